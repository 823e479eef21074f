// SPDX-License-Identifier: MIT
// What must be known of a scene before it is shown, found in portions between which the page
// answers.
import { Box3, Sphere } from 'three';
import { breath } from '../base/breath.js';
import { openSide } from '../triangles/facing.js';
import { surfacesOf } from './model_view.js';
import { withNormals } from '../triangles/normals.js';
import { originNear } from '../triangles/origin.js';
import { outlineOf, polygonsOf } from '../triangles/polygons.js';
import { soupOf } from '../triangles/soup.js';

/** The geometry as it is drawn, which knows its polygons.
 * @param {import('./model_view.js').Surface} surface as loaded */
async function drawn(surface) {
  const { geometry } = surface;
  const polygons = polygonsOf(surface);
  const outline = polygons && outlineOf(geometry, polygons);
  const result = await withNormals(geometry);
  if (polygons) Object.assign(result.userData, { polygons, outline });
  return result;
}

/** @param {import('three').Group} scene as loaded: it is moved to where the stage shows it
 * @param {import('three').Vector3 | null} origin the stage's, in the model's world; null: its own
 * @returns {Promise<import('./model_view.js').Prepared>} */
export async function prepare(scene, origin) {
  const surfaces = surfacesOf(scene);
  scene.updateMatrixWorld(true);
  const shaded = new Map();  // a geometry can be shown in several places
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
    // Good enough to tell what is in view, and known already.
    geometry.boundingSphere ??= geometry.boundingBox?.getBoundingSphere(new Sphere()) ?? null;
  }
  await breath();
  return { scene, bounds, origin: shown, front: openSide(soupOf(surfaces)) };
}
