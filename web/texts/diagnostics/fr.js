// SPDX-License-Identifier: MIT
// French: warnings, errors, and why a result is the mesh that it is.

export default {
  'chosen.rounds': 'La méthode `rounds` était demandée.',
  'chosen.isotropic-asked': 'Des triangles réguliers étaient demandés.',
  'chosen.vertices-placed': 'La simplification ne respecte pas tout ce que les réglages '
    + 'demandent, comme une borne, des longueurs d’arêtes, une densité ou une réparation.',
  'chosen.shape-conforming': 'La forme est préférée : chaque facette a été maillée dans son plan.',
  'chosen.shape-refined': 'La forme est préférée, avec plus de sommets que l’original : des '
    + 'triangles réguliers qui ne s’en écartent visiblement nulle part.',
  'chosen.shape-asked': 'La forme est préférée.',
  'chosen.corners-exceed-number': 'Il y a trop peu de sommets pour les coins de toutes les '
    + 'lignes.',
  'chosen.facets-unrolled': 'Les facettes étroites des parois rondes et des congés n’auraient eu '
    + 'de place que pour des triangles pointus : déroulées, elles ont été maillées ensemble, et '
    + 'l’écart s’y voit à peine.',
  'chosen.facets-conforming': 'Chaque facette a été maillée dans son plan, la forme est donc '
    + 'exactement celle de l’original ; d’autres triangles réguliers la changeraient ou '
    + 'manqueraient le nombre de sommets.',
  'chosen.isotropic-instead': 'Les facettes auraient des triangles irréguliers ; des triangles '
    + 'réguliers gardent les arêtes vives et le volume, et s’en écartent à peine visiblement.',
  'chosen.isotropic-far-unfinished': 'Des triangles réguliers changeraient la forme bien plus '
    + 'que la simplification.',
  'chosen.number-missed': 'Les triangles réguliers n’ont pas atteint le nombre de sommets ; la '
    + 'simplification, si.',
  'chosen.simplified-nearer': 'Des triangles réguliers changeraient visiblement la forme ; la '
    + 'simplification reste bien plus proche.',
  'chosen.flat-sides-refined': 'De simples triangles réguliers bosselleraient les faces planes '
    + ': ceux-ci ne s’en écartent visiblement nulle part.',
  'chosen.isotropic-near-unfinished': 'Les triangles réguliers ne s’écartent pas visiblement en '
    + 'moyenne.',
  'chosen.isotropic-near': 'Les triangles réguliers ne s’écartent pas visiblement en moyenne.',
  'chosen.resampled': 'Avec plus de sommets que l’original, des triangles réguliers remplacent '
    + 'les siens et s’écartent visiblement de ses facettes. « prefer: shape » ou le nombre de '
    + 'l’original conserve ses triangles.',
  'chosen.isotropic': 'Aucune simplification n’est assez proche pour valoir ses triangles '
    + 'irréguliers.',
  'chosen.quads-mirrored': 'Des quads étaient demandés, et des plans reflètent '
    + 'l’original : ceux d’un côté ont été reflétés.',
  'chosen.quads-paired': 'Des quads étaient demandés ; sans carte de carrés, ce sont '
    + 'des paires de triangles.',
  'chosen.quads': 'Des quads étaient demandés.',
  'chosen.own-triangles': 'Les sommets dont la forme a besoin tiennent la limite ; des '
    + 'triangles réguliers en demanderaient plus que n’en a l’original.',
  'chosen.more-vertices': 'Aucun nombre de sommets n’était donné : à peu près le plus petit avec '
    + 'lequel des triangles réguliers ne changent pas visiblement la forme.',
  'chosen.own-number': 'Aucun nombre de sommets n’était donné, et des triangles réguliers qui ne '
    + 'changent pas visiblement la forme en demanderaient trop : l’original garde son nombre et '
    + 'sa forme.',
  'chosen.corners-kept': 'Si peu de sommets bosselleraient visiblement la pièce : il y en a autant '
    + 'que ses coins en demandent.',
  'chosen.unlimited-keeps': 'Le maillage des facettes respecte déjà les limites de lui-même.',
  'chosen.facets-keep': 'Le maillage des facettes respecte les limites, avec autant de sommets '
    + 'qu’il le faut.',
  'chosen.limits-dent': 'Des triangles dans les limites bosselleraient visiblement la pièce : le '
    + 'maillage de ses facettes en garde la forme, mais pas toutes les limites.',
  'chosen.angle-kept-anyway': 'Le maillage fait sans tenir compte du plus petit angle le respecte.',
  'chosen.vertices-for-angle': 'Il y a autant de sommets que le plus petit angle en demande, ou '
    + 'que ce qui s’en approche le plus.',
  'chosen.simplified-unsound': 'Simplifiée, la surface réparée se couperait elle-même.',
  'chosen.uncrossed': 'Les triangles réguliers se coupaient et ont été refaits sans cela.',
  'chosen.uncrossed-simplified': 'Les triangles réguliers se coupent ; les simplifiés, non.',
  'chosen.only-repaired': 'Arrondie aux chiffres écrits, la nouvelle surface ne serait pas '
    + 'saine : la surface réparée est écrite.',
  'chosen.budget-simplified': 'Les triangles isotropes dépasseraient le budget ; les simplifiés '
    + 'le respectent, ou s’en approchent plus.',
  'chosen.no-surface': 'Aucun triangle n’a d’aire : le maillage reste tel qu’il est venu.',
  'chosen.kept': 'Il n’y avait rien à réparer : chaque sommet et chaque triangle reste tel '
    + 'quel.',
  'chosen.repaired': 'La réparation a changé la surface.',
  'warning.ANGLES_TOO_SMALL': 'Des triangles ont des angles plus petits que voulu, surtout là où '
    + 'des arêtes vives ou des bords sont proches.',
  'warning.ANGLES_WORSE': 'Des triangles sont moins bons que ceux de l’original. Plus de points '
    + 'aident là où des parties sont plus minces que les arêtes ne sont longues.',
  'warning.ATTRIBUTE_HAS_NO_CHARTS': 'Un attribut saute à presque chaque arête ; il est repris du '
    + 'coin le plus proche.',
  'warning.ATTRIBUTE_NOT_CARRIED': 'Certaines valeurs ne sont pas reprises.',
  'warning.BACK_TO_BACK_TRIANGLES_REMOVED': 'Des triangles dos à dos, qui n’enferment rien, '
    + 'ont été retirés.',
  'warning.COUNT_CONTRADICTS': 'Le fichier annonce un autre nombre de facettes que n’en donnent '
    + 'ses octets ; ce sont eux qui comptent.',
  'warning.CROSSINGS_LEFT': 'Des triangles en coupent d’autres.',
  'warning.DEGENERATE_TRIANGLES_MADE': 'Des triangles du résultat n’ont pas d’aire : des parties '
    + 'sont trop minces pour ses nombres.',
  'warning.DEGENERATE_TRIANGLES_REMOVED': 'Des triangles sans trois coins distincts ont été '
    + 'retirés.',
  'warning.DUPLICATE_TRIANGLES_REMOVED': 'Des triangles en double ont été retirés.',
  'warning.HOLES_LEFT_OPEN': 'Des trous plus longs que demandé sont restés ouverts.',
  'warning.EDGES_TOO_LONG': 'Des arêtes sont plus longues que voulu.',
  'warning.EDGES_TOO_SHORT': 'Des arêtes sont plus courtes que voulu, surtout là où des arêtes '
    + 'vives ou des coins sont proches.',
  'warning.ELEMENTS_LEFT_OUT': 'Les éléments qui ne sont ni triangles ni quads manquent.',
  'warning.EXTENSION_NOT_CARRIED': 'Ce que des extensions disent de ce qui est refait disparaît.',
  'warning.HIDDEN_LEFT_OUT': 'Ce que la scène ne montre pas manque ; un .glb ou .gltf le garde.',
  'warning.IMAGES_NOT_FITTING': 'Les images des matériaux sont laissées de côté : elles ne '
    + 'correspondent pas aux nouvelles coordonnées de texture.',
  'warning.INCONSISTENT_ORIENTATION_FIXED': 'Des triangles ont été retournés pour regarder du '
    + 'même côté que la plupart de leurs voisins.',
  'warning.INSTANCES_NOT_CONFORMED': 'Des maillages montrés à plusieurs endroits ne partagent pas '
    + 'de faces avec d’autres. Donnez à chaque endroit son propre maillage.',
  'warning.ISOTROPIC_TAKES_MORE': 'La forme et le nombre de sommets restent, avec des triangles '
    + 'irréguliers : des triangles réguliers demandent bien plus de sommets. Demandez-en plus.',
  'warning.JOINT_NOT_IN_SKIN': 'Des points étaient liés à des articulations que leur squelette n’a '
    + 'pas ; elles disparaissent.',
  'warning.JOINTS_RELEASED': 'Des arêtes où la surface a été séparée ne se rejoignent peut-être '
    + 'plus.',
  'warning.LEVELS_REPLACED': 'Les niveaux de détail qu’avait le fichier font place à ceux '
    + 'demandés.',
  'warning.LEVEL_FARTHER_THAN_ASKED': 'Un niveau de détail s’écarte de plus de pixels que demandé '
    + ': le niveau précédent n’a pas plus de sommets.',
  'warning.LEVEL_NOT_COARSER': 'Un niveau de détail n’a pas moins de triangles que les précédents '
    + 'et n’est pas dans le fichier.',
  'warning.MAP_NOT_PAINTED': 'Une texture ou des variantes de matériaux ne peuvent pas être '
    + 'repeintes et sont perdues.',
  'warning.MATERIAL_IMAGES_NOT_READ': 'Les matériaux nomment des images qui ne sont ni lues ni '
    + 'transmises.',
  'warning.MATERIALS_BY_NAME': 'Les matériaux ne gardent que leurs noms.',
  'warning.MAX_ERROR_EXCEEDED': 'Le résultat s’écarte plus que demandé : la limite vaut pour la '
    + 'surface réparée.',
  'warning.MORE_VERTICES_TAKEN': 'Aucun nombre n’était demandé : c’est à peu près le moins de '
    + 'sommets pour des triangles réguliers sans écart visible.',
  'warning.NAME_CONTRADICTS': 'Le fichier n’est pas ce que dit son nom ; il est lu comme ce qu’il '
    + 'est.',
  'warning.NEEDS_THINNING': 'La mémoire ne suffit pas au modèle tel qu’il est ; pour peu de '
    + 'sommets, il est d’abord éclairci.',
  'warning.NON_FINITE_ATTRIBUTE': 'Les valeurs infinies ou qui ne sont pas des nombres comptent '
    + 'pour 0.',
  'warning.NON_MANIFOLD_EDGES_LEFT': 'Des corps se touchent le long d’arêtes de plus de deux '
    + 'triangles, qui sont restées telles quelles.',
  'warning.NON_MANIFOLD_EDGES_MADE': 'Des parties posées l’une sur l’autre partagent des arêtes du '
    + 'résultat.',
  'warning.NON_MANIFOLD_EDGES_SPLIT': 'Des arêtes de plus de deux triangles ont été séparées.',
  'warning.NON_MANIFOLD_VERTICES_LEFT': 'Des corps se touchent en des points isolés, qui sont '
    + 'restés tels quels.',
  'warning.NON_MANIFOLD_VERTICES_SPLIT': 'Des points où la surface se touche elle-même ont été '
    + 'séparés.',
  'warning.NON_ORIENTABLE_CUT': 'La surface n’a qu’un côté : à ces arêtes des triangles regardent '
    + 'des côtés opposés.',
  'warning.NOTHING_TO_REMESH': 'Il n’y a pas de triangles : le fichier est transmis tel quel.',
  'warning.NOT_TRIANGLES': 'Seules les faces sont lues ; le reste est laissé de côté.',
  'warning.ONLY_REPAIRED': 'Des parties de la surface réparée sont trop proches pour leurs '
    + 'nombres et ne sont pas remaillées.',
  'warning.PARTS_MERGED': 'Ce fichier est un seul solide : parties et matériaux y sont fondus.',
  'warning.RESOURCE_NOT_GIVEN': 'Un fichier auquel le modèle renvoie n’a pas été donné.',
  'warning.SCRAPS_REMOVED': 'Des triangles ont été retirés : ceux de petites composantes ouvertes, '
    + 'ceux qui, près d’un trou, ne touchent la surface qu’en un point, et les doubles.',
  'warning.FAULTS_NOT_SOUGHT': 'Les défauts ne sont pas cherchés et rien ne peut être réparé : la '
    + 'mémoire n’y suffit pas.',
  'warning.GUIDES_FAR_AWAY': 'Des lignes guides sont à plus de 1 % de la diagonale de la '
    + 'surface : les quads suivent les points les plus proches sur elle.',
  'warning.GUIDES_MIRRORED': 'Les quads sont symétriques, et les lignes guides avec eux.',
  'warning.GUIDES_NOT_KEPT': 'Des lignes guides ne sont devenues des côtés de quads '
    + 'qu’en partie : elles sont trop près d’autres courbes, ou trop courtes pour des '
    + 'quads de cette taille.',
  'warning.HIDDEN_BODIES_REMOVED': 'Des corps situés dans d’autres, que l’on ne voit pas, ont été '
    + 'retirés.',
  'warning.CAVITIES_FILLED': 'Des cavités invisibles de l’extérieur ont été remplies.',
  'warning.SHAPE_NOT_PREFERRED': 'Des sommets là où la forme les réclame feraient se couper la '
    + 'surface réparée : ses triangles sont réguliers à la place.',
  'warning.SHAPE_TAKES_MORE': 'Avec si peu de sommets, l’angle ou la longueur voulus, la forme '
    + 's’écarte visiblement. Demandez plus de sommets, ou un angle plus petit.',
  'warning.SHEETS_LEFT': 'Des feuilles (cartes, tissu, terrain) n’enferment rien et sont restées '
    + 'telles quelles ; « envelopper » en fait des solides minces.',
  'warning.PASSED_ON': 'Des maillages sans aire ont été transmis tels quels.',
  'warning.SELF_INTERSECTIONS_MADE': 'Des triangles du résultat en coupent d’autres là où '
    + 'l’original ne se coupe pas.',
  'warning.SHAPE_LOST_TO_ROUNDING': 'Le modèle est plus petit que l’arrondi des nombres si loin '
    + 'de l’origine. Déplacez-le d’abord à l’origine.',
  'warning.POLYGONS_CUT': 'Des polygones ont été coupés en triangles : seuls les maillages tout '
    + 'en quads gardent les leurs.',
  'warning.QUADS_MADE_SYMMETRIC': 'Les quads sont symétriques : le côté qui a le plus de '
    + 'surface fait foi.',
  'warning.QUADS_NUMBER_MISSED': 'Le nombre de points est manqué : un nombre plus proche '
    + 'coûterait des '
    + 'points irréguliers ou n’était pas possible.',
  'warning.QUADS_OFF_BORDER': 'Le bord des quads n’est pas partout sur celui qui a été '
    + 'donné.',
  'warning.QUADS_PAIRED': 'Pour des parties, aucune carte vers des carrés n’a été trouvée : leurs '
    + 'quads sont des paires de triangles divisées.',
  'warning.QUADS_SYMMETRY_LOST': 'Le modèle a des plans de symétrie, mais les quads ne les '
    + 'ont pas tous.',
  'warning.QUADS_TOO_FEW': 'Une partie de la forme est perdue : demandez plus de quads.',
  'warning.QUADS_TURNED_AWAY': 'Des quads sont à l’envers sur la surface.',
  'warning.ROUNDED_FAR_FROM_ORIGIN': 'Si loin de l’origine, ce format n’a que des coordonnées '
    + 'grossières : écrivez .ply ou .obj, ou déplacez d’abord le modèle vers elle.',
  'warning.SPIKES_LEFT_COARSE': 'Des points qui dépassent de loin tiennent par des aiguilles ; '
    + 'celles-ci reçoivent peu de points.',
  'warning.SURFACE_OPENED': 'Le résultat a des arêtes ouvertes, alors que l’original était fermé.',
  'warning.THINNED_OUT': 'Le modèle est bien plus fin que le résultat : il a d’abord été '
    + 'éclairci. Les distances sont mesurées en des sommets de l’original.',
  'warning.TOO_FEW_VERTICES': 'Si peu de sommets ne suffisent pas à une surface de tant de '
    + 'morceaux, d’anses, de trous ou de courbes : il y en a davantage.',
  'warning.TRIANGLES_NOT_JOINED': 'Aucun triangle ne partage une arête avec un autre : chacun est '
    + 'une surface à lui seul. « Souder » réunit ce qui est proche.',
  'warning.VERTICES_COINCIDE': 'Des points du résultat se confondent : des parties sont plus '
    + 'proches que les nombres du fichier ne peuvent le dire.',
  'fault.INTERNAL': 'C’est notre faute, pas la vôtre.',
  'fault.CANCELLED': 'Annulé.',
  'fault.OUT_OF_MEMORY': 'La mémoire ne suffit pas. Moins de points ou un modèle plus petit '
    + 'aident ; le dernier résultat est toujours là.',
  'fault.INVALID_OPTION': 'Ce réglage ne va pas ainsi.',
  'fault.UNKNOWN_OPTION': 'Ce réglage n’existe pas.',
  'fault.UNKNOWN_FORMAT': 'La page ne connaît pas ce format.',
  'fault.EMPTY_FILE': 'Le fichier est vide.',
  'fault.PARSE_ERROR': 'Le fichier est abîmé, ou n’est pas ce que dit son nom.',
  'fault.MISSING_RESOURCE': 'Un fichier auquel le modèle renvoie manque : déposez-le avec lui.',
  'fault.UNSUPPORTED': 'La page ne peut pas cela avec ce modèle.',
  'fault.INVALID_MESH': 'Les données ne forment pas de maillage.',
  'fault.INDEX_OUT_OF_RANGE': 'Un triangle nomme un point qui n’existe pas.',
  'fault.NON_FINITE': 'Une coordonnée n’est pas un nombre fini.',
  'fault.NO_TRIANGLES': 'Le modèle n’a pas de triangles.',
  'fault.TARGET_TOO_SMALL': 'Si peu de points ne suffisent pas à cette surface.',
  'fault.TARGET_BELOW_CURVES': 'Si peu de points ne suffisent pas aux arêtes et coutures gardées.',
  'fault.INPUT_UNREADABLE': 'Le fichier ne s’ouvre pas.',
  'fault.OUTPUT_UNWRITABLE': 'Le résultat ne s’écrit pas.',
  'warning.TOO_FEW_FACES': 'Si peu de faces ne suffisent pas à cette surface : le résultat en a '
    + 'plus.',
  'warning.RIMS_CLOSED': 'Des boucles qui semblent voulues ont été fermées ; « garder les '
    + 'bords » les '
    + 'laisse ouvertes.',
  'warning.RIMS_LEFT_OPEN': 'Des boucles qui semblent voulues sont restées ouvertes.',
  'warning.REMADE_IN_PART': 'Des corps sans extérieur exact ont été refaits par une grille. Tous '
    + 'les autres triangles sont inchangés, ou réparés exactement.',
  'warning.RIMS_NOT_KEPT': 'Une grille a refait la surface, et ne laisse aucune boucle ouverte.',
  'warning.SHEETS_MADE_BODIES': 'Des feuilles sont devenues des corps fermés.',
  'warning.SHEETS_NOT_MADE_BODIES': 'Les feuilles ne sont pas devenues les corps demandés : leurs '
    + 'côtés se coupent sans pouvoir être séparés exactement.',
  'warning.BASE_NOT_MADE': 'Des feuilles dont le contour se replie n’ont pas reçu de socle.',
  'warning.PIECES_DROPPED': 'De petites pièces ont été omises, comme demandé.',
  'warning.HIDDEN_DROPPED': 'Des triangles que personne ne voit ont été omis, comme demandé.',
  'warning.SEEN_PARTS_LOST': 'Des parties visibles de l’extérieur manquent au résultat : elles '
    + 'sont plus minces que sa finesse, ou dans des passages qu’il ferme.',
  'warning.SHEETS_THICKENED': 'Des feuilles, qui n’enferment rien, sont devenues des solides '
    + 'minces derrière ce que l’on en voit.',
  'warning.TEXCOORDS_REPLACED': 'Les coordonnées de texture du modèle se recouvrent ou passent le '
    + 'bord du carré : il en a reçu de nouvelles.',
  'warning.TEXELS_NOT_FOUND': 'Pour une partie des texels, aucune surface n’a été trouvée : ils '
    + 'prennent les couleurs voisines.',
  'warning.TEXTURES_PAINTED': 'La réparation a fait une autre surface, ses textures ont donc été '
    + 'repeintes.',
  'warning.PLACES_JOINED': 'Des sommets ne diffèrent d’autres que par l’arrondi ; un lecteur '
    + 'exact y trouve des fentes. La réparation les met au même endroit.',
  'warning.PARTS_MEET': 'Des triangles de parties en rencontrent d’autres : la réparation '
    + 'traite chaque partie pour elle-même, pour garder son nom et sa place. Dans un fichier '
    + 'STL toutes font une seule surface.',
  'warning.ONE_SIDED': 'La surface n’a qu’un côté, comme un ruban de Möbius : elle n’a pas de '
    + 'dehors, et à ces arêtes des triangles regardent des côtés opposés. La réparation la laisse '
    + 'telle quelle.',
  'warning.SHEETS_DROPPED': 'Des feuilles, qui n’enferment rien, ont été omises.',
  'warning.BODIES_ALMOST_TOUCH': 'Des corps se touchent presque : leurs faces sont un peu '
    + 'écartées, et le restent.',
  'warning.BODIES_OVERLAP': 'Des corps se recouvrent : des triangles de l’un coupent ceux de '
    + 'l’autre.',
  'warning.COMMON_FACES_LEFT': 'Des faces qui se touchent ont été remaillées à part : elles ne '
    + 'sont pas dans un plan, ou leurs bords se croisent.',
  'warning.NO_BODIES_TOUCH': 'Aucun corps fermé n’en touche un autre par une face.',
  'warning.TEXCOORDS_LEFT_OUT': 'Les corps aux faces communes ont été remaillés sans coordonnées '
    + 'de texture.',
};
