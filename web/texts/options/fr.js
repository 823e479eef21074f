// SPDX-License-Identifier: MIT
// French: the options' names, units and help.

export default {
  'option.vertices': 'Sommets',
  'option.faces': 'Triangles',
  'option.ratio': 'Part',
  'option.edgeLength': 'Longueur d’arête',
  'option.minEdge': 'Arête minimale',
  'option.maxEdge': 'Arête maximale',
  'option.minAngle': 'Angle minimal',
  'option.scheme': 'Méthode',
  'option.quality': 'Qualité',
  'option.prefer': 'Préférence',
  'option.projection': 'Projection',
  'option.fidelity': 'Fidélité',
  'option.vertexAngle': 'Angle des sommets',
  'option.triangleAngle': 'Angle des triangles',
  'option.splitObtuse': 'Couper les obtus',
  'option.adaptivity': 'Adaptation',
  'option.gradation': 'Gradation',
  'option.featureAngle': 'Angle des arêtes vives',
  'option.boundary': 'Bord',
  'option.maxError': 'Erreur maximale',
  'option.weld': 'Souder',
  'option.quads': 'Quads',
  'option.exact': 'Nombre exact',
  'option.symmetry': 'Symétrie',
  'help.vertices': 'nombre exact de sommets du résultat ; sinon celui de l’original, ou jusqu’à '
    + 'quatre fois autant où des triangles réguliers le demandent',
  'help.faces': 'au plus tant de triangles, ou de quads avec --quads, aussi '
    + 'près que la surface le permet',
  'help.ratio': 'le nombre de sommets comme part de ceux de l’original',
  'help.edgeLength': 'le nombre de sommets d’après une longueur moyenne d’arête',
  'help.minEdge': 'aucune arête ne doit être plus courte ; là où cela ne se peut pas, le rapport '
    + 'dit combien le sont et où. Sans nombre de sommets, pas plus que cela ne permet',
  'help.maxEdge': 'aucune arête ne doit être plus longue, de même. Sans nombre de sommets, aussi '
    + 'peu que cela permet',
  'help.minAngle': 'aucun angle d’un triangle ne doit être plus petit, de même',
  'help.scheme': 'rounds : la méthode publiée, pas à pas ; best : la nôtre',
  'help.quality': 'draft : en une fraction du temps, presque aussi bon, distances peu mesurées',
  'help.prefer': 'even : des triangles réguliers ; shape : les sommets de l’original dont la '
    + 'forme et l’aspect ont le plus besoin ; auto : réguliers là où ils gardent les deux, '
    + 'sinon shape',
  'help.projection': 'patches : sur l’original, par des disques qui se recouvrent ou, avec best '
    + 'dès 8000 points, en allant au plus proche ; current : sur le maillage actuel',
  'help.fidelity': 'un pas est refusé si une paire de normales dépasse les angles ci-dessous '
    + '(strict), si toutes les dépassent (loose), ou seulement là où un triangle se retournerait '
    + '(fold)',
  'help.vertexAngle': 'entre les normales aux sommets d’un triangle',
  'help.triangleAngle': 'entre la normale d’un triangle et celles de ses sommets',
  'help.splitObtuse': 'au but, chaque arête face à un angle obtus est coupée une fois',
  'help.adaptivity': '0 : triangles réguliers ; 1 : les tailles suivent la courbure, pour la '
    + 'moindre erreur ; entre les deux : un mélange',
  'help.gradation': 'plus grand rapport des tailles aux deux bouts d’une arête',
  'help.featureAngle': 'angle entre faces à partir duquel une arête peut appartenir à une courbe '
    + 'qui est conservée',
  'help.boundary': 'déplacer les sommets le long des bords ouverts, ou les garder tels quels',
  'help.maxError': 'refuse ce qui s’écarterait davantage de l’original',
  'help.weld': 'réunit les sommets plus proches des arêtes ouvertes ; sinon ce qui ne diffère que '
    + 'par l’arrondi',
  'help.quads': 'seulement des quads, suivant arêtes et courbure ; points à 1 % près',
  'help.exact': 'des quads : exactement ce nombre de sommets',
  'help.symmetry': 'des quads : auto : exactement symétriques, si le modèle l’est par un '
    + 'plan ; x, xy … : symétriques par des plans perpendiculaires à ces axes, quel que soit le '
    + 'modèle',
  'unit.degrees': 'degrés',
  'unit.model units': 'unités du modèle',
  'unit.% of the diagonal': '% de la diagonale',
  'option.repair': 'Réparation',
  'option.holesUpTo': 'Trous jusqu’à',
  'option.gap': 'Ouverture',
  'help.repair': 'réparer d’abord la surface. holes : fermer les boucles ouvertes, laisser le '
    + 'reste ; solid : l’extérieur de ce qui enferme quelque chose ; wrap : ce que l’on atteint de '
    + 'l’extérieur par des passages plus larges que l’ouverture ; auto : le premier qui convient',
  'help.gap': 'wrap ferme les passages jusqu’à cette largeur ; 2 sans indication',
  'help.holesUpTo': 'les boucles plus longues restent ouvertes ; sans indication, toutes sont '
    + 'fermées',
  'option.textures': 'Textures',
  'option.textureSize': 'Taille des textures',
  'option.textureFormat': 'Format des textures',
  'help.textures': 'keep : les coordonnées de texture, le long de leurs coutures ; drop : '
    + 'les omettre ; bake (en '
    + 'glTF) : de nouvelles textures, peintes d’après les anciennes, si bien que les coutures ne '
    + 'coûtent aucun point',
  'help.textureSize': 'des nouvelles textures, d’un côté ; sans indication aussi fine que celle de '
    + 'l’original, jusqu’à 4096',
  'help.textureFormat': 'des nouvelles textures ; sans indication comme elles sont venues : webp '
    + 'si toutes étaient en WebP, sinon jpeg, mais png pour la transparence et les normales non '
    + 'JPEG',
  'unit.texels': 'texels',
  'option.cavities': 'Garder les cavités',
  'option.sheets': 'Feuilles',
  'help.cavities': 'solid garde les cavités intérieures : des pièces fermées tournées vers ce '
    + 'qu’elles enferment',
  'help.sheets': 'des feuilles, qui n’enferment rien, wrap fait des solides minces derrière ce '
    + 'que l’on en voit, ou les omet',
  'option.keepRims': 'Garder les bords',
  'option.thickness': 'Épaisseur',
  'option.base': 'Socle',
  'option.unite': 'Réunir',
  'option.dropBelow': 'Omettre le petit',
  'option.dropHidden': 'Omettre le caché',
  'option.conform': 'Faces communes',
  'help.keepRims': 'les boucles qui semblent voulues restent ouvertes : les rondes, et les '
    + 'droites où '
    + 'finissent des parois ; '
    + 'avec holes, les petits morceaux ouverts restent aussi',
  'help.thickness': 'les feuilles deviennent des corps de cette épaisseur, une moitié de '
    + 'chaque côté',
  'help.base': 'un relief ouvert, comme un terrain, reçoit des parois verticales et un fond plat, '
    + 'situé à cette épaisseur sous son point le plus bas',
  'help.unite': 'les maillages d’un fichier deviennent une seule surface, avec leurs matériaux',
  'help.dropBelow': 'omettre les pièces plus petites ; auto : ce qui est petit et flotte à l’écart',
  'help.dropHidden': 'omettre les triangles que personne ne voit de l’extérieur ; les autres '
    + 'restent '
    + 'tels quels',
  'help.conform': 'les corps fermés qui se touchent par des faces y ont les mêmes triangles, pour '
    + 'qu’un solveur les joigne ; les sommets d’une face commune comptent une fois',
  'choice.sheets.thicken': 'en faire des solides minces',
  'choice.sheets.drop': 'les omettre',
  'landmark.selfIntersections': '{count} triangles en coupent d’autres',
  'landmark.innerShells': '1 coque intérieure|{count} coques intérieures',
  'landmark.insideOut': '1 corps à l’envers|{count} corps à l’envers',
  'mend.needs': ' (environ {seconds} s, {size})',
  'repair.far': '{share} de la surface visible sont à plus de {distance} du résultat',
  'reason.sound': 'Sain : inchangé.',
  'reason.joined': 'Des endroits presque égaux ont été confondus.',
  'reason.closed': 'Ses bords fermés, la surface est saine.',
  'reason.united': 'Les corps qui se coupent ont été réunis exactement.',
  'repair.rims': '1 bord laissé ouvert|{count} bords laissés ouverts',
  'repair.bodies': '1 feuille devenue un corps fermé|{count} feuilles devenues des corps fermés',
  'reason.made': 'Les feuilles sont devenues des corps fermés.',
  'reason.sheets': 'Les feuilles sont restées telles quelles.',
  'reason.partly': 'Seul ce qui n’a pas d’extérieur exact a été refait par une grille.',
  'reason.enclosed': 'Refaite par une grille autour des corps.',
  'reason.open': 'Refaite par une grille.',
};
