// Validates the GLB files given as arguments with the Khronos validator. The module `gltf-validator` (npm) is looked for
// in GLTF_VALIDATOR_DIR (a folder that holds node_modules), else beside this file as node does.
// Exit code: 0 without errors and warnings, 1 with, 3 when the module is not there.
import fs from 'node:fs';
import path from 'node:path';
import { createRequire } from 'node:module';

const base = process.env.GLTF_VALIDATOR_DIR;
const require = createRequire(base ? path.join(path.resolve(base), 'here.js') : import.meta.url);
let validator;
try {
  validator = require('gltf-validator');
} catch {
  console.error('gltf-validator not found: npm install gltf-validator, and set GLTF_VALIDATOR_DIR to that folder');
  process.exit(3);
}
let bad = 0;
for (const file of process.argv.slice(2)) {
  const { issues } = await validator.validateBytes(new Uint8Array(fs.readFileSync(file)), { uri: file, maxIssues: 50 });
  bad += issues.numErrors + issues.numWarnings;
  console.log(`${file}: ${issues.numErrors} errors, ${issues.numWarnings} warnings, ${issues.numInfos} infos`);
  for (const m of issues.messages) console.log(`  severity ${m.severity} ${m.code} ${m.pointer ?? ''} ${m.message}`);
}
process.exit(bad ? 1 : 0);
