<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="zh_CN" sourcelanguage="en">
<context>
    <name>Actions</name>
    <message>
        <source>&amp;File</source>
        <translation>文件(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>编辑(&amp;E)</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>视图(&amp;V)</translation>
    </message>
    <message>
        <source>&amp;Play</source>
        <translation>播放(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Compare</source>
        <translation>比较(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>帮助(&amp;H)</translation>
    </message>
    <message>
        <source>&amp;New</source>
        <translation>新建(&amp;N)</translation>
    </message>
    <message>
        <source>New &amp;window</source>
        <translation>新建窗口(&amp;W)</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>打开(&amp;O)…</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>保存(&amp;S)</translation>
    </message>
    <message>
        <source>Save &amp;as…</source>
        <translation>另存为(&amp;A)…</translation>
    </message>
    <message>
        <source>Save to the &amp;library…</source>
        <translation>保存到预设库(&amp;L)…</translation>
    </message>
    <message>
        <source>&amp;Revert</source>
        <translation>还原(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>导出(&amp;E)…</translation>
    </message>
    <message>
        <source>Export a&amp;gain</source>
        <translation>再次导出(&amp;G)</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>关闭(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>退出(&amp;Q)</translation>
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
        <source>&amp;Copy the preset as JSON</source>
        <translation>将预设复制为 JSON(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Paste a preset</source>
        <translation>粘贴预设(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Variations…</source>
        <translation>变体(&amp;V)…</translation>
    </message>
    <message>
        <source>Randomise s&amp;lightly</source>
        <translation>稍作随机(&amp;L)</translation>
    </message>
    <message>
        <source>Reset &amp;all parameters</source>
        <translation>重置所有参数(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Search parameters</source>
        <translation>搜索参数(&amp;S)</translation>
    </message>
    <message>
        <source>Search c&amp;ommands…</source>
        <translation>搜索命令(&amp;O)…</translation>
    </message>
    <message>
        <source>Frame &amp;all</source>
        <translation>显示全部(&amp;A)</translation>
    </message>
    <message>
        <source>From the &amp;front</source>
        <translation>前视图(&amp;F)</translation>
    </message>
    <message>
        <source>From the &amp;right</source>
        <translation>右视图(&amp;R)</translation>
    </message>
    <message>
        <source>From &amp;above</source>
        <translation>顶视图(&amp;A)</translation>
    </message>
    <message>
        <source>Ground &amp;grid</source>
        <translation>地面网格(&amp;G)</translation>
    </message>
    <message>
        <source>&amp;Emitter outline</source>
        <translation>发射器轮廓(&amp;E)</translation>
    </message>
    <message>
        <source>Gi&amp;zmos</source>
        <translation>操纵器(&amp;Z)</translation>
    </message>
    <message>
        <source>E&amp;xport frame</source>
        <translation>导出画框(&amp;X)</translation>
    </message>
    <message>
        <source>Rea&amp;dout</source>
        <translation>读数(&amp;D)</translation>
    </message>
    <message>
        <source>&amp;Checkerboard</source>
        <translation>烟雾后的棋盘格(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Backdrop colour…</source>
        <translation>背景颜色(&amp;B)…</translation>
    </message>
    <message>
        <source>F&amp;ull screen</source>
        <translation>全屏(&amp;U)</translation>
    </message>
    <message>
        <source>Reset &amp;layout</source>
        <translation>重置布局(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Play or pause</source>
        <translation>播放或暂停(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Next frame</source>
        <translation>前进一帧(&amp;O)</translation>
    </message>
    <message>
        <source>&amp;Previous frame</source>
        <translation>后退一帧(&amp;B)</translation>
    </message>
    <message>
        <source>Go to &amp;start</source>
        <translation>到第一帧(&amp;F)</translation>
    </message>
    <message>
        <source>Go to &amp;end</source>
        <translation>到最后一帧(&amp;L)</translation>
    </message>
    <message>
        <source>Set &amp;in point</source>
        <translation>区间从这里开始(&amp;H)</translation>
    </message>
    <message>
        <source>Set &amp;out point</source>
        <translation>区间到这里结束(&amp;E)</translation>
    </message>
    <message>
        <source>&amp;Whole range</source>
        <translation>整个区间(&amp;W)</translation>
    </message>
    <message>
        <source>&amp;Store as B</source>
        <translation>记为 B(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Split view of A and B</source>
        <translation>A 与 B 分屏(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Replace A with B</source>
        <translation>采用 B(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Keyboard shortcuts</source>
        <translation>键盘快捷键(&amp;K)</translation>
    </message>
    <message>
        <source>&amp;About Fumage</source>
        <translation>关于 Fumage(&amp;A)</translation>
    </message>
    <message>
        <source>From the bac&amp;k</source>
        <translation>后视图(&amp;K)</translation>
    </message>
    <message>
        <source>From the &amp;left</source>
        <translation>左视图(&amp;L)</translation>
    </message>
    <message>
        <source>From &amp;below</source>
        <translation>底视图(&amp;B)</translation>
    </message>
    <message>
        <source>Show &amp;B (hold the key to look for a moment)</source>
        <translation>显示 B（按住可暂时查看）(&amp;B)</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>打开最近的文件(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Panels</source>
        <translation>面板(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Navigation style</source>
        <translation>鼠标习惯(&amp;M)</translation>
    </message>
    <message>
        <source>Lan&amp;guage</source>
        <translation>语言(&amp;G)</translation>
    </message>
    <message>
        <source>T&amp;heme</source>
        <translation>主题(&amp;H)</translation>
    </message>
    <message>
        <source>Frame the &amp;whole animation</source>
        <translation>显示整个动画(&amp;W)</translation>
    </message>
    <message>
        <source>&amp;Hide panels</source>
        <translation>只显示烟雾(&amp;O)</translation>
    </message>
    <message>
        <source>A&amp;ir</source>
        <translation>空气(&amp;I)</translation>
    </message>
    <message>
        <source>New from a p&amp;reset…</source>
        <translation>从预设新建(&amp;R)…</translation>
    </message>
    <message>
        <source>Pre&amp;ferences…</source>
        <translation>首选项(&amp;F)…</translation>
    </message>
    <message>
        <source>Pre&amp;vious view</source>
        <translation>上一个视图(&amp;V)</translation>
    </message>
    <message>
        <source>&amp;Next view</source>
        <translation>下一个视图(&amp;N)</translation>
    </message>
    <message>
        <source>Reset the ca&amp;mera</source>
        <translation>重置相机(&amp;M)</translation>
    </message>
    <message>
        <source>Cop&amp;y the picture</source>
        <translation>复制画面(&amp;Y)</translation>
    </message>
    <message>
        <source>Particle pa&amp;ths</source>
        <translation>粒子路径(&amp;T)</translation>
    </message>
    <message>
        <source>Cu&amp;t the layers</source>
        <translation>剪切图层(&amp;T)</translation>
    </message>
    <message>
        <source>C&amp;opy the layers</source>
        <translation>复制图层到剪贴板(&amp;O)</translation>
    </message>
    <message>
        <source>Past&amp;e layers</source>
        <translation>粘贴图层(&amp;E)</translation>
    </message>
    <message>
        <source>Paste para&amp;meters…</source>
        <translation>粘贴参数(&amp;M)…</translation>
    </message>
    <message>
        <source>&amp;Duplicate the layers</source>
        <translation>创建图层副本(&amp;D)</translation>
    </message>
    <message>
        <source>Delete the la&amp;yers</source>
        <translation>删除图层(&amp;Y)</translation>
    </message>
    <message>
        <source>End s&amp;olo</source>
        <translation>结束独显(&amp;O)</translation>
    </message>
    <message>
        <source>Previous &amp;key frame</source>
        <translation>上一个关键帧(&amp;K)</translation>
    </message>
    <message>
        <source>Next ke&amp;y frame</source>
        <translation>下一个关键帧(&amp;Y)</translation>
    </message>
    <message>
        <source>&amp;Auto-key: each edit sets a key frame</source>
        <translation>自动关键帧：每次编辑都设置关键帧(&amp;A)</translation>
    </message>
    <message>
        <source>Add a &amp;marker</source>
        <translation>添加标记(&amp;M)</translation>
    </message>
    <message>
        <source>Pre&amp;vious marker</source>
        <translation>上一个标记(&amp;V)</translation>
    </message>
    <message>
        <source>Ne&amp;xt marker</source>
        <translation>下一个标记(&amp;X)</translation>
    </message>
    <message>
        <source>&amp;Graph of key frames</source>
        <translation>关键帧曲线图(&amp;G)</translation>
    </message>
    <message>
        <source>&amp;Manual</source>
        <translation>手册(&amp;M)</translation>
    </message>
    <message>
        <source>&amp;Tour</source>
        <translation>导览(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Into my engine…</source>
        <translation>导入我的引擎(&amp;I)…</translation>
    </message>
    <message>
        <source>Frame the animation without outlier&amp;s</source>
        <translation>显示动画，忽略离群(&amp;S)</translation>
    </message>
</context>
<context>
    <name>fumage::ui::CameraFit</name>
    <message>
        <source>Looking for smoke in all frames: %1 %</source>
        <translation>正在所有帧中查找烟雾：%1 %</translation>
    </message>
    <message>
        <source>The camera shows all smoke of the animation</source>
        <translation>摄像机已显示动画中的全部烟雾</translation>
    </message>
    <message>
        <source>The camera shows the smoke of the animation without outliers</source>
        <translation>摄像机显示动画中的烟雾，忽略离群部分</translation>
    </message>
</context>
<context>
    <name>fumage::ui::ColourEditor</name>
    <message>
        <source>swatch</source>
        <translation>色块</translation>
    </message>
</context>
<context>
    <name>fumage::ui::CommandSearch</name>
    <message>
        <source>Search commands</source>
        <translation>搜索命令</translation>
    </message>
    <message>
        <source>Commands</source>
        <translation>命令</translation>
    </message>
    <message>
        <source>A command, a choice, a parameter or a preset</source>
        <translation>命令、选项、参数或预设</translation>
    </message>
    <message>
        <source>Preset: %1</source>
        <translation>预设：%1</translation>
    </message>
    <message>
        <source>No results for “%1”. Try a part of a word, or another word.</source>
        <translation>没有找到“%1”。请试试词的一部分或另一个词。</translation>
    </message>
    <message>
        <source>Presets</source>
        <translation>预设</translation>
    </message>
</context>
<context>
    <name>fumage::ui::Comparison</name>
    <message>
        <source>Replace A with B</source>
        <translation>采用 B</translation>
    </message>
</context>
<context>
    <name>fumage::ui::CurveEditor</name>
    <message>
        <source>Click to add, drag to move, Delete or right click to remove</source>
        <translation>按下添加，拖动移动，按 Delete 或右键删除</translation>
    </message>
</context>
<context>
    <name>fumage::ui::DataChoices</name>
    <message>
        <source>Size of the noise texture</source>
        <translation>噪声纹理的大小</translation>
    </message>
    <message>
        <source>as in the effect</source>
        <translation>与效果相同</translation>
    </message>
    <message>
        <source> pixels</source>
        <translation> 像素</translation>
    </message>
    <message>
        <source>Axis that points up</source>
        <translation>朝上的轴</translation>
    </message>
    <message>
        <source>As usual for the format</source>
        <translation>按格式惯例</translation>
    </message>
    <message>
        <source>y, as in Houdini and Maya</source>
        <translation>y 轴，如 Houdini 和 Maya</translation>
    </message>
    <message>
        <source>z, as in Blender</source>
        <translation>z 轴，如 Blender</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>大小</translation>
    </message>
    <message>
        <source>Voxels along the longest edge of the smoke of the whole timeline</source>
        <translation>整个时间轴的烟沿最长边的体素数</translation>
    </message>
    <message>
        <source>Frame rate</source>
        <translation>帧率</translation>
    </message>
    <message>
        <source>Repeat</source>
        <translation>重复</translation>
    </message>
    <message>
        <source>Voxels</source>
        <translation>体素数</translation>
    </message>
    <message>
        <source>Voxel size</source>
        <translation>体素大小</translation>
    </message>
    <message>
        <source>Up axis</source>
        <translation>向上轴</translation>
    </message>
    <message>
        <source>Frames a second at which the video plays; the frames stay the same</source>
        <translation>视频每秒播放的帧数；各帧保持不变</translation>
    </message>
    <message>
        <source>As the timeline</source>
        <translation>与时间轴相同</translation>
    </message>
    <message>
        <source>For ever if the frames close a loop</source>
        <translation>若各帧构成循环则一直重复</translation>
    </message>
    <message>
        <source>Once</source>
        <translation>一次</translation>
    </message>
    <message>
        <source>For ever</source>
        <translation>一直重复</translation>
    </message>
    <message>
        <source>Edge of a voxel; all frames have the same</source>
        <translation>体素的边长；所有帧都相同</translation>
    </message>
    <message>
        <source> m</source>
        <translation> m</translation>
    </message>
    <message>
        <source>by their number</source>
        <translation>按体素数</translation>
    </message>
    <message>
        <source>Density</source>
        <translation>密度</translation>
    </message>
    <message>
        <source>One grid of all layers, or one of each, which add up to it</source>
        <translation>所有图层一个网格，或每层一个，合计相同</translation>
    </message>
    <message>
        <source>Of all layers</source>
        <translation>所有图层</translation>
    </message>
    <message>
        <source>A grid a layer</source>
        <translation>每层一个网格</translation>
    </message>
</context>
<context>
    <name>fumage::ui::DirectionEditor</name>
    <message>
        <source>Yaw</source>
        <translation>偏航</translation>
    </message>
    <message>
        <source>Pitch</source>
        <translation>俯仰</translation>
    </message>
</context>
<context>
    <name>fumage::ui::Docks</name>
    <message>
        <source>Presets</source>
        <translation>预设</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>参数</translation>
    </message>
    <message>
        <source>Noise</source>
        <translation>噪声</translation>
    </message>
    <message>
        <source>History</source>
        <translation>历史</translation>
    </message>
    <message>
        <source>Variations</source>
        <translation>变体</translation>
    </message>
    <message>
        <source>Exports</source>
        <translation>导出</translation>
    </message>
</context>
<context>
    <name>fumage::ui::Document</name>
    <message>
        <source>Untitled</source>
        <translation>未命名</translation>
    </message>
    <message>
        <source>Reset %1</source>
        <translation>重置 %1</translation>
    </message>
    <message>
        <source>Unsaved work</source>
        <translation>未保存的工作</translation>
    </message>
    <message>
        <source>Reload</source>
        <translation>重新加载</translation>
    </message>
    <message>
        <source>Move the camera</source>
        <translation>移动摄像机</translation>
    </message>
    <message>
        <source>Key %1</source>
        <translation>为%1设置关键帧</translation>
    </message>
</context>
<context>
    <name>fumage::ui::DocumentFiles</name>
    <message>
        <source>Presets (*.json)</source>
        <translation>预设 (*.json)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>所有文件 (*)</translation>
    </message>
    <message>
        <source>Opened with changes</source>
        <translation>打开时作了修改</translation>
    </message>
    <message>
        <source>“%1” was opened, but some of it had to be put right.</source>
        <translation>“%1”已打开，但其中一些内容需要修正。</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>未保存的更改</translation>
    </message>
    <message>
        <source>Save the changes to “%1”?</source>
        <translation>要保存对“%1”的更改吗？</translation>
    </message>
    <message>
        <source>Your changes will be lost if you don&apos;t save them.</source>
        <translation>如果不保存，这些更改将会丢失。</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>打开</translation>
    </message>
    <message>
        <source>Cannot open “%1”</source>
        <translation>无法打开“%1”</translation>
    </message>
    <message>
        <source>Cannot save “%1”</source>
        <translation>无法保存“%1”</translation>
    </message>
    <message>
        <source>Save as</source>
        <translation>另存为</translation>
    </message>
    <message>
        <source>Save to the library</source>
        <translation>保存到预设库</translation>
    </message>
    <message>
        <source>Name of the preset</source>
        <translation>预设名称</translation>
    </message>
    <message>
        <source>There is a preset “%1” already. Replace it?</source>
        <translation>预设“%1”已存在。要替换它吗？</translation>
    </message>
    <message>
        <source>Revert</source>
        <translation>还原</translation>
    </message>
    <message>
        <source>Cannot paste a preset</source>
        <translation>无法粘贴预设</translation>
    </message>
    <message>
        <source>Paste a preset</source>
        <translation>粘贴预设</translation>
    </message>
    <message>
        <source>The clipboard</source>
        <translation>剪贴板</translation>
    </message>
    <message>
        <source>Presets, and pictures that carry one (*.json *.png *.exr)</source>
        <translation>预设，以及携带预设的图片 (*.json *.png *.exr)</translation>
    </message>
    <message>
        <source>Changed by another program</source>
        <translation>已被其他程序更改</translation>
    </message>
    <message>
        <source>“%1” has been changed by another program since it was opened or saved here. If you overwrite it, those changes are lost.</source>
        <translation>“%1”自在此打开或保存以来已被其他程序更改。如果覆盖，这些更改将会丢失。</translation>
    </message>
    <message>
        <source>Save as…</source>
        <translation>另存为…</translation>
    </message>
    <message>
        <source>Overwrite</source>
        <translation>覆盖</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
</context>
<context>
    <name>fumage::ui::EditActions</name>
    <message>
        <source>Reset all parameters</source>
        <translation>重置所有参数</translation>
    </message>
    <message>
        <source>&amp;Undo %1</source>
        <translation>撤销 %1(&amp;U)</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>撤销(&amp;U)</translation>
    </message>
    <message>
        <source>&amp;Redo %1</source>
        <translation>重做 %1(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>重做(&amp;R)</translation>
    </message>
    <message>
        <source>Randomise slightly</source>
        <translation>稍作随机</translation>
    </message>
</context>
<context>
    <name>fumage::ui::EffectPanel</name>
    <message>
        <source>Search parameters</source>
        <translation>搜索参数</translation>
    </message>
    <message>
        <source>Only the parameters that differ from the preset</source>
        <translation>只显示与预设不同的参数</translation>
    </message>
    <message>
        <source>Essentials</source>
        <translation>常用</translation>
    </message>
    <message>
        <source>Nothing differs from the preset.</source>
        <translation>与预设没有不同。</translation>
    </message>
    <message>
        <source>No parameter matches “%1”. Try a part of a word, or another word.</source>
        <translation>没有参数与“%1”匹配。请试试词的一部分或另一个词。</translation>
    </message>
    <message>
        <source>Parameters of</source>
        <translation>参数属于</translation>
    </message>
    <message>
        <source>Scene</source>
        <translation>场景</translation>
    </message>
    <message>
        <source>Only the parameters that have key frames</source>
        <translation>仅显示有关键帧的参数</translation>
    </message>
    <message>
        <source>Nothing has key frames: the diamond beside a parameter sets one.</source>
        <translation>没有任何关键帧：参数旁的菱形可设置一个。</translation>
    </message>
    <message>
        <source>Nothing that has key frames differs from the preset.</source>
        <translation>有关键帧的参数都与预设相同。</translation>
    </message>
</context>
<context>
    <name>fumage::ui::EmissionStrip</name>
    <message>
        <source>Emission of the layers</source>
        <translation>图层的发射</translation>
    </message>
    <message>
        <source>Emission of %1</source>
        <translation>%1的发射</translation>
    </message>
</context>
<context>
    <name>fumage::ui::EngineDialog</name>
    <message>
        <source>Another engine</source>
        <translation>其他引擎</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Show in folder</source>
        <translation>在文件夹中显示</translation>
    </message>
    <message>
        <source>Copy the path</source>
        <translation>复制路径</translation>
    </message>
    <message>
        <source>Into my engine</source>
        <translation>导入我的引擎</translation>
    </message>
    <message>
        <source>Choose an engine: a sheet with all that it needs is written, with the settings that suit it.</source>
        <translation>选择引擎：将以适合它的设置写出序列图及其所需的一切。</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>文件夹</translation>
    </message>
    <message>
        <source>Size of the sheet</source>
        <translation>序列图大小</translation>
    </message>
    <message>
        <source>%1 pixels at most</source>
        <translation>最多 %1 像素</translation>
    </message>
    <message>
        <source>The longer side of the sheet. Cells of the document that are larger are made smaller</source>
        <translation>序列图的长边。文档中更大的单元格会被缩小</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>选择…</translation>
    </message>
    <message>
        <source>Sheet</source>
        <translation>序列图</translation>
    </message>
    <message>
        <source>Export for %1</source>
        <translation>为 %1 导出</translation>
    </message>
    <message>
        <source>Sky</source>
        <translation>天空</translation>
    </message>
    <message>
        <source>Day</source>
        <translation>白天</translation>
    </message>
    <message>
        <source>Evening</source>
        <translation>傍晚</translation>
    </message>
    <message>
        <source>Night</source>
        <translation>夜晚</translation>
    </message>
    <message>
        <source>More options…</source>
        <translation>更多选项…</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>Folder for the engine</source>
        <translation>引擎的文件夹</translation>
    </message>
    <message>
        <source>Size of cells</source>
        <translation>单元格大小</translation>
    </message>
    <message>
        <source>%1 for %2</source>
        <translation>%1（用于 %2）</translation>
    </message>
    <message>
        <source>The sheet is being rendered…</source>
        <translation>正在渲染序列图…</translation>
    </message>
    <message>
        <source>The sheet is being read…</source>
        <translation>正在读取序列图…</translation>
    </message>
</context>
<context>
    <name>Engines</name>
    <message>
        <source>Any engine</source>
        <translation>任意引擎</translation>
    </message>
    <message>
        <source>Web page</source>
        <translation>网页</translation>
    </message>
    <message>
        <source>Put the folder %1 into Assets of your project, if it is not there.</source>
        <translation>如果文件夹 %1 还不在那里，把它放进项目的 Assets。</translation>
    </message>
    <message>
        <source>Let Unity import it: the script in the folder Editor gives each texture its settings.</source>
        <translation>让 Unity 导入：Editor 文件夹中的脚本会为每个纹理设置导入选项。</translation>
    </message>
    <message>
        <source>Choose Assets, Fumage, %1: it makes a particle system that plays the sheet, and a prefab of it.</source>
        <translation>选择 Assets、Fumage、%1：它会创建播放序列图的粒子系统及其预制件。</translation>
    </message>
    <message>
        <source>In Unreal switch on the Python Editor Script Plugin.</source>
        <translation>在 Unreal 中启用 Python Editor Script Plugin。</translation>
    </message>
    <message>
        <source>Choose Tools, Execute Python Script, and the script in %1: the textures are then in /Game/Fumage, with the right settings.</source>
        <translation>选择 Tools、Execute Python Script，再选 %1 中的脚本：纹理随后位于 /Game/Fumage，设置正确。</translation>
    </message>
    <message>
        <source>Use FlipBook_MotionVectors in a material, with the numbers that the log says, and the material in a Niagara sprite emitter.</source>
        <translation>在材质中使用 FlipBook_MotionVectors 并填入日志给出的数值，再把该材质用于 Niagara 精灵发射器。</translation>
    </message>
    <message>
        <source>Put the folder %1 into your project, if it is not there.</source>
        <translation>如果文件夹 %1 还不在那里，把它放进你的项目。</translation>
    </message>
    <message>
        <source>Let Godot import the textures: the .import files beside them say how.</source>
        <translation>让 Godot 导入纹理：旁边的 .import 文件说明了方式。</translation>
    </message>
    <message>
        <source>Drag the scene %1 into yours. Its shader blends the cells.</source>
        <translation>把场景 %1 拖进你的场景。它的着色器会混合各单元格。</translation>
    </message>
    <message>
        <source>Open %1 in a browser: it plays the sheet by itself.</source>
        <translation>在浏览器中打开 %1：它会自动播放序列图。</translation>
    </message>
    <message>
        <source>Put the file on your server: the pictures are in it.</source>
        <translation>把文件放到你的服务器上：图片就在其中。</translation>
    </message>
    <message>
        <source>Show it in an iframe, or copy its script into your page.</source>
        <translation>用 iframe 显示，或把其中的脚本复制到你的网页。</translation>
    </message>
    <message>
        <source>Open %1 in Effekseer.</source>
        <translation>在 Effekseer 中打开 %1。</translation>
    </message>
    <message>
        <source>Press Play: the node has the texture, the cells and their speed.</source>
        <translation>按播放：节点已有纹理、单元格及其速度。</translation>
    </message>
    <message>
        <source>Export it for your game, with the pictures beside it.</source>
        <translation>为你的游戏导出，并把图片放在旁边。</translation>
    </message>
    <message>
        <source>Take the pictures in %1 into your project.</source>
        <translation>把 %1 中的图片放进你的项目。</translation>
    </message>
    <message>
        <source>Import the colours as sRGB, and light maps and motion vectors as numbers, not colours.</source>
        <translation>颜色以 sRGB 导入，光照贴图和运动矢量作为数值而非颜色导入。</translation>
    </message>
    <message>
        <source>Play the cells as %1 says.</source>
        <translation>按 %1 的说明播放单元格。</translation>
    </message>
</context>
<context>
    <name>fumage::ui::ExportCheck</name>
    <message>
        <source>%1 is missing</source>
        <translation>%1 缺失</translation>
    </message>
    <message>
        <source>%1 is different</source>
        <translation>%1 已改变</translation>
    </message>
    <message>
        <source>%1 is broken</source>
        <translation>%1 已损坏</translation>
    </message>
    <message>
        <source>the manifest says two things of %1</source>
        <translation>清单对 %1 的记录自相矛盾</translation>
    </message>
    <message>
        <source>%1 is not in the manifest</source>
        <translation>%1 不在清单中</translation>
    </message>
    <message>
        <source>Verified: the file is as it was written</source>
        <translation>已校验：文件与写出时一致</translation>
    </message>
    <message>
        <source>Verified: %1 files are as they were written</source>
        <translation>已校验：%1 个文件与写出时一致</translation>
    </message>
    <message>
        <source>%1 more</source>
        <translation>另有 %1 个</translation>
    </message>
    <message>
        <source>1 of %1 files is not as it was written: %2</source>
        <translation>%1 个文件中有 1 个与写出时不同：%2</translation>
    </message>
    <message>
        <source>%1 of %2 files are not as they were written: %3</source>
        <translation>%2 个文件中有 %1 个与写出时不同：%3</translation>
    </message>
    <message>
        <source>Verifying…</source>
        <translation>正在校验…</translation>
    </message>
    <message>
        <source>Verifying: %1 of %2</source>
        <translation>正在校验：%1 / %2</translation>
    </message>
    <message>
        <source>%1 is not a file</source>
        <translation>%1 不是文件</translation>
    </message>
    <message>
        <source>%1 cannot be read</source>
        <translation>%1 无法读取</translation>
    </message>
</context>
<context>
    <name>fumage::ui::ExportController</name>
    <message>
        <source>The queue of exports cannot be kept safe: %1</source>
        <translation>无法妥善保存导出队列：%1</translation>
    </message>
    <message>
        <source>Exporting “%1”: %2</source>
        <translation>正在导出“%1”：%2</translation>
    </message>
    <message>
        <source>Exported %1</source>
        <translation>已导出 %1</translation>
    </message>
    <message>
        <source>Export cancelled</source>
        <translation>导出已取消</translation>
    </message>
    <message>
        <source>Export failed: %1</source>
        <translation>导出失败：%1</translation>
    </message>
</context>
<context>
    <name>fumage::ui::ExportDialog</name>
    <message>
        <source>Export</source>
        <translation>导出</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Show in folder</source>
        <translation>在文件夹中显示</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>格式</translation>
    </message>
    <message>
        <source>File</source>
        <translation>文件</translation>
    </message>
    <message>
        <source>A run of # becomes the number of the frame</source>
        <translation>一串 # 会变成帧号</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>选择…</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>帧</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>Export to</source>
        <translation>导出到</translation>
    </message>
    <message>
        <source>Size of cells</source>
        <translation>单元格大小</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>类型</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>帧</translation>
    </message>
</context>
<context>
    <name>fumage::ui::ExportProgress</name>
    <message>
        <source>Done: %1</source>
        <translation>完成：%1</translation>
    </message>
    <message>
        <source>Fit the camera</source>
        <translation>让摄像机适应烟雾</translation>
    </message>
    <message>
        <source>Exports again, from where all smoke is seen</source>
        <translation>从能看到全部烟的位置重新导出</translation>
    </message>
</context>
<context>
    <name>fumage::ui::ExportQueue</name>
    <message>
        <source>%1 of %2</source>
        <translation>%1 / %2</translation>
    </message>
    <message>
        <source>%1, %2 s left</source>
        <translation>%1，剩余 %2 秒</translation>
    </message>
</context>
<context>
    <name>fumage::ui::ExportWorker</name>
    <message>
        <source>Baking the air: %1 %</source>
        <translation>正在烘焙空气：%1 %</translation>
    </message>
    <message>
        <source>Looking where the smoke is: %1 %</source>
        <translation>正在查找烟雾的位置：%1 %</translation>
    </message>
    <message>
        <source>Simulating what comes before: %1 %</source>
        <translation>正在模拟之前的部分：%1 %</translation>
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
        <source>top</source>
        <translation>上</translation>
    </message>
    <message>
        <source>bottom</source>
        <translation>下</translation>
    </message>
    <message>
        <source>The smoke is cut off at the edge of cells (%1) in frames %2 to %3. Fit the camera, or move it back to %4 m.</source>
        <translation>第 %2 至 %3 帧的烟雾在单元格边缘（%1）被截断。请让摄像机适应烟雾，或将其后移至 %4 米。</translation>
    </message>
    <message>
        <source>The smoke is cut off at the edge of cells (%1) in frames %2 to %3. Fit the camera.</source>
        <translation>第 %2 至 %3 帧的烟雾在单元格边缘（%1）被截断。请让摄像机适应烟雾。</translation>
    </message>
    <message>
        <source>Outliers are cut off at the edge of cells (%1) in frames %2 to %3.</source>
        <translation>离群部分在第 %2 至 %3 帧的单元格边缘（%1）被裁掉。</translation>
    </message>
</context>
<context>
    <name>Exports</name>
    <message>
        <source>Image sequence</source>
        <translation>图像序列</translation>
    </message>
    <message>
        <source>Flipbook</source>
        <translation>序列帧图集</translation>
    </message>
    <message>
        <source>Video</source>
        <translation>视频</translation>
    </message>
    <message>
        <source>Single picture</source>
        <translation>单张图像</translation>
    </message>
    <message>
        <source>Noise texture</source>
        <translation>噪声纹理</translation>
    </message>
    <message>
        <source>Particles</source>
        <translation>粒子</translation>
    </message>
    <message>
        <source>Volumes</source>
        <translation>体积</translation>
    </message>
    <message>
        <source>Air as a vector field</source>
        <translation>空气矢量场</translation>
    </message>
    <message>
        <source>CSV, one particle a line</source>
        <translation>CSV，每行一个粒子</translation>
    </message>
    <message>
        <source>PLY, binary points</source>
        <translation>PLY，二进制点</translation>
    </message>
    <message>
        <source>Point cache for Unity, binary</source>
        <translation>Unity 点缓存，二进制</translation>
    </message>
    <message>
        <source>OpenVDB, half floats</source>
        <translation>OpenVDB，半精度浮点</translation>
    </message>
    <message>
        <source>FGA for Unreal</source>
        <translation>Unreal 用 FGA</translation>
    </message>
    <message>
        <source>Volume File for Unity</source>
        <translation>Unity 用 Volume File</translation>
    </message>
    <message>
        <source>MP4 (H.264), on the background colour</source>
        <translation>MP4 (H.264)，以背景色为底</translation>
    </message>
    <message>
        <source>WebM (VP9), transparent</source>
        <translation>WebM (VP9)，透明</translation>
    </message>
    <message>
        <source>QuickTime (ProRes 4444), transparent</source>
        <translation>QuickTime (ProRes 4444)，透明</translation>
    </message>
    <message>
        <source>GIF, on the background colour</source>
        <translation>GIF，以背景色为底</translation>
    </message>
    <message>
        <source>APNG, transparent</source>
        <translation>APNG，透明</translation>
    </message>
    <message>
        <source>PNG, 8 bits</source>
        <translation>PNG，8 位</translation>
    </message>
    <message>
        <source>PNG, 16 bits</source>
        <translation>PNG，16 位</translation>
    </message>
    <message>
        <source>OpenEXR, half floats, linear</source>
        <translation>OpenEXR，半精度浮点，线性</translation>
    </message>
    <message>
        <source>OpenEXR, floats, linear</source>
        <translation>OpenEXR，浮点，线性</translation>
    </message>
    <message>
        <source>TGA, 8 bits</source>
        <translation>TGA，8 位</translation>
    </message>
    <message>
        <source>%1, %2 × %3 pixels, and %4 more files</source>
        <translation>%1，%2 × %3 像素，以及另外 %4 个文件</translation>
    </message>
    <message>
        <source>%1, %2 × %3 pixels, and %4</source>
        <translation>%1，%2 × %3 像素，以及 %4</translation>
    </message>
    <message>
        <source>On the graphics card: %1 as BC7, %2 uncompressed</source>
        <translation>显卡内存：BC7 格式 %1，未压缩 %2</translation>
    </message>
    <message>
        <source>Files: %1, from %2 to %3</source>
        <translation>文件数：%1，从 %2 到 %3</translation>
    </message>
    <message>
        <source>%1, %2 × %3 pixels, %4 s</source>
        <translation>%1，%2 × %3 像素，%4 秒</translation>
    </message>
    <message>
        <source>Choose a file, and a first frame that comes before the last.</source>
        <translation>请选择文件，并让第一帧在最后一帧之前。</translation>
    </message>
    <message>
        <source>No air carries this smoke: switch it on in the group Air.</source>
        <translation>此烟雾没有空气承载：请在“空气”组中启用。</translation>
    </message>
    <message>
        <source>%1 frames do not fill %2 cells: choose more frames or fewer columns and rows.</source>
        <translation>%1 帧无法填满 %2 个格子：请选择更多帧，或减少列数和行数。</translation>
    </message>
    <message>
        <source>Use %1 × %2 cells</source>
        <translation>使用 %1 × %2 个单元格</translation>
    </message>
    <message>
        <source>Use frames %1</source>
        <translation>使用帧 %1</translation>
    </message>
    <message>
        <source>Save as %1</source>
        <translation>另存为 %1</translation>
    </message>
    <message>
        <source>%1 already exists.</source>
        <translation>%1 已存在。</translation>
    </message>
    <message>
        <source>%1 of the files are there already; the first is %2.</source>
        <translation>其中 %1 个文件已经存在；第一个是 %2。</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>导出</translation>
    </message>
    <message>
        <source>Overwrite</source>
        <translation>覆盖</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Cell width</source>
        <translation>单元格宽度</translation>
    </message>
    <message>
        <source>Cell height</source>
        <translation>单元格高度</translation>
    </message>
    <message>
        <source>Interrupted</source>
        <translation>尚未完成：上次遗留</translation>
    </message>
    <message>
        <source>Waiting</source>
        <translation>等待中</translation>
    </message>
    <message>
        <source>Begun</source>
        <translation>已开始</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>已完成</translation>
    </message>
    <message>
        <source>Failed</source>
        <translation>失败</translation>
    </message>
    <message>
        <source>Cancelled. Files that were complete are kept.</source>
        <translation>已取消。已完成的文件会保留。</translation>
    </message>
</context>
<context>
    <name>fumage::ui::FileNotices</name>
    <message>
        <source>“%1” has been changed by another program. Reload it, which can be undone, or keep this version: it replaces the other when you save it.</source>
        <translation>“%1”已被其他程序更改。可以重新加载（可撤销），或保留此版本：保存时它将替换另一版本。</translation>
    </message>
    <message>
        <source>Reload</source>
        <translation>重新加载</translation>
    </message>
    <message>
        <source>Keep this version</source>
        <translation>保留此版本</translation>
    </message>
    <message>
        <source>“%1” has been deleted or moved. What you see is kept as unsaved work: save it to have a file again.</source>
        <translation>“%1”已被删除或移动。您看到的内容作为未保存的工作保留：请保存以重新得到文件。</translation>
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
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>This is unsaved work from before the program ended unexpectedly. Save it to keep it.</source>
        <translation>这是程序意外退出之前未保存的工作。请保存以保留它。</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>放弃</translation>
    </message>
</context>
<context>
    <name>fumage::ui::FlipbookChoices</name>
    <message>
        <source>Light maps</source>
        <translation>光照贴图</translation>
    </message>
    <message>
        <source>Motion vectors</source>
        <translation>运动矢量</translation>
    </message>
    <message>
        <source>Columns</source>
        <translation>列</translation>
    </message>
    <message>
        <source>Rows</source>
        <translation>行</translation>
    </message>
    <message>
        <source>For</source>
        <translation>用于</translation>
    </message>
    <message>
        <source>What is to play it: the files that it needs are written, too</source>
        <translation>由谁来播放：所需的文件也会一并写出</translation>
    </message>
    <message>
        <source>Any engine</source>
        <translation>任意引擎</translation>
    </message>
    <message>
        <source>Web page</source>
        <translation>网页</translation>
    </message>
    <message>
        <source>Two pictures with light from six sides, so that an engine lights the smoke with its own lights</source>
        <translation>两张含六个方向光照的图片，引擎可以用自己的灯光照亮烟雾</translation>
    </message>
    <message>
        <source>A picture of where the smoke goes, so that an engine moves it between the cells</source>
        <translation>一张记录烟雾去向的图片，引擎可以在两格之间移动它</translation>
    </message>
    <message>
        <source>Extra maps</source>
        <translation>附加贴图</translation>
    </message>
    <message>
        <source>Grid</source>
        <translation>网格</translation>
    </message>
    <message>
        <source>Layers</source>
        <translation>图层</translation>
    </message>
    <message>
        <source>Together</source>
        <translation>合在一起</translation>
    </message>
    <message>
        <source>Each alone</source>
        <translation>各自单独</translation>
    </message>
    <message>
        <source>Contributions</source>
        <translation>贡献</translation>
    </message>
    <message>
        <source>Stacked</source>
        <translation>叠放</translation>
    </message>
    <message>
        <source>Together: one sheet. Each alone: a sheet a layer that nothing hides. Contributions: the others hide what they hide, and all sheets add up to the picture. Stacked: sheets that are the picture when they are drawn over one another, premultiplied.</source>
        <translation>合在一起：一张图集。各自单独：每个图层一张，不被任何东西遮挡。贡献：其他图层照常遮挡，所有图集相加即为画面。叠放：以预乘方式逐层叠绘即为画面的图集。</translation>
    </message>
</context>
<context>
    <name>fumage::ui::FlipbookExtras</name>
    <message>
        <source>More</source>
        <translation>更多</translation>
    </message>
    <message>
        <source>Cells become as large as the nearest power of two; with 1, 2, 4 to 64 columns and rows</source>
        <translation>单元格取最接近的 2 的幂；列数和行数须为 1、2、4 至 64</translation>
    </message>
    <message>
        <source>From left to right through the cells, from bottom to top through the frames: level is still, falling is backwards</source>
        <translation>从左到右经过各单元格，从下到上经过各帧：水平为静止，下降为倒放</translation>
    </message>
    <message>
        <source>Frames by cells</source>
        <translation>单元格对应的帧</translation>
    </message>
    <message>
        <source>A picture whose channels are those of passes that you choose</source>
        <translation>各通道由您从通道图中选择的图片</translation>
    </message>
    <message>
        <source>Not of a loop, which would no longer close</source>
        <translation>循环除外，否则将无法首尾相接</translation>
    </message>
    <message>
        <source>Frames without smoke at the beginning and the end have no cells</source>
        <translation>开头和结尾没有烟雾的帧不占单元格</translation>
    </message>
    <message>
        <source>Trim empty frames</source>
        <translation>裁去空帧</translation>
    </message>
    <message>
        <source>Power-of-two sheet</source>
        <translation>边长为 2 的幂的图集</translation>
    </message>
    <message>
        <source>Retime with a curve</source>
        <translation>用曲线重映射时间</translation>
    </message>
    <message>
        <source>Add channel-packed texture</source>
        <translation>添加通道打包纹理</translation>
    </message>
</context>
<context>
    <name>Gizmos</name>
    <message>
        <source>Emitter</source>
        <translation>发射器</translation>
    </message>
    <message>
        <source>Normal</source>
        <translation>法线</translation>
    </message>
    <message>
        <source>Wind</source>
        <translation>风</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>光</translation>
    </message>
    <message>
        <source>Vortex</source>
        <translation>涡旋</translation>
    </message>
    <message>
        <source>Rings</source>
        <translation>涡环</translation>
    </message>
    <message>
        <source>Obstacle</source>
        <translation>障碍物</translation>
    </message>
    <message>
        <source>Air</source>
        <translation>空气</translation>
    </message>
</context>
<context>
    <name>GlSprites</name>
    <message>
        <source>The graphics driver refuses the shader %1: %2</source>
        <translation>显卡驱动拒绝着色器 %1：%2</translation>
    </message>
</context>
<context>
    <name>fumage::ui::GradientBar</name>
    <message>
        <source>Colour of the stop</source>
        <translation>色标的颜色</translation>
    </message>
</context>
<context>
    <name>fumage::ui::GradientEditor</name>
    <message>
        <source>Click to add, drag to move, double click for the colour, right click for more</source>
        <translation>按下添加，拖动移动，双击选择颜色，右键显示更多</translation>
    </message>
    <message>
        <source>presets</source>
        <translation>预设</translation>
    </message>
    <message>
        <source>Presets</source>
        <translation>预设</translation>
    </message>
    <message>
        <source>Gradients to begin with, and other hues for all colours of this one</source>
        <translation>可作为起点的渐变，以及为此渐变的所有颜色换用其他色相</translation>
    </message>
    <message>
        <source>Gradient</source>
        <translation>渐变</translation>
    </message>
    <message>
        <source>Other hues</source>
        <translation>其他色相</translation>
    </message>
    <message>
        <source>Reverse</source>
        <translation>反转</translation>
    </message>
</context>
<context>
    <name>GradientPresets</name>
    <message>
        <source>Fire</source>
        <translation>火焰</translation>
    </message>
    <message>
        <source>Gas flame</source>
        <translation>煤气火焰</translation>
    </message>
    <message>
        <source>Ice</source>
        <translation>冰</translation>
    </message>
    <message>
        <source>Magic</source>
        <translation>魔法</translation>
    </message>
    <message>
        <source>Poison</source>
        <translation>毒药</translation>
    </message>
    <message>
        <source>Sunset</source>
        <translation>日落</translation>
    </message>
    <message>
        <source>Soot</source>
        <translation>烟灰</translation>
    </message>
    <message>
        <source>White</source>
        <translation>白色</translation>
    </message>
</context>
<context>
    <name>GraphCurves</name>
    <message>
        <source>red</source>
        <translation>红</translation>
    </message>
    <message>
        <source>green</source>
        <translation>绿</translation>
    </message>
    <message>
        <source>blue</source>
        <translation>蓝</translation>
    </message>
</context>
<context>
    <name>fumage::ui::GraphGrip</name>
    <message>
        <source>Height of the graph</source>
        <translation>曲线图的高度</translation>
    </message>
    <message>
        <source>Drag for a higher graph; a double-click gives it its usual height</source>
        <translation>拖动可增高曲线图；双击恢复常用高度</translation>
    </message>
</context>
<context>
    <name>fumage::ui::GuardedApplication</name>
    <message>
        <source>Not enough memory</source>
        <translation>内存不足</translation>
    </message>
    <message>
        <source>There is not enough memory for what you just did. Save your work.</source>
        <translation>内存不足以完成刚才的操作。请保存工作。</translation>
    </message>
    <message>
        <source>Something failed</source>
        <translation>出现错误</translation>
    </message>
    <message>
        <source>What you just did may not have been done. Save your work. %1</source>
        <translation>刚才的操作可能没有完成。请保存您的工作。%1</translation>
    </message>
</context>
<context>
    <name>Help</name>
    <message>
        <source>Find</source>
        <translation>查找</translation>
    </message>
    <message>
        <source>Parameter reference</source>
        <translation>参数手册</translation>
    </message>
    <message>
        <source>Keyboard shortcuts</source>
        <translation>键盘快捷键</translation>
    </message>
    <message>
        <source>About Fumage</source>
        <translation>关于 Fumage</translation>
    </message>
    <message>
        <source>An editor for smoke. Free software under the MIT licence.

The model begins with Lin and Lin, “Smoke Simulation with Perlin Noise”, University of Gävle, 2012. Made with Qt, GLM, Highway, oneTBB, libpng and OpenEXR.</source>
        <translation>烟雾编辑器。遵循 MIT 许可证的自由软件。

模型源自 Lin 与 Lin 的《Smoke Simulation with Perlin Noise》，耶夫勒大学，2012 年。使用 Qt、GLM、Highway、oneTBB、libpng 和 OpenEXR 制作。</translation>
    </message>
    <message>
        <source>%1 These are the tips of all parameters.</source>
        <translation>%1 以下是所有参数的提示。</translation>
    </message>
</context>
<context>
    <name>fumage::ui::HistoryView</name>
    <message>
        <source>As opened</source>
        <translation>刚打开时</translation>
    </message>
    <message>
        <source>Undo history</source>
        <translation>撤销历史</translation>
    </message>
</context>
<context>
    <name>KeyClipboard</name>
    <message>
        <source>Paste key frames</source>
        <translation>粘贴关键帧</translation>
    </message>
</context>
<context>
    <name>KeyEdits</name>
    <message>
        <source>Key %1</source>
        <translation>为%1设置关键帧</translation>
    </message>
    <message>
        <source>%1 outside its key frames</source>
        <translation>%1在关键帧之外</translation>
    </message>
    <message>
        <source>Remove key frames</source>
        <translation>移除关键帧</translation>
    </message>
    <message>
        <source>Ease of key frames</source>
        <translation>关键帧的缓动</translation>
    </message>
    <message>
        <source>Mend key frames of %1</source>
        <translation>修正%1的关键帧</translation>
    </message>
    <message>
        <source>Mend key frames</source>
        <translation>修正关键帧</translation>
    </message>
</context>
<context>
    <name>fumage::ui::KeyGraph</name>
    <message>
        <source>Curves of key frames</source>
        <translation>关键帧曲线</translation>
    </message>
    <message>
        <source>Drag keys and their handles (Ctrl: one side alone); a double-click on a curve adds a key; the wheel zooms the values, F shows all</source>
        <translation>拖动关键帧及其手柄（Ctrl：仅一侧）；双击曲线添加关键帧；滚轮缩放数值，F 显示全部</translation>
    </message>
    <message>
        <source>Move key frames</source>
        <translation>移动关键帧</translation>
    </message>
    <message>
        <source>Bend a curve</source>
        <translation>弯曲曲线</translation>
    </message>
    <message>
        <source>on</source>
        <translation>开</translation>
    </message>
    <message>
        <source>off</source>
        <translation>关</translation>
    </message>
</context>
<context>
    <name>fumage::ui::KeyLanes</name>
    <message>
        <source>Key frames</source>
        <translation>关键帧</translation>
    </message>
    <message>
        <source>Drag key frames to other times; Alt stretches, Delete removes, a double-click adds one</source>
        <translation>拖动关键帧到其他时间；Alt 拉伸，Delete 移除，双击添加</translation>
    </message>
    <message>
        <source>Move key frames</source>
        <translation>移动关键帧</translation>
    </message>
</context>
<context>
    <name>fumage::ui::KeyMark</name>
    <message>
        <source>Key frame of %1</source>
        <translation>%1的关键帧</translation>
    </message>
    <message>
        <source>Key frame here; click to remove it</source>
        <translation>此处有关键帧；单击移除</translation>
    </message>
    <message>
        <source>Click to set a key frame at the time that is shown</source>
        <translation>单击在当前时间设置关键帧</translation>
    </message>
</context>
<context>
    <name>KeyMends</name>
    <message>
        <source>It does not end as it begins, so the loop jumps there.</source>
        <translation>结尾与开头不同，循环会在此跳变。</translation>
    </message>
    <message>
        <source>It has key frames after the end of the timeline.</source>
        <translation>时间线结束之后还有关键帧。</translation>
    </message>
    <message>
        <source>It changes at once at a held key frame, so what it drives changes its pace with a jerk.</source>
        <translation>它在保持的关键帧处突变，受它驱动的运动会突然变速。</translation>
    </message>
    <message>
        <source>Make periodic</source>
        <translation>使其周期化</translation>
    </message>
    <message>
        <source>Move into the timeline</source>
        <translation>移入时间线</translation>
    </message>
    <message>
        <source>Smooth the jumps</source>
        <translation>平滑跳变</translation>
    </message>
</context>
<context>
    <name>KeyMenu</name>
    <message>
        <source>Smooth</source>
        <translation>平滑</translation>
    </message>
    <message>
        <source>Linear</source>
        <translation>线性</translation>
    </message>
    <message>
        <source>Hold</source>
        <translation>保持</translation>
    </message>
    <message>
        <source>Free</source>
        <translation>自由</translation>
    </message>
    <message>
        <source>Ease in</source>
        <translation>缓入</translation>
    </message>
    <message>
        <source>Ease out</source>
        <translation>缓出</translation>
    </message>
    <message>
        <source>Ease in and out</source>
        <translation>缓入缓出</translation>
    </message>
    <message>
        <source>Repeat</source>
        <translation>重复</translation>
    </message>
    <message>
        <source>Back and forth</source>
        <translation>往返</translation>
    </message>
    <message>
        <source>After the last key frame</source>
        <translation>最后一个关键帧之后</translation>
    </message>
    <message>
        <source>Before the first key frame</source>
        <translation>第一个关键帧之前</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>复制</translation>
    </message>
    <message>
        <source>Paste at the time that is shown</source>
        <translation>粘贴到当前时间</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>移除</translation>
    </message>
</context>
<context>
    <name>KeyTable</name>
    <message>
        <source>Tables (*.csv *.tsv *.txt);;All files (*)</source>
        <translation>表格 (*.csv *.tsv *.txt);;所有文件 (*)</translation>
    </message>
    <message>
        <source>The key frames could not be written</source>
        <translation>无法写入关键帧</translation>
    </message>
    <message>
        <source>Write as CSV…</source>
        <translation>写为 CSV…</translation>
    </message>
    <message>
        <source>Write key frames</source>
        <translation>写入关键帧</translation>
    </message>
    <message>
        <source>Read from CSV…</source>
        <translation>从 CSV 读取…</translation>
    </message>
    <message>
        <source>Read key frames</source>
        <translation>读取关键帧</translation>
    </message>
    <message>
        <source>The key frames could not be read</source>
        <translation>无法读取关键帧</translation>
    </message>
    <message>
        <source>Read key frames of %1</source>
        <translation>读取%1的关键帧</translation>
    </message>
</context>
<context>
    <name>LayerClipboard</name>
    <message>
        <source>Paste %1 of “%2”</source>
        <translation>粘贴“%2”的 %1</translation>
    </message>
</context>
<context>
    <name>LayerEdits</name>
    <message>
        <source>Layer %1</source>
        <translation>图层 %1</translation>
    </message>
    <message>
        <source>Add a layer</source>
        <translation>添加图层</translation>
    </message>
    <message>
        <source>Add the layers of “%1”</source>
        <translation>添加“%1”的图层</translation>
    </message>
    <message>
        <source>Duplicate %1</source>
        <translation>复制 %1</translation>
    </message>
    <message>
        <source>Delete %1</source>
        <translation>删除 %1</translation>
    </message>
    <message>
        <source>Move %1</source>
        <translation>移动 %1</translation>
    </message>
    <message>
        <source>Rename %1</source>
        <translation>重命名 %1</translation>
    </message>
    <message>
        <source>Show %1</source>
        <translation>显示 %1</translation>
    </message>
    <message>
        <source>Mute %1</source>
        <translation>静音 %1</translation>
    </message>
    <message>
        <source>Lock %1</source>
        <translation>锁定 %1</translation>
    </message>
    <message>
        <source>Unlock %1</source>
        <translation>解锁 %1</translation>
    </message>
    <message>
        <source>Colour tag of %1</source>
        <translation>%1 的颜色标签</translation>
    </message>
    <message>
        <source>%1 layers</source>
        <translation>%1 个图层</translation>
    </message>
    <message>
        <source>%1: born on %2</source>
        <translation>%1：诞生于 %2</translation>
    </message>
    <message>
        <source>%1: born on the emitter</source>
        <translation>%1：诞生于发射器</translation>
    </message>
</context>
<context>
    <name>fumage::ui::LayerList</name>
    <message>
        <source>None</source>
        <translation>无</translation>
    </message>
    <message>
        <source>Red</source>
        <translation>红</translation>
    </message>
    <message>
        <source>Orange</source>
        <translation>橙</translation>
    </message>
    <message>
        <source>Yellow</source>
        <translation>黄</translation>
    </message>
    <message>
        <source>Green</source>
        <translation>绿</translation>
    </message>
    <message>
        <source>Blue</source>
        <translation>蓝</translation>
    </message>
    <message>
        <source>Violet</source>
        <translation>紫</translation>
    </message>
    <message>
        <source>Grey</source>
        <translation>灰</translation>
    </message>
    <message>
        <source>Add a layer</source>
        <translation>添加图层</translation>
    </message>
    <message>
        <source>Duplicate the layer</source>
        <translation>复制图层</translation>
    </message>
    <message>
        <source>Delete the layer</source>
        <translation>删除图层</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>重命名</translation>
    </message>
    <message>
        <source>Mute</source>
        <translation>静音</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>显示</translation>
    </message>
    <message>
        <source>Unlock</source>
        <translation>解锁</translation>
    </message>
    <message>
        <source>Lock</source>
        <translation>锁定</translation>
    </message>
    <message>
        <source>Colour tag</source>
        <translation>颜色标签</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>复制</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>删除</translation>
    </message>
    <message>
        <source>No longer solo</source>
        <translation>取消独显</translation>
    </message>
    <message>
        <source>Solo</source>
        <translation>独显</translation>
    </message>
    <message>
        <source>End solo</source>
        <translation>结束独显</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>剪切</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>复制到剪贴板</translation>
    </message>
    <message>
        <source>Paste</source>
        <translation>粘贴</translation>
    </message>
    <message>
        <source>Paste parameters…</source>
        <translation>粘贴参数…</translation>
    </message>
    <message>
        <source>Born on</source>
        <translation>诞生于</translation>
    </message>
    <message>
        <source>Its emitter</source>
        <translation>自身的发射器</translation>
    </message>
    <message>
        <source>Smoke</source>
        <translation>烟雾</translation>
    </message>
</context>
<context>
    <name>fumage::ui::LayerModel</name>
    <message>
        <source>%1 particles</source>
        <translation>%1 个粒子</translation>
    </message>
    <message>
        <source>Muted: it is neither simulated nor exported</source>
        <translation>已静音：既不模拟也不导出</translation>
    </message>
    <message>
        <source>%1 % of the simulation</source>
        <translation>占模拟的 %1 %</translation>
    </message>
    <message>
        <source>Born on %1</source>
        <translation>诞生于 %1</translation>
    </message>
</context>
<context>
    <name>LayerTemplates</name>
    <message>
        <source>Flames</source>
        <translation>火焰</translation>
    </message>
    <message>
        <source>Embers</source>
        <translation>余烬</translation>
    </message>
    <message>
        <source>Sparks</source>
        <translation>火花</translation>
    </message>
    <message>
        <source>Fireball</source>
        <translation>火球</translation>
    </message>
    <message>
        <source>Debris with trails</source>
        <translation>带尾迹的碎片</translation>
    </message>
    <message>
        <source>Dust ring</source>
        <translation>尘环</translation>
    </message>
    <message>
        <source>Jet</source>
        <translation>喷流</translation>
    </message>
    <message>
        <source>Falling fog</source>
        <translation>下沉的雾</translation>
    </message>
    <message>
        <source>Glitter</source>
        <translation>闪粉</translation>
    </message>
    <message>
        <source>Halo</source>
        <translation>光晕</translation>
    </message>
</context>
<context>
    <name>fumage::ui::LayerTransfer</name>
    <message>
        <source>Cut %1</source>
        <translation>剪切 %1</translation>
    </message>
    <message>
        <source>A scene has at most %1 layers: %2 were left out.</source>
        <translation>一个场景最多 %1 个图层：略去了 %2 个。</translation>
    </message>
    <message>
        <source>Cannot paste layers</source>
        <translation>无法粘贴图层</translation>
    </message>
    <message>
        <source>Pasted layer</source>
        <translation>粘贴的图层</translation>
    </message>
    <message>
        <source>Paste %1</source>
        <translation>粘贴 %1</translation>
    </message>
    <message>
        <source>Cannot paste parameters</source>
        <translation>无法粘贴参数</translation>
    </message>
    <message>
        <source>Cannot add layers</source>
        <translation>无法添加图层</translation>
    </message>
    <message>
        <source>Cannot add “%1”</source>
        <translation>无法添加“%1”</translation>
    </message>
    <message>
        <source>Add “%1”</source>
        <translation>添加“%1”</translation>
    </message>
</context>
<context>
    <name>fumage::ui::LayerView</name>
    <message>
        <source>Layers</source>
        <translation>图层</translation>
    </message>
    <message>
        <source>Show or mute, in exports, too (Alt: look at this layer alone)</source>
        <translation>显示或静音，导出时也一样（Alt：只看此图层）</translation>
    </message>
    <message>
        <source>Look at this layer alone: in the viewport, not in exports</source>
        <translation>只看此图层：仅在视口中，不影响导出</translation>
    </message>
</context>
<context>
    <name>fumage::ui::MainWindow</name>
    <message>
        <source>Unsaved work cannot be kept safe: %1</source>
        <translation>无法妥善保存未保存的工作：%1</translation>
    </message>
    <message>
        <source>Apply “%1”</source>
        <translation>放入“%1”</translation>
    </message>
    <message>
        <source>There is not enough memory for this picture. Use fewer particles or a smaller window.</source>
        <translation>内存不足以生成这幅图像。请减少粒子数量或缩小窗口。</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>OK</source>
        <translation>确定</translation>
    </message>
    <message>
        <source>There is nothing to be seen that the tour could show.</source>
        <translation>没有可供导览展示的内容。</translation>
    </message>
</context>
<context>
    <name>Manual</name>
    <message>
        <source>The page %1 cannot be read.</source>
        <translation>无法读取页面 %1。</translation>
    </message>
    <message>
        <source>The page %1 is too large.</source>
        <translation>页面 %1 太大。</translation>
    </message>
    <message>
        <source>The page %1 is not UTF-8 text.</source>
        <translation>页面 %1 不是 UTF-8 文本。</translation>
    </message>
    <message>
        <source>The manual is not installed: there is no folder %1.</source>
        <translation>手册未安装：没有文件夹 %1。</translation>
    </message>
    <message>
        <source>The manual has no pages that can be read in %1.</source>
        <translation>%1 中没有可读的手册页面。</translation>
    </message>
    <message>
        <source>The page %1 has a paragraph that is too long.</source>
        <translation>页面 %1 有过长的段落。</translation>
    </message>
</context>
<context>
    <name>fumage::ui::ManualDocument</name>
    <message>
        <source>[This picture cannot be shown: %1]</source>
        <translation>[无法显示此图片：%1]</translation>
    </message>
</context>
<context>
    <name>fumage::ui::ManualView</name>
    <message>
        <source>Page of the manual</source>
        <translation>手册页面</translation>
    </message>
</context>
<context>
    <name>fumage::ui::ManualWindow</name>
    <message>
        <source>Back (Alt+Left)</source>
        <translation>后退 (Alt+左)</translation>
    </message>
    <message>
        <source>Forward (Alt+Right)</source>
        <translation>前进 (Alt+右)</translation>
    </message>
    <message>
        <source>Manual</source>
        <translation>手册</translation>
    </message>
    <message>
        <source>Contents of the manual</source>
        <translation>手册目录</translation>
    </message>
    <message>
        <source>Found in the manual</source>
        <translation>手册中的搜索结果</translation>
    </message>
    <message>
        <source>Message</source>
        <translation>消息</translation>
    </message>
    <message>
        <source>Search the manual</source>
        <translation>搜索手册</translation>
    </message>
    <message>
        <source>Search the manual (Ctrl+F)</source>
        <translation>搜索手册 (Ctrl+F)</translation>
    </message>
    <message>
        <source>The manual has nothing about “%1”.</source>
        <translation>手册中没有关于“%1”的内容。</translation>
    </message>
    <message>
        <source>This page has no place “%1”.</source>
        <translation>本页没有位置“%1”。</translation>
    </message>
    <message>
        <source>%1 — Manual</source>
        <translation>%1 — 手册</translation>
    </message>
    <message>
        <source>This leads out of the manual, and is not opened: %1</source>
        <translation>此链接指向手册之外，不会打开：%1</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>No results for “%1”. Try a part of a word, or another word.</source>
        <translation>没有“%1”的结果。请尝试词的一部分或其他词。</translation>
    </message>
</context>
<context>
    <name>MarkerEdits</name>
    <message>
        <source>Marker %1</source>
        <translation>标记 %1</translation>
    </message>
    <message>
        <source>Add a marker</source>
        <translation>添加标记</translation>
    </message>
    <message>
        <source>Rename a marker</source>
        <translation>重命名标记</translation>
    </message>
    <message>
        <source>Remove a marker</source>
        <translation>移除标记</translation>
    </message>
</context>
<context>
    <name>fumage::ui::MarkerLane</name>
    <message>
        <source>Markers</source>
        <translation>标记</translation>
    </message>
    <message>
        <source>Move a marker</source>
        <translation>移动标记</translation>
    </message>
    <message>
        <source>%1 at %2 s</source>
        <translation>%1，%2 秒</translation>
    </message>
    <message>
        <source>Name of the marker</source>
        <translation>标记名称</translation>
    </message>
    <message>
        <source>Rename…</source>
        <translation>重命名…</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>移除</translation>
    </message>
    <message>
        <source>Add a marker at the frame that is shown</source>
        <translation>在当前帧添加标记</translation>
    </message>
</context>
<context>
    <name>Menus</name>
    <message>
        <source>Tools</source>
        <translation>工具</translation>
    </message>
    <message>
        <source>As the system</source>
        <translation>跟随系统</translation>
    </message>
    <message>
        <source>The language changes when Fumage starts the next time.</source>
        <translation>语言将在下次启动 Fumage 时更改。</translation>
    </message>
    <message>
        <source>As the desktop</source>
        <translation>跟随桌面</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>深色</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>光</translation>
    </message>
</context>
<context>
    <name>fumage::ui::MessageBox</name>
    <message>
        <source>“%1” exists already. Replace it?</source>
        <translation>“%1”已存在。要替换吗？</translation>
    </message>
</context>
<context>
    <name>Messages</name>
    <message>
        <source>there is not enough memory</source>
        <translation>内存不足</translation>
    </message>
    <message>
        <source>Use a smaller picture or fewer particles</source>
        <translation>请使用更小的图像或更少的粒子</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>%1. %2</source>
        <translation>%1。%2</translation>
    </message>
    <message>
        <source>cannot read: %1</source>
        <translation>无法读取：%1</translation>
    </message>
    <message>
        <source>it is not a regular file</source>
        <translation>它不是普通文件</translation>
    </message>
    <message>
        <source>Name a file</source>
        <translation>请指定一个文件</translation>
    </message>
    <message>
        <source>the file has %1 bytes, more than the %2 that are read</source>
        <translation>文件有 %1 字节，超过可读取的 %2 字节</translation>
    </message>
    <message>
        <source>Choose another file</source>
        <translation>请选择其他文件</translation>
    </message>
    <message>
        <source>the folder cannot be made: %1</source>
        <translation>无法创建文件夹：%1</translation>
    </message>
    <message>
        <source>Choose another place</source>
        <translation>请选择其他位置</translation>
    </message>
    <message>
        <source>cannot write: %1</source>
        <translation>无法写入：%1</translation>
    </message>
    <message>
        <source>there is no such file or folder</source>
        <translation>没有这样的文件或文件夹</translation>
    </message>
    <message>
        <source>Check the spelling of the path</source>
        <translation>请检查路径的拼写</translation>
    </message>
    <message>
        <source>permission denied</source>
        <translation>权限不足</translation>
    </message>
    <message>
        <source>Choose a place that you may use, or change its permissions</source>
        <translation>请选择您有权使用的位置，或更改其权限</translation>
    </message>
    <message>
        <source>the disk is read-only</source>
        <translation>磁盘是只读的</translation>
    </message>
    <message>
        <source>Choose another disk</source>
        <translation>请选择其他磁盘</translation>
    </message>
    <message>
        <source>it is a folder</source>
        <translation>它是文件夹</translation>
    </message>
    <message>
        <source>a part of the path is not a folder</source>
        <translation>路径中的一部分不是文件夹</translation>
    </message>
    <message>
        <source>Check the path</source>
        <translation>请检查路径</translation>
    </message>
    <message>
        <source>its symbolic links lead in a circle</source>
        <translation>其符号链接构成循环</translation>
    </message>
    <message>
        <source>Remove the link or name another file</source>
        <translation>请删除该链接或指定其他文件</translation>
    </message>
    <message>
        <source>the name is too long</source>
        <translation>名称过长</translation>
    </message>
    <message>
        <source>Choose a shorter name</source>
        <translation>请选择更短的名称</translation>
    </message>
    <message>
        <source>the disk is full</source>
        <translation>磁盘已满</translation>
    </message>
    <message>
        <source>Free some space or choose another disk</source>
        <translation>请释放空间或选择其他磁盘</translation>
    </message>
    <message>
        <source>the file is larger than may be written here</source>
        <translation>文件超过此处允许写入的大小</translation>
    </message>
    <message>
        <source>Choose another disk or a smaller size</source>
        <translation>请选择其他磁盘或更小的尺寸</translation>
    </message>
    <message>
        <source>this machine has no instruction set %1</source>
        <translation>本机没有指令集 %1</translation>
    </message>
    <message>
        <source>Choose one of %1</source>
        <translation>请从 %1 中选择</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>true 或 false</translation>
    </message>
    <message>
        <source>a whole number</source>
        <translation>整数</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>数字</translation>
    </message>
    <message>
        <source>one of its names</source>
        <translation>其名称之一</translation>
    </message>
    <message>
        <source>a whole number from 0 to 4294967295</source>
        <translation>0 到 4294967295 的整数</translation>
    </message>
    <message>
        <source>three numbers [x, y, z]</source>
        <translation>三个数字 [x, y, z]</translation>
    </message>
    <message>
        <source>three numbers [red, green, blue]</source>
        <translation>三个数字 [红, 绿, 蓝]</translation>
    </message>
    <message>
        <source>a list of 1 to 16 points [x, y]</source>
        <translation>1 到 16 个点 [x, y] 的列表</translation>
    </message>
    <message>
        <source>a list of 1 to 16 stops [at, red, green, blue]</source>
        <translation>1 到 16 个色标 [位置, 红, 绿, 蓝] 的列表</translation>
    </message>
    <message>
        <source>expected %1, found %2</source>
        <translation>应为%1，实际为 %2</translation>
    </message>
    <message>
        <source>there is no %1</source>
        <translation>没有 %1</translation>
    </message>
    <message>
        <source>the number is not finite</source>
        <translation>数字不是有限值</translation>
    </message>
    <message>
        <source>Use a plain number such as 1.5</source>
        <translation>请使用普通数字，例如 1.5</translation>
    </message>
    <message>
        <source>%1 has no &quot;=&quot;</source>
        <translation>%1 缺少“=”</translation>
    </message>
    <message>
        <source>there is no parameter %1</source>
        <translation>没有参数 %1</translation>
    </message>
    <message>
        <source>List them with: fumage-cli parameters</source>
        <translation>可用以下命令列出：fumage-cli parameters</translation>
    </message>
    <message>
        <source>Did you mean %1?</source>
        <translation>您是想说 %1 吗？</translation>
    </message>
    <message>
        <source>the picture was cancelled</source>
        <translation>图像已取消</translation>
    </message>
    <message>
        <source>the picture cannot be written as EXR: %1</source>
        <translation>无法将图像写为 EXR：%1</translation>
    </message>
    <message>
        <source>no visible smoke in frames %1 to %2</source>
        <translation>第 %1 到 %2 帧中看不到烟雾</translation>
    </message>
    <message>
        <source>Choose other frames, or make the smoke denser</source>
        <translation>请选择其他帧，或使烟雾更浓</translation>
    </message>
    <message>
        <source>a flipbook of %1 x %2 cells</source>
        <translation>%1 x %2 格的序列图集</translation>
    </message>
    <message>
        <source>Use 1 to %1 columns and rows</source>
        <translation>请使用 1 到 %1 列和行</translation>
    </message>
    <message>
        <source>%1 frames do not fill %2 cells</source>
        <translation>%1 帧填不满 %2 格</translation>
    </message>
    <message>
        <source>a flipbook of %1 x %2 pixels</source>
        <translation>%1 x %2 像素的序列图集</translation>
    </message>
    <message>
        <source>Choose smaller or fewer cells: edges up to %1 pixels, at most %2 million in all</source>
        <translation>请选择更小或更少的格子：边长至多 %1 像素，总计至多 %2 百万</translation>
    </message>
    <message>
        <source>unknown image format</source>
        <translation>未知的图像格式</translation>
    </message>
    <message>
        <source>this would overwrite the preset that it is made of</source>
        <translation>这会覆盖它所依据的预设</translation>
    </message>
    <message>
        <source>Choose another name</source>
        <translation>请选择其他名称</translation>
    </message>
    <message>
        <source>Name a file, or - for standard output</source>
        <translation>请指定文件，或用 - 表示标准输出</translation>
    </message>
    <message>
        <source>the ending %1 does not fit</source>
        <translation>扩展名 %1 不适用</translation>
    </message>
    <message>
        <source>Use %1</source>
        <translation>请使用 %1</translation>
    </message>
    <message>
        <source>these are several files</source>
        <translation>这是多个文件</translation>
    </message>
    <message>
        <source>Name a file, or one frame</source>
        <translation>请指定一个文件或一帧</translation>
    </message>
    <message>
        <source>the PNG library could not be started</source>
        <translation>无法启动 PNG 库</translation>
    </message>
    <message>
        <source>the picture cannot be written as PNG: %1</source>
        <translation>无法将图像写为 PNG：%1</translation>
    </message>
    <message>
        <source>invalid frame range %1</source>
        <translation>无法理解帧 %1</translation>
    </message>
    <message>
        <source>Write 7, 0-119 or 0-119:2</source>
        <translation>请写成 7、0-119 或 0-119:2</translation>
    </message>
    <message>
        <source>frames %1 run backwards or out of range</source>
        <translation>帧 %1 顺序颠倒或超出范围</translation>
    </message>
    <message>
        <source>Use numbers from 0 to %1, the smaller first</source>
        <translation>请使用 0 到 %1 的数字，小的在前</translation>
    </message>
    <message>
        <source>baking the noise was cancelled</source>
        <translation>噪声烘焙已取消</translation>
    </message>
    <message>
        <source>a noise tile of %1 pixels</source>
        <translation>%1 像素的噪声图块</translation>
    </message>
    <message>
        <source>Choose 1 to %1</source>
        <translation>请选择 1 到 %1</translation>
    </message>
    <message>
        <source>the text is not UTF-8</source>
        <translation>文本不是 UTF-8</translation>
    </message>
    <message>
        <source>Save the file as UTF-8</source>
        <translation>请将文件保存为 UTF-8</translation>
    </message>
    <message>
        <source>the file ends in the middle</source>
        <translation>文件不完整</translation>
    </message>
    <message>
        <source>It may have been cut off; use a copy of it</source>
        <translation>它可能被截断；请使用副本</translation>
    </message>
    <message>
        <source>this is not JSON: %1</source>
        <translation>这不是 JSON：%1</translation>
    </message>
    <message>
        <source>brackets are nested more than %1 deep</source>
        <translation>括号嵌套超过 %1 层</translation>
    </message>
    <message>
        <source>This is not a preset</source>
        <translation>这不是预设</translation>
    </message>
    <message>
        <source>the key %1 is there twice</source>
        <translation>键 %1 出现了两次</translation>
    </message>
    <message>
        <source>Remove one of them</source>
        <translation>请删除其中一个</translation>
    </message>
    <message>
        <source>this is not JSON: there is a zero byte</source>
        <translation>这不是 JSON：其中有零字节</translation>
    </message>
    <message>
        <source>It may be a binary file or a damaged one</source>
        <translation>它可能是二进制文件或已损坏</translation>
    </message>
    <message>
        <source>line %1, column %2</source>
        <translation>第 %1 行，第 %2 列</translation>
    </message>
    <message>
        <source>there is no built-in preset %1</source>
        <translation>没有内置预设 %1</translation>
    </message>
    <message>
        <source>there is no preset or file %1</source>
        <translation>没有预设或文件 %1</translation>
    </message>
    <message>
        <source>List the presets with: fumage-cli presets</source>
        <translation>可用以下命令列出预设：fumage-cli presets</translation>
    </message>
    <message>
        <source>a preset of %1 bytes</source>
        <translation>%1 字节的预设</translation>
    </message>
    <message>
        <source>Presets have at most %1</source>
        <translation>预设至多 %1 字节</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1，%2</translation>
    </message>
    <message>
        <source>a preset is an object in braces { }</source>
        <translation>预设是花括号 { } 中的对象</translation>
    </message>
    <message>
        <source>this JSON is not a Fumage preset</source>
        <translation>此 JSON 不是 Fumage 预设</translation>
    </message>
    <message>
        <source>A preset begins with &quot;format&quot;: &quot;fumage-preset&quot;</source>
        <translation>预设以 &quot;format&quot;: &quot;fumage-preset&quot; 开头</translation>
    </message>
    <message>
        <source>the version of the preset is missing or not a whole number from 1</source>
        <translation>预设的版本缺失，或不是从 1 开始的整数</translation>
    </message>
    <message>
        <source>the preset has version %1, this program reads up to %2</source>
        <translation>预设版本为 %1，本程序至多读取 %2</translation>
    </message>
    <message>
        <source>Open it with a newer Fumage</source>
        <translation>请用更新的 Fumage 打开</translation>
    </message>
    <message>
        <source>%1: expected a text in quotes</source>
        <translation>%1：应为引号中的文本</translation>
    </message>
    <message>
        <source>%1: expected an object in braces { }</source>
        <translation>%1：应为花括号 { } 中的对象</translation>
    </message>
    <message>
        <source>unknown key %1 is kept but has no effect</source>
        <translation>未知键 %1 会被保留，但不起作用</translation>
    </message>
    <message>
        <source>unknown key %1 is kept but has no effect; did you mean %2?</source>
        <translation>未知键 %1 会被保留，但不起作用；您是想说 %2 吗？</translation>
    </message>
    <message>
        <source>%1 was out of range and is now %2</source>
        <translation>%1 超出范围，现为 %2</translation>
    </message>
    <message>
        <source>and %1 more warnings</source>
        <translation>以及另外 %1 条警告</translation>
    </message>
    <message>
        <source>%1 parameters are not in the preset and keep their defaults, the first is %2</source>
        <translation>预设中缺少 %1 个参数，它们保持默认值，第一个是 %2</translation>
    </message>
    <message>
        <source>a picture of %1 x %2 pixels</source>
        <translation>%1 x %2 像素的图像</translation>
    </message>
    <message>
        <source>Choose a smaller size or less supersampling</source>
        <translation>请选择更小的尺寸或更低的超采样</translation>
    </message>
    <message>
        <source>painting was cancelled</source>
        <translation>绘制已取消</translation>
    </message>
    <message>
        <source>baking the noise texture was cancelled</source>
        <translation>噪声纹理烘焙已取消</translation>
    </message>
    <message>
        <source>the simulation was cancelled</source>
        <translation>模拟已取消</translation>
    </message>
    <message>
        <source>the export cannot be started: there are not enough memory or threads</source>
        <translation>无法开始导出：内存或线程不足</translation>
    </message>
    <message>
        <source>Close other programs</source>
        <translation>请关闭其他程序</translation>
    </message>
    <message>
        <source>the air was cancelled</source>
        <translation>空气计算已取消</translation>
    </message>
    <message>
        <source>the folder of your presets cannot be made</source>
        <translation>无法创建您的预设文件夹</translation>
    </message>
    <message>
        <source>Save the preset somewhere else</source>
        <translation>请将预设保存到其他位置</translation>
    </message>
    <message>
        <source>the emitter lies under the ground</source>
        <translation>发射器位于地面之下</translation>
    </message>
    <message>
        <source>Lower air.ground_height or raise emitter.position</source>
        <translation>请降低 air.ground_height 或提高 emitter.position</translation>
    </message>
    <message>
        <source>the emitter lies outside the box of the air</source>
        <translation>发射器位于空气盒之外</translation>
    </message>
    <message>
        <source>Turn air.fit on, or change air.offset or air.size</source>
        <translation>请打开 air.fit，或更改 air.offset 或 air.size</translation>
    </message>
    <message>
        <source>the obstacle fills the box of the air</source>
        <translation>障碍物充满了空气盒</translation>
    </message>
    <message>
        <source>Make the obstacle smaller, or move it</source>
        <translation>请缩小或移动障碍物</translation>
    </message>
    <message>
        <source>%1 plays the colour, which is not among the passes</source>
        <translation>%1 播放颜色，而它不在通道之中</translation>
    </message>
    <message>
        <source>Add colour to the passes</source>
        <translation>请在通道中加入 colour</translation>
    </message>
    <message>
        <source>what is written for %1 reads PNG</source>
        <translation>为 %1 写出的文件读取 PNG</translation>
    </message>
    <message>
        <source>Choose PNG</source>
        <translation>请选择 PNG</translation>
    </message>
    <message>
        <source>the passes of frames are layers of EXR</source>
        <translation>帧的通道是 EXR 的图层</translation>
    </message>
    <message>
        <source>Choose EXR, or a flipbook</source>
        <translation>请选择 EXR 或序列帧图集</translation>
    </message>
    <message>
        <source>the picture is broken: %1</source>
        <translation>图片已损坏：%1</translation>
    </message>
    <message>
        <source>this is neither a PNG nor an EXR</source>
        <translation>这既不是 PNG 也不是 EXR</translation>
    </message>
    <message>
        <source>this picture carries no preset</source>
        <translation>此图片没有携带预设</translation>
    </message>
    <message>
        <source>the program cannot be started: %1</source>
        <translation>无法启动该程序：%1</translation>
    </message>
    <message>
        <source>the program ended by itself</source>
        <translation>该程序自行结束了</translation>
    </message>
    <message>
        <source>the program failed: %1</source>
        <translation>该程序失败：%1</translation>
    </message>
    <message>
        <source>the video was cancelled</source>
        <translation>视频已取消</translation>
    </message>
    <message>
        <source>Videos are made by ffmpeg: install it, or render pictures</source>
        <translation>视频由 ffmpeg 生成：请安装它，或改为渲染图片</translation>
    </message>
    <message>
        <source>no air carries this smoke</source>
        <translation>没有空气带动这团烟</translation>
    </message>
    <message>
        <source>Switch it on with air.enabled</source>
        <translation>用 air.enabled 打开</translation>
    </message>
    <message>
        <source>a volume of %1 cells</source>
        <translation>%1 个单元的体积</translation>
    </message>
    <message>
        <source>Use %1 to %2 cells along the longest edge</source>
        <translation>最长边请使用 %1 到 %2 个单元</translation>
    </message>
    <message>
        <source>Choose a PNG or EXR that Fumage has written, or the preset&apos;s own file</source>
        <translation>请选择由 Fumage 写出的 PNG 或 EXR，或预设自身的文件</translation>
    </message>
    <message>
        <source>no pass is asked for</source>
        <translation>没有选择任何通道图</translation>
    </message>
    <message>
        <source>Choose one, or a packed picture</source>
        <translation>请选择一个，或一张打包图片</translation>
    </message>
    <message>
        <source>there is no channel %1</source>
        <translation>没有通道 %1</translation>
    </message>
    <message>
        <source>a packed picture cannot be named %1</source>
        <translation>打包图片不能命名为 %1</translation>
    </message>
    <message>
        <source>Use up to %1 letters, digits, - and _</source>
        <translation>最多使用 %1 个字母、数字、- 和 _</translation>
    </message>
    <message>
        <source>Choose another name: this is the name of a pass</source>
        <translation>请换一个名称：这是某个通道图的名称</translation>
    </message>
    <message>
        <source>the packed picture %1 is not understood</source>
        <translation>无法理解打包图片 %1</translation>
    </message>
    <message>
        <source>Write masks=shadow,temperature,alpha, and @1/2 to @1/%1 after it for a smaller one</source>
        <translation>请写成 masks=shadow,temperature,alpha，需要较小的图片时在后面加 @1/2 到 @1/%1</translation>
    </message>
    <message>
        <source>the packed picture %1 has %2 channels</source>
        <translation>打包图片 %1 有 %2 个通道</translation>
    </message>
    <message>
        <source>there are %1 packed pictures</source>
        <translation>有 %1 张打包图片</translation>
    </message>
    <message>
        <source>Use up to %1</source>
        <translation>最多 %1 张</translation>
    </message>
    <message>
        <source>two packed pictures are named %1</source>
        <translation>有两张打包图片名为 %1</translation>
    </message>
    <message>
        <source>cells of %1 x %2 pixels cannot be divided by %3, as %4 asks for</source>
        <translation>%1 x %2 像素的单元格不能按 %4 的要求除以 %3</translation>
    </message>
    <message>
        <source>Choose another size of a cell, or another part</source>
        <translation>请选择另一单元格大小，或另一比例</translation>
    </message>
    <message>
        <source>%1 x %2 cells fill no sheet whose sides are powers of two</source>
        <translation>%1 x %2 个单元格无法填满边长为 2 的幂的序列帧图集</translation>
    </message>
    <message>
        <source>Choose columns and rows from 1, 2, 4, 8, 16, 32 and 64</source>
        <translation>列数和行数请选 1、2、4、8、16、32 或 64</translation>
    </message>
    <message>
        <source>the points %1 do not lie between 0 and 1, from left to right</source>
        <translation>点 %1 不在 0 到 1 之间或没有从左到右排列</translation>
    </message>
    <message>
        <source>Write [[0, 0], [0.3, 0.6], [1, 1]]</source>
        <translation>请写成 [[0, 0], [0.3, 0.6], [1, 1]]</translation>
    </message>
    <message>
        <source>a loop is not trimmed: without its empty frames it would no longer close</source>
        <translation>循环不能裁剪：去掉空帧后将无法首尾相接</translation>
    </message>
    <message>
        <source>Switch the loop off, or the trimming</source>
        <translation>请关闭循环，或关闭裁剪</translation>
    </message>
    <message>
        <source>Use one to four: red, green, blue and alpha</source>
        <translation>使用一到四个：红、绿、蓝和 alpha</translation>
    </message>
    <message>
        <source>no sheet fits into %1 bytes, or the frames fill none</source>
        <translation>没有序列帧图集能放进 %1 字节，或帧数不足以填满</translation>
    </message>
    <message>
        <source>Allow more memory, fewer passes or more frames</source>
        <translation>请增加内存、减少通道图或增加帧数</translation>
    </message>
    <message>
        <source>%1 has no way to write %2 in the names of files</source>
        <translation>%1 无法在文件名中写入 %2</translation>
    </message>
    <message>
        <source>Choose another name or folder</source>
        <translation>请选择其他名称或文件夹</translation>
    </message>
    <message>
        <source>only the colour can be joined of frames</source>
        <translation>只有颜色可以由各帧拼合</translation>
    </message>
    <message>
        <source>Render a flipbook for its other passes</source>
        <translation>其他通道图请渲染序列图集</translation>
    </message>
    <message>
        <source>this is no picture of %1 x %2 pixels with colour and alpha</source>
        <translation>这不是带颜色和 Alpha 的 %1 x %2 像素图片</translation>
    </message>
    <message>
        <source>Render the frames anew, as EXR and in the preset&apos;s size</source>
        <translation>请按预设的尺寸以 EXR 重新渲染各帧</translation>
    </message>
    <message>
        <source>%1 is missing in the manifest, or of another type</source>
        <translation>清单中缺少 %1，或其类型不符</translation>
    </message>
    <message>
        <source>this is not a manifest</source>
        <translation>这不是清单</translation>
    </message>
    <message>
        <source>Manifests are written by --manifest</source>
        <translation>清单由 --manifest 写出</translation>
    </message>
    <message>
        <source>the manifest has another version than the %1 that this program reads</source>
        <translation>清单的版本不是本程序可读取的版本 %1</translation>
    </message>
    <message>
        <source>Check it with the Fumage that wrote it</source>
        <translation>请用写出它的 Fumage 检查</translation>
    </message>
    <message>
        <source>the manifest names %1, which lies outside of its folder</source>
        <translation>清单提到的 %1 位于其文件夹之外</translation>
    </message>
    <message>
        <source>Do not trust it, and have it written anew</source>
        <translation>请勿信任它，并重新写出</translation>
    </message>
    <message>
        <source>the manifest has %1 for a hash</source>
        <translation>清单中的哈希值是 %1</translation>
    </message>
    <message>
        <source>the manifest has a frame that is no number from 0 to %1</source>
        <translation>清单中有一帧不是 0 到 %1 的数字</translation>
    </message>
    <message>
        <source>the folder cannot be read: %1</source>
        <translation>无法读取文件夹：%1</translation>
    </message>
    <message>
        <source>%1 does not lie in the folder of its manifest</source>
        <translation>%1 不在其清单所在的文件夹中</translation>
    </message>
    <message>
        <source>Name one in the folder of the pictures, or above it</source>
        <translation>请指定图片所在文件夹或其上级文件夹中的清单</translation>
    </message>
    <message>
        <source>what this manifest is of cannot be rendered again</source>
        <translation>此清单所记录的内容无法重新渲染</translation>
    </message>
    <message>
        <source>interrupted</source>
        <translation>已中断</translation>
    </message>
    <message>
        <source>there is no manifest in this folder</source>
        <translation>此文件夹中没有清单</translation>
    </message>
    <message>
        <source>Write pictures with --manifest</source>
        <translation>请用 --manifest 写出图片</translation>
    </message>
    <message>
        <source>the manifests name none of the frames %1 to %2</source>
        <translation>清单中没有第 %1 到 %2 帧</translation>
    </message>
    <message>
        <source>a channel of the picture has fewer numbers than there are pixels</source>
        <translation>图片的一个通道的数值少于像素数</translation>
    </message>
    <message>
        <source>this is neither a PNG nor a TGA</source>
        <translation>这既不是 PNG 也不是 TGA</translation>
    </message>
    <message>
        <source>it is no TGA that Fumage has written, or not whole</source>
        <translation>它不是 Fumage 写出的 TGA，或不完整</translation>
    </message>
    <message>
        <source>expected a text in quotes</source>
        <translation>此处应为带引号的文本</translation>
    </message>
    <message>
        <source>a text of %1 bytes</source>
        <translation>文本有 %1 字节</translation>
    </message>
    <message>
        <source>Write at most %1</source>
        <translation>最多写 %1 字节</translation>
    </message>
    <message>
        <source>there is a zero byte in the text</source>
        <translation>文本中有零字节</translation>
    </message>
    <message>
        <source>expected true or false</source>
        <translation>此处应为 true 或 false</translation>
    </message>
    <message>
        <source>expected a whole number from %1 to %2</source>
        <translation>此处应为 %1 到 %2 的整数</translation>
    </message>
    <message>
        <source>%1 is not known here</source>
        <translation>此处不认识 %1</translation>
    </message>
    <message>
        <source>Choose from %1</source>
        <translation>请从 %1 中选择</translation>
    </message>
    <message>
        <source>expected a list of up to %1 texts such as &quot;masks=shadow,alpha&quot;</source>
        <translation>此处应为最多 %1 个文本的列表，例如 &quot;masks=shadow,alpha&quot;</translation>
    </message>
    <message>
        <source>a list of jobs of %1 bytes</source>
        <translation>任务列表有 %1 字节</translation>
    </message>
    <message>
        <source>Lists have at most %1</source>
        <translation>列表最多为 %1</translation>
    </message>
    <message>
        <source>this JSON is not a list of Fumage&apos;s jobs</source>
        <translation>此 JSON 不是 Fumage 的任务列表</translation>
    </message>
    <message>
        <source>A list begins with &quot;format&quot;: &quot;fumage-jobs&quot;</source>
        <translation>列表以 &quot;format&quot;: &quot;fumage-jobs&quot; 开头</translation>
    </message>
    <message>
        <source>the version of the list is missing, or not one up to %1, which this program reads</source>
        <translation>列表缺少版本，或版本不在本程序可读取的范围内（至 %1）</translation>
    </message>
    <message>
        <source>%1: expected a list in brackets [ ]</source>
        <translation>%1：此处应为方括号 [ ] 中的列表</translation>
    </message>
    <message>
        <source>a list of %1 jobs</source>
        <translation>列表有 %1 个任务</translation>
    </message>
    <message>
        <source>a job is an object in braces { }</source>
        <translation>任务是花括号 { } 中的对象</translation>
    </message>
    <message>
        <source>the job %1 names no file that it writes</source>
        <translation>任务 %1 没有指定要写入的文件</translation>
    </message>
    <message>
        <source>Write &quot;output&quot;: &quot;smoke.png&quot;</source>
        <translation>请写 &quot;output&quot;: &quot;smoke.png&quot;</translation>
    </message>
    <message>
        <source>a job has no %1</source>
        <translation>任务没有 %1</translation>
    </message>
    <message>
        <source>the job %1 has no preset</source>
        <translation>任务 %1 没有预设</translation>
    </message>
    <message>
        <source>Write it as &quot;preset&quot;, whole or as its name</source>
        <translation>请将其写为 &quot;preset&quot;，可以是完整内容或名称</translation>
    </message>
    <message>
        <source>the jobs write more than %1 files</source>
        <translation>这些任务写入的文件超过 %1 个</translation>
    </message>
    <message>
        <source>Make two lists of them</source>
        <translation>请分成两个列表</translation>
    </message>
    <message>
        <source>%1 would write over a file of %2</source>
        <translation>%1 会覆盖 %2 的文件</translation>
    </message>
    <message>
        <source>%1 would overwrite the preset that %2 is made of</source>
        <translation>%1 会覆盖 %2 所依据的预设</translation>
    </message>
    <message>
        <source>Write colour,six-way,motion</source>
        <translation>请写 colour,six-way,motion</translation>
    </message>
    <message>
        <source>there is no pass %1</source>
        <translation>没有通道图 %1</translation>
    </message>
    <message>
        <source>%1 exports are waiting already</source>
        <translation>已有 %1 个导出在等待</translation>
    </message>
    <message>
        <source>Wait until some are done, or remove some</source>
        <translation>请等待部分完成，或移除一些</translation>
    </message>
    <message>
        <source>the emitter&apos;s place or velocity is no number</source>
        <translation>发射器的位置或速度不是数值</translation>
    </message>
    <message>
        <source>Pass finite numbers</source>
        <translation>请传入有限的数值</translation>
    </message>
    <message>
        <source>the emitter&apos;s normal has no direction</source>
        <translation>发射器的法线没有方向</translation>
    </message>
    <message>
        <source>Pass a normal that is not zero</source>
        <translation>请传入不为零的法线</translation>
    </message>
    <message>
        <source>%1 particles are not possible</source>
        <translation>无法使用 %1 个粒子</translation>
    </message>
    <message>
        <source>Ask for 1 to %1, or 0 for as many as the effect has</source>
        <translation>请取 1 到 %1，或取 0 表示与效果相同的数量</translation>
    </message>
    <message>
        <source>%1 steps a second are not possible</source>
        <translation>无法每秒计算 %1 步</translation>
    </message>
    <message>
        <source>Ask for 1 to %1, or 0 for those of the effect</source>
        <translation>请取 1 到 %1，或取 0 表示使用效果自己的步数</translation>
    </message>
    <message>
        <source>a budget below 0 or less than one step at once is not possible</source>
        <translation>时间预算不能小于 0，每次也不能少于一步</translation>
    </message>
    <message>
        <source>Ask for 0 ms or more, and for 1 step or more</source>
        <translation>请取 0 毫秒或更多，以及 1 步或更多</translation>
    </message>
    <message>
        <source>time that goes back, or is no number, is not possible</source>
        <translation>时间不能倒退，也必须是数值</translation>
    </message>
    <message>
        <source>Pass the seconds since the last step, 0 or more</source>
        <translation>请传入距上一步的秒数，0 或更多</translation>
    </message>
    <message>
        <source>Only frames and flipbooks can; of others the files are checked</source>
        <translation>只有帧和序列帧图集可以；其他内容只检查文件</translation>
    </message>
    <message>
        <source>Choose some that have been rendered, as pictures or in a flipbook</source>
        <translation>请选择渲染过的帧：单独的图片，或序列帧图集中的帧</translation>
    </message>
    <message>
        <source>another program is using it</source>
        <translation>另一个程序正在使用它</translation>
    </message>
    <message>
        <source>Close it there, or choose another name</source>
        <translation>请在那里将其关闭，或选择其他名称</translation>
    </message>
    <message>
        <source>this is not written as a stream</source>
        <translation>此内容不能以流的形式写出</translation>
    </message>
    <message>
        <source>Choose more frames or fewer columns and rows, such as %1x%2</source>
        <translation>请选择更多帧，或更少的列和行，例如 %1x%2</translation>
    </message>
    <message>
        <source>the frame rate %1 is not understood</source>
        <translation>无法理解帧率 %1</translation>
    </message>
    <message>
        <source>Write 24, 23.976 or 24000/1001, from 1 to %1 frames a second</source>
        <translation>请写成 24、23.976 或 24000/1001，每秒 1 至 %1 帧</translation>
    </message>
    <message>
        <source>expected a number from %1 to %2</source>
        <translation>应为 %1 到 %2 的数</translation>
    </message>
    <message>
        <source>frames %1 are no whole turn of the loop of %2 frames, so they are played once: frames %3 close it</source>
        <translation>帧 %1 不是 %2 帧循环的完整一圈，因此只播放一次：帧 %3 可使其首尾相接</translation>
    </message>
    <message>
        <source>frames %1 are no whole turn of the loop of %2 frames, so they are played once</source>
        <translation>帧 %1 不是 %2 帧循环的完整一圈，因此只播放一次</translation>
    </message>
    <message>
        <source>the curve of the frames does not end where it begins, so they are played once</source>
        <translation>帧的曲线没有回到起点，因此只播放一次</translation>
    </message>
    <message>
        <source>one frame of %1 is in the GIF: more than 50 pictures a second play slowly in browsers</source>
        <translation>GIF 中每 %1 帧只取一帧：每秒超过 50 张图在浏览器中会播放得很慢</translation>
    </message>
    <message>
        <source>H.264 has even edges: the video is %1 x %2 pixels, the last column or row twice</source>
        <translation>H.264 的边长必须为偶数：视频为 %1 x %2 像素，最后一列或一行重复一次</translation>
    </message>
    <message>
        <source>voxels of %1 m</source>
        <translation>%1 米的体素</translation>
    </message>
    <message>
        <source>Use %1 to %2 m</source>
        <translation>请使用 %1 到 %2 米</translation>
    </message>
    <message>
        <source>the box around the smoke of frame %1 has more than %2 voxels of %3 m</source>
        <translation>第 %1 帧的烟的包围盒超过 %2 个边长 %3 米的体素</translation>
    </message>
    <message>
        <source>Choose larger voxels</source>
        <translation>请选择更大的体素</translation>
    </message>
    <message>
        <source>Please report it, with the preset that you had</source>
        <translation>请连同当时的预设一起报告此问题</translation>
    </message>
    <message>
        <source>something failed inside Fumage: %1</source>
        <translation>Fumage 内部出错：%1</translation>
    </message>
    <message>
        <source>something failed inside Fumage</source>
        <translation>Fumage 内部出错</translation>
    </message>
    <message>
        <source>a task of %1 has at most %2 frames</source>
        <translation>%1 的一个任务最多有 %2 帧</translation>
    </message>
    <message>
        <source>Choose fewer frames a task</source>
        <translation>请减少每个任务的帧数</translation>
    </message>
    <message>
        <source>%1 plays this sheet in %2 s instead of %3 s, for it counts time in whole steps: %4 frames in its cells, or %5 frames a second, would keep the speed</source>
        <translation>%1 会用 %2 秒而不是 %3 秒播放此序列帧图集，因为它按整步计时：让单元格包含 %4 帧，或使用每秒 %5 帧，即可保持速度</translation>
    </message>
    <message>
        <source>%1 plays this sheet in %2 s instead of %3 s, for it counts time in whole steps: %4 frames a second would keep the speed</source>
        <translation>%1 会用 %2 秒而不是 %3 秒播放此序列帧图集，因为它按整步计时：使用每秒 %4 帧即可保持速度</translation>
    </message>
    <message>
        <source>Unreal&apos;s FlipBook_MotionVectors finds its cells only where there are as many columns as rows: use %1 x %1 cells, or a material of your own</source>
        <translation>Unreal 的 FlipBook_MotionVectors 只有在列数与行数相同时才能找到单元格：请使用 %1 × %1 个单元格，或使用自己的材质</translation>
    </message>
    <message>
        <source>control characters</source>
        <translation>控制字符</translation>
    </message>
    <message>
        <source>Choose another name or another disk</source>
        <translation>请选择其他名称或其他磁盘</translation>
    </message>
    <message>
        <source>the system has no more files, processes or memory to give: %1</source>
        <translation>系统已没有可用的文件、进程或内存：%1</translation>
    </message>
    <message>
        <source>End other programs, raise its limits (ulimit -n, -u, -v), or try again later</source>
        <translation>请关闭其他程序、提高系统限制（ulimit -n、-u、-v），或稍后再试</translation>
    </message>
    <message>
        <source>the system gives no more threads, files or memory: %1</source>
        <translation>系统不再提供线程、文件或内存：%1</translation>
    </message>
    <message>
        <source>End other programs, raise its limits (ulimit -u, -n, -v), or use --threads 1</source>
        <translation>请关闭其他程序、提高系统限制（ulimit -u、-n、-v），或使用 --threads 1</translation>
    </message>
    <message>
        <source>the system refuses what is needed: %1</source>
        <translation>系统拒绝了所需的操作：%1</translation>
    </message>
    <message>
        <source>Use another folder or another machine</source>
        <translation>请使用其他文件夹或其他机器</translation>
    </message>
    <message>
        <source>the program has written no video</source>
        <translation>该程序没有写出视频</translation>
    </message>
    <message>
        <source>Let FUMAGE_FFMPEG name an ffmpeg, or leave it out</source>
        <translation>请让 FUMAGE_FFMPEG 指向 ffmpeg，或不设置它</translation>
    </message>
    <message>
        <source>the text is %1</source>
        <translation>文本是 %1</translation>
    </message>
    <message>
        <source>the smoke has left all bounds: a particle is nowhere</source>
        <translation>烟雾已超出所有边界：某个粒子没有位置</translation>
    </message>
    <message>
        <source>the box of the air has no finite size</source>
        <translation>空气盒的大小不是有限的</translation>
    </message>
    <message>
        <source>Turn air.fit off and give air.size, or make the emitter smaller or slower</source>
        <translation>请关闭 air.fit 并给出 air.size，或把发射器调小、调慢</translation>
    </message>
    <message>
        <source>the air of a loop of %1 frames is baked whole before its first picture, which would take very long</source>
        <translation>%1 帧循环的空气须在第一幅画面之前全部烘焙，这会花很长时间</translation>
    </message>
    <message>
        <source>Shorten timeline.length, lower air.resolution, or turn timeline.loop off</source>
        <translation>请缩短 timeline.length、降低 air.resolution，或关闭 timeline.loop</translation>
    </message>
    <message>
        <source>the air has to be moved on for a whole life of the smoke before its first picture, which would take very long</source>
        <translation>第一幅画面之前须先推进烟雾一整个寿命的空气，这会花很长时间</translation>
    </message>
    <message>
        <source>Turn timeline.prewarm off, raise life.fade_rate, or lower air.resolution</source>
        <translation>请关闭 timeline.prewarm、提高 life.fade_rate，或降低 air.resolution</translation>
    </message>
    <message>
        <source>nobody says which folder ~ is</source>
        <translation>无法得知 ~ 指的是哪个文件夹</translation>
    </message>
    <message>
        <source>Write the whole path</source>
        <translation>请写出完整路径</translation>
    </message>
    <message>
        <source>this name is not UTF-8, and has to be written down in a file beside it</source>
        <translation>此名称不是 UTF-8，而它必须写入旁边的文件</translation>
    </message>
    <message>
        <source>the preset that this picture carries is damaged, or longer than the %1 bytes that are read</source>
        <translation>此图片携带的预设已损坏，或长度超过可读取的 %1 字节</translation>
    </message>
    <message>
        <source>Choose another picture, or the preset&apos;s own file</source>
        <translation>请选择其他图片，或预设自身的文件</translation>
    </message>
    <message>
        <source>this is neither a PNG nor a TGA nor an EXR</source>
        <translation>这既不是 PNG，也不是 TGA 或 EXR</translation>
    </message>
    <message>
        <source>the preset that this picture carries cannot be read: %1</source>
        <translation>此图片携带的预设无法读取：%1</translation>
    </message>
    <message>
        <source>Choose from alpha, density, depth, temperature, shadow, colour.r, six-way-a.r, six-way-b.r, motion.r, normal.r, emission.r, albedo.r, their .g, .b and .a, 0 and 1</source>
        <translation>可选：alpha、density、depth、temperature、shadow、colour.r、six-way-a.r、six-way-b.r、motion.r、normal.r、emission.r、albedo.r，它们的 .g、.b 和 .a，以及 0 和 1</translation>
    </message>
    <message>
        <source>Write key=value, for example wind.strength=1.5</source>
        <translation>请写成 键=值，例如 wind.strength=1.5</translation>
    </message>
    <message>
        <source>Lower forces and speeds, such as motion.buoyancy, source.expansion or turbulence.strength</source>
        <translation>请减小力和速度，例如 motion.buoyancy、source.expansion 或 turbulence.strength</translation>
    </message>
    <message>
        <source>%1 is fixed while the simulation runs</source>
        <translation>模拟运行期间 %1 是固定的</translation>
    </message>
    <message>
        <source>Keep it, or start a new simulation</source>
        <translation>请保持不变，或开始新的模拟</translation>
    </message>
    <message>
        <source>the eye&apos;s place is no number</source>
        <translation>视点位置不是数字</translation>
    </message>
    <message>
        <source>Pass finite numbers, or no eye</source>
        <translation>请给出有限的数字，或不给视点</translation>
    </message>
    <message>
        <source>the preset has %1 layers, from 1 to %2 are possible</source>
        <translation>预设有 %1 个图层，可为 1 到 %2 个</translation>
    </message>
    <message>
        <source>%1: expected %2</source>
        <translation>%1：应为%2</translation>
    </message>
    <message>
        <source>a text in quotes</source>
        <translation>引号中的文本</translation>
    </message>
    <message>
        <source>a layer&apos;s name of %1 bytes</source>
        <translation>%1 字节的图层名称</translation>
    </message>
    <message>
        <source>Names have at most %1</source>
        <translation>名称最多 %1</translation>
    </message>
    <message>
        <source>a colour: %1</source>
        <translation>颜色：%1</translation>
    </message>
    <message>
        <source>there is no one layer %1</source>
        <translation>没有唯一的图层 %1</translation>
    </message>
    <message>
        <source>Name one of %1, or give its number from 1 to %2</source>
        <translation>请指定 %1 之一，或给出 1 到 %2 的编号</translation>
    </message>
    <message>
        <source>layers that are written as %1 have no other passes than %2</source>
        <translation>以 %1 方式写出的图层除 %2 外没有其他通道</translation>
    </message>
    <message>
        <source>Choose these passes, or layers alone</source>
        <translation>请选择这些通道，或选择图层各自单独（alone）</translation>
    </message>
    <message>
        <source>what is written for %1 plays one sheet</source>
        <translation>为 %1 写出的内容只播放一张图集</translation>
    </message>
    <message>
        <source>Choose another engine or none, or layers together or alone</source>
        <translation>请选择其他引擎或不选引擎，或让图层合在一起或各自单独</translation>
    </message>
    <message>
        <source>there is no one layer %1 to be born on</source>
        <translation>没有可供诞生的唯一图层 %1</translation>
    </message>
    <message>
        <source>Name a layer that no other shares its name with</source>
        <translation>请指定一个名称不与其他图层重复的图层</translation>
    </message>
    <message>
        <source>layer %1 would be born on itself, by way of %2</source>
        <translation>图层 %1 会经由 %2 诞生于自身</translation>
    </message>
    <message>
        <source>Let one layer of the ring be born on its emitter</source>
        <translation>请让环中的一个图层诞生于其发射器</translation>
    </message>
    <message>
        <source>there is no layer number %1</source>
        <translation>没有编号为 %1 的图层</translation>
    </message>
    <message>
        <source>Give a number from 0 to %1</source>
        <translation>请给出 0 到 %1 的编号</translation>
    </message>
    <message>
        <source>this is not a PNG</source>
        <translation>这不是 PNG</translation>
    </message>
    <message>
        <source>a picture of %1 bytes</source>
        <translation>%1 字节的图片</translation>
    </message>
    <message>
        <source>Choose a PNG of at most %1 pixels an edge and %2 bytes</source>
        <translation>请选择边长不超过 %1 像素、不超过 %2 字节的 PNG</translation>
    </message>
    <message>
        <source>a PNG in base64</source>
        <translation>base64 编码的 PNG</translation>
    </message>
    <message>
        <source>this parameter cannot change over time</source>
        <translation>此参数不能随时间变化</translation>
    </message>
    <message>
        <source>Take its key frames out; parameters.md says which can</source>
        <translation>请去掉它的关键帧；parameters.md 说明哪些参数可以</translation>
    </message>
    <message>
        <source>%1 key frames, from 1 to %2 are possible</source>
        <translation>%1 个关键帧，可以有 1 到 %2 个</translation>
    </message>
    <message>
        <source>a key frame has a value of another kind</source>
        <translation>某个关键帧的值类型不符</translation>
    </message>
    <message>
        <source>a key frame has a time, value or slope that is no number</source>
        <translation>某个关键帧的时间、值或斜率不是数字</translation>
    </message>
    <message>
        <source>a key frame lies %1 s away</source>
        <translation>某个关键帧在 %1 秒处</translation>
    </message>
    <message>
        <source>Key frames lie at most %1 s away</source>
        <translation>关键帧最远在 %1 秒处</translation>
    </message>
    <message>
        <source>the key frame at %1 s comes after one at %2 s</source>
        <translation>%1 秒处的关键帧排在 %2 秒处的之后</translation>
    </message>
    <message>
        <source>Key frames stand in the order of their times, no two at the same</source>
        <translation>关键帧按时间排列，不能有两个在同一时间</translation>
    </message>
    <message>
        <source>a picture of %1 letters</source>
        <translation>%1 个字符的图片</translation>
    </message>
    <message>
        <source>the box around the smoke of frame %1 has %2 voxels, too many for %3 layers</source>
        <translation>第 %1 帧烟雾的包围盒有 %2 个体素，对 %3 个图层来说太多</translation>
    </message>
    <message>
        <source>Choose larger voxels, or the density of all layers together</source>
        <translation>请选择更大的体素，或所有图层合计的密度</translation>
    </message>
    <message>
        <source>the masks of layers are channels of EXR</source>
        <translation>图层遮罩是 EXR 的通道</translation>
    </message>
    <message>
        <source>Choose EXR, or write alpha of layers as contribution</source>
        <translation>请选择 EXR，或将图层的 alpha 写为贡献</translation>
    </message>
    <message>
        <source>masks of %1 layers for %2 pixels</source>
        <translation>%1 个图层、%2 像素的遮罩</translation>
    </message>
    <message>
        <source>Choose a smaller picture, or mute layers</source>
        <translation>请选择更小的图片，或静音图层</translation>
    </message>
    <message>
        <source>%1 does not end as it begins, so the loop jumps there</source>
        <translation>%1 的结尾与开头不同，循环在那里会跳变</translation>
    </message>
    <message>
        <source>%1 has key frames after the end of the timeline</source>
        <translation>%1 在时间轴结束之后还有关键帧</translation>
    </message>
    <message>
        <source>with its pictures the preset is longer than the %1 bytes that a file can carry: save it beside</source>
        <translation>连同图片，预设超过文件可携带的 %1 字节：请另行保存</translation>
    </message>
    <message>
        <source>layers that are written as %1 have no masks of layers</source>
        <translation>以 %1 写出的图层没有图层遮罩</translation>
    </message>
    <message>
        <source>Write layers together, or the alpha of contributions</source>
        <translation>请将图层一起写出，或写出贡献的 alpha</translation>
    </message>
    <message>
        <source>the sheet of layer %1 is missing</source>
        <translation>缺少图层 %1 的图集</translation>
    </message>
    <message>
        <source>Keep the sheets of all layers in one folder, or export them again</source>
        <translation>请把所有图层的图集放在同一文件夹，或重新导出</translation>
    </message>
    <message>
        <source>the sheet of layer %1 has %2 x %3 pixels, and not %4 x %5</source>
        <translation>图层 %1 的图集为 %2 x %3 像素，而不是 %4 x %5</translation>
    </message>
    <message>
        <source>Export the sheets of all layers together</source>
        <translation>请一起导出所有图层的图集</translation>
    </message>
    <message>
        <source>this manifest is of no sheets of layers</source>
        <translation>此清单不是图层图集的</translation>
    </message>
    <message>
        <source>Name one that was written with --layers-as, or a preset</source>
        <translation>请指定用 --layers-as 写出的清单，或一个预设</translation>
    </message>
    <message>
        <source>the name of this sheet does not say which layer it is of</source>
        <translation>此图集的名称没有说明属于哪个图层</translation>
    </message>
    <message>
        <source>Name it as it was exported, such as fire_flames.png, or its manifest</source>
        <translation>请用导出时的名称，如 fire_flames.png，或其清单</translation>
    </message>
    <message>
        <source>these sheets have no colour to be put together</source>
        <translation>这些图集没有可合成的颜色</translation>
    </message>
    <message>
        <source>Export them with colour among the passes</source>
        <translation>导出时请包含颜色通道</translation>
    </message>
    <message>
        <source>layers, their names, what is muted and what is born on what are fixed while the simulation runs</source>
        <translation>模拟运行时，图层、名称、静音以及谁生于谁是固定的</translation>
    </message>
    <message>
        <source>Keep them, or start a new simulation; a layer whose share is 0 goes out</source>
        <translation>请保持不变，或重新开始模拟；份额为 0 的图层会熄灭</translation>
    </message>
    <message>
        <source>%1 particles are too few for %2 layers</source>
        <translation>%1 个粒子对 %2 个图层来说太少</translation>
    </message>
    <message>
        <source>Ask for %1 or more</source>
        <translation>请要求 %1 个或更多</translation>
    </message>
    <message>
        <source>layer %1: %2</source>
        <translation>图层 %1：%2</translation>
    </message>
    <message>
        <source>%1: expected one of %2</source>
        <translation>%1：应为 %2 之一</translation>
    </message>
    <message>
        <source>a track has %1, %2, %3 and %4, and no %5</source>
        <translation>轨道有 %1、%2、%3 和 %4，没有 %5</translation>
    </message>
    <message>
        <source>a key frame is a list of its seconds, its value and its ease</source>
        <translation>关键帧是由秒数、值和缓动组成的列表</translation>
    </message>
    <message>
        <source>expected one of %1</source>
        <translation>应为 %1 之一</translation>
    </message>
    <message>
        <source>a slope is a number, or a list of three</source>
        <translation>斜率是一个数字，或三个数字的列表</translation>
    </message>
    <message>
        <source>a track is an object with the %1 of its parameter</source>
        <translation>轨道是带有参数 %1 的对象</translation>
    </message>
    <message>
        <source>the track of %1 is kept but has no effect</source>
        <translation>%1 的轨道被保留但不起作用</translation>
    </message>
    <message>
        <source>a second track of %1</source>
        <translation>%1 的第二条轨道</translation>
    </message>
    <message>
        <source>key frames of %1 were out of range</source>
        <translation>%1 的关键帧超出范围</translation>
    </message>
    <message>
        <source>Choose from colour, alpha, density, six-way, motion, normal, depth, emission, albedo, temperature, shadow, layer-masks and all</source>
        <translation>请从 colour、alpha、density、six-way、motion、normal、depth、emission、albedo、temperature、shadow、layer-masks 和 all 中选择</translation>
    </message>
    <message>
        <source>invalid key frame %1</source>
        <translation>无效的关键帧 %1</translation>
    </message>
    <message>
        <source>Write SECONDS:VALUE or SECONDS:VALUE:EASE, with %1 as ease</source>
        <translation>请写成 秒:值 或 秒:值:缓动，缓动可为 %1</translation>
    </message>
    <message>
        <source>%1: no %2</source>
        <translation>%1：没有 %2</translation>
    </message>
    <message>
        <source>Use one of %1</source>
        <translation>请使用 %1 之一</translation>
    </message>
    <message>
        <source>there is no marker number %1</source>
        <translation>没有编号为 %1 的标记</translation>
    </message>
    <message>
        <source>%1 changes at once at a held key frame, so what it drives changes its pace with a jerk</source>
        <translation>%1 在保持的关键帧处突变，受它驱动的运动会突然变速</translation>
    </message>
    <message>
        <source>markers after the end of the timeline: %1</source>
        <translation>时间线结束之后的标记：%1</translation>
    </message>
    <message>
        <source>markers outside of the frames of the sheet: %1</source>
        <translation>图集帧范围之外的标记：%1</translation>
    </message>
    <message>
        <source>a marker is an object with a %1 in quotes and a %2 in seconds</source>
        <translation>标记是一个对象，含带引号的 %1 和以秒计的 %2</translation>
    </message>
    <message>
        <source>%1 markers, at most %2 are possible</source>
        <translation>%1 个标记，最多可有 %2 个</translation>
    </message>
    <message>
        <source>the marker with the unknown member %1 is kept but has no effect</source>
        <translation>含未知成员 %1 的标记会保留，但不起作用</translation>
    </message>
    <message>
        <source>line %1</source>
        <translation>第 %1 行</translation>
    </message>
    <message>
        <source>%1 is no time</source>
        <translation>%1 不是时间</translation>
    </message>
    <message>
        <source>Write seconds, then the value, with commas between</source>
        <translation>请写秒数，然后是值，用逗号分隔</translation>
    </message>
    <message>
        <source>the name of a marker is not UTF-8</source>
        <translation>标记名称不是 UTF-8</translation>
    </message>
    <message>
        <source>a marker&apos;s name of %1 bytes</source>
        <translation>%1 字节的标记名称</translation>
    </message>
    <message>
        <source>the name of a marker is empty or has control characters: %1</source>
        <translation>标记名称为空或含控制字符：%1</translation>
    </message>
    <message>
        <source>Name it with letters, digits, spaces and signs</source>
        <translation>请用字母、数字、空格和符号命名</translation>
    </message>
    <message>
        <source>the time of a marker is no number</source>
        <translation>标记的时间不是数字</translation>
    </message>
    <message>
        <source>a marker lies at %1 s</source>
        <translation>某个标记在 %1 秒处</translation>
    </message>
    <message>
        <source>Markers lie from 0 to %1 s</source>
        <translation>标记应在 0 到 %1 秒之间</translation>
    </message>
    <message>
        <source>the marker at %1 s comes after one at %2 s</source>
        <translation>%1 秒处的标记排在 %2 秒处的之后</translation>
    </message>
    <message>
        <source>Markers stand in the order of their times</source>
        <translation>标记按时间顺序排列</translation>
    </message>
    <message>
        <source>invalid marker %1</source>
        <translation>无效的标记 %1</translation>
    </message>
    <message>
        <source>Write NAME=SECONDS, with ; between several times, or NAME= to take them out</source>
        <translation>请写 名称=秒数，多个时间用 ; 分隔，或写 名称= 以去掉它们</translation>
    </message>
    <message>
        <source>%1 is no whole number from 1 to %2</source>
        <translation>%1 不是 1 到 %2 之间的整数</translation>
    </message>
    <message>
        <source>cells_per_second is no number above 0, %1 at most</source>
        <translation>cells_per_second 不是大于 0 且不超过 %1 的数</translation>
    </message>
    <message>
        <source>a picture has no name of a file beside it</source>
        <translation>某个图片没有指向旁边文件的名称</translation>
    </message>
    <message>
        <source>Export the flipbook anew</source>
        <translation>请重新导出序列图</translation>
    </message>
    <message>
        <source>the picture has another size than its description says</source>
        <translation>图片尺寸与其描述不符</translation>
    </message>
    <message>
        <source>the sheet has %1 x %2 pixels, which is more than can be played here</source>
        <translation>序列图为 %1 x %2 像素，超出此处可播放的范围</translation>
    </message>
    <message>
        <source>the flipbook has no picture of its colours</source>
        <translation>序列图缺少颜色图片</translation>
    </message>
    <message>
        <source>the motion vectors have no scale</source>
        <translation>运动矢量没有比例</translation>
    </message>
    <message>
        <source>this is no description of a flipbook</source>
        <translation>这不是序列图的描述文件</translation>
    </message>
    <message>
        <source>a free key frame has two slopes, a linear or held one may have that before it, and a smooth one has none</source>
        <translation>自由关键帧有两个斜率，线性或保持关键帧可有其前的斜率，平滑关键帧没有</translation>
    </message>
    <message>
        <source>layers are born on %1 particles of others in all, at most %2 are possible</source>
        <translation>各图层共诞生于其他图层的 %1 个粒子上，最多 %2 个</translation>
    </message>
    <message>
        <source>Give fewer particles to the layers that others are born on</source>
        <translation>减少其他图层所诞生于其上的图层的粒子数</translation>
    </message>
    <message>
        <source>there is no one layer %1, but %2</source>
        <translation>没有唯一的图层 %1，而有 %2</translation>
    </message>
    <message>
        <source>Write the name as it is, or where they share it the number</source>
        <translation>请照原样写名称；若名称相同，请写编号</translation>
    </message>
    <message>
        <source>no layer is named</source>
        <translation>没有指定图层</translation>
    </message>
    <message>
        <source>Name layers, or leave the option out</source>
        <translation>请指定图层，或省略该选项</translation>
    </message>
</context>
<context>
    <name>fumage::ui::MockStage</name>
    <message>
        <source>The sheet as it plays in an engine</source>
        <translation>序列图在引擎中的播放效果</translation>
    </message>
</context>
<context>
    <name>fumage::ui::NoiseCanvas</name>
    <message>
        <source>Noise texture</source>
        <translation>噪声纹理</translation>
    </message>
    <message>
        <source>Wheel: zoom. Left button: move the profile line. Middle button: move the picture. Double-click: whole tile.</source>
        <translation>滚轮：缩放。左键：移动剖面线。中键：移动图像。双击：整块。</translation>
    </message>
</context>
<context>
    <name>fumage::ui::NoisePane</name>
    <message>
        <source>Channel</source>
        <translation>通道</translation>
    </message>
    <message>
        <source>Texture</source>
        <translation>纹理</translation>
    </message>
    <message>
        <source>Sum of octaves</source>
        <translation>倍频程之和</translation>
    </message>
    <message>
        <source>Alpha of a particle</source>
        <translation>粒子的透明度</translation>
    </message>
    <message>
        <source>What is shown: the grey values that particles read, the noise before sharpness, or what is left under the mask of a particle</source>
        <translation>显示内容：粒子读取的灰度值、锐化之前的噪声，或粒子遮罩下所剩的部分</translation>
    </message>
    <message>
        <source>Slice</source>
        <translation>切片</translation>
    </message>
    <message>
        <source>Which slice of the 3D noise; particles go through them as they age</source>
        <translation>三维噪声的哪一个切片；粒子随年龄依次经过它们</translation>
    </message>
    <message>
        <source>Without smoothing and sharpness</source>
        <translation>不含平滑和锐度</translation>
    </message>
    <message>
        <source>Three by three tiles, to judge the seams</source>
        <translation>三乘三平铺，用来检查接缝</translation>
    </message>
    <message>
        <source>Profile along a line, with amplitude and wavelength</source>
        <translation>沿一条线的剖面，标出振幅和波长</translation>
    </message>
    <message>
        <source>Go through the slices</source>
        <translation>依次播放切片</translation>
    </message>
    <message>
        <source>Export the noise texture</source>
        <translation>导出噪声纹理</translation>
    </message>
    <message>
        <source>Export the noise texture…</source>
        <translation>导出噪声纹理…</translation>
    </message>
    <message>
        <source>%1 × %1 px   mean %2   deviation %3</source>
        <translation>%1 × %1 像素   均值 %2   偏差 %3</translation>
    </message>
    <message>
        <source>There is not enough memory for this texture.</source>
        <translation>内存不足以生成这张纹理。</translation>
    </message>
</context>
<context>
    <name>fumage::ui::NoisePlots</name>
    <message>
        <source>Profile and histogram of the noise</source>
        <translation>噪声的剖面和直方图</translation>
    </message>
    <message>
        <source>amplitude %1</source>
        <translation>振幅 %1</translation>
    </message>
    <message>
        <source>λ %1</source>
        <translation>λ %1</translation>
    </message>
</context>
<context>
    <name>fumage::ui::NumberField</name>
    <message>
        <source>“%1” is not a number.</source>
        <translation>“%1”不是数字。</translation>
    </message>
    <message>
        <source>“%1” is not a number in %2.</source>
        <translation>“%1”不是以 %2 为单位的数字。</translation>
    </message>
    <message>
        <source>%1 is the largest.</source>
        <translation>最大为 %1。</translation>
    </message>
    <message>
        <source>%1 is the smallest.</source>
        <translation>最小为 %1。</translation>
    </message>
</context>
<context>
    <name>fumage::ui::PackRow</name>
    <message>
        <source>Name of the packed picture</source>
        <translation>打包图片的名称</translation>
    </message>
    <message>
        <source>Stands behind the name of the sheet</source>
        <translation>接在序列帧图集名称之后</translation>
    </message>
    <message>
        <source>Size of the packed picture</source>
        <translation>打包图片的大小</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>移除</translation>
    </message>
    <message>
        <source>Red</source>
        <translation>红</translation>
    </message>
    <message>
        <source>Green</source>
        <translation>绿</translation>
    </message>
    <message>
        <source>Blue</source>
        <translation>蓝</translation>
    </message>
    <message>
        <source>Alpha</source>
        <translation>Alpha</translation>
    </message>
    <message>
        <source>Full size</source>
        <translation>完整大小</translation>
    </message>
    <message>
        <source>Nothing</source>
        <translation>无</translation>
    </message>
</context>
<context>
    <name>fumage::ui::ParameterGroup</name>
    <message>
        <source>Paste into “%1”</source>
        <translation>粘贴到“%1”</translation>
    </message>
    <message>
        <source>Reset “%1”</source>
        <translation>重置“%1”</translation>
    </message>
    <message>
        <source>Reset the group</source>
        <translation>重置该组</translation>
    </message>
    <message>
        <source>Copy the group</source>
        <translation>复制该组</translation>
    </message>
    <message>
        <source>Paste into the group</source>
        <translation>粘贴到该组</translation>
    </message>
    <message>
        <source>Expand all groups</source>
        <translation>展开所有组</translation>
    </message>
    <message>
        <source>Collapse all groups</source>
        <translation>折叠所有组</translation>
    </message>
</context>
<context>
    <name>fumage::ui::ParameterRow</name>
    <message>
        <source>Paste</source>
        <translation>粘贴</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>重置</translation>
    </message>
    <message>
        <source>Reset to the default</source>
        <translation>重置为默认值</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>复制</translation>
    </message>
    <message>
        <source>Copy as --set</source>
        <translation>复制为 --set</translation>
    </message>
    <message>
        <source>Lock against randomising</source>
        <translation>锁定，不参与随机</translation>
    </message>
    <message>
        <source>Locked against randomising; press to unlock</source>
        <translation>已锁定，不会随机改变；按下解锁</translation>
    </message>
    <message>
        <source>Set a key frame here</source>
        <translation>在此设置关键帧</translation>
    </message>
    <message>
        <source>Remove the key frame here</source>
        <translation>移除此处的关键帧</translation>
    </message>
    <message>
        <source>Remove all key frames</source>
        <translation>移除所有关键帧</translation>
    </message>
</context>
<context>
    <name>Parameters</name>
    <message>
        <source>Particles</source>
        <translation>粒子</translation>
    </message>
    <message>
        <source>How many particles are alive once the smoke is warm. Many small ones read as smoke, few large ones as sprites.</source>
        <translation>烟雾充满之后存活的粒子数。又多又小的看起来是烟，又少又大的看起来是贴片。</translation>
    </message>
    <message>
        <source>2012 model, table of results</source>
        <translation>2012 年模型, 结果表</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>形状</translation>
    </message>
    <message>
        <source>The surface or body on which particles are born.</source>
        <translation>粒子诞生的表面或体。</translation>
    </message>
    <message>
        <source>2012 model, eq. I (rectangle)</source>
        <translation>2012 年模型, 式 I (矩形)</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>半径</translation>
    </message>
    <message>
        <source>Radius of the disc or sphere.</source>
        <translation>圆盘或球的半径。</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>宽度</translation>
    </message>
    <message>
        <source>2012 model, eq. I</source>
        <translation>2012 年模型, 式 I</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>深度</translation>
    </message>
    <message>
        <source>Normal</source>
        <translation>法线</translation>
    </message>
    <message>
        <source>The direction N that the emitter faces and sends particles in.</source>
        <translation>发射器所朝并发射粒子的方向 N。</translation>
    </message>
    <message>
        <source>2012 model, eq. I and II</source>
        <translation>2012 年模型, 式 I 与 II</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>Centre of the emitter.</source>
        <translation>发射器的中心。</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>Speed at birth along the normal.</source>
        <translation>诞生时沿法线的速度。</translation>
    </message>
    <message>
        <source>2012 model, eq. II (1 there)</source>
        <translation>2012 年模型, 式 II (原为 1)</translation>
    </message>
    <message>
        <source>Speed variation</source>
        <translation>速度随机性</translation>
    </message>
    <message>
        <source>0: every particle leaves at the full speed. 1: each component of the velocity is multiplied by its own random number.</source>
        <translation>0：每个粒子都以全速离开。1：速度的每个分量都乘以各自的随机数。</translation>
    </message>
    <message>
        <source>Cone angle</source>
        <translation>扩散</translation>
    </message>
    <message>
        <source>Half angle of the cone in which particles leave, evenly over its directions; 180 is all around.</source>
        <translation>粒子离开时所在圆锥的半角，各方向均匀；180 为四面八方。</translation>
    </message>
    <message>
        <source>Emission</source>
        <translation>发射</translation>
    </message>
    <message>
        <source>Continuous smoke, or one burst at the start of the timeline.</source>
        <translation>持续的烟，或在时间线开头爆发一次。</translation>
    </message>
    <message>
        <source>Burst duration</source>
        <translation>爆发时长</translation>
    </message>
    <message>
        <source>The time in which a burst gives birth to all of its particles.</source>
        <translation>一次爆发产生其全部粒子所用的时间。</translation>
    </message>
    <message>
        <source>Sub-frame emission</source>
        <translation>在步间诞生</translation>
    </message>
    <message>
        <source>Spreads births over the time between two steps, so that fast smoke leaves in a stream and not in sheets.</source>
        <translation>把诞生分散到两步之间的时间里，使快速的烟成流而不成片。</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>种子</translation>
    </message>
    <message>
        <source>Another seed gives another smoke of the same kind.</source>
        <translation>换一个种子就得到同类的另一团烟。</translation>
    </message>
    <message>
        <source>Buoyancy</source>
        <translation>浮力</translation>
    </message>
    <message>
        <source>Upward acceleration of smoke that is as hot as at birth; it fades as the smoke cools.</source>
        <translation>与诞生时一样热的烟的向上加速度；随烟冷却而减弱。</translation>
    </message>
    <message>
        <source>2012 model, figure 1</source>
        <translation>2012 年模型, 图 1</translation>
    </message>
    <message>
        <source>Wind</source>
        <translation>风</translation>
    </message>
    <message>
        <source>Acceleration Vw by the wind, level with the ground.</source>
        <translation>风的水平加速度 Vw。</translation>
    </message>
    <message>
        <source>2012 model, eq. III and V</source>
        <translation>2012 年模型, 式 III 与 V</translation>
    </message>
    <message>
        <source>Wind angle</source>
        <translation>风向角</translation>
    </message>
    <message>
        <source>Angle θ of the wind in the horizontal X-Z plane; 0 blows along +X, 90 along +Z, against the sense of the rotation.</source>
        <translation>风在水平 X-Z 平面内的角度 θ；0 沿 +X 吹，90 沿 +Z 吹，与旋转的方向相反。</translation>
    </message>
    <message>
        <source>Gravity</source>
        <translation>重力</translation>
    </message>
    <message>
        <source>Gravity g; divided by the mass it pulls particles down.</source>
        <translation>重力 g；除以质量后把粒子向下拉。</translation>
    </message>
    <message>
        <source>2012 model, eq. IV</source>
        <translation>2012 年模型, 式 IV</translation>
    </message>
    <message>
        <source>Drag</source>
        <translation>阻力</translation>
    </message>
    <message>
        <source>Air resistance: the share of its velocity that a particle loses a second.</source>
        <translation>空气阻力：粒子每秒失去的速度比例。</translation>
    </message>
    <message>
        <source>Cooling</source>
        <translation>冷却</translation>
    </message>
    <message>
        <source>How fast the heat that lifts the smoke is lost.</source>
        <translation>使烟上升的热量散失得多快。</translation>
    </message>
    <message>
        <source>Randomness</source>
        <translation>随机性</translation>
    </message>
    <message>
        <source>0: forces act steadily. 1: each is multiplied by a new random number every frame and acts as a random walk. Steps per frame do not change how far it leads; a higher frame rate shortens it.</source>
        <translation>0：力稳定作用。1：每一帧都乘以新的随机数，如同随机游走。每帧步数不改变它走多远；更高的帧率使它变短。</translation>
    </message>
    <message>
        <source>2012 model, eq. XI and XII (1 there)</source>
        <translation>2012 年模型, 式 XI 与 XII (原为 1)</translation>
    </message>
    <message>
        <source>Gusts</source>
        <translation>阵风</translation>
    </message>
    <message>
        <source>How much the strength and direction of the wind wander.</source>
        <translation>风的强度和方向游移多少。</translation>
    </message>
    <message>
        <source>Gust rate</source>
        <translation>阵风频率</translation>
    </message>
    <message>
        <source>How often the wind changes.</source>
        <translation>风变化得多频繁。</translation>
    </message>
    <message>
        <source>Heat variation</source>
        <translation>热量差异</translation>
    </message>
    <message>
        <source>How much the heat at birth differs from one particle to the next, around the same mean; hot ones run ahead.</source>
        <translation>各粒子诞生时热量的差别，平均值不变；热的跑在前面。</translation>
    </message>
    <message>
        <source>Attract to axis</source>
        <translation>向轴拉力</translation>
    </message>
    <message>
        <source>Acceleration towards the vertical line through the emitter, per metre of distance: the inflow that keeps a plume together.</source>
        <translation>朝向过发射器竖直线的加速度，按每米距离计：使烟柱聚拢的入流。</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>旋转</translation>
    </message>
    <message>
        <source>2012 model, whole-body rotation (0 there)</source>
        <translation>2012 年模型, 整体旋转 (原为 0)</translation>
    </message>
    <message>
        <source>Rotation jitter</source>
        <translation>旋转抖动</translation>
    </message>
    <message>
        <source>Random part of that rate, drawn anew every frame. Steps per frame do not change how far it turns; a higher frame rate does.</source>
        <translation>该速率的随机部分，每帧重新抽取。每帧步数不改变它转多远；更高的帧率会改变。</translation>
    </message>
    <message>
        <source>2012 model, whole-body rotation</source>
        <translation>2012 年模型, 整体旋转</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>质量</translation>
    </message>
    <message>
        <source>Mass m of a particle, which divides gravity.</source>
        <translation>粒子的质量 m，用来除重力。</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>强度</translation>
    </message>
    <message>
        <source>Speed of the swirls that carry the particles: its root mean square over space, all layers together.</source>
        <translation>带动粒子的涡流的速度：所有层合计在空间上的均方根。</translation>
    </message>
    <message>
        <source>Bridson et al. 2007, curl noise</source>
        <translation>Bridson 等 2007, 旋度噪声</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>尺度</translation>
    </message>
    <message>
        <source>Size of the largest swirls at the height of the emitter.</source>
        <translation>发射器高度处最大涡流的大小。</translation>
    </message>
    <message>
        <source>Octaves</source>
        <translation>倍频程</translation>
    </message>
    <message>
        <source>Layers of ever smaller swirls; each costs the same time.</source>
        <translation>越来越小的涡流层；每层耗时相同。</translation>
    </message>
    <message>
        <source>Roughness</source>
        <translation>粗糙度</translation>
    </message>
    <message>
        <source>Speed of each layer of swirls relative to the one before.</source>
        <translation>每层涡流相对于前一层的速度。</translation>
    </message>
    <message>
        <source>Evolution</source>
        <translation>演变</translation>
    </message>
    <message>
        <source>How often the largest swirls become others; smaller ones change faster.</source>
        <translation>最大的涡流多久换成另一些；较小的变得更快。</translation>
    </message>
    <message>
        <source>Fade-in time</source>
        <translation>起始</translation>
    </message>
    <message>
        <source>Age at which the swirls have their full strength; younger smoke is calmer.</source>
        <translation>涡流达到全部强度时的年龄；更年轻的烟更平静。</translation>
    </message>
    <message>
        <source>Growth with height</source>
        <translation>随高度增长</translation>
    </message>
    <message>
        <source>How much larger the swirls are with each metre above the emitter, as in a plume that takes in air.</source>
        <translation>发射器之上每高一米涡流变大多少，如同卷入空气的烟柱。</translation>
    </message>
    <message>
        <source>Drift</source>
        <translation>漂移</translation>
    </message>
    <message>
        <source>Speed at which the swirls rise along with the smoke, instead of standing still while it passes.</source>
        <translation>涡流随烟一起上升的速度，而不是停在原处让烟流过。</translation>
    </message>
    <message>
        <source>Lacunarity</source>
        <translation>间隙度</translation>
    </message>
    <message>
        <source>How many times smaller each layer of swirls is than the one before.</source>
        <translation>每层涡流比前一层小多少倍。</translation>
    </message>
    <message>
        <source>Speed of the swirl at its radius. About an upright axis it turns from +X towards -Z; negative turns the other way.</source>
        <translation>涡旋在其半径处的速度。绕竖直轴时从 +X 转向 -Z；负值反向旋转。</translation>
    </message>
    <message>
        <source>Scully 1975, vortex profile</source>
        <translation>Scully 1975, 涡旋剖面</translation>
    </message>
    <message>
        <source>Distance from the axis at which the swirl is fastest.</source>
        <translation>涡旋最快处离轴的距离。</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>轴</translation>
    </message>
    <message>
        <source>Direction of the axis through the emitter about which the smoke swirls.</source>
        <translation>烟绕其旋转、过发射器的轴的方向。</translation>
    </message>
    <message>
        <source>Fade rate</source>
        <translation>淡出速率</translation>
    </message>
    <message>
        <source>Alpha that a particle loses a second. Its life is the initial alpha divided by this.</source>
        <translation>粒子每秒失去的透明度。其寿命是初始透明度除以此值。</translation>
    </message>
    <message>
        <source>2012 model, eq. XIII</source>
        <translation>2012 年模型, 式 XIII</translation>
    </message>
    <message>
        <source>Initial alpha</source>
        <translation>初始透明度</translation>
    </message>
    <message>
        <source>Alpha Ai of a particle at birth.</source>
        <translation>粒子诞生时的透明度 Ai。</translation>
    </message>
    <message>
        <source>2012 model, eq. XIII (0.1 there)</source>
        <translation>2012 年模型, 式 XIII (0.原为 1)</translation>
    </message>
    <message>
        <source>Lifetime variation</source>
        <translation>寿命差异</translation>
    </message>
    <message>
        <source>Lets particles die earlier, by up to this share of their life, so that the smoke thins out unevenly.</source>
        <translation>让粒子提前消亡，最多提前寿命的这一比例，使烟不均匀地变稀。</translation>
    </message>
    <message>
        <source>Size over life</source>
        <translation>随寿命的大小</translation>
    </message>
    <message>
        <source>Share of the particle&apos;s size, from birth to death.</source>
        <translation>从诞生到消亡，粒子大小的比例。</translation>
    </message>
    <message>
        <source>Alpha over life</source>
        <translation>随寿命的透明度</translation>
    </message>
    <message>
        <source>Multiplies the fading alpha, from birth to death.</source>
        <translation>从诞生到消亡，乘以正在淡出的透明度。</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>不透明度</translation>
    </message>
    <message>
        <source>Multiplies the alpha of every particle: from wisp to billow.</source>
        <translation>乘以每个粒子的透明度：从轻缕到浓云。</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>大小</translation>
    </message>
    <message>
        <source>Largest diameter of a particle.</source>
        <translation>粒子的最大直径。</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>颜色</translation>
    </message>
    <message>
        <source>Colour of the smoke itself (albedo), before light falls on it.</source>
        <translation>光照之前烟本身的颜色（反照率）。</translation>
    </message>
    <message>
        <source>Colour over life</source>
        <translation>随寿命的颜色</translation>
    </message>
    <message>
        <source>Multiplies the colour, from birth to death.</source>
        <translation>从诞生到消亡，乘以颜色。</translation>
    </message>
    <message>
        <source>Texture</source>
        <translation>纹理</translation>
    </message>
    <message>
        <source>How much the noise disturbs the transparency of a particle.</source>
        <translation>噪声对粒子透明度的扰动程度。</translation>
    </message>
    <message>
        <source>2012 model, transparency disturbance</source>
        <translation>2012 年模型, 透明度扰动</translation>
    </message>
    <message>
        <source>Erosion</source>
        <translation>侵蚀</translation>
    </message>
    <message>
        <source>How far the noise eats into a particle by the end of its life.</source>
        <translation>到寿命终点时噪声侵入粒子多深。</translation>
    </message>
    <message>
        <source>Erosion softness</source>
        <translation>侵蚀柔和度</translation>
    </message>
    <message>
        <source>Width of the transition from smoke to hole.</source>
        <translation>从烟到空洞的过渡宽度。</translation>
    </message>
    <message>
        <source>Softness</source>
        <translation>柔和度</translation>
    </message>
    <message>
        <source>0: a disc with a hard rim. 1: a puff that fades from its centre.</source>
        <translation>0：边缘清晰的圆盘。1：从中心淡出的烟团。</translation>
    </message>
    <message>
        <source>Relief</source>
        <translation>浮雕</translation>
    </message>
    <message>
        <source>How much the noise catches the light, as bumps on a puff.</source>
        <translation>噪声受光的程度，如烟团上的凸起。</translation>
    </message>
    <message>
        <source>Roundness</source>
        <translation>圆度</translation>
    </message>
    <message>
        <source>How much a puff is shaded like a ball.</source>
        <translation>烟团像球一样着色的程度。</translation>
    </message>
    <message>
        <source>Size variation</source>
        <translation>大小差异</translation>
    </message>
    <message>
        <source>How much sizes differ; 1 mixes everything down to nothing.</source>
        <translation>大小相差多少；1 混合直至为零的各种大小。</translation>
    </message>
    <message>
        <source>Density falloff</source>
        <translation>稀释</translation>
    </message>
    <message>
        <source>How much a particle thins out as it grows; 1 keeps its amount of smoke constant.</source>
        <translation>粒子变大时变稀的程度；1 保持其烟量不变。</translation>
    </message>
    <message>
        <source>Texture scale</source>
        <translation>纹理比例</translation>
    </message>
    <message>
        <source>Share of the noise tile that a particle shows; more than 1 repeats it.</source>
        <translation>粒子所显示的噪声块比例；大于 1 会重复。</translation>
    </message>
    <message>
        <source>Texture evolution</source>
        <translation>纹理演变</translation>
    </message>
    <message>
        <source>How fast the noise in a particle boils: lattice cells of the third axis a second.</source>
        <translation>粒子中的噪声翻腾得多快：每秒沿第三轴的格数。</translation>
    </message>
    <message>
        <source>Rotation variation</source>
        <translation>旋转差异</translation>
    </message>
    <message>
        <source>How much particles are turned at birth; 1 is any angle.</source>
        <translation>粒子诞生时转过的程度；1 为任意角度。</translation>
    </message>
    <message>
        <source>Spin</source>
        <translation>自转</translation>
    </message>
    <message>
        <source>Rate at which each particle turns on the screen.</source>
        <translation>每个粒子在屏幕上转动的速率。</translation>
    </message>
    <message>
        <source>Spin variation</source>
        <translation>自转差异</translation>
    </message>
    <message>
        <source>Random part of that rate, different for every particle.</source>
        <translation>该速率的随机部分，每个粒子不同。</translation>
    </message>
    <message>
        <source>Stretch</source>
        <translation>拉伸</translation>
    </message>
    <message>
        <source>Lengthens a particle&apos;s texture along its motion, by the way it travels in this time.</source>
        <translation>按粒子在这段时间内走过的路程，沿运动方向拉长其纹理。</translation>
    </message>
    <message>
        <source>Particle shape</source>
        <translation>遮罩</translation>
    </message>
    <message>
        <source>Layers of noise that are summed, each finer and weaker than the one before.</source>
        <translation>相加的噪声层，每层比前一层更细更弱。</translation>
    </message>
    <message>
        <source>2012 model, octaves</source>
        <translation>2012 年模型, 倍频程</translation>
    </message>
    <message>
        <source>Sharpness</source>
        <translation>锐度</translation>
    </message>
    <message>
        <source>Contrast of the grey values about their middle; 1 leaves them as they are.</source>
        <translation>灰度值围绕中间值的对比度；1 保持不变。</translation>
    </message>
    <message>
        <source>2012 model, sharpness</source>
        <translation>2012 年模型, 锐度</translation>
    </message>
    <message>
        <source>Wavelength</source>
        <translation>波长</translation>
    </message>
    <message>
        <source>Wavelength of the first octave as a share of the tile (the inverse of its frequency).</source>
        <translation>第一个倍频程的波长，以块的比例计（频率的倒数）。</translation>
    </message>
    <message>
        <source>Persistence</source>
        <translation>持续度</translation>
    </message>
    <message>
        <source>Amplitude of each octave relative to the one before.</source>
        <translation>每个倍频程相对于前一个的振幅。</translation>
    </message>
    <message>
        <source>Coverage</source>
        <translation>覆盖</translation>
    </message>
    <message>
        <source>How much of the tile is smoke: shifts the grey values up or down.</source>
        <translation>块中有多少是烟：把灰度值整体上移或下移。</translation>
    </message>
    <message>
        <source>Warp</source>
        <translation>扭曲</translation>
    </message>
    <message>
        <source>Bends the noise by another noise, by up to this share of its wavelength.</source>
        <translation>用另一个噪声弯曲噪声，最多达其波长的这一比例。</translation>
    </message>
    <message>
        <source>Perlin 1985, domain perturbation</source>
        <translation>Perlin 1985, 域扰动</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>平滑</translation>
    </message>
    <message>
        <source>Averages each lattice value with its neighbours: centre 1/4, edges 1/8, corners 1/16.</source>
        <translation>把每个格点值与其邻居平均：中心 1/4，边 1/8，角 1/16。</translation>
    </message>
    <message>
        <source>2012 model, smooth function</source>
        <translation>2012 年模型, 平滑函数</translation>
    </message>
    <message>
        <source>Basis</source>
        <translation>基底</translation>
    </message>
    <message>
        <source>Random values on a lattice (2012 model), random gradients, or gradients on a lattice of simplices.</source>
        <translation>格点上的随机值（2012 年模型）、随机梯度，或单纯形格上的梯度。</translation>
    </message>
    <message>
        <source>2012 model; Perlin 2002</source>
        <translation>2012 年模型; Perlin 2002</translation>
    </message>
    <message>
        <source>Interpolation</source>
        <translation>插值</translation>
    </message>
    <message>
        <source>How values between lattice points are found. Cubic swings past its points; what leaves 0 to 1 is cut.</source>
        <translation>如何求格点之间的值。三次插值会越过格点的值；超出 0 到 1 的部分被截去。</translation>
    </message>
    <message>
        <source>2012 model (linear, cosine, cubic); Perlin 2002 (quintic)</source>
        <translation>2012 年模型 (线性、余弦、三次); Perlin 2002 (五次)</translation>
    </message>
    <message>
        <source>Frequency of each octave relative to the one before.</source>
        <translation>每个倍频程相对于前一个的频率。</translation>
    </message>
    <message>
        <source>Lattice cells of the first octave along the third axis, through which the texture boils before it repeats.</source>
        <translation>第一个倍频程沿第三轴的格数，纹理翻腾经过它们之后重复。</translation>
    </message>
    <message>
        <source>Slices</source>
        <translation>切片</translation>
    </message>
    <message>
        <source>How many slices of the 3D noise are baked.</source>
        <translation>烘焙三维噪声的多少个切片。</translation>
    </message>
    <message>
        <source>Resolution</source>
        <translation>分辨率</translation>
    </message>
    <message>
        <source>Edge of the noise tile; particles use the next power of two.</source>
        <translation>噪声块的边长；粒子使用下一个二的幂。</translation>
    </message>
    <message>
        <source>Another seed gives another texture of the same kind.</source>
        <translation>换一个种子就得到同类的另一种纹理。</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>方向</translation>
    </message>
    <message>
        <source>The direction in which the light of the sun travels.</source>
        <translation>太阳光行进的方向。</translation>
    </message>
    <message>
        <source>Sun intensity</source>
        <translation>强度</translation>
    </message>
    <message>
        <source>Strength of the sun.</source>
        <translation>太阳的强度。</translation>
    </message>
    <message>
        <source>Shadow</source>
        <translation>阴影</translation>
    </message>
    <message>
        <source>How much light is lost on the way through the smoke.</source>
        <translation>光穿过烟时损失多少。</translation>
    </message>
    <message>
        <source>Scattering</source>
        <translation>散射</translation>
    </message>
    <message>
        <source>Light that is scattered many times and reaches deep into dense smoke, so that it is not black.</source>
        <translation>多次散射后深入浓烟的光，使浓烟不至于发黑。</translation>
    </message>
    <message>
        <source>Wrenninge et al. 2013, octaves of scattering</source>
        <translation>Wrenninge 等 2013, 散射倍频程</translation>
    </message>
    <message>
        <source>Forward scattering</source>
        <translation>各向异性</translation>
    </message>
    <message>
        <source>More than 0: smoke glows when it stands before the sun. Less: it is brighter with the sun behind the camera.</source>
        <translation>大于 0：烟在太阳前面时发亮。小于 0：太阳在相机后面时更亮。</translation>
    </message>
    <message>
        <source>Henyey and Greenstein 1941</source>
        <translation>Henyey 与 Greenstein 1941</translation>
    </message>
    <message>
        <source>Ambient</source>
        <translation>环境光</translation>
    </message>
    <message>
        <source>Strength of the light from sky and ground.</source>
        <translation>来自天空和地面的光的强度。</translation>
    </message>
    <message>
        <source>Colour of the sun.</source>
        <translation>太阳的颜色。</translation>
    </message>
    <message>
        <source>Sky</source>
        <translation>天空</translation>
    </message>
    <message>
        <source>Colour of the light from above.</source>
        <translation>来自上方的光的颜色。</translation>
    </message>
    <message>
        <source>Ground</source>
        <translation>地面</translation>
    </message>
    <message>
        <source>Colour of the light from below.</source>
        <translation>来自下方的光的颜色。</translation>
    </message>
    <message>
        <source>Occlusion</source>
        <translation>遮蔽</translation>
    </message>
    <message>
        <source>How much the light from sky and ground is lost inside dense smoke.</source>
        <translation>来自天空和地面的光在浓烟内部损失多少。</translation>
    </message>
    <message>
        <source>Light that hot smoke gives off by itself, as fire.</source>
        <translation>热烟自身发出的光，如火焰。</translation>
    </message>
    <message>
        <source>Emission cooling</source>
        <translation>辉光冷却</translation>
    </message>
    <message>
        <source>How fast the glow moves down its colours as smoke ages.</source>
        <translation>烟变老时，辉光沿其颜色下移得多快。</translation>
    </message>
    <message>
        <source>Emission colours</source>
        <translation>辉光颜色</translation>
    </message>
    <message>
        <source>Colour of the glow from cold (left) to as hot as at birth (right).</source>
        <translation>辉光从冷（左）到与诞生时一样热（右）的颜色。</translation>
    </message>
    <message>
        <source>Cells of the density grid along the longest side of the cloud.</source>
        <translation>密度网格沿烟团最长边的格数。</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>模式</translation>
    </message>
    <message>
        <source>Around a target, or at a fixed place.</source>
        <translation>围绕目标，或在固定位置。</translation>
    </message>
    <message>
        <source>Yaw</source>
        <translation>偏航</translation>
    </message>
    <message>
        <source>Angle around the target, seen from above; 0 looks along -Z.</source>
        <translation>从上方看绕目标的角度；0 朝 -Z 看。</translation>
    </message>
    <message>
        <source>Pitch</source>
        <translation>俯仰</translation>
    </message>
    <message>
        <source>Angle above the horizon from which the target is seen.</source>
        <translation>观看目标时高于地平线的角度。</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>距离</translation>
    </message>
    <message>
        <source>Distance from the target.</source>
        <translation>离目标的距离。</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>目标</translation>
    </message>
    <message>
        <source>The point that the camera looks at.</source>
        <translation>相机所看的点。</translation>
    </message>
    <message>
        <source>Turntable</source>
        <translation>转台</translation>
    </message>
    <message>
        <source>Rate at which the camera goes around the target.</source>
        <translation>相机绕目标转动的速率。</translation>
    </message>
    <message>
        <source>Where the fixed camera stands.</source>
        <translation>固定相机所在的位置。</translation>
    </message>
    <message>
        <source>View direction</source>
        <translation>视线方向</translation>
    </message>
    <message>
        <source>Where the fixed camera looks.</source>
        <translation>固定相机所看的方向。</translation>
    </message>
    <message>
        <source>Focal length</source>
        <translation>焦距</translation>
    </message>
    <message>
        <source>Of a lens on a sensor of 36 mm across the shorter side; longer brings the smoke nearer.</source>
        <translation>短边 36 mm 传感器上镜头的焦距；越长烟越近。</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>长度</translation>
    </message>
    <message>
        <source>Frames from the first to the last; also the length of the loop.</source>
        <translation>从第一帧到最后一帧的帧数；也是循环的长度。</translation>
    </message>
    <message>
        <source>The frame after the last is the first again, to the bit.</source>
        <translation>最后一帧之后又是第一帧，逐位相同。</translation>
    </message>
    <message>
        <source>Prewarm</source>
        <translation>预热开始</translation>
    </message>
    <message>
        <source>Frame 0 shows smoke that has been rising for a lifetime, instead of none.</source>
        <translation>第 0 帧显示已上升一个寿命的烟，而不是没有烟。</translation>
    </message>
    <message>
        <source>Frame rate</source>
        <translation>帧率</translation>
    </message>
    <message>
        <source>Frames a second.</source>
        <translation>每秒帧数。</translation>
    </message>
    <message>
        <source>Substeps</source>
        <translation>每帧步数</translation>
    </message>
    <message>
        <source>Steps of the simulation in a frame; more follow fast motion more closely.</source>
        <translation>每帧的模拟步数；步数越多越能跟上快速运动。</translation>
    </message>
    <message>
        <source>2012 model, eq. IX and X (1 there)</source>
        <translation>2012 年模型, 式 IX 与 X (原为 1)</translation>
    </message>
    <message>
        <source>Width of a frame.</source>
        <translation>一帧的宽度。</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>高度</translation>
    </message>
    <message>
        <source>Height of a frame.</source>
        <translation>一帧的高度。</translation>
    </message>
    <message>
        <source>Supersampling</source>
        <translation>超采样</translation>
    </message>
    <message>
        <source>Renders this many times larger and averages.</source>
        <translation>以这么多倍的尺寸渲染，再取平均。</translation>
    </message>
    <message>
        <source>Exposure</source>
        <translation>曝光</translation>
    </message>
    <message>
        <source>Brightness in stops; one more doubles it. Not applied to EXR, which is linear.</source>
        <translation>以档为单位的亮度；每加一档亮度加倍。不用于线性的 EXR。</translation>
    </message>
    <message>
        <source>View transform</source>
        <translation>视图变换</translation>
    </message>
    <message>
        <source>Standard is plain sRGB; filmic rolls bright light off softly.</source>
        <translation>标准即普通 sRGB；胶片让强光柔和地收敛。</translation>
    </message>
    <message>
        <source>Background</source>
        <translation>背景</translation>
    </message>
    <message>
        <source>Keep transparency, or put a colour behind the smoke.</source>
        <translation>保留透明，或在烟后放一种颜色。</translation>
    </message>
    <message>
        <source>Background colour</source>
        <translation>背景颜色</translation>
    </message>
    <message>
        <source>The colour behind the smoke.</source>
        <translation>烟后面的颜色。</translation>
    </message>
    <message>
        <source>rectangle</source>
        <translation>矩形</translation>
    </message>
    <message>
        <source>disc</source>
        <translation>圆盘</translation>
    </message>
    <message>
        <source>sphere</source>
        <translation>球</translation>
    </message>
    <message>
        <source>continuous</source>
        <translation>持续</translation>
    </message>
    <message>
        <source>burst</source>
        <translation>爆发</translation>
    </message>
    <message>
        <source>square</source>
        <translation>方块</translation>
    </message>
    <message>
        <source>lattice</source>
        <translation>格点</translation>
    </message>
    <message>
        <source>gradient</source>
        <translation>梯度</translation>
    </message>
    <message>
        <source>simplex</source>
        <translation>单纯形</translation>
    </message>
    <message>
        <source>linear</source>
        <translation>线性</translation>
    </message>
    <message>
        <source>cosine</source>
        <translation>余弦</translation>
    </message>
    <message>
        <source>cubic</source>
        <translation>三次</translation>
    </message>
    <message>
        <source>quintic</source>
        <translation>五次</translation>
    </message>
    <message>
        <source>orbit</source>
        <translation>环绕</translation>
    </message>
    <message>
        <source>fixed</source>
        <translation>固定</translation>
    </message>
    <message>
        <source>standard</source>
        <translation>标准</translation>
    </message>
    <message>
        <source>filmic</source>
        <translation>胶片</translation>
    </message>
    <message>
        <source>transparent</source>
        <translation>透明</translation>
    </message>
    <message>
        <source>colour</source>
        <translation>颜色</translation>
    </message>
    <message>
        <source>Emitter</source>
        <translation>发射器</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>运动</translation>
    </message>
    <message>
        <source>Turbulence</source>
        <translation>湍流</translation>
    </message>
    <message>
        <source>Vortex</source>
        <translation>涡旋</translation>
    </message>
    <message>
        <source>Life</source>
        <translation>寿命</translation>
    </message>
    <message>
        <source>Look</source>
        <translation>外观</translation>
    </message>
    <message>
        <source>Noise</source>
        <translation>噪声</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>光</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>相机</translation>
    </message>
    <message>
        <source>Timeline</source>
        <translation>时间线</translation>
    </message>
    <message>
        <source>Output</source>
        <translation>输出</translation>
    </message>
    <message>
        <source>Range: %1</source>
        <translation>范围：%1</translation>
    </message>
    <message>
        <source>Source: %1</source>
        <translation>来源：%1</translation>
    </message>
    <message>
        <source>Speed of the flow through the middle of the vortex rings that rise with the smoke: they roll its rim into billows, and the first one is the head of a mushroom.</source>
        <translation>随烟上升的涡环中心的流速：涡环把烟的边缘卷成滚滚烟团，第一个涡环就是蘑菇的头。</translation>
    </message>
    <message>
        <source>Rise</source>
        <translation>上升</translation>
    </message>
    <message>
        <source>Speed at which the rings travel along the emitter&apos;s normal.</source>
        <translation>涡环沿发射器法线行进的速度。</translation>
    </message>
    <message>
        <source>Radius of a ring at the emitter: inside it the smoke rises, outside it sinks.</source>
        <translation>涡环在发射器处的半径：环内烟上升，环外烟下沉。</translation>
    </message>
    <message>
        <source>Metres that the radius grows with each metre from the emitter.</source>
        <translation>离发射器每远一米，半径增加的米数。</translation>
    </message>
    <message>
        <source>Spacing</source>
        <translation>间距</translation>
    </message>
    <message>
        <source>Distance from one ring to the next.</source>
        <translation>一个涡环到下一个的距离。</translation>
    </message>
    <message>
        <source>Following rings</source>
        <translation>后续</translation>
    </message>
    <message>
        <source>Strength of the rings that follow, relative to the first; smoke that starts warm has followers only.</source>
        <translation>后续涡环相对于第一个的强度；预热开始的烟只有后续涡环。</translation>
    </message>
    <message>
        <source>Variation</source>
        <translation>差异</translation>
    </message>
    <message>
        <source>How much the rings differ in strength and lie off the axis, so that they do not march in formation.</source>
        <translation>涡环在强度和偏离轴线上的差异程度，使它们不会列队而行。</translation>
    </message>
    <message>
        <source>Roll</source>
        <translation>翻滚</translation>
    </message>
    <message>
        <source>How much particles turn with the swirls that carry them; 1 is as much as the air itself.</source>
        <translation>粒子随承载它的涡旋转动的程度；1 表示与空气本身相同。</translation>
    </message>
    <message>
        <source>Hot core</source>
        <translation>炽热内核</translation>
    </message>
    <message>
        <source>How much cooler the rim glows than the inside: air cools what lies open to it, and fire shows in the gaps.</source>
        <translation>边缘比内部暗多少：暴露在空气中的部分冷却，火光从缝隙中透出。</translation>
    </message>
    <message>
        <source>Fire colours from</source>
        <translation>发光来源</translation>
    </message>
    <message>
        <source>Colours of your choice, or those of a body that glows by its temperature.</source>
        <translation>自选的颜色，或物体因温度而发出的颜色。</translation>
    </message>
    <message>
        <source>Temperature</source>
        <translation>温度</translation>
    </message>
    <message>
        <source>Temperature at birth: 1000 K glows red, 1900 K as a candle, 5800 K as the sun. As smoke cools, its glow turns red and fades.</source>
        <translation>出生时的温度：1000 K 发红光，1900 K 如烛光，5800 K 如太阳。烟冷却时，光变红并消失。</translation>
    </message>
    <message>
        <source>Planck 1901; colour matching of Wyman et al. 2013</source>
        <translation>Planck 1901；Wyman 等人 2013 的颜色匹配</translation>
    </message>
    <message>
        <source>Quality</source>
        <translation>质量</translation>
    </message>
    <message>
        <source>Draft: a quarter of the particles. Final: eight times as many. The smoke keeps its form and density.</source>
        <translation>草稿：四分之一的粒子。最终：八倍的粒子。烟的形状和密度不变。</translation>
    </message>
    <message>
        <source>black-body</source>
        <translation>黑体</translation>
    </message>
    <message>
        <source>draft</source>
        <translation>草稿</translation>
    </message>
    <message>
        <source>good</source>
        <translation>良好</translation>
    </message>
    <message>
        <source>final</source>
        <translation>最终</translation>
    </message>
    <message>
        <source>Vortex rings</source>
        <translation>涡环</translation>
    </message>
    <message>
        <source>Turner 1962, the starting plume</source>
        <translation>Turner 1962，起始羽流</translation>
    </message>
    <message>
        <source>on</source>
        <translation>开</translation>
    </message>
    <message>
        <source>off</source>
        <translation>关</translation>
    </message>
    <message>
        <source>Seamless loop</source>
        <translation>无缝循环</translation>
    </message>
    <message>
        <source>Fluid simulation</source>
        <translation>流动的空气</translation>
    </message>
    <message>
        <source>The smoke is carried by air that it heats: it rolls up, takes in air, makes stems and caps, and flows around obstacles. Buoyancy, cooling, wind, gusts and the speed of the emitter act on the air; turbulence is the detail below its grid, and vortex rings come by themselves.</source>
        <translation>烟由它加热的空气携带：它会翻卷、卷入空气、形成烟柱和烟帽，并绕过障碍物流动。浮力、冷却、风、阵风和发射器的速度作用于空气；湍流是其网格以下的细节，涡环会自行产生。</translation>
    </message>
    <message>
        <source>Fedkiw, Stam, Jensen 2001</source>
        <translation>Fedkiw、Stam、Jensen 2001</translation>
    </message>
    <message>
        <source>Cells of air along the longest side of its box: twice as many show smaller billows and take sixteen times as long. Once baked, the air costs next to nothing.</source>
        <translation>空气盒最长边上的单元数：加倍可显示更小的烟团，但耗时为十六倍。一旦烘焙完成，空气几乎不再占用时间。</translation>
    </message>
    <message>
        <source>Fit to the smoke</source>
        <translation>适应烟雾</translation>
    </message>
    <message>
        <source>The box of the air is as large as the smoke is expected to become, from what the emitter gives it and for how long it lives.</source>
        <translation>空气盒的大小按烟雾预计达到的范围而定，取决于发射器给予它的量和它的寿命。</translation>
    </message>
    <message>
        <source>Edges of the box of the air. It stands above the emitter&apos;s foot; smoke that leaves it goes on with the wind.</source>
        <translation>空气盒的边长。它立于发射器底部之上；离开它的烟随风而去。</translation>
    </message>
    <message>
        <source>Offset</source>
        <translation>偏移</translation>
    </message>
    <message>
        <source>Moves the box of the air away from the emitter. The emitter has to stay inside it.</source>
        <translation>将空气盒移离发射器。发射器必须留在盒内。</translation>
    </message>
    <message>
        <source>Vorticity confinement</source>
        <translation>涡度</translation>
    </message>
    <message>
        <source>Gives swirls back what the grid takes from them, and no more than that. It makes billows crisp.</source>
        <translation>把网格从漩涡中夺走的还给它们，不会更多。使烟团清晰。</translation>
    </message>
    <message>
        <source>Steinhoff and Underhill 1994</source>
        <translation>Steinhoff 和 Underhill 1994</translation>
    </message>
    <message>
        <source>Source noise</source>
        <translation>参差度</translation>
    </message>
    <message>
        <source>Detail</source>
        <translation>细节</translation>
    </message>
    <message>
        <source>Swirls that are smaller than the cells of the air, as strong as the air around them is sheared. Octaves, roughness, evolution and drift of the turbulence say what they are like.</source>
        <translation>比空气单元更小的漩涡，强度取决于周围空气的剪切。湍流的倍频、粗糙度、演化和漂移决定它们的样子。</translation>
    </message>
    <message>
        <source>Kim, Thürey, James, Gross 2008</source>
        <translation>Kim、Thürey、James、Gross 2008</translation>
    </message>
    <message>
        <source>Heat opacity</source>
        <translation>按热量的不透明度</translation>
    </message>
    <message>
        <source>How much smoke fades where its air is cold: 1 shows nothing but what is hot, as in a flame.</source>
        <translation>烟在冷空气中淡去的程度：1 只显示热的部分，如同火焰。</translation>
    </message>
    <message>
        <source>Expansion</source>
        <translation>膨胀</translation>
    </message>
    <message>
        <source>Volume that the source adds to the air, as a multiple of its own each second, as long as it emits: a burst blows up a ball.</source>
        <translation>发射期间源头每秒向空气增加的体积，以自身体积的倍数计：一次爆发会吹起一个球。</translation>
    </message>
    <message>
        <source>A floor that air and smoke flow along and do not enter.</source>
        <translation>空气和烟沿其流动而不会进入的地面。</translation>
    </message>
    <message>
        <source>Ground height</source>
        <translation>地面高度</translation>
    </message>
    <message>
        <source>Height of the floor.</source>
        <translation>地面的高度。</translation>
    </message>
    <message>
        <source>Friction</source>
        <translation>摩擦</translation>
    </message>
    <message>
        <source>Drag coefficient of the floor and of the obstacle: 0 lets the air slip along, forest has 0.1.</source>
        <translation>地面和障碍物的阻力系数：0 让空气滑过，树林为 0.1。</translation>
    </message>
    <message>
        <source>Obstacle</source>
        <translation>障碍物</translation>
    </message>
    <message>
        <source>A body that air and smoke flow around.</source>
        <translation>空气和烟绕其流动的物体。</translation>
    </message>
    <message>
        <source>Centre of the obstacle.</source>
        <translation>障碍物的中心。</translation>
    </message>
    <message>
        <source>Obstacle size</source>
        <translation>障碍物大小</translation>
    </message>
    <message>
        <source>Edges of the box; of a sphere the first number is the diameter.</source>
        <translation>盒子的边长；对于球体，第一个数是直径。</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>box</source>
        <translation>盒子</translation>
    </message>
    <message>
        <source>Air</source>
        <translation>空气</translation>
    </message>
    <message>
        <source>Overlap</source>
        <translation>重叠</translation>
    </message>
    <message>
        <source>Where fewer particles than this overlap they grow and thin out, so that smoke ends as haze and not as dots; 0: never.</source>
        <translation>重叠的粒子少于此数时，粒子会变大变淡，使烟雾以薄雾而非斑点收尾；0：从不。</translation>
    </message>
    <message>
        <source>Deformation</source>
        <translation>形变</translation>
    </message>
    <message>
        <source>How much the air that carries a particle stretches it, into sheets and curls; 0: all stay round.</source>
        <translation>承载粒子的空气将其拉伸成薄片和卷曲的程度；0：全部保持圆形。</translation>
    </message>
    <message>
        <source>Deformation time</source>
        <translation>形变时间</translation>
    </message>
    <message>
        <source>How long a particle remembers how it was stretched.</source>
        <translation>粒子记住自身如何被拉伸的时长。</translation>
    </message>
    <message>
        <source>Deformation limit</source>
        <translation>形变极限</translation>
    </message>
    <message>
        <source>Axes of a stretched particle are at most this many times its own, and at least the same part of it.</source>
        <translation>被拉伸粒子的轴长至多为原来的此倍数，至少为其倒数。</translation>
    </message>
    <message>
        <source>Flame opacity</source>
        <translation>火焰不透明度</translation>
    </message>
    <message>
        <source>How opaque smoke is while it glows, beside when it is cold. 1: it glows as lava does. 0.1: a clear flame that one sees into, from which soot forms as it cools.</source>
        <translation>烟雾发光时相对于冷却后的不透明度。1：像熔岩一样发光。0.1：可以看进去的清澈火焰，冷却后形成烟炱。</translation>
    </message>
    <message>
        <source>Fire light</source>
        <translation>火光照明</translation>
    </message>
    <message>
        <source>How much what glows lights the smoke around it. 1: as much as it gives off.</source>
        <translation>发光部分照亮周围烟雾的程度。1：与其发出的光一样多。</translation>
    </message>
    <message>
        <source>How far the rim of the source wanders, and how unevenly it blows. Without it smoke rises as a column of one width.</source>
        <translation>热源边缘游移多远，吹出有多不均匀。没有它，烟会像粗细不变的柱子一样上升。</translation>
    </message>
    <message>
        <source>Heat noise</source>
        <translation>不均匀的热</translation>
    </message>
    <message>
        <source>How much the heat of the source differs from place to place, as a share of it. What is hotter rises ahead of the rest: billows on billows. Without it a cap is bald.</source>
        <translation>热源的热量在各处相差多少，以其份额计。更热的部分先于其余上升：翻滚之上再翻滚。没有它，顶部会是光秃的。</translation>
    </message>
    <message>
        <source>Metres that the radius grows with each metre along the axis, away from the emitter: a funnel.</source>
        <translation>沿轴线远离发射器每前进一米，半径增大的米数：形成漏斗。</translation>
    </message>
    <message>
        <source>Stirs the hot air, so that smoke breaks up, spreads and billows from its foot on, where it would rise as a smooth column: the root mean square of the acceleration where it is hottest.</source>
        <translation>搅动热空气，使烟从底部起就散开、扩展并翻滚，而不是像光滑的柱子一样上升：最热处加速度的均方根值。</translation>
    </message>
    <message>
        <source>Turbulence size</source>
        <translation>湍流尺度</translation>
    </message>
    <message>
        <source>Size of the largest swirls that the turbulence makes; there are some half and a quarter as large, as far as the cells of the air show them. About as large as the emitter looks natural.</source>
        <translation>湍流所产生的最大旋涡的尺寸；另有一半和四分之一大小的旋涡，只要空气网格能表现出来。与发射器差不多大时看起来最自然。</translation>
    </message>
    <message>
        <source>Ground fade</source>
        <translation>地面淡出</translation>
    </message>
    <message>
        <source>Height above the floor over which smoke becomes opaque, as soft particles do before what they touch in engines: no straight cut at its foot. 0: smoke ends at the floor.</source>
        <translation>烟雾在地面以上多高处变得不透明，如同引擎中柔和粒子接触物体时那样：底部没有平直的切口。0：烟雾止于地面。</translation>
    </message>
    <message>
        <source>Lifetime</source>
        <translation>寿命</translation>
    </message>
    <message>
        <source>Seconds from birth to death of a particle: the initial alpha divided by the fade rate. Setting it sets the fade rate.</source>
        <translation>粒子从出生到消亡的秒数：初始透明度除以淡出速率。设置它即设置淡出速率。</translation>
    </message>
    <message>
        <source>Fire</source>
        <translation>火焰</translation>
    </message>
    <message>
        <source>Upward acceleration of air that is as hot as the source makes it; it fades as the air cools.</source>
        <translation>被源加热到最热的空气的向上加速度；随空气冷却而减弱。</translation>
    </message>
    <message>
        <source>How fast the heat that lifts the air is lost.</source>
        <translation>抬升空气的热量散失的速度。</translation>
    </message>
    <message>
        <source>Wind drag</source>
        <translation>风阻</translation>
    </message>
    <message>
        <source>The wind blows the air as fast as its acceleration over this, 0.5 at least: with 1 a wind of 2 m/s² is one of 2 m/s.</source>
        <translation>风带动空气的速度等于其加速度除以此值（至少 0.5）：取 1 时，2 m/s² 的风就是 2 m/s。</translation>
    </message>
    <message>
        <source>Obstacle position</source>
        <translation>障碍物位置</translation>
    </message>
    <message>
        <source>Fire brightness</source>
        <translation>火焰亮度</translation>
    </message>
    <message>
        <source>Flare</source>
        <translation>扩张</translation>
    </message>
    <message>
        <source>Wind strength</source>
        <translation>风力</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>源</translation>
    </message>
    <message>
        <source>Mean rate at which the whole cloud turns about the vertical line through the emitter: from +X towards -Z, against the sense of the wind&apos;s angle. The emitter does not turn.</source>
        <translation>整团烟绕过发射器竖直线转动的平均速率：从 +X 转向 -Z，与风角度的方向相反。发射器不转动。</translation>
    </message>
    <message>
        <source>Billows finer than the air: noise that rides on it, the same for all particles of a place. 0: none.</source>
        <translation>比空气网格更细的翻卷：随空气运动的噪声，同一处的所有粒子相同。0：无。</translation>
    </message>
    <message>
        <source>Max and Becker 1995; Neyret, Advected Textures, 2003</source>
        <translation>Max 与 Becker 1995；Neyret，Advected Textures，2003</translation>
    </message>
    <message>
        <source>Detail size</source>
        <translation>细节尺寸</translation>
    </message>
    <message>
        <source>Length of the largest billows of the detail; three octaves are finer. Five to six cells of the air.</source>
        <translation>细节中最大翻卷的长度；另有三个更细的倍频。约为空气网格的五到六格。</translation>
    </message>
    <message>
        <source>Detail life</source>
        <translation>细节寿命</translation>
    </message>
    <message>
        <source>How long the air carries a piece of detail before it is replaced: longer is steadier, until it is drawn out to hair. About 2 over the rate at which the air shears.</source>
        <translation>空气携带一处细节多久后才更换：越长越稳定，直到被拉成细丝。约为 2 除以空气的剪切率。</translation>
    </message>
    <message>
        <source>Detail relief</source>
        <translation>细节浮雕</translation>
    </message>
    <message>
        <source>How much the detail catches the light.</source>
        <translation>细节受光的程度。</translation>
    </message>
    <message>
        <source>Detail at edges</source>
        <translation>边缘细节</translation>
    </message>
    <message>
        <source>Share of the detail that thin smoke shows: 0 leaves veils soft, 1 cuts them as deep as dense smoke.</source>
        <translation>稀薄烟雾所显示细节的比例：0 使薄纱保持柔和，1 使其与浓烟同样深刻。</translation>
    </message>
    <message>
        <source>Detail shadow</source>
        <translation>细节阴影</translation>
    </message>
    <message>
        <source>How much the detail throws shadow into its own folds.</source>
        <translation>细节在自身褶皱中投下阴影的程度。</translation>
    </message>
    <message>
        <source>Surge</source>
        <translation>涌动</translation>
    </message>
    <message>
        <source>How much a steady source comes in puffs: its heat, speed and expansion swell and fall, each puff as strong as chance has it; the mean stays. 0: even.</source>
        <translation>稳定源以一阵阵的方式喷出的程度：热量、速度和膨胀起伏，每一阵强弱随机；平均值不变。0：均匀。</translation>
    </message>
    <message>
        <source>Surge rate</source>
        <translation>涌动频率</translation>
    </message>
    <message>
        <source>Puffs a second; in a loop a whole number of them. A fire puffs at about 1.5 Hz over the root of its width in metres.</source>
        <translation>每秒阵数；循环中为整数。火焰的涌动频率约为 1.5 Hz 除以其宽度（米）的平方根。</translation>
    </message>
    <message>
        <source>Cetegen and Ahmed 1993</source>
        <translation>Cetegen 与 Ahmed 1993</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>开始</translation>
    </message>
    <message>
        <source>When the emission begins. What starts late is not prewarmed; in a loop it comes as much later.</source>
        <translation>发射开始的时间。延后开始的不预热；在循环中则相应推迟。</translation>
    </message>
    <message>
        <source>How long smoke is emitted; in a loop, in each turn of it. 0: for ever. What ends is not prewarmed.</source>
        <translation>烟雾发射多久；循环中指每一圈。0：永远。会结束的不预热。</translation>
    </message>
    <message>
        <source>In the air</source>
        <translation>在空气中</translation>
    </message>
    <message>
        <source>Carried: particles are the air&apos;s, as smoke is. Dragged: they have a velocity of their own, which drag takes towards the air&apos;s, as embers and debris have. Free: no air touches them. What is dragged or free bounces off ground and obstacle.</source>
        <translation>携带：粒子随空气而动，如同烟雾。拖曳：粒子有自己的速度，阻力使其趋向空气的速度，如余烬和碎屑。自由：不受空气影响。拖曳或自由的粒子会从地面和障碍物弹起。</translation>
    </message>
    <message>
        <source>Bounce</source>
        <translation>弹性</translation>
    </message>
    <message>
        <source>Share of its speed with which a dragged or free particle leaves ground and obstacle again.</source>
        <translation>拖曳或自由的粒子离开地面和障碍物时保留的速度比例。</translation>
    </message>
    <message>
        <source>Contact friction</source>
        <translation>接触摩擦</translation>
    </message>
    <message>
        <source>Share of its speed along ground or obstacle that a dragged or free particle loses in each touch.</source>
        <translation>拖曳或自由的粒子每次接触时沿地面或障碍物损失的速度比例。</translation>
    </message>
    <message>
        <source>Feeds the air</source>
        <translation>驱动空气</translation>
    </message>
    <message>
        <source>Whether the emitter heats, pushes and stirs the air. Without it its particles only follow the air that others move: embers, dust, debris.</source>
        <translation>发射器是否加热、推动和搅动空气。否则其粒子只跟随他者推动的空气：余烬、尘土、碎屑。</translation>
    </message>
    <message>
        <source>carried</source>
        <translation>携带</translation>
    </message>
    <message>
        <source>dragged</source>
        <translation>拖曳</translation>
    </message>
    <message>
        <source>free</source>
        <translation>自由</translation>
    </message>
    <message>
        <source>Inherit velocity</source>
        <translation>继承速度</translation>
    </message>
    <message>
        <source>Of a layer whose particles are born on those of another: the share of their velocity that they take along. 0: a trail that stays where it was left. 1: what goes on with them.</source>
        <translation>用于粒子诞生于另一图层粒子上的图层：带走其速度的比例。0：留在原处的拖尾。1：随之前进。</translation>
    </message>
    <message>
        <source>Key frames: as they are at each frame</source>
        <translation>关键帧：按每一帧的值</translation>
    </message>
    <message>
        <source>Key frames: as they are at each step</source>
        <translation>关键帧：按每一步的值</translation>
    </message>
    <message>
        <source>Key frames: as they are at a particle&apos;s birth</source>
        <translation>关键帧：按粒子诞生时的值</translation>
    </message>
    <message>
        <source>Key frames: summed up over time</source>
        <translation>关键帧：随时间累计</translation>
    </message>
    <message>
        <source>Emission rate</source>
        <translation>发射率</translation>
    </message>
    <message>
        <source>The share of the particles that are born: 1 all, 0 none. The source heats the air, and blows it up, as much less. With key frames it lets a fire be lit and go out.</source>
        <translation>诞生的粒子所占份额：1 为全部，0 为没有。源对空气的加热和膨胀也相应减少。配合关键帧可让火点燃和熄灭。</translation>
    </message>
    <message>
        <source>Width of the rectangle or the picture, across its normal.</source>
        <translation>矩形或图片的宽度，垂直于其法线。</translation>
    </message>
    <message>
        <source>Depth of the rectangle or the picture, across its normal and its width.</source>
        <translation>矩形或图片的深度，垂直于其法线和宽度。</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>图片</translation>
    </message>
    <message>
        <source>A PNG whose bright pixels give birth to particles, each as often as it is bright and opaque: a logo that burns. It lies on width and depth of the emitter, upright on a wall that faces +Z. Without one all of the rectangle does.</source>
        <translation>一张 PNG，其明亮像素诞生粒子，越亮越不透明就越频繁：燃烧的徽标。它铺在发射器的宽度和深度上，在朝向 +Z 的墙上为正立。没有图片时由整个矩形诞生。</translation>
    </message>
    <message>
        <source>A soft round puff, the bare square of the 2012 model, or a picture.</source>
        <translation>柔和的圆形烟团、2012 模型的纯方形，或图片。</translation>
    </message>
    <message>
        <source>A PNG that particles look like, as leaves or debris: its alpha is their shape, its colours are multiplied with that of the smoke. It turns and stretches with them, its longer edge as wide as they are; noise, erosion, relief, roundness and detail do not show in it. Without one they are squares.</source>
        <translation>粒子呈现为的 PNG，如树叶或碎片：其 alpha 是形状，其颜色与烟雾颜色相乘。它随粒子旋转和拉伸，长边与粒子同宽；噪声、侵蚀、浮雕、圆度和细节不在其中显示。没有图片时为方形。</translation>
    </message>
    <message>
        <source>picture</source>
        <translation>图片</translation>
    </message>
    <message>
        <source>Parent&apos;s life from</source>
        <translation>父粒子生命起点</translation>
    </message>
    <message>
        <source>Of a layer whose particles are born on those of another: the share of a parent&apos;s life from which on they are. 0.9: near its death, as the stars of a firework&apos;s shell.</source>
        <translation>适用于粒子生于另一图层粒子上的图层：从父粒子生命的哪个比例起开始产生。0.9：临近其消亡，如烟花弹中的星火。</translation>
    </message>
    <message>
        <source>Parent&apos;s life to</source>
        <translation>父粒子生命终点</translation>
    </message>
    <message>
        <source>Of a layer whose particles are born on those of another: the share of a parent&apos;s life up to which they are. 0.1: while it is young.</source>
        <translation>适用于粒子生于另一图层粒子上的图层：到父粒子生命的哪个比例为止产生。0.1：仅在其年轻时。</translation>
    </message>
    <message>
        <source>Multiple scattering</source>
        <translation>多重散射</translation>
    </message>
    <message>
        <source>Light that wanders through the smoke: folds light one another, and nothing that is white is black. 1: white as clouds and steam are. 0: every shadow stays as dark as it falls.</source>
        <translation>在烟雾中穿行的光：褶皱相互照亮，白色之处不再发黑。1：如云和蒸汽般洁白。0：阴影落下多暗就保持多暗。</translation>
    </message>
    <message>
        <source>Stam 1995, multiple scattering as a diffusion process</source>
        <translation>Stam 1995，作为扩散过程的多重散射</translation>
    </message>
    <message>
        <source>fluid solver simulation flow grid fire real realistic billow roll mushroom moving air</source>
        <translation>流体 模拟 解算 仿真 流场 网格 火 真实 写实 翻滚 翻卷 蘑菇 空气</translation>
    </message>
    <message>
        <source>grid cells voxels divisions quality detail</source>
        <translation>网格 单元 格子 体素 精度 质量 细节 划分 精细</translation>
    </message>
    <message>
        <source>auto automatic domain bounds box size</source>
        <translation>自动 自适应 域 边界 范围 盒子 包围盒 大小 匹配</translation>
    </message>
    <message>
        <source>domain bounds box width height depth</source>
        <translation>域 边界 盒子 范围 宽度 高度 深度 尺寸</translation>
    </message>
    <message>
        <source>domain position move box centre center</source>
        <translation>域 位置 移动 盒子 中心 位移 平移</translation>
    </message>
    <message>
        <source>rise lift tall high fast heat hot up float climb</source>
        <translation>上升 升起 抬升 高 快 热 热量 向上 漂浮 上浮 升力 飘</translation>
    </message>
    <message>
        <source>heat cold temperature short low</source>
        <translation>降温 热量 冷 变冷 散热 温度 凉 矮 低 短</translation>
    </message>
    <message>
        <source>wind speed slow blow</source>
        <translation>风 风速 速度 慢 吹 阻力 减速</translation>
    </message>
    <message>
        <source>confinement swirl curl turbulence detail curly vorticity</source>
        <translation>漩涡 旋涡 涡旋 约束 卷曲 旋转 湍流 细节 打旋</translation>
    </message>
    <message>
        <source>disturbance shredding force noise stir chaos break up spread billow rough wild</source>
        <translation>扰动 撕裂 紊流 力 噪声 搅动 混乱 打散 散开 扩散 翻滚 粗糙 狂乱 乱流</translation>
    </message>
    <message>
        <source>disturbance eddy swirl scale wavelength</source>
        <translation>扰动 漩涡 旋涡 尺度 大小 波长 尺寸 涡流</translation>
    </message>
    <message>
        <source>floor collision plane</source>
        <translation>地板 碰撞 平面 底面 地表</translation>
    </message>
    <message>
        <source>floor level altitude</source>
        <translation>高度 地板 海拔 水平面 标高</translation>
    </message>
    <message>
        <source>drag rough floor wall slip</source>
        <translation>阻力 粗糙 地板 墙 滑动 打滑 光滑 减速</translation>
    </message>
    <message>
        <source>collision collider body wall ceiling</source>
        <translation>碰撞 碰撞体 物体 墙 天花板 阻挡 挡板 方块 球</translation>
    </message>
    <message>
        <source>collision place centre center obstacle</source>
        <translation>位置 碰撞 地点 中心 移动 坐标 放置</translation>
    </message>
    <message>
        <source>collision width height depth diameter</source>
        <translation>大小 碰撞 宽度 高度 深度 直径 尺寸</translation>
    </message>
    <message>
        <source>orbit fixed free</source>
        <translation>环绕 固定 自由 轨道 绕行 摄像机</translation>
    </message>
    <message>
        <source>turn orbit rotate angle azimuth heading</source>
        <translation>旋转 转动 环绕 角度 方位角 朝向 水平角 左右</translation>
    </message>
    <message>
        <source>tilt elevation angle above below</source>
        <translation>倾斜 仰角 高度角 角度 俯视 仰视 上方 下方</translation>
    </message>
    <message>
        <source>zoom near far close dolly range</source>
        <translation>缩放 近 远 拉近 推近 拉远 推拉 变焦 远近</translation>
    </message>
    <message>
        <source>look at pivot focus center</source>
        <translation>注视 看向 枢轴 焦点 中心 对准 观察点</translation>
    </message>
    <message>
        <source>turn spin rotate orbit</source>
        <translation>旋转 自转 转动 环绕 转盘 绕圈</translation>
    </message>
    <message>
        <source>place location move eye</source>
        <translation>地点 坐标 移动 视点 机位 放置</translation>
    </message>
    <message>
        <source>look direction aim</source>
        <translation>方向 看向 朝向 瞄准 注视 观看</translation>
    </message>
    <message>
        <source>zoom lens wide field of view fov</source>
        <translation>变焦 镜头 广角 视野 视场角 视角 缩放 长焦 fov</translation>
    </message>
    <message>
        <source>life duration lifespan age seconds long longer short shorter live last persist linger die</source>
        <translation>生命 时长 持续 年龄 秒 长 更长 短 更短 存活 久 停留 死亡 消失</translation>
    </message>
    <message>
        <source>thick dense more number amount quantity density rate spawn</source>
        <translation>浓 数量 密集 更多 个数 密度 浓密 厚 稠密 多 少 生成</translation>
    </message>
    <message>
        <source>birth spawn amount share on off fire lit goes out swell ignite extinguish</source>
        <translation>诞生 出生 生成 份额 数量 开关 开 关 火 点火 点燃 熄灭 增强</translation>
    </message>
    <message>
        <source>source form disc disk sphere rectangle picture image logo text mask</source>
        <translation>源 外形 圆盘 球 球体 矩形 图片 图像 标志 徽标 文字 遮罩</translation>
    </message>
    <message>
        <source>source wide narrow size diameter width</source>
        <translation>源 宽 窄 大小 直径 宽度 粗 细 尺寸</translation>
    </message>
    <message>
        <source>source size wide narrow</source>
        <translation>源 大小 尺寸 窄 粗细</translation>
    </message>
    <message>
        <source>size source length</source>
        <translation>大小 源 长度 尺寸 纵深</translation>
    </message>
    <message>
        <source>image logo text mask texture map bright pixels png file</source>
        <translation>图像 标志 徽标 文字 遮罩 纹理 贴图 亮 像素 png 文件 照片</translation>
    </message>
    <message>
        <source>direction aim up orientation</source>
        <translation>方向 朝向 瞄准 向上 指向 取向</translation>
    </message>
    <message>
        <source>place location source move origin path carry swing</source>
        <translation>地点 坐标 源 移动 原点 路径 轨迹 携带 挥动 摆动</translation>
    </message>
    <message>
        <source>velocity fast slow initial jet throw strong weak</source>
        <translation>快 慢 初速度 射流 喷射 抛出 强 弱 速率</translation>
    </message>
    <message>
        <source>random chaos jitter irregular uneven wild velocity randomness</source>
        <translation>随机 混乱 抖动 不规则 不均匀 狂乱 变化 差异 速率</translation>
    </message>
    <message>
        <source>wide narrow cone angle nozzle fan direction focused spread</source>
        <translation>宽 窄 圆锥 锥角 角度 喷嘴 扇形 方向 集中 聚焦 散开</translation>
    </message>
    <message>
        <source>parent trail born on sub emitter take along throw</source>
        <translation>父级 父粒子 拖尾 尾迹 诞生 子发射器 带走 速度 抛出 跟随</translation>
    </message>
    <message>
        <source>birth death dies end burst on death sub emitter age firework event</source>
        <translation>出生 诞生 死亡 消亡 结束 爆裂 爆发 子发射器 年龄 烟花 事件 起点</translation>
    </message>
    <message>
        <source>birth death dies end burst on birth sub emitter age firework event</source>
        <translation>出生 诞生 死亡 消亡 结束 爆裂 爆发 子发射器 年龄 烟花 事件 终点</translation>
    </message>
    <message>
        <source>burst explosion puff continuous once</source>
        <translation>爆发 爆炸 一阵 喷发 持续 连续 一次 单次</translation>
    </message>
    <message>
        <source>burst explosion puff time</source>
        <translation>爆炸 一阵 喷发 时间 时长 持续时间 长度</translation>
    </message>
    <message>
        <source>delay begin time offset late when</source>
        <translation>延迟 起始 时间 偏移 晚 推迟 何时 启动 延后</translation>
    </message>
    <message>
        <source>end stop emit time</source>
        <translation>结束 停止 发射 时间 时长 持续 终止</translation>
    </message>
    <message>
        <source>smooth stream stripes bands birth between steps</source>
        <translation>平滑 连续 流 条纹 条带 出生 诞生 步间 子帧</translation>
    </message>
    <message>
        <source>random different another</source>
        <translation>随机 不同 另一个 换一个 变化 随机数</translation>
    </message>
    <message>
        <source>flame fire glow burn heat hot incandescent emission flash</source>
        <translation>火 发光 辉光 燃烧 热 炽热 白炽 亮度 亮 自发光 闪光 火光</translation>
    </message>
    <message>
        <source>fade glow flame fire smoky soot</source>
        <translation>冷却 消退 减弱 火焰 火 黑烟 烟炱 煤烟 降温</translation>
    </message>
    <message>
        <source>center inside white hot fire flame</source>
        <translation>内核 核心 中心 内部 白 白热 热 火 火焰</translation>
    </message>
    <message>
        <source>clear transparent soot additive fire</source>
        <translation>清澈 透明 不透明 烟炱 煤烟 叠加 通透 浓 火</translation>
    </message>
    <message>
        <source>flame glow bounce illuminate indirect lit light fire</source>
        <translation>火焰 辉光 反弹 照亮 照明 间接光 打光 光 映照 火</translation>
    </message>
    <message>
        <source>blackbody color fire flame emission from</source>
        <translation>黑体 颜色 火焰 火 辐射 来源 色彩 自发光 色温</translation>
    </message>
    <message>
        <source>heat kelvin hot cold fire blackbody red blue</source>
        <translation>热量 开尔文 热 冷 色温 火 火焰 黑体 红 蓝</translation>
    </message>
    <message>
        <source>color colors fire flame ramp gradient green blue magic</source>
        <translation>颜色 色彩 火焰 火 渐变 色带 绿 蓝 魔法</translation>
    </message>
    <message>
        <source>fade vanish disappear dissolve fast slow lifetime life duration age lifespan out die</source>
        <translation>消失 消散 渐隐 褪去 溶解 快 慢 寿命 生命 时长 年龄 死亡 衰减 速率</translation>
    </message>
    <message>
        <source>transparent transparency opacity density start</source>
        <translation>透明 透明度 不透明度 浓度 密度 开始 起始</translation>
    </message>
    <message>
        <source>life duration random variation lifespan lifetime variance</source>
        <translation>生命 随机 变化 差异 时长 年龄 方差 不同</translation>
    </message>
    <message>
        <source>grow shrink scale expansion curve</source>
        <translation>大小 增长 变大 长大 缩小 变小 缩放 膨胀 曲线 寿命</translation>
    </message>
    <message>
        <source>fade in transparent transparency opacity curve</source>
        <translation>淡入 透明度 透明 不透明度 曲线 渐显 浓度 寿命</translation>
    </message>
    <message>
        <source>sun angle lamp lighting</source>
        <translation>太阳 阳光 角度 灯 灯光 照明 光照 朝向</translation>
    </message>
    <message>
        <source>bright dark brightness sun strength dim light intensity flash lightning strobe</source>
        <translation>亮 明亮 暗 亮度 太阳 阳光 昏暗 光 闪光 闪电 频闪</translation>
    </message>
    <message>
        <source>dark self-shadow shade black absorption thick contrast</source>
        <translation>暗 黑 自阴影 影子 变暗 吸收 厚 浓 对比度</translation>
    </message>
    <message>
        <source>bright translucent soft milky white</source>
        <translation>半透明 亮 柔和 乳白 白 透光 通透</translation>
    </message>
    <message>
        <source>diffuse diffusion white cloud steam snow bounce fill soft bright translucent subsurface black</source>
        <translation>散射 漫射 扩散 白 云 蒸汽 雪 反弹 补光 柔和 亮 半透明 次表面 黑</translation>
    </message>
    <message>
        <source>forward back rim silver lining phase anisotropy</source>
        <translation>前向 后向 边缘光 轮廓光 银边 相位 逆光 散射 背光</translation>
    </message>
    <message>
        <source>fill sky brightness bright dark dim</source>
        <translation>补光 天光 天空 亮度 亮 暗 昏暗 填充光</translation>
    </message>
    <message>
        <source>color sun tint warm cold</source>
        <translation>太阳 阳光 色调 色彩 染色 暖 冷</translation>
    </message>
    <message>
        <source>color ambient blue above</source>
        <translation>颜色 环境光 蓝 上方 天光 蓝天</translation>
    </message>
    <message>
        <source>color ambient bounce below floor</source>
        <translation>颜色 环境光 反弹 反射 下方 地板</translation>
    </message>
    <message>
        <source>ao ambient dark shade</source>
        <translation>ao 环境光 暗 阴影 遮挡 闭塞 变暗</translation>
    </message>
    <message>
        <source>quality detail shadow grid voxels</source>
        <translation>质量 细节 阴影 网格 体素 精度 精细</translation>
    </message>
    <message>
        <source>thick transparent thin dense mist fog haze density transparency thickness heavy faint alpha solid see-through</source>
        <translation>浓 透明 稀薄 薄 厚 雾 薄雾 霾 浓度 密度 透明度 浓重 淡 实心</translation>
    </message>
    <message>
        <source>big small large scale particle puff diameter tiny huge fat soft thick</source>
        <translation>大 小 尺寸 缩放 粒子 烟团 直径 微小 巨大 胖 柔和 厚</translation>
    </message>
    <message>
        <source>color tint white black dark bright light albedo gray grey dirty</source>
        <translation>色调 染色 白 黑 暗 深 亮 浅 反照率 灰 脏 色彩</translation>
    </message>
    <message>
        <source>color gradient tint ramp age</source>
        <translation>颜色 渐变 色调 染色 色带 年龄 变色 色彩 寿命</translation>
    </message>
    <message>
        <source>sharp crisp cauliflower billow noise displacement upres wavelet advected texture focus folds</source>
        <translation>锐利 清晰 花椰菜 菜花 翻卷 噪声 噪波 置换 升频 小波 纹理 聚焦 褶皱</translation>
    </message>
    <message>
        <source>scale wavelength billow noise frequency largest</source>
        <translation>尺寸 大小 缩放 波长 翻卷 噪声 频率 最大 尺度</translation>
    </message>
    <message>
        <source>regenerate advect dissolve hair boil time</source>
        <translation>寿命 再生 更新 平流 溶解 发丝 头发 沸腾 翻腾 时间</translation>
    </message>
    <message>
        <source>bump normal surface light plastic</source>
        <translation>浮雕 凹凸 法线 表面 光 塑料 立体 凸起</translation>
    </message>
    <message>
        <source>thin wisps rim haze veil feather soft</source>
        <translation>细节 薄 稀薄 丝缕 轮廓 薄雾 薄纱 羽化 柔和</translation>
    </message>
    <message>
        <source>folds clefts depth occlusion self-shadow</source>
        <translation>阴影 褶皱 缝隙 裂缝 深度 遮蔽 自阴影 凹陷</translation>
    </message>
    <message>
        <source>detail noise holes transparent grain texture</source>
        <translation>细节 噪声 噪波 孔洞 洞 透明 颗粒 质感 贴图</translation>
    </message>
    <message>
        <source>dissolve holes wispy ragged torn break up</source>
        <translation>溶解 消融 孔洞 洞 丝缕 破碎 破烂 撕裂 散开 腐蚀</translation>
    </message>
    <message>
        <source>dissolve holes edge</source>
        <translation>溶解 柔和 孔洞 洞 边缘 过渡 羽化</translation>
    </message>
    <message>
        <source>soft hard edge crisp sharp blur feather rim smooth mist</source>
        <translation>柔和 软 柔软 硬 边缘 清晰 锐利 模糊 羽化 轮廓 平滑 薄雾</translation>
    </message>
    <message>
        <source>bump normal depth volume plastic</source>
        <translation>凹凸 法线 深度 体积 立体 塑料 凸起</translation>
    </message>
    <message>
        <source>ball round volume puffy fluffy shading</source>
        <translation>球 圆 圆润 球形 体积 蓬松 松软 明暗 着色</translation>
    </message>
    <message>
        <source>random size variation variance</source>
        <translation>随机 变化 差异 不同 尺寸 方差</translation>
    </message>
    <message>
        <source>thin mist expand density mass haze dilution</source>
        <translation>稀薄 变薄 变淡 薄雾 扩散 膨胀 密度 浓度 质量 衰减 雾</translation>
    </message>
    <message>
        <source>dots grain lone haze merge blend grow neighbours smooth mist fog</source>
        <translation>斑点 点 颗粒 孤立 薄雾 合并 融合 混合 变大 相邻 平滑 雾</translation>
    </message>
    <message>
        <source>soft particles depth fade floor foot cut intersection contact</source>
        <translation>软粒子 柔和粒子 深度 淡出 地板 底部 切口 穿插 交线 接触</translation>
    </message>
    <message>
        <source>noise zoom tiling detail</source>
        <translation>比例 噪声 缩放 平铺 重复 细节 大小</translation>
    </message>
    <message>
        <source>boil animate evolve noise speed</source>
        <translation>沸腾 翻腾 动画 演变 演化 噪声 速度 变化</translation>
    </message>
    <message>
        <source>rotate angle random rotation variance</source>
        <translation>角度 转动 随机 变化 差异 朝向</translation>
    </message>
    <message>
        <source>rotate rotation turn fast</source>
        <translation>旋转 转动 转 快 打转 转速</translation>
    </message>
    <message>
        <source>rotate random rotation spin variance</source>
        <translation>旋转 转动 随机 变化 差异 转速</translation>
    </message>
    <message>
        <source>rotate swirl billow</source>
        <translation>旋转 滚动 漩涡 旋涡 翻卷 转动</translation>
    </message>
    <message>
        <source>ellipse anisotropic sheet curl strand flatten shear</source>
        <translation>椭圆 变形 各向异性 薄片 卷曲 丝缕 压扁 剪切 拉伸 扭曲</translation>
    </message>
    <message>
        <source>relax relaxation round memory</source>
        <translation>时间 松弛 恢复 复原 圆 变圆 记忆 变形</translation>
    </message>
    <message>
        <source>ellipse longest thinnest aspect ratio hair</source>
        <translation>极限 椭圆 最长 最细 长宽比 上限 发丝 变形</translation>
    </message>
    <message>
        <source>streak motion blur velocity long</source>
        <translation>条纹 拖影 运动模糊 速度 长 拉长 拖尾</translation>
    </message>
    <message>
        <source>flame fire hot transparent burn opacity heat</source>
        <translation>不透明度 热量 火焰 火 热 透明 燃烧 高温</translation>
    </message>
    <message>
        <source>shape sprite square round mask picture image leaf debris</source>
        <translation>形状 精灵 贴片 方形 圆形 蒙版 图片 图像 叶子 碎片 碎屑</translation>
    </message>
    <message>
        <source>image leaf leaves debris sprite texture map flake petal feather png file</source>
        <translation>图像 叶子 树叶 碎屑 碎片 精灵 纹理 贴图 雪花 花瓣 羽毛 png 文件</translation>
    </message>
    <message>
        <source>advect carried dragged inertia ballistic free heavy sparks embers debris collide</source>
        <translation>携带 平流 拖曳 惯性 弹道 自由 重 火花 余烬 碎屑 碎片 碰撞 空气</translation>
    </message>
    <message>
        <source>restitution elastic rebound collision</source>
        <translation>反弹 弹跳 回弹 恢复系数 碰撞 弹起</translation>
    </message>
    <message>
        <source>slide stick roll collision ground</source>
        <translation>摩擦 摩擦力 滑动 粘住 滚动 碰撞 地面</translation>
    </message>
    <message>
        <source>fall weight down heavy sink drop light</source>
        <translation>下落 重量 向下 重 沉 下沉 落下 坠落 轻 引力</translation>
    </message>
    <message>
        <source>friction slow air resistance damping brake calm</source>
        <translation>摩擦 慢 减速 空气阻力 阻尼 刹车 平静 缓慢</translation>
    </message>
    <message>
        <source>chaos jitter random noise irregular wild messy</source>
        <translation>混乱 抖动 随机 噪声 不规则 狂乱 杂乱 凌乱</translation>
    </message>
    <message>
        <source>random hot rise heat variance</source>
        <translation>随机 热 上升 变化 差异 不同 温度</translation>
    </message>
    <message>
        <source>attract inflow narrow thin column tight pull to axis</source>
        <translation>吸引 流入 窄 细 柱 烟柱 收紧 聚拢 拉向 轴</translation>
    </message>
    <message>
        <source>spin turn swirl twist whirl</source>
        <translation>自转 转动 漩涡 旋涡 扭转 打转 回旋</translation>
    </message>
    <message>
        <source>spin random</source>
        <translation>自转 随机 抖动 转动 晃动</translation>
    </message>
    <message>
        <source>weight heavy light</source>
        <translation>重量 重 轻 沉 分量</translation>
    </message>
    <message>
        <source>detail layers fractal levels fine</source>
        <translation>细节 层 层数 分形 级别 精细 八度 叠加</translation>
    </message>
    <message>
        <source>sharp crisp contrast hard soft</source>
        <translation>锐利 清晰 对比度 硬 柔和 软 锐化</translation>
    </message>
    <message>
        <source>frequency scale size coarse fine</source>
        <translation>频率 缩放 大小 粗 细 尺度</translation>
    </message>
    <message>
        <source>gain amplitude roughness detail</source>
        <translation>增益 振幅 粗糙度 细节 幅度</translation>
    </message>
    <message>
        <source>threshold amount fill bias</source>
        <translation>阈值 填充 多少 偏置 覆盖率 数量</translation>
    </message>
    <message>
        <source>distort bend domain swirl</source>
        <translation>变形 畸变 弯曲 域 漩涡 旋涡</translation>
    </message>
    <message>
        <source>blur soft</source>
        <translation>模糊 柔和 软 光滑 柔化</translation>
    </message>
    <message>
        <source>type perlin simplex value</source>
        <translation>类型 种类 perlin simplex 柏林噪声 单纯形 值 算法</translation>
    </message>
    <message>
        <source>smooth linear cosine cubic</source>
        <translation>平滑 线性 余弦 三次 过渡</translation>
    </message>
    <message>
        <source>frequency detail</source>
        <translation>频率 细节 倍数 空隙 精细</translation>
    </message>
    <message>
        <source>boil evolve third</source>
        <translation>沸腾 翻腾 演变 演化 第三轴</translation>
    </message>
    <message>
        <source>layers quality</source>
        <translation>层 质量 层数 片数</translation>
    </message>
    <message>
        <source>size pixels quality detail</source>
        <translation>大小 像素 质量 细节 尺寸 精度</translation>
    </message>
    <message>
        <source>resolution size pixels wide</source>
        <translation>分辨率 大小 像素 尺寸 画面</translation>
    </message>
    <message>
        <source>resolution size pixels tall high</source>
        <translation>分辨率 大小 像素 尺寸 画面 高</translation>
    </message>
    <message>
        <source>draft final preview particles</source>
        <translation>草稿 最终 预览 粒子 品质 画质</translation>
    </message>
    <message>
        <source>antialias anti-aliasing smooth aa</source>
        <translation>抗锯齿 锯齿 反走样 平滑 aa</translation>
    </message>
    <message>
        <source>bright dark brightness gamma light dim flash</source>
        <translation>亮 暗 亮度 明暗 伽马 光 昏暗 闪光</translation>
    </message>
    <message>
        <source>tone mapping filmic color management gamma</source>
        <translation>色调映射 胶片 电影感 色彩管理 伽马</translation>
    </message>
    <message>
        <source>transparent alpha backdrop</source>
        <translation>透明 透明通道 alpha 底图 衬底</translation>
    </message>
    <message>
        <source>color backdrop behind</source>
        <translation>颜色 底色 衬底 后面 色彩</translation>
    </message>
    <message>
        <source>mushroom billow puff roll vortex</source>
        <translation>蘑菇 翻卷 烟团 翻滚 涡环 漩涡 涡旋 烟圈</translation>
    </message>
    <message>
        <source>rise velocity</source>
        <translation>速度 升起 升高 向上</translation>
    </message>
    <message>
        <source>size</source>
        <translation>大小 尺寸 直径 大 小</translation>
    </message>
    <message>
        <source>grow expand widening</source>
        <translation>变大 扩大 变宽 扩展 增长</translation>
    </message>
    <message>
        <source>distance puffs rate</source>
        <translation>距离 间隔 烟团 频率 疏密</translation>
    </message>
    <message>
        <source>repeat trail followers</source>
        <translation>重复 拖尾 尾迹 跟随 后面</translation>
    </message>
    <message>
        <source>random irregular variance</source>
        <translation>随机 不规则 变化 方差 不同</translation>
    </message>
    <message>
        <source>heat push drive passive emits heats influence follows</source>
        <translation>加热 热 推动 被动 发射 影响 跟随 带动 空气</translation>
    </message>
    <message>
        <source>irregular noise source asymmetry breathe flicker raggedness</source>
        <translation>不规则 噪声 源 不对称 呼吸 闪烁 毛糙 起伏</translation>
    </message>
    <message>
        <source>billows cauliflower hot spots noise source asymmetry heterogeneous bald uneven heat</source>
        <translation>翻卷 菜花 花椰菜 热点 噪声 源 不对称 光秃 热量 热</translation>
    </message>
    <message>
        <source>explosion blast pressure burst divergence big</source>
        <translation>爆炸 冲击波 压力 爆发 爆裂 散度 大 扩张 炸开</translation>
    </message>
    <message>
        <source>puff pulse breathe flicker lull rhythm uneven speed burst pump throb</source>
        <translation>一阵 脉动 脉冲 呼吸 闪烁 间歇 节奏 不均匀 速度 爆发 泵 搏动 起伏 喷吐</translation>
    </message>
    <message>
        <source>puff pulse frequency flicker rhythm puffing</source>
        <translation>频率 一阵 脉动 脉冲 闪烁 节奏 节拍 速率</translation>
    </message>
    <message>
        <source>duration frames end time long short</source>
        <translation>时长 帧数 帧 结束 时间 总帧数 短</translation>
    </message>
    <message>
        <source>loop seamless repeat cycle tile endless forever</source>
        <translation>循环 重复 周期 平铺 无限 永远 首尾相接</translation>
    </message>
    <message>
        <source>preroll pre-roll warmup start warm</source>
        <translation>预运行 热身 预演 预滚 起始 开始 暖</translation>
    </message>
    <message>
        <source>fps speed fast slow playback</source>
        <translation>fps 速度 快 慢 播放 帧频 每秒</translation>
    </message>
    <message>
        <source>substeps quality accuracy steps frame</source>
        <translation>子步 质量 精度 步数 步长 帧 准确</translation>
    </message>
    <message>
        <source>swirl chaos wild wavy turbulent messy calm curl noise rough smooth</source>
        <translation>漩涡 旋涡 混乱 狂乱 波动 紊乱 杂乱 平静 卷曲 噪声 粗糙 平滑 湍流 紊流</translation>
    </message>
    <message>
        <source>swirl size eddies big small coarse fine</source>
        <translation>漩涡 旋涡 大小 涡流 大 小 粗 细 缩放</translation>
    </message>
    <message>
        <source>detail layers swirl fine</source>
        <translation>细节 层 层数 漩涡 旋涡 精细</translation>
    </message>
    <message>
        <source>detail gain persistence</source>
        <translation>细节 增益 持续度 粗 毛糙</translation>
    </message>
    <message>
        <source>speed change animate fast slow</source>
        <translation>速度 变化 动画 快 慢 演化</translation>
    </message>
    <message>
        <source>delay start calm onset</source>
        <translation>延迟 开始 平静 淡入 渐入 时间</translation>
    </message>
    <message>
        <source>height taller high bigger larger</source>
        <translation>高度 增长 变高 变大 更大 高</translation>
    </message>
    <message>
        <source>rise move speed</source>
        <translation>上升 移动 速度 飘动 飘</translation>
    </message>
    <message>
        <source>wavelet turbulence noise subgrid sub-grid small swirls</source>
        <translation>小波 湍流 噪声 子网格 小漩涡 小旋涡</translation>
    </message>
    <message>
        <source>tornado swirl twist spin whirl</source>
        <translation>龙卷风 漩涡 旋涡 涡旋 扭转 旋转 自转 打转</translation>
    </message>
    <message>
        <source>tornado width size</source>
        <translation>龙卷风 宽度 大小 尺寸 直径</translation>
    </message>
    <message>
        <source>tornado funnel cone grow expand widening</source>
        <translation>龙卷风 漏斗 锥形 变大 扩大 变宽 扩展</translation>
    </message>
    <message>
        <source>tornado direction</source>
        <translation>龙卷风 方向 朝向 轴线 轴向</translation>
    </message>
    <message>
        <source>blow breeze force air sideways drift lean fast strong</source>
        <translation>风 吹 微风 力 空气 侧向 漂移 倾斜 快 强 大风 刮风</translation>
    </message>
    <message>
        <source>direction blow heading</source>
        <translation>风 方向 吹 朝向 角度</translation>
    </message>
    <message>
        <source>wind wander random breeze</source>
        <translation>风 游移 随机 微风 变化 乱风</translation>
    </message>
    <message>
        <source>wind frequency</source>
        <translation>风 频率 速率 快慢</translation>
    </message>
    <message>
        <source>Time scale</source>
        <translation>时间缩放</translation>
    </message>
    <message>
        <source>speed fast slow motion playback simulation faster slower tempo</source>
        <translation>速度 快 慢 慢动作 播放 模拟 加快 放慢 节奏</translation>
    </message>
    <message>
        <source>Seconds of smoke in a second of film: 2 lets all of it happen twice as fast, 0.5 in slow motion. Key frames, start and length keep their frames.</source>
        <translation>影片每一秒对应的烟雾秒数：2 使一切快一倍，0.5 为慢动作。关键帧、开始和时长保持各自的帧。</translation>
    </message>
</context>
<context>
    <name>fumage::ui::PasteDialog</name>
    <message>
        <source>Paste parameters</source>
        <translation>粘贴参数</translation>
    </message>
    <message>
        <source>Give %1 these parameters of “%2”:</source>
        <translation>把“%2”的这些参数赋给 %1：</translation>
    </message>
    <message>
        <source>Paste</source>
        <translation>粘贴</translation>
    </message>
    <message>
        <source>All</source>
        <translation>全部</translation>
    </message>
    <message>
        <source>None</source>
        <translation>无</translation>
    </message>
</context>
<context>
    <name>fumage::ui::PictureChoices</name>
    <message>
        <source>Fit the camera to the smoke of all frames</source>
        <translation>使摄像机适应所有帧的烟雾</translation>
    </message>
    <message>
        <source>Pictures are taken from where all smoke is seen and fills them; the view stays as it is</source>
        <translation>从能看到全部烟雾并使其充满画面的位置拍摄；视图保持不变</translation>
    </message>
    <message>
        <source>Fumage then opens a picture as the preset that it was made of, at its frame</source>
        <translation>这样 Fumage 打开图片时会还原生成它的预设，并停在对应的帧</translation>
    </message>
    <message>
        <source>A file beside the others with what each of them shows: Verify, in the panel Exports, and fumage-cli verify then find those that are missing, broken or changed</source>
        <translation>在其他文件旁写出一个文件，记录它们各自显示的内容：之后“导出”面板中的“校验”和 fumage-cli verify 可找出缺失、损坏或改变的文件</translation>
    </message>
    <message>
        <source>Embed the preset in pictures</source>
        <translation>将预设嵌入图片</translation>
    </message>
    <message>
        <source>Write a manifest of checksums</source>
        <translation>写出含校验和的清单</translation>
    </message>
    <message>
        <source>Write a mask of each layer</source>
        <translation>写出每个图层的遮罩</translation>
    </message>
    <message>
        <source>Channels of an EXR that say how much of each layer is seen: together they are its alpha</source>
        <translation>EXR 的通道，说明每个图层可见多少：合计即为其 alpha</translation>
    </message>
    <message>
        <source>Ignore outliers</source>
        <translation>忽略离群</translation>
    </message>
    <message>
        <source>How much of the smoke may be outside, such as stray sparks, so that the rest is larger</source>
        <translation>允许多少烟雾（如零星火花）位于画面之外，使其余部分更大</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
</context>
<context>
    <name>fumage::ui::PictureEditor</name>
    <message>
        <source>Remove the picture</source>
        <translation>移除图片</translation>
    </message>
    <message>
        <source>remove</source>
        <translation>移除</translation>
    </message>
    <message>
        <source>Press to choose a PNG, or drop one here</source>
        <translation>按此选择 PNG，或拖放到这里</translation>
    </message>
    <message>
        <source>Choose a picture</source>
        <translation>选择图片</translation>
    </message>
    <message>
        <source>Pictures (*.png)</source>
        <translation>图片 (*.png)</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>选择…</translation>
    </message>
</context>
<context>
    <name>fumage::ui::PointStrip</name>
    <message>
        <source>Delete the point</source>
        <translation>删除该点</translation>
    </message>
</context>
<context>
    <name>fumage::ui::Preferences</name>
    <message>
        <source>Preferences</source>
        <translation>首选项</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>主题</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>语言</translation>
    </message>
    <message>
        <source>The language changes when Fumage starts the next time.</source>
        <translation>语言将在下次启动 Fumage 时更改。</translation>
    </message>
    <message>
        <source>Mouse in the viewport</source>
        <translation>视口中的鼠标操作</translation>
    </message>
    <message>
        <source>OpenGL</source>
        <translation>OpenGL</translation>
    </message>
    <message>
        <source>Where there is a graphics card</source>
        <translation>有显卡时</translation>
    </message>
    <message>
        <source>Always</source>
        <translation>始终</translation>
    </message>
    <message>
        <source>Never</source>
        <translation>从不</translation>
    </message>
    <message>
        <source>“Never” helps where the picture is black or torn. It takes effect when Fumage starts the next time.</source>
        <translation>如果画面全黑或撕裂，请选择“从不”。下次启动 Fumage 时生效。</translation>
    </message>
    <message>
        <source>Memory for pictures</source>
        <translation>图像内存</translation>
    </message>
    <message>
        <source> MB</source>
        <translation> MB</translation>
    </message>
    <message>
        <source>Frames that a window keeps to play them again at once. Simulation and air come on top.</source>
        <translation>窗口为立即重播而保留的帧。模拟和空气另外占用内存。</translation>
    </message>
    <message>
        <source>Show presets when Fumage starts</source>
        <translation>启动 Fumage 时显示预设</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>启动</translation>
    </message>
    <message>
        <source>Show the folder</source>
        <translation>显示文件夹</translation>
    </message>
    <message>
        <source>Recovery</source>
        <translation>恢复</translation>
    </message>
    <message>
        <source>A copy of unsaved work is kept a second after each change, and is opened again should the program end unexpectedly: %1</source>
        <translation>每次更改一秒后都会保存一份未保存工作的副本，如果程序意外退出，将重新打开：%1</translation>
    </message>
    <message>
        <source>Threads</source>
        <translation>线程</translation>
    </message>
    <message>
        <source>All (%1)</source>
        <translation>全部 (%1)</translation>
    </message>
    <message>
        <source>Fewer leave more of the processor to other programs. Results are the same.</source>
        <translation>较少线程可为其他程序留出更多处理器。结果相同。</translation>
    </message>
    <message>
        <source>Thumbnails on the disk</source>
        <translation>磁盘上的缩略图</translation>
    </message>
    <message>
        <source> MB at most</source>
        <translation> MB 上限</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>清除</translation>
    </message>
    <message>
        <source>%1 now</source>
        <translation>当前 %1</translation>
    </message>
    <message>
        <source>Play thumbnails under the pointer</source>
        <translation>指针悬停时播放缩略图</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>动态</translation>
    </message>
</context>
<context>
    <name>fumage::ui::PresetBrowser</name>
    <message>
        <source>Search presets</source>
        <translation>搜索预设</translation>
    </message>
    <message>
        <source>Favourites only</source>
        <translation>仅收藏</translation>
    </message>
    <message>
        <source>Delete the preset</source>
        <translation>删除预设</translation>
    </message>
    <message>
        <source>Delete “%1”? The file goes to the trash.</source>
        <translation>要删除“%1”吗？文件会移到回收站。</translation>
    </message>
    <message>
        <source>“%1” cannot be moved to the trash. Delete the file by hand.</source>
        <translation>无法把“%1”移到回收站。请手动删除该文件。</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>打开</translation>
    </message>
    <message>
        <source>Apply to this document</source>
        <translation>放入此文档</translation>
    </message>
    <message>
        <source>No longer a favourite</source>
        <translation>取消收藏</translation>
    </message>
    <message>
        <source>Make a favourite</source>
        <translation>加入收藏</translation>
    </message>
    <message>
        <source>Delete…</source>
        <translation>删除…</translation>
    </message>
    <message>
        <source>Add its layers</source>
        <translation>添加其图层</translation>
    </message>
</context>
<context>
    <name>fumage::ui::PresetList</name>
    <message>
        <source>Presets</source>
        <translation>预设</translation>
    </message>
    <message>
        <source> (broken)</source>
        <translation>（已损坏）</translation>
    </message>
    <message>
        <source>There are no favourites yet: the menu of a preset makes it one.</source>
        <translation>还没有收藏：可在预设的菜单中将其设为收藏。</translation>
    </message>
    <message>
        <source>No preset matches “%1”.</source>
        <translation>没有与“%1”相关的预设。</translation>
    </message>
</context>
<context>
    <name>Presets</name>
    <message>
        <source>Campfire</source>
        <translation>篝火</translation>
    </message>
    <message>
        <source>Chimney</source>
        <translation>烟囱</translation>
    </message>
    <message>
        <source>Grey smoke from a stack, bent by a steady wind.</source>
        <translation>烟囱冒出的灰烟，被稳定的风吹弯。</translation>
    </message>
    <message>
        <source>Cigarette</source>
        <translation>香烟</translation>
    </message>
    <message>
        <source>A thin thread of smoke that breaks into curls.</source>
        <translation>一缕细烟，散成卷曲的涡旋。</translation>
    </message>
    <message>
        <source>Cloud</source>
        <translation>云</translation>
    </message>
    <message>
        <source>Coloured smoke</source>
        <translation>彩色烟雾</translation>
    </message>
    <message>
        <source>A dense magenta canister, as at parades.</source>
        <translation>浓密的洋红色烟雾罐，如庆典所用。</translation>
    </message>
    <message>
        <source>Default</source>
        <translation>默认</translation>
    </message>
    <message>
        <source>What a new document shows: a white plume in a light breeze.</source>
        <translation>新建文档所显示的内容：微风中的白色烟柱。</translation>
    </message>
    <message>
        <source>Dust</source>
        <translation>尘土</translation>
    </message>
    <message>
        <source>Explosion</source>
        <translation>爆炸</translation>
    </message>
    <message>
        <source>A fireball that rolls up into a dark mushroom.</source>
        <translation>火球翻卷成黑色蘑菇云。</translation>
    </message>
    <message>
        <source>Ground fog</source>
        <translation>地面雾</translation>
    </message>
    <message>
        <source>A low bank that creeps over the ground.</source>
        <translation>贴着地面缓缓爬行的低雾。</translation>
    </message>
    <message>
        <source>Magic</source>
        <translation>魔法</translation>
    </message>
    <message>
        <source>A glowing spiral that winds around its axis.</source>
        <translation>绕轴盘旋的发光螺旋。</translation>
    </message>
    <message>
        <source>Plume</source>
        <translation>烟柱</translation>
    </message>
    <message>
        <source>A dense, billowing column of grey smoke, as from a great fire.</source>
        <translation>浓密翻滚的灰色烟柱，如大火所生。</translation>
    </message>
    <message>
        <source>Steam</source>
        <translation>蒸汽</translation>
    </message>
    <message>
        <source>White puffs from a vent, gone within a metre or two.</source>
        <translation>从排气口冒出的一团团白汽，一两米内消散。</translation>
    </message>
    <message>
        <source>Thesis 2012</source>
        <translation>2012 年论文</translation>
    </message>
    <message>
        <source>The model of the 2012 thesis as its equations say: 5000 particles on a plane, wind, gravity, fading, lattice noise.</source>
        <translation>2012 年论文的模型，严格按其方程：平面上的 5000 个粒子、风、重力、淡出、晶格噪声。</translation>
    </message>
    <message>
        <source>Tornado</source>
        <translation>龙卷风</translation>
    </message>
    <message>
        <source>A funnel that tightens towards the ground.</source>
        <translation>向地面收紧的漏斗。</translation>
    </message>
    <message>
        <source>Tyre fire</source>
        <translation>轮胎火灾</translation>
    </message>
    <message>
        <source>Thick black smoke that billows from a hidden fire.</source>
        <translation>从隐蔽的火中涌出的浓厚黑烟。</translation>
    </message>
    <message>
        <source>Volcano</source>
        <translation>火山</translation>
    </message>
    <message>
        <source>A column of dark ash that boils up, spreads and leans with the wind.</source>
        <translation>翻腾上升、扩散并随风倾斜的黑色火山灰柱。</translation>
    </message>
    <message>
        <source>Under a ceiling</source>
        <translation>天花板下</translation>
    </message>
    <message>
        <source>Smoke that rises to a ceiling, spreads out under it and rolls up along its edge.</source>
        <translation>烟雾升至天花板，在其下散开，并沿边缘卷起。</translation>
    </message>
    <message>
        <source>Fire ball</source>
        <translation>火球</translation>
    </message>
    <message>
        <source>Burning vapour that blows up into a ball, rolls over itself and burns out into black smoke.</source>
        <translation>燃烧的蒸气膨胀成球，自身翻卷，最后燃尽成黑烟。</translation>
    </message>
    <message>
        <source>Landing</source>
        <translation>着陆</translation>
    </message>
    <message>
        <source>Dust that the blast of a landing presses to the ground: it runs outwards as a ring that rolls up.</source>
        <translation>着陆气流压向地面的尘土：向外扩散成卷起的环。</translation>
    </message>
    <message>
        <source>Mushroom cloud</source>
        <translation>蘑菇云</translation>
    </message>
    <message>
        <source>A ball of hot air that rises, turns inside out and draws a stem of smoke after it.</source>
        <translation>上升的热空气团，翻卷内外并拖出一条烟柱。</translation>
    </message>
    <message>
        <source>Tongues of clear flame, and thin smoke above them.</source>
        <translation>清透的火舌，上方飘着薄烟。</translation>
    </message>
    <message>
        <source>A cumulus that grows from a flat base.</source>
        <translation>从平坦的底部生长起来的积云。</translation>
    </message>
    <message>
        <source>What a blow on dry ground throws up.</source>
        <translation>猛击干燥地面扬起的尘土。</translation>
    </message>
    <message>
        <source>Rolling dust</source>
        <translation>翻滚的尘土</translation>
    </message>
    <message>
        <source>A front of dust that rolls along the ground.</source>
        <translation>沿地面翻滚推进的一道尘土。</translation>
    </message>
    <message>
        <source>Fire whirl</source>
        <translation>火旋风</translation>
    </message>
    <message>
        <source>A turning column of flame that its own wind twists and draws up.</source>
        <translation>一根旋转的火柱，被自身的风扭转并向上抽升。</translation>
    </message>
    <message>
        <source>Blast</source>
        <translation>爆破</translation>
    </message>
    <message>
        <source>Bonfire</source>
        <translation>大篝火</translation>
    </message>
    <message>
        <source>Flames, and embers that the heat carries up and lets fall.</source>
        <translation>火焰，以及被热气带起又落下的余烬。</translation>
    </message>
    <message>
        <source>Forge sparks</source>
        <translation>锻造火花</translation>
    </message>
    <message>
        <source>Sparks that a blow throws from hot iron: they bounce, and burst into smaller ones.</source>
        <translation>锤击热铁溅出的火花：会弹跳，并迸裂成更小的火花。</translation>
    </message>
    <message>
        <source>Sand impact</source>
        <translation>沙地撞击</translation>
    </message>
    <message>
        <source>What strikes sand: a crown of clods that trail it, grains that fall back, and the dust that stays.</source>
        <translation>撞击沙地：拖着沙尾的土块形成冠状，沙粒落回，尘土留下。</translation>
    </message>
    <message>
        <source>Breath</source>
        <translation>呼气</translation>
    </message>
    <message>
        <source>Breath in the cold, once in three seconds: rate and speed of the emission have key frames that repeat.</source>
        <translation>寒冷中的呼气，三秒一次：发射率和速度有重复的关键帧。</translation>
    </message>
    <message>
        <source>Burning logo</source>
        <translation>燃烧的徽标</translation>
    </message>
    <message>
        <source>Letters that burn: births are spread over the bright pixels of a picture that the preset holds.</source>
        <translation>燃烧的文字：粒子诞生于预设所含图片的明亮像素上。</translation>
    </message>
    <message>
        <source>Lit fire</source>
        <translation>点燃的火</translation>
    </message>
    <message>
        <source>A fire that catches, burns, dies down and goes out: the share of the particles that are born, and the radius of the flames, have key frames.</source>
        <translation>火被点燃、燃烧、减弱并熄灭：诞生粒子的份额和火焰半径有关键帧。</translation>
    </message>
    <message>
        <source>Missile</source>
        <translation>导弹</translation>
    </message>
    <message>
        <source>Torch</source>
        <translation>火炬</translation>
    </message>
    <message>
        <source>Candle</source>
        <translation>蜡烛</translation>
    </message>
    <message>
        <source>A small flame that stands still, and leans when the air moves.</source>
        <translation>静静燃烧的小火焰，空气流动时微微倾斜。</translation>
    </message>
    <message>
        <source>Dry ice</source>
        <translation>干冰</translation>
    </message>
    <message>
        <source>Firework</source>
        <translation>烟花</translation>
    </message>
    <message>
        <source>Glitter</source>
        <translation>闪光微粒</translation>
    </message>
    <message>
        <source>Gusty chimney</source>
        <translation>阵风中的烟囱</translation>
    </message>
    <message>
        <source>Smoke in a wind that swells and turns, seamless: strength and angle have key frames that repeat.</source>
        <translation>风力与风向变化中的烟，无缝循环：强度和角度有重复的关键帧。</translation>
    </message>
    <message>
        <source>Rocket launch</source>
        <translation>火箭发射</translation>
    </message>
    <message>
        <source>A rocket that lifts off: its jet, the smoke that it leaves, and the cloud that runs out over the ground.</source>
        <translation>火箭升空：喷流、留下的烟，以及在地面铺开的烟云。</translation>
    </message>
    <message>
        <source>Spell</source>
        <translation>咒语</translation>
    </message>
    <message>
        <source>A fireball over a ring of dust, which throws out debris that trails smoke, and sparks that bounce.</source>
        <translation>尘环之上的火球，抛出拖着烟的碎片和弹跳的火花。</translation>
    </message>
    <message>
        <source>Cold fog that is poured out: it falls, runs out over the ground and curls up at its front.</source>
        <translation>倾倒而出的冷雾：落下、在地面铺开，并在前缘卷起。</translation>
    </message>
    <message>
        <source>Shells that rise with a tail, and burst at their death into stars of two colours that trail and glitter.</source>
        <translation>带尾焰升空的焰火弹，消亡时迸发成两种颜色、拖尾闪烁的星。</translation>
    </message>
    <message>
        <source>Motes of light in three colours that drift apart, twinkle as stars and go out.</source>
        <translation>三种颜色的光点，飘散开来，如星闪烁，然后熄灭。</translation>
    </message>
    <message>
        <source>A missile and its trail: its emitters are carried along one way, and turn with it.</source>
        <translation>导弹及其尾迹：各发射器沿同一路径移动，并随之转向。</translation>
    </message>
    <message>
        <source>Two strands of light that wind around each other, thick with glitter: stars, motes and sparks that twinkle.</source>
        <translation>两股相互缠绕的光，缀满闪光：星、光点与闪烁的火花。</translation>
    </message>
    <message>
        <source>A torch that is swung, seamless: all layers follow the same key frames of the position.</source>
        <translation>挥动的火炬，无缝循环：所有图层都跟随位置的同一组关键帧。</translation>
    </message>
</context>
<context>
    <name>fumage::ui::PreviewCanvas</name>
    <message>
        <source>Preview of the flipbook</source>
        <translation>序列帧图集预览</translation>
    </message>
</context>
<context>
    <name>fumage::ui::PreviewPane</name>
    <message>
        <source>Between cells</source>
        <translation>单元之间</translation>
    </message>
    <message>
        <source>What the engine does between two cells</source>
        <translation>引擎在两个单元之间所做的</translation>
    </message>
    <message>
        <source>No blending</source>
        <translation>不混合</translation>
    </message>
    <message>
        <source>Cross-fade</source>
        <translation>交叉淡化</translation>
    </message>
    <message>
        <source>Background</source>
        <translation>背景</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>深色</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>浅色</translation>
    </message>
    <message>
        <source>Checkerboard</source>
        <translation>棋盘格</translation>
    </message>
    <message>
        <source>Rendering the cells: %1 %</source>
        <translation>正在渲染单元：%1 %</translation>
    </message>
    <message>
        <source>Motion vectors</source>
        <translation>运动矢量</translation>
    </message>
    <message>
        <source>Rendering the cells…</source>
        <translation>正在渲染单元…</translation>
    </message>
    <message>
        <source>%1 cells a second</source>
        <translation>每秒 %1 个单元</translation>
    </message>
    <message>
        <source>%1 cells a second, shown at %2 × %3 pixels</source>
        <translation>每秒 %1 个单元，以 %2 × %3 像素显示</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>预览</translation>
    </message>
    <message>
        <source>Play as in the engine</source>
        <translation>像在引擎中一样播放</translation>
    </message>
</context>
<context>
    <name>QCommandLineParser</name>
    <message>
        <source>Usage: %1</source>
        <translation>用法：%1</translation>
    </message>
    <message>
        <source>[options]</source>
        <translation>[选项]</translation>
    </message>
    <message>
        <source>Options:</source>
        <translation>选项：</translation>
    </message>
    <message>
        <source>Arguments:</source>
        <translation>参数：</translation>
    </message>
    <message>
        <source>Displays help on commandline options.</source>
        <translation>显示命令行选项的帮助。</translation>
    </message>
    <message>
        <source>Displays help including Qt specific options.</source>
        <translation>显示帮助，包括 Qt 自身的选项。</translation>
    </message>
    <message>
        <source>Displays version information.</source>
        <translation>显示版本信息。</translation>
    </message>
    <message>
        <source>Unknown option &apos;%1&apos;.</source>
        <translation>未知选项“%1”。</translation>
    </message>
    <message>
        <source>Unknown options: %1.</source>
        <translation>未知选项：%1。</translation>
    </message>
    <message>
        <source>Missing value after &apos;%1&apos;.</source>
        <translation>“%1”之后缺少值。</translation>
    </message>
    <message>
        <source>Unexpected value after &apos;%1&apos;.</source>
        <translation>“%1”之后有多余的值。</translation>
    </message>
</context>
<context>
    <name>fumage::ui::QueuePanel</name>
    <message>
        <source>Exports</source>
        <translation>导出</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>开始</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>移除</translation>
    </message>
    <message>
        <source>Earlier</source>
        <translation>提前</translation>
    </message>
    <message>
        <source>Later</source>
        <translation>推后</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>重命名</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Show in folder</source>
        <translation>在文件夹中显示</translation>
    </message>
    <message>
        <source>Export again, with the smoke as it is now</source>
        <translation>以烟雾的当前状态再次导出</translation>
    </message>
    <message>
        <source>Remove what has ended</source>
        <translation>移除已结束的项</translation>
    </message>
    <message>
        <source>Save the list…</source>
        <translation>保存列表…</translation>
    </message>
    <message>
        <source>Save what is not done as a list, which fumage-cli render --jobs does without a display</source>
        <translation>将未完成的项保存为列表，可由 fumage-cli render --jobs 在无显示器时执行</translation>
    </message>
    <message>
        <source>Save the list of exports</source>
        <translation>保存导出列表</translation>
    </message>
    <message>
        <source>Not finished when the program ended: %1</source>
        <translation>程序结束时尚未完成：%1</translation>
    </message>
    <message>
        <source>Verify</source>
        <translation>校验</translation>
    </message>
    <message>
        <source>Verify: look whether the files are as they were written, where an export has a manifest</source>
        <translation>校验：查看文件是否与写出时一致；导出须有清单</translation>
    </message>
</context>
<context>
    <name>fumage::ui::RangeRow</name>
    <message>
        <source>Frame</source>
        <translation>帧</translation>
    </message>
    <message>
        <source>First frame</source>
        <translation>首帧</translation>
    </message>
    <message>
        <source>Last frame</source>
        <translation>末帧</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>每隔多少帧</translation>
    </message>
    <message>
        <source>to</source>
        <translation>到</translation>
    </message>
    <message>
        <source>every</source>
        <translation>每</translation>
    </message>
    <message>
        <source>the frame on the screen</source>
        <translation>屏幕上的帧</translation>
    </message>
    <message>
        <source>frame %1 is on the screen</source>
        <translation>屏幕上是第 %1 帧</translation>
    </message>
</context>
<context>
    <name>Readout</name>
    <message>
        <source>%1 fps</source>
        <translation>%1 帧/秒</translation>
    </message>
    <message>
        <source>step %1 ms</source>
        <translation>步进 %1 毫秒</translation>
    </message>
    <message>
        <source>light %1 ms</source>
        <translation>光照 %1 毫秒</translation>
    </message>
    <message>
        <source>composite %1 ms</source>
        <translation>合成 %1 毫秒</translation>
    </message>
    <message>
        <source>coarse air</source>
        <translation>粗略空气</translation>
    </message>
    <message>
        <source>air %1 s</source>
        <translation>空气 %1 秒</translation>
    </message>
    <message>
        <source>%1 particles</source>
        <translation>%1 个粒子</translation>
    </message>
</context>
<context>
    <name>fumage::ui::SeedEditor</name>
    <message>
        <source>dice</source>
        <translation>骰子</translation>
    </message>
    <message>
        <source>New seed: another smoke of the same kind</source>
        <translation>掷骰子：换一个种子，得到同类的另一团烟</translation>
    </message>
    <message>
        <source>lock</source>
        <translation>锁</translation>
    </message>
    <message>
        <source>Lock the seed, so that no slip of the hand changes the smoke</source>
        <translation>锁定种子，以免误操作改变烟雾</translation>
    </message>
</context>
<context>
    <name>fumage::ui::Session</name>
    <message>
        <source>A copy of unsaved work cannot be read. It stays where it is: %1</source>
        <translation>有一份未保存工作的副本无法读取。它仍在原处：%1</translation>
    </message>
    <message>
        <source>The program ended twice while it opened unsaved work. It stays where it is: %1</source>
        <translation>程序两次在打开未保存的工作时意外结束。该工作仍在原处：%1</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>导出</translation>
    </message>
    <message>
        <source>Export failed: %1</source>
        <translation>导出失败：%1</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>Exports</source>
        <translation>导出</translation>
    </message>
    <message>
        <source>Exports still running or waiting: %1</source>
        <translation>尚未完成的导出：%1</translation>
    </message>
    <message>
        <source>Finish in the background and close</source>
        <translation>在后台完成并关闭</translation>
    </message>
    <message>
        <source>Stop them and close</source>
        <translation>停止并关闭</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>A list of exports cannot be read. It stays where it is: %1</source>
        <translation>无法读取一个导出列表。它保留在原处：%1</translation>
    </message>
    <message>
        <source>Exports that were not finished when the program ended: %1. The panel Exports starts or removes them.</source>
        <translation>程序结束时尚未完成的导出：%1。可在“导出”面板中开始或移除它们。</translation>
    </message>
    <message>
        <source>The list has no room for %1 more, which come when the program starts again.</source>
        <translation>列表容纳不下另外 %1 个，它们将在程序下次启动时出现。</translation>
    </message>
</context>
<context>
    <name>fumage::ui::SheetFinder</name>
    <message>
        <source>Cancelled.</source>
        <translation>已取消。</translation>
    </message>
    <message>
        <source>Trying sheets: %1 %</source>
        <translation>正在尝试图集：%1 %</translation>
    </message>
    <message>
        <source>Memory on the graphics card</source>
        <translation>显卡内存</translation>
    </message>
    <message>
        <source>What all pictures of the flipbook may take there, as BC7</source>
        <translation>序列帧图集的所有图片以 BC7 格式最多占用的显存</translation>
    </message>
    <message>
        <source>Cancelled: the flipbook has changed.</source>
        <translation>已取消：序列帧图集已更改。</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Trying sheets…</source>
        <translation>正在尝试图集…</translation>
    </message>
    <message>
        <source>Tries columns, rows and sizes of cells, and takes those that play nearest to the animation</source>
        <translation>尝试不同的列数、行数和单元格大小，并选用播放效果最接近动画的一组</translation>
    </message>
    <message>
        <source>%1 × %2 cells of %3 × %4 pixels, %5: %6 dB</source>
        <translation>%1 × %2 个单元格，每格 %3 × %4 像素，%5：%6 dB</translation>
    </message>
    <message>
        <source> MiB</source>
        <translation> MiB</translation>
    </message>
    <message>
        <source>Fit to a memory budget</source>
        <translation>适应内存预算</translation>
    </message>
    <message>
        <source>Optimise</source>
        <translation>优化</translation>
    </message>
</context>
<context>
    <name>fumage::ui::SoloLine</name>
    <message>
        <source>Solo</source>
        <translation>独显</translation>
    </message>
    <message>
        <source>End solo</source>
        <translation>结束独显</translation>
    </message>
    <message>
        <source>Show all layers again</source>
        <translation>重新显示所有图层</translation>
    </message>
    <message>
        <source>%1 (muted)</source>
        <translation>%1（已静音）</translation>
    </message>
    <message>
        <source>Solo: %1</source>
        <translation>独显：%1</translation>
    </message>
    <message>
        <source>Solo: %1 layers</source>
        <translation>独显：%1 个图层</translation>
    </message>
</context>
<context>
    <name>fumage::ui::StartDialog</name>
    <message>
        <source>Show this when Fumage starts</source>
        <translation>Fumage 启动时显示此窗口</translation>
    </message>
    <message>
        <source>Start from a preset</source>
        <translation>从一团烟开始</translation>
    </message>
    <message>
        <source>Recent files</source>
        <translation>最近的文件</translation>
    </message>
    <message>
        <source>Open a file…</source>
        <translation>打开文件…</translation>
    </message>
    <message>
        <source>New smoke</source>
        <translation>默认的烟</translation>
    </message>
    <message>
        <source>Files that you open or save will be here</source>
        <translation>您打开或保存的文件将显示在这里</translation>
    </message>
    <message>
        <source>Scenes and presets</source>
        <translation>场景与预设</translation>
    </message>
</context>
<context>
    <name>fumage::ui::SummaryRow</name>
    <message>
        <source>Solo is of the view only. Layers that are exported: %1.</source>
        <translation>独显只影响视图：将导出 %1 个图层。</translation>
    </message>
    <message>
        <source>Mend key frames</source>
        <translation>修正关键帧</translation>
    </message>
    <message>
        <source>Moves key frames into the timeline, closes loops, and lets rates change smoothly: one undo step</source>
        <translation>将关键帧移入时间线、闭合循环并使速率平滑变化：一步撤销</translation>
    </message>
</context>
<context>
    <name>fumage::ui::TimelineBar</name>
    <message>
        <source>Go to start (Home)</source>
        <translation>到第一帧 (Home)</translation>
    </message>
    <message>
        <source>Previous frame (Left)</source>
        <translation>后退一帧 (左)</translation>
    </message>
    <message>
        <source>Play or pause (Space)</source>
        <translation>播放或暂停 (空格)</translation>
    </message>
    <message>
        <source>Next frame (Right)</source>
        <translation>前进一帧 (右)</translation>
    </message>
    <message>
        <source>Go to end (End)</source>
        <translation>到最后一帧 (End)</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>帧</translation>
    </message>
    <message>
        <source>The frame that is shown</source>
        <translation>当前显示的帧</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>Speed of playing</source>
        <translation>播放速度</translation>
    </message>
    <message>
        <source>Frames per second</source>
        <translation>每秒帧数</translation>
    </message>
    <message>
        <source>Frames per second of the effect</source>
        <translation>效果的每秒帧数</translation>
    </message>
    <message>
        <source> fps</source>
        <translation> 帧/秒</translation>
    </message>
    <message>
        <source> of %1</source>
        <translation> / %1</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 秒</translation>
    </message>
    <message>
        <source>Repeat playback: start again after the last frame, whether it fits the first or not</source>
        <translation>重复播放：最后一帧之后从头开始，不管它是否与第一帧衔接</translation>
    </message>
    <message>
        <source>What there is no room for</source>
        <translation>放不下的控件</translation>
    </message>
    <message>
        <source>Show the curves of key frames in a graph (Shift+G)</source>
        <translation>在曲线图中显示关键帧曲线 (Shift+G)</translation>
    </message>
</context>
<context>
    <name>fumage::ui::TimelineRuler</name>
    <message>
        <source>Timeline</source>
        <translation>时间线</translation>
    </message>
    <message>
        <source>Drag to go to any frame; drag the ends of the bar to play a part</source>
        <translation>拖动可到任意帧；拖动条的两端可只播放一部分</translation>
    </message>
    <message>
        <source>air %1 %</source>
        <translation>空气 %1 %</translation>
    </message>
</context>
<context>
    <name>fumage::ui::Tour</name>
    <message>
        <source>Back</source>
        <translation>后退</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>下一步</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>完成</translation>
    </message>
    <message>
        <source>Tour</source>
        <translation>导览</translation>
    </message>
</context>
<context>
    <name>fumage::ui::VariationsPanel</name>
    <message>
        <source>The present smoke</source>
        <translation>当前的烟</translation>
    </message>
    <message>
        <source>Variation %1</source>
        <translation>变体 %1</translation>
    </message>
    <message>
        <source>The smoke as it is</source>
        <translation>现在的烟</translation>
    </message>
    <message>
        <source>Click to adopt this variation</source>
        <translation>点击以采用此变体</translation>
    </message>
    <message>
        <source>Previous variation</source>
        <translation>回到此前的烟</translation>
    </message>
    <message>
        <source>Other variations</source>
        <translation>另一些变体</translation>
    </message>
    <message>
        <source>How far they differ</source>
        <translation>它们相差多少</translation>
    </message>
    <message>
        <source>Subtle</source>
        <translation>细微</translation>
    </message>
    <message>
        <source>Wild</source>
        <translation>狂放</translation>
    </message>
    <message>
        <source>Lock parameters in their context menu to keep them as they are.</source>
        <translation>在参数的右键菜单中锁定，可使其保持不变。</translation>
    </message>
    <message>
        <source>Locked parameters, which stay as they are: %1</source>
        <translation>保持不变的已锁定参数：%1</translation>
    </message>
    <message>
        <source>Adopt a variation</source>
        <translation>采用变体</translation>
    </message>
    <message>
        <source>Back from a variation</source>
        <translation>从变体返回</translation>
    </message>
</context>
<context>
    <name>fumage::ui::ViewActions</name>
    <message>
        <source>Backdrop</source>
        <translation>背景</translation>
    </message>
</context>
<context>
    <name>fumage::ui::Viewport</name>
    <message>
        <source>Smoke</source>
        <translation>烟</translation>
    </message>
    <message>
        <source>Auto-key</source>
        <translation>自动关键帧</translation>
    </message>
</context>
<context>
    <name>fumage::ui::ViewportInput</name>
    <message>
        <source>Move a key frame of the way</source>
        <translation>移动路径上的关键帧</translation>
    </message>
</context>
<context>
    <name>WindowTour</name>
    <message>
        <source>This is the smoke. Drag in it to look from another side, and turn the wheel to come nearer.</source>
        <translation>这是烟雾。在其中拖动可换个方向看，转动滚轮可靠近。</translation>
    </message>
    <message>
        <source>These are its parameters. Drag a number sideways, or click it and type: the smoke follows at once. F1 explains the one under the mouse.</source>
        <translation>这些是它的参数。横向拖动数字，或单击后输入：烟雾立即跟随。F1 解释鼠标下的参数。</translation>
    </message>
    <message>
        <source>This plays the smoke and holds it, as Space does. Drag in the timeline to go to another frame.</source>
        <translation>这里播放和暂停烟雾，与空格键相同。在时间线中拖动可到其他帧。</translation>
    </message>
    <message>
        <source>The diamond sets a key frame: change the number at another frame, and it changes over time.</source>
        <translation>菱形设置关键帧：在另一帧更改数字，它就会随时间变化。</translation>
    </message>
    <message>
        <source>This takes the smoke away: as a flipbook, an image sequence, a video or data for an engine. Help &gt; Tour shows all of this again.</source>
        <translation>从这里带走烟雾：作为翻页图集、图像序列、视频或引擎数据。帮助 &gt; 导览会再次展示这些内容。</translation>
    </message>
    <message>
        <source>This is the short way into a game: click your engine, and a flipbook that suits it is written, and plays on a mock ground beside what is to be done in the engine.</source>
        <translation>这是进入游戏的捷径：单击你的引擎，便会写出适合它的翻页图集，并在模拟地面上播放，旁边是要在引擎中做的事。</translation>
    </message>
</context>
<context>
    <name>fumage::ui::WorkLine</name>
    <message>
        <source>Work in progress</source>
        <translation>正在进行的工作</translation>
    </message>
    <message>
        <source>Stopped: a preview is shown</source>
        <translation>已停止：显示的是预览</translation>
    </message>
    <message>
        <source>Go on</source>
        <translation>继续</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>Make the picture after all</source>
        <translation>仍然生成画面</translation>
    </message>
    <message>
        <source>Give this up; a preview stays, and playing goes on with it</source>
        <translation>放弃这项工作；保留预览，并用它继续播放</translation>
    </message>
    <message>
        <source>Baking air</source>
        <translation>正在烘焙空气</translation>
    </message>
    <message>
        <source>Simulating particles</source>
        <translation>正在模拟粒子</translation>
    </message>
    <message>
        <source>Lighting</source>
        <translation>正在计算光照</translation>
    </message>
    <message>
        <source>Painting</source>
        <translation>正在绘制</translation>
    </message>
    <message>
        <source>%1 %2 %</source>
        <translation>%1 %2%</translation>
    </message>
    <message>
        <source>%1 %2 %, about %3 min</source>
        <translation>%1 %2%，约 %3 分钟</translation>
    </message>
    <message>
        <source>%1 %2 %, about %3 s</source>
        <translation>%1 %2%，约 %3 秒</translation>
    </message>
</context>
<context>
    <name>main</name>
    <message>
        <source>An editor for smoke.</source>
        <translation>烟雾编辑器。</translation>
    </message>
    <message>
        <source>Presets to open, each in a window of its own.</source>
        <translation>要打开的预设，每个一个窗口。</translation>
    </message>
    <message>
        <source>Prints the keyboard shortcuts.</source>
        <translation>输出键盘快捷键。</translation>
    </message>
</context>
</TS>
