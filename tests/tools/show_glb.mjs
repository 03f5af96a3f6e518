// Shows GLB files with three.js in headless Chromium and takes a picture of each view (variant of materials).
//
//   node show_glb.mjs OUT_FOLDER FILE.glb...
//
// Modules `three` and `playwright-core` (npm) are looked for in THREE_DIR (a folder that holds node_modules), else beside this file as
// node does; CHROMIUM names the browser [default: /usr/bin/chromium]. Prints a line of JSON for each file: nodes, meshes, triangles,
// variants, animations' morph targets, and what the loader complained about. Exit code 1 when a file does not load or draws nothing,
// 3 when a module or the browser is missing.
import fs from 'node:fs';
import http from 'node:http';
import path from 'node:path';
import { createRequire } from 'node:module';

const base = process.env.THREE_DIR;
const require = createRequire(base ? path.join(path.resolve(base), 'here.js') : import.meta.url);
let chromium, three;
try {
  ({ chromium } = require('playwright-core'));
  three = path.dirname(path.dirname(require.resolve('three')));
} catch {
  console.error('three or playwright-core not found: npm install three playwright-core, and set THREE_DIR to that folder');
  process.exit(3);
}
const executablePath = process.env.CHROMIUM ?? '/usr/bin/chromium';
if (!fs.existsSync(executablePath)) {
  console.error(`${executablePath}: no browser; set CHROMIUM`);
  process.exit(3);
}
const [out, ...files] = process.argv.slice(2);
fs.mkdirSync(out, { recursive: true });

const page = `<!doctype html><body style="margin:0;background:#f3f3f1">
<script type="importmap">{"imports":{"three":"/three/build/three.module.js","three/addons/":"/three/examples/jsm/"}}</script>
<script type="module">
import * as THREE from 'three';
import { RoomEnvironment } from 'three/addons/environments/RoomEnvironment.js';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
const size = [1000, 750];
const renderer = new THREE.WebGLRenderer({ antialias: true, preserveDrawingBuffer: true });
renderer.setSize(...size);
document.body.append(renderer.domElement);
const scene = new THREE.Scene();
scene.background = new THREE.Color(0xf3f3f1);
// Metal is black where nothing is mirrored in it.
scene.environment = new THREE.PMREMGenerator(renderer).fromScene(new RoomEnvironment(), 0.04).texture;
scene.environmentIntensity = 0.35;
scene.add(new THREE.HemisphereLight(0xffffff, 0xb8b2a8, 0.7));
const sun = new THREE.DirectionalLight(0xfff4e2, 1.25);
sun.position.set(-5, 9, 7);
scene.add(sun);
let gltf;
window.load = async (url) => {
  if (gltf) scene.remove(gltf.scene);
  gltf = await new GLTFLoader().loadAsync(url);
  scene.add(gltf.scene);
  const box = new THREE.Box3().setFromObject(gltf.scene);
  const middle = box.getCenter(new THREE.Vector3());
  const radius = box.getSize(new THREE.Vector3()).length() / 2;
  const camera = new THREE.PerspectiveCamera(28, size[0] / size[1], 0.1, 1000);
  camera.position.copy(middle).add(new THREE.Vector3(-0.62, 0.42, 0.78).normalize().multiplyScalar(radius * 4.3));
  camera.lookAt(middle);
  window.camera = camera;
  let [nodes, meshes, triangles, morphs] = [0, 0, 0, 0];
  const geometries = new Set();
  gltf.scene.traverse((o) => {
    nodes += 1;
    if (!o.isMesh) return;
    meshes += 1;
    geometries.add(o.geometry.attributes.position);
    triangles += o.geometry.index.count / 3;
    morphs += o.morphTargetInfluences ? 1 : 0;
  });
  const variants = (gltf.userData.gltfExtensions?.KHR_materials_variants?.variants ?? []).map((v) => v.name);
  return { nodes, meshes, vertex_arrays: geometries.size, triangles, morphs, variants, size: box.getSize(new THREE.Vector3()).toArray() };
};
// Materials of a variant; its index, or -1 for those of the file.
window.show = async (variant) => {
  const jobs = [];
  gltf.scene.traverse((o) => {
    if (!o.isMesh) return;
    o.userData.own ??= o.material;
    const mappings = o.userData.gltfExtensions?.KHR_materials_variants?.mappings ?? [];
    const mapping = mappings.find((m) => m.variants.includes(variant));
    if (!mapping) { o.material = o.userData.own; return; }
    jobs.push(gltf.parser.getDependency('material', mapping.material).then((m) => { o.material = m; gltf.parser.assignFinalMaterial(o); }));
  });
  await Promise.all(jobs);
  renderer.render(scene, window.camera);
  const gl = renderer.getContext();
  const pixels = new Uint8Array(4 * size[0] * size[1]);
  gl.readPixels(0, 0, ...size, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
  let drawn = 0;
  for (let n = 0; n < pixels.length; n += 4) drawn += pixels[n] !== pixels[0] || pixels[n + 1] !== pixels[1] ? 1 : 0;
  return drawn / (pixels.length / 4);
};
window.bend = (amount) => gltf.scene.traverse((o) => { if (o.morphTargetInfluences) o.morphTargetInfluences.fill(amount); });
window.ready = true;
</script>`;

