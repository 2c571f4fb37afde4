# SPDX-License-Identifier: GPL-3.0-or-later
"""The page of scripts/bench quality: the table, and for every survey and storey the plans of all modes side by side."""
import html
from collections import Counter

STYLE = """
body { background: #fff; }
main.bench { max-width: none; margin: 0; padding: 8mm 10mm; box-shadow: none; }
.bench table.scores { width: auto; font-size: 9pt; }
.bench table.scores th, .bench table.scores td { padding: .6mm 2mm; white-space: nowrap; }
.bench table.scores tbody tr:hover { background: #eef4fb; }
.bench table.scores tr.mean td { font-weight: 650; border-bottom-color: #8b95a1; background: #f6f7f9; }
.bench table.scores tr.turn td { border-top: .4mm solid #46505b; }
.bench td .heat { display: inline-block; min-width: 9mm; border-radius: .6mm; padding: 0 1mm; }
.bench nav { position: sticky; top: 0; background: rgba(255,255,255,.94); border-bottom: .2mm solid #c9d0d8; padding: 1.5mm 0; z-index: 2;
  display: flex; flex-wrap: wrap; gap: 1mm 5mm; font-size: 9pt; }
.bench nav a { color: #2660a4; text-decoration: none; }
.bench h2 { scroll-margin-top: 12mm; }
.bench .plans { display: grid; gap: 4mm 6mm; align-items: start; }
.bench figure { margin: 0; min-width: 0; border: .2mm solid #dfe4ea; border-radius: 1mm; padding: 2mm; }
.bench figure h4 { margin: 0 0 1mm; font-size: 9.5pt; font-weight: 650; display: flex; flex-wrap: wrap; gap: 2mm; align-items: baseline; }
.bench figure svg { width: 100%; height: auto; cursor: zoom-in; }
.bench figure.large { grid-column: 1 / -1; }
.bench figure.large svg { cursor: zoom-out; max-height: 96vh; }
.bench details { font-size: 8pt; margin-top: 1mm; }
.bench summary { cursor: pointer; color: #46505b; }
.bench details table { width: auto; margin: 1mm 0; }
.bench .none { color: #1f7a4d; }
.bench .hide-points svg image { display: none; }
"""

SCRIPT = """
for (const svg of document.querySelectorAll('figure svg'))
  svg.addEventListener('click', () => svg.closest('figure').classList.toggle('large'));
document.getElementById('points').addEventListener('change', e =>
  document.querySelector('main').classList.toggle('hide-points', !e.target.checked));
"""

CHIPS = {"missed": "missed", "false positive": "extra", "out of tolerance": "out"}
MODE_TITLES = {"given": "labels given", "degraded": "labels degraded, occluded", "geometry": "geometry only",
               "segmented": "labels of a model"}


def text(value):
    return html.escape(str(value), quote=True)


def heat(title, cell):
    """Scores in [0, 1] get a colour from red to green: bad ones are found without reading numbers."""
    if title not in ("IoU", "F1", "both") or cell == "-":
        return text(cell)
    share = min(1.0, max(0.0, float(cell)))
    return f'<span class="heat" style="background:hsl({round(10 + 130 * max(0.0, 2 * share - 1))} 62% 86%)">{text(cell)}</span>'


def scores(groups, titles, lines, means_from):
    out = ['<table class="scores"><thead><tr>']
    i = 0
    while i < len(groups):
        last = i
        while last + 1 < len(groups) and groups[last + 1] == groups[i]:
            last += 1
        out.append(f'<th class="group{" g" if i > 1 else ""}" colspan="{last - i + 1}">{text(groups[i])}</th>')
        i = last + 1
    starts = {i for i in range(2, len(groups)) if groups[i] != groups[i - 1]}
    out.append("</tr><tr>")
    for i, title in enumerate(titles):
        out.append(f'<th class="{"l" if i < 2 else "g" if i in starts else ""}">{text(title)}</th>')
    out.append("</tr></thead><tbody>")
    for n, line in enumerate(lines):
        isMean = n >= means_from
        turn = n > 0 and (n == means_from or (not isMean and line[1] != lines[n - 1][1]))
        out.append(f'<tr class="{"mean" if isMean else ""}{" turn" if turn else ""}">')
        for i, cell in enumerate(line):
            shown = text(cell) if i != 0 or isMean else f'<a href="#{text(cell)}">{text(cell)}</a>'
            if i > 1:
                shown = heat(titles[i], cell)
            out.append(f'<td class="{"l" if i < 2 else "g" if i in starts else ""}">{shown}</td>')
        out.append("</tr>")
    out.append("</tbody></table>")
    return "".join(out)


