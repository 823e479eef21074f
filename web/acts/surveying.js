// SPDX-License-Identifier: MIT
// The layers on top of the surfaces: distances as colours; curves, borders and faults as lines;
// the triangle under the pointer. The core finds edges, the survey's worker the rest.
import { RemeshError } from 'remesher';
import { Box3, Vector3 } from 'three';
import { addCommand } from '../base/commands.js';
import { distanceColors } from '../base/colors.js';
import { byId } from '../base/dom.js';
import { t } from '../base/i18n.js';
import { showFaultNote, showLandmarks } from '../report/landmarks.js';
import { showLegend, showProbe } from '../report/legend.js';
import { knownUnit, scaleOf, unitLike } from '../model/units.js';
import { announce, isAbort } from '../panel/messages.js';
import { Survey } from '../survey/survey.js';
import { ramp } from '../view/ramp.js';

/** @typedef {import('../view/viewer.js').Side} Side */
/** @typedef {import('../survey/surface.js').Distances} Distances */
/** @typedef {import('../survey/surface.js').Point} Point */
/** @typedef {import('../survey/lines.js').Edges} Edges */

/** @typedef {{ stage: import('../view/stage.js').Stage, panel: import('../panel/panel.js').Panel,
 *   session: import('../model/session.js').Session }} Desk */

const distanceColor = ramp(distanceColors);
/** Milliseconds before the page says that it still looks for faults. */
const patience = 1000;

export class Surveying {
  survey = new Survey();
  #page;
  /** @type {Distances | null} of the shown result */
  distances = null;
  /** @type {Edges | null} of the original */
  #edges = null;
  /** @type {import('remesher').FaultSummary | null} of the original */
  #faults = null;
  /** Why faults are not known. @type {import('../report/landmarks.js').FaultNote | null} */
  #faultNote = null;
  /** Per kind of fault, the number of its next place. @type {Record<string, number>} */
  #visited = {};
  #isProbing = false;

