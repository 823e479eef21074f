// SPDX-License-Identifier: MIT
// THE table of the report card's words: for the text of a card and for the page.

/** @typedef {import('./messages.js').CardLanguage} CardLanguage */
/** @typedef {typeof en} CardWords */

const en = {
  title: 'Report card', figure: 'Figure', before: 'Before', after: 'After',
  triangles: 'Triangles', quads: 'Quads', vertices: 'Vertices', pieces: 'Pieces',
  closed: 'Closed', yes: 'yes', no: 'no: {count} open edges',
  nonManifoldEdges: 'Non-manifold edges', selfIntersections: 'Self-intersecting triangles',
  hidden: 'Hidden triangles', coverage: 'Share of the texture in use',
  distance: 'Largest distance', ofDiagonal: '{share} of the diagonal', bytes: 'Size of the file',
};

/** @type {Record<CardLanguage, CardWords>} */
export const cardWords = {
  en,
  de: {
    title: 'Kurzbericht', figure: 'Angabe', before: 'Vorher', after: 'Nachher',
    triangles: 'Dreiecke', quads: 'Vierecke', vertices: 'Punkte', pieces: 'Teile',
    closed: 'Geschlossen', yes: 'ja', no: 'nein: {count} offene Kanten',
    nonManifoldEdges: 'Nicht-manifolde Kanten', selfIntersections: 'Dreiecke, die andere schneiden',
    hidden: 'Verdeckte Dreiecke', coverage: 'Genutzter Teil der Textur',
    distance: 'Größter Abstand', ofDiagonal: '{share} der Diagonale', bytes: 'Größe der Datei',
  },
  fr: {
    title: 'Bilan', figure: 'Donnée', before: 'Avant', after: 'Après',
    triangles: 'Triangles', quads: 'Quads', vertices: 'Sommets', pieces: 'Pièces',
    closed: 'Fermé', yes: 'oui', no: 'non : {count} arêtes de bord',
    nonManifoldEdges: 'Arêtes non manifold', selfIntersections: 'Triangles qui se croisent',
    hidden: 'Triangles cachés', coverage: 'Part de la texture utilisée',
    distance: 'Plus grande distance', ofDiagonal: '{share} de la diagonale',
    bytes: 'Taille du fichier',
  },
};
