// SPDX-License-Identifier: MIT
// German: warnings, errors, and why a result is the mesh that it is.

export default {
  'chosen.rounds': 'Das Verfahren `rounds` war verlangt.',
  'chosen.isotropic-asked': 'Gleichmäßige Dreiecke waren verlangt.',
  'chosen.vertices-placed': 'Vereinfachen hält nicht alles ein, was die Einstellungen '
    + 'verlangen, etwa eine Schranke, Kantenlängen, Dichte oder Reparatur.',
  'chosen.shape-conforming': 'Die Form geht vor: Jede ebene Fläche wurde für sich vernetzt.',
  'chosen.shape-refined': 'Die Form geht vor, mit mehr Punkten als im Original: gleichmäßige '
    + 'Dreiecke, die nirgends sichtbar abweichen.',
  'chosen.shape-asked': 'Die Form geht vor.',
  'chosen.corners-exceed-number': 'Es sind zu wenige Punkte für die Ecken aller Linien.',
  'chosen.facets-unrolled': 'Die schmalen Flächen runder Wände und Rundungen hätten nur Platz für '
    + 'spitze Dreiecke: Sie wurden abgewickelt und gemeinsam vernetzt, und die Dreiecke dort '
    + 'weichen kaum sichtbar ab.',
  'chosen.facets-conforming': 'Jede ebene Fläche wurde für sich vernetzt, sodass die Form genau '
    + 'die des Originals ist; andere gleichmäßige Dreiecke würden sie ändern oder die Zahl der '
    + 'Punkte verfehlen.',
  'chosen.isotropic-instead': 'Die ebenen Flächen bekämen ungleichmäßige Dreiecke; gleichmäßige '
    + 'erhalten die scharfen Kanten und das Volumen und weichen kaum sichtbar ab.',
  'chosen.isotropic-far-unfinished': 'Gleichmäßige Dreiecke würden die Form viel stärker ändern '
    + 'als Vereinfachen.',
  'chosen.number-missed': 'Gleichmäßige Dreiecke erreichten die Zahl der Punkte nicht; '
    + 'Vereinfachen schon.',
  'chosen.simplified-nearer': 'Gleichmäßige Dreiecke würden die Form sichtbar ändern; '
    + 'Vereinfachen bleibt viel näher.',
  'chosen.flat-sides-refined': 'Einfache gleichmäßige Dreiecke würden ebene Seiten eindellen: '
    + 'diese weichen nirgends sichtbar ab.',
  'chosen.isotropic-near-unfinished': 'Gleichmäßige Dreiecke weichen im Mittel nicht sichtbar ab.',
  'chosen.isotropic-near': 'Gleichmäßige Dreiecke weichen im Mittel nicht sichtbar ab.',
  'chosen.resampled': 'Mit mehr Punkten, als das Original hat, ersetzen gleichmäßige Dreiecke '
    + 'seine eigenen und weichen sichtbar von seinen Facetten ab. „prefer: shape“ oder die Zahl '
    + 'des Originals erhält seine Dreiecke.',
  'chosen.isotropic': 'Keine Vereinfachung bleibt so viel näher, dass sie ungleichmäßige '
    + 'Dreiecke wert wäre.',
  'chosen.quads-mirrored': 'Vierecke waren verlangt, und Ebenen spiegeln das Original: die '
    + 'Vierecke einer Seite wurden gespiegelt.',
  'chosen.quads-paired': 'Vierecke waren verlangt; wo keine Karte aus Quadraten gelang, sind '
    + 'sie Paare von Dreiecken.',
  'chosen.quads': 'Vierecke waren verlangt.',
  'chosen.own-triangles': 'Die Punkte, die die Form braucht, halten die Grenze ein; '
    + 'gleichmäßige Dreiecke bräuchten mehr, als das Original hat.',
  'chosen.more-vertices': 'Keine Zahl von Punkten war gegeben: etwa die wenigsten, mit denen '
    + 'gleichmäßige Dreiecke die Form nicht sichtbar ändern.',
  'chosen.own-number': 'Keine Zahl von Punkten war gegeben, und gleichmäßige Dreiecke, die die '
    + 'Form nicht sichtbar ändern, bräuchten zu viele: Zahl und Form bleiben die des Originals.',
  'chosen.corners-kept': 'So wenige Punkte würden das Teil sichtbar eindellen: Es sind so viele, '
    + 'wie seine Ecken brauchen.',
  'chosen.unlimited-keeps': 'Das Netz der ebenen Flächen hält die Grenzen schon von sich aus ein.',
  'chosen.facets-keep': 'Das Netz der ebenen Flächen hält die Grenzen ein, mit so vielen Punkten, '
    + 'wie das braucht.',
  'chosen.limits-dent': 'Dreiecke in den Grenzen würden das Teil sichtbar eindellen: Das Netz '
    + 'seiner ebenen Flächen erhält die Form, aber nicht alle Grenzen.',
  'chosen.angle-kept-anyway': 'Das Netz, das ohne Rücksicht auf den kleinsten Winkel entsteht, '
    + 'hält ihn ein.',
  'chosen.vertices-for-angle': 'Es sind so viele Punkte, wie der kleinste Winkel braucht oder wie '
    + 'ihm am nächsten kommen.',
  'chosen.simplified-unsound': 'Vereinfachen würde die reparierte Fläche sich selbst schneiden '
    + 'lassen.',
  'chosen.uncrossed': 'Gleichmäßige Dreiecke schnitten einander und wurden ohne das noch einmal '
    + 'gemacht.',
  'chosen.uncrossed-simplified': 'Gleichmäßige Dreiecke schneiden einander; die vereinfachten '
    + 'nicht.',
  'chosen.only-repaired': 'Auf die geschriebenen Stellen gerundet, wäre die neue Fläche nicht '
    + 'heil: geschrieben ist die reparierte.',
  'chosen.budget-simplified': 'Gleichmäßige Dreiecke wären mehr als erlaubt; vereinfachte halten '
    + 'die Zahl ein oder kommen ihr näher.',
  'chosen.no-surface': 'Kein Dreieck hat eine Fläche: das Netz bleibt, wie es kam.',
  'chosen.kept': 'Nichts war zu reparieren: jeder Punkt und jedes Dreieck ist, wie es war.',
  'chosen.repaired': 'Die Reparatur hat die Fläche geändert.',
  'warning.ANGLES_TOO_SMALL': 'Manche Dreiecke haben kleinere Winkel als gewünscht, meist wo '
    + 'scharfe Kanten oder Ränder nah beieinander liegen.',
  'warning.ANGLES_WORSE': 'Manche Dreiecke sind schlechter als die des Originals. Mehr Punkte '
    + 'helfen, wo Teile dünner sind, als Kanten lang.',
  'warning.ATTRIBUTE_HAS_NO_CHARTS': 'Ein Attribut springt an fast jeder Kante; es wird von der '
    + 'nächsten Ecke übernommen.',
  'warning.ATTRIBUTE_NOT_CARRIED': 'Manche Werte werden nicht mitgenommen.',
  'warning.BACK_TO_BACK_TRIANGLES_REMOVED': 'Dreiecke Rücken an Rücken, die nichts umschließen, '
    + 'wurden entfernt.',
  'warning.COUNT_CONTRADICTS': 'Die Datei nennt eine andere Zahl von Facetten, als ihre Bytes '
    + 'ergeben; die Bytes gelten.',
  'warning.CROSSINGS_LEFT': 'Dreiecke schneiden andere.',
  'warning.DEGENERATE_TRIANGLES_MADE': 'Manche Dreiecke des Ergebnisses haben keine Fläche: Teile '
    + 'sind zu dünn für seine Zahlen.',
  'warning.DEGENERATE_TRIANGLES_REMOVED': 'Dreiecke ohne drei verschiedene Ecken wurden entfernt.',
  'warning.DUPLICATE_TRIANGLES_REMOVED': 'Doppelte Dreiecke wurden entfernt.',
  'warning.HOLES_LEFT_OPEN': 'Löcher, die länger sind als verlangt, blieben offen.',
  'warning.EDGES_TOO_LONG': 'Manche Kanten sind länger als gewünscht.',
  'warning.EDGES_TOO_SHORT': 'Manche Kanten sind kürzer als gewünscht, meist wo scharfe Kanten '
    + 'oder Ecken nah beieinander liegen.',
  'warning.ELEMENTS_LEFT_OUT': 'Elemente, die weder Dreiecke noch Vierecke sind, fehlen.',
  'warning.EXTENSION_NOT_CARRIED': 'Was Erweiterungen über Dreiecke, Punkte oder Texturen sagen, '
    + 'die neu gemacht sind, gilt nicht mehr und fällt weg.',
  'warning.HIDDEN_LEFT_OUT': 'Was die Szene nicht zeigt, fehlt; in .glb und .gltf bleibt es da.',
  'warning.IMAGES_NOT_FITTING': 'Die Bilder der Materialien entfallen: Sie passen nicht zu '
    + 'den neuen Texturkoordinaten.',
  'warning.INCONSISTENT_ORIENTATION_FIXED': 'Dreiecke wurden umgedreht, damit sie zur selben Seite '
    + 'weisen wie die meisten neben ihnen.',
  'warning.INSTANCES_NOT_CONFORMED': 'Netze, die an mehreren Orten gezeigt werden, teilen keine '
    + 'Flächen mit anderen. Geben Sie jedem Ort ein eigenes Netz.',
  'warning.ISOTROPIC_TAKES_MORE': 'Form und Zahl der Punkte bleiben, mit ungleichmäßigen '
    + 'Dreiecken: Gleichmäßige brauchen viel mehr Punkte. Verlangen Sie eine größere Zahl.',
  'warning.JOINT_NOT_IN_SKIN': 'Punkte hingen an Gelenken, die ihr Skelett nicht hat; diese fallen '
    + 'weg.',
  'warning.JOINTS_RELEASED': 'Kanten, an denen die Fläche zertrennt wurde, passen vielleicht nicht '
    + 'mehr aneinander.',
  'warning.LEVELS_REPLACED': 'Die gröberen Stufen, die die Datei hatte, weichen den verlangten.',
  'warning.LEVEL_FARTHER_THAN_ASKED': 'Eine Detailstufe weicht um mehr Bildpunkte ab als verlangt: '
    + 'Die Stufe vor ihr hat nicht mehr Punkte.',
  'warning.LEVEL_NOT_COARSER': 'Eine Detailstufe hat nicht weniger Dreiecke als die vor ihr und '
    + 'steht nicht in der Datei.',
  'warning.MAP_NOT_PAINTED': 'Eine Textur oder Varianten von Materialien können nicht neu gemalt '
    + 'werden und gehen verloren.',
  'warning.MATERIAL_IMAGES_NOT_READ': 'Die Materialien nennen Bilder, die nicht gelesen und nicht '
    + 'weitergegeben werden.',
  'warning.MATERIALS_BY_NAME': 'Die Materialien behalten nur ihre Namen.',
  'warning.MAX_ERROR_EXCEEDED': 'Das Ergebnis weicht weiter ab als verlangt: die Grenze gilt für '
    + 'die ausgebesserte Fläche.',
  'warning.MORE_VERTICES_TAKEN': 'Es war keine Zahl verlangt: So viele Punkte brauchen '
    + 'gleichmäßige Dreiecke, die nirgends sichtbar abweichen.',
  'warning.NAME_CONTRADICTS': 'Die Datei ist etwas anderes, als ihr Name sagt; sie wird als das '
    + 'gelesen, was sie ist.',
  'warning.NEEDS_THINNING': 'Für das Modell, wie es ist, reicht der Speicher nicht; für wenige '
    + 'Punkte wird es zuerst ausgedünnt.',
  'warning.NON_FINITE_ATTRIBUTE': 'Unendliche Werte und solche, die keine Zahlen sind, gelten '
    + 'als 0.',
  'warning.NON_MANIFOLD_EDGES_LEFT': 'Körper berühren sich an Kanten von mehr als zwei Dreiecken, '
    + 'die so geblieben sind.',
  'warning.NON_MANIFOLD_EDGES_MADE': 'Teile, die aufeinander liegen, teilen sich Kanten des '
    + 'Ergebnisses.',
  'warning.NON_MANIFOLD_EDGES_SPLIT': 'Kanten mit mehr als zwei Dreiecken wurden zertrennt.',
  'warning.NON_MANIFOLD_VERTICES_LEFT': 'Körper berühren sich in einzelnen Punkten, die so '
    + 'geblieben sind.',
  'warning.NON_MANIFOLD_VERTICES_SPLIT': 'Punkte, in denen die Fläche sich selbst berührt, wurden '
    + 'getrennt.',
  'warning.NON_ORIENTABLE_CUT': 'Die Fläche hat nur eine Seite: An diesen Kanten zeigen Dreiecke '
    + 'zu verschiedenen Seiten.',
  'warning.NOTHING_TO_REMESH': 'Es gibt keine Dreiecke: die Datei wird weitergegeben, wie sie ist.',
  'warning.NOT_TRIANGLES': 'Nur Flächen werden gelesen; anderes wird weggelassen.',
  'warning.ONLY_REPAIRED': 'Teile der ausgebesserten Fläche liegen für ihre Zahlen zu nah '
    + 'beieinander und sind nicht neu vernetzt.',
  'warning.PARTS_MERGED': 'Eine Datei dieses Formats ist ein einziger Körper: Teile und '
    + 'Materialien gehen darin auf.',
  'warning.PASSED_ON': 'Netze ohne Fläche wurden weitergegeben, wie sie sind.',
  'warning.POLYGONS_CUT': 'Vielecke wurden in Dreiecke geteilt: nur Netze, die ganz aus Vierecken '
    + 'bestehen, behalten sie.',
  'warning.QUADS_MADE_SYMMETRIC': 'Die Vierecke sind gespiegelt: die Seite mit mehr Fläche gilt.',
  'warning.QUADS_NUMBER_MISSED': 'Die Zahl der Punkte ist verfehlt: nähere Zahlen kosten '
    + 'unregelmäßige '
    + 'Punkte oder waren nicht möglich.',
  'warning.QUADS_OFF_BORDER': 'Der Rand der Vierecke liegt nicht überall auf dem gegebenen.',
  'warning.QUADS_PAIRED': 'Für Teile wurde keine Abbildung auf Quadrate gefunden: ihre Vierecke '
    + 'sind geteilte Paare von Dreiecken.',
  'warning.QUADS_SYMMETRY_LOST': 'Ebenen spiegeln das Modell, aber nicht alle spiegeln die '
    + 'Vierecke.',
  'warning.QUADS_TOO_FEW': 'Ein Teil der Form ging verloren: Verlangen Sie mehr Vierecke.',
  'warning.QUADS_TURNED_AWAY': 'Manche Vierecke liegen verkehrt herum auf der Fläche.',
  'warning.RESOURCE_NOT_GIVEN': 'Eine Datei, auf die das Modell verweist, war nicht dabei.',
  'warning.SCRAPS_REMOVED': 'Dreiecke wurden entfernt: von kleinen offenen Komponenten, solche, '
    + 'die neben einem Loch nur in einem Punkt an der Fläche hängen, und doppelte.',
  'warning.FAULTS_NOT_SOUGHT': 'Fehler werden nicht gesucht, und nichts kann ausgebessert werden: '
    + 'Dafür reicht der Speicher nicht.',
  'warning.GUIDES_FAR_AWAY': 'Führungslinien liegen weiter als 1 % der Diagonale von der Fläche '
    + 'weg: die Vierecke folgen den nächsten Stellen auf ihr.',
  'warning.GUIDES_MIRRORED': 'Die Vierecke sind gespiegelt, und Führungslinien mit ihnen.',
  'warning.GUIDES_NOT_KEPT': 'Führungslinien wurden nur teilweise zu Seiten von Vierecken: sie '
    + 'liegen zu nah an anderen Kurven oder sind zu kurz für Vierecke dieser Größe.',
  'warning.HIDDEN_BODIES_REMOVED': 'Körper wurden entfernt, die in anderen liegen und nicht zu '
    + 'sehen '
    + 'sind.',
  'warning.CAVITIES_FILLED': 'Hohlräume, die von außen nicht zu sehen sind, wurden gefüllt.',
  'warning.SHAPE_NOT_PREFERRED': 'Punkte dort, wo die Form sie am meisten braucht, ließen die '
    + 'reparierte Fläche sich selbst schneiden: Ihre Dreiecke sind stattdessen gleichmäßig.',
  'warning.SHAPE_TAKES_MORE': 'Mit so wenigen Punkten, dem gewünschten Winkel oder der Kantenlänge '
    + 'weicht die Form sichtbar ab. Verlangen Sie mehr Punkte oder einen kleineren Winkel.',
  'warning.SHEETS_LEFT': 'Blätter wie Karten, Stoff oder Gelände umschließen nichts und blieben, '
    + 'wie '
    + 'sie waren; „einhüllen“ macht dünne Körper aus ihnen.',
  'warning.SELF_INTERSECTIONS_MADE': 'Dreiecke des Ergebnisses schneiden andere, wo das '
    + 'Original '
    + 'sich nicht schneidet.',
  'warning.SHAPE_LOST_TO_ROUNDING': 'Das Modell ist kleiner als das, worauf Zahlen so weit vom '
    + 'Ursprung gerundet werden. Schieben Sie es zuerst dorthin.',
  'warning.ROUNDED_FAR_FROM_ORIGIN': 'Das Format hält so weit vom Ursprung nur grobe Koordinaten: '
    + 'Schreiben Sie .ply oder .obj, oder schieben Sie das Modell zuerst dorthin.',
  'warning.SPIKES_LEFT_COARSE': 'Punkte, die weit herausragen, hängen an Nadeln; diese bekommen '
    + 'wenige Punkte.',
  'warning.SURFACE_OPENED': 'Das Ergebnis hat offene Kanten, obwohl das Original geschlossen war.',
  'warning.THINNED_OUT': 'Das Modell ist viel feiner als das Ergebnis: Es wurde zuerst '
    + 'ausgedünnt. Die Abstände sind an Punkten des Originals gemessen.',
  'warning.TOO_FEW_VERTICES': 'So wenige Punkte reichen für eine Fläche aus so vielen Stücken oder '
    + 'mit so vielen Henkeln, Löchern oder Kurven nicht: es sind mehr geworden.',
  'warning.TRIANGLES_NOT_JOINED': 'Kein Dreieck teilt eine Kante mit einem anderen: jedes ist eine '
    + 'Fläche für sich. „Verbinden“ fügt zusammen, was nah beieinander liegt.',
  'warning.VERTICES_COINCIDE': 'Punkte des Ergebnisses liegen aufeinander: Teile sind näher '
    + 'beisammen, als die Zahlen der Datei unterscheiden können.',
  'fault.INTERNAL': 'Das ist unser Fehler, nicht Ihrer.',
  'fault.CANCELLED': 'Abgebrochen.',
  'fault.OUT_OF_MEMORY': 'Der Speicher reicht nicht. Weniger Punkte oder ein kleineres Modell '
    + 'helfen; das letzte Ergebnis ist noch da.',
  'fault.INVALID_OPTION': 'So geht diese Einstellung nicht.',
  'fault.UNKNOWN_OPTION': 'Diese Einstellung gibt es nicht.',
  'fault.UNKNOWN_FORMAT': 'Dieses Format kennt die Seite nicht.',
  'fault.EMPTY_FILE': 'Die Datei ist leer.',
  'fault.PARSE_ERROR': 'Die Datei ist beschädigt oder nicht, was ihr Name sagt.',
  'fault.MISSING_RESOURCE': 'Eine Datei, auf die das Modell verweist, fehlt: legen Sie sie mit ab.',
  'fault.UNSUPPORTED': 'Das kann die Seite mit diesem Modell nicht.',
  'fault.INVALID_MESH': 'Die Daten ergeben kein Netz.',
  'fault.INDEX_OUT_OF_RANGE': 'Ein Dreieck nennt einen Punkt, den es nicht gibt.',
  'fault.NON_FINITE': 'Eine Koordinate ist keine endliche Zahl.',
  'fault.NO_TRIANGLES': 'Das Modell hat keine Dreiecke.',
  'fault.TARGET_TOO_SMALL': 'So wenige Punkte genügen dieser Fläche nicht.',
  'fault.TARGET_BELOW_CURVES': 'So wenige Punkte genügen den Kanten und Nähten nicht, die erhalten '
    + 'bleiben.',
  'fault.INPUT_UNREADABLE': 'Die Datei lässt sich nicht öffnen.',
  'fault.OUTPUT_UNWRITABLE': 'Das Ergebnis lässt sich nicht schreiben.',
  'warning.TOO_FEW_FACES': 'So wenige Flächen reichen für diese Oberfläche nicht: Das Ergebnis hat '
    + 'mehr.',
  'warning.RIMS_CLOSED': 'Schleifen, die gewollt aussehen, wurden geschlossen; mit „Ränder '
    + 'behalten“ '
    + 'bleiben sie offen.',
  'warning.RIMS_LEFT_OPEN': 'Schleifen, die gewollt aussehen, blieben offen.',
  'warning.REMADE_IN_PART': 'Körper ohne exaktes Äußeres wurden mit einem Gitter neu gemacht. Alle '
    + 'anderen Dreiecke sind, wie sie waren, oder exakt repariert.',
  'warning.RIMS_NOT_KEPT': 'Ein Gitter hat die Fläche neu gemacht, und es lässt keine '
    + 'Schleife offen.',
  'warning.SHEETS_MADE_BODIES': 'Aus Blättern wurden geschlossene Körper.',
  'warning.SHEETS_NOT_MADE_BODIES': 'Aus Blättern wurden nicht die verlangten Körper: ihre Seiten '
    + 'schneiden sich so, dass sie nicht exakt zu trennen sind.',
  'warning.BASE_NOT_MADE': 'Blätter, deren Umriss sich überschlägt, bekamen keinen Sockel.',
  'warning.PIECES_DROPPED': 'Kleine Stücke wurden weggelassen, wie verlangt.',
  'warning.HIDDEN_DROPPED': 'Dreiecke, die von außen niemand sieht, wurden weggelassen, wie '
    + 'verlangt.',
  'warning.SEEN_PARTS_LOST': 'Teile, die von außen zu sehen sind, fehlen dem Ergebnis: sie sind '
    + 'dünner, als es fein ist, oder liegen in Lücken, die es schließt.',
  'warning.SHEETS_THICKENED': 'Aus Blättern, die nichts umschließen, wurden dünne Körper hinter '
    + 'dem, was von ihnen zu sehen ist.',
  'warning.TEXCOORDS_REPLACED': 'Die Texturkoordinaten des Modells überlappen sich oder gehen '
    + 'über den Rand des Quadrats: Es bekam neue.',
  'warning.TEXELS_NOT_FOUND': 'Für einen Teil der Texel wurde keine Fläche gefunden: Sie haben die '
    + 'Farben daneben.',
  'warning.TEXTURES_PAINTED': 'Die Reparatur hat eine andere Fläche gemacht, daher wurden ihre '
    + 'Texturen neu gemalt.',
  'warning.PLACES_JOINED': 'Punkte unterscheiden sich von anderen nur durch Rundung; genaue '
    + 'Leser finden dort Risse. Reparatur macht ihre Stellen gleich.',
  'warning.PARTS_MEET': 'Dreiecke von Teilen treffen solche anderer Teile: Reparatur bessert '
    + 'jedes für sich, um Namen und Ort zu behalten. In einer STL-Datei werden alle eine Fläche.',
  'warning.ONE_SIDED': 'Die Fläche hat nur eine Seite wie ein Möbiusband: Sie hat kein Außen, und '
    + 'an diesen Kanten zeigen Dreiecke zu verschiedenen Seiten. Reparatur lässt sie, wie sie ist.',
  'warning.SHEETS_DROPPED': 'Blätter, die nichts umschließen, wurden weggelassen.',
  'warning.BODIES_ALMOST_TOUCH': 'Körper berühren sich fast: ihre Flächen sind ein wenig '
    + 'voneinander entfernt und bleiben es.',
  'warning.BODIES_OVERLAP': 'Körper überlappen sich: Dreiecke des einen schneiden solche des '
    + 'anderen.',
  'warning.COMMON_FACES_LEFT': 'Flächen, die sich berühren, wurden getrennt neu vernetzt: sie '
    + 'liegen nicht in einer Ebene, oder ihre Ränder kreuzen sich.',
  'warning.NO_BODIES_TOUCH': 'Keine geschlossenen Körper berühren sich mit Flächen.',
  'warning.TEXCOORDS_LEFT_OUT': 'Körper mit gemeinsamen Flächen wurden ohne Texturkoordinaten '
    + 'neu vernetzt.',
};
