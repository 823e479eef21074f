// SPDX-License-Identifier: MIT
// Measures how well a textured model keeps its look with few triangles: with textures kept, with
// textures baked, and simplified by meshoptimizer to as many triangles. Pictures from twelve sides.
import { readFileSync } from 'node:fs';
import { basename, join } from 'node:path';

import { remeshFile } from 'remesher';

import { openGallery } from '../support/pictures.js';
import { simplified } from '../support/simplified.js';

const model = 'DamagedHelmet.glb';
const counts = [2900, 1450, 870];

const mean = (views, key) => views.reduce((sum, view) => sum + view[key], 0) / views.length;

/** What looks less alike than it should. @param {Record<string, number>} limits by the number of
 * vertices, of textures kept @param {any[]} rows */
const brokenLimits = (limits, rows) => rows
  .filter(({ vertices, textures, ssim }) => textures === 'keep' && Number(ssim) < limits[vertices])
  .map(({ vertices, ssim }) => `${vertices}, kept: SSIM ${ssim}, not ${limits[vertices]}`);

/** @param {{ keep: Record<string, number> }} limits of SSIM
 * @param {string | undefined} folder where the model is */
export async function runBake(limits, folder) {
  if (!folder) throw new Error(`Give the folder that ${model} is in.`);
  const bytes = readFileSync(join(folder, model));
  const gallery = await openGallery();
  const rows = [];
  try {
    for (const vertices of counts) {
      for (const textures of ['keep', 'bake', 'meshoptimizer']) {
        const begin = performance.now();
        const last = rows.at(-1);
        const result = textures === 'meshoptimizer'
          ? { bytes: await simplified(bytes, last.triangles) }
          : await remeshFile(bytes, { name: basename(model), vertices, textures });
        const seconds = (performance.now() - begin) / 1000;
        const views = await gallery.compare(bytes, result.bytes);
        const { triangles, minAngle } = result.report?.output ?? { triangles: last.triangles };
        rows.push({ vertices, textures, triangles, ssim: mean(views, 'ssim').toFixed(3),
          difference: `${(100 * mean(views, 'difference')).toFixed(2)} %`,
          angle: minAngle ? `${minAngle.mean.toFixed(1)}°` : '–',
          seconds: seconds.toFixed(1), bytes: result.bytes.length });
        console.error(JSON.stringify(rows.at(-1)));
      }
    }
  } finally {
    await gallery.close();
  }
  const heads = Object.keys(rows[0]);
  const table = [heads, heads.map(() => '---'), ...rows.map(Object.values)]
    .map((row) => `| ${row.join(' | ')} |`).join('\n');
  return { table, broken: brokenLimits(limits.keep, rows) };
}
