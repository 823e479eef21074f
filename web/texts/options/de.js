// SPDX-License-Identifier: MIT
// German: the options' names, units and help.

export default {
  'option.vertices': 'Punkte',
  'option.faces': 'Dreiecke',
  'option.ratio': 'Anteil',
  'option.edgeLength': 'Kantenlänge',
  'option.minEdge': 'Kürzeste Kante',
  'option.maxEdge': 'Längste Kante',
  'option.minAngle': 'Kleinster Winkel',
  'option.scheme': 'Verfahren',
  'option.quality': 'Güte',
  'option.prefer': 'Vorzug',
  'option.projection': 'Projektion',
  'option.fidelity': 'Treue',
  'option.vertexAngle': 'Punktwinkel',
  'option.triangleAngle': 'Dreieckswinkel',
  'option.splitObtuse': 'Stumpfe teilen',
  'option.adaptivity': 'Anpassung',
  'option.gradation': 'Abstufung',
  'option.featureAngle': 'Kantenwinkel',
  'option.boundary': 'Rand',
  'option.maxError': 'Größter Fehler',
  'option.weld': 'Verbinden',
  'option.quads': 'Vierecke',
  'option.exact': 'Genaue Zahl',
  'option.symmetry': 'Spiegelung',
  'help.vertices': 'genaue Zahl der Punkte des Ergebnisses; ohne Angabe die des Originals, oder '
    + 'bis zu viermal so viele, wo gleichmäßige Dreiecke sie brauchen',
  'help.faces': 'höchstens so viele Dreiecke, oder Vierecke mit --quads, so nah daran, '
    + 'wie die Fläche es zulässt',
  'help.ratio': 'die Zahl der Punkte als Anteil an denen des Originals',
  'help.edgeLength': 'die Zahl der Punkte aus einer mittleren Kantenlänge',
  'help.minEdge': 'keine Kante soll kürzer sein; wo das nicht geht, sagt der Bericht, wie viele es '
    + 'sind und wo. Ohne Zahl der Punkte gibt es höchstens so viele, wie das zulässt',
  'help.maxEdge': 'keine Kante soll länger sein, wie oben. Ohne Zahl der Punkte so wenige, wie das '
    + 'zulässt',
  'help.minAngle': 'kein Winkel eines Dreiecks soll kleiner sein, wie oben',
  'help.scheme': 'rounds: das veröffentlichte Verfahren, Schritt für Schritt; best: unser eigenes',
  'help.quality': 'draft: in einem Bruchteil der Zeit, fast so gut, Abstände nur grob gemessen',
  'help.prefer': 'even: gleichmäßige Dreiecke; shape: die Punkte des Originals, die Form und '
    + 'Aussehen am meisten brauchen; auto: gleichmäßige, wo sie beides erhalten, sonst shape',
  'help.projection': 'patches: auf das Original, über einander überlappende Flecken oder, bei best '
    + 'ab 8000 Punkten, auf dem Weg zur nächsten Stelle; current: auf das jetzige Netz',
  'help.fidelity': 'ein Schritt wird verweigert, wenn nicht jedes Paar von Normalen innerhalb der '
    + 'Winkel unten liegt (strict), wenn nicht wenigstens eines (loose), oder nur, wo ein Dreieck '
    + 'umklappte (fold)',
  'help.vertexAngle': 'zwischen den Normalen an den Punkten eines Dreiecks',
  'help.triangleAngle': 'zwischen der Normale eines Dreiecks und denen seiner Punkte',
  'help.splitObtuse': 'am Ziel wird jede Kante gegenüber einem stumpfen Winkel einmal geteilt',
  'help.adaptivity': '0: gleichmäßige Dreiecke; 1: Größen folgen der Krümmung, für den kleinsten '
    + 'Fehler; dazwischen: gemischt',
  'help.gradation': 'größtes Verhältnis der Größen an den Enden einer Kante',
  'help.featureAngle': 'Winkel zwischen Flächen, ab dem eine Kante zu einer Kurve gehören kann, '
    + 'die erhalten bleibt',
  'help.boundary': 'Punkte entlang offener Ränder verschieben oder genau so lassen',
  'help.maxError': 'verweigert, was vom Original mehr abwiche',
  'help.weld': 'fügt Punkte offener Kanten zusammen, die näher beieinander liegen; ohne Angabe '
    + 'nur, was bis auf Rundung gleich ist',
  'help.quads': 'nur Vierecke statt Dreiecken, entlang von Kanten und Krümmung; die Zahl der '
    + 'Punkte auf 1 % genau',
  'help.exact': 'von Vierecken: genau so viele Punkte',
  'help.symmetry': 'von Vierecken: auto: an Ebenen, die das Modell spiegeln, genau gespiegelte; '
    + 'x, xy …: an Ebenen quer zu diesen Achsen gespiegelte, wie auch immer das Modell ist',
  'unit.degrees': 'Grad',
  'unit.model units': 'Modelleinheiten',
  'unit.% of the diagonal': '% der Diagonale',
  'option.repair': 'Reparatur',
  'option.holesUpTo': 'Löcher bis',
  'option.gap': 'Lücke',
  'help.repair': 'die Fläche zuerst ausbessern. holes: offene Schleifen schließen, den Rest '
    + 'lassen; solid: das Äußere dessen, was etwas umschließt; wrap: was von außen durch '
    + 'Öffnungen, weiter als die Lücke, zu erreichen ist; auto: das erste davon, das passt',
  'help.gap': 'so weite Öffnungen schließt wrap noch; ohne Angabe 2',
  'help.holesUpTo': 'längere Schleifen bleiben offen; ohne Angabe werden alle geschlossen',
  'option.textures': 'Texturen',
  'option.textureSize': 'Texturgröße',
  'option.textureFormat': 'Texturformat',
  'help.textures': 'keep: die Texturkoordinaten, entlang ihrer Nähte; drop: weglassen; bake '
    + '(in glTF): neue '
    + 'Texturen, von den alten abgemalt, sodass Nähte keine Punkte kosten',
  'help.textureSize': 'der neuen Texturen, an einer Seite; ohne Angabe so fein wie die des '
    + 'Originals, bis 4096',
  'help.textureFormat': 'der neuen Texturen; ohne Angabe wie sie kamen: webp, wenn alle WebP '
    + 'waren, sonst jpeg, aber png für Durchsichtiges und für Normalen, die kein JPEG waren',
  'unit.texels': 'Texel',
  'option.cavities': 'Hohlräume behalten',
  'option.sheets': 'Blätter',
  'help.cavities': 'solid behält innere Hohlräume: geschlossene Stücke, die in das zeigen, was '
    + 'sie umschließen',
  'help.sheets': 'aus Blättern, die nichts umschließen, macht wrap dünne Körper hinter dem, was '
    + 'von ihnen zu sehen ist, oder lässt sie weg',
  'option.keepRims': 'Ränder behalten',
  'option.thickness': 'Dicke',
  'option.base': 'Sockel',
  'option.unite': 'Vereinigen',
  'option.dropBelow': 'Kleines weglassen',
  'option.dropHidden': 'Verdecktes weglassen',
  'option.conform': 'Gemeinsame Flächen',
  'help.keepRims': 'Schleifen, die gewollt aussehen, bleiben offen: runde, und gerade, an denen '
    + 'Wände enden; '
    + 'mit holes bleiben auch kleine offene Stücke',
  'help.thickness': 'aus Blättern werden so dicke Körper, die Hälfte auf jeder Seite',
  'help.base': 'ein offenes Relief wie ein Gelände bekommt senkrechte Wände und einen flachen '
    + 'Boden, der um die Dicke unter seiner tiefsten Stelle liegt',
  'help.unite': 'die Netze einer Datei werden eine Fläche, mit ihren Materialien',
  'help.dropBelow': 'kleinere Stücke weglassen; auto: was klein ist und abseits vom Rest schwebt',
  'help.dropHidden': 'Dreiecke weglassen, die von außen niemand sieht; alle anderen bleiben, wie '
    + 'sie sind',
  'help.conform': 'geschlossene Körper, die sich mit Flächen berühren, bekommen dort dieselben '
    + 'Dreiecke, sodass ein Löser sie verbinden kann; Punkte einer gemeinsamen Fläche zählen '
    + 'einmal',
  'choice.sheets.thicken': 'zu dünnen Körpern machen',
  'choice.sheets.drop': 'weglassen',
  'landmark.selfIntersections': '{count} Dreiecke schneiden andere',
  'landmark.innerShells': '1 innere Hülle|{count} innere Hüllen',
  'landmark.insideOut': '1 Körper mit dem Inneren nach außen|{count} Körper mit dem Inneren nach '
    + 'außen',
  'mend.needs': ' (etwa {seconds} s, {size})',
  'repair.far': '{share} der sichtbaren Fläche sind weiter als {distance} vom Ergebnis weg',
  'reason.sound': 'Fehlerfrei: unverändert.',
  'reason.joined': 'Fast gleiche Stellen wurden gleich gemacht.',
  'reason.closed': 'Mit geschlossenen Rändern ist die Fläche fehlerfrei.',
  'reason.united': 'Körper, die sich schneiden, wurden exakt vereinigt.',
  'repair.rims': '1 Rand offen gelassen|{count} Ränder offen gelassen',
  'repair.bodies': '1 Blatt zu einem geschlossenen Körper gemacht|{count} Blätter zu '
    + 'geschlossenen Körpern gemacht',
  'reason.made': 'Aus Blättern wurden geschlossene Körper.',
  'reason.sheets': 'Blätter blieben, wie sie waren.',
  'reason.partly': 'Nur was kein exaktes Äußeres hat, wurde mit einem Gitter neu gemacht.',
  'reason.enclosed': 'Mit einem Gitter um Körper neu gemacht.',
  'reason.open': 'Mit einem Gitter neu gemacht.',
};
