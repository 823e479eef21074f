// SPDX-License-Identifier: MIT
// The page's wiring: what happens when a model comes in, when a run is asked for, and when it ends.
import { commandLine, readAddress, writeAddress } from './model/address.js';
import { byId, element } from './base/dom.js';
import { download, downloadButtons } from './panel/downloads.js';
import { modelFrom } from './model/files.js';
import { count, degrees, withExtension } from './base/format.js';
import { wireIntake } from './panel/intake.js';
import { announce, isAbort, showError, showProgress } from './panel/messages.js';
import { Panel } from './panel/panel.js';
import { modelFacts, reportView } from './panel/report_view.js';
import { samples } from './model/samples.js';
import { Session } from './model/session.js';
import { Stage } from './view/stage.js';

/** Larger models wait for the button instead of starting by themselves. */
const largestAutomatic = 150_000;

const session = new Session((event) => showProgress(event));
const stage = new Stage();
const panel = new Panel(byId('form', HTMLFormElement), () => run());
const resultView = byId('result', HTMLElement);
let sample = /** @type {string | null} */ (null);

/** @param {'idle' | 'busy'} state */
function setState(state) {
  panel.setState(state);
  document.body.dataset.state = state;
  showProgress(state === 'busy' ? { phase: 'Preparing', fraction: 0 } : null);
}

let jobs = 0;

/** Runs a job with the page busy around it, its errors shown. A job that a later one has overtaken
 * no longer touches the page.
 * @param {() => Promise<void>} job */
async function busy(job) {
  const number = ++jobs;
  showError();
  setState('busy');
  try {
    await job();
  } catch (error) {
    if (number === jobs) showError(error);
    if (number === jobs && isAbort(error)) announce('Cancelled');
  } finally {
    if (number === jobs) setState('idle');
  }
}

/** The file itself where the viewer can read it, for it keeps what a conversion may not. */
async function showOriginal() {
  try {
    await stage.show('original', await session.originalAsGltf('direct'));
  } catch (error) {
    if (isAbort(error)) throw error;
    await stage.show('original', await session.originalAsGltf('converted'));
  }
}

/** @param {Promise<import('./model/files.js').PathedFile[]>} items
 * @param {string | null} from a sample */
function open(items, from) {
  return busy(async () => {
    const model = await modelFrom(await items);
    announce(`Opening ${model.name}`);
    const report = await session.open(model);
    sample = from;
    if (!sample) intake.clear();
    clearResult();
    byId('model-name', HTMLElement).textContent = model.name;
    byId('model-facts', HTMLElement).textContent = modelFacts(report, model.others);
    byId('original-count', HTMLElement).textContent = count(report.input.vertices);
    panel.setInput(report.input.vertices);
    const shown = samples.find(({ id }) => id === sample);
    if (shown) panel.setTarget(shown.vertices);
    if (Object.keys(wished.values).length) panel.setValues(wished.values);
    wished.values = {};  // the address speaks for the first model only
    await showOriginal();
    announce(`${model.name} is open: ${modelFacts(report, [])}`);
    if (report.input.vertices <= largestAutomatic) await remesh();
  });
}

function clearResult() {
  stage.clear('result');
  resultView.hidden = true;
  resultView.replaceChildren();
  byId('result-count', HTMLElement).textContent = '';
}

const run = () => busy(remesh);

async function remesh() {
  const values = panel.values();
  history.replaceState(null, '', writeAddress(sample, values));
  const { bytes, report } = await session.run(values);
  await stage.show('result', { bytes, resources: [] });
  const { vertices, minAngle } = report.output;
  byId('result-count', HTMLElement).textContent = count(vertices);
  resultView.replaceChildren(...reportView(report), downloadButtons(save), commandView(values));
  resultView.hidden = false;
  announce(`Done: ${count(vertices)} vertices, smallest angles ${degrees(minAngle.mean)} on `
    + `average, ${degrees(minAngle.worst)} at worst`);
}

/** @param {string} format */
const save = (format) => busy(async () => download(await session.filesAs(format)));

/** @param {import('./model/address.js').Values} values */
function commandView(values) {
  const name = session.model?.name ?? '';
  const command = commandLine(name, withExtension(name, 'remeshed.glb'), values);
  return element('details', { className: 'command' },
    element('summary', {}, 'The same on the command line'), element('code', {}, command));
}

const intake = wireIntake(open);
byId('cancel', HTMLButtonElement).addEventListener('click', () => session.cancel());
let wished = readAddress(location.hash);
intake.open(wished.model ?? '');

addEventListener('hashchange', () => {  // typed by hand: the page's own changes do not tell
  wished = readAddress(location.hash);
  if (wished.model && wished.model !== sample) {
    intake.open(wished.model);
    return;
  }
  panel.setValues(wished.values);
  void run();
});
