// SPDX-License-Identifier: MIT
// Runs in Chromium: renders two glTF files from the twelve corners of an icosahedron around the
// first, and compares the pictures pixel by pixel.
import {
  Box3, Color, DirectionalLight, HemisphereLight, IcosahedronGeometry, NoToneMapping,
  PerspectiveCamera, Scene, Sphere, Vector3, WebGLRenderer,
} from 'three';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';

const size = 400;
const renderer = new WebGLRenderer({ alpha: true, preserveDrawingBuffer: true });
renderer.setSize(size, size, false);
renderer.toneMapping = NoToneMapping;

function directions() {
  const { position } = new IcosahedronGeometry(1).attributes;
  const corners = Array.from({ length: position.count }, (_, i) =>
    new Vector3().fromBufferAttribute(position, i));
  return corners.filter((corner, i) =>
    corners.findIndex((other) => other.distanceTo(corner) < 1e-3) === i);
}

/** Sets anisotropic filtering: textures seen at a slant, or with texels longer than wide, are then
 * not blurred as widely as along their length. */
function filterAlong(model, anisotropy) {
  model.traverse(({ material }) => {
    const maps = Object.values(material ?? {}).filter((value) => value?.isTexture);
    for (const map of maps) map.anisotropy = anisotropy;
  });
}

async function sceneOf(url, anisotropy = 1) {
  const scene = new Scene();
  const model = (await new GLTFLoader().loadAsync(url)).scene;
  filterAlong(model, anisotropy);
  scene.add(model);
  scene.add(new HemisphereLight(new Color(1, 1, 1), new Color(0.3, 0.3, 0.3), 2));
  const light = new DirectionalLight(new Color(1, 1, 1), 2);
  light.position.set(1, 2, 3);
  scene.add(light);
  return scene;
}

function picture(scene, camera) {
  renderer.render(scene, camera);
  const gl = renderer.getContext();
  const pixels = new Uint8Array(4 * size * size);
  gl.readPixels(0, 0, size, size, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
  return pixels;
}

const near = (pixels, at, colour) =>
  colour.every((value, k) => Math.abs(pixels[at + k] - value) < 40);

const luminance = (pixels, at) =>
  0.2126 * pixels[at] + 0.7152 * pixels[at + 1] + 0.0722 * pixels[at + 2];

/** Structural similarity [Wang et al. 2004] of two windows, from sums over their n pixels. */
function similarity({ n, a, b, aa, bb, ab }) {
  const [c1, c2] = [(0.01 * 255) ** 2, (0.03 * 255) ** 2];
  const [meanA, meanB] = [a / n, b / n];
  const [varA, varB, both] = [aa / n - meanA ** 2, bb / n - meanB ** 2, ab / n - meanA * meanB];
  return (2 * meanA * meanB + c1) * (2 * both + c2)
    / ((meanA ** 2 + meanB ** 2 + c1) * (varA + varB + c2));
}

const [windowSize, windowStep] = [8, 4];

/** The sums over a window; `shown`: whether the window shows a part of either model. */
function windowSums(a, b, left, top) {
  const sums = { n: windowSize * windowSize, a: 0, b: 0, aa: 0, bb: 0, ab: 0, shown: false };
  for (let i = 0; i < sums.n; i += 1) {
    const at = 4 * ((top + Math.floor(i / windowSize)) * size + left + (i % windowSize));
    sums.shown ||= a[at + 3] + b[at + 3] > 0;
    const [u, v] = [luminance(a, at), luminance(b, at)];
    sums.a += u;
    sums.b += v;
    sums.aa += u * u;
    sums.bb += v * v;
    sums.ab += u * v;
  }
  return sums;
}

/** The mean over all windows of 8 × 8 pixels, four apart, that show a part of a model. */
function ssim(a, b) {
  let [sum, windows] = [0, 0];
  for (let top = 0; top + windowSize <= size; top += windowStep) {
    for (let left = 0; left + windowSize <= size; left += windowStep) {
      const sums = windowSums(a, b, left, top);
      if (!sums.shown) continue;
      sum += similarity(sums);
      windows += 1;
    }
  }
  return sum / windows;
}

/**
 * ssim: structural similarity, 1 at most.
 * difference: mean absolute difference of the colours, 0 to 1, over all `pixels` that show either.
 * strange: number of pixels of the second picture with the colour `forbidden`.
 */
function difference(a, b, forbidden) {
  let [sum, pixels, strange] = [0, 0, 0];
  for (let i = 0; i < a.length; i += 4) {
    if (a[i + 3] === 0 && b[i + 3] === 0) continue;
    pixels += 1;
    for (let k = 0; k < 3; k += 1) sum += Math.abs(a[i + k] - b[i + k]);
    if (forbidden && near(b, i, forbidden)) strange += 1;
  }
  return { difference: sum / (3 * 255 * pixels), pixels, strange, ssim: ssim(a, b) };
}

/** A picture from one of the directions, as a PNG's data URI. */
window.picture = async (url, view) => {
  const scene = await sceneOf(url);
  const { center, radius } = new Box3().setFromObject(scene).getBoundingSphere(new Sphere());
  const camera = new PerspectiveCamera(40, 1, radius, 5 * radius);
  camera.position.copy(center).addScaledVector(directions()[view], 3.1 * radius);
  camera.lookAt(center);
  renderer.render(scene, camera);
  return renderer.domElement.toDataURL('image/png');
};

/** views: the numbers of the directions; all twelve if none are given. */
window.compare = async (first, second, { forbidden, views, anisotropy } = {}) => {
  const [before, after] = await Promise.all([first, second].map((url) => sceneOf(url, anisotropy)));
  const { center, radius } = new Box3().setFromObject(before).getBoundingSphere(new Sphere());
  const camera = new PerspectiveCamera(40, 1, radius, 5 * radius);
  const from = directions();
  return (views?.map((view) => from[view]) ?? from).map((direction) => {
    camera.position.copy(center).addScaledVector(direction, 3.1 * radius);
    camera.lookAt(center);
    return difference(picture(before, camera), picture(after, camera), forbidden);
  });
};
