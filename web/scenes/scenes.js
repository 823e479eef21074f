// SPDX-License-Identifier: MIT
// Fills the figures of "How it works": each names its scene in `data-scene`.
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

/** @type {NodeListOf<HTMLElement>} */
const figures = document.querySelectorAll('figure[data-scene]');
for (const figure of figures) scenes[figure.dataset.scene ?? ''](figure);
