#!/usr/bin/env python3
"""Parts of docs.sh that want more than a shell.

small MANUAL FOLDER PAGE...       a manual of the pages, and of those that they link to
conf LAMMPS/doc FOLDER WORDS      LAMMPS's Sphinx configuration for it, less what is not installed
messages SRC HOWTO                is every message that the page quotes one that the sources print?
commands ROOT                     does all exist that "./run ..." and links on our pages name?
"""
import importlib.util
import pathlib
import re
import shlex
import shutil
import sys


def small(manual, folder, *pages):
    manual, folder = pathlib.Path(manual), pathlib.Path(folder)
    wanted = set(pages)
    for page in pages:
        text = (manual / page).read_text()
        wanted |= {f"{name}.rst" for name in re.findall(r":doc:`[^`]*?<?([A-Za-z0-9_]+)>?`", text)}
    folder.mkdir()
    for page in sorted(wanted):
        if (manual / page).exists():    # Sphinx complains of links that lead nowhere
            shutil.copy(manual / page, folder)
    for name in "_ext", "JPG", "img", "accel_styles.rst":
        if (manual / name).is_dir():
            shutil.copytree(manual / name, folder / name)
        elif (manual / name).exists():
            shutil.copy(manual / name, folder)
    names = "\n".join(f"   {page[:-4]}" for page in sorted(wanted))
    (folder / "Manual.rst").write_text(f"Manual\n======\n\n.. toctree::\n\n{names}\n")


def conf(doc, folder, words):
    doc, folder = pathlib.Path(doc).resolve(), pathlib.Path(folder)
    text = (doc / "utils/sphinx-config/conf.py.in").read_text()
    for name, path in {"DOXYGEN_XML_DIR": folder, "LAMMPS_SOURCE_DIR": doc.parent / "src",
                       "LAMMPS_PYTHON_DIR": doc.parent / "python", "LAMMPS_DOC_DIR": doc}.items():
        text = text.replace(f"@{name}@", str(path))
    sys.path[:0] = [str(doc / "src/_ext"), str(doc / "utils/sphinx-config/_themes")]
    named = re.search(r"^extensions = \[(.*?)\]", text, re.M | re.S)

    def installed(name):
        try:
            return importlib.util.find_spec(name) is not None
        except ModuleNotFoundError:
            return False

    all_of_them = re.findall(r"'([^']+)'", named.group(1))
    absent = [name for name in all_of_them if not installed(name)]
    if absent:
        print("without these extensions of LAMMPS's configuration, which are not installed:", ", ".join(absent))
    text = text.replace(named.group(0), f"extensions = {[n for n in all_of_them if n not in absent]}")
    text += ("\nexclude_patterns += ['accel_styles.rst']\nhtml_theme_path = [os.path.join(LAMMPS_DOC_DIR, 'utils', "
             "'sphinx-config', '_themes')]\nspelling_show_suggestions = True\n")
    config = doc / "utils/sphinx-config"
    (folder / "conf.py").write_text(text)
    for name in "_static", "LAMMPSLexer.py":
        source = config / name
        (shutil.copytree if source.is_dir() else shutil.copy)(source, folder / name)
    (folder / "false_positives.txt").write_text((config / "false_positives.txt").read_text()
                                                + pathlib.Path(words).read_text())


def messages(sources, howto):
    code = "\n".join(path.read_text() for path in sorted(pathlib.Path(sources).glob("*.[ch]*")))
    code = re.sub(r'"\s*\n?\s*"', "", code)    # strings that the compiler joins
    text = pathlib.Path(howto).read_text()
    text = text[text.index("Messages, and what to do\n---"):text.index("**No message")]
    quoted = [m.replace("\n", " ") for m in re.findall(r"\* - ``(.+?)``", text, re.S)]
    if len(quoted) < 20:
        sys.exit(f"messages: found {len(quoted)} alone")
    absent = [m for m in quoted if not all(piece.strip() in code for piece in m.split("..."))]
    for message in absent:
        print("the sources have no message like:", message)
    sys.exit(1 if absent else 0)


def commands(root):
    """./run WHAT -var NAME ...: WHAT is there, and its script has a variable NAME; relative links lead somewhere"""
    root = pathlib.Path(root)
    wrong, seen = [], 0

    def check(page, line):
        words = shlex.split(re.split(" {3,}|#", line)[0])    # less what explains it
        while words and words[0] == "-np":
            words = words[2:]
        what = words.pop(0) if words and not words[0].startswith("-") else "quicksand"
        script = root / "examples" / what / f"in.{what}"
        if (root / "tools" / what).is_file():
            names = [w for w in words if re.fullmatch("[a-z_0-9]+", w)] if what == "figures" else []
            wrong.extend(f"{page}: no example {n}" for n in names
                         if n not in ("full", "quick") and not (root / "examples" / n / "figure.sh").exists())
            return
        if not script.exists():
            script = root / what if (root / what).is_file() else page.parent / what
        if not script.is_file():
            if "path/to" not in what:
                wrong.append(f"{page}: ./run {what}: there is no such thing")
            return
        text = "".join(f.read_text() for f in [script, *script.parent.glob("*.lmp")])
        for at, word in enumerate(words):
            if word in ("-var", "-v") and not re.search(rf"^variable\s+{words[at + 1]}\s", text, re.M):
                wrong.append(f"{page}: {script.name} has no variable {words[at + 1]}")

    pages = [p for kind in ("*.md", "doc/*.md", "doc/*/*.md", "examples/*/README.md", "bench/*.md", "doc/src/*.rst",
                            "examples/*/in.*") for p in root.glob(kind)]
    for page in pages:
        text = page.read_text()
        for line in re.findall(r"^(?:    |#   |   )(?:\.\./\.\.|\.)/run\b(.*)$", text, re.M):
            check(page, line)
            seen += 1
        if page.suffix == ".md":
            for link in re.findall(r"\]\(([^)#\s]+)", text):
                if "://" not in link and not (page.parent / link).exists():
                    wrong.append(f"{page}: the link {link} leads nowhere")
    for line in wrong:
        print(line)
    if seen < 30:
        sys.exit(f"commands: found {seen} alone")
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    {"small": small, "conf": conf, "messages": messages, "commands": commands}[sys.argv[1]](*sys.argv[2:])
