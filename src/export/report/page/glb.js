// Reads glTF 2.0 binary: nodes with their places, shared meshes, materials and their variants, one morph target.
// (Khronos Group, glTF 2.0 specification, chapters 3 and 4.4; KHR_materials_variants.)

const COMPONENTS = {
  5120: [Int8Array, 127], 5121: [Uint8Array, 255], 5122: [Int16Array, 32767], 5123: [Uint16Array, 65535], 5125: [Uint32Array, 1], 5126: [Float32Array, 1],
};
const WIDTHS = { SCALAR: 1, VEC2: 2, VEC3: 3, VEC4: 4, MAT4: 16 };
const READ_EXTENSIONS = ["KHR_materials_variants", "KHR_mesh_quantization"];

function chunksOf(bytes) {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  if (view.getUint32(0, true) !== 0x46546c67 || view.getUint32(4, true) !== 2) throw new Error("not a glTF 2.0 binary");
  const length = view.getUint32(12, true), start = 20 + length + 8;
  const gltf = JSON.parse(new TextDecoder().decode(bytes.subarray(20, 20 + length)));
  const unread = (gltf.extensionsRequired || []).filter((name) => !READ_EXTENSIONS.includes(name));
  if (unread.length) throw new Error(`the model needs ${unread.join(", ")}`);
  return [gltf, start <= bytes.byteLength ? bytes.subarray(start, start + view.getUint32(20 + length, true)) : new Uint8Array(0)];
}

/** An accessor as an array of its numbers, normalised ones as fractions. */
function accessorOf(gltf, blob, number) {
  const accessor = gltf.accessors[number], width = WIDTHS[accessor.type];
  const [Kind, most] = COMPONENTS[accessor.componentType];
  const out = accessor.normalized || Kind === Float32Array ? new Float32Array(accessor.count * width) : new Kind(accessor.count * width);
  if (accessor.bufferView === undefined) return out;
  const view = gltf.bufferViews[accessor.bufferView], size = Kind.BYTES_PER_ELEMENT;
  const stride = view.byteStride || width * size, from = (view.byteOffset || 0) + (accessor.byteOffset || 0);
  const data = new DataView(blob.buffer, blob.byteOffset, blob.byteLength);
  const get = { 5120: "getInt8", 5121: "getUint8", 5122: "getInt16", 5123: "getUint16", 5125: "getUint32", 5126: "getFloat32" }[accessor.componentType];
  for (let i = 0; i < accessor.count; i++) {
    for (let k = 0; k < width; k++) {
      const value = data[get](from + i * stride + k * size, true);
      out[i * width + k] = accessor.normalized ? Math.max(-1, value / most) : value;
    }
  }
  return out;
}

/** A model: its pieces in world coordinates (metres, y up), materials, names of its views and of its deformed shape. */
function readGlb(bytes) {
  const [gltf, blob] = chunksOf(bytes);
  const arrays = new Map();
  const array = (number) => arrays.get(number) ?? arrays.set(number, accessorOf(gltf, blob, number)).get(number);
  const materials = (gltf.materials || []).map((m) => ({
    name: m.name || "", colour: m.pbrMetallicRoughness?.baseColorFactor || [1, 1, 1, 1],
    isClear: m.alphaMode === "BLEND", gloss: 1 - (m.pbrMetallicRoughness?.roughnessFactor ?? 1),
  }));
  materials.push({ name: "none", colour: [0.6, 0.6, 0.6, 1], isClear: false, gloss: 0 });
  const views = (gltf.extensions?.KHR_materials_variants?.variants || []).map((v) => v.name);
  const pieces = [];
  let shape = "";
  const visit = (number, above) => {
    const node = gltf.nodes[number];
    const place = times(above, node.matrix || placed(node.translation, node.rotation, node.scale));
    if (node.mesh !== undefined) {
      const mesh = gltf.meshes[node.mesh];
      for (const primitive of mesh.primitives) {
        if ((primitive.mode ?? 4) !== 4) continue;
        const base = primitive.material ?? materials.length - 1;
        const mappings = primitive.extensions?.KHR_materials_variants?.mappings || [];
        const target = primitive.targets?.[0]?.POSITION;
        if (target !== undefined) shape = mesh.extras?.targetNames?.[0] || "deformed";
        pieces.push({
          place, positions: array(primitive.attributes.POSITION),
          normals: primitive.attributes.NORMAL === undefined ? null : array(primitive.attributes.NORMAL),
          indices: primitive.indices === undefined ? null : array(primitive.indices),
          moves: target === undefined ? null : array(target),
          material: (view) => mappings.find((m) => m.variants.includes(view))?.material ?? base,
          node: { name: node.name || mesh.name || "", extras: node.extras || {} },
        });
      }
    }
    (node.children || []).forEach((child) => visit(child, place));
  };
  const scene = gltf.scenes[gltf.scene || 0];
  scene.nodes.forEach((node) => visit(node, IDENTITY));
  return { pieces, materials, views, shape, extras: scene.extras || {} };
}

/** All triangles of a model in flat arrays: corner by corner place, normal and move, and which piece each is of. */
function trianglesOf(model) {
  const counts = model.pieces.map((p) => (p.indices ? p.indices.length : p.positions.length / 3));
  const total = counts.reduce((a, b) => a + b, 0);
  const out = { count: total, positions: new Float32Array(total * 3), normals: new Float32Array(total * 3), moves: new Float32Array(total * 3), pieces: new Uint16Array(total) };
  let at = 0;
  model.pieces.forEach((piece, number) => {
    const [a, b, c] = normalMatrix(piece.place);
    for (let n = 0; n < counts[number]; n++, at++) {
      const i = (piece.indices ? piece.indices[n] : n) * 3;
      out.positions.set(moved(piece.place, piece.positions.subarray(i, i + 3)), at * 3);
      out.pieces[at] = number;
      if (piece.normals) {
        const [x, y, z] = piece.normals.subarray(i, i + 3);
        out.normals.set(unit([a[0] * x + b[0] * y + c[0] * z, a[1] * x + b[1] * y + c[1] * z, a[2] * x + b[2] * y + c[2] * z]), at * 3);
      }
      if (piece.moves) {
        const [x, y, z] = piece.moves.subarray(i, i + 3), m = piece.place;
        out.moves.set([m[0] * x + m[4] * y + m[8] * z, m[1] * x + m[5] * y + m[9] * z, m[2] * x + m[6] * y + m[10] * z], at * 3);
      }
    }
    if (!piece.normals) flatNormals(out, at - counts[number], at);
  });
  return out;
}

/** Normals of the faces themselves, where a model brings none. */
function flatNormals(out, from, to) {
  for (let t = from; t + 2 < to; t += 3) {
    const corner = (k) => Array.from(out.positions.subarray((t + k) * 3, (t + k) * 3 + 3));
    const normal = unit(cross(sub(corner(1), corner(0)), sub(corner(2), corner(0))));
    for (let k = 0; k < 3; k++) out.normals.set(normal, (t + k) * 3);
  }
}