const types = { '.js': 'text/javascript', '.glb': 'model/gltf-binary' };
const server = http.createServer((request, answer) => {
  const url = decodeURIComponent(new URL(request.url, 'http://x').pathname);
  const file = url.startsWith('/three/') ? path.join(three, url.slice(7)) : url.startsWith('/file/') ? files[Number(url.slice(6))] : null;
  if (url === '/') return answer.writeHead(200, { 'content-type': 'text/html' }).end(page);
  if (!file || !fs.existsSync(file)) return answer.writeHead(404).end();
  answer.writeHead(200, { 'content-type': types[path.extname(file)] ?? 'application/octet-stream' }).end(fs.readFileSync(file));
});
await new Promise((done) => server.listen(0, '127.0.0.1', done));
const browser = await chromium.launch({ executablePath, args: ['--no-sandbox', '--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader'] });
let bad = 0;
try {
  const tab = await browser.newPage({ viewport: { width: 1000, height: 750 } });
  const said = [];
  tab.on('console', (m) => ['warning', 'error'].includes(m.type()) && !/GL Driver|favicon|404/.test(m.text()) && said.push(m.text()));
  tab.on('pageerror', (e) => said.push(String(e)));
  await tab.goto(`http://127.0.0.1:${server.address().port}/`);
  await tab.waitForFunction('window.ready');
  for (const [n, file] of files.entries()) {
    said.length = 0;
    const name = path.basename(file, '.glb');
    try {
      const about = await tab.evaluate((url) => window.load(url), `/file/${n}`);
      const views = about.variants.length ? about.variants : [''];
      const drawn = {};
      for (const [v, view] of views.entries()) {
        drawn[view] = await tab.evaluate((v) => window.show(v), about.variants.length ? v : -1);
        await tab.screenshot({ path: path.join(out, `${name}${view && '-'}${view.replaceAll(' ', '-')}.png`) });
        bad += drawn[view] < 0.01 ? 1 : 0;
      }
      if (about.morphs) {
        await tab.evaluate(() => { window.bend(1); return window.show(0); });
        await tab.screenshot({ path: path.join(out, `${name}-deformed.png`) });
        await tab.evaluate(() => window.bend(0));
      }
      bad += said.length;
      console.log(JSON.stringify({ file: path.basename(file), ...about, drawn, said }));
    } catch (error) {
      bad += 1;
      console.log(JSON.stringify({ file: path.basename(file), failed: String(error), said }));
    }
  }
} finally {
  await browser.close();
  server.close();
}
process.exit(bad ? 1 : 0);
