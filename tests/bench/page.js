// SPDX-License-Identifier: MIT
// Measures how long visitors of the page wait, and how long the page does not react. On a busy
// machine the clock tells little. So a wait is the lesser of the clock's time and the browser's
// processor time, in the best of several runs, each with an empty cache. The page's tasks are timed
// by the processor time of its main thread.
import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';

import { drop, openPage, opened, settled, startSite } from '../support/browser_page.js';
import { objText, torus } from '../support/shape_files.js';
import { fixed, markdownTable } from './table.js';

const samples = ['bunny', 'gear', 'scan', 'vase', 'teapot'];
const categories = ['devtools.timeline', 'disabled-by-default-devtools.timeline'];

/** Processor time of each process that this one has started, in milliseconds, by Linux's /proc. */
function processorTimes() {
  const processes = new Map(readdirSync('/proc').filter((name) => /^\d+$/.test(name)).map((id) => {
    try {
      const fields = readFileSync(`/proc/${id}/stat`, 'utf8').replace(/^.*\) /, '').split(' ');
      const [parent, user, system] = [fields[1], fields[11], fields[12]].map(Number);
      return [Number(id), { parent, ticks: user + system }];
    } catch {
      return [Number(id), { parent: 0, ticks: 0 }];  // the process has just ended
    }
  }));
  const isOurs = (id) => id === process.pid || (id > 1 && isOurs(processes.get(id)?.parent ?? 0));
  return new Map([...processes].filter(([id]) => id !== process.pid && isOurs(id))
    .map(([id, { ticks }]) => [id, 10 * ticks]));
}

/** The processor time of all these processes since then; some have ended meanwhile.
 * @param {Map<number, number>} before */
function computedSince(before) {
  return [...processorTimes()].reduce((sum, [id, now]) => sum + now - (before.get(id) ?? 0), 0);
}

/** Notes in the page the time of each first event, and each draft's duration, in milliseconds. */
function noteTimes() {
  const times = { drafts: [] };
  globalThis.times = times;
  const note = (name) => { times[name] ??= performance.now(); };
  const look = () => {
    if (Number(document.getElementById('canvas')?.dataset.triangles) > 0) note('picture');
    if (document.querySelector('.stage.has-result')) note('sample');
    requestAnimationFrame(look);
  };
  requestAnimationFrame(look);
  let begun = 0;
  addEventListener('DOMContentLoaded', () => new MutationObserver(() => {
    const isDraft = document.body.dataset.state === 'drafting';
    if (!isDraft && begun) times.drafts.push(performance.now() - begun);
    begun = isDraft ? performance.now() : 0;
  }).observe(document.body, { attributes: true, attributeFilter: ['data-state'] }));
}

/** The longest events within a task. */
function inside(task, events) {
  return events.filter(({ name, ts, dur, pid }) => pid === task.pid && !name.startsWith('Run')
    && ts >= task.ts && ts + dur <= task.ts + task.dur)
    .sort((a, b) => b.tdur - a.tdur).slice(0, 4)
    .map(({ name, tdur }) => `${name} ${(tdur / 1000).toFixed(0)}`).join(', ');
}

/** The main thread's tasks during an act, the longest first, each in milliseconds of processor
 * time. */
async function tasksOf(site, page, act) {
  await site.browser.startTracing(page, { categories });
  await act();
  const { traceEvents } = JSON.parse(await site.browser.stopTracing());
  const mains = traceEvents.filter(({ name, args }) => name === 'thread_name'
    && args.name === 'CrRendererMain').map(({ pid, tid }) => `${pid} ${tid}`);
  const events = traceEvents.filter(({ ph, tdur, pid, tid }) =>
    ph === 'X' && tdur && mains.includes(`${pid} ${tid}`));
  return events.filter(({ name }) => name === 'RunTask').sort((a, b) => b.tdur - a.tdur)
    .slice(0, 4).map((task) => ({ milliseconds: task.tdur / 1000, inside: inside(task, events) }));
}