  /** @param {Desk} page */
  constructor(page) {
    this.#page = page;
    const { stage } = page;
    stage.onShading = () => this.#showLegend();
    addCommand('features', () => this.showFeatures(!this.#hasFeatures), 'e');
    addCommand('probe', () => void this.#probeMiddle(), 'i');
    const canvas = byId('canvas', HTMLCanvasElement);
    canvas.addEventListener('pointermove', (event) => {
      if (!event.buttons) void this.#probe({ x: event.offsetX, y: event.offsetY });
    });
    canvas.addEventListener('pointerleave', () => this.#showProbe(null, null));
  }

  /** The sides of the original's bounding box; null if there is no room for a picture of it.
   * @type {Vector3 | null} */
  extent = null;

  /** The corners of an original of flat sides; 0 of another, or if they are not known. */
  get corners() {
    return this.#edges?.corners ?? 0;
  }

  get diagonal() {
    return this.extent?.length() || this.#page.session.inspection?.diagonal || 1;
  }

  /** How lengths of the model are said. */
  get scale() {
    const { session } = this.#page;
    if (!session.model || session.isGltf) return scaleOf(null, this.diagonal);
    const longest = Math.max(...this.extent?.toArray() ?? [0]);
    return scaleOf(knownUnit(session) ?? unitLike(longest), this.diagonal);
  }

  /** How distances are said. */
  get #measure() {
    return { diagonal: this.diagonal, scale: this.scale };
  }

  /** Measures the original, also where it is not shown. */
  async measureExtent() {
    const { session, stage: { viewer } } = this.#page;
    if (viewer) {
      this.extent = viewer.view('original')?.bounds.getSize(new Vector3()) ?? null;
      return;
    }
    const { bytes } = await session.converted('off');
    const places = await this.survey.ask('offVertices', { bytes, origin: [0, 0, 0] });
    const box = new Box3().setFromArray(places);
    this.extent = box.getSize(new Vector3());
  }

  /** The x of the plane that mirrors the model. */
  get middle() {
    return this.#page.stage.viewer?.eye.center.x ?? 0;
  }

  /** A model is on the stage, or gone. @param {Side} side
   * @param {boolean} [isDraft] of which the field is shown that quads follow */
  async shown(side, isDraft = false) {
    const { session, stage: { viewer } } = this.#page;
    if (side !== 'baseline') this.distances = null;
    const view = viewer?.view(side);
    const soup = await view?.soup() ?? null;
    // Finding the edges of what is too large to be drawn whole takes as long as opening it.
    const isAsked = soup?.indices.length && !view?.thinning
      && (side === 'original' || soup.polygons);
    // The core copies what it is asked about before the worker gets it.
    const finding = isAsked ? session.edgesOf(soup) : null;
    const buffers = soup ? [soup.positions.buffer, soup.indices.buffer] : [];
    const [found] = await Promise.all(
      [finding, this.survey.ask('setSurface', { side, soup }, buffers)]);
    viewer?.overlays[side].setDots(found
      && await this.survey.ask('irregular', { side, first: found.first }));
    const strokes = isDraft && soup?.polygons ? await this.survey.ask('strokes', side) : null;
    viewer?.overlays[side].setLines('field', strokes ?? new Float32Array());
    viewer?.draw();
    this.#showLegend();
    if (side === 'original') await this.#showEdges(found);
  }

  /** Another model is open: nothing is known of it yet. */
  forgetModel() {
    this.#edges = null;
    this.#setFaults(null, null);
  }

  /** @param {import('remesher').FaultSummary | null} faults
   * @param {import('../report/landmarks.js').FaultNote | null} note */
  #setFaults(faults, note) {
    this.#faults = faults;
    this.#faultNote = note;
    this.#visited = {};
    this.#showLandmarks();
  }

  /** Faults are not looked for unless the visitor asks.
   * @param {import('../report/landmarks.js').FaultNote} why */
  leaveFaults(why) {
    this.#setFaults(null, why);
  }

  /** Looks for misplaced pieces and triangles while other work goes on. */
  async seekFaults() {
    const { session } = this.#page;
    const { model } = session;
    const isCurrent = () => session.model === model;
    const timer = setTimeout(() => isCurrent() && this.#setFaults(null, { kind: 'sought' }),
      patience);
    try {
      const whole = this.#page.stage.viewer?.view('original');
      const edges = whole?.thinning ? await session.edgesOf(await whole.soup()) : null;
      if (edges && isCurrent()) await this.#showEdges(edges);
      const { faults, hasRoom } = await session.faults();
      if (isCurrent()) this.#setFaults(faults, hasRoom ? null : { kind: 'room' });
    } catch (error) {
      if (!(error instanceof RemeshError) && !isAbort(error)) throw error;
      if (isCurrent()) this.#setFaults(null, { kind: 'failed' });
    } finally {
      clearTimeout(timer);
    }
  }

  /** @param {import('remesher').EdgeSummary | null} found on the original */
  async #showEdges(found) {
    this.#edges = found && await this.survey.ask('lines', found);
    const edges = this.#edges;
    const overlays = this.#page.stage.viewer?.overlays.original;
    if (edges) {
      overlays?.setLines('features', edges.sharp);
      this.showFeatures(this.#hasFeatures);
    }
    this.#showLandmarks();
  }

  /** Shows all texts again, in the current language. */
  retell() {
    this.#showLandmarks();
    this.#showLegend();
  }

  #showLandmarks() {
    const edges = this.#edges;
    const counts = edges && { boundary: edges.boundary.length / 6,
      nonManifold: edges.nonManifold.length / 6, flipped: edges.flipped.length / 6 };
    showLandmarks({ edges: counts, faults: this.#faults },
      { onVisit: (landmark) => this.visitLandmark(landmark),
        onFault: (fault) => this.#visitFault(fault),
        onMend: (isOnly) => this.#page.panel.repair(isOnly) });
    showFaultNote(this.#faultNote, () => void this.seekFaults());
  }

  get #hasFeatures() {
    return byId('features', HTMLButtonElement).getAttribute('aria-pressed') === 'true';
  }

  /** Shows or hides the original's edges that bend by the feature angle. @param {boolean} isOn */
  showFeatures(isOn) {
    const { stage, panel } = this.#page;
    byId('features', HTMLButtonElement).setAttribute('aria-pressed', String(isOn));
    const angle = panel.featureAngle;
    const bends = this.#edges?.bends ?? [];
    const firstBelow = bends.findIndex((bend) => bend < angle);
    const count = firstBelow < 0 ? bends.length : firstBelow;
    stage.viewer?.overlays.original.setCount('features', isOn ? count : 0);
    byId('features', HTMLButtonElement).dataset.count = String(count);
    stage.viewer?.draw();
  }

  /** Shows the edges while the feature angle changes. */
  followFeatures() {
    this.showFeatures(true);
  }

  /** @param {import('../report/landmarks.js').Landmark} landmark */
  visitLandmark(landmark) {
    const segments = this.#edges?.[landmark];
    const { viewer } = this.#page.stage;
    if (!segments?.length || !viewer) return;
    viewer.overlays.original.setLines(landmark, segments);
    void this.visit('original', /** @type {Point} */ (Array.from(segments.subarray(0, 3))));
  }

  /** Flies to the next place of a fault.
   * @param {import('../report/landmarks.js').FaultPlace} fault */
  #visitFault(fault) {
    const places = this.#faults?.places[fault] ?? [];
    const at = 3 * ((this.#visited[fault] ?? 0) % (places.length / 3));
    this.#visited[fault] = at / 3 + 1;
    const place = new Vector3(...places.slice(at, at + 3)).sub(this.#page.stage.origin);
    void this.visit('original', place.toArray());
  }

  /** Flies to a place, and marks it. @param {Side} side @param {Point} point */
  async visit(side, point) {
    const { viewer } = this.#page.stage;
    if (!viewer) return;
    viewer.overlays[side].setMark(point);
    const wished = viewer.eye.direction;
    viewer.eye.visit(point, await this.survey.ask('viewOf', { side, point, wished }));
    announce(t('visited'));
  }

  /** @param {Point} place of the result, in its file's world */
  visitPlace(place) {
    const { origin } = this.#page.stage;
    void this.visit('result', new Vector3(...place).sub(origin).toArray());
  }

  visitLargest() {
    if (!this.distances) return;
    this.#page.stage.setShading('distance');
    void this.visit('result', this.distances.place.point);
  }

  /** Distances of the shown result to the original; null without 3-D, or if overtaken. */
  async measure() {
    const { session: { shown }, stage: { viewer } } = this.#page;
    const { fidelity } = shown?.report ?? {};
    const known = fidelity ? fidelity.hausdorff / 100 * this.diagonal : null;
    const isRepair = !fidelity;
    const distances = viewer && await this.survey.ask('distances', { known, isRepair });
    if (shown !== this.#page.session.shown) return null;
    this.distances = distances;
    if (distances) this.#colorDistances(distances);
    this.#showLegend();
    return distances;
  }

  /** @param {Distances} distances */
  #colorDistances({ values, largest }) {
    const { viewer } = this.#page.stage;
    viewer?.view('result')?.setColors('distance', (vertex, color) =>
      distanceColor(values[vertex] / (largest || 1), color));
    this.#page.stage.setShading(this.#page.stage.shading);
  }

  #showLegend() {
    const largest = this.distances?.largest;
    showLegend(this.#page.stage.shading, {
      distance: largest === undefined ? null : { largest, ...this.#measure },
      faces: this.#page.stage.viewer?.faces ?? [],
    });
  }

  /** Shows the triangle at a point of the screen, one question at a time.
   * @param {{ x: number, y: number }} at */
  async #probe(at) {
    const ray = this.#page.stage.viewer?.rayAt(at);
    const { isBrushing, viewer } = this.#page.stage;
    if (this.#isProbing || isBrushing || viewer?.isCut) return;
    this.#isProbing = true;
    const pick = ray ? await this.survey.ask('pick', ray) : null;
    this.#isProbing = false;
    this.#showProbe(pick, ray?.side ?? null);
  }

  /** Shows the triangle in the middle of the result, for users without a pointer. */
  async #probeMiddle() {
    const { clientWidth, clientHeight } = byId('canvas', HTMLCanvasElement);
    await this.#probe({ x: 0.75 * clientWidth, y: 0.5 * clientHeight });
    announce(byId('probe', HTMLElement).textContent ?? '');
  }

  /** @param {import('../survey/picking.js').Pick | null} pick @param {Side | null} side */
  #showProbe(pick, side) {
    const { viewer } = this.#page.stage;
    if (!viewer) return;
    for (const [name, overlays] of Object.entries(viewer.overlays)) {
      const corners = name === side && pick ? pick.corners : [];
      overlays.setLines('probe', Float32Array.from(corners.flatMap((corner, i) =>
        [...corner, ...corners[(i + 1) % corners.length]])));
    }
    showProbe(pick, this.#measure);
    viewer.draw();
  }
}
