// SPDX-License-Identifier: MIT
// Starts a run and shows its result, with the report, the history and the ways to save.
import { targetNames } from 'remesher/options';
import { byId, element } from '../base/dom.js';
import { count, degrees } from '../base/format.js';
import { t } from '../base/i18n.js';
import { writeAddress } from '../model/address.js';
import { distanceView } from '../report/distance_view.js';
import { historyView, resultName } from '../report/history_view.js';
import { landmarkOf } from '../report/landmarks.js';
import { mapsView, mapTitles } from '../report/maps_view.js';
import { setSavable } from '../panel/downloads.js';
import { announce } from '../panel/messages.js';
import { openExpert } from '../panel/expert.js';
import { exactFrom, isRepairOnly } from '../model/purposes.js';
import { reportView } from '../report/report_view.js';
import { takeawayView } from '../report/takeaway.js';
import { verdictInShort, verdictView } from '../report/verdict.js';
import { unitOption } from './measures.js';
import { besides, downloadFormat, downloadLabel, savingActs } from './saving.js';

/** @typedef {import('./page.js').Page} Page */
/** @typedef {import('../model/result.js').Result} Result */
/** @typedef {import('remesher').RemeshOptions} RemeshOptions */

/** Percent of the diagonal that nobody sees: the bound that is offered where shape was lost. */
const within = 0.2;
const noTarget = Object.fromEntries(targetNames.map((name) => [name, '']));

/** Writes both sides' names, and the report on the right side, in the current language.
 * @param {Page} page */
export function showReport(page) {
  const { session, stage } = page;
  const { shown, baseline, inspection } = session;
  if (inspection) {
    stage.nameLeft(baseline ? resultName(baseline) : t('original'),
      baseline?.report.output.vertices ?? inspection.input.vertices);
  }
  if (!shown) return;
  stage.nameRight(shown.number ? t('result') : t('draft'), shown.report.output.vertices);
  const history = historyView(session, {
    onShow: (result) => page.busy(() => showResult(page, result)),
    onCompare: (result) => page.busy(() => compareWith(page, result)),
  });
  byId('result', HTMLElement).replaceChildren(
    ...reportView(shown.report, {
      visitorOf: (warning) => visitorOf(page, warning),
      onLargest: () => page.surveying.visitLargest(),
    }),
    ...(shown.number ? homeViews(page, shown) : []),
    ...(history ? [history] : []));
  byId('result', HTMLElement).hidden = false;
  showVerdict(page);
  showDistances(page);
}

/** The largest distance of the shown result from the original, in model units, if known.
 * @param {Page} page @param {Result} shown */
function largestOf({ surveying }, { report: { fidelity } }) {
  if (fidelity) return fidelity.hausdorff / 100 * surveying.diagonal;
  return surveying.distances?.largest ?? null;
}

/** The verdict on the shown result, and the button that saves it. @param {Page} page */
function showVerdict(page) {
  const { session, surveying, panel } = page;
  const { shown, model, inspection } = session;
  if (!shown || !model) return;
  const format = downloadFormat(model.name, shown.values);
  const size = shown.sizeIn(format);
  const { triangles, quads } = shown.report.output;
  const judged = { report: shown.report, values: shown.values, scale: surveying.scale,
    diagonal: surveying.diagonal, largest: largestOf(page, shown),
    exact: exactFrom(surveying.corners, inspection?.input.triangles ?? 0),
    edges: surveying.distances?.edges, maps: shown.number ? mapTitles(shown) : [], format, size,
    original: model.size };
  byId('verdict', HTMLElement).replaceChildren(verdictView(judged, {
    onLargest: () => surveying.visitLargest(),
    onPlace: (place) => surveying.visitPlace(place),
    onThicken: () => panel.runWith({ repair: 'wrap' }),
    onWithin: () => panel.runWith({ ...noTarget, maxError: within }),
    onExact: () => panel.runWith({ ...noTarget, faces: judged.exact }),
    onMore: () => panel.runWith({ ...noTarget,
      faces: 2 * (quads?.count ?? triangles) }),
    onShorter: () => panel.runWith({ edgeLength: Number(shown.values.edgeLength) / 2 }),
    onMaps: () => openExpert('.maps'),
    onNotes: () => openExpert('#result'),
  }));
  byId('verdict-short', HTMLElement).textContent = verdictInShort(judged);
  byId('verdict', HTMLElement).hidden = false;
  byId('download', HTMLButtonElement).replaceChildren(...downloadLabel(format, size));
  byId('besides', HTMLElement).replaceChildren(...besides(format, shown.values).map((other) =>
    element('button', { type: 'button', onclick: () => savingActs(page, shown).onFormat(other) },
      other.toUpperCase())));
  setSavable(page.isIdle && shown.number > 0);  // its distances may come while another is made
  byId('download-bar', HTMLElement).hidden = false;
}

