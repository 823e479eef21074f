// SPDX-License-Identifier: MIT
// Fills the documentation's live figures: each names its scene in `data-scene`. The jobs of the
// guides need the whole package, the steps in "How it works" the engine for arrays only.
import { delaunayFlipScene } from './delaunay_flip.js';
import { diskPatchScene } from './disk_patch.js';
import { polarMapScene } from './polar_map.js';
import { relocationScene } from './relocation.js';
import { remeshedScene } from './remeshed.js';

/** @type {Record<string, (figure: HTMLElement) => void | Promise<void>>} */
const scenes = {
  'disk-patch': diskPatchScene,
  'polar-map': polarMapScene,
  'delaunay-flip': delaunayFlipScene,
  relocation: relocationScene,
  remeshed: remeshedScene,
};
const jobs = 'job-';

/** @type {NodeListOf<HTMLElement>} */
const figures = document.querySelectorAll('figure[data-scene]');
for (const figure of figures) {
  const { scene = '' } = figure.dataset;
  if (scene.startsWith(jobs)) {
    void import('./jobs.js').then((all) => all.jobs[scene.slice(jobs.length)](figure));
  } else void scenes[scene](figure);
}
