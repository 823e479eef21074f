// SPDX-License-Identifier: MIT
// Draws the rooms of the core: a box for each room, above all rooms that it may use. A room has no
// line to a room that it also reaches through another.

const [boxWidth, boxHeight, gap, rise, margin] = [136, 26, 14, 62, 12];
const letter = 6.2;

/** How many floors are below each room. @param {Record<string, string[]>} rooms */
function floorsOf(rooms) {
  /** @type {Map<string, number>} */
  const floors = new Map();
  const floorOf = (/** @type {string} */ room) => {
    const known = floors.get(room);
    if (known !== undefined) return known;
    const floor = Math.max(-1, ...rooms[room].map(floorOf)) + 1;
    floors.set(room, floor);
    return floor;
  };
  Object.keys(rooms).forEach(floorOf);
  return floors;
}

/** The rooms that a room uses, except those that it also reaches through another.
 * @param {Record<string, string[]>} rooms */
function directly(rooms, /** @type {string} */ room) {
  const reached = new Set();
  const reach = (/** @type {string} */ other) => {
    for (const next of rooms[other]) {
      if (reached.has(next)) continue;
      reached.add(next);
      reach(next);
    }
  };
  rooms[room].forEach(reach);
  return rooms[room].filter((other) => !reached.has(other));
}

/**
 * Places the rooms floor by floor, each near the middle of the rooms that it uses.
 * @param {Record<string, string[]>} rooms
 */
function placesOf(rooms) {
  const floors = floorsOf(rooms);
  const top = Math.max(...floors.values());
  const rows = Array.from({ length: top + 1 }, (_, floor) =>
    Object.keys(rooms).filter((room) => floors.get(room) === floor));
  const widest = Math.max(...rows.map((row) => row.length));
  const width = widest * (boxWidth + gap) - gap + 2 * margin;
  /** @type {Map<string, { x: number, y: number }>} */
  const places = new Map();
  rows.forEach((row, floor) => {
    const wish = (/** @type {string} */ room) => {
      const below = directly(rooms, room).map((other) => places.get(other)?.x ?? 0);
      return below.reduce((sum, x) => sum + x, 0) / Math.max(1, below.length);
    };
    const left = (width - row.length * (boxWidth + gap) + gap) / 2;
    [...row].sort((a, b) => wish(a) - wish(b)).forEach((room, i) => places.set(room,
      { x: left + i * (boxWidth + gap) + boxWidth / 2, y: margin + (top - floor) * rise }));
  });
  return { places, width, height: top * rise + boxHeight + 2 * margin };
}

/**
 * @param {Record<string, string[]>} rooms each with the rooms that it may use; '' is the top
 * @param {string} top the name of the room ''
 */
export function roomsPicture(rooms, top) {
  const { places, width, height } = placesOf(rooms);
  const at = (/** @type {string} */ room) =>
    /** @type {{ x: number, y: number }} */ (places.get(room));
  const lines = Object.keys(rooms).flatMap((room) => directly(rooms, room).map((other) => {
    const [from, to] = [at(room), at(other)];
    const [start, end, bend] = [from.y + boxHeight, to.y, Math.round(rise / 3)];
    return `<path d="M${from.x} ${start}C${from.x} ${start + bend} `
      + `${to.x} ${end - bend} ${to.x} ${end}"/>`;
  }));
  const boxes = Object.keys(rooms).map((room) => {
    const name = room || top;
    const size = Math.min(12, 12 * (boxWidth - 8) / (letter * name.length));
    const { x, y } = at(room);
    return {
      box: `<rect x="${x - boxWidth / 2}" y="${y}" width="${boxWidth}" `
        + `height="${boxHeight}" rx="4"/>`,
      word: `<text x="${x}" y="${y + 17}" font-size="${size.toFixed(1)}">${name}</text>`,
    };
  });
  return [
    `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${width} ${height}" `
      + 'font-family="sans-serif">',
    '<title>The rooms of the core, each above those that it uses</title>',
    `<rect width="${width}" height="${height}" fill="#fff"/>`,
    '<g fill="none" stroke="#9aa7b4">', ...lines, '</g>',
    '<g fill="#eef3f8" stroke="#41566b">', ...boxes.map(({ box }) => box), '</g>',
    '<g fill="#16202a" text-anchor="middle">', ...boxes.map(({ word }) => word), '</g>',
    '</svg>', ''].join('\n');
}
