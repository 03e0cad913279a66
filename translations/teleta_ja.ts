<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="ja" sourcelanguage="en">
<context>
    <name>AblationText</name>
    <message>
        <source>interrupted before all runs were done</source>
        <translation>すべての実行が終わる前に中断されました</translation>
    </message>
    <message>
        <source>the spread of a measure needs at least two seeds</source>
        <translation>指標のばらつきには少なくとも2つのシードが必要です</translation>
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
        <translation>遠隔のロボットアームが触れているものを表示し、操作者に感じさせます。</translation>
    </message>
    <message>
        <source>Free software under the GNU General Public License, version 3 or later. It comes without any warranty.</source>
        <translation>GNU General Public License (バージョン3以降) のもとで配布されるフリーソフトウェアです。いかなる保証もありません。</translation>
    </message>
    <message>
        <source>About TeleTA Console</source>
        <translation>TeleTA Consoleについて</translation>
    </message>
    <message>
        <source>Esc Esc, Ctrl+.</source>
        <translation>Esc Esc, Ctrl+.</translation>
    </message>
    <message>
        <source>Space</source>
        <translation>Space</translation>
    </message>
    <message>
        <source>Play or pause</source>
        <translation>再生または一時停止</translation>
    </message>
    <message>
        <source>Left, Right</source>
        <translation>←, →</translation>
    </message>
    <message>
        <source>One frame back or forward</source>
        <translation>1フレーム戻る、または進む</translation>
    </message>
    <message>
        <source>Home, End</source>
        <translation>Home, End</translation>
    </message>
    <message>
        <source>Start or end of the recording</source>
        <translation>記録の先頭または末尾</translation>
    </message>
    <message>
        <source>Arrow keys</source>
        <translation>矢印キー</translation>
    </message>
    <message>
        <source>Move the read-out from taxel to taxel, in the heatmap</source>
        <translation>読み取り位置をタクセルごとに移動 (ヒートマップ)</translation>
    </message>
    <message>
        <source>Ctrl+wheel</source>
        <translation>Ctrl+ホイール</translation>
    </message>
    <message>
        <source>Zoom the picture or the time under the mouse</source>
        <translation>マウス位置の画像または時間を拡大・縮小</translation>
    </message>
    <message>
        <source>Shift+wheel</source>
        <translation>Shift+ホイール</translation>
    </message>
    <message>
        <source>Scroll through time</source>
        <translation>時間方向にスクロール</translation>
    </message>
    <message>
        <source>1, 2, 3, 4</source>
        <translation>1, 2, 3, 4</translation>
    </message>
    <message>
        <source>Front, top, side, isometric view, in the reconstruction</source>
        <translation>正面、上面、側面、等角投影 (再構成)</translation>
    </message>
    <message>
        <source>F11</source>
        <translation>F11</translation>
    </message>
    <message>
        <source>Full screen</source>
        <translation>全画面表示</translation>
    </message>
    <message>
        <source>Shift+F1</source>
        <translation>Shift+F1</translation>
    </message>
    <message>
        <source>What&apos;s This</source>
        <translation>これは何?</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>キー</translation>
    </message>
    <message>
        <source>Effect</source>
        <translation>動作</translation>
    </message>
    <message>
        <source>Shortcuts</source>
        <translation>ショートカット</translation>
    </message>
    <message>
        <source>Space, P</source>
        <translation>Space, P</translation>
    </message>
    <message>
        <source>Play or pause; pen</source>
        <translation>再生または一時停止、ペン</translation>
    </message>
    <message>
        <source>Ctrl+N, O, S, Shift+S, E</source>
        <translation>Ctrl+N, O, S, Shift+S, E</translation>
    </message>
    <message>
        <source>New, open, save, save as, export</source>
        <translation>新規、開く、保存、名前を付けて保存、エクスポート</translation>
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
        <source>Cut, copy, paste in place, paste at the playhead, duplicate</source>
        <translation>切り取り、コピー、同じ位置に貼り付け、再生ヘッドに貼り付け、複製</translation>
    </message>
    <message>
        <source>,  .  with Shift</source>
        <translation>,  .  Shift併用可</translation>
    </message>
    <message>
        <source>N, Shift+N</source>
        <translation>N, Shift+N</translation>
    </message>
    <message>
        <source>Next or previous object</source>
        <translation>次または前のオブジェクト</translation>
    </message>
    <message>
        <source>Enter, Insert, Delete</source>
        <translation>Enter, Insert, Delete</translation>
    </message>
    <message>
        <source>Type numbers, add a breakpoint at the playhead, delete</source>
        <translation>数値を入力、再生ヘッドにブレークポイントを追加、削除</translation>
    </message>
    <message>
        <source>Arrow keys, with Shift</source>
        <translation>矢印キー、Shift併用可</translation>
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
        <source>Rotate around the ring, mirror, other arm</source>
        <translation>リングに沿って回転、反転、反対の腕</translation>
    </message>
    <message>
        <source>Ctrl+Alt+1 to 5</source>
        <translation>Ctrl+Alt+1～5</translation>
    </message>
    <message>
        <source>Add a sweep, ring, phantom, ramp, pulse train at the playhead</source>
        <translation>再生ヘッドにスイープ、リング、ファントム、ランプ、パルス列を追加</translation>
    </message>
    <message>
        <source>Ctrl++, Ctrl+-, Ctrl+0</source>
        <translation>Ctrl++, Ctrl+-, Ctrl+0</translation>
    </message>
    <message>
        <source>Zoom in, out, to fit</source>
        <translation>拡大、縮小、全体表示</translation>
    </message>
    <message>
        <source>F2, Ctrl+D, Delete, Ctrl+Z</source>
        <translation>F2, Ctrl+D, Delete, Ctrl+Z</translation>
    </message>
    <message>
        <source>Rename, duplicate, delete, undo, in the library</source>
        <translation>名前の変更、複製、削除、元に戻す (ライブラリ)</translation>
    </message>
    <message>
        <source>Ctrl+R, M</source>
        <translation>Ctrl+R, M</translation>
    </message>
    <message>
        <source>Record, mark this moment in the recording</source>
        <translation>記録、この瞬間にマークを付ける</translation>
    </message>
    <message>
        <source>F1</source>
        <translation>F1</translation>
    </message>
    <message>
        <source>Handbook: the page on what is shown</source>
        <translation>ハンドブック: 表示中の画面についてのページ</translation>
    </message>
    <message>
        <source>Ctrl+1 to 6</source>
        <translation>Ctrl+1～6</translation>
    </message>
    <message>
        <source>Page Operate, Patterns, Study, Calibrate, Cost, Plot</source>
        <translation>操作、パターン、実験、キャリブレーション、コスト、プロットのページ</translation>
    </message>
    <message>
        <source>F5, Shift+F5, Ctrl+F5</source>
        <translation>F5, Shift+F5, Ctrl+F5</translation>
    </message>
    <message>
        <source>Run the program of the arm, hold it, restart it</source>
        <translation>アームのプログラムの実行、保持、再開始</translation>
    </message>
    <message>
        <source>Ctrl+Shift+N</source>
        <translation>Ctrl+Shift+N</translation>
    </message>
    <message>
        <source>Forget the explored contour</source>
        <translation>探索した輪郭を破棄</translation>
    </message>
    <message>
        <source>Undo, redo: marks on the page Operate, edits on the pages Patterns and Calibrate</source>
        <translation>元に戻す、やり直す: 操作ページではマーク、パターンページとキャリブレーションページでは編集</translation>
    </message>
    <message>
        <source>STOP: everything that moves stops at once</source>
        <translation>STOP: 動いているものをすべて直ちに停止</translation>
    </message>
    <message>
        <source>Previous or next breakpoint; with Shift, add it to the selection</source>
        <translation>前または次のブレークポイント、Shiftで追加選択</translation>
    </message>
    <message>
        <source>Move the selection; without one, the playhead and the lane</source>
        <translation>選択したものを移動、選択がなければ再生ヘッドとレーンを移動</translation>
    </message>
    <message>
        <source>Loop start, loop end, no loop</source>
        <translation>ループの先頭、末尾、ループなし</translation>
    </message>
    <message>
        <source>Everywhere</source>
        <translation>どこでも</translation>
    </message>
    <message>
        <source>On the page Operate</source>
        <translation>操作ページ</translation>
    </message>
    <message>
        <source>In the playback bar</source>
        <translation>再生バー</translation>
    </message>
    <message>
        <source>On the page Patterns</source>
        <translation>パターンページ</translation>
    </message>
    <message>
        <source>In the timeline of a pattern</source>
        <translation>パターンのタイムライン</translation>
    </message>
    <message>
        <source>In pictures and charts</source>
        <translation>画像とグラフ</translation>
    </message>
    <message>
        <source>Ctrl+Alt+C</source>
        <translation>Ctrl+Alt+C</translation>
    </message>
    <message>
        <source>Release control of the site</source>
        <translation>サイトの操作権を手放す</translation>
    </message>
    <message>
        <source>Ctrl+,</source>
        <translation>Ctrl+,</translation>
    </message>
    <message>
        <source>Preferences</source>
        <translation>設定</translation>
    </message>
    <message>
        <source>Shift with Q W E R, A S D F</source>
        <translation>ShiftとQ W E R、A S D F</translation>
    </message>
    <message>
        <source>Move the arm, in Jog</source>
        <translation>アームを動かす（ジョグ）</translation>
    </message>
    <message>
        <source>Ctrl+Shift+M</source>
        <translation>Ctrl+Shift+M</translation>
    </message>
    <message>
        <source>Show one view alone, or all again; a double click on its title does the same</source>
        <translation>ビューを1つだけ表示、またはすべて表示に戻す。タイトルのダブルクリックでも同じ</translation>
    </message>
    <message>
        <source>Ctrl+W</source>
        <translation>Ctrl+W</translation>
    </message>
    <message>
        <source>Close the source that is shown</source>
        <translation>表示中のソースを閉じます</translation>
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
        <translation>ほかのプログラムが%1で再生しています。</translation>
    </message>
    <message>
        <source>it to be closed there first</source>
        <translation>先にそちらで閉じてください</translation>
    </message>
    <message>
        <source>The sound card %1 cannot be opened: %2</source>
        <translation>サウンドカード%1を開けません: %2</translation>
    </message>
    <message>
        <source>Other programs can play on %1 as well.</source>
        <translation>ほかのプログラムも%1で再生できます。</translation>
    </message>
    <message>
        <source>the card itself, as alsa:hw:CARD=NAME, or shared = true in the device file</source>
        <translation>alsa:hw:CARD=NAMEのようなカードそのもの、またはデバイスファイルのshared = true</translation>
    </message>
    <message>
        <source>The sound card takes none of the known formats.</source>
        <translation>サウンドカードは既知のどの形式も受け付けません。</translation>
    </message>
    <message>
        <source>The sound card does not play %1 samples a second.</source>
        <translation>サウンドカードは毎秒%1サンプルを再生できません。</translation>
    </message>
    <message>
        <source>another sample_rate_Hz in the device file</source>
        <translation>デバイスファイルの別のsample_rate_Hz</translation>
    </message>
    <message numerus="yes">
        <source>The sound card has %n output(s).</source>
        <translation>
            <numerusform>サウンドカードの出力は%n個です。</numerusform>
        </translation>
    </message>
    <message>
        <source>an output %1, as channels says</source>
        <translation>channelsが示す出力%1</translation>
    </message>
    <message>
        <source>The sound card does not take %1 samples at a time.</source>
        <translation>サウンドカードは一度に%1サンプルを受け付けません。</translation>
    </message>
    <message>
        <source>another period_frames in the device file</source>
        <translation>デバイスファイルの別のperiod_frames</translation>
    </message>
</context>
<context>
    <name>ArmChainText</name>
    <message>
        <source>interrupted</source>
        <translation>処理は途中で中断されました</translation>
    </message>
    <message>
        <source>nobody published %1 in domain %2 within %3 s</source>
        <translation>ドメイン %2 で%3 s以内に %1 を送信するものがありませんでした</translation>
    </message>
    <message>
        <source>a publisher that is reliable and transient local</source>
        <translation>reliableで、送信済みのデータを保持する送信側</translation>
    </message>
    <message>
        <source>the robot in this domain, or description = &quot;FILE.urdf&quot;</source>
        <translation>このドメインのロボット、または description = &quot;FILE.urdf&quot;</translation>
    </message>
    <message>
        <source>two joints of the arm have the ROS name &quot;%1&quot;</source>
        <translation>通信上の名前が「%1」の関節がアームに2つあります</translation>
    </message>
    <message>
        <source>a unique name for each joint in [joint_names]</source>
        <translation>各関節の名前が1回ずつの [joint_names]</translation>
    </message>
    <message>
        <source>the description gives no velocity limit for %1</source>
        <translation>記述に%1の速度がありません</translation>
    </message>
    <message>
        <source>[joint_names] names %1, which is not in the description</source>
        <translation>[joint_names] にある%1が記述にありません</translation>
    </message>
    <message>
        <source>effort_stop has %1 numbers, the arm has %2 joints</source>
        <translation>effort_stopの数値は%1個ですが、アームの関節は%2個です</translation>
    </message>
    <message>
        <source>effort_contains_gravity needs the mass of every link; %1 has none</source>
        <translation>effort_contains_gravityにはすべての質量が必要ですが、%1に質量がありません</translation>
    </message>
    <message>
        <source>the file requires %1, which is not monitored when the arm is driven directly</source>
        <translation>ファイルは%1を必要としますが、ここからは監視されません</translation>
    </message>
    <message>
        <source>MoveIt Servo compares stamps with the robot&apos;s clock, so only teleta-site sends commands to it</source>
        <translation>MoveIt Servoはスタンプをロボットの時計と比べるため、指令を送るのはteleta-siteだけです</translation>
    </message>
    <message>
        <source>force_stop_N needs a force sensor: wrench = &quot;FILE&quot; names the file of one</source>
        <translation>force_stop_Nには力センサーが必要です: wrench = &quot;ファイル&quot;でセンサーのファイルを指定します</translation>
    </message>
    <message>
        <source>the force sensor is in the frame %1, which the description does not have</source>
        <translation>力センサーの座標系%1は記述にありません</translation>
    </message>
    <message>
        <source>the force sensor must be in the domain of the arm, over the same interface</source>
        <translation>力センサーはアームと同じドメインで、同じインターフェイスを使う必要があります</translation>
    </message>
</context>
<context>
    <name>ArmCommand</name>
    <message>
        <source>no end</source>
        <translation>終端なし</translation>
    </message>
    <message>
        <source>not stated</source>
        <translation>記載なし</translation>
    </message>
    <message>
        <source>cannot be moved: the description states no speed</source>
        <translation>動かせません: 記述に速度がありません</translation>
    </message>
    <message>
        <source>Chain, limits and mass of an arm, and what cannot be moved</source>
        <translation>アームの運動連鎖、限界、質量と、動かせないもの</translation>
    </message>
    <message>
        <source>URDF file, or the name of one that comes with the program: %1</source>
        <translation>URDFファイル、またはプログラムに付属するものの名前: %1</translation>
    </message>
    <message>
        <source>Link that stands still; default: the root</source>
        <translation>静止しているリンク。デフォルト: ルート</translation>
    </message>
    <message>
        <source>Link that is moved; default: tool0, flange or ee_link, else the end of the longest chain</source>
        <translation>動かすリンク。デフォルト: tool0、flange、またはee_link。なければ最長の連鎖の終端</translation>
    </message>
    <message>
        <source>Joint</source>
        <translation>関節</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>種類</translation>
    </message>
    <message>
        <source>Range</source>
        <translation>範囲</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>Effort</source>
        <translation>トルク・力</translation>
    </message>
    <message>
        <source>shown, not moved</source>
        <translation>表示のみ、動かしません</translation>
    </message>
    <message>
        <source>follows %1</source>
        <translation>%1に従動</translation>
    </message>
    <message numerus="yes">
        <source>%1: %n joint(s) from %2 to %3</source>
        <translation>
            <numerusform>%1: %2から%3まで%n個の関節</numerusform>
        </translation>
    </message>
    <message>
        <source>The link &apos;%1&apos; has no mass, so the torque of gravity is not known.</source>
        <translation>リンク「%1」に質量がないため、重力によるトルクは不明です。</translation>
    </message>
    <message>
        <source>%1 kg are moved.</source>
        <translation>動く質量は%1 kgです。</translation>
    </message>
    <message>
        <source>Joint to move, as the URDF names it</source>
        <translation>動かす関節 (URDFでの名前)</translation>
    </message>
    <message>
        <source>Speed in rad/s, of a prismatic joint in m/s</source>
        <translation>速度 (rad/s)。直動関節ではm/s</translation>
    </message>
    <message>
        <source>Duration of the motion, at most %1</source>
        <translation>動かす時間。%1以下</translation>
    </message>
    <message>
        <source>Move without asking</source>
        <translation>確認せずに動かす</translation>
    </message>
    <message>
        <source>Show the description of a robot arm (URDF), or jog an arm</source>
        <translation>ロボットアーム: 記述 (URDF)、および関節の動作</translation>
    </message>
    <message>
        <source>Move a joint of an arm for a short time</source>
        <translation>アームの関節を短時間動かす</translation>
    </message>
    <message>
        <source>File that describes the arm (kind = &quot;ros_arm&quot;), or with which its site is reached (kind = &quot;remote_site&quot;)</source>
        <translation>アームを記述するファイル（kind = &quot;ros_arm&quot;）、またはそのサイトに接続するためのファイル（kind = &quot;remote_site&quot;）</translation>
    </message>
    <message>
        <source>Which arm of a site; default: its only one</source>
        <translation>サイトのどのアームか。既定：唯一のアーム</translation>
    </message>
</context>
<context>
    <name>ArmJogText</name>
    <message>
        <source>the arm cannot be moved: %1</source>
        <translation>アームを動かせません: %1</translation>
    </message>
    <message>
        <source>no joint states were received</source>
        <translation>関節の状態が届きませんでした</translation>
    </message>
    <message>
        <source>%1 moved %2 %3 in %4 s.</source>
        <translation>%1は%4 sで%2 %3動きました。</translation>
    </message>
    <message>
        <source>It was at rest %1 s after the command ended.</source>
        <translation>指令の終了から%1 s後に静止しました。</translation>
    </message>
    <message>
        <source>It was not seen to come to rest.</source>
        <translation>静止は確認されませんでした。</translation>
    </message>
    <message>
        <source>Active limits: %1.</source>
        <translation>作用した制限: %1。</translation>
    </message>
    <message>
        <source>there is no terminal to ask on; add --yes to move the arm</source>
        <translation>確認のための端末がない場合、アームを動かすには--yesが必要です</translation>
    </message>
    <message>
        <source>This moves %1 of %2 at %3 %4/s for %5 s. Type &quot;yes&quot; to move it: </source>
        <translation>%2の%1を%3 %4/sで%5 s動かします。動かすには&quot;yes&quot;と入力してください: </translation>
    </message>
    <message>
        <source>nothing was moved</source>
        <translation>何も動かしませんでした</translation>
    </message>
    <message>
        <source>the motion was cut short: %1</source>
        <translation>動作は途中で中断されました: %1</translation>
    </message>
</context>
<context>
    <name>ArmServoTexts</name>
    <message>
        <source>Follow a point</source>
        <translation>点の追従</translation>
    </message>
    <message>
        <source>Explore an edge</source>
        <translation>エッジの探索</translation>
    </message>
    <message>
        <source>Roll about a point</source>
        <translation>点まわりの転がし</translation>
    </message>
    <message>
        <source>Co-manipulation</source>
        <translation>協調操作</translation>
    </message>
    <message>
        <source>The next press is a rehearsal. Only a shadow of the arm moves, and the arm gets no command.</source>
        <translation>次の押下はリハーサルです。動くのはアームの影だけで、アームには指令が送られません。</translation>
    </message>
    <message>
        <source>REHEARSAL: the arm gets no command. Its shadow touches a ball that is assumed in front of the pad.</source>
        <translation>リハーサル: アームには指令が送られません。影は、パッドの前にあると仮定した球に触れます。</translation>
    </message>
    <message>
        <source>REHEARSAL: the arm gets no command. Its shadow touches an edge that is assumed in front of the pad.</source>
        <translation>リハーサル: アームには指令が送られません。影は、パッドの前にあると仮定したエッジに触れます。</translation>
    </message>
    <message>
        <source>Rehearsed. The next press MOVES THE ARM.</source>
        <translation>リハーサル済み。次の押下でアームが動きます。</translation>
    </message>
    <message>
        <source>THE ARM MOVES as long as you hold the switch.</source>
        <translation>ボタンを押している間、アームが動きます。</translation>
    </message>
    <message>
        <source>The rehearsal was too short to count.</source>
        <translation>リハーサルが短すぎて、数えられません。</translation>
    </message>
    <message>
        <source>Ended: STOP was engaged.</source>
        <translation>終了: STOP が作動しました。</translation>
    </message>
    <message>
        <source>Ended: the frames of the pad are old.</source>
        <translation>終了: パッドのフレームが古くなっています。</translation>
    </message>
    <message>
        <source>Ended: the arm took no commands: %1.</source>
        <translation>終了: アームが指令を受けませんでした: %1。</translation>
    </message>
    <message>
        <source>Ended: the contact was lost, and the search did not find it.</source>
        <translation>終了: 接触が失われ、探索でも見つかりませんでした。</translation>
    </message>
    <message>
        <source>Ended: nothing was touched within %1.</source>
        <translation>終了: %1 以内に何にも触れませんでした。</translation>
    </message>
    <message>
        <source>Ended: the pad went %1 into what it touches and felt less than half of the force.</source>
        <translation>終了: パッドが触れている物に %1 入り込みましたが、力は半分に満たないままでした。</translation>
    </message>
    <message>
        <source>Ended: the shadow could not follow.</source>
        <translation>終了: 影が追従できませんでした。</translation>
    </message>
    <message>
        <source>The task is done.</source>
        <translation>タスクが完了しました。</translation>
    </message>
    <message>
        <source>Ended: the joint readings are old or unusable.</source>
        <translation>終了: 関節の値が古いか使えません。</translation>
    </message>
    <message>
        <source>The arm was moved otherwise: rehearse the task again.</source>
        <translation>アームが別の方法で動かされました。もう一度リハーサルしてください。</translation>
    </message>
    <message>
        <source>The task was changed: rehearse it again.</source>
        <translation>タスクが変更されました。もう一度リハーサルしてください。</translation>
    </message>
    <message>
        <source>Ended: a joint is at the end of its range.</source>
        <translation>終了: 関節が可動範囲の端に達しました。</translation>
    </message>
    <message>
        <source>Ended: the commands came too late, or the arm took none.</source>
        <translation>終了: 指令が遅れて届いたか、アームが指令を受けませんでした。</translation>
    </message>
</context>
<context>
    <name>ArmWatch</name>
    <message>
        <source>--viewer with the file of a viewer</source>
        <translation>--viewer に閲覧者のファイル</translation>
    </message>
    <message>
        <source>this site has certificates, so a viewer with keys of its own has to watch the arm</source>
        <translation>このサイトは証明書を使うので、自分の鍵を持つ閲覧者がアームを監視する必要があります</translation>
    </message>
    <message>
        <source>no position of this joint was received within 5 s</source>
        <translation>5 秒以内にこの関節の位置を受信しませんでした</translation>
    </message>
    <message>
        <source>--joint with a joint that the arm reports</source>
        <translation>--joint に、アームが知らせる関節</translation>
    </message>
</context>
<context>
    <name>ArrayFramesText</name>
    <message>
        <source>the file has no arrays</source>
        <translation>ファイルに配列がありません</translation>
    </message>
    <message>
        <source>frames of an array</source>
        <translation>アレイのフレーム</translation>
    </message>
    <message>
        <source>there is no array %1; the file has: %2</source>
        <translation>配列%1がありません。ファイルにある配列: %2</translation>
    </message>
    <message>
        <source>one of these</source>
        <translation>これらのいずれか</translation>
    </message>
    <message>
        <source>no array can be frames; the file has: %1</source>
        <translation>フレームとして使える配列がありません。ファイルにある配列: %1</translation>
    </message>
    <message>
        <source>an array of 3 dimensions: frames x rows x columns</source>
        <translation>3次元の配列: フレーム x 行 x 列</translation>
    </message>
    <message>
        <source>the name of one (--array NAME)</source>
        <translation>いずれかの配列の名前 (--array NAME)</translation>
    </message>
    <message>
        <source>the array %1: %2</source>
        <translation>配列%1: %2</translation>
    </message>
    <message>
        <source>a time in s for each frame</source>
        <translation>フレームごとの時刻 (s)</translation>
    </message>
    <message>
        <source>time_s has the shape %1, the frames have %2</source>
        <translation>time_sの形状は%1ですが、フレームの形状は%2です</translation>
    </message>
    <message>
        <source>the array has %1 instead of %2 values</source>
        <translation>配列の値の数が%2ではなく%1です</translation>
    </message>
    <message>
        <source>a whole file</source>
        <translation>完全なファイル</translation>
    </message>
    <message>
        <source>a frame of the array</source>
        <translation>配列の1フレーム</translation>
    </message>
    <message>
        <source>a frame of %1 has %2 x %3 taxels</source>
        <translation>%1のフレームは%2 x %3タクセルです</translation>
    </message>
    <message>
        <source>from 1 to %1 rows and columns</source>
        <translation>1から%1までの行数と列数</translation>
    </message>
    <message>
        <source>the frames have %1 rows x %2 columns</source>
        <translation>フレームは%1行 x %2列です</translation>
    </message>
    <message>
        <source>%1 rows x %2 columns</source>
        <translation>%1行 x %2列</translation>
    </message>
    <message>
        <source>%1 has %2 taxels</source>
        <translation>%1のタクセル数は%2です</translation>
    </message>
    <message>
        <source>the file does not say when its frames were taken</source>
        <translation>ファイルにフレームの取得時刻がありません</translation>
    </message>
    <message>
        <source>frames per second (--rate HZ), or times in time_s</source>
        <translation>毎秒のフレーム数 (--rate HZ)、またはtime_sの時刻</translation>
    </message>
    <message>
        <source>the time of frame %1 is not a finite number</source>
        <translation>フレーム%1の時刻が有限の数値ではありません</translation>
    </message>
    <message>
        <source>a finite time in s</source>
        <translation>有限の時刻 (s)</translation>
    </message>
    <message>
        <source>the time goes back at frame %1, from %2 s to %3 s</source>
        <translation>フレーム%1で時刻が%2 sから%3 sに戻っています</translation>
    </message>
    <message>
        <source>times that do not decrease</source>
        <translation>減少しない時刻</translation>
    </message>
    <message>
        <source>an array of real numbers</source>
        <translation>実数の配列</translation>
    </message>
    <message>
        <source>the array has the shape %1</source>
        <translation>配列の形状は%1です</translation>
    </message>
    <message>
        <source>frames x rows x columns, or frames x taxels</source>
        <translation>フレーム x 行 x 列、またはフレーム x タクセル</translation>
    </message>
    <message>
        <source>the array is too large: %1</source>
        <translation>配列が大きすぎます: %1</translation>
    </message>
    <message>
        <source>at most %1 values</source>
        <translation>%1個以下の値</translation>
    </message>
    <message>
        <source>the recording has no frames</source>
        <translation>記録にフレームがありません</translation>
    </message>
    <message>
        <source>at least one frame</source>
        <translation>1つ以上のフレーム</translation>
    </message>
    <message>
        <source>time_s has %1 times for %2 frames</source>
        <translation>time_sの時刻は%1個ですが、フレームは%2個です</translation>
    </message>
    <message>
        <source>the file has times of its own, in time_s</source>
        <translation>ファイル自体に時刻 (time_s) があります</translation>
    </message>
    <message>
        <source>no rate</source>
        <translation>レートの指定なし</translation>
    </message>
    <message>
        <source>several arrays can be the frames: %1</source>
        <translation>フレームになり得る配列が複数あります：%1</translation>
    </message>
    <message>
        <source>%1 does not say which dimension is the frames</source>
        <translation>%1 はどの次元がフレームを数えるかを示していません</translation>
    </message>
    <message>
        <source>a frame of %1 has the shape %2 x %3</source>
        <translation>%1のフレームの形は%2 x %3です</translation>
    </message>
    <message>
        <source>%1 taxels x 3, as the layout has them</source>
        <translation>配置どおりの%1タクセル x 3</translation>
    </message>
    <message>
        <source>%1 rows x %2 columns, as the layout has them</source>
        <translation>配置どおりの%1行 x %2列</translation>
    </message>
    <message>
        <source>%1 can be a grid of 3 columns, or %2 taxels with x, y and z each</source>
        <translation>%1は3列の格子かもしれず、それぞれx、y、zを持つ%2個のタクセルかもしれません</translation>
    </message>
    <message>
        <source>%1 has %2 numbers</source>
        <translation>%1には%2個の数があります</translation>
    </message>
    <message>
        <source>%1, as the layout has them</source>
        <translation>配置どおりの%1個</translation>
    </message>
    <message>
        <source>the taxels have places of their own, in positions_m</source>
        <translation>タクセルには独自の場所があります（positions_m）</translation>
    </message>
    <message>
        <source>the file that says where the taxels are (--layout FILE.toml)</source>
        <translation>タクセルの場所を示すファイル（--layout FILE.toml）</translation>
    </message>
    <message>
        <source>a frame of the array has %1 numbers</source>
        <translation>配列のフレームには%1個の数があります</translation>
    </message>
    <message>
        <source>the layout with which the frames were recorded</source>
        <translation>フレームを記録したときの配置</translation>
    </message>
    <message>
        <source>positions_m has the shape %1, but the layout has %2 taxels</source>
        <translation>positions_mの形状は%1ですが、配置のタクセルは%2個です</translation>
    </message>
    <message>
        <source>positions_m has taxel %1 at %2 = %3 mm, the layout at %4 mm</source>
        <comment>a number, x, y or z, two places</comment>
        <translation>positions_mではタクセル%1は%2 = %3 mm、配置では%4 mmです</translation>
    </message>
    <message>
        <source>the dimension that counts the frames, the first or the last (--frame-axis), or a time_s for each frame</source>
        <translation>フレームを数える次元、最初または最後（--frame-axis）、もしくは各フレームのtime_s</translation>
    </message>
    <message>
        <source>for the grid, %1 rows and 3 columns (--rows %1 --columns 3); for vectors, the file that says where the taxels are (--layout FILE.toml)</source>
        <translation>格子なら%1行と3列（--rows %1 --columns 3）。ベクトルならタクセルの場所を示すファイル（--layout FILE.toml）</translation>
    </message>
    <message>
        <source>%1 = %2 rows x %3 columns, or others (--rows N --columns M)</source>
        <translation>%1 = %2行 x %3列、またはその他（--rows N --columns M）</translation>
    </message>
</context>
<context>
    <name>ArrayMessageText</name>
    <message>
        <source>a message has %1 numbers, the file has %2 x %3 taxels</source>
        <translation>メッセージには%1個の数がありますが、ファイルのタクセルは%2 x %3です</translation>
    </message>
    <message>
        <source>a message has %1 x %2 numbers, the file has %3 x %4 taxels</source>
        <translation>メッセージの数は%1 x %2ですが、ファイルのタクセルは%3 x %4です</translation>
    </message>
    <message>
        <source>a message has %1 bytes, its size says %2</source>
        <translation>メッセージは%1バイトですが、その大きさによれば%2です</translation>
    </message>
    <message>
        <source>a message has %1 sensors</source>
        <translation>メッセージには%1個のセンサーがあります</translation>
    </message>
    <message>
        <source>sensor = &quot;NAME&quot; in the file</source>
        <translation>ファイルにsensor = &quot;名前&quot;</translation>
    </message>
    <message>
        <source>a message has %1 dimensions</source>
        <translation>メッセージには%1個の次元があります</translation>
    </message>
    <message>
        <source>rows and columns</source>
        <translation>行と列</translation>
    </message>
    <message>
        <source>a message has the encoding &quot;%1&quot;</source>
        <translation>メッセージの符号化は「%1」です</translation>
    </message>
</context>
<context>
    <name>BakeText</name>
    <message>
        <source>the pattern has too many corners</source>
        <translation>パターンの折れ点が多すぎます</translation>
    </message>
    <message>
        <source>at most %1 breakpoints</source>
        <translation>ブレークポイント%1個以下</translation>
    </message>
</context>
<context>
    <name>BoardCorners</name>
    <message>
        <source>a whole chessboard of %1 x %2 inner corners, in focus and evenly lit</source>
        <translation>内側の角が%1 x %2個で、全体が写り、ピントが合い、均一に照らされたチェスボード</translation>
    </message>
    <message>
        <source>only %1 of the %2 corners of the chessboard are found</source>
        <translation>チェスボードの%2個の角のうち%1個しか見つかりません</translation>
    </message>
</context>
<context>
    <name>Bracelet</name>
    <message>
        <source>The connection to the bracelet was lost.</source>
        <translation>ブレスレットとの接続が切れました。</translation>
    </message>
    <message>
        <source>a feature report of layout version %1</source>
        <translation>レイアウトバージョン%1のフィーチャーレポート</translation>
    </message>
    <message>
        <source>Bracelet %1</source>
        <translation>ブレスレット %1</translation>
    </message>
    <message>
        <source>The device does not respond like a bracelet.</source>
        <translation>デバイスがブレスレットとして応答しません。</translation>
    </message>
</context>
<context>
    <name>BraceletContent</name>
    <message>
        <source>Participant</source>
        <translation>参加者</translation>
    </message>
    <message>
        <source>Condition</source>
        <translation>条件</translation>
    </message>
    <message>
        <source>Track</source>
        <translation>トラック</translation>
    </message>
    <message>
        <source>Best onset, ms</source>
        <translation>最良の開始間隔, ms</translation>
    </message>
    <message>
        <source>95 %</source>
        <translation>95 %</translation>
    </message>
    <message>
        <source>By the law, ms</source>
        <translation>法則による値, ms</translation>
    </message>
    <message>
        <source>What it says</source>
        <translation>内容</translation>
    </message>
    <message>
        <source>Time from burst to burst at which most answers are yes: the top of a parabola on the probit scale</source>
        <translation>「はい」が最も多くなるバースト間の時間。プロビット尺度での放物線の頂点です</translation>
    </message>
    <message>
        <source>By the delta method; of all participants Student&apos;s t of their best onsets</source>
        <translation>デルタ法による。全参加者では、最良の開始間隔のスチューデントのtによる</translation>
    </message>
    <message>
        <source>0.32 times the length of a burst + 47.3 ms, the law of apparent motion</source>
        <translation>バースト長の0.32倍 + 47.3 ms（仮現運動の法則）</translation>
    </message>
    <message>
        <source>nobody has a best onset</source>
        <translation>最良の開始間隔がある人はいません</translation>
    </message>
    <message>
        <source>fewer than three times were shown</source>
        <translation>提示した時間が3つ未満です</translation>
    </message>
    <message>
        <source>no onset is best: the answers have no top</source>
        <translation>最良の開始間隔はありません。回答に頂点がありません</translation>
    </message>
    <message>
        <source>best beyond the times that were shown</source>
        <translation>最良の時間は提示した範囲の外にあります</translation>
    </message>
    <message>
        <source>mean of %1</source>
        <translation>%1人の平均</translation>
    </message>
    <message>
        <source>later than the law says</source>
        <translation>法則より遅い</translation>
    </message>
    <message>
        <source>earlier than the law says</source>
        <translation>法則より早い</translation>
    </message>
    <message>
        <source>agrees with the law</source>
        <translation>法則と一致します</translation>
    </message>
    <message>
        <source>All</source>
        <translation>すべて</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>段数</translation>
    </message>
    <message>
        <source>Steps of one JND each from the start of the motors to their full drive. The JND is linear between the references, and stays as it is beyond them</source>
        <translation>モーターの始動から最大駆動量まで、1段が1つのJNDです。JNDは基準の間で直線的に変わり、外側では一定とします</translation>
    </message>
    <message>
        <source>by the mean JND of all</source>
        <translation>全員の平均のJNDによる</translation>
    </message>
    <message numerus="yes">
        <source>by the JND at %n reference(s)</source>
        <translation>
            <numerusform>%n個の基準でのJNDによる</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 of %2 references have a JND</source>
        <translation>%2個の基準のうち%1個にJNDがあります</translation>
    </message>
    <message>
        <source>Tactor</source>
        <translation>タクタ</translation>
    </message>
    <message>
        <source>Feels equal at</source>
        <translation>等しく感じるレベル</translation>
    </message>
    <message>
        <source>That is, drive</source>
        <translation>駆動に直すと</translation>
    </message>
    <message>
        <source>Full drive now</source>
        <translation>現在の最大駆動量</translation>
    </message>
    <message>
        <source>Full drive, balanced</source>
        <translation>釣り合わせた最大駆動量</translation>
    </message>
    <message>
        <source>Level at which it feels as strong as the reference</source>
        <translation>基準と同じ強さに感じるレベル</translation>
    </message>
    <message>
        <source>? stands for an open end</source>
        <translation>? は端が定まらないことを表します</translation>
    </message>
    <message>
        <source>Share of the full voltage, by the motor&apos;s start and full drive</source>
        <translation>全電圧に対する割合。モーターの始動と最大駆動量から求めます</translation>
    </message>
    <message>
        <source>Share of the full voltage at intensity 1</source>
        <translation>強度1での全電圧に対する割合</translation>
    </message>
    <message>
        <source>With it the tactors feel equally strong: the strongest ones are turned down</source>
        <translation>これでタクタが同じ強さに感じられます。最も強いものを弱めます</translation>
    </message>
    <message>
        <source>%1, the reference</source>
        <translation>%1（基準）</translation>
    </message>
    <message>
        <source>Measured against tactor %1, tactor %2 differs by more than both intervals allow.</source>
        <comment>a tactor; a list of tactors</comment>
        <translation>タクタ%1を基準に測ると、タクタ%2は両方の区間が許す以上に異なります。</translation>
    </message>
</context>
<context>
    <name>BraceletText</name>
    <message>
        <source>No bracelet is plugged in.</source>
        <translation>ブレスレットが接続されていません。</translation>
    </message>
    <message>
        <source>a USB device %1</source>
        <translation>USBデバイス %1</translation>
    </message>
    <message>
        <source>a USB device %1 with the serial number %2</source>
        <translation>USBデバイス %1 (シリアル番号 %2)</translation>
    </message>
    <message>
        <source>No permission to open the bracelet at %1.</source>
        <translation>%1 のブレスレットを開く権限がありません。</translation>
    </message>
    <message>
        <source>read and write access, which the udev rule grants</source>
        <translation>udevルールによる読み書きの権限</translation>
    </message>
    <message>
        <source>Another program uses the bracelet at %1.</source>
        <translation>%1 のブレスレットは別のプログラムが使用中です。</translation>
    </message>
    <message>
        <source>it to be closed there first</source>
        <translation>先にそのプログラムで閉じること</translation>
    </message>
    <message>
        <source>The bracelet at %1 cannot be opened.</source>
        <translation>%1 のブレスレットを開けません。</translation>
    </message>
</context>
<context>
    <name>BraceletTexts</name>
    <message>
        <source>STOP is engaged: the bracelet is off.</source>
        <translation>STOPが作動中です: ブレスレットはオフです。</translation>
    </message>
    <message>
        <source>No bracelet: what would be played is named in the table of patterns.</source>
        <translation>ブレスレットなし: 再生されるはずのパターンはパターン表に示されます。</translation>
    </message>
    <message>
        <source>Connecting to the bracelet…</source>
        <translation>ブレスレットに接続しています…</translation>
    </message>
    <message>
        <source>The bracelet is not connected. %1</source>
        <translation>ブレスレットに接続していません。%1</translation>
    </message>
    <message>
        <source>The bracelet does not answer.</source>
        <translation>ブレスレットが応答しません。</translation>
    </message>
    <message>
        <source>The bracelet is too hot: it is off until it has cooled down.</source>
        <translation>ブレスレットが熱すぎます。冷めるまで停止します。</translation>
    </message>
    <message>
        <source>A study uses the bracelet.</source>
        <translation>実験がブレスレットを使用中です。</translation>
    </message>
    <message>
        <source>The supply of the bracelet is low: %1 V.</source>
        <translation>ブレスレットの電源電圧が低下しています: %1 V。</translation>
    </message>
    <message>
        <source>The supply of the bracelet is low.</source>
        <translation>ブレスレットの電源電圧が低下しています。</translation>
    </message>
    <message>
        <source>The bracelet refused what was played last: it did not understand it.</source>
        <translation>ブレスレットは最後に再生したものを解釈できず、拒否しました。</translation>
    </message>
    <message>
        <source>The motors are not calibrated (page Calibrate).</source>
        <translation>モーターが未キャリブレーションです (キャリブレーションページ)。</translation>
    </message>
    <message>
        <source>too hot: off until it has cooled down</source>
        <translation>過熱: 冷めるまで停止</translation>
    </message>
    <message>
        <source>supply low</source>
        <translation>電源電圧低下</translation>
    </message>
    <message>
        <source>frames refused: %1</source>
        <translation>拒否されたフレーム: %1</translation>
    </message>
    <message>
        <source>supply %1 V</source>
        <translation>電源電圧 %1 V</translation>
    </message>
    <message>
        <source>temperature %1 °C</source>
        <translation>温度 %1 °C</translation>
    </message>
    <message>
        <source>Bracelet</source>
        <translation>ブレスレット</translation>
    </message>
    <message>
        <source>not calibrated: the motors are assumed</source>
        <translation>未キャリブレーション: モーターは仮定値です</translation>
    </message>
    <message>
        <source>confirmed: played by the callback of the sound card</source>
        <translation>確認済み: サウンドカードのコールバックが再生</translation>
    </message>
    <message>
        <source>latency at most %1 ms, as stated, not measured</source>
        <translation>遅延は最大%1 ms (申告値、測定値ではありません)</translation>
    </message>
    <message>
        <source>callback takes %1 % of a period, longest %2 %</source>
        <translation>コールバックは周期の%1 %、最長%2 %</translation>
    </message>
    <message>
        <source>periods missed: %1</source>
        <translation>逃した周期: %1</translation>
    </message>
    <message>
        <source>latency %1 ms, as measured</source>
        <translation>遅延は%1 ms (測定値)</translation>
    </message>
</context>
<context>
    <name>CalibrateCommand</name>
    <message>
        <source>Pairs</source>
        <translation>ペア</translation>
    </message>
    <message>
        <source>Kept</source>
        <translation>採用</translation>
    </message>
    <message>
        <source>3D to 2D</source>
        <translation>3Dから2D</translation>
    </message>
    <message>
        <source>%1 px on average, %2 px rms</source>
        <translation>平均 %1 px、rms %2 px</translation>
    </message>
    <message>
        <source>2D to 3D</source>
        <translation>2Dから3D</translation>
    </message>
    <message>
        <source>%1 mm on average</source>
        <translation>平均 %1 mm</translation>
    </message>
    <message>
        <source>Uncertainty</source>
        <translation>不確かさ</translation>
    </message>
    <message>
        <source>%1 mm of a point on the surface, by the camera alone</source>
        <translation>カメラのみによる表面上の点で %1 mm</translation>
    </message>
    <message>
        <source>Valid radius</source>
        <translation>有効半径</translation>
    </message>
    <message>
        <source>%1 px</source>
        <translation>%1 px</translation>
    </message>
    <message>
        <source>Focal lengths</source>
        <translation>焦点距離</translation>
    </message>
    <message>
        <source>%1, %2 px</source>
        <translation>%1, %2 px</translation>
    </message>
    <message>
        <source>Principal point</source>
        <translation>主点</translation>
    </message>
    <message>
        <source>Camera centre</source>
        <translation>カメラ中心</translation>
    </message>
    <message>
        <source>%1, %2, %3 m</source>
        <translation>%1, %2, %3 m</translation>
    </message>
    <message>
        <source>Mirrored</source>
        <translation>鏡像</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>はい</translation>
    </message>
    <message>
        <source>no</source>
        <translation>いいえ</translation>
    </message>
    <message>
        <source>Residuals</source>
        <translation>残差</translation>
    </message>
    <message>
        <source>without a pattern</source>
        <translation>規則性なし</translation>
    </message>
    <message>
        <source>Width of the image, px</source>
        <translation>画像の幅、px</translation>
    </message>
    <message>
        <source>Height of the image, px</source>
        <translation>画像の高さ、px</translation>
    </message>
    <message>
        <source>Radius of the elastomer, mm</source>
        <translation>エラストマーの半径、mm</translation>
    </message>
    <message>
        <source>Length of the elastomer, from z = 0 of the sensor frame, mm</source>
        <translation>エラストマーの長さ (センサー座標系の z = 0 から)、mm</translation>
    </message>
    <message>
        <source>robust: camera and lens, wrong pairs are left out; paper: linear, without a lens, drops pairs that are off by more than 2 mm</source>
        <translation>robust: カメラとレンズ、誤ったペアを除外。paper: 線形、レンズなし、2 mmを超えて外れたペアを除外</translation>
    </message>
    <message>
        <source>The points are holes of a shell: their x and y times this factor are on the elastomer (the paper&apos;s shell: 0.97)</source>
        <translation>点はシェルの穴です。x と y にこの係数を掛けるとエラストマー上の点になります (論文のシェル: 0.97)</translation>
    </message>
    <message>
        <source>The camera that was written has no lens: it is off by %1 mm on average over the pairs that it kept (%2 of %3).</source>
        <translation>書き込んだカメラにはレンズモデルがありません。残したペア (%3 個中 %2 個) で平均 %1 mm ずれています。</translation>
    </message>
    <message>
        <source>the camera is written to this file</source>
        <translation>このファイルにはカメラが書き込まれます</translation>
    </message>
    <message>
        <source>neighbours are alike: the camera does not explain everything in the pairs</source>
        <translation>隣どうしが似ています: このカメラで表せないものがペアに含まれています</translation>
    </message>
    <message>
        <source>Write each pair and its residual as CSV</source>
        <translation>各ペアとカメラによる計算結果をCSVに書き込む</translation>
    </message>
    <message>
        <source>Reliable</source>
        <translation>信頼性</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>警告</translation>
    </message>
    <message>
        <source>CSV with the columns u_px,v_px,x_m,y_m,z_m, at least 6 rows; with --plane a picture of a chessboard, or a picture or video of the gel at rest</source>
        <translation>列u_px,v_px,x_m,y_m,z_mを持つ6行以上のCSV。--planeではチェスボードの画像、または静止したゲルの画像か動画</translation>
    </message>
    <message>
        <source>Write the camera, or with --plane the lines for the sensor file, to this file</source>
        <translation>このファイルにカメラを書き込みます。--planeではセンサーファイルの行を書き込みます</translation>
    </message>
    <message>
        <source>a file is needed</source>
        <translation>ファイルが必要です</translation>
    </message>
    <message>
        <source>Camera and lens of a tactile cylinder, or the plane of a flat gel</source>
        <translation>触覚円筒のカメラとレンズ、または平らなゲルの面</translation>
    </message>
    <message>
        <source>this is for a tactile cylinder, not for --plane</source>
        <translation>これは触覚円筒用で、--planeには使えません</translation>
    </message>
</context>
<context>
    <name>Camera</name>
    <message>
        <source>camera %1 cannot be opened</source>
        <translation>カメラ %1 を開けません</translation>
    </message>
    <message>
        <source>the file does not exist</source>
        <translation>ファイルが存在しません</translation>
    </message>
    <message>
        <source>this is a folder</source>
        <translation>これはフォルダーです</translation>
    </message>
    <message>
        <source>a video, or the number of a camera</source>
        <translation>動画またはカメラの番号</translation>
    </message>
    <message>
        <source>a video, a pattern like frame_%04d.png, or the number of a camera</source>
        <translation>動画、frame_%04d.png のような連番パターン、またはカメラの番号</translation>
    </message>
    <message>
        <source>camera %1</source>
        <translation>カメラ%1</translation>
    </message>
    <message>
        <source>no frame arrived</source>
        <translation>フレームが届きません</translation>
    </message>
    <message>
        <source>the file is not a readable video</source>
        <translation>読み取り可能な動画ファイルではありません</translation>
    </message>
    <message>
        <source>this is a pipe</source>
        <translation>これはパイプです</translation>
    </message>
</context>
<context>
    <name>CameraPicture</name>
    <message>
        <source>Contact %1</source>
        <translation>接触 %1</translation>
    </message>
    <message>
        <source>at %1 along the tube, %2° around it</source>
        <translation>チューブに沿って %1、周方向 %2°</translation>
    </message>
    <message>
        <source>standard deviation %1</source>
        <translation>標準偏差 %1</translation>
    </message>
    <message>
        <source>moved %1 since it began</source>
        <translation>開始からの移動 %1</translation>
    </message>
    <message>
        <source>%1 deep</source>
        <translation>深さ %1</translation>
    </message>
    <message>
        <source>No picture yet</source>
        <translation>画像はまだありません</translation>
    </message>
    <message>
        <source>BUMP</source>
        <translation>衝突</translation>
    </message>
    <message>
        <source>followed</source>
        <translation>追従中</translation>
    </message>
    <message>
        <source>PAUSED</source>
        <translation>一時停止中</translation>
    </message>
    <message>
        <source>Displacement × %1</source>
        <translation>変位 × %1</translation>
    </message>
</context>
<context>
    <name>CameraText</name>
    <message>
        <source>a parameter is out of range</source>
        <translation>パラメーターが範囲外です</translation>
    </message>
    <message>
        <source>the focal lengths in K are not positive</source>
        <translation>Kの焦点距離が正ではありません</translation>
    </message>
    <message>
        <source>the cylinder has no length</source>
        <translation>円筒に長さがありません</translation>
    </message>
    <message>
        <source>this is not a camera matrix</source>
        <translation>カメラ行列ではありません</translation>
    </message>
    <message>
        <source>R is not a rotation</source>
        <translation>Rが回転行列ではありません</translation>
    </message>
    <message>
        <source>the distortion folds on the axis</source>
        <translation>歪みが光軸上ですでに折り返しています</translation>
    </message>
    <message>
        <source>this is not a camera file</source>
        <translation>カメラファイルではありません</translation>
    </message>
    <message>
        <source>the file was written by a newer version</source>
        <translation>ファイルのバージョンが新しすぎます</translation>
    </message>
    <message>
        <source>The camera stopped sending frames.</source>
        <translation>カメラからフレームが届かなくなりました。</translation>
    </message>
    <message>
        <source>this is not a covariance</source>
        <translation>これは共分散ではありません</translation>
    </message>
    <message>
        <source>a symmetric matrix without negative variances</source>
        <translation>負の分散のない対称行列</translation>
    </message>
</context>
<context>
    <name>CertificateText</name>
    <message>
        <source>SIGTERM, as when a session ends.</source>
        <translation>セッションの終了時と同じSIGTERM。</translation>
    </message>
    <message>
        <source>SIGINT, as by Ctrl-C.</source>
        <translation>Ctrl-Cと同じSIGINT。</translation>
    </message>
    <message>
        <source>SIGHUP, as when a terminal closes.</source>
        <translation>端末が閉じたときと同じSIGHUP。</translation>
    </message>
    <message>
        <source>SIGSTOP, later SIGCONT, as when the computer sleeps.</source>
        <translation>コンピューターのスリープと同様に、SIGSTOPの後にSIGCONT。</translation>
    </message>
    <message>
        <source>The line is cut and cannot be opened for a while.</source>
        <translation>回線が切断され、しばらく開けません。</translation>
    </message>
    <message>
        <source>The driver&apos;s answers are held back.</source>
        <translation>ドライバーの応答を遅らせます。</translation>
    </message>
    <message>
        <source>What the program sends does not arrive.</source>
        <translation>プログラムの送信したものが届きません。</translation>
    </message>
    <message>
        <source>The driver&apos;s answers are replaced by garbage, by refusals, or by answers to other requests.</source>
        <translation>ドライバーの応答を、無意味なデータ、拒否、または別の要求への応答に置き換えます。</translation>
    </message>
    <message>
        <source>STOP is engaged.</source>
        <translation>STOPを作動させます。</translation>
    </message>
    <message>
        <source>The recording can no longer grow; then STOP. Timed from STOP.</source>
        <translation>記録をそれ以上書き込めなくし、その後STOP。時間はSTOPから測ります。</translation>
    </message>
    <message>
        <source>The program gets no more memory; then STOP. Timed from STOP.</source>
        <translation>プログラムがそれ以上メモリを確保できなくし、その後STOP。時間はSTOPから測ります。</translation>
    </message>
    <message>
        <source>The wall clock is set an hour forward or back; then STOP. Timed from STOP.</source>
        <translation>システム時計を1時間ずらし、その後STOP。時間はSTOPから測ります。</translation>
    </message>
    <message>
        <source>No fault was injected.</source>
        <translation>障害は注入されませんでした。</translation>
    </message>
    <message>
        <source>Passed: after each of %1 faults the motors were at zero within %2 ms. They never restarted by themselves, and no recorded frame was lost. With 95 % confidence, at most %3 % of such faults take longer.</source>
        <translation>合格: %1件の障害のいずれの後も、モーターは%2 ms以内にゼロになりました。指示なしに動作が続いたことはなく、記録は何も失われませんでした。95 %の信頼度で、これより長くかかるのはこのような障害の%3 %以下です。</translation>
    </message>
    <message>
        <source>Not passed: of %1 faults, %2 left the motors on for more than %3 ms. After %4 of them the motors restarted by themselves. %5 recorded frames were lost, and %6 recordings were damaged.</source>
        <translation>不合格: %1件の障害のうち、%2件でモーターが%3 msを超えて動き続け、%4件で指示のない動作が後に続きました。失われたフレームは%5個、破損した記録は%6件です。</translation>
    </message>
    <message>
        <source>Time from the fault until the motors were at zero, in ms</source>
        <translation>障害からモーターがゼロになるまでの時間、ms</translation>
    </message>
    <message>
        <source>Fault</source>
        <translation>障害</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>件数</translation>
    </message>
    <message>
        <source>Median</source>
        <translation>中央値</translation>
    </message>
    <message>
        <source>99 %</source>
        <translation>99 %</translation>
    </message>
    <message>
        <source>Longest</source>
        <translation>最長</translation>
    </message>
    <message>
        <source>Over the bound</source>
        <translation>限界超過</translation>
    </message>
    <message>
        <source>Share, upper limit (%)</source>
        <translation>割合の上限 (%)</translation>
    </message>
    <message>
        <source>Restarted by itself</source>
        <translation>指示なしに動作を継続</translation>
    </message>
    <message>
        <source>Frames lost</source>
        <translation>フレーム損失</translation>
    </message>
    <message>
        <source>Files damaged</source>
        <translation>破損したファイル</translation>
    </message>
    <message>
        <source>All</source>
        <translation>すべて</translation>
    </message>
    <message>
        <source>Times until the motors were at zero, by kind of fault</source>
        <translation>種類ごとの、モーターがゼロになるまでの時間</translation>
    </message>
    <message>
        <source>Time until zero (ms)</source>
        <translation>ゼロまでの時間 (ms)</translation>
    </message>
    <message>
        <source>bound</source>
        <translation>限界</translation>
    </message>
    <message>
        <source>System under test</source>
        <translation>試験の対象</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>項目</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>プログラム</translation>
    </message>
    <message>
        <source>Driver of the motors</source>
        <translation>モータードライバー</translation>
    </message>
    <message>
        <source>%1 (SIMULATED)</source>
        <translation>%1 (シミュレーション)</translation>
    </message>
    <message>
        <source>Started</source>
        <translation>開始</translation>
    </message>
    <message>
        <source>System</source>
        <translation>システム</translation>
    </message>
    <message>
        <source>Processor</source>
        <translation>プロセッサー</translation>
    </message>
    <message numerus="yes">
        <source>%1, %n core(s)</source>
        <translation>
            <numerusform>%1、%nコア</numerusform>
        </translation>
    </message>
    <message>
        <source>Load average (1 min)</source>
        <translation>直近1分間の負荷</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>シード</translation>
    </message>
    <message>
        <source>Killed</source>
        <translation>強制終了</translation>
    </message>
    <message>
        <source>Terminated</source>
        <translation>終了要求</translation>
    </message>
    <message>
        <source>Interrupted</source>
        <translation>中断</translation>
    </message>
    <message>
        <source>Terminal closed</source>
        <translation>端末の終了</translation>
    </message>
    <message>
        <source>Put to sleep</source>
        <translation>スリープ</translation>
    </message>
    <message>
        <source>Unplugged</source>
        <translation>取り外し</translation>
    </message>
    <message>
        <source>Answers late</source>
        <translation>応答の遅延</translation>
    </message>
    <message>
        <source>Requests lost</source>
        <translation>要求の損失</translation>
    </message>
    <message>
        <source>Answers wrong</source>
        <translation>誤った応答</translation>
    </message>
    <message>
        <source>STOP</source>
        <translation>STOP</translation>
    </message>
    <message>
        <source>Disk full, STOP</source>
        <translation>ディスク満杯、STOP</translation>
    </message>
    <message>
        <source>Memory refused, STOP</source>
        <translation>メモリ確保の拒否、STOP</translation>
    </message>
    <message>
        <source>Clock set, STOP</source>
        <translation>時計の変更、STOP</translation>
    </message>
    <message>
        <source>SIMULATED: the driver of the motors is a program.</source>
        <translation>シミュレーション: モータードライバーはプログラムです。</translation>
    </message>
    <message>
        <source>Faults</source>
        <translation>障害</translation>
    </message>
    <message>
        <source>What each fault does</source>
        <translation>各障害の内容</translation>
    </message>
    <message>
        <source>en</source>
        <comment>language of the page, as BCP 47 has it</comment>
        <translation>ja</translation>
    </message>
    <message>
        <source>Certificate of faults</source>
        <translation>障害試験の証明書</translation>
    </message>
    <message>
        <source>The program is ended by SIGKILL. Only what watches over the device is left.</source>
        <translation>プログラムを SIGKILL で終了します。装置を見守るものだけが残ります。</translation>
    </message>
    <message>
        <source>Passed: after each of %1 faults the arm was at rest within %2 ms. It never moved again by itself. With 95 % confidence, at most %3 % of such faults take longer.</source>
        <translation>合格: %1 回の故障のそれぞれの後、アームは %2 ms 以内に静止しました。自分から再び動くことはありませんでした。95 % の信頼度で、これより長くかかる故障は多くとも %3 % です。</translation>
    </message>
    <message>
        <source>Not passed: of %1 faults, %2 left the arm moving for more than %3 ms. After %4 of them it moved again by itself.</source>
        <translation>不合格: %1 回の故障のうち %2 回で、アームは %3 ms より長く動き続けました。%4 回の後、自分から再び動きました。</translation>
    </message>
    <message>
        <source>Time from the fault until the arm was at rest, in ms</source>
        <translation>故障からアームが静止するまでの時間 (ms)</translation>
    </message>
    <message>
        <source>Times until the arm was at rest, by kind of fault</source>
        <translation>故障の種類ごとの、アームが静止するまでの時間</translation>
    </message>
    <message>
        <source>Time until rest (ms)</source>
        <translation>静止までの時間 (ms)</translation>
    </message>
    <message>
        <source>Arm</source>
        <translation>アーム</translation>
    </message>
    <message>
        <source>Longest gap between two readings</source>
        <translation>読み取りと読み取りの最長の間隔</translation>
    </message>
    <message>
        <source>SIMULATED: the arm is a program.</source>
        <translation>シミュレーション: アームはプログラムです。</translation>
    </message>
</context>
<context>
    <name>CertifyCommand</name>
    <message>
        <source>File of a Modbus motor driver over TCP; default: a simulated one. Nobody may wear its motors: they run the whole time</source>
        <translation>TCPで接続するModbusモータードライバーのファイル。既定値: シミュレーションのドライバー。モーターは終始回り続けるため、誰も装着してはいけません</translation>
    </message>
    <message>
        <source>Number of faults</source>
        <translation>障害の件数</translation>
    </message>
    <message>
        <source>Seed for the order and timing of the faults</source>
        <translation>障害の順序とタイミングのシード</translation>
    </message>
    <message>
        <source>Name of the report: NAME.html and NAME.json are written</source>
        <translation>レポートの保存先: NAME.htmlとNAME.json</translation>
    </message>
    <message>
        <source>the motors will run the whole time; make sure that nobody wears them, then add --yes</source>
        <translation>モーターは終始回り続けます。全員からモーターを外し、--yesを付けてください</translation>
    </message>
    <message>
        <source>the device has no motors</source>
        <translation>デバイスにモーターがありません</translation>
    </message>
    <message>
        <source>a table [tactors]</source>
        <translation>表 [tactors]</translation>
    </message>
    <message>
        <source>only a driver over TCP can be certified</source>
        <translation>回線の障害はTCP回線にのみ注入できます</translation>
    </message>
    <message>
        <source>The certificate was not passed.</source>
        <translation>証明書は不合格です。</translation>
    </message>
    <message>
        <source>The program under test follows a simulated array by live setpoints, drives the motors within their limits, and records.</source>
        <translation>試験対象のプログラムは、ライブ設定値によってシミュレーションアレイに追従し、上限の範囲内でモーターを駆動し、記録します。</translation>
    </message>
    <message>
        <source>The driver of the motors is SIMULATED: a Modbus server with a watchdog of 100 ms.</source>
        <translation>モータードライバーはシミュレーションです: 100 msのウォッチドッグを持つModbusサーバー。</translation>
    </message>
    <message>
        <source>A damaged recording was kept: %1</source>
        <translation>破損した記録を保存しました: %1</translation>
    </message>
    <message>
        <source>%1 faults: median %2, 99 % %3, longest %4 ms; %5 over the bound</source>
        <translation>障害%1件: 中央値 %2、99 % %3、最長 %4 ms。限界超過%5件</translation>
    </message>
    <message>
        <source>All</source>
        <translation>すべて</translation>
    </message>
    <message>
        <source>Restarted by itself</source>
        <translation>指示なしに動作を継続</translation>
    </message>
    <message>
        <source>Frames lost</source>
        <translation>フレーム損失</translation>
    </message>
    <message>
        <source>Files damaged</source>
        <translation>破損したファイル</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>レポート</translation>
    </message>
    <message>
        <source>File of an arm over ROS 2, which is certified instead. One of its joints moves to and fro the whole time; nobody may be within its reach</source>
        <translation>代わりに試験する ROS 2 のアームのファイル。関節の 1 つが試験の間ずっと往復します。届く範囲に人がいてはいけません</translation>
    </message>
    <message>
        <source>The same with an arm at a site: the file of a console that may move it</source>
        <translation>同じことをサイトのアームで行います。動かすことのできるコンソールのファイル</translation>
    </message>
    <message>
        <source>With --site: file of a viewer, which watches the arm. Default without certificates: the same file</source>
        <translation>--site と共に: アームを監視する閲覧者のファイル。既定値 (証明書なし): 同じファイル</translation>
    </message>
    <message>
        <source>With --site: the arm&apos;s name there; default: the only one</source>
        <translation>--site と共に: サイトでのアームの名前。既定値: ただ 1 つのアーム</translation>
    </message>
    <message>
        <source>With --arm and --site: joint that moves</source>
        <translation>--arm、--site と共に: 動く関節</translation>
    </message>
    <message>
        <source>Nobody wears the motors of --bracelet, or is within reach of the arm</source>
        <translation>--bracelet のモーターを誰も着けておらず、アームの届く範囲にも誰もいません</translation>
    </message>
    <message>
        <source>Longest time until the motors must be at zero or the arm at rest; default: %1, with an arm %2</source>
        <translation>モーターがゼロに、またはアームが静止しなければならない最長の時間。既定値: %1、アームでは %2</translation>
    </message>
    <message>
        <source>--joint is needed, the joint that moves to and fro</source>
        <translation>--joint が必要です。往復する関節です</translation>
    </message>
    <message>
        <source>%1 is no fault of an arm&apos;s chain</source>
        <translation>%1 はアームの系の故障ではありません</translation>
    </message>
    <message>
        <source>the arm will move the whole time; make sure that nobody is within its reach, then add --yes</source>
        <translation>アームは試験の間ずっと動きます。届く範囲に誰もいないことを確かめてから --yes を付けてください</translation>
    </message>
    <message>
        <source>The program under test moves %1 to and fro at %2 (rad/s, prismatic m/s). It has its own connection; the arm is watched over another one.</source>
        <translation>試験するプログラムは %1 を %2 (rad/s、直動は m/s) で往復させます。プログラムは自分の接続を持ち、アームは別の接続で監視されます。</translation>
    </message>
    <message>
        <source>Ended early: %1 of %2 faults were injected.</source>
        <translation>途中で終わりました。%2 回のうち %1 回の故障を与えました。</translation>
    </message>
    <message>
        <source>Not covered: faults of the network, of the site and of the arm&apos;s controller.</source>
        <translation>対象外: ネットワーク、サイト、アームのコントローラーの故障。</translation>
    </message>
    <message>
        <source>Not covered: bracelets that are not Modbus drivers over TCP.</source>
        <translation>対象外: TCP 経由の Modbus ドライバーではないブレスレット。</translation>
    </message>
    <message>
        <source>With --arm and --site: its speed in rad/s, prismatic m/s. It turns back after half a second of motion to each side</source>
        <translation>--arm、--site と共に: 関節の速さ (rad/s、直動は m/s)。両側へ 0.5 秒動くと折り返します</translation>
    </message>
    <message>
        <source>Kinds of faults, separated by commas: %1. Default: all but clock_step, which sets the clock of this computer; for an arm, also without faults of the line and of the recording</source>
        <translation>コンマで区切った故障の種類: %1。既定値: このコンピューターの時計を変える clock_step 以外のすべて。アームでは回線と記録の故障も除きます</translation>
    </message>
    <message>
        <source>Inject faults into the program that drives motors or an arm, and report how soon they stop</source>
        <translation>モーターやアームを動かすプログラムに故障を与え、止まるまでの時間を報告します</translation>
    </message>
</context>
<context>
    <name>ChainText</name>
    <message>
        <source>the robot has no link &apos;%1&apos;</source>
        <translation>ロボットにリンク「%1」がありません</translation>
    </message>
    <message>
        <source>one of %1</source>
        <translation>次のいずれか: %1</translation>
    </message>
    <message>
        <source>the link &apos;%1&apos; does not hang on &apos;%2&apos;</source>
        <translation>リンク「%1」は「%2」につながっていません</translation>
    </message>
    <message>
        <source>a base from which joints lead to the tip</source>
        <translation>関節を介して先端に至るベース</translation>
    </message>
    <message>
        <source>no joint between &apos;%1&apos; and &apos;%2&apos; moves</source>
        <translation>「%1」と「%2」の間に動く関節がありません</translation>
    </message>
    <message>
        <source>at least one revolute, continuous or prismatic joint</source>
        <translation>1つ以上の回転 (revolute)、連続回転 (continuous)、または直動 (prismatic) 関節</translation>
    </message>
    <message>
        <source>%1 joints move the tip</source>
        <translation>先端を動かす関節が%1個あります</translation>
    </message>
    <message>
        <source>at most %1</source>
        <translation>%1以下</translation>
    </message>
    <message>
        <source>a joint that moves &apos;%1&apos; moves the tip as well</source>
        <translation>「%1」を動かす関節が先端も動かします</translation>
    </message>
    <message>
        <source>a base that stands still while the tip moves</source>
        <translation>先端が動いても静止しているベース</translation>
    </message>
</context>
<context>
    <name>ChannelServo</name>
    <message>
        <source>the arm has no pad on a link</source>
        <translation>アームのリンクにパッドがありません</translation>
    </message>
    <message>
        <source>a recording is played, and nothing can be moved</source>
        <translation>記録の再生中は何も動かせません</translation>
    </message>
    <message>
        <source>the pad is not calibrated: its loads are not in N</source>
        <translation>パッドが校正されていません。荷重の単位が N ではありません</translation>
    </message>
</context>
<context>
    <name>ChartText</name>
    <message>
        <source>correct answers</source>
        <translation>正答</translation>
    </message>
    <message>
        <source>correct, %</source>
        <translation>正答、%</translation>
    </message>
    <message>
        <source>chance</source>
        <translation>チャンスレベル</translation>
    </message>
    <message>
        <source>correct answers by pattern</source>
        <translation>パターン別の正答</translation>
    </message>
    <message>
        <source>response times</source>
        <translation>応答時間</translation>
    </message>
    <message>
        <source>median of correct answers, s</source>
        <translation>正答の中央値、s</translation>
    </message>
    <message>
        <source>information transfer</source>
        <translation>情報伝達量</translation>
    </message>
    <message>
        <source>bit</source>
        <translation>bit</translation>
    </message>
    <message>
        <source>all patterns told apart</source>
        <translation>全パターンを識別</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>測定値</translation>
    </message>
    <message>
        <source>less bias</source>
        <translation>バイアス除去後</translation>
    </message>
</context>
<context>
    <name>CliSiteText</name>
    <message>
        <source>no site was found in domain %1</source>
        <translation>ドメイン %1 にサイトは見つかりませんでした</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>記録</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>長さ</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 秒</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>フレーム</translation>
    </message>
    <message>
        <source>Dropped here</source>
        <translation>ここでの欠落</translation>
    </message>
</context>
<context>
    <name>ClickListener</name>
    <message>
        <source>Inputs of ALSA cannot be listened to.</source>
        <translation>ALSAの入力は聞き取れません。</translation>
    </message>
    <message>
        <source>device = &quot;pipewire&quot; or &quot;jack&quot; in the device file</source>
        <translation>デバイスファイルのdevice = &quot;pipewire&quot;または&quot;jack&quot;</translation>
    </message>
    <message>
        <source>The sound server does not answer.</source>
        <translation>サウンドサーバーが応答しません。</translation>
    </message>
    <message>
        <source>There is no sound input &quot;%1&quot;.</source>
        <translation>サウンド入力「%1」がありません。</translation>
    </message>
    <message>
        <source>an input; there is none</source>
        <translation>入力 (1つもありません)</translation>
    </message>
    <message>
        <source>one of: %1</source>
        <translation>次のいずれか: %1</translation>
    </message>
    <message>
        <source>The sound server refused to create an input.</source>
        <translation>サウンドサーバーが入力を用意しません。</translation>
    </message>
    <message>
        <source>The input &quot;%1&quot; cannot be connected.</source>
        <translation>入力「%1」を接続できません。</translation>
    </message>
</context>
<context>
    <name>ComparisonContent</name>
    <message>
        <source>Effect</source>
        <translation>効果</translation>
    </message>
    <message>
        <source>Pattern</source>
        <translation>パターン</translation>
    </message>
    <message>
        <source>Pair</source>
        <translation>ペア</translation>
    </message>
    <message>
        <source>n</source>
        <translation>n</translation>
    </message>
    <message>
        <source>Difference %</source>
        <translation>差 %</translation>
    </message>
    <message>
        <source>95 %</source>
        <translation>95 %</translation>
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
        <translation>d_z 95 %</translation>
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
        <translation>メモ</translation>
    </message>
    <message>
        <source>A comparison of the conditions for this pattern alone</source>
        <translation>このパターンのみでの条件の比較</translation>
    </message>
    <message>
        <source>The first minus the second</source>
        <translation>1つ目から2つ目を引いた値</translation>
    </message>
    <message>
        <source>Participants with both values</source>
        <translation>両方の値がある参加者</translation>
    </message>
    <message>
        <source>Of the difference, not corrected</source>
        <translation>差の区間、補正なし</translation>
    </message>
    <message>
        <source>Paired t test</source>
        <translation>対応のあるt検定</translation>
    </message>
    <message>
        <source>Corrected over all pairs of the effect; over all patterns where the conditions are compared within them</source>
        <translation>効果の全ペアにわたる補正。条件をパターン内で比較する場合は全パターンにわたる補正</translation>
    </message>
    <message>
        <source>Difference over the standard deviation of the differences</source>
        <translation>差を、差の標準偏差で割った値</translation>
    </message>
    <message>
        <source>From the noncentral t distribution, not corrected</source>
        <translation>非心t分布による、補正なし</translation>
    </message>
    <message>
        <source>Difference over the mean standard deviation of the two</source>
        <translation>差を、両者の標準偏差の平均で割った値</translation>
    </message>
    <message>
        <source>d_z with Hedges&apos; correction</source>
        <translation>Hedgesの補正を施したd_z</translation>
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
        <translation>正の差の順位和</translation>
    </message>
    <message>
        <source>Sum of the ranks of negative differences</source>
        <translation>負の差の順位和</translation>
    </message>
    <message>
        <source>Wilcoxon&apos;s signed rank test with Pratt&apos;s zeros; exact up to 25 differences</source>
        <translation>Wilcoxonの符号付き順位検定、ゼロはPrattの方法。差が25個までは正確</translation>
    </message>
    <message>
        <source>Corrected over all pairs of the effect</source>
        <translation>効果の全ペアにわたる補正</translation>
    </message>
    <message>
        <source>Rank-biserial correlation</source>
        <translation>順位双列相関</translation>
    </message>
    <message>
        <source>partial eta²</source>
        <translation>偏eta²</translation>
    </message>
    <message>
        <source>Friedman χ²</source>
        <translation>Friedman χ²</translation>
    </message>
    <message>
        <source>df</source>
        <translation>df</translation>
    </message>
    <message>
        <source>Kendall&apos;s W</source>
        <translation>KendallのW</translation>
    </message>
    <message>
        <source>From the noncentral F distribution; only with sphericity, eps GG at least 0.75</source>
        <translation>非心F分布による。球面性が成り立つ場合 (eps GGが0.75以上) のみ</translation>
    </message>
    <message>
        <source>By ranks, of three levels and more</source>
        <translation>順位による、3水準以上</translation>
    </message>
    <message>
        <source>Of Friedman&apos;s test</source>
        <translation>Friedman検定の値</translation>
    </message>
    <message>
        <source>Concordance of the participants</source>
        <translation>参加者間の一致度</translation>
    </message>
    <message>
        <source>Term</source>
        <translation>項</translation>
    </message>
    <message>
        <source>Estimate</source>
        <translation>推定値</translation>
    </message>
    <message>
        <source>SE</source>
        <translation>SE</translation>
    </message>
    <message>
        <source>Odds ratio</source>
        <translation>オッズ比</translation>
    </message>
    <message>
        <source>Logit of a right answer</source>
        <translation>正答のロジット</translation>
    </message>
    <message>
        <source>Wald&apos;s interval</source>
        <translation>Wald区間</translation>
    </message>
    <message>
        <source>intercept (%1)</source>
        <translation>切片 (%1)</translation>
    </message>
    <message>
        <source>A model of single answers needs at least 5 participants.</source>
        <translation>個々の回答のモデルには5名以上の参加者が必要です。</translation>
    </message>
    <message>
        <source>No model of single answers: under one condition all answers are right, or all wrong, so that its effect has no finite estimate.</source>
        <translation>個々の回答のモデルはありません: ある条件ですべての回答が正答、またはすべて誤答のため、その効果の推定値が有限になりません。</translation>
    </message>
    <message>
        <source>No model of single answers: the search has found no maximum.</source>
        <translation>個々の回答のモデルはありません: 探索で最大値が見つかりませんでした。</translation>
    </message>
    <message>
        <source>Each participant has an own intercept, with a standard deviation of %1.</source>
        <translation>参加者ごとに固有の切片があり、その標準偏差は%1です。</translation>
    </message>
    <message>
        <source>The participants do not differ more than chance makes them.</source>
        <translation>参加者間の差は偶然による程度を超えません。</translation>
    </message>
    <message>
        <source>Conditions: likelihood ratio χ²(%1) = %2, p %3.</source>
        <translation>条件: 尤度比 χ²(%1) = %2、p %3。</translation>
    </message>
    <message>
        <source>Ratio</source>
        <translation>比</translation>
    </message>
    <message>
        <source>The first divided by the second</source>
        <translation>1つ目を2つ目で割った値</translation>
    </message>
    <message>
        <source>Participants with times under both</source>
        <translation>両方の条件で時間がある参加者</translation>
    </message>
    <message>
        <source>Of the geometric means of the response times of right answers</source>
        <translation>正答の応答時間の幾何平均による</translation>
    </message>
    <message>
        <source>Paired t test of the mean logarithms</source>
        <translation>対数の平均の対応のあるt検定</translation>
    </message>
    <message>
        <source>Right answers given within a time</source>
        <translation>時間内に与えられた正答</translation>
    </message>
    <message>
        <source>s from the onset</source>
        <translation>開始からの時間、s</translation>
    </message>
    <message>
        <source>answered, %</source>
        <translation>回答済み、%</translation>
    </message>
    <message>
        <source>Rule</source>
        <translation>規則</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>値</translation>
    </message>
    <message>
        <source>Made</source>
        <translation>作成時期</translation>
    </message>
    <message>
        <source>Trials before</source>
        <translation>適用前の試行数</translation>
    </message>
    <message>
        <source>Trials</source>
        <translation>試行数</translation>
    </message>
    <message>
        <source>Sessions</source>
        <translation>セッション数</translation>
    </message>
    <message>
        <source>Participants</source>
        <translation>参加者数</translation>
    </message>
    <message>
        <source>Before the data, in the protocol, or after them</source>
        <translation>データ取得前、プロトコル内、またはデータ取得後</translation>
    </message>
    <message>
        <source>What the rules before have left</source>
        <translation>前の規則の適用後に残ったもの</translation>
    </message>
    <message>
        <source>Left out</source>
        <translation>除外</translation>
    </message>
    <message>
        <source>Left out as a whole</source>
        <translation>全体として除外</translation>
    </message>
    <message numerus="yes">
        <source>no spread of the times in %n case(s): nothing left out</source>
        <translation>
            <numerusform>時間のばらつきがない場合が%n件: 何も除外していません</numerusform>
        </translation>
    </message>
    <message>
        <source>in the file</source>
        <translation>ファイル内</translation>
    </message>
    <message>
        <source>after the data</source>
        <translation>データ取得後</translation>
    </message>
    <message>
        <source>before the data</source>
        <translation>データ取得前</translation>
    </message>
    <message>
        <source>Condition or effect</source>
        <translation>条件または効果</translation>
    </message>
    <message>
        <source>Right %</source>
        <translation>正答 %</translation>
    </message>
    <message>
        <source>Right % without rules</source>
        <translation>規則なしの正答 %</translation>
    </message>
    <message>
        <source>p GG</source>
        <translation>p GG</translation>
    </message>
    <message>
        <source>p GG without rules</source>
        <translation>規則なしのp GG</translation>
    </message>
</context>
<context>
    <name>ComparisonText</name>
    <message>
        <source>Pairs of levels, paired t tests of the shares of correct answers. Holm: corrected over all pairs of the effect. The intervals (95 %) are not corrected</source>
        <translation>水準のペア、正答率の対応のあるt検定。Holm: 効果の全ペアにわたる補正。区間 (95 %) は補正なし</translation>
    </message>
    <message>
        <source>Effect</source>
        <translation>効果</translation>
    </message>
    <message>
        <source>Pair</source>
        <translation>ペア</translation>
    </message>
    <message>
        <source>Participants</source>
        <translation>参加者数</translation>
    </message>
    <message>
        <source>Difference, %</source>
        <translation>差、%</translation>
    </message>
    <message>
        <source>Interval, %</source>
        <translation>区間、%</translation>
    </message>
    <message>
        <source>p, Holm</source>
        <translation>p、Holm</translation>
    </message>
    <message>
        <source>Interval</source>
        <translation>区間</translation>
    </message>
    <message>
        <source>Remark</source>
        <translation>備考</translation>
    </message>
    <message>
        <source>The same pairs by ranks: Wilcoxon&apos;s signed rank test with Pratt&apos;s zeros, exact up to 25 differences</source>
        <translation>同じペアの順位による比較: Wilcoxonの符号付き順位検定、ゼロはPrattの方法、差が25個までは正確</translation>
    </message>
    <message>
        <source>Rank-biserial r</source>
        <translation>順位双列相関 r</translation>
    </message>
    <message>
        <source>Friedman&apos;s test of effects with three levels and more</source>
        <translation>3水準以上の効果のFriedman検定</translation>
    </message>
    <message>
        <source>df</source>
        <translation>df</translation>
    </message>
    <message>
        <source>Kendall&apos;s W</source>
        <translation>KendallのW</translation>
    </message>
    <message>
        <source>Partial η² with its interval (95 %), where sphericity holds (ε GG at least 0.75)</source>
        <translation>偏η²とその区間 (95 %)、球面性が成り立つ場合 (ε GGが0.75以上)</translation>
    </message>
    <message>
        <source>Model of single answers</source>
        <translation>個々の回答のモデル</translation>
    </message>
    <message>
        <source>There are no numbers: %1.</source>
        <translation>数値はありません: %1。</translation>
    </message>
    <message>
        <source>Logit of a correct answer: an intercept that differs between participants, and the conditions against %1; Wald&apos;s intervals (95 %)</source>
        <translation>正答のロジット: 参加者ごとに異なる切片と、%1に対する各条件。Wald区間 (95 %)</translation>
    </message>
    <message>
        <source>Term</source>
        <translation>項</translation>
    </message>
    <message>
        <source>Estimate</source>
        <translation>推定値</translation>
    </message>
    <message>
        <source>SE</source>
        <translation>SE</translation>
    </message>
    <message>
        <source>Odds ratio</source>
        <translation>オッズ比</translation>
    </message>
    <message>
        <source>intercept (%1)</source>
        <translation>切片 (%1)</translation>
    </message>
    <message>
        <source>Standard deviation of the participants: %1.</source>
        <translation>参加者の標準偏差: %1。</translation>
    </message>
    <message>
        <source>The participants do not differ more than chance makes them.</source>
        <translation>参加者間の差は偶然による程度を超えません。</translation>
    </message>
    <message>
        <source>Conditions: likelihood ratio χ²(%1) = %2, p %3.</source>
        <translation>条件: 尤度比 χ²(%1) = %2、p %3。</translation>
    </message>
    <message>
        <source>Comparisons and effect sizes</source>
        <translation>比較と効果量</translation>
    </message>
    <message>
        <source>response times, cumulative</source>
        <translation>応答時間、累積</translation>
    </message>
    <message>
        <source>time from the onset, s</source>
        <translation>開始からの時間、s</translation>
    </message>
    <message>
        <source>answered, %</source>
        <translation>回答済み、%</translation>
    </message>
    <message>
        <source>Share of the correct answers of all participants that were given within a time.</source>
        <translation>全参加者の正答のうち、ある時間内に与えられたものの割合。</translation>
    </message>
    <message>
        <source>Conditions compared by the participants&apos; geometric means: how many times as long the first takes; paired t tests of the logarithms</source>
        <translation>参加者の幾何平均による条件の比較: 1つ目にかかる時間が何倍か。対数の対応のあるt検定</translation>
    </message>
    <message>
        <source>Ratio</source>
        <translation>比</translation>
    </message>
</context>
<context>
    <name>ConfusionPicture</name>
    <message>
        <source>answered, % of the row</source>
        <translation>回答、行の%</translation>
    </message>
    <message>
        <source>answered</source>
        <translation>回答</translation>
    </message>
    <message>
        <source>presented</source>
        <translation>提示</translation>
    </message>
</context>
<context>
    <name>ConsoleOptions</name>
    <message>
        <source>--%1 %2: expected a number from %3 to %4</source>
        <translation>--%1 %2: %3から%4までの数値が必要です</translation>
    </message>
    <message>
        <source>--%1 %2: expected a whole number from %3 to %4</source>
        <translation>--%1 %2: %3から%4までの整数が必要です</translation>
    </message>
    <message>
        <source>FILE</source>
        <translation>FILE</translation>
    </message>
    <message>
        <source>Seed of the simulated scenes (default 1).</source>
        <translation>シミュレーションシーンのシード (既定値1)。</translation>
    </message>
    <message>
        <source>N</source>
        <translation>N</translation>
    </message>
    <message>
        <source>Rows of the array (default: by the number of taxels).</source>
        <translation>アレイの行数 (既定値: タクセル数から決定)。</translation>
    </message>
    <message>
        <source>Columns of the array.</source>
        <translation>アレイの列数。</translation>
    </message>
    <message>
        <source>Distance between taxels in mm.</source>
        <translation>タクセルの間隔 (mm)。</translation>
    </message>
    <message>
        <source>MM</source>
        <translation>MM</translation>
    </message>
    <message>
        <source>Recording of the unloaded array, subtracted from the frames.</source>
        <translation>無荷重アレイの記録。フレームから差し引きます。</translation>
    </message>
    <message>
        <source>The values fall under load.</source>
        <translation>荷重がかかると値が下がります。</translation>
    </message>
    <message>
        <source>Load per raw unit (default 1).</source>
        <translation>生の値1単位あたりの荷重 (既定値1)。</translation>
    </message>
    <message>
        <source>G</source>
        <translation>G</translation>
    </message>
    <message>
        <source>Unit of the loads (default N or counts, by the array).</source>
        <translation>荷重の単位 (既定値はアレイに応じてNまたはカウント)。</translation>
    </message>
    <message>
        <source>NAME</source>
        <translation>NAME</translation>
    </message>
    <message>
        <source>Load from which a taxel is in contact (default 0.2).</source>
        <translation>タクセルが接触とみなされる荷重 (既定値0.2)。</translation>
    </message>
    <message>
        <source>LOAD</source>
        <translation>LOAD</translation>
    </message>
    <message>
        <source>Play at this rate in Hz instead of the recorded times.</source>
        <translation>記録された時刻の代わりに、このレート (Hz) で再生します。</translation>
    </message>
    <message>
        <source>HZ</source>
        <translation>HZ</translation>
    </message>
    <message>
        <source>Open the sources listed in a TOML file.</source>
        <translation>TOMLファイルに列挙されたソースを開きます。</translation>
    </message>
    <message>
        <source>Page to show: %1.</source>
        <translation>表示するページ: %1。</translation>
    </message>
    <message>
        <source>light, dark or system.</source>
        <translation>light、dark、またはsystem。</translation>
    </message>
    <message>
        <source>Language, for example en, ja, fr, zh_CN.</source>
        <translation>言語。例: en, ja, fr, zh_CN。</translation>
    </message>
    <message>
        <source>CODE</source>
        <translation>CODE</translation>
    </message>
    <message>
        <source>Save a picture of the window as PNG and quit.</source>
        <translation>ウィンドウの画像をPNGで保存して終了します。</translation>
    </message>
    <message>
        <source>Seconds to wait before the picture (default 3).</source>
        <translation>画像を保存するまでの待ち時間 (秒、既定値3)。</translation>
    </message>
    <message>
        <source>S</source>
        <translation>S</translation>
    </message>
    <message>
        <source>Size of the window, for example 1600x1000.</source>
        <translation>ウィンドウのサイズ。例: 1600x1000。</translation>
    </message>
    <message>
        <source>WxH</source>
        <translation>WxH</translation>
    </message>
    <message>
        <source>Run for so many seconds, print how long the event loop was busy, quit.</source>
        <translation>指定した秒数だけ実行し、イベントループの使用時間を表示して終了します。</translation>
    </message>
    <message>
        <source>Start with the default layout and settings, and save none.</source>
        <translation>既定のレイアウトと設定で起動し、何も保存しません。</translation>
    </message>
    <message>
        <source>unexpected argument &quot;%1&quot;</source>
        <translation>予期しない引数「%1」</translation>
    </message>
    <message>
        <source>--page %1: expected one of %2</source>
        <translation>--page %1: 次のいずれかが必要です: %2</translation>
    </message>
    <message>
        <source>--theme %1: expected light, dark or system</source>
        <translation>--theme %1: light、dark、systemのいずれかが必要です</translation>
    </message>
    <message>
        <source>--size %1: expected WIDTHxHEIGHT, from 320x240 to 16384x16384</source>
        <translation>--size %1: 320x240から16384x16384までのWIDTHxHEIGHTが必要です</translation>
    </message>
    <message>
        <source>--dock %1: expected one of %2</source>
        <translation>--dock %1: 次のいずれかが必要です: %2</translation>
    </message>
    <message>
        <source>Open a simulated scene: a file, or the name of one that comes with the program (repeatable).</source>
        <translation>シミュレーションシーンを開きます: ファイル、または付属シーンの名前 (繰り返し指定可)。</translation>
    </message>
    <message>
        <source>SCENE</source>
        <translation>SCENE</translation>
    </message>
    <message>
        <source>Open a camera in the soft tube by its number, or a video of one.</source>
        <translation>ソフトチューブ内のカメラを番号で、またはその動画を開きます。</translation>
    </message>
    <message>
        <source>FILE|N</source>
        <translation>FILE|N</translation>
    </message>
    <message>
        <source>Calibration of that camera (JSON of teleta calibrate).</source>
        <translation>そのカメラのキャリブレーション (teleta calibrateのJSON)。</translation>
    </message>
    <message>
        <source>Open a pattern file, or a built-in pattern by its id, on the Patterns page.</source>
        <translation>パターンページで、パターンファイルまたは組み込みパターン (id指定) を開きます。</translation>
    </message>
    <message>
        <source>Folder of your own patterns (default: the user&apos;s data folder).</source>
        <translation>自作パターンのフォルダー (既定値: ユーザーのデータフォルダー)。</translation>
    </message>
    <message>
        <source>FOLDER</source>
        <translation>FOLDER</translation>
    </message>
    <message>
        <source>View of the Operate page (%1) or of the Study page (%2) to bring to the front.</source>
        <translation>前面に表示する操作ページのビュー (%1) または実験ページのビュー (%2)。</translation>
    </message>
    <message>
        <source>Calibrate the cylinder camera with these pairs (CSV).</source>
        <translation>これらのペア (CSV) で円筒カメラをキャリブレーションします。</translation>
    </message>
    <message>
        <source>Open the folder of a study, or a protocol (TOML) to begin one with.</source>
        <translation>実験のフォルダー、または新しく始めるためのプロトコル (TOML) を開きます。</translation>
    </message>
    <message>
        <source>PATH</source>
        <translation>PATH</translation>
    </message>
    <message>
        <source>Let simulated participants go through the study, which is made if need be.</source>
        <translation>シミュレーション参加者に実験を行わせます。必要なら実験を作成します。</translation>
    </message>
    <message>
        <source>WHICH</source>
        <translation>WHICH</translation>
    </message>
    <message>
        <source>--camera and --camera-model belong together: a camera is of no use without its calibration</source>
        <translation>--cameraと--camera-modelは対で必要です: カメラはキャリブレーションなしでは使えません</translation>
    </message>
    <message>
        <source>Play back a recording of this program, or recorded frames, CSV time_s,t0,t1,... (repeatable; the options below go with the recordings in their order).</source>
        <translation>このプログラムの記録、または記録したフレーム (CSV time_s,t0,t1,...) を再生します (繰り返し指定可。以下のオプションは記録の順に対応します)。</translation>
    </message>
    <message>
        <source>Record all sources and the bracelet into a new file.</source>
        <translation>すべてのソースとブレスレットを新しいファイルに記録します。</translation>
    </message>
    <message>
        <source>Bracelet to drive: simulated, usb, none, or a file that describes one.</source>
        <translation>駆動するブレスレット: simulated、usb、none、またはブレスレットを記述したファイル。</translation>
    </message>
    <message>
        <source>--language %1: expected en, fr, ja or zh_CN</source>
        <translation>--language %1: en、fr、ja、zh_CN のいずれかを指定してください</translation>
    </message>
    <message>
        <source>Show all sources live to Foxglove on this port (default 8765).</source>
        <translation>すべてのソースをこのポートでFoxgloveにライブ表示します (デフォルト 8765)。</translation>
    </message>
    <message>
        <source>PORT</source>
        <translation>PORT</translation>
    </message>
    <message>
        <source>Address on which the live view listens (default 127.0.0.1: this computer only).</source>
        <translation>ライブ表示が待ち受けるアドレス (デフォルト 127.0.0.1: このコンピューターのみ)。</translation>
    </message>
    <message>
        <source>ADDRESS</source>
        <translation>ADDRESS</translation>
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
        <translation>遠隔のロボットアームが触れているものの位置、強さ、硬さ、形を表示します。

例:
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
        <translation>開く記録（.teleta、.csv、.mcap、.npz、.npy、.h5、.mat）、シーン、アーム、サイト、ソース一覧（.toml）。</translation>
    </message>
    <message>
        <source>Connect to a site where teleta-site runs, by its file (TOML; repeatable).</source>
        <translation>teleta-site が動いているサイトに、そのファイルで接続します（TOML、繰り返し可）。</translation>
    </message>
    <message>
        <source>Open an arm over ROS 2, or the joints that a Modbus device reports, described in a file (TOML; repeatable).</source>
        <translation>ファイルに記述されたROS 2のアーム、またはModbusの機器が伝える関節を開く (TOML、繰り返し可)。</translation>
    </message>
    <message>
        <source>Plot a signal on the Plot page as soon as its source is open, SOURCE/STREAM/COLUMN with the names that the page shows (repeatable).</source>
        <translation>ソースが開き次第、プロットページに信号を表示します。ページに表示される名前でSOURCE/STREAM/COLUMNの形で指定します (複数指定可)。</translation>
    </message>
    <message>
        <source>SIGNAL</source>
        <translation>SIGNAL</translation>
    </message>
    <message>
        <source>--plot %1: expected SOURCE/STREAM/COLUMN</source>
        <translation>--plot %1: SOURCE/STREAM/COLUMNの形で指定してください</translation>
    </message>
</context>
<context>
    <name>ContactsCommand</name>
    <message>
        <source>Place, force and identity of each contact of each tactile frame</source>
        <translation>各触覚フレームの各接触の位置、力、識別番号</translation>
    </message>
    <message>
        <source>this is for loads on a grid</source>
        <translation>これは格子上の荷重のためのものです</translation>
    </message>
</context>
<context>
    <name>ContourCommand</name>
    <message>
        <source>circle</source>
        <translation>円</translation>
    </message>
    <message>
        <source>rectangle</source>
        <translation>長方形</translation>
    </message>
    <message>
        <source>triangle</source>
        <translation>三角形</translation>
    </message>
    <message>
        <source>arc</source>
        <translation>円弧</translation>
    </message>
    <message>
        <source>line</source>
        <translation>直線</translation>
    </message>
    <message>
        <source>point</source>
        <translation>点</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>不明</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>点</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>形状</translation>
    </message>
    <message>
        <source>%1 (confidence %2)</source>
        <translation>%1 (確信度 %2)</translation>
    </message>
    <message>
        <source>Closed</source>
        <translation>閉曲線</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>はい</translation>
    </message>
    <message>
        <source>no</source>
        <translation>いいえ</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>長さ</translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation>%1 m</translation>
    </message>
    <message>
        <source>Largest curvature</source>
        <translation>最大曲率</translation>
    </message>
    <message>
        <source>%1 1/m</source>
        <translation>%1 1/m</translation>
    </message>
    <message>
        <source>Centre</source>
        <translation>中心</translation>
    </message>
    <message>
        <source>%1, %2 m</source>
        <translation>%1, %2 m</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>半径</translation>
    </message>
    <message>
        <source>%1 m (points off by %2 m)</source>
        <translation>%1 m (点のずれ %2 m)</translation>
    </message>
    <message>
        <source>Vertex %1</source>
        <translation>頂点 %1</translation>
    </message>
    <message>
        <source>Shape, vertices and spline of a series of contact points</source>
        <translation>一連の接触点から求めた形状、頂点、スプライン</translation>
    </message>
    <message>
        <source>CSV with the columns x_m,y_m, in the order of touch</source>
        <translation>x_m,y_m の列を持つCSV (触れた順)</translation>
    </message>
    <message>
        <source>approximating: the points are the control points; interpolating: the curve passes through them</source>
        <translation>approximating: 点を制御点とする。interpolating: 曲線が点を通る</translation>
    </message>
    <message>
        <source>Points of the curve, for the CSV and the largest curvature</source>
        <translation>曲線の点数 (CSVと最大曲率用)</translation>
    </message>
    <message>
        <source>Write the curve as CSV t,x_m,y_m,curvature_per_m, t from 0 to 1</source>
        <translation>曲線をCSV t,x_m,y_m,curvature_per_m として書き込む (tは0から1)</translation>
    </message>
    <message>
        <source>the file has no points</source>
        <translation>ファイルに点がありません</translation>
    </message>
    <message>
        <source>a coordinate is too large to compute with</source>
        <translation>座標が大きすぎて計算できません</translation>
    </message>
    <message>
        <source>a row for each contact point, in metres</source>
        <translation>接触点ごとに1行 (メートル単位)</translation>
    </message>
    <message>
        <source>The contour is closed; otherwise the program decides</source>
        <translation>輪郭は始点に戻る。指定しなければ自動判定</translation>
    </message>
    <message>
        <source>A contour smaller than this is a point, m</source>
        <translation>これより小さい広がりは点とみなす、m</translation>
    </message>
    <message>
        <source>Candidates</source>
        <translation>候補</translation>
    </message>
</context>
<context>
    <name>ContourPicture</name>
    <message>
        <source>nothing explored yet</source>
        <translation>まだ何も探索されていません</translation>
    </message>
    <message>
        <source>%1, confidence %2 %</source>
        <translation>%1、確信度 %2 %</translation>
    </message>
    <message>
        <source>Touch an object from several sides: its outline appears here.</source>
        <translation>物体に複数の側から触れると、ここに輪郭が表示されます。</translation>
    </message>
    <message numerus="yes">
        <source>%n point(s)</source>
        <translation>
            <numerusform>%n点</numerusform>
        </translation>
    </message>
    <message>
        <source>radius %1</source>
        <translation>半径 %1</translation>
    </message>
    <message>
        <source>edges %1</source>
        <translation>辺 %1</translation>
    </message>
    <message>
        <source>points off by %1 (rms)</source>
        <translation>点のずれ %1 (rms)</translation>
    </message>
    <message>
        <source>z %1</source>
        <translation>z %1</translation>
    </message>
    <message>
        <source>undecided: %1</source>
        <translation>未確定: %1</translation>
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
        <source>too few touches for a shape</source>
        <translation>形状を判断するには接触が足りません</translation>
    </message>
</context>
<context>
    <name>CostFigureText</name>
    <message>
        <source>Filled: no other rung is both as quick and as exact. Lines: to the 95 % error and the 99 % time.</source>
        <translation>塗りつぶし: これより速くかつ正確な段はほかにありません。線: 誤差の95 %点と時間の99 %点まで。</translation>
    </message>
    <message>
        <source>Not measured, the machine was too noisy or there is no error: %1.</source>
        <translation>未測定 (マシンのばらつきが大きすぎるか、誤差がありません): %1。</translation>
    </message>
    <message>
        <source>Median time of one call</source>
        <translation>1回の呼び出しの時間の中央値</translation>
    </message>
    <message>
        <source>Mean error (share)</source>
        <translation>平均誤差 (割合)</translation>
    </message>
    <message>
        <source>Mean error (%1)</source>
        <translation>平均誤差 (%1)</translation>
    </message>
    <message>
        <source>Limit: %1</source>
        <translation>限界: %1</translation>
    </message>
</context>
<context>
    <name>CostFileText</name>
    <message>
        <source>&quot;%1&quot; is not a value of the column %2</source>
        <translation>「%1」は列 %2 の値として使えません</translation>
    </message>
    <message>
        <source>a number that is not negative, or NA</source>
        <translation>負でない数値またはNA</translation>
    </message>
    <message>
        <source>yes or no</source>
        <translation>yesまたはno</translation>
    </message>
    <message>
        <source>a number of samples</source>
        <translation>サンプル数</translation>
    </message>
</context>
<context>
    <name>CostLadder</name>
    <message>
        <source>Calibration of the camera in the tube</source>
        <translation>チューブ内カメラのキャリブレーション</translation>
    </message>
    <message>
        <source>distance of located points of the tube from the true ones; where the calibration is refused the camera of the data sheet stands in</source>
        <translation>求めたチューブ上の点と真の点との距離。キャリブレーションが拒否された場合はデータシートのカメラで代用します</translation>
    </message>
    <message>
        <source>Contacts in a camera frame</source>
        <translation>1枚のカメラフレーム内の接触</translation>
    </message>
    <message>
        <source>distance from the true contact on the tube; a contact that is missed counts with its distance from the tube&apos;s middle</source>
        <translation>チューブ上の真の接触からの距離。検出漏れの接触はチューブ中央からの距離で数えます</translation>
    </message>
    <message>
        <source>Curve through contact points</source>
        <translation>接触点を通る曲線</translation>
    </message>
    <message>
        <source>distance of the true outline (circle, rectangle, bent profile) from the curve</source>
        <translation>真の輪郭 (円、長方形、曲がった断面) と曲線との距離</translation>
    </message>
    <message>
        <source>difference of a taxel from the scene with all effects, root mean square of a frame</source>
        <translation>全効果を含むシーンとのタクセルの差 (フレームの二乗平均平方根)</translation>
    </message>
    <message>
        <source>10 ms of an arm that touches rubber</source>
        <translation>ゴムに触れるアームの10 ms</translation>
    </message>
    <message>
        <source>largest difference of a joint&apos;s torque from a solution with steps of 2 us</source>
        <translation>2 usステップの解との関節トルクの最大差</translation>
    </message>
    <message>
        <source>Interval of the information transfer of a study</source>
        <translation>実験の情報伝達量の区間</translation>
    </message>
    <message>
        <source>score of the 95 % interval: its width, and 40 times how far the true transfer lies outside of it</source>
        <translation>95 %区間のスコア: 区間の幅と、真の伝達量が区間から外れた量の40倍</translation>
    </message>
    <message>
        <source>Stiffness of a touched object</source>
        <translation>触れた物体の剛性</translation>
    </message>
    <message>
        <source>share of the true stiffness of the object; a bound counts as the value, a refused touch as 1</source>
        <translation>物体の真の剛性に対する割合。限界値はその値として、棄却されたタッチは1として数えます</translation>
    </message>
    <message>
        <source>Place of a contact on a tactile array</source>
        <translation>触覚アレイ上の接触位置</translation>
    </message>
    <message>
        <source>distance from the lowest point of the ball that presses</source>
        <translation>押している球の最下点からの距離</translation>
    </message>
    <message>
        <source>Direction in which a pixel of the wide lens looks</source>
        <translation>広角レンズの画素が向く方向</translation>
    </message>
    <message>
        <source>angle from the direction of the point of the tube that the pixel shows</source>
        <translation>その画素に写るチューブ上の点の方向との角度</translation>
    </message>
    <message>
        <source>Gains of an array&apos;s taxels from a press</source>
        <translation>押圧から求めるアレイのタクセルのゲイン</translation>
    </message>
    <message>
        <source>share of the true gains, root mean square of an array; a taxel that is left out counts as it is</source>
        <translation>真のゲインに対する割合、アレイ全体の二乗平均平方根。除外されたタクセルはそのまま数えます</translation>
    </message>
    <message>
        <source>Motion of the markers of a gel</source>
        <translation>ゲルのマーカーの動き</translation>
    </message>
    <message>
        <source>distance from the way that the marker was drawn to have gone; a marker that is lost counts as at rest</source>
        <translation>描いたマーカーの移動量との距離。見失ったマーカーは静止しているとみなす</translation>
    </message>
    <message>
        <source>Interval of a threshold from a participant&apos;s answers</source>
        <translation>参加者の回答から求めた閾値の区間</translation>
    </message>
    <message>
        <source>score of the 95 % interval of the threshold&apos;s logarithm: its width, and 40 times how far the true one lies outside of it</source>
        <translation>閾値の対数の95 %区間のスコア: 区間の幅に、真の値が区間の外にある距離の40倍を加えたもの</translation>
    </message>
    <message>
        <source>Contacts on the skin of a whole body</source>
        <translation>全身の皮膚の接触</translation>
    </message>
    <message>
        <source>distance of each body from the nearest contact of its patch, and of each contact from the nearest body; from the patch&apos;s middle where there is none</source>
        <translation>各物体からその皮膚片の最も近い接触まで、および各接触から最も近い物体までの距離。なければ皮膚片の中央までの距離</translation>
    </message>
    <message>
        <source>A frame of a simulated array without one of the sensor&apos;s effects</source>
        <translation>センサーの効果を1つ除いた、シミュレーションのアレイの1フレーム</translation>
    </message>
</context>
<context>
    <name>CostWords</name>
    <message>
        <source>twice as fast</source>
        <translation>2倍速い</translation>
    </message>
    <message>
        <source>%1 times as fast</source>
        <translation>%1倍速い</translation>
    </message>
    <message>
        <source>takes twice as long</source>
        <translation>2倍の時間がかかる</translation>
    </message>
    <message>
        <source>takes %1 times as long</source>
        <translation>%1倍の時間がかかる</translation>
    </message>
    <message>
        <source>Faster: %1, %2.</source>
        <translation>より速い: %1、%2。</translation>
    </message>
    <message>
        <source>No setting is faster.</source>
        <translation>これより速い設定はありません。</translation>
    </message>
    <message>
        <source>In use: %1. It takes %2 and is off by %3 on average.</source>
        <extracomment>A setting, its time, its error</extracomment>
        <translation>使用中: %1。%2かかり、平均で%3ずれます。</translation>
    </message>
    <message>
        <source>%1 takes %2 and is off by %3 on average.</source>
        <translation>%1は%2かかり、平均で%3ずれます。</translation>
    </message>
    <message>
        <source>%1 percentage points</source>
        <translation>%1パーセントポイント</translation>
    </message>
    <message>
        <source>as fast</source>
        <translation>同じ速さ</translation>
    </message>
    <message>
        <source>%1, equally accurate</source>
        <translation>%1、精度は同じ</translation>
    </message>
    <message>
        <source>%1, %2 less accurate</source>
        <extracomment>How fast another setting is, and by how much its results are better or worse</extracomment>
        <translation>%1、精度は%2悪化</translation>
    </message>
    <message>
        <source>%1, %2 more accurate</source>
        <translation>%1、精度は%2向上</translation>
    </message>
    <message>
        <source>%1 has no time: the machine was too busy. Close other programs and measure again.</source>
        <translation>%1には時間がありません。コンピューターの負荷が高すぎました。他のプログラムを閉じて、もう一度測定してください。</translation>
    </message>
    <message>
        <source>Nothing can do this job in less than %1: this is its limit.</source>
        <translation>この処理はどの方法でも%1より短くはなりません。これが限界です。</translation>
    </message>
    <message>
        <source>%1 takes %2. It has no error to compare.</source>
        <translation>%1は%2かかります。比較できる誤差はありません。</translation>
    </message>
    <message>
        <source>%1 beats it: %2.</source>
        <translation>%1のほうが優れています：%2。</translation>
    </message>
    <message>
        <source>More accurate: %1, %2.</source>
        <translation>より正確：%1、%2。</translation>
    </message>
    <message>
        <source>No setting is more accurate.</source>
        <translation>より正確な設定はありません。</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>カメラ</translation>
    </message>
    <message>
        <source>Tactile array</source>
        <translation>触覚アレイ</translation>
    </message>
    <message>
        <source>Touched object</source>
        <translation>触れた物体</translation>
    </message>
    <message>
        <source>Simulation</source>
        <translation>シミュレーション</translation>
    </message>
    <message>
        <source>Study</source>
        <translation>実験</translation>
    </message>
</context>
<context>
    <name>CsvReaderText</name>
    <message>
        <source>opening was interrupted: %1</source>
        <translation>オープンが中断されました: %1</translation>
    </message>
    <message>
        <source>cannot open the file: %1</source>
        <translation>ファイルを開けません: %1</translation>
    </message>
    <message>
        <source>cannot read the file: %1</source>
        <translation>ファイルを読み取れません: %1</translation>
    </message>
    <message>
        <source>this is a folder</source>
        <translation>これはフォルダーです</translation>
    </message>
    <message>
        <source>a CSV file</source>
        <translation>CSVファイル</translation>
    </message>
    <message>
        <source>the file is empty</source>
        <translation>ファイルが空です</translation>
    </message>
    <message>
        <source>a header line with the names of the columns</source>
        <translation>列名を含むヘッダー行</translation>
    </message>
    <message>
        <source>the file is UTF-16</source>
        <translation>ファイルがUTF-16です</translation>
    </message>
    <message>
        <source>UTF-8</source>
        <translation>UTF-8</translation>
    </message>
    <message>
        <source>the line is longer than 16 MiB</source>
        <translation>行が16 MiBを超えています</translation>
    </message>
    <message>
        <source>a closing quote</source>
        <translation>閉じ引用符</translation>
    </message>
    <message>
        <source>a line end</source>
        <translation>行末</translation>
    </message>
    <message>
        <source>a quote is not closed</source>
        <translation>引用符が閉じられていません</translation>
    </message>
    <message>
        <source>a number, nan, inf or NA</source>
        <translation>数値、nan、inf、またはNA</translation>
    </message>
    <message>
        <source>a finite number</source>
        <translation>有限の数値</translation>
    </message>
    <message>
        <source>the field is empty</source>
        <translation>フィールドが空です</translation>
    </message>
    <message>
        <source>%1 is not a number</source>
        <translation>%1 は数値ではありません</translation>
    </message>
    <message>
        <source>%1 is not a finite number</source>
        <translation>%1 は有限の数値ではありません</translation>
    </message>
    <message>
        <source>missing columns: %1; the file has: %2</source>
        <translation>不足している列: %1。ファイルにある列: %2</translation>
    </message>
    <message>
        <source>the columns %1</source>
        <translation>列 %1</translation>
    </message>
    <message>
        <source>the row is too long: more than %1 values</source>
        <translation>行が長すぎます: 値が%1個を超えています</translation>
    </message>
    <message>
        <source>the row is too short: %1 of %2 values</source>
        <translation>行が短すぎます: 値が%2個中%1個しかありません</translation>
    </message>
    <message>
        <source>a file</source>
        <translation>ファイル</translation>
    </message>
    <message>
        <source>one value per column: %1</source>
        <translation>列ごとに値1つ: %1</translation>
    </message>
    <message>
        <source>text outside the quotes of a column name</source>
        <translation>列名の引用符の外に文字があります</translation>
    </message>
    <message>
        <source>a comma after the closing quote</source>
        <translation>閉じ引用符の後のコンマ</translation>
    </message>
    <message>
        <source>the column %1 appears twice</source>
        <translation>列 %1 が2回あります</translation>
    </message>
    <message>
        <source>each name only once</source>
        <translation>各名前は1回のみ</translation>
    </message>
    <message>
        <source>text outside the quotes of a value</source>
        <translation>値の引用符の外に文字があります</translation>
    </message>
    <message>
        <source>a pipe cannot be rewound</source>
        <translation>パイプでは位置を移動できません</translation>
    </message>
    <message>
        <source>the file is %1</source>
        <translation>ファイルの形式は%1です</translation>
    </message>
</context>
<context>
    <name>DdsDiscovery</name>
    <message>
        <source>other programs of the domain cannot be found</source>
        <translation>ドメインのほかのプログラムを見つけられません</translation>
    </message>
</context>
<context>
    <name>DdsDomain</name>
    <message>
        <source>the environment variable %1 is &quot;%2&quot;</source>
        <translation>環境変数 %1 は「%2」です</translation>
    </message>
    <message>
        <source>a whole number from 0 to %1</source>
        <translation>0から%1までの整数</translation>
    </message>
</context>
<context>
    <name>DdsEndpoint</name>
    <message>
        <source>topic %1 cannot be opened</source>
        <translation>トピック %1 を開けません</translation>
    </message>
    <message>
        <source>topic %1 cannot be read</source>
        <translation>トピック %1 を読み取れません</translation>
    </message>
    <message>
        <source>topic %1 cannot be written</source>
        <translation>トピック %1 に書き込めません</translation>
    </message>
    <message>
        <source>the permissions do not allow reading topic %1</source>
        <translation>権限はトピック %1 の読み取りを許可していません</translation>
    </message>
    <message>
        <source>the permissions do not allow writing topic %1</source>
        <translation>権限はトピック %1 への書き込みを許可していません</translation>
    </message>
</context>
<context>
    <name>DdsParticipant</name>
    <message>
        <source>domain %1 is open with another interface or other peers</source>
        <translation>ドメイン %1 は別のインターフェースまたは別の相手で開かれています</translation>
    </message>
    <message>
        <source>domain %1 of DDS cannot be opened: %2</source>
        <translation>DDSのドメイン %1 を開けません: %2</translation>
    </message>
    <message>
        <source>&quot;%1&quot; to be the name or the address of a network interface</source>
        <translation>「%1」がネットワークインターフェースの名前またはアドレスであること</translation>
    </message>
    <message>
        <source>domain %1 of DDS cannot be joined: %2</source>
        <translation>DDSのドメイン %1 に参加できません: %2</translation>
    </message>
    <message>
        <source>domain %1 of DDS cannot be joined</source>
        <translation>DDSのドメイン %1 に参加できません</translation>
    </message>
    <message>
        <source>this program has joined domain %1 with keys already</source>
        <translation>このプログラムはすでに鍵を使ってドメイン %1 に参加しています</translation>
    </message>
    <message>
        <source>once: the permissions of the first would apply to all</source>
        <translation>一度だけ：最初の権限がすべてに適用されてしまいます</translation>
    </message>
    <message>
        <source>this program joined domain %1 with other permissions before</source>
        <translation>このプログラムは以前、別の権限でドメイン %1 に参加しました</translation>
    </message>
    <message>
        <source>the same ones until the program is started again</source>
        <translation>プログラムを再起動するまで同じ権限</translation>
    </message>
    <message>
        <source>domain %1 of DDS cannot be joined with the keys in %2: %3</source>
        <translation>%2 の鍵では DDS のドメイン %1 に参加できません：%3</translation>
    </message>
    <message>
        <source>a program is kept out of domain %1: %2</source>
        <translation>ドメイン %1 への参加を拒否したプログラムがあります：%2</translation>
    </message>
</context>
<context>
    <name>DdsSecurity</name>
    <message>
        <source>the certificate has expired</source>
        <translation>証明書の有効期限が切れています</translation>
    </message>
    <message>
        <source>the certificate is not valid yet</source>
        <translation>証明書はまだ有効ではありません</translation>
    </message>
    <message>
        <source>the certificate is not signed by identity_ca.pem</source>
        <translation>証明書は identity_ca.pem で署名されていません</translation>
    </message>
    <message>
        <source>the key does not belong to the certificate</source>
        <translation>鍵が証明書と一致しません</translation>
    </message>
    <message>
        <source>the permissions are not signed by permissions_ca.pem</source>
        <translation>権限は permissions_ca.pem で署名されていません</translation>
    </message>
    <message>
        <source>the permissions do not name the subject of the certificate</source>
        <translation>権限に証明書のサブジェクトがありません</translation>
    </message>
    <message>
        <source>the permissions have expired</source>
        <translation>権限の有効期限が切れています</translation>
    </message>
    <message>
        <source>the permissions are not valid yet</source>
        <translation>権限はまだ有効ではありません</translation>
    </message>
    <message>
        <source>the permissions (permissions.p7s) do not allow this domain</source>
        <translation>権限（permissions.p7s）はこのドメインを許可していません</translation>
    </message>
    <message>
        <source>the governance (governance.p7s) does not name this domain</source>
        <translation>ガバナンス（governance.p7s）にこのドメインがありません</translation>
    </message>
    <message>
        <source>the plugins of DDS Security cannot be loaded</source>
        <translation>DDS Security のプラグインを読み込めません</translation>
    </message>
</context>
<context>
    <name>Demo</name>
    <message>
        <source>An arm touches five materials</source>
        <translation>アームが5種類の材料に触れる</translation>
    </message>
    <message>
        <source>An arm explores a round object</source>
        <translation>アームが丸い物体を探索する</translation>
    </message>
    <message>
        <source>An arm explores a rectangular object</source>
        <translation>アームが長方形の物体を探索する</translation>
    </message>
    <message>
        <source>The same with a box</source>
        <translation>同じことを箱で行う</translation>
    </message>
    <message>
        <source>An arm explores a triangular object</source>
        <translation>アームが三角形の物体を探索する</translation>
    </message>
    <message>
        <source>The same with a triangular prism</source>
        <translation>同じことを三角柱で行う</translation>
    </message>
    <message>
        <source>An arm yields</source>
        <translation>アームが外力に従う</translation>
    </message>
    <message>
        <source>Somebody pushes the arm, then it meets an object, under joint admittance control</source>
        <translation>関節アドミタンス制御で、人がアームを押し、その後アームが物体に当たる</translation>
    </message>
    <message>
        <source>A ball and a bar</source>
        <translation>球と棒</translation>
    </message>
    <message>
        <source>A 6 x 14 array pressed by a ball that wanders, then by a bar that turns</source>
        <translation>6 x 14のアレイを、動き回る球、次に回転する棒が押す</translation>
    </message>
    <message>
        <source>Two contacts that meet</source>
        <translation>出会う2つの接触</translation>
    </message>
    <message>
        <source>Two balls that approach each other until they touch, and part</source>
        <translation>2つの球が近づいて触れ合い、離れる</translation>
    </message>
    <message>
        <source>A pressure mat</source>
        <translation>圧力マット</translation>
    </message>
    <message>
        <source>A 64 x 27 mat under a body: a head, a trunk that turns, two heels</source>
        <translation>人体の下の64 x 27マット: 頭、向きを変える体幹、両かかと</translation>
    </message>
    <message>
        <source>Something pokes a soft arm</source>
        <translation>ソフトアームがつつかれる</translation>
    </message>
    <message>
        <source>A camera inside the soft tube sees the bump; the arm draws back</source>
        <translation>ソフトチューブ内のカメラが衝突を捉え、アームが退避する</translation>
    </message>
    <message>
        <source>A finger turns a soft arm</source>
        <translation>指がソフトアームを回す</translation>
    </message>
    <message>
        <source>The arm turns after a finger that goes round it</source>
        <translation>周囲を回る指を追ってアームが回転する</translation>
    </message>
    <message>
        <source>A finger leads a soft arm</source>
        <translation>指がソフトアームを導く</translation>
    </message>
    <message>
        <source>The arm follows a finger along its axis</source>
        <translation>アームが軸方向に指に追従する</translation>
    </message>
    <message>
        <source>Three fingers on a soft arm</source>
        <translation>ソフトアームに3本の指</translation>
    </message>
    <message>
        <source>Contacts near the lens, in the middle and at the far end of the tube</source>
        <translation>レンズの近く、中央、チューブの奥端での接触</translation>
    </message>
    <message>
        <source>An array follows a bent bar</source>
        <translation>アレイが曲がった棒をたどる</translation>
    </message>
    <message>
        <source>It closes in, aligns with the bar, and slides along its bend at 5 N</source>
        <translation>アレイが近づき、棒に向きを合わせ、曲がりに沿って5 Nで滑る</translation>
    </message>
    <message>
        <source>A tray is kept level</source>
        <translation>トレイを水平に保つ</translation>
    </message>
    <message>
        <source>A weight moves on the tray; the hand feels its moment and tilts against it</source>
        <translation>トレイの上でおもりが動き、手がそのモーメントを感じて逆向きに傾く</translation>
    </message>
    <message>
        <source>An array rolls on a ball</source>
        <translation>アレイが球の上を転がる</translation>
    </message>
    <message>
        <source>The contact wanders over the array while the force stays at 4 N</source>
        <translation>力を4 Nに保ったまま、接触がアレイ上を動き回る</translation>
    </message>
    <message>
        <source>An arm among unknown objects</source>
        <translation>未知の物体の中のアーム</translation>
    </message>
    <message>
        <source>Arm</source>
        <translation>アーム</translation>
    </message>
    <message>
        <source>Array</source>
        <translation>アレイ</translation>
    </message>
    <message>
        <source>Servo</source>
        <translation>サーボ</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>カメラ</translation>
    </message>
    <message>
        <source>Study</source>
        <translation>実験</translation>
    </message>
    <message>
        <source>Simulated participants answer, and the confusion matrix fills</source>
        <translation>シミュレーションの参加者が回答し、混同行列が埋まります</translation>
    </message>
    <message>
        <source>The published protocol</source>
        <translation>論文のプロトコル</translation>
    </message>
    <message>
        <source>Stimuli, practice and test trials: read it, and begin a study with it</source>
        <translation>刺激、練習試行、テスト試行。内容を読み、それを使って実験を始めます</translation>
    </message>
    <message>
        <source>Patterns</source>
        <translation>パターン</translation>
    </message>
    <message>
        <source>A rehearsed study</source>
        <translation>実験のリハーサル</translation>
    </message>
    <message>
        <source>A shape as a vibration pattern: play it, or edit a copy</source>
        <translation>形状を表す振動パターン。再生するか、コピーを編集します</translation>
    </message>
    <message>
        <source>A stiffness as a vibration pattern: play it, or edit a copy</source>
        <translation>剛性を表す振動パターン。再生するか、コピーを編集します</translation>
    </message>
    <message>
        <source>Balls press a flat gel</source>
        <translation>球が平らなゲルを押す</translation>
    </message>
    <message>
        <source>Markers on the skin of a flat gel move apart under two balls</source>
        <translation>平らなゲルの皮膚のマーカーが、2つの球の下で広がる</translation>
    </message>
    <message>
        <source>A ball shears a flat gel</source>
        <translation>球が平らなゲルをせん断する</translation>
    </message>
    <message>
        <source>It is dragged to and fro and sticks but for a narrow rim</source>
        <translation>往復して引かれ、狭い縁を除いて固着する</translation>
    </message>
    <message>
        <source>A ball slips on a flat gel</source>
        <translation>球が平らなゲルの上で滑る</translation>
    </message>
    <message>
        <source>A ring of slip grows from the rim of the contact to its middle</source>
        <translation>滑りの輪が接触の縁から中心へ広がる</translation>
    </message>
    <message>
        <source>A ball twists a flat gel</source>
        <translation>球が平らなゲルをねじる</translation>
    </message>
    <message>
        <source>It is turned about the normal, and the skin turns with it</source>
        <translation>法線まわりに回され、皮膚も一緒に回る</translation>
    </message>
    <message>
        <source>A ball bumps into a flat gel</source>
        <translation>球が平らなゲルにぶつかる</translation>
    </message>
    <message>
        <source>The arm that carries the gel draws back</source>
        <translation>ゲルを持つアームが退く</translation>
    </message>
    <message>
        <source>A ball leads a flat gel</source>
        <translation>球が平らなゲルを引く</translation>
    </message>
    <message>
        <source>The arm follows a ball that drags the gel along</source>
        <translation>ゲルを引く球にアームが追従する</translation>
    </message>
    <message>
        <source>From sponge to metal: where it touches, how hard and how stiff</source>
        <translation>スポンジから金属まで: 位置、力、剛性</translation>
    </message>
    <message>
        <source>Outline and shape from single touches</source>
        <translation>接触から輪郭と形状を求めます</translation>
    </message>
    <message>
        <source>Find them over a slow link, or watch</source>
        <translation>遅い回線越しに探すか、見学します</translation>
    </message>
</context>
<context>
    <name>DeviceState</name>
    <message>
        <source>closed</source>
        <translation>切断</translation>
    </message>
    <message>
        <source>connecting</source>
        <translation>接続中</translation>
    </message>
    <message>
        <source>live</source>
        <translation>ライブ</translation>
    </message>
    <message>
        <source>paused</source>
        <translation>一時停止</translation>
    </message>
    <message>
        <source>stale</source>
        <translation>更新停止</translation>
    </message>
    <message>
        <source>lost</source>
        <translation>喪失</translation>
    </message>
    <message>
        <source>reconnecting</source>
        <translation>再接続中</translation>
    </message>
    <message>
        <source>finished</source>
        <translation>終了</translation>
    </message>
</context>
<context>
    <name>DevicesCommand</name>
    <message>
        <source>&quot;kind&quot; is missing</source>
        <translation>&quot;kind&quot;がありません</translation>
    </message>
    <message>
        <source>Bracelet</source>
        <translation>ブレスレット</translation>
    </message>
    <message>
        <source>3D mouse</source>
        <translation>3Dマウス</translation>
    </message>
    <message>
        <source>Tactile array</source>
        <translation>触覚アレイ</translation>
    </message>
    <message>
        <source>Modbus device</source>
        <translation>Modbusデバイス</translation>
    </message>
    <message>
        <source>%1 at %2</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>State</source>
        <translation>状態</translation>
    </message>
    <message>
        <source>not connected: %1</source>
        <translation>未接続: %1</translation>
    </message>
    <message>
        <source>connected</source>
        <translation>接続済み</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>フレーム</translation>
    </message>
    <message>
        <source>up to %1 Hz</source>
        <translation>最大 %1 Hz</translation>
    </message>
    <message>
        <source>Inputs</source>
        <translation>入力</translation>
    </message>
    <message>
        <source>No device is connected.</source>
        <translation>デバイスが接続されていません。</translation>
    </message>
    <message>
        <source>Connect to the device of this description and read it; its motors are set to zero</source>
        <translation>この記述のデバイスに接続して読み取ります。モーターはゼロに設定されます</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>カメラ</translation>
    </message>
    <message>
        <source>List connected devices, how fast they are, and why others cannot be used</source>
        <translation>接続されているもの、接続できない理由、速度</translation>
    </message>
    <message>
        <source>it answers, but sends no frames</source>
        <translation>応答はありますが、フレームが届きません</translation>
    </message>
    <message>
        <source>%1 Hz</source>
        <translation>%1 Hz</translation>
    </message>
    <message>
        <source>nothing came from it</source>
        <translation>何も届きませんでした</translation>
    </message>
    <message numerus="yes">
        <source>it sends frames of %n chip(s)</source>
        <translation>
            <numerusform>%n個のチップのフレームを送っています</numerusform>
        </translation>
    </message>
    <message>
        <source>there is no frame in what came from it, as the file describes them</source>
        <translation>届いたデータの中に、ファイルの記述に合うフレームがありません</translation>
    </message>
    <message>
        <source>Of a described array: show at most so many of the bytes that it sends until a second after its first frame</source>
        <translation>記述されたアレイについて、最初のフレームの1秒後までに送られたバイトを最大この数だけ表示</translation>
    </message>
    <message>
        <source>the sensor file names no camera and no video</source>
        <translation>センサーファイルにカメラも動画も書かれていません</translation>
    </message>
    <message>
        <source>a key &quot;source&quot;</source>
        <translation>キー「source」</translation>
    </message>
    <message>
        <source>Flat gel with markers</source>
        <translation>マーカー付きの平らなゲル</translation>
    </message>
    <message>
        <source>kind = &quot;modbus&quot;, &quot;wts&quot;, &quot;camera&quot;, &quot;hid_bracelet&quot;, &quot;taxels&quot;, &quot;magnetometers&quot;, &quot;xela&quot;, &quot;sound_bracelet&quot;, &quot;marker_gel&quot;, &quot;ros_tactile&quot; or &quot;ros_camera&quot;</source>
        <translation>kind = &quot;modbus&quot;、&quot;wts&quot;、&quot;camera&quot;、&quot;hid_bracelet&quot;、&quot;taxels&quot;、&quot;magnetometers&quot;、&quot;xela&quot;、&quot;sound_bracelet&quot;、&quot;marker_gel&quot;、&quot;ros_tactile&quot;、&quot;ros_camera&quot;のいずれか</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>警告</translation>
    </message>
    <message>
        <source>the temperature of chip %1 changed by %2 K while it was probed: what the sensor reads at rest moves with it. Wait until it is warm</source>
        <translation>調べている間にチップ%1の温度が%2 K変化しました。センサーの静止時の値も一緒に動きます。温まるまで待ってください</translation>
    </message>
    <message>
        <source>this is for a bracelet on a sound card</source>
        <translation>サウンドカード上のブレスレット用のオプションです</translation>
    </message>
    <message>
        <source>Of a bracelet on a sound card: play clicks on tactor 1 and measure when they are heard on this input, at which an accelerometer or a cable is</source>
        <translation>サウンドカード上のブレスレットについて、アクチュエーター1でクリックを再生し、加速度センサーまたはケーブルをつないだこの入力で聞こえるまでの時間を測定</translation>
    </message>
</context>
<context>
    <name>DriverText</name>
    <message>
        <source>the simulated motor driver cannot open a port: %1</source>
        <translation>シミュレーションのモータードライバーがポートを開けません: %1</translation>
    </message>
    <message>
        <source>the device has no motors</source>
        <translation>デバイスにモーターがありません</translation>
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
        <translation>%1 分 %2 秒</translation>
    </message>
    <message>
        <source>%1 h %2 min</source>
        <translation>%1 時間 %2 分</translation>
    </message>
</context>
<context>
    <name>EqualStrength</name>
    <message>
        <source>tactor %1 has no level at which it feels as strong as tactor %2</source>
        <translation>タクタ%1には、タクタ%2と同じ強さに感じるレベルがありません</translation>
    </message>
    <message>
        <source>a level for each of the six tactors</source>
        <translation>6個のタクタそれぞれのレベル</translation>
    </message>
</context>
<context>
    <name>Error</name>
    <message>
        <source> (expected %1)</source>
        <translation> (期待される値: %1)</translation>
    </message>
</context>
<context>
    <name>ExclusionReport</name>
    <message>
        <source>%1 (marked in the file)</source>
        <translation>%1 (ファイル内でマーク済み)</translation>
    </message>
    <message>
        <source>%1 (made after the data)</source>
        <translation>%1 (データ取得後に作成)</translation>
    </message>
    <message>
        <source>What was left out, in the order of the rules; nothing was deleted</source>
        <translation>除外されたもの (規則の順)。何も削除していません</translation>
    </message>
    <message>
        <source>Rule</source>
        <translation>規則</translation>
    </message>
    <message>
        <source>Trials before</source>
        <translation>適用前の試行数</translation>
    </message>
    <message>
        <source>Trials</source>
        <translation>試行数</translation>
    </message>
    <message>
        <source>Sessions</source>
        <translation>セッション数</translation>
    </message>
    <message>
        <source>Participants</source>
        <translation>参加者数</translation>
    </message>
    <message>
        <source>Remark</source>
        <translation>備考</translation>
    </message>
    <message numerus="yes">
        <source>no spread of the times, so nothing was left out, in %n case(s)</source>
        <translation>
            <numerusform>時間のばらつきがなく、何も除外しなかった場合が%n件</numerusform>
        </translation>
    </message>
    <message>
        <source>The results with the rules, and without them</source>
        <translation>規則を適用した結果と、適用しない結果</translation>
    </message>
    <message>
        <source>Task</source>
        <translation>課題</translation>
    </message>
    <message>
        <source>Condition or effect</source>
        <translation>条件または効果</translation>
    </message>
    <message>
        <source>Correct, %</source>
        <translation>正答、%</translation>
    </message>
    <message>
        <source>Correct without rules, %</source>
        <translation>規則なしの正答、%</translation>
    </message>
    <message>
        <source>p GG without rules</source>
        <translation>規則なしのp GG</translation>
    </message>
    <message>
        <source>Exclusions</source>
        <translation>除外</translation>
    </message>
</context>
<context>
    <name>ExclusionRule</name>
    <message>
        <source>the rule %1 is about something else</source>
        <translation>規則%1の対象は別のものです</translation>
    </message>
    <message>
        <source>&quot;%1&quot;</source>
        <translation>「%1」</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no exclusion rule</source>
        <translation>「%1」は除外規則ではありません</translation>
    </message>
    <message>
        <source>RULE=VALUE with one of %1</source>
        <translation>RULE=VALUE、RULEは次のいずれか: %1</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has no usable value</source>
        <translation>「%1」に使用できる値がありません</translation>
    </message>
    <message>
        <source>%1=VALUE with %2</source>
        <translation>%1=VALUE、VALUEは%2</translation>
    </message>
</context>
<context>
    <name>ExportCommand</name>
    <message numerus="yes">
        <source>%n row(s)</source>
        <translation>
            <numerusform>%n行</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n damaged block(s) left out</source>
        <translation>
            <numerusform>破損した%nブロックを除外</numerusform>
        </translation>
    </message>
    <message>
        <source>Note</source>
        <translation>注記</translation>
    </message>
    <message>
        <source>The recording was cut off; what had been written is there.</source>
        <translation>記録は途中で切れています。それまでに書き込まれた分は残っています。</translation>
    </message>
    <message>
        <source>Recording of the console or of teleta simulate</source>
        <translation>コンソールまたはteleta simulateの記録</translation>
    </message>
    <message>
        <source>Write over files that are there already</source>
        <translation>既存のファイルを上書きする</translation>
    </message>
    <message>
        <source>another folder, or --force</source>
        <translation>別のフォルダー、または--force</translation>
    </message>
    <message>
        <source>start, units and origin of these files</source>
        <translation>これらのファイルの開始時刻、単位、由来</translation>
    </message>
    <message numerus="yes">
        <source>%n message(s)</source>
        <translation>
            <numerusform>%n件のメッセージ</numerusform>
        </translation>
    </message>
    <message>
        <source>The camera sees a left-handed frame: y of %1 has changed its sign.</source>
        <translation>カメラは左手系で見ています: %1のyの符号を反転しました。</translation>
    </message>
    <message>
        <source>%1 has no messages in ROS and was left out.</source>
        <translation>%1に対応するROSのメッセージがないため、除外しました。</translation>
    </message>
    <message>
        <source>Folder for a CSV file a stream, events.csv and recording.json</source>
        <translation>ストリームごとのCSVファイル、events.csv、recording.jsonを保存するフォルダー</translation>
    </message>
    <message>
        <source>List the streams of the recording: name and kind</source>
        <translation>記録のストリームを一覧表示: 名前と種類</translation>
    </message>
    <message>
        <source>Add a last column utc_s: Unix time in s with nine decimals</source>
        <translation>最後の列utc_sを追加: Unix時刻 (s)、小数点以下9桁</translation>
    </message>
    <message>
        <source>MCAP file for Foxglove and ROS 2</source>
        <translation>FoxgloveおよびROS 2用のMCAPファイル</translation>
    </message>
    <message>
        <source>Compression of the MCAP file</source>
        <translation>MCAPファイルの圧縮</translation>
    </message>
    <message>
        <source>Size of a chunk of the MCAP file in MiB</source>
        <translation>MCAPファイルのチャンクの大きさ (MiB)</translation>
    </message>
    <message>
        <source>another name, or --force</source>
        <translation>別の名前、または--force</translation>
    </message>
    <message numerus="yes">
        <source>%n frame(s)</source>
        <translation>
            <numerusform>%nフレーム</numerusform>
        </translation>
    </message>
    <message>
        <source>NumPy file with the arrays frames and time_s of a tactile array</source>
        <translation>触覚アレイの配列framesとtime_sを含むNumPyファイル</translation>
    </message>
    <message>
        <source>Only these streams into the MCAP file; the array of the NumPy file</source>
        <translation>MCAPファイルに書き込むストリームを限定。NumPyファイルの場合は対象のアレイ</translation>
    </message>
    <message>
        <source>either a folder here or a file after --mcap or --npz is needed</source>
        <translation>ここにフォルダー、または--mcapか--npzの後にファイルのいずれか1つが必要です</translation>
    </message>
    <message>
        <source>only with --mcap or --npz</source>
        <translation>--mcapまたは--npzと併用する場合のみ指定できます</translation>
    </message>
    <message>
        <source>only one with --npz</source>
        <translation>--npzでは1つだけ指定できます</translation>
    </message>
    <message>
        <source>Write the streams of a recording as CSV, MCAP or NumPy files</source>
        <translation>記録のストリームをCSV、MCAP、NumPyのファイルとして書き込む</translation>
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
        <translation>ハプティッククリップ (.haptic、zip内)</translation>
    </message>
    <message>
        <source>AHAP (in a zip)</source>
        <translation>AHAP (zip内)</translation>
    </message>
    <message>
        <source>tact</source>
        <translation>tact</translation>
    </message>
    <message>
        <source>CSV table</source>
        <translation>CSV表</translation>
    </message>
    <message>
        <source>WAV, six channels</source>
        <translation>WAV、6チャンネル</translation>
    </message>
    <message>
        <source>One channel per motor, with its place on the forearm. Can be read back.</source>
        <translation>モーターごとに1チャンネル、前腕上の位置付き。読み戻し可能です。</translation>
    </message>
    <message>
        <source>One clip per motor. Can be read back.</source>
        <translation>モーターごとに1クリップ。読み戻し可能です。</translation>
    </message>
    <message>
        <source>Columns time_s, t1 to t6: one sample per row.</source>
        <translation>列 time_s、t1～t6: 1行に1サンプル。</translation>
    </message>
    <message>
        <source>One file per motor, for Core Haptics. Can be read back.</source>
        <translation>モーターごとに1ファイル、Core Haptics用。読み戻し可能です。</translation>
    </message>
    <message>
        <source>Six motors on the forearm, whole milliseconds; slopes become steps of 20 ms. Can be read back.</source>
        <translation>前腕上の6個のモーター、ミリ秒単位の整数。傾斜は20 msの段階になります。読み戻し可能です。</translation>
    </message>
    <message>
        <source>16-bit samples, 1 is full scale. Vibrations drive voice coils; bare intensities are for programs that make the vibration themselves.</source>
        <translation>16ビットのサンプル、1がフルスケール。振動はボイスコイルを駆動します。強度のみの出力は、振動を自ら生成するプログラム用です。</translation>
    </message>
</context>
<context>
    <name>FaultInjector</name>
    <message>
        <source>the recording did not fail on a full disk</source>
        <translation>ディスクが満杯でも記録が失敗しませんでした</translation>
    </message>
    <message>
        <source>the program under test ended by itself</source>
        <translation>試験するプログラムが自分から終了しました</translation>
    </message>
    <message>
        <source>nothing moved within 30 s</source>
        <translation>30 秒以内に何も動きませんでした</translation>
    </message>
    <message>
        <source>the device does not answer any more</source>
        <translation>装置が応答しなくなりました</translation>
    </message>
    <message>
        <source>nothing moved within 30 s: %1</source>
        <translation>30 秒以内に何も動きませんでした: %1</translation>
    </message>
</context>
<context>
    <name>FeaturesCommand</name>
    <message>
        <source>Force, centres, moments and orientation of each tactile frame</source>
        <translation>各触覚フレームの力、中心、モーメント、向き</translation>
    </message>
</context>
<context>
    <name>FeltTask</name>
    <message>
        <source>Motor %1: %2</source>
        <comment>a motor, and what is wrong with the answers</comment>
        <translation>モーター%1: %2</translation>
    </message>
</context>
<context>
    <name>FeltThreshold</name>
    <message>
        <source>There are too few answers: %1.</source>
        <translation>回答が少なすぎます: %1。</translation>
    </message>
    <message>
        <source>at least %1</source>
        <translation>%1以上</translation>
    </message>
    <message>
        <source>yes only when something was clearly felt</source>
        <translation>はっきり感じたときだけ「はい」と回答</translation>
    </message>
    <message>
        <source>Nothing was felt, not even at the highest drive.</source>
        <translation>最大の駆動量でも何も感じられませんでした。</translation>
    </message>
    <message>
        <source>Everything was felt, even at the lowest drive.</source>
        <translation>最小の駆動量でもすべて感じられました。</translation>
    </message>
    <message>
        <source>The answers contradict each other: stronger was felt less often than weaker, or as often.</source>
        <translation>回答が矛盾しています: 強い刺激のほうが、弱い刺激より感じた回数が少ないか同じです。</translation>
    </message>
    <message>
        <source>The answer was yes in %1 of %2 cases in which nothing was presented.</source>
        <translation>何も提示していないのに「はい」の回答がありました (%2回中%1回)。</translation>
    </message>
    <message>
        <source>a connected motor in contact with the skin</source>
        <translation>皮膚に接している、接続されたモーター</translation>
    </message>
    <message>
        <source>no when nothing was felt</source>
        <translation>何も感じないときは「いいえ」と回答</translation>
    </message>
    <message>
        <source>consistent answers; undo the wrong ones or start again</source>
        <translation>感じたことへの回答。誤った回答を取り消すか、最初からやり直してください</translation>
    </message>
</context>
<context>
    <name>FigureExport</name>
    <message>
        <source>The file could not be written: %1</source>
        <translation>ファイルに書き込めませんでした: %1</translation>
    </message>
    <message>
        <source>Unknown picture format &quot;%1&quot;</source>
        <translation>不明な画像形式「%1」</translation>
    </message>
</context>
<context>
    <name>FigureText</name>
    <message>
        <source>Actual pattern</source>
        <translation>実際のパターン</translation>
    </message>
    <message>
        <source>cannot draw the picture: %1</source>
        <translation>画像を描画できません: %1</translation>
    </message>
    <message>
        <source>the picture has no size</source>
        <translation>画像にサイズがありません</translation>
    </message>
    <message>
        <source>the picture would have too many pixels</source>
        <translation>画像の画素数が多すぎます</translation>
    </message>
    <message>
        <source>Force, N</source>
        <translation>力、N</translation>
    </message>
    <message>
        <source>CoP y, mm</source>
        <translation>CoP y、mm</translation>
    </message>
    <message>
        <source>CoC x, mm</source>
        <translation>CoC x、mm</translation>
    </message>
    <message>
        <source>DZMP y, mm</source>
        <translation>DZMP y、mm</translation>
    </message>
    <message>
        <source>α z, °</source>
        <translation>α z、°</translation>
    </message>
    <message>
        <source>Turn z, °</source>
        <translation>z軸回りの回転、°</translation>
    </message>
    <message>
        <source>Tactile servoing: force and features over time</source>
        <translation>触覚サーボ: 力と特徴量の時間変化</translation>
    </message>
    <message>
        <source>desired</source>
        <translation>目標</translation>
    </message>
    <message>
        <source>true</source>
        <translation>真値</translation>
    </message>
    <message>
        <source>in contact</source>
        <translation>接触中</translation>
    </message>
    <message>
        <source>weight is moved; its moment is gone</source>
        <translation>おもりの移動、モーメントの消失</translation>
    </message>
    <message>
        <source>Tactile servoing, simulated</source>
        <translation>触覚サーボ、シミュレーション</translation>
    </message>
    <message>
        <source>Tactile servoing</source>
        <translation>触覚サーボ</translation>
    </message>
    <message>
        <source>a limit acts (%1)</source>
        <translation>制限が作用中 (%1)</translation>
    </message>
    <message>
        <source>time, s</source>
        <translation>時間、s</translation>
    </message>
    <message>
        <source>Subject response, %</source>
        <translation>参加者の応答、%</translation>
    </message>
    <message>
        <source>Subject response, trials</source>
        <translation>参加者の応答、試行数</translation>
    </message>
    <message>
        <source>Subject response, % and trials</source>
        <translation>参加者の応答、%と試行数</translation>
    </message>
    <message>
        <source>Position, mm</source>
        <translation>位置、mm</translation>
    </message>
    <message>
        <source>Path, mm</source>
        <translation>経路、mm</translation>
    </message>
</context>
<context>
    <name>FileApartText</name>
    <message>
        <source>reading it takes too long</source>
        <translation>読み取りに時間がかかりすぎます</translation>
    </message>
    <message>
        <source>reading it takes too much memory</source>
        <translation>読み取りにメモリーを使いすぎます</translation>
    </message>
    <message>
        <source>the library that reads it stopped unexpectedly</source>
        <translation>読み取るライブラリーが停止しました</translation>
    </message>
    <message>
        <source>the file changed while it was read</source>
        <translation>読み取り中にファイルが変わりました</translation>
    </message>
    <message>
        <source>no process can be started to read the file: %1</source>
        <translation>ファイルを読むプロセスを開始できません：%1</translation>
    </message>
    <message>
        <source>the file is damaged: %1</source>
        <translation>ファイルが壊れています：%1</translation>
    </message>
    <message>
        <source>a whole file</source>
        <translation>完全なファイル</translation>
    </message>
</context>
<context>
    <name>FileKeysText</name>
    <message>
        <source>&quot;%1&quot; is not a topic name</source>
        <translation>「%1」はトピックの名前ではありません</translation>
    </message>
    <message>
        <source>parts of letters, digits and _ after slashes, for example /joint_states</source>
        <translation>/の後に英字・数字・_からなる部分。例: /joint_states</translation>
    </message>
</context>
<context>
    <name>FileKindText</name>
    <message>
        <source>text</source>
        <translation>テキスト</translation>
    </message>
    <message>
        <source>a NumPy array (npy)</source>
        <translation>NumPy配列 (npy)</translation>
    </message>
    <message>
        <source>a zip archive (npz is one)</source>
        <translation>zipアーカイブ (npzもその一種)</translation>
    </message>
    <message>
        <source>an HDF5 file</source>
        <translation>HDF5ファイル</translation>
    </message>
    <message>
        <source>a MAT file</source>
        <translation>MATファイル</translation>
    </message>
    <message>
        <source>a MAT file of version 7.3</source>
        <translation>MATファイル (バージョン7.3)</translation>
    </message>
    <message>
        <source>an SQLite database, such as a recording</source>
        <translation>SQLiteデータベース (記録など)</translation>
    </message>
    <message>
        <source>an MCAP file</source>
        <translation>MCAPファイル</translation>
    </message>
    <message>
        <source>a file that gzip has packed</source>
        <translation>gzipで圧縮されたファイル</translation>
    </message>
    <message>
        <source>a file that zstd has packed</source>
        <translation>zstdで圧縮されたファイル</translation>
    </message>
    <message>
        <source>a PNG picture</source>
        <translation>PNG画像</translation>
    </message>
    <message>
        <source>a JPEG picture</source>
        <translation>JPEG画像</translation>
    </message>
    <message>
        <source>a PDF document</source>
        <translation>PDF文書</translation>
    </message>
    <message>
        <source>an old Excel file</source>
        <translation>旧形式のExcelファイル</translation>
    </message>
    <message>
        <source>a Parquet file</source>
        <translation>Parquetファイル</translation>
    </message>
    <message>
        <source>a pickle of Python</source>
        <translation>Pythonのpickle</translation>
    </message>
    <message>
        <source>a video</source>
        <translation>動画</translation>
    </message>
    <message>
        <source>a WAV sound</source>
        <translation>WAV音声</translation>
    </message>
    <message>
        <source>text in UTF-16</source>
        <translation>UTF-16のテキスト</translation>
    </message>
    <message>
        <source>binary data of no known format</source>
        <translation>未知の形式のバイナリデータ</translation>
    </message>
</context>
<context>
    <name>FileText</name>
    <message>
        <source>one of %1</source>
        <translation>次のいずれか: %1</translation>
    </message>
    <message>
        <source>there are %1 motors</source>
        <translation>モーターが%1個あります</translation>
    </message>
    <message>
        <source>there is no such file or built-in pattern</source>
        <translation>そのようなファイルまたは組み込みパターンはありません</translation>
    </message>
    <message>
        <source>this format holds one tactor, the pattern uses more</source>
        <translation>この形式が保持できるタクタは1つですが、パターンは複数使用しています</translation>
    </message>
    <message>
        <source>a name that ends with %1</source>
        <translation>%1 で終わる名前</translation>
    </message>
    <message>
        <source>these values are inconsistent</source>
        <translation>これらの値は矛盾しています</translation>
    </message>
    <message>
        <source>0 &lt; start_drive &lt; full_drive, and a curve that rises from the start or below it to drive 1</source>
        <translation>0 &lt; start_drive &lt; full_drive、始動点またはその手前から駆動量1まで上昇する曲線</translation>
    </message>
    <message>
        <source>the file was written by a newer version</source>
        <translation>ファイルのバージョンが新しすぎます</translation>
    </message>
    <message>
        <source>the profile belongs to the bracelet &quot;%1&quot;</source>
        <translation>プロファイルはブレスレット「%1」のものです</translation>
    </message>
    <message>
        <source>a pattern file, or an id listed by teleta pattern list</source>
        <translation>パターンファイル、またはteleta pattern listのid</translation>
    </message>
    <message>
        <source>the file name extension is unknown</source>
        <translation>名前の拡張子から形式を判別できません</translation>
    </message>
    <message>
        <source>this format can be written but not read</source>
        <translation>この形式のパターンは書き込みのみで、読み取りはできません</translation>
    </message>
</context>
<context>
    <name>FinderNames</name>
    <message>
        <source>As published</source>
        <translation>論文の方法</translation>
    </message>
    <message>
        <source>Printed dots</source>
        <translation>印刷された点</translation>
    </message>
    <message>
        <source>Coarse flow</source>
        <translation>粗いフロー</translation>
    </message>
    <message>
        <source>Quick flow</source>
        <translation>速いフロー</translation>
    </message>
    <message>
        <source>Fine flow</source>
        <translation>細かいフロー</translation>
    </message>
    <message>
        <source>%1, changed parts</source>
        <comment>a finder that looks only at those</comment>
        <translation>%1、変化した部分</translation>
    </message>
    <message>
        <source>%1, from the last picture</source>
        <comment>a finder that starts there</comment>
        <translation>%1、前の画像から</translation>
    </message>
    <message>
        <source>%1, 1 : %2</source>
        <comment>a finder and how many times its picture is smaller</comment>
        <translation>%1、1 : %2</translation>
    </message>
    <message>
        <source>%1, whole picture</source>
        <comment>a finder</comment>
        <translation>%1、画像全体</translation>
    </message>
    <message>
        <source>%1 % of the picture&apos;s points</source>
        <translation>画像の点の%1 %</translation>
    </message>
    <message>
        <source>fine; %1, mean of those that moved</source>
        <translation>細かい。%1、動いた点の平均</translation>
    </message>
    <message>
        <source>follows each dot alone; the default</source>
        <translation>点だけを追います。既定</translation>
    </message>
    <message>
        <source>quickest and coarsest; %1</source>
        <translation>最も速く最も粗い。%1</translation>
    </message>
    <message>
        <source>quick; %1, where they differ from the reference</source>
        <translation>速い。%1、基準と異なる所だけ</translation>
    </message>
    <message>
        <source>quick; %1</source>
        <translation>速い。%1</translation>
    </message>
    <message>
        <source>slowest and finest; %1</source>
        <translation>最も遅く最も細かい。%1</translation>
    </message>
    <message>
        <source>As in the published work: dense flow in a picture of 512 × 288, and the mean of the points that moved</source>
        <translation>論文と同じ方法: 512 × 288の画像での密オプティカルフローと、そこで動いた部分の平均</translation>
    </message>
    <message>
        <source>Each printed dot is followed in the whole picture. The default.</source>
        <translation>印刷された各ドットを元の大きさの画像で追跡します。既定の方法です。</translation>
    </message>
    <message>
        <source>the quickest and coarsest</source>
        <translation>最も速く最も粗い</translation>
    </message>
    <message>
        <source>a quick one</source>
        <translation>速い</translation>
    </message>
    <message>
        <source>the slowest and finest</source>
        <translation>最も遅く最も細かい</translation>
    </message>
    <message>
        <source>Dense flow by a preset of OpenCV (%1), in a picture %2 times smaller</source>
        <translation>OpenCVのプリセット（%1）による密オプティカルフロー、%2分の1の大きさの画像で計算</translation>
    </message>
    <message>
        <source>Dense flow by a preset of OpenCV (%1), in the whole picture</source>
        <translation>OpenCVのプリセット（%1）による密オプティカルフロー、元の大きさの画像で計算</translation>
    </message>
    <message>
        <source>Only where the picture differs from the reference</source>
        <translation>基準と異なる部分の周りだけ</translation>
    </message>
    <message>
        <source>Starts from the flow of the previous picture</source>
        <translation>前の画像のフローから始めます</translation>
    </message>
</context>
<context>
    <name>ForeignDatabase</name>
    <message>
        <source>SQLite cannot be made defensive</source>
        <translation>SQLiteを防御モードにできません</translation>
    </message>
    <message>
        <source>SQLite %1 or newer</source>
        <translation>SQLite %1以降</translation>
    </message>
    <message>
        <source>the file holds a %1, &quot;%2&quot;, which this program does not make</source>
        <comment>view, trigger or (virtual) table of a database</comment>
        <translation>ファイルに、このプログラムが作らない%1「%2」があります</translation>
    </message>
    <message>
        <source>plain tables and indices only</source>
        <translation>通常の表と索引のみ</translation>
    </message>
</context>
<context>
    <name>FrameFileText</name>
    <message>
        <source>column %1 is &quot;%2&quot;</source>
        <translation>列%1が「%2」です</translation>
    </message>
    <message>
        <source>there are no taxel columns</source>
        <translation>タクセルの列がありません</translation>
    </message>
    <message>
        <source>the columns time_s, t0, t1, ...</source>
        <translation>列 time_s, t0, t1, ...</translation>
    </message>
    <message>
        <source>the file has %1 taxel columns</source>
        <translation>ファイルのタクセル列は%1個です</translation>
    </message>
    <message>
        <source>%1 = %2 rows x %3 columns</source>
        <translation>%1 = %2行 x %3列</translation>
    </message>
    <message>
        <source>the recording has no frames</source>
        <translation>記録にフレームがありません</translation>
    </message>
    <message>
        <source>the time is %1</source>
        <translation>時刻が%1です</translation>
    </message>
    <message>
        <source>a finite time in s</source>
        <translation>有限の時刻 (s)</translation>
    </message>
    <message>
        <source>the time goes back from %1 to %2</source>
        <translation>時刻が%1から%2に戻っています</translation>
    </message>
    <message>
        <source>times that do not decrease</source>
        <translation>減少しない時刻</translation>
    </message>
    <message>
        <source>at least one row after the header</source>
        <translation>ヘッダーの後に1行以上</translation>
    </message>
    <message>
        <source>the frames are of vectors, t0_x,t0_y,t0_z</source>
        <translation>フレームはベクトルです（t0_x,t0_y,t0_z）</translation>
    </message>
    <message>
        <source>one number a taxel; or the file that says where the taxels are (--layout FILE.toml)</source>
        <translation>タクセルごとに1つの数。またはタクセルの場所を示すファイル（--layout FILE.toml）</translation>
    </message>
</context>
<context>
    <name>FrameImportText</name>
    <message>
        <source>interrupted</source>
        <translation>中断されました</translation>
    </message>
    <message>
        <source>the frames span more than %1 years</source>
        <translation>フレームの期間が%1年を超えています</translation>
    </message>
    <message>
        <source>times in seconds, or their unit (--time-unit UNIT)</source>
        <translation>秒単位の時刻、またはその単位（--time-unit UNIT）</translation>
    </message>
</context>
<context>
    <name>FrameOptionText</name>
    <message>
        <source>%1 is given, a taxel from 0 to %2 is expected</source>
        <translation>%1が指定されましたが、0から%2までのタクセルが必要です</translation>
    </message>
    <message>
        <source>Rows of the array</source>
        <translation>アレイの行数</translation>
    </message>
    <message>
        <source>Distance of neighbouring taxels in mm</source>
        <translation>隣り合うタクセルの間隔 (mm)</translation>
    </message>
    <message>
        <source>The raw values fall under load</source>
        <translation>荷重がかかると生の値が下がる</translation>
    </message>
    <message>
        <source>N per raw unit</source>
        <translation>生の値1単位あたりのN</translation>
    </message>
    <message>
        <source>Numbers of taxels to leave out, such as 0,17</source>
        <translation>除外するタクセルの番号。例: 0,17</translation>
    </message>
    <message>
        <source>Weight the taxels with their load to find the principal axis</source>
        <translation>荷重でタクセルを重み付けして主軸を求める</translation>
    </message>
    <message>
        <source>Find the threshold in each frame; --threshold is the least</source>
        <translation>フレームごとにしきい値を求める。--thresholdが下限</translation>
    </message>
    <message>
        <source>Force and centre of pressure over taxels in contact, not over the whole array</source>
        <translation>力と圧力中心を、アレイ全体ではなく接触中のタクセルから求める</translation>
    </message>
    <message>
        <source>Summits that rise less than this share of the frame&apos;s peak are no contacts of their own</source>
        <translation>フレームのピークに対する割合がこれより小さい山は独立した接触としない</translation>
    </message>
    <message>
        <source>Contacts of fewer taxels are dropped</source>
        <translation>これより少ないタクセルの接触は除外する</translation>
    </message>
    <message>
        <source>the output would replace the input</source>
        <translation>出力が入力を上書きしてしまいます</translation>
    </message>
    <message>
        <source>Gains of the taxels, as &quot;teleta gains&quot; writes them</source>
        <translation>タクセルのゲイン。「teleta gains」が書き出すもの</translation>
    </message>
    <message>
        <source>%1 is given, a number of columns, or columns such as 2..85 are expected</source>
        <translation>%1が指定されましたが、列数、または2..85のような列の範囲が必要です</translation>
    </message>
    <message>
        <source>Columns of the array; or columns of a table of another program that are taxels, from 1, such as 2..85</source>
        <translation>アレイの列数。または、他のプログラムの表でタクセルにあたる列 (1から数える)。例: 2..85</translation>
    </message>
    <message>
        <source>Frames per second of a file without times</source>
        <translation>時刻のないファイルの毎秒のフレーム数</translation>
    </message>
    <message>
        <source>Name of the frames in a file of several arrays</source>
        <translation>複数の配列を含むファイルでのフレームの名前</translation>
    </message>
    <message>
        <source>Dimension of the array that counts the frames</source>
        <translation>フレームを数える配列の次元</translation>
    </message>
    <message>
        <source>Name or number of the column of the times in a table of another program</source>
        <translation>他のプログラムの表での時刻の列の名前または番号</translation>
    </message>
    <message>
        <source>Unit of these times; default: as the name of the column ends</source>
        <translation>この時刻の単位。既定値: 列名の末尾から決定</translation>
    </message>
    <message>
        <source>Recorded frames: CSV time_s,t0,t1,... with one row a frame, row-major, or a file of another program</source>
        <translation>記録したフレーム: CSV time_s,t0,t1,... (1行に1フレーム、行優先)、または他のプログラムのファイル</translation>
    </message>
    <message>
        <source>The values are in %1, not in N: give the N of one unit with --gain.</source>
        <translation>値の単位がNではなく%1です: 1単位あたりのNを--gainで指定してください。</translation>
    </message>
    <message>
        <source>Frames of the unloaded array, whose mean is subtracted; or of the recording itself the median of each taxel, the mean of the first half second, or its value while it is untouched, in at least one frame in ten</source>
        <translation>無負荷のアレイのフレーム（平均を引く）。または記録自身から、各タクセルの中央値、最初の 0.5 秒の平均、あるいは触れられていない（10 フレームに 1 つ以上）ときの値</translation>
    </message>
    <message>
        <source>Add the place of deepest pressure, finer than the taxels, also on a strip</source>
        <translation>最も強く押された位置をタクセルより細かく追加する（一列のセンサーでも）</translation>
    </message>
    <message>
        <source>Standard deviation of a taxel&apos;s load at rest in N, for the standard errors of the summit</source>
        <translation>静止時のタクセル荷重の標準偏差（N）。頂点の標準誤差に使う</translation>
    </message>
    <message>
        <source>Where the taxels are and what each tells, also off a grid and as vectors: the table [layout] of a device file</source>
        <translation>タクセルの場所と、それぞれの値。格子の外やベクトルも可: デバイスファイルの表[layout]</translation>
    </message>
    <message>
        <source>it says rows, columns and pitch itself</source>
        <translation>行、列、間隔はそのファイルが示します</translation>
    </message>
    <message>
        <source>&apos;untouched&apos; is for loads, but each taxel tells three values</source>
        <translation>「untouched」は荷重用ですが、各タクセルは3つの値を示します</translation>
    </message>
    <message>
        <source>These lines of the file have no effect: %1.</source>
        <translation>ファイルの次の行は効果がありません: %1。</translation>
    </message>
    <message>
        <source>this is for loads on a grid</source>
        <translation>これは格子上の荷重のためのものです</translation>
    </message>
    <message>
        <source>the loads are in %1: write from how many %1 a taxel is in contact, such as five times the noise at rest</source>
        <translation>荷重の単位は%1です。何%1からタクセルを接触とみなすかを書いてください (静止時の雑音の5倍など)</translation>
    </message>
    <message>
        <source>Load from which a taxel is in contact, in N or the unit of the file; 0.2 unless that is another one than N and counts</source>
        <translation>タクセルが接触とみなされる荷重 (Nまたはファイルの単位)。単位がNでもカウントでもないときを除き0.2</translation>
    </message>
</context>
<context>
    <name>FrameReaderText</name>
    <message>
        <source>the file is %1</source>
        <translation>ファイルの形式は%1です</translation>
    </message>
    <message>
        <source>the frames do not fit into the memory</source>
        <translation>フレームがメモリに収まりません</translation>
    </message>
    <message>
        <source>the file has times of its own, in time_s</source>
        <translation>ファイル自体に時刻 (time_s) があります</translation>
    </message>
    <message>
        <source>no rate</source>
        <translation>レートの指定なし</translation>
    </message>
    <message>
        <source>the file</source>
        <translation>ファイル</translation>
    </message>
    <message>
        <source>frames as CSV, npy, npz, HDF5, MAT, or Tekscan ASCII</source>
        <translation>CSV、npy、npz、HDF5、MAT、または Tekscan ASCII のフレーム</translation>
    </message>
    <message>
        <source>the file says itself where its taxels are</source>
        <translation>ファイル自体がタクセルの場所を示しています</translation>
    </message>
    <message>
        <source>no layout</source>
        <translation>配置なし</translation>
    </message>
    <message>
        <source>the recording is too long</source>
        <translation>記録が長すぎます</translation>
    </message>
    <message>
        <source>at most %1 values</source>
        <translation>%1個以下の値</translation>
    </message>
    <message>
        <source>%1; of a table of another program, which columns are times and taxels (%2)</source>
        <translation>%1。他のプログラムの表なら、時刻とタクセルの列（%2）</translation>
    </message>
</context>
<context>
    <name>GainMap</name>
    <message>
        <source>dead</source>
        <translation>不良</translation>
    </message>
    <message>
        <source>too weak</source>
        <translation>弱すぎ</translation>
    </message>
    <message>
        <source>too strong</source>
        <translation>強すぎ</translation>
    </message>
    <message>
        <source>stuck</source>
        <translation>固着</translation>
    </message>
    <message>
        <source>Taxel %1, row %2, column %3</source>
        <translation>タクセル %1、行 %2、列 %3</translation>
    </message>
    <message>
        <source>%1, not used</source>
        <translation>%1、不使用</translation>
    </message>
</context>
<context>
    <name>GainsCommand</name>
    <message>
        <source>Frames under load</source>
        <translation>荷重下のフレーム</translation>
    </message>
    <message>
        <source>Taxels used</source>
        <translation>使用するタクセル</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%2個中%1個</translation>
    </message>
    <message>
        <source>Gains</source>
        <translation>ゲイン</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1〜%2</translation>
    </message>
    <message>
        <source>Largest standard error</source>
        <translation>最大の標準誤差</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Not explained</source>
        <translation>説明されない分</translation>
    </message>
    <message>
        <source>%1 % of the level</source>
        <translation>荷重レベルの%1 %</translation>
    </message>
    <message>
        <source>Tilt</source>
        <translation>傾き</translation>
    </message>
    <message>
        <source>%1 % along x, %2 % along y</source>
        <translation>x方向に%1 %、y方向に%2 %</translation>
    </message>
    <message>
        <source>From press to press</source>
        <translation>押圧ごとの差</translation>
    </message>
    <message>
        <source>These taxels are not used: %1.</source>
        <translation>これらのタクセルは使用されません: %1。</translation>
    </message>
    <message>
        <source>The response changes by %1 % along x and %2 % along y: the load may have been uneven. Turn what presses round by half, press again and give both files.</source>
        <translation>応答がx方向に%1 %、y方向に%2 %変化しています。荷重が均一でなかった可能性があります。押すものを半回転させてもう一度押し、両方のファイルを指定してください。</translation>
    </message>
    <message>
        <source>Gain of each taxel from frames under an even load</source>
        <translation>均一な荷重下のフレームから各タクセルのゲインを求める</translation>
    </message>
    <message>
        <source>Recorded frames in which an even load presses on the whole array, a file a press: time_s,t0,t1,...</source>
        <translation>均一な荷重がアレイ全体を押す記録フレーム、押圧ごとに1ファイル: time_s,t0,t1,...</translation>
    </message>
</context>
<context>
    <name>GaugeTexts</name>
    <message>
        <source>no stiffness</source>
        <translation>剛性なし</translation>
    </message>
    <message>
        <source>%1, level %2</source>
        <translation>%1、レベル%2</translation>
    </message>
    <message>
        <source>taken as %1, level %2</source>
        <translation>%1とみなす、レベル%2</translation>
    </message>
    <message>
        <source>%1, level %2, not certain</source>
        <translation>%1、レベル%2、不確実</translation>
    </message>
    <message numerus="yes">
        <source>%n sample(s)</source>
        <translation>
            <numerusform>%nサンプル</numerusform>
        </translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1、%2</translation>
    </message>
    <message>
        <source>95 %: %1   %2</source>
        <translation>95 %: %1   %2</translation>
    </message>
    <message>
        <source>not told from rigid   %1</source>
        <translation>剛体と区別できません   %1</translation>
    </message>
    <message>
        <source>no interval known   %1</source>
        <translation>区間は不明   %1</translation>
    </message>
    <message>
        <source>Stiffer than the link allows: check contact distance and link stiffness.</source>
        <translation>リンクが許す値より硬い結果です: 接触距離とリンク剛性を確認してください。</translation>
    </message>
    <message>
        <source>level %1, %2, the paper&apos;s object %3</source>
        <translation>レベル%1、%2、論文の物体%3</translation>
    </message>
    <message>
        <source>rigid</source>
        <translation>剛体</translation>
    </message>
    <message>
        <source>%1: from %2
%3</source>
        <translation>%1: %2以上
%3</translation>
    </message>
    <message>
        <source>%1: under %2
%3</source>
        <translation>%1: %2未満
%3</translation>
    </message>
    <message>
        <source>%1: %2 to %3
%4</source>
        <translation>%1: %2～%3
%4</translation>
    </message>
    <message>
        <source>No stiffness. %1</source>
        <translation>剛性なし。%1</translation>
    </message>
    <message>
        <source>no touch yet</source>
        <translation>タッチはまだありません</translation>
    </message>
    <message>
        <source>cannot tell</source>
        <translation>判定不能</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>stale, %1 ago</source>
        <translation>古い、%1前</translation>
    </message>
    <message>
        <source>%1 ago</source>
        <translation>%1前</translation>
    </message>
</context>
<context>
    <name>GelFollower</name>
    <message>
        <source>The picture could not be decoded.</source>
        <translation>画像を復号できませんでした。</translation>
    </message>
    <message>
        <source>The gel at rest cannot be taken: %1</source>
        <translation>静止状態のゲルを取れません：%1</translation>
    </message>
    <message>
        <source>The picture has no contrast: is the camera covered?</source>
        <translation>画像にコントラストがありません。カメラが覆われていませんか？</translation>
    </message>
    <message>
        <source>More than 30 % of the markers have been lost for 1 s: is the gel torn?</source>
        <translation>マーカーの30 %以上を1秒間見失っています。ゲルが破れていませんか？</translation>
    </message>
    <message>
        <source>The light has jumped.</source>
        <translation>明るさが急に変わりました。</translation>
    </message>
    <message>
        <source>The recorded pictures of the gel at rest have another size than the video.</source>
        <translation>記録された静止時のゲルの画像の大きさが、動画と異なります。</translation>
    </message>
</context>
<context>
    <name>GelPicture</name>
    <message>
        <source>slip %1</source>
        <translation>滑り %1</translation>
    </message>
    <message>
        <source>slip unknown</source>
        <translation>滑り不明</translation>
    </message>
    <message>
        <source>Contact %1</source>
        <translation>接触 %1</translation>
    </message>
    <message>
        <source>at %1, %2</source>
        <translation>位置 %1、%2</translation>
    </message>
    <message>
        <source>area %1 mm²</source>
        <translation>面積 %1 mm²</translation>
    </message>
    <message>
        <source>shear %1 at %2°</source>
        <translation>せん断 %1、方向 %2°</translation>
    </message>
    <message>
        <source>turned by %1°</source>
        <translation>回転 %1°</translation>
    </message>
    <message>
        <source>slip index %1</source>
        <translation>滑り指数 %1</translation>
    </message>
    <message>
        <source>too few markers for a slip index</source>
        <translation>マーカーが少なすぎて滑り指数を求められません</translation>
    </message>
    <message>
        <source>No picture yet</source>
        <translation>画像はまだありません</translation>
    </message>
    <message>
        <source>%1 mm (enlarged %2 times)</source>
        <translation>%1 mm（%2倍に拡大）</translation>
    </message>
    <message>
        <source>PAUSED</source>
        <translation>一時停止中</translation>
    </message>
    <message>
        <source>load %1</source>
        <translation>荷重 %1</translation>
    </message>
    <message>
        <source>shear along x %1</source>
        <translation>x方向のせん断 %1</translation>
    </message>
    <message>
        <source>shear along y %1</source>
        <translation>y方向のせん断 %1</translation>
    </message>
    <message>
        <source>moment %1</source>
        <translation>モーメント %1</translation>
    </message>
    <message>
        <source>extrapolated</source>
        <comment>loads</comment>
        <translation>外挿</translation>
    </message>
</context>
<context>
    <name>GelPlane</name>
    <message>
        <source>The lens in the file folds within the picture.</source>
        <translation>ファイルのレンズは画像の中で折り返します。</translation>
    </message>
    <message>
        <source>a lens that shows each place once</source>
        <translation>各点を一度だけ写すレンズ</translation>
    </message>
    <message>
        <source>The homography sends pixels of the picture to infinity.</source>
        <translation>ホモグラフィーが画像の画素を無限遠に写します。</translation>
    </message>
    <message>
        <source>a matrix that maps the picture onto a plane</source>
        <translation>画像を平面に写す行列</translation>
    </message>
</context>
<context>
    <name>GelRun</name>
    <message>
        <source>the gel at rest could not be found: %1</source>
        <translation>静止状態のゲルが見つかりませんでした：%1</translation>
    </message>
    <message>
        <source>the scene ends before the gel at rest is known</source>
        <translation>静止時のゲルが分かる前にシーンが終わります</translation>
    </message>
    <message>
        <source>at least %1 pictures</source>
        <translation>少なくとも%1枚の画像</translation>
    </message>
</context>
<context>
    <name>GelText</name>
    <message>
        <source>Only %1 markers were found in the picture.</source>
        <translation>画像から見つかったマーカーは%1個だけです。</translation>
    </message>
    <message>
        <source>at least %1 round spots of one size; check channel, marker and diameter_px in the sensor file</source>
        <translation>同じ大きさの丸い点が%1個以上。センサーファイルのchannel、marker、diameter_pxを確認してください</translation>
    </message>
    <message>
        <source>The crop reaches out of the picture of %1 x %2 pixels.</source>
        <translation>切り抜きが %1 x %2 画素の画像からはみ出します。</translation>
    </message>
    <message>
        <source>x + width and y + height within the picture</source>
        <translation>x + 幅と y + 高さが画像の中</translation>
    </message>
    <message>
        <source>The picture is black.</source>
        <translation>画像が真っ黒です。</translation>
    </message>
    <message>
        <source>The picture has no contrast.</source>
        <translation>画像にコントラストがありません。</translation>
    </message>
    <message>
        <source>a picture of the gel&apos;s markers</source>
        <translation>ゲルのマーカーの画像</translation>
    </message>
    <message>
        <source>The picture shows no grid of %1 x %2 markers: %3 spots, %4 of them in a grid.</source>
        <translation>画像に %1 x %2 のマーカーの格子がありません。点 %3 個、うち格子上 %4 個。</translation>
    </message>
    <message>
        <source>The markers form no hexagonal grid: %1 of %2 spots do.</source>
        <translation>マーカーが六角格子をなしていません。%2 個の点のうち %1 個です。</translation>
    </message>
    <message>
        <source>the grid that the sensor&apos;s file names</source>
        <translation>センサーのファイルにある格子</translation>
    </message>
    <message>
        <source>The size of the picture has changed to %1 x %2.</source>
        <translation>画像の大きさが %1 x %2 に変わりました。</translation>
    </message>
    <message>
        <source>%1 x %2 pixels, as at the beginning</source>
        <translation>最初と同じ %1 x %2 画素</translation>
    </message>
</context>
<context>
    <name>HandStation</name>
    <message>
        <source>3D mouse: none is plugged in.</source>
        <translation>3Dマウス: 接続されていません。</translation>
    </message>
    <message>
        <source>3D mouse: %1</source>
        <translation>3Dマウス: %1</translation>
    </message>
    <message>
        <source>3D mouse %1: moves the tip.</source>
        <translation>3Dマウス %1: 先端を動かします。</translation>
    </message>
    <message>
        <source>3D mouse %1: hold its first button to move the tip.</source>
        <translation>3Dマウス %1: 第1ボタンを押しながら先端を動かします。</translation>
    </message>
    <message>
        <source>3D mouse</source>
        <translation>3Dマウス</translation>
    </message>
</context>
<context>
    <name>Hdf5FileText</name>
    <message>
        <source>the file has too many datasets</source>
        <translation>ファイルのデータセットが多すぎます</translation>
    </message>
    <message>
        <source>at most %1</source>
        <translation>最大 %1</translation>
    </message>
    <message>
        <source>the HDF5 file is damaged: %1</source>
        <translation>HDF5 ファイルが壊れています：%1</translation>
    </message>
    <message>
        <source>a whole HDF5 file</source>
        <translation>完全な HDF5 ファイル</translation>
    </message>
    <message>
        <source>it is damaged: %1</source>
        <translation>壊れています：%1</translation>
    </message>
    <message>
        <source>it has no values</source>
        <translation>値がありません</translation>
    </message>
    <message>
        <source>it contains text</source>
        <translation>文字列が入っています</translation>
    </message>
    <message>
        <source>its values are compound</source>
        <translation>値が複数の部分から成ります</translation>
    </message>
    <message>
        <source>its values are not real numbers</source>
        <translation>値が実数ではありません</translation>
    </message>
    <message>
        <source>its values are stored in other files</source>
        <translation>値が別のファイルにあります</translation>
    </message>
    <message>
        <source>it is compressed with %1; only gzip and shuffle can be read</source>
        <translation>%1 で圧縮されています。読めるのは gzip と shuffle です</translation>
    </message>
    <message>
        <source>its values were never written</source>
        <translation>値が一度も書かれていません</translation>
    </message>
</context>
<context>
    <name>HeatmapPainter</name>
    <message>
        <source>fixed</source>
        <translation>固定</translation>
    </message>
    <message>
        <source>auto</source>
        <translation>自動</translation>
    </message>
    <message>
        <source>force</source>
        <translation>力</translation>
    </message>
    <message>
        <source>contacts</source>
        <translation>接触</translation>
    </message>
    <message>
        <source>type</source>
        <translation>種類</translation>
    </message>
    <message>
        <source>none</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>point</source>
        <translation>点</translation>
    </message>
    <message>
        <source>edge</source>
        <translation>エッジ</translation>
    </message>
    <message>
        <source>centre of pressure</source>
        <translation>圧力中心</translation>
    </message>
    <message>
        <source>centre of contact</source>
        <translation>接触中心</translation>
    </message>
    <message>
        <source>axis %1°</source>
        <translation>軸 %1°</translation>
    </message>
    <message>
        <source>threshold %1</source>
        <translation>しきい値 %1</translation>
    </message>
    <message>
        <source>dead %1</source>
        <translation>不良 %1</translation>
    </message>
    <message>
        <source>Point at a taxel to read it.</source>
        <translation>タクセルを指すと値を読み取れます。</translation>
    </message>
    <message>
        <source>No new data: the last frame is shown.</source>
        <translation>新しいデータがありません。最後のフレームを表示しています。</translation>
    </message>
    <message>
        <source>shear</source>
        <translation>せん断</translation>
    </message>
    <message>
        <source>shear, a taxel&apos;s width is %1</source>
        <translation>せん断、タクセルの幅が%1</translation>
    </message>
    <message>
        <source>extrapolated</source>
        <comment>loads</comment>
        <translation>外挿</translation>
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
        <source>several</source>
        <comment>contacts</comment>
        <translation>複数</translation>
    </message>
</context>
<context>
    <name>HeatmapView</name>
    <message>
        <source>dead</source>
        <translation>不良</translation>
    </message>
    <message>
        <source>contact #%1</source>
        <translation>接触 #%1</translation>
    </message>
    <message>
        <source>no contact</source>
        <translation>接触なし</translation>
    </message>
    <message>
        <source>no taxel</source>
        <translation>タクセルなし</translation>
    </message>
    <message>
        <source>shear %1</source>
        <translation>せん断 %1</translation>
    </message>
    <message>
        <source>row %1, column %2</source>
        <translation>行%1、列%2</translation>
    </message>
    <message>
        <source>taxel %1</source>
        <translation>タクセル%1</translation>
    </message>
    <message>
        <source>%1   %2   %3   x %4 mm, y %5 mm</source>
        <translation>%1   %2   %3   x %4 mm, y %5 mm</translation>
    </message>
    <message>
        <source>contact #%1 with shear %2, friction %3</source>
        <extracomment>Of a contact: the force along the surface, and it divided by the force into the surface</extracomment>
        <translation>接触 #%1、せん断 %2、摩擦 %3</translation>
    </message>
</context>
<context>
    <name>IdentifierText</name>
    <message>
        <source>&quot;%1&quot; cannot be part of a file name</source>
        <translation>「%1」はファイル名に使えません</translation>
    </message>
    <message>
        <source>letters, digits, - and _</source>
        <translation>英字、数字、- および _</translation>
    </message>
    <message>
        <source>each one once</source>
        <translation>それぞれ1回のみ</translation>
    </message>
    <message>
        <source>&quot;%1&quot; occurs twice</source>
        <translation>「%1」が2回あります</translation>
    </message>
</context>
<context>
    <name>ImportCommand</name>
    <message>
        <source>left out</source>
        <translation>除外</translation>
    </message>
    <message numerus="yes">
        <source>%n message(s)</source>
        <translation>
            <numerusform>%n件のメッセージ</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n damaged or of another shape</source>
        <translation>
            <numerusform>破損または形の異なるもの%n件</numerusform>
        </translation>
    </message>
    <message>
        <source>Note</source>
        <translation>メモ</translation>
    </message>
    <message>
        <source>The file was cut off: %1 of %2 bytes could be read.</source>
        <translation>ファイルが途中で切れています: %2バイト中%1バイトを読み取れました。</translation>
    </message>
    <message numerus="yes">
        <source>%n damaged chunk(s) left out</source>
        <translation>
            <numerusform>破損した%nチャンクを除外</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n damaged record(s) left out</source>
        <translation>
            <numerusform>破損した%nレコードを除外</numerusform>
        </translation>
    </message>
    <message>
        <source>The checksum of the file is wrong: it was damaged somewhere.</source>
        <translation>ファイルのチェックサムが誤っています: どこかが破損しています。</translation>
    </message>
    <message>
        <source>Recording to be made</source>
        <translation>作成する記録</translation>
    </message>
    <message>
        <source>Read a topic as array, camera or joints, where its type leaves a choice</source>
        <translation>型から一意に決まらないトピックを、array、camera、またはjointsとして読み取る</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not /TOPIC=array, /TOPIC=camera or /TOPIC=joints</source>
        <translation>「%1」は/TOPIC=array、/TOPIC=camera、/TOPIC=jointsのいずれでもありません</translation>
    </message>
    <message>
        <source>Array</source>
        <translation>アレイ</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>フレーム</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>レート</translation>
    </message>
    <message>
        <source>MCAP file with ROS 2 messages, or frames of an array; the options below supply what a file of frames does not say</source>
        <translation>ROS 2のメッセージのMCAPファイル、またはアレイのフレーム。ファイルにないことは下のオプションで示します</translation>
    </message>
    <message>
        <source>Load in one unit of the values</source>
        <translation>値1単位あたりの荷重</translation>
    </message>
    <message>
        <source>Unit of the loads; default: as the file says, else N or counts, by the array</source>
        <translation>荷重の単位。既定はファイルの記述、なければアレイによりNまたはcounts</translation>
    </message>
    <message>
        <source>this is for MCAP files only</source>
        <translation>これはMCAP用ですが、ファイルはMCAPではありません</translation>
    </message>
    <message>
        <source>this is for frames, not for MCAP files</source>
        <translation>これはフレーム用ですが、ファイルはMCAPです</translation>
    </message>
    <message>
        <source>Make a recording of an MCAP file, or of the frames of another program</source>
        <translation>MCAPファイルまたは他のプログラムのフレームから記録を作る</translation>
    </message>
    <message>
        <source>Load from which a taxel is in contact, in the recording&apos;s settings; 0.2 unless the unit is another one than N and counts</source>
        <translation>記録の設定で、タクセルが接触とみなされる荷重。単位がNでもカウントでもないときを除き0.2</translation>
    </message>
</context>
<context>
    <name>InputFileText</name>
    <message>
        <source>cannot open the file: %1</source>
        <translation>ファイルを開けません: %1</translation>
    </message>
    <message>
        <source>a file</source>
        <translation>ファイル</translation>
    </message>
    <message>
        <source>this is a folder</source>
        <translation>これはフォルダーです</translation>
    </message>
    <message>
        <source>this is a pipe or a device</source>
        <translation>これはパイプまたはデバイスです</translation>
    </message>
    <message>
        <source>cannot read the file: %1</source>
        <translation>ファイルを読めません: %1</translation>
    </message>
    <message>
        <source>the file is too large</source>
        <translation>ファイルが大きすぎます</translation>
    </message>
    <message>
        <source>at most %1 MiB</source>
        <translation>最大%1 MiB</translation>
    </message>
</context>
<context>
    <name>Interruption</name>
    <message>
        <source>interrupted; the output ends with what was computed until then</source>
        <translation>中断されました。出力はそれまでに計算した分で終わっています</translation>
    </message>
</context>
<context>
    <name>JackText</name>
    <message>
        <source>none</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>PipeWire is not running.</source>
        <translation>PipeWireが動いていません。</translation>
    </message>
    <message>
        <source>The JACK server is not running.</source>
        <translation>JACKサーバーが動いていません。</translation>
    </message>
    <message>
        <source>The sound server plays %1 samples a second.</source>
        <translation>サウンドサーバーは毎秒%1サンプルを再生しています。</translation>
    </message>
    <message>
        <source>sample_rate_Hz = %1 in the device file</source>
        <translation>デバイスファイルのsample_rate_Hz = %1</translation>
    </message>
    <message>
        <source>Another program plays on %1.</source>
        <translation>ほかのプログラムが%1で再生しています。</translation>
    </message>
    <message>
        <source>it to be disconnected, or shared = true in the device file</source>
        <translation>その切断、またはデバイスファイルのshared = true</translation>
    </message>
    <message>
        <source>The sound server did not activate the connection.</source>
        <translation>サウンドサーバーが接続を開始しません。</translation>
    </message>
    <message>
        <source>There are several sound cards: %1.</source>
        <translation>サウンドカードが複数あります: %1。</translation>
    </message>
    <message>
        <source>the name of one of them in device</source>
        <translation>deviceにそのいずれかの名前</translation>
    </message>
    <message>
        <source>There is no sound card.</source>
        <translation>サウンドカードがありません。</translation>
    </message>
    <message>
        <source>There is no sound output &quot;%1&quot;.</source>
        <translation>サウンド出力「%1」がありません。</translation>
    </message>
    <message>
        <source>one of: %1</source>
        <translation>次のいずれか: %1</translation>
    </message>
    <message numerus="yes">
        <source>&quot;%1&quot; has %n output(s).</source>
        <translation>
            <numerusform>「%1」の出力は%n個です。</numerusform>
        </translation>
    </message>
    <message>
        <source>an output %1, as channels says</source>
        <translation>channelsが示す出力%1</translation>
    </message>
    <message>
        <source>The sound server refused to create a port for a tactor.</source>
        <translation>サウンドサーバーがアクチュエーター用のポートを用意しません。</translation>
    </message>
    <message>
        <source>Tactor %1 cannot be connected to %2.</source>
        <translation>アクチュエーター%1を%2に接続できません。</translation>
    </message>
    <message>
        <source>The sound server requests no samples.</source>
        <translation>サウンドサーバーがサンプルを要求しません。</translation>
    </message>
    <message>
        <source>The sound server plays %1 samples at a time.</source>
        <translation>サウンドサーバーは一度に%1サンプルを再生しています。</translation>
    </message>
    <message>
        <source>period_frames = %1 in the device file, or a server that plays %2 at a time</source>
        <translation>デバイスファイルのperiod_frames = %1、または一度に%2サンプルを再生するサーバー</translation>
    </message>
</context>
<context>
    <name>JogTargetText</name>
    <message>
        <source>%1 has no arm, or several</source>
        <translation>%1 にはアームがないか、複数あります</translation>
    </message>
    <message>
        <source>%1 has no arm &quot;%2&quot;</source>
        <translation>%1 にアーム「%2」はありません</translation>
    </message>
    <message>
        <source>the arm has no joint &quot;%1&quot;; it has %2</source>
        <translation>アームに関節「%1」がありません。アームにある関節: %2</translation>
    </message>
    <message>
        <source>%1 with one of %2</source>
        <translation>%1 に %2 のいずれか</translation>
    </message>
</context>
<context>
    <name>JsonDocument</name>
    <message>
        <source>the file is too large</source>
        <translation>ファイルが大きすぎます</translation>
    </message>
    <message>
        <source>at most %1 MiB</source>
        <translation>%1 MiB以下</translation>
    </message>
    <message>
        <source>the values are nested too deeply</source>
        <translation>値の入れ子が深すぎます</translation>
    </message>
    <message>
        <source>at most %1 levels</source>
        <translation>%1階層以下</translation>
    </message>
    <message>
        <source>an object has the key &quot;%1&quot; twice</source>
        <translation>オブジェクトにキー「%1」が2回あります</translation>
    </message>
    <message>
        <source>each key once</source>
        <translation>各キーは1回のみ</translation>
    </message>
    <message>
        <source>JSON in UTF-8</source>
        <translation>UTF-8のJSON</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>this is not an object</source>
        <translation>オブジェクトではありません</translation>
    </message>
    <message>
        <source>an object with the key &quot;%1&quot;</source>
        <translation>キー「%1」を持つオブジェクト</translation>
    </message>
    <message>
        <source>the key &quot;%1&quot; is missing</source>
        <translation>キー「%1」がありません</translation>
    </message>
    <message>
        <source>an array of length %1</source>
        <translation>長さ%1の配列</translation>
    </message>
    <message>
        <source>an array of length %1 to %2</source>
        <translation>長さ%1から%2までの配列</translation>
    </message>
    <message>
        <source>this is not an array</source>
        <translation>配列ではありません</translation>
    </message>
    <message>
        <source>a number from %1 to %2</source>
        <translation>%1から%2までの数値</translation>
    </message>
    <message>
        <source>this is not a number</source>
        <translation>数値ではありません</translation>
    </message>
    <message>
        <source>%1 is out of range</source>
        <translation>%1が範囲外です</translation>
    </message>
    <message>
        <source>this is not a whole number</source>
        <translation>整数ではありません</translation>
    </message>
    <message>
        <source>a whole number from %1 to %2</source>
        <translation>%1から%2までの整数</translation>
    </message>
    <message>
        <source>this is neither true nor false</source>
        <translation>trueでもfalseでもありません</translation>
    </message>
    <message>
        <source>this is not text</source>
        <translation>テキストではありません</translation>
    </message>
    <message>
        <source>text</source>
        <translation>テキスト</translation>
    </message>
    <message>
        <source>the JSON text is damaged or truncated</source>
        <translation>JSONテキストが破損しているか途中で切れています</translation>
    </message>
    <message>
        <source>the array has the wrong length</source>
        <translation>配列の長さが正しくありません</translation>
    </message>
</context>
<context>
    <name>KeyListText</name>
    <message>
        <source>a list of %1, each %2</source>
        <translation>%1個の要素からなるリスト。各要素は%2</translation>
    </message>
    <message>
        <source>a list of %1 to %2, each %3</source>
        <translation>%1～%2個の要素からなるリスト。各要素は%3</translation>
    </message>
</context>
<context>
    <name>LadderSweep</name>
    <message>
        <source>there is no such rung</source>
        <translation>その段はありません</translation>
    </message>
    <message>
        <source>there is no ladder &quot;%1&quot;</source>
        <translation>はしご「%1」はありません</translation>
    </message>
    <message>
        <source>one of: %1</source>
        <translation>次のいずれか: %1</translation>
    </message>
    <message>
        <source>unknown key &quot;%1&quot;</source>
        <translation>不明なキー「%1」</translation>
    </message>
    <message>
        <source>rung</source>
        <translation>rung</translation>
    </message>
    <message>
        <source>there is no rung &quot;%1&quot;</source>
        <translation>段「%1」はありません</translation>
    </message>
</context>
<context>
    <name>LanguageMenu</name>
    <message>
        <source>Lan&amp;guage</source>
        <translation>言語(&amp;G)</translation>
    </message>
    <message>
        <source>As the &amp;desktop</source>
        <translation>デスクトップに合わせる(&amp;D)</translation>
    </message>
</context>
<context>
    <name>LastSession</name>
    <message>
        <source>camera</source>
        <translation>カメラ</translation>
    </message>
</context>
<context>
    <name>LevelContent</name>
    <message>
        <source>All participants</source>
        <translation>全参加者</translation>
    </message>
    <message>
        <source>Thresholds of all participants</source>
        <translation>全参加者のしきい値</translation>
    </message>
    <message>
        <source>Levels of %1 over the trials</source>
        <translation>試行にわたる%1のレベル</translation>
    </message>
    <message>
        <source>d&apos; and c of all participants, %1</source>
        <translation>全参加者のd&apos;とc、%1</translation>
    </message>
    <message>
        <source>Participant</source>
        <translation>参加者</translation>
    </message>
    <message>
        <source>Condition</source>
        <translation>条件</translation>
    </message>
    <message>
        <source>Track</source>
        <translation>トラック</translation>
    </message>
    <message>
        <source>Trials</source>
        <translation>試行数</translation>
    </message>
    <message>
        <source>Threshold</source>
        <translation>しきい値</translation>
    </message>
    <message>
        <source>95 %</source>
        <translation>95 %</translation>
    </message>
    <message>
        <source>Spread or slope</source>
        <translation>広がりまたは傾き</translation>
    </message>
    <message>
        <source>Lapses</source>
        <translation>ラプス率</translation>
    </message>
    <message>
        <source>p of fit</source>
        <translation>適合度のp</translation>
    </message>
    <message>
        <source>JND</source>
        <translation>JND</translation>
    </message>
    <message>
        <source>Weber</source>
        <translation>ウェーバー比</translation>
    </message>
    <message>
        <source>What it says</source>
        <translation>内容</translation>
    </message>
    <message>
        <source>Where the curve is half-way between guessing and its upper end; of a comparison the level that feels equal</source>
        <translation>曲線が当て推量の水準と上端の中間になる点。比較では等しいと感じられるレベル</translation>
    </message>
    <message>
        <source>By profile likelihood; of all participants Student&apos;s t of their thresholds. ? stands for an open end</source>
        <translation>プロファイル尤度による。全参加者ではしきい値のStudentのtによる。?は開いた端を表す</translation>
    </message>
    <message>
        <source>s of gauss and logistic, in the unit of the level; the slope b of weibull</source>
        <translation>gaussとlogisticのs (レベルの単位)。weibullの傾きb</translation>
    </message>
    <message>
        <source>Share of mistakes however strong the stimulus is</source>
        <translation>刺激がどれほど強くても生じる誤りの割合</translation>
    </message>
    <message>
        <source>Of the deviance, by data sets that are drawn and fitted again; constant stimuli only</source>
        <translation>逸脱度のp、再抽出して再度当てはめたデータセットによる。恒常法のみ</translation>
    </message>
    <message>
        <source>Just noticeable difference: half of the way from 25 to 75 %</source>
        <translation>丁度可知差異: 25 %から75 %までの幅の半分</translation>
    </message>
    <message>
        <source>JND over the reference</source>
        <translation>JNDを基準で割った値</translation>
    </message>
    <message>
        <source>mean of %1</source>
        <translation>%1名の平均</translation>
    </message>
    <message>
        <source>mean of %1; %2 without threshold</source>
        <translation>%1名の平均。しきい値なし: %2名</translation>
    </message>
    <message>
        <source>All</source>
        <translation>すべて</translation>
    </message>
    <message>
        <source>Mean of reversals</source>
        <translation>反転の平均</translation>
    </message>
    <message>
        <source>Reversals</source>
        <translation>反転数</translation>
    </message>
    <message>
        <source>Posterior mean</source>
        <translation>事後平均</translation>
    </message>
    <message>
        <source>Its sd</source>
        <translation>その標準偏差</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>メモ</translation>
    </message>
    <message>
        <source>The estimate of a staircase</source>
        <translation>階段法の推定値</translation>
    </message>
    <message>
        <source>The estimate of a Bayesian procedure</source>
        <translation>ベイズ法の推定値</translation>
    </message>
    <message>
        <source>On the scale of the levels: in log10 units on a logarithmic one</source>
        <translation>レベルの尺度上の値: 対数尺度ではlog10の単位</translation>
    </message>
    <message>
        <source>Hits</source>
        <translation>ヒット</translation>
    </message>
    <message>
        <source>False alarms</source>
        <translation>誤警報</translation>
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
        <translation>方法</translation>
    </message>
    <message>
        <source>Of how many trials with a stimulus; of several intervals right answers</source>
        <translation>刺激のある試行数に対する数。複数区間では正答数</translation>
    </message>
    <message>
        <source>Of how many trials without</source>
        <translation>刺激のない試行数に対する数</translation>
    </message>
    <message>
        <source>Sensitivity; rates are (count + 1/2) / (trials + 1)</source>
        <translation>感度。率は (数 + 1/2) / (試行数 + 1)</translation>
    </message>
    <message>
        <source>Criterion: above 0 rather no; of two intervals below 0 rather the first</source>
        <translation>判断基準: 0より大きいと「なし」寄り。2区間では0より小さいと1つ目寄り</translation>
    </message>
    <message>
        <source>Without rules</source>
        <translation>規則なし</translation>
    </message>
    <message>
        <source>Threshold of all trials, including those that the rules leave out</source>
        <translation>規則で除かれるものも含む全試行の閾値</translation>
    </message>
    <message>
        <source>Speed, Hz</source>
        <translation>速度, Hz</translation>
    </message>
    <message>
        <source>Of the motors at this level, by their measured curves; mean over the tactors</source>
        <translation>このレベルでのモーターの値。測定した曲線から求め、タクタで平均します</translation>
    </message>
    <message>
        <source>Force, %</source>
        <translation>力, %</translation>
    </message>
    <message>
        <source>Square of that speed over the square of the speed at full drive</source>
        <translation>この速度の2乗を、最大駆動量での速度の2乗で割った値</translation>
    </message>
    <message>
        <source>Weber of speed</source>
        <translation>速度のウェーバー比</translation>
    </message>
    <message>
        <source>By how much the speed rises from the reference to reference + JND</source>
        <translation>基準から基準+JNDまでの速度の増加率</translation>
    </message>
    <message>
        <source>Weber of force</source>
        <translation>力のウェーバー比</translation>
    </message>
    <message>
        <source>By how much the force rises from the reference to reference + JND</source>
        <translation>基準から基準+JNDまでの力の増加率</translation>
    </message>
    <message>
        <source>A level is a share of the range from a motor&apos;s start to its full drive. Connect the bracelet, and the speed of its motors in Hz and their force are shown beside the levels.</source>
        <translation>レベルは、モーターの始動から最大駆動量までの範囲に対する割合です。ブレスレットを接続すると、モーターの速度（Hz）と力がレベルの横に表示されます。</translation>
    </message>
    <message>
        <source>A level is a share of the range from a motor&apos;s start to its full drive. Measure the motors of this bracelet on the page Calibrate, and their speed in Hz and their force are shown beside the levels.</source>
        <translation>レベルは、モーターの始動から最大駆動量までの範囲に対する割合です。キャリブレーションページでこのブレスレットのモーターを測定すると、速度（Hz）と力がレベルの横に表示されます。</translation>
    </message>
</context>
<context>
    <name>LevelSourceText</name>
    <message>
        <source>these are data of different modes: %1 and %2</source>
        <translation>異なるモードのデータが混在しています: %1と%2</translation>
    </message>
    <message>
        <source>one mode, or the choice of one</source>
        <translation>1つのモード、または対象とするモードの指定</translation>
    </message>
    <message>
        <source>%1 cannot be &quot;%2&quot;</source>
        <translation>%1 を「%2」にはできません</translation>
    </message>
    <message>
        <source>nothing says which answers are correct</source>
        <translation>どの回答が正答かを示すものがありません</translation>
    </message>
    <message>
        <source>a column correct, or stimulus and response</source>
        <translation>correct列、またはstimulus列とresponse列</translation>
    </message>
    <message>
        <source>practice or test</source>
        <translation>practiceまたはtest</translation>
    </message>
    <message>
        <source>run, pilot or simulated</source>
        <translation>run、pilot、またはsimulated</translation>
    </message>
    <message>
        <source>correct, incorrect, timeout, aborted or device_error</source>
        <translation>correct、incorrect、timeout、aborted、またはdevice_error</translation>
    </message>
    <message>
        <source>a number from %1 to %2, or NA</source>
        <translation>%1から%2までの数、またはNA</translation>
    </message>
    <message>
        <source>yes_no, interval, same_different or compare, one for a task</source>
        <translation>yes_no、interval、same_different、またはcompare。課題ごとに1つ</translation>
    </message>
    <message>
        <source>0 or 1</source>
        <translation>0または1</translation>
    </message>
    <message>
        <source>a value</source>
        <translation>値</translation>
    </message>
    <message>
        <source>interrupted</source>
        <translation>中断されました</translation>
    </message>
</context>
<context>
    <name>LimitText</name>
    <message>
        <source>joint speed</source>
        <translation>関節の速度</translation>
    </message>
    <message>
        <source>tip speed</source>
        <translation>先端の速度</translation>
    </message>
    <message>
        <source>joint limit</source>
        <translation>関節の可動端</translation>
    </message>
    <message>
        <source>workspace box</source>
        <translation>先端の可動範囲 (箱)</translation>
    </message>
    <message>
        <source>effort</source>
        <translation>トルク・力</translation>
    </message>
    <message>
        <source>force</source>
        <translation>力</translation>
    </message>
    <message>
        <source>the arm lags behind</source>
        <translation>アームの遅れ</translation>
    </message>
</context>
<context>
    <name>LinkText</name>
    <message>
        <source>a serial port cannot run at %1 baud</source>
        <translation>シリアルポートを%1ボーで動作させられません</translation>
    </message>
    <message>
        <source>one of %1</source>
        <translation>次のいずれか: %1</translation>
    </message>
    <message>
        <source>cannot open %1: %2</source>
        <translation>%1 を開けません: %2</translation>
    </message>
    <message>
        <source>%1 is not a serial port</source>
        <translation>%1 はシリアルポートではありません</translation>
    </message>
    <message>
        <source>cannot find %1: %2</source>
        <translation>%1 が見つかりません: %2</translation>
    </message>
    <message>
        <source>connecting was cancelled</source>
        <translation>接続がキャンセルされました</translation>
    </message>
    <message>
        <source>cannot connect to %1: %2</source>
        <translation>%1 に接続できません: %2</translation>
    </message>
    <message>
        <source>The link failed: %1.</source>
        <translation>リンクに障害が発生しました: %1。</translation>
    </message>
    <message>
        <source>The sensor closed the connection.</source>
        <translation>センサーが接続を閉じました。</translation>
    </message>
    <message>
        <source>The device was unplugged.</source>
        <translation>デバイスが取り外されました。</translation>
    </message>
    <message>
        <source>The file has ended.</source>
        <translation>ファイルの終わりに達しました。</translation>
    </message>
    <message>
        <source>The server closed the connection (code %1): %2</source>
        <translation>サーバーが接続を閉じました (コード %1): %2</translation>
    </message>
    <message>
        <source>no answer</source>
        <translation>応答なし</translation>
    </message>
    <message>
        <source>%1 is a folder, not a file</source>
        <translation>%1はファイルではなくフォルダーです</translation>
    </message>
    <message>
        <source>The other program closed the pipe.</source>
        <translation>相手のプログラムがパイプを閉じました。</translation>
    </message>
    <message>
        <source>The server has sent nothing for %1 s.</source>
        <translation>サーバーは%1秒間何も送っていません。</translation>
    </message>
</context>
<context>
    <name>LiveView</name>
    <message>
        <source>&quot;%1&quot; is no address</source>
        <translation>「%1」はアドレスではありません</translation>
    </message>
    <message>
        <source>an address such as 127.0.0.1</source>
        <translation>アドレス。例: 127.0.0.1</translation>
    </message>
    <message>
        <source>the live view cannot listen on %1:%2: %3</source>
        <translation>ライブビューが %1:%2 で待ち受けできません: %3</translation>
    </message>
    <message>
        <source>another port</source>
        <translation>別のポート</translation>
    </message>
</context>
<context>
    <name>LoadCalibration</name>
    <message>
        <source>%1 presses under load are too few for %2 signals</source>
        <translation>%2個の信号に対して、荷重のある押し込み%1回は少なすぎます</translation>
    </message>
    <message>
        <source>at least %1 presses</source>
        <translation>%1回以上の押し込み</translation>
    </message>
    <message>
        <source>%1 is the same in all presses</source>
        <translation>%1はすべての押し込みで同じです</translation>
    </message>
    <message>
        <source>loads of different sizes</source>
        <translation>大きさの異なる荷重</translation>
    </message>
    <message>
        <source>presses that change each signal</source>
        <translation>各信号が変化する押し込み</translation>
    </message>
    <message>
        <source>the presses do not tell the signals apart</source>
        <translation>押し込みからは信号を区別できません</translation>
    </message>
    <message>
        <source>presses in which each signal changes without the others</source>
        <translation>各信号が他と独立に変化する押し込み</translation>
    </message>
</context>
<context>
    <name>LoadCalibrationFile</name>
    <message>
        <source>&quot;%1&quot; is no load</source>
        <translation>「%1」は荷重ではありません</translation>
    </message>
    <message>
        <source>the signal has no name</source>
        <translation>信号に名前がありません</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no number</source>
        <translation>「%1」は数ではありません</translation>
    </message>
    <message>
        <source>least is above greatest</source>
        <translation>leastがgreatestより大きくなっています</translation>
    </message>
    <message>
        <source>there is no column with a load</source>
        <translation>荷重の列がありません</translation>
    </message>
    <message>
        <source>one of %1</source>
        <translation>%1のいずれか</translation>
    </message>
    <message>
        <source>this load and signal are listed twice</source>
        <translation>この荷重と信号の組が2回あります</translation>
    </message>
    <message>
        <source>rest and range of this signal differ from another row</source>
        <translation>この信号の静止値と範囲が他の行と異なります</translation>
    </message>
    <message>
        <source>rows are missing</source>
        <translation>行が足りません</translation>
    </message>
    <message>
        <source>one for each load and signal</source>
        <translation>荷重と信号の組ごとに1行</translation>
    </message>
    <message>
        <source>the scatter of this load differs from another row</source>
        <translation>この荷重のばらつきがほかの行と異なります</translation>
    </message>
    <message>
        <source>an error or a scatter is below 0</source>
        <translation>誤差またはばらつきが0未満です</translation>
    </message>
    <message>
        <source>the source has no signal &quot;%1&quot;</source>
        <translation>ソースに信号「%1」はありません</translation>
    </message>
</context>
<context>
    <name>LoadsCommand</name>
    <message>
        <source>Find the matrix from presses with a known load</source>
        <translation>既知の荷重の押し込みから行列を求めます</translation>
    </message>
    <message>
        <source>CSV, a row a press: the signals, and the loads in one or more of force_n, shear_x_n, shear_y_n, moment_nm</source>
        <translation>1行に1回の押し込みのCSV。信号と、force_n、shear_x_n、shear_y_n、moment_nmのうち1つ以上の荷重</translation>
    </message>
    <message>
        <source>Columns of the signals, between commas</source>
        <translation>信号の列。コンマで区切ります</translation>
    </message>
    <message>
        <source>Loads of each row of a table</source>
        <translation>表の各行の荷重</translation>
    </message>
    <message>
        <source>What &quot;teleta loads fit&quot; has written</source>
        <translation>「teleta loads fit」が書いたファイル</translation>
    </message>
    <message>
        <source>CSV with the same signals</source>
        <translation>同じ信号のCSV</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no signal</source>
        <translation>「%1」は信号ではありません</translation>
    </message>
    <message>
        <source>%1 is named twice</source>
        <translation>%1が2回あります</translation>
    </message>
    <message>
        <source>Presses</source>
        <translation>押し込み</translation>
    </message>
    <message>
        <source>Signals</source>
        <translation>信号</translation>
    </message>
    <message>
        <source>Condition</source>
        <translation>条件数</translation>
    </message>
    <message>
        <source>off by %1 (standard deviation)</source>
        <translation>ずれ%1(標準偏差)</translation>
    </message>
    <message>
        <source>this is no number</source>
        <translation>数ではありません</translation>
    </message>
    <message>
        <source>a number, or NA</source>
        <translation>数、またはNA</translation>
    </message>
    <message>
        <source>Newtons from the signals of a sensor, by presses with a known load</source>
        <translation>既知の荷重の押し込みによって、センサーの信号をニュートンに変えます</translation>
    </message>
</context>
<context>
    <name>LocateCommand</name>
    <message>
        <source>Camera file that teleta calibrate has written</source>
        <translation>teleta calibrateが書き込んだカメラファイル</translation>
    </message>
    <message>
        <source>CSV with the columns u_px,v_px</source>
        <translation>u_px,v_px の列を持つCSV</translation>
    </message>
    <message>
        <source>Points on the tactile cylinder that belong to pixels of its camera</source>
        <translation>カメラの画素に写る触覚円筒上の点</translation>
    </message>
</context>
<context>
    <name>MarkerGelFile</name>
    <message>
        <source>the plane is described twice</source>
        <translation>平面が二重に記述されています</translation>
    </message>
    <message>
        <source>one of mm_per_px, homography and pitch_mm</source>
        <translation>mm_per_px、homography、pitch_mm のいずれか 1 つ</translation>
    </message>
    <message>
        <source>the matrix has no inverse</source>
        <translation>行列に逆行列がありません</translation>
    </message>
    <message>
        <source>a matrix that maps the picture onto a plane</source>
        <translation>画像を平面に写す行列</translation>
    </message>
    <message>
        <source>a part of a pixel cannot be cut off</source>
        <translation>画素の一部は切り取れません</translation>
    </message>
    <message>
        <source>whole numbers</source>
        <translation>整数</translation>
    </message>
    <message>
        <source>the picture would be too small</source>
        <translation>画像が小さすぎます</translation>
    </message>
    <message>
        <source>at least 16 x 16 pixels</source>
        <translation>16 x 16 画素以上</translation>
    </message>
    <message>
        <source>such small markers cannot be told from noise</source>
        <translation>このように小さいマーカーはノイズと区別できません</translation>
    </message>
    <message>
        <source>at least 2 px, or 0</source>
        <translation>2 px 以上、または 0</translation>
    </message>
    <message>
        <source>[plane] gives no scale</source>
        <translation>[plane] に縮尺がありません</translation>
    </message>
</context>
<context>
    <name>MarkersText</name>
    <message>
        <source>the camera has stopped sending frames</source>
        <translation>カメラがフレームを送らなくなりました</translation>
    </message>
    <message>
        <source>Video, pattern of numbered images (frame_%04d.png) or number of a camera; nothing touches the gel in the first frames. Default: the source that the sensor file names</source>
        <translation>動画、番号付き画像のパターン（frame_%04d.png）、またはカメラの番号。最初のフレームでは何もゲルに触れないこと。既定：センサーファイルに書かれた source</translation>
    </message>
    <message>
        <source>Sensor file of kind &quot;marker_gel&quot;</source>
        <translation>kind が「marker_gel」のセンサーのファイル</translation>
    </message>
    <message>
        <source>Print a summary instead of the table</source>
        <translation>表の代わりに要約を出力</translation>
    </message>
    <message>
        <source>a summary is printed; --out writes the table</source>
        <translation>要約は表示されるだけです。--out は表を書き出します</translation>
    </message>
    <message>
        <source>neither a video is given nor does the sensor file name a source</source>
        <translation>動画が指定されておらず、センサーファイルにも source がありません</translation>
    </message>
    <message>
        <source>the video has no frame that can be decoded</source>
        <translation>動画に復号できるフレームがありません</translation>
    </message>
    <message>
        <source>the video has only one frame, so nothing moves in it</source>
        <translation>動画にフレームが 1 つしかないため、動きがありません</translation>
    </message>
    <message>
        <source>at least two frames</source>
        <translation>2 フレーム以上</translation>
    </message>
    <message>
        <source>The picture has no contrast at %1 s: is the camera covered?</source>
        <translation>%1 s で画像にコントラストがありません。カメラが覆われていませんか</translation>
    </message>
    <message>
        <source>The light jumps at %1 s</source>
        <translation>%1 s で明るさが急に変わります</translation>
    </message>
    <message>
        <source>At %1 s more than 30 % of the markers have been lost for 1 s: is the gel torn?</source>
        <translation>%1 s で、マーカーの 30 % 以上が 1 s の間見失われています。ゲルが破れていませんか</translation>
    </message>
    <message>
        <source>Frames that cannot be decoded: %1</source>
        <translation>復号できないフレーム: %1</translation>
    </message>
    <message>
        <source>Frames missing according to their time stamps: %1</source>
        <translation>タイムスタンプによると欠けているフレーム: %1</translation>
    </message>
    <message>
        <source>frames</source>
        <translation>フレーム</translation>
    </message>
    <message>
        <source>markers</source>
        <translation>マーカー</translation>
    </message>
    <message>
        <source>found</source>
        <translation>検出</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>diameter</source>
        <translation>直径</translation>
    </message>
    <message>
        <source>%1 px</source>
        <translation>%1 px</translation>
    </message>
    <message>
        <source>distance of neighbours</source>
        <translation>隣との間隔</translation>
    </message>
    <message>
        <source>frames for the places at rest</source>
        <translation>静止位置に使ったフレーム</translation>
    </message>
    <message>
        <source>noise of a place</source>
        <translation>位置のノイズ</translation>
    </message>
    <message>
        <source>largest displacement</source>
        <translation>最大の変位</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>contacts</source>
        <translation>接触</translation>
    </message>
    <message>
        <source>contact %1</source>
        <translation>接触 %1</translation>
    </message>
    <message>
        <source>%1 s to %2 s, centre (%3, %4) mm</source>
        <translation>%1 s～%2 s、中心 (%3, %4) mm</translation>
    </message>
    <message>
        <source>, slip index up to %1</source>
        <translation>、滑り指標は最大%1</translation>
    </message>
    <message>
        <source>, slip at %1 s</source>
        <translation>、%1 sで滑り</translation>
    </message>
    <message>
        <source>Follow the markers of a flat gel in a video</source>
        <translation>動画で平らなゲルのマーカーを追う</translation>
    </message>
</context>
<context>
    <name>MatCheckText</name>
    <message>
        <source>the MAT file is damaged at byte %1: %2</source>
        <translation>MAT ファイルがバイト %1 で壊れています：%2</translation>
    </message>
    <message>
        <source>a whole MAT file</source>
        <translation>完全な MAT ファイル</translation>
    </message>
    <message>
        <source>it ends within its header</source>
        <translation>ヘッダーの途中で終わっています</translation>
    </message>
    <message>
        <source>it ends within the header of a variable</source>
        <translation>変数のヘッダーの途中で終わっています</translation>
    </message>
    <message>
        <source>a variable has %1 bytes, there are %2</source>
        <translation>変数は %1 バイトですが、%2 バイトしかありません</translation>
    </message>
    <message>
        <source>a compressed variable cannot be decompressed</source>
        <translation>圧縮された変数を展開できません</translation>
    </message>
    <message>
        <source>this is not the header of a variable</source>
        <translation>これは変数のヘッダーではありません</translation>
    </message>
</context>
<context>
    <name>MatFileText</name>
    <message>
        <source>the file has too many variables</source>
        <translation>ファイルの変数が多すぎます</translation>
    </message>
    <message>
        <source>at most %1</source>
        <translation>最大 %1</translation>
    </message>
    <message>
        <source>the MAT file is damaged</source>
        <translation>MAT ファイルが壊れています</translation>
    </message>
    <message>
        <source>a whole MAT file of version 4, 5, 6, 7 or 7.3</source>
        <translation>バージョン 4、5、6、7 または 7.3 の完全な MAT ファイル</translation>
    </message>
    <message>
        <source>its values are complex</source>
        <translation>値が複素数です</translation>
    </message>
    <message>
        <source>it is sparse</source>
        <translation>疎行列です</translation>
    </message>
    <message>
        <source>it contains text</source>
        <translation>文字列が入っています</translation>
    </message>
    <message>
        <source>it contains other variables</source>
        <translation>ほかの変数が入っています</translation>
    </message>
    <message>
        <source>its values are not real numbers</source>
        <translation>値が実数ではありません</translation>
    </message>
</context>
<context>
    <name>McapExport</name>
    <message>
        <source>there is no stream &quot;%1&quot;</source>
        <translation>ストリーム「%1」がありません</translation>
    </message>
    <message>
        <source>one of %1</source>
        <translation>次のいずれか: %1</translation>
    </message>
    <message>
        <source>interrupted; nothing was written</source>
        <translation>中断されました。何も書き込まれていません</translation>
    </message>
    <message>
        <source>a file of this name already exists</source>
        <translation>同じ名前のファイルがすでにあります</translation>
    </message>
    <message>
        <source>another name</source>
        <translation>別の名前</translation>
    </message>
</context>
<context>
    <name>McapFile</name>
    <message>
        <source>there is no such file</source>
        <translation>そのようなファイルはありません</translation>
    </message>
    <message>
        <source>cannot be opened: %1</source>
        <translation>開けません: %1</translation>
    </message>
    <message>
        <source>this is not an MCAP file</source>
        <translation>MCAPファイルではありません</translation>
    </message>
    <message>
        <source>an MCAP file, version 0</source>
        <translation>MCAPファイル、バージョン0</translation>
    </message>
    <message>
        <source>the attachment &quot;%1&quot; is damaged</source>
        <translation>添付ファイル「%1」が破損しています</translation>
    </message>
</context>
<context>
    <name>McapImport</name>
    <message>
        <source>%1 is of the type %2 and cannot be read as %3</source>
        <translation>%1 は型 %2 のため、%3 として読み込めません</translation>
    </message>
    <message>
        <source>there is no topic %1</source>
        <translation>トピック %1 がありません</translation>
    </message>
    <message>
        <source>one of %1</source>
        <translation>次のいずれか: %1</translation>
    </message>
    <message>
        <source>no topic of this file can be read: %1</source>
        <translation>このファイルには読み込めるトピックがありません: %1</translation>
    </message>
    <message>
        <source>it has none</source>
        <translation>トピックがありません</translation>
    </message>
    <message>
        <source>messages of ROS 2 in CDR</source>
        <translation>CDR形式のROS 2メッセージ</translation>
    </message>
    <message>
        <source>interrupted</source>
        <translation>中断されました</translation>
    </message>
</context>
<context>
    <name>MeshFile</name>
    <message>
        <source>mesh_path = &quot;FOLDER&quot;</source>
        <translation>mesh_path = &quot;フォルダー&quot;</translation>
    </message>
    <message>
        <source>the mesh %1 is not in the folder of the arm&apos;s meshes</source>
        <translation>メッシュ%1はアームのメッシュのフォルダーの中にありません</translation>
    </message>
    <message>
        <source>the mesh is missing</source>
        <translation>メッシュがありません</translation>
    </message>
    <message>
        <source>meshes are read from STL, DAE and OBJ files</source>
        <translation>メッシュはSTL、DAE、OBJのファイルから読み込みます</translation>
    </message>
    <message>
        <source>the mesh is larger than %1 MB</source>
        <translation>メッシュが%1 MBを超えています</translation>
    </message>
    <message>
        <source>the mesh cannot be read: %1</source>
        <translation>メッシュを読み込めません: %1</translation>
    </message>
    <message>
        <source>the arm&apos;s file does not set mesh_path</source>
        <translation>アームのファイルに mesh_path がありません</translation>
    </message>
</context>
<context>
    <name>Modbus</name>
    <message>
        <source>%1 cannot be opened: %2</source>
        <translation>%1 を開けません: %2</translation>
    </message>
    <message>
        <source>The device has no motors.</source>
        <translation>デバイスにモーターがありません。</translation>
    </message>
    <message>
        <source>a table [tactors] in its file</source>
        <translation>ファイル内の表 [tactors]</translation>
    </message>
    <message>
        <source>illegal function</source>
        <translation>不正なファンクション</translation>
    </message>
    <message>
        <source>illegal data address</source>
        <translation>不正なデータアドレス</translation>
    </message>
    <message>
        <source>illegal data value</source>
        <translation>不正なデータ値</translation>
    </message>
    <message>
        <source>device failure</source>
        <translation>デバイス障害</translation>
    </message>
    <message>
        <source>acknowledge</source>
        <translation>アクノリッジ</translation>
    </message>
    <message>
        <source>device busy</source>
        <translation>デバイスビジー</translation>
    </message>
    <message>
        <source>negative acknowledge</source>
        <translation>否定アクノリッジ</translation>
    </message>
    <message>
        <source>memory parity error</source>
        <translation>メモリパリティエラー</translation>
    </message>
    <message>
        <source>gateway path unavailable</source>
        <translation>ゲートウェイ経路利用不可</translation>
    </message>
    <message>
        <source>the device behind the gateway does not answer</source>
        <translation>ゲートウェイの先のデバイスが応答しません</translation>
    </message>
    <message>
        <source>not in the standard</source>
        <translation>規格にないコード</translation>
    </message>
    <message>
        <source>The server answered with exception %1: %2.</source>
        <translation>サーバーが例外%1で応答しました: %2。</translation>
    </message>
    <message>
        <source>The server did not answer in time.</source>
        <translation>サーバーが時間内に応答しませんでした。</translation>
    </message>
    <message>
        <source>The server&apos;s answer does not fit the request.</source>
        <translation>サーバーの応答が要求と一致しません。</translation>
    </message>
    <message>
        <source>The connection was lost.</source>
        <translation>接続が切れました。</translation>
    </message>
    <message>
        <source>The device reports no joints.</source>
        <translation>デバイスが関節の情報を返しません。</translation>
    </message>
    <message>
        <source>tables [[joint]] in its file</source>
        <translation>ファイル内の表 [[joint]]</translation>
    </message>
    <message>
        <source>this arm is read-only: it reports its joints but cannot be moved</source>
        <translation>このアームは読み取り専用です。関節を伝えますが、動かすことはできません</translation>
    </message>
</context>
<context>
    <name>MotorFile</name>
    <message>
        <source>the limits belong to the bracelet &quot;%1&quot;</source>
        <translation>この上限はブレスレット「%1」のものです</translation>
    </message>
</context>
<context>
    <name>MotorFit</name>
    <message>
        <source>a motor that starts at the same drive each time; look for a loose contact</source>
        <translation>毎回同じ駆動量で始動するモーター。接触不良がないか確認してください</translation>
    </message>
    <message>
        <source>There is no step: the drive is the same all the time.</source>
        <translation>段差がありません: 駆動量がずっと同じです。</translation>
    </message>
    <message>
        <source>a staircase of drives from 0 to the full one</source>
        <translation>0から最大までの階段状の駆動量</translation>
    </message>
    <message>
        <source>The full drive was never commanded: the highest is %1.</source>
        <translation>最大駆動量が指令されていません: 最高値は%1です。</translation>
    </message>
    <message>
        <source>The recording does not begin at rest.</source>
        <translation>記録が静止状態から始まっていません。</translation>
    </message>
    <message>
        <source>The recording is too short: no drive was held for %1 s.</source>
        <translation>記録が短すぎます: %1 s保持された駆動量がありません。</translation>
    </message>
    <message>
        <source>a drive that is held until the motor has followed, 0.3 s</source>
        <translation>モーターが追従するまで保持された駆動量 (0.3 s)</translation>
    </message>
    <message>
        <source>The recording is too short: %1 samples.</source>
        <translation>記録が短すぎます: %1サンプル。</translation>
    </message>
    <message>
        <source>at least %1</source>
        <translation>%1以上</translation>
    </message>
    <message>
        <source>The motor does not turn, not even at the full drive.</source>
        <translation>最大駆動量でもモーターが回りません。</translation>
    </message>
    <message>
        <source>a connected motor, and its sensor</source>
        <translation>接続されたモーターとそのセンサー</translation>
    </message>
    <message>
        <source>The speed is not 0 although nothing is commanded: %1 Hz.</source>
        <translation>指令がないのに速度が0ではありません: %1 Hz。</translation>
    </message>
    <message>
        <source>The speed is clipped: it stays at the end of the sensor&apos;s range.</source>
        <translation>速度がクリップしています: センサー範囲の端に張り付いています。</translation>
    </message>
    <message>
        <source>a sensor with a larger range</source>
        <translation>より広い範囲のセンサー</translation>
    </message>
    <message>
        <source>a step down at the end</source>
        <translation>最後に下がる段差</translation>
    </message>
    <message>
        <source>a supply and a sensor that reach the full drive</source>
        <translation>最大駆動量に達する電源とセンサー</translation>
    </message>
    <message>
        <source>The motor started at %1 of the full drive but stood still at %2.</source>
        <translation>モーターは最大駆動量の%1で始動しましたが、%2で停止していました。</translation>
    </message>
    <message>
        <source>a commanded drive of 0 at the beginning</source>
        <translation>開始時の指令駆動量0</translation>
    </message>
    <message>
        <source>The rise time cannot be determined: %1 s with a standard error of %2 s.</source>
        <translation>立ち上がり時間を決定できません: %1 s、標準誤差 %2 s。</translation>
    </message>
    <message>
        <source>more samples per second, or less noise</source>
        <translation>1秒あたりより多くのサンプル、またはより少ないノイズ</translation>
    </message>
    <message>
        <source>The fall time cannot be determined: %1 s with a standard error of %2 s.</source>
        <translation>立ち下がり時間を決定できません: %1 s、標準誤差 %2 s。</translation>
    </message>
    <message>
        <source>The motor does not behave like a motor with a lag: the model explains %1 of the speed.</source>
        <translation>モーターの駆動量への追従が遅れ系のモデルに合いません: モデルで説明できる速度は%1です。</translation>
    </message>
    <message>
        <source>a recording of one motor with the drive at the same times</source>
        <translation>同じ時刻の駆動量を含む、モーター1個の記録</translation>
    </message>
    <message>
        <source>a sensor without an offset, and a motor at rest at the beginning</source>
        <translation>オフセットのないセンサーと、開始時に静止しているモーター</translation>
    </message>
    <message>
        <source>The motor turned at one level of the drive only: neither its start nor its curve can be determined.</source>
        <translation>モーターが回ったのは1つの駆動量だけです: 始動点も曲線も決定できません。</translation>
    </message>
    <message>
        <source>The drive never falls while the motor turns: the fall time cannot be determined.</source>
        <translation>モーターの回転中に駆動量が下がりません: 立ち下がり時間を決定できません。</translation>
    </message>
    <message>
        <source>The samples do not determine the motor&apos;s lag.</source>
        <translation>サンプルからモーターの遅れを決定できません。</translation>
    </message>
    <message>
        <source>more samples per second during the steps</source>
        <translation>段差の間、1秒あたりより多くのサンプル</translation>
    </message>
    <message>
        <source>The speed is saturated: it does not rise above %1 of the drive.</source>
        <translation>速度が飽和しています: 駆動量%1以上では上昇しません。</translation>
    </message>
    <message>
        <source>The measurement does not describe a motor: the speed does not rise with the drive.</source>
        <translation>測定値からモーターを構成できません: 速度が駆動量とともに上昇しません。</translation>
    </message>
</context>
<context>
    <name>MotorRecording</name>
    <message>
        <source>the time does not rise</source>
        <translation>時刻が増加していません</translation>
    </message>
    <message>
        <source>a time above %1 s</source>
        <translation>%1 sより後の時刻</translation>
    </message>
    <message>
        <source>the commanded drive is %1</source>
        <translation>指令駆動量が%1です</translation>
    </message>
    <message>
        <source>a share of the full drive, 0 to 1</source>
        <translation>最大駆動量に対する割合 (0～1)</translation>
    </message>
    <message>
        <source>there is neither a column &quot;speed_hz&quot; nor &quot;signal&quot;</source>
        <translation>列「speed_hz」も「signal」もありません</translation>
    </message>
    <message>
        <source>sample %1 is not a finite number</source>
        <translation>サンプル%1が有限の数値ではありません</translation>
    </message>
    <message>
        <source>The recording does not begin at rest.</source>
        <translation>記録が静止状態から始まっていません。</translation>
    </message>
    <message>
        <source>The signal is clipped: it stays at the end of its range.</source>
        <translation>信号がクリップしています: 範囲の端に張り付いています。</translation>
    </message>
    <message>
        <source>a recording with less gain</source>
        <translation>ゲインを下げた記録</translation>
    </message>
    <message>
        <source>The signal shows no vibration above its noise.</source>
        <translation>信号にノイズを超える振動が見られません。</translation>
    </message>
    <message>
        <source>a sensor on the motor, with a signal above four times its noise</source>
        <translation>モーター上のセンサーと、ノイズの4倍を超える信号</translation>
    </message>
    <message>
        <source>the numbers of times, drives and speeds differ</source>
        <translation>時刻、駆動量、速度の数が一致しません</translation>
    </message>
    <message>
        <source>at least %1 s with a commanded drive of 0</source>
        <translation>指令駆動量0が%1 s以上</translation>
    </message>
    <message>
        <source>%1 samples per second are too few for %2 turns per second.</source>
        <translation>毎秒%1サンプルは、毎秒%2回転に対して少なすぎます。</translation>
    </message>
    <message>
        <source>at least %1 samples per turn</source>
        <translation>1回転あたり%1サンプル以上</translation>
    </message>
</context>
<context>
    <name>Mouse3d</name>
    <message>
        <source>The 3D mouse at %1 cannot be opened.</source>
        <translation>%1 の3Dマウスを開けません。</translation>
    </message>
    <message>
        <source>No 3D mouse is plugged in.</source>
        <translation>3Dマウスが接続されていません。</translation>
    </message>
    <message>
        <source>The 3D mouse was unplugged.</source>
        <translation>3Dマウスが取り外されました。</translation>
    </message>
    <message>
        <source>No permission to open the 3D mouse at %1.</source>
        <translation>%1 の3Dマウスを開く権限がありません。</translation>
    </message>
    <message>
        <source>read and write access, which the udev rule grants</source>
        <translation>udevルールによる読み書きの権限</translation>
    </message>
</context>
<context>
    <name>NewRecordingText</name>
    <message>
        <source>a file of this name already exists</source>
        <translation>この名前のファイルはすでにあります</translation>
    </message>
    <message>
        <source>another name</source>
        <translation>別の名前</translation>
    </message>
    <message>
        <source>the file cannot be given its name</source>
        <translation>ファイルに名前を付けられません</translation>
    </message>
</context>
<context>
    <name>NodeClaim</name>
    <message>
        <source>another program uses %1</source>
        <comment>a device</comment>
        <translation>ほかのプログラムが%1を使用中です</translation>
    </message>
    <message>
        <source>it to be closed there first</source>
        <translation>先にそのプログラムで閉じること</translation>
    </message>
</context>
<context>
    <name>NpyText</name>
    <message>
        <source>the head of the array is damaged at byte %1</source>
        <translation>配列のヘッダーがバイト%1で破損しています</translation>
    </message>
    <message>
        <source>the file ends within the head of the array</source>
        <translation>ファイルが配列のヘッダーの途中で終わっています</translation>
    </message>
    <message>
        <source>a whole file</source>
        <translation>完全なファイル</translation>
    </message>
    <message>
        <source>descr, fortran_order and shape</source>
        <translation>descr、fortran_order、shape</translation>
    </message>
    <message>
        <source>the end of the head</source>
        <translation>ヘッダーの終わり</translation>
    </message>
    <message>
        <source>a text in quotes</source>
        <translation>引用符で囲んだテキスト</translation>
    </message>
    <message>
        <source>a closing quote</source>
        <translation>閉じ引用符</translation>
    </message>
    <message>
        <source>its values are structured, with fields</source>
        <translation>値がフィールドを持つ構造体です</translation>
    </message>
    <message>
        <source>its values are of type &quot;%1&quot;</source>
        <translation>値の型が「%1」です</translation>
    </message>
    <message>
        <source>its values are objects of Python, which were pickled</source>
        <translation>値がpickle化されたPythonオブジェクトです</translation>
    </message>
    <message>
        <source>its values are complex numbers</source>
        <translation>値が複素数です</translation>
    </message>
    <message>
        <source>its values are texts</source>
        <translation>値が文字列です</translation>
    </message>
    <message>
        <source>whole numbers of 0 or more</source>
        <translation>0以上の整数</translation>
    </message>
    <message>
        <source>npy of version %1.%2</source>
        <translation>npyのバージョンが%1.%2です</translation>
    </message>
    <message>
        <source>version 1.0, 2.0 or 3.0</source>
        <translation>バージョン1.0、2.0、または3.0</translation>
    </message>
    <message>
        <source>a head of at most 1 MiB</source>
        <translation>1 MiB以下のヘッダー</translation>
    </message>
    <message>
        <source>the file ends after %1 of %2 values</source>
        <translation>ファイルが%2個中%1個の値で終わっています</translation>
    </message>
    <message>
        <source>the file goes on behind the %1 values of its array</source>
        <translation>配列の%1個の値の後にもファイルが続いています</translation>
    </message>
    <message>
        <source>one array</source>
        <translation>1つの配列</translation>
    </message>
</context>
<context>
    <name>NpzExportText</name>
    <message>
        <source>the recording has no tactile array</source>
        <translation>記録に触覚アレイがありません</translation>
    </message>
    <message>
        <source>frames of an array</source>
        <translation>アレイのフレーム</translation>
    </message>
    <message>
        <source>the recording has no array &quot;%1&quot;</source>
        <translation>記録にアレイ「%1」がありません</translation>
    </message>
    <message>
        <source>the recording has several arrays</source>
        <translation>記録に複数のアレイがあります</translation>
    </message>
    <message>
        <source>one of them (--stream NAME): %1</source>
        <translation>そのうちの1つ (--stream NAME): %1</translation>
    </message>
    <message>
        <source>a file of this name already exists</source>
        <translation>同じ名前のファイルがすでにあります</translation>
    </message>
    <message>
        <source>another name</source>
        <translation>別の名前</translation>
    </message>
    <message>
        <source>interrupted; nothing was written</source>
        <translation>中断されました。何も書き込まれていません</translation>
    </message>
    <message>
        <source>the recording is too long</source>
        <translation>記録が長すぎます</translation>
    </message>
    <message>
        <source>at most %1 values</source>
        <translation>%1個以下の値</translation>
    </message>
</context>
<context>
    <name>NpzWriterText</name>
    <message>
        <source>cannot write the file: %1</source>
        <translation>ファイルに書き込めません: %1</translation>
    </message>
</context>
<context>
    <name>NumpyFileText</name>
    <message>
        <source>the file ends after %1 of %2 values</source>
        <translation>ファイルが%2個中%1個の値で終わっています</translation>
    </message>
    <message>
        <source>a whole file</source>
        <translation>完全なファイル</translation>
    </message>
    <message>
        <source>the zip archive is damaged: %1</source>
        <translation>zipアーカイブが破損しています: %1</translation>
    </message>
    <message>
        <source>a whole npz file</source>
        <translation>完全なnpzファイル</translation>
    </message>
    <message>
        <source>the zip archive has too many files</source>
        <translation>zipアーカイブのファイルが多すぎます</translation>
    </message>
    <message>
        <source>at most %1</source>
        <translation>%1以下</translation>
    </message>
    <message>
        <source>the zip archive has no array of NumPy</source>
        <translation>zipアーカイブにNumPyの配列がありません</translation>
    </message>
    <message>
        <source>an npz file, with files that end in .npy</source>
        <translation>名前が.npyで終わるファイルを含むnpzファイル</translation>
    </message>
    <message>
        <source>a whole npz file that is not encrypted</source>
        <translation>暗号化されていない完全なnpzファイル</translation>
    </message>
</context>
<context>
    <name>OperatorDomainText</name>
    <message>
        <source>without certificates anybody on this network could move the arm</source>
        <translation>証明書がないと、このネットワークの誰でもアームを動かせてしまいます</translation>
    </message>
    <message>
        <source>security = &quot;certificates&quot;, or interface = &quot;lo&quot;</source>
        <translation>security = &quot;certificates&quot;、または interface = &quot;lo&quot;</translation>
    </message>
    <message>
        <source>no interface is named, so that each network reaches the site</source>
        <translation>インターフェイスの指定がないため、どのネットワークからもサイトに届きます</translation>
    </message>
    <message>
        <source>%1 is no tunnel, so that its whole network reaches the site</source>
        <translation>%1はトンネルではないため、そのネットワーク全体からサイトに届きます</translation>
    </message>
    <message>
        <source>interface: that of a VPN; or security_bind = &quot;any&quot;</source>
        <translation>interface: VPNのもの。またはsecurity_bind = &quot;any&quot;</translation>
    </message>
</context>
<context>
    <name>OscTrigger</name>
    <message>
        <source>the host for triggers was not found: %1</source>
        <translation>トリガーの送信先ホストが見つかりません: %1</translation>
    </message>
    <message>
        <source>a name or an address</source>
        <translation>名前またはアドレス</translation>
    </message>
    <message>
        <source>triggers cannot be sent: %1</source>
        <translation>トリガーを送信できません: %1</translation>
    </message>
</context>
<context>
    <name>OutputFileText</name>
    <message>
        <source>cannot write: %1</source>
        <translation>書き込めません: %1</translation>
    </message>
    <message>
        <source>standard output</source>
        <translation>標準出力</translation>
    </message>
    <message>
        <source>cannot make the folder</source>
        <translation>フォルダーを作成できません</translation>
    </message>
</context>
<context>
    <name>OutputText</name>
    <message>
        <source>Print one JSON document on standard output</source>
        <translation>標準出力にJSON文書を1つ出力する</translation>
    </message>
    <message>
        <source>Write the CSV to this file, which appears when it is complete</source>
        <translation>CSVをこのファイルに書き込む (完成した時点で現れます)</translation>
    </message>
</context>
<context>
    <name>OverlayMaker</name>
    <message>
        <source>%1: %2</source>
        <extracomment>A contact in the 3-D view: its number and its force
----------
A contact on a gel in the 3-D view: its number and how much of it slips</extracomment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Each block: the largest of %1 × %1 taxels</source>
        <translation>各ブロック: %1 × %1 タクセルの最大値</translation>
    </message>
    <message>
        <source>Cylinder enlarged to fit: radius %1, length %2</source>
        <translation>円筒を収まるよう拡大: 半径 %1、長さ %2</translation>
    </message>
    <message>
        <source>Cylinder: radius %1, length %2</source>
        <translation>円筒: 半径 %1、長さ %2</translation>
    </message>
    <message>
        <source>Grid: %1</source>
        <translation>格子: %1</translation>
    </message>
    <message>
        <source>%1: ± %2</source>
        <extracomment>A contact on the tube in the 3-D view: its number and the standard deviation of its centre</extracomment>
        <translation>%1: ± %2</translation>
    </message>
    <message>
        <source>BUMP</source>
        <translation>衝突</translation>
    </message>
    <message>
        <source>followed</source>
        <translation>追従中</translation>
    </message>
    <message>
        <source>Contact %1
Force %2, peak %3
x %4, y %5
Area %6</source>
        <translation>接触 %1
力 %2、ピーク %3
x %4, y %5
面積 %6</translation>
    </message>
    <message>
        <source>Tube: radius %1, length %2</source>
        <translation>チューブ: 半径 %1、長さ %2</translation>
    </message>
    <message>
        <source>Displacement of the skin × %1, fainter where uncertain</source>
        <translation>皮膚の変位 × %1、不確かな部分は薄く表示</translation>
    </message>
    <message>
        <source>Ellipses: 95 % regions of the centres</source>
        <translation>楕円は95 %で中心を含みます</translation>
    </message>
    <message>
        <source>By the joints: %1</source>
        <translation>関節による: %1</translation>
    </message>
    <message>
        <source>Moment: %1</source>
        <extracomment>A moment in the 3-D view</extracomment>
        <translation>モーメント: %1</translation>
    </message>
    <message>
        <source>%1: %2°, range %3 … %4°</source>
        <extracomment>A joint in the 3-D view: its name, its angle, the ends of its range</extracomment>
        <translation>%1: %2°、範囲 %3 … %4°</translation>
    </message>
    <message>
        <source>Force, longest arrow: %1</source>
        <translation>力、最も長い矢印: %1</translation>
    </message>
    <message>
        <source>Moment, longest arrow: %1</source>
        <translation>モーメント、最も長い矢印: %1</translation>
    </message>
    <message>
        <source>At the wrist: %1</source>
        <translation>手首: %1</translation>
    </message>
    <message>
        <source>Gel: %1 × %2</source>
        <translation>ゲル: %1 × %2</translation>
    </message>
    <message>
        <source>Displacement, shear and turn × %1</source>
        <translation>変位、せん断、回転 × %1</translation>
    </message>
    <message>
        <source>Spread of the skin, longest arrow: %1</source>
        <translation>皮膚の広がり、最長の矢印: %1</translation>
    </message>
    <message>
        <source>Shear %1, friction %2</source>
        <extracomment>Shear is the force along the surface; friction is it divided by the force into the surface</extracomment>
        <translation>せん断 %1、摩擦 %2</translation>
    </message>
</context>
<context>
    <name>PadArm</name>
    <message>
        <source>the arm has %1 joints, its description %2</source>
        <translation>アームの関節は %1 個、記述では %2 個です</translation>
    </message>
</context>
<context>
    <name>PairText</name>
    <message>
        <source>points at several heights and all around the cylinder</source>
        <translation>複数の高さで、円筒の全周にわたる点</translation>
    </message>
    <message>
        <source>a coordinate is not a number, or too large</source>
        <translation>座標が数値でないか、大きすぎます</translation>
    </message>
    <message>
        <source>finite pixels and metres</source>
        <translation>有限の画素座標とメートル値</translation>
    </message>
    <message>
        <source>there are too few pairs: %1</source>
        <translation>ペアが少なすぎます: %1</translation>
    </message>
    <message>
        <source>at least 6, better 50 or more</source>
        <translation>6以上、できれば50以上</translation>
    </message>
    <message>
        <source>at least 6 different points, each with its own pixel</source>
        <translation>それぞれ固有の画素を持つ、6個以上の異なる点</translation>
    </message>
    <message>
        <source>no camera agrees with enough of the pairs</source>
        <translation>十分な数のペアと一致するカメラがありません</translation>
    </message>
    <message>
        <source>the pairs leave the camera undetermined: points on the surface would be uncertain by more than %1 mm</source>
        <translation>ペアからカメラが定まりません: 表面上の点の不確かさが%1 mmを超えます</translation>
    </message>
    <message>
        <source>more pairs, spread over the whole surface</source>
        <translation>表面全体に分布した、より多くのペア</translation>
    </message>
    <message>
        <source>more pairs near the lens, where the distortion is strongest</source>
        <translation>歪みが最も強いレンズ付近の、より多くのペア</translation>
    </message>
    <message>
        <source>a positive radius, width and height of 1 to %1 pixels</source>
        <translation>正の半径と、1～%1 ピクセルの幅と高さ</translation>
    </message>
    <message>
        <source>interrupted</source>
        <translation>中断されました</translation>
    </message>
    <message>
        <source>the file has too many pairs</source>
        <translation>ファイルのペアが多すぎます</translation>
    </message>
    <message>
        <source>at most %1</source>
        <translation>%1以下</translation>
    </message>
    <message>
        <source>the size of the image or of the cylinder is invalid</source>
        <translation>画像または円筒に使用できるサイズがありません</translation>
    </message>
    <message>
        <source>the pairs contain fewer than six different points</source>
        <translation>ペアに異なる点が6個未満しかありません</translation>
    </message>
    <message>
        <source>all points are on one line of the cylinder: the camera could turn about that line without changing the image</source>
        <translation>すべての点が円筒の1本の母線上にあります: カメラがその線の周りに回っても画像が変わりません</translation>
    </message>
    <message>
        <source>all points are on one ring of the cylinder: the camera&apos;s distance and its focal length cannot be distinguished</source>
        <translation>すべての点が円筒の1つの円周上にあります: カメラの距離と焦点距離を区別できません</translation>
    </message>
    <message>
        <source>all points are in one plane: the camera&apos;s distance and its focal length cannot be distinguished</source>
        <translation>すべての点が1つの平面上にあります: カメラの距離と焦点距離を区別できません</translation>
    </message>
    <message>
        <source>at least half of the pairs and at least %1 in agreement: check that pixels and points match, the image size and the cylinder radius</source>
        <translation>ペアの半数以上かつ%1以上の一致: 点の順に並んだ画素、正しい画像サイズと円筒半径</translation>
    </message>
    <message>
        <source>the lens model folds in the region of the pairs</source>
        <translation>レンズモデルがペアの範囲内で折り返しています</translation>
    </message>
    <message>
        <source>most points are on the axis of the cylinder, not on its surface</source>
        <translation>ほとんどの点が円筒の表面ではなく軸上にあります</translation>
    </message>
    <message>
        <source>the points are %1 mm from the axis, the surface is at %2 mm: a hole factor of %3 (standard error %4) brings them onto it, unless the radius is wrong</source>
        <translation>点は軸から %1 mm、表面は %2 mm です。半径が誤りでなければ、穴の係数 %3 (標準誤差 %4) で表面に移ります</translation>
    </message>
    <message>
        <source>many points are beyond the ends of the cylinder: check its length, and where z = 0 is</source>
        <translation>多くの点が円筒の端の外にあります。長さと z = 0 の位置を確かめてください</translation>
    </message>
    <message>
        <source>u and v seem to be swapped: the principal point is %1 px off the middle of the image, and with u and v swapped %2 px</source>
        <translation>u と v が入れ替わっているようです。主点は画像の中央から %1 px、入れ替えると %2 px です</translation>
    </message>
    <message>
        <source>many pixels are outside the image of %1 x %2 px: check its size</source>
        <translation>多くの画素が %1 x %2 px の画像の外にあります。サイズを確かめてください</translation>
    </message>
    <message>
        <source>neighbouring residuals are alike: the camera does not explain everything in the pairs (a shell that has moved, a wrong radius)</source>
        <translation>隣り合う残差が似ており、このカメラではペアのすべてを説明できません (シェルのずれ、半径の誤り)</translation>
    </message>
</context>
<context>
    <name>PartText</name>
    <message>
        <source>a part of the program cannot be loaded: %1</source>
        <translation>プログラムの一部を読み込めません: %1</translation>
    </message>
    <message>
        <source>a complete installation of the program</source>
        <translation>プログラムの完全なインストール</translation>
    </message>
</context>
<context>
    <name>ParticipantReport</name>
    <message>
        <source>In this part nothing was tested yet.</source>
        <translation>この部分では、まだ何もテストしていません。</translation>
    </message>
    <message>
        <source>You answered %1 of %2 trials correctly: %3 %.</source>
        <comment>numbers</comment>
        <translation>%2試行中%1試行に正しく答えました: %3 %。</translation>
    </message>
    <message>
        <source>There were %1 possible answers. Whoever guesses is right in about %2 % of the trials.</source>
        <translation>選べる答えは%1通りでした。当て推量だけでも、約%2 %の試行で正解します。</translation>
    </message>
    <message numerus="yes">
        <source>In %n trial(s) the time was over before you answered.</source>
        <translation>
            <numerusform>%n試行で、答える前に時間切れになりました。</numerusform>
        </translation>
    </message>
    <message>
        <source>Half of your correct answers came within %1 seconds.</source>
        <translation>正しい答えの半分は%1秒以内のものでした。</translation>
    </message>
    <message>
        <source>You recognised these every time: %1.</source>
        <translation>毎回正しく識別できたもの: %1。</translation>
    </message>
    <message>
        <source>, </source>
        <comment>between names</comment>
        <translation>, </translation>
    </message>
    <message>
        <source>This part was not finished.</source>
        <translation>この部分は終了していません。</translation>
    </message>
    <message>
        <source>Thank you for taking part in the study &quot;%1&quot;.</source>
        <translation>実験「%1」にご参加いただき、ありがとうございました。</translation>
    </message>
    <message>
        <source>You have not begun yet.</source>
        <translation>まだ始まっていません。</translation>
    </message>
    <message>
        <source>This page has your answers alone. They say how well these vibrations can be told apart on this bracelet; they are no test of health.</source>
        <translation>このページには、あなたの回答だけが載っています。これらの振動がこのブレスレットでどの程度識別できるかを示すもので、健康状態の検査ではありません。</translation>
    </message>
    <message>
        <source>Completed test trials of each session; the interval is Wilson&apos;s (95 %)</source>
        <translation>各セッションの完了したテスト試行。区間はWilsonのもの (95 %)</translation>
    </message>
    <message>
        <source>Session</source>
        <translation>セッション</translation>
    </message>
    <message>
        <source>Task</source>
        <translation>課題</translation>
    </message>
    <message>
        <source>Condition</source>
        <translation>条件</translation>
    </message>
    <message>
        <source>Finished</source>
        <translation>終了</translation>
    </message>
    <message>
        <source>Correct</source>
        <translation>正答</translation>
    </message>
    <message>
        <source>%</source>
        <translation>%</translation>
    </message>
    <message>
        <source>Interval, %</source>
        <translation>区間、%</translation>
    </message>
    <message>
        <source>No answer</source>
        <translation>無回答</translation>
    </message>
    <message>
        <source>Device faults</source>
        <translation>デバイス障害</translation>
    </message>
    <message>
        <source>Median time, s</source>
        <translation>時間の中央値、s</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>はい</translation>
    </message>
    <message>
        <source>no</source>
        <translation>いいえ</translation>
    </message>
    <message>
        <source>Rows: presented; columns: answered. Number of trials.</source>
        <translation>行: 提示。列: 回答。試行数。</translation>
    </message>
    <message>
        <source>Question</source>
        <translation>質問</translation>
    </message>
    <message>
        <source>Answer</source>
        <translation>回答</translation>
    </message>
    <message>
        <source>no answer</source>
        <translation>無回答</translation>
    </message>
    <message>
        <source>Questionnaires</source>
        <translation>質問票</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>メモ</translation>
    </message>
    <message>
        <source>the study has no participant &quot;%1&quot;</source>
        <translation>実験に参加者「%1」がいません</translation>
    </message>
    <message>
        <source>Your results</source>
        <translation>あなたの結果</translation>
    </message>
    <message>
        <source>Study: %1. Participant %2 in the order of enrolment.</source>
        <translation>実験: %1。登録順で%2番目の参加者。</translation>
    </message>
    <message>
        <source>No session has begun.</source>
        <translation>まだ始まったセッションはありません。</translation>
    </message>
    <message>
        <source>Participant %1</source>
        <comment>an id</comment>
        <translation>参加者 %1</translation>
    </message>
</context>
<context>
    <name>PatternCommand</name>
    <message>
        <source>shape</source>
        <translation>形状</translation>
    </message>
    <message>
        <source>stiffness</source>
        <translation>剛性</translation>
    </message>
    <message>
        <source>other</source>
        <translation>その他</translation>
    </message>
    <message>
        <source>-</source>
        <translation>-</translation>
    </message>
    <message>
        <source>static</source>
        <translation>静的</translation>
    </message>
    <message>
        <source>dynamic</source>
        <translation>動的</translation>
    </message>
    <message>
        <source>Id</source>
        <translation>ID</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名前</translation>
    </message>
    <message>
        <source>Task</source>
        <translation>課題</translation>
    </message>
    <message>
        <source>Condition</source>
        <translation>条件</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>長さ</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>Tags</source>
        <translation>タグ</translation>
    </message>
    <message>
        <source>Objects</source>
        <translation>オブジェクト</translation>
    </message>
    <message>
        <source>%1 s: %2</source>
        <translation>%1 s: %2</translation>
    </message>
    <message>
        <source>... (%1 breakpoints)</source>
        <translation>... (ブレークポイント%1個)</translation>
    </message>
    <message>
        <source>Tactor %1</source>
        <translation>タクタ %1</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>メモ</translation>
    </message>
    <message>
        <source>Object %1</source>
        <translation>オブジェクト %1</translation>
    </message>
    <message>
        <source>Object %1 (%2)</source>
        <translation>オブジェクト %1 (%2)</translation>
    </message>
    <message>
        <source>Pattern file or id of a built-in pattern</source>
        <translation>パターンファイルまたは組み込みパターンのid</translation>
    </message>
    <message>
        <source>List the built-in patterns</source>
        <translation>組み込みパターンを一覧表示します</translation>
    </message>
    <message>
        <source>Show what a pattern consists of</source>
        <translation>パターンの内容を表示します</translation>
    </message>
    <message>
        <source>Sample a pattern: rows time_s,t1..t6 over its duration</source>
        <translation>パターンをサンプリングします: 全長にわたる行 time_s,t1..t6</translation>
    </message>
    <message>
        <source>Samples a second</source>
        <translation>1秒あたりのサンプル数</translation>
    </message>
    <message>
        <source>Write the CSV to this file, which appears when it is complete</source>
        <translation>CSVをこのファイルに書き込む (完成した時点で現れます)</translation>
    </message>
    <message>
        <source>File to write</source>
        <translation>書き込み先ファイル</translation>
    </message>
    <message>
        <source>Say where a pattern breaks a law of what can be felt</source>
        <translation>パターンが知覚の法則に反する箇所を示します</translation>
    </message>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
    <message>
        <source>%1 keeps all laws.</source>
        <translation>%1 はすべての法則を満たしています。</translation>
    </message>
    <message>
        <source>%1, %2 s to %3 s: %4 %5</source>
        <translation>%1、%2 s～%3 s: %4 %5</translation>
    </message>
    <message>
        <source>List, show, sample, convert, check and play the patterns of the bracelet</source>
        <translation>ブレスレットのパターンの一覧表示、表示、サンプリング、変換、検査、再生</translation>
    </message>
    <message>
        <source>Profile of the bracelet&apos;s motors, as the page Calibrate saves it</source>
        <translation>キャリブレーションページで保存した、ブレスレットのモーターのプロファイル</translation>
    </message>
    <message>
        <source>What the motors will do; without --motors with an assumed motor: lag, start and speed are not measured</source>
        <translation>モーターの予測動作。--motorsがない場合は仮定のモーターを使用: 遅れ、始動点、速度は測定値ではありません</translation>
    </message>
    <message>
        <source>Samples a second of CSV (default 200) and WAV (default 8000)</source>
        <translation>CSV (既定値200) とWAV (既定値8000) の1秒あたりのサンプル数</translation>
    </message>
    <message>
        <source>CSV and WAV: what the motors will do, with an assumed motor: lag, start and speed are not measured</source>
        <translation>CSVとWAV: 仮定のモーターによるモーターの予測動作。遅れ、始動点、速度は測定値ではありません</translation>
    </message>
    <message>
        <source>Play a pattern on a bracelet</source>
        <translation>ブレスレットでパターンを再生します</translation>
    </message>
    <message>
        <source>%1 holds no samples: --rate and --predicted are for .csv and .wav files</source>
        <translation>%1 はサンプルを持ちません: --rateと--predictedは.csvと.wavファイル用です</translation>
    </message>
    <message>
        <source>usb, simulated, or a file that describes a bracelet</source>
        <translation>usb、simulated、またはブレスレットを記述したファイル</translation>
    </message>
    <message>
        <source>Speed the motors up with full intensity first, for as long as their profile allows</source>
        <translation>モーターの立ち上がりを助ける：加速している間、プロファイルが許す限り最大強度で駆動する</translation>
    </message>
    <message>
        <source>Write a pattern in another format, chosen by the ending</source>
        <translation>パターンを拡張子で決まる別の形式で書き込みます</translation>
    </message>
    <message>
        <source>Repeat it for this long, then send live setpoints for as long again, and print how punctual the frames were</source>
        <translation>この時間だけ繰り返し再生し、続けて同じ時間ライブ設定値を送り、フレームの時間精度を表示する</translation>
    </message>
    <message>
        <source>the ending of %1 is not that of a format; expected one of %2</source>
        <translation>%1 の拡張子から形式を判別できません。次のいずれかが必要です: %2</translation>
    </message>
    <message>
        <source>Ending that chooses the format when OUT is -, for example json</source>
        <translation>OUTが-のときに形式を決める拡張子。例: json</translation>
    </message>
    <message>
        <source>it belongs to OUT as -, where it is needed</source>
        <translation>OUTが-のときに使うもので、その場合は必須です</translation>
    </message>
    <message>
        <source>The samples are vibrations of %1 Hz with the intensities of the pattern.</source>
        <translation>サンプルは、パターンの強度を持つ%1 Hzの振動です。</translation>
    </message>
    <message>
        <source>The samples are the bare intensities, which move no voice coil: --carrier writes vibrations.</source>
        <translation>サンプルは強度のみで、ボイスコイルは動きません: --carrierを指定すると振動を書き込みます。</translation>
    </message>
    <message>
        <source>WAV: vibrations of this frequency, for voice coils, instead of the bare intensities; 250 without a number</source>
        <translation>WAV: 強度のみの代わりに、ボイスコイル用のこの周波数の振動。数値を省略すると250</translation>
    </message>
    <message>
        <source>A file with one signal: the tactors that play it, for example 1,4; all without this</source>
        <translation>信号が1つのファイル: それを再生するタクタ。例: 1,4。省略時はすべて</translation>
    </message>
    <message>
        <source>A .tact file with both arms: the one to read; left without this</source>
        <translation>両腕を含む.tactファイル: 読み込む腕。省略時は左</translation>
    </message>
    <message>
        <source>expected numbers from 1 to 6 between commas</source>
        <translation>1から6までのコンマ区切りの番号が必要です</translation>
    </message>
    <message>
        <source>it belongs to a file with one signal</source>
        <translation>信号が1つのファイルでのみ指定できます</translation>
    </message>
    <message>
        <source>it is for .wav files</source>
        <translation>.wavファイル用です</translation>
    </message>
</context>
<context>
    <name>PatternFile</name>
    <message>
        <source>there is no tactor for the file &quot;%1&quot;</source>
        <translation>ファイル「%1」に対応するタクタがありません</translation>
    </message>
    <message>
        <source>the pattern is too long for a WAV file</source>
        <translation>パターンがWAVファイルには長すぎます</translation>
    </message>
    <message>
        <source>at most 4 GiB of samples</source>
        <translation>サンプル4 GiB以下</translation>
    </message>
    <message>
        <source>a time that is not before the start</source>
        <translation>開始より前でない時刻</translation>
    </message>
    <message>
        <source>this effect is for other devices</source>
        <translation>この効果はほかのデバイス用です</translation>
    </message>
    <message>
        <source>a pattern file that ends with .json</source>
        <translation>.jsonで終わるパターンファイル</translation>
    </message>
    <message>
        <source>the key &quot;recovery&quot;</source>
        <translation>キー &quot;recovery&quot;</translation>
    </message>
    <message>
        <source>a WAV file cannot have this rate</source>
        <translation>WAVファイルではこのレートを使えません</translation>
    </message>
    <message>
        <source>the pattern is too long for overdrive</source>
        <translation>パターンがオーバードライブには長すぎます</translation>
    </message>
    <message>
        <source>at most %1 s</source>
        <translation>%1 s以下</translation>
    </message>
    <message>
        <source>the pattern has too many corners</source>
        <translation>パターンの角が多すぎます</translation>
    </message>
    <message>
        <source>at most %1 breakpoints</source>
        <translation>ブレークポイント%1個以下</translation>
    </message>
    <message>
        <source>the pattern cannot be stretched by this factor</source>
        <translation>パターンをそのように伸縮できません</translation>
    </message>
    <message>
        <source>a factor above 0 that makes it at most a day long</source>
        <translation>全長が1日以内になる、0より大きい倍率</translation>
    </message>
    <message>
        <source>the times decrease</source>
        <translation>時刻が戻っています</translation>
    </message>
    <message>
        <source>a time that is not before the previous one</source>
        <translation>直前の時刻より前でない時刻</translation>
    </message>
    <message>
        <source>a pattern cannot represent this</source>
        <translation>パターンはこれを保持できません</translation>
    </message>
    <message>
        <source>the times decrease or exceed the longest pattern</source>
        <translation>時刻が戻っているか、長すぎます</translation>
    </message>
    <message>
        <source>the folder cannot be created</source>
        <translation>フォルダーを作成できません</translation>
    </message>
    <message>
        <source>this format cannot store another name</source>
        <translation>この形式はほかの名前を保持できません</translation>
    </message>
    <message>
        <source>this name is unknown</source>
        <translation>この名前は不明です</translation>
    </message>
    <message>
        <source>this is a different format</source>
        <translation>これは別の形式です</translation>
    </message>
    <message>
        <source>the file was written by a newer version</source>
        <translation>ファイルのバージョンが新しすぎます</translation>
    </message>
    <message>
        <source>this is not a recovery file</source>
        <translation>復旧ファイルではありません</translation>
    </message>
    <message>
        <source>the sample rate is out of range</source>
        <translation>サンプルレートが範囲外です</translation>
    </message>
    <message>
        <source>%1 to %2 per second</source>
        <translation>毎秒%1～%2</translation>
    </message>
    <message>
        <source>the values of a motor are inconsistent</source>
        <translation>モーターの値が互いに矛盾しています</translation>
    </message>
    <message>
        <source>a whole number of samples per second</source>
        <translation>1秒あたり整数個のサンプル</translation>
    </message>
    <message>
        <source>this part is not known</source>
        <translation>この部分は不明です</translation>
    </message>
    <message>
        <source>too many pieces overlap</source>
        <translation>重なり合う区間が多すぎます</translation>
    </message>
    <message>
        <source>a pattern of at most %1 objects</source>
        <translation>%1個以下のオブジェクトからなるパターン</translation>
    </message>
    <message>
        <source>there are too many emphases</source>
        <translation>強調 (emphasis) が多すぎます</translation>
    </message>
    <message>
        <source>at most %1</source>
        <translation>%1以下</translation>
    </message>
    <message>
        <source>vectorial waves, transients or curves of vibration</source>
        <translation>ベクトル波形、トランジェント、または振動の曲線</translation>
    </message>
    <message>
        <source>there are too many effects, or too many inside each other</source>
        <translation>効果が多すぎるか、入れ子が深すぎます</translation>
    </message>
    <message>
        <source>there is no such effect in the library</source>
        <translation>ライブラリにこの効果はありません</translation>
    </message>
    <message>
        <source>the id of an effect in effect_library</source>
        <translation>effect_libraryにある効果のid</translation>
    </message>
    <message>
        <source>there are too many keyframes</source>
        <translation>キーフレームが多すぎます</translation>
    </message>
    <message>
        <source>files tactor1%1 to tactor6%1, each once</source>
        <translation>ファイルtactor1%1からtactor6%1まで、各1つ</translation>
    </message>
    <message>
        <source>the paths are too long</source>
        <translation>経路が長すぎます</translation>
    </message>
    <message>
        <source>at most %1 points</source>
        <translation>%1個以下の点</translation>
    </message>
    <message>
        <source>this rate cannot hold a carrier of %1 Hz</source>
        <translation>このレートでは%1 Hzの搬送波を表せません</translation>
    </message>
    <message>
        <source>a carrier above 0 and below half of %1 samples per second</source>
        <translation>0より大きく、毎秒%1サンプルの半分より低い搬送波</translation>
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
        <translation>バーストの開始間隔は%1です。1つの運動として感じられるのは%2です。</translation>
    </message>
    <message>
        <source>Object %1 plays on the same motor at the same time (tactors %2).</source>
        <translation>オブジェクト %1 が同じモーターで同時に再生されます (タクタ %2)。</translation>
    </message>
    <message>
        <source>Tactors %1 are at most %2 Hz apart in speed: they beat.</source>
        <translation>タクタ %1 の速度差は最大 %2 Hzです: うなりが生じます。</translation>
    </message>
    <message>
        <source>It goes on until %1 s, but the pattern ends at %2 s.</source>
        <translation>%1 sまで続きますが、パターンは%2 sで終わります。</translation>
    </message>
    <message>
        <source>Give the ring %1 turns.</source>
        <translation>リングを%1周にしてください。</translation>
    </message>
    <message>
        <source>Make it %1 long.</source>
        <translation>長さを%1にしてください。</translation>
    </message>
    <message>
        <source>Make the ring %1 long.</source>
        <translation>リングの長さを%1にしてください。</translation>
    </message>
    <message>
        <source>Let the law of apparent motion set them %1 apart.</source>
        <translation>仮現運動の法則に従い、間隔を%1にしてください。</translation>
    </message>
    <message>
        <source>Give both the same intensity, or make them %1 Hz different.</source>
        <translation>両方を同じ強度にするか、%1 Hzの差をつけてください。</translation>
    </message>
    <message>
        <source>Let the pattern last %1 s.</source>
        <translation>パターンの長さを%1 sにしてください。</translation>
    </message>
    <message>
        <source>Make motor %1 weaker there, by %2 %, so that they are %3 Hz apart.</source>
        <translation>そこでモーター %1 を %2 % 弱くして、互いに %3 Hz 離します。</translation>
    </message>
    <message>
        <source>A burst of %1 is too short for the motor, which needs %2 to speed up.</source>
        <translation>%1のバーストは、立ち上がりに%2かかるモーターには短すぎます。</translation>
    </message>
    <message>
        <source>A turn of the ring takes %1; its direction is felt reliably only if a turn takes at least %2.</source>
        <translation>リング1周は%1です。その方向を確実に感じられるのは%2以上です。</translation>
    </message>
    <message>
        <source>Let it begin at %1 s, when the other one has ended.</source>
        <translation>もう一方が終わる%1 sから始めてください。</translation>
    </message>
</context>
<context>
    <name>PatternLoss</name>
    <message>
        <source>Frequencies left out: %1. The frequency of the motors follows their intensity.</source>
        <translation>除外した周波数: %1。モーターの周波数は強度に従います。</translation>
    </message>
    <message>
        <source>Short pulses that became bursts of %2 ms: %1.</source>
        <translation>%2 msのバーストになった短いパルス: %1。</translation>
    </message>
    <message>
        <source>The pattern is longer than the file by %1 s, so that its last burst is whole.</source>
        <translation>最後のバーストが欠けないように、パターンはファイルより%1 s長くなっています。</translation>
    </message>
    <message>
        <source>The file holds one signal. It plays on tactor %1.</source>
        <comment>a list of numbers</comment>
        <translation>ファイルの信号は1つです。タクタ%1で再生されます。</translation>
    </message>
    <message>
        <source>Channels without a direction, put on the tactors in their order: %1.</source>
        <translation>方向がなく、順にタクタに割り当てたチャンネル: %1。</translation>
    </message>
    <message>
        <source>Channels left out, because no tactor is left for them: %1.</source>
        <translation>割り当てるタクタが残っていないため除外したチャンネル: %1。</translation>
    </message>
    <message>
        <source>Effects for the other arm left out: %1.</source>
        <translation>除外した反対の腕の効果: %1。</translation>
    </message>
    <message>
        <source>Effects for other devices left out: %1.</source>
        <translation>除外したほかのデバイス用の効果: %1。</translation>
    </message>
    <message>
        <source>Parts that are not vibration left out: %1.</source>
        <translation>除外した振動以外の部分: %1。</translation>
    </message>
    <message>
        <source>Tracks left out that are switched off: %1.</source>
        <translation>除外した無効なトラック: %1。</translation>
    </message>
    <message>
        <source>Pieces that overlap others: %1. The stronger one counts; they do not add up.</source>
        <translation>ほかと重なる区間: %1。強いほうが有効で、加算はされません。</translation>
    </message>
    <message>
        <source>Paths shared among the motors nearest to them: %1.</source>
        <translation>最も近いモーターに配分した経路: %1。</translation>
    </message>
    <message>
        <source>Paths or envelopes of a single point left out: %1. They have no length.</source>
        <translation>除外した1点だけの経路またはエンベロープ: %1。長さがありません。</translation>
    </message>
    <message>
        <source>Sounds left out: %1.</source>
        <translation>除外した音: %1。</translation>
    </message>
    <message>
        <source>Events whose attack, decay or release was left out: %1.</source>
        <translation>アタック、ディケイ、またはリリースを除外したイベント: %1。</translation>
    </message>
    <message>
        <source>Settings that a pattern does not have: %1.</source>
        <translation>パターンにない設定: %1。</translation>
    </message>
    <message>
        <source>Coded wave forms left out: %1.</source>
        <translation>除外した符号化波形: %1。</translation>
    </message>
    <message>
        <source>Curves of displacement, of which the size plays in straight lines: %1.</source>
        <translation>大きさを折れ線で再生する変位の曲線: %1。</translation>
    </message>
    <message>
        <source>Intensities beyond full drive, set to 1: %1.</source>
        <translation>最大駆動量を超えたため1にした強度: %1。</translation>
    </message>
    <message>
        <source>Objects written as the intensities that they play: %1.</source>
        <translation>再生される強度として書き込んだオブジェクト: %1。</translation>
    </message>
    <message>
        <source>Slopes written as steps of %2 ms: %1. They differ from the pattern by up to %3.</source>
        <translation>%2 msの段階として書き込んだ傾斜: %1。パターンとの差は最大%3です。</translation>
    </message>
    <message>
        <source>Times rounded to milliseconds: %1.</source>
        <translation>ミリ秒に丸めた時刻: %1。</translation>
    </message>
    <message>
        <source>The first one is at %1 s.</source>
        <translation>最初のものは%1 sにあります。</translation>
    </message>
    <message>
        <source>First seen in %1.</source>
        <translation>最初に見つかった場所: %1。</translation>
    </message>
    <message>
        <source>Keyframes before the beginning of their effect, moved to it: %1.</source>
        <translation>効果の始まりより前にあり、そこへ移したキーフレーム: %1</translation>
    </message>
    <message>
        <source>Shapes and phases of waves left out: %1. The motors play their strength only.</source>
        <translation>除外した波の形と位相: %1。モーターは波の強さだけを再生します。</translation>
    </message>
</context>
<context>
    <name>PatternNames</name>
    <message>
        <source>Circle, static</source>
        <translation>円、静的</translation>
    </message>
    <message>
        <source>Rectangle, static</source>
        <translation>長方形、静的</translation>
    </message>
    <message>
        <source>Triangle, static</source>
        <translation>三角形、静的</translation>
    </message>
    <message>
        <source>Arc, static</source>
        <translation>円弧、静的</translation>
    </message>
    <message>
        <source>Line, static</source>
        <translation>線、静的</translation>
    </message>
    <message>
        <source>Point, static</source>
        <translation>点、静的</translation>
    </message>
    <message>
        <source>Circle, dynamic</source>
        <translation>円、動的</translation>
    </message>
    <message>
        <source>Rectangle, dynamic</source>
        <translation>長方形、動的</translation>
    </message>
    <message>
        <source>Triangle, dynamic</source>
        <translation>三角形、動的</translation>
    </message>
    <message>
        <source>Arc, dynamic</source>
        <translation>円弧、動的</translation>
    </message>
    <message>
        <source>Line, dynamic</source>
        <translation>線、動的</translation>
    </message>
    <message>
        <source>Point, dynamic</source>
        <translation>点、動的</translation>
    </message>
    <message>
        <source>Sponge, static</source>
        <translation>スポンジ、静的</translation>
    </message>
    <message>
        <source>Rubber sponge, static</source>
        <translation>ゴムスポンジ、静的</translation>
    </message>
    <message>
        <source>Rubber, static</source>
        <translation>ゴム、静的</translation>
    </message>
    <message>
        <source>Wood, static</source>
        <translation>木、静的</translation>
    </message>
    <message>
        <source>Metal, static</source>
        <translation>金属、静的</translation>
    </message>
    <message>
        <source>Sponge, dynamic</source>
        <translation>スポンジ、動的</translation>
    </message>
    <message>
        <source>Rubber sponge, dynamic</source>
        <translation>ゴムスポンジ、動的</translation>
    </message>
    <message>
        <source>Rubber, dynamic</source>
        <translation>ゴム、動的</translation>
    </message>
    <message>
        <source>Wood, dynamic</source>
        <translation>木、動的</translation>
    </message>
    <message>
        <source>Metal, dynamic</source>
        <translation>金属、動的</translation>
    </message>
</context>
<context>
    <name>PatternPlay</name>
    <message>
        <source>the profile is of the bracelet &quot;%1&quot;</source>
        <translation>プロファイルはブレスレット「%1」のものです</translation>
    </message>
    <message>
        <source>median %1, 99 % below %2, longest %3 us</source>
        <translation>中央値 %1、99 %は %2 未満、最長 %3 us</translation>
    </message>
    <message>
        <source>The bracelet was lost.</source>
        <translation>ブレスレットとの接続が切れました。</translation>
    </message>
    <message>
        <source>A frame was so late that the bracelet had stopped.</source>
        <translation>フレームが遅れすぎ、ブレスレットが停止していました。</translation>
    </message>
    <message>
        <source>Bracelet</source>
        <translation>ブレスレット</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>レート</translation>
    </message>
    <message>
        <source>%1 Hz, achieved %2 Hz</source>
        <translation>%1 Hz、実測 %2 Hz</translation>
    </message>
    <message>
        <source>Playback thread</source>
        <translation>再生スレッド</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>フレーム</translation>
    </message>
    <message>
        <source>Deadlines missed</source>
        <translation>締め切り超過</translation>
    </message>
    <message>
        <source>Frames lost</source>
        <translation>フレーム損失</translation>
    </message>
    <message>
        <source>Late by</source>
        <translation>遅れ</translation>
    </message>
    <message>
        <source>Write</source>
        <translation>書き込み</translation>
    </message>
    <message>
        <source>Setpoints</source>
        <translation>設定値</translation>
    </message>
    <message>
        <source>Misses meanwhile</source>
        <translation>その間の超過</translation>
    </message>
    <message>
        <source>Snapshot to frame</source>
        <translation>スナップショットからフレームまで</translation>
    </message>
    <message>
        <source>No bracelet answers.</source>
        <translation>応答するブレスレットがありません。</translation>
    </message>
    <message>
        <source>The bracelet is too hot.</source>
        <translation>ブレスレットが熱すぎます。</translation>
    </message>
    <message>
        <source>let it cool down first</source>
        <translation>先に冷ましてください</translation>
    </message>
    <message>
        <source>Confirmed</source>
        <translation>確認</translation>
    </message>
    <message>
        <source>played by the callback of the sound card</source>
        <translation>サウンドカードのコールバックが再生</translation>
    </message>
    <message>
        <source>Latency</source>
        <translation>遅延</translation>
    </message>
    <message>
        <source>at most %1 ms, as stated, not measured</source>
        <translation>最大%1 ms (申告値、測定値ではありません)</translation>
    </message>
    <message>
        <source>Callback</source>
        <translation>コールバック</translation>
    </message>
    <message>
        <source>%1 % of a period, longest %2 %, %3 missed</source>
        <translation>周期の%1 %、最長%2 %、逃した周期%3</translation>
    </message>
    <message>
        <source>%1 ms, as measured</source>
        <translation>%1 ms (測定値)</translation>
    </message>
</context>
<context>
    <name>PlanContent</name>
    <message>
        <source>%1: %2</source>
        <comment>task, test</comment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>conditions</source>
        <translation>条件</translation>
    </message>
    <message>
        <source>patterns</source>
        <translation>パターン</translation>
    </message>
    <message>
        <source>conditions by patterns</source>
        <translation>条件 × パターン</translation>
    </message>
    <message>
        <source>Power: %1</source>
        <comment>test</comment>
        <translation>検出力: %1</translation>
    </message>
    <message>
        <source>participants</source>
        <translation>参加者数</translation>
    </message>
    <message>
        <source>significant studies, %</source>
        <translation>有意となった実験、%</translation>
    </message>
    <message>
        <source>target</source>
        <translation>目標</translation>
    </message>
    <message>
        <source>Cancelled. The curve has the studies drawn so far.</source>
        <translation>キャンセルしました。曲線は、それまでに生成した実験によるものです。</translation>
    </message>
    <message>
        <source>No number up to %1 reaches %2 %.</source>
        <translation>%1名以下では%2 %に達しません。</translation>
    </message>
    <message>
        <source>%1 or %2 participants reach %3 %; chance cannot tell which.</source>
        <translation>%1名または%2名の参加者で%3 %に達します。どちらであるかは、偶然のばらつきのため決まりません。</translation>
    </message>
    <message>
        <source>%1 participants reach %2 %.</source>
        <translation>%1名の参加者で%2 %に達します。</translation>
    </message>
    <message>
        <source>threshold</source>
        <translation>閾値</translation>
    </message>
    <message>
        <source>studies with an interval narrow enough, %</source>
        <translation>区間が十分に狭い実験、%</translation>
    </message>
    <message>
        <source>Precision: %1</source>
        <comment>test</comment>
        <translation>精度: %1</translation>
    </message>
</context>
<context>
    <name>PlaneCalibration</name>
    <message>
        <source>Find how pixels become places on a flat gel: by --board, --ruler or --pitch-mm</source>
        <translation>平らなゲル上の位置と画素の対応を、--board、--ruler、--pitch-mmのいずれかで求めます</translation>
    </message>
    <message>
        <source>Inner corners of the chessboard in the picture, as 7x5</source>
        <translation>画像にあるチェスボードの内側の角の数。例: 7x5</translation>
    </message>
    <message>
        <source>Side of a square of the chessboard, mm</source>
        <translation>チェスボードの升目の一辺 (mm)</translation>
    </message>
    <message>
        <source>Distance of neighbouring markers of the gel, mm</source>
        <translation>ゲルの隣り合うマーカーの間隔 (mm)</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>縮尺</translation>
    </message>
    <message>
        <source>%1 mm/px, standard deviation %2 mm/px</source>
        <translation>%1 mm/px、標準偏差%2 mm/px</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>点</translation>
    </message>
    <message>
        <source>Kept</source>
        <translation>使用</translation>
    </message>
    <message>
        <source>Off by</source>
        <translation>ずれ</translation>
    </message>
    <message>
        <source>%1 px rms</source>
        <translation>%1 px (二乗平均平方根)</translation>
    </message>
    <message>
        <source>one of --board, --ruler and --pitch-mm is needed</source>
        <translation>--board、--ruler、--pitch-mmのいずれか1つが必要です</translation>
    </message>
    <message>
        <source>a single row does not show a plane</source>
        <translation>1行だけでは面が決まりません</translation>
    </message>
    <message>
        <source>the side of a square is needed with --board</source>
        <translation>--boardには升目の一辺が必要です</translation>
    </message>
    <message>
        <source>a PNG or JPEG picture of a chessboard</source>
        <translation>チェスボードのPNGまたはJPEG画像</translation>
    </message>
    <message>
        <source>the markers of this sensor form no rectangular grid</source>
        <translation>このセンサーのマーカーは長方形の格子ではありません</translation>
    </message>
    <message>
        <source>grid = &quot;rectangular&quot; with rows and columns</source>
        <translation>grid = &quot;rectangular&quot;とrows、columns</translation>
    </message>
    <message>
        <source>no picture can be read from it</source>
        <translation>画像を読み取れません</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not two pixels and a length: U,V,U,V,MM</source>
        <translation>「%1」は2つの画素と長さ(U,V,U,V,MM)ではありません</translation>
    </message>
    <message>
        <source>Of a flat gel: its sensor file, with crop, flips, lens and grid of markers; [plane] may be absent</source>
        <translation>平らなゲルの場合: 切り抜き、反転、レンズ、マーカーの格子を記したセンサーファイル。[plane]はなくてもかまいません</translation>
    </message>
    <message>
        <source>Two points of a ruler in the camera&apos;s whole picture, and their distance; several times for several lengths. A picture is only read for its size</source>
        <translation>カメラの画像全体の中の定規の2点とその距離。複数の長さには繰り返し指定します。画像は大きさのためにだけ読み込まれます</translation>
    </message>
    <message>
        <source>Rulers</source>
        <translation>定規</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a size such as 7x5</source>
        <translation>「%1」は7x5のようなサイズではありません</translation>
    </message>
    <message>
        <source>this is not a picture</source>
        <translation>これは画像ではありません</translation>
    </message>
    <message>
        <source>a PNG or JPEG picture</source>
        <translation>PNGまたはJPEGの画像</translation>
    </message>
    <message>
        <source>a point lies outside the picture of %1 x %2 pixels</source>
        <translation>点が%1 x %2ピクセルの画像の外にあります</translation>
    </message>
    <message>
        <source>the lens of the sensor file needs the size of the picture: give a picture too, or a crop in the sensor file</source>
        <translation>センサーファイルのレンズには画像の大きさが必要です。画像も指定するか、センサーファイルで切り抜きを指定してください</translation>
    </message>
    <message>
        <source>a point lies where the lens of the sensor file shows no place</source>
        <translation>センサーファイルのレンズでは何も写らない位置に点があります</translation>
    </message>
</context>
<context>
    <name>PlaneFit</name>
    <message numerus="yes">
        <source>%n point(s) are too few</source>
        <translation>
            <numerusform>%n点では少なすぎます</numerusform>
        </translation>
    </message>
    <message>
        <source>at least %1 points</source>
        <translation>%1点以上</translation>
    </message>
    <message>
        <source>all points lie on one line, which does not show a plane</source>
        <translation>すべての点が一直線上にあり、面が決まりません</translation>
    </message>
    <message>
        <source>points in at least two rows</source>
        <translation>2行以上に並ぶ点</translation>
    </message>
    <message>
        <source>the points show no plane in front of the camera</source>
        <translation>点からはカメラの前の面が求まりません</translation>
    </message>
    <message>
        <source>points of one flat pattern, each with its own place</source>
        <translation>1つの平らな模様の点。それぞれが異なる位置にあるもの</translation>
    </message>
    <message>
        <source>the length of the ruler is not above 0</source>
        <translation>定規の長さが0より大きくありません</translation>
    </message>
    <message>
        <source>the two points of the ruler are too close to each other</source>
        <translation>定規の2点が近すぎます</translation>
    </message>
    <message>
        <source>points that are at least %1 px apart</source>
        <translation>%1 px以上離れた点</translation>
    </message>
    <message>
        <source>no ruler was read</source>
        <translation>定規が読み取られていません</translation>
    </message>
    <message>
        <source>the rulers contradict each other: %1 mm is %2 px off</source>
        <translation>定規が互いに矛盾しています: %1 mmが%2 pxずれています</translation>
    </message>
    <message>
        <source>lengths that agree within 5 %; a picture seen askew needs a chessboard</source>
        <translation>5 %以内で一致する長さ。斜めに撮った画像にはチェスボードが必要です</translation>
    </message>
</context>
<context>
    <name>ProcessText</name>
    <message>
        <source>the program cannot be started: %1</source>
        <translation>プログラムを起動できません：%1</translation>
    </message>
</context>
<context>
    <name>ProgramText</name>
    <message>
        <source>Usage</source>
        <translation>使い方</translation>
    </message>
    <message>
        <source>OPTIONS</source>
        <translation>OPTIONS</translation>
    </message>
    <message>
        <source>Options</source>
        <translation>オプション</translation>
    </message>
    <message>
        <source>Arguments</source>
        <translation>引数</translation>
    </message>
    <message>
        <source>COMMAND</source>
        <translation>COMMAND</translation>
    </message>
    <message>
        <source>Commands</source>
        <translation>コマンド</translation>
    </message>
    <message>
        <source>(required)</source>
        <translation>(必須)</translation>
    </message>
    <message>
        <source>Print this help</source>
        <translation>このヘルプを表示する</translation>
    </message>
    <message>
        <source>Computes contacts, stiffness and shape from what a tactile robot arm has felt.</source>
        <translation>触覚ロボットアームが感じたものから、接触、剛性、形状を計算します。</translation>
    </message>
    <message>
        <source>Print the version</source>
        <translation>バージョンを表示する</translation>
    </message>
    <message>
        <source>Example:</source>
        <translation>例:</translation>
    </message>
    <message>
        <source>there is no command &apos;%1&apos;; expected one of %2</source>
        <translation>コマンド「%1」はありません。次のいずれかを指定してください: %2</translation>
    </message>
    <message>
        <source>teleta: %1
Run %2 --help for more.
</source>
        <translation>teleta: %1
詳しくは %2 --help を参照してください。
</translation>
    </message>
    <message>
        <source>With --version: print version and commit as JSON</source>
        <translation>--versionと併用: バージョンとコミットをJSONで出力する</translation>
    </message>
    <message>
        <source>Print how to cite the program, as BibTeX</source>
        <translation>プログラムの引用方法をBibTeXで出力する</translation>
    </message>
    <message>
        <source>there is not enough memory</source>
        <translation>メモリが足りません</translation>
    </message>
</context>
<context>
    <name>ProtocolSummary</name>
    <message>
        <source>Each trial</source>
        <translation>各試行</translation>
    </message>
    <message>
        <source>Practice</source>
        <translation>練習</translation>
    </message>
    <message>
        <source>Test</source>
        <translation>テスト</translation>
    </message>
    <message>
        <source>Order</source>
        <translation>順序</translation>
    </message>
    <message>
        <source>All repetitions together, in random order.</source>
        <translation>すべての繰り返しをまとめてランダムな順序で。</translation>
    </message>
    <message>
        <source>Each repetition in a random order.</source>
        <translation>繰り返しごとにランダムな順序で。</translation>
    </message>
    <message>
        <source>Rests</source>
        <translation>休憩</translation>
    </message>
    <message>
        <source>Masking noise</source>
        <translation>マスキングノイズ</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>記録</translation>
    </message>
    <message>
        <source>Each session is recorded.</source>
        <translation>各セッションが記録されます。</translation>
    </message>
    <message>
        <source>Test trials</source>
        <translation>テスト試行</translation>
    </message>
    <message numerus="yes">
        <source>%n for each participant, at most.</source>
        <translation>
            <numerusform>参加者ごとに最大 %n 回。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n question(s).</source>
        <translation>
            <numerusform>質問 %n 件。</numerusform>
        </translation>
    </message>
    <message>
        <source>Questionnaires</source>
        <translation>質問票</translation>
    </message>
    <message>
        <source>What does not count</source>
        <translation>除外されるもの</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>The stimulus lasts %1 at most.</source>
        <translation>刺激は最長 %1 です。</translation>
    </message>
    <message>
        <source>The answer counts within %1 of its onset.</source>
        <translation>開始から %1 以内の回答が有効です。</translation>
    </message>
    <message>
        <source>The answer counts within %1 of its end.</source>
        <translation>終了から %1 以内の回答が有効です。</translation>
    </message>
    <message>
        <source>It is felt once.</source>
        <translation>提示は 1 回だけです。</translation>
    </message>
    <message numerus="yes">
        <source>It may be felt again %n time(s).</source>
        <translation>
            <numerusform>さらに %n 回まで提示できます。</numerusform>
        </translation>
    </message>
    <message>
        <source>None.</source>
        <translation>なし。</translation>
    </message>
    <message numerus="yes">
        <source>Each stimulus %n time(s).</source>
        <translation>
            <numerusform>各刺激 %n 回。</numerusform>
        </translation>
    </message>
    <message>
        <source>The right answer is shown after each trial.</source>
        <translation>各試行の後に正解が表示されます。</translation>
    </message>
    <message>
        <source>The right answer is not shown.</source>
        <translation>正解は表示されません。</translation>
    </message>
    <message>
        <source>The pictures of the patterns are in view.</source>
        <translation>パターンの図が表示されます。</translation>
    </message>
    <message>
        <source>The pictures of the patterns are not in view.</source>
        <translation>パターンの図は表示されません。</translation>
    </message>
    <message numerus="yes">
        <source>After every %n trial(s), at least %1.</source>
        <translation>
            <numerusform>%n 試行ごとに、%1 以上。</numerusform>
        </translation>
    </message>
    <message>
        <source>Pink, %1 dBA.</source>
        <translation>ピンク、%1 dBA。</translation>
    </message>
    <message>
        <source>Conditions</source>
        <translation>条件</translation>
    </message>
    <message>
        <source>Which was it?</source>
        <translation>どれでしたか</translation>
    </message>
    <message>
        <source>Question</source>
        <translation>質問</translation>
    </message>
    <message>
        <source>Design</source>
        <translation>課題形式</translation>
    </message>
    <message>
        <source>Levels</source>
        <translation>レベル</translation>
    </message>
    <message>
        <source>%1 to %2 %3, chosen by %4.</source>
        <comment>lowest, highest, unit, procedure</comment>
        <translation>%1～%2 %3、%4 で選択。</translation>
    </message>
    <message>
        <source>Tracks</source>
        <translation>トラック</translation>
    </message>
    <message numerus="yes">
        <source>%n, interleaved.</source>
        <translation>
            <numerusform>%n トラックを交互に。</numerusform>
        </translation>
    </message>
    <message>
        <source>Yes or no: was it there?</source>
        <translation>はい・いいえ: ありましたか</translation>
    </message>
    <message>
        <source>Intervals: in which one was it?</source>
        <translation>区間: どの区間でしたか</translation>
    </message>
    <message>
        <source>Same or different?</source>
        <translation>同じか違うか</translation>
    </message>
    <message>
        <source>Compare: which one had more?</source>
        <translation>比較: どちらが大きいか</translation>
    </message>
    <message>
        <source>constant stimuli</source>
        <translation>恒常法</translation>
    </message>
    <message>
        <source>a staircase</source>
        <translation>階段法</translation>
    </message>
    <message>
        <source>a Bayesian procedure (QUEST+)</source>
        <translation>ベイズ法 (QUEST+)</translation>
    </message>
    <message>
        <source>Before the first session.</source>
        <translation>最初のセッションの前。</translation>
    </message>
    <message>
        <source>Before each session.</source>
        <translation>各セッションの前。</translation>
    </message>
    <message>
        <source>After each session.</source>
        <translation>各セッションの後。</translation>
    </message>
    <message>
        <source>After the last session.</source>
        <translation>最後のセッションの後。</translation>
    </message>
    <message>
        <source>Trials answered earlier than %1.</source>
        <translation>%1 より早い回答の試行。</translation>
    </message>
    <message>
        <source>Trials answered later than %1.</source>
        <translation>%1 より遅い回答の試行。</translation>
    </message>
    <message>
        <source>Trials whose time is more than %1 MADs from the median.</source>
        <translation>時間が中央値から %1 MAD を超えて離れた試行。</translation>
    </message>
    <message>
        <source>Trials with more than %1 device faults.</source>
        <translation>デバイス障害が %1 件を超える試行。</translation>
    </message>
    <message>
        <source>Trials with more than %1 missed frames.</source>
        <translation>欠落フレームが %1 を超える試行。</translation>
    </message>
    <message>
        <source>Sessions in which more than %1 % of the trials have no answer.</source>
        <translation>無回答の試行が %1 % を超えるセッション。</translation>
    </message>
    <message>
        <source>Sessions with more than %1 % of yes in catch trials.</source>
        <translation>キャッチ試行で「はい」が %1 % を超えるセッション。</translation>
    </message>
    <message>
        <source>Sessions with one answer in more than %1 % of the trials.</source>
        <translation>同じ回答が試行の %1 % を超えるセッション。</translation>
    </message>
    <message>
        <source>Participants with less than %1 % right in practice.</source>
        <translation>練習の正答が %1 % 未満の参加者。</translation>
    </message>
    <message>
        <source>Participants who are not better than chance (p above %1).</source>
        <translation>偶然を上回らない参加者（p が %1 を超える）。</translation>
    </message>
</context>
<context>
    <name>Provenance</name>
    <message>
        <source>SIMULATED</source>
        <translation>シミュレーション</translation>
    </message>
    <message>
        <source>RECORDED</source>
        <translation>記録</translation>
    </message>
    <message>
        <source>RECORDED SIMULATION</source>
        <translation>シミュレーションの記録</translation>
    </message>
    <message>
        <source>UNGUARDED</source>
        <translation>保護なし</translation>
    </message>
</context>
<context>
    <name>PseudonymKey</name>
    <message>
        <source>another program changes the file</source>
        <translation>別のプログラムがファイルを変更しています</translation>
    </message>
    <message>
        <source>to try again in a moment</source>
        <translation>しばらくしてからやり直すこと</translation>
    </message>
    <message>
        <source>the key of the pseudonyms lies in the study&apos;s folder</source>
        <translation>仮名の鍵が実験のフォルダーにあります</translation>
    </message>
    <message>
        <source>a file apart from the data, which are copied and published</source>
        <translation>データとは別の場所のファイル（データはコピーされ公開されます）</translation>
    </message>
    <message>
        <source>a row has no participant</source>
        <translation>参加者のない行があります</translation>
    </message>
    <message>
        <source>a participant of the study</source>
        <translation>実験の参加者</translation>
    </message>
    <message>
        <source>the key has a person for &quot;%1&quot; already</source>
        <translation>鍵には「%1」の人がすでにいます</translation>
    </message>
    <message>
        <source>another name</source>
        <translation>別の名前</translation>
    </message>
</context>
<context>
    <name>QosText</name>
    <message>
        <source>the publisher is best effort, the subscriber asks for reliable</source>
        <translation>送信側は best effort ですが、受信側は reliable を求めています</translation>
    </message>
    <message>
        <source>the publisher is volatile, the subscriber asks for transient local</source>
        <translation>送信側は volatile ですが、受信側は transient local を求めています</translation>
    </message>
    <message>
        <source>publisher and subscriber have incompatible qualities of service (QoS)</source>
        <translation>送信側と受信側のサービス品質（QoS）が合いません</translation>
    </message>
</context>
<context>
    <name>RecordedLoads</name>
    <message>
        <source>the array does not have this</source>
        <translation>アレイにこれはありません</translation>
    </message>
    <message>
        <source>this is listed twice</source>
        <translation>これが2回あります</translation>
    </message>
    <message>
        <source>least is above greatest</source>
        <translation>leastがgreatestより大きくなっています</translation>
    </message>
</context>
<context>
    <name>RecordedSignalsText</name>
    <message>
        <source>The recording has no &quot;%1&quot;.</source>
        <translation>記録に「%1」がありません。</translation>
    </message>
    <message>
        <source>The reading was stopped.</source>
        <translation>読み込みを中止しました。</translation>
    </message>
</context>
<context>
    <name>RecordedStreamText</name>
    <message>
        <source>the stream &quot;%1&quot; is not described: %2</source>
        <translation>ストリーム「%1」が記述されていません: %2</translation>
    </message>
    <message>
        <source>it is not an array</source>
        <translation>アレイではありません</translation>
    </message>
    <message>
        <source>it is not an arm</source>
        <translation>アームではありません</translation>
    </message>
    <message>
        <source>its links have another number of joints</source>
        <translation>リンクの関節数が異なります</translation>
    </message>
    <message>
        <source>it has a pad and no links</source>
        <translation>触覚アレイはありますがリンクがありません</translation>
    </message>
</context>
<context>
    <name>RecordedStreams</name>
    <message>
        <source>a recording of an array, an arm or a camera</source>
        <translation>アレイ、アーム、またはカメラの記録</translation>
    </message>
    <message>
        <source>the recording has no frames of an array, an arm or a camera</source>
        <translation>記録にアレイ、アーム、カメラのフレームがありません</translation>
    </message>
    <message>
        <source>it is not a picture in colour</source>
        <translation>カラーの画像ではありません</translation>
    </message>
    <message>
        <source>it is no gel with markers</source>
        <translation>マーカー付きのゲルではありません</translation>
    </message>
</context>
<context>
    <name>Recording</name>
    <message>
        <source>the stream &quot;%1&quot; is described by &quot;%2&quot;</source>
        <translation>ストリーム「%1」が「%2」と記述されています</translation>
    </message>
    <message>
        <source>the stream &quot;%1&quot; has %2 columns instead of %3</source>
        <translation>ストリーム「%1」の列数が%3ではなく%2です</translation>
    </message>
    <message>
        <source>a new name</source>
        <translation>新しい名前</translation>
    </message>
    <message>
        <source>the recording cannot be written: %1</source>
        <translation>記録を書き込めません: %1</translation>
    </message>
    <message>
        <source>a recording of this program</source>
        <translation>このプログラムの記録</translation>
    </message>
    <message>
        <source>the recording was made by a newer version of the program (format %1)</source>
        <translation>記録はより新しいバージョンのプログラムで作成されました (形式%1)</translation>
    </message>
    <message>
        <source>format %1 or older</source>
        <translation>形式%1以前</translation>
    </message>
    <message>
        <source>a folder that can be written to: the recording was cut off and has to be completed</source>
        <translation>書き込み可能なフォルダー: 記録が途中で切れており、補完が必要です</translation>
    </message>
    <message>
        <source>the disk is full</source>
        <translation>ディスクがいっぱいです</translation>
    </message>
    <message>
        <source>the recording is damaged: %1</source>
        <translation>記録が破損しています: %1</translation>
    </message>
    <message>
        <source>block %1 of the stream &quot;%2&quot; is incomplete</source>
        <translation>ストリーム「%2」のブロック%1が不完全です</translation>
    </message>
    <message>
        <source>the recording was never started</source>
        <translation>記録が開始されていません</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a time</source>
        <translation>「%1」は時刻ではありません</translation>
    </message>
    <message>
        <source>a file of this name already exists</source>
        <translation>同じ名前のファイルがすでにあります</translation>
    </message>
    <message>
        <source>a writable folder</source>
        <translation>書き込み可能なフォルダー</translation>
    </message>
    <message>
        <source>this is not a recording</source>
        <translation>記録ではありません</translation>
    </message>
    <message>
        <source>this is an SQLite database, but not a recording</source>
        <translation>SQLiteデータベースですが、記録ではありません</translation>
    </message>
    <message>
        <source>its format version is missing</source>
        <translation>形式がありません</translation>
    </message>
</context>
<context>
    <name>RecordingArgumentsText</name>
    <message>
        <source>the loads are in %1, a unit without a usual threshold</source>
        <translation>荷重の単位%1には通常のしきい値がありません</translation>
    </message>
    <message>
        <source>--threshold, from how many %1 a taxel is in contact</source>
        <translation>--threshold (何%1からタクセルを接触とみなすか)</translation>
    </message>
</context>
<context>
    <name>RecordingExport</name>
    <message>
        <source>another folder</source>
        <translation>別のフォルダー</translation>
    </message>
    <message>
        <source>interrupted; nothing was written</source>
        <translation>中断されました。何も書き込まれていません</translation>
    </message>
    <message>
        <source>the folder cannot be created or written to</source>
        <translation>フォルダーを作成できないか、書き込めません</translation>
    </message>
    <message>
        <source>a file of this name already exists</source>
        <translation>同じ名前のファイルがすでにあります</translation>
    </message>
    <message>
        <source>the recording cannot be read</source>
        <translation>記録を読み込めません</translation>
    </message>
</context>
<context>
    <name>RecordingRequest</name>
    <message>
        <source>the recording has no stream &quot;%1&quot; to play</source>
        <translation>記録に再生できるストリーム「%1」がありません</translation>
    </message>
</context>
<context>
    <name>RegisterMapReader</name>
    <message>
        <source>&quot;scale&quot; is 0</source>
        <translation>&quot;scale&quot;が0です</translation>
    </message>
    <message>
        <source>the value of one count</source>
        <translation>1カウントの値</translation>
    </message>
    <message>
        <source>the last register would be beyond 65535</source>
        <translation>最後のレジスターが65535を超えます</translation>
    </message>
    <message>
        <source>an address of at most %1</source>
        <translation>%1以下のアドレス</translation>
    </message>
    <message>
        <source>&quot;%1&quot; does not fit into the register</source>
        <translation>「%1」がレジスターに収まりません</translation>
    </message>
    <message>
        <source>a value that type, scale and offset can express</source>
        <translation>型、scale、offsetで表せる値</translation>
    </message>
    <message>
        <source>&quot;full&quot; and &quot;off&quot; are the same</source>
        <translation>&quot;full&quot;と&quot;off&quot;が同じです</translation>
    </message>
    <message>
        <source>a value at which the motor runs as fast as it can</source>
        <translation>モーターが最高速で回る値</translation>
    </message>
    <message>
        <source>a float has no bits to look at</source>
        <translation>浮動小数点数には参照するビットがありません</translation>
    </message>
    <message>
        <source>one of: %1</source>
        <translation>次のいずれか: %1</translation>
    </message>
    <message>
        <source>there is no input &quot;%1&quot;</source>
        <translation>入力「%1」がありません</translation>
    </message>
    <message>
        <source>the name of an [[input]]</source>
        <translation>[[input]] の名前</translation>
    </message>
    <message>
        <source>the unit of &quot;%1&quot; is &quot;%2&quot;</source>
        <translation>「%1」の単位が「%2」です</translation>
    </message>
    <message>
        <source>an input in %1</source>
        <translation>単位が%1の入力</translation>
    </message>
    <message>
        <source>the name &quot;%1&quot; is used twice</source>
        <translation>名前「%1」が2回使われています</translation>
    </message>
    <message>
        <source>a name of its own for each input</source>
        <translation>入力ごとに固有の名前</translation>
    </message>
    <message>
        <source>the watchdog is a register of a motor</source>
        <translation>ウォッチドッグがモーターのレジスターになっています</translation>
    </message>
    <message>
        <source>a register of its own</source>
        <translation>専用のレジスター</translation>
    </message>
    <message>
        <source>there is no motor to watch</source>
        <translation>監視するモーターがありません</translation>
    </message>
    <message>
        <source>a table [tactors]</source>
        <translation>表 [tactors]</translation>
    </message>
    <message>
        <source>the file names no register</source>
        <translation>ファイルにレジスターの指定がありません</translation>
    </message>
    <message>
        <source>[tactors] or [[input]]</source>
        <translation>[tactors] または [[input]]</translation>
    </message>
    <message>
        <source>no such device comes with the program</source>
        <translation>そのようなデバイスはプログラムに付属していません</translation>
    </message>
    <message>
        <source>&quot;start&quot; is not between &quot;off&quot; and &quot;full&quot;</source>
        <translation>&quot;start&quot;が&quot;off&quot;と&quot;full&quot;の間にありません</translation>
    </message>
    <message>
        <source>the value of the weakest intensity</source>
        <translation>最も弱い強度の値</translation>
    </message>
    <message>
        <source>nothing turns the motors off when the program is killed or the line is cut</source>
        <translation>プログラムの強制終了や回線の切断時にモーターを止めるものがありません</translation>
    </message>
    <message>
        <source>[watchdog] with the address of the driver&apos;s watchdog register, or with by_traffic = true where it turns them off when nothing is written</source>
        <translation>ドライバーのウォッチドッグレジスターのアドレスを持つ [watchdog]、または書き込みがないとドライバーが停止させる場合は by_traffic = true</translation>
    </message>
    <message>
        <source>&quot;answer_timeout_s&quot; is too long for motors: STOP may have to wait for it</source>
        <translation>&quot;answer_timeout_s&quot;がモーターには長すぎます: STOPがその分待たされる可能性があります</translation>
    </message>
    <message>
        <source>at most %1 s</source>
        <translation>%1 s以下</translation>
    </message>
    <message>
        <source>too many joints: %1</source>
        <translation>関節が多すぎます: %1</translation>
    </message>
    <message>
        <source>at most %1, from the base to the tip</source>
        <translation>最大 %1、基部から先端の順</translation>
    </message>
</context>
<context>
    <name>RelayText</name>
    <message>
        <source>no line to the driver can be opened: %1</source>
        <translation>ドライバーへの回線を開けません: %1</translation>
    </message>
</context>
<context>
    <name>RemoteCameraText</name>
    <message>
        <source>the received data are not a complete JPEG picture (%1 bytes)</source>
        <translation>受信したデータは完全なJPEG画像ではありません (%1バイト)</translation>
    </message>
</context>
<context>
    <name>RemoteDeviceText</name>
    <message>
        <source>%1 sends nothing of this device</source>
        <translation>%1 からこの装置のデータが届きません</translation>
    </message>
    <message>
        <source>%1 does not answer</source>
        <translation>%1 が応答しません</translation>
    </message>
</context>
<context>
    <name>RemoteSiteFileText</name>
    <message>
        <source>&quot;%1&quot; cannot be a name</source>
        <translation>「%1」は名前に使えません</translation>
    </message>
    <message>
        <source>a small letter, then at most 30 small letters, digits and _</source>
        <translation>小文字で始まり、小文字、数字、_ が最大 30 文字続くもの</translation>
    </message>
</context>
<context>
    <name>ReplayCommand</name>
    <message numerus="yes">
        <source>%n damaged block(s) left out</source>
        <translation>
            <numerusform>破損した%nブロックを除外</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n frame(s) lost at this speed</source>
        <translation>
            <numerusform>この速度で%nフレーム損失</numerusform>
        </translation>
    </message>
    <message>
        <source>Recording of the console or of teleta simulate</source>
        <translation>コンソールまたはteleta simulateの記録</translation>
    </message>
    <message>
        <source>Times the recorded speed; otherwise as fast as possible</source>
        <translation>記録速度に対する倍率。省略時はできるだけ速く</translation>
    </message>
    <message>
        <source>Load from which a taxel is in contact; otherwise as it was recorded</source>
        <translation>タクセルが接触とみなされる荷重。省略時は記録時の値</translation>
    </message>
    <message numerus="yes">
        <source>%n frame(s) were not printed</source>
        <translation>
            <numerusform>%nフレームは表示されませんでした</numerusform>
        </translation>
    </message>
    <message>
        <source>Play a recording through the processing of a device and print its features, or a camera&apos;s contacts</source>
        <translation>記録をデバイスの処理に通して再生し、特徴量、またはカメラの接触を表示します</translation>
    </message>
    <message>
        <source>Name of the stream of an array or a camera; otherwise the first one</source>
        <translation>アレイまたはカメラのストリームの名前。省略時は最初のもの</translation>
    </message>
    <message>
        <source>the recording has the arrays and cameras %1</source>
        <translation>記録に含まれるアレイとカメラは %1 です</translation>
    </message>
    <message>
        <source>the settings changed during the recording; those of its beginning are used</source>
        <translation>設定は記録中に変更されました。開始時の設定が使われます</translation>
    </message>
    <message>
        <source>this is for arrays, but the stream &quot;%1&quot; is a camera&apos;s</source>
        <translation>アレイ用のオプションですが、ストリーム「%1」はカメラのものです</translation>
    </message>
    <message>
        <source>frames of an array or a camera</source>
        <translation>アレイまたはカメラのフレーム</translation>
    </message>
    <message>
        <source>The gel at rest could not be found, so there are no contacts. %1</source>
        <translation>静止時のゲルが見つからないため、接触はありません。%1</translation>
    </message>
    <message>
        <source>%1 of %2 frames could not be used. The last reason: %3</source>
        <translation>%2フレーム中%1フレームは使えませんでした。最後の理由：%3</translation>
    </message>
    <message>
        <source>the recording has joints of an arm or pictures to look at, and nothing that is computed from them</source>
        <translation>記録にあるのはアームの関節か見るだけの画像で、そこから計算するものはありません</translation>
    </message>
</context>
<context>
    <name>ReplayDevice</name>
    <message>
        <source>only a file can be played, not a pipe</source>
        <translation>再生できるのはファイルだけです (パイプは不可)</translation>
    </message>
    <message>
        <source>the recording has no frames</source>
        <translation>記録にフレームがありません</translation>
    </message>
</context>
<context>
    <name>ReportText</name>
    <message>
        <source>en</source>
        <comment>language of the report, as BCP 47 has it</comment>
        <translation>ja</translation>
    </message>
    <message>
        <source>Data: %1. TeleTA Console %2.</source>
        <translation>データ: %1。TeleTA Console %2。</translation>
    </message>
    <message>
        <source>Compute it again</source>
        <translation>再計算</translation>
    </message>
    <message>
        <source>There are no test trials.</source>
        <translation>テスト試行がありません。</translation>
    </message>
    <message>
        <source>Correct answers of the group; the interval is that of Student&apos;s t over participants (95 %)</source>
        <translation>グループの正答。区間は参加者にわたるStudentのtによるものです (95 %)</translation>
    </message>
    <message>
        <source>Condition</source>
        <translation>条件</translation>
    </message>
    <message>
        <source>Participants</source>
        <translation>参加者数</translation>
    </message>
    <message>
        <source>Mean, %</source>
        <translation>平均、%</translation>
    </message>
    <message>
        <source>SD, %</source>
        <translation>SD、%</translation>
    </message>
    <message>
        <source>Interval, %</source>
        <translation>区間、%</translation>
    </message>
    <message>
        <source>Correct answers</source>
        <translation>正答</translation>
    </message>
    <message>
        <source>Dots: participants. Marks: mean with the t interval over participants.</source>
        <translation>点: 参加者。マーク: 平均と参加者にわたるt区間。</translation>
    </message>
    <message>
        <source>Rows: presented; columns: answered. Percent of the row, all participants.</source>
        <translation>行: 提示。列: 回答。行に対する割合 (%)、全参加者。</translation>
    </message>
    <message>
        <source>Presented</source>
        <translation>提示</translation>
    </message>
    <message>
        <source>Trials</source>
        <translation>試行数</translation>
    </message>
    <message>
        <source>%1: trials and share of the row in percent</source>
        <translation>%1: 試行数と行に対する割合 (%)</translation>
    </message>
    <message>
        <source>Confusion matrices</source>
        <translation>混同行列</translation>
    </message>
    <message>
        <source>Pattern</source>
        <translation>パターン</translation>
    </message>
    <message>
        <source>%1, %</source>
        <translation>%1、%</translation>
    </message>
    <message>
        <source>df</source>
        <translation>df</translation>
    </message>
    <message>
        <source>Patterns and conditions</source>
        <translation>パターンと条件</translation>
    </message>
    <message>
        <source>Mean of the participants with the t interval (95 %).</source>
        <translation>参加者の平均とt区間 (95 %)。</translation>
    </message>
    <message>
        <source>Participants&apos; median response times of correct, answered test trials, from the onset of the stimulus</source>
        <translation>回答のあったテスト試行のうち正答の、参加者ごとの応答時間の中央値 (刺激の開始から)</translation>
    </message>
    <message>
        <source>Median of the medians, s</source>
        <translation>中央値の中央値、s</translation>
    </message>
    <message>
        <source>Shortest, s</source>
        <translation>最短、s</translation>
    </message>
    <message>
        <source>Longest, s</source>
        <translation>最長、s</translation>
    </message>
    <message>
        <source>Response times</source>
        <translation>応答時間</translation>
    </message>
    <message>
        <source>Dots: medians of participants. Marks: the median of these.</source>
        <translation>点: 参加者の中央値。マーク: それらの中央値。</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>測定値</translation>
    </message>
    <message>
        <source>Bias</source>
        <translation>バイアス</translation>
    </message>
    <message>
        <source>Corrected</source>
        <translation>補正値</translation>
    </message>
    <message>
        <source>Interval</source>
        <translation>区間</translation>
    </message>
    <message>
        <source>A guesser would show</source>
        <translation>当て推量での値</translation>
    </message>
    <message>
        <source>Remark</source>
        <translation>備考</translation>
    </message>
    <message>
        <source>few trials: fewer than 5 k²</source>
        <translation>試行数不足: 5 k²未満</translation>
    </message>
    <message>
        <source>Information transfer</source>
        <translation>情報伝達量</translation>
    </message>
    <message>
        <source>The measured value is too high with few trials: even a participant who only guesses shows more than 0 bit. Compare it with the column of the guesser, and use the corrected value with care.</source>
        <translation>試行数が少ないと測定値は過大になります: 当て推量だけの参加者でも0 bitを超えます。当て推量の列と比較し、補正値は慎重に扱ってください。</translation>
    </message>
    <message>
        <source>Each participant, test trials; intervals of 95 %, p of so many correct answers by chance</source>
        <translation>各参加者のテスト試行。95 %区間と、偶然にこの正答数となるp</translation>
    </message>
    <message>
        <source>Participant</source>
        <translation>参加者</translation>
    </message>
    <message>
        <source>Correct</source>
        <translation>正答</translation>
    </message>
    <message>
        <source>No answer</source>
        <translation>無回答</translation>
    </message>
    <message>
        <source>Accuracy, %</source>
        <translation>正答率、%</translation>
    </message>
    <message>
        <source>Wilson, %</source>
        <translation>Wilson、%</translation>
    </message>
    <message>
        <source>Clopper-Pearson, %</source>
        <translation>Clopper-Pearson、%</translation>
    </message>
    <message>
        <source>p of chance</source>
        <translation>偶然のp</translation>
    </message>
    <message>
        <source>Transfer, bit</source>
        <translation>伝達量、bit</translation>
    </message>
    <message>
        <source>Guesser, bit</source>
        <translation>当て推量、bit</translation>
    </message>
    <message>
        <source>Corrected, bit</source>
        <translation>補正値、bit</translation>
    </message>
    <message>
        <source>Median time, s</source>
        <translation>時間の中央値、s</translation>
    </message>
    <message>
        <source>Times</source>
        <translation>時間の数</translation>
    </message>
    <message>
        <source>Analysis of variance within participants of the shares of correct answers; p with the corrections of Greenhouse and Geisser and of Huynh and Feldt</source>
        <translation>正答率の参加者内分散分析。pはGreenhouse-GeisserおよびHuynh-Feldtの補正付き</translation>
    </message>
    <message>
        <source>Effect</source>
        <translation>効果</translation>
    </message>
    <message>
        <source>partial η²</source>
        <translation>偏η²</translation>
    </message>
    <message>
        <source>generalised η²</source>
        <translation>一般化η²</translation>
    </message>
    <message>
        <source>%1 is left out: a cell is missing</source>
        <translation>%1 は除外: セルが欠けています</translation>
    </message>
    <message>
        <source>Analysis of variance</source>
        <translation>分散分析</translation>
    </message>
    <message numerus="yes">
        <source>Stimuli: %n trial(s) were played on a bracelet; the longest write of a frame took %1 ms.</source>
        <translation>
            <numerusform>刺激: %n 試行がブレスレットで再生されました。フレームの書き込みは最長 %1 msでした。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Stimuli: the frames of %n trial(s) were counted.</source>
        <translation>
            <numerusform>刺激: %n 試行のフレームを数えました。</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 Frames were missed in %2 of them, %3 in all.</source>
        <comment>the sentence before, numbers</comment>
        <translation>%1%2 試行でフレームが欠け、合計は %3 です。</translation>
    </message>
    <message>
        <source>PILOT: these data were taken to try the study out.</source>
        <translation>パイロット: これらのデータは実験を試すために取得されました。</translation>
    </message>
    <message>
        <source>SIMULATED: these answers were made by a program, not by people.</source>
        <translation>シミュレーション: これらの回答は人ではなくプログラムによるものです。</translation>
    </message>
    <message>
        <source>at least %1</source>
        <translation>%1以上</translation>
    </message>
    <message>
        <source>at most %1</source>
        <translation>%1以下</translation>
    </message>
    <message>
        <source>Information transfer of the pooled answers in bit. Corrected: without bias, by the jackknife over participants. Interval: of the true transfer (95 %)</source>
        <translation>プールした回答の情報伝達量 (bit)。補正値: 参加者にわたるジャックナイフでバイアスを除いた値。区間: 真の情報伝達量の区間 (95 %)</translation>
    </message>
    <message>
        <source>Filled: measured. Hollow: less the bias, with the interval of the true transfer.</source>
        <translation>塗りつぶし: 測定値。中空: バイアスを引いた値と、真の情報伝達量の区間。</translation>
    </message>
    <message>
        <source>analysis.R beside this page computes its numbers again from confusion_long.csv, except the response times, which that file does not have: Rscript analysis.R. In the folder of the study it computes the response times too, from the exported trials.</source>
        <translation>このページと同じ場所にあるanalysis.Rで、このページの数値をconfusion_long.csvから再計算できます (このファイルにない反応時間を除く): Rscript analysis.R。スタディのフォルダーでは、エクスポートされた試行から反応時間も計算します。</translation>
    </message>
    <message>
        <source>all participants have the same share</source>
        <translation>全参加者の割合が同じです</translation>
    </message>
    <message>
        <source>the interval is cut off at 0 or 100 %</source>
        <translation>区間は0または100 %で打ち切られています</translation>
    </message>
    <message>
        <source>p, Holm</source>
        <translation>p、Holm</translation>
    </message>
    <message>
        <source>Mean of the participants&apos; correct answers for each pattern; two conditions are compared within participants; Holm: corrected over the patterns</source>
        <translation>パターンごとの、各参加者の正答の平均。2つの条件は参加者内で比較します。Holm: パターンにわたって補正</translation>
    </message>
</context>
<context>
    <name>ResidualPicture</name>
    <message>
        <source>Image: no pairs yet</source>
        <translation>画像: ペアはまだありません</translation>
    </message>
    <message>
        <source>Unrolled cylinder: no pairs yet</source>
        <translation>展開した円筒: ペアはまだありません</translation>
    </message>
    <message>
        <source>Image: from the pixel to where the camera projects its point</source>
        <translation>画像: 画素から、カメラが点を投影する位置まで</translation>
    </message>
    <message>
        <source>Unrolled cylinder: from the point to where its pixel is located</source>
        <translation>展開した円筒: 点から、その画素の推定位置まで</translation>
    </message>
    <message>
        <source>u to the right, v down, px</source>
        <translation>uは右向き、vは下向き、px</translation>
    </message>
    <message>
        <source>angle, degrees; z upwards, mm</source>
        <translation>角度 (度)、zは上向き、mm</translation>
    </message>
    <message>
        <source>x: wrong pair   o: excluded   dashed: valid radius</source>
        <translation>x: 誤ったペア   o: 除外   破線: 有効半径</translation>
    </message>
    <message>
        <source>along z −%1</source>
        <translation>z方向 −%1</translation>
    </message>
    <message>
        <source>+%1 mm</source>
        <translation>+%1 mm</translation>
    </message>
    <message>
        <source>arrows enlarged %1 times</source>
        <translation>矢印は%1倍</translation>
    </message>
</context>
<context>
    <name>RestText</name>
    <message>
        <source>The frames do not show the value of taxel %1 without load: it is touched in nearly all of them, or nothing touches the array</source>
        <translation>フレームからはタクセル %1 の無負荷の値がわかりません。ほぼすべてで触れられているか、アレイに何も触れていません</translation>
    </message>
    <message>
        <source>frames of the unloaded array, their median, or a dead taxel</source>
        <translation>無負荷のアレイのフレーム、その中央値、または死んだタクセルの指定</translation>
    </message>
</context>
<context>
    <name>ResultsContent</name>
    <message>
        <source>all participants</source>
        <translation>全参加者</translation>
    </message>
    <message>
        <source>Right answers, 95 % Wilson interval</source>
        <translation>正答、95 % Wilson区間</translation>
    </message>
    <message>
        <source>Right answers, mean of participants, 95 % t interval</source>
        <translation>正答、参加者の平均、95 % t区間</translation>
    </message>
    <message>
        <source>right, %</source>
        <translation>正答、%</translation>
    </message>
    <message>
        <source>chance</source>
        <translation>チャンスレベル</translation>
    </message>
    <message>
        <source>test</source>
        <translation>テスト</translation>
    </message>
    <message>
        <source>Each pattern: %1</source>
        <comment>conditions</comment>
        <translation>パターン別: %1</translation>
    </message>
    <message>
        <source> against </source>
        <translation> 対 </translation>
    </message>
    <message>
        <source>Each pattern</source>
        <translation>パターン別</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <comment>condition, participant</comment>
        <translation>%1、%2</translation>
    </message>
    <message>
        <source>Median response time</source>
        <translation>応答時間の中央値</translation>
    </message>
    <message>
        <source>Median response times, 95 % t interval</source>
        <translation>応答時間の中央値、95 % t区間</translation>
    </message>
    <message>
        <source>s from the onset</source>
        <translation>開始からの時間、s</translation>
    </message>
    <message>
        <source>right answers of the test</source>
        <translation>テストの正答</translation>
    </message>
    <message>
        <source>Condition</source>
        <translation>条件</translation>
    </message>
    <message>
        <source>Participants</source>
        <translation>参加者数</translation>
    </message>
    <message>
        <source>Right %</source>
        <translation>正答 %</translation>
    </message>
    <message>
        <source>SD</source>
        <translation>SD</translation>
    </message>
    <message>
        <source>95 % t interval</source>
        <translation>95 % t区間</translation>
    </message>
    <message>
        <source>Trials</source>
        <translation>試行数</translation>
    </message>
    <message>
        <source>IT bit</source>
        <translation>IT bit</translation>
    </message>
    <message>
        <source>Bias bit</source>
        <translation>バイアス bit</translation>
    </message>
    <message>
        <source>IT corrected</source>
        <translation>補正IT</translation>
    </message>
    <message>
        <source>Mean of the participants&apos; shares of right answers</source>
        <translation>各参加者の正答率の平均</translation>
    </message>
    <message>
        <source>Standard deviation between participants</source>
        <translation>参加者間の標準偏差</translation>
    </message>
    <message>
        <source>Of the mean, from Student&apos;s t over participants</source>
        <translation>平均の区間。参加者にわたるStudentのtによる</translation>
    </message>
    <message>
        <source>Of all participants together</source>
        <translation>全参加者の合計</translation>
    </message>
    <message>
        <source>Information transfer of the pooled matrix, as counted</source>
        <translation>プールした行列の情報伝達量 (計数のまま)</translation>
    </message>
    <message>
        <source>Measured less bias</source>
        <translation>測定値からバイアスを引いた値</translation>
    </message>
    <message>
        <source>Participant</source>
        <translation>参加者</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>正答</translation>
    </message>
    <message>
        <source>No answer</source>
        <translation>無回答</translation>
    </message>
    <message>
        <source>Wilson 95 %</source>
        <translation>Wilson 95 %</translation>
    </message>
    <message>
        <source>Clopper-Pearson 95 %</source>
        <translation>Clopper-Pearson 95 %</translation>
    </message>
    <message>
        <source>p by chance</source>
        <translation>偶然のp</translation>
    </message>
    <message>
        <source>Median s</source>
        <translation>中央値 s</translation>
    </message>
    <message>
        <source>of n</source>
        <translation>対象n</translation>
    </message>
    <message>
        <source>In time</source>
        <translation>時間内</translation>
    </message>
    <message>
        <source>Probability of so many right answers, or more, by guessing</source>
        <translation>当て推量でこれ以上の正答数となる確率</translation>
    </message>
    <message>
        <source>Information transfer as counted</source>
        <translation>情報伝達量 (計数のまま)</translation>
    </message>
    <message>
        <source>Response time of right answers</source>
        <translation>正答の応答時間</translation>
    </message>
    <message>
        <source>Effect</source>
        <translation>効果</translation>
    </message>
    <message>
        <source>Pattern</source>
        <translation>パターン</translation>
    </message>
    <message>
        <source>df</source>
        <translation>df</translation>
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
        <translation>偏eta²</translation>
    </message>
    <message>
        <source>gen. eta²</source>
        <translation>一般化eta²</translation>
    </message>
    <message>
        <source>n</source>
        <translation>n</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>注記</translation>
    </message>
    <message>
        <source>A comparison of the conditions for this pattern alone</source>
        <translation>このパターンのみでの条件の比較</translation>
    </message>
    <message>
        <source>Greenhouse and Geisser</source>
        <translation>Greenhouse-Geisser</translation>
    </message>
    <message>
        <source>Huynh and Feldt, at most 1</source>
        <translation>Huynh-Feldt、最大1</translation>
    </message>
    <message>
        <source>Generalised eta squared</source>
        <translation>一般化eta二乗</translation>
    </message>
    <message>
        <source>without %1</source>
        <translation>%1 を除く</translation>
    </message>
    <message>
        <source>With fewer than 5 k² trials even the corrected value is rough.</source>
        <translation>試行数が5 k²未満の場合は、補正値もおおまかな値です。</translation>
    </message>
    <message>
        <source>Within participants, condition × pattern, of the shares of right answers; below, the conditions compared for each pattern.</source>
        <translation>正答率の参加者内分析、条件 × パターン。その下に、各パターンでの条件の比較を示します。</translation>
    </message>
    <message>
        <source>Average overestimate</source>
        <translation>平均的な過大評価量</translation>
    </message>
    <message>
        <source>Participants with complete data</source>
        <translation>データがそろっている参加者</translation>
    </message>
    <message>
        <source>Few trials give too high an information transfer: with %1 trials, guessing alone shows %2 bit on average. Use the corrected value next to it.</source>
        <translation>試行数が少ないと情報伝達量は過大になります: %1試行では、当て推量だけの人でも平均%2 bitになります。隣の補正値を参照してください。</translation>
    </message>
    <message>
        <source>There is only one condition, so the patterns are compared.</source>
        <translation>条件が1つしかないため、パターンを比較します。</translation>
    </message>
    <message>
        <source>IT 95 %</source>
        <translation>IT 95 %</translation>
    </message>
    <message>
        <source>Remark</source>
        <translation>備考</translation>
    </message>
    <message>
        <source>Average overestimate, from the jackknife over participants</source>
        <translation>平均的な過大評価量 (参加者にわたるジャックナイフによる)</translation>
    </message>
    <message>
        <source>Interval or bound of the true transfer, from the jackknife over participants</source>
        <translation>真の情報伝達量の区間または限界 (参加者にわたるジャックナイフによる)</translation>
    </message>
    <message>
        <source>the t interval is cut off at 0 or 100 %</source>
        <translation>t区間は0または100 %で打ち切られています</translation>
    </message>
    <message>
        <source>all participants have the same share</source>
        <translation>全参加者の割合が同じです</translation>
    </message>
    <message>
        <source>p %1</source>
        <translation>p %1</translation>
    </message>
    <message>
        <source>%1; Holm %2</source>
        <comment>p of a pattern, corrected p</comment>
        <translation>%1、Holm %2</translation>
    </message>
</context>
<context>
    <name>RobotShape</name>
    <message>
        <source>the shapes of the arm have more than %1 triangles</source>
        <translation>アームの形状の三角形が%1個を超えています</translation>
    </message>
</context>
<context>
    <name>RosArm</name>
    <message>
        <source>the arm cannot be moved: %1</source>
        <translation>アームを動かせません: %1</translation>
    </message>
    <message>
        <source>%1 does not report: %2</source>
        <translation>%1 に次の情報がありません: %2</translation>
    </message>
    <message>
        <source>%1 reports no effort, so effort_stop cannot work</source>
        <translation>%1 にトルク・力の情報がないため、effort_stopでアームを保持できません</translation>
    </message>
    <message>
        <source>no controller reads %1</source>
        <translation>%1 を受信するコントローラーがありません</translation>
    </message>
    <message>
        <source>looking for other programs</source>
        <translation>ほかのプログラムを探しています</translation>
    </message>
    <message>
        <source>it was held; let go of the switch and press it again</source>
        <translation>アームは保持されました。スイッチを離してもう一度押してください</translation>
    </message>
    <message>
        <source>%1 reports no force, so force_stop_N cannot work</source>
        <translation>%1が力を伝えないため、force_stop_Nは働きません</translation>
    </message>
    <message>
        <source>%1, which the arm requires, is not live</source>
        <translation>アームに必須の%1がライブではありません</translation>
    </message>
    <message>
        <source>the stamps of %1 are %2 s behind this computer, MoveIt Servo takes %3 to %4</source>
        <translation>%1のスタンプはこのコンピューターより%2 s遅れています。MoveIt Servoが受け付けるのは%3から%4です</translation>
    </message>
    <message>
        <source>%1 reports a force in the frame %2, which neither the description nor /tf_static nor /tf (within the last second) has</source>
        <translation>%1は座標系%2で力を報告していますが、記述にも/tf_staticにも、直近1秒の/tfにもありません</translation>
    </message>
</context>
<context>
    <name>RosArmCheck</name>
    <message>
        <source>nobody publishes %1</source>
        <translation>%1 を送信するものがありません</translation>
    </message>
    <message>
        <source>nothing was sent on %1</source>
        <translation>%1 へ何も送信されませんでした</translation>
    </message>
    <message>
        <source>%1 does not report: %2</source>
        <translation>%1 に次の情報がありません: %2</translation>
    </message>
    <message>
        <source>%1 reports all %2 joints</source>
        <translation>%1 に%2個の関節すべての情報があります</translation>
    </message>
    <message>
        <source>%1 publishers of %2</source>
        <translation>%2 の送信側が%1個あります</translation>
    </message>
    <message>
        <source>%1 reports %2, which the arm does not have</source>
        <translation>%1 にある%2がアームにありません</translation>
    </message>
    <message>
        <source>%1 messages were inconsistent and were ignored</source>
        <translation>内容が矛盾するメッセージ%1件を除外しました</translation>
    </message>
    <message>
        <source>%1 samples a second, longest gap %2 s</source>
        <translation>毎秒%1サンプル、最長の間隔 %2 s</translation>
    </message>
    <message>
        <source>; joint_timeout_s is %1</source>
        <translation>。joint_timeout_sは%1です</translation>
    </message>
    <message>
        <source>reported, in %1 according to the file</source>
        <translation>情報あり。ファイルの記載どおり単位は%1です</translation>
    </message>
    <message>
        <source>not reported, so effort_stop cannot work</source>
        <translation>情報がないため、effort_stopでアームを保持できません</translation>
    </message>
    <message>
        <source>not reported</source>
        <translation>情報なし</translation>
    </message>
    <message>
        <source>%1 stamps are zero</source>
        <translation>%1個のタイムスタンプがゼロです</translation>
    </message>
    <message>
        <source>stamps are %1 s behind this computer</source>
        <translation>タイムスタンプはこのコンピューターより%1 s遅れています</translation>
    </message>
    <message>
        <source>someone else commands %1</source>
        <translation>ほかのプログラムが %1 に指令を送っています</translation>
    </message>
    <message>
        <source>%1 has the type %2</source>
        <translation>%1 の型は%2です</translation>
    </message>
    <message>
        <source>reads %1</source>
        <translation>%1 を受信しています</translation>
    </message>
    <message>
        <source>cannot be reached: %1</source>
        <translation>到達できません: %1</translation>
    </message>
    <message>
        <source>nobody reads %1</source>
        <translation>%1 を受信するものがありません</translation>
    </message>
    <message>
        <source>; found: %1</source>
        <translation>。存在するもの: %1</translation>
    </message>
    <message>
        <source>the check was interrupted</source>
        <translation>確認は途中で中断されました</translation>
    </message>
    <message>
        <source>%1 reports no force</source>
        <translation>%1は力を伝えていません</translation>
    </message>
    <message>
        <source>%1 messages a second, longest gap %2 s, at most %3 N</source>
        <translation>毎秒%1メッセージ、最長の間隔%2 s、最大%3 N</translation>
    </message>
    <message>
        <source>; timeout_s is %1</source>
        <translation>; timeout_sは%1です</translation>
    </message>
    <message>
        <source>; force_stop_N is %1</source>
        <translation>; force_stop_Nは%1です</translation>
    </message>
    <message>
        <source>UNGUARDED: %1 keeps its last command when this program ends or the network fails</source>
        <translation>保護なし: このプログラムが終了するかネットワークが故障しても、%1は最後の指令を保ちます</translation>
    </message>
    <message>
        <source>/tf does not lead from %1 to %2</source>
        <translation>/tfでは%1から%2までつながりません</translation>
    </message>
    <message>
        <source>/tf has no pose of the time of a joint sample</source>
        <translation>/tfには関節のサンプルと同じ時刻の姿勢がありません</translation>
    </message>
    <message>
        <source>%1 mm and %2° off at most</source>
        <translation>ずれは最大%1 mm、%2°</translation>
    </message>
    <message>
        <source>the tip is where /tf has it: %1</source>
        <translation>先端は/tfが示す位置にあります：%1</translation>
    </message>
    <message>
        <source>the tip is not where /tf has it: %1</source>
        <translation>先端は/tfが示す位置にありません：%1</translation>
    </message>
    <message>
        <source>; the description is another robot&apos;s, or a joint has another zero</source>
        <translation>。別のロボットの記述であるか、関節の零点が違います</translation>
    </message>
    <message>
        <source>%1 reports a force in the frame %2, which neither the description nor /tf_static nor /tf (within the last second) has</source>
        <translation>%1は座標系%2で力を報告していますが、記述にも/tf_staticにも、直近1秒の/tfにもありません</translation>
    </message>
</context>
<context>
    <name>RosArmCheckReport</name>
    <message numerus="yes">
        <source>the arm cannot be moved: %n problem(s)</source>
        <translation>
            <numerusform>アームを動かせません: 問題%n件</numerusform>
        </translation>
    </message>
    <message>
        <source>on %1, pressed by %2</source>
        <translation>%1上、%2が押します</translation>
    </message>
    <message>
        <source>on %1; touches have a place, but no force and no stiffness, since the arm&apos;s efforts are not in Nm</source>
        <translation>%1上。アームのエフォートがNmでないため、接触の位置は分かりますが、力と剛性は求められません</translation>
    </message>
</context>
<context>
    <name>RosArmFault</name>
    <message>
        <source>someone else commands %1</source>
        <translation>ほかのプログラムが %1 に指令を送っています</translation>
    </message>
    <message>
        <source>%1 reports a position that is not a number</source>
        <translation>%1 の位置が数値ではありません</translation>
    </message>
    <message>
        <source>the position of %1 jumped</source>
        <translation>%1の位置が飛びました</translation>
    </message>
    <message>
        <source>the stamps of %1 went back</source>
        <translation>%1 のタイムスタンプが戻りました</translation>
    </message>
    <message>
        <source>the arm does not follow its commands</source>
        <translation>アームが指令に追従していません</translation>
    </message>
    <message>
        <source>%1 fell silent</source>
        <translation>%1が途絶えました</translation>
    </message>
</context>
<context>
    <name>RosArmFile</name>
    <message>
        <source>two joints have the ROS name &quot;%1&quot;</source>
        <translation>通信上の名前が「%1」の関節が2つあります</translation>
    </message>
    <message>
        <source>a unique name for each joint</source>
        <translation>関節ごとに固有の名前</translation>
    </message>
    <message>
        <source>a side of the box is empty or reversed</source>
        <translation>箱の辺に長さがありません</translation>
    </message>
    <message>
        <source>[lowest, highest] for x, y and z</source>
        <translation>x、y、zそれぞれの [最小, 最大]</translation>
    </message>
    <message>
        <source>STOP would brake more gently than letting go</source>
        <translation>STOPの減速が、手を離したときより弱くなります</translation>
    </message>
    <message>
        <source>at least deceleration_radPerS2, %1</source>
        <translation>deceleration_radPerS2以上、つまり%1以上</translation>
    </message>
    <message>
        <source>the efforts of this arm are not in Nm</source>
        <translation>このアームのトルク・力の単位がNmではありません</translation>
    </message>
    <message>
        <source>the file of a force sensor, kind = &quot;ros_wrench&quot;</source>
        <translation>力センサーのファイル（kind = &quot;ros_wrench&quot;）</translation>
    </message>
    <message>
        <source>another adapter, or unguarded = true</source>
        <translation>別のアダプター、または unguarded = true</translation>
    </message>
    <message>
        <source>with this adapter the robot stops by itself, so it is not unguarded</source>
        <translation>このアダプターではロボットが自分で止まるので、保護なしではありません</translation>
    </message>
    <message>
        <source>with this adapter nothing stops the robot when this program ends or the network fails</source>
        <translation>このアダプターでは、このプログラムが終了するかネットワークが故障したとき、ロボットを止めるものがありません</translation>
    </message>
    <message>
        <source>the window is empty or reversed</source>
        <translation>範囲が空か、逆になっています</translation>
    </message>
    <message>
        <source>[lowest, highest]</source>
        <translation>[下限, 上限]</translation>
    </message>
    <message>
        <source>the pad is not named</source>
        <translation>触覚アレイが指定されていません</translation>
    </message>
    <message>
        <source>array = &quot;the file of the pad&quot;</source>
        <translation>array = &quot;アレイのファイル&quot;</translation>
    </message>
</context>
<context>
    <name>RosArray</name>
    <message>
        <source>%1 has no sensor named &quot;%2&quot;</source>
        <translation>%1に「%2」という名前のセンサーはありません</translation>
    </message>
</context>
<context>
    <name>RosArrayFile</name>
    <message>
        <source>only a TactileState has sensors with names</source>
        <translation>名前のあるセンサーを持つのはTactileStateだけです</translation>
    </message>
    <message>
        <source>with a factor of 0 every value is the same</source>
        <translation>係数が0では、すべての値が同じになります</translation>
    </message>
    <message>
        <source>another number</source>
        <translation>別の数</translation>
    </message>
    <message>
        <source>without a threshold it is not known which taxels are touched</source>
        <translation>しきい値がないと、どのタクセルが触れられているか分かりません</translation>
    </message>
    <message>
        <source>threshold = a number in the unit of the values, above the first table</source>
        <translation>threshold = 値の単位での数 (最初の表より前)</translation>
    </message>
</context>
<context>
    <name>RosCameraMessage</name>
    <message>
        <source>a picture has the encoding &quot;%1&quot;</source>
        <translation>画像の符号化は「%1」です</translation>
    </message>
    <message>
        <source>a picture has no pixels (%1)</source>
        <translation>画像に画素がありません (%1)</translation>
    </message>
    <message>
        <source>a picture is too large (%1)</source>
        <translation>画像が大きすぎます (%1)</translation>
    </message>
    <message>
        <source>at most %1 pixels</source>
        <translation>%1画素まで</translation>
    </message>
    <message>
        <source>a picture in %1 has an odd width (%2)</source>
        <translation>%1の画像の幅が奇数です (%2)</translation>
    </message>
    <message>
        <source>a row of a picture has %1 bytes, its %2 pixels need %3</source>
        <translation>画像の1行は%1バイトですが、%2画素には%3バイトが必要です</translation>
    </message>
    <message>
        <source>a picture has %1 bytes, its size says %2</source>
        <translation>画像は%1バイトですが、その大きさによれば%2です</translation>
    </message>
    <message>
        <source>a picture is no JPEG or PNG, or too large (%1 bytes)</source>
        <translation>画像がJPEGでもPNGでもないか、大きすぎます (%1バイト)</translation>
    </message>
    <message>
        <source>JPEG or PNG of at most %1 pixels</source>
        <translation>%1画素までのJPEGまたはPNG</translation>
    </message>
    <message>
        <source>a picture is damaged (%1 bytes)</source>
        <translation>画像が壊れています (%1バイト)</translation>
    </message>
</context>
<context>
    <name>RosCommand</name>
    <message>
        <source>List topics and who publishes and reads them</source>
        <translation>トピックと、その送信側・受信側を一覧表示</translation>
    </message>
    <message>
        <source>List the nodes of programs</source>
        <translation>プログラムのノードを一覧表示</translation>
    </message>
    <message>
        <source>Print what is sent on a topic, until Ctrl-C</source>
        <translation>Ctrl-Cまで、トピックに送られるデータを表示</translation>
    </message>
    <message>
        <source>Name of the topic, for example /joint_states</source>
        <translation>トピックの名前。例: /joint_states</translation>
    </message>
    <message>
        <source>End after so many messages</source>
        <translation>この数のメッセージで終了</translation>
    </message>
    <message>
        <source>Number of the domain; default: ROS_DOMAIN_ID of the environment, else 0</source>
        <translation>ドメインの番号。既定: 環境変数ROS_DOMAIN_ID、なければ0</translation>
    </message>
    <message>
        <source>Network interface, its name or its address; default: the first one</source>
        <translation>ネットワークインターフェースの名前またはアドレス。既定: 最初のもの</translation>
    </message>
    <message>
        <source>Computer on which to look for programs besides this one; may be repeated. Multicast is not used</source>
        <translation>このコンピューターのほかにプログラムを探すコンピューター。複数指定できます。マルチキャストは使いません</translation>
    </message>
    <message>
        <source>this computer</source>
        <translation>このコンピューター</translation>
    </message>
    <message>
        <source>no program of domain %1 was found on: %2. Name the robot&apos;s computer with --peer, since multicast is not used.</source>
        <translation>ドメイン %1 のプログラムが見つかりません: %2。マルチキャストを使わないので、ロボットのコンピューターを--peerで指定してください。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no name of a topic; expected parts of letters, digits and _ after slashes, for example /joint_states</source>
        <translation>「%1」はトピックの名前ではありません。/の後に英字・数字・_からなる部分が必要です。例: /joint_states</translation>
    </message>
    <message>
        <source>nobody published %1 in domain %2 within %3 s; looked for on: %4</source>
        <translation>ドメイン %2 で%3 s以内に %1 を送信するものがありませんでした。探した場所: %4</translation>
    </message>
    <message>
        <source>%1 has the type %2, which is not known</source>
        <translation>%1 の型 %2 は未知です</translation>
    </message>
    <message>
        <source>nothing was sent on %1 within %2 s</source>
        <translation>%2 s以内に %1 へ何も送信されませんでした</translation>
    </message>
    <message>
        <source>Topics and nodes of ROS 2, without ROS</source>
        <translation>ROSなしでROS 2のトピックとノードを表示</translation>
    </message>
    <message>
        <source>Watch an arm for 5 s and report what prevents moving it</source>
        <translation>アームを5 s監視し、動かすのを妨げているものを示します</translation>
    </message>
    <message>
        <source>File that describes the arm (kind = &quot;ros_arm&quot;)</source>
        <translation>アームを記述したファイル (kind = &quot;ros_arm&quot;)</translation>
    </message>
</context>
<context>
    <name>RosProbeText</name>
    <message>
        <source>nothing came on the topic</source>
        <translation>トピックに何も届きませんでした</translation>
    </message>
</context>
<context>
    <name>RosWrenchFile</name>
    <message>
        <source>a sign of 0 hides every force</source>
        <translation>符号0ではすべての力が隠れます</translation>
    </message>
    <message>
        <source>1: it reports what acts on the arm; -1: what the arm exerts</source>
        <translation>1: アームに働く力を伝える; -1: アームが及ぼす力を伝える</translation>
    </message>
</context>
<context>
    <name>RunSheet</name>
    <message>
        <source>point</source>
        <translation>点</translation>
    </message>
    <message>
        <source>edge</source>
        <translation>エッジ</translation>
    </message>
</context>
<context>
    <name>RunText</name>
    <message>
        <source>STOP ended the measurement.</source>
        <translation>STOPにより測定が終了しました。</translation>
    </message>
    <message>
        <source>release STOP and measure again</source>
        <translation>STOPを解除して再測定</translation>
    </message>
    <message>
        <source>The bracelet was lost during the measurement.</source>
        <translation>測定中にブレスレットとの接続が切れました。</translation>
    </message>
    <message>
        <source>connect it and measure again</source>
        <translation>接続して再測定</translation>
    </message>
    <message>
        <source>Something else was played meanwhile.</source>
        <translation>その間にほかのものが再生されました。</translation>
    </message>
    <message>
        <source>measure again</source>
        <translation>再測定</translation>
    </message>
    <message>
        <source>The bracelet is too hot to be measured.</source>
        <translation>ブレスレットが熱すぎるため測定できません。</translation>
    </message>
    <message>
        <source>let it cool down and measure again</source>
        <translation>冷ましてから再測定</translation>
    </message>
    <message>
        <source>The bracelet does not measure its motors.</source>
        <translation>このブレスレットは自身のモーターを測定しません。</translation>
    </message>
    <message>
        <source>a recording with a sensor of your own, or answers of a person</source>
        <translation>ご自身のセンサーによる記録、または人の回答</translation>
    </message>
    <message>
        <source>The measurement was ended.</source>
        <translation>測定が終了されました。</translation>
    </message>
    <message>
        <source>The computer was too slow for the measurement: the bracelet paused in between.</source>
        <translation>測定に対してコンピューターが遅すぎました: その間ブレスレットが停止していました。</translation>
    </message>
    <message>
        <source>measure again with fewer programs running</source>
        <translation>ほかの処理を減らして再測定</translation>
    </message>
</context>
<context>
    <name>RunningSiteText</name>
    <message>
        <source>nothing was read yet</source>
        <translation>まだ何も読み取っていません</translation>
    </message>
    <message>
        <source>it sends nothing any more</source>
        <translation>もう何も送ってきません</translation>
    </message>
    <message>
        <source>it is not connected</source>
        <translation>接続されていません</translation>
    </message>
    <message>
        <source>interrupted</source>
        <translation>中断されました</translation>
    </message>
    <message>
        <source>%1 requires the device %2, which the site does not have</source>
        <translation>%1に必要なデバイス%2がサイトにありません</translation>
    </message>
    <message>
        <source>ids of the site&apos;s devices</source>
        <translation>サイトのデバイスのid</translation>
    </message>
    <message>
        <source>the frame of %1: %2</source>
        <translation>%1の座標系: %2</translation>
    </message>
    <message>
        <source>a link of one arm of the site</source>
        <translation>サイトのアーム一つのリンク</translation>
    </message>
    <message>
        <source>several arms have the link %1</source>
        <translation>複数のアームにリンク%1があります</translation>
    </message>
    <message>
        <source>no arm has the link %1</source>
        <translation>リンク%1を持つアームがありません</translation>
    </message>
    <message>
        <source>the arm wears another array already</source>
        <translation>アームにはすでに別のアレイがあります</translation>
    </message>
</context>
<context>
    <name>Scene</name>
    <message>
        <source>the scene is not that of a tactile array</source>
        <translation>触覚アレイのシーンではありません</translation>
    </message>
    <message>
        <source>the scene is not that of an arm</source>
        <translation>アームのシーンではありません</translation>
    </message>
    <message>
        <source>the scene is not that of a camera in a soft tube</source>
        <translation>ソフトチューブ内カメラのシーンではありません</translation>
    </message>
    <message>
        <source>the scene is not that of a servoing arm</source>
        <translation>サーボアームのシーンではありません</translation>
    </message>
    <message>
        <source>the scene is not that of an arm with an operator</source>
        <translation>操作者付きアームのシーンではありません</translation>
    </message>
    <message>
        <source>the scene is not that of a flat gel</source>
        <translation>このシーンは平らなゲルのものではありません</translation>
    </message>
</context>
<context>
    <name>SceneReader</name>
    <message>
        <source>a time after %1 s</source>
        <translation>%1 sより後の時刻</translation>
    </message>
    <message>
        <source>the motion does not end where it starts</source>
        <translation>動きの終点が始点と一致しません</translation>
    </message>
    <message>
        <source>a last keyframe like the first one</source>
        <translation>最初と同じ最後のキーフレーム</translation>
    </message>
    <message>
        <source>which taxels are dead is not clear</source>
        <translation>どのタクセルが不良か明確ではありません</translation>
    </message>
    <message>
        <source>either &quot;count&quot; or &quot;taxels&quot;</source>
        <translation>&quot;count&quot;または&quot;taxels&quot;のいずれか一方</translation>
    </message>
    <message>
        <source>the effect is listed twice</source>
        <translation>効果が2回指定されています</translation>
    </message>
    <message>
        <source>each effect at most once</source>
        <translation>各効果は1回まで</translation>
    </message>
    <message>
        <source>the arm starts outside the range of its joints</source>
        <translation>アームの開始位置が関節の範囲外です</translation>
    </message>
    <message>
        <source>%1 from %2 to %3</source>
        <translation>%1: %2から%3まで</translation>
    </message>
    <message>
        <source>the program has no object to touch</source>
        <translation>プログラムに触れる物体がありません</translation>
    </message>
    <message>
        <source>at least one [[object]]</source>
        <translation>1つ以上の [[object]]</translation>
    </message>
    <message>
        <source>the camera is too far from the tube&apos;s axis</source>
        <translation>カメラがチューブの軸から離れすぎています</translation>
    </message>
    <message>
        <source>less than %1 m</source>
        <translation>%1 m未満</translation>
    </message>
    <message>
        <source>the dots touch each other</source>
        <translation>ドットどうしが接しています</translation>
    </message>
    <message>
        <source>less than the pitch of %1 m</source>
        <translation>ピッチ%1 m未満</translation>
    </message>
    <message>
        <source>there would be too few or too many dots</source>
        <translation>ドットが少なすぎるか多すぎます</translation>
    </message>
    <message>
        <source>more than %1 m and less than the radius of %2 m</source>
        <translation>%1 mより大きく、半径%2 m未満</translation>
    </message>
    <message>
        <source>there is no tray to keep level</source>
        <translation>水平に保つトレイがありません</translation>
    </message>
    <message>
        <source>an [object.hinge]</source>
        <translation>[object.hinge]</translation>
    </message>
    <message>
        <source>the times of the keyframes do not increase</source>
        <translation>キーフレームが時刻順ではありません</translation>
    </message>
    <message>
        <source>this is deeper than the skin can yield</source>
        <translation>皮膚がへこむ深さを超えています</translation>
    </message>
    <message>
        <source>this scene cannot have the effect &quot;%1&quot;</source>
        <translation>このシーンでは効果「%1」を使えません</translation>
    </message>
    <message>
        <source>the markers touch each other</source>
        <translation>マーカーが互いに触れています</translation>
    </message>
    <message>
        <source>the markers do not fit into the picture</source>
        <translation>マーカーが画像に収まりません</translation>
    </message>
    <message>
        <source>a grid smaller than %1 m x %2 m</source>
        <translation>%1 m x %2 m より小さい格子</translation>
    </message>
    <message>
        <source>this is deeper than the ball is round</source>
        <translation>球の半径より深くなっています</translation>
    </message>
</context>
<context>
    <name>SceneRecording</name>
    <message>
        <source>another program reads the recording, which keeps this name</source>
        <translation>ほかのプログラムが記録を読み取り中のため、この名前のままになります</translation>
    </message>
</context>
<context>
    <name>SceneRun</name>
    <message>
        <source>the image cannot be written</source>
        <translation>画像を書き込めません</translation>
    </message>
    <message>
        <source>the folder cannot be created or written to</source>
        <translation>フォルダーを作成できないか、書き込めません</translation>
    </message>
    <message>
        <source>the protocol has a stimulus that is not built in</source>
        <translation>プロトコルに、プログラムに付属していない刺激があります</translation>
    </message>
    <message>
        <source>tasks, letters and conditions whose patterns are built in</source>
        <translation>パターンがプログラムに付属している課題、文字、条件</translation>
    </message>
</context>
<context>
    <name>SerialTriggerText</name>
    <message>
        <source>the trigger&apos;s serial line cannot be used: %1</source>
        <translation>トリガーのシリアル回線を使用できません: %1</translation>
    </message>
    <message>
        <source>this is not a serial line</source>
        <translation>シリアル回線ではありません</translation>
    </message>
    <message>
        <source>a serial port, such as /dev/ttyUSB0</source>
        <translation>シリアルポート。例: /dev/ttyUSB0</translation>
    </message>
</context>
<context>
    <name>ServoCurves</name>
    <message>
        <source>a number from -1e12 to 1e12, or NA</source>
        <translation>-1e12から1e12までの数値、またはNA</translation>
    </message>
    <message>
        <source>times in order</source>
        <translation>順序どおりの時刻</translation>
    </message>
    <message>
        <source>names such as force+tool_speed, or nothing</source>
        <translation>force+tool_speed のような名前、または空</translation>
    </message>
    <message>
        <source>this is not a plausible number</source>
        <translation>実行の番号ではありません</translation>
    </message>
    <message>
        <source>the time decreases or is missing</source>
        <translation>時刻が減少しているか、ありません</translation>
    </message>
    <message>
        <source>this is not a limit of a servo</source>
        <translation>これはサーボの制限ではありません</translation>
    </message>
</context>
<context>
    <name>ServoTexts</name>
    <message>
        <source>Free motion</source>
        <translation>自由運動</translation>
    </message>
    <message>
        <source>Align</source>
        <translation>位置合わせ</translation>
    </message>
    <message>
        <source>Edge control</source>
        <translation>エッジ制御</translation>
    </message>
    <message>
        <source>Explore</source>
        <translation>探索</translation>
    </message>
    <message>
        <source>Roll</source>
        <translation>転がし</translation>
    </message>
    <message>
        <source>Follow a point</source>
        <translation>点の追従</translation>
    </message>
    <message>
        <source>Co-manipulation</source>
        <translation>協調操作</translation>
    </message>
    <message>
        <source>no contact</source>
        <translation>接触なし</translation>
    </message>
    <message>
        <source>in contact</source>
        <translation>接触中</translation>
    </message>
    <message>
        <source>searching for the contact</source>
        <translation>接触を探索中</translation>
    </message>
    <message>
        <source>contact lost</source>
        <translation>接触喪失</translation>
    </message>
    <message>
        <source>tool speed</source>
        <translation>ツール速度</translation>
    </message>
    <message>
        <source>turn rate</source>
        <translation>回転速度</translation>
    </message>
    <message>
        <source>force</source>
        <translation>力</translation>
    </message>
    <message>
        <source>saturated taxel</source>
        <translation>タクセルの飽和</translation>
    </message>
    <message>
        <source>distance from the measured pose</source>
        <translation>測定姿勢との距離</translation>
    </message>
    <message>
        <source>joint speed</source>
        <translation>関節速度</translation>
    </message>
    <message>
        <source>end of a joint</source>
        <translation>関節の可動端</translation>
    </message>
    <message>
        <source>singular arm</source>
        <translation>アームの特異姿勢</translation>
    </message>
    <message>
        <source>gap between frames</source>
        <translation>フレームの欠落</translation>
    </message>
    <message>
        <source>unusable numbers</source>
        <translation>使えない数値</translation>
    </message>
    <message>
        <source>, </source>
        <comment>between the limits that act</comment>
        <translation>, </translation>
    </message>
    <message>
        <source>Simulated cycle: %1 µs, %2 times real time. Contact %3 %, kinematics %4 %, features %5 %, control %6 %, dynamics %7 %.</source>
        <translation>シミュレーション周期: %1 µs、実時間の%2倍。接触 %3 %、運動学 %4 %、特徴量 %5 %、制御 %6 %、動力学 %7 %。</translation>
    </message>
    <message>
        <source>%1, run %2</source>
        <comment>a source, and which of its runs</comment>
        <translation>%1、実行%2</translation>
    </message>
    <message>
        <source>%1, partly without DZMP</source>
        <comment>a run</comment>
        <translation>%1、一部DZMPなし</translation>
    </message>
    <message>
        <source>%1, without DZMP</source>
        <comment>a run</comment>
        <translation>%1、DZMPなし</translation>
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
        <translation>力</translation>
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
        <translation>タスク完了</translation>
    </message>
    <message>
        <source>task not completed: stalled by the limit “%1”</source>
        <translation>タスク未完了: 制限「%1」で停滞した</translation>
    </message>
    <message>
        <source>task not completed: never in contact</source>
        <translation>タスク未完了: 一度も接触していない</translation>
    </message>
    <message>
        <source>task not completed: the contact was lost</source>
        <translation>タスク未完了: 接触が失われた</translation>
    </message>
    <message>
        <source>task not completed: stalled</source>
        <translation>タスク未完了: 停滞した</translation>
    </message>
    <message>
        <source>task not completed: not aligned</source>
        <translation>タスク未完了: 向きが揃っていない</translation>
    </message>
</context>
<context>
    <name>SettingsNotice</name>
    <message>
        <source>The settings are damaged: what can be read of them is used, the rest is as at the first start.</source>
        <translation>設定が破損しています: 読み取れる部分は使用され、残りは初回起動時の状態です。</translation>
    </message>
    <message>
        <source>No copy of the damaged file could be kept.</source>
        <translation>破損したファイルのコピーを残せませんでした。</translation>
    </message>
    <message>
        <source>A copy of the damaged file: %1</source>
        <translation>破損したファイルのコピー: %1</translation>
    </message>
    <message>
        <source>The settings are those of a newer version of this program: everything is as at the first start, and nothing is remembered.</source>
        <translation>設定はこのプログラムのより新しいバージョンのものです: すべて初回起動時の状態で、何も保存されません。</translation>
    </message>
    <message>
        <source>The file stays as it is: %1</source>
        <translation>ファイルはそのまま残ります: %1</translation>
    </message>
    <message>
        <source>The settings cannot be kept: what is set now is forgotten at the end.</source>
        <translation>設定を保存できません: ここで設定した内容は終了時に失われます。</translation>
    </message>
    <message>
        <source>This file cannot be written: %1</source>
        <translation>このファイルに書き込めません: %1</translation>
    </message>
</context>
<context>
    <name>SimulateCommand</name>
    <message>
        <source>Scene</source>
        <translation>シーン</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>シード</translation>
    </message>
    <message>
        <source>Simulated</source>
        <translation>シミュレーション時間</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>Computed in</source>
        <translation>計算時間</translation>
    </message>
    <message>
        <source>%1 s (%2 x real time)</source>
        <translation>%1 s (実時間の%2倍)</translation>
    </message>
    <message>
        <source>Effect %1</source>
        <translation>効果 %1</translation>
    </message>
    <message>
        <source>Events</source>
        <translation>イベント</translation>
    </message>
    <message>
        <source>Run a simulated scene as fast as possible and measure what was estimated</source>
        <translation>シミュレーションシーンをできるだけ速く実行し、推定結果を評価します</translation>
    </message>
    <message>
        <source>Seed of all random numbers of the scene</source>
        <translation>シーンのすべての乱数のシード</translation>
    </message>
    <message>
        <source>Share of %1</source>
        <translation>%1 の割合</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Scene file, or the name of a scene that comes with the program</source>
        <translation>シーンファイル、または付属シーンの名前</translation>
    </message>
    <message>
        <source>List the scenes that come with the program</source>
        <translation>付属シーンを一覧表示する</translation>
    </message>
    <message>
        <source>Folder for summary.json, the recording and its data as CSV; with --ablate the CSV file</source>
        <translation>summary.json、記録、およびそのデータのCSVのフォルダー。--ablateの場合はCSVファイル</translation>
    </message>
    <message>
        <source>Formats of the chart of a servo run in --out, separated by commas</source>
        <translation>--outでのサーボ実行のチャートの形式 (コンマ区切り)</translation>
    </message>
    <message>
        <source>Folders of earlier servo runs for the same chart, up to five</source>
        <translation>同じチャートに載せる以前のサーボ実行のフォルダー (5つまで)</translation>
    </message>
    <message>
        <source>Runs of each variant, with seeds from --seed upwards</source>
        <translation>各条件の実行回数。シードは--seedから順に増加</translation>
    </message>
    <message>
        <source>is required</source>
        <translation>指定が必要です</translation>
    </message>
    <message>
        <source>is for scenes of a servo</source>
        <translation>サーボのシーン専用です</translation>
    </message>
    <message>
        <source>a scene file, or a name that teleta simulate --list prints</source>
        <translation>シーンファイル、またはteleta simulate --listが表示する名前</translation>
    </message>
    <message>
        <source>Simulated time in seconds; default: as the scene says</source>
        <translation>シミュレーション時間 (秒)。省略時はシーンの指定</translation>
    </message>
    <message>
        <source>Leave out one effect at a time and compare how far each measure moves with its spread</source>
        <translation>効果を1つずつ除き、指標がばらつきに対してどれだけ変わるかを示す</translation>
    </message>
    <message>
        <source>never in contact</source>
        <translation>一度も接触していない</translation>
    </message>
    <message>
        <source>the contact was lost</source>
        <translation>接触が失われた</translation>
    </message>
    <message>
        <source>stalled</source>
        <translation>停滞した</translation>
    </message>
    <message>
        <source>stalled by the limit %1</source>
        <translation>制限%1で停滞した</translation>
    </message>
    <message>
        <source>not aligned</source>
        <translation>向きが揃っていない</translation>
    </message>
    <message>
        <source>completed</source>
        <translation>完了</translation>
    </message>
    <message>
        <source>not completed: %1, in the phase %2</source>
        <translation>未完了: %1 (フェーズ%2)</translation>
    </message>
    <message>
        <source>Task</source>
        <translation>課題</translation>
    </message>
    <message>
        <source>the task was %1</source>
        <translation>タスクの結果: %1</translation>
    </message>
    <message>
        <source>a completed task, or expect = &quot;not_completed&quot; in the scene</source>
        <translation>完了したタスク、またはシーンでの expect = &quot;not_completed&quot;</translation>
    </message>
</context>
<context>
    <name>SimulatedArmDevice</name>
    <message>
        <source>The arm was unplugged.</source>
        <translation>アームが取り外されました。</translation>
    </message>
</context>
<context>
    <name>SimulatedArrayDevice</name>
    <message>
        <source>The device was unplugged.</source>
        <translation>デバイスが取り外されました。</translation>
    </message>
</context>
<context>
    <name>SimulatedBracelet</name>
    <message>
        <source>Simulated bracelet</source>
        <translation>シミュレーションブレスレット</translation>
    </message>
    <message>
        <source>The bracelet was unplugged.</source>
        <translation>ブレスレットが取り外されました。</translation>
    </message>
</context>
<context>
    <name>SimulatedCameraDevice</name>
    <message>
        <source>The camera was unplugged.</source>
        <translation>カメラが取り外されました。</translation>
    </message>
</context>
<context>
    <name>SimulatedObserver</name>
    <message>
        <source>an observer cannot have &quot;%1&quot;</source>
        <translation>観測者に「%1」は指定できません</translation>
    </message>
    <message>
        <source>t and slope above 0, lapse from 0 to %1, sd of at least 0, as in t=0.2,slope=3.5,lapse=0.02,sd=0.1</source>
        <translation>tとslopeは0より大きい値、lapseは0から%1まで、sdは0以上。例: t=0.2,slope=3.5,lapse=0.02,sd=0.1</translation>
    </message>
</context>
<context>
    <name>SimulatedTube</name>
    <message>
        <source>the lens folds the image over itself: no camera has such a lens</source>
        <translation>カメラのレンズが折り返しています: そのようなカメラはありません</translation>
    </message>
</context>
<context>
    <name>SiteClientText</name>
    <message>
        <source>interrupted</source>
        <translation>中断されました</translation>
    </message>
    <message>
        <source>%1 speaks version %2 of the protocol of sites, this program version %3</source>
        <translation>%1 のサイトプロトコルは版 %2、このプログラムは版 %3 です</translation>
    </message>
    <message>
        <source>the site %1 was not found in domain %2 within %3 s</source>
        <translation>サイト %1 はドメイン %2 で %3 秒以内に見つかりませんでした</translation>
    </message>
    <message>
        <source>teleta-site running there, and its address under peers</source>
        <translation>そこで動いている teleta-site と、peers にあるそのアドレス</translation>
    </message>
    <message>
        <source>the site does not answer</source>
        <translation>サイトが応答しません</translation>
    </message>
    <message>
        <source>STOP is held by %1</source>
        <translation>STOP は %1 が保持しています</translation>
    </message>
    <message>
        <source>nobody controls the site; request control first</source>
        <translation>サイトを操作している人はいません。先に操作権を要求してください</translation>
    </message>
    <message>
        <source>%1 controls the site</source>
        <translation>%1 がサイトを操作しています</translation>
    </message>
    <message>
        <source>control is being handed to %1</source>
        <translation>操作権を %1 に渡しています</translation>
    </message>
    <message>
        <source>the site has no such arm any more</source>
        <translation>サイトにそのアームはもうありません</translation>
    </message>
    <message>
        <source>an arm had a fault; clear it first</source>
        <translation>アームに異常がありました。先に解除してください</translation>
    </message>
    <message>
        <source>an earlier program of this console still controls the site</source>
        <translation>このコンソールの以前のプログラムがまだサイトを操作しています</translation>
    </message>
    <message>
        <source>let go of the switch and press it again</source>
        <translation>スイッチを離して、もう一度押してください</translation>
    </message>
</context>
<context>
    <name>SiteCommandText</name>
    <message>
        <source>Check the certificates and permissions of a site, or print the commands that create them</source>
        <translation>拠点の証明書と許可を検査するか、それらを作成するコマンドを示します</translation>
    </message>
    <message>
        <source>Folder with identity_ca.pem, permissions_ca.pem, governance.p7s and one folder for each site, console and viewer</source>
        <translation>identity_ca.pem、permissions_ca.pem、governance.p7sと、拠点、コンソール、ビューアーごとに1つのフォルダーを含むフォルダー</translation>
    </message>
    <message>
        <source>Instead of checking, print the openssl commands that create the folder for a site of this name</source>
        <translation>検査せずに、この名前の拠点のフォルダーを作成するopensslのコマンドを表示</translation>
    </message>
    <message>
        <source>Consoles that may take control</source>
        <translation>操作できるコンソール</translation>
    </message>
    <message>
        <source>Consoles that only watch</source>
        <translation>閲覧のみのコンソール</translation>
    </message>
    <message>
        <source>List the sites that are there and who controls them</source>
        <translation>存在するサイトと、その操作者を一覧表示する</translation>
    </message>
    <message>
        <source>Print each change of a site&apos;s state</source>
        <translation>サイトの状態の変化を表示する</translation>
    </message>
    <message>
        <source>Print the offset of a site&apos;s clock, and its bound</source>
        <translation>サイトの時計のずれとその限界を表示する</translation>
    </message>
    <message>
        <source>Record all that a site sends, without a screen</source>
        <translation>サイトが送るものすべてを画面なしで記録する</translation>
    </message>
    <message>
        <source>File of the recording</source>
        <translation>記録のファイル</translation>
    </message>
    <message>
        <source>File with which the site is reached (kind = &quot;remote_site&quot;)</source>
        <translation>サイトに接続するためのファイル（kind = &quot;remote_site&quot;）</translation>
    </message>
    <message>
        <source>End after that time; default: Ctrl-C</source>
        <translation>この時間で終える。既定：Ctrl-C</translation>
    </message>
    <message>
        <source>These keys are not safe to use.</source>
        <translation>これらの鍵は安全に使用できません。</translation>
    </message>
    <message>
        <source>%1 (%2): %3, until %4</source>
        <translation>%1 (%2): %3、%4まで</translation>
    </message>
    <message>
        <source>Refused: %1</source>
        <translation>拒否: %1</translation>
    </message>
    <message>
        <source>Warning: %1</source>
        <translation>警告: %1</translation>
    </message>
    <message>
        <source>Sites at which robots are, and their keys</source>
        <translation>ロボットのあるサイトとその鍵</translation>
    </message>
</context>
<context>
    <name>SiteEventText</name>
    <message>
        <source>%1: the console %2 is there.</source>
        <translation>%1：コンソール %2 が接続しました。</translation>
    </message>
    <message>
        <source>%1 cannot listen to the console %2: %3</source>
        <translation>%1 はコンソール %2 を受信できません：%3</translation>
    </message>
    <message>
        <source>%1: another program named %2 is connected; it is ignored.</source>
        <translation>%1：%2 という名前の別のプログラムが接続しています。無視されます。</translation>
    </message>
    <message>
        <source>%1 kept a program out: %2</source>
        <translation>%1 はプログラムを受け入れませんでした：%2</translation>
    </message>
    <message>
        <source>%1: %2 is in control.</source>
        <translation>%1：%2 が操作しています。</translation>
    </message>
    <message>
        <source>%1: %2 is no longer in control.</source>
        <translation>%1：%2 は操作を終えました。</translation>
    </message>
    <message>
        <source>%1: STOP is held by %2.</source>
        <translation>%1：STOP は %2 が保持しています。</translation>
    </message>
    <message>
        <source>%1: %2 withdrew STOP.</source>
        <translation>%1：%2 が STOP を解除しました。</translation>
    </message>
    <message>
        <source>%1: fault of %2: %3</source>
        <translation>%1：%2 の異常：%3</translation>
    </message>
    <message>
        <source>%1: %2 is live.</source>
        <translation>%1：%2 は動作中です。</translation>
    </message>
    <message>
        <source>%1: its recording failed: %2</source>
        <translation>%1：記録に失敗しました：%2</translation>
    </message>
    <message>
        <source>%1: its keys: %2</source>
        <translation>%1：その鍵：%2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>a site and what it says</comment>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>%1: %2: %3</source>
        <comment>a site, a device and what it says</comment>
        <translation>%1：%2：%3</translation>
    </message>
</context>
<context>
    <name>SiteFileText</name>
    <message>
        <source>the device needs an id</source>
        <translation>装置には id が必要です</translation>
    </message>
    <message>
        <source>id = &quot;a small letter, then small letters, digits and _&quot;</source>
        <translation>id = &quot;小文字で始まり、小文字、数字、_ が続く&quot;</translation>
    </message>
    <message>
        <source>a site does not send this kind of device</source>
        <translation>サイトはこの種の装置を送りません</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no name of a console</source>
        <translation>「%1」はコンソールの名前ではありません</translation>
    </message>
    <message>
        <source>a small letter, then at most 30 small letters, digits and _</source>
        <translation>小文字で始まり、小文字、数字、_ が最大 30 文字続くもの</translation>
    </message>
    <message>
        <source>two devices are called &quot;%1&quot;</source>
        <translation>「%1」という装置が二つあります</translation>
    </message>
    <message>
        <source>a unique id for each device</source>
        <translation>装置ごとに異なる id</translation>
    </message>
    <message>
        <source>a pose needs a frame</source>
        <translation>姿勢には座標系が必要です</translation>
    </message>
    <message>
        <source>frame = &quot;the link of the arm&quot;</source>
        <translation>frame = &quot;アームのリンク&quot;</translation>
    </message>
    <message>
        <source>the file of an arm, an array, a gel or a camera over ROS 2</source>
        <translation>アーム、アレイ、ゲル、またはROS 2のカメラのファイル</translation>
    </message>
    <message>
        <source>file, wts, taxels, gel, scene or scene_camera</source>
        <translation>file、wts、taxels、gel、scene、scene_cameraのいずれか</translation>
    </message>
</context>
<context>
    <name>SiteKeys</name>
    <message>
        <source>&apos;%1&apos; is not a valid name for a site or a console</source>
        <translation>「%1」は拠点またはコンソールの名前ではありません</translation>
    </message>
    <message>
        <source>a lowercase letter, then at most 30 of a-z, 0-9 and _</source>
        <translation>英小文字1字の後に、a-z、0-9、_を30字以下</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is already taken</source>
        <translation>「%1」は既に使われています</translation>
    </message>
    <message>
        <source>No topic of a site (rt/teleta/SITE/...) is allowed.</source>
        <translation>拠点のトピック (rt/teleta/SITE/...) が1つも許可されていません。</translation>
    </message>
    <message>
        <source>%1 must not publish %2.</source>
        <translation>%1 に %2 の送信を許可してはいけません。</translation>
    </message>
    <message>
        <source>%1 needs to publish %2.</source>
        <translation>%1 には %2 の送信の許可が必要です。</translation>
    </message>
    <message>
        <source>%1 must not subscribe to %2.</source>
        <translation>%1 に %2 の受信を許可してはいけません。</translation>
    </message>
    <message>
        <source>%1 needs to subscribe to %2.</source>
        <translation>%1 には %2 の受信の許可が必要です。</translation>
    </message>
    <message>
        <source>%1 must not relay %2.</source>
        <translation>%1 に %2 の中継を許可してはいけません。</translation>
    </message>
    <message>
        <source>The signed document is not XML.</source>
        <translation>署名された内容がXMLではありません。</translation>
    </message>
    <message>
        <source>The validity needs not_before and not_after as 2026-01-31T00:00:00, without a time zone.</source>
        <translation>有効期間には、タイムゾーンのない2026-01-31T00:00:00の形式のnot_beforeとnot_afterが必要です。</translation>
    </message>
    <message>
        <source>The permissions are not valid yet.</source>
        <translation>許可はまだ有効ではありません。</translation>
    </message>
    <message>
        <source>The permissions have expired.</source>
        <translation>許可の有効期限が切れています。</translation>
    </message>
    <message>
        <source>The grant has a deny_rule. It needs none: what is not allowed is denied.</source>
        <translation>grantにdeny_ruleがあります。許可されていないものは拒否されるため、不要です。</translation>
    </message>
    <message>
        <source>The default of the grant is not DENY.</source>
        <translation>grantのdefaultがDENYではありません。</translation>
    </message>
    <message>
        <source>No grant names the subject of the certificate, %1.</source>
        <translation>証明書のサブジェクト %1 を指定するgrantがありません。</translation>
    </message>
    <message>
        <source>The signed document has no domain_rule.</source>
        <translation>署名された内容にdomain_ruleがありません。</translation>
    </message>
    <message>
        <source>%1 must be %2.</source>
        <translation>%1は%2でなければなりません。</translation>
    </message>
    <message>
        <source>Both authorities share one key. Anyone with a certificate could sign their own permissions.</source>
        <translation>2つの認証局の鍵が同じです。証明書を持つ者が、自分の許可に署名できてしまいます。</translation>
    </message>
    <message>
        <source>There is no folder for a site, a console or a viewer.</source>
        <translation>拠点、コンソール、ビューアーのフォルダーがありません。</translation>
    </message>
    <message>
        <source>This is not a certificate.</source>
        <translation>これは証明書ではありません。</translation>
    </message>
    <message>
        <source>The file is missing.</source>
        <translation>ファイルがありません。</translation>
    </message>
    <message>
        <source>The certificate is not valid yet.</source>
        <translation>証明書はまだ有効ではありません。</translation>
    </message>
    <message>
        <source>The certificate has expired.</source>
        <translation>証明書の有効期限が切れています。</translation>
    </message>
    <message>
        <source>The certificate ends on %1.</source>
        <translation>証明書の有効期限は%1です。</translation>
    </message>
    <message>
        <source>This is not a certificate authority (basicConstraints CA:TRUE).</source>
        <translation>これは認証局ではありません (basicConstraints CA:TRUE)。</translation>
    </message>
    <message>
        <source>Its key usage lacks digitalSignature or keyCertSign.</source>
        <translation>鍵用途にdigitalSignatureまたはkeyCertSignがありません。</translation>
    </message>
    <message>
        <source>It is not self-signed.</source>
        <translation>自己署名されていません。</translation>
    </message>
    <message>
        <source>Others can read or write this private key (chmod 600).</source>
        <translation>この秘密鍵はほかのユーザーが読み書きできます (chmod 600)。</translation>
    </message>
    <message>
        <source>This is not a private key without a password.</source>
        <translation>これはパスワードのない秘密鍵ではありません。</translation>
    </message>
    <message>
        <source>The key does not belong to the certificate.</source>
        <translation>鍵が証明書と対応していません。</translation>
    </message>
    <message>
        <source>It is not signed by permissions_ca.pem itself.</source>
        <translation>permissions_ca.pem自体による署名ではありません。</translation>
    </message>
    <message>
        <source>Its subject is %1, the folder is called %2.</source>
        <translation>サブジェクトは %1 ですが、フォルダーの名前は %2 です。</translation>
    </message>
    <message>
        <source>It is not signed by identity_ca.pem.</source>
        <translation>identity_ca.pemによる署名がありません。</translation>
    </message>
    <message>
        <source>It verifies against permissions_ca.pem, so its holder could sign their own permissions. That authority must sign nothing but governance and permissions.</source>
        <translation>permissions_ca.pemで検証に通ります: 所有者が自分の許可に署名できてしまいます。この認証局は、governanceとpermissions以外に署名してはいけません。</translation>
    </message>
    <message>
        <source>The key is not here. That is fine if it is kept only on its own computer.</source>
        <translation>鍵はここにありません。鍵をそれ自身のコンピューターにだけ置く場合は、これで正常です。</translation>
    </message>
    <message>
        <source>The permissions end on %1.</source>
        <translation>許可の有効期限は%1です。</translation>
    </message>
    <message>
        <source>Its topics belong to the site %1, those of other permissions to %2.</source>
        <translation>トピックは拠点 %1 のものですが、ほかの許可は %2 を指定しています。</translation>
    </message>
    <message>
        <source>There is no folder %1.</source>
        <translation>フォルダー %1 がありません。</translation>
    </message>
    <message>
        <source>The folder %1 cannot be read.</source>
        <translation>フォルダー %1 を読み取れません。</translation>
    </message>
</context>
<context>
    <name>SiteProgramText</name>
    <message numerus="yes">
        <source>All %n device(s) are ready.</source>
        <translation>
            <numerusform>%n 台の装置がすべて準備完了です。</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 is ready in domain %2 on %3</source>
        <translation>%1 はドメイン %2（%3）で準備完了</translation>
    </message>
    <message>
        <source>the site ends; the arms are held</source>
        <translation>サイトを終了します。アームは保持されます</translation>
    </message>
    <message>
        <source>Runs at the robot: sends what its arms and tactile arrays feel to the consoles, and decides which console moves them.</source>
        <translation>ロボット側で動きます。アームと触覚アレイが感じたものをコンソールに送り、どのコンソールが動かすかを決めます。</translation>
    </message>
    <message>
        <source>Print this help</source>
        <translation>このヘルプを表示する</translation>
    </message>
    <message>
        <source>File of the site (kind = &quot;site&quot;)</source>
        <translation>サイトのファイル（kind = &quot;site&quot;）</translation>
    </message>
    <message>
        <source>Open everything, move nothing, and say what is missing</source>
        <translation>すべてを開き、何も動かさず、足りないものを示す</translation>
    </message>
    <message>
        <source>Print the log, or what is missing, as JSON on standard output</source>
        <translation>ログ、または足りないものを JSON で標準出力に出す</translation>
    </message>
    <message>
        <source>Folder for recordings (record = true); default: the current one</source>
        <translation>記録のフォルダー（record = true）。既定：現在のフォルダー</translation>
    </message>
    <message>
        <source>Print the version</source>
        <translation>バージョンを表示する</translation>
    </message>
    <message>
        <source>teleta-site: %1
Run teleta-site --help for more.
</source>
        <translation>teleta-site: %1
詳しくは teleta-site --help を実行してください。
</translation>
    </message>
    <message>
        <source>Folder that keeps who engages STOP, for the next start; default: $STATE_DIRECTORY, otherwise ~/.local/state/teleta-site</source>
        <translation>誰がSTOPをかけたかを次の起動のために保存するフォルダー。既定: $STATE_DIRECTORY、なければ ~/.local/state/teleta-site</translation>
    </message>
</context>
<context>
    <name>SiteRequestText</name>
    <message>
        <source>the site %1 has no device to show</source>
        <translation>サイト %1 に表示できる装置はありません</translation>
    </message>
    <message>
        <source>the connection to %1 has ended</source>
        <translation>%1 との接続は終わりました</translation>
    </message>
    <message>
        <source>the site to be connected again</source>
        <translation>サイトに接続し直すこと</translation>
    </message>
</context>
<context>
    <name>SkinKinematics</name>
    <message>
        <source>the joint %1 slides, and stiffness is evaluated from an angle</source>
        <translation>関節%1は直動ですが、剛性は角度から求められます</translation>
    </message>
    <message>
        <source>a joint that turns</source>
        <translation>回転する関節</translation>
    </message>
    <message>
        <source>no joint presses the pad on %1: all of them move its centre along it</source>
        <translation>%1上のアレイを押す関節がありません: どの関節も中心をアレイに沿って動かします</translation>
    </message>
    <message>
        <source>a joint with a lever of 2 cm or more</source>
        <translation>てこが2 cm以上の関節</translation>
    </message>
    <message>
        <source>no joint %1 moves the pad on %2</source>
        <translation>%2上のアレイを動かす関節%1はありません</translation>
    </message>
    <message>
        <source>one of %1</source>
        <translation>%1のいずれか</translation>
    </message>
    <message>
        <source>the link %1 is moved by %2, which is no joint of the arm</source>
        <translation>リンク%1は、アームの関節ではない%2によって動きます</translation>
    </message>
    <message>
        <source>a link between %1 and %2</source>
        <translation>%1と%2の間のリンク</translation>
    </message>
    <message>
        <source>%1 joint stiffnesses are given</source>
        <translation>関節剛性が%1個あります</translation>
    </message>
    <message>
        <source>%1, one for each joint</source>
        <translation>%1個、関節ごとに一つ</translation>
    </message>
</context>
<context>
    <name>Slurm</name>
    <message>
        <source>the program %1 of Slurm is not there</source>
        <translation>Slurm のプログラム %1 がありません</translation>
    </message>
    <message>
        <source>the package slurm-client, or a login node of the cluster</source>
        <translation>パッケージ slurm-client、またはクラスターのログインノード</translation>
    </message>
    <message>
        <source>%1 does not answer</source>
        <translation>%1 が応答しません</translation>
    </message>
    <message>
        <source>%1 refuses: %2</source>
        <translation>%1 が拒否しました: %2</translation>
    </message>
</context>
<context>
    <name>SoundBracelet</name>
    <message>
        <source>The sound card requests no samples.</source>
        <translation>サウンドカードがサンプルを要求しません。</translation>
    </message>
    <message>
        <source>There is no JACK library: %1</source>
        <translation>JACKライブラリがありません: %1</translation>
    </message>
    <message>
        <source>the package pipewire-jack, or libjack-jackd2-0</source>
        <translation>パッケージpipewire-jackまたはlibjack-jackd2-0</translation>
    </message>
</context>
<context>
    <name>SoundFaultText</name>
    <message>
        <source>Samples came too late while a tactor was driven.</source>
        <translation>アクチュエーターの駆動中にサンプルが遅れました。</translation>
    </message>
    <message>
        <source>The sound server stopped.</source>
        <translation>サウンドサーバーが終了しました。</translation>
    </message>
    <message>
        <source>The sound card is gone.</source>
        <translation>サウンドカードがなくなりました。</translation>
    </message>
    <message>
        <source>The sound server changed its sample rate.</source>
        <translation>サウンドサーバーのサンプルレートが変わりました。</translation>
    </message>
    <message>
        <source>The sound server changed its period.</source>
        <translation>サウンドサーバーの周期が変わりました。</translation>
    </message>
    <message>
        <source>A tactor was disconnected from its output.</source>
        <translation>アクチュエーターが出力から切断されました。</translation>
    </message>
    <message>
        <source>Another program began to play on the sound card.</source>
        <translation>ほかのプログラムがサウンドカードで再生を始めました。</translation>
    </message>
    <message>
        <source>The sound server stopped requesting samples.</source>
        <translation>サウンドサーバーがサンプルを要求しなくなりました。</translation>
    </message>
</context>
<context>
    <name>SoundFileText</name>
    <message>
        <source>&quot;%1&quot; names no sound card</source>
        <translation>「%1」はサウンドカードの名前ではありません</translation>
    </message>
    <message>
        <source>pipewire, pipewire:NODE, jack, jack:CLIENT or alsa:PCM</source>
        <translation>pipewire、pipewire:NODE、jack、jack:CLIENT、alsa:PCMのいずれか</translation>
    </message>
    <message>
        <source>no such sample rate: %1</source>
        <translation>そのようなサンプルレートはありません: %1</translation>
    </message>
    <message>
        <source>one of: %1</source>
        <translation>次のいずれか: %1</translation>
    </message>
    <message>
        <source>%1 is no power of two</source>
        <translation>%1は2の累乗ではありません</translation>
    </message>
    <message>
        <source>16, 32, 64, 128, 256, 512, 1024 or 2048</source>
        <translation>16、32、64、128、256、512、1024、2048のいずれか</translation>
    </message>
    <message>
        <source>each tactor needs an output of its own</source>
        <translation>アクチュエーターごとに別の出力が必要です</translation>
    </message>
    <message>
        <source>six different whole numbers</source>
        <translation>互いに異なる6個の整数</translation>
    </message>
    <message>
        <source>%1 carriers for six tactors</source>
        <translation>6個のアクチュエーターに対して搬送波が%1個</translation>
    </message>
    <message>
        <source>one number, or a list of six</source>
        <translation>1つの数値、または6個のリスト</translation>
    </message>
    <message>
        <source>the frequency is not clear</source>
        <translation>周波数がはっきりしません</translation>
    </message>
    <message>
        <source>either carrier_Hz or level_Hz</source>
        <translation>carrier_Hzかlevel_Hzのどちらか</translation>
    </message>
    <message>
        <source>the levels do not rise</source>
        <translation>レベルが昇順ではありません</translation>
    </message>
    <message>
        <source>five frequencies, the lowest first</source>
        <translation>低い順に5個の周波数</translation>
    </message>
    <message>
        <source>the ramp is too short for the frequency: it would click</source>
        <translation>ランプが周波数に対して短すぎます: クリックが生じます</translation>
    </message>
    <message>
        <source>at least %1 ms</source>
        <translation>%1 ms以上</translation>
    </message>
    <message>
        <source>there is no latency that varies</source>
        <translation>ばらつく遅延がありません</translation>
    </message>
    <message>
        <source>latency_ms as well</source>
        <translation>latency_msも指定</translation>
    </message>
</context>
<context>
    <name>SoundLatency</name>
    <message>
        <source>only %1 of %2 clicks were heard on %3, whose noise reaches %4 of full scale</source>
        <translation>%3で聞こえたクリックは%2回のうち%1回だけです。この入力の雑音はフルスケールの%4に達します</translation>
    </message>
    <message>
        <source>an accelerometer at tactor 1, or a cable from its output to this input</source>
        <translation>アクチュエーター1の加速度センサー、またはその出力からこの入力へのケーブル</translation>
    </message>
    <message>
        <source>The measurement was ended.</source>
        <translation>測定は中断されました。</translation>
    </message>
</context>
<context>
    <name>SoundLatencyFile</name>
    <message>
        <source>The latency cannot be written into %1.</source>
        <translation>遅延を %1 に書き込めません。</translation>
    </message>
    <message>
        <source>these lines in the file, written by hand:
%1</source>
        <translation>次の行を手でファイルに書く:
%1</translation>
    </message>
</context>
<context>
    <name>SourceText</name>
    <message>
        <source>these are data of different modes: %1 and %2</source>
        <translation>異なるモードのデータが混在しています: %1と%2</translation>
    </message>
    <message>
        <source>%1 cannot be &quot;%2&quot;</source>
        <translation>%1 を「%2」にはできません</translation>
    </message>
    <message>
        <source>run, pilot or simulated</source>
        <translation>run、pilot、またはsimulated</translation>
    </message>
    <message>
        <source>a value</source>
        <translation>値</translation>
    </message>
    <message>
        <source>practice or test</source>
        <translation>practiceまたはtest</translation>
    </message>
    <message>
        <source>correct, incorrect, timeout, aborted or device_error</source>
        <translation>correct、incorrect、timeout、aborted、またはdevice_error</translation>
    </message>
    <message>
        <source>a number of seconds or NA</source>
        <translation>秒数またはNA</translation>
    </message>
    <message>
        <source>%1 at most</source>
        <translation>%1以下</translation>
    </message>
    <message>
        <source>each trial once</source>
        <translation>各試行は一度だけ</translation>
    </message>
    <message>
        <source>interrupted</source>
        <translation>中断されました</translation>
    </message>
    <message>
        <source>there are too many different patterns</source>
        <translation>異なるパターンが多すぎます</translation>
    </message>
    <message>
        <source>one mode, or the choice of one</source>
        <translation>1つのモード、または対象とするモードの指定</translation>
    </message>
    <message>
        <source>%1 also has trials in %2: these may be two people, or the same trials twice</source>
        <translation>%1 の試行は %2 にもあります: 別の二人か、同じ試行が二度あるのかもしれません</translation>
    </message>
    <message>
        <source>each participant in one study only, under a unique name</source>
        <translation>参加者ごとに一つの実験、固有の名前</translation>
    </message>
    <message>
        <source>the value implied by stimulus and response</source>
        <translation>刺激と応答が示すもの</translation>
    </message>
    <message>
        <source>a whole number of at least 1</source>
        <translation>1 以上の整数</translation>
    </message>
    <message>
        <source>trial %1 of session %2 of %3 was already counted</source>
        <translation>%3 のセッション %2 の試行 %1 はすでに数えられています</translation>
    </message>
    <message>
        <source>this text is not UTF-8</source>
        <translation>テキストがUTF-8ではありません</translation>
    </message>
    <message>
        <source>a file that was saved as UTF-8</source>
        <translation>UTF-8で保存したファイル</translation>
    </message>
    <message>
        <source>a whole number</source>
        <translation>整数</translation>
    </message>
    <message>
        <source>the columns are separated by semicolons</source>
        <translation>列がセミコロンで区切られています</translation>
    </message>
    <message>
        <source>the columns are separated by tabs</source>
        <translation>列がタブで区切られています</translation>
    </message>
    <message>
        <source>commas, and a point in numbers: the trials that are in data/ of the study, or the file saved as CSV with commas</source>
        <translation>コンマ区切りで、小数点はピリオド: 実験のdata/にある試行、またはコンマ区切りのCSVとして保存したファイル</translation>
    </message>
    <message>
        <source>the sensor file names no camera and no video</source>
        <translation>センサーファイルにカメラも動画も書かれていません</translation>
    </message>
    <message>
        <source>a key &quot;source&quot;</source>
        <translation>キー「source」</translation>
    </message>
    <message>
        <source>it is not the file of one pad</source>
        <translation>触覚アレイ一つのファイルではありません</translation>
    </message>
    <message>
        <source>an array, or a list with one: taxels or wts</source>
        <translation>アレイ、またはアレイ一つのリスト: taxelsかwts</translation>
    </message>
</context>
<context>
    <name>SpectrumText</name>
    <message>
        <source>The signal has no rate: its samples come when they please.</source>
        <translation>この信号には周期がありません: サンプルは不定期に届きます。</translation>
    </message>
    <message>
        <source>There are only %1 samples in a row in view; a spectrum needs %2.</source>
        <translation>見えている連続したサンプルは %1 個だけです。スペクトルには %2 個必要です。</translation>
    </message>
</context>
<context>
    <name>StandardStreamText</name>
    <message>
        <source>standard input cannot be read</source>
        <translation>標準入力を読み込めません</translation>
    </message>
    <message>
        <source>standard input is too large</source>
        <translation>標準入力が大きすぎます</translation>
    </message>
    <message>
        <source>standard input can be read only once</source>
        <translation>標準入力は一度しか読み込めません</translation>
    </message>
    <message>
        <source>standard output can be written only once</source>
        <translation>標準出力には一度しか書き込めません</translation>
    </message>
    <message>
        <source>- is given, a folder is expected</source>
        <translation>-が指定されましたが、必要なのはフォルダーです</translation>
    </message>
    <message>
        <source>a recording is a database, which is no stream</source>
        <translation>記録はデータベースであり、ストリームとして扱えません</translation>
    </message>
    <message>
        <source>a video cannot be read from standard input</source>
        <translation>動画は標準入力から読み込めません</translation>
    </message>
    <message>
        <source>the document and a file would both go to standard output</source>
        <translation>文書とファイルの両方が標準出力に書き込まれることになります</translation>
    </message>
    <message>
        <source>an npz file is an archive, which is no stream</source>
        <translation>npzファイルはアーカイブであり、ストリームではありません</translation>
    </message>
</context>
<context>
    <name>StiffnessText</name>
    <message>
        <source>the log has no samples</source>
        <translation>ログにサンプルがありません</translation>
    </message>
    <message>
        <source>a row for each sample of the touch</source>
        <translation>タッチのサンプルごとに1行</translation>
    </message>
    <message>
        <source>one half of the torque window has no sample; the largest torque is %1 Nm</source>
        <translation>トルク窓の片側半分にサンプルがありません。最大トルクは%1 Nmです</translation>
    </message>
    <message>
        <source>samples near %1 Nm and near %2 Nm</source>
        <translation>%1 Nm付近と%2 Nm付近のサンプル</translation>
    </message>
    <message>
        <source>no sample reaches the torque window; the largest torque is %1 Nm</source>
        <translation>トルク窓に達するサンプルがありません。最大トルクは%1 Nmです</translation>
    </message>
    <message>
        <source>torques from %1 to %2 Nm</source>
        <translation>%1から%2 Nmまでのトルク</translation>
    </message>
    <message>
        <source>fewer than 20 independent samples lie in the torque window</source>
        <translation>トルク窓内の独立なサンプルが20個未満です</translation>
    </message>
    <message>
        <source>a slower touch or quicker sampling from %1 to %2 Nm; --method two-point needs two samples</source>
        <translation>%1～%2 Nmでのより遅いタッチまたはより速いサンプリング。--method two-point では2サンプルで足ります</translation>
    </message>
    <message>
        <source>the torque does not change within the window</source>
        <translation>窓の中でトルクが変化しません</translation>
    </message>
    <message>
        <source>torque that rises from %1 to %2 Nm</source>
        <translation>%1から%2 Nmまで上昇するトルク</translation>
    </message>
    <message>
        <source>the joint turns against the rising torque</source>
        <translation>上昇するトルクに逆らって関節が回っています</translation>
    </message>
    <message>
        <source>angle and torque that rise together; the sign of one column may be turned</source>
        <translation>ともに増加する角度とトルク。一方の列の符号が逆かもしれません</translation>
    </message>
    <message>
        <source>the torque rises so quickly that the arm&apos;s inertia is part of it</source>
        <translation>トルクの上昇が速すぎて、アームの慣性が含まれています</translation>
    </message>
    <message>
        <source>a slower touch</source>
        <translation>もっとゆっくりしたタッチ</translation>
    </message>
    <message>
        <source>the numbers are too large or too small to compute with</source>
        <translation>数値が大きすぎるか小さすぎて計算できません</translation>
    </message>
    <message>
        <source>SI units</source>
        <translation>SI単位</translation>
    </message>
    <message>
        <source>sponge</source>
        <translation>スポンジ</translation>
    </message>
    <message>
        <source>rubber sponge</source>
        <translation>ゴムスポンジ</translation>
    </message>
    <message>
        <source>rubber</source>
        <translation>ゴム</translation>
    </message>
    <message>
        <source>wood</source>
        <translation>木</translation>
    </message>
    <message>
        <source>metal</source>
        <translation>金属</translation>
    </message>
    <message>
        <source>at least %1 N/m (95 %)</source>
        <translation>%1 N/m以上 (95 %)</translation>
    </message>
    <message>
        <source>%1 N/m (uncertainty not available)</source>
        <translation>%1 N/m (不確かさは不明)</translation>
    </message>
    <message>
        <source>%1 N/m (95 %: %2 to %3)</source>
        <translation>%1 N/m (95 %: %2～%3)</translation>
    </message>
    <message>
        <source>the noise of neighbouring samples is not independent</source>
        <translation>隣り合うサンプルの雑音が独立ではありません</translation>
    </message>
    <message>
        <source>one step of the torque reading is over a tenth of the window</source>
        <translation>トルクの読みの1刻みが窓の10分の1を超えています</translation>
    </message>
    <message>
        <source>one step of the angle reading is over a tenth of the rotation</source>
        <translation>角度の読みの1刻みが回転の10分の1を超えています</translation>
    </message>
    <message>
        <source>the free joint has a torque; it was taken off</source>
        <translation>自由な関節にトルクがあり、差し引かれました</translation>
    </message>
    <message>
        <source>the torque of the free joint changes; the change was taken off</source>
        <translation>自由な関節のトルクが変化しており、その変化は差し引かれました</translation>
    </message>
    <message>
        <source>the stiffness changes within the window</source>
        <translation>窓の中で硬さが変化しています</translation>
    </message>
    <message>
        <source>the force depends on how quickly the object is pressed</source>
        <translation>力が物体を押す速さに依存しています</translation>
    </message>
    <message>
        <source>the free joint has another torque than --torque-reference says</source>
        <translation>自由な関節のトルクが --torque-reference の値と異なります</translation>
    </message>
    <message>
        <source>cannot tell</source>
        <translation>判定不能</translation>
    </message>
    <message>
        <source>%1, safe to touch, level %2 of 5</source>
        <translation>%1、触れても安全、レベル%2/5</translation>
    </message>
    <message>
        <source>%1, danger, level %2 of 5</source>
        <translation>%1、危険、レベル%2/5</translation>
    </message>
    <message>
        <source>two-point</source>
        <translation>2点法</translation>
    </message>
    <message>
        <source>regression</source>
        <translation>回帰</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>方法</translation>
    </message>
    <message>
        <source>Samples</source>
        <translation>サンプル数</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>回転</translation>
    </message>
    <message>
        <source>%1 rad</source>
        <translation>%1 rad</translation>
    </message>
    <message>
        <source>Torque rise</source>
        <translation>トルク上昇</translation>
    </message>
    <message>
        <source>%1 Nm</source>
        <translation>%1 Nm</translation>
    </message>
    <message>
        <source>Total stiffness</source>
        <translation>全体の剛性</translation>
    </message>
    <message>
        <source>Object stiffness</source>
        <translation>物体の剛性</translation>
    </message>
    <message>
        <source>Secant, tangent</source>
        <translation>割線、接線</translation>
    </message>
    <message>
        <source>%1 N/m, %2 N/m at the upper end</source>
        <translation>%1 N/m、上端で%2 N/m</translation>
    </message>
    <message>
        <source>Static stiffness</source>
        <translation>静的な硬さ</translation>
    </message>
    <message>
        <source>Quick over static</source>
        <translation>動的と静的の比</translation>
    </message>
    <message>
        <source>1 + %1 (95 %: %2 to %3)</source>
        <translation>1 + %1 (95 %: %2～%3)</translation>
    </message>
    <message>
        <source>Relaxation</source>
        <translation>緩和時間</translation>
    </message>
    <message>
        <source>%1 s (95 %: %2 to %3)</source>
        <translation>%1 s (95 %: %2～%3)</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>材料</translation>
    </message>
    <message>
        <source>Reliable</source>
        <translation>信頼性</translation>
    </message>
    <message>
        <source>no</source>
        <translation>いいえ</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>警告</translation>
    </message>
    <message>
        <source>CSV with the columns time_s,joint_angle_rad,joint_torque_nm</source>
        <translation>time_s,joint_angle_rad,joint_torque_nm の列を持つCSV</translation>
    </message>
    <message>
        <source>Distance of the contact from the joint&apos;s axis along the link, m</source>
        <translation>関節軸からリンクに沿った接触点までの距離、m</translation>
    </message>
    <message>
        <source>Standard error of the contact distance, m; it enters twice. Default: 0.05 % of the distance</source>
        <translation>接触距離の標準誤差 (m)。2回効きます。既定値: 距離の0.05 %</translation>
    </message>
    <message>
        <source>Half the thickness of the link, m; it cancels out of the stiffness</source>
        <translation>リンクの厚さの半分、m。剛性の計算では打ち消し合います</translation>
    </message>
    <message>
        <source>The link&apos;s own stiffness, N/m</source>
        <translation>リンク自体の剛性、N/m</translation>
    </message>
    <message>
        <source>Standard error of that stiffness, N/m</source>
        <translation>その硬さの標準誤差 (N/m)</translation>
    </message>
    <message>
        <source>Torque of the joint without the touch, Nm; start: that of the free motion before the touch, or 0 when there is none</source>
        <translation>タッチがないときの関節のトルク (Nm)。start: タッチ前の自由な動きのトルク、なければ0</translation>
    </message>
    <message>
        <source>two-point: the samples nearest to both borders of the window; regression: all samples in it</source>
        <translation>two-point: 窓の両端に最も近いサンプル。regression: 窓内の全サンプル</translation>
    </message>
    <message>
        <source>Torques between which the touch is evaluated, Nm</source>
        <translation>タッチを評価するトルクの範囲、Nm</translation>
    </message>
    <message>
        <source>0 or more is expected</source>
        <translation>0以上の値が必要です</translation>
    </message>
    <message>
        <source>a lower border of 0 or more and a higher upper one are expected</source>
        <translation>0以上の下限と、それより大きい上限が必要です</translation>
    </message>
    <message>
        <source>a torque in Nm or start is expected</source>
        <translation>トルク (Nm) または start が必要です</translation>
    </message>
    <message>
        <source>the touch is stiffer than the link allows: check contact distance and link stiffness</source>
        <translation>タッチがリンクの許す値より硬い結果です: 接触距離とリンク剛性を確認してください</translation>
    </message>
    <message>
        <source>Stiffness and material of an object from joint angle and torque during a touch</source>
        <translation>タッチ中の関節角度とトルクから求めた物体の剛性と材料</translation>
    </message>
    <message>
        <source>the torque jumps or falls back, or the joint has play</source>
        <translation>トルクが飛ぶか戻るか、関節に遊びがあります</translation>
    </message>
</context>
<context>
    <name>StimulusText</name>
    <message>
        <source>STOP was pressed</source>
        <translation>STOPが押されました</translation>
    </message>
    <message>
        <source>the bracelet was lost</source>
        <translation>ブレスレットとの接続が切れました</translation>
    </message>
    <message>
        <source>the pattern could not be played: %1</source>
        <translation>パターンを再生できませんでした: %1</translation>
    </message>
    <message>
        <source>something else stopped the bracelet</source>
        <translation>ほかの処理がブレスレットを停止しました</translation>
    </message>
    <message>
        <source>the bracelet is too hot</source>
        <translation>ブレスレットが熱すぎます</translation>
    </message>
    <message>
        <source>%1, ready</source>
        <comment>bracelet</comment>
        <translation>%1、準備完了</translation>
    </message>
    <message>
        <source>%1, ready; last stimulus: %2 frames, longest write %3 ms, %4 late, %5 lost</source>
        <comment>bracelet</comment>
        <translation>%1、準備完了。直前の刺激: %2フレーム、最長書き込み %3 ms、遅延 %4、損失 %5</translation>
    </message>
    <message>
        <source>the bracelet does not answer</source>
        <translation>ブレスレットが応答しません</translation>
    </message>
    <message>
        <source>something else used the bracelet</source>
        <translation>ほかの処理がブレスレットを使用しました</translation>
    </message>
    <message>
        <source>playback stalled for too long</source>
        <translation>再生が長く止まりすぎました</translation>
    </message>
    <message>
        <source>the bracelet did not start</source>
        <translation>ブレスレットが始動しませんでした</translation>
    </message>
    <message>
        <source>the bracelet rejected the stimulus</source>
        <translation>ブレスレットは刺激を解釈できず、拒否しました</translation>
    </message>
    <message>
        <source>the bracelet did not confirm the stimulus</source>
        <translation>ブレスレットが刺激の受信を確認しませんでした</translation>
    </message>
    <message>
        <source>No bracelet: this rehearsal is too fast to be played</source>
        <translation>ブレスレットなし: このリハーサルは速すぎるため再生できません</translation>
    </message>
    <message>
        <source>the folder of this pattern is unknown</source>
        <translation>このパターンがどのフォルダーにあるのかわかりません</translation>
    </message>
    <message>
        <source>the full path of the file</source>
        <translation>ファイルの絶対パス</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be moved to other tactors</source>
        <translation>「%1」はほかのタクタへ移せません</translation>
    </message>
    <message>
        <source>a stimulus without rings and strokes, or a track without tactors</source>
        <translation>リングとストロークのない刺激、またはタクタを指定しないトラック</translation>
    </message>
    <message>
        <source>the stimulus does not use tactor %1</source>
        <translation>刺激がタクタ%1を使用していません</translation>
    </message>
    <message>
        <source>a stimulus of one tactor, or of as many as the track names</source>
        <translation>タクタ1個の刺激、またはトラックに指定した数のタクタの刺激</translation>
    </message>
    <message numerus="yes">
        <source>%n object(s) of the stimulus have %1</source>
        <translation>
            <numerusform>刺激のオブジェクト%n個に%1があります</numerusform>
        </translation>
    </message>
    <message>
        <source>exactly one</source>
        <translation>ちょうど1個</translation>
    </message>
    <message>
        <source>the stimulus takes %1 s at level %2</source>
        <translation>レベル%2では刺激に%1 sかかります</translation>
    </message>
    <message>
        <source>at most stimulus_s, %1 s</source>
        <translation>stimulus_s以下、つまり%1 s以下</translation>
    </message>
</context>
<context>
    <name>StopMemoryText</name>
    <message>
        <source>this does not tell who engages STOP</source>
        <translation>誰がSTOPをかけているかが書かれていません</translation>
    </message>
    <message>
        <source>version 1, site, consoles</source>
        <translation>version 1、site、consoles</translation>
    </message>
</context>
<context>
    <name>StoreText</name>
    <message>
        <source>%1, process %2</source>
        <translation>%1、プロセス%2</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot name a participant</source>
        <translation>「%1」は参加者の名前に使えません</translation>
    </message>
    <message>
        <source>another name</source>
        <translation>別の名前</translation>
    </message>
    <message>
        <source>to try again</source>
        <translation>再試行</translation>
    </message>
    <message>
        <source>one session of a participant at a time</source>
        <translation>参加者ごとに同時に1つのセッション</translation>
    </message>
    <message>
        <source>another station</source>
        <translation>別のステーション</translation>
    </message>
    <message>
        <source>version %1 of the program, or a new study</source>
        <translation>バージョン %1 のプログラム、または新しいスタディ</translation>
    </message>
    <message>
        <source>a study of this name already exists</source>
        <translation>同じ名前の実験がすでにあります</translation>
    </message>
    <message>
        <source>a new name, or to continue the study</source>
        <translation>新しい名前、または既存の実験の続行</translation>
    </message>
    <message>
        <source>this folder already contains a study</source>
        <translation>このフォルダーにはすでに実験があります</translation>
    </message>
    <message>
        <source>a new folder, or to continue the study</source>
        <translation>新しいフォルダー、または既存の実験の続行</translation>
    </message>
    <message>
        <source>the study was not created completely</source>
        <translation>実験の作成が完了していません</translation>
    </message>
    <message>
        <source>another name: in files, %1 means no value or all participants</source>
        <translation>別の名前: ファイルでは %1 が値なしまたは全参加者を表します</translation>
    </message>
    <message>
        <source>the participant &quot;%1&quot; is already enrolled</source>
        <translation>参加者「%1」はすでに登録されています</translation>
    </message>
    <message>
        <source>other stations keep enrolling participants</source>
        <translation>ほかのステーションが絶えず参加者を登録しています</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is already in a session at %2</source>
        <translation>「%1」はすでにセッション中です (%2)</translation>
    </message>
    <message>
        <source>the patterns have changed since this study was created</source>
        <translation>パターンが、このスタディを始めたときのものと異なります</translation>
    </message>
    <message>
        <source>a text of 1 to %1 characters that does not begin with = + - or @</source>
        <translation>= + - @で始まらない1〜%1文字のテキスト</translation>
    </message>
</context>
<context>
    <name>StripTexts</name>
    <message>
        <source>Force</source>
        <translation>力</translation>
    </message>
    <message>
        <source>Position x</source>
        <translation>位置 x</translation>
    </message>
    <message>
        <source>Position y</source>
        <translation>位置 y</translation>
    </message>
    <message>
        <source>DZMP</source>
        <comment>deviation of the zero moment point: centre of pressure minus centre of contact</comment>
        <translation>DZMP</translation>
    </message>
    <message>
        <source>Orientation</source>
        <translation>向き</translation>
    </message>
    <message>
        <source>Spread</source>
        <comment>standard deviations of the touched area along its principal axes</comment>
        <translation>広がり</translation>
    </message>
    <message>
        <source>Edge ratio</source>
        <comment>ratio of the eigenvalues of the touched area</comment>
        <translation>エッジ比</translation>
    </message>
    <message>
        <source>Active taxels</source>
        <translation>有効タクセル</translation>
    </message>
    <message>
        <source>force</source>
        <translation>力</translation>
    </message>
    <message>
        <source>threshold</source>
        <comment>of one taxel</comment>
        <translation>しきい値</translation>
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
        <translation>有効</translation>
    </message>
    <message>
        <source>moment</source>
        <translation>モーメント</translation>
    </message>
    <message>
        <source>shear / load</source>
        <translation>せん断 / 荷重</translation>
    </message>
    <message>
        <source>Shear</source>
        <translation>せん断</translation>
    </message>
    <message>
        <source>Friction</source>
        <translation>摩擦</translation>
    </message>
</context>
<context>
    <name>StudyChecks</name>
    <message>
        <source>Protocol</source>
        <translation>プロトコル</translation>
    </message>
    <message>
        <source>no protocol is open</source>
        <translation>プロトコルが開かれていません</translation>
    </message>
    <message>
        <source>the protocol has no trials</source>
        <translation>プロトコルに試行がありません</translation>
    </message>
    <message>
        <source>Give practice or test at least one repetition.</source>
        <translation>練習またはテストに1回以上の反復を設定してください。</translation>
    </message>
    <message>
        <source>Participant</source>
        <translation>参加者</translation>
    </message>
    <message>
        <source>Choose a participant, or add a new one.</source>
        <translation>参加者を選ぶか、新しく追加してください。</translation>
    </message>
    <message>
        <source>Finish or abort the other session, or choose another participant.</source>
        <translation>もう一方のセッションを終えるか中止する、または別の参加者を選んでください。</translation>
    </message>
    <message>
        <source>%1 has finished this session</source>
        <translation>%1 はこのセッションを終えています</translation>
    </message>
    <message>
        <source>Choose the next session or another participant.</source>
        <translation>次のセッションまたは別の参加者を選んでください。</translation>
    </message>
    <message>
        <source>Bracelet</source>
        <translation>ブレスレット</translation>
    </message>
    <message>
        <source>the bracelet</source>
        <translation>ブレスレット</translation>
    </message>
    <message>
        <source>no bracelet is open</source>
        <translation>ブレスレットが開かれていません</translation>
    </message>
    <message>
        <source>Plug the bracelet in and choose it in the menu Bracelet.</source>
        <translation>ブレスレットを接続し、ブレスレットメニューで選んでください。</translation>
    </message>
    <message>
        <source>%1 does not answer</source>
        <translation>%1 が応答しません</translation>
    </message>
    <message>
        <source>STOP is engaged</source>
        <translation>STOPが作動中です</translation>
    </message>
    <message>
        <source>Release STOP when it is safe.</source>
        <translation>安全を確認してからSTOPを解除してください。</translation>
    </message>
    <message>
        <source>%1 is simulated: nobody can feel it</source>
        <translation>%1 はシミュレーションのため、誰も感じられません</translation>
    </message>
    <message>
        <source>Choose a real bracelet, or a pilot or simulated study.</source>
        <translation>実物のブレスレットを選ぶか、パイロットまたはシミュレーションの実験にしてください。</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>フォルダー</translation>
    </message>
    <message>
        <source>Connect the drive of the study, or choose another folder.</source>
        <translation>実験のドライブを接続するか、別のフォルダーを選んでください。</translation>
    </message>
    <message>
        <source>Allow writing to the folder, or choose another one.</source>
        <translation>フォルダーへの書き込みを許可するか、別のフォルダーを選んでください。</translation>
    </message>
    <message>
        <source>Disk space</source>
        <translation>ディスク容量</translation>
    </message>
    <message>
        <source>%1 MB are free</source>
        <translation>空き容量は %1 MBです</translation>
    </message>
    <message>
        <source>Data store</source>
        <translation>データストア</translation>
    </message>
    <message>
        <source>ready</source>
        <translation>準備完了</translation>
    </message>
    <message>
        <source>Make a copy of the study&apos;s folder and open the study again.</source>
        <translation>実験フォルダーのコピーを作り、実験を開き直してください。</translation>
    </message>
    <message>
        <source>Masking noise</source>
        <translation>マスキングノイズ</translation>
    </message>
    <message>
        <source>not needed: simulated participants hear nothing</source>
        <translation>不要: シミュレーション参加者には何も聞こえません</translation>
    </message>
    <message>
        <source>the protocol has none</source>
        <translation>プロトコルにありません</translation>
    </message>
    <message>
        <source>the noise is not confirmed</source>
        <translation>ノイズが確認されていません</translation>
    </message>
    <message>
        <source>Play the noise, measure its level at the ear, and confirm.</source>
        <translation>ノイズを再生し、耳元でレベルを測定して確認してください。</translation>
    </message>
    <message>
        <source>Play the noise, measure %1 dBA at the participant&apos;s ear, and confirm.</source>
        <translation>ノイズを再生し、参加者の耳元で %1 dBAを測定して確認してください。</translation>
    </message>
    <message>
        <source>confirmed</source>
        <translation>確認済み</translation>
    </message>
    <message>
        <source>Stimuli</source>
        <translation>刺激</translation>
    </message>
    <message>
        <source>Correct the protocol at this place and open it again.</source>
        <translation>プロトコルのこの箇所を修正し、開き直してください。</translation>
    </message>
    <message>
        <source>Open a protocol, or start with the paper&apos;s.</source>
        <translation>プロトコルを開くか、論文のプロトコルで始めてください。</translation>
    </message>
    <message>
        <source>there are no tactile patterns for %1</source>
        <translation>パターン %1 がありません</translation>
    </message>
    <message>
        <source>Create a study whose protocol names a file for each pattern that is not built in.</source>
        <translation>プログラムに付属していない各パターンのファイルを指定したプロトコルで、スタディを作成してください。</translation>
    </message>
    <message>
        <source>the patterns have changed since this study was created</source>
        <translation>パターンが、このスタディを始めたときのものと異なります</translation>
    </message>
    <message>
        <source>Use version %1 of the program, which created it, or create a new study.</source>
        <translation>このスタディを始めたバージョン %1 のプログラムで続けるか、新しいスタディを始めてください。</translation>
    </message>
    <message>
        <source>unchanged since the study was created</source>
        <translation>スタディを始めたときのもの</translation>
    </message>
    <message>
        <source>all there; whether they have changed since the study was created is unknown</source>
        <translation>すべてあります。スタディを始めたときのものと同じかどうかは不明です</translation>
    </message>
    <message>
        <source>no participant is selected</source>
        <translation>参加者が選ばれていません</translation>
    </message>
    <message>
        <source>%1 is already in a session</source>
        <translation>%1 はすでにセッション中です</translation>
    </message>
    <message>
        <source>%1 is already in a session at %2</source>
        <translation>%1 はすでにセッション中です (%2)</translation>
    </message>
    <message>
        <source>Check cable and power supply; it reconnects by itself.</source>
        <translation>ケーブルと電源を確認してください。復帰すると自動的に続行します。</translation>
    </message>
    <message>
        <source>%1 was not found</source>
        <translation>%1 がありません</translation>
    </message>
    <message>
        <source>cannot write to %1: %2</source>
        <translation>%1 に書き込めません: %2</translation>
    </message>
    <message>
        <source>Free up space to at least %1 MB, or choose another folder.</source>
        <translation>空きが %1 MBになるまで容量を確保するか、別のフォルダーを選んでください。</translation>
    </message>
    <message>
        <source>Start the server or repair the network connection, then try again.</source>
        <translation>サーバーを起動するかネットワークを修復してから、もう一度お試しください。</translation>
    </message>
    <message>
        <source>a motor takes %1 s to stop, and the gap between the intervals of %2 is %3 s</source>
        <translation>モーターの停止には%1 sかかりますが、%2の区間の間隔は%3 sです</translation>
    </message>
    <message>
        <source>Create a study with a longer gap (gap_s).</source>
        <translation>間隔 (gap_s) をより長くした実験を作成してください。</translation>
    </message>
    <message>
        <source>the line is being opened</source>
        <translation>回線を開いています</translation>
    </message>
    <message>
        <source>Wait a moment.</source>
        <translation>しばらくお待ちください。</translation>
    </message>
    <message>
        <source>the line cannot be used</source>
        <translation>回線を使用できません</translation>
    </message>
    <message>
        <source>Plug the device in and switch it on; it is tried again every second.</source>
        <translation>デバイスを接続して電源を入れてください。毎秒、自動的に再試行します。</translation>
    </message>
    <message>
        <source>Trigger</source>
        <translation>トリガー</translation>
    </message>
    <message>
        <source>the desktop keeps it on</source>
        <translation>デスクトップは画面をオンに保ちます</translation>
    </message>
    <message>
        <source>the desktop may turn it off during the session</source>
        <translation>デスクトップがセッション中に画面をオフにする可能性があります</translation>
    </message>
    <message>
        <source>Turn off the screen saver and energy saving of the desktop for the session.</source>
        <translation>セッションの間は、デスクトップのスクリーンセーバーと省電力機能をオフにしてください。</translation>
    </message>
    <message>
        <source>Screen</source>
        <translation>画面</translation>
    </message>
</context>
<context>
    <name>StudyCommand</name>
    <message>
        <source>%1 % correct (95 %: %2 to %3, %4 participants)</source>
        <translation>正答 %1 % (95 %: %2～%3、参加者%4名)</translation>
    </message>
    <message>
        <source>%1 % correct (one participant)</source>
        <translation>正答 %1 % (参加者1名)</translation>
    </message>
    <message>
        <source>F(%1, %2) = %3, p = %4</source>
        <translation>F(%1, %2) = %3, p = %4</translation>
    </message>
    <message>
        <source>Rehearse a user study with simulated participants, and analyse studies</source>
        <translation>シミュレーション参加者によるユーザー実験のリハーサルと、実験の解析</translation>
    </message>
    <message>
        <source>Run simulated participants through a whole study</source>
        <translation>シミュレーション参加者に実験全体を行わせます</translation>
    </message>
    <message>
        <source>Seed of all orders and answers</source>
        <translation>すべての順序と回答のシード</translation>
    </message>
    <message>
        <source>Share of the trials in which nothing is answered</source>
        <translation>無回答となる試行の割合</translation>
    </message>
    <message>
        <source>Folder of the new study</source>
        <translation>新しい実験のフォルダー</translation>
    </message>
    <message>
        <source>Go on with a rehearsal that was interrupted</source>
        <translation>中断されたリハーサルを続行する</translation>
    </message>
    <message>
        <source>Folder of the study</source>
        <translation>実験のフォルダー</translation>
    </message>
    <message>
        <source>Confusion matrices, accuracy, information transfer and ANOVA of studies or trial CSVs</source>
        <translation>実験または試行CSVの混同行列、正答率、情報伝達量、分散分析</translation>
    </message>
    <message>
        <source>Folders of studies, or CSVs with participant_id,task,condition,phase,stimulus,response</source>
        <translation>実験のフォルダー、または participant_id,task,condition,phase,stimulus,response のCSV</translation>
    </message>
    <message>
        <source>Only data of this mode; different modes are not merged</source>
        <translation>このモードのデータのみ。異なるモードは統合されません</translation>
    </message>
    <message>
        <source>Write the trials of a study as files into its folder</source>
        <translation>実験の試行をファイルとしてそのフォルダーに書き込みます</translation>
    </message>
    <message>
        <source>psychds: data/; bids: bids/; excel: excel/, with semicolons and the decimal sign of the locale</source>
        <translation>psychds: data/、bids: bids/、excel: excel/ (セミコロン区切り、ロケールの小数点記号)</translation>
    </message>
    <message>
        <source>Study</source>
        <translation>実験</translation>
    </message>
    <message>
        <source>Protocol</source>
        <translation>プロトコル</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>シード</translation>
    </message>
    <message>
        <source>Simulated participants</source>
        <translation>シミュレーション参加者</translation>
    </message>
    <message>
        <source>Trials</source>
        <translation>試行数</translation>
    </message>
    <message>
        <source>Of them kept before</source>
        <translation>うち保存済み</translation>
    </message>
    <message>
        <source>this is named twice</source>
        <translation>これは2回指定されています</translation>
    </message>
    <message>
        <source>each study and each file once</source>
        <translation>各実験と各ファイルは1回のみ</translation>
    </message>
    <message>
        <source>there are no completed trials</source>
        <translation>完了した試行がありません</translation>
    </message>
    <message>
        <source>trials that were answered or timed out</source>
        <translation>回答済みまたは時間切れの試行</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>形式</translation>
    </message>
    <message>
        <source>Sessions</source>
        <translation>セッション数</translation>
    </message>
    <message>
        <source>PostgreSQL server that has the study, postgresql://USER@HOST/DATABASE?study=NAME; the password comes from PGPASSWORD or ~/.pgpass. The folder gets the exports</source>
        <translation>実験を持つPostgreSQLサーバー、postgresql://USER@HOST/DATABASE?study=NAME。パスワードはPGPASSWORDまたは~/.pgpassから取得。エクスポートはフォルダーに保存</translation>
    </message>
    <message>
        <source>Formats of the figures, separated by commas</source>
        <translation>図の形式 (コンマ区切り)</translation>
    </message>
    <message>
        <source>Write pink noise that can be played in a loop</source>
        <translation>ループ再生できるピンクノイズを書き込みます</translation>
    </message>
    <message>
        <source>The sound file</source>
        <translation>音声ファイル</translation>
    </message>
    <message>
        <source>Root mean square against full scale, dB; how loud it is at the ear has to be measured</source>
        <translation>フルスケールに対する二乗平均平方根、dB。耳元での音量は測定が必要です</translation>
    </message>
    <message>
        <source>Seed of the noise</source>
        <translation>ノイズのシード</translation>
    </message>
    <message>
        <source>there is nothing to analyze</source>
        <translation>解析するものがありません</translation>
    </message>
    <message>
        <source>folders of studies, trial CSVs, or a server (--store)</source>
        <translation>実験のフォルダー、試行CSV、またはサーバー (--store)</translation>
    </message>
    <message>
        <source>Results of the study</source>
        <translation>実験の結果</translation>
    </message>
    <message>
        <source>File</source>
        <translation>ファイル</translation>
    </message>
    <message>
        <source>Period</source>
        <translation>周期</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>レベル</translation>
    </message>
    <message>
        <source>%1 dBFS</source>
        <translation>%1 dBFS</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>レポート</translation>
    </message>
    <message>
        <source>Tables and figures</source>
        <translation>表と図</translation>
    </message>
    <message>
        <source>Number of participants</source>
        <translation>参加人数</translation>
    </message>
    <message>
        <source>%1 bit measured</source>
        <translation>%1 bit (測定値)</translation>
    </message>
    <message>
        <source>%1 bit without bias (95 %: %2 to %3)</source>
        <translation>%1 bit、バイアス除去後 (95 %: %2～%3)</translation>
    </message>
    <message>
        <source>%1 bit without bias (95 %: at least %2)</source>
        <translation>%1 bit、バイアス除去後 (95 %: %2以上)</translation>
    </message>
    <message>
        <source>%1 bit without bias (95 %: at most %2)</source>
        <translation>%1 bit、バイアス除去後 (95 %: %2以下)</translation>
    </message>
    <message>
        <source>%1 of %2 trials left out</source>
        <translation>%2試行中%1試行を除外</translation>
    </message>
    <message>
        <source>%1; rule made after the data</source>
        <translation>%1。データ取得後に作られた規則</translation>
    </message>
    <message>
        <source>%1; no spread of the times, so nothing was left out, in %2 case(s)</source>
        <translation>%1。時間にばらつきがないため何も除外しなかった場合が%2件</translation>
    </message>
    <message>
        <source>%1, Holm over the patterns %2</source>
        <comment>F and p</comment>
        <translation>%1、パターンにわたるHolm %2</translation>
    </message>
    <message>
        <source>Thresholds, slopes and d&apos; of tasks with levels, by maximum likelihood</source>
        <translation>レベルのある課題のしきい値、傾き、d&apos;を最尤法で求めます</translation>
    </message>
    <message>
        <source>Write one participant&apos;s results as a page</source>
        <translation>1人の参加者の結果をページとして書き込みます</translation>
    </message>
    <message>
        <source>What the columns of all files of studies mean</source>
        <translation>実験の全ファイルの列の意味を書き込みます</translation>
    </message>
    <message>
        <source>Send one trial&apos;s triggers to another recorder</source>
        <translation>1試行分のトリガーを別の記録装置へ送信します</translation>
    </message>
    <message>
        <source>How many participants a test needs: power by simulated studies</source>
        <translation>検定に必要な参加者数: 実験のシミュレーションによる検出力</translation>
    </message>
    <message>
        <source>Protocol of the study, or the name of one that comes with the program: tactor-detection, intensity-steps, equal-strength, two-or-one, motion-timing; otherwise the paper&apos;s</source>
        <translation>実験のプロトコル、またはプログラムに付属するプロトコルの名前: tactor-detection, intensity-steps, equal-strength, two-or-one, motion-timing。省略時は論文のもの</translation>
    </message>
    <message>
        <source>Simulated participants in tasks with levels: threshold t and slope of their psychometric function, lapse rate, and sd of the threshold between them, in the scale of the levels</source>
        <translation>レベルのある課題でのシミュレーション参加者: 心理測定関数のしきい値tと傾きslope、ラプス率lapse、参加者間のしきい値の標準偏差sd。レベルの尺度で指定</translation>
    </message>
    <message>
        <source>Rule of what does not count, besides those of the protocol; marked as made after the data, for example response_time_below_s=0.2</source>
        <translation>プロトコルの規則に加える、集計対象から外すものの規則。データ取得後に作られたものとして示されます。例: response_time_below_s=0.2</translation>
    </message>
    <message>
        <source>Folder for report.html, confusion_long.csv, summary.csv, group.csv, anova.csv, thresholds.csv, levels.csv, sdt.csv, comparisons.csv, ranks.csv, binomial_model.csv, response_times.csv, exclusions.csv, figures</source>
        <translation>report.html, confusion_long.csv, summary.csv, group.csv, anova.csv, thresholds.csv, levels.csv, sdt.csv, comparisons.csv, ranks.csv, binomial_model.csv, response_times.csv, exclusions.csv, 図のフォルダー</translation>
    </message>
    <message>
        <source>the exclusion rules leave no completed trial</source>
        <translation>除外規則を適用すると、完了した試行が残りません</translation>
    </message>
    <message>
        <source>rules that leave some</source>
        <translation>試行が残る規則</translation>
    </message>
    <message>
        <source>there are no test trials, only practice: the report has no results</source>
        <translation>テスト試行がなく、練習のみです: レポートに結果はありません</translation>
    </message>
    <message>
        <source>the answer &quot;%1&quot; counts as wrong: the pattern is &quot;%2&quot;</source>
        <translation>回答「%1」は誤答として数えられます: パターンは「%2」です</translation>
    </message>
    <message>
        <source>--exclude cannot be applied to this file</source>
        <translation>--excludeはこのファイルに適用できません</translation>
    </message>
    <message>
        <source>the columns stimulus and response</source>
        <translation>列stimulusとresponse</translation>
    </message>
    <message>
        <source>List the participants of a study, and who was deleted</source>
        <translation>実験の参加者と、削除された参加者を一覧表示する</translation>
    </message>
    <message>
        <source>Enrol a participant under a pseudonym</source>
        <translation>参加者を仮名で登録する</translation>
    </message>
    <message>
        <source>Delete a participant with everything that was kept</source>
        <translation>保存されたすべてのデータとともに参加者を削除する</translation>
    </message>
    <message>
        <source>Let others read what is written, as the umask allows; otherwise it is for you alone</source>
        <translation>書き込むものを、umaskの許す範囲で他の人も読めるようにする。指定しなければ自分だけが読める</translation>
    </message>
</context>
<context>
    <name>StudyExport</name>
    <message>
        <source>the study has no participant &quot;%1&quot;</source>
        <translation>実験に参加者「%1」がいません</translation>
    </message>
    <message>
        <source>the file differs from what was written</source>
        <translation>ファイルの内容が書き込んだものと異なります</translation>
    </message>
    <message>
        <source>cannot remove the file: %1</source>
        <translation>ファイルを削除できません: %1</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is in a session at %2</source>
        <translation>「%1」は%2でセッション中です</translation>
    </message>
    <message>
        <source>a participant who is in no session</source>
        <translation>セッション中でない参加者</translation>
    </message>
    <message>
        <source>the file cannot be opened to others: %1</source>
        <translation>ファイルを他の人に公開できません: %1</translation>
    </message>
</context>
<context>
    <name>StudyFigure</name>
    <message>
        <source>PILOT</source>
        <translation>パイロット</translation>
    </message>
    <message>
        <source>SIMULATED</source>
        <translation>シミュレーション</translation>
    </message>
</context>
<context>
    <name>StudyFitCommand</name>
    <message>
        <source>; the curve does not fit: p of the deviance %1</source>
        <translation>; 曲線は適合していません: 逸脱度のp %1</translation>
    </message>
    <message>
        <source>Mean of %1</source>
        <translation>%1名の平均</translation>
    </message>
    <message>
        <source>%1 (%2 to %3)</source>
        <translation>%1 (%2～%3)</translation>
    </message>
    <message>
        <source>no d&apos;: trials of one kind are missing</source>
        <translation>d&apos;なし: 一方の種類の試行がありません</translation>
    </message>
    <message>
        <source>d&apos; %1, c %2</source>
        <translation>d&apos; %1、c %2</translation>
    </message>
    <message>
        <source>d&apos; %1</source>
        <translation>d&apos; %1</translation>
    </message>
    <message>
        <source>Folder of a study, or a CSV with participant_id,task,condition,phase,track,level,correct</source>
        <translation>実験のフォルダー、または participant_id,task,condition,phase,track,level,correct のCSV</translation>
    </message>
    <message>
        <source>PostgreSQL server that has the study, postgresql://USER@HOST/DATABASE?study=NAME</source>
        <translation>実験を持つPostgreSQLサーバー、postgresql://USER@HOST/DATABASE?study=NAME</translation>
    </message>
    <message>
        <source>Function that is fitted; otherwise weibull for detection on a logarithmic scale, else gauss</source>
        <translation>当てはめる関数。省略時は、対数尺度の検出ではweibull、それ以外ではgauss</translation>
    </message>
    <message>
        <source>Share of right answers without a stimulus; otherwise from the design</source>
        <translation>刺激がないときの正答の割合。省略時はデザインから決定</translation>
    </message>
    <message>
        <source>Share of mistakes with any stimulus: fixed, or the range in which it is free; otherwise 0:0.06</source>
        <translation>どのような刺激でも生じる誤りの割合: 固定値、または自由に推定する範囲。省略時は0:0.06</translation>
    </message>
    <message>
        <source>How the interval of a threshold is computed</source>
        <translation>しきい値の区間の計算方法</translation>
    </message>
    <message>
        <source>Folder for thresholds.csv, levels.csv, sdt.csv, analysis.R and figures</source>
        <translation>thresholds.csv, levels.csv, sdt.csv, analysis.R, 図のフォルダー</translation>
    </message>
    <message>
        <source>--lapse cannot be &quot;%1&quot;</source>
        <translation>--lapseを「%1」にはできません</translation>
    </message>
    <message>
        <source>a share from 0 to 0.4, or two with a colon between them, the lower one first</source>
        <translation>0から0.4までの割合、またはコロンで区切った2つの割合 (小さいほうが先)</translation>
    </message>
    <message>
        <source>there are no test trials with a level</source>
        <translation>レベルのあるテスト試行がありません</translation>
    </message>
    <message>
        <source>trials of a design with levels, or a column level</source>
        <translation>レベルのあるデザインの試行、または列level</translation>
    </message>
    <message>
        <source>nothing says how often guessing is right in task %1</source>
        <translation>課題%1で当て推量が正解する割合が、どこにも示されていません</translation>
    </message>
    <message>
        <source>--guess (0.5 for two intervals, 0.02 for yes and no), or a column design or n_alternatives</source>
        <translation>--guess (2区間では0.5、はい/いいえでは0.02)、または列designかn_alternatives</translation>
    </message>
    <message>
        <source>Tables and figures</source>
        <translation>表と図</translation>
    </message>
    <message>
        <source>One fit of %1</source>
        <translation>%1名の一括当てはめ</translation>
    </message>
    <message>
        <source>%1, sd of the participants %2</source>
        <translation>%1、参加者間の標準偏差 %2</translation>
    </message>
    <message>
        <source>%1 steps of intensity from start to full</source>
        <translation>始動点から最大までに強度%1段階</translation>
    </message>
    <message>
        <source>most yes at %1 s (%2 to %3)</source>
        <translation>「はい」が最も多いのは%1 s (%2～%3)</translation>
    </message>
</context>
<context>
    <name>StudyNames</name>
    <message>
        <source>Object shape</source>
        <translation>物体の形状</translation>
    </message>
    <message>
        <source>circle</source>
        <translation>円</translation>
    </message>
    <message>
        <source>rectangle</source>
        <translation>長方形</translation>
    </message>
    <message>
        <source>triangle</source>
        <translation>三角形</translation>
    </message>
    <message>
        <source>arc</source>
        <translation>円弧</translation>
    </message>
    <message>
        <source>line</source>
        <translation>線</translation>
    </message>
    <message>
        <source>point</source>
        <translation>点</translation>
    </message>
    <message>
        <source>static</source>
        <translation>静的</translation>
    </message>
    <message>
        <source>dynamic</source>
        <translation>動的</translation>
    </message>
    <message>
        <source>Object stiffness</source>
        <translation>物体の剛性</translation>
    </message>
    <message>
        <source>sponge</source>
        <translation>スポンジ</translation>
    </message>
    <message>
        <source>rubber sponge</source>
        <translation>ゴムスポンジ</translation>
    </message>
    <message>
        <source>rubber</source>
        <translation>ゴム</translation>
    </message>
    <message>
        <source>wood</source>
        <translation>木</translation>
    </message>
    <message>
        <source>metal</source>
        <translation>金属</translation>
    </message>
    <message>
        <source>Tactor detection</source>
        <translation>タクタの検出</translation>
    </message>
    <message>
        <source>rest</source>
        <translation>安静</translation>
    </message>
    <message>
        <source>In which interval did you feel a vibration?</source>
        <translation>どの区間で振動を感じましたか?</translation>
    </message>
    <message>
        <source>Intensity steps</source>
        <translation>強度のステップ</translation>
    </message>
    <message>
        <source>weak</source>
        <translation>弱</translation>
    </message>
    <message>
        <source>medium</source>
        <translation>中</translation>
    </message>
    <message>
        <source>strong</source>
        <translation>強</translation>
    </message>
    <message>
        <source>Which interval was stronger?</source>
        <translation>どの区間がより強かったですか?</translation>
    </message>
    <message>
        <source>Equal strength</source>
        <translation>等しい強さ</translation>
    </message>
    <message>
        <source>Two or one</source>
        <translation>2つか1つか</translation>
    </message>
    <message>
        <source>Did you feel two separate taps?</source>
        <translation>別々の2回のタップを感じましたか?</translation>
    </message>
    <message>
        <source>Motion timing</source>
        <translation>運動のタイミング</translation>
    </message>
    <message>
        <source>Did you feel one moving point?</source>
        <translation>動く1つの点を感じましたか?</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>はい</translation>
    </message>
    <message>
        <source>no</source>
        <translation>いいえ</translation>
    </message>
    <message>
        <source>same</source>
        <translation>同じ</translation>
    </message>
    <message>
        <source>different</source>
        <translation>異なる</translation>
    </message>
    <message>
        <source>Was there a vibration?</source>
        <translation>振動はありましたか?</translation>
    </message>
    <message>
        <source>Which interval had the vibration?</source>
        <translation>振動はどの区間にありましたか?</translation>
    </message>
    <message>
        <source>Were the two intervals the same?</source>
        <translation>2つの区間は同じでしたか?</translation>
    </message>
    <message>
        <source>Which interval had more?</source>
        <translation>どの区間がより大きかったですか?</translation>
    </message>
    <message>
        <source>drive</source>
        <comment>unit of a level</comment>
        <translation>駆動</translation>
    </message>
    <message>
        <source>balance</source>
        <comment>unit of a level</comment>
        <translation>バランス</translation>
    </message>
</context>
<context>
    <name>StudyNoise</name>
    <message>
        <source>an even number of samples up to %1, and frequencies above 0 up to half the rate</source>
        <translation>%1以下の偶数のサンプル数と、0より大きくレートの半分以下の周波数</translation>
    </message>
    <message>
        <source>more samples or a wider band</source>
        <translation>より多くのサンプル、またはより広い帯域</translation>
    </message>
    <message>
        <source>the noise would be clipped at this level</source>
        <translation>このレベルではノイズがクリップします</translation>
    </message>
    <message>
        <source>a level of %1 dBFS at most</source>
        <translation>%1 dBFS以下のレベル</translation>
    </message>
    <message>
        <source>the sound is too long for a WAV file</source>
        <translation>音声がWAVファイルには長すぎます</translation>
    </message>
    <message>
        <source>at most 4 GiB of samples</source>
        <translation>サンプル4 GiB以下</translation>
    </message>
    <message>
        <source>the noise settings are out of range</source>
        <translation>ノイズの設定が範囲外です</translation>
    </message>
    <message>
        <source>the band contains no frequency</source>
        <translation>この帯域に周波数がありません</translation>
    </message>
</context>
<context>
    <name>StudyPapers</name>
    <message>
        <source>Folder of the study</source>
        <translation>実験のフォルダー</translation>
    </message>
    <message>
        <source>Whose report it is</source>
        <translation>レポートの対象となる参加者</translation>
    </message>
    <message>
        <source>experimenter: everything of this participant; participant: their own answers in plain words</source>
        <translation>experimenter: この参加者のすべての内容。participant: 本人の回答のみを平易な言葉で</translation>
    </message>
    <message>
        <source>The page; otherwise report-ID.html or report-ID-participant.html in the folder of the study</source>
        <translation>書き込むページ。省略時は実験のフォルダー内のreport-ID.htmlまたはreport-ID-participant.html</translation>
    </message>
    <message>
        <source>PostgreSQL server that has the study, postgresql://USER@HOST/DATABASE?study=NAME; the password comes from PGPASSWORD or ~/.pgpass</source>
        <translation>実験を持つPostgreSQLサーバー、postgresql://USER@HOST/DATABASE?study=NAME。パスワードはPGPASSWORDまたは~/.pgpassから取得</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>レポート</translation>
    </message>
    <message>
        <source>Folder of a study, whose questionnaires are described too</source>
        <translation>実験のフォルダー。その質問票も説明に含めます</translation>
    </message>
    <message>
        <source>Where one trial&apos;s events go: a serial port such as /dev/ttyUSB0, or HOST:PORT for OSC by UDP</source>
        <translation>1試行分のイベントの送信先: シリアルポート (例: /dev/ttyUSB0)、またはUDPによるOSCではHOST:PORT</translation>
    </message>
    <message>
        <source>written in %1 ms</source>
        <translation>%1 msで書き込み</translation>
    </message>
</context>
<context>
    <name>StudyPeople</name>
    <message>
        <source>Folder of the study</source>
        <translation>実験のフォルダー</translation>
    </message>
    <message>
        <source>PostgreSQL server that has the study, postgresql://USER@HOST/DATABASE?study=NAME</source>
        <translation>実験のあるPostgreSQLサーバー、postgresql://USER@HOST/DATABASE?study=NAME</translation>
    </message>
    <message>
        <source>Also say who is behind the pseudonyms</source>
        <translation>仮名が誰のものかも表示する</translation>
    </message>
    <message>
        <source>Name of the participant in the study; otherwise a pseudonym at random</source>
        <translation>実験での参加者の名前。指定しなければ無作為な仮名</translation>
    </message>
    <message>
        <source>File that keeps who is behind the pseudonyms, for you alone; not in the study&apos;s folder</source>
        <translation>仮名が誰のものかを保存する、自分だけのファイル。実験のフォルダーの外に置く</translation>
    </message>
    <message>
        <source>Name of the person, for the key</source>
        <translation>鍵に書く本人の名前</translation>
    </message>
    <message>
        <source>How to reach the person, for the key</source>
        <translation>鍵に書く本人の連絡先</translation>
    </message>
    <message>
        <source>Whom to delete</source>
        <translation>削除する参加者</translation>
    </message>
    <message>
        <source>Delete the person from this key as well</source>
        <translation>この鍵からも本人を削除する</translation>
    </message>
    <message>
        <source>Why, for the record that stays; without anything that tells who it was</source>
        <translation>残る記録のための理由。誰であったかがわかることは書かない</translation>
    </message>
    <message>
        <source>Really delete: this cannot be undone</source>
        <translation>本当に削除する: 元に戻せません</translation>
    </message>
    <message numerus="yes">
        <source>%n session(s)</source>
        <translation>
            <numerusform>%nセッション</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n trial(s)</source>
        <translation>
            <numerusform>%n試行</numerusform>
        </translation>
    </message>
    <message>
        <source>Deleted</source>
        <translation>削除済み</translation>
    </message>
    <message numerus="yes">
        <source>number %1 of the enrolment, on %2, %n trial(s)</source>
        <translation>
            <numerusform>登録番号%1、%2、%n試行</numerusform>
        </translation>
    </message>
    <message>
        <source>Nobody is enrolled.</source>
        <translation>登録されている人はいません。</translation>
    </message>
    <message>
        <source>the key that keeps it is missing: --key with a file apart from the study</source>
        <translation>それを保存する鍵がありません: --keyに実験とは別のファイルを指定してください</translation>
    </message>
    <message>
        <source>the name of the person is missing: --name</source>
        <translation>本人の名前がありません: --name</translation>
    </message>
    <message>
        <source>Participant</source>
        <translation>参加者</translation>
    </message>
    <message>
        <source>Number of the enrolment</source>
        <translation>登録番号</translation>
    </message>
    <message>
        <source>Removed</source>
        <translation>取り除いたもの</translation>
    </message>
    <message>
        <source>Key</source>
        <translation>鍵</translation>
    </message>
    <message>
        <source>the person was deleted</source>
        <translation>本人を削除しました</translation>
    </message>
    <message>
        <source>has no such person</source>
        <translation>該当する人はいませんでした</translation>
    </message>
    <message>
        <source>Still counts the participant</source>
        <translation>まだこの参加者を数えています</translation>
    </message>
    <message>
        <source>Analyze the study again, and delete what was copied elsewhere.</source>
        <translation>実験を分析し直し、ほかにコピーしたものを削除してください。</translation>
    </message>
    <message>
        <source>it is missing, and all sessions, answers, notes, recordings and exported files of &quot;%1&quot; would be deleted, which cannot be undone</source>
        <translation>指定がありません。「%1」のすべてのセッション、回答、メモ、記録、エクスポートされたファイルが削除され、元に戻せません</translation>
    </message>
    <message numerus="yes">
        <source>%n file(s)</source>
        <translation>
            <numerusform>%n個のファイル</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>StudyPictures</name>
    <message>
        <source>feel</source>
        <translation>感じる</translation>
    </message>
    <message>
        <source>answer</source>
        <translation>答える</translation>
    </message>
    <message>
        <source>result</source>
        <translation>結果</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>right answers to dynamic shapes</source>
        <translation>動的な形状の正答率</translation>
    </message>
</context>
<context>
    <name>StudyPlan</name>
    <message>
        <source>the protocol has no task &quot;%1&quot;</source>
        <translation>プロトコルに課題「%1」がありません</translation>
    </message>
    <message>
        <source>TASK:EFFECT with one of %1</source>
        <translation>TASK:EFFECT。EFFECTは次のいずれか: %1</translation>
    </message>
    <message>
        <source>the task %1 measures levels</source>
        <translation>課題%1はレベルを測定するものです</translation>
    </message>
    <message>
        <source>a task in which patterns are told apart</source>
        <translation>パターンを識別する課題</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no line of the analysis of %2</source>
        <translation>「%1」は%2の分析の行ではありません</translation>
    </message>
    <message>
        <source>condition, pattern, condition:pattern, or condition@PATTERN</source>
        <translation>condition、pattern、condition:pattern、またはcondition@PATTERN</translation>
    </message>
    <message>
        <source>pattern</source>
        <translation>pattern</translation>
    </message>
    <message>
        <source>the protocol has no test trials</source>
        <translation>プロトコルにテスト試行がありません</translation>
    </message>
    <message>
        <source>test.repetitions above 0</source>
        <translation>0より大きいtest.repetitions</translation>
    </message>
    <message>
        <source>the task %1 has no pattern &quot;%2&quot;</source>
        <translation>課題%1にパターン「%2」がありません</translation>
    </message>
    <message>
        <source>one of its letters</source>
        <translation>その課題の文字のいずれか</translation>
    </message>
    <message>
        <source>the truth says nothing of the task %1</source>
        <translation>真値に課題%1の記述がありません</translation>
    </message>
    <message>
        <source>a [[task]] with that id</source>
        <translation>そのidを持つ[[task]]</translation>
    </message>
    <message>
        <source>the truth says nothing of %1 under %2</source>
        <translation>真値に、条件%2での%1の記述がありません</translation>
    </message>
    <message>
        <source>a condition with that id</source>
        <translation>そのidを持つ条件</translation>
    </message>
</context>
<context>
    <name>StudyPlanCommand</name>
    <message>
        <source>no number up to %1 reaches %2 %</source>
        <translation>%1名以下では%2 %に達しません</translation>
    </message>
    <message>
        <source>%1 or %2 participants; %3 studies cannot tell which</source>
        <translation>%1名または%2名。%3回の実験ではどちらか決まりません</translation>
    </message>
    <message>
        <source>%1 participants reach %2 %</source>
        <translation>%1名の参加者で%2 %に達します</translation>
    </message>
    <message>
        <source>Protocol of the study</source>
        <translation>実験のプロトコル</translation>
    </message>
    <message>
        <source>Numbers of participants to try: from, to, step</source>
        <translation>試す参加者数: 開始、終了、刻み</translation>
    </message>
    <message>
        <source>What is assumed: a file with shares of right answers and spreads, or the folder of a pilot study</source>
        <translation>仮定する内容: 正答の割合とばらつきを記したファイル、またはパイロット実験のフォルダー</translation>
    </message>
    <message>
        <source>Seed of all studies</source>
        <translation>すべての実験のシード</translation>
    </message>
    <message>
        <source>Wanted share of significant studies</source>
        <translation>有意となる実験の割合の目標</translation>
    </message>
    <message>
        <source>Table of the power, CSV</source>
        <translation>検出力の表、CSV</translation>
    </message>
    <message>
        <source>%1 is not FROM:TO:STEP with numbers from 1 to %2</source>
        <translation>%1 はFROM:TO:STEPの形式で、1から%2までの数を指定したものではありません</translation>
    </message>
    <message>
        <source>Test</source>
        <translation>検定</translation>
    </message>
    <message>
        <source>%1 % (95 %: %2 to %3, %4 studies)</source>
        <translation>%1 % (95 %: %2～%3、%4実験)</translation>
    </message>
    <message>
        <source>%1; no analysis in %2 of them</source>
        <translation>%1。うち%2件は分析なし</translation>
    </message>
    <message>
        <source>%1 participants</source>
        <translation>参加者%1名</translation>
    </message>
    <message>
        <source>Answer</source>
        <translation>答え</translation>
    </message>
    <message>
        <source>Table</source>
        <translation>表</translation>
    </message>
    <message>
        <source>Line of the analysis: shape:condition, shape:pattern, shape:condition:pattern, or shape:condition@A within pattern A; or detect:threshold for the interval of a threshold</source>
        <translation>分析の行: shape:condition、shape:pattern、shape:condition:pattern、またはパターンA内ではshape:condition@A。しきい値の区間ではdetect:threshold</translation>
    </message>
    <message>
        <source>Of a threshold: how far its 95 % interval may reach to each side, on the scale of the levels (0.1 log10 units are a factor of 1.26)</source>
        <translation>しきい値の場合: 95 %区間が両側にそれぞれどこまで広がってよいか、レベルの尺度上の値 (log10の単位で0.1は1.26倍)</translation>
    </message>
    <message>
        <source>Of a threshold: trials of a track, of constant stimuli at each level; otherwise the protocol&apos;s</source>
        <translation>しきい値の場合: トラックの試行数、恒常法では各レベルの試行数。省略時はプロトコルの値</translation>
    </message>
    <message>
        <source>Studies drawn for each number; otherwise 10000, for thresholds 1000</source>
        <translation>参加者数ごとに生成する実験の数。省略時は10000、しきい値では1000</translation>
    </message>
</context>
<context>
    <name>StudyProtocol</name>
    <message>
        <source>&quot;%1&quot; means no answer</source>
        <translation>「%1」は無回答を意味します</translation>
    </message>
    <message>
        <source>another letter</source>
        <translation>別の文字</translation>
    </message>
    <message>
        <source>there are too many patterns</source>
        <translation>パターンが多すぎます</translation>
    </message>
    <message>
        <source>at most %1, one digit each</source>
        <translation>%1以下、それぞれに数字キー1つ</translation>
    </message>
    <message>
        <source>%1 is not one more tactor</source>
        <translation>%1 は新たなタクタの番号ではありません</translation>
    </message>
    <message>
        <source>whole numbers from 1 to %1, each once</source>
        <translation>1から%1までの整数、それぞれ1回のみ</translation>
    </message>
    <message>
        <source>there are too many tracks</source>
        <translation>トラックが多すぎます</translation>
    </message>
    <message>
        <source>at most %1</source>
        <translation>%1以下</translation>
    </message>
    <message>
        <source>%1 is not among the levels</source>
        <translation>%1 はレベルの範囲にありません</translation>
    </message>
    <message>
        <source>from lowest to highest, %1 to %2</source>
        <translation>最低から最高まで、%1から%2</translation>
    </message>
    <message>
        <source>the lowest level is not below the highest</source>
        <translation>最低レベルが最高レベルより低くありません</translation>
    </message>
    <message>
        <source>a number below %1</source>
        <translation>%1未満の数</translation>
    </message>
    <message>
        <source>0 has no place on a scale of logarithms</source>
        <translation>対数尺度に0は置けません</translation>
    </message>
    <message>
        <source>a number above 0, or the scale linear</source>
        <translation>0より大きい数、または尺度linear</translation>
    </message>
    <message>
        <source>a level of %1 cannot be shown</source>
        <translation>レベル%1は提示できません</translation>
    </message>
    <message>
        <source>there is nothing to compare with</source>
        <translation>比較の対象がありません</translation>
    </message>
    <message>
        <source>a reference above 0, here or in each condition</source>
        <translation>0より大きい基準 (ここ、または各条件で指定)</translation>
    </message>
    <message>
        <source>the levels do not rise</source>
        <translation>レベルが昇順になっていません</translation>
    </message>
    <message>
        <source>each level above the one before</source>
        <translation>直前のレベルより大きいレベル</translation>
    </message>
    <message>
        <source>weibull has no place for a level of 0</source>
        <translation>レベル0にはweibullを使えません</translation>
    </message>
    <message>
        <source>gauss or logistic, or a lowest level above 0</source>
        <translation>gaussまたはlogistic、または0より大きい最低レベル</translation>
    </message>
    <message>
        <source>a prior needs its mean and its standard deviation</source>
        <translation>事前分布には平均と標準偏差が必要です</translation>
    </message>
    <message>
        <source>prior_mean and prior_sd</source>
        <translation>prior_meanとprior_sd</translation>
    </message>
    <message>
        <source>too few reversals for an estimate</source>
        <translation>推定するには反転が少なすぎます</translation>
    </message>
    <message>
        <source>at least %1</source>
        <translation>%1以上</translation>
    </message>
    <message>
        <source>constant stimuli need their levels</source>
        <translation>恒常法にはレベルの指定が必要です</translation>
    </message>
    <message>
        <source>values in level, 1 to %1 of them</source>
        <translation>levelのvalues、1～%1個</translation>
    </message>
    <message>
        <source>answers to this design count from the end of the last interval</source>
        <translation>この課題形式では、回答時間は最後の区間の終了から数えます</translation>
    </message>
    <message>
        <source>response_window = &quot;from_end&quot;</source>
        <translation>response_window = &quot;from_end&quot;</translation>
    </message>
    <message>
        <source>patterns have no reference</source>
        <translation>パターンには基準がありません</translation>
    </message>
    <message>
        <source>conditions without reference</source>
        <translation>基準のない条件</translation>
    </message>
</context>
<context>
    <name>StudyQuestionnaire</name>
    <message>
        <source>&quot;%1&quot; is not answered</source>
        <translation>「%1」が未回答です</translation>
    </message>
    <message>
        <source>an answer</source>
        <translation>回答</translation>
    </message>
    <message>
        <source>the answer to &quot;%1&quot; is too long</source>
        <translation>「%1」への回答が長すぎます</translation>
    </message>
    <message>
        <source>%1 characters at most</source>
        <translation>%1文字以下</translation>
    </message>
    <message>
        <source>a number from 1 to %1</source>
        <translation>1から%1までの数値</translation>
    </message>
    <message>
        <source>one of the choices</source>
        <translation>選択肢のいずれか</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be answered with &quot;%2&quot;</source>
        <translation>「%1」に「%2」とは回答できません</translation>
    </message>
    <message>
        <source>the answers do not match this questionnaire</source>
        <translation>この質問票の回答ではありません</translation>
    </message>
    <message>
        <source>one answer per item, in order</source>
        <translation>項目ごとに1つの回答 (項目順)</translation>
    </message>
    <message>
        <source>a pair has two choices</source>
        <translation>ペアの選択肢は2つです</translation>
    </message>
    <message>
        <source>two of them</source>
        <translation>そのうちの2つ</translation>
    </message>
    <message>
        <source>a number from 0 to 100 in steps of 5</source>
        <translation>0から100までの5刻みの数値</translation>
    </message>
</context>
<context>
    <name>StudyRehearsal</name>
    <message>
        <source>this study has real participants</source>
        <translation>この実験には実際の参加者がいます</translation>
    </message>
    <message>
        <source>a study created as a rehearsal</source>
        <translation>リハーサルとして始めた実験</translation>
    </message>
</context>
<context>
    <name>StudyScene</name>
    <message>
        <source>the effect is listed twice</source>
        <translation>効果が2回指定されています</translation>
    </message>
    <message>
        <source>each effect at most once</source>
        <translation>各効果は1回まで</translation>
    </message>
</context>
<context>
    <name>StudyScenes</name>
    <message>
        <source>%1, %2</source>
        <comment>task, condition</comment>
        <translation>%1、%2</translation>
    </message>
    <message numerus="yes">
        <source>%1: %n pattern(s); %2</source>
        <comment>task; conditions</comment>
        <translation>
            <numerusform>%1: %nパターン、%2</numerusform>
        </translation>
    </message>
    <message>
        <source>Stimulus %1 s, answer within %2 s %3</source>
        <comment>numbers; of what</comment>
        <translation>刺激 %1 s、回答は%3から%2 s以内</translation>
    </message>
    <message>
        <source>of its onset</source>
        <translation>開始</translation>
    </message>
    <message>
        <source>of its end</source>
        <translation>終了</translation>
    </message>
    <message>
        <source>Pink noise, %1 dBA</source>
        <translation>ピンクノイズ、%1 dBA</translation>
    </message>
    <message>
        <source>Seed %1</source>
        <translation>シード %1</translation>
    </message>
    <message>
        <source>running</source>
        <translation>実行中</translation>
    </message>
    <message>
        <source>✓ finished</source>
        <translation>✓ 完了</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <comment>trials kept</comment>
        <translation>%1/%2</translation>
    </message>
    <message>
        <source>to do</source>
        <translation>未実施</translation>
    </message>
    <message>
        <source>%1 — %2</source>
        <comment>participant, session</comment>
        <translation>%1 — %2</translation>
    </message>
    <message>
        <source>Session %1 of %2, row %3 of the Williams square</source>
        <translation>セッション%1/%2、Williams方格の行%3</translation>
    </message>
    <message>
        <source>Halt the rehearsal</source>
        <translation>リハーサルを停止</translation>
    </message>
    <message>
        <source>This session is finished.</source>
        <translation>このセッションは完了しました。</translation>
    </message>
    <message>
        <source>Show the results</source>
        <translation>結果を表示</translation>
    </message>
    <message>
        <source>All sessions of all participants are finished.</source>
        <translation>全参加者の全セッションが完了しました。</translation>
    </message>
    <message>
        <source>Add a participant</source>
        <translation>参加者を追加</translation>
    </message>
    <message>
        <source>Choose another participant</source>
        <translation>別の参加者を選択</translation>
    </message>
    <message>
        <source>This participant has finished all sessions.</source>
        <translation>この参加者は全セッションを終えています。</translation>
    </message>
    <message>
        <source>The simulated participant fills in “%1”.</source>
        <translation>シミュレーション参加者が「%1」に記入しています。</translation>
    </message>
    <message>
        <source>The participant fills in “%1”.</source>
        <translation>参加者が「%1」に記入しています。</translation>
    </message>
    <message>
        <source>Show the questionnaire</source>
        <translation>質問票を表示</translation>
    </message>
    <message>
        <source>Practice</source>
        <translation>練習</translation>
    </message>
    <message>
        <source>Test</source>
        <translation>テスト</translation>
    </message>
    <message>
        <source>Go on</source>
        <translation>続行</translation>
    </message>
    <message>
        <source>Paused.</source>
        <translation>一時停止中です。</translation>
    </message>
    <message>
        <source>Practice is over. In the test there is no feedback unless the protocol says so.</source>
        <translation>練習は終わりました。プロトコルに指定がない限り、テストではフィードバックはありません。</translation>
    </message>
    <message>
        <source>Go on after STOP</source>
        <translation>STOP後に続行</translation>
    </message>
    <message>
        <source>The stimulus was interrupted: %1. The trial will be shown again.</source>
        <translation>刺激が中断されました: %1。この試行は再び提示されます。</translation>
    </message>
    <message>
        <source>Hold the STOP button for a second to release it.</source>
        <translation>解除するには、STOPボタンを1秒間押し続けてください。</translation>
    </message>
    <message>
        <source>Leave this session</source>
        <translation>このセッションを離れる</translation>
    </message>
    <message>
        <source>This session is finished. Thank the participant.</source>
        <translation>このセッションは完了しました。参加者にお礼を伝えてください。</translation>
    </message>
    <message>
        <source>Ready for the next trial.</source>
        <translation>次の試行の準備ができました。</translation>
    </message>
    <message>
        <source>The right answer is shown.</source>
        <translation>正解を表示しています。</translation>
    </message>
    <message>
        <source>Waiting for the answer.</source>
        <translation>回答を待っています。</translation>
    </message>
    <message>
        <source>A pause follows.</source>
        <translation>この後は休憩です。</translation>
    </message>
    <message>
        <source>%1, test</source>
        <translation>%1、テスト</translation>
    </message>
    <message>
        <source>%1, practice</source>
        <translation>%1、練習</translation>
    </message>
    <message>
        <source>End the rest</source>
        <translation>休憩を終える</translation>
    </message>
    <message>
        <source>Repetitions of each pattern: %1 in practice, %2 in the test; %3 test trials per participant</source>
        <translation>各パターンの反復: 練習%1回、テスト%2回。参加者1名あたりテスト%3試行</translation>
    </message>
    <message>
        <source>Resume this session</source>
        <translation>このセッションを続行</translation>
    </message>
    <message>
        <source>Start this session</source>
        <translation>このセッションを開始</translation>
    </message>
    <message>
        <source>This session was interrupted after %1 of %2 trials. All answers are saved; it resumes in the same order.</source>
        <translation>このセッションは%2試行中%1試行で中断されました。回答は保存されており、同じ順序で続行します。</translation>
    </message>
    <message>
        <source>The session can start when all checks have passed.</source>
        <translation>すべてのチェックを通過するとセッションを開始できます。</translation>
    </message>
    <message>
        <source>Start the rehearsal</source>
        <translation>リハーサルを開始</translation>
    </message>
    <message>
        <source>Resume the rehearsal</source>
        <translation>リハーサルを続行</translation>
    </message>
    <message>
        <source>Simulated participants go through all sessions, by the same rules as people.</source>
        <translation>シミュレーション参加者が、人と同じコードですべてのセッションを行います。</translation>
    </message>
    <message>
        <source>Next session</source>
        <translation>次のセッションへ</translation>
    </message>
    <message>
        <source>Enrol the first participant on the left: the order of enrolment determines the order of the conditions.</source>
        <translation>左側で最初の参加者を登録してください: 条件の順序は登録順で決まります。</translation>
    </message>
    <message>
        <source>It is asked again when a session of this participant starts or resumes.</source>
        <translation>この参加者のセッションを開始または続行するときに、再び質問されます。</translation>
    </message>
    <message>
        <source>It is asked again only if this session is interrupted and resumed.</source>
        <translation>このセッションが中断されて続行されたときにのみ、再び質問されます。</translation>
    </message>
    <message>
        <source>The session finishes without it, and it is not asked again.</source>
        <translation>これなしでセッションは完了し、再び質問されることはありません。</translation>
    </message>
    <message>
        <source>Recording that “%1” is skipped …</source>
        <translation>「%1」の省略を記録しています…</translation>
    </message>
    <message>
        <source>Saving the answers …</source>
        <translation>回答を保存しています…</translation>
    </message>
    <message>
        <source>Try again to skip it</source>
        <translation>もう一度省略する</translation>
    </message>
    <message>
        <source>“%1” could not be skipped, because the note about it could not be saved. %2</source>
        <translation>省略の記録を保存できなかったため、「%1」を省略できませんでした。%2</translation>
    </message>
    <message>
        <source>Try again to save the answers</source>
        <translation>もう一度回答を保存</translation>
    </message>
    <message>
        <source>The answers to “%1” could not be saved; they are still in the participant&apos;s window. %2</source>
        <translation>「%1」への回答を保存できませんでした。回答は参加者のウィンドウに残っています。%2</translation>
    </message>
    <message>
        <source>Rest. The participant may continue in %1 s.</source>
        <translation>休憩中です。参加者は %1 秒後に続けられます。</translation>
    </message>
    <message>
        <source>Rest. The participant continues with Space.</source>
        <translation>休憩中です。参加者がスペースキーで続けます。</translation>
    </message>
    <message>
        <source>Start the test</source>
        <translation>テストを開始</translation>
    </message>
    <message>
        <source>STOPPED. The bracelet is off. An interrupted trial will be shown again.</source>
        <translation>停止しました。ブレスレットはオフです。実行中だった試行は再び提示されます。</translation>
    </message>
    <message>
        <source>Try again to save the last trial</source>
        <translation>もう一度最後の試行を保存</translation>
    </message>
    <message>
        <source>The last trial is waiting for the server. %1</source>
        <translation>最後の試行はサーバーの復帰を待っています。%1</translation>
    </message>
    <message>
        <source>The last trial could not be saved; it is still in memory. %1</source>
        <translation>最後の試行を保存できませんでした。まだメモリー内にあります。%1</translation>
    </message>
    <message>
        <source>The session was aborted. All answers are saved.</source>
        <translation>セッションは中止されました。回答は保存されています。</translation>
    </message>
    <message>
        <source>Saving the trial …</source>
        <translation>試行を保存しています…</translation>
    </message>
    <message>
        <source>The stimulus is starting …</source>
        <translation>刺激が始まります…</translation>
    </message>
    <message>
        <source>The stimulus is playing.</source>
        <translation>刺激を提示しています。</translation>
    </message>
    <message>
        <source>The simulated participant is working</source>
        <translation>シミュレーション参加者が実施中です</translation>
    </message>
    <message>
        <source>The participant continues with Space</source>
        <translation>参加者がSpaceキーで続行します</translation>
    </message>
    <message>
        <source>Your answers could not be saved yet. Please tell the experimenter.</source>
        <translation>回答をまだ保存できていません。実験者に知らせてください。</translation>
    </message>
    <message>
        <source>No session is selected</source>
        <translation>セッションが選ばれていません</translation>
    </message>
    <message numerus="yes">
        <source>%1: %n track(s); %2</source>
        <comment>task; conditions</comment>
        <translation>
            <numerusform>%1: %nトラック、%2</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1. %n trigger(s) could not be written: %2</source>
        <comment>device; why</comment>
        <translation>
            <numerusform>%1。トリガー%n件を書き込めませんでした: %2</numerusform>
        </translation>
    </message>
    <message>
        <source>the line was not open</source>
        <translation>回線が開かれていませんでした</translation>
    </message>
    <message>
        <source>Track %1, level %2 %3</source>
        <comment>name, number, unit</comment>
        <translation>トラック %1、レベル %2 %3</translation>
    </message>
    <message>
        <source>%1 practice trials of each track; up to %2 test trials per participant</source>
        <translation>各トラックの練習%1試行、参加者ごとに本試行は最大%2試行</translation>
    </message>
    <message>
        <source>Session %1 of %2</source>
        <translation>セッション%1 / %2</translation>
    </message>
    <message>
        <source> (%1 Hz, force %2 %)</source>
        <comment>behind a level; force as a share of full</comment>
        <translation> （%1 Hz、力 %2 %）</translation>
    </message>
    <message>
        <source>STOP is released. The session waits, and an interrupted trial will be shown again.</source>
        <translation>STOPは解除されました。セッションは待機しています。中断した試行は再び提示されます。</translation>
    </message>
</context>
<context>
    <name>StudySchema</name>
    <message>
        <source>a newer program made this study (schema %1, this one knows %2)</source>
        <translation>この実験はより新しいプログラムで作成されました (スキーマ%1、このプログラムは%2まで対応)</translation>
    </message>
    <message>
        <source>cannot write the study: %1</source>
        <translation>実験を書き込めません: %1</translation>
    </message>
    <message>
        <source>cannot read the study: %1</source>
        <translation>実験を読み取れません: %1</translation>
    </message>
    <message>
        <source>another program made this database (schema %1)</source>
        <translation>このデータベースは別のプログラムで作成されました (スキーマ%1)</translation>
    </message>
</context>
<context>
    <name>StudySession</name>
    <message>
        <source>the stored trials do not belong to this session&apos;s plan</source>
        <translation>保存された試行がこの計画のものと一致しません</translation>
    </message>
    <message>
        <source>the order given by the session&apos;s seed</source>
        <translation>セッションのシードから決まる順序</translation>
    </message>
</context>
<context>
    <name>StudyStore</name>
    <message>
        <source>cannot open the study: %1</source>
        <translation>実験を開けません: %1</translation>
    </message>
    <message>
        <source>cannot use the study: %1</source>
        <translation>実験を使用できません: %1</translation>
    </message>
    <message>
        <source>there is no study here</source>
        <translation>ここには実験がありません</translation>
    </message>
    <message>
        <source>a folder with study.sqlite</source>
        <translation>study.sqliteを含むフォルダー</translation>
    </message>
    <message>
        <source>each attempt of a trial once</source>
        <translation>試行の各試みは1回のみ</translation>
    </message>
    <message>
        <source>cannot read the file: %1</source>
        <translation>ファイルを読み取れません: %1</translation>
    </message>
    <message>
        <source>server, created_utc and seed of a study</source>
        <translation>実験のserver、created_utc、seed</translation>
    </message>
    <message>
        <source>the address has the port &quot;%1&quot;</source>
        <translation>アドレスのポートが「%1」です</translation>
    </message>
    <message>
        <source>a whole number from 1 to 65535</source>
        <translation>1から65535までの整数</translation>
    </message>
    <message>
        <source>the option &quot;%1&quot; of the address has a semicolon</source>
        <translation>アドレスのオプション「%1」にセミコロンがあります</translation>
    </message>
    <message>
        <source>a value without semicolons</source>
        <translation>セミコロンを含まない値</translation>
    </message>
    <message>
        <source>the address has the unknown option &quot;%1&quot;</source>
        <translation>アドレスに不明なオプション「%1」があります</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot name a study on a server</source>
        <translation>「%1」はサーバー上の実験の名前に使えません</translation>
    </message>
    <message>
        <source>Qt&apos;s driver for PostgreSQL is not installed</source>
        <translation>QtのPostgreSQLドライバーがインストールされていません</translation>
    </message>
    <message>
        <source>the package %1</source>
        <translation>パッケージ %1</translation>
    </message>
    <message>
        <source>the server has no study &quot;%1&quot;</source>
        <translation>サーバーに実験「%1」がありません</translation>
    </message>
    <message>
        <source>one session of a participant at a time</source>
        <translation>参加者ごとに同時に1つのセッション</translation>
    </message>
    <message>
        <source>another station</source>
        <translation>別のステーション</translation>
    </message>
    <message>
        <source>these trials belong to another study</source>
        <translation>これらの試行は別の実験のものです</translation>
    </message>
    <message>
        <source>each questionnaire once</source>
        <translation>各質問票は1回のみ</translation>
    </message>
    <message>
        <source>cannot write the file: %1</source>
        <translation>ファイルに書き込めません: %1</translation>
    </message>
    <message>
        <source>cannot remove the file: %1</source>
        <translation>ファイルを削除できません: %1</translation>
    </message>
    <message>
        <source>cannot read the study: %1</source>
        <translation>実験を読み込めません: %1</translation>
    </message>
    <message>
        <source>another try in a moment</source>
        <translation>しばらくしてからの再試行</translation>
    </message>
    <message>
        <source>a separate folder for each study</source>
        <translation>実験ごとに固有のフォルダー</translation>
    </message>
    <message>
        <source>this folder already contains a study</source>
        <translation>このフォルダーには、フォルダー内に保存された実験があります</translation>
    </message>
    <message>
        <source>this folder belongs to another study, on %1</source>
        <translation>このフォルダーは別の実験のものです (%1)</translation>
    </message>
    <message>
        <source>the file does not say which study the folder belongs to</source>
        <translation>どの実験のフォルダーかを示していません</translation>
    </message>
    <message>
        <source>this is not the address of a PostgreSQL server</source>
        <translation>PostgreSQLサーバーのアドレスではありません</translation>
    </message>
    <message>
        <source>lower-case letters, digits and _, no digit first</source>
        <translation>小文字の英字、数字、_ (先頭は数字以外)</translation>
    </message>
    <message>
        <source>the program that ran this study was interrupted; its last trials are in %1, which can be read only in a writable folder</source>
        <translation>この実験を実行していたプログラムは中断され、最後の試行は %1 にあります。書き込める場所でのみ読めます</translation>
    </message>
    <message>
        <source>a copy of the whole folder in a writable place</source>
        <translation>書き込める場所へのフォルダ全体のコピー</translation>
    </message>
    <message>
        <source>this study was made by an older program and cannot be upgraded here</source>
        <translation>この実験は古いプログラムで作られ、ここでは更新できません</translation>
    </message>
    <message>
        <source>the name of a study on that server</source>
        <translation>サーバー上で始めた実験の名前</translation>
    </message>
    <message>
        <source>another station took over this participant while the server was unreachable</source>
        <translation>サーバーに接続できない間に、別のステーションがこの参加者を続行しました</translation>
    </message>
    <message>
        <source>the server still holds the broken connection, and with it this participant</source>
        <translation>切断された接続とこの参加者が、まだサーバーに残っています</translation>
    </message>
    <message>
        <source>it is read-only here</source>
        <translation>ここでは書き込めません。見ることだけができます</translation>
    </message>
    <message>
        <source>the study is damaged: a session or trial has a number outside its protocol</source>
        <translation>実験が破損しています: プロトコルにない番号のセッションまたは試行があります</translation>
    </message>
    <message>
        <source>this trial is already stored</source>
        <translation>この試行はすでに保存されています</translation>
    </message>
    <message>
        <source>The trial is safe in %1 and will be sent when the server is back.</source>
        <translation>試行は %1 に安全に保存されており、サーバーの復帰後に送信されます。</translation>
    </message>
    <message>
        <source>this questionnaire belongs elsewhere in the study</source>
        <translation>この質問票は実験の別の箇所のものです</translation>
    </message>
    <message>
        <source>this questionnaire has already been answered</source>
        <translation>この質問票はすでに回答されています</translation>
    </message>
    <message>
        <source>this is not a trial</source>
        <translation>試行ではありません</translation>
    </message>
    <message>
        <source>a stored trial</source>
        <translation>ここに保存された試行</translation>
    </message>
    <message>
        <source>the study is open for reading only</source>
        <translation>実験は読み取り専用で開かれています</translation>
    </message>
    <message>
        <source>a folder that can be written to</source>
        <translation>書き込めるフォルダー</translation>
    </message>
    <message>
        <source>the study has no participant &quot;%1&quot;</source>
        <translation>実験に参加者「%1」はいません</translation>
    </message>
</context>
<context>
    <name>StudySweep</name>
    <message>
        <source>&quot;participants&quot; is out of range</source>
        <translation>「participants」が範囲外です</translation>
    </message>
    <message>
        <source>a whole number from 1 to 1000</source>
        <translation>1 から 1000 までの整数</translation>
    </message>
    <message>
        <source>unknown key &quot;%1&quot;</source>
        <translation>不明なキー「%1」</translation>
    </message>
    <message>
        <source>participants, or a key behind &quot;truth.&quot; or &quot;protocol.&quot;</source>
        <translation>participants、または「truth.」か「protocol.」に続くキー</translation>
    </message>
</context>
<context>
    <name>StudyTruth</name>
    <message>
        <source>cannot open the truth: %1</source>
        <translation>真値を開けません: %1</translation>
    </message>
    <message>
        <source>the task %1 shows no spread of its participants: %2</source>
        <translation>課題 %1 は参加者のばらつきを示していません: %2</translation>
    </message>
    <message>
        <source>a pilot with at least 5 participants, or a file with the truth</source>
        <translation>参加者5名以上のパイロット、または真値のファイル</translation>
    </message>
    <message>
        <source>nothing is assumed of the task %1</source>
        <translation>課題%1について何も仮定されていません</translation>
    </message>
    <message>
        <source>condition or threshold</source>
        <translation>conditionまたはthreshold</translation>
    </message>
    <message>
        <source>this study has no test trials yet</source>
        <translation>この実験にはまだテスト試行がありません</translation>
    </message>
    <message>
        <source>no task has a threshold and a slope of several participants</source>
        <translation>複数の参加者のしきい値と傾きがある課題がありません</translation>
    </message>
    <message>
        <source>a pilot with at least 2 participants, or a file with the truth</source>
        <translation>参加者2名以上のパイロット、または真値のファイル</translation>
    </message>
</context>
<context>
    <name>StudyWatermark</name>
    <message>
        <source>PILOT</source>
        <translation>パイロット</translation>
    </message>
    <message>
        <source>SIMULATED</source>
        <translation>シミュレーション</translation>
    </message>
</context>
<context>
    <name>StudyWriting</name>
    <message>
        <source>Results of the study</source>
        <translation>実験の結果</translation>
    </message>
</context>
<context>
    <name>SweepCommand</name>
    <message>
        <source>Sweep file: what runs, with which settings and seeds</source>
        <translation>スイープのファイル: 何をどの設定とシードで実行するか</translation>
    </message>
    <message>
        <source>Folder for runs.csv, cells.csv, figures and sweep.json; a sweep that was interrupted goes on in it</source>
        <translation>runs.csv、cells.csv、figures、sweep.json のフォルダー。中断したスイープはここで続きます</translation>
    </message>
    <message>
        <source>Throw away what the folder has of an earlier sweep</source>
        <translation>フォルダーにある以前のスイープの結果を捨てる</translation>
    </message>
    <message>
        <source>Share of the runs that may fail before this counts as an error</source>
        <translation>エラーとみなさずに失敗してよい実行の割合</translation>
    </message>
    <message>
        <source>Write the tactile frames with contacts, forces and objects to DIR/frames</source>
        <translation>触覚フレームを接触、力、物体とともに DIR/frames に書く</translation>
    </message>
    <message>
        <source>Say how far the sweep in this folder has come</source>
        <translation>このフォルダーのスイープの進み具合を示す</translation>
    </message>
    <message>
        <source>Only merge the results that are there, as each run of this command does at its end</source>
        <translation>今ある結果をまとめるだけにする。このコマンドは毎回最後にこれを行います</translation>
    </message>
    <message>
        <source>Run it as an array of jobs of Slurm on a cluster</source>
        <translation>クラスターの Slurm のジョブ配列として実行する</translation>
    </message>
    <message>
        <source>Of Slurm: tasks of the array</source>
        <translation>Slurm: 配列のタスク数</translation>
    </message>
    <message>
        <source>Of Slurm: runs of one task</source>
        <translation>Slurm: 1 つのタスクの実行数</translation>
    </message>
    <message>
        <source>Of Slurm: an option of sbatch, such as --partition=short; may come again</source>
        <translation>Slurm: --partition=short のような sbatch のオプション。繰り返し指定できます</translation>
    </message>
    <message>
        <source>Of Slurm: wait until all is done and merged</source>
        <translation>Slurm: すべてが終わり、まとめられるまで待つ</translation>
    </message>
    <message>
        <source>Do the share of this task of --tasks, from 0, as the jobs of Slurm do</source>
        <translation>--tasks のうちこのタスク (0 から) の分を行う。Slurm のジョブと同じです</translation>
    </message>
    <message>
        <source>is required</source>
        <translation>が必要です</translation>
    </message>
    <message>
        <source>is not below the number of tasks, %1</source>
        <translation>タスクの数 %1 より小さくありません</translation>
    </message>
    <message>
        <source>is for scenes of an array or a servo</source>
        <translation>アレイまたはサーボのシーン用です</translation>
    </message>
    <message>
        <source>a sweep file, or one of: %1</source>
        <translation>スイープのファイル、または次のいずれか: %1</translation>
    </message>
    <message>
        <source>%1 of %2 runs are missing</source>
        <translation>%2 回のうち %1 回の実行がありません</translation>
    </message>
    <message>
        <source>the same command without --merge, which goes on with them</source>
        <translation>--merge なしの同じコマンド。残りを続けます</translation>
    </message>
    <message>
        <source>%1 of %2 runs failed; runs.csv has the reasons</source>
        <translation>%2 回のうち %1 回の実行が失敗しました。理由は runs.csv にあります</translation>
    </message>
    <message>
        <source>at most %1 (see --allow-failed)</source>
        <translation>多くとも %1 (--allow-failed を参照)</translation>
    </message>
    <message>
        <source>Job</source>
        <translation>ジョブ</translation>
    </message>
    <message>
        <source>Tasks</source>
        <translation>タスク</translation>
    </message>
    <message>
        <source>Merging job</source>
        <translation>まとめるジョブ</translation>
    </message>
    <message>
        <source>How far it is</source>
        <translation>進み具合</translation>
    </message>
    <message>
        <source>Run a scene over a grid of settings and seeds, here or on a cluster</source>
        <translation>設定とシードの格子でシーンを実行する。このマシンまたはクラスターで</translation>
    </message>
    <message>
        <source>needs --slurm or --task</source>
        <translation>--slurm または --task が必要です</translation>
    </message>
    <message>
        <source>Runs at the same time; otherwise as many as the machine has cores, and one of a ladder, which is timed</source>
        <translation>同時に行う実行の数。なければマシンのコア数、時間を計るラダーでは1つ</translation>
    </message>
    <message>
        <source>%1; asking again (%2 of %3)</source>
        <translation>%1。もう一度尋ねます（%3回中%2回目）</translation>
    </message>
</context>
<context>
    <name>SweepFigure</name>
    <message>
        <source>Bars: Wilson&apos;s 95 % interval of the share.</source>
        <translation>棒: 割合のウィルソンの 95 % 区間。</translation>
    </message>
    <message>
        <source>Points: means with their 95 % interval. Dotted: 5 and 95 % of the runs.</source>
        <translation>点: 平均とその 95 % 区間。点線: 実行の 5 % と 95 %。</translation>
    </message>
    <message>
        <source>Means. The first %1 of %2 maps.</source>
        <translation>平均。%2 枚の地図のうち最初の %1 枚。</translation>
    </message>
    <message>
        <source>Means. Crossed out: no run has it.</source>
        <translation>平均。斜線: どの実行にもありません。</translation>
    </message>
</context>
<context>
    <name>SweepFolderText</name>
    <message>
        <source>the folder holds results of another sweep: %1</source>
        <translation>フォルダーには別のスイープの結果があります: %1</translation>
    </message>
    <message>
        <source>another folder, or --restart, which throws these results away</source>
        <translation>別のフォルダー、またはこの結果を捨てる --restart</translation>
    </message>
    <message>
        <source>line %1 was &quot;%2&quot; and is &quot;%3&quot;</source>
        <translation>%1 行目は「%2」でしたが「%3」になっています</translation>
    </message>
    <message>
        <source>only the spaces differ</source>
        <translation>空白だけが異なります</translation>
    </message>
    <message>
        <source>earlier results cannot be removed</source>
        <translation>以前の結果を削除できません</translation>
    </message>
    <message>
        <source>what it runs has changed, %1</source>
        <translation>実行するものが変わりました。%1</translation>
    </message>
    <message>
        <source>they are of version %1, this is %2</source>
        <translation>結果はバージョン %1、これは %2 です</translation>
    </message>
    <message>
        <source>they have frames</source>
        <translation>フレームがあります</translation>
    </message>
    <message>
        <source>they have no frames</source>
        <translation>フレームがありません</translation>
    </message>
    <message>
        <source>the folder holds other files</source>
        <translation>フォルダーに他のファイルがあります</translation>
    </message>
    <message>
        <source>a new or empty folder, or one of a sweep</source>
        <translation>新しいか空のフォルダー、またはスイープのフォルダー</translation>
    </message>
    <message>
        <source>this describes no sweep</source>
        <translation>これはスイープの記述ではありません</translation>
    </message>
    <message>
        <source>a file that teleta sweep has written</source>
        <translation>teleta sweep が書いたファイル</translation>
    </message>
</context>
<context>
    <name>SweepParts</name>
    <message>
        <source>the file cannot be made: %1</source>
        <translation>ファイルを作れません: %1</translation>
    </message>
    <message>
        <source>this is no part of a sweep</source>
        <translation>これはスイープの部分ではありません</translation>
    </message>
    <message>
        <source>this is no row of a sweep</source>
        <translation>これはスイープの行ではありません</translation>
    </message>
    <message>
        <source>the number of a run and its times</source>
        <translation>実行の番号とその時間</translation>
    </message>
    <message>
        <source>this is no number</source>
        <translation>これは数ではありません</translation>
    </message>
    <message>
        <source>a number or NA</source>
        <translation>数または NA</translation>
    </message>
    <message>
        <source>a part has the run %1</source>
        <translation>部分に実行 %1 があります</translation>
    </message>
    <message>
        <source>runs from 0 to %1</source>
        <translation>0 から %1 までの実行</translation>
    </message>
</context>
<context>
    <name>SweepPlan</name>
    <message>
        <source>a range with scale &quot;log10&quot; reaches 0 or below</source>
        <translation>scale が「log10」の範囲が 0 以下に達します</translation>
    </message>
    <message>
        <source>the key &quot;%1&quot; is varied twice</source>
        <translation>キー「%1」が 2 回変えられています</translation>
    </message>
    <message>
        <source>each key once</source>
        <translation>各キーは 1 回</translation>
    </message>
    <message>
        <source>keys that go together have unlike numbers of values: %1 and %2</source>
        <translation>一緒に変わるキーの値の数が異なります: %1 と %2</translation>
    </message>
    <message>
        <source>%1 values, as the first key has</source>
        <translation>最初のキーと同じ %1 個の値</translation>
    </message>
    <message>
        <source>a sweep runs one thing</source>
        <translation>スイープが実行するのは 1 つです</translation>
    </message>
    <message>
        <source>one of: scene, study, ladder</source>
        <translation>scene、study、ladder のいずれか</translation>
    </message>
    <message>
        <source>these are no seeds</source>
        <translation>これはシードではありません</translation>
    </message>
    <message>
        <source>&quot;FIRST:LAST&quot;, such as &quot;1:200&quot;</source>
        <translation>「FIRST:LAST」、例えば「1:200」</translation>
    </message>
    <message>
        <source>the sweep has %1 runs</source>
        <translation>スイープの実行は %1 回です</translation>
    </message>
    <message>
        <source>at most %1</source>
        <translation>多くとも %1</translation>
    </message>
</context>
<context>
    <name>SweepReport</name>
    <message>
        <source>%1 of %2 runs, %3 failed, %4 left</source>
        <translation>%2 回中 %1 回、失敗 %3、残り %4</translation>
    </message>
    <message>
        <source>Worst cells so far:</source>
        <translation>これまでで最も悪いセル:</translation>
    </message>
    <message>
        <source>%1 of %2 failed; </source>
        <translation>%2 回中 %1 回失敗; </translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>フォルダー</translation>
    </message>
    <message>
        <source>Runs</source>
        <translation>実行</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 / %2</translation>
    </message>
    <message>
        <source>Failed</source>
        <translation>失敗</translation>
    </message>
    <message>
        <source>Cells</source>
        <translation>セル</translation>
    </message>
    <message>
        <source>Processor time</source>
        <translation>プロセッサー時間</translation>
    </message>
    <message>
        <source>%1 to %2 (means of the cells)</source>
        <translation>%1 ～ %2 (セルの平均)</translation>
    </message>
</context>
<context>
    <name>SweepRunner</name>
    <message>
        <source>a run has no measure &quot;%1&quot;</source>
        <translation>実行に測定値「%1」がありません</translation>
    </message>
    <message>
        <source>of: %1</source>
        <translation>次のうち: %1</translation>
    </message>
    <message>
        <source>this has no frames of a tactile array</source>
        <translation>これには触覚アレイのフレームがありません</translation>
    </message>
    <message>
        <source>a scene of an array or a servo</source>
        <translation>アレイまたはサーボのシーン</translation>
    </message>
</context>
<context>
    <name>SweepTexts</name>
    <message>
        <source>Camera</source>
        <translation>カメラ</translation>
    </message>
    <message>
        <source>Contact by place and depth</source>
        <translation>位置と深さによる接触</translation>
    </message>
    <message>
        <source>How exactly does the camera in the soft tube find a finger along the tube?</source>
        <translation>柔らかいチューブ内のカメラは、チューブに沿った指をどれだけ正確に見つけますか。</translation>
    </message>
    <message>
        <source>Touched object</source>
        <translation>触れた物体</translation>
    </message>
    <message>
        <source>Stiffness by noise and speed</source>
        <translation>ノイズと速度による剛性</translation>
    </message>
    <message>
        <source>Over which stiffnesses, noises and speeds does a touch find the stiffness?</source>
        <translation>どの剛性、ノイズ、速度の範囲で、接触から剛性が求まりますか。</translation>
    </message>
    <message>
        <source>Curve through contact points</source>
        <translation>接触点を通る曲線</translation>
    </message>
    <message>
        <source>How far is the curve from the outline, and how long does it take?</source>
        <translation>曲線は輪郭からどれだけ離れ、どれだけ時間がかかりますか。</translation>
    </message>
    <message>
        <source>Servo</source>
        <translation>サーボ</translation>
    </message>
    <message>
        <source>Bent bar by friction and latency</source>
        <translation>摩擦と遅延による曲がった棒</translation>
    </message>
    <message>
        <source>Over which radii, frictions and latencies does the array follow the bar?</source>
        <translation>どの半径、摩擦、遅延の範囲で、アレイは棒に追従しますか。</translation>
    </message>
    <message>
        <source>Frames to learn from</source>
        <translation>学習用のフレーム</translation>
    </message>
    <message>
        <source>Two balls on an array</source>
        <translation>アレイ上の2つの球</translation>
    </message>
    <message>
        <source>A million frames, with where and how hard each ball presses.</source>
        <translation>100万フレーム。各球が押す位置と力を含みます。</translation>
    </message>
    <message>
        <source>An array along a bent bar</source>
        <translation>曲がった棒に沿うアレイ</translation>
    </message>
    <message>
        <source>A million frames, with where, how hard and along which normal it is pressed.</source>
        <translation>100万フレーム。押される位置、力、法線を含みます。</translation>
    </message>
</context>
<context>
    <name>TableText</name>
    <message>
        <source>the recording has no frames</source>
        <translation>記録にフレームがありません</translation>
    </message>
    <message>
        <source>at least one row of numbers</source>
        <translation>1行以上の数値</translation>
    </message>
    <message>
        <source>there is no column %1</source>
        <translation>列%1がありません</translation>
    </message>
    <message>
        <source>a number from 1 to %1; the table has no header</source>
        <translation>1から%1までの番号。表にヘッダーはありません</translation>
    </message>
    <message>
        <source>one of %1, or a number from 1 to %2</source>
        <translation>%1のいずれか、または1から%2までの番号</translation>
    </message>
    <message>
        <source>the table has %1 columns, %2..%3 are asked for</source>
        <translation>表の列は%1個ですが、%2..%3が指定されています</translation>
    </message>
    <message>
        <source>columns from 1 to %1</source>
        <translation>1から%1までの列</translation>
    </message>
    <message>
        <source>the table has %1 columns of taxels</source>
        <translation>表のタクセル列は%1個です</translation>
    </message>
    <message>
        <source>from 1 to %1</source>
        <translation>1から%1まで</translation>
    </message>
    <message>
        <source>column %1 is that of the times, and one of the taxels</source>
        <translation>列%1が時刻の列とタクセルの列の両方に指定されています</translation>
    </message>
    <message>
        <source>either</source>
        <translation>どちらか一方</translation>
    </message>
    <message>
        <source>a row of the table</source>
        <translation>表の1行</translation>
    </message>
    <message>
        <source>a column of times and a rate</source>
        <translation>時刻の列とレートの両方があります</translation>
    </message>
    <message>
        <source>the column of the times (--time-column NAME), or frames per second (--rate HZ)</source>
        <translation>時刻の列 (--time-column NAME)、または毎秒のフレーム数 (--rate HZ)</translation>
    </message>
    <message>
        <source>the unit %1 of the times</source>
        <translation>時刻の単位%1は使えません</translation>
    </message>
    <message>
        <source>the row has %1 values</source>
        <translation>行の値は%1個です</translation>
    </message>
    <message>
        <source>one value per column: %1</source>
        <translation>列ごとに値1つ: %1</translation>
    </message>
    <message>
        <source>the table is too long</source>
        <translation>表が長すぎます</translation>
    </message>
    <message>
        <source>at most %1 values</source>
        <translation>%1個以下の値</translation>
    </message>
    <message>
        <source>the time goes back</source>
        <translation>時刻が戻っています</translation>
    </message>
    <message>
        <source>times that do not decrease</source>
        <translation>減少しない時刻</translation>
    </message>
    <message>
        <source>%1 is not a number</source>
        <translation>%1 は数値ではありません</translation>
    </message>
    <message>
        <source>a number, nan, inf or NA</source>
        <translation>数値、nan、inf、またはNA</translation>
    </message>
    <message>
        <source>%1 is not a time</source>
        <translation>%1 は時刻ではありません</translation>
    </message>
    <message>
        <source>a finite number</source>
        <translation>有限の数値</translation>
    </message>
    <message>
        <source>a date and time such as 2026-05-01T12:00:00.5</source>
        <translation>2026-05-01T12:00:00.5のような日時</translation>
    </message>
    <message>
        <source>a number, or iso as the unit (--time-unit iso)</source>
        <translation>数値、または単位としてiso（--time-unit iso）</translation>
    </message>
</context>
<context>
    <name>TareQuestion</name>
    <message>
        <source>Tare the array</source>
        <translation>アレイのゼロ点調整</translation>
    </message>
    <message>
        <source>%1 of %2 taxels are under load.</source>
        <translation>%2個中%1個のタクセルに荷重がかかっています。</translation>
    </message>
    <message>
        <source>What presses on the array during the tare counts as no load afterwards. Tare only if nothing touches the array and the loads shown are drift.</source>
        <translation>ゼロ点調整中にアレイを押しているものは、その後は荷重として数えられません。何もアレイに触れておらず、表示されている荷重がドリフトである場合にだけゼロ点を調整してください。</translation>
    </message>
    <message>
        <source>&amp;Tare under load</source>
        <translation>荷重がかかったままゼロ点調整(&amp;T)</translation>
    </message>
</context>
<context>
    <name>TaxelGainFile</name>
    <message>
        <source>taxel %1 is missing</source>
        <translation>タクセル %1 がありません</translation>
    </message>
    <message>
        <source>the taxels 0 to %1</source>
        <translation>タクセル0〜%1</translation>
    </message>
    <message>
        <source>the %1 is &quot;%2&quot;</source>
        <comment>a column of a table</comment>
        <translation>%1が「%2」です</translation>
    </message>
    <message>
        <source>a whole number from 0 to %1</source>
        <translation>0から%1までの整数</translation>
    </message>
    <message>
        <source>%1, in an array of %2 rows x %3 columns</source>
        <translation>%1 (%2行 x %3列のアレイ)</translation>
    </message>
    <message>
        <source>each taxel once</source>
        <translation>各タクセルを1回</translation>
    </message>
    <message>
        <source>a number from %1 to %2, or NA</source>
        <translation>%1から%2までの数、またはNA</translation>
    </message>
    <message>
        <source>the state does not fit the gain</source>
        <translation>状態がゲインと合いません</translation>
    </message>
    <message>
        <source>taxel %1 is listed in row %2, column %3</source>
        <translation>タクセル %1 が行 %2、列 %3 にあることになっています</translation>
    </message>
    <message>
        <source>taxel %1 is listed twice</source>
        <translation>タクセル %1 が2回あります</translation>
    </message>
    <message>
        <source>the gain is not a number or out of range</source>
        <translation>ゲインが範囲外か、数ではありません</translation>
    </message>
    <message>
        <source>the standard error is not a number or out of range</source>
        <translation>標準誤差が範囲外か、数ではありません</translation>
    </message>
    <message>
        <source>a number of at least 0, or NA</source>
        <translation>0以上の数、またはNA</translation>
    </message>
</context>
<context>
    <name>TaxelGains</name>
    <message>
        <source>Only %1 of %2 taxels feel the load.</source>
        <translation>荷重を感じるのは%2個中%1個のタクセルだけです。</translation>
    </message>
    <message>
        <source>Only %1 frames are under load.</source>
        <translation>荷重下のフレームは%1個だけです。</translation>
    </message>
    <message>
        <source>at least %1</source>
        <translation>%1以上</translation>
    </message>
    <message>
        <source>There is no press.</source>
        <translation>押圧がありません。</translation>
    </message>
    <message>
        <source>at least one</source>
        <translation>1つ以上</translation>
    </message>
    <message>
        <source>a multiple of %1</source>
        <translation>%1の倍数</translation>
    </message>
    <message>
        <source>No taxel is good in all presses.</source>
        <translation>すべての押圧で良好なタクセルがありません。</translation>
    </message>
    <message>
        <source>presses of the whole array</source>
        <translation>アレイ全体への押圧</translation>
    </message>
    <message>
        <source>Most taxels read the same value in all frames: %1.</source>
        <translation>ほとんどのタクセルがすべてのフレームで同じ値を示しています: %1。</translation>
    </message>
    <message>
        <source>a load that the taxels can measure</source>
        <translation>タクセルが測定できる荷重</translation>
    </message>
    <message>
        <source>at least %1, under a smaller load</source>
        <translation>%1 個以上 (より小さい荷重で)</translation>
    </message>
    <message>
        <source>a load on the whole array, and a tare taken without load</source>
        <translation>アレイ全体への荷重と、無荷重でのゼロ点</translation>
    </message>
    <message>
        <source>Only %1 frames under load are within the range of the taxels.</source>
        <translation>荷重のかかったフレームのうち %1 個を除いて、タクセルが測定範囲の上限に達しています。</translation>
    </message>
    <message>
        <source>The frames have %1 values in total.</source>
        <translation>フレームの値は全部で%1個です。</translation>
    </message>
</context>
<context>
    <name>TaxelsReportText</name>
    <message>
        <source>Frames found</source>
        <translation>見つかったフレーム</translation>
    </message>
    <message>
        <source>Bytes of frames</source>
        <translation>フレームのバイト</translation>
    </message>
    <message>
        <source>Bytes outside frames</source>
        <translation>フレーム外のバイト</translation>
    </message>
    <message>
        <source>Wrong checksums</source>
        <translation>誤ったチェックサム</translation>
    </message>
    <message>
        <source>Wrong lengths</source>
        <translation>誤った長さ</translation>
    </message>
    <message>
        <source>Wrong closing bytes</source>
        <translation>誤った末尾バイト</translation>
    </message>
    <message>
        <source>Unreadable values</source>
        <translation>読めない値</translation>
    </message>
    <message>
        <source>Frames of another length</source>
        <translation>別の長さのフレーム</translation>
    </message>
    <message>
        <source>Bytes (&gt; begins a frame)</source>
        <translation>バイト列 (&gt;はフレームの先頭)</translation>
    </message>
    <message>
        <source>First frame in %1, the last row first</source>
        <translation>最初のフレーム (単位 %1)、最後の行が先頭</translation>
    </message>
    <message>
        <source>First frame: taxel, x and y in mm, and its x, y and z in %1</source>
        <translation>最初のフレーム: タクセル、xとy (mm)、x、y、z成分 (%1)</translation>
    </message>
    <message>
        <source>First frame: taxel, x and y in mm, and its load in %1</source>
        <translation>最初のフレーム: タクセル、xとy (mm)、荷重 (%1)</translation>
    </message>
    <message>
        <source>Binary messages, which are left out</source>
        <translation>除外したバイナリーメッセージ</translation>
    </message>
</context>
<context>
    <name>TaxelsText</name>
    <message>
        <source>up to %1 bytes, as &quot;AA 55&quot;</source>
        <translation>「AA 55」のように最大%1バイト</translation>
    </message>
    <message numerus="yes">
        <source>%n byte(s) from %1 on are not in the frame</source>
        <translation>
            <numerusform>%1からの%nバイトはフレームの中にありません</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>a place in a frame of %n byte(s)</source>
        <translation>
            <numerusform>%nバイトのフレームの中の位置</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n byte(s) from %1 on are in no frame</source>
        <translation>
            <numerusform>%1からの%nバイトはどのフレームの中にもありません</numerusform>
        </translation>
    </message>
    <message>
        <source>a place in the frame; a negative one counts from its end</source>
        <translation>フレームの中の位置。負の数は末尾から数えます</translation>
    </message>
    <message>
        <source>the checksum covers no byte of the frame</source>
        <translation>チェックサムの範囲にフレームのバイトがありません</translation>
    </message>
    <message>
        <source>&quot;from&quot; before &quot;to&quot;</source>
        <translation>「to」より前の「from」</translation>
    </message>
    <message>
        <source>the checksum covers itself</source>
        <translation>チェックサムの範囲にそれ自身が入っています</translation>
    </message>
    <message>
        <source>bytes before or behind it</source>
        <translation>その前または後のバイト</translation>
    </message>
    <message>
        <source>with a factor of 0 every value is the same</source>
        <translation>係数が0では、すべての値が同じになります</translation>
    </message>
    <message>
        <source>another number</source>
        <translation>別の数</translation>
    </message>
    <message>
        <source>%1 numbers are not %2 for each taxel</source>
        <translation>%1個の数は、タクセルあたり%2個になりません</translation>
    </message>
    <message>
        <source>a multiple of %1</source>
        <translation>%1の倍数</translation>
    </message>
    <message>
        <source>a taxel has more bytes than that</source>
        <translation>タクセルのバイト数はそれより多いです</translation>
    </message>
    <message>
        <source>at least %1, or 0</source>
        <translation>%1以上、または0</translation>
    </message>
    <message>
        <source>the length of a frame is not clear</source>
        <translation>フレームの長さが決まりません</translation>
    </message>
    <message>
        <source>either length or length_field</source>
        <translation>lengthかlength_fieldのどちらか</translation>
    </message>
    <message>
        <source>the first and last bytes are longer than the frame</source>
        <translation>先頭と末尾のバイトがフレームより長くなっています</translation>
    </message>
    <message>
        <source>at least %1</source>
        <translation>%1以上</translation>
    </message>
    <message>
        <source>nothing shows where a frame begins</source>
        <translation>フレームの先頭を示すものがありません</translation>
    </message>
    <message>
        <source>sync, end or a checksum</source>
        <translation>sync、endまたはチェックサム</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot separate numbers</source>
        <translation>「%1」は数の区切りになりません</translation>
    </message>
    <message>
        <source>one character</source>
        <translation>1文字</translation>
    </message>
    <message>
        <source>&quot;%1&quot; names no columns</source>
        <translation>「%1」は列を表していません</translation>
    </message>
    <message>
        <source>the first and the last column, as &quot;2..85&quot;</source>
        <translation>「2..85」のように最初と最後の列</translation>
    </message>
    <message>
        <source>a column cannot be a value and the time</source>
        <translation>1つの列が値と時刻を兼ねることはできません</translation>
    </message>
    <message>
        <source>a column outside &quot;columns&quot;</source>
        <translation>「columns」の外の列</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no JSON pointer</source>
        <translation>「%1」はJSONポインターではありません</translation>
    </message>
    <message>
        <source>a path as &quot;/sensors/0/data&quot;</source>
        <translation>「/sensors/0/data」のようなパス</translation>
    </message>
    <message>
        <source>a taxel tells its load or three components</source>
        <translation>タクセルが示すのは荷重か3成分です</translation>
    </message>
    <message>
        <source>1 or 3</source>
        <translation>1または3</translation>
    </message>
    <message>
        <source>each axis once with its sign, as [&quot;+x&quot;, &quot;-y&quot;, &quot;-z&quot;]</source>
        <translation>[&quot;+x&quot;, &quot;-y&quot;, &quot;-z&quot;]のように、各軸を符号付きで1回ずつ</translation>
    </message>
    <message>
        <source>these are no places of taxels</source>
        <translation>これはタクセルの位置ではありません</translation>
    </message>
    <message>
        <source>&quot;places&quot; says already where no taxel is</source>
        <translation>タクセルのない位置は「places」で決まっています</translation>
    </message>
    <message>
        <source>either places or mask</source>
        <translation>placesかmaskのどちらか</translation>
    </message>
    <message>
        <source>The sensor has sent no usable frame for %1 s.</source>
        <translation>センサーから使用可能なフレームが%1 s間届いていません。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no address of a WebSocket server</source>
        <translation>「%1」はWebSocketサーバーのアドレスではありません</translation>
    </message>
    <message>
        <source>ws://HOST:PORT or wss://HOST:PORT</source>
        <translation>ws://HOST:PORTまたはwss://HOST:PORT</translation>
    </message>
    <message>
        <source>it is given as text already</source>
        <translation>すでにテキストで指定されています</translation>
    </message>
    <message>
        <source>either %1 or %2</source>
        <translation>%1か%2のどちらか</translation>
    </message>
    <message>
        <source>a frame has %1 numbers, but the layout has %2 taxels with %3 each</source>
        <translation>フレームには%1個の数がありますが、配置にはそれぞれ%3個のタクセルが%2個あります</translation>
    </message>
    <message>
        <source>%1 numbers</source>
        <translation>%1個の数</translation>
    </message>
    <message>
        <source>without a threshold it is not known which taxels are touched</source>
        <translation>しきい値がないと、どのタクセルが触れられているか分かりません</translation>
    </message>
    <message>
        <source>opening was cancelled</source>
        <translation>開くことが取り消されました</translation>
    </message>
    <message>
        <source>numbers from 0 to %1, and at least one place with a taxel</source>
        <translation>0から%1までの数。タクセルのある位置が少なくとも1つ必要です</translation>
    </message>
    <message>
        <source>numbers from 0 to %1, each once</source>
        <translation>0から%1までの数を1回ずつ</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a list of hexadecimal bytes</source>
        <translation>「%1」は16進数のバイトのリストではありません</translation>
    </message>
    <message>
        <source>threshold = a number in the unit of the values, above the first table</source>
        <translation>threshold = 値の単位での数 (最初の表より前)</translation>
    </message>
    <message>
        <source>only %1 of %2 frames arrived while the tare was measured</source>
        <translation>ゼロ点の測定中に届いたフレームは%2個中%1個だけです</translation>
    </message>
    <message>
        <source>frames as the file describes; check with teleta devices --probe FILE</source>
        <translation>ファイルに記述されたとおりのフレーム。teleta devices --probe FILEで確認してください</translation>
    </message>
    <message>
        <source>there are %1 positions</source>
        <translation>位置は%1個あります</translation>
    </message>
    <message>
        <source>one entry a position</source>
        <translation>位置ごとに1つ</translation>
    </message>
    <message>
        <source>at most %1; more of them on a grid</source>
        <translation>最大%1個。それより多い場合は格子で</translation>
    </message>
    <message>
        <source>other numbers than [0, 0, 0]</source>
        <translation>[0, 0, 0]以外の数</translation>
    </message>
    <message>
        <source>taxels %1 and %2 are at the same place</source>
        <translation>タクセル%1と%2が同じ位置にあります</translation>
    </message>
    <message>
        <source>different places; they count from 0</source>
        <translation>異なる位置 (番号は0から)</translation>
    </message>
    <message>
        <source>a normal is zero</source>
        <translation>法線がゼロです</translation>
    </message>
    <message>
        <source>these are not three distinct axes</source>
        <translation>3つの異なる軸ではありません</translation>
    </message>
    <message>
        <source>this mask does not fit the array</source>
        <translation>このマスクはアレイに合いません</translation>
    </message>
    <message>
        <source>at most %1 chips</source>
        <translation>%1個以下のチップ</translation>
    </message>
    <message>
        <source>The sensor has told no values for %1 s: it has none, or they are switched off.</source>
        <translation>センサーは%1 sの間、値を送っていません。値がないか、オフになっています。</translation>
    </message>
    <message>
        <source>The sensor is another model: %1 instead of %2.</source>
        <translation>センサーの型が違います: %2ではなく%1です。</translation>
    </message>
    <message>
        <source>The sensor has %1 taxels instead of %2.</source>
        <translation>センサーのタクセルは%2個ではなく%1個です。</translation>
    </message>
    <message>
        <source>the board sends frames of %1 chips</source>
        <translation>ボードは%1チップのフレームを送っています</translation>
    </message>
    <message>
        <source>frames of %1 chips, as the file has positions</source>
        <translation>ファイルの位置の数と同じ%1チップのフレーム</translation>
    </message>
</context>
<context>
    <name>TekscanText</name>
    <message>
        <source>the recording has no frames</source>
        <translation>記録にフレームがありません</translation>
    </message>
    <message>
        <source>the file ends after frame %1 of %2</source>
        <translation>ファイルが%2フレーム中フレーム%1で終わっています</translation>
    </message>
    <message>
        <source>a whole file</source>
        <translation>完全なファイル</translation>
    </message>
    <message>
        <source>the file ends within its head</source>
        <translation>ファイルがヘッダーの途中で終わっています</translation>
    </message>
    <message>
        <source>the head has no line %1</source>
        <translation>ヘッダーに%1の行がありません</translation>
    </message>
    <message>
        <source>a whole number from 1 to %1</source>
        <translation>1から%1までの整数</translation>
    </message>
    <message>
        <source>a number above 0 in mm or cm</source>
        <translation>0より大きい数値 (mmまたはcm)</translation>
    </message>
    <message>
        <source>%1 rows x %2 columns, as was asked for</source>
        <translation>指定どおりの%1行 x %2列</translation>
    </message>
    <message>
        <source>a number above 0 in mm2 or cm2</source>
        <translation>0より大きい数値 (mm2またはcm2)</translation>
    </message>
    <message>
        <source>RAW, or a unit of pressure such as kPa or PSI</source>
        <translation>RAW、またはkPaやPSIなどの圧力の単位</translation>
    </message>
    <message>
        <source>the area with which a pressure makes a force</source>
        <translation>圧力を力に換算するための面積</translation>
    </message>
    <message>
        <source>a number above 0, or frames per second (--rate HZ)</source>
        <translation>0より大きい数値、または毎秒のフレーム数 (--rate HZ)</translation>
    </message>
    <message>
        <source>the line is %1</source>
        <translation>行が%1です</translation>
    </message>
    <message>
        <source>the frame has no number</source>
        <translation>フレームに番号がありません</translation>
    </message>
    <message>
        <source>frame %1 comes after frame %2</source>
        <translation>フレーム%2の後にフレーム%1があります</translation>
    </message>
    <message>
        <source>numbers that grow</source>
        <translation>増加する番号</translation>
    </message>
    <message>
        <source>the recording is too long</source>
        <translation>記録が長すぎます</translation>
    </message>
    <message>
        <source>at most %1 values</source>
        <translation>%1個以下の値</translation>
    </message>
    <message>
        <source>frame %1 ends after %2 of %3 rows</source>
        <translation>フレーム%1が%3行中%2行で終わっています</translation>
    </message>
    <message>
        <source>a whole frame</source>
        <translation>完全なフレーム</translation>
    </message>
    <message>
        <source>the row has %1 values</source>
        <translation>行の値は%1個です</translation>
    </message>
    <message>
        <source>%1 values</source>
        <translation>%1個の値</translation>
    </message>
    <message>
        <source>%1 is not a number</source>
        <translation>%1 は数値ではありません</translation>
    </message>
    <message>
        <source>a number or B</source>
        <translation>数値またはB</translation>
    </message>
    <message>
        <source>0 or 1</source>
        <translation>0か1</translation>
    </message>
</context>
<context>
    <name>TextLinesText</name>
    <message>
        <source>the line is longer than 16 MiB</source>
        <translation>行が16 MiBを超えています</translation>
    </message>
    <message>
        <source>a line end</source>
        <translation>行末</translation>
    </message>
    <message>
        <source>the line has a byte 0, which no text has</source>
        <translation>行にバイト0があり、テキストではありません</translation>
    </message>
    <message>
        <source>text</source>
        <translation>テキスト</translation>
    </message>
</context>
<context>
    <name>ThresholdPlan</name>
    <message>
        <source>the protocol has no task &quot;%1&quot;</source>
        <translation>プロトコルに課題「%1」がありません</translation>
    </message>
    <message>
        <source>TASK:threshold with the id of a task with levels</source>
        <translation>TASK:threshold。TASKはレベルのある課題のid</translation>
    </message>
    <message>
        <source>the task %1 has no levels</source>
        <translation>課題%1にレベルがありません</translation>
    </message>
    <message>
        <source>a task that measures a threshold</source>
        <translation>しきい値を測定する課題</translation>
    </message>
    <message>
        <source>the truth says nothing of the threshold of %1</source>
        <translation>真値に%1のしきい値の記述がありません</translation>
    </message>
    <message>
        <source>a [[task]] with that id and a threshold</source>
        <translation>そのidとthresholdを持つ[[task]]</translation>
    </message>
    <message>
        <source>the threshold of %1 cannot be 0</source>
        <translation>%1のしきい値を0にはできません</translation>
    </message>
    <message>
        <source>a level above 0, since the scale is log10</source>
        <translation>0より大きいレベル (尺度がlog10のため)</translation>
    </message>
</context>
<context>
    <name>ThresholdSection</name>
    <message>
        <source>open</source>
        <comment>end of an interval</comment>
        <translation>開放</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <comment>interval</comment>
        <translation>%1～%2</translation>
    </message>
    <message>
        <source>Participant</source>
        <translation>参加者</translation>
    </message>
    <message>
        <source>Condition</source>
        <translation>条件</translation>
    </message>
    <message>
        <source>Track</source>
        <translation>トラック</translation>
    </message>
    <message>
        <source>Each participant; intervals of 95 % by profile likelihood unless the tables say otherwise</source>
        <translation>参加者別。特に表に記載がない限り、プロファイル尤度による95 %区間</translation>
    </message>
    <message>
        <source>Trials</source>
        <translation>試行数</translation>
    </message>
    <message>
        <source>Threshold</source>
        <translation>しきい値</translation>
    </message>
    <message>
        <source>95 %</source>
        <translation>95 %</translation>
    </message>
    <message>
        <source>Slope or spread</source>
        <translation>傾きまたは広がり</translation>
    </message>
    <message>
        <source>Just noticeable difference</source>
        <translation>丁度可知差異</translation>
    </message>
    <message>
        <source>Weber fraction</source>
        <translation>ウェーバー比</translation>
    </message>
    <message>
        <source>p of the deviance</source>
        <translation>逸脱度のp</translation>
    </message>
    <message>
        <source>Estimate of the procedure</source>
        <translation>手続きの推定値</translation>
    </message>
    <message>
        <source>Remark</source>
        <translation>備考</translation>
    </message>
    <message>
        <source>All participants: the mean of their thresholds with Student&apos;s t interval, and one fit of all with a threshold for each</source>
        <translation>全参加者: しきい値の平均とStudentのt区間、および参加者ごとのしきい値を持つ全員の一括当てはめ</translation>
    </message>
    <message>
        <source>Participants</source>
        <translation>参加者数</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>平均</translation>
    </message>
    <message>
        <source>One fit of all</source>
        <translation>全員の一括当てはめ</translation>
    </message>
    <message>
        <source>Spread of the participants</source>
        <translation>参加者間のばらつき</translation>
    </message>
    <message>
        <source>no fit of all: %1</source>
        <translation>全員の一括当てはめなし: %1</translation>
    </message>
    <message>
        <source>Intensities that can be told apart, from the start of the motor to its full drive</source>
        <translation>モーターの始動点から最大駆動量までに区別できる強度</translation>
    </message>
    <message>
        <source>References</source>
        <translation>基準</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>段階数</translation>
    </message>
    <message>
        <source>fewer than three times</source>
        <translation>時間が3つ未満です</translation>
    </message>
    <message>
        <source>the share of yes has no highest point</source>
        <translation>「はい」の割合に最高点がありません</translation>
    </message>
    <message>
        <source>the highest point is outside the times that were shown</source>
        <translation>最高点が提示した時間の範囲外です</translation>
    </message>
    <message>
        <source>The time from burst to burst with the most yes, s</source>
        <translation>「はい」が最も多いバーストからバーストまでの時間、s</translation>
    </message>
    <message>
        <source>Best</source>
        <translation>最良値</translation>
    </message>
    <message>
        <source>Sensitivity d&apos; and criterion c over all levels</source>
        <translation>全レベルにわたる感度d&apos;と判断基準c</translation>
    </message>
    <message>
        <source>Hits</source>
        <translation>ヒット</translation>
    </message>
    <message>
        <source>False alarms</source>
        <translation>誤警報</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>方法</translation>
    </message>
    <message>
        <source>Mean of %1</source>
        <translation>%1名の平均</translation>
    </message>
    <message>
        <source>as in the data</source>
        <translation>データのとおり</translation>
    </message>
    <message>
        <source>Thresholds: %1</source>
        <translation>しきい値: %1</translation>
    </message>
    <message>
        <source>The threshold is where half of the way from guessing to the most right answers is reached. Unit of the levels: %1.</source>
        <translation>しきい値は、当て推量の水準から最も高い正答率までの中間に達する点です。レベルの単位: %1。</translation>
    </message>
    <message>
        <source>Thresholds of the participants, and their means with t intervals.</source>
        <translation>参加者のしきい値と、その平均およびt区間。</translation>
    </message>
</context>
<context>
    <name>ThresholdText</name>
    <message>
        <source>PILOT</source>
        <translation>パイロット</translation>
    </message>
    <message>
        <source>SIMULATED</source>
        <translation>シミュレーション</translation>
    </message>
    <message>
        <source>level, s</source>
        <translation>レベル、s</translation>
    </message>
    <message>
        <source>level</source>
        <translation>レベル</translation>
    </message>
    <message>
        <source>level, %1</source>
        <translation>レベル、%1</translation>
    </message>
    <message>
        <source>share of yes</source>
        <translation>「はい」の割合</translation>
    </message>
    <message>
        <source>share of different</source>
        <translation>「異なる」の割合</translation>
    </message>
    <message>
        <source>share of more</source>
        <translation>「より多い」の割合</translation>
    </message>
    <message>
        <source>share of right answers</source>
        <translation>正答の割合</translation>
    </message>
    <message>
        <source>open</source>
        <comment>end of an interval</comment>
        <translation>開放</translation>
    </message>
    <message>
        <source> (%1 to %2)</source>
        <comment>interval behind a number</comment>
        <translation> (%1～%2)</translation>
    </message>
    <message>
        <source>reversal</source>
        <translation>反転</translation>
    </message>
    <message>
        <source>mean of reversals</source>
        <translation>反転の平均</translation>
    </message>
    <message>
        <source>threshold, 95 %</source>
        <translation>しきい値、95 %</translation>
    </message>
    <message>
        <source>not fitted: the table does not say what guessing gives</source>
        <translation>当てはめなし: 当て推量での値が表に示されていません</translation>
    </message>
    <message>
        <source>no trials</source>
        <translation>試行なし</translation>
    </message>
    <message>
        <source>worse with more of it: are levels or answers swapped?</source>
        <translation>多いほど成績が悪化: レベルまたは回答が入れ替わっていませんか?</translation>
    </message>
    <message>
        <source>the answers do not depend on the level</source>
        <translation>回答がレベルに依存していません</translation>
    </message>
    <message>
        <source>below %1%2, the lowest level</source>
        <translation>最低レベルの%1%2を下回る</translation>
    </message>
    <message>
        <source>above %1%2, the highest level</source>
        <translation>最高レベルの%1%2を上回る</translation>
    </message>
    <message>
        <source>too few levels for a fit; one less is enough with a fixed lapse rate</source>
        <translation>当てはめにはレベルが少なすぎます。ラプス率を固定すれば、必要なレベルは1つ減ります</translation>
    </message>
    <message>
        <source>no level is above 0</source>
        <translation>0より大きいレベルがありません</translation>
    </message>
    <message>
        <source>equal at %1</source>
        <translation>%1 で等価</translation>
    </message>
    <message>
        <source>threshold %1</source>
        <translation>しきい値 %1</translation>
    </message>
    <message>
        <source>a step between two levels, without a threshold</source>
        <translation>2つのレベルの間に段差があり、しきい値なし</translation>
    </message>
    <message>
        <source>, just noticeable %1</source>
        <translation>、丁度可知差異 %1</translation>
    </message>
    <message>
        <source>; a step between two levels</source>
        <translation>、2つのレベルの間に段差</translation>
    </message>
    <message>
        <source>; many lapses, or no upper end</source>
        <translation>、ラプスが多いか、上端がない</translation>
    </message>
    <message>
        <source>the curve does not fit: p of the deviance %1</source>
        <translation>曲線が当てはまりません: 逸脱度のp %1</translation>
    </message>
    <message>
        <source>trial</source>
        <translation>試行</translation>
    </message>
    <message>
        <source>right</source>
        <translation>正答</translation>
    </message>
    <message>
        <source>felt</source>
        <comment>answer: yes, different, more</comment>
        <translation>感じた</translation>
    </message>
    <message>
        <source>wrong</source>
        <translation>誤答</translation>
    </message>
    <message>
        <source>not felt</source>
        <comment>answer: no, same, less</comment>
        <translation>感じなかった</translation>
    </message>
    <message>
        <source>thresholds</source>
        <translation>しきい値</translation>
    </message>
    <message>
        <source>participants</source>
        <translation>参加者</translation>
    </message>
    <message>
        <source>mean, 95 %</source>
        <translation>平均、95 %</translation>
    </message>
    <message>
        <source>d&apos;, c</source>
        <translation>d&apos;、c</translation>
    </message>
    <message>
        <source>d&apos;, 95 %</source>
        <translation>d&apos;、95 %</translation>
    </message>
    <message>
        <source>c (above 0: rather no)</source>
        <translation>c (0より大きい: 「いいえ」寄り)</translation>
    </message>
    <message>
        <source>mean</source>
        <translation>平均</translation>
    </message>
</context>
<context>
    <name>Timeline</name>
    <message>
        <source>hold</source>
        <translation>保持</translation>
    </message>
    <message>
        <source>ease in</source>
        <translation>イーズイン</translation>
    </message>
    <message>
        <source>ease out</source>
        <translation>イーズアウト</translation>
    </message>
    <message>
        <source>ease in and out</source>
        <translation>イーズインアウト</translation>
    </message>
    <message>
        <source>linear</source>
        <translation>線形</translation>
    </message>
    <message>
        <source>Motor %1 at %2°
%3 s: %4 %, %5 Hz</source>
        <translation>モーター%1 (%2°)
%3 s: %4 %、%5 Hz</translation>
    </message>
    <message>
        <source>%1: %2 to %3 s</source>
        <translation>%1: %2～%3 s</translation>
    </message>
    <message>
        <source>Cu&amp;t</source>
        <translation>切り取り(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>コピー(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Paste in place</source>
        <translation>同じ位置に貼り付け(&amp;P)</translation>
    </message>
    <message>
        <source>Paste at play&amp;head</source>
        <translation>再生ヘッドに貼り付け(&amp;H)</translation>
    </message>
    <message>
        <source>&amp;Duplicate</source>
        <translation>複製(&amp;D)</translation>
    </message>
    <message>
        <source>De&amp;lete</source>
        <translation>削除(&amp;L)</translation>
    </message>
    <message>
        <source>commanded</source>
        <translation>指令</translation>
    </message>
    <message>
        <source>predicted (assumed motors)</source>
        <translation>予測 (仮定のモーター)</translation>
    </message>
    <message>
        <source>predicted</source>
        <translation>予測</translation>
    </message>
    <message>
        <source>the motor cannot follow</source>
        <translation>モーターが追従不可</translation>
    </message>
    <message>
        <source>zoom in to see what the motors do</source>
        <translation>拡大するとモーターの動作が見えます</translation>
    </message>
    <message>
        <source>Sweep</source>
        <translation>スイープ</translation>
    </message>
    <message>
        <source>Ring</source>
        <translation>リング</translation>
    </message>
    <message>
        <source>Phantom</source>
        <translation>ファントム</translation>
    </message>
    <message>
        <source>Ramp</source>
        <translation>ランプ</translation>
    </message>
    <message>
        <source>Pulse train</source>
        <translation>パルス列</translation>
    </message>
    <message>
        <source>Stroke</source>
        <translation>ストローク</translation>
    </message>
    <message>
        <source>Δ %1 %, rms %2 %</source>
        <translation>Δ %1 %、rms %2 %</translation>
    </message>
    <message>
        <source>O&amp;verdrive: make the motors start faster</source>
        <translation>オーバードライブ：モーターの立ち上がりを助ける(&amp;V)</translation>
    </message>
</context>
<context>
    <name>TomlEdit</name>
    <message>
        <source>there is no place for the key &quot;%1&quot;</source>
        <translation>キー「%1」の場所がありません</translation>
    </message>
    <message>
        <source>the entry&apos;s number or name, and a key in it</source>
        <translation>項目の番号または名前と、その中のキー</translation>
    </message>
    <message>
        <source>a number from 0 to %1</source>
        <translation>0 から %1 までの番号</translation>
    </message>
    <message>
        <source>tables of the file, with dots between them</source>
        <translation>ファイルの表を点でつないだもの</translation>
    </message>
</context>
<context>
    <name>TomlReader</name>
    <message>
        <source>one of: %1</source>
        <translation>次のいずれか: %1</translation>
    </message>
    <message>
        <source>a number above %1, at most %2</source>
        <translation>%1より大きく%2以下の数値</translation>
    </message>
    <message>
        <source>a number from %1 to %2</source>
        <translation>%1から%2までの数値</translation>
    </message>
    <message>
        <source>a number above %1</source>
        <translation>%1より大きい数値</translation>
    </message>
    <message>
        <source>a number of at least %1</source>
        <translation>%1以上の数値</translation>
    </message>
    <message>
        <source>a number of at most %1</source>
        <translation>%1以下の数値</translation>
    </message>
    <message>
        <source>a number or nan</source>
        <translation>数値またはnan</translation>
    </message>
    <message>
        <source>a finite number</source>
        <translation>有限の数値</translation>
    </message>
    <message>
        <source>wrong type for &quot;%1&quot;</source>
        <translation>「%1」の型が正しくありません</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is out of range: %2</source>
        <translation>「%1」が範囲外です: %2</translation>
    </message>
    <message>
        <source>a text in quotes</source>
        <translation>引用符で囲んだテキスト</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is empty</source>
        <translation>「%1」が空です</translation>
    </message>
    <message>
        <source>a whole number from %1 to %2</source>
        <translation>%1から%2までの整数</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has no unit in its name</source>
        <translation>「%1」の名前に単位がありません</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has another unit in its name</source>
        <translation>「%1」の名前の単位が異なります</translation>
    </message>
    <message>
        <source>unknown key &quot;%1&quot;; perhaps &quot;%2&quot; is meant</source>
        <translation>不明なキー「%1」。「%2」ではありませんか</translation>
    </message>
    <message>
        <source>unknown key &quot;%1&quot;</source>
        <translation>不明なキー「%1」</translation>
    </message>
    <message>
        <source>not valid TOML: %1</source>
        <translation>有効なTOMLではありません: %1</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>trueまたはfalse</translation>
    </message>
    <message>
        <source>unknown value &quot;%1&quot; of &quot;%2&quot;</source>
        <translation>「%2」の値「%1」は不明です</translation>
    </message>
    <message>
        <source>unknown value &quot;%1&quot; of &quot;%2&quot;; perhaps &quot;%3&quot; is meant</source>
        <translation>「%2」の値「%1」は不明です。「%3」ではありませんか</translation>
    </message>
    <message>
        <source>a table: [%1]</source>
        <translation>表: [%1]</translation>
    </message>
    <message>
        <source>tables: [[%1]] or %1 = [{...}]</source>
        <translation>表: [[%1]] または %1 = [{...}]</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has too few entries</source>
        <translation>「%1」の項目が少なすぎます</translation>
    </message>
    <message>
        <source>at least %1</source>
        <translation>%1以上</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is missing</source>
        <translation>「%1」がありません</translation>
    </message>
    <message>
        <source>&quot;%1&quot; and &quot;%2&quot; are the same key</source>
        <translation>「%1」と「%2」は同じキーです</translation>
    </message>
    <message>
        <source>one of them</source>
        <translation>そのうちの1つ</translation>
    </message>
    <message>
        <source>the file is too large</source>
        <translation>ファイルが大きすぎます</translation>
    </message>
    <message>
        <source>at most %1 MiB</source>
        <translation>最大%1 MiB</translation>
    </message>
    <message>
        <source>the keys are nested too deeply</source>
        <translation>キーの入れ子が深すぎます</translation>
    </message>
    <message>
        <source>at most %1 levels</source>
        <translation>最大%1段</translation>
    </message>
    <message>
        <source>a list of %1 lists, each of %2 numbers</source>
        <translation>%1個のリストからなるリスト。各リストは%2個の数値</translation>
    </message>
    <message>
        <source>a list of texts in quotes</source>
        <translation>引用符で囲んだテキストのリスト</translation>
    </message>
    <message>
        <source>a list of one or more values</source>
        <translation>1 つ以上の値のリスト</translation>
    </message>
    <message>
        <source>a number, a text in quotes, or true or false</source>
        <translation>数、引用符で囲んだテキスト、または true か false</translation>
    </message>
    <message>
        <source>a list of lists, each of %1 numbers</source>
        <translation>それぞれ%1個の数からなるリストのリスト</translation>
    </message>
</context>
<context>
    <name>TopicFeedText</name>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1 is silent</source>
        <translation>%1から何も届きません</translation>
    </message>
    <message>
        <source>nobody publishes %1</source>
        <translation>%1 を送信するものがありません</translation>
    </message>
</context>
<context>
    <name>TouchTexts</name>
    <message>
        <source>sponge</source>
        <translation>スポンジ</translation>
    </message>
    <message>
        <source>rubber sponge</source>
        <translation>ゴムスポンジ</translation>
    </message>
    <message>
        <source>rubber</source>
        <translation>ゴム</translation>
    </message>
    <message>
        <source>wood</source>
        <translation>木</translation>
    </message>
    <message>
        <source>metal</source>
        <translation>金属</translation>
    </message>
    <message>
        <source>circle</source>
        <translation>円</translation>
    </message>
    <message>
        <source>rectangle</source>
        <translation>長方形</translation>
    </message>
    <message>
        <source>triangle</source>
        <translation>三角形</translation>
    </message>
    <message>
        <source>arc</source>
        <translation>円弧</translation>
    </message>
    <message>
        <source>line</source>
        <translation>直線</translation>
    </message>
    <message>
        <source>point</source>
        <translation>点</translation>
    </message>
    <message>
        <source>unknown shape</source>
        <translation>不明な形状</translation>
    </message>
    <message>
        <source>SAFE</source>
        <translation>安全</translation>
    </message>
    <message>
        <source>DANGER</source>
        <translation>危険</translation>
    </message>
    <message>
        <source>two points</source>
        <translation>2点</translation>
    </message>
    <message>
        <source>regression</source>
        <translation>回帰</translation>
    </message>
    <message>
        <source>The readings of angle or torque are not usable numbers. Check the arm&apos;s sensors.</source>
        <translation>角度またはトルクの測定値が使えない数値です。アームのセンサーを確認してください。</translation>
    </message>
    <message>
        <source>The noise of the arm&apos;s readings is set below zero.</source>
        <translation>アームの測定値のノイズが負に設定されています。</translation>
    </message>
    <message>
        <source>The torque window is empty: its upper end must lie above its lower end.</source>
        <translation>トルク窓が空です: 上端は下端より上でなければなりません。</translation>
    </message>
    <message>
        <source>No joint samples came in during the touch.</source>
        <translation>タッチ中に関節のサンプルが届きませんでした。</translation>
    </message>
    <message>
        <source>The torque did not change within the torque window. Press with rising force.</source>
        <translation>トルク窓の中でトルクが変化しませんでした。力を増しながら押してください。</translation>
    </message>
    <message>
        <source>The joint turned against the rising torque: the object moved, or a sign is wrong.</source>
        <translation>上昇するトルクに逆らって関節が回りました: 物体が動いたか、符号が誤っています。</translation>
    </message>
    <message>
        <source>shoulder roll</source>
        <translation>肩ロール</translation>
    </message>
    <message>
        <source>shoulder pitch</source>
        <translation>肩ピッチ</translation>
    </message>
    <message>
        <source>shoulder yaw</source>
        <translation>肩ヨー</translation>
    </message>
    <message>
        <source>elbow pitch</source>
        <translation>肘ピッチ</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>held</source>
        <translation>保持</translation>
    </message>
    <message>
        <source>program</source>
        <translation>プログラム</translation>
    </message>
    <message>
        <source>jog</source>
        <translation>ジョグ</translation>
    </message>
    <message>
        <source>N/m</source>
        <translation>N/m</translation>
    </message>
    <message>
        <source>at least %1 (95 %)</source>
        <translation>%1以上 (95 %)</translation>
    </message>
    <message>
        <source>%1 … rigid</source>
        <translation>%1 … 剛体</translation>
    </message>
    <message>
        <source>%1 … %2</source>
        <translation>%1 … %2</translation>
    </message>
    <message>
        <source>The touch was too quick: the arm&apos;s own inertia was felt with the object. Press slower.</source>
        <translation>タッチが速すぎます: アーム自体の慣性が物体とともに感知されました。もっとゆっくり押してください。</translation>
    </message>
    <message>
        <source>joint %1</source>
        <translation>関節 %1</translation>
    </message>
    <message>
        <source>%1 (%2 %)</source>
        <comment>a recognised shape and its confidence</comment>
        <translation>%1 (%2 %)</translation>
    </message>
    <message>
        <source>%1 or %2</source>
        <comment>recognised shapes</comment>
        <translation>%1または%2</translation>
    </message>
    <message>
        <source>The touch was too quick: fewer than 20 independent samples lie in the torque window. Press slower.</source>
        <translation>タッチが速すぎます: トルク窓内の独立なサンプルが20個未満です。もっとゆっくり押してください。</translation>
    </message>
    <message>
        <source>One step of the torque reading is over a tenth of the window.</source>
        <translation>トルクの読みの1刻みが窓の10分の1を超えています。</translation>
    </message>
    <message>
        <source>One step of the angle reading is over a tenth of the rotation.</source>
        <translation>角度の読みの1刻みが回転の10分の1を超えています。</translation>
    </message>
    <message>
        <source>The free joint has a torque; it was taken off.</source>
        <translation>自由な関節にトルクがあり、差し引かれました。</translation>
    </message>
    <message>
        <source>The torque of the free joint changes; the change was taken off.</source>
        <translation>自由な関節のトルクが変化しており、その変化は差し引かれました。</translation>
    </message>
    <message>
        <source>The stiffness changes within the torque window.</source>
        <translation>トルク窓の中で硬さが変化しています。</translation>
    </message>
    <message>
        <source>The force depends on how quickly the object is pressed.</source>
        <translation>力が物体を押す速さに依存しています。</translation>
    </message>
    <message>
        <source>The joint that presses feels nothing of a touch on its axis or along it, or the link&apos;s stiffness is not set. Touch from another side.</source>
        <translation>押す関節は、その軸上または軸方向の接触を感じません。または、リンクの剛性が設定されていません。別の側から触れてください。</translation>
    </message>
    <message>
        <source>The joint that presses felt too little: its torque did not reach the torque window. Press harder, or from another side.</source>
        <translation>押す関節が感じたトルクが小さすぎ、トルクの範囲に達しませんでした。もっと強く、または別の側から押してください。</translation>
    </message>
    <message>
        <source>The arm measures no joint torques, so the touch has a place but no stiffness.</source>
        <translation>アームは関節トルクを測定しないため、接触の位置は分かりますが、剛性は求められません。</translation>
    </message>
    <message>
        <source>The torque jumps or falls back, or the joint has play.</source>
        <translation>トルクが飛ぶか戻るか、関節に遊びがあります。</translation>
    </message>
    <message>
        <source>The noise is correlated; the interval allows for it.</source>
        <translation>ノイズに相関があります。区間はそれを考慮しています。</translation>
    </message>
</context>
<context>
    <name>TrackCommand</name>
    <message>
        <source>%1 of %2 frames could not be used. The last reason: %3</source>
        <translation>%2フレーム中%1フレームを使用できませんでした。最後の理由: %3</translation>
    </message>
    <message>
        <source>Video, pattern of numbered images (frame_%04d.png) or number of a camera; nothing touches the tube in the first frame</source>
        <translation>動画、連番画像のパターン (frame_%04d.png)、またはカメラの番号。最初のフレームではチューブに何も触れていないこと</translation>
    </message>
    <message>
        <source>Camera file, as calibrate writes it</source>
        <translation>calibrateが書き込むカメラファイル</translation>
    </message>
    <message>
        <source>the video has no frame that can be decoded</source>
        <translation>動画に復号できるフレームがありません</translation>
    </message>
    <message>
        <source>Find contacts on the soft tube in a video or live from a camera</source>
        <translation>動画内またはカメラの前のソフトチューブ上の接触</translation>
    </message>
    <message>
        <source>How contacts are found; the more exact, the slower</source>
        <translation>接触の検出方法: 正確なものほど時間がかかります</translation>
    </message>
    <message>
        <source>Frames missing according to their time stamps: %1</source>
        <translation>タイムスタンプから見て欠けているフレーム: %1</translation>
    </message>
    <message>
        <source>the camera has stopped sending frames</source>
        <translation>カメラからフレームが届かなくなりました</translation>
    </message>
</context>
<context>
    <name>TradeoffCommand</name>
    <message>
        <source>there is no ladder &quot;%1&quot; (expected %2)</source>
        <translation>ラダー「%1」はありません (期待される値: %2)</translation>
    </message>
    <message>
        <source>Measure on this machine what accuracy costs in time</source>
        <translation>このマシンで精度にかかる時間のコストを測定します</translation>
    </message>
    <message>
        <source>Ladders of --list; otherwise all of them</source>
        <translation>--listに示すラダー。省略時はすべて</translation>
    </message>
    <message>
        <source>List the ladders</source>
        <translation>ラダーを一覧表示する</translation>
    </message>
    <message>
        <source>Folder for tradeoff.csv and a picture of each ladder (SVG)</source>
        <translation>tradeoff.csvと各ラダーの図 (SVG) のフォルダー</translation>
    </message>
    <message>
        <source>Refuse the times of a rung when the machine ran more unevenly than this meanwhile, in percent</source>
        <translation>測定中のマシンの変動がこれ (%) より大きい場合、その段の時間を棄却する</translation>
    </message>
    <message numerus="yes">
        <source>the machine was too busy: the times of %n rung(s) were refused</source>
        <translation>
            <numerusform>マシンの負荷が高すぎました: %n段の時間を棄却しました</numerusform>
        </translation>
    </message>
    <message>
        <source>a spread of at most %1 %; close other programs, or see --largest-spread</source>
        <translation>ばらつき%1 %以下。ほかのプログラムを閉じるか、--largest-spreadを参照してください</translation>
    </message>
    <message>
        <source>refused</source>
        <translation>棄却</translation>
    </message>
    <message>
        <source>rung</source>
        <translation>段</translation>
    </message>
    <message>
        <source>parameter</source>
        <translation>パラメーター</translation>
    </message>
    <message>
        <source>mean error</source>
        <translation>平均誤差</translation>
    </message>
    <message>
        <source>95 %</source>
        <translation>95 %</translation>
    </message>
    <message>
        <source>worst</source>
        <translation>最悪</translation>
    </message>
    <message>
        <source>median time</source>
        <translation>時間の中央値</translation>
    </message>
    <message>
        <source>99 %</source>
        <translation>99 %</translation>
    </message>
    <message>
        <source>samples</source>
        <translation>サンプル数</translation>
    </message>
    <message>
        <source>spread</source>
        <translation>ばらつき</translation>
    </message>
    <message>
        <source>* no other rung is both as quick and as exact. Measured in %1 s.</source>
        <translation>* これより速くかつ正確な段はほかにありません。測定時間 %1 s。</translation>
    </message>
    <message>
        <source>the folder cannot be made</source>
        <translation>フォルダーを作成できません</translation>
    </message>
    <message>
        <source>Calls of a few microseconds are timed together; their 99 % is one of means.</source>
        <translation>数マイクロ秒の呼び出しはまとめて計測され、その 99 % は平均値のものです。</translation>
    </message>
    <message>
        <source>Fastest: %1, %2 times the limit (%3: %4).</source>
        <translation>最速: %1、限界 (%3: %4) の %2 倍です。</translation>
    </message>
</context>
<context>
    <name>TransferText</name>
    <message>
        <source>Fewer than 4 participants do not show how much people differ, so there is only a bound.</source>
        <translation>参加者が4人未満では個人差がわからないため、限界だけを示します。</translation>
    </message>
    <message>
        <source>With fewer than 20 trials a pattern, or 4 k² for k patterns, there is only a bound.</source>
        <translation>パターンあたりの試行が20回未満、またはk個のパターンで4 k²回未満のときは、限界だけを示します。</translation>
    </message>
    <message>
        <source>Nearly all answers to each pattern are the same; fewer than 10 differ, so there is only a bound.</source>
        <translation>各パターンへの回答はほぼすべて同じで、異なるものは10件未満のため、限界だけを示します。</translation>
    </message>
    <message>
        <source>The answers do not differ from guesses (G test, p ≥ 0.05), so there is only a bound.</source>
        <translation>回答は当て推量と異ならない (G検定、p ≥ 0.05) ため、限界だけを示します。</translation>
    </message>
</context>
<context>
    <name>TrialLines</name>
    <message>
        <source>✓ right</source>
        <translation>✓ 正解</translation>
    </message>
    <message>
        <source>✗ wrong</source>
        <translation>✗ 不正解</translation>
    </message>
    <message>
        <source>no answer</source>
        <translation>無回答</translation>
    </message>
    <message>
        <source>aborted</source>
        <translation>中止</translation>
    </message>
    <message>
        <source>practice %1</source>
        <translation>練習 %1</translation>
    </message>
    <message>
        <source>test %1</source>
        <translation>テスト %1</translation>
    </message>
    <message>
        <source>%1: %2 %3</source>
        <comment>track, level, unit</comment>
        <translation>%1: %2 %3</translation>
    </message>
    <message>
        <source>interrupted, repeated later</source>
        <translation>中断、後で再提示</translation>
    </message>
</context>
<context>
    <name>TriggerOpener</name>
    <message>
        <source>this is no trigger device</source>
        <translation>これはトリガーデバイスではありません</translation>
    </message>
    <message>
        <source>a serial port such as /dev/ttyUSB0, or HOST:PORT for OSC</source>
        <translation>/dev/ttyUSB0などのシリアルポート、またはOSC用のHOST:PORT</translation>
    </message>
</context>
<context>
    <name>UnitAxesText</name>
    <message>
        <source>value</source>
        <translation>値</translation>
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
        <translation>文書型宣言があります</translation>
    </message>
    <message>
        <source>a plain URDF</source>
        <translation>通常のURDF</translation>
    </message>
    <message>
        <source>this is xacro, not URDF</source>
        <translation>これはURDFではなくxacroです</translation>
    </message>
    <message>
        <source>the expanded text: xacro FILE &gt; robot.urdf</source>
        <translation>展開後のテキスト: xacro FILE &gt; robot.urdf</translation>
    </message>
    <message>
        <source>the document is &apos;%1&apos;</source>
        <translation>ドキュメントが「%1」です</translation>
    </message>
    <message>
        <source>&lt;robot name=&quot;...&quot;&gt;</source>
        <translation>&lt;robot name=&quot;...&quot;&gt;</translation>
    </message>
    <message>
        <source>elements are nested more than %1 deep</source>
        <translation>要素の入れ子が%1段を超えています</translation>
    </message>
    <message>
        <source>&lt;robot&gt; with &lt;link&gt; and &lt;joint&gt;</source>
        <translation>&lt;link&gt;と&lt;joint&gt;を持つ&lt;robot&gt;</translation>
    </message>
    <message>
        <source>a well-formed XML document</source>
        <translation>整形式のXMLドキュメント</translation>
    </message>
    <message>
        <source>some links hang on themselves</source>
        <translation>自分自身にぶら下がっているリンクがあります</translation>
    </message>
    <message>
        <source>a tree of links</source>
        <translation>リンクのツリー</translation>
    </message>
    <message>
        <source>link &apos;%1&apos;: %2</source>
        <translation>リンク「%1」: %2</translation>
    </message>
    <message>
        <source>joint &apos;%1&apos;: %2</source>
        <translation>関節「%1」: %2</translation>
    </message>
    <message>
        <source>numbers from -%1 to %1</source>
        <translation>-%1から%1までの数値</translation>
    </message>
    <message>
        <source>a number of its inertial is out of range</source>
        <translation>inertialの数値が範囲外です</translation>
    </message>
    <message>
        <source>its mass is negative</source>
        <translation>質量が負です</translation>
    </message>
    <message>
        <source>0 kg or more</source>
        <translation>0 kg以上</translation>
    </message>
    <message>
        <source>a number of its visual is out of range</source>
        <translation>visualの数値が範囲外です</translation>
    </message>
    <message>
        <source>it is floating or planar</source>
        <translation>floatingまたはplanarです</translation>
    </message>
    <message>
        <source>revolute, continuous, prismatic or fixed</source>
        <translation>revolute、continuous、prismatic、またはfixed</translation>
    </message>
    <message>
        <source>a number of its origin is out of range</source>
        <translation>originの数値が範囲外です</translation>
    </message>
    <message>
        <source>its axis has no direction</source>
        <translation>軸に方向がありません</translation>
    </message>
    <message>
        <source>&lt;axis xyz=&quot;...&quot;&gt; other than 0 0 0</source>
        <translation>0 0 0以外の&lt;axis xyz=&quot;...&quot;&gt;</translation>
    </message>
    <message>
        <source>it has no limits</source>
        <translation>限界値がありません</translation>
    </message>
    <message>
        <source>&lt;limit lower= upper= effort= velocity=&gt;</source>
        <translation>&lt;limit lower= upper= effort= velocity=&gt;</translation>
    </message>
    <message>
        <source>a number of its limits is out of range</source>
        <translation>限界値の数値が範囲外です</translation>
    </message>
    <message>
        <source>a limit of velocity or effort is negative</source>
        <translation>速度または力の限界値が負です</translation>
    </message>
    <message>
        <source>0 or more</source>
        <translation>0以上</translation>
    </message>
    <message>
        <source>its lower limit lies above the upper one</source>
        <translation>下限が上限より上にあります</translation>
    </message>
    <message>
        <source>lower &lt;= upper</source>
        <translation>lower &lt;= upper</translation>
    </message>
    <message>
        <source>it mimics itself</source>
        <translation>自分自身を模倣しています</translation>
    </message>
    <message>
        <source>a mimic of another joint</source>
        <translation>別の関節の模倣</translation>
    </message>
    <message>
        <source>it mimics &apos;%1&apos;, which does not exist</source>
        <translation>模倣先の「%1」が存在しません</translation>
    </message>
    <message>
        <source>the name of a joint</source>
        <translation>関節の名前</translation>
    </message>
    <message>
        <source>a number of its mimic is out of range</source>
        <translation>mimicの数値が範囲外です</translation>
    </message>
    <message>
        <source>the text has %1 bytes</source>
        <translation>テキストが%1バイトあります</translation>
    </message>
    <message>
        <source>at most %1</source>
        <translation>%1以下</translation>
    </message>
    <message>
        <source>this is not a robot</source>
        <translation>これはロボットではありません</translation>
    </message>
    <message>
        <source>a tree of links and joints, http://wiki.ros.org/urdf/XML</source>
        <translation>リンクと関節のツリー、http://wiki.ros.org/urdf/XML</translation>
    </message>
    <message>
        <source>the file does not exist</source>
        <translation>ファイルが存在しません</translation>
    </message>
    <message>
        <source>a URDF file</source>
        <translation>URDFファイル</translation>
    </message>
    <message>
        <source>this is not a file</source>
        <translation>これはファイルではありません</translation>
    </message>
    <message>
        <source>the file has %1 bytes</source>
        <translation>ファイルが%1バイトあります</translation>
    </message>
    <message>
        <source>this cannot be read as a robot (%1)</source>
        <translation>ロボットとして読めません (%1)</translation>
    </message>
</context>
<context>
    <name>ValidatorText</name>
    <message>
        <source>%1 is given, %2 is expected</source>
        <translation>%1が指定されましたが、%2が必要です</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>数値</translation>
    </message>
    <message>
        <source>a number other than 0</source>
        <translation>0以外の数値</translation>
    </message>
    <message>
        <source>a number above 0</source>
        <translation>0より大きい数値</translation>
    </message>
    <message>
        <source>a number from %1 to %2</source>
        <translation>%1から%2までの数値</translation>
    </message>
    <message>
        <source>a whole number from 0 to %1</source>
        <translation>0から%1までの整数</translation>
    </message>
</context>
<context>
    <name>VisionText</name>
    <message>
        <source>The frame could not be decoded.</source>
        <translation>フレームを復号できませんでした。</translation>
    </message>
    <message>
        <source>The image is too small to show printed dots: %1 x %2 pixels.</source>
        <translation>画像が小さすぎて印刷ドットが写りません: %1 x %2画素。</translation>
    </message>
    <message>
        <source>at least %1 pixels on each side</source>
        <translation>各辺%1画素以上</translation>
    </message>
    <message>
        <source>The image shows no printed dots on the skin (%1 found).</source>
        <translation>画像に皮膚の印刷ドットが写っていません (検出数 %1)。</translation>
    </message>
    <message>
        <source>a frame in focus, in which nothing touches the skin</source>
        <translation>皮膚に何も触れていない、ピントの合ったフレーム</translation>
    </message>
    <message>
        <source>The printed dots are too faint to be followed.</source>
        <translation>印刷ドットが薄すぎて追跡できません。</translation>
    </message>
    <message>
        <source>The frame does not show the skin: %1 of %2 dots found.</source>
        <translation>フレームに皮膚が写っていません: %2個中%1個のドットを検出。</translation>
    </message>
    <message>
        <source>The image is too small for optical flow: %1 x %2 pixels.</source>
        <translation>画像が小さすぎてオプティカルフローを計算できません: %1 x %2画素。</translation>
    </message>
    <message>
        <source>There is no frame of the untouched skin to compare with.</source>
        <translation>比較するための、触れられていない皮膚のフレームがありません。</translation>
    </message>
    <message>
        <source>The frame has %1 x %2 pixels.</source>
        <translation>フレームは%1 x %2画素です。</translation>
    </message>
    <message>
        <source>%1 x %2 pixels, as in the camera&apos;s calibration</source>
        <translation>カメラのキャリブレーションと同じ%1 x %2画素</translation>
    </message>
    <message>
        <source>The camera was closed before it was ready.</source>
        <translation>準備ができる前にカメラが閉じられました。</translation>
    </message>
    <message>
        <source>The camera does not see the skin.</source>
        <translation>カメラに皮膚がまったく写っていません。</translation>
    </message>
    <message>
        <source>The image shows no pattern on the skin that could be tracked.</source>
        <translation>画像に、動きを捉えられる皮膚の模様が写っていません。</translation>
    </message>
    <message>
        <source>The image cannot be processed: %1</source>
        <translation>画像を処理できません: %1</translation>
    </message>
    <message>
        <source>There is not enough memory for images of this size.</source>
        <translation>この大きさの画像にはメモリが足りません。</translation>
    </message>
</context>
<context>
    <name>WorkProgress</name>
    <message>
        <source>Cancel</source>
        <translation>キャンセル</translation>
    </message>
</context>
<context>
    <name>WtsText</name>
    <message>
        <source>&quot;%1&quot; is not the address of a tactile array</source>
        <translation>「%1」は触覚アレイのアドレスではありません</translation>
    </message>
    <message>
        <source>the path of a serial port, or tcp://HOST:PORT</source>
        <translation>シリアルポートのパス、またはtcp://HOST:PORT</translation>
    </message>
    <message>
        <source>success</source>
        <translation>成功</translation>
    </message>
    <message>
        <source>not available</source>
        <translation>利用不可</translation>
    </message>
    <message>
        <source>no sensor connected</source>
        <translation>センサー未接続</translation>
    </message>
    <message>
        <source>not initialised</source>
        <translation>未初期化</translation>
    </message>
    <message>
        <source>already running</source>
        <translation>実行中</translation>
    </message>
    <message>
        <source>not supported</source>
        <translation>未対応</translation>
    </message>
    <message>
        <source>inconsistent data</source>
        <translation>データの不整合</translation>
    </message>
    <message>
        <source>read error in the sensor</source>
        <translation>センサー内の読み取りエラー</translation>
    </message>
    <message>
        <source>write error in the sensor</source>
        <translation>センサー内の書き込みエラー</translation>
    </message>
    <message>
        <source>wrong checksum</source>
        <translation>チェックサムの誤り</translation>
    </message>
    <message>
        <source>unknown command</source>
        <translation>不明なコマンド</translation>
    </message>
    <message>
        <source>wrong format</source>
        <translation>形式の誤り</translation>
    </message>
    <message>
        <source>access denied</source>
        <translation>アクセス拒否</translation>
    </message>
    <message>
        <source>status %1</source>
        <translation>ステータス%1</translation>
    </message>
    <message>
        <source>connecting was cancelled</source>
        <translation>接続がキャンセルされました</translation>
    </message>
    <message>
        <source>an array of 1 to %1 rows and columns whose frame fits into one message</source>
        <translation>フレームが1メッセージに収まる、1～%1行・列のアレイ</translation>
    </message>
    <message>
        <source>the sensor&apos;s cells are %1 mm wide and %2 mm high</source>
        <translation>センサーのセルは幅%1 mm、高さ%2 mmです</translation>
    </message>
    <message>
        <source>the sensor describes its array in %1 bytes</source>
        <translation>センサーのアレイ記述が%1バイトです</translation>
    </message>
    <message>
        <source>the 10 bytes of a WTS array</source>
        <translation>WTSアレイの10バイト</translation>
    </message>
    <message>
        <source>the sensor sends no frames: %1</source>
        <translation>センサーがフレームを送信しません: %1</translation>
    </message>
    <message>
        <source>the sensor does not answer</source>
        <translation>センサーが応答しません</translation>
    </message>
    <message>
        <source>the sensor refused a request: %1</source>
        <translation>センサーが要求を拒否しました: %1</translation>
    </message>
    <message>
        <source>Another array is connected: %1 x %2 cells of %3 mm instead of %4 x %5 cells of %6 mm.</source>
        <translation>別のアレイが接続されています: %6 mmの%4 x %5セルではなく、%3 mmの%1 x %2セルです。</translation>
    </message>
    <message>
        <source>The sensor has sent no usable frame for %1 s.</source>
        <translation>センサーから使用可能なフレームが%1 s間届いていません。</translation>
    </message>
    <message>
        <source>the sensor reports %1 rows and %2 columns</source>
        <translation>センサーの報告では%1行%2列です</translation>
    </message>
    <message>
        <source>timeout in the sensor</source>
        <translation>センサー内のタイムアウト</translation>
    </message>
    <message>
        <source>cells with a width and a height</source>
        <translation>幅と高さのあるセル</translation>
    </message>
</context>
<context>
    <name>ZipText</name>
    <message>
        <source>the zip archive is damaged</source>
        <translation>zipアーカイブが破損しています</translation>
    </message>
    <message>
        <source>a zip archive that is not encrypted</source>
        <translation>暗号化されていないzipアーカイブ</translation>
    </message>
    <message>
        <source>the zip archive has too many files</source>
        <translation>zipアーカイブのファイルが多すぎます</translation>
    </message>
    <message>
        <source>at most %1</source>
        <translation>%1以下</translation>
    </message>
    <message>
        <source>the unpacked zip archive is too large</source>
        <translation>展開したzipアーカイブが大きすぎます</translation>
    </message>
    <message>
        <source>at most %1 MiB</source>
        <translation>%1 MiB以下</translation>
    </message>
    <message>
        <source>the zip archive could not be created</source>
        <translation>zipアーカイブを作成できませんでした</translation>
    </message>
</context>
<context>
    <name>teleta::arm_servo::ArmServoPanel</name>
    <message>
        <source>No servo task is possible: %1.</source>
        <translation>サーボタスクは行えません: %1。</translation>
    </message>
    <message>
        <source>Hold to move the arm (or Space)</source>
        <translation>押している間アームが動く (またはスペース)</translation>
    </message>
    <message>
        <source>Hold to rehearse (or Space)</source>
        <translation>押している間リハーサル (またはスペース)</translation>
    </message>
    <message>
        <source>%1, %2, force %3</source>
        <comment>a task, whether there is contact</comment>
        <translation>%1、%2、力 %3</translation>
    </message>
    <message>
        <source>%1. Limits that act: %2</source>
        <translation>%1。働いている制限: %2</translation>
    </message>
    <message>
        <source>Servo task on the arm</source>
        <translation>アームのサーボタスク</translation>
    </message>
    <message>
        <source>&lt;p&gt;Lets the arm do a task by what its pad feels. The first press is a rehearsal on a shadow of the arm, the second one moves the arm. It moves only while you hold the button, or Space.&lt;/p&gt;</source>
        <translation>&lt;p&gt;パッドの感触に従ってアームにタスクを行わせます。最初の押下はアームの影でのリハーサル、2 回目はアームを動かします。ボタンまたはスペースキーを押している間だけ動きます。&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Servo task</source>
        <translation>サーボタスク</translation>
    </message>
    <message>
        <source>&amp;Task</source>
        <translation>タスク(&amp;T)</translation>
    </message>
    <message>
        <source>Force with which the pad presses</source>
        <translation>パッドが押す力</translation>
    </message>
    <message>
        <source>Dead-man switch of the servo task</source>
        <translation>サーボタスクのデッドマンスイッチ</translation>
    </message>
    <message>
        <source>Dead-man switch: the task runs only while this button or Space is held</source>
        <translation>デッドマンスイッチ: このボタンまたはスペースキーを押している間だけタスクが動きます</translation>
    </message>
    <message>
        <source>F&amp;orce</source>
        <translation>力(&amp;O)</translation>
    </message>
</context>
<context>
    <name>teleta::base::FigureExport</name>
    <message>
        <source>SVG picture (*.svg)</source>
        <translation>SVG画像 (*.svg)</translation>
    </message>
    <message>
        <source>PDF document (*.pdf)</source>
        <translation>PDF文書 (*.pdf)</translation>
    </message>
    <message>
        <source>PNG picture (*.png)</source>
        <translation>PNG画像 (*.png)</translation>
    </message>
    <message>
        <source>Comma-separated values (*.csv)</source>
        <translation>コンマ区切り値 (*.csv)</translation>
    </message>
    <message>
        <source>&amp;Copy picture</source>
        <translation>画像をコピー(&amp;C)</translation>
    </message>
    <message>
        <source>Copy &amp;data</source>
        <translation>データをコピー(&amp;D)</translation>
    </message>
    <message>
        <source>&amp;Save picture…</source>
        <translation>画像を保存(&amp;S)…</translation>
    </message>
    <message>
        <source>Save da&amp;ta…</source>
        <translation>データを保存(&amp;T)…</translation>
    </message>
    <message>
        <source>Save picture</source>
        <translation>画像を保存</translation>
    </message>
    <message>
        <source>Save data</source>
        <translation>データを保存</translation>
    </message>
</context>
<context>
    <name>teleta::bracelet::BraceletView</name>
    <message>
        <source>Bracelet</source>
        <translation>ブレスレット</translation>
    </message>
    <message>
        <source>motor %1: %2 %</source>
        <translation>モーター%1: %2 %</translation>
    </message>
    <message>
        <source>Motor %1 at %2°: %3 %</source>
        <translation>モーター%1 (%2°): %3 %</translation>
    </message>
    <message>
        <source>&lt;p&gt;What the six motors of the bracelet are doing, on the unrolled forearm: from left to right once around the arm. The fuller a disc, the stronger the motor vibrates.&lt;/p&gt;&lt;p&gt;With a bracelet connected, hold a disc with the mouse, or one of the keys 1 to 6, to feel that motor alone.&lt;/p&gt;</source>
        <translation>&lt;p&gt;ブレスレットの6個のモーターの現在の動作を、展開した前腕上に示します。左から右へ腕を1周します。円盤が満たされているほど、モーターは強く振動しています。&lt;/p&gt;&lt;p&gt;ブレスレットが接続されている場合、円盤をマウスで押し続けるか、キー1～6を押し続けると、そのモーターだけを感じられます。&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Nothing is playing</source>
        <translation>再生していません</translation>
    </message>
    <message>
        <source>%1: preview</source>
        <comment>a pattern that is not played</comment>
        <translation>%1：プレビュー</translation>
    </message>
</context>
<context>
    <name>teleta::bracelet::StrengthPanel</name>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>to %1 %</source>
        <translation>%1 % まで</translation>
    </message>
    <message>
        <source>Stron&amp;gest</source>
        <translation>最強(&amp;G)</translation>
    </message>
    <message>
        <source>Strongest, all motors</source>
        <translation>最強、全モーター</translation>
    </message>
    <message>
        <source>Each motor</source>
        <translation>モーターごと</translation>
    </message>
    <message>
        <source>A limit for each motor</source>
        <translation>モーターごとの上限</translation>
    </message>
    <message>
        <source>Motor &amp;%1</source>
        <translation>モーター(&amp;%1)</translation>
    </message>
    <message>
        <source>Strongest, motor %1</source>
        <translation>最強、モーター %1</translation>
    </message>
    <message>
        <source>The most that the motors may vibrate, whatever is played. Saved for this bracelet.</source>
        <translation>再生・保持・触感のいずれでも、このブレスレットのモーターの強さの上限です。ブレスレットごとに保存されます。</translation>
    </message>
</context>
<context>
    <name>teleta::calibrate::FeltPanel</name>
    <message>
        <source>The motors were balanced by feel.</source>
        <translation>モーターを感覚に基づいて均一化しました。</translation>
    </message>
    <message>
        <source>Motor %1 starts at %2 % of the full drive (95 %: %3 to %4 %).</source>
        <translation>モーター%1は最大駆動量の%2 %で始動します (95 %: %3～%4 %)。</translation>
    </message>
    <message>
        <source>Start of motor %1</source>
        <translation>モーター%1の始動点</translation>
    </message>
    <message>
        <source>%1 answers so far</source>
        <translation>これまでの回答 %1件</translation>
    </message>
    <message>
        <source>Play the next burst.</source>
        <translation>次のバーストを再生してください。</translation>
    </message>
    <message>
        <source>Did you feel it?</source>
        <translation>感じましたか?</translation>
    </message>
    <message>
        <source>Was the second burst stronger?</source>
        <translation>2番目のバーストのほうが強かったですか?</translation>
    </message>
    <message>
        <source>The bracelet cannot play now: it is not connected, STOP is engaged, or a study uses it.</source>
        <translation>ブレスレットは現在再生できません: 未接続、STOP作動中、または実験で使用中です。</translation>
    </message>
    <message>
        <source>Now and then nothing is played. Answer yes only when you are sure.</source>
        <translation>ときどき何も再生されません。確信があるときだけ「はい」と答えてください。</translation>
    </message>
    <message>
        <source>Guess when you are not sure.</source>
        <translation>わからないときは推測で答えてください。</translation>
    </message>
    <message>
        <source>Questions about what is felt</source>
        <translation>感覚に関する質問</translation>
    </message>
    <message>
        <source>Play (Space)</source>
        <translation>再生 (Space)</translation>
    </message>
    <message>
        <source>Yes (Y)</source>
        <translation>はい (Y)</translation>
    </message>
    <message>
        <source>No (N)</source>
        <translation>いいえ (N)</translation>
    </message>
    <message>
        <source>Take back the last answer (Backspace)</source>
        <translation>最後の回答を取り消す (Backspace)</translation>
    </message>
    <message>
        <source>Give up</source>
        <translation>やめる</translation>
    </message>
    <message>
        <source>Leave the motors as they were</source>
        <translation>モーターを元のままにする</translation>
    </message>
    <message>
        <source>Strength of motor %1, compared with motor 1</source>
        <translation>モーター1と比べたモーター%1の強さ</translation>
    </message>
    <message>
        <source>The answers contradict each other.</source>
        <translation>回答に整合性がありません。</translation>
    </message>
    <message>
        <source>Play the burst, as often as you like</source>
        <translation>バーストを何度でも感じられます</translation>
    </message>
</context>
<context>
    <name>teleta::calibrate::GainsView</name>
    <message>
        <source>%1 of %2 taxels have gains from %3 to %4.</source>
        <translation>%2個中%1個のタクセルのゲインは%3から%4です。</translation>
    </message>
    <message numerus="yes">
        <source>%n dead</source>
        <comment>taxels</comment>
        <translation>
            <numerusform>不良%n個</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n too weak</source>
        <comment>taxels</comment>
        <translation>
            <numerusform>弱すぎ%n個</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n too strong</source>
        <comment>taxels</comment>
        <translation>
            <numerusform>強すぎ%n個</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n stuck</source>
        <comment>taxels</comment>
        <translation>
            <numerusform>固着%n個</numerusform>
        </translation>
    </message>
    <message>
        <source>Not used: %1.</source>
        <comment>kinds of taxels</comment>
        <translation>使用しないもの: %1。</translation>
    </message>
    <message>
        <source>No array</source>
        <translation>アレイがありません</translation>
    </message>
    <message>
        <source>no gains: every taxel counts as it is</source>
        <translation>ゲインなし: 各タクセルはそのまま数えられます</translation>
    </message>
    <message>
        <source>gains in use, saved</source>
        <translation>ゲイン使用中、保存済み</translation>
    </message>
    <message>
        <source>gains in use, not saved</source>
        <translation>ゲイン使用中、未保存</translation>
    </message>
    <message>
        <source>1. The array is tared.</source>
        <translation>1. アレイのゼロ点は調整済みです。</translation>
    </message>
    <message>
        <source>2. Press evenly on the whole array, with a bladder or with a plate on foam. The load may change.</source>
        <translation>2. ブラダーか、フォームに載せた板で、アレイ全体を均一に押します。荷重は変化してもかまいません。</translation>
    </message>
    <message numerus="yes">
        <source>%n press(es) so far.</source>
        <translation>
            <numerusform>これまでに%n回の押圧。</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 of %2 taxels are under load.</source>
        <translation>%2個中%1個のタクセルに荷重がかかっています。</translation>
    </message>
    <message>
        <source>Keep pressing: %1 of %2 taxels are under load.</source>
        <translation>押し続けてください: %2個中%1個のタクセルに荷重がかかっています。</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>元に戻す</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>やり直す</translation>
    </message>
    <message>
        <source>&amp;Load…</source>
        <translation>読み込み(&amp;L)…</translation>
    </message>
    <message>
        <source>Use no gains and forget all presses</source>
        <translation>ゲインを使わず、すべての押圧を破棄します</translation>
    </message>
    <message>
        <source>&amp;Save…</source>
        <translation>保存(&amp;S)…</translation>
    </message>
    <message>
        <source>Takes the mean of the next half second as the unloaded state. Nothing may touch the array.</source>
        <translation>次の0.5秒間の平均を無荷重状態とします。アレイに何も触れないようにしてください。</translation>
    </message>
    <message>
        <source>&amp;Collect a press</source>
        <translation>押圧を収集(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;End</source>
        <translation>終了(&amp;E)</translation>
    </message>
    <message>
        <source>Use what has been collected</source>
        <translation>収集した分を使います</translation>
    </message>
    <message>
        <source>&amp;Open recorded presses…</source>
        <translation>記録した押圧を開く(&amp;O)…</translation>
    </message>
    <message>
        <source>Open the &amp;demo</source>
        <translation>デモを開く(&amp;D)</translation>
    </message>
    <message>
        <source>A simulated plate presses evenly on an array whose taxels differ</source>
        <translation>シミュレーションの板が、タクセルの異なるアレイを均一に押します</translation>
    </message>
    <message>
        <source>Gains of the taxels</source>
        <translation>タクセルのゲイン</translation>
    </message>
    <message>
        <source>Share of the press that has been collected</source>
        <translation>収集済みの押圧の割合</translation>
    </message>
    <message>
        <source>Calibration of an array&apos;s taxels</source>
        <translation>アレイのタクセルのキャリブレーション</translation>
    </message>
    <message>
        <source>The least certain gain has a standard error of %1 %.</source>
        <translation>最も不確かなものは%1 %の精度です (標準誤差)。</translation>
    </message>
    <message>
        <source>Gains vary by %1 % from press to press.</source>
        <translation>ゲインは押圧ごとに%1 %異なります。</translation>
    </message>
    <message>
        <source>The response changes by %1 % along x and %2 % along y: the load may have been uneven. Turn the bladder or plate by 180° and collect another press: the difference cancels out.</source>
        <translation>応答がx方向に%1 %、y方向に%2 %変化しています。荷重が均一でなかった可能性があります。押すものを半回転させてもう一度収集すると、差は打ち消されます。</translation>
    </message>
    <message>
        <source>Open an array, a recording or a scene on the page Operate, or the demo.</source>
        <translation>「操作」ページでアレイ、記録、シーンを開くか、ここでデモを開いてください。</translation>
    </message>
    <message>
        <source>computing the gains…</source>
        <translation>ゲインを計算中…</translation>
    </message>
    <message>
        <source>1. Tare the array with nothing touching it.</source>
        <translation>1. アレイに何も触れない状態でゼロ点を調整します。</translation>
    </message>
    <message>
        <source>Undo the last change (Ctrl+Z)</source>
        <translation>最後の変更を取り消します (Ctrl+Z)</translation>
    </message>
    <message>
        <source>Redo the change undone last</source>
        <translation>取り消したものを復元します</translation>
    </message>
    <message>
        <source>Load gains for an array of this size from a file (CSV)</source>
        <translation>同じサイズのアレイのゲインをファイル (CSV) から読みます</translation>
    </message>
    <message>
        <source>Save the gains to a file (CSV) for “Open recording”, source lists and the command line</source>
        <translation>ゲインをファイル (CSV) に書き出します。「記録を開く」、ソースリスト、コマンドラインがこれを読みます</translation>
    </message>
    <message>
        <source>Wait for a load and collect its frames; stops by itself</source>
        <translation>荷重を待ってそのフレームを取り込み、自動的に終わります</translation>
    </message>
    <message>
        <source>Frames as CSV, one file per press: time_s,t0,t1,…</source>
        <translation>CSVのフレーム、押圧ごとに1ファイル: time_s,t0,t1,…</translation>
    </message>
    <message>
        <source>Red taxels read too low and are raised, blue ones are lowered, hatched ones are not used. Point at a taxel, or use the arrow keys, to read its gain.</source>
        <translation>赤いタクセルは感度が低いため引き上げられ、青いものは引き下げられ、斜線のものは使われません。矢印キーかマウスで1つずつ読めます。</translation>
    </message>
    <message>
        <source>Rese&amp;t</source>
        <translation>リセット(&amp;T)</translation>
    </message>
    <message>
        <source>Tare &amp;now</source>
        <translation>ゼロ点調整(&amp;N)</translation>
    </message>
    <message>
        <source>Waiting for a load on more than half of the taxels: %1 of %2 now. If the array is pressed already, it was tared under that load: take the load off and tare again.</source>
        <translation>半分を超えるタクセルへの荷重を待っています: 現在%2個中%1個。アレイがすでに押されている場合は、その荷重のままゼロ点が調整されています。荷重を取り除いて、もう一度ゼロ点を調整してください。</translation>
    </message>
    <message>
        <source>The taxels differ by %1 % without gains, by %2 % with them.</source>
        <translation>タクセルのばらつきは、ゲインなしで%1 %、ゲインありで%2 %です。</translation>
    </message>
    <message>
        <source>The taxels differ by %1 % under this load.</source>
        <translation>この荷重でのタクセルのばらつきは%1 %です。</translation>
    </message>
</context>
<context>
    <name>teleta::calibrate::LatencyChart</name>
    <message>
        <source>click</source>
        <translation>クリック</translation>
    </message>
    <message>
        <source>latency</source>
        <translation>遅延</translation>
    </message>
    <message>
        <source>Latency of the clicks: none was heard yet</source>
        <translation>クリックの遅延: まだ聞こえていません</translation>
    </message>
    <message>
        <source>Latency of the clicks: %1 ms</source>
        <translation>クリックの遅延: %1 ms</translation>
    </message>
</context>
<context>
    <name>teleta::calibrate::LoadsView</name>
    <message>
        <source>No presses</source>
        <translation>押しがありません</translation>
    </message>
    <message>
        <source>computing…</source>
        <translation>計算中…</translation>
    </message>
    <message>
        <source>no calibration yet</source>
        <translation>キャリブレーションはまだありません</translation>
    </message>
    <message>
        <source>calibration saved</source>
        <translation>キャリブレーションは保存済み</translation>
    </message>
    <message>
        <source>calibration not saved</source>
        <translation>キャリブレーションは未保存</translation>
    </message>
    <message>
        <source>This one has %1.</source>
        <translation>この表には%1があります。</translation>
    </message>
    <message>
        <source>2. Tick the columns that are signals.</source>
        <translation>2. 信号である列にチェックを入れます。</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>元に戻す</translation>
    </message>
    <message>
        <source>Undo the last change (Ctrl+Z)</source>
        <translation>最後の変更を元に戻す (Ctrl+Z)</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>やり直し</translation>
    </message>
    <message>
        <source>Redo the change undone last</source>
        <translation>最後に元に戻した変更をやり直す</translation>
    </message>
    <message>
        <source>&amp;Load…</source>
        <translation>読み込み(&amp;L)…</translation>
    </message>
    <message>
        <source>Show a calibration from a file (CSV)</source>
        <translation>ファイル(CSV)のキャリブレーションを表示する</translation>
    </message>
    <message>
        <source>&amp;Save…</source>
        <translation>保存(&amp;S)…</translation>
    </message>
    <message>
        <source>Save the calibration (CSV) for the key “loads” of a sensor&apos;s file and the command line</source>
        <translation>センサーのファイルのキー「loads」とコマンドラインのためにキャリブレーション(CSV)を保存する</translation>
    </message>
    <message>
        <source>&amp;Open presses…</source>
        <translation>押しを開く(&amp;O)…</translation>
    </message>
    <message>
        <source>A table (CSV) with a row for each press</source>
        <translation>押しごとに1行の表(CSV)</translation>
    </message>
    <message>
        <source>Find the &amp;gains</source>
        <translation>ゲインを求める(&amp;G)</translation>
    </message>
    <message>
        <source>Least squares over the presses under load</source>
        <translation>荷重のある押しにわたる最小二乗法</translation>
    </message>
    <message>
        <source>Columns that may be signals</source>
        <translation>信号になりうる列</translation>
    </message>
    <message>
        <source>Gains of the signals</source>
        <translation>信号のゲイン</translation>
    </message>
    <message>
        <source>Load</source>
        <translation>荷重</translation>
    </message>
    <message>
        <source>Signal</source>
        <translation>信号</translation>
    </message>
    <message>
        <source>Gain</source>
        <comment>N per unit of a signal</comment>
        <translation>ゲイン</translation>
    </message>
    <message>
        <source>Standard error</source>
        <translation>標準誤差</translation>
    </message>
    <message>
        <source>Presses from</source>
        <comment>a signal</comment>
        <translation>押しの範囲 (から)</translation>
    </message>
    <message>
        <source>to</source>
        <comment>a signal</comment>
        <translation>まで</translation>
    </message>
    <message>
        <source>The newtons for one unit of each signal will be shown here.</source>
        <translation>各信号の1単位あたりのニュートンがここに表示されます。</translation>
    </message>
    <message>
        <source>Calibration of a sensor to newtons</source>
        <translation>センサーのニュートンへのキャリブレーション</translation>
    </message>
    <message>
        <source>%1: residual standard deviation %2.</source>
        <comment>a load</comment>
        <translation>%1：残差の標準偏差 %2。</translation>
    </message>
    <message>
        <source>Condition number of the presses: %1. From %2 on, the signals cannot be told apart.</source>
        <translation>押し付けの条件数：%1。%2以上では信号を区別できません。</translation>
    </message>
    <message>
        <source>1. Open a table (CSV) with one row per press: the signals of the sensor, and the known load in force_n, shear_x_n, shear_y_n or moment_nm. Rows without load give the signals at rest.</source>
        <translation>1. 1行が1回の押し付けを表すCSVの表を開きます：センサーの信号と、force_n、shear_x_n、shear_y_n、moment_nm のいずれかの既知の荷重。荷重のない行は静止時の信号になります。</translation>
    </message>
    <message>
        <source>signal</source>
        <translation>信号</translation>
    </message>
    <message>
        <source>No calibration yet</source>
        <translation>校正はまだありません</translation>
    </message>
</context>
<context>
    <name>teleta::calibrate::MotorChart</name>
    <message>
        <source>Speed of motor %1 over its drive</source>
        <translation>モーター%1の速度と駆動量の関係</translation>
    </message>
    <message>
        <source>Recording of motor %1, and the model</source>
        <translation>モーター%1の記録とモデル</translation>
    </message>
    <message>
        <source>assumed</source>
        <translation>仮定値</translation>
    </message>
    <message>
        <source>curve</source>
        <translation>曲線</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>測定値</translation>
    </message>
    <message>
        <source>Motor %1: curve and lag are assumed</source>
        <translation>モーター%1: 曲線と遅れは仮定値</translation>
    </message>
    <message>
        <source>Motor %1</source>
        <translation>モーター%1</translation>
    </message>
    <message>
        <source>%1 % of the variance, residual %2 Hz</source>
        <translation>分散の%1 %、残差 %2 Hz</translation>
    </message>
    <message>
        <source>No recording of this motor yet: measure it, or open a recording.</source>
        <translation>このモーターの記録はまだありません: 測定するか、記録を開いてください。</translation>
    </message>
    <message>
        <source>measured (simulated)</source>
        <translation>測定値 (シミュレーション)</translation>
    </message>
    <message>
        <source>model</source>
        <translation>モデル</translation>
    </message>
    <message>
        <source>residual</source>
        <translation>残差</translation>
    </message>
    <message>
        <source>drive</source>
        <translation>駆動</translation>
    </message>
    <message>
        <source>speed</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>time</source>
        <translation>時間</translation>
    </message>
</context>
<context>
    <name>teleta::calibrate::MotorTable</name>
    <message>
        <source>assumed</source>
        <translation>仮定</translation>
    </message>
    <message>
        <source>by feel</source>
        <translation>感覚</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>測定</translation>
    </message>
    <message>
        <source>Motor %1</source>
        <translation>モーター%1</translation>
    </message>
    <message>
        <source>start %1, lag and curve %2</source>
        <comment>where the values come from</comment>
        <translation>始動点: %1、遅れと曲線: %2</translation>
    </message>
    <message>
        <source>Motors of the bracelet</source>
        <translation>ブレスレットのモーター</translation>
    </message>
    <message>
        <source>Motor</source>
        <translation>モーター</translation>
    </message>
    <message>
        <source>Drive at which the motor begins to turn, with its standard error</source>
        <translation>モーターが回り始める駆動量とその標準誤差</translation>
    </message>
    <message>
        <source>Drive of intensity 1, so that all motors are equally strong</source>
        <translation>全モーターの強さをそろえるための、強度1の駆動量</translation>
    </message>
    <message>
        <source>From rest to 90 % of a speed</source>
        <translation>静止状態から速度の90 %まで</translation>
    </message>
    <message>
        <source>From a speed to 10 % of it</source>
        <translation>ある速度からその10 %まで</translation>
    </message>
    <message>
        <source>Speed at the full drive of this motor</source>
        <translation>このモーターの最大駆動量での速度</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>ソース</translation>
    </message>
    <message>
        <source>measured, by feel</source>
        <comment>where the values come from</comment>
        <translation>測定、感覚</translation>
    </message>
    <message>
        <source>partly by feel</source>
        <comment>where the values come from</comment>
        <translation>一部は感覚</translation>
    </message>
    <message>
        <source>partly measured</source>
        <comment>where the values come from</comment>
        <translation>一部は測定</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>始動</translation>
    </message>
    <message>
        <source>Full</source>
        <translation>全開</translation>
    </message>
    <message>
        <source>Rise</source>
        <translation>上昇</translation>
    </message>
    <message>
        <source>Fall</source>
        <translation>下降</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>速度</translation>
    </message>
</context>
<context>
    <name>teleta::calibrate::MotorsView</name>
    <message>
        <source>Motor %1 was not calibrated. %2</source>
        <comment>a motor, and why not</comment>
        <translation>モーター%1はキャリブレーションされませんでした。%2</translation>
    </message>
    <message>
        <source>Motor %1: starts at %2 to %3 % of the drive, rises in %4 ± %5 ms, falls in %6 ± %7 ms, reaches %8 Hz.</source>
        <translation>モーター%1: 駆動量の%2～%3 %で始動、立ち上がり%4 ± %5 ms、立ち下がり%6 ± %7 ms、%8 Hzに到達します。</translation>
    </message>
    <message>
        <source>No bracelet</source>
        <translation>ブレスレットなし</translation>
    </message>
    <message>
        <source>Choose a bracelet in the menu Bracelet.</source>
        <translation>ブレスレットメニューでブレスレットを選んでください。</translation>
    </message>
    <message>
        <source>calibrated, saved</source>
        <translation>キャリブレーション済み、保存済み</translation>
    </message>
    <message>
        <source>calibrated, not saved</source>
        <translation>キャリブレーション済み、未保存</translation>
    </message>
    <message>
        <source>Motor %1</source>
        <translation>モーター%1</translation>
    </message>
    <message>
        <source>Drive the motor up and down and record it with the bracelet&apos;s sensor</source>
        <translation>モーターの駆動量を上げ下げし、ブレスレットのセンサーで記録します</translation>
    </message>
    <message>
        <source>This bracelet has no sensor: open a recording, or answer by feel</source>
        <translation>このブレスレットにはセンサーがありません: 記録を開くか、感覚で回答してください</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>元に戻す</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>やり直す</translation>
    </message>
    <message>
        <source>&amp;Load…</source>
        <translation>読み込み(&amp;L)…</translation>
    </message>
    <message>
        <source>Save a &amp;copy…</source>
        <translation>コピーを保存(&amp;C)…</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>保存(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Measure this motor</source>
        <translation>このモーターを測定(&amp;M)</translation>
    </message>
    <message>
        <source>One after another, with the bracelet&apos;s sensor</source>
        <translation>ブレスレットのセンサーで1個ずつ順に</translation>
    </message>
    <message>
        <source>&amp;Open a recording…</source>
        <translation>記録を開く(&amp;O)…</translation>
    </message>
    <message>
        <source>Compare the strength of each motor with that of motor 1</source>
        <translation>各モーターの強さをモーター1と比べます</translation>
    </message>
    <message>
        <source>Stop measuring</source>
        <translation>測定を停止</translation>
    </message>
    <message>
        <source>Calibration of the bracelet&apos;s motors</source>
        <translation>ブレスレットモーターのキャリブレーション</translation>
    </message>
    <message>
        <source>Turning at %1 Hz, measured by the bracelet&apos;s sensor.</source>
        <translation>ブレスレットのセンサーによると、現在%1 Hzで回転しています。</translation>
    </message>
    <message>
        <source>All motors use assumed values again. Undo brings the measurements back.</source>
        <translation>全モーターを仮定値に戻しました。「元に戻す」で測定値を復元できます。</translation>
    </message>
    <message>
        <source>Every measured motor is now limited to the top speed of the slowest one.</source>
        <translation>測定済みの全モーターの上限を、最も遅いモーターの速度にそろえました。</translation>
    </message>
    <message>
        <source>Measuring motor %1: steps up to full drive, then pulses.</source>
        <translation>モーター%1を測定中: 最大駆動量までの階段、続いてパルス。</translation>
    </message>
    <message>
        <source>not calibrated: the motors use assumed values</source>
        <translation>未キャリブレーション: モーターは仮定値です</translation>
    </message>
    <message>
        <source>a study uses the bracelet: its motors cannot be changed</source>
        <translation>実験がブレスレットを使用中です: モーターの設定は変わりません</translation>
    </message>
    <message>
        <source>Undo the last change or answer (Ctrl+Z)</source>
        <translation>最後の変更または最後の回答を取り消します (Ctrl+Z)</translation>
    </message>
    <message>
        <source>Redo the change undone last</source>
        <translation>取り消したものを復元します</translation>
    </message>
    <message>
        <source>Load a profile of this bracelet from a file</source>
        <translation>このブレスレットのプロファイルをファイルから読み込みます</translation>
    </message>
    <message>
        <source>Save the profile to another file</source>
        <translation>プロファイルを別のファイルに書き込みます</translation>
    </message>
    <message>
        <source>Discard the measurements</source>
        <translation>測定値を破棄します</translation>
    </message>
    <message>
        <source>Save the profile for this bracelet: it is used whenever the bracelet is connected</source>
        <translation>このブレスレット用にプロファイルを保存します: 接続するたびに使用されます</translation>
    </message>
    <message>
        <source>CSV with time_s, commanded, and speed_hz (tachometer) or signal (accelerometer, microphone)</source>
        <translation>time_s,commanded に加え、回転計のspeed_hz、または加速度計かマイクのsignalを含むCSV</translation>
    </message>
    <message>
        <source>Save the &amp;excitation…</source>
        <translation>励振信号を書き込む(&amp;E)…</translation>
    </message>
    <message>
        <source>Save the drive signal of a measurement as CSV, to record with a sensor of your own</source>
        <translation>測定中のモーターへの指令 (CSV): ご自身のセンサーを使う場合</translation>
    </message>
    <message>
        <source>Plays weaker and stronger bursts; you say what you felt</source>
        <translation>弱くなったり強くなったりするバースト。感じたかどうかを答えます</translation>
    </message>
    <message>
        <source>Limit all measured motors to the top speed of the slowest</source>
        <translation>測定済みの全モーターの上限を、最も遅いモーターの速度にそろえます</translation>
    </message>
    <message>
        <source>The computer was busy: %1 % of the time has no readings. Measure again with fewer programs running.</source>
        <translation>コンピューターがビジーでした: 時間の%1 %に測定値がありません。実行中のプログラムを減らして測定し直してください。</translation>
    </message>
    <message>
        <source>Measuring motor %1, %2 of %3: steps up to full drive, then pulses.</source>
        <translation>モーター %1 を測定中（%3 個中 %2 個目）：最大駆動までの段階、続いてパルス。</translation>
    </message>
    <message>
        <source>What to do: %1.</source>
        <translation>対処：%1。</translation>
    </message>
    <message>
        <source>With its sensor</source>
        <translation>内蔵センサーで</translation>
    </message>
    <message>
        <source>By feel</source>
        <translation>体感で</translation>
    </message>
    <message>
        <source>By the curves</source>
        <translation>曲線から</translation>
    </message>
    <message>
        <source>In files</source>
        <translation>ファイルで</translation>
    </message>
    <message>
        <source>Rese&amp;t</source>
        <translation>リセット(&amp;T)</translation>
    </message>
    <message>
        <source>Measure all si&amp;x</source>
        <translation>6個すべて測定(&amp;X)</translation>
    </message>
    <message>
        <source>Fi&amp;nd the start by feel</source>
        <translation>感覚で始動点を探す(&amp;N)</translation>
    </message>
    <message>
        <source>Balance b&amp;y feel</source>
        <translation>感覚で均一化(&amp;Y)</translation>
    </message>
    <message>
        <source>Balance by the c&amp;urves</source>
        <translation>曲線で均一化(&amp;U)</translation>
    </message>
    <message numerus="yes">
        <source>%n of %1 motors calibrated, saved</source>
        <translation>
            <numerusform>%1個中%n個のモーターをキャリブレーション済み、保存済み</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n of %1 motors calibrated, not saved</source>
        <translation>
            <numerusform>%1個中%n個のモーターをキャリブレーション済み、未保存</numerusform>
        </translation>
    </message>
    <message>
        <source>Curves</source>
        <translation>曲線</translation>
    </message>
    <message>
        <source>Motors</source>
        <translation>モーター</translation>
    </message>
</context>
<context>
    <name>teleta::calibrate::StepList</name>
    <message>
        <source>running</source>
        <translation>実行中</translation>
    </message>
    <message>
        <source>not saved</source>
        <comment>a calibration</comment>
        <translation>未保存</translation>
    </message>
    <message>
        <source>done</source>
        <comment>a calibration</comment>
        <translation>完了</translation>
    </message>
    <message>
        <source>failed</source>
        <comment>a calibration</comment>
        <translation>失敗</translation>
    </message>
    <message>
        <source>%1 of %2 done</source>
        <translation>%2 中 %1 完了</translation>
    </message>
    <message>
        <source>to do</source>
        <comment>a calibration</comment>
        <translation>未実施</translation>
    </message>
    <message>
        <source>%1. %2: %3</source>
        <comment>number, name and state of a step</comment>
        <translation>%1. %2: %3</translation>
    </message>
    <message>
        <source>running: %1 of %2</source>
        <translation>実行中: %2個中%1個</translation>
    </message>
</context>
<context>
    <name>teleta::camera::CameraPanel</name>
    <message>
        <source>Pause</source>
        <translation>一時停止</translation>
    </message>
    <message>
        <source>Waiting for a picture of the tube with nothing touching it.</source>
        <translation>何も触れていないチューブの画像を待っています。</translation>
    </message>
    <message>
        <source>No reference yet: %1</source>
        <translation>基準はまだありません: %1</translation>
    </message>
    <message>
        <source>This finder cannot be used: %1</source>
        <translation>この検出器は使用できません: %1</translation>
    </message>
    <message>
        <source>Finder</source>
        <translation>検出器</translation>
    </message>
    <message>
        <source>&amp;Displacement</source>
        <translation>変位(&amp;D)</translation>
    </message>
    <message>
        <source>Show how far the pattern on the skin has moved</source>
        <translation>皮膚の模様がどれだけ動いたかを表示します</translation>
    </message>
    <message>
        <source>Resume</source>
        <translation>続行</translation>
    </message>
    <message>
        <source>Picture not used: %1</source>
        <translation>不使用: %1</translation>
    </message>
    <message>
        <source>How contacts are found: from the printed dots alone, or with dense flow by one of OpenCV&apos;s presets; the number is how many times the image is reduced</source>
        <translation>接触の検出方法: 印刷ドットのみ、またはOpenCVのプリセットによる密オプティカルフロー。数字は画像サイズを割る数です</translation>
    </message>
    <message>
        <source>Take the next picture as the reference: nothing may touch the tube</source>
        <translation>次の画像を、触れられていないチューブの画像とします</translation>
    </message>
    <message>
        <source>Freeze the picture; contacts are still tracked (Space)</source>
        <translation>この画像を保持します。接触の追跡は続きます (Space)</translation>
    </message>
    <message>
        <source>F&amp;inder</source>
        <translation>検出器(&amp;I)</translation>
    </message>
    <message>
        <source>Ne&amp;w reference</source>
        <translation>新しい基準(&amp;W)</translation>
    </message>
    <message>
        <source>Preparing the finder: %1.</source>
        <translation>検出器を準備しています: %1</translation>
    </message>
</context>
<context>
    <name>teleta::camera::CameraView</name>
    <message>
        <source>camera</source>
        <translation>カメラ</translation>
    </message>
    <message>
        <source>&amp;Pause the picture</source>
        <translation>画像を一時停止(&amp;P)</translation>
    </message>
    <message>
        <source>Show &amp;all</source>
        <translation>全体を表示(&amp;A)</translation>
    </message>
    <message>
        <source>Camera picture</source>
        <translation>カメラ画像</translation>
    </message>
    <message>
        <source>&lt;p&gt;What the camera sees inside the tube. Lines show, enlarged, how far the printed pattern has moved since nothing touched the tube; outlines are contacts, each in the colour of its number.&lt;/p&gt;&lt;p&gt;Ctrl+wheel zooms, dragging moves, a double click shows all.&lt;/p&gt;</source>
        <translation>&lt;p&gt;カメラから見たチューブの内側です。線は、チューブに何も触れていない状態から印刷模様がどれだけ動いたかを拡大して示します。輪郭線は接触で、それぞれ番号に応じた色です。&lt;/p&gt;&lt;p&gt;Ctrl+ホイールで拡大・縮小、ドラッグで移動、ダブルクリックで全体を表示します。&lt;/p&gt;</translation>
    </message>
    <message>
        <source>&amp;Resume</source>
        <translation>続行(&amp;G)</translation>
    </message>
</context>
<context>
    <name>teleta::camera::EventList</name>
    <message>
        <source>&amp;Clear the list</source>
        <translation>一覧を消去(&amp;C)</translation>
    </message>
    <message>
        <source>Events</source>
        <translation>イベント</translation>
    </message>
</context>
<context>
    <name>teleta::camera::EventModel</name>
    <message>
        <source>touched</source>
        <translation>接触</translation>
    </message>
    <message>
        <source>BUMP</source>
        <translation>衝突</translation>
    </message>
    <message>
        <source>arm follows</source>
        <translation>アームが追従</translation>
    </message>
    <message>
        <source>reference taken</source>
        <translation>基準を取得</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>時刻</translation>
    </message>
    <message>
        <source>Event</source>
        <translation>イベント</translation>
    </message>
    <message>
        <source>Contact</source>
        <translation>接触</translation>
    </message>
    <message>
        <source>Along the tube</source>
        <translation>軸方向</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>深さ</translation>
    </message>
    <message>
        <source>released</source>
        <translation>離脱</translation>
    </message>
    <message>
        <source>restarted</source>
        <translation>再開始</translation>
    </message>
    <message>
        <source>Around the tube</source>
        <translation>周方向</translation>
    </message>
    <message>
        <source>Along</source>
        <comment>the tube</comment>
        <translation>軸方向</translation>
    </message>
    <message>
        <source>Around</source>
        <comment>the tube</comment>
        <translation>周方向</translation>
    </message>
</context>
<context>
    <name>teleta::camera::EventTable</name>
    <message>
        <source>camera-events</source>
        <translation>カメライベント</translation>
    </message>
    <message>
        <source>What happened to the tube, newest first. The context menu copies and saves the list.</source>
        <translation>チューブに起きたこと (新しい順)。コンテキストメニューで一覧をコピー・保存できます。</translation>
    </message>
</context>
<context>
    <name>teleta::camera::GelEventModel</name>
    <message>
        <source>touched</source>
        <translation>接触</translation>
    </message>
    <message>
        <source>incipient slip</source>
        <translation>初期滑り</translation>
    </message>
    <message>
        <source>SLIP</source>
        <translation>滑り</translation>
    </message>
    <message>
        <source>released</source>
        <translation>離脱</translation>
    </message>
    <message>
        <source>rest taken</source>
        <translation>静止を取得</translation>
    </message>
    <message>
        <source>restarted</source>
        <translation>再開始</translation>
    </message>
    <message>
        <source>picture is dark</source>
        <translation>画像が暗い</translation>
    </message>
    <message>
        <source>light jumped</source>
        <translation>明るさの急変</translation>
    </message>
    <message>
        <source>gel torn?</source>
        <translation>ゲルの破れ？</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>時刻</translation>
    </message>
    <message>
        <source>Event</source>
        <translation>イベント</translation>
    </message>
    <message>
        <source>Contact</source>
        <translation>接触</translation>
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
        <translation>せん断</translation>
    </message>
    <message>
        <source>Slip index</source>
        <translation>滑り指数</translation>
    </message>
    <message>
        <source>BUMP</source>
        <translation>衝突</translation>
    </message>
    <message>
        <source>arm follows</source>
        <translation>アームが追従</translation>
    </message>
</context>
<context>
    <name>teleta::camera::GelEventTable</name>
    <message>
        <source>gel-events</source>
        <translation>gel-events</translation>
    </message>
    <message>
        <source>What happened to the gel, newest first. Shear is the mean displacement of the contact&apos;s markers less that of the others. The context menu copies and saves the list.</source>
        <translation>ゲルに起きたことを新しい順に示します。せん断は、接触のマーカーの平均変位から他のマーカーの平均変位を引いたものです。コンテキストメニューで一覧をコピー・保存できます。</translation>
    </message>
</context>
<context>
    <name>teleta::camera::GelPanel</name>
    <message>
        <source>Resume</source>
        <translation>続行</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>一時停止</translation>
    </message>
    <message>
        <source>%1 of %2 markers</source>
        <translation>マーカー %2 個のうち %1 個</translation>
    </message>
    <message>
        <source>%1 ms per frame, %2 frames/s</source>
        <translation>1フレーム %1 ms、%2フレーム/s</translation>
    </message>
    <message numerus="yes">
        <source>%n skipped</source>
        <translation>
            <numerusform>スキップ%n</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n unusable</source>
        <translation>
            <numerusform>使用不可%n</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Taking the gel at rest: nothing may touch it (%n more picture(s)).</source>
        <translation>
            <numerusform>ゲルの静止状態を取得中です。何もゲルに触れないでください（残り %n 枚）。</numerusform>
        </translation>
    </message>
    <message>
        <source>&amp;Displacement</source>
        <translation>変位(&amp;D)</translation>
    </message>
    <message>
        <source>Show how far each marker has moved from its place at rest</source>
        <translation>各マーカーが静止位置からどれだけ動いたかを示す</translation>
    </message>
    <message>
        <source>&amp;Enlarged</source>
        <translation>拡大(&amp;E)</translation>
    </message>
    <message>
        <source>Enlargement of the arrows</source>
        <translation>矢印の拡大率</translation>
    </message>
    <message>
        <source>How many times longer than the displacement the arrows are</source>
        <translation>矢印が変位の何倍の長さか</translation>
    </message>
    <message>
        <source>Take the next pictures as the gel at rest: nothing may touch it</source>
        <translation>次の画像をゲルの静止状態とする。何もゲルに触れないこと</translation>
    </message>
    <message>
        <source>Freeze the picture; markers are still followed (Space)</source>
        <translation>画像を止める。マーカーの追跡は続く（スペース）</translation>
    </message>
    <message>
        <source>Ne&amp;w rest</source>
        <translation>静止を取り直す(&amp;W)</translation>
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
        <translation>続行(&amp;G)</translation>
    </message>
    <message>
        <source>&amp;Pause the picture</source>
        <translation>画像を一時停止(&amp;P)</translation>
    </message>
    <message>
        <source>Take the gel at &amp;rest anew</source>
        <translation>ゲルの静止を取り直す(&amp;R)</translation>
    </message>
    <message>
        <source>Picture of the gel</source>
        <translation>ゲルの画像</translation>
    </message>
    <message>
        <source>&lt;p&gt;What the camera sees of the gel. Arrows show, enlarged, how far each marker has moved from its place at rest; a cross is a marker that is lost. Outlines are contacts, each in the colour of its number.&lt;/p&gt;&lt;p&gt;The slip index is the share of the contact&apos;s markers that do not move with it: green while it sticks, amber when a part of it slips, red when all of it does.&lt;/p&gt;</source>
        <translation>&lt;p&gt;カメラが見るゲルの画像です。矢印は、各マーカーが静止位置からどれだけ動いたかを拡大して示します。×印は見失ったマーカーです。輪郭は接触で、それぞれ番号の色で描かれます。&lt;/p&gt;&lt;p&gt;滑り指数は、接触のマーカーのうち接触と一緒に動かないものの割合です。固着している間は緑、一部が滑ると琥珀色、全体が滑ると赤になります。&lt;/p&gt;</translation>
    </message>
</context>
<context>
    <name>teleta::camera::PairModel</name>
    <message>
        <source>kept</source>
        <translation>採用</translation>
    </message>
    <message>
        <source>wrong</source>
        <translation>誤り</translation>
    </message>
    <message>
        <source>excluded</source>
        <translation>除外</translation>
    </message>
    <message>
        <source>Pair</source>
        <translation>ペア</translation>
    </message>
    <message>
        <source>State</source>
        <translation>状態</translation>
    </message>
    <message>
        <source>Pixel</source>
        <translation>画素</translation>
    </message>
    <message>
        <source>Point</source>
        <translation>点</translation>
    </message>
    <message>
        <source>Image</source>
        <translation>画像</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>表面</translation>
    </message>
</context>
<context>
    <name>teleta::camera::ReactionRow</name>
    <message>
        <source>The arm has retreated from contact %1.</source>
        <translation>アームは接触 %1 から退避しました。</translation>
    </message>
    <message>
        <source>The arm is at rest.</source>
        <translation>アームは停止しています。</translation>
    </message>
    <message>
        <source>The arm is retreating from contact %1.</source>
        <translation>アームは接触 %1 から退避しています。</translation>
    </message>
    <message>
        <source>The arm follows contact %1.</source>
        <translation>アームは接触 %1 に追従しています。</translation>
    </message>
    <message>
        <source>The arm is held.</source>
        <translation>アームは保持されています。</translation>
    </message>
    <message>
        <source>The arm is held. Tick the box to let it react again.</source>
        <translation>アームは保持されています。再び反応させるにはチェックを入れてください。</translation>
    </message>
    <message>
        <source>The arm may r&amp;eact</source>
        <translation>アームの反応を許可(&amp;E)</translation>
    </message>
    <message>
        <source>Off: the arm does not react to touch. STOP unticks this; tick it again to let the arm react.</source>
        <translation>オフ: 何が触れてもアームは停止したままです。STOPを押すと、再び許可するまでオフになります。</translation>
    </message>
</context>
<context>
    <name>teleta::camera::ResidualView</name>
    <message>
        <source>Residuals on the image</source>
        <translation>画像上の残差</translation>
    </message>
    <message>
        <source>Residuals on the unrolled cylinder</source>
        <translation>展開した円筒上の残差</translation>
    </message>
    <message>
        <source>&lt;p&gt;Each pair at its point on the cylinder, cut open at the back, with an enlarged arrow to where its pixel is located. The colour is the error along the axis.&lt;/p&gt;</source>
        <translation>&lt;p&gt;背面で切り開いた円筒上の点の位置に各ペアを示し、画素の推定位置へ拡大した矢印を描きます。色は軸方向の誤差です。&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Pair %1</source>
        <translation>ペア %1</translation>
    </message>
    <message>
        <source>kept</source>
        <translation>採用</translation>
    </message>
    <message>
        <source>left out as wrong</source>
        <translation>誤りとして除外</translation>
    </message>
    <message>
        <source>excluded by you</source>
        <translation>手動で除外</translation>
    </message>
    <message>
        <source>off by %1 in the image</source>
        <translation>画像上のずれ %1</translation>
    </message>
    <message>
        <source>off by %1 on the cylinder</source>
        <translation>円筒上のずれ %1</translation>
    </message>
    <message>
        <source>residuals-image</source>
        <translation>画像残差</translation>
    </message>
    <message>
        <source>residuals-cylinder</source>
        <translation>円筒残差</translation>
    </message>
    <message>
        <source>&amp;Exclude pair %1</source>
        <translation>ペア %1 を除外(&amp;E)</translation>
    </message>
    <message>
        <source>&amp;Use pair %1 again</source>
        <translation>ペア %1 を再び使用(&amp;U)</translation>
    </message>
    <message>
        <source>&lt;p&gt;Each pair at its pixel, with an enlarged arrow to where the camera projects its point. Random arrows are noise; a pattern shows something that the camera model misses.&lt;/p&gt;&lt;p&gt;Pixels outside the dashed circle have no ray.&lt;/p&gt;</source>
        <translation>&lt;p&gt;各ペアを画素の位置に示し、カメラが点を投影する位置へ拡大した矢印を描きます。規則性のない矢印はノイズ、流れのある矢印はカメラで表せていないものです。&lt;/p&gt;&lt;p&gt;破線の円の外の画素には光線がありません。&lt;/p&gt;</translation>
    </message>
</context>
<context>
    <name>teleta::camera::SceneTile</name>
    <message>
        <source>Waiting for the first picture</source>
        <translation>最初の画像を待っています</translation>
    </message>
    <message>
        <source>No picture for %1</source>
        <translation>%1の間、画像がありません</translation>
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
        <translation>現場</translation>
    </message>
    <message>
        <source>Picture of %1</source>
        <comment>a camera</comment>
        <translation>%1の画像</translation>
    </message>
    <message>
        <source>&lt;p&gt;What a camera sees now. Above it stand the size of its pictures, how many come in a second, and the age of the one that is shown: the time since it was read.&lt;/p&gt;&lt;p&gt;A picture that is too old for the camera&apos;s rate is dimmed, and says for how long none has come.&lt;/p&gt;</source>
        <translation>&lt;p&gt;カメラが今見ているものです。上には、画像の大きさ、1秒あたりの枚数、表示中の画像の経過時間（読み取ってからの時間）が表示されます。&lt;/p&gt;&lt;p&gt;カメラのレートに対して古すぎる画像は暗くなり、どれだけの間届いていないかを示します。&lt;/p&gt;</translation>
    </message>
</context>
<context>
    <name>teleta::camera::StageBar</name>
    <message>
        <source>prepare</source>
        <translation>準備</translation>
    </message>
    <message>
        <source>displacement</source>
        <translation>変位</translation>
    </message>
    <message>
        <source>segment</source>
        <translation>領域分割</translation>
    </message>
    <message>
        <source>locate</source>
        <translation>位置推定</translation>
    </message>
    <message numerus="yes">
        <source>%n unusable</source>
        <translation>
            <numerusform>使用不可%n</numerusform>
        </translation>
    </message>
    <message>
        <source>%1: %2 ms</source>
        <comment>stage of a computation and its time</comment>
        <translation>%1: %2 ms</translation>
    </message>
    <message>
        <source>%1 ms per frame, %2 frames/s</source>
        <translation>1フレーム %1 ms、%2フレーム/s</translation>
    </message>
    <message numerus="yes">
        <source>%n skipped</source>
        <translation>
            <numerusform>スキップ%n</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>teleta::charts::JointChartView</name>
    <message>
        <source>Joint torques and angles of the arm</source>
        <translation>アームの関節トルクと関節角度</translation>
    </message>
    <message>
        <source>No arm. Open a scene or a device with an arm.</source>
        <translation>アームがありません。アームを含むシーンまたはデバイスを開いてください。</translation>
    </message>
    <message>
        <source>Angles</source>
        <translation>角度</translation>
    </message>
    <message>
        <source>Show the joint angles too</source>
        <translation>関節角度も表示します</translation>
    </message>
    <message>
        <source>at %1 s   arm time %2 s</source>
        <translation>%1 s   アーム時刻 %2 s</translation>
    </message>
    <message>
        <source>joints</source>
        <translation>関節</translation>
    </message>
    <message>
        <source>&lt;p&gt;Torque of each joint over time. The coloured band is the torque window in which a touch is evaluated. Grey stretches are touches with their numbers, from the first torque above the noise to the estimate.&lt;/p&gt;&lt;p&gt;Drag or Shift+wheel scrolls, Ctrl+wheel changes the span, Space pauses, End goes back to live. Double-click an axis to type its range.&lt;/p&gt;</source>
        <translation>&lt;p&gt;各関節のトルクの時間変化です。色付きの帯はトルク窓で、その両端の間でタッチを評価します。灰色の区間は番号付きのタッチで、ノイズを超えた最初のトルクから推定までを示します。&lt;/p&gt;&lt;p&gt;ドラッグまたはShift+ホイールでスクロール、Ctrl+ホイールで表示範囲を変更、Spaceで一時停止、Endでライブに戻ります。軸をダブルクリックすると両端の値を入力できます。&lt;/p&gt;</translation>
    </message>
</context>
<context>
    <name>teleta::charts::JointPlot</name>
    <message>
        <source>shoulder roll</source>
        <translation>肩ロール</translation>
    </message>
    <message>
        <source>shoulder pitch</source>
        <translation>肩ピッチ</translation>
    </message>
    <message>
        <source>shoulder yaw</source>
        <translation>肩ヨー</translation>
    </message>
    <message>
        <source>elbow pitch</source>
        <translation>肘ピッチ</translation>
    </message>
    <message>
        <source>Joint torque</source>
        <translation>関節トルク</translation>
    </message>
    <message>
        <source>Joint angle</source>
        <translation>関節角度</translation>
    </message>
    <message>
        <source>joint %1</source>
        <translation>関節 %1</translation>
    </message>
</context>
<context>
    <name>teleta::charts::StripChartView</name>
    <message>
        <source>Strip charts of the tactile features</source>
        <translation>触覚特徴量のストリップチャート</translation>
    </message>
    <message>
        <source>Strips</source>
        <translation>ストリップ</translation>
    </message>
    <message>
        <source>Choose which strips are shown</source>
        <translation>表示するストリップを選びます</translation>
    </message>
    <message>
        <source>Choose strips</source>
        <translation>ストリップを選択</translation>
    </message>
    <message>
        <source>Mark</source>
        <translation>マーク</translation>
    </message>
    <message>
        <source>Mark this moment (M)</source>
        <translation>この瞬間にマークを付けます (M)</translation>
    </message>
    <message>
        <source>at %1 s   stream time %2 s</source>
        <translation>%1 s   ストリーム時刻 %2 s</translation>
    </message>
    <message>
        <source>charts</source>
        <translation>チャート</translation>
    </message>
    <message>
        <source>&amp;Strips</source>
        <translation>ストリップ(&amp;S)</translation>
    </message>
    <message>
        <source>&lt;p&gt;Force, centres, moment deviation and orientation of the contact over time. The numbers beside the strips are the newest values, or those at the cursor.&lt;/p&gt;&lt;p&gt;A gap in a line means that nothing is known there: there was no contact, samples were lost, or the recording jumped (dotted line).&lt;/p&gt;&lt;p&gt;Drag or Shift+wheel scrolls, Ctrl+wheel changes the span, Space pauses, End goes back to live. Double-click an axis to type its range.&lt;/p&gt;</source>
        <translation>&lt;p&gt;接触の力、中心、モーメント偏差、向きの時間変化です。各ストリップの横の数値は、最新の値またはカーソル位置の値です。&lt;/p&gt;&lt;p&gt;線が途切れて再び続く部分は、その間の値が不明であることを示します: 接触がなくなった、サンプルが失われた、または記録が飛んだ (点線) 場合です。&lt;/p&gt;&lt;p&gt;ドラッグまたはShift+ホイールでスクロール、Ctrl+ホイールで表示範囲を変更、Spaceで一時停止、Endでライブに戻ります。軸をダブルクリックすると両端の値を入力できます。&lt;/p&gt;</translation>
    </message>
</context>
<context>
    <name>teleta::charts::TimeChartView</name>
    <message>
        <source>S&amp;pan</source>
        <translation>表示範囲(&amp;P)</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>Show %1 s (Ctrl+wheel for other spans)</source>
        <translation>%1 sを表示します (ほかの範囲はCtrl+ホイール)</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>一時停止</translation>
    </message>
    <message>
        <source>at %1 s   no sample</source>
        <translation>%1 s   サンプルなし</translation>
    </message>
    <message>
        <source>last %1 s</source>
        <translation>直近 %1 s</translation>
    </message>
    <message>
        <source>PAUSED, %1 s behind   %2</source>
        <translation>一時停止中、%1 s遅れ   %2</translation>
    </message>
    <message>
        <source>Lower and upper end, for example -5 5. Empty: automatic.</source>
        <translation>下端と上端。例: -5 5。空欄: 自動。</translation>
    </message>
    <message>
        <source>auto</source>
        <translation>自動</translation>
    </message>
    <message>
        <source>&amp;Type range of %1…</source>
        <translation>%1の範囲を入力(&amp;T)…</translation>
    </message>
    <message>
        <source>&amp;Automatic range</source>
        <translation>自動範囲(&amp;A)</translation>
    </message>
    <message>
        <source>Go live</source>
        <translation>ライブへ</translation>
    </message>
    <message>
        <source>Freeze the chart; samples are still collected (Space)</source>
        <translation>画面を止めます。サンプルの保存は続きます (Space)</translation>
    </message>
    <message>
        <source>Range of the axis of %1</source>
        <translation>%1の軸の両端</translation>
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
        <translation>完了。%1</translation>
    </message>
</context>
<context>
    <name>teleta::chrome::DeviceStrip</name>
    <message>
        <source>Devices</source>
        <translation>デバイス</translation>
    </message>
    <message>
        <source>%1 for %2</source>
        <comment>state of a device and its age</comment>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Hz</source>
        <translation>Hz</translation>
    </message>
    <message>
        <source>%1 lost</source>
        <comment>frames</comment>
        <translation>損失 %1</translation>
    </message>
    <message>
        <source>to screen %1 ms</source>
        <translation>画面まで %1 ms</translation>
    </message>
    <message>
        <source>No device</source>
        <translation>デバイスなし</translation>
    </message>
    <message>
        <source>State: %1</source>
        <translation>状態: %1</translation>
    </message>
    <message>
        <source>Rate: %1 Hz</source>
        <translation>レート: %1 Hz</translation>
    </message>
    <message>
        <source>Frames lost: %1</source>
        <translation>フレーム損失: %1</translation>
    </message>
    <message>
        <source>Frames displayed: %1</source>
        <translation>表示フレーム数: %1</translation>
    </message>
    <message>
        <source>Age of the newest frame: %1</source>
        <translation>最新フレームの経過時間: %1</translation>
    </message>
    <message>
        <source>touch to skin %1 ms</source>
        <translation>タッチから皮膚まで %1 ms</translation>
    </message>
    <message>
        <source>From the completed touch to the first frame of its pattern: %1 ms</source>
        <translation>タッチ完了からパターンの最初のフレームまで: %1 ms</translation>
    </message>
    <message>
        <source>From sensor read to screen: %1 ms</source>
        <translation>読み取りから画面まで: %1 ms</translation>
    </message>
    <message>
        <source>rec</source>
        <comment>recorded, short</comment>
        <translation>記録</translation>
    </message>
    <message>
        <source>rec sim</source>
        <comment>a recorded simulation, short</comment>
        <translation>記録模擬</translation>
    </message>
    <message>
        <source>sim</source>
        <comment>simulated, short</comment>
        <translation>模擬</translation>
    </message>
    <message>
        <source>Frames lost: not counted by the sensor</source>
        <translation>フレーム損失: センサーは数えません</translation>
    </message>
    <message>
        <source>playing</source>
        <comment>a recording</comment>
        <translation>再生中</translation>
    </message>
</context>
<context>
    <name>teleta::chrome::FirstSteps</name>
    <message>
        <source>First steps</source>
        <translation>最初のステップ</translation>
    </message>
    <message>
        <source>Hide the first steps; the handbook has them</source>
        <translation>最初のステップを非表示にします。ハンドブックにもあります</translation>
    </message>
    <message>
        <source>Hide the first steps</source>
        <translation>最初のステップを非表示</translation>
    </message>
    <message>
        <source>Touch something</source>
        <translation>何かに触れます</translation>
    </message>
    <message>
        <source>A simulated arm touches five materials: contact, force, stiffness</source>
        <translation>シミュレーションのアームが5種類の材料に触れます: 接触、力、剛性</translation>
    </message>
    <message>
        <source>Say it with a pattern</source>
        <translation>パターンで伝えます</translation>
    </message>
    <message>
        <source>Open a built-in pattern and play it with Space</source>
        <translation>組み込みのパターンを開き、スペースキーで再生します</translation>
    </message>
    <message>
        <source>Watch a study</source>
        <translation>実験を見ます</translation>
    </message>
    <message>
        <source>Simulated participants answer, and the confusion matrix fills</source>
        <translation>シミュレーションの参加者が回答し、混同行列が埋まります</translation>
    </message>
</context>
<context>
    <name>teleta::chrome::MessageBar</name>
    <message>
        <source>Messages</source>
        <translation>メッセージ</translation>
    </message>
    <message numerus="yes">
        <source>%n older message(s)</source>
        <translation>
            <numerusform>以前のメッセージ%n件</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>since %1, %n times</source>
        <translation>
            <numerusform>%1から、%n回</numerusform>
        </translation>
    </message>
    <message>
        <source>Hide details</source>
        <translation>詳細を隠す</translation>
    </message>
    <message>
        <source>Details</source>
        <translation>詳細</translation>
    </message>
    <message>
        <source>Dismiss</source>
        <translation>閉じる</translation>
    </message>
</context>
<context>
    <name>teleta::chrome::MessageLog</name>
    <message>
        <source>Error</source>
        <translation>エラー</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>警告</translation>
    </message>
    <message>
        <source>Information</source>
        <translation>情報</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>時刻</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>種類</translation>
    </message>
    <message>
        <source>Message</source>
        <translation>メッセージ</translation>
    </message>
</context>
<context>
    <name>teleta::chrome::PageRail</name>
    <message>
        <source>Pages</source>
        <translation>ページ</translation>
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
        <translation>フレーム%1/%2</translation>
    </message>
    <message>
        <source>Playback</source>
        <translation>再生</translation>
    </message>
    <message>
        <source>To the start</source>
        <translation>先頭へ</translation>
    </message>
    <message>
        <source>Home</source>
        <translation>Home</translation>
    </message>
    <message>
        <source>One frame back</source>
        <translation>1フレーム戻る</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>←</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>再生</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>一時停止</translation>
    </message>
    <message>
        <source>Space</source>
        <translation>Space</translation>
    </message>
    <message>
        <source>One frame forward</source>
        <translation>1フレーム進む</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>→</translation>
    </message>
    <message>
        <source>Time in the recording</source>
        <translation>記録内の時刻</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>Repeat</source>
        <translation>末尾で先頭に戻る</translation>
    </message>
</context>
<context>
    <name>teleta::chrome::RecentList</name>
    <message>
        <source>Recent:</source>
        <translation>最近使ったファイル:</translation>
    </message>
    <message>
        <source>Reopen %1</source>
        <comment>what was open</comment>
        <translation>%1を再び開く</translation>
    </message>
    <message>
        <source>What was open when the console was closed</source>
        <translation>コンソールを閉じたときに開いていたもの</translation>
    </message>
</context>
<context>
    <name>teleta::chrome::RecordingIndicator</name>
    <message numerus="yes">
        <source>Recording %1 · %2 · %n lost</source>
        <comment>time, size of the file, frames</comment>
        <translation>
            <numerusform>記録中 %1 · %2 · 損失 %n</numerusform>
        </translation>
    </message>
    <message>
        <source>Record</source>
        <translation>記録する</translation>
    </message>
    <message>
        <source>End the recording (Ctrl+R)</source>
        <translation>記録を終了します (Ctrl+R)</translation>
    </message>
    <message>
        <source>Record all sources and the bracelet into a file (Ctrl+R)</source>
        <translation>すべてのソースとブレスレットをファイルに記録します (Ctrl+R)</translation>
    </message>
    <message>
        <source>End the recording</source>
        <translation>記録を終了</translation>
    </message>
    <message>
        <source>Mark</source>
        <translation>マーク</translation>
    </message>
    <message>
        <source>Mark this moment (M)</source>
        <translation>この瞬間にマークを付けます (M)</translation>
    </message>
    <message>
        <source>Mark this moment</source>
        <translation>この瞬間にマークを付ける</translation>
    </message>
    <message>
        <source>Starting…</source>
        <translation>開始中…</translation>
    </message>
    <message>
        <source>Finishing…</source>
        <translation>完了処理中…</translation>
    </message>
    <message>
        <source>Recording failed</source>
        <translation>記録に失敗</translation>
    </message>
    <message>
        <source>Recording failed. Record</source>
        <translation>記録に失敗しました。記録</translation>
    </message>
</context>
<context>
    <name>teleta::chrome::SourceChooser</name>
    <message>
        <source>%1 (opening…)</source>
        <comment>a source</comment>
        <translation>%1 (オープン中…)</translation>
    </message>
    <message>
        <source>%1 — %2</source>
        <comment>a source and whether its data are simulated or recorded</comment>
        <translation>%1 — %2</translation>
    </message>
    <message>
        <source>No source</source>
        <translation>ソースなし</translation>
    </message>
    <message>
        <source>Open &amp;recording…</source>
        <translation>記録を開く(&amp;R)…</translation>
    </message>
    <message>
        <source>Open &amp;scene file…</source>
        <translation>シーンファイルを開く(&amp;S)…</translation>
    </message>
    <message>
        <source>Open source &amp;list…</source>
        <translation>ソースリストを開く(&amp;L)…</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>ソース</translation>
    </message>
    <message>
        <source>Open a simulated scene or a recording</source>
        <translation>シミュレーションシーンまたは記録を開きます</translation>
    </message>
    <message>
        <source>Close source</source>
        <translation>ソースを閉じる</translation>
    </message>
    <message>
        <source>Close this source</source>
        <translation>このソースを閉じます</translation>
    </message>
    <message>
        <source>Open &amp;camera…</source>
        <translation>カメラを開く(&amp;C)…</translation>
    </message>
    <message>
        <source>A camera in the soft tube, or a video of one, with its calibration</source>
        <translation>ソフトチューブ内のカメラまたはその動画と、そのキャリブレーション</translation>
    </message>
    <message>
        <source>The source that the views show</source>
        <translation>ビューに表示されるソース</translation>
    </message>
    <message>
        <source>Open &amp;arm…</source>
        <translation>アームを開く(&amp;A)…</translation>
    </message>
    <message>
        <source>An arm over ROS 2, described in a file</source>
        <translation>ファイルで記述されたROS 2のアーム</translation>
    </message>
    <message>
        <source>A recording of this program or as MCAP, or recorded frames of an array: CSV, NumPy, HDF5, MATLAB, Tekscan</source>
        <translation>このプログラムの記録かMCAP、またはアレイのフレームの記録：CSV、NumPy、HDF5、MATLAB、Tekscan</translation>
    </message>
    <message>
        <source>Ope&amp;n</source>
        <translation>開く(&amp;N)</translation>
    </message>
</context>
<context>
    <name>teleta::chrome::StopBanner</name>
    <message>
        <source>The STOP button was pressed.</source>
        <translation>STOPボタンが押されました。</translation>
    </message>
    <message>
        <source>Ctrl+. was pressed.</source>
        <translation>Ctrl+.が押されました。</translation>
    </message>
    <message>
        <source>Esc was pressed twice.</source>
        <translation>Escが2回押されました。</translation>
    </message>
    <message>
        <source>The program engaged STOP.</source>
        <translation>プログラムがSTOPを作動させました。</translation>
    </message>
    <message>
        <source>STOPPED since %1. %2</source>
        <comment>time, cause</comment>
        <translation>停止中 (%1から)。%2</translation>
    </message>
    <message>
        <source>Motors are off and arms are held. To continue, hold the STOPPED button for one second.</source>
        <translation>モーターはオフで、アームは保持されています。続けるには「停止中」のボタンを1秒間押し続けてください。</translation>
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
        <translation>停止中</translation>
    </message>
    <message>
        <source>hold to release</source>
        <translation>長押しで解除</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation>停止中</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>Everything that moves is stopped. Hold for a second to release.</source>
        <translation>動くものはすべて停止しています。1秒間押し続けると解除します。</translation>
    </message>
    <message>
        <source>Stops everything that moves at once.</source>
        <translation>動いているものをすべて直ちに停止します。</translation>
    </message>
    <message>
        <source>Stop everything that moves at once (Esc Esc, or Ctrl+.)</source>
        <translation>動いているものをすべて直ちに停止します (Esc EscまたはCtrl+.)</translation>
    </message>
</context>
<context>
    <name>teleta::chrome::TimeSlider</name>
    <message>
        <source>Mark</source>
        <translation>マーク</translation>
    </message>
</context>
<context>
    <name>teleta::console::BraceletMenu</name>
    <message>
        <source>&amp;Simulated</source>
        <translation>シミュレーション(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;USB</source>
        <translation>USB(&amp;U)</translation>
    </message>
    <message>
        <source>&amp;None</source>
        <translation>なし(&amp;N)</translation>
    </message>
    <message>
        <source>Devices (*.toml)</source>
        <translation>デバイス (*.toml)</translation>
    </message>
    <message>
        <source>File: %1</source>
        <comment>a device file</comment>
        <translation>ファイル: %1</translation>
    </message>
    <message>
        <source>&amp;Device file…</source>
        <translation>デバイスファイル(&amp;D)…</translation>
    </message>
    <message>
        <source>Open the file of a bracelet</source>
        <translation>ブレスレットのファイルを開く</translation>
    </message>
    <message>
        <source>A file that describes the registers of a Modbus motor driver, the ids of a USB bracelet, or the outputs of a sound card</source>
        <translation>Modbusモータードライバーのレジスター、USBブレスレットのID、またはサウンドカードの出力を記述したファイル</translation>
    </message>
    <message>
        <source>Measure its &amp;latency…</source>
        <translation>遅延を測定(&amp;L)…</translation>
    </message>
    <message>
        <source>From a frame to the movement of a tactor, for a bracelet on a sound card</source>
        <translation>フレームからタクタの動きまで（サウンドカードのブレスレット）</translation>
    </message>
</context>
<context>
    <name>teleta::console::CalibratePage</name>
    <message>
        <source>What can be calibrated</source>
        <translation>キャリブレーションの対象</translation>
    </message>
    <message>
        <source>Bracelet motors</source>
        <translation>ブレスレットモーター</translation>
    </message>
    <message>
        <source>Cylinder camera</source>
        <translation>円筒カメラ</translation>
    </message>
    <message>
        <source>Taxel gains</source>
        <translation>タクセルのゲイン</translation>
    </message>
    <message>
        <source>Unsaved calibration</source>
        <translation>未保存のキャリブレーション</translation>
    </message>
    <message>
        <source>%1: the calibration is not saved.</source>
        <comment>a part of the page</comment>
        <translation>%1: キャリブレーションが保存されていません。</translation>
    </message>
    <message>
        <source>Discarded values must be measured again.</source>
        <translation>破棄したものは、測定し直す必要があります。</translation>
    </message>
    <message>
        <source>The taxel gains of %1 are not saved.</source>
        <comment>a source</comment>
        <translation>%1のタクセルのゲインは保存されていません。</translation>
    </message>
    <message>
        <source>They are lost when the source is closed. Save them on the page Calibrate.</source>
        <translation>ソースを閉じると失われます。「キャリブレーション」ページで保存できます。</translation>
    </message>
    <message>
        <source>Loads in newtons</source>
        <translation>ニュートンの荷重</translation>
    </message>
</context>
<context>
    <name>teleta::console::CameraCalibrator</name>
    <message>
        <source>Saved %1</source>
        <translation>%1 を保存しました</translation>
    </message>
    <message>
        <source>Cylinder camera</source>
        <translation>円筒カメラ</translation>
    </message>
    <message>
        <source>Pairs of pixels and points: CSV with u_px,v_px,x_m,y_m,z_m</source>
        <translation>画素と点のペア: u_px,v_px,x_m,y_m,z_m のCSV</translation>
    </message>
    <message>
        <source>&amp;Probe the simulated tube</source>
        <translation>シミュレーションチューブをプロービング(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Method:</source>
        <translation>方法(&amp;M):</translation>
    </message>
    <message>
        <source>Method of calibration</source>
        <translation>キャリブレーションの方法</translation>
    </message>
    <message>
        <source>Linear (DLT)</source>
        <translation>線形 (DLT)</translation>
    </message>
    <message>
        <source>As in the paper</source>
        <translation>論文の方法</translation>
    </message>
    <message>
        <source>Least squares</source>
        <translation>最小二乗</translation>
    </message>
    <message>
        <source>Robust</source>
        <translation>ロバスト</translation>
    </message>
    <message>
        <source>&amp;Exclude wrong pairs</source>
        <translation>誤ったペアを除外(&amp;E)</translation>
    </message>
    <message>
        <source>Methods side by side</source>
        <translation>方法の比較</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>方法</translation>
    </message>
    <message>
        <source>Kept</source>
        <translation>採用</translation>
    </message>
    <message>
        <source>Image, mean</source>
        <translation>画像、平均</translation>
    </message>
    <message>
        <source>Surface, mean</source>
        <translation>表面、平均</translation>
    </message>
    <message>
        <source>Uncertainty</source>
        <translation>不確かさ</translation>
    </message>
    <message>
        <source>Remark</source>
        <translation>備考</translation>
    </message>
    <message>
        <source>Pairs</source>
        <translation>ペア</translation>
    </message>
    <message>
        <source>&amp;Exclude, or use again</source>
        <translation>除外または再び使用(&amp;E)</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>削除(&amp;R)</translation>
    </message>
    <message>
        <source>Save the camera</source>
        <translation>カメラを保存</translation>
    </message>
    <message>
        <source>Save the pairs</source>
        <translation>ペアを保存</translation>
    </message>
    <message>
        <source>Load pairs</source>
        <translation>ペアを読み込む</translation>
    </message>
    <message>
        <source>Cameras (*.json)</source>
        <translation>カメラ (*.json)</translation>
    </message>
    <message>
        <source>probing</source>
        <translation>プロービング</translation>
    </message>
    <message>
        <source>loading</source>
        <translation>読み込み</translation>
    </message>
    <message>
        <source>added pair</source>
        <translation>ペアの追加</translation>
    </message>
    <message numerus="yes">
        <source>removal of %n pair(s)</source>
        <translation>
            <numerusform>%n組のペアの削除</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>use of %n pair(s)</source>
        <translation>
            <numerusform>%n組のペアの使用</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>exclusion of %n pair(s)</source>
        <translation>
            <numerusform>%n組のペアの除外</numerusform>
        </translation>
    </message>
    <message>
        <source>image and cylinder</source>
        <translation>画像と円筒</translation>
    </message>
    <message>
        <source>No calibration: %1.</source>
        <translation>キャリブレーションできません: %1。</translation>
    </message>
    <message numerus="yes">
        <source>%1 of %n pair(s) kept; </source>
        <translation>
            <numerusform>%n組中%1組のペアを採用。 </numerusform>
        </translation>
    </message>
    <message>
        <source>SIMULATED</source>
        <translation>シミュレーション</translation>
    </message>
    <message>
        <source>has a pattern</source>
        <translation>規則性あり</translation>
    </message>
    <message>
        <source>Load pairs of pixels and probed points, drop their file here, type them in below, or probe a tube.</source>
        <translation>画素とプロービングした点のペアを読み込むか、ファイルをここにドロップするか、下に入力するか、チューブをプロービングしてください。</translation>
    </message>
    <message>
        <source>It is valid within %1 of its axis. </source>
        <translation>軸から %1 以内で有効です。 </translation>
    </message>
    <message>
        <source>probed hole</source>
        <translation>穴のプロービング</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>元に戻す(&amp;U)</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>やり直す(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Load pairs…</source>
        <translation>ペアを読み込む(&amp;L)…</translation>
    </message>
    <message>
        <source>Save pai&amp;rs…</source>
        <translation>ペアを保存(&amp;R)…</translation>
    </message>
    <message>
        <source>&amp;Save camera…</source>
        <translation>カメラを保存(&amp;S)…</translation>
    </message>
    <message>
        <source>Probe with a &amp;camera…</source>
        <translation>カメラでプロービング(&amp;C)…</translation>
    </message>
    <message>
        <source>Calibrating…</source>
        <translation>キャリブレーション中…</translation>
    </message>
    <message>
        <source>Save all pairs, including excluded ones, to load them again later</source>
        <translation>除外されたものを含むすべてのペアを、読み込まれる形式で保存します</translation>
    </message>
    <message>
        <source>Save the camera found by the chosen method, for teleta locate and the camera view</source>
        <translation>teleta locateとカメラビュー用の、選択した方法によるカメラ</translation>
    </message>
    <message>
        <source>Collect pairs: a simulated person presses a stick on the marked places of a simulated tube and mistakes one in ten for its neighbour</source>
        <translation>ペアを収集します: シミュレーション上の人がチューブの印の位置を棒で押し、10回に1回は隣の印と取り違えます</translation>
    </message>
    <message>
        <source>Collect pairs: press a stick through the holes of a shell while a camera watches, live or in a video</source>
        <translation>ペアを収集します。シェルの穴に棒を押し込む様子を、カメラまたはその動画で見ます</translation>
    </message>
    <message>
        <source>Exclude the pairs marked as wrong, for every method</source>
        <translation>誤りと判定されたペアを、すべての方法で除外します</translation>
    </message>
    <message>
        <source>&lt;p&gt;Finds the camera inside the tactile cylinder from pairs of a pixel and the surface point that was probed there.&lt;/p&gt;&lt;p&gt;Load a CSV file, drop it here, or type pairs in. Wrong pairs are detected and left out; you can exclude more, remove them (Delete in the table) and undo every step.&lt;/p&gt;</source>
        <translation>&lt;p&gt;画素と、そこでプロービングされた表面の点とのペアから、触覚円筒内のカメラを求めます。&lt;/p&gt;&lt;p&gt;CSVファイルを読み込むかここにドロップする、またはペアを入力してください。誤ったペアは検出されて除外されます。さらに除外したり削除したり (表でDelete) することもでき、すべての操作は元に戻せます。&lt;/p&gt;</translation>
    </message>
    <message>
        <source>The camera was not saved. Wait until it is calibrated.</source>
        <translation>カメラは保存されませんでした: キャリブレーション中です。</translation>
    </message>
    <message>
        <source>Waiting for the first touch.</source>
        <translation>最初のタッチを待っています。</translation>
    </message>
    <message>
        <source>their points are located to within %1 on average; the camera&apos;s uncertainty is %2. </source>
        <translation>点の位置推定の誤差は平均%1、カメラの不確かさは%2以内です。 </translation>
    </message>
    <message>
        <source>This method ignores lens distortion: use it only for comparison.</source>
        <translation>この方法はレンズを考慮しません: 比較にのみ使用してください。</translation>
    </message>
    <message>
        <source>The residuals show no pattern, as they should.</source>
        <translation>残差に規則性はありません。良好です。</translation>
    </message>
    <message>
        <source>Pairs (*.csv)</source>
        <translation>ペア (*.csv)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>すべてのファイル (*)</translation>
    </message>
    <message>
        <source>points off the cylinder</source>
        <translation>点が円筒上にない</translation>
    </message>
    <message>
        <source>points beyond the ends</source>
        <translation>点が端の外</translation>
    </message>
    <message>
        <source>u and v swapped?</source>
        <translation>uとvが逆？</translation>
    </message>
    <message>
        <source>pixels outside the image</source>
        <translation>画素が画像の外</translation>
    </message>
    <message>
        <source>Caution: %1.</source>
        <translation>注意: %1。</translation>
    </message>
    <message>
        <source>It is valid in the whole image. </source>
        <translation>画像全体で有効です。 </translation>
    </message>
</context>
<context>
    <name>teleta::console::CameraDialog</name>
    <message>
        <source>Open camera</source>
        <translation>カメラを開く</translation>
    </message>
    <message>
        <source>…</source>
        <translation>…</translation>
    </message>
    <message>
        <source>Ca&amp;libration:</source>
        <translation>キャリブレーション(&amp;L):</translation>
    </message>
    <message>
        <source>Choose a camera file</source>
        <translation>カメラファイルを選択</translation>
    </message>
    <message>
        <source>Camera file</source>
        <translation>カメラファイル</translation>
    </message>
    <message>
        <source>Camera files (*.json)</source>
        <translation>カメラファイル (*.json)</translation>
    </message>
    <message>
        <source>The camera file that the page Calibrate or teleta calibrate has written; without one the camera is only looked at</source>
        <translation>キャリブレーションページまたはteleta calibrateが書き込んだカメラファイル。なければカメラの画像を見るだけになります</translation>
    </message>
    <message>
        <source>none: only show the picture</source>
        <translation>なし: 見るだけ</translation>
    </message>
    <message>
        <source>&amp;Start again at the end</source>
        <translation>末尾で先頭に戻る(&amp;S)</translation>
    </message>
    <message>
        <source>Camera or &amp;video:</source>
        <translation>カメラまたは動画(&amp;V):</translation>
    </message>
</context>
<context>
    <name>teleta::console::CameraSourceField</name>
    <message>
        <source>The number of a connected camera (0 is /dev/video0), or a video file</source>
        <translation>接続されたカメラの番号 (0は/dev/video0) または動画ファイル</translation>
    </message>
    <message>
        <source>…</source>
        <translation>…</translation>
    </message>
    <message>
        <source>Choose a video</source>
        <translation>動画を選択</translation>
    </message>
    <message>
        <source>Video of a camera</source>
        <translation>カメラの動画</translation>
    </message>
    <message>
        <source>Videos and pictures (*)</source>
        <translation>動画と画像 (*)</translation>
    </message>
    <message>
        <source>Camera or video</source>
        <translation>カメラまたは動画</translation>
    </message>
</context>
<context>
    <name>teleta::console::CostMeasuring</name>
    <message>
        <source>The saved costs cannot be read.</source>
        <translation>以前に測定したコストを読み取れません。</translation>
    </message>
    <message>
        <source>The costs cannot be saved.</source>
        <translation>測定したコストを保存できません。</translation>
    </message>
    <message>
        <source>The jobs could not be measured.</source>
        <translation>処理を測定できませんでした。</translation>
    </message>
</context>
<context>
    <name>teleta::console::CostPage</name>
    <message>
        <source>Error: %1.</source>
        <translation>誤差: %1。</translation>
    </message>
    <message>
        <source>refused: too noisy</source>
        <translation>棄却: 変動過大</translation>
    </message>
    <message>
        <source>Preparing…</source>
        <translation>準備中…</translation>
    </message>
    <message>
        <source>%1: %2 on average, 99 of 100 frames within %3 (1640 x 1232 pixels).</source>
        <translation>%1: 平均 %2、100フレーム中99フレームが %3 以内 (1640 x 1232画素)。</translation>
    </message>
    <message>
        <source>Measuring %1: %2</source>
        <translation>%1 を測定中: %2</translation>
    </message>
    <message>
        <source>Preparing %1…</source>
        <translation>%1 を準備中…</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>キャンセル(&amp;C)</translation>
    </message>
    <message>
        <source>Not measured on this machine</source>
        <translation>このマシンでは未測定</translation>
    </message>
    <message>
        <source>Parameter</source>
        <translation>パラメーター</translation>
    </message>
    <message>
        <source>Mean error</source>
        <translation>平均誤差</translation>
    </message>
    <message>
        <source>95 %</source>
        <translation>95 %</translation>
    </message>
    <message>
        <source>Worst</source>
        <translation>最悪</translation>
    </message>
    <message>
        <source>Median time</source>
        <translation>時間の中央値</translation>
    </message>
    <message>
        <source>99 % time</source>
        <translation>99 %時間</translation>
    </message>
    <message>
        <source>Camera in use</source>
        <translation>使用中のカメラ</translation>
    </message>
    <message>
        <source>Time of a frame, now</source>
        <translation>現在の1フレームの時間</translation>
    </message>
    <message>
        <source> ms a frame</source>
        <translation> ms/フレーム</translation>
    </message>
    <message>
        <source>No camera is shown on the page Operate.</source>
        <translation>操作ページにカメラが表示されていません。</translation>
    </message>
    <message>
        <source>Open a demo with a camera</source>
        <translation>カメラのデモを開く</translation>
    </message>
    <message>
        <source>Measuring</source>
        <translation>測定中</translation>
    </message>
    <message>
        <source>Close other programs and sources first: their load makes the times unreliable.</source>
        <translation>先にほかのプログラムとソースを閉じてください: それらの計算により時間が不確かになります。</translation>
    </message>
    <message>
        <source>Stopping…</source>
        <translation>終了しています…</translation>
    </message>
    <message>
        <source>Takes a few minutes; you can go on using the console</source>
        <translation>数分かかります。その間もコンソールを使えます</translation>
    </message>
    <message>
        <source>Sweeps</source>
        <translation>スイープ</translation>
    </message>
    <message>
        <source>Fastest: %1, %2 times the limit (%3: %4).</source>
        <translation>最速: %1、限界 (%3: %4) の %2 倍です。</translation>
    </message>
    <message>
        <source>%1 (frontier)</source>
        <comment>name of a setting</comment>
        <translation>%1 (フロンティア)</translation>
    </message>
    <message>
        <source>Measure &quot;%1&quot; first.</source>
        <translation>先に「%1」を測定してください。</translation>
    </message>
    <message>
        <source>No setting is fast enough: only one frame in 100 may take longer.</source>
        <translation>十分に速い設定がありません。これより長くかかってよいのは100フレーム中1フレームだけです。</translation>
    </message>
    <message>
        <source>The setting %1 cannot be used.</source>
        <translation>設定%1は使用できません。</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>設定</translation>
    </message>
    <message>
        <source>Jobs</source>
        <translation>処理</translation>
    </message>
    <message>
        <source>Jobs that can be done fast or accurately</source>
        <translation>速く、または正確に行える処理</translation>
    </message>
    <message>
        <source>Measure this job</source>
        <translation>この処理を測定</translation>
    </message>
    <message>
        <source>Setting</source>
        <translation>設定</translation>
    </message>
    <message>
        <source>Settings with their errors and times</source>
        <translation>設定とその誤差および時間</translation>
    </message>
    <message>
        <source>&amp;Setting in use</source>
        <translation>使用中の設定(&amp;S)</translation>
    </message>
    <message>
        <source>Setting that finds the contacts</source>
        <translation>接触を見つける設定</translation>
    </message>
    <message>
        <source>&amp;Use the best setting within it</source>
        <translation>この予算内の最良の設定を使用(&amp;U)</translation>
    </message>
    <message>
        <source>Choose a setting in the table or the chart to read what it costs and gives.</source>
        <translation>表またはチャートで設定を選ぶと、そのコストと効果が表示されます。</translation>
    </message>
    <message>
        <source>On the command line: %1</source>
        <translation>コマンドラインでの名前: %1</translation>
    </message>
    <message>
        <source>not measured</source>
        <translation>未測定</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <comment>times</comment>
        <translation>%1～%2</translation>
    </message>
    <message>
        <source>&amp;Measure again</source>
        <translation>もう一度測定(&amp;M)</translation>
    </message>
    <message>
        <source>Measure all &amp;jobs</source>
        <translation>すべての処理を測定(&amp;J)</translation>
    </message>
    <message>
        <source>&amp;Time budget of a frame</source>
        <translation>1フレームの時間予算(&amp;T)</translation>
    </message>
</context>
<context>
    <name>teleta::console::DeletionDialog</name>
    <message>
        <source>Delete a participant</source>
        <translation>参加者を削除</translation>
    </message>
    <message>
        <source>For example: consent withdrawn</source>
        <translation>例: 同意の撤回</translation>
    </message>
    <message>
        <source>It is recorded. Write nothing that tells who it was</source>
        <translation>記録されます。誰であったかがわかることは書かないでください</translation>
    </message>
    <message>
        <source>&amp;Reason</source>
        <translation>理由(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Name of the participant, once more</source>
        <translation>参加者の名前をもう一度(&amp;N)</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>削除</translation>
    </message>
    <message>
        <source>All sessions, answers, notes, recordings and exported files of %1 are deleted. This cannot be undone. The study records that somebody was deleted, and when. Results that were computed before, and copies elsewhere, stay as they are.</source>
        <comment>a participant</comment>
        <translation>%1のすべてのセッション、回答、メモ、記録、エクスポートされたファイルが削除されます。元に戻せません。実験には、誰かが削除されたことと日時だけが残ります。以前に計算された結果や、ほかの場所のコピーはそのまま残ります。</translation>
    </message>
</context>
<context>
    <name>teleta::console::DockTabs</name>
    <message>
        <source>&amp;Maximise</source>
        <translation>最大化(&amp;M)</translation>
    </message>
    <message>
        <source>&amp;Float</source>
        <translation>切り離す(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>閉じる(&amp;C)</translation>
    </message>
</context>
<context>
    <name>teleta::console::ExclusionEditor</name>
    <message>
        <source>What does not count</source>
        <translation>集計対象から外すもの</translation>
    </message>
    <message>
        <source>No rules: every completed trial counts.</source>
        <translation>規則なし: 完了したすべての試行を集計対象とします。</translation>
    </message>
    <message>
        <source>Add a r&amp;ule</source>
        <translation>規則を追加(&amp;U)</translation>
    </message>
    <message>
        <source>Rules apply from top to bottom, each to what is left. Nothing is deleted: results are shown with the rules, and without them</source>
        <translation>規則は上から順に、それまでに残ったものへ適用されます。何も削除しません。結果は規則を適用した場合と、適用しない場合を示します</translation>
    </message>
    <message>
        <source>a trial answered earlier than, s</source>
        <translation>回答が次の時間より早い試行、s</translation>
    </message>
    <message>
        <source>a trial answered later than, s</source>
        <translation>回答が次の時間より遅い試行、s</translation>
    </message>
    <message>
        <source>a trial whose time is unusual, MADs from the median</source>
        <translation>時間が通常から外れた試行、中央値からの隔たり (MAD単位)</translation>
    </message>
    <message>
        <source>a trial with more device faults than</source>
        <translation>デバイス障害が次の数より多い試行</translation>
    </message>
    <message>
        <source>a trial with more missed frames than</source>
        <translation>欠けたフレームが次の数より多い試行</translation>
    </message>
    <message>
        <source>a session with a share without answer above</source>
        <translation>無回答の割合が次の値を超えるセッション</translation>
    </message>
    <message>
        <source>a session with a share of yes in catch trials above</source>
        <translation>キャッチ試行での「はい」の割合が次の値を超えるセッション</translation>
    </message>
    <message>
        <source>a session with a share of one answer above</source>
        <translation>1つの答えの割合が次の値を超えるセッション</translation>
    </message>
    <message>
        <source>a participant with a share right in practice below</source>
        <translation>練習の正答の割合が次の値を下回る参加者</translation>
    </message>
    <message>
        <source>a participant not above chance, p above</source>
        <translation>偶然の水準を上回らない参加者、pが次の値を超える場合</translation>
    </message>
    <message>
        <source>Name of the rule</source>
        <translation>規則の名前</translation>
    </message>
    <message>
        <source>The name of the rule in the column “excluded” and in results</source>
        <translation>列「excluded」と結果に表示される規則の名前</translation>
    </message>
    <message>
        <source>What the rule leaves out</source>
        <translation>規則が除外するもの</translation>
    </message>
    <message>
        <source>Number of the rule</source>
        <translation>規則の値</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>削除</translation>
    </message>
    <message>
        <source>Remove this rule</source>
        <translation>この規則を削除</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; is not a number</source>
        <comment>a rule</comment>
        <translation>%1: 「%2」は数値ではありません</translation>
    </message>
    <message>
        <source>a number with a point, such as 0.2</source>
        <translation>0.2のように小数点を使った数値</translation>
    </message>
</context>
<context>
    <name>teleta::console::ExportDialog</name>
    <message>
        <source>Export pattern</source>
        <translation>パターンのエクスポート</translation>
    </message>
    <message>
        <source>commanded intensities</source>
        <translation>指令強度</translation>
    </message>
    <message>
        <source>&amp;Format:</source>
        <translation>形式(&amp;F):</translation>
    </message>
    <message>
        <source>&amp;Rate:</source>
        <translation>レート(&amp;R):</translation>
    </message>
    <message>
        <source>&amp;Values:</source>
        <translation>値(&amp;V):</translation>
    </message>
    <message>
        <source>Choose file…</source>
        <translation>ファイルを選択…</translation>
    </message>
    <message>
        <source>predicted intensities</source>
        <translation>モーターの予測動作</translation>
    </message>
    <message>
        <source>vibrations</source>
        <translation>振動</translation>
    </message>
    <message>
        <source>bare intensities</source>
        <translation>強度のみ</translation>
    </message>
    <message>
        <source>&amp;Signal:</source>
        <translation>信号(&amp;S):</translation>
    </message>
    <message>
        <source>Frequenc&amp;y:</source>
        <translation>周波数(&amp;Y):</translation>
    </message>
</context>
<context>
    <name>teleta::console::FeedbackPanel</name>
    <message>
        <source>shape</source>
        <translation>形状</translation>
    </message>
    <message>
        <source>stiffness</source>
        <translation>剛性</translation>
    </message>
    <message>
        <source>dynamic</source>
        <translation>動的</translation>
    </message>
    <message>
        <source>static</source>
        <translation>静的</translation>
    </message>
    <message>
        <source>%1: no pattern</source>
        <comment>what was recognised</comment>
        <translation>%1: パターンなし</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>what was recognised: id of a pattern</comment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Touch %1: %2. There is no pattern for it in the table.</source>
        <translation>タッチ%1: %2。対応するパターンが表にありません。</translation>
    </message>
    <message>
        <source>Touch %1: %2. %3 was felt %4 later.</source>
        <translation>タッチ%1: %2。%3 が%4後に提示されました。</translation>
    </message>
    <message>
        <source>Touch %1: %2. %3 was sent.</source>
        <translation>タッチ%1: %2。%3 を送信しました。</translation>
    </message>
    <message>
        <source>Stiffness and shape</source>
        <translation>剛性と形状</translation>
    </message>
    <message>
        <source>Stiffness</source>
        <translation>剛性</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>形状</translation>
    </message>
    <message>
        <source>Nothing</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>What of a touch is played on the bracelet</source>
        <translation>タッチのうちブレスレットで再生する内容</translation>
    </message>
    <message>
        <source>Nothing was recognised yet.</source>
        <translation>まだ何も認識されていません。</translation>
    </message>
    <message>
        <source>%1: %2 is missing</source>
        <comment>what was recognised: id of a pattern</comment>
        <translation>%1: %2 が見つかりません</translation>
    </message>
    <message>
        <source>Touch %1: %2. Its pattern %3 is missing: nothing was played. Choose another one, or put it back among your patterns.</source>
        <translation>タッチ%1: %2。パターン %3 が見つからないため、何も再生されませんでした。別のパターンを選ぶか、自作パターンに戻してください。</translation>
    </message>
    <message>
        <source>From touch to skin: %1 half of the time, %2 at 99 %.</source>
        <translation>タッチから皮膚まで: 半数は%1以内、99 %は%2以内。</translation>
    </message>
    <message>
        <source>Of the newest touches, with the link between the two sites on the way</source>
        <translation>最近のタッチについて。途中にある2拠点間の回線を含みます</translation>
    </message>
    <message>
        <source>Nothing is played (last: %1)</source>
        <comment>what was recognised and its pattern</comment>
        <translation>再生していません(直前: %1)</translation>
    </message>
    <message>
        <source>Unknown stiffness</source>
        <translation>硬さ不明</translation>
    </message>
    <message>
        <source>%1: %2, not played</source>
        <comment>what was recognised: id of a pattern</comment>
        <translation>%1: %2 (再生されず)</translation>
    </message>
    <message>
        <source>Touch %1: %2. %3 was not played: no bracelet is connected, or a study or a calibration is using it.</source>
        <translation>タッチ%1: %2。%3は再生されませんでした。ブレスレットがないか、実験またはキャリブレーションで使用中です。</translation>
    </message>
    <message>
        <source>What to &amp;play:</source>
        <translation>タッチのうち再生するもの(&amp;P)：</translation>
    </message>
    <message>
        <source>Save the times of touches</source>
        <translation>タッチの時刻を保存</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>表 (*.csv)</translation>
    </message>
    <message>
        <source>Read: %1</source>
        <translation>読み取り: %1</translation>
    </message>
    <message>
        <source>by the clock of the site, known to ± %1</source>
        <translation>サイトの時計による（不確かさ± %1）</translation>
    </message>
    <message>
        <source>by the clock of this computer</source>
        <translation>このコンピューターの時計による</translation>
    </message>
    <message>
        <source>Evaluated: %1 later</source>
        <translation>評価: %1後</translation>
    </message>
    <message>
        <source>First frame to the bracelet: %1 later</source>
        <translation>ブレスレットへの最初のフレーム: %1後</translation>
    </message>
    <message>
        <source>First frame that is felt: %1 later</source>
        <translation>感じられる最初のフレーム: %1後</translation>
    </message>
    <message>
        <source>Each is known to ± %1, since two clocks are compared.</source>
        <translation>2つの時計を比べるため、それぞれの不確かさは± %1です。</translation>
    </message>
    <message>
        <source>Save times…</source>
        <translation>時刻を保存…</translation>
    </message>
    <message>
        <source>Arrived at the console: %1 later</source>
        <translation>コンソールに到着: %1後</translation>
    </message>
    <message>
        <source>Save when each touch was read, arrived from a site, was evaluated, sent and felt, as a table (CSV)</source>
        <translation>各接触が読み取られ、サイトから届き、評価され、送られ、感じられた時刻を表 (CSV) に保存します</translation>
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
        <translation>フレームを開く</translation>
    </message>
    <message>
        <source>the only one, or the one named frames</source>
        <translation>唯一のもの、またはframesという名前のもの</translation>
    </message>
    <message>
        <source>as the file says</source>
        <translation>ファイルのとおり</translation>
    </message>
    <message>
        <source>the first</source>
        <translation>最初</translation>
    </message>
    <message>
        <source>the last</source>
        <translation>最後</translation>
    </message>
    <message>
        <source>Rows</source>
        <translation>行</translation>
    </message>
    <message>
        <source>Columns</source>
        <translation>列</translation>
    </message>
    <message>
        <source>Columns of a table that are taxels, counted from 1</source>
        <translation>表のうちタクセルである列（1から数えます）</translation>
    </message>
    <message>
        <source>name or number of the column</source>
        <translation>列の名前または番号</translation>
    </message>
    <message>
        <source>as the name of the column ends</source>
        <translation>列名の末尾のとおり</translation>
    </message>
    <message>
        <source>rows ×</source>
        <comment>N rows x M columns</comment>
        <translation>行 ×</translation>
    </message>
    <message>
        <source>columns</source>
        <translation>列</translation>
    </message>
    <message>
        <source>File:</source>
        <translation>ファイル：</translation>
    </message>
    <message>
        <source>&amp;Name of the frames:</source>
        <translation>フレームの名前(&amp;N)：</translation>
    </message>
    <message>
        <source>&amp;Dimension that counts the frames:</source>
        <translation>フレームを数える次元(&amp;D)：</translation>
    </message>
    <message>
        <source>&amp;Shape:</source>
        <translation>形状(&amp;S)：</translation>
    </message>
    <message>
        <source>&amp;Pitch:</source>
        <translation>ピッチ(&amp;P)：</translation>
    </message>
    <message>
        <source>Column of the &amp;times:</source>
        <translation>時刻の列(&amp;T)：</translation>
    </message>
    <message>
        <source>&amp;Unit of the times:</source>
        <translation>時刻の単位(&amp;U)：</translation>
    </message>
    <message>
        <source>&amp;Rate, without times:</source>
        <translation>時刻がないときのレート(&amp;R)：</translation>
    </message>
    <message>
        <source>Columns are numbers and ranges, such as 2..85 or 2..10,12.</source>
        <translation>列は番号と範囲で示します（例：2..85、2..10,12）。</translation>
    </message>
    <message>
        <source>Load from which a taxel is in contact, in the unit of the values</source>
        <translation>タクセルが接触とみなされる荷重 (値の単位)</translation>
    </message>
    <message>
        <source>In contact &amp;from:</source>
        <translation>接触とみなす荷重(&amp;F):</translation>
    </message>
    <message>
        <source>0.2 N, or one count</source>
        <translation>0.2 Nまたは1カウント</translation>
    </message>
    <message>
        <source>only for taxels off a grid, or with three components</source>
        <translation>格子上にない、または3成分のタクセルの場合のみ</translation>
    </message>
    <message>
        <source>The device file of the array, or a file with its table [layout]: it says where the taxels are. Rows, columns and pitch are not needed then.</source>
        <translation>アレイの機器ファイル、またはその[layout]の表があるファイル。タクセルの位置を示します。行、列、ピッチは不要になります。</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>選択…</translation>
    </message>
    <message>
        <source>File of the &amp;array:</source>
        <translation>アレイのファイル(&amp;A)：</translation>
    </message>
    <message>
        <source>File of the array</source>
        <translation>アレイのファイル</translation>
    </message>
    <message>
        <source>Arrays (*.toml)</source>
        <translation>アレイ (*.toml)</translation>
    </message>
    <message>
        <source>Co&amp;lumns of the taxels:</source>
        <translation>タクセルの列(&amp;L)：</translation>
    </message>
</context>
<context>
    <name>teleta::console::FramePreview</name>
    <message>
        <source>Frame</source>
        <translation>フレーム</translation>
    </message>
    <message>
        <source>Choose a frame</source>
        <translation>フレームを選ぶ</translation>
    </message>
    <message>
        <source>Reading…</source>
        <translation>読み込み中…</translation>
    </message>
    <message>
        <source>No frame to show.</source>
        <translation>表示できるフレームがありません。</translation>
    </message>
    <message numerus="yes">
        <source>%n frame(s) of %1 × %2 taxels, %3 to %4</source>
        <extracomment>Numbers of rows and columns, lowest and highest value</extracomment>
        <translation>
            <numerusform>%nフレーム、%1 × %2タクセル、%3～%4</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>The first %n frame(s) of %1 × %2 taxels, %3 to %4</source>
        <translation>
            <numerusform>最初の%nフレーム、%1 × %2タクセル、%3～%4</numerusform>
        </translation>
    </message>
    <message>
        <source>Frame %1 of %2, %3 s</source>
        <translation>フレーム%1/%2、%3 s</translation>
    </message>
</context>
<context>
    <name>teleta::console::GainCalibrator</name>
    <message>
        <source>Open recorded presses</source>
        <translation>記録した押圧を開く</translation>
    </message>
    <message>
        <source>Frames (*.csv)</source>
        <translation>フレーム (*.csv)</translation>
    </message>
    <message>
        <source>Load gains</source>
        <translation>ゲインを読み込む</translation>
    </message>
    <message>
        <source>Gains (*.csv)</source>
        <translation>ゲイン (*.csv)</translation>
    </message>
    <message>
        <source>Save the gains</source>
        <translation>ゲインを保存</translation>
    </message>
    <message>
        <source>Choose another folder or file name.</source>
        <translation>別のフォルダーまたはファイル名を選んでください。</translation>
    </message>
    <message>
        <source>%1 could not be saved.</source>
        <comment>a file</comment>
        <translation>%1 を保存できませんでした。</translation>
    </message>
    <message>
        <source>The loads of the array will be shown here.</source>
        <translation>アレイの荷重がここに表示されます。</translation>
    </message>
</context>
<context>
    <name>teleta::console::HandbookWindow</name>
    <message>
        <source>Handbook of the TeleTA Console</source>
        <translation>TeleTA Console ハンドブック</translation>
    </message>
    <message>
        <source>← Back</source>
        <translation>← 戻る</translation>
    </message>
    <message>
        <source>Forward →</source>
        <translation>進む →</translation>
    </message>
    <message>
        <source>Find</source>
        <translation>検索</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>閉じる</translation>
    </message>
    <message>
        <source>Find in the handbook (Ctrl+F)</source>
        <translation>ハンドブック内を検索 (Ctrl+F)</translation>
    </message>
    <message>
        <source>Find in the handbook</source>
        <translation>ハンドブック内を検索</translation>
    </message>
    <message>
        <source>Pages of the handbook</source>
        <translation>ハンドブックのページ一覧</translation>
    </message>
    <message>
        <source>Page of the handbook</source>
        <translation>ハンドブックのページ</translation>
    </message>
    <message>
        <source>Guide</source>
        <translation>ガイド</translation>
    </message>
    <message>
        <source>Reference</source>
        <translation>リファレンス</translation>
    </message>
</context>
<context>
    <name>teleta::console::HelpMenu</name>
    <message>
        <source>&amp;Handbook</source>
        <translation>ハンドブック(&amp;H)</translation>
    </message>
    <message>
        <source>&amp;First steps</source>
        <translation>はじめに(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Shortcuts</source>
        <translation>ショートカット(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;About TeleTA Console</source>
        <translation>TeleTA Consoleについて(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Log</source>
        <translation>ログ(&amp;L)</translation>
    </message>
</context>
<context>
    <name>teleta::console::ImportDialog</name>
    <message>
        <source>Open pattern</source>
        <translation>パターンを開く</translation>
    </message>
    <message>
        <source>A pattern cannot represent everything that %1 holds. Opening it changes or leaves out:</source>
        <comment>a file</comment>
        <translation>パターンは%1の内容をすべて表現できるわけではありません。開くと、次のものが変更または除外されます:</translation>
    </message>
    <message>
        <source>left</source>
        <translation>左</translation>
    </message>
    <message>
        <source>right</source>
        <translation>右</translation>
    </message>
    <message>
        <source>&amp;Arm:</source>
        <translation>腕(&amp;A):</translation>
    </message>
    <message>
        <source>&amp;Motors:</source>
        <translation>モーター(&amp;M):</translation>
    </message>
</context>
<context>
    <name>teleta::console::JointViews</name>
    <message>
        <source>The arm is drawn without its meshes: %1</source>
        <translation>アームはメッシュなしで描かれます: %1</translation>
    </message>
    <message>
        <source>The arm reports joints that its description does not have: %1.</source>
        <translation>アームの記述にない関節が報告されています: %1。</translation>
    </message>
</context>
<context>
    <name>teleta::console::LatencyDialog</name>
    <message>
        <source>Latency of the bracelet</source>
        <translation>ブレスレットの遅延</translation>
    </message>
    <message>
        <source>Ten clicks are played on tactor 1 and heard at an input of the sound card: fix an accelerometer to the tactor, or lead a cable from its output to the input. The median is saved in the device file, and studies then count from when a stimulus is felt.</source>
        <translation>タクタ1でクリックを10回再生し、サウンドカードの入力で聞き取ります。加速度計をタクタに固定するか、その出力から入力へケーブルをつないでください。中央値はデバイスファイルに保存され、実験は刺激が感じられた時点から数えます。</translation>
    </message>
    <message>
        <source>&amp;Input:</source>
        <translation>入力(&amp;I):</translation>
    </message>
    <message>
        <source>&amp;Look again</source>
        <translation>再検索(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Save in the device file</source>
        <translation>デバイスファイルに保存(&amp;S)</translation>
    </message>
    <message>
        <source>The sound server has no input.</source>
        <translation>サウンドサーバに入力がありません。</translation>
    </message>
    <message>
        <source>S&amp;top measuring</source>
        <translation>測定を停止(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Measure</source>
        <translation>測定(&amp;M)</translation>
    </message>
    <message>
        <source>Playing clicks. Do not touch the tactor or the input.</source>
        <translation>クリックを再生中です。タクタと入力に触れないでください。</translation>
    </message>
    <message>
        <source>Median %1 ms, spread %2 ms from the shortest to the longest.</source>
        <translation>中央値 %1 ms、最短から最長までの幅 %2 ms。</translation>
    </message>
    <message>
        <source>It is saved in %1.</source>
        <comment>a file</comment>
        <translation>%1 に保存されました。</translation>
    </message>
    <message>
        <source>The device file says %1 ms, as measured before.</source>
        <translation>デバイスファイルでは %1 ms です（以前の測定）。</translation>
    </message>
    <message>
        <source>Not measured yet. According to the sound server it is at most %1 ms.</source>
        <translation>まだ測定されていません。サウンドサーバの申告は最大 %1 ms です。</translation>
    </message>
</context>
<context>
    <name>teleta::console::LayoutsMenu</name>
    <message>
        <source>Ma&amp;ximise the view</source>
        <translation>ビューを最大化(&amp;X)</translation>
    </message>
    <message>
        <source>Show the view with the focus alone, or all again; a double click on a title does the same</source>
        <translation>フォーカスのあるビューだけを表示、または再びすべて表示します。タイトルのダブルクリックでも同じです</translation>
    </message>
    <message>
        <source>La&amp;youts</source>
        <translation>レイアウト(&amp;Y)</translation>
    </message>
    <message>
        <source>&amp;Save layout as…</source>
        <translation>レイアウトを保存(&amp;S)…</translation>
    </message>
    <message>
        <source>D&amp;elete</source>
        <translation>削除(&amp;E)</translation>
    </message>
    <message>
        <source>Save layout</source>
        <translation>レイアウトを保存</translation>
    </message>
    <message>
        <source>Name (a layout of the same name is replaced):</source>
        <translation>名前 (既にある場合は置き換えられます):</translation>
    </message>
</context>
<context>
    <name>teleta::console::LevelTaskForm</name>
    <message>
        <source>Task with levels</source>
        <translation>レベルのある課題</translation>
    </message>
    <message>
        <source>yes or no: was it there?</source>
        <translation>はい・いいえ: それはありましたか?</translation>
    </message>
    <message>
        <source>intervals: in which one was it?</source>
        <translation>区間: どの区間にありましたか?</translation>
    </message>
    <message>
        <source>same or different</source>
        <translation>同じか異なるか</translation>
    </message>
    <message>
        <source>compare: which one had more?</source>
        <translation>比較: どちらのほうが多かったですか?</translation>
    </message>
    <message>
        <source>the usual question of the design</source>
        <translation>この課題形式の通常の質問</translation>
    </message>
    <message>
        <source>for example rest, or weak 0.3, strong 0.7 with their references</source>
        <translation>例: rest。基準付きの場合は weak 0.3, strong 0.7</translation>
    </message>
    <message>
        <source>name and tactors, one track per line, for example t1 1; tactors of the reference after /</source>
        <translation>名前とタクタを1行に1トラック。例: t1 1。基準のタクタは / の後</translation>
    </message>
    <message>
        <source>full path of a pattern file</source>
        <translation>パターンファイルの絶対パス</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>選択…</translation>
    </message>
    <message>
        <source>intensity</source>
        <translation>強度</translation>
    </message>
    <message>
        <source>time from burst to burst</source>
        <translation>バーストからバーストまでの時間</translation>
    </message>
    <message>
        <source>length of a burst</source>
        <translation>バーストの長さ</translation>
    </message>
    <message>
        <source>length</source>
        <translation>長さ</translation>
    </message>
    <message>
        <source>balance of a phantom</source>
        <translation>ファントムのバランス</translation>
    </message>
    <message>
        <source>linear</source>
        <translation>線形</translation>
    </message>
    <message>
        <source>logarithmic (log10)</source>
        <translation>対数 (log10)</translation>
    </message>
    <message>
        <source>the highest</source>
        <translation>最高値</translation>
    </message>
    <message>
        <source>constant stimuli</source>
        <translation>恒常法</translation>
    </message>
    <message>
        <source>staircase</source>
        <translation>階段法</translation>
    </message>
    <message>
        <source>Bayesian (QUEST+)</source>
        <translation>ベイズ法 (QUEST+)</translation>
    </message>
    <message>
        <source>levels with commas between them, for example 0.1, 0.2, 0.4</source>
        <translation>コンマで区切ったレベル。例: 0.1, 0.2, 0.4</translation>
    </message>
    <message>
        <source>Identifier</source>
        <translation>識別子</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名前</translation>
    </message>
    <message>
        <source>Design</source>
        <translation>課題形式</translation>
    </message>
    <message>
        <source>Question</source>
        <translation>質問</translation>
    </message>
    <message>
        <source>Conditions</source>
        <translation>条件</translation>
    </message>
    <message>
        <source>Intervals</source>
        <translation>区間数</translation>
    </message>
    <message>
        <source>Gap between intervals, s</source>
        <translation>区間の間隔、s</translation>
    </message>
    <message>
        <source>Share of catch trials</source>
        <translation>キャッチ試行の割合</translation>
    </message>
    <message>
        <source>Tracks</source>
        <translation>トラック</translation>
    </message>
    <message>
        <source>Stimulus</source>
        <translation>刺激</translation>
    </message>
    <message>
        <source>A level sets the</source>
        <translation>レベルが決めるもの</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>尺度</translation>
    </message>
    <message>
        <source>Lowest level</source>
        <translation>最低レベル</translation>
    </message>
    <message>
        <source>Highest level</source>
        <translation>最高レベル</translation>
    </message>
    <message>
        <source>Reference; 0 is nothing</source>
        <translation>基準 (0は刺激なし)</translation>
    </message>
    <message>
        <source>Level of the practice</source>
        <translation>練習のレベル</translation>
    </message>
    <message>
        <source>Levels are chosen by</source>
        <translation>レベルの選び方</translation>
    </message>
    <message>
        <source>Levels</source>
        <translation>レベル</translation>
    </message>
    <message>
        <source>Remove this task</source>
        <translation>この課題を削除</translation>
    </message>
    <message>
        <source>First level</source>
        <translation>最初のレベル</translation>
    </message>
    <message>
        <source>Right answers for a step down</source>
        <translation>1段下げるまでの正答数</translation>
    </message>
    <message>
        <source>Reversals with larger steps</source>
        <translation>大きなステップでの反転数</translation>
    </message>
    <message>
        <source>Reversals at most</source>
        <translation>反転数の上限</translation>
    </message>
    <message>
        <source>Trials at most</source>
        <translation>試行数の上限</translation>
    </message>
    <message>
        <source>Function</source>
        <translation>関数</translation>
    </message>
    <message>
        <source>Slopes or spreads</source>
        <translation>傾きまたは広がり</translation>
    </message>
    <message>
        <source>Lapse rates</source>
        <translation>ラプス率</translation>
    </message>
    <message>
        <source>Rates of yes without a stimulus</source>
        <translation>刺激なしでの「はい」の割合</translation>
    </message>
    <message>
        <source>Levels of the grid</source>
        <translation>グリッドのレベル数</translation>
    </message>
    <message>
        <source>Mean of the prior, in the scale</source>
        <translation>事前分布の平均 (尺度上)</translation>
    </message>
    <message>
        <source>all thresholds are equally likely</source>
        <translation>すべてのしきい値が同程度に起こりやすい</translation>
    </message>
    <message>
        <source>Its standard deviation</source>
        <translation>その標準偏差</translation>
    </message>
    <message>
        <source>Trials at least</source>
        <translation>試行数の下限</translation>
    </message>
    <message>
        <source>Ends with a standard deviation of</source>
        <translation>終了する標準偏差</translation>
    </message>
    <message>
        <source>only with its trials</source>
        <translation>試行数に達したときのみ</translation>
    </message>
    <message>
        <source>Pattern file of the stimulus</source>
        <translation>刺激のパターンファイル</translation>
    </message>
    <message>
        <source>Detection</source>
        <translation>検出</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; is not a number</source>
        <comment>a row of the form</comment>
        <translation>%1: 「%2」は数値ではありません</translation>
    </message>
    <message>
        <source>a number with a point, such as 0.5</source>
        <translation>0.5のように小数点を使った数値</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a number</source>
        <translation>「%1」は数値ではありません</translation>
    </message>
    <message>
        <source>numbers with a point, such as 0.1, 0.2</source>
        <translation>0.1, 0.2のように小数点を使った数値</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a whole number</source>
        <translation>「%1」は整数ではありません</translation>
    </message>
    <message>
        <source>a number such as 12</source>
        <translation>12のような数値</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no tactor</source>
        <translation>「%1」はタクタではありません</translation>
    </message>
    <message>
        <source>a name and numbers of tactors, for example t1 1</source>
        <translation>名前とタクタの番号。例: t1 1</translation>
    </message>
    <message>
        <source>a condition and its reference, such as weak 0.3</source>
        <translation>条件とその基準。例: weak 0.3</translation>
    </message>
    <message>
        <source>Step up, log10 units on a log scale</source>
        <translation>上げ幅、対数尺度ではlog10の単位</translation>
    </message>
    <message>
        <source>Step down, likewise</source>
        <translation>下げ幅、同様</translation>
    </message>
    <message>
        <source>These steps are larger by</source>
        <translation>大きなステップの倍率</translation>
    </message>
    <message>
        <source>First reversals left out</source>
        <translation>除外する最初の反転数</translation>
    </message>
    <message>
        <source>It stays at</source>
        <translation>収束先</translation>
    </message>
    <message>
        <source>Levels are shares of the intensity in the file, 0 to 1.</source>
        <translation>レベルはファイル内の強度に対する割合で、0から1までです。</translation>
    </message>
    <message>
        <source>Levels are balances, from 0 (the first tactor alone) to 1 (the second alone).</source>
        <translation>レベルはバランスで、0 (1つ目のタクタのみ) から1 (2つ目のみ) までです。</translation>
    </message>
    <message>
        <source>Levels are times in seconds.</source>
        <translation>レベルは時間 (秒) です。</translation>
    </message>
    <message>
        <source>%1 % right answers</source>
        <translation>正答 %1 %</translation>
    </message>
</context>
<context>
    <name>teleta::console::LiveProbing</name>
    <message>
        <source>The camera is open but sends no frames.</source>
        <translation>カメラは開いていますが、フレームが届きません。</translation>
    </message>
    <message>
        <source>The camera&apos;s image size has changed from %1 × %2 to %3 × %4 pixels. Start probing again.</source>
        <translation>カメラの画像が %1 × %2 画素から %3 × %4 画素に変わりました。プロービングをやり直してください。</translation>
    </message>
</context>
<context>
    <name>teleta::console::LiveProbingDialog</name>
    <message>
        <source>Probe with a camera</source>
        <translation>カメラでプロービング</translation>
    </message>
    <message>
        <source>Ri&amp;ngs:</source>
        <translation>リング数(&amp;N):</translation>
    </message>
    <message>
        <source>&amp;First ring at z =</source>
        <translation>最初のリングの z(&amp;F) =</translation>
    </message>
    <message>
        <source>&amp;Last ring at z =</source>
        <translation>最後のリングの z(&amp;L) =</translation>
    </message>
    <message>
        <source>An&amp;gle of the first hole:</source>
        <translation>最初の穴の角度(&amp;G):</translation>
    </message>
    <message>
        <source>&amp;Probe</source>
        <translation>プロービング(&amp;P)</translation>
    </message>
    <message>
        <source>Angle of the first hole of each ring, from the x axis towards y</source>
        <translation>各リングの最初の穴の角度。x 軸から y に向かって測ります</translation>
    </message>
    <message>
        <source>Holes per &amp;ring:</source>
        <translation>リングあたりの穴数(&amp;R):</translation>
    </message>
    <message>
        <source>Camera or &amp;video:</source>
        <translation>カメラまたは動画(&amp;V):</translation>
    </message>
</context>
<context>
    <name>teleta::console::LiveProbingPanel</name>
    <message>
        <source>The video is over.</source>
        <translation>動画が終わりました。</translation>
    </message>
    <message>
        <source>All holes are probed.</source>
        <translation>すべての穴をプロービングしました。</translation>
    </message>
    <message>
        <source>All holes are probed</source>
        <translation>すべての穴をプロービング済み</translation>
    </message>
    <message>
        <source>Hole %1 of %2: ring %3, %4&#xa0;mm, %5°</source>
        <translation>穴 %1 / %2: リング %3、%4&#xa0;mm、%5°</translation>
    </message>
    <message>
        <source>Press the stick into this hole.</source>
        <translation>この穴に棒を押し込んでください。</translation>
    </message>
    <message>
        <source>Hold still.</source>
        <translation>そのまま動かさないでください。</translation>
    </message>
    <message>
        <source>Taken. Lift the stick.</source>
        <translation>取得しました。棒を離してください。</translation>
    </message>
    <message>
        <source>How long the stick has been held still</source>
        <translation>棒を静止させた時間</translation>
    </message>
    <message>
        <source>What the camera sees</source>
        <translation>カメラに見えているもの</translation>
    </message>
    <message>
        <source>Sto&amp;p probing</source>
        <translation>プロービングを停止(&amp;P)</translation>
    </message>
    <message>
        <source>Lift the stick first.</source>
        <translation>先に棒を離してください。</translation>
    </message>
    <message>
        <source>Waiting for the camera: %1</source>
        <translation>カメラを待っています: %1</translation>
    </message>
    <message>
        <source>Waiting for the first frame. Nothing may touch the skin.</source>
        <translation>最初のフレームを待っています。スキンには何も触れないでください。</translation>
    </message>
    <message>
        <source>Waiting for a frame in which nothing touches the skin: %1</source>
        <translation>スキンに何も触れていないフレームを待っています: %1</translation>
    </message>
    <message>
        <source>The skin is touched in several places. Remove everything but the stick.</source>
        <translation>スキンの複数の場所に触れています。棒以外を離してください。</translation>
    </message>
    <message>
        <source>Back to the previous hole. Probing it again replaces its pixel</source>
        <translation>1 つ前の穴。もう一度プロービングした穴の画素は置き換わります</translation>
    </message>
    <message>
        <source>Skip this hole for now</source>
        <translation>この穴を今は飛ばします</translation>
    </message>
    <message>
        <source>Ne&amp;w reference</source>
        <translation>今は非接触(&amp;U)</translation>
    </message>
    <message>
        <source>Take the next frame as the reference: nothing may touch the skin</source>
        <translation>次のフレームには何も触れていないスキンが写ります</translation>
    </message>
    <message>
        <source>Keep the pairs collected so far</source>
        <translation>これまでに収集した分を残します</translation>
    </message>
    <message>
        <source>Bac&amp;k</source>
        <translation>戻る(&amp;K)</translation>
    </message>
    <message>
        <source>Sk&amp;ip</source>
        <translation>スキップ(&amp;I)</translation>
    </message>
</context>
<context>
    <name>teleta::console::LiveViewService</name>
    <message>
        <source>Li&amp;ve view for Foxglove</source>
        <translation>Foxglove用のライブビュー(&amp;V)</translation>
    </message>
    <message numerus="yes">
        <source>%n viewer(s)</source>
        <translation>
            <numerusform>ビューアー%n件</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n message(s) missed</source>
        <translation>
            <numerusform>メッセージ%n件の欠落</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>teleta::console::LoadCalibrator</name>
    <message>
        <source>the table has no load</source>
        <translation>表に荷重がありません</translation>
    </message>
    <message>
        <source>a column force_n, shear_x_n, shear_y_n or moment_nm</source>
        <translation>force_n、shear_x_n、shear_y_n、moment_nmのいずれかの列</translation>
    </message>
    <message>
        <source>Open presses with a known load</source>
        <translation>既知の荷重の押しを開く</translation>
    </message>
    <message>
        <source>Presses (*.csv)</source>
        <translation>押し (*.csv)</translation>
    </message>
    <message>
        <source>Load a calibration</source>
        <translation>キャリブレーションを読み込む</translation>
    </message>
    <message>
        <source>Calibrations (*.csv)</source>
        <translation>キャリブレーション (*.csv)</translation>
    </message>
    <message>
        <source>Save the calibration</source>
        <translation>キャリブレーションを保存する</translation>
    </message>
    <message>
        <source>%1 could not be saved.</source>
        <comment>a file</comment>
        <translation>%1を保存できませんでした。</translation>
    </message>
</context>
<context>
    <name>teleta::console::LogWindow</name>
    <message>
        <source>Save log</source>
        <translation>ログを保存</translation>
    </message>
    <message>
        <source>Text (*.txt)</source>
        <translation>テキスト (*.txt)</translation>
    </message>
    <message>
        <source>Log</source>
        <translation>ログ</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>コピー(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Save…</source>
        <translation>保存(&amp;S)…</translation>
    </message>
    <message>
        <source>C&amp;lose</source>
        <translation>閉じる(&amp;L)</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>%1 を保存しました</translation>
    </message>
    <message>
        <source>%1 could not be saved: %2</source>
        <translation>%1 を書き込めませんでした: %2</translation>
    </message>
    <message>
        <source>Messages since the program started</source>
        <translation>プログラム開始からのメッセージ</translation>
    </message>
</context>
<context>
    <name>teleta::console::MainWindow</name>
    <message>
        <source>Looking for the site of %1…</source>
        <translation>%1 のサイトを探しています…</translation>
    </message>
    <message>
        <source>TeleTA Console</source>
        <translation>TeleTA Console</translation>
    </message>
    <message>
        <source>Operate</source>
        <translation>操作</translation>
    </message>
    <message>
        <source>What the arm touches, live or played back</source>
        <translation>アームが触れているもの (ライブまたは再生)</translation>
    </message>
    <message>
        <source>Open recording</source>
        <translation>記録を開く</translation>
    </message>
    <message>
        <source>Open source list</source>
        <translation>ソースリストを開く</translation>
    </message>
    <message>
        <source>Source lists (*.toml)</source>
        <translation>ソースリスト (*.toml)</translation>
    </message>
    <message>
        <source>Open scene</source>
        <translation>シーンを開く</translation>
    </message>
    <message>
        <source>Scenes (*.toml)</source>
        <translation>シーン (*.toml)</translation>
    </message>
    <message>
        <source>%1 could not be opened.</source>
        <comment>a file</comment>
        <translation>%1 を開けませんでした。</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>ファイル(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Open</source>
        <translation>開く(&amp;O)</translation>
    </message>
    <message>
        <source>&amp;Close source</source>
        <translation>ソースを閉じる(&amp;C)</translation>
    </message>
    <message>
        <source>Close the source that is shown</source>
        <translation>表示中のソースを閉じます</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>終了(&amp;Q)</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>表示(&amp;V)</translation>
    </message>
    <message>
        <source>&amp;Reset layout</source>
        <translation>レイアウトをリセット(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>ライト(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation>ダーク(&amp;D)</translation>
    </message>
    <message>
        <source>&amp;Full screen</source>
        <translation>全画面表示(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>ヘルプ(&amp;H)</translation>
    </message>
    <message>
        <source>&amp;Arm</source>
        <translation>アーム(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Run its program</source>
        <translation>プログラムを実行(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Hold</source>
        <translation>保持(&amp;H)</translation>
    </message>
    <message>
        <source>&amp;Forget the explored contour</source>
        <translation>探索した輪郭を破棄(&amp;F)</translation>
    </message>
    <message>
        <source>What is touched from now on is another object</source>
        <translation>これ以降に触れるものを別の物体とみなします</translation>
    </message>
    <message>
        <source>&amp;Bracelet</source>
        <translation>ブレスレット(&amp;B)</translation>
    </message>
    <message>
        <source>Patterns</source>
        <translation>パターン</translation>
    </message>
    <message>
        <source>What the bracelet can say: edit, check and play patterns</source>
        <translation>ブレスレットで伝えられるもの: パターンの編集、検査、再生</translation>
    </message>
    <message>
        <source>Study</source>
        <translation>実験</translation>
    </message>
    <message>
        <source>User studies: from the first practice trial to confusion matrices and ANOVA</source>
        <translation>ユーザー実験: 最初の練習試行から混同行列と分散分析まで</translation>
    </message>
    <message>
        <source>Calibrate</source>
        <translation>キャリブレーション</translation>
    </message>
    <message>
        <source>Cost</source>
        <translation>コスト</translation>
    </message>
    <message>
        <source>The page Patterns opens the edits.</source>
        <translation>パターンページで編集内容を開きます。</translation>
    </message>
    <message>
        <source>my own</source>
        <translation>自作</translation>
    </message>
    <message>
        <source>dynamic</source>
        <translation>動的</translation>
    </message>
    <message>
        <source>static</source>
        <translation>静的</translation>
    </message>
    <message>
        <source>As the de&amp;sktop</source>
        <translation>デスクトップに合わせる(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Recording</source>
        <translation>記録(&amp;R)</translation>
    </message>
    <message>
        <source>What has to be measured: the motors of the bracelet, the camera in the tube, the taxels</source>
        <translation>測定が必要なもの: ブレスレットのモーター、チューブ内のカメラ、タクセル</translation>
    </message>
    <message>
        <source>Re&amp;start</source>
        <translation>再開始(&amp;S)</translation>
    </message>
    <message>
        <source>Foxglove can be connected to %1.</source>
        <translation>Foxgloveを %1 に接続できます。</translation>
    </message>
    <message>
        <source>Open connection &gt; Foxglove WebSocket shows all sources there.</source>
        <translation>Foxgloveの「Open connection」&gt;「Foxglove WebSocket」で、すべてのソースを表示できます。</translation>
    </message>
    <message>
        <source>The live view has ended.</source>
        <translation>ライブビューが終了しました。</translation>
    </message>
    <message>
        <source>Choose another port with --foxglove.</source>
        <translation>--foxgloveで別のポートを選んでください。</translation>
    </message>
    <message>
        <source>The layout %1 cannot be restored; the default one is shown.</source>
        <translation>レイアウト%1を復元できません。既定のレイアウトを表示しています。</translation>
    </message>
    <message>
        <source>It was saved by another version of the program.</source>
        <translation>プログラムの別のバージョンで保存されたものです。</translation>
    </message>
    <message>
        <source>The desktop may turn the screen off while something runs: %1</source>
        <translation>動作中にデスクトップが画面をオフにする可能性があります: %1</translation>
    </message>
    <message>
        <source>%1 was made from %2.</source>
        <comment>two files</comment>
        <translation>%2から%1を作成しました。</translation>
    </message>
    <message>
        <source>A robot arm, a recording or a session is running</source>
        <translation>ロボットアーム、記録、またはセッションが動作中です</translation>
    </message>
    <message>
        <source>&amp;Preferences…</source>
        <translation>環境設定(&amp;P)…</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>最近使ったファイルを開く(&amp;R)</translation>
    </message>
    <message>
        <source>Recordings</source>
        <translation>記録</translation>
    </message>
    <message>
        <source>Studies</source>
        <translation>実験</translation>
    </message>
    <message>
        <source>&amp;Clear the list</source>
        <translation>一覧を消去(&amp;C)</translation>
    </message>
    <message>
        <source>Reopen the &amp;last session</source>
        <translation>前回のセッションを再び開く(&amp;L)</translation>
    </message>
    <message>
        <source>STOP was released after %1 s.</source>
        <translation>STOPは%1 s後に解除されました。</translation>
    </message>
    <message>
        <source>STOP. %1</source>
        <comment>cause</comment>
        <translation>STOP。%1</translation>
    </message>
    <message>
        <source>Open arm</source>
        <translation>アームを開く</translation>
    </message>
    <message>
        <source>&amp;Open arm…</source>
        <translation>アームを開く(&amp;O)…</translation>
    </message>
    <message>
        <source>An arm over ROS 2, described in a file</source>
        <translation>ファイルで記述されたROS 2のアーム</translation>
    </message>
    <message>
        <source>Scenes, arms and source lists</source>
        <translation>シーン、アーム、ソースの一覧</translation>
    </message>
    <message>
        <source>Recordings (*.teleta *.csv *.mcap *.npz *.npy *.h5 *.hdf5 *.mat *.asf)</source>
        <translation>記録 (*.teleta *.csv *.mcap *.npz *.npy *.h5 *.hdf5 *.mat *.asf)</translation>
    </message>
    <message>
        <source>Plot</source>
        <translation>プロット</translation>
    </message>
    <message>
        <source>Any signal over time: live ones and those of recordings, with cursors and spectra</source>
        <translation>あらゆる信号の時間変化: 動作中の信号と記録の信号。カーソルとスペクトル付き</translation>
    </message>
    <message>
        <source>Connect to a site</source>
        <translation>サイトに接続</translation>
    </message>
    <message>
        <source>Sites (*.toml)</source>
        <translation>サイト (*.toml)</translation>
    </message>
    <message>
        <source>&amp;Connect to a site…</source>
        <translation>サイトに接続(&amp;C)…</translation>
    </message>
    <message>
        <source>Arms and arrays at another place, where teleta-site runs</source>
        <translation>teleta-site が動く別の場所のアームとアレイ</translation>
    </message>
    <message>
        <source>Re&amp;quest control of the site</source>
        <translation>サイトの操作権を要求(&amp;Q)</translation>
    </message>
    <message>
        <source>Rele&amp;ase control of the site</source>
        <translation>サイトの操作権を手放す(&amp;A)</translation>
    </message>
    <message>
        <source>What accuracy costs in time on this machine, and the setting that the camera uses</source>
        <translation>このコンピューターで精度にかかる時間と、カメラが使う設定</translation>
    </message>
    <message>
        <source>Arms (*.toml)</source>
        <translation>アーム (*.toml)</translation>
    </message>
    <message>
        <source>Hand o&amp;ver to</source>
        <translation>操作権を渡す相手(&amp;V)</translation>
    </message>
    <message>
        <source>&amp;Take over control of the site</source>
        <translation>サイトの操作権を引き継ぐ(&amp;T)</translation>
    </message>
    <message>
        <source>For supervisors: the other console has 5 s to decline</source>
        <translation>監督者用：相手のコンソールは 5 秒以内に断れます</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
</context>
<context>
    <name>teleta::console::MarkList</name>
    <message>
        <source>Time</source>
        <translation>時刻</translation>
    </message>
    <message>
        <source>What was marked</source>
        <translation>マークの内容</translation>
    </message>
    <message>
        <source>Marks</source>
        <translation>マーク</translation>
    </message>
    <message>
        <source>Moments that somebody marked in the recording. Double-click a text or press Enter to type it, Delete takes a mark out, Ctrl+Z undoes. In a recording that is played, a double click on a mark goes there.</source>
        <translation>記録中に付けられたマークの時点です。テキストをダブルクリックするかEnterを押すと入力でき、Deleteでマークを削除、Ctrl+Zで元に戻します。再生中の記録では、マークをダブルクリックするとそこへ移動します。</translation>
    </message>
    <message>
        <source>This recording is played: Enter goes to a mark. Marks are named while they are recorded, or afterwards beside the source that was recorded.</source>
        <translation>この記録は再生中です。Enterでマークに移動します。マークの名前は、記録中、または記録後に元のソースを表示して付けます。</translation>
    </message>
    <message>
        <source>No marks yet. While something is recorded, M sets one. Press Enter on it to type what it was.</source>
        <translation>マークはまだありません。記録中にMでマークを付けます。内容はそのマークでEnterを押して入力します。</translation>
    </message>
</context>
<context>
    <name>teleta::console::MotorCalibrator</name>
    <message>
        <source>Open the recording of a motor</source>
        <translation>モーターの記録を開く</translation>
    </message>
    <message>
        <source>Recordings (*.csv)</source>
        <translation>記録 (*.csv)</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>表 (*.csv)</translation>
    </message>
    <message>
        <source>Save a copy of the profile</source>
        <translation>プロファイルのコピーを保存</translation>
    </message>
    <message>
        <source>Profiles (*.toml)</source>
        <translation>プロファイル (*.toml)</translation>
    </message>
    <message>
        <source>Load a profile</source>
        <translation>プロファイルを読み込む</translation>
    </message>
    <message>
        <source>Choose another folder or file name.</source>
        <translation>別のフォルダーまたはファイル名を選んでください。</translation>
    </message>
    <message>
        <source>%1 could not be opened.</source>
        <comment>a file</comment>
        <translation>%1 を開けませんでした。</translation>
    </message>
    <message>
        <source>%1 could not be saved.</source>
        <comment>a file</comment>
        <translation>%1 を保存できませんでした。</translation>
    </message>
    <message>
        <source>The motor profile cannot be used: the motors use assumed values.</source>
        <translation>モーターのプロファイルを使用できないため、仮定値を使います。</translation>
    </message>
    <message>
        <source>Save the excitation</source>
        <translation>励振信号を書き込む</translation>
    </message>
    <message>
        <source>%1 belongs to another bracelet.</source>
        <comment>a file</comment>
        <translation>%1 は別のブレスレットのものです。</translation>
    </message>
    <message>
        <source>The file is for “%1”, this bracelet is “%2”. Measure this one, or connect the other.</source>
        <translation>これは「%1」のもので、現在のブレスレットは「%2」です。現在のものを測定するか、もう一方を接続してください。</translation>
    </message>
    <message>
        <source>Motor %1 was measured and is not saved.</source>
        <translation>モーター%1は測定されましたが、保存されていません。</translation>
    </message>
    <message>
        <source>Motors %1 were measured and are not saved.</source>
        <comment>1, 2</comment>
        <translation>モーター%1は測定されましたが、保存されていません。</translation>
    </message>
    <message>
        <source>Motor %1 was changed and is not saved.</source>
        <translation>モーター%1は変更されましたが、保存されていません。</translation>
    </message>
    <message>
        <source>Motors %1 were changed and are not saved.</source>
        <comment>1, 2</comment>
        <translation>モーター%1は変更されましたが、保存されていません。</translation>
    </message>
</context>
<context>
    <name>teleta::console::NewStudyDialog</name>
    <message>
        <source>&amp;Participants</source>
        <translation>参加者(&amp;P)</translation>
    </message>
    <message>
        <source>New study</source>
        <translation>新しい実験</translation>
    </message>
    <message>
        <source>Pilot: people try it, marked PILOT everywhere</source>
        <translation>パイロット: 人が試行、すべてに「パイロット」と表示</translation>
    </message>
    <message>
        <source>Simulated: no people, marked SIMULATED everywhere</source>
        <translation>シミュレーション: 人なし、すべてに「シミュレーション」と表示</translation>
    </message>
    <message>
        <source>&amp;Mode</source>
        <translation>モード(&amp;M)</translation>
    </message>
    <message>
        <source>&amp;Seed</source>
        <translation>シード(&amp;S)</translation>
    </message>
    <message>
        <source>The seed is a whole number from 0 to 18446744073709551615.</source>
        <translation>シードは0から18446744073709551615までの整数です。</translation>
    </message>
    <message>
        <source>F&amp;rom a file…</source>
        <translation>ファイルから(&amp;R)…</translation>
    </message>
    <message>
        <source>A protocol of your own (TOML)</source>
        <translation>独自のプロトコル (TOML)</translation>
    </message>
    <message>
        <source>Pr&amp;otocol</source>
        <translation>プロトコル(&amp;O)</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <comment>a protocol; where it is from</comment>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Open a protocol</source>
        <translation>プロトコルを開く</translation>
    </message>
    <message>
        <source>Protocols (*.toml)</source>
        <translation>プロトコル (*.toml)</translation>
    </message>
    <message>
        <source>In a file in this folder, for one station</source>
        <translation>このフォルダーのファイル内: 1ステーション</translation>
    </message>
    <message>
        <source>On a PostgreSQL server, shared by several stations</source>
        <translation>PostgreSQLサーバー上: 複数のステーションで共有</translation>
    </message>
    <message>
        <source>Run: real participants, data count</source>
        <translation>本番: 実際の参加者、データとして扱います</translation>
    </message>
    <message>
        <source>New &amp;folder</source>
        <translation>フォルダー (作成されます)(&amp;F)</translation>
    </message>
    <message>
        <source>S&amp;torage</source>
        <translation>保存先(&amp;K)</translation>
    </message>
    <message>
        <source>Create the study</source>
        <translation>実験を作成</translation>
    </message>
    <message>
        <source>Study folder</source>
        <translation>実験のフォルダー</translation>
    </message>
    <message numerus="yes">
        <source>%n test trial(s) per participant</source>
        <translation>
            <numerusform>参加者1名あたりテスト%n試行</numerusform>
        </translation>
    </message>
    <message>
        <source>There is no tactile pattern for %1: name a file for it in the protocol.</source>
        <translation>このプロトコルには、感じるべきパターン %1 がありません。プロトコルの中でそのファイルを指定してください。</translation>
    </message>
    <message>
        <source>Choose a folder by its full path.</source>
        <translation>フォルダーを完全なパスで選んでください。</translation>
    </message>
    <message>
        <source>The file is not a usable protocol; the one above stays selected. %1</source>
        <translation>このファイルは使用できるプロトコルではありません。上のプロトコルが選ばれたままです。%1</translation>
    </message>
    <message>
        <source>Determines the order of all trials: the same seed gives the same study. It is drawn at random, shown here and kept with the study.</source>
        <translation>全試行の順序を決めます: 同じシードからは同じ実験ができます。無作為に選ばれ、ここに表示され、実験とともに保存されます。</translation>
    </message>
    <message>
        <source>C&amp;hoose…</source>
        <translation>選択(&amp;H)…</translation>
    </message>
</context>
<context>
    <name>teleta::console::NoisePlayer</name>
    <message>
        <source>this computer has no sound output</source>
        <translation>このコンピューターには音声出力がありません</translation>
    </message>
    <message>
        <source>%1 cannot play 48 kHz</source>
        <comment>a sound output</comment>
        <translation>%1 は48 kHzを再生できません</translation>
    </message>
    <message>
        <source>the sound output stopped</source>
        <translation>音声出力が停止しました</translation>
    </message>
    <message>
        <source>headphones that stay plugged in</source>
        <translation>接続されたままのヘッドホン</translation>
    </message>
    <message>
        <source>headphones, plugged in, or the noise from another device</source>
        <translation>接続されたヘッドホン、または別の機器からのノイズ</translation>
    </message>
</context>
<context>
    <name>teleta::console::OperateDocks</name>
    <message>
        <source>Heatmap</source>
        <translation>ヒートマップ</translation>
    </message>
    <message>
        <source>Reconstruction</source>
        <translation>再構成</translation>
    </message>
    <message>
        <source>Features over time</source>
        <translation>特徴量の時間変化</translation>
    </message>
    <message>
        <source>Processing</source>
        <translation>処理</translation>
    </message>
    <message>
        <source>Stiffness</source>
        <translation>剛性</translation>
    </message>
    <message>
        <source>Bracelet</source>
        <translation>ブレスレット</translation>
    </message>
    <message>
        <source>Joints</source>
        <translation>関節</translation>
    </message>
    <message>
        <source>Touches</source>
        <translation>タッチ</translation>
    </message>
    <message>
        <source>Jog</source>
        <translation>ジョグ</translation>
    </message>
    <message>
        <source>Feedback</source>
        <translation>フィードバック</translation>
    </message>
    <message>
        <source>Contour</source>
        <translation>輪郭</translation>
    </message>
    <message>
        <source>Servo</source>
        <translation>サーボ</translation>
    </message>
    <message>
        <source>Servo runs</source>
        <translation>サーボ実行</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>カメラ</translation>
    </message>
    <message>
        <source>Events</source>
        <translation>イベント</translation>
    </message>
    <message>
        <source>Marks</source>
        <translation>マーク</translation>
    </message>
    <message>
        <source>Run sheet</source>
        <translation>探索シート</translation>
    </message>
    <message>
        <source>Gel</source>
        <translation>ゲル</translation>
    </message>
    <message>
        <source>Scene</source>
        <translation>現場</translation>
    </message>
</context>
<context>
    <name>teleta::console::OperatePage</name>
    <message>
        <source>Choose another folder or file name.</source>
        <translation>別のフォルダーまたはファイル名を選んでください。</translation>
    </message>
    <message>
        <source>joints</source>
        <translation>関節</translation>
    </message>
    <message>
        <source>The bracelet could not be opened.</source>
        <translation>ブレスレットを開けませんでした。</translation>
    </message>
    <message>
        <source>%1: joints</source>
        <comment>a source</comment>
        <translation>%1：関節</translation>
    </message>
    <message>
        <source>Check mesh_path in the file with which you opened the arm or its site.</source>
        <translation>アームまたはサイトを開いたファイルの mesh_path を確認してください。</translation>
    </message>
    <message>
        <source>Opening %1…</source>
        <comment>a source</comment>
        <translation>%1を開いています…</translation>
    </message>
    <message>
        <source>Its views come up as soon as it answers.</source>
        <translation>応答があり次第、表示が現れます。</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>キャンセル(&amp;C)</translation>
    </message>
    <message>
        <source>Closes it again</source>
        <translation>閉じます</translation>
    </message>
    <message>
        <source>They are left out. Compare [joint_names] in the arm&apos;s file.</source>
        <translation>これらは無視されます。アームのファイルの [joint_names] と比べてください。</translation>
    </message>
    <message>
        <source>The scene is held.</source>
        <translation>シーンは停止したままです。</translation>
    </message>
    <message>
        <source>Nothing goes on by itself after STOP.</source>
        <translation>STOP の後は何も自動では再開しません。</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>実行</translation>
    </message>
    <message>
        <source>not for %1</source>
        <comment>the bracelet plays no touches of an arm</comment>
        <translation>%1 には使われません</translation>
    </message>
    <message>
        <source>The bracelet does not play the touches of %1.</source>
        <comment>an arm</comment>
        <translation>ブレスレットは %1 の接触を再生しません。</translation>
    </message>
    <message>
        <source>It plays those of the arm that is shown.</source>
        <translation>表示中のアームの接触を再生します。</translation>
    </message>
    <message>
        <source>Show %1</source>
        <comment>an arm</comment>
        <translation>%1 を表示</translation>
    </message>
</context>
<context>
    <name>teleta::console::PairEntry</name>
    <message>
        <source>Pi&amp;xel, px:</source>
        <translation>画素、px(&amp;X):</translation>
    </message>
    <message>
        <source>&amp;Point, mm:</source>
        <translation>点、mm(&amp;P):</translation>
    </message>
    <message>
        <source>u, to the right</source>
        <translation>u、右向き</translation>
    </message>
    <message>
        <source>v, down</source>
        <translation>v、下向き</translation>
    </message>
    <message>
        <source>x of the point</source>
        <translation>点のx</translation>
    </message>
    <message>
        <source>y of the point</source>
        <translation>点のy</translation>
    </message>
    <message>
        <source>z of the point, along the tube</source>
        <translation>点のz (チューブの軸方向)</translation>
    </message>
    <message>
        <source>Add this pair (Enter)</source>
        <translation>このペアを追加します (Enter)</translation>
    </message>
    <message>
        <source>A&amp;dd pair</source>
        <translation>ペアを追加(&amp;D)</translation>
    </message>
</context>
<context>
    <name>teleta::console::PatternCollection</name>
    <message>
        <source>The pattern could not be saved.</source>
        <translation>パターンを保存できませんでした。</translation>
    </message>
    <message>
        <source>The pattern could not be duplicated.</source>
        <translation>パターンを複製できませんでした。</translation>
    </message>
    <message>
        <source>%1 could not be renamed.</source>
        <comment>a pattern</comment>
        <translation>%1 の名前を変更できませんでした。</translation>
    </message>
    <message>
        <source>%1 could not be deleted.</source>
        <comment>a pattern</comment>
        <translation>%1 を削除できませんでした。</translation>
    </message>
    <message>
        <source>%1 was renamed.</source>
        <comment>a pattern</comment>
        <translation>%1 の名前を変更しました。</translation>
    </message>
    <message>
        <source>%1 was deleted.</source>
        <comment>a pattern</comment>
        <translation>%1 を削除しました。</translation>
    </message>
    <message>
        <source>%1 could not be restored.</source>
        <comment>a pattern</comment>
        <translation>%1 を復元できませんでした。</translation>
    </message>
</context>
<context>
    <name>teleta::console::PatternPlayback</name>
    <message>
        <source>The pattern is shown on the screen but not felt.</source>
        <translation>再生中のものは表示だけで、感じられません。</translation>
    </message>
</context>
<context>
    <name>teleta::console::PatternsPage</name>
    <message>
        <source>%1 (copy)</source>
        <translation>%1 (コピー)</translation>
    </message>
    <message>
        <source>%1 could not be opened.</source>
        <comment>a file</comment>
        <translation>%1 を開けませんでした。</translation>
    </message>
    <message>
        <source>New pattern</source>
        <translation>新しいパターン</translation>
    </message>
    <message>
        <source>%1 could not be saved.</source>
        <comment>a file</comment>
        <translation>%1 を保存できませんでした。</translation>
    </message>
    <message>
        <source>Exporting %1…</source>
        <comment>a file</comment>
        <translation>%1 をエクスポート中…</translation>
    </message>
    <message>
        <source>%1 was exported.</source>
        <comment>a file</comment>
        <translation>%1 をエクスポートしました。</translation>
    </message>
    <message>
        <source>%1 could not be exported.</source>
        <comment>a file</comment>
        <translation>%1 をエクスポートできませんでした。</translation>
    </message>
    <message>
        <source>Unsaved edits</source>
        <translation>未保存の編集内容</translation>
    </message>
    <message numerus="yes">
        <source>There are %n more.</source>
        <translation>
            <numerusform>ほかに%n件あります。</numerusform>
        </translation>
    </message>
    <message>
        <source>Save pattern</source>
        <translation>パターンを保存</translation>
    </message>
    <message>
        <source>Open pattern</source>
        <translation>パターンを開く</translation>
    </message>
    <message>
        <source>Patterns (*.json)</source>
        <translation>パターン (*.json)</translation>
    </message>
    <message>
        <source>HJIF (*.hjif)</source>
        <translation>HJIF (*.hjif)</translation>
    </message>
    <message>
        <source>Haptic clips (*.haptic *.haptic.zip)</source>
        <translation>ハプティッククリップ (*.haptic *.haptic.zip)</translation>
    </message>
    <message>
        <source>tact (*.tact)</source>
        <translation>tact (*.tact)</translation>
    </message>
    <message>
        <source>Open the edits</source>
        <translation>編集内容を開く</translation>
    </message>
    <message>
        <source>Discard them</source>
        <translation>破棄する</translation>
    </message>
    <message>
        <source>Unsaved edits could not be backed up: a crash would lose them.</source>
        <translation>未保存の編集内容を退避できませんでした: 異常終了すると失われます。</translation>
    </message>
    <message>
        <source>The strength limit of the bracelet could not be read or saved: check the slider Strongest.</source>
        <translation>ブレスレットの強さの上限を読み込みまたは保存できませんでした: スライダ「最強」を確認してください。</translation>
    </message>
    <message>
        <source>%1 has unsaved edits.</source>
        <comment>a pattern</comment>
        <translation>%1 に未保存の編集内容があります。</translation>
    </message>
    <message>
        <source>The program ended before %1, edited %2, was saved. The file on disk is unchanged.</source>
        <comment>a pattern, a time</comment>
        <translation>プログラムは %1 (編集 %2) を保存せずに終了しました。ディスク上のファイルは元のままです。</translation>
    </message>
    <message>
        <source>%1 holds more than the pattern: %2</source>
        <comment>a file, a list of sentences</comment>
        <translation>%1にはパターンで表せない内容があります: %2</translation>
    </message>
    <message>
        <source>All patterns (*.json *.hjif *.haptic *.haptic.zip *.ahap *.ahap.zip *.tact)</source>
        <translation>すべてのパターン (*.json *.hjif *.haptic *.haptic.zip *.ahap *.ahap.zip *.tact)</translation>
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
        <translation>レイアウトに名前を付けて保存(&amp;S)…</translation>
    </message>
    <message>
        <source>D&amp;elete</source>
        <translation>削除(&amp;E)</translation>
    </message>
    <message>
        <source>Save layout</source>
        <translation>レイアウトを保存</translation>
    </message>
    <message>
        <source>Name (a layout of the same name is replaced):</source>
        <translation>名前 (同じ名前のレイアウトは置き換えられます):</translation>
    </message>
</context>
<context>
    <name>teleta::console::PlotPage</name>
    <message>
        <source>%1 could not be read.</source>
        <comment>a recording</comment>
        <translation>%1 を読み込めませんでした。</translation>
    </message>
    <message numerus="yes">
        <source>%1 is damaged: %n part(s) could not be read and are gaps.</source>
        <translation>
            <numerusform>%1 は破損しています: %n 個の部分を読み込めず、空白になります。</numerusform>
        </translation>
    </message>
    <message>
        <source>The layout %1 cannot be restored.</source>
        <translation>レイアウト「%1」を復元できません。</translation>
    </message>
    <message>
        <source>It was saved by another version of the program.</source>
        <translation>プログラムの別のバージョンで保存されたものです。</translation>
    </message>
    <message>
        <source>Save da&amp;ta…</source>
        <translation>データを保存(&amp;T)…</translation>
    </message>
    <message>
        <source>Plot a recording as a whole, without playing it</source>
        <translation>記録を再生せずに全体をプロットします</translation>
    </message>
    <message>
        <source>Reading: %p %</source>
        <translation>読み込み中: %p %</translation>
    </message>
    <message>
        <source>Follow</source>
        <translation>追従</translation>
    </message>
    <message>
        <source>The newest sample stays at the right end (Space, End)</source>
        <translation>最新のサンプルを右端に保ちます (Space、End)</translation>
    </message>
    <message>
        <source>Show everything</source>
        <translation>すべて表示</translation>
    </message>
    <message>
        <source>All samples, and axes that follow the values (Home, double click)</source>
        <translation>すべてのサンプルと、値に合わせる軸 (Home、ダブルクリック)</translation>
    </message>
    <message>
        <source>Cursors</source>
        <translation>カーソル</translation>
    </message>
    <message>
        <source>Two lines to measure between (C); Left and Right move A, with Ctrl B</source>
        <translation>間を測る二本の線 (C)。左右キーで A、Ctrl と左右キーで B を動かします</translation>
    </message>
    <message>
        <source>Power density</source>
        <translation>パワー密度</translation>
    </message>
    <message>
        <source>Spectra show the density of power instead of the amplitude</source>
        <translation>スペクトルを振幅ではなくパワー密度で表示します</translation>
    </message>
    <message>
        <source>Layouts</source>
        <translation>レイアウト</translation>
    </message>
    <message>
        <source>Save what is plotted under a name, and choose it again</source>
        <translation>プロットしているものを名前を付けて保存し、また選べます</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>保存</translation>
    </message>
    <message>
        <source>The picture, or the samples in view as CSV</source>
        <translation>図、または見えているサンプルの CSV</translation>
    </message>
    <message>
        <source>Undo remove</source>
        <translation>取り除きを元に戻す</translation>
    </message>
    <message>
        <source>Nothing is plotted yet</source>
        <translation>まだ何もプロットしていません</translation>
    </message>
    <message>
        <source>Drag a signal from the list onto this place, or choose it there and press Enter.</source>
        <translation>一覧から信号をここにドラッグするか、一覧で選んで Enter を押します。</translation>
    </message>
    <message>
        <source>Open a demo</source>
        <translation>デモを開く</translation>
    </message>
    <message>
        <source>A simulated arm that touches things</source>
        <translation>物に触れるシミュレーションのアーム</translation>
    </message>
    <message>
        <source>Add a recording…</source>
        <translation>記録を追加…</translation>
    </message>
    <message>
        <source>%1 old samples dropped</source>
        <translation>古いサンプル %1 個を破棄</translation>
    </message>
    <message>
        <source>%1 frames lost</source>
        <translation>%1 フレーム欠落</translation>
    </message>
    <message>
        <source>Add a recording</source>
        <translation>記録を追加</translation>
    </message>
    <message>
        <source>Recordings (*.teleta)</source>
        <translation>記録 (*.teleta)</translation>
    </message>
    <message>
        <source>Save data</source>
        <translation>データを保存</translation>
    </message>
    <message>
        <source>Comma-separated values (*.csv)</source>
        <translation>カンマ区切り (*.csv)</translation>
    </message>
    <message>
        <source>plot</source>
        <comment>name of a file</comment>
        <translation>plot</translation>
    </message>
    <message>
        <source>The data were saved.</source>
        <translation>データを保存しました。</translation>
    </message>
    <message>
        <source>The data could not be saved.</source>
        <translation>データを保存できませんでした。</translation>
    </message>
    <message>
        <source>Choose another folder or file name.</source>
        <translation>別のフォルダーまたはファイル名を選んでください。</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>キャンセル</translation>
    </message>
    <message>
        <source>Stop reading and remove these signals; Ctrl+Z reads them again</source>
        <translation>読み取りを中止し、これらの信号を取り除きます。Ctrl+Z でもう一度読み取ります</translation>
    </message>
    <message>
        <source>A&amp;dd a recording…</source>
        <translation>記録を追加(&amp;D)…</translation>
    </message>
    <message>
        <source>From each start</source>
        <translation>それぞれの開始から</translation>
    </message>
    <message>
        <source>Clock time</source>
        <translation>時計の時刻</translation>
    </message>
    <message>
        <source>Time axis</source>
        <translation>時間軸</translation>
    </message>
    <message>
        <source>Where the time axis begins: with each source, so that a recording lies upon what runs, or by the clock</source>
        <translation>時間軸の始まり。ソースごとの開始では記録が動作中の信号に重なります。または時計に従います</translation>
    </message>
    <message numerus="yes">
        <source>%n signal(s) outside the view: Show everything (Home)</source>
        <translation>
            <numerusform>%n個の信号が表示範囲外: すべて表示 (Home)</numerusform>
        </translation>
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
        <translation>ソースが開いていません</translation>
    </message>
    <message>
        <source>is being read</source>
        <translation>読み込み中</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <comment>a signal of a joint</comment>
        <translation>%2の%1</translation>
    </message>
</context>
<context>
    <name>teleta::console::PreferencesDialog</name>
    <message>
        <source>&amp;Keep the screen on while something runs</source>
        <translation>動作中は画面をオンに保つ(&amp;K)</translation>
    </message>
    <message>
        <source>Add the &amp;Unix time to exported CSV files</source>
        <translation>エクスポートするCSVファイルにUnix時刻を追加(&amp;U)</translation>
    </message>
    <message>
        <source>Preferences</source>
        <translation>環境設定</translation>
    </message>
    <message>
        <source>While a session runs, something is recorded, or an arm may move</source>
        <translation>セッションの進行中、記録中、またはアームが動く可能性がある間</translation>
    </message>
    <message>
        <source>As the desktop</source>
        <translation>デスクトップに合わせる</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>ライト</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>ダーク</translation>
    </message>
    <message>
        <source>Offer what was open last time</source>
        <translation>前回開いていたものを候補として表示</translation>
    </message>
    <message>
        <source>Open what was open last time</source>
        <translation>前回開いていたものを開く</translation>
    </message>
    <message>
        <source>Open nothing</source>
        <translation>何も開かない</translation>
    </message>
    <message>
        <source>A last column, utc_s, in seconds since 1970</source>
        <translation>最後の列utc_s、1970年からの秒数</translation>
    </message>
    <message>
        <source>Folder of recordings</source>
        <translation>記録のフォルダー</translation>
    </message>
    <message>
        <source>Lan&amp;guage:</source>
        <translation>言語(&amp;G):</translation>
    </message>
    <message>
        <source>&amp;Theme:</source>
        <translation>テーマ(&amp;T):</translation>
    </message>
    <message>
        <source>At the &amp;start:</source>
        <translation>起動時(&amp;S):</translation>
    </message>
    <message>
        <source>&amp;Folder of recordings:</source>
        <translation>記録のフォルダー(&amp;F):</translation>
    </message>
    <message>
        <source>C&amp;hoose…</source>
        <translation>選択(&amp;H)…</translation>
    </message>
</context>
<context>
    <name>teleta::console::ProbingStrip</name>
    <message>
        <source>Sto&amp;p probing</source>
        <translation>プロービングを停止(&amp;P)</translation>
    </message>
    <message>
        <source>Progress of the probing</source>
        <translation>プロービングの進捗</translation>
    </message>
    <message>
        <source>SIMULATED: a person probes the tube; pairs so far: %1</source>
        <translation>シミュレーション: 人がチューブをプロービング中。これまでのペア: %1</translation>
    </message>
    <message>
        <source>Keep the pairs collected so far</source>
        <translation>これまでに収集した分を残します</translation>
    </message>
</context>
<context>
    <name>teleta::console::ProtocolDialog</name>
    <message>
        <source>Protocol</source>
        <translation>プロトコル</translation>
    </message>
    <message>
        <source>of the onset of the stimulus</source>
        <translation>刺激の開始から</translation>
    </message>
    <message>
        <source>of its end</source>
        <translation>刺激の終了から</translation>
    </message>
    <message>
        <source> ×</source>
        <comment>after a number</comment>
        <translation> ×</translation>
    </message>
    <message>
        <source>all repetitions together, in random order</source>
        <translation>全反復をまとめてランダムな順序</translation>
    </message>
    <message>
        <source>each repetition in a random order</source>
        <translation>反復ごとにランダムな順序</translation>
    </message>
    <message>
        <source>pink</source>
        <translation>ピンク</translation>
    </message>
    <message>
        <source>none</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>&amp;Name</source>
        <translation>名前(&amp;N)</translation>
    </message>
    <message>
        <source>D&amp;escription</source>
        <translation>説明(&amp;E)</translation>
    </message>
    <message>
        <source>&amp;Stimulus, at most</source>
        <translation>刺激の上限(&amp;S)</translation>
    </message>
    <message>
        <source>Answer &amp;within</source>
        <translation>回答期限(&amp;W)</translation>
    </message>
    <message>
        <source>Or&amp;der</source>
        <translation>順序(&amp;D)</translation>
    </message>
    <message>
        <source>&amp;Practice</source>
        <translation>練習(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Test</source>
        <translation>テスト(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Masking noise</source>
        <translation>マスキングノイズ(&amp;M)</translation>
    </message>
    <message>
        <source>&amp;Add a task</source>
        <translation>課題を追加(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>開く(&amp;O)…</translation>
    </message>
    <message>
        <source>The pape&amp;r&apos;s</source>
        <translation>論文のプロトコル(&amp;R)</translation>
    </message>
    <message>
        <source>Sa&amp;ve as…</source>
        <translation>名前を付けて保存(&amp;V)…</translation>
    </message>
    <message>
        <source>feedback</source>
        <translation>フィードバック</translation>
    </message>
    <message>
        <source>pictures in view</source>
        <translation>図を表示</translation>
    </message>
    <message>
        <source> × each pattern</source>
        <comment>after a number</comment>
        <translation> × 各パターン</translation>
    </message>
    <message>
        <source>Task</source>
        <translation>課題</translation>
    </message>
    <message>
        <source>for example shape</source>
        <translation>例: shape</translation>
    </message>
    <message>
        <source>for example static, dynamic</source>
        <translation>例: static, dynamic</translation>
    </message>
    <message>
        <source>Identifier</source>
        <translation>識別子</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名前</translation>
    </message>
    <message>
        <source>Conditions</source>
        <translation>条件</translation>
    </message>
    <message>
        <source>Patterns</source>
        <translation>パターン</translation>
    </message>
    <message>
        <source>Remove this task</source>
        <translation>この課題を削除</translation>
    </message>
    <message>
        <source>this form</source>
        <translation>このフォーム</translation>
    </message>
    <message>
        <source> (expected: %1)</source>
        <translation> (期待される値: %1)</translation>
    </message>
    <message>
        <source>Save the protocol</source>
        <translation>プロトコルを保存</translation>
    </message>
    <message>
        <source>Protocols (*.toml)</source>
        <translation>プロトコル (*.toml)</translation>
    </message>
    <message>
        <source>✓ Saved: %1</source>
        <translation>✓ 保存しました: %1</translation>
    </message>
    <message>
        <source>no rests</source>
        <translation>休憩なし</translation>
    </message>
    <message>
        <source>after every </source>
        <comment>before a number of trials</comment>
        <translation>間隔: </translation>
    </message>
    <message>
        <source> trials</source>
        <comment>after a number</comment>
        <translation> 試行</translation>
    </message>
    <message>
        <source>at least </source>
        <comment>before a number of seconds</comment>
        <translation>最短 </translation>
    </message>
    <message>
        <source>Rests</source>
        <translation>休憩</translation>
    </message>
    <message>
        <source>Add a &amp;questionnaire</source>
        <translation>質問票を追加(&amp;Q)</translation>
    </message>
    <message>
        <source>Choose a pattern file…</source>
        <translation>パターンファイルを選択…</translation>
    </message>
    <message>
        <source>a letter and a condition of the task, then the file</source>
        <translation>課題の文字と条件、続けてファイル</translation>
    </message>
    <message>
        <source>the file of &quot;%1 %2&quot; cannot be found</source>
        <translation>「%1 %2」のファイルが見つかりません</translation>
    </message>
    <message>
        <source>&quot;%1 %2&quot; has two files</source>
        <translation>「%1 %2」にファイルが2つあります</translation>
    </message>
    <message>
        <source>one file</source>
        <translation>1つのファイル</translation>
    </message>
    <message>
        <source>Pattern file for %1</source>
        <comment>a letter and a condition</comment>
        <translation>%1 のパターンファイル</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>未保存の変更</translation>
    </message>
    <message>
        <source>The protocol has changes that are not saved.</source>
        <translation>プロトコルに未保存の変更があります。</translation>
    </message>
    <message>
        <source>letter, condition and file, one per line, for your own patterns; all others are built in</source>
        <translation>自作のパターンの文字、条件、ファイルを1行に1つ。ほかはすべてプログラムに付属しています</translation>
    </message>
    <message>
        <source>letter and name, one per line, for example A circle</source>
        <translation>文字と名前を1行に1つ。例: A circle</translation>
    </message>
    <message>
        <source>Your own</source>
        <translation>自作のもの</translation>
    </message>
    <message>
        <source>the task has no pattern &quot;%1 %2&quot;</source>
        <translation>この課題に「%1 %2」にあたるパターンはありません</translation>
    </message>
    <message>
        <source>its full path</source>
        <translation>その絶対パス</translation>
    </message>
    <message>
        <source>There is no tactile pattern for %1. Name a file for it, or use a task, letter and condition whose pattern is built in. The protocol can be saved as it is.</source>
        <translation>感じるべきパターン %1 がありません。ファイルを指定するか、パターンがプログラムに付属している課題、文字、条件にしてください。プロトコルは保存できます。</translation>
    </message>
    <message numerus="yes">
        <source>%n test trial(s) per participant</source>
        <translation>
            <numerusform>参加者1名あたりテスト%n試行</numerusform>
        </translation>
    </message>
    <message>
        <source>Add a task with &amp;levels</source>
        <translation>レベルのある課題を追加(&amp;L)</translation>
    </message>
    <message>
        <source>names separated by semicolons, for the description of exported data</source>
        <translation>「;」で区切った名前。エクスポートしたデータの説明に使います</translation>
    </message>
    <message>
        <source>Aut&amp;hors</source>
        <translation>著者(&amp;H)</translation>
    </message>
    <message>
        <source>Record each sess&amp;ion</source>
        <translation>各セッションを記録(&amp;I)</translation>
    </message>
    <message>
        <source>May &amp;be felt again</source>
        <translation>再提示(&amp;B)</translation>
    </message>
    <message>
        <source>Tri&amp;ggers</source>
        <translation>トリガー(&amp;G)</translation>
    </message>
    <message>
        <source>Ma&amp;ke a study…</source>
        <translation>実験を作成(&amp;K)…</translation>
    </message>
</context>
<context>
    <name>teleta::console::ProtocolReading</name>
    <message>
        <source>Protocol</source>
        <translation>プロトコル</translation>
    </message>
    <message>
        <source>Ma&amp;ke a study…</source>
        <translation>実験を作成(&amp;K)…</translation>
    </message>
    <message>
        <source>Chan&amp;ge a copy…</source>
        <translation>コピーを変更(&amp;G)…</translation>
    </message>
</context>
<context>
    <name>teleta::console::QuestionnaireEditor</name>
    <message>
        <source>Questionnaire</source>
        <translation>質問票</translation>
    </message>
    <message>
        <source>for example effort</source>
        <translation>例: effort</translation>
    </message>
    <message>
        <source>before the first session</source>
        <translation>最初のセッションの前</translation>
    </message>
    <message>
        <source>before each session</source>
        <translation>各セッションの前</translation>
    </message>
    <message>
        <source>after each session</source>
        <translation>各セッションの後</translation>
    </message>
    <message>
        <source>after the last session</source>
        <translation>最後のセッションの後</translation>
    </message>
    <message>
        <source>Identifier</source>
        <translation>識別子</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>タイトル</translation>
    </message>
    <message>
        <source>Filled in</source>
        <translation>記入の時期</translation>
    </message>
    <message>
        <source>Add a question</source>
        <translation>質問を追加</translation>
    </message>
    <message>
        <source>Remove this questionnaire</source>
        <translation>この質問票を削除</translation>
    </message>
    <message>
        <source>for example hard</source>
        <translation>例: hard</translation>
    </message>
    <message>
        <source>free text</source>
        <translation>自由記述</translation>
    </message>
    <message>
        <source>scale</source>
        <translation>尺度</translation>
    </message>
    <message>
        <source>one of several answers</source>
        <translation>選択肢から1つ</translation>
    </message>
    <message>
        <source> points</source>
        <comment>after a number</comment>
        <translation> 段階</translation>
    </message>
    <message>
        <source>what the last point means</source>
        <translation>最後の段階の意味</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>削除</translation>
    </message>
    <message>
        <source>Remove this question</source>
        <translation>この質問を削除</translation>
    </message>
    <message>
        <source>Question</source>
        <translation>質問</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>尺度</translation>
    </message>
    <message>
        <source>Answers</source>
        <translation>答え</translation>
    </message>
    <message>
        <source>required</source>
        <translation>回答必須</translation>
    </message>
    <message>
        <source>identifier and text, one per line, for example yes I felt it</source>
        <translation>識別子と文を1行に1つ、例: yes I felt it</translation>
    </message>
    <message>
        <source>all questions have to be answered</source>
        <translation>すべての質問への回答が必要です</translation>
    </message>
    <message>
        <source>of my own</source>
        <translation>自作のもの</translation>
    </message>
    <message>
        <source>NASA-TLX: six ratings</source>
        <translation>NASA-TLX: 6つの評定</translation>
    </message>
    <message>
        <source>NASA-TLX: ratings and comparisons</source>
        <translation>NASA-TLX: 評定と一対比較</translation>
    </message>
    <message>
        <source>System Usability Scale</source>
        <translation>System Usability Scale</translation>
    </message>
    <message>
        <source>Questions</source>
        <translation>質問</translation>
    </message>
    <message>
        <source>scale from 0 to 100</source>
        <translation>0から100までの尺度</translation>
    </message>
    <message>
        <source>one of two answers</source>
        <translation>2つの答えから1つ</translation>
    </message>
    <message>
        <source>what the first point means</source>
        <translation>最初の段階の意味</translation>
    </message>
</context>
<context>
    <name>teleta::console::RecordingControls</name>
    <message numerus="yes">
        <source>%n damaged block(s) left out.</source>
        <translation>
            <numerusform>破損した%nブロックを除外しました。</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 could not be exported.</source>
        <comment>a file</comment>
        <translation>%1 をエクスポートできませんでした。</translation>
    </message>
    <message>
        <source>Choose another recording or folder.</source>
        <translation>別の記録またはフォルダーを選んでください。</translation>
    </message>
    <message>
        <source>%1 was recorded.</source>
        <comment>a file</comment>
        <translation>%1 を記録しました。</translation>
    </message>
    <message>
        <source>Nothing is recorded now.</source>
        <translation>現在、何も記録していません。</translation>
    </message>
    <message>
        <source>Marks are kept in a recording. Ctrl+R begins one.</source>
        <translation>マークは記録に保存されます。Ctrl+Rで記録を開始します。</translation>
    </message>
    <message>
        <source>Folder of the recordings</source>
        <translation>記録のフォルダー</translation>
    </message>
    <message>
        <source>End the &amp;recording</source>
        <translation>記録を終了(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Record</source>
        <translation>記録する(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Mark this moment</source>
        <translation>この瞬間にマークを付ける(&amp;M)</translation>
    </message>
    <message>
        <source>&amp;Folder of the recordings…</source>
        <translation>記録のフォルダー(&amp;F)…</translation>
    </message>
    <message>
        <source>&amp;Export recording as CSV…</source>
        <translation>記録をCSVとしてエクスポート(&amp;E)…</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>元に戻す(&amp;U)</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>やり直す(&amp;R)</translation>
    </message>
    <message>
        <source>The recording ended: %1.</source>
        <translation>記録が終了しました: %1。</translation>
    </message>
    <message>
        <source>What was recorded until then can be opened: %1</source>
        <translation>それまでの記録は開くことができます: %1</translation>
    </message>
    <message>
        <source>The recording could not begin.</source>
        <translation>記録を開始できませんでした。</translation>
    </message>
    <message>
        <source>Choose another folder in the menu Recording.</source>
        <translation>「記録」メニューで別のフォルダーを選んでください。</translation>
    </message>
    <message>
        <source>The marks of %1 could not be changed.</source>
        <comment>a file</comment>
        <translation>%1 のマークを変更できませんでした。</translation>
    </message>
    <message>
        <source>The recording was cut off; what had been written is there.</source>
        <translation>記録は途中で切れています。それまでに書き込まれた分は残っています。</translation>
    </message>
    <message>
        <source>Close whatever else uses the file. It is tried again with the next change of a mark, and when the program ends.</source>
        <translation>このファイルを使用しているほかのものを閉じてください。次にマークを変更したとき、およびプログラムの終了時に再試行されます。</translation>
    </message>
    <message>
        <source>%1 was written.</source>
        <comment>a file</comment>
        <translation>%1 を書き込みました。</translation>
    </message>
    <message>
        <source>Ex&amp;port recording as MCAP…</source>
        <translation>記録をMCAPとしてエクスポート(&amp;P)…</translation>
    </message>
    <message>
        <source>Play it</source>
        <translation>再生</translation>
    </message>
    <message>
        <source>Show in folder</source>
        <translation>フォルダーを開く</translation>
    </message>
    <message numerus="yes">
        <source>%n file(s) were written to %1.</source>
        <translation>
            <numerusform>%n 個のファイルを %1 に書き込みました。</numerusform>
        </translation>
    </message>
    <message>
        <source>Play the &amp;last recording</source>
        <translation>最後の記録を再生(&amp;L)</translation>
    </message>
</context>
<context>
    <name>teleta::console::RecordingDialog</name>
    <message>
        <source>The &amp;values fall under load</source>
        <translation>荷重がかかると値が下がる(&amp;V)</translation>
    </message>
    <message>
        <source>Open recording</source>
        <translation>記録を開く</translation>
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
        <translation>記録どおり</translation>
    </message>
    <message>
        <source>none</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>…</source>
        <translation>…</translation>
    </message>
    <message>
        <source>Choose the recording of the unloaded array</source>
        <translation>無荷重アレイの記録を選択</translation>
    </message>
    <message>
        <source>rows ×</source>
        <comment>N rows x M columns</comment>
        <translation>行 ×</translation>
    </message>
    <message>
        <source>columns</source>
        <translation>列</translation>
    </message>
    <message>
        <source>Rows</source>
        <translation>行</translation>
    </message>
    <message>
        <source>Columns</source>
        <translation>列</translation>
    </message>
    <message>
        <source>Recording:</source>
        <translation>記録:</translation>
    </message>
    <message>
        <source>&amp;Array:</source>
        <translation>アレイ(&amp;A):</translation>
    </message>
    <message>
        <source>&amp;Pitch:</source>
        <translation>ピッチ(&amp;P):</translation>
    </message>
    <message>
        <source>&amp;Unloaded (tare):</source>
        <translation>無荷重 (ゼロ点)(&amp;U):</translation>
    </message>
    <message>
        <source>&amp;Gain:</source>
        <translation>ゲイン(&amp;G):</translation>
    </message>
    <message>
        <source>Unit of the &amp;load:</source>
        <translation>荷重の単位(&amp;L):</translation>
    </message>
    <message>
        <source>&amp;Threshold:</source>
        <translation>しきい値(&amp;T):</translation>
    </message>
    <message>
        <source>&amp;Rate:</source>
        <translation>レート(&amp;R):</translation>
    </message>
    <message numerus="yes">
        <source>%n taxel(s), as in the file</source>
        <translation>
            <numerusform>ファイルと同じ%nタクセル</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 taxels, but the file has %2</source>
        <translation>%1タクセルですが、ファイルには%2あります</translation>
    </message>
    <message>
        <source>Recording of the unloaded array</source>
        <translation>無荷重アレイの記録</translation>
    </message>
    <message>
        <source>Frames (*.csv)</source>
        <translation>フレーム (*.csv)</translation>
    </message>
    <message>
        <source>Choose the gains of the taxels</source>
        <translation>タクセルのゲインを選択</translation>
    </message>
    <message>
        <source>Gains of the taxels</source>
        <translation>タクセルのゲイン</translation>
    </message>
    <message>
        <source>Gains (*.csv)</source>
        <translation>ゲイン (*.csv)</translation>
    </message>
    <message>
        <source>Gains of the ta&amp;xels:</source>
        <translation>タクセルのゲイン(&amp;X):</translation>
    </message>
    <message>
        <source>&amp;Start again at the end</source>
        <translation>末尾で先頭に戻る(&amp;S)</translation>
    </message>
</context>
<context>
    <name>teleta::console::RecordingExport</name>
    <message>
        <source>Export recording as CSV</source>
        <translation>記録をCSVとしてエクスポート</translation>
    </message>
    <message>
        <source>Recordings (*.teleta)</source>
        <translation>記録 (*.teleta)</translation>
    </message>
    <message>
        <source>Folder for the CSV files</source>
        <translation>CSVファイルのフォルダー</translation>
    </message>
    <message>
        <source>Exporting %1…</source>
        <comment>a file</comment>
        <translation>%1 をエクスポート中…</translation>
    </message>
    <message>
        <source>another export is running</source>
        <translation>別のエクスポートを実行中です</translation>
    </message>
    <message>
        <source>Export recording as MCAP</source>
        <translation>記録をMCAPとしてエクスポート</translation>
    </message>
    <message>
        <source>MCAP file</source>
        <translation>MCAPファイル</translation>
    </message>
    <message>
        <source>MCAP files (*.mcap)</source>
        <translation>MCAPファイル (*.mcap)</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>エクスポート…</translation>
    </message>
    <message>
        <source>Export here</source>
        <translation>ここにエクスポート</translation>
    </message>
</context>
<context>
    <name>teleta::console::RecordingFiles</name>
    <message>
        <source>%1 is there already.</source>
        <comment>a file</comment>
        <translation>%1は既にあります。</translation>
    </message>
    <message>
        <source>It may have been made from %1 before. Importing the file again makes %2.</source>
        <comment>two files</comment>
        <translation>以前に%1から作成されたものかもしれません。ファイルをもう一度インポートすると%2が作成されます。</translation>
    </message>
    <message>
        <source>&amp;Open the recording</source>
        <translation>記録を開く(&amp;O)</translation>
    </message>
    <message>
        <source>&amp;Import again</source>
        <translation>もう一度インポート(&amp;I)</translation>
    </message>
    <message>
        <source>Open file</source>
        <translation>ファイルを開く</translation>
    </message>
    <message>
        <source>Import with other &amp;choices…</source>
        <translation>別の設定でインポート(&amp;C)…</translation>
    </message>
</context>
<context>
    <name>teleta::console::RecordingImport</name>
    <message>
        <source>a recording of this name is being made</source>
        <translation>この名前の記録を作成中です</translation>
    </message>
    <message>
        <source>Importing %1…</source>
        <comment>a file</comment>
        <translation>%1をインポート中…</translation>
    </message>
    <message>
        <source>the folder cannot be made</source>
        <translation>フォルダーを作成できません</translation>
    </message>
    <message>
        <source>Topics that cannot be read were left out: %1.</source>
        <translation>読み込めないトピックを除外しました: %1。</translation>
    </message>
    <message>
        <source>The file was cut off; what could be read is there.</source>
        <translation>ファイルが途中で切れています。読み取れた分は残っています。</translation>
    </message>
    <message numerus="yes">
        <source>%n damaged chunk(s) left out.</source>
        <translation>
            <numerusform>破損した%nチャンクを除外しました。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n damaged message(s) left out.</source>
        <translation>
            <numerusform>破損したメッセージ%n件を除外しました。</numerusform>
        </translation>
    </message>
    <message>
        <source>The checksum of the file is wrong: it was damaged somewhere.</source>
        <translation>ファイルのチェックサムが誤っています: どこかが破損しています。</translation>
    </message>
    <message>
        <source>the loads are in %1, a unit without a usual threshold</source>
        <translation>荷重の単位%1には通常のしきい値がありません</translation>
    </message>
    <message>
        <source>in “In contact from”, from how many %1 a taxel is in contact</source>
        <translation>「接触とみなす荷重」に、何%1からタクセルを接触とみなすか</translation>
    </message>
</context>
<context>
    <name>teleta::console::RecordingMarks</name>
    <message>
        <source>mark</source>
        <translation>マーク</translation>
    </message>
    <message>
        <source>removal of a mark</source>
        <translation>マークの削除</translation>
    </message>
    <message>
        <source>text of a mark</source>
        <translation>マークのテキスト</translation>
    </message>
</context>
<context>
    <name>teleta::console::RecordingService</name>
    <message>
        <source>the folder cannot be made</source>
        <translation>フォルダーを作成できません</translation>
    </message>
    <message>
        <source>a folder that can be written to</source>
        <translation>書き込み可能なフォルダー</translation>
    </message>
</context>
<context>
    <name>teleta::console::ScreenKeeper</name>
    <message>
        <source>the service has ended</source>
        <translation>サービスが終了しました</translation>
    </message>
    <message>
        <source>there is no session bus</source>
        <translation>セッションバスがありません</translation>
    </message>
    <message>
        <source>the answer is not understood</source>
        <translation>応答を解釈できません</translation>
    </message>
</context>
<context>
    <name>teleta::console::ServerFields</name>
    <message>
        <source>otherwise PGPASSWORD or ~/.pgpass</source>
        <translation>省略時はPGPASSWORDまたは~/.pgpass</translation>
    </message>
    <message>
        <source>&amp;Server</source>
        <translation>サーバー(&amp;S)</translation>
    </message>
    <message>
        <source>Pass&amp;word</source>
        <translation>パスワード(&amp;W)</translation>
    </message>
    <message>
        <source>The address of a server looks like %1.</source>
        <translation>サーバーのアドレスは %1 のような形式です。</translation>
    </message>
    <message>
        <source>Used for this connection only, never saved</source>
        <translation>この接続にのみ使用し、どこにも保存しません</translation>
    </message>
</context>
<context>
    <name>teleta::console::ServerStudyDialog</name>
    <message>
        <source>Open a study on a server</source>
        <translation>サーバー上の実験を開く</translation>
    </message>
    <message>
        <source>&amp;Folder on this computer</source>
        <translation>このコンピューターのフォルダー(&amp;F)</translation>
    </message>
    <message>
        <source>Open the study</source>
        <translation>実験を開く</translation>
    </message>
    <message>
        <source>For exports, and for trials while the server is unreachable</source>
        <translation>エクスポートと、サーバーに接続できない間の試行の保存先です</translation>
    </message>
    <message>
        <source>Choose a folder by its full path.</source>
        <translation>フォルダーを完全なパスで選んでください。</translation>
    </message>
</context>
<context>
    <name>teleta::console::SignalSources</name>
    <message>
        <source>whole recording</source>
        <translation>記録全体</translation>
    </message>
</context>
<context>
    <name>teleta::console::SiteViews</name>
    <message>
        <source>Ask for new keys in time.</source>
        <translation>期限までに新しい鍵を依頼してください。</translation>
    </message>
    <message>
        <source>%1 was started anew.</source>
        <translation>%1 が再起動されました。</translation>
    </message>
    <message>
        <source>Request control again.</source>
        <translation>もう一度操作権を要求してください。</translation>
    </message>
    <message>
        <source>Control was handed to you by %1.</source>
        <translation>%1 から操作権を渡されました。</translation>
    </message>
    <message>
        <source>Let go of the switch and press it again.</source>
        <translation>スイッチを離して、もう一度押してください。</translation>
    </message>
    <message>
        <source>You no longer control %1.</source>
        <translation>%1 の操作権がなくなりました。</translation>
    </message>
    <message>
        <source>%1 controls %2 now.</source>
        <translation>いま %1 が %2 を操作しています。</translation>
    </message>
    <message>
        <source>STOP is held by %1.</source>
        <translation>STOP は %1 が保持しています。</translation>
    </message>
    <message>
        <source>It can be withdrawn there, or by a supervisor.</source>
        <translation>そこで、または監督者が解除できます。</translation>
    </message>
    <message>
        <source>%1 does not answer; its arms are held.</source>
        <translation>%1 が応答しません。アームは保持されます。</translation>
    </message>
    <message>
        <source>The site holds its arms by itself when no command comes.</source>
        <translation>指令が来なければ、サイトが自らアームを保持します。</translation>
    </message>
    <message>
        <source>Refused: another console is in control, or the cause is still there.</source>
        <translation>拒否：別のコンソールが操作中か、原因がまだ残っています。</translation>
    </message>
    <message>
        <source>Refused: this console may not do that.</source>
        <translation>拒否：このコンソールには許可されていません。</translation>
    </message>
    <message>
        <source>Refused: there is no such console.</source>
        <translation>拒否：そのコンソールはありません。</translation>
    </message>
    <message>
        <source>Refused: this console is not in control.</source>
        <translation>拒否：このコンソールに操作権がありません。</translation>
    </message>
    <message>
        <source>Refused: STOP is engaged.</source>
        <translation>拒否：STOP が作動しています。</translation>
    </message>
    <message>
        <source>not in control</source>
        <translation>操作権なし</translation>
    </message>
    <message>
        <source>control has changed since</source>
        <translation>その後操作権が移りました</translation>
    </message>
    <message>
        <source>STOP is engaged</source>
        <translation>STOP が作動中</translation>
    </message>
    <message>
        <source>the switch must be let go and pressed again</source>
        <translation>スイッチを離して押し直す必要があります</translation>
    </message>
    <message>
        <source>it was overtaken</source>
        <translation>追い越されました</translation>
    </message>
    <message>
        <source>the loop takes too long</source>
        <translation>往復に時間がかかりすぎます</translation>
    </message>
    <message>
        <source>the arm is not known</source>
        <translation>アームが不明です</translation>
    </message>
    <message>
        <source>it was no number</source>
        <translation>数値ではありません</translation>
    </message>
    <message>
        <source>the arm is not live</source>
        <translation>アームが動作していません</translation>
    </message>
    <message>
        <source>another program has this console&apos;s name</source>
        <translation>別のプログラムがこのコンソールの名前を使っています</translation>
    </message>
    <message>
        <source>the loop takes %1 s, the limit is %2 s</source>
        <translation>往復に %1 s かかります。上限は %2 s です</translation>
    </message>
    <message>
        <source>the loop takes longer than %1 s</source>
        <translation>往復に %1 s より長くかかります</translation>
    </message>
    <message>
        <source>Refused: another program named %1 is connected.</source>
        <translation>拒否：%1 という名前の別のプログラムが接続しています。</translation>
    </message>
    <message>
        <source>It was declined.</source>
        <translation>断られました。</translation>
    </message>
    <message>
        <source>It was declined: %1</source>
        <translation>断られました：%1</translation>
    </message>
    <message>
        <source>Nobody answered in time.</source>
        <translation>時間内に応答がありませんでした。</translation>
    </message>
</context>
<context>
    <name>teleta::console::SourceWatch</name>
    <message>
        <source>%1 was lost.</source>
        <comment>a source</comment>
        <translation>%1 との接続が切れました。</translation>
    </message>
    <message>
        <source>The file cannot be read further: it is damaged, or its disk is gone. Open it again when it can be read.</source>
        <translation>ファイルのこれより先を読み取れません。ファイルが破損しているか、ディスクがなくなっています。読み取れるようになってから、もう一度開いてください。</translation>
    </message>
    <message>
        <source>Check the cable and the power supply; it is tried again by itself.</source>
        <translation>ケーブルと電源を確認してください。自動的に再試行します。</translation>
    </message>
    <message>
        <source>The settings of %1 changed while it was recorded.</source>
        <comment>a source</comment>
        <translation>%1の設定は記録中に変更されました。</translation>
    </message>
    <message>
        <source>It is played with those of the beginning; the events of the recording have the others.</source>
        <translation>再生には開始時の設定が使われます。ほかの設定は記録のイベントにあります。</translation>
    </message>
    <message>
        <source>The recording of %1 is damaged.</source>
        <comment>a source</comment>
        <translation>%1の記録は破損しています。</translation>
    </message>
    <message>
        <source>The blocks that cannot be read are passed over; the others are played.</source>
        <translation>読み取れないブロックは飛ばされ、ほかのブロックは再生されます。</translation>
    </message>
    <message>
        <source>%1 has become warmer since its tare.</source>
        <comment>a source</comment>
        <translation>%1は風袋引きの後に温まりました。</translation>
    </message>
    <message>
        <source>%1 has become colder since its tare.</source>
        <comment>a source</comment>
        <translation>%1は風袋引きの後に冷えました。</translation>
    </message>
    <message>
        <source>What it reads at rest moved with temperature while it was recorded.</source>
        <translation>静止時の値は、記録中に温度とともに変わりました。</translation>
    </message>
    <message>
        <source>What it reads at rest moves with temperature. Tare it again with nothing touching.</source>
        <translation>静止時の値は温度とともに変わります。何も触れない状態でもう一度風袋引きをしてください。</translation>
    </message>
    <message>
        <source>Chip %1: %2</source>
        <translation>チップ%1: %2</translation>
    </message>
</context>
<context>
    <name>teleta::console::StartPage</name>
    <message>
        <source>No source</source>
        <translation>ソースなし</translation>
    </message>
    <message>
        <source>Open a demo scene to look around, a recording, or a list of sources.</source>
        <translation>デモシーン、記録、またはソースリストを開いてください。</translation>
    </message>
    <message>
        <source>First &amp;steps</source>
        <translation>はじめに(&amp;S)</translation>
    </message>
    <message>
        <source>The page of the handbook to begin with (F1)</source>
        <translation>最初に読むハンドブックのページ (F1)</translation>
    </message>
    <message>
        <source>Open &amp;demo scene</source>
        <translation>デモシーンを開く(&amp;D)</translation>
    </message>
    <message>
        <source>A simulated arm that touches five materials</source>
        <translation>5種類の材料に触れるシミュレーションアーム</translation>
    </message>
    <message>
        <source>A recording of this program or as MCAP, or recorded frames of an array: CSV, NumPy, HDF5, MATLAB, Tekscan</source>
        <translation>このプログラムの記録かMCAP、またはアレイのフレームの記録：CSV、NumPy、HDF5、MATLAB、Tekscan</translation>
    </message>
    <message>
        <source>Open source &amp;list…</source>
        <translation>ソースリストを開く(&amp;L)…</translation>
    </message>
    <message>
        <source>A TOML file that lists scenes and recordings</source>
        <translation>シーンと記録を列挙したTOMLファイル</translation>
    </message>
    <message>
        <source>&amp;Open recording…</source>
        <translation>記録を開く(&amp;O)…</translation>
    </message>
</context>
<context>
    <name>teleta::console::StudyBracelet</name>
    <message>
        <source>Tactor %1: %2 → %3</source>
        <comment>a number; full drives</comment>
        <translation>タクタ%1: %2 → %3</translation>
    </message>
    <message>
        <source>Balance the bracelet</source>
        <translation>ブレスレットの釣り合わせ</translation>
    </message>
    <message>
        <source>Use these full drives for the bracelet %1?</source>
        <translation>この最大駆動量をブレスレット%1に使いますか?</translation>
    </message>
    <message>
        <source>As felt by: %1</source>
        <comment>a participant, or all</comment>
        <translation>感じた人: %1</translation>
    </message>
    <message>
        <source>Patterns, feedback and later studies will use them. The page Calibrate can change them again.</source>
        <translation>パターン、フィードバック、以後の実験がこれで再生されます。キャリブレーションページで再び変更できます。</translation>
    </message>
    <message>
        <source>&amp;Use them</source>
        <translation>使う(&amp;U)</translation>
    </message>
    <message>
        <source>Another bracelet was connected meanwhile.</source>
        <translation>その間に別のブレスレットが接続されました。</translation>
    </message>
    <message>
        <source>Nothing was changed. Connect the one with which the study was run.</source>
        <translation>何も変更していません。実験に使ったものを接続してください。</translation>
    </message>
    <message>
        <source>The tactors are balanced.</source>
        <translation>タクタを釣り合わせました。</translation>
    </message>
    <message>
        <source>Saved: %1</source>
        <translation>保存しました: %1</translation>
    </message>
    <message>
        <source>The full drives could not be saved.</source>
        <translation>最大駆動量を保存できませんでした。</translation>
    </message>
    <message>
        <source>They are used until the program ends. Save them on the page Calibrate.</source>
        <translation>プログラムの終了まで使われます。キャリブレーションページで保存してください。</translation>
    </message>
</context>
<context>
    <name>teleta::console::StudyController</name>
    <message>
        <source>the open study is being read or written</source>
        <translation>開いている実験を読み書き中です</translation>
    </message>
    <message>
        <source>to leave the session first</source>
        <translation>先にセッションを離れること</translation>
    </message>
    <message>
        <source>to try again in a moment</source>
        <translation>しばらくしてからの再試行</translation>
    </message>
    <message>
        <source>%1 could not be opened.</source>
        <comment>a folder</comment>
        <translation>%1 を開けませんでした。</translation>
    </message>
    <message>
        <source>The rehearsal could not be opened.</source>
        <translation>リハーサルを開けませんでした。</translation>
    </message>
    <message>
        <source>%1 could not be enrolled.</source>
        <comment>a participant</comment>
        <translation>%1 を登録できませんでした。</translation>
    </message>
    <message>
        <source>The study could not be read.</source>
        <translation>実験を読み取れませんでした。</translation>
    </message>
    <message>
        <source>The trials are safe in the study, but could not be exported.</source>
        <translation>試行は実験に安全に保存されていますが、エクスポートできませんでした。</translation>
    </message>
    <message>
        <source>The session could not be closed.</source>
        <translation>セッションを終了できませんでした。</translation>
    </message>
    <message>
        <source>The note is safe in the study, but could not be exported.</source>
        <translation>メモは実験に安全に保存されていますが、エクスポートできませんでした。</translation>
    </message>
    <message>
        <source>The export failed.</source>
        <translation>エクスポートに失敗しました。</translation>
    </message>
    <message>
        <source>a session of the open study is running</source>
        <translation>開いている実験のセッションが進行中です</translation>
    </message>
    <message>
        <source>The study could not be created.</source>
        <translation>実験を作成できませんでした。</translation>
    </message>
    <message>
        <source>The session could not start.</source>
        <translation>セッションを開始できませんでした。</translation>
    </message>
    <message>
        <source>Saved and verified: %1</source>
        <translation>保存し、読み戻して照合しました: %1</translation>
    </message>
    <message>
        <source>The note could not be saved.</source>
        <translation>メモを保存できませんでした。</translation>
    </message>
    <message>
        <source>%1 could not be deleted.</source>
        <comment>a participant</comment>
        <translation>%1を削除できませんでした。</translation>
    </message>
</context>
<context>
    <name>teleta::console::StudyLeaving</name>
    <message>
        <source>Study</source>
        <translation>実験</translation>
    </message>
    <message>
        <source>&amp;Try again</source>
        <translation>再試行(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;End the session</source>
        <translation>セッションを終了(&amp;E)</translation>
    </message>
    <message>
        <source>The last answer is not saved: %1</source>
        <translation>最後の回答は保存されていません: %1</translation>
    </message>
    <message>
        <source>It exists only in the memory of this program and is lost when the session ends.</source>
        <translation>このプログラムのメモリにだけあります。セッションはそれとともに終わります。</translation>
    </message>
    <message>
        <source>&amp;Discard it</source>
        <translation>破棄(&amp;L)</translation>
    </message>
    <message>
        <source>The session of %1 is still running.</source>
        <comment>a participant</comment>
        <translation>%1 のセッションが進行中です。</translation>
    </message>
    <message>
        <source>All answers are saved, and the session can be resumed later.</source>
        <translation>回答済みのものは保存されており、セッションは後で続けられます。</translation>
    </message>
</context>
<context>
    <name>teleta::console::StudyPage</name>
    <message>
        <source>The noise cannot be played.</source>
        <translation>ノイズを再生できません。</translation>
    </message>
    <message>
        <source>Play it from another device, and confirm its level.</source>
        <translation>別の機器で再生し、レベルを確認してください。</translation>
    </message>
    <message>
        <source>The figure could not be saved.</source>
        <translation>図を保存できませんでした。</translation>
    </message>
    <message>
        <source>A session of this study was interrupted.</source>
        <translation>この実験のセッションが中断されています。</translation>
    </message>
    <message>
        <source>%1 could not be opened.</source>
        <comment>a file</comment>
        <translation>%1 を開けませんでした。</translation>
    </message>
    <message>
        <source>The paper&apos;s protocol could not be read.</source>
        <translation>論文のプロトコルを読み取れませんでした。</translation>
    </message>
    <message>
        <source>Open a protocol</source>
        <translation>プロトコルを開く</translation>
    </message>
    <message>
        <source>Protocols (*.toml)</source>
        <translation>プロトコル (*.toml)</translation>
    </message>
    <message>
        <source>Open a study</source>
        <translation>実験を開く</translation>
    </message>
    <message>
        <source>✗ Not played: %1. Play it from another device.</source>
        <translation>✗ 再生できません: %1。別の機器で再生してください。</translation>
    </message>
    <message>
        <source>Computing …</source>
        <translation>計算中…</translation>
    </message>
    <message>
        <source>There are no completed trials yet.</source>
        <translation>完了した試行はまだありません。</translation>
    </message>
    <message>
        <source>The results could not be computed.</source>
        <translation>結果を計算できませんでした。</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>書き込みました: %1</translation>
    </message>
    <message>
        <source>Session</source>
        <translation>セッション</translation>
    </message>
    <message>
        <source>Results</source>
        <translation>結果</translation>
    </message>
    <message>
        <source>Counts</source>
        <translation>度数</translation>
    </message>
    <message>
        <source>Percent of the row</source>
        <translation>行に対する割合</translation>
    </message>
    <message>
        <source>What the matrix shows</source>
        <translation>行列の表示内容</translation>
    </message>
    <message>
        <source>Spee&amp;d</source>
        <translation>速度(&amp;D)</translation>
    </message>
    <message>
        <source>Real time, felt on the bracelet</source>
        <translation>実時間、ブレスレットで提示</translation>
    </message>
    <message>
        <source>%1 times real time, not played</source>
        <translation>実時間の%1倍、提示なし</translation>
    </message>
    <message>
        <source>The protocols that come with the program could not be read.</source>
        <translation>付属のプロトコルを読み取れませんでした。</translation>
    </message>
    <message>
        <source>comes with the program</source>
        <comment>a protocol</comment>
        <translation>付属</translation>
    </message>
    <message>
        <source>The participant&apos;s screen was disconnected.</source>
        <translation>参加者の画面が失われました。</translation>
    </message>
    <message>
        <source>The participant&apos;s window is now next to the console, and the session pauses. Reconnect the screen and show the window again.</source>
        <translation>参加者ウィンドウは現在コンソールの横にあり、セッションは一時停止中です。画面を接続し、ウィンドウを再び表示してください。</translation>
    </message>
    <message>
        <source>The participant&apos;s window covers part of the console.</source>
        <translation>参加者ウィンドウがコンソールの一部を覆っています。</translation>
    </message>
    <message>
        <source>There is no second screen, and no room next to the console. Connect a second screen, or make the console smaller, and show the window again.</source>
        <translation>ほかに画面がなく、コンソールの横にも場所がありません。2つ目の画面を接続するか、コンソールを小さくして、ウィンドウを再び表示してください。</translation>
    </message>
    <message>
        <source>This study is read-only: nothing can be written here.</source>
        <translation>この実験は見ることだけができます: ここには何も書き込めません。</translation>
    </message>
    <message>
        <source>Copy its whole folder to continue the study.</source>
        <translation>続けるにはフォルダ全体をコピーしてください。</translation>
    </message>
    <message>
        <source>No answer is lost. Resume it, or choose another one.</source>
        <translation>回答は失われていません。続行するか、別のセッションを選んでください。</translation>
    </message>
    <message>
        <source>Completed test trials only.</source>
        <translation>完了したテスト試行のみを対象とします。</translation>
    </message>
    <message>
        <source>Speed of the simulated participants; can be changed between sessions</source>
        <translation>シミュレーション参加者の速さ。セッションの合間に変更できます</translation>
    </message>
    <message>
        <source>Plan</source>
        <translation>計画</translation>
    </message>
    <message>
        <source>%1 was deleted.</source>
        <comment>a participant</comment>
        <translation>%1を削除しました。</translation>
    </message>
    <message>
        <source>Results that were written before still count the participant: write them again.</source>
        <translation>以前に書き込んだ結果は、まだこの参加者を数えています。書き込み直してください。</translation>
    </message>
    <message>
        <source>Show it</source>
        <translation>表示</translation>
    </message>
</context>
<context>
    <name>teleta::console::StudyPlanning</name>
    <message>
        <source>What is assumed</source>
        <translation>仮定するもの</translation>
    </message>
    <message>
        <source>Truth (*.toml)</source>
        <translation>真値 (*.toml)</translation>
    </message>
    <message>
        <source>There is no number of participants to try: &quot;from&quot; is above &quot;to&quot;.</source>
        <translation>試す参加者数がありません: 「最小」が「最大」を上回っています。</translation>
    </message>
    <message>
        <source>this study</source>
        <translation>この実験</translation>
    </message>
</context>
<context>
    <name>teleta::console::StudyRunner</name>
    <message>
        <source>STOP was pressed</source>
        <translation>STOPが押されました</translation>
    </message>
    <message>
        <source>there is no tactile pattern &quot;%1&quot;</source>
        <translation>提示するパターン「%1」がありません</translation>
    </message>
    <message>
        <source>a protocol that names a file for each pattern that is not built in</source>
        <translation>プログラムに付属していない各パターンのファイルを指定したプロトコル</translation>
    </message>
</context>
<context>
    <name>teleta::console::SweepPanel</name>
    <message>
        <source>Open the results of a sweep</source>
        <translation>スイープの結果を開く</translation>
    </message>
    <message>
        <source>Open a sweep</source>
        <translation>スイープを開く</translation>
    </message>
    <message>
        <source>Sweeps (*.toml)</source>
        <translation>スイープ (*.toml)</translation>
    </message>
    <message>
        <source>Empty folder for the results, or one of this sweep to go on with</source>
        <translation>結果のための空のフォルダー、または続けるこのスイープのフォルダー</translation>
    </message>
    <message>
        <source>%1 cells, each with %2 seeds: %3 runs.</source>
        <translation>%1 セル、それぞれ %2 シード: %3 回の実行。</translation>
    </message>
    <message>
        <source>%1 done, %2 failed, in %3.</source>
        <translation>%1 回済み、失敗 %2、%3 にあります。</translation>
    </message>
    <message>
        <source>%1 over the cells of the sweep</source>
        <translation>スイープのセルでの %1</translation>
    </message>
    <message>
        <source>Runs</source>
        <translation>実行</translation>
    </message>
    <message>
        <source>Failed</source>
        <translation>失敗</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>平均</translation>
    </message>
    <message>
        <source>Spread</source>
        <translation>ばらつき</translation>
    </message>
    <message>
        <source>95 % from</source>
        <translation>95 % 下限</translation>
    </message>
    <message>
        <source>95 % to</source>
        <translation>95 % 上限</translation>
    </message>
    <message>
        <source>The runs that are under way end…</source>
        <translation>進行中の実行が終わります…</translation>
    </message>
    <message>
        <source>Checking every cell…</source>
        <translation>すべてのセルを検査中…</translation>
    </message>
    <message>
        <source>No sweep is open</source>
        <translation>スイープは開かれていません</translation>
    </message>
    <message>
        <source>Choose one on the left, or open a file.</source>
        <translation>左で選ぶか、ファイルを開いてください。</translation>
    </message>
    <message>
        <source>No results yet</source>
        <translation>まだ結果がありません</translation>
    </message>
    <message>
        <source>A sweep runs a scene over a grid of settings and seeds, and keeps every run.</source>
        <translation>スイープは設定とシードの格子でシーンを実行し、すべての実行を残します。</translation>
    </message>
    <message>
        <source>%1 of %2 runs, %3 failed, %4 left</source>
        <translation>%2 回中 %1 回、失敗 %3、残り %4</translation>
    </message>
    <message>
        <source>Sweeps</source>
        <translation>スイープ</translation>
    </message>
    <message>
        <source>Sweeps that come with the program</source>
        <translation>プログラムに付属のスイープ</translation>
    </message>
    <message>
        <source>&amp;Open a sweep…</source>
        <translation>スイープを開く(&amp;O)…</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>キャンセル(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Measure</source>
        <translation>測定値(&amp;M)</translation>
    </message>
    <message>
        <source>Chart of a measure over the cells</source>
        <translation>セルでの測定値の図</translation>
    </message>
    <message>
        <source>Cells with their settings and the measure</source>
        <translation>セルとその設定と測定値</translation>
    </message>
    <message>
        <source>Open resu&amp;lts…</source>
        <translation>結果を開く(&amp;L)…</translation>
    </message>
    <message>
        <source>Scene</source>
        <translation>シーン</translation>
    </message>
    <message>
        <source>Protocol</source>
        <translation>プロトコル</translation>
    </message>
    <message>
        <source>Ladder</source>
        <translation>ラダー</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>測定値</translation>
    </message>
    <message>
        <source>all numbers of a run</source>
        <translation>実行のすべての数値</translation>
    </message>
    <message>
        <source>%1 runs, one for each seed.</source>
        <translation>%1 回の実行、シードごとに1回。</translation>
    </message>
    <message>
        <source>&amp;Start in…</source>
        <translation>フォルダーを選んで開始(&amp;S)…</translation>
    </message>
    <message>
        <source>Start the sweep</source>
        <translation>スイープを開始</translation>
    </message>
    <message>
        <source>Results are kept in a new folder in your documents</source>
        <translation>結果はドキュメント内の新しいフォルダーに保存されます</translation>
    </message>
    <message>
        <source>Every rung with %1 seeds.</source>
        <translation>すべての段を %1 個のシードで実行します。</translation>
    </message>
</context>
<context>
    <name>teleta::console::SweepRunning</name>
    <message>
        <source>The sweep cannot be opened.</source>
        <translation>スイープを開けません。</translation>
    </message>
    <message>
        <source>The sweep has failed.</source>
        <translation>スイープが失敗しました。</translation>
    </message>
</context>
<context>
    <name>teleta::console::TriggerEditor</name>
    <message>
        <source>none</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>serial port</source>
        <translation>シリアルポート</translation>
    </message>
    <message>
        <source>OSC by UDP</source>
        <translation>UDPのOSC</translation>
    </message>
    <message>
        <source>Serial port</source>
        <translation>シリアルポート</translation>
    </message>
    <message>
        <source>back to 0 after </source>
        <comment>before a number of milliseconds</comment>
        <translation>0に戻すまで </translation>
    </message>
    <message>
        <source>not back to 0</source>
        <translation>0に戻さない</translation>
    </message>
    <message>
        <source>Name or address of the receiver</source>
        <translation>受信側の名前またはアドレス</translation>
    </message>
    <message>
        <source>port </source>
        <comment>before a number</comment>
        <translation>ポート </translation>
    </message>
</context>
<context>
    <name>teleta::console::TubeFields</name>
    <message>
        <source>&amp;Image:</source>
        <translation>画像(&amp;I):</translation>
    </message>
    <message>
        <source>Len&amp;gth:</source>
        <translation>長さ(&amp;G):</translation>
    </message>
    <message>
        <source>Width of the image</source>
        <translation>画像の幅</translation>
    </message>
    <message>
        <source>Height of the image</source>
        <translation>画像の高さ</translation>
    </message>
    <message>
        <source>Radius of the tactile cylinder</source>
        <translation>触覚円筒の半径</translation>
    </message>
    <message>
        <source>Length of the tactile cylinder</source>
        <translation>触覚円筒の長さ</translation>
    </message>
    <message>
        <source>Length of the surface, from z = 0 of the sensor&apos;s frame</source>
        <translation>表面の長さ (センサー座標系の z = 0 から)</translation>
    </message>
    <message>
        <source>Width of the image that the pixels refer to</source>
        <translation>画素が属する画像の幅</translation>
    </message>
    <message>
        <source>Height of the image that the pixels refer to</source>
        <translation>画素が属する画像の高さ</translation>
    </message>
    <message>
        <source>Radius of the surface that the points lie on</source>
        <translation>点がある表面の半径</translation>
    </message>
    <message>
        <source>Factor from the holes of a shell to the tactile cylinder</source>
        <translation>シェルの穴から触覚円筒への係数</translation>
    </message>
    <message>
        <source>For points that are holes of a shell: x and y times this factor lie on the elastomer (0.97 for the shell in the paper)</source>
        <translation>点はシェルの穴です。そのxとyにこの係数を掛けるとエラストマー上の点になります (論文のシェル: 0.97)</translation>
    </message>
    <message>
        <source>Ra&amp;dius:</source>
        <translation>半径(&amp;D):</translation>
    </message>
    <message>
        <source>H&amp;ole factor:</source>
        <translation>穴の係数(&amp;O):</translation>
    </message>
</context>
<context>
    <name>teleta::console::Unattended</name>
    <message>
        <source>teleta-console: %1: cannot write the picture: %2</source>
        <translation>teleta-console: %1: 画像を書き込めません: %2</translation>
    </message>
</context>
<context>
    <name>teleta::cost::CostChart</name>
    <message>
        <source>median time of one call</source>
        <translation>1回の呼び出しの時間の中央値</translation>
    </message>
    <message>
        <source>mean error</source>
        <translation>平均誤差</translation>
    </message>
    <message>
        <source>Mean error over time of the settings of %1</source>
        <translation>%1の各設定の時間に対する平均誤差</translation>
    </message>
    <message>
        <source>%1 (exact)</source>
        <comment>name of a setting</comment>
        <translation>%1 (正確)</translation>
    </message>
</context>
<context>
    <name>teleta::pattern::LawList</name>
    <message>
        <source>Laws of the display</source>
        <translation>提示の法則</translation>
    </message>
    <message>
        <source>Warnings</source>
        <translation>警告</translation>
    </message>
    <message>
        <source>Laws: no warning</source>
        <translation>法則: 警告なし</translation>
    </message>
    <message>
        <source>Laws: checking…</source>
        <translation>法則: 検査中…</translation>
    </message>
    <message>
        <source>Laws: %1 to review</source>
        <translation>法則: 要確認%1件</translation>
    </message>
    <message>
        <source>F&amp;ix</source>
        <translation>修正(&amp;I)</translation>
    </message>
</context>
<context>
    <name>teleta::pattern::PatternDocument</name>
    <message>
        <source>%1 (copy)</source>
        <translation>%1 (コピー)</translation>
    </message>
    <message>
        <source>Add breakpoint</source>
        <translation>ブレークポイントの追加</translation>
    </message>
    <message>
        <source>Move object</source>
        <translation>オブジェクトの移動</translation>
    </message>
    <message>
        <source>Move breakpoints</source>
        <translation>ブレークポイントの移動</translation>
    </message>
    <message>
        <source>Set breakpoint</source>
        <translation>ブレークポイントの設定</translation>
    </message>
    <message>
        <source>Change curve</source>
        <translation>曲線の変更</translation>
    </message>
    <message>
        <source>Scale intensity</source>
        <translation>強度の拡大・縮小</translation>
    </message>
    <message>
        <source>Stretch in time</source>
        <translation>時間方向の伸縮</translation>
    </message>
    <message>
        <source>Delete object</source>
        <translation>オブジェクトの削除</translation>
    </message>
    <message>
        <source>Delete breakpoints</source>
        <translation>ブレークポイントの削除</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>切り取り</translation>
    </message>
    <message>
        <source>Paste</source>
        <translation>貼り付け</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>複製</translation>
    </message>
    <message>
        <source>Rotate</source>
        <translation>回転</translation>
    </message>
    <message>
        <source>Mirror</source>
        <translation>反転</translation>
    </message>
    <message>
        <source>Swap arms</source>
        <translation>腕の入れ替え</translation>
    </message>
    <message>
        <source>Add object</source>
        <translation>オブジェクトの追加</translation>
    </message>
    <message>
        <source>Change object</source>
        <translation>オブジェクトの変更</translation>
    </message>
    <message>
        <source>Bake object</source>
        <translation>オブジェクトのベイク</translation>
    </message>
    <message>
        <source>Follow the law</source>
        <translation>法則に合わせる</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>名前の変更</translation>
    </message>
    <message>
        <source>Edit notes</source>
        <translation>メモの編集</translation>
    </message>
    <message>
        <source>Edit tags</source>
        <translation>タグの編集</translation>
    </message>
    <message>
        <source>Change task</source>
        <translation>課題の変更</translation>
    </message>
    <message>
        <source>Change condition</source>
        <translation>条件の変更</translation>
    </message>
    <message>
        <source>Change duration</source>
        <translation>長さの変更</translation>
    </message>
    <message>
        <source>Overdrive</source>
        <translation>オーバードライブ</translation>
    </message>
    <message>
        <source>No motor needs overdrive here: the pattern is unchanged.</source>
        <translation>立ち上がりに助けの要るモーターはありません。パターンはそのままです。</translation>
    </message>
</context>
<context>
    <name>teleta::pattern::PatternEditor</name>
    <message>
        <source>&amp;Recent</source>
        <translation>最近使ったファイル(&amp;R)</translation>
    </message>
    <message>
        <source>Compared with %1…</source>
        <translation>%1 と比較中…</translation>
    </message>
    <message>
        <source>Compared with %1: largest difference %2 % (motor %3 at %4 s), rms %5 %</source>
        <translation>%1 との比較: 最大差 %2 % (モーター%3、%4 s)、rms %5 %</translation>
    </message>
    <message>
        <source>File</source>
        <translation>ファイル</translation>
    </message>
    <message>
        <source>New, open, recent, save, export</source>
        <translation>新規、開く、最近使ったファイル、保存、エクスポート</translation>
    </message>
    <message>
        <source>New</source>
        <translation>新規</translation>
    </message>
    <message>
        <source>An empty pattern</source>
        <translation>空のパターン</translation>
    </message>
    <message>
        <source>Open…</source>
        <translation>開く…</translation>
    </message>
    <message>
        <source>Open a pattern file</source>
        <translation>パターンファイルを開きます</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>保存</translation>
    </message>
    <message>
        <source>Save as…</source>
        <translation>名前を付けて保存…</translation>
    </message>
    <message>
        <source>Save the pattern under another name</source>
        <translation>パターンを別の名前で保存します</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>エクスポート…</translation>
    </message>
    <message>
        <source>Write HJIF, .haptic, AHAP, .tact, CSV or WAV</source>
        <translation>HJIF、.haptic、AHAP、.tact、CSV、WAVで書き込みます</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>一時停止</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>再生</translation>
    </message>
    <message>
        <source>Play from the playhead, or pause (Space)</source>
        <translation>再生ヘッドから再生、または一時停止します (Space)</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>Stop playing</source>
        <translation>再生を停止します</translation>
    </message>
    <message>
        <source>Loop</source>
        <translation>ループ</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>元に戻す</translation>
    </message>
    <message>
        <source>Undo the last edit</source>
        <translation>最後の編集を元に戻します</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>やり直す</translation>
    </message>
    <message>
        <source>Redo what was undone</source>
        <translation>元に戻した編集をやり直します</translation>
    </message>
    <message>
        <source>Pen</source>
        <translation>ペン</translation>
    </message>
    <message>
        <source>Every click adds a breakpoint (P)</source>
        <translation>クリックするたびにブレークポイントを追加します (P)</translation>
    </message>
    <message>
        <source>Snap</source>
        <translation>スナップ</translation>
    </message>
    <message>
        <source>Step of the grid, and of the arrow keys</source>
        <translation>グリッドおよび矢印キーの刻み</translation>
    </message>
    <message>
        <source>Step of the grid</source>
        <translation>グリッドの刻み</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>追加</translation>
    </message>
    <message>
        <source>Add an object at the playhead</source>
        <translation>再生ヘッドにオブジェクトを追加します</translation>
    </message>
    <message>
        <source>↺ 60°</source>
        <translation>↺ 60°</translation>
    </message>
    <message>
        <source>Rotate around the ring: every motor does what the next one did</source>
        <translation>リングに沿って回転: 各モーターが次のモーターの動作を引き継ぎます</translation>
    </message>
    <message>
        <source>↻ 60°</source>
        <translation>↻ 60°</translation>
    </message>
    <message>
        <source>Rotate around the ring: every motor does what the one before did</source>
        <translation>リングに沿って回転: 各モーターが前のモーターの動作を引き継ぎます</translation>
    </message>
    <message>
        <source>Mirror</source>
        <translation>反転</translation>
    </message>
    <message>
        <source>Other arm</source>
        <translation>反対の腕</translation>
    </message>
    <message>
        <source>The pattern for the other arm</source>
        <translation>反対の腕用のパターンにします</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>全体</translation>
    </message>
    <message>
        <source>Show the whole pattern (Ctrl+0 on the timeline)</source>
        <translation>パターン全体を表示します (タイムライン上でCtrl+0)</translation>
    </message>
    <message>
        <source>Untitled</source>
        <translation>無題</translation>
    </message>
    <message>
        <source>not saved</source>
        <translation>未保存</translation>
    </message>
    <message>
        <source>left arm</source>
        <translation>左腕</translation>
    </message>
    <message>
        <source>right arm</source>
        <translation>右腕</translation>
    </message>
    <message>
        <source>Compared with %1: no difference</source>
        <translation>%1 との比較: モーターの動作は同じです</translation>
    </message>
    <message>
        <source>Pattern editor</source>
        <translation>パターンエディター</translation>
    </message>
    <message>
        <source>Save the pattern; a new one is added to your own patterns</source>
        <translation>パターンを保存します。ファイルがない場合は自作パターンに入ります</translation>
    </message>
    <message>
        <source>Repeat from the beginning; Shift and dragging on the ruler set the range</source>
        <translation>末尾で先頭に戻ります。ルーラー上でShift+ドラッグすると範囲を設定できます</translation>
    </message>
    <message>
        <source>Snap times to a grid; hold Alt while dragging to ignore it</source>
        <translation>時刻をグリッドに合わせます。ドラッグ中にAltを押すと外れます</translation>
    </message>
    <message>
        <source>Reverse the order of the motors</source>
        <translation>モーターの順序を逆にします</translation>
    </message>
    <message>
        <source>Stop comparing</source>
        <translation>比較を終了</translation>
    </message>
    <message>
        <source>built-in, edits create a copy</source>
        <translation>組み込み、編集するとコピーを作成</translation>
    </message>
    <message>
        <source>STOP is engaged: release it to play</source>
        <translation>STOPが作動中です。再生するには解除してください</translation>
    </message>
</context>
<context>
    <name>teleta::pattern::PatternInspector</name>
    <message>
        <source>Numbers from 1 to 6, separated by spaces</source>
        <translation>1から6までの数字をスペース区切りで入力</translation>
    </message>
    <message>
        <source>Motors:</source>
        <translation>モーター:</translation>
    </message>
    <message>
        <source>Burst:</source>
        <translation>バースト:</translation>
    </message>
    <message>
        <source>Onset to onset:</source>
        <translation>開始間隔:</translation>
    </message>
    <message>
        <source>Onset by the law of apparent motion</source>
        <translation>仮現運動の法則による開始間隔</translation>
    </message>
    <message>
        <source>Turns:</source>
        <translation>周回数:</translation>
    </message>
    <message>
        <source>First motor:</source>
        <translation>最初のモーター:</translation>
    </message>
    <message>
        <source>Counter-clockwise (rising numbers)</source>
        <translation>反時計回り (番号の増加方向)</translation>
    </message>
    <message>
        <source>Burst by the law of apparent motion</source>
        <translation>仮現運動の法則によるバースト</translation>
    </message>
    <message>
        <source>Second motor:</source>
        <translation>2番目のモーター:</translation>
    </message>
    <message>
        <source>From:</source>
        <translation>始値:</translation>
    </message>
    <message>
        <source>To:</source>
        <translation>終値:</translation>
    </message>
    <message>
        <source>Period:</source>
        <translation>周期:</translation>
    </message>
    <message>
        <source>Width:</source>
        <translation>幅:</translation>
    </message>
    <message>
        <source>Length:</source>
        <translation>長さ:</translation>
    </message>
    <message>
        <source>Begins at:</source>
        <translation>開始時刻:</translation>
    </message>
    <message>
        <source>Point:</source>
        <translation>点:</translation>
    </message>
    <message>
        <source>its time:</source>
        <translation>時刻:</translation>
    </message>
    <message>
        <source>its angle:</source>
        <translation>角度:</translation>
    </message>
    <message>
        <source>along the arm:</source>
        <translation>腕の長さ方向:</translation>
    </message>
    <message>
        <source>Start:</source>
        <translation>開始:</translation>
    </message>
    <message>
        <source>Intensity:</source>
        <translation>強度:</translation>
    </message>
    <message>
        <source>Called:</source>
        <translation>名称:</translation>
    </message>
    <message>
        <source>Bake into breakpoints</source>
        <translation>ブレークポイントにベイク</translation>
    </message>
    <message>
        <source>&amp;Name:</source>
        <translation>名前(&amp;N):</translation>
    </message>
    <message>
        <source>Le&amp;ngth:</source>
        <translation>長さ(&amp;N):</translation>
    </message>
    <message>
        <source>&amp;Loop:</source>
        <translation>ループ(&amp;L):</translation>
    </message>
    <message>
        <source>Begin of the loop</source>
        <translation>ループの先頭</translation>
    </message>
    <message>
        <source>End of the loop</source>
        <translation>ループの末尾</translation>
    </message>
    <message>
        <source>T&amp;ells:</source>
        <translation>伝える内容(&amp;E):</translation>
    </message>
    <message>
        <source>Condition</source>
        <translation>条件</translation>
    </message>
    <message>
        <source>a shape</source>
        <translation>形状</translation>
    </message>
    <message>
        <source>a stiffness</source>
        <translation>剛性</translation>
    </message>
    <message>
        <source>something else</source>
        <translation>その他</translation>
    </message>
    <message>
        <source>no condition</source>
        <translation>条件なし</translation>
    </message>
    <message>
        <source>static</source>
        <translation>静的</translation>
    </message>
    <message>
        <source>dynamic</source>
        <translation>動的</translation>
    </message>
    <message>
        <source>&amp;Tags:</source>
        <translation>タグ(&amp;T):</translation>
    </message>
    <message>
        <source>N&amp;otes:</source>
        <translation>メモ(&amp;O):</translation>
    </message>
    <message>
        <source>Nothing is selected</source>
        <translation>何も選択されていません</translation>
    </message>
    <message>
        <source>Breakpoint of motor %1</source>
        <translation>モーター%1のブレークポイント</translation>
    </message>
    <message>
        <source>%1 breakpoints</source>
        <translation>ブレークポイント%1個</translation>
    </message>
    <message>
        <source>Time:</source>
        <translation>時刻:</translation>
    </message>
    <message>
        <source>Scale by:</source>
        <translation>倍率:</translation>
    </message>
    <message>
        <source>Stretch to:</source>
        <translation>伸縮後の長さ:</translation>
    </message>
    <message>
        <source>Curve:</source>
        <translation>曲線:</translation>
    </message>
    <message>
        <source>The range that is repeated; the whole pattern when both times are equal</source>
        <translation>繰り返し再生する範囲。両端が同じ場合はパターン全体</translation>
    </message>
</context>
<context>
    <name>teleta::pattern::PatternLibrary</name>
    <message>
        <source>Filter the patterns</source>
        <translation>パターンを絞り込みます</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>元に戻す</translation>
    </message>
    <message>
        <source>Patterns</source>
        <translation>パターン</translation>
    </message>
    <message>
        <source>Built-in: shapes</source>
        <translation>組み込み: 形状</translation>
    </message>
    <message>
        <source>Built-in: stiffness</source>
        <translation>組み込み: 剛性</translation>
    </message>
    <message>
        <source>Mine</source>
        <translation>自作</translation>
    </message>
    <message>
        <source>none yet: edit a built-in one</source>
        <translation>まだありません: 組み込みパターンを編集してください</translation>
    </message>
    <message>
        <source>damaged</source>
        <translation>破損</translation>
    </message>
    <message>
        <source>Tags: %1</source>
        <translation>タグ: %1</translation>
    </message>
    <message>
        <source>&amp;Open</source>
        <translation>開く(&amp;O)</translation>
    </message>
    <message>
        <source>&amp;Compare with it</source>
        <translation>これと比較(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Duplicate</source>
        <translation>複製(&amp;D)</translation>
    </message>
    <message>
        <source>&amp;Rename</source>
        <translation>名前の変更(&amp;R)</translation>
    </message>
    <message>
        <source>De&amp;lete</source>
        <translation>削除(&amp;L)</translation>
    </message>
    <message>
        <source>Open in the editor</source>
        <translation>エディターで開いています</translation>
    </message>
    <message>
        <source>Undo the last change to the library (Ctrl+Z in the list)</source>
        <translation>ライブラリへの最後の操作を元に戻します (一覧でCtrl+Z)</translation>
    </message>
    <message>
        <source>&lt;p&gt;A click or &lt;b&gt;Enter&lt;/b&gt; opens a pattern. Built-in patterns cannot be changed: the first edit creates a copy. Your own patterns: &lt;b&gt;F2&lt;/b&gt; renames, &lt;b&gt;Ctrl+D&lt;/b&gt; duplicates, &lt;b&gt;Delete&lt;/b&gt; deletes, &lt;b&gt;Ctrl+Z&lt;/b&gt; undoes that.&lt;/p&gt;</source>
        <translation>&lt;p&gt;クリックまたは&lt;b&gt;Enter&lt;/b&gt;でパターンを開きます。組み込みパターンは変更されず、最初の編集でコピーが作られます。自作パターンでは、&lt;b&gt;F2&lt;/b&gt;で名前の変更、&lt;b&gt;Ctrl+D&lt;/b&gt;で複製、&lt;b&gt;Delete&lt;/b&gt;で削除、&lt;b&gt;Ctrl+Z&lt;/b&gt;で元に戻します。&lt;/p&gt;</translation>
    </message>
    <message>
        <source>&lt;p&gt;The pattern in bold, with a bar in front of it, is open in the editor; keys act on the highlighted one.&lt;/p&gt;</source>
        <translation>&lt;p&gt;太字で、前に棒が付いているパターンがエディターで開いています。キーは強調表示されたパターンに作用します。&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Filter: name, tag (Ctrl+F)</source>
        <translation>絞り込み: 名前、タグ (Ctrl+F)</translation>
    </message>
</context>
<context>
    <name>teleta::pattern::StrokePad</name>
    <message>
        <source>Unrolled forearm</source>
        <translation>展開した前腕</translation>
    </message>
    <message>
        <source>Draw a stroke: it is felt as a point that moves along it</source>
        <translation>ストロークを描きます: それに沿って動く点として感じられます</translation>
    </message>
    <message>
        <source>Draw a stroke here</source>
        <translation>ここにストロークを描いてください</translation>
    </message>
    <message>
        <source>&lt;p&gt;The unrolled forearm: from left to right once around it. Draw with the mouse to add a stroke that starts at the playhead and moves as fast as you draw. &lt;b&gt;Esc&lt;/b&gt; cancels it.&lt;/p&gt;&lt;p&gt;With keys: the arrows move a cursor, &lt;b&gt;Space&lt;/b&gt; adds a point a quarter of a second after the last one, &lt;b&gt;Backspace&lt;/b&gt; removes it, &lt;b&gt;Enter&lt;/b&gt; finishes.&lt;/p&gt;</source>
        <translation>&lt;p&gt;展開した前腕です。左から右へ腕を1周します。ここにマウスで描いたものは、再生ヘッドの位置から、描いた速さでパターンのストロークになります。&lt;b&gt;Esc&lt;/b&gt;で取りやめます。&lt;/p&gt;&lt;p&gt;キー操作: 矢印キーでカーソルを移動し、&lt;b&gt;Space&lt;/b&gt;で直前の点の1/4秒後に点を置き、&lt;b&gt;Backspace&lt;/b&gt;で取り消し、&lt;b&gt;Enter&lt;/b&gt;で完了します。&lt;/p&gt;</translation>
    </message>
</context>
<context>
    <name>teleta::pattern::TimelineView</name>
    <message>
        <source>Time in s; intensity in %</source>
        <translation>時間 (s)、強度 (%)</translation>
    </message>
    <message>
        <source>Timeline of the pattern</source>
        <translation>パターンのタイムライン</translation>
    </message>
    <message>
        <source>Visible time</source>
        <translation>表示時間</translation>
    </message>
    <message>
        <source>pattern</source>
        <translation>パターン</translation>
    </message>
    <message>
        <source>&amp;Type numbers…</source>
        <translation>数値を入力(&amp;T)…</translation>
    </message>
    <message>
        <source>Add &amp;breakpoint here</source>
        <translation>ここにブレークポイントを追加(&amp;B)</translation>
    </message>
    <message>
        <source>&amp;Zoom to fit</source>
        <translation>全体を表示(&amp;Z)</translation>
    </message>
    <message>
        <source>Clear &amp;loop</source>
        <translation>ループを解除(&amp;L)</translation>
    </message>
    <message>
        <source>&lt;p&gt;Six motors over time. The blue line is the commanded intensity of a motor, the thin one its predicted response; hatching shows where the motor cannot follow.&lt;/p&gt;&lt;p&gt;Double-click or &lt;b&gt;P&lt;/b&gt;: add breakpoints. Drag: move, with &lt;b&gt;Alt&lt;/b&gt; without the grid. Drag on the background, or with &lt;b&gt;Shift&lt;/b&gt;: select. Double-click on a breakpoint or &lt;b&gt;Enter&lt;/b&gt;: type its numbers. Arrow keys: move what is selected, with &lt;b&gt;Shift&lt;/b&gt; farther in time and finer in intensity. &lt;b&gt;Page Up&lt;/b&gt;, &lt;b&gt;Page Down&lt;/b&gt;: lane; &lt;b&gt;,&lt;/b&gt; and &lt;b&gt;.&lt;/b&gt;: breakpoint, with &lt;b&gt;Shift&lt;/b&gt; one more; &lt;b&gt;N&lt;/b&gt;: object; &lt;b&gt;Insert&lt;/b&gt;: a breakpoint at the playhead; &lt;b&gt;[&lt;/b&gt; and &lt;b&gt;]&lt;/b&gt;: begin and end of the loop, &lt;b&gt;\&lt;/b&gt;: none.&lt;/p&gt;&lt;p&gt;&lt;b&gt;Ctrl&lt;/b&gt; and wheel: zoom. &lt;b&gt;Shift&lt;/b&gt; and wheel: scroll. On the ruler a drag moves the playhead and, with &lt;b&gt;Shift&lt;/b&gt;, sets the loop.&lt;/p&gt;</source>
        <translation>&lt;p&gt;6個のモーターの時間変化です。青い線はモーターへの指令、細い線はモーターの予測動作です。モーターが追従できない部分は斜線で示します。&lt;/p&gt;&lt;p&gt;ダブルクリックまたは&lt;b&gt;P&lt;/b&gt;: ブレークポイントを追加。ドラッグ: 移動、&lt;b&gt;Alt&lt;/b&gt;併用でグリッドから外す。背景のドラッグ、または&lt;b&gt;Shift&lt;/b&gt;+ドラッグ: 選択。ブレークポイントのダブルクリックまたは&lt;b&gt;Enter&lt;/b&gt;: 数値を入力。矢印キー: 選択したものを移動、&lt;b&gt;Shift&lt;/b&gt;併用で時間は大きく、強度は細かく移動。&lt;b&gt;Page Up&lt;/b&gt;、&lt;b&gt;Page Down&lt;/b&gt;: レーン。&lt;b&gt;,&lt;/b&gt;と&lt;b&gt;.&lt;/b&gt;: ブレークポイント、&lt;b&gt;Shift&lt;/b&gt;併用で追加選択。&lt;b&gt;N&lt;/b&gt;: オブジェクト。&lt;b&gt;Insert&lt;/b&gt;: 再生ヘッドにブレークポイントを追加。&lt;b&gt;[&lt;/b&gt;と&lt;b&gt;]&lt;/b&gt;: ループの先頭と末尾、&lt;b&gt;\&lt;/b&gt;: ループなし。&lt;/p&gt;&lt;p&gt;&lt;b&gt;Ctrl&lt;/b&gt;+ホイール: 拡大・縮小。&lt;b&gt;Shift&lt;/b&gt;+ホイール: スクロール。ルーラー上のドラッグで再生ヘッドを動かし、&lt;b&gt;Shift&lt;/b&gt;併用でループを設定します。&lt;/p&gt;</translation>
    </message>
</context>
<context>
    <name>teleta::servo::ForceStrip</name>
    <message>
        <source>Force over time</source>
        <translation>力の時間変化</translation>
    </message>
    <message>
        <source>actual</source>
        <translation>実際</translation>
    </message>
    <message>
        <source>desired</source>
        <translation>目標</translation>
    </message>
    <message>
        <source>Measured force (line) and desired force (dashes) over the last 20 s</source>
        <translation>アレイが読み取る力 (実線) と目標の力 (破線)、直近20 s</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>力</translation>
    </message>
</context>
<context>
    <name>teleta::servo::ServoPanel</name>
    <message>
        <source>No servo</source>
        <translation>サーボなし</translation>
    </message>
    <message>
        <source>No limit acts.</source>
        <translation>作用中の制限はありません。</translation>
    </message>
    <message>
        <source>Limits that act: %1</source>
        <translation>作用中の制限: %1</translation>
    </message>
    <message>
        <source>%1. %2</source>
        <comment>number and name of a task</comment>
        <translation>%1. %2</translation>
    </message>
    <message>
        <source>&amp;Task</source>
        <translation>課題(&amp;T)</translation>
    </message>
    <message>
        <source>Force with which the array presses</source>
        <translation>アレイが押す力</translation>
    </message>
    <message>
        <source>&amp;Sliding speed</source>
        <translation>滑り速度(&amp;S)</translation>
    </message>
    <message>
        <source>Along the edge, while it is explored</source>
        <translation>探索中のエッジに沿った速度</translation>
    </message>
    <message>
        <source>&amp;Gains</source>
        <translation>ゲイン(&amp;G)</translation>
    </message>
    <message>
        <source>Balance the &amp;moment (DZMP)</source>
        <translation>モーメントの釣り合い (DZMP)(&amp;M)</translation>
    </message>
    <message>
        <source>Off: the controller without the distance to the zero-moment point</source>
        <translation>オフ: ゼロモーメント点までの距離を使わない制御器</translation>
    </message>
    <message>
        <source>The scene is held</source>
        <translation>シーンは保持されています</translation>
    </message>
    <message>
        <source>The running task; choose one to start it now</source>
        <translation>実行中の課題。別の課題を選ぶと直ちに開始します</translation>
    </message>
    <message>
        <source>All controller gains, in percent of those in the scene</source>
        <translation>調節器の全ゲイン (シーンの値に対する%)</translation>
    </message>
    <message>
        <source>So far: %1</source>
        <translation>現在まで: %1</translation>
    </message>
    <message>
        <source>Last run: %1</source>
        <translation>前回の実行: %1</translation>
    </message>
    <message>
        <source>force %1</source>
        <comment>as planned</comment>
        <translation>力 %1</translation>
    </message>
    <message>
        <source>sliding speed %1</source>
        <comment>as planned</comment>
        <translation>滑り速度 %1</translation>
    </message>
    <message>
        <source>gains %1</source>
        <comment>as planned</comment>
        <translation>ゲイン %1</translation>
    </message>
    <message>
        <source>moment balanced</source>
        <translation>モーメントの釣り合いあり</translation>
    </message>
    <message>
        <source>moment not balanced</source>
        <translation>モーメントの釣り合いなし</translation>
    </message>
    <message>
        <source>Changed from the scene, and kept after a restart. The scene has: %1.</source>
        <translation>変更済みです。再開後も有効です。シーンの値: %1。</translation>
    </message>
    <message>
        <source>Reset to the scene</source>
        <translation>シーンの設定</translation>
    </message>
    <message>
        <source>Set force, speed, gains and moment back to the values of the scene</source>
        <translation>力・速度・ゲイン・モーメントの変更をすべて元に戻します</translation>
    </message>
    <message>
        <source>Matrices</source>
        <translation>行列</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>実行</translation>
    </message>
    <message>
        <source>Let the scene go on (F5)</source>
        <translation>シーンを続行します（F5）</translation>
    </message>
    <message>
        <source>Hold</source>
        <translation>保持</translation>
    </message>
    <message>
        <source>Hold the scene where it is (Shift+F5)</source>
        <translation>シーンをその状態で保持します（Shift+F5）</translation>
    </message>
    <message>
        <source>Restart</source>
        <translation>再開始</translation>
    </message>
    <message>
        <source>Start the scene again (Ctrl+F5)</source>
        <translation>シーンを最初から始めます（Ctrl+F5）</translation>
    </message>
    <message>
        <source>F&amp;orce</source>
        <translation>力(&amp;O)</translation>
    </message>
    <message>
        <source>as planned</source>
        <translation>予定どおり</translation>
    </message>
    <message>
        <source>STOP: the arm is held</source>
        <translation>STOP: アームは保持されています</translation>
    </message>
    <message>
        <source>The arm keeps the pose that it had. It no longer presses beyond it: the force falls to what pushes against the arm.</source>
        <translation>アームは直前の姿勢を保ちます。それ以上は押さないため、力はアームを押し返す分まで下がります。</translation>
    </message>
</context>
<context>
    <name>teleta::servo::ServoPicture</name>
    <message>
        <source>Features and matrices of the servo</source>
        <translation>サーボの特徴量と行列</translation>
    </message>
    <message>
        <source>Desired and actual features as the inverse tactile Jacobian selects them; bold rows act on the motion through the projection matrix P.</source>
        <translation>触覚ヤコビ行列の逆行列で選択された目標特徴量と実際の特徴量。太字の行は射影行列Pを通して運動に作用します。</translation>
    </message>
    <message>
        <source>Feature</source>
        <translation>特徴量</translation>
    </message>
    <message>
        <source>Desired</source>
        <translation>目標</translation>
    </message>
    <message>
        <source>Actual</source>
        <translation>実際</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>誤差</translation>
    </message>
    <message>
        <source>J⁻¹, features</source>
        <translation>J⁻¹、特徴量</translation>
    </message>
    <message>
        <source>P, motions</source>
        <translation>P、運動</translation>
    </message>
</context>
<context>
    <name>teleta::servo::ServoRunsView</name>
    <message>
        <source>&amp;Picture</source>
        <translation>図(&amp;P)</translation>
    </message>
    <message>
        <source>Copies or saves the chart or its data</source>
        <translation>チャートまたはそのデータをコピー・保存します</translation>
    </message>
    <message>
        <source>Servo runs</source>
        <translation>サーボ実行</translation>
    </message>
    <message>
        <source>Servo runs (servo.csv)</source>
        <translation>サーボ実行 (servo.csv)</translation>
    </message>
    <message>
        <source>Comma-separated values (*.csv)</source>
        <translation>コンマ区切り値 (*.csv)</translation>
    </message>
    <message>
        <source>servo-runs</source>
        <comment>name of a file</comment>
        <translation>サーボ実行</translation>
    </message>
    <message>
        <source>Add recorded run</source>
        <translation>記録した実行を追加</translation>
    </message>
    <message>
        <source>A run written by teleta simulate --out: its servo.csv</source>
        <translation>teleta simulate --outが書き込んだ実行のservo.csv</translation>
    </message>
    <message>
        <source>Keeps only the current run</source>
        <translation>進行中の実行だけを残します</translation>
    </message>
    <message>
        <source>&lt;p&gt;Servo runs in one chart: the current one, earlier ones from before a restart or a change of the source, and recorded ones.&lt;/p&gt;&lt;p&gt;To see the effect of the moment, restart the scene with and without “Balance the moment”.&lt;/p&gt;</source>
        <translation>&lt;p&gt;サーボ実行を1つのチャートに表示します: 進行中の実行、ソースの再起動や別のソースの表示より前の実行、記録した実行です。&lt;/p&gt;&lt;p&gt;モーメントの効果を見るには、「モーメントの釣り合い」をオンとオフにしてシーンを再起動してください。&lt;/p&gt;</translation>
    </message>
    <message>
        <source>No runs yet. Servo runs are drawn here on top of each other.</source>
        <translation>実行はまだありません。サーボの実行がここに重ねて描かれます。</translation>
    </message>
    <message>
        <source>A&amp;dd recorded run…</source>
        <translation>記録した実行を追加(&amp;D)…</translation>
    </message>
    <message>
        <source>Forget &amp;other runs</source>
        <translation>ほかの実行を破棄(&amp;O)</translation>
    </message>
</context>
<context>
    <name>teleta::signal::SignalPlot</name>
    <message>
        <source>units</source>
        <translation>単位</translation>
    </message>
    <message>
        <source>power density ((%1)²/Hz)</source>
        <translation>パワー密度 ((%1)²/Hz)</translation>
    </message>
    <message>
        <source>amplitude</source>
        <translation>振幅</translation>
    </message>
    <message>
        <source>amplitude (%1)</source>
        <translation>振幅 (%1)</translation>
    </message>
    <message>
        <source>Signals over time</source>
        <translation>信号の時間変化</translation>
    </message>
    <message>
        <source>plot</source>
        <comment>name of a file</comment>
        <translation>plot</translation>
    </message>
    <message>
        <source>frequency</source>
        <translation>周波数</translation>
    </message>
    <message>
        <source>clock time</source>
        <translation>時計の時刻</translation>
    </message>
    <message>
        <source>time since the start of each source</source>
        <translation>各ソースの開始からの時間</translation>
    </message>
</context>
<context>
    <name>teleta::signal::SignalTable</name>
    <message>
        <source>Plotted signals with their values</source>
        <translation>プロットした信号とその値</translation>
    </message>
    <message>
        <source>Add its &amp;derivative</source>
        <translation>微分を追加(&amp;D)</translation>
    </message>
    <message>
        <source>Show its &amp;spectrum</source>
        <translation>スペクトルを表示(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>取り除く(&amp;R)</translation>
    </message>
    <message>
        <source>Plotted signal</source>
        <translation>プロットした信号</translation>
    </message>
    <message>
        <source>at A</source>
        <translation>A の値</translation>
    </message>
    <message>
        <source>Newest</source>
        <translation>最新</translation>
    </message>
    <message>
        <source>at B</source>
        <translation>B の値</translation>
    </message>
    <message>
        <source>B − A</source>
        <comment>difference of two values</comment>
        <translation>B − A</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>単位</translation>
    </message>
    <message>
        <source>B − A: %1, 1/(B − A): %2</source>
        <translation>B − A: %1、1/(B − A): %2</translation>
    </message>
</context>
<context>
    <name>teleta::signal::SignalTree</name>
    <message>
        <source>Search signals</source>
        <translation>信号を検索</translation>
    </message>
    <message>
        <source>Signals of all sources</source>
        <translation>すべてのソースの信号</translation>
    </message>
    <message>
        <source>Signal</source>
        <translation>信号</translation>
    </message>
    <message>
        <source>Newest value</source>
        <translation>最新の値</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <comment>signal, unit</comment>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Search signals (Ctrl+F)</source>
        <translation>信号を検索 (Ctrl+F)</translation>
    </message>
</context>
<context>
    <name>teleta::site_view::SiteBar</name>
    <message>
        <source>%1 does not answer (%2 s)</source>
        <translation>%1 が応答しません（%2 秒）</translation>
    </message>
    <message>
        <source>%1: STOP is held by %2</source>
        <translation>%1：STOP は %2 が保持</translation>
    </message>
    <message>
        <source>%1: %2 offers you control</source>
        <translation>%1：%2 が操作権を渡そうとしています</translation>
    </message>
    <message>
        <source>%1: handing control to %2</source>
        <translation>%1：操作権を %2 に渡しています</translation>
    </message>
    <message>
        <source>%1: an arm has a fault</source>
        <translation>%1：アームに異常</translation>
    </message>
    <message>
        <source>%1: you are moving it</source>
        <translation>%1：操作中</translation>
    </message>
    <message>
        <source>%1: you control</source>
        <translation>%1：あなたに操作権</translation>
    </message>
    <message>
        <source>%1: %2 controls</source>
        <translation>%1：%2 が操作</translation>
    </message>
    <message>
        <source>%1: viewing</source>
        <translation>%1：閲覧中</translation>
    </message>
    <message>
        <source>%1: nobody controls</source>
        <translation>%1：操作者なし</translation>
    </message>
    <message>
        <source>loop %1 ms</source>
        <translation>往復 %1 ms</translation>
    </message>
    <message>
        <source>clock ±%1 ms</source>
        <translation>時計 ±%1 ms</translation>
    </message>
    <message>
        <source>%1 refused: %2</source>
        <translation>拒否 %1 件：%2</translation>
    </message>
    <message numerus="yes">
        <source>%n state(s) of the site were lost on the way</source>
        <translation>
            <numerusform>サイトの状態が途中で %n 件失われました</numerusform>
        </translation>
    </message>
    <message>
        <source>Control lease: how long control stays here without an answer</source>
        <translation>操作権の期限：応答なしで操作権が残る時間</translation>
    </message>
    <message>
        <source>Request control</source>
        <translation>操作権を要求</translation>
    </message>
    <message>
        <source>Accept control</source>
        <translation>操作権を受け取る</translation>
    </message>
    <message>
        <source>Agree</source>
        <translation>同意</translation>
    </message>
    <message>
        <source>Decline</source>
        <translation>断る</translation>
    </message>
    <message>
        <source>Keep control</source>
        <translation>操作権を保つ</translation>
    </message>
    <message>
        <source>Take over…</source>
        <translation>引き継ぐ…</translation>
    </message>
    <message>
        <source>For supervisors: the other console has 5 s to decline</source>
        <translation>監督者用：相手のコンソールは 5 秒以内に断れます</translation>
    </message>
    <message>
        <source>Clear the fault</source>
        <translation>異常を解除</translation>
    </message>
    <message>
        <source>Hand over</source>
        <translation>渡す</translation>
    </message>
    <message>
        <source>Withdraw STOP</source>
        <translation>STOP を解除</translation>
    </message>
    <message>
        <source>For supervisors, once the console that engaged STOP is gone</source>
        <translation>監督者用：STOP を作動させたコンソールがなくなったとき</translation>
    </message>
    <message>
        <source>Release control</source>
        <translation>操作権を手放す</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <comment>a console and who sits there</comment>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>In control: %1</source>
        <translation>操作中：%1</translation>
    </message>
    <message>
        <source>Viewers: %1</source>
        <translation>閲覧者：%1</translation>
    </message>
    <message>
        <source>Loop: median %1 ms, 99 %: %2 ms</source>
        <translation>往復：中央値 %1 ms、99 %：%2 ms</translation>
    </message>
    <message>
        <source>Clock offset: %1 s ± %2 ms</source>
        <translation>時計のずれ：%1 s ± %2 ms</translation>
    </message>
    <message>
        <source>Refused: %1 (%2)</source>
        <comment>a reason and how often</comment>
        <translation>拒否：%1 (%2)</translation>
    </message>
    <message>
        <source>Reason (if you decline)</source>
        <translation>理由 (断る場合)</translation>
    </message>
    <message>
        <source>Reason for declining</source>
        <translation>断る理由</translation>
    </message>
    <message>
        <source>The other console shows it</source>
        <translation>相手のコンソールに表示されます</translation>
    </message>
    <message>
        <source>Lost on the way, %1: %2</source>
        <translation>途中での損失、%1：%2</translation>
    </message>
</context>
<context>
    <name>teleta::study::AnswerButton</name>
    <message>
        <source>Answer %1: %2</source>
        <comment>letter, name</comment>
        <translation>回答 %1: %2</translation>
    </message>
    <message>
        <source>%1. This was felt.</source>
        <translation>%1。これが提示されました。</translation>
    </message>
    <message>
        <source>%1. This was answered.</source>
        <translation>%1。これが回答されました。</translation>
    </message>
    <message>
        <source>✓ felt</source>
        <translation>✓ 正解</translation>
    </message>
    <message>
        <source>✗ your answer</source>
        <translation>✗ あなたの回答</translation>
    </message>
    <message>
        <source>your answer</source>
        <translation>あなたの回答</translation>
    </message>
    <message>
        <source>Answer: %1</source>
        <comment>yes, no, a number ..</comment>
        <translation>回答: %1</translation>
    </message>
    <message>
        <source>%1. This was right.</source>
        <translation>%1。これが正解でした。</translation>
    </message>
    <message>
        <source>✓ right</source>
        <translation>✓ 正解</translation>
    </message>
</context>
<context>
    <name>teleta::study::BraceletView</name>
    <message>
        <source>All participants, mean</source>
        <translation>全参加者の平均</translation>
    </message>
    <message>
        <source>Connect the bracelet with which the study was run: the balance needs its motors.</source>
        <translation>実験に使ったブレスレットを接続してください。釣り合わせにはそのモーターが必要です。</translation>
    </message>
    <message>
        <source>The balance takes the motors of %1 as they are now. They must be the ones that the study was run with.</source>
        <translation>釣り合わせには%1の現在のモーターを使います。実験に使ったものでなければなりません。</translation>
    </message>
    <message>
        <source>There is no balance: %1.</source>
        <translation>釣り合わせはできません: %1。</translation>
    </message>
    <message>
        <source>Best time from burst to burst</source>
        <translation>バースト間の最良の時間</translation>
    </message>
    <message>
        <source>Intensities that can be told apart</source>
        <translation>区別できる強度</translation>
    </message>
    <message>
        <source>Equally strong tactors</source>
        <translation>等しい強さのタクタ</translation>
    </message>
    <message>
        <source>As felt b&amp;y</source>
        <translation>感じた人(&amp;Y)</translation>
    </message>
    <message>
        <source>&amp;Use for this bracelet…</source>
        <translation>このブレスレットに使う(&amp;U)…</translation>
    </message>
    <message>
        <source>Sets the full drives of the connected bracelet, after a question</source>
        <translation>確認のうえ、接続中のブレスレットの最大駆動量を設定します</translation>
    </message>
    <message>
        <source>The participants are simulated: nobody felt this, so it cannot be used for a real bracelet.</source>
        <translation>参加者はシミュレーションです。誰も感じていないため、実際のブレスレットには使えません。</translation>
    </message>
</context>
<context>
    <name>teleta::study::ComparisonsView</name>
    <message>
        <source>Pairs of levels</source>
        <translation>水準のペア</translation>
    </message>
    <message>
        <source>Paired t tests. p Holm is corrected over all pairs of an effect; intervals are not corrected.</source>
        <translation>対応のあるt検定。p Holmは効果の全ペアにわたる補正済みの値です。区間は補正されていません。</translation>
    </message>
    <message>
        <source>Effect sizes, and effects by ranks</source>
        <translation>効果量、および順位による効果</translation>
    </message>
    <message>
        <source>The same pairs by ranks</source>
        <translation>同じペアの順位による比較</translation>
    </message>
    <message>
        <source>Model of single answers</source>
        <translation>個々の回答のモデル</translation>
    </message>
    <message>
        <source>Response times of the conditions</source>
        <translation>各条件の応答時間</translation>
    </message>
    <message>
        <source>Exclusions</source>
        <translation>除外</translation>
    </message>
    <message>
        <source>Nothing was deleted: the trials are in the study and in its exports, with the rule that left them out.</source>
        <translation>何も削除されていません: これらの試行は、除外の理由となった規則とともに実験とそのエクスポートに残っています。</translation>
    </message>
    <message>
        <source>With the rules, and without them</source>
        <translation>規則を適用した場合と適用しない場合</translation>
    </message>
</context>
<context>
    <name>teleta::study::ConfusionView</name>
    <message>
        <source>Confusion matrix</source>
        <translation>混同行列</translation>
    </message>
    <message>
        <source>%1 of %2 right</source>
        <translation>正答 %1/%2</translation>
    </message>
    <message>
        <source>No trials yet</source>
        <translation>試行はまだありません</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <comment>count of a row</comment>
        <translation>%1/%2</translation>
    </message>
    <message>
        <source>%1 not answered in time: </source>
        <comment>pattern</comment>
        <translation>%1に時間内の回答なし: </translation>
    </message>
    <message>
        <source>%1 answered as %2: </source>
        <comment>pattern, pattern</comment>
        <translation>%1を%2と回答: </translation>
    </message>
    <message>
        <source>In &amp;percent</source>
        <translation>割合で表示(&amp;P)</translation>
    </message>
    <message>
        <source>&lt;p&gt;Rows: what was presented. Columns: what was answered, and NONE for no answer in time. &lt;b&gt;Space&lt;/b&gt; or a double click switches between counts and percent of the row.&lt;/p&gt;</source>
        <translation>&lt;p&gt;行: 提示。列: 回答。NONEは時間内に回答がなかったものです。&lt;b&gt;Space&lt;/b&gt;またはダブルクリックで、度数と行に対する割合を切り替えます。&lt;/p&gt;</translation>
    </message>
</context>
<context>
    <name>teleta::study::ParticipantPicker</name>
    <message numerus="yes">
        <source>%n participant(s)</source>
        <translation>
            <numerusform>参加者%n名</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>teleta::study::ParticipantWindow</name>
    <message>
        <source>Please wait for the experimenter.</source>
        <translation>実験者をお待ちください。</translation>
    </message>
    <message>
        <source>Press Space for the next trial.</source>
        <translation>Spaceキーを押すと次の試行に進みます。</translation>
    </message>
    <message>
        <source>Press Space for the first trial.</source>
        <translation>Spaceキーを押すと最初の試行に進みます。</translation>
    </message>
    <message>
        <source>Wait …</source>
        <translation>お待ちください…</translation>
    </message>
    <message>
        <source>Feel …</source>
        <translation>感じてください…</translation>
    </message>
    <message>
        <source>Which pattern do you feel? Press R to feel it again.</source>
        <translation>どのパターンを感じますか? もう一度感じるにはRキーを押してください。</translation>
    </message>
    <message>
        <source>Which pattern do you feel?</source>
        <translation>どのパターンを感じますか?</translation>
    </message>
    <message>
        <source>Pause. Please wait for the experimenter.</source>
        <translation>休憩です。実験者をお待ちください。</translation>
    </message>
    <message>
        <source>Stopped. The bracelet is off. Please wait for the experimenter.</source>
        <translation>停止しました。ブレスレットはオフです。実験者をお待ちください。</translation>
    </message>
    <message>
        <source>This part is finished. Thank you!</source>
        <translation>この部分は終了です。ありがとうございました!</translation>
    </message>
    <message>
        <source>Participant</source>
        <translation>参加者</translation>
    </message>
    <message>
        <source>Practice</source>
        <translation>練習</translation>
    </message>
    <message>
        <source>Test</source>
        <translation>テスト</translation>
    </message>
    <message>
        <source>%1 — %2, trial %3 of %4</source>
        <comment>task, phase, numbers</comment>
        <translation>%1 — %2、試行%3/%4</translation>
    </message>
    <message>
        <source>There was no answer in time. The marked pattern was the right one. Press Space to continue.</source>
        <translation>時間内に回答がありませんでした。印の付いたパターンが提示されました。Spaceキーを押すと続行します。</translation>
    </message>
    <message>
        <source>Right. Press Space to continue.</source>
        <translation>正解です。Spaceキーを押すと続行します。</translation>
    </message>
    <message>
        <source>That was another one: the pattern marked with ✓ was the right one. Press Space to continue.</source>
        <translation>別のパターンでした: ✓の付いたパターンが提示されました。Spaceキーを押すと続行します。</translation>
    </message>
    <message>
        <source>Take a break. You can continue in %1 s.</source>
        <translation>休憩してください。%1 秒後に続けられます。</translation>
    </message>
    <message>
        <source>Take a break. Press Space when you would like to continue.</source>
        <translation>休憩してください。続けるときはスペースキーを押してください。</translation>
    </message>
    <message>
        <source>%1 Press R to feel it again.</source>
        <comment>a question</comment>
        <translation>%1 もう一度感じるにはRキーを押してください。</translation>
    </message>
    <message>
        <source>There was no answer in time. The marked answer was the right one. Press Space to continue.</source>
        <translation>時間内に回答がありませんでした。印の付いた答えが正解でした。Spaceキーを押すと続行します。</translation>
    </message>
    <message>
        <source>The answer marked with ✓ was the right one. Press Space to continue.</source>
        <translation>✓の付いた答えが正解でした。Spaceキーを押すと続行します。</translation>
    </message>
    <message>
        <source>The session has ended. Please wait for the experimenter.</source>
        <translation>セッションは終了しました。実験者をお待ちください。</translation>
    </message>
</context>
<context>
    <name>teleta::study::PlanPanel</name>
    <message>
        <source>Right answers, %1</source>
        <comment>condition</comment>
        <translation>正答、%1</translation>
    </message>
    <message>
        <source>The middle participant has these shares; the spreads are in logits.</source>
        <translation>中央の参加者がこれらの割合を示します。ばらつきの単位はロジットです。</translation>
    </message>
    <message>
        <source>Assumed: what %1 says.</source>
        <translation>仮定: %1 の内容。</translation>
    </message>
    <message>
        <source>&amp;Test</source>
        <translation>検定(&amp;T)</translation>
    </message>
    <message>
        <source>Spread of &amp;participants</source>
        <translation>参加者間のばらつき(&amp;P)</translation>
    </message>
    <message>
        <source>Spread under one &amp;condition</source>
        <translation>1条件内のばらつき(&amp;C)</translation>
    </message>
    <message>
        <source>From this st&amp;udy</source>
        <translation>この実験から(&amp;U)</translation>
    </message>
    <message>
        <source>Assumes what the results of this study show; at least 5 participants</source>
        <translation>この実験の結果が示す値を仮定します。参加者5名以上</translation>
    </message>
    <message>
        <source>From this f&amp;orm</source>
        <translation>このフォームから(&amp;O)</translation>
    </message>
    <message>
        <source>Part&amp;icipants</source>
        <translation>参加者数(&amp;I)</translation>
    </message>
    <message>
        <source>from </source>
        <comment>number of participants</comment>
        <translation>最小 </translation>
    </message>
    <message>
        <source>to </source>
        <comment>number of participants</comment>
        <translation>最大 </translation>
    </message>
    <message>
        <source>step </source>
        <comment>of the number of participants</comment>
        <translation>刻み </translation>
    </message>
    <message>
        <source>Target po&amp;wer</source>
        <translation>目標検定力(&amp;W)</translation>
    </message>
    <message>
        <source>&amp;Studies drawn</source>
        <translation>抽出する実験数(&amp;S)</translation>
    </message>
    <message>
        <source>P&amp;lan</source>
        <translation>計画(&amp;L)</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>キャンセル</translation>
    </message>
    <message>
        <source>Power over the number of participants</source>
        <translation>参加者数に対する検定力</translation>
    </message>
    <message>
        <source>The power over the number of participants will be shown here.
Enter what you assume on the left, and choose Plan.</source>
        <translation>参加者数に対する検出力がここに表示されます。
左に仮定を入力し、「計画」を選んでください。</translation>
    </message>
    <message>
        <source>There is nothing to plan.</source>
        <translation>計画するものがありません。</translation>
    </message>
    <message>
        <source>The middle participant has this threshold.</source>
        <translation>中央の参加者がこの閾値を持ちます。</translation>
    </message>
    <message>
        <source>The protocol has no task to plan for.</source>
        <translation>プロトコルに計画できる課題がありません。</translation>
    </message>
    <message>
        <source>A TOML file with shares of right answers or thresholds, and spreads</source>
        <translation>正答率または閾値と、ばらつきを書いたTOMLファイル</translation>
    </message>
    <message>
        <source>Targ&amp;et</source>
        <translation>目標(&amp;E)</translation>
    </message>
    <message>
        <source>The share of studies with an interval narrow enough will be shown here.
Enter what you assume on the left, and choose Plan.</source>
        <translation>区間が十分に狭い実験の割合がここに表示されます。
左に仮定を入力し、「計画」を選んでください。</translation>
    </message>
    <message>
        <source>Fro&amp;m a file…</source>
        <translation>ファイルから(&amp;M)…</translation>
    </message>
</context>
<context>
    <name>teleta::study::QuestionnaireForm</name>
    <message>
        <source>Please answer this question.</source>
        <translation>この質問に回答してください。</translation>
    </message>
    <message>
        <source>%1 of %2 answered</source>
        <translation>%2問中%1問回答済み</translation>
    </message>
    <message>
        <source>&amp;Done</source>
        <translation>完了(&amp;D)</translation>
    </message>
    <message>
        <source>This answer is not valid: %1.</source>
        <comment>what is expected</comment>
        <translation>入力が適切ではありません: %1。</translation>
    </message>
    <message>
        <source>Submits the answers (Ctrl+Return)</source>
        <translation>回答を提出します (Ctrl+Return)</translation>
    </message>
</context>
<context>
    <name>teleta::study::QuestionnaireItemView</name>
    <message>
        <source>No answer</source>
        <translation>無回答</translation>
    </message>
    <message>
        <source>%1: %2 of %3</source>
        <comment>question, point, points</comment>
        <translation>%1: %2/%3</translation>
    </message>
    <message>
        <source>%1 (optional)</source>
        <comment>a question</comment>
        <translation>%1 (省略可)</translation>
    </message>
</context>
<context>
    <name>teleta::study::ResultsView</name>
    <message>
        <source>All participants</source>
        <translation>全参加者</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <comment>condition, participant</comment>
        <translation>%1、%2</translation>
    </message>
    <message>
        <source>Task</source>
        <translation>課題</translation>
    </message>
    <message>
        <source>Tick one participant, or a group</source>
        <translation>1名または複数の参加者にチェックを入れてください</translation>
    </message>
    <message>
        <source>What the matrices show</source>
        <translation>行列の表示内容</translation>
    </message>
    <message>
        <source>Counts</source>
        <translation>度数</translation>
    </message>
    <message>
        <source>Percent of the row</source>
        <translation>行に対する割合</translation>
    </message>
    <message>
        <source>All participants together</source>
        <translation>全参加者の合計</translation>
    </message>
    <message>
        <source>Analysis of variance</source>
        <translation>分散分析</translation>
    </message>
    <message>
        <source>Each participant</source>
        <translation>参加者別</translation>
    </message>
    <message>
        <source>&amp;Export</source>
        <translation>エクスポート(&amp;E)</translation>
    </message>
    <message>
        <source>Writes the trials, or these results, into the folder of the study</source>
        <translation>試行またはこれらの結果を実験のフォルダーに書き込みます</translation>
    </message>
    <message>
        <source>Trials as &amp;Psych-DS (CSV)</source>
        <translation>試行をPsych-DS (CSV) で(&amp;P)</translation>
    </message>
    <message>
        <source>Trials as &amp;BIDS (TSV)</source>
        <translation>試行をBIDS (TSV) で(&amp;B)</translation>
    </message>
    <message>
        <source>Trials for a &amp;spreadsheet</source>
        <translation>試行を表計算ソフト用に(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Results: tables, figures, R script</source>
        <translation>結果: 表、図、Rスクリプト(&amp;R)</translation>
    </message>
    <message>
        <source>No comparison</source>
        <translation>比較なし</translation>
    </message>
    <message>
        <source>Participants shown</source>
        <translation>表示する参加者</translation>
    </message>
    <message>
        <source>Participants for comparison</source>
        <translation>比較する参加者</translation>
    </message>
    <message>
        <source>Tick the participants to compare with: a second group, side by side</source>
        <translation>比較したい参加者にチェックを入れてください: 第2のグループとして並べて表示します</translation>
    </message>
    <message>
        <source>Comparisons</source>
        <translation>比較</translation>
    </message>
    <message>
        <source>Answers</source>
        <translation>回答</translation>
    </message>
    <message>
        <source>Thresholds</source>
        <translation>しきい値</translation>
    </message>
    <message>
        <source>Tracks</source>
        <translation>トラック</translation>
    </message>
    <message>
        <source>d&apos; and c</source>
        <translation>d&apos;とc</translation>
    </message>
    <message>
        <source>Whose threshold is shown</source>
        <translation>しきい値を表示する対象</translation>
    </message>
    <message>
        <source>Which track is shown</source>
        <translation>表示するトラック</translation>
    </message>
    <message>
        <source>Which condition is shown</source>
        <translation>表示する条件</translation>
    </message>
    <message>
        <source>Bracelet</source>
        <translation>ブレスレット</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>letter of a pattern, its name</comment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>No results yet</source>
        <translation>結果はまだありません</translation>
    </message>
    <message>
        <source>Each task&apos;s confusion matrices, accuracy and response times appear here while test trials are completed.</source>
        <translation>本試行が完了するにつれて、各課題の混同行列、正答率、反応時間がここに表示されます。</translation>
    </message>
</context>
<context>
    <name>teleta::study::SessionPanel</name>
    <message>
        <source>Stop the noise</source>
        <translation>ノイズを停止</translation>
    </message>
    <message>
        <source>Play the noise</source>
        <translation>ノイズを再生</translation>
    </message>
    <message>
        <source>Abort the session?</source>
        <translation>セッションを中止しますか?</translation>
    </message>
    <message>
        <source>&amp;Abort the session</source>
        <translation>セッションを中止(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Go on</source>
        <translation>続行(&amp;G)</translation>
    </message>
    <message>
        <source>Next step</source>
        <translation>次のステップ</translation>
    </message>
    <message>
        <source>What to do next (Ctrl+Return)</source>
        <translation>次に行うこと (Ctrl+Return)</translation>
    </message>
    <message>
        <source>Checks before the run</source>
        <translation>実行前のチェック</translation>
    </message>
    <message>
        <source>Noise &amp;confirmed</source>
        <translation>ノイズを確認済み(&amp;C)</translation>
    </message>
    <message>
        <source>The participant hears the masking noise at the level of the protocol</source>
        <translation>参加者にはプロトコルのレベルでマスキングノイズが聞こえています</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>進捗</translation>
    </message>
    <message>
        <source>Last trials</source>
        <translation>最近の試行</translation>
    </message>
    <message>
        <source>Trial</source>
        <translation>試行</translation>
    </message>
    <message>
        <source>Presented</source>
        <translation>提示</translation>
    </message>
    <message>
        <source>Answered</source>
        <translation>回答</translation>
    </message>
    <message>
        <source>Outcome</source>
        <translation>結果</translation>
    </message>
    <message>
        <source>Response time</source>
        <translation>応答時間</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>メモ</translation>
    </message>
    <message>
        <source>Participant&apos;s &amp;window</source>
        <translation>参加者ウィンドウ(&amp;W)</translation>
    </message>
    <message>
        <source>&amp;Pause</source>
        <translation>一時停止(&amp;P)</translation>
    </message>
    <message>
        <source>The session ends here. All answers are saved, and it can be resumed later where it stopped.</source>
        <translation>セッションはここで終了します。回答は保存され、中断した箇所から後で続行できます。</translation>
    </message>
    <message>
        <source>Skip the questionnaire?</source>
        <translation>質問票を省略しますか?</translation>
    </message>
    <message>
        <source>What is filled in is lost, and a note says that it was skipped.</source>
        <translation>記入内容は失われ、省略したことが記録されます。</translation>
    </message>
    <message>
        <source>&amp;Skip it</source>
        <translation>省略する(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Continue with it</source>
        <translation>記入を続ける(&amp;G)</translation>
    </message>
    <message>
        <source>A note on this session; Return saves it</source>
        <translation>このセッションのメモ。Returnで保存します</translation>
    </message>
    <message>
        <source>Shows the participant&apos;s window, on the second screen if there is one</source>
        <translation>参加者ウィンドウを表示します (第2画面があればそこに表示)</translation>
    </message>
    <message>
        <source>S&amp;kip the questionnaire…</source>
        <translation>質問票を省略(&amp;L)…</translation>
    </message>
    <message>
        <source>Continues without the participant&apos;s answers</source>
        <translation>参加者の回答なしで続行します</translation>
    </message>
    <message>
        <source>Pauses after the current trial</source>
        <translation>現在の試行の後で一時停止します</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>レベル</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>時刻</translation>
    </message>
    <message>
        <source>Ab&amp;ort…</source>
        <translation>中止(&amp;O)…</translation>
    </message>
</context>
<context>
    <name>teleta::study::StudyPanel</name>
    <message>
        <source>● On the server: %1</source>
        <translation>● サーバー上: %1</translation>
    </message>
    <message>
        <source>✗ The study cannot be used: %1</source>
        <translation>✗ 実験を使用できません: %1</translation>
    </message>
    <message>
        <source>%1 of %2 trials</source>
        <comment>kept</comment>
        <translation>%1/%2試行</translation>
    </message>
    <message>
        <source>&amp;New…</source>
        <translation>新規(&amp;N)…</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>開く(&amp;O)…</translation>
    </message>
    <message>
        <source>Open another study</source>
        <translation>別の実験を開きます</translation>
    </message>
    <message>
        <source>The &amp;folder of a study…</source>
        <translation>実験のフォルダー(&amp;F)…</translation>
    </message>
    <message>
        <source>A study on a &amp;server…</source>
        <translation>サーバー上の実験(&amp;S)…</translation>
    </message>
    <message>
        <source>Pro&amp;tocol…</source>
        <translation>プロトコル(&amp;T)…</translation>
    </message>
    <message>
        <source>Participants</source>
        <translation>参加者</translation>
    </message>
    <message>
        <source>Session</source>
        <translation>セッション</translation>
    </message>
    <message>
        <source>State</source>
        <translation>状態</translation>
    </message>
    <message>
        <source>Participants and their sessions</source>
        <translation>参加者とそのセッション</translation>
    </message>
    <message>
        <source>Name of a new participant, for example P07</source>
        <translation>新しい参加者の名前。例: P07</translation>
    </message>
    <message>
        <source>Name of a new participant</source>
        <translation>新しい参加者の名前</translation>
    </message>
    <message>
        <source>A&amp;dd</source>
        <translation>追加(&amp;D)</translation>
    </message>
    <message>
        <source>Enrol this participant</source>
        <translation>この参加者を登録します</translation>
    </message>
    <message>
        <source>✗ Server unreachable: %1</source>
        <translation>✗ サーバーに接続できません: %1</translation>
    </message>
    <message>
        <source>Create a new study</source>
        <translation>新しい実験を始めます</translation>
    </message>
    <message>
        <source>View the protocol, or make another one from it</source>
        <translation>プロトコルを確認するか、それをもとに別のプロトコルを作ります</translation>
    </message>
    <message>
        <source>&amp;Delete the participant…</source>
        <translation>参加者を削除(&amp;D)…</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>participant, order of the conditions</comment>
        <translation>%1: %2</translation>
    </message>
</context>
<context>
    <name>teleta::study::StudyStart</name>
    <message>
        <source>%1 stopped in “%2” after %3 of %4 trials.</source>
        <comment>a participant</comment>
        <translation>%1は「%2」の%4試行中%3試行で中断しました。</translation>
    </message>
    <message>
        <source>Nobody has taken part yet.</source>
        <translation>まだ参加者はいません。</translation>
    </message>
    <message>
        <source>%1 of %2 sessions are finished.</source>
        <translation>%2セッション中%1セッションが終了しています。</translation>
    </message>
    <message>
        <source>A rehearsal. %1</source>
        <translation>リハーサル。%1</translation>
    </message>
    <message>
        <source>Go on with “%1”</source>
        <comment>a study</comment>
        <translation>「%1」を続ける</translation>
    </message>
    <message>
        <source>No study is open</source>
        <translation>開いている実験はありません</translation>
    </message>
    <message>
        <source>Run the published user study, or one of your own: from the first practice trial to confusion matrices and ANOVA.</source>
        <translation>論文のユーザー実験、または独自の実験を、最初の練習試行から混同行列と分散分析まで実施します。</translation>
    </message>
    <message>
        <source>Watch a rehearsal</source>
        <translation>リハーサルを見る</translation>
    </message>
    <message>
        <source>Simulated participants go through the whole study, and its results build up.</source>
        <translation>シミュレーション参加者が実験全体を行い、結果が積み上がっていきます。</translation>
    </message>
    <message>
        <source>The published protocol</source>
        <translation>論文のプロトコル</translation>
    </message>
    <message>
        <source>Six shapes and five stiffnesses, static and dynamic: read every step, and begin a study with it.</source>
        <translation>6つの形状と5つの剛性、それぞれ静的と動的。すべての手順を読み、それを使って実験を始めます。</translation>
    </message>
    <message>
        <source>Your own study</source>
        <translation>独自の実験</translation>
    </message>
    <message>
        <source>Begin with a protocol of yours, or go on with a study in a folder or on a server.</source>
        <translation>独自のプロトコルで始めるか、フォルダーまたはサーバーにある実験を続けます。</translation>
    </message>
    <message>
        <source>Go on</source>
        <translation>続ける</translation>
    </message>
    <message>
        <source>Open the study that was open last</source>
        <translation>最後に開いていた実験を開きます</translation>
    </message>
    <message>
        <source>Watch</source>
        <translation>見る</translation>
    </message>
    <message>
        <source>Simulated participants go through the whole study</source>
        <translation>シミュレーション参加者が実験全体を行います</translation>
    </message>
    <message>
        <source>Read it</source>
        <translation>読む</translation>
    </message>
    <message>
        <source>Stimuli, practice and test trials of the paper</source>
        <translation>論文の刺激、練習試行、テスト試行</translation>
    </message>
    <message>
        <source>New…</source>
        <translation>新規…</translation>
    </message>
    <message>
        <source>With the paper&apos;s protocol or your own</source>
        <translation>論文のプロトコル、または独自のプロトコルによる実験</translation>
    </message>
    <message>
        <source>Open…</source>
        <translation>開く…</translation>
    </message>
    <message>
        <source>The folder of a study</source>
        <translation>実験のフォルダー</translation>
    </message>
    <message>
        <source>Server…</source>
        <translation>サーバー…</translation>
    </message>
    <message>
        <source>A study that several stations share</source>
        <translation>複数のステーションで共有する実験</translation>
    </message>
</context>
<context>
    <name>teleta::study::ThresholdForm</name>
    <message>
        <source>log10 units</source>
        <translation>log10単位</translation>
    </message>
    <message>
        <source>Spread of &amp;participants</source>
        <translation>参加者間のばらつき(&amp;P)</translation>
    </message>
    <message>
        <source>How far the 95 % interval of the mean threshold may reach to each side</source>
        <translation>平均閾値の95 %区間が両側に広がってよい幅</translation>
    </message>
    <message>
        <source>as in the protocol</source>
        <translation>プロトコルのとおり</translation>
    </message>
    <message>
        <source>Of constant stimuli: at each level</source>
        <translation>恒常刺激: 各レベルで</translation>
    </message>
    <message>
        <source>Slope (Wei&amp;bull)</source>
        <translation>傾き (Weibull)(&amp;B)</translation>
    </message>
    <message>
        <source>Spread of the fu&amp;nction</source>
        <translation>関数の広がり(&amp;N)</translation>
    </message>
    <message>
        <source>&amp;Yes without a stimulus</source>
        <translation>刺激なしでの「はい」(&amp;Y)</translation>
    </message>
    <message>
        <source>Interval at &amp;most ±</source>
        <translation>区間の上限 ±(&amp;M)</translation>
    </message>
    <message>
        <source>Trials of a trac&amp;k</source>
        <translation>トラックの試行数(&amp;K)</translation>
    </message>
    <message>
        <source>&amp;Threshold</source>
        <translation>閾値(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Lapses</source>
        <translation>ラプス率(&amp;L)</translation>
    </message>
</context>
<context>
    <name>teleta::tactile::ChannelSettingsPanel</name>
    <message>
        <source>Not tared</source>
        <translation>ゼロ点未調整</translation>
    </message>
    <message>
        <source>Tared</source>
        <translation>ゼロ点調整済み</translation>
    </message>
    <message numerus="yes">
        <source>Tared, %n taxel(s) without a reading</source>
        <translation>
            <numerusform>ゼロ点調整済み、読み取りのないタクセル%n個</numerusform>
        </translation>
    </message>
    <message>
        <source>&amp;Tare now</source>
        <translation>ゼロ点調整(&amp;T)</translation>
    </message>
    <message>
        <source>Takes the mean of the next half second as the unloaded state. Nothing may touch the array.</source>
        <translation>次の0.5秒間の平均を無荷重状態とします。アレイに何も触れないようにしてください。</translation>
    </message>
    <message>
        <source>&amp;Clear tare</source>
        <translation>ゼロ点をクリア(&amp;C)</translation>
    </message>
    <message>
        <source>Uses the raw values again</source>
        <translation>生の値の使用に戻します</translation>
    </message>
    <message>
        <source>&amp;Gain:</source>
        <translation>ゲイン(&amp;G):</translation>
    </message>
    <message>
        <source>Load per raw unit</source>
        <translation>生の値1単位あたりの荷重</translation>
    </message>
    <message>
        <source>For arrays whose raw values are highest when nothing touches them</source>
        <translation>何も触れていないときに生の値が最大になるアレイ用</translation>
    </message>
    <message>
        <source>A taxel is in contact from this load on</source>
        <translation>タクセルはこの荷重から接触とみなされます</translation>
    </message>
    <message>
        <source>Finds the lowest useful threshold in each frame; the value above is its lower bound</source>
        <translation>フレームごとに有効な最小のしきい値を求めます。上の値がその下限です</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>&amp;Smallest contact:</source>
        <translation>最小接触(&amp;S):</translation>
    </message>
    <message>
        <source>&amp;Orientation:</source>
        <translation>向き(&amp;O):</translation>
    </message>
    <message>
        <source>Which taxels the principal axis is computed from</source>
        <translation>主軸の計算に使うタクセル</translation>
    </message>
    <message>
        <source>whole image</source>
        <translation>画像全体</translation>
    </message>
    <message>
        <source>active taxels</source>
        <translation>有効タクセル</translation>
    </message>
    <message>
        <source>&amp;Edge above:</source>
        <translation>エッジの下限(&amp;E):</translation>
    </message>
    <message>
        <source>The contact becomes an edge when the ratio of the eigenvalues rises above this</source>
        <translation>固有値の比がこれを上回ると、接触はエッジになります</translation>
    </message>
    <message>
        <source>&amp;Point below:</source>
        <translation>点の上限(&amp;P):</translation>
    </message>
    <message>
        <source>The contact becomes a point when the ratio of the eigenvalues falls below this</source>
        <translation>固有値の比がこれを下回ると、接触は点になります</translation>
    </message>
    <message>
        <source>&amp;Defaults</source>
        <translation>既定値(&amp;D)</translation>
    </message>
    <message>
        <source> %1/raw unit</source>
        <comment>of a gain: load per raw unit</comment>
        <translation> %1/生の値</translation>
    </message>
    <message>
        <source> taxel</source>
        <translation> タクセル</translation>
    </message>
    <message>
        <source> taxels</source>
        <translation> タクセル</translation>
    </message>
    <message>
        <source>taxel gains in use</source>
        <translation>タクセルのゲインを使用中</translation>
    </message>
    <message>
        <source>Two peaks count as one contact when the lower one rises less than this above the saddle between them, in percent of the highest peak of the frame</source>
        <translation>2つの山のうち低いほうが、間の鞍点からこの高さ (フレームのピークに対する%) 未満しか高くない場合、1つの接触とみなします</translation>
    </message>
    <message>
        <source>In taxels; smaller contacts are ignored</source>
        <translation>タクセル数。これより少ない接触は無視します</translation>
    </message>
    <message>
        <source>active taxels equally</source>
        <translation>有効タクセルを均等に</translation>
    </message>
    <message>
        <source>weighted by load</source>
        <translation>荷重で重み付け</translation>
    </message>
    <message>
        <source>Whole image: adds up every load. Active taxels: leaves out the noise of unloaded taxels</source>
        <translation>画像全体ではすべての荷重を数えます。有効タクセルでは無荷重タクセルのノイズを除きます</translation>
    </message>
    <message>
        <source>Reset everything but the tare and the taxel gains</source>
        <translation>ゼロ点とタクセルのゲイン以外をすべて既定値に戻します</translation>
    </message>
    <message>
        <source>Values fall under load</source>
        <translation>荷重がかかると値が下がる</translation>
    </message>
    <message>
        <source>Thresho&amp;ld:</source>
        <translation>しきい値(&amp;L):</translation>
    </message>
    <message>
        <source>A&amp;utomatic threshold</source>
        <translation>自動しきい値(&amp;U)</translation>
    </message>
    <message>
        <source>Force over:</source>
        <translation>力の範囲:</translation>
    </message>
    <message>
        <source>No&amp;ise height:</source>
        <translation>ノイズ高さ(&amp;I):</translation>
    </message>
    <message>
        <source>Loads</source>
        <comment>a group of settings</comment>
        <translation>荷重</translation>
    </message>
    <message>
        <source>Contacts</source>
        <comment>a group of settings</comment>
        <translation>接触</translation>
    </message>
</context>
<context>
    <name>teleta::tactile::HeatmapView</name>
    <message>
        <source>Tactile heatmap</source>
        <translation>触覚ヒートマップ</translation>
    </message>
    <message>
        <source>&amp;Contacts</source>
        <translation>接触(&amp;C)</translation>
    </message>
    <message>
        <source>Outline each contact and show its number</source>
        <translation>各接触の輪郭と番号を表示します</translation>
    </message>
    <message>
        <source>Mark the load-weighted centre with ×</source>
        <translation>荷重で重み付けした中心を×で示します</translation>
    </message>
    <message>
        <source>Mark the centre of the touched area with ○</source>
        <translation>触れている領域の中心を○で示します</translation>
    </message>
    <message>
        <source>Draw the axis along which the touched area is longest</source>
        <translation>触れている領域が最も長い方向の軸を描きます</translation>
    </message>
    <message>
        <source>&amp;Numbers</source>
        <translation>数値(&amp;N)</translation>
    </message>
    <message>
        <source>Write each load into its taxel where there is room</source>
        <translation>場所があれば各タクセルに荷重を書き込みます</translation>
    </message>
    <message>
        <source>heatmap</source>
        <translation>ヒートマップ</translation>
    </message>
    <message>
        <source>&amp;Automatic</source>
        <translation>自動(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Fixed at %1</source>
        <translation>%1に固定(&amp;F)</translation>
    </message>
    <message>
        <source>Upper end of the colours</source>
        <translation>色の上端</translation>
    </message>
    <message>
        <source>Load at the upper end of the colours. Empty: automatic.</source>
        <translation>色の上端に対応する荷重。空欄: 自動。</translation>
    </message>
    <message>
        <source>auto</source>
        <translation>自動</translation>
    </message>
    <message>
        <source>Dead taxel: its value is not used.</source>
        <translation>不良タクセル: 値は使用されません。</translation>
    </message>
    <message>
        <source>Centre of &amp;pressure</source>
        <translation>圧力中心(&amp;P)</translation>
    </message>
    <message>
        <source>Centre of c&amp;ontact</source>
        <translation>接触中心(&amp;O)</translation>
    </message>
    <message>
        <source>Principal &amp;axis</source>
        <translation>主軸(&amp;A)</translation>
    </message>
    <message>
        <source>Colour &amp;range</source>
        <translation>色の範囲(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Type upper end…</source>
        <translation>上端を入力(&amp;T)…</translation>
    </message>
    <message>
        <source>Show &amp;whole array</source>
        <translation>アレイ全体を表示(&amp;W)</translation>
    </message>
    <message>
        <source>Loads from 0 to %1. Taxels below the threshold of %2 are not in contact.
Double-click to type the upper end.</source>
        <translation>0から%1までの荷重。しきい値%2未満のタクセルは接触とみなしません。
ダブルクリックすると上端を入力できます。</translation>
    </message>
    <message>
        <source>&lt;p&gt;The load of every taxel of the array, seen from outside the skin: x points to the right, y up.&lt;/p&gt;&lt;p&gt;Coloured outlines are contacts, each with the number under which it is followed. × is the centre of pressure, ○ the centre of contact, the line the principal axis. Hatched taxels are dead and carry no load. Arrows are the force along the surface, of arrays that measure it; zoom in where taxels are too small for them.&lt;/p&gt;&lt;p&gt;Ctrl+wheel zooms, drag moves, double click shows the whole array. Double-click the colour bar to type its upper end. The arrow keys read taxel by taxel.&lt;/p&gt;</source>
        <translation>&lt;p&gt;アレイの各タクセルの荷重を、皮膚の外側から見た向きで示します。xは右向き、yは上向きです。&lt;/p&gt;&lt;p&gt;色付きの輪郭線は接触で、それぞれ追跡番号が付いています。×は圧力中心、○は接触中心、線は主軸です。斜線のタクセルは不良で、荷重を持ちません。矢印は、アレイが測る場合の表面に沿う力です。タクセルが小さすぎて描かれないときは拡大してください。&lt;/p&gt;&lt;p&gt;Ctrl+ホイールで拡大・縮小、ドラッグで移動、ダブルクリックでアレイ全体を表示します。カラーバーをダブルクリックすると上端の値を入力できます。矢印キーでタクセルごとに値を読み取れます。&lt;/p&gt;</translation>
    </message>
    <message>
        <source>&amp;Shear</source>
        <translation>せん断(&amp;H)</translation>
    </message>
    <message>
        <source>Draw the force along the surface as arrows, of arrays that measure it</source>
        <translation>アレイが測る場合、表面に沿う力を矢印で描きます</translation>
    </message>
    <message>
        <source>load</source>
        <translation>荷重</translation>
    </message>
    <message>
        <source>moment</source>
        <translation>モーメント</translation>
    </message>
    <message>
        <source>shear along x</source>
        <translation>x方向のせん断</translation>
    </message>
    <message>
        <source>shear along y</source>
        <translation>y方向のせん断</translation>
    </message>
</context>
<context>
    <name>teleta::touch::ContourView</name>
    <message>
        <source>Explored contour</source>
        <translation>探索した輪郭</translation>
    </message>
    <message>
        <source>contour</source>
        <translation>輪郭</translation>
    </message>
    <message>
        <source>&amp;Forget the explored contour</source>
        <translation>探索した輪郭を破棄(&amp;F)</translation>
    </message>
    <message>
        <source>&lt;p&gt;The object from above, as far as it was explored: the points at which it was touched, the spline through them, and the vertices or the circle of the shape that was recognised.&lt;/p&gt;&lt;p&gt;The confidence is the share of such answers that are right. While the points do not decide, the shapes that come into question stand there with their probabilities.&lt;/p&gt;</source>
        <translation>&lt;p&gt;これまでに探索した範囲の物体を上から見た図です: 触れた点、それらを通るスプライン、認識された形状の頂点または円を示します。&lt;/p&gt;&lt;p&gt;確信度は、そのような答えのうち正しいものの割合です。点からまだ決まらない間は、可能性のある形状とその確率を表示します。&lt;/p&gt;</translation>
    </message>
</context>
<context>
    <name>teleta::touch::DriveSign</name>
    <message>
        <source>Drive of the arm</source>
        <translation>アームの駆動</translation>
    </message>
    <message>
        <source>no arm</source>
        <translation>アームなし</translation>
    </message>
</context>
<context>
    <name>teleta::touch::JogPanel</name>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Jog the arm</source>
        <translation>アームのジョグ</translation>
    </message>
    <message>
        <source>&lt;p&gt;Moves the arm by hand. It moves only while you hold Shift, or the wide button, together with a direction. Let go of either and it stands still.&lt;/p&gt;</source>
        <translation>&lt;p&gt;アームを手動で動かします。Shiftまたは幅広のボタンを、方向と同時に押している間だけ動きます。どちらかを離すと停止します。&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Let the arm&apos;s program go on</source>
        <translation>アームのプログラムを続行します</translation>
    </message>
    <message>
        <source>Hold the arm where it is</source>
        <translation>アームをその位置で保持します</translation>
    </message>
    <message>
        <source>R&amp;estart</source>
        <translation>再開始(&amp;E)</translation>
    </message>
    <message>
        <source>Joints</source>
        <translation>関節</translation>
    </message>
    <message>
        <source>Tip, x y z</source>
        <translation>先端、x y z</translation>
    </message>
    <message>
        <source>What is moved</source>
        <translation>動かす対象</translation>
    </message>
    <message>
        <source>Turn single joints, or move the tip of the forearm along the base&apos;s axes</source>
        <translation>関節を1つずつ回すか、前腕の先端をベースの軸に沿って動かします</translation>
    </message>
    <message>
        <source>&amp;Speed</source>
        <translation>速度(&amp;S)</translation>
    </message>
    <message>
        <source>Share of the fastest speed</source>
        <translation>最高速度に対する割合</translation>
    </message>
    <message>
        <source>Jog speed</source>
        <translation>ジョグ速度</translation>
    </message>
    <message>
        <source>Hold to enable (or Shift)</source>
        <translation>押している間有効 (またはShift)</translation>
    </message>
    <message>
        <source>Dead-man switch: the arm moves only while this button or Shift is held</source>
        <translation>デッドマンスイッチ: このボタンまたはShiftを押している間だけアームが動きます</translation>
    </message>
    <message>
        <source>Dead-man switch</source>
        <translation>デッドマンスイッチ</translation>
    </message>
    <message>
        <source>Angle of %1</source>
        <translation>%1の角度</translation>
    </message>
    <message>
        <source>tip along %1</source>
        <translation>先端 %1方向</translation>
    </message>
    <message>
        <source>%1 up</source>
        <translation>%1 増</translation>
    </message>
    <message>
        <source>%1 down</source>
        <translation>%1 減</translation>
    </message>
    <message>
        <source>Hold with Shift to move; key Shift+%1</source>
        <translation>Shiftと同時に押している間動きます。キー Shift+%1</translation>
    </message>
    <message>
        <source>No arm is connected. Open a scene or a device with an arm.</source>
        <translation>アームが接続されていません。アームを含むシーンまたはデバイスを開いてください。</translation>
    </message>
    <message>
        <source>STOP is engaged. Hold the STOP button to release it, then jog.</source>
        <translation>STOPが作動中です。STOPボタンを押し続けて解除してから、ジョグしてください。</translation>
    </message>
    <message>
        <source>Hold Shift and a button, or Shift with D A (x), W S (y), E Q (z).</source>
        <translation>Shiftとボタンを押し続けるか、ShiftとD A (x)、W S (y)、E Q (z) を押し続けてください。</translation>
    </message>
    <message>
        <source>The joint readings are old: nothing is moved until they come again.</source>
        <translation>関節の測定値が古くなっています: 再び届くまで何も動きません。</translation>
    </message>
    <message>
        <source>&amp;Step</source>
        <translation>ステップ(&amp;T)</translation>
    </message>
    <message>
        <source>How far a press leads the tip, and a 3D mouse that is fully deflected</source>
        <translation>1回押したとき、または3Dマウスを最大まで倒したときに先端が動く距離</translation>
    </message>
    <message>
        <source>Length of a step</source>
        <translation>ステップの長さ</translation>
    </message>
    <message>
        <source>By velocity</source>
        <translation>速度で</translation>
    </message>
    <message>
        <source>By position</source>
        <translation>位置で</translation>
    </message>
    <message>
        <source>How it is moved</source>
        <translation>動かし方</translation>
    </message>
    <message>
        <source>By velocity the arm moves while a direction is held. By position each press is a step of the tip, and a 3D mouse leads the tip as far as it is deflected.</source>
        <translation>速度では、方向を押している間アームが動きます。位置では、1回押すごとに先端が1ステップ動き、3Dマウスでは倒した分だけ先端が動きます。</translation>
    </message>
    <message>
        <source>Clutch (C)</source>
        <translation>クラッチ (C)</translation>
    </message>
    <message>
        <source>While it is held the arm stands still and the hand goes back freely; then it takes hold anew. Also the second button of a 3D mouse.</source>
        <translation>押している間アームは静止し、手を自由に戻せます。離すと、その位置から再び操作できます。3Dマウスの第2ボタンも同じです。</translation>
    </message>
    <message>
        <source>Clutch</source>
        <translation>クラッチ</translation>
    </message>
    <message>
        <source>Hold Shift: each press of D A (x), W S (y), E Q (z) is a step.</source>
        <translation>Shiftを押し続けてください: D A (x)、W S (y)、E Q (z) を1回押すごとに1ステップ動きます。</translation>
    </message>
    <message>
        <source>&lt;p&gt;Leads the tip of the arm by hand. Each press of a direction is a step. The arm moves only while you hold Shift, or the wide button; let go of it and it stands still.&lt;/p&gt;</source>
        <translation>&lt;p&gt;アームの先端を手動で動かします。方向を1回押すごとに1ステップ進みます。アームはShiftまたは幅の広いボタンを押している間だけ動き、離すと停止します。&lt;/p&gt;</translation>
    </message>
    <message>
        <source>A step, while Shift is held; key Shift+%1</source>
        <translation>Shiftを押している間の1ステップ。キー Shift+%1</translation>
    </message>
    <message>
        <source>A recording is played: what its arm did is over, and nothing can be moved.</source>
        <translation>記録を再生しています。アームの動きは過去のものなので、動かすことはできません。</translation>
    </message>
    <message>
        <source>Restart the arm&apos;s program</source>
        <translation>アームのプログラムを再開始します</translation>
    </message>
    <message>
        <source>Hold with Shift to move</source>
        <translation>Shiftと同時に押している間動きます</translation>
    </message>
    <message>
        <source>Hold Shift and a button, or Shift with %1 (up), %2 (down).</source>
        <translation>Shiftとボタンを押し続けるか、Shiftと %1 (増)、%2 (減) を押し続けてください。</translation>
    </message>
    <message>
        <source>tip %1</source>
        <translation>先端 %1</translation>
    </message>
    <message>
        <source>Click here first: the keys work only in this view. %1</source>
        <translation>先にここをクリックしてください。キーはこのビューでのみ働きます。%1</translation>
    </message>
    <message>
        <source>The arm does not move: %1.</source>
        <translation>アームは動きません：%1。</translation>
    </message>
    <message>
        <source>UNGUARDED: the robot does not stop by itself when this program or the network fails. Keep its emergency stop within reach. %1</source>
        <translation>保護なし: このプログラムやネットワークが故障しても、ロボットは自分では止まりません。非常停止に手が届くようにしてください。%1</translation>
    </message>
    <message>
        <source>At the tip: force %1, torque %2</source>
        <translation>先端: 力 %1、トルク %2</translation>
    </message>
    <message>
        <source>Speed and effort of %1, as the arm reports them</source>
        <translation>%1 の速度とトルク・力 (アームの報告値)</translation>
    </message>
    <message>
        <source>R&amp;un</source>
        <translation>実行(&amp;U)</translation>
    </message>
    <message>
        <source>H&amp;old</source>
        <translation>保持(&amp;O)</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>a button and what it does</comment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Hold (or Shift)</source>
        <translation>押している間 (Shift)</translation>
    </message>
    <message>
        <source>Hold Shift with %1 (up), %2 (down).</source>
        <translation>Shiftと %1 (増)、%2 (減) を押し続けてください。</translation>
    </message>
</context>
<context>
    <name>teleta::touch::JointRange</name>
    <message>
        <source>%1 limit</source>
        <translation>%1 可動端</translation>
    </message>
    <message>
        <source>limit</source>
        <translation>可動端</translation>
    </message>
    <message>
        <source>Turns without limits</source>
        <translation>制限なく回転</translation>
    </message>
    <message>
        <source>Range %1 … %2</source>
        <translation>範囲 %1 … %2</translation>
    </message>
</context>
<context>
    <name>teleta::touch::LimitLine</name>
    <message>
        <source>Active limits: %1.</source>
        <translation>作用中の制限: %1。</translation>
    </message>
    <message>
        <source>Near a singularity: slower.</source>
        <translation>特異点の近く：遅くなります。</translation>
    </message>
</context>
<context>
    <name>teleta::touch::PatternMapTable</name>
    <message>
        <source>level %1: %2</source>
        <translation>レベル%1: %2</translation>
    </message>
    <message>
        <source>What was recognised and its pattern</source>
        <translation>認識されたものとそのパターン</translation>
    </message>
    <message>
        <source>&lt;p&gt;Which pattern the bracelet plays for what was recognised. The marked row was recognised last.&lt;/p&gt;</source>
        <translation>&lt;p&gt;認識されたものに対して、ブレスレットが再生するパターンです。印の付いた行は最後に認識されたものです。&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Patterns for what was recognised</source>
        <translation>認識されたものに対するパターン</translation>
    </message>
    <message>
        <source>Recognised</source>
        <translation>認識</translation>
    </message>
    <message>
        <source>Pattern</source>
        <translation>パターン</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>元に戻す(&amp;U)</translation>
    </message>
    <message>
        <source>&amp;Defaults</source>
        <translation>既定値(&amp;D)</translation>
    </message>
    <message>
        <source>The built-in dynamic patterns again; can be undone</source>
        <translation>組み込みの動的パターンに戻します。元に戻せます</translation>
    </message>
    <message>
        <source>&amp;Import…</source>
        <translation>インポート(&amp;I)…</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>エクスポート(&amp;E)…</translation>
    </message>
    <message>
        <source>Pattern for %1</source>
        <translation>%1のパターン</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>%1 (missing)</source>
        <translation>%1 (見つかりません)</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1、%2</translation>
    </message>
    <message>
        <source>%1 (now)</source>
        <translation>%1 (現在)</translation>
    </message>
    <message>
        <source>Nothing was recognised yet.</source>
        <translation>まだ何も認識されていません。</translation>
    </message>
    <message>
        <source>Recognised: %1. Nothing is played.</source>
        <translation>認識: %1。再生なし。</translation>
    </message>
    <message>
        <source>Recognised: %1. Pattern now: %2.</source>
        <translation>認識: %1。現在のパターン: %2。</translation>
    </message>
    <message>
        <source>Recognised: %1. Its pattern %2 is missing.</source>
        <translation>認識: %1。パターン %2 が見つかりません。</translation>
    </message>
    <message>
        <source>Default patterns</source>
        <translation>既定のパターン</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>インポート</translation>
    </message>
    <message>
        <source>The file could not be written: %1</source>
        <translation>ファイルに書き込めませんでした: %1</translation>
    </message>
    <message>
        <source>Map of patterns (*.json)</source>
        <translation>パターン対応表 (*.json)</translation>
    </message>
    <message>
        <source>Export patterns</source>
        <translation>パターンのエクスポート</translation>
    </message>
    <message>
        <source>Import patterns</source>
        <translation>パターンのインポート</translation>
    </message>
    <message>
        <source>unknown stiffness</source>
        <translation>硬さ不明</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>種類</translation>
    </message>
    <message>
        <source>Red&amp;o</source>
        <translation>やり直す(&amp;O)</translation>
    </message>
</context>
<context>
    <name>teleta::touch::RunSheet</name>
    <message>
        <source>Run sheet</source>
        <translation>探索シート</translation>
    </message>
    <message>
        <source>&lt;p&gt;The objects that were found, told apart by their place. Stiffness is the median of their touches, with its 95 % interval.&lt;/p&gt;&lt;p&gt;F2 names an object, Delete takes it off the sheet, Ctrl+Z brings it back.&lt;/p&gt;</source>
        <translation>&lt;p&gt;見つかった物体を、場所で区別して示します。剛性はそのタッチの中央値で、95 %区間を添えます。&lt;/p&gt;&lt;p&gt;F2で物体に名前を付け、Deleteでシートから外し、Ctrl+Zで元に戻します。&lt;/p&gt;</translation>
    </message>
    <message>
        <source>No object was found yet. Drive the arm until it touches something.</source>
        <translation>物体はまだ見つかっていません。何かに触れるまでアームを動かしてください。</translation>
    </message>
    <message>
        <source>&amp;Name…</source>
        <translation>名前を付ける(&amp;N)…</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>削除(&amp;D)</translation>
    </message>
    <message>
        <source>&amp;Undo %1</source>
        <translation>元に戻す(&amp;U) %1</translation>
    </message>
    <message>
        <source>&amp;Redo %1</source>
        <translation>やり直す(&amp;R) %1</translation>
    </message>
    <message numerus="yes">
        <source>%n object(s) found</source>
        <translation>
            <numerusform>見つかった物体%n個</numerusform>
        </translation>
    </message>
    <message>
        <source>run-sheet</source>
        <comment>name of a file</comment>
        <translation>探索シート</translation>
    </message>
    <message>
        <source>No object was found yet. Play the recording until the arm touches something.</source>
        <translation>物体はまだ見つかっていません。アームが何かに触れるまで記録を再生してください。</translation>
    </message>
</context>
<context>
    <name>teleta::touch::RunSheetModel</name>
    <message>
        <source>Rename object %1</source>
        <translation>物体%1の名前の変更</translation>
    </message>
    <message>
        <source>Delete from the run sheet</source>
        <translation>探索シートから削除</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>番号</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名前</translation>
    </message>
    <message>
        <source>Found at</source>
        <translation>発見時刻</translation>
    </message>
    <message>
        <source>Place x, y</source>
        <translation>位置 x, y</translation>
    </message>
    <message>
        <source>Touches</source>
        <translation>タッチ</translation>
    </message>
    <message>
        <source>Contact</source>
        <translation>接触</translation>
    </message>
    <message>
        <source>Stiffness</source>
        <translation>剛性</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>材料</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>形状</translation>
    </message>
    <message>
        <source>When its first touch began, as in Touches</source>
        <translation>「接触」と同じ、最初の接触が始まった時刻</translation>
    </message>
    <message>
        <source>The highest force of all its touches, from the torques of the joints</source>
        <translation>関節のトルクから求めた、すべての接触のうち最大の力</translation>
    </message>
    <message>
        <source>Force when evaluated</source>
        <translation>評価時の力</translation>
    </message>
</context>
<context>
    <name>teleta::touch::StiffnessGauge</name>
    <message>
        <source>Stiffness of the touched object</source>
        <translation>触れた物体の剛性</translation>
    </message>
    <message>
        <source>&lt;p&gt;How stiff the object is that was touched last, on a logarithmic scale. The dot is the estimate, the line through it the interval in which the stiffness lies with 95 %.&lt;/p&gt;&lt;p&gt;An object that yields hardly more than the arm itself cannot be told from a rigid one: then an open arrow shows that its stiffness is at least so large.&lt;/p&gt;&lt;p&gt;Sponge and rubber sponge are safe to touch; rubber, wood and metal are a danger.&lt;/p&gt;</source>
        <translation>&lt;p&gt;最後に触れた物体の硬さを対数目盛で示します。点は推定値、点を通る線は剛性が95 %で含まれる区間です。&lt;/p&gt;&lt;p&gt;アーム自体とほとんど同程度にしかたわまない物体は、剛体と区別できません。その場合、剛性が少なくともその値以上であることを開いた矢印で示します。&lt;/p&gt;&lt;p&gt;スポンジとゴムスポンジは触れても安全です。ゴム、木、金属は危険です。&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Touch an object with the arm&apos;s skin: its stiffness appears here.</source>
        <translation>アームのスキンで物体に触れると、ここに剛性が表示されます。</translation>
    </message>
    <message>
        <source>stiffness</source>
        <translation>剛性</translation>
    </message>
    <message>
        <source>&lt;p&gt;Below the word stands how long ago the touch was. After half a minute it is stale: the arm may be elsewhere by then.&lt;/p&gt;</source>
        <translation>&lt;p&gt;言葉の下に、触れてからどれだけ経ったかが示されます。30秒を過ぎると古いと示します。アームはもう別の場所にあるかもしれません。&lt;/p&gt;</translation>
    </message>
</context>
<context>
    <name>teleta::touch::TouchModel</name>
    <message>
        <source>No force: the skin did not feel where the contact is.</source>
        <translation>力なし: 皮膚が接触位置を感知しませんでした。</translation>
    </message>
    <message>
        <source>%1: %2 ± %3 N</source>
        <translation>%1: %2 ± %3 N</translation>
    </message>
    <message>
        <source>%1: not observable in this configuration of the arm</source>
        <translation>%1: アームのこの姿勢では観測できません</translation>
    </message>
    <message>
        <source>condition number %1, unexplained torque %2 Nm</source>
        <translation>条件数 %1、説明できないトルク %2 Nm</translation>
    </message>
    <message>
        <source>none</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message numerus="yes">
        <source>95 % interval in brackets; %1, %n sample(s)</source>
        <translation>
            <numerusform>括弧内は95 %区間。%1、%nサンプル</numerusform>
        </translation>
    </message>
    <message>
        <source>No stiffness: the skin did not feel where the contact is.</source>
        <translation>剛性なし: 皮膚が接触位置を感知しませんでした。</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1、%2</translation>
    </message>
    <message>
        <source>%1 (not certain), %2</source>
        <translation>%1 (不確実)、%2</translation>
    </message>
    <message>
        <source>First torque above the noise at %1 s, estimated %2 ms later; evaluated: %3</source>
        <translation>ノイズを超えた最初のトルク: %1 s、推定はその%2 ms後。評価範囲: %3</translation>
    </message>
    <message>
        <source>The skin did not feel this contact.</source>
        <translation>皮膚がこの接触を感知しませんでした。</translation>
    </message>
    <message>
        <source>Condition number of the force: longest over shortest lever; large is bad</source>
        <translation>力の条件数: 最長と最短のてこの比。大きいほど悪い</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>番号</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>時刻</translation>
    </message>
    <message>
        <source>Contact x, y, z</source>
        <translation>接触 x, y, z</translation>
    </message>
    <message>
        <source>Along link</source>
        <translation>リンク方向</translation>
    </message>
    <message>
        <source>Force x, y, z</source>
        <translation>力 x, y, z</translation>
    </message>
    <message>
        <source>Stiffness</source>
        <translation>剛性</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>材料</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>レベル</translation>
    </message>
    <message>
        <source>Condition</source>
        <translation>条件数</translation>
    </message>
    <message>
        <source>cannot tell</source>
        <translation>判定不能</translation>
    </message>
    <message>
        <source>Force at the contact; a dash marks what the arm cannot observe in this pose</source>
        <translation>接触点の力。ダッシュは、その姿勢でアームが観測できないものを示します</translation>
    </message>
    <message>
        <source>x, y, z in the frame of the arm&apos;s base; the distance is from the joint that presses: along the forearm from the elbow</source>
        <translation>アームの基部の座標系でのx、y、z。距離は押す関節からのもの: 前腕に沿った肘からの距離</translation>
    </message>
    <message>
        <source>Distance of the contact from the joint that presses: along the forearm from the elbow</source>
        <translation>押す関節から接触点までの距離: 前腕に沿った肘からの距離</translation>
    </message>
</context>
<context>
    <name>teleta::touch::TouchTable</name>
    <message>
        <source>Recent touches</source>
        <translation>最近のタッチ</translation>
    </message>
    <message>
        <source>&lt;p&gt;Every touch of the arm with what was found out about it. A ? in the force marks a component that the arm cannot observe in its configuration.&lt;/p&gt;&lt;p&gt;Click a title to sort. Ctrl+C copies the selected rows.&lt;/p&gt;</source>
        <translation>&lt;p&gt;アームのすべてのタッチと、それについてわかったことです。力の?は、アームがこの姿勢では観測できない成分を示します。&lt;/p&gt;&lt;p&gt;見出しをクリックすると並べ替えます。Ctrl+Cで選択した行をコピーします。&lt;/p&gt;</translation>
    </message>
    <message>
        <source>No touch yet. Touch an object with the arm&apos;s skin.</source>
        <translation>タッチはまだありません。アームのスキンで物体に触れてください。</translation>
    </message>
    <message>
        <source>touches</source>
        <translation>タッチ一覧</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>コピー(&amp;C)</translation>
    </message>
    <message numerus="yes">
        <source>%n touch(es)</source>
        <translation>
            <numerusform>タッチ%n件</numerusform>
        </translation>
    </message>
    <message>
        <source>Select &amp;all</source>
        <translation>すべて選択(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Newest first</source>
        <translation>新しい順(&amp;N)</translation>
    </message>
</context>
<context>
    <name>teleta::view3d::Scene3dView</name>
    <message>
        <source>touch 3-D</source>
        <translation>3Dタッチ</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Flat array</source>
        <translation>平らなアレイ</translation>
    </message>
    <message>
        <source>Show the array flat, as it is</source>
        <translation>アレイをそのまま平らに表示します</translation>
    </message>
    <message>
        <source>Wrapped on the cylinder</source>
        <translation>円筒に巻き付け</translation>
    </message>
    <message>
        <source>Wrap the array around the tactile cylinder</source>
        <translation>アレイを触覚円筒に巻き付けて表示します</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>正面</translation>
    </message>
    <message>
        <source>Look from the front</source>
        <translation>正面から見ます</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>上面</translation>
    </message>
    <message>
        <source>Look from above</source>
        <translation>上から見ます</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>側面</translation>
    </message>
    <message>
        <source>Look from the right</source>
        <translation>右から見ます</translation>
    </message>
    <message>
        <source>Isometric</source>
        <translation>等角投影</translation>
    </message>
    <message>
        <source>Look from a corner</source>
        <translation>斜め上の角から見ます</translation>
    </message>
    <message>
        <source>Follow contact</source>
        <translation>接触に追従</translation>
    </message>
    <message>
        <source>Orthographic</source>
        <translation>平行投影</translation>
    </message>
    <message>
        <source>Parallel lines stay parallel: no perspective</source>
        <translation>平行線を平行のまま表示します: 遠近感なし</translation>
    </message>
    <message>
        <source>Copy picture</source>
        <translation>画像をコピー</translation>
    </message>
    <message>
        <source>Copy the picture</source>
        <translation>画像をコピーします</translation>
    </message>
    <message>
        <source>Export geometry…</source>
        <translation>形状をエクスポート…</translation>
    </message>
    <message>
        <source>Save the scene for other programs: VTP, PLY, STL</source>
        <translation>シーンをほかのプログラム用に保存します: VTP、PLY、STL</translation>
    </message>
    <message>
        <source>3-D view</source>
        <translation>3Dビュー</translation>
    </message>
    <message>
        <source>Touch in 3-D</source>
        <translation>3Dでのタッチ</translation>
    </message>
    <message>
        <source>The tactile array with its loads as heights and colours, contacts with force arrows, the arm and the explored contour. Drag with the left button to turn, with the middle button to move, turn the wheel to zoom.</source>
        <translation>触覚アレイの荷重を高さと色で示し、力の矢印付きの接触、アーム、探索した輪郭を表示します。左ボタンのドラッグで回転、中央ボタンのドラッグで移動、ホイールで拡大・縮小します。</translation>
    </message>
    <message>
        <source>No touch to show yet.</source>
        <translation>表示するタッチはまだありません。</translation>
    </message>
    <message>
        <source>Export geometry (in mm)</source>
        <translation>形状のエクスポート (mm単位)</translation>
    </message>
    <message>
        <source>VTK, with colours and lines (*.vtp)</source>
        <translation>VTK、色と線付き (*.vtp)</translation>
    </message>
    <message>
        <source>Triangles with colours (*.ply)</source>
        <translation>色付き三角形 (*.ply)</translation>
    </message>
    <message>
        <source>Triangles (*.stl)</source>
        <translation>三角形 (*.stl)</translation>
    </message>
    <message>
        <source>Keep the strongest contact in the middle, or the arm&apos;s hand while nothing is touched</source>
        <translation>最も強い接触を、何にも触れていない間はアームの手先を中央に保ちます</translation>
    </message>
    <message>
        <source>From the hand</source>
        <translation>ハンドから</translation>
    </message>
    <message>
        <source>Look along with the tactile array: the camera moves and turns with the hand that carries it</source>
        <translation>触覚アレイとともに見る：カメラはアレイを持つハンドとともに動き、回ります</translation>
    </message>
    <message>
        <source>Initial view</source>
        <translation>初期表示</translation>
    </message>
    <message>
        <source>Back to the view of the beginning, from a corner</source>
        <translation>最初の表示 (斜めから) に戻ります</translation>
    </message>
</context>
<context>
    <name>teleta::view3d::SceneLayers</name>
    <message>
        <source>Grid</source>
        <translation>グリッド</translation>
    </message>
    <message>
        <source>Show the ground with a grid in millimetres</source>
        <translation>ミリメートル単位のグリッド付きの床を表示します</translation>
    </message>
    <message>
        <source>Axes</source>
        <translation>座標軸</translation>
    </message>
    <message>
        <source>Show the axes of the array&apos;s frame</source>
        <translation>アレイ座標系の軸を表示します</translation>
    </message>
    <message>
        <source>Displacement</source>
        <translation>変位</translation>
    </message>
    <message>
        <source>Show how far each contact moved since it began</source>
        <translation>各接触が開始時からどれだけ動いたかを表示します</translation>
    </message>
    <message>
        <source>Contact labels</source>
        <translation>接触ラベル</translation>
    </message>
    <message>
        <source>Show number and force at each contact</source>
        <translation>各接触に番号と力を表示します</translation>
    </message>
    <message>
        <source>Trail of the tip</source>
        <translation>先端の軌跡</translation>
    </message>
    <message>
        <source>Show where the arm&apos;s tip was in the last 5 s</source>
        <translation>アームの先端が直近の5秒間にいた場所を表示</translation>
    </message>
    <message>
        <source>Joint limits</source>
        <translation>関節の限界</translation>
    </message>
    <message>
        <source>Show range and angle of each joint that is near the end of its range</source>
        <translation>範囲の端に近い各関節の範囲と角度を表示</translation>
    </message>
    <message>
        <source>Forces</source>
        <translation>力</translation>
    </message>
    <message>
        <source>Show forces as arrows</source>
        <translation>力を矢印で表示</translation>
    </message>
    <message>
        <source>Moments</source>
        <translation>モーメント</translation>
    </message>
    <message>
        <source>Show the moment of the loads on a flat array about their centre, as an arrow that turns</source>
        <translation>平らなアレイの荷重が中心のまわりに作るモーメントを曲がった矢印で表示</translation>
    </message>
    <message>
        <source>Objects of the scene</source>
        <translation>シーンの物体</translation>
    </message>
    <message>
        <source>Show what a simulated scene has around the arm</source>
        <translation>シミュレーションのシーンでアームの周りにあるものを表示します</translation>
    </message>
</context>
<context>
    <name>teleta::view3d::VtkWidget</name>
    <message>
        <source>The 3-D view is not available. %1
All other views work without it.</source>
        <translation>3Dビューは使用できません。%1
ほかのビューはすべて動作します。</translation>
    </message>
</context>
<context>
    <name>view3d</name>
    <message>
        <source>a file name that ends in .vtp, .ply or .stl</source>
        <translation>.vtp、.ply、.stlのいずれかで終わるファイル名</translation>
    </message>
    <message>
        <source>The scene is empty: there is nothing to write.</source>
        <translation>シーンが空です: 書き込むものがありません。</translation>
    </message>
    <message>
        <source>nothing was written</source>
        <translation>何も書き込まれませんでした</translation>
    </message>
    <message>
        <source>The geometry could not be written: %1</source>
        <translation>形状を書き込めませんでした: %1</translation>
    </message>
    <message>
        <source>The display platform &quot;%1&quot; has no OpenGL widgets.</source>
        <translation>表示プラットフォーム「%1」はOpenGLウィジェットに対応していません。</translation>
    </message>
    <message>
        <source>This display refused an OpenGL context.</source>
        <translation>このディスプレイがOpenGLコンテキストを拒否しました。</translation>
    </message>
    <message>
        <source>The OpenGL driver of this display does not work with VTK.</source>
        <translation>このディスプレイのOpenGLドライバーはVTKで動作しません。</translation>
    </message>
    <message>
        <source>Geometry cannot be written in this format.</source>
        <translation>書き込み可能な形状の形式ではありません。</translation>
    </message>
    <message>
        <source>This display does not support OpenGL %1.%2 or newer.</source>
        <translation>このディスプレイはOpenGL %1.%2以降に対応していません。</translation>
    </message>
</context>
</TS>
