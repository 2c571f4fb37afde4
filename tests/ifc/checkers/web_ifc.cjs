// SPDX-License-Identifier: GPL-3.0-or-later
// Reads a file with web-ifc, which shares no code with IfcOpenShell, and compares: web_ifc.cjs FILE.ifc DESCRIPTION.json
//   the same elements of each class as IfcGeom saw (DESCRIPTION.json, by describe);
//   volumes within 0.1 % of the file's own Qto_* (exact), or of IfcGeom's where the standard has no volume (doors);
//   boxes within 1 mm of IfcGeom's, 3 mm where there are arcs, which both readers make polygons of.
"use strict";
const fs = require("fs");
const WebIFC = require("web-ifc");

const CLASSES = ["IFCWALL", "IFCDOOR", "IFCWINDOW", "IFCCOLUMN", "IFCSLAB", "IFCSPACE", "IFCOPENINGELEMENT"];
const VOLUME_SHARE = 0.001;
const BOX_M = 0.001;
const ARC_BOX_M = 0.003;

function list(vector) {
  return Array.from({ length: vector.size() }, (_, i) => vector.get(i));
}

/// [NetVolume of each element that has one] by express id.
function netVolumes(api, model) {
  const volumes = new Map();
  for (const id of list(api.GetLineIDsWithType(model, WebIFC.IFCRELDEFINESBYPROPERTIES))) {
    const relation = api.GetLine(model, id);
    const definition = api.GetLine(model, relation.RelatingPropertyDefinition.value);
    if (!(definition.Name && definition.Name.value.startsWith("Qto_"))) continue;
    for (const reference of definition.Quantities) {
      const quantity = api.GetLine(model, reference.value);
      if (quantity.Name.value !== "NetVolume") continue;
      for (const object of relation.RelatedObjects) volumes.set(object.value, quantity.VolumeValue.value);
    }
  }
  return volumes;
}

/// Volume and box of an element's closed meshes, in the file's axes (web-ifc's own y is up).
function measure(api, model, id) {
  const flat = api.GetFlatMesh(model, id);
  const result = { volume: 0, low: [Infinity, Infinity, Infinity], high: [-Infinity, -Infinity, -Infinity] };
  for (const part of list(flat.geometries)) {
    const geometry = api.GetGeometry(model, part.geometryExpressID);
    const floats = api.GetVertexArray(geometry.GetVertexData(), geometry.GetVertexDataSize());
    const index = api.GetIndexArray(geometry.GetIndexData(), geometry.GetIndexDataSize());
    const m = part.flatTransformation; // by columns
    const points = [];
    for (let i = 0; i + 5 < floats.length; i += 6) {
      const [x, y, z] = [floats[i], floats[i + 1], floats[i + 2]];
      const at = [0, 1, 2].map((r) => m[r] * x + m[4 + r] * y + m[8 + r] * z + m[12 + r]);
      points.push([at[0], -at[2], at[1]]);
    }
    const origin = points[0];
    for (const p of points)
      for (let k = 0; k < 3; ++k) {
        result.low[k] = Math.min(result.low[k], p[k]);
        result.high[k] = Math.max(result.high[k], p[k]);
      }
    let six = 0;
    for (let i = 0; i < index.length; i += 3) {
      const [a, b, c] = [0, 1, 2].map((k) => points[index[i + k]].map((value, axis) => value - origin[axis]));
      six += a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
    }
    result.volume += Math.abs(six) / 6;
    geometry.delete();
  }
  return result;
}

async function main() {
  const [file, description] = process.argv.slice(2);
  const expected = JSON.parse(fs.readFileSync(description)).elements;
  const api = new WebIFC.IfcAPI();
  await api.Init();
  api.SetLogLevel(WebIFC.LogLevel.LOG_LEVEL_OFF);
  // Enough segments for 0.1 % of a circle's area.
  const model = api.OpenModel(new Uint8Array(fs.readFileSync(file)), { COORDINATE_TO_ORIGIN: false, CIRCLE_SEGMENTS: 256 });
  const faults = [];
  const net = netVolumes(api, model);
  const arcs = new Set(list(api.GetLineIDsWithType(model, WebIFC.IFCCIRCLEPROFILEDEF)));
  const hasArcs = arcs.size > 0 || fs.readFileSync(file, "latin1").includes("IFCARCINDEX");
  let compared = 0;
  let worst = 0;
  let worstBox = 0;
  for (const name of CLASSES) {
    const seen = Object.entries(expected).filter(([, e]) => e.type.toUpperCase() === name);
    const ids = list(api.GetLineIDsWithType(model, WebIFC[name]));
    if (ids.length !== seen.length) faults.push(`${ids.length} ${name}, IfcGeom sees ${seen.length}`);
    for (const id of ids) {
      const guid = api.GetLine(model, id).GlobalId.value;
      const other = expected[guid];
      if (!other) {
        faults.push(`${name} ${guid} is not seen by IfcGeom`);
        continue;
      }
      const own = measure(api, model, id);
      const reference = net.has(id) ? net.get(id) : other.volume_m3;
      const share = Math.abs(own.volume - reference) / reference;
      worst = Math.max(worst, share);
      if (!(share <= VOLUME_SHARE)) faults.push(`${other.name}: ${own.volume} m3, not ${reference}`);
      const off = Math.max(...[0, 1, 2].flatMap((k) => [Math.abs(own.low[k] - other.low[k]), Math.abs(own.high[k] - other.high[k])]));
      worstBox = Math.max(worstBox, off);
      if (!(off <= (hasArcs ? ARC_BOX_M : BOX_M))) faults.push(`${other.name}: its box is ${off} m off`);
      ++compared;
    }
  }
  if (compared === 0) faults.push("there is nothing to compare");
  console.log(`${api.GetModelSchema(model)}: ${compared} elements, volumes within ${(100 * worst).toFixed(4)} %, boxes within ${(1000 * worstBox).toFixed(2)} mm`);
  for (const fault of faults) console.log(fault);
  process.exit(faults.length > 0 ? 1 : 0);
}

main().catch((error) => {
  console.error(`web-ifc can't read the file: ${error.message || error}`);
  process.exit(1);
});
