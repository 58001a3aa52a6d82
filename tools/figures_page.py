"""The page of ./run figures: python3 figures_page.py ROOT FOLDER quick|full

One section per finished example in FOLDER: the head of its page in doc/examples, its results.txt as
a table, its pictures.
"""
import html
import pathlib
import re
import sys

root, folder, size = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]), sys.argv[3]


def title_and_case(name):
    page = root / "doc/examples" / f"{name}.md"
    if not page.exists():
        return name, ""
    text = page.read_text()
    title = re.search(r"^# (.*)", text, re.M)
    case = re.search(r"\*\*Case\*\*:?(.*?)(\n\n|\n    |\Z)", text, re.S)
    return title.group(1) if title else name, case.group(1).strip() if case else ""


def table(results):
    rows = []
    for line in results.read_text().splitlines():
        words = line.split()
        if len(words) < 4:
            continue
        name, value, low, high = words[:4]
        gated = low != "-" or high != "-"
        inside = ((low == "-" or float(value) >= float(low)) and
                  (high == "-" or float(value) <= float(high)))
        mark = "" if not gated else "yes" if inside else "<b>no</b>"
        rows.append("<tr>" + "".join(f"<td>{cell}</td>" for cell in
                    (html.escape(name), value, low, high, mark)) + "</tr>")
    if not rows:
        return ""
    return ("<table><tr><th>what</th><th>value</th><th>from</th><th>to</th><th>inside</th></tr>" +
            "".join(rows) + "</table>")


def section(done):
    title, case = title_and_case(done.name)
    seconds = (done / "seconds").read_text().strip()
    parts = [f"<h2 id='{done.name}'>{html.escape(title)}</h2>",
             f"<p>{html.escape(case)}</p>",
             f"<p><code>./run figures {size} {done.name}</code>, {seconds} s here; "
             f"<a href='../../doc/examples/{done.name}.md'>its page</a></p>"]
    if (done / "results.txt").exists():
        parts.append(table(done / "results.txt"))
    shown = done / "figures.txt"    # an example may choose and order its pictures
    pictures = (shown.read_text().split() if shown.exists() else
                sorted(p.name for p in done.glob("*.png")))
    parts += [f"<img src='{done.name}/{p}' alt='{p}'>" for p in pictures]
    return "\n".join(parts)


order = ["poiseuille_sphere", "moving_sphere", "dkt2d", "quicksand", "quicksand2d"]
finished = [state.parent for state in folder.glob("*/state")]
finished.sort(key=lambda p: (order.index(p.name) if p.name in order else len(order), p.name))
sizes = {"quick": "reduced size", "full": "full size"}
(folder / "index.html").write_text(f"""<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8"><title>LBM-IBB: figures</title><style>
body {{ font: 16px/1.5 sans-serif; max-width: 60em; margin: 2em auto; padding: 0 1em }}
img {{ max-width: 100%; display: block; margin: 1em 0 }}
td, th {{ padding: .1em 1em .1em 0; text-align: left }}
</style></head><body>
<h1>Figures, {sizes[size]}</h1>
{chr(10).join(section(p) for p in finished)}
</body></html>
""")
