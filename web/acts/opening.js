// SPDX-License-Identifier: MIT
// Opens a model: finds it among the files, reads and shows it, and remeshes it if that is quick.
import { RemeshError } from 'remesher';
import { byId } from '../base/dom.js';
import { t } from '../base/i18n.js';
import { unpacked } from '../files/archives.js';
import { writeAddress } from '../model/address.js';
import { remeshAll } from '../model/batch.js';
import { modelFrom, modelsAmong } from '../files/models.js';
import { PageError } from '../files/files.js';
import { addRecent } from '../model/recent.js';
import { sampleOf } from '../model/samples.js';
import { chooseModel } from '../panel/chooser.js';
import { download } from '../panel/downloads.js';
import { fillMenu, showInMenu } from '../panel/intake.js';
import { announce, isAbort, showNews, showProgress } from '../panel/messages.js';
import { modelFacts } from '../report/report_view.js';
import { showSize, tellPanel } from './measures.js';
import { clearResult, remesh, remeshToEnough, showReport } from './running.js';

/** @typedef {import('./page.js').Page} Page */
/** @typedef {import('../files/files.js').PathedFile} PathedFile */
/** @typedef {import('../model/address.js').Values} Values */

/** Larger models wait for the button instead of starting by themselves. */
const largestAutomatic = 150_000;
/** For larger models further runs, for a number that is enough, take too long. */
const largestRaised = 50_000;

/** The facts about the model, in words. @param {Page} page */
export function showFacts({ session: { model, inspection, source } }) {
  if (!model || !inspection) return;
  byId('model-name', HTMLElement).textContent = model.name;
  byId('model-facts', HTMLElement).textContent = modelFacts(inspection);
  const origin = byId('model-origin', HTMLElement);
  const sample = sampleOf(source);
  origin.hidden = !sample;
  if (sample) origin.textContent = t(`origin.${sample.id}`);
}

/** The same in another language. @param {Page} page */
export function retellFacts(page) {
  showFacts(page);
  showSize(page, () => showReport(page));
}

/** Goes on without a picture of a model that has no room to be converted, though it has to be
 * remeshed. @param {Page} page @param {unknown} error */
function showNoOriginal({ stage }, error) {
  if (!(error instanceof RemeshError) || error.code !== 'OUT_OF_MEMORY') throw error;
  stage.clear('original');
  showNews(t('picture.room'));
}

/** Shows the file itself if the viewer can read it, because a conversion may lose something.
 * @param {Page} page */
async function showOriginal(page) {
  const { session, stage, surveying, painting, guiding } = page;
  const show = async (/** @type {'direct' | 'converted'} */ way) => {
    const gltf = await session.originalAsGltf(way);
    page.tell(t('preparing.picture'));
    await stage.show('original', gltf);
  };
  try {
    await show('direct');
  } catch (error) {
    if (isAbort(error)) throw error;
    await show('converted').catch((cause) => showNoOriginal(page, cause));
  }
  await surveying.measureExtent();
  showSize(page, () => showReport(page));
  await surveying.shown('original');
  tellPanel(page);
  painting.begin();
  guiding.begin();
}

/** A model begins with the defaults and what an address asked for: no option of the model before
 * stays. @param {Page} page @param {Values} wished */
function setForm({ panel, session }, wished) {
  panel.setInput(session.inspection?.input.vertices ?? 0, sampleOf(session.source)?.vertices);
  panel.setValues(wished);
}

/** Whether the model's own number is too small: the visitor has not asked for it.
 * @param {unknown} error */
const isTooFew = (error) => error instanceof RemeshError
  && (error.code === 'TARGET_TOO_SMALL' || error.code === 'TARGET_BELOW_CURVES');

/** Remeshes by the form. Where that asks for the model's own number of vertices, and these are too
 * few for isotropic triangles, as many as these need are tried, unless the address names a number.
 * @param {Page} page @param {{ wished: Values, onForm: () => void }} opening */
async function remeshAtFirst(page, { wished, onForm }) {
  const { session, panel } = page;
  const own = session.inspection?.input.vertices ?? Infinity;
  const { vertices, prefer } = panel.values();
  const isFree = !('vertices' in wished) && vertices === own && prefer !== 'shape'
    && !wished.purpose && own <= largestRaised;
  try {
    await remesh(page);
  } catch (error) {
    if (!isFree || !isTooFew(error)) throw error;
    await remeshToEnough(page, onForm);
    return;
  }
  if (isFree && session.shown?.report.prefer?.includes('shape')) await remeshToEnough(page, onForm);
}

/** @param {Page} page @param {{ models: PathedFile[], items: PathedFile[] }} found */
async function remeshEach({ session, panel }, { models, items }) {
  const values = panel.values();
  const { file, outcomes } = await remeshAll(session, { models, items, values }, (name, i) => {
    const phase = t('batch.phase', { name, number: i + 1, total: models.length });
    showProgress({ phase, fraction: 0 });
    announce(phase);
  });
  download(file);
  const failed = outcomes.filter(({ error }) => error).map(({ name }) => name);
  const total = models.length;
  if (!failed.length) showNews(t('batch.done', { count: total }));
  else {
    throw new PageError(t('batch.failed', { failed: failed.length, count: total,
      names: failed.join(', ') }), t('batch.failed.hint'));
  }
}

/** Faults are looked for while other work goes on; of models that wait for the button, on request.
 * @param {Page} page @param {{ isLarge: boolean, isCancelled: boolean }} opened */
function findFaults({ session, surveying }, { isLarge, isCancelled }) {
  if (!session.hasRoomForFaults) surveying.leaveFaults({ kind: 'room' });
  else if (isLarge) surveying.leaveFaults({ kind: 'large', limit: largestAutomatic });
  else if (isCancelled) surveying.leaveFaults({ kind: 'skipped' });
  else void surveying.seekFaults();
}

/**
 * @param {Page} page
 * @param {Promise<PathedFile[]>} coming
 * @param {{ source: string | null, wished: Values, onForm: () => void }} from `wished`: by the
 *   address; onForm: the form has its values
 */
export function open(page, coming, { source, wished, onForm }) {
  const { session, panel } = page;
  /** @type {{ model: object, isLarge: boolean, isCancelled: boolean } | undefined} */
  let opened;
  return page.busy(async () => {
    const items = await unpacked(await coming);
    const models = modelsAmong(items);
    const chosen = models.length > 1 ? await chooseModel(models) : models[0];
    if (!chosen) return;
    if (chosen === 'all') {
      await remeshEach(page, { models, items });
      return;
    }
    const model = await modelFrom(chosen, items);
    announce(t('opening', { name: model.name }));
    const { report, signal } = await session.open(model, source);
    clearResult(page);
    page.surveying.forgetModel();
    page.panel.forgetSubject();
    if (!source) await addRecent(model.name, items);
    fillMenu();
    showInMenu(source);
    showFacts(page);
    showReport(page);
    setForm(page, wished);
    await showOriginal(page);
    onForm();
    announce(t('opened', { name: model.name, facts: modelFacts(report) }));
    const isLarge = report.input.vertices > largestAutomatic;
    opened = { model, isLarge, isCancelled: session.isCancelled };
    if (isLarge) history.replaceState(null, '', writeAddress(source, panel.values()));
    if (isLarge || signal.aborted) return;
    await remeshAtFirst(page, { wished, onForm });
  }).then(() => { if (opened && opened.model === session.model) findFaults(page, opened); });
}