def chips(wrong):
    out = []
    for outcome, style in CHIPS.items():
        counts = Counter(w["class"] for w in wrong if w["outcome"] == outcome)
        if counts:
            what = ", ".join(f"{count} {kind}{'' if count == 1 else 's'}" for kind, count in sorted(counts.items()))
            out.append(f'<span class="chip {style}">{text(outcome)}: {text(what)}</span>')
    return " ".join(out) or '<span class="chip within">nothing wrong</span>'


def figure(mode, plan):
    rows = "".join(
        f'<tr><td>{w["number"]}</td><td class="l">{text(w["class"])}</td><td class="l">{text(w["outcome"])}</td>'
        f'<td>{"-" if not w["iou"] else format(w["iou"], ".2f")}</td>'
        f'<td>{"-" if w["error_m"] is None else format(1000 * w["error_m"], ".0f")}</td><td class="id l">{text(w["id"])}</td></tr>'
        for w in plan["wrong"])
    details = (f'<details><summary>{len(plan["wrong"])} elements</summary><table><thead><tr><th>no.</th><th class="l">class</th>'
               f'<th class="l">what</th><th>IoU</th><th>error mm</th><th class="l">id</th></tr></thead><tbody>{rows}</tbody></table></details>'
               if rows else "")
    extra = "" if plan["is_of_truth"] else ' <span class="chip extra">storey of the result alone</span>'
    return (f'<figure><h4>{text(MODE_TITLES.get(mode, mode))}{extra} {chips(plan["wrong"])}</h4>{plan["svg"]}'
            f'<figcaption>{text(plan["caption"])}</figcaption>{details}</figure>')


def same_storey(a, b):
    return abs(a["elevation_m"] - b["elevation_m"]) < 0.5


def survey_section(name, rows):
    """Storeys from below, in each the modes side by side; a result's own storeys fall in where they are."""
    storeys = []
    for row in rows:
        for plan in row["plans"]["storeys"]:
            if not any(same_storey(plan, s) for s in storeys):
                storeys.append(plan)
    storeys.sort(key=lambda s: s["elevation_m"])
    out = [f'<h2 id="{text(name)}">{text(name)}</h2>']
    for storey in storeys:
        out.append(f'<h3>{text(storey["level"])}, floor at {storey["elevation_m"]:.2f} m</h3>')
        out.append(f'<div class="plans" style="grid-template-columns:repeat({len(rows)},minmax(0,1fr))">')
        for row in rows:
            plans = [p for p in row["plans"]["storeys"] if same_storey(p, storey)]
            out += [figure(row["mode"], p) for p in plans] or [
                f'<figure><h4>{text(MODE_TITLES.get(row["mode"], row["mode"]))}</h4><p class="note">no such storey</p></figure>']
        out.append("</div>")
    return "".join(out)


def write(path, rows, modes, table):
    plans = rows[0]["plans"]
    names = sorted({r["survey"] for r in rows})
    sections = [survey_section(n, [r for m in modes for r in rows if r["survey"] == n and r["mode"] == m]) for n in names]
    nav = "".join(f'<a href="#{text(n)}">{text(n)}</a>' for n in names)
    page = f"""<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width, initial-scale=1">
<title>Quality of the reconstruction</title>
<style>{plans["style"]}{STYLE}</style></head>
<body>{plans["definitions"]}<main class="bench">
<header><p>Scan to BIM</p><h1>Quality of the reconstruction</h1></header>
<p class="note">IoU: mean over the truth that was seen, an element without a partner counts 0. F1: at IoU 0.5. both: IoU of walls seen from both sides.
thk: median error of their thickness. In the plans an element is found from an
IoU of 0.5, and out of tolerance when its place, length or thickness is off by more than 5&nbsp;cm.
A click on a plan makes it large.</p>
{scores(*table)}
<nav>{nav}<label><input type="checkbox" id="points" checked> points</label></nav>
{plans["legend"]}
{"".join(sections)}
</main><script>{SCRIPT}</script></body></html>
"""
    temporary = path.with_suffix(".part")
    temporary.write_text(page, encoding="utf-8")
    temporary.replace(path)
