// SPDX-License-Identifier: MIT
// Prepares a scene to be shown. The work is done in portions, between which the page can react.
import { Box3, Sphere } from 'three';
import { breath } from '../base/breath.js';
import { openSide } from '../triangles/facing.js';
import { surfacesOf } from './model_view.js';
import { withNormals } from '../triangles/normals.js';
import { originNear } from '../triangles/origin.js';
import { outlineOf, polygonsOf } from '../triangles/polygons.js';
import { soupOf } from '../triangles/soup.js';

/** The geometry to draw, with normals and, if the file has them, polygons.
 * @param {import('./model_view.js').Surface} surface as loaded */
async function drawn(surface) {
  const { geometry } = surface;
  const polygons = polygonsOf(surface);
  const outline = polygons && outlineOf(geometry, polygons);
  const result = await withNormals(geometry);
  if (polygons) Object.assign(result.userData, { polygons, outline });
  return result;
}

/** @param {import('three').Group} scene as loaded; it is moved so that `origin` becomes zero
 * @param {import('three').Vector3 | null} origin in the model's world; null: from its bounds
 * @returns {Promise<import('./model_view.js').Prepared>} */
export async function prepare(scene, origin) {
  const surfaces = surfacesOf(scene);
  scene.updateMatrixWorld(true);
  const shaded = new Map();  // several surfaces can share a geometry
  for (const surface of surfaces) {
    const { geometry } = surface;
    if (!shaded.has(geometry)) shaded.set(geometry, await drawn(surface));
    surface.geometry = shaded.get(geometry);
  }
  await breath();
  const bounds = new Box3().setFromObject(scene);
  const shown = origin ?? originNear(bounds);
  scene.position.sub(shown);
  scene.updateMatrixWorld(true);
  bounds.translate(shown.clone().negate());
  for (const { geometry } of surfaces) {
    // The box is already computed, and its sphere is good enough for culling.
    geometry.boundingSphere ??= geometry.boundingBox?.getBoundingSphere(new Sphere()) ?? null;
  }
  await breath();
  return { scene, bounds, origin: shown, front: await openSide(soupOf(surfaces)) };
}