/** The wait from an empty cache to the sample's result. */
async function arrival(site) {
  const start = processorTimes();
  const { page } = await openPage(site, { prepare: noteTimes });
  const least = {};
  for (const what of ['picture', 'sample']) {
    await page.waitForFunction((name) => globalThis.times[name], what);
    const computed = computedSince(start);
    least[what] = Math.min(computed, await page.evaluate((name) => globalThis.times[name], what));
  }
  await page.context().close();
  return least;
}

/** The shortest draft of each sample while its slider moves. */
async function drafts(site, runs) {
  const { page } = await openPage(site, { hash: '#model=bunny&vertices=500', prepare: noteTimes });
  await settled(page);
  const rows = [];
  for (const id of samples) {
    await page.selectOption('#samples', id);
    await page.waitForFunction((wanted) => location.hash.includes(`model=${wanted}`), id);
    await settled(page);
    await page.evaluate(() => { globalThis.times.drafts = []; });
    await page.focus('#target-slider');
    for (let i = 0; i < 2 * runs; i += 1) {
      await page.keyboard.press('ArrowLeft');
      await page.waitForFunction((count) => globalThis.times.drafts.length > count, i);
    }
    await settled(page);
    const times = await page.evaluate(() => globalThis.times.drafts);
    rows.push([`draft of ${id}, ms`, Math.min(...times)]);
  }
  await page.context().close();
  return rows;
}

/** How long the page does not react while a large file is opened and remeshed. */
async function blocking(site, folder) {
  const path = join(folder, 'horse.obj');
  if (!existsSync(path)) return [];
  const { page } = await openPage(site, { hash: '#model=gear&vertices=500' });
  await settled(page);
  const tasks = await tasksOf(site, page, async () => {
    await page.setInputFiles('#file-input', path);
    await opened(page, 'horse.obj');
    await page.waitForSelector('#distances:not([hidden])', { state: 'attached' });
    await page.waitForTimeout(300);
  });
  for (const { milliseconds, inside: parts } of tasks) {
    console.log(`a task of ${milliseconds.toFixed(0)} ms: ${parts}`);
  }
  await page.context().close();
  return [['longest task with horse.obj, ms', tasks[0].milliseconds]];
}

/** The draw calls and triangles of a frame with a model of 200 thousand triangles. */
async function frame(site) {
  const { page } = await openPage(site, { hash: '#model=gear&vertices=500' });
  await settled(page);
  await drop(page, { 'large.obj': objText(torus(400, 250)) });
  await page.waitForFunction(() =>
    document.getElementById('original-count').textContent === '100,000');
  await page.click('#cancel');
  await page.waitForFunction(() =>
    Number(document.getElementById('canvas').dataset.triangles) > 100_000);
  const { calls, triangles } = await page.evaluate(() =>
    ({ ...document.getElementById('canvas').dataset }));
  await page.context().close();
  return [['draw calls, 200000 triangles', Number(calls)],
    ['triangles a frame, lines included', Number(triangles)]];
}

/** @param {Record<string, number>} limits by the beginning of a row's name */
export async function runPage(limits, { folder = '', runs }) {
  const site = await startSite();
  try {
    const arrivals = [];
    for (let i = 0; i < runs; i += 1) arrivals.push(await arrival(site));
    const least = (name) => Math.min(...arrivals.map((times) => times[name]));
    const rows = [['first picture, ms', least('picture')], ['sample remeshed, ms', least('sample')],
      ...await drafts(site, runs), ...await blocking(site, folder), ...await frame(site)];
    const limitOf = (name) => limits[Object.keys(limits).find((start) => name.startsWith(start))];
    return {
      table: markdownTable(['page', 'value', 'at most'],
        rows.map(([name, value]) => [name, fixed(value, 0), limitOf(name)])),
      broken: rows.filter(([name, value]) => value > limitOf(name))
        .map(([name, value]) => `${name}: ${value.toFixed(0)} > ${limitOf(name)}`),
    };
  } finally {
    await site.close();
  }
}
