<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="zh_CN" sourcelanguage="en">
<context>
    <name>AblationText</name>
    <message>
        <source>interrupted before all runs were done</source>
        <translation>在全部运行完成前中断</translation>
    </message>
    <message>
        <source>the spread of a measure needs at least two seeds</source>
        <translation>要得到测量量的离散度，至少需要两个种子</translation>
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
        <translation>显示远程机械臂所触碰的内容，并让操作者感受到它。</translation>
    </message>
    <message>
        <source>Free software under the GNU General Public License, version 3 or later. It comes without any warranty.</source>
        <translation>自由软件，采用 GNU 通用公共许可证第 3 版或更高版本。不提供任何担保。</translation>
    </message>
    <message>
        <source>About TeleTA Console</source>
        <translation>关于 TeleTA Console</translation>
    </message>
    <message>
        <source>Esc Esc, Ctrl+.</source>
        <translation>Esc Esc, Ctrl+.</translation>
    </message>
    <message>
        <source>Space</source>
        <translation>空格键</translation>
    </message>
    <message>
        <source>Play or pause</source>
        <translation>播放或暂停</translation>
    </message>
    <message>
        <source>Left, Right</source>
        <translation>左、右方向键</translation>
    </message>
    <message>
        <source>One frame back or forward</source>
        <translation>后退或前进一帧</translation>
    </message>
    <message>
        <source>Home, End</source>
        <translation>Home、End</translation>
    </message>
    <message>
        <source>Start or end of the recording</source>
        <translation>到记录的开头或末尾</translation>
    </message>
    <message>
        <source>Arrow keys</source>
        <translation>方向键</translation>
    </message>
    <message>
        <source>Move the read-out from taxel to taxel, in the heatmap</source>
        <translation>在热图中：逐个触觉单元移动读数</translation>
    </message>
    <message>
        <source>Ctrl+wheel</source>
        <translation>Ctrl+滚轮</translation>
    </message>
    <message>
        <source>Zoom the picture or the time under the mouse</source>
        <translation>缩放鼠标处的图像或时间</translation>
    </message>
    <message>
        <source>Shift+wheel</source>
        <translation>Shift+滚轮</translation>
    </message>
    <message>
        <source>Scroll through time</source>
        <translation>沿时间滚动</translation>
    </message>
    <message>
        <source>1, 2, 3, 4</source>
        <translation>1、2、3、4</translation>
    </message>
    <message>
        <source>Front, top, side, isometric view, in the reconstruction</source>
        <translation>在重建视图中：前、顶、侧、等轴测视图</translation>
    </message>
    <message>
        <source>F11</source>
        <translation>F11</translation>
    </message>
    <message>
        <source>Full screen</source>
        <translation>全屏</translation>
    </message>
    <message>
        <source>Shift+F1</source>
        <translation>Shift+F1</translation>
    </message>
    <message>
        <source>What&apos;s This</source>
        <translation>这是什么</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>按键</translation>
    </message>
    <message>
        <source>Effect</source>
        <translation>作用</translation>
    </message>
    <message>
        <source>Shortcuts</source>
        <translation>快捷键</translation>
    </message>
    <message>
        <source>Space, P</source>
        <translation>空格键、P</translation>
    </message>
    <message>
        <source>Play or pause; pen</source>
        <translation>播放或暂停；画笔</translation>
    </message>
    <message>
        <source>Ctrl+N, O, S, Shift+S, E</source>
        <translation>Ctrl+N、O、S、Shift+S、E</translation>
    </message>
    <message>
        <source>New, open, save, save as, export</source>
        <translation>新建、打开、保存、另存为、导出</translation>
    </message>
    <message>
        <source>Ctrl+Z, Ctrl+Y</source>
        <translation>Ctrl+Z、Ctrl+Y</translation>
    </message>
    <message>
        <source>Ctrl+X, C, V, Shift+V, D</source>
        <translation>Ctrl+X、C、V、Shift+V、D</translation>
    </message>
    <message>
        <source>Cut, copy, paste in place, paste at the playhead, duplicate</source>
        <translation>剪切、复制、原位粘贴、粘贴到播放头、创建副本</translation>
    </message>
    <message>
        <source>,  .  with Shift</source>
        <translation>,  .  可加 Shift</translation>
    </message>
    <message>
        <source>N, Shift+N</source>
        <translation>N、Shift+N</translation>
    </message>
    <message>
        <source>Next or previous object</source>
        <translation>下一个或上一个对象</translation>
    </message>
    <message>
        <source>Enter, Insert, Delete</source>
        <translation>Enter、Insert、Delete</translation>
    </message>
    <message>
        <source>Type numbers, add a breakpoint at the playhead, delete</source>
        <translation>输入数值、在播放头处添加节点、删除</translation>
    </message>
    <message>
        <source>Arrow keys, with Shift</source>
        <translation>方向键，可加 Shift</translation>
    </message>
    <message>
        <source>[  ]  \</source>
        <translation>[  ]  \</translation>
    </message>
    <message>
        <source>Ctrl+[, Ctrl+], Ctrl+M, Ctrl+L</source>
        <translation>Ctrl+[、Ctrl+]、Ctrl+M、Ctrl+L</translation>
    </message>
    <message>
        <source>Rotate around the ring, mirror, other arm</source>
        <translation>沿环旋转、镜像、换到另一只手臂</translation>
    </message>
    <message>
        <source>Ctrl+Alt+1 to 5</source>
        <translation>Ctrl+Alt+1 至 5</translation>
    </message>
    <message>
        <source>Add a sweep, ring, phantom, ramp, pulse train at the playhead</source>
        <translation>在播放头处添加扫动、环绕、幻象、斜坡、脉冲串</translation>
    </message>
    <message>
        <source>Ctrl++, Ctrl+-, Ctrl+0</source>
        <translation>Ctrl++、Ctrl+-、Ctrl+0</translation>
    </message>
    <message>
        <source>Zoom in, out, to fit</source>
        <translation>放大、缩小、适合窗口</translation>
    </message>
    <message>
        <source>F2, Ctrl+D, Delete, Ctrl+Z</source>
        <translation>F2、Ctrl+D、Delete、Ctrl+Z</translation>
    </message>
    <message>
        <source>Rename, duplicate, delete, undo, in the library</source>
        <translation>在图案库中：重命名、创建副本、删除、撤销</translation>
    </message>
    <message>
        <source>Ctrl+R, M</source>
        <translation>Ctrl+R、M</translation>
    </message>
    <message>
        <source>Record, mark this moment in the recording</source>
        <translation>记录；在记录中标记此刻</translation>
    </message>
    <message>
        <source>F1</source>
        <translation>F1</translation>
    </message>
    <message>
        <source>Handbook: the page on what is shown</source>
        <translation>手册：有关当前画面的页面</translation>
    </message>
    <message>
        <source>Ctrl+1 to 6</source>
        <translation>Ctrl+1 至 6</translation>
    </message>
    <message>
        <source>Page Operate, Patterns, Study, Calibrate, Cost, Plot</source>
        <translation>“操作”、“图案”、“研究”、“标定”、“代价”、“绘图”页</translation>
    </message>
    <message>
        <source>F5, Shift+F5, Ctrl+F5</source>
        <translation>F5、Shift+F5、Ctrl+F5</translation>
    </message>
    <message>
        <source>Run the program of the arm, hold it, restart it</source>
        <translation>运行机械臂的程序、保持、重新开始</translation>
    </message>
    <message>
        <source>Ctrl+Shift+N</source>
        <translation>Ctrl+Shift+N</translation>
    </message>
    <message>
        <source>Forget the explored contour</source>
        <translation>清除已探索的轮廓</translation>
    </message>
    <message>
        <source>Undo, redo: marks on the page Operate, edits on the pages Patterns and Calibrate</source>
        <translation>撤销、重做：“操作”页上的标记，“图案”页和“标定”页上的编辑</translation>
    </message>
    <message>
        <source>STOP: everything that moves stops at once</source>
        <translation>STOP：立即停止一切运动</translation>
    </message>
    <message>
        <source>Previous or next breakpoint; with Shift, add it to the selection</source>
        <translation>上一个或下一个节点；按住 Shift 则加入所选内容</translation>
    </message>
    <message>
        <source>Move the selection; without one, the playhead and the lane</source>
        <translation>移动所选内容，无选择时移动播放头和轨道</translation>
    </message>
    <message>
        <source>Loop start, loop end, no loop</source>
        <translation>循环起点、循环终点、取消循环</translation>
    </message>
    <message>
        <source>Everywhere</source>
        <translation>任何位置</translation>
    </message>
    <message>
        <source>On the page Operate</source>
        <translation>“操作”页</translation>
    </message>
    <message>
        <source>In the playback bar</source>
        <translation>播放栏</translation>
    </message>
    <message>
        <source>On the page Patterns</source>
        <translation>“图案”页</translation>
    </message>
    <message>
        <source>In the timeline of a pattern</source>
        <translation>图案的时间轴</translation>
    </message>
    <message>
        <source>In pictures and charts</source>
        <translation>图像和图表</translation>
    </message>
    <message>
        <source>Ctrl+Alt+C</source>
        <translation>Ctrl+Alt+C</translation>
    </message>
    <message>
        <source>Release control of the site</source>
        <translation>释放站点的控制权</translation>
    </message>
    <message>
        <source>Ctrl+,</source>
        <translation>Ctrl+,</translation>
    </message>
    <message>
        <source>Preferences</source>
        <translation>首选项</translation>
    </message>
    <message>
        <source>Shift with Q W E R, A S D F</source>
        <translation>Shift 加 Q W E R、A S D F</translation>
    </message>
    <message>
        <source>Move the arm, in Jog</source>
        <translation>移动机械臂（点动）</translation>
    </message>
    <message>
        <source>Ctrl+Shift+M</source>
        <translation>Ctrl+Shift+M</translation>
    </message>
    <message>
        <source>Show one view alone, or all again; a double click on its title does the same</source>
        <translation>仅显示一个视图，或恢复全部；双击其标题效果相同</translation>
    </message>
    <message>
        <source>Ctrl+W</source>
        <translation>Ctrl+W</translation>
    </message>
    <message>
        <source>Close the source that is shown</source>
        <translation>关闭当前显示的来源</translation>
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
        <translation>另一个程序正在 %1 上播放。</translation>
    </message>
    <message>
        <source>it to be closed there first</source>
        <translation>请先在那里将其关闭</translation>
    </message>
    <message>
        <source>The sound card %1 cannot be opened: %2</source>
        <translation>无法打开声卡 %1：%2</translation>
    </message>
    <message>
        <source>Other programs can play on %1 as well.</source>
        <translation>其他程序也可以在 %1 上播放。</translation>
    </message>
    <message>
        <source>the card itself, as alsa:hw:CARD=NAME, or shared = true in the device file</source>
        <translation>声卡本身，如 alsa:hw:CARD=NAME，或设备文件中的 shared = true</translation>
    </message>
    <message>
        <source>The sound card takes none of the known formats.</source>
        <translation>声卡不接受任何已知格式。</translation>
    </message>
    <message>
        <source>The sound card does not play %1 samples a second.</source>
        <translation>声卡不支持每秒 %1 个采样。</translation>
    </message>
    <message>
        <source>another sample_rate_Hz in the device file</source>
        <translation>设备文件中的其他 sample_rate_Hz</translation>
    </message>
    <message numerus="yes">
        <source>The sound card has %n output(s).</source>
        <translation>
            <numerusform>声卡有 %n 个输出。</numerusform>
        </translation>
    </message>
    <message>
        <source>an output %1, as channels says</source>
        <translation>channels 所写的输出 %1</translation>
    </message>
    <message>
        <source>The sound card does not take %1 samples at a time.</source>
        <translation>声卡不支持一次 %1 个采样。</translation>
    </message>
    <message>
        <source>another period_frames in the device file</source>
        <translation>设备文件中的其他 period_frames</translation>
    </message>
</context>
<context>
    <name>ArmChainText</name>
    <message>
        <source>interrupted</source>
        <translation>工作被中断</translation>
    </message>
    <message>
        <source>nobody published %1 in domain %2 within %3 s</source>
        <translation>在 %3 s 内，域 %2 中没有程序发布 %1</translation>
    </message>
    <message>
        <source>a publisher that is reliable and transient local</source>
        <translation>设为 reliable 且保留已发送数据的发布者</translation>
    </message>
    <message>
        <source>the robot in this domain, or description = &quot;FILE.urdf&quot;</source>
        <translation>此域中的机器人，或 description = &quot;FILE.urdf&quot;</translation>
    </message>
    <message>
        <source>two joints of the arm have the ROS name &quot;%1&quot;</source>
        <translation>机械臂有两个关节在传输中都名为“%1”</translation>
    </message>
    <message>
        <source>a unique name for each joint in [joint_names]</source>
        <translation>[joint_names] 中每个关节只命名一次</translation>
    </message>
    <message>
        <source>the description gives no velocity limit for %1</source>
        <translation>描述中未给出 %1 的速度</translation>
    </message>
    <message>
        <source>[joint_names] names %1, which is not in the description</source>
        <translation>[joint_names] 列出了 %1，而描述中没有它</translation>
    </message>
    <message>
        <source>effort_stop has %1 numbers, the arm has %2 joints</source>
        <translation>effort_stop 有 %1 个数，而机械臂有 %2 个关节</translation>
    </message>
    <message>
        <source>effort_contains_gravity needs the mass of every link; %1 has none</source>
        <translation>effort_contains_gravity 需要全部质量；%1 没有质量</translation>
    </message>
    <message>
        <source>the file requires %1, which is not monitored when the arm is driven directly</source>
        <translation>文件要求 %1，而此处不对其进行监视</translation>
    </message>
    <message>
        <source>MoveIt Servo compares stamps with the robot&apos;s clock, so only teleta-site sends commands to it</source>
        <translation>MoveIt Servo 用机器人的时钟比较时间戳，因此只有 teleta-site 向它发送指令</translation>
    </message>
    <message>
        <source>force_stop_N needs a force sensor: wrench = &quot;FILE&quot; names the file of one</source>
        <translation>force_stop_N 需要力传感器：wrench = &quot;文件&quot; 指明传感器的文件</translation>
    </message>
    <message>
        <source>the force sensor is in the frame %1, which the description does not have</source>
        <translation>力传感器所在的坐标系 %1 不在描述中</translation>
    </message>
    <message>
        <source>the force sensor must be in the domain of the arm, over the same interface</source>
        <translation>力传感器必须与机械臂在同一个域中，并使用同一接口</translation>
    </message>
</context>
<context>
    <name>ArmCommand</name>
    <message>
        <source>no end</source>
        <translation>无限位</translation>
    </message>
    <message>
        <source>not stated</source>
        <translation>未给出</translation>
    </message>
    <message>
        <source>cannot be moved: the description states no speed</source>
        <translation>无法移动：描述中没有给出速度</translation>
    </message>
    <message>
        <source>Chain, limits and mass of an arm, and what cannot be moved</source>
        <translation>机械臂的运动链、限位和质量，以及无法移动的部分</translation>
    </message>
    <message>
        <source>URDF file, or the name of one that comes with the program: %1</source>
        <translation>URDF 文件，或程序自带 URDF 的名称：%1</translation>
    </message>
    <message>
        <source>Link that stands still; default: the root</source>
        <translation>静止不动的连杆；默认：根连杆</translation>
    </message>
    <message>
        <source>Link that is moved; default: tool0, flange or ee_link, else the end of the longest chain</source>
        <translation>被移动的连杆；默认：tool0、flange 或 ee_link，否则为最长运动链的末端</translation>
    </message>
    <message>
        <source>Joint</source>
        <translation>关节</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>类型</translation>
    </message>
    <message>
        <source>Range</source>
        <translation>范围</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>Effort</source>
        <translation>力/力矩</translation>
    </message>
    <message>
        <source>shown, not moved</source>
        <translation>显示但不移动</translation>
    </message>
    <message>
        <source>follows %1</source>
        <translation>跟随 %1</translation>
    </message>
    <message numerus="yes">
        <source>%1: %n joint(s) from %2 to %3</source>
        <translation>
            <numerusform>%1：从 %2 到 %3 共 %n 个关节</numerusform>
        </translation>
    </message>
    <message>
        <source>The link &apos;%1&apos; has no mass, so the torque of gravity is not known.</source>
        <translation>连杆“%1”没有质量，因此重力力矩未知。</translation>
    </message>
    <message>
        <source>%1 kg are moved.</source>
        <translation>移动的质量为 %1 kg。</translation>
    </message>
    <message>
        <source>Joint to move, as the URDF names it</source>
        <translation>要移动的关节，采用 URDF 中的名称</translation>
    </message>
    <message>
        <source>Speed in rad/s, of a prismatic joint in m/s</source>
        <translation>速度，单位 rad/s；移动关节为 m/s</translation>
    </message>
    <message>
        <source>Duration of the motion, at most %1</source>
        <translation>移动的时长，至多 %1</translation>
    </message>
    <message>
        <source>Move without asking</source>
        <translation>不经询问直接移动</translation>
    </message>
    <message>
        <source>Show the description of a robot arm (URDF), or jog an arm</source>
        <translation>机械臂：描述 (URDF)，以及移动关节</translation>
    </message>
    <message>
        <source>Move a joint of an arm for a short time</source>
        <translation>让机械臂的一个关节短时间运动</translation>
    </message>
    <message>
        <source>File that describes the arm (kind = &quot;ros_arm&quot;), or with which its site is reached (kind = &quot;remote_site&quot;)</source>
        <translation>描述机械臂的文件（kind = &quot;ros_arm&quot;），或用于连接其站点的文件（kind = &quot;remote_site&quot;）</translation>
    </message>
    <message>
        <source>Which arm of a site; default: its only one</source>
        <translation>站点的哪个机械臂；默认：唯一的一个</translation>
    </message>
</context>
<context>
    <name>ArmJogText</name>
    <message>
        <source>the arm cannot be moved: %1</source>
        <translation>无法移动机械臂：%1</translation>
    </message>
    <message>
        <source>no joint states were received</source>
        <translation>未收到关节状态</translation>
    </message>
    <message>
        <source>%1 moved %2 %3 in %4 s.</source>
        <translation>%1 在 %4 s 内移动了 %2 %3。</translation>
    </message>
    <message>
        <source>It was at rest %1 s after the command ended.</source>
        <translation>指令结束 %1 s 后静止。</translation>
    </message>
    <message>
        <source>It was not seen to come to rest.</source>
        <translation>未观测到其静止。</translation>
    </message>
    <message>
        <source>Active limits: %1.</source>
        <translation>起作用的限制：%1。</translation>
    </message>
    <message>
        <source>there is no terminal to ask on; add --yes to move the arm</source>
        <translation>没有可供询问的终端，移动机械臂需要 --yes</translation>
    </message>
    <message>
        <source>This moves %1 of %2 at %3 %4/s for %5 s. Type &quot;yes&quot; to move it: </source>
        <translation>这将使 %2 的 %1 以 %3 %4/s 移动 %5 s。键入 &quot;yes&quot; 以移动： </translation>
    </message>
    <message>
        <source>nothing was moved</source>
        <translation>未移动任何部分</translation>
    </message>
    <message>
        <source>the motion was cut short: %1</source>
        <translation>运动被中断：%1</translation>
    </message>
</context>
<context>
    <name>ArmServoTexts</name>
    <message>
        <source>Follow a point</source>
        <translation>跟随一点</translation>
    </message>
    <message>
        <source>Explore an edge</source>
        <translation>探索边缘</translation>
    </message>
    <message>
        <source>Roll about a point</source>
        <translation>绕点滚动</translation>
    </message>
    <message>
        <source>Co-manipulation</source>
        <translation>协同操作</translation>
    </message>
    <message>
        <source>The next press is a rehearsal. Only a shadow of the arm moves, and the arm gets no command.</source>
        <translation>下一次按下是预演。只有机械臂的影子运动，机械臂不会收到指令。</translation>
    </message>
    <message>
        <source>REHEARSAL: the arm gets no command. Its shadow touches a ball that is assumed in front of the pad.</source>
        <translation>预演：机械臂不会收到指令。它的影子接触假定位于触觉垫前方的球。</translation>
    </message>
    <message>
        <source>REHEARSAL: the arm gets no command. Its shadow touches an edge that is assumed in front of the pad.</source>
        <translation>预演：机械臂不会收到指令。它的影子接触假定位于触觉垫前方的边缘。</translation>
    </message>
    <message>
        <source>Rehearsed. The next press MOVES THE ARM.</source>
        <translation>已预演。下一次按下将移动机械臂。</translation>
    </message>
    <message>
        <source>THE ARM MOVES as long as you hold the switch.</source>
        <translation>只要您按住开关，机械臂就会运动。</translation>
    </message>
    <message>
        <source>The rehearsal was too short to count.</source>
        <translation>预演太短，不算数。</translation>
    </message>
    <message>
        <source>Ended: STOP was engaged.</source>
        <translation>已结束：STOP 被按下。</translation>
    </message>
    <message>
        <source>Ended: the frames of the pad are old.</source>
        <translation>已结束：触觉垫的帧过旧。</translation>
    </message>
    <message>
        <source>Ended: the arm took no commands: %1.</source>
        <translation>已结束：机械臂不接受指令：%1。</translation>
    </message>
    <message>
        <source>Ended: the contact was lost, and the search did not find it.</source>
        <translation>已结束：接触丢失，搜索未能找回。</translation>
    </message>
    <message>
        <source>Ended: nothing was touched within %1.</source>
        <translation>已结束：%1 内没有接触到任何东西。</translation>
    </message>
    <message>
        <source>Ended: the pad went %1 into what it touches and felt less than half of the force.</source>
        <translation>已结束：触觉垫压入所接触的物体 %1，感到的力不到一半。</translation>
    </message>
    <message>
        <source>Ended: the shadow could not follow.</source>
        <translation>已结束：影子无法跟随。</translation>
    </message>
    <message>
        <source>The task is done.</source>
        <translation>任务已完成。</translation>
    </message>
    <message>
        <source>Ended: the joint readings are old or unusable.</source>
        <translation>已结束：关节读数过旧或不可用。</translation>
    </message>
    <message>
        <source>The arm was moved otherwise: rehearse the task again.</source>
        <translation>机械臂被以其他方式移动：请重新预演任务。</translation>
    </message>
    <message>
        <source>The task was changed: rehearse it again.</source>
        <translation>任务已更改：请重新预演。</translation>
    </message>
    <message>
        <source>Ended: a joint is at the end of its range.</source>
        <translation>已结束：一个关节已到达其范围的极限。</translation>
    </message>
    <message>
        <source>Ended: the commands came too late, or the arm took none.</source>
        <translation>已结束：指令到达过晚，或机械臂不接受指令。</translation>
    </message>
</context>
<context>
    <name>ArmWatch</name>
    <message>
        <source>--viewer with the file of a viewer</source>
        <translation>--viewer 加上观察者的文件</translation>
    </message>
    <message>
        <source>this site has certificates, so a viewer with keys of its own has to watch the arm</source>
        <translation>此站点使用证书，因此须由拥有自己密钥的观察者监视机械臂</translation>
    </message>
    <message>
        <source>no position of this joint was received within 5 s</source>
        <translation>5 秒内没有收到该关节的位置</translation>
    </message>
    <message>
        <source>--joint with a joint that the arm reports</source>
        <translation>--joint 加上机械臂报告的关节</translation>
    </message>
</context>
<context>
    <name>ArrayFramesText</name>
    <message>
        <source>the file has no arrays</source>
        <translation>文件中没有数组</translation>
    </message>
    <message>
        <source>frames of an array</source>
        <translation>阵列的帧</translation>
    </message>
    <message>
        <source>there is no array %1; the file has: %2</source>
        <translation>没有数组 %1；文件中有：%2</translation>
    </message>
    <message>
        <source>one of these</source>
        <translation>其中之一</translation>
    </message>
    <message>
        <source>no array can be frames; the file has: %1</source>
        <translation>没有可作为帧的数组；文件中有：%1</translation>
    </message>
    <message>
        <source>an array of 3 dimensions: frames x rows x columns</source>
        <translation>三维数组：帧 x 行 x 列</translation>
    </message>
    <message>
        <source>the name of one (--array NAME)</source>
        <translation>其中一个的名称（--array NAME）</translation>
    </message>
    <message>
        <source>the array %1: %2</source>
        <translation>数组 %1：%2</translation>
    </message>
    <message>
        <source>a time in s for each frame</source>
        <translation>每帧一个以 s 为单位的时间</translation>
    </message>
    <message>
        <source>time_s has the shape %1, the frames have %2</source>
        <translation>time_s 的形状为 %1，帧的形状为 %2</translation>
    </message>
    <message>
        <source>the array has %1 instead of %2 values</source>
        <translation>数组有 %1 个值，应为 %2 个</translation>
    </message>
    <message>
        <source>a whole file</source>
        <translation>完整的文件</translation>
    </message>
    <message>
        <source>a frame of the array</source>
        <translation>阵列的一帧</translation>
    </message>
    <message>
        <source>a frame of %1 has %2 x %3 taxels</source>
        <translation>%1 的一帧有 %2 x %3 个触觉单元</translation>
    </message>
    <message>
        <source>from 1 to %1 rows and columns</source>
        <translation>1 至 %1 行和列</translation>
    </message>
    <message>
        <source>the frames have %1 rows x %2 columns</source>
        <translation>帧为 %1 行 x %2 列</translation>
    </message>
    <message>
        <source>%1 rows x %2 columns</source>
        <translation>%1 行 x %2 列</translation>
    </message>
    <message>
        <source>%1 has %2 taxels</source>
        <translation>%1 有 %2 个触觉单元</translation>
    </message>
    <message>
        <source>the file does not say when its frames were taken</source>
        <translation>文件未说明各帧的采集时间</translation>
    </message>
    <message>
        <source>frames per second (--rate HZ), or times in time_s</source>
        <translation>每秒帧数（--rate HZ），或 time_s 中的时间</translation>
    </message>
    <message>
        <source>the time of frame %1 is not a finite number</source>
        <translation>帧 %1 的时间不是有限数</translation>
    </message>
    <message>
        <source>a finite time in s</source>
        <translation>以 s 为单位的有限时间</translation>
    </message>
    <message>
        <source>the time goes back at frame %1, from %2 s to %3 s</source>
        <translation>时间在帧 %1 处倒退，从 %2 s 到 %3 s</translation>
    </message>
    <message>
        <source>times that do not decrease</source>
        <translation>不递减的时间</translation>
    </message>
    <message>
        <source>an array of real numbers</source>
        <translation>实数数组</translation>
    </message>
    <message>
        <source>the array has the shape %1</source>
        <translation>数组的形状为 %1</translation>
    </message>
    <message>
        <source>frames x rows x columns, or frames x taxels</source>
        <translation>帧 x 行 x 列，或帧 x 触觉单元</translation>
    </message>
    <message>
        <source>the array is too large: %1</source>
        <translation>数组过大：%1</translation>
    </message>
    <message>
        <source>at most %1 values</source>
        <translation>至多 %1 个值</translation>
    </message>
    <message>
        <source>the recording has no frames</source>
        <translation>记录中没有帧</translation>
    </message>
    <message>
        <source>at least one frame</source>
        <translation>至少一帧</translation>
    </message>
    <message>
        <source>time_s has %1 times for %2 frames</source>
        <translation>time_s 有 %1 个时间，而帧数为 %2</translation>
    </message>
    <message>
        <source>the file has times of its own, in time_s</source>
        <translation>文件自带时间，位于 time_s 中</translation>
    </message>
    <message>
        <source>no rate</source>
        <translation>不指定帧率</translation>
    </message>
    <message>
        <source>several arrays can be the frames: %1</source>
        <translation>有多个数组可以是帧：%1</translation>
    </message>
    <message>
        <source>%1 does not say which dimension is the frames</source>
        <translation>%1 没有说明哪一维是帧数</translation>
    </message>
    <message>
        <source>a frame of %1 has the shape %2 x %3</source>
        <translation>%1 的一帧形状为 %2 x %3</translation>
    </message>
    <message>
        <source>%1 taxels x 3, as the layout has them</source>
        <translation>按布局为 %1 个触觉单元 x 3</translation>
    </message>
    <message>
        <source>%1 rows x %2 columns, as the layout has them</source>
        <translation>按布局为 %1 行 x %2 列</translation>
    </message>
    <message>
        <source>%1 can be a grid of 3 columns, or %2 taxels with x, y and z each</source>
        <translation>%1 可能是 3 列的网格，也可能是各有 x、y、z 的 %2 个触觉单元</translation>
    </message>
    <message>
        <source>%1 has %2 numbers</source>
        <translation>%1有 %2 个数</translation>
    </message>
    <message>
        <source>%1, as the layout has them</source>
        <translation>按布局为 %1 个</translation>
    </message>
    <message>
        <source>the taxels have places of their own, in positions_m</source>
        <translation>触觉单元有各自的位置，见 positions_m</translation>
    </message>
    <message>
        <source>the file that says where the taxels are (--layout FILE.toml)</source>
        <translation>说明触觉单元位置的文件（--layout FILE.toml）</translation>
    </message>
    <message>
        <source>a frame of the array has %1 numbers</source>
        <translation>数组的一帧有 %1 个数</translation>
    </message>
    <message>
        <source>the layout with which the frames were recorded</source>
        <translation>记录这些帧时所用的布局</translation>
    </message>
    <message>
        <source>positions_m has the shape %1, but the layout has %2 taxels</source>
        <translation>positions_m 的形状为 %1，但布局有 %2 个触觉单元</translation>
    </message>
    <message>
        <source>positions_m has taxel %1 at %2 = %3 mm, the layout at %4 mm</source>
        <comment>a number, x, y or z, two places</comment>
        <translation>positions_m 中触觉单元 %1 位于 %2 = %3 mm，布局中位于 %4 mm</translation>
    </message>
    <message>
        <source>the dimension that counts the frames, the first or the last (--frame-axis), or a time_s for each frame</source>
        <translation>计帧的维度，第一维或最后一维（--frame-axis），或每帧一个 time_s</translation>
    </message>
    <message>
        <source>for the grid, %1 rows and 3 columns (--rows %1 --columns 3); for vectors, the file that says where the taxels are (--layout FILE.toml)</source>
        <translation>网格用 %1 行和 3 列（--rows %1 --columns 3）；向量用说明触觉单元位置的文件（--layout FILE.toml）</translation>
    </message>
    <message>
        <source>%1 = %2 rows x %3 columns, or others (--rows N --columns M)</source>
        <translation>%1 = %2 行 x %3 列，或其他行列数（--rows N --columns M）</translation>
    </message>
</context>
<context>
    <name>ArrayMessageText</name>
    <message>
        <source>a message has %1 numbers, the file has %2 x %3 taxels</source>
        <translation>一条消息有 %1 个数，文件有 %2 x %3 个触觉单元</translation>
    </message>
    <message>
        <source>a message has %1 x %2 numbers, the file has %3 x %4 taxels</source>
        <translation>一条消息有 %1 x %2 个数，文件有 %3 x %4 个触觉单元</translation>
    </message>
    <message>
        <source>a message has %1 bytes, its size says %2</source>
        <translation>一条消息有 %1 个字节，按其尺寸应为 %2 个</translation>
    </message>
    <message>
        <source>a message has %1 sensors</source>
        <translation>一条消息有 %1 个传感器</translation>
    </message>
    <message>
        <source>sensor = &quot;NAME&quot; in the file</source>
        <translation>文件中的 sensor = &quot;名称&quot;</translation>
    </message>
    <message>
        <source>a message has %1 dimensions</source>
        <translation>一条消息有 %1 个维度</translation>
    </message>
    <message>
        <source>rows and columns</source>
        <translation>行和列</translation>
    </message>
    <message>
        <source>a message has the encoding &quot;%1&quot;</source>
        <translation>一条消息的编码为“%1”</translation>
    </message>
</context>
<context>
    <name>BakeText</name>
    <message>
        <source>the pattern has too many corners</source>
        <translation>图案的拐点过多</translation>
    </message>
    <message>
        <source>at most %1 breakpoints</source>
        <translation>至多 %1 个节点</translation>
    </message>
</context>
<context>
    <name>BoardCorners</name>
    <message>
        <source>a whole chessboard of %1 x %2 inner corners, in focus and evenly lit</source>
        <translation>内角点为 %1 x %2 的完整棋盘，对焦清晰、照明均匀</translation>
    </message>
    <message>
        <source>only %1 of the %2 corners of the chessboard are found</source>
        <translation>棋盘的 %2 个角点中只找到 %1 个</translation>
    </message>
</context>
<context>
    <name>Bracelet</name>
    <message>
        <source>The connection to the bracelet was lost.</source>
        <translation>与手环的连接已断开。</translation>
    </message>
    <message>
        <source>a feature report of layout version %1</source>
        <translation>布局版本为 %1 的特征报告</translation>
    </message>
    <message>
        <source>Bracelet %1</source>
        <translation>手环 %1</translation>
    </message>
    <message>
        <source>The device does not respond like a bracelet.</source>
        <translation>设备的应答不像手环。</translation>
    </message>
</context>
<context>
    <name>BraceletContent</name>
    <message>
        <source>Participant</source>
        <translation>被试</translation>
    </message>
    <message>
        <source>Condition</source>
        <translation>条件</translation>
    </message>
    <message>
        <source>Track</source>
        <translation>序列</translation>
    </message>
    <message>
        <source>Best onset, ms</source>
        <translation>最佳起始间隔，ms</translation>
    </message>
    <message>
        <source>95 %</source>
        <translation>95 %</translation>
    </message>
    <message>
        <source>By the law, ms</source>
        <translation>按规律，ms</translation>
    </message>
    <message>
        <source>What it says</source>
        <translation>说明</translation>
    </message>
    <message>
        <source>Time from burst to burst at which most answers are yes: the top of a parabola on the probit scale</source>
        <translation>回答“是”最多时短振之间的时间：probit 尺度上抛物线的顶点</translation>
    </message>
    <message>
        <source>By the delta method; of all participants Student&apos;s t of their best onsets</source>
        <translation>用 delta 法；全体参与者用其最佳起始间隔的学生 t 区间</translation>
    </message>
    <message>
        <source>0.32 times the length of a burst + 47.3 ms, the law of apparent motion</source>
        <translation>短振时长的 0.32 倍 + 47.3 ms，即似动规律</translation>
    </message>
    <message>
        <source>nobody has a best onset</source>
        <translation>没有人有最佳起始间隔</translation>
    </message>
    <message>
        <source>fewer than three times were shown</source>
        <translation>所呈现的时间少于三个</translation>
    </message>
    <message>
        <source>no onset is best: the answers have no top</source>
        <translation>没有最佳起始间隔：回答没有顶点</translation>
    </message>
    <message>
        <source>best beyond the times that were shown</source>
        <translation>最佳值在所呈现的时间之外</translation>
    </message>
    <message>
        <source>mean of %1</source>
        <translation>%1 人的平均</translation>
    </message>
    <message>
        <source>later than the law says</source>
        <translation>晚于规律所述</translation>
    </message>
    <message>
        <source>earlier than the law says</source>
        <translation>早于规律所述</translation>
    </message>
    <message>
        <source>agrees with the law</source>
        <translation>与规律一致</translation>
    </message>
    <message>
        <source>All</source>
        <translation>全部</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>级数</translation>
    </message>
    <message>
        <source>Steps of one JND each from the start of the motors to their full drive. The JND is linear between the references, and stays as it is beyond them</source>
        <translation>从电机启动到满驱动，每级为一个JND。JND在参考之间线性变化，之外保持不变</translation>
    </message>
    <message>
        <source>by the mean JND of all</source>
        <translation>按全体的平均JND</translation>
    </message>
    <message numerus="yes">
        <source>by the JND at %n reference(s)</source>
        <translation>
            <numerusform>按 %n 个参考处的JND</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 of %2 references have a JND</source>
        <translation>%2 个参考中有 %1 个具有JND</translation>
    </message>
    <message>
        <source>Tactor</source>
        <translation>振子</translation>
    </message>
    <message>
        <source>Feels equal at</source>
        <translation>感觉相等于</translation>
    </message>
    <message>
        <source>That is, drive</source>
        <translation>对应驱动</translation>
    </message>
    <message>
        <source>Full drive now</source>
        <translation>当前满驱动</translation>
    </message>
    <message>
        <source>Full drive, balanced</source>
        <translation>平衡后的满驱动</translation>
    </message>
    <message>
        <source>Level at which it feels as strong as the reference</source>
        <translation>感觉与参考同样强的水平</translation>
    </message>
    <message>
        <source>? stands for an open end</source>
        <translation>? 表示该端未定</translation>
    </message>
    <message>
        <source>Share of the full voltage, by the motor&apos;s start and full drive</source>
        <translation>占满电压的比例，由电机的启动与满驱动得出</translation>
    </message>
    <message>
        <source>Share of the full voltage at intensity 1</source>
        <translation>强度为 1 时占满电压的比例</translation>
    </message>
    <message>
        <source>With it the tactors feel equally strong: the strongest ones are turned down</source>
        <translation>据此各振子感觉同样强：最强的被调低</translation>
    </message>
    <message>
        <source>%1, the reference</source>
        <translation>%1（参考）</translation>
    </message>
    <message>
        <source>Measured against tactor %1, tactor %2 differs by more than both intervals allow.</source>
        <comment>a tactor; a list of tactors</comment>
        <translation>以振子 %1 为参考测量时，振子 %2 的差异超出了两个区间的允许范围。</translation>
    </message>
</context>
<context>
    <name>BraceletText</name>
    <message>
        <source>No bracelet is plugged in.</source>
        <translation>未插入手环。</translation>
    </message>
    <message>
        <source>a USB device %1</source>
        <translation>USB 设备 %1</translation>
    </message>
    <message>
        <source>a USB device %1 with the serial number %2</source>
        <translation>USB 设备 %1，序列号 %2</translation>
    </message>
    <message>
        <source>No permission to open the bracelet at %1.</source>
        <translation>没有权限打开位于 %1 的手环。</translation>
    </message>
    <message>
        <source>read and write access, which the udev rule grants</source>
        <translation>对它的读写权限，由 udev 规则授予</translation>
    </message>
    <message>
        <source>Another program uses the bracelet at %1.</source>
        <translation>另一个程序正在使用位于 %1 的手环。</translation>
    </message>
    <message>
        <source>it to be closed there first</source>
        <translation>先在该程序中将其关闭</translation>
    </message>
    <message>
        <source>The bracelet at %1 cannot be opened.</source>
        <translation>无法打开位于 %1 的手环。</translation>
    </message>
</context>
<context>
    <name>BraceletTexts</name>
    <message>
        <source>STOP is engaged: the bracelet is off.</source>
        <translation>STOP 已触发：手环已关闭。</translation>
    </message>
    <message>
        <source>No bracelet: what would be played is named in the table of patterns.</source>
        <translation>无手环：将要播放的内容列在图案表中。</translation>
    </message>
    <message>
        <source>Connecting to the bracelet…</source>
        <translation>正在连接手环…</translation>
    </message>
    <message>
        <source>The bracelet is not connected. %1</source>
        <translation>手环未连接。%1</translation>
    </message>
    <message>
        <source>The bracelet does not answer.</source>
        <translation>手环没有响应。</translation>
    </message>
    <message>
        <source>The bracelet is too hot: it is off until it has cooled down.</source>
        <translation>手环过热：冷却之前保持关闭。</translation>
    </message>
    <message>
        <source>A study uses the bracelet.</source>
        <translation>研究正在使用手环。</translation>
    </message>
    <message>
        <source>The supply of the bracelet is low: %1 V.</source>
        <translation>手环供电电压过低：%1 V。</translation>
    </message>
    <message>
        <source>The supply of the bracelet is low.</source>
        <translation>手环供电电压过低。</translation>
    </message>
    <message>
        <source>The bracelet refused what was played last: it did not understand it.</source>
        <translation>手环拒绝了上次播放的内容：无法识别。</translation>
    </message>
    <message>
        <source>The motors are not calibrated (page Calibrate).</source>
        <translation>电机未标定（“标定”页）。</translation>
    </message>
    <message>
        <source>too hot: off until it has cooled down</source>
        <translation>过热：冷却之前保持关闭</translation>
    </message>
    <message>
        <source>supply low</source>
        <translation>供电电压过低</translation>
    </message>
    <message>
        <source>frames refused: %1</source>
        <translation>被拒绝的帧：%1</translation>
    </message>
    <message>
        <source>supply %1 V</source>
        <translation>供电电压 %1 V</translation>
    </message>
    <message>
        <source>temperature %1 °C</source>
        <translation>温度 %1 °C</translation>
    </message>
    <message>
        <source>Bracelet</source>
        <translation>手环</translation>
    </message>
    <message>
        <source>not calibrated: the motors are assumed</source>
        <translation>未标定：电机采用假定值</translation>
    </message>
    <message>
        <source>confirmed: played by the callback of the sound card</source>
        <translation>已确认：由声卡的回调播放</translation>
    </message>
    <message>
        <source>latency at most %1 ms, as stated, not measured</source>
        <translation>延迟至多 %1 ms，为声明值，未经测量</translation>
    </message>
    <message>
        <source>callback takes %1 % of a period, longest %2 %</source>
        <translation>回调占周期的 %1 %，最长 %2 %</translation>
    </message>
    <message>
        <source>periods missed: %1</source>
        <translation>错过的周期：%1</translation>
    </message>
    <message>
        <source>latency %1 ms, as measured</source>
        <translation>延迟 %1 ms，为测量值</translation>
    </message>
</context>
<context>
    <name>CalibrateCommand</name>
    <message>
        <source>Pairs</source>
        <translation>点对</translation>
    </message>
    <message>
        <source>Kept</source>
        <translation>保留</translation>
    </message>
    <message>
        <source>3D to 2D</source>
        <translation>3D 到 2D</translation>
    </message>
    <message>
        <source>%1 px on average, %2 px rms</source>
        <translation>平均 %1 px，均方根 %2 px</translation>
    </message>
    <message>
        <source>2D to 3D</source>
        <translation>2D 到 3D</translation>
    </message>
    <message>
        <source>%1 mm on average</source>
        <translation>平均 %1 mm</translation>
    </message>
    <message>
        <source>Uncertainty</source>
        <translation>不确定度</translation>
    </message>
    <message>
        <source>%1 mm of a point on the surface, by the camera alone</source>
        <translation>仅由相机引起的表面点不确定度 %1 mm</translation>
    </message>
    <message>
        <source>Valid radius</source>
        <translation>有效半径</translation>
    </message>
    <message>
        <source>%1 px</source>
        <translation>%1 px</translation>
    </message>
    <message>
        <source>Focal lengths</source>
        <translation>焦距</translation>
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
        <translation>相机中心</translation>
    </message>
    <message>
        <source>%1, %2, %3 m</source>
        <translation>%1, %2, %3 m</translation>
    </message>
    <message>
        <source>Mirrored</source>
        <translation>镜像</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>是</translation>
    </message>
    <message>
        <source>no</source>
        <translation>否</translation>
    </message>
    <message>
        <source>Residuals</source>
        <translation>残差</translation>
    </message>
    <message>
        <source>without a pattern</source>
        <translation>无规律</translation>
    </message>
    <message>
        <source>Width of the image, px</source>
        <translation>图像宽度，px</translation>
    </message>
    <message>
        <source>Height of the image, px</source>
        <translation>图像高度，px</translation>
    </message>
    <message>
        <source>Radius of the elastomer, mm</source>
        <translation>弹性体半径，mm</translation>
    </message>
    <message>
        <source>Length of the elastomer, from z = 0 of the sensor frame, mm</source>
        <translation>弹性体长度，自传感器坐标系 z = 0 起，mm</translation>
    </message>
    <message>
        <source>robust: camera and lens, wrong pairs are left out; paper: linear, without a lens, drops pairs that are off by more than 2 mm</source>
        <translation>robust：相机和镜头，剔除错误点对；paper：线性，不含镜头，剔除偏差超过 2 mm 的点对</translation>
    </message>
    <message>
        <source>The points are holes of a shell: their x and y times this factor are on the elastomer (the paper&apos;s shell: 0.97)</source>
        <translation>各点是外壳上的孔：x 和 y 乘以此系数后位于弹性体上（论文的外壳：0.97）</translation>
    </message>
    <message>
        <source>The camera that was written has no lens: it is off by %1 mm on average over the pairs that it kept (%2 of %3).</source>
        <translation>写出的相机没有镜头模型：在其保留的点对（%3 个中的 %2 个）上平均偏差 %1 mm。</translation>
    </message>
    <message>
        <source>the camera is written to this file</source>
        <translation>此文件用于写入相机</translation>
    </message>
    <message>
        <source>neighbours are alike: the camera does not explain everything in the pairs</source>
        <translation>相邻残差相似：点对中含有此相机模型未包含的因素</translation>
    </message>
    <message>
        <source>Write each pair and its residual as CSV</source>
        <translation>将每个点对及相机对它的计算结果写为 CSV</translation>
    </message>
    <message>
        <source>Reliable</source>
        <translation>可靠</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>警告</translation>
    </message>
    <message>
        <source>CSV with the columns u_px,v_px,x_m,y_m,z_m, at least 6 rows; with --plane a picture of a chessboard, or a picture or video of the gel at rest</source>
        <translation>含 u_px,v_px,x_m,y_m,z_m 列的 CSV，至少 6 行；使用 --plane 时为棋盘图像，或静止凝胶的图像或视频</translation>
    </message>
    <message>
        <source>Write the camera, or with --plane the lines for the sensor file, to this file</source>
        <translation>将相机写入此文件；使用 --plane 时写入传感器文件的各行</translation>
    </message>
    <message>
        <source>a file is needed</source>
        <translation>需要一个文件</translation>
    </message>
    <message>
        <source>Camera and lens of a tactile cylinder, or the plane of a flat gel</source>
        <translation>触觉圆柱的相机和镜头，或平面凝胶的平面</translation>
    </message>
    <message>
        <source>this is for a tactile cylinder, not for --plane</source>
        <translation>此选项用于触觉圆柱，不用于 --plane</translation>
    </message>
</context>
<context>
    <name>Camera</name>
    <message>
        <source>camera %1 cannot be opened</source>
        <translation>无法打开相机 %1</translation>
    </message>
    <message>
        <source>the file does not exist</source>
        <translation>文件不存在</translation>
    </message>
    <message>
        <source>this is a folder</source>
        <translation>这是文件夹</translation>
    </message>
    <message>
        <source>a video, or the number of a camera</source>
        <translation>视频，或相机编号</translation>
    </message>
    <message>
        <source>a video, a pattern like frame_%04d.png, or the number of a camera</source>
        <translation>视频、形如 frame_%04d.png 的编号格式，或相机编号</translation>
    </message>
    <message>
        <source>camera %1</source>
        <translation>相机 %1</translation>
    </message>
    <message>
        <source>no frame arrived</source>
        <translation>没有帧到来</translation>
    </message>
    <message>
        <source>the file is not a readable video</source>
        <translation>该文件不是可读取的视频</translation>
    </message>
    <message>
        <source>this is a pipe</source>
        <translation>这是管道</translation>
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
        <translation>沿管 %1，绕管 %2°</translation>
    </message>
    <message>
        <source>standard deviation %1</source>
        <translation>标准差 %1</translation>
    </message>
    <message>
        <source>moved %1 since it began</source>
        <translation>自开始以来移动了 %1</translation>
    </message>
    <message>
        <source>%1 deep</source>
        <translation>深 %1</translation>
    </message>
    <message>
        <source>No picture yet</source>
        <translation>尚无图像</translation>
    </message>
    <message>
        <source>BUMP</source>
        <translation>碰撞</translation>
    </message>
    <message>
        <source>followed</source>
        <translation>跟随中</translation>
    </message>
    <message>
        <source>PAUSED</source>
        <translation>已暂停</translation>
    </message>
    <message>
        <source>Displacement × %1</source>
        <translation>位移 × %1</translation>
    </message>
</context>
<context>
    <name>CameraText</name>
    <message>
        <source>a parameter is out of range</source>
        <translation>参数超出范围</translation>
    </message>
    <message>
        <source>the focal lengths in K are not positive</source>
        <translation>K 中的焦距不为正</translation>
    </message>
    <message>
        <source>the cylinder has no length</source>
        <translation>圆柱没有长度</translation>
    </message>
    <message>
        <source>this is not a camera matrix</source>
        <translation>这不是相机矩阵</translation>
    </message>
    <message>
        <source>R is not a rotation</source>
        <translation>R 不是旋转矩阵</translation>
    </message>
    <message>
        <source>the distortion folds on the axis</source>
        <translation>畸变在光轴上已发生折叠</translation>
    </message>
    <message>
        <source>this is not a camera file</source>
        <translation>这不是相机文件</translation>
    </message>
    <message>
        <source>the file was written by a newer version</source>
        <translation>文件版本较新</translation>
    </message>
    <message>
        <source>The camera stopped sending frames.</source>
        <translation>相机不再提供帧。</translation>
    </message>
    <message>
        <source>this is not a covariance</source>
        <translation>这不是协方差</translation>
    </message>
    <message>
        <source>a symmetric matrix without negative variances</source>
        <translation>没有负方差的对称矩阵</translation>
    </message>
</context>
<context>
    <name>CertificateText</name>
    <message>
        <source>SIGTERM, as when a session ends.</source>
        <translation>SIGTERM，如同会话结束时。</translation>
    </message>
    <message>
        <source>SIGINT, as by Ctrl-C.</source>
        <translation>SIGINT，如同按下 Ctrl-C。</translation>
    </message>
    <message>
        <source>SIGHUP, as when a terminal closes.</source>
        <translation>SIGHUP，如同终端关闭时。</translation>
    </message>
    <message>
        <source>SIGSTOP, later SIGCONT, as when the computer sleeps.</source>
        <translation>SIGSTOP，随后 SIGCONT，如同计算机休眠时。</translation>
    </message>
    <message>
        <source>The line is cut and cannot be opened for a while.</source>
        <translation>线路中断，并在一段时间内无法打开。</translation>
    </message>
    <message>
        <source>The driver&apos;s answers are held back.</source>
        <translation>驱动器的应答被延迟。</translation>
    </message>
    <message>
        <source>What the program sends does not arrive.</source>
        <translation>程序发送的内容未送达。</translation>
    </message>
    <message>
        <source>The driver&apos;s answers are replaced by garbage, by refusals, or by answers to other requests.</source>
        <translation>驱动器的应答被替换为乱码、拒绝或对其他请求的应答。</translation>
    </message>
    <message>
        <source>STOP is engaged.</source>
        <translation>STOP 已触发。</translation>
    </message>
    <message>
        <source>The recording can no longer grow; then STOP. Timed from STOP.</source>
        <translation>记录无法再增大；随后 STOP。自 STOP 起计时。</translation>
    </message>
    <message>
        <source>The program gets no more memory; then STOP. Timed from STOP.</source>
        <translation>程序无法再获得内存；随后 STOP。自 STOP 起计时。</translation>
    </message>
    <message>
        <source>The wall clock is set an hour forward or back; then STOP. Timed from STOP.</source>
        <translation>系统时钟被拨动一小时；随后 STOP。自 STOP 起计时。</translation>
    </message>
    <message>
        <source>No fault was injected.</source>
        <translation>未注入任何故障。</translation>
    </message>
    <message>
        <source>Passed: after each of %1 faults the motors were at zero within %2 ms. They never restarted by themselves, and no recorded frame was lost. With 95 % confidence, at most %3 % of such faults take longer.</source>
        <translation>通过：%1 次故障中，每次故障后电机都在 %2 ms 内归零。没有任何动作未经请求而继续，记录也没有任何丢失。以 95 % 的置信度，至多 %3 % 的此类故障耗时更长。</translation>
    </message>
    <message>
        <source>Not passed: of %1 faults, %2 left the motors on for more than %3 ms. After %4 of them the motors restarted by themselves. %5 recorded frames were lost, and %6 recordings were damaged.</source>
        <translation>未通过：%1 次故障中，有 %2 次使电机继续运转超过 %3 ms，有 %4 次之后出现了无人请求的动作，丢失 %5 帧，损坏 %6 个记录。</translation>
    </message>
    <message>
        <source>Time from the fault until the motors were at zero, in ms</source>
        <translation>从故障到电机归零的时间，ms</translation>
    </message>
    <message>
        <source>Fault</source>
        <translation>故障</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>次数</translation>
    </message>
    <message>
        <source>Median</source>
        <translation>中位数</translation>
    </message>
    <message>
        <source>99 %</source>
        <translation>99 %</translation>
    </message>
    <message>
        <source>Longest</source>
        <translation>最长</translation>
    </message>
    <message>
        <source>Over the bound</source>
        <translation>超出时限</translation>
    </message>
    <message>
        <source>Share, upper limit (%)</source>
        <translation>比例上限 (%)</translation>
    </message>
    <message>
        <source>Restarted by itself</source>
        <translation>未经请求而继续</translation>
    </message>
    <message>
        <source>Frames lost</source>
        <translation>丢失的帧</translation>
    </message>
    <message>
        <source>Files damaged</source>
        <translation>损坏的文件</translation>
    </message>
    <message>
        <source>All</source>
        <translation>全部</translation>
    </message>
    <message>
        <source>Times until the motors were at zero, by kind of fault</source>
        <translation>各类故障下电机归零的时间</translation>
    </message>
    <message>
        <source>Time until zero (ms)</source>
        <translation>归零时间 (ms)</translation>
    </message>
    <message>
        <source>bound</source>
        <translation>时限</translation>
    </message>
    <message>
        <source>System under test</source>
        <translation>检查对象</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>项目</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>程序</translation>
    </message>
    <message>
        <source>Driver of the motors</source>
        <translation>电机驱动器</translation>
    </message>
    <message>
        <source>%1 (SIMULATED)</source>
        <translation>%1（模拟）</translation>
    </message>
    <message>
        <source>Started</source>
        <translation>开始时间</translation>
    </message>
    <message>
        <source>System</source>
        <translation>系统</translation>
    </message>
    <message>
        <source>Processor</source>
        <translation>处理器</translation>
    </message>
    <message numerus="yes">
        <source>%1, %n core(s)</source>
        <translation>
            <numerusform>%1，%n 个核心</numerusform>
        </translation>
    </message>
    <message>
        <source>Load average (1 min)</source>
        <translation>最近一分钟的负载</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>种子</translation>
    </message>
    <message>
        <source>Killed</source>
        <translation>强制终止</translation>
    </message>
    <message>
        <source>Terminated</source>
        <translation>终止</translation>
    </message>
    <message>
        <source>Interrupted</source>
        <translation>中断</translation>
    </message>
    <message>
        <source>Terminal closed</source>
        <translation>终端关闭</translation>
    </message>
    <message>
        <source>Put to sleep</source>
        <translation>休眠</translation>
    </message>
    <message>
        <source>Unplugged</source>
        <translation>拔出</translation>
    </message>
    <message>
        <source>Answers late</source>
        <translation>应答延迟</translation>
    </message>
    <message>
        <source>Requests lost</source>
        <translation>请求丢失</translation>
    </message>
    <message>
        <source>Answers wrong</source>
        <translation>应答错误</translation>
    </message>
    <message>
        <source>STOP</source>
        <translation>STOP</translation>
    </message>
    <message>
        <source>Disk full, STOP</source>
        <translation>磁盘已满，STOP</translation>
    </message>
    <message>
        <source>Memory refused, STOP</source>
        <translation>内存分配被拒，STOP</translation>
    </message>
    <message>
        <source>Clock set, STOP</source>
        <translation>时钟被拨动，STOP</translation>
    </message>
    <message>
        <source>SIMULATED: the driver of the motors is a program.</source>
        <translation>模拟：电机驱动器是一个程序。</translation>
    </message>
    <message>
        <source>Faults</source>
        <translation>故障</translation>
    </message>
    <message>
        <source>What each fault does</source>
        <translation>各类故障的含义</translation>
    </message>
    <message>
        <source>en</source>
        <comment>language of the page, as BCP 47 has it</comment>
        <translation>zh-Hans</translation>
    </message>
    <message>
        <source>Certificate of faults</source>
        <translation>故障测试证书</translation>
    </message>
    <message>
        <source>The program is ended by SIGKILL. Only what watches over the device is left.</source>
        <translation>程序被 SIGKILL 终止。只剩下看护设备的机制。</translation>
    </message>
    <message>
        <source>Passed: after each of %1 faults the arm was at rest within %2 ms. It never moved again by itself. With 95 % confidence, at most %3 % of such faults take longer.</source>
        <translation>通过：%1 次故障中每次之后机械臂都在 %2 ms 内静止，从未自行再次运动。以 95 % 的置信度，此类故障中最多有 %3 % 需要更长时间。</translation>
    </message>
    <message>
        <source>Not passed: of %1 faults, %2 left the arm moving for more than %3 ms. After %4 of them it moved again by itself.</source>
        <translation>未通过：%1 次故障中有 %2 次机械臂运动超过 %3 ms。其中 %4 次之后它自行再次运动。</translation>
    </message>
    <message>
        <source>Time from the fault until the arm was at rest, in ms</source>
        <translation>从故障到机械臂静止的时间（ms）</translation>
    </message>
    <message>
        <source>Times until the arm was at rest, by kind of fault</source>
        <translation>各类故障下机械臂静止所需的时间</translation>
    </message>
    <message>
        <source>Time until rest (ms)</source>
        <translation>到静止的时间（ms）</translation>
    </message>
    <message>
        <source>Arm</source>
        <translation>机械臂</translation>
    </message>
    <message>
        <source>Longest gap between two readings</source>
        <translation>两次读数之间的最长间隔</translation>
    </message>
    <message>
        <source>SIMULATED: the arm is a program.</source>
        <translation>模拟：机械臂是一个程序。</translation>
    </message>
</context>
<context>
    <name>CertifyCommand</name>
    <message>
        <source>File of a Modbus motor driver over TCP; default: a simulated one. Nobody may wear its motors: they run the whole time</source>
        <translation>TCP 上 Modbus 电机驱动器的文件；默认：模拟的驱动器。任何人都不得佩戴其电机，电机会一直转动</translation>
    </message>
    <message>
        <source>Number of faults</source>
        <translation>故障次数</translation>
    </message>
    <message>
        <source>Seed for the order and timing of the faults</source>
        <translation>故障的顺序和相位的种子</translation>
    </message>
    <message>
        <source>Name of the report: NAME.html and NAME.json are written</source>
        <translation>报告的存放位置：NAME.html 和 NAME.json</translation>
    </message>
    <message>
        <source>the motors will run the whole time; make sure that nobody wears them, then add --yes</source>
        <translation>电机会一直转动；请确保没有人佩戴电机，并加上 --yes</translation>
    </message>
    <message>
        <source>the device has no motors</source>
        <translation>该设备没有电机</translation>
    </message>
    <message>
        <source>a table [tactors]</source>
        <translation>表 [tactors]</translation>
    </message>
    <message>
        <source>only a driver over TCP can be certified</source>
        <translation>线路故障只能注入 TCP 线路</translation>
    </message>
    <message>
        <source>The certificate was not passed.</source>
        <translation>证书测试未通过。</translation>
    </message>
    <message>
        <source>The program under test follows a simulated array by live setpoints, drives the motors within their limits, and records.</source>
        <translation>被测程序以实时设定值跟随模拟阵列，在限制范围内驱动电机，并进行记录。</translation>
    </message>
    <message>
        <source>The driver of the motors is SIMULATED: a Modbus server with a watchdog of 100 ms.</source>
        <translation>电机驱动器为模拟：一个看门狗为 100 ms 的 Modbus 服务器。</translation>
    </message>
    <message>
        <source>A damaged recording was kept: %1</source>
        <translation>已保留一个损坏的记录：%1</translation>
    </message>
    <message>
        <source>%1 faults: median %2, 99 % %3, longest %4 ms; %5 over the bound</source>
        <translation>%1 次故障：中位数 %2，99 % %3，最长 %4 ms；%5 次超出时限</translation>
    </message>
    <message>
        <source>All</source>
        <translation>全部</translation>
    </message>
    <message>
        <source>Restarted by itself</source>
        <translation>未经请求而继续</translation>
    </message>
    <message>
        <source>Frames lost</source>
        <translation>丢失的帧</translation>
    </message>
    <message>
        <source>Files damaged</source>
        <translation>损坏的文件</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>报告</translation>
    </message>
    <message>
        <source>File of an arm over ROS 2, which is certified instead. One of its joints moves to and fro the whole time; nobody may be within its reach</source>
        <translation>改为认证的 ROS 2 机械臂的文件。它的一个关节一直来回运动；其可及范围内不得有人</translation>
    </message>
    <message>
        <source>The same with an arm at a site: the file of a console that may move it</source>
        <translation>同样，但用站点的机械臂：可以移动它的控制台的文件</translation>
    </message>
    <message>
        <source>With --site: file of a viewer, which watches the arm. Default without certificates: the same file</source>
        <translation>与 --site 一起：监视机械臂的观察者的文件。默认（无证书时）：同一文件</translation>
    </message>
    <message>
        <source>With --site: the arm&apos;s name there; default: the only one</source>
        <translation>与 --site 一起：机械臂在站点上的名称；默认：唯一的一个</translation>
    </message>
    <message>
        <source>With --arm and --site: joint that moves</source>
        <translation>与 --arm 和 --site 一起：运动的关节</translation>
    </message>
    <message>
        <source>Nobody wears the motors of --bracelet, or is within reach of the arm</source>
        <translation>没有人佩戴 --bracelet 的电机，也没有人在机械臂的可及范围内</translation>
    </message>
    <message>
        <source>Longest time until the motors must be at zero or the arm at rest; default: %1, with an arm %2</source>
        <translation>电机归零或机械臂静止所允许的最长时间；默认：%1，对机械臂为 %2</translation>
    </message>
    <message>
        <source>--joint is needed, the joint that moves to and fro</source>
        <translation>需要 --joint，即来回运动的关节</translation>
    </message>
    <message>
        <source>%1 is no fault of an arm&apos;s chain</source>
        <translation>%1 不是机械臂链路的故障</translation>
    </message>
    <message>
        <source>the arm will move the whole time; make sure that nobody is within its reach, then add --yes</source>
        <translation>机械臂会一直运动；请确认其可及范围内没有人，然后加上 --yes</translation>
    </message>
    <message>
        <source>The program under test moves %1 to and fro at %2 (rad/s, prismatic m/s). It has its own connection; the arm is watched over another one.</source>
        <translation>被测程序以 %2（rad/s，移动关节为 m/s）来回移动 %1。它有自己的连接；机械臂通过另一连接被监视。</translation>
    </message>
    <message>
        <source>Ended early: %1 of %2 faults were injected.</source>
        <translation>提前结束：%2 次故障中注入了 %1 次。</translation>
    </message>
    <message>
        <source>Not covered: faults of the network, of the site and of the arm&apos;s controller.</source>
        <translation>未涵盖：网络、站点和机械臂控制器的故障。</translation>
    </message>
    <message>
        <source>Not covered: bracelets that are not Modbus drivers over TCP.</source>
        <translation>未涵盖：不是 TCP 上的 Modbus 驱动器的手环。</translation>
    </message>
    <message>
        <source>With --arm and --site: its speed in rad/s, prismatic m/s. It turns back after half a second of motion to each side</source>
        <translation>与 --arm 和 --site 一起：其速度，rad/s，移动关节为 m/s。向每一侧运动半秒后折返</translation>
    </message>
    <message>
        <source>Kinds of faults, separated by commas: %1. Default: all but clock_step, which sets the clock of this computer; for an arm, also without faults of the line and of the recording</source>
        <translation>以逗号分隔的故障种类：%1。默认：除会设置本机时钟的 clock_step 外的全部；对机械臂还不含线路和记录的故障</translation>
    </message>
    <message>
        <source>Inject faults into the program that drives motors or an arm, and report how soon they stop</source>
        <translation>向驱动电机或机械臂的程序注入故障，并报告它们多快停下</translation>
    </message>
</context>
<context>
    <name>ChainText</name>
    <message>
        <source>the robot has no link &apos;%1&apos;</source>
        <translation>机器人没有连杆“%1”</translation>
    </message>
    <message>
        <source>one of %1</source>
        <translation>%1 之一</translation>
    </message>
    <message>
        <source>the link &apos;%1&apos; does not hang on &apos;%2&apos;</source>
        <translation>连杆“%1”不连接在“%2”之下</translation>
    </message>
    <message>
        <source>a base from which joints lead to the tip</source>
        <translation>有关节通向末端的基座</translation>
    </message>
    <message>
        <source>no joint between &apos;%1&apos; and &apos;%2&apos; moves</source>
        <translation>“%1”与“%2”之间没有可动的关节</translation>
    </message>
    <message>
        <source>at least one revolute, continuous or prismatic joint</source>
        <translation>至少一个 revolute、continuous 或 prismatic 关节</translation>
    </message>
    <message>
        <source>%1 joints move the tip</source>
        <translation>有 %1 个关节移动末端</translation>
    </message>
    <message>
        <source>at most %1</source>
        <translation>至多 %1</translation>
    </message>
    <message>
        <source>a joint that moves &apos;%1&apos; moves the tip as well</source>
        <translation>移动“%1”的关节也会移动末端</translation>
    </message>
    <message>
        <source>a base that stands still while the tip moves</source>
        <translation>末端移动时静止不动的基座</translation>
    </message>
</context>
<context>
    <name>ChannelServo</name>
    <message>
        <source>the arm has no pad on a link</source>
        <translation>机械臂的连杆上没有触觉垫</translation>
    </message>
    <message>
        <source>a recording is played, and nothing can be moved</source>
        <translation>正在播放记录，什么都不能移动</translation>
    </message>
    <message>
        <source>the pad is not calibrated: its loads are not in N</source>
        <translation>触觉垫未标定：其载荷不以 N 为单位</translation>
    </message>
</context>
<context>
    <name>ChartText</name>
    <message>
        <source>correct answers</source>
        <translation>正确回答</translation>
    </message>
    <message>
        <source>correct, %</source>
        <translation>正确率，%</translation>
    </message>
    <message>
        <source>chance</source>
        <translation>随机水平</translation>
    </message>
    <message>
        <source>correct answers by pattern</source>
        <translation>各图案的正确回答</translation>
    </message>
    <message>
        <source>response times</source>
        <translation>反应时间</translation>
    </message>
    <message>
        <source>median of correct answers, s</source>
        <translation>正确回答的中位数，s</translation>
    </message>
    <message>
        <source>information transfer</source>
        <translation>信息传输量</translation>
    </message>
    <message>
        <source>bit</source>
        <translation>bit</translation>
    </message>
    <message>
        <source>all patterns told apart</source>
        <translation>全部图案均可区分</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>实测</translation>
    </message>
    <message>
        <source>less bias</source>
        <translation>减去偏差</translation>
    </message>
</context>
<context>
    <name>CliSiteText</name>
    <message>
        <source>no site was found in domain %1</source>
        <translation>在域 %1 中未找到站点</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>记录</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>时长</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 秒</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>帧</translation>
    </message>
    <message>
        <source>Dropped here</source>
        <translation>在此丢失</translation>
    </message>
</context>
<context>
    <name>ClickListener</name>
    <message>
        <source>Inputs of ALSA cannot be listened to.</source>
        <translation>无法监听 ALSA 的输入。</translation>
    </message>
    <message>
        <source>device = &quot;pipewire&quot; or &quot;jack&quot; in the device file</source>
        <translation>设备文件中的 device = &quot;pipewire&quot; 或 &quot;jack&quot;</translation>
    </message>
    <message>
        <source>The sound server does not answer.</source>
        <translation>声音服务器没有应答。</translation>
    </message>
    <message>
        <source>There is no sound input &quot;%1&quot;.</source>
        <translation>没有声音输入“%1”。</translation>
    </message>
    <message>
        <source>an input; there is none</source>
        <translation>一个输入；目前没有</translation>
    </message>
    <message>
        <source>one of: %1</source>
        <translation>以下之一：%1</translation>
    </message>
    <message>
        <source>The sound server refused to create an input.</source>
        <translation>声音服务器没有提供输入。</translation>
    </message>
    <message>
        <source>The input &quot;%1&quot; cannot be connected.</source>
        <translation>无法连接输入“%1”。</translation>
    </message>
</context>
<context>
    <name>ComparisonContent</name>
    <message>
        <source>Effect</source>
        <translation>效应</translation>
    </message>
    <message>
        <source>Pattern</source>
        <translation>图案</translation>
    </message>
    <message>
        <source>Pair</source>
        <translation>水平对</translation>
    </message>
    <message>
        <source>n</source>
        <translation>n</translation>
    </message>
    <message>
        <source>Difference %</source>
        <translation>差值 %</translation>
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
        <translation>备注</translation>
    </message>
    <message>
        <source>A comparison of the conditions for this pattern alone</source>
        <translation>仅就此图案比较各条件</translation>
    </message>
    <message>
        <source>The first minus the second</source>
        <translation>第一个减去第二个</translation>
    </message>
    <message>
        <source>Participants with both values</source>
        <translation>两个值都有的被试</translation>
    </message>
    <message>
        <source>Of the difference, not corrected</source>
        <translation>差值的区间，未校正</translation>
    </message>
    <message>
        <source>Paired t test</source>
        <translation>配对 t 检验</translation>
    </message>
    <message>
        <source>Corrected over all pairs of the effect; over all patterns where the conditions are compared within them</source>
        <translation>对该效应的所有水平对作校正；在各图案内比较条件时，对所有图案作校正</translation>
    </message>
    <message>
        <source>Difference over the standard deviation of the differences</source>
        <translation>差值除以差值的标准差</translation>
    </message>
    <message>
        <source>From the noncentral t distribution, not corrected</source>
        <translation>由非中心 t 分布求得，未校正</translation>
    </message>
    <message>
        <source>Difference over the mean standard deviation of the two</source>
        <translation>差值除以两者的平均标准差</translation>
    </message>
    <message>
        <source>d_z with Hedges&apos; correction</source>
        <translation>经 Hedges 校正的 d_z</translation>
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
        <translation>正差值的秩和</translation>
    </message>
    <message>
        <source>Sum of the ranks of negative differences</source>
        <translation>负差值的秩和</translation>
    </message>
    <message>
        <source>Wilcoxon&apos;s signed rank test with Pratt&apos;s zeros; exact up to 25 differences</source>
        <translation>Wilcoxon 符号秩检验，零差值按 Pratt 处理；不超过 25 个差值时为精确检验</translation>
    </message>
    <message>
        <source>Corrected over all pairs of the effect</source>
        <translation>对该效应的所有水平对作校正</translation>
    </message>
    <message>
        <source>Rank-biserial correlation</source>
        <translation>秩二列相关</translation>
    </message>
    <message>
        <source>partial eta²</source>
        <translation>偏 eta²</translation>
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
        <translation>Kendall W</translation>
    </message>
    <message>
        <source>From the noncentral F distribution; only with sphericity, eps GG at least 0.75</source>
        <translation>由非中心 F 分布求得；仅在满足球形性时给出，即 eps GG 至少为 0.75</translation>
    </message>
    <message>
        <source>By ranks, of three levels and more</source>
        <translation>按秩计算，用于三个及以上水平</translation>
    </message>
    <message>
        <source>Of Friedman&apos;s test</source>
        <translation>Friedman 检验的 p 值</translation>
    </message>
    <message>
        <source>Concordance of the participants</source>
        <translation>被试间的一致性</translation>
    </message>
    <message>
        <source>Term</source>
        <translation>项</translation>
    </message>
    <message>
        <source>Estimate</source>
        <translation>估计值</translation>
    </message>
    <message>
        <source>SE</source>
        <translation>SE</translation>
    </message>
    <message>
        <source>Odds ratio</source>
        <translation>优势比</translation>
    </message>
    <message>
        <source>Logit of a right answer</source>
        <translation>正确回答的 logit</translation>
    </message>
    <message>
        <source>Wald&apos;s interval</source>
        <translation>Wald 区间</translation>
    </message>
    <message>
        <source>intercept (%1)</source>
        <translation>截距 (%1)</translation>
    </message>
    <message>
        <source>A model of single answers needs at least 5 participants.</source>
        <translation>单次回答的模型至少需要 5 名被试。</translation>
    </message>
    <message>
        <source>No model of single answers: under one condition all answers are right, or all wrong, so that its effect has no finite estimate.</source>
        <translation>没有单次回答的模型：在某一条件下所有回答都正确或都错误，因此其效应没有有限的估计值。</translation>
    </message>
    <message>
        <source>No model of single answers: the search has found no maximum.</source>
        <translation>没有单次回答的模型：搜索未找到最大值。</translation>
    </message>
    <message>
        <source>Each participant has an own intercept, with a standard deviation of %1.</source>
        <translation>每名被试有各自的截距，标准差为 %1。</translation>
    </message>
    <message>
        <source>The participants do not differ more than chance makes them.</source>
        <translation>被试之间的差异不超过随机所致。</translation>
    </message>
    <message>
        <source>Conditions: likelihood ratio χ²(%1) = %2, p %3.</source>
        <translation>条件：似然比 χ²(%1) = %2，p %3。</translation>
    </message>
    <message>
        <source>Ratio</source>
        <translation>比值</translation>
    </message>
    <message>
        <source>The first divided by the second</source>
        <translation>第一个除以第二个</translation>
    </message>
    <message>
        <source>Participants with times under both</source>
        <translation>两个条件下都有时间的被试</translation>
    </message>
    <message>
        <source>Of the geometric means of the response times of right answers</source>
        <translation>正确回答反应时间的几何平均值之比</translation>
    </message>
    <message>
        <source>Paired t test of the mean logarithms</source>
        <translation>对平均对数的配对 t 检验</translation>
    </message>
    <message>
        <source>Right answers given within a time</source>
        <translation>在某一时间内给出的正确回答</translation>
    </message>
    <message>
        <source>s from the onset</source>
        <translation>自起始起，s</translation>
    </message>
    <message>
        <source>answered, %</source>
        <translation>已回答，%</translation>
    </message>
    <message>
        <source>Rule</source>
        <translation>规则</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>值</translation>
    </message>
    <message>
        <source>Made</source>
        <translation>制定时间</translation>
    </message>
    <message>
        <source>Trials before</source>
        <translation>之前的试次</translation>
    </message>
    <message>
        <source>Trials</source>
        <translation>试次</translation>
    </message>
    <message>
        <source>Sessions</source>
        <translation>场次</translation>
    </message>
    <message>
        <source>Participants</source>
        <translation>被试</translation>
    </message>
    <message>
        <source>Before the data, in the protocol, or after them</source>
        <translation>在数据之前（方案中）或在数据之后</translation>
    </message>
    <message>
        <source>What the rules before have left</source>
        <translation>前面的规则留下的试次</translation>
    </message>
    <message>
        <source>Left out</source>
        <translation>被排除的</translation>
    </message>
    <message>
        <source>Left out as a whole</source>
        <translation>整体被排除的</translation>
    </message>
    <message numerus="yes">
        <source>no spread of the times in %n case(s): nothing left out</source>
        <translation>
            <numerusform>%n 处的时间没有离散：未排除任何数据</numerusform>
        </translation>
    </message>
    <message>
        <source>in the file</source>
        <translation>文件中</translation>
    </message>
    <message>
        <source>after the data</source>
        <translation>数据之后</translation>
    </message>
    <message>
        <source>before the data</source>
        <translation>数据之前</translation>
    </message>
    <message>
        <source>Condition or effect</source>
        <translation>条件或效应</translation>
    </message>
    <message>
        <source>Right %</source>
        <translation>正确 %</translation>
    </message>
    <message>
        <source>Right % without rules</source>
        <translation>无规则时正确 %</translation>
    </message>
    <message>
        <source>p GG</source>
        <translation>p GG</translation>
    </message>
    <message>
        <source>p GG without rules</source>
        <translation>无规则时 p GG</translation>
    </message>
</context>
<context>
    <name>ComparisonText</name>
    <message>
        <source>Pairs of levels, paired t tests of the shares of correct answers. Holm: corrected over all pairs of the effect. The intervals (95 %) are not corrected</source>
        <translation>各水平两两比较，对正确回答比例的配对 t 检验。Holm：对该效应的所有水平对作校正。区间 (95 %) 未校正</translation>
    </message>
    <message>
        <source>Effect</source>
        <translation>效应</translation>
    </message>
    <message>
        <source>Pair</source>
        <translation>水平对</translation>
    </message>
    <message>
        <source>Participants</source>
        <translation>被试</translation>
    </message>
    <message>
        <source>Difference, %</source>
        <translation>差值，%</translation>
    </message>
    <message>
        <source>Interval, %</source>
        <translation>区间，%</translation>
    </message>
    <message>
        <source>p, Holm</source>
        <translation>p，Holm</translation>
    </message>
    <message>
        <source>Interval</source>
        <translation>区间</translation>
    </message>
    <message>
        <source>Remark</source>
        <translation>备注</translation>
    </message>
    <message>
        <source>The same pairs by ranks: Wilcoxon&apos;s signed rank test with Pratt&apos;s zeros, exact up to 25 differences</source>
        <translation>对相同的水平对按秩检验：Wilcoxon 符号秩检验，零差值按 Pratt 处理，不超过 25 个差值时为精确检验</translation>
    </message>
    <message>
        <source>Rank-biserial r</source>
        <translation>秩二列 r</translation>
    </message>
    <message>
        <source>Friedman&apos;s test of effects with three levels and more</source>
        <translation>对三个及以上水平的效应的 Friedman 检验</translation>
    </message>
    <message>
        <source>df</source>
        <translation>df</translation>
    </message>
    <message>
        <source>Kendall&apos;s W</source>
        <translation>Kendall W</translation>
    </message>
    <message>
        <source>Partial η² with its interval (95 %), where sphericity holds (ε GG at least 0.75)</source>
        <translation>偏 η² 及其区间 (95 %)，仅在满足球形性时给出（ε GG 至少为 0.75）</translation>
    </message>
    <message>
        <source>Model of single answers</source>
        <translation>单次回答的模型</translation>
    </message>
    <message>
        <source>There are no numbers: %1.</source>
        <translation>没有数值：%1。</translation>
    </message>
    <message>
        <source>Logit of a correct answer: an intercept that differs between participants, and the conditions against %1; Wald&apos;s intervals (95 %)</source>
        <translation>正确回答的 logit：截距因被试而异，各条件与 %1 相比；Wald 区间 (95 %)</translation>
    </message>
    <message>
        <source>Term</source>
        <translation>项</translation>
    </message>
    <message>
        <source>Estimate</source>
        <translation>估计值</translation>
    </message>
    <message>
        <source>SE</source>
        <translation>SE</translation>
    </message>
    <message>
        <source>Odds ratio</source>
        <translation>优势比</translation>
    </message>
    <message>
        <source>intercept (%1)</source>
        <translation>截距 (%1)</translation>
    </message>
    <message>
        <source>Standard deviation of the participants: %1.</source>
        <translation>被试的标准差：%1。</translation>
    </message>
    <message>
        <source>The participants do not differ more than chance makes them.</source>
        <translation>被试之间的差异不超过随机所致。</translation>
    </message>
    <message>
        <source>Conditions: likelihood ratio χ²(%1) = %2, p %3.</source>
        <translation>条件：似然比 χ²(%1) = %2，p %3。</translation>
    </message>
    <message>
        <source>Comparisons and effect sizes</source>
        <translation>比较与效应量</translation>
    </message>
    <message>
        <source>response times, cumulative</source>
        <translation>反应时间，累积</translation>
    </message>
    <message>
        <source>time from the onset, s</source>
        <translation>自起始起的时间，s</translation>
    </message>
    <message>
        <source>answered, %</source>
        <translation>已回答，%</translation>
    </message>
    <message>
        <source>Share of the correct answers of all participants that were given within a time.</source>
        <translation>全部被试的正确回答中，在某一时间内给出的比例。</translation>
    </message>
    <message>
        <source>Conditions compared by the participants&apos; geometric means: how many times as long the first takes; paired t tests of the logarithms</source>
        <translation>按各被试的几何平均值比较条件：第一个所用时间是第二个的多少倍；对数的配对 t 检验</translation>
    </message>
    <message>
        <source>Ratio</source>
        <translation>比值</translation>
    </message>
</context>
<context>
    <name>ConfusionPicture</name>
    <message>
        <source>answered, % of the row</source>
        <translation>回答，占行的 %</translation>
    </message>
    <message>
        <source>answered</source>
        <translation>回答</translation>
    </message>
    <message>
        <source>presented</source>
        <translation>呈现</translation>
    </message>
</context>
<context>
    <name>ConsoleOptions</name>
    <message>
        <source>--%1 %2: expected a number from %3 to %4</source>
        <translation>--%1 %2：应为 %3 至 %4 的数</translation>
    </message>
    <message>
        <source>--%1 %2: expected a whole number from %3 to %4</source>
        <translation>--%1 %2：应为 %3 至 %4 的整数</translation>
    </message>
    <message>
        <source>FILE</source>
        <translation>文件</translation>
    </message>
    <message>
        <source>Seed of the simulated scenes (default 1).</source>
        <translation>模拟场景的种子（默认 1）。</translation>
    </message>
    <message>
        <source>N</source>
        <translation>N</translation>
    </message>
    <message>
        <source>Rows of the array (default: by the number of taxels).</source>
        <translation>阵列的行数（默认由触觉单元数决定）。</translation>
    </message>
    <message>
        <source>Columns of the array.</source>
        <translation>阵列的列数。</translation>
    </message>
    <message>
        <source>Distance between taxels in mm.</source>
        <translation>触觉单元间距，单位 mm。</translation>
    </message>
    <message>
        <source>MM</source>
        <translation>MM</translation>
    </message>
    <message>
        <source>Recording of the unloaded array, subtracted from the frames.</source>
        <translation>空载阵列的记录，将从各帧中减去。</translation>
    </message>
    <message>
        <source>The values fall under load.</source>
        <translation>数值随载荷增大而下降。</translation>
    </message>
    <message>
        <source>Load per raw unit (default 1).</source>
        <translation>每原始单位的载荷（默认 1）。</translation>
    </message>
    <message>
        <source>G</source>
        <translation>G</translation>
    </message>
    <message>
        <source>Unit of the loads (default N or counts, by the array).</source>
        <translation>载荷的单位（默认 N 或计数，视阵列而定）。</translation>
    </message>
    <message>
        <source>NAME</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Load from which a taxel is in contact (default 0.2).</source>
        <translation>触觉单元视为接触的最小载荷（默认 0.2）。</translation>
    </message>
    <message>
        <source>LOAD</source>
        <translation>载荷</translation>
    </message>
    <message>
        <source>Play at this rate in Hz instead of the recorded times.</source>
        <translation>以此频率（Hz）播放，而非按记录的时间。</translation>
    </message>
    <message>
        <source>HZ</source>
        <translation>HZ</translation>
    </message>
    <message>
        <source>Open the sources listed in a TOML file.</source>
        <translation>打开 TOML 文件中列出的数据源。</translation>
    </message>
    <message>
        <source>Page to show: %1.</source>
        <translation>要显示的页面：%1。</translation>
    </message>
    <message>
        <source>light, dark or system.</source>
        <translation>light、dark 或 system。</translation>
    </message>
    <message>
        <source>Language, for example en, ja, fr, zh_CN.</source>
        <translation>语言，例如 en、ja、fr、zh_CN。</translation>
    </message>
    <message>
        <source>CODE</source>
        <translation>代码</translation>
    </message>
    <message>
        <source>Save a picture of the window as PNG and quit.</source>
        <translation>将窗口图像保存为 PNG 并退出。</translation>
    </message>
    <message>
        <source>Seconds to wait before the picture (default 3).</source>
        <translation>截图前等待的秒数（默认 3）。</translation>
    </message>
    <message>
        <source>S</source>
        <translation>S</translation>
    </message>
    <message>
        <source>Size of the window, for example 1600x1000.</source>
        <translation>窗口大小，例如 1600x1000。</translation>
    </message>
    <message>
        <source>WxH</source>
        <translation>宽x高</translation>
    </message>
    <message>
        <source>Run for so many seconds, print how long the event loop was busy, quit.</source>
        <translation>运行指定秒数，输出事件循环的繁忙时间，然后退出。</translation>
    </message>
    <message>
        <source>Start with the default layout and settings, and save none.</source>
        <translation>以默认布局和设置启动，且不保存任何设置。</translation>
    </message>
    <message>
        <source>unexpected argument &quot;%1&quot;</source>
        <translation>意外的参数“%1”</translation>
    </message>
    <message>
        <source>--page %1: expected one of %2</source>
        <translation>--page %1：应为 %2 之一</translation>
    </message>
    <message>
        <source>--theme %1: expected light, dark or system</source>
        <translation>--theme %1：应为 light、dark 或 system</translation>
    </message>
    <message>
        <source>--size %1: expected WIDTHxHEIGHT, from 320x240 to 16384x16384</source>
        <translation>--size %1：应为 宽x高，从 320x240 到 16384x16384</translation>
    </message>
    <message>
        <source>--dock %1: expected one of %2</source>
        <translation>--dock %1：应为 %2 之一</translation>
    </message>
    <message>
        <source>Open a simulated scene: a file, or the name of one that comes with the program (repeatable).</source>
        <translation>打开模拟场景：文件，或程序自带场景的名称（可重复）。</translation>
    </message>
    <message>
        <source>SCENE</source>
        <translation>场景</translation>
    </message>
    <message>
        <source>Open a camera in the soft tube by its number, or a video of one.</source>
        <translation>按编号打开软管中的相机，或打开其视频。</translation>
    </message>
    <message>
        <source>FILE|N</source>
        <translation>文件|N</translation>
    </message>
    <message>
        <source>Calibration of that camera (JSON of teleta calibrate).</source>
        <translation>该相机的标定（teleta calibrate 的 JSON）。</translation>
    </message>
    <message>
        <source>Open a pattern file, or a built-in pattern by its id, on the Patterns page.</source>
        <translation>在“图案”页打开图案文件，或按 ID 打开内置图案。</translation>
    </message>
    <message>
        <source>Folder of your own patterns (default: the user&apos;s data folder).</source>
        <translation>您自己的图案所在文件夹（默认：用户数据文件夹）。</translation>
    </message>
    <message>
        <source>FOLDER</source>
        <translation>文件夹</translation>
    </message>
    <message>
        <source>View of the Operate page (%1) or of the Study page (%2) to bring to the front.</source>
        <translation>要置于前台的“操作”页视图（%1）或“研究”页视图（%2）。</translation>
    </message>
    <message>
        <source>Calibrate the cylinder camera with these pairs (CSV).</source>
        <translation>用这些点对（CSV）标定圆柱相机。</translation>
    </message>
    <message>
        <source>Open the folder of a study, or a protocol (TOML) to begin one with.</source>
        <translation>打开研究文件夹，或用于新建研究的方案（TOML）。</translation>
    </message>
    <message>
        <source>PATH</source>
        <translation>路径</translation>
    </message>
    <message>
        <source>Let simulated participants go through the study, which is made if need be.</source>
        <translation>让模拟被试完成研究；必要时先创建研究。</translation>
    </message>
    <message>
        <source>WHICH</source>
        <translation>哪一个</translation>
    </message>
    <message>
        <source>--camera and --camera-model belong together: a camera is of no use without its calibration</source>
        <translation>--camera 与 --camera-model 须同时使用：没有标定，相机无法使用</translation>
    </message>
    <message>
        <source>Play back a recording of this program, or recorded frames, CSV time_s,t0,t1,... (repeatable; the options below go with the recordings in their order).</source>
        <translation>回放本程序的记录，或记录的帧，CSV time_s,t0,t1,...（可重复；以下选项按顺序对应各记录）。</translation>
    </message>
    <message>
        <source>Record all sources and the bracelet into a new file.</source>
        <translation>将所有数据源和手环记录到新文件中。</translation>
    </message>
    <message>
        <source>Bracelet to drive: simulated, usb, none, or a file that describes one.</source>
        <translation>要驱动的手环：simulated、usb、none，或描述手环的文件。</translation>
    </message>
    <message>
        <source>--language %1: expected en, fr, ja or zh_CN</source>
        <translation>--language %1：应为 en、fr、ja 或 zh_CN</translation>
    </message>
    <message>
        <source>Show all sources live to Foxglove on this port (default 8765).</source>
        <translation>在此端口上向 Foxglove 实时显示所有数据源（默认 8765）。</translation>
    </message>
    <message>
        <source>PORT</source>
        <translation>端口</translation>
    </message>
    <message>
        <source>Address on which the live view listens (default 127.0.0.1: this computer only).</source>
        <translation>实时视图监听的地址（默认 127.0.0.1：仅限本计算机）。</translation>
    </message>
    <message>
        <source>ADDRESS</source>
        <translation>地址</translation>
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
        <translation>显示远程机械臂所触碰的内容：位置、力度、刚度、形状。

示例：
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
        <translation>要打开的记录（.teleta、.csv、.mcap、.npz、.npy、.h5、.mat）、场景、机械臂、站点和源列表（.toml）。</translation>
    </message>
    <message>
        <source>Connect to a site where teleta-site runs, by its file (TOML; repeatable).</source>
        <translation>按文件连接运行 teleta-site 的站点（TOML；可重复）。</translation>
    </message>
    <message>
        <source>Open an arm over ROS 2, or the joints that a Modbus device reports, described in a file (TOML; repeatable).</source>
        <translation>打开文件中描述的通过 ROS 2 的机械臂，或 Modbus 设备报告的关节（TOML；可重复）。</translation>
    </message>
    <message>
        <source>Plot a signal on the Plot page as soon as its source is open, SOURCE/STREAM/COLUMN with the names that the page shows (repeatable).</source>
        <translation>信号源一打开就在“绘图”页上绘制一个信号，用该页显示的名称写成 SOURCE/STREAM/COLUMN（可重复）。</translation>
    </message>
    <message>
        <source>SIGNAL</source>
        <translation>SIGNAL</translation>
    </message>
    <message>
        <source>--plot %1: expected SOURCE/STREAM/COLUMN</source>
        <translation>--plot %1：应为 SOURCE/STREAM/COLUMN</translation>
    </message>
</context>
<context>
    <name>ContactsCommand</name>
    <message>
        <source>Place, force and identity of each contact of each tactile frame</source>
        <translation>每个触觉帧中各接触的位置、力和标识</translation>
    </message>
    <message>
        <source>this is for loads on a grid</source>
        <translation>此选项用于网格上的载荷</translation>
    </message>
</context>
<context>
    <name>ContourCommand</name>
    <message>
        <source>circle</source>
        <translation>圆</translation>
    </message>
    <message>
        <source>rectangle</source>
        <translation>矩形</translation>
    </message>
    <message>
        <source>triangle</source>
        <translation>三角形</translation>
    </message>
    <message>
        <source>arc</source>
        <translation>圆弧</translation>
    </message>
    <message>
        <source>line</source>
        <translation>直线</translation>
    </message>
    <message>
        <source>point</source>
        <translation>点</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>未知</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>点数</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>形状</translation>
    </message>
    <message>
        <source>%1 (confidence %2)</source>
        <translation>%1（置信度 %2）</translation>
    </message>
    <message>
        <source>Closed</source>
        <translation>闭合</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>是</translation>
    </message>
    <message>
        <source>no</source>
        <translation>否</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>长度</translation>
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
        <translation>%1 m（点偏差 %2 m）</translation>
    </message>
    <message>
        <source>Vertex %1</source>
        <translation>顶点 %1</translation>
    </message>
    <message>
        <source>Shape, vertices and spline of a series of contact points</source>
        <translation>一系列接触点的形状、顶点和样条曲线</translation>
    </message>
    <message>
        <source>CSV with the columns x_m,y_m, in the order of touch</source>
        <translation>CSV，含列 x_m,y_m，按触碰顺序排列</translation>
    </message>
    <message>
        <source>approximating: the points are the control points; interpolating: the curve passes through them</source>
        <translation>approximating：点为控制点；interpolating：曲线通过各点</translation>
    </message>
    <message>
        <source>Points of the curve, for the CSV and the largest curvature</source>
        <translation>曲线点数，用于 CSV 和最大曲率</translation>
    </message>
    <message>
        <source>Write the curve as CSV t,x_m,y_m,curvature_per_m, t from 0 to 1</source>
        <translation>将曲线写为 CSV t,x_m,y_m,curvature_per_m，t 从 0 到 1</translation>
    </message>
    <message>
        <source>the file has no points</source>
        <translation>文件中没有点</translation>
    </message>
    <message>
        <source>a coordinate is too large to compute with</source>
        <translation>坐标过大，无法计算</translation>
    </message>
    <message>
        <source>a row for each contact point, in metres</source>
        <translation>每个接触点一行，单位为米</translation>
    </message>
    <message>
        <source>The contour is closed; otherwise the program decides</source>
        <translation>轮廓回到起点；否则自动判定</translation>
    </message>
    <message>
        <source>A contour smaller than this is a point, m</source>
        <translation>小于此范围视为一个点，m</translation>
    </message>
    <message>
        <source>Candidates</source>
        <translation>候选</translation>
    </message>
</context>
<context>
    <name>ContourPicture</name>
    <message>
        <source>nothing explored yet</source>
        <translation>尚未探索</translation>
    </message>
    <message>
        <source>%1, confidence %2 %</source>
        <translation>%1，置信度 %2 %</translation>
    </message>
    <message>
        <source>Touch an object from several sides: its outline appears here.</source>
        <translation>从多个侧面触碰物体：其轮廓将显示在此处。</translation>
    </message>
    <message numerus="yes">
        <source>%n point(s)</source>
        <translation>
            <numerusform>%n 个点</numerusform>
        </translation>
    </message>
    <message>
        <source>radius %1</source>
        <translation>半径 %1</translation>
    </message>
    <message>
        <source>edges %1</source>
        <translation>边 %1</translation>
    </message>
    <message>
        <source>points off by %1 (rms)</source>
        <translation>点偏差 %1（rms）</translation>
    </message>
    <message>
        <source>z %1</source>
        <translation>z %1</translation>
    </message>
    <message>
        <source>undecided: %1</source>
        <translation>未定：%1</translation>
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
        <translation>触碰太少，无法判断形状</translation>
    </message>
</context>
<context>
    <name>CostFigureText</name>
    <message>
        <source>Filled: no other rung is both as quick and as exact. Lines: to the 95 % error and the 99 % time.</source>
        <translation>实心：没有其他档级能同样快且同样精确。线段：至 95 % 误差和 99 % 时间。</translation>
    </message>
    <message>
        <source>Not measured, the machine was too noisy or there is no error: %1.</source>
        <translation>未测量、机器干扰过大或没有误差：%1。</translation>
    </message>
    <message>
        <source>Median time of one call</source>
        <translation>单次调用的中位时间</translation>
    </message>
    <message>
        <source>Mean error (share)</source>
        <translation>平均误差（比例）</translation>
    </message>
    <message>
        <source>Mean error (%1)</source>
        <translation>平均误差（%1）</translation>
    </message>
    <message>
        <source>Limit: %1</source>
        <translation>极限：%1</translation>
    </message>
</context>
<context>
    <name>CostFileText</name>
    <message>
        <source>&quot;%1&quot; is not a value of the column %2</source>
        <translation>“%1”不是列 %2 的有效值</translation>
    </message>
    <message>
        <source>a number that is not negative, or NA</source>
        <translation>非负数，或 NA</translation>
    </message>
    <message>
        <source>yes or no</source>
        <translation>yes 或 no</translation>
    </message>
    <message>
        <source>a number of samples</source>
        <translation>样本数</translation>
    </message>
</context>
<context>
    <name>CostLadder</name>
    <message>
        <source>Calibration of the camera in the tube</source>
        <translation>管内相机的标定</translation>
    </message>
    <message>
        <source>distance of located points of the tube from the true ones; where the calibration is refused the camera of the data sheet stands in</source>
        <translation>管上定位点与真实点的距离；标定被拒绝时以数据手册中的相机代替</translation>
    </message>
    <message>
        <source>Contacts in a camera frame</source>
        <translation>相机帧中的接触</translation>
    </message>
    <message>
        <source>distance from the true contact on the tube; a contact that is missed counts with its distance from the tube&apos;s middle</source>
        <translation>与管上真实接触的距离；漏检的接触按其到管中部的距离计</translation>
    </message>
    <message>
        <source>Curve through contact points</source>
        <translation>通过接触点的曲线</translation>
    </message>
    <message>
        <source>distance of the true outline (circle, rectangle, bent profile) from the curve</source>
        <translation>真实轮廓（圆、矩形、弯曲型材）与曲线的距离</translation>
    </message>
    <message>
        <source>difference of a taxel from the scene with all effects, root mean square of a frame</source>
        <translation>触觉单元与含全部效应的场景之差，按帧取均方根</translation>
    </message>
    <message>
        <source>10 ms of an arm that touches rubber</source>
        <translation>机械臂触碰橡胶的 10 ms</translation>
    </message>
    <message>
        <source>largest difference of a joint&apos;s torque from a solution with steps of 2 us</source>
        <translation>关节力矩与步长 2 us 的解的最大差值</translation>
    </message>
    <message>
        <source>Interval of the information transfer of a study</source>
        <translation>研究的信息传输量区间</translation>
    </message>
    <message>
        <source>score of the 95 % interval: its width, and 40 times how far the true transfer lies outside of it</source>
        <translation>95 % 区间的评分：区间宽度，加上 40 倍的真实传输量超出区间的距离</translation>
    </message>
    <message>
        <source>Stiffness of a touched object</source>
        <translation>被触碰物体的刚度</translation>
    </message>
    <message>
        <source>share of the true stiffness of the object; a bound counts as the value, a refused touch as 1</source>
        <translation>占物体真实刚度的比例；界限按数值计，被拒绝的触碰计为 1</translation>
    </message>
    <message>
        <source>Place of a contact on a tactile array</source>
        <translation>触觉阵列上接触的位置</translation>
    </message>
    <message>
        <source>distance from the lowest point of the ball that presses</source>
        <translation>与按压小球最低点的距离</translation>
    </message>
    <message>
        <source>Direction in which a pixel of the wide lens looks</source>
        <translation>广角镜头中像素的视线方向</translation>
    </message>
    <message>
        <source>angle from the direction of the point of the tube that the pixel shows</source>
        <translation>与该像素所示管上点方向的夹角</translation>
    </message>
    <message>
        <source>Gains of an array&apos;s taxels from a press</source>
        <translation>由一次按压求阵列触觉单元的增益</translation>
    </message>
    <message>
        <source>share of the true gains, root mean square of an array; a taxel that is left out counts as it is</source>
        <translation>相对真实增益的比例，整个阵列的均方根；被排除的触觉单元按原值计</translation>
    </message>
    <message>
        <source>Motion of the markers of a gel</source>
        <translation>凝胶标记点的运动</translation>
    </message>
    <message>
        <source>distance from the way that the marker was drawn to have gone; a marker that is lost counts as at rest</source>
        <translation>与所绘标记点实际位移的距离；丢失的标记点按静止计</translation>
    </message>
    <message>
        <source>Interval of a threshold from a participant&apos;s answers</source>
        <translation>由参与者的回答得到的阈值区间</translation>
    </message>
    <message>
        <source>score of the 95 % interval of the threshold&apos;s logarithm: its width, and 40 times how far the true one lies outside of it</source>
        <translation>阈值对数的 95 % 区间的得分：区间宽度，加上真值超出区间距离的 40 倍</translation>
    </message>
    <message>
        <source>Contacts on the skin of a whole body</source>
        <translation>全身皮肤上的接触</translation>
    </message>
    <message>
        <source>distance of each body from the nearest contact of its patch, and of each contact from the nearest body; from the patch&apos;s middle where there is none</source>
        <translation>每个物体到其皮肤片上最近接触的距离，以及每个接触到最近物体的距离；没有时取到皮肤片中央的距离</translation>
    </message>
    <message>
        <source>A frame of a simulated array without one of the sensor&apos;s effects</source>
        <translation>仿真阵列去掉一种传感器效应后的一帧</translation>
    </message>
</context>
<context>
    <name>CostWords</name>
    <message>
        <source>twice as fast</source>
        <translation>快一倍</translation>
    </message>
    <message>
        <source>%1 times as fast</source>
        <translation>速度为 %1 倍</translation>
    </message>
    <message>
        <source>takes twice as long</source>
        <translation>用时为两倍</translation>
    </message>
    <message>
        <source>takes %1 times as long</source>
        <translation>用时为 %1 倍</translation>
    </message>
    <message>
        <source>Faster: %1, %2.</source>
        <translation>更快：%1，%2。</translation>
    </message>
    <message>
        <source>No setting is faster.</source>
        <translation>没有更快的设置。</translation>
    </message>
    <message>
        <source>In use: %1. It takes %2 and is off by %3 on average.</source>
        <extracomment>A setting, its time, its error</extracomment>
        <translation>正在使用：%1。用时 %2，平均偏差 %3。</translation>
    </message>
    <message>
        <source>%1 takes %2 and is off by %3 on average.</source>
        <translation>%1 用时 %2，平均偏差 %3。</translation>
    </message>
    <message>
        <source>%1 percentage points</source>
        <translation>%1 个百分点</translation>
    </message>
    <message>
        <source>as fast</source>
        <translation>一样快</translation>
    </message>
    <message>
        <source>%1, equally accurate</source>
        <translation>%1，同样准确</translation>
    </message>
    <message>
        <source>%1, %2 less accurate</source>
        <extracomment>How fast another setting is, and by how much its results are better or worse</extracomment>
        <translation>%1，准确度低 %2</translation>
    </message>
    <message>
        <source>%1, %2 more accurate</source>
        <translation>%1，准确度高 %2</translation>
    </message>
    <message>
        <source>%1 has no time: the machine was too busy. Close other programs and measure again.</source>
        <translation>%1 没有时间：计算机太忙。请关闭其他程序后重新测量。</translation>
    </message>
    <message>
        <source>Nothing can do this job in less than %1: this is its limit.</source>
        <translation>完成这项工作的任何方法都不会少于 %1：这是极限。</translation>
    </message>
    <message>
        <source>%1 takes %2. It has no error to compare.</source>
        <translation>%1 需要 %2。它没有可比较的误差。</translation>
    </message>
    <message>
        <source>%1 beats it: %2.</source>
        <translation>%1 更优：%2。</translation>
    </message>
    <message>
        <source>More accurate: %1, %2.</source>
        <translation>更准确：%1，%2。</translation>
    </message>
    <message>
        <source>No setting is more accurate.</source>
        <translation>没有更准确的设置。</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>相机</translation>
    </message>
    <message>
        <source>Tactile array</source>
        <translation>触觉阵列</translation>
    </message>
    <message>
        <source>Touched object</source>
        <translation>被触碰物体</translation>
    </message>
    <message>
        <source>Simulation</source>
        <translation>仿真</translation>
    </message>
    <message>
        <source>Study</source>
        <translation>研究</translation>
    </message>
</context>
<context>
    <name>CsvReaderText</name>
    <message>
        <source>opening was interrupted: %1</source>
        <translation>打开操作被中断：%1</translation>
    </message>
    <message>
        <source>cannot open the file: %1</source>
        <translation>无法打开文件：%1</translation>
    </message>
    <message>
        <source>cannot read the file: %1</source>
        <translation>无法读取文件：%1</translation>
    </message>
    <message>
        <source>this is a folder</source>
        <translation>这是文件夹</translation>
    </message>
    <message>
        <source>a CSV file</source>
        <translation>CSV 文件</translation>
    </message>
    <message>
        <source>the file is empty</source>
        <translation>文件为空</translation>
    </message>
    <message>
        <source>a header line with the names of the columns</source>
        <translation>含列名的标题行</translation>
    </message>
    <message>
        <source>the file is UTF-16</source>
        <translation>文件为 UTF-16 编码</translation>
    </message>
    <message>
        <source>UTF-8</source>
        <translation>UTF-8</translation>
    </message>
    <message>
        <source>the line is longer than 16 MiB</source>
        <translation>该行超过 16 MiB</translation>
    </message>
    <message>
        <source>a closing quote</source>
        <translation>右引号</translation>
    </message>
    <message>
        <source>a line end</source>
        <translation>行尾</translation>
    </message>
    <message>
        <source>a quote is not closed</source>
        <translation>引号未闭合</translation>
    </message>
    <message>
        <source>a number, nan, inf or NA</source>
        <translation>数值、nan、inf 或 NA</translation>
    </message>
    <message>
        <source>a finite number</source>
        <translation>有限数</translation>
    </message>
    <message>
        <source>the field is empty</source>
        <translation>字段为空</translation>
    </message>
    <message>
        <source>%1 is not a number</source>
        <translation>%1 不是数值</translation>
    </message>
    <message>
        <source>%1 is not a finite number</source>
        <translation>%1 不是有限数</translation>
    </message>
    <message>
        <source>missing columns: %1; the file has: %2</source>
        <translation>缺少列：%1；文件中有：%2</translation>
    </message>
    <message>
        <source>the columns %1</source>
        <translation>列 %1</translation>
    </message>
    <message>
        <source>the row is too long: more than %1 values</source>
        <translation>该行过长：超过 %1 个值</translation>
    </message>
    <message>
        <source>the row is too short: %1 of %2 values</source>
        <translation>该行过短：%1 个值，应为 %2 个</translation>
    </message>
    <message>
        <source>a file</source>
        <translation>文件</translation>
    </message>
    <message>
        <source>one value per column: %1</source>
        <translation>每列一个值：%1</translation>
    </message>
    <message>
        <source>text outside the quotes of a column name</source>
        <translation>列名的引号之外有文本</translation>
    </message>
    <message>
        <source>a comma after the closing quote</source>
        <translation>右引号之后的逗号</translation>
    </message>
    <message>
        <source>the column %1 appears twice</source>
        <translation>列 %1 出现两次</translation>
    </message>
    <message>
        <source>each name only once</source>
        <translation>每个名称一次</translation>
    </message>
    <message>
        <source>text outside the quotes of a value</source>
        <translation>值的引号之外有文本</translation>
    </message>
    <message>
        <source>a pipe cannot be rewound</source>
        <translation>管道不支持定位</translation>
    </message>
    <message>
        <source>the file is %1</source>
        <translation>文件是%1</translation>
    </message>
</context>
<context>
    <name>DdsDiscovery</name>
    <message>
        <source>other programs of the domain cannot be found</source>
        <translation>无法找到该域中的其他程序</translation>
    </message>
</context>
<context>
    <name>DdsDomain</name>
    <message>
        <source>the environment variable %1 is &quot;%2&quot;</source>
        <translation>环境变量 %1 为“%2”</translation>
    </message>
    <message>
        <source>a whole number from 0 to %1</source>
        <translation>0 到 %1 的整数</translation>
    </message>
</context>
<context>
    <name>DdsEndpoint</name>
    <message>
        <source>topic %1 cannot be opened</source>
        <translation>无法打开话题 %1</translation>
    </message>
    <message>
        <source>topic %1 cannot be read</source>
        <translation>无法读取话题 %1</translation>
    </message>
    <message>
        <source>topic %1 cannot be written</source>
        <translation>无法写入话题 %1</translation>
    </message>
    <message>
        <source>the permissions do not allow reading topic %1</source>
        <translation>权限不允许读取话题 %1</translation>
    </message>
    <message>
        <source>the permissions do not allow writing topic %1</source>
        <translation>权限不允许写入话题 %1</translation>
    </message>
</context>
<context>
    <name>DdsParticipant</name>
    <message>
        <source>domain %1 is open with another interface or other peers</source>
        <translation>域 %1 已用另一接口或其他对端打开</translation>
    </message>
    <message>
        <source>domain %1 of DDS cannot be opened: %2</source>
        <translation>无法打开 DDS 域 %1：%2</translation>
    </message>
    <message>
        <source>&quot;%1&quot; to be the name or the address of a network interface</source>
        <translation>“%1”应为网络接口的名称或地址</translation>
    </message>
    <message>
        <source>domain %1 of DDS cannot be joined: %2</source>
        <translation>无法加入 DDS 域 %1：%2</translation>
    </message>
    <message>
        <source>domain %1 of DDS cannot be joined</source>
        <translation>无法加入 DDS 域 %1</translation>
    </message>
    <message>
        <source>this program has joined domain %1 with keys already</source>
        <translation>此程序已使用密钥加入域 %1</translation>
    </message>
    <message>
        <source>once: the permissions of the first would apply to all</source>
        <translation>仅一次：否则第一次的权限会适用于全部</translation>
    </message>
    <message>
        <source>this program joined domain %1 with other permissions before</source>
        <translation>此程序之前以其他权限加入过域 %1</translation>
    </message>
    <message>
        <source>the same ones until the program is started again</source>
        <translation>在程序重新启动之前使用相同的权限</translation>
    </message>
    <message>
        <source>domain %1 of DDS cannot be joined with the keys in %2: %3</source>
        <translation>无法用 %2 中的密钥加入 DDS 域 %1：%3</translation>
    </message>
    <message>
        <source>a program is kept out of domain %1: %2</source>
        <translation>有程序被拒于域 %1 之外：%2</translation>
    </message>
</context>
<context>
    <name>DdsSecurity</name>
    <message>
        <source>the certificate has expired</source>
        <translation>证书已过期</translation>
    </message>
    <message>
        <source>the certificate is not valid yet</source>
        <translation>证书尚未生效</translation>
    </message>
    <message>
        <source>the certificate is not signed by identity_ca.pem</source>
        <translation>证书不是由 identity_ca.pem 签名的</translation>
    </message>
    <message>
        <source>the key does not belong to the certificate</source>
        <translation>密钥与证书不匹配</translation>
    </message>
    <message>
        <source>the permissions are not signed by permissions_ca.pem</source>
        <translation>权限不是由 permissions_ca.pem 签名的</translation>
    </message>
    <message>
        <source>the permissions do not name the subject of the certificate</source>
        <translation>权限中没有证书的主体</translation>
    </message>
    <message>
        <source>the permissions have expired</source>
        <translation>权限已过期</translation>
    </message>
    <message>
        <source>the permissions are not valid yet</source>
        <translation>权限尚未生效</translation>
    </message>
    <message>
        <source>the permissions (permissions.p7s) do not allow this domain</source>
        <translation>权限（permissions.p7s）不允许此域</translation>
    </message>
    <message>
        <source>the governance (governance.p7s) does not name this domain</source>
        <translation>治理文件（governance.p7s）中没有此域</translation>
    </message>
    <message>
        <source>the plugins of DDS Security cannot be loaded</source>
        <translation>无法加载 DDS Security 的插件</translation>
    </message>
</context>
<context>
    <name>Demo</name>
    <message>
        <source>An arm touches five materials</source>
        <translation>机械臂触碰五种材料</translation>
    </message>
    <message>
        <source>An arm explores a round object</source>
        <translation>机械臂探索圆形物体</translation>
    </message>
    <message>
        <source>An arm explores a rectangular object</source>
        <translation>机械臂探索矩形物体</translation>
    </message>
    <message>
        <source>The same with a box</source>
        <translation>同上，对象为盒子</translation>
    </message>
    <message>
        <source>An arm explores a triangular object</source>
        <translation>机械臂探索三角形物体</translation>
    </message>
    <message>
        <source>The same with a triangular prism</source>
        <translation>同上，对象为三棱柱</translation>
    </message>
    <message>
        <source>An arm yields</source>
        <translation>机械臂顺应</translation>
    </message>
    <message>
        <source>Somebody pushes the arm, then it meets an object, under joint admittance control</source>
        <translation>有人推动机械臂，随后它碰到物体，采用关节导纳控制</translation>
    </message>
    <message>
        <source>A ball and a bar</source>
        <translation>小球与杆</translation>
    </message>
    <message>
        <source>A 6 x 14 array pressed by a ball that wanders, then by a bar that turns</source>
        <translation>6 x 14 阵列先由移动的小球按压，再由转动的杆按压</translation>
    </message>
    <message>
        <source>Two contacts that meet</source>
        <translation>两个相遇的接触</translation>
    </message>
    <message>
        <source>Two balls that approach each other until they touch, and part</source>
        <translation>两个小球相互靠近直至接触，然后分开</translation>
    </message>
    <message>
        <source>A pressure mat</source>
        <translation>压力垫</translation>
    </message>
    <message>
        <source>A 64 x 27 mat under a body: a head, a trunk that turns, two heels</source>
        <translation>人体下的 64 x 27 压力垫：头部、转动的躯干、两个脚跟</translation>
    </message>
    <message>
        <source>Something pokes a soft arm</source>
        <translation>有物体戳软体臂</translation>
    </message>
    <message>
        <source>A camera inside the soft tube sees the bump; the arm draws back</source>
        <translation>软管内的相机看到碰撞；机械臂退缩</translation>
    </message>
    <message>
        <source>A finger turns a soft arm</source>
        <translation>手指转动软体臂</translation>
    </message>
    <message>
        <source>The arm turns after a finger that goes round it</source>
        <translation>机械臂随绕其转动的手指转动</translation>
    </message>
    <message>
        <source>A finger leads a soft arm</source>
        <translation>手指引导软体臂</translation>
    </message>
    <message>
        <source>The arm follows a finger along its axis</source>
        <translation>机械臂沿其轴线跟随手指</translation>
    </message>
    <message>
        <source>Three fingers on a soft arm</source>
        <translation>三根手指按在软体臂上</translation>
    </message>
    <message>
        <source>Contacts near the lens, in the middle and at the far end of the tube</source>
        <translation>接触位于镜头附近、管的中部和远端</translation>
    </message>
    <message>
        <source>An array follows a bent bar</source>
        <translation>阵列跟随弯曲的杆</translation>
    </message>
    <message>
        <source>It closes in, aligns with the bar, and slides along its bend at 5 N</source>
        <translation>阵列靠近并与杆对齐，以 5 N 的力沿其弯曲处滑动</translation>
    </message>
    <message>
        <source>A tray is kept level</source>
        <translation>保持托盘水平</translation>
    </message>
    <message>
        <source>A weight moves on the tray; the hand feels its moment and tilts against it</source>
        <translation>重物在托盘上移动；手感受到其力矩并反向倾斜</translation>
    </message>
    <message>
        <source>An array rolls on a ball</source>
        <translation>阵列在小球上滚动</translation>
    </message>
    <message>
        <source>The contact wanders over the array while the force stays at 4 N</source>
        <translation>接触在阵列上移动，而力保持为 4 N</translation>
    </message>
    <message>
        <source>An arm among unknown objects</source>
        <translation>未知物体之间的机械臂</translation>
    </message>
    <message>
        <source>Arm</source>
        <translation>机械臂</translation>
    </message>
    <message>
        <source>Array</source>
        <translation>阵列</translation>
    </message>
    <message>
        <source>Servo</source>
        <translation>伺服</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>相机</translation>
    </message>
    <message>
        <source>Study</source>
        <translation>研究</translation>
    </message>
    <message>
        <source>Simulated participants answer, and the confusion matrix fills</source>
        <translation>模拟被试作出回答，混淆矩阵逐渐填满</translation>
    </message>
    <message>
        <source>The published protocol</source>
        <translation>已发表的方案</translation>
    </message>
    <message>
        <source>Stimuli, practice and test trials: read it, and begin a study with it</source>
        <translation>刺激、练习试次和测试试次：阅读它，并用它开始一项研究</translation>
    </message>
    <message>
        <source>Patterns</source>
        <translation>图案</translation>
    </message>
    <message>
        <source>A rehearsed study</source>
        <translation>研究的预演</translation>
    </message>
    <message>
        <source>A shape as a vibration pattern: play it, or edit a copy</source>
        <translation>以振动图案表示的形状：可播放，或编辑其副本</translation>
    </message>
    <message>
        <source>A stiffness as a vibration pattern: play it, or edit a copy</source>
        <translation>以振动图案表示的刚度：可播放，或编辑其副本</translation>
    </message>
    <message>
        <source>Balls press a flat gel</source>
        <translation>球压平面凝胶</translation>
    </message>
    <message>
        <source>Markers on the skin of a flat gel move apart under two balls</source>
        <translation>平面凝胶表面的标记在两个球下散开</translation>
    </message>
    <message>
        <source>A ball shears a flat gel</source>
        <translation>球剪切平面凝胶</translation>
    </message>
    <message>
        <source>It is dragged to and fro and sticks but for a narrow rim</source>
        <translation>来回拖动，除狭窄的边缘外保持粘着</translation>
    </message>
    <message>
        <source>A ball slips on a flat gel</source>
        <translation>球在平面凝胶上滑动</translation>
    </message>
    <message>
        <source>A ring of slip grows from the rim of the contact to its middle</source>
        <translation>滑动环从接触边缘向中心扩展</translation>
    </message>
    <message>
        <source>A ball twists a flat gel</source>
        <translation>球扭转平面凝胶</translation>
    </message>
    <message>
        <source>It is turned about the normal, and the skin turns with it</source>
        <translation>球绕法线转动，表面随之转动</translation>
    </message>
    <message>
        <source>A ball bumps into a flat gel</source>
        <translation>小球撞上平面凝胶</translation>
    </message>
    <message>
        <source>The arm that carries the gel draws back</source>
        <translation>携带凝胶的机械臂后退</translation>
    </message>
    <message>
        <source>A ball leads a flat gel</source>
        <translation>小球牵引平面凝胶</translation>
    </message>
    <message>
        <source>The arm follows a ball that drags the gel along</source>
        <translation>机械臂跟随拖动凝胶的小球</translation>
    </message>
    <message>
        <source>From sponge to metal: where it touches, how hard and how stiff</source>
        <translation>从海绵到金属：触碰位置、力和刚度</translation>
    </message>
    <message>
        <source>Outline and shape from single touches</source>
        <translation>由逐次触碰得出轮廓和形状</translation>
    </message>
    <message>
        <source>Find them over a slow link, or watch</source>
        <translation>经慢速链路寻找它们，或观看</translation>
    </message>
</context>
<context>
    <name>DeviceState</name>
    <message>
        <source>closed</source>
        <translation>已关闭</translation>
    </message>
    <message>
        <source>connecting</source>
        <translation>正在连接</translation>
    </message>
    <message>
        <source>live</source>
        <translation>实时</translation>
    </message>
    <message>
        <source>paused</source>
        <translation>已暂停</translation>
    </message>
    <message>
        <source>stale</source>
        <translation>数据过时</translation>
    </message>
    <message>
        <source>lost</source>
        <translation>已断开</translation>
    </message>
    <message>
        <source>reconnecting</source>
        <translation>正在重新连接</translation>
    </message>
    <message>
        <source>finished</source>
        <translation>已结束</translation>
    </message>
</context>
<context>
    <name>DevicesCommand</name>
    <message>
        <source>&quot;kind&quot; is missing</source>
        <translation>缺少“kind”</translation>
    </message>
    <message>
        <source>Bracelet</source>
        <translation>手环</translation>
    </message>
    <message>
        <source>3D mouse</source>
        <translation>3D 鼠标</translation>
    </message>
    <message>
        <source>Tactile array</source>
        <translation>触觉阵列</translation>
    </message>
    <message>
        <source>Modbus device</source>
        <translation>Modbus 设备</translation>
    </message>
    <message>
        <source>%1 at %2</source>
        <translation>%1，位于 %2</translation>
    </message>
    <message>
        <source>State</source>
        <translation>状态</translation>
    </message>
    <message>
        <source>not connected: %1</source>
        <translation>未连接：%1</translation>
    </message>
    <message>
        <source>connected</source>
        <translation>已连接</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>帧</translation>
    </message>
    <message>
        <source>up to %1 Hz</source>
        <translation>最高 %1 Hz</translation>
    </message>
    <message>
        <source>Inputs</source>
        <translation>输入</translation>
    </message>
    <message>
        <source>No device is connected.</source>
        <translation>未连接任何设备。</translation>
    </message>
    <message>
        <source>Connect to the device of this description and read it; its motors are set to zero</source>
        <translation>连接此描述文件所述的设备并读取；其电机置零</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>相机</translation>
    </message>
    <message>
        <source>List connected devices, how fast they are, and why others cannot be used</source>
        <translation>已连接的设备、未连接的原因及其速度</translation>
    </message>
    <message>
        <source>it answers, but sends no frames</source>
        <translation>有应答，但不发送帧</translation>
    </message>
    <message>
        <source>%1 Hz</source>
        <translation>%1 Hz</translation>
    </message>
    <message>
        <source>nothing came from it</source>
        <translation>没有收到任何数据</translation>
    </message>
    <message numerus="yes">
        <source>it sends frames of %n chip(s)</source>
        <translation>
            <numerusform>它发送含 %n 个芯片的帧</numerusform>
        </translation>
    </message>
    <message>
        <source>there is no frame in what came from it, as the file describes them</source>
        <translation>收到的数据中没有文件所描述的帧</translation>
    </message>
    <message>
        <source>Of a described array: show at most so many of the bytes that it sends until a second after its first frame</source>
        <translation>对于已描述的阵列：最多显示其在第一帧之后一秒内发送的这么多字节</translation>
    </message>
    <message>
        <source>the sensor file names no camera and no video</source>
        <translation>传感器文件未指明相机或视频</translation>
    </message>
    <message>
        <source>a key &quot;source&quot;</source>
        <translation>键“source”</translation>
    </message>
    <message>
        <source>Flat gel with markers</source>
        <translation>带标记的平面凝胶</translation>
    </message>
    <message>
        <source>kind = &quot;modbus&quot;, &quot;wts&quot;, &quot;camera&quot;, &quot;hid_bracelet&quot;, &quot;taxels&quot;, &quot;magnetometers&quot;, &quot;xela&quot;, &quot;sound_bracelet&quot;, &quot;marker_gel&quot;, &quot;ros_tactile&quot; or &quot;ros_camera&quot;</source>
        <translation>kind = &quot;modbus&quot;、&quot;wts&quot;、&quot;camera&quot;、&quot;hid_bracelet&quot;、&quot;taxels&quot;、&quot;magnetometers&quot;、&quot;xela&quot;、&quot;sound_bracelet&quot;、&quot;marker_gel&quot;、&quot;ros_tactile&quot; 或 &quot;ros_camera&quot;</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>警告</translation>
    </message>
    <message>
        <source>the temperature of chip %1 changed by %2 K while it was probed: what the sensor reads at rest moves with it. Wait until it is warm</source>
        <translation>探测期间芯片 %1 的温度变化了 %2 K：传感器的静止读数随之变化。请等待其预热</translation>
    </message>
    <message>
        <source>this is for a bracelet on a sound card</source>
        <translation>此选项用于声卡上的手环</translation>
    </message>
    <message>
        <source>Of a bracelet on a sound card: play clicks on tactor 1 and measure when they are heard on this input, at which an accelerometer or a cable is</source>
        <translation>对于声卡上的手环：在致动器 1 上播放咔嗒声，并测量它们何时在此输入（接有加速度计或电缆）上被听到</translation>
    </message>
</context>
<context>
    <name>DriverText</name>
    <message>
        <source>the simulated motor driver cannot open a port: %1</source>
        <translation>模拟电机驱动器无法打开端口：%1</translation>
    </message>
    <message>
        <source>the device has no motors</source>
        <translation>该设备没有电机</translation>
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
        <translation>%1 小时 %2 分</translation>
    </message>
</context>
<context>
    <name>EqualStrength</name>
    <message>
        <source>tactor %1 has no level at which it feels as strong as tactor %2</source>
        <translation>振子 %1 没有感觉与振子 %2 同样强的水平</translation>
    </message>
    <message>
        <source>a level for each of the six tactors</source>
        <translation>六个振子各自的水平</translation>
    </message>
</context>
<context>
    <name>Error</name>
    <message>
        <source> (expected %1)</source>
        <translation> （应为：%1）</translation>
    </message>
</context>
<context>
    <name>ExclusionReport</name>
    <message>
        <source>%1 (marked in the file)</source>
        <translation>%1（在文件中标记）</translation>
    </message>
    <message>
        <source>%1 (made after the data)</source>
        <translation>%1（在数据之后制定）</translation>
    </message>
    <message>
        <source>What was left out, in the order of the rules; nothing was deleted</source>
        <translation>被排除的内容，按规则的顺序；没有删除任何数据</translation>
    </message>
    <message>
        <source>Rule</source>
        <translation>规则</translation>
    </message>
    <message>
        <source>Trials before</source>
        <translation>之前的试次</translation>
    </message>
    <message>
        <source>Trials</source>
        <translation>试次</translation>
    </message>
    <message>
        <source>Sessions</source>
        <translation>场次</translation>
    </message>
    <message>
        <source>Participants</source>
        <translation>被试</translation>
    </message>
    <message>
        <source>Remark</source>
        <translation>备注</translation>
    </message>
    <message numerus="yes">
        <source>no spread of the times, so nothing was left out, in %n case(s)</source>
        <translation>
            <numerusform>%n 处的时间没有离散，因此未排除任何数据</numerusform>
        </translation>
    </message>
    <message>
        <source>The results with the rules, and without them</source>
        <translation>应用规则与不应用规则的结果</translation>
    </message>
    <message>
        <source>Task</source>
        <translation>任务</translation>
    </message>
    <message>
        <source>Condition or effect</source>
        <translation>条件或效应</translation>
    </message>
    <message>
        <source>Correct, %</source>
        <translation>正确，%</translation>
    </message>
    <message>
        <source>Correct without rules, %</source>
        <translation>无规则时正确，%</translation>
    </message>
    <message>
        <source>p GG without rules</source>
        <translation>无规则时 p GG</translation>
    </message>
    <message>
        <source>Exclusions</source>
        <translation>排除</translation>
    </message>
</context>
<context>
    <name>ExclusionRule</name>
    <message>
        <source>the rule %1 is about something else</source>
        <translation>规则 %1 针对的是其他对象</translation>
    </message>
    <message>
        <source>&quot;%1&quot;</source>
        <translation>&quot;%1&quot;</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no exclusion rule</source>
        <translation>“%1”不是排除规则</translation>
    </message>
    <message>
        <source>RULE=VALUE with one of %1</source>
        <translation>RULE=VALUE，其中 RULE 为 %1 之一</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has no usable value</source>
        <translation>“%1”没有可用的值</translation>
    </message>
    <message>
        <source>%1=VALUE with %2</source>
        <translation>%1=VALUE，其中 VALUE 为 %2</translation>
    </message>
</context>
<context>
    <name>ExportCommand</name>
    <message numerus="yes">
        <source>%n row(s)</source>
        <translation>
            <numerusform>%n 行</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n damaged block(s) left out</source>
        <translation>
            <numerusform>略去 %n 个损坏的数据块</numerusform>
        </translation>
    </message>
    <message>
        <source>Note</source>
        <translation>备注</translation>
    </message>
    <message>
        <source>The recording was cut off; what had been written is there.</source>
        <translation>记录被截断；已写入的内容仍保留。</translation>
    </message>
    <message>
        <source>Recording of the console or of teleta simulate</source>
        <translation>控制台或 teleta simulate 的记录</translation>
    </message>
    <message>
        <source>Write over files that are there already</source>
        <translation>覆盖已有文件</translation>
    </message>
    <message>
        <source>another folder, or --force</source>
        <translation>另一个文件夹，或 --force</translation>
    </message>
    <message>
        <source>start, units and origin of these files</source>
        <translation>这些文件的起始时间、单位和来源</translation>
    </message>
    <message numerus="yes">
        <source>%n message(s)</source>
        <translation>
            <numerusform>%n 条消息</numerusform>
        </translation>
    </message>
    <message>
        <source>The camera sees a left-handed frame: y of %1 has changed its sign.</source>
        <translation>相机采用左手坐标系：%1 的 y 已改变符号。</translation>
    </message>
    <message>
        <source>%1 has no messages in ROS and was left out.</source>
        <translation>%1 在 ROS 中没有对应的消息，已略去。</translation>
    </message>
    <message>
        <source>Folder for a CSV file a stream, events.csv and recording.json</source>
        <translation>文件夹，用于存放每个数据流的 CSV 文件、events.csv 和 recording.json</translation>
    </message>
    <message>
        <source>List the streams of the recording: name and kind</source>
        <translation>列出记录中的数据流：名称和种类</translation>
    </message>
    <message>
        <source>Add a last column utc_s: Unix time in s with nine decimals</source>
        <translation>在最后添加一列 utc_s：Unix 时间，单位 s，九位小数</translation>
    </message>
    <message>
        <source>MCAP file for Foxglove and ROS 2</source>
        <translation>用于 Foxglove 和 ROS 2 的 MCAP 文件</translation>
    </message>
    <message>
        <source>Compression of the MCAP file</source>
        <translation>MCAP 文件的压缩方式</translation>
    </message>
    <message>
        <source>Size of a chunk of the MCAP file in MiB</source>
        <translation>MCAP 文件的数据块大小，单位 MiB</translation>
    </message>
    <message>
        <source>another name, or --force</source>
        <translation>另一个名称，或 --force</translation>
    </message>
    <message numerus="yes">
        <source>%n frame(s)</source>
        <translation>
            <numerusform>%n 帧</numerusform>
        </translation>
    </message>
    <message>
        <source>NumPy file with the arrays frames and time_s of a tactile array</source>
        <translation>NumPy 文件，含触觉阵列的数组 frames 和 time_s</translation>
    </message>
    <message>
        <source>Only these streams into the MCAP file; the array of the NumPy file</source>
        <translation>只将这些数据流写入 MCAP 文件；对 NumPy 文件则为所用的阵列</translation>
    </message>
    <message>
        <source>either a folder here or a file after --mcap or --npz is needed</source>
        <translation>须在此处给出文件夹，或在 --mcap 或 --npz 之后给出文件</translation>
    </message>
    <message>
        <source>only with --mcap or --npz</source>
        <translation>仅可与 --mcap 或 --npz 一起使用</translation>
    </message>
    <message>
        <source>only one with --npz</source>
        <translation>与 --npz 一起使用时只能给出一个</translation>
    </message>
    <message>
        <source>Write the streams of a recording as CSV, MCAP or NumPy files</source>
        <translation>将记录中的数据流写为 CSV、MCAP 或 NumPy 文件</translation>
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
        <translation>触觉片段（zip 中的 .haptic）</translation>
    </message>
    <message>
        <source>AHAP (in a zip)</source>
        <translation>AHAP（zip 压缩包）</translation>
    </message>
    <message>
        <source>tact</source>
        <translation>tact</translation>
    </message>
    <message>
        <source>CSV table</source>
        <translation>CSV 表格</translation>
    </message>
    <message>
        <source>WAV, six channels</source>
        <translation>WAV，六声道</translation>
    </message>
    <message>
        <source>One channel per motor, with its place on the forearm. Can be read back.</source>
        <translation>每个电机一个通道，含其在前臂上的位置。可重新读取。</translation>
    </message>
    <message>
        <source>One clip per motor. Can be read back.</source>
        <translation>每个电机一个片段。可重新读取。</translation>
    </message>
    <message>
        <source>Columns time_s, t1 to t6: one sample per row.</source>
        <translation>列 time_s、t1 至 t6：每行一个样本。</translation>
    </message>
    <message>
        <source>One file per motor, for Core Haptics. Can be read back.</source>
        <translation>每个电机一个文件，用于 Core Haptics。可重新读取。</translation>
    </message>
    <message>
        <source>Six motors on the forearm, whole milliseconds; slopes become steps of 20 ms. Can be read back.</source>
        <translation>前臂上的六个电机，时间为整毫秒；斜坡变为每级 20 ms 的阶梯。可重新读取。</translation>
    </message>
    <message>
        <source>16-bit samples, 1 is full scale. Vibrations drive voice coils; bare intensities are for programs that make the vibration themselves.</source>
        <translation>16 位样本，1 为满量程。振动用于驱动音圈；纯强度用于自行产生振动的程序。</translation>
    </message>
</context>
<context>
    <name>FaultInjector</name>
    <message>
        <source>the recording did not fail on a full disk</source>
        <translation>磁盘已满时记录没有失败</translation>
    </message>
    <message>
        <source>the program under test ended by itself</source>
        <translation>被测程序自行结束了</translation>
    </message>
    <message>
        <source>nothing moved within 30 s</source>
        <translation>30 秒内没有任何运动</translation>
    </message>
    <message>
        <source>the device does not answer any more</source>
        <translation>设备不再应答</translation>
    </message>
    <message>
        <source>nothing moved within 30 s: %1</source>
        <translation>30 秒内没有任何运动：%1</translation>
    </message>
</context>
<context>
    <name>FeaturesCommand</name>
    <message>
        <source>Force, centres, moments and orientation of each tactile frame</source>
        <translation>每个触觉帧的力、中心、矩和方向</translation>
    </message>
</context>
<context>
    <name>FeltTask</name>
    <message>
        <source>Motor %1: %2</source>
        <comment>a motor, and what is wrong with the answers</comment>
        <translation>电机 %1：%2</translation>
    </message>
</context>
<context>
    <name>FeltThreshold</name>
    <message>
        <source>There are too few answers: %1.</source>
        <translation>回答过少：%1。</translation>
    </message>
    <message>
        <source>at least %1</source>
        <translation>至少 %1</translation>
    </message>
    <message>
        <source>yes only when something was clearly felt</source>
        <translation>仅在明确感觉到时回答“是”</translation>
    </message>
    <message>
        <source>Nothing was felt, not even at the highest drive.</source>
        <translation>即使在最高驱动量下也没有感觉到。</translation>
    </message>
    <message>
        <source>Everything was felt, even at the lowest drive.</source>
        <translation>即使在最低驱动量下也都感觉到了。</translation>
    </message>
    <message>
        <source>The answers contradict each other: stronger was felt less often than weaker, or as often.</source>
        <translation>回答相互矛盾：较强的刺激被感觉到的次数不多于较弱的。</translation>
    </message>
    <message>
        <source>The answer was yes in %1 of %2 cases in which nothing was presented.</source>
        <translation>未呈现任何刺激时回答了“是”，%2 次中有 %1 次。</translation>
    </message>
    <message>
        <source>a connected motor in contact with the skin</source>
        <translation>已连接且贴在皮肤上的电机</translation>
    </message>
    <message>
        <source>no when nothing was felt</source>
        <translation>没有感觉到时回答“否”</translation>
    </message>
    <message>
        <source>consistent answers; undo the wrong ones or start again</source>
        <translation>如实反映感觉的回答；请撤销错误的回答或重新开始</translation>
    </message>
</context>
<context>
    <name>FigureExport</name>
    <message>
        <source>The file could not be written: %1</source>
        <translation>无法写入文件：%1</translation>
    </message>
    <message>
        <source>Unknown picture format &quot;%1&quot;</source>
        <translation>未知的图片格式“%1”</translation>
    </message>
</context>
<context>
    <name>FigureText</name>
    <message>
        <source>Actual pattern</source>
        <translation>实际图案</translation>
    </message>
    <message>
        <source>cannot draw the picture: %1</source>
        <translation>无法绘制图片：%1</translation>
    </message>
    <message>
        <source>the picture has no size</source>
        <translation>图片没有尺寸</translation>
    </message>
    <message>
        <source>the picture would have too many pixels</source>
        <translation>图片像素过多</translation>
    </message>
    <message>
        <source>Force, N</source>
        <translation>力，N</translation>
    </message>
    <message>
        <source>CoP y, mm</source>
        <translation>CoP y，mm</translation>
    </message>
    <message>
        <source>CoC x, mm</source>
        <translation>CoC x，mm</translation>
    </message>
    <message>
        <source>DZMP y, mm</source>
        <translation>DZMP y，mm</translation>
    </message>
    <message>
        <source>α z, °</source>
        <translation>α z，°</translation>
    </message>
    <message>
        <source>Turn z, °</source>
        <translation>绕 z 转动，°</translation>
    </message>
    <message>
        <source>Tactile servoing: force and features over time</source>
        <translation>触觉伺服：力与特征随时间的变化</translation>
    </message>
    <message>
        <source>desired</source>
        <translation>期望</translation>
    </message>
    <message>
        <source>true</source>
        <translation>真实</translation>
    </message>
    <message>
        <source>in contact</source>
        <translation>接触中</translation>
    </message>
    <message>
        <source>weight is moved; its moment is gone</source>
        <translation>砝码移动；其力矩消失</translation>
    </message>
    <message>
        <source>Tactile servoing, simulated</source>
        <translation>触觉伺服，模拟</translation>
    </message>
    <message>
        <source>Tactile servoing</source>
        <translation>触觉伺服</translation>
    </message>
    <message>
        <source>a limit acts (%1)</source>
        <translation>限制起作用（%1）</translation>
    </message>
    <message>
        <source>time, s</source>
        <translation>时间，s</translation>
    </message>
    <message>
        <source>Subject response, %</source>
        <translation>被试的回答，%</translation>
    </message>
    <message>
        <source>Subject response, trials</source>
        <translation>被试的回答，试次数</translation>
    </message>
    <message>
        <source>Subject response, % and trials</source>
        <translation>被试的回答，% 与试次数</translation>
    </message>
    <message>
        <source>Position, mm</source>
        <translation>位置，mm</translation>
    </message>
    <message>
        <source>Path, mm</source>
        <translation>路径，mm</translation>
    </message>
</context>
<context>
    <name>FileApartText</name>
    <message>
        <source>reading it takes too long</source>
        <translation>读取它耗时过长</translation>
    </message>
    <message>
        <source>reading it takes too much memory</source>
        <translation>读取它占用内存过多</translation>
    </message>
    <message>
        <source>the library that reads it stopped unexpectedly</source>
        <translation>读取它的库停止了</translation>
    </message>
    <message>
        <source>the file changed while it was read</source>
        <translation>读取期间文件发生了变化</translation>
    </message>
    <message>
        <source>no process can be started to read the file: %1</source>
        <translation>无法启动读取文件的进程：%1</translation>
    </message>
    <message>
        <source>the file is damaged: %1</source>
        <translation>文件已损坏：%1</translation>
    </message>
    <message>
        <source>a whole file</source>
        <translation>完整的文件</translation>
    </message>
</context>
<context>
    <name>FileKeysText</name>
    <message>
        <source>&quot;%1&quot; is not a topic name</source>
        <translation>“%1”不是话题名称</translation>
    </message>
    <message>
        <source>parts of letters, digits and _ after slashes, for example /joint_states</source>
        <translation>斜杠后由字母、数字和 _ 组成的各部分，例如 /joint_states</translation>
    </message>
</context>
<context>
    <name>FileKindText</name>
    <message>
        <source>text</source>
        <translation>文本</translation>
    </message>
    <message>
        <source>a NumPy array (npy)</source>
        <translation>NumPy 数组（npy）</translation>
    </message>
    <message>
        <source>a zip archive (npz is one)</source>
        <translation>zip 压缩包（npz 即是）</translation>
    </message>
    <message>
        <source>an HDF5 file</source>
        <translation>HDF5 文件</translation>
    </message>
    <message>
        <source>a MAT file</source>
        <translation>MAT 文件</translation>
    </message>
    <message>
        <source>a MAT file of version 7.3</source>
        <translation>7.3 版 MAT 文件</translation>
    </message>
    <message>
        <source>an SQLite database, such as a recording</source>
        <translation>SQLite 数据库，例如记录</translation>
    </message>
    <message>
        <source>an MCAP file</source>
        <translation>MCAP 文件</translation>
    </message>
    <message>
        <source>a file that gzip has packed</source>
        <translation>gzip 压缩的文件</translation>
    </message>
    <message>
        <source>a file that zstd has packed</source>
        <translation>zstd 压缩的文件</translation>
    </message>
    <message>
        <source>a PNG picture</source>
        <translation>PNG 图片</translation>
    </message>
    <message>
        <source>a JPEG picture</source>
        <translation>JPEG 图片</translation>
    </message>
    <message>
        <source>a PDF document</source>
        <translation>PDF 文档</translation>
    </message>
    <message>
        <source>an old Excel file</source>
        <translation>旧版 Excel 文件</translation>
    </message>
    <message>
        <source>a Parquet file</source>
        <translation>Parquet 文件</translation>
    </message>
    <message>
        <source>a pickle of Python</source>
        <translation>Python 的 pickle 文件</translation>
    </message>
    <message>
        <source>a video</source>
        <translation>视频</translation>
    </message>
    <message>
        <source>a WAV sound</source>
        <translation>WAV 音频</translation>
    </message>
    <message>
        <source>text in UTF-16</source>
        <translation>UTF-16 编码的文本</translation>
    </message>
    <message>
        <source>binary data of no known format</source>
        <translation>格式未知的二进制数据</translation>
    </message>
</context>
<context>
    <name>FileText</name>
    <message>
        <source>one of %1</source>
        <translation>%1 之一</translation>
    </message>
    <message>
        <source>there are %1 motors</source>
        <translation>有 %1 个电机</translation>
    </message>
    <message>
        <source>there is no such file or built-in pattern</source>
        <translation>没有这样的文件或内置图案</translation>
    </message>
    <message>
        <source>this format holds one tactor, the pattern uses more</source>
        <translation>此格式只容纳一个振子，而图案使用了更多</translation>
    </message>
    <message>
        <source>a name that ends with %1</source>
        <translation>以 %1 结尾的文件名</translation>
    </message>
    <message>
        <source>these values are inconsistent</source>
        <translation>这些值相互矛盾</translation>
    </message>
    <message>
        <source>0 &lt; start_drive &lt; full_drive, and a curve that rises from the start or below it to drive 1</source>
        <translation>0 &lt; start_drive &lt; full_drive，曲线从启动点或其之前上升到驱动量 1</translation>
    </message>
    <message>
        <source>the file was written by a newer version</source>
        <translation>文件版本较新</translation>
    </message>
    <message>
        <source>the profile belongs to the bracelet &quot;%1&quot;</source>
        <translation>该配置属于手环“%1”</translation>
    </message>
    <message>
        <source>a pattern file, or an id listed by teleta pattern list</source>
        <translation>图案文件，或 teleta pattern list 中的 ID</translation>
    </message>
    <message>
        <source>the file name extension is unknown</source>
        <translation>无法由文件扩展名确定格式</translation>
    </message>
    <message>
        <source>this format can be written but not read</source>
        <translation>此格式的图案只能写出，不能读取</translation>
    </message>
</context>
<context>
    <name>FinderNames</name>
    <message>
        <source>As published</source>
        <translation>如论文所述</translation>
    </message>
    <message>
        <source>Printed dots</source>
        <translation>印刷点</translation>
    </message>
    <message>
        <source>Coarse flow</source>
        <translation>粗略光流</translation>
    </message>
    <message>
        <source>Quick flow</source>
        <translation>快速光流</translation>
    </message>
    <message>
        <source>Fine flow</source>
        <translation>精细光流</translation>
    </message>
    <message>
        <source>%1, changed parts</source>
        <comment>a finder that looks only at those</comment>
        <translation>%1，变化的部分</translation>
    </message>
    <message>
        <source>%1, from the last picture</source>
        <comment>a finder that starts there</comment>
        <translation>%1，从上一幅图像开始</translation>
    </message>
    <message>
        <source>%1, 1 : %2</source>
        <comment>a finder and how many times its picture is smaller</comment>
        <translation>%1，1 : %2</translation>
    </message>
    <message>
        <source>%1, whole picture</source>
        <comment>a finder</comment>
        <translation>%1，整幅图像</translation>
    </message>
    <message>
        <source>%1 % of the picture&apos;s points</source>
        <translation>图像中 %1 % 的点</translation>
    </message>
    <message>
        <source>fine; %1, mean of those that moved</source>
        <translation>精细；%1，取移动的点的平均</translation>
    </message>
    <message>
        <source>follows each dot alone; the default</source>
        <translation>只跟踪每个点；默认</translation>
    </message>
    <message>
        <source>quickest and coarsest; %1</source>
        <translation>最快也最粗略；%1</translation>
    </message>
    <message>
        <source>quick; %1, where they differ from the reference</source>
        <translation>快；%1，仅在与参考不同之处</translation>
    </message>
    <message>
        <source>quick; %1</source>
        <translation>快；%1</translation>
    </message>
    <message>
        <source>slowest and finest; %1</source>
        <translation>最慢也最精细；%1</translation>
    </message>
    <message>
        <source>As in the published work: dense flow in a picture of 512 × 288, and the mean of the points that moved</source>
        <translation>与已发表的工作相同：在 512 × 288 的图像中计算稠密光流，并取其中移动部分的平均值</translation>
    </message>
    <message>
        <source>Each printed dot is followed in the whole picture. The default.</source>
        <translation>在原尺寸图像中跟踪每个印刷圆点。默认方式。</translation>
    </message>
    <message>
        <source>the quickest and coarsest</source>
        <translation>最快、最粗略</translation>
    </message>
    <message>
        <source>a quick one</source>
        <translation>较快</translation>
    </message>
    <message>
        <source>the slowest and finest</source>
        <translation>最慢、最精细</translation>
    </message>
    <message>
        <source>Dense flow by a preset of OpenCV (%1), in a picture %2 times smaller</source>
        <translation>采用 OpenCV 预设（%1）的稠密光流，在缩小到 1/%2 的图像中计算</translation>
    </message>
    <message>
        <source>Dense flow by a preset of OpenCV (%1), in the whole picture</source>
        <translation>采用 OpenCV 预设（%1）的稠密光流，在原尺寸图像中计算</translation>
    </message>
    <message>
        <source>Only where the picture differs from the reference</source>
        <translation>仅在与参考不同之处的周围</translation>
    </message>
    <message>
        <source>Starts from the flow of the previous picture</source>
        <translation>以前一幅图像的光流为初值</translation>
    </message>
</context>
<context>
    <name>ForeignDatabase</name>
    <message>
        <source>SQLite cannot be made defensive</source>
        <translation>无法让 SQLite 进入防御模式</translation>
    </message>
    <message>
        <source>SQLite %1 or newer</source>
        <translation>SQLite %1 或更新版本</translation>
    </message>
    <message>
        <source>the file holds a %1, &quot;%2&quot;, which this program does not make</source>
        <comment>view, trigger or (virtual) table of a database</comment>
        <translation>文件中有本程序不会创建的 %1“%2”</translation>
    </message>
    <message>
        <source>plain tables and indices only</source>
        <translation>仅普通的表和索引</translation>
    </message>
</context>
<context>
    <name>FrameFileText</name>
    <message>
        <source>column %1 is &quot;%2&quot;</source>
        <translation>第 %1 列为“%2”</translation>
    </message>
    <message>
        <source>there are no taxel columns</source>
        <translation>没有触觉单元列</translation>
    </message>
    <message>
        <source>the columns time_s, t0, t1, ...</source>
        <translation>列 time_s, t0, t1, ...</translation>
    </message>
    <message>
        <source>the file has %1 taxel columns</source>
        <translation>文件有 %1 个触觉单元列</translation>
    </message>
    <message>
        <source>%1 = %2 rows x %3 columns</source>
        <translation>%1 = %2 行 x %3 列</translation>
    </message>
    <message>
        <source>the recording has no frames</source>
        <translation>记录中没有帧</translation>
    </message>
    <message>
        <source>the time is %1</source>
        <translation>时间为 %1</translation>
    </message>
    <message>
        <source>a finite time in s</source>
        <translation>以 s 为单位的有限时间</translation>
    </message>
    <message>
        <source>the time goes back from %1 to %2</source>
        <translation>时间从 %1 倒退到 %2</translation>
    </message>
    <message>
        <source>times that do not decrease</source>
        <translation>不递减的时间</translation>
    </message>
    <message>
        <source>at least one row after the header</source>
        <translation>标题行之后至少一行</translation>
    </message>
    <message>
        <source>the frames are of vectors, t0_x,t0_y,t0_z</source>
        <translation>帧是向量：t0_x,t0_y,t0_z</translation>
    </message>
    <message>
        <source>one number a taxel; or the file that says where the taxels are (--layout FILE.toml)</source>
        <translation>每个触觉单元一个数；或说明触觉单元位置的文件（--layout FILE.toml）</translation>
    </message>
</context>
<context>
    <name>FrameImportText</name>
    <message>
        <source>interrupted</source>
        <translation>已中断</translation>
    </message>
    <message>
        <source>the frames span more than %1 years</source>
        <translation>这些帧跨越了 %1 年以上</translation>
    </message>
    <message>
        <source>times in seconds, or their unit (--time-unit UNIT)</source>
        <translation>以秒为单位的时间，或其单位（--time-unit UNIT）</translation>
    </message>
</context>
<context>
    <name>FrameOptionText</name>
    <message>
        <source>%1 is given, a taxel from 0 to %2 is expected</source>
        <translation>给出的是 %1，应为 0 至 %2 的触觉单元</translation>
    </message>
    <message>
        <source>Rows of the array</source>
        <translation>阵列的行数</translation>
    </message>
    <message>
        <source>Distance of neighbouring taxels in mm</source>
        <translation>相邻触觉单元的间距，mm</translation>
    </message>
    <message>
        <source>The raw values fall under load</source>
        <translation>原始值随载荷增大而下降</translation>
    </message>
    <message>
        <source>N per raw unit</source>
        <translation>每原始单位的 N 数</translation>
    </message>
    <message>
        <source>Numbers of taxels to leave out, such as 0,17</source>
        <translation>要排除的触觉单元编号，例如 0,17</translation>
    </message>
    <message>
        <source>Weight the taxels with their load to find the principal axis</source>
        <translation>按载荷对触觉单元加权来求主轴</translation>
    </message>
    <message>
        <source>Find the threshold in each frame; --threshold is the least</source>
        <translation>在每帧中自动求阈值；--threshold 为下限</translation>
    </message>
    <message>
        <source>Force and centre of pressure over taxels in contact, not over the whole array</source>
        <translation>力和压力中心只对接触的触觉单元计算，而非整个阵列</translation>
    </message>
    <message>
        <source>Summits that rise less than this share of the frame&apos;s peak are no contacts of their own</source>
        <translation>突起低于帧峰值此比例的峰顶不作为独立接触</translation>
    </message>
    <message>
        <source>Contacts of fewer taxels are dropped</source>
        <translation>触觉单元数更少的接触将被舍弃</translation>
    </message>
    <message>
        <source>the output would replace the input</source>
        <translation>输出会覆盖输入</translation>
    </message>
    <message>
        <source>Gains of the taxels, as &quot;teleta gains&quot; writes them</source>
        <translation>触觉单元的增益，由“teleta gains”写出</translation>
    </message>
    <message>
        <source>%1 is given, a number of columns, or columns such as 2..85 are expected</source>
        <translation>给出的是 %1，应为列数，或 2..85 这样的列范围</translation>
    </message>
    <message>
        <source>Columns of the array; or columns of a table of another program that are taxels, from 1, such as 2..85</source>
        <translation>阵列的列数；或其他程序的表格中作为触觉单元的列，从 1 开始，例如 2..85</translation>
    </message>
    <message>
        <source>Frames per second of a file without times</source>
        <translation>不含时间的文件的每秒帧数</translation>
    </message>
    <message>
        <source>Name of the frames in a file of several arrays</source>
        <translation>含多个数组的文件中帧数组的名称</translation>
    </message>
    <message>
        <source>Dimension of the array that counts the frames</source>
        <translation>数组中表示帧序号的维</translation>
    </message>
    <message>
        <source>Name or number of the column of the times in a table of another program</source>
        <translation>其他程序的表格中时间列的名称或编号</translation>
    </message>
    <message>
        <source>Unit of these times; default: as the name of the column ends</source>
        <translation>这些时间的单位；默认由列名的结尾决定</translation>
    </message>
    <message>
        <source>Recorded frames: CSV time_s,t0,t1,... with one row a frame, row-major, or a file of another program</source>
        <translation>记录的帧：CSV time_s,t0,t1,...，每帧一行，按行优先，或其他程序的文件</translation>
    </message>
    <message>
        <source>The values are in %1, not in N: give the N of one unit with --gain.</source>
        <translation>数值的单位是 %1，不是 N：请用 --gain 给出每单位的 N 数。</translation>
    </message>
    <message>
        <source>Frames of the unloaded array, whose mean is subtracted; or of the recording itself the median of each taxel, the mean of the first half second, or its value while it is untouched, in at least one frame in ten</source>
        <translation>空载阵列的帧（减去其均值）；或取自记录本身：每个触觉单元的中位数、最初半秒的均值，或其未被触碰时（至少十帧中有一帧）的值</translation>
    </message>
    <message>
        <source>Add the place of deepest pressure, finer than the taxels, also on a strip</source>
        <translation>添加压力最大的位置，精度高于触觉单元，条形传感器也可用</translation>
    </message>
    <message>
        <source>Standard deviation of a taxel&apos;s load at rest in N, for the standard errors of the summit</source>
        <translation>触觉单元静止时载荷的标准差（N），用于峰值位置的标准误差</translation>
    </message>
    <message>
        <source>Where the taxels are and what each tells, also off a grid and as vectors: the table [layout] of a device file</source>
        <translation>触觉单元的位置及其数值，也可不在网格上或为向量：设备文件中的表 [layout]</translation>
    </message>
    <message>
        <source>it says rows, columns and pitch itself</source>
        <translation>行、列和间距由它自己说明</translation>
    </message>
    <message>
        <source>&apos;untouched&apos; is for loads, but each taxel tells three values</source>
        <translation>“untouched”用于载荷，但每个触觉单元有三个值</translation>
    </message>
    <message>
        <source>These lines of the file have no effect: %1.</source>
        <translation>文件中的这些行不起作用：%1。</translation>
    </message>
    <message>
        <source>this is for loads on a grid</source>
        <translation>此选项用于网格上的载荷</translation>
    </message>
    <message>
        <source>the loads are in %1: write from how many %1 a taxel is in contact, such as five times the noise at rest</source>
        <translation>负载的单位是 %1：请写明从多少 %1 起触觉单元算作接触，例如静止噪声的五倍</translation>
    </message>
    <message>
        <source>Load from which a taxel is in contact, in N or the unit of the file; 0.2 unless that is another one than N and counts</source>
        <translation>触觉单元算作接触的起始负载，以 N 或文件的单位表示；单位为 N 或计数时为 0.2</translation>
    </message>
</context>
<context>
    <name>FrameReaderText</name>
    <message>
        <source>the file is %1</source>
        <translation>文件是%1</translation>
    </message>
    <message>
        <source>the frames do not fit into the memory</source>
        <translation>内存不足，无法容纳这些帧</translation>
    </message>
    <message>
        <source>the file has times of its own, in time_s</source>
        <translation>文件自带时间，位于 time_s 中</translation>
    </message>
    <message>
        <source>no rate</source>
        <translation>不指定帧率</translation>
    </message>
    <message>
        <source>the file</source>
        <translation>文件</translation>
    </message>
    <message>
        <source>frames as CSV, npy, npz, HDF5, MAT, or Tekscan ASCII</source>
        <translation>CSV、npy、npz、HDF5、MAT 或 Tekscan ASCII 格式的帧</translation>
    </message>
    <message>
        <source>the file says itself where its taxels are</source>
        <translation>文件自己说明了触觉单元的位置</translation>
    </message>
    <message>
        <source>no layout</source>
        <translation>不给布局</translation>
    </message>
    <message>
        <source>the recording is too long</source>
        <translation>记录过长</translation>
    </message>
    <message>
        <source>at most %1 values</source>
        <translation>至多 %1 个值</translation>
    </message>
    <message>
        <source>%1; of a table of another program, which columns are times and taxels (%2)</source>
        <translation>%1；若是其他程序的表格，则需指明哪些列是时间和触觉单元（%2）</translation>
    </message>
</context>
<context>
    <name>GainMap</name>
    <message>
        <source>dead</source>
        <translation>失效</translation>
    </message>
    <message>
        <source>too weak</source>
        <translation>过弱</translation>
    </message>
    <message>
        <source>too strong</source>
        <translation>过强</translation>
    </message>
    <message>
        <source>stuck</source>
        <translation>卡死</translation>
    </message>
    <message>
        <source>Taxel %1, row %2, column %3</source>
        <translation>触觉单元 %1，第 %2 行，第 %3 列</translation>
    </message>
    <message>
        <source>%1, not used</source>
        <translation>%1，不使用</translation>
    </message>
</context>
<context>
    <name>GainsCommand</name>
    <message>
        <source>Frames under load</source>
        <translation>受载的帧</translation>
    </message>
    <message>
        <source>Taxels used</source>
        <translation>使用的触觉单元</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 / %2</translation>
    </message>
    <message>
        <source>Gains</source>
        <translation>增益</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 至 %2</translation>
    </message>
    <message>
        <source>Largest standard error</source>
        <translation>最大标准误差</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Not explained</source>
        <translation>未解释部分</translation>
    </message>
    <message>
        <source>%1 % of the level</source>
        <translation>载荷水平的 %1 %</translation>
    </message>
    <message>
        <source>Tilt</source>
        <translation>倾斜</translation>
    </message>
    <message>
        <source>%1 % along x, %2 % along y</source>
        <translation>沿 x %1 %，沿 y %2 %</translation>
    </message>
    <message>
        <source>From press to press</source>
        <translation>各次按压之间</translation>
    </message>
    <message>
        <source>These taxels are not used: %1.</source>
        <translation>以下触觉单元不使用：%1。</translation>
    </message>
    <message>
        <source>The response changes by %1 % along x and %2 % along y: the load may have been uneven. Turn what presses round by half, press again and give both files.</source>
        <translation>响应沿 x 变化 %1 %，沿 y 变化 %2 %：载荷可能不均匀。请将按压物转半圈再按一次，并给出两个文件。</translation>
    </message>
    <message>
        <source>Gain of each taxel from frames under an even load</source>
        <translation>由均匀载荷下的帧求各触觉单元的增益</translation>
    </message>
    <message>
        <source>Recorded frames in which an even load presses on the whole array, a file a press: time_s,t0,t1,...</source>
        <translation>均匀载荷按压整个阵列时记录的帧，每次按压一个文件：time_s,t0,t1,...</translation>
    </message>
</context>
<context>
    <name>GaugeTexts</name>
    <message>
        <source>no stiffness</source>
        <translation>无刚度</translation>
    </message>
    <message>
        <source>%1, level %2</source>
        <translation>%1，等级 %2</translation>
    </message>
    <message>
        <source>taken as %1, level %2</source>
        <translation>按 %1 处理，等级 %2</translation>
    </message>
    <message>
        <source>%1, level %2, not certain</source>
        <translation>%1，等级 %2，不确定</translation>
    </message>
    <message numerus="yes">
        <source>%n sample(s)</source>
        <translation>
            <numerusform>%n 个样本</numerusform>
        </translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1，%2</translation>
    </message>
    <message>
        <source>95 %: %1   %2</source>
        <translation>95 %：%1   %2</translation>
    </message>
    <message>
        <source>not told from rigid   %1</source>
        <translation>无法与刚体区分   %1</translation>
    </message>
    <message>
        <source>no interval known   %1</source>
        <translation>区间未知   %1</translation>
    </message>
    <message>
        <source>Stiffer than the link allows: check contact distance and link stiffness.</source>
        <translation>刚度超出连杆允许的范围：请检查接触距离和连杆刚度。</translation>
    </message>
    <message>
        <source>level %1, %2, the paper&apos;s object %3</source>
        <translation>等级 %1，%2，论文中的物体 %3</translation>
    </message>
    <message>
        <source>rigid</source>
        <translation>刚性</translation>
    </message>
    <message>
        <source>%1: from %2
%3</source>
        <translation>%1：不低于 %2
%3</translation>
    </message>
    <message>
        <source>%1: under %2
%3</source>
        <translation>%1：低于 %2
%3</translation>
    </message>
    <message>
        <source>%1: %2 to %3
%4</source>
        <translation>%1：%2 至 %3
%4</translation>
    </message>
    <message>
        <source>No stiffness. %1</source>
        <translation>无刚度。%1</translation>
    </message>
    <message>
        <source>no touch yet</source>
        <translation>尚无触碰</translation>
    </message>
    <message>
        <source>cannot tell</source>
        <translation>无法判断</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>stale, %1 ago</source>
        <translation>已过时，%1 前</translation>
    </message>
    <message>
        <source>%1 ago</source>
        <translation>%1 前</translation>
    </message>
</context>
<context>
    <name>GelFollower</name>
    <message>
        <source>The picture could not be decoded.</source>
        <translation>图像无法解码。</translation>
    </message>
    <message>
        <source>The gel at rest cannot be taken: %1</source>
        <translation>无法取得静止的凝胶：%1</translation>
    </message>
    <message>
        <source>The picture has no contrast: is the camera covered?</source>
        <translation>图像没有对比度：相机是否被遮住？</translation>
    </message>
    <message>
        <source>More than 30 % of the markers have been lost for 1 s: is the gel torn?</source>
        <translation>30 % 以上的标记已丢失 1 秒：凝胶是否破损？</translation>
    </message>
    <message>
        <source>The light has jumped.</source>
        <translation>光线发生突变。</translation>
    </message>
    <message>
        <source>The recorded pictures of the gel at rest have another size than the video.</source>
        <translation>记录的凝胶静止图像与视频的尺寸不同。</translation>
    </message>
</context>
<context>
    <name>GelPicture</name>
    <message>
        <source>slip %1</source>
        <translation>滑动 %1</translation>
    </message>
    <message>
        <source>slip unknown</source>
        <translation>滑动未知</translation>
    </message>
    <message>
        <source>Contact %1</source>
        <translation>接触 %1</translation>
    </message>
    <message>
        <source>at %1, %2</source>
        <translation>位于 %1，%2</translation>
    </message>
    <message>
        <source>area %1 mm²</source>
        <translation>面积 %1 mm²</translation>
    </message>
    <message>
        <source>shear %1 at %2°</source>
        <translation>剪切 %1，方向 %2°</translation>
    </message>
    <message>
        <source>turned by %1°</source>
        <translation>转动 %1°</translation>
    </message>
    <message>
        <source>slip index %1</source>
        <translation>滑动指数 %1</translation>
    </message>
    <message>
        <source>too few markers for a slip index</source>
        <translation>标记太少，无法给出滑动指数</translation>
    </message>
    <message>
        <source>No picture yet</source>
        <translation>尚无图像</translation>
    </message>
    <message>
        <source>%1 mm (enlarged %2 times)</source>
        <translation>%1 mm（放大 %2 倍）</translation>
    </message>
    <message>
        <source>PAUSED</source>
        <translation>已暂停</translation>
    </message>
    <message>
        <source>load %1</source>
        <translation>载荷 %1</translation>
    </message>
    <message>
        <source>shear along x %1</source>
        <translation>沿 x 的剪切 %1</translation>
    </message>
    <message>
        <source>shear along y %1</source>
        <translation>沿 y 的剪切 %1</translation>
    </message>
    <message>
        <source>moment %1</source>
        <translation>力矩 %1</translation>
    </message>
    <message>
        <source>extrapolated</source>
        <comment>loads</comment>
        <translation>外推</translation>
    </message>
</context>
<context>
    <name>GelPlane</name>
    <message>
        <source>The lens in the file folds within the picture.</source>
        <translation>文件中的镜头在图像内发生折叠。</translation>
    </message>
    <message>
        <source>a lens that shows each place once</source>
        <translation>每个位置只显示一次的镜头</translation>
    </message>
    <message>
        <source>The homography sends pixels of the picture to infinity.</source>
        <translation>单应矩阵把图像中的像素映射到无穷远。</translation>
    </message>
    <message>
        <source>a matrix that maps the picture onto a plane</source>
        <translation>把图像映射到平面的矩阵</translation>
    </message>
</context>
<context>
    <name>GelRun</name>
    <message>
        <source>the gel at rest could not be found: %1</source>
        <translation>未能找到静止的凝胶：%1</translation>
    </message>
    <message>
        <source>the scene ends before the gel at rest is known</source>
        <translation>在得知静止的凝胶之前场景就结束了</translation>
    </message>
    <message>
        <source>at least %1 pictures</source>
        <translation>至少 %1 张图像</translation>
    </message>
</context>
<context>
    <name>GelText</name>
    <message>
        <source>Only %1 markers were found in the picture.</source>
        <translation>图像中只找到 %1 个标记。</translation>
    </message>
    <message>
        <source>at least %1 round spots of one size; check channel, marker and diameter_px in the sensor file</source>
        <translation>至少 %1 个大小相同的圆点；请检查传感器文件中的 channel、marker 和 diameter_px</translation>
    </message>
    <message>
        <source>The crop reaches out of the picture of %1 x %2 pixels.</source>
        <translation>裁剪超出了 %1 x %2 像素的图像。</translation>
    </message>
    <message>
        <source>x + width and y + height within the picture</source>
        <translation>x + 宽和 y + 高在图像之内</translation>
    </message>
    <message>
        <source>The picture is black.</source>
        <translation>图像是黑的。</translation>
    </message>
    <message>
        <source>The picture has no contrast.</source>
        <translation>图像没有对比度。</translation>
    </message>
    <message>
        <source>a picture of the gel&apos;s markers</source>
        <translation>凝胶标记的图像</translation>
    </message>
    <message>
        <source>The picture shows no grid of %1 x %2 markers: %3 spots, %4 of them in a grid.</source>
        <translation>图像中没有 %1 x %2 的标记网格：%3 个点，其中 %4 个成网格。</translation>
    </message>
    <message>
        <source>The markers form no hexagonal grid: %1 of %2 spots do.</source>
        <translation>标记没有形成六角网格：%2 个点中只有 %1 个。</translation>
    </message>
    <message>
        <source>the grid that the sensor&apos;s file names</source>
        <translation>传感器文件所述的网格</translation>
    </message>
    <message>
        <source>The size of the picture has changed to %1 x %2.</source>
        <translation>图像的大小变为 %1 x %2。</translation>
    </message>
    <message>
        <source>%1 x %2 pixels, as at the beginning</source>
        <translation>与开始时相同的 %1 x %2 像素</translation>
    </message>
</context>
<context>
    <name>HandStation</name>
    <message>
        <source>3D mouse: none is plugged in.</source>
        <translation>3D 鼠标：未插入。</translation>
    </message>
    <message>
        <source>3D mouse: %1</source>
        <translation>3D 鼠标：%1</translation>
    </message>
    <message>
        <source>3D mouse %1: moves the tip.</source>
        <translation>3D 鼠标 %1：移动末端。</translation>
    </message>
    <message>
        <source>3D mouse %1: hold its first button to move the tip.</source>
        <translation>3D 鼠标 %1：按住第一个按钮可移动末端。</translation>
    </message>
    <message>
        <source>3D mouse</source>
        <translation>3D 鼠标</translation>
    </message>
</context>
<context>
    <name>Hdf5FileText</name>
    <message>
        <source>the file has too many datasets</source>
        <translation>文件的数据集过多</translation>
    </message>
    <message>
        <source>at most %1</source>
        <translation>至多 %1</translation>
    </message>
    <message>
        <source>the HDF5 file is damaged: %1</source>
        <translation>HDF5 文件已损坏：%1</translation>
    </message>
    <message>
        <source>a whole HDF5 file</source>
        <translation>完整的 HDF5 文件</translation>
    </message>
    <message>
        <source>it is damaged: %1</source>
        <translation>已损坏：%1</translation>
    </message>
    <message>
        <source>it has no values</source>
        <translation>没有数值</translation>
    </message>
    <message>
        <source>it contains text</source>
        <translation>其中是文本</translation>
    </message>
    <message>
        <source>its values are compound</source>
        <translation>其数值由多个部分组成</translation>
    </message>
    <message>
        <source>its values are not real numbers</source>
        <translation>其数值不是实数</translation>
    </message>
    <message>
        <source>its values are stored in other files</source>
        <translation>其数值在其他文件中</translation>
    </message>
    <message>
        <source>it is compressed with %1; only gzip and shuffle can be read</source>
        <translation>它用 %1 压缩；可读取 gzip 和 shuffle</translation>
    </message>
    <message>
        <source>its values were never written</source>
        <translation>其数值从未写入</translation>
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
        <translation>自动</translation>
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
        <translation>类型</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>point</source>
        <translation>点</translation>
    </message>
    <message>
        <source>edge</source>
        <translation>边缘</translation>
    </message>
    <message>
        <source>centre of pressure</source>
        <translation>压力中心</translation>
    </message>
    <message>
        <source>centre of contact</source>
        <translation>接触中心</translation>
    </message>
    <message>
        <source>axis %1°</source>
        <translation>轴 %1°</translation>
    </message>
    <message>
        <source>threshold %1</source>
        <translation>阈值 %1</translation>
    </message>
    <message>
        <source>dead %1</source>
        <translation>失效 %1</translation>
    </message>
    <message>
        <source>Point at a taxel to read it.</source>
        <translation>将鼠标指向触觉单元以读取数值。</translation>
    </message>
    <message>
        <source>No new data: the last frame is shown.</source>
        <translation>没有新数据：显示的是最后一帧。</translation>
    </message>
    <message>
        <source>shear</source>
        <translation>剪切</translation>
    </message>
    <message>
        <source>shear, a taxel&apos;s width is %1</source>
        <translation>剪切，触觉单元宽度为 %1</translation>
    </message>
    <message>
        <source>extrapolated</source>
        <comment>loads</comment>
        <translation>外推</translation>
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
        <translation>多个</translation>
    </message>
</context>
<context>
    <name>HeatmapView</name>
    <message>
        <source>dead</source>
        <translation>失效</translation>
    </message>
    <message>
        <source>contact #%1</source>
        <translation>接触 #%1</translation>
    </message>
    <message>
        <source>no contact</source>
        <translation>无接触</translation>
    </message>
    <message>
        <source>no taxel</source>
        <translation>无触觉单元</translation>
    </message>
    <message>
        <source>shear %1</source>
        <translation>剪切 %1</translation>
    </message>
    <message>
        <source>row %1, column %2</source>
        <translation>行 %1，列 %2</translation>
    </message>
    <message>
        <source>taxel %1</source>
        <translation>触觉单元 %1</translation>
    </message>
    <message>
        <source>%1   %2   %3   x %4 mm, y %5 mm</source>
        <translation>%1   %2   %3   x %4 mm，y %5 mm</translation>
    </message>
    <message>
        <source>contact #%1 with shear %2, friction %3</source>
        <extracomment>Of a contact: the force along the surface, and it divided by the force into the surface</extracomment>
        <translation>接触 #%1，剪切 %2，摩擦 %3</translation>
    </message>
</context>
<context>
    <name>IdentifierText</name>
    <message>
        <source>&quot;%1&quot; cannot be part of a file name</source>
        <translation>“%1”不能用于文件名</translation>
    </message>
    <message>
        <source>letters, digits, - and _</source>
        <translation>字母、数字、- 和 _</translation>
    </message>
    <message>
        <source>each one once</source>
        <translation>每个一次</translation>
    </message>
    <message>
        <source>&quot;%1&quot; occurs twice</source>
        <translation>“%1”出现两次</translation>
    </message>
</context>
<context>
    <name>ImportCommand</name>
    <message>
        <source>left out</source>
        <translation>已略去</translation>
    </message>
    <message numerus="yes">
        <source>%n message(s)</source>
        <translation>
            <numerusform>%n 条消息</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n damaged or of another shape</source>
        <translation>
            <numerusform>%n 条已损坏或形状不同</numerusform>
        </translation>
    </message>
    <message>
        <source>Note</source>
        <translation>备注</translation>
    </message>
    <message>
        <source>The file was cut off: %1 of %2 bytes could be read.</source>
        <translation>文件被截断：%2 字节中可读取 %1 字节。</translation>
    </message>
    <message numerus="yes">
        <source>%n damaged chunk(s) left out</source>
        <translation>
            <numerusform>略去 %n 个损坏的数据块</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n damaged record(s) left out</source>
        <translation>
            <numerusform>略去 %n 条损坏的数据记录</numerusform>
        </translation>
    </message>
    <message>
        <source>The checksum of the file is wrong: it was damaged somewhere.</source>
        <translation>文件的校验和错误：文件某处已损坏。</translation>
    </message>
    <message>
        <source>Recording to be made</source>
        <translation>要创建的记录</translation>
    </message>
    <message>
        <source>Read a topic as array, camera or joints, where its type leaves a choice</source>
        <translation>当话题的类型允许选择时，将其读作 array、camera 或 joints</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not /TOPIC=array, /TOPIC=camera or /TOPIC=joints</source>
        <translation>“%1”不是 /TOPIC=array、/TOPIC=camera 或 /TOPIC=joints</translation>
    </message>
    <message>
        <source>Array</source>
        <translation>阵列</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>帧</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>速率</translation>
    </message>
    <message>
        <source>MCAP file with ROS 2 messages, or frames of an array; the options below supply what a file of frames does not say</source>
        <translation>ROS 2 消息的 MCAP 文件，或阵列的帧；文件未说明的内容由下列选项给出</translation>
    </message>
    <message>
        <source>Load in one unit of the values</source>
        <translation>数值一个单位的载荷</translation>
    </message>
    <message>
        <source>Unit of the loads; default: as the file says, else N or counts, by the array</source>
        <translation>载荷的单位；默认按文件，否则按阵列为 N 或 counts</translation>
    </message>
    <message>
        <source>this is for MCAP files only</source>
        <translation>这用于 MCAP，但该文件不是</translation>
    </message>
    <message>
        <source>this is for frames, not for MCAP files</source>
        <translation>这用于帧，但该文件是 MCAP</translation>
    </message>
    <message>
        <source>Make a recording of an MCAP file, or of the frames of another program</source>
        <translation>由 MCAP 文件或其他程序的帧生成记录</translation>
    </message>
    <message>
        <source>Load from which a taxel is in contact, in the recording&apos;s settings; 0.2 unless the unit is another one than N and counts</source>
        <translation>记录设置中触觉单元算作接触的起始负载；单位为 N 或计数时为 0.2</translation>
    </message>
</context>
<context>
    <name>InputFileText</name>
    <message>
        <source>cannot open the file: %1</source>
        <translation>无法打开文件：%1</translation>
    </message>
    <message>
        <source>a file</source>
        <translation>一个文件</translation>
    </message>
    <message>
        <source>this is a folder</source>
        <translation>这是文件夹</translation>
    </message>
    <message>
        <source>this is a pipe or a device</source>
        <translation>这是管道或设备</translation>
    </message>
    <message>
        <source>cannot read the file: %1</source>
        <translation>无法读取文件：%1</translation>
    </message>
    <message>
        <source>the file is too large</source>
        <translation>文件太大</translation>
    </message>
    <message>
        <source>at most %1 MiB</source>
        <translation>最多 %1 MiB</translation>
    </message>
</context>
<context>
    <name>Interruption</name>
    <message>
        <source>interrupted; the output ends with what was computed until then</source>
        <translation>已中断；输出截至中断前已计算的内容</translation>
    </message>
</context>
<context>
    <name>JackText</name>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>PipeWire is not running.</source>
        <translation>PipeWire 未运行。</translation>
    </message>
    <message>
        <source>The JACK server is not running.</source>
        <translation>JACK 服务器未运行。</translation>
    </message>
    <message>
        <source>The sound server plays %1 samples a second.</source>
        <translation>声音服务器每秒播放 %1 个采样。</translation>
    </message>
    <message>
        <source>sample_rate_Hz = %1 in the device file</source>
        <translation>设备文件中的 sample_rate_Hz = %1</translation>
    </message>
    <message>
        <source>Another program plays on %1.</source>
        <translation>另一个程序正在 %1 上播放。</translation>
    </message>
    <message>
        <source>it to be disconnected, or shared = true in the device file</source>
        <translation>断开该程序，或在设备文件中写 shared = true</translation>
    </message>
    <message>
        <source>The sound server did not activate the connection.</source>
        <translation>声音服务器未启动连接。</translation>
    </message>
    <message>
        <source>There are several sound cards: %1.</source>
        <translation>有多个声卡：%1。</translation>
    </message>
    <message>
        <source>the name of one of them in device</source>
        <translation>在 device 中写明其中一个的名称</translation>
    </message>
    <message>
        <source>There is no sound card.</source>
        <translation>没有声卡。</translation>
    </message>
    <message>
        <source>There is no sound output &quot;%1&quot;.</source>
        <translation>没有声音输出“%1”。</translation>
    </message>
    <message>
        <source>one of: %1</source>
        <translation>以下之一：%1</translation>
    </message>
    <message numerus="yes">
        <source>&quot;%1&quot; has %n output(s).</source>
        <translation>
            <numerusform>“%1”有 %n 个输出。</numerusform>
        </translation>
    </message>
    <message>
        <source>an output %1, as channels says</source>
        <translation>channels 所写的输出 %1</translation>
    </message>
    <message>
        <source>The sound server refused to create a port for a tactor.</source>
        <translation>声音服务器没有为致动器提供端口。</translation>
    </message>
    <message>
        <source>Tactor %1 cannot be connected to %2.</source>
        <translation>无法将致动器 %1 连接到 %2。</translation>
    </message>
    <message>
        <source>The sound server requests no samples.</source>
        <translation>声音服务器不请求采样。</translation>
    </message>
    <message>
        <source>The sound server plays %1 samples at a time.</source>
        <translation>声音服务器一次播放 %1 个采样。</translation>
    </message>
    <message>
        <source>period_frames = %1 in the device file, or a server that plays %2 at a time</source>
        <translation>设备文件中的 period_frames = %1，或一次播放 %2 个采样的服务器</translation>
    </message>
</context>
<context>
    <name>JogTargetText</name>
    <message>
        <source>%1 has no arm, or several</source>
        <translation>%1 没有机械臂，或有多个</translation>
    </message>
    <message>
        <source>%1 has no arm &quot;%2&quot;</source>
        <translation>%1 没有机械臂“%2”</translation>
    </message>
    <message>
        <source>the arm has no joint &quot;%1&quot;; it has %2</source>
        <translation>机械臂没有关节“%1”；它有 %2</translation>
    </message>
    <message>
        <source>%1 with one of %2</source>
        <translation>%1 取 %2 之一</translation>
    </message>
</context>
<context>
    <name>JsonDocument</name>
    <message>
        <source>the file is too large</source>
        <translation>文件过大</translation>
    </message>
    <message>
        <source>at most %1 MiB</source>
        <translation>至多 %1 MiB</translation>
    </message>
    <message>
        <source>the values are nested too deeply</source>
        <translation>值的嵌套过深</translation>
    </message>
    <message>
        <source>at most %1 levels</source>
        <translation>至多 %1 层</translation>
    </message>
    <message>
        <source>an object has the key &quot;%1&quot; twice</source>
        <translation>对象中的键“%1”出现两次</translation>
    </message>
    <message>
        <source>each key once</source>
        <translation>每个键一次</translation>
    </message>
    <message>
        <source>JSON in UTF-8</source>
        <translation>UTF-8 编码的 JSON</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>this is not an object</source>
        <translation>这不是对象</translation>
    </message>
    <message>
        <source>an object with the key &quot;%1&quot;</source>
        <translation>含键“%1”的对象</translation>
    </message>
    <message>
        <source>the key &quot;%1&quot; is missing</source>
        <translation>缺少键“%1”</translation>
    </message>
    <message>
        <source>an array of length %1</source>
        <translation>长度为 %1 的数组</translation>
    </message>
    <message>
        <source>an array of length %1 to %2</source>
        <translation>长度为 %1 至 %2 的数组</translation>
    </message>
    <message>
        <source>this is not an array</source>
        <translation>这不是数组</translation>
    </message>
    <message>
        <source>a number from %1 to %2</source>
        <translation>%1 至 %2 的数</translation>
    </message>
    <message>
        <source>this is not a number</source>
        <translation>这不是数</translation>
    </message>
    <message>
        <source>%1 is out of range</source>
        <translation>%1 超出范围</translation>
    </message>
    <message>
        <source>this is not a whole number</source>
        <translation>这不是整数</translation>
    </message>
    <message>
        <source>a whole number from %1 to %2</source>
        <translation>%1 至 %2 的整数</translation>
    </message>
    <message>
        <source>this is neither true nor false</source>
        <translation>这既不是 true 也不是 false</translation>
    </message>
    <message>
        <source>this is not text</source>
        <translation>这不是文本</translation>
    </message>
    <message>
        <source>text</source>
        <translation>文本</translation>
    </message>
    <message>
        <source>the JSON text is damaged or truncated</source>
        <translation>JSON 文本已损坏或被截断</translation>
    </message>
    <message>
        <source>the array has the wrong length</source>
        <translation>数组长度错误</translation>
    </message>
</context>
<context>
    <name>KeyListText</name>
    <message>
        <source>a list of %1, each %2</source>
        <translation>含 %1 个元素的列表，每个为%2</translation>
    </message>
    <message>
        <source>a list of %1 to %2, each %3</source>
        <translation>含 %1 至 %2 个元素的列表，每个为%3</translation>
    </message>
</context>
<context>
    <name>LadderSweep</name>
    <message>
        <source>there is no such rung</source>
        <translation>没有这一级</translation>
    </message>
    <message>
        <source>there is no ladder &quot;%1&quot;</source>
        <translation>没有阶梯“%1”</translation>
    </message>
    <message>
        <source>one of: %1</source>
        <translation>以下之一：%1</translation>
    </message>
    <message>
        <source>unknown key &quot;%1&quot;</source>
        <translation>未知的键“%1”</translation>
    </message>
    <message>
        <source>rung</source>
        <translation>rung</translation>
    </message>
    <message>
        <source>there is no rung &quot;%1&quot;</source>
        <translation>没有级“%1”</translation>
    </message>
</context>
<context>
    <name>LanguageMenu</name>
    <message>
        <source>Lan&amp;guage</source>
        <translation>语言(&amp;G)</translation>
    </message>
    <message>
        <source>As the &amp;desktop</source>
        <translation>跟随桌面(&amp;D)</translation>
    </message>
</context>
<context>
    <name>LastSession</name>
    <message>
        <source>camera</source>
        <translation>相机</translation>
    </message>
</context>
<context>
    <name>LevelContent</name>
    <message>
        <source>All participants</source>
        <translation>全部被试</translation>
    </message>
    <message>
        <source>Thresholds of all participants</source>
        <translation>全部被试的阈值</translation>
    </message>
    <message>
        <source>Levels of %1 over the trials</source>
        <translation>%1 的刺激水平随试次的变化</translation>
    </message>
    <message>
        <source>d&apos; and c of all participants, %1</source>
        <translation>全部被试的 d&apos; 和 c，%1</translation>
    </message>
    <message>
        <source>Participant</source>
        <translation>被试</translation>
    </message>
    <message>
        <source>Condition</source>
        <translation>条件</translation>
    </message>
    <message>
        <source>Track</source>
        <translation>序列</translation>
    </message>
    <message>
        <source>Trials</source>
        <translation>试次</translation>
    </message>
    <message>
        <source>Threshold</source>
        <translation>阈值</translation>
    </message>
    <message>
        <source>95 %</source>
        <translation>95 %</translation>
    </message>
    <message>
        <source>Spread or slope</source>
        <translation>离散度或斜率</translation>
    </message>
    <message>
        <source>Lapses</source>
        <translation>失误率</translation>
    </message>
    <message>
        <source>p of fit</source>
        <translation>拟合 p 值</translation>
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
        <translation>说明</translation>
    </message>
    <message>
        <source>Where the curve is half-way between guessing and its upper end; of a comparison the level that feels equal</source>
        <translation>曲线处于猜测水平与其上端正中间时的刺激水平；比较任务中为感觉相等的水平</translation>
    </message>
    <message>
        <source>By profile likelihood; of all participants Student&apos;s t of their thresholds. ? stands for an open end</source>
        <translation>由轮廓似然求得；全部被试的区间由其阈值的学生 t 分布求得。? 表示该端不封闭</translation>
    </message>
    <message>
        <source>s of gauss and logistic, in the unit of the level; the slope b of weibull</source>
        <translation>gauss 和 logistic 的 s，单位与刺激水平相同；weibull 的斜率 b</translation>
    </message>
    <message>
        <source>Share of mistakes however strong the stimulus is</source>
        <translation>无论刺激多强都会出现的错误所占的比例</translation>
    </message>
    <message>
        <source>Of the deviance, by data sets that are drawn and fitted again; constant stimuli only</source>
        <translation>偏差度 (deviance) 的 p 值，由重新抽取并再次拟合的数据集求得；仅用于恒定刺激法</translation>
    </message>
    <message>
        <source>Just noticeable difference: half of the way from 25 to 75 %</source>
        <translation>最小可觉差：从 25 % 到 75 % 的距离的一半</translation>
    </message>
    <message>
        <source>JND over the reference</source>
        <translation>JND 除以参考值</translation>
    </message>
    <message>
        <source>mean of %1</source>
        <translation>%1 名被试的平均值</translation>
    </message>
    <message>
        <source>mean of %1; %2 without threshold</source>
        <translation>%1 名被试的平均值；%2 名无阈值</translation>
    </message>
    <message>
        <source>All</source>
        <translation>全部</translation>
    </message>
    <message>
        <source>Mean of reversals</source>
        <translation>反转点平均值</translation>
    </message>
    <message>
        <source>Reversals</source>
        <translation>反转次数</translation>
    </message>
    <message>
        <source>Posterior mean</source>
        <translation>后验均值</translation>
    </message>
    <message>
        <source>Its sd</source>
        <translation>其 sd</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>备注</translation>
    </message>
    <message>
        <source>The estimate of a staircase</source>
        <translation>阶梯法的估计值</translation>
    </message>
    <message>
        <source>The estimate of a Bayesian procedure</source>
        <translation>贝叶斯法的估计值</translation>
    </message>
    <message>
        <source>On the scale of the levels: in log10 units on a logarithmic one</source>
        <translation>按刺激水平的刻度；对数刻度时以 log10 为单位</translation>
    </message>
    <message>
        <source>Hits</source>
        <translation>击中</translation>
    </message>
    <message>
        <source>False alarms</source>
        <translation>虚报</translation>
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
        <translation>占多少个有刺激的试次；多个时间区间时为正确回答</translation>
    </message>
    <message>
        <source>Of how many trials without</source>
        <translation>占多少个无刺激的试次</translation>
    </message>
    <message>
        <source>Sensitivity; rates are (count + 1/2) / (trials + 1)</source>
        <translation>辨别力；比率为 (次数 + 1/2) / (试次数 + 1)</translation>
    </message>
    <message>
        <source>Criterion: above 0 rather no; of two intervals below 0 rather the first</source>
        <translation>判断标准：大于 0 时倾向于答“否”；两个时间区间时，小于 0 倾向于选第一个</translation>
    </message>
    <message>
        <source>Without rules</source>
        <translation>不用规则</translation>
    </message>
    <message>
        <source>Threshold of all trials, including those that the rules leave out</source>
        <translation>所有试次的阈值，包括规则排除的试次</translation>
    </message>
    <message>
        <source>Speed, Hz</source>
        <translation>转速，Hz</translation>
    </message>
    <message>
        <source>Of the motors at this level, by their measured curves; mean over the tactors</source>
        <translation>电机在此水平的值，按其测得的曲线；对各振子取平均</translation>
    </message>
    <message>
        <source>Force, %</source>
        <translation>力，%</translation>
    </message>
    <message>
        <source>Square of that speed over the square of the speed at full drive</source>
        <translation>该转速的平方除以满驱动转速的平方</translation>
    </message>
    <message>
        <source>Weber of speed</source>
        <translation>转速的 Weber 分数</translation>
    </message>
    <message>
        <source>By how much the speed rises from the reference to reference + JND</source>
        <translation>转速从参考到参考 + JND增加的幅度</translation>
    </message>
    <message>
        <source>Weber of force</source>
        <translation>力的 Weber 分数</translation>
    </message>
    <message>
        <source>By how much the force rises from the reference to reference + JND</source>
        <translation>力从参考到参考 + JND增加的幅度</translation>
    </message>
    <message>
        <source>A level is a share of the range from a motor&apos;s start to its full drive. Connect the bracelet, and the speed of its motors in Hz and their force are shown beside the levels.</source>
        <translation>水平是电机从启动到满驱动范围内的比例。连接手环后，会在水平旁显示其电机的转速（Hz）和力。</translation>
    </message>
    <message>
        <source>A level is a share of the range from a motor&apos;s start to its full drive. Measure the motors of this bracelet on the page Calibrate, and their speed in Hz and their force are shown beside the levels.</source>
        <translation>水平是电机从启动到满驱动范围内的比例。在“标定”页测量此手环的电机后，会在水平旁显示其转速（Hz）和力。</translation>
    </message>
</context>
<context>
    <name>LevelSourceText</name>
    <message>
        <source>these are data of different modes: %1 and %2</source>
        <translation>这些数据属于不同模式：%1 和 %2</translation>
    </message>
    <message>
        <source>one mode, or the choice of one</source>
        <translation>同一种模式，或指明采用哪一种</translation>
    </message>
    <message>
        <source>%1 cannot be &quot;%2&quot;</source>
        <translation>%1 不能为“%2”</translation>
    </message>
    <message>
        <source>nothing says which answers are correct</source>
        <translation>没有内容说明哪些回答正确</translation>
    </message>
    <message>
        <source>a column correct, or stimulus and response</source>
        <translation>列 correct，或 stimulus 和 response</translation>
    </message>
    <message>
        <source>practice or test</source>
        <translation>practice 或 test</translation>
    </message>
    <message>
        <source>run, pilot or simulated</source>
        <translation>run、pilot 或 simulated</translation>
    </message>
    <message>
        <source>correct, incorrect, timeout, aborted or device_error</source>
        <translation>correct、incorrect、timeout、aborted 或 device_error</translation>
    </message>
    <message>
        <source>a number from %1 to %2, or NA</source>
        <translation>%1 至 %2 的数字，或 NA</translation>
    </message>
    <message>
        <source>yes_no, interval, same_different or compare, one for a task</source>
        <translation>yes_no、interval、same_different 或 compare，每个任务只有一种</translation>
    </message>
    <message>
        <source>0 or 1</source>
        <translation>0 或 1</translation>
    </message>
    <message>
        <source>a value</source>
        <translation>一个值</translation>
    </message>
    <message>
        <source>interrupted</source>
        <translation>已中断</translation>
    </message>
</context>
<context>
    <name>LimitText</name>
    <message>
        <source>joint speed</source>
        <translation>关节速度</translation>
    </message>
    <message>
        <source>tip speed</source>
        <translation>末端速度</translation>
    </message>
    <message>
        <source>joint limit</source>
        <translation>关节极限</translation>
    </message>
    <message>
        <source>workspace box</source>
        <translation>末端的活动范围框</translation>
    </message>
    <message>
        <source>effort</source>
        <translation>effort</translation>
    </message>
    <message>
        <source>force</source>
        <translation>力</translation>
    </message>
    <message>
        <source>the arm lags behind</source>
        <translation>机械臂滞后</translation>
    </message>
</context>
<context>
    <name>LinkText</name>
    <message>
        <source>a serial port cannot run at %1 baud</source>
        <translation>串口不支持 %1 波特</translation>
    </message>
    <message>
        <source>one of %1</source>
        <translation>%1 之一</translation>
    </message>
    <message>
        <source>cannot open %1: %2</source>
        <translation>无法打开 %1：%2</translation>
    </message>
    <message>
        <source>%1 is not a serial port</source>
        <translation>%1 不是串口</translation>
    </message>
    <message>
        <source>cannot find %1: %2</source>
        <translation>找不到 %1：%2</translation>
    </message>
    <message>
        <source>connecting was cancelled</source>
        <translation>连接已取消</translation>
    </message>
    <message>
        <source>cannot connect to %1: %2</source>
        <translation>无法连接到 %1：%2</translation>
    </message>
    <message>
        <source>The link failed: %1.</source>
        <translation>链路故障：%1。</translation>
    </message>
    <message>
        <source>The sensor closed the connection.</source>
        <translation>传感器关闭了连接。</translation>
    </message>
    <message>
        <source>The device was unplugged.</source>
        <translation>设备已拔出。</translation>
    </message>
    <message>
        <source>The file has ended.</source>
        <translation>文件已结束。</translation>
    </message>
    <message>
        <source>The server closed the connection (code %1): %2</source>
        <translation>服务器关闭了连接（代码 %1）：%2</translation>
    </message>
    <message>
        <source>no answer</source>
        <translation>没有应答</translation>
    </message>
    <message>
        <source>%1 is a folder, not a file</source>
        <translation>%1 是文件夹，不是文件</translation>
    </message>
    <message>
        <source>The other program closed the pipe.</source>
        <translation>另一程序关闭了管道。</translation>
    </message>
    <message>
        <source>The server has sent nothing for %1 s.</source>
        <translation>服务器已有 %1 秒没有发送任何内容。</translation>
    </message>
</context>
<context>
    <name>LiveView</name>
    <message>
        <source>&quot;%1&quot; is no address</source>
        <translation>“%1”不是地址</translation>
    </message>
    <message>
        <source>an address such as 127.0.0.1</source>
        <translation>例如 127.0.0.1 的地址</translation>
    </message>
    <message>
        <source>the live view cannot listen on %1:%2: %3</source>
        <translation>实时视图无法在 %1:%2 上监听：%3</translation>
    </message>
    <message>
        <source>another port</source>
        <translation>另一个端口</translation>
    </message>
</context>
<context>
    <name>LoadCalibration</name>
    <message>
        <source>%1 presses under load are too few for %2 signals</source>
        <translation>对 %2 个信号来说，%1 次有载荷的按压太少</translation>
    </message>
    <message>
        <source>at least %1 presses</source>
        <translation>至少 %1 次按压</translation>
    </message>
    <message>
        <source>%1 is the same in all presses</source>
        <translation>%1 在所有按压中都相同</translation>
    </message>
    <message>
        <source>loads of different sizes</source>
        <translation>大小不同的载荷</translation>
    </message>
    <message>
        <source>presses that change each signal</source>
        <translation>使每个信号都变化的按压</translation>
    </message>
    <message>
        <source>the presses do not tell the signals apart</source>
        <translation>这些按压无法区分各信号</translation>
    </message>
    <message>
        <source>presses in which each signal changes without the others</source>
        <translation>每个信号都单独变化过的按压</translation>
    </message>
</context>
<context>
    <name>LoadCalibrationFile</name>
    <message>
        <source>&quot;%1&quot; is no load</source>
        <translation>“%1”不是载荷</translation>
    </message>
    <message>
        <source>the signal has no name</source>
        <translation>信号没有名称</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no number</source>
        <translation>“%1”不是数字</translation>
    </message>
    <message>
        <source>least is above greatest</source>
        <translation>least 大于 greatest</translation>
    </message>
    <message>
        <source>there is no column with a load</source>
        <translation>没有载荷列</translation>
    </message>
    <message>
        <source>one of %1</source>
        <translation>%1 之一</translation>
    </message>
    <message>
        <source>this load and signal are listed twice</source>
        <translation>此载荷与信号的组合出现了两次</translation>
    </message>
    <message>
        <source>rest and range of this signal differ from another row</source>
        <translation>此信号的静止值和范围与另一行不同</translation>
    </message>
    <message>
        <source>rows are missing</source>
        <translation>缺少行</translation>
    </message>
    <message>
        <source>one for each load and signal</source>
        <translation>每个载荷与信号各一行</translation>
    </message>
    <message>
        <source>the scatter of this load differs from another row</source>
        <translation>此载荷的离散度与另一行不同</translation>
    </message>
    <message>
        <source>an error or a scatter is below 0</source>
        <translation>误差或离散度小于 0</translation>
    </message>
    <message>
        <source>the source has no signal &quot;%1&quot;</source>
        <translation>数据源没有信号“%1”</translation>
    </message>
</context>
<context>
    <name>LoadsCommand</name>
    <message>
        <source>Find the matrix from presses with a known load</source>
        <translation>由已知载荷的按压求出矩阵</translation>
    </message>
    <message>
        <source>CSV, a row a press: the signals, and the loads in one or more of force_n, shear_x_n, shear_y_n, moment_nm</source>
        <translation>CSV，每行一次按压：信号，以及 force_n、shear_x_n、shear_y_n、moment_nm 中一个或多个载荷</translation>
    </message>
    <message>
        <source>Columns of the signals, between commas</source>
        <translation>信号的列，以逗号分隔</translation>
    </message>
    <message>
        <source>Loads of each row of a table</source>
        <translation>表中每行的载荷</translation>
    </message>
    <message>
        <source>What &quot;teleta loads fit&quot; has written</source>
        <translation>“teleta loads fit”写出的文件</translation>
    </message>
    <message>
        <source>CSV with the same signals</source>
        <translation>含相同信号的 CSV</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no signal</source>
        <translation>“%1”不是信号</translation>
    </message>
    <message>
        <source>%1 is named twice</source>
        <translation>%1 出现了两次</translation>
    </message>
    <message>
        <source>Presses</source>
        <translation>按压</translation>
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
        <translation>偏差 %1（标准差）</translation>
    </message>
    <message>
        <source>this is no number</source>
        <translation>这不是数字</translation>
    </message>
    <message>
        <source>a number, or NA</source>
        <translation>数字或 NA</translation>
    </message>
    <message>
        <source>Newtons from the signals of a sensor, by presses with a known load</source>
        <translation>借助已知载荷的按压，把传感器信号变为牛顿</translation>
    </message>
</context>
<context>
    <name>LocateCommand</name>
    <message>
        <source>Camera file that teleta calibrate has written</source>
        <translation>teleta calibrate 写出的相机文件</translation>
    </message>
    <message>
        <source>CSV with the columns u_px,v_px</source>
        <translation>CSV，含列 u_px,v_px</translation>
    </message>
    <message>
        <source>Points on the tactile cylinder that belong to pixels of its camera</source>
        <translation>相机像素所对应的触觉圆柱上的点</translation>
    </message>
</context>
<context>
    <name>MarkerGelFile</name>
    <message>
        <source>the plane is described twice</source>
        <translation>平面被描述了两次</translation>
    </message>
    <message>
        <source>one of mm_per_px, homography and pitch_mm</source>
        <translation>mm_per_px、homography 和 pitch_mm 之一</translation>
    </message>
    <message>
        <source>the matrix has no inverse</source>
        <translation>矩阵不可逆</translation>
    </message>
    <message>
        <source>a matrix that maps the picture onto a plane</source>
        <translation>把图像映射到平面的矩阵</translation>
    </message>
    <message>
        <source>a part of a pixel cannot be cut off</source>
        <translation>不能裁去像素的一部分</translation>
    </message>
    <message>
        <source>whole numbers</source>
        <translation>整数</translation>
    </message>
    <message>
        <source>the picture would be too small</source>
        <translation>图像会太小</translation>
    </message>
    <message>
        <source>at least 16 x 16 pixels</source>
        <translation>至少 16 x 16 像素</translation>
    </message>
    <message>
        <source>such small markers cannot be told from noise</source>
        <translation>这么小的标记无法与噪声区分</translation>
    </message>
    <message>
        <source>at least 2 px, or 0</source>
        <translation>至少 2 px，或 0</translation>
    </message>
    <message>
        <source>[plane] gives no scale</source>
        <translation>[plane] 没有给出比例</translation>
    </message>
</context>
<context>
    <name>MarkersText</name>
    <message>
        <source>the camera has stopped sending frames</source>
        <translation>相机已停止发送图像</translation>
    </message>
    <message>
        <source>Video, pattern of numbered images (frame_%04d.png) or number of a camera; nothing touches the gel in the first frames. Default: the source that the sensor file names</source>
        <translation>视频、带编号图像的模式（frame_%04d.png）或相机编号；最初几帧中没有物体接触凝胶。默认：传感器文件指明的源</translation>
    </message>
    <message>
        <source>Sensor file of kind &quot;marker_gel&quot;</source>
        <translation>kind 为“marker_gel”的传感器文件</translation>
    </message>
    <message>
        <source>Print a summary instead of the table</source>
        <translation>输出摘要而不是表格</translation>
    </message>
    <message>
        <source>a summary is printed; --out writes the table</source>
        <translation>汇总只会输出到屏幕；--out 写出表格</translation>
    </message>
    <message>
        <source>neither a video is given nor does the sensor file name a source</source>
        <translation>既未给出视频，传感器文件也未指明源</translation>
    </message>
    <message>
        <source>the video has no frame that can be decoded</source>
        <translation>视频中没有可以解码的帧</translation>
    </message>
    <message>
        <source>the video has only one frame, so nothing moves in it</source>
        <translation>视频只有一帧，其中没有运动</translation>
    </message>
    <message>
        <source>at least two frames</source>
        <translation>至少两帧</translation>
    </message>
    <message>
        <source>The picture has no contrast at %1 s: is the camera covered?</source>
        <translation>在 %1 s 图像没有对比度：相机被遮住了吗？</translation>
    </message>
    <message>
        <source>The light jumps at %1 s</source>
        <translation>在 %1 s 光线突变</translation>
    </message>
    <message>
        <source>At %1 s more than 30 % of the markers have been lost for 1 s: is the gel torn?</source>
        <translation>在 %1 s，超过 30 % 的标记已丢失 1 s：凝胶破了吗？</translation>
    </message>
    <message>
        <source>Frames that cannot be decoded: %1</source>
        <translation>无法解码的帧：%1</translation>
    </message>
    <message>
        <source>Frames missing according to their time stamps: %1</source>
        <translation>根据时间戳缺失的帧：%1</translation>
    </message>
    <message>
        <source>frames</source>
        <translation>帧</translation>
    </message>
    <message>
        <source>markers</source>
        <translation>标记</translation>
    </message>
    <message>
        <source>found</source>
        <translation>找到</translation>
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
        <translation>相邻间距</translation>
    </message>
    <message>
        <source>frames for the places at rest</source>
        <translation>用于静止位置的帧</translation>
    </message>
    <message>
        <source>noise of a place</source>
        <translation>位置噪声</translation>
    </message>
    <message>
        <source>largest displacement</source>
        <translation>最大位移</translation>
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
        <translation>%1 s 至 %2 s，中心 (%3, %4) mm</translation>
    </message>
    <message>
        <source>, slip index up to %1</source>
        <translation>，滑动指数最高 %1</translation>
    </message>
    <message>
        <source>, slip at %1 s</source>
        <translation>，%1 s 时滑动</translation>
    </message>
    <message>
        <source>Follow the markers of a flat gel in a video</source>
        <translation>在视频中跟踪平面凝胶的标记</translation>
    </message>
</context>
<context>
    <name>MatCheckText</name>
    <message>
        <source>the MAT file is damaged at byte %1: %2</source>
        <translation>MAT 文件在字节 %1 处损坏：%2</translation>
    </message>
    <message>
        <source>a whole MAT file</source>
        <translation>完整的 MAT 文件</translation>
    </message>
    <message>
        <source>it ends within its header</source>
        <translation>在文件头中结束</translation>
    </message>
    <message>
        <source>it ends within the header of a variable</source>
        <translation>在变量头中结束</translation>
    </message>
    <message>
        <source>a variable has %1 bytes, there are %2</source>
        <translation>一个变量有 %1 字节，实有 %2 字节</translation>
    </message>
    <message>
        <source>a compressed variable cannot be decompressed</source>
        <translation>一个压缩的变量无法解压</translation>
    </message>
    <message>
        <source>this is not the header of a variable</source>
        <translation>这不是变量头</translation>
    </message>
</context>
<context>
    <name>MatFileText</name>
    <message>
        <source>the file has too many variables</source>
        <translation>文件的变量过多</translation>
    </message>
    <message>
        <source>at most %1</source>
        <translation>至多 %1</translation>
    </message>
    <message>
        <source>the MAT file is damaged</source>
        <translation>MAT 文件已损坏</translation>
    </message>
    <message>
        <source>a whole MAT file of version 4, 5, 6, 7 or 7.3</source>
        <translation>版本 4、5、6、7 或 7.3 的完整 MAT 文件</translation>
    </message>
    <message>
        <source>its values are complex</source>
        <translation>其数值是复数</translation>
    </message>
    <message>
        <source>it is sparse</source>
        <translation>它是稀疏的</translation>
    </message>
    <message>
        <source>it contains text</source>
        <translation>其中是文本</translation>
    </message>
    <message>
        <source>it contains other variables</source>
        <translation>其中是其他变量</translation>
    </message>
    <message>
        <source>its values are not real numbers</source>
        <translation>其数值不是实数</translation>
    </message>
</context>
<context>
    <name>McapExport</name>
    <message>
        <source>there is no stream &quot;%1&quot;</source>
        <translation>没有数据流“%1”</translation>
    </message>
    <message>
        <source>one of %1</source>
        <translation>%1 之一</translation>
    </message>
    <message>
        <source>interrupted; nothing was written</source>
        <translation>已中断；未写入任何内容</translation>
    </message>
    <message>
        <source>a file of this name already exists</source>
        <translation>已存在同名文件</translation>
    </message>
    <message>
        <source>another name</source>
        <translation>另一个名称</translation>
    </message>
</context>
<context>
    <name>McapFile</name>
    <message>
        <source>there is no such file</source>
        <translation>没有这样的文件</translation>
    </message>
    <message>
        <source>cannot be opened: %1</source>
        <translation>无法打开：%1</translation>
    </message>
    <message>
        <source>this is not an MCAP file</source>
        <translation>这不是 MCAP 文件</translation>
    </message>
    <message>
        <source>an MCAP file, version 0</source>
        <translation>MCAP 文件，版本 0</translation>
    </message>
    <message>
        <source>the attachment &quot;%1&quot; is damaged</source>
        <translation>附件“%1”已损坏</translation>
    </message>
</context>
<context>
    <name>McapImport</name>
    <message>
        <source>%1 is of the type %2 and cannot be read as %3</source>
        <translation>%1 的类型为 %2，无法作为 %3 读取</translation>
    </message>
    <message>
        <source>there is no topic %1</source>
        <translation>没有话题 %1</translation>
    </message>
    <message>
        <source>one of %1</source>
        <translation>%1 之一</translation>
    </message>
    <message>
        <source>no topic of this file can be read: %1</source>
        <translation>此文件中没有可读取的话题：%1</translation>
    </message>
    <message>
        <source>it has none</source>
        <translation>其中没有话题</translation>
    </message>
    <message>
        <source>messages of ROS 2 in CDR</source>
        <translation>采用 CDR 的 ROS 2 消息</translation>
    </message>
    <message>
        <source>interrupted</source>
        <translation>已中断</translation>
    </message>
</context>
<context>
    <name>MeshFile</name>
    <message>
        <source>mesh_path = &quot;FOLDER&quot;</source>
        <translation>mesh_path = &quot;文件夹&quot;</translation>
    </message>
    <message>
        <source>the mesh %1 is not in the folder of the arm&apos;s meshes</source>
        <translation>网格 %1 不在机械臂的网格文件夹中</translation>
    </message>
    <message>
        <source>the mesh is missing</source>
        <translation>缺少该网格</translation>
    </message>
    <message>
        <source>meshes are read from STL, DAE and OBJ files</source>
        <translation>网格从 STL、DAE 和 OBJ 文件读取</translation>
    </message>
    <message>
        <source>the mesh is larger than %1 MB</source>
        <translation>网格大于 %1 MB</translation>
    </message>
    <message>
        <source>the mesh cannot be read: %1</source>
        <translation>无法读取网格：%1</translation>
    </message>
    <message>
        <source>the arm&apos;s file does not set mesh_path</source>
        <translation>机械臂的文件没有设置 mesh_path</translation>
    </message>
</context>
<context>
    <name>Modbus</name>
    <message>
        <source>%1 cannot be opened: %2</source>
        <translation>无法打开 %1：%2</translation>
    </message>
    <message>
        <source>The device has no motors.</source>
        <translation>该设备没有电机。</translation>
    </message>
    <message>
        <source>a table [tactors] in its file</source>
        <translation>其文件中的表 [tactors]</translation>
    </message>
    <message>
        <source>illegal function</source>
        <translation>非法功能</translation>
    </message>
    <message>
        <source>illegal data address</source>
        <translation>非法数据地址</translation>
    </message>
    <message>
        <source>illegal data value</source>
        <translation>非法数据值</translation>
    </message>
    <message>
        <source>device failure</source>
        <translation>设备故障</translation>
    </message>
    <message>
        <source>acknowledge</source>
        <translation>确认</translation>
    </message>
    <message>
        <source>device busy</source>
        <translation>设备忙</translation>
    </message>
    <message>
        <source>negative acknowledge</source>
        <translation>否定确认</translation>
    </message>
    <message>
        <source>memory parity error</source>
        <translation>存储器奇偶校验错误</translation>
    </message>
    <message>
        <source>gateway path unavailable</source>
        <translation>网关路径不可用</translation>
    </message>
    <message>
        <source>the device behind the gateway does not answer</source>
        <translation>网关后的设备没有应答</translation>
    </message>
    <message>
        <source>not in the standard</source>
        <translation>标准中未定义</translation>
    </message>
    <message>
        <source>The server answered with exception %1: %2.</source>
        <translation>服务器以异常 %1 应答：%2。</translation>
    </message>
    <message>
        <source>The server did not answer in time.</source>
        <translation>服务器未及时应答。</translation>
    </message>
    <message>
        <source>The server&apos;s answer does not fit the request.</source>
        <translation>服务器的应答与请求不符。</translation>
    </message>
    <message>
        <source>The connection was lost.</source>
        <translation>连接已断开。</translation>
    </message>
    <message>
        <source>The device reports no joints.</source>
        <translation>该设备不提供关节。</translation>
    </message>
    <message>
        <source>tables [[joint]] in its file</source>
        <translation>其文件中的表 [[joint]]</translation>
    </message>
    <message>
        <source>this arm is read-only: it reports its joints but cannot be moved</source>
        <translation>此机械臂为只读：它报告关节，但无法移动</translation>
    </message>
</context>
<context>
    <name>MotorFile</name>
    <message>
        <source>the limits belong to the bracelet &quot;%1&quot;</source>
        <translation>这些上限属于手环“%1”</translation>
    </message>
</context>
<context>
    <name>MotorFit</name>
    <message>
        <source>a motor that starts at the same drive each time; look for a loose contact</source>
        <translation>每次在相同驱动量启动的电机；请检查是否接触不良</translation>
    </message>
    <message>
        <source>There is no step: the drive is the same all the time.</source>
        <translation>没有阶跃：驱动量始终相同。</translation>
    </message>
    <message>
        <source>a staircase of drives from 0 to the full one</source>
        <translation>从 0 到满驱动的阶梯驱动</translation>
    </message>
    <message>
        <source>The full drive was never commanded: the highest is %1.</source>
        <translation>从未给出满驱动指令：最高为 %1。</translation>
    </message>
    <message>
        <source>The recording does not begin at rest.</source>
        <translation>记录不是从静止开始。</translation>
    </message>
    <message>
        <source>The recording is too short: no drive was held for %1 s.</source>
        <translation>记录过短：没有驱动量保持 %1 s。</translation>
    </message>
    <message>
        <source>a drive that is held until the motor has followed, 0.3 s</source>
        <translation>保持到电机跟上的驱动量，0.3 s</translation>
    </message>
    <message>
        <source>The recording is too short: %1 samples.</source>
        <translation>记录过短：%1 个样本。</translation>
    </message>
    <message>
        <source>at least %1</source>
        <translation>至少 %1</translation>
    </message>
    <message>
        <source>The motor does not turn, not even at the full drive.</source>
        <translation>即使在满驱动下电机也不转。</translation>
    </message>
    <message>
        <source>a connected motor, and its sensor</source>
        <translation>已连接的电机及其传感器</translation>
    </message>
    <message>
        <source>The speed is not 0 although nothing is commanded: %1 Hz.</source>
        <translation>没有指令时转速却不为 0：%1 Hz。</translation>
    </message>
    <message>
        <source>The speed is clipped: it stays at the end of the sensor&apos;s range.</source>
        <translation>转速被削顶：停留在传感器量程的端点。</translation>
    </message>
    <message>
        <source>a sensor with a larger range</source>
        <translation>量程更大的传感器</translation>
    </message>
    <message>
        <source>a step down at the end</source>
        <translation>末尾有一个向下的阶跃</translation>
    </message>
    <message>
        <source>a supply and a sensor that reach the full drive</source>
        <translation>能达到满驱动的电源和传感器</translation>
    </message>
    <message>
        <source>The motor started at %1 of the full drive but stood still at %2.</source>
        <translation>电机曾在满驱动的 %1 处启动，却又在 %2 处停转。</translation>
    </message>
    <message>
        <source>a commanded drive of 0 at the beginning</source>
        <translation>开始时指令驱动量为 0</translation>
    </message>
    <message>
        <source>The rise time cannot be determined: %1 s with a standard error of %2 s.</source>
        <translation>无法确定上升时间：%1 s，标准误 %2 s。</translation>
    </message>
    <message>
        <source>more samples per second, or less noise</source>
        <translation>每秒更多样本，或更低的噪声</translation>
    </message>
    <message>
        <source>The fall time cannot be determined: %1 s with a standard error of %2 s.</source>
        <translation>无法确定下降时间：%1 s，标准误 %2 s。</translation>
    </message>
    <message>
        <source>The motor does not behave like a motor with a lag: the model explains %1 of the speed.</source>
        <translation>电机未按带滞后的电机那样跟随驱动量：模型仅能解释转速的 %1。</translation>
    </message>
    <message>
        <source>a recording of one motor with the drive at the same times</source>
        <translation>单个电机的记录，含同一时刻的驱动量</translation>
    </message>
    <message>
        <source>a sensor without an offset, and a motor at rest at the beginning</source>
        <translation>没有零点偏移的传感器，且电机开始时静止</translation>
    </message>
    <message>
        <source>The motor turned at one level of the drive only: neither its start nor its curve can be determined.</source>
        <translation>电机仅在一个驱动量下转动：无法确定其启动点和曲线。</translation>
    </message>
    <message>
        <source>The drive never falls while the motor turns: the fall time cannot be determined.</source>
        <translation>电机转动期间驱动量从未下降：无法确定下降时间。</translation>
    </message>
    <message>
        <source>The samples do not determine the motor&apos;s lag.</source>
        <translation>样本不足以确定电机的滞后。</translation>
    </message>
    <message>
        <source>more samples per second during the steps</source>
        <translation>阶跃期间每秒更多样本</translation>
    </message>
    <message>
        <source>The speed is saturated: it does not rise above %1 of the drive.</source>
        <translation>转速饱和：驱动量达到 %1 后不再上升。</translation>
    </message>
    <message>
        <source>The measurement does not describe a motor: the speed does not rise with the drive.</source>
        <translation>测得的数据不符合电机特性：转速不随驱动量上升。</translation>
    </message>
</context>
<context>
    <name>MotorRecording</name>
    <message>
        <source>the time does not rise</source>
        <translation>时间没有递增</translation>
    </message>
    <message>
        <source>a time above %1 s</source>
        <translation>大于 %1 s 的时间</translation>
    </message>
    <message>
        <source>the commanded drive is %1</source>
        <translation>指令驱动量为 %1</translation>
    </message>
    <message>
        <source>a share of the full drive, 0 to 1</source>
        <translation>占满驱动的比例，0 至 1</translation>
    </message>
    <message>
        <source>there is neither a column &quot;speed_hz&quot; nor &quot;signal&quot;</source>
        <translation>既没有列“speed_hz”，也没有列“signal”</translation>
    </message>
    <message>
        <source>sample %1 is not a finite number</source>
        <translation>样本 %1 不是有限数</translation>
    </message>
    <message>
        <source>The recording does not begin at rest.</source>
        <translation>记录不是从静止开始。</translation>
    </message>
    <message>
        <source>The signal is clipped: it stays at the end of its range.</source>
        <translation>信号被削顶：停留在其量程的端点。</translation>
    </message>
    <message>
        <source>a recording with less gain</source>
        <translation>增益较小的记录</translation>
    </message>
    <message>
        <source>The signal shows no vibration above its noise.</source>
        <translation>信号中没有高于噪声的振动。</translation>
    </message>
    <message>
        <source>a sensor on the motor, with a signal above four times its noise</source>
        <translation>装在电机上的传感器，信号高于其噪声的四倍</translation>
    </message>
    <message>
        <source>the numbers of times, drives and speeds differ</source>
        <translation>时间、驱动量和转速的数目不一致</translation>
    </message>
    <message>
        <source>at least %1 s with a commanded drive of 0</source>
        <translation>指令驱动量为 0 的时间至少 %1 s</translation>
    </message>
    <message>
        <source>%1 samples per second are too few for %2 turns per second.</source>
        <translation>每秒 %1 个样本对每秒 %2 转而言过少。</translation>
    </message>
    <message>
        <source>at least %1 samples per turn</source>
        <translation>每转至少 %1 个样本</translation>
    </message>
</context>
<context>
    <name>Mouse3d</name>
    <message>
        <source>The 3D mouse at %1 cannot be opened.</source>
        <translation>无法打开位于 %1 的 3D 鼠标。</translation>
    </message>
    <message>
        <source>No 3D mouse is plugged in.</source>
        <translation>未插入 3D 鼠标。</translation>
    </message>
    <message>
        <source>The 3D mouse was unplugged.</source>
        <translation>3D 鼠标已拔出。</translation>
    </message>
    <message>
        <source>No permission to open the 3D mouse at %1.</source>
        <translation>没有权限打开位于 %1 的 3D 鼠标。</translation>
    </message>
    <message>
        <source>read and write access, which the udev rule grants</source>
        <translation>对它的读写权限，由 udev 规则授予</translation>
    </message>
</context>
<context>
    <name>NewRecordingText</name>
    <message>
        <source>a file of this name already exists</source>
        <translation>已有同名文件</translation>
    </message>
    <message>
        <source>another name</source>
        <translation>另一个名称</translation>
    </message>
    <message>
        <source>the file cannot be given its name</source>
        <translation>无法给文件命名</translation>
    </message>
</context>
<context>
    <name>NodeClaim</name>
    <message>
        <source>another program uses %1</source>
        <comment>a device</comment>
        <translation>另一个程序正在使用 %1</translation>
    </message>
    <message>
        <source>it to be closed there first</source>
        <translation>先在该程序中将其关闭</translation>
    </message>
</context>
<context>
    <name>NpyText</name>
    <message>
        <source>the head of the array is damaged at byte %1</source>
        <translation>数组的文件头在字节 %1 处损坏</translation>
    </message>
    <message>
        <source>the file ends within the head of the array</source>
        <translation>文件在数组的文件头内结束</translation>
    </message>
    <message>
        <source>a whole file</source>
        <translation>完整的文件</translation>
    </message>
    <message>
        <source>descr, fortran_order and shape</source>
        <translation>descr、fortran_order 和 shape</translation>
    </message>
    <message>
        <source>the end of the head</source>
        <translation>文件头的结尾</translation>
    </message>
    <message>
        <source>a text in quotes</source>
        <translation>带引号的文本</translation>
    </message>
    <message>
        <source>a closing quote</source>
        <translation>右引号</translation>
    </message>
    <message>
        <source>its values are structured, with fields</source>
        <translation>其值为结构化类型，含字段</translation>
    </message>
    <message>
        <source>its values are of type &quot;%1&quot;</source>
        <translation>其值的类型为“%1”</translation>
    </message>
    <message>
        <source>its values are objects of Python, which were pickled</source>
        <translation>其值为经 pickle 序列化的 Python 对象</translation>
    </message>
    <message>
        <source>its values are complex numbers</source>
        <translation>其值为复数</translation>
    </message>
    <message>
        <source>its values are texts</source>
        <translation>其值为文本</translation>
    </message>
    <message>
        <source>whole numbers of 0 or more</source>
        <translation>不小于 0 的整数</translation>
    </message>
    <message>
        <source>npy of version %1.%2</source>
        <translation>%1.%2 版 npy</translation>
    </message>
    <message>
        <source>version 1.0, 2.0 or 3.0</source>
        <translation>1.0、2.0 或 3.0 版</translation>
    </message>
    <message>
        <source>a head of at most 1 MiB</source>
        <translation>至多 1 MiB 的文件头</translation>
    </message>
    <message>
        <source>the file ends after %1 of %2 values</source>
        <translation>文件在 %1 个值之后结束，应有 %2 个值</translation>
    </message>
    <message>
        <source>the file goes on behind the %1 values of its array</source>
        <translation>文件在其数组的 %1 个值之后还有内容</translation>
    </message>
    <message>
        <source>one array</source>
        <translation>一个数组</translation>
    </message>
</context>
<context>
    <name>NpzExportText</name>
    <message>
        <source>the recording has no tactile array</source>
        <translation>记录中没有触觉阵列</translation>
    </message>
    <message>
        <source>frames of an array</source>
        <translation>阵列的帧</translation>
    </message>
    <message>
        <source>the recording has no array &quot;%1&quot;</source>
        <translation>记录中没有阵列“%1”</translation>
    </message>
    <message>
        <source>the recording has several arrays</source>
        <translation>记录中有多个阵列</translation>
    </message>
    <message>
        <source>one of them (--stream NAME): %1</source>
        <translation>其中之一（--stream NAME）：%1</translation>
    </message>
    <message>
        <source>a file of this name already exists</source>
        <translation>已存在同名文件</translation>
    </message>
    <message>
        <source>another name</source>
        <translation>另一个名称</translation>
    </message>
    <message>
        <source>interrupted; nothing was written</source>
        <translation>已中断；未写入任何内容</translation>
    </message>
    <message>
        <source>the recording is too long</source>
        <translation>记录过长</translation>
    </message>
    <message>
        <source>at most %1 values</source>
        <translation>至多 %1 个值</translation>
    </message>
</context>
<context>
    <name>NpzWriterText</name>
    <message>
        <source>cannot write the file: %1</source>
        <translation>无法写入文件：%1</translation>
    </message>
</context>
<context>
    <name>NumpyFileText</name>
    <message>
        <source>the file ends after %1 of %2 values</source>
        <translation>文件在 %1 个值之后结束，应有 %2 个值</translation>
    </message>
    <message>
        <source>a whole file</source>
        <translation>完整的文件</translation>
    </message>
    <message>
        <source>the zip archive is damaged: %1</source>
        <translation>zip 压缩包已损坏：%1</translation>
    </message>
    <message>
        <source>a whole npz file</source>
        <translation>完整的 npz 文件</translation>
    </message>
    <message>
        <source>the zip archive has too many files</source>
        <translation>zip 压缩包中的文件过多</translation>
    </message>
    <message>
        <source>at most %1</source>
        <translation>至多 %1</translation>
    </message>
    <message>
        <source>the zip archive has no array of NumPy</source>
        <translation>zip 压缩包中没有 NumPy 数组</translation>
    </message>
    <message>
        <source>an npz file, with files that end in .npy</source>
        <translation>npz 文件，含以 .npy 结尾的文件</translation>
    </message>
    <message>
        <source>a whole npz file that is not encrypted</source>
        <translation>未加密的完整 npz 文件</translation>
    </message>
</context>
<context>
    <name>OperatorDomainText</name>
    <message>
        <source>without certificates anybody on this network could move the arm</source>
        <translation>没有证书，此网络上的任何人都能移动机械臂</translation>
    </message>
    <message>
        <source>security = &quot;certificates&quot;, or interface = &quot;lo&quot;</source>
        <translation>security = &quot;certificates&quot;，或 interface = &quot;lo&quot;</translation>
    </message>
    <message>
        <source>no interface is named, so that each network reaches the site</source>
        <translation>未指定接口，因此每个网络都能到达站点</translation>
    </message>
    <message>
        <source>%1 is no tunnel, so that its whole network reaches the site</source>
        <translation>%1 不是隧道，因此其整个网络都能到达站点</translation>
    </message>
    <message>
        <source>interface: that of a VPN; or security_bind = &quot;any&quot;</source>
        <translation>interface：VPN 的接口；或 security_bind = &quot;any&quot;</translation>
    </message>
</context>
<context>
    <name>OscTrigger</name>
    <message>
        <source>the host for triggers was not found: %1</source>
        <translation>未找到触发信号的主机：%1</translation>
    </message>
    <message>
        <source>a name or an address</source>
        <translation>名称或地址</translation>
    </message>
    <message>
        <source>triggers cannot be sent: %1</source>
        <translation>无法发送触发信号：%1</translation>
    </message>
</context>
<context>
    <name>OutputFileText</name>
    <message>
        <source>cannot write: %1</source>
        <translation>无法写入：%1</translation>
    </message>
    <message>
        <source>standard output</source>
        <translation>标准输出</translation>
    </message>
    <message>
        <source>cannot make the folder</source>
        <translation>无法创建文件夹</translation>
    </message>
</context>
<context>
    <name>OutputText</name>
    <message>
        <source>Print one JSON document on standard output</source>
        <translation>在标准输出上输出一个 JSON 文档</translation>
    </message>
    <message>
        <source>Write the CSV to this file, which appears when it is complete</source>
        <translation>将 CSV 写入此文件，完成后才会出现</translation>
    </message>
</context>
<context>
    <name>OverlayMaker</name>
    <message>
        <source>%1: %2</source>
        <extracomment>A contact in the 3-D view: its number and its force
----------
A contact on a gel in the 3-D view: its number and how much of it slips</extracomment>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>Each block: the largest of %1 × %1 taxels</source>
        <translation>每块：%1 × %1 个触觉单元中的最大值</translation>
    </message>
    <message>
        <source>Cylinder enlarged to fit: radius %1, length %2</source>
        <translation>圆柱已放大以适应：半径 %1，长度 %2</translation>
    </message>
    <message>
        <source>Cylinder: radius %1, length %2</source>
        <translation>圆柱：半径 %1，长度 %2</translation>
    </message>
    <message>
        <source>Grid: %1</source>
        <translation>网格：%1</translation>
    </message>
    <message>
        <source>%1: ± %2</source>
        <extracomment>A contact on the tube in the 3-D view: its number and the standard deviation of its centre</extracomment>
        <translation>%1：± %2</translation>
    </message>
    <message>
        <source>BUMP</source>
        <translation>碰撞</translation>
    </message>
    <message>
        <source>followed</source>
        <translation>跟随中</translation>
    </message>
    <message>
        <source>Contact %1
Force %2, peak %3
x %4, y %5
Area %6</source>
        <translation>接触 %1
力 %2，峰值 %3
x %4，y %5
面积 %6</translation>
    </message>
    <message>
        <source>Tube: radius %1, length %2</source>
        <translation>软管：半径 %1，长度 %2</translation>
    </message>
    <message>
        <source>Displacement of the skin × %1, fainter where uncertain</source>
        <translation>皮肤位移 × %1，不确定处较淡</translation>
    </message>
    <message>
        <source>Ellipses: 95 % regions of the centres</source>
        <translation>椭圆以 95 % 的概率包含中心</translation>
    </message>
    <message>
        <source>By the joints: %1</source>
        <translation>由关节得出：%1</translation>
    </message>
    <message>
        <source>Moment: %1</source>
        <extracomment>A moment in the 3-D view</extracomment>
        <translation>力矩：%1</translation>
    </message>
    <message>
        <source>%1: %2°, range %3 … %4°</source>
        <extracomment>A joint in the 3-D view: its name, its angle, the ends of its range</extracomment>
        <translation>%1：%2°，范围 %3 … %4°</translation>
    </message>
    <message>
        <source>Force, longest arrow: %1</source>
        <translation>力，最长箭头：%1</translation>
    </message>
    <message>
        <source>Moment, longest arrow: %1</source>
        <translation>力矩，最长箭头：%1</translation>
    </message>
    <message>
        <source>At the wrist: %1</source>
        <translation>腕部：%1</translation>
    </message>
    <message>
        <source>Gel: %1 × %2</source>
        <translation>凝胶：%1 × %2</translation>
    </message>
    <message>
        <source>Displacement, shear and turn × %1</source>
        <translation>位移、剪切和转动 × %1</translation>
    </message>
    <message>
        <source>Spread of the skin, longest arrow: %1</source>
        <translation>皮肤张开，最长箭头：%1</translation>
    </message>
    <message>
        <source>Shear %1, friction %2</source>
        <extracomment>Shear is the force along the surface; friction is it divided by the force into the surface</extracomment>
        <translation>剪切 %1，摩擦 %2</translation>
    </message>
</context>
<context>
    <name>PadArm</name>
    <message>
        <source>the arm has %1 joints, its description %2</source>
        <translation>机械臂有 %1 个关节，其描述有 %2 个</translation>
    </message>
</context>
<context>
    <name>PairText</name>
    <message>
        <source>points at several heights and all around the cylinder</source>
        <translation>位于多个高度且遍布圆柱四周的点</translation>
    </message>
    <message>
        <source>a coordinate is not a number, or too large</source>
        <translation>坐标不是数，或过大</translation>
    </message>
    <message>
        <source>finite pixels and metres</source>
        <translation>有限的像素和米值</translation>
    </message>
    <message>
        <source>there are too few pairs: %1</source>
        <translation>点对过少：%1</translation>
    </message>
    <message>
        <source>at least 6, better 50 or more</source>
        <translation>至少 6 个，最好 50 个或更多</translation>
    </message>
    <message>
        <source>at least 6 different points, each with its own pixel</source>
        <translation>至少 6 个不同的点，各有自己的像素</translation>
    </message>
    <message>
        <source>no camera agrees with enough of the pairs</source>
        <translation>没有相机能与足够多的点对相符</translation>
    </message>
    <message>
        <source>the pairs leave the camera undetermined: points on the surface would be uncertain by more than %1 mm</source>
        <translation>点对不足以确定相机：表面点的不确定度将超过 %1 mm</translation>
    </message>
    <message>
        <source>more pairs, spread over the whole surface</source>
        <translation>更多点对，分布于整个表面</translation>
    </message>
    <message>
        <source>more pairs near the lens, where the distortion is strongest</source>
        <translation>在畸变最强的镜头附近采集更多点对</translation>
    </message>
    <message>
        <source>a positive radius, width and height of 1 to %1 pixels</source>
        <translation>为正的半径，以及 1 至 %1 像素的宽度和高度</translation>
    </message>
    <message>
        <source>interrupted</source>
        <translation>已中断</translation>
    </message>
    <message>
        <source>the file has too many pairs</source>
        <translation>文件中的点对过多</translation>
    </message>
    <message>
        <source>at most %1</source>
        <translation>至多 %1</translation>
    </message>
    <message>
        <source>the size of the image or of the cylinder is invalid</source>
        <translation>图像或圆柱没有可用的尺寸</translation>
    </message>
    <message>
        <source>the pairs contain fewer than six different points</source>
        <translation>点对中重复的不同点少于六个</translation>
    </message>
    <message>
        <source>all points are on one line of the cylinder: the camera could turn about that line without changing the image</source>
        <translation>所有点都在圆柱的同一条直线上：相机绕该直线转动时图像不变</translation>
    </message>
    <message>
        <source>all points are on one ring of the cylinder: the camera&apos;s distance and its focal length cannot be distinguished</source>
        <translation>所有点都在圆柱的同一圆环上：无法区分相机距离与焦距</translation>
    </message>
    <message>
        <source>all points are in one plane: the camera&apos;s distance and its focal length cannot be distinguished</source>
        <translation>所有点都在同一平面上：无法区分相机距离与焦距</translation>
    </message>
    <message>
        <source>at least half of the pairs and at least %1 in agreement: check that pixels and points match, the image size and the cylinder radius</source>
        <translation>至少一半点对且至少 %1 个相符：像素与点的顺序一致，图像尺寸和圆柱半径正确</translation>
    </message>
    <message>
        <source>the lens model folds in the region of the pairs</source>
        <translation>镜头模型在点对范围内发生折叠</translation>
    </message>
    <message>
        <source>most points are on the axis of the cylinder, not on its surface</source>
        <translation>多数点位于圆柱的轴线上，而不在其表面</translation>
    </message>
    <message>
        <source>the points are %1 mm from the axis, the surface is at %2 mm: a hole factor of %3 (standard error %4) brings them onto it, unless the radius is wrong</source>
        <translation>点距轴线 %1 mm，表面在 %2 mm：除非半径有误，孔系数 %3（标准误差 %4）可使其落在表面上</translation>
    </message>
    <message>
        <source>many points are beyond the ends of the cylinder: check its length, and where z = 0 is</source>
        <translation>许多点超出圆柱两端：请检查其长度以及 z = 0 的位置</translation>
    </message>
    <message>
        <source>u and v seem to be swapped: the principal point is %1 px off the middle of the image, and with u and v swapped %2 px</source>
        <translation>u 与 v 似乎颠倒：主点距图像中心 %1 px，交换 u 与 v 后为 %2 px</translation>
    </message>
    <message>
        <source>many pixels are outside the image of %1 x %2 px: check its size</source>
        <translation>许多像素在 %1 x %2 px 的图像之外：请检查其尺寸</translation>
    </message>
    <message>
        <source>neighbouring residuals are alike: the camera does not explain everything in the pairs (a shell that has moved, a wrong radius)</source>
        <translation>相邻残差相似：相机不能解释点对中的全部内容（外壳移动、半径有误）</translation>
    </message>
</context>
<context>
    <name>PartText</name>
    <message>
        <source>a part of the program cannot be loaded: %1</source>
        <translation>无法加载程序的一个组成部分：%1</translation>
    </message>
    <message>
        <source>a complete installation of the program</source>
        <translation>完整安装的程序</translation>
    </message>
</context>
<context>
    <name>ParticipantReport</name>
    <message>
        <source>In this part nothing was tested yet.</source>
        <translation>此部分尚未进行任何测试。</translation>
    </message>
    <message>
        <source>You answered %1 of %2 trials correctly: %3 %.</source>
        <comment>numbers</comment>
        <translation>您在 %2 个试次中答对了 %1 个：%3 %。</translation>
    </message>
    <message>
        <source>There were %1 possible answers. Whoever guesses is right in about %2 % of the trials.</source>
        <translation>共有 %1 种可能的回答。仅凭猜测大约能答对 %2 % 的试次。</translation>
    </message>
    <message numerus="yes">
        <source>In %n trial(s) the time was over before you answered.</source>
        <translation>
            <numerusform>有 %n 个试次在您回答之前时间已到。</numerusform>
        </translation>
    </message>
    <message>
        <source>Half of your correct answers came within %1 seconds.</source>
        <translation>您的正确回答中有一半在 %1 秒内作出。</translation>
    </message>
    <message>
        <source>You recognised these every time: %1.</source>
        <translation>以下各项您每次都能识别：%1。</translation>
    </message>
    <message>
        <source>, </source>
        <comment>between names</comment>
        <translation>, </translation>
    </message>
    <message>
        <source>This part was not finished.</source>
        <translation>此部分未完成。</translation>
    </message>
    <message>
        <source>Thank you for taking part in the study &quot;%1&quot;.</source>
        <translation>感谢您参加研究“%1”。</translation>
    </message>
    <message>
        <source>You have not begun yet.</source>
        <translation>您尚未开始。</translation>
    </message>
    <message>
        <source>This page has your answers alone. They say how well these vibrations can be told apart on this bracelet; they are no test of health.</source>
        <translation>本页只包含您的回答。它们说明在此手环上这些振动能被区分到什么程度；这不是健康检查。</translation>
    </message>
    <message>
        <source>Completed test trials of each session; the interval is Wilson&apos;s (95 %)</source>
        <translation>各场次已完成的测试试次；区间为 Wilson 区间 (95 %)</translation>
    </message>
    <message>
        <source>Session</source>
        <translation>场次</translation>
    </message>
    <message>
        <source>Task</source>
        <translation>任务</translation>
    </message>
    <message>
        <source>Condition</source>
        <translation>条件</translation>
    </message>
    <message>
        <source>Finished</source>
        <translation>完成</translation>
    </message>
    <message>
        <source>Correct</source>
        <translation>正确</translation>
    </message>
    <message>
        <source>%</source>
        <translation>%</translation>
    </message>
    <message>
        <source>Interval, %</source>
        <translation>区间，%</translation>
    </message>
    <message>
        <source>No answer</source>
        <translation>未回答</translation>
    </message>
    <message>
        <source>Device faults</source>
        <translation>设备故障</translation>
    </message>
    <message>
        <source>Median time, s</source>
        <translation>中位时间，s</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>是</translation>
    </message>
    <message>
        <source>no</source>
        <translation>否</translation>
    </message>
    <message>
        <source>Rows: presented; columns: answered. Number of trials.</source>
        <translation>行：呈现；列：回答。试次数。</translation>
    </message>
    <message>
        <source>Question</source>
        <translation>问题</translation>
    </message>
    <message>
        <source>Answer</source>
        <translation>回答</translation>
    </message>
    <message>
        <source>no answer</source>
        <translation>未回答</translation>
    </message>
    <message>
        <source>Questionnaires</source>
        <translation>问卷</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>备注</translation>
    </message>
    <message>
        <source>the study has no participant &quot;%1&quot;</source>
        <translation>研究中没有被试“%1”</translation>
    </message>
    <message>
        <source>Your results</source>
        <translation>您的结果</translation>
    </message>
    <message>
        <source>Study: %1. Participant %2 in the order of enrolment.</source>
        <translation>研究：%1。按登记顺序的第 %2 名被试。</translation>
    </message>
    <message>
        <source>No session has begun.</source>
        <translation>尚未开始任何场次。</translation>
    </message>
    <message>
        <source>Participant %1</source>
        <comment>an id</comment>
        <translation>被试 %1</translation>
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
        <translation>刚度</translation>
    </message>
    <message>
        <source>other</source>
        <translation>其他</translation>
    </message>
    <message>
        <source>-</source>
        <translation>-</translation>
    </message>
    <message>
        <source>static</source>
        <translation>静态</translation>
    </message>
    <message>
        <source>dynamic</source>
        <translation>动态</translation>
    </message>
    <message>
        <source>Id</source>
        <translation>ID</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Task</source>
        <translation>任务</translation>
    </message>
    <message>
        <source>Condition</source>
        <translation>条件</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>时长</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>Tags</source>
        <translation>标签</translation>
    </message>
    <message>
        <source>Objects</source>
        <translation>对象</translation>
    </message>
    <message>
        <source>%1 s: %2</source>
        <translation>%1 s：%2</translation>
    </message>
    <message>
        <source>... (%1 breakpoints)</source>
        <translation>...（%1 个节点）</translation>
    </message>
    <message>
        <source>Tactor %1</source>
        <translation>振子 %1</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>备注</translation>
    </message>
    <message>
        <source>Object %1</source>
        <translation>对象 %1</translation>
    </message>
    <message>
        <source>Object %1 (%2)</source>
        <translation>对象 %1（%2）</translation>
    </message>
    <message>
        <source>Pattern file or id of a built-in pattern</source>
        <translation>图案文件或内置图案的 ID</translation>
    </message>
    <message>
        <source>List the built-in patterns</source>
        <translation>列出内置图案</translation>
    </message>
    <message>
        <source>Show what a pattern consists of</source>
        <translation>显示图案的组成</translation>
    </message>
    <message>
        <source>Sample a pattern: rows time_s,t1..t6 over its duration</source>
        <translation>对图案采样：在其时长内逐行输出 time_s,t1..t6</translation>
    </message>
    <message>
        <source>Samples a second</source>
        <translation>每秒样本数</translation>
    </message>
    <message>
        <source>Write the CSV to this file, which appears when it is complete</source>
        <translation>将 CSV 写入此文件，完成后才会出现</translation>
    </message>
    <message>
        <source>File to write</source>
        <translation>要写入的文件</translation>
    </message>
    <message>
        <source>Say where a pattern breaks a law of what can be felt</source>
        <translation>指出图案违反感知规律之处</translation>
    </message>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
    <message>
        <source>%1 keeps all laws.</source>
        <translation>%1 符合所有规律。</translation>
    </message>
    <message>
        <source>%1, %2 s to %3 s: %4 %5</source>
        <translation>%1，%2 s 至 %3 s：%4 %5</translation>
    </message>
    <message>
        <source>List, show, sample, convert, check and play the patterns of the bracelet</source>
        <translation>列出、显示、采样、转换、检查和播放手环的图案</translation>
    </message>
    <message>
        <source>Profile of the bracelet&apos;s motors, as the page Calibrate saves it</source>
        <translation>手环电机的配置，由“标定”页保存</translation>
    </message>
    <message>
        <source>What the motors will do; without --motors with an assumed motor: lag, start and speed are not measured</source>
        <translation>电机的预期动作；不带 --motors 时采用假定的电机：滞后、启动点和转速均未经测量</translation>
    </message>
    <message>
        <source>Samples a second of CSV (default 200) and WAV (default 8000)</source>
        <translation>CSV（默认 200）和 WAV（默认 8000）的每秒样本数</translation>
    </message>
    <message>
        <source>CSV and WAV: what the motors will do, with an assumed motor: lag, start and speed are not measured</source>
        <translation>CSV 和 WAV：电机的预期动作，采用假定的电机：滞后、启动点和转速均未经测量</translation>
    </message>
    <message>
        <source>Play a pattern on a bracelet</source>
        <translation>在手环上播放图案</translation>
    </message>
    <message>
        <source>%1 holds no samples: --rate and --predicted are for .csv and .wav files</source>
        <translation>%1 不含样本：--rate 和 --predicted 用于 .csv 和 .wav 文件</translation>
    </message>
    <message>
        <source>usb, simulated, or a file that describes a bracelet</source>
        <translation>usb、simulated，或描述手环的文件</translation>
    </message>
    <message>
        <source>Speed the motors up with full intensity first, for as long as their profile allows</source>
        <translation>帮助电机起动：加速期间以全强度驱动，时长不超过其特性所允许</translation>
    </message>
    <message>
        <source>Write a pattern in another format, chosen by the ending</source>
        <translation>以其他格式写出图案，格式由扩展名决定</translation>
    </message>
    <message>
        <source>Repeat it for this long, then send live setpoints for as long again, and print how punctual the frames were</source>
        <translation>反复播放指定时长，再以实时设定值运行同样时长，并输出各帧的准时程度</translation>
    </message>
    <message>
        <source>the ending of %1 is not that of a format; expected one of %2</source>
        <translation>%1 的扩展名不对应任何格式；应为 %2 之一</translation>
    </message>
    <message>
        <source>Ending that chooses the format when OUT is -, for example json</source>
        <translation>OUT 为 - 时选择格式的扩展名，例如 json</translation>
    </message>
    <message>
        <source>it belongs to OUT as -, where it is needed</source>
        <translation>它用于 OUT 为 - 的情形，此时必须给出</translation>
    </message>
    <message>
        <source>The samples are vibrations of %1 Hz with the intensities of the pattern.</source>
        <translation>样本为 %1 Hz 的振动，其强度取自图案。</translation>
    </message>
    <message>
        <source>The samples are the bare intensities, which move no voice coil: --carrier writes vibrations.</source>
        <translation>样本为纯强度，无法驱动音圈：用 --carrier 写出振动。</translation>
    </message>
    <message>
        <source>WAV: vibrations of this frequency, for voice coils, instead of the bare intensities; 250 without a number</source>
        <translation>WAV：以此频率的振动代替纯强度，用于音圈；不给数值时为 250</translation>
    </message>
    <message>
        <source>A file with one signal: the tactors that play it, for example 1,4; all without this</source>
        <translation>只含一路信号的文件：播放该信号的振子，例如 1,4；不给出时为全部振子</translation>
    </message>
    <message>
        <source>A .tact file with both arms: the one to read; left without this</source>
        <translation>含双臂的 .tact 文件：要读取的手臂；不给出时为左臂</translation>
    </message>
    <message>
        <source>expected numbers from 1 to 6 between commas</source>
        <translation>应为以逗号分隔的 1 至 6 的数字</translation>
    </message>
    <message>
        <source>it belongs to a file with one signal</source>
        <translation>它用于只含一路信号的文件</translation>
    </message>
    <message>
        <source>it is for .wav files</source>
        <translation>它用于 .wav 文件</translation>
    </message>
</context>
<context>
    <name>PatternFile</name>
    <message>
        <source>there is no tactor for the file &quot;%1&quot;</source>
        <translation>文件“%1”没有对应的振子</translation>
    </message>
    <message>
        <source>the pattern is too long for a WAV file</source>
        <translation>图案过长，无法存为 WAV 文件</translation>
    </message>
    <message>
        <source>at most 4 GiB of samples</source>
        <translation>至多 4 GiB 的样本</translation>
    </message>
    <message>
        <source>a time that is not before the start</source>
        <translation>不早于起点的时间</translation>
    </message>
    <message>
        <source>this effect is for other devices</source>
        <translation>此效果用于其他设备</translation>
    </message>
    <message>
        <source>a pattern file that ends with .json</source>
        <translation>以 .json 结尾的图案文件</translation>
    </message>
    <message>
        <source>the key &quot;recovery&quot;</source>
        <translation>键“recovery”</translation>
    </message>
    <message>
        <source>a WAV file cannot have this rate</source>
        <translation>WAV 文件不支持此采样率</translation>
    </message>
    <message>
        <source>the pattern is too long for overdrive</source>
        <translation>图案太长，无法过驱动</translation>
    </message>
    <message>
        <source>at most %1 s</source>
        <translation>至多 %1 s</translation>
    </message>
    <message>
        <source>the pattern has too many corners</source>
        <translation>图案的拐点太多</translation>
    </message>
    <message>
        <source>at most %1 breakpoints</source>
        <translation>至多 %1 个节点</translation>
    </message>
    <message>
        <source>the pattern cannot be stretched by this factor</source>
        <translation>图案无法如此拉伸</translation>
    </message>
    <message>
        <source>a factor above 0 that makes it at most a day long</source>
        <translation>大于 0 的倍数，且时长不超过一天</translation>
    </message>
    <message>
        <source>the times decrease</source>
        <translation>时间倒退</translation>
    </message>
    <message>
        <source>a time that is not before the previous one</source>
        <translation>不早于前一个的时间</translation>
    </message>
    <message>
        <source>a pattern cannot represent this</source>
        <translation>图案无法容纳此内容</translation>
    </message>
    <message>
        <source>the times decrease or exceed the longest pattern</source>
        <translation>时间倒退或持续过久</translation>
    </message>
    <message>
        <source>the folder cannot be created</source>
        <translation>无法创建文件夹</translation>
    </message>
    <message>
        <source>this format cannot store another name</source>
        <translation>此格式无法容纳另一个名称</translation>
    </message>
    <message>
        <source>this name is unknown</source>
        <translation>此名称未知</translation>
    </message>
    <message>
        <source>this is a different format</source>
        <translation>这是另一种格式</translation>
    </message>
    <message>
        <source>the file was written by a newer version</source>
        <translation>文件版本较新</translation>
    </message>
    <message>
        <source>this is not a recovery file</source>
        <translation>这不是恢复文件</translation>
    </message>
    <message>
        <source>the sample rate is out of range</source>
        <translation>采样率超出范围</translation>
    </message>
    <message>
        <source>%1 to %2 per second</source>
        <translation>每秒 %1 至 %2</translation>
    </message>
    <message>
        <source>the values of a motor are inconsistent</source>
        <translation>某个电机的值相互矛盾</translation>
    </message>
    <message>
        <source>a whole number of samples per second</source>
        <translation>每秒整数个样本</translation>
    </message>
    <message>
        <source>this part is not known</source>
        <translation>此部分未知</translation>
    </message>
    <message>
        <source>too many pieces overlap</source>
        <translation>重叠的片段过多</translation>
    </message>
    <message>
        <source>a pattern of at most %1 objects</source>
        <translation>至多 %1 个对象的图案</translation>
    </message>
    <message>
        <source>there are too many emphases</source>
        <translation>强调点过多</translation>
    </message>
    <message>
        <source>at most %1</source>
        <translation>至多 %1</translation>
    </message>
    <message>
        <source>vectorial waves, transients or curves of vibration</source>
        <translation>矢量波、瞬态或曲线形式的振动</translation>
    </message>
    <message>
        <source>there are too many effects, or too many inside each other</source>
        <translation>效果过多，或嵌套过深</translation>
    </message>
    <message>
        <source>there is no such effect in the library</source>
        <translation>库中没有此效果</translation>
    </message>
    <message>
        <source>the id of an effect in effect_library</source>
        <translation>effect_library 中某个效果的 id</translation>
    </message>
    <message>
        <source>there are too many keyframes</source>
        <translation>关键帧过多</translation>
    </message>
    <message>
        <source>files tactor1%1 to tactor6%1, each once</source>
        <translation>文件 tactor1%1 至 tactor6%1，每个一次</translation>
    </message>
    <message>
        <source>the paths are too long</source>
        <translation>路径过长</translation>
    </message>
    <message>
        <source>at most %1 points</source>
        <translation>至多 %1 个点</translation>
    </message>
    <message>
        <source>this rate cannot hold a carrier of %1 Hz</source>
        <translation>此采样率无法容纳 %1 Hz 的载波</translation>
    </message>
    <message>
        <source>a carrier above 0 and below half of %1 samples per second</source>
        <translation>大于 0 且低于每秒 %1 个样本之半的载波</translation>
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
        <translation>各短振起始相隔 %1；相隔 %2 时会被感觉为一个连续的运动。</translation>
    </message>
    <message>
        <source>Object %1 plays on the same motor at the same time (tactors %2).</source>
        <translation>对象 %1 同时在同一电机上播放（振子 %2）。</translation>
    </message>
    <message>
        <source>Tactors %1 are at most %2 Hz apart in speed: they beat.</source>
        <translation>振子 %1 的转速相差至多 %2 Hz：会产生拍频。</translation>
    </message>
    <message>
        <source>It goes on until %1 s, but the pattern ends at %2 s.</source>
        <translation>它持续到 %1 s，而图案在 %2 s 结束。</translation>
    </message>
    <message>
        <source>Give the ring %1 turns.</source>
        <translation>将环绕设为 %1 圈。</translation>
    </message>
    <message>
        <source>Make it %1 long.</source>
        <translation>将时长设为 %1。</translation>
    </message>
    <message>
        <source>Make the ring %1 long.</source>
        <translation>将环绕时长设为 %1。</translation>
    </message>
    <message>
        <source>Let the law of apparent motion set them %1 apart.</source>
        <translation>按似动规律使其相隔 %1。</translation>
    </message>
    <message>
        <source>Give both the same intensity, or make them %1 Hz different.</source>
        <translation>使两者强度相同，或使其相差 %1 Hz。</translation>
    </message>
    <message>
        <source>Let the pattern last %1 s.</source>
        <translation>将图案时长设为 %1 s。</translation>
    </message>
    <message>
        <source>Make motor %1 weaker there, by %2 %, so that they are %3 Hz apart.</source>
        <translation>在那里把电机 %1 减弱 %2 %，使两者相差 %3 Hz。</translation>
    </message>
    <message>
        <source>A burst of %1 is too short for the motor, which needs %2 to speed up.</source>
        <translation>%1 的短振对电机而言过短，电机需要 %2 才能升速。</translation>
    </message>
    <message>
        <source>A turn of the ring takes %1; its direction is felt reliably only if a turn takes at least %2.</source>
        <translation>环绕一圈用时 %1；从 %2 起才能可靠地感觉到方向。</translation>
    </message>
    <message>
        <source>Let it begin at %1 s, when the other one has ended.</source>
        <translation>让它在另一个结束后的 %1 s 开始。</translation>
    </message>
</context>
<context>
    <name>PatternLoss</name>
    <message>
        <source>Frequencies left out: %1. The frequency of the motors follows their intensity.</source>
        <translation>略去的频率：%1。电机的频率随其强度而变。</translation>
    </message>
    <message>
        <source>Short pulses that became bursts of %2 ms: %1.</source>
        <translation>变为 %2 ms 短振的短脉冲：%1。</translation>
    </message>
    <message>
        <source>The pattern is longer than the file by %1 s, so that its last burst is whole.</source>
        <translation>图案比文件长 %1 s，以使最后一次短振保持完整。</translation>
    </message>
    <message>
        <source>The file holds one signal. It plays on tactor %1.</source>
        <comment>a list of numbers</comment>
        <translation>文件只含一路信号，由振子 %1 播放。</translation>
    </message>
    <message>
        <source>Channels without a direction, put on the tactors in their order: %1.</source>
        <translation>没有方向、按顺序分配给各振子的通道：%1。</translation>
    </message>
    <message>
        <source>Channels left out, because no tactor is left for them: %1.</source>
        <translation>因没有剩余振子而略去的通道：%1。</translation>
    </message>
    <message>
        <source>Effects for the other arm left out: %1.</source>
        <translation>略去的另一只手臂的效果：%1。</translation>
    </message>
    <message>
        <source>Effects for other devices left out: %1.</source>
        <translation>略去的其他设备的效果：%1。</translation>
    </message>
    <message>
        <source>Parts that are not vibration left out: %1.</source>
        <translation>略去的非振动部分：%1。</translation>
    </message>
    <message>
        <source>Tracks left out that are switched off: %1.</source>
        <translation>略去的已关闭轨道：%1。</translation>
    </message>
    <message>
        <source>Pieces that overlap others: %1. The stronger one counts; they do not add up.</source>
        <translation>与其他片段重叠的片段：%1。取较强者；不叠加。</translation>
    </message>
    <message>
        <source>Paths shared among the motors nearest to them: %1.</source>
        <translation>分配到最近几个电机的路径：%1。</translation>
    </message>
    <message>
        <source>Paths or envelopes of a single point left out: %1. They have no length.</source>
        <translation>略去的单点路径或包络：%1。它们没有长度。</translation>
    </message>
    <message>
        <source>Sounds left out: %1.</source>
        <translation>略去的声音：%1。</translation>
    </message>
    <message>
        <source>Events whose attack, decay or release was left out: %1.</source>
        <translation>略去起音、衰减或释音的事件：%1。</translation>
    </message>
    <message>
        <source>Settings that a pattern does not have: %1.</source>
        <translation>图案所没有的设置：%1。</translation>
    </message>
    <message>
        <source>Coded wave forms left out: %1.</source>
        <translation>略去的编码波形：%1。</translation>
    </message>
    <message>
        <source>Curves of displacement, of which the size plays in straight lines: %1.</source>
        <translation>位移曲线，按其大小以直线段播放：%1。</translation>
    </message>
    <message>
        <source>Intensities beyond full drive, set to 1: %1.</source>
        <translation>超出满驱动而设为 1 的强度：%1。</translation>
    </message>
    <message>
        <source>Objects written as the intensities that they play: %1.</source>
        <translation>以其播放的强度写出的对象：%1。</translation>
    </message>
    <message>
        <source>Slopes written as steps of %2 ms: %1. They differ from the pattern by up to %3.</source>
        <translation>写为每级 %2 ms 阶梯的斜坡：%1。与图案最多相差 %3。</translation>
    </message>
    <message>
        <source>Times rounded to milliseconds: %1.</source>
        <translation>取整到毫秒的时间：%1。</translation>
    </message>
    <message>
        <source>The first one is at %1 s.</source>
        <translation>第一处位于 %1 s。</translation>
    </message>
    <message>
        <source>First seen in %1.</source>
        <translation>首次出现于 %1。</translation>
    </message>
    <message>
        <source>Keyframes before the beginning of their effect, moved to it: %1.</source>
        <translation>位于其效果开始之前、已移到开始处的关键帧：%1。</translation>
    </message>
    <message>
        <source>Shapes and phases of waves left out: %1. The motors play their strength only.</source>
        <translation>略去的波形和相位：%1。电机只播放其强度。</translation>
    </message>
</context>
<context>
    <name>PatternNames</name>
    <message>
        <source>Circle, static</source>
        <translation>圆，静态</translation>
    </message>
    <message>
        <source>Rectangle, static</source>
        <translation>矩形，静态</translation>
    </message>
    <message>
        <source>Triangle, static</source>
        <translation>三角形，静态</translation>
    </message>
    <message>
        <source>Arc, static</source>
        <translation>圆弧，静态</translation>
    </message>
    <message>
        <source>Line, static</source>
        <translation>线，静态</translation>
    </message>
    <message>
        <source>Point, static</source>
        <translation>点，静态</translation>
    </message>
    <message>
        <source>Circle, dynamic</source>
        <translation>圆，动态</translation>
    </message>
    <message>
        <source>Rectangle, dynamic</source>
        <translation>矩形，动态</translation>
    </message>
    <message>
        <source>Triangle, dynamic</source>
        <translation>三角形，动态</translation>
    </message>
    <message>
        <source>Arc, dynamic</source>
        <translation>圆弧，动态</translation>
    </message>
    <message>
        <source>Line, dynamic</source>
        <translation>线，动态</translation>
    </message>
    <message>
        <source>Point, dynamic</source>
        <translation>点，动态</translation>
    </message>
    <message>
        <source>Sponge, static</source>
        <translation>海绵，静态</translation>
    </message>
    <message>
        <source>Rubber sponge, static</source>
        <translation>橡胶海绵，静态</translation>
    </message>
    <message>
        <source>Rubber, static</source>
        <translation>橡胶，静态</translation>
    </message>
    <message>
        <source>Wood, static</source>
        <translation>木材，静态</translation>
    </message>
    <message>
        <source>Metal, static</source>
        <translation>金属，静态</translation>
    </message>
    <message>
        <source>Sponge, dynamic</source>
        <translation>海绵，动态</translation>
    </message>
    <message>
        <source>Rubber sponge, dynamic</source>
        <translation>橡胶海绵，动态</translation>
    </message>
    <message>
        <source>Rubber, dynamic</source>
        <translation>橡胶，动态</translation>
    </message>
    <message>
        <source>Wood, dynamic</source>
        <translation>木材，动态</translation>
    </message>
    <message>
        <source>Metal, dynamic</source>
        <translation>金属，动态</translation>
    </message>
</context>
<context>
    <name>PatternPlay</name>
    <message>
        <source>the profile is of the bracelet &quot;%1&quot;</source>
        <translation>该配置属于手环“%1”</translation>
    </message>
    <message>
        <source>median %1, 99 % below %2, longest %3 us</source>
        <translation>中位数 %1，99 % 低于 %2，最长 %3 us</translation>
    </message>
    <message>
        <source>The bracelet was lost.</source>
        <translation>手环已断开。</translation>
    </message>
    <message>
        <source>A frame was so late that the bracelet had stopped.</source>
        <translation>某一帧延迟过久，手环已停止。</translation>
    </message>
    <message>
        <source>Bracelet</source>
        <translation>手环</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>频率</translation>
    </message>
    <message>
        <source>%1 Hz, achieved %2 Hz</source>
        <translation>%1 Hz，实际 %2 Hz</translation>
    </message>
    <message>
        <source>Playback thread</source>
        <translation>播放线程</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>帧</translation>
    </message>
    <message>
        <source>Deadlines missed</source>
        <translation>错过的时限</translation>
    </message>
    <message>
        <source>Frames lost</source>
        <translation>丢失的帧</translation>
    </message>
    <message>
        <source>Late by</source>
        <translation>延迟</translation>
    </message>
    <message>
        <source>Write</source>
        <translation>写入</translation>
    </message>
    <message>
        <source>Setpoints</source>
        <translation>设定值</translation>
    </message>
    <message>
        <source>Misses meanwhile</source>
        <translation>期间错过次数</translation>
    </message>
    <message>
        <source>Snapshot to frame</source>
        <translation>从快照到帧</translation>
    </message>
    <message>
        <source>No bracelet answers.</source>
        <translation>没有手环应答。</translation>
    </message>
    <message>
        <source>The bracelet is too hot.</source>
        <translation>手环过热。</translation>
    </message>
    <message>
        <source>let it cool down first</source>
        <translation>请先让它冷却</translation>
    </message>
    <message>
        <source>Confirmed</source>
        <translation>已确认</translation>
    </message>
    <message>
        <source>played by the callback of the sound card</source>
        <translation>由声卡的回调播放</translation>
    </message>
    <message>
        <source>Latency</source>
        <translation>延迟</translation>
    </message>
    <message>
        <source>at most %1 ms, as stated, not measured</source>
        <translation>至多 %1 ms，为声明值，未经测量</translation>
    </message>
    <message>
        <source>Callback</source>
        <translation>回调</translation>
    </message>
    <message>
        <source>%1 % of a period, longest %2 %, %3 missed</source>
        <translation>周期的 %1 %，最长 %2 %，错过 %3 个</translation>
    </message>
    <message>
        <source>%1 ms, as measured</source>
        <translation>%1 ms，为测量值</translation>
    </message>
</context>
<context>
    <name>PlanContent</name>
    <message>
        <source>%1: %2</source>
        <comment>task, test</comment>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>conditions</source>
        <translation>条件</translation>
    </message>
    <message>
        <source>patterns</source>
        <translation>图案</translation>
    </message>
    <message>
        <source>conditions by patterns</source>
        <translation>条件与图案的交互</translation>
    </message>
    <message>
        <source>Power: %1</source>
        <comment>test</comment>
        <translation>检验效能：%1</translation>
    </message>
    <message>
        <source>participants</source>
        <translation>被试人数</translation>
    </message>
    <message>
        <source>significant studies, %</source>
        <translation>显著的研究，%</translation>
    </message>
    <message>
        <source>target</source>
        <translation>目标</translation>
    </message>
    <message>
        <source>Cancelled. The curve has the studies drawn so far.</source>
        <translation>已取消。曲线包含目前已抽取的研究。</translation>
    </message>
    <message>
        <source>No number up to %1 reaches %2 %.</source>
        <translation>直到 %1 的人数均达不到 %2 %。</translation>
    </message>
    <message>
        <source>%1 or %2 participants reach %3 %; chance cannot tell which.</source>
        <translation>%1 或 %2 名被试可达到 %3 %；因偶然性无法判定是哪一个。</translation>
    </message>
    <message>
        <source>%1 participants reach %2 %.</source>
        <translation>%1 名被试可达到 %2 %。</translation>
    </message>
    <message>
        <source>threshold</source>
        <translation>阈值</translation>
    </message>
    <message>
        <source>studies with an interval narrow enough, %</source>
        <translation>区间足够窄的研究，%</translation>
    </message>
    <message>
        <source>Precision: %1</source>
        <comment>test</comment>
        <translation>精度：%1</translation>
    </message>
</context>
<context>
    <name>PlaneCalibration</name>
    <message>
        <source>Find how pixels become places on a flat gel: by --board, --ruler or --pitch-mm</source>
        <translation>求像素如何对应平面凝胶上的位置：用 --board、--ruler 或 --pitch-mm</translation>
    </message>
    <message>
        <source>Inner corners of the chessboard in the picture, as 7x5</source>
        <translation>图像中棋盘的内角点数，如 7x5</translation>
    </message>
    <message>
        <source>Side of a square of the chessboard, mm</source>
        <translation>棋盘方格的边长，mm</translation>
    </message>
    <message>
        <source>Distance of neighbouring markers of the gel, mm</source>
        <translation>凝胶相邻标记的间距，mm</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>比例</translation>
    </message>
    <message>
        <source>%1 mm/px, standard deviation %2 mm/px</source>
        <translation>%1 mm/px，标准差 %2 mm/px</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>点</translation>
    </message>
    <message>
        <source>Kept</source>
        <translation>保留</translation>
    </message>
    <message>
        <source>Off by</source>
        <translation>偏差</translation>
    </message>
    <message>
        <source>%1 px rms</source>
        <translation>%1 px（均方根）</translation>
    </message>
    <message>
        <source>one of --board, --ruler and --pitch-mm is needed</source>
        <translation>需要 --board、--ruler 和 --pitch-mm 之一</translation>
    </message>
    <message>
        <source>a single row does not show a plane</source>
        <translation>单独一行不能确定平面</translation>
    </message>
    <message>
        <source>the side of a square is needed with --board</source>
        <translation>使用 --board 时需要方格的边长</translation>
    </message>
    <message>
        <source>a PNG or JPEG picture of a chessboard</source>
        <translation>棋盘的 PNG 或 JPEG 图像</translation>
    </message>
    <message>
        <source>the markers of this sensor form no rectangular grid</source>
        <translation>该传感器的标记不构成矩形网格</translation>
    </message>
    <message>
        <source>grid = &quot;rectangular&quot; with rows and columns</source>
        <translation>grid = &quot;rectangular&quot; 以及 rows 和 columns</translation>
    </message>
    <message>
        <source>no picture can be read from it</source>
        <translation>无法从中读取图像</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not two pixels and a length: U,V,U,V,MM</source>
        <translation>“%1”不是两个像素和一个长度：U,V,U,V,MM</translation>
    </message>
    <message>
        <source>Of a flat gel: its sensor file, with crop, flips, lens and grid of markers; [plane] may be absent</source>
        <translation>对于平面凝胶：其传感器文件，含裁剪、翻转、镜头和标记网格；可以没有 [plane]</translation>
    </message>
    <message>
        <source>Two points of a ruler in the camera&apos;s whole picture, and their distance; several times for several lengths. A picture is only read for its size</source>
        <translation>相机整幅图像中标尺上的两点及其距离；多个长度可重复给出。图像只用于读取其尺寸</translation>
    </message>
    <message>
        <source>Rulers</source>
        <translation>标尺</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a size such as 7x5</source>
        <translation>“%1”不是像 7x5 这样的尺寸</translation>
    </message>
    <message>
        <source>this is not a picture</source>
        <translation>这不是图像</translation>
    </message>
    <message>
        <source>a PNG or JPEG picture</source>
        <translation>PNG 或 JPEG 图像</translation>
    </message>
    <message>
        <source>a point lies outside the picture of %1 x %2 pixels</source>
        <translation>有一点位于 %1 x %2 像素的图像之外</translation>
    </message>
    <message>
        <source>the lens of the sensor file needs the size of the picture: give a picture too, or a crop in the sensor file</source>
        <translation>传感器文件中的镜头需要图像尺寸：请同时给出一幅图像，或在传感器文件中给出裁剪</translation>
    </message>
    <message>
        <source>a point lies where the lens of the sensor file shows no place</source>
        <translation>有一点位于传感器文件中的镜头不成像之处</translation>
    </message>
</context>
<context>
    <name>PlaneFit</name>
    <message numerus="yes">
        <source>%n point(s) are too few</source>
        <translation>
            <numerusform>%n 个点太少</numerusform>
        </translation>
    </message>
    <message>
        <source>at least %1 points</source>
        <translation>至少 %1 个点</translation>
    </message>
    <message>
        <source>all points lie on one line, which does not show a plane</source>
        <translation>所有点都在一条直线上，不能确定平面</translation>
    </message>
    <message>
        <source>points in at least two rows</source>
        <translation>至少两行的点</translation>
    </message>
    <message>
        <source>the points show no plane in front of the camera</source>
        <translation>这些点不能给出相机前方的平面</translation>
    </message>
    <message>
        <source>points of one flat pattern, each with its own place</source>
        <translation>同一平面图案上的点，各有各的位置</translation>
    </message>
    <message>
        <source>the length of the ruler is not above 0</source>
        <translation>标尺的长度不大于 0</translation>
    </message>
    <message>
        <source>the two points of the ruler are too close to each other</source>
        <translation>标尺的两点过近</translation>
    </message>
    <message>
        <source>points that are at least %1 px apart</source>
        <translation>相距至少 %1 px 的点</translation>
    </message>
    <message>
        <source>no ruler was read</source>
        <translation>没有读取标尺</translation>
    </message>
    <message>
        <source>the rulers contradict each other: %1 mm is %2 px off</source>
        <translation>各标尺相互矛盾：%1 mm 偏差 %2 px</translation>
    </message>
    <message>
        <source>lengths that agree within 5 %; a picture seen askew needs a chessboard</source>
        <translation>相差在 5 % 以内的长度；斜拍的图像需要棋盘</translation>
    </message>
</context>
<context>
    <name>ProcessText</name>
    <message>
        <source>the program cannot be started: %1</source>
        <translation>无法启动程序：%1</translation>
    </message>
</context>
<context>
    <name>ProgramText</name>
    <message>
        <source>Usage</source>
        <translation>用法</translation>
    </message>
    <message>
        <source>OPTIONS</source>
        <translation>选项</translation>
    </message>
    <message>
        <source>Options</source>
        <translation>选项</translation>
    </message>
    <message>
        <source>Arguments</source>
        <translation>参数</translation>
    </message>
    <message>
        <source>COMMAND</source>
        <translation>命令</translation>
    </message>
    <message>
        <source>Commands</source>
        <translation>命令</translation>
    </message>
    <message>
        <source>(required)</source>
        <translation>（必需）</translation>
    </message>
    <message>
        <source>Print this help</source>
        <translation>显示此帮助</translation>
    </message>
    <message>
        <source>Computes contacts, stiffness and shape from what a tactile robot arm has felt.</source>
        <translation>根据触觉机械臂的感知计算接触、刚度和形状。</translation>
    </message>
    <message>
        <source>Print the version</source>
        <translation>显示版本</translation>
    </message>
    <message>
        <source>Example:</source>
        <translation>示例：</translation>
    </message>
    <message>
        <source>there is no command &apos;%1&apos;; expected one of %2</source>
        <translation>没有命令“%1”；应为以下之一：%2</translation>
    </message>
    <message>
        <source>teleta: %1
Run %2 --help for more.
</source>
        <translation>teleta: %1
更多说明见 %2 --help。
</translation>
    </message>
    <message>
        <source>With --version: print version and commit as JSON</source>
        <translation>与 --version 一起使用：以 JSON 输出版本和提交</translation>
    </message>
    <message>
        <source>Print how to cite the program, as BibTeX</source>
        <translation>以 BibTeX 输出本程序的引用方式</translation>
    </message>
    <message>
        <source>there is not enough memory</source>
        <translation>内存不足</translation>
    </message>
</context>
<context>
    <name>ProtocolSummary</name>
    <message>
        <source>Each trial</source>
        <translation>每次试次</translation>
    </message>
    <message>
        <source>Practice</source>
        <translation>练习</translation>
    </message>
    <message>
        <source>Test</source>
        <translation>测试</translation>
    </message>
    <message>
        <source>Order</source>
        <translation>顺序</translation>
    </message>
    <message>
        <source>All repetitions together, in random order.</source>
        <translation>所有重复合在一起，随机排序。</translation>
    </message>
    <message>
        <source>Each repetition in a random order.</source>
        <translation>每轮重复随机排序。</translation>
    </message>
    <message>
        <source>Rests</source>
        <translation>休息</translation>
    </message>
    <message>
        <source>Masking noise</source>
        <translation>掩蔽噪声</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>记录</translation>
    </message>
    <message>
        <source>Each session is recorded.</source>
        <translation>记录每个场次。</translation>
    </message>
    <message>
        <source>Test trials</source>
        <translation>测试试次</translation>
    </message>
    <message numerus="yes">
        <source>%n for each participant, at most.</source>
        <translation>
            <numerusform>每位被试最多 %n 次。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n question(s).</source>
        <translation>
            <numerusform>%n 个问题。</numerusform>
        </translation>
    </message>
    <message>
        <source>Questionnaires</source>
        <translation>问卷</translation>
    </message>
    <message>
        <source>What does not count</source>
        <translation>不计入的内容</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>The stimulus lasts %1 at most.</source>
        <translation>刺激最长 %1。</translation>
    </message>
    <message>
        <source>The answer counts within %1 of its onset.</source>
        <translation>从其开始起 %1 内的回答有效。</translation>
    </message>
    <message>
        <source>The answer counts within %1 of its end.</source>
        <translation>从其结束起 %1 内的回答有效。</translation>
    </message>
    <message>
        <source>It is felt once.</source>
        <translation>只感受一次。</translation>
    </message>
    <message numerus="yes">
        <source>It may be felt again %n time(s).</source>
        <translation>
            <numerusform>可以再感受 %n 次。</numerusform>
        </translation>
    </message>
    <message>
        <source>None.</source>
        <translation>无。</translation>
    </message>
    <message numerus="yes">
        <source>Each stimulus %n time(s).</source>
        <translation>
            <numerusform>每个刺激 %n 次。</numerusform>
        </translation>
    </message>
    <message>
        <source>The right answer is shown after each trial.</source>
        <translation>每次试次后显示正确答案。</translation>
    </message>
    <message>
        <source>The right answer is not shown.</source>
        <translation>不显示正确答案。</translation>
    </message>
    <message>
        <source>The pictures of the patterns are in view.</source>
        <translation>显示图案的图片。</translation>
    </message>
    <message>
        <source>The pictures of the patterns are not in view.</source>
        <translation>不显示图案的图片。</translation>
    </message>
    <message numerus="yes">
        <source>After every %n trial(s), at least %1.</source>
        <translation>
            <numerusform>每 %n 次试次后，至少 %1。</numerusform>
        </translation>
    </message>
    <message>
        <source>Pink, %1 dBA.</source>
        <translation>粉红噪声，%1 dBA。</translation>
    </message>
    <message>
        <source>Conditions</source>
        <translation>条件</translation>
    </message>
    <message>
        <source>Which was it?</source>
        <translation>是哪一个？</translation>
    </message>
    <message>
        <source>Question</source>
        <translation>问题</translation>
    </message>
    <message>
        <source>Design</source>
        <translation>设计</translation>
    </message>
    <message>
        <source>Levels</source>
        <translation>水平</translation>
    </message>
    <message>
        <source>%1 to %2 %3, chosen by %4.</source>
        <comment>lowest, highest, unit, procedure</comment>
        <translation>%1 至 %2 %3，由%4选择。</translation>
    </message>
    <message>
        <source>Tracks</source>
        <translation>序列</translation>
    </message>
    <message numerus="yes">
        <source>%n, interleaved.</source>
        <translation>
            <numerusform>%n 个，交错进行。</numerusform>
        </translation>
    </message>
    <message>
        <source>Yes or no: was it there?</source>
        <translation>是或否：有没有？</translation>
    </message>
    <message>
        <source>Intervals: in which one was it?</source>
        <translation>区间：在哪一个？</translation>
    </message>
    <message>
        <source>Same or different?</source>
        <translation>相同还是不同？</translation>
    </message>
    <message>
        <source>Compare: which one had more?</source>
        <translation>比较：哪一个更多？</translation>
    </message>
    <message>
        <source>constant stimuli</source>
        <translation>恒定刺激法</translation>
    </message>
    <message>
        <source>a staircase</source>
        <translation>阶梯法</translation>
    </message>
    <message>
        <source>a Bayesian procedure (QUEST+)</source>
        <translation>贝叶斯方法（QUEST+）</translation>
    </message>
    <message>
        <source>Before the first session.</source>
        <translation>第一个场次之前。</translation>
    </message>
    <message>
        <source>Before each session.</source>
        <translation>每个场次之前。</translation>
    </message>
    <message>
        <source>After each session.</source>
        <translation>每个场次之后。</translation>
    </message>
    <message>
        <source>After the last session.</source>
        <translation>最后一个场次之后。</translation>
    </message>
    <message>
        <source>Trials answered earlier than %1.</source>
        <translation>早于 %1 回答的试次。</translation>
    </message>
    <message>
        <source>Trials answered later than %1.</source>
        <translation>晚于 %1 回答的试次。</translation>
    </message>
    <message>
        <source>Trials whose time is more than %1 MADs from the median.</source>
        <translation>时间偏离中位数超过 %1 个 MAD 的试次。</translation>
    </message>
    <message>
        <source>Trials with more than %1 device faults.</source>
        <translation>设备故障超过 %1 次的试次。</translation>
    </message>
    <message>
        <source>Trials with more than %1 missed frames.</source>
        <translation>丢帧超过 %1 的试次。</translation>
    </message>
    <message>
        <source>Sessions in which more than %1 % of the trials have no answer.</source>
        <translation>超过 %1 % 的试次无回答的场次。</translation>
    </message>
    <message>
        <source>Sessions with more than %1 % of yes in catch trials.</source>
        <translation>捕捉试次中回答“是”超过 %1 % 的场次。</translation>
    </message>
    <message>
        <source>Sessions with one answer in more than %1 % of the trials.</source>
        <translation>同一回答超过 %1 % 试次的场次。</translation>
    </message>
    <message>
        <source>Participants with less than %1 % right in practice.</source>
        <translation>练习正确率低于 %1 % 的被试。</translation>
    </message>
    <message>
        <source>Participants who are not better than chance (p above %1).</source>
        <translation>不优于随机水平的被试（p 高于 %1）。</translation>
    </message>
</context>
<context>
    <name>Provenance</name>
    <message>
        <source>SIMULATED</source>
        <translation>模拟</translation>
    </message>
    <message>
        <source>RECORDED</source>
        <translation>记录</translation>
    </message>
    <message>
        <source>RECORDED SIMULATION</source>
        <translation>模拟记录</translation>
    </message>
    <message>
        <source>UNGUARDED</source>
        <translation>无保护</translation>
    </message>
</context>
<context>
    <name>PseudonymKey</name>
    <message>
        <source>another program changes the file</source>
        <translation>另一个程序正在修改该文件</translation>
    </message>
    <message>
        <source>to try again in a moment</source>
        <translation>稍后重试</translation>
    </message>
    <message>
        <source>the key of the pseudonyms lies in the study&apos;s folder</source>
        <translation>假名密钥位于研究文件夹中</translation>
    </message>
    <message>
        <source>a file apart from the data, which are copied and published</source>
        <translation>与数据分开的文件，因为数据会被复制和发布</translation>
    </message>
    <message>
        <source>a row has no participant</source>
        <translation>有一行没有被试</translation>
    </message>
    <message>
        <source>a participant of the study</source>
        <translation>研究的一名被试</translation>
    </message>
    <message>
        <source>the key has a person for &quot;%1&quot; already</source>
        <translation>密钥中已有“%1”对应的人</translation>
    </message>
    <message>
        <source>another name</source>
        <translation>另一个名称</translation>
    </message>
</context>
<context>
    <name>QosText</name>
    <message>
        <source>the publisher is best effort, the subscriber asks for reliable</source>
        <translation>发布者为 best effort，订阅者要求 reliable</translation>
    </message>
    <message>
        <source>the publisher is volatile, the subscriber asks for transient local</source>
        <translation>发布者为 volatile，订阅者要求 transient local</translation>
    </message>
    <message>
        <source>publisher and subscriber have incompatible qualities of service (QoS)</source>
        <translation>发布者与订阅者的服务质量（QoS）不兼容</translation>
    </message>
</context>
<context>
    <name>RecordedLoads</name>
    <message>
        <source>the array does not have this</source>
        <translation>阵列没有此项</translation>
    </message>
    <message>
        <source>this is listed twice</source>
        <translation>此项出现了两次</translation>
    </message>
    <message>
        <source>least is above greatest</source>
        <translation>least 大于 greatest</translation>
    </message>
</context>
<context>
    <name>RecordedSignalsText</name>
    <message>
        <source>The recording has no &quot;%1&quot;.</source>
        <translation>记录中没有“%1”。</translation>
    </message>
    <message>
        <source>The reading was stopped.</source>
        <translation>读取已停止。</translation>
    </message>
</context>
<context>
    <name>RecordedStreamText</name>
    <message>
        <source>the stream &quot;%1&quot; is not described: %2</source>
        <translation>数据流“%1”没有描述：%2</translation>
    </message>
    <message>
        <source>it is not an array</source>
        <translation>它不是阵列</translation>
    </message>
    <message>
        <source>it is not an arm</source>
        <translation>它不是机械臂</translation>
    </message>
    <message>
        <source>its links have another number of joints</source>
        <translation>其连杆的关节数不同</translation>
    </message>
    <message>
        <source>it has a pad and no links</source>
        <translation>它有触觉阵列但没有连杆</translation>
    </message>
</context>
<context>
    <name>RecordedStreams</name>
    <message>
        <source>a recording of an array, an arm or a camera</source>
        <translation>阵列、机械臂或相机的记录</translation>
    </message>
    <message>
        <source>the recording has no frames of an array, an arm or a camera</source>
        <translation>记录中没有阵列、机械臂或摄像头的帧</translation>
    </message>
    <message>
        <source>it is not a picture in colour</source>
        <translation>不是彩色图像</translation>
    </message>
    <message>
        <source>it is no gel with markers</source>
        <translation>它不是带标记的凝胶</translation>
    </message>
</context>
<context>
    <name>Recording</name>
    <message>
        <source>the stream &quot;%1&quot; is described by &quot;%2&quot;</source>
        <translation>数据流“%1”由“%2”描述</translation>
    </message>
    <message>
        <source>the stream &quot;%1&quot; has %2 columns instead of %3</source>
        <translation>数据流“%1”有 %2 列，应为 %3 列</translation>
    </message>
    <message>
        <source>a new name</source>
        <translation>新名称</translation>
    </message>
    <message>
        <source>the recording cannot be written: %1</source>
        <translation>无法写入记录：%1</translation>
    </message>
    <message>
        <source>a recording of this program</source>
        <translation>本程序的记录</translation>
    </message>
    <message>
        <source>the recording was made by a newer version of the program (format %1)</source>
        <translation>该记录由较新版本的程序生成（格式 %1）</translation>
    </message>
    <message>
        <source>format %1 or older</source>
        <translation>格式 %1 或更早</translation>
    </message>
    <message>
        <source>a folder that can be written to: the recording was cut off and has to be completed</source>
        <translation>可写入的文件夹：该记录被截断，须补全</translation>
    </message>
    <message>
        <source>the disk is full</source>
        <translation>磁盘已满</translation>
    </message>
    <message>
        <source>the recording is damaged: %1</source>
        <translation>记录已损坏：%1</translation>
    </message>
    <message>
        <source>block %1 of the stream &quot;%2&quot; is incomplete</source>
        <translation>数据流“%2”的数据块 %1 不完整</translation>
    </message>
    <message>
        <source>the recording was never started</source>
        <translation>记录从未开始</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a time</source>
        <translation>“%1”不是时间</translation>
    </message>
    <message>
        <source>a file of this name already exists</source>
        <translation>已存在同名文件</translation>
    </message>
    <message>
        <source>a writable folder</source>
        <translation>可写入的文件夹</translation>
    </message>
    <message>
        <source>this is not a recording</source>
        <translation>这不是记录</translation>
    </message>
    <message>
        <source>this is an SQLite database, but not a recording</source>
        <translation>这是 SQLite 数据库，但不是记录</translation>
    </message>
    <message>
        <source>its format version is missing</source>
        <translation>它没有格式</translation>
    </message>
</context>
<context>
    <name>RecordingArgumentsText</name>
    <message>
        <source>the loads are in %1, a unit without a usual threshold</source>
        <translation>负载的单位是 %1，它没有通用的阈值</translation>
    </message>
    <message>
        <source>--threshold, from how many %1 a taxel is in contact</source>
        <translation>--threshold：从多少 %1 起触觉单元算作接触</translation>
    </message>
</context>
<context>
    <name>RecordingExport</name>
    <message>
        <source>another folder</source>
        <translation>另一个文件夹</translation>
    </message>
    <message>
        <source>interrupted; nothing was written</source>
        <translation>已中断；未写入任何内容</translation>
    </message>
    <message>
        <source>the folder cannot be created or written to</source>
        <translation>无法创建或写入该文件夹</translation>
    </message>
    <message>
        <source>a file of this name already exists</source>
        <translation>已存在同名文件</translation>
    </message>
    <message>
        <source>the recording cannot be read</source>
        <translation>无法读取该记录</translation>
    </message>
</context>
<context>
    <name>RecordingRequest</name>
    <message>
        <source>the recording has no stream &quot;%1&quot; to play</source>
        <translation>记录中没有可回放的数据流“%1”</translation>
    </message>
</context>
<context>
    <name>RegisterMapReader</name>
    <message>
        <source>&quot;scale&quot; is 0</source>
        <translation>“scale”为 0</translation>
    </message>
    <message>
        <source>the value of one count</source>
        <translation>一个计数对应的值</translation>
    </message>
    <message>
        <source>the last register would be beyond 65535</source>
        <translation>最后一个寄存器将超出 65535</translation>
    </message>
    <message>
        <source>an address of at most %1</source>
        <translation>至多为 %1 的地址</translation>
    </message>
    <message>
        <source>&quot;%1&quot; does not fit into the register</source>
        <translation>“%1”超出寄存器的表示范围</translation>
    </message>
    <message>
        <source>a value that type, scale and offset can express</source>
        <translation>类型、比例和偏移所能表示的值</translation>
    </message>
    <message>
        <source>&quot;full&quot; and &quot;off&quot; are the same</source>
        <translation>“full”与“off”相同</translation>
    </message>
    <message>
        <source>a value at which the motor runs as fast as it can</source>
        <translation>电机以最快速度运转时的值</translation>
    </message>
    <message>
        <source>a float has no bits to look at</source>
        <translation>浮点数没有可读取的位</translation>
    </message>
    <message>
        <source>one of: %1</source>
        <translation>以下之一：%1</translation>
    </message>
    <message>
        <source>there is no input &quot;%1&quot;</source>
        <translation>没有输入“%1”</translation>
    </message>
    <message>
        <source>the name of an [[input]]</source>
        <translation>某个 [[input]] 的名称</translation>
    </message>
    <message>
        <source>the unit of &quot;%1&quot; is &quot;%2&quot;</source>
        <translation>“%1”的单位为“%2”</translation>
    </message>
    <message>
        <source>an input in %1</source>
        <translation>单位为 %1 的输入</translation>
    </message>
    <message>
        <source>the name &quot;%1&quot; is used twice</source>
        <translation>名称“%1”使用了两次</translation>
    </message>
    <message>
        <source>a name of its own for each input</source>
        <translation>每个输入使用各自的名称</translation>
    </message>
    <message>
        <source>the watchdog is a register of a motor</source>
        <translation>看门狗占用了电机的寄存器</translation>
    </message>
    <message>
        <source>a register of its own</source>
        <translation>专用的寄存器</translation>
    </message>
    <message>
        <source>there is no motor to watch</source>
        <translation>没有可监视的电机</translation>
    </message>
    <message>
        <source>a table [tactors]</source>
        <translation>表 [tactors]</translation>
    </message>
    <message>
        <source>the file names no register</source>
        <translation>文件未指定任何寄存器</translation>
    </message>
    <message>
        <source>[tactors] or [[input]]</source>
        <translation>[tactors] 或 [[input]]</translation>
    </message>
    <message>
        <source>no such device comes with the program</source>
        <translation>程序未自带此设备</translation>
    </message>
    <message>
        <source>&quot;start&quot; is not between &quot;off&quot; and &quot;full&quot;</source>
        <translation>“start”不在“off”与“full”之间</translation>
    </message>
    <message>
        <source>the value of the weakest intensity</source>
        <translation>最弱强度对应的值</translation>
    </message>
    <message>
        <source>nothing turns the motors off when the program is killed or the line is cut</source>
        <translation>程序被终止或线路中断时，没有任何机制关闭电机</translation>
    </message>
    <message>
        <source>[watchdog] with the address of the driver&apos;s watchdog register, or with by_traffic = true where it turns them off when nothing is written</source>
        <translation>[watchdog]，给出驱动器看门狗寄存器的地址；若驱动器在无写入时自行关闭电机，则设 by_traffic = true</translation>
    </message>
    <message>
        <source>&quot;answer_timeout_s&quot; is too long for motors: STOP may have to wait for it</source>
        <translation>“answer_timeout_s”对电机而言过长：STOP 可能须等待它</translation>
    </message>
    <message>
        <source>at most %1 s</source>
        <translation>至多 %1 s</translation>
    </message>
    <message>
        <source>too many joints: %1</source>
        <translation>关节过多：%1</translation>
    </message>
    <message>
        <source>at most %1, from the base to the tip</source>
        <translation>最多 %1 个，从基座到末端</translation>
    </message>
</context>
<context>
    <name>RelayText</name>
    <message>
        <source>no line to the driver can be opened: %1</source>
        <translation>无法打开到驱动器的线路：%1</translation>
    </message>
</context>
<context>
    <name>RemoteCameraText</name>
    <message>
        <source>the received data are not a complete JPEG picture (%1 bytes)</source>
        <translation>收到的数据不是完整的 JPEG 图像（%1 字节）</translation>
    </message>
</context>
<context>
    <name>RemoteDeviceText</name>
    <message>
        <source>%1 sends nothing of this device</source>
        <translation>%1 没有发送此设备的数据</translation>
    </message>
    <message>
        <source>%1 does not answer</source>
        <translation>%1 没有应答</translation>
    </message>
</context>
<context>
    <name>RemoteSiteFileText</name>
    <message>
        <source>&quot;%1&quot; cannot be a name</source>
        <translation>“%1”不能作为名称</translation>
    </message>
    <message>
        <source>a small letter, then at most 30 small letters, digits and _</source>
        <translation>一个小写字母，其后最多 30 个小写字母、数字和 _</translation>
    </message>
</context>
<context>
    <name>ReplayCommand</name>
    <message numerus="yes">
        <source>%n damaged block(s) left out</source>
        <translation>
            <numerusform>略去 %n 个损坏的数据块</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n frame(s) lost at this speed</source>
        <translation>
            <numerusform>以此速度丢失 %n 帧</numerusform>
        </translation>
    </message>
    <message>
        <source>Recording of the console or of teleta simulate</source>
        <translation>控制台或 teleta simulate 的记录</translation>
    </message>
    <message>
        <source>Times the recorded speed; otherwise as fast as possible</source>
        <translation>相对记录速度的倍数；默认尽可能快</translation>
    </message>
    <message>
        <source>Load from which a taxel is in contact; otherwise as it was recorded</source>
        <translation>触觉单元视为接触的最小载荷；默认与记录时相同</translation>
    </message>
    <message numerus="yes">
        <source>%n frame(s) were not printed</source>
        <translation>
            <numerusform>%n 帧未输出</numerusform>
        </translation>
    </message>
    <message>
        <source>Play a recording through the processing of a device and print its features, or a camera&apos;s contacts</source>
        <translation>让记录经过设备的处理流程回放，并输出其特征或相机的接触</translation>
    </message>
    <message>
        <source>Name of the stream of an array or a camera; otherwise the first one</source>
        <translation>阵列或相机的数据流名称；默认为第一个</translation>
    </message>
    <message>
        <source>the recording has the arrays and cameras %1</source>
        <translation>记录中的阵列和相机为 %1</translation>
    </message>
    <message>
        <source>the settings changed during the recording; those of its beginning are used</source>
        <translation>设置在记录期间发生了更改；使用开始时的设置</translation>
    </message>
    <message>
        <source>this is for arrays, but the stream &quot;%1&quot; is a camera&apos;s</source>
        <translation>此选项用于阵列，但数据流“%1”来自相机</translation>
    </message>
    <message>
        <source>frames of an array or a camera</source>
        <translation>阵列或摄像头的帧</translation>
    </message>
    <message>
        <source>The gel at rest could not be found, so there are no contacts. %1</source>
        <translation>找不到静止的凝胶，因此没有接触。%1</translation>
    </message>
    <message>
        <source>%1 of %2 frames could not be used. The last reason: %3</source>
        <translation>%2 帧中有 %1 帧无法使用。最后的原因：%3</translation>
    </message>
    <message>
        <source>the recording has joints of an arm or pictures to look at, and nothing that is computed from them</source>
        <translation>记录中只有机械臂的关节或仅供观看的画面，没有由其计算的内容</translation>
    </message>
</context>
<context>
    <name>ReplayDevice</name>
    <message>
        <source>only a file can be played, not a pipe</source>
        <translation>只能播放文件，不能播放管道</translation>
    </message>
    <message>
        <source>the recording has no frames</source>
        <translation>记录中没有帧</translation>
    </message>
</context>
<context>
    <name>ReportText</name>
    <message>
        <source>en</source>
        <comment>language of the report, as BCP 47 has it</comment>
        <translation>zh-Hans</translation>
    </message>
    <message>
        <source>Data: %1. TeleTA Console %2.</source>
        <translation>数据：%1。TeleTA Console %2。</translation>
    </message>
    <message>
        <source>Compute it again</source>
        <translation>重新计算</translation>
    </message>
    <message>
        <source>There are no test trials.</source>
        <translation>没有测试试次。</translation>
    </message>
    <message>
        <source>Correct answers of the group; the interval is that of Student&apos;s t over participants (95 %)</source>
        <translation>全组的正确回答；区间为被试间的学生 t 区间 (95 %)</translation>
    </message>
    <message>
        <source>Condition</source>
        <translation>条件</translation>
    </message>
    <message>
        <source>Participants</source>
        <translation>被试</translation>
    </message>
    <message>
        <source>Mean, %</source>
        <translation>平均值，%</translation>
    </message>
    <message>
        <source>SD, %</source>
        <translation>SD，%</translation>
    </message>
    <message>
        <source>Interval, %</source>
        <translation>区间，%</translation>
    </message>
    <message>
        <source>Correct answers</source>
        <translation>正确回答</translation>
    </message>
    <message>
        <source>Dots: participants. Marks: mean with the t interval over participants.</source>
        <translation>圆点：被试。标记：平均值及被试间的 t 区间。</translation>
    </message>
    <message>
        <source>Rows: presented; columns: answered. Percent of the row, all participants.</source>
        <translation>行：呈现；列：回答。占行的百分比，全部被试。</translation>
    </message>
    <message>
        <source>Presented</source>
        <translation>呈现</translation>
    </message>
    <message>
        <source>Trials</source>
        <translation>试次</translation>
    </message>
    <message>
        <source>%1: trials and share of the row in percent</source>
        <translation>%1：试次数及占行的百分比</translation>
    </message>
    <message>
        <source>Confusion matrices</source>
        <translation>混淆矩阵</translation>
    </message>
    <message>
        <source>Pattern</source>
        <translation>图案</translation>
    </message>
    <message>
        <source>%1, %</source>
        <translation>%1，%</translation>
    </message>
    <message>
        <source>df</source>
        <translation>df</translation>
    </message>
    <message>
        <source>Patterns and conditions</source>
        <translation>图案与条件</translation>
    </message>
    <message>
        <source>Mean of the participants with the t interval (95 %).</source>
        <translation>被试平均值及 t 区间 (95 %)。</translation>
    </message>
    <message>
        <source>Participants&apos; median response times of correct, answered test trials, from the onset of the stimulus</source>
        <translation>被试在已正确回答的测试试次中的反应时间中位数，自刺激起始计</translation>
    </message>
    <message>
        <source>Median of the medians, s</source>
        <translation>中位数的中位数，s</translation>
    </message>
    <message>
        <source>Shortest, s</source>
        <translation>最短，s</translation>
    </message>
    <message>
        <source>Longest, s</source>
        <translation>最长，s</translation>
    </message>
    <message>
        <source>Response times</source>
        <translation>反应时间</translation>
    </message>
    <message>
        <source>Dots: medians of participants. Marks: the median of these.</source>
        <translation>圆点：各被试的中位数。标记：这些中位数的中位数。</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>实测</translation>
    </message>
    <message>
        <source>Bias</source>
        <translation>偏差</translation>
    </message>
    <message>
        <source>Corrected</source>
        <translation>校正后</translation>
    </message>
    <message>
        <source>Interval</source>
        <translation>区间</translation>
    </message>
    <message>
        <source>A guesser would show</source>
        <translation>纯猜测的结果</translation>
    </message>
    <message>
        <source>Remark</source>
        <translation>备注</translation>
    </message>
    <message>
        <source>few trials: fewer than 5 k²</source>
        <translation>试次较少：少于 5 k²</translation>
    </message>
    <message>
        <source>Information transfer</source>
        <translation>信息传输量</translation>
    </message>
    <message>
        <source>The measured value is too high with few trials: even a participant who only guesses shows more than 0 bit. Compare it with the column of the guesser, and use the corrected value with care.</source>
        <translation>试次较少时实测值偏高：即使只靠猜测的被试也会显示大于 0 bit。请与“纯猜测”一列比较，并谨慎使用校正值。</translation>
    </message>
    <message>
        <source>Each participant, test trials; intervals of 95 %, p of so many correct answers by chance</source>
        <translation>各被试，测试试次；95 % 区间，随机得到这么多正确回答的 p 值</translation>
    </message>
    <message>
        <source>Participant</source>
        <translation>被试</translation>
    </message>
    <message>
        <source>Correct</source>
        <translation>正确</translation>
    </message>
    <message>
        <source>No answer</source>
        <translation>未回答</translation>
    </message>
    <message>
        <source>Accuracy, %</source>
        <translation>正确率，%</translation>
    </message>
    <message>
        <source>Wilson, %</source>
        <translation>Wilson，%</translation>
    </message>
    <message>
        <source>Clopper-Pearson, %</source>
        <translation>Clopper-Pearson，%</translation>
    </message>
    <message>
        <source>p of chance</source>
        <translation>随机 p 值</translation>
    </message>
    <message>
        <source>Transfer, bit</source>
        <translation>传输量，bit</translation>
    </message>
    <message>
        <source>Guesser, bit</source>
        <translation>纯猜测，bit</translation>
    </message>
    <message>
        <source>Corrected, bit</source>
        <translation>校正后，bit</translation>
    </message>
    <message>
        <source>Median time, s</source>
        <translation>中位时间，s</translation>
    </message>
    <message>
        <source>Times</source>
        <translation>时间数</translation>
    </message>
    <message>
        <source>Analysis of variance within participants of the shares of correct answers; p with the corrections of Greenhouse and Geisser and of Huynh and Feldt</source>
        <translation>对正确回答比例的被试内方差分析；p 值含 Greenhouse-Geisser 校正和 Huynh-Feldt 校正</translation>
    </message>
    <message>
        <source>Effect</source>
        <translation>效应</translation>
    </message>
    <message>
        <source>partial η²</source>
        <translation>偏 η²</translation>
    </message>
    <message>
        <source>generalised η²</source>
        <translation>广义 η²</translation>
    </message>
    <message>
        <source>%1 is left out: a cell is missing</source>
        <translation>%1 被排除：缺少一个单元格</translation>
    </message>
    <message>
        <source>Analysis of variance</source>
        <translation>方差分析</translation>
    </message>
    <message numerus="yes">
        <source>Stimuli: %n trial(s) were played on a bracelet; the longest write of a frame took %1 ms.</source>
        <translation>
            <numerusform>刺激：有 %n 个试次在手环上播放；写入一帧最长用时 %1 ms。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Stimuli: the frames of %n trial(s) were counted.</source>
        <translation>
            <numerusform>刺激：已统计 %n 个试次的帧。</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 Frames were missed in %2 of them, %3 in all.</source>
        <comment>the sentence before, numbers</comment>
        <translation>%1其中 %2 个试次有丢帧，共 %3 帧。</translation>
    </message>
    <message>
        <source>PILOT: these data were taken to try the study out.</source>
        <translation>预试：这些数据用于试行研究。</translation>
    </message>
    <message>
        <source>SIMULATED: these answers were made by a program, not by people.</source>
        <translation>模拟：这些回答由程序生成，并非来自真人。</translation>
    </message>
    <message>
        <source>at least %1</source>
        <translation>至少 %1</translation>
    </message>
    <message>
        <source>at most %1</source>
        <translation>至多 %1</translation>
    </message>
    <message>
        <source>Information transfer of the pooled answers in bit. Corrected: without bias, by the jackknife over participants. Interval: of the true transfer (95 %)</source>
        <translation>合并回答的信息传输量（bit）。校正值：用被试间刀切法去除偏差。区间：真实传输量的区间（95 %）</translation>
    </message>
    <message>
        <source>Filled: measured. Hollow: less the bias, with the interval of the true transfer.</source>
        <translation>实心：实测值。空心：减去偏差，含真实传输量的区间。</translation>
    </message>
    <message>
        <source>analysis.R beside this page computes its numbers again from confusion_long.csv, except the response times, which that file does not have: Rscript analysis.R. In the folder of the study it computes the response times too, from the exported trials.</source>
        <translation>本页旁的 analysis.R 可由 confusion_long.csv 重新计算本页的数值（该文件中没有的反应时间除外）：Rscript analysis.R。放在研究的文件夹中时，还会根据导出的试次计算反应时间。</translation>
    </message>
    <message>
        <source>all participants have the same share</source>
        <translation>所有被试的比例相同</translation>
    </message>
    <message>
        <source>the interval is cut off at 0 or 100 %</source>
        <translation>区间在 0 或 100 % 处被截断</translation>
    </message>
    <message>
        <source>p, Holm</source>
        <translation>p，Holm</translation>
    </message>
    <message>
        <source>Mean of the participants&apos; correct answers for each pattern; two conditions are compared within participants; Holm: corrected over the patterns</source>
        <translation>各图案的被试正确回答平均值；两个条件在被试内比较；Holm：在各图案上校正</translation>
    </message>
</context>
<context>
    <name>ResidualPicture</name>
    <message>
        <source>Image: no pairs yet</source>
        <translation>图像：尚无点对</translation>
    </message>
    <message>
        <source>Unrolled cylinder: no pairs yet</source>
        <translation>展开的圆柱：尚无点对</translation>
    </message>
    <message>
        <source>Image: from the pixel to where the camera projects its point</source>
        <translation>图像：从像素指向相机对其点的投影</translation>
    </message>
    <message>
        <source>Unrolled cylinder: from the point to where its pixel is located</source>
        <translation>展开的圆柱：从点指向其像素的定位处</translation>
    </message>
    <message>
        <source>u to the right, v down, px</source>
        <translation>u 向右，v 向下，px</translation>
    </message>
    <message>
        <source>angle, degrees; z upwards, mm</source>
        <translation>角度，度；z 向上，mm</translation>
    </message>
    <message>
        <source>x: wrong pair   o: excluded   dashed: valid radius</source>
        <translation>x：错误点对   o：已排除   虚线：有效半径</translation>
    </message>
    <message>
        <source>along z −%1</source>
        <translation>沿 z −%1</translation>
    </message>
    <message>
        <source>+%1 mm</source>
        <translation>+%1 mm</translation>
    </message>
    <message>
        <source>arrows enlarged %1 times</source>
        <translation>箭头放大 %1 倍</translation>
    </message>
</context>
<context>
    <name>RestText</name>
    <message>
        <source>The frames do not show the value of taxel %1 without load: it is touched in nearly all of them, or nothing touches the array</source>
        <translation>这些帧没有显示触觉单元 %1 的空载值：它几乎在所有帧中都被触碰，或阵列未被触碰</translation>
    </message>
    <message>
        <source>frames of the unloaded array, their median, or a dead taxel</source>
        <translation>空载阵列的帧、其中位数，或标为失效触觉单元</translation>
    </message>
</context>
<context>
    <name>ResultsContent</name>
    <message>
        <source>all participants</source>
        <translation>全部被试</translation>
    </message>
    <message>
        <source>Right answers, 95 % Wilson interval</source>
        <translation>正确回答，95 % Wilson 区间</translation>
    </message>
    <message>
        <source>Right answers, mean of participants, 95 % t interval</source>
        <translation>正确回答，被试平均值，95 % t 区间</translation>
    </message>
    <message>
        <source>right, %</source>
        <translation>正确，%</translation>
    </message>
    <message>
        <source>chance</source>
        <translation>随机水平</translation>
    </message>
    <message>
        <source>test</source>
        <translation>测试</translation>
    </message>
    <message>
        <source>Each pattern: %1</source>
        <comment>conditions</comment>
        <translation>各图案：%1</translation>
    </message>
    <message>
        <source> against </source>
        <translation> 对 </translation>
    </message>
    <message>
        <source>Each pattern</source>
        <translation>各图案</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <comment>condition, participant</comment>
        <translation>%1，%2</translation>
    </message>
    <message>
        <source>Median response time</source>
        <translation>反应时间中位数</translation>
    </message>
    <message>
        <source>Median response times, 95 % t interval</source>
        <translation>反应时间中位数，95 % t 区间</translation>
    </message>
    <message>
        <source>s from the onset</source>
        <translation>自起始起，s</translation>
    </message>
    <message>
        <source>right answers of the test</source>
        <translation>测试的正确回答</translation>
    </message>
    <message>
        <source>Condition</source>
        <translation>条件</translation>
    </message>
    <message>
        <source>Participants</source>
        <translation>被试</translation>
    </message>
    <message>
        <source>Right %</source>
        <translation>正确 %</translation>
    </message>
    <message>
        <source>SD</source>
        <translation>SD</translation>
    </message>
    <message>
        <source>95 % t interval</source>
        <translation>95 % t 区间</translation>
    </message>
    <message>
        <source>Trials</source>
        <translation>试次</translation>
    </message>
    <message>
        <source>IT bit</source>
        <translation>IT bit</translation>
    </message>
    <message>
        <source>Bias bit</source>
        <translation>偏差 bit</translation>
    </message>
    <message>
        <source>IT corrected</source>
        <translation>校正后 IT</translation>
    </message>
    <message>
        <source>Mean of the participants&apos; shares of right answers</source>
        <translation>各被试正确率的平均值</translation>
    </message>
    <message>
        <source>Standard deviation between participants</source>
        <translation>被试间的标准差</translation>
    </message>
    <message>
        <source>Of the mean, from Student&apos;s t over participants</source>
        <translation>平均值的区间，由被试间的学生 t 分布求得</translation>
    </message>
    <message>
        <source>Of all participants together</source>
        <translation>全部被试合计</translation>
    </message>
    <message>
        <source>Information transfer of the pooled matrix, as counted</source>
        <translation>合并矩阵的信息传输量，按计数直接求得</translation>
    </message>
    <message>
        <source>Measured less bias</source>
        <translation>实测值减去偏差</translation>
    </message>
    <message>
        <source>Participant</source>
        <translation>被试</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>正确</translation>
    </message>
    <message>
        <source>No answer</source>
        <translation>未回答</translation>
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
        <translation>随机 p 值</translation>
    </message>
    <message>
        <source>Median s</source>
        <translation>中位数 s</translation>
    </message>
    <message>
        <source>of n</source>
        <translation>样本数 n</translation>
    </message>
    <message>
        <source>In time</source>
        <translation>按时</translation>
    </message>
    <message>
        <source>Probability of so many right answers, or more, by guessing</source>
        <translation>靠猜测得到这么多或更多正确回答的概率</translation>
    </message>
    <message>
        <source>Information transfer as counted</source>
        <translation>按计数直接求得的信息传输量</translation>
    </message>
    <message>
        <source>Response time of right answers</source>
        <translation>正确回答的反应时间</translation>
    </message>
    <message>
        <source>Effect</source>
        <translation>效应</translation>
    </message>
    <message>
        <source>Pattern</source>
        <translation>图案</translation>
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
        <translation>偏 eta²</translation>
    </message>
    <message>
        <source>gen. eta²</source>
        <translation>广义 eta²</translation>
    </message>
    <message>
        <source>n</source>
        <translation>n</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>备注</translation>
    </message>
    <message>
        <source>A comparison of the conditions for this pattern alone</source>
        <translation>仅就此图案比较各条件</translation>
    </message>
    <message>
        <source>Greenhouse and Geisser</source>
        <translation>Greenhouse-Geisser</translation>
    </message>
    <message>
        <source>Huynh and Feldt, at most 1</source>
        <translation>Huynh-Feldt，至多为 1</translation>
    </message>
    <message>
        <source>Generalised eta squared</source>
        <translation>广义 eta 平方</translation>
    </message>
    <message>
        <source>without %1</source>
        <translation>不含 %1</translation>
    </message>
    <message>
        <source>With fewer than 5 k² trials even the corrected value is rough.</source>
        <translation>试次少于 5 k² 时，校正值也只是粗略估计。</translation>
    </message>
    <message>
        <source>Within participants, condition × pattern, of the shares of right answers; below, the conditions compared for each pattern.</source>
        <translation>对正确率的被试内分析，条件 × 图案；下方为各图案的条件比较。</translation>
    </message>
    <message>
        <source>Average overestimate</source>
        <translation>平均偏高的量</translation>
    </message>
    <message>
        <source>Participants with complete data</source>
        <translation>数据完整的被试</translation>
    </message>
    <message>
        <source>Few trials give too high an information transfer: with %1 trials, guessing alone shows %2 bit on average. Use the corrected value next to it.</source>
        <translation>试次较少时信息传输量偏高：%1 个试次时，仅凭猜测平均也会得到 %2 bit。请看旁边的校正值。</translation>
    </message>
    <message>
        <source>There is only one condition, so the patterns are compared.</source>
        <translation>只有一个条件，因此比较各图案。</translation>
    </message>
    <message>
        <source>IT 95 %</source>
        <translation>IT 95 %</translation>
    </message>
    <message>
        <source>Remark</source>
        <translation>备注</translation>
    </message>
    <message>
        <source>Average overestimate, from the jackknife over participants</source>
        <translation>平均偏高的量，由被试间刀切法得出</translation>
    </message>
    <message>
        <source>Interval or bound of the true transfer, from the jackknife over participants</source>
        <translation>真实传输量的区间或界限，由被试间刀切法得出</translation>
    </message>
    <message>
        <source>the t interval is cut off at 0 or 100 %</source>
        <translation>t 区间在 0 或 100 % 处被截断</translation>
    </message>
    <message>
        <source>all participants have the same share</source>
        <translation>所有被试的比例相同</translation>
    </message>
    <message>
        <source>p %1</source>
        <translation>p %1</translation>
    </message>
    <message>
        <source>%1; Holm %2</source>
        <comment>p of a pattern, corrected p</comment>
        <translation>%1；Holm %2</translation>
    </message>
</context>
<context>
    <name>RobotShape</name>
    <message>
        <source>the shapes of the arm have more than %1 triangles</source>
        <translation>机械臂的形状超过 %1 个三角形</translation>
    </message>
</context>
<context>
    <name>RosArm</name>
    <message>
        <source>the arm cannot be moved: %1</source>
        <translation>无法移动机械臂：%1</translation>
    </message>
    <message>
        <source>%1 does not report: %2</source>
        <translation>%1 未提供：%2</translation>
    </message>
    <message>
        <source>%1 reports no effort, so effort_stop cannot work</source>
        <translation>%1 不提供 effort，因此 effort_stop 无法使机械臂保持</translation>
    </message>
    <message>
        <source>no controller reads %1</source>
        <translation>没有控制器读取 %1</translation>
    </message>
    <message>
        <source>looking for other programs</source>
        <translation>正在查找其他程序</translation>
    </message>
    <message>
        <source>it was held; let go of the switch and press it again</source>
        <translation>它曾被停住；请松开开关再重新按下</translation>
    </message>
    <message>
        <source>%1 reports no force, so force_stop_N cannot work</source>
        <translation>%1 没有报告力，force_stop_N 无法起作用</translation>
    </message>
    <message>
        <source>%1, which the arm requires, is not live</source>
        <translation>机械臂所需的 %1 不在线</translation>
    </message>
    <message>
        <source>the stamps of %1 are %2 s behind this computer, MoveIt Servo takes %3 to %4</source>
        <translation>%1 的时间戳比本计算机晚 %2 s，MoveIt Servo 接受 %3 到 %4</translation>
    </message>
    <message>
        <source>%1 reports a force in the frame %2, which neither the description nor /tf_static nor /tf (within the last second) has</source>
        <translation>%1 报告的力属于坐标系 %2，描述、/tf_static 以及最近一秒的 /tf 中都没有它</translation>
    </message>
</context>
<context>
    <name>RosArmCheck</name>
    <message>
        <source>nobody publishes %1</source>
        <translation>没有程序发布 %1</translation>
    </message>
    <message>
        <source>nothing was sent on %1</source>
        <translation>%1 上未发送任何内容</translation>
    </message>
    <message>
        <source>%1 does not report: %2</source>
        <translation>%1 未提供：%2</translation>
    </message>
    <message>
        <source>%1 reports all %2 joints</source>
        <translation>%1 提供了全部 %2 个关节</translation>
    </message>
    <message>
        <source>%1 publishers of %2</source>
        <translation>有 %1 个发布者发布 %2</translation>
    </message>
    <message>
        <source>%1 reports %2, which the arm does not have</source>
        <translation>%1 提供了 %2，而机械臂没有</translation>
    </message>
    <message>
        <source>%1 messages were inconsistent and were ignored</source>
        <translation>%1 条消息自相矛盾，已略去</translation>
    </message>
    <message>
        <source>%1 samples a second, longest gap %2 s</source>
        <translation>每秒 %1 个样本，最长间隔 %2 s</translation>
    </message>
    <message>
        <source>; joint_timeout_s is %1</source>
        <translation>；joint_timeout_s 为 %1</translation>
    </message>
    <message>
        <source>reported, in %1 according to the file</source>
        <translation>已提供，按文件所述单位为 %1</translation>
    </message>
    <message>
        <source>not reported, so effort_stop cannot work</source>
        <translation>未提供，因此 effort_stop 无法使机械臂保持</translation>
    </message>
    <message>
        <source>not reported</source>
        <translation>未提供</translation>
    </message>
    <message>
        <source>%1 stamps are zero</source>
        <translation>%1 个时间戳为零</translation>
    </message>
    <message>
        <source>stamps are %1 s behind this computer</source>
        <translation>时间戳比本计算机落后 %1 s</translation>
    </message>
    <message>
        <source>someone else commands %1</source>
        <translation>另有程序在向 %1 发送指令</translation>
    </message>
    <message>
        <source>%1 has the type %2</source>
        <translation>%1 的类型为 %2</translation>
    </message>
    <message>
        <source>reads %1</source>
        <translation>读取 %1</translation>
    </message>
    <message>
        <source>cannot be reached: %1</source>
        <translation>无法连通：%1</translation>
    </message>
    <message>
        <source>nobody reads %1</source>
        <translation>没有程序读取 %1</translation>
    </message>
    <message>
        <source>; found: %1</source>
        <translation>；现有 %1</translation>
    </message>
    <message>
        <source>the check was interrupted</source>
        <translation>检查被中断</translation>
    </message>
    <message>
        <source>%1 reports no force</source>
        <translation>%1 没有报告力</translation>
    </message>
    <message>
        <source>%1 messages a second, longest gap %2 s, at most %3 N</source>
        <translation>每秒 %1 条消息，最长间隔 %2 s，最大 %3 N</translation>
    </message>
    <message>
        <source>; timeout_s is %1</source>
        <translation>；timeout_s 为 %1</translation>
    </message>
    <message>
        <source>; force_stop_N is %1</source>
        <translation>；force_stop_N 为 %1</translation>
    </message>
    <message>
        <source>UNGUARDED: %1 keeps its last command when this program ends or the network fails</source>
        <translation>无保护：本程序结束或网络出故障时，%1 保持其最后的指令</translation>
    </message>
    <message>
        <source>/tf does not lead from %1 to %2</source>
        <translation>/tf 没有从 %1 到 %2 的路径</translation>
    </message>
    <message>
        <source>/tf has no pose of the time of a joint sample</source>
        <translation>/tf 中没有与关节采样同一时刻的位姿</translation>
    </message>
    <message>
        <source>%1 mm and %2° off at most</source>
        <translation>最多相差 %1 mm 和 %2°</translation>
    </message>
    <message>
        <source>the tip is where /tf has it: %1</source>
        <translation>末端就在 /tf 给出的位置：%1</translation>
    </message>
    <message>
        <source>the tip is not where /tf has it: %1</source>
        <translation>末端不在 /tf 给出的位置：%1</translation>
    </message>
    <message>
        <source>; the description is another robot&apos;s, or a joint has another zero</source>
        <translation>；描述属于另一台机器人，或者某个关节的零位不同</translation>
    </message>
    <message>
        <source>%1 reports a force in the frame %2, which neither the description nor /tf_static nor /tf (within the last second) has</source>
        <translation>%1 报告的力属于坐标系 %2，描述、/tf_static 以及最近一秒的 /tf 中都没有它</translation>
    </message>
</context>
<context>
    <name>RosArmCheckReport</name>
    <message numerus="yes">
        <source>the arm cannot be moved: %n problem(s)</source>
        <translation>
            <numerusform>无法移动机械臂：%n 个问题</numerusform>
        </translation>
    </message>
    <message>
        <source>on %1, pressed by %2</source>
        <translation>位于 %1，由 %2 按压</translation>
    </message>
    <message>
        <source>on %1; touches have a place, but no force and no stiffness, since the arm&apos;s efforts are not in Nm</source>
        <translation>在 %1 上；由于机械臂的力矩不以 Nm 为单位，接触有位置，但没有力和刚度</translation>
    </message>
</context>
<context>
    <name>RosArmFault</name>
    <message>
        <source>someone else commands %1</source>
        <translation>另有程序在向 %1 发送指令</translation>
    </message>
    <message>
        <source>%1 reports a position that is not a number</source>
        <translation>%1 提供的位置不是数</translation>
    </message>
    <message>
        <source>the position of %1 jumped</source>
        <translation>%1 的位置发生跳变</translation>
    </message>
    <message>
        <source>the stamps of %1 went back</source>
        <translation>%1 的时间戳倒退</translation>
    </message>
    <message>
        <source>the arm does not follow its commands</source>
        <translation>机械臂未跟随其指令</translation>
    </message>
    <message>
        <source>%1 fell silent</source>
        <translation>%1 已中断</translation>
    </message>
</context>
<context>
    <name>RosArmFile</name>
    <message>
        <source>two joints have the ROS name &quot;%1&quot;</source>
        <translation>有两个关节在传输中都名为“%1”</translation>
    </message>
    <message>
        <source>a unique name for each joint</source>
        <translation>每个关节使用各自的名称</translation>
    </message>
    <message>
        <source>a side of the box is empty or reversed</source>
        <translation>活动范围框的一条边没有长度</translation>
    </message>
    <message>
        <source>[lowest, highest] for x, y and z</source>
        <translation>x、y 和 z 的 [最小值, 最大值]</translation>
    </message>
    <message>
        <source>STOP would brake more gently than letting go</source>
        <translation>STOP 的制动会弱于松手</translation>
    </message>
    <message>
        <source>at least deceleration_radPerS2, %1</source>
        <translation>至少为 deceleration_radPerS2，%1</translation>
    </message>
    <message>
        <source>the efforts of this arm are not in Nm</source>
        <translation>此机械臂的 effort 不以 Nm 为单位</translation>
    </message>
    <message>
        <source>the file of a force sensor, kind = &quot;ros_wrench&quot;</source>
        <translation>力传感器的文件，kind = &quot;ros_wrench&quot;</translation>
    </message>
    <message>
        <source>another adapter, or unguarded = true</source>
        <translation>另一个适配器，或 unguarded = true</translation>
    </message>
    <message>
        <source>with this adapter the robot stops by itself, so it is not unguarded</source>
        <translation>使用此适配器时机器人会自行停止，因此并非无保护</translation>
    </message>
    <message>
        <source>with this adapter nothing stops the robot when this program ends or the network fails</source>
        <translation>使用此适配器时，若本程序结束或网络出故障，没有任何机制使机器人停止</translation>
    </message>
    <message>
        <source>the window is empty or reversed</source>
        <translation>范围为空或颠倒</translation>
    </message>
    <message>
        <source>[lowest, highest]</source>
        <translation>[下限, 上限]</translation>
    </message>
    <message>
        <source>the pad is not named</source>
        <translation>未指定触觉阵列</translation>
    </message>
    <message>
        <source>array = &quot;the file of the pad&quot;</source>
        <translation>array = &quot;阵列的文件&quot;</translation>
    </message>
</context>
<context>
    <name>RosArray</name>
    <message>
        <source>%1 has no sensor named &quot;%2&quot;</source>
        <translation>%1 中没有名为“%2”的传感器</translation>
    </message>
</context>
<context>
    <name>RosArrayFile</name>
    <message>
        <source>only a TactileState has sensors with names</source>
        <translation>只有 TactileState 的传感器有名称</translation>
    </message>
    <message>
        <source>with a factor of 0 every value is the same</source>
        <translation>系数为 0 时所有值都相同</translation>
    </message>
    <message>
        <source>another number</source>
        <translation>另一个数</translation>
    </message>
    <message>
        <source>without a threshold it is not known which taxels are touched</source>
        <translation>没有阈值就无法知道哪些触觉单元被触碰</translation>
    </message>
    <message>
        <source>threshold = a number in the unit of the values, above the first table</source>
        <translation>threshold = 以数值的单位表示的数，写在第一个表之前</translation>
    </message>
</context>
<context>
    <name>RosCameraMessage</name>
    <message>
        <source>a picture has the encoding &quot;%1&quot;</source>
        <translation>一幅图像的编码为“%1”</translation>
    </message>
    <message>
        <source>a picture has no pixels (%1)</source>
        <translation>一幅图像没有像素（%1）</translation>
    </message>
    <message>
        <source>a picture is too large (%1)</source>
        <translation>一幅图像过大（%1）</translation>
    </message>
    <message>
        <source>at most %1 pixels</source>
        <translation>最多 %1 个像素</translation>
    </message>
    <message>
        <source>a picture in %1 has an odd width (%2)</source>
        <translation>一幅 %1 图像的宽度为奇数（%2）</translation>
    </message>
    <message>
        <source>a row of a picture has %1 bytes, its %2 pixels need %3</source>
        <translation>图像的一行有 %1 个字节，而 %2 个像素需要 %3 个</translation>
    </message>
    <message>
        <source>a picture has %1 bytes, its size says %2</source>
        <translation>一幅图像有 %1 个字节，按其尺寸应为 %2 个</translation>
    </message>
    <message>
        <source>a picture is no JPEG or PNG, or too large (%1 bytes)</source>
        <translation>一幅图像不是 JPEG 或 PNG，或者过大（%1 个字节）</translation>
    </message>
    <message>
        <source>JPEG or PNG of at most %1 pixels</source>
        <translation>最多 %1 个像素的 JPEG 或 PNG</translation>
    </message>
    <message>
        <source>a picture is damaged (%1 bytes)</source>
        <translation>一幅图像已损坏（%1 个字节）</translation>
    </message>
</context>
<context>
    <name>RosCommand</name>
    <message>
        <source>List topics and who publishes and reads them</source>
        <translation>列出话题及其发布者和读取者</translation>
    </message>
    <message>
        <source>List the nodes of programs</source>
        <translation>列出各程序的节点</translation>
    </message>
    <message>
        <source>Print what is sent on a topic, until Ctrl-C</source>
        <translation>显示话题上发送的内容，直到 Ctrl-C</translation>
    </message>
    <message>
        <source>Name of the topic, for example /joint_states</source>
        <translation>话题名称，例如 /joint_states</translation>
    </message>
    <message>
        <source>End after so many messages</source>
        <translation>收到这么多条消息后结束</translation>
    </message>
    <message>
        <source>Number of the domain; default: ROS_DOMAIN_ID of the environment, else 0</source>
        <translation>域编号；默认：环境变量 ROS_DOMAIN_ID，否则为 0</translation>
    </message>
    <message>
        <source>Network interface, its name or its address; default: the first one</source>
        <translation>网络接口的名称或地址；默认：第一个</translation>
    </message>
    <message>
        <source>Computer on which to look for programs besides this one; may be repeated. Multicast is not used</source>
        <translation>除本机外还要查找程序的计算机；可重复。不使用多播</translation>
    </message>
    <message>
        <source>this computer</source>
        <translation>本机</translation>
    </message>
    <message>
        <source>no program of domain %1 was found on: %2. Name the robot&apos;s computer with --peer, since multicast is not used.</source>
        <translation>在以下位置未找到域 %1 的程序：%2。由于不使用多播，请用 --peer 指定机器人的计算机。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no name of a topic; expected parts of letters, digits and _ after slashes, for example /joint_states</source>
        <translation>“%1”不是话题名称；应为斜杠后由字母、数字和 _ 组成的各部分，例如 /joint_states</translation>
    </message>
    <message>
        <source>nobody published %1 in domain %2 within %3 s; looked for on: %4</source>
        <translation>在 %3 s 内，域 %2 中没有程序发布 %1；查找位置：%4</translation>
    </message>
    <message>
        <source>%1 has the type %2, which is not known</source>
        <translation>%1 的类型 %2 未知</translation>
    </message>
    <message>
        <source>nothing was sent on %1 within %2 s</source>
        <translation>%2 s 内 %1 上没有发送任何内容</translation>
    </message>
    <message>
        <source>Topics and nodes of ROS 2, without ROS</source>
        <translation>无需 ROS 即可查看 ROS 2 的话题和节点</translation>
    </message>
    <message>
        <source>Watch an arm for 5 s and report what prevents moving it</source>
        <translation>观察机械臂 5 s，并指出无法移动它的原因</translation>
    </message>
    <message>
        <source>File that describes the arm (kind = &quot;ros_arm&quot;)</source>
        <translation>描述机械臂的文件 (kind = &quot;ros_arm&quot;)</translation>
    </message>
</context>
<context>
    <name>RosProbeText</name>
    <message>
        <source>nothing came on the topic</source>
        <translation>该话题上没有收到任何数据</translation>
    </message>
</context>
<context>
    <name>RosWrenchFile</name>
    <message>
        <source>a sign of 0 hides every force</source>
        <translation>符号 0 会隐藏所有的力</translation>
    </message>
    <message>
        <source>1: it reports what acts on the arm; -1: what the arm exerts</source>
        <translation>1：报告作用在机械臂上的力；-1：报告机械臂所施加的力</translation>
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
        <translation>边缘</translation>
    </message>
</context>
<context>
    <name>RunText</name>
    <message>
        <source>STOP ended the measurement.</source>
        <translation>STOP 终止了测量。</translation>
    </message>
    <message>
        <source>release STOP and measure again</source>
        <translation>解除 STOP 并重新测量</translation>
    </message>
    <message>
        <source>The bracelet was lost during the measurement.</source>
        <translation>测量期间手环断开。</translation>
    </message>
    <message>
        <source>connect it and measure again</source>
        <translation>连接手环并重新测量</translation>
    </message>
    <message>
        <source>Something else was played meanwhile.</source>
        <translation>期间播放了其他内容。</translation>
    </message>
    <message>
        <source>measure again</source>
        <translation>重新测量</translation>
    </message>
    <message>
        <source>The bracelet is too hot to be measured.</source>
        <translation>手环过热，无法测量。</translation>
    </message>
    <message>
        <source>let it cool down and measure again</source>
        <translation>让它冷却后重新测量</translation>
    </message>
    <message>
        <source>The bracelet does not measure its motors.</source>
        <translation>该手环不能测量自身的电机。</translation>
    </message>
    <message>
        <source>a recording with a sensor of your own, or answers of a person</source>
        <translation>用自备传感器所做的记录，或人的回答</translation>
    </message>
    <message>
        <source>The measurement was ended.</source>
        <translation>测量已终止。</translation>
    </message>
    <message>
        <source>The computer was too slow for the measurement: the bracelet paused in between.</source>
        <translation>计算机过慢，无法完成测量：期间手环曾停止。</translation>
    </message>
    <message>
        <source>measure again with fewer programs running</source>
        <translation>减少其他任务后重新测量</translation>
    </message>
</context>
<context>
    <name>RunningSiteText</name>
    <message>
        <source>nothing was read yet</source>
        <translation>尚未读到任何数据</translation>
    </message>
    <message>
        <source>it sends nothing any more</source>
        <translation>已不再发送数据</translation>
    </message>
    <message>
        <source>it is not connected</source>
        <translation>未连接</translation>
    </message>
    <message>
        <source>interrupted</source>
        <translation>已中断</translation>
    </message>
    <message>
        <source>%1 requires the device %2, which the site does not have</source>
        <translation>%1 需要设备 %2，站点没有该设备</translation>
    </message>
    <message>
        <source>ids of the site&apos;s devices</source>
        <translation>站点设备的 id</translation>
    </message>
    <message>
        <source>the frame of %1: %2</source>
        <translation>%1 的坐标系：%2</translation>
    </message>
    <message>
        <source>a link of one arm of the site</source>
        <translation>站点中某一机械臂的连杆</translation>
    </message>
    <message>
        <source>several arms have the link %1</source>
        <translation>多个机械臂都有连杆 %1</translation>
    </message>
    <message>
        <source>no arm has the link %1</source>
        <translation>没有机械臂具有连杆 %1</translation>
    </message>
    <message>
        <source>the arm wears another array already</source>
        <translation>该机械臂已装有另一个阵列</translation>
    </message>
</context>
<context>
    <name>Scene</name>
    <message>
        <source>the scene is not that of a tactile array</source>
        <translation>该场景不是触觉阵列的场景</translation>
    </message>
    <message>
        <source>the scene is not that of an arm</source>
        <translation>该场景不是机械臂的场景</translation>
    </message>
    <message>
        <source>the scene is not that of a camera in a soft tube</source>
        <translation>该场景不是软管内相机的场景</translation>
    </message>
    <message>
        <source>the scene is not that of a servoing arm</source>
        <translation>该场景不是伺服机械臂的场景</translation>
    </message>
    <message>
        <source>the scene is not that of an arm with an operator</source>
        <translation>该场景不是带操作者的机械臂的场景</translation>
    </message>
    <message>
        <source>the scene is not that of a flat gel</source>
        <translation>该场景不是平面凝胶的场景</translation>
    </message>
</context>
<context>
    <name>SceneReader</name>
    <message>
        <source>a time after %1 s</source>
        <translation>晚于 %1 s 的时间</translation>
    </message>
    <message>
        <source>the motion does not end where it starts</source>
        <translation>运动没有回到起点</translation>
    </message>
    <message>
        <source>a last keyframe like the first one</source>
        <translation>与第一个相同的最后一个关键帧</translation>
    </message>
    <message>
        <source>which taxels are dead is not clear</source>
        <translation>无法确定哪些触觉单元失效</translation>
    </message>
    <message>
        <source>either &quot;count&quot; or &quot;taxels&quot;</source>
        <translation>“count”或“taxels”二者之一</translation>
    </message>
    <message>
        <source>the effect is listed twice</source>
        <translation>该效应列出了两次</translation>
    </message>
    <message>
        <source>each effect at most once</source>
        <translation>每个效应至多一次</translation>
    </message>
    <message>
        <source>the arm starts outside the range of its joints</source>
        <translation>机械臂的起始位置超出关节范围</translation>
    </message>
    <message>
        <source>%1 from %2 to %3</source>
        <translation>%1，从 %2 到 %3</translation>
    </message>
    <message>
        <source>the program has no object to touch</source>
        <translation>程序没有可触碰的物体</translation>
    </message>
    <message>
        <source>at least one [[object]]</source>
        <translation>至少一个 [[object]]</translation>
    </message>
    <message>
        <source>the camera is too far from the tube&apos;s axis</source>
        <translation>相机离管轴过远</translation>
    </message>
    <message>
        <source>less than %1 m</source>
        <translation>小于 %1 m</translation>
    </message>
    <message>
        <source>the dots touch each other</source>
        <translation>圆点相互接触</translation>
    </message>
    <message>
        <source>less than the pitch of %1 m</source>
        <translation>小于 %1 m 的间距</translation>
    </message>
    <message>
        <source>there would be too few or too many dots</source>
        <translation>圆点将过少或过多</translation>
    </message>
    <message>
        <source>more than %1 m and less than the radius of %2 m</source>
        <translation>大于 %1 m 且小于 %2 m 的半径</translation>
    </message>
    <message>
        <source>there is no tray to keep level</source>
        <translation>没有需要保持水平的托盘</translation>
    </message>
    <message>
        <source>an [object.hinge]</source>
        <translation>[object.hinge]</translation>
    </message>
    <message>
        <source>the times of the keyframes do not increase</source>
        <translation>关键帧未按时间顺序排列</translation>
    </message>
    <message>
        <source>this is deeper than the skin can yield</source>
        <translation>这超过了皮肤可压缩的深度</translation>
    </message>
    <message>
        <source>this scene cannot have the effect &quot;%1&quot;</source>
        <translation>此场景不能有效应“%1”</translation>
    </message>
    <message>
        <source>the markers touch each other</source>
        <translation>标记互相接触</translation>
    </message>
    <message>
        <source>the markers do not fit into the picture</source>
        <translation>标记超出图像</translation>
    </message>
    <message>
        <source>a grid smaller than %1 m x %2 m</source>
        <translation>小于 %1 m x %2 m 的网格</translation>
    </message>
    <message>
        <source>this is deeper than the ball is round</source>
        <translation>深度超过了球的半径</translation>
    </message>
</context>
<context>
    <name>SceneRecording</name>
    <message>
        <source>another program reads the recording, which keeps this name</source>
        <translation>另一个程序正在读取该记录，记录保留此名称</translation>
    </message>
</context>
<context>
    <name>SceneRun</name>
    <message>
        <source>the image cannot be written</source>
        <translation>无法写入图像</translation>
    </message>
    <message>
        <source>the folder cannot be created or written to</source>
        <translation>无法创建或写入该文件夹</translation>
    </message>
    <message>
        <source>the protocol has a stimulus that is not built in</source>
        <translation>方案中的某个刺激未随程序提供</translation>
    </message>
    <message>
        <source>tasks, letters and conditions whose patterns are built in</source>
        <translation>图案随程序提供的任务、字母和条件</translation>
    </message>
</context>
<context>
    <name>SerialTriggerText</name>
    <message>
        <source>the trigger&apos;s serial line cannot be used: %1</source>
        <translation>无法使用触发信号的串口：%1</translation>
    </message>
    <message>
        <source>this is not a serial line</source>
        <translation>这不是串口</translation>
    </message>
    <message>
        <source>a serial port, such as /dev/ttyUSB0</source>
        <translation>串口，例如 /dev/ttyUSB0</translation>
    </message>
</context>
<context>
    <name>ServoCurves</name>
    <message>
        <source>a number from -1e12 to 1e12, or NA</source>
        <translation>-1e12 至 1e12 的数，或 NA</translation>
    </message>
    <message>
        <source>times in order</source>
        <translation>按顺序的时间</translation>
    </message>
    <message>
        <source>names such as force+tool_speed, or nothing</source>
        <translation>诸如 force+tool_speed 的名称，或为空</translation>
    </message>
    <message>
        <source>this is not a plausible number</source>
        <translation>这不是运行数据的有效数值</translation>
    </message>
    <message>
        <source>the time decreases or is missing</source>
        <translation>时间倒退，或没有时间</translation>
    </message>
    <message>
        <source>this is not a limit of a servo</source>
        <translation>这不是伺服的限制</translation>
    </message>
</context>
<context>
    <name>ServoTexts</name>
    <message>
        <source>Free motion</source>
        <translation>自由运动</translation>
    </message>
    <message>
        <source>Align</source>
        <translation>对准</translation>
    </message>
    <message>
        <source>Edge control</source>
        <translation>边缘控制</translation>
    </message>
    <message>
        <source>Explore</source>
        <translation>探索</translation>
    </message>
    <message>
        <source>Roll</source>
        <translation>滚动</translation>
    </message>
    <message>
        <source>Follow a point</source>
        <translation>跟随一点</translation>
    </message>
    <message>
        <source>Co-manipulation</source>
        <translation>协同操作</translation>
    </message>
    <message>
        <source>no contact</source>
        <translation>无接触</translation>
    </message>
    <message>
        <source>in contact</source>
        <translation>接触中</translation>
    </message>
    <message>
        <source>searching for the contact</source>
        <translation>正在寻找接触</translation>
    </message>
    <message>
        <source>contact lost</source>
        <translation>接触丢失</translation>
    </message>
    <message>
        <source>tool speed</source>
        <translation>工具速度</translation>
    </message>
    <message>
        <source>turn rate</source>
        <translation>转动速度</translation>
    </message>
    <message>
        <source>force</source>
        <translation>力</translation>
    </message>
    <message>
        <source>saturated taxel</source>
        <translation>触觉单元饱和</translation>
    </message>
    <message>
        <source>distance from the measured pose</source>
        <translation>与实测位姿的距离</translation>
    </message>
    <message>
        <source>joint speed</source>
        <translation>关节速度</translation>
    </message>
    <message>
        <source>end of a joint</source>
        <translation>关节极限</translation>
    </message>
    <message>
        <source>singular arm</source>
        <translation>机械臂奇异</translation>
    </message>
    <message>
        <source>gap between frames</source>
        <translation>帧间隔中断</translation>
    </message>
    <message>
        <source>unusable numbers</source>
        <translation>数值不可用</translation>
    </message>
    <message>
        <source>, </source>
        <comment>between the limits that act</comment>
        <translation>, </translation>
    </message>
    <message>
        <source>Simulated cycle: %1 µs, %2 times real time. Contact %3 %, kinematics %4 %, features %5 %, control %6 %, dynamics %7 %.</source>
        <translation>模拟周期：%1 µs，实时的 %2 倍。接触 %3 %，运动学 %4 %，特征 %5 %，控制 %6 %，动力学 %7 %。</translation>
    </message>
    <message>
        <source>%1, run %2</source>
        <comment>a source, and which of its runs</comment>
        <translation>%1，第 %2 次运行</translation>
    </message>
    <message>
        <source>%1, partly without DZMP</source>
        <comment>a run</comment>
        <translation>%1，部分不含 DZMP</translation>
    </message>
    <message>
        <source>%1, without DZMP</source>
        <comment>a run</comment>
        <translation>%1，不含 DZMP</translation>
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
        <translation>任务已完成</translation>
    </message>
    <message>
        <source>task not completed: stalled by the limit “%1”</source>
        <translation>任务未完成：因限制“%1”而停滞</translation>
    </message>
    <message>
        <source>task not completed: never in contact</source>
        <translation>任务未完成：从未接触</translation>
    </message>
    <message>
        <source>task not completed: the contact was lost</source>
        <translation>任务未完成：接触已丢失</translation>
    </message>
    <message>
        <source>task not completed: stalled</source>
        <translation>任务未完成：停滞</translation>
    </message>
    <message>
        <source>task not completed: not aligned</source>
        <translation>任务未完成：未对准</translation>
    </message>
</context>
<context>
    <name>SettingsNotice</name>
    <message>
        <source>The settings are damaged: what can be read of them is used, the rest is as at the first start.</source>
        <translation>设置已损坏：能读取的部分会被使用，其余恢复为首次启动时的状态。</translation>
    </message>
    <message>
        <source>No copy of the damaged file could be kept.</source>
        <translation>无法保留损坏文件的副本。</translation>
    </message>
    <message>
        <source>A copy of the damaged file: %1</source>
        <translation>损坏文件的副本：%1</translation>
    </message>
    <message>
        <source>The settings are those of a newer version of this program: everything is as at the first start, and nothing is remembered.</source>
        <translation>设置来自本程序的较新版本：一切如首次启动时，且不会保存任何设置。</translation>
    </message>
    <message>
        <source>The file stays as it is: %1</source>
        <translation>文件保持不变：%1</translation>
    </message>
    <message>
        <source>The settings cannot be kept: what is set now is forgotten at the end.</source>
        <translation>无法保存设置：现在所做的设置在退出后会丢失。</translation>
    </message>
    <message>
        <source>This file cannot be written: %1</source>
        <translation>无法写入此文件：%1</translation>
    </message>
</context>
<context>
    <name>SimulateCommand</name>
    <message>
        <source>Scene</source>
        <translation>场景</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>种子</translation>
    </message>
    <message>
        <source>Simulated</source>
        <translation>已模拟</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>Computed in</source>
        <translation>计算用时</translation>
    </message>
    <message>
        <source>%1 s (%2 x real time)</source>
        <translation>%1 s（%2 x 实时）</translation>
    </message>
    <message>
        <source>Effect %1</source>
        <translation>效应 %1</translation>
    </message>
    <message>
        <source>Events</source>
        <translation>事件</translation>
    </message>
    <message>
        <source>Run a simulated scene as fast as possible and measure what was estimated</source>
        <translation>尽可能快地运行模拟场景，并衡量估计结果</translation>
    </message>
    <message>
        <source>Seed of all random numbers of the scene</source>
        <translation>场景中所有随机数的种子</translation>
    </message>
    <message>
        <source>Share of %1</source>
        <translation>%1 的占比</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Scene file, or the name of a scene that comes with the program</source>
        <translation>场景文件，或程序自带场景的名称</translation>
    </message>
    <message>
        <source>List the scenes that come with the program</source>
        <translation>列出程序自带的场景</translation>
    </message>
    <message>
        <source>Folder for summary.json, the recording and its data as CSV; with --ablate the CSV file</source>
        <translation>存放 summary.json、记录及其 CSV 数据的文件夹；使用 --ablate 时为 CSV 文件</translation>
    </message>
    <message>
        <source>Formats of the chart of a servo run in --out, separated by commas</source>
        <translation>--out 中伺服运行图的格式，以逗号分隔</translation>
    </message>
    <message>
        <source>Folders of earlier servo runs for the same chart, up to five</source>
        <translation>用于同一图中的先前伺服运行的文件夹，最多五个</translation>
    </message>
    <message>
        <source>Runs of each variant, with seeds from --seed upwards</source>
        <translation>每个变体的运行次数，种子从 --seed 起递增</translation>
    </message>
    <message>
        <source>is required</source>
        <translation>为必需项</translation>
    </message>
    <message>
        <source>is for scenes of a servo</source>
        <translation>用于伺服场景</translation>
    </message>
    <message>
        <source>a scene file, or a name that teleta simulate --list prints</source>
        <translation>场景文件，或 teleta simulate --list 列出的名称</translation>
    </message>
    <message>
        <source>Simulated time in seconds; default: as the scene says</source>
        <translation>模拟时间，单位秒；默认由场景规定</translation>
    </message>
    <message>
        <source>Leave out one effect at a time and compare how far each measure moves with its spread</source>
        <translation>每次去掉一种效应，并给出各测量量相对其离散度的变化</translation>
    </message>
    <message>
        <source>never in contact</source>
        <translation>从未接触</translation>
    </message>
    <message>
        <source>the contact was lost</source>
        <translation>接触已丢失</translation>
    </message>
    <message>
        <source>stalled</source>
        <translation>停滞</translation>
    </message>
    <message>
        <source>stalled by the limit %1</source>
        <translation>因限制 %1 而停滞</translation>
    </message>
    <message>
        <source>not aligned</source>
        <translation>未对准</translation>
    </message>
    <message>
        <source>completed</source>
        <translation>已完成</translation>
    </message>
    <message>
        <source>not completed: %1, in the phase %2</source>
        <translation>未完成：%1，阶段 %2</translation>
    </message>
    <message>
        <source>Task</source>
        <translation>任务</translation>
    </message>
    <message>
        <source>the task was %1</source>
        <translation>任务结果：%1</translation>
    </message>
    <message>
        <source>a completed task, or expect = &quot;not_completed&quot; in the scene</source>
        <translation>已完成的任务，或在场景中设 expect = &quot;not_completed&quot;</translation>
    </message>
</context>
<context>
    <name>SimulatedArmDevice</name>
    <message>
        <source>The arm was unplugged.</source>
        <translation>机械臂已拔出。</translation>
    </message>
</context>
<context>
    <name>SimulatedArrayDevice</name>
    <message>
        <source>The device was unplugged.</source>
        <translation>设备已拔出。</translation>
    </message>
</context>
<context>
    <name>SimulatedBracelet</name>
    <message>
        <source>Simulated bracelet</source>
        <translation>模拟手环</translation>
    </message>
    <message>
        <source>The bracelet was unplugged.</source>
        <translation>手环已拔出。</translation>
    </message>
</context>
<context>
    <name>SimulatedCameraDevice</name>
    <message>
        <source>The camera was unplugged.</source>
        <translation>相机已拔出。</translation>
    </message>
</context>
<context>
    <name>SimulatedObserver</name>
    <message>
        <source>an observer cannot have &quot;%1&quot;</source>
        <translation>观察者不能有“%1”</translation>
    </message>
    <message>
        <source>t and slope above 0, lapse from 0 to %1, sd of at least 0, as in t=0.2,slope=3.5,lapse=0.02,sd=0.1</source>
        <translation>t 和 slope 大于 0，lapse 为 0 至 %1，sd 不小于 0，例如 t=0.2,slope=3.5,lapse=0.02,sd=0.1</translation>
    </message>
</context>
<context>
    <name>SimulatedTube</name>
    <message>
        <source>the lens folds the image over itself: no camera has such a lens</source>
        <translation>相机的镜头模型发生折叠：没有相机会如此</translation>
    </message>
</context>
<context>
    <name>SiteClientText</name>
    <message>
        <source>interrupted</source>
        <translation>已中断</translation>
    </message>
    <message>
        <source>%1 speaks version %2 of the protocol of sites, this program version %3</source>
        <translation>%1 使用站点协议版本 %2，此程序使用版本 %3</translation>
    </message>
    <message>
        <source>the site %1 was not found in domain %2 within %3 s</source>
        <translation>在域 %2 中 %3 秒内未找到站点 %1</translation>
    </message>
    <message>
        <source>teleta-site running there, and its address under peers</source>
        <translation>那里正在运行 teleta-site，且其地址列在 peers 中</translation>
    </message>
    <message>
        <source>the site does not answer</source>
        <translation>站点没有应答</translation>
    </message>
    <message>
        <source>STOP is held by %1</source>
        <translation>STOP 由 %1 保持</translation>
    </message>
    <message>
        <source>nobody controls the site; request control first</source>
        <translation>没有人控制该站点；请先请求控制权</translation>
    </message>
    <message>
        <source>%1 controls the site</source>
        <translation>%1 正在控制该站点</translation>
    </message>
    <message>
        <source>control is being handed to %1</source>
        <translation>控制权正在移交给 %1</translation>
    </message>
    <message>
        <source>the site has no such arm any more</source>
        <translation>站点已没有这个机械臂</translation>
    </message>
    <message>
        <source>an arm had a fault; clear it first</source>
        <translation>某个机械臂发生过故障；请先清除</translation>
    </message>
    <message>
        <source>an earlier program of this console still controls the site</source>
        <translation>此控制台的先前程序仍在控制站点</translation>
    </message>
    <message>
        <source>let go of the switch and press it again</source>
        <translation>松开开关，再重新按下</translation>
    </message>
</context>
<context>
    <name>SiteCommandText</name>
    <message>
        <source>Check the certificates and permissions of a site, or print the commands that create them</source>
        <translation>检查站点的证书和权限，或给出生成它们的命令</translation>
    </message>
    <message>
        <source>Folder with identity_ca.pem, permissions_ca.pem, governance.p7s and one folder for each site, console and viewer</source>
        <translation>含 identity_ca.pem、permissions_ca.pem、governance.p7s 以及每个站点、控制台和查看者各一个文件夹的文件夹</translation>
    </message>
    <message>
        <source>Instead of checking, print the openssl commands that create the folder for a site of this name</source>
        <translation>不作检查，输出为此名称的站点生成该文件夹的 openssl 命令</translation>
    </message>
    <message>
        <source>Consoles that may take control</source>
        <translation>可进行控制的控制台</translation>
    </message>
    <message>
        <source>Consoles that only watch</source>
        <translation>只能查看的控制台</translation>
    </message>
    <message>
        <source>List the sites that are there and who controls them</source>
        <translation>列出现有站点及其控制者</translation>
    </message>
    <message>
        <source>Print each change of a site&apos;s state</source>
        <translation>显示站点状态的每次变化</translation>
    </message>
    <message>
        <source>Print the offset of a site&apos;s clock, and its bound</source>
        <translation>显示站点时钟的偏差及其界限</translation>
    </message>
    <message>
        <source>Record all that a site sends, without a screen</source>
        <translation>无屏幕记录站点发送的全部数据</translation>
    </message>
    <message>
        <source>File of the recording</source>
        <translation>记录的文件</translation>
    </message>
    <message>
        <source>File with which the site is reached (kind = &quot;remote_site&quot;)</source>
        <translation>用于连接站点的文件（kind = &quot;remote_site&quot;）</translation>
    </message>
    <message>
        <source>End after that time; default: Ctrl-C</source>
        <translation>在此时间后结束；默认：Ctrl-C</translation>
    </message>
    <message>
        <source>These keys are not safe to use.</source>
        <translation>这些密钥不能安全使用。</translation>
    </message>
    <message>
        <source>%1 (%2): %3, until %4</source>
        <translation>%1（%2）：%3，有效至 %4</translation>
    </message>
    <message>
        <source>Refused: %1</source>
        <translation>已拒绝：%1</translation>
    </message>
    <message>
        <source>Warning: %1</source>
        <translation>警告：%1</translation>
    </message>
    <message>
        <source>Sites at which robots are, and their keys</source>
        <translation>机器人所在的站点及其密钥</translation>
    </message>
</context>
<context>
    <name>SiteEventText</name>
    <message>
        <source>%1: the console %2 is there.</source>
        <translation>%1：控制台 %2 已连接。</translation>
    </message>
    <message>
        <source>%1 cannot listen to the console %2: %3</source>
        <translation>%1 无法接收控制台 %2：%3</translation>
    </message>
    <message>
        <source>%1: another program named %2 is connected; it is ignored.</source>
        <translation>%1：另一个名为 %2 的程序已连接；它被忽略。</translation>
    </message>
    <message>
        <source>%1 kept a program out: %2</source>
        <translation>%1 拒绝了一个程序：%2</translation>
    </message>
    <message>
        <source>%1: %2 is in control.</source>
        <translation>%1：%2 正在控制。</translation>
    </message>
    <message>
        <source>%1: %2 is no longer in control.</source>
        <translation>%1：%2 不再控制。</translation>
    </message>
    <message>
        <source>%1: STOP is held by %2.</source>
        <translation>%1：STOP 由 %2 保持。</translation>
    </message>
    <message>
        <source>%1: %2 withdrew STOP.</source>
        <translation>%1：%2 解除了 STOP。</translation>
    </message>
    <message>
        <source>%1: fault of %2: %3</source>
        <translation>%1：%2 故障：%3</translation>
    </message>
    <message>
        <source>%1: %2 is live.</source>
        <translation>%1：%2 正常。</translation>
    </message>
    <message>
        <source>%1: its recording failed: %2</source>
        <translation>%1：其记录失败：%2</translation>
    </message>
    <message>
        <source>%1: its keys: %2</source>
        <translation>%1：其密钥：%2</translation>
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
        <translation>设备需要 id</translation>
    </message>
    <message>
        <source>id = &quot;a small letter, then small letters, digits and _&quot;</source>
        <translation>id = &quot;以小写字母开头，其后为小写字母、数字和 _&quot;</translation>
    </message>
    <message>
        <source>a site does not send this kind of device</source>
        <translation>站点不发送这类设备</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no name of a console</source>
        <translation>“%1”不是控制台名称</translation>
    </message>
    <message>
        <source>a small letter, then at most 30 small letters, digits and _</source>
        <translation>一个小写字母，其后最多 30 个小写字母、数字和 _</translation>
    </message>
    <message>
        <source>two devices are called &quot;%1&quot;</source>
        <translation>有两个设备名为“%1”</translation>
    </message>
    <message>
        <source>a unique id for each device</source>
        <translation>每个设备唯一的 id</translation>
    </message>
    <message>
        <source>a pose needs a frame</source>
        <translation>位姿需要坐标系</translation>
    </message>
    <message>
        <source>frame = &quot;the link of the arm&quot;</source>
        <translation>frame = &quot;机械臂的连杆&quot;</translation>
    </message>
    <message>
        <source>the file of an arm, an array, a gel or a camera over ROS 2</source>
        <translation>机械臂、阵列、凝胶或 ROS 2 相机的文件</translation>
    </message>
    <message>
        <source>file, wts, taxels, gel, scene or scene_camera</source>
        <translation>file、wts、taxels、gel、scene 或 scene_camera</translation>
    </message>
</context>
<context>
    <name>SiteKeys</name>
    <message>
        <source>&apos;%1&apos; is not a valid name for a site or a console</source>
        <translation>“%1”不是站点或控制台的名称</translation>
    </message>
    <message>
        <source>a lowercase letter, then at most 30 of a-z, 0-9 and _</source>
        <translation>一个小写字母，后接至多 30 个 a-z、0-9 和 _</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is already taken</source>
        <translation>“%1”已被占用</translation>
    </message>
    <message>
        <source>No topic of a site (rt/teleta/SITE/...) is allowed.</source>
        <translation>未允许任何站点话题 (rt/teleta/SITE/...)。</translation>
    </message>
    <message>
        <source>%1 must not publish %2.</source>
        <translation>%1 不得发布 %2。</translation>
    </message>
    <message>
        <source>%1 needs to publish %2.</source>
        <translation>%1 需要能发布 %2。</translation>
    </message>
    <message>
        <source>%1 must not subscribe to %2.</source>
        <translation>%1 不得订阅 %2。</translation>
    </message>
    <message>
        <source>%1 needs to subscribe to %2.</source>
        <translation>%1 需要能订阅 %2。</translation>
    </message>
    <message>
        <source>%1 must not relay %2.</source>
        <translation>%1 不得转发 %2。</translation>
    </message>
    <message>
        <source>The signed document is not XML.</source>
        <translation>所签名的内容不是 XML。</translation>
    </message>
    <message>
        <source>The validity needs not_before and not_after as 2026-01-31T00:00:00, without a time zone.</source>
        <translation>有效期需要 not_before 和 not_after，格式为 2026-01-31T00:00:00，不带时区。</translation>
    </message>
    <message>
        <source>The permissions are not valid yet.</source>
        <translation>权限尚未生效。</translation>
    </message>
    <message>
        <source>The permissions have expired.</source>
        <translation>权限已过期。</translation>
    </message>
    <message>
        <source>The grant has a deny_rule. It needs none: what is not allowed is denied.</source>
        <translation>该授权含有 deny_rule。无需此项：未允许的即被拒绝。</translation>
    </message>
    <message>
        <source>The default of the grant is not DENY.</source>
        <translation>该授权的默认值不是 DENY。</translation>
    </message>
    <message>
        <source>No grant names the subject of the certificate, %1.</source>
        <translation>没有授权列出证书的主体 %1。</translation>
    </message>
    <message>
        <source>The signed document has no domain_rule.</source>
        <translation>所签名的内容没有 domain_rule。</translation>
    </message>
    <message>
        <source>%1 must be %2.</source>
        <translation>%1 必须为 %2。</translation>
    </message>
    <message>
        <source>Both authorities share one key. Anyone with a certificate could sign their own permissions.</source>
        <translation>两个证书颁发机构使用同一密钥。任何持有证书者都可为自己签署权限。</translation>
    </message>
    <message>
        <source>There is no folder for a site, a console or a viewer.</source>
        <translation>没有站点、控制台或查看者的文件夹。</translation>
    </message>
    <message>
        <source>This is not a certificate.</source>
        <translation>这不是证书。</translation>
    </message>
    <message>
        <source>The file is missing.</source>
        <translation>缺少该文件。</translation>
    </message>
    <message>
        <source>The certificate is not valid yet.</source>
        <translation>证书尚未生效。</translation>
    </message>
    <message>
        <source>The certificate has expired.</source>
        <translation>证书已过期。</translation>
    </message>
    <message>
        <source>The certificate ends on %1.</source>
        <translation>证书将于 %1 到期。</translation>
    </message>
    <message>
        <source>This is not a certificate authority (basicConstraints CA:TRUE).</source>
        <translation>这不是证书颁发机构 (basicConstraints CA:TRUE)。</translation>
    </message>
    <message>
        <source>Its key usage lacks digitalSignature or keyCertSign.</source>
        <translation>其密钥用途缺少 digitalSignature 或 keyCertSign。</translation>
    </message>
    <message>
        <source>It is not self-signed.</source>
        <translation>它不是自签名的。</translation>
    </message>
    <message>
        <source>Others can read or write this private key (chmod 600).</source>
        <translation>其他人可以读取或写入此私钥 (chmod 600)。</translation>
    </message>
    <message>
        <source>This is not a private key without a password.</source>
        <translation>这不是无密码的私钥。</translation>
    </message>
    <message>
        <source>The key does not belong to the certificate.</source>
        <translation>该密钥与证书不匹配。</translation>
    </message>
    <message>
        <source>It is not signed by permissions_ca.pem itself.</source>
        <translation>它不是由 permissions_ca.pem 本身签名的。</translation>
    </message>
    <message>
        <source>Its subject is %1, the folder is called %2.</source>
        <translation>其主体为 %1，而文件夹名为 %2。</translation>
    </message>
    <message>
        <source>It is not signed by identity_ca.pem.</source>
        <translation>它不是由 identity_ca.pem 签名的。</translation>
    </message>
    <message>
        <source>It verifies against permissions_ca.pem, so its holder could sign their own permissions. That authority must sign nothing but governance and permissions.</source>
        <translation>它能通过 permissions_ca.pem 的验证：其持有者可为自己签署权限。该证书颁发机构只能签署 governance 和 permissions。</translation>
    </message>
    <message>
        <source>The key is not here. That is fine if it is kept only on its own computer.</source>
        <translation>密钥不在此处。若它只存放在其所属的计算机上，则属正常。</translation>
    </message>
    <message>
        <source>The permissions end on %1.</source>
        <translation>权限将于 %1 到期。</translation>
    </message>
    <message>
        <source>Its topics belong to the site %1, those of other permissions to %2.</source>
        <translation>其话题属于站点 %1，而其他权限列出的是 %2。</translation>
    </message>
    <message>
        <source>There is no folder %1.</source>
        <translation>没有文件夹 %1。</translation>
    </message>
    <message>
        <source>The folder %1 cannot be read.</source>
        <translation>无法读取文件夹 %1。</translation>
    </message>
</context>
<context>
    <name>SiteProgramText</name>
    <message numerus="yes">
        <source>All %n device(s) are ready.</source>
        <translation>
            <numerusform>全部 %n 个设备已就绪。</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 is ready in domain %2 on %3</source>
        <translation>%1 已在域 %2（%3）就绪</translation>
    </message>
    <message>
        <source>the site ends; the arms are held</source>
        <translation>站点结束；机械臂保持不动</translation>
    </message>
    <message>
        <source>Runs at the robot: sends what its arms and tactile arrays feel to the consoles, and decides which console moves them.</source>
        <translation>在机器人处运行：把机械臂和触觉阵列感知到的内容发送给控制台，并决定由哪个控制台移动它们。</translation>
    </message>
    <message>
        <source>Print this help</source>
        <translation>显示此帮助</translation>
    </message>
    <message>
        <source>File of the site (kind = &quot;site&quot;)</source>
        <translation>站点的文件（kind = &quot;site&quot;）</translation>
    </message>
    <message>
        <source>Open everything, move nothing, and say what is missing</source>
        <translation>打开全部设备，不移动任何东西，并说明缺少什么</translation>
    </message>
    <message>
        <source>Print the log, or what is missing, as JSON on standard output</source>
        <translation>以 JSON 在标准输出显示日志或缺少的内容</translation>
    </message>
    <message>
        <source>Folder for recordings (record = true); default: the current one</source>
        <translation>记录的文件夹（record = true）；默认：当前文件夹</translation>
    </message>
    <message>
        <source>Print the version</source>
        <translation>显示版本</translation>
    </message>
    <message>
        <source>teleta-site: %1
Run teleta-site --help for more.
</source>
        <translation>teleta-site: %1
运行 teleta-site --help 了解更多。
</translation>
    </message>
    <message>
        <source>Folder that keeps who engages STOP, for the next start; default: $STATE_DIRECTORY, otherwise ~/.local/state/teleta-site</source>
        <translation>为下次启动保存由谁触发 STOP 的文件夹；默认：$STATE_DIRECTORY，否则 ~/.local/state/teleta-site</translation>
    </message>
</context>
<context>
    <name>SiteRequestText</name>
    <message>
        <source>the site %1 has no device to show</source>
        <translation>站点 %1 没有可显示的设备</translation>
    </message>
    <message>
        <source>the connection to %1 has ended</source>
        <translation>与 %1 的连接已结束</translation>
    </message>
    <message>
        <source>the site to be connected again</source>
        <translation>重新连接站点</translation>
    </message>
</context>
<context>
    <name>SkinKinematics</name>
    <message>
        <source>the joint %1 slides, and stiffness is evaluated from an angle</source>
        <translation>关节 %1 是移动关节，而刚度由角度求得</translation>
    </message>
    <message>
        <source>a joint that turns</source>
        <translation>转动关节</translation>
    </message>
    <message>
        <source>no joint presses the pad on %1: all of them move its centre along it</source>
        <translation>没有关节按压 %1 上的阵列：所有关节都使其中心沿阵列移动</translation>
    </message>
    <message>
        <source>a joint with a lever of 2 cm or more</source>
        <translation>力臂至少 2 cm 的关节</translation>
    </message>
    <message>
        <source>no joint %1 moves the pad on %2</source>
        <translation>没有名为 %1 的关节移动 %2 上的阵列</translation>
    </message>
    <message>
        <source>one of %1</source>
        <translation>%1 之一</translation>
    </message>
    <message>
        <source>the link %1 is moved by %2, which is no joint of the arm</source>
        <translation>连杆 %1 由 %2 移动，而它不是机械臂的关节</translation>
    </message>
    <message>
        <source>a link between %1 and %2</source>
        <translation>%1 与 %2 之间的连杆</translation>
    </message>
    <message>
        <source>%1 joint stiffnesses are given</source>
        <translation>给出了 %1 个关节刚度</translation>
    </message>
    <message>
        <source>%1, one for each joint</source>
        <translation>%1 个，每个关节一个</translation>
    </message>
</context>
<context>
    <name>Slurm</name>
    <message>
        <source>the program %1 of Slurm is not there</source>
        <translation>没有 Slurm 的程序 %1</translation>
    </message>
    <message>
        <source>the package slurm-client, or a login node of the cluster</source>
        <translation>软件包 slurm-client，或集群的登录节点</translation>
    </message>
    <message>
        <source>%1 does not answer</source>
        <translation>%1 没有应答</translation>
    </message>
    <message>
        <source>%1 refuses: %2</source>
        <translation>%1 拒绝：%2</translation>
    </message>
</context>
<context>
    <name>SoundBracelet</name>
    <message>
        <source>The sound card requests no samples.</source>
        <translation>声卡不请求采样。</translation>
    </message>
    <message>
        <source>There is no JACK library: %1</source>
        <translation>没有 JACK 库：%1</translation>
    </message>
    <message>
        <source>the package pipewire-jack, or libjack-jackd2-0</source>
        <translation>软件包 pipewire-jack 或 libjack-jackd2-0</translation>
    </message>
</context>
<context>
    <name>SoundFaultText</name>
    <message>
        <source>Samples came too late while a tactor was driven.</source>
        <translation>驱动致动器时采样到达过晚。</translation>
    </message>
    <message>
        <source>The sound server stopped.</source>
        <translation>声音服务器已结束。</translation>
    </message>
    <message>
        <source>The sound card is gone.</source>
        <translation>声卡已消失。</translation>
    </message>
    <message>
        <source>The sound server changed its sample rate.</source>
        <translation>声音服务器更改了采样率。</translation>
    </message>
    <message>
        <source>The sound server changed its period.</source>
        <translation>声音服务器更改了周期。</translation>
    </message>
    <message>
        <source>A tactor was disconnected from its output.</source>
        <translation>有致动器与其输出断开。</translation>
    </message>
    <message>
        <source>Another program began to play on the sound card.</source>
        <translation>另一个程序开始在声卡上播放。</translation>
    </message>
    <message>
        <source>The sound server stopped requesting samples.</source>
        <translation>声音服务器不再请求采样。</translation>
    </message>
</context>
<context>
    <name>SoundFileText</name>
    <message>
        <source>&quot;%1&quot; names no sound card</source>
        <translation>“%1”不是声卡的名称</translation>
    </message>
    <message>
        <source>pipewire, pipewire:NODE, jack, jack:CLIENT or alsa:PCM</source>
        <translation>pipewire、pipewire:NODE、jack、jack:CLIENT 或 alsa:PCM</translation>
    </message>
    <message>
        <source>no such sample rate: %1</source>
        <translation>没有这样的采样率：%1</translation>
    </message>
    <message>
        <source>one of: %1</source>
        <translation>以下之一：%1</translation>
    </message>
    <message>
        <source>%1 is no power of two</source>
        <translation>%1 不是 2 的幂</translation>
    </message>
    <message>
        <source>16, 32, 64, 128, 256, 512, 1024 or 2048</source>
        <translation>16、32、64、128、256、512、1024 或 2048</translation>
    </message>
    <message>
        <source>each tactor needs an output of its own</source>
        <translation>每个致动器都需要自己的输出</translation>
    </message>
    <message>
        <source>six different whole numbers</source>
        <translation>六个不同的整数</translation>
    </message>
    <message>
        <source>%1 carriers for six tactors</source>
        <translation>六个致动器有 %1 个载波</translation>
    </message>
    <message>
        <source>one number, or a list of six</source>
        <translation>一个数，或六个数的列表</translation>
    </message>
    <message>
        <source>the frequency is not clear</source>
        <translation>频率不明确</translation>
    </message>
    <message>
        <source>either carrier_Hz or level_Hz</source>
        <translation>carrier_Hz 或 level_Hz 之一</translation>
    </message>
    <message>
        <source>the levels do not rise</source>
        <translation>各级别不是递增的</translation>
    </message>
    <message>
        <source>five frequencies, the lowest first</source>
        <translation>五个频率，最低的在前</translation>
    </message>
    <message>
        <source>the ramp is too short for the frequency: it would click</source>
        <translation>斜坡对该频率来说过短：会产生咔嗒声</translation>
    </message>
    <message>
        <source>at least %1 ms</source>
        <translation>至少 %1 ms</translation>
    </message>
    <message>
        <source>there is no latency that varies</source>
        <translation>没有可变化的延迟</translation>
    </message>
    <message>
        <source>latency_ms as well</source>
        <translation>同时给出 latency_ms</translation>
    </message>
</context>
<context>
    <name>SoundLatency</name>
    <message>
        <source>only %1 of %2 clicks were heard on %3, whose noise reaches %4 of full scale</source>
        <translation>在 %3 上只听到 %2 次咔嗒声中的 %1 次，其噪声达到满量程的 %4</translation>
    </message>
    <message>
        <source>an accelerometer at tactor 1, or a cable from its output to this input</source>
        <translation>致动器 1 上的加速度计，或从其输出到此输入的电缆</translation>
    </message>
    <message>
        <source>The measurement was ended.</source>
        <translation>测量已中止。</translation>
    </message>
</context>
<context>
    <name>SoundLatencyFile</name>
    <message>
        <source>The latency cannot be written into %1.</source>
        <translation>无法把延迟写入 %1。</translation>
    </message>
    <message>
        <source>these lines in the file, written by hand:
%1</source>
        <translation>请手动在文件中写入以下各行：
%1</translation>
    </message>
</context>
<context>
    <name>SourceText</name>
    <message>
        <source>these are data of different modes: %1 and %2</source>
        <translation>这些数据属于不同模式：%1 和 %2</translation>
    </message>
    <message>
        <source>%1 cannot be &quot;%2&quot;</source>
        <translation>%1 不能为“%2”</translation>
    </message>
    <message>
        <source>run, pilot or simulated</source>
        <translation>run、pilot 或 simulated</translation>
    </message>
    <message>
        <source>a value</source>
        <translation>一个值</translation>
    </message>
    <message>
        <source>practice or test</source>
        <translation>practice 或 test</translation>
    </message>
    <message>
        <source>correct, incorrect, timeout, aborted or device_error</source>
        <translation>correct、incorrect、timeout、aborted 或 device_error</translation>
    </message>
    <message>
        <source>a number of seconds or NA</source>
        <translation>秒数或 NA</translation>
    </message>
    <message>
        <source>%1 at most</source>
        <translation>至多 %1</translation>
    </message>
    <message>
        <source>each trial once</source>
        <translation>每个试次一次</translation>
    </message>
    <message>
        <source>interrupted</source>
        <translation>已中断</translation>
    </message>
    <message>
        <source>there are too many different patterns</source>
        <translation>不同的图案过多</translation>
    </message>
    <message>
        <source>one mode, or the choice of one</source>
        <translation>同一种模式，或指明采用哪一种</translation>
    </message>
    <message>
        <source>%1 also has trials in %2: these may be two people, or the same trials twice</source>
        <translation>%1 在 %2 中也有试次：可能是两个人，或者是相同试次的两份</translation>
    </message>
    <message>
        <source>each participant in one study only, under a unique name</source>
        <translation>每名被试只在一个研究中，并使用自己的名称</translation>
    </message>
    <message>
        <source>the value implied by stimulus and response</source>
        <translation>与 stimulus 和 response 一致的内容</translation>
    </message>
    <message>
        <source>a whole number of at least 1</source>
        <translation>从 1 开始的整数</translation>
    </message>
    <message>
        <source>trial %1 of session %2 of %3 was already counted</source>
        <translation>%3 的场次 %2 的试次 %1 之前已计入</translation>
    </message>
    <message>
        <source>this text is not UTF-8</source>
        <translation>此文本不是 UTF-8</translation>
    </message>
    <message>
        <source>a file that was saved as UTF-8</source>
        <translation>保存为 UTF-8 的文件</translation>
    </message>
    <message>
        <source>a whole number</source>
        <translation>整数</translation>
    </message>
    <message>
        <source>the columns are separated by semicolons</source>
        <translation>各列以分号分隔</translation>
    </message>
    <message>
        <source>the columns are separated by tabs</source>
        <translation>各列以制表符分隔</translation>
    </message>
    <message>
        <source>commas, and a point in numbers: the trials that are in data/ of the study, or the file saved as CSV with commas</source>
        <translation>以逗号分隔，数字用小数点：研究的 data/ 中的试次，或以逗号保存为 CSV 的文件</translation>
    </message>
    <message>
        <source>the sensor file names no camera and no video</source>
        <translation>传感器文件未指明相机或视频</translation>
    </message>
    <message>
        <source>a key &quot;source&quot;</source>
        <translation>键“source”</translation>
    </message>
    <message>
        <source>it is not the file of one pad</source>
        <translation>它不是单个触觉阵列的文件</translation>
    </message>
    <message>
        <source>an array, or a list with one: taxels or wts</source>
        <translation>一个阵列，或只含一个阵列的列表：taxels 或 wts</translation>
    </message>
</context>
<context>
    <name>SpectrumText</name>
    <message>
        <source>The signal has no rate: its samples come when they please.</source>
        <translation>该信号没有采样率：其样本不定时到来。</translation>
    </message>
    <message>
        <source>There are only %1 samples in a row in view; a spectrum needs %2.</source>
        <translation>可见的连续样本只有 %1 个；频谱需要 %2 个。</translation>
    </message>
</context>
<context>
    <name>StandardStreamText</name>
    <message>
        <source>standard input cannot be read</source>
        <translation>无法读取标准输入</translation>
    </message>
    <message>
        <source>standard input is too large</source>
        <translation>标准输入过大</translation>
    </message>
    <message>
        <source>standard input can be read only once</source>
        <translation>标准输入只能读取一次</translation>
    </message>
    <message>
        <source>standard output can be written only once</source>
        <translation>标准输出只能写入一次</translation>
    </message>
    <message>
        <source>- is given, a folder is expected</source>
        <translation>给出的是 -，应为文件夹</translation>
    </message>
    <message>
        <source>a recording is a database, which is no stream</source>
        <translation>记录是数据库，不是流</translation>
    </message>
    <message>
        <source>a video cannot be read from standard input</source>
        <translation>无法从标准输入读取视频</translation>
    </message>
    <message>
        <source>the document and a file would both go to standard output</source>
        <translation>文档和文件会同时写到标准输出</translation>
    </message>
    <message>
        <source>an npz file is an archive, which is no stream</source>
        <translation>npz 文件是压缩包，不是流</translation>
    </message>
</context>
<context>
    <name>StiffnessText</name>
    <message>
        <source>the log has no samples</source>
        <translation>日志中没有样本</translation>
    </message>
    <message>
        <source>a row for each sample of the touch</source>
        <translation>触碰的每个样本一行</translation>
    </message>
    <message>
        <source>one half of the torque window has no sample; the largest torque is %1 Nm</source>
        <translation>力矩窗口的一半中没有样本；最大力矩为 %1 Nm</translation>
    </message>
    <message>
        <source>samples near %1 Nm and near %2 Nm</source>
        <translation>在 %1 Nm 附近和 %2 Nm 附近的样本</translation>
    </message>
    <message>
        <source>no sample reaches the torque window; the largest torque is %1 Nm</source>
        <translation>没有样本达到力矩窗口；最大力矩为 %1 Nm</translation>
    </message>
    <message>
        <source>torques from %1 to %2 Nm</source>
        <translation>%1 至 %2 Nm 的力矩</translation>
    </message>
    <message>
        <source>fewer than 20 independent samples lie in the torque window</source>
        <translation>力矩窗口内的独立样本少于 20 个</translation>
    </message>
    <message>
        <source>a slower touch or quicker sampling from %1 to %2 Nm; --method two-point needs two samples</source>
        <translation>在 %1 至 %2 Nm 间放慢触碰或加快采样；--method two-point 只需两个样本</translation>
    </message>
    <message>
        <source>the torque does not change within the window</source>
        <translation>力矩在窗口内没有变化</translation>
    </message>
    <message>
        <source>torque that rises from %1 to %2 Nm</source>
        <translation>从 %1 升至 %2 Nm 的力矩</translation>
    </message>
    <message>
        <source>the joint turns against the rising torque</source>
        <translation>关节逆着上升的力矩转动</translation>
    </message>
    <message>
        <source>angle and torque that rise together; the sign of one column may be turned</source>
        <translation>同时上升的角度和力矩；可能有一列的符号相反</translation>
    </message>
    <message>
        <source>the torque rises so quickly that the arm&apos;s inertia is part of it</source>
        <translation>力矩上升过快，其中包含了机械臂的惯性</translation>
    </message>
    <message>
        <source>a slower touch</source>
        <translation>更慢的触碰</translation>
    </message>
    <message>
        <source>the numbers are too large or too small to compute with</source>
        <translation>数值过大或过小，无法计算</translation>
    </message>
    <message>
        <source>SI units</source>
        <translation>SI 单位</translation>
    </message>
    <message>
        <source>sponge</source>
        <translation>海绵</translation>
    </message>
    <message>
        <source>rubber sponge</source>
        <translation>橡胶海绵</translation>
    </message>
    <message>
        <source>rubber</source>
        <translation>橡胶</translation>
    </message>
    <message>
        <source>wood</source>
        <translation>木材</translation>
    </message>
    <message>
        <source>metal</source>
        <translation>金属</translation>
    </message>
    <message>
        <source>at least %1 N/m (95 %)</source>
        <translation>至少 %1 N/m (95 %)</translation>
    </message>
    <message>
        <source>%1 N/m (uncertainty not available)</source>
        <translation>%1 N/m（不确定度不可用）</translation>
    </message>
    <message>
        <source>%1 N/m (95 %: %2 to %3)</source>
        <translation>%1 N/m（95 %：%2 至 %3）</translation>
    </message>
    <message>
        <source>the noise of neighbouring samples is not independent</source>
        <translation>相邻样本的噪声不独立</translation>
    </message>
    <message>
        <source>one step of the torque reading is over a tenth of the window</source>
        <translation>力矩读数的一个步长超过窗口的十分之一</translation>
    </message>
    <message>
        <source>one step of the angle reading is over a tenth of the rotation</source>
        <translation>角度读数的一个步长超过转角的十分之一</translation>
    </message>
    <message>
        <source>the free joint has a torque; it was taken off</source>
        <translation>自由关节存在力矩，已扣除</translation>
    </message>
    <message>
        <source>the torque of the free joint changes; the change was taken off</source>
        <translation>自由关节的力矩有变化，该变化已扣除</translation>
    </message>
    <message>
        <source>the stiffness changes within the window</source>
        <translation>刚度在窗口内发生变化</translation>
    </message>
    <message>
        <source>the force depends on how quickly the object is pressed</source>
        <translation>力取决于按压物体的快慢</translation>
    </message>
    <message>
        <source>the free joint has another torque than --torque-reference says</source>
        <translation>自由关节的力矩与 --torque-reference 的值不同</translation>
    </message>
    <message>
        <source>cannot tell</source>
        <translation>无法判断</translation>
    </message>
    <message>
        <source>%1, safe to touch, level %2 of 5</source>
        <translation>%1，可安全触碰，等级 %2（共 5 级）</translation>
    </message>
    <message>
        <source>%1, danger, level %2 of 5</source>
        <translation>%1，危险，等级 %2（共 5 级）</translation>
    </message>
    <message>
        <source>two-point</source>
        <translation>两点法</translation>
    </message>
    <message>
        <source>regression</source>
        <translation>回归法</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>方法</translation>
    </message>
    <message>
        <source>Samples</source>
        <translation>样本</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>转角</translation>
    </message>
    <message>
        <source>%1 rad</source>
        <translation>%1 rad</translation>
    </message>
    <message>
        <source>Torque rise</source>
        <translation>力矩上升</translation>
    </message>
    <message>
        <source>%1 Nm</source>
        <translation>%1 Nm</translation>
    </message>
    <message>
        <source>Total stiffness</source>
        <translation>总刚度</translation>
    </message>
    <message>
        <source>Object stiffness</source>
        <translation>物体刚度</translation>
    </message>
    <message>
        <source>Secant, tangent</source>
        <translation>割线、切线</translation>
    </message>
    <message>
        <source>%1 N/m, %2 N/m at the upper end</source>
        <translation>%1 N/m，上端为 %2 N/m</translation>
    </message>
    <message>
        <source>Static stiffness</source>
        <translation>静态刚度</translation>
    </message>
    <message>
        <source>Quick over static</source>
        <translation>快速与静态之比</translation>
    </message>
    <message>
        <source>1 + %1 (95 %: %2 to %3)</source>
        <translation>1 + %1（95 %：%2 至 %3）</translation>
    </message>
    <message>
        <source>Relaxation</source>
        <translation>松弛时间</translation>
    </message>
    <message>
        <source>%1 s (95 %: %2 to %3)</source>
        <translation>%1 s（95 %：%2 至 %3）</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>材料</translation>
    </message>
    <message>
        <source>Reliable</source>
        <translation>可靠</translation>
    </message>
    <message>
        <source>no</source>
        <translation>否</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>警告</translation>
    </message>
    <message>
        <source>CSV with the columns time_s,joint_angle_rad,joint_torque_nm</source>
        <translation>CSV，含列 time_s,joint_angle_rad,joint_torque_nm</translation>
    </message>
    <message>
        <source>Distance of the contact from the joint&apos;s axis along the link, m</source>
        <translation>接触点沿连杆到关节轴的距离，m</translation>
    </message>
    <message>
        <source>Standard error of the contact distance, m; it enters twice. Default: 0.05 % of the distance</source>
        <translation>接触距离的标准误差（m），计入两次。默认：距离的 0.05 %</translation>
    </message>
    <message>
        <source>Half the thickness of the link, m; it cancels out of the stiffness</source>
        <translation>连杆厚度的一半，m；在刚度中相互抵消</translation>
    </message>
    <message>
        <source>The link&apos;s own stiffness, N/m</source>
        <translation>连杆自身的刚度，N/m</translation>
    </message>
    <message>
        <source>Standard error of that stiffness, N/m</source>
        <translation>该刚度的标准误差（N/m）</translation>
    </message>
    <message>
        <source>Torque of the joint without the touch, Nm; start: that of the free motion before the touch, or 0 when there is none</source>
        <translation>没有触碰时关节的力矩（Nm）；start：触碰前自由运动的力矩，没有则为 0</translation>
    </message>
    <message>
        <source>two-point: the samples nearest to both borders of the window; regression: all samples in it</source>
        <translation>two-point：最接近窗口两端的样本；regression：窗口内的所有样本</translation>
    </message>
    <message>
        <source>Torques between which the touch is evaluated, Nm</source>
        <translation>用于评估触碰的力矩范围，Nm</translation>
    </message>
    <message>
        <source>0 or more is expected</source>
        <translation>应为 0 或更大</translation>
    </message>
    <message>
        <source>a lower border of 0 or more and a higher upper one are expected</source>
        <translation>应为 0 或更大的下限和更高的上限</translation>
    </message>
    <message>
        <source>a torque in Nm or start is expected</source>
        <translation>应为以 Nm 为单位的力矩或 start</translation>
    </message>
    <message>
        <source>the touch is stiffer than the link allows: check contact distance and link stiffness</source>
        <translation>触碰的刚度超出连杆允许的范围：请检查接触距离和连杆刚度</translation>
    </message>
    <message>
        <source>Stiffness and material of an object from joint angle and torque during a touch</source>
        <translation>由触碰期间的关节角和力矩求物体的刚度和材料</translation>
    </message>
    <message>
        <source>the torque jumps or falls back, or the joint has play</source>
        <translation>力矩跳变或回落，或关节有间隙</translation>
    </message>
</context>
<context>
    <name>StimulusText</name>
    <message>
        <source>STOP was pressed</source>
        <translation>按下了 STOP</translation>
    </message>
    <message>
        <source>the bracelet was lost</source>
        <translation>手环已断开</translation>
    </message>
    <message>
        <source>the pattern could not be played: %1</source>
        <translation>无法播放图案：%1</translation>
    </message>
    <message>
        <source>something else stopped the bracelet</source>
        <translation>其他任务停止了手环</translation>
    </message>
    <message>
        <source>the bracelet is too hot</source>
        <translation>手环过热</translation>
    </message>
    <message>
        <source>%1, ready</source>
        <comment>bracelet</comment>
        <translation>%1，就绪</translation>
    </message>
    <message>
        <source>%1, ready; last stimulus: %2 frames, longest write %3 ms, %4 late, %5 lost</source>
        <comment>bracelet</comment>
        <translation>%1，就绪；上一个刺激：%2 帧，最长写入 %3 ms，%4 帧延迟，%5 帧丢失</translation>
    </message>
    <message>
        <source>the bracelet does not answer</source>
        <translation>手环没有响应</translation>
    </message>
    <message>
        <source>something else used the bracelet</source>
        <translation>手环被其他任务占用</translation>
    </message>
    <message>
        <source>playback stalled for too long</source>
        <translation>播放停顿时间过长</translation>
    </message>
    <message>
        <source>the bracelet did not start</source>
        <translation>手环没有开始</translation>
    </message>
    <message>
        <source>the bracelet rejected the stimulus</source>
        <translation>手环拒绝了刺激：无法识别</translation>
    </message>
    <message>
        <source>the bracelet did not confirm the stimulus</source>
        <translation>手环没有确认收到刺激</translation>
    </message>
    <message>
        <source>No bracelet: this rehearsal is too fast to be played</source>
        <translation>没有手环：此次预演速度过快，无法播放</translation>
    </message>
    <message>
        <source>the folder of this pattern is unknown</source>
        <translation>无法得知该图案在哪个文件夹中</translation>
    </message>
    <message>
        <source>the full path of the file</source>
        <translation>文件的完整路径</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be moved to other tactors</source>
        <translation>“%1”无法移到其他振子上</translation>
    </message>
    <message>
        <source>a stimulus without rings and strokes, or a track without tactors</source>
        <translation>不含环绕和笔画的刺激，或不含振子的序列</translation>
    </message>
    <message>
        <source>the stimulus does not use tactor %1</source>
        <translation>该刺激不使用振子 %1</translation>
    </message>
    <message>
        <source>a stimulus of one tactor, or of as many as the track names</source>
        <translation>使用一个振子的刺激，或振子数与序列所列相同的刺激</translation>
    </message>
    <message numerus="yes">
        <source>%n object(s) of the stimulus have %1</source>
        <translation>
            <numerusform>刺激中有 %n 个对象具有 %1</numerusform>
        </translation>
    </message>
    <message>
        <source>exactly one</source>
        <translation>恰好一个</translation>
    </message>
    <message>
        <source>the stimulus takes %1 s at level %2</source>
        <translation>该刺激在水平 %2 下用时 %1 s</translation>
    </message>
    <message>
        <source>at most stimulus_s, %1 s</source>
        <translation>至多 stimulus_s，%1 s</translation>
    </message>
</context>
<context>
    <name>StopMemoryText</name>
    <message>
        <source>this does not tell who engages STOP</source>
        <translation>其中没有说明由谁触发 STOP</translation>
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
        <translation>%1，进程 %2</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot name a participant</source>
        <translation>“%1”不能作为被试的名称</translation>
    </message>
    <message>
        <source>another name</source>
        <translation>另一个名称</translation>
    </message>
    <message>
        <source>to try again</source>
        <translation>重试</translation>
    </message>
    <message>
        <source>one session of a participant at a time</source>
        <translation>一名被试同一时间只进行一个场次</translation>
    </message>
    <message>
        <source>another station</source>
        <translation>另一个工作站</translation>
    </message>
    <message>
        <source>version %1 of the program, or a new study</source>
        <translation>%1 版程序，或新的研究</translation>
    </message>
    <message>
        <source>a study of this name already exists</source>
        <translation>已存在同名的研究</translation>
    </message>
    <message>
        <source>a new name, or to continue the study</source>
        <translation>新名称，或继续该研究</translation>
    </message>
    <message>
        <source>this folder already contains a study</source>
        <translation>此文件夹中已有研究</translation>
    </message>
    <message>
        <source>a new folder, or to continue the study</source>
        <translation>新的文件夹，或继续该研究</translation>
    </message>
    <message>
        <source>the study was not created completely</source>
        <translation>该研究从未完整创建</translation>
    </message>
    <message>
        <source>another name: in files, %1 means no value or all participants</source>
        <translation>另一个名称：文件中以 %1 表示无值或全部被试</translation>
    </message>
    <message>
        <source>the participant &quot;%1&quot; is already enrolled</source>
        <translation>被试“%1”已登记</translation>
    </message>
    <message>
        <source>other stations keep enrolling participants</source>
        <translation>其他工作站一直在登记被试</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is already in a session at %2</source>
        <translation>“%1”已在 %2 进行一个场次</translation>
    </message>
    <message>
        <source>the patterns have changed since this study was created</source>
        <translation>图案不是本研究开始时所用的图案</translation>
    </message>
    <message>
        <source>a text of 1 to %1 characters that does not begin with = + - or @</source>
        <translation>1 到 %1 个字符且不以 = + - 或 @ 开头的文本</translation>
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
        <translation>方向</translation>
    </message>
    <message>
        <source>Spread</source>
        <comment>standard deviations of the touched area along its principal axes</comment>
        <translation>展宽</translation>
    </message>
    <message>
        <source>Edge ratio</source>
        <comment>ratio of the eigenvalues of the touched area</comment>
        <translation>边缘比</translation>
    </message>
    <message>
        <source>Active taxels</source>
        <translation>活动触觉单元</translation>
    </message>
    <message>
        <source>force</source>
        <translation>力</translation>
    </message>
    <message>
        <source>threshold</source>
        <comment>of one taxel</comment>
        <translation>阈值</translation>
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
        <translation>活动</translation>
    </message>
    <message>
        <source>moment</source>
        <translation>力矩</translation>
    </message>
    <message>
        <source>shear / load</source>
        <translation>剪切 / 载荷</translation>
    </message>
    <message>
        <source>Shear</source>
        <translation>剪切</translation>
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
        <translation>方案</translation>
    </message>
    <message>
        <source>no protocol is open</source>
        <translation>未打开方案</translation>
    </message>
    <message>
        <source>the protocol has no trials</source>
        <translation>方案中没有试次</translation>
    </message>
    <message>
        <source>Give practice or test at least one repetition.</source>
        <translation>为练习或测试设置至少一次重复。</translation>
    </message>
    <message>
        <source>Participant</source>
        <translation>被试</translation>
    </message>
    <message>
        <source>Choose a participant, or add a new one.</source>
        <translation>选择被试，或添加新被试。</translation>
    </message>
    <message>
        <source>Finish or abort the other session, or choose another participant.</source>
        <translation>完成或中止另一个场次，或选择其他被试。</translation>
    </message>
    <message>
        <source>%1 has finished this session</source>
        <translation>%1 已完成此场次</translation>
    </message>
    <message>
        <source>Choose the next session or another participant.</source>
        <translation>选择下一个场次或其他被试。</translation>
    </message>
    <message>
        <source>Bracelet</source>
        <translation>手环</translation>
    </message>
    <message>
        <source>the bracelet</source>
        <translation>手环</translation>
    </message>
    <message>
        <source>no bracelet is open</source>
        <translation>未打开手环</translation>
    </message>
    <message>
        <source>Plug the bracelet in and choose it in the menu Bracelet.</source>
        <translation>插入手环，并在“手环”菜单中选择它。</translation>
    </message>
    <message>
        <source>%1 does not answer</source>
        <translation>%1 没有应答</translation>
    </message>
    <message>
        <source>STOP is engaged</source>
        <translation>STOP 已触发</translation>
    </message>
    <message>
        <source>Release STOP when it is safe.</source>
        <translation>确认安全后解除 STOP。</translation>
    </message>
    <message>
        <source>%1 is simulated: nobody can feel it</source>
        <translation>%1 是模拟的：没有人能感觉到</translation>
    </message>
    <message>
        <source>Choose a real bracelet, or a pilot or simulated study.</source>
        <translation>选择真实的手环，或选择预试或模拟研究。</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>文件夹</translation>
    </message>
    <message>
        <source>Connect the drive of the study, or choose another folder.</source>
        <translation>连接存放研究的磁盘，或选择其他文件夹。</translation>
    </message>
    <message>
        <source>Allow writing to the folder, or choose another one.</source>
        <translation>允许写入该文件夹，或选择其他文件夹。</translation>
    </message>
    <message>
        <source>Disk space</source>
        <translation>磁盘空间</translation>
    </message>
    <message>
        <source>%1 MB are free</source>
        <translation>剩余 %1 MB</translation>
    </message>
    <message>
        <source>Data store</source>
        <translation>数据存储</translation>
    </message>
    <message>
        <source>ready</source>
        <translation>就绪</translation>
    </message>
    <message>
        <source>Make a copy of the study&apos;s folder and open the study again.</source>
        <translation>复制研究的文件夹，然后重新打开研究。</translation>
    </message>
    <message>
        <source>Masking noise</source>
        <translation>掩蔽噪声</translation>
    </message>
    <message>
        <source>not needed: simulated participants hear nothing</source>
        <translation>不需要：模拟被试听不到声音</translation>
    </message>
    <message>
        <source>the protocol has none</source>
        <translation>方案中没有噪声</translation>
    </message>
    <message>
        <source>the noise is not confirmed</source>
        <translation>噪声未确认</translation>
    </message>
    <message>
        <source>Play the noise, measure its level at the ear, and confirm.</source>
        <translation>播放噪声，在耳边测量其声级，然后确认。</translation>
    </message>
    <message>
        <source>Play the noise, measure %1 dBA at the participant&apos;s ear, and confirm.</source>
        <translation>播放噪声，在被试耳边测得 %1 dBA，然后确认。</translation>
    </message>
    <message>
        <source>confirmed</source>
        <translation>已确认</translation>
    </message>
    <message>
        <source>Stimuli</source>
        <translation>刺激</translation>
    </message>
    <message>
        <source>Correct the protocol at this place and open it again.</source>
        <translation>修正方案的此处，然后重新打开。</translation>
    </message>
    <message>
        <source>Open a protocol, or start with the paper&apos;s.</source>
        <translation>打开一个方案，或从论文的方案开始。</translation>
    </message>
    <message>
        <source>there are no tactile patterns for %1</source>
        <translation>没有图案 %1</translation>
    </message>
    <message>
        <source>Create a study whose protocol names a file for each pattern that is not built in.</source>
        <translation>请用为每个未随程序提供的图案指定了文件的方案建立研究。</translation>
    </message>
    <message>
        <source>the patterns have changed since this study was created</source>
        <translation>图案不是本研究开始时所用的图案</translation>
    </message>
    <message>
        <source>Use version %1 of the program, which created it, or create a new study.</source>
        <translation>请用开始本研究的 %1 版程序继续，或开始新的研究。</translation>
    </message>
    <message>
        <source>unchanged since the study was created</source>
        <translation>研究开始时所用的图案</translation>
    </message>
    <message>
        <source>all there; whether they have changed since the study was created is unknown</source>
        <translation>全部存在；是否与研究开始时所用的相同，不得而知</translation>
    </message>
    <message>
        <source>no participant is selected</source>
        <translation>未选择被试</translation>
    </message>
    <message>
        <source>%1 is already in a session</source>
        <translation>%1 已在进行一个场次</translation>
    </message>
    <message>
        <source>%1 is already in a session at %2</source>
        <translation>%1 已在 %2 进行一个场次</translation>
    </message>
    <message>
        <source>Check cable and power supply; it reconnects by itself.</source>
        <translation>检查电缆和电源；恢复后会自动继续。</translation>
    </message>
    <message>
        <source>%1 was not found</source>
        <translation>%1 不存在</translation>
    </message>
    <message>
        <source>cannot write to %1: %2</source>
        <translation>无法写入 %1：%2</translation>
    </message>
    <message>
        <source>Free up space to at least %1 MB, or choose another folder.</source>
        <translation>释放空间至 %1 MB，或选择其他文件夹。</translation>
    </message>
    <message>
        <source>Start the server or repair the network connection, then try again.</source>
        <translation>启动服务器或修复网络，然后重试。</translation>
    </message>
    <message>
        <source>a motor takes %1 s to stop, and the gap between the intervals of %2 is %3 s</source>
        <translation>电机停止需要 %1 s，而 %2 的区间之间的间隔为 %3 s</translation>
    </message>
    <message>
        <source>Create a study with a longer gap (gap_s).</source>
        <translation>请创建间隔 (gap_s) 更长的研究。</translation>
    </message>
    <message>
        <source>the line is being opened</source>
        <translation>正在打开串口</translation>
    </message>
    <message>
        <source>Wait a moment.</source>
        <translation>请稍候。</translation>
    </message>
    <message>
        <source>the line cannot be used</source>
        <translation>无法使用该串口</translation>
    </message>
    <message>
        <source>Plug the device in and switch it on; it is tried again every second.</source>
        <translation>请插入设备并打开其电源；每秒重试一次。</translation>
    </message>
    <message>
        <source>Trigger</source>
        <translation>触发信号</translation>
    </message>
    <message>
        <source>the desktop keeps it on</source>
        <translation>桌面使其保持开启</translation>
    </message>
    <message>
        <source>the desktop may turn it off during the session</source>
        <translation>桌面可能在场次期间将其关闭</translation>
    </message>
    <message>
        <source>Turn off the screen saver and energy saving of the desktop for the session.</source>
        <translation>请在场次期间关闭桌面的屏幕保护程序和节能功能。</translation>
    </message>
    <message>
        <source>Screen</source>
        <translation>屏幕</translation>
    </message>
</context>
<context>
    <name>StudyCommand</name>
    <message>
        <source>%1 % correct (95 %: %2 to %3, %4 participants)</source>
        <translation>正确率 %1 %（95 %：%2 至 %3，%4 名被试）</translation>
    </message>
    <message>
        <source>%1 % correct (one participant)</source>
        <translation>正确率 %1 %（一名被试）</translation>
    </message>
    <message>
        <source>F(%1, %2) = %3, p = %4</source>
        <translation>F(%1, %2) = %3, p = %4</translation>
    </message>
    <message>
        <source>Rehearse a user study with simulated participants, and analyse studies</source>
        <translation>用模拟被试预演用户研究，并分析研究</translation>
    </message>
    <message>
        <source>Run simulated participants through a whole study</source>
        <translation>让模拟被试完成整个研究</translation>
    </message>
    <message>
        <source>Seed of all orders and answers</source>
        <translation>所有顺序和回答的种子</translation>
    </message>
    <message>
        <source>Share of the trials in which nothing is answered</source>
        <translation>未回答试次的比例</translation>
    </message>
    <message>
        <source>Folder of the new study</source>
        <translation>新研究的文件夹</translation>
    </message>
    <message>
        <source>Go on with a rehearsal that was interrupted</source>
        <translation>继续中断的预演</translation>
    </message>
    <message>
        <source>Folder of the study</source>
        <translation>研究的文件夹</translation>
    </message>
    <message>
        <source>Confusion matrices, accuracy, information transfer and ANOVA of studies or trial CSVs</source>
        <translation>研究或试次 CSV 的混淆矩阵、正确率、信息传输量和方差分析</translation>
    </message>
    <message>
        <source>Folders of studies, or CSVs with participant_id,task,condition,phase,stimulus,response</source>
        <translation>研究的文件夹，或含 participant_id,task,condition,phase,stimulus,response 的 CSV</translation>
    </message>
    <message>
        <source>Only data of this mode; different modes are not merged</source>
        <translation>只用此模式的数据；不同模式不合并</translation>
    </message>
    <message>
        <source>Write the trials of a study as files into its folder</source>
        <translation>将研究的试次写为其文件夹中的文件</translation>
    </message>
    <message>
        <source>psychds: data/; bids: bids/; excel: excel/, with semicolons and the decimal sign of the locale</source>
        <translation>psychds：data/；bids：bids/；excel：excel/，使用分号和本地小数点符号</translation>
    </message>
    <message>
        <source>Study</source>
        <translation>研究</translation>
    </message>
    <message>
        <source>Protocol</source>
        <translation>方案</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>种子</translation>
    </message>
    <message>
        <source>Simulated participants</source>
        <translation>模拟被试</translation>
    </message>
    <message>
        <source>Trials</source>
        <translation>试次</translation>
    </message>
    <message>
        <source>Of them kept before</source>
        <translation>其中先前已保存</translation>
    </message>
    <message>
        <source>this is named twice</source>
        <translation>此项指定了两次</translation>
    </message>
    <message>
        <source>each study and each file once</source>
        <translation>每个研究和每个文件一次</translation>
    </message>
    <message>
        <source>there are no completed trials</source>
        <translation>没有已完成的试次</translation>
    </message>
    <message>
        <source>trials that were answered or timed out</source>
        <translation>已回答或超时的试次</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>格式</translation>
    </message>
    <message>
        <source>Sessions</source>
        <translation>场次</translation>
    </message>
    <message>
        <source>PostgreSQL server that has the study, postgresql://USER@HOST/DATABASE?study=NAME; the password comes from PGPASSWORD or ~/.pgpass. The folder gets the exports</source>
        <translation>存放研究的 PostgreSQL 服务器，postgresql://USER@HOST/DATABASE?study=NAME；密码取自 PGPASSWORD 或 ~/.pgpass。导出文件存入该文件夹</translation>
    </message>
    <message>
        <source>Formats of the figures, separated by commas</source>
        <translation>图的格式，以逗号分隔</translation>
    </message>
    <message>
        <source>Write pink noise that can be played in a loop</source>
        <translation>写出可循环播放的粉红噪声</translation>
    </message>
    <message>
        <source>The sound file</source>
        <translation>声音文件</translation>
    </message>
    <message>
        <source>Root mean square against full scale, dB; how loud it is at the ear has to be measured</source>
        <translation>相对满量程的均方根值，dB；耳边的实际响度须另行测量</translation>
    </message>
    <message>
        <source>Seed of the noise</source>
        <translation>噪声的种子</translation>
    </message>
    <message>
        <source>there is nothing to analyze</source>
        <translation>没有可分析的内容</translation>
    </message>
    <message>
        <source>folders of studies, trial CSVs, or a server (--store)</source>
        <translation>研究的文件夹、试次 CSV 或服务器 (--store)</translation>
    </message>
    <message>
        <source>Results of the study</source>
        <translation>研究结果</translation>
    </message>
    <message>
        <source>File</source>
        <translation>文件</translation>
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
        <translation>电平</translation>
    </message>
    <message>
        <source>%1 dBFS</source>
        <translation>%1 dBFS</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>报告</translation>
    </message>
    <message>
        <source>Tables and figures</source>
        <translation>表格和图</translation>
    </message>
    <message>
        <source>Number of participants</source>
        <translation>参与人数</translation>
    </message>
    <message>
        <source>%1 bit measured</source>
        <translation>实测 %1 bit</translation>
    </message>
    <message>
        <source>%1 bit without bias (95 %: %2 to %3)</source>
        <translation>%1 bit，去除偏差后（95 %：%2 至 %3）</translation>
    </message>
    <message>
        <source>%1 bit without bias (95 %: at least %2)</source>
        <translation>%1 bit，去除偏差后（95 %：至少 %2）</translation>
    </message>
    <message>
        <source>%1 bit without bias (95 %: at most %2)</source>
        <translation>%1 bit，去除偏差后（95 %：至多 %2）</translation>
    </message>
    <message>
        <source>%1 of %2 trials left out</source>
        <translation>略去 %1 个试次，共 %2 个</translation>
    </message>
    <message>
        <source>%1; rule made after the data</source>
        <translation>%1；规则在取得数据之后制定</translation>
    </message>
    <message>
        <source>%1; no spread of the times, so nothing was left out, in %2 case(s)</source>
        <translation>%1；有 %2 种情形的时间没有离散，因此未略去任何试次</translation>
    </message>
    <message>
        <source>%1, Holm over the patterns %2</source>
        <comment>F and p</comment>
        <translation>%1，在各图案上的 Holm %2</translation>
    </message>
    <message>
        <source>Thresholds, slopes and d&apos; of tasks with levels, by maximum likelihood</source>
        <translation>带水平的任务的阈值、斜率和 d&apos;，采用最大似然法</translation>
    </message>
    <message>
        <source>Write one participant&apos;s results as a page</source>
        <translation>将一名被试的结果写为一个页面</translation>
    </message>
    <message>
        <source>What the columns of all files of studies mean</source>
        <translation>研究的所有文件中各列的含义</translation>
    </message>
    <message>
        <source>Send one trial&apos;s triggers to another recorder</source>
        <translation>向另一台记录设备发送一个试次的触发信号</translation>
    </message>
    <message>
        <source>How many participants a test needs: power by simulated studies</source>
        <translation>检验需要多少被试：通过模拟研究求检验效能</translation>
    </message>
    <message>
        <source>Protocol of the study, or the name of one that comes with the program: tactor-detection, intensity-steps, equal-strength, two-or-one, motion-timing; otherwise the paper&apos;s</source>
        <translation>研究的方案，或程序自带方案的名称：tactor-detection、intensity-steps、equal-strength、two-or-one、motion-timing；默认为论文的方案</translation>
    </message>
    <message>
        <source>Simulated participants in tasks with levels: threshold t and slope of their psychometric function, lapse rate, and sd of the threshold between them, in the scale of the levels</source>
        <translation>带水平的任务中的模拟被试：其心理测量函数的阈值 t 和 slope（斜率）、lapse（失误率），以及被试间阈值的 sd（标准差），采用水平的尺度</translation>
    </message>
    <message>
        <source>Rule of what does not count, besides those of the protocol; marked as made after the data, for example response_time_below_s=0.2</source>
        <translation>除方案中的规则外，哪些数据不计入的规则；会标为在取得数据之后制定，例如 response_time_below_s=0.2</translation>
    </message>
    <message>
        <source>Folder for report.html, confusion_long.csv, summary.csv, group.csv, anova.csv, thresholds.csv, levels.csv, sdt.csv, comparisons.csv, ranks.csv, binomial_model.csv, response_times.csv, exclusions.csv, figures</source>
        <translation>存放 report.html、confusion_long.csv、summary.csv、group.csv、anova.csv、thresholds.csv、levels.csv、sdt.csv、comparisons.csv、ranks.csv、binomial_model.csv、response_times.csv、exclusions.csv 和图的文件夹</translation>
    </message>
    <message>
        <source>the exclusion rules leave no completed trial</source>
        <translation>应用排除规则后没有剩下已完成的试次</translation>
    </message>
    <message>
        <source>rules that leave some</source>
        <translation>能留下一些试次的规则</translation>
    </message>
    <message>
        <source>there are no test trials, only practice: the report has no results</source>
        <translation>没有测试试次，只有练习：报告中没有结果</translation>
    </message>
    <message>
        <source>the answer &quot;%1&quot; counts as wrong: the pattern is &quot;%2&quot;</source>
        <translation>回答“%1”计为错误：图案为“%2”</translation>
    </message>
    <message>
        <source>--exclude cannot be applied to this file</source>
        <translation>--exclude 无法应用于此文件</translation>
    </message>
    <message>
        <source>the columns stimulus and response</source>
        <translation>列 stimulus 和 response</translation>
    </message>
    <message>
        <source>List the participants of a study, and who was deleted</source>
        <translation>列出研究的被试以及已删除的被试</translation>
    </message>
    <message>
        <source>Enrol a participant under a pseudonym</source>
        <translation>以假名登记被试</translation>
    </message>
    <message>
        <source>Delete a participant with everything that was kept</source>
        <translation>删除被试及其保存的一切数据</translation>
    </message>
    <message>
        <source>Let others read what is written, as the umask allows; otherwise it is for you alone</source>
        <translation>按 umask 允许他人读取写出的内容；否则只有您自己可读</translation>
    </message>
</context>
<context>
    <name>StudyExport</name>
    <message>
        <source>the study has no participant &quot;%1&quot;</source>
        <translation>研究中没有被试“%1”</translation>
    </message>
    <message>
        <source>the file differs from what was written</source>
        <translation>文件内容与写入的不符</translation>
    </message>
    <message>
        <source>cannot remove the file: %1</source>
        <translation>无法删除文件：%1</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is in a session at %2</source>
        <translation>“%1”正在 %2 上进行场次</translation>
    </message>
    <message>
        <source>a participant who is in no session</source>
        <translation>不在场次中的被试</translation>
    </message>
    <message>
        <source>the file cannot be opened to others: %1</source>
        <translation>无法将文件开放给他人：%1</translation>
    </message>
</context>
<context>
    <name>StudyFigure</name>
    <message>
        <source>PILOT</source>
        <translation>预试</translation>
    </message>
    <message>
        <source>SIMULATED</source>
        <translation>模拟</translation>
    </message>
</context>
<context>
    <name>StudyFitCommand</name>
    <message>
        <source>; the curve does not fit: p of the deviance %1</source>
        <translation>；曲线不符合数据：偏差的 p 值为 %1</translation>
    </message>
    <message>
        <source>Mean of %1</source>
        <translation>%1 的平均值</translation>
    </message>
    <message>
        <source>%1 (%2 to %3)</source>
        <translation>%1（%2 至 %3）</translation>
    </message>
    <message>
        <source>no d&apos;: trials of one kind are missing</source>
        <translation>没有 d&apos;：缺少其中一类试次</translation>
    </message>
    <message>
        <source>d&apos; %1, c %2</source>
        <translation>d&apos; %1，c %2</translation>
    </message>
    <message>
        <source>d&apos; %1</source>
        <translation>d&apos; %1</translation>
    </message>
    <message>
        <source>Folder of a study, or a CSV with participant_id,task,condition,phase,track,level,correct</source>
        <translation>研究的文件夹，或含 participant_id,task,condition,phase,track,level,correct 的 CSV</translation>
    </message>
    <message>
        <source>PostgreSQL server that has the study, postgresql://USER@HOST/DATABASE?study=NAME</source>
        <translation>存放研究的 PostgreSQL 服务器，postgresql://USER@HOST/DATABASE?study=NAME</translation>
    </message>
    <message>
        <source>Function that is fitted; otherwise weibull for detection on a logarithmic scale, else gauss</source>
        <translation>要拟合的函数；默认对数尺度上的检测用 weibull，其余用 gauss</translation>
    </message>
    <message>
        <source>Share of right answers without a stimulus; otherwise from the design</source>
        <translation>没有刺激时正确回答的比例；默认由设计得出</translation>
    </message>
    <message>
        <source>Share of mistakes with any stimulus: fixed, or the range in which it is free; otherwise 0:0.06</source>
        <translation>无论刺激如何都会出错的比例：固定值，或其自由取值的范围；默认为 0:0.06</translation>
    </message>
    <message>
        <source>How the interval of a threshold is computed</source>
        <translation>阈值区间的计算方法</translation>
    </message>
    <message>
        <source>Folder for thresholds.csv, levels.csv, sdt.csv, analysis.R and figures</source>
        <translation>存放 thresholds.csv、levels.csv、sdt.csv、analysis.R 和图的文件夹</translation>
    </message>
    <message>
        <source>--lapse cannot be &quot;%1&quot;</source>
        <translation>--lapse 不能为“%1”</translation>
    </message>
    <message>
        <source>a share from 0 to 0.4, or two with a colon between them, the lower one first</source>
        <translation>0 至 0.4 的比例，或以冒号分隔的两个比例，较小者在前</translation>
    </message>
    <message>
        <source>there are no test trials with a level</source>
        <translation>没有带水平的测试试次</translation>
    </message>
    <message>
        <source>trials of a design with levels, or a column level</source>
        <translation>带水平的设计的试次，或列 level</translation>
    </message>
    <message>
        <source>nothing says how often guessing is right in task %1</source>
        <translation>没有说明任务 %1 中猜对的比例</translation>
    </message>
    <message>
        <source>--guess (0.5 for two intervals, 0.02 for yes and no), or a column design or n_alternatives</source>
        <translation>--guess（两个区间为 0.5，是/否为 0.02），或列 design 或 n_alternatives</translation>
    </message>
    <message>
        <source>Tables and figures</source>
        <translation>表格和图</translation>
    </message>
    <message>
        <source>One fit of %1</source>
        <translation>%1 的共同拟合</translation>
    </message>
    <message>
        <source>%1, sd of the participants %2</source>
        <translation>%1，被试的标准差 %2</translation>
    </message>
    <message>
        <source>%1 steps of intensity from start to full</source>
        <translation>从启动到满驱动共 %1 级强度</translation>
    </message>
    <message>
        <source>most yes at %1 s (%2 to %3)</source>
        <translation>在 %1 s 时回答“是”最多（%2 至 %3）</translation>
    </message>
</context>
<context>
    <name>StudyNames</name>
    <message>
        <source>Object shape</source>
        <translation>物体形状</translation>
    </message>
    <message>
        <source>circle</source>
        <translation>圆</translation>
    </message>
    <message>
        <source>rectangle</source>
        <translation>矩形</translation>
    </message>
    <message>
        <source>triangle</source>
        <translation>三角形</translation>
    </message>
    <message>
        <source>arc</source>
        <translation>圆弧</translation>
    </message>
    <message>
        <source>line</source>
        <translation>线</translation>
    </message>
    <message>
        <source>point</source>
        <translation>点</translation>
    </message>
    <message>
        <source>static</source>
        <translation>静态</translation>
    </message>
    <message>
        <source>dynamic</source>
        <translation>动态</translation>
    </message>
    <message>
        <source>Object stiffness</source>
        <translation>物体刚度</translation>
    </message>
    <message>
        <source>sponge</source>
        <translation>海绵</translation>
    </message>
    <message>
        <source>rubber sponge</source>
        <translation>橡胶海绵</translation>
    </message>
    <message>
        <source>rubber</source>
        <translation>橡胶</translation>
    </message>
    <message>
        <source>wood</source>
        <translation>木材</translation>
    </message>
    <message>
        <source>metal</source>
        <translation>金属</translation>
    </message>
    <message>
        <source>Tactor detection</source>
        <translation>振子检测</translation>
    </message>
    <message>
        <source>rest</source>
        <translation>静息</translation>
    </message>
    <message>
        <source>In which interval did you feel a vibration?</source>
        <translation>您在哪个区间感觉到振动？</translation>
    </message>
    <message>
        <source>Intensity steps</source>
        <translation>强度差别</translation>
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
        <translation>强</translation>
    </message>
    <message>
        <source>Which interval was stronger?</source>
        <translation>哪个区间更强？</translation>
    </message>
    <message>
        <source>Equal strength</source>
        <translation>等强度</translation>
    </message>
    <message>
        <source>Two or one</source>
        <translation>两个或一个</translation>
    </message>
    <message>
        <source>Did you feel two separate taps?</source>
        <translation>您是否感觉到两次分开的轻敲？</translation>
    </message>
    <message>
        <source>Motion timing</source>
        <translation>运动时序</translation>
    </message>
    <message>
        <source>Did you feel one moving point?</source>
        <translation>您是否感觉到一个移动的点？</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>是</translation>
    </message>
    <message>
        <source>no</source>
        <translation>否</translation>
    </message>
    <message>
        <source>same</source>
        <translation>相同</translation>
    </message>
    <message>
        <source>different</source>
        <translation>不同</translation>
    </message>
    <message>
        <source>Was there a vibration?</source>
        <translation>是否有振动？</translation>
    </message>
    <message>
        <source>Which interval had the vibration?</source>
        <translation>哪个区间有振动？</translation>
    </message>
    <message>
        <source>Were the two intervals the same?</source>
        <translation>两个区间是否相同？</translation>
    </message>
    <message>
        <source>Which interval had more?</source>
        <translation>哪个区间更强？</translation>
    </message>
    <message>
        <source>drive</source>
        <comment>unit of a level</comment>
        <translation>驱动</translation>
    </message>
    <message>
        <source>balance</source>
        <comment>unit of a level</comment>
        <translation>平衡</translation>
    </message>
</context>
<context>
    <name>StudyNoise</name>
    <message>
        <source>an even number of samples up to %1, and frequencies above 0 up to half the rate</source>
        <translation>至多 %1 的偶数个样本，以及大于 0 且不超过采样率一半的频率</translation>
    </message>
    <message>
        <source>more samples or a wider band</source>
        <translation>更多样本或更宽的频带</translation>
    </message>
    <message>
        <source>the noise would be clipped at this level</source>
        <translation>以此电平噪声会被削顶</translation>
    </message>
    <message>
        <source>a level of %1 dBFS at most</source>
        <translation>至多 %1 dBFS 的电平</translation>
    </message>
    <message>
        <source>the sound is too long for a WAV file</source>
        <translation>声音过长，无法存为 WAV 文件</translation>
    </message>
    <message>
        <source>at most 4 GiB of samples</source>
        <translation>至多 4 GiB 的样本</translation>
    </message>
    <message>
        <source>the noise settings are out of range</source>
        <translation>噪声的这些设置超出范围</translation>
    </message>
    <message>
        <source>the band contains no frequency</source>
        <translation>此频带中没有频率</translation>
    </message>
</context>
<context>
    <name>StudyPapers</name>
    <message>
        <source>Folder of the study</source>
        <translation>研究的文件夹</translation>
    </message>
    <message>
        <source>Whose report it is</source>
        <translation>报告所属的被试</translation>
    </message>
    <message>
        <source>experimenter: everything of this participant; participant: their own answers in plain words</source>
        <translation>experimenter：此被试的全部内容；participant：用通俗的话写出其本人的回答</translation>
    </message>
    <message>
        <source>The page; otherwise report-ID.html or report-ID-participant.html in the folder of the study</source>
        <translation>页面；默认为研究文件夹中的 report-ID.html 或 report-ID-participant.html</translation>
    </message>
    <message>
        <source>PostgreSQL server that has the study, postgresql://USER@HOST/DATABASE?study=NAME; the password comes from PGPASSWORD or ~/.pgpass</source>
        <translation>存放研究的 PostgreSQL 服务器，postgresql://USER@HOST/DATABASE?study=NAME；密码取自 PGPASSWORD 或 ~/.pgpass</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>报告</translation>
    </message>
    <message>
        <source>Folder of a study, whose questionnaires are described too</source>
        <translation>研究的文件夹，其问卷也会一并说明</translation>
    </message>
    <message>
        <source>Where one trial&apos;s events go: a serial port such as /dev/ttyUSB0, or HOST:PORT for OSC by UDP</source>
        <translation>一个试次的事件发往何处：串口，例如 /dev/ttyUSB0；或 HOST:PORT，以 UDP 发送 OSC</translation>
    </message>
    <message>
        <source>written in %1 ms</source>
        <translation>写入用时 %1 ms</translation>
    </message>
</context>
<context>
    <name>StudyPeople</name>
    <message>
        <source>Folder of the study</source>
        <translation>研究的文件夹</translation>
    </message>
    <message>
        <source>PostgreSQL server that has the study, postgresql://USER@HOST/DATABASE?study=NAME</source>
        <translation>存放研究的 PostgreSQL 服务器，postgresql://USER@HOST/DATABASE?study=NAME</translation>
    </message>
    <message>
        <source>Also say who is behind the pseudonyms</source>
        <translation>同时显示假名对应的人</translation>
    </message>
    <message>
        <source>Name of the participant in the study; otherwise a pseudonym at random</source>
        <translation>被试在研究中的名称；否则使用随机假名</translation>
    </message>
    <message>
        <source>File that keeps who is behind the pseudonyms, for you alone; not in the study&apos;s folder</source>
        <translation>保存假名对应关系的文件，仅供您使用；不放在研究文件夹中</translation>
    </message>
    <message>
        <source>Name of the person, for the key</source>
        <translation>写入密钥的姓名</translation>
    </message>
    <message>
        <source>How to reach the person, for the key</source>
        <translation>写入密钥的联系方式</translation>
    </message>
    <message>
        <source>Whom to delete</source>
        <translation>要删除的被试</translation>
    </message>
    <message>
        <source>Delete the person from this key as well</source>
        <translation>同时从该密钥中删除此人</translation>
    </message>
    <message>
        <source>Why, for the record that stays; without anything that tells who it was</source>
        <translation>留存记录中的原因；不要写能看出是谁的内容</translation>
    </message>
    <message>
        <source>Really delete: this cannot be undone</source>
        <translation>确实删除：无法撤销</translation>
    </message>
    <message numerus="yes">
        <source>%n session(s)</source>
        <translation>
            <numerusform>%n 个场次</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n trial(s)</source>
        <translation>
            <numerusform>%n 次试次</numerusform>
        </translation>
    </message>
    <message>
        <source>Deleted</source>
        <translation>已删除</translation>
    </message>
    <message numerus="yes">
        <source>number %1 of the enrolment, on %2, %n trial(s)</source>
        <translation>
            <numerusform>登记号 %1，%2，%n 次试次</numerusform>
        </translation>
    </message>
    <message>
        <source>Nobody is enrolled.</source>
        <translation>没有登记任何人。</translation>
    </message>
    <message>
        <source>the key that keeps it is missing: --key with a file apart from the study</source>
        <translation>缺少用于保存的密钥：--key 加上与研究分开的文件</translation>
    </message>
    <message>
        <source>the name of the person is missing: --name</source>
        <translation>缺少姓名：--name</translation>
    </message>
    <message>
        <source>Participant</source>
        <translation>被试</translation>
    </message>
    <message>
        <source>Number of the enrolment</source>
        <translation>登记号</translation>
    </message>
    <message>
        <source>Removed</source>
        <translation>已移除</translation>
    </message>
    <message>
        <source>Key</source>
        <translation>密钥</translation>
    </message>
    <message>
        <source>the person was deleted</source>
        <translation>已删除此人</translation>
    </message>
    <message>
        <source>has no such person</source>
        <translation>没有此人</translation>
    </message>
    <message>
        <source>Still counts the participant</source>
        <translation>仍包含该被试</translation>
    </message>
    <message>
        <source>Analyze the study again, and delete what was copied elsewhere.</source>
        <translation>请重新分析研究，并删除复制到别处的内容。</translation>
    </message>
    <message>
        <source>it is missing, and all sessions, answers, notes, recordings and exported files of &quot;%1&quot; would be deleted, which cannot be undone</source>
        <translation>缺少该选项；“%1”的全部场次、回答、备注、记录和导出文件都会被删除，且无法撤销</translation>
    </message>
    <message numerus="yes">
        <source>%n file(s)</source>
        <translation>
            <numerusform>%n 个文件</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>StudyPictures</name>
    <message>
        <source>feel</source>
        <translation>感受</translation>
    </message>
    <message>
        <source>answer</source>
        <translation>作答</translation>
    </message>
    <message>
        <source>result</source>
        <translation>结果</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1%</translation>
    </message>
    <message>
        <source>right answers to dynamic shapes</source>
        <translation>动态形状的正确率</translation>
    </message>
</context>
<context>
    <name>StudyPlan</name>
    <message>
        <source>the protocol has no task &quot;%1&quot;</source>
        <translation>方案中没有任务“%1”</translation>
    </message>
    <message>
        <source>TASK:EFFECT with one of %1</source>
        <translation>TASK:EFFECT，其中任务为 %1 之一</translation>
    </message>
    <message>
        <source>the task %1 measures levels</source>
        <translation>任务 %1 测量的是水平</translation>
    </message>
    <message>
        <source>a task in which patterns are told apart</source>
        <translation>区分图案的任务</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no line of the analysis of %2</source>
        <translation>“%1”不是 %2 的分析中的行</translation>
    </message>
    <message>
        <source>condition, pattern, condition:pattern, or condition@PATTERN</source>
        <translation>condition、pattern、condition:pattern 或 condition@PATTERN</translation>
    </message>
    <message>
        <source>pattern</source>
        <translation>pattern</translation>
    </message>
    <message>
        <source>the protocol has no test trials</source>
        <translation>方案中没有测试试次</translation>
    </message>
    <message>
        <source>test.repetitions above 0</source>
        <translation>大于 0 的 test.repetitions</translation>
    </message>
    <message>
        <source>the task %1 has no pattern &quot;%2&quot;</source>
        <translation>任务 %1 没有图案“%2”</translation>
    </message>
    <message>
        <source>one of its letters</source>
        <translation>其字母之一</translation>
    </message>
    <message>
        <source>the truth says nothing of the task %1</source>
        <translation>真值中没有任务 %1</translation>
    </message>
    <message>
        <source>a [[task]] with that id</source>
        <translation>具有该标识的 [[task]]</translation>
    </message>
    <message>
        <source>the truth says nothing of %1 under %2</source>
        <translation>真值中没有 %2 下的 %1</translation>
    </message>
    <message>
        <source>a condition with that id</source>
        <translation>具有该标识的条件</translation>
    </message>
</context>
<context>
    <name>StudyPlanCommand</name>
    <message>
        <source>no number up to %1 reaches %2 %</source>
        <translation>直到 %1 的人数均达不到 %2 %</translation>
    </message>
    <message>
        <source>%1 or %2 participants; %3 studies cannot tell which</source>
        <translation>%1 或 %2 名被试；%3 项研究无法判定是哪一个</translation>
    </message>
    <message>
        <source>%1 participants reach %2 %</source>
        <translation>%1 名被试可达到 %2 %</translation>
    </message>
    <message>
        <source>Protocol of the study</source>
        <translation>研究的方案</translation>
    </message>
    <message>
        <source>Numbers of participants to try: from, to, step</source>
        <translation>要尝试的被试人数：起始、终止、步长</translation>
    </message>
    <message>
        <source>What is assumed: a file with shares of right answers and spreads, or the folder of a pilot study</source>
        <translation>所作的假设：含正确率和离散度的文件，或预试研究的文件夹</translation>
    </message>
    <message>
        <source>Seed of all studies</source>
        <translation>所有研究的种子</translation>
    </message>
    <message>
        <source>Wanted share of significant studies</source>
        <translation>期望的显著研究比例</translation>
    </message>
    <message>
        <source>Table of the power, CSV</source>
        <translation>检验效能表，CSV</translation>
    </message>
    <message>
        <source>%1 is not FROM:TO:STEP with numbers from 1 to %2</source>
        <translation>%1 不是 FROM:TO:STEP，其中的数应为 1 至 %2</translation>
    </message>
    <message>
        <source>Test</source>
        <translation>检验</translation>
    </message>
    <message>
        <source>%1 % (95 %: %2 to %3, %4 studies)</source>
        <translation>%1 %（95 %：%2 至 %3，%4 项研究）</translation>
    </message>
    <message>
        <source>%1; no analysis in %2 of them</source>
        <translation>%1；其中 %2 项无法分析</translation>
    </message>
    <message>
        <source>%1 participants</source>
        <translation>%1 名被试</translation>
    </message>
    <message>
        <source>Answer</source>
        <translation>答案</translation>
    </message>
    <message>
        <source>Table</source>
        <translation>表格</translation>
    </message>
    <message>
        <source>Line of the analysis: shape:condition, shape:pattern, shape:condition:pattern, or shape:condition@A within pattern A; or detect:threshold for the interval of a threshold</source>
        <translation>分析中的行：shape:condition、shape:pattern、shape:condition:pattern，或图案 A 内的 shape:condition@A；或用 detect:threshold 表示阈值的区间</translation>
    </message>
    <message>
        <source>Of a threshold: how far its 95 % interval may reach to each side, on the scale of the levels (0.1 log10 units are a factor of 1.26)</source>
        <translation>针对阈值：其 95 % 区间向每一侧最多可延伸多远，采用水平的尺度（0.1 个 log10 单位相当于 1.26 倍）</translation>
    </message>
    <message>
        <source>Of a threshold: trials of a track, of constant stimuli at each level; otherwise the protocol&apos;s</source>
        <translation>针对阈值：每个序列的试次数，恒定刺激法时为每个水平的试次数；默认采用方案中的数值</translation>
    </message>
    <message>
        <source>Studies drawn for each number; otherwise 10000, for thresholds 1000</source>
        <translation>每个人数抽取的研究数；默认为 10000，阈值时为 1000</translation>
    </message>
</context>
<context>
    <name>StudyProtocol</name>
    <message>
        <source>&quot;%1&quot; means no answer</source>
        <translation>“%1”表示未回答</translation>
    </message>
    <message>
        <source>another letter</source>
        <translation>另一个字母</translation>
    </message>
    <message>
        <source>there are too many patterns</source>
        <translation>图案过多</translation>
    </message>
    <message>
        <source>at most %1, one digit each</source>
        <translation>至多 %1 个，各对应一个数字键</translation>
    </message>
    <message>
        <source>%1 is not one more tactor</source>
        <translation>%1 不是另一个振子</translation>
    </message>
    <message>
        <source>whole numbers from 1 to %1, each once</source>
        <translation>1 至 %1 的整数，每个一次</translation>
    </message>
    <message>
        <source>there are too many tracks</source>
        <translation>序列过多</translation>
    </message>
    <message>
        <source>at most %1</source>
        <translation>至多 %1</translation>
    </message>
    <message>
        <source>%1 is not among the levels</source>
        <translation>%1 不在水平范围内</translation>
    </message>
    <message>
        <source>from lowest to highest, %1 to %2</source>
        <translation>从最低到最高，%1 至 %2</translation>
    </message>
    <message>
        <source>the lowest level is not below the highest</source>
        <translation>最低水平不低于最高水平</translation>
    </message>
    <message>
        <source>a number below %1</source>
        <translation>小于 %1 的数</translation>
    </message>
    <message>
        <source>0 has no place on a scale of logarithms</source>
        <translation>对数尺度上没有 0</translation>
    </message>
    <message>
        <source>a number above 0, or the scale linear</source>
        <translation>大于 0 的数，或将尺度设为 linear</translation>
    </message>
    <message>
        <source>a level of %1 cannot be shown</source>
        <translation>无法呈现水平 %1</translation>
    </message>
    <message>
        <source>there is nothing to compare with</source>
        <translation>没有可比较的对象</translation>
    </message>
    <message>
        <source>a reference above 0, here or in each condition</source>
        <translation>大于 0 的基准，在此处或在每个条件中给出</translation>
    </message>
    <message>
        <source>the levels do not rise</source>
        <translation>水平没有递增</translation>
    </message>
    <message>
        <source>each level above the one before</source>
        <translation>每个水平高于前一个</translation>
    </message>
    <message>
        <source>weibull has no place for a level of 0</source>
        <translation>weibull 不能有为 0 的水平</translation>
    </message>
    <message>
        <source>gauss or logistic, or a lowest level above 0</source>
        <translation>gauss 或 logistic，或大于 0 的最低水平</translation>
    </message>
    <message>
        <source>a prior needs its mean and its standard deviation</source>
        <translation>先验需要其均值和标准差</translation>
    </message>
    <message>
        <source>prior_mean and prior_sd</source>
        <translation>prior_mean 和 prior_sd</translation>
    </message>
    <message>
        <source>too few reversals for an estimate</source>
        <translation>反转次数过少，无法估计</translation>
    </message>
    <message>
        <source>at least %1</source>
        <translation>至少 %1</translation>
    </message>
    <message>
        <source>constant stimuli need their levels</source>
        <translation>恒定刺激需要给出各水平</translation>
    </message>
    <message>
        <source>values in level, 1 to %1 of them</source>
        <translation>level 中的值，1 至 %1 个</translation>
    </message>
    <message>
        <source>answers to this design count from the end of the last interval</source>
        <translation>此设计的回答从最后一个时间区间结束时起计时</translation>
    </message>
    <message>
        <source>response_window = &quot;from_end&quot;</source>
        <translation>response_window = &quot;from_end&quot;</translation>
    </message>
    <message>
        <source>patterns have no reference</source>
        <translation>图案没有参考</translation>
    </message>
    <message>
        <source>conditions without reference</source>
        <translation>不带参考的条件</translation>
    </message>
</context>
<context>
    <name>StudyQuestionnaire</name>
    <message>
        <source>&quot;%1&quot; is not answered</source>
        <translation>“%1”未回答</translation>
    </message>
    <message>
        <source>an answer</source>
        <translation>一个回答</translation>
    </message>
    <message>
        <source>the answer to &quot;%1&quot; is too long</source>
        <translation>“%1”的回答过长</translation>
    </message>
    <message>
        <source>%1 characters at most</source>
        <translation>至多 %1 个字符</translation>
    </message>
    <message>
        <source>a number from 1 to %1</source>
        <translation>1 至 %1 的数</translation>
    </message>
    <message>
        <source>one of the choices</source>
        <translation>选项之一</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be answered with &quot;%2&quot;</source>
        <translation>“%1”不能用“%2”回答</translation>
    </message>
    <message>
        <source>the answers do not match this questionnaire</source>
        <translation>这些回答不属于此问卷</translation>
    </message>
    <message>
        <source>one answer per item, in order</source>
        <translation>每个题目一个回答，按题目顺序</translation>
    </message>
    <message>
        <source>a pair has two choices</source>
        <translation>一对题须有两个选项</translation>
    </message>
    <message>
        <source>two of them</source>
        <translation>两个选项</translation>
    </message>
    <message>
        <source>a number from 0 to 100 in steps of 5</source>
        <translation>0 至 100 的数，步长为 5</translation>
    </message>
</context>
<context>
    <name>StudyRehearsal</name>
    <message>
        <source>this study has real participants</source>
        <translation>此研究有真实的被试</translation>
    </message>
    <message>
        <source>a study created as a rehearsal</source>
        <translation>以预演方式开始的研究</translation>
    </message>
</context>
<context>
    <name>StudyScene</name>
    <message>
        <source>the effect is listed twice</source>
        <translation>该效应列出了两次</translation>
    </message>
    <message>
        <source>each effect at most once</source>
        <translation>每个效应至多一次</translation>
    </message>
</context>
<context>
    <name>StudyScenes</name>
    <message>
        <source>%1, %2</source>
        <comment>task, condition</comment>
        <translation>%1，%2</translation>
    </message>
    <message numerus="yes">
        <source>%1: %n pattern(s); %2</source>
        <comment>task; conditions</comment>
        <translation>
            <numerusform>%1：%n 个图案；%2</numerusform>
        </translation>
    </message>
    <message>
        <source>Stimulus %1 s, answer within %2 s %3</source>
        <comment>numbers; of what</comment>
        <translation>刺激 %1 s，须在%3 %2 s 内回答</translation>
    </message>
    <message>
        <source>of its onset</source>
        <translation>其起始后</translation>
    </message>
    <message>
        <source>of its end</source>
        <translation>其结束后</translation>
    </message>
    <message>
        <source>Pink noise, %1 dBA</source>
        <translation>粉红噪声，%1 dBA</translation>
    </message>
    <message>
        <source>Seed %1</source>
        <translation>种子 %1</translation>
    </message>
    <message>
        <source>running</source>
        <translation>进行中</translation>
    </message>
    <message>
        <source>✓ finished</source>
        <translation>✓ 已完成</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <comment>trials kept</comment>
        <translation>%1 / %2</translation>
    </message>
    <message>
        <source>to do</source>
        <translation>待进行</translation>
    </message>
    <message>
        <source>%1 — %2</source>
        <comment>participant, session</comment>
        <translation>%1 — %2</translation>
    </message>
    <message>
        <source>Session %1 of %2, row %3 of the Williams square</source>
        <translation>第 %1 场次，共 %2 场次，Williams 方阵第 %3 行</translation>
    </message>
    <message>
        <source>Halt the rehearsal</source>
        <translation>暂停预演</translation>
    </message>
    <message>
        <source>This session is finished.</source>
        <translation>此场次已完成。</translation>
    </message>
    <message>
        <source>Show the results</source>
        <translation>显示结果</translation>
    </message>
    <message>
        <source>All sessions of all participants are finished.</source>
        <translation>所有被试的所有场次均已完成。</translation>
    </message>
    <message>
        <source>Add a participant</source>
        <translation>添加被试</translation>
    </message>
    <message>
        <source>Choose another participant</source>
        <translation>选择其他被试</translation>
    </message>
    <message>
        <source>This participant has finished all sessions.</source>
        <translation>此被试已完成所有场次。</translation>
    </message>
    <message>
        <source>The simulated participant fills in “%1”.</source>
        <translation>模拟被试正在填写“%1”。</translation>
    </message>
    <message>
        <source>The participant fills in “%1”.</source>
        <translation>被试正在填写“%1”。</translation>
    </message>
    <message>
        <source>Show the questionnaire</source>
        <translation>显示问卷</translation>
    </message>
    <message>
        <source>Practice</source>
        <translation>练习</translation>
    </message>
    <message>
        <source>Test</source>
        <translation>测试</translation>
    </message>
    <message>
        <source>Go on</source>
        <translation>继续</translation>
    </message>
    <message>
        <source>Paused.</source>
        <translation>已暂停。</translation>
    </message>
    <message>
        <source>Practice is over. In the test there is no feedback unless the protocol says so.</source>
        <translation>练习已结束。除非方案另有规定，测试中没有反馈。</translation>
    </message>
    <message>
        <source>Go on after STOP</source>
        <translation>在 STOP 之后继续</translation>
    </message>
    <message>
        <source>The stimulus was interrupted: %1. The trial will be shown again.</source>
        <translation>刺激被中断：%1。该试次将重新呈现。</translation>
    </message>
    <message>
        <source>Hold the STOP button for a second to release it.</source>
        <translation>按住 STOP 按钮一秒以解除。</translation>
    </message>
    <message>
        <source>Leave this session</source>
        <translation>离开此场次</translation>
    </message>
    <message>
        <source>This session is finished. Thank the participant.</source>
        <translation>此场次已完成。请向被试致谢。</translation>
    </message>
    <message>
        <source>Ready for the next trial.</source>
        <translation>已准备好进行下一个试次。</translation>
    </message>
    <message>
        <source>The right answer is shown.</source>
        <translation>正在显示正确答案。</translation>
    </message>
    <message>
        <source>Waiting for the answer.</source>
        <translation>正在等待回答。</translation>
    </message>
    <message>
        <source>A pause follows.</source>
        <translation>接下来是休息。</translation>
    </message>
    <message>
        <source>%1, test</source>
        <translation>%1，测试</translation>
    </message>
    <message>
        <source>%1, practice</source>
        <translation>%1，练习</translation>
    </message>
    <message>
        <source>End the rest</source>
        <translation>结束休息</translation>
    </message>
    <message>
        <source>Repetitions of each pattern: %1 in practice, %2 in the test; %3 test trials per participant</source>
        <translation>每个图案的重复次数：练习 %1 次，测试 %2 次；每名被试 %3 个测试试次</translation>
    </message>
    <message>
        <source>Resume this session</source>
        <translation>继续此场次</translation>
    </message>
    <message>
        <source>Start this session</source>
        <translation>开始此场次</translation>
    </message>
    <message>
        <source>This session was interrupted after %1 of %2 trials. All answers are saved; it resumes in the same order.</source>
        <translation>此场次在完成 %2 个试次中的 %1 个后中断。已有的回答均已保留；将按相同顺序继续。</translation>
    </message>
    <message>
        <source>The session can start when all checks have passed.</source>
        <translation>所有检查通过后即可开始此场次。</translation>
    </message>
    <message>
        <source>Start the rehearsal</source>
        <translation>开始预演</translation>
    </message>
    <message>
        <source>Resume the rehearsal</source>
        <translation>继续预演</translation>
    </message>
    <message>
        <source>Simulated participants go through all sessions, by the same rules as people.</source>
        <translation>模拟被试完成所有场次，使用与真人相同的代码。</translation>
    </message>
    <message>
        <source>Next session</source>
        <translation>前往下一个场次</translation>
    </message>
    <message>
        <source>Enrol the first participant on the left: the order of enrolment determines the order of the conditions.</source>
        <translation>在左侧登记第一名被试：条件的顺序由登记顺序决定。</translation>
    </message>
    <message>
        <source>It is asked again when a session of this participant starts or resumes.</source>
        <translation>此被试的场次开始或继续时会再次询问。</translation>
    </message>
    <message>
        <source>It is asked again only if this session is interrupted and resumed.</source>
        <translation>仅当此场次中断后继续时才会再次询问。</translation>
    </message>
    <message>
        <source>The session finishes without it, and it is not asked again.</source>
        <translation>场次将在没有它的情况下完成，此后不再询问。</translation>
    </message>
    <message>
        <source>Recording that “%1” is skipped …</source>
        <translation>正在记录“%1”已跳过…</translation>
    </message>
    <message>
        <source>Saving the answers …</source>
        <translation>正在保存回答…</translation>
    </message>
    <message>
        <source>Try again to skip it</source>
        <translation>重试跳过</translation>
    </message>
    <message>
        <source>“%1” could not be skipped, because the note about it could not be saved. %2</source>
        <translation>无法跳过“%1”，因为相关备注无法保存。%2</translation>
    </message>
    <message>
        <source>Try again to save the answers</source>
        <translation>重试保存回答</translation>
    </message>
    <message>
        <source>The answers to “%1” could not be saved; they are still in the participant&apos;s window. %2</source>
        <translation>“%1”的回答无法保存；它们仍在被试窗口中。%2</translation>
    </message>
    <message>
        <source>Rest. The participant may continue in %1 s.</source>
        <translation>休息。被试可在 %1 秒后继续。</translation>
    </message>
    <message>
        <source>Rest. The participant continues with Space.</source>
        <translation>休息。被试按空格键继续。</translation>
    </message>
    <message>
        <source>Start the test</source>
        <translation>开始测试</translation>
    </message>
    <message>
        <source>STOPPED. The bracelet is off. An interrupted trial will be shown again.</source>
        <translation>已停止。手环已关闭。进行中的试次将重新呈现。</translation>
    </message>
    <message>
        <source>Try again to save the last trial</source>
        <translation>重试保存上一个试次</translation>
    </message>
    <message>
        <source>The last trial is waiting for the server. %1</source>
        <translation>上一个试次正在等待服务器。%1</translation>
    </message>
    <message>
        <source>The last trial could not be saved; it is still in memory. %1</source>
        <translation>上一个试次无法保存；它仍在内存中。%1</translation>
    </message>
    <message>
        <source>The session was aborted. All answers are saved.</source>
        <translation>场次已中止。已有的回答均已保留。</translation>
    </message>
    <message>
        <source>Saving the trial …</source>
        <translation>正在保存试次…</translation>
    </message>
    <message>
        <source>The stimulus is starting …</source>
        <translation>刺激即将开始…</translation>
    </message>
    <message>
        <source>The stimulus is playing.</source>
        <translation>正在呈现刺激。</translation>
    </message>
    <message>
        <source>The simulated participant is working</source>
        <translation>模拟被试正在进行</translation>
    </message>
    <message>
        <source>The participant continues with Space</source>
        <translation>由被试按空格键继续</translation>
    </message>
    <message>
        <source>Your answers could not be saved yet. Please tell the experimenter.</source>
        <translation>您的回答尚未能保存。请告知实验人员。</translation>
    </message>
    <message>
        <source>No session is selected</source>
        <translation>未选择场次</translation>
    </message>
    <message numerus="yes">
        <source>%1: %n track(s); %2</source>
        <comment>task; conditions</comment>
        <translation>
            <numerusform>%1：%n 个序列；%2</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1. %n trigger(s) could not be written: %2</source>
        <comment>device; why</comment>
        <translation>
            <numerusform>%1。%n 个触发信号未能写出：%2</numerusform>
        </translation>
    </message>
    <message>
        <source>the line was not open</source>
        <translation>线路未打开</translation>
    </message>
    <message>
        <source>Track %1, level %2 %3</source>
        <comment>name, number, unit</comment>
        <translation>序列 %1，刺激水平 %2 %3</translation>
    </message>
    <message>
        <source>%1 practice trials of each track; up to %2 test trials per participant</source>
        <translation>每条轨迹 %1 个练习试次；每位参与者最多 %2 个测试试次</translation>
    </message>
    <message>
        <source>Session %1 of %2</source>
        <translation>第 %1 次，共 %2 次</translation>
    </message>
    <message>
        <source> (%1 Hz, force %2 %)</source>
        <comment>behind a level; force as a share of full</comment>
        <translation> （%1 Hz，力 %2 %）</translation>
    </message>
    <message>
        <source>STOP is released. The session waits, and an interrupted trial will be shown again.</source>
        <translation>STOP 已解除。此场次正在等待，被中断的试次将重新呈现。</translation>
    </message>
</context>
<context>
    <name>StudySchema</name>
    <message>
        <source>a newer program made this study (schema %1, this one knows %2)</source>
        <translation>此研究由较新的程序创建（架构 %1，本程序支持 %2）</translation>
    </message>
    <message>
        <source>cannot write the study: %1</source>
        <translation>无法写入研究：%1</translation>
    </message>
    <message>
        <source>cannot read the study: %1</source>
        <translation>无法读取研究：%1</translation>
    </message>
    <message>
        <source>another program made this database (schema %1)</source>
        <translation>此数据库由其他程序创建（架构 %1）</translation>
    </message>
</context>
<context>
    <name>StudySession</name>
    <message>
        <source>the stored trials do not belong to this session&apos;s plan</source>
        <translation>已保存的试次与此计划不符</translation>
    </message>
    <message>
        <source>the order given by the session&apos;s seed</source>
        <translation>由场次种子给出的顺序</translation>
    </message>
</context>
<context>
    <name>StudyStore</name>
    <message>
        <source>cannot open the study: %1</source>
        <translation>无法打开研究：%1</translation>
    </message>
    <message>
        <source>cannot use the study: %1</source>
        <translation>无法使用研究：%1</translation>
    </message>
    <message>
        <source>there is no study here</source>
        <translation>此处没有研究</translation>
    </message>
    <message>
        <source>a folder with study.sqlite</source>
        <translation>含 study.sqlite 的文件夹</translation>
    </message>
    <message>
        <source>each attempt of a trial once</source>
        <translation>试次的每次尝试一次</translation>
    </message>
    <message>
        <source>cannot read the file: %1</source>
        <translation>无法读取文件：%1</translation>
    </message>
    <message>
        <source>server, created_utc and seed of a study</source>
        <translation>研究的 server、created_utc 和 seed</translation>
    </message>
    <message>
        <source>the address has the port &quot;%1&quot;</source>
        <translation>地址中的端口为“%1”</translation>
    </message>
    <message>
        <source>a whole number from 1 to 65535</source>
        <translation>1 至 65535 的整数</translation>
    </message>
    <message>
        <source>the option &quot;%1&quot; of the address has a semicolon</source>
        <translation>地址的选项“%1”含有分号</translation>
    </message>
    <message>
        <source>a value without semicolons</source>
        <translation>不含分号的值</translation>
    </message>
    <message>
        <source>the address has the unknown option &quot;%1&quot;</source>
        <translation>地址含有未知选项“%1”</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot name a study on a server</source>
        <translation>“%1”不能作为服务器上研究的名称</translation>
    </message>
    <message>
        <source>Qt&apos;s driver for PostgreSQL is not installed</source>
        <translation>未安装 Qt 的 PostgreSQL 驱动程序</translation>
    </message>
    <message>
        <source>the package %1</source>
        <translation>软件包 %1</translation>
    </message>
    <message>
        <source>the server has no study &quot;%1&quot;</source>
        <translation>服务器上没有研究“%1”</translation>
    </message>
    <message>
        <source>one session of a participant at a time</source>
        <translation>一名被试同一时间只进行一个场次</translation>
    </message>
    <message>
        <source>another station</source>
        <translation>另一个工作站</translation>
    </message>
    <message>
        <source>these trials belong to another study</source>
        <translation>这些试次属于另一个研究</translation>
    </message>
    <message>
        <source>each questionnaire once</source>
        <translation>每份问卷一次</translation>
    </message>
    <message>
        <source>cannot write the file: %1</source>
        <translation>无法写入文件：%1</translation>
    </message>
    <message>
        <source>cannot remove the file: %1</source>
        <translation>无法删除文件：%1</translation>
    </message>
    <message>
        <source>cannot read the study: %1</source>
        <translation>无法读取研究：%1</translation>
    </message>
    <message>
        <source>another try in a moment</source>
        <translation>稍后重试</translation>
    </message>
    <message>
        <source>a separate folder for each study</source>
        <translation>每个研究使用各自的文件夹</translation>
    </message>
    <message>
        <source>this folder already contains a study</source>
        <translation>此文件夹中已有一个存于其内的研究</translation>
    </message>
    <message>
        <source>this folder belongs to another study, on %1</source>
        <translation>此文件夹属于 %1 上的另一个研究</translation>
    </message>
    <message>
        <source>the file does not say which study the folder belongs to</source>
        <translation>未说明该文件夹属于哪个研究</translation>
    </message>
    <message>
        <source>this is not the address of a PostgreSQL server</source>
        <translation>这不是 PostgreSQL 服务器的地址</translation>
    </message>
    <message>
        <source>lower-case letters, digits and _, no digit first</source>
        <translation>小写字母、数字和 _，不以数字开头</translation>
    </message>
    <message>
        <source>the program that ran this study was interrupted; its last trials are in %1, which can be read only in a writable folder</source>
        <translation>运行此研究的程序被中断，其最后的试次在 %1 中，只能在可写入的位置读取</translation>
    </message>
    <message>
        <source>a copy of the whole folder in a writable place</source>
        <translation>整个文件夹在可写位置的副本</translation>
    </message>
    <message>
        <source>this study was made by an older program and cannot be upgraded here</source>
        <translation>此研究由较旧的程序创建，无法在此处升级</translation>
    </message>
    <message>
        <source>the name of a study on that server</source>
        <translation>已在该处开始的研究的名称</translation>
    </message>
    <message>
        <source>another station took over this participant while the server was unreachable</source>
        <translation>服务器断开期间，另一个工作站继续了此被试</translation>
    </message>
    <message>
        <source>the server still holds the broken connection, and with it this participant</source>
        <translation>服务器仍保留着已中断的连接及此被试</translation>
    </message>
    <message>
        <source>it is read-only here</source>
        <translation>此处不能写入，只能查看</translation>
    </message>
    <message>
        <source>the study is damaged: a session or trial has a number outside its protocol</source>
        <translation>研究已损坏：某个场次或试次的编号在其方案中不存在</translation>
    </message>
    <message>
        <source>this trial is already stored</source>
        <translation>该试次已保存</translation>
    </message>
    <message>
        <source>The trial is safe in %1 and will be sent when the server is back.</source>
        <translation>该试次已安全存于 %1，服务器恢复后发送。</translation>
    </message>
    <message>
        <source>this questionnaire belongs elsewhere in the study</source>
        <translation>此问卷属于研究中的另一处</translation>
    </message>
    <message>
        <source>this questionnaire has already been answered</source>
        <translation>此问卷已回答过</translation>
    </message>
    <message>
        <source>this is not a trial</source>
        <translation>这不是试次</translation>
    </message>
    <message>
        <source>a stored trial</source>
        <translation>在此保存过的试次</translation>
    </message>
    <message>
        <source>the study is open for reading only</source>
        <translation>研究以只读方式打开</translation>
    </message>
    <message>
        <source>a folder that can be written to</source>
        <translation>可写入的文件夹</translation>
    </message>
    <message>
        <source>the study has no participant &quot;%1&quot;</source>
        <translation>研究中没有被试“%1”</translation>
    </message>
</context>
<context>
    <name>StudySweep</name>
    <message>
        <source>&quot;participants&quot; is out of range</source>
        <translation>“participants”超出范围</translation>
    </message>
    <message>
        <source>a whole number from 1 to 1000</source>
        <translation>1 到 1000 的整数</translation>
    </message>
    <message>
        <source>unknown key &quot;%1&quot;</source>
        <translation>未知的键“%1”</translation>
    </message>
    <message>
        <source>participants, or a key behind &quot;truth.&quot; or &quot;protocol.&quot;</source>
        <translation>participants，或“truth.”或“protocol.”之后的键</translation>
    </message>
</context>
<context>
    <name>StudyTruth</name>
    <message>
        <source>cannot open the truth: %1</source>
        <translation>无法打开真值：%1</translation>
    </message>
    <message>
        <source>the task %1 shows no spread of its participants: %2</source>
        <translation>任务 %1 未显示其被试的离散度：%2</translation>
    </message>
    <message>
        <source>a pilot with at least 5 participants, or a file with the truth</source>
        <translation>至少有 5 名被试的预试，或含真值的文件</translation>
    </message>
    <message>
        <source>nothing is assumed of the task %1</source>
        <translation>对任务 %1 没有作任何假设</translation>
    </message>
    <message>
        <source>condition or threshold</source>
        <translation>condition 或 threshold</translation>
    </message>
    <message>
        <source>this study has no test trials yet</source>
        <translation>此研究还没有测试试次</translation>
    </message>
    <message>
        <source>no task has a threshold and a slope of several participants</source>
        <translation>没有任务具有多名被试的阈值和斜率</translation>
    </message>
    <message>
        <source>a pilot with at least 2 participants, or a file with the truth</source>
        <translation>至少有 2 名被试的预试，或含真值的文件</translation>
    </message>
</context>
<context>
    <name>StudyWatermark</name>
    <message>
        <source>PILOT</source>
        <translation>预试</translation>
    </message>
    <message>
        <source>SIMULATED</source>
        <translation>模拟</translation>
    </message>
</context>
<context>
    <name>StudyWriting</name>
    <message>
        <source>Results of the study</source>
        <translation>研究结果</translation>
    </message>
</context>
<context>
    <name>SweepCommand</name>
    <message>
        <source>Sweep file: what runs, with which settings and seeds</source>
        <translation>扫描文件：运行什么，用哪些设置和种子</translation>
    </message>
    <message>
        <source>Folder for runs.csv, cells.csv, figures and sweep.json; a sweep that was interrupted goes on in it</source>
        <translation>存放 runs.csv、cells.csv、figures 和 sweep.json 的文件夹；中断的扫描在其中继续</translation>
    </message>
    <message>
        <source>Throw away what the folder has of an earlier sweep</source>
        <translation>丢弃文件夹中先前扫描的结果</translation>
    </message>
    <message>
        <source>Share of the runs that may fail before this counts as an error</source>
        <translation>可以失败而不算错误的运行份额</translation>
    </message>
    <message>
        <source>Write the tactile frames with contacts, forces and objects to DIR/frames</source>
        <translation>把触觉帧连同接触、力和物体写入 DIR/frames</translation>
    </message>
    <message>
        <source>Say how far the sweep in this folder has come</source>
        <translation>说明此文件夹中扫描的进度</translation>
    </message>
    <message>
        <source>Only merge the results that are there, as each run of this command does at its end</source>
        <translation>仅合并已有的结果；此命令每次结束时都会这样做</translation>
    </message>
    <message>
        <source>Run it as an array of jobs of Slurm on a cluster</source>
        <translation>作为 Slurm 的作业数组在集群上运行</translation>
    </message>
    <message>
        <source>Of Slurm: tasks of the array</source>
        <translation>Slurm：数组的任务数</translation>
    </message>
    <message>
        <source>Of Slurm: runs of one task</source>
        <translation>Slurm：一个任务的运行数</translation>
    </message>
    <message>
        <source>Of Slurm: an option of sbatch, such as --partition=short; may come again</source>
        <translation>Slurm：sbatch 的选项，例如 --partition=short；可重复</translation>
    </message>
    <message>
        <source>Of Slurm: wait until all is done and merged</source>
        <translation>Slurm：等待全部完成并合并</translation>
    </message>
    <message>
        <source>Do the share of this task of --tasks, from 0, as the jobs of Slurm do</source>
        <translation>执行 --tasks 中此任务（从 0 起）的份额，与 Slurm 的作业相同</translation>
    </message>
    <message>
        <source>is required</source>
        <translation>是必需的</translation>
    </message>
    <message>
        <source>is not below the number of tasks, %1</source>
        <translation>不小于任务数 %1</translation>
    </message>
    <message>
        <source>is for scenes of an array or a servo</source>
        <translation>用于阵列或伺服的场景</translation>
    </message>
    <message>
        <source>a sweep file, or one of: %1</source>
        <translation>扫描文件，或以下之一：%1</translation>
    </message>
    <message>
        <source>%1 of %2 runs are missing</source>
        <translation>%2 次运行中缺少 %1 次</translation>
    </message>
    <message>
        <source>the same command without --merge, which goes on with them</source>
        <translation>不带 --merge 的同一命令，它会继续完成</translation>
    </message>
    <message>
        <source>%1 of %2 runs failed; runs.csv has the reasons</source>
        <translation>%2 次运行中有 %1 次失败；原因见 runs.csv</translation>
    </message>
    <message>
        <source>at most %1 (see --allow-failed)</source>
        <translation>最多 %1（见 --allow-failed）</translation>
    </message>
    <message>
        <source>Job</source>
        <translation>作业</translation>
    </message>
    <message>
        <source>Tasks</source>
        <translation>任务</translation>
    </message>
    <message>
        <source>Merging job</source>
        <translation>合并作业</translation>
    </message>
    <message>
        <source>How far it is</source>
        <translation>进度</translation>
    </message>
    <message>
        <source>Run a scene over a grid of settings and seeds, here or on a cluster</source>
        <translation>在设置和种子的网格上运行场景，在本机或集群上</translation>
    </message>
    <message>
        <source>needs --slurm or --task</source>
        <translation>需要 --slurm 或 --task</translation>
    </message>
    <message>
        <source>Runs at the same time; otherwise as many as the machine has cores, and one of a ladder, which is timed</source>
        <translation>同时运行的数目；不指定则与机器的核心数相同，阶梯因要计时则为一个</translation>
    </message>
    <message>
        <source>%1; asking again (%2 of %3)</source>
        <translation>%1；再次询问（第 %2 次，共 %3 次）</translation>
    </message>
</context>
<context>
    <name>SweepFigure</name>
    <message>
        <source>Bars: Wilson&apos;s 95 % interval of the share.</source>
        <translation>竖线：份额的威尔逊 95 % 区间。</translation>
    </message>
    <message>
        <source>Points: means with their 95 % interval. Dotted: 5 and 95 % of the runs.</source>
        <translation>点：平均值及其 95 % 区间。虚线：运行的 5 % 和 95 %。</translation>
    </message>
    <message>
        <source>Means. The first %1 of %2 maps.</source>
        <translation>平均值。%2 张地图中的前 %1 张。</translation>
    </message>
    <message>
        <source>Means. Crossed out: no run has it.</source>
        <translation>平均值。划去：没有运行具有该值。</translation>
    </message>
</context>
<context>
    <name>SweepFolderText</name>
    <message>
        <source>the folder holds results of another sweep: %1</source>
        <translation>文件夹中有另一扫描的结果：%1</translation>
    </message>
    <message>
        <source>another folder, or --restart, which throws these results away</source>
        <translation>另一个文件夹，或会丢弃这些结果的 --restart</translation>
    </message>
    <message>
        <source>line %1 was &quot;%2&quot; and is &quot;%3&quot;</source>
        <translation>第 %1 行原为“%2”，现为“%3”</translation>
    </message>
    <message>
        <source>only the spaces differ</source>
        <translation>仅空格不同</translation>
    </message>
    <message>
        <source>earlier results cannot be removed</source>
        <translation>无法删除先前的结果</translation>
    </message>
    <message>
        <source>what it runs has changed, %1</source>
        <translation>所运行的内容已改变，%1</translation>
    </message>
    <message>
        <source>they are of version %1, this is %2</source>
        <translation>结果属于版本 %1，当前为 %2</translation>
    </message>
    <message>
        <source>they have frames</source>
        <translation>结果带有帧</translation>
    </message>
    <message>
        <source>they have no frames</source>
        <translation>结果不带帧</translation>
    </message>
    <message>
        <source>the folder holds other files</source>
        <translation>文件夹中有其他文件</translation>
    </message>
    <message>
        <source>a new or empty folder, or one of a sweep</source>
        <translation>新的或空的文件夹，或扫描的文件夹</translation>
    </message>
    <message>
        <source>this describes no sweep</source>
        <translation>这不是扫描的描述</translation>
    </message>
    <message>
        <source>a file that teleta sweep has written</source>
        <translation>由 teleta sweep 写出的文件</translation>
    </message>
</context>
<context>
    <name>SweepParts</name>
    <message>
        <source>the file cannot be made: %1</source>
        <translation>无法创建文件：%1</translation>
    </message>
    <message>
        <source>this is no part of a sweep</source>
        <translation>这不是扫描的部分文件</translation>
    </message>
    <message>
        <source>this is no row of a sweep</source>
        <translation>这不是扫描的一行</translation>
    </message>
    <message>
        <source>the number of a run and its times</source>
        <translation>运行的编号及其时间</translation>
    </message>
    <message>
        <source>this is no number</source>
        <translation>这不是数字</translation>
    </message>
    <message>
        <source>a number or NA</source>
        <translation>数字或 NA</translation>
    </message>
    <message>
        <source>a part has the run %1</source>
        <translation>部分文件中有运行 %1</translation>
    </message>
    <message>
        <source>runs from 0 to %1</source>
        <translation>0 到 %1 的运行</translation>
    </message>
</context>
<context>
    <name>SweepPlan</name>
    <message>
        <source>a range with scale &quot;log10&quot; reaches 0 or below</source>
        <translation>scale 为“log10”的范围达到 0 或以下</translation>
    </message>
    <message>
        <source>the key &quot;%1&quot; is varied twice</source>
        <translation>键“%1”变化了两次</translation>
    </message>
    <message>
        <source>each key once</source>
        <translation>每个键一次</translation>
    </message>
    <message>
        <source>keys that go together have unlike numbers of values: %1 and %2</source>
        <translation>一起变化的键的取值数不同：%1 和 %2</translation>
    </message>
    <message>
        <source>%1 values, as the first key has</source>
        <translation>%1 个值，与第一个键相同</translation>
    </message>
    <message>
        <source>a sweep runs one thing</source>
        <translation>一个扫描只运行一样东西</translation>
    </message>
    <message>
        <source>one of: scene, study, ladder</source>
        <translation>以下之一：scene、study、ladder</translation>
    </message>
    <message>
        <source>these are no seeds</source>
        <translation>这不是种子</translation>
    </message>
    <message>
        <source>&quot;FIRST:LAST&quot;, such as &quot;1:200&quot;</source>
        <translation>“FIRST:LAST”，例如“1:200”</translation>
    </message>
    <message>
        <source>the sweep has %1 runs</source>
        <translation>扫描有 %1 次运行</translation>
    </message>
    <message>
        <source>at most %1</source>
        <translation>最多 %1</translation>
    </message>
</context>
<context>
    <name>SweepReport</name>
    <message>
        <source>%1 of %2 runs, %3 failed, %4 left</source>
        <translation>%2 次中已运行 %1 次，失败 %3，剩余 %4</translation>
    </message>
    <message>
        <source>Worst cells so far:</source>
        <translation>目前最差的单元：</translation>
    </message>
    <message>
        <source>%1 of %2 failed; </source>
        <translation>%2 次中 %1 次失败； </translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>文件夹</translation>
    </message>
    <message>
        <source>Runs</source>
        <translation>运行</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 / %2</translation>
    </message>
    <message>
        <source>Failed</source>
        <translation>失败</translation>
    </message>
    <message>
        <source>Cells</source>
        <translation>单元</translation>
    </message>
    <message>
        <source>Processor time</source>
        <translation>处理器时间</translation>
    </message>
    <message>
        <source>%1 to %2 (means of the cells)</source>
        <translation>%1 至 %2（各单元的平均值）</translation>
    </message>
</context>
<context>
    <name>SweepRunner</name>
    <message>
        <source>a run has no measure &quot;%1&quot;</source>
        <translation>运行没有测量值“%1”</translation>
    </message>
    <message>
        <source>of: %1</source>
        <translation>其中：%1</translation>
    </message>
    <message>
        <source>this has no frames of a tactile array</source>
        <translation>这没有触觉阵列的帧</translation>
    </message>
    <message>
        <source>a scene of an array or a servo</source>
        <translation>阵列或伺服的场景</translation>
    </message>
</context>
<context>
    <name>SweepTexts</name>
    <message>
        <source>Camera</source>
        <translation>相机</translation>
    </message>
    <message>
        <source>Contact by place and depth</source>
        <translation>不同位置和深度的触碰</translation>
    </message>
    <message>
        <source>How exactly does the camera in the soft tube find a finger along the tube?</source>
        <translation>软管内的相机沿管能多准确地找到手指？</translation>
    </message>
    <message>
        <source>Touched object</source>
        <translation>被触碰物体</translation>
    </message>
    <message>
        <source>Stiffness by noise and speed</source>
        <translation>不同噪声和速度下的刚度</translation>
    </message>
    <message>
        <source>Over which stiffnesses, noises and speeds does a touch find the stiffness?</source>
        <translation>在哪些刚度、噪声和速度下，触碰能得出刚度？</translation>
    </message>
    <message>
        <source>Curve through contact points</source>
        <translation>通过接触点的曲线</translation>
    </message>
    <message>
        <source>How far is the curve from the outline, and how long does it take?</source>
        <translation>曲线与轮廓相差多少，需要多长时间？</translation>
    </message>
    <message>
        <source>Servo</source>
        <translation>伺服</translation>
    </message>
    <message>
        <source>Bent bar by friction and latency</source>
        <translation>不同摩擦和延迟下的弯杆</translation>
    </message>
    <message>
        <source>Over which radii, frictions and latencies does the array follow the bar?</source>
        <translation>在哪些半径、摩擦和延迟下，阵列能跟随杆？</translation>
    </message>
    <message>
        <source>Frames to learn from</source>
        <translation>用于学习的帧</translation>
    </message>
    <message>
        <source>Two balls on an array</source>
        <translation>阵列上的两个球</translation>
    </message>
    <message>
        <source>A million frames, with where and how hard each ball presses.</source>
        <translation>一百万帧，含每个球按压的位置和力。</translation>
    </message>
    <message>
        <source>An array along a bent bar</source>
        <translation>沿弯杆移动的阵列</translation>
    </message>
    <message>
        <source>A million frames, with where, how hard and along which normal it is pressed.</source>
        <translation>一百万帧，含受压的位置、力和法线。</translation>
    </message>
</context>
<context>
    <name>TableText</name>
    <message>
        <source>the recording has no frames</source>
        <translation>记录中没有帧</translation>
    </message>
    <message>
        <source>at least one row of numbers</source>
        <translation>至少一行数值</translation>
    </message>
    <message>
        <source>there is no column %1</source>
        <translation>没有列 %1</translation>
    </message>
    <message>
        <source>a number from 1 to %1; the table has no header</source>
        <translation>1 至 %1 的编号；表格没有标题行</translation>
    </message>
    <message>
        <source>one of %1, or a number from 1 to %2</source>
        <translation>%1 之一，或 1 至 %2 的编号</translation>
    </message>
    <message>
        <source>the table has %1 columns, %2..%3 are asked for</source>
        <translation>表格有 %1 列，而请求的是 %2..%3</translation>
    </message>
    <message>
        <source>columns from 1 to %1</source>
        <translation>1 至 %1 的列</translation>
    </message>
    <message>
        <source>the table has %1 columns of taxels</source>
        <translation>表格有 %1 列触觉单元</translation>
    </message>
    <message>
        <source>from 1 to %1</source>
        <translation>1 至 %1</translation>
    </message>
    <message>
        <source>column %1 is that of the times, and one of the taxels</source>
        <translation>列 %1 既是时间列，又是触觉单元列</translation>
    </message>
    <message>
        <source>either</source>
        <translation>二者之一</translation>
    </message>
    <message>
        <source>a row of the table</source>
        <translation>表格的一行</translation>
    </message>
    <message>
        <source>a column of times and a rate</source>
        <translation>同时给出了时间列和帧率</translation>
    </message>
    <message>
        <source>the column of the times (--time-column NAME), or frames per second (--rate HZ)</source>
        <translation>时间列（--time-column NAME），或每秒帧数（--rate HZ）</translation>
    </message>
    <message>
        <source>the unit %1 of the times</source>
        <translation>时间的单位 %1</translation>
    </message>
    <message>
        <source>the row has %1 values</source>
        <translation>该行有 %1 个值</translation>
    </message>
    <message>
        <source>one value per column: %1</source>
        <translation>每列一个值：%1</translation>
    </message>
    <message>
        <source>the table is too long</source>
        <translation>表格过长</translation>
    </message>
    <message>
        <source>at most %1 values</source>
        <translation>至多 %1 个值</translation>
    </message>
    <message>
        <source>the time goes back</source>
        <translation>时间倒退</translation>
    </message>
    <message>
        <source>times that do not decrease</source>
        <translation>不递减的时间</translation>
    </message>
    <message>
        <source>%1 is not a number</source>
        <translation>%1 不是数值</translation>
    </message>
    <message>
        <source>a number, nan, inf or NA</source>
        <translation>数值、nan、inf 或 NA</translation>
    </message>
    <message>
        <source>%1 is not a time</source>
        <translation>%1 不是时间</translation>
    </message>
    <message>
        <source>a finite number</source>
        <translation>有限数</translation>
    </message>
    <message>
        <source>a date and time such as 2026-05-01T12:00:00.5</source>
        <translation>日期和时间，例如 2026-05-01T12:00:00.5</translation>
    </message>
    <message>
        <source>a number, or iso as the unit (--time-unit iso)</source>
        <translation>数值，或以 iso 为单位（--time-unit iso）</translation>
    </message>
</context>
<context>
    <name>TareQuestion</name>
    <message>
        <source>Tare the array</source>
        <translation>对阵列去皮</translation>
    </message>
    <message>
        <source>%1 of %2 taxels are under load.</source>
        <translation>%2 个触觉单元中有 %1 个受载。</translation>
    </message>
    <message>
        <source>What presses on the array during the tare counts as no load afterwards. Tare only if nothing touches the array and the loads shown are drift.</source>
        <translation>去皮时压在阵列上的东西，之后不再算作载荷。只有在没有任何物体接触阵列、所显示的载荷是漂移时才去皮。</translation>
    </message>
    <message>
        <source>&amp;Tare under load</source>
        <translation>带载去皮(&amp;T)</translation>
    </message>
</context>
<context>
    <name>TaxelGainFile</name>
    <message>
        <source>taxel %1 is missing</source>
        <translation>缺少触觉单元 %1</translation>
    </message>
    <message>
        <source>the taxels 0 to %1</source>
        <translation>触觉单元 0 至 %1</translation>
    </message>
    <message>
        <source>the %1 is &quot;%2&quot;</source>
        <comment>a column of a table</comment>
        <translation>%1 为“%2”</translation>
    </message>
    <message>
        <source>a whole number from 0 to %1</source>
        <translation>0 至 %1 的整数</translation>
    </message>
    <message>
        <source>%1, in an array of %2 rows x %3 columns</source>
        <translation>%1（%2 行 x %3 列的阵列）</translation>
    </message>
    <message>
        <source>each taxel once</source>
        <translation>每个触觉单元一次</translation>
    </message>
    <message>
        <source>a number from %1 to %2, or NA</source>
        <translation>%1 至 %2 的数字，或 NA</translation>
    </message>
    <message>
        <source>the state does not fit the gain</source>
        <translation>状态与增益不符</translation>
    </message>
    <message>
        <source>taxel %1 is listed in row %2, column %3</source>
        <translation>触觉单元 %1 被写在第 %2 行、第 %3 列</translation>
    </message>
    <message>
        <source>taxel %1 is listed twice</source>
        <translation>触觉单元 %1 出现两次</translation>
    </message>
    <message>
        <source>the gain is not a number or out of range</source>
        <translation>增益超出范围或不是数字</translation>
    </message>
    <message>
        <source>the standard error is not a number or out of range</source>
        <translation>标准误差超出范围或不是数字</translation>
    </message>
    <message>
        <source>a number of at least 0, or NA</source>
        <translation>不小于 0 的数字，或 NA</translation>
    </message>
</context>
<context>
    <name>TaxelGains</name>
    <message>
        <source>Only %1 of %2 taxels feel the load.</source>
        <translation>%2 个触觉单元中只有 %1 个感受到载荷。</translation>
    </message>
    <message>
        <source>Only %1 frames are under load.</source>
        <translation>只有 %1 帧受载。</translation>
    </message>
    <message>
        <source>at least %1</source>
        <translation>至少 %1</translation>
    </message>
    <message>
        <source>There is no press.</source>
        <translation>没有按压。</translation>
    </message>
    <message>
        <source>at least one</source>
        <translation>至少一个</translation>
    </message>
    <message>
        <source>a multiple of %1</source>
        <translation>%1 的倍数</translation>
    </message>
    <message>
        <source>No taxel is good in all presses.</source>
        <translation>没有在所有按压中都良好的触觉单元。</translation>
    </message>
    <message>
        <source>presses of the whole array</source>
        <translation>对整个阵列的按压</translation>
    </message>
    <message>
        <source>Most taxels read the same value in all frames: %1.</source>
        <translation>大多数触觉单元在所有帧中的读数都相同：%1。</translation>
    </message>
    <message>
        <source>a load that the taxels can measure</source>
        <translation>触觉单元能够测量的载荷</translation>
    </message>
    <message>
        <source>at least %1, under a smaller load</source>
        <translation>至少 %1 帧，载荷更小</translation>
    </message>
    <message>
        <source>a load on the whole array, and a tare taken without load</source>
        <translation>整个阵列受载，并在空载时去皮</translation>
    </message>
    <message>
        <source>Only %1 frames under load are within the range of the taxels.</source>
        <translation>除 %1 帧外，受载各帧中的触觉单元都已到达量程上限。</translation>
    </message>
    <message>
        <source>The frames have %1 values in total.</source>
        <translation>各帧共有 %1 个值。</translation>
    </message>
</context>
<context>
    <name>TaxelsReportText</name>
    <message>
        <source>Frames found</source>
        <translation>找到的帧</translation>
    </message>
    <message>
        <source>Bytes of frames</source>
        <translation>帧的字节</translation>
    </message>
    <message>
        <source>Bytes outside frames</source>
        <translation>帧外的字节</translation>
    </message>
    <message>
        <source>Wrong checksums</source>
        <translation>错误的校验和</translation>
    </message>
    <message>
        <source>Wrong lengths</source>
        <translation>错误的长度</translation>
    </message>
    <message>
        <source>Wrong closing bytes</source>
        <translation>错误的结束字节</translation>
    </message>
    <message>
        <source>Unreadable values</source>
        <translation>无法读取的值</translation>
    </message>
    <message>
        <source>Frames of another length</source>
        <translation>其他长度的帧</translation>
    </message>
    <message>
        <source>Bytes (&gt; begins a frame)</source>
        <translation>字节（&gt; 为帧的开头）</translation>
    </message>
    <message>
        <source>First frame in %1, the last row first</source>
        <translation>第一帧（单位 %1），最后一行在前</translation>
    </message>
    <message>
        <source>First frame: taxel, x and y in mm, and its x, y and z in %1</source>
        <translation>第一帧：触觉单元、x 和 y（mm）以及其 x、y、z 分量（%1）</translation>
    </message>
    <message>
        <source>First frame: taxel, x and y in mm, and its load in %1</source>
        <translation>第一帧：触觉单元、x 和 y（mm）以及其载荷（%1）</translation>
    </message>
    <message>
        <source>Binary messages, which are left out</source>
        <translation>被忽略的二进制消息</translation>
    </message>
</context>
<context>
    <name>TaxelsText</name>
    <message>
        <source>up to %1 bytes, as &quot;AA 55&quot;</source>
        <translation>最多 %1 个字节，如“AA 55”</translation>
    </message>
    <message numerus="yes">
        <source>%n byte(s) from %1 on are not in the frame</source>
        <translation>
            <numerusform>从 %1 起的 %n 个字节不在帧内</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>a place in a frame of %n byte(s)</source>
        <translation>
            <numerusform>%n 个字节的帧中的位置</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n byte(s) from %1 on are in no frame</source>
        <translation>
            <numerusform>从 %1 起的 %n 个字节不在任何帧内</numerusform>
        </translation>
    </message>
    <message>
        <source>a place in the frame; a negative one counts from its end</source>
        <translation>帧中的位置；负数从末尾数起</translation>
    </message>
    <message>
        <source>the checksum covers no byte of the frame</source>
        <translation>校验和不覆盖帧的任何字节</translation>
    </message>
    <message>
        <source>&quot;from&quot; before &quot;to&quot;</source>
        <translation>“from”在“to”之前</translation>
    </message>
    <message>
        <source>the checksum covers itself</source>
        <translation>校验和覆盖了自身</translation>
    </message>
    <message>
        <source>bytes before or behind it</source>
        <translation>它之前或之后的字节</translation>
    </message>
    <message>
        <source>with a factor of 0 every value is the same</source>
        <translation>系数为 0 时所有值都相同</translation>
    </message>
    <message>
        <source>another number</source>
        <translation>另一个数</translation>
    </message>
    <message>
        <source>%1 numbers are not %2 for each taxel</source>
        <translation>%1 个数不是每个触觉单元 %2 个</translation>
    </message>
    <message>
        <source>a multiple of %1</source>
        <translation>%1 的倍数</translation>
    </message>
    <message>
        <source>a taxel has more bytes than that</source>
        <translation>一个触觉单元的字节比这更多</translation>
    </message>
    <message>
        <source>at least %1, or 0</source>
        <translation>至少 %1，或 0</translation>
    </message>
    <message>
        <source>the length of a frame is not clear</source>
        <translation>帧的长度不明确</translation>
    </message>
    <message>
        <source>either length or length_field</source>
        <translation>length 或 length_field 之一</translation>
    </message>
    <message>
        <source>the first and last bytes are longer than the frame</source>
        <translation>开头和结尾的字节比帧还长</translation>
    </message>
    <message>
        <source>at least %1</source>
        <translation>至少 %1</translation>
    </message>
    <message>
        <source>nothing shows where a frame begins</source>
        <translation>没有任何东西表明帧从何处开始</translation>
    </message>
    <message>
        <source>sync, end or a checksum</source>
        <translation>sync、end 或校验和</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot separate numbers</source>
        <translation>“%1”不能用来分隔数字</translation>
    </message>
    <message>
        <source>one character</source>
        <translation>一个字符</translation>
    </message>
    <message>
        <source>&quot;%1&quot; names no columns</source>
        <translation>“%1”没有指明列</translation>
    </message>
    <message>
        <source>the first and the last column, as &quot;2..85&quot;</source>
        <translation>第一列和最后一列，如“2..85”</translation>
    </message>
    <message>
        <source>a column cannot be a value and the time</source>
        <translation>一列不能既是值又是时间</translation>
    </message>
    <message>
        <source>a column outside &quot;columns&quot;</source>
        <translation>“columns”之外的列</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no JSON pointer</source>
        <translation>“%1”不是 JSON 指针</translation>
    </message>
    <message>
        <source>a path as &quot;/sensors/0/data&quot;</source>
        <translation>如“/sensors/0/data”的路径</translation>
    </message>
    <message>
        <source>a taxel tells its load or three components</source>
        <translation>一个触觉单元给出其载荷或三个分量</translation>
    </message>
    <message>
        <source>1 or 3</source>
        <translation>1 或 3</translation>
    </message>
    <message>
        <source>each axis once with its sign, as [&quot;+x&quot;, &quot;-y&quot;, &quot;-z&quot;]</source>
        <translation>每个轴带符号出现一次，如 [&quot;+x&quot;, &quot;-y&quot;, &quot;-z&quot;]</translation>
    </message>
    <message>
        <source>these are no places of taxels</source>
        <translation>这些不是触觉单元的位置</translation>
    </message>
    <message>
        <source>&quot;places&quot; says already where no taxel is</source>
        <translation>“places”已说明哪里没有触觉单元</translation>
    </message>
    <message>
        <source>either places or mask</source>
        <translation>places 或 mask 之一</translation>
    </message>
    <message>
        <source>The sensor has sent no usable frame for %1 s.</source>
        <translation>传感器已有 %1 s 未发送可用的帧。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no address of a WebSocket server</source>
        <translation>“%1”不是 WebSocket 服务器的地址</translation>
    </message>
    <message>
        <source>ws://HOST:PORT or wss://HOST:PORT</source>
        <translation>ws://HOST:PORT 或 wss://HOST:PORT</translation>
    </message>
    <message>
        <source>it is given as text already</source>
        <translation>已经以文本给出</translation>
    </message>
    <message>
        <source>either %1 or %2</source>
        <translation>%1 或 %2 之一</translation>
    </message>
    <message>
        <source>a frame has %1 numbers, but the layout has %2 taxels with %3 each</source>
        <translation>一帧有 %1 个数，但布局有 %2 个触觉单元，每个 %3 个数</translation>
    </message>
    <message>
        <source>%1 numbers</source>
        <translation>%1 个数</translation>
    </message>
    <message>
        <source>without a threshold it is not known which taxels are touched</source>
        <translation>没有阈值就无法知道哪些触觉单元被触碰</translation>
    </message>
    <message>
        <source>opening was cancelled</source>
        <translation>打开已取消</translation>
    </message>
    <message>
        <source>numbers from 0 to %1, and at least one place with a taxel</source>
        <translation>0 到 %1 的数，且至少有一个位置有触觉单元</translation>
    </message>
    <message>
        <source>numbers from 0 to %1, each once</source>
        <translation>0 到 %1 的数，每个一次</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a list of hexadecimal bytes</source>
        <translation>“%1”不是十六进制字节列表</translation>
    </message>
    <message>
        <source>threshold = a number in the unit of the values, above the first table</source>
        <translation>threshold = 以数值的单位表示的数，写在第一个表之前</translation>
    </message>
    <message>
        <source>only %1 of %2 frames arrived while the tare was measured</source>
        <translation>测量去皮值期间，%2 帧中只收到 %1 帧</translation>
    </message>
    <message>
        <source>frames as the file describes; check with teleta devices --probe FILE</source>
        <translation>与文件描述一致的帧；请用 teleta devices --probe FILE 检查</translation>
    </message>
    <message>
        <source>there are %1 positions</source>
        <translation>有 %1 个位置</translation>
    </message>
    <message>
        <source>one entry a position</source>
        <translation>每个位置一项</translation>
    </message>
    <message>
        <source>at most %1; more of them on a grid</source>
        <translation>最多 %1 个；更多时请用网格</translation>
    </message>
    <message>
        <source>other numbers than [0, 0, 0]</source>
        <translation>[0, 0, 0] 以外的数</translation>
    </message>
    <message>
        <source>taxels %1 and %2 are at the same place</source>
        <translation>触觉单元 %1 和 %2 位于同一位置</translation>
    </message>
    <message>
        <source>different places; they count from 0</source>
        <translation>不同的位置；编号从 0 开始</translation>
    </message>
    <message>
        <source>a normal is zero</source>
        <translation>某个法向量为零</translation>
    </message>
    <message>
        <source>these are not three distinct axes</source>
        <translation>这不是三个不同的轴</translation>
    </message>
    <message>
        <source>this mask does not fit the array</source>
        <translation>此掩码与阵列不符</translation>
    </message>
    <message>
        <source>at most %1 chips</source>
        <translation>至多 %1 个芯片</translation>
    </message>
    <message>
        <source>The sensor has told no values for %1 s: it has none, or they are switched off.</source>
        <translation>传感器已有 %1 s 未给出数值：它没有数值，或数值已关闭。</translation>
    </message>
    <message>
        <source>The sensor is another model: %1 instead of %2.</source>
        <translation>传感器是另一种型号：%1，而不是 %2。</translation>
    </message>
    <message>
        <source>The sensor has %1 taxels instead of %2.</source>
        <translation>传感器有 %1 个触觉单元，而不是 %2 个。</translation>
    </message>
    <message>
        <source>the board sends frames of %1 chips</source>
        <translation>电路板发送的是 %1 个芯片的帧</translation>
    </message>
    <message>
        <source>frames of %1 chips, as the file has positions</source>
        <translation>与文件中位置数相同的 %1 个芯片的帧</translation>
    </message>
</context>
<context>
    <name>TekscanText</name>
    <message>
        <source>the recording has no frames</source>
        <translation>记录中没有帧</translation>
    </message>
    <message>
        <source>the file ends after frame %1 of %2</source>
        <translation>文件在帧 %1 之后结束，应有 %2 帧</translation>
    </message>
    <message>
        <source>a whole file</source>
        <translation>完整的文件</translation>
    </message>
    <message>
        <source>the file ends within its head</source>
        <translation>文件在其文件头内结束</translation>
    </message>
    <message>
        <source>the head has no line %1</source>
        <translation>文件头中没有 %1 行</translation>
    </message>
    <message>
        <source>a whole number from 1 to %1</source>
        <translation>1 至 %1 的整数</translation>
    </message>
    <message>
        <source>a number above 0 in mm or cm</source>
        <translation>以 mm 或 cm 为单位、大于 0 的数值</translation>
    </message>
    <message>
        <source>%1 rows x %2 columns, as was asked for</source>
        <translation>%1 行 x %2 列，与所请求的一致</translation>
    </message>
    <message>
        <source>a number above 0 in mm2 or cm2</source>
        <translation>以 mm2 或 cm2 为单位、大于 0 的数值</translation>
    </message>
    <message>
        <source>RAW, or a unit of pressure such as kPa or PSI</source>
        <translation>RAW，或压力单位，例如 kPa 或 PSI</translation>
    </message>
    <message>
        <source>the area with which a pressure makes a force</source>
        <translation>由压力换算为力所用的面积</translation>
    </message>
    <message>
        <source>a number above 0, or frames per second (--rate HZ)</source>
        <translation>大于 0 的数值，或每秒帧数（--rate HZ）</translation>
    </message>
    <message>
        <source>the line is %1</source>
        <translation>该行为 %1</translation>
    </message>
    <message>
        <source>the frame has no number</source>
        <translation>该帧没有编号</translation>
    </message>
    <message>
        <source>frame %1 comes after frame %2</source>
        <translation>帧 %1 出现在帧 %2 之后</translation>
    </message>
    <message>
        <source>numbers that grow</source>
        <translation>递增的编号</translation>
    </message>
    <message>
        <source>the recording is too long</source>
        <translation>记录过长</translation>
    </message>
    <message>
        <source>at most %1 values</source>
        <translation>至多 %1 个值</translation>
    </message>
    <message>
        <source>frame %1 ends after %2 of %3 rows</source>
        <translation>帧 %1 在 %2 行之后结束，应有 %3 行</translation>
    </message>
    <message>
        <source>a whole frame</source>
        <translation>完整的一帧</translation>
    </message>
    <message>
        <source>the row has %1 values</source>
        <translation>该行有 %1 个值</translation>
    </message>
    <message>
        <source>%1 values</source>
        <translation>%1 个值</translation>
    </message>
    <message>
        <source>%1 is not a number</source>
        <translation>%1 不是数值</translation>
    </message>
    <message>
        <source>a number or B</source>
        <translation>数值或 B</translation>
    </message>
    <message>
        <source>0 or 1</source>
        <translation>0 或 1</translation>
    </message>
</context>
<context>
    <name>TextLinesText</name>
    <message>
        <source>the line is longer than 16 MiB</source>
        <translation>该行超过 16 MiB</translation>
    </message>
    <message>
        <source>a line end</source>
        <translation>行尾</translation>
    </message>
    <message>
        <source>the line has a byte 0, which no text has</source>
        <translation>该行含有字节 0，文本中不应出现</translation>
    </message>
    <message>
        <source>text</source>
        <translation>文本</translation>
    </message>
</context>
<context>
    <name>ThresholdPlan</name>
    <message>
        <source>the protocol has no task &quot;%1&quot;</source>
        <translation>方案中没有任务“%1”</translation>
    </message>
    <message>
        <source>TASK:threshold with the id of a task with levels</source>
        <translation>TASK:threshold，其中 TASK 为带水平的任务的标识</translation>
    </message>
    <message>
        <source>the task %1 has no levels</source>
        <translation>任务 %1 没有水平</translation>
    </message>
    <message>
        <source>a task that measures a threshold</source>
        <translation>测量阈值的任务</translation>
    </message>
    <message>
        <source>the truth says nothing of the threshold of %1</source>
        <translation>真值中没有 %1 的阈值</translation>
    </message>
    <message>
        <source>a [[task]] with that id and a threshold</source>
        <translation>具有该标识并给出阈值的 [[task]]</translation>
    </message>
    <message>
        <source>the threshold of %1 cannot be 0</source>
        <translation>%1 的阈值不能为 0</translation>
    </message>
    <message>
        <source>a level above 0, since the scale is log10</source>
        <translation>大于 0 的水平，因为尺度为 log10</translation>
    </message>
</context>
<context>
    <name>ThresholdSection</name>
    <message>
        <source>open</source>
        <comment>end of an interval</comment>
        <translation>开放</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <comment>interval</comment>
        <translation>%1 至 %2</translation>
    </message>
    <message>
        <source>Participant</source>
        <translation>被试</translation>
    </message>
    <message>
        <source>Condition</source>
        <translation>条件</translation>
    </message>
    <message>
        <source>Track</source>
        <translation>序列</translation>
    </message>
    <message>
        <source>Each participant; intervals of 95 % by profile likelihood unless the tables say otherwise</source>
        <translation>各被试；除非表中另有说明，95 % 区间由轮廓似然求得</translation>
    </message>
    <message>
        <source>Trials</source>
        <translation>试次</translation>
    </message>
    <message>
        <source>Threshold</source>
        <translation>阈值</translation>
    </message>
    <message>
        <source>95 %</source>
        <translation>95 %</translation>
    </message>
    <message>
        <source>Slope or spread</source>
        <translation>斜率或离散度</translation>
    </message>
    <message>
        <source>Just noticeable difference</source>
        <translation>最小可觉差</translation>
    </message>
    <message>
        <source>Weber fraction</source>
        <translation>韦伯分数</translation>
    </message>
    <message>
        <source>p of the deviance</source>
        <translation>偏差的 p 值</translation>
    </message>
    <message>
        <source>Estimate of the procedure</source>
        <translation>程序的估计值</translation>
    </message>
    <message>
        <source>Remark</source>
        <translation>备注</translation>
    </message>
    <message>
        <source>All participants: the mean of their thresholds with Student&apos;s t interval, and one fit of all with a threshold for each</source>
        <translation>全部被试：其阈值的平均值及学生 t 区间，以及对全部被试的共同拟合（每名被试各有一个阈值）</translation>
    </message>
    <message>
        <source>Participants</source>
        <translation>被试</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>平均值</translation>
    </message>
    <message>
        <source>One fit of all</source>
        <translation>全部被试的共同拟合</translation>
    </message>
    <message>
        <source>Spread of the participants</source>
        <translation>被试间的离散度</translation>
    </message>
    <message>
        <source>no fit of all: %1</source>
        <translation>没有全部被试的共同拟合：%1</translation>
    </message>
    <message>
        <source>Intensities that can be told apart, from the start of the motor to its full drive</source>
        <translation>从电机启动到满驱动之间可区分的强度</translation>
    </message>
    <message>
        <source>References</source>
        <translation>参考</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>级数</translation>
    </message>
    <message>
        <source>fewer than three times</source>
        <translation>时间值少于三个</translation>
    </message>
    <message>
        <source>the share of yes has no highest point</source>
        <translation>回答“是”的比例没有最高点</translation>
    </message>
    <message>
        <source>the highest point is outside the times that were shown</source>
        <translation>最高点在所呈现的时间范围之外</translation>
    </message>
    <message>
        <source>The time from burst to burst with the most yes, s</source>
        <translation>回答“是”最多时相邻短振的间隔时间，s</translation>
    </message>
    <message>
        <source>Best</source>
        <translation>最佳</translation>
    </message>
    <message>
        <source>Sensitivity d&apos; and criterion c over all levels</source>
        <translation>所有刺激水平合计的敏感性 d&apos; 和判断标准 c</translation>
    </message>
    <message>
        <source>Hits</source>
        <translation>击中</translation>
    </message>
    <message>
        <source>False alarms</source>
        <translation>虚报</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>方法</translation>
    </message>
    <message>
        <source>Mean of %1</source>
        <translation>%1 的平均值</translation>
    </message>
    <message>
        <source>as in the data</source>
        <translation>与数据中相同</translation>
    </message>
    <message>
        <source>Thresholds: %1</source>
        <translation>阈值：%1</translation>
    </message>
    <message>
        <source>The threshold is where half of the way from guessing to the most right answers is reached. Unit of the levels: %1.</source>
        <translation>阈值处于猜测水平与最高正确率的正中间。刺激水平的单位：%1。</translation>
    </message>
    <message>
        <source>Thresholds of the participants, and their means with t intervals.</source>
        <translation>各被试的阈值，及其平均值和 t 区间。</translation>
    </message>
</context>
<context>
    <name>ThresholdText</name>
    <message>
        <source>PILOT</source>
        <translation>预试</translation>
    </message>
    <message>
        <source>SIMULATED</source>
        <translation>模拟</translation>
    </message>
    <message>
        <source>level, s</source>
        <translation>刺激水平，s</translation>
    </message>
    <message>
        <source>level</source>
        <translation>刺激水平</translation>
    </message>
    <message>
        <source>level, %1</source>
        <translation>刺激水平，%1</translation>
    </message>
    <message>
        <source>share of yes</source>
        <translation>回答“是”的比例</translation>
    </message>
    <message>
        <source>share of different</source>
        <translation>回答“不同”的比例</translation>
    </message>
    <message>
        <source>share of more</source>
        <translation>回答“更多”的比例</translation>
    </message>
    <message>
        <source>share of right answers</source>
        <translation>正确回答的比例</translation>
    </message>
    <message>
        <source>open</source>
        <comment>end of an interval</comment>
        <translation>开放</translation>
    </message>
    <message>
        <source> (%1 to %2)</source>
        <comment>interval behind a number</comment>
        <translation> (%1 至 %2)</translation>
    </message>
    <message>
        <source>reversal</source>
        <translation>反转点</translation>
    </message>
    <message>
        <source>mean of reversals</source>
        <translation>反转点的平均值</translation>
    </message>
    <message>
        <source>threshold, 95 %</source>
        <translation>阈值，95 %</translation>
    </message>
    <message>
        <source>not fitted: the table does not say what guessing gives</source>
        <translation>未拟合：表中未说明猜测的正确率</translation>
    </message>
    <message>
        <source>no trials</source>
        <translation>没有试次</translation>
    </message>
    <message>
        <source>worse with more of it: are levels or answers swapped?</source>
        <translation>刺激水平越高结果反而越差：水平或回答是否颠倒了？</translation>
    </message>
    <message>
        <source>the answers do not depend on the level</source>
        <translation>回答不随刺激水平变化</translation>
    </message>
    <message>
        <source>below %1%2, the lowest level</source>
        <translation>低于 %1%2，即最低刺激水平</translation>
    </message>
    <message>
        <source>above %1%2, the highest level</source>
        <translation>高于 %1%2，即最高刺激水平</translation>
    </message>
    <message>
        <source>too few levels for a fit; one less is enough with a fixed lapse rate</source>
        <translation>刺激水平过少，无法拟合；固定失误率时可少一个</translation>
    </message>
    <message>
        <source>no level is above 0</source>
        <translation>没有大于 0 的刺激水平</translation>
    </message>
    <message>
        <source>equal at %1</source>
        <translation>在 %1 处相等</translation>
    </message>
    <message>
        <source>threshold %1</source>
        <translation>阈值 %1</translation>
    </message>
    <message>
        <source>a step between two levels, without a threshold</source>
        <translation>两个刺激水平之间的阶跃，没有阈值</translation>
    </message>
    <message>
        <source>, just noticeable %1</source>
        <translation>，最小可觉差 %1</translation>
    </message>
    <message>
        <source>; a step between two levels</source>
        <translation>；两个刺激水平之间的阶跃</translation>
    </message>
    <message>
        <source>; many lapses, or no upper end</source>
        <translation>；失误较多，或没有上端</translation>
    </message>
    <message>
        <source>the curve does not fit: p of the deviance %1</source>
        <translation>曲线不拟合：偏差的 p 为 %1</translation>
    </message>
    <message>
        <source>trial</source>
        <translation>试次</translation>
    </message>
    <message>
        <source>right</source>
        <translation>正确</translation>
    </message>
    <message>
        <source>felt</source>
        <comment>answer: yes, different, more</comment>
        <translation>感觉到</translation>
    </message>
    <message>
        <source>wrong</source>
        <translation>错误</translation>
    </message>
    <message>
        <source>not felt</source>
        <comment>answer: no, same, less</comment>
        <translation>未感觉到</translation>
    </message>
    <message>
        <source>thresholds</source>
        <translation>阈值</translation>
    </message>
    <message>
        <source>participants</source>
        <translation>被试</translation>
    </message>
    <message>
        <source>mean, 95 %</source>
        <translation>平均值，95 %</translation>
    </message>
    <message>
        <source>d&apos;, c</source>
        <translation>d&apos;，c</translation>
    </message>
    <message>
        <source>d&apos;, 95 %</source>
        <translation>d&apos;，95 %</translation>
    </message>
    <message>
        <source>c (above 0: rather no)</source>
        <translation>c（大于 0：偏向“否”）</translation>
    </message>
    <message>
        <source>mean</source>
        <translation>平均值</translation>
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
        <translation>缓入</translation>
    </message>
    <message>
        <source>ease out</source>
        <translation>缓出</translation>
    </message>
    <message>
        <source>ease in and out</source>
        <translation>缓入缓出</translation>
    </message>
    <message>
        <source>linear</source>
        <translation>线性</translation>
    </message>
    <message>
        <source>Motor %1 at %2°
%3 s: %4 %, %5 Hz</source>
        <translation>电机 %1，位于 %2°
%3 s：%4 %，%5 Hz</translation>
    </message>
    <message>
        <source>%1: %2 to %3 s</source>
        <translation>%1：%2 至 %3 s</translation>
    </message>
    <message>
        <source>Cu&amp;t</source>
        <translation>剪切(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>复制(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Paste in place</source>
        <translation>原位粘贴(&amp;P)</translation>
    </message>
    <message>
        <source>Paste at play&amp;head</source>
        <translation>粘贴到播放头(&amp;H)</translation>
    </message>
    <message>
        <source>&amp;Duplicate</source>
        <translation>创建副本(&amp;D)</translation>
    </message>
    <message>
        <source>De&amp;lete</source>
        <translation>删除(&amp;L)</translation>
    </message>
    <message>
        <source>commanded</source>
        <translation>指令</translation>
    </message>
    <message>
        <source>predicted (assumed motors)</source>
        <translation>预测（假定的电机）</translation>
    </message>
    <message>
        <source>predicted</source>
        <translation>预测</translation>
    </message>
    <message>
        <source>the motor cannot follow</source>
        <translation>电机无法跟随</translation>
    </message>
    <message>
        <source>zoom in to see what the motors do</source>
        <translation>放大以查看电机的动作</translation>
    </message>
    <message>
        <source>Sweep</source>
        <translation>扫动</translation>
    </message>
    <message>
        <source>Ring</source>
        <translation>环绕</translation>
    </message>
    <message>
        <source>Phantom</source>
        <translation>幻象</translation>
    </message>
    <message>
        <source>Ramp</source>
        <translation>斜坡</translation>
    </message>
    <message>
        <source>Pulse train</source>
        <translation>脉冲串</translation>
    </message>
    <message>
        <source>Stroke</source>
        <translation>笔画</translation>
    </message>
    <message>
        <source>Δ %1 %, rms %2 %</source>
        <translation>Δ %1 %，rms %2 %</translation>
    </message>
    <message>
        <source>O&amp;verdrive: make the motors start faster</source>
        <translation>过驱动(&amp;V)：帮助电机起动</translation>
    </message>
</context>
<context>
    <name>TomlEdit</name>
    <message>
        <source>there is no place for the key &quot;%1&quot;</source>
        <translation>键“%1”没有位置</translation>
    </message>
    <message>
        <source>the entry&apos;s number or name, and a key in it</source>
        <translation>条目的编号或名称，以及其中的键</translation>
    </message>
    <message>
        <source>a number from 0 to %1</source>
        <translation>0 到 %1 的编号</translation>
    </message>
    <message>
        <source>tables of the file, with dots between them</source>
        <translation>文件中的表，用点分隔</translation>
    </message>
</context>
<context>
    <name>TomlReader</name>
    <message>
        <source>one of: %1</source>
        <translation>以下之一：%1</translation>
    </message>
    <message>
        <source>a number above %1, at most %2</source>
        <translation>大于 %1、至多 %2 的数</translation>
    </message>
    <message>
        <source>a number from %1 to %2</source>
        <translation>%1 至 %2 的数</translation>
    </message>
    <message>
        <source>a number above %1</source>
        <translation>大于 %1 的数</translation>
    </message>
    <message>
        <source>a number of at least %1</source>
        <translation>至少为 %1 的数</translation>
    </message>
    <message>
        <source>a number of at most %1</source>
        <translation>至多为 %1 的数</translation>
    </message>
    <message>
        <source>a number or nan</source>
        <translation>数或 nan</translation>
    </message>
    <message>
        <source>a finite number</source>
        <translation>有限数</translation>
    </message>
    <message>
        <source>wrong type for &quot;%1&quot;</source>
        <translation>“%1”的类型错误</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is out of range: %2</source>
        <translation>“%1”超出范围：%2</translation>
    </message>
    <message>
        <source>a text in quotes</source>
        <translation>带引号的文本</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is empty</source>
        <translation>“%1”为空</translation>
    </message>
    <message>
        <source>a whole number from %1 to %2</source>
        <translation>%1 至 %2 的整数</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has no unit in its name</source>
        <translation>“%1”的名称中没有单位</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has another unit in its name</source>
        <translation>“%1”的名称中带有另一个单位</translation>
    </message>
    <message>
        <source>unknown key &quot;%1&quot;; perhaps &quot;%2&quot; is meant</source>
        <translation>未知的键“%1”；或许应为“%2”</translation>
    </message>
    <message>
        <source>unknown key &quot;%1&quot;</source>
        <translation>未知的键“%1”</translation>
    </message>
    <message>
        <source>not valid TOML: %1</source>
        <translation>不是有效的 TOML：%1</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>true 或 false</translation>
    </message>
    <message>
        <source>unknown value &quot;%1&quot; of &quot;%2&quot;</source>
        <translation>“%2”的值“%1”未知</translation>
    </message>
    <message>
        <source>unknown value &quot;%1&quot; of &quot;%2&quot;; perhaps &quot;%3&quot; is meant</source>
        <translation>“%2”的值“%1”未知；或许应为“%3”</translation>
    </message>
    <message>
        <source>a table: [%1]</source>
        <translation>表：[%1]</translation>
    </message>
    <message>
        <source>tables: [[%1]] or %1 = [{...}]</source>
        <translation>多个表：[[%1]] 或 %1 = [{...}]</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has too few entries</source>
        <translation>“%1”的条目过少</translation>
    </message>
    <message>
        <source>at least %1</source>
        <translation>至少 %1</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is missing</source>
        <translation>缺少“%1”</translation>
    </message>
    <message>
        <source>&quot;%1&quot; and &quot;%2&quot; are the same key</source>
        <translation>“%1”和“%2”是同一个键</translation>
    </message>
    <message>
        <source>one of them</source>
        <translation>其中之一</translation>
    </message>
    <message>
        <source>the file is too large</source>
        <translation>文件太大</translation>
    </message>
    <message>
        <source>at most %1 MiB</source>
        <translation>最多 %1 MiB</translation>
    </message>
    <message>
        <source>the keys are nested too deeply</source>
        <translation>键嵌套过深</translation>
    </message>
    <message>
        <source>at most %1 levels</source>
        <translation>最多 %1 层</translation>
    </message>
    <message>
        <source>a list of %1 lists, each of %2 numbers</source>
        <translation>含 %1 个列表的列表，每个列表含 %2 个数</translation>
    </message>
    <message>
        <source>a list of texts in quotes</source>
        <translation>带引号的文本的列表</translation>
    </message>
    <message>
        <source>a list of one or more values</source>
        <translation>含一个或多个值的列表</translation>
    </message>
    <message>
        <source>a number, a text in quotes, or true or false</source>
        <translation>数字、带引号的文本，或 true 或 false</translation>
    </message>
    <message>
        <source>a list of lists, each of %1 numbers</source>
        <translation>列表的列表，每个含 %1 个数</translation>
    </message>
</context>
<context>
    <name>TopicFeedText</name>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>%1 is silent</source>
        <translation>%1 没有数据</translation>
    </message>
    <message>
        <source>nobody publishes %1</source>
        <translation>没有程序发布 %1</translation>
    </message>
</context>
<context>
    <name>TouchTexts</name>
    <message>
        <source>sponge</source>
        <translation>海绵</translation>
    </message>
    <message>
        <source>rubber sponge</source>
        <translation>橡胶海绵</translation>
    </message>
    <message>
        <source>rubber</source>
        <translation>橡胶</translation>
    </message>
    <message>
        <source>wood</source>
        <translation>木材</translation>
    </message>
    <message>
        <source>metal</source>
        <translation>金属</translation>
    </message>
    <message>
        <source>circle</source>
        <translation>圆</translation>
    </message>
    <message>
        <source>rectangle</source>
        <translation>矩形</translation>
    </message>
    <message>
        <source>triangle</source>
        <translation>三角形</translation>
    </message>
    <message>
        <source>arc</source>
        <translation>圆弧</translation>
    </message>
    <message>
        <source>line</source>
        <translation>直线</translation>
    </message>
    <message>
        <source>point</source>
        <translation>点</translation>
    </message>
    <message>
        <source>unknown shape</source>
        <translation>未知形状</translation>
    </message>
    <message>
        <source>SAFE</source>
        <translation>安全</translation>
    </message>
    <message>
        <source>DANGER</source>
        <translation>危险</translation>
    </message>
    <message>
        <source>two points</source>
        <translation>两点法</translation>
    </message>
    <message>
        <source>regression</source>
        <translation>回归法</translation>
    </message>
    <message>
        <source>The readings of angle or torque are not usable numbers. Check the arm&apos;s sensors.</source>
        <translation>角度或力矩的读数不可用。请检查机械臂的传感器。</translation>
    </message>
    <message>
        <source>The noise of the arm&apos;s readings is set below zero.</source>
        <translation>机械臂读数的噪声被设为负值。</translation>
    </message>
    <message>
        <source>The torque window is empty: its upper end must lie above its lower end.</source>
        <translation>力矩窗口为空：其上限必须高于下限。</translation>
    </message>
    <message>
        <source>No joint samples came in during the touch.</source>
        <translation>触碰期间没有收到关节样本。</translation>
    </message>
    <message>
        <source>The torque did not change within the torque window. Press with rising force.</source>
        <translation>力矩在力矩窗口内没有变化。请以逐渐增大的力按压。</translation>
    </message>
    <message>
        <source>The joint turned against the rising torque: the object moved, or a sign is wrong.</source>
        <translation>关节逆着上升的力矩转动：物体发生了移动，或符号有误。</translation>
    </message>
    <message>
        <source>shoulder roll</source>
        <translation>肩部横滚</translation>
    </message>
    <message>
        <source>shoulder pitch</source>
        <translation>肩部俯仰</translation>
    </message>
    <message>
        <source>shoulder yaw</source>
        <translation>肩部偏航</translation>
    </message>
    <message>
        <source>elbow pitch</source>
        <translation>肘部俯仰</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>已停止</translation>
    </message>
    <message>
        <source>held</source>
        <translation>保持</translation>
    </message>
    <message>
        <source>program</source>
        <translation>程序</translation>
    </message>
    <message>
        <source>jog</source>
        <translation>点动</translation>
    </message>
    <message>
        <source>N/m</source>
        <translation>N/m</translation>
    </message>
    <message>
        <source>at least %1 (95 %)</source>
        <translation>至少 %1 (95 %)</translation>
    </message>
    <message>
        <source>%1 … rigid</source>
        <translation>%1 … 刚性</translation>
    </message>
    <message>
        <source>%1 … %2</source>
        <translation>%1 … %2</translation>
    </message>
    <message>
        <source>The touch was too quick: the arm&apos;s own inertia was felt with the object. Press slower.</source>
        <translation>触碰过快：机械臂自身的惯性与物体一起被感觉到。请放慢按压。</translation>
    </message>
    <message>
        <source>joint %1</source>
        <translation>关节 %1</translation>
    </message>
    <message>
        <source>%1 (%2 %)</source>
        <comment>a recognised shape and its confidence</comment>
        <translation>%1 (%2 %)</translation>
    </message>
    <message>
        <source>%1 or %2</source>
        <comment>recognised shapes</comment>
        <translation>%1 或 %2</translation>
    </message>
    <message>
        <source>The touch was too quick: fewer than 20 independent samples lie in the torque window. Press slower.</source>
        <translation>触碰过快：力矩窗口内的独立样本少于 20 个。请放慢按压。</translation>
    </message>
    <message>
        <source>One step of the torque reading is over a tenth of the window.</source>
        <translation>力矩读数的一个步长超过窗口的十分之一。</translation>
    </message>
    <message>
        <source>One step of the angle reading is over a tenth of the rotation.</source>
        <translation>角度读数的一个步长超过转角的十分之一。</translation>
    </message>
    <message>
        <source>The free joint has a torque; it was taken off.</source>
        <translation>自由关节存在力矩，已扣除。</translation>
    </message>
    <message>
        <source>The torque of the free joint changes; the change was taken off.</source>
        <translation>自由关节的力矩有变化，该变化已扣除。</translation>
    </message>
    <message>
        <source>The stiffness changes within the torque window.</source>
        <translation>刚度在力矩窗口内发生变化。</translation>
    </message>
    <message>
        <source>The force depends on how quickly the object is pressed.</source>
        <translation>力取决于按压物体的快慢。</translation>
    </message>
    <message>
        <source>The joint that presses feels nothing of a touch on its axis or along it, or the link&apos;s stiffness is not set. Touch from another side.</source>
        <translation>按压的关节感觉不到位于其轴上或沿其轴的接触，或者未设置连杆刚度。请从另一侧触碰。</translation>
    </message>
    <message>
        <source>The joint that presses felt too little: its torque did not reach the torque window. Press harder, or from another side.</source>
        <translation>按压的关节感觉到的太少：其力矩未达到力矩窗口。请用力按压，或从另一侧按压。</translation>
    </message>
    <message>
        <source>The arm measures no joint torques, so the touch has a place but no stiffness.</source>
        <translation>机械臂不测量关节力矩，因此接触有位置，但没有刚度。</translation>
    </message>
    <message>
        <source>The torque jumps or falls back, or the joint has play.</source>
        <translation>力矩跳变或回落，或关节有间隙。</translation>
    </message>
    <message>
        <source>The noise is correlated; the interval allows for it.</source>
        <translation>噪声存在相关；区间已考虑这一点。</translation>
    </message>
</context>
<context>
    <name>TrackCommand</name>
    <message>
        <source>%1 of %2 frames could not be used. The last reason: %3</source>
        <translation>%2 帧中有 %1 帧无法使用。最近一次的原因：%3</translation>
    </message>
    <message>
        <source>Video, pattern of numbered images (frame_%04d.png) or number of a camera; nothing touches the tube in the first frame</source>
        <translation>视频、编号图像的格式 (frame_%04d.png) 或相机编号；第一帧中没有物体接触软管</translation>
    </message>
    <message>
        <source>Camera file, as calibrate writes it</source>
        <translation>calibrate 写出的相机文件</translation>
    </message>
    <message>
        <source>the video has no frame that can be decoded</source>
        <translation>视频中没有可解码的帧</translation>
    </message>
    <message>
        <source>Find contacts on the soft tube in a video or live from a camera</source>
        <translation>视频中或相机前软管上的接触</translation>
    </message>
    <message>
        <source>How contacts are found; the more exact, the slower</source>
        <translation>接触的检测方式：越精确用时越长</translation>
    </message>
    <message>
        <source>Frames missing according to their time stamps: %1</source>
        <translation>按时间戳判断缺失的帧：%1</translation>
    </message>
    <message>
        <source>the camera has stopped sending frames</source>
        <translation>相机不再提供帧</translation>
    </message>
</context>
<context>
    <name>TradeoffCommand</name>
    <message>
        <source>there is no ladder &quot;%1&quot; (expected %2)</source>
        <translation>没有阶梯“%1”（应为 %2）</translation>
    </message>
    <message>
        <source>Measure on this machine what accuracy costs in time</source>
        <translation>在本机上测量精度的时间代价</translation>
    </message>
    <message>
        <source>Ladders of --list; otherwise all of them</source>
        <translation>--list 中的阶梯；默认为全部</translation>
    </message>
    <message>
        <source>List the ladders</source>
        <translation>列出阶梯</translation>
    </message>
    <message>
        <source>Folder for tradeoff.csv and a picture of each ladder (SVG)</source>
        <translation>存放 tradeoff.csv 和各阶梯图片 (SVG) 的文件夹</translation>
    </message>
    <message>
        <source>Refuse the times of a rung when the machine ran more unevenly than this meanwhile, in percent</source>
        <translation>若期间机器的运行波动超过此百分比，则拒绝该档级的时间</translation>
    </message>
    <message numerus="yes">
        <source>the machine was too busy: the times of %n rung(s) were refused</source>
        <translation>
            <numerusform>机器过于繁忙：%n 个档级的时间被拒绝</numerusform>
        </translation>
    </message>
    <message>
        <source>a spread of at most %1 %; close other programs, or see --largest-spread</source>
        <translation>至多 %1 % 的离散度；请关闭其他程序，或参见 --largest-spread</translation>
    </message>
    <message>
        <source>refused</source>
        <translation>被拒绝</translation>
    </message>
    <message>
        <source>rung</source>
        <translation>档级</translation>
    </message>
    <message>
        <source>parameter</source>
        <translation>参数</translation>
    </message>
    <message>
        <source>mean error</source>
        <translation>平均误差</translation>
    </message>
    <message>
        <source>95 %</source>
        <translation>95 %</translation>
    </message>
    <message>
        <source>worst</source>
        <translation>最差</translation>
    </message>
    <message>
        <source>median time</source>
        <translation>中位时间</translation>
    </message>
    <message>
        <source>99 %</source>
        <translation>99 %</translation>
    </message>
    <message>
        <source>samples</source>
        <translation>样本</translation>
    </message>
    <message>
        <source>spread</source>
        <translation>离散度</translation>
    </message>
    <message>
        <source>* no other rung is both as quick and as exact. Measured in %1 s.</source>
        <translation>* 没有其他档级能同样快且同样精确。测量用时 %1 s。</translation>
    </message>
    <message>
        <source>the folder cannot be made</source>
        <translation>无法创建文件夹</translation>
    </message>
    <message>
        <source>Calls of a few microseconds are timed together; their 99 % is one of means.</source>
        <translation>几微秒的调用会合在一起计时，其 99 % 是均值的 99 %。</translation>
    </message>
    <message>
        <source>Fastest: %1, %2 times the limit (%3: %4).</source>
        <translation>最快：%1，为极限（%3：%4）的 %2 倍。</translation>
    </message>
</context>
<context>
    <name>TransferText</name>
    <message>
        <source>Fewer than 4 participants do not show how much people differ, so there is only a bound.</source>
        <translation>被试少于 4 名时看不出个体差异，因此只给出界限。</translation>
    </message>
    <message>
        <source>With fewer than 20 trials a pattern, or 4 k² for k patterns, there is only a bound.</source>
        <translation>每个模式少于 20 次试次，或 k 个模式少于 4 k² 次时，只给出界限。</translation>
    </message>
    <message>
        <source>Nearly all answers to each pattern are the same; fewer than 10 differ, so there is only a bound.</source>
        <translation>对每个模式的回答几乎全都相同，不同的少于 10 个，因此只给出界限。</translation>
    </message>
    <message>
        <source>The answers do not differ from guesses (G test, p ≥ 0.05), so there is only a bound.</source>
        <translation>回答与猜测无差异（G 检验，p ≥ 0.05），因此只给出界限。</translation>
    </message>
</context>
<context>
    <name>TrialLines</name>
    <message>
        <source>✓ right</source>
        <translation>✓ 正确</translation>
    </message>
    <message>
        <source>✗ wrong</source>
        <translation>✗ 错误</translation>
    </message>
    <message>
        <source>no answer</source>
        <translation>未回答</translation>
    </message>
    <message>
        <source>aborted</source>
        <translation>已中止</translation>
    </message>
    <message>
        <source>practice %1</source>
        <translation>练习 %1</translation>
    </message>
    <message>
        <source>test %1</source>
        <translation>测试 %1</translation>
    </message>
    <message>
        <source>%1: %2 %3</source>
        <comment>track, level, unit</comment>
        <translation>%1：%2 %3</translation>
    </message>
    <message>
        <source>interrupted, repeated later</source>
        <translation>已中断，稍后重新呈现</translation>
    </message>
</context>
<context>
    <name>TriggerOpener</name>
    <message>
        <source>this is no trigger device</source>
        <translation>这不是触发设备</translation>
    </message>
    <message>
        <source>a serial port such as /dev/ttyUSB0, or HOST:PORT for OSC</source>
        <translation>串口，例如 /dev/ttyUSB0，或用于 OSC 的 HOST:PORT</translation>
    </message>
</context>
<context>
    <name>UnitAxesText</name>
    <message>
        <source>value</source>
        <translation>值</translation>
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
        <translation>含有文档类型声明</translation>
    </message>
    <message>
        <source>a plain URDF</source>
        <translation>纯 URDF</translation>
    </message>
    <message>
        <source>this is xacro, not URDF</source>
        <translation>这是 xacro，不是 URDF</translation>
    </message>
    <message>
        <source>the expanded text: xacro FILE &gt; robot.urdf</source>
        <translation>展开后的文本：xacro FILE &gt; robot.urdf</translation>
    </message>
    <message>
        <source>the document is &apos;%1&apos;</source>
        <translation>文档为“%1”</translation>
    </message>
    <message>
        <source>&lt;robot name=&quot;...&quot;&gt;</source>
        <translation>&lt;robot name=&quot;...&quot;&gt;</translation>
    </message>
    <message>
        <source>elements are nested more than %1 deep</source>
        <translation>元素嵌套超过 %1 层</translation>
    </message>
    <message>
        <source>&lt;robot&gt; with &lt;link&gt; and &lt;joint&gt;</source>
        <translation>含 &lt;link&gt; 和 &lt;joint&gt; 的 &lt;robot&gt;</translation>
    </message>
    <message>
        <source>a well-formed XML document</source>
        <translation>格式正确的 XML 文档</translation>
    </message>
    <message>
        <source>some links hang on themselves</source>
        <translation>有些连杆连接到自身</translation>
    </message>
    <message>
        <source>a tree of links</source>
        <translation>连杆构成的树</translation>
    </message>
    <message>
        <source>link &apos;%1&apos;: %2</source>
        <translation>连杆“%1”：%2</translation>
    </message>
    <message>
        <source>joint &apos;%1&apos;: %2</source>
        <translation>关节“%1”：%2</translation>
    </message>
    <message>
        <source>numbers from -%1 to %1</source>
        <translation>-%1 至 %1 的数</translation>
    </message>
    <message>
        <source>a number of its inertial is out of range</source>
        <translation>其 inertial 中有数值超出范围</translation>
    </message>
    <message>
        <source>its mass is negative</source>
        <translation>其质量为负</translation>
    </message>
    <message>
        <source>0 kg or more</source>
        <translation>0 kg 或更大</translation>
    </message>
    <message>
        <source>a number of its visual is out of range</source>
        <translation>其 visual 中有数值超出范围</translation>
    </message>
    <message>
        <source>it is floating or planar</source>
        <translation>其类型为 floating 或 planar</translation>
    </message>
    <message>
        <source>revolute, continuous, prismatic or fixed</source>
        <translation>revolute、continuous、prismatic 或 fixed</translation>
    </message>
    <message>
        <source>a number of its origin is out of range</source>
        <translation>其 origin 中有数值超出范围</translation>
    </message>
    <message>
        <source>its axis has no direction</source>
        <translation>其轴没有方向</translation>
    </message>
    <message>
        <source>&lt;axis xyz=&quot;...&quot;&gt; other than 0 0 0</source>
        <translation>&lt;axis xyz=&quot;...&quot;&gt;，不为 0 0 0</translation>
    </message>
    <message>
        <source>it has no limits</source>
        <translation>没有极限</translation>
    </message>
    <message>
        <source>&lt;limit lower= upper= effort= velocity=&gt;</source>
        <translation>&lt;limit lower= upper= effort= velocity=&gt;</translation>
    </message>
    <message>
        <source>a number of its limits is out of range</source>
        <translation>其极限中有数值超出范围</translation>
    </message>
    <message>
        <source>a limit of velocity or effort is negative</source>
        <translation>velocity 或 effort 的极限为负</translation>
    </message>
    <message>
        <source>0 or more</source>
        <translation>0 或更大</translation>
    </message>
    <message>
        <source>its lower limit lies above the upper one</source>
        <translation>其下限高于上限</translation>
    </message>
    <message>
        <source>lower &lt;= upper</source>
        <translation>lower &lt;= upper</translation>
    </message>
    <message>
        <source>it mimics itself</source>
        <translation>它 mimic 自身</translation>
    </message>
    <message>
        <source>a mimic of another joint</source>
        <translation>对另一个关节的 mimic</translation>
    </message>
    <message>
        <source>it mimics &apos;%1&apos;, which does not exist</source>
        <translation>它 mimic 的“%1”不存在</translation>
    </message>
    <message>
        <source>the name of a joint</source>
        <translation>关节的名称</translation>
    </message>
    <message>
        <source>a number of its mimic is out of range</source>
        <translation>其 mimic 中有数值超出范围</translation>
    </message>
    <message>
        <source>the text has %1 bytes</source>
        <translation>文本有 %1 字节</translation>
    </message>
    <message>
        <source>at most %1</source>
        <translation>至多 %1</translation>
    </message>
    <message>
        <source>this is not a robot</source>
        <translation>这不是机器人</translation>
    </message>
    <message>
        <source>a tree of links and joints, http://wiki.ros.org/urdf/XML</source>
        <translation>连杆和关节构成的树，http://wiki.ros.org/urdf/XML</translation>
    </message>
    <message>
        <source>the file does not exist</source>
        <translation>文件不存在</translation>
    </message>
    <message>
        <source>a URDF file</source>
        <translation>URDF 文件</translation>
    </message>
    <message>
        <source>this is not a file</source>
        <translation>这不是文件</translation>
    </message>
    <message>
        <source>the file has %1 bytes</source>
        <translation>文件有 %1 字节</translation>
    </message>
    <message>
        <source>this cannot be read as a robot (%1)</source>
        <translation>无法作为机器人读取（%1）</translation>
    </message>
</context>
<context>
    <name>ValidatorText</name>
    <message>
        <source>%1 is given, %2 is expected</source>
        <translation>给出的是 %1，应为 %2</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>数</translation>
    </message>
    <message>
        <source>a number other than 0</source>
        <translation>非 0 的数</translation>
    </message>
    <message>
        <source>a number above 0</source>
        <translation>大于 0 的数</translation>
    </message>
    <message>
        <source>a number from %1 to %2</source>
        <translation>%1 至 %2 的数</translation>
    </message>
    <message>
        <source>a whole number from 0 to %1</source>
        <translation>0 至 %1 的整数</translation>
    </message>
</context>
<context>
    <name>VisionText</name>
    <message>
        <source>The frame could not be decoded.</source>
        <translation>无法解码该帧。</translation>
    </message>
    <message>
        <source>The image is too small to show printed dots: %1 x %2 pixels.</source>
        <translation>图像过小，无法显示印刷圆点：%1 x %2 像素。</translation>
    </message>
    <message>
        <source>at least %1 pixels on each side</source>
        <translation>每边至少 %1 像素</translation>
    </message>
    <message>
        <source>The image shows no printed dots on the skin (%1 found).</source>
        <translation>图像中没有显示皮肤上的印刷圆点（找到 %1 个）。</translation>
    </message>
    <message>
        <source>a frame in focus, in which nothing touches the skin</source>
        <translation>对焦清晰且没有物体接触皮肤的一帧</translation>
    </message>
    <message>
        <source>The printed dots are too faint to be followed.</source>
        <translation>印刷圆点过淡，无法跟踪。</translation>
    </message>
    <message>
        <source>The frame does not show the skin: %1 of %2 dots found.</source>
        <translation>该帧没有显示皮肤：%2 个圆点中找到 %1 个。</translation>
    </message>
    <message>
        <source>The image is too small for optical flow: %1 x %2 pixels.</source>
        <translation>图像过小，无法计算光流：%1 x %2 像素。</translation>
    </message>
    <message>
        <source>There is no frame of the untouched skin to compare with.</source>
        <translation>没有未接触皮肤的帧可供比较。</translation>
    </message>
    <message>
        <source>The frame has %1 x %2 pixels.</source>
        <translation>该帧为 %1 x %2 像素。</translation>
    </message>
    <message>
        <source>%1 x %2 pixels, as in the camera&apos;s calibration</source>
        <translation>%1 x %2 像素，与相机标定时相同</translation>
    </message>
    <message>
        <source>The camera was closed before it was ready.</source>
        <translation>相机在就绪之前已被关闭。</translation>
    </message>
    <message>
        <source>The camera does not see the skin.</source>
        <translation>相机看不到皮肤。</translation>
    </message>
    <message>
        <source>The image shows no pattern on the skin that could be tracked.</source>
        <translation>图像中的皮肤上没有可观察其移动的花纹。</translation>
    </message>
    <message>
        <source>The image cannot be processed: %1</source>
        <translation>无法处理该图像：%1</translation>
    </message>
    <message>
        <source>There is not enough memory for images of this size.</source>
        <translation>内存不足，无法处理此尺寸的图像。</translation>
    </message>
</context>
<context>
    <name>WorkProgress</name>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
</context>
<context>
    <name>WtsText</name>
    <message>
        <source>&quot;%1&quot; is not the address of a tactile array</source>
        <translation>“%1”不是触觉阵列的地址</translation>
    </message>
    <message>
        <source>the path of a serial port, or tcp://HOST:PORT</source>
        <translation>串口路径，或 tcp://HOST:PORT</translation>
    </message>
    <message>
        <source>success</source>
        <translation>成功</translation>
    </message>
    <message>
        <source>not available</source>
        <translation>不可用</translation>
    </message>
    <message>
        <source>no sensor connected</source>
        <translation>未连接传感器</translation>
    </message>
    <message>
        <source>not initialised</source>
        <translation>未初始化</translation>
    </message>
    <message>
        <source>already running</source>
        <translation>已在运行</translation>
    </message>
    <message>
        <source>not supported</source>
        <translation>不支持</translation>
    </message>
    <message>
        <source>inconsistent data</source>
        <translation>数据不一致</translation>
    </message>
    <message>
        <source>read error in the sensor</source>
        <translation>传感器读取错误</translation>
    </message>
    <message>
        <source>write error in the sensor</source>
        <translation>传感器写入错误</translation>
    </message>
    <message>
        <source>wrong checksum</source>
        <translation>校验和错误</translation>
    </message>
    <message>
        <source>unknown command</source>
        <translation>未知命令</translation>
    </message>
    <message>
        <source>wrong format</source>
        <translation>格式错误</translation>
    </message>
    <message>
        <source>access denied</source>
        <translation>拒绝访问</translation>
    </message>
    <message>
        <source>status %1</source>
        <translation>状态 %1</translation>
    </message>
    <message>
        <source>connecting was cancelled</source>
        <translation>连接已取消</translation>
    </message>
    <message>
        <source>an array of 1 to %1 rows and columns whose frame fits into one message</source>
        <translation>1 至 %1 行和列的阵列，且一帧能装入一条消息</translation>
    </message>
    <message>
        <source>the sensor&apos;s cells are %1 mm wide and %2 mm high</source>
        <translation>传感器单元宽 %1 mm，高 %2 mm</translation>
    </message>
    <message>
        <source>the sensor describes its array in %1 bytes</source>
        <translation>传感器用 %1 字节描述其阵列</translation>
    </message>
    <message>
        <source>the 10 bytes of a WTS array</source>
        <translation>WTS 阵列的 10 字节</translation>
    </message>
    <message>
        <source>the sensor sends no frames: %1</source>
        <translation>传感器不发送帧：%1</translation>
    </message>
    <message>
        <source>the sensor does not answer</source>
        <translation>传感器没有应答</translation>
    </message>
    <message>
        <source>the sensor refused a request: %1</source>
        <translation>传感器拒绝了请求：%1</translation>
    </message>
    <message>
        <source>Another array is connected: %1 x %2 cells of %3 mm instead of %4 x %5 cells of %6 mm.</source>
        <translation>连接的是另一个阵列：%1 x %2 个 %3 mm 的单元，而非 %4 x %5 个 %6 mm 的单元。</translation>
    </message>
    <message>
        <source>The sensor has sent no usable frame for %1 s.</source>
        <translation>传感器已有 %1 s 未发送可用的帧。</translation>
    </message>
    <message>
        <source>the sensor reports %1 rows and %2 columns</source>
        <translation>传感器报告其有 %1 行 %2 列</translation>
    </message>
    <message>
        <source>timeout in the sensor</source>
        <translation>传感器超时</translation>
    </message>
    <message>
        <source>cells with a width and a height</source>
        <translation>有宽度和高度的单元</translation>
    </message>
</context>
<context>
    <name>ZipText</name>
    <message>
        <source>the zip archive is damaged</source>
        <translation>zip 压缩包已损坏</translation>
    </message>
    <message>
        <source>a zip archive that is not encrypted</source>
        <translation>未加密的 zip 压缩包</translation>
    </message>
    <message>
        <source>the zip archive has too many files</source>
        <translation>zip 压缩包中的文件过多</translation>
    </message>
    <message>
        <source>at most %1</source>
        <translation>至多 %1</translation>
    </message>
    <message>
        <source>the unpacked zip archive is too large</source>
        <translation>解压后的 zip 内容过大</translation>
    </message>
    <message>
        <source>at most %1 MiB</source>
        <translation>至多 %1 MiB</translation>
    </message>
    <message>
        <source>the zip archive could not be created</source>
        <translation>无法创建 zip 压缩包</translation>
    </message>
</context>
<context>
    <name>teleta::arm_servo::ArmServoPanel</name>
    <message>
        <source>No servo task is possible: %1.</source>
        <translation>无法执行伺服任务：%1。</translation>
    </message>
    <message>
        <source>Hold to move the arm (or Space)</source>
        <translation>按住以移动机械臂（或空格）</translation>
    </message>
    <message>
        <source>Hold to rehearse (or Space)</source>
        <translation>按住以预演（或空格）</translation>
    </message>
    <message>
        <source>%1, %2, force %3</source>
        <comment>a task, whether there is contact</comment>
        <translation>%1，%2，力 %3</translation>
    </message>
    <message>
        <source>%1. Limits that act: %2</source>
        <translation>%1。起作用的限制：%2</translation>
    </message>
    <message>
        <source>Servo task on the arm</source>
        <translation>机械臂的伺服任务</translation>
    </message>
    <message>
        <source>&lt;p&gt;Lets the arm do a task by what its pad feels. The first press is a rehearsal on a shadow of the arm, the second one moves the arm. It moves only while you hold the button, or Space.&lt;/p&gt;</source>
        <translation>&lt;p&gt;让机械臂按触觉垫的感觉完成任务。第一次按下是影子上的预演，第二次按下移动机械臂。只有在您按住按钮或空格键时它才运动。&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Servo task</source>
        <translation>伺服任务</translation>
    </message>
    <message>
        <source>&amp;Task</source>
        <translation>任务(&amp;T)</translation>
    </message>
    <message>
        <source>Force with which the pad presses</source>
        <translation>触觉垫按压的力</translation>
    </message>
    <message>
        <source>Dead-man switch of the servo task</source>
        <translation>伺服任务的使能开关</translation>
    </message>
    <message>
        <source>Dead-man switch: the task runs only while this button or Space is held</source>
        <translation>使能开关：只有按住此按钮或空格键时任务才运行</translation>
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
        <translation>SVG 图片 (*.svg)</translation>
    </message>
    <message>
        <source>PDF document (*.pdf)</source>
        <translation>PDF 文档 (*.pdf)</translation>
    </message>
    <message>
        <source>PNG picture (*.png)</source>
        <translation>PNG 图片 (*.png)</translation>
    </message>
    <message>
        <source>Comma-separated values (*.csv)</source>
        <translation>逗号分隔值 (*.csv)</translation>
    </message>
    <message>
        <source>&amp;Copy picture</source>
        <translation>复制图片(&amp;C)</translation>
    </message>
    <message>
        <source>Copy &amp;data</source>
        <translation>复制数据(&amp;D)</translation>
    </message>
    <message>
        <source>&amp;Save picture…</source>
        <translation>保存图片(&amp;S)…</translation>
    </message>
    <message>
        <source>Save da&amp;ta…</source>
        <translation>保存数据(&amp;T)…</translation>
    </message>
    <message>
        <source>Save picture</source>
        <translation>保存图片</translation>
    </message>
    <message>
        <source>Save data</source>
        <translation>保存数据</translation>
    </message>
</context>
<context>
    <name>teleta::bracelet::BraceletView</name>
    <message>
        <source>Bracelet</source>
        <translation>手环</translation>
    </message>
    <message>
        <source>motor %1: %2 %</source>
        <translation>电机 %1：%2 %</translation>
    </message>
    <message>
        <source>Motor %1 at %2°: %3 %</source>
        <translation>电机 %1，位于 %2°：%3 %</translation>
    </message>
    <message>
        <source>&lt;p&gt;What the six motors of the bracelet are doing, on the unrolled forearm: from left to right once around the arm. The fuller a disc, the stronger the motor vibrates.&lt;/p&gt;&lt;p&gt;With a bracelet connected, hold a disc with the mouse, or one of the keys 1 to 6, to feel that motor alone.&lt;/p&gt;</source>
        <translation>&lt;p&gt;手环的六个电机当前的动作，显示在展开的前臂上：从左到右绕手臂一周。圆盘越满，电机振动越强。&lt;/p&gt;&lt;p&gt;连接手环后，用鼠标按住圆盘，或按住 1 至 6 中的一个键，可单独感受该电机。&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Nothing is playing</source>
        <translation>未在播放</translation>
    </message>
    <message>
        <source>%1: preview</source>
        <comment>a pattern that is not played</comment>
        <translation>%1：预览</translation>
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
        <translation>至 %1 %</translation>
    </message>
    <message>
        <source>Stron&amp;gest</source>
        <translation>最强(&amp;G)</translation>
    </message>
    <message>
        <source>Strongest, all motors</source>
        <translation>最强，所有电机</translation>
    </message>
    <message>
        <source>Each motor</source>
        <translation>每个电机</translation>
    </message>
    <message>
        <source>A limit for each motor</source>
        <translation>每个电机的上限</translation>
    </message>
    <message>
        <source>Motor &amp;%1</source>
        <translation>电机(&amp;%1)</translation>
    </message>
    <message>
        <source>Strongest, motor %1</source>
        <translation>最强，电机 %1</translation>
    </message>
    <message>
        <source>The most that the motors may vibrate, whatever is played. Saved for this bracelet.</source>
        <translation>无论播放、保持还是感受什么，此手环上电机的强度上限。它按手环保存。</translation>
    </message>
</context>
<context>
    <name>teleta::calibrate::FeltPanel</name>
    <message>
        <source>The motors were balanced by feel.</source>
        <translation>已凭感觉平衡各电机。</translation>
    </message>
    <message>
        <source>Motor %1 starts at %2 % of the full drive (95 %: %3 to %4 %).</source>
        <translation>电机 %1 在满驱动的 %2 % 处启动（95 %：%3 至 %4 %）。</translation>
    </message>
    <message>
        <source>Start of motor %1</source>
        <translation>电机 %1 的启动点</translation>
    </message>
    <message>
        <source>%1 answers so far</source>
        <translation>目前 %1 个回答</translation>
    </message>
    <message>
        <source>Play the next burst.</source>
        <translation>播放下一次短振。</translation>
    </message>
    <message>
        <source>Did you feel it?</source>
        <translation>您感觉到了吗？</translation>
    </message>
    <message>
        <source>Was the second burst stronger?</source>
        <translation>第二次短振更强吗？</translation>
    </message>
    <message>
        <source>The bracelet cannot play now: it is not connected, STOP is engaged, or a study uses it.</source>
        <translation>手环现在无法播放：未连接、STOP 已触发，或正被研究使用。</translation>
    </message>
    <message>
        <source>Now and then nothing is played. Answer yes only when you are sure.</source>
        <translation>有时不会播放任何振动。仅在确定时回答“是”。</translation>
    </message>
    <message>
        <source>Guess when you are not sure.</source>
        <translation>不确定时请猜测。</translation>
    </message>
    <message>
        <source>Questions about what is felt</source>
        <translation>关于感觉的提问</translation>
    </message>
    <message>
        <source>Play (Space)</source>
        <translation>播放（空格键）</translation>
    </message>
    <message>
        <source>Yes (Y)</source>
        <translation>是 (Y)</translation>
    </message>
    <message>
        <source>No (N)</source>
        <translation>否 (N)</translation>
    </message>
    <message>
        <source>Take back the last answer (Backspace)</source>
        <translation>撤回上一个回答 (Backspace)</translation>
    </message>
    <message>
        <source>Give up</source>
        <translation>放弃</translation>
    </message>
    <message>
        <source>Leave the motors as they were</source>
        <translation>保持各电机原状</translation>
    </message>
    <message>
        <source>Strength of motor %1, compared with motor 1</source>
        <translation>电机 %1 与电机 1 的强度比较</translation>
    </message>
    <message>
        <source>The answers contradict each other.</source>
        <translation>这些回答互不相符。</translation>
    </message>
    <message>
        <source>Play the burst, as often as you like</source>
        <translation>让短振被感觉到，次数不限</translation>
    </message>
</context>
<context>
    <name>teleta::calibrate::GainsView</name>
    <message>
        <source>%1 of %2 taxels have gains from %3 to %4.</source>
        <translation>%2 个触觉单元中有 %1 个的增益在 %3 至 %4 之间。</translation>
    </message>
    <message numerus="yes">
        <source>%n dead</source>
        <comment>taxels</comment>
        <translation>
            <numerusform>%n 个失效</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n too weak</source>
        <comment>taxels</comment>
        <translation>
            <numerusform>%n 个过弱</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n too strong</source>
        <comment>taxels</comment>
        <translation>
            <numerusform>%n 个过强</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n stuck</source>
        <comment>taxels</comment>
        <translation>
            <numerusform>%n 个卡死</numerusform>
        </translation>
    </message>
    <message>
        <source>Not used: %1.</source>
        <comment>kinds of taxels</comment>
        <translation>不使用：%1。</translation>
    </message>
    <message>
        <source>No array</source>
        <translation>没有阵列</translation>
    </message>
    <message>
        <source>no gains: every taxel counts as it is</source>
        <translation>无增益：每个触觉单元按原值计</translation>
    </message>
    <message>
        <source>gains in use, saved</source>
        <translation>正在使用增益，已保存</translation>
    </message>
    <message>
        <source>gains in use, not saved</source>
        <translation>正在使用增益，未保存</translation>
    </message>
    <message>
        <source>1. The array is tared.</source>
        <translation>1. 阵列已去皮。</translation>
    </message>
    <message>
        <source>2. Press evenly on the whole array, with a bladder or with a plate on foam. The load may change.</source>
        <translation>2. 用充气囊或垫着泡沫的平板均匀按压整个阵列。载荷可以变化。</translation>
    </message>
    <message numerus="yes">
        <source>%n press(es) so far.</source>
        <translation>
            <numerusform>目前 %n 次按压。</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 of %2 taxels are under load.</source>
        <translation>%2 个触觉单元中有 %1 个受载。</translation>
    </message>
    <message>
        <source>Keep pressing: %1 of %2 taxels are under load.</source>
        <translation>请继续按压：%2 个触觉单元中有 %1 个受载。</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>撤销</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>重做</translation>
    </message>
    <message>
        <source>&amp;Load…</source>
        <translation>加载(&amp;L)…</translation>
    </message>
    <message>
        <source>Use no gains and forget all presses</source>
        <translation>不使用增益并清除所有按压</translation>
    </message>
    <message>
        <source>&amp;Save…</source>
        <translation>保存(&amp;S)…</translation>
    </message>
    <message>
        <source>Takes the mean of the next half second as the unloaded state. Nothing may touch the array.</source>
        <translation>取接下来半秒的平均值作为空载状态。期间不得有任何物体接触阵列。</translation>
    </message>
    <message>
        <source>&amp;Collect a press</source>
        <translation>采集一次按压(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;End</source>
        <translation>结束(&amp;E)</translation>
    </message>
    <message>
        <source>Use what has been collected</source>
        <translation>使用已采集的内容</translation>
    </message>
    <message>
        <source>&amp;Open recorded presses…</source>
        <translation>打开已记录的按压(&amp;O)…</translation>
    </message>
    <message>
        <source>Open the &amp;demo</source>
        <translation>打开演示(&amp;D)</translation>
    </message>
    <message>
        <source>A simulated plate presses evenly on an array whose taxels differ</source>
        <translation>模拟的平板均匀按压一个触觉单元各不相同的阵列</translation>
    </message>
    <message>
        <source>Gains of the taxels</source>
        <translation>触觉单元的增益</translation>
    </message>
    <message>
        <source>Share of the press that has been collected</source>
        <translation>已采集的按压比例</translation>
    </message>
    <message>
        <source>Calibration of an array&apos;s taxels</source>
        <translation>阵列触觉单元的标定</translation>
    </message>
    <message>
        <source>The least certain gain has a standard error of %1 %.</source>
        <translation>最不确定的一个精确到 %1 %（标准误差）。</translation>
    </message>
    <message>
        <source>Gains vary by %1 % from press to press.</source>
        <translation>各次按压的增益相差 %1 %。</translation>
    </message>
    <message>
        <source>The response changes by %1 % along x and %2 % along y: the load may have been uneven. Turn the bladder or plate by 180° and collect another press: the difference cancels out.</source>
        <translation>响应沿 x 变化 %1 %，沿 y 变化 %2 %：载荷可能不均匀。请将按压物转半圈再采集一次，差异会相互抵消。</translation>
    </message>
    <message>
        <source>Open an array, a recording or a scene on the page Operate, or the demo.</source>
        <translation>请在“操作”页打开阵列、记录或场景，或在此打开演示。</translation>
    </message>
    <message>
        <source>computing the gains…</source>
        <translation>正在求增益…</translation>
    </message>
    <message>
        <source>1. Tare the array with nothing touching it.</source>
        <translation>1. 不要让任何东西接触阵列，然后去皮。</translation>
    </message>
    <message>
        <source>Undo the last change (Ctrl+Z)</source>
        <translation>撤销上一次更改 (Ctrl+Z)</translation>
    </message>
    <message>
        <source>Redo the change undone last</source>
        <translation>将其恢复</translation>
    </message>
    <message>
        <source>Load gains for an array of this size from a file (CSV)</source>
        <translation>从文件 (CSV) 读取同样大小阵列的增益</translation>
    </message>
    <message>
        <source>Save the gains to a file (CSV) for “Open recording”, source lists and the command line</source>
        <translation>将增益写入文件 (CSV)：“打开记录”、源列表和命令行都能读取</translation>
    </message>
    <message>
        <source>Wait for a load and collect its frames; stops by itself</source>
        <translation>等待载荷并采集其帧；自动结束</translation>
    </message>
    <message>
        <source>Frames as CSV, one file per press: time_s,t0,t1,…</source>
        <translation>CSV 格式的帧，每次按压一个文件：time_s,t0,t1,…</translation>
    </message>
    <message>
        <source>Red taxels read too low and are raised, blue ones are lowered, hatched ones are not used. Point at a taxel, or use the arrow keys, to read its gain.</source>
        <translation>红色触觉单元感受偏小而被调高，蓝色触觉单元被调低，带斜线的不使用。用方向键或鼠标读取单个触觉单元。</translation>
    </message>
    <message>
        <source>Rese&amp;t</source>
        <translation>重置(&amp;T)</translation>
    </message>
    <message>
        <source>Tare &amp;now</source>
        <translation>立即去皮(&amp;N)</translation>
    </message>
    <message>
        <source>Waiting for a load on more than half of the taxels: %1 of %2 now. If the array is pressed already, it was tared under that load: take the load off and tare again.</source>
        <translation>等待一半以上的触觉单元受载：现在 %1 / %2。如果阵列已经受压，说明它是在该载荷下去皮的：请移除载荷并重新去皮。</translation>
    </message>
    <message>
        <source>The taxels differ by %1 % without gains, by %2 % with them.</source>
        <translation>各触觉单元在无增益时相差 %1%，有增益时相差 %2%。</translation>
    </message>
    <message>
        <source>The taxels differ by %1 % under this load.</source>
        <translation>在此载荷下，各触觉单元相差 %1%。</translation>
    </message>
</context>
<context>
    <name>teleta::calibrate::LatencyChart</name>
    <message>
        <source>click</source>
        <translation>咔嗒声</translation>
    </message>
    <message>
        <source>latency</source>
        <translation>延迟</translation>
    </message>
    <message>
        <source>Latency of the clicks: none was heard yet</source>
        <translation>咔嗒声的延迟：尚未听到</translation>
    </message>
    <message>
        <source>Latency of the clicks: %1 ms</source>
        <translation>咔嗒声的延迟：%1 ms</translation>
    </message>
</context>
<context>
    <name>teleta::calibrate::LoadsView</name>
    <message>
        <source>No presses</source>
        <translation>没有按压</translation>
    </message>
    <message>
        <source>computing…</source>
        <translation>正在计算…</translation>
    </message>
    <message>
        <source>no calibration yet</source>
        <translation>尚无标定</translation>
    </message>
    <message>
        <source>calibration saved</source>
        <translation>标定已保存</translation>
    </message>
    <message>
        <source>calibration not saved</source>
        <translation>标定未保存</translation>
    </message>
    <message>
        <source>This one has %1.</source>
        <translation>此表格含 %1。</translation>
    </message>
    <message>
        <source>2. Tick the columns that are signals.</source>
        <translation>2. 勾选作为信号的列。</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>撤销</translation>
    </message>
    <message>
        <source>Undo the last change (Ctrl+Z)</source>
        <translation>撤销上一步更改 (Ctrl+Z)</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>重做</translation>
    </message>
    <message>
        <source>Redo the change undone last</source>
        <translation>重做上一步撤销的更改</translation>
    </message>
    <message>
        <source>&amp;Load…</source>
        <translation>载入(&amp;L)…</translation>
    </message>
    <message>
        <source>Show a calibration from a file (CSV)</source>
        <translation>显示文件（CSV）中的标定</translation>
    </message>
    <message>
        <source>&amp;Save…</source>
        <translation>保存(&amp;S)…</translation>
    </message>
    <message>
        <source>Save the calibration (CSV) for the key “loads” of a sensor&apos;s file and the command line</source>
        <translation>保存标定（CSV），供传感器文件的键“loads”和命令行使用</translation>
    </message>
    <message>
        <source>&amp;Open presses…</source>
        <translation>打开按压(&amp;O)…</translation>
    </message>
    <message>
        <source>A table (CSV) with a row for each press</source>
        <translation>每次按压一行的表格（CSV）</translation>
    </message>
    <message>
        <source>Find the &amp;gains</source>
        <translation>求增益(&amp;G)</translation>
    </message>
    <message>
        <source>Least squares over the presses under load</source>
        <translation>对有载荷的按压做最小二乘</translation>
    </message>
    <message>
        <source>Columns that may be signals</source>
        <translation>可作信号的列</translation>
    </message>
    <message>
        <source>Gains of the signals</source>
        <translation>信号的增益</translation>
    </message>
    <message>
        <source>Load</source>
        <translation>载荷</translation>
    </message>
    <message>
        <source>Signal</source>
        <translation>信号</translation>
    </message>
    <message>
        <source>Gain</source>
        <comment>N per unit of a signal</comment>
        <translation>增益</translation>
    </message>
    <message>
        <source>Standard error</source>
        <translation>标准误差</translation>
    </message>
    <message>
        <source>Presses from</source>
        <comment>a signal</comment>
        <translation>按压自</translation>
    </message>
    <message>
        <source>to</source>
        <comment>a signal</comment>
        <translation>至</translation>
    </message>
    <message>
        <source>The newtons for one unit of each signal will be shown here.</source>
        <translation>每个信号一个单位对应的牛顿将显示在此处。</translation>
    </message>
    <message>
        <source>Calibration of a sensor to newtons</source>
        <translation>将传感器标定为牛顿</translation>
    </message>
    <message>
        <source>%1: residual standard deviation %2.</source>
        <comment>a load</comment>
        <translation>%1：残差标准差 %2。</translation>
    </message>
    <message>
        <source>Condition number of the presses: %1. From %2 on, the signals cannot be told apart.</source>
        <translation>按压的条件数：%1。达到 %2 时，信号无法区分。</translation>
    </message>
    <message>
        <source>1. Open a table (CSV) with one row per press: the signals of the sensor, and the known load in force_n, shear_x_n, shear_y_n or moment_nm. Rows without load give the signals at rest.</source>
        <translation>1. 打开一个每行一次按压的表格 (CSV)：传感器的信号，以及 force_n、shear_x_n、shear_y_n 或 moment_nm 中的已知载荷。无载荷的行给出静止时的信号。</translation>
    </message>
    <message>
        <source>signal</source>
        <translation>信号</translation>
    </message>
    <message>
        <source>No calibration yet</source>
        <translation>尚无校准</translation>
    </message>
</context>
<context>
    <name>teleta::calibrate::MotorChart</name>
    <message>
        <source>Speed of motor %1 over its drive</source>
        <translation>电机 %1 的转速随驱动量的变化</translation>
    </message>
    <message>
        <source>Recording of motor %1, and the model</source>
        <translation>电机 %1 的记录与模型</translation>
    </message>
    <message>
        <source>assumed</source>
        <translation>假定</translation>
    </message>
    <message>
        <source>curve</source>
        <translation>曲线</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>实测</translation>
    </message>
    <message>
        <source>Motor %1: curve and lag are assumed</source>
        <translation>电机 %1：曲线和滞后为假定值</translation>
    </message>
    <message>
        <source>Motor %1</source>
        <translation>电机 %1</translation>
    </message>
    <message>
        <source>%1 % of the variance, residual %2 Hz</source>
        <translation>解释方差的 %1 %，残差 %2 Hz</translation>
    </message>
    <message>
        <source>No recording of this motor yet: measure it, or open a recording.</source>
        <translation>尚无此电机的记录：请测量，或打开一个记录。</translation>
    </message>
    <message>
        <source>measured (simulated)</source>
        <translation>实测（模拟）</translation>
    </message>
    <message>
        <source>model</source>
        <translation>模型</translation>
    </message>
    <message>
        <source>residual</source>
        <translation>残差</translation>
    </message>
    <message>
        <source>drive</source>
        <translation>驱动</translation>
    </message>
    <message>
        <source>speed</source>
        <translation>转速</translation>
    </message>
    <message>
        <source>time</source>
        <translation>时间</translation>
    </message>
</context>
<context>
    <name>teleta::calibrate::MotorTable</name>
    <message>
        <source>assumed</source>
        <translation>假定</translation>
    </message>
    <message>
        <source>by feel</source>
        <translation>凭感觉</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>实测</translation>
    </message>
    <message>
        <source>Motor %1</source>
        <translation>电机 %1</translation>
    </message>
    <message>
        <source>start %1, lag and curve %2</source>
        <comment>where the values come from</comment>
        <translation>启动点：%1，滞后和曲线：%2</translation>
    </message>
    <message>
        <source>Motors of the bracelet</source>
        <translation>手环的电机</translation>
    </message>
    <message>
        <source>Motor</source>
        <translation>电机</translation>
    </message>
    <message>
        <source>Drive at which the motor begins to turn, with its standard error</source>
        <translation>电机开始转动时的驱动量，含标准误</translation>
    </message>
    <message>
        <source>Drive of intensity 1, so that all motors are equally strong</source>
        <translation>强度为 1 时的驱动量，使所有电机强度相同</translation>
    </message>
    <message>
        <source>From rest to 90 % of a speed</source>
        <translation>从静止到转速的 90 %</translation>
    </message>
    <message>
        <source>From a speed to 10 % of it</source>
        <translation>从某一转速降至其 10 %</translation>
    </message>
    <message>
        <source>Speed at the full drive of this motor</source>
        <translation>此电机满驱动时的转速</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>数据源</translation>
    </message>
    <message>
        <source>measured, by feel</source>
        <comment>where the values come from</comment>
        <translation>测量、凭感觉</translation>
    </message>
    <message>
        <source>partly by feel</source>
        <comment>where the values come from</comment>
        <translation>部分凭感觉</translation>
    </message>
    <message>
        <source>partly measured</source>
        <comment>where the values come from</comment>
        <translation>部分测量</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>起动</translation>
    </message>
    <message>
        <source>Full</source>
        <translation>满程</translation>
    </message>
    <message>
        <source>Rise</source>
        <translation>上升</translation>
    </message>
    <message>
        <source>Fall</source>
        <translation>下降</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>转速</translation>
    </message>
</context>
<context>
    <name>teleta::calibrate::MotorsView</name>
    <message>
        <source>Motor %1 was not calibrated. %2</source>
        <comment>a motor, and why not</comment>
        <translation>电机 %1 未标定。%2</translation>
    </message>
    <message>
        <source>Motor %1: starts at %2 to %3 % of the drive, rises in %4 ± %5 ms, falls in %6 ± %7 ms, reaches %8 Hz.</source>
        <translation>电机 %1：在驱动量的 %2 至 %3 % 处启动，上升 %4 ± %5 ms，下降 %6 ± %7 ms，可达 %8 Hz。</translation>
    </message>
    <message>
        <source>No bracelet</source>
        <translation>无手环</translation>
    </message>
    <message>
        <source>Choose a bracelet in the menu Bracelet.</source>
        <translation>请在“手环”菜单中选择手环。</translation>
    </message>
    <message>
        <source>calibrated, saved</source>
        <translation>已标定，已保存</translation>
    </message>
    <message>
        <source>calibrated, not saved</source>
        <translation>已标定，未保存</translation>
    </message>
    <message>
        <source>Motor %1</source>
        <translation>电机 %1</translation>
    </message>
    <message>
        <source>Drive the motor up and down and record it with the bracelet&apos;s sensor</source>
        <translation>驱动电机升降，并用手环的传感器记录</translation>
    </message>
    <message>
        <source>This bracelet has no sensor: open a recording, or answer by feel</source>
        <translation>此手环没有传感器：请打开记录，或凭感觉回答</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>撤销</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>重做</translation>
    </message>
    <message>
        <source>&amp;Load…</source>
        <translation>加载(&amp;L)…</translation>
    </message>
    <message>
        <source>Save a &amp;copy…</source>
        <translation>保存副本(&amp;C)…</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>保存(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Measure this motor</source>
        <translation>测量此电机(&amp;M)</translation>
    </message>
    <message>
        <source>One after another, with the bracelet&apos;s sensor</source>
        <translation>用手环的传感器逐个测量</translation>
    </message>
    <message>
        <source>&amp;Open a recording…</source>
        <translation>打开记录(&amp;O)…</translation>
    </message>
    <message>
        <source>Compare the strength of each motor with that of motor 1</source>
        <translation>将各电机的强度与电机 1 比较</translation>
    </message>
    <message>
        <source>Stop measuring</source>
        <translation>停止测量</translation>
    </message>
    <message>
        <source>Calibration of the bracelet&apos;s motors</source>
        <translation>手环电机的标定</translation>
    </message>
    <message>
        <source>Turning at %1 Hz, measured by the bracelet&apos;s sensor.</source>
        <translation>手环的传感器显示，它目前以 %1 Hz 转动。</translation>
    </message>
    <message>
        <source>All motors use assumed values again. Undo brings the measurements back.</source>
        <translation>所有电机重新采用假定值。撤销可恢复测量结果。</translation>
    </message>
    <message>
        <source>Every measured motor is now limited to the top speed of the slowest one.</source>
        <translation>现在所有已测电机的最高转速都与最慢的电机一致。</translation>
    </message>
    <message>
        <source>Measuring motor %1: steps up to full drive, then pulses.</source>
        <translation>正在测量电机 %1：阶梯升至满驱动，然后是脉冲。</translation>
    </message>
    <message>
        <source>not calibrated: the motors use assumed values</source>
        <translation>未标定：电机采用假定值</translation>
    </message>
    <message>
        <source>a study uses the bracelet: its motors cannot be changed</source>
        <translation>研究正在使用手环：其电机保持原状</translation>
    </message>
    <message>
        <source>Undo the last change or answer (Ctrl+Z)</source>
        <translation>撤回上一次更改或上一个回答 (Ctrl+Z)</translation>
    </message>
    <message>
        <source>Redo the change undone last</source>
        <translation>将其恢复</translation>
    </message>
    <message>
        <source>Load a profile of this bracelet from a file</source>
        <translation>从文件读取此手环的配置</translation>
    </message>
    <message>
        <source>Save the profile to another file</source>
        <translation>将配置写入另一个文件</translation>
    </message>
    <message>
        <source>Discard the measurements</source>
        <translation>清除测量结果</translation>
    </message>
    <message>
        <source>Save the profile for this bracelet: it is used whenever the bracelet is connected</source>
        <translation>保存此手环的配置：每次连接时都会使用</translation>
    </message>
    <message>
        <source>CSV with time_s, commanded, and speed_hz (tachometer) or signal (accelerometer, microphone)</source>
        <translation>CSV，含 time_s,commanded 以及转速计的 speed_hz 或加速度计、麦克风的 signal</translation>
    </message>
    <message>
        <source>Save the &amp;excitation…</source>
        <translation>写出激励信号(&amp;E)…</translation>
    </message>
    <message>
        <source>Save the drive signal of a measurement as CSV, to record with a sensor of your own</source>
        <translation>测量期间给电机的指令，存为 CSV：用于您自备的传感器</translation>
    </message>
    <message>
        <source>Plays weaker and stronger bursts; you say what you felt</source>
        <translation>逐渐变弱和变强的短振；由您说明感觉</translation>
    </message>
    <message>
        <source>Limit all measured motors to the top speed of the slowest</source>
        <translation>使所有已测电机的最高转速与最慢的电机一致</translation>
    </message>
    <message>
        <source>The computer was busy: %1 % of the time has no readings. Measure again with fewer programs running.</source>
        <translation>计算机繁忙：%1 % 的时间没有读数。请减少运行的程序后重新测量。</translation>
    </message>
    <message>
        <source>Measuring motor %1, %2 of %3: steps up to full drive, then pulses.</source>
        <translation>正在测量电机 %1（第 %2 个，共 %3 个）：逐级升至最大驱动，然后是脉冲。</translation>
    </message>
    <message>
        <source>What to do: %1.</source>
        <translation>处理办法：%1。</translation>
    </message>
    <message>
        <source>With its sensor</source>
        <translation>用其传感器</translation>
    </message>
    <message>
        <source>By feel</source>
        <translation>凭感觉</translation>
    </message>
    <message>
        <source>By the curves</source>
        <translation>按曲线</translation>
    </message>
    <message>
        <source>In files</source>
        <translation>用文件</translation>
    </message>
    <message>
        <source>Rese&amp;t</source>
        <translation>重置(&amp;T)</translation>
    </message>
    <message>
        <source>Measure all si&amp;x</source>
        <translation>测量全部六个(&amp;X)</translation>
    </message>
    <message>
        <source>Fi&amp;nd the start by feel</source>
        <translation>凭感觉找启动点(&amp;N)</translation>
    </message>
    <message>
        <source>Balance b&amp;y feel</source>
        <translation>凭感觉平衡(&amp;Y)</translation>
    </message>
    <message>
        <source>Balance by the c&amp;urves</source>
        <translation>按曲线平衡(&amp;U)</translation>
    </message>
    <message numerus="yes">
        <source>%n of %1 motors calibrated, saved</source>
        <translation>
            <numerusform>%1 个电机中已标定 %n 个，已保存</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n of %1 motors calibrated, not saved</source>
        <translation>
            <numerusform>%1 个电机中已标定 %n 个，未保存</numerusform>
        </translation>
    </message>
    <message>
        <source>Curves</source>
        <translation>曲线</translation>
    </message>
    <message>
        <source>Motors</source>
        <translation>电机</translation>
    </message>
</context>
<context>
    <name>teleta::calibrate::StepList</name>
    <message>
        <source>running</source>
        <translation>进行中</translation>
    </message>
    <message>
        <source>not saved</source>
        <comment>a calibration</comment>
        <translation>未保存</translation>
    </message>
    <message>
        <source>done</source>
        <comment>a calibration</comment>
        <translation>完成</translation>
    </message>
    <message>
        <source>failed</source>
        <comment>a calibration</comment>
        <translation>失败</translation>
    </message>
    <message>
        <source>%1 of %2 done</source>
        <translation>已完成 %1/%2</translation>
    </message>
    <message>
        <source>to do</source>
        <comment>a calibration</comment>
        <translation>待做</translation>
    </message>
    <message>
        <source>%1. %2: %3</source>
        <comment>number, name and state of a step</comment>
        <translation>%1. %2：%3</translation>
    </message>
    <message>
        <source>running: %1 of %2</source>
        <translation>进行中：%1/%2</translation>
    </message>
</context>
<context>
    <name>teleta::camera::CameraPanel</name>
    <message>
        <source>Pause</source>
        <translation>暂停</translation>
    </message>
    <message>
        <source>Waiting for a picture of the tube with nothing touching it.</source>
        <translation>等待没有物体接触软管的图像。</translation>
    </message>
    <message>
        <source>No reference yet: %1</source>
        <translation>尚无参考：%1</translation>
    </message>
    <message>
        <source>This finder cannot be used: %1</source>
        <translation>此检测器无法使用：%1</translation>
    </message>
    <message>
        <source>Finder</source>
        <translation>检测器</translation>
    </message>
    <message>
        <source>&amp;Displacement</source>
        <translation>位移(&amp;D)</translation>
    </message>
    <message>
        <source>Show how far the pattern on the skin has moved</source>
        <translation>显示皮肤上的花纹移动了多远</translation>
    </message>
    <message>
        <source>Resume</source>
        <translation>继续</translation>
    </message>
    <message>
        <source>Picture not used: %1</source>
        <translation>未使用：%1</translation>
    </message>
    <message>
        <source>How contacts are found: from the printed dots alone, or with dense flow by one of OpenCV&apos;s presets; the number is how many times the image is reduced</source>
        <translation>接触的检测方式：仅用印刷圆点，或采用 OpenCV 预设之一的稠密光流；数字为图像尺寸的除数</translation>
    </message>
    <message>
        <source>Take the next picture as the reference: nothing may touch the tube</source>
        <translation>将下一幅图像作为未接触软管的图像</translation>
    </message>
    <message>
        <source>Freeze the picture; contacts are still tracked (Space)</source>
        <translation>冻结此图像；接触仍继续跟踪（空格键）</translation>
    </message>
    <message>
        <source>F&amp;inder</source>
        <translation>检测器(&amp;I)</translation>
    </message>
    <message>
        <source>Ne&amp;w reference</source>
        <translation>新参考(&amp;W)</translation>
    </message>
    <message>
        <source>Preparing the finder: %1.</source>
        <translation>正在准备检测器：%1。</translation>
    </message>
</context>
<context>
    <name>teleta::camera::CameraView</name>
    <message>
        <source>camera</source>
        <translation>相机</translation>
    </message>
    <message>
        <source>&amp;Pause the picture</source>
        <translation>暂停画面(&amp;P)</translation>
    </message>
    <message>
        <source>Show &amp;all</source>
        <translation>显示全部(&amp;A)</translation>
    </message>
    <message>
        <source>Camera picture</source>
        <translation>相机图像</translation>
    </message>
    <message>
        <source>&lt;p&gt;What the camera sees inside the tube. Lines show, enlarged, how far the printed pattern has moved since nothing touched the tube; outlines are contacts, each in the colour of its number.&lt;/p&gt;&lt;p&gt;Ctrl+wheel zooms, dragging moves, a double click shows all.&lt;/p&gt;</source>
        <translation>&lt;p&gt;相机在管内看到的画面。线条以放大的方式显示印刷花纹自无接触以来移动的距离；轮廓线表示接触，颜色与其编号对应。&lt;/p&gt;&lt;p&gt;Ctrl+滚轮缩放，拖动平移，双击显示全部。&lt;/p&gt;</translation>
    </message>
    <message>
        <source>&amp;Resume</source>
        <translation>继续(&amp;G)</translation>
    </message>
</context>
<context>
    <name>teleta::camera::EventList</name>
    <message>
        <source>&amp;Clear the list</source>
        <translation>清空列表(&amp;C)</translation>
    </message>
    <message>
        <source>Events</source>
        <translation>事件</translation>
    </message>
</context>
<context>
    <name>teleta::camera::EventModel</name>
    <message>
        <source>touched</source>
        <translation>触碰</translation>
    </message>
    <message>
        <source>BUMP</source>
        <translation>碰撞</translation>
    </message>
    <message>
        <source>arm follows</source>
        <translation>机械臂跟随</translation>
    </message>
    <message>
        <source>reference taken</source>
        <translation>已取参考</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>Event</source>
        <translation>事件</translation>
    </message>
    <message>
        <source>Contact</source>
        <translation>接触</translation>
    </message>
    <message>
        <source>Along the tube</source>
        <translation>沿管</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>深度</translation>
    </message>
    <message>
        <source>released</source>
        <translation>松开</translation>
    </message>
    <message>
        <source>restarted</source>
        <translation>重新开始</translation>
    </message>
    <message>
        <source>Around the tube</source>
        <translation>绕管</translation>
    </message>
    <message>
        <source>Along</source>
        <comment>the tube</comment>
        <translation>轴向</translation>
    </message>
    <message>
        <source>Around</source>
        <comment>the tube</comment>
        <translation>周向</translation>
    </message>
</context>
<context>
    <name>teleta::camera::EventTable</name>
    <message>
        <source>camera-events</source>
        <translation>相机事件</translation>
    </message>
    <message>
        <source>What happened to the tube, newest first. The context menu copies and saves the list.</source>
        <translation>软管上发生的事件，最新的在最前。右键菜单可复制和保存列表。</translation>
    </message>
</context>
<context>
    <name>teleta::camera::GelEventModel</name>
    <message>
        <source>touched</source>
        <translation>触碰</translation>
    </message>
    <message>
        <source>incipient slip</source>
        <translation>初始滑动</translation>
    </message>
    <message>
        <source>SLIP</source>
        <translation>滑动</translation>
    </message>
    <message>
        <source>released</source>
        <translation>松开</translation>
    </message>
    <message>
        <source>rest taken</source>
        <translation>已取静止</translation>
    </message>
    <message>
        <source>restarted</source>
        <translation>重新开始</translation>
    </message>
    <message>
        <source>picture is dark</source>
        <translation>图像过暗</translation>
    </message>
    <message>
        <source>light jumped</source>
        <translation>光线突变</translation>
    </message>
    <message>
        <source>gel torn?</source>
        <translation>凝胶破损？</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>Event</source>
        <translation>事件</translation>
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
        <translation>剪切</translation>
    </message>
    <message>
        <source>Slip index</source>
        <translation>滑动指数</translation>
    </message>
    <message>
        <source>BUMP</source>
        <translation>碰撞</translation>
    </message>
    <message>
        <source>arm follows</source>
        <translation>机械臂跟随</translation>
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
        <translation>凝胶上发生的事件，最新的在前。剪切是接触的标记的平均位移减去其他标记的平均位移。右键菜单可复制和保存列表。</translation>
    </message>
</context>
<context>
    <name>teleta::camera::GelPanel</name>
    <message>
        <source>Resume</source>
        <translation>继续</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>暂停</translation>
    </message>
    <message>
        <source>%1 of %2 markers</source>
        <translation>%2 个标记中的 %1 个</translation>
    </message>
    <message>
        <source>%1 ms per frame, %2 frames/s</source>
        <translation>每帧 %1 ms，%2 帧/秒</translation>
    </message>
    <message numerus="yes">
        <source>%n skipped</source>
        <translation>
            <numerusform>%n 帧被跳过</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n unusable</source>
        <translation>
            <numerusform>%n 帧不可用</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Taking the gel at rest: nothing may touch it (%n more picture(s)).</source>
        <translation>
            <numerusform>正在取凝胶的静止状态：不得有物体接触（还需 %n 幅图像）。</numerusform>
        </translation>
    </message>
    <message>
        <source>&amp;Displacement</source>
        <translation>位移(&amp;D)</translation>
    </message>
    <message>
        <source>Show how far each marker has moved from its place at rest</source>
        <translation>显示每个标记离开静止位置的距离</translation>
    </message>
    <message>
        <source>&amp;Enlarged</source>
        <translation>放大(&amp;E)</translation>
    </message>
    <message>
        <source>Enlargement of the arrows</source>
        <translation>箭头的放大倍数</translation>
    </message>
    <message>
        <source>How many times longer than the displacement the arrows are</source>
        <translation>箭头长度是位移的多少倍</translation>
    </message>
    <message>
        <source>Take the next pictures as the gel at rest: nothing may touch it</source>
        <translation>把接下来的图像作为凝胶的静止状态：不得有物体接触凝胶</translation>
    </message>
    <message>
        <source>Freeze the picture; markers are still followed (Space)</source>
        <translation>冻结画面；仍继续跟踪标记（空格）</translation>
    </message>
    <message>
        <source>Ne&amp;w rest</source>
        <translation>重新取静止(&amp;W)</translation>
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
        <translation>继续(&amp;G)</translation>
    </message>
    <message>
        <source>&amp;Pause the picture</source>
        <translation>暂停画面(&amp;P)</translation>
    </message>
    <message>
        <source>Take the gel at &amp;rest anew</source>
        <translation>重新取凝胶的静止状态(&amp;R)</translation>
    </message>
    <message>
        <source>Picture of the gel</source>
        <translation>凝胶图像</translation>
    </message>
    <message>
        <source>&lt;p&gt;What the camera sees of the gel. Arrows show, enlarged, how far each marker has moved from its place at rest; a cross is a marker that is lost. Outlines are contacts, each in the colour of its number.&lt;/p&gt;&lt;p&gt;The slip index is the share of the contact&apos;s markers that do not move with it: green while it sticks, amber when a part of it slips, red when all of it does.&lt;/p&gt;</source>
        <translation>&lt;p&gt;相机看到的凝胶。箭头以放大的方式表示每个标记离开静止位置的距离；叉号表示丢失的标记。轮廓为接触，各用其编号的颜色。&lt;/p&gt;&lt;p&gt;滑动指数是接触的标记中不随接触移动的份额：粘着时为绿色，部分滑动时为琥珀色，全部滑动时为红色。&lt;/p&gt;</translation>
    </message>
</context>
<context>
    <name>teleta::camera::PairModel</name>
    <message>
        <source>kept</source>
        <translation>保留</translation>
    </message>
    <message>
        <source>wrong</source>
        <translation>错误</translation>
    </message>
    <message>
        <source>excluded</source>
        <translation>已排除</translation>
    </message>
    <message>
        <source>Pair</source>
        <translation>点对</translation>
    </message>
    <message>
        <source>State</source>
        <translation>状态</translation>
    </message>
    <message>
        <source>Pixel</source>
        <translation>像素</translation>
    </message>
    <message>
        <source>Point</source>
        <translation>点</translation>
    </message>
    <message>
        <source>Image</source>
        <translation>图像</translation>
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
        <translation>机械臂已从接触 %1 退缩。</translation>
    </message>
    <message>
        <source>The arm is at rest.</source>
        <translation>机械臂静止。</translation>
    </message>
    <message>
        <source>The arm is retreating from contact %1.</source>
        <translation>机械臂正从接触 %1 退缩。</translation>
    </message>
    <message>
        <source>The arm follows contact %1.</source>
        <translation>机械臂正跟随接触 %1。</translation>
    </message>
    <message>
        <source>The arm is held.</source>
        <translation>机械臂处于保持状态。</translation>
    </message>
    <message>
        <source>The arm is held. Tick the box to let it react again.</source>
        <translation>机械臂处于保持状态。勾选此框可让它再次做出反应。</translation>
    </message>
    <message>
        <source>The arm may r&amp;eact</source>
        <translation>允许机械臂反应(&amp;E)</translation>
    </message>
    <message>
        <source>Off: the arm does not react to touch. STOP unticks this; tick it again to let the arm react.</source>
        <translation>关闭：无论什么接触软管，机械臂都静止。STOP 会取消此许可，直到您再次授予。</translation>
    </message>
</context>
<context>
    <name>teleta::camera::ResidualView</name>
    <message>
        <source>Residuals on the image</source>
        <translation>图像上的残差</translation>
    </message>
    <message>
        <source>Residuals on the unrolled cylinder</source>
        <translation>展开圆柱上的残差</translation>
    </message>
    <message>
        <source>&lt;p&gt;Each pair at its point on the cylinder, cut open at the back, with an enlarged arrow to where its pixel is located. The colour is the error along the axis.&lt;/p&gt;</source>
        <translation>&lt;p&gt;每个点对显示在圆柱上的点处，圆柱从背面剖开，放大的箭头指向其像素的定位处。颜色表示沿轴向的误差。&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Pair %1</source>
        <translation>点对 %1</translation>
    </message>
    <message>
        <source>kept</source>
        <translation>保留</translation>
    </message>
    <message>
        <source>left out as wrong</source>
        <translation>判为错误而剔除</translation>
    </message>
    <message>
        <source>excluded by you</source>
        <translation>由您排除</translation>
    </message>
    <message>
        <source>off by %1 in the image</source>
        <translation>图像上偏差 %1</translation>
    </message>
    <message>
        <source>off by %1 on the cylinder</source>
        <translation>圆柱上偏差 %1</translation>
    </message>
    <message>
        <source>residuals-image</source>
        <translation>残差-图像</translation>
    </message>
    <message>
        <source>residuals-cylinder</source>
        <translation>残差-圆柱</translation>
    </message>
    <message>
        <source>&amp;Exclude pair %1</source>
        <translation>排除点对 %1(&amp;E)</translation>
    </message>
    <message>
        <source>&amp;Use pair %1 again</source>
        <translation>重新使用点对 %1(&amp;U)</translation>
    </message>
    <message>
        <source>&lt;p&gt;Each pair at its pixel, with an enlarged arrow to where the camera projects its point. Random arrows are noise; a pattern shows something that the camera model misses.&lt;/p&gt;&lt;p&gt;Pixels outside the dashed circle have no ray.&lt;/p&gt;</source>
        <translation>&lt;p&gt;每个点对显示在其像素处，放大的箭头指向相机对其点的投影。无规律的箭头是噪声；呈流动状的箭头表示相机模型未描述的因素。&lt;/p&gt;&lt;p&gt;虚线圆以外的像素没有视线。&lt;/p&gt;</translation>
    </message>
</context>
<context>
    <name>teleta::camera::SceneTile</name>
    <message>
        <source>Waiting for the first picture</source>
        <translation>正在等待第一幅画面</translation>
    </message>
    <message>
        <source>No picture for %1</source>
        <translation>已有 %1 没有画面</translation>
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
        <translation>现场</translation>
    </message>
    <message>
        <source>Picture of %1</source>
        <comment>a camera</comment>
        <translation>%1 的画面</translation>
    </message>
    <message>
        <source>&lt;p&gt;What a camera sees now. Above it stand the size of its pictures, how many come in a second, and the age of the one that is shown: the time since it was read.&lt;/p&gt;&lt;p&gt;A picture that is too old for the camera&apos;s rate is dimmed, and says for how long none has come.&lt;/p&gt;</source>
        <translation>&lt;p&gt;相机此刻看到的画面。上方是画面的尺寸、每秒的数量，以及所显示画面的时龄：自读取以来的时间。&lt;/p&gt;&lt;p&gt;相对于相机速率过旧的画面会变暗，并说明已有多久没有画面。&lt;/p&gt;</translation>
    </message>
</context>
<context>
    <name>teleta::camera::StageBar</name>
    <message>
        <source>prepare</source>
        <translation>准备</translation>
    </message>
    <message>
        <source>displacement</source>
        <translation>位移</translation>
    </message>
    <message>
        <source>segment</source>
        <translation>分割</translation>
    </message>
    <message>
        <source>locate</source>
        <translation>定位</translation>
    </message>
    <message numerus="yes">
        <source>%n unusable</source>
        <translation>
            <numerusform>%n 帧不可用</numerusform>
        </translation>
    </message>
    <message>
        <source>%1: %2 ms</source>
        <comment>stage of a computation and its time</comment>
        <translation>%1：%2 ms</translation>
    </message>
    <message>
        <source>%1 ms per frame, %2 frames/s</source>
        <translation>每帧 %1 ms，%2 帧/秒</translation>
    </message>
    <message numerus="yes">
        <source>%n skipped</source>
        <translation>
            <numerusform>%n 帧被跳过</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>teleta::charts::JointChartView</name>
    <message>
        <source>Joint torques and angles of the arm</source>
        <translation>机械臂的关节力矩和角度</translation>
    </message>
    <message>
        <source>No arm. Open a scene or a device with an arm.</source>
        <translation>没有机械臂。请打开带机械臂的场景或设备。</translation>
    </message>
    <message>
        <source>Angles</source>
        <translation>角度</translation>
    </message>
    <message>
        <source>Show the joint angles too</source>
        <translation>同时显示关节角</translation>
    </message>
    <message>
        <source>at %1 s   arm time %2 s</source>
        <translation>位于 %1 s   机械臂时间 %2 s</translation>
    </message>
    <message>
        <source>joints</source>
        <translation>关节</translation>
    </message>
    <message>
        <source>&lt;p&gt;Torque of each joint over time. The coloured band is the torque window in which a touch is evaluated. Grey stretches are touches with their numbers, from the first torque above the noise to the estimate.&lt;/p&gt;&lt;p&gt;Drag or Shift+wheel scrolls, Ctrl+wheel changes the span, Space pauses, End goes back to live. Double-click an axis to type its range.&lt;/p&gt;</source>
        <translation>&lt;p&gt;各关节力矩随时间的变化。彩色带为力矩窗口：触碰在其两端之间评估。灰色段为带编号的触碰，从力矩首次高于噪声到得出估计为止。&lt;/p&gt;&lt;p&gt;拖动或 Shift+滚轮滚动，Ctrl+滚轮改变时间跨度，空格键暂停，End 返回实时。双击坐标轴可输入其端点。&lt;/p&gt;</translation>
    </message>
</context>
<context>
    <name>teleta::charts::JointPlot</name>
    <message>
        <source>shoulder roll</source>
        <translation>肩部横滚</translation>
    </message>
    <message>
        <source>shoulder pitch</source>
        <translation>肩部俯仰</translation>
    </message>
    <message>
        <source>shoulder yaw</source>
        <translation>肩部偏航</translation>
    </message>
    <message>
        <source>elbow pitch</source>
        <translation>肘部俯仰</translation>
    </message>
    <message>
        <source>Joint torque</source>
        <translation>关节力矩</translation>
    </message>
    <message>
        <source>Joint angle</source>
        <translation>关节角</translation>
    </message>
    <message>
        <source>joint %1</source>
        <translation>关节 %1</translation>
    </message>
</context>
<context>
    <name>teleta::charts::StripChartView</name>
    <message>
        <source>Strip charts of the tactile features</source>
        <translation>触觉特征的条带图</translation>
    </message>
    <message>
        <source>Strips</source>
        <translation>条带</translation>
    </message>
    <message>
        <source>Choose which strips are shown</source>
        <translation>选择要显示的条带</translation>
    </message>
    <message>
        <source>Choose strips</source>
        <translation>选择条带</translation>
    </message>
    <message>
        <source>Mark</source>
        <translation>标记</translation>
    </message>
    <message>
        <source>Mark this moment (M)</source>
        <translation>标记此刻 (M)</translation>
    </message>
    <message>
        <source>at %1 s   stream time %2 s</source>
        <translation>位于 %1 s   数据流时间 %2 s</translation>
    </message>
    <message>
        <source>charts</source>
        <translation>曲线图</translation>
    </message>
    <message>
        <source>&amp;Strips</source>
        <translation>条带(&amp;S)</translation>
    </message>
    <message>
        <source>&lt;p&gt;Force, centres, moment deviation and orientation of the contact over time. The numbers beside the strips are the newest values, or those at the cursor.&lt;/p&gt;&lt;p&gt;A gap in a line means that nothing is known there: there was no contact, samples were lost, or the recording jumped (dotted line).&lt;/p&gt;&lt;p&gt;Drag or Shift+wheel scrolls, Ctrl+wheel changes the span, Space pauses, End goes back to live. Double-click an axis to type its range.&lt;/p&gt;</source>
        <translation>&lt;p&gt;接触的力、中心、矩偏差和方向随时间的变化。条带旁的数值为最新值，或光标处的值。&lt;/p&gt;&lt;p&gt;曲线中断后又继续，表示其间没有已知数据：接触消失、样本丢失或记录跳变（点线）。&lt;/p&gt;&lt;p&gt;拖动或 Shift+滚轮滚动，Ctrl+滚轮改变时间跨度，空格键暂停，End 返回实时。双击坐标轴可输入其端点。&lt;/p&gt;</translation>
    </message>
</context>
<context>
    <name>teleta::charts::TimeChartView</name>
    <message>
        <source>S&amp;pan</source>
        <translation>时间跨度(&amp;P)</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>Show %1 s (Ctrl+wheel for other spans)</source>
        <translation>显示 %1 s（Ctrl+滚轮可选其他跨度）</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>暂停</translation>
    </message>
    <message>
        <source>at %1 s   no sample</source>
        <translation>位于 %1 s   无样本</translation>
    </message>
    <message>
        <source>last %1 s</source>
        <translation>最近 %1 s</translation>
    </message>
    <message>
        <source>PAUSED, %1 s behind   %2</source>
        <translation>已暂停，落后 %1 s   %2</translation>
    </message>
    <message>
        <source>Lower and upper end, for example -5 5. Empty: automatic.</source>
        <translation>下端和上端，例如 -5 5。留空：自动。</translation>
    </message>
    <message>
        <source>auto</source>
        <translation>自动</translation>
    </message>
    <message>
        <source>&amp;Type range of %1…</source>
        <translation>输入 %1 的范围(&amp;T)…</translation>
    </message>
    <message>
        <source>&amp;Automatic range</source>
        <translation>自动范围(&amp;A)</translation>
    </message>
    <message>
        <source>Go live</source>
        <translation>转到实时</translation>
    </message>
    <message>
        <source>Freeze the chart; samples are still collected (Space)</source>
        <translation>停止画面；样本仍继续保存（空格键）</translation>
    </message>
    <message>
        <source>Range of the axis of %1</source>
        <translation>%1 坐标轴的端点</translation>
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
        <translation>已完成。%1</translation>
    </message>
</context>
<context>
    <name>teleta::chrome::DeviceStrip</name>
    <message>
        <source>Devices</source>
        <translation>设备</translation>
    </message>
    <message>
        <source>%1 for %2</source>
        <comment>state of a device and its age</comment>
        <translation>%1，已 %2</translation>
    </message>
    <message>
        <source>Hz</source>
        <translation>Hz</translation>
    </message>
    <message>
        <source>%1 lost</source>
        <comment>frames</comment>
        <translation>丢失 %1</translation>
    </message>
    <message>
        <source>to screen %1 ms</source>
        <translation>至屏幕 %1 ms</translation>
    </message>
    <message>
        <source>No device</source>
        <translation>无设备</translation>
    </message>
    <message>
        <source>State: %1</source>
        <translation>状态：%1</translation>
    </message>
    <message>
        <source>Rate: %1 Hz</source>
        <translation>频率：%1 Hz</translation>
    </message>
    <message>
        <source>Frames lost: %1</source>
        <translation>丢失的帧：%1</translation>
    </message>
    <message>
        <source>Frames displayed: %1</source>
        <translation>已显示的帧：%1</translation>
    </message>
    <message>
        <source>Age of the newest frame: %1</source>
        <translation>最新帧距今：%1</translation>
    </message>
    <message>
        <source>touch to skin %1 ms</source>
        <translation>从触碰到皮肤 %1 ms</translation>
    </message>
    <message>
        <source>From the completed touch to the first frame of its pattern: %1 ms</source>
        <translation>从触碰完成到其图案的第一帧：%1 ms</translation>
    </message>
    <message>
        <source>From sensor read to screen: %1 ms</source>
        <translation>从读取到屏幕：%1 ms</translation>
    </message>
    <message>
        <source>rec</source>
        <comment>recorded, short</comment>
        <translation>记录</translation>
    </message>
    <message>
        <source>rec sim</source>
        <comment>a recorded simulation, short</comment>
        <translation>记录模拟</translation>
    </message>
    <message>
        <source>sim</source>
        <comment>simulated, short</comment>
        <translation>模拟</translation>
    </message>
    <message>
        <source>Frames lost: not counted by the sensor</source>
        <translation>丢失的帧：传感器不计数</translation>
    </message>
    <message>
        <source>playing</source>
        <comment>a recording</comment>
        <translation>播放中</translation>
    </message>
</context>
<context>
    <name>teleta::chrome::FirstSteps</name>
    <message>
        <source>First steps</source>
        <translation>入门步骤</translation>
    </message>
    <message>
        <source>Hide the first steps; the handbook has them</source>
        <translation>隐藏入门步骤；手册中有这些内容</translation>
    </message>
    <message>
        <source>Hide the first steps</source>
        <translation>隐藏入门步骤</translation>
    </message>
    <message>
        <source>Touch something</source>
        <translation>触碰物体</translation>
    </message>
    <message>
        <source>A simulated arm touches five materials: contact, force, stiffness</source>
        <translation>模拟机械臂触碰五种材料：接触、力、刚度</translation>
    </message>
    <message>
        <source>Say it with a pattern</source>
        <translation>用图案表达</translation>
    </message>
    <message>
        <source>Open a built-in pattern and play it with Space</source>
        <translation>打开一个内置图案，按空格键播放</translation>
    </message>
    <message>
        <source>Watch a study</source>
        <translation>观看一项研究</translation>
    </message>
    <message>
        <source>Simulated participants answer, and the confusion matrix fills</source>
        <translation>模拟被试作出回答，混淆矩阵逐渐填满</translation>
    </message>
</context>
<context>
    <name>teleta::chrome::MessageBar</name>
    <message>
        <source>Messages</source>
        <translation>消息</translation>
    </message>
    <message numerus="yes">
        <source>%n older message(s)</source>
        <translation>
            <numerusform>%n 条较早的消息</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>since %1, %n times</source>
        <translation>
            <numerusform>自 %1 起，%n 次</numerusform>
        </translation>
    </message>
    <message>
        <source>Hide details</source>
        <translation>隐藏详情</translation>
    </message>
    <message>
        <source>Details</source>
        <translation>详情</translation>
    </message>
    <message>
        <source>Dismiss</source>
        <translation>关闭</translation>
    </message>
</context>
<context>
    <name>teleta::chrome::MessageLog</name>
    <message>
        <source>Error</source>
        <translation>错误</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>警告</translation>
    </message>
    <message>
        <source>Information</source>
        <translation>信息</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>类型</translation>
    </message>
    <message>
        <source>Message</source>
        <translation>消息</translation>
    </message>
</context>
<context>
    <name>teleta::chrome::PageRail</name>
    <message>
        <source>Pages</source>
        <translation>页面</translation>
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
        <translation>第 %1 帧，共 %2 帧</translation>
    </message>
    <message>
        <source>Playback</source>
        <translation>回放</translation>
    </message>
    <message>
        <source>To the start</source>
        <translation>到开头</translation>
    </message>
    <message>
        <source>Home</source>
        <translation>Home</translation>
    </message>
    <message>
        <source>One frame back</source>
        <translation>后退一帧</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>左方向键</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>播放</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>暂停</translation>
    </message>
    <message>
        <source>Space</source>
        <translation>空格键</translation>
    </message>
    <message>
        <source>One frame forward</source>
        <translation>前进一帧</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>右方向键</translation>
    </message>
    <message>
        <source>Time in the recording</source>
        <translation>记录中的时间</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>Repeat</source>
        <translation>到末尾后重新开始</translation>
    </message>
</context>
<context>
    <name>teleta::chrome::RecentList</name>
    <message>
        <source>Recent:</source>
        <translation>最近使用：</translation>
    </message>
    <message>
        <source>Reopen %1</source>
        <comment>what was open</comment>
        <translation>重新打开 %1</translation>
    </message>
    <message>
        <source>What was open when the console was closed</source>
        <translation>上次关闭控制台时打开的内容</translation>
    </message>
</context>
<context>
    <name>teleta::chrome::RecordingIndicator</name>
    <message numerus="yes">
        <source>Recording %1 · %2 · %n lost</source>
        <comment>time, size of the file, frames</comment>
        <translation>
            <numerusform>正在记录 %1 · %2 · 丢失 %n</numerusform>
        </translation>
    </message>
    <message>
        <source>Record</source>
        <translation>记录</translation>
    </message>
    <message>
        <source>End the recording (Ctrl+R)</source>
        <translation>结束记录 (Ctrl+R)</translation>
    </message>
    <message>
        <source>Record all sources and the bracelet into a file (Ctrl+R)</source>
        <translation>将所有数据源和手环记录到文件 (Ctrl+R)</translation>
    </message>
    <message>
        <source>End the recording</source>
        <translation>结束记录</translation>
    </message>
    <message>
        <source>Mark</source>
        <translation>标记</translation>
    </message>
    <message>
        <source>Mark this moment (M)</source>
        <translation>标记此刻 (M)</translation>
    </message>
    <message>
        <source>Mark this moment</source>
        <translation>标记此刻</translation>
    </message>
    <message>
        <source>Starting…</source>
        <translation>正在开始…</translation>
    </message>
    <message>
        <source>Finishing…</source>
        <translation>正在完成…</translation>
    </message>
    <message>
        <source>Recording failed</source>
        <translation>记录失败</translation>
    </message>
    <message>
        <source>Recording failed. Record</source>
        <translation>记录失败。记录</translation>
    </message>
</context>
<context>
    <name>teleta::chrome::SourceChooser</name>
    <message>
        <source>%1 (opening…)</source>
        <comment>a source</comment>
        <translation>%1（正在打开…）</translation>
    </message>
    <message>
        <source>%1 — %2</source>
        <comment>a source and whether its data are simulated or recorded</comment>
        <translation>%1 — %2</translation>
    </message>
    <message>
        <source>No source</source>
        <translation>无数据源</translation>
    </message>
    <message>
        <source>Open &amp;recording…</source>
        <translation>打开记录(&amp;R)…</translation>
    </message>
    <message>
        <source>Open &amp;scene file…</source>
        <translation>打开场景文件(&amp;S)…</translation>
    </message>
    <message>
        <source>Open source &amp;list…</source>
        <translation>打开数据源列表(&amp;L)…</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>数据源</translation>
    </message>
    <message>
        <source>Open a simulated scene or a recording</source>
        <translation>打开模拟场景或记录</translation>
    </message>
    <message>
        <source>Close source</source>
        <translation>关闭数据源</translation>
    </message>
    <message>
        <source>Close this source</source>
        <translation>关闭此数据源</translation>
    </message>
    <message>
        <source>Open &amp;camera…</source>
        <translation>打开相机(&amp;C)…</translation>
    </message>
    <message>
        <source>A camera in the soft tube, or a video of one, with its calibration</source>
        <translation>软管中的相机或其视频，及其标定</translation>
    </message>
    <message>
        <source>The source that the views show</source>
        <translation>各视图显示的数据源</translation>
    </message>
    <message>
        <source>Open &amp;arm…</source>
        <translation>打开机械臂(&amp;A)…</translation>
    </message>
    <message>
        <source>An arm over ROS 2, described in a file</source>
        <translation>通过 ROS 2 的机械臂，由文件描述</translation>
    </message>
    <message>
        <source>A recording of this program or as MCAP, or recorded frames of an array: CSV, NumPy, HDF5, MATLAB, Tekscan</source>
        <translation>本程序的记录或 MCAP，或阵列的帧记录：CSV、NumPy、HDF5、MATLAB、Tekscan</translation>
    </message>
    <message>
        <source>Ope&amp;n</source>
        <translation>打开(&amp;N)</translation>
    </message>
</context>
<context>
    <name>teleta::chrome::StopBanner</name>
    <message>
        <source>The STOP button was pressed.</source>
        <translation>按下了 STOP 按钮。</translation>
    </message>
    <message>
        <source>Ctrl+. was pressed.</source>
        <translation>按下了 Ctrl+.。</translation>
    </message>
    <message>
        <source>Esc was pressed twice.</source>
        <translation>连按了两次 Esc。</translation>
    </message>
    <message>
        <source>The program engaged STOP.</source>
        <translation>程序触发了 STOP。</translation>
    </message>
    <message>
        <source>STOPPED since %1. %2</source>
        <comment>time, cause</comment>
        <translation>已停止，自 %1 起。%2</translation>
    </message>
    <message>
        <source>Motors are off and arms are held. To continue, hold the STOPPED button for one second.</source>
        <translation>电机已关闭，机械臂保持不动。要继续，请按住“已停止”按钮一秒。</translation>
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
        <translation>已停止</translation>
    </message>
    <message>
        <source>hold to release</source>
        <translation>按住以解除</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation>已停止</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>Everything that moves is stopped. Hold for a second to release.</source>
        <translation>一切运动均已停止。按住一秒以解除。</translation>
    </message>
    <message>
        <source>Stops everything that moves at once.</source>
        <translation>立即停止一切运动。</translation>
    </message>
    <message>
        <source>Stop everything that moves at once (Esc Esc, or Ctrl+.)</source>
        <translation>立即停止一切运动（Esc Esc 或 Ctrl+.）</translation>
    </message>
</context>
<context>
    <name>teleta::chrome::TimeSlider</name>
    <message>
        <source>Mark</source>
        <translation>标记</translation>
    </message>
</context>
<context>
    <name>teleta::console::BraceletMenu</name>
    <message>
        <source>&amp;Simulated</source>
        <translation>模拟(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;USB</source>
        <translation>USB(&amp;U)</translation>
    </message>
    <message>
        <source>&amp;None</source>
        <translation>无(&amp;N)</translation>
    </message>
    <message>
        <source>Devices (*.toml)</source>
        <translation>设备 (*.toml)</translation>
    </message>
    <message>
        <source>File: %1</source>
        <comment>a device file</comment>
        <translation>文件：%1</translation>
    </message>
    <message>
        <source>&amp;Device file…</source>
        <translation>设备文件(&amp;D)…</translation>
    </message>
    <message>
        <source>Open the file of a bracelet</source>
        <translation>打开手环的文件</translation>
    </message>
    <message>
        <source>A file that describes the registers of a Modbus motor driver, the ids of a USB bracelet, or the outputs of a sound card</source>
        <translation>描述 Modbus 电机驱动器的寄存器、USB 手环的标识号或声卡输出的文件</translation>
    </message>
    <message>
        <source>Measure its &amp;latency…</source>
        <translation>测量其延迟(&amp;L)…</translation>
    </message>
    <message>
        <source>From a frame to the movement of a tactor, for a bracelet on a sound card</source>
        <translation>从一帧到振子的动作，用于声卡上的手环</translation>
    </message>
</context>
<context>
    <name>teleta::console::CalibratePage</name>
    <message>
        <source>What can be calibrated</source>
        <translation>可标定的内容</translation>
    </message>
    <message>
        <source>Bracelet motors</source>
        <translation>手环电机</translation>
    </message>
    <message>
        <source>Cylinder camera</source>
        <translation>圆柱相机</translation>
    </message>
    <message>
        <source>Taxel gains</source>
        <translation>触觉单元增益</translation>
    </message>
    <message>
        <source>Unsaved calibration</source>
        <translation>未保存的标定</translation>
    </message>
    <message>
        <source>%1: the calibration is not saved.</source>
        <comment>a part of the page</comment>
        <translation>%1：标定尚未保存。</translation>
    </message>
    <message>
        <source>Discarded values must be measured again.</source>
        <translation>丢弃的内容须重新测量。</translation>
    </message>
    <message>
        <source>The taxel gains of %1 are not saved.</source>
        <comment>a source</comment>
        <translation>%1 的触觉单元增益尚未保存。</translation>
    </message>
    <message>
        <source>They are lost when the source is closed. Save them on the page Calibrate.</source>
        <translation>关闭该来源后将丢失。可在“标定”页保存。</translation>
    </message>
    <message>
        <source>Loads in newtons</source>
        <translation>以牛顿表示载荷</translation>
    </message>
</context>
<context>
    <name>teleta::console::CameraCalibrator</name>
    <message>
        <source>Saved %1</source>
        <translation>已保存 %1</translation>
    </message>
    <message>
        <source>Cylinder camera</source>
        <translation>圆柱相机</translation>
    </message>
    <message>
        <source>Pairs of pixels and points: CSV with u_px,v_px,x_m,y_m,z_m</source>
        <translation>像素与点的点对：CSV，含 u_px,v_px,x_m,y_m,z_m</translation>
    </message>
    <message>
        <source>&amp;Probe the simulated tube</source>
        <translation>探测模拟软管(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Method:</source>
        <translation>方法(&amp;M)：</translation>
    </message>
    <message>
        <source>Method of calibration</source>
        <translation>标定方法</translation>
    </message>
    <message>
        <source>Linear (DLT)</source>
        <translation>线性 (DLT)</translation>
    </message>
    <message>
        <source>As in the paper</source>
        <translation>与论文相同</translation>
    </message>
    <message>
        <source>Least squares</source>
        <translation>最小二乘</translation>
    </message>
    <message>
        <source>Robust</source>
        <translation>稳健</translation>
    </message>
    <message>
        <source>&amp;Exclude wrong pairs</source>
        <translation>排除错误点对(&amp;E)</translation>
    </message>
    <message>
        <source>Methods side by side</source>
        <translation>方法对比</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>方法</translation>
    </message>
    <message>
        <source>Kept</source>
        <translation>保留</translation>
    </message>
    <message>
        <source>Image, mean</source>
        <translation>图像，平均</translation>
    </message>
    <message>
        <source>Surface, mean</source>
        <translation>表面，平均</translation>
    </message>
    <message>
        <source>Uncertainty</source>
        <translation>不确定度</translation>
    </message>
    <message>
        <source>Remark</source>
        <translation>备注</translation>
    </message>
    <message>
        <source>Pairs</source>
        <translation>点对</translation>
    </message>
    <message>
        <source>&amp;Exclude, or use again</source>
        <translation>排除或重新使用(&amp;E)</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>移除(&amp;R)</translation>
    </message>
    <message>
        <source>Save the camera</source>
        <translation>保存相机</translation>
    </message>
    <message>
        <source>Save the pairs</source>
        <translation>保存点对</translation>
    </message>
    <message>
        <source>Load pairs</source>
        <translation>加载点对</translation>
    </message>
    <message>
        <source>Cameras (*.json)</source>
        <translation>相机 (*.json)</translation>
    </message>
    <message>
        <source>probing</source>
        <translation>探测</translation>
    </message>
    <message>
        <source>loading</source>
        <translation>加载</translation>
    </message>
    <message>
        <source>added pair</source>
        <translation>添加点对</translation>
    </message>
    <message numerus="yes">
        <source>removal of %n pair(s)</source>
        <translation>
            <numerusform>移除 %n 个点对</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>use of %n pair(s)</source>
        <translation>
            <numerusform>使用 %n 个点对</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>exclusion of %n pair(s)</source>
        <translation>
            <numerusform>排除 %n 个点对</numerusform>
        </translation>
    </message>
    <message>
        <source>image and cylinder</source>
        <translation>图像和圆柱</translation>
    </message>
    <message>
        <source>No calibration: %1.</source>
        <translation>无法标定：%1。</translation>
    </message>
    <message numerus="yes">
        <source>%1 of %n pair(s) kept; </source>
        <translation>
            <numerusform>保留 %1 个点对，共 %n 个； </numerusform>
        </translation>
    </message>
    <message>
        <source>SIMULATED</source>
        <translation>模拟</translation>
    </message>
    <message>
        <source>has a pattern</source>
        <translation>有规律</translation>
    </message>
    <message>
        <source>Load pairs of pixels and probed points, drop their file here, type them in below, or probe a tube.</source>
        <translation>请加载像素与探测点的点对，将其文件拖放到此处，在下方输入，或探测一根软管。</translation>
    </message>
    <message>
        <source>It is valid within %1 of its axis. </source>
        <translation>在距光轴 %1 以内有效。 </translation>
    </message>
    <message>
        <source>probed hole</source>
        <translation>探测孔</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>撤销(&amp;U)</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>重做(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Load pairs…</source>
        <translation>加载点对(&amp;L)…</translation>
    </message>
    <message>
        <source>Save pai&amp;rs…</source>
        <translation>保存点对(&amp;R)…</translation>
    </message>
    <message>
        <source>&amp;Save camera…</source>
        <translation>保存相机(&amp;S)…</translation>
    </message>
    <message>
        <source>Probe with a &amp;camera…</source>
        <translation>用相机探测(&amp;C)…</translation>
    </message>
    <message>
        <source>Calibrating…</source>
        <translation>正在标定…</translation>
    </message>
    <message>
        <source>Save all pairs, including excluded ones, to load them again later</source>
        <translation>按加载时的原样保存全部点对，包括被剔除的</translation>
    </message>
    <message>
        <source>Save the camera found by the chosen method, for teleta locate and the camera view</source>
        <translation>所选方法得到的相机，用于 teleta locate 和相机视图</translation>
    </message>
    <message>
        <source>Collect pairs: a simulated person presses a stick on the marked places of a simulated tube and mistakes one in ten for its neighbour</source>
        <translation>采集点对：模拟的人用探棒按压模拟软管上的标记位置，每十个中有一个误按到相邻位置</translation>
    </message>
    <message>
        <source>Collect pairs: press a stick through the holes of a shell while a camera watches, live or in a video</source>
        <translation>采集点对：将探棒穿过外壳的孔按压，同时观察相机或其视频</translation>
    </message>
    <message>
        <source>Exclude the pairs marked as wrong, for every method</source>
        <translation>在所有方法中剔除标为错误的点对</translation>
    </message>
    <message>
        <source>&lt;p&gt;Finds the camera inside the tactile cylinder from pairs of a pixel and the surface point that was probed there.&lt;/p&gt;&lt;p&gt;Load a CSV file, drop it here, or type pairs in. Wrong pairs are detected and left out; you can exclude more, remove them (Delete in the table) and undo every step.&lt;/p&gt;</source>
        <translation>&lt;p&gt;由点对求触觉圆柱内的相机：每个点对是一个像素及在该处探测的表面点。&lt;/p&gt;&lt;p&gt;加载 CSV 文件或将其拖放到此处，也可键入点对。错误的点对会被找出并剔除；您还可以排除更多点对或将其移除（在表中按 Delete），每一步都可撤回。&lt;/p&gt;</translation>
    </message>
    <message>
        <source>The camera was not saved. Wait until it is calibrated.</source>
        <translation>相机未保存：正在标定。</translation>
    </message>
    <message>
        <source>Waiting for the first touch.</source>
        <translation>等待第一次触碰。</translation>
    </message>
    <message>
        <source>their points are located to within %1 on average; the camera&apos;s uncertainty is %2. </source>
        <translation>其点的定位平均偏差在 %1 以内，相机的不确定度在 %2 以内。 </translation>
    </message>
    <message>
        <source>This method ignores lens distortion: use it only for comparison.</source>
        <translation>此方法不含镜头模型：仅供比较。</translation>
    </message>
    <message>
        <source>The residuals show no pattern, as they should.</source>
        <translation>残差无规律。良好。</translation>
    </message>
    <message>
        <source>Pairs (*.csv)</source>
        <translation>点对 (*.csv)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>所有文件 (*)</translation>
    </message>
    <message>
        <source>points off the cylinder</source>
        <translation>点不在圆柱上</translation>
    </message>
    <message>
        <source>points beyond the ends</source>
        <translation>点超出两端</translation>
    </message>
    <message>
        <source>u and v swapped?</source>
        <translation>u 与 v 颠倒？</translation>
    </message>
    <message>
        <source>pixels outside the image</source>
        <translation>像素在图像之外</translation>
    </message>
    <message>
        <source>Caution: %1.</source>
        <translation>请注意：%1。</translation>
    </message>
    <message>
        <source>It is valid in the whole image. </source>
        <translation>它在整幅图像中有效。 </translation>
    </message>
</context>
<context>
    <name>teleta::console::CameraDialog</name>
    <message>
        <source>Open camera</source>
        <translation>打开相机</translation>
    </message>
    <message>
        <source>…</source>
        <translation>…</translation>
    </message>
    <message>
        <source>Ca&amp;libration:</source>
        <translation>标定(&amp;L)：</translation>
    </message>
    <message>
        <source>Choose a camera file</source>
        <translation>选择相机文件</translation>
    </message>
    <message>
        <source>Camera file</source>
        <translation>相机文件</translation>
    </message>
    <message>
        <source>Camera files (*.json)</source>
        <translation>相机文件 (*.json)</translation>
    </message>
    <message>
        <source>The camera file that the page Calibrate or teleta calibrate has written; without one the camera is only looked at</source>
        <translation>“标定”页或 teleta calibrate 写出的相机文件；没有它时相机仅用于观看</translation>
    </message>
    <message>
        <source>none: only show the picture</source>
        <translation>无：仅观看</translation>
    </message>
    <message>
        <source>&amp;Start again at the end</source>
        <translation>到末尾后重新开始(&amp;S)</translation>
    </message>
    <message>
        <source>Camera or &amp;video:</source>
        <translation>相机或视频(&amp;V)：</translation>
    </message>
</context>
<context>
    <name>teleta::console::CameraSourceField</name>
    <message>
        <source>The number of a connected camera (0 is /dev/video0), or a video file</source>
        <translation>所连相机的编号（0 为 /dev/video0），或视频文件</translation>
    </message>
    <message>
        <source>…</source>
        <translation>…</translation>
    </message>
    <message>
        <source>Choose a video</source>
        <translation>选择视频</translation>
    </message>
    <message>
        <source>Video of a camera</source>
        <translation>相机的视频</translation>
    </message>
    <message>
        <source>Videos and pictures (*)</source>
        <translation>视频和图片 (*)</translation>
    </message>
    <message>
        <source>Camera or video</source>
        <translation>相机或视频</translation>
    </message>
</context>
<context>
    <name>teleta::console::CostMeasuring</name>
    <message>
        <source>The saved costs cannot be read.</source>
        <translation>无法读取先前测得的代价。</translation>
    </message>
    <message>
        <source>The costs cannot be saved.</source>
        <translation>无法保存测得的代价。</translation>
    </message>
    <message>
        <source>The jobs could not be measured.</source>
        <translation>无法测量各任务。</translation>
    </message>
</context>
<context>
    <name>teleta::console::CostPage</name>
    <message>
        <source>Error: %1.</source>
        <translation>误差：%1。</translation>
    </message>
    <message>
        <source>refused: too noisy</source>
        <translation>被拒绝：干扰过大</translation>
    </message>
    <message>
        <source>Preparing…</source>
        <translation>正在准备…</translation>
    </message>
    <message>
        <source>%1: %2 on average, 99 of 100 frames within %3 (1640 x 1232 pixels).</source>
        <translation>%1：平均 %2，100 帧中有 99 帧在 %3 以内（1640 x 1232 像素）。</translation>
    </message>
    <message>
        <source>Measuring %1: %2</source>
        <translation>正在测量 %1：%2</translation>
    </message>
    <message>
        <source>Preparing %1…</source>
        <translation>正在准备 %1…</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>取消(&amp;C)</translation>
    </message>
    <message>
        <source>Not measured on this machine</source>
        <translation>未在本机上测量</translation>
    </message>
    <message>
        <source>Parameter</source>
        <translation>参数</translation>
    </message>
    <message>
        <source>Mean error</source>
        <translation>平均误差</translation>
    </message>
    <message>
        <source>95 %</source>
        <translation>95 %</translation>
    </message>
    <message>
        <source>Worst</source>
        <translation>最差</translation>
    </message>
    <message>
        <source>Median time</source>
        <translation>中位时间</translation>
    </message>
    <message>
        <source>99 % time</source>
        <translation>99 % 时间</translation>
    </message>
    <message>
        <source>Camera in use</source>
        <translation>使用中的相机</translation>
    </message>
    <message>
        <source>Time of a frame, now</source>
        <translation>当前每帧用时</translation>
    </message>
    <message>
        <source> ms a frame</source>
        <translation> ms/帧</translation>
    </message>
    <message>
        <source>No camera is shown on the page Operate.</source>
        <translation>“操作”页未显示相机。</translation>
    </message>
    <message>
        <source>Open a demo with a camera</source>
        <translation>打开带相机的演示</translation>
    </message>
    <message>
        <source>Measuring</source>
        <translation>正在测量</translation>
    </message>
    <message>
        <source>Close other programs and sources first: their load makes the times unreliable.</source>
        <translation>请先关闭其他程序和数据源：它们的计算会使计时不可靠。</translation>
    </message>
    <message>
        <source>Stopping…</source>
        <translation>正在结束…</translation>
    </message>
    <message>
        <source>Takes a few minutes; you can go on using the console</source>
        <translation>需要几分钟；期间仍可使用控制台</translation>
    </message>
    <message>
        <source>Sweeps</source>
        <translation>扫描</translation>
    </message>
    <message>
        <source>Fastest: %1, %2 times the limit (%3: %4).</source>
        <translation>最快：%1，为极限（%3：%4）的 %2 倍。</translation>
    </message>
    <message>
        <source>%1 (frontier)</source>
        <comment>name of a setting</comment>
        <translation>%1（前沿）</translation>
    </message>
    <message>
        <source>Measure &quot;%1&quot; first.</source>
        <translation>请先测量“%1”。</translation>
    </message>
    <message>
        <source>No setting is fast enough: only one frame in 100 may take longer.</source>
        <translation>没有足够快的设置：每 100 帧中只允许一帧用时更长。</translation>
    </message>
    <message>
        <source>The setting %1 cannot be used.</source>
        <translation>无法使用设置 %1。</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>设置</translation>
    </message>
    <message>
        <source>Jobs</source>
        <translation>任务</translation>
    </message>
    <message>
        <source>Jobs that can be done fast or accurately</source>
        <translation>可快速或精确完成的任务</translation>
    </message>
    <message>
        <source>Measure this job</source>
        <translation>测量此任务</translation>
    </message>
    <message>
        <source>Setting</source>
        <translation>设置</translation>
    </message>
    <message>
        <source>Settings with their errors and times</source>
        <translation>各设置及其误差和用时</translation>
    </message>
    <message>
        <source>&amp;Setting in use</source>
        <translation>正在使用的设置(&amp;S)</translation>
    </message>
    <message>
        <source>Setting that finds the contacts</source>
        <translation>寻找接触所用的设置</translation>
    </message>
    <message>
        <source>&amp;Use the best setting within it</source>
        <translation>使用预算内的最佳设置(&amp;U)</translation>
    </message>
    <message>
        <source>Choose a setting in the table or the chart to read what it costs and gives.</source>
        <translation>在表格或图表中选择一种设置，即可查看其代价和所得。</translation>
    </message>
    <message>
        <source>On the command line: %1</source>
        <translation>命令行名称：%1</translation>
    </message>
    <message>
        <source>not measured</source>
        <translation>未测量</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <comment>times</comment>
        <translation>%1 至 %2</translation>
    </message>
    <message>
        <source>&amp;Measure again</source>
        <translation>重新测量(&amp;M)</translation>
    </message>
    <message>
        <source>Measure all &amp;jobs</source>
        <translation>测量所有任务(&amp;J)</translation>
    </message>
    <message>
        <source>&amp;Time budget of a frame</source>
        <translation>每帧时间预算(&amp;T)</translation>
    </message>
</context>
<context>
    <name>teleta::console::DeletionDialog</name>
    <message>
        <source>Delete a participant</source>
        <translation>删除被试</translation>
    </message>
    <message>
        <source>For example: consent withdrawn</source>
        <translation>例如：撤回同意</translation>
    </message>
    <message>
        <source>It is recorded. Write nothing that tells who it was</source>
        <translation>会被记录；不要写能看出是谁的内容</translation>
    </message>
    <message>
        <source>&amp;Reason</source>
        <translation>原因(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Name of the participant, once more</source>
        <translation>再次输入被试名称(&amp;N)</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>删除</translation>
    </message>
    <message>
        <source>All sessions, answers, notes, recordings and exported files of %1 are deleted. This cannot be undone. The study records that somebody was deleted, and when. Results that were computed before, and copies elsewhere, stay as they are.</source>
        <comment>a participant</comment>
        <translation>%1 的全部场次、回答、备注、记录和导出文件都会被删除，且无法撤销。研究只保留“有人被删除”及其时间。以前算出的结果以及别处的副本保持不变。</translation>
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
        <translation>浮动(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>关闭(&amp;C)</translation>
    </message>
</context>
<context>
    <name>teleta::console::ExclusionEditor</name>
    <message>
        <source>What does not count</source>
        <translation>不计入的数据</translation>
    </message>
    <message>
        <source>No rules: every completed trial counts.</source>
        <translation>没有规则：每个已完成的试次都计入。</translation>
    </message>
    <message>
        <source>Add a r&amp;ule</source>
        <translation>添加规则(&amp;U)</translation>
    </message>
    <message>
        <source>Rules apply from top to bottom, each to what is left. Nothing is deleted: results are shown with the rules, and without them</source>
        <translation>规则从上到下依次应用，每条只针对此前余下的数据。没有删除任何数据：结果会分别在应用规则和不应用规则的情况下显示</translation>
    </message>
    <message>
        <source>a trial answered earlier than, s</source>
        <translation>回答早于此时间的试次，s</translation>
    </message>
    <message>
        <source>a trial answered later than, s</source>
        <translation>回答晚于此时间的试次，s</translation>
    </message>
    <message>
        <source>a trial whose time is unusual, MADs from the median</source>
        <translation>时间异常的试次，偏离中位数的 MAD 倍数</translation>
    </message>
    <message>
        <source>a trial with more device faults than</source>
        <translation>设备故障多于此数的试次</translation>
    </message>
    <message>
        <source>a trial with more missed frames than</source>
        <translation>丢帧多于此数的试次</translation>
    </message>
    <message>
        <source>a session with a share without answer above</source>
        <translation>未回答比例高于此值的场次</translation>
    </message>
    <message>
        <source>a session with a share of yes in catch trials above</source>
        <translation>捕捉试次中回答“是”的比例高于此值的场次</translation>
    </message>
    <message>
        <source>a session with a share of one answer above</source>
        <translation>同一回答的比例高于此值的场次</translation>
    </message>
    <message>
        <source>a participant with a share right in practice below</source>
        <translation>练习正确率低于此值的被试</translation>
    </message>
    <message>
        <source>a participant not above chance, p above</source>
        <translation>未高于随机水平的被试，p 大于</translation>
    </message>
    <message>
        <source>Name of the rule</source>
        <translation>规则的名称</translation>
    </message>
    <message>
        <source>The name of the rule in the column “excluded” and in results</source>
        <translation>规则在列“excluded”和结果中的名称</translation>
    </message>
    <message>
        <source>What the rule leaves out</source>
        <translation>规则所排除的内容</translation>
    </message>
    <message>
        <source>Number of the rule</source>
        <translation>规则的数值</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>删除</translation>
    </message>
    <message>
        <source>Remove this rule</source>
        <translation>删除此规则</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; is not a number</source>
        <comment>a rule</comment>
        <translation>%1：“%2”不是数</translation>
    </message>
    <message>
        <source>a number with a point, such as 0.2</source>
        <translation>带小数点的数，例如 0.2</translation>
    </message>
</context>
<context>
    <name>teleta::console::ExportDialog</name>
    <message>
        <source>Export pattern</source>
        <translation>导出图案</translation>
    </message>
    <message>
        <source>commanded intensities</source>
        <translation>指令强度</translation>
    </message>
    <message>
        <source>&amp;Format:</source>
        <translation>格式(&amp;F)：</translation>
    </message>
    <message>
        <source>&amp;Rate:</source>
        <translation>采样率(&amp;R)：</translation>
    </message>
    <message>
        <source>&amp;Values:</source>
        <translation>数值(&amp;V)：</translation>
    </message>
    <message>
        <source>Choose file…</source>
        <translation>选择文件…</translation>
    </message>
    <message>
        <source>predicted intensities</source>
        <translation>电机的预测动作</translation>
    </message>
    <message>
        <source>vibrations</source>
        <translation>振动</translation>
    </message>
    <message>
        <source>bare intensities</source>
        <translation>纯强度</translation>
    </message>
    <message>
        <source>&amp;Signal:</source>
        <translation>信号(&amp;S)：</translation>
    </message>
    <message>
        <source>Frequenc&amp;y:</source>
        <translation>频率(&amp;Y)：</translation>
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
        <translation>刚度</translation>
    </message>
    <message>
        <source>dynamic</source>
        <translation>动态</translation>
    </message>
    <message>
        <source>static</source>
        <translation>静态</translation>
    </message>
    <message>
        <source>%1: no pattern</source>
        <comment>what was recognised</comment>
        <translation>%1：无图案</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>what was recognised: id of a pattern</comment>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>Touch %1: %2. There is no pattern for it in the table.</source>
        <translation>触碰 %1：%2。表中没有对应的图案。</translation>
    </message>
    <message>
        <source>Touch %1: %2. %3 was felt %4 later.</source>
        <translation>触碰 %1：%2。%4 后感觉到 %3。</translation>
    </message>
    <message>
        <source>Touch %1: %2. %3 was sent.</source>
        <translation>触碰 %1：%2。已发送 %3。</translation>
    </message>
    <message>
        <source>Stiffness and shape</source>
        <translation>刚度和形状</translation>
    </message>
    <message>
        <source>Stiffness</source>
        <translation>刚度</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>形状</translation>
    </message>
    <message>
        <source>Nothing</source>
        <translation>无</translation>
    </message>
    <message>
        <source>What of a touch is played on the bracelet</source>
        <translation>触碰的哪些信息在手环上播放</translation>
    </message>
    <message>
        <source>Nothing was recognised yet.</source>
        <translation>尚未识别任何内容。</translation>
    </message>
    <message>
        <source>%1: %2 is missing</source>
        <comment>what was recognised: id of a pattern</comment>
        <translation>%1：缺少 %2</translation>
    </message>
    <message>
        <source>Touch %1: %2. Its pattern %3 is missing: nothing was played. Choose another one, or put it back among your patterns.</source>
        <translation>触碰 %1：%2。其图案 %3 缺失：未播放任何内容。请另选一个，或将它放回您的图案中。</translation>
    </message>
    <message>
        <source>From touch to skin: %1 half of the time, %2 at 99 %.</source>
        <translation>从触碰到皮肤：半数不超过 %1，99 % 不超过 %2。</translation>
    </message>
    <message>
        <source>Of the newest touches, with the link between the two sites on the way</source>
        <translation>针对最近的触碰，包含途中两地之间的链路</translation>
    </message>
    <message>
        <source>Nothing is played (last: %1)</source>
        <comment>what was recognised and its pattern</comment>
        <translation>未在播放（上一个：%1）</translation>
    </message>
    <message>
        <source>Unknown stiffness</source>
        <translation>刚度未知</translation>
    </message>
    <message>
        <source>%1: %2, not played</source>
        <comment>what was recognised: id of a pattern</comment>
        <translation>%1：%2，未播放</translation>
    </message>
    <message>
        <source>Touch %1: %2. %3 was not played: no bracelet is connected, or a study or a calibration is using it.</source>
        <translation>触碰 %1：%2。%3 未播放：没有手环，或研究或标定正在使用它。</translation>
    </message>
    <message>
        <source>What to &amp;play:</source>
        <translation>播放触碰的(&amp;P)：</translation>
    </message>
    <message>
        <source>Save the times of touches</source>
        <translation>保存触碰的时间</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>表格 (*.csv)</translation>
    </message>
    <message>
        <source>Read: %1</source>
        <translation>读取：%1</translation>
    </message>
    <message>
        <source>by the clock of the site, known to ± %1</source>
        <translation>按站点的时钟，不确定度 ± %1</translation>
    </message>
    <message>
        <source>by the clock of this computer</source>
        <translation>按本计算机的时钟</translation>
    </message>
    <message>
        <source>Evaluated: %1 later</source>
        <translation>评估：%1 之后</translation>
    </message>
    <message>
        <source>First frame to the bracelet: %1 later</source>
        <translation>发送到手环的第一帧：%1 之后</translation>
    </message>
    <message>
        <source>First frame that is felt: %1 later</source>
        <translation>可感觉到的第一帧：%1 之后</translation>
    </message>
    <message>
        <source>Each is known to ± %1, since two clocks are compared.</source>
        <translation>由于比较了两个时钟，每个值的不确定度为 ± %1。</translation>
    </message>
    <message>
        <source>Save times…</source>
        <translation>保存时间…</translation>
    </message>
    <message>
        <source>Arrived at the console: %1 later</source>
        <translation>到达控制台：%1 后</translation>
    </message>
    <message>
        <source>Save when each touch was read, arrived from a site, was evaluated, sent and felt, as a table (CSV)</source>
        <translation>将每次触碰被读取、从站点到达、被评估、发送和感受到的时间保存为表格（CSV）</translation>
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
        <translation>打开帧</translation>
    </message>
    <message>
        <source>the only one, or the one named frames</source>
        <translation>唯一的一个，或名为 frames 的那个</translation>
    </message>
    <message>
        <source>as the file says</source>
        <translation>按文件</translation>
    </message>
    <message>
        <source>the first</source>
        <translation>第一维</translation>
    </message>
    <message>
        <source>the last</source>
        <translation>最后一维</translation>
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
        <translation>表中作为触觉单元的列，从 1 数起</translation>
    </message>
    <message>
        <source>name or number of the column</source>
        <translation>列的名称或编号</translation>
    </message>
    <message>
        <source>as the name of the column ends</source>
        <translation>按列名的结尾</translation>
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
        <translation>文件：</translation>
    </message>
    <message>
        <source>&amp;Name of the frames:</source>
        <translation>帧的名称(&amp;N)：</translation>
    </message>
    <message>
        <source>&amp;Dimension that counts the frames:</source>
        <translation>计数帧的维度(&amp;D)：</translation>
    </message>
    <message>
        <source>&amp;Shape:</source>
        <translation>形状(&amp;S)：</translation>
    </message>
    <message>
        <source>&amp;Pitch:</source>
        <translation>间距(&amp;P)：</translation>
    </message>
    <message>
        <source>Column of the &amp;times:</source>
        <translation>时间的列(&amp;T)：</translation>
    </message>
    <message>
        <source>&amp;Unit of the times:</source>
        <translation>时间的单位(&amp;U)：</translation>
    </message>
    <message>
        <source>&amp;Rate, without times:</source>
        <translation>无时间时的速率(&amp;R)：</translation>
    </message>
    <message>
        <source>Columns are numbers and ranges, such as 2..85 or 2..10,12.</source>
        <translation>列用编号和范围表示，例如 2..85 或 2..10,12。</translation>
    </message>
    <message>
        <source>Load from which a taxel is in contact, in the unit of the values</source>
        <translation>触觉单元算作接触的起始负载，单位与数值相同</translation>
    </message>
    <message>
        <source>In contact &amp;from:</source>
        <translation>接触起始值(&amp;F)：</translation>
    </message>
    <message>
        <source>0.2 N, or one count</source>
        <translation>0.2 N 或一个计数</translation>
    </message>
    <message>
        <source>only for taxels off a grid, or with three components</source>
        <translation>仅用于不在网格上或有三个分量的触觉单元</translation>
    </message>
    <message>
        <source>The device file of the array, or a file with its table [layout]: it says where the taxels are. Rows, columns and pitch are not needed then.</source>
        <translation>阵列的设备文件，或含有其 [layout] 表的文件：说明触觉单元的位置。此时不需要行、列和间距。</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>选择…</translation>
    </message>
    <message>
        <source>File of the &amp;array:</source>
        <translation>阵列的文件(&amp;A)：</translation>
    </message>
    <message>
        <source>File of the array</source>
        <translation>阵列的文件</translation>
    </message>
    <message>
        <source>Arrays (*.toml)</source>
        <translation>阵列 (*.toml)</translation>
    </message>
    <message>
        <source>Co&amp;lumns of the taxels:</source>
        <translation>触觉单元的列(&amp;L)：</translation>
    </message>
</context>
<context>
    <name>teleta::console::FramePreview</name>
    <message>
        <source>Frame</source>
        <translation>帧</translation>
    </message>
    <message>
        <source>Choose a frame</source>
        <translation>选择一帧</translation>
    </message>
    <message>
        <source>Reading…</source>
        <translation>正在读取…</translation>
    </message>
    <message>
        <source>No frame to show.</source>
        <translation>没有可显示的帧。</translation>
    </message>
    <message numerus="yes">
        <source>%n frame(s) of %1 × %2 taxels, %3 to %4</source>
        <extracomment>Numbers of rows and columns, lowest and highest value</extracomment>
        <translation>
            <numerusform>%n 帧，%1 × %2 个触觉单元，%3 至 %4</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>The first %n frame(s) of %1 × %2 taxels, %3 to %4</source>
        <translation>
            <numerusform>前 %n 帧，%1 × %2 个触觉单元，%3 至 %4</numerusform>
        </translation>
    </message>
    <message>
        <source>Frame %1 of %2, %3 s</source>
        <translation>第 %1 帧，共 %2 帧，%3 s</translation>
    </message>
</context>
<context>
    <name>teleta::console::GainCalibrator</name>
    <message>
        <source>Open recorded presses</source>
        <translation>打开已记录的按压</translation>
    </message>
    <message>
        <source>Frames (*.csv)</source>
        <translation>帧 (*.csv)</translation>
    </message>
    <message>
        <source>Load gains</source>
        <translation>加载增益</translation>
    </message>
    <message>
        <source>Gains (*.csv)</source>
        <translation>增益 (*.csv)</translation>
    </message>
    <message>
        <source>Save the gains</source>
        <translation>保存增益</translation>
    </message>
    <message>
        <source>Choose another folder or file name.</source>
        <translation>请选择其他文件夹或文件名。</translation>
    </message>
    <message>
        <source>%1 could not be saved.</source>
        <comment>a file</comment>
        <translation>无法保存 %1。</translation>
    </message>
    <message>
        <source>The loads of the array will be shown here.</source>
        <translation>阵列的载荷将显示在这里。</translation>
    </message>
</context>
<context>
    <name>teleta::console::HandbookWindow</name>
    <message>
        <source>Handbook of the TeleTA Console</source>
        <translation>TeleTA Console 手册</translation>
    </message>
    <message>
        <source>← Back</source>
        <translation>← 后退</translation>
    </message>
    <message>
        <source>Forward →</source>
        <translation>前进 →</translation>
    </message>
    <message>
        <source>Find</source>
        <translation>查找</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>Find in the handbook (Ctrl+F)</source>
        <translation>在手册中查找（Ctrl+F）</translation>
    </message>
    <message>
        <source>Find in the handbook</source>
        <translation>在手册中查找</translation>
    </message>
    <message>
        <source>Pages of the handbook</source>
        <translation>手册页面列表</translation>
    </message>
    <message>
        <source>Page of the handbook</source>
        <translation>手册页面</translation>
    </message>
    <message>
        <source>Guide</source>
        <translation>指南</translation>
    </message>
    <message>
        <source>Reference</source>
        <translation>参考</translation>
    </message>
</context>
<context>
    <name>teleta::console::HelpMenu</name>
    <message>
        <source>&amp;Handbook</source>
        <translation>手册(&amp;H)</translation>
    </message>
    <message>
        <source>&amp;First steps</source>
        <translation>入门(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Shortcuts</source>
        <translation>快捷键(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;About TeleTA Console</source>
        <translation>关于 TeleTA Console(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Log</source>
        <translation>日志(&amp;L)</translation>
    </message>
</context>
<context>
    <name>teleta::console::ImportDialog</name>
    <message>
        <source>Open pattern</source>
        <translation>打开图案</translation>
    </message>
    <message>
        <source>A pattern cannot represent everything that %1 holds. Opening it changes or leaves out:</source>
        <comment>a file</comment>
        <translation>图案无法容纳 %1 中的全部内容。打开时将更改或略去：</translation>
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
        <translation>手臂(&amp;A)：</translation>
    </message>
    <message>
        <source>&amp;Motors:</source>
        <translation>电机(&amp;M)：</translation>
    </message>
</context>
<context>
    <name>teleta::console::JointViews</name>
    <message>
        <source>The arm is drawn without its meshes: %1</source>
        <translation>机械臂不带网格显示：%1</translation>
    </message>
    <message>
        <source>The arm reports joints that its description does not have: %1.</source>
        <translation>机械臂报告了其描述中没有的关节：%1。</translation>
    </message>
</context>
<context>
    <name>teleta::console::LatencyDialog</name>
    <message>
        <source>Latency of the bracelet</source>
        <translation>手环的延迟</translation>
    </message>
    <message>
        <source>Ten clicks are played on tactor 1 and heard at an input of the sound card: fix an accelerometer to the tactor, or lead a cable from its output to the input. The median is saved in the device file, and studies then count from when a stimulus is felt.</source>
        <translation>在振子1上播放十次咔嗒声，并在声卡的一个输入端听取：把加速度计固定在振子上，或用电缆把其输出接到该输入。中位数保存在设备文件中，研究从感觉到刺激的时刻开始计时。</translation>
    </message>
    <message>
        <source>&amp;Input:</source>
        <translation>输入(&amp;I)：</translation>
    </message>
    <message>
        <source>&amp;Look again</source>
        <translation>重新查找(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Save in the device file</source>
        <translation>保存到设备文件(&amp;S)</translation>
    </message>
    <message>
        <source>The sound server has no input.</source>
        <translation>声音服务器没有输入。</translation>
    </message>
    <message>
        <source>S&amp;top measuring</source>
        <translation>停止测量(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Measure</source>
        <translation>测量(&amp;M)</translation>
    </message>
    <message>
        <source>Playing clicks. Do not touch the tactor or the input.</source>
        <translation>正在播放咔嗒声。请勿触碰振子和输入。</translation>
    </message>
    <message>
        <source>Median %1 ms, spread %2 ms from the shortest to the longest.</source>
        <translation>中位数 %1 ms，从最短到最长相差 %2 ms。</translation>
    </message>
    <message>
        <source>It is saved in %1.</source>
        <comment>a file</comment>
        <translation>已保存在 %1 中。</translation>
    </message>
    <message>
        <source>The device file says %1 ms, as measured before.</source>
        <translation>设备文件中为 %1 ms（先前测得）。</translation>
    </message>
    <message>
        <source>Not measured yet. According to the sound server it is at most %1 ms.</source>
        <translation>尚未测量。声音服务器声称最多 %1 ms。</translation>
    </message>
</context>
<context>
    <name>teleta::console::LayoutsMenu</name>
    <message>
        <source>Ma&amp;ximise the view</source>
        <translation>最大化视图(&amp;X)</translation>
    </message>
    <message>
        <source>Show the view with the focus alone, or all again; a double click on a title does the same</source>
        <translation>仅显示具有焦点的视图，或重新显示全部视图；双击标题效果相同</translation>
    </message>
    <message>
        <source>La&amp;youts</source>
        <translation>布局(&amp;Y)</translation>
    </message>
    <message>
        <source>&amp;Save layout as…</source>
        <translation>将布局另存为(&amp;S)…</translation>
    </message>
    <message>
        <source>D&amp;elete</source>
        <translation>删除(&amp;E)</translation>
    </message>
    <message>
        <source>Save layout</source>
        <translation>保存布局</translation>
    </message>
    <message>
        <source>Name (a layout of the same name is replaced):</source>
        <translation>名称；已有的同名布局将被替换：</translation>
    </message>
</context>
<context>
    <name>teleta::console::LevelTaskForm</name>
    <message>
        <source>Task with levels</source>
        <translation>带刺激水平的任务</translation>
    </message>
    <message>
        <source>yes or no: was it there?</source>
        <translation>是或否：是否出现？</translation>
    </message>
    <message>
        <source>intervals: in which one was it?</source>
        <translation>时间区间：出现在哪个时间区间？</translation>
    </message>
    <message>
        <source>same or different</source>
        <translation>相同或不同</translation>
    </message>
    <message>
        <source>compare: which one had more?</source>
        <translation>比较：哪一个更多？</translation>
    </message>
    <message>
        <source>the usual question of the design</source>
        <translation>该设计的常用问题</translation>
    </message>
    <message>
        <source>for example rest, or weak 0.3, strong 0.7 with their references</source>
        <translation>例如 rest，或带参考的 weak 0.3, strong 0.7</translation>
    </message>
    <message>
        <source>name and tactors, one track per line, for example t1 1; tactors of the reference after /</source>
        <translation>名称和振子，每行一个序列，例如 t1 1；参考的振子写在 / 之后</translation>
    </message>
    <message>
        <source>full path of a pattern file</source>
        <translation>图案文件的完整路径</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>选择…</translation>
    </message>
    <message>
        <source>intensity</source>
        <translation>强度</translation>
    </message>
    <message>
        <source>time from burst to burst</source>
        <translation>相邻短振的间隔时间</translation>
    </message>
    <message>
        <source>length of a burst</source>
        <translation>短振的时长</translation>
    </message>
    <message>
        <source>length</source>
        <translation>时长</translation>
    </message>
    <message>
        <source>balance of a phantom</source>
        <translation>幻象的平衡</translation>
    </message>
    <message>
        <source>linear</source>
        <translation>线性</translation>
    </message>
    <message>
        <source>logarithmic (log10)</source>
        <translation>对数 (log10)</translation>
    </message>
    <message>
        <source>the highest</source>
        <translation>最高刺激水平</translation>
    </message>
    <message>
        <source>constant stimuli</source>
        <translation>恒定刺激法</translation>
    </message>
    <message>
        <source>staircase</source>
        <translation>阶梯法</translation>
    </message>
    <message>
        <source>Bayesian (QUEST+)</source>
        <translation>贝叶斯 (QUEST+)</translation>
    </message>
    <message>
        <source>levels with commas between them, for example 0.1, 0.2, 0.4</source>
        <translation>以逗号分隔的刺激水平，例如 0.1, 0.2, 0.4</translation>
    </message>
    <message>
        <source>Identifier</source>
        <translation>标识符</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Design</source>
        <translation>设计</translation>
    </message>
    <message>
        <source>Question</source>
        <translation>问题</translation>
    </message>
    <message>
        <source>Conditions</source>
        <translation>条件</translation>
    </message>
    <message>
        <source>Intervals</source>
        <translation>时间区间数</translation>
    </message>
    <message>
        <source>Gap between intervals, s</source>
        <translation>时间区间之间的间隔，s</translation>
    </message>
    <message>
        <source>Share of catch trials</source>
        <translation>捕捉试次的比例</translation>
    </message>
    <message>
        <source>Tracks</source>
        <translation>序列</translation>
    </message>
    <message>
        <source>Stimulus</source>
        <translation>刺激</translation>
    </message>
    <message>
        <source>A level sets the</source>
        <translation>刺激水平所设定的量</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>标度</translation>
    </message>
    <message>
        <source>Lowest level</source>
        <translation>最低刺激水平</translation>
    </message>
    <message>
        <source>Highest level</source>
        <translation>最高刺激水平</translation>
    </message>
    <message>
        <source>Reference; 0 is nothing</source>
        <translation>参考；0 表示无</translation>
    </message>
    <message>
        <source>Level of the practice</source>
        <translation>练习的刺激水平</translation>
    </message>
    <message>
        <source>Levels are chosen by</source>
        <translation>刺激水平的选取方式</translation>
    </message>
    <message>
        <source>Levels</source>
        <translation>刺激水平</translation>
    </message>
    <message>
        <source>Remove this task</source>
        <translation>移除此任务</translation>
    </message>
    <message>
        <source>First level</source>
        <translation>第一个刺激水平</translation>
    </message>
    <message>
        <source>Right answers for a step down</source>
        <translation>下降一步所需的正确回答数</translation>
    </message>
    <message>
        <source>Reversals with larger steps</source>
        <translation>采用较大步长的反转点数</translation>
    </message>
    <message>
        <source>Reversals at most</source>
        <translation>反转点上限</translation>
    </message>
    <message>
        <source>Trials at most</source>
        <translation>试次上限</translation>
    </message>
    <message>
        <source>Function</source>
        <translation>函数</translation>
    </message>
    <message>
        <source>Slopes or spreads</source>
        <translation>斜率或离散度</translation>
    </message>
    <message>
        <source>Lapse rates</source>
        <translation>失误率</translation>
    </message>
    <message>
        <source>Rates of yes without a stimulus</source>
        <translation>无刺激时回答“是”的比率</translation>
    </message>
    <message>
        <source>Levels of the grid</source>
        <translation>网格的刺激水平数</translation>
    </message>
    <message>
        <source>Mean of the prior, in the scale</source>
        <translation>先验的平均值（按标度）</translation>
    </message>
    <message>
        <source>all thresholds are equally likely</source>
        <translation>所有阈值的可能性相同</translation>
    </message>
    <message>
        <source>Its standard deviation</source>
        <translation>其标准差</translation>
    </message>
    <message>
        <source>Trials at least</source>
        <translation>试次下限</translation>
    </message>
    <message>
        <source>Ends with a standard deviation of</source>
        <translation>结束时的标准差</translation>
    </message>
    <message>
        <source>only with its trials</source>
        <translation>仅在试次用完时</translation>
    </message>
    <message>
        <source>Pattern file of the stimulus</source>
        <translation>刺激的图案文件</translation>
    </message>
    <message>
        <source>Detection</source>
        <translation>检测</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; is not a number</source>
        <comment>a row of the form</comment>
        <translation>%1：“%2”不是数</translation>
    </message>
    <message>
        <source>a number with a point, such as 0.5</source>
        <translation>带小数点的数，例如 0.5</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a number</source>
        <translation>“%1”不是数</translation>
    </message>
    <message>
        <source>numbers with a point, such as 0.1, 0.2</source>
        <translation>带小数点的数，例如 0.1, 0.2</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a whole number</source>
        <translation>“%1”不是整数</translation>
    </message>
    <message>
        <source>a number such as 12</source>
        <translation>数，例如 12</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no tactor</source>
        <translation>“%1”不是振子</translation>
    </message>
    <message>
        <source>a name and numbers of tactors, for example t1 1</source>
        <translation>名称和振子编号，例如 t1 1</translation>
    </message>
    <message>
        <source>a condition and its reference, such as weak 0.3</source>
        <translation>条件及其参考，例如 weak 0.3</translation>
    </message>
    <message>
        <source>Step up, log10 units on a log scale</source>
        <translation>上升步长，对数标度时以 log10 为单位</translation>
    </message>
    <message>
        <source>Step down, likewise</source>
        <translation>下降步长，同上</translation>
    </message>
    <message>
        <source>These steps are larger by</source>
        <translation>这些步长的放大倍数</translation>
    </message>
    <message>
        <source>First reversals left out</source>
        <translation>略去的最初反转点数</translation>
    </message>
    <message>
        <source>It stays at</source>
        <translation>收敛于</translation>
    </message>
    <message>
        <source>Levels are shares of the intensity in the file, 0 to 1.</source>
        <translation>刺激水平为文件中强度的比例，0 至 1。</translation>
    </message>
    <message>
        <source>Levels are balances, from 0 (the first tactor alone) to 1 (the second alone).</source>
        <translation>刺激水平为平衡值，从 0（仅第一个振子）到 1（仅第二个振子）。</translation>
    </message>
    <message>
        <source>Levels are times in seconds.</source>
        <translation>刺激水平为时间，单位 s。</translation>
    </message>
    <message>
        <source>%1 % right answers</source>
        <translation>正确回答 %1 %</translation>
    </message>
</context>
<context>
    <name>teleta::console::LiveProbing</name>
    <message>
        <source>The camera is open but sends no frames.</source>
        <translation>相机已打开，但没有帧到来。</translation>
    </message>
    <message>
        <source>The camera&apos;s image size has changed from %1 × %2 to %3 × %4 pixels. Start probing again.</source>
        <translation>相机图像已从 %1 × %2 变为 %3 × %4 像素。请重新开始探测。</translation>
    </message>
</context>
<context>
    <name>teleta::console::LiveProbingDialog</name>
    <message>
        <source>Probe with a camera</source>
        <translation>用相机探测</translation>
    </message>
    <message>
        <source>Ri&amp;ngs:</source>
        <translation>圈数(&amp;N)：</translation>
    </message>
    <message>
        <source>&amp;First ring at z =</source>
        <translation>第一圈位于 z(&amp;F) =</translation>
    </message>
    <message>
        <source>&amp;Last ring at z =</source>
        <translation>最后一圈位于 z(&amp;L) =</translation>
    </message>
    <message>
        <source>An&amp;gle of the first hole:</source>
        <translation>第一个孔的角度(&amp;G)：</translation>
    </message>
    <message>
        <source>&amp;Probe</source>
        <translation>探测(&amp;P)</translation>
    </message>
    <message>
        <source>Angle of the first hole of each ring, from the x axis towards y</source>
        <translation>每一圈第一个孔的角度，从 x 轴转向 y</translation>
    </message>
    <message>
        <source>Holes per &amp;ring:</source>
        <translation>每圈孔数(&amp;R)：</translation>
    </message>
    <message>
        <source>Camera or &amp;video:</source>
        <translation>相机或视频(&amp;V)：</translation>
    </message>
</context>
<context>
    <name>teleta::console::LiveProbingPanel</name>
    <message>
        <source>The video is over.</source>
        <translation>视频已结束。</translation>
    </message>
    <message>
        <source>All holes are probed.</source>
        <translation>所有孔均已探测。</translation>
    </message>
    <message>
        <source>All holes are probed</source>
        <translation>所有孔均已探测</translation>
    </message>
    <message>
        <source>Hole %1 of %2: ring %3, %4&#xa0;mm, %5°</source>
        <translation>第 %1 孔，共 %2 孔：第 %3 圈，%4&#xa0;mm，%5°</translation>
    </message>
    <message>
        <source>Press the stick into this hole.</source>
        <translation>请将探棒压入此孔。</translation>
    </message>
    <message>
        <source>Hold still.</source>
        <translation>请保持不动。</translation>
    </message>
    <message>
        <source>Taken. Lift the stick.</source>
        <translation>已采集。请抬起探棒。</translation>
    </message>
    <message>
        <source>How long the stick has been held still</source>
        <translation>探棒保持不动的时间</translation>
    </message>
    <message>
        <source>What the camera sees</source>
        <translation>相机所见</translation>
    </message>
    <message>
        <source>Sto&amp;p probing</source>
        <translation>停止探测(&amp;P)</translation>
    </message>
    <message>
        <source>Lift the stick first.</source>
        <translation>请先抬起探棒。</translation>
    </message>
    <message>
        <source>Waiting for the camera: %1</source>
        <translation>正在等待相机：%1</translation>
    </message>
    <message>
        <source>Waiting for the first frame. Nothing may touch the skin.</source>
        <translation>正在等待第一帧。请勿触碰皮肤。</translation>
    </message>
    <message>
        <source>Waiting for a frame in which nothing touches the skin: %1</source>
        <translation>正在等待皮肤未被触碰的一帧：%1</translation>
    </message>
    <message>
        <source>The skin is touched in several places. Remove everything but the stick.</source>
        <translation>皮肤有多处被触碰。请移开探棒以外的物体。</translation>
    </message>
    <message>
        <source>Back to the previous hole. Probing it again replaces its pixel</source>
        <translation>上一个孔。重新探测的孔会得到新的像素</translation>
    </message>
    <message>
        <source>Skip this hole for now</source>
        <translation>暂时略过此孔</translation>
    </message>
    <message>
        <source>Ne&amp;w reference</source>
        <translation>现在未触碰(&amp;U)</translation>
    </message>
    <message>
        <source>Take the next frame as the reference: nothing may touch the skin</source>
        <translation>下一帧显示未被触碰的皮肤</translation>
    </message>
    <message>
        <source>Keep the pairs collected so far</source>
        <translation>保留目前采集的内容</translation>
    </message>
    <message>
        <source>Bac&amp;k</source>
        <translation>返回(&amp;K)</translation>
    </message>
    <message>
        <source>Sk&amp;ip</source>
        <translation>跳过(&amp;I)</translation>
    </message>
</context>
<context>
    <name>teleta::console::LiveViewService</name>
    <message>
        <source>Li&amp;ve view for Foxglove</source>
        <translation>用于 Foxglove 的实时视图(&amp;V)</translation>
    </message>
    <message numerus="yes">
        <source>%n viewer(s)</source>
        <translation>
            <numerusform>%n 个查看者</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n message(s) missed</source>
        <translation>
            <numerusform>遗漏 %n 条消息</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>teleta::console::LoadCalibrator</name>
    <message>
        <source>the table has no load</source>
        <translation>表格中没有载荷</translation>
    </message>
    <message>
        <source>a column force_n, shear_x_n, shear_y_n or moment_nm</source>
        <translation>列 force_n、shear_x_n、shear_y_n 或 moment_nm</translation>
    </message>
    <message>
        <source>Open presses with a known load</source>
        <translation>打开已知载荷的按压</translation>
    </message>
    <message>
        <source>Presses (*.csv)</source>
        <translation>按压 (*.csv)</translation>
    </message>
    <message>
        <source>Load a calibration</source>
        <translation>载入标定</translation>
    </message>
    <message>
        <source>Calibrations (*.csv)</source>
        <translation>标定 (*.csv)</translation>
    </message>
    <message>
        <source>Save the calibration</source>
        <translation>保存标定</translation>
    </message>
    <message>
        <source>%1 could not be saved.</source>
        <comment>a file</comment>
        <translation>无法保存 %1。</translation>
    </message>
</context>
<context>
    <name>teleta::console::LogWindow</name>
    <message>
        <source>Save log</source>
        <translation>保存日志</translation>
    </message>
    <message>
        <source>Text (*.txt)</source>
        <translation>文本 (*.txt)</translation>
    </message>
    <message>
        <source>Log</source>
        <translation>日志</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>复制(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Save…</source>
        <translation>保存(&amp;S)…</translation>
    </message>
    <message>
        <source>C&amp;lose</source>
        <translation>关闭(&amp;L)</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>已保存 %1</translation>
    </message>
    <message>
        <source>%1 could not be saved: %2</source>
        <translation>无法写入 %1：%2</translation>
    </message>
    <message>
        <source>Messages since the program started</source>
        <translation>程序启动以来的消息</translation>
    </message>
</context>
<context>
    <name>teleta::console::MainWindow</name>
    <message>
        <source>Looking for the site of %1…</source>
        <translation>正在查找 %1 的站点…</translation>
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
        <translation>机械臂所触碰的内容，实时或回放</translation>
    </message>
    <message>
        <source>Open recording</source>
        <translation>打开记录</translation>
    </message>
    <message>
        <source>Open source list</source>
        <translation>打开数据源列表</translation>
    </message>
    <message>
        <source>Source lists (*.toml)</source>
        <translation>数据源列表 (*.toml)</translation>
    </message>
    <message>
        <source>Open scene</source>
        <translation>打开场景</translation>
    </message>
    <message>
        <source>Scenes (*.toml)</source>
        <translation>场景 (*.toml)</translation>
    </message>
    <message>
        <source>%1 could not be opened.</source>
        <comment>a file</comment>
        <translation>无法打开 %1。</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>文件(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Open</source>
        <translation>打开(&amp;O)</translation>
    </message>
    <message>
        <source>&amp;Close source</source>
        <translation>关闭数据源(&amp;C)</translation>
    </message>
    <message>
        <source>Close the source that is shown</source>
        <translation>关闭当前显示的数据源</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>退出(&amp;Q)</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>视图(&amp;V)</translation>
    </message>
    <message>
        <source>&amp;Reset layout</source>
        <translation>重置布局(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>浅色(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation>深色(&amp;D)</translation>
    </message>
    <message>
        <source>&amp;Full screen</source>
        <translation>全屏(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>帮助(&amp;H)</translation>
    </message>
    <message>
        <source>&amp;Arm</source>
        <translation>机械臂(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Run its program</source>
        <translation>运行程序(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Hold</source>
        <translation>保持(&amp;H)</translation>
    </message>
    <message>
        <source>&amp;Forget the explored contour</source>
        <translation>清除已探索的轮廓(&amp;F)</translation>
    </message>
    <message>
        <source>What is touched from now on is another object</source>
        <translation>此后触碰的是另一个物体</translation>
    </message>
    <message>
        <source>&amp;Bracelet</source>
        <translation>手环(&amp;B)</translation>
    </message>
    <message>
        <source>Patterns</source>
        <translation>图案</translation>
    </message>
    <message>
        <source>What the bracelet can say: edit, check and play patterns</source>
        <translation>手环能表达的内容：编辑、检查和播放图案</translation>
    </message>
    <message>
        <source>Study</source>
        <translation>研究</translation>
    </message>
    <message>
        <source>User studies: from the first practice trial to confusion matrices and ANOVA</source>
        <translation>用户研究：从第一个练习试次到混淆矩阵和方差分析</translation>
    </message>
    <message>
        <source>Calibrate</source>
        <translation>标定</translation>
    </message>
    <message>
        <source>Cost</source>
        <translation>代价</translation>
    </message>
    <message>
        <source>The page Patterns opens the edits.</source>
        <translation>“图案”页将打开这些编辑内容。</translation>
    </message>
    <message>
        <source>my own</source>
        <translation>自定义</translation>
    </message>
    <message>
        <source>dynamic</source>
        <translation>动态</translation>
    </message>
    <message>
        <source>static</source>
        <translation>静态</translation>
    </message>
    <message>
        <source>As the de&amp;sktop</source>
        <translation>跟随桌面(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Recording</source>
        <translation>记录(&amp;R)</translation>
    </message>
    <message>
        <source>What has to be measured: the motors of the bracelet, the camera in the tube, the taxels</source>
        <translation>需要测量的内容：手环的电机、管内的相机、触觉单元</translation>
    </message>
    <message>
        <source>Re&amp;start</source>
        <translation>重新开始(&amp;S)</translation>
    </message>
    <message>
        <source>Foxglove can be connected to %1.</source>
        <translation>Foxglove 可连接到 %1。</translation>
    </message>
    <message>
        <source>Open connection &gt; Foxglove WebSocket shows all sources there.</source>
        <translation>在其中选择 Open connection &gt; Foxglove WebSocket 即可显示所有数据源。</translation>
    </message>
    <message>
        <source>The live view has ended.</source>
        <translation>实时视图已结束。</translation>
    </message>
    <message>
        <source>Choose another port with --foxglove.</source>
        <translation>请用 --foxglove 选择另一个端口。</translation>
    </message>
    <message>
        <source>The layout %1 cannot be restored; the default one is shown.</source>
        <translation>无法恢复布局 %1；显示默认布局。</translation>
    </message>
    <message>
        <source>It was saved by another version of the program.</source>
        <translation>它由另一版本的程序保存。</translation>
    </message>
    <message>
        <source>The desktop may turn the screen off while something runs: %1</source>
        <translation>有任务运行时，桌面可能会关闭屏幕：%1</translation>
    </message>
    <message>
        <source>%1 was made from %2.</source>
        <comment>two files</comment>
        <translation>%1 已由 %2 创建。</translation>
    </message>
    <message>
        <source>A robot arm, a recording or a session is running</source>
        <translation>机械臂、记录或场次正在运行</translation>
    </message>
    <message>
        <source>&amp;Preferences…</source>
        <translation>首选项(&amp;P)…</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>打开最近使用的内容(&amp;R)</translation>
    </message>
    <message>
        <source>Recordings</source>
        <translation>记录</translation>
    </message>
    <message>
        <source>Studies</source>
        <translation>研究</translation>
    </message>
    <message>
        <source>&amp;Clear the list</source>
        <translation>清空列表(&amp;C)</translation>
    </message>
    <message>
        <source>Reopen the &amp;last session</source>
        <translation>重新打开上次的内容(&amp;L)</translation>
    </message>
    <message>
        <source>STOP was released after %1 s.</source>
        <translation>STOP 在 %1 s 后被解除。</translation>
    </message>
    <message>
        <source>STOP. %1</source>
        <comment>cause</comment>
        <translation>STOP。%1</translation>
    </message>
    <message>
        <source>Open arm</source>
        <translation>打开机械臂</translation>
    </message>
    <message>
        <source>&amp;Open arm…</source>
        <translation>打开机械臂(&amp;O)…</translation>
    </message>
    <message>
        <source>An arm over ROS 2, described in a file</source>
        <translation>通过 ROS 2 的机械臂，由文件描述</translation>
    </message>
    <message>
        <source>Scenes, arms and source lists</source>
        <translation>场景、机械臂和信号源列表</translation>
    </message>
    <message>
        <source>Recordings (*.teleta *.csv *.mcap *.npz *.npy *.h5 *.hdf5 *.mat *.asf)</source>
        <translation>记录 (*.teleta *.csv *.mcap *.npz *.npy *.h5 *.hdf5 *.mat *.asf)</translation>
    </message>
    <message>
        <source>Plot</source>
        <translation>绘图</translation>
    </message>
    <message>
        <source>Any signal over time: live ones and those of recordings, with cursors and spectra</source>
        <translation>任何信号随时间的变化：实时信号与记录中的信号，带光标和频谱</translation>
    </message>
    <message>
        <source>Connect to a site</source>
        <translation>连接到站点</translation>
    </message>
    <message>
        <source>Sites (*.toml)</source>
        <translation>站点 (*.toml)</translation>
    </message>
    <message>
        <source>&amp;Connect to a site…</source>
        <translation>连接到站点(&amp;C)…</translation>
    </message>
    <message>
        <source>Arms and arrays at another place, where teleta-site runs</source>
        <translation>另一地点（运行 teleta-site）的机械臂和阵列</translation>
    </message>
    <message>
        <source>Re&amp;quest control of the site</source>
        <translation>请求站点的控制权(&amp;Q)</translation>
    </message>
    <message>
        <source>Rele&amp;ase control of the site</source>
        <translation>释放站点的控制权(&amp;A)</translation>
    </message>
    <message>
        <source>What accuracy costs in time on this machine, and the setting that the camera uses</source>
        <translation>精度在本机上的时间代价，以及相机使用的设置</translation>
    </message>
    <message>
        <source>Arms (*.toml)</source>
        <translation>机械臂 (*.toml)</translation>
    </message>
    <message>
        <source>Hand o&amp;ver to</source>
        <translation>移交给(&amp;V)</translation>
    </message>
    <message>
        <source>&amp;Take over control of the site</source>
        <translation>接管站点的控制权(&amp;T)</translation>
    </message>
    <message>
        <source>For supervisors: the other console has 5 s to decline</source>
        <translation>供监督者使用：对方控制台有 5 秒时间拒绝</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1（%2）</translation>
    </message>
</context>
<context>
    <name>teleta::console::MarkList</name>
    <message>
        <source>Time</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>What was marked</source>
        <translation>标记内容</translation>
    </message>
    <message>
        <source>Marks</source>
        <translation>标记</translation>
    </message>
    <message>
        <source>Moments that somebody marked in the recording. Double-click a text or press Enter to type it, Delete takes a mark out, Ctrl+Z undoes. In a recording that is played, a double click on a mark goes there.</source>
        <translation>记录中被标记的时刻。双击文字或按 Enter 可输入，Delete 删除标记，Ctrl+Z 撤销。在回放的记录中，双击标记可跳转到该处。</translation>
    </message>
    <message>
        <source>This recording is played: Enter goes to a mark. Marks are named while they are recorded, or afterwards beside the source that was recorded.</source>
        <translation>正在回放此记录：按 Enter 跳到标记。标记在记录期间命名，或在记录之后于所记录的数据源旁命名。</translation>
    </message>
    <message>
        <source>No marks yet. While something is recorded, M sets one. Press Enter on it to type what it was.</source>
        <translation>还没有标记。记录时按 M 添加标记。在该标记上按 Enter 输入其内容。</translation>
    </message>
</context>
<context>
    <name>teleta::console::MotorCalibrator</name>
    <message>
        <source>Open the recording of a motor</source>
        <translation>打开电机的记录</translation>
    </message>
    <message>
        <source>Recordings (*.csv)</source>
        <translation>记录 (*.csv)</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>表格 (*.csv)</translation>
    </message>
    <message>
        <source>Save a copy of the profile</source>
        <translation>保存配置的副本</translation>
    </message>
    <message>
        <source>Profiles (*.toml)</source>
        <translation>配置 (*.toml)</translation>
    </message>
    <message>
        <source>Load a profile</source>
        <translation>加载配置</translation>
    </message>
    <message>
        <source>Choose another folder or file name.</source>
        <translation>请选择其他文件夹或文件名。</translation>
    </message>
    <message>
        <source>%1 could not be opened.</source>
        <comment>a file</comment>
        <translation>无法打开 %1。</translation>
    </message>
    <message>
        <source>%1 could not be saved.</source>
        <comment>a file</comment>
        <translation>无法保存 %1。</translation>
    </message>
    <message>
        <source>The motor profile cannot be used: the motors use assumed values.</source>
        <translation>无法使用电机配置；电机采用假定值。</translation>
    </message>
    <message>
        <source>Save the excitation</source>
        <translation>写出激励信号</translation>
    </message>
    <message>
        <source>%1 belongs to another bracelet.</source>
        <comment>a file</comment>
        <translation>%1 属于另一个手环。</translation>
    </message>
    <message>
        <source>The file is for “%1”, this bracelet is “%2”. Measure this one, or connect the other.</source>
        <translation>它属于“%1”，而当前手环为“%2”。请测量当前手环，或连接另一个。</translation>
    </message>
    <message>
        <source>Motor %1 was measured and is not saved.</source>
        <translation>电机 %1 已测量，尚未保存。</translation>
    </message>
    <message>
        <source>Motors %1 were measured and are not saved.</source>
        <comment>1, 2</comment>
        <translation>电机 %1 已测量，尚未保存。</translation>
    </message>
    <message>
        <source>Motor %1 was changed and is not saved.</source>
        <translation>电机 %1 已更改，尚未保存。</translation>
    </message>
    <message>
        <source>Motors %1 were changed and are not saved.</source>
        <comment>1, 2</comment>
        <translation>电机 %1 已更改，尚未保存。</translation>
    </message>
</context>
<context>
    <name>teleta::console::NewStudyDialog</name>
    <message>
        <source>&amp;Participants</source>
        <translation>被试(&amp;P)</translation>
    </message>
    <message>
        <source>New study</source>
        <translation>新建研究</translation>
    </message>
    <message>
        <source>Pilot: people try it, marked PILOT everywhere</source>
        <translation>预试：由人试做，处处标为“预试”</translation>
    </message>
    <message>
        <source>Simulated: no people, marked SIMULATED everywhere</source>
        <translation>模拟：无真人参与，处处标为“模拟”</translation>
    </message>
    <message>
        <source>&amp;Mode</source>
        <translation>模式(&amp;M)</translation>
    </message>
    <message>
        <source>&amp;Seed</source>
        <translation>种子(&amp;S)</translation>
    </message>
    <message>
        <source>The seed is a whole number from 0 to 18446744073709551615.</source>
        <translation>种子为 0 至 18446744073709551615 的整数。</translation>
    </message>
    <message>
        <source>F&amp;rom a file…</source>
        <translation>从文件(&amp;R)…</translation>
    </message>
    <message>
        <source>A protocol of your own (TOML)</source>
        <translation>您自己的方案 (TOML)</translation>
    </message>
    <message>
        <source>Pr&amp;otocol</source>
        <translation>方案(&amp;O)</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <comment>a protocol; where it is from</comment>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Open a protocol</source>
        <translation>打开方案</translation>
    </message>
    <message>
        <source>Protocols (*.toml)</source>
        <translation>方案 (*.toml)</translation>
    </message>
    <message>
        <source>In a file in this folder, for one station</source>
        <translation>存于此文件夹的文件中：单个工作站</translation>
    </message>
    <message>
        <source>On a PostgreSQL server, shared by several stations</source>
        <translation>存于 PostgreSQL 服务器：多个工作站共用</translation>
    </message>
    <message>
        <source>Run: real participants, data count</source>
        <translation>正式：真实被试，计为数据</translation>
    </message>
    <message>
        <source>New &amp;folder</source>
        <translation>要创建的文件夹(&amp;F)</translation>
    </message>
    <message>
        <source>S&amp;torage</source>
        <translation>存储位置(&amp;K)</translation>
    </message>
    <message>
        <source>Create the study</source>
        <translation>创建研究</translation>
    </message>
    <message>
        <source>Study folder</source>
        <translation>研究的文件夹</translation>
    </message>
    <message numerus="yes">
        <source>%n test trial(s) per participant</source>
        <translation>
            <numerusform>每名被试 %n 个测试试次</numerusform>
        </translation>
    </message>
    <message>
        <source>There is no tactile pattern for %1: name a file for it in the protocol.</source>
        <translation>此方案没有可供感受的图案 %1：请在方案中为它指定文件。</translation>
    </message>
    <message>
        <source>Choose a folder by its full path.</source>
        <translation>请选择文件夹，使用完整路径。</translation>
    </message>
    <message>
        <source>The file is not a usable protocol; the one above stays selected. %1</source>
        <translation>该文件不是可用的方案；仍选用上面的方案。%1</translation>
    </message>
    <message>
        <source>Determines the order of all trials: the same seed gives the same study. It is drawn at random, shown here and kept with the study.</source>
        <translation>决定所有试次的顺序：相同的种子得到相同的研究。它随机抽取，显示在此处，并随研究保存。</translation>
    </message>
    <message>
        <source>C&amp;hoose…</source>
        <translation>选择(&amp;H)…</translation>
    </message>
</context>
<context>
    <name>teleta::console::NoisePlayer</name>
    <message>
        <source>this computer has no sound output</source>
        <translation>此计算机没有声音输出</translation>
    </message>
    <message>
        <source>%1 cannot play 48 kHz</source>
        <comment>a sound output</comment>
        <translation>%1 无法播放 48 kHz</translation>
    </message>
    <message>
        <source>the sound output stopped</source>
        <translation>声音输出已停止</translation>
    </message>
    <message>
        <source>headphones that stay plugged in</source>
        <translation>保持插入的耳机</translation>
    </message>
    <message>
        <source>headphones, plugged in, or the noise from another device</source>
        <translation>已插入的耳机，或由其他设备播放噪声</translation>
    </message>
</context>
<context>
    <name>teleta::console::OperateDocks</name>
    <message>
        <source>Heatmap</source>
        <translation>热图</translation>
    </message>
    <message>
        <source>Reconstruction</source>
        <translation>重建</translation>
    </message>
    <message>
        <source>Features over time</source>
        <translation>特征随时间的变化</translation>
    </message>
    <message>
        <source>Processing</source>
        <translation>处理</translation>
    </message>
    <message>
        <source>Stiffness</source>
        <translation>刚度</translation>
    </message>
    <message>
        <source>Bracelet</source>
        <translation>手环</translation>
    </message>
    <message>
        <source>Joints</source>
        <translation>关节</translation>
    </message>
    <message>
        <source>Touches</source>
        <translation>触碰</translation>
    </message>
    <message>
        <source>Jog</source>
        <translation>点动</translation>
    </message>
    <message>
        <source>Feedback</source>
        <translation>反馈</translation>
    </message>
    <message>
        <source>Contour</source>
        <translation>轮廓</translation>
    </message>
    <message>
        <source>Servo</source>
        <translation>伺服</translation>
    </message>
    <message>
        <source>Servo runs</source>
        <translation>伺服运行</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>相机</translation>
    </message>
    <message>
        <source>Events</source>
        <translation>事件</translation>
    </message>
    <message>
        <source>Marks</source>
        <translation>标记</translation>
    </message>
    <message>
        <source>Run sheet</source>
        <translation>物体清单</translation>
    </message>
    <message>
        <source>Gel</source>
        <translation>凝胶</translation>
    </message>
    <message>
        <source>Scene</source>
        <translation>现场</translation>
    </message>
</context>
<context>
    <name>teleta::console::OperatePage</name>
    <message>
        <source>Choose another folder or file name.</source>
        <translation>请选择其他文件夹或文件名。</translation>
    </message>
    <message>
        <source>joints</source>
        <translation>关节</translation>
    </message>
    <message>
        <source>The bracelet could not be opened.</source>
        <translation>无法打开手环。</translation>
    </message>
    <message>
        <source>%1: joints</source>
        <comment>a source</comment>
        <translation>%1：关节</translation>
    </message>
    <message>
        <source>Check mesh_path in the file with which you opened the arm or its site.</source>
        <translation>请检查打开机械臂或其站点所用文件中的 mesh_path。</translation>
    </message>
    <message>
        <source>Opening %1…</source>
        <comment>a source</comment>
        <translation>正在打开 %1…</translation>
    </message>
    <message>
        <source>Its views come up as soon as it answers.</source>
        <translation>一有应答，其视图就会出现。</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>取消(&amp;C)</translation>
    </message>
    <message>
        <source>Closes it again</source>
        <translation>将其关闭</translation>
    </message>
    <message>
        <source>They are left out. Compare [joint_names] in the arm&apos;s file.</source>
        <translation>它们被忽略。请与机械臂文件中的 [joint_names] 比较。</translation>
    </message>
    <message>
        <source>The scene is held.</source>
        <translation>场景保持停止。</translation>
    </message>
    <message>
        <source>Nothing goes on by itself after STOP.</source>
        <translation>STOP 之后，任何东西都不会自行继续。</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>运行</translation>
    </message>
    <message>
        <source>not for %1</source>
        <comment>the bracelet plays no touches of an arm</comment>
        <translation>不用于 %1</translation>
    </message>
    <message>
        <source>The bracelet does not play the touches of %1.</source>
        <comment>an arm</comment>
        <translation>手环不播放 %1 的触碰。</translation>
    </message>
    <message>
        <source>It plays those of the arm that is shown.</source>
        <translation>它播放所显示机械臂的触碰。</translation>
    </message>
    <message>
        <source>Show %1</source>
        <comment>an arm</comment>
        <translation>显示 %1</translation>
    </message>
</context>
<context>
    <name>teleta::console::PairEntry</name>
    <message>
        <source>Pi&amp;xel, px:</source>
        <translation>像素，px(&amp;X)：</translation>
    </message>
    <message>
        <source>&amp;Point, mm:</source>
        <translation>点，mm(&amp;P)：</translation>
    </message>
    <message>
        <source>u, to the right</source>
        <translation>u，向右</translation>
    </message>
    <message>
        <source>v, down</source>
        <translation>v，向下</translation>
    </message>
    <message>
        <source>x of the point</source>
        <translation>点的 x</translation>
    </message>
    <message>
        <source>y of the point</source>
        <translation>点的 y</translation>
    </message>
    <message>
        <source>z of the point, along the tube</source>
        <translation>点的 z，沿管方向</translation>
    </message>
    <message>
        <source>Add this pair (Enter)</source>
        <translation>加入此点对 (Enter)</translation>
    </message>
    <message>
        <source>A&amp;dd pair</source>
        <translation>添加点对(&amp;D)</translation>
    </message>
</context>
<context>
    <name>teleta::console::PatternCollection</name>
    <message>
        <source>The pattern could not be saved.</source>
        <translation>无法保存图案。</translation>
    </message>
    <message>
        <source>The pattern could not be duplicated.</source>
        <translation>无法创建图案的副本。</translation>
    </message>
    <message>
        <source>%1 could not be renamed.</source>
        <comment>a pattern</comment>
        <translation>无法重命名 %1。</translation>
    </message>
    <message>
        <source>%1 could not be deleted.</source>
        <comment>a pattern</comment>
        <translation>无法删除 %1。</translation>
    </message>
    <message>
        <source>%1 was renamed.</source>
        <comment>a pattern</comment>
        <translation>已重命名 %1。</translation>
    </message>
    <message>
        <source>%1 was deleted.</source>
        <comment>a pattern</comment>
        <translation>已删除 %1。</translation>
    </message>
    <message>
        <source>%1 could not be restored.</source>
        <comment>a pattern</comment>
        <translation>无法恢复 %1。</translation>
    </message>
</context>
<context>
    <name>teleta::console::PatternPlayback</name>
    <message>
        <source>The pattern is shown on the screen but not felt.</source>
        <translation>播放的内容只会显示，不会被感受到。</translation>
    </message>
</context>
<context>
    <name>teleta::console::PatternsPage</name>
    <message>
        <source>%1 (copy)</source>
        <translation>%1（副本）</translation>
    </message>
    <message>
        <source>%1 could not be opened.</source>
        <comment>a file</comment>
        <translation>无法打开 %1。</translation>
    </message>
    <message>
        <source>New pattern</source>
        <translation>新图案</translation>
    </message>
    <message>
        <source>%1 could not be saved.</source>
        <comment>a file</comment>
        <translation>无法保存 %1。</translation>
    </message>
    <message>
        <source>Exporting %1…</source>
        <comment>a file</comment>
        <translation>正在导出 %1…</translation>
    </message>
    <message>
        <source>%1 was exported.</source>
        <comment>a file</comment>
        <translation>已导出 %1。</translation>
    </message>
    <message>
        <source>%1 could not be exported.</source>
        <comment>a file</comment>
        <translation>无法导出 %1。</translation>
    </message>
    <message>
        <source>Unsaved edits</source>
        <translation>未保存的编辑</translation>
    </message>
    <message numerus="yes">
        <source>There are %n more.</source>
        <translation>
            <numerusform>还有 %n 个。</numerusform>
        </translation>
    </message>
    <message>
        <source>Save pattern</source>
        <translation>保存图案</translation>
    </message>
    <message>
        <source>Open pattern</source>
        <translation>打开图案</translation>
    </message>
    <message>
        <source>Patterns (*.json)</source>
        <translation>图案 (*.json)</translation>
    </message>
    <message>
        <source>HJIF (*.hjif)</source>
        <translation>HJIF (*.hjif)</translation>
    </message>
    <message>
        <source>Haptic clips (*.haptic *.haptic.zip)</source>
        <translation>触觉片段 (*.haptic *.haptic.zip)</translation>
    </message>
    <message>
        <source>tact (*.tact)</source>
        <translation>tact (*.tact)</translation>
    </message>
    <message>
        <source>Open the edits</source>
        <translation>打开编辑内容</translation>
    </message>
    <message>
        <source>Discard them</source>
        <translation>放弃编辑内容</translation>
    </message>
    <message>
        <source>Unsaved edits could not be backed up: a crash would lose them.</source>
        <translation>无法暂存未保存的编辑：程序崩溃时将会丢失。</translation>
    </message>
    <message>
        <source>The strength limit of the bracelet could not be read or saved: check the slider Strongest.</source>
        <translation>无法读取或保存手环的强度上限：请查看滑块“最强”。</translation>
    </message>
    <message>
        <source>%1 has unsaved edits.</source>
        <comment>a pattern</comment>
        <translation>%1 有未保存的编辑。</translation>
    </message>
    <message>
        <source>The program ended before %1, edited %2, was saved. The file on disk is unchanged.</source>
        <comment>a pattern, a time</comment>
        <translation>程序结束时未保存于 %2 编辑的 %1。磁盘上的文件保持原样。</translation>
    </message>
    <message>
        <source>%1 holds more than the pattern: %2</source>
        <comment>a file, a list of sentences</comment>
        <translation>%1 的内容超出图案所能容纳：%2</translation>
    </message>
    <message>
        <source>All patterns (*.json *.hjif *.haptic *.haptic.zip *.ahap *.ahap.zip *.tact)</source>
        <translation>所有图案 (*.json *.hjif *.haptic *.haptic.zip *.ahap *.ahap.zip *.tact)</translation>
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
        <translation>布局另存为(&amp;S)…</translation>
    </message>
    <message>
        <source>D&amp;elete</source>
        <translation>删除(&amp;E)</translation>
    </message>
    <message>
        <source>Save layout</source>
        <translation>保存布局</translation>
    </message>
    <message>
        <source>Name (a layout of the same name is replaced):</source>
        <translation>名称（同名的布局将被替换）：</translation>
    </message>
</context>
<context>
    <name>teleta::console::PlotPage</name>
    <message>
        <source>%1 could not be read.</source>
        <comment>a recording</comment>
        <translation>无法读取 %1。</translation>
    </message>
    <message numerus="yes">
        <source>%1 is damaged: %n part(s) could not be read and are gaps.</source>
        <translation>
            <numerusform>%1 已损坏：%n 个部分无法读取，成为空缺。</numerusform>
        </translation>
    </message>
    <message>
        <source>The layout %1 cannot be restored.</source>
        <translation>无法恢复布局 %1。</translation>
    </message>
    <message>
        <source>It was saved by another version of the program.</source>
        <translation>它由另一版本的程序保存。</translation>
    </message>
    <message>
        <source>Save da&amp;ta…</source>
        <translation>保存数据(&amp;T)…</translation>
    </message>
    <message>
        <source>Plot a recording as a whole, without playing it</source>
        <translation>绘制整个记录，而不回放它</translation>
    </message>
    <message>
        <source>Reading: %p %</source>
        <translation>正在读取：%p %</translation>
    </message>
    <message>
        <source>Follow</source>
        <translation>跟随</translation>
    </message>
    <message>
        <source>The newest sample stays at the right end (Space, End)</source>
        <translation>最新的样本保持在右端（空格键、End）</translation>
    </message>
    <message>
        <source>Show everything</source>
        <translation>显示全部</translation>
    </message>
    <message>
        <source>All samples, and axes that follow the values (Home, double click)</source>
        <translation>所有样本，坐标轴跟随数值（Home、双击）</translation>
    </message>
    <message>
        <source>Cursors</source>
        <translation>光标</translation>
    </message>
    <message>
        <source>Two lines to measure between (C); Left and Right move A, with Ctrl B</source>
        <translation>用于测量的两条线（C）；左右键移动 A，加 Ctrl 移动 B</translation>
    </message>
    <message>
        <source>Power density</source>
        <translation>功率密度</translation>
    </message>
    <message>
        <source>Spectra show the density of power instead of the amplitude</source>
        <translation>频谱显示功率密度而不是幅值</translation>
    </message>
    <message>
        <source>Layouts</source>
        <translation>布局</translation>
    </message>
    <message>
        <source>Save what is plotted under a name, and choose it again</source>
        <translation>以一个名称保存所绘制的内容，并可再次选择</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>保存</translation>
    </message>
    <message>
        <source>The picture, or the samples in view as CSV</source>
        <translation>图，或可见样本的 CSV</translation>
    </message>
    <message>
        <source>Undo remove</source>
        <translation>撤销移除</translation>
    </message>
    <message>
        <source>Nothing is plotted yet</source>
        <translation>尚未绘制任何内容</translation>
    </message>
    <message>
        <source>Drag a signal from the list onto this place, or choose it there and press Enter.</source>
        <translation>把信号从列表拖到这里，或在列表中选中它并按 Enter。</translation>
    </message>
    <message>
        <source>Open a demo</source>
        <translation>打开演示</translation>
    </message>
    <message>
        <source>A simulated arm that touches things</source>
        <translation>触碰物体的仿真机械臂</translation>
    </message>
    <message>
        <source>Add a recording…</source>
        <translation>添加记录…</translation>
    </message>
    <message>
        <source>%1 old samples dropped</source>
        <translation>已丢弃 %1 个旧样本</translation>
    </message>
    <message>
        <source>%1 frames lost</source>
        <translation>丢失 %1 帧</translation>
    </message>
    <message>
        <source>Add a recording</source>
        <translation>添加记录</translation>
    </message>
    <message>
        <source>Recordings (*.teleta)</source>
        <translation>记录 (*.teleta)</translation>
    </message>
    <message>
        <source>Save data</source>
        <translation>保存数据</translation>
    </message>
    <message>
        <source>Comma-separated values (*.csv)</source>
        <translation>逗号分隔值 (*.csv)</translation>
    </message>
    <message>
        <source>plot</source>
        <comment>name of a file</comment>
        <translation>plot</translation>
    </message>
    <message>
        <source>The data were saved.</source>
        <translation>数据已保存。</translation>
    </message>
    <message>
        <source>The data could not be saved.</source>
        <translation>无法保存数据。</translation>
    </message>
    <message>
        <source>Choose another folder or file name.</source>
        <translation>请选择其他文件夹或文件名。</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Stop reading and remove these signals; Ctrl+Z reads them again</source>
        <translation>停止读取并移除这些信号；Ctrl+Z 可重新读取</translation>
    </message>
    <message>
        <source>A&amp;dd a recording…</source>
        <translation>添加记录(&amp;D)…</translation>
    </message>
    <message>
        <source>From each start</source>
        <translation>从各自开始</translation>
    </message>
    <message>
        <source>Clock time</source>
        <translation>时钟时间</translation>
    </message>
    <message>
        <source>Time axis</source>
        <translation>时间轴</translation>
    </message>
    <message>
        <source>Where the time axis begins: with each source, so that a recording lies upon what runs, or by the clock</source>
        <translation>时间轴的起点：随各数据源开始，使记录与运行中的信号重叠；或按时钟</translation>
    </message>
    <message numerus="yes">
        <source>%n signal(s) outside the view: Show everything (Home)</source>
        <translation>
            <numerusform>%n 个信号在视图之外：显示全部 (Home)</numerusform>
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
        <translation>其数据源未打开</translation>
    </message>
    <message>
        <source>is being read</source>
        <translation>正在读取</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <comment>a signal of a joint</comment>
        <translation>%2的 %1</translation>
    </message>
</context>
<context>
    <name>teleta::console::PreferencesDialog</name>
    <message>
        <source>&amp;Keep the screen on while something runs</source>
        <translation>有任务运行时保持屏幕开启(&amp;K)</translation>
    </message>
    <message>
        <source>Add the &amp;Unix time to exported CSV files</source>
        <translation>在导出的 CSV 文件中添加 Unix 时间(&amp;U)</translation>
    </message>
    <message>
        <source>Preferences</source>
        <translation>首选项</translation>
    </message>
    <message>
        <source>While a session runs, something is recorded, or an arm may move</source>
        <translation>当场次正在进行、正在记录或机械臂可能移动时</translation>
    </message>
    <message>
        <source>As the desktop</source>
        <translation>跟随桌面</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>浅色</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>深色</translation>
    </message>
    <message>
        <source>Offer what was open last time</source>
        <translation>提供上次打开的内容以供选择</translation>
    </message>
    <message>
        <source>Open what was open last time</source>
        <translation>打开上次打开的内容</translation>
    </message>
    <message>
        <source>Open nothing</source>
        <translation>不打开任何内容</translation>
    </message>
    <message>
        <source>A last column, utc_s, in seconds since 1970</source>
        <translation>最后一列 utc_s，自 1970 年起的秒数</translation>
    </message>
    <message>
        <source>Folder of recordings</source>
        <translation>记录的文件夹</translation>
    </message>
    <message>
        <source>Lan&amp;guage:</source>
        <translation>语言(&amp;G)：</translation>
    </message>
    <message>
        <source>&amp;Theme:</source>
        <translation>主题(&amp;T)：</translation>
    </message>
    <message>
        <source>At the &amp;start:</source>
        <translation>启动时(&amp;S)：</translation>
    </message>
    <message>
        <source>&amp;Folder of recordings:</source>
        <translation>记录的文件夹(&amp;F)：</translation>
    </message>
    <message>
        <source>C&amp;hoose…</source>
        <translation>选择(&amp;H)…</translation>
    </message>
</context>
<context>
    <name>teleta::console::ProbingStrip</name>
    <message>
        <source>Sto&amp;p probing</source>
        <translation>停止探测(&amp;P)</translation>
    </message>
    <message>
        <source>Progress of the probing</source>
        <translation>探测的进度</translation>
    </message>
    <message>
        <source>SIMULATED: a person probes the tube; pairs so far: %1</source>
        <translation>模拟：由人探测软管；目前点对数：%1</translation>
    </message>
    <message>
        <source>Keep the pairs collected so far</source>
        <translation>保留目前采集的内容</translation>
    </message>
</context>
<context>
    <name>teleta::console::ProtocolDialog</name>
    <message>
        <source>Protocol</source>
        <translation>方案</translation>
    </message>
    <message>
        <source>of the onset of the stimulus</source>
        <translation>自刺激起始计</translation>
    </message>
    <message>
        <source>of its end</source>
        <translation>自刺激结束计</translation>
    </message>
    <message>
        <source> ×</source>
        <comment>after a number</comment>
        <translation> ×</translation>
    </message>
    <message>
        <source>all repetitions together, in random order</source>
        <translation>所有重复混在一起，随机顺序</translation>
    </message>
    <message>
        <source>each repetition in a random order</source>
        <translation>每次重复内随机顺序</translation>
    </message>
    <message>
        <source>pink</source>
        <translation>粉红</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>&amp;Name</source>
        <translation>名称(&amp;N)</translation>
    </message>
    <message>
        <source>D&amp;escription</source>
        <translation>说明(&amp;E)</translation>
    </message>
    <message>
        <source>&amp;Stimulus, at most</source>
        <translation>刺激最长(&amp;S)</translation>
    </message>
    <message>
        <source>Answer &amp;within</source>
        <translation>回答时限(&amp;W)</translation>
    </message>
    <message>
        <source>Or&amp;der</source>
        <translation>顺序(&amp;D)</translation>
    </message>
    <message>
        <source>&amp;Practice</source>
        <translation>练习(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Test</source>
        <translation>测试(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Masking noise</source>
        <translation>掩蔽噪声(&amp;M)</translation>
    </message>
    <message>
        <source>&amp;Add a task</source>
        <translation>添加任务(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>打开(&amp;O)…</translation>
    </message>
    <message>
        <source>The pape&amp;r&apos;s</source>
        <translation>论文的方案(&amp;R)</translation>
    </message>
    <message>
        <source>Sa&amp;ve as…</source>
        <translation>另存为(&amp;V)…</translation>
    </message>
    <message>
        <source>feedback</source>
        <translation>反馈</translation>
    </message>
    <message>
        <source>pictures in view</source>
        <translation>显示图片</translation>
    </message>
    <message>
        <source> × each pattern</source>
        <comment>after a number</comment>
        <translation> × 每个图案</translation>
    </message>
    <message>
        <source>Task</source>
        <translation>任务</translation>
    </message>
    <message>
        <source>for example shape</source>
        <translation>例如：shape</translation>
    </message>
    <message>
        <source>for example static, dynamic</source>
        <translation>例如：static, dynamic</translation>
    </message>
    <message>
        <source>Identifier</source>
        <translation>标识符</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Conditions</source>
        <translation>条件</translation>
    </message>
    <message>
        <source>Patterns</source>
        <translation>图案</translation>
    </message>
    <message>
        <source>Remove this task</source>
        <translation>移除此任务</translation>
    </message>
    <message>
        <source>this form</source>
        <translation>此表单</translation>
    </message>
    <message>
        <source> (expected: %1)</source>
        <translation> （应为：%1）</translation>
    </message>
    <message>
        <source>Save the protocol</source>
        <translation>保存方案</translation>
    </message>
    <message>
        <source>Protocols (*.toml)</source>
        <translation>方案 (*.toml)</translation>
    </message>
    <message>
        <source>✓ Saved: %1</source>
        <translation>✓ 已保存：%1</translation>
    </message>
    <message>
        <source>no rests</source>
        <translation>无休息</translation>
    </message>
    <message>
        <source>after every </source>
        <comment>before a number of trials</comment>
        <translation>每 </translation>
    </message>
    <message>
        <source> trials</source>
        <comment>after a number</comment>
        <translation> 个试次</translation>
    </message>
    <message>
        <source>at least </source>
        <comment>before a number of seconds</comment>
        <translation>至少 </translation>
    </message>
    <message>
        <source>Rests</source>
        <translation>休息</translation>
    </message>
    <message>
        <source>Add a &amp;questionnaire</source>
        <translation>添加问卷(&amp;Q)</translation>
    </message>
    <message>
        <source>Choose a pattern file…</source>
        <translation>选择图案文件…</translation>
    </message>
    <message>
        <source>a letter and a condition of the task, then the file</source>
        <translation>该任务的字母和条件，然后是文件</translation>
    </message>
    <message>
        <source>the file of &quot;%1 %2&quot; cannot be found</source>
        <translation>找不到“%1 %2”的文件</translation>
    </message>
    <message>
        <source>&quot;%1 %2&quot; has two files</source>
        <translation>“%1 %2”有两个文件</translation>
    </message>
    <message>
        <source>one file</source>
        <translation>一个文件</translation>
    </message>
    <message>
        <source>Pattern file for %1</source>
        <comment>a letter and a condition</comment>
        <translation>%1 的图案文件</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>未保存的更改</translation>
    </message>
    <message>
        <source>The protocol has changes that are not saved.</source>
        <translation>方案有未保存的更改。</translation>
    </message>
    <message>
        <source>letter, condition and file, one per line, for your own patterns; all others are built in</source>
        <translation>自有图案的字母、条件和文件，每行一个；其余图案均随程序提供</translation>
    </message>
    <message>
        <source>letter and name, one per line, for example A circle</source>
        <translation>字母和名称，每行一个，例如：A 圆</translation>
    </message>
    <message>
        <source>Your own</source>
        <translation>自有图案</translation>
    </message>
    <message>
        <source>the task has no pattern &quot;%1 %2&quot;</source>
        <translation>该任务中没有“%1 %2”对应的图案</translation>
    </message>
    <message>
        <source>its full path</source>
        <translation>其完整路径</translation>
    </message>
    <message>
        <source>There is no tactile pattern for %1. Name a file for it, or use a task, letter and condition whose pattern is built in. The protocol can be saved as it is.</source>
        <translation>没有可供感受的图案 %1。请为它指定文件，或改用图案随程序提供的任务、字母和条件；方案可以保存。</translation>
    </message>
    <message numerus="yes">
        <source>%n test trial(s) per participant</source>
        <translation>
            <numerusform>每名被试 %n 个测试试次</numerusform>
        </translation>
    </message>
    <message>
        <source>Add a task with &amp;levels</source>
        <translation>添加带刺激水平的任务(&amp;L)</translation>
    </message>
    <message>
        <source>names separated by semicolons, for the description of exported data</source>
        <translation>以 ; 分隔的姓名，用于导出数据的说明</translation>
    </message>
    <message>
        <source>Aut&amp;hors</source>
        <translation>作者(&amp;H)</translation>
    </message>
    <message>
        <source>Record each sess&amp;ion</source>
        <translation>记录每个场次(&amp;I)</translation>
    </message>
    <message>
        <source>May &amp;be felt again</source>
        <translation>可再次感受(&amp;B)</translation>
    </message>
    <message>
        <source>Tri&amp;ggers</source>
        <translation>触发信号(&amp;G)</translation>
    </message>
    <message>
        <source>Ma&amp;ke a study…</source>
        <translation>创建研究(&amp;K)…</translation>
    </message>
</context>
<context>
    <name>teleta::console::ProtocolReading</name>
    <message>
        <source>Protocol</source>
        <translation>方案</translation>
    </message>
    <message>
        <source>Ma&amp;ke a study…</source>
        <translation>创建研究(&amp;K)…</translation>
    </message>
    <message>
        <source>Chan&amp;ge a copy…</source>
        <translation>修改副本(&amp;G)…</translation>
    </message>
</context>
<context>
    <name>teleta::console::QuestionnaireEditor</name>
    <message>
        <source>Questionnaire</source>
        <translation>问卷</translation>
    </message>
    <message>
        <source>for example effort</source>
        <translation>例如 effort</translation>
    </message>
    <message>
        <source>before the first session</source>
        <translation>第一个场次之前</translation>
    </message>
    <message>
        <source>before each session</source>
        <translation>每个场次之前</translation>
    </message>
    <message>
        <source>after each session</source>
        <translation>每个场次之后</translation>
    </message>
    <message>
        <source>after the last session</source>
        <translation>最后一个场次之后</translation>
    </message>
    <message>
        <source>Identifier</source>
        <translation>标识符</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>标题</translation>
    </message>
    <message>
        <source>Filled in</source>
        <translation>填写时间</translation>
    </message>
    <message>
        <source>Add a question</source>
        <translation>添加问题</translation>
    </message>
    <message>
        <source>Remove this questionnaire</source>
        <translation>删除此问卷</translation>
    </message>
    <message>
        <source>for example hard</source>
        <translation>例如 hard</translation>
    </message>
    <message>
        <source>free text</source>
        <translation>自由文本</translation>
    </message>
    <message>
        <source>scale</source>
        <translation>量表</translation>
    </message>
    <message>
        <source>one of several answers</source>
        <translation>多个答案中选一个</translation>
    </message>
    <message>
        <source> points</source>
        <comment>after a number</comment>
        <translation> 级</translation>
    </message>
    <message>
        <source>what the last point means</source>
        <translation>最后一级的含义</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>删除</translation>
    </message>
    <message>
        <source>Remove this question</source>
        <translation>删除此问题</translation>
    </message>
    <message>
        <source>Question</source>
        <translation>问题</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>量表</translation>
    </message>
    <message>
        <source>Answers</source>
        <translation>答案</translation>
    </message>
    <message>
        <source>required</source>
        <translation>必须回答</translation>
    </message>
    <message>
        <source>identifier and text, one per line, for example yes I felt it</source>
        <translation>标识符和文本，每行一个，例如 yes I felt it</translation>
    </message>
    <message>
        <source>all questions have to be answered</source>
        <translation>所有问题都必须回答</translation>
    </message>
    <message>
        <source>of my own</source>
        <translation>自定义</translation>
    </message>
    <message>
        <source>NASA-TLX: six ratings</source>
        <translation>NASA-TLX：六项评分</translation>
    </message>
    <message>
        <source>NASA-TLX: ratings and comparisons</source>
        <translation>NASA-TLX：评分与两两比较</translation>
    </message>
    <message>
        <source>System Usability Scale</source>
        <translation>系统可用性量表</translation>
    </message>
    <message>
        <source>Questions</source>
        <translation>问题</translation>
    </message>
    <message>
        <source>scale from 0 to 100</source>
        <translation>0 至 100 的量表</translation>
    </message>
    <message>
        <source>one of two answers</source>
        <translation>两个答案中选一个</translation>
    </message>
    <message>
        <source>what the first point means</source>
        <translation>第一级的含义</translation>
    </message>
</context>
<context>
    <name>teleta::console::RecordingControls</name>
    <message numerus="yes">
        <source>%n damaged block(s) left out.</source>
        <translation>
            <numerusform>略去 %n 个损坏的数据块。</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 could not be exported.</source>
        <comment>a file</comment>
        <translation>无法导出 %1。</translation>
    </message>
    <message>
        <source>Choose another recording or folder.</source>
        <translation>请选择其他记录或文件夹。</translation>
    </message>
    <message>
        <source>%1 was recorded.</source>
        <comment>a file</comment>
        <translation>已记录 %1。</translation>
    </message>
    <message>
        <source>Nothing is recorded now.</source>
        <translation>当前没有在记录。</translation>
    </message>
    <message>
        <source>Marks are kept in a recording. Ctrl+R begins one.</source>
        <translation>标记保存在记录中。按 Ctrl+R 开始记录。</translation>
    </message>
    <message>
        <source>Folder of the recordings</source>
        <translation>记录的文件夹</translation>
    </message>
    <message>
        <source>End the &amp;recording</source>
        <translation>结束记录(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Record</source>
        <translation>开始记录(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Mark this moment</source>
        <translation>标记此刻(&amp;M)</translation>
    </message>
    <message>
        <source>&amp;Folder of the recordings…</source>
        <translation>记录的文件夹(&amp;F)…</translation>
    </message>
    <message>
        <source>&amp;Export recording as CSV…</source>
        <translation>将记录导出为 CSV(&amp;E)…</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>撤销(&amp;U)</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>重做(&amp;R)</translation>
    </message>
    <message>
        <source>The recording ended: %1.</source>
        <translation>记录已结束：%1。</translation>
    </message>
    <message>
        <source>What was recorded until then can be opened: %1</source>
        <translation>可以打开此前已记录的内容：%1</translation>
    </message>
    <message>
        <source>The recording could not begin.</source>
        <translation>无法开始记录。</translation>
    </message>
    <message>
        <source>Choose another folder in the menu Recording.</source>
        <translation>请在“记录”菜单中选择其他文件夹。</translation>
    </message>
    <message>
        <source>The marks of %1 could not be changed.</source>
        <comment>a file</comment>
        <translation>无法更改 %1 的标记。</translation>
    </message>
    <message>
        <source>The recording was cut off; what had been written is there.</source>
        <translation>记录被截断；已写入的内容仍保留。</translation>
    </message>
    <message>
        <source>Close whatever else uses the file. It is tried again with the next change of a mark, and when the program ends.</source>
        <translation>请关闭其他正在使用该文件的程序。下次更改标记时以及程序结束时会重试。</translation>
    </message>
    <message>
        <source>%1 was written.</source>
        <comment>a file</comment>
        <translation>已写出 %1。</translation>
    </message>
    <message>
        <source>Ex&amp;port recording as MCAP…</source>
        <translation>将记录导出为 MCAP(&amp;P)…</translation>
    </message>
    <message>
        <source>Play it</source>
        <translation>播放</translation>
    </message>
    <message>
        <source>Show in folder</source>
        <translation>打开所在文件夹</translation>
    </message>
    <message numerus="yes">
        <source>%n file(s) were written to %1.</source>
        <translation>
            <numerusform>已将 %n 个文件写入 %1。</numerusform>
        </translation>
    </message>
    <message>
        <source>Play the &amp;last recording</source>
        <translation>播放最近的记录(&amp;L)</translation>
    </message>
</context>
<context>
    <name>teleta::console::RecordingDialog</name>
    <message>
        <source>The &amp;values fall under load</source>
        <translation>数值随载荷增大而下降(&amp;V)</translation>
    </message>
    <message>
        <source>Open recording</source>
        <translation>打开记录</translation>
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
        <translation>与记录时相同</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>…</source>
        <translation>…</translation>
    </message>
    <message>
        <source>Choose the recording of the unloaded array</source>
        <translation>选择空载阵列的记录</translation>
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
        <translation>记录：</translation>
    </message>
    <message>
        <source>&amp;Array:</source>
        <translation>阵列(&amp;A)：</translation>
    </message>
    <message>
        <source>&amp;Pitch:</source>
        <translation>间距(&amp;P)：</translation>
    </message>
    <message>
        <source>&amp;Unloaded (tare):</source>
        <translation>空载（去皮）(&amp;U)：</translation>
    </message>
    <message>
        <source>&amp;Gain:</source>
        <translation>增益(&amp;G)：</translation>
    </message>
    <message>
        <source>Unit of the &amp;load:</source>
        <translation>载荷单位(&amp;L)：</translation>
    </message>
    <message>
        <source>&amp;Threshold:</source>
        <translation>阈值(&amp;T)：</translation>
    </message>
    <message>
        <source>&amp;Rate:</source>
        <translation>频率(&amp;R)：</translation>
    </message>
    <message numerus="yes">
        <source>%n taxel(s), as in the file</source>
        <translation>
            <numerusform>%n 个触觉单元，与文件一致</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 taxels, but the file has %2</source>
        <translation>%1 个触觉单元，但文件中有 %2 个</translation>
    </message>
    <message>
        <source>Recording of the unloaded array</source>
        <translation>空载阵列的记录</translation>
    </message>
    <message>
        <source>Frames (*.csv)</source>
        <translation>帧 (*.csv)</translation>
    </message>
    <message>
        <source>Choose the gains of the taxels</source>
        <translation>选择触觉单元的增益</translation>
    </message>
    <message>
        <source>Gains of the taxels</source>
        <translation>触觉单元的增益</translation>
    </message>
    <message>
        <source>Gains (*.csv)</source>
        <translation>增益 (*.csv)</translation>
    </message>
    <message>
        <source>Gains of the ta&amp;xels:</source>
        <translation>触觉单元的增益(&amp;X)：</translation>
    </message>
    <message>
        <source>&amp;Start again at the end</source>
        <translation>到末尾后重新开始(&amp;S)</translation>
    </message>
</context>
<context>
    <name>teleta::console::RecordingExport</name>
    <message>
        <source>Export recording as CSV</source>
        <translation>将记录导出为 CSV</translation>
    </message>
    <message>
        <source>Recordings (*.teleta)</source>
        <translation>记录 (*.teleta)</translation>
    </message>
    <message>
        <source>Folder for the CSV files</source>
        <translation>CSV 文件的文件夹</translation>
    </message>
    <message>
        <source>Exporting %1…</source>
        <comment>a file</comment>
        <translation>正在导出 %1…</translation>
    </message>
    <message>
        <source>another export is running</source>
        <translation>另一个导出正在进行</translation>
    </message>
    <message>
        <source>Export recording as MCAP</source>
        <translation>将记录导出为 MCAP</translation>
    </message>
    <message>
        <source>MCAP file</source>
        <translation>MCAP 文件</translation>
    </message>
    <message>
        <source>MCAP files (*.mcap)</source>
        <translation>MCAP 文件 (*.mcap)</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>导出…</translation>
    </message>
    <message>
        <source>Export here</source>
        <translation>导出到此处</translation>
    </message>
</context>
<context>
    <name>teleta::console::RecordingFiles</name>
    <message>
        <source>%1 is there already.</source>
        <comment>a file</comment>
        <translation>%1 已存在。</translation>
    </message>
    <message>
        <source>It may have been made from %1 before. Importing the file again makes %2.</source>
        <comment>two files</comment>
        <translation>它可能是先前由 %1 创建的。再次导入该文件将创建 %2。</translation>
    </message>
    <message>
        <source>&amp;Open the recording</source>
        <translation>打开记录(&amp;O)</translation>
    </message>
    <message>
        <source>&amp;Import again</source>
        <translation>再次导入(&amp;I)</translation>
    </message>
    <message>
        <source>Open file</source>
        <translation>打开文件</translation>
    </message>
    <message>
        <source>Import with other &amp;choices…</source>
        <translation>用其他设置导入(&amp;C)…</translation>
    </message>
</context>
<context>
    <name>teleta::console::RecordingImport</name>
    <message>
        <source>a recording of this name is being made</source>
        <translation>正在创建同名的记录</translation>
    </message>
    <message>
        <source>Importing %1…</source>
        <comment>a file</comment>
        <translation>正在导入 %1…</translation>
    </message>
    <message>
        <source>the folder cannot be made</source>
        <translation>无法创建文件夹</translation>
    </message>
    <message>
        <source>Topics that cannot be read were left out: %1.</source>
        <translation>已略去无法读取的话题：%1。</translation>
    </message>
    <message>
        <source>The file was cut off; what could be read is there.</source>
        <translation>文件被截断；可读取的内容已保留。</translation>
    </message>
    <message numerus="yes">
        <source>%n damaged chunk(s) left out.</source>
        <translation>
            <numerusform>略去 %n 个损坏的数据块。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n damaged message(s) left out.</source>
        <translation>
            <numerusform>略去 %n 条损坏的消息。</numerusform>
        </translation>
    </message>
    <message>
        <source>The checksum of the file is wrong: it was damaged somewhere.</source>
        <translation>文件的校验和错误：文件某处已损坏。</translation>
    </message>
    <message>
        <source>the loads are in %1, a unit without a usual threshold</source>
        <translation>负载的单位是 %1，它没有通用的阈值</translation>
    </message>
    <message>
        <source>in “In contact from”, from how many %1 a taxel is in contact</source>
        <translation>在“接触起始值”中写明从多少 %1 起触觉单元算作接触</translation>
    </message>
</context>
<context>
    <name>teleta::console::RecordingMarks</name>
    <message>
        <source>mark</source>
        <translation>标记</translation>
    </message>
    <message>
        <source>removal of a mark</source>
        <translation>删除标记</translation>
    </message>
    <message>
        <source>text of a mark</source>
        <translation>标记的文字</translation>
    </message>
</context>
<context>
    <name>teleta::console::RecordingService</name>
    <message>
        <source>the folder cannot be made</source>
        <translation>无法创建文件夹</translation>
    </message>
    <message>
        <source>a folder that can be written to</source>
        <translation>可写入的文件夹</translation>
    </message>
</context>
<context>
    <name>teleta::console::ScreenKeeper</name>
    <message>
        <source>the service has ended</source>
        <translation>服务已终止</translation>
    </message>
    <message>
        <source>there is no session bus</source>
        <translation>没有会话总线</translation>
    </message>
    <message>
        <source>the answer is not understood</source>
        <translation>无法理解应答</translation>
    </message>
</context>
<context>
    <name>teleta::console::ServerFields</name>
    <message>
        <source>otherwise PGPASSWORD or ~/.pgpass</source>
        <translation>留空则用 PGPASSWORD 或 ~/.pgpass</translation>
    </message>
    <message>
        <source>&amp;Server</source>
        <translation>服务器(&amp;S)</translation>
    </message>
    <message>
        <source>Pass&amp;word</source>
        <translation>密码(&amp;W)</translation>
    </message>
    <message>
        <source>The address of a server looks like %1.</source>
        <translation>服务器地址形如 %1。</translation>
    </message>
    <message>
        <source>Used for this connection only, never saved</source>
        <translation>仅用于此次连接，不在任何地方保存</translation>
    </message>
</context>
<context>
    <name>teleta::console::ServerStudyDialog</name>
    <message>
        <source>Open a study on a server</source>
        <translation>打开服务器上的研究</translation>
    </message>
    <message>
        <source>&amp;Folder on this computer</source>
        <translation>此计算机上的文件夹(&amp;F)</translation>
    </message>
    <message>
        <source>Open the study</source>
        <translation>打开研究</translation>
    </message>
    <message>
        <source>For exports, and for trials while the server is unreachable</source>
        <translation>导出文件存于此处；服务器断开期间，试次也存于此处</translation>
    </message>
    <message>
        <source>Choose a folder by its full path.</source>
        <translation>请选择文件夹，使用完整路径。</translation>
    </message>
</context>
<context>
    <name>teleta::console::SignalSources</name>
    <message>
        <source>whole recording</source>
        <translation>整个记录</translation>
    </message>
</context>
<context>
    <name>teleta::console::SiteViews</name>
    <message>
        <source>Ask for new keys in time.</source>
        <translation>请及时申请新密钥。</translation>
    </message>
    <message>
        <source>%1 was started anew.</source>
        <translation>%1 已重新启动。</translation>
    </message>
    <message>
        <source>Request control again.</source>
        <translation>请重新请求控制权。</translation>
    </message>
    <message>
        <source>Control was handed to you by %1.</source>
        <translation>%1 已将控制权移交给您。</translation>
    </message>
    <message>
        <source>Let go of the switch and press it again.</source>
        <translation>松开开关，再重新按下。</translation>
    </message>
    <message>
        <source>You no longer control %1.</source>
        <translation>您不再控制 %1。</translation>
    </message>
    <message>
        <source>%1 controls %2 now.</source>
        <translation>现在由 %1 控制 %2。</translation>
    </message>
    <message>
        <source>STOP is held by %1.</source>
        <translation>STOP 由 %1 保持。</translation>
    </message>
    <message>
        <source>It can be withdrawn there, or by a supervisor.</source>
        <translation>可在那里或由监督者解除。</translation>
    </message>
    <message>
        <source>%1 does not answer; its arms are held.</source>
        <translation>%1 没有应答；其机械臂保持不动。</translation>
    </message>
    <message>
        <source>The site holds its arms by itself when no command comes.</source>
        <translation>没有指令到来时，站点会自行保持机械臂不动。</translation>
    </message>
    <message>
        <source>Refused: another console is in control, or the cause is still there.</source>
        <translation>被拒绝：另一控制台正在控制，或原因仍然存在。</translation>
    </message>
    <message>
        <source>Refused: this console may not do that.</source>
        <translation>被拒绝：此控制台无权这样做。</translation>
    </message>
    <message>
        <source>Refused: there is no such console.</source>
        <translation>被拒绝：没有这个控制台。</translation>
    </message>
    <message>
        <source>Refused: this console is not in control.</source>
        <translation>被拒绝：此控制台没有控制权。</translation>
    </message>
    <message>
        <source>Refused: STOP is engaged.</source>
        <translation>被拒绝：STOP 已启动。</translation>
    </message>
    <message>
        <source>not in control</source>
        <translation>没有控制权</translation>
    </message>
    <message>
        <source>control has changed since</source>
        <translation>控制权此后已变更</translation>
    </message>
    <message>
        <source>STOP is engaged</source>
        <translation>STOP 已启动</translation>
    </message>
    <message>
        <source>the switch must be let go and pressed again</source>
        <translation>必须松开开关再重新按下</translation>
    </message>
    <message>
        <source>it was overtaken</source>
        <translation>已被后来的指令超过</translation>
    </message>
    <message>
        <source>the loop takes too long</source>
        <translation>回路时间过长</translation>
    </message>
    <message>
        <source>the arm is not known</source>
        <translation>未知的机械臂</translation>
    </message>
    <message>
        <source>it was no number</source>
        <translation>不是数值</translation>
    </message>
    <message>
        <source>the arm is not live</source>
        <translation>机械臂未处于活动状态</translation>
    </message>
    <message>
        <source>another program has this console&apos;s name</source>
        <translation>另一程序使用了此控制台的名称</translation>
    </message>
    <message>
        <source>the loop takes %1 s, the limit is %2 s</source>
        <translation>回路耗时 %1 s，上限为 %2 s</translation>
    </message>
    <message>
        <source>the loop takes longer than %1 s</source>
        <translation>回路耗时超过 %1 s</translation>
    </message>
    <message>
        <source>Refused: another program named %1 is connected.</source>
        <translation>被拒绝：另一个名为 %1 的程序已连接。</translation>
    </message>
    <message>
        <source>It was declined.</source>
        <translation>已被拒绝。</translation>
    </message>
    <message>
        <source>It was declined: %1</source>
        <translation>已被拒绝：%1</translation>
    </message>
    <message>
        <source>Nobody answered in time.</source>
        <translation>无人及时应答。</translation>
    </message>
</context>
<context>
    <name>teleta::console::SourceWatch</name>
    <message>
        <source>%1 was lost.</source>
        <comment>a source</comment>
        <translation>%1 已断开。</translation>
    </message>
    <message>
        <source>The file cannot be read further: it is damaged, or its disk is gone. Open it again when it can be read.</source>
        <translation>文件无法继续读取：文件已损坏，或其磁盘已不存在。可以读取时请重新打开。</translation>
    </message>
    <message>
        <source>Check the cable and the power supply; it is tried again by itself.</source>
        <translation>请检查电缆和电源；会自动重试。</translation>
    </message>
    <message>
        <source>The settings of %1 changed while it was recorded.</source>
        <comment>a source</comment>
        <translation>%1 的设置在记录期间发生了更改。</translation>
    </message>
    <message>
        <source>It is played with those of the beginning; the events of the recording have the others.</source>
        <translation>回放使用开始时的设置；其余的在记录的事件中。</translation>
    </message>
    <message>
        <source>The recording of %1 is damaged.</source>
        <comment>a source</comment>
        <translation>%1 的记录已损坏。</translation>
    </message>
    <message>
        <source>The blocks that cannot be read are passed over; the others are played.</source>
        <translation>无法读取的数据块会被跳过，其余的会被播放。</translation>
    </message>
    <message>
        <source>%1 has become warmer since its tare.</source>
        <comment>a source</comment>
        <translation>%1 自去皮后变热了。</translation>
    </message>
    <message>
        <source>%1 has become colder since its tare.</source>
        <comment>a source</comment>
        <translation>%1 自去皮后变冷了。</translation>
    </message>
    <message>
        <source>What it reads at rest moved with temperature while it was recorded.</source>
        <translation>记录期间，其静止读数随温度发生了变化。</translation>
    </message>
    <message>
        <source>What it reads at rest moves with temperature. Tare it again with nothing touching.</source>
        <translation>其静止读数随温度变化。请在没有接触时重新去皮。</translation>
    </message>
    <message>
        <source>Chip %1: %2</source>
        <translation>芯片 %1：%2</translation>
    </message>
</context>
<context>
    <name>teleta::console::StartPage</name>
    <message>
        <source>No source</source>
        <translation>无数据源</translation>
    </message>
    <message>
        <source>Open a demo scene to look around, a recording, or a list of sources.</source>
        <translation>打开演示场景浏览一番，或打开记录或数据源列表。</translation>
    </message>
    <message>
        <source>First &amp;steps</source>
        <translation>入门(&amp;S)</translation>
    </message>
    <message>
        <source>The page of the handbook to begin with (F1)</source>
        <translation>手册中首先阅读的页面（F1）</translation>
    </message>
    <message>
        <source>Open &amp;demo scene</source>
        <translation>打开演示场景(&amp;D)</translation>
    </message>
    <message>
        <source>A simulated arm that touches five materials</source>
        <translation>触碰五种材料的模拟机械臂</translation>
    </message>
    <message>
        <source>A recording of this program or as MCAP, or recorded frames of an array: CSV, NumPy, HDF5, MATLAB, Tekscan</source>
        <translation>本程序的记录或 MCAP，或阵列的帧记录：CSV、NumPy、HDF5、MATLAB、Tekscan</translation>
    </message>
    <message>
        <source>Open source &amp;list…</source>
        <translation>打开数据源列表(&amp;L)…</translation>
    </message>
    <message>
        <source>A TOML file that lists scenes and recordings</source>
        <translation>列出场景和记录的 TOML 文件</translation>
    </message>
    <message>
        <source>&amp;Open recording…</source>
        <translation>打开记录(&amp;O)…</translation>
    </message>
</context>
<context>
    <name>teleta::console::StudyBracelet</name>
    <message>
        <source>Tactor %1: %2 → %3</source>
        <comment>a number; full drives</comment>
        <translation>振子 %1：%2 → %3</translation>
    </message>
    <message>
        <source>Balance the bracelet</source>
        <translation>平衡手环</translation>
    </message>
    <message>
        <source>Use these full drives for the bracelet %1?</source>
        <translation>将这些满驱动用于手环 %1 吗？</translation>
    </message>
    <message>
        <source>As felt by: %1</source>
        <comment>a participant, or all</comment>
        <translation>感受者：%1</translation>
    </message>
    <message>
        <source>Patterns, feedback and later studies will use them. The page Calibrate can change them again.</source>
        <translation>模式、反馈和以后的实验都将以其播放。可在“标定”页再次更改。</translation>
    </message>
    <message>
        <source>&amp;Use them</source>
        <translation>使用(&amp;U)</translation>
    </message>
    <message>
        <source>Another bracelet was connected meanwhile.</source>
        <translation>期间连接了另一个手环。</translation>
    </message>
    <message>
        <source>Nothing was changed. Connect the one with which the study was run.</source>
        <translation>未作任何更改。请连接实验所用的手环。</translation>
    </message>
    <message>
        <source>The tactors are balanced.</source>
        <translation>振子已平衡。</translation>
    </message>
    <message>
        <source>Saved: %1</source>
        <translation>已保存：%1</translation>
    </message>
    <message>
        <source>The full drives could not be saved.</source>
        <translation>无法保存满驱动。</translation>
    </message>
    <message>
        <source>They are used until the program ends. Save them on the page Calibrate.</source>
        <translation>在程序结束前有效。请在“标定”页保存。</translation>
    </message>
</context>
<context>
    <name>teleta::console::StudyController</name>
    <message>
        <source>the open study is being read or written</source>
        <translation>打开的研究正在读取或写入</translation>
    </message>
    <message>
        <source>to leave the session first</source>
        <translation>先离开该场次</translation>
    </message>
    <message>
        <source>to try again in a moment</source>
        <translation>稍后重试</translation>
    </message>
    <message>
        <source>%1 could not be opened.</source>
        <comment>a folder</comment>
        <translation>无法打开 %1。</translation>
    </message>
    <message>
        <source>The rehearsal could not be opened.</source>
        <translation>无法打开预演。</translation>
    </message>
    <message>
        <source>%1 could not be enrolled.</source>
        <comment>a participant</comment>
        <translation>无法登记 %1。</translation>
    </message>
    <message>
        <source>The study could not be read.</source>
        <translation>无法读取研究。</translation>
    </message>
    <message>
        <source>The trials are safe in the study, but could not be exported.</source>
        <translation>试次已安全存于研究中，但无法导出。</translation>
    </message>
    <message>
        <source>The session could not be closed.</source>
        <translation>无法结束场次。</translation>
    </message>
    <message>
        <source>The note is safe in the study, but could not be exported.</source>
        <translation>备注已安全存于研究中，但无法导出。</translation>
    </message>
    <message>
        <source>The export failed.</source>
        <translation>导出失败。</translation>
    </message>
    <message>
        <source>a session of the open study is running</source>
        <translation>打开的研究正在进行一个场次</translation>
    </message>
    <message>
        <source>The study could not be created.</source>
        <translation>无法创建研究。</translation>
    </message>
    <message>
        <source>The session could not start.</source>
        <translation>无法开始场次。</translation>
    </message>
    <message>
        <source>Saved and verified: %1</source>
        <translation>已保存、读回并比对：%1</translation>
    </message>
    <message>
        <source>The note could not be saved.</source>
        <translation>无法保存备注。</translation>
    </message>
    <message>
        <source>%1 could not be deleted.</source>
        <comment>a participant</comment>
        <translation>无法删除 %1。</translation>
    </message>
</context>
<context>
    <name>teleta::console::StudyLeaving</name>
    <message>
        <source>Study</source>
        <translation>研究</translation>
    </message>
    <message>
        <source>&amp;Try again</source>
        <translation>重试(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;End the session</source>
        <translation>结束场次(&amp;E)</translation>
    </message>
    <message>
        <source>The last answer is not saved: %1</source>
        <translation>最后的回答未保存：%1</translation>
    </message>
    <message>
        <source>It exists only in the memory of this program and is lost when the session ends.</source>
        <translation>它只在本程序的内存中，场次结束时将随之丢失。</translation>
    </message>
    <message>
        <source>&amp;Discard it</source>
        <translation>丢弃(&amp;L)</translation>
    </message>
    <message>
        <source>The session of %1 is still running.</source>
        <comment>a participant</comment>
        <translation>%1 的场次正在进行。</translation>
    </message>
    <message>
        <source>All answers are saved, and the session can be resumed later.</source>
        <translation>已回答的内容已保存，场次可以稍后继续。</translation>
    </message>
</context>
<context>
    <name>teleta::console::StudyPage</name>
    <message>
        <source>The noise cannot be played.</source>
        <translation>无法播放噪声。</translation>
    </message>
    <message>
        <source>Play it from another device, and confirm its level.</source>
        <translation>请用其他设备播放，并确认其声级。</translation>
    </message>
    <message>
        <source>The figure could not be saved.</source>
        <translation>无法保存图。</translation>
    </message>
    <message>
        <source>A session of this study was interrupted.</source>
        <translation>此研究的一个场次曾中断。</translation>
    </message>
    <message>
        <source>%1 could not be opened.</source>
        <comment>a file</comment>
        <translation>无法打开 %1。</translation>
    </message>
    <message>
        <source>The paper&apos;s protocol could not be read.</source>
        <translation>无法读取论文的方案。</translation>
    </message>
    <message>
        <source>Open a protocol</source>
        <translation>打开方案</translation>
    </message>
    <message>
        <source>Protocols (*.toml)</source>
        <translation>方案 (*.toml)</translation>
    </message>
    <message>
        <source>Open a study</source>
        <translation>打开研究</translation>
    </message>
    <message>
        <source>✗ Not played: %1. Play it from another device.</source>
        <translation>✗ 未播放：%1。请用其他设备播放。</translation>
    </message>
    <message>
        <source>Computing …</source>
        <translation>正在计算…</translation>
    </message>
    <message>
        <source>There are no completed trials yet.</source>
        <translation>尚无已完成的试次。</translation>
    </message>
    <message>
        <source>The results could not be computed.</source>
        <translation>无法计算结果。</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>已写入：%1</translation>
    </message>
    <message>
        <source>Session</source>
        <translation>场次</translation>
    </message>
    <message>
        <source>Results</source>
        <translation>结果</translation>
    </message>
    <message>
        <source>Counts</source>
        <translation>计数</translation>
    </message>
    <message>
        <source>Percent of the row</source>
        <translation>占行的百分比</translation>
    </message>
    <message>
        <source>What the matrix shows</source>
        <translation>矩阵显示的内容</translation>
    </message>
    <message>
        <source>Spee&amp;d</source>
        <translation>速度(&amp;D)</translation>
    </message>
    <message>
        <source>Real time, felt on the bracelet</source>
        <translation>实时，可在手环上感觉到</translation>
    </message>
    <message>
        <source>%1 times real time, not played</source>
        <translation>%1 倍实时速度，不播放</translation>
    </message>
    <message>
        <source>The protocols that come with the program could not be read.</source>
        <translation>无法读取程序自带的方案。</translation>
    </message>
    <message>
        <source>comes with the program</source>
        <comment>a protocol</comment>
        <translation>程序自带</translation>
    </message>
    <message>
        <source>The participant&apos;s screen was disconnected.</source>
        <translation>被试的屏幕已断开。</translation>
    </message>
    <message>
        <source>The participant&apos;s window is now next to the console, and the session pauses. Reconnect the screen and show the window again.</source>
        <translation>被试窗口现位于控制台旁，场次已暂停。请插好屏幕并重新显示窗口。</translation>
    </message>
    <message>
        <source>The participant&apos;s window covers part of the console.</source>
        <translation>被试窗口遮住了控制台的一部分。</translation>
    </message>
    <message>
        <source>There is no second screen, and no room next to the console. Connect a second screen, or make the console smaller, and show the window again.</source>
        <translation>没有其他屏幕，控制台旁也没有位置。请连接第二个屏幕，或缩小控制台，然后重新显示窗口。</translation>
    </message>
    <message>
        <source>This study is read-only: nothing can be written here.</source>
        <translation>此研究只能查看：此处不能写入任何内容。</translation>
    </message>
    <message>
        <source>Copy its whole folder to continue the study.</source>
        <translation>要继续，请复制其整个文件夹。</translation>
    </message>
    <message>
        <source>No answer is lost. Resume it, or choose another one.</source>
        <translation>已有的回答均未丢失。请继续该场次，或选择其他场次。</translation>
    </message>
    <message>
        <source>Completed test trials only.</source>
        <translation>已完成的测试试次；其他不计入。</translation>
    </message>
    <message>
        <source>Speed of the simulated participants; can be changed between sessions</source>
        <translation>模拟被试的速度；可在场次之间更改</translation>
    </message>
    <message>
        <source>Plan</source>
        <translation>规划</translation>
    </message>
    <message>
        <source>%1 was deleted.</source>
        <comment>a participant</comment>
        <translation>已删除 %1。</translation>
    </message>
    <message>
        <source>Results that were written before still count the participant: write them again.</source>
        <translation>以前写出的结果仍包含该被试：请重新写出。</translation>
    </message>
    <message>
        <source>Show it</source>
        <translation>显示</translation>
    </message>
</context>
<context>
    <name>teleta::console::StudyPlanning</name>
    <message>
        <source>What is assumed</source>
        <translation>假定的内容</translation>
    </message>
    <message>
        <source>Truth (*.toml)</source>
        <translation>真值 (*.toml)</translation>
    </message>
    <message>
        <source>There is no number of participants to try: &quot;from&quot; is above &quot;to&quot;.</source>
        <translation>没有可尝试的被试人数：“从”大于“到”。</translation>
    </message>
    <message>
        <source>this study</source>
        <translation>本研究</translation>
    </message>
</context>
<context>
    <name>teleta::console::StudyRunner</name>
    <message>
        <source>STOP was pressed</source>
        <translation>按下了 STOP</translation>
    </message>
    <message>
        <source>there is no tactile pattern &quot;%1&quot;</source>
        <translation>没有可供感觉的图案“%1”</translation>
    </message>
    <message>
        <source>a protocol that names a file for each pattern that is not built in</source>
        <translation>为每个未随程序提供的图案指定了文件的方案</translation>
    </message>
</context>
<context>
    <name>teleta::console::SweepPanel</name>
    <message>
        <source>Open the results of a sweep</source>
        <translation>打开扫描的结果</translation>
    </message>
    <message>
        <source>Open a sweep</source>
        <translation>打开扫描</translation>
    </message>
    <message>
        <source>Sweeps (*.toml)</source>
        <translation>扫描 (*.toml)</translation>
    </message>
    <message>
        <source>Empty folder for the results, or one of this sweep to go on with</source>
        <translation>存放结果的空文件夹，或要继续的此扫描的文件夹</translation>
    </message>
    <message>
        <source>%1 cells, each with %2 seeds: %3 runs.</source>
        <translation>%1 个单元，每个 %2 个种子：%3 次运行。</translation>
    </message>
    <message>
        <source>%1 done, %2 failed, in %3.</source>
        <translation>已完成 %1，失败 %2，位于 %3。</translation>
    </message>
    <message>
        <source>%1 over the cells of the sweep</source>
        <translation>扫描各单元上的 %1</translation>
    </message>
    <message>
        <source>Runs</source>
        <translation>运行</translation>
    </message>
    <message>
        <source>Failed</source>
        <translation>失败</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>平均值</translation>
    </message>
    <message>
        <source>Spread</source>
        <translation>离散</translation>
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
        <translation>正在进行的运行即将结束…</translation>
    </message>
    <message>
        <source>Checking every cell…</source>
        <translation>正在检查每个单元…</translation>
    </message>
    <message>
        <source>No sweep is open</source>
        <translation>没有打开扫描</translation>
    </message>
    <message>
        <source>Choose one on the left, or open a file.</source>
        <translation>在左侧选择一个，或打开文件。</translation>
    </message>
    <message>
        <source>No results yet</source>
        <translation>还没有结果</translation>
    </message>
    <message>
        <source>A sweep runs a scene over a grid of settings and seeds, and keeps every run.</source>
        <translation>扫描在设置和种子的网格上运行场景，并保留每次运行。</translation>
    </message>
    <message>
        <source>%1 of %2 runs, %3 failed, %4 left</source>
        <translation>%2 次中已运行 %1 次，失败 %3，剩余 %4</translation>
    </message>
    <message>
        <source>Sweeps</source>
        <translation>扫描</translation>
    </message>
    <message>
        <source>Sweeps that come with the program</source>
        <translation>随程序提供的扫描</translation>
    </message>
    <message>
        <source>&amp;Open a sweep…</source>
        <translation>打开扫描(&amp;O)…</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>取消(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Measure</source>
        <translation>测量值(&amp;M)</translation>
    </message>
    <message>
        <source>Chart of a measure over the cells</source>
        <translation>各单元上测量值的图</translation>
    </message>
    <message>
        <source>Cells with their settings and the measure</source>
        <translation>单元及其设置和测量值</translation>
    </message>
    <message>
        <source>Open resu&amp;lts…</source>
        <translation>打开结果(&amp;L)…</translation>
    </message>
    <message>
        <source>Scene</source>
        <translation>场景</translation>
    </message>
    <message>
        <source>Protocol</source>
        <translation>方案</translation>
    </message>
    <message>
        <source>Ladder</source>
        <translation>阶梯</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>测量</translation>
    </message>
    <message>
        <source>all numbers of a run</source>
        <translation>一次运行的所有数值</translation>
    </message>
    <message>
        <source>%1 runs, one for each seed.</source>
        <translation>%1 次运行，每个种子一次。</translation>
    </message>
    <message>
        <source>&amp;Start in…</source>
        <translation>选择文件夹并开始(&amp;S)…</translation>
    </message>
    <message>
        <source>Start the sweep</source>
        <translation>开始扫描</translation>
    </message>
    <message>
        <source>Results are kept in a new folder in your documents</source>
        <translation>结果保存在您的文档中的新文件夹里</translation>
    </message>
    <message>
        <source>Every rung with %1 seeds.</source>
        <translation>每一级运行 %1 个种子。</translation>
    </message>
</context>
<context>
    <name>teleta::console::SweepRunning</name>
    <message>
        <source>The sweep cannot be opened.</source>
        <translation>无法打开扫描。</translation>
    </message>
    <message>
        <source>The sweep has failed.</source>
        <translation>扫描失败。</translation>
    </message>
</context>
<context>
    <name>teleta::console::TriggerEditor</name>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>serial port</source>
        <translation>串口</translation>
    </message>
    <message>
        <source>OSC by UDP</source>
        <translation>UDP 上的 OSC</translation>
    </message>
    <message>
        <source>Serial port</source>
        <translation>串口</translation>
    </message>
    <message>
        <source>back to 0 after </source>
        <comment>before a number of milliseconds</comment>
        <translation>归零前 </translation>
    </message>
    <message>
        <source>not back to 0</source>
        <translation>不归零</translation>
    </message>
    <message>
        <source>Name or address of the receiver</source>
        <translation>接收方的名称或地址</translation>
    </message>
    <message>
        <source>port </source>
        <comment>before a number</comment>
        <translation>端口 </translation>
    </message>
</context>
<context>
    <name>teleta::console::TubeFields</name>
    <message>
        <source>&amp;Image:</source>
        <translation>图像(&amp;I)：</translation>
    </message>
    <message>
        <source>Len&amp;gth:</source>
        <translation>长度(&amp;G)：</translation>
    </message>
    <message>
        <source>Width of the image</source>
        <translation>图像宽度</translation>
    </message>
    <message>
        <source>Height of the image</source>
        <translation>图像高度</translation>
    </message>
    <message>
        <source>Radius of the tactile cylinder</source>
        <translation>触觉圆柱的半径</translation>
    </message>
    <message>
        <source>Length of the tactile cylinder</source>
        <translation>触觉圆柱的长度</translation>
    </message>
    <message>
        <source>Length of the surface, from z = 0 of the sensor&apos;s frame</source>
        <translation>表面的长度，自传感器坐标系 z = 0 起</translation>
    </message>
    <message>
        <source>Width of the image that the pixels refer to</source>
        <translation>像素所在图像的宽度</translation>
    </message>
    <message>
        <source>Height of the image that the pixels refer to</source>
        <translation>像素所在图像的高度</translation>
    </message>
    <message>
        <source>Radius of the surface that the points lie on</source>
        <translation>点所在表面的半径</translation>
    </message>
    <message>
        <source>Factor from the holes of a shell to the tactile cylinder</source>
        <translation>由外壳的孔到触觉圆柱的系数</translation>
    </message>
    <message>
        <source>For points that are holes of a shell: x and y times this factor lie on the elastomer (0.97 for the shell in the paper)</source>
        <translation>这些点是外壳的孔：其 x 和 y 乘以该系数即位于弹性体上（论文的外壳：0.97）</translation>
    </message>
    <message>
        <source>Ra&amp;dius:</source>
        <translation>半径(&amp;D)：</translation>
    </message>
    <message>
        <source>H&amp;ole factor:</source>
        <translation>孔系数(&amp;O)：</translation>
    </message>
</context>
<context>
    <name>teleta::console::Unattended</name>
    <message>
        <source>teleta-console: %1: cannot write the picture: %2</source>
        <translation>teleta-console：%1：无法写入图片：%2</translation>
    </message>
</context>
<context>
    <name>teleta::cost::CostChart</name>
    <message>
        <source>median time of one call</source>
        <translation>单次调用的中位时间</translation>
    </message>
    <message>
        <source>mean error</source>
        <translation>平均误差</translation>
    </message>
    <message>
        <source>Mean error over time of the settings of %1</source>
        <translation>%1 各设置的平均误差与用时</translation>
    </message>
    <message>
        <source>%1 (exact)</source>
        <comment>name of a setting</comment>
        <translation>%1（精确）</translation>
    </message>
</context>
<context>
    <name>teleta::pattern::LawList</name>
    <message>
        <source>Laws of the display</source>
        <translation>触觉显示规律</translation>
    </message>
    <message>
        <source>Warnings</source>
        <translation>警告</translation>
    </message>
    <message>
        <source>Laws: no warning</source>
        <translation>规律：无警告</translation>
    </message>
    <message>
        <source>Laws: checking…</source>
        <translation>规律：正在检查…</translation>
    </message>
    <message>
        <source>Laws: %1 to review</source>
        <translation>规律：%1 项待查看</translation>
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
        <translation>%1（副本）</translation>
    </message>
    <message>
        <source>Add breakpoint</source>
        <translation>添加节点</translation>
    </message>
    <message>
        <source>Move object</source>
        <translation>移动对象</translation>
    </message>
    <message>
        <source>Move breakpoints</source>
        <translation>移动节点</translation>
    </message>
    <message>
        <source>Set breakpoint</source>
        <translation>设置节点</translation>
    </message>
    <message>
        <source>Change curve</source>
        <translation>更改曲线</translation>
    </message>
    <message>
        <source>Scale intensity</source>
        <translation>缩放强度</translation>
    </message>
    <message>
        <source>Stretch in time</source>
        <translation>按时间拉伸</translation>
    </message>
    <message>
        <source>Delete object</source>
        <translation>删除对象</translation>
    </message>
    <message>
        <source>Delete breakpoints</source>
        <translation>删除节点</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>剪切</translation>
    </message>
    <message>
        <source>Paste</source>
        <translation>粘贴</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>创建副本</translation>
    </message>
    <message>
        <source>Rotate</source>
        <translation>旋转</translation>
    </message>
    <message>
        <source>Mirror</source>
        <translation>镜像</translation>
    </message>
    <message>
        <source>Swap arms</source>
        <translation>交换手臂</translation>
    </message>
    <message>
        <source>Add object</source>
        <translation>添加对象</translation>
    </message>
    <message>
        <source>Change object</source>
        <translation>更改对象</translation>
    </message>
    <message>
        <source>Bake object</source>
        <translation>将对象转为节点</translation>
    </message>
    <message>
        <source>Follow the law</source>
        <translation>遵循规律</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>重命名</translation>
    </message>
    <message>
        <source>Edit notes</source>
        <translation>编辑备注</translation>
    </message>
    <message>
        <source>Edit tags</source>
        <translation>编辑标签</translation>
    </message>
    <message>
        <source>Change task</source>
        <translation>更改任务</translation>
    </message>
    <message>
        <source>Change condition</source>
        <translation>更改条件</translation>
    </message>
    <message>
        <source>Change duration</source>
        <translation>更改时长</translation>
    </message>
    <message>
        <source>Overdrive</source>
        <translation>过驱动</translation>
    </message>
    <message>
        <source>No motor needs overdrive here: the pattern is unchanged.</source>
        <translation>这里没有电机需要帮助：图案保持不变。</translation>
    </message>
</context>
<context>
    <name>teleta::pattern::PatternEditor</name>
    <message>
        <source>&amp;Recent</source>
        <translation>最近使用(&amp;R)</translation>
    </message>
    <message>
        <source>Compared with %1…</source>
        <translation>正在与 %1 比较…</translation>
    </message>
    <message>
        <source>Compared with %1: largest difference %2 % (motor %3 at %4 s), rms %5 %</source>
        <translation>与 %1 比较：最大差异 %2 %（电机 %3，%4 s 处），rms %5 %</translation>
    </message>
    <message>
        <source>File</source>
        <translation>文件</translation>
    </message>
    <message>
        <source>New, open, recent, save, export</source>
        <translation>新建、打开、最近使用、保存、导出</translation>
    </message>
    <message>
        <source>New</source>
        <translation>新建</translation>
    </message>
    <message>
        <source>An empty pattern</source>
        <translation>空白图案</translation>
    </message>
    <message>
        <source>Open…</source>
        <translation>打开…</translation>
    </message>
    <message>
        <source>Open a pattern file</source>
        <translation>打开图案文件</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>保存</translation>
    </message>
    <message>
        <source>Save as…</source>
        <translation>另存为…</translation>
    </message>
    <message>
        <source>Save the pattern under another name</source>
        <translation>以另一名称保存图案</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>导出…</translation>
    </message>
    <message>
        <source>Write HJIF, .haptic, AHAP, .tact, CSV or WAV</source>
        <translation>写出 HJIF、.haptic、AHAP、.tact、CSV 或 WAV</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>暂停</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>播放</translation>
    </message>
    <message>
        <source>Play from the playhead, or pause (Space)</source>
        <translation>从播放头处播放，或暂停（空格键）</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>Stop playing</source>
        <translation>停止播放</translation>
    </message>
    <message>
        <source>Loop</source>
        <translation>循环</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>撤销</translation>
    </message>
    <message>
        <source>Undo the last edit</source>
        <translation>撤销上一次编辑</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>重做</translation>
    </message>
    <message>
        <source>Redo what was undone</source>
        <translation>重做已撤销的操作</translation>
    </message>
    <message>
        <source>Pen</source>
        <translation>画笔</translation>
    </message>
    <message>
        <source>Every click adds a breakpoint (P)</source>
        <translation>每次单击添加一个节点 (P)</translation>
    </message>
    <message>
        <source>Snap</source>
        <translation>吸附</translation>
    </message>
    <message>
        <source>Step of the grid, and of the arrow keys</source>
        <translation>网格和方向键的步长</translation>
    </message>
    <message>
        <source>Step of the grid</source>
        <translation>网格步长</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>添加</translation>
    </message>
    <message>
        <source>Add an object at the playhead</source>
        <translation>在播放头处添加对象</translation>
    </message>
    <message>
        <source>↺ 60°</source>
        <translation>↺ 60°</translation>
    </message>
    <message>
        <source>Rotate around the ring: every motor does what the next one did</source>
        <translation>沿环旋转：每个电机执行后一个电机的动作</translation>
    </message>
    <message>
        <source>↻ 60°</source>
        <translation>↻ 60°</translation>
    </message>
    <message>
        <source>Rotate around the ring: every motor does what the one before did</source>
        <translation>沿环旋转：每个电机执行前一个电机的动作</translation>
    </message>
    <message>
        <source>Mirror</source>
        <translation>镜像</translation>
    </message>
    <message>
        <source>Other arm</source>
        <translation>另一只手臂</translation>
    </message>
    <message>
        <source>The pattern for the other arm</source>
        <translation>用于另一只手臂的图案</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>适合窗口</translation>
    </message>
    <message>
        <source>Show the whole pattern (Ctrl+0 on the timeline)</source>
        <translation>显示整个图案（时间轴上按 Ctrl+0）</translation>
    </message>
    <message>
        <source>Untitled</source>
        <translation>未命名</translation>
    </message>
    <message>
        <source>not saved</source>
        <translation>未保存</translation>
    </message>
    <message>
        <source>left arm</source>
        <translation>左臂</translation>
    </message>
    <message>
        <source>right arm</source>
        <translation>右臂</translation>
    </message>
    <message>
        <source>Compared with %1: no difference</source>
        <translation>与 %1 比较：电机动作相同</translation>
    </message>
    <message>
        <source>Pattern editor</source>
        <translation>图案编辑器</translation>
    </message>
    <message>
        <source>Save the pattern; a new one is added to your own patterns</source>
        <translation>保存图案；没有文件的图案存入自己的图案中</translation>
    </message>
    <message>
        <source>Repeat from the beginning; Shift and dragging on the ruler set the range</source>
        <translation>到末尾后重新开始；按住 Shift 在标尺上拖动可设置范围</translation>
    </message>
    <message>
        <source>Snap times to a grid; hold Alt while dragging to ignore it</source>
        <translation>时间对齐到网格；拖动时按住 Alt 可不对齐</translation>
    </message>
    <message>
        <source>Reverse the order of the motors</source>
        <translation>将电机的顺序反转</translation>
    </message>
    <message>
        <source>Stop comparing</source>
        <translation>停止比较</translation>
    </message>
    <message>
        <source>built-in, edits create a copy</source>
        <translation>内置，编辑时生成副本</translation>
    </message>
    <message>
        <source>STOP is engaged: release it to play</source>
        <translation>STOP 已按下：释放后才能播放</translation>
    </message>
</context>
<context>
    <name>teleta::pattern::PatternInspector</name>
    <message>
        <source>Numbers from 1 to 6, separated by spaces</source>
        <translation>1 至 6 的数字，以空格分隔</translation>
    </message>
    <message>
        <source>Motors:</source>
        <translation>电机：</translation>
    </message>
    <message>
        <source>Burst:</source>
        <translation>短振：</translation>
    </message>
    <message>
        <source>Onset to onset:</source>
        <translation>起始间隔：</translation>
    </message>
    <message>
        <source>Onset by the law of apparent motion</source>
        <translation>按似动规律设置起始间隔</translation>
    </message>
    <message>
        <source>Turns:</source>
        <translation>圈数：</translation>
    </message>
    <message>
        <source>First motor:</source>
        <translation>第一个电机：</translation>
    </message>
    <message>
        <source>Counter-clockwise (rising numbers)</source>
        <translation>逆时针（编号递增）</translation>
    </message>
    <message>
        <source>Burst by the law of apparent motion</source>
        <translation>按似动规律设置短振</translation>
    </message>
    <message>
        <source>Second motor:</source>
        <translation>第二个电机：</translation>
    </message>
    <message>
        <source>From:</source>
        <translation>从：</translation>
    </message>
    <message>
        <source>To:</source>
        <translation>到：</translation>
    </message>
    <message>
        <source>Period:</source>
        <translation>周期：</translation>
    </message>
    <message>
        <source>Width:</source>
        <translation>宽度：</translation>
    </message>
    <message>
        <source>Length:</source>
        <translation>长度：</translation>
    </message>
    <message>
        <source>Begins at:</source>
        <translation>开始于：</translation>
    </message>
    <message>
        <source>Point:</source>
        <translation>点：</translation>
    </message>
    <message>
        <source>its time:</source>
        <translation>其时间：</translation>
    </message>
    <message>
        <source>its angle:</source>
        <translation>其角度：</translation>
    </message>
    <message>
        <source>along the arm:</source>
        <translation>沿手臂：</translation>
    </message>
    <message>
        <source>Start:</source>
        <translation>起点：</translation>
    </message>
    <message>
        <source>Intensity:</source>
        <translation>强度：</translation>
    </message>
    <message>
        <source>Called:</source>
        <translation>对象名称：</translation>
    </message>
    <message>
        <source>Bake into breakpoints</source>
        <translation>转为节点</translation>
    </message>
    <message>
        <source>&amp;Name:</source>
        <translation>名称(&amp;N)：</translation>
    </message>
    <message>
        <source>Le&amp;ngth:</source>
        <translation>长度(&amp;N)：</translation>
    </message>
    <message>
        <source>&amp;Loop:</source>
        <translation>循环(&amp;L)：</translation>
    </message>
    <message>
        <source>Begin of the loop</source>
        <translation>循环起点</translation>
    </message>
    <message>
        <source>End of the loop</source>
        <translation>循环终点</translation>
    </message>
    <message>
        <source>T&amp;ells:</source>
        <translation>表达(&amp;E)：</translation>
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
        <translation>刚度</translation>
    </message>
    <message>
        <source>something else</source>
        <translation>其他</translation>
    </message>
    <message>
        <source>no condition</source>
        <translation>无条件</translation>
    </message>
    <message>
        <source>static</source>
        <translation>静态</translation>
    </message>
    <message>
        <source>dynamic</source>
        <translation>动态</translation>
    </message>
    <message>
        <source>&amp;Tags:</source>
        <translation>标签(&amp;T)：</translation>
    </message>
    <message>
        <source>N&amp;otes:</source>
        <translation>备注(&amp;O)：</translation>
    </message>
    <message>
        <source>Nothing is selected</source>
        <translation>未选择任何内容</translation>
    </message>
    <message>
        <source>Breakpoint of motor %1</source>
        <translation>电机 %1 的节点</translation>
    </message>
    <message>
        <source>%1 breakpoints</source>
        <translation>%1 个节点</translation>
    </message>
    <message>
        <source>Time:</source>
        <translation>时间：</translation>
    </message>
    <message>
        <source>Scale by:</source>
        <translation>缩放倍数：</translation>
    </message>
    <message>
        <source>Stretch to:</source>
        <translation>拉伸至：</translation>
    </message>
    <message>
        <source>Curve:</source>
        <translation>曲线：</translation>
    </message>
    <message>
        <source>The range that is repeated; the whole pattern when both times are equal</source>
        <translation>反复播放的部分；两者相同时为整个图案</translation>
    </message>
</context>
<context>
    <name>teleta::pattern::PatternLibrary</name>
    <message>
        <source>Filter the patterns</source>
        <translation>筛选图案</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>撤销</translation>
    </message>
    <message>
        <source>Patterns</source>
        <translation>图案</translation>
    </message>
    <message>
        <source>Built-in: shapes</source>
        <translation>内置：形状</translation>
    </message>
    <message>
        <source>Built-in: stiffness</source>
        <translation>内置：刚度</translation>
    </message>
    <message>
        <source>Mine</source>
        <translation>我的图案</translation>
    </message>
    <message>
        <source>none yet: edit a built-in one</source>
        <translation>尚无：编辑内置图案即可创建</translation>
    </message>
    <message>
        <source>damaged</source>
        <translation>已损坏</translation>
    </message>
    <message>
        <source>Tags: %1</source>
        <translation>标签：%1</translation>
    </message>
    <message>
        <source>&amp;Open</source>
        <translation>打开(&amp;O)</translation>
    </message>
    <message>
        <source>&amp;Compare with it</source>
        <translation>与之比较(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Duplicate</source>
        <translation>创建副本(&amp;D)</translation>
    </message>
    <message>
        <source>&amp;Rename</source>
        <translation>重命名(&amp;R)</translation>
    </message>
    <message>
        <source>De&amp;lete</source>
        <translation>删除(&amp;L)</translation>
    </message>
    <message>
        <source>Open in the editor</source>
        <translation>已在编辑器中打开</translation>
    </message>
    <message>
        <source>Undo the last change to the library (Ctrl+Z in the list)</source>
        <translation>撤销对图案库的上一次操作（在列表中按 Ctrl+Z）</translation>
    </message>
    <message>
        <source>&lt;p&gt;A click or &lt;b&gt;Enter&lt;/b&gt; opens a pattern. Built-in patterns cannot be changed: the first edit creates a copy. Your own patterns: &lt;b&gt;F2&lt;/b&gt; renames, &lt;b&gt;Ctrl+D&lt;/b&gt; duplicates, &lt;b&gt;Delete&lt;/b&gt; deletes, &lt;b&gt;Ctrl+Z&lt;/b&gt; undoes that.&lt;/p&gt;</source>
        <translation>&lt;p&gt;单击或按 &lt;b&gt;Enter&lt;/b&gt; 打开图案。内置图案保持不变：首次编辑时生成副本。对自己的图案：&lt;b&gt;F2&lt;/b&gt; 重命名，&lt;b&gt;Ctrl+D&lt;/b&gt; 创建副本，&lt;b&gt;Delete&lt;/b&gt; 删除，&lt;b&gt;Ctrl+Z&lt;/b&gt; 撤回。&lt;/p&gt;</translation>
    </message>
    <message>
        <source>&lt;p&gt;The pattern in bold, with a bar in front of it, is open in the editor; keys act on the highlighted one.&lt;/p&gt;</source>
        <translation>&lt;p&gt;以粗体显示、前面有竖条的图案正在编辑器中打开；按键作用于高亮的图案。&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Filter: name, tag (Ctrl+F)</source>
        <translation>筛选：名称、标签 (Ctrl+F)</translation>
    </message>
</context>
<context>
    <name>teleta::pattern::StrokePad</name>
    <message>
        <source>Unrolled forearm</source>
        <translation>展开的前臂</translation>
    </message>
    <message>
        <source>Draw a stroke: it is felt as a point that moves along it</source>
        <translation>绘制一笔：感觉为沿其移动的点</translation>
    </message>
    <message>
        <source>Draw a stroke here</source>
        <translation>在此绘制笔画</translation>
    </message>
    <message>
        <source>&lt;p&gt;The unrolled forearm: from left to right once around it. Draw with the mouse to add a stroke that starts at the playhead and moves as fast as you draw. &lt;b&gt;Esc&lt;/b&gt; cancels it.&lt;/p&gt;&lt;p&gt;With keys: the arrows move a cursor, &lt;b&gt;Space&lt;/b&gt; adds a point a quarter of a second after the last one, &lt;b&gt;Backspace&lt;/b&gt; removes it, &lt;b&gt;Enter&lt;/b&gt; finishes.&lt;/p&gt;</source>
        <translation>&lt;p&gt;展开的前臂：从左到右绕手臂一周。用鼠标在此绘制的内容将成为图案的一个笔画，从播放头开始，速度与绘制时相同。&lt;b&gt;Esc&lt;/b&gt; 放弃。&lt;/p&gt;&lt;p&gt;键盘操作：方向键移动光标，&lt;b&gt;空格键&lt;/b&gt;在上一点之后四分之一秒处设置一个点，&lt;b&gt;Backspace&lt;/b&gt; 撤回该点，&lt;b&gt;Enter&lt;/b&gt; 完成。&lt;/p&gt;</translation>
    </message>
</context>
<context>
    <name>teleta::pattern::TimelineView</name>
    <message>
        <source>Time in s; intensity in %</source>
        <translation>时间，s；强度，%</translation>
    </message>
    <message>
        <source>Timeline of the pattern</source>
        <translation>图案的时间轴</translation>
    </message>
    <message>
        <source>Visible time</source>
        <translation>可见时间</translation>
    </message>
    <message>
        <source>pattern</source>
        <translation>图案</translation>
    </message>
    <message>
        <source>&amp;Type numbers…</source>
        <translation>输入数值(&amp;T)…</translation>
    </message>
    <message>
        <source>Add &amp;breakpoint here</source>
        <translation>在此添加节点(&amp;B)</translation>
    </message>
    <message>
        <source>&amp;Zoom to fit</source>
        <translation>缩放至适合(&amp;Z)</translation>
    </message>
    <message>
        <source>Clear &amp;loop</source>
        <translation>清除循环(&amp;L)</translation>
    </message>
    <message>
        <source>&lt;p&gt;Six motors over time. The blue line is the commanded intensity of a motor, the thin one its predicted response; hatching shows where the motor cannot follow.&lt;/p&gt;&lt;p&gt;Double-click or &lt;b&gt;P&lt;/b&gt;: add breakpoints. Drag: move, with &lt;b&gt;Alt&lt;/b&gt; without the grid. Drag on the background, or with &lt;b&gt;Shift&lt;/b&gt;: select. Double-click on a breakpoint or &lt;b&gt;Enter&lt;/b&gt;: type its numbers. Arrow keys: move what is selected, with &lt;b&gt;Shift&lt;/b&gt; farther in time and finer in intensity. &lt;b&gt;Page Up&lt;/b&gt;, &lt;b&gt;Page Down&lt;/b&gt;: lane; &lt;b&gt;,&lt;/b&gt; and &lt;b&gt;.&lt;/b&gt;: breakpoint, with &lt;b&gt;Shift&lt;/b&gt; one more; &lt;b&gt;N&lt;/b&gt;: object; &lt;b&gt;Insert&lt;/b&gt;: a breakpoint at the playhead; &lt;b&gt;[&lt;/b&gt; and &lt;b&gt;]&lt;/b&gt;: begin and end of the loop, &lt;b&gt;\&lt;/b&gt;: none.&lt;/p&gt;&lt;p&gt;&lt;b&gt;Ctrl&lt;/b&gt; and wheel: zoom. &lt;b&gt;Shift&lt;/b&gt; and wheel: scroll. On the ruler a drag moves the playhead and, with &lt;b&gt;Shift&lt;/b&gt;, sets the loop.&lt;/p&gt;</source>
        <translation>&lt;p&gt;六个电机随时间的变化。蓝线为对电机的指令，细线为电机的预测动作；电机无法跟随处以斜线填充。&lt;/p&gt;&lt;p&gt;双击或 &lt;b&gt;P&lt;/b&gt;：添加节点。拖动：移动，按住 &lt;b&gt;Alt&lt;/b&gt; 不对齐网格。在空白处拖动，或按住 &lt;b&gt;Shift&lt;/b&gt; 拖动：选择。双击节点或按 &lt;b&gt;Enter&lt;/b&gt;：输入其数值。方向键：移动所选内容，按住 &lt;b&gt;Shift&lt;/b&gt; 时时间步长更大、强度步长更小。&lt;b&gt;Page Up&lt;/b&gt;、&lt;b&gt;Page Down&lt;/b&gt;：轨道；&lt;b&gt;,&lt;/b&gt; 和 &lt;b&gt;.&lt;/b&gt;：节点，按住 &lt;b&gt;Shift&lt;/b&gt; 再多选一个；&lt;b&gt;N&lt;/b&gt;：对象；&lt;b&gt;Insert&lt;/b&gt;：在播放头处添加节点；&lt;b&gt;[&lt;/b&gt; 和 &lt;b&gt;]&lt;/b&gt;：循环的起点和终点，&lt;b&gt;\&lt;/b&gt;：取消循环。&lt;/p&gt;&lt;p&gt;&lt;b&gt;Ctrl&lt;/b&gt; 加滚轮：缩放。&lt;b&gt;Shift&lt;/b&gt; 加滚轮：滚动。在标尺上拖动可移动播放头，按住 &lt;b&gt;Shift&lt;/b&gt; 则设置循环。&lt;/p&gt;</translation>
    </message>
</context>
<context>
    <name>teleta::servo::ForceStrip</name>
    <message>
        <source>Force over time</source>
        <translation>力随时间的变化</translation>
    </message>
    <message>
        <source>actual</source>
        <translation>实际</translation>
    </message>
    <message>
        <source>desired</source>
        <translation>期望</translation>
    </message>
    <message>
        <source>Measured force (line) and desired force (dashes) over the last 20 s</source>
        <translation>最近 20 s 内阵列读取的力（实线）和期望的力（虚线）</translation>
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
        <translation>无伺服</translation>
    </message>
    <message>
        <source>No limit acts.</source>
        <translation>没有限制起作用。</translation>
    </message>
    <message>
        <source>Limits that act: %1</source>
        <translation>起作用的限制：%1</translation>
    </message>
    <message>
        <source>%1. %2</source>
        <comment>number and name of a task</comment>
        <translation>%1. %2</translation>
    </message>
    <message>
        <source>&amp;Task</source>
        <translation>任务(&amp;T)</translation>
    </message>
    <message>
        <source>Force with which the array presses</source>
        <translation>阵列按压的力</translation>
    </message>
    <message>
        <source>&amp;Sliding speed</source>
        <translation>滑动速度(&amp;S)</translation>
    </message>
    <message>
        <source>Along the edge, while it is explored</source>
        <translation>探索边缘时沿边缘的速度</translation>
    </message>
    <message>
        <source>&amp;Gains</source>
        <translation>增益(&amp;G)</translation>
    </message>
    <message>
        <source>Balance the &amp;moment (DZMP)</source>
        <translation>平衡力矩 (DZMP)(&amp;M)</translation>
    </message>
    <message>
        <source>Off: the controller without the distance to the zero-moment point</source>
        <translation>关闭：控制器不使用到零力矩点的距离</translation>
    </message>
    <message>
        <source>The scene is held</source>
        <translation>场景处于保持状态</translation>
    </message>
    <message>
        <source>The running task; choose one to start it now</source>
        <translation>正在运行的任务；选择一个即可立即开始</translation>
    </message>
    <message>
        <source>All controller gains, in percent of those in the scene</source>
        <translation>调节器的全部增益，以场景设定的百分比表示</translation>
    </message>
    <message>
        <source>So far: %1</source>
        <translation>到目前为止：%1</translation>
    </message>
    <message>
        <source>Last run: %1</source>
        <translation>上一次运行：%1</translation>
    </message>
    <message>
        <source>force %1</source>
        <comment>as planned</comment>
        <translation>力 %1</translation>
    </message>
    <message>
        <source>sliding speed %1</source>
        <comment>as planned</comment>
        <translation>滑动速度 %1</translation>
    </message>
    <message>
        <source>gains %1</source>
        <comment>as planned</comment>
        <translation>增益 %1</translation>
    </message>
    <message>
        <source>moment balanced</source>
        <translation>力矩平衡</translation>
    </message>
    <message>
        <source>moment not balanced</source>
        <translation>力矩不平衡</translation>
    </message>
    <message>
        <source>Changed from the scene, and kept after a restart. The scene has: %1.</source>
        <translation>已更改，重新开始后仍然有效。场景的设置：%1。</translation>
    </message>
    <message>
        <source>Reset to the scene</source>
        <translation>场景的设置</translation>
    </message>
    <message>
        <source>Set force, speed, gains and moment back to the values of the scene</source>
        <translation>撤销对力、速度、增益和力矩的全部更改</translation>
    </message>
    <message>
        <source>Matrices</source>
        <translation>矩阵</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>运行</translation>
    </message>
    <message>
        <source>Let the scene go on (F5)</source>
        <translation>让场景继续（F5）</translation>
    </message>
    <message>
        <source>Hold</source>
        <translation>保持</translation>
    </message>
    <message>
        <source>Hold the scene where it is (Shift+F5)</source>
        <translation>使场景保持在当前状态（Shift+F5）</translation>
    </message>
    <message>
        <source>Restart</source>
        <translation>重新开始</translation>
    </message>
    <message>
        <source>Start the scene again (Ctrl+F5)</source>
        <translation>重新开始场景（Ctrl+F5）</translation>
    </message>
    <message>
        <source>F&amp;orce</source>
        <translation>力(&amp;O)</translation>
    </message>
    <message>
        <source>as planned</source>
        <translation>按计划进行</translation>
    </message>
    <message>
        <source>STOP: the arm is held</source>
        <translation>STOP：机械臂处于保持状态</translation>
    </message>
    <message>
        <source>The arm keeps the pose that it had. It no longer presses beyond it: the force falls to what pushes against the arm.</source>
        <translation>机械臂保持原有位姿，不再继续压入：力降至外界对机械臂的推力。</translation>
    </message>
</context>
<context>
    <name>teleta::servo::ServoPicture</name>
    <message>
        <source>Features and matrices of the servo</source>
        <translation>伺服的特征和矩阵</translation>
    </message>
    <message>
        <source>Desired and actual features as the inverse tactile Jacobian selects them; bold rows act on the motion through the projection matrix P.</source>
        <translation>由逆触觉雅可比矩阵选出的期望特征和实际特征；粗体行通过投影矩阵 P 作用于运动。</translation>
    </message>
    <message>
        <source>Feature</source>
        <translation>特征</translation>
    </message>
    <message>
        <source>Desired</source>
        <translation>期望</translation>
    </message>
    <message>
        <source>Actual</source>
        <translation>实际</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>误差</translation>
    </message>
    <message>
        <source>J⁻¹, features</source>
        <translation>J⁻¹，特征</translation>
    </message>
    <message>
        <source>P, motions</source>
        <translation>P，运动</translation>
    </message>
</context>
<context>
    <name>teleta::servo::ServoRunsView</name>
    <message>
        <source>&amp;Picture</source>
        <translation>图片(&amp;P)</translation>
    </message>
    <message>
        <source>Copies or saves the chart or its data</source>
        <translation>复制或保存图或其数据</translation>
    </message>
    <message>
        <source>Servo runs</source>
        <translation>伺服运行</translation>
    </message>
    <message>
        <source>Servo runs (servo.csv)</source>
        <translation>伺服运行 (servo.csv)</translation>
    </message>
    <message>
        <source>Comma-separated values (*.csv)</source>
        <translation>逗号分隔值 (*.csv)</translation>
    </message>
    <message>
        <source>servo-runs</source>
        <comment>name of a file</comment>
        <translation>伺服运行</translation>
    </message>
    <message>
        <source>Add recorded run</source>
        <translation>添加记录的运行</translation>
    </message>
    <message>
        <source>A run written by teleta simulate --out: its servo.csv</source>
        <translation>teleta simulate --out 写出的运行：其 servo.csv</translation>
    </message>
    <message>
        <source>Keeps only the current run</source>
        <translation>仅保留正在进行的运行</translation>
    </message>
    <message>
        <source>&lt;p&gt;Servo runs in one chart: the current one, earlier ones from before a restart or a change of the source, and recorded ones.&lt;/p&gt;&lt;p&gt;To see the effect of the moment, restart the scene with and without “Balance the moment”.&lt;/p&gt;</source>
        <translation>&lt;p&gt;同一图中的各次伺服运行：正在进行的运行，数据源重新启动或切换之前的运行，以及记录的运行。&lt;/p&gt;&lt;p&gt;要了解力矩的作用，请分别勾选和取消“平衡力矩”后重新启动场景。&lt;/p&gt;</translation>
    </message>
    <message>
        <source>No runs yet. Servo runs are drawn here on top of each other.</source>
        <translation>尚无运行。伺服运行将叠加绘制于此。</translation>
    </message>
    <message>
        <source>A&amp;dd recorded run…</source>
        <translation>添加记录的运行(&amp;D)…</translation>
    </message>
    <message>
        <source>Forget &amp;other runs</source>
        <translation>清除其他运行(&amp;O)</translation>
    </message>
</context>
<context>
    <name>teleta::signal::SignalPlot</name>
    <message>
        <source>units</source>
        <translation>单位</translation>
    </message>
    <message>
        <source>power density ((%1)²/Hz)</source>
        <translation>功率密度 ((%1)²/Hz)</translation>
    </message>
    <message>
        <source>amplitude</source>
        <translation>幅值</translation>
    </message>
    <message>
        <source>amplitude (%1)</source>
        <translation>幅值 (%1)</translation>
    </message>
    <message>
        <source>Signals over time</source>
        <translation>信号随时间的变化</translation>
    </message>
    <message>
        <source>plot</source>
        <comment>name of a file</comment>
        <translation>plot</translation>
    </message>
    <message>
        <source>frequency</source>
        <translation>频率</translation>
    </message>
    <message>
        <source>clock time</source>
        <translation>时钟时间</translation>
    </message>
    <message>
        <source>time since the start of each source</source>
        <translation>自各数据源开始以来的时间</translation>
    </message>
</context>
<context>
    <name>teleta::signal::SignalTable</name>
    <message>
        <source>Plotted signals with their values</source>
        <translation>绘制的信号及其数值</translation>
    </message>
    <message>
        <source>Add its &amp;derivative</source>
        <translation>添加其导数(&amp;D)</translation>
    </message>
    <message>
        <source>Show its &amp;spectrum</source>
        <translation>显示其频谱(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>移除(&amp;R)</translation>
    </message>
    <message>
        <source>Plotted signal</source>
        <translation>绘制的信号</translation>
    </message>
    <message>
        <source>at A</source>
        <translation>A 处</translation>
    </message>
    <message>
        <source>Newest</source>
        <translation>最新</translation>
    </message>
    <message>
        <source>at B</source>
        <translation>B 处</translation>
    </message>
    <message>
        <source>B − A</source>
        <comment>difference of two values</comment>
        <translation>B − A</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>单位</translation>
    </message>
    <message>
        <source>B − A: %1, 1/(B − A): %2</source>
        <translation>B − A：%1，1/(B − A)：%2</translation>
    </message>
</context>
<context>
    <name>teleta::signal::SignalTree</name>
    <message>
        <source>Search signals</source>
        <translation>查找信号</translation>
    </message>
    <message>
        <source>Signals of all sources</source>
        <translation>所有数据源的信号</translation>
    </message>
    <message>
        <source>Signal</source>
        <translation>信号</translation>
    </message>
    <message>
        <source>Newest value</source>
        <translation>最新值</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <comment>signal, unit</comment>
        <translation>%1（%2）</translation>
    </message>
    <message>
        <source>Search signals (Ctrl+F)</source>
        <translation>搜索信号 (Ctrl+F)</translation>
    </message>
</context>
<context>
    <name>teleta::site_view::SiteBar</name>
    <message>
        <source>%1 does not answer (%2 s)</source>
        <translation>%1 没有应答（%2 秒）</translation>
    </message>
    <message>
        <source>%1: STOP is held by %2</source>
        <translation>%1：STOP 由 %2 保持</translation>
    </message>
    <message>
        <source>%1: %2 offers you control</source>
        <translation>%1：%2 要把控制权交给您</translation>
    </message>
    <message>
        <source>%1: handing control to %2</source>
        <translation>%1：正在把控制权交给 %2</translation>
    </message>
    <message>
        <source>%1: an arm has a fault</source>
        <translation>%1：机械臂故障</translation>
    </message>
    <message>
        <source>%1: you are moving it</source>
        <translation>%1：您正在移动它</translation>
    </message>
    <message>
        <source>%1: you control</source>
        <translation>%1：您在控制</translation>
    </message>
    <message>
        <source>%1: %2 controls</source>
        <translation>%1：%2 在控制</translation>
    </message>
    <message>
        <source>%1: viewing</source>
        <translation>%1：查看中</translation>
    </message>
    <message>
        <source>%1: nobody controls</source>
        <translation>%1：无人控制</translation>
    </message>
    <message>
        <source>loop %1 ms</source>
        <translation>回路 %1 ms</translation>
    </message>
    <message>
        <source>clock ±%1 ms</source>
        <translation>时钟 ±%1 ms</translation>
    </message>
    <message>
        <source>%1 refused: %2</source>
        <translation>%1 条被拒绝：%2</translation>
    </message>
    <message numerus="yes">
        <source>%n state(s) of the site were lost on the way</source>
        <translation>
            <numerusform>途中丢失了 %n 个站点状态</numerusform>
        </translation>
    </message>
    <message>
        <source>Control lease: how long control stays here without an answer</source>
        <translation>控制租期：无应答时控制权保留的时间</translation>
    </message>
    <message>
        <source>Request control</source>
        <translation>请求控制权</translation>
    </message>
    <message>
        <source>Accept control</source>
        <translation>接受控制权</translation>
    </message>
    <message>
        <source>Agree</source>
        <translation>同意</translation>
    </message>
    <message>
        <source>Decline</source>
        <translation>拒绝</translation>
    </message>
    <message>
        <source>Keep control</source>
        <translation>保留控制权</translation>
    </message>
    <message>
        <source>Take over…</source>
        <translation>接管…</translation>
    </message>
    <message>
        <source>For supervisors: the other console has 5 s to decline</source>
        <translation>供监督者使用：对方控制台有 5 秒时间拒绝</translation>
    </message>
    <message>
        <source>Clear the fault</source>
        <translation>清除故障</translation>
    </message>
    <message>
        <source>Hand over</source>
        <translation>移交</translation>
    </message>
    <message>
        <source>Withdraw STOP</source>
        <translation>解除 STOP</translation>
    </message>
    <message>
        <source>For supervisors, once the console that engaged STOP is gone</source>
        <translation>供监督者使用：启动 STOP 的控制台已消失时</translation>
    </message>
    <message>
        <source>Release control</source>
        <translation>释放控制权</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <comment>a console and who sits there</comment>
        <translation>%1（%2）</translation>
    </message>
    <message>
        <source>In control: %1</source>
        <translation>控制者：%1</translation>
    </message>
    <message>
        <source>Viewers: %1</source>
        <translation>查看者：%1</translation>
    </message>
    <message>
        <source>Loop: median %1 ms, 99 %: %2 ms</source>
        <translation>回路：中位数 %1 ms，99 %：%2 ms</translation>
    </message>
    <message>
        <source>Clock offset: %1 s ± %2 ms</source>
        <translation>时钟偏移：%1 s ± %2 ms</translation>
    </message>
    <message>
        <source>Refused: %1 (%2)</source>
        <comment>a reason and how often</comment>
        <translation>被拒绝：%1（%2）</translation>
    </message>
    <message>
        <source>Reason (if you decline)</source>
        <translation>理由（如果拒绝）</translation>
    </message>
    <message>
        <source>Reason for declining</source>
        <translation>拒绝的理由</translation>
    </message>
    <message>
        <source>The other console shows it</source>
        <translation>对方控制台会显示它</translation>
    </message>
    <message>
        <source>Lost on the way, %1: %2</source>
        <translation>途中丢失，%1：%2</translation>
    </message>
</context>
<context>
    <name>teleta::study::AnswerButton</name>
    <message>
        <source>Answer %1: %2</source>
        <comment>letter, name</comment>
        <translation>回答 %1：%2</translation>
    </message>
    <message>
        <source>%1. This was felt.</source>
        <translation>%1。这是感觉到的图案。</translation>
    </message>
    <message>
        <source>%1. This was answered.</source>
        <translation>%1。这是所选的回答。</translation>
    </message>
    <message>
        <source>✓ felt</source>
        <translation>✓ 正确答案</translation>
    </message>
    <message>
        <source>✗ your answer</source>
        <translation>✗ 您的回答</translation>
    </message>
    <message>
        <source>your answer</source>
        <translation>您的回答</translation>
    </message>
    <message>
        <source>Answer: %1</source>
        <comment>yes, no, a number ..</comment>
        <translation>回答：%1</translation>
    </message>
    <message>
        <source>%1. This was right.</source>
        <translation>%1。这是正确答案。</translation>
    </message>
    <message>
        <source>✓ right</source>
        <translation>✓ 正确答案</translation>
    </message>
</context>
<context>
    <name>teleta::study::BraceletView</name>
    <message>
        <source>All participants, mean</source>
        <translation>全体参与者，平均</translation>
    </message>
    <message>
        <source>Connect the bracelet with which the study was run: the balance needs its motors.</source>
        <translation>请连接实验所用的手环：平衡需要其电机。</translation>
    </message>
    <message>
        <source>The balance takes the motors of %1 as they are now. They must be the ones that the study was run with.</source>
        <translation>平衡采用 %1 当前的电机。它们必须是实验所用的电机。</translation>
    </message>
    <message>
        <source>There is no balance: %1.</source>
        <translation>无法平衡：%1。</translation>
    </message>
    <message>
        <source>Best time from burst to burst</source>
        <translation>短振之间的最佳时间</translation>
    </message>
    <message>
        <source>Intensities that can be told apart</source>
        <translation>可区分的强度</translation>
    </message>
    <message>
        <source>Equally strong tactors</source>
        <translation>同样强的振子</translation>
    </message>
    <message>
        <source>As felt b&amp;y</source>
        <translation>感受者(&amp;Y)</translation>
    </message>
    <message>
        <source>&amp;Use for this bracelet…</source>
        <translation>用于此手环(&amp;U)…</translation>
    </message>
    <message>
        <source>Sets the full drives of the connected bracelet, after a question</source>
        <translation>询问后设置已连接手环的满驱动</translation>
    </message>
    <message>
        <source>The participants are simulated: nobody felt this, so it cannot be used for a real bracelet.</source>
        <translation>参与者是模拟的：无人感受过，因此不能用于真实的手环。</translation>
    </message>
</context>
<context>
    <name>teleta::study::ComparisonsView</name>
    <message>
        <source>Pairs of levels</source>
        <translation>水平对</translation>
    </message>
    <message>
        <source>Paired t tests. p Holm is corrected over all pairs of an effect; intervals are not corrected.</source>
        <translation>配对 t 检验。p Holm 已针对同一效应的所有水平对校正；区间未校正。</translation>
    </message>
    <message>
        <source>Effect sizes, and effects by ranks</source>
        <translation>效应量，以及基于秩的效应</translation>
    </message>
    <message>
        <source>The same pairs by ranks</source>
        <translation>基于秩的相同水平对</translation>
    </message>
    <message>
        <source>Model of single answers</source>
        <translation>单次回答的模型</translation>
    </message>
    <message>
        <source>Response times of the conditions</source>
        <translation>各条件的反应时</translation>
    </message>
    <message>
        <source>Exclusions</source>
        <translation>排除</translation>
    </message>
    <message>
        <source>Nothing was deleted: the trials are in the study and in its exports, with the rule that left them out.</source>
        <translation>没有删除任何内容：试次仍在研究及其导出中，并附有将其略去的规则。</translation>
    </message>
    <message>
        <source>With the rules, and without them</source>
        <translation>应用规则与不应用规则</translation>
    </message>
</context>
<context>
    <name>teleta::study::ConfusionView</name>
    <message>
        <source>Confusion matrix</source>
        <translation>混淆矩阵</translation>
    </message>
    <message>
        <source>%1 of %2 right</source>
        <translation>%2 个中正确 %1 个</translation>
    </message>
    <message>
        <source>No trials yet</source>
        <translation>尚无试次</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <comment>count of a row</comment>
        <translation>%1 / %2</translation>
    </message>
    <message>
        <source>%1 not answered in time: </source>
        <comment>pattern</comment>
        <translation>%1 未及时回答： </translation>
    </message>
    <message>
        <source>%1 answered as %2: </source>
        <comment>pattern, pattern</comment>
        <translation>%1 被回答为 %2： </translation>
    </message>
    <message>
        <source>In &amp;percent</source>
        <translation>以百分比显示(&amp;P)</translation>
    </message>
    <message>
        <source>&lt;p&gt;Rows: what was presented. Columns: what was answered, and NONE for no answer in time. &lt;b&gt;Space&lt;/b&gt; or a double click switches between counts and percent of the row.&lt;/p&gt;</source>
        <translation>&lt;p&gt;行：呈现的图案。列：回答的图案，NONE 表示未及时回答。按&lt;b&gt;空格键&lt;/b&gt;或双击可在计数与占行的百分比之间切换。&lt;/p&gt;</translation>
    </message>
</context>
<context>
    <name>teleta::study::ParticipantPicker</name>
    <message numerus="yes">
        <source>%n participant(s)</source>
        <translation>
            <numerusform>%n 名被试</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>teleta::study::ParticipantWindow</name>
    <message>
        <source>Please wait for the experimenter.</source>
        <translation>请等待实验人员。</translation>
    </message>
    <message>
        <source>Press Space for the next trial.</source>
        <translation>按空格键开始下一个试次。</translation>
    </message>
    <message>
        <source>Press Space for the first trial.</source>
        <translation>按空格键开始第一个试次。</translation>
    </message>
    <message>
        <source>Wait …</source>
        <translation>请稍候…</translation>
    </message>
    <message>
        <source>Feel …</source>
        <translation>请感受…</translation>
    </message>
    <message>
        <source>Which pattern do you feel? Press R to feel it again.</source>
        <translation>您感觉到的是哪个图案？按 R 可再感受一次。</translation>
    </message>
    <message>
        <source>Which pattern do you feel?</source>
        <translation>您感觉到的是哪个图案？</translation>
    </message>
    <message>
        <source>Pause. Please wait for the experimenter.</source>
        <translation>暂停。请等待实验人员。</translation>
    </message>
    <message>
        <source>Stopped. The bracelet is off. Please wait for the experimenter.</source>
        <translation>已停止。手环已关闭。请等待实验人员。</translation>
    </message>
    <message>
        <source>This part is finished. Thank you!</source>
        <translation>此部分已完成。谢谢！</translation>
    </message>
    <message>
        <source>Participant</source>
        <translation>被试</translation>
    </message>
    <message>
        <source>Practice</source>
        <translation>练习</translation>
    </message>
    <message>
        <source>Test</source>
        <translation>测试</translation>
    </message>
    <message>
        <source>%1 — %2, trial %3 of %4</source>
        <comment>task, phase, numbers</comment>
        <translation>%1 — %2，第 %3 个试次，共 %4 个</translation>
    </message>
    <message>
        <source>There was no answer in time. The marked pattern was the right one. Press Space to continue.</source>
        <translation>未及时回答。实际呈现的是标出的图案。按空格键继续。</translation>
    </message>
    <message>
        <source>Right. Press Space to continue.</source>
        <translation>正确。按空格键继续。</translation>
    </message>
    <message>
        <source>That was another one: the pattern marked with ✓ was the right one. Press Space to continue.</source>
        <translation>是另一个图案：实际呈现的是标有 ✓ 的图案。按空格键继续。</translation>
    </message>
    <message>
        <source>Take a break. You can continue in %1 s.</source>
        <translation>请休息。%1 秒后可以继续。</translation>
    </message>
    <message>
        <source>Take a break. Press Space when you would like to continue.</source>
        <translation>请休息。想继续时请按空格键。</translation>
    </message>
    <message>
        <source>%1 Press R to feel it again.</source>
        <comment>a question</comment>
        <translation>%1 按 R 可再感受一次。</translation>
    </message>
    <message>
        <source>There was no answer in time. The marked answer was the right one. Press Space to continue.</source>
        <translation>未及时回答。标出的回答是正确答案。按空格键继续。</translation>
    </message>
    <message>
        <source>The answer marked with ✓ was the right one. Press Space to continue.</source>
        <translation>标有 ✓ 的回答是正确答案。按空格键继续。</translation>
    </message>
    <message>
        <source>The session has ended. Please wait for the experimenter.</source>
        <translation>本场次已结束。请等待实验人员。</translation>
    </message>
</context>
<context>
    <name>teleta::study::PlanPanel</name>
    <message>
        <source>Right answers, %1</source>
        <comment>condition</comment>
        <translation>正确率，%1</translation>
    </message>
    <message>
        <source>The middle participant has these shares; the spreads are in logits.</source>
        <translation>居中的被试具有这些比例；离散度以 logit 为单位。</translation>
    </message>
    <message>
        <source>Assumed: what %1 says.</source>
        <translation>假定：按 %1 所述。</translation>
    </message>
    <message>
        <source>&amp;Test</source>
        <translation>检验(&amp;T)</translation>
    </message>
    <message>
        <source>Spread of &amp;participants</source>
        <translation>被试间的离散度(&amp;P)</translation>
    </message>
    <message>
        <source>Spread under one &amp;condition</source>
        <translation>单个条件下的离散度(&amp;C)</translation>
    </message>
    <message>
        <source>From this st&amp;udy</source>
        <translation>来自此研究(&amp;U)</translation>
    </message>
    <message>
        <source>Assumes what the results of this study show; at least 5 participants</source>
        <translation>假定此研究的结果所显示的内容；至少 5 名被试</translation>
    </message>
    <message>
        <source>From this f&amp;orm</source>
        <translation>来自此表单(&amp;O)</translation>
    </message>
    <message>
        <source>Part&amp;icipants</source>
        <translation>被试(&amp;I)</translation>
    </message>
    <message>
        <source>from </source>
        <comment>number of participants</comment>
        <translation>从 </translation>
    </message>
    <message>
        <source>to </source>
        <comment>number of participants</comment>
        <translation>到 </translation>
    </message>
    <message>
        <source>step </source>
        <comment>of the number of participants</comment>
        <translation>步长 </translation>
    </message>
    <message>
        <source>Target po&amp;wer</source>
        <translation>目标检验力(&amp;W)</translation>
    </message>
    <message>
        <source>&amp;Studies drawn</source>
        <translation>抽取的研究数(&amp;S)</translation>
    </message>
    <message>
        <source>P&amp;lan</source>
        <translation>规划(&amp;L)</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Power over the number of participants</source>
        <translation>检验力随被试人数的变化</translation>
    </message>
    <message>
        <source>The power over the number of participants will be shown here.
Enter what you assume on the left, and choose Plan.</source>
        <translation>此处将显示检验功效随参与者人数的变化。
请在左侧输入假设，然后选择“规划”。</translation>
    </message>
    <message>
        <source>There is nothing to plan.</source>
        <translation>没有可规划的内容。</translation>
    </message>
    <message>
        <source>The middle participant has this threshold.</source>
        <translation>居中的被试具有此阈值。</translation>
    </message>
    <message>
        <source>The protocol has no task to plan for.</source>
        <translation>方案中没有可规划的任务。</translation>
    </message>
    <message>
        <source>A TOML file with shares of right answers or thresholds, and spreads</source>
        <translation>含正确率或阈值以及离散度的 TOML 文件</translation>
    </message>
    <message>
        <source>Targ&amp;et</source>
        <translation>目标(&amp;E)</translation>
    </message>
    <message>
        <source>The share of studies with an interval narrow enough will be shown here.
Enter what you assume on the left, and choose Plan.</source>
        <translation>这里将显示区间足够窄的研究所占的比例。
请在左侧输入假设，然后选择“规划”。</translation>
    </message>
    <message>
        <source>Fro&amp;m a file…</source>
        <translation>来自文件(&amp;M)…</translation>
    </message>
</context>
<context>
    <name>teleta::study::QuestionnaireForm</name>
    <message>
        <source>Please answer this question.</source>
        <translation>请回答此问题。</translation>
    </message>
    <message>
        <source>%1 of %2 answered</source>
        <translation>已回答 %1 / %2</translation>
    </message>
    <message>
        <source>&amp;Done</source>
        <translation>完成(&amp;D)</translation>
    </message>
    <message>
        <source>This answer is not valid: %1.</source>
        <comment>what is expected</comment>
        <translation>不符合要求，应为：%1。</translation>
    </message>
    <message>
        <source>Submits the answers (Ctrl+Return)</source>
        <translation>提交回答 (Ctrl+Return)</translation>
    </message>
</context>
<context>
    <name>teleta::study::QuestionnaireItemView</name>
    <message>
        <source>No answer</source>
        <translation>未回答</translation>
    </message>
    <message>
        <source>%1: %2 of %3</source>
        <comment>question, point, points</comment>
        <translation>%1：%2，共 %3 级</translation>
    </message>
    <message>
        <source>%1 (optional)</source>
        <comment>a question</comment>
        <translation>%1（可不填）</translation>
    </message>
</context>
<context>
    <name>teleta::study::ResultsView</name>
    <message>
        <source>All participants</source>
        <translation>全部被试</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <comment>condition, participant</comment>
        <translation>%1，%2</translation>
    </message>
    <message>
        <source>Task</source>
        <translation>任务</translation>
    </message>
    <message>
        <source>Tick one participant, or a group</source>
        <translation>勾选一名被试或一组被试</translation>
    </message>
    <message>
        <source>What the matrices show</source>
        <translation>矩阵显示的内容</translation>
    </message>
    <message>
        <source>Counts</source>
        <translation>计数</translation>
    </message>
    <message>
        <source>Percent of the row</source>
        <translation>占行的百分比</translation>
    </message>
    <message>
        <source>All participants together</source>
        <translation>全部被试合计</translation>
    </message>
    <message>
        <source>Analysis of variance</source>
        <translation>方差分析</translation>
    </message>
    <message>
        <source>Each participant</source>
        <translation>各被试</translation>
    </message>
    <message>
        <source>&amp;Export</source>
        <translation>导出(&amp;E)</translation>
    </message>
    <message>
        <source>Writes the trials, or these results, into the folder of the study</source>
        <translation>将试次或这些结果写入研究的文件夹</translation>
    </message>
    <message>
        <source>Trials as &amp;Psych-DS (CSV)</source>
        <translation>试次存为 Psych-DS (CSV)(&amp;P)</translation>
    </message>
    <message>
        <source>Trials as &amp;BIDS (TSV)</source>
        <translation>试次存为 BIDS (TSV)(&amp;B)</translation>
    </message>
    <message>
        <source>Trials for a &amp;spreadsheet</source>
        <translation>试次用于电子表格(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Results: tables, figures, R script</source>
        <translation>结果：表格、图、R 脚本(&amp;R)</translation>
    </message>
    <message>
        <source>No comparison</source>
        <translation>不对比</translation>
    </message>
    <message>
        <source>Participants shown</source>
        <translation>显示的被试</translation>
    </message>
    <message>
        <source>Participants for comparison</source>
        <translation>对比的被试</translation>
    </message>
    <message>
        <source>Tick the participants to compare with: a second group, side by side</source>
        <translation>勾选要对比的被试：第二组并排显示</translation>
    </message>
    <message>
        <source>Comparisons</source>
        <translation>比较</translation>
    </message>
    <message>
        <source>Answers</source>
        <translation>回答</translation>
    </message>
    <message>
        <source>Thresholds</source>
        <translation>阈值</translation>
    </message>
    <message>
        <source>Tracks</source>
        <translation>序列</translation>
    </message>
    <message>
        <source>d&apos; and c</source>
        <translation>d&apos; 与 c</translation>
    </message>
    <message>
        <source>Whose threshold is shown</source>
        <translation>显示谁的阈值</translation>
    </message>
    <message>
        <source>Which track is shown</source>
        <translation>显示哪个序列</translation>
    </message>
    <message>
        <source>Which condition is shown</source>
        <translation>显示哪个条件</translation>
    </message>
    <message>
        <source>Bracelet</source>
        <translation>手环</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>letter of a pattern, its name</comment>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>No results yet</source>
        <translation>尚无结果</translation>
    </message>
    <message>
        <source>Each task&apos;s confusion matrices, accuracy and response times appear here while test trials are completed.</source>
        <translation>随着正式试次的完成，每个任务的混淆矩阵、准确率和反应时间会显示在这里。</translation>
    </message>
</context>
<context>
    <name>teleta::study::SessionPanel</name>
    <message>
        <source>Stop the noise</source>
        <translation>停止噪声</translation>
    </message>
    <message>
        <source>Play the noise</source>
        <translation>播放噪声</translation>
    </message>
    <message>
        <source>Abort the session?</source>
        <translation>中止场次？</translation>
    </message>
    <message>
        <source>&amp;Abort the session</source>
        <translation>中止场次(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Go on</source>
        <translation>继续(&amp;G)</translation>
    </message>
    <message>
        <source>Next step</source>
        <translation>下一步</translation>
    </message>
    <message>
        <source>What to do next (Ctrl+Return)</source>
        <translation>下一步操作 (Ctrl+Return)</translation>
    </message>
    <message>
        <source>Checks before the run</source>
        <translation>运行前的检查</translation>
    </message>
    <message>
        <source>Noise &amp;confirmed</source>
        <translation>噪声已确认(&amp;C)</translation>
    </message>
    <message>
        <source>The participant hears the masking noise at the level of the protocol</source>
        <translation>被试听到的掩蔽噪声达到方案规定的声级</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>进度</translation>
    </message>
    <message>
        <source>Last trials</source>
        <translation>最近的试次</translation>
    </message>
    <message>
        <source>Trial</source>
        <translation>试次</translation>
    </message>
    <message>
        <source>Presented</source>
        <translation>呈现</translation>
    </message>
    <message>
        <source>Answered</source>
        <translation>回答</translation>
    </message>
    <message>
        <source>Outcome</source>
        <translation>结果</translation>
    </message>
    <message>
        <source>Response time</source>
        <translation>反应时间</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>备注</translation>
    </message>
    <message>
        <source>Participant&apos;s &amp;window</source>
        <translation>被试窗口(&amp;W)</translation>
    </message>
    <message>
        <source>&amp;Pause</source>
        <translation>暂停(&amp;P)</translation>
    </message>
    <message>
        <source>The session ends here. All answers are saved, and it can be resumed later where it stopped.</source>
        <translation>场次在此结束。已有的回答均会保留，以后可从停止处继续此场次。</translation>
    </message>
    <message>
        <source>Skip the questionnaire?</source>
        <translation>跳过问卷？</translation>
    </message>
    <message>
        <source>What is filled in is lost, and a note says that it was skipped.</source>
        <translation>已填写的内容将丢失，并会记录备注说明问卷已跳过。</translation>
    </message>
    <message>
        <source>&amp;Skip it</source>
        <translation>跳过(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Continue with it</source>
        <translation>继续填写(&amp;G)</translation>
    </message>
    <message>
        <source>A note on this session; Return saves it</source>
        <translation>关于此场次的备注；按 Return 保存</translation>
    </message>
    <message>
        <source>Shows the participant&apos;s window, on the second screen if there is one</source>
        <translation>显示被试窗口；有第二屏幕时显示在其上</translation>
    </message>
    <message>
        <source>S&amp;kip the questionnaire…</source>
        <translation>跳过问卷(&amp;L)…</translation>
    </message>
    <message>
        <source>Continues without the participant&apos;s answers</source>
        <translation>不等被试回答即继续</translation>
    </message>
    <message>
        <source>Pauses after the current trial</source>
        <translation>在当前试次之后暂停</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>水平</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>时间</translation>
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
        <translation>● 在服务器上：%1</translation>
    </message>
    <message>
        <source>✗ The study cannot be used: %1</source>
        <translation>✗ 无法使用研究：%1</translation>
    </message>
    <message>
        <source>%1 of %2 trials</source>
        <comment>kept</comment>
        <translation>%1 / %2 个试次</translation>
    </message>
    <message>
        <source>&amp;New…</source>
        <translation>新建(&amp;N)…</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>打开(&amp;O)…</translation>
    </message>
    <message>
        <source>Open another study</source>
        <translation>打开另一个研究</translation>
    </message>
    <message>
        <source>The &amp;folder of a study…</source>
        <translation>研究的文件夹(&amp;F)…</translation>
    </message>
    <message>
        <source>A study on a &amp;server…</source>
        <translation>服务器上的研究(&amp;S)…</translation>
    </message>
    <message>
        <source>Pro&amp;tocol…</source>
        <translation>方案(&amp;T)…</translation>
    </message>
    <message>
        <source>Participants</source>
        <translation>被试</translation>
    </message>
    <message>
        <source>Session</source>
        <translation>场次</translation>
    </message>
    <message>
        <source>State</source>
        <translation>状态</translation>
    </message>
    <message>
        <source>Participants and their sessions</source>
        <translation>被试及其场次</translation>
    </message>
    <message>
        <source>Name of a new participant, for example P07</source>
        <translation>新被试的名称，例如 P07</translation>
    </message>
    <message>
        <source>Name of a new participant</source>
        <translation>新被试的名称</translation>
    </message>
    <message>
        <source>A&amp;dd</source>
        <translation>添加(&amp;D)</translation>
    </message>
    <message>
        <source>Enrol this participant</source>
        <translation>登记此被试</translation>
    </message>
    <message>
        <source>✗ Server unreachable: %1</source>
        <translation>✗ 服务器已断开：%1</translation>
    </message>
    <message>
        <source>Create a new study</source>
        <translation>开始新的研究</translation>
    </message>
    <message>
        <source>View the protocol, or make another one from it</source>
        <translation>查看方案，或由它制作另一个方案</translation>
    </message>
    <message>
        <source>&amp;Delete the participant…</source>
        <translation>删除被试(&amp;D)…</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>participant, order of the conditions</comment>
        <translation>%1：%2</translation>
    </message>
</context>
<context>
    <name>teleta::study::StudyStart</name>
    <message>
        <source>%1 stopped in “%2” after %3 of %4 trials.</source>
        <comment>a participant</comment>
        <translation>%1 在“%2”中完成 %4 个试次中的 %3 个后中断。</translation>
    </message>
    <message>
        <source>Nobody has taken part yet.</source>
        <translation>尚无人参加。</translation>
    </message>
    <message>
        <source>%1 of %2 sessions are finished.</source>
        <translation>%2 个场次中已完成 %1 个。</translation>
    </message>
    <message>
        <source>A rehearsal. %1</source>
        <translation>预演。%1</translation>
    </message>
    <message>
        <source>Go on with “%1”</source>
        <comment>a study</comment>
        <translation>继续“%1”</translation>
    </message>
    <message>
        <source>No study is open</source>
        <translation>未打开研究</translation>
    </message>
    <message>
        <source>Run the published user study, or one of your own: from the first practice trial to confusion matrices and ANOVA.</source>
        <translation>进行已发表的用户研究，或您自己的研究：从第一个练习试次到混淆矩阵和方差分析。</translation>
    </message>
    <message>
        <source>Watch a rehearsal</source>
        <translation>观看预演</translation>
    </message>
    <message>
        <source>Simulated participants go through the whole study, and its results build up.</source>
        <translation>模拟被试完成整个研究，结果逐步形成。</translation>
    </message>
    <message>
        <source>The published protocol</source>
        <translation>已发表的方案</translation>
    </message>
    <message>
        <source>Six shapes and five stiffnesses, static and dynamic: read every step, and begin a study with it.</source>
        <translation>六种形状和五种刚度，静态和动态：阅读每一步，并用它开始一项研究。</translation>
    </message>
    <message>
        <source>Your own study</source>
        <translation>您自己的研究</translation>
    </message>
    <message>
        <source>Begin with a protocol of yours, or go on with a study in a folder or on a server.</source>
        <translation>用您自己的方案开始，或继续文件夹中或服务器上的研究。</translation>
    </message>
    <message>
        <source>Go on</source>
        <translation>继续</translation>
    </message>
    <message>
        <source>Open the study that was open last</source>
        <translation>打开上次打开的研究</translation>
    </message>
    <message>
        <source>Watch</source>
        <translation>观看</translation>
    </message>
    <message>
        <source>Simulated participants go through the whole study</source>
        <translation>模拟被试完成整个研究</translation>
    </message>
    <message>
        <source>Read it</source>
        <translation>阅读</translation>
    </message>
    <message>
        <source>Stimuli, practice and test trials of the paper</source>
        <translation>论文的刺激、练习试次和测试试次</translation>
    </message>
    <message>
        <source>New…</source>
        <translation>新建…</translation>
    </message>
    <message>
        <source>With the paper&apos;s protocol or your own</source>
        <translation>按论文方案，或按您自己的方案</translation>
    </message>
    <message>
        <source>Open…</source>
        <translation>打开…</translation>
    </message>
    <message>
        <source>The folder of a study</source>
        <translation>研究的文件夹</translation>
    </message>
    <message>
        <source>Server…</source>
        <translation>服务器…</translation>
    </message>
    <message>
        <source>A study that several stations share</source>
        <translation>多个工作站共用的研究</translation>
    </message>
</context>
<context>
    <name>teleta::study::ThresholdForm</name>
    <message>
        <source>log10 units</source>
        <translation>log10 单位</translation>
    </message>
    <message>
        <source>Spread of &amp;participants</source>
        <translation>被试间的离散度(&amp;P)</translation>
    </message>
    <message>
        <source>How far the 95 % interval of the mean threshold may reach to each side</source>
        <translation>平均阈值的 95 % 区间可向两侧延伸的最大距离</translation>
    </message>
    <message>
        <source>as in the protocol</source>
        <translation>按方案</translation>
    </message>
    <message>
        <source>Of constant stimuli: at each level</source>
        <translation>恒定刺激：每个水平</translation>
    </message>
    <message>
        <source>Slope (Wei&amp;bull)</source>
        <translation>斜率 (Weibull)(&amp;B)</translation>
    </message>
    <message>
        <source>Spread of the fu&amp;nction</source>
        <translation>函数的展宽(&amp;N)</translation>
    </message>
    <message>
        <source>&amp;Yes without a stimulus</source>
        <translation>无刺激时答“是”(&amp;Y)</translation>
    </message>
    <message>
        <source>Interval at &amp;most ±</source>
        <translation>区间最多 ±(&amp;M)</translation>
    </message>
    <message>
        <source>Trials of a trac&amp;k</source>
        <translation>一条轨迹的试次数(&amp;K)</translation>
    </message>
    <message>
        <source>&amp;Threshold</source>
        <translation>阈值(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Lapses</source>
        <translation>失误率(&amp;L)</translation>
    </message>
</context>
<context>
    <name>teleta::tactile::ChannelSettingsPanel</name>
    <message>
        <source>Not tared</source>
        <translation>未去皮</translation>
    </message>
    <message>
        <source>Tared</source>
        <translation>已去皮</translation>
    </message>
    <message numerus="yes">
        <source>Tared, %n taxel(s) without a reading</source>
        <translation>
            <numerusform>已去皮，%n 个触觉单元无读数</numerusform>
        </translation>
    </message>
    <message>
        <source>&amp;Tare now</source>
        <translation>立即去皮(&amp;T)</translation>
    </message>
    <message>
        <source>Takes the mean of the next half second as the unloaded state. Nothing may touch the array.</source>
        <translation>取接下来半秒的平均值作为空载状态。期间不得有任何物体接触阵列。</translation>
    </message>
    <message>
        <source>&amp;Clear tare</source>
        <translation>清除去皮(&amp;C)</translation>
    </message>
    <message>
        <source>Uses the raw values again</source>
        <translation>重新使用原始值</translation>
    </message>
    <message>
        <source>&amp;Gain:</source>
        <translation>增益(&amp;G)：</translation>
    </message>
    <message>
        <source>Load per raw unit</source>
        <translation>每原始单位的载荷</translation>
    </message>
    <message>
        <source>For arrays whose raw values are highest when nothing touches them</source>
        <translation>用于无接触时原始值最高的阵列</translation>
    </message>
    <message>
        <source>A taxel is in contact from this load on</source>
        <translation>触觉单元从此载荷起视为接触</translation>
    </message>
    <message>
        <source>Finds the lowest useful threshold in each frame; the value above is its lower bound</source>
        <translation>在每帧中求最低的有效阈值；上方的值为其下限</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>&amp;Smallest contact:</source>
        <translation>最小接触(&amp;S)：</translation>
    </message>
    <message>
        <source>&amp;Orientation:</source>
        <translation>方向(&amp;O)：</translation>
    </message>
    <message>
        <source>Which taxels the principal axis is computed from</source>
        <translation>由哪些触觉单元计算主轴</translation>
    </message>
    <message>
        <source>whole image</source>
        <translation>整幅图像</translation>
    </message>
    <message>
        <source>active taxels</source>
        <translation>活动触觉单元</translation>
    </message>
    <message>
        <source>&amp;Edge above:</source>
        <translation>高于此值为边缘(&amp;E)：</translation>
    </message>
    <message>
        <source>The contact becomes an edge when the ratio of the eigenvalues rises above this</source>
        <translation>特征值之比升至此值以上时，接触判为边缘</translation>
    </message>
    <message>
        <source>&amp;Point below:</source>
        <translation>低于此值为点(&amp;P)：</translation>
    </message>
    <message>
        <source>The contact becomes a point when the ratio of the eigenvalues falls below this</source>
        <translation>特征值之比降至此值以下时，接触判为点</translation>
    </message>
    <message>
        <source>&amp;Defaults</source>
        <translation>默认值(&amp;D)</translation>
    </message>
    <message>
        <source> %1/raw unit</source>
        <comment>of a gain: load per raw unit</comment>
        <translation> %1/原始单位</translation>
    </message>
    <message>
        <source> taxel</source>
        <translation> 个触觉单元</translation>
    </message>
    <message>
        <source> taxels</source>
        <translation> 个触觉单元</translation>
    </message>
    <message>
        <source>taxel gains in use</source>
        <translation>正在使用触觉单元增益</translation>
    </message>
    <message>
        <source>Two peaks count as one contact when the lower one rises less than this above the saddle between them, in percent of the highest peak of the frame</source>
        <translation>若两个峰顶中较低者高出其间鞍点的量小于此值（帧峰值的百分比），则视为同一接触</translation>
    </message>
    <message>
        <source>In taxels; smaller contacts are ignored</source>
        <translation>以触觉单元计；触觉单元数更少的接触将被忽略</translation>
    </message>
    <message>
        <source>active taxels equally</source>
        <translation>活动触觉单元等权</translation>
    </message>
    <message>
        <source>weighted by load</source>
        <translation>按载荷加权</translation>
    </message>
    <message>
        <source>Whole image: adds up every load. Active taxels: leaves out the noise of unloaded taxels</source>
        <translation>整幅图像计入所有载荷；活动触觉单元则排除空载触觉单元的噪声</translation>
    </message>
    <message>
        <source>Reset everything but the tare and the taxel gains</source>
        <translation>除去皮和触觉单元增益外全部恢复默认值</translation>
    </message>
    <message>
        <source>Values fall under load</source>
        <translation>数值随载荷增大而下降</translation>
    </message>
    <message>
        <source>Thresho&amp;ld:</source>
        <translation>阈值(&amp;L)：</translation>
    </message>
    <message>
        <source>A&amp;utomatic threshold</source>
        <translation>自动阈值(&amp;U)</translation>
    </message>
    <message>
        <source>Force over:</source>
        <translation>力的范围：</translation>
    </message>
    <message>
        <source>No&amp;ise height:</source>
        <translation>噪声高度(&amp;I)：</translation>
    </message>
    <message>
        <source>Loads</source>
        <comment>a group of settings</comment>
        <translation>载荷</translation>
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
        <translation>触觉热图</translation>
    </message>
    <message>
        <source>&amp;Contacts</source>
        <translation>接触(&amp;C)</translation>
    </message>
    <message>
        <source>Outline each contact and show its number</source>
        <translation>勾勒各接触并显示其编号</translation>
    </message>
    <message>
        <source>Mark the load-weighted centre with ×</source>
        <translation>用 × 标出载荷加权中心</translation>
    </message>
    <message>
        <source>Mark the centre of the touched area with ○</source>
        <translation>用 ○ 标出接触区域的中心</translation>
    </message>
    <message>
        <source>Draw the axis along which the touched area is longest</source>
        <translation>绘制接触区域最长方向的轴</translation>
    </message>
    <message>
        <source>&amp;Numbers</source>
        <translation>数值(&amp;N)</translation>
    </message>
    <message>
        <source>Write each load into its taxel where there is room</source>
        <translation>空间足够时将载荷写入触觉单元</translation>
    </message>
    <message>
        <source>heatmap</source>
        <translation>热图</translation>
    </message>
    <message>
        <source>&amp;Automatic</source>
        <translation>自动(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Fixed at %1</source>
        <translation>固定为 %1(&amp;F)</translation>
    </message>
    <message>
        <source>Upper end of the colours</source>
        <translation>颜色上端</translation>
    </message>
    <message>
        <source>Load at the upper end of the colours. Empty: automatic.</source>
        <translation>颜色上端对应的载荷。留空：自动。</translation>
    </message>
    <message>
        <source>auto</source>
        <translation>自动</translation>
    </message>
    <message>
        <source>Dead taxel: its value is not used.</source>
        <translation>失效触觉单元：其值不被使用。</translation>
    </message>
    <message>
        <source>Centre of &amp;pressure</source>
        <translation>压力中心(&amp;P)</translation>
    </message>
    <message>
        <source>Centre of c&amp;ontact</source>
        <translation>接触中心(&amp;O)</translation>
    </message>
    <message>
        <source>Principal &amp;axis</source>
        <translation>主轴(&amp;A)</translation>
    </message>
    <message>
        <source>Colour &amp;range</source>
        <translation>颜色范围(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Type upper end…</source>
        <translation>输入上端(&amp;T)…</translation>
    </message>
    <message>
        <source>Show &amp;whole array</source>
        <translation>显示整个阵列(&amp;W)</translation>
    </message>
    <message>
        <source>Loads from 0 to %1. Taxels below the threshold of %2 are not in contact.
Double-click to type the upper end.</source>
        <translation>载荷从 0 到 %1。低于阈值 %2 的触觉单元不属于接触。
双击可输入上端。</translation>
    </message>
    <message>
        <source>&lt;p&gt;The load of every taxel of the array, seen from outside the skin: x points to the right, y up.&lt;/p&gt;&lt;p&gt;Coloured outlines are contacts, each with the number under which it is followed. × is the centre of pressure, ○ the centre of contact, the line the principal axis. Hatched taxels are dead and carry no load. Arrows are the force along the surface, of arrays that measure it; zoom in where taxels are too small for them.&lt;/p&gt;&lt;p&gt;Ctrl+wheel zooms, drag moves, double click shows the whole array. Double-click the colour bar to type its upper end. The arrow keys read taxel by taxel.&lt;/p&gt;</source>
        <translation>&lt;p&gt;阵列中每个触觉单元的载荷，从皮肤外侧看：x 向右，y 向上。&lt;/p&gt;&lt;p&gt;彩色轮廓线为接触，各带其跟踪编号。× 为压力中心，○ 为接触中心，直线为主轴。带斜线的触觉单元已失效，不承载。箭头是沿表面的力（限能测量它的阵列）；触觉单元太小画不下时请放大。&lt;/p&gt;&lt;p&gt;Ctrl+滚轮缩放，拖动平移，双击显示整个阵列。双击颜色条可输入其上端。方向键逐个触觉单元读数。&lt;/p&gt;</translation>
    </message>
    <message>
        <source>&amp;Shear</source>
        <translation>剪切(&amp;H)</translation>
    </message>
    <message>
        <source>Draw the force along the surface as arrows, of arrays that measure it</source>
        <translation>用箭头画出沿表面的力（限能测量它的阵列）</translation>
    </message>
    <message>
        <source>load</source>
        <translation>载荷</translation>
    </message>
    <message>
        <source>moment</source>
        <translation>力矩</translation>
    </message>
    <message>
        <source>shear along x</source>
        <translation>沿 x 的剪切</translation>
    </message>
    <message>
        <source>shear along y</source>
        <translation>沿 y 的剪切</translation>
    </message>
</context>
<context>
    <name>teleta::touch::ContourView</name>
    <message>
        <source>Explored contour</source>
        <translation>已探索的轮廓</translation>
    </message>
    <message>
        <source>contour</source>
        <translation>轮廓</translation>
    </message>
    <message>
        <source>&amp;Forget the explored contour</source>
        <translation>清除已探索的轮廓(&amp;F)</translation>
    </message>
    <message>
        <source>&lt;p&gt;The object from above, as far as it was explored: the points at which it was touched, the spline through them, and the vertices or the circle of the shape that was recognised.&lt;/p&gt;&lt;p&gt;The confidence is the share of such answers that are right. While the points do not decide, the shapes that come into question stand there with their probabilities.&lt;/p&gt;</source>
        <translation>&lt;p&gt;从上方看已探索部分的物体：触碰过的点、通过这些点的样条曲线，以及所识别形状的顶点或圆。&lt;/p&gt;&lt;p&gt;置信度是此类答案中正确者所占的比例。各点尚不足以判定时，显示可能的形状及其概率。&lt;/p&gt;</translation>
    </message>
</context>
<context>
    <name>teleta::touch::DriveSign</name>
    <message>
        <source>Drive of the arm</source>
        <translation>机械臂驱动方式</translation>
    </message>
    <message>
        <source>no arm</source>
        <translation>无机械臂</translation>
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
        <translation>点动机械臂</translation>
    </message>
    <message>
        <source>&lt;p&gt;Moves the arm by hand. It moves only while you hold Shift, or the wide button, together with a direction. Let go of either and it stands still.&lt;/p&gt;</source>
        <translation>&lt;p&gt;手动移动机械臂。仅当您按住 Shift 或宽按钮，同时按住一个方向时才会移动。松开其中任何一个，机械臂即静止。&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Let the arm&apos;s program go on</source>
        <translation>让机械臂的程序继续</translation>
    </message>
    <message>
        <source>Hold the arm where it is</source>
        <translation>使机械臂保持在原处</translation>
    </message>
    <message>
        <source>R&amp;estart</source>
        <translation>重新开始(&amp;E)</translation>
    </message>
    <message>
        <source>Joints</source>
        <translation>关节</translation>
    </message>
    <message>
        <source>Tip, x y z</source>
        <translation>末端，x y z</translation>
    </message>
    <message>
        <source>What is moved</source>
        <translation>移动对象</translation>
    </message>
    <message>
        <source>Turn single joints, or move the tip of the forearm along the base&apos;s axes</source>
        <translation>转动单个关节，或沿基座坐标轴移动前臂末端</translation>
    </message>
    <message>
        <source>&amp;Speed</source>
        <translation>速度(&amp;S)</translation>
    </message>
    <message>
        <source>Share of the fastest speed</source>
        <translation>占最高速度的比例</translation>
    </message>
    <message>
        <source>Jog speed</source>
        <translation>点动速度</translation>
    </message>
    <message>
        <source>Hold to enable (or Shift)</source>
        <translation>按住以使能（或 Shift）</translation>
    </message>
    <message>
        <source>Dead-man switch: the arm moves only while this button or Shift is held</source>
        <translation>使能开关：仅在按住此按钮或 Shift 时机械臂才会移动</translation>
    </message>
    <message>
        <source>Dead-man switch</source>
        <translation>使能开关</translation>
    </message>
    <message>
        <source>Angle of %1</source>
        <translation>%1 的角度</translation>
    </message>
    <message>
        <source>tip along %1</source>
        <translation>末端沿 %1</translation>
    </message>
    <message>
        <source>%1 up</source>
        <translation>%1 正向</translation>
    </message>
    <message>
        <source>%1 down</source>
        <translation>%1 负向</translation>
    </message>
    <message>
        <source>Hold with Shift to move; key Shift+%1</source>
        <translation>与 Shift 同时按住以移动；按键 Shift+%1</translation>
    </message>
    <message>
        <source>No arm is connected. Open a scene or a device with an arm.</source>
        <translation>未连接机械臂。请打开带机械臂的场景或设备。</translation>
    </message>
    <message>
        <source>STOP is engaged. Hold the STOP button to release it, then jog.</source>
        <translation>STOP 已触发。按住 STOP 按钮解除后再点动。</translation>
    </message>
    <message>
        <source>Hold Shift and a button, or Shift with D A (x), W S (y), E Q (z).</source>
        <translation>按住 Shift 和一个按钮，或按 Shift 加 D A (x)、W S (y)、E Q (z)。</translation>
    </message>
    <message>
        <source>The joint readings are old: nothing is moved until they come again.</source>
        <translation>关节读数已过时：在新读数到来之前不会移动。</translation>
    </message>
    <message>
        <source>&amp;Step</source>
        <translation>步长(&amp;T)</translation>
    </message>
    <message>
        <source>How far a press leads the tip, and a 3D mouse that is fully deflected</source>
        <translation>每按一次，或 3D 鼠标完全偏转时，末端移动的距离</translation>
    </message>
    <message>
        <source>Length of a step</source>
        <translation>每步的长度</translation>
    </message>
    <message>
        <source>By velocity</source>
        <translation>按速度</translation>
    </message>
    <message>
        <source>By position</source>
        <translation>按位置</translation>
    </message>
    <message>
        <source>How it is moved</source>
        <translation>移动方式</translation>
    </message>
    <message>
        <source>By velocity the arm moves while a direction is held. By position each press is a step of the tip, and a 3D mouse leads the tip as far as it is deflected.</source>
        <translation>按速度时，按住方向期间机械臂移动。按位置时，每按一次末端移动一步，3D 鼠标偏转多少，末端就移动多少。</translation>
    </message>
    <message>
        <source>Clutch (C)</source>
        <translation>离合 (C)</translation>
    </message>
    <message>
        <source>While it is held the arm stands still and the hand goes back freely; then it takes hold anew. Also the second button of a 3D mouse.</source>
        <translation>按住期间机械臂静止，手可自由收回；松开后重新接合。也可用 3D 鼠标的第二个按钮。</translation>
    </message>
    <message>
        <source>Clutch</source>
        <translation>离合</translation>
    </message>
    <message>
        <source>Hold Shift: each press of D A (x), W S (y), E Q (z) is a step.</source>
        <translation>按住 Shift：每按一次 D A (x)、W S (y)、E Q (z) 移动一步。</translation>
    </message>
    <message>
        <source>&lt;p&gt;Leads the tip of the arm by hand. Each press of a direction is a step. The arm moves only while you hold Shift, or the wide button; let go of it and it stands still.&lt;/p&gt;</source>
        <translation>&lt;p&gt;用手引导机械臂的末端。每按一次方向走一步。只有按住 Shift 或宽按钮时机械臂才会移动；松开即停止。&lt;/p&gt;</translation>
    </message>
    <message>
        <source>A step, while Shift is held; key Shift+%1</source>
        <translation>按住 Shift 时走一步；按键 Shift+%1</translation>
    </message>
    <message>
        <source>A recording is played: what its arm did is over, and nothing can be moved.</source>
        <translation>正在回放记录：机械臂的动作已成过去，无法再移动。</translation>
    </message>
    <message>
        <source>Restart the arm&apos;s program</source>
        <translation>重新开始机械臂的程序</translation>
    </message>
    <message>
        <source>Hold with Shift to move</source>
        <translation>与 Shift 同时按住以移动</translation>
    </message>
    <message>
        <source>Hold Shift and a button, or Shift with %1 (up), %2 (down).</source>
        <translation>按住 Shift 和一个按钮，或按 Shift 加 %1（正向）、%2（负向）。</translation>
    </message>
    <message>
        <source>tip %1</source>
        <translation>末端 %1</translation>
    </message>
    <message>
        <source>Click here first: the keys work only in this view. %1</source>
        <translation>请先单击此处：按键只在此视图中有效。%1</translation>
    </message>
    <message>
        <source>The arm does not move: %1.</source>
        <translation>机械臂不运动：%1。</translation>
    </message>
    <message>
        <source>UNGUARDED: the robot does not stop by itself when this program or the network fails. Keep its emergency stop within reach. %1</source>
        <translation>无保护：本程序或网络出故障时，机器人不会自行停止。请确保急停按钮触手可及。%1</translation>
    </message>
    <message>
        <source>At the tip: force %1, torque %2</source>
        <translation>末端：力 %1，力矩 %2</translation>
    </message>
    <message>
        <source>Speed and effort of %1, as the arm reports them</source>
        <translation>%1 的速度和 effort，由机械臂报告</translation>
    </message>
    <message>
        <source>R&amp;un</source>
        <translation>运行(&amp;U)</translation>
    </message>
    <message>
        <source>H&amp;old</source>
        <translation>保持(&amp;O)</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>a button and what it does</comment>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>Hold (or Shift)</source>
        <translation>按住（或 Shift）</translation>
    </message>
    <message>
        <source>Hold Shift with %1 (up), %2 (down).</source>
        <translation>按住 Shift 加 %1（正向）、%2（负向）。</translation>
    </message>
</context>
<context>
    <name>teleta::touch::JointRange</name>
    <message>
        <source>%1 limit</source>
        <translation>%1，到极限</translation>
    </message>
    <message>
        <source>limit</source>
        <translation>极限</translation>
    </message>
    <message>
        <source>Turns without limits</source>
        <translation>无限制旋转</translation>
    </message>
    <message>
        <source>Range %1 … %2</source>
        <translation>范围 %1 … %2</translation>
    </message>
</context>
<context>
    <name>teleta::touch::LimitLine</name>
    <message>
        <source>Active limits: %1.</source>
        <translation>起作用的限制：%1。</translation>
    </message>
    <message>
        <source>Near a singularity: slower.</source>
        <translation>接近奇异位形：速度降低。</translation>
    </message>
</context>
<context>
    <name>teleta::touch::PatternMapTable</name>
    <message>
        <source>level %1: %2</source>
        <translation>等级 %1：%2</translation>
    </message>
    <message>
        <source>What was recognised and its pattern</source>
        <translation>识别内容及其图案</translation>
    </message>
    <message>
        <source>&lt;p&gt;Which pattern the bracelet plays for what was recognised. The marked row was recognised last.&lt;/p&gt;</source>
        <translation>&lt;p&gt;针对识别的内容，手环播放哪个图案。标出的行是最近识别的内容。&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Patterns for what was recognised</source>
        <translation>识别内容对应的图案</translation>
    </message>
    <message>
        <source>Recognised</source>
        <translation>识别内容</translation>
    </message>
    <message>
        <source>Pattern</source>
        <translation>图案</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>撤销(&amp;U)</translation>
    </message>
    <message>
        <source>&amp;Defaults</source>
        <translation>默认值(&amp;D)</translation>
    </message>
    <message>
        <source>The built-in dynamic patterns again; can be undone</source>
        <translation>恢复内置的动态图案；可撤销</translation>
    </message>
    <message>
        <source>&amp;Import…</source>
        <translation>导入(&amp;I)…</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>导出(&amp;E)…</translation>
    </message>
    <message>
        <source>Pattern for %1</source>
        <translation>%1 的图案</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>无</translation>
    </message>
    <message>
        <source>%1 (missing)</source>
        <translation>%1（缺失）</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1，%2</translation>
    </message>
    <message>
        <source>%1 (now)</source>
        <translation>%1（当前）</translation>
    </message>
    <message>
        <source>Nothing was recognised yet.</source>
        <translation>尚未识别任何内容。</translation>
    </message>
    <message>
        <source>Recognised: %1. Nothing is played.</source>
        <translation>已识别：%1。不播放任何内容。</translation>
    </message>
    <message>
        <source>Recognised: %1. Pattern now: %2.</source>
        <translation>已识别：%1。当前图案：%2。</translation>
    </message>
    <message>
        <source>Recognised: %1. Its pattern %2 is missing.</source>
        <translation>已识别：%1。其图案 %2 缺失。</translation>
    </message>
    <message>
        <source>Default patterns</source>
        <translation>默认图案</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>导入</translation>
    </message>
    <message>
        <source>The file could not be written: %1</source>
        <translation>无法写入文件：%1</translation>
    </message>
    <message>
        <source>Map of patterns (*.json)</source>
        <translation>图案对应表 (*.json)</translation>
    </message>
    <message>
        <source>Export patterns</source>
        <translation>导出图案</translation>
    </message>
    <message>
        <source>Import patterns</source>
        <translation>导入图案</translation>
    </message>
    <message>
        <source>unknown stiffness</source>
        <translation>刚度未知</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>种类</translation>
    </message>
    <message>
        <source>Red&amp;o</source>
        <translation>重做(&amp;O)</translation>
    </message>
</context>
<context>
    <name>teleta::touch::RunSheet</name>
    <message>
        <source>Run sheet</source>
        <translation>物体清单</translation>
    </message>
    <message>
        <source>&lt;p&gt;The objects that were found, told apart by their place. Stiffness is the median of their touches, with its 95 % interval.&lt;/p&gt;&lt;p&gt;F2 names an object, Delete takes it off the sheet, Ctrl+Z brings it back.&lt;/p&gt;</source>
        <translation>&lt;p&gt;已发现的物体，按位置区分。刚度为其各次触碰的中位数，并附 95 % 区间。&lt;/p&gt;&lt;p&gt;F2 为物体命名，Delete 将其从清单中删除，Ctrl+Z 将其恢复。&lt;/p&gt;</translation>
    </message>
    <message>
        <source>No object was found yet. Drive the arm until it touches something.</source>
        <translation>尚未发现物体。请操纵机械臂，直到它触碰到物体。</translation>
    </message>
    <message>
        <source>&amp;Name…</source>
        <translation>命名(&amp;N)…</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>删除(&amp;D)</translation>
    </message>
    <message>
        <source>&amp;Undo %1</source>
        <translation>撤销(&amp;U) %1</translation>
    </message>
    <message>
        <source>&amp;Redo %1</source>
        <translation>重做(&amp;R) %1</translation>
    </message>
    <message numerus="yes">
        <source>%n object(s) found</source>
        <translation>
            <numerusform>已发现 %n 个物体</numerusform>
        </translation>
    </message>
    <message>
        <source>run-sheet</source>
        <comment>name of a file</comment>
        <translation>物体清单</translation>
    </message>
    <message>
        <source>No object was found yet. Play the recording until the arm touches something.</source>
        <translation>尚未发现物体。请回放记录，直到机械臂触碰到物体。</translation>
    </message>
</context>
<context>
    <name>teleta::touch::RunSheetModel</name>
    <message>
        <source>Rename object %1</source>
        <translation>重命名物体 %1</translation>
    </message>
    <message>
        <source>Delete from the run sheet</source>
        <translation>从物体清单中删除</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>序号</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Found at</source>
        <translation>发现时间</translation>
    </message>
    <message>
        <source>Place x, y</source>
        <translation>位置 x、y</translation>
    </message>
    <message>
        <source>Touches</source>
        <translation>触碰</translation>
    </message>
    <message>
        <source>Contact</source>
        <translation>接触</translation>
    </message>
    <message>
        <source>Stiffness</source>
        <translation>刚度</translation>
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
        <translation>其首次触碰开始的时间，与“触碰”中相同</translation>
    </message>
    <message>
        <source>The highest force of all its touches, from the torques of the joints</source>
        <translation>其所有触碰中由关节力矩得出的最大力</translation>
    </message>
    <message>
        <source>Force when evaluated</source>
        <translation>评估时的力</translation>
    </message>
</context>
<context>
    <name>teleta::touch::StiffnessGauge</name>
    <message>
        <source>Stiffness of the touched object</source>
        <translation>被触碰物体的刚度</translation>
    </message>
    <message>
        <source>&lt;p&gt;How stiff the object is that was touched last, on a logarithmic scale. The dot is the estimate, the line through it the interval in which the stiffness lies with 95 %.&lt;/p&gt;&lt;p&gt;An object that yields hardly more than the arm itself cannot be told from a rigid one: then an open arrow shows that its stiffness is at least so large.&lt;/p&gt;&lt;p&gt;Sponge and rubber sponge are safe to touch; rubber, wood and metal are a danger.&lt;/p&gt;</source>
        <translation>&lt;p&gt;最近触碰的物体有多硬，采用对数刻度。圆点为估计值，穿过它的线段为刚度的 95 % 区间。&lt;/p&gt;&lt;p&gt;若物体的变形几乎不大于机械臂自身的变形，则无法与刚体区分：此时空心箭头表示其刚度至少有这么大。&lt;/p&gt;&lt;p&gt;海绵和橡胶海绵可安全触碰；橡胶、木材和金属有危险。&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Touch an object with the arm&apos;s skin: its stiffness appears here.</source>
        <translation>用机械臂的皮肤触碰物体：其刚度将显示在此处。</translation>
    </message>
    <message>
        <source>stiffness</source>
        <translation>刚度</translation>
    </message>
    <message>
        <source>&lt;p&gt;Below the word stands how long ago the touch was. After half a minute it is stale: the arm may be elsewhere by then.&lt;/p&gt;</source>
        <translation>&lt;p&gt;文字下方给出触摸是多久之前的事。超过半分钟即已过时：机械臂此时可能已在别处。&lt;/p&gt;</translation>
    </message>
</context>
<context>
    <name>teleta::touch::TouchModel</name>
    <message>
        <source>No force: the skin did not feel where the contact is.</source>
        <translation>无力值：皮肤未感觉到接触的位置。</translation>
    </message>
    <message>
        <source>%1: %2 ± %3 N</source>
        <translation>%1：%2 ± %3 N</translation>
    </message>
    <message>
        <source>%1: not observable in this configuration of the arm</source>
        <translation>%1：在机械臂的此构型下不可观测</translation>
    </message>
    <message>
        <source>condition number %1, unexplained torque %2 Nm</source>
        <translation>条件数 %1，未解释的力矩 %2 Nm</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message numerus="yes">
        <source>95 % interval in brackets; %1, %n sample(s)</source>
        <translation>
            <numerusform>括号内为 95 % 区间；%1，%n 个样本</numerusform>
        </translation>
    </message>
    <message>
        <source>No stiffness: the skin did not feel where the contact is.</source>
        <translation>无刚度：皮肤未感觉到接触的位置。</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1，%2</translation>
    </message>
    <message>
        <source>%1 (not certain), %2</source>
        <translation>%1（不确定），%2</translation>
    </message>
    <message>
        <source>First torque above the noise at %1 s, estimated %2 ms later; evaluated: %3</source>
        <translation>力矩于 %1 s 首次高于噪声，%2 ms 后得出估计；评估：%3</translation>
    </message>
    <message>
        <source>The skin did not feel this contact.</source>
        <translation>皮肤未感觉到此接触。</translation>
    </message>
    <message>
        <source>Condition number of the force: longest over shortest lever; large is bad</source>
        <translation>力的条件数：最长力臂与最短力臂之比；越大越差</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>序号</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>Contact x, y, z</source>
        <translation>接触 x、y、z</translation>
    </message>
    <message>
        <source>Along link</source>
        <translation>沿连杆</translation>
    </message>
    <message>
        <source>Force x, y, z</source>
        <translation>力 x、y、z</translation>
    </message>
    <message>
        <source>Stiffness</source>
        <translation>刚度</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>材料</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>等级</translation>
    </message>
    <message>
        <source>Condition</source>
        <translation>条件数</translation>
    </message>
    <message>
        <source>cannot tell</source>
        <translation>无法判断</translation>
    </message>
    <message>
        <source>Force at the contact; a dash marks what the arm cannot observe in this pose</source>
        <translation>接触处的力；短横线表示机械臂在当前构型下无法观测的量</translation>
    </message>
    <message>
        <source>x, y, z in the frame of the arm&apos;s base; the distance is from the joint that presses: along the forearm from the elbow</source>
        <translation>机械臂基座坐标系中的 x、y、z；距离从按压的关节算起：沿前臂从肘部起</translation>
    </message>
    <message>
        <source>Distance of the contact from the joint that presses: along the forearm from the elbow</source>
        <translation>接触点到按压关节的距离：沿前臂从肘部起</translation>
    </message>
</context>
<context>
    <name>teleta::touch::TouchTable</name>
    <message>
        <source>Recent touches</source>
        <translation>最近的触碰</translation>
    </message>
    <message>
        <source>&lt;p&gt;Every touch of the arm with what was found out about it. A ? in the force marks a component that the arm cannot observe in its configuration.&lt;/p&gt;&lt;p&gt;Click a title to sort. Ctrl+C copies the selected rows.&lt;/p&gt;</source>
        <translation>&lt;p&gt;机械臂的每次触碰及由此得到的信息。力中的 ? 表示机械臂在其构型下不可观测的分量。&lt;/p&gt;&lt;p&gt;单击标题可排序。Ctrl+C 复制所选的行。&lt;/p&gt;</translation>
    </message>
    <message>
        <source>No touch yet. Touch an object with the arm&apos;s skin.</source>
        <translation>尚无触碰。请用机械臂的皮肤触碰物体。</translation>
    </message>
    <message>
        <source>touches</source>
        <translation>触碰</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>复制(&amp;C)</translation>
    </message>
    <message numerus="yes">
        <source>%n touch(es)</source>
        <translation>
            <numerusform>%n 次触碰</numerusform>
        </translation>
    </message>
    <message>
        <source>Select &amp;all</source>
        <translation>全选(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Newest first</source>
        <translation>最新的在前(&amp;N)</translation>
    </message>
</context>
<context>
    <name>teleta::view3d::Scene3dView</name>
    <message>
        <source>touch 3-D</source>
        <translation>触碰 3D</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Flat array</source>
        <translation>平面阵列</translation>
    </message>
    <message>
        <source>Show the array flat, as it is</source>
        <translation>按原样平面显示阵列</translation>
    </message>
    <message>
        <source>Wrapped on the cylinder</source>
        <translation>包裹于圆柱</translation>
    </message>
    <message>
        <source>Wrap the array around the tactile cylinder</source>
        <translation>将阵列包裹在触觉圆柱上</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>前</translation>
    </message>
    <message>
        <source>Look from the front</source>
        <translation>从前方看</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>顶</translation>
    </message>
    <message>
        <source>Look from above</source>
        <translation>从上方看</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>侧</translation>
    </message>
    <message>
        <source>Look from the right</source>
        <translation>从右侧看</translation>
    </message>
    <message>
        <source>Isometric</source>
        <translation>等轴测</translation>
    </message>
    <message>
        <source>Look from a corner</source>
        <translation>从角上看</translation>
    </message>
    <message>
        <source>Follow contact</source>
        <translation>跟随接触</translation>
    </message>
    <message>
        <source>Orthographic</source>
        <translation>正交</translation>
    </message>
    <message>
        <source>Parallel lines stay parallel: no perspective</source>
        <translation>平行线保持平行：无透视</translation>
    </message>
    <message>
        <source>Copy picture</source>
        <translation>复制图片</translation>
    </message>
    <message>
        <source>Copy the picture</source>
        <translation>复制此图片</translation>
    </message>
    <message>
        <source>Export geometry…</source>
        <translation>导出几何数据…</translation>
    </message>
    <message>
        <source>Save the scene for other programs: VTP, PLY, STL</source>
        <translation>为其他程序保存场景：VTP、PLY、STL</translation>
    </message>
    <message>
        <source>3-D view</source>
        <translation>3D 视图</translation>
    </message>
    <message>
        <source>Touch in 3-D</source>
        <translation>三维触碰</translation>
    </message>
    <message>
        <source>The tactile array with its loads as heights and colours, contacts with force arrows, the arm and the explored contour. Drag with the left button to turn, with the middle button to move, turn the wheel to zoom.</source>
        <translation>触觉阵列，以高度和颜色表示载荷，以及带力箭头的接触、机械臂和已探索的轮廓。按住左键拖动可旋转，按住中键拖动可平移，滚轮缩放。</translation>
    </message>
    <message>
        <source>No touch to show yet.</source>
        <translation>尚无可显示的触碰。</translation>
    </message>
    <message>
        <source>Export geometry (in mm)</source>
        <translation>导出几何数据（单位 mm）</translation>
    </message>
    <message>
        <source>VTK, with colours and lines (*.vtp)</source>
        <translation>VTK，含颜色和线条 (*.vtp)</translation>
    </message>
    <message>
        <source>Triangles with colours (*.ply)</source>
        <translation>带颜色的三角面 (*.ply)</translation>
    </message>
    <message>
        <source>Triangles (*.stl)</source>
        <translation>三角面 (*.stl)</translation>
    </message>
    <message>
        <source>Keep the strongest contact in the middle, or the arm&apos;s hand while nothing is touched</source>
        <translation>使最强的接触保持在中央；未接触时则为机械臂的手部</translation>
    </message>
    <message>
        <source>From the hand</source>
        <translation>从手上看</translation>
    </message>
    <message>
        <source>Look along with the tactile array: the camera moves and turns with the hand that carries it</source>
        <translation>随触觉阵列一起看：相机随携带它的手移动和转动</translation>
    </message>
    <message>
        <source>Initial view</source>
        <translation>初始视图</translation>
    </message>
    <message>
        <source>Back to the view of the beginning, from a corner</source>
        <translation>回到开始时的视图，从一角观看</translation>
    </message>
</context>
<context>
    <name>teleta::view3d::SceneLayers</name>
    <message>
        <source>Grid</source>
        <translation>网格</translation>
    </message>
    <message>
        <source>Show the ground with a grid in millimetres</source>
        <translation>显示带毫米网格的地面</translation>
    </message>
    <message>
        <source>Axes</source>
        <translation>坐标轴</translation>
    </message>
    <message>
        <source>Show the axes of the array&apos;s frame</source>
        <translation>显示阵列坐标系的坐标轴</translation>
    </message>
    <message>
        <source>Displacement</source>
        <translation>位移</translation>
    </message>
    <message>
        <source>Show how far each contact moved since it began</source>
        <translation>显示各接触自开始以来移动了多远</translation>
    </message>
    <message>
        <source>Contact labels</source>
        <translation>接触标签</translation>
    </message>
    <message>
        <source>Show number and force at each contact</source>
        <translation>显示各接触的编号和力</translation>
    </message>
    <message>
        <source>Trail of the tip</source>
        <translation>末端轨迹</translation>
    </message>
    <message>
        <source>Show where the arm&apos;s tip was in the last 5 s</source>
        <translation>显示机械臂末端在最近 5 秒内的位置</translation>
    </message>
    <message>
        <source>Joint limits</source>
        <translation>关节限位</translation>
    </message>
    <message>
        <source>Show range and angle of each joint that is near the end of its range</source>
        <translation>显示每个接近范围末端的关节的范围和角度</translation>
    </message>
    <message>
        <source>Forces</source>
        <translation>力</translation>
    </message>
    <message>
        <source>Show forces as arrows</source>
        <translation>用箭头显示力</translation>
    </message>
    <message>
        <source>Moments</source>
        <translation>力矩</translation>
    </message>
    <message>
        <source>Show the moment of the loads on a flat array about their centre, as an arrow that turns</source>
        <translation>用弯箭头显示平面阵列上的载荷绕其中心的力矩</translation>
    </message>
    <message>
        <source>Objects of the scene</source>
        <translation>场景中的物体</translation>
    </message>
    <message>
        <source>Show what a simulated scene has around the arm</source>
        <translation>显示仿真场景中机械臂周围的物体</translation>
    </message>
</context>
<context>
    <name>teleta::view3d::VtkWidget</name>
    <message>
        <source>The 3-D view is not available. %1
All other views work without it.</source>
        <translation>此处没有 3D 视图。%1
所有其他视图不受影响。</translation>
    </message>
</context>
<context>
    <name>view3d</name>
    <message>
        <source>a file name that ends in .vtp, .ply or .stl</source>
        <translation>以 .vtp、.ply 或 .stl 结尾的文件名</translation>
    </message>
    <message>
        <source>The scene is empty: there is nothing to write.</source>
        <translation>场景为空：没有可写出的内容。</translation>
    </message>
    <message>
        <source>nothing was written</source>
        <translation>未写出任何内容</translation>
    </message>
    <message>
        <source>The geometry could not be written: %1</source>
        <translation>无法写出几何数据：%1</translation>
    </message>
    <message>
        <source>The display platform &quot;%1&quot; has no OpenGL widgets.</source>
        <translation>显示平台“%1”不支持 OpenGL 部件。</translation>
    </message>
    <message>
        <source>This display refused an OpenGL context.</source>
        <translation>此显示器拒绝了 OpenGL 上下文。</translation>
    </message>
    <message>
        <source>The OpenGL driver of this display does not work with VTK.</source>
        <translation>此显示器的 OpenGL 驱动程序无法与 VTK 配合工作。</translation>
    </message>
    <message>
        <source>Geometry cannot be written in this format.</source>
        <translation>这不是可写出的几何数据格式。</translation>
    </message>
    <message>
        <source>This display does not support OpenGL %1.%2 or newer.</source>
        <translation>此显示器不提供 OpenGL %1.%2 或更新版本。</translation>
    </message>
</context>
</TS>