/** Saves the shown result in the format on the button. @param {Page} page */
export async function saveShown(page) {
  const { shown, model } = page.session;
  if (!shown?.number || !model) return;
  await savingActs(page, shown).onFormat(downloadFormat(model.name, shown.values));
}

/** The views to save a result and its maps. @param {Page} page @param {Result} result */
function homeViews(page, result) {
  const acts = savingActs(page, result);
  const maps = mapsView(result, acts.onFile);
  return [...(maps ? [maps] : []), takeawayView(page.session, result, acts)];
}

/** A function that shows a warning's place, null if the place is unknown.
 * @param {Page} page @param {import('remesher').Warning} warning */
function visitorOf({ surveying }, { code, at }) {
  const landmark = landmarkOf(code);
  if (at) return () => void surveying.visitPlace(at);
  return landmark ? () => surveying.visitLandmark(landmark) : null;
}

/** @param {Page} page */
function showDistances(page) {
  const { surveying, panel } = page;
  const box = document.getElementById('distances');
  const { distances, diagonal } = surveying;
  if (!box || !distances) return;
  box.hidden = false;
  box.replaceChildren(...distanceView(distances, { diagonal, scale: surveying.scale }, {
    onVisit: () => surveying.visitLargest(),
    onMaxError: (error, isChosen) => panel.ask('maxError', error, isChosen),
  }));
}

/** Shows a result, and then its distances from the original.
 * @param {Page} page @param {Result} result */
async function stageResult(page, result) {
  const { stage, surveying, guiding } = page;
  await stage.show('result', { bytes: result.bytes, resources: [] });
  await surveying.shown('result', !result.number);
  guiding.show();
  showReport(page);
  if (!result.number && stage.shading !== 'distance') return;
  void surveying.measure().then((distances) => {
    if (!distances) return;
    showDistances(page);
    showVerdict(page);
  });
}

/** @param {Page} page @param {Result} result */
async function showResult(page, result) {
  const { session, panel } = page;
  session.shown = result;
  if (session.baseline === result) await compareWith(page, null);
  panel.setValues(result.values);
  await stageResult(page, result);
}

/** @param {Page} page @param {Result | null} baseline null: the original */
async function compareWith(page, baseline) {
  const { session, stage } = page;
  session.baseline = baseline;
  if (baseline) await stage.show('baseline', { bytes: baseline.bytes, resources: [] });
  else stage.clear('baseline');
  await page.surveying.shown('baseline');
  page.guiding.show();
  showReport(page);
}

/** @param {Page} page */
export function clearResult({ stage }) {
  stage.clear('result');
  stage.clear('baseline');
  for (const id of ['result', 'verdict']) {
    const view = byId(id, HTMLElement);
    view.hidden = true;
    view.replaceChildren();
  }
  byId('download-bar', HTMLElement).hidden = true;
  byId('result-count', HTMLElement).textContent = '';
}

/** The announcement for screen readers. @param {import('remesher').MeshReport} output */
function done({ vertices, minAngle, quads }) {
  if (!quads) {
    return t('done', { count: count(vertices), mean: degrees(minAngle.mean),
      worst: degrees(minAngle.worst) });
  }
  return t('done.quads', { count: count(vertices), quads: count(quads.count),
    irregular: count(quads.irregular), mean: degrees(quads.angleDeviation.mean) });
}

/** @param {Page} page @param {RemeshOptions} [extra] options that are not in the form */
export async function remesh(page, extra = {}) {
  const { session, panel } = page;
  const values = panel.values();
  setSavable(false);  // what is shown is not what was asked for
  history.replaceState(null, '', writeAddress(session.source, values));
  const more = isRepairOnly(values) ? {} : { ...extra, ...await page.painting.option(),
    ...page.guiding.option() };
  const result = await session.run(values, { ...unitOption(page), ...more });
  await stageResult(page, result);
  announce(done(result.report.output));
}

/** Makes a result with the number of vertices left open. If it has more than the model, as even
 * triangles need, or there is none yet, it takes the place of all results, and its number that of
 * the first.
 * @param {Page} page @param {() => void} onForm the form has that number */
export async function remeshToEnough(page, onForm) {
  const { session, panel } = page;
  const open = { ...panel.values() };
  delete open.vertices;
  const result = await session.attempt(open);
  const { warnings, output } = result.report;
  const isMore = warnings.some(({ code }) => code === 'MORE_VERTICES_TAKEN');
  if (session.shown && !isMore) return;
  panel.setEnough(output.vertices);
  result.values = panel.values();
  onForm();
  history.replaceState(null, '', writeAddress(session.source, panel.values()));
  session.keepOnly(result);
  await stageResult(page, result);
  announce(done(result.report.output));
}
