<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="generator" content="Scan to BIM for CloudCompare">
<title>{{TITLE:h}}</title>
<style>
@page { size: A4; margin: 14mm 14mm 16mm; }
:root { --ink: #1d252e; --soft: #5b6672; --line: #c9d0d8; --faint: #eef1f5; --blue: #2660a4; }
* { box-sizing: border-box; }
html { font: 10pt/1.42 "Inter", "Segoe UI", "Helvetica Neue", Helvetica, Arial, "Liberation Sans", sans-serif; color: var(--ink);
  -webkit-print-color-adjust: exact; print-color-adjust: exact; }
body { margin: 0; background: #e9ecf0; }
main { max-width: 210mm; margin: 8mm auto; padding: 14mm; background: #fff; box-shadow: 0 1px 6px rgba(0,0,0,.18); }
header { border-bottom: 0.6mm solid var(--ink); padding-bottom: 3mm; margin-bottom: 5mm; }
header p { margin: 0; color: var(--soft); letter-spacing: .06em; text-transform: uppercase; font-size: 8pt; }
h1 { font-size: 19pt; line-height: 1.2; margin: 1mm 0 0; font-weight: 650; overflow-wrap: anywhere; }
h2 { font-size: 13pt; margin: 7mm 0 2mm; font-weight: 650; border-bottom: 0.25mm solid var(--line); padding-bottom: 1mm; break-after: avoid; }
h3 { font-size: 10.5pt; margin: 5mm 0 1mm; font-weight: 650; break-after: avoid; }
p { margin: 0 0 2mm; max-width: 165mm; }
.note { color: var(--soft); font-size: 8.5pt; }
.verdict { display: flex; gap: 4mm; align-items: center; padding: 3mm 4mm; border-radius: 1mm; border-left: 1.6mm solid; margin: 0 0 4mm; break-inside: avoid; }
.verdict b { font-size: 12pt; font-weight: 650; }
.verdict .mark { font-size: 15pt; font-weight: 700; width: 8mm; text-align: center; }
.verdict p { margin: 0; }
.good { background: #e7f3ec; border-color: #1f7a4d; } .good .mark { color: #1f7a4d; }
.bad { background: #fdf0dd; border-color: #d98a00; } .bad .mark { color: #b36f00; }
.undecided { background: var(--faint); border-color: #8b95a1; }
.tiles { display: flex; flex-wrap: wrap; gap: 3mm; margin: 0 0 5mm; }
.tile { flex: 1 1 27mm; border: 0.25mm solid var(--line); border-radius: 1mm; padding: 2mm 2.5mm; break-inside: avoid; }
.tile b { display: block; font-size: 15pt; line-height: 1.2; font-weight: 650; font-variant-numeric: tabular-nums; }
.tile b small { font-size: 9pt; font-weight: 500; color: var(--soft); }
.tile span { color: var(--soft); font-size: 8pt; line-height: 1.25; display: block; }
table { border-collapse: collapse; width: 100%; font-size: 8.5pt; font-variant-numeric: tabular-nums; margin: 1mm 0 3mm; }
thead { display: table-header-group; }
tr { break-inside: avoid; }
table:not(.elements):not(.long) { break-inside: avoid; }
th { text-align: right; font-weight: 600; color: var(--soft); font-size: 7.6pt; line-height: 1.25; vertical-align: bottom; border-bottom: 0.3mm solid var(--ink); padding: 0.8mm 1.4mm; }
td { text-align: right; padding: 0.9mm 1.4mm; border-bottom: 0.15mm solid var(--line); vertical-align: top; }
th.l, td.l { text-align: left; }
th.group { text-align: center; border-bottom: 0.2mm solid var(--line); }
td.g, th.g { border-left: 0.2mm solid var(--line); }
td.c { white-space: nowrap; }
td.id { white-space: nowrap; font-family: "Cascadia Mono", "DejaVu Sans Mono", Menlo, Consolas, monospace; font-size: 6.8pt; }
td .name { display: block; white-space: normal; color: var(--soft); overflow-wrap: anywhere; max-width: 36mm; }
.facts td:first-child { color: var(--soft); width: 32mm; }
.facts td, .parameters td { text-align: left; }
.elements { font-size: 7.6pt; }
.elements th, .elements td { padding-left: 1mm; padding-right: 1mm; }
.chip { display: inline-block; white-space: nowrap; padding: 0 1.3mm; border-radius: 0.8mm; border: 0.25mm solid; font-size: 7.4pt; }
.chip.within { color: #1d5a96; border-color: #9dbfe0; background: #eaf2fa; }
.chip.out { color: #7a4c00; border-color: #d98a00; background: #ffe9c2; font-weight: 600; }
.chip.missed { color: #9c1f14; border-color: #c0281c; background: #fbe1dc; font-weight: 600; }
.chip.extra { color: #57237a; border-color: #6b2f94; background: #f0e4f7; font-weight: 600; }
.chip.nodata, .chip.notseen { color: #555; border-color: #b5b5b5; background: #f5f5f5; }
section.keep { break-inside: avoid; }
figure { margin: 3mm 0 5mm; break-inside: avoid; }
figure svg { max-width: 100%; height: auto; display: block; margin: 0 auto; }
figure.pair { display: block; }
figure.pair svg { display: inline-block; vertical-align: top; margin: 0; }
figcaption { color: var(--soft); font-size: 8.5pt; margin-top: 1mm; }
ul.legend { list-style: none; display: flex; flex-wrap: wrap; gap: 1mm 4mm; padding: 0; margin: 1mm 0 2mm; font-size: 7.8pt; color: var(--soft); }
ul.legend li { display: flex; align-items: center; gap: 1.5mm; }
svg.colorbar { display: block; margin: 1mm 0 2mm; }
svg text { font-family: "Inter", "Segoe UI", "Helvetica Neue", Helvetica, Arial, "Liberation Sans", sans-serif; }
svg .axis { font-size: 2.5px; fill: #46505b; }
svg .bandtext { font-size: 2.6px; }
svg .tick { stroke: #46505b; stroke-width: 0.2; }
svg .cross { stroke: #8f9aa6; stroke-width: 0.1; }
svg .limit { stroke: #1d252e; stroke-width: 0.3; stroke-dasharray: 1.6 1; }
svg .frame { fill: none; stroke: #46505b; stroke-width: 0.25; }
svg .north { fill: #1d252e; }
svg .bar0 { fill: #1d252e; } svg .bar1 { fill: #fff; stroke: #1d252e; stroke-width: 0.15; }
svg image { image-rendering: pixelated; }
svg image[aria-label="points of the slice"] { mix-blend-mode: multiply; }
svg .e { stroke-width: 0.3; stroke-linejoin: round; }
svg .within { fill: #3f7fbf; fill-opacity: .32; stroke: #1d5a96; }
svg .out { fill: url(#p-out); stroke: #9a6200; stroke-width: 0.4; }
svg .missed { fill: url(#p-missed); stroke: #c0281c; stroke-width: 0.6; }
svg .extra { fill: url(#p-extra); stroke: #6b2f94; stroke-width: 0.6; }
svg .nodata { fill: url(#p-nodata); stroke: #7d7d7d; }
svg .notseen { fill: none; stroke: #8a8a8a; stroke-width: 0.35; stroke-dasharray: 0.4 0.7; }
svg .slab { fill: none; stroke-width: 0.2; }
svg .slab.within, svg .slab.nodata { stroke: #b4bcc6; }
svg .truth { fill: none; stroke: #111; stroke-width: 0.22; stroke-dasharray: 1.1 0.7; }
svg .outline { fill: none; stroke: #8a94a0; stroke-width: 0.08; }
svg .badge { fill: #fff; stroke: #1d252e; stroke-width: 0.25; }
svg .badgetext { font-size: 2.4px; font-weight: 700; fill: #1d252e; }
.sign { display: flex; gap: 10mm; margin-top: 14mm; break-inside: avoid; }
.sign div { flex: 1; border-top: 0.25mm solid var(--ink); padding-top: 1mm; font-size: 8pt; color: var(--soft); }
@media print { body { background: #fff; } main { max-width: none; margin: 0; padding: 0; box-shadow: none; } }
</style>
</head>
<body>
{{DEFINITIONS:none}}
<main>
<header><p>Validation of a building model</p><h1>{{TITLE:h}}</h1></header>
{{#VERDICT}}<div class="verdict {{CLASS:h}}"><span class="mark">{{MARK:h}}</span><div><b>{{TEXT:h}}</b><p>Tolerance {{TOLERANCE:h}}: 95&#8239;% within {{LIMIT:h}} mm. {{REST:h}}</p></div></div>
{{/VERDICT}}
{{#UNDECIDED}}<div class="verdict undecided"><div><b>No element could be judged.</b><p>There are no points on the elements, and nothing to compare them with.</p></div></div>
{{/UNDECIDED}}
<div class="tiles">
{{#TILE}}<div class="tile"><b>{{VALUE:h}} <small>{{UNIT:h}}</small></b><span>{{LABEL:h}}</span></div>
{{/TILE}}
</div>
<table class="facts"><tbody>
{{#FILE}}<tr><td>{{ROLE:h}}</td><td>{{NAME:h}}</td><td>{{ABOUT:h}}</td></tr>
{{/FILE}}
</tbody></table>

<h2>Summary</h2>
{{#FOUND}}
<h3>What was found</h3>
<table><thead>
<tr><th class="l" rowspan="2">Class</th><th rowspan="2">in the<br>truth</th><th rowspan="2">in the<br>result</th><th rowspan="2">not<br>seen</th><th class="group g" colspan="3">intersection over union</th><th class="group g" colspan="3">at IoU 0.25</th><th class="group g" colspan="3">at IoU 0.50</th></tr>
<tr><th class="g">mean</th><th>of pairs</th><th>volume</th><th class="g">prec.</th><th>recall</th><th>F1</th><th class="g">prec.</th><th>recall</th><th>F1</th></tr></thead><tbody>
{{#CLASS_ROW}}<tr><td class="l">{{CLASS:h}}</td><td>{{TRUTH:h}}</td><td>{{RESULT:h}}</td><td>{{NOT_SEEN:h}}</td><td class="g">{{IOU:h}}</td><td>{{IOU_MATCHED:h}}</td><td>{{VOLUMETRIC:h}}</td><td class="g">{{P25:h}}</td><td>{{R25:h}}</td><td>{{F25:h}}</td><td class="g">{{P50:h}}</td><td>{{R50:h}}</td><td><b>{{F50:h}}</b></td></tr>
{{/CLASS_ROW}}
</tbody></table>
<p class="note">Counts are of truth elements that the survey saw, and of result elements that do not stand where the truth was not seen. The mean counts a truth element without a partner as 0.</p>
{{/FOUND}}
{{#SIZE}}
<h3>Place and size of matched pairs</h3>
<table><thead>
<tr><th class="l" rowspan="2">Class</th><th rowspan="2">centre<br>mean [mm]</th><th rowspan="2">axis ends<br>median [mm]</th><th rowspan="2">thickness<br>median [mm]</th><th rowspan="2">height<br>median [mm]</th><th class="group g" colspan="3">F1 of corners within</th></tr>
<tr><th class="g">5 cm</th><th>10 cm</th><th>20 cm</th></tr></thead><tbody>
{{#CLASS_ROW}}<tr><td class="l">{{CLASS:h}}</td><td>{{CENTROID:h}}</td><td>{{AXIS:h}}</td><td>{{THICKNESS:h}}</td><td>{{HEIGHT:h}}</td><td class="g">{{C5:h}}</td><td>{{C10:h}}</td><td>{{C20:h}}</td></tr>
{{/CLASS_ROW}}
</tbody></table>
{{/SIZE}}
<h3>Deviations and tolerance</h3>
<table><thead>
<tr><th class="l" rowspan="2">Class</th><th class="group" colspan="2">points, mean absolute [mm]</th><th class="group g" colspan="3">elements</th><th class="l g" rowspan="2">accuracy bands of the elements</th></tr>
<tr><th>to result</th><th>to truth</th><th class="g">within</th><th>out</th><th>no data</th></tr></thead><tbody>
{{#CLASS_TOLERANCE}}<tr><td class="l">{{CLASS:h}}</td><td>{{TO_RESULT:h}}</td><td>{{TO_TRUTH:h}}</td><td class="g">{{WITHIN:h}}</td><td><b>{{OUT:h}}</b></td><td>{{NO_DATA:h}}</td><td class="l g">{{BANDS:none}}</td></tr>
{{/CLASS_TOLERANCE}}
</tbody></table>
{{BAND_LEGEND:none}}
{{#STOREYS}}
<h3>Storeys</h3>
<table><thead><tr><th class="l">Storey</th><th>floor, truth [m]</th><th>floor, result [m]</th><th>error [mm]</th><th class="l"></th></tr></thead><tbody>
{{#STOREY}}<tr><td class="l">{{NAME:h}}</td><td>{{TRUTH:h}}</td><td>{{RESULT:h}}</td><td>{{ERROR:h}}</td><td class="l">{{REMARK:h}}</td></tr>
{{/STOREY}}
</tbody></table>
{{#EXTRA}}<p class="note">Storeys of the result without one in the truth: {{COUNT:h}}.</p>{{/EXTRA}}
{{/STOREYS}}

{{#PLANS}}
<section class="keep"><h2>Plans</h2>
{{LEGEND:none}}
{{#FIRST}}<figure>{{SVG:none}}<figcaption>{{CAPTION:h}}</figcaption></figure>{{/FIRST}}
</section>
{{#FIGURE}}<figure>{{SVG:none}}<figcaption>{{CAPTION:h}}</figcaption></figure>
{{/FIGURE}}
{{/PLANS}}
{{#UNSEEN}}<p class="note">Not drawn, because the survey saw nothing of them: {{NAMES:h}}.</p>
{{/UNSEEN}}

<h2>Elements, worst first</h2>
<table class="elements"><thead>
<tr><th rowspan="2">No.</th><th class="l" rowspan="2">Class</th><th class="l" rowspan="2">GUID, name</th><th class="l" rowspan="2">Storey</th><th class="group g" colspan="4">against the truth [mm]</th><th class="group g" colspan="3">points [mm]</th><th class="l g" rowspan="2">LOA</th><th class="l" rowspan="2">Verdict</th></tr>
<tr><th class="g">IoU</th><th>place</th><th>thick.</th><th>height</th><th class="g">mean</th><th>95&#8239;%</th><th>cover</th></tr></thead><tbody>
{{#ELEMENT}}<tr id="e{{NUMBER:h}}" title="{{REASON:h}}"><td>{{NUMBER:h}}</td><td class="l c">{{CLASS:h}}</td><td class="l id">{{ID:h}}<span class="name">{{NAME:h}}</span></td><td class="l">{{STOREY:h}}</td><td class="g">{{IOU:h}}</td><td>{{PLACE:h}}</td><td>{{THICKNESS:h}}</td><td>{{HEIGHT:h}}</td><td class="g">{{MEAN:h}}</td><td>{{P95:h}}</td><td>{{COVERAGE:h}}</td><td class="l g">{{LOA:h}}</td><td class="l"><span class="chip {{STYLE:h}}">{{VERDICT:h}}</span></td></tr>
{{/ELEMENT}}
</tbody></table>
<p class="note">Place: the larger distance of the axes' ends of a wall, else of the centres. Thickness and height: result less truth. Mean: signed, positive in front of the surface. Cover: share of the element's visible surface with points.</p>

{{#DEVIATIONS}}
<section class="keep"><h2>Deviations of the points</h2>
{{LEGEND:none}}
{{#FIRST}}<figure>{{SVG:none}}<figcaption>{{CAPTION:h}}</figcaption></figure>{{/FIRST}}
</section>
{{#FIGURE}}<figure>{{SVG:none}}<figcaption>{{CAPTION:h}}</figcaption></figure>
{{/FIGURE}}
{{/DEVIATIONS}}
{{#HISTOGRAM}}
<section class="keep"><h2>Distribution of the deviations</h2>
<figure>{{SVG:none}}<figcaption>{{CAPTION:h}}</figcaption></figure></section>
{{/HISTOGRAM}}
{{#WALLS}}
<section class="keep"><h2>Faces of the worst walls</h2>
{{LEGEND:none}}
{{#FIRST}}<figure class="pair">{{SVG:none}}<figcaption>{{CAPTION:h}}</figcaption></figure>{{/FIRST}}
</section>
{{#FIGURE}}<figure class="pair">{{SVG:none}}<figcaption>{{CAPTION:h}}</figcaption></figure>
{{/FIGURE}}
{{/WALLS}}

<h2>How it was measured</h2>
<p class="note">Distances are measured from each point to the nearest surface of the model, up to the limit below. The accuracy band of an element is the best one of the USIBD Level of Accuracy specification whose limit 95&#8239;% of its points keep; without points, and for doors and windows, whose leaf or pane is not what was measured, the largest error in place and size takes their place. An element of the truth that nothing of the result meets, and an element of the result without one in the truth, are out of tolerance. Coordinates and north are those of the input.</p>
<table class="parameters"><tbody>
{{#VALIDATION}}<tr><td>{{NAME:h}}</td><td>{{VALUE:h}}</td></tr>
{{/VALIDATION}}
</tbody></table>
{{#PARAMETERS}}
<h3>Parameters of the reconstruction</h3>
<table class="parameters long"><tbody>
{{#PARAMETER}}<tr><td>{{NAME:h}}</td><td>{{VALUE:h}}</td></tr>
{{/PARAMETER}}
</tbody></table>
{{/PARAMETERS}}
{{#DIAGNOSTICS}}
<h3>Remarks of the reconstruction</h3>
<table class="long"><thead><tr><th class="l">Kind</th><th class="l">Stage</th><th class="l">Remark</th><th class="l">Place (x, y, z) [m]</th></tr></thead><tbody>
{{#DIAGNOSTIC}}<tr><td class="l">{{SEVERITY:h}}</td><td class="l">{{STAGE:h}}</td><td class="l">{{TEXT:h}}</td><td class="l">{{PLACE:h}}</td></tr>
{{/DIAGNOSTIC}}
</tbody></table>
{{/DIAGNOSTICS}}
<div class="sign"><div>Place, date</div><div>Surveyor</div><div>Client</div></div>
</main>
</body>
</html>
