<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="fr">
<context>
    <name>AblationText</name>
    <message>
        <source>interrupted before all runs were done</source>
        <translation>interrompu avant la fin de toutes les exécutions</translation>
    </message>
    <message>
        <source>the spread of a measure needs at least two seeds</source>
        <translation>la dispersion d’une mesure demande au moins deux graines</translation>
    </message>
</context>
<context>
    <name>About</name>
    <message>
        <source>TeleTA Console</source>
        <translation>TeleTA Console</translation>
    </message>
    <message>
        <source>Shows, and lets the operator feel, what a remote robot arm touches.</source>
        <translation>Montre ce que touche un bras robotisé distant et le fait sentir à l’opérateur.</translation>
    </message>
    <message>
        <source>Free software under the GNU General Public License, version 3 or later. It comes without any warranty.</source>
        <translation>Logiciel libre sous licence publique générale GNU, version 3 ou ultérieure. Fourni sans aucune garantie.</translation>
    </message>
    <message>
        <source>About TeleTA Console</source>
        <translation>À propos de TeleTA Console</translation>
    </message>
    <message>
        <source>Esc Esc, Ctrl+.</source>
        <translation>Esc Esc, Ctrl+.</translation>
    </message>
    <message>
        <source>Space</source>
        <translation>Espace</translation>
    </message>
    <message>
        <source>Play or pause, in the playback bar</source>
        <translation>Lecture ou pause, dans la barre de lecture</translation>
    </message>
    <message>
        <source>Left, Right</source>
        <translation>Gauche, Droite</translation>
    </message>
    <message>
        <source>One frame back or forward, in the playback bar</source>
        <translation>Une trame en arrière ou en avant, dans la barre de lecture</translation>
    </message>
    <message>
        <source>Home, End</source>
        <translation>Début, Fin</translation>
    </message>
    <message>
        <source>Start or end of the recording, in the playback bar</source>
        <translation>Début ou fin de l’enregistrement, dans la barre de lecture</translation>
    </message>
    <message>
        <source>Arrow keys</source>
        <translation>Touches fléchées</translation>
    </message>
    <message>
        <source>Move the read-out from taxel to taxel, in the heatmap</source>
        <translation>Déplacer la lecture de taxel en taxel, dans la carte de chaleur</translation>
    </message>
    <message>
        <source>Ctrl+wheel</source>
        <translation>Ctrl+molette</translation>
    </message>
    <message>
        <source>Zoom the picture or the time under the mouse</source>
        <translation>Zoomer sur l’image ou le temps sous la souris</translation>
    </message>
    <message>
        <source>Shift+wheel</source>
        <translation>Shift+molette</translation>
    </message>
    <message>
        <source>Scroll through time, in the charts</source>
        <translation>Défiler dans le temps, dans les graphiques</translation>
    </message>
    <message>
        <source>1, 2, 3, 4</source>
        <translation>1, 2, 3, 4</translation>
    </message>
    <message>
        <source>Front, top, side, isometric view, in the reconstruction</source>
        <translation>Vue de face, de dessus, de côté, isométrique, dans la reconstruction</translation>
    </message>
    <message>
        <source>F11</source>
        <translation>F11</translation>
    </message>
    <message>
        <source>Full screen</source>
        <translation>Plein écran</translation>
    </message>
    <message>
        <source>Shift+F1</source>
        <translation>Shift+F1</translation>
    </message>
    <message>
        <source>What&apos;s This</source>
        <translation>Qu’est-ce que c’est&#xa0;?</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Touches</translation>
    </message>
    <message>
        <source>Effect</source>
        <translation>Effet</translation>
    </message>
    <message>
        <source>Shortcuts</source>
        <translation>Raccourcis clavier</translation>
    </message>
    <message>
        <source>Space, P</source>
        <translation>Espace, P</translation>
    </message>
    <message>
        <source>Play or pause; pen; in the timeline of a pattern</source>
        <translation>Lecture ou pause&#xa0;; crayon&#xa0;; dans la chronologie d’un motif</translation>
    </message>
    <message>
        <source>Ctrl+N, O, S, Shift+S, E</source>
        <translation>Ctrl+N, O, S, Shift+S, E</translation>
    </message>
    <message>
        <source>New, open, save, save as, export, on the page Patterns</source>
        <translation>Nouveau, ouvrir, enregistrer, enregistrer sous, exporter, sur la page Motifs</translation>
    </message>
    <message>
        <source>Ctrl+Z, Ctrl+Y</source>
        <translation>Ctrl+Z, Ctrl+Y</translation>
    </message>
    <message>
        <source>Ctrl+X, C, V, Shift+V, D</source>
        <translation>Ctrl+X, C, V, Shift+V, D</translation>
    </message>
    <message>
        <source>Cut, copy, paste in place, paste at the playhead, duplicate, in the timeline</source>
        <translation>Couper, copier, coller sur place, coller à la tête de lecture, dupliquer, dans la chronologie</translation>
    </message>
    <message>
        <source>,  .  with Shift</source>
        <translation>,  .  avec Shift</translation>
    </message>
    <message>
        <source>N, Shift+N</source>
        <translation>N, Shift+N</translation>
    </message>
    <message>
        <source>Next or previous object, in the timeline</source>
        <translation>Objet suivant ou précédent, dans la chronologie</translation>
    </message>
    <message>
        <source>Enter, Insert, Delete</source>
        <translation>Entrée, Inser, Suppr</translation>
    </message>
    <message>
        <source>Type numbers, add a breakpoint at the playhead, delete, in the timeline</source>
        <translation>Saisir des nombres, ajouter un nœud à la tête de lecture, supprimer, dans la chronologie</translation>
    </message>
    <message>
        <source>Arrow keys, with Shift</source>
        <translation>Touches fléchées, avec Shift</translation>
    </message>
    <message>
        <source>[  ]  \</source>
        <translation>[  ]  \</translation>
    </message>
    <message>
        <source>Ctrl+[, Ctrl+], Ctrl+M, Ctrl+L</source>
        <translation>Ctrl+[, Ctrl+], Ctrl+M, Ctrl+L</translation>
    </message>
    <message>
        <source>Rotate around the ring, mirror, other arm, on the page Patterns</source>
        <translation>Tourner autour de l’anneau, mettre en miroir, autre bras, sur la page Motifs</translation>
    </message>
    <message>
        <source>Ctrl+Alt+1 to 5</source>
        <translation>Ctrl+Alt+1 à 5</translation>
    </message>
    <message>
        <source>Add a sweep, ring, phantom, ramp, pulse train at the playhead, on the page Patterns</source>
        <translation>Ajouter un balayage, un anneau, un fantôme, une rampe, un train d’impulsions à la tête de lecture, sur la page Motifs</translation>
    </message>
    <message>
        <source>Ctrl++, Ctrl+-, Ctrl+0</source>
        <translation>Ctrl++, Ctrl+-, Ctrl+0</translation>
    </message>
    <message>
        <source>Zoom in, out, to fit, in the timeline</source>
        <translation>Zoom avant, arrière, ajusté, dans la chronologie</translation>
    </message>
    <message>
        <source>F2, Ctrl+D, Delete, Ctrl+Z</source>
        <translation>F2, Ctrl+D, Suppr, Ctrl+Z</translation>
    </message>
    <message>
        <source>Rename, duplicate, delete, undo, in the library of patterns</source>
        <translation>Renommer, dupliquer, supprimer, annuler, dans la bibliothèque de motifs</translation>
    </message>
    <message>
        <source>Ctrl+R, M</source>
        <translation>Ctrl+R, M</translation>
    </message>
    <message>
        <source>Record, mark this moment in the recording</source>
        <translation>Enregistrer, marquer cet instant dans l’enregistrement</translation>
    </message>
    <message>
        <source>F1</source>
        <translation>F1</translation>
    </message>
    <message>
        <source>Handbook: the page on what is shown</source>
        <translation>Manuel&#xa0;: la page sur ce qui est affiché</translation>
    </message>
    <message>
        <source>Ctrl+1 to 5</source>
        <translation>Ctrl+1 à 5</translation>
    </message>
    <message>
        <source>Page Operate, Patterns, Study, Calibrate, Cost</source>
        <translation>Page Conduite, Motifs, Étude, Étalonnage, Coût</translation>
    </message>
    <message>
        <source>F5, Shift+F5, Ctrl+F5</source>
        <translation>F5, Shift+F5, Ctrl+F5</translation>
    </message>
    <message>
        <source>Run the program of the arm, hold it, restart it, on the page Operate</source>
        <translation>Exécuter le programme du bras, le maintenir, le recommencer, sur la page Conduite</translation>
    </message>
    <message>
        <source>Ctrl+Shift+N</source>
        <translation>Ctrl+Shift+N</translation>
    </message>
    <message>
        <source>Forget the explored contour, on the page Operate</source>
        <translation>Oublier le contour exploré, sur la page Conduite</translation>
    </message>
    <message>
        <source>Undo, redo: marks on the page Operate, edits on the pages Patterns and Calibrate</source>
        <translation>Annuler, rétablir&#xa0;: les marques sur la page Conduite, les modifications sur les pages Motifs et Étalonnage</translation>
    </message>
    <message>
        <source>STOP: everything that moves stops at once</source>
        <translation>STOP&#xa0;: tout ce qui bouge s’arrête aussitôt</translation>
    </message>
    <message>
        <source>Previous or next breakpoint; with Shift, add it to the selection, in the timeline</source>
        <translation>Nœud précédent ou suivant, un de plus avec Shift, dans la chronologie</translation>
    </message>
    <message>
        <source>Move the selection; without one, the playhead and the lane, in the timeline</source>
        <translation>Déplacer la sélection, sinon la tête de lecture et la piste, dans la chronologie</translation>
    </message>
    <message>
        <source>Loop start, loop end, no loop, in the timeline</source>
        <translation>Début de la boucle, sa fin, pas de boucle, dans la chronologie</translation>
    </message>
</context>
<context>
    <name>Age</name>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1 min</translation>
    </message>
    <message>
        <source>%1 h</source>
        <translation>%1 h</translation>
    </message>
</context>
<context>
    <name>AlsaText</name>
    <message>
        <source>Another program plays on %1.</source>
        <translation>Un autre programme joue sur %1.</translation>
    </message>
    <message>
        <source>it to be closed there first</source>
        <translation>qu’il y soit d’abord fermé</translation>
    </message>
    <message>
        <source>The sound card %1 cannot be opened: %2</source>
        <translation>La carte son %1 ne peut pas être ouverte&#xa0;: %2</translation>
    </message>
    <message>
        <source>Other programs can play on %1 as well.</source>
        <translation>D’autres programmes peuvent jouer aussi sur %1.</translation>
    </message>
    <message>
        <source>the card itself, as alsa:hw:CARD=NAME, or shared = true in the device file</source>
        <translation>la carte elle-même, comme alsa:hw:CARD=NAME, ou shared = true dans le fichier d’appareil</translation>
    </message>
    <message>
        <source>The sound card takes none of the known formats.</source>
        <translation>La carte son n’accepte aucun des formats connus.</translation>
    </message>
    <message>
        <source>The sound card does not play %1 samples a second.</source>
        <translation>La carte son ne joue pas %1 échantillons par seconde.</translation>
    </message>
    <message>
        <source>another sample_rate_Hz in the device file</source>
        <translation>un autre sample_rate_Hz dans le fichier d’appareil</translation>
    </message>
    <message numerus="yes">
        <source>The sound card has %n output(s).</source>
        <translation>
            <numerusform>La carte son a %n sortie.</numerusform>
            <numerusform>La carte son a %n sorties.</numerusform>
        </translation>
    </message>
    <message>
        <source>an output %1, as channels says</source>
        <translation>une sortie %1, comme l’indique channels</translation>
    </message>
    <message>
        <source>The sound card does not take %1 samples at a time.</source>
        <translation>La carte son n’accepte pas %1 échantillons à la fois.</translation>
    </message>
    <message>
        <source>another period_frames in the device file</source>
        <translation>un autre period_frames dans le fichier d’appareil</translation>
    </message>
</context>
<context>
    <name>ArmChainText</name>
    <message>
        <source>interrupted</source>
        <translation>le travail a été interrompu</translation>
    </message>
    <message>
        <source>nobody published %1 in domain %2 within %3 s</source>
        <translation>personne n’a publié&#xa0;%1 dans le domaine&#xa0;%2 en&#xa0;%3 s</translation>
    </message>
    <message>
        <source>a publisher that is reliable and transient local</source>
        <translation>un émetteur en «&#xa0;reliable&#xa0;» qui garde ce qu’il a envoyé</translation>
    </message>
    <message>
        <source>the robot in this domain, or description = &quot;FILE.urdf&quot;</source>
        <translation>le robot dans ce domaine, ou description = &quot;FILE.urdf&quot;</translation>
    </message>
    <message>
        <source>two joints of the arm have the ROS name &quot;%1&quot;</source>
        <translation>deux articulations du bras s’appellent «&#xa0;%1&#xa0;» sur le réseau</translation>
    </message>
    <message>
        <source>a unique name for each joint in [joint_names]</source>
        <translation>que [joint_names] nomme chaque articulation une seule fois</translation>
    </message>
    <message>
        <source>the description gives no velocity limit for %1</source>
        <translation>la description n’indique pas de vitesse pour&#xa0;%1</translation>
    </message>
    <message>
        <source>[joint_names] names %1, which is not in the description</source>
        <translation>[joint_names] nomme&#xa0;%1, que la description n’a pas</translation>
    </message>
    <message>
        <source>effort_stop has %1 numbers, the arm has %2 joints</source>
        <translation>effort_stop a&#xa0;%1 nombres, le bras a&#xa0;%2 articulations</translation>
    </message>
    <message>
        <source>effort_contains_gravity needs the mass of every link; %1 has none</source>
        <translation>effort_contains_gravity demande toutes les masses&#xa0;;&#xa0;%1 n’en a pas</translation>
    </message>
    <message>
        <source>the file requires %1, which is not monitored when the arm is driven directly</source>
        <translation>le fichier exige&#xa0;%1, qui n’est pas surveillé d’ici</translation>
    </message>
    <message>
        <source>MoveIt Servo compares stamps with the robot&apos;s clock, so only teleta-site sends commands to it</source>
        <translation>MoveIt Servo compare les horodatages avec l’horloge du robot&#xa0;: seul teleta-site lui envoie des commandes</translation>
    </message>
    <message>
        <source>force_stop_N needs a force sensor: wrench = &quot;FILE&quot; names the file of one</source>
        <translation>force_stop_N a besoin d’un capteur de force&#xa0;: wrench = &quot;FICHIER&quot; nomme le fichier du capteur</translation>
    </message>
    <message>
        <source>the force sensor is in the frame %1, which the description does not have</source>
        <translation>le capteur de force est dans le repère %1, que la description n’a pas</translation>
    </message>
    <message>
        <source>the force sensor must be in the domain of the arm, over the same interface</source>
        <translation>le capteur de force doit être dans le domaine du bras, par la même interface</translation>
    </message>
</context>
<context>
    <name>ArmCommand</name>
    <message>
        <source>no end</source>
        <translation>sans fin</translation>
    </message>
    <message>
        <source>not stated</source>
        <translation>non indiqué</translation>
    </message>
    <message>
        <source>cannot be moved: the description states no speed</source>
        <translation>ne peut pas être bougé&#xa0;: la description n’indique pas de vitesse</translation>
    </message>
    <message>
        <source>Chain, limits and mass of an arm, and what cannot be moved</source>
        <translation>Chaîne, limites et masse d’un bras, et ce qui ne peut pas être bougé</translation>
    </message>
    <message>
        <source>URDF file, or the name of one that comes with the program: %1</source>
        <translation>Fichier URDF, ou nom de l’un de ceux fournis avec le programme&#xa0;: %1</translation>
    </message>
    <message>
        <source>Link that stands still; default: the root</source>
        <translation>Segment immobile&#xa0;; par défaut&#xa0;: la racine</translation>
    </message>
    <message>
        <source>Link that is moved; default: tool0, flange or ee_link, else the end of the longest chain</source>
        <translation>Segment qui est bougé&#xa0;; par défaut&#xa0;: tool0, flange ou ee_link, sinon le bout de la chaîne la plus longue</translation>
    </message>
    <message>
        <source>Joint</source>
        <translation>Articulation</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>Type</translation>
    </message>
    <message>
        <source>Range</source>
        <translation>Plage</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Vitesse</translation>
    </message>
    <message>
        <source>Effort</source>
        <translation>Effort</translation>
    </message>
    <message>
        <source>shown, not moved</source>
        <translation>montré, non bougé</translation>
    </message>
    <message>
        <source>follows %1</source>
        <translation>suit %1</translation>
    </message>
    <message numerus="yes">
        <source>%1: %n joint(s) from %2 to %3</source>
        <translation>
            <numerusform>%1&#xa0;: %n articulation de %2 à %3</numerusform>
            <numerusform>%1&#xa0;: %n articulations de %2 à %3</numerusform>
        </translation>
    </message>
    <message>
        <source>The link &apos;%1&apos; has no mass, so the torque of gravity is not known.</source>
        <translation>Le segment «&#xa0;%1&#xa0;» n’a pas de masse&#xa0;: le couple de pesanteur est donc inconnu.</translation>
    </message>
    <message>
        <source>%1 kg are moved.</source>
        <translation>%1 kg sont bougés.</translation>
    </message>
    <message>
        <source>Joint to move, as the URDF names it</source>
        <translation>Articulation à bouger, telle que l’URDF la nomme</translation>
    </message>
    <message>
        <source>Speed in rad/s, of a prismatic joint in m/s</source>
        <translation>Vitesse en rad/s, en m/s pour une articulation prismatique</translation>
    </message>
    <message>
        <source>Duration of the motion, at most %1</source>
        <translation>Durée du mouvement, au plus&#xa0;%1</translation>
    </message>
    <message>
        <source>Move without asking</source>
        <translation>Bouger sans demander</translation>
    </message>
    <message>
        <source>Show the description of a robot arm (URDF), or jog an arm</source>
        <translation>Bras robotisés&#xa0;: descriptions (URDF), et une articulation qui est bougée</translation>
    </message>
    <message>
        <source>Move a joint of an arm for a short time</source>
        <translation>Déplacer une articulation d’un bras pendant un court moment</translation>
    </message>
    <message>
        <source>File that describes the arm (kind = &quot;ros_arm&quot;), or with which its site is reached (kind = &quot;remote_site&quot;)</source>
        <translation>Fichier qui décrit le bras (kind = &quot;ros_arm&quot;), ou qui permet d’atteindre son site (kind = &quot;remote_site&quot;)</translation>
    </message>
    <message>
        <source>Which arm of a site; default: its only one</source>
        <translation>Quel bras d’un site ; par défaut : son seul bras</translation>
    </message>
</context>
<context>
    <name>ArmJogText</name>
    <message>
        <source>joint speed</source>
        <translation>vitesse de l’articulation</translation>
    </message>
    <message>
        <source>tip speed</source>
        <translation>vitesse de l’extrémité</translation>
    </message>
    <message>
        <source>joint limit</source>
        <translation>butée de l’articulation</translation>
    </message>
    <message>
        <source>workspace box</source>
        <translation>boîte de l’extrémité</translation>
    </message>
    <message>
        <source>effort</source>
        <translation>effort</translation>
    </message>
    <message>
        <source>force</source>
        <translation>force</translation>
    </message>
    <message>
        <source>the arm lags behind</source>
        <translation>le bras est en retard</translation>
    </message>
    <message>
        <source>the arm cannot be moved: %1</source>
        <translation>le bras ne peut pas être bougé&#xa0;:&#xa0;%1</translation>
    </message>
    <message>
        <source>no joint states were received</source>
        <translation>aucun état des articulations n’est arrivé</translation>
    </message>
    <message>
        <source>%1 moved %2 %3 in %4 s.</source>
        <translation>%1 a bougé de&#xa0;%2&#xa0;%3 en&#xa0;%4 s.</translation>
    </message>
    <message>
        <source>It was at rest %1 s after the command ended.</source>
        <translation>L’articulation était à l’arrêt&#xa0;%1 s après la fin de la commande.</translation>
    </message>
    <message>
        <source>It was not seen to come to rest.</source>
        <translation>L’articulation n’a pas été vue à l’arrêt.</translation>
    </message>
    <message>
        <source>Active limits: %1.</source>
        <translation>Limites qui sont intervenues&#xa0;:&#xa0;%1.</translation>
    </message>
    <message>
        <source>there is no terminal to ask on; add --yes to move the arm</source>
        <translation>sans terminal où demander, --yes est nécessaire pour bouger un bras</translation>
    </message>
    <message>
        <source>This moves %1 of %2 at %3 %4/s for %5 s. Type &quot;yes&quot; to move it: </source>
        <translation>Ceci bouge&#xa0;%1 de&#xa0;%2 à&#xa0;%3&#xa0;%4/s pendant&#xa0;%5 s. Tapez «&#xa0;yes&#xa0;» pour le faire&#xa0;: </translation>
    </message>
    <message>
        <source>nothing was moved</source>
        <translation>rien n’a été bougé</translation>
    </message>
    <message>
        <source>the motion was cut short: %1</source>
        <translation>le mouvement a été interrompu&#xa0;:&#xa0;%1</translation>
    </message>
</context>
<context>
    <name>ArmWatch</name>
    <message>
        <source>--viewer with the file of a viewer</source>
        <translation>--viewer avec le fichier d’un observateur</translation>
    </message>
    <message>
        <source>this site has certificates, so a viewer with keys of its own has to watch the arm</source>
        <translation>ce site a des certificats&#xa0;: un observateur avec ses propres clés doit surveiller le bras</translation>
    </message>
    <message>
        <source>no position of this joint was received within 5 s</source>
        <translation>aucune position de cette articulation n’a été reçue en 5 s</translation>
    </message>
    <message>
        <source>--joint with a joint that the arm reports</source>
        <translation>--joint avec une articulation que le bras annonce</translation>
    </message>
</context>
<context>
    <name>ArrayFramesText</name>
    <message>
        <source>the file has no arrays</source>
        <translation>le fichier n’a pas de tableaux</translation>
    </message>
    <message>
        <source>frames of an array</source>
        <translation>les trames d’une matrice</translation>
    </message>
    <message>
        <source>there is no array %1; the file has: %2</source>
        <translation>il n’y a pas de tableau&#xa0;%1&#xa0;; le fichier a&#xa0;:&#xa0;%2</translation>
    </message>
    <message>
        <source>one of these</source>
        <translation>l’un de ceux-ci</translation>
    </message>
    <message>
        <source>no array can be frames; the file has: %1</source>
        <translation>aucun tableau ne peut constituer les trames&#xa0;; le fichier a&#xa0;:&#xa0;%1</translation>
    </message>
    <message>
        <source>an array of 3 dimensions: frames x rows x columns</source>
        <translation>un tableau à 3 dimensions&#xa0;: trames x lignes x colonnes</translation>
    </message>
    <message>
        <source>the name of one (--array NAME)</source>
        <translation>le nom d’un seul (--array NAME)</translation>
    </message>
    <message>
        <source>the array %1: %2</source>
        <translation>le tableau&#xa0;%1&#xa0;:&#xa0;%2</translation>
    </message>
    <message>
        <source>a time in s for each frame</source>
        <translation>un temps en s pour chaque trame</translation>
    </message>
    <message>
        <source>time_s has the shape %1, the frames have %2</source>
        <translation>time_s a la forme&#xa0;%1, les trames ont&#xa0;%2</translation>
    </message>
    <message>
        <source>the array has %1 instead of %2 values</source>
        <translation>le tableau a&#xa0;%1 valeurs au lieu de&#xa0;%2</translation>
    </message>
    <message>
        <source>a whole file</source>
        <translation>un fichier entier</translation>
    </message>
    <message>
        <source>a frame of the array</source>
        <translation>une trame de la matrice</translation>
    </message>
    <message>
        <source>a frame of %1 has %2 x %3 taxels</source>
        <translation>une trame de&#xa0;%1 a&#xa0;%2 x&#xa0;%3 taxels</translation>
    </message>
    <message>
        <source>from 1 to %1 rows and columns</source>
        <translation>de 1 à&#xa0;%1 lignes et colonnes</translation>
    </message>
    <message>
        <source>the frames have %1 rows x %2 columns</source>
        <translation>les trames ont&#xa0;%1 lignes x&#xa0;%2 colonnes</translation>
    </message>
    <message>
        <source>%1 rows x %2 columns</source>
        <translation>%1 lignes x&#xa0;%2 colonnes</translation>
    </message>
    <message>
        <source>%1 has %2 taxels</source>
        <translation>%1 a&#xa0;%2 taxels</translation>
    </message>
    <message>
        <source>%1 = %2 rows x %3 columns; others with --rows and --columns</source>
        <translation>%1 =&#xa0;%2 lignes x&#xa0;%3 colonnes&#xa0;; d’autres avec --rows et --columns</translation>
    </message>
    <message>
        <source>the file does not say when its frames were taken</source>
        <translation>le fichier n’indique pas quand ses trames ont été prises</translation>
    </message>
    <message>
        <source>frames per second (--rate HZ), or times in time_s</source>
        <translation>des trames par seconde (--rate HZ), ou des temps dans time_s</translation>
    </message>
    <message>
        <source>the time of frame %1 is not a finite number</source>
        <translation>le temps de la trame&#xa0;%1 n’est pas un nombre fini</translation>
    </message>
    <message>
        <source>a finite time in s</source>
        <translation>un temps fini en s</translation>
    </message>
    <message>
        <source>the time goes back at frame %1, from %2 s to %3 s</source>
        <translation>le temps recule à la trame&#xa0;%1, de&#xa0;%2 s à&#xa0;%3 s</translation>
    </message>
    <message>
        <source>times that do not decrease</source>
        <translation>des temps non décroissants</translation>
    </message>
    <message>
        <source>an array of real numbers</source>
        <translation>un tableau de nombres réels</translation>
    </message>
    <message>
        <source>the array has the shape %1</source>
        <translation>le tableau a la forme&#xa0;%1</translation>
    </message>
    <message>
        <source>frames x rows x columns, or frames x taxels</source>
        <translation>trames x lignes x colonnes, ou trames x taxels</translation>
    </message>
    <message>
        <source>the array is too large: %1</source>
        <translation>le tableau est trop grand&#xa0;:&#xa0;%1</translation>
    </message>
    <message>
        <source>at most %1 values</source>
        <translation>au plus&#xa0;%1 valeurs</translation>
    </message>
    <message>
        <source>the recording has no frames</source>
        <translation>l’enregistrement n’a pas de trames</translation>
    </message>
    <message>
        <source>at least one frame</source>
        <translation>au moins une trame</translation>
    </message>
    <message>
        <source>time_s has %1 times for %2 frames</source>
        <translation>time_s a&#xa0;%1 temps pour&#xa0;%2 trames</translation>
    </message>
    <message>
        <source>the file has times of its own, in time_s</source>
        <translation>le fichier a ses propres temps, dans time_s</translation>
    </message>
    <message>
        <source>no rate</source>
        <translation>pas de fréquence</translation>
    </message>
    <message>
        <source>several arrays can be the frames: %1</source>
        <translation>plusieurs tableaux peuvent être les images&#xa0;:&#xa0;%1</translation>
    </message>
    <message>
        <source>%1 does not say which dimension is the frames</source>
        <translation>%1 ne dit pas laquelle de ses dimensions compte les images</translation>
    </message>
    <message>
        <source>--frame-axis first or last, or a time_s for each frame</source>
        <translation>--frame-axis first ou last, ou un time_s par image</translation>
    </message>
</context>
<context>
    <name>ArrayMessageText</name>
    <message>
        <source>a message has %1 numbers, the file has %2 x %3 taxels</source>
        <translation>un message a %1 nombres, le fichier a %2 x %3 taxels</translation>
    </message>
    <message>
        <source>a message has %1 x %2 numbers, the file has %3 x %4 taxels</source>
        <translation>un message a %1 x %2 nombres, le fichier a %3 x %4 taxels</translation>
    </message>
    <message>
        <source>a message has %1 bytes, its size says %2</source>
        <translation>un message a %1 octets, sa taille en dit %2</translation>
    </message>
    <message>
        <source>a message has %1 sensors</source>
        <translation>un message a %1 capteurs</translation>
    </message>
    <message>
        <source>sensor = &quot;NAME&quot; in the file</source>
        <translation>sensor = &quot;NOM&quot; dans le fichier</translation>
    </message>
    <message>
        <source>a message has %1 dimensions</source>
        <translation>un message a %1 dimensions</translation>
    </message>
    <message>
        <source>rows and columns</source>
        <translation>lignes et colonnes</translation>
    </message>
    <message>
        <source>a message has the encoding &quot;%1&quot;</source>
        <translation>un message a le codage «&#xa0;%1&#xa0;»</translation>
    </message>
</context>
<context>
    <name>BakeText</name>
    <message>
        <source>the pattern has too many corners</source>
        <translation>le motif a trop de points anguleux</translation>
    </message>
    <message>
        <source>at most %1 breakpoints</source>
        <translation>au plus %1 nœuds</translation>
    </message>
</context>
<context>
    <name>Bracelet</name>
    <message>
        <source>The connection to the bracelet was lost.</source>
        <translation>La connexion au bracelet a été perdue.</translation>
    </message>
    <message>
        <source>a feature report of layout version %1</source>
        <translation>un rapport de fonction (feature report) au format de version %1</translation>
    </message>
    <message>
        <source>Bracelet %1</source>
        <translation>Bracelet %1</translation>
    </message>
    <message>
        <source>The device does not respond like a bracelet.</source>
        <translation>L’appareil ne répond pas comme un bracelet.</translation>
    </message>
</context>
<context>
    <name>BraceletContent</name>
    <message>
        <source>Participant</source>
        <translation>Participant</translation>
    </message>
    <message>
        <source>Condition</source>
        <translation>Condition</translation>
    </message>
    <message>
        <source>Track</source>
        <translation>Piste</translation>
    </message>
    <message>
        <source>Best onset, ms</source>
        <translation>Meilleur intervalle, ms</translation>
    </message>
    <message>
        <source>95 %</source>
        <translation>95&#xa0;%</translation>
    </message>
    <message>
        <source>By the law, ms</source>
        <translation>Selon la loi, ms</translation>
    </message>
    <message>
        <source>What it says</source>
        <translation>Ce qu’il indique</translation>
    </message>
    <message>
        <source>Time from burst to burst at which most answers are yes: the top of a parabola on the probit scale</source>
        <translation>Intervalle entre salves pour lequel les réponses «&#xa0;oui&#xa0;» sont les plus nombreuses&#xa0;: le sommet d’une parabole sur l’échelle probit</translation>
    </message>
    <message>
        <source>By the delta method; of all participants Student&apos;s t of their best onsets</source>
        <translation>Par la méthode delta&#xa0;; pour tous les participants, le t de Student de leurs meilleurs intervalles</translation>
    </message>
    <message>
        <source>0.32 times the length of a burst + 47.3 ms, the law of apparent motion</source>
        <translation>0,32 fois la durée d’une salve + 47,3 ms, la loi du mouvement apparent</translation>
    </message>
    <message>
        <source>nobody has a best onset</source>
        <translation>personne n’a de meilleur intervalle</translation>
    </message>
    <message>
        <source>fewer than three times were shown</source>
        <translation>moins de trois intervalles ont été présentés</translation>
    </message>
    <message>
        <source>no onset is best: the answers have no top</source>
        <translation>aucun intervalle n’est le meilleur&#xa0;: les réponses n’ont pas de sommet</translation>
    </message>
    <message>
        <source>best beyond the times that were shown</source>
        <translation>optimum hors des intervalles présentés</translation>
    </message>
    <message>
        <source>mean of %1</source>
        <translation>moyenne de %1</translation>
    </message>
    <message>
        <source>later than the law says</source>
        <translation>plus tard que la loi ne le dit</translation>
    </message>
    <message>
        <source>earlier than the law says</source>
        <translation>plus tôt que la loi ne le dit</translation>
    </message>
    <message>
        <source>agrees with the law</source>
        <translation>conforme à la loi</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Tous</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Pas</translation>
    </message>
    <message>
        <source>Steps of one JND each from the start of the motors to their full drive. The JND is linear between the references, and stays as it is beyond them</source>
        <translation>Pas d’une JND chacun, du démarrage des moteurs à leur pleine commande. La JND est linéaire entre les références et constante au-delà</translation>
    </message>
    <message>
        <source>by the mean JND of all</source>
        <translation>d’après la JND moyenne de tous</translation>
    </message>
    <message numerus="yes">
        <source>by the JND at %n reference(s)</source>
        <translation>
            <numerusform>d’après la JND à %n référence</numerusform>
            <numerusform>d’après la JND à %n références</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 of %2 references have a JND</source>
        <translation>%1 des %2 références ont une JND</translation>
    </message>
    <message>
        <source>Tactor</source>
        <translation>Tacteur</translation>
    </message>
    <message>
        <source>Feels equal at</source>
        <translation>Ressenti égal à</translation>
    </message>
    <message>
        <source>That is, drive</source>
        <translation>Soit, en commande</translation>
    </message>
    <message>
        <source>Full drive now</source>
        <translation>Pleine commande actuelle</translation>
    </message>
    <message>
        <source>Full drive, balanced</source>
        <translation>Pleine commande, équilibrée</translation>
    </message>
    <message>
        <source>Level at which it feels as strong as the reference</source>
        <translation>Niveau auquel il est ressenti aussi fort que la référence</translation>
    </message>
    <message>
        <source>? stands for an open end</source>
        <translation>? indique une borne ouverte</translation>
    </message>
    <message>
        <source>Share of the full voltage, by the motor&apos;s start and full drive</source>
        <translation>Part de la tension maximale, d’après le démarrage et la pleine commande du moteur</translation>
    </message>
    <message>
        <source>Share of the full voltage at intensity 1</source>
        <translation>Part de la tension maximale à l’intensité 1</translation>
    </message>
    <message>
        <source>With it the tactors feel equally strong: the strongest ones are turned down</source>
        <translation>Avec elle les tacteurs sont ressentis aussi forts&#xa0;: les plus forts sont réduits</translation>
    </message>
    <message>
        <source>%1, the reference</source>
        <translation>%1, la référence</translation>
    </message>
    <message>
        <source>Measured against tactor %1, tactor %2 differs by more than both intervals allow.</source>
        <comment>a tactor; a list of tactors</comment>
        <translation>Mesuré par rapport au tacteur %1, le tacteur %2 diffère de plus que ne le permettent les deux intervalles.</translation>
    </message>
</context>
<context>
    <name>BraceletText</name>
    <message>
        <source>No bracelet is plugged in.</source>
        <translation>Aucun bracelet n’est branché.</translation>
    </message>
    <message>
        <source>a USB device %1</source>
        <translation>un appareil USB %1</translation>
    </message>
    <message>
        <source>a USB device %1 with the serial number %2</source>
        <translation>un appareil USB %1 avec le numéro de série %2</translation>
    </message>
    <message>
        <source>No permission to open the bracelet at %1.</source>
        <translation>Le bracelet sur %1 ne peut pas être ouvert, faute d’autorisation.</translation>
    </message>
    <message>
        <source>read and write access, which the udev rule grants</source>
        <translation>un accès en lecture et en écriture, que donne la règle udev</translation>
    </message>
    <message>
        <source>Another program uses the bracelet at %1.</source>
        <translation>Un autre programme utilise le bracelet sur %1.</translation>
    </message>
    <message>
        <source>it to be closed there first</source>
        <translation>qu’il y soit d’abord fermé</translation>
    </message>
    <message>
        <source>The bracelet at %1 cannot be opened.</source>
        <translation>Le bracelet sur %1 ne peut pas être ouvert.</translation>
    </message>
</context>
<context>
    <name>BraceletTexts</name>
    <message>
        <source>STOP is engaged: the bracelet is off.</source>
        <translation>STOP est enclenché&#xa0;: le bracelet est éteint.</translation>
    </message>
    <message>
        <source>No bracelet: what would be played is named in the table of patterns.</source>
        <translation>Pas de bracelet&#xa0;: ce qui serait joué est indiqué dans le tableau des motifs.</translation>
    </message>
    <message>
        <source>Connecting to the bracelet…</source>
        <translation>Connexion au bracelet…</translation>
    </message>
    <message>
        <source>The bracelet is not connected. %1</source>
        <translation>Le bracelet n’est pas connecté. %1</translation>
    </message>
    <message>
        <source>The bracelet does not answer.</source>
        <translation>Le bracelet ne répond pas.</translation>
    </message>
    <message>
        <source>The bracelet is too hot: it is off until it has cooled down.</source>
        <translation>Le bracelet est trop chaud&#xa0;: il est éteint jusqu’à ce qu’il ait refroidi.</translation>
    </message>
    <message>
        <source>A study uses the bracelet.</source>
        <translation>Une étude utilise le bracelet.</translation>
    </message>
    <message>
        <source>The supply of the bracelet is low: %1 V.</source>
        <translation>L’alimentation du bracelet est faible&#xa0;: %1&#xa0;V.</translation>
    </message>
    <message>
        <source>The supply of the bracelet is low.</source>
        <translation>L’alimentation du bracelet est faible.</translation>
    </message>
    <message>
        <source>The bracelet refused what was played last: it did not understand it.</source>
        <translation>Le bracelet a refusé ce qui a été joué en dernier&#xa0;: il ne l’a pas compris.</translation>
    </message>
    <message>
        <source>The motors are not calibrated (page Calibrate).</source>
        <translation>Les moteurs ne sont pas étalonnés (page Étalonnage).</translation>
    </message>
    <message>
        <source>too hot: off until it has cooled down</source>
        <translation>trop chaud&#xa0;: éteint jusqu’à ce qu’il ait refroidi</translation>
    </message>
    <message>
        <source>supply low</source>
        <translation>alimentation faible</translation>
    </message>
    <message>
        <source>frames refused: %1</source>
        <translation>trames refusées&#xa0;: %1</translation>
    </message>
    <message>
        <source>supply %1 V</source>
        <translation>alimentation %1&#xa0;V</translation>
    </message>
    <message>
        <source>temperature %1 °C</source>
        <translation>température %1&#xa0;°C</translation>
    </message>
    <message>
        <source>Bracelet</source>
        <translation>Bracelet</translation>
    </message>
    <message>
        <source>not calibrated: the motors are assumed</source>
        <translation>non étalonnés&#xa0;: les moteurs sont supposés</translation>
    </message>
    <message>
        <source>confirmed: played by the callback of the sound card</source>
        <translation>confirmé&#xa0;: joué par la fonction de rappel de la carte son</translation>
    </message>
    <message>
        <source>latency at most %1 ms, as stated, not measured</source>
        <translation>latence d’au plus %1 ms, annoncée, non mesurée</translation>
    </message>
    <message>
        <source>callback takes %1 % of a period, longest %2 %</source>
        <translation>la fonction de rappel prend %1&#xa0;% d’une période, au plus %2&#xa0;%</translation>
    </message>
    <message>
        <source>periods missed: %1</source>
        <translation>périodes manquées&#xa0;: %1</translation>
    </message>
</context>
<context>
    <name>CalibrateCommand</name>
    <message>
        <source>Pairs</source>
        <translation>Paires</translation>
    </message>
    <message>
        <source>Kept</source>
        <translation>Gardées</translation>
    </message>
    <message>
        <source>3D to 2D</source>
        <translation>3D vers 2D</translation>
    </message>
    <message>
        <source>%1 px on average, %2 px rms</source>
        <translation>%1 px en moyenne, %2 px RMS</translation>
    </message>
    <message>
        <source>2D to 3D</source>
        <translation>2D vers 3D</translation>
    </message>
    <message>
        <source>%1 mm on average</source>
        <translation>%1 mm en moyenne</translation>
    </message>
    <message>
        <source>Uncertainty</source>
        <translation>Incertitude</translation>
    </message>
    <message>
        <source>%1 mm of a point on the surface, by the camera alone</source>
        <translation>%1 mm pour un point de la surface, due à la caméra seule</translation>
    </message>
    <message>
        <source>Valid radius</source>
        <translation>Rayon valide</translation>
    </message>
    <message>
        <source>%1 px</source>
        <translation>%1 px</translation>
    </message>
    <message>
        <source>Focal lengths</source>
        <translation>Focales</translation>
    </message>
    <message>
        <source>%1, %2 px</source>
        <translation>%1, %2 px</translation>
    </message>
    <message>
        <source>Principal point</source>
        <translation>Point principal</translation>
    </message>
    <message>
        <source>Camera centre</source>
        <translation>Centre de la caméra</translation>
    </message>
    <message>
        <source>%1, %2, %3 m</source>
        <translation>%1, %2, %3 m</translation>
    </message>
    <message>
        <source>Mirrored</source>
        <translation>Image miroir</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>oui</translation>
    </message>
    <message>
        <source>no</source>
        <translation>non</translation>
    </message>
    <message>
        <source>Residuals</source>
        <translation>Résidus</translation>
    </message>
    <message>
        <source>without a pattern</source>
        <translation>sans structure</translation>
    </message>
    <message>
        <source>Camera and lens of a tactile cylinder from pairs of pixels and points</source>
        <translation>Caméra et objectif d’un cylindre tactile d’après des paires de pixels et de points</translation>
    </message>
    <message>
        <source>CSV with the columns u_px,v_px,x_m,y_m,z_m, at least 6 rows</source>
        <translation>CSV avec les colonnes u_px,v_px,x_m,y_m,z_m, au moins 6 lignes</translation>
    </message>
    <message>
        <source>Width of the image, px</source>
        <translation>Largeur de l’image, px</translation>
    </message>
    <message>
        <source>Height of the image, px</source>
        <translation>Hauteur de l’image, px</translation>
    </message>
    <message>
        <source>Radius of the elastomer, mm</source>
        <translation>Rayon de l’élastomère, mm</translation>
    </message>
    <message>
        <source>Length of the elastomer, from z = 0 of the sensor frame, mm</source>
        <translation>Longueur de l’élastomère, depuis z = 0 du repère du capteur, mm</translation>
    </message>
    <message>
        <source>robust: camera and lens, wrong pairs are left out; paper: linear, without a lens, drops pairs that are off by more than 2 mm</source>
        <translation>robust&#xa0;: caméra et objectif, les paires fausses sont écartées&#xa0;; paper&#xa0;: linéaire, sans objectif, écarte les paires à plus de 2 mm</translation>
    </message>
    <message>
        <source>Write the camera to this file</source>
        <translation>Écrire la caméra dans ce fichier</translation>
    </message>
    <message>
        <source>The points are holes of a shell: their x and y times this factor are on the elastomer (the paper&apos;s shell: 0.97)</source>
        <translation>Les points sont les trous d’une coque&#xa0;: leurs x et y multipliés par ce facteur sont sur l’élastomère (coque de l’article&#xa0;: 0,97)</translation>
    </message>
    <message>
        <source>The camera that was written has no lens: it is off by %1 mm on average over the pairs that it kept (%2 of %3).</source>
        <translation>La caméra écrite n’a pas d’objectif&#xa0;: elle s’écarte de %1 mm en moyenne sur les paires qu’elle a gardées (%2 sur %3).</translation>
    </message>
    <message>
        <source>the camera is written to this file</source>
        <translation>la caméra est écrite dans ce fichier</translation>
    </message>
    <message>
        <source>neighbours are alike: the camera does not explain everything in the pairs</source>
        <translation>les voisins se ressemblent&#xa0;: les paires contiennent un effet que cette caméra ne décrit pas</translation>
    </message>
    <message>
        <source>Write each pair and its residual as CSV</source>
        <translation>Écrire en CSV chaque paire avec ce que la caméra en fait</translation>
    </message>
    <message>
        <source>Reliable</source>
        <translation>Fiable</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>Avertissement</translation>
    </message>
</context>
<context>
    <name>Camera</name>
    <message>
        <source>camera %1 cannot be opened</source>
        <translation>la caméra %1 ne peut pas être ouverte</translation>
    </message>
    <message>
        <source>the file does not exist</source>
        <translation>le fichier n’existe pas</translation>
    </message>
    <message>
        <source>this is a folder</source>
        <translation>c’est un dossier</translation>
    </message>
    <message>
        <source>a video, or the number of a camera</source>
        <translation>une vidéo, ou le numéro d’une caméra</translation>
    </message>
    <message>
        <source>a video, a pattern like frame_%04d.png, or the number of a camera</source>
        <translation>une vidéo, un modèle comme frame_%04d.png, ou le numéro d’une caméra</translation>
    </message>
    <message>
        <source>camera %1</source>
        <translation>la caméra %1</translation>
    </message>
    <message>
        <source>no frame arrived</source>
        <translation>aucune image n’arrive</translation>
    </message>
    <message>
        <source>the file is not a readable video</source>
        <translation>le fichier n’est pas une vidéo lisible</translation>
    </message>
    <message>
        <source>this is a pipe</source>
        <translation>c’est un tube</translation>
    </message>
</context>
<context>
    <name>CameraPicture</name>
    <message>
        <source>Contact %1</source>
        <translation>Contact %1</translation>
    </message>
    <message>
        <source>at %1 along the tube, %2° around it</source>
        <translation>à %1 le long du tube, %2° autour</translation>
    </message>
    <message>
        <source>standard deviation %1</source>
        <translation>écart-type %1</translation>
    </message>
    <message>
        <source>moved %1 since it began</source>
        <translation>déplacé de %1 depuis son début</translation>
    </message>
    <message>
        <source>%1 deep</source>
        <translation>profondeur %1</translation>
    </message>
    <message>
        <source>No picture yet</source>
        <translation>Pas encore d’image</translation>
    </message>
    <message>
        <source>BUMP</source>
        <translation>CHOC</translation>
    </message>
    <message>
        <source>followed</source>
        <translation>suivi</translation>
    </message>
    <message>
        <source>PAUSED</source>
        <translation>EN PAUSE</translation>
    </message>
    <message>
        <source>Displacement × %1</source>
        <translation>Déplacement × %1</translation>
    </message>
</context>
<context>
    <name>CameraText</name>
    <message>
        <source>a parameter is out of range</source>
        <translation>un paramètre est hors limites</translation>
    </message>
    <message>
        <source>the focal lengths in K are not positive</source>
        <translation>les focales de K ne sont pas positives</translation>
    </message>
    <message>
        <source>the cylinder has no length</source>
        <translation>le cylindre n’a pas de longueur</translation>
    </message>
    <message>
        <source>this is not a camera matrix</source>
        <translation>ce n’est pas une matrice de caméra</translation>
    </message>
    <message>
        <source>R is not a rotation</source>
        <translation>R n’est pas une rotation</translation>
    </message>
    <message>
        <source>the distortion folds on the axis</source>
        <translation>la distorsion se replie déjà sur l’axe</translation>
    </message>
    <message>
        <source>this is not a camera file</source>
        <translation>ce n’est pas un fichier de caméra</translation>
    </message>
    <message>
        <source>the file was written by a newer version</source>
        <translation>le fichier est d’une version plus récente</translation>
    </message>
    <message>
        <source>The camera stopped sending frames.</source>
        <translation>La caméra ne donne plus d’images.</translation>
    </message>
    <message>
        <source>this is not a covariance</source>
        <translation>ce n’est pas une covariance</translation>
    </message>
    <message>
        <source>a symmetric matrix without negative variances</source>
        <translation>une matrice symétrique sans variance négative</translation>
    </message>
</context>
<context>
    <name>CertificateText</name>
    <message>
        <source>SIGTERM, as when a session ends.</source>
        <translation>SIGTERM, comme à la fin d’une session.</translation>
    </message>
    <message>
        <source>SIGINT, as by Ctrl-C.</source>
        <translation>SIGINT, comme par Ctrl-C.</translation>
    </message>
    <message>
        <source>SIGHUP, as when a terminal closes.</source>
        <translation>SIGHUP, comme à la fermeture d’un terminal.</translation>
    </message>
    <message>
        <source>SIGSTOP, later SIGCONT, as when the computer sleeps.</source>
        <translation>SIGSTOP, puis SIGCONT, comme quand l’ordinateur se met en veille.</translation>
    </message>
    <message>
        <source>The line is cut and cannot be opened for a while.</source>
        <translation>La ligne est coupée et ne peut pas être rouverte pendant un moment.</translation>
    </message>
    <message>
        <source>The driver&apos;s answers are held back.</source>
        <translation>Les réponses du pilote sont retenues.</translation>
    </message>
    <message>
        <source>What the program sends does not arrive.</source>
        <translation>Ce que le programme envoie n’arrive pas.</translation>
    </message>
    <message>
        <source>The driver&apos;s answers are replaced by garbage, by refusals, or by answers to other requests.</source>
        <translation>Les réponses du pilote sont remplacées par des données absurdes, par des refus ou par des réponses à d’autres requêtes.</translation>
    </message>
    <message>
        <source>STOP is engaged.</source>
        <translation>STOP est enclenché.</translation>
    </message>
    <message>
        <source>The recording can no longer grow; then STOP. Timed from STOP.</source>
        <translation>L’enregistrement ne peut plus grandir&#xa0;; puis STOP. Temps compté à partir de STOP.</translation>
    </message>
    <message>
        <source>The program gets no more memory; then STOP. Timed from STOP.</source>
        <translation>Le programme n’obtient plus de mémoire&#xa0;; puis STOP. Temps compté à partir de STOP.</translation>
    </message>
    <message>
        <source>The wall clock is set an hour forward or back; then STOP. Timed from STOP.</source>
        <translation>L’horloge du système est décalée d’une heure&#xa0;; puis STOP. Temps compté à partir de STOP.</translation>
    </message>
    <message>
        <source>No fault was injected.</source>
        <translation>Aucun défaut n’a été injecté.</translation>
    </message>
    <message>
        <source>Passed: after each of %1 faults the motors were at zero within %2 ms. They never restarted by themselves, and no recorded frame was lost. With 95 % confidence, at most %3 % of such faults take longer.</source>
        <translation>Réussi&#xa0;: après chacun des&#xa0;%1 défauts, les moteurs étaient à zéro en&#xa0;%2 ms au plus. Rien n’a continué sans être demandé, et rien des enregistrements n’a été perdu. Avec une confiance de 95&#xa0;%, au plus&#xa0;%3&#xa0;% de tels défauts prennent plus de temps.</translation>
    </message>
    <message>
        <source>Not passed: of %1 faults, %2 left the motors on for more than %3 ms. After %4 of them the motors restarted by themselves. %5 recorded frames were lost, and %6 recordings were damaged.</source>
        <translation>Non réussi&#xa0;: sur&#xa0;%1 défauts,&#xa0;%2 ont laissé les moteurs en marche plus de&#xa0;%3 ms,&#xa0;%4 ont été suivis de mouvements que personne n’avait demandés,&#xa0;%5 trames ont été perdues et&#xa0;%6 enregistrements ont été endommagés.</translation>
    </message>
    <message>
        <source>Time from the fault until the motors were at zero, in ms</source>
        <translation>Temps du défaut jusqu’à la mise à zéro des moteurs, en ms</translation>
    </message>
    <message>
        <source>Fault</source>
        <translation>Défaut</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>Median</source>
        <translation>Médiane</translation>
    </message>
    <message>
        <source>99 %</source>
        <translation>99&#xa0;%</translation>
    </message>
    <message>
        <source>Longest</source>
        <translation>Le plus long</translation>
    </message>
    <message>
        <source>Over the bound</source>
        <translation>Au-delà de la limite</translation>
    </message>
    <message>
        <source>Share, upper limit (%)</source>
        <translation>Part au plus (%)</translation>
    </message>
    <message>
        <source>Restarted by itself</source>
        <translation>Suites non demandées</translation>
    </message>
    <message>
        <source>Frames lost</source>
        <translation>Trames perdues</translation>
    </message>
    <message>
        <source>Files damaged</source>
        <translation>Fichiers endommagés</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Tous</translation>
    </message>
    <message>
        <source>Times until the motors were at zero, by kind of fault</source>
        <translation>Temps jusqu’à la mise à zéro des moteurs, pour chaque type</translation>
    </message>
    <message>
        <source>Time until zero (ms)</source>
        <translation>Temps jusqu’à zéro (ms)</translation>
    </message>
    <message>
        <source>bound</source>
        <translation>limite</translation>
    </message>
    <message>
        <source>System under test</source>
        <translation>Ce qui a été examiné</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>Élément</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Programme</translation>
    </message>
    <message>
        <source>Driver of the motors</source>
        <translation>Pilote des moteurs</translation>
    </message>
    <message>
        <source>%1 (SIMULATED)</source>
        <translation>%1 (SIMULÉ)</translation>
    </message>
    <message>
        <source>Started</source>
        <translation>Début</translation>
    </message>
    <message>
        <source>System</source>
        <translation>Système</translation>
    </message>
    <message>
        <source>Processor</source>
        <translation>Processeur</translation>
    </message>
    <message numerus="yes">
        <source>%1, %n core(s)</source>
        <translation>
            <numerusform>%1,&#xa0;%n cœur</numerusform>
            <numerusform>%1,&#xa0;%n cœurs</numerusform>
        </translation>
    </message>
    <message>
        <source>Load average (1 min)</source>
        <translation>Charge de la dernière minute</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Graine</translation>
    </message>
    <message>
        <source>Killed</source>
        <translation>Tué</translation>
    </message>
    <message>
        <source>Terminated</source>
        <translation>Terminé</translation>
    </message>
    <message>
        <source>Interrupted</source>
        <translation>Interrompu</translation>
    </message>
    <message>
        <source>Terminal closed</source>
        <translation>Terminal fermé</translation>
    </message>
    <message>
        <source>Put to sleep</source>
        <translation>Mis en veille</translation>
    </message>
    <message>
        <source>Unplugged</source>
        <translation>Débranché</translation>
    </message>
    <message>
        <source>Answers late</source>
        <translation>Réponses tardives</translation>
    </message>
    <message>
        <source>Requests lost</source>
        <translation>Requêtes perdues</translation>
    </message>
    <message>
        <source>Answers wrong</source>
        <translation>Réponses fausses</translation>
    </message>
    <message>
        <source>STOP</source>
        <translation>STOP</translation>
    </message>
    <message>
        <source>Disk full, STOP</source>
        <translation>Disque plein, STOP</translation>
    </message>
    <message>
        <source>Memory refused, STOP</source>
        <translation>Mémoire refusée, STOP</translation>
    </message>
    <message>
        <source>Clock set, STOP</source>
        <translation>Horloge décalée, STOP</translation>
    </message>
    <message>
        <source>SIMULATED: the driver of the motors is a program.</source>
        <translation>SIMULÉ&#xa0;: le pilote des moteurs est un programme.</translation>
    </message>
    <message>
        <source>Faults</source>
        <translation>Défauts</translation>
    </message>
    <message>
        <source>What each fault does</source>
        <translation>Ce qu’est chaque défaut</translation>
    </message>
    <message>
        <source>en</source>
        <comment>language of the page, as BCP 47 has it</comment>
        <translation>fr</translation>
    </message>
    <message>
        <source>Certificate of faults</source>
        <translation>Certificat d’injection de défauts</translation>
    </message>
    <message>
        <source>The program is ended by SIGKILL. Only what watches over the device is left.</source>
        <translation>Le programme est terminé par SIGKILL. Seul ce qui veille sur l’appareil reste.</translation>
    </message>
    <message>
        <source>Passed: after each of %1 faults the arm was at rest within %2 ms. It never moved again by itself. With 95 % confidence, at most %3 % of such faults take longer.</source>
        <translation>Réussi&#xa0;: après chacune des %1 pannes, le bras était au repos en moins de %2 ms. Il n’a jamais bougé de nouveau de lui-même. Avec une confiance de 95&#xa0;%, au plus %3&#xa0;% de telles pannes durent plus longtemps.</translation>
    </message>
    <message>
        <source>Not passed: of %1 faults, %2 left the arm moving for more than %3 ms. After %4 of them it moved again by itself.</source>
        <translation>Échoué&#xa0;: sur %1 pannes, %2 ont laissé le bras en mouvement pendant plus de %3 ms. Après %4 d’entre elles, il a bougé de nouveau de lui-même.</translation>
    </message>
    <message>
        <source>Time from the fault until the arm was at rest, in ms</source>
        <translation>Temps de la panne jusqu’au repos du bras, en ms</translation>
    </message>
    <message>
        <source>Times until the arm was at rest, by kind of fault</source>
        <translation>Temps jusqu’au repos du bras, par sorte de panne</translation>
    </message>
    <message>
        <source>Time until rest (ms)</source>
        <translation>Temps jusqu’au repos (ms)</translation>
    </message>
    <message>
        <source>Arm</source>
        <translation>Bras</translation>
    </message>
    <message>
        <source>Longest gap between two readings</source>
        <translation>Plus long intervalle entre deux lectures</translation>
    </message>
    <message>
        <source>SIMULATED: the arm is a program.</source>
        <translation>SIMULÉ&#xa0;: le bras est un programme.</translation>
    </message>
</context>
<context>
    <name>CertifyCommand</name>
    <message>
        <source>File of a Modbus motor driver over TCP; default: a simulated one. Nobody may wear its motors: they run the whole time</source>
        <translation>Fichier d’un pilote de moteurs Modbus sur TCP&#xa0;; par défaut&#xa0;: un pilote simulé. Personne ne doit porter ses moteurs, qui tournent tout le temps</translation>
    </message>
    <message>
        <source>Number of faults</source>
        <translation>Nombre de défauts</translation>
    </message>
    <message>
        <source>Seed for the order and timing of the faults</source>
        <translation>Graine de l’ordre et des phases des défauts</translation>
    </message>
    <message>
        <source>Name of the report: NAME.html and NAME.json are written</source>
        <translation>Où va le rapport&#xa0;: NAME.html et NAME.json</translation>
    </message>
    <message>
        <source>the motors will run the whole time; make sure that nobody wears them, then add --yes</source>
        <translation>les moteurs tourneront tout le temps&#xa0;; retirez-les à tout le monde et ajoutez --yes</translation>
    </message>
    <message>
        <source>the device has no motors</source>
        <translation>l’appareil n’a pas de moteurs</translation>
    </message>
    <message>
        <source>a table [tactors]</source>
        <translation>une table [tactors]</translation>
    </message>
    <message>
        <source>only a driver over TCP can be certified</source>
        <translation>des défauts de ligne ne peuvent être injectés que dans une ligne TCP</translation>
    </message>
    <message>
        <source>The certificate was not passed.</source>
        <translation>Le certificat n’est pas obtenu.</translation>
    </message>
    <message>
        <source>The program under test follows a simulated array by live setpoints, drives the motors within their limits, and records.</source>
        <translation>Le programme testé suit une matrice simulée par des consignes en direct, commande les moteurs dans leurs limites et enregistre.</translation>
    </message>
    <message>
        <source>The driver of the motors is SIMULATED: a Modbus server with a watchdog of 100 ms.</source>
        <translation>Le pilote des moteurs est SIMULÉ&#xa0;: un serveur Modbus avec un chien de garde de 100 ms.</translation>
    </message>
    <message>
        <source>A damaged recording was kept: %1</source>
        <translation>Un enregistrement endommagé a été gardé&#xa0;:&#xa0;%1</translation>
    </message>
    <message>
        <source>%1 faults: median %2, 99 % %3, longest %4 ms; %5 over the bound</source>
        <translation>%1 défauts&#xa0;: médiane&#xa0;%2, 99&#xa0;%&#xa0;%3, le plus long&#xa0;%4 ms&#xa0;;&#xa0;%5 au-delà de la limite</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Tous</translation>
    </message>
    <message>
        <source>Restarted by itself</source>
        <translation>Suites non demandées</translation>
    </message>
    <message>
        <source>Frames lost</source>
        <translation>Trames perdues</translation>
    </message>
    <message>
        <source>Files damaged</source>
        <translation>Fichiers endommagés</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>Rapport</translation>
    </message>
    <message>
        <source>File of an arm over ROS 2, which is certified instead. One of its joints moves to and fro the whole time; nobody may be within its reach</source>
        <translation>Fichier d’un bras sur ROS 2, certifié à la place. Une de ses articulations va et vient tout le temps&#xa0;; personne ne doit être à sa portée</translation>
    </message>
    <message>
        <source>The same with an arm at a site: the file of a console that may move it</source>
        <translation>De même avec un bras d’un site&#xa0;: le fichier d’une console qui peut le déplacer</translation>
    </message>
    <message>
        <source>With --site: file of a viewer, which watches the arm. Default without certificates: the same file</source>
        <translation>Avec --site&#xa0;: fichier d’un observateur, qui surveille le bras. Par défaut, sans certificats&#xa0;: le même fichier</translation>
    </message>
    <message>
        <source>With --site: the arm&apos;s name there; default: the only one</source>
        <translation>Avec --site&#xa0;: le nom du bras sur le site&#xa0;; par défaut, le seul</translation>
    </message>
    <message>
        <source>With --arm and --site: joint that moves</source>
        <translation>Avec --arm et --site&#xa0;: articulation qui bouge</translation>
    </message>
    <message>
        <source>Nobody wears the motors of --bracelet, or is within reach of the arm</source>
        <translation>Personne ne porte les moteurs de --bracelet, ni n’est à portée du bras</translation>
    </message>
    <message>
        <source>Longest time until the motors must be at zero or the arm at rest; default: %1, with an arm %2</source>
        <translation>Plus long temps jusqu’à ce que les moteurs soient à zéro ou le bras au repos&#xa0;; par défaut&#xa0;: %1, avec un bras %2</translation>
    </message>
    <message>
        <source>--joint is needed, the joint that moves to and fro</source>
        <translation>--joint est nécessaire&#xa0;: l’articulation qui va et vient</translation>
    </message>
    <message>
        <source>%1 is no fault of an arm&apos;s chain</source>
        <translation>%1 n’est pas une panne de la chaîne d’un bras</translation>
    </message>
    <message>
        <source>the arm will move the whole time; make sure that nobody is within its reach, then add --yes</source>
        <translation>le bras bougera tout le temps&#xa0;; assurez-vous que personne n’est à sa portée, puis ajoutez --yes</translation>
    </message>
    <message>
        <source>The program under test moves %1 to and fro at %2 (rad/s, prismatic m/s). It has its own connection; the arm is watched over another one.</source>
        <translation>Le programme testé fait aller et venir %1 à %2 (rad/s, prismatique m/s). Il a sa propre connexion&#xa0;; le bras est surveillé par une autre.</translation>
    </message>
    <message>
        <source>Ended early: %1 of %2 faults were injected.</source>
        <translation>Terminé avant la fin&#xa0;: %1 pannes sur %2 ont été injectées.</translation>
    </message>
    <message>
        <source>Not covered: faults of the network, of the site and of the arm&apos;s controller.</source>
        <translation>Non couvert&#xa0;: les pannes du réseau, du site et du contrôleur du bras.</translation>
    </message>
    <message>
        <source>Not covered: bracelets that are not Modbus drivers over TCP.</source>
        <translation>Non couvert&#xa0;: les bracelets qui ne sont pas des pilotes Modbus sur TCP.</translation>
    </message>
    <message>
        <source>With --arm and --site: its speed in rad/s, prismatic m/s. It turns back after half a second of motion to each side</source>
        <translation>Avec --arm et --site&#xa0;: sa vitesse en rad/s, prismatique en m/s. Elle fait demi-tour après une demi-seconde de mouvement de chaque côté</translation>
    </message>
    <message>
        <source>Kinds of faults, separated by commas: %1. Default: all but clock_step, which sets the clock of this computer; for an arm, also without faults of the line and of the recording</source>
        <translation>Sortes de pannes, séparées par des virgules&#xa0;: %1. Par défaut&#xa0;: toutes sauf clock_step, qui règle l’horloge de cet ordinateur&#xa0;; pour un bras, sans celles de la ligne et de l’enregistrement non plus</translation>
    </message>
    <message>
        <source>Inject faults into the program that drives motors or an arm, and report how soon they stop</source>
        <translation>Injecter des pannes dans le programme qui commande des moteurs ou un bras, et indiquer en combien de temps ils s’arrêtent</translation>
    </message>
</context>
<context>
    <name>ChainText</name>
    <message>
        <source>the robot has no link &apos;%1&apos;</source>
        <translation>le robot n’a pas de segment «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>one of %1</source>
        <translation>l’un de %1</translation>
    </message>
    <message>
        <source>the link &apos;%1&apos; does not hang on &apos;%2&apos;</source>
        <translation>le segment «&#xa0;%1&#xa0;» n’est pas rattaché à «&#xa0;%2&#xa0;»</translation>
    </message>
    <message>
        <source>a base from which joints lead to the tip</source>
        <translation>une base d’où des articulations mènent au bout</translation>
    </message>
    <message>
        <source>no joint between &apos;%1&apos; and &apos;%2&apos; moves</source>
        <translation>aucune articulation entre «&#xa0;%1&#xa0;» et «&#xa0;%2&#xa0;» ne bouge</translation>
    </message>
    <message>
        <source>at least one revolute, continuous or prismatic joint</source>
        <translation>au moins une articulation revolute, continuous ou prismatic</translation>
    </message>
    <message>
        <source>%1 joints move the tip</source>
        <translation>%1 articulations bougent le bout</translation>
    </message>
    <message>
        <source>at most %1</source>
        <translation>au plus %1</translation>
    </message>
    <message>
        <source>a joint that moves &apos;%1&apos; moves the tip as well</source>
        <translation>une articulation qui bouge «&#xa0;%1&#xa0;» bouge aussi le bout</translation>
    </message>
    <message>
        <source>a base that stands still while the tip moves</source>
        <translation>une base qui reste immobile pendant que le bout bouge</translation>
    </message>
</context>
<context>
    <name>ChartText</name>
    <message>
        <source>correct answers</source>
        <translation>réponses correctes</translation>
    </message>
    <message>
        <source>correct, %</source>
        <translation>correctes,&#xa0;%</translation>
    </message>
    <message>
        <source>chance</source>
        <translation>hasard</translation>
    </message>
    <message>
        <source>correct answers by pattern</source>
        <translation>réponses correctes par motif</translation>
    </message>
    <message>
        <source>response times</source>
        <translation>temps de réponse</translation>
    </message>
    <message>
        <source>median of correct answers, s</source>
        <translation>médiane des réponses correctes, s</translation>
    </message>
    <message>
        <source>information transfer</source>
        <translation>transfert d’information</translation>
    </message>
    <message>
        <source>bit</source>
        <translation>bit</translation>
    </message>
    <message>
        <source>all patterns told apart</source>
        <translation>tous les motifs distingués</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>mesuré</translation>
    </message>
    <message>
        <source>less bias</source>
        <translation>sans biais</translation>
    </message>
</context>
<context>
    <name>CliSiteText</name>
    <message>
        <source>no site was found in domain %1</source>
        <translation>aucun site n’a été trouvé dans le domaine %1</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>Enregistrement</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>Durée</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>Trames</translation>
    </message>
    <message>
        <source>Dropped here</source>
        <translation>Perdues ici</translation>
    </message>
</context>
<context>
    <name>ComparisonContent</name>
    <message>
        <source>Effect</source>
        <translation>Effet</translation>
    </message>
    <message>
        <source>Pattern</source>
        <translation>Motif</translation>
    </message>
    <message>
        <source>Pair</source>
        <translation>Paire</translation>
    </message>
    <message>
        <source>n</source>
        <translation>n</translation>
    </message>
    <message>
        <source>Difference %</source>
        <translation>Différence&#xa0;%</translation>
    </message>
    <message>
        <source>95 %</source>
        <translation>95&#xa0;%</translation>
    </message>
    <message>
        <source>t</source>
        <translation>t</translation>
    </message>
    <message>
        <source>p</source>
        <translation>p</translation>
    </message>
    <message>
        <source>p Holm</source>
        <translation>p Holm</translation>
    </message>
    <message>
        <source>d_z</source>
        <translation>d_z</translation>
    </message>
    <message>
        <source>d_z 95 %</source>
        <translation>d_z 95&#xa0;%</translation>
    </message>
    <message>
        <source>d_av</source>
        <translation>d_av</translation>
    </message>
    <message>
        <source>g_z</source>
        <translation>g_z</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Remarque</translation>
    </message>
    <message>
        <source>A comparison of the conditions for this pattern alone</source>
        <translation>Comparaison des conditions pour ce seul motif</translation>
    </message>
    <message>
        <source>The first minus the second</source>
        <translation>La première moins la seconde</translation>
    </message>
    <message>
        <source>Participants with both values</source>
        <translation>Participants avec les deux valeurs</translation>
    </message>
    <message>
        <source>Of the difference, not corrected</source>
        <translation>De la différence, non corrigé</translation>
    </message>
    <message>
        <source>Paired t test</source>
        <translation>Test t apparié</translation>
    </message>
    <message>
        <source>Corrected over all pairs of the effect; over all patterns where the conditions are compared within them</source>
        <translation>Corrigé sur toutes les paires de l’effet&#xa0;; sur tous les motifs là où les conditions sont comparées au sein de chacun</translation>
    </message>
    <message>
        <source>Difference over the standard deviation of the differences</source>
        <translation>Différence divisée par l’écart-type des différences</translation>
    </message>
    <message>
        <source>From the noncentral t distribution, not corrected</source>
        <translation>D’après la loi t non centrée, non corrigé</translation>
    </message>
    <message>
        <source>Difference over the mean standard deviation of the two</source>
        <translation>Différence divisée par l’écart-type moyen des deux</translation>
    </message>
    <message>
        <source>d_z with Hedges&apos; correction</source>
        <translation>d_z avec la correction de Hedges</translation>
    </message>
    <message>
        <source>W+</source>
        <translation>W+</translation>
    </message>
    <message>
        <source>W−</source>
        <translation>W−</translation>
    </message>
    <message>
        <source>r</source>
        <translation>r</translation>
    </message>
    <message>
        <source>Sum of the ranks of positive differences</source>
        <translation>Somme des rangs des différences positives</translation>
    </message>
    <message>
        <source>Sum of the ranks of negative differences</source>
        <translation>Somme des rangs des différences négatives</translation>
    </message>
    <message>
        <source>Wilcoxon&apos;s signed rank test with Pratt&apos;s zeros; exact up to 25 differences</source>
        <translation>Test des rangs signés de Wilcoxon avec les zéros selon Pratt&#xa0;; exact jusqu’à 25 différences</translation>
    </message>
    <message>
        <source>Corrected over all pairs of the effect</source>
        <translation>Corrigé sur toutes les paires de l’effet</translation>
    </message>
    <message>
        <source>Rank-biserial correlation</source>
        <translation>Corrélation bisériale de rangs</translation>
    </message>
    <message>
        <source>partial eta²</source>
        <translation>êta² partiel</translation>
    </message>
    <message>
        <source>Friedman χ²</source>
        <translation>χ² de Friedman</translation>
    </message>
    <message>
        <source>df</source>
        <translation>ddl</translation>
    </message>
    <message>
        <source>Kendall&apos;s W</source>
        <translation>W de Kendall</translation>
    </message>
    <message>
        <source>From the noncentral F distribution; only with sphericity, eps GG at least 0.75</source>
        <translation>D’après la loi F non centrée&#xa0;; seulement avec sphéricité, eps GG d’au moins 0.75</translation>
    </message>
    <message>
        <source>By ranks, of three levels and more</source>
        <translation>Par les rangs, à partir de trois niveaux</translation>
    </message>
    <message>
        <source>Of Friedman&apos;s test</source>
        <translation>Du test de Friedman</translation>
    </message>
    <message>
        <source>Concordance of the participants</source>
        <translation>Concordance des participants</translation>
    </message>
    <message>
        <source>Term</source>
        <translation>Terme</translation>
    </message>
    <message>
        <source>Estimate</source>
        <translation>Estimation</translation>
    </message>
    <message>
        <source>SE</source>
        <translation>Erreur type</translation>
    </message>
    <message>
        <source>Odds ratio</source>
        <translation>Rapport de cotes</translation>
    </message>
    <message>
        <source>Logit of a right answer</source>
        <translation>Logit d’une réponse correcte</translation>
    </message>
    <message>
        <source>Wald&apos;s interval</source>
        <translation>Intervalle de Wald</translation>
    </message>
    <message>
        <source>intercept (%1)</source>
        <translation>ordonnée à l’origine (%1)</translation>
    </message>
    <message>
        <source>A model of single answers needs at least 5 participants.</source>
        <translation>Un modèle des réponses individuelles demande au moins 5 participants.</translation>
    </message>
    <message>
        <source>No model of single answers: under one condition all answers are right, or all wrong, so that its effect has no finite estimate.</source>
        <translation>Pas de modèle des réponses individuelles&#xa0;: dans une condition, toutes les réponses sont correctes, ou toutes fausses, si bien que son effet n’a pas d’estimation finie.</translation>
    </message>
    <message>
        <source>No model of single answers: the search has found no maximum.</source>
        <translation>Pas de modèle des réponses individuelles&#xa0;: la recherche n’a pas trouvé de maximum.</translation>
    </message>
    <message>
        <source>Each participant has an own intercept, with a standard deviation of %1.</source>
        <translation>Chaque participant a sa propre ordonnée à l’origine, avec un écart-type de %1.</translation>
    </message>
    <message>
        <source>The participants do not differ more than chance makes them.</source>
        <translation>Les participants ne diffèrent pas plus que par hasard.</translation>
    </message>
    <message>
        <source>Conditions: likelihood ratio χ²(%1) = %2, p %3.</source>
        <translation>Conditions&#xa0;: rapport de vraisemblance χ²(%1) = %2, p %3.</translation>
    </message>
    <message>
        <source>Ratio</source>
        <translation>Rapport</translation>
    </message>
    <message>
        <source>The first divided by the second</source>
        <translation>La première divisée par la seconde</translation>
    </message>
    <message>
        <source>Participants with times under both</source>
        <translation>Participants avec des temps dans les deux</translation>
    </message>
    <message>
        <source>Of the geometric means of the response times of right answers</source>
        <translation>Des moyennes géométriques des temps de réponse des réponses correctes</translation>
    </message>
    <message>
        <source>Paired t test of the mean logarithms</source>
        <translation>Test t apparié des logarithmes moyens</translation>
    </message>
    <message>
        <source>Right answers given within a time</source>
        <translation>Réponses correctes données en un temps donné</translation>
    </message>
    <message>
        <source>s from the onset</source>
        <translation>s depuis le début</translation>
    </message>
    <message>
        <source>answered, %</source>
        <translation>réponses données,&#xa0;%</translation>
    </message>
    <message>
        <source>Rule</source>
        <translation>Règle</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Valeur</translation>
    </message>
    <message>
        <source>Made</source>
        <translation>Fixée</translation>
    </message>
    <message>
        <source>Trials before</source>
        <translation>Essais avant</translation>
    </message>
    <message>
        <source>Trials</source>
        <translation>Essais</translation>
    </message>
    <message>
        <source>Sessions</source>
        <translation>Sessions</translation>
    </message>
    <message>
        <source>Participants</source>
        <translation>Participants</translation>
    </message>
    <message>
        <source>Before the data, in the protocol, or after them</source>
        <translation>Avant les données, dans le protocole, ou après elles</translation>
    </message>
    <message>
        <source>What the rules before have left</source>
        <translation>Ce que les règles précédentes ont laissé</translation>
    </message>
    <message>
        <source>Left out</source>
        <translation>Écartés</translation>
    </message>
    <message>
        <source>Left out as a whole</source>
        <translation>Écartés en entier</translation>
    </message>
    <message numerus="yes">
        <source>no spread of the times in %n case(s): nothing left out</source>
        <translation>
            <numerusform>pas de dispersion des temps dans %n cas&#xa0;: rien n’est écarté</numerusform>
            <numerusform>pas de dispersion des temps dans %n cas&#xa0;: rien n’est écarté</numerusform>
        </translation>
    </message>
    <message>
        <source>in the file</source>
        <translation>dans le fichier</translation>
    </message>
    <message>
        <source>after the data</source>
        <translation>après les données</translation>
    </message>
    <message>
        <source>before the data</source>
        <translation>avant les données</translation>
    </message>
    <message>
        <source>Condition or effect</source>
        <translation>Condition ou effet</translation>
    </message>
    <message>
        <source>Right %</source>
        <translation>Correctes&#xa0;%</translation>
    </message>
    <message>
        <source>Right % without rules</source>
        <translation>Correctes&#xa0;% sans règles</translation>
    </message>
    <message>
        <source>p GG</source>
        <translation>p GG</translation>
    </message>
    <message>
        <source>p GG without rules</source>
        <translation>p GG sans règles</translation>
    </message>
</context>
<context>
    <name>ComparisonText</name>
    <message>
        <source>Pairs of levels, paired t tests of the shares of correct answers. Holm: corrected over all pairs of the effect. The intervals (95 %) are not corrected</source>
        <translation>Paires de niveaux, tests t appariés des parts de réponses correctes. Holm&#xa0;: corrigé sur toutes les paires de l’effet. Les intervalles (95&#xa0;%) ne sont pas corrigés</translation>
    </message>
    <message>
        <source>Effect</source>
        <translation>Effet</translation>
    </message>
    <message>
        <source>Pair</source>
        <translation>Paire</translation>
    </message>
    <message>
        <source>Participants</source>
        <translation>Participants</translation>
    </message>
    <message>
        <source>Difference, %</source>
        <translation>Différence,&#xa0;%</translation>
    </message>
    <message>
        <source>Interval, %</source>
        <translation>Intervalle,&#xa0;%</translation>
    </message>
    <message>
        <source>p, Holm</source>
        <translation>p, Holm</translation>
    </message>
    <message>
        <source>Interval</source>
        <translation>Intervalle</translation>
    </message>
    <message>
        <source>Remark</source>
        <translation>Remarque</translation>
    </message>
    <message>
        <source>The same pairs by ranks: Wilcoxon&apos;s signed rank test with Pratt&apos;s zeros, exact up to 25 differences</source>
        <translation>Les mêmes paires par les rangs&#xa0;: test des rangs signés de Wilcoxon avec les zéros selon Pratt, exact jusqu’à 25 différences</translation>
    </message>
    <message>
        <source>Rank-biserial r</source>
        <translation>r bisérial de rangs</translation>
    </message>
    <message>
        <source>Friedman&apos;s test of effects with three levels and more</source>
        <translation>Test de Friedman des effets à trois niveaux et plus</translation>
    </message>
    <message>
        <source>df</source>
        <translation>ddl</translation>
    </message>
    <message>
        <source>Kendall&apos;s W</source>
        <translation>W de Kendall</translation>
    </message>
    <message>
        <source>Partial η² with its interval (95 %), where sphericity holds (ε GG at least 0.75)</source>
        <translation>η² partiel avec son intervalle (95&#xa0;%), là où la sphéricité est respectée (ε GG d’au moins 0.75)</translation>
    </message>
    <message>
        <source>Model of single answers</source>
        <translation>Modèle des réponses individuelles</translation>
    </message>
    <message>
        <source>There are no numbers: %1.</source>
        <translation>Il n’y a pas de nombres&#xa0;: %1.</translation>
    </message>
    <message>
        <source>Logit of a correct answer: an intercept that differs between participants, and the conditions against %1; Wald&apos;s intervals (95 %)</source>
        <translation>Logit d’une réponse correcte&#xa0;: une ordonnée à l’origine propre à chaque participant, et les conditions par rapport à %1&#xa0;; intervalles de Wald (95&#xa0;%)</translation>
    </message>
    <message>
        <source>Term</source>
        <translation>Terme</translation>
    </message>
    <message>
        <source>Estimate</source>
        <translation>Estimation</translation>
    </message>
    <message>
        <source>SE</source>
        <translation>Erreur type</translation>
    </message>
    <message>
        <source>Odds ratio</source>
        <translation>Rapport de cotes</translation>
    </message>
    <message>
        <source>intercept (%1)</source>
        <translation>ordonnée à l’origine (%1)</translation>
    </message>
    <message>
        <source>Standard deviation of the participants: %1.</source>
        <translation>Écart-type des participants&#xa0;: %1.</translation>
    </message>
    <message>
        <source>The participants do not differ more than chance makes them.</source>
        <translation>Les participants ne diffèrent pas plus que par hasard.</translation>
    </message>
    <message>
        <source>Conditions: likelihood ratio χ²(%1) = %2, p %3.</source>
        <translation>Conditions&#xa0;: rapport de vraisemblance χ²(%1) = %2, p %3.</translation>
    </message>
    <message>
        <source>Comparisons and effect sizes</source>
        <translation>Comparaisons et tailles d’effet</translation>
    </message>
    <message>
        <source>response times, cumulative</source>
        <translation>temps de réponse, cumulés</translation>
    </message>
    <message>
        <source>time from the onset, s</source>
        <translation>temps depuis le début, s</translation>
    </message>
    <message>
        <source>answered, %</source>
        <translation>réponses données,&#xa0;%</translation>
    </message>
    <message>
        <source>Share of the correct answers of all participants that were given within a time.</source>
        <translation>Part des réponses correctes de tous les participants qui ont été données en un temps donné.</translation>
    </message>
    <message>
        <source>Conditions compared by the participants&apos; geometric means: how many times as long the first takes; paired t tests of the logarithms</source>
        <translation>Conditions comparées par les moyennes géométriques des participants&#xa0;: combien de fois plus de temps prend la première&#xa0;; tests t appariés des logarithmes</translation>
    </message>
    <message>
        <source>Ratio</source>
        <translation>Rapport</translation>
    </message>
</context>
<context>
    <name>ConfusionPicture</name>
    <message>
        <source>answered, % of the row</source>
        <translation>répondu,&#xa0;% de la ligne</translation>
    </message>
    <message>
        <source>answered</source>
        <translation>répondu</translation>
    </message>
    <message>
        <source>presented</source>
        <translation>présenté</translation>
    </message>
</context>
<context>
    <name>ConsoleOptions</name>
    <message>
        <source>--%1 %2: expected a number from %3 to %4</source>
        <translation>--%1 %2&#xa0;: nombre de %3 à %4 attendu</translation>
    </message>
    <message>
        <source>--%1 %2: expected a whole number from %3 to %4</source>
        <translation>--%1 %2&#xa0;: nombre entier de %3 à %4 attendu</translation>
    </message>
    <message>
        <source>FILE</source>
        <translation>FICHIER</translation>
    </message>
    <message>
        <source>Seed of the simulated scenes (default 1).</source>
        <translation>Graine des scènes simulées (par défaut 1).</translation>
    </message>
    <message>
        <source>N</source>
        <translation>N</translation>
    </message>
    <message>
        <source>Rows of the array (default: by the number of taxels).</source>
        <translation>Lignes de la matrice (par défaut d’après le nombre de taxels).</translation>
    </message>
    <message>
        <source>Columns of the array.</source>
        <translation>Colonnes de la matrice.</translation>
    </message>
    <message>
        <source>Distance between taxels in mm.</source>
        <translation>Distance entre taxels en mm.</translation>
    </message>
    <message>
        <source>MM</source>
        <translation>MM</translation>
    </message>
    <message>
        <source>Recording of the unloaded array, subtracted from the frames.</source>
        <translation>Enregistrement de la matrice à vide, soustrait des trames.</translation>
    </message>
    <message>
        <source>The values fall under load.</source>
        <translation>Les valeurs diminuent sous charge.</translation>
    </message>
    <message>
        <source>Load per raw unit (default 1).</source>
        <translation>Charge par unité brute (par défaut 1).</translation>
    </message>
    <message>
        <source>G</source>
        <translation>G</translation>
    </message>
    <message>
        <source>Unit of the loads (default N or counts, by the array).</source>
        <translation>Unité des charges (par défaut N ou counts, selon la matrice).</translation>
    </message>
    <message>
        <source>NAME</source>
        <translation>NOM</translation>
    </message>
    <message>
        <source>Load from which a taxel is in contact (default 0.2).</source>
        <translation>Charge à partir de laquelle un taxel est en contact (par défaut 0.2).</translation>
    </message>
    <message>
        <source>LOAD</source>
        <translation>CHARGE</translation>
    </message>
    <message>
        <source>Play at this rate in Hz instead of the recorded times.</source>
        <translation>Lire à cette fréquence en Hz plutôt qu’aux instants enregistrés.</translation>
    </message>
    <message>
        <source>HZ</source>
        <translation>HZ</translation>
    </message>
    <message>
        <source>Open the sources listed in a TOML file.</source>
        <translation>Ouvrir les sources énumérées dans un fichier TOML.</translation>
    </message>
    <message>
        <source>Page to show: %1.</source>
        <translation>Page à afficher&#xa0;: %1.</translation>
    </message>
    <message>
        <source>light, dark or system.</source>
        <translation>light, dark ou system.</translation>
    </message>
    <message>
        <source>Language, for example en, ja, fr, zh_CN.</source>
        <translation>Langue, par exemple en, ja, fr, zh_CN.</translation>
    </message>
    <message>
        <source>CODE</source>
        <translation>CODE</translation>
    </message>
    <message>
        <source>Save a picture of the window as PNG and quit.</source>
        <translation>Enregistrer une image de la fenêtre en PNG et quitter.</translation>
    </message>
    <message>
        <source>Seconds to wait before the picture (default 3).</source>
        <translation>Secondes d’attente avant l’image (par défaut 3).</translation>
    </message>
    <message>
        <source>S</source>
        <translation>S</translation>
    </message>
    <message>
        <source>Size of the window, for example 1600x1000.</source>
        <translation>Taille de la fenêtre, par exemple 1600x1000.</translation>
    </message>
    <message>
        <source>WxH</source>
        <translation>LxH</translation>
    </message>
    <message>
        <source>Run for so many seconds, print how long the event loop was busy, quit.</source>
        <translation>Tourner pendant tant de secondes, afficher la durée d’occupation de la boucle d’événements, quitter.</translation>
    </message>
    <message>
        <source>Start with the default layout and settings, and save none.</source>
        <translation>Démarrer avec la disposition et les réglages par défaut, sans rien enregistrer.</translation>
    </message>
    <message>
        <source>unexpected argument &quot;%1&quot;</source>
        <translation>argument inattendu «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>--page %1: expected one of %2</source>
        <translation>--page %1&#xa0;: valeurs possibles&#xa0;: %2</translation>
    </message>
    <message>
        <source>--theme %1: expected light, dark or system</source>
        <translation>--theme %1&#xa0;: light, dark ou system attendu</translation>
    </message>
    <message>
        <source>--size %1: expected WIDTHxHEIGHT, from 320x240 to 16384x16384</source>
        <translation>--size %1&#xa0;: LARGEURxHAUTEUR attendu, de 320x240 à 16384x16384</translation>
    </message>
    <message>
        <source>--dock %1: expected one of %2</source>
        <translation>--dock %1&#xa0;: valeurs possibles&#xa0;: %2</translation>
    </message>
    <message>
        <source>Open a simulated scene: a file, or the name of one that comes with the program (repeatable).</source>
        <translation>Ouvrir une scène simulée&#xa0;: un fichier, ou le nom d’une scène fournie avec le programme (répétable).</translation>
    </message>
    <message>
        <source>SCENE</source>
        <translation>SCÈNE</translation>
    </message>
    <message>
        <source>Open a camera in the soft tube by its number, or a video of one.</source>
        <translation>Ouvrir une caméra du tube souple par son numéro, ou une vidéo.</translation>
    </message>
    <message>
        <source>FILE|N</source>
        <translation>FICHIER|N</translation>
    </message>
    <message>
        <source>Calibration of that camera (JSON of teleta calibrate).</source>
        <translation>Étalonnage de cette caméra (JSON de teleta calibrate).</translation>
    </message>
    <message>
        <source>Open a pattern file, or a built-in pattern by its id, on the Patterns page.</source>
        <translation>Ouvrir un fichier de motif, ou un motif intégré par son identifiant, sur la page Motifs.</translation>
    </message>
    <message>
        <source>Folder of your own patterns (default: the user&apos;s data folder).</source>
        <translation>Dossier de vos propres motifs (par défaut&#xa0;: le dossier de données de l’utilisateur).</translation>
    </message>
    <message>
        <source>FOLDER</source>
        <translation>DOSSIER</translation>
    </message>
    <message>
        <source>View of the Operate page (%1) or of the Study page (%2) to bring to the front.</source>
        <translation>Vue de la page Conduite (%1) ou de la page Étude (%2) à mettre au premier plan.</translation>
    </message>
    <message>
        <source>Calibrate the cylinder camera with these pairs (CSV).</source>
        <translation>Étalonner la caméra du cylindre avec ces paires (CSV).</translation>
    </message>
    <message>
        <source>Open the folder of a study, or a protocol (TOML) to begin one with.</source>
        <translation>Ouvrir le dossier d’une étude, ou un protocole (TOML) pour en commencer une.</translation>
    </message>
    <message>
        <source>PATH</source>
        <translation>CHEMIN</translation>
    </message>
    <message>
        <source>Let simulated participants go through the study, which is made if need be.</source>
        <translation>Faire parcourir l’étude, créée au besoin, par des participants simulés.</translation>
    </message>
    <message>
        <source>WHICH</source>
        <translation>LEQUEL</translation>
    </message>
    <message>
        <source>--camera and --camera-model belong together: a camera is of no use without its calibration</source>
        <translation>--camera et --camera-model vont ensemble&#xa0;: une caméra est inutile sans son étalonnage</translation>
    </message>
    <message>
        <source>Play back a recording of this program, or recorded frames, CSV time_s,t0,t1,... (repeatable; the options below go with the recordings in their order).</source>
        <translation>Lire un enregistrement de ce programme, ou des trames enregistrées, CSV time_s,t0,t1,... (répétable&#xa0;; les options ci-dessous s’appliquent aux enregistrements dans leur ordre).</translation>
    </message>
    <message>
        <source>Record all sources and the bracelet into a new file.</source>
        <translation>Enregistrer toutes les sources et le bracelet dans un nouveau fichier.</translation>
    </message>
    <message>
        <source>Bracelet to drive: simulated, usb, none, or a file that describes one.</source>
        <translation>Bracelet à piloter&#xa0;: simulated, usb, none, ou un fichier qui en décrit un.</translation>
    </message>
    <message>
        <source>--language %1: expected en, fr, ja or zh_CN</source>
        <translation>--language %1&#xa0;: attendu en, fr, ja ou zh_CN</translation>
    </message>
    <message>
        <source>Show all sources live to Foxglove on this port (default 8765).</source>
        <translation>Montrer toutes les sources en direct à Foxglove sur ce port (par défaut 8765).</translation>
    </message>
    <message>
        <source>PORT</source>
        <translation>PORT</translation>
    </message>
    <message>
        <source>Address on which the live view listens (default 127.0.0.1: this computer only).</source>
        <translation>Adresse sur laquelle la vue en direct écoute (par défaut 127.0.0.1&#xa0;: cet ordinateur seulement).</translation>
    </message>
    <message>
        <source>ADDRESS</source>
        <translation>ADRESSE</translation>
    </message>
    <message>
        <source>Shows what a remote robot arm touches: where, how hard, how stiff, what shape.

Examples:
  teleta-console --scene tactile-indenter
  teleta-console --replay run.csv --rows 64 --columns 27 --tare empty.csv --threshold 10
  teleta-console session.teleta
  teleta-console --camera 0 --camera-model camera.json
  teleta-console --arm arm.toml
  teleta-console --site lab.toml
  teleta-console --sources both-arrays.toml --theme dark</source>
        <translation>Montre ce que touche un bras robotisé distant&#xa0;: où, avec quelle force, quelle raideur, quelle forme.

Exemples&#xa0;:
  teleta-console --scene tactile-indenter
  teleta-console --replay run.csv --rows 64 --columns 27 --tare empty.csv --threshold 10
  teleta-console session.teleta
  teleta-console --camera 0 --camera-model camera.json
  teleta-console --arm arm.toml
  teleta-console --site lab.toml
  teleta-console --sources both-arrays.toml --theme dark</translation>
    </message>
    <message>
        <source>Recordings (.teleta, .csv, .mcap, .npz, .npy, .h5, .mat), scenes, arms, sites and source lists (.toml) to open.</source>
        <translation>Enregistrements (.teleta, .csv, .mcap, .npz, .npy, .h5, .mat), scènes, bras, sites et listes de sources (.toml) à ouvrir.</translation>
    </message>
    <message>
        <source>Connect to a site where teleta-site runs, by its file (TOML; repeatable).</source>
        <translation>Se connecter à un site où tourne teleta-site, par son fichier (TOML ; répétable).</translation>
    </message>
    <message>
        <source>Open an arm over ROS 2, or the joints that a Modbus device reports, described in a file (TOML; repeatable).</source>
        <translation>Ouvrir un bras par ROS 2, ou les articulations qu’indique un appareil Modbus, décrits dans un fichier (TOML&#xa0;; répétable).</translation>
    </message>
</context>
<context>
    <name>ContactsCommand</name>
    <message>
        <source>Place, force and identity of each contact of each tactile frame</source>
        <translation>Lieu, force et identité de chaque contact de chaque trame tactile</translation>
    </message>
</context>
<context>
    <name>ContourCommand</name>
    <message>
        <source>circle</source>
        <translation>cercle</translation>
    </message>
    <message>
        <source>rectangle</source>
        <translation>rectangle</translation>
    </message>
    <message>
        <source>triangle</source>
        <translation>triangle</translation>
    </message>
    <message>
        <source>arc</source>
        <translation>arc</translation>
    </message>
    <message>
        <source>line</source>
        <translation>ligne</translation>
    </message>
    <message>
        <source>point</source>
        <translation>point</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>inconnue</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Points</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>Forme</translation>
    </message>
    <message>
        <source>%1 (confidence %2)</source>
        <translation>%1 (confiance %2)</translation>
    </message>
    <message>
        <source>Closed</source>
        <translation>Fermé</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>oui</translation>
    </message>
    <message>
        <source>no</source>
        <translation>non</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Longueur</translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation>%1 m</translation>
    </message>
    <message>
        <source>Largest curvature</source>
        <translation>Courbure maximale</translation>
    </message>
    <message>
        <source>%1 1/m</source>
        <translation>%1 1/m</translation>
    </message>
    <message>
        <source>Centre</source>
        <translation>Centre</translation>
    </message>
    <message>
        <source>%1, %2 m</source>
        <translation>%1, %2 m</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Rayon</translation>
    </message>
    <message>
        <source>%1 m (points off by %2 m)</source>
        <translation>%1 m (points écartés de %2 m)</translation>
    </message>
    <message>
        <source>Vertex %1</source>
        <translation>Sommet %1</translation>
    </message>
    <message>
        <source>Shape, vertices and spline of a series of contact points</source>
        <translation>Forme, sommets et spline d’une suite de points de contact</translation>
    </message>
    <message>
        <source>CSV with the columns x_m,y_m, in the order of touch</source>
        <translation>CSV avec les colonnes x_m,y_m, dans l’ordre des touchers</translation>
    </message>
    <message>
        <source>approximating: the points are the control points; interpolating: the curve passes through them</source>
        <translation>approximating&#xa0;: les points sont les points de contrôle&#xa0;; interpolating&#xa0;: la courbe passe par les points</translation>
    </message>
    <message>
        <source>Points of the curve, for the CSV and the largest curvature</source>
        <translation>Points de la courbe, pour le CSV et la courbure maximale</translation>
    </message>
    <message>
        <source>Write the curve as CSV t,x_m,y_m,curvature_per_m, t from 0 to 1</source>
        <translation>Écrire la courbe en CSV t,x_m,y_m,curvature_per_m, t de 0 à 1</translation>
    </message>
    <message>
        <source>the file has no points</source>
        <translation>le fichier n’a pas de points</translation>
    </message>
    <message>
        <source>a coordinate is too large to compute with</source>
        <translation>une coordonnée est trop grande pour le calcul</translation>
    </message>
    <message>
        <source>a row for each contact point, in metres</source>
        <translation>une ligne par point de contact, en mètres</translation>
    </message>
    <message>
        <source>The contour is closed; otherwise the program decides</source>
        <translation>Le contour revient à son début&#xa0;; sinon, c’est déterminé</translation>
    </message>
    <message>
        <source>A contour smaller than this is a point, m</source>
        <translation>Une étendue inférieure à cette valeur est un point, m</translation>
    </message>
    <message>
        <source>Candidates</source>
        <translation>Candidats</translation>
    </message>
</context>
<context>
    <name>ContourPicture</name>
    <message>
        <source>nothing explored yet</source>
        <translation>rien d’exploré pour l’instant</translation>
    </message>
    <message>
        <source>%1, confidence %2 %</source>
        <translation>%1, confiance %2&#xa0;%</translation>
    </message>
    <message>
        <source>Touch an object from several sides: its outline appears here.</source>
        <translation>Touchez un objet de plusieurs côtés&#xa0;: son contour apparaît ici.</translation>
    </message>
    <message numerus="yes">
        <source>%n point(s)</source>
        <translation>
            <numerusform>%n point</numerusform>
            <numerusform>%n points</numerusform>
        </translation>
    </message>
    <message>
        <source>radius %1</source>
        <translation>rayon %1</translation>
    </message>
    <message>
        <source>edges %1</source>
        <translation>arêtes %1</translation>
    </message>
    <message>
        <source>points off by %1 (rms)</source>
        <translation>points écartés de %1 (RMS)</translation>
    </message>
    <message>
        <source>z %1</source>
        <translation>z %1</translation>
    </message>
    <message>
        <source>undecided: %1</source>
        <translation>indécis&#xa0;: %1</translation>
    </message>
    <message>
        <source>x</source>
        <translation>x</translation>
    </message>
    <message>
        <source>y</source>
        <translation>y</translation>
    </message>
</context>
<context>
    <name>CostFigureText</name>
    <message>
        <source>Filled: no other rung is both as quick and as exact. Lines: to the 95 % error and the 99 % time.</source>
        <translation>Pleins&#xa0;: aucun autre échelon n’est à la fois aussi rapide et aussi exact. Traits&#xa0;: jusqu’à l’erreur à 95&#xa0;% et au temps à 99&#xa0;%.</translation>
    </message>
    <message>
        <source>Not measured, the machine was too noisy or there is no error: %1.</source>
        <translation>Non mesuré, machine trop perturbée ou erreur inconnue&#xa0;: %1.</translation>
    </message>
    <message>
        <source>Median time of one call</source>
        <translation>Temps médian d’un appel</translation>
    </message>
    <message>
        <source>Mean error (share)</source>
        <translation>Erreur moyenne (fraction)</translation>
    </message>
    <message>
        <source>Mean error (%1)</source>
        <translation>Erreur moyenne (%1)</translation>
    </message>
    <message>
        <source>Limit: %1</source>
        <translation>Limite&#xa0;: %1</translation>
    </message>
</context>
<context>
    <name>CostFileText</name>
    <message>
        <source>&quot;%1&quot; is not a value of the column %2</source>
        <translation>«&#xa0;%1&#xa0;» n’est pas une valeur de la colonne %2</translation>
    </message>
    <message>
        <source>a number that is not negative, or NA</source>
        <translation>un nombre non négatif, ou NA</translation>
    </message>
    <message>
        <source>yes or no</source>
        <translation>yes ou no</translation>
    </message>
    <message>
        <source>a number of samples</source>
        <translation>un nombre d’échantillons</translation>
    </message>
</context>
<context>
    <name>CostLadder</name>
    <message>
        <source>Calibration of the camera in the tube</source>
        <translation>Étalonnage de la caméra dans le tube</translation>
    </message>
    <message>
        <source>distance of located points of the tube from the true ones; where the calibration is refused the camera of the data sheet stands in</source>
        <translation>distance entre les points localisés du tube et les vrais&#xa0;; si l’étalonnage est refusé, la caméra de la fiche technique le remplace</translation>
    </message>
    <message>
        <source>Contacts in a camera frame</source>
        <translation>Contacts dans une image de caméra</translation>
    </message>
    <message>
        <source>distance from the true contact on the tube; a contact that is missed counts with its distance from the tube&apos;s middle</source>
        <translation>distance au vrai contact sur le tube&#xa0;; un contact manqué compte avec sa distance au milieu du tube</translation>
    </message>
    <message>
        <source>Curve through contact points</source>
        <translation>Courbe passant par des points de contact</translation>
    </message>
    <message>
        <source>distance of the true outline (circle, rectangle, bent profile) from the curve</source>
        <translation>distance du vrai contour (cercle, rectangle, profil coudé) à la courbe</translation>
    </message>
    <message>
        <source>A frame of the scene &quot;tactile-indenter&quot; without one of its effects</source>
        <translation>Une trame de la scène «&#xa0;tactile-indenter&#xa0;» sans l’un de ses effets</translation>
    </message>
    <message>
        <source>difference of a taxel from the scene with all effects, root mean square of a frame</source>
        <translation>écart d’un taxel à la scène avec tous les effets, moyenne quadratique d’une trame</translation>
    </message>
    <message>
        <source>10 ms of an arm that touches rubber</source>
        <translation>10 ms d’un bras qui touche du caoutchouc</translation>
    </message>
    <message>
        <source>largest difference of a joint&apos;s torque from a solution with steps of 2 us</source>
        <translation>plus grand écart du couple d’une articulation à une solution par pas de 2 us</translation>
    </message>
    <message>
        <source>Interval of the information transfer of a study</source>
        <translation>Intervalle du transfert d’information d’une étude</translation>
    </message>
    <message>
        <source>score of the 95 % interval: its width, and 40 times how far the true transfer lies outside of it</source>
        <translation>score de l’intervalle à 95&#xa0;%&#xa0;: sa largeur, plus 40 fois l’écart du vrai transfert hors de l’intervalle</translation>
    </message>
    <message>
        <source>Stiffness of a touched object</source>
        <translation>Raideur d’un objet touché</translation>
    </message>
    <message>
        <source>share of the true stiffness of the object; a bound counts as the value, a refused touch as 1</source>
        <translation>fraction de la vraie raideur de l’objet&#xa0;; une borne compte comme valeur, un toucher refusé comme 1</translation>
    </message>
    <message>
        <source>Place of a contact on a tactile array</source>
        <translation>Lieu d’un contact sur une matrice tactile</translation>
    </message>
    <message>
        <source>distance from the lowest point of the ball that presses</source>
        <translation>distance au point le plus bas de la bille qui appuie</translation>
    </message>
    <message>
        <source>Direction in which a pixel of the wide lens looks</source>
        <translation>Direction visée par un pixel de l’objectif grand angle</translation>
    </message>
    <message>
        <source>angle from the direction of the point of the tube that the pixel shows</source>
        <translation>angle avec la direction du point du tube que montre le pixel</translation>
    </message>
    <message>
        <source>Gains of an array&apos;s taxels from a press</source>
        <translation>Gains des taxels d’une matrice d’après un appui</translation>
    </message>
    <message>
        <source>share of the true gains, root mean square of an array; a taxel that is left out counts as it is</source>
        <translation>part des gains vrais, moyenne quadratique d’une matrice&#xa0;; un taxel laissé de côté compte tel quel</translation>
    </message>
</context>
<context>
    <name>CostWords</name>
    <message>
        <source>twice as fast</source>
        <translation>deux fois plus rapide</translation>
    </message>
    <message>
        <source>%1 times as fast</source>
        <translation>%1 fois plus rapide</translation>
    </message>
    <message>
        <source>takes twice as long</source>
        <translation>prend deux fois plus de temps</translation>
    </message>
    <message>
        <source>takes %1 times as long</source>
        <translation>prend %1 fois plus de temps</translation>
    </message>
    <message>
        <source>Faster: %1, %2.</source>
        <translation>Plus rapide&#xa0;: %1, %2.</translation>
    </message>
    <message>
        <source>No setting is faster.</source>
        <translation>Aucun réglage n’est plus rapide.</translation>
    </message>
    <message>
        <source>In use: %1. It takes %2 and is off by %3 on average.</source>
        <extracomment>A setting, its time, its error</extracomment>
        <translation>Utilisé&#xa0;: %1. Il prend %2 et s’écarte de %3 en moyenne.</translation>
    </message>
    <message>
        <source>%1 takes %2 and is off by %3 on average.</source>
        <translation>%1 prend %2 et s’écarte de %3 en moyenne.</translation>
    </message>
    <message>
        <source>%1 percentage points</source>
        <translation>%1 points de pourcentage</translation>
    </message>
    <message>
        <source>as fast</source>
        <translation>aussi rapide</translation>
    </message>
    <message>
        <source>%1, equally accurate</source>
        <translation>%1, aussi exact</translation>
    </message>
    <message>
        <source>%1, %2 less accurate</source>
        <extracomment>How fast another setting is, and by how much its results are better or worse</extracomment>
        <translation>%1, moins exact de %2</translation>
    </message>
    <message>
        <source>%1, %2 more accurate</source>
        <translation>%1, plus exact de %2</translation>
    </message>
    <message>
        <source>%1 has no time: the machine was too busy. Close other programs and measure again.</source>
        <translation>%1 n’a pas de durée&#xa0;: la machine était trop occupée. Fermez les autres programmes et mesurez de nouveau.</translation>
    </message>
    <message>
        <source>Nothing can do this job in less than %1: this is its limit.</source>
        <translation>Aucune façon de faire ce travail ne prend moins de %1&#xa0;: c’est la limite.</translation>
    </message>
    <message>
        <source>%1 takes %2. It has no error to compare.</source>
        <translation>%1 prend %2. Il n’a pas d’erreur à comparer.</translation>
    </message>
    <message>
        <source>%1 beats it: %2.</source>
        <translation>%1 fait mieux&#xa0;: %2.</translation>
    </message>
    <message>
        <source>More accurate: %1, %2.</source>
        <translation>Plus exact&#xa0;: %1, %2.</translation>
    </message>
    <message>
        <source>No setting is more accurate.</source>
        <translation>Aucun réglage n’est plus exact.</translation>
    </message>
</context>
<context>
    <name>CsvReaderText</name>
    <message>
        <source>opening was interrupted: %1</source>
        <translation>ouverture interrompue&#xa0;: %1</translation>
    </message>
    <message>
        <source>cannot open the file: %1</source>
        <translation>impossible d’ouvrir le fichier&#xa0;: %1</translation>
    </message>
    <message>
        <source>cannot read the file: %1</source>
        <translation>impossible de lire le fichier&#xa0;: %1</translation>
    </message>
    <message>
        <source>this is a folder</source>
        <translation>c’est un dossier</translation>
    </message>
    <message>
        <source>a CSV file</source>
        <translation>un fichier CSV</translation>
    </message>
    <message>
        <source>the file is empty</source>
        <translation>le fichier est vide</translation>
    </message>
    <message>
        <source>a header line with the names of the columns</source>
        <translation>une ligne d’en-tête avec les noms des colonnes</translation>
    </message>
    <message>
        <source>the file is UTF-16</source>
        <translation>le fichier est en UTF-16</translation>
    </message>
    <message>
        <source>UTF-8</source>
        <translation>UTF-8</translation>
    </message>
    <message>
        <source>the line is longer than 16 MiB</source>
        <translation>la ligne dépasse 16 MiB</translation>
    </message>
    <message>
        <source>a closing quote</source>
        <translation>un guillemet fermant</translation>
    </message>
    <message>
        <source>a line end</source>
        <translation>une fin de ligne</translation>
    </message>
    <message>
        <source>a quote is not closed</source>
        <translation>un guillemet n’est pas fermé</translation>
    </message>
    <message>
        <source>a number, nan, inf or NA</source>
        <translation>un nombre, nan, inf ou NA</translation>
    </message>
    <message>
        <source>a finite number</source>
        <translation>un nombre fini</translation>
    </message>
    <message>
        <source>the field is empty</source>
        <translation>le champ est vide</translation>
    </message>
    <message>
        <source>%1 is not a number</source>
        <translation>%1 n’est pas un nombre</translation>
    </message>
    <message>
        <source>%1 is not a finite number</source>
        <translation>%1 n’est pas un nombre fini</translation>
    </message>
    <message>
        <source>missing columns: %1; the file has: %2</source>
        <translation>colonnes manquantes&#xa0;: %1&#xa0;; le fichier contient&#xa0;: %2</translation>
    </message>
    <message>
        <source>the columns %1</source>
        <translation>les colonnes %1</translation>
    </message>
    <message>
        <source>the row is too long: more than %1 values</source>
        <translation>la ligne est trop longue&#xa0;: plus de %1 valeurs</translation>
    </message>
    <message>
        <source>the row is too short: %1 of %2 values</source>
        <translation>la ligne est trop courte&#xa0;: %1 valeurs sur %2</translation>
    </message>
    <message>
        <source>a file</source>
        <translation>un fichier</translation>
    </message>
    <message>
        <source>one value per column: %1</source>
        <translation>une valeur par colonne&#xa0;: %1</translation>
    </message>
    <message>
        <source>text outside the quotes of a column name</source>
        <translation>texte hors des guillemets d’un nom de colonne</translation>
    </message>
    <message>
        <source>a comma after the closing quote</source>
        <translation>une virgule après le guillemet fermant</translation>
    </message>
    <message>
        <source>the column %1 appears twice</source>
        <translation>la colonne %1 est présente deux fois</translation>
    </message>
    <message>
        <source>each name only once</source>
        <translation>chaque nom une seule fois</translation>
    </message>
    <message>
        <source>text outside the quotes of a value</source>
        <translation>texte hors des guillemets d’une valeur</translation>
    </message>
    <message>
        <source>a pipe cannot be rewound</source>
        <translation>un tube (pipe) ne permet pas de se positionner</translation>
    </message>
    <message>
        <source>the file is %1</source>
        <translation>le fichier est&#xa0;%1</translation>
    </message>
</context>
<context>
    <name>DdsDiscovery</name>
    <message>
        <source>other programs of the domain cannot be found</source>
        <translation>les autres programmes du domaine ne peuvent pas être trouvés</translation>
    </message>
</context>
<context>
    <name>DdsDomain</name>
    <message>
        <source>the environment variable %1 is &quot;%2&quot;</source>
        <translation>la variable d’environnement&#xa0;%1 vaut «&#xa0;%2&#xa0;»</translation>
    </message>
    <message>
        <source>a whole number from 0 to %1</source>
        <translation>un nombre entier de 0 à&#xa0;%1</translation>
    </message>
</context>
<context>
    <name>DdsEndpoint</name>
    <message>
        <source>topic %1 cannot be opened</source>
        <translation>le topic&#xa0;%1 ne peut pas être ouvert</translation>
    </message>
    <message>
        <source>topic %1 cannot be read</source>
        <translation>le topic&#xa0;%1 ne peut pas être lu</translation>
    </message>
    <message>
        <source>topic %1 cannot be written</source>
        <translation>le topic&#xa0;%1 ne peut pas être écrit</translation>
    </message>
    <message>
        <source>the permissions do not allow reading topic %1</source>
        <translation>les permissions n’autorisent pas la lecture du topic %1</translation>
    </message>
    <message>
        <source>the permissions do not allow writing topic %1</source>
        <translation>les permissions n’autorisent pas l’écriture du topic %1</translation>
    </message>
</context>
<context>
    <name>DdsParticipant</name>
    <message>
        <source>domain %1 is open with another interface or other peers</source>
        <translation>le domaine&#xa0;%1 est ouvert avec une autre interface ou d’autres pairs</translation>
    </message>
    <message>
        <source>domain %1 of DDS cannot be opened: %2</source>
        <translation>le domaine DDS&#xa0;%1 ne peut pas être ouvert&#xa0;:&#xa0;%2</translation>
    </message>
    <message>
        <source>&quot;%1&quot; to be the name or the address of a network interface</source>
        <translation>que «&#xa0;%1&#xa0;» soit le nom ou l’adresse d’une interface réseau</translation>
    </message>
    <message>
        <source>domain %1 of DDS cannot be joined: %2</source>
        <translation>le domaine DDS&#xa0;%1 ne peut pas être rejoint&#xa0;:&#xa0;%2</translation>
    </message>
    <message>
        <source>domain %1 of DDS cannot be joined</source>
        <translation>le domaine DDS&#xa0;%1 ne peut pas être rejoint</translation>
    </message>
    <message>
        <source>this program has joined domain %1 with keys already</source>
        <translation>ce programme a déjà rejoint le domaine %1 avec des clés</translation>
    </message>
    <message>
        <source>once: the permissions of the first would apply to all</source>
        <translation>une seule fois : les permissions de la première s’appliqueraient à toutes</translation>
    </message>
    <message>
        <source>this program joined domain %1 with other permissions before</source>
        <translation>ce programme a déjà rejoint le domaine %1 avec d’autres permissions</translation>
    </message>
    <message>
        <source>the same ones until the program is started again</source>
        <translation>les mêmes jusqu’au redémarrage du programme</translation>
    </message>
    <message>
        <source>domain %1 of DDS cannot be joined with the keys in %2: %3</source>
        <translation>le domaine DDS %1 ne peut pas être rejoint avec les clés de %2 : %3</translation>
    </message>
    <message>
        <source>a program is kept out of domain %1: %2</source>
        <translation>un programme est tenu hors du domaine %1 : %2</translation>
    </message>
</context>
<context>
    <name>DdsSecurity</name>
    <message>
        <source>the certificate has expired</source>
        <translation>le certificat a expiré</translation>
    </message>
    <message>
        <source>the certificate is not valid yet</source>
        <translation>le certificat n’est pas encore valable</translation>
    </message>
    <message>
        <source>the certificate is not signed by identity_ca.pem</source>
        <translation>le certificat n’est pas signé par identity_ca.pem</translation>
    </message>
    <message>
        <source>the key does not belong to the certificate</source>
        <translation>la clé ne correspond pas au certificat</translation>
    </message>
    <message>
        <source>the permissions are not signed by permissions_ca.pem</source>
        <translation>les permissions ne sont pas signées par permissions_ca.pem</translation>
    </message>
    <message>
        <source>the permissions do not name the subject of the certificate</source>
        <translation>les permissions ne nomment pas le sujet du certificat</translation>
    </message>
    <message>
        <source>the permissions have expired</source>
        <translation>les permissions ont expiré</translation>
    </message>
    <message>
        <source>the permissions are not valid yet</source>
        <translation>les permissions ne sont pas encore valables</translation>
    </message>
    <message>
        <source>the permissions (permissions.p7s) do not allow this domain</source>
        <translation>les permissions (permissions.p7s) n’autorisent pas ce domaine</translation>
    </message>
    <message>
        <source>the governance (governance.p7s) does not name this domain</source>
        <translation>la gouvernance (governance.p7s) ne nomme pas ce domaine</translation>
    </message>
    <message>
        <source>the plugins of DDS Security cannot be loaded</source>
        <translation>les modules de DDS Security ne peuvent pas être chargés</translation>
    </message>
</context>
<context>
    <name>Demo</name>
    <message>
        <source>An arm touches five materials</source>
        <translation>Un bras touche cinq matériaux</translation>
    </message>
    <message>
        <source>Sponge, rubber sponge, rubber, wood and metal: contact point, force, stiffness, bracelet</source>
        <translation>Éponge, caoutchouc mousse, caoutchouc, bois et métal&#xa0;: point de contact, force, raideur, bracelet</translation>
    </message>
    <message>
        <source>An arm explores a round object</source>
        <translation>Un bras explore un objet rond</translation>
    </message>
    <message>
        <source>The forearm touches it from all around: contact points, spline, recognised shape</source>
        <translation>L’avant-bras le touche de tous côtés&#xa0;: points de contact, spline, forme reconnue</translation>
    </message>
    <message>
        <source>An arm explores a rectangular object</source>
        <translation>Un bras explore un objet rectangulaire</translation>
    </message>
    <message>
        <source>The same with a box</source>
        <translation>La même chose avec une boîte</translation>
    </message>
    <message>
        <source>An arm explores a triangular object</source>
        <translation>Un bras explore un objet triangulaire</translation>
    </message>
    <message>
        <source>The same with a triangular prism</source>
        <translation>La même chose avec un prisme triangulaire</translation>
    </message>
    <message>
        <source>An arm yields</source>
        <translation>Un bras cède</translation>
    </message>
    <message>
        <source>Somebody pushes the arm, then it meets an object, under joint admittance control</source>
        <translation>Quelqu’un pousse le bras, puis celui-ci rencontre un objet, sous commande en admittance articulaire</translation>
    </message>
    <message>
        <source>A ball and a bar</source>
        <translation>Une bille et une barre</translation>
    </message>
    <message>
        <source>A 6 x 14 array pressed by a ball that wanders, then by a bar that turns</source>
        <translation>Une matrice 6 x 14 pressée par une bille qui se déplace, puis par une barre qui tourne</translation>
    </message>
    <message>
        <source>Two contacts that meet</source>
        <translation>Deux contacts qui se rejoignent</translation>
    </message>
    <message>
        <source>Two balls that approach each other until they touch, and part</source>
        <translation>Deux billes qui se rapprochent jusqu’à se toucher, puis se séparent</translation>
    </message>
    <message>
        <source>A pressure mat</source>
        <translation>Un tapis de pression</translation>
    </message>
    <message>
        <source>A 64 x 27 mat under a body: a head, a trunk that turns, two heels</source>
        <translation>Un tapis 64 x 27 sous un corps&#xa0;: une tête, un tronc qui se tourne, deux talons</translation>
    </message>
    <message>
        <source>Something pokes a soft arm</source>
        <translation>Quelque chose pique un bras souple</translation>
    </message>
    <message>
        <source>A camera inside the soft tube sees the bump; the arm draws back</source>
        <translation>Une caméra dans le tube souple voit le choc&#xa0;; le bras se retire</translation>
    </message>
    <message>
        <source>A finger turns a soft arm</source>
        <translation>Un doigt fait tourner un bras souple</translation>
    </message>
    <message>
        <source>The arm turns after a finger that goes round it</source>
        <translation>Le bras tourne à la suite d’un doigt qui en fait le tour</translation>
    </message>
    <message>
        <source>A finger leads a soft arm</source>
        <translation>Un doigt guide un bras souple</translation>
    </message>
    <message>
        <source>The arm follows a finger along its axis</source>
        <translation>Le bras suit un doigt le long de son axe</translation>
    </message>
    <message>
        <source>Three fingers on a soft arm</source>
        <translation>Trois doigts sur un bras souple</translation>
    </message>
    <message>
        <source>Contacts near the lens, in the middle and at the far end of the tube</source>
        <translation>Contacts près de l’objectif, au milieu et à l’extrémité du tube</translation>
    </message>
    <message>
        <source>An array follows a bent bar</source>
        <translation>Une matrice suit une barre courbe</translation>
    </message>
    <message>
        <source>It closes in, aligns with the bar, and slides along its bend at 5 N</source>
        <translation>Elle s’approche, s’aligne sur la barre et glisse le long de sa courbure à 5 N</translation>
    </message>
    <message>
        <source>A tray is kept level</source>
        <translation>Un plateau est tenu horizontal</translation>
    </message>
    <message>
        <source>A weight moves on the tray; the hand feels its moment and tilts against it</source>
        <translation>Un poids se déplace sur le plateau&#xa0;; la main en ressent le moment et s’incline en sens contraire</translation>
    </message>
    <message>
        <source>An array rolls on a ball</source>
        <translation>Une matrice roule sur une bille</translation>
    </message>
    <message>
        <source>The contact wanders over the array while the force stays at 4 N</source>
        <translation>Le contact se promène sur la matrice tandis que la force reste à 4 N</translation>
    </message>
    <message>
        <source>An arm among unknown objects</source>
        <translation>Un bras parmi des objets inconnus</translation>
    </message>
    <message>
        <source>Drive it yourself over a slow link, or watch the scripted operator: each object that is found goes on the run sheet</source>
        <translation>Conduisez-le vous-même par une liaison lente, ou regardez l’opérateur programmé&#xa0;: chaque objet trouvé est inscrit au relevé</translation>
    </message>
    <message>
        <source>Arm</source>
        <translation>Bras</translation>
    </message>
    <message>
        <source>Array</source>
        <translation>Matrice</translation>
    </message>
    <message>
        <source>Servo</source>
        <translation>Asservissement</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Caméra</translation>
    </message>
    <message>
        <source>Study</source>
        <translation>Étude</translation>
    </message>
    <message>
        <source>Simulated participants answer, and the confusion matrix fills</source>
        <translation>Des participants simulés répondent, et la matrice de confusion se remplit</translation>
    </message>
    <message>
        <source>The published protocol</source>
        <translation>Le protocole publié</translation>
    </message>
    <message>
        <source>Stimuli, practice and test trials: read it, and begin a study with it</source>
        <translation>Stimuli, essais d’entraînement et de test&#xa0;: lisez-le, et commencez une étude avec lui</translation>
    </message>
    <message>
        <source>Patterns</source>
        <translation>Motifs</translation>
    </message>
    <message>
        <source>A rehearsed study</source>
        <translation>Répétition d’une étude</translation>
    </message>
    <message>
        <source>A shape as a vibration pattern: play it, or edit a copy</source>
        <translation>Une forme comme motif de vibration&#xa0;: jouez-le, ou modifiez-en une copie</translation>
    </message>
    <message>
        <source>A stiffness as a vibration pattern: play it, or edit a copy</source>
        <translation>Une raideur comme motif de vibration&#xa0;: jouez-le, ou modifiez-en une copie</translation>
    </message>
    <message>
        <source>Balls press a flat gel</source>
        <translation>Des billes pressent un gel plat</translation>
    </message>
    <message>
        <source>Markers on the skin of a flat gel move apart under two balls</source>
        <translation>Les marqueurs de la peau d’un gel plat s’écartent sous deux billes</translation>
    </message>
    <message>
        <source>A ball shears a flat gel</source>
        <translation>Une bille cisaille un gel plat</translation>
    </message>
    <message>
        <source>It is dragged to and fro and sticks but for a narrow rim</source>
        <translation>Elle est traînée en va-et-vient et adhère, sauf un bord étroit</translation>
    </message>
    <message>
        <source>A ball slips on a flat gel</source>
        <translation>Une bille glisse sur un gel plat</translation>
    </message>
    <message>
        <source>A ring of slip grows from the rim of the contact to its middle</source>
        <translation>Un anneau de glissement s’étend du bord du contact vers son centre</translation>
    </message>
    <message>
        <source>A ball twists a flat gel</source>
        <translation>Une bille tord un gel plat</translation>
    </message>
    <message>
        <source>It is turned about the normal, and the skin turns with it</source>
        <translation>Elle tourne autour de la normale, et la peau tourne avec elle</translation>
    </message>
</context>
<context>
    <name>DeviceState</name>
    <message>
        <source>closed</source>
        <translation>fermé</translation>
    </message>
    <message>
        <source>connecting</source>
        <translation>connexion</translation>
    </message>
    <message>
        <source>live</source>
        <translation>en direct</translation>
    </message>
    <message>
        <source>paused</source>
        <translation>en pause</translation>
    </message>
    <message>
        <source>stale</source>
        <translation>figé</translation>
    </message>
    <message>
        <source>lost</source>
        <translation>perdu</translation>
    </message>
    <message>
        <source>reconnecting</source>
        <translation>reconnexion</translation>
    </message>
    <message>
        <source>finished</source>
        <translation>terminé</translation>
    </message>
</context>
<context>
    <name>DevicesCommand</name>
    <message>
        <source>&quot;kind&quot; is missing</source>
        <translation>«&#xa0;kind&#xa0;» manque</translation>
    </message>
    <message>
        <source>Bracelet</source>
        <translation>Bracelet</translation>
    </message>
    <message>
        <source>3D mouse</source>
        <translation>Souris 3D</translation>
    </message>
    <message>
        <source>Tactile array</source>
        <translation>Matrice tactile</translation>
    </message>
    <message>
        <source>Modbus device</source>
        <translation>Appareil Modbus</translation>
    </message>
    <message>
        <source>%1 at %2</source>
        <translation>%1 sur %2</translation>
    </message>
    <message>
        <source>State</source>
        <translation>État</translation>
    </message>
    <message>
        <source>not connected: %1</source>
        <translation>non connecté&#xa0;: %1</translation>
    </message>
    <message>
        <source>connected</source>
        <translation>connecté</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>Trames</translation>
    </message>
    <message>
        <source>up to %1 Hz</source>
        <translation>jusqu’à %1 Hz</translation>
    </message>
    <message>
        <source>Inputs</source>
        <translation>Entrées</translation>
    </message>
    <message>
        <source>No device is connected.</source>
        <translation>Aucun appareil n’est connecté.</translation>
    </message>
    <message>
        <source>Connect to the device of this description and read it; its motors are set to zero</source>
        <translation>Se connecter à l’appareil de cette description et le lire&#xa0;; ses moteurs sont mis à zéro</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Caméra</translation>
    </message>
    <message>
        <source>List connected devices, how fast they are, and why others cannot be used</source>
        <translation>Ce qui est connecté, pourquoi un appareil ne l’est pas, et sa vitesse</translation>
    </message>
    <message>
        <source>it answers, but sends no frames</source>
        <translation>il répond, mais n’envoie aucune trame</translation>
    </message>
    <message>
        <source>%1 Hz</source>
        <translation>%1 Hz</translation>
    </message>
    <message>
        <source>nothing came from it</source>
        <translation>rien n’en est venu</translation>
    </message>
    <message numerus="yes">
        <source>it sends frames of %n chip(s)</source>
        <translation>
            <numerusform>il envoie des trames de %n puce</numerusform>
            <numerusform>il envoie des trames de %n puces</numerusform>
        </translation>
    </message>
    <message>
        <source>there is no frame in what came from it, as the file describes them</source>
        <translation>ce qui en est venu ne contient aucune trame telle que le fichier la décrit</translation>
    </message>
    <message>
        <source>Of a described array: show at most so many of the bytes that it sends until a second after its first frame</source>
        <translation>D’une matrice décrite&#xa0;: montrer au plus ce nombre des octets qu’elle envoie jusqu’à une seconde après sa première trame</translation>
    </message>
    <message>
        <source>the sensor file names no camera and no video</source>
        <translation>le fichier du capteur n’indique ni caméra ni vidéo</translation>
    </message>
    <message>
        <source>a key &quot;source&quot;</source>
        <translation>une clé «&#xa0;source&#xa0;»</translation>
    </message>
    <message>
        <source>Flat gel with markers</source>
        <translation>Gel plat à marqueurs</translation>
    </message>
    <message>
        <source>kind = &quot;modbus&quot;, &quot;wts&quot;, &quot;camera&quot;, &quot;hid_bracelet&quot;, &quot;taxels&quot;, &quot;magnetometers&quot;, &quot;xela&quot;, &quot;sound_bracelet&quot;, &quot;marker_gel&quot;, &quot;ros_tactile&quot; or &quot;ros_camera&quot;</source>
        <translation>kind = &quot;modbus&quot;, &quot;wts&quot;, &quot;camera&quot;, &quot;hid_bracelet&quot;, &quot;taxels&quot;, &quot;magnetometers&quot;, &quot;xela&quot;, &quot;sound_bracelet&quot;, &quot;marker_gel&quot;, &quot;ros_tactile&quot; ou &quot;ros_camera&quot;</translation>
    </message>
</context>
<context>
    <name>DriverText</name>
    <message>
        <source>the simulated motor driver cannot open a port: %1</source>
        <translation>le pilote de moteurs simulé ne peut pas ouvrir de port&#xa0;:&#xa0;%1</translation>
    </message>
    <message>
        <source>the device has no motors</source>
        <translation>l’appareil n’a pas de moteurs</translation>
    </message>
</context>
<context>
    <name>DurationText</name>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>%1 min %2 s</source>
        <translation>%1 min %2 s</translation>
    </message>
    <message>
        <source>%1 h %2 min</source>
        <translation>%1 h %2 min</translation>
    </message>
</context>
<context>
    <name>EqualStrength</name>
    <message>
        <source>tactor %1 has no level at which it feels as strong as tactor %2</source>
        <translation>le tacteur %1 n’a aucun niveau auquel il est ressenti aussi fort que le tacteur %2</translation>
    </message>
    <message>
        <source>a level for each of the six tactors</source>
        <translation>un niveau pour chacun des six tacteurs</translation>
    </message>
</context>
<context>
    <name>Error</name>
    <message>
        <source> (expected %1)</source>
        <translation> (attendu&#xa0;: %1)</translation>
    </message>
</context>
<context>
    <name>ExclusionReport</name>
    <message>
        <source>%1 (marked in the file)</source>
        <translation>%1 (d’après une marque dans le fichier)</translation>
    </message>
    <message>
        <source>%1 (made after the data)</source>
        <translation>%1 (fixée après les données)</translation>
    </message>
    <message>
        <source>What was left out, in the order of the rules; nothing was deleted</source>
        <translation>Ce qui a été écarté, dans l’ordre des règles&#xa0;; rien n’a été supprimé</translation>
    </message>
    <message>
        <source>Rule</source>
        <translation>Règle</translation>
    </message>
    <message>
        <source>Trials before</source>
        <translation>Essais avant</translation>
    </message>
    <message>
        <source>Trials</source>
        <translation>Essais</translation>
    </message>
    <message>
        <source>Sessions</source>
        <translation>Sessions</translation>
    </message>
    <message>
        <source>Participants</source>
        <translation>Participants</translation>
    </message>
    <message>
        <source>Remark</source>
        <translation>Remarque</translation>
    </message>
    <message numerus="yes">
        <source>no spread of the times, so nothing was left out, in %n case(s)</source>
        <translation>
            <numerusform>pas de dispersion des temps, donc rien n’a été écarté, dans %n cas</numerusform>
            <numerusform>pas de dispersion des temps, donc rien n’a été écarté, dans %n cas</numerusform>
        </translation>
    </message>
    <message>
        <source>The results with the rules, and without them</source>
        <translation>Les résultats avec les règles, et sans elles</translation>
    </message>
    <message>
        <source>Task</source>
        <translation>Tâche</translation>
    </message>
    <message>
        <source>Condition or effect</source>
        <translation>Condition ou effet</translation>
    </message>
    <message>
        <source>Correct, %</source>
        <translation>Correctes,&#xa0;%</translation>
    </message>
    <message>
        <source>Correct without rules, %</source>
        <translation>Correctes sans règles,&#xa0;%</translation>
    </message>
    <message>
        <source>p GG without rules</source>
        <translation>p GG sans règles</translation>
    </message>
    <message>
        <source>Exclusions</source>
        <translation>Exclusions</translation>
    </message>
</context>
<context>
    <name>ExclusionRule</name>
    <message>
        <source>the rule %1 is about something else</source>
        <translation>la règle %1 porte sur autre chose</translation>
    </message>
    <message>
        <source>&quot;%1&quot;</source>
        <translation>«&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no exclusion rule</source>
        <translation>«&#xa0;%1&#xa0;» n’est pas une règle d’exclusion</translation>
    </message>
    <message>
        <source>RULE=VALUE with one of %1</source>
        <translation>RÈGLE=VALEUR avec l’une de %1</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has no usable value</source>
        <translation>«&#xa0;%1&#xa0;» n’a pas de valeur utilisable</translation>
    </message>
    <message>
        <source>%1=VALUE with %2</source>
        <translation>%1=VALEUR avec %2</translation>
    </message>
</context>
<context>
    <name>ExportCommand</name>
    <message numerus="yes">
        <source>%n row(s)</source>
        <translation>
            <numerusform>%n ligne</numerusform>
            <numerusform>%n lignes</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n damaged block(s) left out</source>
        <translation>
            <numerusform>%n bloc endommagé ignoré</numerusform>
            <numerusform>%n blocs endommagés ignorés</numerusform>
        </translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Remarque</translation>
    </message>
    <message>
        <source>The recording was cut off; what had been written is there.</source>
        <translation>L’enregistrement a été coupé&#xa0;; ce qui avait été écrit est là.</translation>
    </message>
    <message>
        <source>Recording of the console or of teleta simulate</source>
        <translation>Enregistrement de la console ou de teleta simulate</translation>
    </message>
    <message>
        <source>Write over files that are there already</source>
        <translation>Remplacer les fichiers déjà présents</translation>
    </message>
    <message>
        <source>another folder, or --force</source>
        <translation>un autre dossier, ou --force</translation>
    </message>
    <message>
        <source>start, units and origin of these files</source>
        <translation>début, unités et origine de ces fichiers</translation>
    </message>
    <message numerus="yes">
        <source>%n message(s)</source>
        <translation>
            <numerusform>%n message</numerusform>
            <numerusform>%n messages</numerusform>
        </translation>
    </message>
    <message>
        <source>The camera sees a left-handed frame: y of %1 has changed its sign.</source>
        <translation>La caméra voit un repère indirect&#xa0;: y de %1 a changé de signe.</translation>
    </message>
    <message>
        <source>%1 has no messages in ROS and was left out.</source>
        <translation>%1 n’a pas de messages dans ROS et a été laissé de côté.</translation>
    </message>
    <message>
        <source>Folder for a CSV file a stream, events.csv and recording.json</source>
        <translation>Dossier pour un fichier CSV par flux, events.csv et recording.json</translation>
    </message>
    <message>
        <source>List the streams of the recording: name and kind</source>
        <translation>Lister les flux de l’enregistrement&#xa0;: nom et type</translation>
    </message>
    <message>
        <source>Add a last column utc_s: Unix time in s with nine decimals</source>
        <translation>Ajouter une dernière colonne utc_s&#xa0;: temps Unix en s avec neuf décimales</translation>
    </message>
    <message>
        <source>MCAP file for Foxglove and ROS 2</source>
        <translation>Fichier MCAP pour Foxglove et ROS 2</translation>
    </message>
    <message>
        <source>Compression of the MCAP file</source>
        <translation>Compression du fichier MCAP</translation>
    </message>
    <message>
        <source>Size of a chunk of the MCAP file in MiB</source>
        <translation>Taille d’un bloc (chunk) du fichier MCAP, en MiB</translation>
    </message>
    <message>
        <source>another name, or --force</source>
        <translation>un autre nom, ou --force</translation>
    </message>
    <message numerus="yes">
        <source>%n frame(s)</source>
        <translation>
            <numerusform>%n trame</numerusform>
            <numerusform>%n trames</numerusform>
        </translation>
    </message>
    <message>
        <source>NumPy file with the arrays frames and time_s of a tactile array</source>
        <translation>Fichier NumPy avec les tableaux frames et time_s d’une matrice tactile</translation>
    </message>
    <message>
        <source>Only these streams into the MCAP file; the array of the NumPy file</source>
        <translation>Seulement ces flux dans le fichier MCAP&#xa0;; la matrice du fichier NumPy</translation>
    </message>
    <message>
        <source>either a folder here or a file after --mcap or --npz is needed</source>
        <translation>il faut soit un dossier ici, soit un fichier après --mcap ou --npz</translation>
    </message>
    <message>
        <source>only with --mcap or --npz</source>
        <translation>seulement avec --mcap ou --npz</translation>
    </message>
    <message>
        <source>only one with --npz</source>
        <translation>un seul avec --npz</translation>
    </message>
    <message>
        <source>Write the streams of a recording as CSV, MCAP or NumPy files</source>
        <translation>Écrire les flux d’un enregistrement en fichiers CSV, MCAP ou NumPy</translation>
    </message>
</context>
<context>
    <name>ExportDialog</name>
    <message>
        <source>HJIF (ISO/IEC 23090-31)</source>
        <translation>HJIF (ISO/IEC 23090-31)</translation>
    </message>
    <message>
        <source>Haptic clips (.haptic in a zip)</source>
        <translation>Clips haptiques (.haptic dans un zip)</translation>
    </message>
    <message>
        <source>AHAP (in a zip)</source>
        <translation>AHAP (dans un zip)</translation>
    </message>
    <message>
        <source>tact</source>
        <translation>tact</translation>
    </message>
    <message>
        <source>CSV table</source>
        <translation>Tableau CSV</translation>
    </message>
    <message>
        <source>WAV, six channels</source>
        <translation>WAV, six canaux</translation>
    </message>
    <message>
        <source>One channel per motor, with its place on the forearm. Can be read back.</source>
        <translation>Un canal par moteur, avec sa place sur l’avant-bras. Peut être relu.</translation>
    </message>
    <message>
        <source>One clip per motor. Can be read back.</source>
        <translation>Un clip par moteur. Peut être relu.</translation>
    </message>
    <message>
        <source>Columns time_s, t1 to t6: one sample per row.</source>
        <translation>Colonnes time_s, t1 à t6&#xa0;: un échantillon par ligne.</translation>
    </message>
    <message>
        <source>One file per motor, for Core Haptics. Can be read back.</source>
        <translation>Un fichier par moteur, pour Core Haptics. Peut être relu.</translation>
    </message>
    <message>
        <source>Six motors on the forearm, whole milliseconds; slopes become steps of 20 ms. Can be read back.</source>
        <translation>Six moteurs sur l’avant-bras, millisecondes entières&#xa0;; les pentes deviennent des paliers de 20 ms. Peut être relu.</translation>
    </message>
    <message>
        <source>16-bit samples, 1 is full scale. Vibrations drive voice coils; bare intensities are for programs that make the vibration themselves.</source>
        <translation>Échantillons de 16 bits, 1 est la pleine échelle. Les vibrations pilotent des actionneurs à bobine mobile&#xa0;; les intensités brutes sont destinées aux programmes qui produisent eux-mêmes la vibration.</translation>
    </message>
</context>
<context>
    <name>FaultInjector</name>
    <message>
        <source>the recording did not fail on a full disk</source>
        <translation>l’enregistrement n’a pas échoué sur un disque plein</translation>
    </message>
    <message>
        <source>the program under test ended by itself</source>
        <translation>le programme testé s’est terminé de lui-même</translation>
    </message>
    <message>
        <source>nothing moved within 30 s</source>
        <translation>rien n’a bougé en 30 s</translation>
    </message>
    <message>
        <source>the device does not answer any more</source>
        <translation>l’appareil ne répond plus</translation>
    </message>
    <message>
        <source>nothing moved within 30 s: %1</source>
        <translation>rien n’a bougé en 30 s&#xa0;: %1</translation>
    </message>
</context>
<context>
    <name>FeaturesCommand</name>
    <message>
        <source>Force, centres, moments and orientation of each tactile frame</source>
        <translation>Force, centres, moments et orientation de chaque trame tactile</translation>
    </message>
</context>
<context>
    <name>FeltTask</name>
    <message>
        <source>Motor %1: %2</source>
        <comment>a motor, and what is wrong with the answers</comment>
        <translation>Moteur %1&#xa0;: %2</translation>
    </message>
</context>
<context>
    <name>FeltThreshold</name>
    <message>
        <source>There are too few answers: %1.</source>
        <translation>Il y a trop peu de réponses&#xa0;: %1.</translation>
    </message>
    <message>
        <source>at least %1</source>
        <translation>au moins %1</translation>
    </message>
    <message>
        <source>yes only when something was clearly felt</source>
        <translation>oui seulement si quelque chose a été nettement senti</translation>
    </message>
    <message>
        <source>Nothing was felt, not even at the highest drive.</source>
        <translation>Rien n’a été senti, même à la commande la plus forte.</translation>
    </message>
    <message>
        <source>Everything was felt, even at the lowest drive.</source>
        <translation>Tout a été senti, même à la commande la plus faible.</translation>
    </message>
    <message>
        <source>The answers contradict each other: stronger was felt less often than weaker, or as often.</source>
        <translation>Les réponses se contredisent&#xa0;: le plus fort a été senti moins souvent que le plus faible, ou aussi souvent.</translation>
    </message>
    <message>
        <source>The answer was yes in %1 of %2 cases in which nothing was presented.</source>
        <translation>La réponse a été oui alors que rien n’était présenté, %1 fois sur %2.</translation>
    </message>
    <message>
        <source>a connected motor in contact with the skin</source>
        <translation>un moteur connecté et posé sur la peau</translation>
    </message>
    <message>
        <source>no when nothing was felt</source>
        <translation>non lorsque rien n’a été senti</translation>
    </message>
    <message>
        <source>consistent answers; undo the wrong ones or start again</source>
        <translation>des réponses selon ce qui est senti&#xa0;; annulez les fausses ou recommencez</translation>
    </message>
</context>
<context>
    <name>FigureExport</name>
    <message>
        <source>The file could not be written: %1</source>
        <translation>Le fichier n’a pas pu être écrit&#xa0;: %1</translation>
    </message>
    <message>
        <source>Unknown picture format &quot;%1&quot;</source>
        <translation>Format d’image «&#xa0;%1&#xa0;» inconnu</translation>
    </message>
</context>
<context>
    <name>FigureText</name>
    <message>
        <source>Actual pattern</source>
        <translation>Motif réel</translation>
    </message>
    <message>
        <source>cannot draw the picture: %1</source>
        <translation>impossible de dessiner l’image&#xa0;: %1</translation>
    </message>
    <message>
        <source>the picture has no size</source>
        <translation>l’image n’a pas de taille</translation>
    </message>
    <message>
        <source>the picture would have too many pixels</source>
        <translation>l’image aurait trop de pixels</translation>
    </message>
    <message>
        <source>Force, N</source>
        <translation>Force, N</translation>
    </message>
    <message>
        <source>CoP y, mm</source>
        <translation>CoP y, mm</translation>
    </message>
    <message>
        <source>CoC x, mm</source>
        <translation>CoC x, mm</translation>
    </message>
    <message>
        <source>DZMP y, mm</source>
        <translation>DZMP y, mm</translation>
    </message>
    <message>
        <source>α z, °</source>
        <translation>α z, °</translation>
    </message>
    <message>
        <source>Turn z, °</source>
        <translation>Rotation z, °</translation>
    </message>
    <message>
        <source>Tactile servoing: force and features over time</source>
        <translation>Asservissement tactile&#xa0;: force et caractéristiques au cours du temps</translation>
    </message>
    <message>
        <source>desired</source>
        <translation>désiré</translation>
    </message>
    <message>
        <source>true</source>
        <translation>vrai</translation>
    </message>
    <message>
        <source>in contact</source>
        <translation>en contact</translation>
    </message>
    <message>
        <source>weight is moved; its moment is gone</source>
        <translation>le poids est déplacé&#xa0;; son moment a disparu</translation>
    </message>
    <message>
        <source>Tactile servoing, simulated</source>
        <translation>Asservissement tactile, simulé</translation>
    </message>
    <message>
        <source>Tactile servoing</source>
        <translation>Asservissement tactile</translation>
    </message>
    <message>
        <source>a limit acts (%1)</source>
        <translation>une limite agit (%1)</translation>
    </message>
    <message>
        <source>time, s</source>
        <translation>temps, s</translation>
    </message>
    <message>
        <source>Subject response, %</source>
        <translation>Réponse du sujet,&#xa0;%</translation>
    </message>
    <message>
        <source>Subject response, trials</source>
        <translation>Réponse du sujet, essais</translation>
    </message>
    <message>
        <source>Subject response, % and trials</source>
        <translation>Réponse du sujet,&#xa0;% et essais</translation>
    </message>
    <message>
        <source>Position, mm</source>
        <translation>Position, mm</translation>
    </message>
    <message>
        <source>Path, mm</source>
        <translation>Trajet, mm</translation>
    </message>
</context>
<context>
    <name>FileApartText</name>
    <message>
        <source>reading it takes too long</source>
        <translation>sa lecture prend trop de temps</translation>
    </message>
    <message>
        <source>reading it takes too much memory</source>
        <translation>sa lecture prend trop de mémoire</translation>
    </message>
    <message>
        <source>the library that reads it stopped unexpectedly</source>
        <translation>la bibliothèque qui le lit s’est arrêtée</translation>
    </message>
    <message>
        <source>the file changed while it was read</source>
        <translation>le fichier a changé pendant la lecture</translation>
    </message>
    <message>
        <source>no process can be started to read the file: %1</source>
        <translation>aucun processus ne peut être lancé pour lire le fichier&#xa0;:&#xa0;%1</translation>
    </message>
    <message>
        <source>the file is damaged: %1</source>
        <translation>le fichier est endommagé&#xa0;:&#xa0;%1</translation>
    </message>
    <message>
        <source>a whole file</source>
        <translation>un fichier entier</translation>
    </message>
</context>
<context>
    <name>FileKeysText</name>
    <message>
        <source>&quot;%1&quot; is not a topic name</source>
        <translation>«&#xa0;%1&#xa0;» n’est pas un nom de topic</translation>
    </message>
    <message>
        <source>parts of letters, digits and _ after slashes, for example /joint_states</source>
        <translation>des parties de lettres, de chiffres et de _ après des barres obliques, par exemple /joint_states</translation>
    </message>
</context>
<context>
    <name>FileKindText</name>
    <message>
        <source>text</source>
        <translation>du texte</translation>
    </message>
    <message>
        <source>a NumPy array (npy)</source>
        <translation>un tableau NumPy (npy)</translation>
    </message>
    <message>
        <source>a zip archive (npz is one)</source>
        <translation>une archive zip (npz en est une)</translation>
    </message>
    <message>
        <source>an HDF5 file</source>
        <translation>un fichier HDF5</translation>
    </message>
    <message>
        <source>a MAT file</source>
        <translation>un fichier MAT</translation>
    </message>
    <message>
        <source>a MAT file of version 7.3</source>
        <translation>un fichier MAT de version 7.3</translation>
    </message>
    <message>
        <source>an SQLite database, such as a recording</source>
        <translation>une base de données SQLite, comme un enregistrement</translation>
    </message>
    <message>
        <source>an MCAP file</source>
        <translation>un fichier MCAP</translation>
    </message>
    <message>
        <source>a file that gzip has packed</source>
        <translation>un fichier compressé par gzip</translation>
    </message>
    <message>
        <source>a file that zstd has packed</source>
        <translation>un fichier compressé par zstd</translation>
    </message>
    <message>
        <source>a PNG picture</source>
        <translation>une image PNG</translation>
    </message>
    <message>
        <source>a JPEG picture</source>
        <translation>une image JPEG</translation>
    </message>
    <message>
        <source>a PDF document</source>
        <translation>un document PDF</translation>
    </message>
    <message>
        <source>an old Excel file</source>
        <translation>un ancien fichier Excel</translation>
    </message>
    <message>
        <source>a Parquet file</source>
        <translation>un fichier Parquet</translation>
    </message>
    <message>
        <source>a pickle of Python</source>
        <translation>un pickle de Python</translation>
    </message>
    <message>
        <source>a video</source>
        <translation>une vidéo</translation>
    </message>
    <message>
        <source>a WAV sound</source>
        <translation>un son WAV</translation>
    </message>
    <message>
        <source>text in UTF-16</source>
        <translation>du texte en UTF-16</translation>
    </message>
    <message>
        <source>binary data of no known format</source>
        <translation>des données binaires de format inconnu</translation>
    </message>
</context>
<context>
    <name>FileText</name>
    <message>
        <source>one of %1</source>
        <translation>l’un de %1</translation>
    </message>
    <message>
        <source>there are %1 motors</source>
        <translation>il y a %1 moteurs</translation>
    </message>
    <message>
        <source>there is no such file or built-in pattern</source>
        <translation>il n’y a pas de tel fichier ni de tel motif intégré</translation>
    </message>
    <message>
        <source>this format holds one tactor, the pattern uses more</source>
        <translation>ce format contient un seul tacteur, le motif en utilise davantage</translation>
    </message>
    <message>
        <source>a name that ends with %1</source>
        <translation>un nom qui se termine par %1</translation>
    </message>
    <message>
        <source>these values are inconsistent</source>
        <translation>ces valeurs se contredisent</translation>
    </message>
    <message>
        <source>0 &lt; start_drive &lt; full_drive, and a curve that rises from the start or below it to drive 1</source>
        <translation>0 &lt; start_drive &lt; full_drive, une courbe qui monte depuis le démarrage ou avant jusqu’à la commande 1</translation>
    </message>
    <message>
        <source>the file was written by a newer version</source>
        <translation>le fichier est d’une version plus récente</translation>
    </message>
    <message>
        <source>the profile belongs to the bracelet &quot;%1&quot;</source>
        <translation>le profil est celui du bracelet «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>a pattern file, or an id listed by teleta pattern list</source>
        <translation>un fichier de motif, ou un identifiant de teleta pattern list</translation>
    </message>
    <message>
        <source>the file name extension is unknown</source>
        <translation>l’extension du nom n’indique aucun format</translation>
    </message>
    <message>
        <source>this format can be written but not read</source>
        <translation>les motifs s’écrivent dans ce format, mais ne s’y lisent pas</translation>
    </message>
</context>
<context>
    <name>ForeignDatabase</name>
    <message>
        <source>SQLite cannot be made defensive</source>
        <translation>SQLite ne peut pas passer en mode défensif</translation>
    </message>
    <message>
        <source>SQLite %1 or newer</source>
        <translation>SQLite&#xa0;%1 ou plus récent</translation>
    </message>
    <message>
        <source>the file holds a %1, &quot;%2&quot;, which this program does not make</source>
        <comment>view, trigger or (virtual) table of a database</comment>
        <translation>le fichier contient un objet de type&#xa0;%1, «&#xa0;%2&#xa0;», que ce programme ne crée pas</translation>
    </message>
    <message>
        <source>plain tables and indices only</source>
        <translation>seulement des tables et des index ordinaires</translation>
    </message>
</context>
<context>
    <name>FrameFileText</name>
    <message>
        <source>column %1 is &quot;%2&quot;</source>
        <translation>la colonne %1 est «&#xa0;%2&#xa0;»</translation>
    </message>
    <message>
        <source>there are no taxel columns</source>
        <translation>il n’y a pas de colonnes de taxels</translation>
    </message>
    <message>
        <source>the columns time_s, t0, t1, ...</source>
        <translation>les colonnes time_s, t0, t1, ...</translation>
    </message>
    <message>
        <source>the file has %1 taxel columns</source>
        <translation>le fichier a %1 colonnes de taxels</translation>
    </message>
    <message>
        <source>%1 = %2 rows x %3 columns</source>
        <translation>%1 = %2 lignes x %3 colonnes</translation>
    </message>
    <message>
        <source>the recording has no frames</source>
        <translation>l’enregistrement n’a pas de trames</translation>
    </message>
    <message>
        <source>the time is %1</source>
        <translation>le temps est %1</translation>
    </message>
    <message>
        <source>a finite time in s</source>
        <translation>un temps fini en s</translation>
    </message>
    <message>
        <source>the time goes back from %1 to %2</source>
        <translation>le temps recule de %1 à %2</translation>
    </message>
    <message>
        <source>times that do not decrease</source>
        <translation>des temps non décroissants</translation>
    </message>
    <message>
        <source>at least one row after the header</source>
        <translation>au moins une ligne après l’en-tête</translation>
    </message>
</context>
<context>
    <name>FrameImportText</name>
    <message>
        <source>interrupted</source>
        <translation>interrompu</translation>
    </message>
    <message>
        <source>the frames span more than %1 years</source>
        <translation>les trames s’étendent sur plus de %1 ans</translation>
    </message>
    <message>
        <source>times in seconds; see --time-unit</source>
        <translation>des temps en secondes ; voir --time-unit</translation>
    </message>
</context>
<context>
    <name>FrameOptionText</name>
    <message>
        <source>%1 is given, a taxel from 0 to %2 is expected</source>
        <translation>%1 est donné, un taxel de 0 à %2 est attendu</translation>
    </message>
    <message>
        <source>Rows of the array</source>
        <translation>Lignes de la matrice</translation>
    </message>
    <message>
        <source>Distance of neighbouring taxels in mm</source>
        <translation>Distance entre taxels voisins en mm</translation>
    </message>
    <message>
        <source>Load in N from which a taxel is in contact</source>
        <translation>Charge en N à partir de laquelle un taxel est en contact</translation>
    </message>
    <message>
        <source>The raw values fall under load</source>
        <translation>Les valeurs brutes diminuent sous charge</translation>
    </message>
    <message>
        <source>N per raw unit</source>
        <translation>N par unité brute</translation>
    </message>
    <message>
        <source>Numbers of taxels to leave out, such as 0,17</source>
        <translation>Numéros des taxels à ignorer, comme 0,17</translation>
    </message>
    <message>
        <source>Weight the taxels with their load to find the principal axis</source>
        <translation>Pondérer les taxels par leur charge pour trouver l’axe principal</translation>
    </message>
    <message>
        <source>Find the threshold in each frame; --threshold is the least</source>
        <translation>Trouver le seuil dans chaque trame&#xa0;; --threshold en est le minimum</translation>
    </message>
    <message>
        <source>Force and centre of pressure over taxels in contact, not over the whole array</source>
        <translation>Force et centre de pression sur les taxels en contact, non sur toute la matrice</translation>
    </message>
    <message>
        <source>Summits that rise less than this share of the frame&apos;s peak are no contacts of their own</source>
        <translation>Les sommets qui s’élèvent de moins que cette fraction du pic de la trame ne sont pas des contacts distincts</translation>
    </message>
    <message>
        <source>Contacts of fewer taxels are dropped</source>
        <translation>Les contacts de moins de taxels sont ignorés</translation>
    </message>
    <message>
        <source>the output would replace the input</source>
        <translation>la sortie remplacerait l’entrée</translation>
    </message>
    <message>
        <source>Gains of the taxels, as &quot;teleta gains&quot; writes them</source>
        <translation>Gains des taxels, tels que «&#xa0;teleta gains&#xa0;» les écrit</translation>
    </message>
    <message>
        <source>%1 is given, a number of columns, or columns such as 2..85 are expected</source>
        <translation>%1 est donné, un nombre de colonnes ou des colonnes comme 2..85 sont attendus</translation>
    </message>
    <message>
        <source>Columns of the array; or columns of a table of another program that are taxels, from 1, such as 2..85</source>
        <translation>Colonnes de la matrice&#xa0;; ou colonnes du tableau d’un autre programme qui sont des taxels, à partir de 1, comme 2..85</translation>
    </message>
    <message>
        <source>Frames per second of a file without times</source>
        <translation>Trames par seconde d’un fichier sans temps</translation>
    </message>
    <message>
        <source>Name of the frames in a file of several arrays</source>
        <translation>Nom des trames dans un fichier à plusieurs tableaux</translation>
    </message>
    <message>
        <source>Dimension of the array that counts the frames</source>
        <translation>Dimension du tableau qui compte les trames</translation>
    </message>
    <message>
        <source>Name or number of the column of the times in a table of another program</source>
        <translation>Nom ou numéro de la colonne des temps dans le tableau d’un autre programme</translation>
    </message>
    <message>
        <source>Unit of these times; default: as the name of the column ends</source>
        <translation>Unité de ces temps&#xa0;; par défaut&#xa0;: d’après la fin du nom de la colonne</translation>
    </message>
    <message>
        <source>Recorded frames: CSV time_s,t0,t1,... with one row a frame, row-major, or a file of another program</source>
        <translation>Trames enregistrées&#xa0;: CSV time_s,t0,t1,... avec une ligne par trame, taxels ligne par ligne, ou un fichier d’un autre programme</translation>
    </message>
    <message>
        <source>The values are in %1, not in N: give the N of one unit with --gain.</source>
        <translation>Les valeurs sont en&#xa0;%1, non en N&#xa0;: indiquez avec --gain combien de N vaut une unité.</translation>
    </message>
    <message>
        <source>Frames of the unloaded array, whose mean is subtracted; or of the recording itself the median of each taxel, the mean of the first half second, or its value while it is untouched, in at least one frame in ten</source>
        <translation>Trames du réseau sans charge, dont la moyenne est soustraite ; ou, de l’enregistrement lui-même, la médiane de chaque taxel, la moyenne de la première demi-seconde, ou sa valeur quand il n’est pas touché, dans au moins une trame sur dix</translation>
    </message>
    <message>
        <source>Add the place of deepest pressure, finer than the taxels, also on a strip</source>
        <translation>Ajouter l’endroit de pression la plus forte, plus fin que les taxels, aussi sur une bande</translation>
    </message>
    <message>
        <source>Standard deviation of a taxel&apos;s load at rest in N, for the standard errors of the summit</source>
        <translation>Écart type de la charge d’un taxel au repos en N, pour les erreurs types du sommet</translation>
    </message>
</context>
<context>
    <name>FrameReaderText</name>
    <message>
        <source>the file is %1</source>
        <translation>le fichier est&#xa0;%1</translation>
    </message>
    <message>
        <source>the frames do not fit into the memory</source>
        <translation>les trames ne tiennent pas en mémoire</translation>
    </message>
    <message>
        <source>the file has times of its own, in time_s</source>
        <translation>le fichier a ses propres temps, dans time_s</translation>
    </message>
    <message>
        <source>no rate</source>
        <translation>pas de fréquence</translation>
    </message>
    <message>
        <source>%1; a table of another program is read with %2</source>
        <translation>%1&#xa0;; le tableau d’un autre programme se lit avec&#xa0;%2</translation>
    </message>
    <message>
        <source>the file</source>
        <translation>le fichier</translation>
    </message>
    <message>
        <source>frames as CSV, npy, npz, HDF5, MAT, or Tekscan ASCII</source>
        <translation>des images en CSV, npy, npz, HDF5, MAT ou ASCII de Tekscan</translation>
    </message>
</context>
<context>
    <name>GainMap</name>
    <message>
        <source>dead</source>
        <translation>mort</translation>
    </message>
    <message>
        <source>too weak</source>
        <translation>trop faible</translation>
    </message>
    <message>
        <source>too strong</source>
        <translation>trop fort</translation>
    </message>
    <message>
        <source>stuck</source>
        <translation>bloqué</translation>
    </message>
    <message>
        <source>Taxel %1, row %2, column %3</source>
        <translation>Taxel %1, ligne %2, colonne %3</translation>
    </message>
    <message>
        <source>%1, not used</source>
        <translation>%1, non utilisé</translation>
    </message>
</context>
<context>
    <name>GainsCommand</name>
    <message>
        <source>Frames under load</source>
        <translation>Trames sous charge</translation>
    </message>
    <message>
        <source>Taxels used</source>
        <translation>Taxels utilisés</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 sur %2</translation>
    </message>
    <message>
        <source>Gains</source>
        <translation>Gains</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 à %2</translation>
    </message>
    <message>
        <source>Largest standard error</source>
        <translation>Plus grande erreur type</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Not explained</source>
        <translation>Non expliqué</translation>
    </message>
    <message>
        <source>%1 % of the level</source>
        <translation>%1 % du niveau</translation>
    </message>
    <message>
        <source>Tilt</source>
        <translation>Inclinaison</translation>
    </message>
    <message>
        <source>%1 % along x, %2 % along y</source>
        <translation>%1 % selon x, %2 % selon y</translation>
    </message>
    <message>
        <source>From press to press</source>
        <translation>D’un appui à l’autre</translation>
    </message>
    <message>
        <source>These taxels are not used: %1.</source>
        <translation>Ces taxels ne sont pas utilisés&#xa0;: %1.</translation>
    </message>
    <message>
        <source>The response changes by %1 % along x and %2 % along y: the load may have been uneven. Turn what presses round by half, press again and give both files.</source>
        <translation>La réponse change de %1 % selon x et de %2 % selon y&#xa0;: la charge était peut-être inégale. Tournez d’un demi-tour ce qui appuie, appuyez de nouveau et donnez les deux fichiers.</translation>
    </message>
    <message>
        <source>Gain of each taxel from frames under an even load</source>
        <translation>Gain de chaque taxel d’après des trames sous une charge uniforme</translation>
    </message>
    <message>
        <source>Recorded frames in which an even load presses on the whole array, a file a press: time_s,t0,t1,...</source>
        <translation>Trames enregistrées où une charge uniforme appuie sur toute la matrice, un fichier par appui&#xa0;: time_s,t0,t1,...</translation>
    </message>
</context>
<context>
    <name>GaugeTexts</name>
    <message>
        <source>no stiffness</source>
        <translation>pas de raideur</translation>
    </message>
    <message>
        <source>%1, level %2</source>
        <translation>%1, niveau %2</translation>
    </message>
    <message>
        <source>taken as %1, level %2</source>
        <translation>considéré comme %1, niveau %2</translation>
    </message>
    <message>
        <source>%1, level %2, not certain</source>
        <translation>%1, niveau %2, incertain</translation>
    </message>
    <message numerus="yes">
        <source>%n sample(s)</source>
        <translation>
            <numerusform>%n échantillon</numerusform>
            <numerusform>%n échantillons</numerusform>
        </translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>95 %: %1   %2</source>
        <translation>95&#xa0;%&#xa0;: %1   %2</translation>
    </message>
    <message>
        <source>not told from rigid   %1</source>
        <translation>non distingué du rigide   %1</translation>
    </message>
    <message>
        <source>no interval known   %1</source>
        <translation>intervalle inconnu   %1</translation>
    </message>
    <message>
        <source>Stiffer than the link allows: check contact distance and link stiffness.</source>
        <translation>Plus raide que le segment ne le permet&#xa0;: vérifiez la distance du contact et la raideur du segment.</translation>
    </message>
    <message>
        <source>level %1, %2, the paper&apos;s object %3</source>
        <translation>niveau %1, %2, objet de l’article&#xa0;: %3</translation>
    </message>
    <message>
        <source>rigid</source>
        <translation>rigide</translation>
    </message>
    <message>
        <source>%1: from %2
%3</source>
        <translation>%1&#xa0;: à partir de %2
%3</translation>
    </message>
    <message>
        <source>%1: under %2
%3</source>
        <translation>%1&#xa0;: moins de %2
%3</translation>
    </message>
    <message>
        <source>%1: %2 to %3
%4</source>
        <translation>%1&#xa0;: %2 à %3
%4</translation>
    </message>
    <message>
        <source>No stiffness. %1</source>
        <translation>Pas de raideur. %1</translation>
    </message>
    <message>
        <source>no touch yet</source>
        <translation>pas encore de toucher</translation>
    </message>
    <message>
        <source>cannot tell</source>
        <translation>indéterminé</translation>
    </message>
</context>
<context>
    <name>GelFollower</name>
    <message>
        <source>The picture could not be decoded.</source>
        <translation>L’image n’a pas pu être décodée.</translation>
    </message>
    <message>
        <source>The gel at rest cannot be taken: %1</source>
        <translation>Le gel au repos ne peut pas être pris&#xa0;: %1</translation>
    </message>
    <message>
        <source>The picture has no contrast: is the camera covered?</source>
        <translation>L’image n’a pas de contraste&#xa0;: la caméra est-elle couverte&#xa0;?</translation>
    </message>
    <message>
        <source>More than 30 % of the markers have been lost for 1 s: is the gel torn?</source>
        <translation>Plus de 30&#xa0;% des marqueurs sont perdus depuis 1&#xa0;s&#xa0;: le gel est-il déchiré&#xa0;?</translation>
    </message>
    <message>
        <source>The light has jumped.</source>
        <translation>La lumière a changé brusquement.</translation>
    </message>
    <message>
        <source>The recorded pictures of the gel at rest have another size than the video.</source>
        <translation>Les images enregistrées du gel au repos n’ont pas la taille de la vidéo.</translation>
    </message>
</context>
<context>
    <name>GelPicture</name>
    <message>
        <source>slip %1</source>
        <translation>glissement %1</translation>
    </message>
    <message>
        <source>slip unknown</source>
        <translation>glissement inconnu</translation>
    </message>
    <message>
        <source>Contact %1</source>
        <translation>Contact %1</translation>
    </message>
    <message>
        <source>at %1, %2</source>
        <translation>en %1, %2</translation>
    </message>
    <message>
        <source>area %1 mm²</source>
        <translation>aire %1 mm²</translation>
    </message>
    <message>
        <source>shear %1 at %2°</source>
        <translation>cisaillement %1 à %2°</translation>
    </message>
    <message>
        <source>turned by %1°</source>
        <translation>tourné de %1°</translation>
    </message>
    <message>
        <source>slip index %1</source>
        <translation>indice de glissement %1</translation>
    </message>
    <message>
        <source>too few markers for a slip index</source>
        <translation>trop peu de marqueurs pour un indice de glissement</translation>
    </message>
    <message>
        <source>No picture yet</source>
        <translation>Pas encore d’image</translation>
    </message>
    <message>
        <source>%1 mm (enlarged %2 times)</source>
        <translation>%1 mm (agrandi %2 fois)</translation>
    </message>
    <message>
        <source>PAUSED</source>
        <translation>EN PAUSE</translation>
    </message>
</context>
<context>
    <name>GelPlane</name>
    <message>
        <source>The lens in the file folds within the picture.</source>
        <translation>L’objectif décrit dans le fichier se replie dans l’image.</translation>
    </message>
    <message>
        <source>a lens that shows each place once</source>
        <translation>un objectif qui montre chaque point une seule fois</translation>
    </message>
    <message>
        <source>The homography sends pixels of the picture to infinity.</source>
        <translation>L’homographie envoie des pixels de l’image à l’infini.</translation>
    </message>
    <message>
        <source>a matrix that maps the picture onto a plane</source>
        <translation>une matrice qui projette l’image sur un plan</translation>
    </message>
</context>
<context>
    <name>GelRun</name>
    <message>
        <source>the gel at rest could not be found: %1</source>
        <translation>le gel au repos n’a pas été trouvé&#xa0;: %1</translation>
    </message>
    <message>
        <source>the scene ends before the gel at rest is known</source>
        <translation>la scène finit avant que le gel au repos soit connu</translation>
    </message>
    <message>
        <source>at least %1 pictures</source>
        <translation>au moins %1 images</translation>
    </message>
</context>
<context>
    <name>GelText</name>
    <message>
        <source>Only %1 markers were found in the picture.</source>
        <translation>Seuls %1 marqueurs ont été trouvés dans l’image.</translation>
    </message>
    <message>
        <source>at least %1 round spots of one size; check channel, marker and diameter_px in the sensor file</source>
        <translation>au moins %1 taches rondes de même taille&#xa0;; vérifiez channel, marker et diameter_px dans le fichier du capteur</translation>
    </message>
    <message>
        <source>The crop reaches out of the picture of %1 x %2 pixels.</source>
        <translation>Le recadrage dépasse l’image de %1 x %2 pixels.</translation>
    </message>
    <message>
        <source>x + width and y + height within the picture</source>
        <translation>x + largeur et y + hauteur dans l’image</translation>
    </message>
    <message>
        <source>The picture is black.</source>
        <translation>L’image est noire.</translation>
    </message>
    <message>
        <source>The picture has no contrast.</source>
        <translation>L’image n’a pas de contraste.</translation>
    </message>
    <message>
        <source>a picture of the gel&apos;s markers</source>
        <translation>une image des marqueurs du gel</translation>
    </message>
    <message>
        <source>The picture shows no grid of %1 x %2 markers: %3 spots, %4 of them in a grid.</source>
        <translation>L’image ne montre pas de grille de %1 x %2 marqueurs&#xa0;: %3 taches, dont %4 en grille.</translation>
    </message>
    <message>
        <source>The markers form no hexagonal grid: %1 of %2 spots do.</source>
        <translation>Les marqueurs ne forment pas de grille hexagonale&#xa0;: seules %1 taches sur %2.</translation>
    </message>
    <message>
        <source>the grid that the sensor&apos;s file names</source>
        <translation>la grille que nomme le fichier du capteur</translation>
    </message>
    <message>
        <source>The size of the picture has changed to %1 x %2.</source>
        <translation>La taille de l’image est passée à %1 x %2.</translation>
    </message>
    <message>
        <source>%1 x %2 pixels, as at the beginning</source>
        <translation>%1 x %2 pixels, comme au début</translation>
    </message>
</context>
<context>
    <name>HandStation</name>
    <message>
        <source>3D mouse: none is plugged in.</source>
        <translation>Souris 3D&#xa0;: aucune n’est branchée.</translation>
    </message>
    <message>
        <source>3D mouse: %1</source>
        <translation>Souris 3D&#xa0;: %1</translation>
    </message>
    <message>
        <source>3D mouse %1: moves the tip.</source>
        <translation>Souris 3D %1&#xa0;: déplace l’extrémité.</translation>
    </message>
    <message>
        <source>3D mouse %1: hold its first button to move the tip.</source>
        <translation>Souris 3D %1&#xa0;: maintenez son premier bouton pour déplacer l’extrémité.</translation>
    </message>
    <message>
        <source>3D mouse</source>
        <translation>Souris 3D</translation>
    </message>
</context>
<context>
    <name>Hdf5FileText</name>
    <message>
        <source>the file has too many datasets</source>
        <translation>le fichier a trop de jeux de données</translation>
    </message>
    <message>
        <source>at most %1</source>
        <translation>au plus&#xa0;%1</translation>
    </message>
    <message>
        <source>the HDF5 file is damaged: %1</source>
        <translation>le fichier HDF5 est endommagé&#xa0;:&#xa0;%1</translation>
    </message>
    <message>
        <source>a whole HDF5 file</source>
        <translation>un fichier HDF5 entier</translation>
    </message>
    <message>
        <source>it is damaged: %1</source>
        <translation>il est endommagé&#xa0;:&#xa0;%1</translation>
    </message>
    <message>
        <source>it has no values</source>
        <translation>il n’a pas de valeurs</translation>
    </message>
    <message>
        <source>it contains text</source>
        <translation>il contient des textes</translation>
    </message>
    <message>
        <source>its values are compound</source>
        <translation>ses valeurs ont plusieurs parties</translation>
    </message>
    <message>
        <source>its values are not real numbers</source>
        <translation>ses valeurs ne sont pas des nombres réels</translation>
    </message>
    <message>
        <source>its values are stored in other files</source>
        <translation>ses valeurs sont dans d’autres fichiers</translation>
    </message>
    <message>
        <source>it is compressed with %1; only gzip and shuffle can be read</source>
        <translation>il est compressé par&#xa0;%1&#xa0;; gzip et shuffle sont lus</translation>
    </message>
    <message>
        <source>its values were never written</source>
        <translation>ses valeurs n’ont jamais été écrites</translation>
    </message>
</context>
<context>
    <name>HeatmapPainter</name>
    <message>
        <source>x [mm]</source>
        <translation>x [mm]</translation>
    </message>
    <message>
        <source>y [mm]</source>
        <translation>y [mm]</translation>
    </message>
    <message>
        <source>fixed</source>
        <translation>fixe</translation>
    </message>
    <message>
        <source>auto</source>
        <translation>auto</translation>
    </message>
    <message>
        <source>force</source>
        <translation>force</translation>
    </message>
    <message>
        <source>contacts</source>
        <translation>contacts</translation>
    </message>
    <message>
        <source>type</source>
        <translation>type</translation>
    </message>
    <message>
        <source>none</source>
        <translation>aucun</translation>
    </message>
    <message>
        <source>point</source>
        <translation>point</translation>
    </message>
    <message>
        <source>edge</source>
        <translation>arête</translation>
    </message>
    <message>
        <source>centre of pressure</source>
        <translation>centre de pression</translation>
    </message>
    <message>
        <source>centre of contact</source>
        <translation>centre de contact</translation>
    </message>
    <message>
        <source>axis %1°</source>
        <translation>axe %1°</translation>
    </message>
    <message>
        <source>threshold %1</source>
        <translation>seuil %1</translation>
    </message>
    <message>
        <source>dead %1</source>
        <translation>morts %1</translation>
    </message>
    <message>
        <source>Point at a taxel to read it.</source>
        <translation>Pointez un taxel pour le lire.</translation>
    </message>
    <message>
        <source>No new data: the last frame is shown.</source>
        <translation>Pas de nouvelles données&#xa0;: la dernière trame est affichée.</translation>
    </message>
    <message>
        <source>shear</source>
        <translation>cisaillement</translation>
    </message>
    <message>
        <source>shear, a taxel&apos;s width is %1</source>
        <translation>cisaillement, la largeur d’un taxel vaut %1</translation>
    </message>
</context>
<context>
    <name>HeatmapView</name>
    <message>
        <source>dead</source>
        <translation>mort</translation>
    </message>
    <message>
        <source>contact #%1</source>
        <translation>contact n° %1</translation>
    </message>
    <message>
        <source>no contact</source>
        <translation>pas de contact</translation>
    </message>
    <message>
        <source>no taxel</source>
        <translation>pas de taxel</translation>
    </message>
    <message>
        <source>shear %1</source>
        <translation>cisaillement %1</translation>
    </message>
    <message>
        <source>row %1, column %2</source>
        <translation>ligne %1, colonne %2</translation>
    </message>
    <message>
        <source>taxel %1</source>
        <translation>taxel %1</translation>
    </message>
    <message>
        <source>%1   %2   %3   x %4 mm, y %5 mm</source>
        <translation>%1   %2   %3   x %4 mm, y %5 mm</translation>
    </message>
</context>
<context>
    <name>IdentifierText</name>
    <message>
        <source>&quot;%1&quot; cannot be part of a file name</source>
        <translation>«&#xa0;%1&#xa0;» ne peut pas figurer dans un nom de fichier</translation>
    </message>
    <message>
        <source>letters, digits, - and _</source>
        <translation>des lettres, des chiffres, - et _</translation>
    </message>
    <message>
        <source>each one once</source>
        <translation>chacun une seule fois</translation>
    </message>
    <message>
        <source>&quot;%1&quot; occurs twice</source>
        <translation>«&#xa0;%1&#xa0;» est présent deux fois</translation>
    </message>
</context>
<context>
    <name>ImportCommand</name>
    <message>
        <source>left out</source>
        <translation>laissé de côté</translation>
    </message>
    <message numerus="yes">
        <source>%n message(s)</source>
        <translation>
            <numerusform>%n message</numerusform>
            <numerusform>%n messages</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n damaged or of another shape</source>
        <translation>
            <numerusform>%n endommagé ou d’une autre forme</numerusform>
            <numerusform>%n endommagés ou d’une autre forme</numerusform>
        </translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Remarque</translation>
    </message>
    <message>
        <source>The file was cut off: %1 of %2 bytes could be read.</source>
        <translation>Le fichier a été coupé&#xa0;: %1 octets sur %2 ont pu être lus.</translation>
    </message>
    <message numerus="yes">
        <source>%n damaged chunk(s) left out</source>
        <translation>
            <numerusform>%n bloc (chunk) endommagé ignoré</numerusform>
            <numerusform>%n blocs (chunks) endommagés ignorés</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n damaged record(s) left out</source>
        <translation>
            <numerusform>%n entrée (record) endommagée ignorée</numerusform>
            <numerusform>%n entrées (records) endommagées ignorées</numerusform>
        </translation>
    </message>
    <message>
        <source>The checksum of the file is wrong: it was damaged somewhere.</source>
        <translation>La somme de contrôle du fichier est fausse&#xa0;: il a été endommagé quelque part.</translation>
    </message>
    <message>
        <source>Recording to be made</source>
        <translation>Enregistrement à créer</translation>
    </message>
    <message>
        <source>Read a topic as array, camera or joints, where its type leaves a choice</source>
        <translation>Lire un topic comme array, camera ou joints, là où son type laisse le choix</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not /TOPIC=array, /TOPIC=camera or /TOPIC=joints</source>
        <translation>«&#xa0;%1&#xa0;» n’est pas /TOPIC=array, /TOPIC=camera ni /TOPIC=joints</translation>
    </message>
    <message>
        <source>Array</source>
        <translation>Matrice</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>Trames</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>Cadence</translation>
    </message>
    <message>
        <source>MCAP file with ROS 2 messages, or frames of an array; the options below supply what a file of frames does not say</source>
        <translation>Fichier MCAP de messages de ROS 2, ou trames d’une matrice, dont les options ci-dessous disent ce que le fichier ne dit pas</translation>
    </message>
    <message>
        <source>Load in one unit of the values</source>
        <translation>Charge d’une unité des valeurs</translation>
    </message>
    <message>
        <source>Unit of the loads; default: as the file says, else N or counts, by the array</source>
        <translation>Unité des charges ; par défaut celle du fichier, sinon N ou counts, selon la matrice</translation>
    </message>
    <message>
        <source>Load from which a taxel is in contact, in the recording&apos;s settings</source>
        <translation>Charge à partir de laquelle un taxel est en contact, dans les réglages de l’enregistrement</translation>
    </message>
    <message>
        <source>this is for MCAP files only</source>
        <translation>ceci est pour MCAP, mais le fichier n’en est pas un</translation>
    </message>
    <message>
        <source>this is for frames, not for MCAP files</source>
        <translation>ceci est pour des trames, mais le fichier est en MCAP</translation>
    </message>
    <message>
        <source>Make a recording of an MCAP file, or of the frames of another program</source>
        <translation>Faire un enregistrement d’un fichier MCAP ou des trames d’un autre programme</translation>
    </message>
</context>
<context>
    <name>InputFileText</name>
    <message>
        <source>cannot open the file: %1</source>
        <translation>impossible d’ouvrir le fichier&#xa0;:&#xa0;%1</translation>
    </message>
    <message>
        <source>a file</source>
        <translation>un fichier</translation>
    </message>
    <message>
        <source>this is a folder</source>
        <translation>c’est un dossier</translation>
    </message>
    <message>
        <source>this is a pipe or a device</source>
        <translation>c’est un tube ou un périphérique</translation>
    </message>
    <message>
        <source>cannot read the file: %1</source>
        <translation>impossible de lire le fichier&#xa0;:&#xa0;%1</translation>
    </message>
    <message>
        <source>the file is too large</source>
        <translation>le fichier est trop grand</translation>
    </message>
    <message>
        <source>at most %1 MiB</source>
        <translation>au plus&#xa0;%1 Mio</translation>
    </message>
</context>
<context>
    <name>Interruption</name>
    <message>
        <source>interrupted; the output ends with what was computed until then</source>
        <translation>interrompu&#xa0;; la sortie s’arrête à ce qui avait été calculé</translation>
    </message>
</context>
<context>
    <name>JackText</name>
    <message>
        <source>none</source>
        <translation>aucune</translation>
    </message>
    <message>
        <source>PipeWire is not running.</source>
        <translation>PipeWire ne fonctionne pas.</translation>
    </message>
    <message>
        <source>The JACK server is not running.</source>
        <translation>Le serveur JACK ne fonctionne pas.</translation>
    </message>
    <message>
        <source>The sound server plays %1 samples a second.</source>
        <translation>Le serveur de son joue %1 échantillons par seconde.</translation>
    </message>
    <message>
        <source>sample_rate_Hz = %1 in the device file</source>
        <translation>sample_rate_Hz = %1 dans le fichier d’appareil</translation>
    </message>
    <message>
        <source>Another program plays on %1.</source>
        <translation>Un autre programme joue sur %1.</translation>
    </message>
    <message>
        <source>it to be disconnected, or shared = true in the device file</source>
        <translation>qu’il soit déconnecté, ou shared = true dans le fichier d’appareil</translation>
    </message>
    <message>
        <source>The sound server did not activate the connection.</source>
        <translation>Le serveur de son n’établit pas la connexion.</translation>
    </message>
    <message>
        <source>There are several sound cards: %1.</source>
        <translation>Il y a plusieurs cartes son&#xa0;: %1.</translation>
    </message>
    <message>
        <source>the name of one of them in device</source>
        <translation>le nom de l’une d’elles dans device</translation>
    </message>
    <message>
        <source>There is no sound card.</source>
        <translation>Il n’y a pas de carte son.</translation>
    </message>
    <message>
        <source>There is no sound output &quot;%1&quot;.</source>
        <translation>Il n’y a pas de sortie de son « %1&#xa0;».</translation>
    </message>
    <message>
        <source>one of: %1</source>
        <translation>l’un de&#xa0;: %1</translation>
    </message>
    <message numerus="yes">
        <source>&quot;%1&quot; has %n output(s).</source>
        <translation>
            <numerusform>« %1&#xa0;» a %n sortie.</numerusform>
            <numerusform>« %1&#xa0;» a %n sorties.</numerusform>
        </translation>
    </message>
    <message>
        <source>an output %1, as channels says</source>
        <translation>une sortie %1, comme l’indique channels</translation>
    </message>
    <message>
        <source>The sound server refused to create a port for a tactor.</source>
        <translation>Le serveur de son ne donne pas de port pour un actionneur.</translation>
    </message>
    <message>
        <source>Tactor %1 cannot be connected to %2.</source>
        <translation>L’actionneur %1 ne peut pas être relié à %2.</translation>
    </message>
    <message>
        <source>The sound server requests no samples.</source>
        <translation>Le serveur de son ne demande pas d’échantillons.</translation>
    </message>
    <message>
        <source>The sound server plays %1 samples at a time.</source>
        <translation>Le serveur de son joue %1 échantillons à la fois.</translation>
    </message>
    <message>
        <source>period_frames = %1 in the device file, or a server that plays %2 at a time</source>
        <translation>period_frames = %1 dans le fichier d’appareil, ou un serveur qui en joue %2 à la fois</translation>
    </message>
</context>
<context>
    <name>JogTargetText</name>
    <message>
        <source>%1 has no arm, or several</source>
        <translation>%1 n’a pas de bras, ou en a plusieurs</translation>
    </message>
    <message>
        <source>%1 has no arm &quot;%2&quot;</source>
        <translation>%1 n’a pas de bras « %2 »</translation>
    </message>
    <message>
        <source>the arm has no joint &quot;%1&quot;; it has %2</source>
        <translation>le bras n’a pas d’articulation «&#xa0;%1&#xa0;»&#xa0;; il a&#xa0;%2</translation>
    </message>
    <message>
        <source>%1 with one of %2</source>
        <translation>%1 avec l’un de %2</translation>
    </message>
</context>
<context>
    <name>JsonDocument</name>
    <message>
        <source>the file is too large</source>
        <translation>le fichier est trop grand</translation>
    </message>
    <message>
        <source>at most %1 MiB</source>
        <translation>au plus %1 MiB</translation>
    </message>
    <message>
        <source>the values are nested too deeply</source>
        <translation>les valeurs sont trop imbriquées</translation>
    </message>
    <message>
        <source>at most %1 levels</source>
        <translation>au plus %1 niveaux</translation>
    </message>
    <message>
        <source>an object has the key &quot;%1&quot; twice</source>
        <translation>un objet a la clé «&#xa0;%1&#xa0;» deux fois</translation>
    </message>
    <message>
        <source>each key once</source>
        <translation>chaque clé une seule fois</translation>
    </message>
    <message>
        <source>JSON in UTF-8</source>
        <translation>du JSON en UTF-8</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1&#xa0;: %2</translation>
    </message>
    <message>
        <source>this is not an object</source>
        <translation>ce n’est pas un objet</translation>
    </message>
    <message>
        <source>an object with the key &quot;%1&quot;</source>
        <translation>un objet avec la clé «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>the key &quot;%1&quot; is missing</source>
        <translation>la clé «&#xa0;%1&#xa0;» manque</translation>
    </message>
    <message>
        <source>an array of length %1</source>
        <translation>un tableau de longueur %1</translation>
    </message>
    <message>
        <source>an array of length %1 to %2</source>
        <translation>un tableau de longueur %1 à %2</translation>
    </message>
    <message>
        <source>this is not an array</source>
        <translation>ce n’est pas un tableau</translation>
    </message>
    <message>
        <source>a number from %1 to %2</source>
        <translation>un nombre de %1 à %2</translation>
    </message>
    <message>
        <source>this is not a number</source>
        <translation>ce n’est pas un nombre</translation>
    </message>
    <message>
        <source>%1 is out of range</source>
        <translation>%1 est hors limites</translation>
    </message>
    <message>
        <source>this is not a whole number</source>
        <translation>ce n’est pas un nombre entier</translation>
    </message>
    <message>
        <source>a whole number from %1 to %2</source>
        <translation>un nombre entier de %1 à %2</translation>
    </message>
    <message>
        <source>this is neither true nor false</source>
        <translation>ce n’est ni true ni false</translation>
    </message>
    <message>
        <source>this is not text</source>
        <translation>ce n’est pas du texte</translation>
    </message>
    <message>
        <source>text</source>
        <translation>du texte</translation>
    </message>
    <message>
        <source>the JSON text is damaged or truncated</source>
        <translation>le texte JSON est endommagé ou tronqué</translation>
    </message>
    <message>
        <source>the array has the wrong length</source>
        <translation>le tableau n’a pas la bonne longueur</translation>
    </message>
</context>
<context>
    <name>KeyListText</name>
    <message>
        <source>a list of %1, each %2</source>
        <translation>une liste de %1 éléments, chacun %2</translation>
    </message>
    <message>
        <source>a list of %1 to %2, each %3</source>
        <translation>une liste de %1 à %2 éléments, chacun %3</translation>
    </message>
</context>
<context>
    <name>LadderSweep</name>
    <message>
        <source>there is no such rung</source>
        <translation>cet échelon n’existe pas</translation>
    </message>
    <message>
        <source>there is no ladder &quot;%1&quot;</source>
        <translation>il n’y a pas d’échelle «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>one of: %1</source>
        <translation>l’un de&#xa0;: %1</translation>
    </message>
    <message>
        <source>unknown key &quot;%1&quot;</source>
        <translation>clé inconnue «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>rung</source>
        <translation>rung</translation>
    </message>
    <message>
        <source>there is no rung &quot;%1&quot;</source>
        <translation>il n’y a pas d’échelon «&#xa0;%1&#xa0;»</translation>
    </message>
</context>
<context>
    <name>LanguageMenu</name>
    <message>
        <source>Lan&amp;guage</source>
        <translation>&amp;Langue</translation>
    </message>
    <message>
        <source>As the &amp;desktop</source>
        <translation>Comme le &amp;bureau</translation>
    </message>
</context>
<context>
    <name>LastSession</name>
    <message>
        <source>camera</source>
        <translation>caméra</translation>
    </message>
</context>
<context>
    <name>LevelContent</name>
    <message>
        <source>All participants</source>
        <translation>Tous les participants</translation>
    </message>
    <message>
        <source>Thresholds of all participants</source>
        <translation>Seuils de tous les participants</translation>
    </message>
    <message>
        <source>Levels of %1 over the trials</source>
        <translation>Niveaux de %1 au fil des essais</translation>
    </message>
    <message>
        <source>d&apos; and c of all participants, %1</source>
        <translation>d&apos; et c de tous les participants, %1</translation>
    </message>
    <message>
        <source>Participant</source>
        <translation>Participant</translation>
    </message>
    <message>
        <source>Condition</source>
        <translation>Condition</translation>
    </message>
    <message>
        <source>Track</source>
        <translation>Piste</translation>
    </message>
    <message>
        <source>Trials</source>
        <translation>Essais</translation>
    </message>
    <message>
        <source>Threshold</source>
        <translation>Seuil</translation>
    </message>
    <message>
        <source>95 %</source>
        <translation>95&#xa0;%</translation>
    </message>
    <message>
        <source>Spread or slope</source>
        <translation>Dispersion ou pente</translation>
    </message>
    <message>
        <source>Lapses</source>
        <translation>Inattentions</translation>
    </message>
    <message>
        <source>p of fit</source>
        <translation>p d’ajustement</translation>
    </message>
    <message>
        <source>JND</source>
        <translation>JND</translation>
    </message>
    <message>
        <source>Weber</source>
        <translation>Weber</translation>
    </message>
    <message>
        <source>What it says</source>
        <translation>Ce qu’il indique</translation>
    </message>
    <message>
        <source>Where the curve is half-way between guessing and its upper end; of a comparison the level that feels equal</source>
        <translation>Là où la courbe est à mi-chemin entre la réponse au hasard et son extrémité supérieure&#xa0;; pour une comparaison, le niveau ressenti comme égal</translation>
    </message>
    <message>
        <source>By profile likelihood; of all participants Student&apos;s t of their thresholds. ? stands for an open end</source>
        <translation>Par vraisemblance profilée&#xa0;; pour tous les participants, t de Student de leurs seuils. ? signale une extrémité ouverte</translation>
    </message>
    <message>
        <source>s of gauss and logistic, in the unit of the level; the slope b of weibull</source>
        <translation>s de gauss et de logistic, dans l’unité du niveau&#xa0;; la pente b de weibull</translation>
    </message>
    <message>
        <source>Share of mistakes however strong the stimulus is</source>
        <translation>Part d’erreurs, si fort que soit le stimulus</translation>
    </message>
    <message>
        <source>Of the deviance, by data sets that are drawn and fitted again; constant stimuli only</source>
        <translation>De la déviance, par des jeux de données tirés puis ajustés à nouveau&#xa0;; stimuli constants seulement</translation>
    </message>
    <message>
        <source>Just noticeable difference: half of the way from 25 to 75 %</source>
        <translation>Différence juste perceptible&#xa0;: la moitié de l’écart de 25 à 75&#xa0;%</translation>
    </message>
    <message>
        <source>JND over the reference</source>
        <translation>JND divisée par la référence</translation>
    </message>
    <message>
        <source>mean of %1</source>
        <translation>moyenne de %1</translation>
    </message>
    <message>
        <source>mean of %1; %2 without threshold</source>
        <translation>moyenne de %1&#xa0;; %2 sans seuil</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Tous</translation>
    </message>
    <message>
        <source>Mean of reversals</source>
        <translation>Moyenne des inversions</translation>
    </message>
    <message>
        <source>Reversals</source>
        <translation>Inversions</translation>
    </message>
    <message>
        <source>Posterior mean</source>
        <translation>Moyenne a posteriori</translation>
    </message>
    <message>
        <source>Its sd</source>
        <translation>Son écart-type</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Remarque</translation>
    </message>
    <message>
        <source>The estimate of a staircase</source>
        <translation>L’estimation d’un escalier</translation>
    </message>
    <message>
        <source>The estimate of a Bayesian procedure</source>
        <translation>L’estimation d’une procédure bayésienne</translation>
    </message>
    <message>
        <source>On the scale of the levels: in log10 units on a logarithmic one</source>
        <translation>À l’échelle des niveaux&#xa0;: en unités log10 si elle est logarithmique</translation>
    </message>
    <message>
        <source>Hits</source>
        <translation>Détections correctes</translation>
    </message>
    <message>
        <source>False alarms</source>
        <translation>Fausses alarmes</translation>
    </message>
    <message>
        <source>d&apos;</source>
        <translation>d&apos;</translation>
    </message>
    <message>
        <source>c</source>
        <translation>c</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Méthode</translation>
    </message>
    <message>
        <source>Of how many trials with a stimulus; of several intervals right answers</source>
        <translation>Sur combien d’essais avec stimulus&#xa0;; à plusieurs intervalles, réponses correctes</translation>
    </message>
    <message>
        <source>Of how many trials without</source>
        <translation>Sur combien d’essais sans stimulus</translation>
    </message>
    <message>
        <source>Sensitivity; rates are (count + 1/2) / (trials + 1)</source>
        <translation>Sensibilité&#xa0;; les taux sont (nombre + 1/2) / (essais + 1)</translation>
    </message>
    <message>
        <source>Criterion: above 0 rather no; of two intervals below 0 rather the first</source>
        <translation>Critère&#xa0;: au-dessus de 0, plutôt non&#xa0;; à deux intervalles, au-dessous de 0, plutôt le premier</translation>
    </message>
    <message>
        <source>Without rules</source>
        <translation>Sans les règles</translation>
    </message>
    <message>
        <source>Threshold of all trials, including those that the rules leave out</source>
        <translation>Seuil de tous les essais, y compris ceux que les règles excluent</translation>
    </message>
    <message>
        <source>Speed, Hz</source>
        <translation>Vitesse, Hz</translation>
    </message>
    <message>
        <source>Of the motors at this level, by their measured curves; mean over the tactors</source>
        <translation>Des moteurs à ce niveau, d’après leurs courbes mesurées&#xa0;; moyenne sur les tacteurs</translation>
    </message>
    <message>
        <source>Force, %</source>
        <translation>Force,&#xa0;%</translation>
    </message>
    <message>
        <source>Square of that speed over the square of the speed at full drive</source>
        <translation>Carré de cette vitesse sur le carré de la vitesse à pleine commande</translation>
    </message>
    <message>
        <source>Weber of speed</source>
        <translation>Weber de la vitesse</translation>
    </message>
    <message>
        <source>By how much the speed rises from the reference to reference + JND</source>
        <translation>De combien la vitesse augmente de la référence à la référence + JND</translation>
    </message>
    <message>
        <source>Weber of force</source>
        <translation>Weber de la force</translation>
    </message>
    <message>
        <source>By how much the force rises from the reference to reference + JND</source>
        <translation>De combien la force augmente de la référence à la référence + JND</translation>
    </message>
    <message>
        <source>A level is a share of the range from a motor&apos;s start to its full drive. Connect the bracelet, and the speed of its motors in Hz and their force are shown beside the levels.</source>
        <translation>Un niveau est une part de la plage entre le démarrage d’un moteur et sa pleine commande. Connectez le bracelet&#xa0;: la vitesse de ses moteurs en Hz et leur force s’affichent à côté des niveaux.</translation>
    </message>
    <message>
        <source>A level is a share of the range from a motor&apos;s start to its full drive. Measure the motors of this bracelet on the page Calibrate, and their speed in Hz and their force are shown beside the levels.</source>
        <translation>Un niveau est une part de la plage entre le démarrage d’un moteur et sa pleine commande. Mesurez les moteurs de ce bracelet à la page Étalonnage&#xa0;: leur vitesse en Hz et leur force s’affichent à côté des niveaux.</translation>
    </message>
</context>
<context>
    <name>LevelSourceText</name>
    <message>
        <source>these are data of different modes: %1 and %2</source>
        <translation>ces données sont de modes différents&#xa0;: %1 et %2</translation>
    </message>
    <message>
        <source>one mode, or the choice of one</source>
        <translation>un seul mode, ou l’indication de celui qui compte</translation>
    </message>
    <message>
        <source>%1 cannot be &quot;%2&quot;</source>
        <translation>%1 ne peut pas être «&#xa0;%2&#xa0;»</translation>
    </message>
    <message>
        <source>nothing says which answers are correct</source>
        <translation>rien ne dit quelles réponses sont correctes</translation>
    </message>
    <message>
        <source>a column correct, or stimulus and response</source>
        <translation>une colonne correct, ou stimulus et response</translation>
    </message>
    <message>
        <source>practice or test</source>
        <translation>practice ou test</translation>
    </message>
    <message>
        <source>run, pilot or simulated</source>
        <translation>run, pilot ou simulated</translation>
    </message>
    <message>
        <source>correct, incorrect, timeout, aborted or device_error</source>
        <translation>correct, incorrect, timeout, aborted ou device_error</translation>
    </message>
    <message>
        <source>a number from %1 to %2, or NA</source>
        <translation>un nombre de %1 à %2, ou NA</translation>
    </message>
    <message>
        <source>yes_no, interval, same_different or compare, one for a task</source>
        <translation>yes_no, interval, same_different ou compare, un seul par tâche</translation>
    </message>
    <message>
        <source>0 or 1</source>
        <translation>0 ou 1</translation>
    </message>
    <message>
        <source>a value</source>
        <translation>une valeur</translation>
    </message>
    <message>
        <source>interrupted</source>
        <translation>interrompu</translation>
    </message>
</context>
<context>
    <name>LinkText</name>
    <message>
        <source>a serial port cannot run at %1 baud</source>
        <translation>un port série ne peut pas fonctionner à %1 bauds</translation>
    </message>
    <message>
        <source>one of %1</source>
        <translation>l’un de %1</translation>
    </message>
    <message>
        <source>cannot open %1: %2</source>
        <translation>impossible d’ouvrir %1&#xa0;: %2</translation>
    </message>
    <message>
        <source>%1 is not a serial port</source>
        <translation>%1 n’est pas un port série</translation>
    </message>
    <message>
        <source>cannot find %1: %2</source>
        <translation>impossible de trouver %1&#xa0;: %2</translation>
    </message>
    <message>
        <source>connecting was cancelled</source>
        <translation>la connexion a été annulée</translation>
    </message>
    <message>
        <source>cannot connect to %1: %2</source>
        <translation>impossible de se connecter à %1&#xa0;: %2</translation>
    </message>
    <message>
        <source>The link failed: %1.</source>
        <translation>La liaison a échoué&#xa0;: %1.</translation>
    </message>
    <message>
        <source>The sensor closed the connection.</source>
        <translation>Le capteur a fermé la connexion.</translation>
    </message>
    <message>
        <source>The device was unplugged.</source>
        <translation>L’appareil a été débranché.</translation>
    </message>
    <message>
        <source>The file has ended.</source>
        <translation>Le fichier est terminé.</translation>
    </message>
    <message>
        <source>The server closed the connection (code %1): %2</source>
        <translation>Le serveur a fermé la connexion (code %1)&#xa0;: %2</translation>
    </message>
    <message>
        <source>no answer</source>
        <translation>sans réponse</translation>
    </message>
    <message>
        <source>%1 is a folder, not a file</source>
        <translation>%1 est un dossier, pas un fichier</translation>
    </message>
    <message>
        <source>The other program closed the pipe.</source>
        <translation>L’autre programme a fermé le tube.</translation>
    </message>
</context>
<context>
    <name>LiveView</name>
    <message>
        <source>&quot;%1&quot; is no address</source>
        <translation>«&#xa0;%1&#xa0;» n’est pas une adresse</translation>
    </message>
    <message>
        <source>an address such as 127.0.0.1</source>
        <translation>une adresse comme 127.0.0.1</translation>
    </message>
    <message>
        <source>the live view cannot listen on %1:%2: %3</source>
        <translation>la vue en direct ne peut pas écouter sur %1:%2&#xa0;: %3</translation>
    </message>
    <message>
        <source>another port</source>
        <translation>un autre port</translation>
    </message>
</context>
<context>
    <name>LocateCommand</name>
    <message>
        <source>Camera file that teleta calibrate has written</source>
        <translation>Fichier de caméra écrit par teleta calibrate</translation>
    </message>
    <message>
        <source>CSV with the columns u_px,v_px</source>
        <translation>CSV avec les colonnes u_px,v_px</translation>
    </message>
    <message>
        <source>Points on the tactile cylinder that belong to pixels of its camera</source>
        <translation>Points du cylindre tactile que montrent des pixels de sa caméra</translation>
    </message>
</context>
<context>
    <name>MarkerGelFile</name>
    <message>
        <source>the plane is described twice</source>
        <translation>le plan est décrit deux fois</translation>
    </message>
    <message>
        <source>one of mm_per_px, homography and pitch_mm</source>
        <translation>un seul de mm_per_px, homography et pitch_mm</translation>
    </message>
    <message>
        <source>the matrix has no inverse</source>
        <translation>la matrice n’a pas d’inverse</translation>
    </message>
    <message>
        <source>a matrix that maps the picture onto a plane</source>
        <translation>une matrice qui projette l’image sur un plan</translation>
    </message>
    <message>
        <source>a part of a pixel cannot be cut off</source>
        <translation>une partie de pixel ne peut pas être coupée</translation>
    </message>
    <message>
        <source>whole numbers</source>
        <translation>des nombres entiers</translation>
    </message>
    <message>
        <source>the picture would be too small</source>
        <translation>l’image serait trop petite</translation>
    </message>
    <message>
        <source>at least 16 x 16 pixels</source>
        <translation>au moins 16 x 16 pixels</translation>
    </message>
    <message>
        <source>such small markers cannot be told from noise</source>
        <translation>de si petits marqueurs ne se distinguent pas du bruit</translation>
    </message>
    <message>
        <source>at least 2 px, or 0</source>
        <translation>au moins 2 px, ou 0</translation>
    </message>
    <message>
        <source>[plane] gives no scale</source>
        <translation>[plane] ne donne pas d’échelle</translation>
    </message>
</context>
<context>
    <name>MarkersText</name>
    <message>
        <source>the camera has stopped sending frames</source>
        <translation>la caméra n’envoie plus d’images</translation>
    </message>
    <message>
        <source>Video, pattern of numbered images (frame_%04d.png) or number of a camera; nothing touches the gel in the first frames. Default: the source that the sensor file names</source>
        <translation>Vidéo, motif d’images numérotées (frame_%04d.png) ou numéro d’une caméra&#xa0;; rien ne touche le gel dans les premières images. Par défaut&#xa0;: la source que le fichier du capteur indique</translation>
    </message>
    <message>
        <source>Sensor file of kind &quot;marker_gel&quot;</source>
        <translation>Fichier du capteur, de kind «&#xa0;marker_gel&#xa0;»</translation>
    </message>
    <message>
        <source>Print a summary instead of the table</source>
        <translation>Afficher un résumé au lieu du tableau</translation>
    </message>
    <message>
        <source>a summary is printed; --out writes the table</source>
        <translation>un bilan est affiché&#xa0;; --out écrit le tableau</translation>
    </message>
    <message>
        <source>neither a video is given nor does the sensor file name a source</source>
        <translation>aucune vidéo n’est donnée et le fichier du capteur n’indique pas de source</translation>
    </message>
    <message>
        <source>the video has no frame that can be decoded</source>
        <translation>la vidéo n’a aucune image décodable</translation>
    </message>
    <message>
        <source>the video has only one frame, so nothing moves in it</source>
        <translation>la vidéo n’a qu’une image, donc rien n’y bouge</translation>
    </message>
    <message>
        <source>at least two frames</source>
        <translation>au moins deux images</translation>
    </message>
    <message>
        <source>The picture has no contrast at %1 s: is the camera covered?</source>
        <translation>L’image n’a pas de contraste à %1 s&#xa0;: la caméra est-elle couverte&#xa0;?</translation>
    </message>
    <message>
        <source>The light jumps at %1 s</source>
        <translation>La lumière saute à %1 s</translation>
    </message>
    <message>
        <source>At %1 s more than 30 % of the markers have been lost for 1 s: is the gel torn?</source>
        <translation>À %1 s, plus de 30&#xa0;% des marqueurs sont perdus depuis 1 s&#xa0;: le gel est-il déchiré&#xa0;?</translation>
    </message>
    <message>
        <source>Frames that cannot be decoded: %1</source>
        <translation>Images indécodables&#xa0;: %1</translation>
    </message>
    <message>
        <source>Frames missing according to their time stamps: %1</source>
        <translation>Images manquantes d’après leurs horodatages&#xa0;: %1</translation>
    </message>
    <message>
        <source>frames</source>
        <translation>images</translation>
    </message>
    <message>
        <source>markers</source>
        <translation>marqueurs</translation>
    </message>
    <message>
        <source>found</source>
        <translation>trouvés</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>diameter</source>
        <translation>diamètre</translation>
    </message>
    <message>
        <source>%1 px</source>
        <translation>%1 px</translation>
    </message>
    <message>
        <source>distance of neighbours</source>
        <translation>distance des voisins</translation>
    </message>
    <message>
        <source>frames for the places at rest</source>
        <translation>images pour les positions de repos</translation>
    </message>
    <message>
        <source>noise of a place</source>
        <translation>bruit d’une position</translation>
    </message>
    <message>
        <source>largest displacement</source>
        <translation>plus grand déplacement</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>contacts</source>
        <translation>contacts</translation>
    </message>
    <message>
        <source>contact %1</source>
        <translation>contact %1</translation>
    </message>
    <message>
        <source>%1 s to %2 s, centre (%3, %4) mm</source>
        <translation>%1 s à %2 s, centre (%3, %4) mm</translation>
    </message>
    <message>
        <source>, slip index up to %1</source>
        <translation>, indice de glissement jusqu’à %1</translation>
    </message>
    <message>
        <source>, slip at %1 s</source>
        <translation>, glissement à %1 s</translation>
    </message>
    <message>
        <source>Follow the markers of a flat gel in a video</source>
        <translation>Suivre les marqueurs d’un gel plat dans une vidéo</translation>
    </message>
</context>
<context>
    <name>MatCheckText</name>
    <message>
        <source>the MAT file is damaged at byte %1: %2</source>
        <translation>le fichier MAT est endommagé à l’octet&#xa0;%1&#xa0;:&#xa0;%2</translation>
    </message>
    <message>
        <source>a whole MAT file</source>
        <translation>un fichier MAT entier</translation>
    </message>
    <message>
        <source>it ends within its header</source>
        <translation>il s’arrête dans son en-tête</translation>
    </message>
    <message>
        <source>it ends within the header of a variable</source>
        <translation>il s’arrête dans l’en-tête d’une variable</translation>
    </message>
    <message>
        <source>a variable has %1 bytes, there are %2</source>
        <translation>une variable a&#xa0;%1 octets, il y en a&#xa0;%2</translation>
    </message>
    <message>
        <source>a compressed variable cannot be decompressed</source>
        <translation>une variable compressée ne se décompresse pas</translation>
    </message>
    <message>
        <source>this is not the header of a variable</source>
        <translation>ce n’est pas l’en-tête d’une variable</translation>
    </message>
</context>
<context>
    <name>MatFileText</name>
    <message>
        <source>the file has too many variables</source>
        <translation>le fichier a trop de variables</translation>
    </message>
    <message>
        <source>at most %1</source>
        <translation>au plus&#xa0;%1</translation>
    </message>
    <message>
        <source>the MAT file is damaged</source>
        <translation>le fichier MAT est endommagé</translation>
    </message>
    <message>
        <source>a whole MAT file of version 4, 5, 6, 7 or 7.3</source>
        <translation>un fichier MAT entier de version 4, 5, 6, 7 ou 7.3</translation>
    </message>
    <message>
        <source>its values are complex</source>
        <translation>ses valeurs sont complexes</translation>
    </message>
    <message>
        <source>it is sparse</source>
        <translation>elle est creuse</translation>
    </message>
    <message>
        <source>it contains text</source>
        <translation>il contient des textes</translation>
    </message>
    <message>
        <source>it contains other variables</source>
        <translation>elle contient d’autres variables</translation>
    </message>
    <message>
        <source>its values are not real numbers</source>
        <translation>ses valeurs ne sont pas des nombres réels</translation>
    </message>
</context>
<context>
    <name>McapExport</name>
    <message>
        <source>there is no stream &quot;%1&quot;</source>
        <translation>il n’y a pas de flux «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>one of %1</source>
        <translation>l’un de %1</translation>
    </message>
    <message>
        <source>interrupted; nothing was written</source>
        <translation>interrompu&#xa0;; rien n’a été écrit</translation>
    </message>
    <message>
        <source>a file of this name already exists</source>
        <translation>il y a déjà un fichier de ce nom</translation>
    </message>
    <message>
        <source>another name</source>
        <translation>un autre nom</translation>
    </message>
</context>
<context>
    <name>McapFile</name>
    <message>
        <source>there is no such file</source>
        <translation>ce fichier n’existe pas</translation>
    </message>
    <message>
        <source>cannot be opened: %1</source>
        <translation>ouverture impossible&#xa0;: %1</translation>
    </message>
    <message>
        <source>this is not an MCAP file</source>
        <translation>ce n’est pas un fichier MCAP</translation>
    </message>
    <message>
        <source>an MCAP file, version 0</source>
        <translation>un fichier MCAP, version 0</translation>
    </message>
    <message>
        <source>the attachment &quot;%1&quot; is damaged</source>
        <translation>la pièce jointe «&#xa0;%1&#xa0;» est endommagée</translation>
    </message>
</context>
<context>
    <name>McapImport</name>
    <message>
        <source>%1 is of the type %2 and cannot be read as %3</source>
        <translation>%1 est du type %2 et ne peut pas être lu comme %3</translation>
    </message>
    <message>
        <source>there is no topic %1</source>
        <translation>il n’y a pas de topic %1</translation>
    </message>
    <message>
        <source>one of %1</source>
        <translation>l’un de %1</translation>
    </message>
    <message>
        <source>no topic of this file can be read: %1</source>
        <translation>aucun topic de ce fichier ne peut être lu&#xa0;: %1</translation>
    </message>
    <message>
        <source>it has none</source>
        <translation>il n’en a pas</translation>
    </message>
    <message>
        <source>messages of ROS 2 in CDR</source>
        <translation>des messages de ROS 2 en CDR</translation>
    </message>
    <message>
        <source>interrupted</source>
        <translation>interrompu</translation>
    </message>
</context>
<context>
    <name>MeshFile</name>
    <message>
        <source>mesh_path = &quot;FOLDER&quot;</source>
        <translation>mesh_path = &quot;DOSSIER&quot;</translation>
    </message>
    <message>
        <source>the mesh %1 is not in the folder of the arm&apos;s meshes</source>
        <translation>le maillage %1 n’est pas dans le dossier des maillages du bras</translation>
    </message>
    <message>
        <source>the mesh is missing</source>
        <translation>le maillage manque</translation>
    </message>
    <message>
        <source>meshes are read from STL, DAE and OBJ files</source>
        <translation>les maillages sont lus dans des fichiers STL, DAE et OBJ</translation>
    </message>
    <message>
        <source>the mesh is larger than %1 MB</source>
        <translation>le maillage dépasse %1 Mo</translation>
    </message>
    <message>
        <source>the mesh cannot be read: %1</source>
        <translation>le maillage ne peut pas être lu&#xa0;: %1</translation>
    </message>
    <message>
        <source>the arm&apos;s file does not set mesh_path</source>
        <translation>le fichier du bras ne définit pas mesh_path</translation>
    </message>
</context>
<context>
    <name>Modbus</name>
    <message>
        <source>%1 cannot be opened: %2</source>
        <translation>%1 ne peut pas être ouvert&#xa0;: %2</translation>
    </message>
    <message>
        <source>The device has no motors.</source>
        <translation>L’appareil n’a pas de moteurs.</translation>
    </message>
    <message>
        <source>a table [tactors] in its file</source>
        <translation>une table [tactors] dans son fichier</translation>
    </message>
    <message>
        <source>illegal function</source>
        <translation>fonction illégale</translation>
    </message>
    <message>
        <source>illegal data address</source>
        <translation>adresse de donnée illégale</translation>
    </message>
    <message>
        <source>illegal data value</source>
        <translation>valeur de donnée illégale</translation>
    </message>
    <message>
        <source>device failure</source>
        <translation>défaillance de l’appareil</translation>
    </message>
    <message>
        <source>acknowledge</source>
        <translation>accusé de réception</translation>
    </message>
    <message>
        <source>device busy</source>
        <translation>appareil occupé</translation>
    </message>
    <message>
        <source>negative acknowledge</source>
        <translation>accusé de réception négatif</translation>
    </message>
    <message>
        <source>memory parity error</source>
        <translation>erreur de parité mémoire</translation>
    </message>
    <message>
        <source>gateway path unavailable</source>
        <translation>chemin de passerelle indisponible</translation>
    </message>
    <message>
        <source>the device behind the gateway does not answer</source>
        <translation>l’appareil derrière la passerelle ne répond pas</translation>
    </message>
    <message>
        <source>not in the standard</source>
        <translation>absent de la norme</translation>
    </message>
    <message>
        <source>The server answered with exception %1: %2.</source>
        <translation>Le serveur a répondu par l’exception %1&#xa0;: %2.</translation>
    </message>
    <message>
        <source>The server did not answer in time.</source>
        <translation>Le serveur n’a pas répondu à temps.</translation>
    </message>
    <message>
        <source>The server&apos;s answer does not fit the request.</source>
        <translation>La réponse du serveur ne correspond pas à la requête.</translation>
    </message>
    <message>
        <source>The connection was lost.</source>
        <translation>La connexion a été perdue.</translation>
    </message>
    <message>
        <source>The device reports no joints.</source>
        <translation>L’appareil n’indique pas d’articulations.</translation>
    </message>
    <message>
        <source>tables [[joint]] in its file</source>
        <translation>des tables [[joint]] dans son fichier</translation>
    </message>
    <message>
        <source>this arm is read-only: it reports its joints but cannot be moved</source>
        <translation>ce bras est en lecture seule&#xa0;: il indique ses articulations mais ne peut pas être déplacé</translation>
    </message>
</context>
<context>
    <name>MotorFile</name>
    <message>
        <source>the limits belong to the bracelet &quot;%1&quot;</source>
        <translation>les limites sont celles du bracelet «&#xa0;%1&#xa0;»</translation>
    </message>
</context>
<context>
    <name>MotorFit</name>
    <message>
        <source>a motor that starts at the same drive each time; look for a loose contact</source>
        <translation>un moteur qui démarre toujours à la même commande&#xa0;; cherchez un faux contact</translation>
    </message>
    <message>
        <source>There is no step: the drive is the same all the time.</source>
        <translation>Il n’y a pas d’échelon&#xa0;: la commande est toujours la même.</translation>
    </message>
    <message>
        <source>a staircase of drives from 0 to the full one</source>
        <translation>un escalier de commandes de 0 à la pleine commande</translation>
    </message>
    <message>
        <source>The full drive was never commanded: the highest is %1.</source>
        <translation>La pleine commande n’a jamais été donnée&#xa0;: la plus forte est %1.</translation>
    </message>
    <message>
        <source>The recording does not begin at rest.</source>
        <translation>L’enregistrement ne commence pas au repos.</translation>
    </message>
    <message>
        <source>The recording is too short: no drive was held for %1 s.</source>
        <translation>L’enregistrement est trop court&#xa0;: aucune commande n’a été maintenue %1 s.</translation>
    </message>
    <message>
        <source>a drive that is held until the motor has followed, 0.3 s</source>
        <translation>une commande maintenue jusqu’à ce que le moteur ait suivi, 0.3 s</translation>
    </message>
    <message>
        <source>The recording is too short: %1 samples.</source>
        <translation>L’enregistrement est trop court&#xa0;: %1 échantillons.</translation>
    </message>
    <message>
        <source>at least %1</source>
        <translation>au moins %1</translation>
    </message>
    <message>
        <source>The motor does not turn, not even at the full drive.</source>
        <translation>Le moteur ne tourne pas, même à la pleine commande.</translation>
    </message>
    <message>
        <source>a connected motor, and its sensor</source>
        <translation>un moteur connecté, et son capteur</translation>
    </message>
    <message>
        <source>The speed is not 0 although nothing is commanded: %1 Hz.</source>
        <translation>La vitesse n’est pas nulle alors que rien n’est commandé&#xa0;: %1 Hz.</translation>
    </message>
    <message>
        <source>The speed is clipped: it stays at the end of the sensor&apos;s range.</source>
        <translation>La vitesse est écrêtée&#xa0;: elle reste à la limite de la plage du capteur.</translation>
    </message>
    <message>
        <source>a sensor with a larger range</source>
        <translation>un capteur de plus grande plage</translation>
    </message>
    <message>
        <source>a step down at the end</source>
        <translation>un échelon descendant à la fin</translation>
    </message>
    <message>
        <source>a supply and a sensor that reach the full drive</source>
        <translation>une alimentation et un capteur qui atteignent la pleine commande</translation>
    </message>
    <message>
        <source>The motor started at %1 of the full drive but stood still at %2.</source>
        <translation>Le moteur a démarré à %1 de la pleine commande mais était à l’arrêt à %2.</translation>
    </message>
    <message>
        <source>a commanded drive of 0 at the beginning</source>
        <translation>une commande de 0 au début</translation>
    </message>
    <message>
        <source>The rise time cannot be determined: %1 s with a standard error of %2 s.</source>
        <translation>Le temps de montée ne peut pas être déterminé&#xa0;: %1 s avec une erreur type de %2 s.</translation>
    </message>
    <message>
        <source>more samples per second, or less noise</source>
        <translation>plus d’échantillons par seconde, ou moins de bruit</translation>
    </message>
    <message>
        <source>The fall time cannot be determined: %1 s with a standard error of %2 s.</source>
        <translation>Le temps de descente ne peut pas être déterminé&#xa0;: %1 s avec une erreur type de %2 s.</translation>
    </message>
    <message>
        <source>The motor does not behave like a motor with a lag: the model explains %1 of the speed.</source>
        <translation>Le moteur ne suit pas la commande comme un moteur à retard&#xa0;: le modèle explique %1 de la vitesse.</translation>
    </message>
    <message>
        <source>a recording of one motor with the drive at the same times</source>
        <translation>l’enregistrement d’un seul moteur, avec la commande au même instant</translation>
    </message>
    <message>
        <source>a sensor without an offset, and a motor at rest at the beginning</source>
        <translation>un capteur sans décalage, et un moteur au repos au début</translation>
    </message>
    <message>
        <source>The motor turned at one level of the drive only: neither its start nor its curve can be determined.</source>
        <translation>Le moteur n’a tourné qu’à un seul niveau de commande&#xa0;: ni son démarrage ni sa courbe ne peuvent être déterminés.</translation>
    </message>
    <message>
        <source>The drive never falls while the motor turns: the fall time cannot be determined.</source>
        <translation>La commande ne descend jamais pendant que le moteur tourne&#xa0;: le temps de descente ne peut pas être déterminé.</translation>
    </message>
    <message>
        <source>The samples do not determine the motor&apos;s lag.</source>
        <translation>Les échantillons ne révèlent pas le retard du moteur.</translation>
    </message>
    <message>
        <source>more samples per second during the steps</source>
        <translation>plus d’échantillons par seconde pendant les échelons</translation>
    </message>
    <message>
        <source>The speed is saturated: it does not rise above %1 of the drive.</source>
        <translation>La vitesse est saturée&#xa0;: à partir de %1 de la commande, elle n’augmente plus.</translation>
    </message>
    <message>
        <source>The measurement does not describe a motor: the speed does not rise with the drive.</source>
        <translation>Les mesures ne décrivent pas un moteur&#xa0;: sa vitesse n’augmente pas avec la commande.</translation>
    </message>
</context>
<context>
    <name>MotorRecording</name>
    <message>
        <source>the time does not rise</source>
        <translation>le temps n’augmente pas</translation>
    </message>
    <message>
        <source>a time above %1 s</source>
        <translation>un temps supérieur à %1 s</translation>
    </message>
    <message>
        <source>the commanded drive is %1</source>
        <translation>la commande donnée est %1</translation>
    </message>
    <message>
        <source>a share of the full drive, 0 to 1</source>
        <translation>une fraction de la pleine commande, de 0 à 1</translation>
    </message>
    <message>
        <source>there is neither a column &quot;speed_hz&quot; nor &quot;signal&quot;</source>
        <translation>il n’y a ni colonne «&#xa0;speed_hz&#xa0;» ni colonne «&#xa0;signal&#xa0;»</translation>
    </message>
    <message>
        <source>sample %1 is not a finite number</source>
        <translation>l’échantillon %1 n’est pas un nombre fini</translation>
    </message>
    <message>
        <source>The recording does not begin at rest.</source>
        <translation>L’enregistrement ne commence pas au repos.</translation>
    </message>
    <message>
        <source>The signal is clipped: it stays at the end of its range.</source>
        <translation>Le signal est écrêté&#xa0;: il reste à la limite de sa plage.</translation>
    </message>
    <message>
        <source>a recording with less gain</source>
        <translation>un enregistrement avec moins de gain</translation>
    </message>
    <message>
        <source>The signal shows no vibration above its noise.</source>
        <translation>Le signal ne montre pas de vibration au-dessus de son bruit.</translation>
    </message>
    <message>
        <source>a sensor on the motor, with a signal above four times its noise</source>
        <translation>un capteur sur le moteur, avec un signal supérieur à quatre fois son bruit</translation>
    </message>
    <message>
        <source>the numbers of times, drives and speeds differ</source>
        <translation>les temps, commandes et vitesses ne sont pas en nombre égal</translation>
    </message>
    <message>
        <source>at least %1 s with a commanded drive of 0</source>
        <translation>au moins %1 s avec la commande 0</translation>
    </message>
    <message>
        <source>%1 samples per second are too few for %2 turns per second.</source>
        <translation>%1 échantillons par seconde sont trop peu pour %2 tours par seconde.</translation>
    </message>
    <message>
        <source>at least %1 samples per turn</source>
        <translation>au moins %1 échantillons par tour</translation>
    </message>
</context>
<context>
    <name>Mouse3d</name>
    <message>
        <source>The 3D mouse at %1 cannot be opened.</source>
        <translation>La souris 3D sur %1 ne peut pas être ouverte.</translation>
    </message>
    <message>
        <source>No 3D mouse is plugged in.</source>
        <translation>Aucune souris 3D n’est branchée.</translation>
    </message>
    <message>
        <source>The 3D mouse was unplugged.</source>
        <translation>La souris 3D a été débranchée.</translation>
    </message>
    <message>
        <source>No permission to open the 3D mouse at %1.</source>
        <translation>La souris 3D sur %1 ne peut pas être ouverte, faute d’autorisation.</translation>
    </message>
    <message>
        <source>read and write access, which the udev rule grants</source>
        <translation>un accès en lecture et en écriture, que donne la règle udev</translation>
    </message>
</context>
<context>
    <name>NewRecordingText</name>
    <message>
        <source>a file of this name already exists</source>
        <translation>un fichier de ce nom existe déjà</translation>
    </message>
    <message>
        <source>another name</source>
        <translation>un autre nom</translation>
    </message>
    <message>
        <source>the file cannot be given its name</source>
        <translation>le fichier ne peut pas recevoir son nom</translation>
    </message>
</context>
<context>
    <name>NodeClaim</name>
    <message>
        <source>another program uses %1</source>
        <comment>a device</comment>
        <translation>un autre programme utilise %1</translation>
    </message>
    <message>
        <source>it to be closed there first</source>
        <translation>qu’il y soit d’abord fermé</translation>
    </message>
</context>
<context>
    <name>NpyText</name>
    <message>
        <source>the head of the array is damaged at byte %1</source>
        <translation>l’en-tête du tableau est endommagé à l’octet&#xa0;%1</translation>
    </message>
    <message>
        <source>the file ends within the head of the array</source>
        <translation>le fichier se termine dans l’en-tête du tableau</translation>
    </message>
    <message>
        <source>a whole file</source>
        <translation>un fichier entier</translation>
    </message>
    <message>
        <source>descr, fortran_order and shape</source>
        <translation>descr, fortran_order et shape</translation>
    </message>
    <message>
        <source>the end of the head</source>
        <translation>la fin de l’en-tête</translation>
    </message>
    <message>
        <source>a text in quotes</source>
        <translation>un texte entre guillemets</translation>
    </message>
    <message>
        <source>a closing quote</source>
        <translation>un guillemet fermant</translation>
    </message>
    <message>
        <source>its values are structured, with fields</source>
        <translation>ses valeurs sont structurées, avec des champs</translation>
    </message>
    <message>
        <source>its values are of type &quot;%1&quot;</source>
        <translation>ses valeurs sont du type «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>its values are objects of Python, which were pickled</source>
        <translation>ses valeurs sont des objets Python sérialisés par pickle</translation>
    </message>
    <message>
        <source>its values are complex numbers</source>
        <translation>ses valeurs sont des nombres complexes</translation>
    </message>
    <message>
        <source>its values are texts</source>
        <translation>ses valeurs sont des textes</translation>
    </message>
    <message>
        <source>whole numbers of 0 or more</source>
        <translation>des nombres entiers supérieurs ou égaux à 0</translation>
    </message>
    <message>
        <source>npy of version %1.%2</source>
        <translation>npy de version&#xa0;%1.%2</translation>
    </message>
    <message>
        <source>version 1.0, 2.0 or 3.0</source>
        <translation>la version 1.0, 2.0 ou 3.0</translation>
    </message>
    <message>
        <source>a head of at most 1 MiB</source>
        <translation>un en-tête d’au plus 1 MiB</translation>
    </message>
    <message>
        <source>the file ends after %1 of %2 values</source>
        <translation>le fichier se termine après&#xa0;%1 valeurs sur&#xa0;%2</translation>
    </message>
    <message>
        <source>the file goes on behind the %1 values of its array</source>
        <translation>le fichier continue après les&#xa0;%1 valeurs de son tableau</translation>
    </message>
    <message>
        <source>one array</source>
        <translation>un seul tableau</translation>
    </message>
</context>
<context>
    <name>NpzExportText</name>
    <message>
        <source>the recording has no tactile array</source>
        <translation>l’enregistrement n’a pas de matrice tactile</translation>
    </message>
    <message>
        <source>frames of an array</source>
        <translation>les trames d’une matrice</translation>
    </message>
    <message>
        <source>the recording has no array &quot;%1&quot;</source>
        <translation>l’enregistrement n’a pas de matrice «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>the recording has several arrays</source>
        <translation>l’enregistrement a plusieurs matrices</translation>
    </message>
    <message>
        <source>one of them (--stream NAME): %1</source>
        <translation>l’une d’elles (--stream NAME)&#xa0;:&#xa0;%1</translation>
    </message>
    <message>
        <source>a file of this name already exists</source>
        <translation>il y a déjà un fichier de ce nom</translation>
    </message>
    <message>
        <source>another name</source>
        <translation>un autre nom</translation>
    </message>
    <message>
        <source>interrupted; nothing was written</source>
        <translation>interrompu&#xa0;; rien n’a été écrit</translation>
    </message>
    <message>
        <source>the recording is too long</source>
        <translation>l’enregistrement est trop long</translation>
    </message>
    <message>
        <source>at most %1 values</source>
        <translation>au plus&#xa0;%1 valeurs</translation>
    </message>
</context>
<context>
    <name>NpzWriterText</name>
    <message>
        <source>cannot write the file: %1</source>
        <translation>impossible d’écrire le fichier&#xa0;:&#xa0;%1</translation>
    </message>
</context>
<context>
    <name>NumpyFileText</name>
    <message>
        <source>the file ends after %1 of %2 values</source>
        <translation>le fichier se termine après&#xa0;%1 valeurs sur&#xa0;%2</translation>
    </message>
    <message>
        <source>a whole file</source>
        <translation>un fichier entier</translation>
    </message>
    <message>
        <source>the zip archive is damaged: %1</source>
        <translation>l’archive zip est endommagée&#xa0;:&#xa0;%1</translation>
    </message>
    <message>
        <source>a whole npz file</source>
        <translation>un fichier npz entier</translation>
    </message>
    <message>
        <source>the zip archive has too many files</source>
        <translation>l’archive zip a trop de fichiers</translation>
    </message>
    <message>
        <source>at most %1</source>
        <translation>au plus&#xa0;%1</translation>
    </message>
    <message>
        <source>the zip archive has no array of NumPy</source>
        <translation>l’archive zip n’a pas de tableau NumPy</translation>
    </message>
    <message>
        <source>an npz file, with files that end in .npy</source>
        <translation>un fichier npz, dont les fichiers se terminent par .npy</translation>
    </message>
    <message>
        <source>a whole npz file that is not encrypted</source>
        <translation>un fichier npz entier et non chiffré</translation>
    </message>
</context>
<context>
    <name>OperatorDomainText</name>
    <message>
        <source>without certificates anybody on this network could move the arm</source>
        <translation>sans certificats, n’importe qui sur ce réseau pourrait déplacer le bras</translation>
    </message>
    <message>
        <source>security = &quot;certificates&quot;, or interface = &quot;lo&quot;</source>
        <translation>security = &quot;certificates&quot;, ou interface = &quot;lo&quot;</translation>
    </message>
</context>
<context>
    <name>OscTrigger</name>
    <message>
        <source>the host for triggers was not found: %1</source>
        <translation>l’hôte des déclencheurs est introuvable&#xa0;: %1</translation>
    </message>
    <message>
        <source>a name or an address</source>
        <translation>un nom ou une adresse</translation>
    </message>
    <message>
        <source>triggers cannot be sent: %1</source>
        <translation>les déclencheurs ne peuvent pas être envoyés&#xa0;: %1</translation>
    </message>
</context>
<context>
    <name>OutputFileText</name>
    <message>
        <source>cannot write: %1</source>
        <translation>écriture impossible&#xa0;: %1</translation>
    </message>
    <message>
        <source>standard output</source>
        <translation>sortie standard</translation>
    </message>
    <message>
        <source>cannot make the folder</source>
        <translation>impossible de créer le dossier</translation>
    </message>
</context>
<context>
    <name>OutputText</name>
    <message>
        <source>Print one JSON document on standard output</source>
        <translation>Afficher un document JSON sur la sortie standard</translation>
    </message>
    <message>
        <source>Write the CSV to this file, which appears when it is complete</source>
        <translation>Écrire le CSV dans ce fichier, qui apparaît une fois complet</translation>
    </message>
</context>
<context>
    <name>OverlayMaker</name>
    <message>
        <source>%1: %2</source>
        <extracomment>A contact in the 3-D view: its number and its force</extracomment>
        <translation>%1&#xa0;: %2</translation>
    </message>
    <message>
        <source>Each block: the largest of %1 × %1 taxels</source>
        <translation>Chaque bloc&#xa0;: le maximum de %1 × %1 taxels</translation>
    </message>
    <message>
        <source>Cylinder enlarged to fit: radius %1, length %2</source>
        <translation>Cylindre agrandi pour contenir&#xa0;: rayon %1, longueur %2</translation>
    </message>
    <message>
        <source>Cylinder: radius %1, length %2</source>
        <translation>Cylindre&#xa0;: rayon %1, longueur %2</translation>
    </message>
    <message>
        <source>Grid: %1</source>
        <translation>Grille&#xa0;: %1</translation>
    </message>
    <message>
        <source>%1: ± %2</source>
        <extracomment>A contact on the tube in the 3-D view: its number and the standard deviation of its centre</extracomment>
        <translation>%1&#xa0;: ± %2</translation>
    </message>
    <message>
        <source>BUMP</source>
        <translation>CHOC</translation>
    </message>
    <message>
        <source>followed</source>
        <translation>suivi</translation>
    </message>
    <message>
        <source>Contact %1
Force %2, peak %3
x %4, y %5
Area %6</source>
        <translation>Contact %1
Force %2, pic %3
x %4, y %5
Aire %6</translation>
    </message>
    <message>
        <source>Tube: radius %1, length %2</source>
        <translation>Tube&#xa0;: rayon %1, longueur %2</translation>
    </message>
    <message>
        <source>Displacement of the skin × %1, fainter where uncertain</source>
        <translation>Déplacement de la peau × %1, plus pâle si incertain</translation>
    </message>
    <message>
        <source>Ellipses: 95 % regions of the centres</source>
        <translation>Les ellipses contiennent les centres à 95&#xa0;%</translation>
    </message>
    <message>
        <source>By the joints: %1</source>
        <translation>Par les articulations&#xa0;: %1</translation>
    </message>
    <message>
        <source>Moment: %1</source>
        <extracomment>A moment in the 3-D view</extracomment>
        <translation>Moment&#xa0;: %1</translation>
    </message>
    <message>
        <source>%1: %2°, range %3 … %4°</source>
        <extracomment>A joint in the 3-D view: its name, its angle, the ends of its range</extracomment>
        <translation>%1&#xa0;: %2°, plage %3 … %4°</translation>
    </message>
    <message>
        <source>Force, longest arrow: %1</source>
        <translation>Force, flèche la plus longue&#xa0;: %1</translation>
    </message>
    <message>
        <source>Moment, longest arrow: %1</source>
        <translation>Moment, flèche la plus longue&#xa0;: %1</translation>
    </message>
    <message>
        <source>At the wrist: %1</source>
        <translation>Au poignet&#xa0;: %1</translation>
    </message>
</context>
<context>
    <name>PairText</name>
    <message>
        <source>points at several heights and all around the cylinder</source>
        <translation>des points à plusieurs hauteurs et tout autour du cylindre</translation>
    </message>
    <message>
        <source>a coordinate is not a number, or too large</source>
        <translation>une coordonnée n’est pas un nombre, ou est trop grande</translation>
    </message>
    <message>
        <source>finite pixels and metres</source>
        <translation>des pixels et des mètres finis</translation>
    </message>
    <message>
        <source>there are too few pairs: %1</source>
        <translation>il y a trop peu de paires&#xa0;: %1</translation>
    </message>
    <message>
        <source>at least 6, better 50 or more</source>
        <translation>au moins 6, mieux 50 ou plus</translation>
    </message>
    <message>
        <source>at least 6 different points, each with its own pixel</source>
        <translation>au moins 6 points différents, chacun avec son propre pixel</translation>
    </message>
    <message>
        <source>no camera agrees with enough of the pairs</source>
        <translation>aucune caméra ne concorde avec assez de paires</translation>
    </message>
    <message>
        <source>the pairs leave the camera undetermined: points on the surface would be uncertain by more than %1 mm</source>
        <translation>les paires laissent la caméra indéterminée&#xa0;: les points de la surface seraient incertains de plus de %1 mm</translation>
    </message>
    <message>
        <source>more pairs, spread over the whole surface</source>
        <translation>plus de paires, réparties sur toute la surface</translation>
    </message>
    <message>
        <source>more pairs near the lens, where the distortion is strongest</source>
        <translation>plus de paires près de l’objectif, où la distorsion est la plus forte</translation>
    </message>
    <message>
        <source>a positive radius, width and height of 1 to %1 pixels</source>
        <translation>un rayon positif, une largeur et une hauteur de 1 à %1 pixels</translation>
    </message>
    <message>
        <source>interrupted</source>
        <translation>interrompu</translation>
    </message>
    <message>
        <source>the file has too many pairs</source>
        <translation>le fichier a trop de paires</translation>
    </message>
    <message>
        <source>at most %1</source>
        <translation>au plus %1</translation>
    </message>
    <message>
        <source>the size of the image or of the cylinder is invalid</source>
        <translation>l’image ou le cylindre n’a pas de taille utilisable</translation>
    </message>
    <message>
        <source>the pairs contain fewer than six different points</source>
        <translation>les paires répètent moins de six points différents</translation>
    </message>
    <message>
        <source>all points are on one line of the cylinder: the camera could turn about that line without changing the image</source>
        <translation>tous les points sont sur une même droite du cylindre&#xa0;: la caméra peut tourner autour de cette droite sans que l’image change</translation>
    </message>
    <message>
        <source>all points are on one ring of the cylinder: the camera&apos;s distance and its focal length cannot be distinguished</source>
        <translation>tous les points sont sur un même anneau du cylindre&#xa0;: la distance de la caméra et sa focale ne peuvent pas être distinguées</translation>
    </message>
    <message>
        <source>all points are in one plane: the camera&apos;s distance and its focal length cannot be distinguished</source>
        <translation>tous les points sont dans un même plan&#xa0;: la distance de la caméra et sa focale ne peuvent pas être distinguées</translation>
    </message>
    <message>
        <source>at least half of the pairs and at least %1 in agreement: check that pixels and points match, the image size and the cylinder radius</source>
        <translation>la moitié des paires et au moins %1 concordantes&#xa0;: pixels dans l’ordre de leurs points, bonne taille d’image et bon rayon de cylindre</translation>
    </message>
    <message>
        <source>the lens model folds in the region of the pairs</source>
        <translation>le modèle d’objectif se replie dans la zone des paires</translation>
    </message>
    <message>
        <source>most points are on the axis of the cylinder, not on its surface</source>
        <translation>la plupart des points sont sur l’axe du cylindre, pas sur sa surface</translation>
    </message>
    <message>
        <source>the points are %1 mm from the axis, the surface is at %2 mm: a hole factor of %3 (standard error %4) brings them onto it, unless the radius is wrong</source>
        <translation>les points sont à %1 mm de l’axe, la surface à %2 mm&#xa0;: un facteur des trous de %3 (erreur type %4) les y amène, à moins que le rayon ne soit faux</translation>
    </message>
    <message>
        <source>many points are beyond the ends of the cylinder: check its length, and where z = 0 is</source>
        <translation>beaucoup de points sont au-delà des extrémités du cylindre&#xa0;: vérifiez sa longueur et l’endroit où z = 0</translation>
    </message>
    <message>
        <source>u and v seem to be swapped: the principal point is %1 px off the middle of the image, and with u and v swapped %2 px</source>
        <translation>u et v semblent échangés&#xa0;: le point principal est à %1 px du milieu de l’image, et à %2 px si l’on échange u et v</translation>
    </message>
    <message>
        <source>many pixels are outside the image of %1 x %2 px: check its size</source>
        <translation>beaucoup de pixels sont hors de l’image de %1 x %2 px&#xa0;: vérifiez sa taille</translation>
    </message>
    <message>
        <source>neighbouring residuals are alike: the camera does not explain everything in the pairs (a shell that has moved, a wrong radius)</source>
        <translation>les résidus voisins se ressemblent&#xa0;: la caméra n’explique pas tout ce que contiennent les paires (une enveloppe qui a bougé, un rayon faux)</translation>
    </message>
</context>
<context>
    <name>PartText</name>
    <message>
        <source>a part of the program cannot be loaded: %1</source>
        <translation>une partie du programme ne peut pas être chargée&#xa0;:&#xa0;%1</translation>
    </message>
    <message>
        <source>a complete installation of the program</source>
        <translation>une installation complète du programme</translation>
    </message>
</context>
<context>
    <name>ParticipantReport</name>
    <message>
        <source>In this part nothing was tested yet.</source>
        <translation>Dans cette partie, rien n’a encore été testé.</translation>
    </message>
    <message>
        <source>You answered %1 of %2 trials correctly: %3 %.</source>
        <comment>numbers</comment>
        <translation>Vous avez répondu correctement à %1 essais sur %2&#xa0;: %3&#xa0;%.</translation>
    </message>
    <message>
        <source>There were %1 possible answers. Whoever guesses is right in about %2 % of the trials.</source>
        <translation>Il y avait %1 réponses possibles. Qui devine a raison dans environ %2&#xa0;% des essais.</translation>
    </message>
    <message numerus="yes">
        <source>In %n trial(s) the time was over before you answered.</source>
        <translation>
            <numerusform>Dans %n essai, le temps était écoulé avant votre réponse.</numerusform>
            <numerusform>Dans %n essais, le temps était écoulé avant votre réponse.</numerusform>
        </translation>
    </message>
    <message>
        <source>Half of your correct answers came within %1 seconds.</source>
        <translation>La moitié de vos réponses correctes ont été données en %1 secondes au plus.</translation>
    </message>
    <message>
        <source>You recognised these every time: %1.</source>
        <translation>Vous avez reconnu ceux-ci à chaque fois&#xa0;: %1.</translation>
    </message>
    <message>
        <source>, </source>
        <comment>between names</comment>
        <translation>, </translation>
    </message>
    <message>
        <source>This part was not finished.</source>
        <translation>Cette partie n’a pas été terminée.</translation>
    </message>
    <message>
        <source>Thank you for taking part in the study &quot;%1&quot;.</source>
        <translation>Merci d’avoir participé à l’étude «&#xa0;%1&#xa0;».</translation>
    </message>
    <message>
        <source>You have not begun yet.</source>
        <translation>Vous n’avez pas encore commencé.</translation>
    </message>
    <message>
        <source>This page has your answers alone. They say how well these vibrations can be told apart on this bracelet; they are no test of health.</source>
        <translation>Cette page contient vos réponses seules. Elles indiquent à quel point ces vibrations peuvent être distinguées sur ce bracelet&#xa0;; ce n’est pas un test de santé.</translation>
    </message>
    <message>
        <source>Completed test trials of each session; the interval is Wilson&apos;s (95 %)</source>
        <translation>Essais de test achevés de chaque session&#xa0;; l’intervalle est celui de Wilson (95&#xa0;%)</translation>
    </message>
    <message>
        <source>Session</source>
        <translation>Session</translation>
    </message>
    <message>
        <source>Task</source>
        <translation>Tâche</translation>
    </message>
    <message>
        <source>Condition</source>
        <translation>Condition</translation>
    </message>
    <message>
        <source>Finished</source>
        <translation>Terminée</translation>
    </message>
    <message>
        <source>Correct</source>
        <translation>Correctes</translation>
    </message>
    <message>
        <source>%</source>
        <translation>%</translation>
    </message>
    <message>
        <source>Interval, %</source>
        <translation>Intervalle,&#xa0;%</translation>
    </message>
    <message>
        <source>No answer</source>
        <translation>Sans réponse</translation>
    </message>
    <message>
        <source>Device faults</source>
        <translation>Défauts d’appareil</translation>
    </message>
    <message>
        <source>Median time, s</source>
        <translation>Temps médian, s</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>oui</translation>
    </message>
    <message>
        <source>no</source>
        <translation>non</translation>
    </message>
    <message>
        <source>Rows: presented; columns: answered. Number of trials.</source>
        <translation>Lignes&#xa0;: présenté&#xa0;; colonnes&#xa0;: répondu. Nombre d’essais.</translation>
    </message>
    <message>
        <source>Question</source>
        <translation>Question</translation>
    </message>
    <message>
        <source>Answer</source>
        <translation>Réponse</translation>
    </message>
    <message>
        <source>no answer</source>
        <translation>sans réponse</translation>
    </message>
    <message>
        <source>Questionnaires</source>
        <translation>Questionnaires</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>Notes</translation>
    </message>
    <message>
        <source>the study has no participant &quot;%1&quot;</source>
        <translation>l’étude n’a pas de participant «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>Your results</source>
        <translation>Vos résultats</translation>
    </message>
    <message>
        <source>Study: %1. Participant %2 in the order of enrolment.</source>
        <translation>Étude&#xa0;: %1. Participant %2 dans l’ordre d’inscription.</translation>
    </message>
    <message>
        <source>No session has begun.</source>
        <translation>Aucune session n’a commencé.</translation>
    </message>
    <message>
        <source>Participant %1</source>
        <comment>an id</comment>
        <translation>Participant %1</translation>
    </message>
</context>
<context>
    <name>PatternCommand</name>
    <message>
        <source>shape</source>
        <translation>forme</translation>
    </message>
    <message>
        <source>stiffness</source>
        <translation>raideur</translation>
    </message>
    <message>
        <source>other</source>
        <translation>autre</translation>
    </message>
    <message>
        <source>-</source>
        <translation>-</translation>
    </message>
    <message>
        <source>static</source>
        <translation>statique</translation>
    </message>
    <message>
        <source>dynamic</source>
        <translation>dynamique</translation>
    </message>
    <message>
        <source>Id</source>
        <translation>Id</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nom</translation>
    </message>
    <message>
        <source>Task</source>
        <translation>Tâche</translation>
    </message>
    <message>
        <source>Condition</source>
        <translation>Condition</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>Durée</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>Tags</source>
        <translation>Étiquettes</translation>
    </message>
    <message>
        <source>Objects</source>
        <translation>Objets</translation>
    </message>
    <message>
        <source>%1 s: %2</source>
        <translation>%1 s&#xa0;: %2</translation>
    </message>
    <message>
        <source>... (%1 breakpoints)</source>
        <translation>... (%1 nœuds)</translation>
    </message>
    <message>
        <source>Tactor %1</source>
        <translation>Tacteur %1</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>Notes</translation>
    </message>
    <message>
        <source>Object %1</source>
        <translation>Objet %1</translation>
    </message>
    <message>
        <source>Object %1 (%2)</source>
        <translation>Objet %1 (%2)</translation>
    </message>
    <message>
        <source>Pattern file or id of a built-in pattern</source>
        <translation>Fichier de motif ou identifiant d’un motif intégré</translation>
    </message>
    <message>
        <source>List the built-in patterns</source>
        <translation>Lister les motifs intégrés</translation>
    </message>
    <message>
        <source>Show what a pattern consists of</source>
        <translation>Montrer de quoi un motif se compose</translation>
    </message>
    <message>
        <source>Sample a pattern: rows time_s,t1..t6 over its duration</source>
        <translation>Échantillonner un motif&#xa0;: lignes time_s,t1..t6 sur sa durée</translation>
    </message>
    <message>
        <source>Samples a second</source>
        <translation>Échantillons par seconde</translation>
    </message>
    <message>
        <source>Write the CSV to this file, which appears when it is complete</source>
        <translation>Écrire le CSV dans ce fichier, qui apparaît une fois complet</translation>
    </message>
    <message>
        <source>File to write</source>
        <translation>Fichier à écrire</translation>
    </message>
    <message>
        <source>Say where a pattern breaks a law of what can be felt</source>
        <translation>Dire où un motif enfreint une loi de ce qui peut être senti</translation>
    </message>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
    <message>
        <source>%1 keeps all laws.</source>
        <translation>%1 respecte toutes les lois.</translation>
    </message>
    <message>
        <source>%1, %2 s to %3 s: %4 %5</source>
        <translation>%1, %2 s à %3 s&#xa0;: %4 %5</translation>
    </message>
    <message>
        <source>List, show, sample, convert, check and play the patterns of the bracelet</source>
        <translation>Lister, montrer, échantillonner, convertir, vérifier et jouer les motifs du bracelet</translation>
    </message>
    <message>
        <source>Profile of the bracelet&apos;s motors, as the page Calibrate saves it</source>
        <translation>Profil des moteurs du bracelet, tel que l’enregistre la page Étalonnage</translation>
    </message>
    <message>
        <source>What the motors will do; without --motors with an assumed motor: lag, start and speed are not measured</source>
        <translation>Ce que feront les moteurs&#xa0;; sans --motors, avec un moteur supposé&#xa0;: retard, démarrage et vitesse ne sont pas mesurés</translation>
    </message>
    <message>
        <source>Samples a second of CSV (default 200) and WAV (default 8000)</source>
        <translation>Échantillons par seconde du CSV (par défaut 200) et du WAV (par défaut 8000)</translation>
    </message>
    <message>
        <source>CSV and WAV: what the motors will do, with an assumed motor: lag, start and speed are not measured</source>
        <translation>CSV et WAV&#xa0;: ce que feront les moteurs, avec un moteur supposé&#xa0;: retard, démarrage et vitesse ne sont pas mesurés</translation>
    </message>
    <message>
        <source>Play a pattern on a bracelet</source>
        <translation>Jouer un motif sur un bracelet</translation>
    </message>
    <message>
        <source>%1 holds no samples: --rate and --predicted are for .csv and .wav files</source>
        <translation>%1 ne contient pas d’échantillons&#xa0;: --rate et --predicted sont pour les fichiers .csv et .wav</translation>
    </message>
    <message>
        <source>usb, simulated, or a file that describes a bracelet</source>
        <translation>usb, simulated, ou un fichier décrivant un bracelet</translation>
    </message>
    <message>
        <source>Speed the motors up with full intensity first, for as long as their profile allows</source>
        <translation>Aider les moteurs à démarrer&#xa0;: pleine intensité pendant qu’ils accélèrent, aussi longtemps que leur profil le permet</translation>
    </message>
    <message>
        <source>Write a pattern in another format, chosen by the ending</source>
        <translation>Écrire un motif dans un autre format, indiqué par l’extension</translation>
    </message>
    <message>
        <source>Repeat it for this long, then send live setpoints for as long again, and print how punctual the frames were</source>
        <translation>Le jouer en continu pendant cette durée, puis des consignes en direct pendant la même durée, et afficher la ponctualité des trames</translation>
    </message>
    <message>
        <source>the ending of %1 is not that of a format; expected one of %2</source>
        <translation>l’extension de %1 n’indique aucun format&#xa0;; attendu l’un de %2</translation>
    </message>
    <message>
        <source>Ending that chooses the format when OUT is -, for example json</source>
        <translation>Extension qui choisit le format quand OUT est -, par exemple json</translation>
    </message>
    <message>
        <source>it belongs to OUT as -, where it is needed</source>
        <translation>elle va avec OUT donné comme -, où elle est nécessaire</translation>
    </message>
    <message>
        <source>The samples are vibrations of %1 Hz with the intensities of the pattern.</source>
        <translation>Les échantillons sont des vibrations de&#xa0;%1 Hz avec les intensités du motif.</translation>
    </message>
    <message>
        <source>The samples are the bare intensities, which move no voice coil: --carrier writes vibrations.</source>
        <translation>Les échantillons sont les intensités brutes, qui ne font bouger aucune bobine mobile&#xa0;: --carrier écrit des vibrations.</translation>
    </message>
    <message>
        <source>WAV: vibrations of this frequency, for voice coils, instead of the bare intensities; 250 without a number</source>
        <translation>WAV&#xa0;: des vibrations de cette fréquence, pour des actionneurs à bobine mobile, au lieu des intensités brutes&#xa0;; 250 sans nombre</translation>
    </message>
    <message>
        <source>A file with one signal: the tactors that play it, for example 1,4; all without this</source>
        <translation>Un fichier à un seul signal&#xa0;: les tacteurs qui le jouent, par exemple 1,4&#xa0;; tous sans cette option</translation>
    </message>
    <message>
        <source>A .tact file with both arms: the one to read; left without this</source>
        <translation>Un fichier .tact avec les deux bras&#xa0;: celui à lire&#xa0;; le gauche sans cette option</translation>
    </message>
    <message>
        <source>expected numbers from 1 to 6 between commas</source>
        <translation>nombres de 1 à 6 séparés par des virgules attendus</translation>
    </message>
    <message>
        <source>it belongs to a file with one signal</source>
        <translation>elle va avec un fichier à un seul signal</translation>
    </message>
    <message>
        <source>it is for .wav files</source>
        <translation>elle concerne les fichiers .wav</translation>
    </message>
</context>
<context>
    <name>PatternFile</name>
    <message>
        <source>there is no tactor for the file &quot;%1&quot;</source>
        <translation>il n’y a pas de tacteur pour le fichier «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>the pattern is too long for a WAV file</source>
        <translation>le motif est trop long pour un fichier WAV</translation>
    </message>
    <message>
        <source>at most 4 GiB of samples</source>
        <translation>au plus 4 GiB d’échantillons</translation>
    </message>
    <message>
        <source>a time that is not before the start</source>
        <translation>un temps qui ne précède pas le début</translation>
    </message>
    <message>
        <source>this effect is for other devices</source>
        <translation>cet effet est pour d’autres appareils</translation>
    </message>
    <message>
        <source>a pattern file that ends with .json</source>
        <translation>un fichier de motif qui se termine par .json</translation>
    </message>
    <message>
        <source>the key &quot;recovery&quot;</source>
        <translation>la clé «&#xa0;recovery&#xa0;»</translation>
    </message>
    <message>
        <source>a WAV file cannot have this rate</source>
        <translation>un fichier WAV ne peut pas avoir cette fréquence</translation>
    </message>
    <message>
        <source>the pattern is too long for overdrive</source>
        <translation>le motif est trop long pour la surintensité</translation>
    </message>
    <message>
        <source>at most %1 s</source>
        <translation>au plus %1&#xa0;s</translation>
    </message>
    <message>
        <source>the pattern has too many corners</source>
        <translation>le motif a trop de coins</translation>
    </message>
    <message>
        <source>at most %1 breakpoints</source>
        <translation>au plus %1 nœuds</translation>
    </message>
    <message>
        <source>the pattern cannot be stretched by this factor</source>
        <translation>le motif ne peut pas être étiré ainsi</translation>
    </message>
    <message>
        <source>a factor above 0 that makes it at most a day long</source>
        <translation>un facteur supérieur à 0 avec lequel il dure au plus un jour</translation>
    </message>
    <message>
        <source>the times decrease</source>
        <translation>les temps reculent</translation>
    </message>
    <message>
        <source>a time that is not before the previous one</source>
        <translation>un temps qui ne précède pas le temps d’avant</translation>
    </message>
    <message>
        <source>a pattern cannot represent this</source>
        <translation>un motif ne peut pas contenir cela</translation>
    </message>
    <message>
        <source>the times decrease or exceed the longest pattern</source>
        <translation>les temps reculent ou durent trop</translation>
    </message>
    <message>
        <source>the folder cannot be created</source>
        <translation>le dossier ne peut pas être créé</translation>
    </message>
    <message>
        <source>this format cannot store another name</source>
        <translation>ce format ne peut pas contenir un autre nom</translation>
    </message>
    <message>
        <source>this name is unknown</source>
        <translation>ce nom n’est pas connu</translation>
    </message>
    <message>
        <source>this is a different format</source>
        <translation>c’est un autre format</translation>
    </message>
    <message>
        <source>the file was written by a newer version</source>
        <translation>le fichier est d’une version plus récente</translation>
    </message>
    <message>
        <source>this is not a recovery file</source>
        <translation>ce n’est pas un fichier de récupération</translation>
    </message>
    <message>
        <source>the sample rate is out of range</source>
        <translation>la fréquence d’échantillonnage est hors limites</translation>
    </message>
    <message>
        <source>%1 to %2 per second</source>
        <translation>%1 à %2 par seconde</translation>
    </message>
    <message>
        <source>the values of a motor are inconsistent</source>
        <translation>les valeurs d’un moteur se contredisent</translation>
    </message>
    <message>
        <source>a whole number of samples per second</source>
        <translation>un nombre entier d’échantillons par seconde</translation>
    </message>
    <message>
        <source>this part is not known</source>
        <translation>cette partie est inconnue</translation>
    </message>
    <message>
        <source>too many pieces overlap</source>
        <translation>trop de segments se chevauchent</translation>
    </message>
    <message>
        <source>a pattern of at most %1 objects</source>
        <translation>un motif d’au plus&#xa0;%1 objets</translation>
    </message>
    <message>
        <source>there are too many emphases</source>
        <translation>il y a trop d’accentuations</translation>
    </message>
    <message>
        <source>at most %1</source>
        <translation>au plus&#xa0;%1</translation>
    </message>
    <message>
        <source>vectorial waves, transients or curves of vibration</source>
        <translation>des ondes vectorielles, des transitoires ou des courbes de vibration</translation>
    </message>
    <message>
        <source>there are too many effects, or too many inside each other</source>
        <translation>il y a trop d’effets, ou trop d’effets imbriqués</translation>
    </message>
    <message>
        <source>there is no such effect in the library</source>
        <translation>il n’y a pas d’effet de ce nom dans la bibliothèque</translation>
    </message>
    <message>
        <source>the id of an effect in effect_library</source>
        <translation>l’id d’un effet présent dans effect_library</translation>
    </message>
    <message>
        <source>there are too many keyframes</source>
        <translation>il y a trop d’images clés</translation>
    </message>
    <message>
        <source>files tactor1%1 to tactor6%1, each once</source>
        <translation>des fichiers tactor1%1 à tactor6%1, chacun une seule fois</translation>
    </message>
    <message>
        <source>the paths are too long</source>
        <translation>les trajectoires sont trop longues</translation>
    </message>
    <message>
        <source>at most %1 points</source>
        <translation>au plus&#xa0;%1 points</translation>
    </message>
    <message>
        <source>this rate cannot hold a carrier of %1 Hz</source>
        <translation>cette fréquence d’échantillonnage ne permet pas une porteuse de&#xa0;%1 Hz</translation>
    </message>
    <message>
        <source>a carrier above 0 and below half of %1 samples per second</source>
        <translation>une porteuse au-dessus de 0 et au-dessous de la moitié de&#xa0;%1 échantillons par seconde</translation>
    </message>
</context>
<context>
    <name>PatternLaws</name>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>The bursts begin %1 apart; they are felt as one motion with %2.</source>
        <translation>Les salves débutent à %1 d’intervalle&#xa0;; elles sont senties comme un seul mouvement avec %2.</translation>
    </message>
    <message>
        <source>Object %1 plays on the same motor at the same time (tactors %2).</source>
        <translation>L’objet %1 joue sur le même moteur en même temps (tacteurs %2).</translation>
    </message>
    <message>
        <source>Tactors %1 are at most %2 Hz apart in speed: they beat.</source>
        <translation>Les tacteurs %1 diffèrent d’au plus %2 Hz en vitesse&#xa0;: ils battent.</translation>
    </message>
    <message>
        <source>It goes on until %1 s, but the pattern ends at %2 s.</source>
        <translation>Il continue jusqu’à %1 s, mais le motif se termine à %2 s.</translation>
    </message>
    <message>
        <source>Give the ring %1 turns.</source>
        <translation>Donner %1 tours à l’anneau.</translation>
    </message>
    <message>
        <source>Make it %1 long.</source>
        <translation>Lui donner une durée de %1.</translation>
    </message>
    <message>
        <source>Make the ring %1 long.</source>
        <translation>Donner à l’anneau une durée de %1.</translation>
    </message>
    <message>
        <source>Let the law of apparent motion set them %1 apart.</source>
        <translation>Laisser la loi du mouvement apparent les espacer de %1.</translation>
    </message>
    <message>
        <source>Give both the same intensity, or make them %1 Hz different.</source>
        <translation>Donner aux deux la même intensité, ou les écarter de %1 Hz.</translation>
    </message>
    <message>
        <source>Let the pattern last %1 s.</source>
        <translation>Faire durer le motif %1 s.</translation>
    </message>
    <message>
        <source>Make motor %1 weaker there, by %2 %, so that they are %3 Hz apart.</source>
        <translation>Affaiblir là le moteur&#xa0;%1 de&#xa0;%2&#xa0;% pour qu’ils soient éloignés de&#xa0;%3 Hz.</translation>
    </message>
    <message>
        <source>A burst of %1 is too short for the motor, which needs %2 to speed up.</source>
        <translation>Une salve de %1 est trop courte pour le moteur, qui met %2 à monter.</translation>
    </message>
    <message>
        <source>A turn of the ring takes %1; its direction is felt reliably only if a turn takes at least %2.</source>
        <translation>Un tour de l’anneau dure %1&#xa0;; son sens est senti de façon fiable à partir de %2.</translation>
    </message>
    <message>
        <source>Let it begin at %1 s, when the other one has ended.</source>
        <translation>Le faire débuter à %1 s, quand l’autre est fini.</translation>
    </message>
</context>
<context>
    <name>PatternLoss</name>
    <message>
        <source>Frequencies left out: %1. The frequency of the motors follows their intensity.</source>
        <translation>Fréquences laissées de côté&#xa0;:&#xa0;%1. La fréquence des moteurs suit leur intensité.</translation>
    </message>
    <message>
        <source>Short pulses that became bursts of %2 ms: %1.</source>
        <translation>Impulsions brèves devenues des salves de&#xa0;%2 ms&#xa0;:&#xa0;%1.</translation>
    </message>
    <message>
        <source>The pattern is longer than the file by %1 s, so that its last burst is whole.</source>
        <translation>Le motif dépasse le fichier de&#xa0;%1 s, pour que sa dernière salve soit entière.</translation>
    </message>
    <message>
        <source>The file holds one signal. It plays on tactor %1.</source>
        <comment>a list of numbers</comment>
        <translation>Le fichier contient un seul signal. Il est joué sur le tacteur&#xa0;%1.</translation>
    </message>
    <message>
        <source>Channels without a direction, put on the tactors in their order: %1.</source>
        <translation>Canaux sans direction, placés sur les tacteurs dans leur ordre&#xa0;:&#xa0;%1.</translation>
    </message>
    <message>
        <source>Channels left out, because no tactor is left for them: %1.</source>
        <translation>Canaux laissés de côté, faute de tacteur restant&#xa0;:&#xa0;%1.</translation>
    </message>
    <message>
        <source>Effects for the other arm left out: %1.</source>
        <translation>Effets pour l’autre bras laissés de côté&#xa0;:&#xa0;%1.</translation>
    </message>
    <message>
        <source>Effects for other devices left out: %1.</source>
        <translation>Effets pour d’autres appareils laissés de côté&#xa0;:&#xa0;%1.</translation>
    </message>
    <message>
        <source>Parts that are not vibration left out: %1.</source>
        <translation>Parties autres que des vibrations laissées de côté&#xa0;:&#xa0;%1.</translation>
    </message>
    <message>
        <source>Tracks left out that are switched off: %1.</source>
        <translation>Pistes désactivées laissées de côté&#xa0;:&#xa0;%1.</translation>
    </message>
    <message>
        <source>Pieces that overlap others: %1. The stronger one counts; they do not add up.</source>
        <translation>Segments qui en chevauchent d’autres&#xa0;:&#xa0;%1. Le plus fort compte&#xa0;; ils ne s’additionnent pas.</translation>
    </message>
    <message>
        <source>Paths shared among the motors nearest to them: %1.</source>
        <translation>Trajectoires réparties entre les moteurs les plus proches&#xa0;:&#xa0;%1.</translation>
    </message>
    <message>
        <source>Paths or envelopes of a single point left out: %1. They have no length.</source>
        <translation>Trajectoires ou enveloppes d’un seul point laissées de côté&#xa0;:&#xa0;%1. Elles n’ont pas de durée.</translation>
    </message>
    <message>
        <source>Sounds left out: %1.</source>
        <translation>Sons laissés de côté&#xa0;:&#xa0;%1.</translation>
    </message>
    <message>
        <source>Events whose attack, decay or release was left out: %1.</source>
        <translation>Événements dont l’attaque, la décroissance ou le relâchement a été laissé de côté&#xa0;:&#xa0;%1.</translation>
    </message>
    <message>
        <source>Settings that a pattern does not have: %1.</source>
        <translation>Réglages qu’un motif n’a pas&#xa0;:&#xa0;%1.</translation>
    </message>
    <message>
        <source>Coded wave forms left out: %1.</source>
        <translation>Formes d’onde codées laissées de côté&#xa0;:&#xa0;%1.</translation>
    </message>
    <message>
        <source>Curves of displacement, of which the size plays in straight lines: %1.</source>
        <translation>Courbes de déplacement, dont l’amplitude est jouée en segments de droite&#xa0;:&#xa0;%1.</translation>
    </message>
    <message>
        <source>Intensities beyond full drive, set to 1: %1.</source>
        <translation>Intensités au-delà de la pleine commande, ramenées à 1&#xa0;:&#xa0;%1.</translation>
    </message>
    <message>
        <source>Objects written as the intensities that they play: %1.</source>
        <translation>Objets écrits sous la forme des intensités qu’ils jouent&#xa0;:&#xa0;%1.</translation>
    </message>
    <message>
        <source>Slopes written as steps of %2 ms: %1. They differ from the pattern by up to %3.</source>
        <translation>Pentes écrites en paliers de&#xa0;%2 ms&#xa0;:&#xa0;%1. Elles s’écartent du motif d’au plus&#xa0;%3.</translation>
    </message>
    <message>
        <source>Times rounded to milliseconds: %1.</source>
        <translation>Temps arrondis à la milliseconde&#xa0;:&#xa0;%1.</translation>
    </message>
    <message>
        <source>The first one is at %1 s.</source>
        <translation>Première occurrence à&#xa0;%1 s.</translation>
    </message>
    <message>
        <source>First seen in %1.</source>
        <translation>Première occurrence dans&#xa0;%1.</translation>
    </message>
</context>
<context>
    <name>PatternNames</name>
    <message>
        <source>Circle, static</source>
        <translation>Cercle, statique</translation>
    </message>
    <message>
        <source>Rectangle, static</source>
        <translation>Rectangle, statique</translation>
    </message>
    <message>
        <source>Triangle, static</source>
        <translation>Triangle, statique</translation>
    </message>
    <message>
        <source>Arc, static</source>
        <translation>Arc, statique</translation>
    </message>
    <message>
        <source>Line, static</source>
        <translation>Ligne, statique</translation>
    </message>
    <message>
        <source>Point, static</source>
        <translation>Point, statique</translation>
    </message>
    <message>
        <source>Circle, dynamic</source>
        <translation>Cercle, dynamique</translation>
    </message>
    <message>
        <source>Rectangle, dynamic</source>
        <translation>Rectangle, dynamique</translation>
    </message>
    <message>
        <source>Triangle, dynamic</source>
        <translation>Triangle, dynamique</translation>
    </message>
    <message>
        <source>Arc, dynamic</source>
        <translation>Arc, dynamique</translation>
    </message>
    <message>
        <source>Line, dynamic</source>
        <translation>Ligne, dynamique</translation>
    </message>
    <message>
        <source>Point, dynamic</source>
        <translation>Point, dynamique</translation>
    </message>
    <message>
        <source>Sponge, static</source>
        <translation>Éponge, statique</translation>
    </message>
    <message>
        <source>Rubber sponge, static</source>
        <translation>Caoutchouc mousse, statique</translation>
    </message>
    <message>
        <source>Rubber, static</source>
        <translation>Caoutchouc, statique</translation>
    </message>
    <message>
        <source>Wood, static</source>
        <translation>Bois, statique</translation>
    </message>
    <message>
        <source>Metal, static</source>
        <translation>Métal, statique</translation>
    </message>
    <message>
        <source>Sponge, dynamic</source>
        <translation>Éponge, dynamique</translation>
    </message>
    <message>
        <source>Rubber sponge, dynamic</source>
        <translation>Caoutchouc mousse, dynamique</translation>
    </message>
    <message>
        <source>Rubber, dynamic</source>
        <translation>Caoutchouc, dynamique</translation>
    </message>
    <message>
        <source>Wood, dynamic</source>
        <translation>Bois, dynamique</translation>
    </message>
    <message>
        <source>Metal, dynamic</source>
        <translation>Métal, dynamique</translation>
    </message>
</context>
<context>
    <name>PatternPlay</name>
    <message>
        <source>the profile is of the bracelet &quot;%1&quot;</source>
        <translation>le profil est celui du bracelet «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>median %1, 99 % below %2, longest %3 us</source>
        <translation>médiane %1, 99&#xa0;% sous %2, maximum %3 us</translation>
    </message>
    <message>
        <source>The bracelet was lost.</source>
        <translation>Le bracelet a été perdu.</translation>
    </message>
    <message>
        <source>A frame was so late that the bracelet had stopped.</source>
        <translation>Une trame est venue si tard que le bracelet s’était arrêté.</translation>
    </message>
    <message>
        <source>Bracelet</source>
        <translation>Bracelet</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>Fréquence</translation>
    </message>
    <message>
        <source>%1 Hz, achieved %2 Hz</source>
        <translation>%1 Hz, %2 Hz obtenus</translation>
    </message>
    <message>
        <source>Playback thread</source>
        <translation>Fil de lecture</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>Trames</translation>
    </message>
    <message>
        <source>Deadlines missed</source>
        <translation>Échéances manquées</translation>
    </message>
    <message>
        <source>Frames lost</source>
        <translation>Trames perdues</translation>
    </message>
    <message>
        <source>Late by</source>
        <translation>Retard</translation>
    </message>
    <message>
        <source>Write</source>
        <translation>Écriture</translation>
    </message>
    <message>
        <source>Setpoints</source>
        <translation>Consignes</translation>
    </message>
    <message>
        <source>Misses meanwhile</source>
        <translation>Manquées entre-temps</translation>
    </message>
    <message>
        <source>Snapshot to frame</source>
        <translation>De la consigne à la trame</translation>
    </message>
    <message>
        <source>No bracelet answers.</source>
        <translation>Aucun bracelet ne répond.</translation>
    </message>
    <message>
        <source>The bracelet is too hot.</source>
        <translation>Le bracelet est trop chaud.</translation>
    </message>
    <message>
        <source>let it cool down first</source>
        <translation>laissez-le d’abord refroidir</translation>
    </message>
    <message>
        <source>Confirmed</source>
        <translation>Confirmé</translation>
    </message>
    <message>
        <source>played by the callback of the sound card</source>
        <translation>joué par la fonction de rappel de la carte son</translation>
    </message>
    <message>
        <source>Latency</source>
        <translation>Latence</translation>
    </message>
    <message>
        <source>at most %1 ms, as stated, not measured</source>
        <translation>au plus %1 ms, annoncée, non mesurée</translation>
    </message>
    <message>
        <source>Callback</source>
        <translation>Fonction de rappel</translation>
    </message>
    <message>
        <source>%1 % of a period, longest %2 %, %3 missed</source>
        <translation>%1&#xa0;% d’une période, au plus %2&#xa0;%, %3 manquées</translation>
    </message>
</context>
<context>
    <name>PlanContent</name>
    <message>
        <source>%1: %2</source>
        <comment>task, test</comment>
        <translation>%1&#xa0;: %2</translation>
    </message>
    <message>
        <source>conditions</source>
        <translation>conditions</translation>
    </message>
    <message>
        <source>patterns</source>
        <translation>motifs</translation>
    </message>
    <message>
        <source>conditions by patterns</source>
        <translation>conditions × motifs</translation>
    </message>
    <message>
        <source>Power: %1</source>
        <comment>test</comment>
        <translation>Puissance&#xa0;: %1</translation>
    </message>
    <message>
        <source>participants</source>
        <translation>participants</translation>
    </message>
    <message>
        <source>significant studies, %</source>
        <translation>études significatives,&#xa0;%</translation>
    </message>
    <message>
        <source>target</source>
        <translation>cible</translation>
    </message>
    <message>
        <source>Cancelled. The curve has the studies drawn so far.</source>
        <translation>Annulé. La courbe contient les études tirées jusqu’ici.</translation>
    </message>
    <message>
        <source>No number up to %1 reaches %2 %.</source>
        <translation>Aucun nombre jusqu’à %1 n’atteint %2&#xa0;%.</translation>
    </message>
    <message>
        <source>%1 or %2 participants reach %3 %; chance cannot tell which.</source>
        <translation>%1 ou %2 participants atteignent %3&#xa0;%&#xa0;; le hasard ne permet pas de dire lequel.</translation>
    </message>
    <message>
        <source>%1 participants reach %2 %.</source>
        <translation>%1 participants atteignent %2&#xa0;%.</translation>
    </message>
    <message>
        <source>threshold</source>
        <translation>seuil</translation>
    </message>
    <message>
        <source>studies with an interval narrow enough, %</source>
        <translation>études à l’intervalle assez étroit,&#xa0;%</translation>
    </message>
    <message>
        <source>Precision: %1</source>
        <comment>test</comment>
        <translation>Précision&#xa0;:&#xa0;%1</translation>
    </message>
</context>
<context>
    <name>ProcessText</name>
    <message>
        <source>the program cannot be started: %1</source>
        <translation>le programme ne peut pas être lancé&#xa0;:&#xa0;%1</translation>
    </message>
</context>
<context>
    <name>ProgramText</name>
    <message>
        <source>Usage</source>
        <translation>Utilisation</translation>
    </message>
    <message>
        <source>OPTIONS</source>
        <translation>OPTIONS</translation>
    </message>
    <message>
        <source>Options</source>
        <translation>Options</translation>
    </message>
    <message>
        <source>Arguments</source>
        <translation>Arguments</translation>
    </message>
    <message>
        <source>COMMAND</source>
        <translation>COMMANDE</translation>
    </message>
    <message>
        <source>Commands</source>
        <translation>Commandes</translation>
    </message>
    <message>
        <source>(required)</source>
        <translation>(obligatoire)</translation>
    </message>
    <message>
        <source>Print this help</source>
        <translation>Afficher cette aide</translation>
    </message>
    <message>
        <source>Computes contacts, stiffness and shape from what a tactile robot arm has felt.</source>
        <translation>Calcule contacts, raideur et forme d’après ce qu’a senti un bras robotisé tactile.</translation>
    </message>
    <message>
        <source>Print the version</source>
        <translation>Afficher la version</translation>
    </message>
    <message>
        <source>Example:</source>
        <translation>Exemple&#xa0;:</translation>
    </message>
    <message>
        <source>there is no command &apos;%1&apos;; expected one of %2</source>
        <translation>il n’y a pas de commande «&#xa0;%1&#xa0;»&#xa0;; attendu&#xa0;: %2</translation>
    </message>
    <message>
        <source>teleta: %1
Run %2 --help for more.
</source>
        <translation>teleta&#xa0;: %1
%2 --help en dit plus.
</translation>
    </message>
    <message>
        <source>With --version: print version and commit as JSON</source>
        <translation>Avec --version&#xa0;: afficher la version et le commit en JSON</translation>
    </message>
    <message>
        <source>Print how to cite the program, as BibTeX</source>
        <translation>Afficher comment citer le programme, en BibTeX</translation>
    </message>
    <message>
        <source>there is not enough memory</source>
        <translation>la mémoire ne suffit pas</translation>
    </message>
</context>
<context>
    <name>Provenance</name>
    <message>
        <source>SIMULATED</source>
        <translation>SIMULÉ</translation>
    </message>
    <message>
        <source>RECORDED</source>
        <translation>ENREGISTRÉ</translation>
    </message>
    <message>
        <source>RECORDED SIMULATION</source>
        <translation>SIMULATION ENREGISTRÉE</translation>
    </message>
    <message>
        <source>UNGUARDED</source>
        <translation>SANS GARDE</translation>
    </message>
</context>
<context>
    <name>PseudonymKey</name>
    <message>
        <source>another program changes the file</source>
        <translation>un autre programme modifie le fichier</translation>
    </message>
    <message>
        <source>to try again in a moment</source>
        <translation>réessayer dans un instant</translation>
    </message>
    <message>
        <source>the key of the pseudonyms lies in the study&apos;s folder</source>
        <translation>la clé des pseudonymes se trouve dans le dossier de l’étude</translation>
    </message>
    <message>
        <source>a file apart from the data, which are copied and published</source>
        <translation>un fichier à part des données, qui sont copiées et publiées</translation>
    </message>
    <message>
        <source>a row has no participant</source>
        <translation>une ligne n’a pas de participant</translation>
    </message>
    <message>
        <source>a participant of the study</source>
        <translation>un participant de l’étude</translation>
    </message>
    <message>
        <source>the key has a person for &quot;%1&quot; already</source>
        <translation>la clé a déjà une personne pour «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>another name</source>
        <translation>un autre nom</translation>
    </message>
</context>
<context>
    <name>QosText</name>
    <message>
        <source>the publisher is best effort, the subscriber asks for reliable</source>
        <translation>l’émetteur est en «&#xa0;best effort&#xa0;», le récepteur demande «&#xa0;reliable&#xa0;»</translation>
    </message>
    <message>
        <source>the publisher is volatile, the subscriber asks for transient local</source>
        <translation>l’émetteur est «&#xa0;volatile&#xa0;», le récepteur demande «&#xa0;transient local&#xa0;»</translation>
    </message>
    <message>
        <source>publisher and subscriber have incompatible qualities of service (QoS)</source>
        <translation>l’émetteur et le récepteur ont des qualités de service (QoS) incompatibles</translation>
    </message>
</context>
<context>
    <name>RecordedSignalsText</name>
    <message>
        <source>The recording has no &quot;%1&quot;.</source>
        <translation>L’enregistrement n’a pas de «&#xa0;%1&#xa0;».</translation>
    </message>
    <message>
        <source>The reading was stopped.</source>
        <translation>La lecture a été arrêtée.</translation>
    </message>
</context>
<context>
    <name>RecordedStreamText</name>
    <message>
        <source>the stream &quot;%1&quot; is not described: %2</source>
        <translation>le flux «&#xa0;%1&#xa0;» n’est pas décrit&#xa0;: %2</translation>
    </message>
    <message>
        <source>it is not an array</source>
        <translation>ce n’est pas une matrice</translation>
    </message>
    <message>
        <source>it is not an arm</source>
        <translation>ce n’est pas un bras</translation>
    </message>
    <message>
        <source>its links have another number of joints</source>
        <translation>ses segments ont un autre nombre d’articulations</translation>
    </message>
</context>
<context>
    <name>RecordedStreams</name>
    <message>
        <source>a recording of an array, an arm or a camera</source>
        <translation>un enregistrement d’une matrice, d’un bras ou d’une caméra</translation>
    </message>
    <message>
        <source>the recording has no frames of an array, an arm or a camera</source>
        <translation>l’enregistrement n’a ni trames de matrice, ni articulations de bras, ni images de caméra</translation>
    </message>
    <message>
        <source>it is not a picture in colour</source>
        <translation>ce n’est pas une image en couleur</translation>
    </message>
</context>
<context>
    <name>Recording</name>
    <message>
        <source>the stream &quot;%1&quot; is described by &quot;%2&quot;</source>
        <translation>le flux «&#xa0;%1&#xa0;» est décrit par «&#xa0;%2&#xa0;»</translation>
    </message>
    <message>
        <source>the stream &quot;%1&quot; has %2 columns instead of %3</source>
        <translation>le flux «&#xa0;%1&#xa0;» a %2 colonnes au lieu de %3</translation>
    </message>
    <message>
        <source>a new name</source>
        <translation>un nouveau nom</translation>
    </message>
    <message>
        <source>the recording cannot be written: %1</source>
        <translation>l’enregistrement ne peut pas être écrit&#xa0;: %1</translation>
    </message>
    <message>
        <source>a recording of this program</source>
        <translation>un enregistrement de ce programme</translation>
    </message>
    <message>
        <source>the recording was made by a newer version of the program (format %1)</source>
        <translation>l’enregistrement provient d’une version plus récente du programme (format %1)</translation>
    </message>
    <message>
        <source>format %1 or older</source>
        <translation>le format %1 ou antérieur</translation>
    </message>
    <message>
        <source>a folder that can be written to: the recording was cut off and has to be completed</source>
        <translation>un dossier où l’on peut écrire&#xa0;: l’enregistrement a été coupé et doit être complété</translation>
    </message>
    <message>
        <source>the disk is full</source>
        <translation>le disque est plein</translation>
    </message>
    <message>
        <source>the recording is damaged: %1</source>
        <translation>l’enregistrement est endommagé&#xa0;: %1</translation>
    </message>
    <message>
        <source>block %1 of the stream &quot;%2&quot; is incomplete</source>
        <translation>le bloc %1 du flux «&#xa0;%2&#xa0;» n’est pas entier</translation>
    </message>
    <message>
        <source>the recording was never started</source>
        <translation>l’enregistrement n’a jamais été commencé</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a time</source>
        <translation>«&#xa0;%1&#xa0;» n’est pas un temps</translation>
    </message>
    <message>
        <source>a file of this name already exists</source>
        <translation>il y a déjà un fichier de ce nom</translation>
    </message>
    <message>
        <source>a writable folder</source>
        <translation>un dossier où l’on peut écrire</translation>
    </message>
    <message>
        <source>this is not a recording</source>
        <translation>ce n’est pas un enregistrement</translation>
    </message>
    <message>
        <source>this is an SQLite database, but not a recording</source>
        <translation>c’est une base SQLite, mais pas un enregistrement</translation>
    </message>
    <message>
        <source>its format version is missing</source>
        <translation>il n’a pas de format</translation>
    </message>
</context>
<context>
    <name>RecordingExport</name>
    <message>
        <source>another folder</source>
        <translation>un autre dossier</translation>
    </message>
    <message>
        <source>interrupted; nothing was written</source>
        <translation>interrompu&#xa0;; rien n’a été écrit</translation>
    </message>
    <message>
        <source>the folder cannot be created or written to</source>
        <translation>le dossier ne peut pas être créé, ou on ne peut pas y écrire</translation>
    </message>
    <message>
        <source>a file of this name already exists</source>
        <translation>il y a déjà un fichier de ce nom</translation>
    </message>
    <message>
        <source>the recording cannot be read</source>
        <translation>l’enregistrement ne peut pas être lu</translation>
    </message>
</context>
<context>
    <name>RecordingRequest</name>
    <message>
        <source>the recording has no stream &quot;%1&quot; to play</source>
        <translation>l’enregistrement n’a pas de flux «&#xa0;%1&#xa0;» à lire</translation>
    </message>
</context>
<context>
    <name>RegisterMapReader</name>
    <message>
        <source>&quot;scale&quot; is 0</source>
        <translation>«&#xa0;scale&#xa0;» vaut 0</translation>
    </message>
    <message>
        <source>the value of one count</source>
        <translation>la valeur d’un pas de comptage</translation>
    </message>
    <message>
        <source>the last register would be beyond 65535</source>
        <translation>le dernier registre dépasserait 65535</translation>
    </message>
    <message>
        <source>an address of at most %1</source>
        <translation>une adresse d’au plus %1</translation>
    </message>
    <message>
        <source>&quot;%1&quot; does not fit into the register</source>
        <translation>«&#xa0;%1&#xa0;» ne tient pas dans le registre</translation>
    </message>
    <message>
        <source>a value that type, scale and offset can express</source>
        <translation>une valeur que type, scale et offset peuvent exprimer</translation>
    </message>
    <message>
        <source>&quot;full&quot; and &quot;off&quot; are the same</source>
        <translation>«&#xa0;full&#xa0;» et «&#xa0;off&#xa0;» sont identiques</translation>
    </message>
    <message>
        <source>a value at which the motor runs as fast as it can</source>
        <translation>une valeur à laquelle le moteur tourne aussi vite que possible</translation>
    </message>
    <message>
        <source>a float has no bits to look at</source>
        <translation>un flottant n’a pas de bits à examiner</translation>
    </message>
    <message>
        <source>one of: %1</source>
        <translation>l’un de&#xa0;: %1</translation>
    </message>
    <message>
        <source>there is no input &quot;%1&quot;</source>
        <translation>il n’y a pas d’entrée «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>the name of an [[input]]</source>
        <translation>le nom d’une [[input]]</translation>
    </message>
    <message>
        <source>the unit of &quot;%1&quot; is &quot;%2&quot;</source>
        <translation>l’unité de «&#xa0;%1&#xa0;» est «&#xa0;%2&#xa0;»</translation>
    </message>
    <message>
        <source>an input in %1</source>
        <translation>une entrée en %1</translation>
    </message>
    <message>
        <source>the name &quot;%1&quot; is used twice</source>
        <translation>le nom «&#xa0;%1&#xa0;» est utilisé deux fois</translation>
    </message>
    <message>
        <source>a name of its own for each input</source>
        <translation>un nom propre à chaque entrée</translation>
    </message>
    <message>
        <source>the watchdog is a register of a motor</source>
        <translation>le chien de garde est un registre d’un moteur</translation>
    </message>
    <message>
        <source>a register of its own</source>
        <translation>un registre à lui</translation>
    </message>
    <message>
        <source>there is no motor to watch</source>
        <translation>il n’y a pas de moteur à surveiller</translation>
    </message>
    <message>
        <source>a table [tactors]</source>
        <translation>une table [tactors]</translation>
    </message>
    <message>
        <source>the file names no register</source>
        <translation>le fichier ne nomme aucun registre</translation>
    </message>
    <message>
        <source>[tactors] or [[input]]</source>
        <translation>[tactors] ou [[input]]</translation>
    </message>
    <message>
        <source>no such device comes with the program</source>
        <translation>aucun appareil de ce nom n’est fourni avec le programme</translation>
    </message>
    <message>
        <source>&quot;start&quot; is not between &quot;off&quot; and &quot;full&quot;</source>
        <translation>«&#xa0;start&#xa0;» n’est pas entre «&#xa0;off&#xa0;» et «&#xa0;full&#xa0;»</translation>
    </message>
    <message>
        <source>the value of the weakest intensity</source>
        <translation>la valeur de la plus faible intensité</translation>
    </message>
    <message>
        <source>nothing turns the motors off when the program is killed or the line is cut</source>
        <translation>rien n’arrête les moteurs quand le programme est tué ou la ligne coupée</translation>
    </message>
    <message>
        <source>[watchdog] with the address of the driver&apos;s watchdog register, or with by_traffic = true where it turns them off when nothing is written</source>
        <translation>[watchdog] avec l’adresse du registre de chien de garde du pilote, ou avec by_traffic = true s’il les arrête quand rien n’est écrit</translation>
    </message>
    <message>
        <source>&quot;answer_timeout_s&quot; is too long for motors: STOP may have to wait for it</source>
        <translation>«&#xa0;answer_timeout_s&#xa0;» est trop long pour des moteurs&#xa0;: STOP pourrait avoir à l’attendre</translation>
    </message>
    <message>
        <source>at most %1 s</source>
        <translation>au plus %1 s</translation>
    </message>
    <message>
        <source>too many joints: %1</source>
        <translation>trop d’articulations : %1</translation>
    </message>
    <message>
        <source>at most %1, from the base to the tip</source>
        <translation>au plus %1, de la base à la pointe</translation>
    </message>
</context>
<context>
    <name>RelayText</name>
    <message>
        <source>no line to the driver can be opened: %1</source>
        <translation>aucune ligne vers le pilote ne peut être ouverte&#xa0;:&#xa0;%1</translation>
    </message>
</context>
<context>
    <name>RemoteCameraText</name>
    <message>
        <source>the received data are not a complete JPEG picture (%1 bytes)</source>
        <translation>les données reçues ne sont pas une image JPEG complète (%1 octets)</translation>
    </message>
</context>
<context>
    <name>RemoteDeviceText</name>
    <message>
        <source>%1 sends nothing of this device</source>
        <translation>%1 n’envoie rien de cet appareil</translation>
    </message>
    <message>
        <source>%1 does not answer</source>
        <translation>%1 ne répond pas</translation>
    </message>
</context>
<context>
    <name>RemoteSiteFileText</name>
    <message>
        <source>&quot;%1&quot; cannot be a name</source>
        <translation>« %1 » ne peut pas être un nom</translation>
    </message>
    <message>
        <source>a small letter, then at most 30 small letters, digits and _</source>
        <translation>une minuscule, puis au plus 30 minuscules, chiffres et _</translation>
    </message>
</context>
<context>
    <name>ReplayCommand</name>
    <message numerus="yes">
        <source>%n damaged block(s) left out</source>
        <translation>
            <numerusform>%n bloc endommagé ignoré</numerusform>
            <numerusform>%n blocs endommagés ignorés</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n frame(s) lost at this speed</source>
        <translation>
            <numerusform>%n trame perdue à cette vitesse</numerusform>
            <numerusform>%n trames perdues à cette vitesse</numerusform>
        </translation>
    </message>
    <message>
        <source>Recording of the console or of teleta simulate</source>
        <translation>Enregistrement de la console ou de teleta simulate</translation>
    </message>
    <message>
        <source>Times the recorded speed; otherwise as fast as possible</source>
        <translation>Multiple de la vitesse enregistrée&#xa0;; sinon aussi vite que possible</translation>
    </message>
    <message>
        <source>Load from which a taxel is in contact; otherwise as it was recorded</source>
        <translation>Charge à partir de laquelle un taxel est en contact&#xa0;; sinon comme enregistré</translation>
    </message>
    <message numerus="yes">
        <source>%n frame(s) were not printed</source>
        <translation>
            <numerusform>%n trame n’a pas été affichée</numerusform>
            <numerusform>%n trames n’ont pas été affichées</numerusform>
        </translation>
    </message>
    <message>
        <source>Play a recording through the processing of a device and print its features, or a camera&apos;s contacts</source>
        <translation>Rejouer un enregistrement à travers le traitement d’un appareil et afficher ses caractéristiques, ou les contacts d’une caméra</translation>
    </message>
    <message>
        <source>Name of the stream of an array or a camera; otherwise the first one</source>
        <translation>Nom du flux d’une matrice ou d’une caméra&#xa0;; sinon le premier</translation>
    </message>
    <message>
        <source>the recording has the arrays and cameras %1</source>
        <translation>l’enregistrement contient les matrices et caméras %1</translation>
    </message>
    <message>
        <source>the settings changed during the recording; those of its beginning are used</source>
        <translation>les réglages ont changé pendant l’enregistrement&#xa0;; ceux du début sont utilisés</translation>
    </message>
    <message>
        <source>this is for arrays, but the stream &quot;%1&quot; is a camera&apos;s</source>
        <translation>cela concerne une matrice, mais le flux «&#xa0;%1&#xa0;» est celui d’une caméra</translation>
    </message>
    <message>
        <source>frames of an array or a camera</source>
        <translation>des trames de matrice ou des images de caméra</translation>
    </message>
    <message>
        <source>The gel at rest could not be found, so there are no contacts. %1</source>
        <translation>Le gel au repos n’a pas pu être trouvé, il n’y a donc pas de contacts. %1</translation>
    </message>
    <message>
        <source>%1 of %2 frames could not be used. The last reason: %3</source>
        <translation>%1 trames sur %2 n’ont pas pu servir. La dernière raison&#xa0;: %3</translation>
    </message>
    <message>
        <source>the recording has joints of an arm or pictures to look at, and nothing that is computed from them</source>
        <translation>l’enregistrement a des articulations d’un bras ou des images à regarder, et rien n’en est calculé</translation>
    </message>
</context>
<context>
    <name>ReplayDevice</name>
    <message>
        <source>only a file can be played, not a pipe</source>
        <translation>seul un fichier peut être lu, pas un tube (pipe)</translation>
    </message>
    <message>
        <source>the recording has no frames</source>
        <translation>l’enregistrement n’a pas de trames</translation>
    </message>
</context>
<context>
    <name>ReportText</name>
    <message>
        <source>en</source>
        <comment>language of the report, as BCP 47 has it</comment>
        <translation>fr</translation>
    </message>
    <message>
        <source>Data: %1. TeleTA Console %2.</source>
        <translation>Données&#xa0;: %1. TeleTA Console %2.</translation>
    </message>
    <message>
        <source>Compute it again</source>
        <translation>Refaire le calcul</translation>
    </message>
    <message>
        <source>There are no test trials.</source>
        <translation>Il n’y a pas d’essais de test.</translation>
    </message>
    <message>
        <source>Correct answers of the group; the interval is that of Student&apos;s t over participants (95 %)</source>
        <translation>Réponses correctes du groupe&#xa0;; l’intervalle est celui du t de Student sur les participants (95&#xa0;%)</translation>
    </message>
    <message>
        <source>Condition</source>
        <translation>Condition</translation>
    </message>
    <message>
        <source>Participants</source>
        <translation>Participants</translation>
    </message>
    <message>
        <source>Mean, %</source>
        <translation>Moyenne,&#xa0;%</translation>
    </message>
    <message>
        <source>SD, %</source>
        <translation>Écart-type,&#xa0;%</translation>
    </message>
    <message>
        <source>Interval, %</source>
        <translation>Intervalle,&#xa0;%</translation>
    </message>
    <message>
        <source>Correct answers</source>
        <translation>Réponses correctes</translation>
    </message>
    <message>
        <source>Dots: participants. Marks: mean with the t interval over participants.</source>
        <translation>Points&#xa0;: participants. Marques&#xa0;: moyenne avec l’intervalle t sur les participants.</translation>
    </message>
    <message>
        <source>Rows: presented; columns: answered. Percent of the row, all participants.</source>
        <translation>Lignes&#xa0;: présenté&#xa0;; colonnes&#xa0;: répondu. Pourcentage de la ligne, tous les participants.</translation>
    </message>
    <message>
        <source>Presented</source>
        <translation>Présenté</translation>
    </message>
    <message>
        <source>Trials</source>
        <translation>Essais</translation>
    </message>
    <message>
        <source>%1: trials and share of the row in percent</source>
        <translation>%1&#xa0;: essais et part de la ligne en pour cent</translation>
    </message>
    <message>
        <source>Confusion matrices</source>
        <translation>Matrices de confusion</translation>
    </message>
    <message>
        <source>Pattern</source>
        <translation>Motif</translation>
    </message>
    <message>
        <source>%1, %</source>
        <translation>%1,&#xa0;%</translation>
    </message>
    <message>
        <source>df</source>
        <translation>ddl</translation>
    </message>
    <message>
        <source>Patterns and conditions</source>
        <translation>Motifs et conditions</translation>
    </message>
    <message>
        <source>Mean of the participants with the t interval (95 %).</source>
        <translation>Moyenne des participants avec l’intervalle t (95&#xa0;%).</translation>
    </message>
    <message>
        <source>Participants&apos; median response times of correct, answered test trials, from the onset of the stimulus</source>
        <translation>Temps de réponse médians des participants pour les essais de test répondus correctement, depuis le début du stimulus</translation>
    </message>
    <message>
        <source>Median of the medians, s</source>
        <translation>Médiane des médianes, s</translation>
    </message>
    <message>
        <source>Shortest, s</source>
        <translation>Le plus court, s</translation>
    </message>
    <message>
        <source>Longest, s</source>
        <translation>Le plus long, s</translation>
    </message>
    <message>
        <source>Response times</source>
        <translation>Temps de réponse</translation>
    </message>
    <message>
        <source>Dots: medians of participants. Marks: the median of these.</source>
        <translation>Points&#xa0;: médianes des participants. Marques&#xa0;: médiane de celles-ci.</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>Mesuré</translation>
    </message>
    <message>
        <source>Bias</source>
        <translation>Biais</translation>
    </message>
    <message>
        <source>Corrected</source>
        <translation>Corrigé</translation>
    </message>
    <message>
        <source>Interval</source>
        <translation>Intervalle</translation>
    </message>
    <message>
        <source>A guesser would show</source>
        <translation>Valeur en devinant</translation>
    </message>
    <message>
        <source>Remark</source>
        <translation>Remarque</translation>
    </message>
    <message>
        <source>few trials: fewer than 5 k²</source>
        <translation>peu d’essais&#xa0;: moins de 5 k²</translation>
    </message>
    <message>
        <source>Information transfer</source>
        <translation>Transfert d’information</translation>
    </message>
    <message>
        <source>The measured value is too high with few trials: even a participant who only guesses shows more than 0 bit. Compare it with the column of the guesser, and use the corrected value with care.</source>
        <translation>La valeur mesurée est trop élevée avec peu d’essais&#xa0;: même un participant qui ne fait que deviner montre plus de 0 bit. Comparez-la à la colonne de la valeur en devinant, et utilisez la valeur corrigée avec prudence.</translation>
    </message>
    <message>
        <source>Each participant, test trials; intervals of 95 %, p of so many correct answers by chance</source>
        <translation>Chaque participant, essais de test&#xa0;; intervalles à 95&#xa0;%, p d’autant de réponses correctes au hasard</translation>
    </message>
    <message>
        <source>Participant</source>
        <translation>Participant</translation>
    </message>
    <message>
        <source>Correct</source>
        <translation>Correctes</translation>
    </message>
    <message>
        <source>No answer</source>
        <translation>Sans réponse</translation>
    </message>
    <message>
        <source>Accuracy, %</source>
        <translation>Exactitude,&#xa0;%</translation>
    </message>
    <message>
        <source>Wilson, %</source>
        <translation>Wilson,&#xa0;%</translation>
    </message>
    <message>
        <source>Clopper-Pearson, %</source>
        <translation>Clopper-Pearson,&#xa0;%</translation>
    </message>
    <message>
        <source>p of chance</source>
        <translation>p au hasard</translation>
    </message>
    <message>
        <source>Transfer, bit</source>
        <translation>Transfert, bit</translation>
    </message>
    <message>
        <source>Guesser, bit</source>
        <translation>En devinant, bit</translation>
    </message>
    <message>
        <source>Corrected, bit</source>
        <translation>Corrigé, bit</translation>
    </message>
    <message>
        <source>Median time, s</source>
        <translation>Temps médian, s</translation>
    </message>
    <message>
        <source>Times</source>
        <translation>Temps</translation>
    </message>
    <message>
        <source>Analysis of variance within participants of the shares of correct answers; p with the corrections of Greenhouse and Geisser and of Huynh and Feldt</source>
        <translation>Analyse de variance intra-participants des parts de réponses correctes&#xa0;; p avec les corrections de Greenhouse et Geisser et de Huynh et Feldt</translation>
    </message>
    <message>
        <source>Effect</source>
        <translation>Effet</translation>
    </message>
    <message>
        <source>partial η²</source>
        <translation>η² partiel</translation>
    </message>
    <message>
        <source>generalised η²</source>
        <translation>η² généralisé</translation>
    </message>
    <message>
        <source>%1 is left out: a cell is missing</source>
        <translation>%1 est écarté&#xa0;: une cellule manque</translation>
    </message>
    <message>
        <source>Analysis of variance</source>
        <translation>Analyse de variance</translation>
    </message>
    <message numerus="yes">
        <source>Stimuli: %n trial(s) were played on a bracelet; the longest write of a frame took %1 ms.</source>
        <translation>
            <numerusform>Stimuli&#xa0;: %n essai a été joué sur un bracelet&#xa0;; l’écriture la plus longue d’une trame a pris %1 ms.</numerusform>
            <numerusform>Stimuli&#xa0;: %n essais ont été joués sur un bracelet&#xa0;; l’écriture la plus longue d’une trame a pris %1 ms.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Stimuli: the frames of %n trial(s) were counted.</source>
        <translation>
            <numerusform>Stimuli&#xa0;: les trames de %n essai ont été comptées.</numerusform>
            <numerusform>Stimuli&#xa0;: les trames de %n essais ont été comptées.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 Frames were missed in %2 of them, %3 in all.</source>
        <comment>the sentence before, numbers</comment>
        <translation>%1 Des trames ont manqué dans %2 d’entre eux, %3 au total.</translation>
    </message>
    <message>
        <source>PILOT: these data were taken to try the study out.</source>
        <translation>PILOTE&#xa0;: ces données ont été recueillies pour mettre l’étude à l’épreuve.</translation>
    </message>
    <message>
        <source>SIMULATED: these answers were made by a program, not by people.</source>
        <translation>SIMULÉ&#xa0;: ces réponses ont été données par un programme, non par des personnes.</translation>
    </message>
    <message>
        <source>at least %1</source>
        <translation>au moins %1</translation>
    </message>
    <message>
        <source>at most %1</source>
        <translation>au plus %1</translation>
    </message>
    <message>
        <source>Information transfer of the pooled answers in bit. Corrected: without bias, by the jackknife over participants. Interval: of the true transfer (95 %)</source>
        <translation>Transfert d’information des réponses cumulées en bit. Corrigé&#xa0;: sans biais, par le jackknife sur les participants. Intervalle&#xa0;: du vrai transfert (95&#xa0;%)</translation>
    </message>
    <message>
        <source>Filled: measured. Hollow: less the bias, with the interval of the true transfer.</source>
        <translation>Pleins&#xa0;: mesuré. Creux&#xa0;: moins le biais, avec l’intervalle du vrai transfert.</translation>
    </message>
    <message>
        <source>analysis.R beside this page computes its numbers again from confusion_long.csv, except the response times, which that file does not have: Rscript analysis.R. In the folder of the study it computes the response times too, from the exported trials.</source>
        <translation>analysis.R, à côté de cette page, recalcule ses nombres à partir de confusion_long.csv, sauf les temps de réponse, que ce fichier n’a pas&#xa0;: Rscript analysis.R. Dans le dossier de l’étude, il calcule aussi les temps de réponse, à partir des essais exportés.</translation>
    </message>
    <message>
        <source>all participants have the same share</source>
        <translation>tous les participants ont la même part</translation>
    </message>
    <message>
        <source>the interval is cut off at 0 or 100 %</source>
        <translation>l’intervalle est coupé à 0 ou à 100&#xa0;%</translation>
    </message>
    <message>
        <source>p, Holm</source>
        <translation>p, Holm</translation>
    </message>
    <message>
        <source>Mean of the participants&apos; correct answers for each pattern; two conditions are compared within participants; Holm: corrected over the patterns</source>
        <translation>Moyenne des réponses correctes des participants pour chaque motif&#xa0;; deux conditions sont comparées au sein des participants&#xa0;; Holm&#xa0;: corrigé sur les motifs</translation>
    </message>
</context>
<context>
    <name>ResidualPicture</name>
    <message>
        <source>Image: no pairs yet</source>
        <translation>Image&#xa0;: pas encore de paires</translation>
    </message>
    <message>
        <source>Unrolled cylinder: no pairs yet</source>
        <translation>Cylindre déroulé&#xa0;: pas encore de paires</translation>
    </message>
    <message>
        <source>Image: from the pixel to where the camera projects its point</source>
        <translation>Image&#xa0;: du pixel à l’endroit où la caméra projette son point</translation>
    </message>
    <message>
        <source>Unrolled cylinder: from the point to where its pixel is located</source>
        <translation>Cylindre déroulé&#xa0;: du point à l’endroit où son pixel est localisé</translation>
    </message>
    <message>
        <source>u to the right, v down, px</source>
        <translation>u vers la droite, v vers le bas, px</translation>
    </message>
    <message>
        <source>angle, degrees; z upwards, mm</source>
        <translation>angle, degrés&#xa0;; z vers le haut, mm</translation>
    </message>
    <message>
        <source>x: wrong pair   o: excluded   dashed: valid radius</source>
        <translation>x&#xa0;: paire fausse   o&#xa0;: exclue   tirets&#xa0;: rayon valide</translation>
    </message>
    <message>
        <source>along z −%1</source>
        <translation>selon z −%1</translation>
    </message>
    <message>
        <source>+%1 mm</source>
        <translation>+%1 mm</translation>
    </message>
    <message>
        <source>arrows enlarged %1 times</source>
        <translation>flèches %1 fois</translation>
    </message>
</context>
<context>
    <name>RestText</name>
    <message>
        <source>The frames do not show the value of taxel %1 without load: it is touched in nearly all of them, or nothing touches the array</source>
        <translation>Les trames ne montrent pas la valeur du taxel %1 sans charge : il est touché dans presque toutes, ou rien ne touche le réseau</translation>
    </message>
    <message>
        <source>frames of the unloaded array, their median, or a dead taxel</source>
        <translation>des trames du réseau sans charge, leur médiane, ou un taxel mort</translation>
    </message>
</context>
<context>
    <name>ResultsContent</name>
    <message>
        <source>all participants</source>
        <translation>tous les participants</translation>
    </message>
    <message>
        <source>Right answers, 95 % Wilson interval</source>
        <translation>Réponses correctes, intervalle de Wilson à 95&#xa0;%</translation>
    </message>
    <message>
        <source>Right answers, mean of participants, 95 % t interval</source>
        <translation>Réponses correctes, moyenne des participants, intervalle t à 95&#xa0;%</translation>
    </message>
    <message>
        <source>right, %</source>
        <translation>correctes,&#xa0;%</translation>
    </message>
    <message>
        <source>chance</source>
        <translation>hasard</translation>
    </message>
    <message>
        <source>test</source>
        <translation>test</translation>
    </message>
    <message>
        <source>Each pattern: %1</source>
        <comment>conditions</comment>
        <translation>Chaque motif&#xa0;: %1</translation>
    </message>
    <message>
        <source> against </source>
        <translation> contre </translation>
    </message>
    <message>
        <source>Each pattern</source>
        <translation>Chaque motif</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <comment>condition, participant</comment>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>Median response time</source>
        <translation>Temps de réponse médian</translation>
    </message>
    <message>
        <source>Median response times, 95 % t interval</source>
        <translation>Temps de réponse médians, intervalle t à 95&#xa0;%</translation>
    </message>
    <message>
        <source>s from the onset</source>
        <translation>s depuis le début</translation>
    </message>
    <message>
        <source>right answers of the test</source>
        <translation>réponses correctes du test</translation>
    </message>
    <message>
        <source>Condition</source>
        <translation>Condition</translation>
    </message>
    <message>
        <source>Participants</source>
        <translation>Participants</translation>
    </message>
    <message>
        <source>Right %</source>
        <translation>Correctes&#xa0;%</translation>
    </message>
    <message>
        <source>SD</source>
        <translation>É.-T.</translation>
    </message>
    <message>
        <source>95 % t interval</source>
        <translation>Intervalle t 95&#xa0;%</translation>
    </message>
    <message>
        <source>Trials</source>
        <translation>Essais</translation>
    </message>
    <message>
        <source>IT bit</source>
        <translation>TI bit</translation>
    </message>
    <message>
        <source>Bias bit</source>
        <translation>Biais bit</translation>
    </message>
    <message>
        <source>IT corrected</source>
        <translation>TI corrigé</translation>
    </message>
    <message>
        <source>Mean of the participants&apos; shares of right answers</source>
        <translation>Moyenne des parts de réponses correctes des participants</translation>
    </message>
    <message>
        <source>Standard deviation between participants</source>
        <translation>Écart-type entre participants</translation>
    </message>
    <message>
        <source>Of the mean, from Student&apos;s t over participants</source>
        <translation>De la moyenne, d’après le t de Student sur les participants</translation>
    </message>
    <message>
        <source>Of all participants together</source>
        <translation>De tous les participants réunis</translation>
    </message>
    <message>
        <source>Information transfer of the pooled matrix, as counted</source>
        <translation>Transfert d’information de la matrice cumulée, tel que compté</translation>
    </message>
    <message>
        <source>Measured less bias</source>
        <translation>Mesuré moins le biais</translation>
    </message>
    <message>
        <source>Participant</source>
        <translation>Participant</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Correctes</translation>
    </message>
    <message>
        <source>No answer</source>
        <translation>Sans réponse</translation>
    </message>
    <message>
        <source>Wilson 95 %</source>
        <translation>Wilson 95&#xa0;%</translation>
    </message>
    <message>
        <source>Clopper-Pearson 95 %</source>
        <translation>Clopper-Pearson 95&#xa0;%</translation>
    </message>
    <message>
        <source>p by chance</source>
        <translation>p au hasard</translation>
    </message>
    <message>
        <source>Median s</source>
        <translation>Médiane s</translation>
    </message>
    <message>
        <source>of n</source>
        <translation>sur n</translation>
    </message>
    <message>
        <source>In time</source>
        <translation>À temps</translation>
    </message>
    <message>
        <source>Probability of so many right answers, or more, by guessing</source>
        <translation>Probabilité d’au moins autant de réponses correctes au hasard</translation>
    </message>
    <message>
        <source>Information transfer as counted</source>
        <translation>Transfert d’information tel que compté</translation>
    </message>
    <message>
        <source>Response time of right answers</source>
        <translation>Temps de réponse des réponses correctes</translation>
    </message>
    <message>
        <source>Effect</source>
        <translation>Effet</translation>
    </message>
    <message>
        <source>Pattern</source>
        <translation>Motif</translation>
    </message>
    <message>
        <source>df</source>
        <translation>ddl</translation>
    </message>
    <message>
        <source>F</source>
        <translation>F</translation>
    </message>
    <message>
        <source>p</source>
        <translation>p</translation>
    </message>
    <message>
        <source>eps GG</source>
        <translation>eps GG</translation>
    </message>
    <message>
        <source>p GG</source>
        <translation>p GG</translation>
    </message>
    <message>
        <source>eps HF</source>
        <translation>eps HF</translation>
    </message>
    <message>
        <source>p HF</source>
        <translation>p HF</translation>
    </message>
    <message>
        <source>partial eta²</source>
        <translation>êta² partiel</translation>
    </message>
    <message>
        <source>gen. eta²</source>
        <translation>êta² gén.</translation>
    </message>
    <message>
        <source>n</source>
        <translation>n</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Remarque</translation>
    </message>
    <message>
        <source>A comparison of the conditions for this pattern alone</source>
        <translation>Comparaison des conditions pour ce seul motif</translation>
    </message>
    <message>
        <source>Greenhouse and Geisser</source>
        <translation>Greenhouse et Geisser</translation>
    </message>
    <message>
        <source>Huynh and Feldt, at most 1</source>
        <translation>Huynh et Feldt, au plus 1</translation>
    </message>
    <message>
        <source>Generalised eta squared</source>
        <translation>Êta carré généralisé</translation>
    </message>
    <message>
        <source>without %1</source>
        <translation>sans %1</translation>
    </message>
    <message>
        <source>With fewer than 5 k² trials even the corrected value is rough.</source>
        <translation>Avec moins de 5 k² essais, même la valeur corrigée est approximative.</translation>
    </message>
    <message>
        <source>Within participants, condition × pattern, of the shares of right answers; below, the conditions compared for each pattern.</source>
        <translation>Intra-participants, condition × motif, des parts de réponses correctes&#xa0;; en dessous, les conditions comparées pour chaque motif.</translation>
    </message>
    <message>
        <source>Average overestimate</source>
        <translation>Excès moyen</translation>
    </message>
    <message>
        <source>Participants with complete data</source>
        <translation>Participants complets</translation>
    </message>
    <message>
        <source>Few trials give too high an information transfer: with %1 trials, guessing alone shows %2 bit on average. Use the corrected value next to it.</source>
        <translation>Le transfert d’information de peu d’essais est trop élevé&#xa0;: avec %1 essais, quelqu’un qui ne fait que deviner montre %2 bit en moyenne. Lisez la valeur corrigée à côté.</translation>
    </message>
    <message>
        <source>There is only one condition, so the patterns are compared.</source>
        <translation>Il n’y a qu’une condition&#xa0;: ce sont donc les motifs qui sont comparés.</translation>
    </message>
    <message>
        <source>IT 95 %</source>
        <translation>TI 95&#xa0;%</translation>
    </message>
    <message>
        <source>Remark</source>
        <translation>Remarque</translation>
    </message>
    <message>
        <source>Average overestimate, from the jackknife over participants</source>
        <translation>Excès moyen, par le jackknife sur les participants</translation>
    </message>
    <message>
        <source>Interval or bound of the true transfer, from the jackknife over participants</source>
        <translation>Intervalle ou borne du vrai transfert, par le jackknife sur les participants</translation>
    </message>
    <message>
        <source>the t interval is cut off at 0 or 100 %</source>
        <translation>l’intervalle t est coupé à 0 ou à 100&#xa0;%</translation>
    </message>
    <message>
        <source>all participants have the same share</source>
        <translation>tous les participants ont la même part</translation>
    </message>
    <message>
        <source>p %1</source>
        <translation>p %1</translation>
    </message>
    <message>
        <source>%1; Holm %2</source>
        <comment>p of a pattern, corrected p</comment>
        <translation>%1&#xa0;; Holm %2</translation>
    </message>
</context>
<context>
    <name>RobotShape</name>
    <message>
        <source>the shapes of the arm have more than %1 triangles</source>
        <translation>les formes du bras ont plus de %1 triangles</translation>
    </message>
</context>
<context>
    <name>RosArm</name>
    <message>
        <source>the arm cannot be moved: %1</source>
        <translation>le bras ne peut pas être bougé&#xa0;:&#xa0;%1</translation>
    </message>
    <message>
        <source>%1 does not report: %2</source>
        <translation>%1 n’indique pas&#xa0;:&#xa0;%2</translation>
    </message>
    <message>
        <source>%1 reports no effort, so effort_stop cannot work</source>
        <translation>%1 n’indique pas d’effort&#xa0;: effort_stop ne peut donc pas maintenir le bras</translation>
    </message>
    <message>
        <source>no controller reads %1</source>
        <translation>aucun contrôleur ne lit&#xa0;%1</translation>
    </message>
    <message>
        <source>looking for other programs</source>
        <translation>d’autres programmes sont recherchés</translation>
    </message>
    <message>
        <source>it was held; let go of the switch and press it again</source>
        <translation>il a été retenu ; relâchez l’interrupteur et appuyez de nouveau</translation>
    </message>
    <message>
        <source>%1 reports no force, so force_stop_N cannot work</source>
        <translation>%1 ne donne pas de force, force_stop_N ne peut donc pas agir</translation>
    </message>
    <message>
        <source>%1, which the arm requires, is not live</source>
        <translation>%1, qu’exige le bras, n’est pas actif</translation>
    </message>
    <message>
        <source>the stamps of %1 are %2 s behind this computer, MoveIt Servo takes %3 to %4</source>
        <translation>les horodatages de %1 ont %2&#xa0;s de retard sur cet ordinateur, MoveIt Servo admet de %3 à %4</translation>
    </message>
    <message>
        <source>%1 reports a force in the frame %2, which neither the description nor /tf_static has</source>
        <translation>%1 donne une force dans le repère %2, que ni la description ni /tf_static ne connaissent</translation>
    </message>
</context>
<context>
    <name>RosArmCheck</name>
    <message>
        <source>nobody publishes %1</source>
        <translation>personne ne publie&#xa0;%1</translation>
    </message>
    <message>
        <source>nothing was sent on %1</source>
        <translation>rien n’a été envoyé sur&#xa0;%1</translation>
    </message>
    <message>
        <source>%1 does not report: %2</source>
        <translation>%1 n’indique pas&#xa0;:&#xa0;%2</translation>
    </message>
    <message>
        <source>%1 reports all %2 joints</source>
        <translation>%1 indique toutes les&#xa0;%2 articulations</translation>
    </message>
    <message>
        <source>%1 publishers of %2</source>
        <translation>%1 émetteurs de&#xa0;%2</translation>
    </message>
    <message>
        <source>%1 reports %2, which the arm does not have</source>
        <translation>%1 indique&#xa0;%2, que le bras n’a pas</translation>
    </message>
    <message>
        <source>%1 messages were inconsistent and were ignored</source>
        <translation>%1 messages se contredisent et ont été laissés de côté</translation>
    </message>
    <message>
        <source>%1 samples a second, longest gap %2 s</source>
        <translation>%1 échantillons par seconde, plus long intervalle&#xa0;%2 s</translation>
    </message>
    <message>
        <source>; joint_timeout_s is %1</source>
        <translation>&#xa0;; joint_timeout_s vaut&#xa0;%1</translation>
    </message>
    <message>
        <source>reported, in %1 according to the file</source>
        <translation>indiqué, en&#xa0;%1 comme le dit le fichier</translation>
    </message>
    <message>
        <source>not reported, so effort_stop cannot work</source>
        <translation>non indiqué&#xa0;: effort_stop ne peut donc pas maintenir le bras</translation>
    </message>
    <message>
        <source>not reported</source>
        <translation>non indiqué</translation>
    </message>
    <message>
        <source>%1 stamps are zero</source>
        <translation>%1 horodatages sont à zéro</translation>
    </message>
    <message>
        <source>stamps are %1 s behind this computer</source>
        <translation>les horodatages ont&#xa0;%1 s de retard sur cet ordinateur</translation>
    </message>
    <message>
        <source>someone else commands %1</source>
        <translation>quelqu’un d’autre commande&#xa0;%1</translation>
    </message>
    <message>
        <source>%1 has the type %2</source>
        <translation>%1 a le type&#xa0;%2</translation>
    </message>
    <message>
        <source>reads %1</source>
        <translation>lit&#xa0;%1</translation>
    </message>
    <message>
        <source>cannot be reached: %1</source>
        <translation>ne peut pas être atteint&#xa0;:&#xa0;%1</translation>
    </message>
    <message>
        <source>nobody reads %1</source>
        <translation>personne ne lit&#xa0;%1</translation>
    </message>
    <message>
        <source>; found: %1</source>
        <translation>&#xa0;; il y a&#xa0;%1</translation>
    </message>
    <message>
        <source>the check was interrupted</source>
        <translation>la vérification a été interrompue</translation>
    </message>
    <message>
        <source>%1 reports no force</source>
        <translation>%1 ne donne pas de force</translation>
    </message>
    <message>
        <source>%1 messages a second, longest gap %2 s, at most %3 N</source>
        <translation>%1 messages par seconde, plus longue pause %2&#xa0;s, au plus %3&#xa0;N</translation>
    </message>
    <message>
        <source>; timeout_s is %1</source>
        <translation>&#xa0;; timeout_s vaut %1</translation>
    </message>
    <message>
        <source>; force_stop_N is %1</source>
        <translation>&#xa0;; force_stop_N vaut %1</translation>
    </message>
    <message>
        <source>UNGUARDED: %1 keeps its last command when this program ends or the network fails</source>
        <translation>SANS GARDE&#xa0;: %1 garde son dernier ordre quand ce programme s’arrête ou que le réseau est en panne</translation>
    </message>
    <message>
        <source>%1 reports a force in the frame %2, which neither the description nor /tf_static has</source>
        <translation>%1 donne une force dans le repère %2, que ni la description ni /tf_static ne connaissent</translation>
    </message>
</context>
<context>
    <name>RosArmCheckReport</name>
    <message numerus="yes">
        <source>the arm cannot be moved: %n problem(s)</source>
        <translation>
            <numerusform>le bras ne peut pas être bougé&#xa0;:&#xa0;%n problème</numerusform>
            <numerusform>le bras ne peut pas être bougé&#xa0;:&#xa0;%n problèmes</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>RosArmFault</name>
    <message>
        <source>someone else commands %1</source>
        <translation>quelqu’un d’autre commande&#xa0;%1</translation>
    </message>
    <message>
        <source>%1 reports a position that is not a number</source>
        <translation>%1 indique une position qui n’est pas un nombre</translation>
    </message>
    <message>
        <source>the position of %1 jumped</source>
        <translation>la position de&#xa0;%1 a sauté</translation>
    </message>
    <message>
        <source>the stamps of %1 went back</source>
        <translation>les horodatages de&#xa0;%1 ont reculé</translation>
    </message>
    <message>
        <source>the arm does not follow its commands</source>
        <translation>le bras ne suit pas ses commandes</translation>
    </message>
</context>
<context>
    <name>RosArmFile</name>
    <message>
        <source>two joints have the ROS name &quot;%1&quot;</source>
        <translation>deux articulations s’appellent «&#xa0;%1&#xa0;» sur le réseau</translation>
    </message>
    <message>
        <source>a unique name for each joint</source>
        <translation>un nom propre à chaque articulation</translation>
    </message>
    <message>
        <source>a side of the box is empty or reversed</source>
        <translation>un côté de la boîte n’a pas de longueur</translation>
    </message>
    <message>
        <source>[lowest, highest] for x, y and z</source>
        <translation>[minimum, maximum] pour x, y et z</translation>
    </message>
    <message>
        <source>STOP would brake more gently than letting go</source>
        <translation>STOP freinerait moins que le relâchement</translation>
    </message>
    <message>
        <source>at least deceleration_radPerS2, %1</source>
        <translation>au moins deceleration_radPerS2,&#xa0;%1</translation>
    </message>
    <message>
        <source>the efforts of this arm are not in Nm</source>
        <translation>les efforts de ce bras ne sont pas en Nm</translation>
    </message>
    <message>
        <source>the file of a force sensor, kind = &quot;ros_wrench&quot;</source>
        <translation>le fichier d’un capteur de force, kind = &quot;ros_wrench&quot;</translation>
    </message>
    <message>
        <source>another adapter, or unguarded = true</source>
        <translation>un autre adaptateur, ou unguarded = true</translation>
    </message>
    <message>
        <source>with this adapter the robot stops by itself, so it is not unguarded</source>
        <translation>avec cet adaptateur le robot s’arrête de lui-même, il n’est donc pas sans garde</translation>
    </message>
    <message>
        <source>with this adapter nothing stops the robot when this program ends or the network fails</source>
        <translation>avec cet adaptateur, rien n’arrête le robot quand ce programme s’arrête ou que le réseau est en panne</translation>
    </message>
</context>
<context>
    <name>RosArray</name>
    <message>
        <source>%1 has no sensor named &quot;%2&quot;</source>
        <translation>%1 n’a pas de capteur nommé «&#xa0;%2&#xa0;»</translation>
    </message>
</context>
<context>
    <name>RosArrayFile</name>
    <message>
        <source>only a TactileState has sensors with names</source>
        <translation>seul un TactileState a des capteurs avec des noms</translation>
    </message>
    <message>
        <source>with a factor of 0 every value is the same</source>
        <translation>avec un facteur 0, toutes les valeurs sont égales</translation>
    </message>
    <message>
        <source>another number</source>
        <translation>un autre nombre</translation>
    </message>
    <message>
        <source>without a threshold it is not known which taxels are touched</source>
        <translation>sans seuil, on ne sait pas quels taxels sont touchés</translation>
    </message>
    <message>
        <source>threshold = a number in the unit of the values</source>
        <translation>threshold = un nombre dans l’unité des valeurs</translation>
    </message>
</context>
<context>
    <name>RosCameraMessage</name>
    <message>
        <source>a picture has the encoding &quot;%1&quot;</source>
        <translation>une image a le codage «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>a picture has no pixels (%1)</source>
        <translation>une image n’a pas de pixels (%1)</translation>
    </message>
    <message>
        <source>a picture is too large (%1)</source>
        <translation>une image est trop grande (%1)</translation>
    </message>
    <message>
        <source>at most %1 pixels</source>
        <translation>au plus %1 pixels</translation>
    </message>
    <message>
        <source>a picture in %1 has an odd width (%2)</source>
        <translation>une image en %1 a une largeur impaire (%2)</translation>
    </message>
    <message>
        <source>a row of a picture has %1 bytes, its %2 pixels need %3</source>
        <translation>une ligne d’une image a %1 octets, ses %2 pixels en demandent %3</translation>
    </message>
    <message>
        <source>a picture has %1 bytes, its size says %2</source>
        <translation>une image a %1 octets, sa taille en dit %2</translation>
    </message>
    <message>
        <source>a picture is no JPEG or PNG, or too large (%1 bytes)</source>
        <translation>une image n’est ni JPEG ni PNG, ou est trop grande (%1 octets)</translation>
    </message>
    <message>
        <source>JPEG or PNG of at most %1 pixels</source>
        <translation>JPEG ou PNG d’au plus %1 pixels</translation>
    </message>
    <message>
        <source>a picture is damaged (%1 bytes)</source>
        <translation>une image est abîmée (%1 octets)</translation>
    </message>
</context>
<context>
    <name>RosCommand</name>
    <message>
        <source>List topics and who publishes and reads them</source>
        <translation>Lister les topics et qui les publie et les lit</translation>
    </message>
    <message>
        <source>List the nodes of programs</source>
        <translation>Lister les nœuds des programmes</translation>
    </message>
    <message>
        <source>Print what is sent on a topic, until Ctrl-C</source>
        <translation>Afficher ce qui est envoyé sur un topic, jusqu’à Ctrl-C</translation>
    </message>
    <message>
        <source>Name of the topic, for example /joint_states</source>
        <translation>Nom du topic, par exemple /joint_states</translation>
    </message>
    <message>
        <source>End after so many messages</source>
        <translation>Terminer après ce nombre de messages</translation>
    </message>
    <message>
        <source>Number of the domain; default: ROS_DOMAIN_ID of the environment, else 0</source>
        <translation>Numéro du domaine&#xa0;; par défaut&#xa0;: ROS_DOMAIN_ID de l’environnement, sinon 0</translation>
    </message>
    <message>
        <source>Network interface, its name or its address; default: the first one</source>
        <translation>Interface réseau, son nom ou son adresse&#xa0;; par défaut&#xa0;: la première</translation>
    </message>
    <message>
        <source>Computer on which to look for programs besides this one; may be repeated. Multicast is not used</source>
        <translation>Ordinateur où chercher des programmes, en plus de celui-ci&#xa0;; peut être répété. Le multicast n’est pas utilisé</translation>
    </message>
    <message>
        <source>this computer</source>
        <translation>cet ordinateur</translation>
    </message>
    <message>
        <source>no program of domain %1 was found on: %2. Name the robot&apos;s computer with --peer, since multicast is not used.</source>
        <translation>aucun programme du domaine&#xa0;%1 n’a été trouvé sur&#xa0;:&#xa0;%2. Indiquez l’ordinateur du robot avec --peer, car le multicast n’est pas utilisé.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no name of a topic; expected parts of letters, digits and _ after slashes, for example /joint_states</source>
        <translation>«&#xa0;%1&#xa0;» n’est pas un nom de topic&#xa0;; attendu&#xa0;: des parties de lettres, de chiffres et de _ après des barres obliques, par exemple /joint_states</translation>
    </message>
    <message>
        <source>nobody published %1 in domain %2 within %3 s; looked for on: %4</source>
        <translation>personne n’a publié&#xa0;%1 dans le domaine&#xa0;%2 en&#xa0;%3 s&#xa0;; recherché sur&#xa0;:&#xa0;%4</translation>
    </message>
    <message>
        <source>%1 has the type %2, which is not known</source>
        <translation>%1 est du type&#xa0;%2, qui n’est pas connu</translation>
    </message>
    <message>
        <source>nothing was sent on %1 within %2 s</source>
        <translation>rien n’a été envoyé sur&#xa0;%1 en&#xa0;%2 s</translation>
    </message>
    <message>
        <source>Topics and nodes of ROS 2, without ROS</source>
        <translation>Topics et nœuds de ROS 2, sans ROS</translation>
    </message>
    <message>
        <source>Watch an arm for 5 s and report what prevents moving it</source>
        <translation>Observer un bras pendant 5 s et dire ce qui empêche de le bouger</translation>
    </message>
    <message>
        <source>File that describes the arm (kind = &quot;ros_arm&quot;)</source>
        <translation>Fichier qui décrit le bras (kind = &quot;ros_arm&quot;)</translation>
    </message>
</context>
<context>
    <name>RosProbeText</name>
    <message>
        <source>nothing came on the topic</source>
        <translation>rien n’est venu sur le topic</translation>
    </message>
</context>
<context>
    <name>RosWrenchFile</name>
    <message>
        <source>a sign of 0 hides every force</source>
        <translation>un signe nul cache toute force</translation>
    </message>
    <message>
        <source>1: it reports what acts on the arm; -1: what the arm exerts</source>
        <translation>1&#xa0;: il donne ce qui agit sur le bras&#xa0;; -1&#xa0;: ce que le bras exerce</translation>
    </message>
</context>
<context>
    <name>RunSheet</name>
    <message>
        <source>point</source>
        <translation>point</translation>
    </message>
    <message>
        <source>edge</source>
        <translation>arête</translation>
    </message>
</context>
<context>
    <name>RunText</name>
    <message>
        <source>STOP ended the measurement.</source>
        <translation>STOP a mis fin à la mesure.</translation>
    </message>
    <message>
        <source>release STOP and measure again</source>
        <translation>relâchez STOP et mesurez à nouveau</translation>
    </message>
    <message>
        <source>The bracelet was lost during the measurement.</source>
        <translation>Le bracelet a été perdu pendant la mesure.</translation>
    </message>
    <message>
        <source>connect it and measure again</source>
        <translation>connectez-le et mesurez à nouveau</translation>
    </message>
    <message>
        <source>Something else was played meanwhile.</source>
        <translation>Autre chose a été joué entre-temps.</translation>
    </message>
    <message>
        <source>measure again</source>
        <translation>mesurez à nouveau</translation>
    </message>
    <message>
        <source>The bracelet is too hot to be measured.</source>
        <translation>Le bracelet est trop chaud pour être mesuré.</translation>
    </message>
    <message>
        <source>let it cool down and measure again</source>
        <translation>laissez-le refroidir et mesurez à nouveau</translation>
    </message>
    <message>
        <source>The bracelet does not measure its motors.</source>
        <translation>Le bracelet ne mesure pas ses moteurs.</translation>
    </message>
    <message>
        <source>a recording with a sensor of your own, or answers of a person</source>
        <translation>un enregistrement avec votre propre capteur, ou les réponses d’une personne</translation>
    </message>
    <message>
        <source>The measurement was ended.</source>
        <translation>La mesure a été arrêtée.</translation>
    </message>
    <message>
        <source>The computer was too slow for the measurement: the bracelet paused in between.</source>
        <translation>L’ordinateur était trop lent pour la mesure&#xa0;: le bracelet s’est arrêté entre-temps.</translation>
    </message>
    <message>
        <source>measure again with fewer programs running</source>
        <translation>mesurez à nouveau avec moins d’autres tâches</translation>
    </message>
</context>
<context>
    <name>RunningSiteText</name>
    <message>
        <source>nothing was read yet</source>
        <translation>rien n’a encore été lu</translation>
    </message>
    <message>
        <source>it sends nothing any more</source>
        <translation>il n’envoie plus rien</translation>
    </message>
    <message>
        <source>it is not connected</source>
        <translation>il n’est pas connecté</translation>
    </message>
    <message>
        <source>interrupted</source>
        <translation>interrompu</translation>
    </message>
    <message>
        <source>%1 requires the device %2, which the site does not have</source>
        <translation>%1 exige l’appareil %2, que le site n’a pas</translation>
    </message>
    <message>
        <source>ids of the site&apos;s devices</source>
        <translation>des id d’appareils du site</translation>
    </message>
</context>
<context>
    <name>Scene</name>
    <message>
        <source>the scene is not that of a tactile array</source>
        <translation>la scène n’est pas celle d’une matrice tactile</translation>
    </message>
    <message>
        <source>the scene is not that of an arm</source>
        <translation>la scène n’est pas celle d’un bras</translation>
    </message>
    <message>
        <source>the scene is not that of a camera in a soft tube</source>
        <translation>la scène n’est pas celle d’une caméra dans un tube souple</translation>
    </message>
    <message>
        <source>the scene is not that of a servoing arm</source>
        <translation>la scène n’est pas celle d’un bras asservi</translation>
    </message>
    <message>
        <source>the scene is not that of an arm with an operator</source>
        <translation>la scène n’est pas celle d’un bras avec un opérateur</translation>
    </message>
    <message>
        <source>the scene is not that of a flat gel</source>
        <translation>la scène n’est pas celle d’un gel plat</translation>
    </message>
</context>
<context>
    <name>SceneReader</name>
    <message>
        <source>a time after %1 s</source>
        <translation>un temps après %1 s</translation>
    </message>
    <message>
        <source>the motion does not end where it starts</source>
        <translation>le mouvement ne se termine pas où il commence</translation>
    </message>
    <message>
        <source>a last keyframe like the first one</source>
        <translation>une dernière image clé identique à la première</translation>
    </message>
    <message>
        <source>which taxels are dead is not clear</source>
        <translation>on ne sait pas quels taxels sont morts</translation>
    </message>
    <message>
        <source>either &quot;count&quot; or &quot;taxels&quot;</source>
        <translation>soit «&#xa0;count&#xa0;», soit «&#xa0;taxels&#xa0;»</translation>
    </message>
    <message>
        <source>the effect is listed twice</source>
        <translation>l’effet est indiqué deux fois</translation>
    </message>
    <message>
        <source>each effect at most once</source>
        <translation>chaque effet au plus une fois</translation>
    </message>
    <message>
        <source>the arm starts outside the range of its joints</source>
        <translation>le bras démarre hors de la plage de ses articulations</translation>
    </message>
    <message>
        <source>%1 from %2 to %3</source>
        <translation>%1 de %2 à %3</translation>
    </message>
    <message>
        <source>the program has no object to touch</source>
        <translation>le programme n’a pas d’objet à toucher</translation>
    </message>
    <message>
        <source>at least one [[object]]</source>
        <translation>au moins un [[object]]</translation>
    </message>
    <message>
        <source>the camera is too far from the tube&apos;s axis</source>
        <translation>la caméra est trop loin de l’axe du tube</translation>
    </message>
    <message>
        <source>less than %1 m</source>
        <translation>moins de %1 m</translation>
    </message>
    <message>
        <source>the dots touch each other</source>
        <translation>les points se touchent</translation>
    </message>
    <message>
        <source>less than the pitch of %1 m</source>
        <translation>moins que le pas de %1 m</translation>
    </message>
    <message>
        <source>there would be too few or too many dots</source>
        <translation>il y aurait trop peu ou trop de points</translation>
    </message>
    <message>
        <source>more than %1 m and less than the radius of %2 m</source>
        <translation>plus de %1 m et moins que le rayon de %2 m</translation>
    </message>
    <message>
        <source>there is no tray to keep level</source>
        <translation>il n’y a pas de plateau à tenir horizontal</translation>
    </message>
    <message>
        <source>an [object.hinge]</source>
        <translation>une [object.hinge]</translation>
    </message>
    <message>
        <source>the times of the keyframes do not increase</source>
        <translation>les images clés ne sont pas dans l’ordre du temps</translation>
    </message>
    <message>
        <source>this is deeper than the skin can yield</source>
        <translation>c’est plus profond que la peau ne peut céder</translation>
    </message>
    <message>
        <source>this scene cannot have the effect &quot;%1&quot;</source>
        <translation>cette scène ne peut pas avoir l’effet « %1 »</translation>
    </message>
    <message>
        <source>the markers touch each other</source>
        <translation>les marqueurs se touchent</translation>
    </message>
    <message>
        <source>the markers do not fit into the picture</source>
        <translation>les marqueurs ne tiennent pas dans l’image</translation>
    </message>
    <message>
        <source>a grid smaller than %1 m x %2 m</source>
        <translation>une grille plus petite que %1 m x %2 m</translation>
    </message>
    <message>
        <source>this is deeper than the ball is round</source>
        <translation>c’est plus profond que le rayon de la bille</translation>
    </message>
</context>
<context>
    <name>SceneRecording</name>
    <message>
        <source>another program reads the recording, which keeps this name</source>
        <translation>un autre programme lit l’enregistrement, qui garde ce nom</translation>
    </message>
</context>
<context>
    <name>SceneRun</name>
    <message>
        <source>the image cannot be written</source>
        <translation>l’image ne peut pas être écrite</translation>
    </message>
    <message>
        <source>the folder cannot be created or written to</source>
        <translation>le dossier ne peut pas être créé, ou on ne peut pas y écrire</translation>
    </message>
    <message>
        <source>the protocol has a stimulus that is not built in</source>
        <translation>le protocole a un stimulus qui n’est pas fourni avec le programme</translation>
    </message>
    <message>
        <source>tasks, letters and conditions whose patterns are built in</source>
        <translation>des tâches, lettres et conditions dont les motifs sont fournis avec le programme</translation>
    </message>
</context>
<context>
    <name>SerialTriggerText</name>
    <message>
        <source>the trigger&apos;s serial line cannot be used: %1</source>
        <translation>la ligne série du déclencheur ne peut pas être utilisée&#xa0;: %1</translation>
    </message>
    <message>
        <source>this is not a serial line</source>
        <translation>ce n’est pas une ligne série</translation>
    </message>
    <message>
        <source>a serial port, such as /dev/ttyUSB0</source>
        <translation>un port série, comme /dev/ttyUSB0</translation>
    </message>
</context>
<context>
    <name>ServoCurves</name>
    <message>
        <source>a number from -1e12 to 1e12, or NA</source>
        <translation>un nombre de -1e12 à 1e12, ou NA</translation>
    </message>
    <message>
        <source>times in order</source>
        <translation>des temps dans l’ordre</translation>
    </message>
    <message>
        <source>names such as force+tool_speed, or nothing</source>
        <translation>des noms comme force+tool_speed, ou rien</translation>
    </message>
    <message>
        <source>this is not a plausible number</source>
        <translation>ce n’est pas un nombre d’une exécution</translation>
    </message>
    <message>
        <source>the time decreases or is missing</source>
        <translation>le temps diminue, ou manque</translation>
    </message>
    <message>
        <source>this is not a limit of a servo</source>
        <translation>ce n’est pas une limite d’un asservissement</translation>
    </message>
</context>
<context>
    <name>ServoTexts</name>
    <message>
        <source>Free motion</source>
        <translation>Mouvement libre</translation>
    </message>
    <message>
        <source>Align</source>
        <translation>Aligner</translation>
    </message>
    <message>
        <source>Edge control</source>
        <translation>Contrôle d’arête</translation>
    </message>
    <message>
        <source>Explore</source>
        <translation>Explorer</translation>
    </message>
    <message>
        <source>Roll</source>
        <translation>Rouler</translation>
    </message>
    <message>
        <source>Follow a point</source>
        <translation>Suivre un point</translation>
    </message>
    <message>
        <source>Co-manipulation</source>
        <translation>Co-manipulation</translation>
    </message>
    <message>
        <source>no contact</source>
        <translation>pas de contact</translation>
    </message>
    <message>
        <source>in contact</source>
        <translation>en contact</translation>
    </message>
    <message>
        <source>searching for the contact</source>
        <translation>recherche du contact</translation>
    </message>
    <message>
        <source>contact lost</source>
        <translation>contact perdu</translation>
    </message>
    <message>
        <source>tool speed</source>
        <translation>vitesse de l’outil</translation>
    </message>
    <message>
        <source>turn rate</source>
        <translation>vitesse de rotation</translation>
    </message>
    <message>
        <source>force</source>
        <translation>force</translation>
    </message>
    <message>
        <source>saturated taxel</source>
        <translation>taxel saturé</translation>
    </message>
    <message>
        <source>distance from the measured pose</source>
        <translation>distance à la pose mesurée</translation>
    </message>
    <message>
        <source>joint speed</source>
        <translation>vitesse articulaire</translation>
    </message>
    <message>
        <source>end of a joint</source>
        <translation>butée d’une articulation</translation>
    </message>
    <message>
        <source>singular arm</source>
        <translation>bras singulier</translation>
    </message>
    <message>
        <source>gap between frames</source>
        <translation>lacune entre trames</translation>
    </message>
    <message>
        <source>unusable numbers</source>
        <translation>nombres inutilisables</translation>
    </message>
    <message>
        <source>, </source>
        <comment>between the limits that act</comment>
        <translation>, </translation>
    </message>
    <message>
        <source>Simulated cycle: %1 µs, %2 times real time. Contact %3 %, kinematics %4 %, features %5 %, control %6 %, dynamics %7 %.</source>
        <translation>Cycle simulé&#xa0;: %1 µs, %2 fois le temps réel. Contact %3&#xa0;%, cinématique %4&#xa0;%, caractéristiques %5&#xa0;%, commande %6&#xa0;%, dynamique %7&#xa0;%.</translation>
    </message>
    <message>
        <source>%1, run %2</source>
        <comment>a source, and which of its runs</comment>
        <translation>%1, exécution %2</translation>
    </message>
    <message>
        <source>%1, partly without DZMP</source>
        <comment>a run</comment>
        <translation>%1, en partie sans DZMP</translation>
    </message>
    <message>
        <source>%1, without DZMP</source>
        <comment>a run</comment>
        <translation>%1, sans DZMP</translation>
    </message>
    <message>
        <source>CoP x</source>
        <translation>CoP x</translation>
    </message>
    <message>
        <source>CoP y</source>
        <translation>CoP y</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Force</translation>
    </message>
    <message>
        <source>−DZMP x</source>
        <translation>−DZMP x</translation>
    </message>
    <message>
        <source>CoC y</source>
        <translation>CoC y</translation>
    </message>
    <message>
        <source>−DZMP y</source>
        <translation>−DZMP y</translation>
    </message>
    <message>
        <source>CoC x</source>
        <translation>CoC x</translation>
    </message>
    <message>
        <source>α z</source>
        <translation>α z</translation>
    </message>
    <message>
        <source>task completed</source>
        <translation>tâche accomplie</translation>
    </message>
    <message>
        <source>task not completed: stalled by the limit “%1”</source>
        <translation>tâche non accomplie&#xa0;: bloqué par la limite «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>task not completed: never in contact</source>
        <translation>tâche non accomplie&#xa0;: jamais en contact</translation>
    </message>
    <message>
        <source>task not completed: the contact was lost</source>
        <translation>tâche non accomplie&#xa0;: le contact a été perdu</translation>
    </message>
    <message>
        <source>task not completed: stalled</source>
        <translation>tâche non accomplie&#xa0;: bras bloqué</translation>
    </message>
    <message>
        <source>task not completed: not aligned</source>
        <translation>tâche non accomplie&#xa0;: matrice non alignée</translation>
    </message>
</context>
<context>
    <name>SettingsNotice</name>
    <message>
        <source>The settings are damaged: what can be read of them is used, the rest is as at the first start.</source>
        <translation>Les réglages sont endommagés&#xa0;: ce qui peut en être lu est utilisé, le reste est comme au premier démarrage.</translation>
    </message>
    <message>
        <source>No copy of the damaged file could be kept.</source>
        <translation>Aucune copie du fichier endommagé n’a pu être gardée.</translation>
    </message>
    <message>
        <source>A copy of the damaged file: %1</source>
        <translation>Copie du fichier endommagé&#xa0;: %1</translation>
    </message>
    <message>
        <source>The settings are those of a newer version of this program: everything is as at the first start, and nothing is remembered.</source>
        <translation>Les réglages sont ceux d’une version plus récente de ce programme&#xa0;: tout est comme au premier démarrage et rien n’est retenu.</translation>
    </message>
    <message>
        <source>The file stays as it is: %1</source>
        <translation>Le fichier reste tel quel&#xa0;: %1</translation>
    </message>
    <message>
        <source>The settings cannot be kept: what is set now is forgotten at the end.</source>
        <translation>Les réglages ne peuvent pas être conservés&#xa0;: ce qui est réglé maintenant est oublié à la fin.</translation>
    </message>
    <message>
        <source>This file cannot be written: %1</source>
        <translation>Ce fichier ne peut pas être écrit&#xa0;: %1</translation>
    </message>
</context>
<context>
    <name>SimulateCommand</name>
    <message>
        <source>Scene</source>
        <translation>Scène</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Graine</translation>
    </message>
    <message>
        <source>Simulated</source>
        <translation>Simulé</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>Computed in</source>
        <translation>Calculé en</translation>
    </message>
    <message>
        <source>%1 s (%2 x real time)</source>
        <translation>%1 s (%2 x temps réel)</translation>
    </message>
    <message>
        <source>Effect %1</source>
        <translation>Effet %1</translation>
    </message>
    <message>
        <source>Events</source>
        <translation>Événements</translation>
    </message>
    <message>
        <source>Run a simulated scene as fast as possible and measure what was estimated</source>
        <translation>Exécuter une scène simulée aussi vite que possible et mesurer ce qui a été estimé</translation>
    </message>
    <message>
        <source>Seed of all random numbers of the scene</source>
        <translation>Graine de tous les nombres aléatoires de la scène</translation>
    </message>
    <message>
        <source>Share of %1</source>
        <translation>Part de %1</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1&#xa0;%</translation>
    </message>
    <message>
        <source>Scene file, or the name of a scene that comes with the program</source>
        <translation>Fichier de scène, ou nom d’une scène fournie avec le programme</translation>
    </message>
    <message>
        <source>List the scenes that come with the program</source>
        <translation>Lister les scènes fournies avec le programme</translation>
    </message>
    <message>
        <source>Folder for summary.json, the recording and its data as CSV; with --ablate the CSV file</source>
        <translation>Dossier pour summary.json, l’enregistrement et ses données en CSV&#xa0;; avec --ablate, le fichier CSV</translation>
    </message>
    <message>
        <source>Formats of the chart of a servo run in --out, separated by commas</source>
        <translation>Formats du graphique d’une exécution d’asservissement dans --out, séparés par des virgules</translation>
    </message>
    <message>
        <source>Folders of earlier servo runs for the same chart, up to five</source>
        <translation>Dossiers d’exécutions d’asservissement antérieures pour le même graphique, cinq au plus</translation>
    </message>
    <message>
        <source>Runs of each variant, with seeds from --seed upwards</source>
        <translation>Exécutions de chaque variante, avec des graines croissantes à partir de --seed</translation>
    </message>
    <message>
        <source>is required</source>
        <translation>est obligatoire</translation>
    </message>
    <message>
        <source>is for scenes of a servo</source>
        <translation>est pour les scènes d’asservissement</translation>
    </message>
    <message>
        <source>a scene file, or a name that teleta simulate --list prints</source>
        <translation>un fichier de scène, ou un nom que teleta simulate --list affiche</translation>
    </message>
    <message>
        <source>Simulated time in seconds; default: as the scene says</source>
        <translation>Temps simulé en secondes&#xa0;; sinon ce que dit la scène</translation>
    </message>
    <message>
        <source>Leave out one effect at a time and compare how far each measure moves with its spread</source>
        <translation>Retirer un effet à la fois et dire de combien les mesures bougent par rapport à leur dispersion</translation>
    </message>
    <message>
        <source>never in contact</source>
        <translation>jamais en contact</translation>
    </message>
    <message>
        <source>the contact was lost</source>
        <translation>le contact a été perdu</translation>
    </message>
    <message>
        <source>stalled</source>
        <translation>bloqué</translation>
    </message>
    <message>
        <source>stalled by the limit %1</source>
        <translation>bloqué par la limite %1</translation>
    </message>
    <message>
        <source>not aligned</source>
        <translation>non aligné</translation>
    </message>
    <message>
        <source>completed</source>
        <translation>accompli</translation>
    </message>
    <message>
        <source>not completed: %1, in the phase %2</source>
        <translation>non accompli&#xa0;: %1, dans la phase %2</translation>
    </message>
    <message>
        <source>Task</source>
        <translation>Tâche</translation>
    </message>
    <message>
        <source>the task was %1</source>
        <translation>bilan de la tâche&#xa0;: %1</translation>
    </message>
    <message>
        <source>a completed task, or expect = &quot;not_completed&quot; in the scene</source>
        <translation>une tâche accomplie, ou expect = &quot;not_completed&quot; dans la scène</translation>
    </message>
</context>
<context>
    <name>SimulatedArmDevice</name>
    <message>
        <source>The arm was unplugged.</source>
        <translation>Le bras a été débranché.</translation>
    </message>
</context>
<context>
    <name>SimulatedArrayDevice</name>
    <message>
        <source>The device was unplugged.</source>
        <translation>L’appareil a été débranché.</translation>
    </message>
</context>
<context>
    <name>SimulatedBracelet</name>
    <message>
        <source>Simulated bracelet</source>
        <translation>Bracelet simulé</translation>
    </message>
    <message>
        <source>The bracelet was unplugged.</source>
        <translation>Le bracelet a été débranché.</translation>
    </message>
</context>
<context>
    <name>SimulatedCameraDevice</name>
    <message>
        <source>The camera was unplugged.</source>
        <translation>La caméra a été débranchée.</translation>
    </message>
</context>
<context>
    <name>SimulatedObserver</name>
    <message>
        <source>an observer cannot have &quot;%1&quot;</source>
        <translation>un observateur ne peut pas avoir «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>t and slope above 0, lapse from 0 to %1, sd of at least 0, as in t=0.2,slope=3.5,lapse=0.02,sd=0.1</source>
        <translation>t et slope supérieurs à 0, lapse de 0 à %1, sd d’au moins 0, comme dans t=0.2,slope=3.5,lapse=0.02,sd=0.1</translation>
    </message>
</context>
<context>
    <name>SimulatedTube</name>
    <message>
        <source>the lens folds the image over itself: no camera has such a lens</source>
        <translation>l’objectif de la caméra se replie&#xa0;: aucune caméra n’en a de tel</translation>
    </message>
</context>
<context>
    <name>SiteClientText</name>
    <message>
        <source>interrupted</source>
        <translation>interrompu</translation>
    </message>
    <message>
        <source>%1 speaks version %2 of the protocol of sites, this program version %3</source>
        <translation>%1 parle la version %2 du protocole des sites, ce programme la version %3</translation>
    </message>
    <message>
        <source>the site %1 was not found in domain %2 within %3 s</source>
        <translation>le site %1 n’a pas été trouvé dans le domaine %2 en %3 s</translation>
    </message>
    <message>
        <source>teleta-site running there, and its address under peers</source>
        <translation>teleta-site en marche là-bas, et son adresse sous peers</translation>
    </message>
    <message>
        <source>the site does not answer</source>
        <translation>le site ne répond pas</translation>
    </message>
    <message>
        <source>STOP is held by %1</source>
        <translation>STOP est maintenu par %1</translation>
    </message>
    <message>
        <source>nobody controls the site; request control first</source>
        <translation>personne ne commande le site ; demandez d’abord la commande</translation>
    </message>
    <message>
        <source>%1 controls the site</source>
        <translation>%1 commande le site</translation>
    </message>
    <message>
        <source>control is being handed to %1</source>
        <translation>la commande est en cours de transfert à %1</translation>
    </message>
    <message>
        <source>the site has no such arm any more</source>
        <translation>le site n’a plus ce bras</translation>
    </message>
    <message>
        <source>an arm had a fault; clear it first</source>
        <translation>un bras a eu un défaut ; effacez-le d’abord</translation>
    </message>
    <message>
        <source>an earlier program of this console still controls the site</source>
        <translation>un programme précédent de cette console commande encore le site</translation>
    </message>
</context>
<context>
    <name>SiteCommandText</name>
    <message>
        <source>Check the certificates and permissions of a site, or print the commands that create them</source>
        <translation>Vérifier les certificats et les permissions d’un site, ou donner les commandes qui les créent</translation>
    </message>
    <message>
        <source>Folder with identity_ca.pem, permissions_ca.pem, governance.p7s and one folder for each site, console and viewer</source>
        <translation>Dossier avec identity_ca.pem, permissions_ca.pem, governance.p7s et un dossier pour chaque site, console et observateur</translation>
    </message>
    <message>
        <source>Instead of checking, print the openssl commands that create the folder for a site of this name</source>
        <translation>Ne rien vérifier, afficher les commandes openssl qui créent le dossier pour un site de ce nom</translation>
    </message>
    <message>
        <source>Consoles that may take control</source>
        <translation>Consoles qui peuvent commander</translation>
    </message>
    <message>
        <source>Consoles that only watch</source>
        <translation>Consoles qui ne font qu’observer</translation>
    </message>
    <message>
        <source>List the sites that are there and who controls them</source>
        <translation>Lister les sites présents et qui les commande</translation>
    </message>
    <message>
        <source>Print each change of a site&apos;s state</source>
        <translation>Afficher chaque changement d’état d’un site</translation>
    </message>
    <message>
        <source>Print the offset of a site&apos;s clock, and its bound</source>
        <translation>Afficher le décalage de l’horloge d’un site, et sa borne</translation>
    </message>
    <message>
        <source>Record all that a site sends, without a screen</source>
        <translation>Enregistrer tout ce qu’un site envoie, sans écran</translation>
    </message>
    <message>
        <source>File of the recording</source>
        <translation>Fichier de l’enregistrement</translation>
    </message>
    <message>
        <source>File with which the site is reached (kind = &quot;remote_site&quot;)</source>
        <translation>Fichier qui permet d’atteindre le site (kind = &quot;remote_site&quot;)</translation>
    </message>
    <message>
        <source>End after that time; default: Ctrl-C</source>
        <translation>Finir après ce temps ; par défaut : Ctrl-C</translation>
    </message>
    <message>
        <source>These keys are not safe to use.</source>
        <translation>Ces clés ne peuvent pas être utilisées sans danger.</translation>
    </message>
    <message>
        <source>%1 (%2): %3, until %4</source>
        <translation>%1 (%2)&#xa0;:&#xa0;%3, jusqu’au&#xa0;%4</translation>
    </message>
    <message>
        <source>Refused: %1</source>
        <translation>Refusé&#xa0;:&#xa0;%1</translation>
    </message>
    <message>
        <source>Warning: %1</source>
        <translation>Avertissement&#xa0;:&#xa0;%1</translation>
    </message>
    <message>
        <source>Sites at which robots are, and their keys</source>
        <translation>Sites où sont les robots, et leurs clés</translation>
    </message>
</context>
<context>
    <name>SiteFileText</name>
    <message>
        <source>the device needs an id</source>
        <translation>l’appareil a besoin d’un id</translation>
    </message>
    <message>
        <source>id = &quot;a small letter, then small letters, digits and _&quot;</source>
        <translation>id = &quot;une minuscule, puis des minuscules, des chiffres et _&quot;</translation>
    </message>
    <message>
        <source>a site does not send this kind of device</source>
        <translation>un site n’envoie pas ce genre d’appareil</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no name of a console</source>
        <translation>« %1 » n’est pas un nom de console</translation>
    </message>
    <message>
        <source>a small letter, then at most 30 small letters, digits and _</source>
        <translation>une minuscule, puis au plus 30 minuscules, chiffres et _</translation>
    </message>
    <message>
        <source>two devices are called &quot;%1&quot;</source>
        <translation>deux appareils s’appellent « %1 »</translation>
    </message>
    <message>
        <source>a unique id for each device</source>
        <translation>un id unique pour chaque appareil</translation>
    </message>
    <message>
        <source>the file of an arm, an array or a camera over ROS 2</source>
        <translation>le fichier d’un bras, d’une matrice ou d’une caméra par ROS 2</translation>
    </message>
    <message>
        <source>file, wts, taxels, scene or scene_camera</source>
        <translation>file, wts, taxels, scene ou scene_camera</translation>
    </message>
</context>
<context>
    <name>SiteKeys</name>
    <message>
        <source>&apos;%1&apos; is not a valid name for a site or a console</source>
        <translation>«&#xa0;%1&#xa0;» n’est pas un nom de site ni de console</translation>
    </message>
    <message>
        <source>a lowercase letter, then at most 30 of a-z, 0-9 and _</source>
        <translation>une lettre minuscule, puis au plus 30 caractères parmi a-z, 0-9 et _</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is already taken</source>
        <translation>«&#xa0;%1&#xa0;» est déjà pris</translation>
    </message>
    <message>
        <source>No topic of a site (rt/teleta/SITE/...) is allowed.</source>
        <translation>Aucun topic d’un site (rt/teleta/SITE/...) n’est permis.</translation>
    </message>
    <message>
        <source>%1 must not publish %2.</source>
        <translation>%1 ne doit pas publier&#xa0;%2.</translation>
    </message>
    <message>
        <source>%1 needs to publish %2.</source>
        <translation>%1 doit pouvoir publier&#xa0;%2.</translation>
    </message>
    <message>
        <source>%1 must not subscribe to %2.</source>
        <translation>%1 ne doit pas s’abonner à&#xa0;%2.</translation>
    </message>
    <message>
        <source>%1 needs to subscribe to %2.</source>
        <translation>%1 doit pouvoir s’abonner à&#xa0;%2.</translation>
    </message>
    <message>
        <source>%1 must not relay %2.</source>
        <translation>%1 ne doit pas relayer&#xa0;%2.</translation>
    </message>
    <message>
        <source>The signed document is not XML.</source>
        <translation>Ce qui est signé n’est pas du XML.</translation>
    </message>
    <message>
        <source>The validity needs not_before and not_after as 2026-01-31T00:00:00, without a time zone.</source>
        <translation>La validité demande not_before et not_after sous la forme 2026-01-31T00:00:00, sans fuseau horaire.</translation>
    </message>
    <message>
        <source>The permissions are not valid yet.</source>
        <translation>Les permissions ne sont pas encore valables.</translation>
    </message>
    <message>
        <source>The permissions have expired.</source>
        <translation>Les permissions ont expiré.</translation>
    </message>
    <message>
        <source>The grant has a deny_rule. It needs none: what is not allowed is denied.</source>
        <translation>L’autorisation (grant) a une deny_rule. Il n’en faut pas&#xa0;: ce qui n’est pas permis est refusé.</translation>
    </message>
    <message>
        <source>The default of the grant is not DENY.</source>
        <translation>La valeur par défaut de l’autorisation (grant) n’est pas DENY.</translation>
    </message>
    <message>
        <source>No grant names the subject of the certificate, %1.</source>
        <translation>Aucune autorisation (grant) ne nomme le sujet du certificat,&#xa0;%1.</translation>
    </message>
    <message>
        <source>The signed document has no domain_rule.</source>
        <translation>Ce qui est signé n’a pas de domain_rule.</translation>
    </message>
    <message>
        <source>%1 must be %2.</source>
        <translation>%1 doit être&#xa0;%2.</translation>
    </message>
    <message>
        <source>Both authorities share one key. Anyone with a certificate could sign their own permissions.</source>
        <translation>Les deux autorités ont la même clé. Quiconque a un certificat pourrait signer ses propres permissions.</translation>
    </message>
    <message>
        <source>There is no folder for a site, a console or a viewer.</source>
        <translation>Il n’y a aucun dossier de site, de console ou d’observateur.</translation>
    </message>
    <message>
        <source>This is not a certificate.</source>
        <translation>Ce n’est pas un certificat.</translation>
    </message>
    <message>
        <source>The file is missing.</source>
        <translation>Le fichier manque.</translation>
    </message>
    <message>
        <source>The certificate is not valid yet.</source>
        <translation>Le certificat n’est pas encore valable.</translation>
    </message>
    <message>
        <source>The certificate has expired.</source>
        <translation>Le certificat a expiré.</translation>
    </message>
    <message>
        <source>The certificate ends on %1.</source>
        <translation>Le certificat prend fin le&#xa0;%1.</translation>
    </message>
    <message>
        <source>This is not a certificate authority (basicConstraints CA:TRUE).</source>
        <translation>Ce n’est pas une autorité de certification (basicConstraints CA:TRUE).</translation>
    </message>
    <message>
        <source>Its key usage lacks digitalSignature or keyCertSign.</source>
        <translation>Il manque digitalSignature ou keyCertSign dans son usage de clé.</translation>
    </message>
    <message>
        <source>It is not self-signed.</source>
        <translation>Il n’est pas signé par lui-même.</translation>
    </message>
    <message>
        <source>Others can read or write this private key (chmod 600).</source>
        <translation>D’autres peuvent lire ou écrire cette clé privée (chmod 600).</translation>
    </message>
    <message>
        <source>This is not a private key without a password.</source>
        <translation>Ce n’est pas une clé privée sans mot de passe.</translation>
    </message>
    <message>
        <source>The key does not belong to the certificate.</source>
        <translation>La clé n’appartient pas au certificat.</translation>
    </message>
    <message>
        <source>It is not signed by permissions_ca.pem itself.</source>
        <translation>Il n’est pas signé par permissions_ca.pem même.</translation>
    </message>
    <message>
        <source>Its subject is %1, the folder is called %2.</source>
        <translation>Son sujet est&#xa0;%1, le dossier s’appelle&#xa0;%2.</translation>
    </message>
    <message>
        <source>It is not signed by identity_ca.pem.</source>
        <translation>Il n’est pas signé par identity_ca.pem.</translation>
    </message>
    <message>
        <source>It verifies against permissions_ca.pem, so its holder could sign their own permissions. That authority must sign nothing but governance and permissions.</source>
        <translation>Il est validé par permissions_ca.pem&#xa0;: son détenteur pourrait signer ses propres permissions. Cette autorité ne doit signer que la gouvernance et les permissions.</translation>
    </message>
    <message>
        <source>The key is not here. That is fine if it is kept only on its own computer.</source>
        <translation>La clé n’est pas ici. C’est correct si elle n’est que sur son propre ordinateur.</translation>
    </message>
    <message>
        <source>The permissions end on %1.</source>
        <translation>Les permissions prennent fin le&#xa0;%1.</translation>
    </message>
    <message>
        <source>Its topics belong to the site %1, those of other permissions to %2.</source>
        <translation>Ses topics sont ceux du site&#xa0;%1, d’autres permissions nomment&#xa0;%2.</translation>
    </message>
    <message>
        <source>There is no folder %1.</source>
        <translation>Il n’y a pas de dossier&#xa0;%1.</translation>
    </message>
    <message>
        <source>The folder %1 cannot be read.</source>
        <translation>Le dossier&#xa0;%1 ne peut pas être lu.</translation>
    </message>
</context>
<context>
    <name>SiteProgramText</name>
    <message numerus="yes">
        <source>All %n device(s) are ready.</source>
        <translation>
            <numerusform>Le %n appareil est prêt.</numerusform>
            <numerusform>Les %n appareils sont prêts.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 is ready in domain %2 on %3</source>
        <translation>%1 est prêt dans le domaine %2 sur %3</translation>
    </message>
    <message>
        <source>the site ends; the arms are held</source>
        <translation>le site se termine ; les bras sont maintenus</translation>
    </message>
    <message>
        <source>Runs at the robot: sends what its arms and tactile arrays feel to the consoles, and decides which console moves them.</source>
        <translation>Tourne auprès du robot : envoie aux consoles ce que sentent ses bras et ses réseaux tactiles, et décide quelle console les déplace.</translation>
    </message>
    <message>
        <source>Print this help</source>
        <translation>Afficher cette aide</translation>
    </message>
    <message>
        <source>File of the site (kind = &quot;site&quot;)</source>
        <translation>Fichier du site (kind = &quot;site&quot;)</translation>
    </message>
    <message>
        <source>Open everything, move nothing, and say what is missing</source>
        <translation>Tout ouvrir, ne rien déplacer, et dire ce qui manque</translation>
    </message>
    <message>
        <source>Print the log, or what is missing, as JSON on standard output</source>
        <translation>Afficher le journal, ou ce qui manque, en JSON sur la sortie standard</translation>
    </message>
    <message>
        <source>Folder for recordings (record = true); default: the current one</source>
        <translation>Dossier des enregistrements (record = true) ; par défaut : le dossier courant</translation>
    </message>
    <message>
        <source>Print the version</source>
        <translation>Afficher la version</translation>
    </message>
    <message>
        <source>teleta-site: %1
Run teleta-site --help for more.
</source>
        <translation>teleta-site: %1
Lancez teleta-site --help pour en savoir plus.
</translation>
    </message>
</context>
<context>
    <name>SiteRequestText</name>
    <message>
        <source>the site %1 has no device to show</source>
        <translation>le site %1 n’a aucun appareil à montrer</translation>
    </message>
    <message>
        <source>the connection to %1 has ended</source>
        <translation>la connexion à %1 est terminée</translation>
    </message>
    <message>
        <source>the site to be connected again</source>
        <translation>que le site soit connecté de nouveau</translation>
    </message>
</context>
<context>
    <name>SiteStreamText</name>
    <message>
        <source>this kind of stream is not known</source>
        <translation>ce genre de flux n’est pas connu</translation>
    </message>
</context>
<context>
    <name>Slurm</name>
    <message>
        <source>the program %1 of Slurm is not there</source>
        <translation>le programme %1 de Slurm n’est pas là</translation>
    </message>
    <message>
        <source>the package slurm-client, or a login node of the cluster</source>
        <translation>le paquet slurm-client, ou un nœud de connexion de la grappe</translation>
    </message>
    <message>
        <source>%1 does not answer</source>
        <translation>%1 ne répond pas</translation>
    </message>
    <message>
        <source>%1 refuses: %2</source>
        <translation>%1 refuse&#xa0;: %2</translation>
    </message>
</context>
<context>
    <name>SoundBracelet</name>
    <message>
        <source>The sound card requests no samples.</source>
        <translation>La carte son ne demande pas d’échantillons.</translation>
    </message>
    <message>
        <source>There is no JACK library: %1</source>
        <translation>Il n’y a pas de bibliothèque JACK&#xa0;: %1</translation>
    </message>
    <message>
        <source>the package pipewire-jack, or libjack-jackd2-0</source>
        <translation>le paquet pipewire-jack ou libjack-jackd2-0</translation>
    </message>
</context>
<context>
    <name>SoundFaultText</name>
    <message>
        <source>Samples came too late while a tactor was driven.</source>
        <translation>Des échantillons sont arrivés trop tard pendant qu’un actionneur vibrait.</translation>
    </message>
    <message>
        <source>The sound server stopped.</source>
        <translation>Le serveur de son s’est arrêté.</translation>
    </message>
    <message>
        <source>The sound card is gone.</source>
        <translation>La carte son a disparu.</translation>
    </message>
    <message>
        <source>The sound server changed its sample rate.</source>
        <translation>Le serveur de son a changé sa fréquence d’échantillonnage.</translation>
    </message>
    <message>
        <source>The sound server changed its period.</source>
        <translation>Le serveur de son a changé sa période.</translation>
    </message>
    <message>
        <source>A tactor was disconnected from its output.</source>
        <translation>Un actionneur a été déconnecté de sa sortie.</translation>
    </message>
    <message>
        <source>Another program began to play on the sound card.</source>
        <translation>Un autre programme s’est mis à jouer sur la carte son.</translation>
    </message>
    <message>
        <source>The sound server stopped requesting samples.</source>
        <translation>Le serveur de son ne demande plus d’échantillons.</translation>
    </message>
</context>
<context>
    <name>SoundFileText</name>
    <message>
        <source>&quot;%1&quot; names no sound card</source>
        <translation>« %1&#xa0;» ne désigne pas de carte son</translation>
    </message>
    <message>
        <source>pipewire, pipewire:NODE, jack, jack:CLIENT or alsa:PCM</source>
        <translation>pipewire, pipewire:NODE, jack, jack:CLIENT ou alsa:PCM</translation>
    </message>
    <message>
        <source>no such sample rate: %1</source>
        <translation>fréquence d’échantillonnage inconnue&#xa0;: %1</translation>
    </message>
    <message>
        <source>one of: %1</source>
        <translation>l’un de&#xa0;: %1</translation>
    </message>
    <message>
        <source>%1 is no power of two</source>
        <translation>%1 n’est pas une puissance de deux</translation>
    </message>
    <message>
        <source>16, 32, 64, 128, 256, 512, 1024 or 2048</source>
        <translation>16, 32, 64, 128, 256, 512, 1024 ou 2048</translation>
    </message>
    <message>
        <source>each tactor needs an output of its own</source>
        <translation>chaque actionneur demande sa propre sortie</translation>
    </message>
    <message>
        <source>six different whole numbers</source>
        <translation>six nombres entiers différents</translation>
    </message>
    <message>
        <source>%1 carriers for six tactors</source>
        <translation>%1 porteuses pour six actionneurs</translation>
    </message>
    <message>
        <source>one number, or a list of six</source>
        <translation>un nombre, ou une liste de six</translation>
    </message>
    <message>
        <source>the frequency is not clear</source>
        <translation>la fréquence n’est pas claire</translation>
    </message>
    <message>
        <source>either carrier_Hz or level_Hz</source>
        <translation>soit carrier_Hz, soit level_Hz</translation>
    </message>
    <message>
        <source>the levels do not rise</source>
        <translation>les niveaux ne sont pas croissants</translation>
    </message>
    <message>
        <source>five frequencies, the lowest first</source>
        <translation>cinq fréquences, la plus basse d’abord</translation>
    </message>
    <message>
        <source>the ramp is too short for the frequency: it would click</source>
        <translation>la rampe est trop courte pour la fréquence&#xa0;: elle claquerait</translation>
    </message>
    <message>
        <source>at least %1 ms</source>
        <translation>au moins %1 ms</translation>
    </message>
</context>
<context>
    <name>SourceText</name>
    <message>
        <source>these are data of different modes: %1 and %2</source>
        <translation>ces données sont de modes différents&#xa0;: %1 et %2</translation>
    </message>
    <message>
        <source>%1 cannot be &quot;%2&quot;</source>
        <translation>%1 ne peut pas être «&#xa0;%2&#xa0;»</translation>
    </message>
    <message>
        <source>run, pilot or simulated</source>
        <translation>run, pilot ou simulated</translation>
    </message>
    <message>
        <source>a value</source>
        <translation>une valeur</translation>
    </message>
    <message>
        <source>practice or test</source>
        <translation>practice ou test</translation>
    </message>
    <message>
        <source>correct, incorrect, timeout, aborted or device_error</source>
        <translation>correct, incorrect, timeout, aborted ou device_error</translation>
    </message>
    <message>
        <source>a number of seconds or NA</source>
        <translation>un nombre de secondes ou NA</translation>
    </message>
    <message>
        <source>%1 at most</source>
        <translation>%1 au plus</translation>
    </message>
    <message>
        <source>each trial once</source>
        <translation>chaque essai une seule fois</translation>
    </message>
    <message>
        <source>interrupted</source>
        <translation>interrompu</translation>
    </message>
    <message>
        <source>there are too many different patterns</source>
        <translation>il y a trop de motifs différents</translation>
    </message>
    <message>
        <source>one mode, or the choice of one</source>
        <translation>un seul mode, ou l’indication de celui qui compte</translation>
    </message>
    <message>
        <source>%1 also has trials in %2: these may be two people, or the same trials twice</source>
        <translation>%1 a aussi des essais dans %2&#xa0;: ce sont peut-être deux personnes, ou deux fois les mêmes essais</translation>
    </message>
    <message>
        <source>each participant in one study only, under a unique name</source>
        <translation>chaque participant dans une seule étude, sous un nom qui lui est propre</translation>
    </message>
    <message>
        <source>the value implied by stimulus and response</source>
        <translation>ce que disent stimulus et response</translation>
    </message>
    <message>
        <source>a whole number of at least 1</source>
        <translation>un nombre entier à partir de 1</translation>
    </message>
    <message>
        <source>trial %1 of session %2 of %3 was already counted</source>
        <translation>l’essai %1 de la session %2 de %3 a déjà été compté</translation>
    </message>
    <message>
        <source>this text is not UTF-8</source>
        <translation>ce texte n’est pas en UTF-8</translation>
    </message>
    <message>
        <source>a file that was saved as UTF-8</source>
        <translation>un fichier enregistré en UTF-8</translation>
    </message>
    <message>
        <source>a whole number</source>
        <translation>un nombre entier</translation>
    </message>
    <message>
        <source>the columns are separated by semicolons</source>
        <translation>les colonnes sont séparées par des points-virgules</translation>
    </message>
    <message>
        <source>the columns are separated by tabs</source>
        <translation>les colonnes sont séparées par des tabulations</translation>
    </message>
    <message>
        <source>commas, and a point in numbers: the trials that are in data/ of the study, or the file saved as CSV with commas</source>
        <translation>des virgules, et un point dans les nombres&#xa0;: les essais qui sont dans data/ de l’étude, ou le fichier enregistré en CSV avec des virgules</translation>
    </message>
    <message>
        <source>the sensor file names no camera and no video</source>
        <translation>le fichier du capteur n’indique ni caméra ni vidéo</translation>
    </message>
    <message>
        <source>a key &quot;source&quot;</source>
        <translation>une clé «&#xa0;source&#xa0;»</translation>
    </message>
</context>
<context>
    <name>SpectrumText</name>
    <message>
        <source>The signal has no rate: its samples come when they please.</source>
        <translation>Le signal n’a pas de cadence&#xa0;: ses échantillons arrivent à des instants quelconques.</translation>
    </message>
    <message>
        <source>There are only %1 samples in a row in view; a spectrum needs %2.</source>
        <translation>Seuls %1 échantillons sans interruption sont visibles&#xa0;; un spectre en demande %2.</translation>
    </message>
</context>
<context>
    <name>StandardStreamText</name>
    <message>
        <source>standard input cannot be read</source>
        <translation>l’entrée standard ne peut pas être lue</translation>
    </message>
    <message>
        <source>standard input is too large</source>
        <translation>l’entrée standard est trop volumineuse</translation>
    </message>
    <message>
        <source>standard input can be read only once</source>
        <translation>l’entrée standard ne peut être lue qu’une fois</translation>
    </message>
    <message>
        <source>standard output can be written only once</source>
        <translation>la sortie standard ne peut être écrite qu’une fois</translation>
    </message>
    <message>
        <source>- is given, a folder is expected</source>
        <translation>- est donné, un dossier est attendu</translation>
    </message>
    <message>
        <source>a recording is a database, which is no stream</source>
        <translation>un enregistrement est une base de données, et non un flux</translation>
    </message>
    <message>
        <source>a video cannot be read from standard input</source>
        <translation>une vidéo ne peut pas être lue sur l’entrée standard</translation>
    </message>
    <message>
        <source>the document and a file would both go to standard output</source>
        <translation>le document et un fichier iraient tous deux sur la sortie standard</translation>
    </message>
    <message>
        <source>an npz file is an archive, which is no stream</source>
        <translation>un fichier npz est une archive, et non un flux</translation>
    </message>
</context>
<context>
    <name>StiffnessText</name>
    <message>
        <source>the log has no samples</source>
        <translation>le journal n’a pas d’échantillons</translation>
    </message>
    <message>
        <source>a row for each sample of the touch</source>
        <translation>une ligne par échantillon du toucher</translation>
    </message>
    <message>
        <source>one half of the torque window has no sample; the largest torque is %1 Nm</source>
        <translation>une moitié de la fenêtre de couple n’a pas d’échantillon&#xa0;; le plus grand couple est %1 Nm</translation>
    </message>
    <message>
        <source>samples near %1 Nm and near %2 Nm</source>
        <translation>des échantillons près de %1 Nm et de %2 Nm</translation>
    </message>
    <message>
        <source>no sample reaches the torque window; the largest torque is %1 Nm</source>
        <translation>aucun échantillon n’atteint la fenêtre de couple&#xa0;; le plus grand couple est %1 Nm</translation>
    </message>
    <message>
        <source>torques from %1 to %2 Nm</source>
        <translation>des couples de %1 à %2 Nm</translation>
    </message>
    <message>
        <source>fewer than 20 independent samples lie in the torque window</source>
        <translation>moins de 20 échantillons indépendants se trouvent dans la fenêtre de couple</translation>
    </message>
    <message>
        <source>a slower touch or quicker sampling from %1 to %2 Nm; --method two-point needs two samples</source>
        <translation>un toucher plus lent ou un échantillonnage plus rapide de %1 à %2 Nm&#xa0;; --method two-point demande deux échantillons</translation>
    </message>
    <message>
        <source>the torque does not change within the window</source>
        <translation>le couple ne change pas dans la fenêtre</translation>
    </message>
    <message>
        <source>torque that rises from %1 to %2 Nm</source>
        <translation>un couple qui monte de %1 à %2 Nm</translation>
    </message>
    <message>
        <source>the joint turns against the rising torque</source>
        <translation>l’articulation tourne contre le couple croissant</translation>
    </message>
    <message>
        <source>angle and torque that rise together; the sign of one column may be turned</source>
        <translation>un angle et un couple qui montent ensemble&#xa0;; le signe d’une colonne peut être inversé</translation>
    </message>
    <message>
        <source>the torque rises so quickly that the arm&apos;s inertia is part of it</source>
        <translation>le couple monte si vite que l’inertie du bras y prend part</translation>
    </message>
    <message>
        <source>a slower touch</source>
        <translation>un toucher plus lent</translation>
    </message>
    <message>
        <source>the numbers are too large or too small to compute with</source>
        <translation>les nombres sont trop grands ou trop petits pour le calcul</translation>
    </message>
    <message>
        <source>SI units</source>
        <translation>des unités SI</translation>
    </message>
    <message>
        <source>sponge</source>
        <translation>éponge</translation>
    </message>
    <message>
        <source>rubber sponge</source>
        <translation>caoutchouc mousse</translation>
    </message>
    <message>
        <source>rubber</source>
        <translation>caoutchouc</translation>
    </message>
    <message>
        <source>wood</source>
        <translation>bois</translation>
    </message>
    <message>
        <source>metal</source>
        <translation>métal</translation>
    </message>
    <message>
        <source>at least %1 N/m (95 %)</source>
        <translation>au moins %1 N/m (95&#xa0;%)</translation>
    </message>
    <message>
        <source>%1 N/m (uncertainty not available)</source>
        <translation>%1 N/m (incertitude non disponible)</translation>
    </message>
    <message>
        <source>%1 N/m (95 %: %2 to %3)</source>
        <translation>%1 N/m (95&#xa0;%&#xa0;: %2 à %3)</translation>
    </message>
    <message>
        <source>the noise of neighbouring samples is not independent</source>
        <translation>le bruit d’échantillons voisins n’est pas indépendant</translation>
    </message>
    <message>
        <source>one step of the torque reading is over a tenth of the window</source>
        <translation>un pas de la lecture du couple dépasse un dixième de la fenêtre</translation>
    </message>
    <message>
        <source>one step of the angle reading is over a tenth of the rotation</source>
        <translation>un pas de la lecture de l’angle dépasse un dixième de la rotation</translation>
    </message>
    <message>
        <source>the free joint has a torque; it was taken off</source>
        <translation>l’articulation libre a un couple&#xa0;; il a été retranché</translation>
    </message>
    <message>
        <source>the torque of the free joint changes; the change was taken off</source>
        <translation>le couple de l’articulation libre change&#xa0;; ce changement a été retranché</translation>
    </message>
    <message>
        <source>the stiffness changes within the window</source>
        <translation>la raideur change dans la fenêtre</translation>
    </message>
    <message>
        <source>the force depends on how quickly the object is pressed</source>
        <translation>la force dépend de la vitesse à laquelle on presse l’objet</translation>
    </message>
    <message>
        <source>the torque jumps, or the joint has play</source>
        <translation>le couple saute, ou l’articulation a du jeu</translation>
    </message>
    <message>
        <source>the free joint has another torque than --torque-reference says</source>
        <translation>l’articulation libre a un autre couple que celui de --torque-reference</translation>
    </message>
    <message>
        <source>cannot tell</source>
        <translation>indéterminé</translation>
    </message>
    <message>
        <source>%1, safe to touch, level %2 of 5</source>
        <translation>%1, toucher sans danger, niveau %2 sur 5</translation>
    </message>
    <message>
        <source>%1, danger, level %2 of 5</source>
        <translation>%1, danger, niveau %2 sur 5</translation>
    </message>
    <message>
        <source>two-point</source>
        <translation>deux points</translation>
    </message>
    <message>
        <source>regression</source>
        <translation>régression</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Méthode</translation>
    </message>
    <message>
        <source>Samples</source>
        <translation>Échantillons</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>Rotation</translation>
    </message>
    <message>
        <source>%1 rad</source>
        <translation>%1 rad</translation>
    </message>
    <message>
        <source>Torque rise</source>
        <translation>Hausse du couple</translation>
    </message>
    <message>
        <source>%1 Nm</source>
        <translation>%1 Nm</translation>
    </message>
    <message>
        <source>Total stiffness</source>
        <translation>Raideur totale</translation>
    </message>
    <message>
        <source>Object stiffness</source>
        <translation>Raideur de l’objet</translation>
    </message>
    <message>
        <source>Secant, tangent</source>
        <translation>Sécante, tangente</translation>
    </message>
    <message>
        <source>%1 N/m, %2 N/m at the upper end</source>
        <translation>%1 N/m, %2 N/m à l’extrémité supérieure</translation>
    </message>
    <message>
        <source>Static stiffness</source>
        <translation>Raideur statique</translation>
    </message>
    <message>
        <source>Quick over static</source>
        <translation>Rapide sur statique</translation>
    </message>
    <message>
        <source>1 + %1 (95 %: %2 to %3)</source>
        <translation>1 + %1 (95&#xa0;%&#xa0;: %2 à %3)</translation>
    </message>
    <message>
        <source>Relaxation</source>
        <translation>Relaxation</translation>
    </message>
    <message>
        <source>%1 s (95 %: %2 to %3)</source>
        <translation>%1 s (95&#xa0;%&#xa0;: %2 à %3)</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>Matériau</translation>
    </message>
    <message>
        <source>Reliable</source>
        <translation>Fiable</translation>
    </message>
    <message>
        <source>no</source>
        <translation>non</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>Avertissement</translation>
    </message>
    <message>
        <source>CSV with the columns time_s,joint_angle_rad,joint_torque_nm</source>
        <translation>CSV avec les colonnes time_s,joint_angle_rad,joint_torque_nm</translation>
    </message>
    <message>
        <source>Distance of the contact from the joint&apos;s axis along the link, m</source>
        <translation>Distance du contact à l’axe de l’articulation le long du segment, m</translation>
    </message>
    <message>
        <source>Standard error of the contact distance, m; it enters twice. Default: 0.05 % of the distance</source>
        <translation>Erreur type de la distance de contact, en m&#xa0;; elle compte deux fois. Par défaut&#xa0;: 0.05&#xa0;% de la distance</translation>
    </message>
    <message>
        <source>Half the thickness of the link, m; it cancels out of the stiffness</source>
        <translation>Demi-épaisseur du segment, m&#xa0;; elle s’élimine de la raideur</translation>
    </message>
    <message>
        <source>The link&apos;s own stiffness, N/m</source>
        <translation>Raideur propre du segment, N/m</translation>
    </message>
    <message>
        <source>Standard error of that stiffness, N/m</source>
        <translation>Erreur type de cette raideur, en N/m</translation>
    </message>
    <message>
        <source>Torque of the joint without the touch, Nm; start: that of the free motion before the touch, or 0 when there is none</source>
        <translation>Couple de l’articulation sans le toucher, en Nm&#xa0;; start&#xa0;: celui du mouvement libre avant le toucher, ou 0 s’il n’y en a pas</translation>
    </message>
    <message>
        <source>two-point: the samples nearest to both borders of the window; regression: all samples in it</source>
        <translation>two-point&#xa0;: les échantillons les plus proches des deux bornes de la fenêtre&#xa0;; regression&#xa0;: tous ses échantillons</translation>
    </message>
    <message>
        <source>Torques between which the touch is evaluated, Nm</source>
        <translation>Couples entre lesquels le toucher est évalué, Nm</translation>
    </message>
    <message>
        <source>0 or more is expected</source>
        <translation>0 ou plus est attendu</translation>
    </message>
    <message>
        <source>a lower border of 0 or more and a higher upper one are expected</source>
        <translation>une borne inférieure de 0 ou plus et une borne supérieure plus grande sont attendues</translation>
    </message>
    <message>
        <source>a torque in Nm or start is expected</source>
        <translation>attendu&#xa0;: un couple en Nm ou start</translation>
    </message>
    <message>
        <source>the touch is stiffer than the link allows: check contact distance and link stiffness</source>
        <translation>le toucher est plus raide que le segment ne le permet&#xa0;: vérifiez la distance du contact et la raideur du segment</translation>
    </message>
    <message>
        <source>Stiffness and material of an object from joint angle and torque during a touch</source>
        <translation>Raideur et matériau d’un objet d’après l’angle et le couple articulaires pendant un toucher</translation>
    </message>
</context>
<context>
    <name>StimulusText</name>
    <message>
        <source>STOP was pressed</source>
        <translation>STOP a été enclenché</translation>
    </message>
    <message>
        <source>the bracelet was lost</source>
        <translation>le bracelet a été perdu</translation>
    </message>
    <message>
        <source>the pattern could not be played: %1</source>
        <translation>le motif n’a pas pu être joué&#xa0;: %1</translation>
    </message>
    <message>
        <source>something else stopped the bracelet</source>
        <translation>autre chose a arrêté le bracelet</translation>
    </message>
    <message>
        <source>the bracelet is too hot</source>
        <translation>le bracelet est trop chaud</translation>
    </message>
    <message>
        <source>%1, ready</source>
        <comment>bracelet</comment>
        <translation>%1, prêt</translation>
    </message>
    <message>
        <source>%1, ready; last stimulus: %2 frames, longest write %3 ms, %4 late, %5 lost</source>
        <comment>bracelet</comment>
        <translation>%1, prêt&#xa0;; dernier stimulus&#xa0;: %2 trames, écriture la plus longue %3 ms, %4 en retard, %5 perdues</translation>
    </message>
    <message>
        <source>the bracelet does not answer</source>
        <translation>le bracelet ne répond pas</translation>
    </message>
    <message>
        <source>something else used the bracelet</source>
        <translation>autre chose a utilisé le bracelet</translation>
    </message>
    <message>
        <source>playback stalled for too long</source>
        <translation>la lecture s’est interrompue trop longtemps</translation>
    </message>
    <message>
        <source>the bracelet did not start</source>
        <translation>le bracelet n’a pas commencé</translation>
    </message>
    <message>
        <source>the bracelet rejected the stimulus</source>
        <translation>le bracelet a refusé le stimulus&#xa0;: il ne l’a pas compris</translation>
    </message>
    <message>
        <source>the bracelet did not confirm the stimulus</source>
        <translation>le bracelet n’a pas confirmé avoir reçu le stimulus</translation>
    </message>
    <message>
        <source>No bracelet: this rehearsal is too fast to be played</source>
        <translation>Pas de bracelet&#xa0;: cette répétition générale est trop rapide pour être jouée</translation>
    </message>
    <message>
        <source>the folder of this pattern is unknown</source>
        <translation>on ne peut pas savoir dans quel dossier est ce motif</translation>
    </message>
    <message>
        <source>the full path of the file</source>
        <translation>le chemin complet du fichier</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be moved to other tactors</source>
        <translation>«&#xa0;%1&#xa0;» ne peut pas être déplacé vers d’autres tacteurs</translation>
    </message>
    <message>
        <source>a stimulus without rings and strokes, or a track without tactors</source>
        <translation>un stimulus sans anneaux ni tracés, ou une piste sans tacteurs</translation>
    </message>
    <message>
        <source>the stimulus does not use tactor %1</source>
        <translation>le stimulus n’utilise pas le tacteur %1</translation>
    </message>
    <message>
        <source>a stimulus of one tactor, or of as many as the track names</source>
        <translation>un stimulus à un seul tacteur, ou à autant de tacteurs que la piste en nomme</translation>
    </message>
    <message numerus="yes">
        <source>%n object(s) of the stimulus have %1</source>
        <translation>
            <numerusform>%n objet du stimulus a %1</numerusform>
            <numerusform>%n objets du stimulus ont %1</numerusform>
        </translation>
    </message>
    <message>
        <source>exactly one</source>
        <translation>exactement un</translation>
    </message>
    <message>
        <source>the stimulus takes %1 s at level %2</source>
        <translation>le stimulus dure %1 s au niveau %2</translation>
    </message>
    <message>
        <source>at most stimulus_s, %1 s</source>
        <translation>au plus stimulus_s, %1 s</translation>
    </message>
</context>
<context>
    <name>StoreText</name>
    <message>
        <source>%1, process %2</source>
        <translation>%1, processus %2</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot name a participant</source>
        <translation>«&#xa0;%1&#xa0;» ne peut pas désigner un participant</translation>
    </message>
    <message>
        <source>another name</source>
        <translation>un autre nom</translation>
    </message>
    <message>
        <source>to try again</source>
        <translation>une nouvelle tentative</translation>
    </message>
    <message>
        <source>one session of a participant at a time</source>
        <translation>une seule session à la fois par participant</translation>
    </message>
    <message>
        <source>another station</source>
        <translation>un autre poste</translation>
    </message>
    <message>
        <source>version %1 of the program, or a new study</source>
        <translation>la version %1 du programme, ou une nouvelle étude</translation>
    </message>
    <message>
        <source>a study of this name already exists</source>
        <translation>il y a déjà une étude de ce nom</translation>
    </message>
    <message>
        <source>a new name, or to continue the study</source>
        <translation>un nouveau nom, ou la reprise de l’étude</translation>
    </message>
    <message>
        <source>this folder already contains a study</source>
        <translation>il y a déjà une étude dans ce dossier</translation>
    </message>
    <message>
        <source>a new folder, or to continue the study</source>
        <translation>un nouveau dossier, ou la reprise de l’étude</translation>
    </message>
    <message>
        <source>the study was not created completely</source>
        <translation>la création de l’étude n’a jamais été achevée</translation>
    </message>
    <message>
        <source>another name: in files, %1 means no value or all participants</source>
        <translation>un autre nom&#xa0;: les fichiers ont %1 pour aucune valeur ou pour tous les participants</translation>
    </message>
    <message>
        <source>the participant &quot;%1&quot; is already enrolled</source>
        <translation>le participant «&#xa0;%1&#xa0;» est déjà inscrit</translation>
    </message>
    <message>
        <source>other stations keep enrolling participants</source>
        <translation>d’autres postes inscrivent sans cesse des participants</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is already in a session at %2</source>
        <translation>«&#xa0;%1&#xa0;» est déjà en session, sur %2</translation>
    </message>
    <message>
        <source>the patterns have changed since this study was created</source>
        <translation>les motifs ne sont pas ceux avec lesquels cette étude a été commencée</translation>
    </message>
    <message>
        <source>a text of 1 to %1 characters that does not begin with = + - or @</source>
        <translation>un texte de 1 à&#xa0;%1 caractères qui ne commence pas par = + - ou @</translation>
    </message>
</context>
<context>
    <name>StripTexts</name>
    <message>
        <source>Force</source>
        <translation>Force</translation>
    </message>
    <message>
        <source>Position x</source>
        <translation>Position x</translation>
    </message>
    <message>
        <source>Position y</source>
        <translation>Position y</translation>
    </message>
    <message>
        <source>DZMP</source>
        <comment>deviation of the zero moment point: centre of pressure minus centre of contact</comment>
        <translation>DZMP</translation>
    </message>
    <message>
        <source>Orientation</source>
        <translation>Orientation</translation>
    </message>
    <message>
        <source>Spread</source>
        <comment>standard deviations of the touched area along its principal axes</comment>
        <translation>Étendue</translation>
    </message>
    <message>
        <source>Edge ratio</source>
        <comment>ratio of the eigenvalues of the touched area</comment>
        <translation>Rapport d’arête</translation>
    </message>
    <message>
        <source>Active taxels</source>
        <translation>Taxels actifs</translation>
    </message>
    <message>
        <source>force</source>
        <translation>force</translation>
    </message>
    <message>
        <source>threshold</source>
        <comment>of one taxel</comment>
        <translation>seuil</translation>
    </message>
    <message>
        <source>CoP</source>
        <comment>centre of pressure</comment>
        <translation>CoP</translation>
    </message>
    <message>
        <source>CoC</source>
        <comment>centre of contact</comment>
        <translation>CoC</translation>
    </message>
    <message>
        <source>active</source>
        <translation>actifs</translation>
    </message>
</context>
<context>
    <name>StudyChecks</name>
    <message>
        <source>Protocol</source>
        <translation>Protocole</translation>
    </message>
    <message>
        <source>no protocol is open</source>
        <translation>aucun protocole n’est ouvert</translation>
    </message>
    <message>
        <source>the protocol has no trials</source>
        <translation>le protocole n’a pas d’essais</translation>
    </message>
    <message>
        <source>Give practice or test at least one repetition.</source>
        <translation>Donnez au moins une répétition à l’entraînement ou au test.</translation>
    </message>
    <message>
        <source>Participant</source>
        <translation>Participant</translation>
    </message>
    <message>
        <source>Choose a participant, or add a new one.</source>
        <translation>Choisissez un participant, ou ajoutez-en un.</translation>
    </message>
    <message>
        <source>Finish or abort the other session, or choose another participant.</source>
        <translation>Terminez ou abandonnez l’autre session, ou choisissez un autre participant.</translation>
    </message>
    <message>
        <source>%1 has finished this session</source>
        <translation>%1 a terminé cette session</translation>
    </message>
    <message>
        <source>Choose the next session or another participant.</source>
        <translation>Choisissez la session suivante ou un autre participant.</translation>
    </message>
    <message>
        <source>Bracelet</source>
        <translation>Bracelet</translation>
    </message>
    <message>
        <source>the bracelet</source>
        <translation>le bracelet</translation>
    </message>
    <message>
        <source>no bracelet is open</source>
        <translation>aucun bracelet n’est ouvert</translation>
    </message>
    <message>
        <source>Plug the bracelet in and choose it in the menu Bracelet.</source>
        <translation>Branchez le bracelet et choisissez-le dans le menu Bracelet.</translation>
    </message>
    <message>
        <source>%1 does not answer</source>
        <translation>%1 ne répond pas</translation>
    </message>
    <message>
        <source>STOP is engaged</source>
        <translation>STOP est enclenché</translation>
    </message>
    <message>
        <source>Release STOP when it is safe.</source>
        <translation>Relâchez STOP quand il n’y a plus de danger.</translation>
    </message>
    <message>
        <source>%1 is simulated: nobody can feel it</source>
        <translation>%1 est simulé&#xa0;: personne ne peut le sentir</translation>
    </message>
    <message>
        <source>Choose a real bracelet, or a pilot or simulated study.</source>
        <translation>Choisissez un vrai bracelet, ou une étude pilote ou simulée.</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>Dossier</translation>
    </message>
    <message>
        <source>Connect the drive of the study, or choose another folder.</source>
        <translation>Connectez le disque de l’étude, ou choisissez un autre dossier.</translation>
    </message>
    <message>
        <source>Allow writing to the folder, or choose another one.</source>
        <translation>Autorisez l’écriture dans le dossier, ou choisissez-en un autre.</translation>
    </message>
    <message>
        <source>Disk space</source>
        <translation>Espace disque</translation>
    </message>
    <message>
        <source>%1 MB are free</source>
        <translation>%1 MB sont libres</translation>
    </message>
    <message>
        <source>Data store</source>
        <translation>Stockage des données</translation>
    </message>
    <message>
        <source>ready</source>
        <translation>prêt</translation>
    </message>
    <message>
        <source>Make a copy of the study&apos;s folder and open the study again.</source>
        <translation>Faites une copie du dossier de l’étude et rouvrez l’étude.</translation>
    </message>
    <message>
        <source>Masking noise</source>
        <translation>Bruit de masquage</translation>
    </message>
    <message>
        <source>not needed: simulated participants hear nothing</source>
        <translation>inutile&#xa0;: les participants simulés n’entendent rien</translation>
    </message>
    <message>
        <source>the protocol has none</source>
        <translation>le protocole n’en a pas</translation>
    </message>
    <message>
        <source>the noise is not confirmed</source>
        <translation>le bruit n’est pas confirmé</translation>
    </message>
    <message>
        <source>Play the noise, measure its level at the ear, and confirm.</source>
        <translation>Jouez le bruit, mesurez son niveau à l’oreille et confirmez.</translation>
    </message>
    <message>
        <source>Play the noise, measure %1 dBA at the participant&apos;s ear, and confirm.</source>
        <translation>Jouez le bruit, mesurez %1 dBA à l’oreille du participant et confirmez.</translation>
    </message>
    <message>
        <source>confirmed</source>
        <translation>confirmé</translation>
    </message>
    <message>
        <source>Stimuli</source>
        <translation>Stimuli</translation>
    </message>
    <message>
        <source>Correct the protocol at this place and open it again.</source>
        <translation>Corrigez le protocole à cet endroit et rouvrez-le.</translation>
    </message>
    <message>
        <source>Open a protocol, or start with the paper&apos;s.</source>
        <translation>Ouvrez un protocole, ou commencez par celui de l’article.</translation>
    </message>
    <message>
        <source>there are no tactile patterns for %1</source>
        <translation>il n’y a pas de motifs %1</translation>
    </message>
    <message>
        <source>Create a study whose protocol names a file for each pattern that is not built in.</source>
        <translation>Créez une étude dont le protocole nomme un fichier pour chaque motif qui n’est pas fourni avec le programme.</translation>
    </message>
    <message>
        <source>the patterns have changed since this study was created</source>
        <translation>les motifs ne sont pas ceux avec lesquels cette étude a été commencée</translation>
    </message>
    <message>
        <source>Use version %1 of the program, which created it, or create a new study.</source>
        <translation>Continuez avec la version %1 du programme, qui l’a commencée, ou commencez une nouvelle étude.</translation>
    </message>
    <message>
        <source>unchanged since the study was created</source>
        <translation>ceux avec lesquels l’étude a été commencée</translation>
    </message>
    <message>
        <source>all there; whether they have changed since the study was created is unknown</source>
        <translation>tous présents&#xa0;; on ne sait pas si l’étude a été commencée avec d’autres</translation>
    </message>
    <message>
        <source>no participant is selected</source>
        <translation>aucun participant n’est choisi</translation>
    </message>
    <message>
        <source>%1 is already in a session</source>
        <translation>%1 est déjà en session</translation>
    </message>
    <message>
        <source>%1 is already in a session at %2</source>
        <translation>%1 est déjà en session, sur %2</translation>
    </message>
    <message>
        <source>Check cable and power supply; it reconnects by itself.</source>
        <translation>Vérifiez le câble et l’alimentation&#xa0;; la suite est automatique à son retour.</translation>
    </message>
    <message>
        <source>%1 was not found</source>
        <translation>%1 n’est pas là</translation>
    </message>
    <message>
        <source>cannot write to %1: %2</source>
        <translation>impossible d’écrire dans %1&#xa0;: %2</translation>
    </message>
    <message>
        <source>Free up space to at least %1 MB, or choose another folder.</source>
        <translation>Libérez de l’espace jusqu’à %1 MB, ou choisissez un autre dossier.</translation>
    </message>
    <message>
        <source>Start the server or repair the network connection, then try again.</source>
        <translation>Démarrez le serveur ou rétablissez le réseau, puis réessayez.</translation>
    </message>
    <message>
        <source>a motor takes %1 s to stop, and the gap between the intervals of %2 is %3 s</source>
        <translation>un moteur met %1 s à s’arrêter, et la pause entre les intervalles de %2 est de %3 s</translation>
    </message>
    <message>
        <source>Create a study with a longer gap (gap_s).</source>
        <translation>Créez une étude avec une pause plus longue (gap_s).</translation>
    </message>
    <message>
        <source>the line is being opened</source>
        <translation>la ligne est en cours d’ouverture</translation>
    </message>
    <message>
        <source>Wait a moment.</source>
        <translation>Attendez un instant.</translation>
    </message>
    <message>
        <source>the line cannot be used</source>
        <translation>la ligne est inutilisable</translation>
    </message>
    <message>
        <source>Plug the device in and switch it on; it is tried again every second.</source>
        <translation>Branchez l’appareil et allumez-le&#xa0;; une nouvelle tentative est faite chaque seconde.</translation>
    </message>
    <message>
        <source>Trigger</source>
        <translation>Déclencheur</translation>
    </message>
    <message>
        <source>the desktop keeps it on</source>
        <translation>le bureau le garde allumé</translation>
    </message>
    <message>
        <source>the desktop may turn it off during the session</source>
        <translation>le bureau peut l’éteindre pendant la session</translation>
    </message>
    <message>
        <source>Turn off the screen saver and energy saving of the desktop for the session.</source>
        <translation>Désactivez l’économiseur d’écran et les économies d’énergie du bureau pour la session.</translation>
    </message>
    <message>
        <source>Screen</source>
        <translation>Écran</translation>
    </message>
</context>
<context>
    <name>StudyCommand</name>
    <message>
        <source>%1 % correct (95 %: %2 to %3, %4 participants)</source>
        <translation>%1&#xa0;% de réponses correctes (95&#xa0;%&#xa0;: %2 à %3, %4 participants)</translation>
    </message>
    <message>
        <source>%1 % correct (one participant)</source>
        <translation>%1&#xa0;% de réponses correctes (un participant)</translation>
    </message>
    <message>
        <source>F(%1, %2) = %3, p = %4</source>
        <translation>F(%1, %2) = %3, p = %4</translation>
    </message>
    <message>
        <source>Rehearse a user study with simulated participants, and analyse studies</source>
        <translation>Répéter une étude utilisateur avec des participants simulés, et analyser des études</translation>
    </message>
    <message>
        <source>Run simulated participants through a whole study</source>
        <translation>Faire parcourir toute une étude à des participants simulés</translation>
    </message>
    <message>
        <source>Seed of all orders and answers</source>
        <translation>Graine de tous les ordres et de toutes les réponses</translation>
    </message>
    <message>
        <source>Share of the trials in which nothing is answered</source>
        <translation>Part des essais restés sans réponse</translation>
    </message>
    <message>
        <source>Folder of the new study</source>
        <translation>Dossier de la nouvelle étude</translation>
    </message>
    <message>
        <source>Go on with a rehearsal that was interrupted</source>
        <translation>Reprendre une répétition générale interrompue</translation>
    </message>
    <message>
        <source>Folder of the study</source>
        <translation>Dossier de l’étude</translation>
    </message>
    <message>
        <source>Confusion matrices, accuracy, information transfer and ANOVA of studies or trial CSVs</source>
        <translation>Matrices de confusion, exactitude, transfert d’information et ANOVA d’études ou de CSV d’essais</translation>
    </message>
    <message>
        <source>Folders of studies, or CSVs with participant_id,task,condition,phase,stimulus,response</source>
        <translation>Dossiers d’études, ou CSV avec participant_id,task,condition,phase,stimulus,response</translation>
    </message>
    <message>
        <source>Only data of this mode; different modes are not merged</source>
        <translation>Seulement les données de ce mode&#xa0;; des modes différents ne sont pas réunis</translation>
    </message>
    <message>
        <source>Write the trials of a study as files into its folder</source>
        <translation>Écrire les essais d’une étude en fichiers dans son dossier</translation>
    </message>
    <message>
        <source>psychds: data/; bids: bids/; excel: excel/, with semicolons and the decimal sign of the locale</source>
        <translation>psychds&#xa0;: data/&#xa0;; bids&#xa0;: bids/&#xa0;; excel&#xa0;: excel/, avec des points-virgules et le séparateur décimal local</translation>
    </message>
    <message>
        <source>Study</source>
        <translation>Étude</translation>
    </message>
    <message>
        <source>Protocol</source>
        <translation>Protocole</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Graine</translation>
    </message>
    <message>
        <source>Simulated participants</source>
        <translation>Participants simulés</translation>
    </message>
    <message>
        <source>Trials</source>
        <translation>Essais</translation>
    </message>
    <message>
        <source>Of them kept before</source>
        <translation>Dont conservés auparavant</translation>
    </message>
    <message>
        <source>this is named twice</source>
        <translation>ceci est nommé deux fois</translation>
    </message>
    <message>
        <source>each study and each file once</source>
        <translation>chaque étude et chaque fichier une seule fois</translation>
    </message>
    <message>
        <source>there are no completed trials</source>
        <translation>il n’y a pas d’essais achevés</translation>
    </message>
    <message>
        <source>trials that were answered or timed out</source>
        <translation>des essais répondus ou hors délai</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Format</translation>
    </message>
    <message>
        <source>Sessions</source>
        <translation>Sessions</translation>
    </message>
    <message>
        <source>PostgreSQL server that has the study, postgresql://USER@HOST/DATABASE?study=NAME; the password comes from PGPASSWORD or ~/.pgpass. The folder gets the exports</source>
        <translation>Serveur PostgreSQL qui contient l’étude, postgresql://USER@HOST/DATABASE?study=NAME&#xa0;; le mot de passe vient de PGPASSWORD ou de ~/.pgpass. Le dossier reçoit les exports</translation>
    </message>
    <message>
        <source>Formats of the figures, separated by commas</source>
        <translation>Formats des figures, séparés par des virgules</translation>
    </message>
    <message>
        <source>Write pink noise that can be played in a loop</source>
        <translation>Écrire un bruit rose qui peut être joué en boucle</translation>
    </message>
    <message>
        <source>The sound file</source>
        <translation>Le fichier son</translation>
    </message>
    <message>
        <source>Root mean square against full scale, dB; how loud it is at the ear has to be measured</source>
        <translation>Valeur efficace par rapport à la pleine échelle, dB&#xa0;; le niveau à l’oreille est à mesurer</translation>
    </message>
    <message>
        <source>Seed of the noise</source>
        <translation>Graine du bruit</translation>
    </message>
    <message>
        <source>there is nothing to analyze</source>
        <translation>il n’y a rien à analyser</translation>
    </message>
    <message>
        <source>folders of studies, trial CSVs, or a server (--store)</source>
        <translation>des dossiers d’études, des CSV d’essais, ou un serveur (--store)</translation>
    </message>
    <message>
        <source>Results of the study</source>
        <translation>Résultats de l’étude</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Fichier</translation>
    </message>
    <message>
        <source>Period</source>
        <translation>Période</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>Niveau</translation>
    </message>
    <message>
        <source>%1 dBFS</source>
        <translation>%1 dBFS</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>Rapport</translation>
    </message>
    <message>
        <source>Tables and figures</source>
        <translation>Tableaux et figures</translation>
    </message>
    <message>
        <source>Number of participants</source>
        <translation>Nombre de participants</translation>
    </message>
    <message>
        <source>%1 bit measured</source>
        <translation>%1 bit mesuré</translation>
    </message>
    <message>
        <source>%1 bit without bias (95 %: %2 to %3)</source>
        <translation>%1 bit sans biais (95&#xa0;%&#xa0;: %2 à %3)</translation>
    </message>
    <message>
        <source>%1 bit without bias (95 %: at least %2)</source>
        <translation>%1 bit sans biais (95&#xa0;%&#xa0;: au moins %2)</translation>
    </message>
    <message>
        <source>%1 bit without bias (95 %: at most %2)</source>
        <translation>%1 bit sans biais (95&#xa0;%&#xa0;: au plus %2)</translation>
    </message>
    <message>
        <source>%1 of %2 trials left out</source>
        <translation>%1 essais sur %2 écartés</translation>
    </message>
    <message>
        <source>%1; rule made after the data</source>
        <translation>%1&#xa0;; règle établie après les données</translation>
    </message>
    <message>
        <source>%1; no spread of the times, so nothing was left out, in %2 case(s)</source>
        <translation>%1&#xa0;; temps sans dispersion, donc rien n’a été écarté, dans %2 cas</translation>
    </message>
    <message>
        <source>%1, Holm over the patterns %2</source>
        <comment>F and p</comment>
        <translation>%1, Holm sur les motifs %2</translation>
    </message>
    <message>
        <source>Thresholds, slopes and d&apos; of tasks with levels, by maximum likelihood</source>
        <translation>Seuils, pentes et d&apos; des tâches à niveaux, par maximum de vraisemblance</translation>
    </message>
    <message>
        <source>Write one participant&apos;s results as a page</source>
        <translation>Écrire les résultats d’un participant sous forme de page</translation>
    </message>
    <message>
        <source>What the columns of all files of studies mean</source>
        <translation>Ce que signifient les colonnes de tous les fichiers des études</translation>
    </message>
    <message>
        <source>Send one trial&apos;s triggers to another recorder</source>
        <translation>Envoyer les déclencheurs d’un essai à un autre enregistreur</translation>
    </message>
    <message>
        <source>How many participants a test needs: power by simulated studies</source>
        <translation>Combien de participants demande un test&#xa0;: puissance par des études simulées</translation>
    </message>
    <message>
        <source>Protocol of the study, or the name of one that comes with the program: tactor-detection, intensity-steps, equal-strength, two-or-one, motion-timing; otherwise the paper&apos;s</source>
        <translation>Protocole de l’étude, ou nom de l’un de ceux fournis avec le programme&#xa0;: tactor-detection, intensity-steps, equal-strength, two-or-one, motion-timing&#xa0;; sinon celui de l’article</translation>
    </message>
    <message>
        <source>Simulated participants in tasks with levels: threshold t and slope of their psychometric function, lapse rate, and sd of the threshold between them, in the scale of the levels</source>
        <translation>Participants simulés dans les tâches à niveaux&#xa0;: seuil t et pente de leur fonction psychométrique, taux d’inattention, et écart-type sd du seuil entre eux, dans l’échelle des niveaux</translation>
    </message>
    <message>
        <source>Rule of what does not count, besides those of the protocol; marked as made after the data, for example response_time_below_s=0.2</source>
        <translation>Règle de ce qui ne compte pas, en plus de celles du protocole&#xa0;; marquée comme établie après les données, par exemple response_time_below_s=0.2</translation>
    </message>
    <message>
        <source>Folder for report.html, confusion_long.csv, summary.csv, group.csv, anova.csv, thresholds.csv, levels.csv, sdt.csv, comparisons.csv, ranks.csv, binomial_model.csv, response_times.csv, exclusions.csv, figures</source>
        <translation>Dossier pour report.html, confusion_long.csv, summary.csv, group.csv, anova.csv, thresholds.csv, levels.csv, sdt.csv, comparisons.csv, ranks.csv, binomial_model.csv, response_times.csv, exclusions.csv, figures</translation>
    </message>
    <message>
        <source>the exclusion rules leave no completed trial</source>
        <translation>les règles d’exclusion ne laissent aucun essai achevé</translation>
    </message>
    <message>
        <source>rules that leave some</source>
        <translation>des règles qui en laissent</translation>
    </message>
    <message>
        <source>there are no test trials, only practice: the report has no results</source>
        <translation>il n’y a pas d’essais de test, seulement de l’entraînement&#xa0;: le rapport n’a pas de résultats</translation>
    </message>
    <message>
        <source>the answer &quot;%1&quot; counts as wrong: the pattern is &quot;%2&quot;</source>
        <translation>la réponse «&#xa0;%1&#xa0;» compte comme fausse&#xa0;: le motif est «&#xa0;%2&#xa0;»</translation>
    </message>
    <message>
        <source>--exclude cannot be applied to this file</source>
        <translation>--exclude ne peut pas être appliqué à ce fichier</translation>
    </message>
    <message>
        <source>the columns stimulus and response</source>
        <translation>les colonnes stimulus et response</translation>
    </message>
    <message>
        <source>List the participants of a study, and who was deleted</source>
        <translation>Lister les participants d’une étude, et qui a été supprimé</translation>
    </message>
    <message>
        <source>Enrol a participant under a pseudonym</source>
        <translation>Inscrire un participant sous un pseudonyme</translation>
    </message>
    <message>
        <source>Delete a participant with everything that was kept</source>
        <translation>Supprimer un participant avec tout ce qui a été gardé</translation>
    </message>
    <message>
        <source>Let others read what is written, as the umask allows; otherwise it is for you alone</source>
        <translation>Laisser les autres lire ce qui est écrit, selon le umask&#xa0;; sinon c’est pour vous seul</translation>
    </message>
</context>
<context>
    <name>StudyExport</name>
    <message>
        <source>the study has no participant &quot;%1&quot;</source>
        <translation>l’étude n’a pas de participant «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>the file differs from what was written</source>
        <translation>le fichier ne contient pas ce qui a été écrit</translation>
    </message>
    <message>
        <source>cannot remove the file: %1</source>
        <translation>impossible de supprimer le fichier&#xa0;:&#xa0;%1</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is in a session at %2</source>
        <translation>«&#xa0;%1&#xa0;» est dans une session à&#xa0;%2</translation>
    </message>
    <message>
        <source>a participant who is in no session</source>
        <translation>un participant qui n’est dans aucune session</translation>
    </message>
    <message>
        <source>the file cannot be opened to others: %1</source>
        <translation>le fichier ne peut pas être ouvert aux autres&#xa0;:&#xa0;%1</translation>
    </message>
</context>
<context>
    <name>StudyFigure</name>
    <message>
        <source>PILOT</source>
        <translation>PILOTE</translation>
    </message>
    <message>
        <source>SIMULATED</source>
        <translation>SIMULÉ</translation>
    </message>
</context>
<context>
    <name>StudyFitCommand</name>
    <message>
        <source>; the curve does not fit: p of the deviance %1</source>
        <translation>&#xa0;; la courbe n’est pas ajustée aux données&#xa0;: p de la déviance %1</translation>
    </message>
    <message>
        <source>Mean of %1</source>
        <translation>Moyenne de %1</translation>
    </message>
    <message>
        <source>%1 (%2 to %3)</source>
        <translation>%1 (%2 à %3)</translation>
    </message>
    <message>
        <source>no d&apos;: trials of one kind are missing</source>
        <translation>pas de d&apos;&#xa0;: il manque les essais d’une des deux sortes</translation>
    </message>
    <message>
        <source>d&apos; %1, c %2</source>
        <translation>d&apos; %1, c %2</translation>
    </message>
    <message>
        <source>d&apos; %1</source>
        <translation>d&apos; %1</translation>
    </message>
    <message>
        <source>Folder of a study, or a CSV with participant_id,task,condition,phase,track,level,correct</source>
        <translation>Dossier d’une étude, ou un CSV avec participant_id,task,condition,phase,track,level,correct</translation>
    </message>
    <message>
        <source>PostgreSQL server that has the study, postgresql://USER@HOST/DATABASE?study=NAME</source>
        <translation>Serveur PostgreSQL qui contient l’étude, postgresql://USER@HOST/DATABASE?study=NAME</translation>
    </message>
    <message>
        <source>Function that is fitted; otherwise weibull for detection on a logarithmic scale, else gauss</source>
        <translation>Fonction ajustée&#xa0;; sinon weibull pour la détection sur une échelle logarithmique, et gauss dans les autres cas</translation>
    </message>
    <message>
        <source>Share of right answers without a stimulus; otherwise from the design</source>
        <translation>Part de réponses correctes sans stimulus&#xa0;; sinon d’après le plan d’expérience</translation>
    </message>
    <message>
        <source>Share of mistakes with any stimulus: fixed, or the range in which it is free; otherwise 0:0.06</source>
        <translation>Part d’erreurs avec n’importe quel stimulus&#xa0;: fixe, ou la plage dans laquelle elle est libre&#xa0;; sinon 0:0.06</translation>
    </message>
    <message>
        <source>How the interval of a threshold is computed</source>
        <translation>Mode de calcul de l’intervalle d’un seuil</translation>
    </message>
    <message>
        <source>Folder for thresholds.csv, levels.csv, sdt.csv, analysis.R and figures</source>
        <translation>Dossier pour thresholds.csv, levels.csv, sdt.csv, analysis.R et les figures</translation>
    </message>
    <message>
        <source>--lapse cannot be &quot;%1&quot;</source>
        <translation>--lapse ne peut pas être «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>a share from 0 to 0.4, or two with a colon between them, the lower one first</source>
        <translation>une part de 0 à 0.4, ou deux séparées par un deux-points, la plus petite d’abord</translation>
    </message>
    <message>
        <source>there are no test trials with a level</source>
        <translation>il n’y a pas d’essais de test avec un niveau</translation>
    </message>
    <message>
        <source>trials of a design with levels, or a column level</source>
        <translation>des essais d’un plan à niveaux, ou une colonne level</translation>
    </message>
    <message>
        <source>nothing says how often guessing is right in task %1</source>
        <translation>rien ne dit combien de fois on répond juste au hasard dans la tâche %1</translation>
    </message>
    <message>
        <source>--guess (0.5 for two intervals, 0.02 for yes and no), or a column design or n_alternatives</source>
        <translation>--guess (0.5 pour deux intervalles, 0.02 pour oui et non), ou une colonne design ou n_alternatives</translation>
    </message>
    <message>
        <source>Tables and figures</source>
        <translation>Tableaux et figures</translation>
    </message>
    <message>
        <source>One fit of %1</source>
        <translation>Ajustement commun de %1</translation>
    </message>
    <message>
        <source>%1, sd of the participants %2</source>
        <translation>%1, écart-type des participants %2</translation>
    </message>
    <message>
        <source>%1 steps of intensity from start to full</source>
        <translation>%1 pas d’intensité du démarrage à la pleine commande</translation>
    </message>
    <message>
        <source>most yes at %1 s (%2 to %3)</source>
        <translation>le plus de oui à %1 s (%2 à %3)</translation>
    </message>
</context>
<context>
    <name>StudyNames</name>
    <message>
        <source>Object shape</source>
        <translation>Forme de l’objet</translation>
    </message>
    <message>
        <source>circle</source>
        <translation>cercle</translation>
    </message>
    <message>
        <source>rectangle</source>
        <translation>rectangle</translation>
    </message>
    <message>
        <source>triangle</source>
        <translation>triangle</translation>
    </message>
    <message>
        <source>arc</source>
        <translation>arc</translation>
    </message>
    <message>
        <source>line</source>
        <translation>ligne</translation>
    </message>
    <message>
        <source>point</source>
        <translation>point</translation>
    </message>
    <message>
        <source>static</source>
        <translation>statique</translation>
    </message>
    <message>
        <source>dynamic</source>
        <translation>dynamique</translation>
    </message>
    <message>
        <source>Object stiffness</source>
        <translation>Raideur de l’objet</translation>
    </message>
    <message>
        <source>sponge</source>
        <translation>éponge</translation>
    </message>
    <message>
        <source>rubber sponge</source>
        <translation>caoutchouc mousse</translation>
    </message>
    <message>
        <source>rubber</source>
        <translation>caoutchouc</translation>
    </message>
    <message>
        <source>wood</source>
        <translation>bois</translation>
    </message>
    <message>
        <source>metal</source>
        <translation>métal</translation>
    </message>
    <message>
        <source>Tactor detection</source>
        <translation>Détection des tacteurs</translation>
    </message>
    <message>
        <source>rest</source>
        <translation>repos</translation>
    </message>
    <message>
        <source>In which interval did you feel a vibration?</source>
        <translation>Dans quel intervalle avez-vous senti une vibration&#xa0;?</translation>
    </message>
    <message>
        <source>Intensity steps</source>
        <translation>Écarts d’intensité</translation>
    </message>
    <message>
        <source>weak</source>
        <translation>faible</translation>
    </message>
    <message>
        <source>medium</source>
        <translation>moyen</translation>
    </message>
    <message>
        <source>strong</source>
        <translation>fort</translation>
    </message>
    <message>
        <source>Which interval was stronger?</source>
        <translation>Quel intervalle était le plus fort&#xa0;?</translation>
    </message>
    <message>
        <source>Equal strength</source>
        <translation>Même force</translation>
    </message>
    <message>
        <source>Two or one</source>
        <translation>Deux ou un</translation>
    </message>
    <message>
        <source>Did you feel two separate taps?</source>
        <translation>Avez-vous senti deux tapotements distincts&#xa0;?</translation>
    </message>
    <message>
        <source>Motion timing</source>
        <translation>Cadence du mouvement</translation>
    </message>
    <message>
        <source>Did you feel one moving point?</source>
        <translation>Avez-vous senti un seul point en mouvement&#xa0;?</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>oui</translation>
    </message>
    <message>
        <source>no</source>
        <translation>non</translation>
    </message>
    <message>
        <source>same</source>
        <translation>identiques</translation>
    </message>
    <message>
        <source>different</source>
        <translation>différents</translation>
    </message>
    <message>
        <source>Was there a vibration?</source>
        <translation>Y avait-il une vibration&#xa0;?</translation>
    </message>
    <message>
        <source>Which interval had the vibration?</source>
        <translation>Quel intervalle contenait la vibration&#xa0;?</translation>
    </message>
    <message>
        <source>Were the two intervals the same?</source>
        <translation>Les deux intervalles étaient-ils identiques&#xa0;?</translation>
    </message>
    <message>
        <source>Which interval had more?</source>
        <translation>Quel intervalle en avait le plus&#xa0;?</translation>
    </message>
    <message>
        <source>drive</source>
        <comment>unit of a level</comment>
        <translation>commande</translation>
    </message>
    <message>
        <source>balance</source>
        <comment>unit of a level</comment>
        <translation>équilibre</translation>
    </message>
</context>
<context>
    <name>StudyNoise</name>
    <message>
        <source>an even number of samples up to %1, and frequencies above 0 up to half the rate</source>
        <translation>un nombre pair d’échantillons jusqu’à %1, et des fréquences supérieures à 0 jusqu’à la moitié de la fréquence d’échantillonnage</translation>
    </message>
    <message>
        <source>more samples or a wider band</source>
        <translation>plus d’échantillons ou une bande plus large</translation>
    </message>
    <message>
        <source>the noise would be clipped at this level</source>
        <translation>le bruit serait écrêté à ce niveau</translation>
    </message>
    <message>
        <source>a level of %1 dBFS at most</source>
        <translation>un niveau de %1 dBFS au plus</translation>
    </message>
    <message>
        <source>the sound is too long for a WAV file</source>
        <translation>le son est trop long pour un fichier WAV</translation>
    </message>
    <message>
        <source>at most 4 GiB of samples</source>
        <translation>au plus 4 GiB d’échantillons</translation>
    </message>
    <message>
        <source>the noise settings are out of range</source>
        <translation>ces réglages du bruit sont hors limites</translation>
    </message>
    <message>
        <source>the band contains no frequency</source>
        <translation>il n’y a pas de fréquence dans cette bande</translation>
    </message>
</context>
<context>
    <name>StudyPapers</name>
    <message>
        <source>Folder of the study</source>
        <translation>Dossier de l’étude</translation>
    </message>
    <message>
        <source>Whose report it is</source>
        <translation>Participant dont c’est le rapport</translation>
    </message>
    <message>
        <source>experimenter: everything of this participant; participant: their own answers in plain words</source>
        <translation>experimenter&#xa0;: tout sur ce participant&#xa0;; participant&#xa0;: ses propres réponses, en mots simples</translation>
    </message>
    <message>
        <source>The page; otherwise report-ID.html or report-ID-participant.html in the folder of the study</source>
        <translation>La page&#xa0;; sinon report-ID.html ou report-ID-participant.html dans le dossier de l’étude</translation>
    </message>
    <message>
        <source>PostgreSQL server that has the study, postgresql://USER@HOST/DATABASE?study=NAME; the password comes from PGPASSWORD or ~/.pgpass</source>
        <translation>Serveur PostgreSQL qui contient l’étude, postgresql://USER@HOST/DATABASE?study=NAME&#xa0;; le mot de passe vient de PGPASSWORD ou de ~/.pgpass</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>Rapport</translation>
    </message>
    <message>
        <source>Folder of a study, whose questionnaires are described too</source>
        <translation>Dossier d’une étude, dont les questionnaires sont décrits aussi</translation>
    </message>
    <message>
        <source>Where one trial&apos;s events go: a serial port such as /dev/ttyUSB0, or HOST:PORT for OSC by UDP</source>
        <translation>Où vont les événements d’un essai&#xa0;: un port série tel que /dev/ttyUSB0, ou HOST:PORT pour OSC par UDP</translation>
    </message>
    <message>
        <source>written in %1 ms</source>
        <translation>écrit en %1 ms</translation>
    </message>
</context>
<context>
    <name>StudyPeople</name>
    <message>
        <source>Folder of the study</source>
        <translation>Dossier de l’étude</translation>
    </message>
    <message>
        <source>PostgreSQL server that has the study, postgresql://USER@HOST/DATABASE?study=NAME</source>
        <translation>Serveur PostgreSQL qui a l’étude, postgresql://USER@HOST/DATABASE?study=NAME</translation>
    </message>
    <message>
        <source>Also say who is behind the pseudonyms</source>
        <translation>Dire aussi qui se cache derrière les pseudonymes</translation>
    </message>
    <message>
        <source>Name of the participant in the study; otherwise a pseudonym at random</source>
        <translation>Nom du participant dans l’étude&#xa0;; sinon un pseudonyme au hasard</translation>
    </message>
    <message>
        <source>File that keeps who is behind the pseudonyms, for you alone; not in the study&apos;s folder</source>
        <translation>Fichier qui garde qui se cache derrière les pseudonymes, pour vous seul&#xa0;; pas dans le dossier de l’étude</translation>
    </message>
    <message>
        <source>Name of the person, for the key</source>
        <translation>Nom de la personne, pour la clé</translation>
    </message>
    <message>
        <source>How to reach the person, for the key</source>
        <translation>Comment joindre la personne, pour la clé</translation>
    </message>
    <message>
        <source>Whom to delete</source>
        <translation>Qui supprimer</translation>
    </message>
    <message>
        <source>Delete the person from this key as well</source>
        <translation>Supprimer aussi la personne de cette clé</translation>
    </message>
    <message>
        <source>Why, for the record that stays; without anything that tells who it was</source>
        <translation>Pourquoi, pour la trace qui reste&#xa0;; sans rien qui dise qui c’était</translation>
    </message>
    <message>
        <source>Really delete: this cannot be undone</source>
        <translation>Supprimer vraiment&#xa0;: c’est irréversible</translation>
    </message>
    <message numerus="yes">
        <source>%n session(s)</source>
        <translation>
            <numerusform>%n session</numerusform>
            <numerusform>%n sessions</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n trial(s)</source>
        <translation>
            <numerusform>%n essai</numerusform>
            <numerusform>%n essais</numerusform>
        </translation>
    </message>
    <message>
        <source>Deleted</source>
        <translation>Supprimé</translation>
    </message>
    <message numerus="yes">
        <source>number %1 of the enrolment, on %2, %n trial(s)</source>
        <translation>
            <numerusform>numéro d’inscription&#xa0;%1, le&#xa0;%2,&#xa0;%n essai</numerusform>
            <numerusform>numéro d’inscription&#xa0;%1, le&#xa0;%2,&#xa0;%n essais</numerusform>
        </translation>
    </message>
    <message>
        <source>Nobody is enrolled.</source>
        <translation>Personne n’est inscrit.</translation>
    </message>
    <message>
        <source>the key that keeps it is missing: --key with a file apart from the study</source>
        <translation>il manque une clé qui le garderait&#xa0;: --key avec un fichier à part de l’étude</translation>
    </message>
    <message>
        <source>the name of the person is missing: --name</source>
        <translation>il manque le nom de la personne&#xa0;: --name</translation>
    </message>
    <message>
        <source>Participant</source>
        <translation>Participant</translation>
    </message>
    <message>
        <source>Number of the enrolment</source>
        <translation>Numéro d’inscription</translation>
    </message>
    <message>
        <source>Removed</source>
        <translation>Retirés</translation>
    </message>
    <message>
        <source>Key</source>
        <translation>Clé</translation>
    </message>
    <message>
        <source>the person was deleted</source>
        <translation>la personne a été supprimée</translation>
    </message>
    <message>
        <source>has no such person</source>
        <translation>n’avait pas cette personne</translation>
    </message>
    <message>
        <source>Still counts the participant</source>
        <translation>Compte encore le participant</translation>
    </message>
    <message>
        <source>Analyze the study again, and delete what was copied elsewhere.</source>
        <translation>Analysez l’étude à nouveau, et supprimez ce qui a été copié ailleurs.</translation>
    </message>
    <message>
        <source>it is missing, and all sessions, answers, notes, recordings and exported files of &quot;%1&quot; would be deleted, which cannot be undone</source>
        <translation>elle manque, et toutes les sessions, réponses, notes, enregistrements et fichiers exportés de «&#xa0;%1&#xa0;» seraient supprimés, ce qui est irréversible</translation>
    </message>
    <message numerus="yes">
        <source>%n file(s)</source>
        <translation>
            <numerusform>%n fichier</numerusform>
            <numerusform>%n fichiers</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>StudyPlan</name>
    <message>
        <source>the protocol has no task &quot;%1&quot;</source>
        <translation>le protocole n’a pas de tâche «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>TASK:EFFECT with one of %1</source>
        <translation>TASK:EFFECT avec l’une de %1</translation>
    </message>
    <message>
        <source>the task %1 measures levels</source>
        <translation>la tâche %1 mesure des niveaux</translation>
    </message>
    <message>
        <source>a task in which patterns are told apart</source>
        <translation>une tâche où des motifs sont distingués</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no line of the analysis of %2</source>
        <translation>«&#xa0;%1&#xa0;» n’est pas une ligne de l’analyse de %2</translation>
    </message>
    <message>
        <source>condition, pattern, condition:pattern, or condition@PATTERN</source>
        <translation>condition, pattern, condition:pattern ou condition@PATTERN</translation>
    </message>
    <message>
        <source>pattern</source>
        <translation>pattern</translation>
    </message>
    <message>
        <source>the protocol has no test trials</source>
        <translation>le protocole n’a pas d’essais de test</translation>
    </message>
    <message>
        <source>test.repetitions above 0</source>
        <translation>test.repetitions supérieur à 0</translation>
    </message>
    <message>
        <source>the task %1 has no pattern &quot;%2&quot;</source>
        <translation>la tâche %1 n’a pas de motif «&#xa0;%2&#xa0;»</translation>
    </message>
    <message>
        <source>one of its letters</source>
        <translation>l’une de ses lettres</translation>
    </message>
    <message>
        <source>the truth says nothing of the task %1</source>
        <translation>la vérité ne dit rien de la tâche %1</translation>
    </message>
    <message>
        <source>a [[task]] with that id</source>
        <translation>une [[task]] avec cet identifiant</translation>
    </message>
    <message>
        <source>the truth says nothing of %1 under %2</source>
        <translation>la vérité ne dit rien de %1 dans la condition %2</translation>
    </message>
    <message>
        <source>a condition with that id</source>
        <translation>une condition avec cet identifiant</translation>
    </message>
</context>
<context>
    <name>StudyPlanCommand</name>
    <message>
        <source>no number up to %1 reaches %2 %</source>
        <translation>aucun nombre jusqu’à %1 n’atteint %2&#xa0;%</translation>
    </message>
    <message>
        <source>%1 or %2 participants; %3 studies cannot tell which</source>
        <translation>%1 ou %2 participants&#xa0;; %3 études ne permettent pas de trancher</translation>
    </message>
    <message>
        <source>%1 participants reach %2 %</source>
        <translation>%1 participants atteignent %2&#xa0;%</translation>
    </message>
    <message>
        <source>Protocol of the study</source>
        <translation>Protocole de l’étude</translation>
    </message>
    <message>
        <source>Numbers of participants to try: from, to, step</source>
        <translation>Nombres de participants à essayer&#xa0;: de, à, pas</translation>
    </message>
    <message>
        <source>What is assumed: a file with shares of right answers and spreads, or the folder of a pilot study</source>
        <translation>Ce qui est supposé&#xa0;: un fichier avec des parts de réponses correctes et des dispersions, ou le dossier d’une étude pilote</translation>
    </message>
    <message>
        <source>Seed of all studies</source>
        <translation>Graine de toutes les études</translation>
    </message>
    <message>
        <source>Wanted share of significant studies</source>
        <translation>Part voulue d’études significatives</translation>
    </message>
    <message>
        <source>Table of the power, CSV</source>
        <translation>Tableau de la puissance, CSV</translation>
    </message>
    <message>
        <source>%1 is not FROM:TO:STEP with numbers from 1 to %2</source>
        <translation>%1 n’est pas FROM:TO:STEP avec des nombres de 1 à %2</translation>
    </message>
    <message>
        <source>Test</source>
        <translation>Test</translation>
    </message>
    <message>
        <source>%1 % (95 %: %2 to %3, %4 studies)</source>
        <translation>%1&#xa0;% (95&#xa0;%&#xa0;: %2 à %3, %4 études)</translation>
    </message>
    <message>
        <source>%1; no analysis in %2 of them</source>
        <translation>%1&#xa0;; pas d’analyse dans %2 d’entre elles</translation>
    </message>
    <message>
        <source>%1 participants</source>
        <translation>%1 participants</translation>
    </message>
    <message>
        <source>Answer</source>
        <translation>Réponse</translation>
    </message>
    <message>
        <source>Table</source>
        <translation>Tableau</translation>
    </message>
    <message>
        <source>Line of the analysis: shape:condition, shape:pattern, shape:condition:pattern, or shape:condition@A within pattern A; or detect:threshold for the interval of a threshold</source>
        <translation>Ligne de l’analyse&#xa0;: shape:condition, shape:pattern, shape:condition:pattern, ou shape:condition@A pour le seul motif A&#xa0;; ou detect:threshold pour l’intervalle d’un seuil</translation>
    </message>
    <message>
        <source>Of a threshold: how far its 95 % interval may reach to each side, on the scale of the levels (0.1 log10 units are a factor of 1.26)</source>
        <translation>D’un seuil&#xa0;: jusqu’où son intervalle à 95&#xa0;% peut s’étendre de chaque côté, à l’échelle des niveaux (0.1 unité log10 est un facteur de 1.26)</translation>
    </message>
    <message>
        <source>Of a threshold: trials of a track, of constant stimuli at each level; otherwise the protocol&apos;s</source>
        <translation>D’un seuil&#xa0;: essais d’une série, ou à chaque niveau pour des stimuli constants&#xa0;; sinon ceux du protocole</translation>
    </message>
    <message>
        <source>Studies drawn for each number; otherwise 10000, for thresholds 1000</source>
        <translation>Études tirées pour chaque nombre&#xa0;; sinon 10000, et 1000 pour des seuils</translation>
    </message>
</context>
<context>
    <name>StudyProtocol</name>
    <message>
        <source>&quot;%1&quot; means no answer</source>
        <translation>«&#xa0;%1&#xa0;» signifie pas de réponse</translation>
    </message>
    <message>
        <source>another letter</source>
        <translation>une autre lettre</translation>
    </message>
    <message>
        <source>there are too many patterns</source>
        <translation>il y a trop de motifs</translation>
    </message>
    <message>
        <source>at most %1, one digit each</source>
        <translation>au plus %1, un chiffre pour chacun</translation>
    </message>
    <message>
        <source>%1 is not one more tactor</source>
        <translation>%1 n’est pas un tacteur de plus</translation>
    </message>
    <message>
        <source>whole numbers from 1 to %1, each once</source>
        <translation>des nombres entiers de 1 à %1, chacun une seule fois</translation>
    </message>
    <message>
        <source>there are too many tracks</source>
        <translation>il y a trop de séries</translation>
    </message>
    <message>
        <source>at most %1</source>
        <translation>au plus %1</translation>
    </message>
    <message>
        <source>%1 is not among the levels</source>
        <translation>%1 ne fait pas partie des niveaux</translation>
    </message>
    <message>
        <source>from lowest to highest, %1 to %2</source>
        <translation>du plus bas au plus haut, de %1 à %2</translation>
    </message>
    <message>
        <source>the lowest level is not below the highest</source>
        <translation>le niveau le plus bas n’est pas inférieur au plus haut</translation>
    </message>
    <message>
        <source>a number below %1</source>
        <translation>un nombre inférieur à %1</translation>
    </message>
    <message>
        <source>0 has no place on a scale of logarithms</source>
        <translation>0 n’a pas de place sur une échelle logarithmique</translation>
    </message>
    <message>
        <source>a number above 0, or the scale linear</source>
        <translation>un nombre supérieur à 0, ou l’échelle linear</translation>
    </message>
    <message>
        <source>a level of %1 cannot be shown</source>
        <translation>un niveau de %1 ne peut pas être présenté</translation>
    </message>
    <message>
        <source>there is nothing to compare with</source>
        <translation>il n’y a rien à quoi comparer</translation>
    </message>
    <message>
        <source>a reference above 0, here or in each condition</source>
        <translation>une référence supérieure à 0, ici ou dans chaque condition</translation>
    </message>
    <message>
        <source>the levels do not rise</source>
        <translation>les niveaux ne sont pas croissants</translation>
    </message>
    <message>
        <source>each level above the one before</source>
        <translation>chaque niveau supérieur au précédent</translation>
    </message>
    <message>
        <source>weibull has no place for a level of 0</source>
        <translation>weibull n’a pas de place pour un niveau de 0</translation>
    </message>
    <message>
        <source>gauss or logistic, or a lowest level above 0</source>
        <translation>gauss ou logistic, ou un niveau le plus bas supérieur à 0</translation>
    </message>
    <message>
        <source>a prior needs its mean and its standard deviation</source>
        <translation>un a priori demande sa moyenne et son écart-type</translation>
    </message>
    <message>
        <source>prior_mean and prior_sd</source>
        <translation>prior_mean et prior_sd</translation>
    </message>
    <message>
        <source>too few reversals for an estimate</source>
        <translation>trop peu d’inversions pour une estimation</translation>
    </message>
    <message>
        <source>at least %1</source>
        <translation>au moins %1</translation>
    </message>
    <message>
        <source>constant stimuli need their levels</source>
        <translation>les stimuli constants demandent leurs niveaux</translation>
    </message>
    <message>
        <source>values in level, 1 to %1 of them</source>
        <translation>des valeurs dans level, de 1 à %1</translation>
    </message>
    <message>
        <source>answers to this design count from the end of the last interval</source>
        <translation>les réponses de ce plan d’expérience comptent à partir de la fin du dernier intervalle</translation>
    </message>
    <message>
        <source>response_window = &quot;from_end&quot;</source>
        <translation>response_window = &quot;from_end&quot;</translation>
    </message>
    <message>
        <source>patterns have no reference</source>
        <translation>les motifs n’ont pas de référence</translation>
    </message>
    <message>
        <source>conditions without reference</source>
        <translation>des conditions sans référence</translation>
    </message>
</context>
<context>
    <name>StudyQuestionnaire</name>
    <message>
        <source>&quot;%1&quot; is not answered</source>
        <translation>«&#xa0;%1&#xa0;» est sans réponse</translation>
    </message>
    <message>
        <source>an answer</source>
        <translation>une réponse</translation>
    </message>
    <message>
        <source>the answer to &quot;%1&quot; is too long</source>
        <translation>la réponse à «&#xa0;%1&#xa0;» est trop longue</translation>
    </message>
    <message>
        <source>%1 characters at most</source>
        <translation>%1 caractères au plus</translation>
    </message>
    <message>
        <source>a number from 1 to %1</source>
        <translation>un nombre de 1 à %1</translation>
    </message>
    <message>
        <source>one of the choices</source>
        <translation>l’un des choix</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be answered with &quot;%2&quot;</source>
        <translation>«&#xa0;%2&#xa0;» n’est pas une réponse possible à «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>the answers do not match this questionnaire</source>
        <translation>les réponses ne sont pas celles de ce questionnaire</translation>
    </message>
    <message>
        <source>one answer per item, in order</source>
        <translation>une réponse par question, dans leur ordre</translation>
    </message>
    <message>
        <source>a pair has two choices</source>
        <translation>une paire a deux choix</translation>
    </message>
    <message>
        <source>two of them</source>
        <translation>deux choix</translation>
    </message>
    <message>
        <source>a number from 0 to 100 in steps of 5</source>
        <translation>un nombre de 0 à 100 par pas de 5</translation>
    </message>
</context>
<context>
    <name>StudyRehearsal</name>
    <message>
        <source>this study has real participants</source>
        <translation>cette étude a de vrais participants</translation>
    </message>
    <message>
        <source>a study created as a rehearsal</source>
        <translation>une étude commencée comme répétition générale</translation>
    </message>
</context>
<context>
    <name>StudyScene</name>
    <message>
        <source>the effect is listed twice</source>
        <translation>l’effet est indiqué deux fois</translation>
    </message>
    <message>
        <source>each effect at most once</source>
        <translation>chaque effet au plus une fois</translation>
    </message>
</context>
<context>
    <name>StudyScenes</name>
    <message>
        <source>%1, %2</source>
        <comment>task, condition</comment>
        <translation>%1, %2</translation>
    </message>
    <message numerus="yes">
        <source>%1: %n pattern(s); %2</source>
        <comment>task; conditions</comment>
        <translation>
            <numerusform>%1&#xa0;: %n motif&#xa0;; %2</numerusform>
            <numerusform>%1&#xa0;: %n motifs&#xa0;; %2</numerusform>
        </translation>
    </message>
    <message>
        <source>Stimulus %1 s, answer within %2 s %3</source>
        <comment>numbers; of what</comment>
        <translation>Stimulus %1 s, réponse en %2 s %3</translation>
    </message>
    <message>
        <source>of its onset</source>
        <translation>après son début</translation>
    </message>
    <message>
        <source>of its end</source>
        <translation>après sa fin</translation>
    </message>
    <message>
        <source>Pink noise, %1 dBA</source>
        <translation>Bruit rose, %1 dBA</translation>
    </message>
    <message>
        <source>Seed %1</source>
        <translation>Graine %1</translation>
    </message>
    <message>
        <source>running</source>
        <translation>en cours</translation>
    </message>
    <message>
        <source>✓ finished</source>
        <translation>✓ terminée</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <comment>trials kept</comment>
        <translation>%1 sur %2</translation>
    </message>
    <message>
        <source>to do</source>
        <translation>à faire</translation>
    </message>
    <message>
        <source>%1 — %2</source>
        <comment>participant, session</comment>
        <translation>%1 — %2</translation>
    </message>
    <message>
        <source>Session %1 of %2, row %3 of the Williams square</source>
        <translation>Session %1 sur %2, ligne %3 du carré de Williams</translation>
    </message>
    <message>
        <source>Halt the rehearsal</source>
        <translation>Interrompre la répétition générale</translation>
    </message>
    <message>
        <source>This session is finished.</source>
        <translation>Cette session est terminée.</translation>
    </message>
    <message>
        <source>Show the results</source>
        <translation>Afficher les résultats</translation>
    </message>
    <message>
        <source>All sessions of all participants are finished.</source>
        <translation>Toutes les sessions de tous les participants sont terminées.</translation>
    </message>
    <message>
        <source>Add a participant</source>
        <translation>Ajouter un participant</translation>
    </message>
    <message>
        <source>Choose another participant</source>
        <translation>Choisir un autre participant</translation>
    </message>
    <message>
        <source>This participant has finished all sessions.</source>
        <translation>Ce participant a terminé toutes les sessions.</translation>
    </message>
    <message>
        <source>The simulated participant fills in “%1”.</source>
        <translation>Le participant simulé remplit «&#xa0;%1&#xa0;».</translation>
    </message>
    <message>
        <source>The participant fills in “%1”.</source>
        <translation>Le participant remplit «&#xa0;%1&#xa0;».</translation>
    </message>
    <message>
        <source>Show the questionnaire</source>
        <translation>Afficher le questionnaire</translation>
    </message>
    <message>
        <source>Practice</source>
        <translation>Entraînement</translation>
    </message>
    <message>
        <source>Test</source>
        <translation>Test</translation>
    </message>
    <message>
        <source>Go on</source>
        <translation>Continuer</translation>
    </message>
    <message>
        <source>Paused.</source>
        <translation>En pause.</translation>
    </message>
    <message>
        <source>Practice is over. In the test there is no feedback unless the protocol says so.</source>
        <translation>L’entraînement est terminé. Au test, il n’y a pas de retour sur les réponses, sauf si le protocole le prévoit.</translation>
    </message>
    <message>
        <source>Go on after STOP</source>
        <translation>Continuer après STOP</translation>
    </message>
    <message>
        <source>The stimulus was interrupted: %1. The trial will be shown again.</source>
        <translation>Le stimulus a été interrompu&#xa0;: %1. L’essai sera présenté à nouveau.</translation>
    </message>
    <message>
        <source>Hold the STOP button for a second to release it.</source>
        <translation>Maintenez le bouton STOP une seconde pour le relâcher.</translation>
    </message>
    <message>
        <source>Leave this session</source>
        <translation>Quitter cette session</translation>
    </message>
    <message>
        <source>This session is finished. Thank the participant.</source>
        <translation>Cette session est terminée. Remerciez le participant.</translation>
    </message>
    <message>
        <source>Ready for the next trial.</source>
        <translation>Prêt pour l’essai suivant.</translation>
    </message>
    <message>
        <source>The right answer is shown.</source>
        <translation>La bonne réponse est montrée.</translation>
    </message>
    <message>
        <source>Waiting for the answer.</source>
        <translation>En attente de la réponse.</translation>
    </message>
    <message>
        <source>A pause follows.</source>
        <translation>Une pause suit.</translation>
    </message>
    <message>
        <source>%1, test</source>
        <translation>%1, test</translation>
    </message>
    <message>
        <source>%1, practice</source>
        <translation>%1, entraînement</translation>
    </message>
    <message>
        <source>End the rest</source>
        <translation>Terminer le repos</translation>
    </message>
    <message>
        <source>Repetitions of each pattern: %1 in practice, %2 in the test; %3 test trials per participant</source>
        <translation>Répétitions de chaque motif&#xa0;: %1 à l’entraînement, %2 au test&#xa0;; %3 essais de test par participant</translation>
    </message>
    <message>
        <source>Resume this session</source>
        <translation>Reprendre cette session</translation>
    </message>
    <message>
        <source>Start this session</source>
        <translation>Commencer cette session</translation>
    </message>
    <message>
        <source>This session was interrupted after %1 of %2 trials. All answers are saved; it resumes in the same order.</source>
        <translation>Cette session a été interrompue après %1 essais sur %2. Les réponses données sont conservées&#xa0;; elle reprend dans le même ordre.</translation>
    </message>
    <message>
        <source>The session can start when all checks have passed.</source>
        <translation>La session peut commencer quand tous les contrôles sont positifs.</translation>
    </message>
    <message>
        <source>Start the rehearsal</source>
        <translation>Commencer la répétition générale</translation>
    </message>
    <message>
        <source>Resume the rehearsal</source>
        <translation>Reprendre la répétition générale</translation>
    </message>
    <message>
        <source>Simulated participants go through all sessions, by the same rules as people.</source>
        <translation>Des participants simulés parcourent toutes les sessions, avec le même code que des personnes.</translation>
    </message>
    <message>
        <source>Next session</source>
        <translation>À la session suivante</translation>
    </message>
    <message>
        <source>Enrol the first participant on the left: the order of enrolment determines the order of the conditions.</source>
        <translation>Inscrivez le premier participant à gauche&#xa0;: l’ordre des conditions découle de l’ordre d’inscription.</translation>
    </message>
    <message>
        <source>It is asked again when a session of this participant starts or resumes.</source>
        <translation>Il est de nouveau posé quand une session de ce participant commence ou reprend.</translation>
    </message>
    <message>
        <source>It is asked again only if this session is interrupted and resumed.</source>
        <translation>Il n’est de nouveau posé que si cette session est interrompue puis reprise.</translation>
    </message>
    <message>
        <source>The session finishes without it, and it is not asked again.</source>
        <translation>La session se termine sans lui, et il n’est plus posé ensuite.</translation>
    </message>
    <message>
        <source>Recording that “%1” is skipped …</source>
        <translation>Note de l’omission de «&#xa0;%1&#xa0;» …</translation>
    </message>
    <message>
        <source>Saving the answers …</source>
        <translation>Conservation des réponses …</translation>
    </message>
    <message>
        <source>Try again to skip it</source>
        <translation>Réessayer de l’omettre</translation>
    </message>
    <message>
        <source>“%1” could not be skipped, because the note about it could not be saved. %2</source>
        <translation>«&#xa0;%1&#xa0;» n’a pas pu être omis, car la note à ce sujet n’a pas pu être conservée. %2</translation>
    </message>
    <message>
        <source>Try again to save the answers</source>
        <translation>Réessayer de conserver les réponses</translation>
    </message>
    <message>
        <source>The answers to “%1” could not be saved; they are still in the participant&apos;s window. %2</source>
        <translation>Les réponses à «&#xa0;%1&#xa0;» n’ont pas pu être conservées&#xa0;; elles sont encore dans la fenêtre du participant. %2</translation>
    </message>
    <message>
        <source>Rest. The participant may continue in %1 s.</source>
        <translation>Repos. Le participant peut continuer dans %1 s.</translation>
    </message>
    <message>
        <source>Rest. The participant continues with Space.</source>
        <translation>Repos. Le participant continue avec Espace.</translation>
    </message>
    <message>
        <source>Start the test</source>
        <translation>Commencer le test</translation>
    </message>
    <message>
        <source>STOPPED. The bracelet is off. An interrupted trial will be shown again.</source>
        <translation>ARRÊTÉ. Le bracelet est éteint. Un essai en cours sera présenté à nouveau.</translation>
    </message>
    <message>
        <source>Try again to save the last trial</source>
        <translation>Réessayer de conserver le dernier essai</translation>
    </message>
    <message>
        <source>The last trial is waiting for the server. %1</source>
        <translation>Le dernier essai attend le serveur. %1</translation>
    </message>
    <message>
        <source>The last trial could not be saved; it is still in memory. %1</source>
        <translation>Le dernier essai n’a pas pu être conservé&#xa0;; il est encore en mémoire. %1</translation>
    </message>
    <message>
        <source>The session was aborted. All answers are saved.</source>
        <translation>La session a été abandonnée. Les réponses données sont conservées.</translation>
    </message>
    <message>
        <source>Saving the trial …</source>
        <translation>Conservation de l’essai …</translation>
    </message>
    <message>
        <source>The stimulus is starting …</source>
        <translation>Le stimulus commence …</translation>
    </message>
    <message>
        <source>The stimulus is playing.</source>
        <translation>Le stimulus est présenté.</translation>
    </message>
    <message>
        <source>The simulated participant is working</source>
        <translation>Le participant simulé est à l’œuvre</translation>
    </message>
    <message>
        <source>The participant continues with Space</source>
        <translation>Le participant continue avec Espace</translation>
    </message>
    <message>
        <source>Your answers could not be saved yet. Please tell the experimenter.</source>
        <translation>Vos réponses n’ont pas encore pu être conservées. Veuillez prévenir l’expérimentateur.</translation>
    </message>
    <message>
        <source>No session is selected</source>
        <translation>Aucune session n’est choisie</translation>
    </message>
    <message numerus="yes">
        <source>%1: %n track(s); %2</source>
        <comment>task; conditions</comment>
        <translation>
            <numerusform>%1&#xa0;: %n série&#xa0;; %2</numerusform>
            <numerusform>%1&#xa0;: %n séries&#xa0;; %2</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1. %n trigger(s) could not be written: %2</source>
        <comment>device; why</comment>
        <translation>
            <numerusform>%1. %n déclencheur n’a pas pu être écrit&#xa0;: %2</numerusform>
            <numerusform>%1. %n déclencheurs n’ont pas pu être écrits&#xa0;: %2</numerusform>
        </translation>
    </message>
    <message>
        <source>the line was not open</source>
        <translation>la ligne n’était pas ouverte</translation>
    </message>
    <message>
        <source>Track %1, level %2 %3</source>
        <comment>name, number, unit</comment>
        <translation>Série %1, niveau %2 %3</translation>
    </message>
    <message>
        <source>%1 practice trials of each track; up to %2 test trials per participant</source>
        <translation>%1 essais d’entraînement par piste&#xa0;; jusqu’à&#xa0;%2 essais de test par participant</translation>
    </message>
    <message>
        <source>Session %1 of %2</source>
        <translation>Séance %1 sur %2</translation>
    </message>
    <message>
        <source> (%1 Hz, force %2 %)</source>
        <comment>behind a level; force as a share of full</comment>
        <translation> (%1 Hz, force %2&#xa0;%)</translation>
    </message>
</context>
<context>
    <name>StudySchema</name>
    <message>
        <source>a newer program made this study (schema %1, this one knows %2)</source>
        <translation>un programme plus récent a créé cette étude (schéma %1, celui-ci connaît %2)</translation>
    </message>
    <message>
        <source>cannot write the study: %1</source>
        <translation>impossible d’écrire l’étude&#xa0;: %1</translation>
    </message>
    <message>
        <source>cannot read the study: %1</source>
        <translation>impossible de lire l’étude&#xa0;: %1</translation>
    </message>
    <message>
        <source>another program made this database (schema %1)</source>
        <translation>un autre programme a créé cette base de données (schéma %1)</translation>
    </message>
</context>
<context>
    <name>StudySession</name>
    <message>
        <source>the stored trials do not belong to this session&apos;s plan</source>
        <translation>les essais conservés ne sont pas ceux de ce plan</translation>
    </message>
    <message>
        <source>the order given by the session&apos;s seed</source>
        <translation>l’ordre que donne la graine de la session</translation>
    </message>
</context>
<context>
    <name>StudyStore</name>
    <message>
        <source>cannot open the study: %1</source>
        <translation>impossible d’ouvrir l’étude&#xa0;: %1</translation>
    </message>
    <message>
        <source>cannot use the study: %1</source>
        <translation>impossible d’utiliser l’étude&#xa0;: %1</translation>
    </message>
    <message>
        <source>there is no study here</source>
        <translation>il n’y a pas d’étude ici</translation>
    </message>
    <message>
        <source>a folder with study.sqlite</source>
        <translation>un dossier avec study.sqlite</translation>
    </message>
    <message>
        <source>each attempt of a trial once</source>
        <translation>chaque tentative d’un essai une seule fois</translation>
    </message>
    <message>
        <source>cannot read the file: %1</source>
        <translation>impossible de lire le fichier&#xa0;: %1</translation>
    </message>
    <message>
        <source>server, created_utc and seed of a study</source>
        <translation>server, created_utc et seed d’une étude</translation>
    </message>
    <message>
        <source>the address has the port &quot;%1&quot;</source>
        <translation>l’adresse a le port «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>a whole number from 1 to 65535</source>
        <translation>un nombre entier de 1 à 65535</translation>
    </message>
    <message>
        <source>the option &quot;%1&quot; of the address has a semicolon</source>
        <translation>l’option «&#xa0;%1&#xa0;» de l’adresse a un point-virgule</translation>
    </message>
    <message>
        <source>a value without semicolons</source>
        <translation>une valeur sans points-virgules</translation>
    </message>
    <message>
        <source>the address has the unknown option &quot;%1&quot;</source>
        <translation>l’adresse a l’option inconnue «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot name a study on a server</source>
        <translation>«&#xa0;%1&#xa0;» ne peut pas désigner une étude sur un serveur</translation>
    </message>
    <message>
        <source>Qt&apos;s driver for PostgreSQL is not installed</source>
        <translation>le pilote Qt pour PostgreSQL n’est pas installé</translation>
    </message>
    <message>
        <source>the package %1</source>
        <translation>le paquet %1</translation>
    </message>
    <message>
        <source>the server has no study &quot;%1&quot;</source>
        <translation>le serveur n’a pas d’étude «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>one session of a participant at a time</source>
        <translation>une seule session à la fois par participant</translation>
    </message>
    <message>
        <source>another station</source>
        <translation>un autre poste</translation>
    </message>
    <message>
        <source>these trials belong to another study</source>
        <translation>ces essais appartiennent à une autre étude</translation>
    </message>
    <message>
        <source>each questionnaire once</source>
        <translation>chaque questionnaire une seule fois</translation>
    </message>
    <message>
        <source>cannot write the file: %1</source>
        <translation>impossible d’écrire le fichier&#xa0;: %1</translation>
    </message>
    <message>
        <source>cannot remove the file: %1</source>
        <translation>impossible de supprimer le fichier&#xa0;: %1</translation>
    </message>
    <message>
        <source>cannot read the study: %1</source>
        <translation>impossible de lire l’étude&#xa0;: %1</translation>
    </message>
    <message>
        <source>another try in a moment</source>
        <translation>une nouvelle tentative dans un instant</translation>
    </message>
    <message>
        <source>a separate folder for each study</source>
        <translation>un dossier propre à chaque étude</translation>
    </message>
    <message>
        <source>this folder already contains a study</source>
        <translation>ce dossier contient une étude qui y est conservée</translation>
    </message>
    <message>
        <source>this folder belongs to another study, on %1</source>
        <translation>ce dossier est celui d’une autre étude, sur %1</translation>
    </message>
    <message>
        <source>the file does not say which study the folder belongs to</source>
        <translation>ceci ne dit pas à quelle étude le dossier est destiné</translation>
    </message>
    <message>
        <source>this is not the address of a PostgreSQL server</source>
        <translation>ce n’est pas l’adresse d’un serveur PostgreSQL</translation>
    </message>
    <message>
        <source>lower-case letters, digits and _, no digit first</source>
        <translation>des lettres minuscules, des chiffres et _, sans chiffre au début</translation>
    </message>
    <message>
        <source>the program that ran this study was interrupted; its last trials are in %1, which can be read only in a writable folder</source>
        <translation>le programme qui menait cette étude a été interrompu&#xa0;; ses derniers essais sont dans %1, qui ne peut être lu que là où l’on peut écrire</translation>
    </message>
    <message>
        <source>a copy of the whole folder in a writable place</source>
        <translation>une copie du dossier entier à un endroit où l’on peut écrire</translation>
    </message>
    <message>
        <source>this study was made by an older program and cannot be upgraded here</source>
        <translation>un programme plus ancien a créé cette étude, et elle ne peut pas être mise à jour ici</translation>
    </message>
    <message>
        <source>the name of a study on that server</source>
        <translation>le nom d’une étude qui y a été commencée</translation>
    </message>
    <message>
        <source>another station took over this participant while the server was unreachable</source>
        <translation>un autre poste a continué avec ce participant pendant l’absence du serveur</translation>
    </message>
    <message>
        <source>the server still holds the broken connection, and with it this participant</source>
        <translation>le serveur garde encore la connexion rompue, et avec elle ce participant</translation>
    </message>
    <message>
        <source>it is read-only here</source>
        <translation>elle ne peut pas être modifiée ici, seulement consultée</translation>
    </message>
    <message>
        <source>the study is damaged: a session or trial has a number outside its protocol</source>
        <translation>l’étude est endommagée&#xa0;: une session ou un essai a un numéro que son protocole n’a pas</translation>
    </message>
    <message>
        <source>this trial is already stored</source>
        <translation>cet essai est déjà conservé</translation>
    </message>
    <message>
        <source>The trial is safe in %1 and will be sent when the server is back.</source>
        <translation>L’essai est en sûreté dans %1 et sera envoyé au retour du serveur.</translation>
    </message>
    <message>
        <source>this questionnaire belongs elsewhere in the study</source>
        <translation>ce questionnaire appartient à un autre moment de l’étude</translation>
    </message>
    <message>
        <source>this questionnaire has already been answered</source>
        <translation>ce questionnaire a déjà reçu ses réponses</translation>
    </message>
    <message>
        <source>this is not a trial</source>
        <translation>ce n’est pas un essai</translation>
    </message>
    <message>
        <source>a stored trial</source>
        <translation>un essai conservé ici</translation>
    </message>
    <message>
        <source>the study is open for reading only</source>
        <translation>l’étude est ouverte en lecture seule</translation>
    </message>
    <message>
        <source>a folder that can be written to</source>
        <translation>un dossier où l’on peut écrire</translation>
    </message>
    <message>
        <source>the study has no participant &quot;%1&quot;</source>
        <translation>l’étude n’a pas de participant «&#xa0;%1&#xa0;»</translation>
    </message>
</context>
<context>
    <name>StudySweep</name>
    <message>
        <source>&quot;participants&quot; is out of range</source>
        <translation>«&#xa0;participants&#xa0;» est hors de l’intervalle</translation>
    </message>
    <message>
        <source>a whole number from 1 to 1000</source>
        <translation>un entier de 1 à 1000</translation>
    </message>
    <message>
        <source>unknown key &quot;%1&quot;</source>
        <translation>clé inconnue «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>participants, or a key behind &quot;truth.&quot; or &quot;protocol.&quot;</source>
        <translation>participants, ou une clé après «&#xa0;truth.&#xa0;» ou «&#xa0;protocol.&#xa0;»</translation>
    </message>
</context>
<context>
    <name>StudyTruth</name>
    <message>
        <source>cannot open the truth: %1</source>
        <translation>impossible d’ouvrir la vérité&#xa0;: %1</translation>
    </message>
    <message>
        <source>the task %1 shows no spread of its participants: %2</source>
        <translation>la tâche %1 ne montre pas de dispersion de ses participants&#xa0;: %2</translation>
    </message>
    <message>
        <source>a pilot with at least 5 participants, or a file with the truth</source>
        <translation>une étude pilote avec au moins 5 participants, ou un fichier avec la vérité</translation>
    </message>
    <message>
        <source>nothing is assumed of the task %1</source>
        <translation>rien n’est supposé de la tâche %1</translation>
    </message>
    <message>
        <source>condition or threshold</source>
        <translation>condition ou threshold</translation>
    </message>
    <message>
        <source>this study has no test trials yet</source>
        <translation>cette étude n’a pas encore d’essais de test</translation>
    </message>
    <message>
        <source>no task has a threshold and a slope of several participants</source>
        <translation>aucune tâche n’a un seuil et une pente de plusieurs participants</translation>
    </message>
    <message>
        <source>a pilot with at least 2 participants, or a file with the truth</source>
        <translation>une étude pilote avec au moins 2 participants, ou un fichier avec la vérité</translation>
    </message>
</context>
<context>
    <name>StudyWatermark</name>
    <message>
        <source>PILOT</source>
        <translation>PILOTE</translation>
    </message>
    <message>
        <source>SIMULATED</source>
        <translation>SIMULÉ</translation>
    </message>
</context>
<context>
    <name>StudyWriting</name>
    <message>
        <source>Results of the study</source>
        <translation>Résultats de l’étude</translation>
    </message>
</context>
<context>
    <name>SweepCommand</name>
    <message>
        <source>Sweep file: what runs, with which settings and seeds</source>
        <translation>Fichier de balayage&#xa0;: ce qui s’exécute, avec quels réglages et quelles graines</translation>
    </message>
    <message>
        <source>Folder for runs.csv, cells.csv, figures and sweep.json; a sweep that was interrupted goes on in it</source>
        <translation>Dossier pour runs.csv, cells.csv, figures et sweep.json&#xa0;; un balayage interrompu y reprend</translation>
    </message>
    <message>
        <source>Runs at the same time; otherwise as many as the machine has cores</source>
        <translation>Exécutions simultanées&#xa0;; sinon autant que la machine a de cœurs</translation>
    </message>
    <message>
        <source>Throw away what the folder has of an earlier sweep</source>
        <translation>Jeter ce que le dossier contient d’un balayage antérieur</translation>
    </message>
    <message>
        <source>Share of the runs that may fail before this counts as an error</source>
        <translation>Part des exécutions qui peuvent échouer avant que cela compte comme erreur</translation>
    </message>
    <message>
        <source>Write the tactile frames with contacts, forces and objects to DIR/frames</source>
        <translation>Écrire les images tactiles avec contacts, forces et objets dans DIR/frames</translation>
    </message>
    <message>
        <source>Say how far the sweep in this folder has come</source>
        <translation>Dire où en est le balayage de ce dossier</translation>
    </message>
    <message>
        <source>Only merge the results that are there, as each run of this command does at its end</source>
        <translation>Fusionner seulement les résultats présents, comme chaque exécution de cette commande le fait à la fin</translation>
    </message>
    <message>
        <source>Run it as an array of jobs of Slurm on a cluster</source>
        <translation>L’exécuter comme tableau de travaux Slurm sur une grappe de calcul</translation>
    </message>
    <message>
        <source>Of Slurm: tasks of the array</source>
        <translation>De Slurm&#xa0;: tâches du tableau</translation>
    </message>
    <message>
        <source>Of Slurm: runs of one task</source>
        <translation>De Slurm&#xa0;: exécutions d’une tâche</translation>
    </message>
    <message>
        <source>Of Slurm: an option of sbatch, such as --partition=short; may come again</source>
        <translation>De Slurm&#xa0;: une option de sbatch, comme --partition=short&#xa0;; peut être répétée</translation>
    </message>
    <message>
        <source>Of Slurm: wait until all is done and merged</source>
        <translation>De Slurm&#xa0;: attendre que tout soit fait et fusionné</translation>
    </message>
    <message>
        <source>Do the share of this task of --tasks, from 0, as the jobs of Slurm do</source>
        <translation>Faire la part de cette tâche parmi --tasks, à partir de 0, comme les travaux de Slurm</translation>
    </message>
    <message>
        <source>is required</source>
        <translation>est requis</translation>
    </message>
    <message>
        <source>is not below the number of tasks, %1</source>
        <translation>n’est pas inférieur au nombre de tâches, %1</translation>
    </message>
    <message>
        <source>is for scenes of an array or a servo</source>
        <translation>est pour les scènes d’une matrice ou d’un asservissement</translation>
    </message>
    <message>
        <source>a sweep file, or one of: %1</source>
        <translation>un fichier de balayage, ou l’un de&#xa0;: %1</translation>
    </message>
    <message>
        <source>%1 of %2 runs are missing</source>
        <translation>%1 exécutions sur %2 manquent</translation>
    </message>
    <message>
        <source>the same command without --merge, which goes on with them</source>
        <translation>la même commande sans --merge, qui les reprend</translation>
    </message>
    <message>
        <source>%1 of %2 runs failed; runs.csv has the reasons</source>
        <translation>%1 exécutions sur %2 ont échoué&#xa0;; runs.csv donne les raisons</translation>
    </message>
    <message>
        <source>at most %1 (see --allow-failed)</source>
        <translation>au plus %1 (voir --allow-failed)</translation>
    </message>
    <message>
        <source>Job</source>
        <translation>Travail</translation>
    </message>
    <message>
        <source>Tasks</source>
        <translation>Tâches</translation>
    </message>
    <message>
        <source>Merging job</source>
        <translation>Travail de fusion</translation>
    </message>
    <message>
        <source>How far it is</source>
        <translation>Où il en est</translation>
    </message>
    <message>
        <source>Run a scene over a grid of settings and seeds, here or on a cluster</source>
        <translation>Exécuter une scène sur une grille de réglages et de graines, ici ou sur une grappe de calcul</translation>
    </message>
    <message>
        <source>needs --slurm or --task</source>
        <translation>a besoin de --slurm ou --task</translation>
    </message>
</context>
<context>
    <name>SweepFigure</name>
    <message>
        <source>Bars: Wilson&apos;s 95 % interval of the share.</source>
        <translation>Barres&#xa0;: intervalle de Wilson à 95&#xa0;% de la part.</translation>
    </message>
    <message>
        <source>Points: means with their 95 % interval. Dotted: 5 and 95 % of the runs.</source>
        <translation>Points&#xa0;: moyennes avec leur intervalle à 95&#xa0;%. Pointillés&#xa0;: 5 et 95&#xa0;% des exécutions.</translation>
    </message>
    <message>
        <source>Means. The first %1 of %2 maps.</source>
        <translation>Moyennes. Les %1 premières de %2 cartes.</translation>
    </message>
    <message>
        <source>Means. Crossed out: no run has it.</source>
        <translation>Moyennes. Barré&#xa0;: aucune exécution ne l’a.</translation>
    </message>
</context>
<context>
    <name>SweepFolderText</name>
    <message>
        <source>the folder holds results of another sweep: %1</source>
        <translation>le dossier contient les résultats d’un autre balayage&#xa0;: %1</translation>
    </message>
    <message>
        <source>another folder, or --restart, which throws these results away</source>
        <translation>un autre dossier, ou --restart, qui jette ces résultats</translation>
    </message>
    <message>
        <source>line %1 was &quot;%2&quot; and is &quot;%3&quot;</source>
        <translation>la ligne %1 était «&#xa0;%2&#xa0;» et est «&#xa0;%3&#xa0;»</translation>
    </message>
    <message>
        <source>only the spaces differ</source>
        <translation>seuls les espaces diffèrent</translation>
    </message>
    <message>
        <source>earlier results cannot be removed</source>
        <translation>les résultats antérieurs ne peuvent pas être supprimés</translation>
    </message>
    <message>
        <source>what it runs has changed, %1</source>
        <translation>ce qu’il exécute a changé, %1</translation>
    </message>
    <message>
        <source>they are of version %1, this is %2</source>
        <translation>ils sont de la version %1, celle-ci est %2</translation>
    </message>
    <message>
        <source>they have frames</source>
        <translation>ils ont des images tactiles</translation>
    </message>
    <message>
        <source>they have no frames</source>
        <translation>ils n’ont pas d’images tactiles</translation>
    </message>
    <message>
        <source>the folder holds other files</source>
        <translation>le dossier contient d’autres fichiers</translation>
    </message>
    <message>
        <source>a new or empty folder, or one of a sweep</source>
        <translation>un dossier nouveau ou vide, ou celui d’un balayage</translation>
    </message>
    <message>
        <source>this describes no sweep</source>
        <translation>cela ne décrit aucun balayage</translation>
    </message>
    <message>
        <source>a file that teleta sweep has written</source>
        <translation>un fichier écrit par teleta sweep</translation>
    </message>
</context>
<context>
    <name>SweepParts</name>
    <message>
        <source>the file cannot be made: %1</source>
        <translation>le fichier ne peut pas être créé&#xa0;: %1</translation>
    </message>
    <message>
        <source>this is no part of a sweep</source>
        <translation>ce n’est pas une partie d’un balayage</translation>
    </message>
    <message>
        <source>this is no row of a sweep</source>
        <translation>ce n’est pas une ligne d’un balayage</translation>
    </message>
    <message>
        <source>the number of a run and its times</source>
        <translation>le numéro d’une exécution et ses temps</translation>
    </message>
    <message>
        <source>this is no number</source>
        <translation>ce n’est pas un nombre</translation>
    </message>
    <message>
        <source>a number or NA</source>
        <translation>un nombre ou NA</translation>
    </message>
    <message>
        <source>a part has the run %1</source>
        <translation>une partie contient l’exécution %1</translation>
    </message>
    <message>
        <source>runs from 0 to %1</source>
        <translation>les exécutions de 0 à %1</translation>
    </message>
</context>
<context>
    <name>SweepPlan</name>
    <message>
        <source>a range with scale &quot;log10&quot; reaches 0 or below</source>
        <translation>un intervalle d’échelle «&#xa0;log10&#xa0;» atteint 0 ou moins</translation>
    </message>
    <message>
        <source>the key &quot;%1&quot; is varied twice</source>
        <translation>la clé «&#xa0;%1&#xa0;» varie deux fois</translation>
    </message>
    <message>
        <source>each key once</source>
        <translation>chaque clé une fois</translation>
    </message>
    <message>
        <source>keys that go together have unlike numbers of values: %1 and %2</source>
        <translation>des clés qui vont ensemble ont des nombres de valeurs différents&#xa0;: %1 et %2</translation>
    </message>
    <message>
        <source>%1 values, as the first key has</source>
        <translation>%1 valeurs, comme la première clé</translation>
    </message>
    <message>
        <source>a sweep runs one thing</source>
        <translation>un balayage exécute une seule chose</translation>
    </message>
    <message>
        <source>one of: scene, study, ladder</source>
        <translation>l’un de&#xa0;: scene, study, ladder</translation>
    </message>
    <message>
        <source>these are no seeds</source>
        <translation>ce ne sont pas des graines</translation>
    </message>
    <message>
        <source>&quot;FIRST:LAST&quot;, such as &quot;1:200&quot;</source>
        <translation>«&#xa0;FIRST:LAST&#xa0;», comme «&#xa0;1:200&#xa0;»</translation>
    </message>
    <message>
        <source>the sweep has %1 runs</source>
        <translation>le balayage a %1 exécutions</translation>
    </message>
    <message>
        <source>at most %1</source>
        <translation>au plus %1</translation>
    </message>
</context>
<context>
    <name>SweepReport</name>
    <message>
        <source>%1 of %2 runs, %3 failed, %4 left</source>
        <translation>%1 exécutions sur %2, %3 échouées, encore %4</translation>
    </message>
    <message>
        <source>Worst cells so far:</source>
        <translation>Pires cellules jusqu’ici&#xa0;:</translation>
    </message>
    <message>
        <source>%1 of %2 failed; </source>
        <translation>%1 sur %2 échouées&#xa0;; </translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>Dossier</translation>
    </message>
    <message>
        <source>Runs</source>
        <translation>Exécutions</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 sur %2</translation>
    </message>
    <message>
        <source>Failed</source>
        <translation>Échouées</translation>
    </message>
    <message>
        <source>Cells</source>
        <translation>Cellules</translation>
    </message>
    <message>
        <source>Processor time</source>
        <translation>Temps de processeur</translation>
    </message>
    <message>
        <source>%1 to %2 (means of the cells)</source>
        <translation>%1 à %2 (moyennes des cellules)</translation>
    </message>
</context>
<context>
    <name>SweepRunner</name>
    <message>
        <source>a run has no measure &quot;%1&quot;</source>
        <translation>une exécution n’a pas de mesure «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>of: %1</source>
        <translation>parmi&#xa0;: %1</translation>
    </message>
    <message>
        <source>this has no frames of a tactile array</source>
        <translation>ceci n’a pas d’images d’une matrice tactile</translation>
    </message>
    <message>
        <source>a scene of an array or a servo</source>
        <translation>une scène d’une matrice ou d’un asservissement</translation>
    </message>
</context>
<context>
    <name>TableText</name>
    <message>
        <source>the recording has no frames</source>
        <translation>l’enregistrement n’a pas de trames</translation>
    </message>
    <message>
        <source>at least one row of numbers</source>
        <translation>au moins une ligne de nombres</translation>
    </message>
    <message>
        <source>there is no column %1</source>
        <translation>il n’y a pas de colonne&#xa0;%1</translation>
    </message>
    <message>
        <source>a number from 1 to %1; the table has no header</source>
        <translation>un nombre de 1 à&#xa0;%1&#xa0;; le tableau n’a pas d’en-tête</translation>
    </message>
    <message>
        <source>one of %1, or a number from 1 to %2</source>
        <translation>l’un de&#xa0;%1, ou un nombre de 1 à&#xa0;%2</translation>
    </message>
    <message>
        <source>the table has %1 columns, %2..%3 are asked for</source>
        <translation>le tableau a&#xa0;%1 colonnes,&#xa0;%2..%3 sont demandées</translation>
    </message>
    <message>
        <source>columns from 1 to %1</source>
        <translation>des colonnes de 1 à&#xa0;%1</translation>
    </message>
    <message>
        <source>the table has %1 columns of taxels</source>
        <translation>le tableau a&#xa0;%1 colonnes de taxels</translation>
    </message>
    <message>
        <source>from 1 to %1</source>
        <translation>de 1 à&#xa0;%1</translation>
    </message>
    <message>
        <source>column %1 is that of the times, and one of the taxels</source>
        <translation>la colonne&#xa0;%1 est celle des temps et l’une de celles des taxels</translation>
    </message>
    <message>
        <source>either</source>
        <translation>l’un ou l’autre</translation>
    </message>
    <message>
        <source>a row of the table</source>
        <translation>une ligne du tableau</translation>
    </message>
    <message>
        <source>a column of times and a rate</source>
        <translation>une colonne des temps et une fréquence</translation>
    </message>
    <message>
        <source>the column of the times (--time-column NAME), or frames per second (--rate HZ)</source>
        <translation>la colonne des temps (--time-column NAME), ou des trames par seconde (--rate HZ)</translation>
    </message>
    <message>
        <source>the unit %1 of the times</source>
        <translation>l’unité&#xa0;%1 des temps</translation>
    </message>
    <message>
        <source>the row has %1 values</source>
        <translation>la ligne a&#xa0;%1 valeurs</translation>
    </message>
    <message>
        <source>one value per column: %1</source>
        <translation>une valeur par colonne&#xa0;:&#xa0;%1</translation>
    </message>
    <message>
        <source>the table is too long</source>
        <translation>le tableau est trop long</translation>
    </message>
    <message>
        <source>at most %1 values</source>
        <translation>au plus&#xa0;%1 valeurs</translation>
    </message>
    <message>
        <source>the time goes back</source>
        <translation>le temps recule</translation>
    </message>
    <message>
        <source>times that do not decrease</source>
        <translation>des temps non décroissants</translation>
    </message>
    <message>
        <source>%1 is not a number</source>
        <translation>%1 n’est pas un nombre</translation>
    </message>
    <message>
        <source>a number, nan, inf or NA</source>
        <translation>un nombre, nan, inf ou NA</translation>
    </message>
    <message>
        <source>%1 is not a time</source>
        <translation>%1 n’est pas un temps</translation>
    </message>
    <message>
        <source>a number, or --time-unit iso</source>
        <translation>un nombre, ou --time-unit iso</translation>
    </message>
    <message>
        <source>a finite number</source>
        <translation>un nombre fini</translation>
    </message>
    <message>
        <source>a date and time such as 2026-05-01T12:00:00.5</source>
        <translation>une date et une heure comme 2026-05-01T12:00:00.5</translation>
    </message>
</context>
<context>
    <name>TaxelGainFile</name>
    <message>
        <source>taxel %1 is missing</source>
        <translation>le taxel %1 manque</translation>
    </message>
    <message>
        <source>the taxels 0 to %1</source>
        <translation>les taxels 0 à %1</translation>
    </message>
    <message>
        <source>the %1 is &quot;%2&quot;</source>
        <comment>a column of a table</comment>
        <translation>«&#xa0;%1&#xa0;» vaut «&#xa0;%2&#xa0;»</translation>
    </message>
    <message>
        <source>a whole number from 0 to %1</source>
        <translation>un nombre entier de 0 à %1</translation>
    </message>
    <message>
        <source>%1, in an array of %2 rows x %3 columns</source>
        <translation>%1, dans une matrice de %2 lignes x %3 colonnes</translation>
    </message>
    <message>
        <source>each taxel once</source>
        <translation>chaque taxel une fois</translation>
    </message>
    <message>
        <source>a number from %1 to %2, or NA</source>
        <translation>un nombre de %1 à %2, ou NA</translation>
    </message>
    <message>
        <source>the state does not fit the gain</source>
        <translation>l’état ne correspond pas au gain</translation>
    </message>
    <message>
        <source>taxel %1 is listed in row %2, column %3</source>
        <translation>le taxel %1 serait à la ligne %2, colonne %3</translation>
    </message>
    <message>
        <source>taxel %1 is listed twice</source>
        <translation>le taxel %1 figure deux fois</translation>
    </message>
    <message>
        <source>the gain is not a number or out of range</source>
        <translation>le gain est hors limites ou n’est pas un nombre</translation>
    </message>
    <message>
        <source>the standard error is not a number or out of range</source>
        <translation>l’erreur type est hors limites ou n’est pas un nombre</translation>
    </message>
    <message>
        <source>a number of at least 0, or NA</source>
        <translation>un nombre à partir de 0, ou NA</translation>
    </message>
</context>
<context>
    <name>TaxelGains</name>
    <message>
        <source>Only %1 of %2 taxels feel the load.</source>
        <translation>Seuls %1 des %2 taxels ressentent la charge.</translation>
    </message>
    <message>
        <source>Only %1 frames are under load.</source>
        <translation>Seules %1 trames sont sous charge.</translation>
    </message>
    <message>
        <source>at least %1</source>
        <translation>au moins %1</translation>
    </message>
    <message>
        <source>There is no press.</source>
        <translation>Il n’y a pas d’appui.</translation>
    </message>
    <message>
        <source>at least one</source>
        <translation>au moins un</translation>
    </message>
    <message>
        <source>a multiple of %1</source>
        <translation>un multiple de %1</translation>
    </message>
    <message>
        <source>No taxel is good in all presses.</source>
        <translation>Aucun taxel n’est bon dans tous les appuis.</translation>
    </message>
    <message>
        <source>presses of the whole array</source>
        <translation>des appuis sur toute la matrice</translation>
    </message>
    <message>
        <source>Most taxels read the same value in all frames: %1.</source>
        <translation>La plupart des taxels donnent la même valeur dans toutes les trames&#xa0;: %1.</translation>
    </message>
    <message>
        <source>a load that the taxels can measure</source>
        <translation>une charge que les taxels peuvent mesurer</translation>
    </message>
    <message>
        <source>at least %1, under a smaller load</source>
        <translation>au moins %1, sous une charge plus faible</translation>
    </message>
    <message>
        <source>a load on the whole array, and a tare taken without load</source>
        <translation>une charge sur toute la matrice, et une tare sans charge</translation>
    </message>
    <message>
        <source>Only %1 frames under load are within the range of the taxels.</source>
        <translation>Sauf dans %1 trames sous charge, les taxels sont au bout de leur plage.</translation>
    </message>
    <message>
        <source>The frames have %1 values in total.</source>
        <translation>Les trames ont %1 valeurs en tout.</translation>
    </message>
</context>
<context>
    <name>TaxelsReportText</name>
    <message>
        <source>Frames found</source>
        <translation>Trames trouvées</translation>
    </message>
    <message>
        <source>Bytes of frames</source>
        <translation>Octets des trames</translation>
    </message>
    <message>
        <source>Bytes outside frames</source>
        <translation>Octets hors des trames</translation>
    </message>
    <message>
        <source>Wrong checksums</source>
        <translation>Sommes de contrôle fausses</translation>
    </message>
    <message>
        <source>Wrong lengths</source>
        <translation>Longueurs fausses</translation>
    </message>
    <message>
        <source>Wrong closing bytes</source>
        <translation>Octets de fin faux</translation>
    </message>
    <message>
        <source>Unreadable values</source>
        <translation>Valeurs illisibles</translation>
    </message>
    <message>
        <source>Frames of another length</source>
        <translation>Trames d’une autre longueur</translation>
    </message>
    <message>
        <source>Bytes (&gt; begins a frame)</source>
        <translation>Octets (&gt; débute une trame)</translation>
    </message>
    <message>
        <source>First frame in %1, the last row first</source>
        <translation>Première trame en %1, la dernière ligne d’abord</translation>
    </message>
    <message>
        <source>First frame: taxel, x and y in mm, and its x, y and z in %1</source>
        <translation>Première trame&#xa0;: taxel, x et y en mm, et ses x, y et z en %1</translation>
    </message>
    <message>
        <source>First frame: taxel, x and y in mm, and its load in %1</source>
        <translation>Première trame&#xa0;: taxel, x et y en mm, et sa charge en %1</translation>
    </message>
</context>
<context>
    <name>TaxelsText</name>
    <message>
        <source>up to %1 bytes, as &quot;AA 55&quot;</source>
        <translation>au plus %1 octets, comme «&#xa0;AA 55&#xa0;»</translation>
    </message>
    <message numerus="yes">
        <source>%n byte(s) from %1 on are not in the frame</source>
        <translation>
            <numerusform>%n octet à partir de %1 n’est pas dans la trame</numerusform>
            <numerusform>%n octets à partir de %1 ne sont pas dans la trame</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>a place in a frame of %n byte(s)</source>
        <translation>
            <numerusform>une place dans une trame de %n octet</numerusform>
            <numerusform>une place dans une trame de %n octets</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n byte(s) from %1 on are in no frame</source>
        <translation>
            <numerusform>%n octet à partir de %1 n’est dans aucune trame</numerusform>
            <numerusform>%n octets à partir de %1 ne sont dans aucune trame</numerusform>
        </translation>
    </message>
    <message>
        <source>a place in the frame; a negative one counts from its end</source>
        <translation>une place dans la trame&#xa0;; négative, elle compte à partir de la fin</translation>
    </message>
    <message>
        <source>the checksum covers no byte of the frame</source>
        <translation>la somme de contrôle ne couvre aucun octet de la trame</translation>
    </message>
    <message>
        <source>&quot;from&quot; before &quot;to&quot;</source>
        <translation>«&#xa0;from&#xa0;» avant «&#xa0;to&#xa0;»</translation>
    </message>
    <message>
        <source>the checksum covers itself</source>
        <translation>la somme de contrôle se couvre elle-même</translation>
    </message>
    <message>
        <source>bytes before or behind it</source>
        <translation>des octets avant ou après elle</translation>
    </message>
    <message>
        <source>with a factor of 0 every value is the same</source>
        <translation>avec un facteur 0, toutes les valeurs sont égales</translation>
    </message>
    <message>
        <source>another number</source>
        <translation>un autre nombre</translation>
    </message>
    <message>
        <source>%1 numbers are not %2 for each taxel</source>
        <translation>%1 nombres ne font pas %2 par taxel</translation>
    </message>
    <message>
        <source>a multiple of %1</source>
        <translation>un multiple de %1</translation>
    </message>
    <message>
        <source>a taxel has more bytes than that</source>
        <translation>un taxel a plus d’octets que cela</translation>
    </message>
    <message>
        <source>at least %1, or 0</source>
        <translation>au moins %1, ou 0</translation>
    </message>
    <message>
        <source>the length of a frame is not clear</source>
        <translation>la longueur d’une trame n’est pas claire</translation>
    </message>
    <message>
        <source>either length or length_field</source>
        <translation>soit length, soit length_field</translation>
    </message>
    <message>
        <source>the first and last bytes are longer than the frame</source>
        <translation>les premiers et derniers octets sont plus longs que la trame</translation>
    </message>
    <message>
        <source>at least %1</source>
        <translation>au moins %1</translation>
    </message>
    <message>
        <source>nothing shows where a frame begins</source>
        <translation>rien n’indique où débute une trame</translation>
    </message>
    <message>
        <source>sync, end or a checksum</source>
        <translation>sync, end ou une somme de contrôle</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot separate numbers</source>
        <translation>«&#xa0;%1&#xa0;» ne peut pas séparer des nombres</translation>
    </message>
    <message>
        <source>one character</source>
        <translation>un caractère</translation>
    </message>
    <message>
        <source>&quot;%1&quot; names no columns</source>
        <translation>«&#xa0;%1&#xa0;» ne désigne aucune colonne</translation>
    </message>
    <message>
        <source>the first and the last column, as &quot;2..85&quot;</source>
        <translation>la première et la dernière colonne, comme «&#xa0;2..85&#xa0;»</translation>
    </message>
    <message>
        <source>a column cannot be a value and the time</source>
        <translation>une colonne ne peut pas être à la fois une valeur et l’heure</translation>
    </message>
    <message>
        <source>a column outside &quot;columns&quot;</source>
        <translation>une colonne hors de «&#xa0;columns&#xa0;»</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no JSON pointer</source>
        <translation>«&#xa0;%1&#xa0;» n’est pas un pointeur JSON</translation>
    </message>
    <message>
        <source>a path as &quot;/sensors/0/data&quot;</source>
        <translation>un chemin comme «&#xa0;/sensors/0/data&#xa0;»</translation>
    </message>
    <message>
        <source>a taxel tells its load or three components</source>
        <translation>un taxel donne sa charge ou trois composantes</translation>
    </message>
    <message>
        <source>1 or 3</source>
        <translation>1 ou 3</translation>
    </message>
    <message>
        <source>each axis once with its sign, as [&quot;+x&quot;, &quot;-y&quot;, &quot;-z&quot;]</source>
        <translation>chaque axe une fois avec son signe, comme [&quot;+x&quot;, &quot;-y&quot;, &quot;-z&quot;]</translation>
    </message>
    <message>
        <source>these are no places of taxels</source>
        <translation>ce ne sont pas des places de taxels</translation>
    </message>
    <message>
        <source>&quot;places&quot; says already where no taxel is</source>
        <translation>«&#xa0;places&#xa0;» dit déjà où il n’y a pas de taxel</translation>
    </message>
    <message>
        <source>either places or mask</source>
        <translation>soit places, soit mask</translation>
    </message>
    <message>
        <source>The sensor has sent no usable frame for %1 s.</source>
        <translation>Le capteur n’a pas envoyé de trame utilisable depuis %1 s.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no address of a WebSocket server</source>
        <translation>«&#xa0;%1&#xa0;» n’est pas l’adresse d’un serveur WebSocket</translation>
    </message>
    <message>
        <source>ws://HOST:PORT or wss://HOST:PORT</source>
        <translation>ws://HOST:PORT ou wss://HOST:PORT</translation>
    </message>
    <message>
        <source>it is given as text already</source>
        <translation>c’est déjà donné sous forme de texte</translation>
    </message>
    <message>
        <source>either %1 or %2</source>
        <translation>soit %1, soit %2</translation>
    </message>
    <message>
        <source>a frame has %1 numbers, but the layout has %2 taxels with %3 each</source>
        <translation>une trame a %1 nombres, mais la disposition a %2 taxels de %3 nombres chacun</translation>
    </message>
    <message>
        <source>%1 numbers</source>
        <translation>%1 nombres</translation>
    </message>
    <message>
        <source>without a threshold it is not known which taxels are touched</source>
        <translation>sans seuil, on ne sait pas quels taxels sont touchés</translation>
    </message>
    <message>
        <source>opening was cancelled</source>
        <translation>l’ouverture a été annulée</translation>
    </message>
    <message>
        <source>numbers from 0 to %1, and at least one place with a taxel</source>
        <translation>des nombres de 0 à %1, et au moins une place avec un taxel</translation>
    </message>
    <message>
        <source>numbers from 0 to %1, each once</source>
        <translation>des nombres de 0 à %1, chacun une fois</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a list of hexadecimal bytes</source>
        <translation>«&#xa0;%1&#xa0;» n’est pas une liste d’octets hexadécimaux</translation>
    </message>
    <message>
        <source>threshold = a number in the unit of the values</source>
        <translation>threshold = un nombre dans l’unité des valeurs</translation>
    </message>
    <message>
        <source>only %1 of %2 frames arrived while the tare was measured</source>
        <translation>seules %1 trames sur %2 sont arrivées pendant la mesure de la tare</translation>
    </message>
    <message>
        <source>frames as the file describes; check with teleta devices --probe FILE</source>
        <translation>des trames telles que le fichier les décrit&#xa0;; vérifiez avec teleta devices --probe FILE</translation>
    </message>
    <message>
        <source>there are %1 positions</source>
        <translation>il y a %1 positions</translation>
    </message>
    <message>
        <source>one entry a position</source>
        <translation>une entrée par position</translation>
    </message>
    <message>
        <source>at most %1; more of them on a grid</source>
        <translation>au plus %1&#xa0;; davantage sur une grille</translation>
    </message>
    <message>
        <source>other numbers than [0, 0, 0]</source>
        <translation>d’autres nombres que [0, 0, 0]</translation>
    </message>
    <message>
        <source>taxels %1 and %2 are at the same place</source>
        <translation>les taxels %1 et %2 sont au même endroit</translation>
    </message>
    <message>
        <source>different places; they count from 0</source>
        <translation>des positions différentes&#xa0;; elles comptent à partir de 0</translation>
    </message>
    <message>
        <source>a normal is zero</source>
        <translation>une normale est nulle</translation>
    </message>
    <message>
        <source>these are not three distinct axes</source>
        <translation>ce ne sont pas trois axes différents</translation>
    </message>
    <message>
        <source>this mask does not fit the array</source>
        <translation>ce masque ne convient pas à la matrice</translation>
    </message>
</context>
<context>
    <name>TekscanText</name>
    <message>
        <source>the recording has no frames</source>
        <translation>l’enregistrement n’a pas de trames</translation>
    </message>
    <message>
        <source>the file ends after frame %1 of %2</source>
        <translation>le fichier se termine après la trame&#xa0;%1 sur&#xa0;%2</translation>
    </message>
    <message>
        <source>a whole file</source>
        <translation>un fichier entier</translation>
    </message>
    <message>
        <source>the file ends within its head</source>
        <translation>le fichier se termine dans son en-tête</translation>
    </message>
    <message>
        <source>the head has no line %1</source>
        <translation>l’en-tête n’a pas de ligne&#xa0;%1</translation>
    </message>
    <message>
        <source>a whole number from 1 to %1</source>
        <translation>un nombre entier de 1 à&#xa0;%1</translation>
    </message>
    <message>
        <source>a number above 0 in mm or cm</source>
        <translation>un nombre supérieur à 0 en mm ou cm</translation>
    </message>
    <message>
        <source>%1 rows x %2 columns, as was asked for</source>
        <translation>%1 lignes x&#xa0;%2 colonnes, comme demandé</translation>
    </message>
    <message>
        <source>a number above 0 in mm2 or cm2</source>
        <translation>un nombre supérieur à 0 en mm2 ou cm2</translation>
    </message>
    <message>
        <source>RAW, or a unit of pressure such as kPa or PSI</source>
        <translation>RAW, ou une unité de pression comme kPa ou PSI</translation>
    </message>
    <message>
        <source>the area with which a pressure makes a force</source>
        <translation>l’aire avec laquelle une pression donne une force</translation>
    </message>
    <message>
        <source>a number above 0, or frames per second (--rate HZ)</source>
        <translation>un nombre supérieur à 0, ou des trames par seconde (--rate HZ)</translation>
    </message>
    <message>
        <source>the line is %1</source>
        <translation>la ligne est&#xa0;%1</translation>
    </message>
    <message>
        <source>the frame has no number</source>
        <translation>la trame n’a pas de numéro</translation>
    </message>
    <message>
        <source>frame %1 comes after frame %2</source>
        <translation>la trame&#xa0;%1 vient après la trame&#xa0;%2</translation>
    </message>
    <message>
        <source>numbers that grow</source>
        <translation>des numéros croissants</translation>
    </message>
    <message>
        <source>the recording is too long</source>
        <translation>l’enregistrement est trop long</translation>
    </message>
    <message>
        <source>at most %1 values</source>
        <translation>au plus&#xa0;%1 valeurs</translation>
    </message>
    <message>
        <source>frame %1 ends after %2 of %3 rows</source>
        <translation>la trame&#xa0;%1 se termine après&#xa0;%2 lignes sur&#xa0;%3</translation>
    </message>
    <message>
        <source>a whole frame</source>
        <translation>une trame entière</translation>
    </message>
    <message>
        <source>the row has %1 values</source>
        <translation>la ligne a&#xa0;%1 valeurs</translation>
    </message>
    <message>
        <source>%1 values</source>
        <translation>%1 valeurs</translation>
    </message>
    <message>
        <source>%1 is not a number</source>
        <translation>%1 n’est pas un nombre</translation>
    </message>
    <message>
        <source>a number or B</source>
        <translation>un nombre ou B</translation>
    </message>
</context>
<context>
    <name>TextLinesText</name>
    <message>
        <source>the line is longer than 16 MiB</source>
        <translation>la ligne dépasse 16 MiB</translation>
    </message>
    <message>
        <source>a line end</source>
        <translation>une fin de ligne</translation>
    </message>
    <message>
        <source>the line has a byte 0, which no text has</source>
        <translation>la ligne a un octet 0, qu’aucun texte ne contient</translation>
    </message>
    <message>
        <source>text</source>
        <translation>du texte</translation>
    </message>
</context>
<context>
    <name>ThresholdPlan</name>
    <message>
        <source>the protocol has no task &quot;%1&quot;</source>
        <translation>le protocole n’a pas de tâche «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>TASK:threshold with the id of a task with levels</source>
        <translation>TASK:threshold avec l’identifiant d’une tâche à niveaux</translation>
    </message>
    <message>
        <source>the task %1 has no levels</source>
        <translation>la tâche %1 n’a pas de niveaux</translation>
    </message>
    <message>
        <source>a task that measures a threshold</source>
        <translation>une tâche qui mesure un seuil</translation>
    </message>
    <message>
        <source>the truth says nothing of the threshold of %1</source>
        <translation>la vérité ne dit rien du seuil de %1</translation>
    </message>
    <message>
        <source>a [[task]] with that id and a threshold</source>
        <translation>un [[task]] avec cet identifiant et un seuil</translation>
    </message>
    <message>
        <source>the threshold of %1 cannot be 0</source>
        <translation>le seuil de %1 ne peut pas être 0</translation>
    </message>
    <message>
        <source>a level above 0, since the scale is log10</source>
        <translation>un niveau supérieur à 0, puisque l’échelle est log10</translation>
    </message>
</context>
<context>
    <name>ThresholdSection</name>
    <message>
        <source>open</source>
        <comment>end of an interval</comment>
        <translation>ouvert</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <comment>interval</comment>
        <translation>%1 à %2</translation>
    </message>
    <message>
        <source>Participant</source>
        <translation>Participant</translation>
    </message>
    <message>
        <source>Condition</source>
        <translation>Condition</translation>
    </message>
    <message>
        <source>Track</source>
        <translation>Série</translation>
    </message>
    <message>
        <source>Each participant; intervals of 95 % by profile likelihood unless the tables say otherwise</source>
        <translation>Chaque participant&#xa0;; intervalles à 95&#xa0;% par vraisemblance profilée, sauf indication contraire des tableaux</translation>
    </message>
    <message>
        <source>Trials</source>
        <translation>Essais</translation>
    </message>
    <message>
        <source>Threshold</source>
        <translation>Seuil</translation>
    </message>
    <message>
        <source>95 %</source>
        <translation>95&#xa0;%</translation>
    </message>
    <message>
        <source>Slope or spread</source>
        <translation>Pente ou dispersion</translation>
    </message>
    <message>
        <source>Just noticeable difference</source>
        <translation>Différence juste perceptible</translation>
    </message>
    <message>
        <source>Weber fraction</source>
        <translation>Fraction de Weber</translation>
    </message>
    <message>
        <source>p of the deviance</source>
        <translation>p de la déviance</translation>
    </message>
    <message>
        <source>Estimate of the procedure</source>
        <translation>Estimation de la procédure</translation>
    </message>
    <message>
        <source>Remark</source>
        <translation>Remarque</translation>
    </message>
    <message>
        <source>All participants: the mean of their thresholds with Student&apos;s t interval, and one fit of all with a threshold for each</source>
        <translation>Tous les participants&#xa0;: la moyenne de leurs seuils avec l’intervalle du t de Student, et un ajustement commun avec un seuil pour chacun</translation>
    </message>
    <message>
        <source>Participants</source>
        <translation>Participants</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Moyenne</translation>
    </message>
    <message>
        <source>One fit of all</source>
        <translation>Ajustement commun</translation>
    </message>
    <message>
        <source>Spread of the participants</source>
        <translation>Dispersion des participants</translation>
    </message>
    <message>
        <source>no fit of all: %1</source>
        <translation>pas d’ajustement commun&#xa0;:&#xa0;%1</translation>
    </message>
    <message>
        <source>Intensities that can be told apart, from the start of the motor to its full drive</source>
        <translation>Intensités qui peuvent être distinguées, du démarrage du moteur à sa pleine commande</translation>
    </message>
    <message>
        <source>References</source>
        <translation>Références</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Pas</translation>
    </message>
    <message>
        <source>fewer than three times</source>
        <translation>moins de trois temps</translation>
    </message>
    <message>
        <source>the share of yes has no highest point</source>
        <translation>la part de oui n’a pas de point le plus haut</translation>
    </message>
    <message>
        <source>the highest point is outside the times that were shown</source>
        <translation>le point le plus haut est en dehors des temps présentés</translation>
    </message>
    <message>
        <source>The time from burst to burst with the most yes, s</source>
        <translation>Le temps d’une salve à la suivante avec le plus de oui, s</translation>
    </message>
    <message>
        <source>Best</source>
        <translation>Meilleur</translation>
    </message>
    <message>
        <source>Sensitivity d&apos; and criterion c over all levels</source>
        <translation>Sensibilité d&apos; et critère c sur tous les niveaux</translation>
    </message>
    <message>
        <source>Hits</source>
        <translation>Détections correctes</translation>
    </message>
    <message>
        <source>False alarms</source>
        <translation>Fausses alarmes</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Méthode</translation>
    </message>
    <message>
        <source>Mean of %1</source>
        <translation>Moyenne de %1</translation>
    </message>
    <message>
        <source>as in the data</source>
        <translation>comme dans les données</translation>
    </message>
    <message>
        <source>Thresholds: %1</source>
        <translation>Seuils&#xa0;:&#xa0;%1</translation>
    </message>
    <message>
        <source>The threshold is where half of the way from guessing to the most right answers is reached. Unit of the levels: %1.</source>
        <translation>Le seuil est là où la moitié du chemin entre la réponse au hasard et le plus de réponses correctes est atteinte. Unité des niveaux&#xa0;:&#xa0;%1.</translation>
    </message>
    <message>
        <source>Thresholds of the participants, and their means with t intervals.</source>
        <translation>Seuils des participants, et leurs moyennes avec des intervalles du t.</translation>
    </message>
</context>
<context>
    <name>ThresholdText</name>
    <message>
        <source>PILOT</source>
        <translation>PILOTE</translation>
    </message>
    <message>
        <source>SIMULATED</source>
        <translation>SIMULÉ</translation>
    </message>
    <message>
        <source>level, s</source>
        <translation>niveau, s</translation>
    </message>
    <message>
        <source>level</source>
        <translation>niveau</translation>
    </message>
    <message>
        <source>level, %1</source>
        <translation>niveau, %1</translation>
    </message>
    <message>
        <source>share of yes</source>
        <translation>part de oui</translation>
    </message>
    <message>
        <source>share of different</source>
        <translation>part de «&#xa0;différents&#xa0;»</translation>
    </message>
    <message>
        <source>share of more</source>
        <translation>part de «&#xa0;plus&#xa0;»</translation>
    </message>
    <message>
        <source>share of right answers</source>
        <translation>part de réponses correctes</translation>
    </message>
    <message>
        <source>open</source>
        <comment>end of an interval</comment>
        <translation>ouvert</translation>
    </message>
    <message>
        <source> (%1 to %2)</source>
        <comment>interval behind a number</comment>
        <translation> (%1 à %2)</translation>
    </message>
    <message>
        <source>reversal</source>
        <translation>inversion</translation>
    </message>
    <message>
        <source>mean of reversals</source>
        <translation>moyenne des inversions</translation>
    </message>
    <message>
        <source>threshold, 95 %</source>
        <translation>seuil, 95&#xa0;%</translation>
    </message>
    <message>
        <source>not fitted: the table does not say what guessing gives</source>
        <translation>sans ajustement&#xa0;: la table ne dit pas ce que donne le hasard</translation>
    </message>
    <message>
        <source>no trials</source>
        <translation>aucun essai</translation>
    </message>
    <message>
        <source>worse with more of it: are levels or answers swapped?</source>
        <translation>moins bon quand il y en a plus&#xa0;: niveaux ou réponses sont-ils intervertis&#xa0;?</translation>
    </message>
    <message>
        <source>the answers do not depend on the level</source>
        <translation>les réponses ne dépendent pas du niveau</translation>
    </message>
    <message>
        <source>below %1%2, the lowest level</source>
        <translation>inférieur à %1%2, le niveau le plus bas</translation>
    </message>
    <message>
        <source>above %1%2, the highest level</source>
        <translation>supérieur à %1%2, le niveau le plus haut</translation>
    </message>
    <message>
        <source>too few levels for a fit; one less is enough with a fixed lapse rate</source>
        <translation>trop peu de niveaux pour un ajustement&#xa0;; un de moins suffit avec un taux d’inattention fixe</translation>
    </message>
    <message>
        <source>no level is above 0</source>
        <translation>aucun niveau n’est supérieur à 0</translation>
    </message>
    <message>
        <source>equal at %1</source>
        <translation>égal à %1</translation>
    </message>
    <message>
        <source>threshold %1</source>
        <translation>seuil %1</translation>
    </message>
    <message>
        <source>a step between two levels, without a threshold</source>
        <translation>un saut entre deux niveaux, sans seuil</translation>
    </message>
    <message>
        <source>, just noticeable %1</source>
        <translation>, différence juste perceptible %1</translation>
    </message>
    <message>
        <source>; a step between two levels</source>
        <translation>&#xa0;; un saut entre deux niveaux</translation>
    </message>
    <message>
        <source>; many lapses, or no upper end</source>
        <translation>&#xa0;; beaucoup d’inattention, ou pas de palier supérieur</translation>
    </message>
    <message>
        <source>the curve does not fit: p of the deviance %1</source>
        <translation>la courbe n’est pas ajustée aux données&#xa0;: p de la déviance %1</translation>
    </message>
    <message>
        <source>trial</source>
        <translation>essai</translation>
    </message>
    <message>
        <source>right</source>
        <translation>juste</translation>
    </message>
    <message>
        <source>felt</source>
        <comment>answer: yes, different, more</comment>
        <translation>senti</translation>
    </message>
    <message>
        <source>wrong</source>
        <translation>faux</translation>
    </message>
    <message>
        <source>not felt</source>
        <comment>answer: no, same, less</comment>
        <translation>non senti</translation>
    </message>
    <message>
        <source>thresholds</source>
        <translation>seuils</translation>
    </message>
    <message>
        <source>participants</source>
        <translation>participants</translation>
    </message>
    <message>
        <source>mean, 95 %</source>
        <translation>moyenne, 95&#xa0;%</translation>
    </message>
    <message>
        <source>d&apos;, c</source>
        <translation>d&apos;, c</translation>
    </message>
    <message>
        <source>d&apos;, 95 %</source>
        <translation>d&apos;, 95&#xa0;%</translation>
    </message>
    <message>
        <source>c (above 0: rather no)</source>
        <translation>c (supérieur à 0&#xa0;: plutôt non)</translation>
    </message>
    <message>
        <source>mean</source>
        <translation>moyenne</translation>
    </message>
</context>
<context>
    <name>Timeline</name>
    <message>
        <source>hold</source>
        <translation>maintien</translation>
    </message>
    <message>
        <source>ease in</source>
        <translation>entrée progressive</translation>
    </message>
    <message>
        <source>ease out</source>
        <translation>sortie progressive</translation>
    </message>
    <message>
        <source>ease in and out</source>
        <translation>entrée et sortie progressives</translation>
    </message>
    <message>
        <source>linear</source>
        <translation>linéaire</translation>
    </message>
    <message>
        <source>Motor %1 at %2°
%3 s: %4 %, %5 Hz</source>
        <translation>Moteur %1 à %2°
%3 s&#xa0;: %4&#xa0;%, %5 Hz</translation>
    </message>
    <message>
        <source>%1: %2 to %3 s</source>
        <translation>%1&#xa0;: %2 à %3 s</translation>
    </message>
    <message>
        <source>Cu&amp;t</source>
        <translation>Co&amp;uper</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Copier</translation>
    </message>
    <message>
        <source>&amp;Paste in place</source>
        <translation>Coller sur &amp;place</translation>
    </message>
    <message>
        <source>Paste at play&amp;head</source>
        <translation>Coller à la &amp;tête de lecture</translation>
    </message>
    <message>
        <source>&amp;Duplicate</source>
        <translation>&amp;Dupliquer</translation>
    </message>
    <message>
        <source>De&amp;lete</source>
        <translation>&amp;Supprimer</translation>
    </message>
    <message>
        <source>commanded</source>
        <translation>commandé</translation>
    </message>
    <message>
        <source>predicted (assumed motors)</source>
        <translation>prédit (moteurs supposés)</translation>
    </message>
    <message>
        <source>predicted</source>
        <translation>prédit</translation>
    </message>
    <message>
        <source>the motor cannot follow</source>
        <translation>le moteur ne peut pas suivre</translation>
    </message>
    <message>
        <source>zoom in to see what the motors do</source>
        <translation>zoomer pour voir ce que font les moteurs</translation>
    </message>
    <message>
        <source>Sweep</source>
        <translation>Balayage</translation>
    </message>
    <message>
        <source>Ring</source>
        <translation>Anneau</translation>
    </message>
    <message>
        <source>Phantom</source>
        <translation>Fantôme</translation>
    </message>
    <message>
        <source>Ramp</source>
        <translation>Rampe</translation>
    </message>
    <message>
        <source>Pulse train</source>
        <translation>Train d’impulsions</translation>
    </message>
    <message>
        <source>Stroke</source>
        <translation>Tracé</translation>
    </message>
    <message>
        <source>Δ %1 %, rms %2 %</source>
        <translation>Δ %1&#xa0;%, RMS %2&#xa0;%</translation>
    </message>
    <message>
        <source>O&amp;verdrive: make the motors start faster</source>
        <translation>S&amp;urintensité&#xa0;: aider les moteurs à démarrer</translation>
    </message>
</context>
<context>
    <name>TomlEdit</name>
    <message>
        <source>there is no place for the key &quot;%1&quot;</source>
        <translation>il n’y a pas de place pour la clé «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>the entry&apos;s number or name, and a key in it</source>
        <translation>le numéro ou le nom de l’entrée, et une clé dans celle-ci</translation>
    </message>
    <message>
        <source>a number from 0 to %1</source>
        <translation>un numéro de 0 à %1</translation>
    </message>
    <message>
        <source>tables of the file, with dots between them</source>
        <translation>des tables du fichier, séparées par des points</translation>
    </message>
</context>
<context>
    <name>TomlReader</name>
    <message>
        <source>one of: %1</source>
        <translation>l’un de&#xa0;: %1</translation>
    </message>
    <message>
        <source>a number above %1, at most %2</source>
        <translation>un nombre supérieur à %1, au plus %2</translation>
    </message>
    <message>
        <source>a number from %1 to %2</source>
        <translation>un nombre de %1 à %2</translation>
    </message>
    <message>
        <source>a number above %1</source>
        <translation>un nombre supérieur à %1</translation>
    </message>
    <message>
        <source>a number of at least %1</source>
        <translation>un nombre d’au moins %1</translation>
    </message>
    <message>
        <source>a number of at most %1</source>
        <translation>un nombre d’au plus %1</translation>
    </message>
    <message>
        <source>a number or nan</source>
        <translation>un nombre ou nan</translation>
    </message>
    <message>
        <source>a finite number</source>
        <translation>un nombre fini</translation>
    </message>
    <message>
        <source>wrong type for &quot;%1&quot;</source>
        <translation>mauvais type pour «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is out of range: %2</source>
        <translation>«&#xa0;%1&#xa0;» est hors limites&#xa0;: %2</translation>
    </message>
    <message>
        <source>a text in quotes</source>
        <translation>un texte entre guillemets</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is empty</source>
        <translation>«&#xa0;%1&#xa0;» est vide</translation>
    </message>
    <message>
        <source>a whole number from %1 to %2</source>
        <translation>un nombre entier de %1 à %2</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has no unit in its name</source>
        <translation>«&#xa0;%1&#xa0;» n’a pas d’unité dans son nom</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has another unit in its name</source>
        <translation>«&#xa0;%1&#xa0;» a une autre unité dans son nom</translation>
    </message>
    <message>
        <source>unknown key &quot;%1&quot;; perhaps &quot;%2&quot; is meant</source>
        <translation>clé inconnue «&#xa0;%1&#xa0;»&#xa0;; peut-être «&#xa0;%2&#xa0;»</translation>
    </message>
    <message>
        <source>unknown key &quot;%1&quot;</source>
        <translation>clé inconnue «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>not valid TOML: %1</source>
        <translation>TOML non valide&#xa0;: %1</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>true ou false</translation>
    </message>
    <message>
        <source>unknown value &quot;%1&quot; of &quot;%2&quot;</source>
        <translation>valeur inconnue «&#xa0;%1&#xa0;» de «&#xa0;%2&#xa0;»</translation>
    </message>
    <message>
        <source>unknown value &quot;%1&quot; of &quot;%2&quot;; perhaps &quot;%3&quot; is meant</source>
        <translation>valeur inconnue «&#xa0;%1&#xa0;» de «&#xa0;%2&#xa0;»&#xa0;; peut-être «&#xa0;%3&#xa0;»</translation>
    </message>
    <message>
        <source>a table: [%1]</source>
        <translation>une table&#xa0;: [%1]</translation>
    </message>
    <message>
        <source>tables: [[%1]] or %1 = [{...}]</source>
        <translation>des tables&#xa0;: [[%1]] ou %1 = [{...}]</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has too few entries</source>
        <translation>«&#xa0;%1&#xa0;» a trop peu d’éléments</translation>
    </message>
    <message>
        <source>at least %1</source>
        <translation>au moins %1</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is missing</source>
        <translation>«&#xa0;%1&#xa0;» manque</translation>
    </message>
    <message>
        <source>&quot;%1&quot; and &quot;%2&quot; are the same key</source>
        <translation>«&#xa0;%1&#xa0;» et «&#xa0;%2&#xa0;» sont la même clé</translation>
    </message>
    <message>
        <source>one of them</source>
        <translation>une seule des deux</translation>
    </message>
    <message>
        <source>the file is too large</source>
        <translation>le fichier est trop grand</translation>
    </message>
    <message>
        <source>at most %1 MiB</source>
        <translation>au plus&#xa0;%1 Mio</translation>
    </message>
    <message>
        <source>the keys are nested too deeply</source>
        <translation>les clés sont imbriquées trop profondément</translation>
    </message>
    <message>
        <source>at most %1 levels</source>
        <translation>au plus&#xa0;%1 niveaux</translation>
    </message>
    <message>
        <source>a list of %1 lists, each of %2 numbers</source>
        <translation>une liste de&#xa0;%1 listes, chacune de&#xa0;%2 nombres</translation>
    </message>
    <message>
        <source>a list of texts in quotes</source>
        <translation>une liste de textes entre guillemets</translation>
    </message>
    <message>
        <source>a list of one or more values</source>
        <translation>une liste d’une ou plusieurs valeurs</translation>
    </message>
    <message>
        <source>a number, a text in quotes, or true or false</source>
        <translation>un nombre, un texte entre guillemets, ou true ou false</translation>
    </message>
    <message>
        <source>a list of lists, each of %1 numbers</source>
        <translation>une liste de listes, chacune de %1 nombres</translation>
    </message>
</context>
<context>
    <name>TopicFeedText</name>
    <message>
        <source>%1: %2</source>
        <translation>%1&#xa0;: %2</translation>
    </message>
    <message>
        <source>%1 is silent</source>
        <translation>%1 se tait</translation>
    </message>
    <message>
        <source>nobody publishes %1</source>
        <translation>personne ne publie&#xa0;%1</translation>
    </message>
</context>
<context>
    <name>TouchTexts</name>
    <message>
        <source>sponge</source>
        <translation>éponge</translation>
    </message>
    <message>
        <source>rubber sponge</source>
        <translation>caoutchouc mousse</translation>
    </message>
    <message>
        <source>rubber</source>
        <translation>caoutchouc</translation>
    </message>
    <message>
        <source>wood</source>
        <translation>bois</translation>
    </message>
    <message>
        <source>metal</source>
        <translation>métal</translation>
    </message>
    <message>
        <source>circle</source>
        <translation>cercle</translation>
    </message>
    <message>
        <source>rectangle</source>
        <translation>rectangle</translation>
    </message>
    <message>
        <source>triangle</source>
        <translation>triangle</translation>
    </message>
    <message>
        <source>arc</source>
        <translation>arc</translation>
    </message>
    <message>
        <source>line</source>
        <translation>ligne</translation>
    </message>
    <message>
        <source>point</source>
        <translation>point</translation>
    </message>
    <message>
        <source>unknown shape</source>
        <translation>forme inconnue</translation>
    </message>
    <message>
        <source>SAFE</source>
        <translation>SÛR</translation>
    </message>
    <message>
        <source>DANGER</source>
        <translation>DANGER</translation>
    </message>
    <message>
        <source>two points</source>
        <translation>deux points</translation>
    </message>
    <message>
        <source>regression</source>
        <translation>régression</translation>
    </message>
    <message>
        <source>The readings of angle or torque are not usable numbers. Check the arm&apos;s sensors.</source>
        <translation>Les mesures d’angle ou de couple ne sont pas des nombres utilisables. Vérifiez les capteurs du bras.</translation>
    </message>
    <message>
        <source>The noise of the arm&apos;s readings is set below zero.</source>
        <translation>Le bruit des mesures du bras est réglé au-dessous de zéro.</translation>
    </message>
    <message>
        <source>The torque window is empty: its upper end must lie above its lower end.</source>
        <translation>La fenêtre de couple est vide&#xa0;: sa borne supérieure doit dépasser sa borne inférieure.</translation>
    </message>
    <message>
        <source>No joint samples came in during the touch.</source>
        <translation>Aucun échantillon articulaire n’est arrivé pendant le toucher.</translation>
    </message>
    <message>
        <source>The torque did not change within the torque window. Press with rising force.</source>
        <translation>Le couple n’a pas changé dans la fenêtre de couple. Appuyez avec une force croissante.</translation>
    </message>
    <message>
        <source>The joint turned against the rising torque: the object moved, or a sign is wrong.</source>
        <translation>L’articulation a tourné contre le couple croissant&#xa0;: l’objet a bougé, ou un signe est faux.</translation>
    </message>
    <message>
        <source>shoulder roll</source>
        <translation>roulis de l’épaule</translation>
    </message>
    <message>
        <source>shoulder pitch</source>
        <translation>tangage de l’épaule</translation>
    </message>
    <message>
        <source>shoulder yaw</source>
        <translation>lacet de l’épaule</translation>
    </message>
    <message>
        <source>elbow pitch</source>
        <translation>tangage du coude</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>arrêté</translation>
    </message>
    <message>
        <source>held</source>
        <translation>maintenu</translation>
    </message>
    <message>
        <source>program</source>
        <translation>programme</translation>
    </message>
    <message>
        <source>jog</source>
        <translation>manuel</translation>
    </message>
    <message>
        <source>N/m</source>
        <translation>N/m</translation>
    </message>
    <message>
        <source>at least %1 (95 %)</source>
        <translation>au moins %1 (95&#xa0;%)</translation>
    </message>
    <message>
        <source>%1 … rigid</source>
        <translation>%1 … rigide</translation>
    </message>
    <message>
        <source>%1 … %2</source>
        <translation>%1 … %2</translation>
    </message>
    <message>
        <source>The elbow feels nothing of a touch on its axis or along it, or the link&apos;s stiffness is not set. Touch from another side.</source>
        <translation>Le coude ne sent rien d’un toucher sur son axe ou le long de celui-ci, ou la raideur du segment n’est pas réglée. Touchez d’un autre côté.</translation>
    </message>
    <message>
        <source>The elbow felt too little: its torque did not reach the torque window. Press harder, or from another side.</source>
        <translation>Le coude a senti trop peu&#xa0;: son couple n’a pas atteint la fenêtre de couple. Appuyez plus fort, ou d’un autre côté.</translation>
    </message>
    <message>
        <source>The touch was too quick: the arm&apos;s own inertia was felt with the object. Press slower.</source>
        <translation>Le toucher était trop rapide&#xa0;: l’inertie propre du bras a été sentie avec l’objet. Appuyez plus lentement.</translation>
    </message>
    <message>
        <source>joint %1</source>
        <translation>articulation %1</translation>
    </message>
    <message>
        <source>%1 (%2 %)</source>
        <comment>a recognised shape and its confidence</comment>
        <translation>%1 (%2&#xa0;%)</translation>
    </message>
    <message>
        <source>%1 or %2</source>
        <comment>recognised shapes</comment>
        <translation>%1 ou %2</translation>
    </message>
    <message>
        <source>The touch was too quick: fewer than 20 independent samples lie in the torque window. Press slower.</source>
        <translation>Le toucher était trop rapide&#xa0;: moins de 20 échantillons indépendants dans la fenêtre de couple. Appuyez plus lentement.</translation>
    </message>
    <message>
        <source>The noise of neighbouring samples is not independent.</source>
        <translation>Le bruit d’échantillons voisins n’est pas indépendant.</translation>
    </message>
    <message>
        <source>One step of the torque reading is over a tenth of the window.</source>
        <translation>Un pas de la lecture du couple dépasse un dixième de la fenêtre.</translation>
    </message>
    <message>
        <source>One step of the angle reading is over a tenth of the rotation.</source>
        <translation>Un pas de la lecture de l’angle dépasse un dixième de la rotation.</translation>
    </message>
    <message>
        <source>The free joint has a torque; it was taken off.</source>
        <translation>L’articulation libre a un couple&#xa0;; il a été retranché.</translation>
    </message>
    <message>
        <source>The torque of the free joint changes; the change was taken off.</source>
        <translation>Le couple de l’articulation libre change&#xa0;; ce changement a été retranché.</translation>
    </message>
    <message>
        <source>The stiffness changes within the torque window.</source>
        <translation>La raideur change dans la fenêtre de couple.</translation>
    </message>
    <message>
        <source>The force depends on how quickly the object is pressed.</source>
        <translation>La force dépend de la vitesse à laquelle on presse l’objet.</translation>
    </message>
    <message>
        <source>The torque jumps, or the joint has play.</source>
        <translation>Le couple saute, ou l’articulation a du jeu.</translation>
    </message>
</context>
<context>
    <name>TrackCommand</name>
    <message>
        <source>%1 of %2 frames could not be used. The last reason: %3</source>
        <translation>%1 images sur %2 étaient inutilisables. Dernière raison&#xa0;: %3</translation>
    </message>
    <message>
        <source>Video, pattern of numbered images (frame_%04d.png) or number of a camera; nothing touches the tube in the first frame</source>
        <translation>Vidéo, modèle d’images numérotées (frame_%04d.png) ou numéro d’une caméra&#xa0;; rien ne touche le tube dans la première image</translation>
    </message>
    <message>
        <source>Camera file, as calibrate writes it</source>
        <translation>Fichier de caméra, tel que l’écrit calibrate</translation>
    </message>
    <message>
        <source>the video has no frame that can be decoded</source>
        <translation>la vidéo n’a pas d’image décodable</translation>
    </message>
    <message>
        <source>Find contacts on the soft tube in a video or live from a camera</source>
        <translation>Contacts sur le tube souple dans une vidéo ou devant une caméra</translation>
    </message>
    <message>
        <source>How contacts are found; the more exact, the slower</source>
        <translation>Comment les contacts sont trouvés&#xa0;: les détecteurs exacts prennent plus de temps</translation>
    </message>
    <message>
        <source>Frames missing according to their time stamps: %1</source>
        <translation>Images manquantes d’après leur horodatage&#xa0;: %1</translation>
    </message>
    <message>
        <source>the camera has stopped sending frames</source>
        <translation>la caméra ne donne plus d’images</translation>
    </message>
</context>
<context>
    <name>TradeoffCommand</name>
    <message>
        <source>there is no ladder &quot;%1&quot; (expected %2)</source>
        <translation>il n’y a pas d’échelle «&#xa0;%1&#xa0;» (attendu&#xa0;: %2)</translation>
    </message>
    <message>
        <source>Measure on this machine what accuracy costs in time</source>
        <translation>Mesurer sur cette machine ce que la précision coûte en temps</translation>
    </message>
    <message>
        <source>Ladders of --list; otherwise all of them</source>
        <translation>Échelles de --list&#xa0;; sinon toutes</translation>
    </message>
    <message>
        <source>List the ladders</source>
        <translation>Lister les échelles</translation>
    </message>
    <message>
        <source>Folder for tradeoff.csv and a picture of each ladder (SVG)</source>
        <translation>Dossier pour tradeoff.csv et une image de chaque échelle (SVG)</translation>
    </message>
    <message>
        <source>Refuse the times of a rung when the machine ran more unevenly than this meanwhile, in percent</source>
        <translation>Refuser les temps d’un échelon quand la machine a tourné plus irrégulièrement que cela, en pour cent</translation>
    </message>
    <message numerus="yes">
        <source>the machine was too busy: the times of %n rung(s) were refused</source>
        <translation>
            <numerusform>la machine était trop occupée&#xa0;: les temps de %n échelon ont été refusés</numerusform>
            <numerusform>la machine était trop occupée&#xa0;: les temps de %n échelons ont été refusés</numerusform>
        </translation>
    </message>
    <message>
        <source>a spread of at most %1 %; close other programs, or see --largest-spread</source>
        <translation>une dispersion d’au plus %1&#xa0;%&#xa0;; fermez les autres programmes, ou voyez --largest-spread</translation>
    </message>
    <message>
        <source>refused</source>
        <translation>refusé</translation>
    </message>
    <message>
        <source>rung</source>
        <translation>échelon</translation>
    </message>
    <message>
        <source>parameter</source>
        <translation>paramètre</translation>
    </message>
    <message>
        <source>mean error</source>
        <translation>erreur moyenne</translation>
    </message>
    <message>
        <source>95 %</source>
        <translation>95&#xa0;%</translation>
    </message>
    <message>
        <source>worst</source>
        <translation>pire</translation>
    </message>
    <message>
        <source>median time</source>
        <translation>temps médian</translation>
    </message>
    <message>
        <source>99 %</source>
        <translation>99&#xa0;%</translation>
    </message>
    <message>
        <source>samples</source>
        <translation>échantillons</translation>
    </message>
    <message>
        <source>spread</source>
        <translation>dispersion</translation>
    </message>
    <message>
        <source>* no other rung is both as quick and as exact. Measured in %1 s.</source>
        <translation>* aucun autre échelon n’est à la fois aussi rapide et aussi exact. Mesuré en %1 s.</translation>
    </message>
    <message>
        <source>the folder cannot be made</source>
        <translation>le dossier ne peut pas être créé</translation>
    </message>
    <message>
        <source>Calls of a few microseconds are timed together; their 99 % is one of means.</source>
        <translation>Les appels de quelques microsecondes sont chronométrés ensemble&#xa0;; leur 99&#xa0;% est celui de moyennes.</translation>
    </message>
    <message>
        <source>Fastest: %1, %2 times the limit (%3: %4).</source>
        <translation>Le plus rapide&#xa0;: %1, %2 fois la limite (%3&#xa0;: %4).</translation>
    </message>
</context>
<context>
    <name>TransferText</name>
    <message>
        <source>Fewer than 4 participants do not show how much people differ, so there is only a bound.</source>
        <translation>Moins de 4 participants ne montrent pas combien les personnes diffèrent&#xa0;: il n’y a qu’une borne.</translation>
    </message>
    <message>
        <source>With fewer than 20 trials a pattern, or 4 k² for k patterns, there is only a bound.</source>
        <translation>Avec moins de 20 essais par motif, ou 4 k² pour k motifs, il n’y a qu’une borne.</translation>
    </message>
    <message>
        <source>Nearly all answers to each pattern are the same; fewer than 10 differ, so there is only a bound.</source>
        <translation>Presque toutes les réponses à chaque motif sont les mêmes, et moins de 10 en diffèrent&#xa0;: il n’y a qu’une borne.</translation>
    </message>
    <message>
        <source>The answers do not differ from guesses (G test, p ≥ 0.05), so there is only a bound.</source>
        <translation>Les réponses ne diffèrent pas du hasard (test G, p ≥ 0.05)&#xa0;: il n’y a qu’une borne.</translation>
    </message>
</context>
<context>
    <name>TrialLines</name>
    <message>
        <source>✓ right</source>
        <translation>✓ juste</translation>
    </message>
    <message>
        <source>✗ wrong</source>
        <translation>✗ faux</translation>
    </message>
    <message>
        <source>no answer</source>
        <translation>sans réponse</translation>
    </message>
    <message>
        <source>aborted</source>
        <translation>abandonné</translation>
    </message>
    <message>
        <source>practice %1</source>
        <translation>entraînement %1</translation>
    </message>
    <message>
        <source>test %1</source>
        <translation>test %1</translation>
    </message>
    <message>
        <source>%1: %2 %3</source>
        <comment>track, level, unit</comment>
        <translation>%1&#xa0;:&#xa0;%2&#xa0;%3</translation>
    </message>
    <message>
        <source>interrupted, will be repeated</source>
        <translation>interrompu, sera repris</translation>
    </message>
</context>
<context>
    <name>TriggerOpener</name>
    <message>
        <source>this is no trigger device</source>
        <translation>ceci n’est pas un appareil de déclenchement</translation>
    </message>
    <message>
        <source>a serial port such as /dev/ttyUSB0, or HOST:PORT for OSC</source>
        <translation>un port série tel que /dev/ttyUSB0, ou HOST:PORT pour OSC</translation>
    </message>
</context>
<context>
    <name>UnitAxesText</name>
    <message>
        <source>value</source>
        <translation>valeur</translation>
    </message>
</context>
<context>
    <name>UnitTitle</name>
    <message>
        <source>%1 (%2)</source>
        <comment>a title and its unit</comment>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>%1
(%2)</source>
        <comment>a title above its unit</comment>
        <translation>%1
(%2)</translation>
    </message>
</context>
<context>
    <name>UrdfText</name>
    <message>
        <source>there is a document type declaration</source>
        <translation>il y a une déclaration de type de document</translation>
    </message>
    <message>
        <source>a plain URDF</source>
        <translation>un URDF simple</translation>
    </message>
    <message>
        <source>this is xacro, not URDF</source>
        <translation>ceci est du xacro, pas de l’URDF</translation>
    </message>
    <message>
        <source>the expanded text: xacro FILE &gt; robot.urdf</source>
        <translation>le texte développé&#xa0;: xacro FILE &gt; robot.urdf</translation>
    </message>
    <message>
        <source>the document is &apos;%1&apos;</source>
        <translation>le document est «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>&lt;robot name=&quot;...&quot;&gt;</source>
        <translation>&lt;robot name=&quot;...&quot;&gt;</translation>
    </message>
    <message>
        <source>elements are nested more than %1 deep</source>
        <translation>des éléments sont imbriqués sur plus de %1 niveaux</translation>
    </message>
    <message>
        <source>&lt;robot&gt; with &lt;link&gt; and &lt;joint&gt;</source>
        <translation>&lt;robot&gt; avec &lt;link&gt; et &lt;joint&gt;</translation>
    </message>
    <message>
        <source>a well-formed XML document</source>
        <translation>un document XML bien formé</translation>
    </message>
    <message>
        <source>some links hang on themselves</source>
        <translation>certains segments dépendent d’eux-mêmes</translation>
    </message>
    <message>
        <source>a tree of links</source>
        <translation>un arbre de segments</translation>
    </message>
    <message>
        <source>link &apos;%1&apos;: %2</source>
        <translation>segment «&#xa0;%1&#xa0;»&#xa0;: %2</translation>
    </message>
    <message>
        <source>joint &apos;%1&apos;: %2</source>
        <translation>articulation «&#xa0;%1&#xa0;»&#xa0;: %2</translation>
    </message>
    <message>
        <source>numbers from -%1 to %1</source>
        <translation>des nombres de -%1 à %1</translation>
    </message>
    <message>
        <source>a number of its inertial is out of range</source>
        <translation>un nombre de son élément inertial est hors limites</translation>
    </message>
    <message>
        <source>its mass is negative</source>
        <translation>sa masse est négative</translation>
    </message>
    <message>
        <source>0 kg or more</source>
        <translation>0 kg ou plus</translation>
    </message>
    <message>
        <source>a number of its visual is out of range</source>
        <translation>un nombre de son élément visual est hors limites</translation>
    </message>
    <message>
        <source>it is floating or planar</source>
        <translation>elle est de type floating ou planar</translation>
    </message>
    <message>
        <source>revolute, continuous, prismatic or fixed</source>
        <translation>revolute, continuous, prismatic ou fixed</translation>
    </message>
    <message>
        <source>a number of its origin is out of range</source>
        <translation>un nombre de son élément origin est hors limites</translation>
    </message>
    <message>
        <source>its axis has no direction</source>
        <translation>son axe n’a pas de direction</translation>
    </message>
    <message>
        <source>&lt;axis xyz=&quot;...&quot;&gt; other than 0 0 0</source>
        <translation>&lt;axis xyz=&quot;...&quot;&gt; autre que 0 0 0</translation>
    </message>
    <message>
        <source>it has no limits</source>
        <translation>elle n’a pas de limites</translation>
    </message>
    <message>
        <source>&lt;limit lower= upper= effort= velocity=&gt;</source>
        <translation>&lt;limit lower= upper= effort= velocity=&gt;</translation>
    </message>
    <message>
        <source>a number of its limits is out of range</source>
        <translation>un nombre de ses limites est hors limites</translation>
    </message>
    <message>
        <source>a limit of velocity or effort is negative</source>
        <translation>une limite de vitesse ou d’effort est négative</translation>
    </message>
    <message>
        <source>0 or more</source>
        <translation>0 ou plus</translation>
    </message>
    <message>
        <source>its lower limit lies above the upper one</source>
        <translation>sa limite inférieure est au-dessus de la limite supérieure</translation>
    </message>
    <message>
        <source>lower &lt;= upper</source>
        <translation>lower &lt;= upper</translation>
    </message>
    <message>
        <source>it mimics itself</source>
        <translation>elle s’imite elle-même</translation>
    </message>
    <message>
        <source>a mimic of another joint</source>
        <translation>un élément mimic d’une autre articulation</translation>
    </message>
    <message>
        <source>it mimics &apos;%1&apos;, which does not exist</source>
        <translation>elle imite «&#xa0;%1&#xa0;», qui n’existe pas</translation>
    </message>
    <message>
        <source>the name of a joint</source>
        <translation>le nom d’une articulation</translation>
    </message>
    <message>
        <source>a number of its mimic is out of range</source>
        <translation>un nombre de son élément mimic est hors limites</translation>
    </message>
    <message>
        <source>the text has %1 bytes</source>
        <translation>le texte a %1 octets</translation>
    </message>
    <message>
        <source>at most %1</source>
        <translation>au plus %1</translation>
    </message>
    <message>
        <source>this is not a robot</source>
        <translation>ceci n’est pas un robot</translation>
    </message>
    <message>
        <source>a tree of links and joints, http://wiki.ros.org/urdf/XML</source>
        <translation>un arbre de segments et d’articulations, http://wiki.ros.org/urdf/XML</translation>
    </message>
    <message>
        <source>the file does not exist</source>
        <translation>le fichier n’existe pas</translation>
    </message>
    <message>
        <source>a URDF file</source>
        <translation>un fichier URDF</translation>
    </message>
    <message>
        <source>this is not a file</source>
        <translation>ceci n’est pas un fichier</translation>
    </message>
    <message>
        <source>the file has %1 bytes</source>
        <translation>le fichier a %1 octets</translation>
    </message>
</context>
<context>
    <name>ValidatorText</name>
    <message>
        <source>%1 is given, %2 is expected</source>
        <translation>%1 est donné, %2 est attendu</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>un nombre</translation>
    </message>
    <message>
        <source>a number other than 0</source>
        <translation>un nombre autre que 0</translation>
    </message>
    <message>
        <source>a number above 0</source>
        <translation>un nombre supérieur à 0</translation>
    </message>
    <message>
        <source>a number from %1 to %2</source>
        <translation>un nombre de %1 à %2</translation>
    </message>
    <message>
        <source>a whole number from 0 to %1</source>
        <translation>un nombre entier de 0 à %1</translation>
    </message>
</context>
<context>
    <name>VisionText</name>
    <message>
        <source>The frame could not be decoded.</source>
        <translation>L’image n’a pas pu être décodée.</translation>
    </message>
    <message>
        <source>The image is too small to show printed dots: %1 x %2 pixels.</source>
        <translation>L’image est trop petite pour montrer des points imprimés&#xa0;: %1 x %2 pixels.</translation>
    </message>
    <message>
        <source>at least %1 pixels on each side</source>
        <translation>au moins %1 pixels de chaque côté</translation>
    </message>
    <message>
        <source>The image shows no printed dots on the skin (%1 found).</source>
        <translation>L’image ne montre pas de points imprimés sur la peau (%1 trouvés).</translation>
    </message>
    <message>
        <source>a frame in focus, in which nothing touches the skin</source>
        <translation>une image nette, où rien ne touche la peau</translation>
    </message>
    <message>
        <source>The printed dots are too faint to be followed.</source>
        <translation>Les points imprimés sont trop pâles pour être suivis.</translation>
    </message>
    <message>
        <source>The frame does not show the skin: %1 of %2 dots found.</source>
        <translation>L’image ne montre pas la peau&#xa0;: %1 points trouvés sur %2.</translation>
    </message>
    <message>
        <source>The image is too small for optical flow: %1 x %2 pixels.</source>
        <translation>L’image est trop petite pour le flot optique&#xa0;: %1 x %2 pixels.</translation>
    </message>
    <message>
        <source>There is no frame of the untouched skin to compare with.</source>
        <translation>Il n’y a pas d’image de la peau intacte à laquelle comparer.</translation>
    </message>
    <message>
        <source>The frame has %1 x %2 pixels.</source>
        <translation>L’image a %1 x %2 pixels.</translation>
    </message>
    <message>
        <source>%1 x %2 pixels, as in the camera&apos;s calibration</source>
        <translation>%1 x %2 pixels, comme dans l’étalonnage de la caméra</translation>
    </message>
    <message>
        <source>The camera was closed before it was ready.</source>
        <translation>La caméra a été fermée avant d’être prête.</translation>
    </message>
    <message>
        <source>The camera does not see the skin.</source>
        <translation>La caméra ne voit rien de la peau.</translation>
    </message>
    <message>
        <source>The image shows no pattern on the skin that could be tracked.</source>
        <translation>L’image ne montre sur la peau aucun motif dont le mouvement puisse être vu.</translation>
    </message>
    <message>
        <source>The image cannot be processed: %1</source>
        <translation>L’image ne peut pas être traitée&#xa0;: %1</translation>
    </message>
    <message>
        <source>There is not enough memory for images of this size.</source>
        <translation>La mémoire ne suffit pas pour des images de cette taille.</translation>
    </message>
</context>
<context>
    <name>WorkProgress</name>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
</context>
<context>
    <name>WtsText</name>
    <message>
        <source>&quot;%1&quot; is not the address of a tactile array</source>
        <translation>«&#xa0;%1&#xa0;» n’est pas l’adresse d’une matrice tactile</translation>
    </message>
    <message>
        <source>the path of a serial port, or tcp://HOST:PORT</source>
        <translation>le chemin d’un port série, ou tcp://HOST:PORT</translation>
    </message>
    <message>
        <source>success</source>
        <translation>succès</translation>
    </message>
    <message>
        <source>not available</source>
        <translation>non disponible</translation>
    </message>
    <message>
        <source>no sensor connected</source>
        <translation>aucun capteur connecté</translation>
    </message>
    <message>
        <source>not initialised</source>
        <translation>non initialisé</translation>
    </message>
    <message>
        <source>already running</source>
        <translation>déjà en marche</translation>
    </message>
    <message>
        <source>not supported</source>
        <translation>non pris en charge</translation>
    </message>
    <message>
        <source>inconsistent data</source>
        <translation>données incohérentes</translation>
    </message>
    <message>
        <source>read error in the sensor</source>
        <translation>erreur de lecture dans le capteur</translation>
    </message>
    <message>
        <source>write error in the sensor</source>
        <translation>erreur d’écriture dans le capteur</translation>
    </message>
    <message>
        <source>wrong checksum</source>
        <translation>somme de contrôle fausse</translation>
    </message>
    <message>
        <source>unknown command</source>
        <translation>commande inconnue</translation>
    </message>
    <message>
        <source>wrong format</source>
        <translation>mauvais format</translation>
    </message>
    <message>
        <source>access denied</source>
        <translation>accès refusé</translation>
    </message>
    <message>
        <source>status %1</source>
        <translation>état %1</translation>
    </message>
    <message>
        <source>connecting was cancelled</source>
        <translation>la connexion a été annulée</translation>
    </message>
    <message>
        <source>an array of 1 to %1 rows and columns whose frame fits into one message</source>
        <translation>une matrice de 1 à %1 lignes et colonnes dont la trame tient dans un message</translation>
    </message>
    <message>
        <source>the sensor&apos;s cells are %1 mm wide and %2 mm high</source>
        <translation>les cellules du capteur font %1 mm de large et %2 mm de haut</translation>
    </message>
    <message>
        <source>the sensor describes its array in %1 bytes</source>
        <translation>le capteur décrit sa matrice en %1 octets</translation>
    </message>
    <message>
        <source>the 10 bytes of a WTS array</source>
        <translation>les 10 octets d’une matrice WTS</translation>
    </message>
    <message>
        <source>the sensor sends no frames: %1</source>
        <translation>le capteur n’envoie pas de trames&#xa0;: %1</translation>
    </message>
    <message>
        <source>the sensor does not answer</source>
        <translation>le capteur ne répond pas</translation>
    </message>
    <message>
        <source>the sensor refused a request: %1</source>
        <translation>le capteur a refusé une requête&#xa0;: %1</translation>
    </message>
    <message>
        <source>Another array is connected: %1 x %2 cells of %3 mm instead of %4 x %5 cells of %6 mm.</source>
        <translation>Une autre matrice est connectée&#xa0;: %1 x %2 cellules de %3 mm au lieu de %4 x %5 cellules de %6 mm.</translation>
    </message>
    <message>
        <source>The sensor has sent no usable frame for %1 s.</source>
        <translation>Le capteur n’a pas envoyé de trame utilisable depuis %1 s.</translation>
    </message>
    <message>
        <source>the sensor reports %1 rows and %2 columns</source>
        <translation>le capteur dit avoir %1 lignes et %2 colonnes</translation>
    </message>
    <message>
        <source>timeout in the sensor</source>
        <translation>délai dépassé dans le capteur</translation>
    </message>
    <message>
        <source>cells with a width and a height</source>
        <translation>des cellules avec une largeur et une hauteur</translation>
    </message>
</context>
<context>
    <name>ZipText</name>
    <message>
        <source>the zip archive is damaged</source>
        <translation>l’archive zip est endommagée</translation>
    </message>
    <message>
        <source>a zip archive that is not encrypted</source>
        <translation>une archive zip non chiffrée</translation>
    </message>
    <message>
        <source>the zip archive has too many files</source>
        <translation>l’archive zip a trop de fichiers</translation>
    </message>
    <message>
        <source>at most %1</source>
        <translation>au plus %1</translation>
    </message>
    <message>
        <source>the unpacked zip archive is too large</source>
        <translation>l’archive zip décompressée est trop grande</translation>
    </message>
    <message>
        <source>at most %1 MiB</source>
        <translation>au plus %1 MiB</translation>
    </message>
    <message>
        <source>the zip archive could not be created</source>
        <translation>l’archive zip n’a pas pu être créée</translation>
    </message>
</context>
<context>
    <name>teleta::base::FigureExport</name>
    <message>
        <source>SVG picture (*.svg)</source>
        <translation>Image SVG (*.svg)</translation>
    </message>
    <message>
        <source>PDF document (*.pdf)</source>
        <translation>Document PDF (*.pdf)</translation>
    </message>
    <message>
        <source>PNG picture (*.png)</source>
        <translation>Image PNG (*.png)</translation>
    </message>
    <message>
        <source>Comma-separated values (*.csv)</source>
        <translation>Valeurs séparées par des virgules (*.csv)</translation>
    </message>
    <message>
        <source>&amp;Copy picture</source>
        <translation>&amp;Copier l’image</translation>
    </message>
    <message>
        <source>Copy &amp;data</source>
        <translation>Copier les &amp;données</translation>
    </message>
    <message>
        <source>&amp;Save picture…</source>
        <translation>&amp;Enregistrer l’image…</translation>
    </message>
    <message>
        <source>Save da&amp;ta…</source>
        <translation>Enregistrer les d&amp;onnées…</translation>
    </message>
    <message>
        <source>Save picture</source>
        <translation>Enregistrer l’image</translation>
    </message>
    <message>
        <source>Save data</source>
        <translation>Enregistrer les données</translation>
    </message>
</context>
<context>
    <name>teleta::bracelet::BraceletView</name>
    <message>
        <source>Bracelet</source>
        <translation>Bracelet</translation>
    </message>
    <message>
        <source>motor %1: %2 %</source>
        <translation>moteur %1&#xa0;: %2&#xa0;%</translation>
    </message>
    <message>
        <source>Motor %1 at %2°: %3 %</source>
        <translation>Moteur %1 à %2°&#xa0;: %3&#xa0;%</translation>
    </message>
    <message>
        <source>&lt;p&gt;What the six motors of the bracelet are doing, on the unrolled forearm: from left to right once around the arm. The fuller a disc, the stronger the motor vibrates.&lt;/p&gt;&lt;p&gt;With a bracelet connected, hold a disc with the mouse, or one of the keys 1 to 6, to feel that motor alone.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Ce que font maintenant les six moteurs du bracelet, sur l’avant-bras déroulé&#xa0;: de gauche à droite, un tour du bras. Plus un disque est plein, plus le moteur vibre fort.&lt;/p&gt;&lt;p&gt;Si un bracelet est connecté, maintenez un disque avec la souris, ou l’une des touches 1 à 6, pour sentir ce moteur seul.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Nothing is playing</source>
        <translation>Rien n’est joué</translation>
    </message>
    <message>
        <source>%1: preview</source>
        <comment>a pattern that is not played</comment>
        <translation>%1&#xa0;: aperçu</translation>
    </message>
</context>
<context>
    <name>teleta::bracelet::StrengthPanel</name>
    <message>
        <source>%1 %</source>
        <translation>%1&#xa0;%</translation>
    </message>
    <message>
        <source>to %1 %</source>
        <translation>à&#xa0;%1&#xa0;%</translation>
    </message>
    <message>
        <source>Stron&amp;gest</source>
        <translation>Intensité ma&amp;ximale</translation>
    </message>
    <message>
        <source>Strongest, all motors</source>
        <translation>Intensité maximale, tous les moteurs</translation>
    </message>
    <message>
        <source>Each motor</source>
        <translation>Chaque moteur</translation>
    </message>
    <message>
        <source>A limit for each motor</source>
        <translation>Une limite pour chaque moteur</translation>
    </message>
    <message>
        <source>Motor &amp;%1</source>
        <translation>Moteur &amp;%1</translation>
    </message>
    <message>
        <source>Strongest, motor %1</source>
        <translation>Intensité maximale, moteur %1</translation>
    </message>
    <message>
        <source>The most that the motors may vibrate, whatever is played. Saved for this bracelet.</source>
        <translation>Force maximale des moteurs, quoi que l’on joue, maintienne ou ressente sur ce bracelet. Elle est conservée pour le bracelet.</translation>
    </message>
</context>
<context>
    <name>teleta::calibrate::FeltPanel</name>
    <message>
        <source>The motors were balanced by feel.</source>
        <translation>Les moteurs ont été équilibrés au ressenti.</translation>
    </message>
    <message>
        <source>Motor %1 starts at %2 % of the full drive (95 %: %3 to %4 %).</source>
        <translation>Le moteur %1 démarre à %2&#xa0;% de la pleine commande (95&#xa0;%&#xa0;: %3 à %4&#xa0;%).</translation>
    </message>
    <message>
        <source>Start of motor %1</source>
        <translation>Démarrage du moteur %1</translation>
    </message>
    <message>
        <source>%1 answers so far</source>
        <translation>%1 réponses jusqu’ici</translation>
    </message>
    <message>
        <source>Play the next burst.</source>
        <translation>Jouez la salve suivante.</translation>
    </message>
    <message>
        <source>Did you feel it?</source>
        <translation>L’avez-vous sentie&#xa0;?</translation>
    </message>
    <message>
        <source>Was the second burst stronger?</source>
        <translation>La seconde salve était-elle plus forte&#xa0;?</translation>
    </message>
    <message>
        <source>The bracelet cannot play now: it is not connected, STOP is engaged, or a study uses it.</source>
        <translation>Le bracelet ne peut pas jouer maintenant&#xa0;: il n’est pas connecté, STOP est enclenché, ou une étude l’utilise.</translation>
    </message>
    <message>
        <source>Now and then nothing is played. Answer yes only when you are sure.</source>
        <translation>De temps en temps, rien n’est joué. Ne répondez oui que si vous êtes sûr.</translation>
    </message>
    <message>
        <source>Guess when you are not sure.</source>
        <translation>Devinez si vous n’êtes pas sûr.</translation>
    </message>
    <message>
        <source>Questions about what is felt</source>
        <translation>Questions sur ce qui est senti</translation>
    </message>
    <message>
        <source>Play (Space)</source>
        <translation>Jouer (Espace)</translation>
    </message>
    <message>
        <source>Yes (Y)</source>
        <translation>Oui (Y)</translation>
    </message>
    <message>
        <source>No (N)</source>
        <translation>Non (N)</translation>
    </message>
    <message>
        <source>Take back the last answer (Backspace)</source>
        <translation>Retirer la dernière réponse (Retour arrière)</translation>
    </message>
    <message>
        <source>Give up</source>
        <translation>Renoncer</translation>
    </message>
    <message>
        <source>Leave the motors as they were</source>
        <translation>Laisser les moteurs tels qu’ils étaient</translation>
    </message>
    <message>
        <source>Strength of motor %1, compared with motor 1</source>
        <translation>Force du moteur %1, à côté du moteur 1</translation>
    </message>
    <message>
        <source>The answers contradict each other.</source>
        <translation>Les réponses ne concordent pas.</translation>
    </message>
    <message>
        <source>Play the burst, as often as you like</source>
        <translation>Faire sentir la salve, aussi souvent que vous le voulez</translation>
    </message>
</context>
<context>
    <name>teleta::calibrate::GainsView</name>
    <message>
        <source>%1 of %2 taxels have gains from %3 to %4.</source>
        <translation>%1 des %2 taxels ont des gains de %3 à %4.</translation>
    </message>
    <message numerus="yes">
        <source>%n dead</source>
        <comment>taxels</comment>
        <translation>
            <numerusform>%n mort</numerusform>
            <numerusform>%n morts</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n too weak</source>
        <comment>taxels</comment>
        <translation>
            <numerusform>%n trop faible</numerusform>
            <numerusform>%n trop faibles</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n too strong</source>
        <comment>taxels</comment>
        <translation>
            <numerusform>%n trop fort</numerusform>
            <numerusform>%n trop forts</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n stuck</source>
        <comment>taxels</comment>
        <translation>
            <numerusform>%n bloqué</numerusform>
            <numerusform>%n bloqués</numerusform>
        </translation>
    </message>
    <message>
        <source>Not used: %1.</source>
        <comment>kinds of taxels</comment>
        <translation>Non utilisés&#xa0;: %1.</translation>
    </message>
    <message>
        <source>No array</source>
        <translation>Aucune matrice</translation>
    </message>
    <message>
        <source>no gains: every taxel counts as it is</source>
        <translation>aucun gain&#xa0;: chaque taxel compte tel quel</translation>
    </message>
    <message>
        <source>gains in use, saved</source>
        <translation>gains utilisés, enregistrés</translation>
    </message>
    <message>
        <source>gains in use, not saved</source>
        <translation>gains utilisés, non enregistrés</translation>
    </message>
    <message>
        <source>1. The array is tared.</source>
        <translation>1. La matrice est tarée.</translation>
    </message>
    <message>
        <source>2. Press evenly on the whole array, with a bladder or with a plate on foam. The load may change.</source>
        <translation>2. Appuyez uniformément sur toute la matrice, avec un coussin gonflé ou une plaque sur de la mousse. La charge peut varier.</translation>
    </message>
    <message numerus="yes">
        <source>%n press(es) so far.</source>
        <translation>
            <numerusform>%n appui jusqu’ici.</numerusform>
            <numerusform>%n appuis jusqu’ici.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 of %2 taxels are under load.</source>
        <translation>%1 des %2 taxels sont chargés.</translation>
    </message>
    <message>
        <source>Waiting for a load on more than half of the taxels: %1 of %2 now.</source>
        <translation>En attente d’une charge sur plus de la moitié des taxels&#xa0;: %1 sur %2 maintenant.</translation>
    </message>
    <message>
        <source>Keep pressing: %1 of %2 taxels are under load.</source>
        <translation>Continuez d’appuyer&#xa0;: %1 des %2 taxels sont chargés.</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Rétablir</translation>
    </message>
    <message>
        <source>&amp;Load…</source>
        <translation>&amp;Charger…</translation>
    </message>
    <message>
        <source>&amp;Reset</source>
        <translation>&amp;Réinitialiser</translation>
    </message>
    <message>
        <source>Use no gains and forget all presses</source>
        <translation>N’utiliser aucun gain et oublier tous les appuis</translation>
    </message>
    <message>
        <source>&amp;Save…</source>
        <translation>&amp;Enregistrer…</translation>
    </message>
    <message>
        <source>&amp;Tare now</source>
        <translation>&amp;Tarer maintenant</translation>
    </message>
    <message>
        <source>Takes the mean of the next half second as the unloaded state. Nothing may touch the array.</source>
        <translation>Prend la moyenne de la demi-seconde suivante comme état à vide. Rien ne doit toucher la matrice.</translation>
    </message>
    <message>
        <source>&amp;Collect a press</source>
        <translation>Re&amp;cueillir un appui</translation>
    </message>
    <message>
        <source>&amp;End</source>
        <translation>&amp;Terminer</translation>
    </message>
    <message>
        <source>Use what has been collected</source>
        <translation>Utiliser ce qui a été recueilli</translation>
    </message>
    <message>
        <source>&amp;Open recorded presses…</source>
        <translation>&amp;Ouvrir des appuis enregistrés…</translation>
    </message>
    <message>
        <source>Open the &amp;demo</source>
        <translation>Ouvrir la &amp;démonstration</translation>
    </message>
    <message>
        <source>A simulated plate presses evenly on an array whose taxels differ</source>
        <translation>Une plaque simulée appuie uniformément sur une matrice dont les taxels diffèrent</translation>
    </message>
    <message>
        <source>Gains of the taxels</source>
        <translation>Gains des taxels</translation>
    </message>
    <message>
        <source>Share of the press that has been collected</source>
        <translation>Part de l’appui qui a été recueillie</translation>
    </message>
    <message>
        <source>Calibration of an array&apos;s taxels</source>
        <translation>Étalonnage des taxels d’une matrice</translation>
    </message>
    <message>
        <source>The least certain gain has a standard error of %1 %.</source>
        <translation>Le moins sûr est connu à %1 % près (erreur type).</translation>
    </message>
    <message>
        <source>Gains vary by %1 % from press to press.</source>
        <translation>Les gains diffèrent de %1 % d’un appui à l’autre.</translation>
    </message>
    <message>
        <source>The response changes by %1 % along x and %2 % along y: the load may have been uneven. Turn the bladder or plate by 180° and collect another press: the difference cancels out.</source>
        <translation>La réponse change de %1 % selon x et de %2 % selon y&#xa0;: la charge était peut-être inégale. Tournez d’un demi-tour ce qui appuie et recueillez un autre appui&#xa0;; l’écart s’annule.</translation>
    </message>
    <message>
        <source>Open an array, a recording or a scene on the page Operate, or the demo.</source>
        <translation>Ouvrez une matrice, un enregistrement ou une scène&#xa0;: sur la page Conduite, ou la démonstration ici.</translation>
    </message>
    <message>
        <source>computing the gains…</source>
        <translation>recherche des gains…</translation>
    </message>
    <message>
        <source>1. Tare the array with nothing touching it.</source>
        <translation>1. Ne laissez rien toucher la matrice, et tarez-la.</translation>
    </message>
    <message>
        <source>Undo the last change (Ctrl+Z)</source>
        <translation>Annuler la dernière modification (Ctrl+Z)</translation>
    </message>
    <message>
        <source>Redo the change undone last</source>
        <translation>La rétablir</translation>
    </message>
    <message>
        <source>Load gains for an array of this size from a file (CSV)</source>
        <translation>Lire dans un fichier (CSV) les gains d’une matrice de cette taille</translation>
    </message>
    <message>
        <source>Save the gains to a file (CSV) for “Open recording”, source lists and the command line</source>
        <translation>Écrire les gains dans un fichier (CSV)&#xa0;: «&#xa0;Ouvrir un enregistrement&#xa0;», les listes de sources et la ligne de commande le lisent</translation>
    </message>
    <message>
        <source>Wait for a load and collect its frames; stops by itself</source>
        <translation>Attend une charge et prend ses trames&#xa0;; s’arrête tout seul</translation>
    </message>
    <message>
        <source>Frames as CSV, one file per press: time_s,t0,t1,…</source>
        <translation>Trames en CSV, un fichier par appui&#xa0;: time_s,t0,t1,…</translation>
    </message>
    <message>
        <source>Every taxel counts as it is. Its gain will be shown here.</source>
        <translation>Chaque taxel compte tel quel. Ce par quoi chacun est multiplié s’affichera ici.</translation>
    </message>
    <message>
        <source>Red taxels read too low and are raised, blue ones are lowered, hatched ones are not used. Point at a taxel, or use the arrow keys, to read its gain.</source>
        <translation>Les taxels rouges ressentent trop peu et sont relevés, les bleus sont abaissés, les hachurés ne sont pas utilisés. Les flèches ou la souris lisent un taxel.</translation>
    </message>
</context>
<context>
    <name>teleta::calibrate::MotorChart</name>
    <message>
        <source>Speed of motor %1 over its drive</source>
        <translation>Vitesse du moteur %1 selon sa commande</translation>
    </message>
    <message>
        <source>Recording of motor %1, and the model</source>
        <translation>Enregistrement du moteur %1, et modèle</translation>
    </message>
    <message>
        <source>assumed</source>
        <translation>supposé</translation>
    </message>
    <message>
        <source>curve</source>
        <translation>courbe</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>mesuré</translation>
    </message>
    <message>
        <source>Motor %1: curve and lag are assumed</source>
        <translation>Moteur %1&#xa0;: courbe et retard sont supposés</translation>
    </message>
    <message>
        <source>Motor %1</source>
        <translation>Moteur %1</translation>
    </message>
    <message>
        <source>%1 % of the variance, residual %2 Hz</source>
        <translation>%1&#xa0;% de la variance, résidu %2 Hz</translation>
    </message>
    <message>
        <source>No recording of this motor yet: measure it, or open a recording.</source>
        <translation>Pas encore d’enregistrement de ce moteur&#xa0;: mesurez-le, ou ouvrez un enregistrement.</translation>
    </message>
    <message>
        <source>measured (simulated)</source>
        <translation>mesuré (simulé)</translation>
    </message>
    <message>
        <source>model</source>
        <translation>modèle</translation>
    </message>
    <message>
        <source>residual</source>
        <translation>résidu</translation>
    </message>
    <message>
        <source>drive</source>
        <translation>commande</translation>
    </message>
    <message>
        <source>speed</source>
        <translation>vitesse</translation>
    </message>
    <message>
        <source>time</source>
        <translation>temps</translation>
    </message>
</context>
<context>
    <name>teleta::calibrate::MotorTable</name>
    <message>
        <source>assumed</source>
        <translation>supposé</translation>
    </message>
    <message>
        <source>by feel</source>
        <translation>au ressenti</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>mesuré</translation>
    </message>
    <message>
        <source>Motor %1</source>
        <translation>Moteur %1</translation>
    </message>
    <message>
        <source>start %1, lag and curve %2</source>
        <comment>where the values come from</comment>
        <translation>démarrage&#xa0;: %1, retard et courbe&#xa0;: %2</translation>
    </message>
    <message>
        <source>Motors of the bracelet</source>
        <translation>Moteurs du bracelet</translation>
    </message>
    <message>
        <source>Motor</source>
        <translation>Moteur</translation>
    </message>
    <message>
        <source>Drive at which the motor begins to turn, with its standard error</source>
        <translation>Commande à laquelle le moteur commence à tourner, avec son erreur type</translation>
    </message>
    <message>
        <source>Drive of intensity 1, so that all motors are equally strong</source>
        <translation>Commande de l’intensité 1, pour que tous les moteurs soient aussi forts</translation>
    </message>
    <message>
        <source>From rest to 90 % of a speed</source>
        <translation>Du repos à 90&#xa0;% d’une vitesse</translation>
    </message>
    <message>
        <source>From a speed to 10 % of it</source>
        <translation>D’une vitesse à 10&#xa0;% de celle-ci</translation>
    </message>
    <message>
        <source>Speed at the full drive of this motor</source>
        <translation>Vitesse à la pleine commande de ce moteur</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Source</translation>
    </message>
    <message>
        <source>measured, by feel</source>
        <comment>where the values come from</comment>
        <translation>mesuré, au ressenti</translation>
    </message>
    <message>
        <source>partly by feel</source>
        <comment>where the values come from</comment>
        <translation>en partie au ressenti</translation>
    </message>
    <message>
        <source>partly measured</source>
        <comment>where the values come from</comment>
        <translation>en partie mesuré</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Démarrage</translation>
    </message>
    <message>
        <source>Full</source>
        <translation>Plein</translation>
    </message>
    <message>
        <source>Rise</source>
        <translation>Montée</translation>
    </message>
    <message>
        <source>Fall</source>
        <translation>Descente</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Vitesse</translation>
    </message>
</context>
<context>
    <name>teleta::calibrate::MotorsView</name>
    <message>
        <source>Motor %1 was not calibrated. %2</source>
        <comment>a motor, and why not</comment>
        <translation>Le moteur %1 n’a pas été étalonné. %2</translation>
    </message>
    <message>
        <source>Motor %1: starts at %2 to %3 % of the drive, rises in %4 ± %5 ms, falls in %6 ± %7 ms, reaches %8 Hz.</source>
        <translation>Moteur %1&#xa0;: démarre entre %2 et %3&#xa0;% de la commande, monte en %4 ± %5 ms, descend en %6 ± %7 ms, atteint %8 Hz.</translation>
    </message>
    <message>
        <source>No bracelet</source>
        <translation>Pas de bracelet</translation>
    </message>
    <message>
        <source>Choose a bracelet in the menu Bracelet.</source>
        <translation>Choisissez un bracelet dans le menu Bracelet.</translation>
    </message>
    <message>
        <source>calibrated, saved</source>
        <translation>étalonné, enregistré</translation>
    </message>
    <message>
        <source>calibrated, not saved</source>
        <translation>étalonné, non enregistré</translation>
    </message>
    <message>
        <source>Motor %1</source>
        <translation>Moteur %1</translation>
    </message>
    <message>
        <source>Drive the motor up and down and record it with the bracelet&apos;s sensor</source>
        <translation>Faire monter et descendre la commande du moteur et l’enregistrer avec le capteur du bracelet</translation>
    </message>
    <message>
        <source>This bracelet has no sensor: open a recording, or answer by feel</source>
        <translation>Ce bracelet n’a pas de capteur&#xa0;: ouvrez un enregistrement, ou répondez au ressenti</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Rétablir</translation>
    </message>
    <message>
        <source>&amp;Load…</source>
        <translation>&amp;Charger…</translation>
    </message>
    <message>
        <source>Save a &amp;copy…</source>
        <translation>Enregistrer une co&amp;pie…</translation>
    </message>
    <message>
        <source>&amp;Reset</source>
        <translation>&amp;Réinitialiser</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Enregistrer</translation>
    </message>
    <message>
        <source>&amp;Measure this motor</source>
        <translation>&amp;Mesurer ce moteur</translation>
    </message>
    <message>
        <source>Measure &amp;all six</source>
        <translation>Mesurer les &amp;six</translation>
    </message>
    <message>
        <source>One after another, with the bracelet&apos;s sensor</source>
        <translation>L’un après l’autre, avec le capteur du bracelet</translation>
    </message>
    <message>
        <source>&amp;Open a recording…</source>
        <translation>&amp;Ouvrir un enregistrement…</translation>
    </message>
    <message>
        <source>&amp;Balance by feel</source>
        <translation>Équili&amp;brer au ressenti</translation>
    </message>
    <message>
        <source>Compare the strength of each motor with that of motor 1</source>
        <translation>Comparer la force de chaque moteur à celle du moteur 1</translation>
    </message>
    <message>
        <source>Balance by the cur&amp;ves</source>
        <translation>Équilibrer par les co&amp;urbes</translation>
    </message>
    <message>
        <source>Stop measuring</source>
        <translation>Arrêter la mesure</translation>
    </message>
    <message>
        <source>Calibration of the bracelet&apos;s motors</source>
        <translation>Étalonnage des moteurs du bracelet</translation>
    </message>
    <message>
        <source>Turning at %1 Hz, measured by the bracelet&apos;s sensor.</source>
        <translation>Il tourne maintenant à %1 Hz, selon le capteur du bracelet.</translation>
    </message>
    <message>
        <source>All motors use assumed values again. Undo brings the measurements back.</source>
        <translation>Tous les moteurs sont de nouveau supposés. Annuler rétablit ce qui a été mesuré.</translation>
    </message>
    <message>
        <source>Every measured motor is now limited to the top speed of the slowest one.</source>
        <translation>Chaque moteur mesuré finit maintenant à la vitesse du plus lent.</translation>
    </message>
    <message>
        <source>Measuring motor %1: steps up to full drive, then pulses.</source>
        <translation>Mesure du moteur %1&#xa0;: paliers jusqu’à la pleine commande, puis impulsions.</translation>
    </message>
    <message>
        <source>not calibrated: the motors use assumed values</source>
        <translation>non étalonné&#xa0;: les moteurs sont supposés</translation>
    </message>
    <message>
        <source>a study uses the bracelet: its motors cannot be changed</source>
        <translation>une étude utilise le bracelet&#xa0;: ses moteurs restent tels quels</translation>
    </message>
    <message>
        <source>Undo the last change or answer (Ctrl+Z)</source>
        <translation>Annuler la dernière modification, ou la dernière réponse (Ctrl+Z)</translation>
    </message>
    <message>
        <source>Redo the change undone last</source>
        <translation>La rétablir</translation>
    </message>
    <message>
        <source>Load a profile of this bracelet from a file</source>
        <translation>Lire d’un fichier un profil de ce bracelet</translation>
    </message>
    <message>
        <source>Save the profile to another file</source>
        <translation>Écrire le profil dans un autre fichier</translation>
    </message>
    <message>
        <source>Discard the measurements</source>
        <translation>Oublier ce qui a été mesuré</translation>
    </message>
    <message>
        <source>Save the profile for this bracelet: it is used whenever the bracelet is connected</source>
        <translation>Conserver le profil pour ce bracelet&#xa0;: il est utilisé à chaque connexion</translation>
    </message>
    <message>
        <source>CSV with time_s, commanded, and speed_hz (tachometer) or signal (accelerometer, microphone)</source>
        <translation>CSV avec time_s,commanded et speed_hz d’un tachymètre ou signal d’un accéléromètre ou d’un microphone</translation>
    </message>
    <message>
        <source>Save the &amp;excitation…</source>
        <translation>Écrire l’e&amp;xcitation…</translation>
    </message>
    <message>
        <source>Save the drive signal of a measurement as CSV, to record with a sensor of your own</source>
        <translation>Ce qui est commandé au moteur pendant une mesure, en CSV&#xa0;: pour votre propre capteur</translation>
    </message>
    <message>
        <source>Find the start by &amp;feel</source>
        <translation>&amp;Trouver son démarrage au ressenti</translation>
    </message>
    <message>
        <source>Plays weaker and stronger bursts; you say what you felt</source>
        <translation>Des salves qui faiblissent et se renforcent&#xa0;; vous dites ce que vous avez senti</translation>
    </message>
    <message>
        <source>Limit all measured motors to the top speed of the slowest</source>
        <translation>Faire finir tous les moteurs mesurés à la vitesse du plus lent</translation>
    </message>
    <message>
        <source>The computer was busy: %1 % of the time has no readings. Measure again with fewer programs running.</source>
        <translation>L’ordinateur était occupé&#xa0;: %1&#xa0;% du temps est sans mesures. Mesurez à nouveau avec moins de programmes en cours.</translation>
    </message>
    <message>
        <source>%1 of %2 motors calibrated, saved</source>
        <translation>%1 moteurs sur&#xa0;%2 étalonnés, enregistré</translation>
    </message>
    <message>
        <source>%1 of %2 motors calibrated, not saved</source>
        <translation>%1 moteurs sur&#xa0;%2 étalonnés, non enregistré</translation>
    </message>
    <message>
        <source>Measuring motor %1, %2 of %3: steps up to full drive, then pulses.</source>
        <translation>Mesure du moteur&#xa0;%1,&#xa0;%2 sur&#xa0;%3&#xa0;: des échelons jusqu’à la pleine commande, puis des impulsions.</translation>
    </message>
    <message>
        <source>What to do: %1.</source>
        <translation>À faire&#xa0;:&#xa0;%1.</translation>
    </message>
    <message>
        <source>With its sensor</source>
        <translation>Avec son capteur</translation>
    </message>
    <message>
        <source>By feel</source>
        <translation>Au toucher</translation>
    </message>
    <message>
        <source>By the curves</source>
        <translation>D’après les courbes</translation>
    </message>
    <message>
        <source>In files</source>
        <translation>Dans des fichiers</translation>
    </message>
</context>
<context>
    <name>teleta::calibrate::StepList</name>
    <message>
        <source>running</source>
        <translation>en cours</translation>
    </message>
    <message>
        <source>not saved</source>
        <comment>a calibration</comment>
        <translation>non enregistré</translation>
    </message>
    <message>
        <source>done</source>
        <comment>a calibration</comment>
        <translation>fait</translation>
    </message>
    <message>
        <source>failed</source>
        <comment>a calibration</comment>
        <translation>échec</translation>
    </message>
    <message>
        <source>%1 of %2 done</source>
        <translation>%1 sur %2 faits</translation>
    </message>
    <message>
        <source>to do</source>
        <comment>a calibration</comment>
        <translation>à faire</translation>
    </message>
    <message>
        <source>%1. %2: %3</source>
        <comment>number, name and state of a step</comment>
        <translation>%1. %2&#xa0;: %3</translation>
    </message>
    <message>
        <source>running: %1 of %2</source>
        <translation>en cours&#xa0;: %1 sur %2</translation>
    </message>
</context>
<context>
    <name>teleta::camera::CameraPanel</name>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Waiting for a picture of the tube with nothing touching it.</source>
        <translation>En attente d’une image du tube sans rien qui le touche.</translation>
    </message>
    <message>
        <source>No reference yet: %1</source>
        <translation>Pas encore de référence&#xa0;: %1</translation>
    </message>
    <message>
        <source>This finder cannot be used: %1</source>
        <translation>Ce détecteur ne peut pas être utilisé&#xa0;: %1</translation>
    </message>
    <message>
        <source>The arm follows contact %1.</source>
        <translation>Le bras suit le contact %1.</translation>
    </message>
    <message>
        <source>The arm is held.</source>
        <translation>Le bras est maintenu.</translation>
    </message>
    <message>
        <source>The arm is held. Tick the box to let it react again.</source>
        <translation>Le bras est maintenu. Cochez la case pour le laisser réagir à nouveau.</translation>
    </message>
    <message>
        <source>&amp;Finder</source>
        <translation>&amp;Détecteur</translation>
    </message>
    <message>
        <source>Finder</source>
        <translation>Détecteur</translation>
    </message>
    <message>
        <source>&amp;Displacement</source>
        <translation>Dé&amp;placement</translation>
    </message>
    <message>
        <source>Show how far the pattern on the skin has moved</source>
        <translation>Montrer de combien le motif imprimé sur la peau s’est déplacé</translation>
    </message>
    <message>
        <source>New &amp;reference</source>
        <translation>Nouvelle &amp;référence</translation>
    </message>
    <message>
        <source>The arm may r&amp;eact</source>
        <translation>Le bras peut réa&amp;gir</translation>
    </message>
    <message>
        <source>Each printed dot is followed in the whole picture. The default.</source>
        <translation>Chaque point imprimé est suivi dans l’image entière. Choix par défaut.</translation>
    </message>
    <message>
        <source>the quickest and coarsest</source>
        <translation>le plus rapide et le plus grossier</translation>
    </message>
    <message>
        <source>a quick one</source>
        <translation>un préréglage rapide</translation>
    </message>
    <message>
        <source>the slowest and finest</source>
        <translation>le plus lent et le plus fin</translation>
    </message>
    <message>
        <source>Dense flow by a preset of OpenCV (%1), in a picture %2 times smaller</source>
        <translation>Flot dense selon un préréglage d’OpenCV (%1), dans une image %2 fois plus petite</translation>
    </message>
    <message>
        <source>Dense flow by a preset of OpenCV (%1), in the whole picture</source>
        <translation>Flot dense selon un préréglage d’OpenCV (%1), dans l’image entière</translation>
    </message>
    <message>
        <source>As in the published work: dense flow in a picture of 512 × 288, and the mean of the points that moved</source>
        <translation>Comme dans les travaux publiés&#xa0;: flot dense dans une image de 512&#xa0;×&#xa0;288, et moyenne de ce qui s’y est déplacé</translation>
    </message>
    <message>
        <source>Only where the picture differs from the reference</source>
        <translation>Seulement autour de ce qui diffère de la référence</translation>
    </message>
    <message>
        <source>Starts from the flow of the previous picture</source>
        <translation>À partir du flot de l’image précédente</translation>
    </message>
    <message>
        <source>Resume</source>
        <translation>Reprendre</translation>
    </message>
    <message>
        <source>Picture not used: %1</source>
        <translation>Non utilisée&#xa0;: %1</translation>
    </message>
    <message>
        <source>Preparing the finder %1.</source>
        <translation>Le détecteur %1 est en préparation.</translation>
    </message>
    <message>
        <source>The arm has retreated from contact %1.</source>
        <translation>Le bras s’est retiré du contact %1.</translation>
    </message>
    <message>
        <source>The arm is at rest.</source>
        <translation>Le bras est à l’arrêt.</translation>
    </message>
    <message>
        <source>The arm is retreating from contact %1.</source>
        <translation>Le bras se retire du contact %1.</translation>
    </message>
    <message>
        <source>How contacts are found: from the printed dots alone, or with dense flow by one of OpenCV&apos;s presets; the number is how many times the image is reduced</source>
        <translation>Comment les contacts sont trouvés&#xa0;: les points imprimés seuls, ou un flot dense selon l’un des préréglages d’OpenCV&#xa0;; le nombre divise la taille de l’image</translation>
    </message>
    <message>
        <source>Take the next picture as the reference: nothing may touch the tube</source>
        <translation>Prendre l’image suivante comme celle du tube intact</translation>
    </message>
    <message>
        <source>Freeze the picture; contacts are still tracked (Space)</source>
        <translation>Garder cette image&#xa0;; le suivi des contacts continue (Espace)</translation>
    </message>
    <message>
        <source>Off: the arm does not react to touch. STOP unticks this; tick it again to let the arm react.</source>
        <translation>Désactivé&#xa0;: le bras ne bouge pas, quoi qui le touche. STOP retire cette autorisation jusqu’à ce que vous la redonniez.</translation>
    </message>
</context>
<context>
    <name>teleta::camera::CameraView</name>
    <message>
        <source>camera</source>
        <translation>caméra</translation>
    </message>
    <message>
        <source>&amp;Pause the picture</source>
        <translation>Mettre l’image en &amp;pause</translation>
    </message>
    <message>
        <source>Show &amp;all</source>
        <translation>&amp;Tout afficher</translation>
    </message>
    <message>
        <source>Camera picture</source>
        <translation>Image de la caméra</translation>
    </message>
    <message>
        <source>&lt;p&gt;What the camera sees inside the tube. Lines show, enlarged, how far the printed pattern has moved since nothing touched the tube; outlines are contacts, each in the colour of its number.&lt;/p&gt;&lt;p&gt;Ctrl+wheel zooms, dragging moves, a double click shows all.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Ce que la caméra voit dans le tube. Les traits montrent, agrandi, le déplacement du motif imprimé depuis que rien ne touchait le tube&#xa0;; les contours sont des contacts, chacun dans la couleur de son numéro.&lt;/p&gt;&lt;p&gt;Ctrl+molette zoome, glisser déplace, un double clic affiche tout.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>&amp;Resume</source>
        <translation>&amp;Reprendre</translation>
    </message>
</context>
<context>
    <name>teleta::camera::EventList</name>
    <message>
        <source>&amp;Clear the list</source>
        <translation>&amp;Vider la liste</translation>
    </message>
    <message>
        <source>Events</source>
        <translation>Événements</translation>
    </message>
</context>
<context>
    <name>teleta::camera::EventModel</name>
    <message>
        <source>touched</source>
        <translation>touché</translation>
    </message>
    <message>
        <source>BUMP</source>
        <translation>CHOC</translation>
    </message>
    <message>
        <source>arm follows</source>
        <translation>le bras suit</translation>
    </message>
    <message>
        <source>reference taken</source>
        <translation>référence prise</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Temps</translation>
    </message>
    <message>
        <source>Event</source>
        <translation>Événement</translation>
    </message>
    <message>
        <source>Contact</source>
        <translation>Contact</translation>
    </message>
    <message>
        <source>Along the tube</source>
        <translation>Le long du tube</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Profondeur</translation>
    </message>
    <message>
        <source>released</source>
        <translation>lâché</translation>
    </message>
    <message>
        <source>restarted</source>
        <translation>recommence</translation>
    </message>
    <message>
        <source>Around the tube</source>
        <translation>Autour</translation>
    </message>
    <message>
        <source>Along</source>
        <comment>the tube</comment>
        <translation>Long.</translation>
    </message>
    <message>
        <source>Around</source>
        <comment>the tube</comment>
        <translation>Tour</translation>
    </message>
</context>
<context>
    <name>teleta::camera::EventTable</name>
    <message>
        <source>camera-events</source>
        <translation>événements-caméra</translation>
    </message>
    <message>
        <source>What happened to the tube, newest first. The context menu copies and saves the list.</source>
        <translation>Ce qui est arrivé au tube, le plus récent en premier. Le menu contextuel copie et enregistre la liste.</translation>
    </message>
</context>
<context>
    <name>teleta::camera::GelEventModel</name>
    <message>
        <source>touched</source>
        <translation>touché</translation>
    </message>
    <message>
        <source>incipient slip</source>
        <translation>début de glissement</translation>
    </message>
    <message>
        <source>SLIP</source>
        <translation>GLISSEMENT</translation>
    </message>
    <message>
        <source>released</source>
        <translation>lâché</translation>
    </message>
    <message>
        <source>rest taken</source>
        <translation>repos pris</translation>
    </message>
    <message>
        <source>restarted</source>
        <translation>recommence</translation>
    </message>
    <message>
        <source>picture is dark</source>
        <translation>image sombre</translation>
    </message>
    <message>
        <source>light jumped</source>
        <translation>saut de lumière</translation>
    </message>
    <message>
        <source>gel torn?</source>
        <translation>gel déchiré&#xa0;?</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Temps</translation>
    </message>
    <message>
        <source>Event</source>
        <translation>Événement</translation>
    </message>
    <message>
        <source>Contact</source>
        <translation>Contact</translation>
    </message>
    <message>
        <source>x</source>
        <translation>x</translation>
    </message>
    <message>
        <source>y</source>
        <translation>y</translation>
    </message>
    <message>
        <source>Shear</source>
        <translation>Cisaillement</translation>
    </message>
    <message>
        <source>Slip index</source>
        <translation>Indice de glissement</translation>
    </message>
</context>
<context>
    <name>teleta::camera::GelEventTable</name>
    <message>
        <source>gel-events</source>
        <translation>gel-evenements</translation>
    </message>
    <message>
        <source>What happened to the gel, newest first. Shear is the mean displacement of the contact&apos;s markers less that of the others. The context menu copies and saves the list.</source>
        <translation>Ce qui est arrivé au gel, le plus récent en premier. Le cisaillement est le déplacement moyen des marqueurs du contact, moins celui des autres. Le menu contextuel copie et enregistre la liste.</translation>
    </message>
</context>
<context>
    <name>teleta::camera::GelPanel</name>
    <message>
        <source>Resume</source>
        <translation>Reprendre</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>%1 of %2 markers</source>
        <translation>%1 marqueurs sur %2</translation>
    </message>
    <message>
        <source>%1 ms per frame, %2 frames/s</source>
        <translation>%1 ms par image, %2 images/s</translation>
    </message>
    <message numerus="yes">
        <source>%n skipped</source>
        <translation>
            <numerusform>%n sautée</numerusform>
            <numerusform>%n sautées</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n unusable</source>
        <translation>
            <numerusform>%n inutilisable</numerusform>
            <numerusform>%n inutilisables</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Taking the gel at rest: nothing may touch it (%n more picture(s)).</source>
        <translation>
            <numerusform>Prise du gel au repos&#xa0;: rien ne doit le toucher (encore %n image).</numerusform>
            <numerusform>Prise du gel au repos&#xa0;: rien ne doit le toucher (encore %n images).</numerusform>
        </translation>
    </message>
    <message>
        <source>&amp;Displacement</source>
        <translation>Dé&amp;placement</translation>
    </message>
    <message>
        <source>Show how far each marker has moved from its place at rest</source>
        <translation>Montrer de combien chaque marqueur s’est éloigné de sa position de repos</translation>
    </message>
    <message>
        <source>&amp;Enlarged</source>
        <translation>&amp;Agrandi</translation>
    </message>
    <message>
        <source>Enlargement of the arrows</source>
        <translation>Agrandissement des flèches</translation>
    </message>
    <message>
        <source>How many times longer than the displacement the arrows are</source>
        <translation>Combien de fois les flèches sont plus longues que le déplacement</translation>
    </message>
    <message>
        <source>New &amp;rest</source>
        <translation>Nouveau &amp;repos</translation>
    </message>
    <message>
        <source>Take the next pictures as the gel at rest: nothing may touch it</source>
        <translation>Prendre les images suivantes comme gel au repos&#xa0;: rien ne doit le toucher</translation>
    </message>
    <message>
        <source>Freeze the picture; markers are still followed (Space)</source>
        <translation>Figer l’image&#xa0;; les marqueurs sont toujours suivis (Espace)</translation>
    </message>
</context>
<context>
    <name>teleta::camera::GelView</name>
    <message>
        <source>gel</source>
        <translation>gel</translation>
    </message>
    <message>
        <source>&amp;Resume</source>
        <translation>&amp;Reprendre</translation>
    </message>
    <message>
        <source>&amp;Pause the picture</source>
        <translation>Mettre l’image en &amp;pause</translation>
    </message>
    <message>
        <source>Take the gel at &amp;rest anew</source>
        <translation>Prendre à nouveau le gel au &amp;repos</translation>
    </message>
    <message>
        <source>Picture of the gel</source>
        <translation>Image du gel</translation>
    </message>
    <message>
        <source>&lt;p&gt;What the camera sees of the gel. Arrows show, enlarged, how far each marker has moved from its place at rest; a cross is a marker that is lost. Outlines are contacts, each in the colour of its number.&lt;/p&gt;&lt;p&gt;The slip index is the share of the contact&apos;s markers that do not move with it: green while it sticks, amber when a part of it slips, red when all of it does.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Ce que la caméra voit du gel. Les flèches montrent, agrandi, de combien chaque marqueur s’est éloigné de sa position de repos&#xa0;; une croix est un marqueur perdu. Les contours sont des contacts, chacun dans la couleur de son numéro.&lt;/p&gt;&lt;p&gt;L’indice de glissement est la part des marqueurs du contact qui ne bougent pas avec lui&#xa0;: vert tant qu’il adhère, ambre quand une partie glisse, rouge quand tout glisse.&lt;/p&gt;</translation>
    </message>
</context>
<context>
    <name>teleta::camera::PairModel</name>
    <message>
        <source>kept</source>
        <translation>gardée</translation>
    </message>
    <message>
        <source>wrong</source>
        <translation>fausse</translation>
    </message>
    <message>
        <source>excluded</source>
        <translation>exclue</translation>
    </message>
    <message>
        <source>Pair</source>
        <translation>Paire</translation>
    </message>
    <message>
        <source>State</source>
        <translation>État</translation>
    </message>
    <message>
        <source>Pixel</source>
        <translation>Pixel</translation>
    </message>
    <message>
        <source>Point</source>
        <translation>Point</translation>
    </message>
    <message>
        <source>Image</source>
        <translation>Image</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Surface</translation>
    </message>
</context>
<context>
    <name>teleta::camera::ResidualView</name>
    <message>
        <source>Residuals on the image</source>
        <translation>Résidus dans l’image</translation>
    </message>
    <message>
        <source>Residuals on the unrolled cylinder</source>
        <translation>Résidus sur le cylindre déroulé</translation>
    </message>
    <message>
        <source>&lt;p&gt;Each pair at its point on the cylinder, cut open at the back, with an enlarged arrow to where its pixel is located. The colour is the error along the axis.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Chaque paire à son point sur le cylindre, ouvert à l’arrière, avec une flèche agrandie vers l’endroit où son pixel est localisé. La couleur est l’erreur le long de l’axe.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Pair %1</source>
        <translation>Paire %1</translation>
    </message>
    <message>
        <source>kept</source>
        <translation>gardée</translation>
    </message>
    <message>
        <source>left out as wrong</source>
        <translation>écartée comme fausse</translation>
    </message>
    <message>
        <source>excluded by you</source>
        <translation>exclue par vous</translation>
    </message>
    <message>
        <source>off by %1 in the image</source>
        <translation>écart de %1 dans l’image</translation>
    </message>
    <message>
        <source>off by %1 on the cylinder</source>
        <translation>écart de %1 sur le cylindre</translation>
    </message>
    <message>
        <source>residuals-image</source>
        <translation>résidus-image</translation>
    </message>
    <message>
        <source>residuals-cylinder</source>
        <translation>résidus-cylindre</translation>
    </message>
    <message>
        <source>&amp;Exclude pair %1</source>
        <translation>&amp;Exclure la paire %1</translation>
    </message>
    <message>
        <source>&amp;Use pair %1 again</source>
        <translation>&amp;Réutiliser la paire %1</translation>
    </message>
    <message>
        <source>&lt;p&gt;Each pair at its pixel, with an enlarged arrow to where the camera projects its point. Random arrows are noise; a pattern shows something that the camera model misses.&lt;/p&gt;&lt;p&gt;Pixels outside the dashed circle have no ray.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Chaque paire à son pixel, avec une flèche agrandie vers l’endroit où la caméra projette son point. Des flèches sans structure sont du bruit&#xa0;; des flèches qui s’ordonnent révèlent un effet que la caméra ne décrit pas.&lt;/p&gt;&lt;p&gt;Un pixel hors du cercle en tirets n’a pas de rayon.&lt;/p&gt;</translation>
    </message>
</context>
<context>
    <name>teleta::camera::SceneTile</name>
    <message>
        <source>Waiting for the first picture</source>
        <translation>En attente de la première image</translation>
    </message>
    <message>
        <source>No picture for %1</source>
        <translation>Pas d’image depuis %1</translation>
    </message>
    <message>
        <source>%1 × %2</source>
        <translation>%1 × %2</translation>
    </message>
    <message>
        <source>Hz</source>
        <translation>Hz</translation>
    </message>
    <message>
        <source>ms</source>
        <translation>ms</translation>
    </message>
    <message>
        <source>scene</source>
        <translation>scène</translation>
    </message>
    <message>
        <source>Picture of %1</source>
        <comment>a camera</comment>
        <translation>Image de %1</translation>
    </message>
    <message>
        <source>&lt;p&gt;What a camera sees now. Above it stand the size of its pictures, how many come in a second, and the age of the one that is shown: the time since it was read.&lt;/p&gt;&lt;p&gt;A picture that is too old for the camera&apos;s rate is dimmed, and says for how long none has come.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Ce qu’une caméra voit maintenant. Au-dessus figurent la taille de ses images, combien il en vient par seconde, et l’âge de celle qui est affichée&#xa0;: le temps depuis sa lecture.&lt;/p&gt;&lt;p&gt;Une image trop vieille pour la cadence de la caméra est assombrie et dit depuis combien de temps il n’en vient plus.&lt;/p&gt;</translation>
    </message>
</context>
<context>
    <name>teleta::camera::StageBar</name>
    <message>
        <source>prepare</source>
        <translation>préparation</translation>
    </message>
    <message>
        <source>displacement</source>
        <translation>déplacement</translation>
    </message>
    <message>
        <source>segment</source>
        <translation>segmentation</translation>
    </message>
    <message>
        <source>locate</source>
        <translation>localisation</translation>
    </message>
    <message numerus="yes">
        <source>%n unusable</source>
        <translation>
            <numerusform>%n inutilisable</numerusform>
            <numerusform>%n inutilisables</numerusform>
        </translation>
    </message>
    <message>
        <source>%1: %2 ms</source>
        <comment>stage of a computation and its time</comment>
        <translation>%1&#xa0;: %2 ms</translation>
    </message>
    <message>
        <source>%1 ms per frame, %2 frames/s</source>
        <translation>%1 ms par image, %2 images/s</translation>
    </message>
    <message numerus="yes">
        <source>%n skipped</source>
        <translation>
            <numerusform>%n sautée</numerusform>
            <numerusform>%n sautées</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>teleta::charts::JointChartView</name>
    <message>
        <source>Joint torques and angles of the arm</source>
        <translation>Couples et angles articulaires du bras</translation>
    </message>
    <message>
        <source>No arm. Open a scene or a device with an arm.</source>
        <translation>Pas de bras. Ouvrez une scène ou un appareil avec un bras.</translation>
    </message>
    <message>
        <source>Angles</source>
        <translation>Angles</translation>
    </message>
    <message>
        <source>Show the joint angles too</source>
        <translation>Afficher aussi les angles articulaires</translation>
    </message>
    <message>
        <source>at %1 s   arm time %2 s</source>
        <translation>à %1 s   temps du bras %2 s</translation>
    </message>
    <message>
        <source>joints</source>
        <translation>articulations</translation>
    </message>
    <message>
        <source>&lt;p&gt;Torque of each joint over time. The coloured band is the torque window in which a touch is evaluated. Grey stretches are touches with their numbers, from the first torque above the noise to the estimate.&lt;/p&gt;&lt;p&gt;Drag or Shift+wheel scrolls, Ctrl+wheel changes the span, Space pauses, End goes back to live. Double-click an axis to type its range.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Couple de chaque articulation au cours du temps. La bande colorée est la fenêtre de couple&#xa0;: un toucher est évalué entre ses bornes. Les zones grises sont des touchers avec leurs numéros, du premier couple au-dessus du bruit à l’estimation.&lt;/p&gt;&lt;p&gt;Glisser ou Shift+molette fait défiler, Ctrl+molette change la durée affichée, Espace met en pause, Fin revient au direct. Double-cliquez sur un axe pour saisir ses bornes.&lt;/p&gt;</translation>
    </message>
</context>
<context>
    <name>teleta::charts::JointPlot</name>
    <message>
        <source>shoulder roll</source>
        <translation>roulis de l’épaule</translation>
    </message>
    <message>
        <source>shoulder pitch</source>
        <translation>tangage de l’épaule</translation>
    </message>
    <message>
        <source>shoulder yaw</source>
        <translation>lacet de l’épaule</translation>
    </message>
    <message>
        <source>elbow pitch</source>
        <translation>tangage du coude</translation>
    </message>
    <message>
        <source>Joint torque</source>
        <translation>Couple articulaire</translation>
    </message>
    <message>
        <source>Joint angle</source>
        <translation>Angle articulaire</translation>
    </message>
    <message>
        <source>joint %1</source>
        <translation>articulation %1</translation>
    </message>
</context>
<context>
    <name>teleta::charts::StripChartView</name>
    <message>
        <source>Strip charts of the tactile features</source>
        <translation>Graphiques défilants des caractéristiques tactiles</translation>
    </message>
    <message>
        <source>Strips</source>
        <translation>Bandes</translation>
    </message>
    <message>
        <source>Choose which strips are shown</source>
        <translation>Choisir les bandes affichées</translation>
    </message>
    <message>
        <source>Choose strips</source>
        <translation>Choisir les bandes</translation>
    </message>
    <message>
        <source>Mark</source>
        <translation>Marquer</translation>
    </message>
    <message>
        <source>Mark this moment (M)</source>
        <translation>Marquer cet instant (M)</translation>
    </message>
    <message>
        <source>at %1 s   stream time %2 s</source>
        <translation>à %1 s   temps du flux %2 s</translation>
    </message>
    <message>
        <source>charts</source>
        <translation>graphiques</translation>
    </message>
    <message>
        <source>&amp;Strips</source>
        <translation>&amp;Bandes</translation>
    </message>
    <message>
        <source>&lt;p&gt;Force, centres, moment deviation and orientation of the contact over time. The numbers beside the strips are the newest values, or those at the cursor.&lt;/p&gt;&lt;p&gt;A gap in a line means that nothing is known there: there was no contact, samples were lost, or the recording jumped (dotted line).&lt;/p&gt;&lt;p&gt;Drag or Shift+wheel scrolls, Ctrl+wheel changes the span, Space pauses, End goes back to live. Double-click an axis to type its range.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Force, centres, écart de moment et orientation du contact au cours du temps. Les nombres à côté des bandes sont les dernières valeurs, ou celles au curseur.&lt;/p&gt;&lt;p&gt;Une ligne qui s’arrête et reprend signifie que rien n’est connu dans l’intervalle&#xa0;: le contact avait disparu, des échantillons ont été perdus, ou l’enregistrement a sauté (ligne pointillée).&lt;/p&gt;&lt;p&gt;Glisser ou Shift+molette fait défiler, Ctrl+molette change la durée affichée, Espace met en pause, Fin revient au direct. Double-cliquez sur un axe pour saisir ses bornes.&lt;/p&gt;</translation>
    </message>
</context>
<context>
    <name>teleta::charts::TimeChartView</name>
    <message>
        <source>S&amp;pan</source>
        <translation>&amp;Durée affichée</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>Show %1 s (Ctrl+wheel for other spans)</source>
        <translation>Afficher %1 s (Ctrl+molette pour d’autres durées)</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>at %1 s   no sample</source>
        <translation>à %1 s   pas d’échantillon</translation>
    </message>
    <message>
        <source>last %1 s</source>
        <translation>dernières %1 s</translation>
    </message>
    <message>
        <source>PAUSED, %1 s behind   %2</source>
        <translation>EN PAUSE, %1 s de retard   %2</translation>
    </message>
    <message>
        <source>Lower and upper end, for example -5 5. Empty: automatic.</source>
        <translation>Bornes inférieure et supérieure, par exemple -5 5. Vide&#xa0;: automatique.</translation>
    </message>
    <message>
        <source>auto</source>
        <translation>auto</translation>
    </message>
    <message>
        <source>&amp;Type range of %1…</source>
        <translation>&amp;Saisir la plage de %1…</translation>
    </message>
    <message>
        <source>&amp;Automatic range</source>
        <translation>Plage &amp;automatique</translation>
    </message>
    <message>
        <source>Go live</source>
        <translation>En direct</translation>
    </message>
    <message>
        <source>Freeze the chart; samples are still collected (Space)</source>
        <translation>Figer l’image&#xa0;; les échantillons continuent d’être conservés (Espace)</translation>
    </message>
    <message>
        <source>Range of the axis of %1</source>
        <translation>Bornes de l’axe de %1</translation>
    </message>
</context>
<context>
    <name>teleta::charts::TimePlot</name>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
</context>
<context>
    <name>teleta::chrome::DemoCard</name>
    <message>
        <source>Done. %1</source>
        <translation>Fait. %1</translation>
    </message>
</context>
<context>
    <name>teleta::chrome::DeviceStrip</name>
    <message>
        <source>Devices</source>
        <translation>Appareils</translation>
    </message>
    <message>
        <source>%1 for %2</source>
        <comment>state of a device and its age</comment>
        <translation>%1 depuis %2</translation>
    </message>
    <message>
        <source>Hz</source>
        <translation>Hz</translation>
    </message>
    <message>
        <source>%1 lost</source>
        <comment>frames</comment>
        <translation>%1 perdues</translation>
    </message>
    <message>
        <source>to screen %1 ms</source>
        <translation>à l’écran %1 ms</translation>
    </message>
    <message>
        <source>No device</source>
        <translation>Pas d’appareil</translation>
    </message>
    <message>
        <source>State: %1</source>
        <translation>État&#xa0;: %1</translation>
    </message>
    <message>
        <source>Rate: %1 Hz</source>
        <translation>Fréquence&#xa0;: %1 Hz</translation>
    </message>
    <message>
        <source>Frames lost: %1</source>
        <translation>Trames perdues&#xa0;: %1</translation>
    </message>
    <message>
        <source>Frames displayed: %1</source>
        <translation>Trames affichées&#xa0;: %1</translation>
    </message>
    <message>
        <source>Age of the newest frame: %1</source>
        <translation>Âge de la dernière trame&#xa0;: %1</translation>
    </message>
    <message>
        <source>touch to skin %1 ms</source>
        <translation>du toucher à la peau %1 ms</translation>
    </message>
    <message>
        <source>From the completed touch to the first frame of its pattern: %1 ms</source>
        <translation>De la fin du toucher à la première trame de son motif&#xa0;: %1 ms</translation>
    </message>
    <message>
        <source>From sensor read to screen: %1 ms</source>
        <translation>De la lecture à l’écran&#xa0;: %1 ms</translation>
    </message>
    <message>
        <source>rec</source>
        <comment>recorded, short</comment>
        <translation>enr</translation>
    </message>
    <message>
        <source>rec sim</source>
        <comment>a recorded simulation, short</comment>
        <translation>enr sim</translation>
    </message>
    <message>
        <source>sim</source>
        <comment>simulated, short</comment>
        <translation>sim</translation>
    </message>
</context>
<context>
    <name>teleta::chrome::FirstSteps</name>
    <message>
        <source>First steps</source>
        <translation>Premiers pas</translation>
    </message>
    <message>
        <source>Hide the first steps; the handbook has them</source>
        <translation>Masquer les premiers pas&#xa0;; le manuel les contient</translation>
    </message>
    <message>
        <source>Hide the first steps</source>
        <translation>Masquer les premiers pas</translation>
    </message>
    <message>
        <source>Touch something</source>
        <translation>Touchez quelque chose</translation>
    </message>
    <message>
        <source>A simulated arm touches five materials: contact, force, stiffness</source>
        <translation>Un bras simulé touche cinq matériaux&#xa0;: contact, force, raideur</translation>
    </message>
    <message>
        <source>Say it with a pattern</source>
        <translation>Dites-le par un motif</translation>
    </message>
    <message>
        <source>Open a built-in pattern and play it with Space</source>
        <translation>Ouvrez un motif intégré et jouez-le avec Espace</translation>
    </message>
    <message>
        <source>Watch a study</source>
        <translation>Observez une étude</translation>
    </message>
    <message>
        <source>Simulated participants answer, and the confusion matrix fills</source>
        <translation>Des participants simulés répondent, et la matrice de confusion se remplit</translation>
    </message>
</context>
<context>
    <name>teleta::chrome::MessageBar</name>
    <message>
        <source>Messages</source>
        <translation>Messages</translation>
    </message>
    <message numerus="yes">
        <source>%n older message(s)</source>
        <translation>
            <numerusform>%n message plus ancien</numerusform>
            <numerusform>%n messages plus anciens</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>since %1, %n times</source>
        <translation>
            <numerusform>depuis %1, %n fois</numerusform>
            <numerusform>depuis %1, %n fois</numerusform>
        </translation>
    </message>
    <message>
        <source>Hide details</source>
        <translation>Masquer les détails</translation>
    </message>
    <message>
        <source>Details</source>
        <translation>Détails</translation>
    </message>
    <message>
        <source>Dismiss</source>
        <translation>Fermer</translation>
    </message>
</context>
<context>
    <name>teleta::chrome::MessageLog</name>
    <message>
        <source>Error</source>
        <translation>Erreur</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>Avertissement</translation>
    </message>
    <message>
        <source>Information</source>
        <translation>Information</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Heure</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Genre</translation>
    </message>
    <message>
        <source>Message</source>
        <translation>Message</translation>
    </message>
</context>
<context>
    <name>teleta::chrome::PageRail</name>
    <message>
        <source>Pages</source>
        <translation>Pages</translation>
    </message>
    <message>
        <source>%1 (Ctrl+%2)</source>
        <comment>tool tip of a page and its shortcut</comment>
        <translation>%1 (Ctrl+%2)</translation>
    </message>
</context>
<context>
    <name>teleta::chrome::PlaybackBar</name>
    <message>
        <source>%1 / %2</source>
        <comment>time and duration</comment>
        <translation>%1 / %2</translation>
    </message>
    <message>
        <source>Frame %1 of %2</source>
        <translation>Trame %1 sur %2</translation>
    </message>
    <message>
        <source>Playback</source>
        <translation>Lecture</translation>
    </message>
    <message>
        <source>To the start</source>
        <translation>Au début</translation>
    </message>
    <message>
        <source>Home</source>
        <translation>Début</translation>
    </message>
    <message>
        <source>One frame back</source>
        <translation>Une trame en arrière</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Gauche</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Lire</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Space</source>
        <translation>Espace</translation>
    </message>
    <message>
        <source>One frame forward</source>
        <translation>Une trame en avant</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Droite</translation>
    </message>
    <message>
        <source>Time in the recording</source>
        <translation>Temps dans l’enregistrement</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Vitesse</translation>
    </message>
    <message>
        <source>Repeat</source>
        <translation>Recommencer à la fin</translation>
    </message>
</context>
<context>
    <name>teleta::chrome::RecentList</name>
    <message>
        <source>Recent:</source>
        <translation>Récents&#xa0;:</translation>
    </message>
    <message>
        <source>Reopen %1</source>
        <comment>what was open</comment>
        <translation>Rouvrir %1</translation>
    </message>
    <message>
        <source>What was open when the console was closed</source>
        <translation>Ce qui était ouvert à la fermeture de la console</translation>
    </message>
</context>
<context>
    <name>teleta::chrome::RecordingIndicator</name>
    <message numerus="yes">
        <source>Recording %1 · %2 · %n lost</source>
        <comment>time, size of the file, frames</comment>
        <translation>
            <numerusform>Enregistrement %1 · %2 · %n perdue</numerusform>
            <numerusform>Enregistrement %1 · %2 · %n perdues</numerusform>
        </translation>
    </message>
    <message>
        <source>Record</source>
        <translation>Enregistrer</translation>
    </message>
    <message>
        <source>End the recording (Ctrl+R)</source>
        <translation>Terminer l’enregistrement (Ctrl+R)</translation>
    </message>
    <message>
        <source>Record all sources and the bracelet into a file (Ctrl+R)</source>
        <translation>Enregistrer toutes les sources et le bracelet dans un fichier (Ctrl+R)</translation>
    </message>
    <message>
        <source>End the recording</source>
        <translation>Terminer l’enregistrement</translation>
    </message>
    <message>
        <source>Mark</source>
        <translation>Marquer</translation>
    </message>
    <message>
        <source>Mark this moment (M)</source>
        <translation>Marquer cet instant (M)</translation>
    </message>
    <message>
        <source>Mark this moment</source>
        <translation>Marquer cet instant</translation>
    </message>
    <message>
        <source>Starting…</source>
        <translation>Démarrage…</translation>
    </message>
    <message>
        <source>Finishing…</source>
        <translation>Finalisation…</translation>
    </message>
    <message>
        <source>Recording failed</source>
        <translation>Enregistrement échoué</translation>
    </message>
    <message>
        <source>Recording failed. Record</source>
        <translation>Enregistrement échoué. Enregistrer</translation>
    </message>
</context>
<context>
    <name>teleta::chrome::SourceChooser</name>
    <message>
        <source>%1 (opening…)</source>
        <comment>a source</comment>
        <translation>%1 (ouverture…)</translation>
    </message>
    <message>
        <source>%1 — %2</source>
        <comment>a source and whether its data are simulated or recorded</comment>
        <translation>%1 — %2</translation>
    </message>
    <message>
        <source>No source</source>
        <translation>Pas de source</translation>
    </message>
    <message>
        <source>Open &amp;recording…</source>
        <translation>Ouvrir un en&amp;registrement…</translation>
    </message>
    <message>
        <source>Open &amp;scene file…</source>
        <translation>Ouvrir un fichier de &amp;scène…</translation>
    </message>
    <message>
        <source>Open source &amp;list…</source>
        <translation>Ouvrir une &amp;liste de sources…</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Source</translation>
    </message>
    <message>
        <source>&amp;Open</source>
        <translation>&amp;Ouvrir</translation>
    </message>
    <message>
        <source>Open a simulated scene or a recording</source>
        <translation>Ouvrir une scène simulée ou un enregistrement</translation>
    </message>
    <message>
        <source>Close source</source>
        <translation>Fermer la source</translation>
    </message>
    <message>
        <source>Close this source</source>
        <translation>Fermer cette source</translation>
    </message>
    <message>
        <source>Open &amp;camera…</source>
        <translation>Ouvrir une &amp;caméra…</translation>
    </message>
    <message>
        <source>A camera in the soft tube, or a video of one, with its calibration</source>
        <translation>Une caméra dans le tube souple, ou une vidéo d’une telle caméra, avec son étalonnage</translation>
    </message>
    <message>
        <source>The source that the views show</source>
        <translation>La source que montrent les vues</translation>
    </message>
    <message>
        <source>Open &amp;arm…</source>
        <translation>Ouvrir un &amp;bras…</translation>
    </message>
    <message>
        <source>An arm over ROS 2, described in a file</source>
        <translation>Un bras sur ROS 2, décrit dans un fichier</translation>
    </message>
    <message>
        <source>A recording of this program or as MCAP, or recorded frames of an array: CSV, NumPy, HDF5, MATLAB, Tekscan</source>
        <translation>Un enregistrement de ce programme ou en MCAP, ou des trames d’une matrice : CSV, NumPy, HDF5, MATLAB, Tekscan</translation>
    </message>
</context>
<context>
    <name>teleta::chrome::StopBanner</name>
    <message>
        <source>The STOP button was pressed.</source>
        <translation>Le bouton STOP a été pressé.</translation>
    </message>
    <message>
        <source>Ctrl+. was pressed.</source>
        <translation>Ctrl+. a été pressé.</translation>
    </message>
    <message>
        <source>Esc was pressed twice.</source>
        <translation>Esc a été pressé deux fois.</translation>
    </message>
    <message>
        <source>The program engaged STOP.</source>
        <translation>Le programme a déclenché STOP.</translation>
    </message>
    <message>
        <source>STOPPED since %1. %2</source>
        <comment>time, cause</comment>
        <translation>ARRÊTÉ depuis&#xa0;%1.&#xa0;%2</translation>
    </message>
    <message>
        <source>Motors are off and arms are held. To continue, hold the STOPPED button for one second.</source>
        <translation>Les moteurs sont à l’arrêt et les bras maintenus. Pour reprendre, maintenez le bouton ARRÊTÉ pendant une seconde.</translation>
    </message>
</context>
<context>
    <name>teleta::chrome::StopButton</name>
    <message>
        <source>STOP</source>
        <translation>STOP</translation>
    </message>
    <message>
        <source>STOPPED</source>
        <translation>ARRÊTÉ</translation>
    </message>
    <message>
        <source>hold to release</source>
        <translation>maintenir pour relâcher</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation>Arrêté</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Arrêter</translation>
    </message>
    <message>
        <source>Everything that moves is stopped. Hold for a second to release.</source>
        <translation>Tout ce qui bouge est arrêté. Maintenez une seconde pour relâcher.</translation>
    </message>
    <message>
        <source>Stops everything that moves at once.</source>
        <translation>Arrête aussitôt tout ce qui bouge.</translation>
    </message>
    <message>
        <source>Stop everything that moves at once (Esc Esc, or Ctrl+.)</source>
        <translation>Arrêter aussitôt tout ce qui bouge (Esc Esc, ou Ctrl+.)</translation>
    </message>
</context>
<context>
    <name>teleta::chrome::TimeSlider</name>
    <message>
        <source>Mark</source>
        <translation>Marque</translation>
    </message>
</context>
<context>
    <name>teleta::console::BraceletMenu</name>
    <message>
        <source>&amp;Simulated</source>
        <translation>&amp;Simulé</translation>
    </message>
    <message>
        <source>&amp;USB</source>
        <translation>&amp;USB</translation>
    </message>
    <message>
        <source>&amp;None</source>
        <translation>&amp;Aucun</translation>
    </message>
    <message>
        <source>Devices (*.toml)</source>
        <translation>Appareils (*.toml)</translation>
    </message>
    <message>
        <source>File: %1</source>
        <comment>a device file</comment>
        <translation>Fichier&#xa0;: %1</translation>
    </message>
    <message>
        <source>&amp;Device file…</source>
        <translation>&amp;Fichier d’appareil…</translation>
    </message>
    <message>
        <source>Open the file of a bracelet</source>
        <translation>Ouvrir le fichier d’un bracelet</translation>
    </message>
    <message>
        <source>A file that describes the registers of a Modbus motor driver, the ids of a USB bracelet, or the outputs of a sound card</source>
        <translation>Un fichier qui décrit les registres d’un pilote de moteurs Modbus, les identifiants d’un bracelet USB, ou les sorties d’une carte son</translation>
    </message>
</context>
<context>
    <name>teleta::console::CalibratePage</name>
    <message>
        <source>What can be calibrated</source>
        <translation>Ce qui peut être étalonné</translation>
    </message>
    <message>
        <source>Bracelet motors</source>
        <translation>Moteurs du bracelet</translation>
    </message>
    <message>
        <source>Cylinder camera</source>
        <translation>Caméra du cylindre</translation>
    </message>
    <message>
        <source>Taxel gains</source>
        <translation>Gains des taxels</translation>
    </message>
    <message>
        <source>Unsaved calibration</source>
        <translation>Étalonnage non enregistré</translation>
    </message>
    <message>
        <source>%1: the calibration is not saved.</source>
        <comment>a part of the page</comment>
        <translation>%1&#xa0;: l’étalonnage n’est pas enregistré.</translation>
    </message>
    <message>
        <source>Discarded values must be measured again.</source>
        <translation>Ce qui est abandonné devra être mesuré à nouveau.</translation>
    </message>
    <message>
        <source>The taxel gains of %1 are not saved.</source>
        <comment>a source</comment>
        <translation>Les gains des taxels de&#xa0;%1 ne sont pas enregistrés.</translation>
    </message>
    <message>
        <source>They are lost when the source is closed. Save them on the page Calibrate.</source>
        <translation>Ils sont perdus quand la source est fermée. La page Étalonnage les enregistre.</translation>
    </message>
</context>
<context>
    <name>teleta::console::CameraCalibrator</name>
    <message>
        <source>Saved %1</source>
        <translation>Enregistré&#xa0;: %1</translation>
    </message>
    <message>
        <source>Cylinder camera</source>
        <translation>Caméra du cylindre</translation>
    </message>
    <message>
        <source>Pairs of pixels and points: CSV with u_px,v_px,x_m,y_m,z_m</source>
        <translation>Paires de pixels et de points&#xa0;: CSV avec u_px,v_px,x_m,y_m,z_m</translation>
    </message>
    <message>
        <source>&amp;Probe the simulated tube</source>
        <translation>&amp;Palper le tube simulé</translation>
    </message>
    <message>
        <source>&amp;Method:</source>
        <translation>Mét&amp;hode&#xa0;:</translation>
    </message>
    <message>
        <source>Method of calibration</source>
        <translation>Méthode d’étalonnage</translation>
    </message>
    <message>
        <source>Linear (DLT)</source>
        <translation>Linéaire (DLT)</translation>
    </message>
    <message>
        <source>As in the paper</source>
        <translation>Comme dans l’article</translation>
    </message>
    <message>
        <source>Least squares</source>
        <translation>Moindres carrés</translation>
    </message>
    <message>
        <source>Robust</source>
        <translation>Robuste</translation>
    </message>
    <message>
        <source>&amp;Exclude wrong pairs</source>
        <translation>Exclure les paires &amp;fausses</translation>
    </message>
    <message>
        <source>Methods side by side</source>
        <translation>Comparaison des méthodes</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Méthode</translation>
    </message>
    <message>
        <source>Kept</source>
        <translation>Gardées</translation>
    </message>
    <message>
        <source>Image, mean</source>
        <translation>Image, moyenne</translation>
    </message>
    <message>
        <source>Surface, mean</source>
        <translation>Surface, moyenne</translation>
    </message>
    <message>
        <source>Uncertainty</source>
        <translation>Incertitude</translation>
    </message>
    <message>
        <source>Remark</source>
        <translation>Remarque</translation>
    </message>
    <message>
        <source>Pairs</source>
        <translation>Paires</translation>
    </message>
    <message>
        <source>&amp;Exclude, or use again</source>
        <translation>&amp;Exclure ou réutiliser</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>&amp;Supprimer</translation>
    </message>
    <message>
        <source>Save the camera</source>
        <translation>Enregistrer la caméra</translation>
    </message>
    <message>
        <source>Save the pairs</source>
        <translation>Enregistrer les paires</translation>
    </message>
    <message>
        <source>Load pairs</source>
        <translation>Charger des paires</translation>
    </message>
    <message>
        <source>Cameras (*.json)</source>
        <translation>Caméras (*.json)</translation>
    </message>
    <message>
        <source>probing</source>
        <translation>palpage</translation>
    </message>
    <message>
        <source>loading</source>
        <translation>chargement</translation>
    </message>
    <message>
        <source>added pair</source>
        <translation>paire ajoutée</translation>
    </message>
    <message numerus="yes">
        <source>removal of %n pair(s)</source>
        <translation>
            <numerusform>suppression de %n paire</numerusform>
            <numerusform>suppression de %n paires</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>use of %n pair(s)</source>
        <translation>
            <numerusform>utilisation de %n paire</numerusform>
            <numerusform>utilisation de %n paires</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>exclusion of %n pair(s)</source>
        <translation>
            <numerusform>exclusion de %n paire</numerusform>
            <numerusform>exclusion de %n paires</numerusform>
        </translation>
    </message>
    <message>
        <source>image and cylinder</source>
        <translation>image et cylindre</translation>
    </message>
    <message>
        <source>No calibration: %1.</source>
        <translation>Pas d’étalonnage&#xa0;: %1.</translation>
    </message>
    <message numerus="yes">
        <source>%1 of %n pair(s) kept; </source>
        <translation>
            <numerusform>%1 sur %n paire gardée&#xa0;; </numerusform>
            <numerusform>%1 sur %n paires gardées&#xa0;; </numerusform>
        </translation>
    </message>
    <message>
        <source>SIMULATED</source>
        <translation>SIMULÉ</translation>
    </message>
    <message>
        <source>has a pattern</source>
        <translation>a une structure</translation>
    </message>
    <message>
        <source>Load pairs of pixels and probed points, drop their file here, type them in below, or probe a tube.</source>
        <translation>Chargez des paires de pixels et de points palpés, déposez leur fichier ici, saisissez-les ci-dessous ou palpez un tube.</translation>
    </message>
    <message>
        <source>It is valid within %1 of its axis. </source>
        <translation>Elle est valable jusqu’à %1 de son axe. </translation>
    </message>
    <message>
        <source>probed hole</source>
        <translation>trou palpé</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Annuler</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Rétablir</translation>
    </message>
    <message>
        <source>&amp;Load pairs…</source>
        <translation>&amp;Charger des paires…</translation>
    </message>
    <message>
        <source>Save pai&amp;rs…</source>
        <translation>Enre&amp;gistrer les paires…</translation>
    </message>
    <message>
        <source>&amp;Save camera…</source>
        <translation>Enregistrer la ca&amp;méra…</translation>
    </message>
    <message>
        <source>Probe with a &amp;camera…</source>
        <translation>Palper avec une &amp;caméra…</translation>
    </message>
    <message>
        <source>Calibrating…</source>
        <translation>Étalonnage…</translation>
    </message>
    <message>
        <source>Save all pairs, including excluded ones, to load them again later</source>
        <translation>Toutes les paires, aussi celles écartées, telles qu’elles ont été chargées</translation>
    </message>
    <message>
        <source>Save the camera found by the chosen method, for teleta locate and the camera view</source>
        <translation>La caméra de la méthode choisie, pour teleta locate et la vue de la caméra</translation>
    </message>
    <message>
        <source>Collect pairs: a simulated person presses a stick on the marked places of a simulated tube and mistakes one in ten for its neighbour</source>
        <translation>Recueillir des paires&#xa0;: une personne simulée appuie un bâton aux endroits marqués d’un tube simulé, et en prend un sur dix pour son voisin</translation>
    </message>
    <message>
        <source>Collect pairs: press a stick through the holes of a shell while a camera watches, live or in a video</source>
        <translation>Recueillir des paires&#xa0;: appuyer un bâton à travers les trous d’une coque pendant qu’une caméra, ou une vidéo, est observée</translation>
    </message>
    <message>
        <source>Exclude the pairs marked as wrong, for every method</source>
        <translation>Écarte pour toutes les méthodes les paires marquées comme fausses</translation>
    </message>
    <message>
        <source>&lt;p&gt;Finds the camera inside the tactile cylinder from pairs of a pixel and the surface point that was probed there.&lt;/p&gt;&lt;p&gt;Load a CSV file, drop it here, or type pairs in. Wrong pairs are detected and left out; you can exclude more, remove them (Delete in the table) and undo every step.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Trouve la caméra dans le cylindre tactile à partir de paires&#xa0;: un pixel et le point de la surface qui y a été palpé.&lt;/p&gt;&lt;p&gt;Chargez un fichier CSV ou déposez-le ici, ou saisissez des paires. Les paires fausses sont trouvées et écartées&#xa0;; vous pouvez en exclure d’autres ou les supprimer (Suppr dans le tableau), et annuler chaque étape.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>The camera was not saved. Wait until it is calibrated.</source>
        <translation>La caméra n’a pas été enregistrée&#xa0;: l’étalonnage est en cours.</translation>
    </message>
    <message>
        <source>Waiting for the first touch.</source>
        <translation>Le premier toucher est attendu.</translation>
    </message>
    <message>
        <source>their points are located to within %1 on average; the camera&apos;s uncertainty is %2. </source>
        <translation>leurs points sont localisés à %1 près en moyenne, et la caméra est sûre à %2 près. </translation>
    </message>
    <message>
        <source>This method ignores lens distortion: use it only for comparison.</source>
        <translation>Cette méthode ne connaît pas d’objectif&#xa0;: ne l’utilisez que pour comparer.</translation>
    </message>
    <message>
        <source>The residuals show no pattern, as they should.</source>
        <translation>Les résidus sont sans structure. Bien.</translation>
    </message>
    <message>
        <source>Pairs (*.csv)</source>
        <translation>Paires (*.csv)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>points off the cylinder</source>
        <translation>points hors du cylindre</translation>
    </message>
    <message>
        <source>points beyond the ends</source>
        <translation>points au-delà des extrémités</translation>
    </message>
    <message>
        <source>u and v swapped?</source>
        <translation>u et v échangés&#xa0;?</translation>
    </message>
    <message>
        <source>pixels outside the image</source>
        <translation>pixels hors de l’image</translation>
    </message>
    <message>
        <source>Caution: %1.</source>
        <translation>Attention&#xa0;: %1.</translation>
    </message>
</context>
<context>
    <name>teleta::console::CameraDialog</name>
    <message>
        <source>Start &amp;again at the end</source>
        <translation>Recommencer à la &amp;fin</translation>
    </message>
    <message>
        <source>Open camera</source>
        <translation>Ouvrir une caméra</translation>
    </message>
    <message>
        <source>…</source>
        <translation>…</translation>
    </message>
    <message>
        <source>&amp;Camera or video:</source>
        <translation>&amp;Caméra ou vidéo&#xa0;:</translation>
    </message>
    <message>
        <source>Ca&amp;libration:</source>
        <translation>É&amp;talonnage&#xa0;:</translation>
    </message>
    <message>
        <source>Choose a camera file</source>
        <translation>Choisir un fichier de caméra</translation>
    </message>
    <message>
        <source>Camera file</source>
        <translation>Fichier de caméra</translation>
    </message>
    <message>
        <source>Camera files (*.json)</source>
        <translation>Fichiers de caméra (*.json)</translation>
    </message>
    <message>
        <source>The camera file that the page Calibrate or teleta calibrate has written; without one the camera is only looked at</source>
        <translation>Le fichier de caméra écrit par la page Étalonnage ou par teleta calibrate&#xa0;; sans lui, la caméra ne fait que regarder</translation>
    </message>
    <message>
        <source>none: only show the picture</source>
        <translation>aucun&#xa0;: regarder seulement</translation>
    </message>
</context>
<context>
    <name>teleta::console::CameraSourceField</name>
    <message>
        <source>The number of a connected camera (0 is /dev/video0), or a video file</source>
        <translation>Le numéro d’une caméra connectée (0 est /dev/video0), ou un fichier vidéo</translation>
    </message>
    <message>
        <source>…</source>
        <translation>…</translation>
    </message>
    <message>
        <source>Choose a video</source>
        <translation>Choisir une vidéo</translation>
    </message>
    <message>
        <source>Video of a camera</source>
        <translation>Vidéo d’une caméra</translation>
    </message>
    <message>
        <source>Videos and pictures (*)</source>
        <translation>Vidéos et images (*)</translation>
    </message>
    <message>
        <source>Camera or video</source>
        <translation>Caméra ou vidéo</translation>
    </message>
</context>
<context>
    <name>teleta::console::CostMeasuring</name>
    <message>
        <source>The saved costs cannot be read.</source>
        <translation>Les coûts mesurés auparavant ne peuvent pas être lus.</translation>
    </message>
    <message>
        <source>The costs cannot be saved.</source>
        <translation>Les coûts mesurés ne peuvent pas être conservés.</translation>
    </message>
    <message>
        <source>The jobs could not be measured.</source>
        <translation>Les tâches n’ont pas pu être mesurées.</translation>
    </message>
</context>
<context>
    <name>teleta::console::CostPage</name>
    <message>
        <source>Error: %1.</source>
        <translation>Erreur&#xa0;: %1.</translation>
    </message>
    <message>
        <source>refused: too noisy</source>
        <translation>refusé&#xa0;: trop de perturbations</translation>
    </message>
    <message>
        <source>Preparing…</source>
        <translation>Préparation…</translation>
    </message>
    <message>
        <source>%1: %2 on average, 99 of 100 frames within %3 (1640 x 1232 pixels).</source>
        <translation>%1&#xa0;: %2 en moyenne, 99 images sur 100 en moins de %3 (1640 x 1232 pixels).</translation>
    </message>
    <message>
        <source>Measuring %1: %2</source>
        <translation>Mesure de %1&#xa0;: %2</translation>
    </message>
    <message>
        <source>Preparing %1…</source>
        <translation>Préparation de %1…</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>&amp;Annuler</translation>
    </message>
    <message>
        <source>Not measured on this machine</source>
        <translation>Non mesurée sur cette machine</translation>
    </message>
    <message>
        <source>Parameter</source>
        <translation>Paramètre</translation>
    </message>
    <message>
        <source>Mean error</source>
        <translation>Erreur moyenne</translation>
    </message>
    <message>
        <source>95 %</source>
        <translation>95&#xa0;%</translation>
    </message>
    <message>
        <source>Worst</source>
        <translation>Pire</translation>
    </message>
    <message>
        <source>Median time</source>
        <translation>Temps médian</translation>
    </message>
    <message>
        <source>99 % time</source>
        <translation>Temps 99&#xa0;%</translation>
    </message>
    <message>
        <source>Camera in use</source>
        <translation>Caméra utilisée</translation>
    </message>
    <message>
        <source>Time of a frame, now</source>
        <translation>Temps d’une image, maintenant</translation>
    </message>
    <message>
        <source>Time &amp;budget of a frame</source>
        <translation>&amp;Budget de temps d’une image</translation>
    </message>
    <message>
        <source> ms a frame</source>
        <translation> ms par image</translation>
    </message>
    <message>
        <source>No camera is shown on the page Operate.</source>
        <translation>Aucune caméra n’est affichée sur la page Conduite.</translation>
    </message>
    <message>
        <source>Open a demo with a camera</source>
        <translation>Ouvrir une démo avec une caméra</translation>
    </message>
    <message>
        <source>Measuring</source>
        <translation>Mesure en cours</translation>
    </message>
    <message>
        <source>Close other programs and sources first: their load makes the times unreliable.</source>
        <translation>Fermez d’abord les autres programmes et sources&#xa0;: leurs calculs rendent les temps incertains.</translation>
    </message>
    <message>
        <source>Stopping…</source>
        <translation>Arrêt en cours…</translation>
    </message>
    <message>
        <source>Takes a few minutes; you can go on using the console</source>
        <translation>Dure quelques minutes&#xa0;; la console reste utilisable entre-temps</translation>
    </message>
    <message>
        <source>Sweeps</source>
        <translation>Balayages</translation>
    </message>
    <message>
        <source>Fastest: %1, %2 times the limit (%3: %4).</source>
        <translation>Le plus rapide&#xa0;: %1, %2 fois la limite (%3&#xa0;: %4).</translation>
    </message>
    <message>
        <source>%1 (frontier)</source>
        <comment>name of a setting</comment>
        <translation>%1 (front de Pareto)</translation>
    </message>
    <message>
        <source>Measure &quot;%1&quot; first.</source>
        <translation>Mesurez d’abord «&#xa0;%1&#xa0;».</translation>
    </message>
    <message>
        <source>No setting is fast enough: only one frame in 100 may take longer.</source>
        <translation>Aucun réglage n’est assez rapide&#xa0;: une image sur 100 seulement peut prendre plus de temps.</translation>
    </message>
    <message>
        <source>The setting %1 cannot be used.</source>
        <translation>Le réglage %1 ne peut pas être utilisé.</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Réglages</translation>
    </message>
    <message>
        <source>Jobs</source>
        <translation>Tâches</translation>
    </message>
    <message>
        <source>Jobs that can be done fast or accurately</source>
        <translation>Tâches qui peuvent se faire vite ou exactement</translation>
    </message>
    <message>
        <source>Measure &amp;all jobs</source>
        <translation>Mesurer &amp;toutes les tâches</translation>
    </message>
    <message>
        <source>Measure this job</source>
        <translation>Mesurer cette tâche</translation>
    </message>
    <message>
        <source>Setting</source>
        <translation>Réglage</translation>
    </message>
    <message>
        <source>Settings with their errors and times</source>
        <translation>Réglages avec leurs erreurs et leurs temps</translation>
    </message>
    <message>
        <source>&amp;Setting in use</source>
        <translation>&amp;Réglage utilisé</translation>
    </message>
    <message>
        <source>Setting that finds the contacts</source>
        <translation>Réglage qui trouve les contacts</translation>
    </message>
    <message>
        <source>&amp;Use the best setting within it</source>
        <translation>&amp;Utiliser le meilleur réglage dans ce budget</translation>
    </message>
    <message>
        <source>Choose a setting in the table or the chart to read what it costs and gives.</source>
        <translation>Choisissez un réglage dans le tableau ou le graphique pour lire ce qu’il coûte et apporte.</translation>
    </message>
    <message>
        <source>On the command line: %1</source>
        <translation>En ligne de commande&#xa0;: %1</translation>
    </message>
    <message>
        <source>not measured</source>
        <translation>non mesuré</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <comment>times</comment>
        <translation>%1 à %2</translation>
    </message>
    <message>
        <source>&amp;Measure again</source>
        <translation>&amp;Mesurer à nouveau</translation>
    </message>
</context>
<context>
    <name>teleta::console::DeletionDialog</name>
    <message>
        <source>Delete a participant</source>
        <translation>Supprimer un participant</translation>
    </message>
    <message>
        <source>For example: consent withdrawn</source>
        <translation>Par exemple&#xa0;: consentement retiré</translation>
    </message>
    <message>
        <source>It is recorded. Write nothing that tells who it was</source>
        <translation>La raison est gardée&#xa0;; n’écrivez rien qui dise qui c’était</translation>
    </message>
    <message>
        <source>&amp;Reason</source>
        <translation>&amp;Raison</translation>
    </message>
    <message>
        <source>&amp;Name of the participant, once more</source>
        <translation>&amp;Nom du participant, encore une fois</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Supprimer</translation>
    </message>
    <message>
        <source>All sessions, answers, notes, recordings and exported files of %1 are deleted. This cannot be undone. The study records that somebody was deleted, and when. Results that were computed before, and copies elsewhere, stay as they are.</source>
        <comment>a participant</comment>
        <translation>Toutes les sessions, réponses, notes, enregistrements et fichiers exportés de&#xa0;%1 sont supprimés. C’est irréversible. L’étude garde la trace que quelqu’un a été supprimé, et quand. Les résultats calculés auparavant, et les copies ailleurs, restent tels quels.</translation>
    </message>
</context>
<context>
    <name>teleta::console::DockTabs</name>
    <message>
        <source>&amp;Maximise</source>
        <translation>&amp;Agrandir</translation>
    </message>
    <message>
        <source>&amp;Float</source>
        <translation>&amp;Détacher</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>&amp;Fermer</translation>
    </message>
</context>
<context>
    <name>teleta::console::ExclusionEditor</name>
    <message>
        <source>What does not count</source>
        <translation>Ce qui ne compte pas</translation>
    </message>
    <message>
        <source>No rules: every completed trial counts.</source>
        <translation>Pas de règles&#xa0;: chaque essai terminé compte.</translation>
    </message>
    <message>
        <source>Add a r&amp;ule</source>
        <translation>Ajouter une &amp;règle</translation>
    </message>
    <message>
        <source>Rules apply from top to bottom, each to what is left. Nothing is deleted: results are shown with the rules, and without them</source>
        <translation>Les règles s’appliquent de haut en bas, chacune à ce qui reste. Rien n’est supprimé&#xa0;: les résultats sont montrés avec les règles, et sans elles</translation>
    </message>
    <message>
        <source>a trial answered earlier than, s</source>
        <translation>un essai avec une réponse plus tôt que, s</translation>
    </message>
    <message>
        <source>a trial answered later than, s</source>
        <translation>un essai avec une réponse plus tard que, s</translation>
    </message>
    <message>
        <source>a trial whose time is unusual, MADs from the median</source>
        <translation>un essai au temps inhabituel, en MAD depuis la médiane</translation>
    </message>
    <message>
        <source>a trial with more device faults than</source>
        <translation>un essai avec plus de défauts d’appareil que</translation>
    </message>
    <message>
        <source>a trial with more missed frames than</source>
        <translation>un essai avec plus de trames manquées que</translation>
    </message>
    <message>
        <source>a session with a share without answer above</source>
        <translation>une session avec une part sans réponse supérieure à</translation>
    </message>
    <message>
        <source>a session with a share of yes in catch trials above</source>
        <translation>une session avec une part de oui aux essais pièges supérieure à</translation>
    </message>
    <message>
        <source>a session with a share of one answer above</source>
        <translation>une session avec une part d’une même réponse supérieure à</translation>
    </message>
    <message>
        <source>a participant with a share right in practice below</source>
        <translation>un participant avec une part de réponses correctes à l’entraînement inférieure à</translation>
    </message>
    <message>
        <source>a participant not above chance, p above</source>
        <translation>un participant qui ne dépasse pas le hasard, p supérieur à</translation>
    </message>
    <message>
        <source>Name of the rule</source>
        <translation>Nom de la règle</translation>
    </message>
    <message>
        <source>The name of the rule in the column “excluded” and in results</source>
        <translation>Le nom de la règle dans la colonne «&#xa0;excluded&#xa0;» et dans les résultats</translation>
    </message>
    <message>
        <source>What the rule leaves out</source>
        <translation>Ce que la règle écarte</translation>
    </message>
    <message>
        <source>Number of the rule</source>
        <translation>Nombre de la règle</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Supprimer</translation>
    </message>
    <message>
        <source>Remove this rule</source>
        <translation>Supprimer cette règle</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; is not a number</source>
        <comment>a rule</comment>
        <translation>%1&#xa0;: «&#xa0;%2&#xa0;» n’est pas un nombre</translation>
    </message>
    <message>
        <source>a number with a point, such as 0.2</source>
        <translation>un nombre avec un point, tel que 0.2</translation>
    </message>
</context>
<context>
    <name>teleta::console::ExportDialog</name>
    <message>
        <source>Export pattern</source>
        <translation>Exporter le motif</translation>
    </message>
    <message>
        <source>commanded intensities</source>
        <translation>intensités commandées</translation>
    </message>
    <message>
        <source>&amp;Format:</source>
        <translation>&amp;Format&#xa0;:</translation>
    </message>
    <message>
        <source>&amp;Rate:</source>
        <translation>F&amp;réquence&#xa0;:</translation>
    </message>
    <message>
        <source>&amp;Values:</source>
        <translation>&amp;Valeurs&#xa0;:</translation>
    </message>
    <message>
        <source>Choose file…</source>
        <translation>Choisir un fichier…</translation>
    </message>
    <message>
        <source>predicted intensities</source>
        <translation>ce que feront les moteurs selon la prédiction</translation>
    </message>
    <message>
        <source>vibrations</source>
        <translation>vibrations</translation>
    </message>
    <message>
        <source>bare intensities</source>
        <translation>intensités brutes</translation>
    </message>
    <message>
        <source>&amp;Signal:</source>
        <translation>&amp;Signal&#xa0;:</translation>
    </message>
    <message>
        <source>Frequenc&amp;y:</source>
        <translation>F&amp;réquence&#xa0;:</translation>
    </message>
</context>
<context>
    <name>teleta::console::FeedbackPanel</name>
    <message>
        <source>shape</source>
        <translation>forme</translation>
    </message>
    <message>
        <source>stiffness</source>
        <translation>raideur</translation>
    </message>
    <message>
        <source>dynamic</source>
        <translation>dynamique</translation>
    </message>
    <message>
        <source>static</source>
        <translation>statique</translation>
    </message>
    <message>
        <source>%1: no pattern</source>
        <comment>what was recognised</comment>
        <translation>%1&#xa0;: pas de motif</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>what was recognised: id of a pattern</comment>
        <translation>%1&#xa0;: %2</translation>
    </message>
    <message>
        <source>Touch %1: %2. There is no pattern for it in the table.</source>
        <translation>Toucher %1&#xa0;: %2. Il n’y a pas de motif pour cela dans le tableau.</translation>
    </message>
    <message>
        <source>Touch %1: %2. %3 was felt %4 later.</source>
        <translation>Toucher %1&#xa0;: %2. %3 a été senti %4 plus tard.</translation>
    </message>
    <message>
        <source>Touch %1: %2. %3 was sent.</source>
        <translation>Toucher %1&#xa0;: %2. %3 a été envoyé.</translation>
    </message>
    <message>
        <source>Stiffness and shape</source>
        <translation>Raideur et forme</translation>
    </message>
    <message>
        <source>Stiffness</source>
        <translation>Raideur</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>Forme</translation>
    </message>
    <message>
        <source>Nothing</source>
        <translation>Rien</translation>
    </message>
    <message>
        <source>What of a touch is played on the bracelet</source>
        <translation>Ce qui, d’un toucher, est joué sur le bracelet</translation>
    </message>
    <message>
        <source>Nothing was recognised yet.</source>
        <translation>Rien n’a encore été reconnu.</translation>
    </message>
    <message>
        <source>%1: %2 is missing</source>
        <comment>what was recognised: id of a pattern</comment>
        <translation>%1&#xa0;: %2 manque</translation>
    </message>
    <message>
        <source>Touch %1: %2. Its pattern %3 is missing: nothing was played. Choose another one, or put it back among your patterns.</source>
        <translation>Toucher %1&#xa0;: %2. Son motif %3 manque&#xa0;: rien n’a été joué. Choisissez-en un autre, ou remettez-le parmi vos motifs.</translation>
    </message>
    <message>
        <source>From touch to skin: %1 half of the time, %2 at 99 %.</source>
        <translation>Du toucher à la peau&#xa0;: %1 la moitié du temps, %2 à 99&#xa0;%.</translation>
    </message>
    <message>
        <source>Of the newest touches, with the link between the two sites on the way</source>
        <translation>Pour les touchers les plus récents, liaison entre les deux sites comprise</translation>
    </message>
    <message>
        <source>Nothing is played (last: %1)</source>
        <comment>what was recognised and its pattern</comment>
        <translation>Rien n’est joué (dernier&#xa0;: %1)</translation>
    </message>
    <message>
        <source>Unknown stiffness</source>
        <translation>Raideur inconnue</translation>
    </message>
    <message>
        <source>%1: %2, not played</source>
        <comment>what was recognised: id of a pattern</comment>
        <translation>%1&#xa0;:&#xa0;%2, non joué</translation>
    </message>
    <message>
        <source>Touch %1: %2. %3 was not played: no bracelet is connected, or a study or a calibration is using it.</source>
        <translation>Toucher&#xa0;%1&#xa0;:&#xa0;%2.&#xa0;%3 n’a pas été joué&#xa0;: il n’y a pas de bracelet, ou une étude ou un étalonnage s’en sert.</translation>
    </message>
    <message>
        <source>What to &amp;play:</source>
        <translation>&amp;Jouer d’un contact&#xa0;:</translation>
    </message>
    <message>
        <source>Save the times of touches</source>
        <translation>Enregistrer les temps des touchers</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>Tableaux (*.csv)</translation>
    </message>
    <message>
        <source>Read: %1</source>
        <translation>Lu&#xa0;: %1</translation>
    </message>
    <message>
        <source>by the clock of the site, known to ± %1</source>
        <translation>à l’horloge du site, connue à ± %1 près</translation>
    </message>
    <message>
        <source>by the clock of this computer</source>
        <translation>à l’horloge de cet ordinateur</translation>
    </message>
    <message>
        <source>Evaluated: %1 later</source>
        <translation>Évalué&#xa0;: %1 plus tard</translation>
    </message>
    <message>
        <source>First frame to the bracelet: %1 later</source>
        <translation>Première trame vers le bracelet&#xa0;: %1 plus tard</translation>
    </message>
    <message>
        <source>First frame that is felt: %1 later</source>
        <translation>Première trame sentie&#xa0;: %1 plus tard</translation>
    </message>
    <message>
        <source>Each is known to ± %1, since two clocks are compared.</source>
        <translation>Chacun est connu à ± %1 près, car deux horloges sont comparées.</translation>
    </message>
    <message>
        <source>Save times…</source>
        <translation>Enregistrer les temps…</translation>
    </message>
    <message>
        <source>Arrived at the console: %1 later</source>
        <translation>Arrivé à la console&#xa0;: %1 plus tard</translation>
    </message>
    <message>
        <source>Save when each touch was read, arrived from a site, was evaluated, sent and felt, as a table (CSV)</source>
        <translation>Enregistrer en tableau (CSV) quand chaque contact a été lu, est arrivé d’un site, a été évalué, envoyé et ressenti</translation>
    </message>
</context>
<context>
    <name>teleta::console::FrameDialog</name>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source> Hz</source>
        <translation> Hz</translation>
    </message>
    <message>
        <source>Open frames</source>
        <translation>Ouvrir des trames</translation>
    </message>
    <message>
        <source>the only one, or the one named frames</source>
        <translation>le seul, ou celui qui s’appelle frames</translation>
    </message>
    <message>
        <source>as the file says</source>
        <translation>comme dans le fichier</translation>
    </message>
    <message>
        <source>the first</source>
        <translation>la première</translation>
    </message>
    <message>
        <source>the last</source>
        <translation>la dernière</translation>
    </message>
    <message>
        <source>Rows</source>
        <translation>Lignes</translation>
    </message>
    <message>
        <source>Columns</source>
        <translation>Colonnes</translation>
    </message>
    <message>
        <source>Columns of a table that are taxels, counted from 1</source>
        <translation>Colonnes d’un tableau qui sont des taxels, comptées à partir de 1</translation>
    </message>
    <message>
        <source>name or number of the column</source>
        <translation>nom ou numéro de la colonne</translation>
    </message>
    <message>
        <source>as the name of the column ends</source>
        <translation>selon la fin du nom de la colonne</translation>
    </message>
    <message>
        <source>rows ×</source>
        <comment>N rows x M columns</comment>
        <translation>lignes ×</translation>
    </message>
    <message>
        <source>columns</source>
        <translation>colonnes</translation>
    </message>
    <message>
        <source>File:</source>
        <translation>Fichier :</translation>
    </message>
    <message>
        <source>&amp;Name of the frames:</source>
        <translation>&amp;Nom des trames :</translation>
    </message>
    <message>
        <source>&amp;Dimension that counts the frames:</source>
        <translation>&amp;Dimension qui compte les trames :</translation>
    </message>
    <message>
        <source>&amp;Shape:</source>
        <translation>&amp;Forme :</translation>
    </message>
    <message>
        <source>&amp;Pitch:</source>
        <translation>&amp;Pas :</translation>
    </message>
    <message>
        <source>&amp;Columns of the taxels:</source>
        <translation>&amp;Colonnes des taxels :</translation>
    </message>
    <message>
        <source>Column of the &amp;times:</source>
        <translation>Colonne des &amp;temps :</translation>
    </message>
    <message>
        <source>&amp;Unit of the times:</source>
        <translation>&amp;Unité des temps :</translation>
    </message>
    <message>
        <source>&amp;Rate, without times:</source>
        <translation>Cadence, &amp;sans temps :</translation>
    </message>
    <message>
        <source>Columns are numbers and ranges, such as 2..85 or 2..10,12.</source>
        <translation>Les colonnes sont des nombres et des plages, comme 2..85 ou 2..10,12.</translation>
    </message>
</context>
<context>
    <name>teleta::console::FramePreview</name>
    <message>
        <source>Frame</source>
        <translation>Trame</translation>
    </message>
    <message>
        <source>Choose a frame</source>
        <translation>Choisir une trame</translation>
    </message>
    <message>
        <source>Reading…</source>
        <translation>Lecture…</translation>
    </message>
    <message>
        <source>No frame to show.</source>
        <translation>Aucune trame à montrer.</translation>
    </message>
    <message numerus="yes">
        <source>%n frame(s) of %1 × %2 taxels, %3 to %4</source>
        <extracomment>Numbers of rows and columns, lowest and highest value</extracomment>
        <translation>
            <numerusform>%n trame de %1 × %2 taxels, de %3 à %4</numerusform>
            <numerusform>%n trames de %1 × %2 taxels, de %3 à %4</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>The first %n frame(s) of %1 × %2 taxels, %3 to %4</source>
        <translation>
            <numerusform>La première trame de %1 × %2 taxels, de %3 à %4</numerusform>
            <numerusform>Les %n premières trames de %1 × %2 taxels, de %3 à %4</numerusform>
        </translation>
    </message>
    <message>
        <source>Frame %1 of %2, %3 s</source>
        <translation>Trame %1 sur %2, %3 s</translation>
    </message>
</context>
<context>
    <name>teleta::console::GainCalibrator</name>
    <message>
        <source>Open recorded presses</source>
        <translation>Ouvrir des appuis enregistrés</translation>
    </message>
    <message>
        <source>Frames (*.csv)</source>
        <translation>Trames (*.csv)</translation>
    </message>
    <message>
        <source>Load gains</source>
        <translation>Charger des gains</translation>
    </message>
    <message>
        <source>Gains (*.csv)</source>
        <translation>Gains (*.csv)</translation>
    </message>
    <message>
        <source>Save the gains</source>
        <translation>Enregistrer les gains</translation>
    </message>
    <message>
        <source>Choose another folder or file name.</source>
        <translation>Choisissez un autre dossier ou nom de fichier.</translation>
    </message>
    <message>
        <source>%1 could not be saved.</source>
        <comment>a file</comment>
        <translation>%1 n’a pas pu être enregistré.</translation>
    </message>
</context>
<context>
    <name>teleta::console::HandbookWindow</name>
    <message>
        <source>Handbook of the TeleTA Console</source>
        <translation>Manuel de TeleTA Console</translation>
    </message>
    <message>
        <source>← Back</source>
        <translation>← Précédent</translation>
    </message>
    <message>
        <source>Forward →</source>
        <translation>Suivant →</translation>
    </message>
    <message>
        <source>Find</source>
        <translation>Rechercher</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>Find in the handbook (Ctrl+F)</source>
        <translation>Rechercher dans le manuel (Ctrl+F)</translation>
    </message>
    <message>
        <source>Find in the handbook</source>
        <translation>Rechercher dans le manuel</translation>
    </message>
    <message>
        <source>Pages of the handbook</source>
        <translation>Pages du manuel</translation>
    </message>
    <message>
        <source>Page of the handbook</source>
        <translation>Page du manuel</translation>
    </message>
</context>
<context>
    <name>teleta::console::HelpMenu</name>
    <message>
        <source>&amp;Handbook</source>
        <translation>&amp;Manuel</translation>
    </message>
    <message>
        <source>&amp;First steps</source>
        <translation>Pr&amp;emiers pas</translation>
    </message>
    <message>
        <source>&amp;Shortcuts</source>
        <translation>&amp;Raccourcis clavier</translation>
    </message>
    <message>
        <source>&amp;About TeleTA Console</source>
        <translation>À &amp;propos de TeleTA Console</translation>
    </message>
    <message>
        <source>&amp;Log</source>
        <translation>&amp;Journal</translation>
    </message>
</context>
<context>
    <name>teleta::console::ImportDialog</name>
    <message>
        <source>Open pattern</source>
        <translation>Ouvrir un motif</translation>
    </message>
    <message>
        <source>A pattern cannot represent everything that %1 holds. Opening it changes or leaves out:</source>
        <comment>a file</comment>
        <translation>Un motif ne peut pas représenter tout ce que contient&#xa0;%1. L’ouverture modifie ou laisse de côté&#xa0;:</translation>
    </message>
    <message>
        <source>left</source>
        <translation>gauche</translation>
    </message>
    <message>
        <source>right</source>
        <translation>droit</translation>
    </message>
    <message>
        <source>&amp;Arm:</source>
        <translation>&amp;Bras&#xa0;:</translation>
    </message>
    <message>
        <source>&amp;Motors:</source>
        <translation>&amp;Moteurs&#xa0;:</translation>
    </message>
</context>
<context>
    <name>teleta::console::JointViews</name>
    <message>
        <source>The arm is drawn without its meshes: %1</source>
        <translation>Le bras est dessiné sans ses maillages&#xa0;: %1</translation>
    </message>
</context>
<context>
    <name>teleta::console::LayoutsMenu</name>
    <message>
        <source>Ma&amp;ximise the view</source>
        <translation>Agra&amp;ndir la vue</translation>
    </message>
    <message>
        <source>Show the view with the focus alone, or all again; a double click on a title does the same</source>
        <translation>Afficher seule la vue qui a le focus, ou de nouveau toutes&#xa0;; un double clic sur un titre fait de même</translation>
    </message>
    <message>
        <source>La&amp;youts</source>
        <translation>&amp;Dispositions</translation>
    </message>
    <message>
        <source>&amp;Save layout as…</source>
        <translation>&amp;Enregistrer la disposition…</translation>
    </message>
    <message>
        <source>D&amp;elete</source>
        <translation>&amp;Supprimer</translation>
    </message>
    <message>
        <source>Save layout</source>
        <translation>Enregistrer la disposition</translation>
    </message>
    <message>
        <source>Name (a layout of the same name is replaced):</source>
        <translation>Nom&#xa0;; une disposition qui existe déjà est remplacée&#xa0;:</translation>
    </message>
</context>
<context>
    <name>teleta::console::LevelTaskForm</name>
    <message>
        <source>Task with levels</source>
        <translation>Tâche à niveaux</translation>
    </message>
    <message>
        <source>yes or no: was it there?</source>
        <translation>oui ou non&#xa0;: était-il là&#xa0;?</translation>
    </message>
    <message>
        <source>intervals: in which one was it?</source>
        <translation>intervalles&#xa0;: dans lequel était-il&#xa0;?</translation>
    </message>
    <message>
        <source>same or different</source>
        <translation>identiques ou différents</translation>
    </message>
    <message>
        <source>compare: which one had more?</source>
        <translation>comparer&#xa0;: lequel en avait le plus&#xa0;?</translation>
    </message>
    <message>
        <source>the usual question of the design</source>
        <translation>la question habituelle du plan d’expérience</translation>
    </message>
    <message>
        <source>for example rest, or weak 0.3, strong 0.7 with their references</source>
        <translation>par exemple rest, ou weak 0.3, strong 0.7 avec leurs références</translation>
    </message>
    <message>
        <source>name and tactors, one track per line, for example t1 1; tactors of the reference after /</source>
        <translation>nom et tacteurs, une série par ligne, par exemple t1 1&#xa0;; tacteurs de la référence après /</translation>
    </message>
    <message>
        <source>full path of a pattern file</source>
        <translation>chemin complet d’un fichier de motif</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Choisir…</translation>
    </message>
    <message>
        <source>intensity</source>
        <translation>l’intensité</translation>
    </message>
    <message>
        <source>time from burst to burst</source>
        <translation>le temps d’une salve à la suivante</translation>
    </message>
    <message>
        <source>length of a burst</source>
        <translation>la durée d’une salve</translation>
    </message>
    <message>
        <source>length</source>
        <translation>la durée</translation>
    </message>
    <message>
        <source>balance of a phantom</source>
        <translation>l’équilibre d’un fantôme</translation>
    </message>
    <message>
        <source>linear</source>
        <translation>linéaire</translation>
    </message>
    <message>
        <source>logarithmic (log10)</source>
        <translation>logarithmique (log10)</translation>
    </message>
    <message>
        <source>the highest</source>
        <translation>le plus haut</translation>
    </message>
    <message>
        <source>constant stimuli</source>
        <translation>stimuli constants</translation>
    </message>
    <message>
        <source>staircase</source>
        <translation>escalier</translation>
    </message>
    <message>
        <source>Bayesian (QUEST+)</source>
        <translation>bayésien (QUEST+)</translation>
    </message>
    <message>
        <source>levels with commas between them, for example 0.1, 0.2, 0.4</source>
        <translation>niveaux séparés par des virgules, par exemple 0.1, 0.2, 0.4</translation>
    </message>
    <message>
        <source>Identifier</source>
        <translation>Identifiant</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nom</translation>
    </message>
    <message>
        <source>Design</source>
        <translation>Plan d’expérience</translation>
    </message>
    <message>
        <source>Question</source>
        <translation>Question</translation>
    </message>
    <message>
        <source>Conditions</source>
        <translation>Conditions</translation>
    </message>
    <message>
        <source>Intervals</source>
        <translation>Intervalles</translation>
    </message>
    <message>
        <source>Gap between intervals, s</source>
        <translation>Pause entre les intervalles, s</translation>
    </message>
    <message>
        <source>Share of catch trials</source>
        <translation>Part d’essais pièges</translation>
    </message>
    <message>
        <source>Tracks</source>
        <translation>Séries</translation>
    </message>
    <message>
        <source>Stimulus</source>
        <translation>Stimulus</translation>
    </message>
    <message>
        <source>A level sets the</source>
        <translation>Un niveau règle</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Échelle</translation>
    </message>
    <message>
        <source>Lowest level</source>
        <translation>Niveau le plus bas</translation>
    </message>
    <message>
        <source>Highest level</source>
        <translation>Niveau le plus haut</translation>
    </message>
    <message>
        <source>Reference; 0 is nothing</source>
        <translation>Référence&#xa0;; 0&#xa0;: rien</translation>
    </message>
    <message>
        <source>Level of the practice</source>
        <translation>Niveau de l’entraînement</translation>
    </message>
    <message>
        <source>Levels are chosen by</source>
        <translation>Choix des niveaux</translation>
    </message>
    <message>
        <source>Levels</source>
        <translation>Niveaux</translation>
    </message>
    <message>
        <source>Remove this task</source>
        <translation>Supprimer cette tâche</translation>
    </message>
    <message>
        <source>First level</source>
        <translation>Premier niveau</translation>
    </message>
    <message>
        <source>Right answers for a step down</source>
        <translation>Réponses correctes pour un pas vers le bas</translation>
    </message>
    <message>
        <source>Reversals with larger steps</source>
        <translation>Inversions à pas plus grands</translation>
    </message>
    <message>
        <source>Reversals at most</source>
        <translation>Inversions au plus</translation>
    </message>
    <message>
        <source>Trials at most</source>
        <translation>Essais au plus</translation>
    </message>
    <message>
        <source>Function</source>
        <translation>Fonction</translation>
    </message>
    <message>
        <source>Slopes or spreads</source>
        <translation>Pentes ou dispersions</translation>
    </message>
    <message>
        <source>Lapse rates</source>
        <translation>Taux d’inattention</translation>
    </message>
    <message>
        <source>Rates of yes without a stimulus</source>
        <translation>Taux de oui sans stimulus</translation>
    </message>
    <message>
        <source>Levels of the grid</source>
        <translation>Niveaux de la grille</translation>
    </message>
    <message>
        <source>Mean of the prior, in the scale</source>
        <translation>Moyenne de l’a priori, dans l’échelle</translation>
    </message>
    <message>
        <source>all thresholds are equally likely</source>
        <translation>tous les seuils sont également probables</translation>
    </message>
    <message>
        <source>Its standard deviation</source>
        <translation>Son écart-type</translation>
    </message>
    <message>
        <source>Trials at least</source>
        <translation>Essais au moins</translation>
    </message>
    <message>
        <source>Ends with a standard deviation of</source>
        <translation>Se termine à un écart-type de</translation>
    </message>
    <message>
        <source>only with its trials</source>
        <translation>seulement avec ses essais</translation>
    </message>
    <message>
        <source>Pattern file of the stimulus</source>
        <translation>Fichier de motif du stimulus</translation>
    </message>
    <message>
        <source>Detection</source>
        <translation>Détection</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; is not a number</source>
        <comment>a row of the form</comment>
        <translation>%1&#xa0;: «&#xa0;%2&#xa0;» n’est pas un nombre</translation>
    </message>
    <message>
        <source>a number with a point, such as 0.5</source>
        <translation>un nombre avec un point, tel que 0.5</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a number</source>
        <translation>«&#xa0;%1&#xa0;» n’est pas un nombre</translation>
    </message>
    <message>
        <source>numbers with a point, such as 0.1, 0.2</source>
        <translation>des nombres avec un point, tels que 0.1, 0.2</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a whole number</source>
        <translation>«&#xa0;%1&#xa0;» n’est pas un nombre entier</translation>
    </message>
    <message>
        <source>a number such as 12</source>
        <translation>un nombre tel que 12</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no tactor</source>
        <translation>«&#xa0;%1&#xa0;» n’est pas un tacteur</translation>
    </message>
    <message>
        <source>a name and numbers of tactors, for example t1 1</source>
        <translation>un nom et des numéros de tacteurs, par exemple t1 1</translation>
    </message>
    <message>
        <source>a condition and its reference, such as weak 0.3</source>
        <translation>une condition et sa référence, telles que weak 0.3</translation>
    </message>
    <message>
        <source>Step up, log10 units on a log scale</source>
        <translation>Pas vers le haut, en unités log10 sur une échelle logarithmique</translation>
    </message>
    <message>
        <source>Step down, likewise</source>
        <translation>Pas vers le bas, de même</translation>
    </message>
    <message>
        <source>These steps are larger by</source>
        <translation>Facteur d’agrandissement de ces pas</translation>
    </message>
    <message>
        <source>First reversals left out</source>
        <translation>Premières inversions écartées</translation>
    </message>
    <message>
        <source>It stays at</source>
        <translation>Reste à</translation>
    </message>
    <message>
        <source>Levels are shares of the intensity in the file, 0 to 1.</source>
        <translation>Les niveaux sont des parts de l’intensité du fichier, de 0 à 1.</translation>
    </message>
    <message>
        <source>Levels are balances, from 0 (the first tactor alone) to 1 (the second alone).</source>
        <translation>Les niveaux sont des équilibres, de 0 (le premier tacteur seul) à 1 (le second seul).</translation>
    </message>
    <message>
        <source>Levels are times in seconds.</source>
        <translation>Les niveaux sont des temps en secondes.</translation>
    </message>
    <message>
        <source>%1 % right answers</source>
        <translation>%1&#xa0;% de réponses correctes</translation>
    </message>
</context>
<context>
    <name>teleta::console::LiveProbing</name>
    <message>
        <source>The camera is open but sends no frames.</source>
        <translation>La caméra est ouverte, mais aucune image n’arrive.</translation>
    </message>
    <message>
        <source>The camera&apos;s image size has changed from %1 × %2 to %3 × %4 pixels. Start probing again.</source>
        <translation>L’image de la caméra est passée de %1 × %2 à %3 × %4 pixels. Recommencez le palpage.</translation>
    </message>
</context>
<context>
    <name>teleta::console::LiveProbingDialog</name>
    <message>
        <source>Probe with a camera</source>
        <translation>Palper avec une caméra</translation>
    </message>
    <message>
        <source>&amp;Camera or video:</source>
        <translation>&amp;Caméra ou vidéo&#xa0;:</translation>
    </message>
    <message>
        <source>Ri&amp;ngs:</source>
        <translation>A&amp;nneaux&#xa0;:</translation>
    </message>
    <message>
        <source>&amp;First ring at z =</source>
        <translation>&amp;Premier anneau à z =</translation>
    </message>
    <message>
        <source>&amp;Last ring at z =</source>
        <translation>&amp;Dernier anneau à z =</translation>
    </message>
    <message>
        <source>An&amp;gle of the first hole:</source>
        <translation>An&amp;gle du premier trou&#xa0;:</translation>
    </message>
    <message>
        <source>&amp;Probe</source>
        <translation>Pa&amp;lper</translation>
    </message>
    <message>
        <source>Angle of the first hole of each ring, from the x axis towards y</source>
        <translation>Du premier trou de chaque anneau, de l’axe x vers y</translation>
    </message>
    <message>
        <source>Holes per &amp;ring:</source>
        <translation>T&amp;rous par anneau&#xa0;:</translation>
    </message>
</context>
<context>
    <name>teleta::console::LiveProbingPanel</name>
    <message>
        <source>The video is over.</source>
        <translation>La vidéo est terminée.</translation>
    </message>
    <message>
        <source>All holes are probed.</source>
        <translation>Tous les trous sont palpés.</translation>
    </message>
    <message>
        <source>All holes are probed</source>
        <translation>Tous les trous sont palpés</translation>
    </message>
    <message>
        <source>Hole %1 of %2: ring %3, %4&#xa0;mm, %5°</source>
        <translation>Trou %1 sur %2&#xa0;: anneau %3, %4&#xa0;mm, %5°</translation>
    </message>
    <message>
        <source>Press the stick into this hole.</source>
        <translation>Appuyez le bâton dans ce trou.</translation>
    </message>
    <message>
        <source>Hold still.</source>
        <translation>Ne bougez plus.</translation>
    </message>
    <message>
        <source>Taken. Lift the stick.</source>
        <translation>Enregistré. Levez le bâton.</translation>
    </message>
    <message>
        <source>How long the stick has been held still</source>
        <translation>Depuis combien de temps le bâton est immobile</translation>
    </message>
    <message>
        <source>What the camera sees</source>
        <translation>Ce que voit la caméra</translation>
    </message>
    <message>
        <source>&amp;Back</source>
        <translation>&amp;Retour</translation>
    </message>
    <message>
        <source>S&amp;kip</source>
        <translation>&amp;Passer</translation>
    </message>
    <message>
        <source>Sto&amp;p probing</source>
        <translation>Arrê&amp;ter le palpage</translation>
    </message>
    <message>
        <source>Lift the stick first.</source>
        <translation>Levez d’abord le bâton.</translation>
    </message>
    <message>
        <source>Waiting for the camera: %1</source>
        <translation>La caméra est attendue&#xa0;: %1</translation>
    </message>
    <message>
        <source>Waiting for the first frame. Nothing may touch the skin.</source>
        <translation>La première image est attendue. Rien ne doit toucher la peau.</translation>
    </message>
    <message>
        <source>Waiting for a frame in which nothing touches the skin: %1</source>
        <translation>Une image où rien ne touche la peau est attendue&#xa0;: %1</translation>
    </message>
    <message>
        <source>The skin is touched in several places. Remove everything but the stick.</source>
        <translation>La peau est touchée en plusieurs endroits. Ne laissez que le bâton.</translation>
    </message>
    <message>
        <source>Back to the previous hole. Probing it again replaces its pixel</source>
        <translation>Le trou précédent. Un trou palpé de nouveau reçoit un nouveau pixel</translation>
    </message>
    <message>
        <source>Skip this hole for now</source>
        <translation>Laisser ce trou de côté pour l’instant</translation>
    </message>
    <message>
        <source>Ne&amp;w reference</source>
        <translation>Rien ne to&amp;uche</translation>
    </message>
    <message>
        <source>Take the next frame as the reference: nothing may touch the skin</source>
        <translation>L’image suivante montre la peau sans aucun contact</translation>
    </message>
    <message>
        <source>Keep the pairs collected so far</source>
        <translation>Garder ce qui a été recueilli jusqu’ici</translation>
    </message>
</context>
<context>
    <name>teleta::console::LiveViewService</name>
    <message>
        <source>Li&amp;ve view for Foxglove</source>
        <translation>&amp;Vue en direct pour Foxglove</translation>
    </message>
    <message numerus="yes">
        <source>%n viewer(s)</source>
        <translation>
            <numerusform>%n spectateur</numerusform>
            <numerusform>%n spectateurs</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n message(s) missed</source>
        <translation>
            <numerusform>%n message manqué</numerusform>
            <numerusform>%n messages manqués</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>teleta::console::LogWindow</name>
    <message>
        <source>Save log</source>
        <translation>Enregistrer le journal</translation>
    </message>
    <message>
        <source>Text (*.txt)</source>
        <translation>Texte (*.txt)</translation>
    </message>
    <message>
        <source>Log</source>
        <translation>Journal</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Copier</translation>
    </message>
    <message>
        <source>&amp;Save…</source>
        <translation>&amp;Enregistrer…</translation>
    </message>
    <message>
        <source>C&amp;lose</source>
        <translation>&amp;Fermer</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>Enregistré&#xa0;: %1</translation>
    </message>
    <message>
        <source>%1 could not be saved: %2</source>
        <translation>%1 n’a pas pu être écrit&#xa0;: %2</translation>
    </message>
    <message>
        <source>Messages since the program started</source>
        <translation>Messages depuis le début du programme</translation>
    </message>
</context>
<context>
    <name>teleta::console::MainWindow</name>
    <message>
        <source>Looking for the site of %1…</source>
        <translation>Recherche du site de %1…</translation>
    </message>
    <message>
        <source>TeleTA Console</source>
        <translation>TeleTA Console</translation>
    </message>
    <message>
        <source>Operate</source>
        <translation>Conduite</translation>
    </message>
    <message>
        <source>What the arm touches, live or played back</source>
        <translation>Ce que touche le bras, en direct ou en relecture</translation>
    </message>
    <message>
        <source>Open recording</source>
        <translation>Ouvrir un enregistrement</translation>
    </message>
    <message>
        <source>Open source list</source>
        <translation>Ouvrir une liste de sources</translation>
    </message>
    <message>
        <source>Source lists (*.toml)</source>
        <translation>Listes de sources (*.toml)</translation>
    </message>
    <message>
        <source>Open scene</source>
        <translation>Ouvrir une scène</translation>
    </message>
    <message>
        <source>Scenes (*.toml)</source>
        <translation>Scènes (*.toml)</translation>
    </message>
    <message>
        <source>%1 could not be opened.</source>
        <comment>a file</comment>
        <translation>%1 n’a pas pu être ouvert.</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Fichier</translation>
    </message>
    <message>
        <source>&amp;Open</source>
        <translation>&amp;Ouvrir</translation>
    </message>
    <message>
        <source>&amp;Close source</source>
        <translation>&amp;Fermer la source</translation>
    </message>
    <message>
        <source>Close the source that is shown</source>
        <translation>Fermer la source affichée</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Quitter</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Affichage</translation>
    </message>
    <message>
        <source>&amp;Reset layout</source>
        <translation>&amp;Réinitialiser la disposition</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>&amp;Clair</translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation>&amp;Sombre</translation>
    </message>
    <message>
        <source>&amp;Full screen</source>
        <translation>&amp;Plein écran</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>A&amp;ide</translation>
    </message>
    <message>
        <source>&amp;Arm</source>
        <translation>&amp;Bras</translation>
    </message>
    <message>
        <source>&amp;Run its program</source>
        <translation>&amp;Exécuter son programme</translation>
    </message>
    <message>
        <source>&amp;Hold</source>
        <translation>&amp;Maintenir</translation>
    </message>
    <message>
        <source>&amp;Forget the explored contour</source>
        <translation>&amp;Oublier le contour exploré</translation>
    </message>
    <message>
        <source>What is touched from now on is another object</source>
        <translation>Ce qui est touché à partir de maintenant est un autre objet</translation>
    </message>
    <message>
        <source>&amp;Bracelet</source>
        <translation>B&amp;racelet</translation>
    </message>
    <message>
        <source>Patterns</source>
        <translation>Motifs</translation>
    </message>
    <message>
        <source>What the bracelet can say: edit, check and play patterns</source>
        <translation>Ce que le bracelet peut dire&#xa0;: modifier, vérifier et jouer des motifs</translation>
    </message>
    <message>
        <source>Study</source>
        <translation>Étude</translation>
    </message>
    <message>
        <source>User studies: from the first practice trial to confusion matrices and ANOVA</source>
        <translation>Études utilisateur&#xa0;: du premier essai d’entraînement aux matrices de confusion et à l’ANOVA</translation>
    </message>
    <message>
        <source>Calibrate</source>
        <translation>Étalonnage</translation>
    </message>
    <message>
        <source>Cost</source>
        <translation>Coût</translation>
    </message>
    <message>
        <source>The page Patterns opens the edits.</source>
        <translation>La page Motifs ouvre les modifications.</translation>
    </message>
    <message>
        <source>my own</source>
        <translation>le mien</translation>
    </message>
    <message>
        <source>dynamic</source>
        <translation>dynamique</translation>
    </message>
    <message>
        <source>static</source>
        <translation>statique</translation>
    </message>
    <message>
        <source>As the de&amp;sktop</source>
        <translation>Comme le b&amp;ureau</translation>
    </message>
    <message>
        <source>&amp;Recording</source>
        <translation>&amp;Enregistrement</translation>
    </message>
    <message>
        <source>What has to be measured: the motors of the bracelet, the camera in the tube, the taxels</source>
        <translation>Ce qui doit être mesuré&#xa0;: les moteurs du bracelet, la caméra dans le tube, les taxels</translation>
    </message>
    <message>
        <source>Re&amp;start</source>
        <translation>Re&amp;commencer</translation>
    </message>
    <message>
        <source>Foxglove can be connected to %1.</source>
        <translation>Foxglove peut être connecté à %1.</translation>
    </message>
    <message>
        <source>Open connection &gt; Foxglove WebSocket shows all sources there.</source>
        <translation>Open connection &gt; Foxglove WebSocket y montre toutes les sources.</translation>
    </message>
    <message>
        <source>The live view has ended.</source>
        <translation>La vue en direct s’est terminée.</translation>
    </message>
    <message>
        <source>Choose another port with --foxglove.</source>
        <translation>Choisissez un autre port avec --foxglove.</translation>
    </message>
    <message>
        <source>The layout %1 cannot be restored; the default one is shown.</source>
        <translation>La disposition %1 ne peut pas être rétablie&#xa0;; celle par défaut est affichée.</translation>
    </message>
    <message>
        <source>It was saved by another version of the program.</source>
        <translation>Elle a été enregistrée par une autre version du programme.</translation>
    </message>
    <message>
        <source>The desktop may turn the screen off while something runs: %1</source>
        <translation>Le bureau peut éteindre l’écran pendant que quelque chose est en cours&#xa0;: %1</translation>
    </message>
    <message>
        <source>%1 was made from %2.</source>
        <comment>two files</comment>
        <translation>%1 a été créé d’après %2.</translation>
    </message>
    <message>
        <source>A robot arm, a recording or a session is running</source>
        <translation>Un bras robotisé, un enregistrement ou une session est en cours</translation>
    </message>
    <message>
        <source>&amp;Preferences…</source>
        <translation>&amp;Préférences…</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>Ouvrir un élément &amp;récent</translation>
    </message>
    <message>
        <source>Recordings</source>
        <translation>Enregistrements</translation>
    </message>
    <message>
        <source>Studies</source>
        <translation>Études</translation>
    </message>
    <message>
        <source>&amp;Clear the list</source>
        <translation>&amp;Vider la liste</translation>
    </message>
    <message>
        <source>Reopen the &amp;last session</source>
        <translation>Rouvrir la &amp;dernière session</translation>
    </message>
    <message>
        <source>STOP was released after %1 s.</source>
        <translation>STOP a été relâché après&#xa0;%1 s.</translation>
    </message>
    <message>
        <source>STOP. %1</source>
        <comment>cause</comment>
        <translation>STOP.&#xa0;%1</translation>
    </message>
    <message>
        <source>Open arm</source>
        <translation>Ouvrir un bras</translation>
    </message>
    <message>
        <source>&amp;Open arm…</source>
        <translation>&amp;Ouvrir un bras…</translation>
    </message>
    <message>
        <source>An arm over ROS 2, described in a file</source>
        <translation>Un bras sur ROS 2, décrit dans un fichier</translation>
    </message>
    <message>
        <source>Scenes, arms and source lists</source>
        <translation>Scènes, bras et listes de sources</translation>
    </message>
    <message>
        <source>Recordings (*.teleta *.csv *.mcap *.npz *.npy *.h5 *.hdf5 *.mat *.asf)</source>
        <translation>Enregistrements (*.teleta *.csv *.mcap *.npz *.npy *.h5 *.hdf5 *.mat *.asf)</translation>
    </message>
    <message>
        <source>Plot</source>
        <translation>Tracé</translation>
    </message>
    <message>
        <source>Any signal over time: live ones and those of recordings, with cursors and spectra</source>
        <translation>N’importe quel signal au cours du temps, en direct ou d’un enregistrement, avec curseurs et spectres</translation>
    </message>
    <message>
        <source>Connect to a site</source>
        <translation>Se connecter à un site</translation>
    </message>
    <message>
        <source>Sites (*.toml)</source>
        <translation>Sites (*.toml)</translation>
    </message>
    <message>
        <source>&amp;Connect to a site…</source>
        <translation>Se &amp;connecter à un site…</translation>
    </message>
    <message>
        <source>Arms and arrays at another place, where teleta-site runs</source>
        <translation>Bras et réseaux en un autre lieu, où tourne teleta-site</translation>
    </message>
    <message>
        <source>Re&amp;quest control of the site</source>
        <translation>&amp;Demander la commande du site</translation>
    </message>
    <message>
        <source>Rele&amp;ase control of the site</source>
        <translation>Ren&amp;dre la commande du site</translation>
    </message>
    <message>
        <source>What accuracy costs in time on this machine, and the setting that the camera uses</source>
        <translation>Ce que la précision coûte en temps sur cette machine, et le réglage que la caméra utilise</translation>
    </message>
    <message>
        <source>Arms (*.toml)</source>
        <translation>Bras (*.toml)</translation>
    </message>
</context>
<context>
    <name>teleta::console::MarkList</name>
    <message>
        <source>Time</source>
        <translation>Temps</translation>
    </message>
    <message>
        <source>What was marked</source>
        <translation>Ce qui a été marqué</translation>
    </message>
    <message>
        <source>Marks</source>
        <translation>Marques</translation>
    </message>
    <message>
        <source>No marks. M sets one while something is recorded; its text can be typed then.</source>
        <translation>Aucune marque. M en pose une pendant un enregistrement&#xa0;; son texte peut alors être saisi.</translation>
    </message>
    <message>
        <source>Moments that somebody marked in the recording. Double-click a text or press Enter to type it, Delete takes a mark out, Ctrl+Z undoes. In a recording that is played, a double click on a mark goes there.</source>
        <translation>Instants que quelqu’un a marqués dans l’enregistrement. Double-cliquez sur un texte ou appuyez sur Entrée pour le saisir&#xa0;; Suppr retire une marque, Ctrl+Z annule. Dans un enregistrement en cours de lecture, un double clic sur une marque y mène.</translation>
    </message>
</context>
<context>
    <name>teleta::console::MotorCalibrator</name>
    <message>
        <source>Open the recording of a motor</source>
        <translation>Ouvrir l’enregistrement d’un moteur</translation>
    </message>
    <message>
        <source>Recordings (*.csv)</source>
        <translation>Enregistrements (*.csv)</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>Tableaux (*.csv)</translation>
    </message>
    <message>
        <source>Save a copy of the profile</source>
        <translation>Enregistrer une copie du profil</translation>
    </message>
    <message>
        <source>Profiles (*.toml)</source>
        <translation>Profils (*.toml)</translation>
    </message>
    <message>
        <source>Load a profile</source>
        <translation>Charger un profil</translation>
    </message>
    <message>
        <source>Choose another folder or file name.</source>
        <translation>Choisissez un autre dossier ou nom de fichier.</translation>
    </message>
    <message>
        <source>%1 could not be opened.</source>
        <comment>a file</comment>
        <translation>%1 n’a pas pu être ouvert.</translation>
    </message>
    <message>
        <source>%1 could not be saved.</source>
        <comment>a file</comment>
        <translation>%1 n’a pas pu être enregistré.</translation>
    </message>
    <message>
        <source>The motor profile cannot be used: the motors use assumed values.</source>
        <translation>Le profil des moteurs ne peut pas être utilisé&#xa0;; ils sont supposés.</translation>
    </message>
    <message>
        <source>Save the excitation</source>
        <translation>Écrire l’excitation</translation>
    </message>
    <message>
        <source>%1 belongs to another bracelet.</source>
        <comment>a file</comment>
        <translation>%1 est celui d’un autre bracelet.</translation>
    </message>
    <message>
        <source>The file is for “%1”, this bracelet is “%2”. Measure this one, or connect the other.</source>
        <translation>C’est celui de «&#xa0;%1&#xa0;», or celui-ci est «&#xa0;%2&#xa0;». Mesurez celui-ci, ou connectez l’autre.</translation>
    </message>
    <message>
        <source>Motor %1 was measured and is not saved.</source>
        <translation>Le moteur %1 a été mesuré et n’est pas enregistré.</translation>
    </message>
    <message>
        <source>Motors %1 were measured and are not saved.</source>
        <comment>1, 2</comment>
        <translation>Les moteurs %1 ont été mesurés et ne sont pas enregistrés.</translation>
    </message>
    <message>
        <source>Motor %1 was changed and is not saved.</source>
        <translation>Le moteur %1 a été modifié et n’est pas enregistré.</translation>
    </message>
    <message>
        <source>Motors %1 were changed and are not saved.</source>
        <comment>1, 2</comment>
        <translation>Les moteurs %1 ont été modifiés et ne sont pas enregistrés.</translation>
    </message>
</context>
<context>
    <name>teleta::console::NewStudyDialog</name>
    <message>
        <source>&amp;Participants</source>
        <translation>&amp;Participants</translation>
    </message>
    <message>
        <source>New study</source>
        <translation>Nouvelle étude</translation>
    </message>
    <message>
        <source>Pilot: people try it, marked PILOT everywhere</source>
        <translation>Pilote&#xa0;: des personnes l’essaient, marquée PILOTE partout</translation>
    </message>
    <message>
        <source>Simulated: no people, marked SIMULATED everywhere</source>
        <translation>Simulée&#xa0;: pas de personnes, marquée SIMULÉ partout</translation>
    </message>
    <message>
        <source>&amp;Choose…</source>
        <translation>C&amp;hoisir…</translation>
    </message>
    <message>
        <source>&amp;Mode</source>
        <translation>&amp;Mode</translation>
    </message>
    <message>
        <source>&amp;Seed</source>
        <translation>&amp;Graine</translation>
    </message>
    <message>
        <source>The seed is a whole number from 0 to 18446744073709551615.</source>
        <translation>La graine est un nombre entier de 0 à 18446744073709551615.</translation>
    </message>
    <message>
        <source>F&amp;rom a file…</source>
        <translation>D’un &amp;fichier…</translation>
    </message>
    <message>
        <source>A protocol of your own (TOML)</source>
        <translation>Votre propre protocole (TOML)</translation>
    </message>
    <message>
        <source>Pr&amp;otocol</source>
        <translation>Pr&amp;otocole</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <comment>a protocol; where it is from</comment>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Open a protocol</source>
        <translation>Ouvrir un protocole</translation>
    </message>
    <message>
        <source>Protocols (*.toml)</source>
        <translation>Protocoles (*.toml)</translation>
    </message>
    <message>
        <source>In a file in this folder, for one station</source>
        <translation>Dans un fichier de ce dossier&#xa0;: un seul poste</translation>
    </message>
    <message>
        <source>On a PostgreSQL server, shared by several stations</source>
        <translation>Sur un serveur PostgreSQL&#xa0;: des postes la partagent</translation>
    </message>
    <message>
        <source>Run: real participants, data count</source>
        <translation>Réelle&#xa0;: de vrais participants, compte comme données</translation>
    </message>
    <message>
        <source>New &amp;folder</source>
        <translation>&amp;Dossier, qui sera créé</translation>
    </message>
    <message>
        <source>S&amp;torage</source>
        <translation>&amp;Conservation</translation>
    </message>
    <message>
        <source>Create the study</source>
        <translation>Créer l’étude</translation>
    </message>
    <message>
        <source>Study folder</source>
        <translation>Dossier de l’étude</translation>
    </message>
    <message numerus="yes">
        <source>%n test trial(s) per participant</source>
        <translation>
            <numerusform>%n essai de test par participant</numerusform>
            <numerusform>%n essais de test par participant</numerusform>
        </translation>
    </message>
    <message>
        <source>There is no tactile pattern for %1: name a file for it in the protocol.</source>
        <translation>Ce protocole n’a pas de motif %1 à ressentir&#xa0;: nommez un fichier pour lui dans le protocole.</translation>
    </message>
    <message>
        <source>Choose a folder by its full path.</source>
        <translation>Choisissez un dossier, avec son chemin complet.</translation>
    </message>
    <message>
        <source>The file is not a usable protocol; the one above stays selected. %1</source>
        <translation>Le fichier n’est pas un protocole utilisable&#xa0;; celui ci-dessus reste choisi. %1</translation>
    </message>
    <message>
        <source>Determines the order of all trials: the same seed gives the same study. It is drawn at random, shown here and kept with the study.</source>
        <translation>Détermine l’ordre de tous les essais&#xa0;: la même graine donne la même étude. Elle est tirée au hasard, affichée ici et conservée avec l’étude.</translation>
    </message>
</context>
<context>
    <name>teleta::console::NoisePlayer</name>
    <message>
        <source>this computer has no sound output</source>
        <translation>cet ordinateur n’a pas de sortie audio</translation>
    </message>
    <message>
        <source>%1 cannot play 48 kHz</source>
        <comment>a sound output</comment>
        <translation>%1 ne peut pas jouer à 48 kHz</translation>
    </message>
    <message>
        <source>the sound output stopped</source>
        <translation>la sortie audio s’est arrêtée</translation>
    </message>
    <message>
        <source>headphones that stay plugged in</source>
        <translation>un casque qui reste branché</translation>
    </message>
    <message>
        <source>headphones, plugged in, or the noise from another device</source>
        <translation>un casque branché, ou le bruit depuis un autre appareil</translation>
    </message>
</context>
<context>
    <name>teleta::console::OperateDocks</name>
    <message>
        <source>Heatmap</source>
        <translation>Carte de chaleur</translation>
    </message>
    <message>
        <source>Reconstruction</source>
        <translation>Reconstruction</translation>
    </message>
    <message>
        <source>Features over time</source>
        <translation>Caractéristiques au cours du temps</translation>
    </message>
    <message>
        <source>Processing</source>
        <translation>Traitement</translation>
    </message>
    <message>
        <source>Stiffness</source>
        <translation>Raideur</translation>
    </message>
    <message>
        <source>Bracelet</source>
        <translation>Bracelet</translation>
    </message>
    <message>
        <source>Joints</source>
        <translation>Articulations</translation>
    </message>
    <message>
        <source>Touches</source>
        <translation>Touchers</translation>
    </message>
    <message>
        <source>Jog</source>
        <translation>Déplacement manuel</translation>
    </message>
    <message>
        <source>Feedback</source>
        <translation>Retour haptique</translation>
    </message>
    <message>
        <source>Contour</source>
        <translation>Contour</translation>
    </message>
    <message>
        <source>Servo</source>
        <translation>Asservissement</translation>
    </message>
    <message>
        <source>Servo runs</source>
        <translation>Exécutions d’asservissement</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Caméra</translation>
    </message>
    <message>
        <source>Events</source>
        <translation>Événements</translation>
    </message>
    <message>
        <source>Marks</source>
        <translation>Marques</translation>
    </message>
    <message>
        <source>Run sheet</source>
        <translation>Relevé des objets</translation>
    </message>
    <message>
        <source>Gel</source>
        <translation>Gel</translation>
    </message>
    <message>
        <source>Scene</source>
        <translation>Scène</translation>
    </message>
</context>
<context>
    <name>teleta::console::OperatePage</name>
    <message>
        <source>Choose another folder or file name.</source>
        <translation>Choisissez un autre dossier ou nom de fichier.</translation>
    </message>
    <message>
        <source>%1 was lost.</source>
        <comment>a source</comment>
        <translation>La source %1 a été perdue.</translation>
    </message>
    <message>
        <source>Check the cable and the power supply; it is tried again by itself.</source>
        <translation>Vérifiez le câble et l’alimentation&#xa0;; une nouvelle tentative est faite automatiquement.</translation>
    </message>
    <message>
        <source>joints</source>
        <translation>articulations</translation>
    </message>
    <message>
        <source>The bracelet could not be opened.</source>
        <translation>Le bracelet n’a pas pu être ouvert.</translation>
    </message>
    <message>
        <source>The file cannot be read further: it is damaged, or its disk is gone. Open it again when it can be read.</source>
        <translation>La suite du fichier est illisible&#xa0;: il est endommagé, ou son disque n’est plus là. Ouvrez-le à nouveau lorsqu’il sera lisible.</translation>
    </message>
    <message>
        <source>The settings of %1 changed while it was recorded.</source>
        <comment>a source</comment>
        <translation>Les réglages de %1 ont changé pendant l’enregistrement.</translation>
    </message>
    <message>
        <source>It is played with those of the beginning; the events of the recording have the others.</source>
        <translation>La lecture utilise ceux du début&#xa0;; les événements de l’enregistrement contiennent les autres.</translation>
    </message>
    <message>
        <source>The recording of %1 is damaged.</source>
        <comment>a source</comment>
        <translation>L’enregistrement de %1 est endommagé.</translation>
    </message>
    <message>
        <source>The blocks that cannot be read are passed over; the others are played.</source>
        <translation>Les blocs illisibles sont ignorés&#xa0;; les autres sont lus.</translation>
    </message>
    <message>
        <source>%1: joints</source>
        <comment>a source</comment>
        <translation>%1&#xa0;: articulations</translation>
    </message>
    <message>
        <source>Check mesh_path in the file with which you opened the arm or its site.</source>
        <translation>Vérifiez mesh_path dans le fichier par lequel vous avez ouvert le bras ou son site.</translation>
    </message>
</context>
<context>
    <name>teleta::console::PairEntry</name>
    <message>
        <source>Pi&amp;xel, px:</source>
        <translation>Pi&amp;xel, px&#xa0;:</translation>
    </message>
    <message>
        <source>&amp;Point, mm:</source>
        <translation>P&amp;oint, mm&#xa0;:</translation>
    </message>
    <message>
        <source>u, to the right</source>
        <translation>u, vers la droite</translation>
    </message>
    <message>
        <source>v, down</source>
        <translation>v, vers le bas</translation>
    </message>
    <message>
        <source>x of the point</source>
        <translation>x du point</translation>
    </message>
    <message>
        <source>y of the point</source>
        <translation>y du point</translation>
    </message>
    <message>
        <source>z of the point, along the tube</source>
        <translation>z du point, le long du tube</translation>
    </message>
    <message>
        <source>&amp;Add pair</source>
        <translation>&amp;Ajouter la paire</translation>
    </message>
    <message>
        <source>Add this pair (Enter)</source>
        <translation>Prendre cette paire en compte (Entrée)</translation>
    </message>
</context>
<context>
    <name>teleta::console::PatternCollection</name>
    <message>
        <source>The pattern could not be saved.</source>
        <translation>Le motif n’a pas pu être enregistré.</translation>
    </message>
    <message>
        <source>The pattern could not be duplicated.</source>
        <translation>Le motif n’a pas pu être dupliqué.</translation>
    </message>
    <message>
        <source>%1 could not be renamed.</source>
        <comment>a pattern</comment>
        <translation>%1 n’a pas pu être renommé.</translation>
    </message>
    <message>
        <source>%1 could not be deleted.</source>
        <comment>a pattern</comment>
        <translation>%1 n’a pas pu être supprimé.</translation>
    </message>
    <message>
        <source>%1 was renamed.</source>
        <comment>a pattern</comment>
        <translation>%1 a été renommé.</translation>
    </message>
    <message>
        <source>%1 was deleted.</source>
        <comment>a pattern</comment>
        <translation>%1 a été supprimé.</translation>
    </message>
    <message>
        <source>%1 could not be restored.</source>
        <comment>a pattern</comment>
        <translation>%1 n’a pas pu être restauré.</translation>
    </message>
</context>
<context>
    <name>teleta::console::PatternPlayback</name>
    <message>
        <source>The pattern is shown on the screen but not felt.</source>
        <translation>Ce qui est joué est seulement affiché, pas ressenti.</translation>
    </message>
</context>
<context>
    <name>teleta::console::PatternsPage</name>
    <message>
        <source>%1 (copy)</source>
        <translation>%1 (copie)</translation>
    </message>
    <message>
        <source>%1 could not be opened.</source>
        <comment>a file</comment>
        <translation>%1 n’a pas pu être ouvert.</translation>
    </message>
    <message>
        <source>New pattern</source>
        <translation>Nouveau motif</translation>
    </message>
    <message>
        <source>%1 could not be saved.</source>
        <comment>a file</comment>
        <translation>%1 n’a pas pu être enregistré.</translation>
    </message>
    <message>
        <source>Exporting %1…</source>
        <comment>a file</comment>
        <translation>Exportation de %1…</translation>
    </message>
    <message>
        <source>%1 was exported.</source>
        <comment>a file</comment>
        <translation>%1 a été exporté.</translation>
    </message>
    <message>
        <source>%1 could not be exported.</source>
        <comment>a file</comment>
        <translation>%1 n’a pas pu être exporté.</translation>
    </message>
    <message>
        <source>Unsaved edits</source>
        <translation>Modifications non enregistrées</translation>
    </message>
    <message numerus="yes">
        <source>There are %n more.</source>
        <translation>
            <numerusform>Il y en a %n de plus.</numerusform>
            <numerusform>Il y en a %n de plus.</numerusform>
        </translation>
    </message>
    <message>
        <source>Save pattern</source>
        <translation>Enregistrer le motif</translation>
    </message>
    <message>
        <source>Open pattern</source>
        <translation>Ouvrir un motif</translation>
    </message>
    <message>
        <source>Patterns (*.json)</source>
        <translation>Motifs (*.json)</translation>
    </message>
    <message>
        <source>HJIF (*.hjif)</source>
        <translation>HJIF (*.hjif)</translation>
    </message>
    <message>
        <source>Haptic clips (*.haptic *.haptic.zip)</source>
        <translation>Clips haptiques (*.haptic *.haptic.zip)</translation>
    </message>
    <message>
        <source>tact (*.tact)</source>
        <translation>tact (*.tact)</translation>
    </message>
    <message>
        <source>Open the edits</source>
        <translation>Ouvrir les modifications</translation>
    </message>
    <message>
        <source>Discard them</source>
        <translation>Les abandonner</translation>
    </message>
    <message>
        <source>Unsaved edits could not be backed up: a crash would lose them.</source>
        <translation>Les modifications non enregistrées n’ont pas pu être mises de côté&#xa0;: une panne les ferait perdre.</translation>
    </message>
    <message>
        <source>The strength limit of the bracelet could not be read or saved: check the slider Strongest.</source>
        <translation>La force maximale du bracelet n’a pas pu être lue ou conservée&#xa0;: vérifier le curseur «&#xa0;Intensité maximale&#xa0;».</translation>
    </message>
    <message>
        <source>%1 has unsaved edits.</source>
        <comment>a pattern</comment>
        <translation>%1 a des modifications non enregistrées.</translation>
    </message>
    <message>
        <source>The program ended before %1, edited %2, was saved. The file on disk is unchanged.</source>
        <comment>a pattern, a time</comment>
        <translation>Le programme s’est terminé sans enregistrer %1 (modification&#xa0;: %2). Le fichier sur le disque est resté tel quel.</translation>
    </message>
    <message>
        <source>%1 holds more than the pattern: %2</source>
        <comment>a file, a list of sentences</comment>
        <translation>%1 contient plus que le motif&#xa0;:&#xa0;%2</translation>
    </message>
    <message>
        <source>All patterns (*.json *.hjif *.haptic *.haptic.zip *.ahap *.ahap.zip *.tact)</source>
        <translation>Tous les motifs (*.json *.hjif *.haptic *.haptic.zip *.ahap *.ahap.zip *.tact)</translation>
    </message>
    <message>
        <source>AHAP (*.ahap *.ahap.zip)</source>
        <translation>AHAP (*.ahap *.ahap.zip)</translation>
    </message>
</context>
<context>
    <name>teleta::console::PlotLayoutsMenu</name>
    <message>
        <source>&amp;Save layout as…</source>
        <translation>&amp;Enregistrer la disposition sous…</translation>
    </message>
    <message>
        <source>D&amp;elete</source>
        <translation>&amp;Supprimer</translation>
    </message>
    <message>
        <source>Save layout</source>
        <translation>Enregistrer la disposition</translation>
    </message>
    <message>
        <source>Name (a layout of the same name is replaced):</source>
        <translation>Nom (une disposition du même nom est remplacée)&#xa0;:</translation>
    </message>
</context>
<context>
    <name>teleta::console::PlotPage</name>
    <message>
        <source>%1 could not be read.</source>
        <comment>a recording</comment>
        <translation>%1 n’a pas pu être lu.</translation>
    </message>
    <message numerus="yes">
        <source>%1 is damaged: %n part(s) could not be read and are gaps.</source>
        <translation>
            <numerusform>%1 est endommagé&#xa0;: %n partie n’a pas pu être lue et reste vide.</numerusform>
            <numerusform>%1 est endommagé&#xa0;: %n parties n’ont pas pu être lues et restent vides.</numerusform>
        </translation>
    </message>
    <message>
        <source>The layout %1 cannot be restored.</source>
        <translation>La disposition %1 ne peut pas être rétablie.</translation>
    </message>
    <message>
        <source>It was saved by another version of the program.</source>
        <translation>Elle a été enregistrée par une autre version du programme.</translation>
    </message>
    <message>
        <source>Save da&amp;ta…</source>
        <translation>Enregistrer les d&amp;onnées…</translation>
    </message>
    <message>
        <source>&amp;Add a recording…</source>
        <translation>&amp;Ajouter un enregistrement…</translation>
    </message>
    <message>
        <source>Plot a recording as a whole, without playing it</source>
        <translation>Tracer un enregistrement en entier, sans le lire</translation>
    </message>
    <message>
        <source>Reading: %p %</source>
        <translation>Lecture&#xa0;: %p&#xa0;%</translation>
    </message>
    <message>
        <source>Follow</source>
        <translation>Suivre</translation>
    </message>
    <message>
        <source>The newest sample stays at the right end (Space, End)</source>
        <translation>L’échantillon le plus récent reste au bord droit (Espace, Fin)</translation>
    </message>
    <message>
        <source>Show everything</source>
        <translation>Tout montrer</translation>
    </message>
    <message>
        <source>All samples, and axes that follow the values (Home, double click)</source>
        <translation>Tous les échantillons, et des axes qui suivent les valeurs (Début, double clic)</translation>
    </message>
    <message>
        <source>Cursors</source>
        <translation>Curseurs</translation>
    </message>
    <message>
        <source>Two lines to measure between (C); Left and Right move A, with Ctrl B</source>
        <translation>Deux lignes pour mesurer entre elles (C)&#xa0;; Gauche et Droite déplacent A, avec Ctrl B</translation>
    </message>
    <message>
        <source>Power density</source>
        <translation>Densité de puissance</translation>
    </message>
    <message>
        <source>Spectra show the density of power instead of the amplitude</source>
        <translation>Les spectres montrent la densité de puissance au lieu de l’amplitude</translation>
    </message>
    <message>
        <source>Layouts</source>
        <translation>Dispositions</translation>
    </message>
    <message>
        <source>Save what is plotted under a name, and choose it again</source>
        <translation>Enregistrer sous un nom ce qui est tracé, et le choisir de nouveau</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Enregistrer</translation>
    </message>
    <message>
        <source>The picture, or the samples in view as CSV</source>
        <translation>L’image, ou les échantillons visibles en CSV</translation>
    </message>
    <message>
        <source>Undo remove</source>
        <translation>Annuler le retrait</translation>
    </message>
    <message>
        <source>Nothing is plotted yet</source>
        <translation>Rien n’est encore tracé</translation>
    </message>
    <message>
        <source>Drag a signal from the list onto this place, or choose it there and press Enter.</source>
        <translation>Faites glisser ici un signal de la liste, ou choisissez-le et appuyez sur Entrée.</translation>
    </message>
    <message>
        <source>Open a demo</source>
        <translation>Ouvrir une démonstration</translation>
    </message>
    <message>
        <source>A simulated arm that touches things</source>
        <translation>Un bras simulé qui touche des objets</translation>
    </message>
    <message>
        <source>Add a recording…</source>
        <translation>Ajouter un enregistrement…</translation>
    </message>
    <message>
        <source>%1 old samples dropped</source>
        <translation>%1 anciens échantillons abandonnés</translation>
    </message>
    <message>
        <source>%1 frames lost</source>
        <translation>%1 trames perdues</translation>
    </message>
    <message>
        <source>Add a recording</source>
        <translation>Ajouter un enregistrement</translation>
    </message>
    <message>
        <source>Recordings (*.teleta)</source>
        <translation>Enregistrements (*.teleta)</translation>
    </message>
    <message>
        <source>Save data</source>
        <translation>Enregistrer les données</translation>
    </message>
    <message>
        <source>Comma-separated values (*.csv)</source>
        <translation>Valeurs séparées par des virgules (*.csv)</translation>
    </message>
    <message>
        <source>plot</source>
        <comment>name of a file</comment>
        <translation>trace</translation>
    </message>
    <message>
        <source>The data were saved.</source>
        <translation>Les données ont été enregistrées.</translation>
    </message>
    <message>
        <source>The data could not be saved.</source>
        <translation>Les données n’ont pas pu être enregistrées.</translation>
    </message>
    <message>
        <source>Choose another folder or file name.</source>
        <translation>Choisissez un autre dossier ou un autre nom de fichier.</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Stop reading and remove these signals; Ctrl+Z reads them again</source>
        <translation>Arrêter la lecture et retirer ces signaux&#xa0;; Ctrl+Z les relit</translation>
    </message>
</context>
<context>
    <name>teleta::console::PlotSignals</name>
    <message>
        <source>d/dt %1</source>
        <comment>derivative of a signal</comment>
        <translation>d/dt %1</translation>
    </message>
    <message>
        <source>its source is not open</source>
        <translation>sa source n’est pas ouverte</translation>
    </message>
    <message>
        <source>is being read</source>
        <translation>en cours de lecture</translation>
    </message>
</context>
<context>
    <name>teleta::console::PreferencesDialog</name>
    <message>
        <source>&amp;Keep the screen on while something runs</source>
        <translation>&amp;Garder l’écran allumé tant que quelque chose est en cours</translation>
    </message>
    <message>
        <source>Add the &amp;Unix time to exported CSV files</source>
        <translation>Ajouter le temps &amp;Unix aux fichiers CSV exportés</translation>
    </message>
    <message>
        <source>Preferences</source>
        <translation>Préférences</translation>
    </message>
    <message>
        <source>While a session runs, something is recorded, or an arm may move</source>
        <translation>Pendant une session, un enregistrement, ou quand un bras peut bouger</translation>
    </message>
    <message>
        <source>As the desktop</source>
        <translation>Comme le bureau</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Clair</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Sombre</translation>
    </message>
    <message>
        <source>Offer what was open last time</source>
        <translation>Proposer ce qui était ouvert la dernière fois</translation>
    </message>
    <message>
        <source>Open what was open last time</source>
        <translation>Ouvrir ce qui était ouvert la dernière fois</translation>
    </message>
    <message>
        <source>Open nothing</source>
        <translation>Ne rien ouvrir</translation>
    </message>
    <message>
        <source>A last column, utc_s, in seconds since 1970</source>
        <translation>Une dernière colonne, utc_s, en secondes depuis 1970</translation>
    </message>
    <message>
        <source>&amp;Choose…</source>
        <translation>&amp;Choisir…</translation>
    </message>
    <message>
        <source>Folder of recordings</source>
        <translation>Dossier des enregistrements</translation>
    </message>
    <message>
        <source>Lan&amp;guage:</source>
        <translation>&amp;Langue&#xa0;:</translation>
    </message>
    <message>
        <source>&amp;Theme:</source>
        <translation>&amp;Thème&#xa0;:</translation>
    </message>
    <message>
        <source>At the &amp;start:</source>
        <translation>Au &amp;démarrage&#xa0;:</translation>
    </message>
    <message>
        <source>&amp;Folder of recordings:</source>
        <translation>Dossier des &amp;enregistrements&#xa0;:</translation>
    </message>
</context>
<context>
    <name>teleta::console::ProbingStrip</name>
    <message>
        <source>Sto&amp;p probing</source>
        <translation>Arrê&amp;ter le palpage</translation>
    </message>
    <message>
        <source>Progress of the probing</source>
        <translation>Avancement du palpage</translation>
    </message>
    <message>
        <source>SIMULATED: a person probes the tube; pairs so far: %1</source>
        <translation>SIMULÉ&#xa0;: une personne palpe le tube&#xa0;; paires jusqu’ici&#xa0;: %1</translation>
    </message>
    <message>
        <source>Keep the pairs collected so far</source>
        <translation>Garder ce qui a été recueilli jusqu’ici</translation>
    </message>
</context>
<context>
    <name>teleta::console::ProtocolDialog</name>
    <message>
        <source>Protocol</source>
        <translation>Protocole</translation>
    </message>
    <message>
        <source>of the onset of the stimulus</source>
        <translation>après le début du stimulus</translation>
    </message>
    <message>
        <source>of its end</source>
        <translation>après sa fin</translation>
    </message>
    <message>
        <source> ×</source>
        <comment>after a number</comment>
        <translation> ×</translation>
    </message>
    <message>
        <source>all repetitions together, in random order</source>
        <translation>toutes les répétitions ensemble, dans un ordre aléatoire</translation>
    </message>
    <message>
        <source>each repetition in a random order</source>
        <translation>chaque répétition dans un ordre aléatoire</translation>
    </message>
    <message>
        <source>pink</source>
        <translation>rose</translation>
    </message>
    <message>
        <source>none</source>
        <translation>aucun</translation>
    </message>
    <message>
        <source>&amp;Name</source>
        <translation>&amp;Nom</translation>
    </message>
    <message>
        <source>D&amp;escription</source>
        <translation>D&amp;escription</translation>
    </message>
    <message>
        <source>&amp;Stimulus, at most</source>
        <translation>&amp;Stimulus, au plus</translation>
    </message>
    <message>
        <source>Answer &amp;within</source>
        <translation>&amp;Réponse en moins de</translation>
    </message>
    <message>
        <source>May be felt a&amp;gain</source>
        <translation>Peut être sent&amp;i à nouveau</translation>
    </message>
    <message>
        <source>Or&amp;der</source>
        <translation>Or&amp;dre</translation>
    </message>
    <message>
        <source>&amp;Practice</source>
        <translation>Entraîne&amp;ment</translation>
    </message>
    <message>
        <source>&amp;Test</source>
        <translation>&amp;Test</translation>
    </message>
    <message>
        <source>&amp;Masking noise</source>
        <translation>&amp;Bruit de masquage</translation>
    </message>
    <message>
        <source>&amp;Add a task</source>
        <translation>&amp;Ajouter une tâche</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>&amp;Ouvrir…</translation>
    </message>
    <message>
        <source>The pape&amp;r&apos;s</source>
        <translation>Celui de l’arti&amp;cle</translation>
    </message>
    <message>
        <source>Sa&amp;ve as…</source>
        <translation>Enre&amp;gistrer sous…</translation>
    </message>
    <message>
        <source>Make a st&amp;udy…</source>
        <translation>Créer une ét&amp;ude…</translation>
    </message>
    <message>
        <source>feedback</source>
        <translation>retour sur la réponse</translation>
    </message>
    <message>
        <source>pictures in view</source>
        <translation>images visibles</translation>
    </message>
    <message>
        <source> × each pattern</source>
        <comment>after a number</comment>
        <translation> × chaque motif</translation>
    </message>
    <message>
        <source>Task</source>
        <translation>Tâche</translation>
    </message>
    <message>
        <source>for example shape</source>
        <translation>par exemple shape</translation>
    </message>
    <message>
        <source>for example static, dynamic</source>
        <translation>par exemple static, dynamic</translation>
    </message>
    <message>
        <source>Identifier</source>
        <translation>Identifiant</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nom</translation>
    </message>
    <message>
        <source>Conditions</source>
        <translation>Conditions</translation>
    </message>
    <message>
        <source>Patterns</source>
        <translation>Motifs</translation>
    </message>
    <message>
        <source>Remove this task</source>
        <translation>Supprimer cette tâche</translation>
    </message>
    <message>
        <source>this form</source>
        <translation>ce formulaire</translation>
    </message>
    <message>
        <source> (expected: %1)</source>
        <translation> (attendu&#xa0;: %1)</translation>
    </message>
    <message>
        <source>Save the protocol</source>
        <translation>Enregistrer le protocole</translation>
    </message>
    <message>
        <source>Protocols (*.toml)</source>
        <translation>Protocoles (*.toml)</translation>
    </message>
    <message>
        <source>✓ Saved: %1</source>
        <translation>✓ Enregistré&#xa0;: %1</translation>
    </message>
    <message>
        <source>no rests</source>
        <translation>pas de repos</translation>
    </message>
    <message>
        <source>after every </source>
        <comment>before a number of trials</comment>
        <translation>tous les </translation>
    </message>
    <message>
        <source> trials</source>
        <comment>after a number</comment>
        <translation> essais</translation>
    </message>
    <message>
        <source>at least </source>
        <comment>before a number of seconds</comment>
        <translation>au moins </translation>
    </message>
    <message>
        <source>Rests</source>
        <translation>Repos</translation>
    </message>
    <message>
        <source>Add a &amp;questionnaire</source>
        <translation>Ajouter un &amp;questionnaire</translation>
    </message>
    <message>
        <source>Choose a pattern file…</source>
        <translation>Choisir un fichier de motif…</translation>
    </message>
    <message>
        <source>a letter and a condition of the task, then the file</source>
        <translation>une lettre et une condition de la tâche, puis le fichier</translation>
    </message>
    <message>
        <source>the file of &quot;%1 %2&quot; cannot be found</source>
        <translation>le fichier de «&#xa0;%1 %2&#xa0;» est introuvable</translation>
    </message>
    <message>
        <source>&quot;%1 %2&quot; has two files</source>
        <translation>«&#xa0;%1 %2&#xa0;» a deux fichiers</translation>
    </message>
    <message>
        <source>one file</source>
        <translation>un seul fichier</translation>
    </message>
    <message>
        <source>Pattern file for %1</source>
        <comment>a letter and a condition</comment>
        <translation>Fichier de motif pour %1</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>Changements non enregistrés</translation>
    </message>
    <message>
        <source>The protocol has changes that are not saved.</source>
        <translation>Le protocole a des changements non enregistrés.</translation>
    </message>
    <message>
        <source>letter, condition and file, one per line, for your own patterns; all others are built in</source>
        <translation>lettre, condition et fichier, un par ligne, pour vos propres motifs&#xa0;; tous les autres sont fournis avec le programme</translation>
    </message>
    <message>
        <source>letter and name, one per line, for example A circle</source>
        <translation>lettre et nom, un par ligne, par exemple A cercle</translation>
    </message>
    <message>
        <source>Your own</source>
        <translation>Vos propres motifs</translation>
    </message>
    <message>
        <source>the task has no pattern &quot;%1 %2&quot;</source>
        <translation>aucun motif de la tâche n’est ressenti comme «&#xa0;%1 %2&#xa0;»</translation>
    </message>
    <message>
        <source>its full path</source>
        <translation>son chemin complet</translation>
    </message>
    <message>
        <source>There is no tactile pattern for %1. Name a file for it, or use a task, letter and condition whose pattern is built in. The protocol can be saved as it is.</source>
        <translation>Il n’y a pas de motif %1 à ressentir. Nommez un fichier pour lui, ou prenez une tâche, une lettre et une condition dont le motif est fourni avec le programme&#xa0;; le protocole peut être enregistré.</translation>
    </message>
    <message numerus="yes">
        <source>%n test trial(s) per participant</source>
        <translation>
            <numerusform>%n essai de test par participant</numerusform>
            <numerusform>%n essais de test par participant</numerusform>
        </translation>
    </message>
    <message>
        <source>Add a task with &amp;levels</source>
        <translation>Ajouter une tâche à ni&amp;veaux</translation>
    </message>
    <message>
        <source>Re&amp;cord each session</source>
        <translation>Enregistrer c&amp;haque session</translation>
    </message>
    <message>
        <source>names separated by semicolons, for the description of exported data</source>
        <translation>noms séparés par&#xa0;;, pour les descriptions des données exportées</translation>
    </message>
    <message>
        <source>Aut&amp;hors</source>
        <translation>Auteurs (&amp;p)</translation>
    </message>
    <message>
        <source>Tr&amp;iggers</source>
        <translation>Déc&amp;lencheurs</translation>
    </message>
</context>
<context>
    <name>teleta::console::QuestionnaireEditor</name>
    <message>
        <source>Questionnaire</source>
        <translation>Questionnaire</translation>
    </message>
    <message>
        <source>for example effort</source>
        <translation>par exemple effort</translation>
    </message>
    <message>
        <source>before the first session</source>
        <translation>avant la première session</translation>
    </message>
    <message>
        <source>before each session</source>
        <translation>avant chaque session</translation>
    </message>
    <message>
        <source>after each session</source>
        <translation>après chaque session</translation>
    </message>
    <message>
        <source>after the last session</source>
        <translation>après la dernière session</translation>
    </message>
    <message>
        <source>Identifier</source>
        <translation>Identifiant</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>Titre</translation>
    </message>
    <message>
        <source>Filled in</source>
        <translation>Rempli</translation>
    </message>
    <message>
        <source>Add a question</source>
        <translation>Ajouter une question</translation>
    </message>
    <message>
        <source>Remove this questionnaire</source>
        <translation>Retirer ce questionnaire</translation>
    </message>
    <message>
        <source>for example hard</source>
        <translation>par exemple hard</translation>
    </message>
    <message>
        <source>free text</source>
        <translation>texte libre</translation>
    </message>
    <message>
        <source>scale</source>
        <translation>échelle</translation>
    </message>
    <message>
        <source>one of several answers</source>
        <translation>une réponse parmi plusieurs</translation>
    </message>
    <message>
        <source> points</source>
        <comment>after a number</comment>
        <translation> points</translation>
    </message>
    <message>
        <source>what the last point means</source>
        <translation>ce que signifie le dernier point</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Retirer</translation>
    </message>
    <message>
        <source>Remove this question</source>
        <translation>Retirer cette question</translation>
    </message>
    <message>
        <source>Question</source>
        <translation>Question</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Échelle</translation>
    </message>
    <message>
        <source>Answers</source>
        <translation>Réponses</translation>
    </message>
    <message>
        <source>required</source>
        <translation>réponse obligatoire</translation>
    </message>
    <message>
        <source>identifier and text, one per line, for example yes I felt it</source>
        <translation>identifiant et texte, un par ligne, par exemple yes I felt it</translation>
    </message>
    <message>
        <source>all questions have to be answered</source>
        <translation>il faut répondre à toutes les questions</translation>
    </message>
    <message>
        <source>of my own</source>
        <translation>personnel</translation>
    </message>
    <message>
        <source>NASA-TLX: six ratings</source>
        <translation>NASA-TLX&#xa0;: six évaluations</translation>
    </message>
    <message>
        <source>NASA-TLX: ratings and comparisons</source>
        <translation>NASA-TLX&#xa0;: évaluations et comparaisons</translation>
    </message>
    <message>
        <source>System Usability Scale</source>
        <translation>System Usability Scale</translation>
    </message>
    <message>
        <source>Questions</source>
        <translation>Questions</translation>
    </message>
    <message>
        <source>scale from 0 to 100</source>
        <translation>échelle de 0 à 100</translation>
    </message>
    <message>
        <source>one of two answers</source>
        <translation>une réponse parmi deux</translation>
    </message>
    <message>
        <source>what the first point means</source>
        <translation>ce que signifie le premier point</translation>
    </message>
</context>
<context>
    <name>teleta::console::RecordingControls</name>
    <message numerus="yes">
        <source>%n damaged block(s) left out.</source>
        <translation>
            <numerusform>%n bloc endommagé ignoré.</numerusform>
            <numerusform>%n blocs endommagés ignorés.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n CSV file(s) were written.</source>
        <translation>
            <numerusform>%n fichier CSV a été écrit.</numerusform>
            <numerusform>%n fichiers CSV ont été écrits.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 could not be exported.</source>
        <comment>a file</comment>
        <translation>%1 n’a pas pu être exporté.</translation>
    </message>
    <message>
        <source>Choose another recording or folder.</source>
        <translation>Choisissez un autre enregistrement ou dossier.</translation>
    </message>
    <message>
        <source>%1 was recorded.</source>
        <comment>a file</comment>
        <translation>%1 a été enregistré.</translation>
    </message>
    <message>
        <source>Nothing is recorded now.</source>
        <translation>Aucun enregistrement n’est en cours.</translation>
    </message>
    <message>
        <source>Marks are kept in a recording. Ctrl+R begins one.</source>
        <translation>Les marques sont conservées dans un enregistrement. Ctrl+R en commence un.</translation>
    </message>
    <message>
        <source>Folder of the recordings</source>
        <translation>Dossier des enregistrements</translation>
    </message>
    <message>
        <source>End the &amp;recording</source>
        <translation>&amp;Terminer l’enregistrement</translation>
    </message>
    <message>
        <source>&amp;Record</source>
        <translation>&amp;Enregistrer</translation>
    </message>
    <message>
        <source>&amp;Mark this moment</source>
        <translation>&amp;Marquer cet instant</translation>
    </message>
    <message>
        <source>&amp;Folder of the recordings…</source>
        <translation>&amp;Dossier des enregistrements…</translation>
    </message>
    <message>
        <source>&amp;Export recording as CSV…</source>
        <translation>E&amp;xporter un enregistrement en CSV…</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Annuler</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Rétablir</translation>
    </message>
    <message>
        <source>The recording ended: %1.</source>
        <translation>L’enregistrement s’est terminé&#xa0;: %1.</translation>
    </message>
    <message>
        <source>What was recorded until then can be opened: %1</source>
        <translation>Ce qui a été enregistré jusque-là peut être ouvert&#xa0;: %1</translation>
    </message>
    <message>
        <source>The recording could not begin.</source>
        <translation>L’enregistrement n’a pas pu commencer.</translation>
    </message>
    <message>
        <source>Choose another folder in the menu Recording.</source>
        <translation>Choisissez un autre dossier dans le menu Enregistrement.</translation>
    </message>
    <message>
        <source>The marks of %1 could not be changed.</source>
        <comment>a file</comment>
        <translation>Les marques de %1 n’ont pas pu être modifiées.</translation>
    </message>
    <message>
        <source>The recording was cut off; what had been written is there.</source>
        <translation>L’enregistrement a été coupé&#xa0;; ce qui avait été écrit est là.</translation>
    </message>
    <message>
        <source>Close whatever else uses the file. It is tried again with the next change of a mark, and when the program ends.</source>
        <translation>Fermez tout ce qui utilise encore le fichier. Un nouvel essai a lieu à la prochaine modification d’une marque, et à la fin du programme.</translation>
    </message>
    <message>
        <source>%1 was written.</source>
        <comment>a file</comment>
        <translation>%1 a été écrit.</translation>
    </message>
    <message>
        <source>Ex&amp;port recording as MCAP…</source>
        <translation>Ex&amp;porter un enregistrement en MCAP…</translation>
    </message>
    <message>
        <source>Play it</source>
        <translation>Le lire</translation>
    </message>
    <message>
        <source>Show in folder</source>
        <translation>Afficher dans le dossier</translation>
    </message>
</context>
<context>
    <name>teleta::console::RecordingDialog</name>
    <message>
        <source>The &amp;values fall under load</source>
        <translation>Les &amp;valeurs diminuent sous charge</translation>
    </message>
    <message>
        <source>Start &amp;again at the end</source>
        <translation>Re&amp;commencer à la fin</translation>
    </message>
    <message>
        <source>Open recording</source>
        <translation>Ouvrir un enregistrement</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source> Hz</source>
        <translation> Hz</translation>
    </message>
    <message>
        <source>as recorded</source>
        <translation>comme enregistré</translation>
    </message>
    <message>
        <source>none</source>
        <translation>aucun</translation>
    </message>
    <message>
        <source>…</source>
        <translation>…</translation>
    </message>
    <message>
        <source>Choose the recording of the unloaded array</source>
        <translation>Choisir l’enregistrement de la matrice à vide</translation>
    </message>
    <message>
        <source>rows ×</source>
        <comment>N rows x M columns</comment>
        <translation>lignes ×</translation>
    </message>
    <message>
        <source>columns</source>
        <translation>colonnes</translation>
    </message>
    <message>
        <source>Rows</source>
        <translation>Lignes</translation>
    </message>
    <message>
        <source>Columns</source>
        <translation>Colonnes</translation>
    </message>
    <message>
        <source>Recording:</source>
        <translation>Enregistrement&#xa0;:</translation>
    </message>
    <message>
        <source>&amp;Array:</source>
        <translation>&amp;Matrice&#xa0;:</translation>
    </message>
    <message>
        <source>&amp;Pitch:</source>
        <translation>&amp;Pas&#xa0;:</translation>
    </message>
    <message>
        <source>&amp;Unloaded (tare):</source>
        <translation>À vide (&amp;tare)&#xa0;:</translation>
    </message>
    <message>
        <source>&amp;Gain:</source>
        <translation>&amp;Gain&#xa0;:</translation>
    </message>
    <message>
        <source>Unit of the &amp;load:</source>
        <translation>&amp;Unité de la charge&#xa0;:</translation>
    </message>
    <message>
        <source>&amp;Threshold:</source>
        <translation>&amp;Seuil&#xa0;:</translation>
    </message>
    <message>
        <source>&amp;Rate:</source>
        <translation>&amp;Fréquence&#xa0;:</translation>
    </message>
    <message numerus="yes">
        <source>%n taxel(s), as in the file</source>
        <translation>
            <numerusform>%n taxel, comme dans le fichier</numerusform>
            <numerusform>%n taxels, comme dans le fichier</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 taxels, but the file has %2</source>
        <translation>%1 taxels, mais le fichier en a %2</translation>
    </message>
    <message>
        <source>Recording of the unloaded array</source>
        <translation>Enregistrement de la matrice à vide</translation>
    </message>
    <message>
        <source>Frames (*.csv)</source>
        <translation>Trames (*.csv)</translation>
    </message>
    <message>
        <source>Choose the gains of the taxels</source>
        <translation>Choisir les gains des taxels</translation>
    </message>
    <message>
        <source>Gains of the taxels</source>
        <translation>Gains des taxels</translation>
    </message>
    <message>
        <source>Gains (*.csv)</source>
        <translation>Gains (*.csv)</translation>
    </message>
    <message>
        <source>Gains of the ta&amp;xels:</source>
        <translation>Gains des ta&amp;xels&#xa0;:</translation>
    </message>
</context>
<context>
    <name>teleta::console::RecordingExport</name>
    <message>
        <source>Export recording as CSV</source>
        <translation>Exporter un enregistrement en CSV</translation>
    </message>
    <message>
        <source>Recordings (*.teleta)</source>
        <translation>Enregistrements (*.teleta)</translation>
    </message>
    <message>
        <source>Folder for the CSV files</source>
        <translation>Dossier des fichiers CSV</translation>
    </message>
    <message>
        <source>Exporting %1…</source>
        <comment>a file</comment>
        <translation>Exportation de %1…</translation>
    </message>
    <message>
        <source>another export is running</source>
        <translation>une autre exportation est en cours</translation>
    </message>
    <message>
        <source>Export recording as MCAP</source>
        <translation>Exporter un enregistrement en MCAP</translation>
    </message>
    <message>
        <source>MCAP file</source>
        <translation>Fichier MCAP</translation>
    </message>
    <message>
        <source>MCAP files (*.mcap)</source>
        <translation>Fichiers MCAP (*.mcap)</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Exporter…</translation>
    </message>
    <message>
        <source>Export here</source>
        <translation>Exporter ici</translation>
    </message>
</context>
<context>
    <name>teleta::console::RecordingFiles</name>
    <message>
        <source>%1 is there already.</source>
        <comment>a file</comment>
        <translation>%1 existe déjà.</translation>
    </message>
    <message>
        <source>It may have been made from %1 before. Importing the file again makes %2.</source>
        <comment>two files</comment>
        <translation>Il a peut-être été créé auparavant d’après %1. Importer de nouveau le fichier crée %2.</translation>
    </message>
    <message>
        <source>&amp;Open the recording</source>
        <translation>&amp;Ouvrir l’enregistrement</translation>
    </message>
    <message>
        <source>&amp;Import again</source>
        <translation>&amp;Importer de nouveau</translation>
    </message>
    <message>
        <source>Open file</source>
        <translation>Ouvrir un fichier</translation>
    </message>
    <message>
        <source>Import with other &amp;choices…</source>
        <translation>Importer avec d’autres &amp;choix…</translation>
    </message>
</context>
<context>
    <name>teleta::console::RecordingImport</name>
    <message>
        <source>a recording of this name is being made</source>
        <translation>un enregistrement de ce nom est en cours de création</translation>
    </message>
    <message>
        <source>Importing %1…</source>
        <comment>a file</comment>
        <translation>Importation de %1…</translation>
    </message>
    <message>
        <source>the folder cannot be made</source>
        <translation>le dossier ne peut pas être créé</translation>
    </message>
    <message>
        <source>Topics that cannot be read were left out: %1.</source>
        <translation>Des topics illisibles ont été laissés de côté&#xa0;: %1.</translation>
    </message>
    <message>
        <source>The file was cut off; what could be read is there.</source>
        <translation>Le fichier a été coupé&#xa0;; ce qui a pu être lu est là.</translation>
    </message>
    <message numerus="yes">
        <source>%n damaged chunk(s) left out.</source>
        <translation>
            <numerusform>%n bloc (chunk) endommagé ignoré.</numerusform>
            <numerusform>%n blocs (chunks) endommagés ignorés.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n damaged message(s) left out.</source>
        <translation>
            <numerusform>%n message endommagé ignoré.</numerusform>
            <numerusform>%n messages endommagés ignorés.</numerusform>
        </translation>
    </message>
    <message>
        <source>The checksum of the file is wrong: it was damaged somewhere.</source>
        <translation>La somme de contrôle du fichier est fausse&#xa0;: il a été endommagé quelque part.</translation>
    </message>
</context>
<context>
    <name>teleta::console::RecordingMarks</name>
    <message>
        <source>mark</source>
        <translation>marque</translation>
    </message>
    <message>
        <source>removal of a mark</source>
        <translation>suppression d’une marque</translation>
    </message>
    <message>
        <source>text of a mark</source>
        <translation>texte d’une marque</translation>
    </message>
</context>
<context>
    <name>teleta::console::RecordingService</name>
    <message>
        <source>the folder cannot be made</source>
        <translation>le dossier ne peut pas être créé</translation>
    </message>
    <message>
        <source>a folder that can be written to</source>
        <translation>un dossier où l’on peut écrire</translation>
    </message>
</context>
<context>
    <name>teleta::console::ScreenKeeper</name>
    <message>
        <source>the service has ended</source>
        <translation>le service s’est terminé</translation>
    </message>
    <message>
        <source>there is no session bus</source>
        <translation>il n’y a pas de bus de session</translation>
    </message>
    <message>
        <source>the answer is not understood</source>
        <translation>la réponse n’est pas comprise</translation>
    </message>
</context>
<context>
    <name>teleta::console::ServerFields</name>
    <message>
        <source>otherwise PGPASSWORD or ~/.pgpass</source>
        <translation>sinon PGPASSWORD ou ~/.pgpass</translation>
    </message>
    <message>
        <source>&amp;Server</source>
        <translation>&amp;Serveur</translation>
    </message>
    <message>
        <source>Pass&amp;word</source>
        <translation>Mot de &amp;passe</translation>
    </message>
    <message>
        <source>The address of a server looks like %1.</source>
        <translation>L’adresse d’un serveur ressemble à %1.</translation>
    </message>
    <message>
        <source>Used for this connection only, never saved</source>
        <translation>Utilisé pour cette connexion, et conservé nulle part</translation>
    </message>
</context>
<context>
    <name>teleta::console::ServerStudyDialog</name>
    <message>
        <source>Open a study on a server</source>
        <translation>Ouvrir une étude sur un serveur</translation>
    </message>
    <message>
        <source>&amp;Folder on this computer</source>
        <translation>&amp;Dossier sur cet ordinateur</translation>
    </message>
    <message>
        <source>Open the study</source>
        <translation>Ouvrir l’étude</translation>
    </message>
    <message>
        <source>For exports, and for trials while the server is unreachable</source>
        <translation>Les exports vont ici, ainsi que les essais pendant l’absence du serveur</translation>
    </message>
    <message>
        <source>Choose a folder by its full path.</source>
        <translation>Choisissez un dossier, avec son chemin complet.</translation>
    </message>
</context>
<context>
    <name>teleta::console::SignalSources</name>
    <message>
        <source>whole recording</source>
        <translation>enregistrement entier</translation>
    </message>
</context>
<context>
    <name>teleta::console::SiteViews</name>
    <message>
        <source>Ask for new keys in time.</source>
        <translation>Demandez de nouvelles clés à temps.</translation>
    </message>
    <message>
        <source>%1 was started anew.</source>
        <translation>%1 a été redémarré.</translation>
    </message>
    <message>
        <source>Request control again.</source>
        <translation>Demandez de nouveau la commande.</translation>
    </message>
    <message>
        <source>Control was handed to you by %1.</source>
        <translation>%1 vous a transmis la commande.</translation>
    </message>
    <message>
        <source>Let go of the switch and press it again.</source>
        <translation>Lâchez l’interrupteur et pressez-le de nouveau.</translation>
    </message>
    <message>
        <source>You no longer control %1.</source>
        <translation>Vous ne commandez plus %1.</translation>
    </message>
    <message>
        <source>%1 controls %2 now.</source>
        <translation>%1 commande maintenant %2.</translation>
    </message>
    <message>
        <source>STOP is held by %1.</source>
        <translation>STOP est maintenu par %1.</translation>
    </message>
    <message>
        <source>It can be withdrawn there, or by a supervisor.</source>
        <translation>Il peut être levé là-bas, ou par un superviseur.</translation>
    </message>
    <message>
        <source>%1 does not answer; its arms are held.</source>
        <translation>%1 ne répond pas ; ses bras sont maintenus.</translation>
    </message>
    <message>
        <source>The site holds its arms by itself when no command comes.</source>
        <translation>Le site maintient lui-même ses bras quand aucune commande n’arrive.</translation>
    </message>
    <message>
        <source>Refused: another console is in control, or the cause is still there.</source>
        <translation>Refusé : une autre console commande, ou la cause est toujours là.</translation>
    </message>
    <message>
        <source>Refused: this console may not do that.</source>
        <translation>Refusé : cette console n’en a pas le droit.</translation>
    </message>
    <message>
        <source>Refused: there is no such console.</source>
        <translation>Refusé : cette console n’existe pas.</translation>
    </message>
    <message>
        <source>Refused: this console is not in control.</source>
        <translation>Refusé : cette console ne commande pas.</translation>
    </message>
    <message>
        <source>Refused: STOP is engaged.</source>
        <translation>Refusé : STOP est engagé.</translation>
    </message>
    <message>
        <source>Nobody answered in time, or it was declined.</source>
        <translation>Personne n’a répondu à temps, ou c’était un refus.</translation>
    </message>
    <message>
        <source>not in control</source>
        <translation>sans la commande</translation>
    </message>
    <message>
        <source>control has changed since</source>
        <translation>la commande a changé depuis</translation>
    </message>
    <message>
        <source>STOP is engaged</source>
        <translation>STOP est engagé</translation>
    </message>
    <message>
        <source>the switch must be let go and pressed again</source>
        <translation>il faut lâcher l’interrupteur et le presser de nouveau</translation>
    </message>
    <message>
        <source>it was overtaken</source>
        <translation>elle a été dépassée</translation>
    </message>
    <message>
        <source>the loop takes too long</source>
        <translation>la boucle est trop longue</translation>
    </message>
    <message>
        <source>the arm is not known</source>
        <translation>le bras n’est pas connu</translation>
    </message>
    <message>
        <source>it was no number</source>
        <translation>ce n’était pas un nombre</translation>
    </message>
    <message>
        <source>the arm is not live</source>
        <translation>le bras n’est pas actif</translation>
    </message>
    <message>
        <source>another program has this console&apos;s name</source>
        <translation>un autre programme porte le nom de cette console</translation>
    </message>
</context>
<context>
    <name>teleta::console::StartPage</name>
    <message>
        <source>No source</source>
        <translation>Pas de source</translation>
    </message>
    <message>
        <source>Open a demo scene to look around, a recording, or a list of sources.</source>
        <translation>Ouvrez une scène de démonstration pour découvrir, un enregistrement, ou une liste de sources.</translation>
    </message>
    <message>
        <source>First &amp;steps</source>
        <translation>&amp;Premiers pas</translation>
    </message>
    <message>
        <source>The page of the handbook to begin with (F1)</source>
        <translation>La page du manuel par laquelle commencer (F1)</translation>
    </message>
    <message>
        <source>Open &amp;demo scene</source>
        <translation>Ouvrir une scène de &amp;démo</translation>
    </message>
    <message>
        <source>A simulated arm that touches five materials</source>
        <translation>Un bras simulé qui touche cinq matériaux</translation>
    </message>
    <message>
        <source>Open &amp;recording…</source>
        <translation>Ouvrir un en&amp;registrement…</translation>
    </message>
    <message>
        <source>A recording of this program or as MCAP, or recorded frames of an array: CSV, NumPy, HDF5, MATLAB, Tekscan</source>
        <translation>Un enregistrement de ce programme ou en MCAP, ou des trames d’une matrice : CSV, NumPy, HDF5, MATLAB, Tekscan</translation>
    </message>
    <message>
        <source>Open source &amp;list…</source>
        <translation>Ouvrir une &amp;liste de sources…</translation>
    </message>
    <message>
        <source>A TOML file that lists scenes and recordings</source>
        <translation>Un fichier TOML qui énumère des scènes et des enregistrements</translation>
    </message>
</context>
<context>
    <name>teleta::console::StudyBracelet</name>
    <message>
        <source>Tactor %1: %2 → %3</source>
        <comment>a number; full drives</comment>
        <translation>Tacteur %1&#xa0;: %2 → %3</translation>
    </message>
    <message>
        <source>Balance the bracelet</source>
        <translation>Équilibrer le bracelet</translation>
    </message>
    <message>
        <source>Use these full drives for the bracelet %1?</source>
        <translation>Utiliser ces pleines commandes pour le bracelet %1&#xa0;?</translation>
    </message>
    <message>
        <source>As felt by: %1</source>
        <comment>a participant, or all</comment>
        <translation>Ressenti par&#xa0;:&#xa0;%1</translation>
    </message>
    <message>
        <source>Patterns, feedback and later studies will use them. The page Calibrate can change them again.</source>
        <translation>Les motifs, le retour et les études suivantes jouent avec elles. La page Étalonnage permet de les modifier à nouveau.</translation>
    </message>
    <message>
        <source>&amp;Use them</source>
        <translation>&amp;Les utiliser</translation>
    </message>
    <message>
        <source>Another bracelet was connected meanwhile.</source>
        <translation>Un autre bracelet a été connecté entre-temps.</translation>
    </message>
    <message>
        <source>Nothing was changed. Connect the one with which the study was run.</source>
        <translation>Rien n’a été modifié. Connectez celui avec lequel l’étude a été menée.</translation>
    </message>
    <message>
        <source>The tactors are balanced.</source>
        <translation>Les tacteurs sont équilibrés.</translation>
    </message>
    <message>
        <source>Saved: %1</source>
        <translation>Enregistré&#xa0;:&#xa0;%1</translation>
    </message>
    <message>
        <source>The full drives could not be saved.</source>
        <translation>Les pleines commandes n’ont pas pu être enregistrées.</translation>
    </message>
    <message>
        <source>They are used until the program ends. Save them on the page Calibrate.</source>
        <translation>Elles servent jusqu’à la fin du programme. Enregistrez-les à la page Étalonnage.</translation>
    </message>
</context>
<context>
    <name>teleta::console::StudyController</name>
    <message>
        <source>the open study is being read or written</source>
        <translation>l’étude ouverte est en cours de lecture ou d’écriture</translation>
    </message>
    <message>
        <source>to leave the session first</source>
        <translation>quitter d’abord la session</translation>
    </message>
    <message>
        <source>to try again in a moment</source>
        <translation>réessayer dans un instant</translation>
    </message>
    <message>
        <source>%1 could not be opened.</source>
        <comment>a folder</comment>
        <translation>%1 n’a pas pu être ouvert.</translation>
    </message>
    <message>
        <source>The rehearsal could not be opened.</source>
        <translation>La répétition générale n’a pas pu être ouverte.</translation>
    </message>
    <message>
        <source>%1 could not be enrolled.</source>
        <comment>a participant</comment>
        <translation>%1 n’a pas pu être inscrit.</translation>
    </message>
    <message>
        <source>The study could not be read.</source>
        <translation>L’étude n’a pas pu être lue.</translation>
    </message>
    <message>
        <source>The trials are safe in the study, but could not be exported.</source>
        <translation>Les essais sont en sûreté dans l’étude, mais n’ont pas pu être exportés.</translation>
    </message>
    <message>
        <source>The session could not be closed.</source>
        <translation>La session n’a pas pu être close.</translation>
    </message>
    <message>
        <source>The note is safe in the study, but could not be exported.</source>
        <translation>La note est en sûreté dans l’étude, mais n’a pas pu être exportée.</translation>
    </message>
    <message>
        <source>The export failed.</source>
        <translation>L’exportation a échoué.</translation>
    </message>
    <message>
        <source>a session of the open study is running</source>
        <translation>une session de l’étude ouverte est en cours</translation>
    </message>
    <message>
        <source>The study could not be created.</source>
        <translation>L’étude n’a pas pu être créée.</translation>
    </message>
    <message>
        <source>The session could not start.</source>
        <translation>La session n’a pas pu commencer.</translation>
    </message>
    <message>
        <source>Saved and verified: %1</source>
        <translation>Enregistré, relu et comparé&#xa0;: %1</translation>
    </message>
    <message>
        <source>The note could not be saved.</source>
        <translation>La note n’a pas pu être conservée.</translation>
    </message>
    <message>
        <source>%1 could not be deleted.</source>
        <comment>a participant</comment>
        <translation>%1 n’a pas pu être supprimé.</translation>
    </message>
</context>
<context>
    <name>teleta::console::StudyLeaving</name>
    <message>
        <source>Study</source>
        <translation>Étude</translation>
    </message>
    <message>
        <source>&amp;Try again</source>
        <translation>&amp;Réessayer</translation>
    </message>
    <message>
        <source>&amp;End the session</source>
        <translation>&amp;Terminer la session</translation>
    </message>
    <message>
        <source>The last answer is not saved: %1</source>
        <translation>La dernière réponse n’est pas conservée&#xa0;: %1</translation>
    </message>
    <message>
        <source>It exists only in the memory of this program and is lost when the session ends.</source>
        <translation>Elle n’est que dans la mémoire de ce programme. La session se termine avec elle.</translation>
    </message>
    <message>
        <source>&amp;Discard it</source>
        <translation>&amp;Perdre la réponse</translation>
    </message>
    <message>
        <source>The session of %1 is still running.</source>
        <comment>a participant</comment>
        <translation>La session de %1 est en cours.</translation>
    </message>
    <message>
        <source>All answers are saved, and the session can be resumed later.</source>
        <translation>Ce qui a été répondu est conservé, et la session peut être reprise plus tard.</translation>
    </message>
</context>
<context>
    <name>teleta::console::StudyPage</name>
    <message>
        <source>No study</source>
        <translation>Pas d’étude</translation>
    </message>
    <message>
        <source>Run the user study of the paper, or one of your own: from the first practice trial to confusion matrices and ANOVA.</source>
        <translation>Menez l’étude utilisateur de l’article, ou la vôtre&#xa0;: du premier essai d’entraînement aux matrices de confusion et à l’ANOVA.</translation>
    </message>
    <message>
        <source>Watch a rehearsal</source>
        <translation>Voir une répétition générale</translation>
    </message>
    <message>
        <source>Simulated participants go through the whole study</source>
        <translation>Des participants simulés parcourent toute l’étude</translation>
    </message>
    <message>
        <source>New study…</source>
        <translation>Nouvelle étude…</translation>
    </message>
    <message>
        <source>Open a study…</source>
        <translation>Ouvrir une étude…</translation>
    </message>
    <message>
        <source>The folder of a study</source>
        <translation>Le dossier d’une étude</translation>
    </message>
    <message>
        <source>Study on a server…</source>
        <translation>Étude sur un serveur…</translation>
    </message>
    <message>
        <source>A study that several stations share</source>
        <translation>Une étude que partagent plusieurs postes</translation>
    </message>
    <message>
        <source>The noise cannot be played.</source>
        <translation>Le bruit ne peut pas être joué.</translation>
    </message>
    <message>
        <source>Play it from another device, and confirm its level.</source>
        <translation>Jouez-le depuis un autre appareil, et confirmez son niveau.</translation>
    </message>
    <message>
        <source>The figure could not be saved.</source>
        <translation>La figure n’a pas pu être enregistrée.</translation>
    </message>
    <message>
        <source>A session of this study was interrupted.</source>
        <translation>Une session de cette étude a été interrompue.</translation>
    </message>
    <message>
        <source>%1 could not be opened.</source>
        <comment>a file</comment>
        <translation>%1 n’a pas pu être ouvert.</translation>
    </message>
    <message>
        <source>The paper&apos;s protocol could not be read.</source>
        <translation>Le protocole de l’article n’a pas pu être lu.</translation>
    </message>
    <message>
        <source>Open a protocol</source>
        <translation>Ouvrir un protocole</translation>
    </message>
    <message>
        <source>Protocols (*.toml)</source>
        <translation>Protocoles (*.toml)</translation>
    </message>
    <message>
        <source>Open a study</source>
        <translation>Ouvrir une étude</translation>
    </message>
    <message>
        <source>✗ Not played: %1. Play it from another device.</source>
        <translation>✗ Non joué&#xa0;: %1. Jouez-le depuis un autre appareil.</translation>
    </message>
    <message>
        <source>Computing …</source>
        <translation>Calcul …</translation>
    </message>
    <message>
        <source>There are no completed trials yet.</source>
        <translation>Il n’y a pas encore d’essais achevés.</translation>
    </message>
    <message>
        <source>The results could not be computed.</source>
        <translation>Les résultats n’ont pas pu être calculés.</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>Écrit&#xa0;: %1</translation>
    </message>
    <message>
        <source>Session</source>
        <translation>Session</translation>
    </message>
    <message>
        <source>Results</source>
        <translation>Résultats</translation>
    </message>
    <message>
        <source>Counts</source>
        <translation>Effectifs</translation>
    </message>
    <message>
        <source>Percent of the row</source>
        <translation>Pourcentage de la ligne</translation>
    </message>
    <message>
        <source>What the matrix shows</source>
        <translation>Ce que montre la matrice</translation>
    </message>
    <message>
        <source>Spee&amp;d</source>
        <translation>&amp;Vitesse</translation>
    </message>
    <message>
        <source>Real time, felt on the bracelet</source>
        <translation>Temps réel, senti sur le bracelet</translation>
    </message>
    <message>
        <source>%1 times real time, not played</source>
        <translation>%1 fois le temps réel, non joué</translation>
    </message>
    <message>
        <source>The protocols that come with the program could not be read.</source>
        <translation>Les protocoles fournis avec le programme n’ont pas pu être lus.</translation>
    </message>
    <message>
        <source>comes with the program</source>
        <comment>a protocol</comment>
        <translation>fourni avec le programme</translation>
    </message>
    <message>
        <source>The participant&apos;s screen was disconnected.</source>
        <translation>L’écran du participant a été perdu.</translation>
    </message>
    <message>
        <source>The participant&apos;s window is now next to the console, and the session pauses. Reconnect the screen and show the window again.</source>
        <translation>La fenêtre du participant est maintenant à côté de la console, et la session est en pause. Rebranchez l’écran et affichez de nouveau la fenêtre.</translation>
    </message>
    <message>
        <source>The participant&apos;s window covers part of the console.</source>
        <translation>La fenêtre du participant couvre une partie de la console.</translation>
    </message>
    <message>
        <source>There is no second screen, and no room next to the console. Connect a second screen, or make the console smaller, and show the window again.</source>
        <translation>Il n’y a pas d’autre écran, ni de place à côté de la console. Branchez un second écran, ou réduisez la console, puis affichez de nouveau la fenêtre.</translation>
    </message>
    <message>
        <source>This study is read-only: nothing can be written here.</source>
        <translation>Cette étude peut seulement être consultée&#xa0;: rien ne peut être écrit ici.</translation>
    </message>
    <message>
        <source>Copy its whole folder to continue the study.</source>
        <translation>Copier son dossier entier pour la poursuivre.</translation>
    </message>
    <message>
        <source>No answer is lost. Resume it, or choose another one.</source>
        <translation>Aucune réponse n’est perdue. Reprenez-la, ou choisissez-en une autre.</translation>
    </message>
    <message>
        <source>Completed test trials only.</source>
        <translation>Essais de test complets&#xa0;; les autres sont écartés.</translation>
    </message>
    <message>
        <source>With the paper&apos;s protocol or your own</source>
        <translation>Selon le protocole de l’article, ou selon le vôtre</translation>
    </message>
    <message>
        <source>Speed of the simulated participants; can be changed between sessions</source>
        <translation>Rapidité des participants simulés&#xa0;; elle peut être changée entre les sessions</translation>
    </message>
    <message>
        <source>Plan</source>
        <translation>Planification</translation>
    </message>
    <message>
        <source>%1 was deleted.</source>
        <comment>a participant</comment>
        <translation>%1 a été supprimé.</translation>
    </message>
    <message>
        <source>Results that were written before still count the participant: write them again.</source>
        <translation>Les résultats écrits auparavant comptent encore le participant&#xa0;: écrivez-les à nouveau.</translation>
    </message>
</context>
<context>
    <name>teleta::console::StudyPlanning</name>
    <message>
        <source>What is assumed</source>
        <translation>Ce qui est supposé</translation>
    </message>
    <message>
        <source>Truth (*.toml)</source>
        <translation>Vérité (*.toml)</translation>
    </message>
    <message>
        <source>There is no number of participants to try: &quot;from&quot; is above &quot;to&quot;.</source>
        <translation>Il n’y a aucun nombre de participants à essayer&#xa0;: «&#xa0;de&#xa0;» est supérieur à «&#xa0;à&#xa0;».</translation>
    </message>
    <message>
        <source>this study</source>
        <translation>cette étude</translation>
    </message>
</context>
<context>
    <name>teleta::console::StudyRunner</name>
    <message>
        <source>STOP was pressed</source>
        <translation>STOP a été enclenché</translation>
    </message>
    <message>
        <source>there is no tactile pattern &quot;%1&quot;</source>
        <translation>il n’y a pas de motif «&#xa0;%1&#xa0;» à sentir</translation>
    </message>
    <message>
        <source>a protocol that names a file for each pattern that is not built in</source>
        <translation>un protocole qui nomme un fichier pour chaque motif qui n’est pas fourni avec le programme</translation>
    </message>
</context>
<context>
    <name>teleta::console::SweepPanel</name>
    <message>
        <source>Open the results of a sweep</source>
        <translation>Ouvrir les résultats d’un balayage</translation>
    </message>
    <message>
        <source>Open a sweep</source>
        <translation>Ouvrir un balayage</translation>
    </message>
    <message>
        <source>Sweeps (*.toml)</source>
        <translation>Balayages (*.toml)</translation>
    </message>
    <message>
        <source>Empty folder for the results, or one of this sweep to go on with</source>
        <translation>Dossier vide pour les résultats, ou un dossier de ce balayage à reprendre</translation>
    </message>
    <message>
        <source>%1 cells, each with %2 seeds: %3 runs.</source>
        <translation>%1 cellules, chacune avec %2 graines&#xa0;: %3 exécutions.</translation>
    </message>
    <message>
        <source>%1 done, %2 failed, in %3.</source>
        <translation>%1 faites, %2 échouées, dans %3.</translation>
    </message>
    <message>
        <source>%1 over the cells of the sweep</source>
        <translation>%1 sur les cellules du balayage</translation>
    </message>
    <message>
        <source>Runs</source>
        <translation>Exécutions</translation>
    </message>
    <message>
        <source>Failed</source>
        <translation>Échouées</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Moyenne</translation>
    </message>
    <message>
        <source>Spread</source>
        <translation>Dispersion</translation>
    </message>
    <message>
        <source>95 % from</source>
        <translation>95&#xa0;% de</translation>
    </message>
    <message>
        <source>95 % to</source>
        <translation>95&#xa0;% à</translation>
    </message>
    <message>
        <source>The runs that are under way end…</source>
        <translation>Les exécutions en cours se terminent…</translation>
    </message>
    <message>
        <source>Checking every cell…</source>
        <translation>Vérification de chaque cellule…</translation>
    </message>
    <message>
        <source>No sweep is open</source>
        <translation>Aucun balayage n’est ouvert</translation>
    </message>
    <message>
        <source>Choose one on the left, or open a file.</source>
        <translation>Choisissez-en un à gauche, ou ouvrez un fichier.</translation>
    </message>
    <message>
        <source>No results yet</source>
        <translation>Pas encore de résultats</translation>
    </message>
    <message>
        <source>A sweep runs a scene over a grid of settings and seeds, and keeps every run.</source>
        <translation>Un balayage exécute une scène sur une grille de réglages et de graines, et garde chaque exécution.</translation>
    </message>
    <message>
        <source>%1 of %2 runs, %3 failed, %4 left</source>
        <translation>%1 exécutions sur %2, %3 échouées, encore %4</translation>
    </message>
    <message>
        <source>Sweeps</source>
        <translation>Balayages</translation>
    </message>
    <message>
        <source>Sweeps that come with the program</source>
        <translation>Balayages fournis avec le programme</translation>
    </message>
    <message>
        <source>&amp;Open a sweep…</source>
        <translation>&amp;Ouvrir un balayage…</translation>
    </message>
    <message>
        <source>Open &amp;results…</source>
        <translation>Ouvrir des &amp;résultats…</translation>
    </message>
    <message>
        <source>&amp;Start…</source>
        <translation>&amp;Démarrer…</translation>
    </message>
    <message>
        <source>Start the sweep…</source>
        <translation>Démarrer le balayage…</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>&amp;Annuler</translation>
    </message>
    <message>
        <source>&amp;Measure</source>
        <translation>&amp;Mesure</translation>
    </message>
    <message>
        <source>Chart of a measure over the cells</source>
        <translation>Graphique d’une mesure sur les cellules</translation>
    </message>
    <message>
        <source>Cells with their settings and the measure</source>
        <translation>Cellules avec leurs réglages et la mesure</translation>
    </message>
</context>
<context>
    <name>teleta::console::SweepRunning</name>
    <message>
        <source>The sweep cannot be opened.</source>
        <translation>Le balayage ne peut pas être ouvert.</translation>
    </message>
    <message>
        <source>The sweep has failed.</source>
        <translation>Le balayage a échoué.</translation>
    </message>
</context>
<context>
    <name>teleta::console::TriggerEditor</name>
    <message>
        <source>none</source>
        <translation>aucun</translation>
    </message>
    <message>
        <source>serial port</source>
        <translation>port série</translation>
    </message>
    <message>
        <source>OSC by UDP</source>
        <translation>OSC par UDP</translation>
    </message>
    <message>
        <source>Serial port</source>
        <translation>Port série</translation>
    </message>
    <message>
        <source>back to 0 after </source>
        <comment>before a number of milliseconds</comment>
        <translation>retour à 0 après </translation>
    </message>
    <message>
        <source>not back to 0</source>
        <translation>pas de retour à 0</translation>
    </message>
    <message>
        <source>Name or address of the receiver</source>
        <translation>Nom ou adresse du récepteur</translation>
    </message>
    <message>
        <source>port </source>
        <comment>before a number</comment>
        <translation>port </translation>
    </message>
</context>
<context>
    <name>teleta::console::TubeFields</name>
    <message>
        <source>&amp;Image:</source>
        <translation>&amp;Image&#xa0;:</translation>
    </message>
    <message>
        <source>&amp;Radius:</source>
        <translation>&amp;Rayon&#xa0;:</translation>
    </message>
    <message>
        <source>Len&amp;gth:</source>
        <translation>&amp;Longueur&#xa0;:</translation>
    </message>
    <message>
        <source>Width of the image</source>
        <translation>Largeur de l’image</translation>
    </message>
    <message>
        <source>Height of the image</source>
        <translation>Hauteur de l’image</translation>
    </message>
    <message>
        <source>Radius of the tactile cylinder</source>
        <translation>Rayon du cylindre tactile</translation>
    </message>
    <message>
        <source>Length of the tactile cylinder</source>
        <translation>Longueur du cylindre tactile</translation>
    </message>
    <message>
        <source>Length of the surface, from z = 0 of the sensor&apos;s frame</source>
        <translation>Longueur de la surface, depuis z = 0 du repère du capteur</translation>
    </message>
    <message>
        <source>&amp;Hole factor:</source>
        <translation>Facteur des &amp;trous&#xa0;:</translation>
    </message>
    <message>
        <source>Width of the image that the pixels refer to</source>
        <translation>Largeur de l’image qui contient les pixels</translation>
    </message>
    <message>
        <source>Height of the image that the pixels refer to</source>
        <translation>Hauteur de l’image qui contient les pixels</translation>
    </message>
    <message>
        <source>Radius of the surface that the points lie on</source>
        <translation>Rayon de la surface qui porte les points</translation>
    </message>
    <message>
        <source>Factor from the holes of a shell to the tactile cylinder</source>
        <translation>Des trous d’une coque au cylindre tactile</translation>
    </message>
    <message>
        <source>For points that are holes of a shell: x and y times this factor lie on the elastomer (0.97 for the shell in the paper)</source>
        <translation>Les points sont les trous d’une coque&#xa0;: leurs x et y multipliés par ce facteur sont sur l’élastomère (coque de l’article&#xa0;: 0,97)</translation>
    </message>
</context>
<context>
    <name>teleta::console::Unattended</name>
    <message>
        <source>teleta-console: %1: cannot write the picture: %2</source>
        <translation>teleta-console&#xa0;: %1&#xa0;: impossible d’écrire l’image&#xa0;: %2</translation>
    </message>
</context>
<context>
    <name>teleta::cost::CostChart</name>
    <message>
        <source>median time of one call</source>
        <translation>temps médian d’un appel</translation>
    </message>
    <message>
        <source>mean error</source>
        <translation>erreur moyenne</translation>
    </message>
    <message>
        <source>Mean error over time of the settings of %1</source>
        <translation>Erreur moyenne en fonction du temps, pour les réglages de %1</translation>
    </message>
    <message>
        <source>%1 (exact)</source>
        <comment>name of a setting</comment>
        <translation>%1 (exact)</translation>
    </message>
</context>
<context>
    <name>teleta::pattern::LawList</name>
    <message>
        <source>Laws of the display</source>
        <translation>Lois de l’affichage tactile</translation>
    </message>
    <message>
        <source>Warnings</source>
        <translation>Avertissements</translation>
    </message>
    <message>
        <source>&amp;Fix</source>
        <translation>&amp;Corriger</translation>
    </message>
    <message>
        <source>Laws: no warning</source>
        <translation>Lois&#xa0;: aucun avertissement</translation>
    </message>
    <message>
        <source>Laws: checking…</source>
        <translation>Lois&#xa0;: examen…</translation>
    </message>
    <message>
        <source>Laws: %1 to review</source>
        <translation>Lois&#xa0;: %1 à examiner</translation>
    </message>
</context>
<context>
    <name>teleta::pattern::PatternDocument</name>
    <message>
        <source>%1 (copy)</source>
        <translation>%1 (copie)</translation>
    </message>
    <message>
        <source>Add breakpoint</source>
        <translation>Ajouter un nœud</translation>
    </message>
    <message>
        <source>Move object</source>
        <translation>Déplacer l’objet</translation>
    </message>
    <message>
        <source>Move breakpoints</source>
        <translation>Déplacer les nœuds</translation>
    </message>
    <message>
        <source>Set breakpoint</source>
        <translation>Régler le nœud</translation>
    </message>
    <message>
        <source>Change curve</source>
        <translation>Changer la courbe</translation>
    </message>
    <message>
        <source>Scale intensity</source>
        <translation>Mettre l’intensité à l’échelle</translation>
    </message>
    <message>
        <source>Stretch in time</source>
        <translation>Étirer dans le temps</translation>
    </message>
    <message>
        <source>Delete object</source>
        <translation>Supprimer l’objet</translation>
    </message>
    <message>
        <source>Delete breakpoints</source>
        <translation>Supprimer les nœuds</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Couper</translation>
    </message>
    <message>
        <source>Paste</source>
        <translation>Coller</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>Dupliquer</translation>
    </message>
    <message>
        <source>Rotate</source>
        <translation>Tourner</translation>
    </message>
    <message>
        <source>Mirror</source>
        <translation>Mettre en miroir</translation>
    </message>
    <message>
        <source>Swap arms</source>
        <translation>Changer de bras</translation>
    </message>
    <message>
        <source>Add object</source>
        <translation>Ajouter un objet</translation>
    </message>
    <message>
        <source>Change object</source>
        <translation>Modifier l’objet</translation>
    </message>
    <message>
        <source>Bake object</source>
        <translation>Convertir l’objet en nœuds</translation>
    </message>
    <message>
        <source>Follow the law</source>
        <translation>Suivre la loi</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Renommer</translation>
    </message>
    <message>
        <source>Edit notes</source>
        <translation>Modifier les notes</translation>
    </message>
    <message>
        <source>Edit tags</source>
        <translation>Modifier les étiquettes</translation>
    </message>
    <message>
        <source>Change task</source>
        <translation>Changer la tâche</translation>
    </message>
    <message>
        <source>Change condition</source>
        <translation>Changer la condition</translation>
    </message>
    <message>
        <source>Change duration</source>
        <translation>Changer la durée</translation>
    </message>
    <message>
        <source>Overdrive</source>
        <translation>Surintensité</translation>
    </message>
    <message>
        <source>No motor needs overdrive here: the pattern is unchanged.</source>
        <translation>Aucun moteur n’a besoin d’aide ici&#xa0;: le motif reste tel quel.</translation>
    </message>
</context>
<context>
    <name>teleta::pattern::PatternEditor</name>
    <message>
        <source>&amp;Recent</source>
        <translation>&amp;Récents</translation>
    </message>
    <message>
        <source>Compared with %1…</source>
        <translation>Comparé à %1…</translation>
    </message>
    <message>
        <source>Compared with %1: largest difference %2 % (motor %3 at %4 s), rms %5 %</source>
        <translation>Comparé à %1&#xa0;: plus grand écart %2&#xa0;% (moteur %3 à %4 s), RMS %5&#xa0;%</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Fichier</translation>
    </message>
    <message>
        <source>New, open, recent, save, export</source>
        <translation>Nouveau, ouvrir, récents, enregistrer, exporter</translation>
    </message>
    <message>
        <source>New</source>
        <translation>Nouveau</translation>
    </message>
    <message>
        <source>An empty pattern</source>
        <translation>Un motif vide</translation>
    </message>
    <message>
        <source>Open…</source>
        <translation>Ouvrir…</translation>
    </message>
    <message>
        <source>Open a pattern file</source>
        <translation>Ouvrir un fichier de motif</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Enregistrer</translation>
    </message>
    <message>
        <source>Save as…</source>
        <translation>Enregistrer sous…</translation>
    </message>
    <message>
        <source>Save the pattern under another name</source>
        <translation>Enregistrer le motif sous un autre nom</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Exporter…</translation>
    </message>
    <message>
        <source>Write HJIF, .haptic, AHAP, .tact, CSV or WAV</source>
        <translation>Écrire en HJIF, .haptic, AHAP, .tact, CSV ou WAV</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Jouer</translation>
    </message>
    <message>
        <source>Play from the playhead, or pause (Space)</source>
        <translation>Jouer depuis la tête de lecture, ou mettre en pause (Espace)</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Arrêter</translation>
    </message>
    <message>
        <source>Stop playing</source>
        <translation>Arrêter la lecture</translation>
    </message>
    <message>
        <source>Loop</source>
        <translation>Boucle</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Undo the last edit</source>
        <translation>Annuler la dernière modification</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Rétablir</translation>
    </message>
    <message>
        <source>Redo what was undone</source>
        <translation>Rétablir ce qui a été annulé</translation>
    </message>
    <message>
        <source>Pen</source>
        <translation>Crayon</translation>
    </message>
    <message>
        <source>Every click adds a breakpoint (P)</source>
        <translation>Chaque clic ajoute un nœud (P)</translation>
    </message>
    <message>
        <source>Snap</source>
        <translation>Magnétisme</translation>
    </message>
    <message>
        <source>Step of the grid, and of the arrow keys</source>
        <translation>Pas de la grille et des touches fléchées</translation>
    </message>
    <message>
        <source>Step of the grid</source>
        <translation>Pas de la grille</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Ajouter</translation>
    </message>
    <message>
        <source>Add an object at the playhead</source>
        <translation>Ajouter un objet à la tête de lecture</translation>
    </message>
    <message>
        <source>↺ 60°</source>
        <translation>↺ 60°</translation>
    </message>
    <message>
        <source>Rotate around the ring: every motor does what the next one did</source>
        <translation>Tourner autour de l’anneau&#xa0;: chaque moteur fait ce que faisait le suivant</translation>
    </message>
    <message>
        <source>↻ 60°</source>
        <translation>↻ 60°</translation>
    </message>
    <message>
        <source>Rotate around the ring: every motor does what the one before did</source>
        <translation>Tourner autour de l’anneau&#xa0;: chaque moteur fait ce que faisait le précédent</translation>
    </message>
    <message>
        <source>Mirror</source>
        <translation>Miroir</translation>
    </message>
    <message>
        <source>Other arm</source>
        <translation>Autre bras</translation>
    </message>
    <message>
        <source>The pattern for the other arm</source>
        <translation>Le motif pour l’autre bras</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Ajuster</translation>
    </message>
    <message>
        <source>Show the whole pattern (Ctrl+0 on the timeline)</source>
        <translation>Afficher tout le motif (Ctrl+0 sur la chronologie)</translation>
    </message>
    <message>
        <source>Untitled</source>
        <translation>Sans titre</translation>
    </message>
    <message>
        <source>not saved</source>
        <translation>non enregistré</translation>
    </message>
    <message>
        <source>left arm</source>
        <translation>bras gauche</translation>
    </message>
    <message>
        <source>right arm</source>
        <translation>bras droit</translation>
    </message>
    <message>
        <source>Compared with %1: no difference</source>
        <translation>Comparé à %1&#xa0;: les moteurs font la même chose</translation>
    </message>
    <message>
        <source>Pattern editor</source>
        <translation>Éditeur de motifs</translation>
    </message>
    <message>
        <source>Save the pattern; a new one is added to your own patterns</source>
        <translation>Enregistrer le motif&#xa0;; sans fichier, il va parmi vos propres motifs</translation>
    </message>
    <message>
        <source>Repeat from the beginning; Shift and dragging on the ruler set the range</source>
        <translation>Recommencer à la fin&#xa0;; Shift et glisser sur la règle définissent la plage</translation>
    </message>
    <message>
        <source>Snap times to a grid; hold Alt while dragging to ignore it</source>
        <translation>Temps sur une grille&#xa0;; Alt en glissant s’en libère</translation>
    </message>
    <message>
        <source>Reverse the order of the motors</source>
        <translation>L’ordre des moteurs dans l’autre sens</translation>
    </message>
    <message>
        <source>Stop comparing</source>
        <translation>Ne plus comparer</translation>
    </message>
    <message>
        <source>built-in, edits create a copy</source>
        <translation>intégré, toute modification en fait une copie</translation>
    </message>
    <message>
        <source>STOP is engaged: release it to play</source>
        <translation>STOP est enclenché&#xa0;: relâchez-le pour jouer</translation>
    </message>
</context>
<context>
    <name>teleta::pattern::PatternInspector</name>
    <message>
        <source>Numbers from 1 to 6, separated by spaces</source>
        <translation>Nombres de 1 à 6, séparés par des espaces</translation>
    </message>
    <message>
        <source>Motors:</source>
        <translation>Moteurs&#xa0;:</translation>
    </message>
    <message>
        <source>Burst:</source>
        <translation>Salve&#xa0;:</translation>
    </message>
    <message>
        <source>Onset to onset:</source>
        <translation>D’un début à l’autre&#xa0;:</translation>
    </message>
    <message>
        <source>Onset by the law of apparent motion</source>
        <translation>Début selon la loi du mouvement apparent</translation>
    </message>
    <message>
        <source>Turns:</source>
        <translation>Tours&#xa0;:</translation>
    </message>
    <message>
        <source>First motor:</source>
        <translation>Premier moteur&#xa0;:</translation>
    </message>
    <message>
        <source>Counter-clockwise (rising numbers)</source>
        <translation>Sens antihoraire (numéros croissants)</translation>
    </message>
    <message>
        <source>Burst by the law of apparent motion</source>
        <translation>Salve selon la loi du mouvement apparent</translation>
    </message>
    <message>
        <source>Second motor:</source>
        <translation>Second moteur&#xa0;:</translation>
    </message>
    <message>
        <source>From:</source>
        <translation>De&#xa0;:</translation>
    </message>
    <message>
        <source>To:</source>
        <translation>À&#xa0;:</translation>
    </message>
    <message>
        <source>Period:</source>
        <translation>Période&#xa0;:</translation>
    </message>
    <message>
        <source>Width:</source>
        <translation>Largeur&#xa0;:</translation>
    </message>
    <message>
        <source>Length:</source>
        <translation>Durée&#xa0;:</translation>
    </message>
    <message>
        <source>Begins at:</source>
        <translation>Commence à&#xa0;:</translation>
    </message>
    <message>
        <source>Point:</source>
        <translation>Point&#xa0;:</translation>
    </message>
    <message>
        <source>its time:</source>
        <translation>son temps&#xa0;:</translation>
    </message>
    <message>
        <source>its angle:</source>
        <translation>son angle&#xa0;:</translation>
    </message>
    <message>
        <source>along the arm:</source>
        <translation>le long du bras&#xa0;:</translation>
    </message>
    <message>
        <source>Start:</source>
        <translation>Début&#xa0;:</translation>
    </message>
    <message>
        <source>Intensity:</source>
        <translation>Intensité&#xa0;:</translation>
    </message>
    <message>
        <source>Called:</source>
        <translation>Nommé&#xa0;:</translation>
    </message>
    <message>
        <source>Bake into breakpoints</source>
        <translation>Convertir en nœuds</translation>
    </message>
    <message>
        <source>&amp;Name:</source>
        <translation>&amp;Nom&#xa0;:</translation>
    </message>
    <message>
        <source>Le&amp;ngth:</source>
        <translation>&amp;Durée&#xa0;:</translation>
    </message>
    <message>
        <source>&amp;Loop:</source>
        <translation>&amp;Boucle&#xa0;:</translation>
    </message>
    <message>
        <source>Begin of the loop</source>
        <translation>Début de la boucle</translation>
    </message>
    <message>
        <source>End of the loop</source>
        <translation>Fin de la boucle</translation>
    </message>
    <message>
        <source>T&amp;ells:</source>
        <translation>&amp;Exprime&#xa0;:</translation>
    </message>
    <message>
        <source>Condition</source>
        <translation>Condition</translation>
    </message>
    <message>
        <source>a shape</source>
        <translation>une forme</translation>
    </message>
    <message>
        <source>a stiffness</source>
        <translation>une raideur</translation>
    </message>
    <message>
        <source>something else</source>
        <translation>autre chose</translation>
    </message>
    <message>
        <source>no condition</source>
        <translation>sans condition</translation>
    </message>
    <message>
        <source>static</source>
        <translation>statique</translation>
    </message>
    <message>
        <source>dynamic</source>
        <translation>dynamique</translation>
    </message>
    <message>
        <source>&amp;Tags:</source>
        <translation>É&amp;tiquettes&#xa0;:</translation>
    </message>
    <message>
        <source>N&amp;otes:</source>
        <translation>N&amp;otes&#xa0;:</translation>
    </message>
    <message>
        <source>Nothing is selected</source>
        <translation>Rien n’est sélectionné</translation>
    </message>
    <message>
        <source>Breakpoint of motor %1</source>
        <translation>Nœud du moteur %1</translation>
    </message>
    <message>
        <source>%1 breakpoints</source>
        <translation>%1 nœuds</translation>
    </message>
    <message>
        <source>Time:</source>
        <translation>Temps&#xa0;:</translation>
    </message>
    <message>
        <source>Scale by:</source>
        <translation>Multiplier par&#xa0;:</translation>
    </message>
    <message>
        <source>Stretch to:</source>
        <translation>Étirer à&#xa0;:</translation>
    </message>
    <message>
        <source>Curve:</source>
        <translation>Courbe&#xa0;:</translation>
    </message>
    <message>
        <source>The range that is repeated; the whole pattern when both times are equal</source>
        <translation>Ce qui est joué en boucle&#xa0;; tout le motif si les deux sont égaux</translation>
    </message>
</context>
<context>
    <name>teleta::pattern::PatternLibrary</name>
    <message>
        <source>Filter the patterns</source>
        <translation>Filtrer les motifs</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Patterns</source>
        <translation>Motifs</translation>
    </message>
    <message>
        <source>Built-in: shapes</source>
        <translation>Intégrés&#xa0;: formes</translation>
    </message>
    <message>
        <source>Built-in: stiffness</source>
        <translation>Intégrés&#xa0;: raideur</translation>
    </message>
    <message>
        <source>Mine</source>
        <translation>Les miens</translation>
    </message>
    <message>
        <source>none yet: edit a built-in one</source>
        <translation>aucun encore&#xa0;: modifiez un motif intégré</translation>
    </message>
    <message>
        <source>damaged</source>
        <translation>endommagé</translation>
    </message>
    <message>
        <source>Tags: %1</source>
        <translation>Étiquettes&#xa0;: %1</translation>
    </message>
    <message>
        <source>&amp;Open</source>
        <translation>&amp;Ouvrir</translation>
    </message>
    <message>
        <source>&amp;Compare with it</source>
        <translation>&amp;Comparer à celui-ci</translation>
    </message>
    <message>
        <source>&amp;Duplicate</source>
        <translation>&amp;Dupliquer</translation>
    </message>
    <message>
        <source>&amp;Rename</source>
        <translation>&amp;Renommer</translation>
    </message>
    <message>
        <source>De&amp;lete</source>
        <translation>&amp;Supprimer</translation>
    </message>
    <message>
        <source>Open in the editor</source>
        <translation>Ouvert dans l’éditeur</translation>
    </message>
    <message>
        <source>Undo the last change to the library (Ctrl+Z in the list)</source>
        <translation>Annuler la dernière action sur la bibliothèque (Ctrl+Z dans la liste)</translation>
    </message>
    <message>
        <source>&lt;p&gt;A click or &lt;b&gt;Enter&lt;/b&gt; opens a pattern. Built-in patterns cannot be changed: the first edit creates a copy. Your own patterns: &lt;b&gt;F2&lt;/b&gt; renames, &lt;b&gt;Ctrl+D&lt;/b&gt; duplicates, &lt;b&gt;Delete&lt;/b&gt; deletes, &lt;b&gt;Ctrl+Z&lt;/b&gt; undoes that.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Un clic ou &lt;b&gt;Entrée&lt;/b&gt; ouvre un motif. Les motifs intégrés restent tels quels&#xa0;: la première modification en fait une copie. Parmi les vôtres&#xa0;: &lt;b&gt;F2&lt;/b&gt; renomme, &lt;b&gt;Ctrl+D&lt;/b&gt; duplique, &lt;b&gt;Suppr&lt;/b&gt; supprime, &lt;b&gt;Ctrl+Z&lt;/b&gt; annule cela.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>&lt;p&gt;The pattern in bold, with a bar in front of it, is open in the editor; keys act on the highlighted one.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Le motif en gras, précédé d’une barre, est ouvert dans l’éditeur&#xa0;; les touches agissent sur celui qui est en surbrillance.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Filter: name, tag (Ctrl+F)</source>
        <translation>Filtrer&#xa0;: nom, étiquette (Ctrl+F)</translation>
    </message>
</context>
<context>
    <name>teleta::pattern::StrokePad</name>
    <message>
        <source>Unrolled forearm</source>
        <translation>Avant-bras déroulé</translation>
    </message>
    <message>
        <source>Draw a stroke: it is felt as a point that moves along it</source>
        <translation>Dessiner un tracé&#xa0;: il est senti comme un point qui le parcourt</translation>
    </message>
    <message>
        <source>Draw a stroke here</source>
        <translation>Dessinez un tracé ici</translation>
    </message>
    <message>
        <source>&lt;p&gt;The unrolled forearm: from left to right once around it. Draw with the mouse to add a stroke that starts at the playhead and moves as fast as you draw. &lt;b&gt;Esc&lt;/b&gt; cancels it.&lt;/p&gt;&lt;p&gt;With keys: the arrows move a cursor, &lt;b&gt;Space&lt;/b&gt; adds a point a quarter of a second after the last one, &lt;b&gt;Backspace&lt;/b&gt; removes it, &lt;b&gt;Enter&lt;/b&gt; finishes.&lt;/p&gt;</source>
        <translation>&lt;p&gt;L’avant-bras, déroulé&#xa0;: de gauche à droite, un tour complet. Ce qui est dessiné ici avec la souris devient un tracé du motif, à partir de la tête de lecture, aussi vite qu’il a été dessiné. &lt;b&gt;Esc&lt;/b&gt; l’abandonne.&lt;/p&gt;&lt;p&gt;Au clavier&#xa0;: les flèches déplacent un curseur, &lt;b&gt;Espace&lt;/b&gt; pose un point un quart de seconde après le dernier, &lt;b&gt;Retour arrière&lt;/b&gt; le retire, &lt;b&gt;Entrée&lt;/b&gt; termine.&lt;/p&gt;</translation>
    </message>
</context>
<context>
    <name>teleta::pattern::TimelineView</name>
    <message>
        <source>Time in s; intensity in %</source>
        <translation>Temps en s&#xa0;; intensité en&#xa0;%</translation>
    </message>
    <message>
        <source>Timeline of the pattern</source>
        <translation>Chronologie du motif</translation>
    </message>
    <message>
        <source>Visible time</source>
        <translation>Temps visible</translation>
    </message>
    <message>
        <source>pattern</source>
        <translation>motif</translation>
    </message>
    <message>
        <source>&amp;Type numbers…</source>
        <translation>&amp;Saisir des nombres…</translation>
    </message>
    <message>
        <source>Add &amp;breakpoint here</source>
        <translation>Ajouter un &amp;nœud ici</translation>
    </message>
    <message>
        <source>&amp;Zoom to fit</source>
        <translation>&amp;Zoom ajusté</translation>
    </message>
    <message>
        <source>Clear &amp;loop</source>
        <translation>Effacer la &amp;boucle</translation>
    </message>
    <message>
        <source>&lt;p&gt;Six motors over time. The blue line is the commanded intensity of a motor, the thin one its predicted response; hatching shows where the motor cannot follow.&lt;/p&gt;&lt;p&gt;Double-click or &lt;b&gt;P&lt;/b&gt;: add breakpoints. Drag: move, with &lt;b&gt;Alt&lt;/b&gt; without the grid. Drag on the background, or with &lt;b&gt;Shift&lt;/b&gt;: select. Double-click on a breakpoint or &lt;b&gt;Enter&lt;/b&gt;: type its numbers. Arrow keys: move what is selected, with &lt;b&gt;Shift&lt;/b&gt; farther in time and finer in intensity. &lt;b&gt;Page Up&lt;/b&gt;, &lt;b&gt;Page Down&lt;/b&gt;: lane; &lt;b&gt;,&lt;/b&gt; and &lt;b&gt;.&lt;/b&gt;: breakpoint, with &lt;b&gt;Shift&lt;/b&gt; one more; &lt;b&gt;N&lt;/b&gt;: object; &lt;b&gt;Insert&lt;/b&gt;: a breakpoint at the playhead; &lt;b&gt;[&lt;/b&gt; and &lt;b&gt;]&lt;/b&gt;: begin and end of the loop, &lt;b&gt;\&lt;/b&gt;: none.&lt;/p&gt;&lt;p&gt;&lt;b&gt;Ctrl&lt;/b&gt; and wheel: zoom. &lt;b&gt;Shift&lt;/b&gt; and wheel: scroll. On the ruler a drag moves the playhead and, with &lt;b&gt;Shift&lt;/b&gt;, sets the loop.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Six moteurs au cours du temps. La ligne bleue est ce qui est demandé à un moteur, la ligne fine ce que le moteur devrait faire selon la prédiction&#xa0;; elle est hachurée là où le moteur ne peut pas suivre.&lt;/p&gt;&lt;p&gt;Double clic ou &lt;b&gt;P&lt;/b&gt;&#xa0;: ajouter des nœuds. Glisser&#xa0;: déplacer, avec &lt;b&gt;Alt&lt;/b&gt; hors de la grille. Glisser sur le fond, ou avec &lt;b&gt;Shift&lt;/b&gt;&#xa0;: sélectionner. Double clic sur un nœud ou &lt;b&gt;Entrée&lt;/b&gt;&#xa0;: saisir ses nombres. Touches fléchées&#xa0;: déplacer la sélection, avec &lt;b&gt;Shift&lt;/b&gt; plus loin en temps et plus finement en intensité. &lt;b&gt;Page préc.&lt;/b&gt;, &lt;b&gt;Page suiv.&lt;/b&gt;&#xa0;: piste&#xa0;; &lt;b&gt;,&lt;/b&gt; et &lt;b&gt;.&lt;/b&gt;&#xa0;: nœud, avec &lt;b&gt;Shift&lt;/b&gt; un de plus&#xa0;; &lt;b&gt;N&lt;/b&gt;&#xa0;: objet&#xa0;; &lt;b&gt;Inser&lt;/b&gt;&#xa0;: un nœud à la tête de lecture&#xa0;; &lt;b&gt;[&lt;/b&gt; et &lt;b&gt;]&lt;/b&gt;&#xa0;: début et fin de la boucle, &lt;b&gt;\&lt;/b&gt;&#xa0;: aucune.&lt;/p&gt;&lt;p&gt;&lt;b&gt;Ctrl&lt;/b&gt; et molette&#xa0;: zoomer. &lt;b&gt;Shift&lt;/b&gt; et molette&#xa0;: défiler. Sur la règle, glisser déplace la tête de lecture et, avec &lt;b&gt;Shift&lt;/b&gt;, définit la boucle.&lt;/p&gt;</translation>
    </message>
</context>
<context>
    <name>teleta::servo::ForceStrip</name>
    <message>
        <source>Force over time</source>
        <translation>Force au cours du temps</translation>
    </message>
    <message>
        <source>actual</source>
        <translation>réelle</translation>
    </message>
    <message>
        <source>desired</source>
        <translation>désirée</translation>
    </message>
    <message>
        <source>Measured force (line) and desired force (dashes) over the last 20 s</source>
        <translation>Force lue par la matrice (trait) et force voulue (tirets), sur les 20 dernières secondes</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Force</translation>
    </message>
</context>
<context>
    <name>teleta::servo::ServoPanel</name>
    <message>
        <source>No servo</source>
        <translation>Pas d’asservissement</translation>
    </message>
    <message>
        <source>STOP: the arm is held</source>
        <translation>STOP&#xa0;: le bras est maintenu</translation>
    </message>
    <message>
        <source>No limit acts.</source>
        <translation>Aucune limite n’agit.</translation>
    </message>
    <message>
        <source>Limits that act: %1</source>
        <translation>Limites qui agissent&#xa0;: %1</translation>
    </message>
    <message>
        <source>%1. %2</source>
        <comment>number and name of a task</comment>
        <translation>%1. %2</translation>
    </message>
    <message>
        <source>&amp;Task</source>
        <translation>&amp;Tâche</translation>
    </message>
    <message>
        <source>&amp;Force</source>
        <translation>&amp;Force</translation>
    </message>
    <message>
        <source>Force with which the array presses</source>
        <translation>Force avec laquelle la matrice appuie</translation>
    </message>
    <message>
        <source>&amp;Sliding speed</source>
        <translation>&amp;Vitesse de glissement</translation>
    </message>
    <message>
        <source>Along the edge, while it is explored</source>
        <translation>Le long de l’arête, pendant son exploration</translation>
    </message>
    <message>
        <source>&amp;Gains</source>
        <translation>&amp;Gains</translation>
    </message>
    <message>
        <source>Balance the &amp;moment (DZMP)</source>
        <translation>Équilibrer le &amp;moment (DZMP)</translation>
    </message>
    <message>
        <source>Off: the controller without the distance to the zero-moment point</source>
        <translation>Désactivé&#xa0;: le régulateur sans la distance au point de moment nul</translation>
    </message>
    <message>
        <source>The scene is held</source>
        <translation>La scène est maintenue</translation>
    </message>
    <message>
        <source>The running task; choose one to start it now</source>
        <translation>La tâche en cours&#xa0;; choisissez-en une pour la commencer maintenant</translation>
    </message>
    <message>
        <source>All controller gains, in percent of those in the scene</source>
        <translation>Tous les gains des régulateurs, en pour cent de ceux de la scène</translation>
    </message>
    <message>
        <source>So far: %1</source>
        <translation>Jusqu’ici&#xa0;: %1</translation>
    </message>
    <message>
        <source>Last run: %1</source>
        <translation>Dernière exécution&#xa0;: %1</translation>
    </message>
    <message>
        <source>force %1</source>
        <comment>as planned</comment>
        <translation>force&#xa0;%1</translation>
    </message>
    <message>
        <source>sliding speed %1</source>
        <comment>as planned</comment>
        <translation>vitesse de glissement&#xa0;%1</translation>
    </message>
    <message>
        <source>gains %1</source>
        <comment>as planned</comment>
        <translation>gains&#xa0;%1</translation>
    </message>
    <message>
        <source>moment balanced</source>
        <translation>moment équilibré</translation>
    </message>
    <message>
        <source>moment not balanced</source>
        <translation>moment non équilibré</translation>
    </message>
    <message>
        <source>Changed from the scene, and kept after a restart. The scene has: %1.</source>
        <translation>Modifié, aussi après un redémarrage. La scène a&#xa0;:&#xa0;%1.</translation>
    </message>
    <message>
        <source>Reset to the scene</source>
        <translation>Réglages de la scène</translation>
    </message>
    <message>
        <source>Set force, speed, gains and moment back to the values of the scene</source>
        <translation>Annuler toutes les modifications de force, de vitesse, de gains et de moment</translation>
    </message>
    <message>
        <source>Matrices</source>
        <translation>Matrices</translation>
    </message>
</context>
<context>
    <name>teleta::servo::ServoPicture</name>
    <message>
        <source>Features and matrices of the servo</source>
        <translation>Caractéristiques et matrices de l’asservissement</translation>
    </message>
    <message>
        <source>Desired and actual features as the inverse tactile Jacobian selects them; bold rows act on the motion through the projection matrix P.</source>
        <translation>Caractéristiques désirées et réelles telles que les sélectionne la jacobienne tactile inverse&#xa0;; les lignes en gras agissent sur le mouvement par la matrice de projection P.</translation>
    </message>
    <message>
        <source>Feature</source>
        <translation>Caractéristique</translation>
    </message>
    <message>
        <source>Desired</source>
        <translation>Désirée</translation>
    </message>
    <message>
        <source>Actual</source>
        <translation>Réelle</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Erreur</translation>
    </message>
    <message>
        <source>J⁻¹, features</source>
        <translation>J⁻¹, caractéristiques</translation>
    </message>
    <message>
        <source>P, motions</source>
        <translation>P, mouvements</translation>
    </message>
</context>
<context>
    <name>teleta::servo::ServoRunsView</name>
    <message>
        <source>&amp;Picture</source>
        <translation>&amp;Image</translation>
    </message>
    <message>
        <source>Copies or saves the chart or its data</source>
        <translation>Copie ou enregistre le graphique ou ses données</translation>
    </message>
    <message>
        <source>Servo runs</source>
        <translation>Exécutions d’asservissement</translation>
    </message>
    <message>
        <source>Servo runs (servo.csv)</source>
        <translation>Exécutions d’asservissement (servo.csv)</translation>
    </message>
    <message>
        <source>Comma-separated values (*.csv)</source>
        <translation>Valeurs séparées par des virgules (*.csv)</translation>
    </message>
    <message>
        <source>servo-runs</source>
        <comment>name of a file</comment>
        <translation>exécutions-asservissement</translation>
    </message>
    <message>
        <source>&amp;Add recorded run…</source>
        <translation>&amp;Ajouter une exécution enregistrée…</translation>
    </message>
    <message>
        <source>&amp;Forget other runs</source>
        <translation>&amp;Oublier les autres exécutions</translation>
    </message>
    <message>
        <source>Add recorded run</source>
        <translation>Ajouter une exécution enregistrée</translation>
    </message>
    <message>
        <source>A run written by teleta simulate --out: its servo.csv</source>
        <translation>Une exécution écrite par teleta simulate --out&#xa0;: son servo.csv</translation>
    </message>
    <message>
        <source>Keeps only the current run</source>
        <translation>Ne garde que l’exécution en cours</translation>
    </message>
    <message>
        <source>&lt;p&gt;Servo runs in one chart: the current one, earlier ones from before a restart or a change of the source, and recorded ones.&lt;/p&gt;&lt;p&gt;To see the effect of the moment, restart the scene with and without “Balance the moment”.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Exécutions d’asservissement dans un seul graphique&#xa0;: celle en cours, celles d’avant que sa source ait été relancée ou qu’une autre source ait été affichée, et des exécutions enregistrées.&lt;/p&gt;&lt;p&gt;Pour voir à quoi sert le moment, relancez la scène avec et sans «&#xa0;Équilibrer le moment&#xa0;».&lt;/p&gt;</translation>
    </message>
    <message>
        <source>No runs yet. Servo runs are drawn here on top of each other.</source>
        <translation>Pas encore d’exécution. Les exécutions d’asservissements sont tracées ici, l’une sur l’autre.</translation>
    </message>
</context>
<context>
    <name>teleta::signal::SignalPlot</name>
    <message>
        <source>units</source>
        <translation>unités</translation>
    </message>
    <message>
        <source>power density ((%1)²/Hz)</source>
        <translation>densité de puissance ((%1)²/Hz)</translation>
    </message>
    <message>
        <source>amplitude</source>
        <translation>amplitude</translation>
    </message>
    <message>
        <source>amplitude (%1)</source>
        <translation>amplitude (%1)</translation>
    </message>
    <message>
        <source>Signals over time</source>
        <translation>Signaux au cours du temps</translation>
    </message>
    <message>
        <source>plot</source>
        <comment>name of a file</comment>
        <translation>trace</translation>
    </message>
    <message>
        <source>frequency</source>
        <translation>fréquence</translation>
    </message>
    <message>
        <source>time</source>
        <translation>temps</translation>
    </message>
</context>
<context>
    <name>teleta::signal::SignalTable</name>
    <message>
        <source>Plotted signals with their values</source>
        <translation>Signaux tracés avec leurs valeurs</translation>
    </message>
    <message>
        <source>Add its &amp;derivative</source>
        <translation>Ajouter sa &amp;dérivée</translation>
    </message>
    <message>
        <source>Show its &amp;spectrum</source>
        <translation>Montrer son &amp;spectre</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>&amp;Retirer</translation>
    </message>
    <message>
        <source>Plotted signal</source>
        <translation>Signal tracé</translation>
    </message>
    <message>
        <source>at A</source>
        <translation>en A</translation>
    </message>
    <message>
        <source>Newest</source>
        <translation>Le plus récent</translation>
    </message>
    <message>
        <source>at B</source>
        <translation>en B</translation>
    </message>
    <message>
        <source>B − A</source>
        <comment>difference of two values</comment>
        <translation>B − A</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Unité</translation>
    </message>
    <message>
        <source>B − A: %1, 1/(B − A): %2</source>
        <translation>B − A&#xa0;: %1, 1/(B − A)&#xa0;: %2</translation>
    </message>
</context>
<context>
    <name>teleta::signal::SignalTree</name>
    <message>
        <source>Search signals</source>
        <translation>Chercher des signaux</translation>
    </message>
    <message>
        <source>Signals of all sources</source>
        <translation>Signaux de toutes les sources</translation>
    </message>
    <message>
        <source>Signal</source>
        <translation>Signal</translation>
    </message>
    <message>
        <source>Newest value</source>
        <translation>Dernière valeur</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <comment>signal, unit</comment>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Search signals (Ctrl+F)</source>
        <translation>Rechercher des signaux (Ctrl+F)</translation>
    </message>
</context>
<context>
    <name>teleta::site_view::SiteBar</name>
    <message>
        <source>%1 does not answer (%2 s)</source>
        <translation>%1 ne répond pas (%2 s)</translation>
    </message>
    <message>
        <source>%1: STOP is held by %2</source>
        <translation>%1 : STOP maintenu par %2</translation>
    </message>
    <message>
        <source>%1: %2 offers you control</source>
        <translation>%1 : %2 vous propose la commande</translation>
    </message>
    <message>
        <source>%1: handing control to %2</source>
        <translation>%1 : transfert de la commande à %2</translation>
    </message>
    <message>
        <source>%1: an arm has a fault</source>
        <translation>%1 : un bras est en défaut</translation>
    </message>
    <message>
        <source>%1: you are moving it</source>
        <translation>%1 : vous le déplacez</translation>
    </message>
    <message>
        <source>%1: you control</source>
        <translation>%1 : vous commandez</translation>
    </message>
    <message>
        <source>%1: %2 controls</source>
        <translation>%1 : %2 commande</translation>
    </message>
    <message>
        <source>%1: viewing</source>
        <translation>%1 : observation</translation>
    </message>
    <message>
        <source>%1: nobody controls</source>
        <translation>%1 : personne ne commande</translation>
    </message>
    <message>
        <source>loop %1 ms</source>
        <translation>boucle %1 ms</translation>
    </message>
    <message>
        <source>clock ±%1 ms</source>
        <translation>horloge ±%1 ms</translation>
    </message>
    <message>
        <source>%1 refused: %2</source>
        <translation>%1 refusées : %2</translation>
    </message>
    <message numerus="yes">
        <source>%n state(s) of the site were lost on the way</source>
        <translation>
            <numerusform>%n état du site perdu en route</numerusform>
            <numerusform>%n états du site perdus en route</numerusform>
        </translation>
    </message>
    <message>
        <source>Control lease: how long control stays here without an answer</source>
        <translation>Bail de commande : combien de temps la commande reste ici sans réponse</translation>
    </message>
    <message>
        <source>Request control</source>
        <translation>Demander la commande</translation>
    </message>
    <message>
        <source>Accept control</source>
        <translation>Accepter la commande</translation>
    </message>
    <message>
        <source>Agree</source>
        <translation>Accepter</translation>
    </message>
    <message>
        <source>Decline</source>
        <translation>Refuser</translation>
    </message>
    <message>
        <source>Keep control</source>
        <translation>Garder la commande</translation>
    </message>
    <message>
        <source>Take over…</source>
        <translation>Reprendre…</translation>
    </message>
    <message>
        <source>For supervisors: the other console has 5 s to decline</source>
        <translation>Pour les superviseurs : l’autre console a 5 s pour refuser</translation>
    </message>
    <message>
        <source>Clear the fault</source>
        <translation>Effacer le défaut</translation>
    </message>
    <message>
        <source>Hand over</source>
        <translation>Transmettre</translation>
    </message>
    <message>
        <source>Withdraw STOP</source>
        <translation>Lever STOP</translation>
    </message>
    <message>
        <source>For supervisors, once the console that engaged STOP is gone</source>
        <translation>Pour les superviseurs, quand la console qui a engagé STOP a disparu</translation>
    </message>
    <message>
        <source>Release control</source>
        <translation>Rendre la commande</translation>
    </message>
</context>
<context>
    <name>teleta::study::AnswerButton</name>
    <message>
        <source>Answer %1: %2</source>
        <comment>letter, name</comment>
        <translation>Réponse %1&#xa0;: %2</translation>
    </message>
    <message>
        <source>%1. This was felt.</source>
        <translation>%1. C’est ce qui a été senti.</translation>
    </message>
    <message>
        <source>%1. This was answered.</source>
        <translation>%1. C’est ce qui a été répondu.</translation>
    </message>
    <message>
        <source>✓ felt</source>
        <translation>✓ senti</translation>
    </message>
    <message>
        <source>✗ your answer</source>
        <translation>✗ votre réponse</translation>
    </message>
    <message>
        <source>your answer</source>
        <translation>votre réponse</translation>
    </message>
    <message>
        <source>Answer: %1</source>
        <comment>yes, no, a number ..</comment>
        <translation>Réponse&#xa0;: %1</translation>
    </message>
    <message>
        <source>%1. This was right.</source>
        <translation>%1. C’était juste.</translation>
    </message>
    <message>
        <source>✓ right</source>
        <translation>✓ juste</translation>
    </message>
</context>
<context>
    <name>teleta::study::BraceletView</name>
    <message>
        <source>All participants, mean</source>
        <translation>Tous les participants, moyenne</translation>
    </message>
    <message>
        <source>Connect the bracelet with which the study was run: the balance needs its motors.</source>
        <translation>Connectez le bracelet avec lequel l’étude a été menée&#xa0;: l’équilibrage a besoin de ses moteurs.</translation>
    </message>
    <message>
        <source>The balance takes the motors of %1 as they are now. They must be the ones that the study was run with.</source>
        <translation>L’équilibrage prend les moteurs de %1 tels qu’ils sont. Ce doivent être ceux avec lesquels l’étude a été menée.</translation>
    </message>
    <message>
        <source>There is no balance: %1.</source>
        <translation>Il n’y a pas d’équilibrage&#xa0;:&#xa0;%1.</translation>
    </message>
    <message>
        <source>Best time from burst to burst</source>
        <translation>Meilleur intervalle entre salves</translation>
    </message>
    <message>
        <source>Intensities that can be told apart</source>
        <translation>Intensités que l’on peut distinguer</translation>
    </message>
    <message>
        <source>Equally strong tactors</source>
        <translation>Tacteurs aussi forts</translation>
    </message>
    <message>
        <source>As felt b&amp;y</source>
        <translation>Ressenti &amp;par</translation>
    </message>
    <message>
        <source>&amp;Use for this bracelet…</source>
        <translation>&amp;Utiliser pour ce bracelet…</translation>
    </message>
    <message>
        <source>Sets the full drives of the connected bracelet, after a question</source>
        <translation>Règle les pleines commandes du bracelet connecté, après une question</translation>
    </message>
    <message>
        <source>The participants are simulated: nobody felt this, so it cannot be used for a real bracelet.</source>
        <translation>Les participants sont simulés&#xa0;: personne n’a ressenti cela, qui ne peut donc pas servir à un vrai bracelet.</translation>
    </message>
</context>
<context>
    <name>teleta::study::ComparisonsView</name>
    <message>
        <source>Pairs of levels</source>
        <translation>Paires de niveaux</translation>
    </message>
    <message>
        <source>Paired t tests. p Holm is corrected over all pairs of an effect; intervals are not corrected.</source>
        <translation>Tests t appariés. p Holm est corrigé sur toutes les paires d’un effet&#xa0;; les intervalles ne sont pas corrigés.</translation>
    </message>
    <message>
        <source>Effect sizes, and effects by ranks</source>
        <translation>Tailles d’effet, et effets par les rangs</translation>
    </message>
    <message>
        <source>The same pairs by ranks</source>
        <translation>Les mêmes paires par les rangs</translation>
    </message>
    <message>
        <source>Model of single answers</source>
        <translation>Modèle des réponses individuelles</translation>
    </message>
    <message>
        <source>Response times of the conditions</source>
        <translation>Temps de réponse des conditions</translation>
    </message>
    <message>
        <source>Exclusions</source>
        <translation>Exclusions</translation>
    </message>
    <message>
        <source>Nothing was deleted: the trials are in the study and in its exports, with the rule that left them out.</source>
        <translation>Rien n’a été supprimé&#xa0;: les essais sont dans l’étude et dans ses exports, avec la règle qui les a écartés.</translation>
    </message>
    <message>
        <source>With the rules, and without them</source>
        <translation>Avec les règles, et sans elles</translation>
    </message>
</context>
<context>
    <name>teleta::study::ConfusionView</name>
    <message>
        <source>Confusion matrix</source>
        <translation>Matrice de confusion</translation>
    </message>
    <message>
        <source>%1 of %2 right</source>
        <translation>%1 correctes sur %2</translation>
    </message>
    <message>
        <source>No trials yet</source>
        <translation>Pas encore d’essais</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <comment>count of a row</comment>
        <translation>%1 sur %2</translation>
    </message>
    <message>
        <source>%1 not answered in time: </source>
        <comment>pattern</comment>
        <translation>%1 sans réponse à temps&#xa0;: </translation>
    </message>
    <message>
        <source>%1 answered as %2: </source>
        <comment>pattern, pattern</comment>
        <translation>%1 répondu comme %2&#xa0;: </translation>
    </message>
    <message>
        <source>In &amp;percent</source>
        <translation>En &amp;pour cent</translation>
    </message>
    <message>
        <source>&lt;p&gt;Rows: what was presented. Columns: what was answered, and NONE for no answer in time. &lt;b&gt;Space&lt;/b&gt; or a double click switches between counts and percent of the row.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Lignes&#xa0;: ce qui a été présenté. Colonnes&#xa0;: ce qui a été répondu, et NONE pour l’absence de réponse à temps. &lt;b&gt;Espace&lt;/b&gt; ou un double clic alterne entre effectifs et pourcentage de la ligne.&lt;/p&gt;</translation>
    </message>
</context>
<context>
    <name>teleta::study::ParticipantPicker</name>
    <message numerus="yes">
        <source>%n participant(s)</source>
        <translation>
            <numerusform>%n participant</numerusform>
            <numerusform>%n participants</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>teleta::study::ParticipantWindow</name>
    <message>
        <source>Please wait for the experimenter.</source>
        <translation>Veuillez attendre l’expérimentateur.</translation>
    </message>
    <message>
        <source>Press Space for the next trial.</source>
        <translation>Appuyez sur Espace pour l’essai suivant.</translation>
    </message>
    <message>
        <source>Press Space for the first trial.</source>
        <translation>Appuyez sur Espace pour le premier essai.</translation>
    </message>
    <message>
        <source>Wait …</source>
        <translation>Attendez …</translation>
    </message>
    <message>
        <source>Feel …</source>
        <translation>Sentez …</translation>
    </message>
    <message>
        <source>Which pattern do you feel? Press R to feel it again.</source>
        <translation>Quel motif sentez-vous&#xa0;? Appuyez sur R pour le sentir à nouveau.</translation>
    </message>
    <message>
        <source>Which pattern do you feel?</source>
        <translation>Quel motif sentez-vous&#xa0;?</translation>
    </message>
    <message>
        <source>Pause. Please wait for the experimenter.</source>
        <translation>Pause. Veuillez attendre l’expérimentateur.</translation>
    </message>
    <message>
        <source>Stopped. The bracelet is off. Please wait for the experimenter.</source>
        <translation>Arrêté. Le bracelet est éteint. Veuillez attendre l’expérimentateur.</translation>
    </message>
    <message>
        <source>This part is finished. Thank you!</source>
        <translation>Cette partie est terminée. Merci&#xa0;!</translation>
    </message>
    <message>
        <source>Participant</source>
        <translation>Participant</translation>
    </message>
    <message>
        <source>Practice</source>
        <translation>Entraînement</translation>
    </message>
    <message>
        <source>Test</source>
        <translation>Test</translation>
    </message>
    <message>
        <source>%1 — %2, trial %3 of %4</source>
        <comment>task, phase, numbers</comment>
        <translation>%1 — %2, essai %3 sur %4</translation>
    </message>
    <message>
        <source>There was no answer in time. The marked pattern was the right one. Press Space to continue.</source>
        <translation>Il n’y a pas eu de réponse à temps. Le motif marqué a été présenté. Appuyez sur Espace pour continuer.</translation>
    </message>
    <message>
        <source>Right. Press Space to continue.</source>
        <translation>Juste. Appuyez sur Espace pour continuer.</translation>
    </message>
    <message>
        <source>That was another one: the pattern marked with ✓ was the right one. Press Space to continue.</source>
        <translation>C’en était un autre&#xa0;: le motif marqué d’un ✓ a été présenté. Appuyez sur Espace pour continuer.</translation>
    </message>
    <message>
        <source>Take a break. You can continue in %1 s.</source>
        <translation>Reposez-vous. Vous pourrez continuer dans %1 s.</translation>
    </message>
    <message>
        <source>Take a break. Press Space when you would like to continue.</source>
        <translation>Reposez-vous. Appuyez sur Espace quand vous voulez continuer.</translation>
    </message>
    <message>
        <source>%1 Press R to feel it again.</source>
        <comment>a question</comment>
        <translation>%1 Appuyez sur R pour le sentir à nouveau.</translation>
    </message>
    <message>
        <source>There was no answer in time. The marked answer was the right one. Press Space to continue.</source>
        <translation>Il n’y a pas eu de réponse à temps. La réponse marquée était la bonne. Appuyez sur Espace pour continuer.</translation>
    </message>
    <message>
        <source>The answer marked with ✓ was the right one. Press Space to continue.</source>
        <translation>La réponse marquée d’un ✓ était la bonne. Appuyez sur Espace pour continuer.</translation>
    </message>
</context>
<context>
    <name>teleta::study::PlanPanel</name>
    <message>
        <source>Right answers, %1</source>
        <comment>condition</comment>
        <translation>Réponses correctes, %1</translation>
    </message>
    <message>
        <source>The middle participant has these shares; the spreads are in logits.</source>
        <translation>Le participant médian a ces parts&#xa0;; les dispersions sont en logits.</translation>
    </message>
    <message>
        <source>Assumed: what %1 says.</source>
        <translation>Supposé&#xa0;: ce que dit %1.</translation>
    </message>
    <message>
        <source>&amp;Test</source>
        <translation>&amp;Test</translation>
    </message>
    <message>
        <source>Spread of &amp;participants</source>
        <translation>Dispersion entre &amp;participants</translation>
    </message>
    <message>
        <source>Spread under one &amp;condition</source>
        <translation>Dispersion dans une &amp;condition</translation>
    </message>
    <message>
        <source>From a &amp;file…</source>
        <translation>D’un &amp;fichier…</translation>
    </message>
    <message>
        <source>From this st&amp;udy</source>
        <translation>De cette ét&amp;ude</translation>
    </message>
    <message>
        <source>Assumes what the results of this study show; at least 5 participants</source>
        <translation>Suppose ce que montrent les résultats de cette étude&#xa0;; au moins 5 participants</translation>
    </message>
    <message>
        <source>From this f&amp;orm</source>
        <translation>De ce f&amp;ormulaire</translation>
    </message>
    <message>
        <source>Part&amp;icipants</source>
        <translation>Part&amp;icipants</translation>
    </message>
    <message>
        <source>from </source>
        <comment>number of participants</comment>
        <translation>de </translation>
    </message>
    <message>
        <source>to </source>
        <comment>number of participants</comment>
        <translation>à </translation>
    </message>
    <message>
        <source>step </source>
        <comment>of the number of participants</comment>
        <translation>pas de </translation>
    </message>
    <message>
        <source>Target po&amp;wer</source>
        <translation>Puissance &amp;visée</translation>
    </message>
    <message>
        <source>&amp;Studies drawn</source>
        <translation>Étude&amp;s tirées</translation>
    </message>
    <message>
        <source>P&amp;lan</source>
        <translation>P&amp;lanifier</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Power over the number of participants</source>
        <translation>Puissance selon le nombre de participants</translation>
    </message>
    <message>
        <source>The power over the number of participants will be shown here.
Enter what you assume on the left, and choose Plan.</source>
        <translation>La puissance selon le nombre de participants sera affichée ici.
Saisissez vos hypothèses à gauche, puis choisissez Planifier.</translation>
    </message>
    <message>
        <source>There is nothing to plan.</source>
        <translation>Il n’y a rien à planifier.</translation>
    </message>
    <message>
        <source>The middle participant has this threshold.</source>
        <translation>Le participant médian a ce seuil.</translation>
    </message>
    <message>
        <source>The protocol has no task to plan for.</source>
        <translation>Le protocole n’a pas de tâche à planifier.</translation>
    </message>
    <message>
        <source>A TOML file with shares of right answers or thresholds, and spreads</source>
        <translation>Un fichier TOML avec des parts de bonnes réponses ou des seuils, et des dispersions</translation>
    </message>
    <message>
        <source>Targ&amp;et</source>
        <translation>Cibl&amp;e</translation>
    </message>
    <message>
        <source>The share of studies with an interval narrow enough will be shown here.
Enter what you assume on the left, and choose Plan.</source>
        <translation>La part des études à l’intervalle assez étroit sera affichée ici.
Saisissez vos hypothèses à gauche, puis choisissez Planifier.</translation>
    </message>
</context>
<context>
    <name>teleta::study::QuestionnaireForm</name>
    <message>
        <source>Please answer this question.</source>
        <translation>Veuillez répondre à cette question.</translation>
    </message>
    <message>
        <source>%1 of %2 answered</source>
        <translation>%1 réponses sur %2</translation>
    </message>
    <message>
        <source>&amp;Done</source>
        <translation>&amp;Terminer</translation>
    </message>
    <message>
        <source>This answer is not valid: %1.</source>
        <comment>what is expected</comment>
        <translation>Cela ne convient pas&#xa0;: %1.</translation>
    </message>
    <message>
        <source>Submits the answers (Ctrl+Return)</source>
        <translation>Remet les réponses (Ctrl+Entrée)</translation>
    </message>
</context>
<context>
    <name>teleta::study::QuestionnaireItemView</name>
    <message>
        <source>No answer</source>
        <translation>Pas de réponse</translation>
    </message>
    <message>
        <source>%1: %2 of %3</source>
        <comment>question, point, points</comment>
        <translation>%1&#xa0;: %2 sur %3</translation>
    </message>
    <message>
        <source>%1 (optional)</source>
        <comment>a question</comment>
        <translation>%1 (facultatif)</translation>
    </message>
</context>
<context>
    <name>teleta::study::ResultsView</name>
    <message>
        <source>All participants</source>
        <translation>Tous les participants</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <comment>condition, participant</comment>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>Task</source>
        <translation>Tâche</translation>
    </message>
    <message>
        <source>Tick one participant, or a group</source>
        <translation>Cochez un participant, ou un groupe</translation>
    </message>
    <message>
        <source>What the matrices show</source>
        <translation>Ce que montrent les matrices</translation>
    </message>
    <message>
        <source>Counts</source>
        <translation>Effectifs</translation>
    </message>
    <message>
        <source>Percent of the row</source>
        <translation>Pourcentage de la ligne</translation>
    </message>
    <message>
        <source>All participants together</source>
        <translation>Tous les participants réunis</translation>
    </message>
    <message>
        <source>Analysis of variance</source>
        <translation>Analyse de variance</translation>
    </message>
    <message>
        <source>Each participant</source>
        <translation>Chaque participant</translation>
    </message>
    <message>
        <source>&amp;Export</source>
        <translation>&amp;Exporter</translation>
    </message>
    <message>
        <source>Writes the trials, or these results, into the folder of the study</source>
        <translation>Écrit les essais, ou ces résultats, dans le dossier de l’étude</translation>
    </message>
    <message>
        <source>Trials as &amp;Psych-DS (CSV)</source>
        <translation>Essais en &amp;Psych-DS (CSV)</translation>
    </message>
    <message>
        <source>Trials as &amp;BIDS (TSV)</source>
        <translation>Essais en &amp;BIDS (TSV)</translation>
    </message>
    <message>
        <source>Trials for a &amp;spreadsheet</source>
        <translation>Essais pour &amp;tableur</translation>
    </message>
    <message>
        <source>&amp;Results: tables, figures, R script</source>
        <translation>&amp;Résultats&#xa0;: tableaux, figures, script R</translation>
    </message>
    <message>
        <source>No comparison</source>
        <translation>Personne à côté</translation>
    </message>
    <message>
        <source>Participants shown</source>
        <translation>Participants affichés</translation>
    </message>
    <message>
        <source>Participants for comparison</source>
        <translation>Participants à côté</translation>
    </message>
    <message>
        <source>Tick the participants to compare with: a second group, side by side</source>
        <translation>Cochez ceux à qui comparer&#xa0;: un second groupe côte à côte</translation>
    </message>
    <message>
        <source>Comparisons</source>
        <translation>Comparaisons</translation>
    </message>
    <message>
        <source>Answers</source>
        <translation>Réponses</translation>
    </message>
    <message>
        <source>Thresholds</source>
        <translation>Seuils</translation>
    </message>
    <message>
        <source>Tracks</source>
        <translation>Séries</translation>
    </message>
    <message>
        <source>d&apos; and c</source>
        <translation>d&apos; et c</translation>
    </message>
    <message>
        <source>Whose threshold is shown</source>
        <translation>De qui le seuil est affiché</translation>
    </message>
    <message>
        <source>Which track is shown</source>
        <translation>Série affichée</translation>
    </message>
    <message>
        <source>Which condition is shown</source>
        <translation>Condition affichée</translation>
    </message>
    <message>
        <source>Bracelet</source>
        <translation>Bracelet</translation>
    </message>
</context>
<context>
    <name>teleta::study::SessionPanel</name>
    <message>
        <source>Stop the noise</source>
        <translation>Arrêter le bruit</translation>
    </message>
    <message>
        <source>Play the noise</source>
        <translation>Jouer le bruit</translation>
    </message>
    <message>
        <source>Abort the session?</source>
        <translation>Abandonner la session&#xa0;?</translation>
    </message>
    <message>
        <source>&amp;Abort the session</source>
        <translation>&amp;Abandonner la session</translation>
    </message>
    <message>
        <source>&amp;Go on</source>
        <translation>&amp;Continuer</translation>
    </message>
    <message>
        <source>Next step</source>
        <translation>Étape suivante</translation>
    </message>
    <message>
        <source>What to do next (Ctrl+Return)</source>
        <translation>Ce qu’il faut faire ensuite (Ctrl+Entrée)</translation>
    </message>
    <message>
        <source>Checks before the run</source>
        <translation>Contrôles avant l’exécution</translation>
    </message>
    <message>
        <source>Noise &amp;confirmed</source>
        <translation>Bruit &amp;confirmé</translation>
    </message>
    <message>
        <source>The participant hears the masking noise at the level of the protocol</source>
        <translation>Le participant entend le bruit de masquage au niveau du protocole</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Avancement</translation>
    </message>
    <message>
        <source>Last trials</source>
        <translation>Derniers essais</translation>
    </message>
    <message>
        <source>Trial</source>
        <translation>Essai</translation>
    </message>
    <message>
        <source>Presented</source>
        <translation>Présenté</translation>
    </message>
    <message>
        <source>Answered</source>
        <translation>Répondu</translation>
    </message>
    <message>
        <source>Outcome</source>
        <translation>Résultat</translation>
    </message>
    <message>
        <source>Response time</source>
        <translation>Temps de réponse</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Note</translation>
    </message>
    <message>
        <source>Participant&apos;s &amp;window</source>
        <translation>&amp;Fenêtre du participant</translation>
    </message>
    <message>
        <source>&amp;Pause</source>
        <translation>&amp;Pause</translation>
    </message>
    <message>
        <source>&amp;Abort…</source>
        <translation>&amp;Abandonner…</translation>
    </message>
    <message>
        <source>The session ends here. All answers are saved, and it can be resumed later where it stopped.</source>
        <translation>La session se termine ici. Les réponses données sont conservées, et la session peut être reprise plus tard, là où elle s’est arrêtée.</translation>
    </message>
    <message>
        <source>Skip the questionnaire?</source>
        <translation>Omettre le questionnaire&#xa0;?</translation>
    </message>
    <message>
        <source>What is filled in is lost, and a note says that it was skipped.</source>
        <translation>Ce qui est rempli est perdu, et une note indique qu’il a été omis.</translation>
    </message>
    <message>
        <source>&amp;Skip it</source>
        <translation>&amp;Omettre</translation>
    </message>
    <message>
        <source>&amp;Continue with it</source>
        <translation>&amp;Poursuivre</translation>
    </message>
    <message>
        <source>A note on this session; Return saves it</source>
        <translation>Une note sur cette session&#xa0;; Entrée la conserve</translation>
    </message>
    <message>
        <source>Shows the participant&apos;s window, on the second screen if there is one</source>
        <translation>Affiche la fenêtre du participant, sur le second écran s’il y en a un</translation>
    </message>
    <message>
        <source>S&amp;kip the questionnaire…</source>
        <translation>&amp;Omettre le questionnaire…</translation>
    </message>
    <message>
        <source>Continues without the participant&apos;s answers</source>
        <translation>Continue sans les réponses du participant</translation>
    </message>
    <message>
        <source>Pauses after the current trial</source>
        <translation>Met en pause après l’essai en cours</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>Niveau</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Temps</translation>
    </message>
</context>
<context>
    <name>teleta::study::StudyPanel</name>
    <message>
        <source>● On the server: %1</source>
        <translation>● Sur le serveur&#xa0;: %1</translation>
    </message>
    <message>
        <source>✗ The study cannot be used: %1</source>
        <translation>✗ L’étude ne peut pas être utilisée&#xa0;: %1</translation>
    </message>
    <message>
        <source>%1 of %2 trials</source>
        <comment>kept</comment>
        <translation>%1 essais sur %2</translation>
    </message>
    <message>
        <source>&amp;New…</source>
        <translation>&amp;Nouvelle…</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>&amp;Ouvrir…</translation>
    </message>
    <message>
        <source>Open another study</source>
        <translation>Ouvrir une autre étude</translation>
    </message>
    <message>
        <source>The &amp;folder of a study…</source>
        <translation>Le &amp;dossier d’une étude…</translation>
    </message>
    <message>
        <source>A study on a &amp;server…</source>
        <translation>Une étude sur un &amp;serveur…</translation>
    </message>
    <message>
        <source>Pro&amp;tocol…</source>
        <translation>Pro&amp;tocole…</translation>
    </message>
    <message>
        <source>Participants</source>
        <translation>Participants</translation>
    </message>
    <message>
        <source>Session</source>
        <translation>Session</translation>
    </message>
    <message>
        <source>State</source>
        <translation>État</translation>
    </message>
    <message>
        <source>Participants and their sessions</source>
        <translation>Participants et leurs sessions</translation>
    </message>
    <message>
        <source>Name of a new participant, for example P07</source>
        <translation>Nom d’un nouveau participant, par exemple P07</translation>
    </message>
    <message>
        <source>Name of a new participant</source>
        <translation>Nom d’un nouveau participant</translation>
    </message>
    <message>
        <source>A&amp;dd</source>
        <translation>A&amp;jouter</translation>
    </message>
    <message>
        <source>Enrol this participant</source>
        <translation>Inscrire ce participant</translation>
    </message>
    <message>
        <source>✗ Server unreachable: %1</source>
        <translation>✗ Serveur absent&#xa0;: %1</translation>
    </message>
    <message>
        <source>Create a new study</source>
        <translation>Commencer une nouvelle étude</translation>
    </message>
    <message>
        <source>View the protocol, or make another one from it</source>
        <translation>Consulter le protocole, ou en faire un autre à partir de lui</translation>
    </message>
    <message>
        <source>&amp;Delete the participant…</source>
        <translation>&amp;Supprimer le participant…</translation>
    </message>
</context>
<context>
    <name>teleta::study::ThresholdForm</name>
    <message>
        <source>log10 units</source>
        <translation>unités log10</translation>
    </message>
    <message>
        <source>Spread of &amp;participants</source>
        <translation>Dispersion entre &amp;participants</translation>
    </message>
    <message>
        <source>How far the 95 % interval of the mean threshold may reach to each side</source>
        <translation>Jusqu’où l’intervalle à 95&#xa0;% du seuil moyen peut s’étendre de chaque côté</translation>
    </message>
    <message>
        <source>as in the protocol</source>
        <translation>comme dans le protocole</translation>
    </message>
    <message>
        <source>Of constant stimuli: at each level</source>
        <translation>Des stimuli constants&#xa0;: à chaque niveau</translation>
    </message>
    <message>
        <source>Th&amp;reshold</source>
        <translation>Seui&amp;l</translation>
    </message>
    <message>
        <source>Slope (Wei&amp;bull)</source>
        <translation>Pente (Wei&amp;bull)</translation>
    </message>
    <message>
        <source>Spread of the fu&amp;nction</source>
        <translation>Étalement de la fo&amp;nction</translation>
    </message>
    <message>
        <source>L&amp;apses</source>
        <translation>L&amp;apses</translation>
    </message>
    <message>
        <source>&amp;Yes without a stimulus</source>
        <translation>&amp;Oui sans stimulus</translation>
    </message>
    <message>
        <source>Interval at &amp;most ±</source>
        <translation>Intervalle d’au plus ± (&amp;m)</translation>
    </message>
    <message>
        <source>Trials of a trac&amp;k</source>
        <translation>Essais d’une série (&amp;k)</translation>
    </message>
</context>
<context>
    <name>teleta::tactile::ChannelSettingsPanel</name>
    <message>
        <source>Not tared</source>
        <translation>Non taré</translation>
    </message>
    <message>
        <source>Tared</source>
        <translation>Taré</translation>
    </message>
    <message numerus="yes">
        <source>Tared, %n taxel(s) without a reading</source>
        <translation>
            <numerusform>Taré, %n taxel sans mesure</numerusform>
            <numerusform>Taré, %n taxels sans mesure</numerusform>
        </translation>
    </message>
    <message>
        <source>&amp;Tare now</source>
        <translation>&amp;Tarer maintenant</translation>
    </message>
    <message>
        <source>Takes the mean of the next half second as the unloaded state. Nothing may touch the array.</source>
        <translation>Prend la moyenne de la demi-seconde suivante comme état à vide. Rien ne doit toucher la matrice.</translation>
    </message>
    <message>
        <source>&amp;Clear tare</source>
        <translation>&amp;Effacer la tare</translation>
    </message>
    <message>
        <source>Uses the raw values again</source>
        <translation>Utilise de nouveau les valeurs brutes</translation>
    </message>
    <message>
        <source>&amp;Gain:</source>
        <translation>&amp;Gain&#xa0;:</translation>
    </message>
    <message>
        <source>Load per raw unit</source>
        <translation>Charge par unité brute</translation>
    </message>
    <message>
        <source>Values &amp;fall under load</source>
        <translation>Les &amp;valeurs diminuent sous charge</translation>
    </message>
    <message>
        <source>For arrays whose raw values are highest when nothing touches them</source>
        <translation>Pour les matrices dont les valeurs brutes sont maximales quand rien ne les touche</translation>
    </message>
    <message>
        <source>T&amp;hreshold:</source>
        <translation>&amp;Seuil&#xa0;:</translation>
    </message>
    <message>
        <source>A taxel is in contact from this load on</source>
        <translation>Un taxel est en contact à partir de cette charge</translation>
    </message>
    <message>
        <source>&amp;Automatic threshold</source>
        <translation>Seuil &amp;automatique</translation>
    </message>
    <message>
        <source>Finds the lowest useful threshold in each frame; the value above is its lower bound</source>
        <translation>Trouve le plus petit seuil utile dans chaque trame&#xa0;; la valeur ci-dessus en est la borne inférieure</translation>
    </message>
    <message>
        <source>&amp;Noise height:</source>
        <translation>&amp;Hauteur du bruit&#xa0;:</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>&amp;Smallest contact:</source>
        <translation>Plus &amp;petit contact&#xa0;:</translation>
    </message>
    <message>
        <source>&amp;Orientation:</source>
        <translation>&amp;Orientation&#xa0;:</translation>
    </message>
    <message>
        <source>Which taxels the principal axis is computed from</source>
        <translation>Les taxels à partir desquels l’axe principal est calculé</translation>
    </message>
    <message>
        <source>&amp;Force over:</source>
        <translation>&amp;Force sur&#xa0;:</translation>
    </message>
    <message>
        <source>whole image</source>
        <translation>image entière</translation>
    </message>
    <message>
        <source>active taxels</source>
        <translation>taxels actifs</translation>
    </message>
    <message>
        <source>&amp;Edge above:</source>
        <translation>Arête au-&amp;dessus de&#xa0;:</translation>
    </message>
    <message>
        <source>The contact becomes an edge when the ratio of the eigenvalues rises above this</source>
        <translation>Le contact devient une arête quand le rapport des valeurs propres dépasse cette valeur</translation>
    </message>
    <message>
        <source>&amp;Point below:</source>
        <translation>Po&amp;int au-dessous de&#xa0;:</translation>
    </message>
    <message>
        <source>The contact becomes a point when the ratio of the eigenvalues falls below this</source>
        <translation>Le contact devient un point quand le rapport des valeurs propres passe sous cette valeur</translation>
    </message>
    <message>
        <source>&amp;Defaults</source>
        <translation>Valeurs par défa&amp;ut</translation>
    </message>
    <message>
        <source> %1/raw unit</source>
        <comment>of a gain: load per raw unit</comment>
        <translation> %1/unité brute</translation>
    </message>
    <message>
        <source> taxel</source>
        <translation> taxel</translation>
    </message>
    <message>
        <source> taxels</source>
        <translation> taxels</translation>
    </message>
    <message>
        <source>taxel gains in use</source>
        <translation>gains des taxels utilisés</translation>
    </message>
    <message>
        <source>Two peaks count as one contact when the lower one rises less than this above the saddle between them, in percent of the highest peak of the frame</source>
        <translation>Deux sommets forment un seul contact quand le plus bas s’élève de moins que cela au-dessus du col qui les sépare, en pour cent du pic de la trame</translation>
    </message>
    <message>
        <source>In taxels; smaller contacts are ignored</source>
        <translation>En taxels&#xa0;; les contacts de moins de taxels sont ignorés</translation>
    </message>
    <message>
        <source>active taxels equally</source>
        <translation>taxels actifs, à égalité</translation>
    </message>
    <message>
        <source>weighted by load</source>
        <translation>pondérés par la charge</translation>
    </message>
    <message>
        <source>Whole image: adds up every load. Active taxels: leaves out the noise of unloaded taxels</source>
        <translation>L’image entière compte chaque charge&#xa0;; les taxels actifs écartent le bruit des taxels à vide</translation>
    </message>
    <message>
        <source>Reset everything but the tare and the taxel gains</source>
        <translation>Valeurs par défaut pour tout sauf la tare et les gains des taxels</translation>
    </message>
</context>
<context>
    <name>teleta::tactile::HeatmapView</name>
    <message>
        <source>Tactile heatmap</source>
        <translation>Carte de chaleur tactile</translation>
    </message>
    <message>
        <source>&amp;Contacts</source>
        <translation>&amp;Contacts</translation>
    </message>
    <message>
        <source>Outline each contact and show its number</source>
        <translation>Entourer chaque contact et afficher son numéro</translation>
    </message>
    <message>
        <source>Mark the load-weighted centre with ×</source>
        <translation>Marquer d’un × le centre pondéré par la charge</translation>
    </message>
    <message>
        <source>Mark the centre of the touched area with ○</source>
        <translation>Marquer d’un ○ le centre de la zone touchée</translation>
    </message>
    <message>
        <source>Draw the axis along which the touched area is longest</source>
        <translation>Tracer l’axe le long duquel la zone touchée est la plus longue</translation>
    </message>
    <message>
        <source>&amp;Numbers</source>
        <translation>&amp;Nombres</translation>
    </message>
    <message>
        <source>Write each load into its taxel where there is room</source>
        <translation>Écrire chaque charge dans son taxel si la place suffit</translation>
    </message>
    <message>
        <source>heatmap</source>
        <translation>carte-de-chaleur</translation>
    </message>
    <message>
        <source>&amp;Automatic</source>
        <translation>&amp;Automatique</translation>
    </message>
    <message>
        <source>&amp;Fixed at %1</source>
        <translation>&amp;Fixée à %1</translation>
    </message>
    <message>
        <source>Upper end of the colours</source>
        <translation>Borne supérieure des couleurs</translation>
    </message>
    <message>
        <source>Load at the upper end of the colours. Empty: automatic.</source>
        <translation>Charge à la borne supérieure des couleurs. Vide&#xa0;: automatique.</translation>
    </message>
    <message>
        <source>auto</source>
        <translation>auto</translation>
    </message>
    <message>
        <source>Dead taxel: its value is not used.</source>
        <translation>Taxel mort&#xa0;: sa valeur n’est pas utilisée.</translation>
    </message>
    <message>
        <source>Centre of &amp;pressure</source>
        <translation>Centre de &amp;pression</translation>
    </message>
    <message>
        <source>Centre of c&amp;ontact</source>
        <translation>Centre de c&amp;ontact</translation>
    </message>
    <message>
        <source>Principal &amp;axis</source>
        <translation>&amp;Axe principal</translation>
    </message>
    <message>
        <source>Colour &amp;range</source>
        <translation>Plage de cou&amp;leurs</translation>
    </message>
    <message>
        <source>&amp;Type upper end…</source>
        <translation>&amp;Saisir la borne supérieure…</translation>
    </message>
    <message>
        <source>Show &amp;whole array</source>
        <translation>Afficher toute la &amp;matrice</translation>
    </message>
    <message>
        <source>Loads from 0 to %1. Taxels below the threshold of %2 are not in contact.
Double-click to type the upper end.</source>
        <translation>Charges de 0 à %1. Les taxels sous le seuil de %2 ne portent pas de contact.
Double-cliquez pour saisir la borne supérieure.</translation>
    </message>
    <message>
        <source>&lt;p&gt;The load of every taxel of the array, seen from outside the skin: x points to the right, y up.&lt;/p&gt;&lt;p&gt;Coloured outlines are contacts, each with the number under which it is followed. × is the centre of pressure, ○ the centre of contact, the line the principal axis. Hatched taxels are dead and carry no load. Arrows are the force along the surface, of arrays that measure it; zoom in where taxels are too small for them.&lt;/p&gt;&lt;p&gt;Ctrl+wheel zooms, drag moves, double click shows the whole array. Double-click the colour bar to type its upper end. The arrow keys read taxel by taxel.&lt;/p&gt;</source>
        <translation>&lt;p&gt;La charge de chaque taxel de la matrice, vue de l’extérieur de la peau&#xa0;: x pointe vers la droite, y vers le haut.&lt;/p&gt;&lt;p&gt;Les contours colorés sont des contacts, chacun avec le numéro sous lequel il est suivi. × est le centre de pression, ○ le centre de contact, le trait l’axe principal. Les taxels hachurés sont morts et ne portent pas de charge. Les flèches sont la force le long de la surface, si la matrice la mesure&#xa0;; agrandissez là où les taxels sont trop petits pour elles.&lt;/p&gt;&lt;p&gt;Ctrl+molette zoome, glisser déplace, un double clic affiche toute la matrice. Double-cliquez sur l’échelle de couleurs pour saisir sa borne supérieure. Les touches fléchées lisent taxel par taxel.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>&amp;Shear</source>
        <translation>&amp;Cisaillement</translation>
    </message>
    <message>
        <source>Draw the force along the surface as arrows, of arrays that measure it</source>
        <translation>Dessiner la force le long de la surface par des flèches, si la matrice la mesure</translation>
    </message>
</context>
<context>
    <name>teleta::touch::ContourView</name>
    <message>
        <source>Explored contour</source>
        <translation>Contour exploré</translation>
    </message>
    <message>
        <source>contour</source>
        <translation>contour</translation>
    </message>
    <message>
        <source>&amp;Forget the explored contour</source>
        <translation>&amp;Oublier le contour exploré</translation>
    </message>
    <message>
        <source>&lt;p&gt;The object from above, as far as it was explored: the points at which it was touched, the spline through them, and the vertices or the circle of the shape that was recognised.&lt;/p&gt;&lt;p&gt;The confidence is the share of such answers that are right. While the points do not decide, the shapes that come into question stand there with their probabilities.&lt;/p&gt;</source>
        <translation>&lt;p&gt;L’objet vu d’en haut, tel qu’il a été exploré&#xa0;: les points où il a été touché, la spline qui les relie, et les sommets ou le cercle de la forme reconnue.&lt;/p&gt;&lt;p&gt;La confiance est la part de telles réponses qui sont justes. Tant que les points ne décident pas, les formes possibles sont affichées avec leurs probabilités.&lt;/p&gt;</translation>
    </message>
</context>
<context>
    <name>teleta::touch::DriveSign</name>
    <message>
        <source>Drive of the arm</source>
        <translation>Commande du bras</translation>
    </message>
    <message>
        <source>no arm</source>
        <translation>pas de bras</translation>
    </message>
</context>
<context>
    <name>teleta::touch::JogPanel</name>
    <message>
        <source>%1 %</source>
        <translation>%1&#xa0;%</translation>
    </message>
    <message>
        <source>Jog the arm</source>
        <translation>Déplacer le bras manuellement</translation>
    </message>
    <message>
        <source>&lt;p&gt;Moves the arm by hand. It moves only while you hold Shift, or the wide button, together with a direction. Let go of either and it stands still.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Déplace le bras à la main. Il ne bouge que tant que vous maintenez Shift, ou le bouton large, avec une direction. Relâchez l’un ou l’autre et il s’arrête.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>&amp;Run</source>
        <translation>&amp;Exécuter</translation>
    </message>
    <message>
        <source>Let the arm&apos;s program go on</source>
        <translation>Laisser continuer le programme du bras</translation>
    </message>
    <message>
        <source>&amp;Hold</source>
        <translation>&amp;Maintenir</translation>
    </message>
    <message>
        <source>Hold the arm where it is</source>
        <translation>Maintenir le bras là où il est</translation>
    </message>
    <message>
        <source>R&amp;estart</source>
        <translation>&amp;Recommencer</translation>
    </message>
    <message>
        <source>Joints</source>
        <translation>Articulations</translation>
    </message>
    <message>
        <source>Tip, x y z</source>
        <translation>Extrémité, x y z</translation>
    </message>
    <message>
        <source>What is moved</source>
        <translation>Ce qui est déplacé</translation>
    </message>
    <message>
        <source>Turn single joints, or move the tip of the forearm along the base&apos;s axes</source>
        <translation>Tourner des articulations une à une, ou déplacer l’extrémité de l’avant-bras selon les axes de la base</translation>
    </message>
    <message>
        <source>&amp;Speed</source>
        <translation>&amp;Vitesse</translation>
    </message>
    <message>
        <source>Share of the fastest speed</source>
        <translation>Part de la vitesse maximale</translation>
    </message>
    <message>
        <source>Jog speed</source>
        <translation>Vitesse du déplacement manuel</translation>
    </message>
    <message>
        <source>Hold to enable (or Shift)</source>
        <translation>Maintenir pour autoriser (ou Shift)</translation>
    </message>
    <message>
        <source>Dead-man switch: the arm moves only while this button or Shift is held</source>
        <translation>Dispositif d’homme mort&#xa0;: le bras ne bouge que tant que ce bouton ou Shift est maintenu</translation>
    </message>
    <message>
        <source>Dead-man switch</source>
        <translation>Dispositif d’homme mort</translation>
    </message>
    <message>
        <source>Angle of %1</source>
        <translation>Angle&#xa0;: %1</translation>
    </message>
    <message>
        <source>tip along %1</source>
        <translation>extrémité selon %1</translation>
    </message>
    <message>
        <source>%1 up</source>
        <translation>%1, augmenter</translation>
    </message>
    <message>
        <source>%1 down</source>
        <translation>%1, diminuer</translation>
    </message>
    <message>
        <source>Hold with Shift to move; key Shift+%1</source>
        <translation>Maintenir avec Shift pour déplacer&#xa0;; touche Shift+%1</translation>
    </message>
    <message>
        <source>No arm is connected. Open a scene or a device with an arm.</source>
        <translation>Aucun bras n’est connecté. Ouvrez une scène ou un appareil avec un bras.</translation>
    </message>
    <message>
        <source>STOP is engaged. Hold the STOP button to release it, then jog.</source>
        <translation>STOP est enclenché. Maintenez le bouton STOP pour le relâcher, puis déplacez le bras.</translation>
    </message>
    <message>
        <source>Hold Shift and a button, or Shift with D A (x), W S (y), E Q (z).</source>
        <translation>Maintenez Shift et un bouton, ou Shift avec D A (x), W S (y), E Q (z).</translation>
    </message>
    <message>
        <source>The joint readings are old: nothing is moved until they come again.</source>
        <translation>Les mesures articulaires sont anciennes&#xa0;: rien ne bouge jusqu’à leur retour.</translation>
    </message>
    <message>
        <source>&amp;Step</source>
        <translation>&amp;Pas</translation>
    </message>
    <message>
        <source>How far a press leads the tip, and a 3D mouse that is fully deflected</source>
        <translation>De combien un appui déplace l’extrémité, de même qu’une souris 3D déviée à fond</translation>
    </message>
    <message>
        <source>Length of a step</source>
        <translation>Longueur d’un pas</translation>
    </message>
    <message>
        <source>By velocity</source>
        <translation>En vitesse</translation>
    </message>
    <message>
        <source>By position</source>
        <translation>En position</translation>
    </message>
    <message>
        <source>How it is moved</source>
        <translation>Mode de déplacement</translation>
    </message>
    <message>
        <source>By velocity the arm moves while a direction is held. By position each press is a step of the tip, and a 3D mouse leads the tip as far as it is deflected.</source>
        <translation>En vitesse, le bras bouge tant qu’une direction est maintenue. En position, chaque appui est un pas de l’extrémité, et une souris 3D déplace l’extrémité d’autant qu’elle est déviée.</translation>
    </message>
    <message>
        <source>Clutch (C)</source>
        <translation>Débrayage (C)</translation>
    </message>
    <message>
        <source>While it is held the arm stands still and the hand goes back freely; then it takes hold anew. Also the second button of a 3D mouse.</source>
        <translation>Tant qu’il est maintenu, le bras reste immobile et la main revient librement&#xa0;; puis elle reprend prise. Aussi le deuxième bouton d’une souris 3D.</translation>
    </message>
    <message>
        <source>Clutch</source>
        <translation>Débrayage</translation>
    </message>
    <message>
        <source>Hold Shift: each press of D A (x), W S (y), E Q (z) is a step.</source>
        <translation>Maintenez Shift&#xa0;: chaque appui sur D A (x), W S (y), E Q (z) est un pas.</translation>
    </message>
    <message>
        <source>&lt;p&gt;Leads the tip of the arm by hand. Each press of a direction is a step. The arm moves only while you hold Shift, or the wide button; let go of it and it stands still.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Mène à la main la pointe du bras. Chaque appui sur une direction est un pas. Le bras ne bouge que tant que vous maintenez Shift, ou le bouton large&#xa0;; relâchez-le et il s’arrête.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>A step, while Shift is held; key Shift+%1</source>
        <translation>Un pas, tant que Shift est maintenu&#xa0;; touche Shift+%1</translation>
    </message>
    <message>
        <source>A recording is played: what its arm did is over, and nothing can be moved.</source>
        <translation>Un enregistrement est lu&#xa0;: ce que son bras a fait est passé, rien ne peut être déplacé.</translation>
    </message>
    <message>
        <source>Restart the arm&apos;s program</source>
        <translation>Recommencer le programme du bras</translation>
    </message>
    <message>
        <source>Hold with Shift to move</source>
        <translation>Maintenir avec Shift pour déplacer</translation>
    </message>
    <message>
        <source>Hold Shift and a button, or Shift with %1 (up), %2 (down).</source>
        <translation>Maintenez Shift et un bouton, ou Shift avec %1 (augmenter), %2 (diminuer).</translation>
    </message>
    <message>
        <source>tip %1</source>
        <translation>pointe&#xa0;%1</translation>
    </message>
    <message>
        <source>Click here first: the keys work only in this view. %1</source>
        <translation>Cliquez d’abord ici&#xa0;: les touches n’agissent que dans cette vue.&#xa0;%1</translation>
    </message>
    <message>
        <source>The arm does not move: %1.</source>
        <translation>Le bras ne bouge pas : %1.</translation>
    </message>
    <message>
        <source>UNGUARDED: the robot does not stop by itself when this program or the network fails. Keep its emergency stop within reach. %1</source>
        <translation>SANS GARDE&#xa0;: le robot ne s’arrête pas de lui-même en cas de défaillance de ce programme ou du réseau. Gardez son arrêt d’urgence à portée de main. %1</translation>
    </message>
    <message>
        <source>At the tip: force %1, torque %2</source>
        <translation>À l’extrémité&#xa0;: force %1, couple %2</translation>
    </message>
</context>
<context>
    <name>teleta::touch::JointRange</name>
    <message>
        <source>%1 limit</source>
        <translation>%1 butée</translation>
    </message>
    <message>
        <source>limit</source>
        <translation>butée</translation>
    </message>
    <message>
        <source>Turns without limits</source>
        <translation>Tourne sans limites</translation>
    </message>
    <message>
        <source>Range %1 … %2</source>
        <translation>Plage %1 … %2</translation>
    </message>
</context>
<context>
    <name>teleta::touch::PatternMapTable</name>
    <message>
        <source>level %1: %2</source>
        <translation>niveau %1&#xa0;: %2</translation>
    </message>
    <message>
        <source>What was recognised and its pattern</source>
        <translation>Ce qui a été reconnu et son motif</translation>
    </message>
    <message>
        <source>&lt;p&gt;Which pattern the bracelet plays for what was recognised. The marked row was recognised last.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Le motif que joue le bracelet pour ce qui a été reconnu. La ligne marquée est la dernière reconnue.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Patterns for what was recognised</source>
        <translation>Motifs pour ce qui a été reconnu</translation>
    </message>
    <message>
        <source>Recognised</source>
        <translation>Reconnu</translation>
    </message>
    <message>
        <source>Pattern</source>
        <translation>Motif</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Annuler</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Rétablir</translation>
    </message>
    <message>
        <source>&amp;Defaults</source>
        <translation>Valeurs par &amp;défaut</translation>
    </message>
    <message>
        <source>The built-in dynamic patterns again; can be undone</source>
        <translation>De nouveau les motifs dynamiques intégrés&#xa0;; peut être annulé</translation>
    </message>
    <message>
        <source>&amp;Import…</source>
        <translation>&amp;Importer…</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>&amp;Exporter…</translation>
    </message>
    <message>
        <source>Pattern for %1</source>
        <translation>Motif pour %1</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>rien</translation>
    </message>
    <message>
        <source>%1 (missing)</source>
        <translation>%1 (manquant)</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>%1 (now)</source>
        <translation>%1 (maintenant)</translation>
    </message>
    <message>
        <source>Nothing was recognised yet.</source>
        <translation>Rien n’a encore été reconnu.</translation>
    </message>
    <message>
        <source>Recognised: %1. Nothing is played.</source>
        <translation>Reconnu&#xa0;: %1. Rien n’est joué.</translation>
    </message>
    <message>
        <source>Recognised: %1. Pattern now: %2.</source>
        <translation>Reconnu&#xa0;: %1. Motif actuel&#xa0;: %2.</translation>
    </message>
    <message>
        <source>Recognised: %1. Its pattern %2 is missing.</source>
        <translation>Reconnu&#xa0;: %1. Son motif %2 manque.</translation>
    </message>
    <message>
        <source>Default patterns</source>
        <translation>Motifs par défaut</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>Importation</translation>
    </message>
    <message>
        <source>The file could not be written: %1</source>
        <translation>Le fichier n’a pas pu être écrit&#xa0;: %1</translation>
    </message>
    <message>
        <source>Map of patterns (*.json)</source>
        <translation>Table des motifs (*.json)</translation>
    </message>
    <message>
        <source>Export patterns</source>
        <translation>Exporter les motifs</translation>
    </message>
    <message>
        <source>Import patterns</source>
        <translation>Importer des motifs</translation>
    </message>
    <message>
        <source>unknown stiffness</source>
        <translation>raideur inconnue</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Genre</translation>
    </message>
</context>
<context>
    <name>teleta::touch::RunSheet</name>
    <message>
        <source>Run sheet</source>
        <translation>Relevé des objets</translation>
    </message>
    <message>
        <source>&lt;p&gt;The objects that were found, told apart by their place. Stiffness is the median of their touches, with its 95 % interval.&lt;/p&gt;&lt;p&gt;F2 names an object, Delete takes it off the sheet, Ctrl+Z brings it back.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Les objets trouvés, distingués par leur emplacement. La raideur est la médiane de leurs touchers, avec son intervalle à 95&#xa0;%.&lt;/p&gt;&lt;p&gt;F2 nomme un objet, Suppr le retire du relevé, Ctrl+Z le rétablit.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>No object was found yet. Drive the arm until it touches something.</source>
        <translation>Aucun objet n’a encore été trouvé. Conduisez le bras jusqu’à ce qu’il touche quelque chose.</translation>
    </message>
    <message>
        <source>&amp;Name…</source>
        <translation>&amp;Nommer…</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>&amp;Supprimer</translation>
    </message>
    <message>
        <source>&amp;Undo %1</source>
        <translation>&amp;Annuler %1</translation>
    </message>
    <message>
        <source>&amp;Redo %1</source>
        <translation>&amp;Rétablir %1</translation>
    </message>
    <message numerus="yes">
        <source>%n object(s) found</source>
        <translation>
            <numerusform>%n objet trouvé</numerusform>
            <numerusform>%n objets trouvés</numerusform>
        </translation>
    </message>
    <message>
        <source>run-sheet</source>
        <comment>name of a file</comment>
        <translation>relevé-des-objets</translation>
    </message>
    <message>
        <source>No object was found yet. Play the recording until the arm touches something.</source>
        <translation>Aucun objet n’a encore été trouvé. Lisez l’enregistrement jusqu’à ce que le bras touche quelque chose.</translation>
    </message>
</context>
<context>
    <name>teleta::touch::RunSheetModel</name>
    <message>
        <source>Rename object %1</source>
        <translation>Renommer l’objet %1</translation>
    </message>
    <message>
        <source>Delete from the run sheet</source>
        <translation>Supprimer du relevé</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>N°</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nom</translation>
    </message>
    <message>
        <source>Found at</source>
        <translation>Trouvé à</translation>
    </message>
    <message>
        <source>Place x, y</source>
        <translation>Position x, y</translation>
    </message>
    <message>
        <source>Touches</source>
        <translation>Touchers</translation>
    </message>
    <message>
        <source>Contact</source>
        <translation>Contact</translation>
    </message>
    <message>
        <source>Stiffness</source>
        <translation>Raideur</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>Matériau</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>Forme</translation>
    </message>
    <message>
        <source>Highest force</source>
        <translation>Force maximale</translation>
    </message>
    <message>
        <source>When its first touch began, as in Touches</source>
        <translation>Début de son premier contact, comme dans Contacts</translation>
    </message>
    <message>
        <source>The highest force of all its touches, from the torques of the joints</source>
        <translation>La plus grande force de tous ses contacts, d’après les couples des articulations</translation>
    </message>
</context>
<context>
    <name>teleta::touch::StiffnessGauge</name>
    <message>
        <source>Stiffness of the touched object</source>
        <translation>Raideur de l’objet touché</translation>
    </message>
    <message>
        <source>&lt;p&gt;How stiff the object is that was touched last, on a logarithmic scale. The dot is the estimate, the line through it the interval in which the stiffness lies with 95 %.&lt;/p&gt;&lt;p&gt;An object that yields hardly more than the arm itself cannot be told from a rigid one: then an open arrow shows that its stiffness is at least so large.&lt;/p&gt;&lt;p&gt;Sponge and rubber sponge are safe to touch; rubber, wood and metal are a danger.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Raideur du dernier objet touché, sur une échelle logarithmique. Le point est l’estimation, le trait qui le traverse l’intervalle qui contient la raideur à 95&#xa0;%.&lt;/p&gt;&lt;p&gt;Un objet qui ne cède guère plus que le bras lui-même ne peut pas être distingué d’un objet rigide&#xa0;: une flèche ouverte montre alors que sa raideur est au moins aussi grande.&lt;/p&gt;&lt;p&gt;L’éponge et le caoutchouc mousse peuvent être touchés sans danger&#xa0;; le caoutchouc, le bois et le métal présentent un danger.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Touch an object with the forearm: its stiffness appears here.</source>
        <translation>Touchez un objet avec l’avant-bras&#xa0;: sa raideur apparaît ici.</translation>
    </message>
    <message>
        <source>stiffness</source>
        <translation>raideur</translation>
    </message>
</context>
<context>
    <name>teleta::touch::TouchModel</name>
    <message>
        <source>No force: the skin did not feel where the contact is.</source>
        <translation>Pas de force&#xa0;: la peau n’a pas senti où est le contact.</translation>
    </message>
    <message>
        <source>%1: %2 ± %3 N</source>
        <translation>%1&#xa0;: %2 ± %3 N</translation>
    </message>
    <message>
        <source>%1: not observable in this configuration of the arm</source>
        <translation>%1&#xa0;: non observable dans cette configuration du bras</translation>
    </message>
    <message>
        <source>condition number %1, unexplained torque %2 Nm</source>
        <translation>conditionnement %1, couple inexpliqué %2 Nm</translation>
    </message>
    <message>
        <source>none</source>
        <translation>aucune</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message numerus="yes">
        <source>95 % interval in brackets; %1, %n sample(s)</source>
        <translation>
            <numerusform>intervalle à 95&#xa0;% entre crochets&#xa0;; %1, %n échantillon</numerusform>
            <numerusform>intervalle à 95&#xa0;% entre crochets&#xa0;; %1, %n échantillons</numerusform>
        </translation>
    </message>
    <message>
        <source>No stiffness: the skin did not feel where the contact is.</source>
        <translation>Pas de raideur&#xa0;: la peau n’a pas senti où est le contact.</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>%1 (not certain), %2</source>
        <translation>%1 (incertain), %2</translation>
    </message>
    <message>
        <source>First torque above the noise at %1 s, estimated %2 ms later; evaluated: %3</source>
        <translation>Premier couple au-dessus du bruit à %1 s, estimé %2 ms plus tard&#xa0;; évalué&#xa0;: %3</translation>
    </message>
    <message>
        <source>x, y, z in the frame of the arm&apos;s base; the distance is along the forearm, from the elbow</source>
        <translation>x, y, z dans le repère de la base du bras&#xa0;; la distance est le long de l’avant-bras, depuis le coude</translation>
    </message>
    <message>
        <source>The skin did not feel this contact.</source>
        <translation>La peau n’a pas senti ce contact.</translation>
    </message>
    <message>
        <source>Condition number of the force: longest over shortest lever; large is bad</source>
        <translation>Conditionnement de la force&#xa0;: plus long bras de levier sur le plus court&#xa0;; grand est mauvais</translation>
    </message>
    <message>
        <source>Distance of the contact from the elbow, along the forearm</source>
        <translation>Distance du contact au coude, le long de l’avant-bras</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>N°</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Temps</translation>
    </message>
    <message>
        <source>Contact x, y, z</source>
        <translation>Contact x, y, z</translation>
    </message>
    <message>
        <source>Along link</source>
        <translation>Sur le segment</translation>
    </message>
    <message>
        <source>Force x, y, z</source>
        <translation>Force x, y, z</translation>
    </message>
    <message>
        <source>Stiffness</source>
        <translation>Raideur</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>Matériau</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>Niveau</translation>
    </message>
    <message>
        <source>Condition</source>
        <translation>Conditionnement</translation>
    </message>
    <message>
        <source>cannot tell</source>
        <translation>indéterminé</translation>
    </message>
    <message>
        <source>Force at the contact; a dash marks what the arm cannot observe in this pose</source>
        <translation>Force au contact&#xa0;; un tiret marque ce que le bras ne peut pas observer dans sa configuration</translation>
    </message>
</context>
<context>
    <name>teleta::touch::TouchTable</name>
    <message>
        <source>Recent touches</source>
        <translation>Touchers récents</translation>
    </message>
    <message>
        <source>&lt;p&gt;Every touch of the arm with what was found out about it. A ? in the force marks a component that the arm cannot observe in its configuration.&lt;/p&gt;&lt;p&gt;Click a title to sort. Ctrl+C copies the selected rows.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Chaque toucher du bras avec ce qui en a été déterminé. Un&#xa0;? dans la force marque une composante que le bras ne peut pas observer dans sa configuration.&lt;/p&gt;&lt;p&gt;Cliquez sur un titre pour trier. Ctrl+C copie les lignes sélectionnées.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>No touch yet. Touch an object with the forearm.</source>
        <translation>Pas encore de toucher. Touchez un objet avec l’avant-bras.</translation>
    </message>
    <message>
        <source>touches</source>
        <translation>touchers</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Copier</translation>
    </message>
    <message numerus="yes">
        <source>%n touch(es)</source>
        <translation>
            <numerusform>%n toucher</numerusform>
            <numerusform>%n touchers</numerusform>
        </translation>
    </message>
    <message>
        <source>Select &amp;all</source>
        <translation>&amp;Tout sélectionner</translation>
    </message>
    <message>
        <source>&amp;Newest first</source>
        <translation>Les plus &amp;récents d’abord</translation>
    </message>
</context>
<context>
    <name>teleta::view3d::Scene3dView</name>
    <message>
        <source>touch 3-D</source>
        <translation>toucher 3D</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Flat array</source>
        <translation>Matrice à plat</translation>
    </message>
    <message>
        <source>Show the array flat, as it is</source>
        <translation>Afficher la matrice à plat, telle qu’elle est</translation>
    </message>
    <message>
        <source>Wrapped on the cylinder</source>
        <translation>Enroulée sur le cylindre</translation>
    </message>
    <message>
        <source>Wrap the array around the tactile cylinder</source>
        <translation>Enrouler la matrice autour du cylindre tactile</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Face</translation>
    </message>
    <message>
        <source>Look from the front</source>
        <translation>Regarder de face</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Dessus</translation>
    </message>
    <message>
        <source>Look from above</source>
        <translation>Regarder de dessus</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>Côté</translation>
    </message>
    <message>
        <source>Look from the right</source>
        <translation>Regarder de la droite</translation>
    </message>
    <message>
        <source>Isometric</source>
        <translation>Isométrique</translation>
    </message>
    <message>
        <source>Look from a corner</source>
        <translation>Regarder depuis un coin</translation>
    </message>
    <message>
        <source>Show all</source>
        <translation>Tout afficher</translation>
    </message>
    <message>
        <source>Follow contact</source>
        <translation>Suivre le contact</translation>
    </message>
    <message>
        <source>Keep the strongest contact in the middle</source>
        <translation>Garder le contact le plus fort au milieu</translation>
    </message>
    <message>
        <source>Orthographic</source>
        <translation>Orthographique</translation>
    </message>
    <message>
        <source>Parallel lines stay parallel: no perspective</source>
        <translation>Les droites parallèles restent parallèles&#xa0;: pas de perspective</translation>
    </message>
    <message>
        <source>Grid</source>
        <translation>Grille</translation>
    </message>
    <message>
        <source>Show the ground with a grid in millimetres</source>
        <translation>Afficher le sol avec une grille en millimètres</translation>
    </message>
    <message>
        <source>Axes</source>
        <translation>Axes</translation>
    </message>
    <message>
        <source>Show the axes of the array&apos;s frame</source>
        <translation>Afficher les axes du repère de la matrice</translation>
    </message>
    <message>
        <source>Displacement</source>
        <translation>Déplacement</translation>
    </message>
    <message>
        <source>Show how far each contact moved since it began</source>
        <translation>Afficher le déplacement de chaque contact depuis son début</translation>
    </message>
    <message>
        <source>Contact labels</source>
        <translation>Étiquettes des contacts</translation>
    </message>
    <message>
        <source>Show number and force at each contact</source>
        <translation>Afficher numéro et force à chaque contact</translation>
    </message>
    <message>
        <source>Copy picture</source>
        <translation>Copier l’image</translation>
    </message>
    <message>
        <source>Copy the picture</source>
        <translation>Copier l’image</translation>
    </message>
    <message>
        <source>Export geometry…</source>
        <translation>Exporter la géométrie…</translation>
    </message>
    <message>
        <source>Save the scene for other programs: VTP, PLY, STL</source>
        <translation>Enregistrer la scène pour d’autres programmes&#xa0;: VTP, PLY, STL</translation>
    </message>
    <message>
        <source>3-D view</source>
        <translation>Vue 3D</translation>
    </message>
    <message>
        <source>Touch in 3-D</source>
        <translation>Toucher en 3D</translation>
    </message>
    <message>
        <source>The tactile array with its loads as heights and colours, contacts with force arrows, the arm and the explored contour. Drag with the left button to turn, with the middle button to move, turn the wheel to zoom.</source>
        <translation>La matrice tactile avec ses charges en hauteurs et couleurs, les contacts avec des flèches de force, le bras et le contour exploré. Glissez avec le bouton gauche pour tourner, avec le bouton du milieu pour déplacer, tournez la molette pour zoomer.</translation>
    </message>
    <message>
        <source>No touch to show yet.</source>
        <translation>Pas encore de toucher à montrer.</translation>
    </message>
    <message>
        <source>Export geometry (in mm)</source>
        <translation>Exporter la géométrie (en mm)</translation>
    </message>
    <message>
        <source>VTK, with colours and lines (*.vtp)</source>
        <translation>VTK, avec couleurs et lignes (*.vtp)</translation>
    </message>
    <message>
        <source>Triangles with colours (*.ply)</source>
        <translation>Triangles avec couleurs (*.ply)</translation>
    </message>
    <message>
        <source>Triangles (*.stl)</source>
        <translation>Triangles (*.stl)</translation>
    </message>
    <message>
        <source>Back to the initial view: everything from a corner</source>
        <translation>Retour au départ&#xa0;: tout, depuis un coin</translation>
    </message>
    <message>
        <source>Trail of the tip</source>
        <translation>Trace de la pointe</translation>
    </message>
    <message>
        <source>Show where the arm&apos;s tip was in the last 5 s</source>
        <translation>Montrer où la pointe du bras se trouvait pendant les 5 dernières secondes</translation>
    </message>
    <message>
        <source>Joint limits</source>
        <translation>Limites des articulations</translation>
    </message>
    <message>
        <source>Show range and angle of each joint that is near the end of its range</source>
        <translation>Montrer la plage et l’angle de chaque articulation proche du bout de sa plage</translation>
    </message>
    <message>
        <source>Forces</source>
        <translation>Forces</translation>
    </message>
    <message>
        <source>Show forces as arrows</source>
        <translation>Montrer les forces par des flèches</translation>
    </message>
    <message>
        <source>Moments</source>
        <translation>Moments</translation>
    </message>
    <message>
        <source>Show the moment of the loads on a flat array about their centre, as an arrow that turns</source>
        <translation>Montrer le moment des charges d’une matrice plane autour de leur centre, par une flèche courbe</translation>
    </message>
    <message>
        <source>Objects of the scene</source>
        <translation>Objets de la scène</translation>
    </message>
    <message>
        <source>Show what a simulated scene has around the arm</source>
        <translation>Montrer ce qu’une scène simulée place autour du bras</translation>
    </message>
</context>
<context>
    <name>teleta::view3d::VtkWidget</name>
    <message>
        <source>The 3-D view is not available. %1
All other views work without it.</source>
        <translation>Pas de vue 3D ici. %1
Toutes les autres vues fonctionnent sans elle.</translation>
    </message>
</context>
<context>
    <name>view3d</name>
    <message>
        <source>a file name that ends in .vtp, .ply or .stl</source>
        <translation>un nom de fichier qui se termine par .vtp, .ply ou .stl</translation>
    </message>
    <message>
        <source>The scene is empty: there is nothing to write.</source>
        <translation>La scène est vide&#xa0;: il n’y a rien à écrire.</translation>
    </message>
    <message>
        <source>nothing was written</source>
        <translation>rien n’a été écrit</translation>
    </message>
    <message>
        <source>The geometry could not be written: %1</source>
        <translation>La géométrie n’a pas pu être écrite&#xa0;: %1</translation>
    </message>
    <message>
        <source>The display platform &quot;%1&quot; has no OpenGL widgets.</source>
        <translation>La plateforme d’affichage «&#xa0;%1&#xa0;» n’a pas de widgets OpenGL.</translation>
    </message>
    <message>
        <source>This display refused an OpenGL context.</source>
        <translation>Cet affichage a refusé un contexte OpenGL.</translation>
    </message>
    <message>
        <source>The OpenGL driver of this display does not work with VTK.</source>
        <translation>Le pilote OpenGL de cet affichage ne fonctionne pas avec VTK.</translation>
    </message>
    <message>
        <source>Geometry cannot be written in this format.</source>
        <translation>Ce n’est pas un format de géométrie qui peut être écrit.</translation>
    </message>
    <message>
        <source>This display does not support OpenGL %1.%2 or newer.</source>
        <translation>Cet affichage n’offre pas OpenGL %1.%2 ou plus récent.</translation>
    </message>
</context>
</TS>
