#!/usr/bin/env bash
# Long test: our pages inside LAMMPS's manual.
#
#   unittest/docs.sh LAMMPS-TREE FOLDER
#
# Puts doc/src into a copy of the manual (doc/join_manual.py), runs LAMMPS's own checks (anchors, lists
# of styles and packages, characters, roles, spelling) and builds our pages with its Sphinx
# configuration. What any of them says of our pages is a failure; of LAMMPS's own pages it does not
# count. Pages: FOLDER/html/Howto_lbm_ibb.html. Only pages that ours link to are read, so it takes a minute;
# extensions of LAMMPS's configuration that Debian lacks are left out, and named.
# ctest counts it as skipped (exit status 77) where there is no Sphinx.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../cmake/setup.sh"

tree=$1 folder=$2
prepare_machine '?python3-sphinx' '?python3-sphinx-rtd-theme' '?python3-sphinx-tabs' \
  '?python3-sphinxcontrib.spelling' '?python3-enchant' '?hunspell-en-us'
python=/usr/bin/python3
"$python" -c 'import sphinx' 2>/dev/null || {
  echo "SKIPPED: no Sphinx here (python3-sphinx)"
  exit 77
}

rm -rf "$folder"
mkdir -p "$folder/lammps/doc"
cd "$folder"
# a tree that looks like LAMMPS's with our package in it
cp -rs "$tree/src" lammps/src
rm -rf lammps/src/LBM-IBB
cp -r "$root/src/LBM-IBB" lammps/src
ln -s "$tree/python" lammps/python
cp -r "$tree/doc/src" "$tree/doc/utils" lammps/doc
manual=$folder/lammps/doc/src
"$python" "$root/doc/join_manual.py" "$manual"
"$python" "$root/doc/join_manual.py" "$manual"    # twice does no harm
"$python" lammps/doc/utils/make-globbed-tocs.py -d "$manual" > tocs.txt
mapfile -t pages < <(cd "$root/doc/src" && ls ./*.rst | sed 's,^\./,,')

# fails with what it was given, if that is anything
bad=0
complain() {
  local what=$1 text
  text=$(cat)
  if [ -n "$text" ]; then
    printf '%s:\n%s\n' "$what" "$text"
    bad=1
  fi
}
ours() { grep -iE 'lbm|lb[_/](ibb|plan)|gran[_/]lsd' || true; }

# ---- LAMMPS's checks, as its doc/Makefile calls them
{ "$python" lammps/doc/utils/converters/lammpsdoc/rst_anchor_check.py "$manual"/*.rst || true; } > anchors.txt
complain anchors < <(ours < anchors.txt)
# check-styles.py names pages as seen from doc/
(cd lammps/doc && "$python" utils/check-packages.py -s ../src -d src && "$python" utils/check-styles.py -s ../src -d src) > lists.txt 2>&1 ||
  { tail -n 5 lists.txt; bad=1; }
complain "lists of styles and packages" < <(ours < lists.txt)
cd "$manual"
complain "characters that are not ASCII" < <(LC_ALL=C grep -n '[^ -~]' "${pages[@]}")
complain roles < <(LC_ALL=C grep -nE ' :[a-z]+`|:(ref|doc):[^`]|[^:](ref|doc)`[^`]' "${pages[@]}" | grep -vE ' :(doc|ref|math|lammps|code|sup|sub):`' || true)
complain "links without underscore" < <(LC_ALL=C grep -nE ' `[^`]+<[a-z][^`]+`[^_]' "${pages[@]}")
complain "trailing blanks and tabs" < <(LC_ALL=C grep -nE $'[ \t]+$|\t' "${pages[@]}")
cd "$folder"

# ---- Sphinx with LAMMPS's configuration, on our pages and those they link to
"$python" "$root/unittest/docs.py" small "$manual" small "${pages[@]}"
"$python" "$root/unittest/docs.py" conf lammps/doc small "$root/doc/spelling.txt"
of_ours() {
  local page text=''
  for page in "${pages[@]}"; do text+="|/$page:|^$page:|${page%.rst}\\b"; done
  grep -E "${text#|}" || true
}
"$python" -m sphinx -q -n -b html small html -w html.txt > /dev/null 2>&1 || { tail -n 5 html.txt; bad=1; }
complain "Sphinx" < <(grep -vE 'py:class|c:identifier' html.txt | of_ours)
for page in "${pages[@]}"; do
  [ -s "html/${page%.rst}.html" ] || { echo "no html of $page"; bad=1; }
done
if "$python" -c 'import enchant, sphinxcontrib.spelling' 2>/dev/null; then
  "$python" -m sphinx -q -b spelling small spelling -w spelling.txt > /dev/null 2>&1 || { tail -n 5 spelling.txt; bad=1; }
  complain "spelling (LAMMPS's list, and doc/spelling.txt)" < <(cat spelling/*.spelling 2>/dev/null | of_ours)
else
  echo "no spelling checker here (python3-sphinxcontrib.spelling, python3-enchant): not checked"
fi

# ---- messages that the Howto explains must be messages of the code; commands and links must lead somewhere
"$python" "$root/unittest/docs.py" messages "$root/src/LBM-IBB" "$root/doc/src/Howto_lbm_ibb.rst" || bad=1
"$python" "$root/unittest/docs.py" commands "$root" || bad=1
echo "${#pages[@]} pages: $folder/html/Howto_lbm_ibb.html"
exit $bad
