// SPDX-License-Identifier: MIT
// The way of most visitors, in small windows and on a phone.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { overlappingBoxes } from '../../support/broken_shapes.js';
import { drop, openPage, opened, settled, visit } from '../../support/browser_page.js';
import { choose, eachPurpose } from '../../support/doors.js';
import { stl } from '../../support/shapes.js';

const { site, page, complaints } = await visit({ hash: '#model=gear&vertices=300', isFirst: true,
  unseen: true, viewport: { width: 1440, height: 900 } });

for (const [screen, size] of Object.entries({ small: [1024, 768], phone: [390, 844] })) {
  test(`each purpose, from the door to the file: ${screen}`, () => eachPurpose(page, size));
}

test('on a phone purposes and verdict are in view without scrolling', async () => {
  await page.setViewportSize({ width: 390, height: 844 });
  const name = 'a long name of a part with faults.stl';
  await drop(page, { [name]: stl(overlappingBoxes()) });
  await opened(page, name);
  await page.waitForSelector('#landmark-selfIntersections');
  await choose(page, 'print');
  await page.evaluate(() => scrollTo(0, 0));
  const top = (await page.locator('#download-bar').boundingBox()).y;
  const { y, height } = await page.locator('#purpose-quads').boundingBox();
  assert.ok(y + height <= top, `${y + height} of ${top}`);
  assert.equal(await page.textContent('#verdict-short'), 'Closed · shape exact · 28 triangles');
  assert.ok(await page.isVisible('#verdict-short'));
  const others = await page.locator('#other-formats').boundingBox();
  assert.ok(others.width >= 44 && others.height >= 44, 'a finger finds it');
});

test('what a finger presses is large enough, upright and across', async () => {
  const { page: phone } = await openPage(site, { hash: '#model=gear&vertices=300', unseen: true,
    isKept: false, isFirst: true, hasTouch: true, isMobile: true,
    viewport: { width: 844, height: 390 } });
  await settled(phone);
  await phone.click('#purpose-quads');
  await settled(phone);
  for (const [width, height] of [[844, 390], [390, 844]]) {
    await phone.setViewportSize({ width, height });
    const small = await phone.locator('button, select, summary, input:not([type=radio], '
      + '[type=checkbox])').evaluateAll((nodes) => nodes.filter((node) => node.checkVisibility()
      && node.id !== 'divider').map((node) => [node.id || node.textContent.trim(),
      node.getBoundingClientRect()]).filter(([, box]) => box.width && box.height < 43.5)
      .map(([name, { height: own }]) => `${name} ${own}`));
    assert.deepEqual(small, [], `${width} × ${height}`);
  }
  await phone.context().close();
});

test('nothing is complained of', () => assert.deepEqual(complaints, []));
