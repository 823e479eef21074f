// SPDX-License-Identifier: MIT
// The page's wiring of events to acts.
import { init } from 'remesher';
import { codecs } from 'remesher/codecs';
import { open, retellFacts } from './acts/opening.js';
import { Page } from './acts/page.js';
import { remesh, saveShown, showReport } from './acts/running.js';
import { Steering } from './acts/steering.js';
import { addCommand, wireCommands } from './base/commands.js';
import { byId } from './base/dom.js';
import { firstLanguage, onLanguage, setLanguage } from './base/i18n.js';
import { readAddress } from './model/address.js';
import { samples } from './model/samples.js';
import { fillMenu, namedFiles, wireIntake } from './panel/intake.js';
import { showCallouts } from './panel/callouts.js';
import { wireExpert } from './panel/expert.js';
import { wireSettings } from './panel/settings.js';

let wished = readAddress(location.hash);
const first = wished.model ?? samples[0].id;
// Both load while the page is being made. Their errors are shown later, where they are awaited.
const coming = namedFiles(first);
coming.catch(() => {});
init({ codecs }).catch(() => {});

await setLanguage(firstLanguage());
const steering = new Steering();
const page = new Page({
  onSubmit: () => run(), onSettle: () => steering.settle(), onMove: () => move(),
  onStroke: () => steering.stroke(),
});
steering.wire(page);
/** The angle of the feature curves last shown. */
let featureAngle = page.panel.featureAngle;

function move() {
  if (page.panel.featureAngle !== featureAngle) page.surveying.followFeatures();
  forgetAngle();
  steering.move();
}

/** An angle that the form got from a purpose is no change by the visitor. */
function forgetAngle() {
  ({ featureAngle } = page.panel);
}

function run() {
  steering.stop();
  forgetAngle();
  return page.busy(() => remesh(page));
}

function cancel() {
  steering.stop();
  page.session.cancel();
}

/** The address's options, which apply once: to the present model or to the next. */
function granted() {
  const { values } = wished;
  wished = { model: null, values: {} };
  return values;
}

/** Opens a model, with the address's options.
 * @param {Promise<import('./files/files.js').PathedFile[]>} items @param {string | null} source */
function take(items, source) {
  const values = granted();
  steering.stop();
  void open(page, items, { source, wished: values, onForm: () => {
    steering.begin();
    forgetAngle();
  } });
}

onLanguage(() => {
  page.panel.build();
  page.stage.fillMenu();
  fillMenu();
  retellFacts(page);
  page.surveying.retell();
  showReport(page);
});
wireIntake(take);
wireSettings(fillMenu);
wireExpert();
showCallouts();
addCommand('cancel', cancel);
byId('download', HTMLButtonElement).addEventListener('click', () => void saveShown(page));
wireCommands();
fillMenu();
take(coming, first);

addEventListener('beforeunload', (event) => {
  if (page.session.isUnsaved) event.preventDefault();  // the browser asks before it leaves
});
// Keeping the page takes as long as loading it, so it begins 3 seconds after the load.
addEventListener('load', () => setTimeout(keepOffline, 3000));

function keepOffline() {
  const { serviceWorker } = navigator;
  // If service workers are forbidden, the page needs the network, like any other.
  serviceWorker?.register('./offline.js').catch(() => {});
}

addEventListener('hashchange', () => {  // typed by hand: the page's own changes fire no event
  wished = readAddress(location.hash);
  if (wished.model && wished.model !== page.session.source) {
    take(namedFiles(wished.model), wished.model);
    return;
  }
  page.panel.setValues(granted());
  steering.settle();
  void run();
});
