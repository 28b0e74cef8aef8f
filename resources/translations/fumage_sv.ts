<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="sv" sourcelanguage="en">
<context>
    <name>Actions</name>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Arkiv</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Redigera</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Visa</translation>
    </message>
    <message>
        <source>&amp;Play</source>
        <translation>&amp;Spela</translation>
    </message>
    <message>
        <source>&amp;Compare</source>
        <translation>&amp;Jämför</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Hjälp</translation>
    </message>
    <message>
        <source>&amp;New</source>
        <translation>&amp;Nytt</translation>
    </message>
    <message>
        <source>New &amp;window</source>
        <translation>Nytt &amp;fönster</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>&amp;Öppna…</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Spara</translation>
    </message>
    <message>
        <source>Save &amp;as…</source>
        <translation>Spara s&amp;om…</translation>
    </message>
    <message>
        <source>Save to the &amp;library…</source>
        <translation>Spara i &amp;biblioteket…</translation>
    </message>
    <message>
        <source>&amp;Revert</source>
        <translation>Å&amp;tergå</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>&amp;Exportera…</translation>
    </message>
    <message>
        <source>Export a&amp;gain</source>
        <translation>Exportera i&amp;gen</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>S&amp;täng</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Avsluta</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Ångra</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Gör om</translation>
    </message>
    <message>
        <source>&amp;Copy the preset as JSON</source>
        <translation>&amp;Kopiera förinställningen som JSON</translation>
    </message>
    <message>
        <source>&amp;Paste a preset</source>
        <translation>K&amp;listra in en förinställning</translation>
    </message>
    <message>
        <source>&amp;Variations…</source>
        <translation>&amp;Variationer…</translation>
    </message>
    <message>
        <source>Randomise s&amp;lightly</source>
        <translation>Slumpa &amp;lite</translation>
    </message>
    <message>
        <source>Reset &amp;all parameters</source>
        <translation>Återställ &amp;alla parametrar</translation>
    </message>
    <message>
        <source>&amp;Search parameters</source>
        <translation>&amp;Sök parametrar</translation>
    </message>
    <message>
        <source>Search c&amp;ommands…</source>
        <translation>Sök ko&amp;mmandon…</translation>
    </message>
    <message>
        <source>Frame &amp;all</source>
        <translation>Visa &amp;allt</translation>
    </message>
    <message>
        <source>From the &amp;front</source>
        <translation>&amp;Framifrån</translation>
    </message>
    <message>
        <source>From the &amp;right</source>
        <translation>Från &amp;höger</translation>
    </message>
    <message>
        <source>From &amp;above</source>
        <translation>&amp;Uppifrån</translation>
    </message>
    <message>
        <source>Ground &amp;grid</source>
        <translation>&amp;Markrutnät</translation>
    </message>
    <message>
        <source>&amp;Emitter outline</source>
        <translation>&amp;Utsändarens kontur</translation>
    </message>
    <message>
        <source>Gi&amp;zmos</source>
        <translation>&amp;Handtag</translation>
    </message>
    <message>
        <source>E&amp;xport frame</source>
        <translation>E&amp;xportram</translation>
    </message>
    <message>
        <source>Rea&amp;dout</source>
        <translation>Mät&amp;värden</translation>
    </message>
    <message>
        <source>&amp;Checkerboard</source>
        <translation>&amp;Schackrutor bakom röken</translation>
    </message>
    <message>
        <source>&amp;Backdrop colour…</source>
        <translation>&amp;Bakgrundsfärg…</translation>
    </message>
    <message>
        <source>F&amp;ull screen</source>
        <translation>&amp;Helskärm</translation>
    </message>
    <message>
        <source>Reset &amp;layout</source>
        <translation>Återställ &amp;layouten</translation>
    </message>
    <message>
        <source>&amp;Play or pause</source>
        <translation>&amp;Spela eller pausa</translation>
    </message>
    <message>
        <source>&amp;Next frame</source>
        <translation>En bildruta &amp;framåt</translation>
    </message>
    <message>
        <source>&amp;Previous frame</source>
        <translation>En bildruta &amp;bakåt</translation>
    </message>
    <message>
        <source>Go to &amp;start</source>
        <translation>Till &amp;första bildrutan</translation>
    </message>
    <message>
        <source>Go to &amp;end</source>
        <translation>Till &amp;sista bildrutan</translation>
    </message>
    <message>
        <source>Set &amp;in point</source>
        <translation>Intervallet börjar &amp;här</translation>
    </message>
    <message>
        <source>Set &amp;out point</source>
        <translation>Intervallet &amp;slutar här</translation>
    </message>
    <message>
        <source>&amp;Whole range</source>
        <translation>&amp;Hela intervallet</translation>
    </message>
    <message>
        <source>&amp;Store as B</source>
        <translation>&amp;Kom ihåg detta som B</translation>
    </message>
    <message>
        <source>&amp;Split view of A and B</source>
        <translation>&amp;Delad vy av A och B</translation>
    </message>
    <message>
        <source>&amp;Replace A with B</source>
        <translation>&amp;Ta över B</translation>
    </message>
    <message>
        <source>&amp;Keyboard shortcuts</source>
        <translation>&amp;Kortkommandon</translation>
    </message>
    <message>
        <source>&amp;About Fumage</source>
        <translation>&amp;Om Fumage</translation>
    </message>
    <message>
        <source>From the bac&amp;k</source>
        <translation>&amp;Bakifrån</translation>
    </message>
    <message>
        <source>From the &amp;left</source>
        <translation>Från &amp;vänster</translation>
    </message>
    <message>
        <source>From &amp;below</source>
        <translation>&amp;Nedifrån</translation>
    </message>
    <message>
        <source>Show &amp;B (hold the key to look for a moment)</source>
        <translation>Visa &amp;B (håll tangenten för att titta en stund)</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>Öppna &amp;senaste</translation>
    </message>
    <message>
        <source>&amp;Panels</source>
        <translation>&amp;Paneler</translation>
    </message>
    <message>
        <source>&amp;Navigation style</source>
        <translation>&amp;Musvanor</translation>
    </message>
    <message>
        <source>Lan&amp;guage</source>
        <translation>Sp&amp;råk</translation>
    </message>
    <message>
        <source>T&amp;heme</source>
        <translation>&amp;Tema</translation>
    </message>
    <message>
        <source>Frame the &amp;whole animation</source>
        <translation>Visa &amp;hela animationen</translation>
    </message>
    <message>
        <source>&amp;Hide panels</source>
        <translation>&amp;Bara röken</translation>
    </message>
    <message>
        <source>A&amp;ir</source>
        <translation>L&amp;uft</translation>
    </message>
    <message>
        <source>New from a p&amp;reset…</source>
        <translation>Nytt från en fö&amp;rinställning…</translation>
    </message>
    <message>
        <source>Pre&amp;ferences…</source>
        <translation>&amp;Inställningar…</translation>
    </message>
    <message>
        <source>Pre&amp;vious view</source>
        <translation>&amp;Föregående vy</translation>
    </message>
    <message>
        <source>&amp;Next view</source>
        <translation>&amp;Nästa vy</translation>
    </message>
    <message>
        <source>Reset the ca&amp;mera</source>
        <translation>Återställ ka&amp;meran</translation>
    </message>
    <message>
        <source>Cop&amp;y the picture</source>
        <translation>Kopiera &amp;bilden</translation>
    </message>
    <message>
        <source>Particle pa&amp;ths</source>
        <translation>Partikel&amp;banor</translation>
    </message>
    <message>
        <source>Cu&amp;t the layers</source>
        <translation>Klipp &amp;ut lagren</translation>
    </message>
    <message>
        <source>C&amp;opy the layers</source>
        <translation>Kopie&amp;ra lagren</translation>
    </message>
    <message>
        <source>Past&amp;e layers</source>
        <translation>Klistra in &amp;lager</translation>
    </message>
    <message>
        <source>Paste para&amp;meters…</source>
        <translation>Klistra in para&amp;metrar…</translation>
    </message>
    <message>
        <source>&amp;Duplicate the layers</source>
        <translation>&amp;Dubblera lagren</translation>
    </message>
    <message>
        <source>Delete the la&amp;yers</source>
        <translation>Ta b&amp;ort lagren</translation>
    </message>
    <message>
        <source>End s&amp;olo</source>
        <translation>Avsluta s&amp;olo</translation>
    </message>
    <message>
        <source>Previous &amp;key frame</source>
        <translation>Föregående &amp;nyckelbildruta</translation>
    </message>
    <message>
        <source>Next ke&amp;y frame</source>
        <translation>Nästa n&amp;yckelbildruta</translation>
    </message>
    <message>
        <source>&amp;Auto-key: each edit sets a key frame</source>
        <translation>&amp;Autonyckel: varje ändring sätter en nyckelbildruta</translation>
    </message>
    <message>
        <source>Add a &amp;marker</source>
        <translation>Lägg till en &amp;markör</translation>
    </message>
    <message>
        <source>Pre&amp;vious marker</source>
        <translation>F&amp;öregående markör</translation>
    </message>
    <message>
        <source>Ne&amp;xt marker</source>
        <translation>&amp;Nästa markör</translation>
    </message>
    <message>
        <source>&amp;Graph of key frames</source>
        <translation>Nyckelbildrutornas &amp;kurvor</translation>
    </message>
    <message>
        <source>&amp;Manual</source>
        <translation>&amp;Handbok</translation>
    </message>
    <message>
        <source>&amp;Tour</source>
        <translation>&amp;Rundtur</translation>
    </message>
    <message>
        <source>&amp;Into my engine…</source>
        <translation>&amp;Till min spelmotor…</translation>
    </message>
    <message>
        <source>Frame the animation without outlier&amp;s</source>
        <translation>Visa animationen utan &amp;ströpartiklar</translation>
    </message>
</context>
<context>
    <name>fumage::ui::CameraFit</name>
    <message>
        <source>Looking for smoke in all frames: %1 %</source>
        <translation>Letar efter rök i alla bildrutor: %1 %</translation>
    </message>
    <message>
        <source>The camera shows all smoke of the animation</source>
        <translation>Kameran visar all rök i animationen</translation>
    </message>
    <message>
        <source>The camera shows the smoke of the animation without outliers</source>
        <translation>Kameran visar animationens rök utan ströpartiklar</translation>
    </message>
</context>
<context>
    <name>fumage::ui::ColourEditor</name>
    <message>
        <source>swatch</source>
        <translation>färgprov</translation>
    </message>
</context>
<context>
    <name>fumage::ui::CommandSearch</name>
    <message>
        <source>Search commands</source>
        <translation>Sök kommandon</translation>
    </message>
    <message>
        <source>Commands</source>
        <translation>Kommandon</translation>
    </message>
    <message>
        <source>A command, a choice, a parameter or a preset</source>
        <translation>Ett kommando, ett val, en parameter eller en förinställning</translation>
    </message>
    <message>
        <source>Preset: %1</source>
        <translation>Förinställning: %1</translation>
    </message>
    <message>
        <source>No results for “%1”. Try a part of a word, or another word.</source>
        <translation>Inget hittas med ”%1”. Prova en del av ett ord eller ett annat ord.</translation>
    </message>
    <message>
        <source>Presets</source>
        <translation>Förinställningar</translation>
    </message>
</context>
<context>
    <name>fumage::ui::Comparison</name>
    <message>
        <source>Replace A with B</source>
        <translation>Ta över B</translation>
    </message>
</context>
<context>
    <name>fumage::ui::CurveEditor</name>
    <message>
        <source>Click to add, drag to move, Delete or right click to remove</source>
        <translation>Tryck för att lägga till, dra för att flytta, Delete eller högerklick för att ta bort</translation>
    </message>
</context>
<context>
    <name>fumage::ui::DataChoices</name>
    <message>
        <source>Size of the noise texture</source>
        <translation>Brustexturens storlek</translation>
    </message>
    <message>
        <source>as in the effect</source>
        <translation>som i effekten</translation>
    </message>
    <message>
        <source> pixels</source>
        <translation> bildpunkter</translation>
    </message>
    <message>
        <source>Axis that points up</source>
        <translation>Axel som pekar uppåt</translation>
    </message>
    <message>
        <source>As usual for the format</source>
        <translation>Som formatet brukar ha det</translation>
    </message>
    <message>
        <source>y, as in Houdini and Maya</source>
        <translation>y, som i Houdini och Maya</translation>
    </message>
    <message>
        <source>z, as in Blender</source>
        <translation>z, som i Blender</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Storlek</translation>
    </message>
    <message>
        <source>Voxels along the longest edge of the smoke of the whole timeline</source>
        <translation>Voxlar längs den längsta sidan av röken på hela tidslinjen</translation>
    </message>
    <message>
        <source>Frame rate</source>
        <translation>Bildfrekvens</translation>
    </message>
    <message>
        <source>Repeat</source>
        <translation>Upprepning</translation>
    </message>
    <message>
        <source>Voxels</source>
        <translation>Voxlar</translation>
    </message>
    <message>
        <source>Voxel size</source>
        <translation>Voxelstorlek</translation>
    </message>
    <message>
        <source>Up axis</source>
        <translation>Axel uppåt</translation>
    </message>
    <message>
        <source>Frames a second at which the video plays; the frames stay the same</source>
        <translation>Bildrutor per sekund som videon spelas med; bildrutorna förblir desamma</translation>
    </message>
    <message>
        <source>As the timeline</source>
        <translation>Som tidslinjen</translation>
    </message>
    <message>
        <source>For ever if the frames close a loop</source>
        <translation>För alltid om bildrutorna sluter en slinga</translation>
    </message>
    <message>
        <source>Once</source>
        <translation>En gång</translation>
    </message>
    <message>
        <source>For ever</source>
        <translation>För alltid</translation>
    </message>
    <message>
        <source>Edge of a voxel; all frames have the same</source>
        <translation>En voxels sida; alla bildrutor har samma</translation>
    </message>
    <message>
        <source> m</source>
        <translation> m</translation>
    </message>
    <message>
        <source>by their number</source>
        <translation>efter antalet</translation>
    </message>
    <message>
        <source>Density</source>
        <translation>Täthet</translation>
    </message>
    <message>
        <source>One grid of all layers, or one of each, which add up to it</source>
        <translation>Ett rutnät för alla lager, eller ett för varje, som tillsammans blir det</translation>
    </message>
    <message>
        <source>Of all layers</source>
        <translation>För alla lager</translation>
    </message>
    <message>
        <source>A grid a layer</source>
        <translation>Ett rutnät per lager</translation>
    </message>
</context>
<context>
    <name>fumage::ui::DirectionEditor</name>
    <message>
        <source>Yaw</source>
        <translation>Gir</translation>
    </message>
    <message>
        <source>Pitch</source>
        <translation>Lutning</translation>
    </message>
</context>
<context>
    <name>fumage::ui::Docks</name>
    <message>
        <source>Presets</source>
        <translation>Förinställningar</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>Parametrar</translation>
    </message>
    <message>
        <source>Noise</source>
        <translation>Brus</translation>
    </message>
    <message>
        <source>History</source>
        <translation>Historik</translation>
    </message>
    <message>
        <source>Variations</source>
        <translation>Variationer</translation>
    </message>
    <message>
        <source>Exports</source>
        <translation>Exporter</translation>
    </message>
</context>
<context>
    <name>fumage::ui::Document</name>
    <message>
        <source>Untitled</source>
        <translation>Namnlös</translation>
    </message>
    <message>
        <source>Reset %1</source>
        <translation>Återställ %1</translation>
    </message>
    <message>
        <source>Unsaved work</source>
        <translation>Osparat arbete</translation>
    </message>
    <message>
        <source>Reload</source>
        <translation>Läs in igen</translation>
    </message>
    <message>
        <source>Move the camera</source>
        <translation>Flytta kameran</translation>
    </message>
    <message>
        <source>Key %1</source>
        <translation>Nyckla %1</translation>
    </message>
</context>
<context>
    <name>fumage::ui::DocumentFiles</name>
    <message>
        <source>Presets (*.json)</source>
        <translation>Förinställningar (*.json)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Alla filer (*)</translation>
    </message>
    <message>
        <source>Opened with changes</source>
        <translation>Öppnad med ändringar</translation>
    </message>
    <message>
        <source>“%1” was opened, but some of it had to be put right.</source>
        <translation>”%1” öppnades, men en del av innehållet måste rättas till.</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>Osparade ändringar</translation>
    </message>
    <message>
        <source>Save the changes to “%1”?</source>
        <translation>Spara ändringarna i ”%1”?</translation>
    </message>
    <message>
        <source>Your changes will be lost if you don&apos;t save them.</source>
        <translation>De går förlorade om du inte sparar dem.</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öppna</translation>
    </message>
    <message>
        <source>Cannot open “%1”</source>
        <translation>Kan inte öppna ”%1”</translation>
    </message>
    <message>
        <source>Cannot save “%1”</source>
        <translation>Kan inte spara ”%1”</translation>
    </message>
    <message>
        <source>Save as</source>
        <translation>Spara som</translation>
    </message>
    <message>
        <source>Save to the library</source>
        <translation>Spara i biblioteket</translation>
    </message>
    <message>
        <source>Name of the preset</source>
        <translation>Förinställningens namn</translation>
    </message>
    <message>
        <source>There is a preset “%1” already. Replace it?</source>
        <translation>Det finns redan en förinställning ”%1”. Ska den ersättas?</translation>
    </message>
    <message>
        <source>Revert</source>
        <translation>Återgå</translation>
    </message>
    <message>
        <source>Cannot paste a preset</source>
        <translation>Kan inte klistra in en förinställning</translation>
    </message>
    <message>
        <source>Paste a preset</source>
        <translation>Klistra in en förinställning</translation>
    </message>
    <message>
        <source>The clipboard</source>
        <translation>Urklipp</translation>
    </message>
    <message>
        <source>Presets, and pictures that carry one (*.json *.png *.exr)</source>
        <translation>Förinställningar, och bilder som bär en (*.json *.png *.exr)</translation>
    </message>
    <message>
        <source>Changed by another program</source>
        <translation>Ändrad av ett annat program</translation>
    </message>
    <message>
        <source>“%1” has been changed by another program since it was opened or saved here. If you overwrite it, those changes are lost.</source>
        <translation>”%1” har ändrats av ett annat program sedan den öppnades eller sparades här. Om du skriver över den går de ändringarna förlorade.</translation>
    </message>
    <message>
        <source>Save as…</source>
        <translation>Spara som…</translation>
    </message>
    <message>
        <source>Overwrite</source>
        <translation>Skriv över</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Avbryt</translation>
    </message>
</context>
<context>
    <name>fumage::ui::EditActions</name>
    <message>
        <source>Reset all parameters</source>
        <translation>Återställ alla parametrar</translation>
    </message>
    <message>
        <source>&amp;Undo %1</source>
        <translation>&amp;Ångra %1</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Ångra</translation>
    </message>
    <message>
        <source>&amp;Redo %1</source>
        <translation>&amp;Gör om %1</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Gör om</translation>
    </message>
    <message>
        <source>Randomise slightly</source>
        <translation>Slumpa lite</translation>
    </message>
</context>
<context>
    <name>fumage::ui::EffectPanel</name>
    <message>
        <source>Search parameters</source>
        <translation>Sök parametrar</translation>
    </message>
    <message>
        <source>Only the parameters that differ from the preset</source>
        <translation>Bara de parametrar som skiljer sig från förinställningen</translation>
    </message>
    <message>
        <source>Essentials</source>
        <translation>Det viktigaste</translation>
    </message>
    <message>
        <source>Nothing differs from the preset.</source>
        <translation>Inget skiljer sig från förinställningen.</translation>
    </message>
    <message>
        <source>No parameter matches “%1”. Try a part of a word, or another word.</source>
        <translation>Ingen parameter hittas med ”%1”. Prova en del av ett ord eller ett annat ord.</translation>
    </message>
    <message>
        <source>Parameters of</source>
        <translation>Parametrar för</translation>
    </message>
    <message>
        <source>Scene</source>
        <translation>Scen</translation>
    </message>
    <message>
        <source>Only the parameters that have key frames</source>
        <translation>Bara de parametrar som har nyckelbildrutor</translation>
    </message>
    <message>
        <source>Nothing has key frames: the diamond beside a parameter sets one.</source>
        <translation>Inget har nyckelbildrutor: romben bredvid en parameter sätter en.</translation>
    </message>
    <message>
        <source>Nothing that has key frames differs from the preset.</source>
        <translation>Inget som har nyckelbildrutor skiljer sig från förinställningen.</translation>
    </message>
</context>
<context>
    <name>fumage::ui::EmissionStrip</name>
    <message>
        <source>Emission of the layers</source>
        <translation>Lagrens emission</translation>
    </message>
    <message>
        <source>Emission of %1</source>
        <translation>Emission för %1</translation>
    </message>
</context>
<context>
    <name>fumage::ui::EngineDialog</name>
    <message>
        <source>Another engine</source>
        <translation>En annan spelmotor</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Avbryt</translation>
    </message>
    <message>
        <source>Show in folder</source>
        <translation>Visa i mappen</translation>
    </message>
    <message>
        <source>Copy the path</source>
        <translation>Kopiera sökvägen</translation>
    </message>
    <message>
        <source>Into my engine</source>
        <translation>Till min spelmotor</translation>
    </message>
    <message>
        <source>Choose an engine: a sheet with all that it needs is written, with the settings that suit it.</source>
        <translation>Välj en spelmotor: ett ark med allt som den behöver skrivs, med de inställningar som passar den.</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>Mapp</translation>
    </message>
    <message>
        <source>Size of the sheet</source>
        <translation>Arkets storlek</translation>
    </message>
    <message>
        <source>%1 pixels at most</source>
        <translation>högst %1 pixlar</translation>
    </message>
    <message>
        <source>The longer side of the sheet. Cells of the document that are larger are made smaller</source>
        <translation>Arkets längre sida. Celler i dokumentet som är större görs mindre</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Välj…</translation>
    </message>
    <message>
        <source>Sheet</source>
        <translation>Ark</translation>
    </message>
    <message>
        <source>Export for %1</source>
        <translation>Exportera för %1</translation>
    </message>
    <message>
        <source>Sky</source>
        <translation>Himmel</translation>
    </message>
    <message>
        <source>Day</source>
        <translation>Dag</translation>
    </message>
    <message>
        <source>Evening</source>
        <translation>Kväll</translation>
    </message>
    <message>
        <source>Night</source>
        <translation>Natt</translation>
    </message>
    <message>
        <source>More options…</source>
        <translation>Fler alternativ…</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Stäng</translation>
    </message>
    <message>
        <source>Folder for the engine</source>
        <translation>Mapp för spelmotorn</translation>
    </message>
    <message>
        <source>Size of cells</source>
        <translation>Cellernas storlek</translation>
    </message>
    <message>
        <source>%1 for %2</source>
        <translation>%1 för %2</translation>
    </message>
    <message>
        <source>The sheet is being rendered…</source>
        <translation>Arket renderas…</translation>
    </message>
    <message>
        <source>The sheet is being read…</source>
        <translation>Arket läses…</translation>
    </message>
</context>
<context>
    <name>Engines</name>
    <message>
        <source>Any engine</source>
        <translation>Valfri motor</translation>
    </message>
    <message>
        <source>Web page</source>
        <translation>Webbsida</translation>
    </message>
    <message>
        <source>Put the folder %1 into Assets of your project, if it is not there.</source>
        <translation>Lägg mappen %1 i Assets i ditt projekt, om den inte är där.</translation>
    </message>
    <message>
        <source>Let Unity import it: the script in the folder Editor gives each texture its settings.</source>
        <translation>Låt Unity importera den: skriptet i mappen Editor ger varje textur dess inställningar.</translation>
    </message>
    <message>
        <source>Choose Assets, Fumage, %1: it makes a particle system that plays the sheet, and a prefab of it.</source>
        <translation>Välj Assets, Fumage, %1: det gör ett partikelsystem som spelar arket, och en prefab av det.</translation>
    </message>
    <message>
        <source>In Unreal switch on the Python Editor Script Plugin.</source>
        <translation>Slå på Python Editor Script Plugin i Unreal.</translation>
    </message>
    <message>
        <source>Choose Tools, Execute Python Script, and the script in %1: the textures are then in /Game/Fumage, with the right settings.</source>
        <translation>Välj Tools, Execute Python Script, och skriptet i %1: texturerna ligger då i /Game/Fumage, med rätt inställningar.</translation>
    </message>
    <message>
        <source>Use FlipBook_MotionVectors in a material, with the numbers that the log says, and the material in a Niagara sprite emitter.</source>
        <translation>Använd FlipBook_MotionVectors i ett material, med talen som loggen anger, och materialet i en Niagara-emitter med sprites.</translation>
    </message>
    <message>
        <source>Put the folder %1 into your project, if it is not there.</source>
        <translation>Lägg mappen %1 i ditt projekt, om den inte är där.</translation>
    </message>
    <message>
        <source>Let Godot import the textures: the .import files beside them say how.</source>
        <translation>Låt Godot importera texturerna: .import-filerna bredvid dem säger hur.</translation>
    </message>
    <message>
        <source>Drag the scene %1 into yours. Its shader blends the cells.</source>
        <translation>Dra scenen %1 till din. Dess shader blandar cellerna.</translation>
    </message>
    <message>
        <source>Open %1 in a browser: it plays the sheet by itself.</source>
        <translation>Öppna %1 i en webbläsare: den spelar arket av sig själv.</translation>
    </message>
    <message>
        <source>Put the file on your server: the pictures are in it.</source>
        <translation>Lägg filen på din server: bilderna finns i den.</translation>
    </message>
    <message>
        <source>Show it in an iframe, or copy its script into your page.</source>
        <translation>Visa den i en iframe, eller kopiera dess skript till din sida.</translation>
    </message>
    <message>
        <source>Open %1 in Effekseer.</source>
        <translation>Öppna %1 i Effekseer.</translation>
    </message>
    <message>
        <source>Press Play: the node has the texture, the cells and their speed.</source>
        <translation>Tryck på Play: noden har texturen, cellerna och deras hastighet.</translation>
    </message>
    <message>
        <source>Export it for your game, with the pictures beside it.</source>
        <translation>Exportera det för ditt spel, med bilderna bredvid.</translation>
    </message>
    <message>
        <source>Take the pictures in %1 into your project.</source>
        <translation>Ta in bilderna i %1 i ditt projekt.</translation>
    </message>
    <message>
        <source>Import the colours as sRGB, and light maps and motion vectors as numbers, not colours.</source>
        <translation>Importera färgerna som sRGB, och ljuskartor och rörelsevektorer som tal, inte färger.</translation>
    </message>
    <message>
        <source>Play the cells as %1 says.</source>
        <translation>Spela cellerna som %1 säger.</translation>
    </message>
</context>
<context>
    <name>fumage::ui::ExportCheck</name>
    <message>
        <source>%1 is missing</source>
        <translation>%1 saknas</translation>
    </message>
    <message>
        <source>%1 is different</source>
        <translation>%1 är annorlunda</translation>
    </message>
    <message>
        <source>%1 is broken</source>
        <translation>%1 är trasig</translation>
    </message>
    <message>
        <source>the manifest says two things of %1</source>
        <translation>manifestet säger två saker om %1</translation>
    </message>
    <message>
        <source>%1 is not in the manifest</source>
        <translation>%1 finns inte i manifestet</translation>
    </message>
    <message>
        <source>Verified: the file is as it was written</source>
        <translation>Kontrollerad: filen är som den skrevs</translation>
    </message>
    <message>
        <source>Verified: %1 files are as they were written</source>
        <translation>Kontrollerade: %1 filer är som de skrevs</translation>
    </message>
    <message>
        <source>%1 more</source>
        <translation>%1 till</translation>
    </message>
    <message>
        <source>1 of %1 files is not as it was written: %2</source>
        <translation>1 av %1 filer är inte som den skrevs: %2</translation>
    </message>
    <message>
        <source>%1 of %2 files are not as they were written: %3</source>
        <translation>%1 av %2 filer är inte som de skrevs: %3</translation>
    </message>
    <message>
        <source>Verifying…</source>
        <translation>Kontrollerar…</translation>
    </message>
    <message>
        <source>Verifying: %1 of %2</source>
        <translation>Kontrollerar: %1 av %2</translation>
    </message>
    <message>
        <source>%1 is not a file</source>
        <translation>%1 är ingen fil</translation>
    </message>
    <message>
        <source>%1 cannot be read</source>
        <translation>%1 kan inte läsas</translation>
    </message>
</context>
<context>
    <name>fumage::ui::ExportController</name>
    <message>
        <source>The queue of exports cannot be kept safe: %1</source>
        <translation>Exportkön kan inte sparas undan: %1</translation>
    </message>
    <message>
        <source>Exporting “%1”: %2</source>
        <translation>Exporterar ”%1”: %2</translation>
    </message>
    <message>
        <source>Exported %1</source>
        <translation>Exporterade %1</translation>
    </message>
    <message>
        <source>Export cancelled</source>
        <translation>Exporten avbröts</translation>
    </message>
    <message>
        <source>Export failed: %1</source>
        <translation>Exporten misslyckades: %1</translation>
    </message>
</context>
<context>
    <name>fumage::ui::ExportDialog</name>
    <message>
        <source>Export</source>
        <translation>Exportera</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Avbryt</translation>
    </message>
    <message>
        <source>Show in folder</source>
        <translation>Visa i mappen</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Format</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Fil</translation>
    </message>
    <message>
        <source>A run of # becomes the number of the frame</source>
        <translation>En följd av # blir bildrutans nummer</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Välj…</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>Bildrutor</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Stäng</translation>
    </message>
    <message>
        <source>Export to</source>
        <translation>Exportera till</translation>
    </message>
    <message>
        <source>Size of cells</source>
        <translation>Cellernas storlek</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>Typ</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>Bildruta</translation>
    </message>
</context>
<context>
    <name>fumage::ui::ExportProgress</name>
    <message>
        <source>Done: %1</source>
        <translation>Klart: %1</translation>
    </message>
    <message>
        <source>Fit the camera</source>
        <translation>Anpassa kameran</translation>
    </message>
    <message>
        <source>Exports again, from where all smoke is seen</source>
        <translation>Exporterar igen, därifrån all rök syns</translation>
    </message>
</context>
<context>
    <name>fumage::ui::ExportQueue</name>
    <message>
        <source>%1 of %2</source>
        <translation>%1 av %2</translation>
    </message>
    <message>
        <source>%1, %2 s left</source>
        <translation>%1, %2 s kvar</translation>
    </message>
</context>
<context>
    <name>fumage::ui::ExportWorker</name>
    <message>
        <source>Baking the air: %1 %</source>
        <translation>Bakar luften: %1 %</translation>
    </message>
    <message>
        <source>Looking where the smoke is: %1 %</source>
        <translation>Letar efter röken: %1 %</translation>
    </message>
    <message>
        <source>Simulating what comes before: %1 %</source>
        <translation>Simulerar det som kommer före: %1 %</translation>
    </message>
    <message>
        <source>left</source>
        <translation>vänster</translation>
    </message>
    <message>
        <source>right</source>
        <translation>höger</translation>
    </message>
    <message>
        <source>top</source>
        <translation>överkant</translation>
    </message>
    <message>
        <source>bottom</source>
        <translation>underkant</translation>
    </message>
    <message>
        <source>The smoke is cut off at the edge of cells (%1) in frames %2 to %3. Fit the camera, or move it back to %4 m.</source>
        <translation>Röken skärs av vid rutornas kant (%1) i bildruta %2 till %3. Anpassa kameran, eller flytta den bakåt till %4 m.</translation>
    </message>
    <message>
        <source>The smoke is cut off at the edge of cells (%1) in frames %2 to %3. Fit the camera.</source>
        <translation>Röken skärs av vid rutornas kant (%1) i bildruta %2 till %3. Anpassa kameran.</translation>
    </message>
    <message>
        <source>Outliers are cut off at the edge of cells (%1) in frames %2 to %3.</source>
        <translation>Ströpartiklar skärs av vid cellernas kant (%1) i bildrutorna %2 till %3.</translation>
    </message>
</context>
<context>
    <name>Exports</name>
    <message>
        <source>Image sequence</source>
        <translation>Bildsekvens</translation>
    </message>
    <message>
        <source>Flipbook</source>
        <translation>Flipbook</translation>
    </message>
    <message>
        <source>Video</source>
        <translation>Film</translation>
    </message>
    <message>
        <source>Single picture</source>
        <translation>En bild</translation>
    </message>
    <message>
        <source>Noise texture</source>
        <translation>Brustextur</translation>
    </message>
    <message>
        <source>Particles</source>
        <translation>Partiklar</translation>
    </message>
    <message>
        <source>Volumes</source>
        <translation>Volymer</translation>
    </message>
    <message>
        <source>Air as a vector field</source>
        <translation>Luften som vektorfält</translation>
    </message>
    <message>
        <source>CSV, one particle a line</source>
        <translation>CSV, en partikel per rad</translation>
    </message>
    <message>
        <source>PLY, binary points</source>
        <translation>PLY, binära punkter</translation>
    </message>
    <message>
        <source>Point cache for Unity, binary</source>
        <translation>Punktmoln för Unity, binärt</translation>
    </message>
    <message>
        <source>OpenVDB, half floats</source>
        <translation>OpenVDB, halva flyttal</translation>
    </message>
    <message>
        <source>FGA for Unreal</source>
        <translation>FGA för Unreal</translation>
    </message>
    <message>
        <source>Volume File for Unity</source>
        <translation>Volume File för Unity</translation>
    </message>
    <message>
        <source>MP4 (H.264), on the background colour</source>
        <translation>MP4 (H.264), på bakgrundsfärgen</translation>
    </message>
    <message>
        <source>WebM (VP9), transparent</source>
        <translation>WebM (VP9), genomskinlig</translation>
    </message>
    <message>
        <source>QuickTime (ProRes 4444), transparent</source>
        <translation>QuickTime (ProRes 4444), genomskinlig</translation>
    </message>
    <message>
        <source>GIF, on the background colour</source>
        <translation>GIF, på bakgrundsfärgen</translation>
    </message>
    <message>
        <source>APNG, transparent</source>
        <translation>APNG, genomskinlig</translation>
    </message>
    <message>
        <source>PNG, 8 bits</source>
        <translation>PNG, 8 bitar</translation>
    </message>
    <message>
        <source>PNG, 16 bits</source>
        <translation>PNG, 16 bitar</translation>
    </message>
    <message>
        <source>OpenEXR, half floats, linear</source>
        <translation>OpenEXR, halva flyttal, linjär</translation>
    </message>
    <message>
        <source>OpenEXR, floats, linear</source>
        <translation>OpenEXR, flyttal, linjär</translation>
    </message>
    <message>
        <source>TGA, 8 bits</source>
        <translation>TGA, 8 bitar</translation>
    </message>
    <message>
        <source>%1, %2 × %3 pixels, and %4 more files</source>
        <translation>%1, %2 × %3 bildpunkter, och %4 filer till</translation>
    </message>
    <message>
        <source>%1, %2 × %3 pixels, and %4</source>
        <translation>%1, %2 × %3 bildpunkter, och %4</translation>
    </message>
    <message>
        <source>On the graphics card: %1 as BC7, %2 uncompressed</source>
        <translation>På grafikkortet: %1 som BC7, %2 okomprimerat</translation>
    </message>
    <message>
        <source>Files: %1, from %2 to %3</source>
        <translation>Filer: %1, från %2 till %3</translation>
    </message>
    <message>
        <source>%1, %2 × %3 pixels, %4 s</source>
        <translation>%1, %2 × %3 bildpunkter, %4 s</translation>
    </message>
    <message>
        <source>Choose a file, and a first frame that comes before the last.</source>
        <translation>Välj en fil, och en första bildruta som kommer före den sista.</translation>
    </message>
    <message>
        <source>No air carries this smoke: switch it on in the group Air.</source>
        <translation>Ingen luft bär denna rök: slå på den i gruppen Luft.</translation>
    </message>
    <message>
        <source>%1 frames do not fill %2 cells: choose more frames or fewer columns and rows.</source>
        <translation>%1 bildrutor fyller inte %2 rutor: välj fler bildrutor eller färre kolumner och rader.</translation>
    </message>
    <message>
        <source>Use %1 × %2 cells</source>
        <translation>Använd %1 × %2 rutor</translation>
    </message>
    <message>
        <source>Use frames %1</source>
        <translation>Använd bildrutorna %1</translation>
    </message>
    <message>
        <source>Save as %1</source>
        <translation>Spara som %1</translation>
    </message>
    <message>
        <source>%1 already exists.</source>
        <translation>%1 finns redan.</translation>
    </message>
    <message>
        <source>%1 of the files are there already; the first is %2.</source>
        <translation>%1 av filerna finns redan; den första är %2.</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportera</translation>
    </message>
    <message>
        <source>Overwrite</source>
        <translation>Skriv över</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Avbryt</translation>
    </message>
    <message>
        <source>Cell width</source>
        <translation>Rutans bredd</translation>
    </message>
    <message>
        <source>Cell height</source>
        <translation>Rutans höjd</translation>
    </message>
    <message>
        <source>Interrupted</source>
        <translation>Inte färdig: kvar sedan tidigare</translation>
    </message>
    <message>
        <source>Waiting</source>
        <translation>Väntar</translation>
    </message>
    <message>
        <source>Begun</source>
        <translation>Påbörjad</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Klar</translation>
    </message>
    <message>
        <source>Failed</source>
        <translation>Misslyckades</translation>
    </message>
    <message>
        <source>Cancelled. Files that were complete are kept.</source>
        <translation>Avbruten. Filer som var färdiga finns kvar.</translation>
    </message>
</context>
<context>
    <name>fumage::ui::FileNotices</name>
    <message>
        <source>“%1” has been changed by another program. Reload it, which can be undone, or keep this version: it replaces the other when you save it.</source>
        <translation>”%1” har ändrats av ett annat program. Läs in den igen, vilket kan ångras, eller behåll den här versionen: den ersätter den andra när du sparar.</translation>
    </message>
    <message>
        <source>Reload</source>
        <translation>Läs in igen</translation>
    </message>
    <message>
        <source>Keep this version</source>
        <translation>Behåll den här versionen</translation>
    </message>
    <message>
        <source>“%1” has been deleted or moved. What you see is kept as unsaved work: save it to have a file again.</source>
        <translation>”%1” har tagits bort eller flyttats. Det du ser behålls som osparat arbete: spara det för att åter ha en fil.</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Spara</translation>
    </message>
    <message>
        <source>Save as…</source>
        <translation>Spara som…</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Stäng</translation>
    </message>
    <message>
        <source>This is unsaved work from before the program ended unexpectedly. Save it to keep it.</source>
        <translation>Detta är osparat arbete från innan programmet oväntat tog slut. Spara det för att behålla det.</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Kasta</translation>
    </message>
</context>
<context>
    <name>fumage::ui::FlipbookChoices</name>
    <message>
        <source>Light maps</source>
        <translation>Ljuskartor</translation>
    </message>
    <message>
        <source>Motion vectors</source>
        <translation>Rörelsevektorer</translation>
    </message>
    <message>
        <source>Columns</source>
        <translation>Kolumner</translation>
    </message>
    <message>
        <source>Rows</source>
        <translation>Rader</translation>
    </message>
    <message>
        <source>For</source>
        <translation>För</translation>
    </message>
    <message>
        <source>What is to play it: the files that it needs are written, too</source>
        <translation>Vad som ska spela upp det: filerna som behövs skrivs också</translation>
    </message>
    <message>
        <source>Any engine</source>
        <translation>Valfri motor</translation>
    </message>
    <message>
        <source>Web page</source>
        <translation>Webbsida</translation>
    </message>
    <message>
        <source>Two pictures with light from six sides, so that an engine lights the smoke with its own lights</source>
        <translation>Två bilder med ljus från sex håll, så att en motor belyser röken med sina egna ljus</translation>
    </message>
    <message>
        <source>A picture of where the smoke goes, so that an engine moves it between the cells</source>
        <translation>En bild av vart röken rör sig, så att en motor flyttar den mellan rutorna</translation>
    </message>
    <message>
        <source>Extra maps</source>
        <translation>Extra kartor</translation>
    </message>
    <message>
        <source>Grid</source>
        <translation>Rutnät</translation>
    </message>
    <message>
        <source>Layers</source>
        <translation>Lager</translation>
    </message>
    <message>
        <source>Together</source>
        <translation>Tillsammans</translation>
    </message>
    <message>
        <source>Each alone</source>
        <translation>Var för sig</translation>
    </message>
    <message>
        <source>Contributions</source>
        <translation>Bidrag</translation>
    </message>
    <message>
        <source>Stacked</source>
        <translation>Staplade</translation>
    </message>
    <message>
        <source>Together: one sheet. Each alone: a sheet a layer that nothing hides. Contributions: the others hide what they hide, and all sheets add up to the picture. Stacked: sheets that are the picture when they are drawn over one another, premultiplied.</source>
        <translation>Tillsammans: ett ark. Var för sig: ett ark per lager, som inget döljer. Bidrag: de andra döljer vad de döljer, och alla ark blir bilden när de läggs ihop. Staplade: ark som blir bilden när de ritas ovanpå varandra, förmultiplicerade.</translation>
    </message>
</context>
<context>
    <name>fumage::ui::FlipbookExtras</name>
    <message>
        <source>More</source>
        <translation>Mer</translation>
    </message>
    <message>
        <source>Cells become as large as the nearest power of two; with 1, 2, 4 to 64 columns and rows</source>
        <translation>Celler blir så stora som närmaste tvåpotens; med 1, 2, 4 till 64 kolumner och rader</translation>
    </message>
    <message>
        <source>From left to right through the cells, from bottom to top through the frames: level is still, falling is backwards</source>
        <translation>Från vänster till höger genom cellerna, nedifrån och upp genom bildrutorna: plant är stilla, fallande är baklänges</translation>
    </message>
    <message>
        <source>Frames by cells</source>
        <translation>Bildrutor efter celler</translation>
    </message>
    <message>
        <source>A picture whose channels are those of passes that you choose</source>
        <translation>En bild vars kanaler är de av passen som du väljer</translation>
    </message>
    <message>
        <source>Not of a loop, which would no longer close</source>
        <translation>Inte av en slinga, som då inte längre skulle gå ihop</translation>
    </message>
    <message>
        <source>Frames without smoke at the beginning and the end have no cells</source>
        <translation>Bildrutor utan rök i början och slutet får inga celler</translation>
    </message>
    <message>
        <source>Trim empty frames</source>
        <translation>Beskär tomma bildrutor</translation>
    </message>
    <message>
        <source>Power-of-two sheet</source>
        <translation>Ark med tvåpotenser</translation>
    </message>
    <message>
        <source>Retime with a curve</source>
        <translation>Ändra tiden med en kurva</translation>
    </message>
    <message>
        <source>Add channel-packed texture</source>
        <translation>Lägg till kanalpackad textur</translation>
    </message>
</context>
<context>
    <name>Gizmos</name>
    <message>
        <source>Emitter</source>
        <translation>Utsändare</translation>
    </message>
    <message>
        <source>Normal</source>
        <translation>Normal</translation>
    </message>
    <message>
        <source>Wind</source>
        <translation>Vind</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Ljus</translation>
    </message>
    <message>
        <source>Vortex</source>
        <translation>Virvel</translation>
    </message>
    <message>
        <source>Rings</source>
        <translation>Ringar</translation>
    </message>
    <message>
        <source>Obstacle</source>
        <translation>Hinder</translation>
    </message>
    <message>
        <source>Air</source>
        <translation>Luft</translation>
    </message>
</context>
<context>
    <name>GlSprites</name>
    <message>
        <source>The graphics driver refuses the shader %1: %2</source>
        <translation>Grafikdrivrutinen vägrar skuggaren %1: %2</translation>
    </message>
</context>
<context>
    <name>fumage::ui::GradientBar</name>
    <message>
        <source>Colour of the stop</source>
        <translation>Stoppets färg</translation>
    </message>
</context>
<context>
    <name>fumage::ui::GradientEditor</name>
    <message>
        <source>Click to add, drag to move, double click for the colour, right click for more</source>
        <translation>Tryck för att lägga till, dra för att flytta, dubbelklicka för färgen, högerklicka för mer</translation>
    </message>
    <message>
        <source>presets</source>
        <translation>förinställningar</translation>
    </message>
    <message>
        <source>Presets</source>
        <translation>Förinställningar</translation>
    </message>
    <message>
        <source>Gradients to begin with, and other hues for all colours of this one</source>
        <translation>Övertoningar att börja med, och andra nyanser för alla färger i denna</translation>
    </message>
    <message>
        <source>Gradient</source>
        <translation>Övertoning</translation>
    </message>
    <message>
        <source>Other hues</source>
        <translation>Andra nyanser</translation>
    </message>
    <message>
        <source>Reverse</source>
        <translation>Vänd</translation>
    </message>
</context>
<context>
    <name>GradientPresets</name>
    <message>
        <source>Fire</source>
        <translation>Eld</translation>
    </message>
    <message>
        <source>Gas flame</source>
        <translation>Gaslåga</translation>
    </message>
    <message>
        <source>Ice</source>
        <translation>Is</translation>
    </message>
    <message>
        <source>Magic</source>
        <translation>Magi</translation>
    </message>
    <message>
        <source>Poison</source>
        <translation>Gift</translation>
    </message>
    <message>
        <source>Sunset</source>
        <translation>Solnedgång</translation>
    </message>
    <message>
        <source>Soot</source>
        <translation>Sot</translation>
    </message>
    <message>
        <source>White</source>
        <translation>Vitt</translation>
    </message>
</context>
<context>
    <name>GraphCurves</name>
    <message>
        <source>red</source>
        <translation>rött</translation>
    </message>
    <message>
        <source>green</source>
        <translation>grönt</translation>
    </message>
    <message>
        <source>blue</source>
        <translation>blått</translation>
    </message>
</context>
<context>
    <name>fumage::ui::GraphGrip</name>
    <message>
        <source>Height of the graph</source>
        <translation>Kurvornas höjd</translation>
    </message>
    <message>
        <source>Drag for a higher graph; a double-click gives it its usual height</source>
        <translation>Dra för högre kurvor; ett dubbelklick ger dem deras vanliga höjd</translation>
    </message>
</context>
<context>
    <name>fumage::ui::GuardedApplication</name>
    <message>
        <source>Not enough memory</source>
        <translation>Minnet räcker inte</translation>
    </message>
    <message>
        <source>There is not enough memory for what you just did. Save your work.</source>
        <translation>Minnet räcker inte till det du just gjorde. Spara ditt arbete.</translation>
    </message>
    <message>
        <source>Something failed</source>
        <translation>Något misslyckades</translation>
    </message>
    <message>
        <source>What you just did may not have been done. Save your work. %1</source>
        <translation>Det du just gjorde kanske inte har utförts. Spara ditt arbete. %1</translation>
    </message>
</context>
<context>
    <name>Help</name>
    <message>
        <source>Find</source>
        <translation>Sök</translation>
    </message>
    <message>
        <source>Parameter reference</source>
        <translation>Parameterreferens</translation>
    </message>
    <message>
        <source>Keyboard shortcuts</source>
        <translation>Kortkommandon</translation>
    </message>
    <message>
        <source>About Fumage</source>
        <translation>Om Fumage</translation>
    </message>
    <message>
        <source>An editor for smoke. Free software under the MIT licence.

The model begins with Lin and Lin, “Smoke Simulation with Perlin Noise”, University of Gävle, 2012. Made with Qt, GLM, Highway, oneTBB, libpng and OpenEXR.</source>
        <translation>En redigerare för rök. Fri programvara under MIT-licensen.

Modellen utgår från Lin och Lin, ”Smoke Simulation with Perlin Noise”, Högskolan i Gävle, 2012. Byggd med Qt, GLM, Highway, oneTBB, libpng och OpenEXR.</translation>
    </message>
    <message>
        <source>%1 These are the tips of all parameters.</source>
        <translation>%1 Detta är alla parametrars tips.</translation>
    </message>
</context>
<context>
    <name>fumage::ui::HistoryView</name>
    <message>
        <source>As opened</source>
        <translation>Som det öppnades</translation>
    </message>
    <message>
        <source>Undo history</source>
        <translation>Ångra-historik</translation>
    </message>
</context>
<context>
    <name>KeyClipboard</name>
    <message>
        <source>Paste key frames</source>
        <translation>Klistra in nyckelbildrutor</translation>
    </message>
</context>
<context>
    <name>KeyEdits</name>
    <message>
        <source>Key %1</source>
        <translation>Nyckla %1</translation>
    </message>
    <message>
        <source>%1 outside its key frames</source>
        <translation>%1 utanför sina nyckelbildrutor</translation>
    </message>
    <message>
        <source>Remove key frames</source>
        <translation>Ta bort nyckelbildrutor</translation>
    </message>
    <message>
        <source>Ease of key frames</source>
        <translation>Nyckelbildrutors övergång</translation>
    </message>
    <message>
        <source>Mend key frames of %1</source>
        <translation>Laga nyckelbildrutorna för %1</translation>
    </message>
    <message>
        <source>Mend key frames</source>
        <translation>Laga nyckelbildrutor</translation>
    </message>
</context>
<context>
    <name>fumage::ui::KeyGraph</name>
    <message>
        <source>Curves of key frames</source>
        <translation>Nyckelbildrutornas kurvor</translation>
    </message>
    <message>
        <source>Drag keys and their handles (Ctrl: one side alone); a double-click on a curve adds a key; the wheel zooms the values, F shows all</source>
        <translation>Dra nycklar och deras handtag (Ctrl: bara en sida); dubbelklick på en kurva lägger till en nyckel; hjulet zoomar värdena, F visar allt</translation>
    </message>
    <message>
        <source>Move key frames</source>
        <translation>Flytta nyckelbildrutor</translation>
    </message>
    <message>
        <source>Bend a curve</source>
        <translation>Böj en kurva</translation>
    </message>
    <message>
        <source>on</source>
        <translation>på</translation>
    </message>
    <message>
        <source>off</source>
        <translation>av</translation>
    </message>
</context>
<context>
    <name>fumage::ui::KeyLanes</name>
    <message>
        <source>Key frames</source>
        <translation>Nyckelbildrutor</translation>
    </message>
    <message>
        <source>Drag key frames to other times; Alt stretches, Delete removes, a double-click adds one</source>
        <translation>Dra nyckelbildrutor till andra tider; Alt sträcker ut, Delete tar bort, dubbelklick lägger till</translation>
    </message>
    <message>
        <source>Move key frames</source>
        <translation>Flytta nyckelbildrutor</translation>
    </message>
</context>
<context>
    <name>fumage::ui::KeyMark</name>
    <message>
        <source>Key frame of %1</source>
        <translation>Nyckelbildruta för %1</translation>
    </message>
    <message>
        <source>Key frame here; click to remove it</source>
        <translation>Nyckelbildruta här; klicka för att ta bort den</translation>
    </message>
    <message>
        <source>Click to set a key frame at the time that is shown</source>
        <translation>Klicka för att sätta en nyckelbildruta vid den visade tiden</translation>
    </message>
</context>
<context>
    <name>KeyMends</name>
    <message>
        <source>It does not end as it begins, so the loop jumps there.</source>
        <translation>Den slutar inte som den börjar, så slingan hoppar där.</translation>
    </message>
    <message>
        <source>It has key frames after the end of the timeline.</source>
        <translation>Den har nyckelbildrutor efter tidslinjens slut.</translation>
    </message>
    <message>
        <source>It changes at once at a held key frame, so what it drives changes its pace with a jerk.</source>
        <translation>Den ändras på en gång vid en hållen nyckelbildruta, så det den driver byter takt med ett ryck.</translation>
    </message>
    <message>
        <source>Make periodic</source>
        <translation>Gör periodisk</translation>
    </message>
    <message>
        <source>Move into the timeline</source>
        <translation>Flytta in i tidslinjen</translation>
    </message>
    <message>
        <source>Smooth the jumps</source>
        <translation>Jämna ut hoppen</translation>
    </message>
</context>
<context>
    <name>KeyMenu</name>
    <message>
        <source>Smooth</source>
        <translation>Mjuk</translation>
    </message>
    <message>
        <source>Linear</source>
        <translation>Linjär</translation>
    </message>
    <message>
        <source>Hold</source>
        <translation>Håll</translation>
    </message>
    <message>
        <source>Free</source>
        <translation>Fri</translation>
    </message>
    <message>
        <source>Ease in</source>
        <translation>Mjuk in</translation>
    </message>
    <message>
        <source>Ease out</source>
        <translation>Mjuk ut</translation>
    </message>
    <message>
        <source>Ease in and out</source>
        <translation>Mjuk in och ut</translation>
    </message>
    <message>
        <source>Repeat</source>
        <translation>Upprepa</translation>
    </message>
    <message>
        <source>Back and forth</source>
        <translation>Fram och tillbaka</translation>
    </message>
    <message>
        <source>After the last key frame</source>
        <translation>Efter den sista nyckelbildrutan</translation>
    </message>
    <message>
        <source>Before the first key frame</source>
        <translation>Före den första nyckelbildrutan</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopiera</translation>
    </message>
    <message>
        <source>Paste at the time that is shown</source>
        <translation>Klistra in vid den visade tiden</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Ta bort</translation>
    </message>
</context>
<context>
    <name>KeyTable</name>
    <message>
        <source>Tables (*.csv *.tsv *.txt);;All files (*)</source>
        <translation>Tabeller (*.csv *.tsv *.txt);;Alla filer (*)</translation>
    </message>
    <message>
        <source>The key frames could not be written</source>
        <translation>Nyckelbildrutorna kunde inte skrivas</translation>
    </message>
    <message>
        <source>Write as CSV…</source>
        <translation>Skriv som CSV…</translation>
    </message>
    <message>
        <source>Write key frames</source>
        <translation>Skriv nyckelbildrutor</translation>
    </message>
    <message>
        <source>Read from CSV…</source>
        <translation>Läs från CSV…</translation>
    </message>
    <message>
        <source>Read key frames</source>
        <translation>Läs nyckelbildrutor</translation>
    </message>
    <message>
        <source>The key frames could not be read</source>
        <translation>Nyckelbildrutorna kunde inte läsas</translation>
    </message>
    <message>
        <source>Read key frames of %1</source>
        <translation>Läs nyckelbildrutor för %1</translation>
    </message>
</context>
<context>
    <name>LayerClipboard</name>
    <message>
        <source>Paste %1 of “%2”</source>
        <translation>Klistra in %1 från ”%2”</translation>
    </message>
</context>
<context>
    <name>LayerEdits</name>
    <message>
        <source>Layer %1</source>
        <translation>Lager %1</translation>
    </message>
    <message>
        <source>Add a layer</source>
        <translation>Lägg till ett lager</translation>
    </message>
    <message>
        <source>Add the layers of “%1”</source>
        <translation>Lägg till lagren i ”%1”</translation>
    </message>
    <message>
        <source>Duplicate %1</source>
        <translation>Duplicera %1</translation>
    </message>
    <message>
        <source>Delete %1</source>
        <translation>Ta bort %1</translation>
    </message>
    <message>
        <source>Move %1</source>
        <translation>Flytta %1</translation>
    </message>
    <message>
        <source>Rename %1</source>
        <translation>Byt namn på %1</translation>
    </message>
    <message>
        <source>Show %1</source>
        <translation>Visa %1</translation>
    </message>
    <message>
        <source>Mute %1</source>
        <translation>Tysta %1</translation>
    </message>
    <message>
        <source>Lock %1</source>
        <translation>Lås %1</translation>
    </message>
    <message>
        <source>Unlock %1</source>
        <translation>Lås upp %1</translation>
    </message>
    <message>
        <source>Colour tag of %1</source>
        <translation>Färgmärke på %1</translation>
    </message>
    <message>
        <source>%1 layers</source>
        <translation>%1 lager</translation>
    </message>
    <message>
        <source>%1: born on %2</source>
        <translation>%1: föds på %2</translation>
    </message>
    <message>
        <source>%1: born on the emitter</source>
        <translation>%1: föds på utsändaren</translation>
    </message>
</context>
<context>
    <name>fumage::ui::LayerList</name>
    <message>
        <source>None</source>
        <translation>Ingen</translation>
    </message>
    <message>
        <source>Red</source>
        <translation>Röd</translation>
    </message>
    <message>
        <source>Orange</source>
        <translation>Orange</translation>
    </message>
    <message>
        <source>Yellow</source>
        <translation>Gul</translation>
    </message>
    <message>
        <source>Green</source>
        <translation>Grön</translation>
    </message>
    <message>
        <source>Blue</source>
        <translation>Blå</translation>
    </message>
    <message>
        <source>Violet</source>
        <translation>Violett</translation>
    </message>
    <message>
        <source>Grey</source>
        <translation>Grå</translation>
    </message>
    <message>
        <source>Add a layer</source>
        <translation>Lägg till ett lager</translation>
    </message>
    <message>
        <source>Duplicate the layer</source>
        <translation>Duplicera lagret</translation>
    </message>
    <message>
        <source>Delete the layer</source>
        <translation>Ta bort lagret</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Byt namn</translation>
    </message>
    <message>
        <source>Mute</source>
        <translation>Tysta</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Visa</translation>
    </message>
    <message>
        <source>Unlock</source>
        <translation>Lås upp</translation>
    </message>
    <message>
        <source>Lock</source>
        <translation>Lås</translation>
    </message>
    <message>
        <source>Colour tag</source>
        <translation>Färgmärke</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>Duplicera</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Ta bort</translation>
    </message>
    <message>
        <source>No longer solo</source>
        <translation>Inte längre solo</translation>
    </message>
    <message>
        <source>Solo</source>
        <translation>Solo</translation>
    </message>
    <message>
        <source>End solo</source>
        <translation>Avsluta solo</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Klipp ut</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopiera</translation>
    </message>
    <message>
        <source>Paste</source>
        <translation>Klistra in</translation>
    </message>
    <message>
        <source>Paste parameters…</source>
        <translation>Klistra in parametrar…</translation>
    </message>
    <message>
        <source>Born on</source>
        <translation>Föds på</translation>
    </message>
    <message>
        <source>Its emitter</source>
        <translation>Sin utsändare</translation>
    </message>
    <message>
        <source>Smoke</source>
        <translation>Rök</translation>
    </message>
</context>
<context>
    <name>fumage::ui::LayerModel</name>
    <message>
        <source>%1 particles</source>
        <translation>%1 partiklar</translation>
    </message>
    <message>
        <source>Muted: it is neither simulated nor exported</source>
        <translation>Tystat: det varken simuleras eller exporteras</translation>
    </message>
    <message>
        <source>%1 % of the simulation</source>
        <translation>%1 % av simuleringen</translation>
    </message>
    <message>
        <source>Born on %1</source>
        <translation>Föds på %1</translation>
    </message>
</context>
<context>
    <name>LayerTemplates</name>
    <message>
        <source>Flames</source>
        <translation>Lågor</translation>
    </message>
    <message>
        <source>Embers</source>
        <translation>Glöd</translation>
    </message>
    <message>
        <source>Sparks</source>
        <translation>Gnistor</translation>
    </message>
    <message>
        <source>Fireball</source>
        <translation>Eldklot</translation>
    </message>
    <message>
        <source>Debris with trails</source>
        <translation>Skräp med spår</translation>
    </message>
    <message>
        <source>Dust ring</source>
        <translation>Dammring</translation>
    </message>
    <message>
        <source>Jet</source>
        <translation>Stråle</translation>
    </message>
    <message>
        <source>Falling fog</source>
        <translation>Fallande dimma</translation>
    </message>
    <message>
        <source>Glitter</source>
        <translation>Glitter</translation>
    </message>
    <message>
        <source>Halo</source>
        <translation>Gloria</translation>
    </message>
</context>
<context>
    <name>fumage::ui::LayerTransfer</name>
    <message>
        <source>Cut %1</source>
        <translation>Klipp ut %1</translation>
    </message>
    <message>
        <source>A scene has at most %1 layers: %2 were left out.</source>
        <translation>En scen har högst %1 lager: %2 utelämnades.</translation>
    </message>
    <message>
        <source>Cannot paste layers</source>
        <translation>Lager kan inte klistras in</translation>
    </message>
    <message>
        <source>Pasted layer</source>
        <translation>Inklistrat lager</translation>
    </message>
    <message>
        <source>Paste %1</source>
        <translation>Klistra in %1</translation>
    </message>
    <message>
        <source>Cannot paste parameters</source>
        <translation>Parametrar kan inte klistras in</translation>
    </message>
    <message>
        <source>Cannot add layers</source>
        <translation>Lager kan inte läggas till</translation>
    </message>
    <message>
        <source>Cannot add “%1”</source>
        <translation>Kan inte lägga till ”%1”</translation>
    </message>
    <message>
        <source>Add “%1”</source>
        <translation>Lägg till ”%1”</translation>
    </message>
</context>
<context>
    <name>fumage::ui::LayerView</name>
    <message>
        <source>Layers</source>
        <translation>Lager</translation>
    </message>
    <message>
        <source>Show or mute, in exports, too (Alt: look at this layer alone)</source>
        <translation>Visa eller tysta, också i exporter (Alt: se bara detta lager)</translation>
    </message>
    <message>
        <source>Look at this layer alone: in the viewport, not in exports</source>
        <translation>Se bara detta lager: i vyn, inte i exporter</translation>
    </message>
</context>
<context>
    <name>fumage::ui::MainWindow</name>
    <message>
        <source>Unsaved work cannot be kept safe: %1</source>
        <translation>Osparat arbete kan inte hållas i säkerhet: %1</translation>
    </message>
    <message>
        <source>Apply “%1”</source>
        <translation>Lägg in ”%1”</translation>
    </message>
    <message>
        <source>There is not enough memory for this picture. Use fewer particles or a smaller window.</source>
        <translation>Minnet räcker inte till den här bilden. Använd färre partiklar eller ett mindre fönster.</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>OK</source>
        <translation>OK</translation>
    </message>
    <message>
        <source>There is nothing to be seen that the tour could show.</source>
        <translation>Det syns inget som rundturen kunde visa.</translation>
    </message>
</context>
<context>
    <name>Manual</name>
    <message>
        <source>The page %1 cannot be read.</source>
        <translation>Sidan %1 kan inte läsas.</translation>
    </message>
    <message>
        <source>The page %1 is too large.</source>
        <translation>Sidan %1 är för stor.</translation>
    </message>
    <message>
        <source>The page %1 is not UTF-8 text.</source>
        <translation>Sidan %1 är inte text i UTF-8.</translation>
    </message>
    <message>
        <source>The manual is not installed: there is no folder %1.</source>
        <translation>Handboken är inte installerad: det finns ingen mapp %1.</translation>
    </message>
    <message>
        <source>The manual has no pages that can be read in %1.</source>
        <translation>Handboken har inga läsbara sidor i %1.</translation>
    </message>
    <message>
        <source>The page %1 has a paragraph that is too long.</source>
        <translation>Sidan %1 har ett för långt stycke.</translation>
    </message>
</context>
<context>
    <name>fumage::ui::ManualDocument</name>
    <message>
        <source>[This picture cannot be shown: %1]</source>
        <translation>[Bilden kan inte visas: %1]</translation>
    </message>
</context>
<context>
    <name>fumage::ui::ManualView</name>
    <message>
        <source>Page of the manual</source>
        <translation>Handbokens sida</translation>
    </message>
</context>
<context>
    <name>fumage::ui::ManualWindow</name>
    <message>
        <source>Back (Alt+Left)</source>
        <translation>Bakåt (Alt+Vänster)</translation>
    </message>
    <message>
        <source>Forward (Alt+Right)</source>
        <translation>Framåt (Alt+Höger)</translation>
    </message>
    <message>
        <source>Manual</source>
        <translation>Handbok</translation>
    </message>
    <message>
        <source>Contents of the manual</source>
        <translation>Handbokens innehåll</translation>
    </message>
    <message>
        <source>Found in the manual</source>
        <translation>Hittat i handboken</translation>
    </message>
    <message>
        <source>Message</source>
        <translation>Meddelande</translation>
    </message>
    <message>
        <source>Search the manual</source>
        <translation>Sök i handboken</translation>
    </message>
    <message>
        <source>Search the manual (Ctrl+F)</source>
        <translation>Sök i handboken (Ctrl+F)</translation>
    </message>
    <message>
        <source>The manual has nothing about “%1”.</source>
        <translation>Handboken har inget om ”%1”.</translation>
    </message>
    <message>
        <source>This page has no place “%1”.</source>
        <translation>Sidan har inget ställe ”%1”.</translation>
    </message>
    <message>
        <source>%1 — Manual</source>
        <translation>%1 — Handbok</translation>
    </message>
    <message>
        <source>This leads out of the manual, and is not opened: %1</source>
        <translation>Detta leder ut ur handboken och öppnas inte: %1</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>No results for “%1”. Try a part of a word, or another word.</source>
        <translation>Inga träffar på ”%1”. Försök med en del av ett ord, eller ett annat ord.</translation>
    </message>
</context>
<context>
    <name>MarkerEdits</name>
    <message>
        <source>Marker %1</source>
        <translation>Markör %1</translation>
    </message>
    <message>
        <source>Add a marker</source>
        <translation>Lägg till en markör</translation>
    </message>
    <message>
        <source>Rename a marker</source>
        <translation>Byt namn på en markör</translation>
    </message>
    <message>
        <source>Remove a marker</source>
        <translation>Ta bort en markör</translation>
    </message>
</context>
<context>
    <name>fumage::ui::MarkerLane</name>
    <message>
        <source>Markers</source>
        <translation>Markörer</translation>
    </message>
    <message>
        <source>Move a marker</source>
        <translation>Flytta en markör</translation>
    </message>
    <message>
        <source>%1 at %2 s</source>
        <translation>%1 vid %2 s</translation>
    </message>
    <message>
        <source>Name of the marker</source>
        <translation>Markörens namn</translation>
    </message>
    <message>
        <source>Rename…</source>
        <translation>Byt namn…</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Ta bort</translation>
    </message>
    <message>
        <source>Add a marker at the frame that is shown</source>
        <translation>Lägg till en markör vid den visade bildrutan</translation>
    </message>
</context>
<context>
    <name>Menus</name>
    <message>
        <source>Tools</source>
        <translation>Verktyg</translation>
    </message>
    <message>
        <source>As the system</source>
        <translation>Som systemet</translation>
    </message>
    <message>
        <source>The language changes when Fumage starts the next time.</source>
        <translation>Språket ändras nästa gång Fumage startar.</translation>
    </message>
    <message>
        <source>As the desktop</source>
        <translation>Som skrivbordet</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Mörkt</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Ljus</translation>
    </message>
</context>
<context>
    <name>fumage::ui::MessageBox</name>
    <message>
        <source>“%1” exists already. Replace it?</source>
        <translation>”%1” finns redan. Ska den ersättas?</translation>
    </message>
</context>
<context>
    <name>Messages</name>
    <message>
        <source>there is not enough memory</source>
        <translation>det finns inte tillräckligt med minne</translation>
    </message>
    <message>
        <source>Use a smaller picture or fewer particles</source>
        <translation>Använd en mindre bild eller färre partiklar</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1. %2</source>
        <translation>%1. %2</translation>
    </message>
    <message>
        <source>cannot read: %1</source>
        <translation>kan inte läsas: %1</translation>
    </message>
    <message>
        <source>it is not a regular file</source>
        <translation>det är ingen vanlig fil</translation>
    </message>
    <message>
        <source>Name a file</source>
        <translation>Ange en fil</translation>
    </message>
    <message>
        <source>the file has %1 bytes, more than the %2 that are read</source>
        <translation>filen har %1 byte, fler än de %2 som läses</translation>
    </message>
    <message>
        <source>Choose another file</source>
        <translation>Välj en annan fil</translation>
    </message>
    <message>
        <source>the folder cannot be made: %1</source>
        <translation>mappen kan inte skapas: %1</translation>
    </message>
    <message>
        <source>Choose another place</source>
        <translation>Välj en annan plats</translation>
    </message>
    <message>
        <source>cannot write: %1</source>
        <translation>kan inte skrivas: %1</translation>
    </message>
    <message>
        <source>there is no such file or folder</source>
        <translation>det finns ingen sådan fil eller mapp</translation>
    </message>
    <message>
        <source>Check the spelling of the path</source>
        <translation>Kontrollera stavningen av sökvägen</translation>
    </message>
    <message>
        <source>permission denied</source>
        <translation>åtkomst nekad</translation>
    </message>
    <message>
        <source>Choose a place that you may use, or change its permissions</source>
        <translation>Välj en plats som du får använda, eller ändra dess rättigheter</translation>
    </message>
    <message>
        <source>the disk is read-only</source>
        <translation>disken är skrivskyddad</translation>
    </message>
    <message>
        <source>Choose another disk</source>
        <translation>Välj en annan disk</translation>
    </message>
    <message>
        <source>it is a folder</source>
        <translation>det är en mapp</translation>
    </message>
    <message>
        <source>a part of the path is not a folder</source>
        <translation>en del av sökvägen är ingen mapp</translation>
    </message>
    <message>
        <source>Check the path</source>
        <translation>Kontrollera sökvägen</translation>
    </message>
    <message>
        <source>its symbolic links lead in a circle</source>
        <translation>dess symboliska länkar leder i en cirkel</translation>
    </message>
    <message>
        <source>Remove the link or name another file</source>
        <translation>Ta bort länken eller ange en annan fil</translation>
    </message>
    <message>
        <source>the name is too long</source>
        <translation>namnet är för långt</translation>
    </message>
    <message>
        <source>Choose a shorter name</source>
        <translation>Välj ett kortare namn</translation>
    </message>
    <message>
        <source>the disk is full</source>
        <translation>disken är full</translation>
    </message>
    <message>
        <source>Free some space or choose another disk</source>
        <translation>Frigör utrymme eller välj en annan disk</translation>
    </message>
    <message>
        <source>the file is larger than may be written here</source>
        <translation>filen är större än vad som får skrivas här</translation>
    </message>
    <message>
        <source>Choose another disk or a smaller size</source>
        <translation>Välj en annan disk eller en mindre storlek</translation>
    </message>
    <message>
        <source>this machine has no instruction set %1</source>
        <translation>den här datorn har ingen instruktionsuppsättning %1</translation>
    </message>
    <message>
        <source>Choose one of %1</source>
        <translation>Välj något av %1</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>true eller false</translation>
    </message>
    <message>
        <source>a whole number</source>
        <translation>ett heltal</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>ett tal</translation>
    </message>
    <message>
        <source>one of its names</source>
        <translation>något av dess namn</translation>
    </message>
    <message>
        <source>a whole number from 0 to 4294967295</source>
        <translation>ett heltal från 0 till 4294967295</translation>
    </message>
    <message>
        <source>three numbers [x, y, z]</source>
        <translation>tre tal [x, y, z]</translation>
    </message>
    <message>
        <source>three numbers [red, green, blue]</source>
        <translation>tre tal [röd, grön, blå]</translation>
    </message>
    <message>
        <source>a list of 1 to 16 points [x, y]</source>
        <translation>en lista med 1 till 16 punkter [x, y]</translation>
    </message>
    <message>
        <source>a list of 1 to 16 stops [at, red, green, blue]</source>
        <translation>en lista med 1 till 16 steg [läge, röd, grön, blå]</translation>
    </message>
    <message>
        <source>expected %1, found %2</source>
        <translation>väntade %1, fann %2</translation>
    </message>
    <message>
        <source>there is no %1</source>
        <translation>det finns inget %1</translation>
    </message>
    <message>
        <source>the number is not finite</source>
        <translation>talet är inte ändligt</translation>
    </message>
    <message>
        <source>Use a plain number such as 1.5</source>
        <translation>Använd ett vanligt tal, till exempel 1.5</translation>
    </message>
    <message>
        <source>%1 has no &quot;=&quot;</source>
        <translation>%1 saknar &quot;=&quot;</translation>
    </message>
    <message>
        <source>there is no parameter %1</source>
        <translation>det finns ingen parameter %1</translation>
    </message>
    <message>
        <source>List them with: fumage-cli parameters</source>
        <translation>Lista dem med: fumage-cli parameters</translation>
    </message>
    <message>
        <source>Did you mean %1?</source>
        <translation>Menade du %1?</translation>
    </message>
    <message>
        <source>the picture was cancelled</source>
        <translation>bilden avbröts</translation>
    </message>
    <message>
        <source>the picture cannot be written as EXR: %1</source>
        <translation>bilden kan inte skrivas som EXR: %1</translation>
    </message>
    <message>
        <source>no visible smoke in frames %1 to %2</source>
        <translation>ingen rök syns i bildruta %1 till %2</translation>
    </message>
    <message>
        <source>Choose other frames, or make the smoke denser</source>
        <translation>Välj andra bildrutor, eller gör röken tätare</translation>
    </message>
    <message>
        <source>a flipbook of %1 x %2 cells</source>
        <translation>en bildbok med %1 x %2 rutor</translation>
    </message>
    <message>
        <source>Use 1 to %1 columns and rows</source>
        <translation>Använd 1 till %1 kolumner och rader</translation>
    </message>
    <message>
        <source>%1 frames do not fill %2 cells</source>
        <translation>%1 bildrutor fyller inte %2 rutor</translation>
    </message>
    <message>
        <source>a flipbook of %1 x %2 pixels</source>
        <translation>en bildbok på %1 x %2 pixlar</translation>
    </message>
    <message>
        <source>Choose smaller or fewer cells: edges up to %1 pixels, at most %2 million in all</source>
        <translation>Välj mindre eller färre rutor: kanter upp till %1 pixlar, högst %2 miljoner totalt</translation>
    </message>
    <message>
        <source>unknown image format</source>
        <translation>okänt bildformat</translation>
    </message>
    <message>
        <source>this would overwrite the preset that it is made of</source>
        <translation>detta skulle skriva över förinställningen som det görs av</translation>
    </message>
    <message>
        <source>Choose another name</source>
        <translation>Välj ett annat namn</translation>
    </message>
    <message>
        <source>Name a file, or - for standard output</source>
        <translation>Ange en fil, eller - för standard ut</translation>
    </message>
    <message>
        <source>the ending %1 does not fit</source>
        <translation>ändelsen %1 passar inte</translation>
    </message>
    <message>
        <source>Use %1</source>
        <translation>Använd %1</translation>
    </message>
    <message>
        <source>these are several files</source>
        <translation>det här är flera filer</translation>
    </message>
    <message>
        <source>Name a file, or one frame</source>
        <translation>Ange en fil, eller en bildruta</translation>
    </message>
    <message>
        <source>the PNG library could not be started</source>
        <translation>PNG-biblioteket kunde inte startas</translation>
    </message>
    <message>
        <source>the picture cannot be written as PNG: %1</source>
        <translation>bilden kan inte skrivas som PNG: %1</translation>
    </message>
    <message>
        <source>invalid frame range %1</source>
        <translation>bildrutorna %1 går inte att förstå</translation>
    </message>
    <message>
        <source>Write 7, 0-119 or 0-119:2</source>
        <translation>Skriv 7, 0-119 eller 0-119:2</translation>
    </message>
    <message>
        <source>frames %1 run backwards or out of range</source>
        <translation>bildrutorna %1 går baklänges eller utanför gränserna</translation>
    </message>
    <message>
        <source>Use numbers from 0 to %1, the smaller first</source>
        <translation>Använd tal från 0 till %1, det mindre först</translation>
    </message>
    <message>
        <source>baking the noise was cancelled</source>
        <translation>bakningen av bruset avbröts</translation>
    </message>
    <message>
        <source>a noise tile of %1 pixels</source>
        <translation>en brusplatta på %1 pixlar</translation>
    </message>
    <message>
        <source>Choose 1 to %1</source>
        <translation>Välj 1 till %1</translation>
    </message>
    <message>
        <source>the text is not UTF-8</source>
        <translation>texten är inte UTF-8</translation>
    </message>
    <message>
        <source>Save the file as UTF-8</source>
        <translation>Spara filen som UTF-8</translation>
    </message>
    <message>
        <source>the file ends in the middle</source>
        <translation>filen slutar mitt i</translation>
    </message>
    <message>
        <source>It may have been cut off; use a copy of it</source>
        <translation>Den kan ha kapats; använd en kopia</translation>
    </message>
    <message>
        <source>this is not JSON: %1</source>
        <translation>detta är inte JSON: %1</translation>
    </message>
    <message>
        <source>brackets are nested more than %1 deep</source>
        <translation>parenteser är nästlade mer än %1 djupt</translation>
    </message>
    <message>
        <source>This is not a preset</source>
        <translation>Detta är ingen förinställning</translation>
    </message>
    <message>
        <source>the key %1 is there twice</source>
        <translation>nyckeln %1 finns två gånger</translation>
    </message>
    <message>
        <source>Remove one of them</source>
        <translation>Ta bort en av dem</translation>
    </message>
    <message>
        <source>this is not JSON: there is a zero byte</source>
        <translation>detta är inte JSON: det finns en nollbyte</translation>
    </message>
    <message>
        <source>It may be a binary file or a damaged one</source>
        <translation>Det kan vara en binär eller skadad fil</translation>
    </message>
    <message>
        <source>line %1, column %2</source>
        <translation>rad %1, kolumn %2</translation>
    </message>
    <message>
        <source>there is no built-in preset %1</source>
        <translation>det finns ingen inbyggd förinställning %1</translation>
    </message>
    <message>
        <source>there is no preset or file %1</source>
        <translation>det finns ingen förinställning eller fil %1</translation>
    </message>
    <message>
        <source>List the presets with: fumage-cli presets</source>
        <translation>Lista förinställningarna med: fumage-cli presets</translation>
    </message>
    <message>
        <source>a preset of %1 bytes</source>
        <translation>en förinställning på %1 byte</translation>
    </message>
    <message>
        <source>Presets have at most %1</source>
        <translation>Förinställningar har högst %1</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>a preset is an object in braces { }</source>
        <translation>en förinställning är ett objekt inom klamrar { }</translation>
    </message>
    <message>
        <source>this JSON is not a Fumage preset</source>
        <translation>denna JSON är ingen Fumage-förinställning</translation>
    </message>
    <message>
        <source>A preset begins with &quot;format&quot;: &quot;fumage-preset&quot;</source>
        <translation>En förinställning börjar med &quot;format&quot;: &quot;fumage-preset&quot;</translation>
    </message>
    <message>
        <source>the version of the preset is missing or not a whole number from 1</source>
        <translation>förinställningens version saknas eller är inget heltal från 1</translation>
    </message>
    <message>
        <source>the preset has version %1, this program reads up to %2</source>
        <translation>förinställningen har version %1, detta program läser upp till %2</translation>
    </message>
    <message>
        <source>Open it with a newer Fumage</source>
        <translation>Öppna den med en nyare Fumage</translation>
    </message>
    <message>
        <source>%1: expected a text in quotes</source>
        <translation>%1: väntade en text inom citattecken</translation>
    </message>
    <message>
        <source>%1: expected an object in braces { }</source>
        <translation>%1: väntade ett objekt inom klamrar { }</translation>
    </message>
    <message>
        <source>unknown key %1 is kept but has no effect</source>
        <translation>den okända nyckeln %1 behålls men har ingen verkan</translation>
    </message>
    <message>
        <source>unknown key %1 is kept but has no effect; did you mean %2?</source>
        <translation>den okända nyckeln %1 behålls men har ingen verkan; menade du %2?</translation>
    </message>
    <message>
        <source>%1 was out of range and is now %2</source>
        <translation>%1 var utanför gränserna och är nu %2</translation>
    </message>
    <message>
        <source>and %1 more warnings</source>
        <translation>och %1 varningar till</translation>
    </message>
    <message>
        <source>%1 parameters are not in the preset and keep their defaults, the first is %2</source>
        <translation>%1 parametrar finns inte i förinställningen och behåller sina standardvärden, den första är %2</translation>
    </message>
    <message>
        <source>a picture of %1 x %2 pixels</source>
        <translation>en bild på %1 x %2 pixlar</translation>
    </message>
    <message>
        <source>Choose a smaller size or less supersampling</source>
        <translation>Välj en mindre storlek eller mindre översampling</translation>
    </message>
    <message>
        <source>painting was cancelled</source>
        <translation>målningen avbröts</translation>
    </message>
    <message>
        <source>baking the noise texture was cancelled</source>
        <translation>bakningen av brustexturen avbröts</translation>
    </message>
    <message>
        <source>the simulation was cancelled</source>
        <translation>simuleringen avbröts</translation>
    </message>
    <message>
        <source>the export cannot be started: there are not enough memory or threads</source>
        <translation>exporten kan inte startas: det finns inte tillräckligt med minne eller trådar</translation>
    </message>
    <message>
        <source>Close other programs</source>
        <translation>Stäng andra program</translation>
    </message>
    <message>
        <source>the air was cancelled</source>
        <translation>luften avbröts</translation>
    </message>
    <message>
        <source>the folder of your presets cannot be made</source>
        <translation>mappen för dina förinställningar kan inte skapas</translation>
    </message>
    <message>
        <source>Save the preset somewhere else</source>
        <translation>Spara förinställningen någon annanstans</translation>
    </message>
    <message>
        <source>the emitter lies under the ground</source>
        <translation>utsändaren ligger under marken</translation>
    </message>
    <message>
        <source>Lower air.ground_height or raise emitter.position</source>
        <translation>Sänk air.ground_height eller höj emitter.position</translation>
    </message>
    <message>
        <source>the emitter lies outside the box of the air</source>
        <translation>utsändaren ligger utanför luftens låda</translation>
    </message>
    <message>
        <source>Turn air.fit on, or change air.offset or air.size</source>
        <translation>Slå på air.fit, eller ändra air.offset eller air.size</translation>
    </message>
    <message>
        <source>the obstacle fills the box of the air</source>
        <translation>hindret fyller luftens låda</translation>
    </message>
    <message>
        <source>Make the obstacle smaller, or move it</source>
        <translation>Gör hindret mindre, eller flytta det</translation>
    </message>
    <message>
        <source>%1 plays the colour, which is not among the passes</source>
        <translation>%1 spelar upp färgen, som inte finns bland passen</translation>
    </message>
    <message>
        <source>Add colour to the passes</source>
        <translation>Lägg till colour bland passen</translation>
    </message>
    <message>
        <source>what is written for %1 reads PNG</source>
        <translation>det som skrivs för %1 läser PNG</translation>
    </message>
    <message>
        <source>Choose PNG</source>
        <translation>Välj PNG</translation>
    </message>
    <message>
        <source>the passes of frames are layers of EXR</source>
        <translation>passen av bildrutor är lager i EXR</translation>
    </message>
    <message>
        <source>Choose EXR, or a flipbook</source>
        <translation>Välj EXR, eller en flipbook</translation>
    </message>
    <message>
        <source>the picture is broken: %1</source>
        <translation>bilden är trasig: %1</translation>
    </message>
    <message>
        <source>this is neither a PNG nor an EXR</source>
        <translation>detta är varken en PNG eller en EXR</translation>
    </message>
    <message>
        <source>this picture carries no preset</source>
        <translation>den här bilden bär ingen förinställning</translation>
    </message>
    <message>
        <source>the program cannot be started: %1</source>
        <translation>programmet kan inte startas: %1</translation>
    </message>
    <message>
        <source>the program ended by itself</source>
        <translation>programmet avslutade sig självt</translation>
    </message>
    <message>
        <source>the program failed: %1</source>
        <translation>programmet misslyckades: %1</translation>
    </message>
    <message>
        <source>the video was cancelled</source>
        <translation>filmen avbröts</translation>
    </message>
    <message>
        <source>Videos are made by ffmpeg: install it, or render pictures</source>
        <translation>Filmer görs av ffmpeg: installera det, eller rendera bilder</translation>
    </message>
    <message>
        <source>no air carries this smoke</source>
        <translation>ingen luft bär den här röken</translation>
    </message>
    <message>
        <source>Switch it on with air.enabled</source>
        <translation>Slå på den med air.enabled</translation>
    </message>
    <message>
        <source>a volume of %1 cells</source>
        <translation>en volym på %1 celler</translation>
    </message>
    <message>
        <source>Use %1 to %2 cells along the longest edge</source>
        <translation>Använd %1 till %2 celler längs den längsta kanten</translation>
    </message>
    <message>
        <source>Choose a PNG or EXR that Fumage has written, or the preset&apos;s own file</source>
        <translation>Välj en PNG eller EXR som Fumage har skrivit, eller förinställningens egen fil</translation>
    </message>
    <message>
        <source>no pass is asked for</source>
        <translation>inget pass är valt</translation>
    </message>
    <message>
        <source>Choose one, or a packed picture</source>
        <translation>Välj ett, eller en packad bild</translation>
    </message>
    <message>
        <source>there is no channel %1</source>
        <translation>det finns ingen kanal %1</translation>
    </message>
    <message>
        <source>a packed picture cannot be named %1</source>
        <translation>en packad bild kan inte heta %1</translation>
    </message>
    <message>
        <source>Use up to %1 letters, digits, - and _</source>
        <translation>Använd högst %1 bokstäver, siffror, - och _</translation>
    </message>
    <message>
        <source>Choose another name: this is the name of a pass</source>
        <translation>Välj ett annat namn: detta är namnet på ett pass</translation>
    </message>
    <message>
        <source>the packed picture %1 is not understood</source>
        <translation>den packade bilden %1 går inte att förstå</translation>
    </message>
    <message>
        <source>Write masks=shadow,temperature,alpha, and @1/2 to @1/%1 after it for a smaller one</source>
        <translation>Skriv masks=shadow,temperature,alpha, och @1/2 till @1/%1 efter det för en mindre</translation>
    </message>
    <message>
        <source>the packed picture %1 has %2 channels</source>
        <translation>den packade bilden %1 har %2 kanaler</translation>
    </message>
    <message>
        <source>there are %1 packed pictures</source>
        <translation>det är %1 packade bilder</translation>
    </message>
    <message>
        <source>Use up to %1</source>
        <translation>Använd högst %1</translation>
    </message>
    <message>
        <source>two packed pictures are named %1</source>
        <translation>två packade bilder heter %1</translation>
    </message>
    <message>
        <source>cells of %1 x %2 pixels cannot be divided by %3, as %4 asks for</source>
        <translation>celler på %1 x %2 pixlar kan inte delas med %3, som %4 begär</translation>
    </message>
    <message>
        <source>Choose another size of a cell, or another part</source>
        <translation>Välj en annan storlek på cellen, eller en annan del</translation>
    </message>
    <message>
        <source>%1 x %2 cells fill no sheet whose sides are powers of two</source>
        <translation>%1 x %2 celler fyller inget ark vars sidor är tvåpotenser</translation>
    </message>
    <message>
        <source>Choose columns and rows from 1, 2, 4, 8, 16, 32 and 64</source>
        <translation>Välj kolumner och rader bland 1, 2, 4, 8, 16, 32 och 64</translation>
    </message>
    <message>
        <source>the points %1 do not lie between 0 and 1, from left to right</source>
        <translation>punkterna %1 ligger inte mellan 0 och 1, från vänster till höger</translation>
    </message>
    <message>
        <source>Write [[0, 0], [0.3, 0.6], [1, 1]]</source>
        <translation>Skriv [[0, 0], [0.3, 0.6], [1, 1]]</translation>
    </message>
    <message>
        <source>a loop is not trimmed: without its empty frames it would no longer close</source>
        <translation>en slinga beskärs inte: utan sina tomma bildrutor skulle den inte längre gå ihop</translation>
    </message>
    <message>
        <source>Switch the loop off, or the trimming</source>
        <translation>Stäng av slingan, eller beskärningen</translation>
    </message>
    <message>
        <source>Use one to four: red, green, blue and alpha</source>
        <translation>Använd en till fyra: röd, grön, blå och alfa</translation>
    </message>
    <message>
        <source>no sheet fits into %1 bytes, or the frames fill none</source>
        <translation>inget ark ryms i %1 byte, eller så fyller bildrutorna inget</translation>
    </message>
    <message>
        <source>Allow more memory, fewer passes or more frames</source>
        <translation>Tillåt mer minne, färre pass eller fler bildrutor</translation>
    </message>
    <message>
        <source>%1 has no way to write %2 in the names of files</source>
        <translation>%1 kan inte skriva %2 i filnamn</translation>
    </message>
    <message>
        <source>Choose another name or folder</source>
        <translation>Välj ett annat namn eller en annan mapp</translation>
    </message>
    <message>
        <source>only the colour can be joined of frames</source>
        <translation>bara färgen kan sättas ihop av bildrutor</translation>
    </message>
    <message>
        <source>Render a flipbook for its other passes</source>
        <translation>Rendera en flipbook för dess övriga pass</translation>
    </message>
    <message>
        <source>this is no picture of %1 x %2 pixels with colour and alpha</source>
        <translation>det här är ingen bild på %1 x %2 pixlar med färg och alfa</translation>
    </message>
    <message>
        <source>Render the frames anew, as EXR and in the preset&apos;s size</source>
        <translation>Rendera bildrutorna på nytt, som EXR och i förinställningens storlek</translation>
    </message>
    <message>
        <source>%1 is missing in the manifest, or of another type</source>
        <translation>%1 saknas i manifestet eller är av en annan typ</translation>
    </message>
    <message>
        <source>this is not a manifest</source>
        <translation>det här är inget manifest</translation>
    </message>
    <message>
        <source>Manifests are written by --manifest</source>
        <translation>Manifest skrivs av --manifest</translation>
    </message>
    <message>
        <source>the manifest has another version than the %1 that this program reads</source>
        <translation>manifestet har en annan version än den %1 som det här programmet läser</translation>
    </message>
    <message>
        <source>Check it with the Fumage that wrote it</source>
        <translation>Kontrollera det med den Fumage som skrev det</translation>
    </message>
    <message>
        <source>the manifest names %1, which lies outside of its folder</source>
        <translation>manifestet nämner %1, som ligger utanför dess mapp</translation>
    </message>
    <message>
        <source>Do not trust it, and have it written anew</source>
        <translation>Lita inte på det, och låt skriva det på nytt</translation>
    </message>
    <message>
        <source>the manifest has %1 for a hash</source>
        <translation>manifestet har %1 som hashvärde</translation>
    </message>
    <message>
        <source>the manifest has a frame that is no number from 0 to %1</source>
        <translation>manifestet har en bildruta som inte är ett tal från 0 till %1</translation>
    </message>
    <message>
        <source>the folder cannot be read: %1</source>
        <translation>mappen kan inte läsas: %1</translation>
    </message>
    <message>
        <source>%1 does not lie in the folder of its manifest</source>
        <translation>%1 ligger inte i manifestets mapp</translation>
    </message>
    <message>
        <source>Name one in the folder of the pictures, or above it</source>
        <translation>Ange ett i bildernas mapp, eller ovanför den</translation>
    </message>
    <message>
        <source>what this manifest is of cannot be rendered again</source>
        <translation>det som manifestet beskriver kan inte renderas på nytt</translation>
    </message>
    <message>
        <source>interrupted</source>
        <translation>avbrutet</translation>
    </message>
    <message>
        <source>there is no manifest in this folder</source>
        <translation>det finns inget manifest i den här mappen</translation>
    </message>
    <message>
        <source>Write pictures with --manifest</source>
        <translation>Skriv bilder med --manifest</translation>
    </message>
    <message>
        <source>the manifests name none of the frames %1 to %2</source>
        <translation>manifesten nämner ingen av bildrutorna %1 till %2</translation>
    </message>
    <message>
        <source>a channel of the picture has fewer numbers than there are pixels</source>
        <translation>en kanal i bilden har färre tal än det finns pixlar</translation>
    </message>
    <message>
        <source>this is neither a PNG nor a TGA</source>
        <translation>det här är varken en PNG eller en TGA</translation>
    </message>
    <message>
        <source>it is no TGA that Fumage has written, or not whole</source>
        <translation>det är ingen TGA som Fumage har skrivit, eller inte hel</translation>
    </message>
    <message>
        <source>expected a text in quotes</source>
        <translation>en text inom citattecken väntades</translation>
    </message>
    <message>
        <source>a text of %1 bytes</source>
        <translation>en text på %1 byte</translation>
    </message>
    <message>
        <source>Write at most %1</source>
        <translation>Skriv högst %1</translation>
    </message>
    <message>
        <source>there is a zero byte in the text</source>
        <translation>det finns en nollbyte i texten</translation>
    </message>
    <message>
        <source>expected true or false</source>
        <translation>true eller false väntades</translation>
    </message>
    <message>
        <source>expected a whole number from %1 to %2</source>
        <translation>ett heltal från %1 till %2 väntades</translation>
    </message>
    <message>
        <source>%1 is not known here</source>
        <translation>%1 är inte känt här</translation>
    </message>
    <message>
        <source>Choose from %1</source>
        <translation>Välj bland %1</translation>
    </message>
    <message>
        <source>expected a list of up to %1 texts such as &quot;masks=shadow,alpha&quot;</source>
        <translation>en lista med högst %1 texter som &quot;masks=shadow,alpha&quot; väntades</translation>
    </message>
    <message>
        <source>a list of jobs of %1 bytes</source>
        <translation>en jobblista på %1 byte</translation>
    </message>
    <message>
        <source>Lists have at most %1</source>
        <translation>Listor har högst %1</translation>
    </message>
    <message>
        <source>this JSON is not a list of Fumage&apos;s jobs</source>
        <translation>denna JSON är ingen lista med jobb för Fumage</translation>
    </message>
    <message>
        <source>A list begins with &quot;format&quot;: &quot;fumage-jobs&quot;</source>
        <translation>En lista börjar med &quot;format&quot;: &quot;fumage-jobs&quot;</translation>
    </message>
    <message>
        <source>the version of the list is missing, or not one up to %1, which this program reads</source>
        <translation>listans version saknas, eller är inte en av dem till och med %1 som programmet läser</translation>
    </message>
    <message>
        <source>%1: expected a list in brackets [ ]</source>
        <translation>%1: en lista inom hakparenteser [ ] väntades</translation>
    </message>
    <message>
        <source>a list of %1 jobs</source>
        <translation>en lista med %1 jobb</translation>
    </message>
    <message>
        <source>a job is an object in braces { }</source>
        <translation>ett jobb är ett objekt inom klamrar { }</translation>
    </message>
    <message>
        <source>the job %1 names no file that it writes</source>
        <translation>jobbet %1 anger ingen fil som det skriver</translation>
    </message>
    <message>
        <source>Write &quot;output&quot;: &quot;smoke.png&quot;</source>
        <translation>Skriv &quot;output&quot;: &quot;smoke.png&quot;</translation>
    </message>
    <message>
        <source>a job has no %1</source>
        <translation>ett jobb har inget %1</translation>
    </message>
    <message>
        <source>the job %1 has no preset</source>
        <translation>jobbet %1 har ingen förinställning</translation>
    </message>
    <message>
        <source>Write it as &quot;preset&quot;, whole or as its name</source>
        <translation>Skriv den som &quot;preset&quot;, hel eller som sitt namn</translation>
    </message>
    <message>
        <source>the jobs write more than %1 files</source>
        <translation>jobben skriver mer än %1 filer</translation>
    </message>
    <message>
        <source>Make two lists of them</source>
        <translation>Gör två listor av dem</translation>
    </message>
    <message>
        <source>%1 would write over a file of %2</source>
        <translation>%1 skulle skriva över en fil som hör till %2</translation>
    </message>
    <message>
        <source>%1 would overwrite the preset that %2 is made of</source>
        <translation>%1 skulle skriva över förinställningen som %2 görs av</translation>
    </message>
    <message>
        <source>Write colour,six-way,motion</source>
        <translation>Skriv colour,six-way,motion</translation>
    </message>
    <message>
        <source>there is no pass %1</source>
        <translation>det finns inget pass %1</translation>
    </message>
    <message>
        <source>%1 exports are waiting already</source>
        <translation>%1 exporter väntar redan</translation>
    </message>
    <message>
        <source>Wait until some are done, or remove some</source>
        <translation>Vänta tills några är klara, eller ta bort några</translation>
    </message>
    <message>
        <source>the emitter&apos;s place or velocity is no number</source>
        <translation>emitterns plats eller hastighet är inget tal</translation>
    </message>
    <message>
        <source>Pass finite numbers</source>
        <translation>Ange ändliga tal</translation>
    </message>
    <message>
        <source>the emitter&apos;s normal has no direction</source>
        <translation>emitterns normal har ingen riktning</translation>
    </message>
    <message>
        <source>Pass a normal that is not zero</source>
        <translation>Ange en normal som inte är noll</translation>
    </message>
    <message>
        <source>%1 particles are not possible</source>
        <translation>%1 partiklar är inte möjligt</translation>
    </message>
    <message>
        <source>Ask for 1 to %1, or 0 for as many as the effect has</source>
        <translation>Begär 1 till %1, eller 0 för så många som effekten har</translation>
    </message>
    <message>
        <source>%1 steps a second are not possible</source>
        <translation>%1 steg i sekunden är inte möjligt</translation>
    </message>
    <message>
        <source>Ask for 1 to %1, or 0 for those of the effect</source>
        <translation>Begär 1 till %1, eller 0 för effektens egna</translation>
    </message>
    <message>
        <source>a budget below 0 or less than one step at once is not possible</source>
        <translation>en budget under 0 eller färre än ett steg åt gången är inte möjligt</translation>
    </message>
    <message>
        <source>Ask for 0 ms or more, and for 1 step or more</source>
        <translation>Begär 0 ms eller mer, och 1 steg eller fler</translation>
    </message>
    <message>
        <source>time that goes back, or is no number, is not possible</source>
        <translation>tid som går bakåt, eller inte är något tal, är inte möjligt</translation>
    </message>
    <message>
        <source>Pass the seconds since the last step, 0 or more</source>
        <translation>Ange sekunderna sedan förra steget, 0 eller mer</translation>
    </message>
    <message>
        <source>Only frames and flipbooks can; of others the files are checked</source>
        <translation>Det kan bara bildrutor och flipbookar; av annat kontrolleras filerna</translation>
    </message>
    <message>
        <source>Choose some that have been rendered, as pictures or in a flipbook</source>
        <translation>Välj några som har renderats, som bilder eller i en flipbook</translation>
    </message>
    <message>
        <source>another program is using it</source>
        <translation>ett annat program använder den</translation>
    </message>
    <message>
        <source>Close it there, or choose another name</source>
        <translation>Stäng den där, eller välj ett annat namn</translation>
    </message>
    <message>
        <source>this is not written as a stream</source>
        <translation>detta skrivs inte som en ström</translation>
    </message>
    <message>
        <source>Choose more frames or fewer columns and rows, such as %1x%2</source>
        <translation>Välj fler bildrutor eller färre kolumner och rader, till exempel %1x%2</translation>
    </message>
    <message>
        <source>the frame rate %1 is not understood</source>
        <translation>bildfrekvensen %1 förstås inte</translation>
    </message>
    <message>
        <source>Write 24, 23.976 or 24000/1001, from 1 to %1 frames a second</source>
        <translation>Skriv 24, 23.976 eller 24000/1001, från 1 till %1 bildrutor per sekund</translation>
    </message>
    <message>
        <source>expected a number from %1 to %2</source>
        <translation>ett tal från %1 till %2 väntades</translation>
    </message>
    <message>
        <source>frames %1 are no whole turn of the loop of %2 frames, so they are played once: frames %3 close it</source>
        <translation>bildrutorna %1 är inget helt varv av slingan på %2 bildrutor, så de spelas en gång: bildrutorna %3 sluter den</translation>
    </message>
    <message>
        <source>frames %1 are no whole turn of the loop of %2 frames, so they are played once</source>
        <translation>bildrutorna %1 är inget helt varv av slingan på %2 bildrutor, så de spelas en gång</translation>
    </message>
    <message>
        <source>the curve of the frames does not end where it begins, so they are played once</source>
        <translation>kurvan för bildrutorna slutar inte där den börjar, så de spelas en gång</translation>
    </message>
    <message>
        <source>one frame of %1 is in the GIF: more than 50 pictures a second play slowly in browsers</source>
        <translation>en bildruta av %1 är med i GIF-filen: fler än 50 bilder per sekund spelas långsamt i webbläsare</translation>
    </message>
    <message>
        <source>H.264 has even edges: the video is %1 x %2 pixels, the last column or row twice</source>
        <translation>H.264 har jämna sidor: videon är %1 x %2 bildpunkter, med sista kolumnen eller raden två gånger</translation>
    </message>
    <message>
        <source>voxels of %1 m</source>
        <translation>voxlar på %1 m</translation>
    </message>
    <message>
        <source>Use %1 to %2 m</source>
        <translation>Använd %1 till %2 m</translation>
    </message>
    <message>
        <source>the box around the smoke of frame %1 has more than %2 voxels of %3 m</source>
        <translation>lådan runt röken i bildruta %1 har fler än %2 voxlar på %3 m</translation>
    </message>
    <message>
        <source>Choose larger voxels</source>
        <translation>Välj större voxlar</translation>
    </message>
    <message>
        <source>Please report it, with the preset that you had</source>
        <translation>Rapportera det gärna, tillsammans med förinställningen du hade</translation>
    </message>
    <message>
        <source>something failed inside Fumage: %1</source>
        <translation>något misslyckades inuti Fumage: %1</translation>
    </message>
    <message>
        <source>something failed inside Fumage</source>
        <translation>något misslyckades inuti Fumage</translation>
    </message>
    <message>
        <source>a task of %1 has at most %2 frames</source>
        <translation>en uppgift för %1 har högst %2 bildrutor</translation>
    </message>
    <message>
        <source>Choose fewer frames a task</source>
        <translation>Välj färre bildrutor per uppgift</translation>
    </message>
    <message>
        <source>%1 plays this sheet in %2 s instead of %3 s, for it counts time in whole steps: %4 frames in its cells, or %5 frames a second, would keep the speed</source>
        <translation>%1 spelar upp arket på %2 s i stället för %3 s, eftersom det räknar tiden i hela steg: %4 bildrutor i cellerna, eller %5 bildrutor per sekund, skulle behålla hastigheten</translation>
    </message>
    <message>
        <source>%1 plays this sheet in %2 s instead of %3 s, for it counts time in whole steps: %4 frames a second would keep the speed</source>
        <translation>%1 spelar upp arket på %2 s i stället för %3 s, eftersom det räknar tiden i hela steg: %4 bildrutor per sekund skulle behålla hastigheten</translation>
    </message>
    <message>
        <source>Unreal&apos;s FlipBook_MotionVectors finds its cells only where there are as many columns as rows: use %1 x %1 cells, or a material of your own</source>
        <translation>Unreals FlipBook_MotionVectors hittar sina celler bara där det finns lika många kolumner som rader: använd %1 × %1 celler, eller ett eget material</translation>
    </message>
    <message>
        <source>control characters</source>
        <translation>styrtecken</translation>
    </message>
    <message>
        <source>Choose another name or another disk</source>
        <translation>Välj ett annat namn eller en annan disk</translation>
    </message>
    <message>
        <source>the system has no more files, processes or memory to give: %1</source>
        <translation>systemet har inte fler filer, processer eller mer minne att ge: %1</translation>
    </message>
    <message>
        <source>End other programs, raise its limits (ulimit -n, -u, -v), or try again later</source>
        <translation>Avsluta andra program, höj dess gränser (ulimit -n, -u, -v) eller försök igen senare</translation>
    </message>
    <message>
        <source>the system gives no more threads, files or memory: %1</source>
        <translation>systemet ger inte fler trådar, filer eller mer minne: %1</translation>
    </message>
    <message>
        <source>End other programs, raise its limits (ulimit -u, -n, -v), or use --threads 1</source>
        <translation>Avsluta andra program, höj dess gränser (ulimit -u, -n, -v) eller använd --threads 1</translation>
    </message>
    <message>
        <source>the system refuses what is needed: %1</source>
        <translation>systemet vägrar det som behövs: %1</translation>
    </message>
    <message>
        <source>Use another folder or another machine</source>
        <translation>Använd en annan mapp eller en annan dator</translation>
    </message>
    <message>
        <source>the program has written no video</source>
        <translation>programmet har inte skrivit någon video</translation>
    </message>
    <message>
        <source>Let FUMAGE_FFMPEG name an ffmpeg, or leave it out</source>
        <translation>Låt FUMAGE_FFMPEG ange ett ffmpeg, eller utelämna den</translation>
    </message>
    <message>
        <source>the text is %1</source>
        <translation>texten är %1</translation>
    </message>
    <message>
        <source>the smoke has left all bounds: a particle is nowhere</source>
        <translation>röken har lämnat alla gränser: en partikel är ingenstans</translation>
    </message>
    <message>
        <source>the box of the air has no finite size</source>
        <translation>luftens låda har ingen ändlig storlek</translation>
    </message>
    <message>
        <source>Turn air.fit off and give air.size, or make the emitter smaller or slower</source>
        <translation>Stäng av air.fit och ange air.size, eller gör källan mindre eller långsammare</translation>
    </message>
    <message>
        <source>the air of a loop of %1 frames is baked whole before its first picture, which would take very long</source>
        <translation>luften i en slinga på %1 bildrutor bakas helt före den första bilden, vilket skulle ta mycket lång tid</translation>
    </message>
    <message>
        <source>Shorten timeline.length, lower air.resolution, or turn timeline.loop off</source>
        <translation>Förkorta timeline.length, sänk air.resolution eller stäng av timeline.loop</translation>
    </message>
    <message>
        <source>the air has to be moved on for a whole life of the smoke before its first picture, which would take very long</source>
        <translation>luften måste föras framåt en hel livstid av röken före den första bilden, vilket skulle ta mycket lång tid</translation>
    </message>
    <message>
        <source>Turn timeline.prewarm off, raise life.fade_rate, or lower air.resolution</source>
        <translation>Stäng av timeline.prewarm, höj life.fade_rate eller sänk air.resolution</translation>
    </message>
    <message>
        <source>nobody says which folder ~ is</source>
        <translation>ingen säger vilken mapp ~ är</translation>
    </message>
    <message>
        <source>Write the whole path</source>
        <translation>Skriv hela sökvägen</translation>
    </message>
    <message>
        <source>this name is not UTF-8, and has to be written down in a file beside it</source>
        <translation>det här namnet är inte UTF-8 och måste skrivas ned i en fil bredvid</translation>
    </message>
    <message>
        <source>the preset that this picture carries is damaged, or longer than the %1 bytes that are read</source>
        <translation>förinställningen som den här bilden bär är skadad, eller längre än de %1 byte som läses</translation>
    </message>
    <message>
        <source>Choose another picture, or the preset&apos;s own file</source>
        <translation>Välj en annan bild, eller förinställningens egen fil</translation>
    </message>
    <message>
        <source>this is neither a PNG nor a TGA nor an EXR</source>
        <translation>det här är varken PNG, TGA eller EXR</translation>
    </message>
    <message>
        <source>the preset that this picture carries cannot be read: %1</source>
        <translation>förinställningen som den här bilden bär kan inte läsas: %1</translation>
    </message>
    <message>
        <source>Choose from alpha, density, depth, temperature, shadow, colour.r, six-way-a.r, six-way-b.r, motion.r, normal.r, emission.r, albedo.r, their .g, .b and .a, 0 and 1</source>
        <translation>Välj bland alpha, density, depth, temperature, shadow, colour.r, six-way-a.r, six-way-b.r, motion.r, normal.r, emission.r, albedo.r, deras .g, .b och .a, 0 och 1</translation>
    </message>
    <message>
        <source>Write key=value, for example wind.strength=1.5</source>
        <translation>Skriv nyckel=värde, till exempel wind.strength=1.5</translation>
    </message>
    <message>
        <source>Lower forces and speeds, such as motion.buoyancy, source.expansion or turbulence.strength</source>
        <translation>Sänk krafter och hastigheter, såsom motion.buoyancy, source.expansion eller turbulence.strength</translation>
    </message>
    <message>
        <source>%1 is fixed while the simulation runs</source>
        <translation>%1 är fast så länge simuleringen pågår</translation>
    </message>
    <message>
        <source>Keep it, or start a new simulation</source>
        <translation>Behåll det, eller starta en ny simulering</translation>
    </message>
    <message>
        <source>the eye&apos;s place is no number</source>
        <translation>ögats plats är inget tal</translation>
    </message>
    <message>
        <source>Pass finite numbers, or no eye</source>
        <translation>Ge ändliga tal, eller inget öga</translation>
    </message>
    <message>
        <source>the preset has %1 layers, from 1 to %2 are possible</source>
        <translation>presetet har %1 lager, 1 till %2 är möjliga</translation>
    </message>
    <message>
        <source>%1: expected %2</source>
        <translation>%1: väntade %2</translation>
    </message>
    <message>
        <source>a text in quotes</source>
        <translation>en text inom citattecken</translation>
    </message>
    <message>
        <source>a layer&apos;s name of %1 bytes</source>
        <translation>ett lagernamn på %1 byte</translation>
    </message>
    <message>
        <source>Names have at most %1</source>
        <translation>Namn har högst %1</translation>
    </message>
    <message>
        <source>a colour: %1</source>
        <translation>en färg: %1</translation>
    </message>
    <message>
        <source>there is no one layer %1</source>
        <translation>det finns inget enda lager %1</translation>
    </message>
    <message>
        <source>Name one of %1, or give its number from 1 to %2</source>
        <translation>Namnge ett av %1, eller ange dess nummer från 1 till %2</translation>
    </message>
    <message>
        <source>layers that are written as %1 have no other passes than %2</source>
        <translation>lager som skrivs som %1 har inga andra pass än %2</translation>
    </message>
    <message>
        <source>Choose these passes, or layers alone</source>
        <translation>Välj dessa pass, eller lager var för sig (alone)</translation>
    </message>
    <message>
        <source>what is written for %1 plays one sheet</source>
        <translation>det som skrivs för %1 spelar ett ark</translation>
    </message>
    <message>
        <source>Choose another engine or none, or layers together or alone</source>
        <translation>Välj en annan motor eller ingen, eller lager tillsammans eller var för sig</translation>
    </message>
    <message>
        <source>there is no one layer %1 to be born on</source>
        <translation>det finns inget enda lager %1 att födas på</translation>
    </message>
    <message>
        <source>Name a layer that no other shares its name with</source>
        <translation>Ange ett lager vars namn inget annat har</translation>
    </message>
    <message>
        <source>layer %1 would be born on itself, by way of %2</source>
        <translation>lagret %1 skulle födas på sig självt, via %2</translation>
    </message>
    <message>
        <source>Let one layer of the ring be born on its emitter</source>
        <translation>Låt ett lager i ringen födas på sin utsändare</translation>
    </message>
    <message>
        <source>there is no layer number %1</source>
        <translation>det finns inget lager nummer %1</translation>
    </message>
    <message>
        <source>Give a number from 0 to %1</source>
        <translation>Ange ett tal från 0 till %1</translation>
    </message>
    <message>
        <source>this is not a PNG</source>
        <translation>detta är ingen PNG</translation>
    </message>
    <message>
        <source>a picture of %1 bytes</source>
        <translation>en bild på %1 byte</translation>
    </message>
    <message>
        <source>Choose a PNG of at most %1 pixels an edge and %2 bytes</source>
        <translation>Välj en PNG med högst %1 pixlar per kant och %2 byte</translation>
    </message>
    <message>
        <source>a PNG in base64</source>
        <translation>en PNG i base64</translation>
    </message>
    <message>
        <source>this parameter cannot change over time</source>
        <translation>denna parameter kan inte ändras över tid</translation>
    </message>
    <message>
        <source>Take its key frames out; parameters.md says which can</source>
        <translation>Ta bort dess nyckelbildrutor; parameters.md säger vilka som kan</translation>
    </message>
    <message>
        <source>%1 key frames, from 1 to %2 are possible</source>
        <translation>%1 nyckelbildrutor, 1 till %2 är möjliga</translation>
    </message>
    <message>
        <source>a key frame has a value of another kind</source>
        <translation>en nyckelbildruta har ett värde av annat slag</translation>
    </message>
    <message>
        <source>a key frame has a time, value or slope that is no number</source>
        <translation>en nyckelbildruta har en tid, ett värde eller en lutning som inte är ett tal</translation>
    </message>
    <message>
        <source>a key frame lies %1 s away</source>
        <translation>en nyckelbildruta ligger %1 s bort</translation>
    </message>
    <message>
        <source>Key frames lie at most %1 s away</source>
        <translation>Nyckelbildrutor ligger högst %1 s bort</translation>
    </message>
    <message>
        <source>the key frame at %1 s comes after one at %2 s</source>
        <translation>nyckelbildrutan vid %1 s kommer efter en vid %2 s</translation>
    </message>
    <message>
        <source>Key frames stand in the order of their times, no two at the same</source>
        <translation>Nyckelbildrutor står i tidsordning, inga två vid samma tid</translation>
    </message>
    <message>
        <source>a picture of %1 letters</source>
        <translation>en bild på %1 tecken</translation>
    </message>
    <message>
        <source>the box around the smoke of frame %1 has %2 voxels, too many for %3 layers</source>
        <translation>lådan kring röken i bildruta %1 har %2 voxlar, för många för %3 lager</translation>
    </message>
    <message>
        <source>Choose larger voxels, or the density of all layers together</source>
        <translation>Välj större voxlar, eller tätheten för alla lager tillsammans</translation>
    </message>
    <message>
        <source>the masks of layers are channels of EXR</source>
        <translation>lagrens masker är kanaler i EXR</translation>
    </message>
    <message>
        <source>Choose EXR, or write alpha of layers as contribution</source>
        <translation>Välj EXR, eller skriv lagrens alfa som bidrag</translation>
    </message>
    <message>
        <source>masks of %1 layers for %2 pixels</source>
        <translation>masker för %1 lager med %2 bildpunkter</translation>
    </message>
    <message>
        <source>Choose a smaller picture, or mute layers</source>
        <translation>Välj en mindre bild, eller dölj lager</translation>
    </message>
    <message>
        <source>%1 does not end as it begins, so the loop jumps there</source>
        <translation>%1 slutar inte som den börjar, så slingan hoppar där</translation>
    </message>
    <message>
        <source>%1 has key frames after the end of the timeline</source>
        <translation>%1 har nyckelbildrutor efter tidslinjens slut</translation>
    </message>
    <message>
        <source>with its pictures the preset is longer than the %1 bytes that a file can carry: save it beside</source>
        <translation>med sina bilder är förinställningen längre än de %1 byte som en fil kan bära: spara den bredvid</translation>
    </message>
    <message>
        <source>layers that are written as %1 have no masks of layers</source>
        <translation>lager som skrivs som %1 har inga lagermasker</translation>
    </message>
    <message>
        <source>Write layers together, or the alpha of contributions</source>
        <translation>Skriv lagren tillsammans, eller bidragens alfa</translation>
    </message>
    <message>
        <source>the sheet of layer %1 is missing</source>
        <translation>arket för lager %1 saknas</translation>
    </message>
    <message>
        <source>Keep the sheets of all layers in one folder, or export them again</source>
        <translation>Håll arken för alla lager i en mapp, eller exportera dem igen</translation>
    </message>
    <message>
        <source>the sheet of layer %1 has %2 x %3 pixels, and not %4 x %5</source>
        <translation>arket för lager %1 har %2 x %3 bildpunkter, och inte %4 x %5</translation>
    </message>
    <message>
        <source>Export the sheets of all layers together</source>
        <translation>Exportera arken för alla lager tillsammans</translation>
    </message>
    <message>
        <source>this manifest is of no sheets of layers</source>
        <translation>detta manifest gäller inga lagerark</translation>
    </message>
    <message>
        <source>Name one that was written with --layers-as, or a preset</source>
        <translation>Ange ett som skrevs med --layers-as, eller en förinställning</translation>
    </message>
    <message>
        <source>the name of this sheet does not say which layer it is of</source>
        <translation>arkets namn säger inte vilket lager det gäller</translation>
    </message>
    <message>
        <source>Name it as it was exported, such as fire_flames.png, or its manifest</source>
        <translation>Ange det som det exporterades, till exempel fire_flames.png, eller dess manifest</translation>
    </message>
    <message>
        <source>these sheets have no colour to be put together</source>
        <translation>dessa ark har ingen färg att sätta ihop</translation>
    </message>
    <message>
        <source>Export them with colour among the passes</source>
        <translation>Exportera dem med färg bland passen</translation>
    </message>
    <message>
        <source>layers, their names, what is muted and what is born on what are fixed while the simulation runs</source>
        <translation>lager, deras namn, vad som är dolt och vad som föds på vad är fast medan simuleringen går</translation>
    </message>
    <message>
        <source>Keep them, or start a new simulation; a layer whose share is 0 goes out</source>
        <translation>Behåll dem, eller starta en ny simulering; ett lager vars andel är 0 slocknar</translation>
    </message>
    <message>
        <source>%1 particles are too few for %2 layers</source>
        <translation>%1 partiklar är för få för %2 lager</translation>
    </message>
    <message>
        <source>Ask for %1 or more</source>
        <translation>Begär %1 eller fler</translation>
    </message>
    <message>
        <source>layer %1: %2</source>
        <translation>lager %1: %2</translation>
    </message>
    <message>
        <source>%1: expected one of %2</source>
        <translation>%1: väntade ett av %2</translation>
    </message>
    <message>
        <source>a track has %1, %2, %3 and %4, and no %5</source>
        <translation>ett spår har %1, %2, %3 och %4, och inget %5</translation>
    </message>
    <message>
        <source>a key frame is a list of its seconds, its value and its ease</source>
        <translation>en nyckelbildruta är en lista av sekunder, värde och övergång</translation>
    </message>
    <message>
        <source>expected one of %1</source>
        <translation>väntade ett av %1</translation>
    </message>
    <message>
        <source>a slope is a number, or a list of three</source>
        <translation>en lutning är ett tal, eller en lista av tre</translation>
    </message>
    <message>
        <source>a track is an object with the %1 of its parameter</source>
        <translation>ett spår är ett objekt med sin parameters %1</translation>
    </message>
    <message>
        <source>the track of %1 is kept but has no effect</source>
        <translation>spåret för %1 behålls men har ingen verkan</translation>
    </message>
    <message>
        <source>a second track of %1</source>
        <translation>ett andra spår för %1</translation>
    </message>
    <message>
        <source>key frames of %1 were out of range</source>
        <translation>nyckelbildrutor för %1 låg utanför området</translation>
    </message>
    <message>
        <source>Choose from colour, alpha, density, six-way, motion, normal, depth, emission, albedo, temperature, shadow, layer-masks and all</source>
        <translation>Välj bland colour, alpha, density, six-way, motion, normal, depth, emission, albedo, temperature, shadow, layer-masks och all</translation>
    </message>
    <message>
        <source>invalid key frame %1</source>
        <translation>ogiltig nyckelbildruta %1</translation>
    </message>
    <message>
        <source>Write SECONDS:VALUE or SECONDS:VALUE:EASE, with %1 as ease</source>
        <translation>Skriv SEKUNDER:VÄRDE eller SEKUNDER:VÄRDE:ÖVERGÅNG, med %1 som övergång</translation>
    </message>
    <message>
        <source>%1: no %2</source>
        <translation>%1: inget %2</translation>
    </message>
    <message>
        <source>Use one of %1</source>
        <translation>Använd ett av %1</translation>
    </message>
    <message>
        <source>there is no marker number %1</source>
        <translation>det finns ingen markör nummer %1</translation>
    </message>
    <message>
        <source>%1 changes at once at a held key frame, so what it drives changes its pace with a jerk</source>
        <translation>%1 ändras på en gång vid en hållen nyckelbildruta, så det den driver byter takt med ett ryck</translation>
    </message>
    <message>
        <source>markers after the end of the timeline: %1</source>
        <translation>markörer efter tidslinjens slut: %1</translation>
    </message>
    <message>
        <source>markers outside of the frames of the sheet: %1</source>
        <translation>markörer utanför arkets bildrutor: %1</translation>
    </message>
    <message>
        <source>a marker is an object with a %1 in quotes and a %2 in seconds</source>
        <translation>en markör är ett objekt med ett %1 inom citattecken och ett %2 i sekunder</translation>
    </message>
    <message>
        <source>%1 markers, at most %2 are possible</source>
        <translation>%1 markörer, högst %2 är möjliga</translation>
    </message>
    <message>
        <source>the marker with the unknown member %1 is kept but has no effect</source>
        <translation>markören med den okända medlemmen %1 behålls men har ingen verkan</translation>
    </message>
    <message>
        <source>line %1</source>
        <translation>rad %1</translation>
    </message>
    <message>
        <source>%1 is no time</source>
        <translation>%1 är ingen tid</translation>
    </message>
    <message>
        <source>Write seconds, then the value, with commas between</source>
        <translation>Skriv sekunder och sedan värdet, med komma emellan</translation>
    </message>
    <message>
        <source>the name of a marker is not UTF-8</source>
        <translation>namnet på en markör är inte UTF-8</translation>
    </message>
    <message>
        <source>a marker&apos;s name of %1 bytes</source>
        <translation>ett markörnamn på %1 byte</translation>
    </message>
    <message>
        <source>the name of a marker is empty or has control characters: %1</source>
        <translation>namnet på en markör är tomt eller har styrtecken: %1</translation>
    </message>
    <message>
        <source>Name it with letters, digits, spaces and signs</source>
        <translation>Ge den ett namn av bokstäver, siffror, blanksteg och tecken</translation>
    </message>
    <message>
        <source>the time of a marker is no number</source>
        <translation>tiden för en markör är inget tal</translation>
    </message>
    <message>
        <source>a marker lies at %1 s</source>
        <translation>en markör ligger vid %1 s</translation>
    </message>
    <message>
        <source>Markers lie from 0 to %1 s</source>
        <translation>Markörer ligger från 0 till %1 s</translation>
    </message>
    <message>
        <source>the marker at %1 s comes after one at %2 s</source>
        <translation>markören vid %1 s kommer efter en vid %2 s</translation>
    </message>
    <message>
        <source>Markers stand in the order of their times</source>
        <translation>Markörer står i tidsordning</translation>
    </message>
    <message>
        <source>invalid marker %1</source>
        <translation>ogiltig markör %1</translation>
    </message>
    <message>
        <source>Write NAME=SECONDS, with ; between several times, or NAME= to take them out</source>
        <translation>Skriv NAMN=SEKUNDER, med ; mellan flera tider, eller NAMN= för att ta bort dem</translation>
    </message>
    <message>
        <source>%1 is no whole number from 1 to %2</source>
        <translation>%1 är inget heltal från 1 till %2</translation>
    </message>
    <message>
        <source>cells_per_second is no number above 0, %1 at most</source>
        <translation>cells_per_second är inget tal över 0, högst %1</translation>
    </message>
    <message>
        <source>a picture has no name of a file beside it</source>
        <translation>en bild har inget namn på en fil bredvid</translation>
    </message>
    <message>
        <source>Export the flipbook anew</source>
        <translation>Exportera flipbooken på nytt</translation>
    </message>
    <message>
        <source>the picture has another size than its description says</source>
        <translation>bilden har en annan storlek än beskrivningen anger</translation>
    </message>
    <message>
        <source>the sheet has %1 x %2 pixels, which is more than can be played here</source>
        <translation>arket har %1 x %2 pixlar, vilket är mer än vad som kan spelas här</translation>
    </message>
    <message>
        <source>the flipbook has no picture of its colours</source>
        <translation>flipbooken saknar bild av sina färger</translation>
    </message>
    <message>
        <source>the motion vectors have no scale</source>
        <translation>rörelsevektorerna saknar skala</translation>
    </message>
    <message>
        <source>this is no description of a flipbook</source>
        <translation>detta är ingen beskrivning av en flipbook</translation>
    </message>
    <message>
        <source>a free key frame has two slopes, a linear or held one may have that before it, and a smooth one has none</source>
        <translation>en fri nyckelbildruta har två lutningar, en linjär eller hållen kan ha den före sig, och en mjuk har ingen</translation>
    </message>
    <message>
        <source>layers are born on %1 particles of others in all, at most %2 are possible</source>
        <translation>lager föds på sammanlagt %1 partiklar hos andra, högst %2 är möjliga</translation>
    </message>
    <message>
        <source>Give fewer particles to the layers that others are born on</source>
        <translation>Ge färre partiklar åt de lager som andra föds på</translation>
    </message>
    <message>
        <source>there is no one layer %1, but %2</source>
        <translation>det finns inte ett lager %1, utan %2</translation>
    </message>
    <message>
        <source>Write the name as it is, or where they share it the number</source>
        <translation>Skriv namnet som det är, eller numret där de delar det</translation>
    </message>
    <message>
        <source>no layer is named</source>
        <translation>inget lager anges</translation>
    </message>
    <message>
        <source>Name layers, or leave the option out</source>
        <translation>Ange lager, eller utelämna alternativet</translation>
    </message>
</context>
<context>
    <name>fumage::ui::MockStage</name>
    <message>
        <source>The sheet as it plays in an engine</source>
        <translation>Arket som det spelas i en spelmotor</translation>
    </message>
</context>
<context>
    <name>fumage::ui::NoiseCanvas</name>
    <message>
        <source>Noise texture</source>
        <translation>Brustextur</translation>
    </message>
    <message>
        <source>Wheel: zoom. Left button: move the profile line. Middle button: move the picture. Double-click: whole tile.</source>
        <translation>Hjul: zooma. Vänster knapp: flytta profillinjen. Mittknapp: flytta bilden. Dubbelklick: hela rutan.</translation>
    </message>
</context>
<context>
    <name>fumage::ui::NoisePane</name>
    <message>
        <source>Channel</source>
        <translation>Kanal</translation>
    </message>
    <message>
        <source>Texture</source>
        <translation>Textur</translation>
    </message>
    <message>
        <source>Sum of octaves</source>
        <translation>Summa av oktaver</translation>
    </message>
    <message>
        <source>Alpha of a particle</source>
        <translation>En partikels alfa</translation>
    </message>
    <message>
        <source>What is shown: the grey values that particles read, the noise before sharpness, or what is left under the mask of a particle</source>
        <translation>Vad som visas: gråvärdena som partiklarna läser, bruset före skärpan, eller det som blir kvar under en partikels mask</translation>
    </message>
    <message>
        <source>Slice</source>
        <translation>Snitt</translation>
    </message>
    <message>
        <source>Which slice of the 3D noise; particles go through them as they age</source>
        <translation>Vilket snitt av 3D-bruset; partiklarna går igenom dem medan de åldras</translation>
    </message>
    <message>
        <source>Without smoothing and sharpness</source>
        <translation>Utan utjämning och skärpa</translation>
    </message>
    <message>
        <source>Three by three tiles, to judge the seams</source>
        <translation>Tre gånger tre rutor, för att bedöma fogarna</translation>
    </message>
    <message>
        <source>Profile along a line, with amplitude and wavelength</source>
        <translation>Profil längs en linje, med amplitud och våglängd</translation>
    </message>
    <message>
        <source>Go through the slices</source>
        <translation>Gå igenom snitten</translation>
    </message>
    <message>
        <source>Export the noise texture</source>
        <translation>Exportera brustexturen</translation>
    </message>
    <message>
        <source>Export the noise texture…</source>
        <translation>Exportera brustexturen…</translation>
    </message>
    <message>
        <source>%1 × %1 px   mean %2   deviation %3</source>
        <translation>%1 × %1 px   medel %2   avvikelse %3</translation>
    </message>
    <message>
        <source>There is not enough memory for this texture.</source>
        <translation>Minnet räcker inte till den här texturen.</translation>
    </message>
</context>
<context>
    <name>fumage::ui::NoisePlots</name>
    <message>
        <source>Profile and histogram of the noise</source>
        <translation>Brusets profil och histogram</translation>
    </message>
    <message>
        <source>amplitude %1</source>
        <translation>amplitud %1</translation>
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
        <translation>”%1” är inget tal.</translation>
    </message>
    <message>
        <source>“%1” is not a number in %2.</source>
        <translation>”%1” är inget tal i %2.</translation>
    </message>
    <message>
        <source>%1 is the largest.</source>
        <translation>%1 är det största.</translation>
    </message>
    <message>
        <source>%1 is the smallest.</source>
        <translation>%1 är det minsta.</translation>
    </message>
</context>
<context>
    <name>fumage::ui::PackRow</name>
    <message>
        <source>Name of the packed picture</source>
        <translation>Den packade bildens namn</translation>
    </message>
    <message>
        <source>Stands behind the name of the sheet</source>
        <translation>Står efter arkets namn</translation>
    </message>
    <message>
        <source>Size of the packed picture</source>
        <translation>Den packade bildens storlek</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Ta bort</translation>
    </message>
    <message>
        <source>Red</source>
        <translation>Röd</translation>
    </message>
    <message>
        <source>Green</source>
        <translation>Grön</translation>
    </message>
    <message>
        <source>Blue</source>
        <translation>Blå</translation>
    </message>
    <message>
        <source>Alpha</source>
        <translation>Alfa</translation>
    </message>
    <message>
        <source>Full size</source>
        <translation>Full storlek</translation>
    </message>
    <message>
        <source>Nothing</source>
        <translation>Ingenting</translation>
    </message>
</context>
<context>
    <name>fumage::ui::ParameterGroup</name>
    <message>
        <source>Paste into “%1”</source>
        <translation>Klistra in i ”%1”</translation>
    </message>
    <message>
        <source>Reset “%1”</source>
        <translation>Återställ ”%1”</translation>
    </message>
    <message>
        <source>Reset the group</source>
        <translation>Återställ gruppen</translation>
    </message>
    <message>
        <source>Copy the group</source>
        <translation>Kopiera gruppen</translation>
    </message>
    <message>
        <source>Paste into the group</source>
        <translation>Klistra in i gruppen</translation>
    </message>
    <message>
        <source>Expand all groups</source>
        <translation>Fäll ut alla grupper</translation>
    </message>
    <message>
        <source>Collapse all groups</source>
        <translation>Fäll ihop alla grupper</translation>
    </message>
</context>
<context>
    <name>fumage::ui::ParameterRow</name>
    <message>
        <source>Paste</source>
        <translation>Klistra in</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Återställ</translation>
    </message>
    <message>
        <source>Reset to the default</source>
        <translation>Återställ till standard</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopiera</translation>
    </message>
    <message>
        <source>Copy as --set</source>
        <translation>Kopiera som --set</translation>
    </message>
    <message>
        <source>Lock against randomising</source>
        <translation>Lås mot slumpen</translation>
    </message>
    <message>
        <source>Locked against randomising; press to unlock</source>
        <translation>Låst mot slumpning; tryck för att låsa upp</translation>
    </message>
    <message>
        <source>Set a key frame here</source>
        <translation>Sätt en nyckelbildruta här</translation>
    </message>
    <message>
        <source>Remove the key frame here</source>
        <translation>Ta bort nyckelbildrutan här</translation>
    </message>
    <message>
        <source>Remove all key frames</source>
        <translation>Ta bort alla nyckelbildrutor</translation>
    </message>
</context>
<context>
    <name>Parameters</name>
    <message>
        <source>Particles</source>
        <translation>Partiklar</translation>
    </message>
    <message>
        <source>How many particles are alive once the smoke is warm. Many small ones read as smoke, few large ones as sprites.</source>
        <translation>Hur många partiklar som lever när röken är varm. Många små ser ut som rök, få stora som lappar.</translation>
    </message>
    <message>
        <source>2012 model, table of results</source>
        <translation>2012 års modell, resultattabellen</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>Form</translation>
    </message>
    <message>
        <source>The surface or body on which particles are born.</source>
        <translation>Ytan eller kroppen där partiklar föds.</translation>
    </message>
    <message>
        <source>2012 model, eq. I (rectangle)</source>
        <translation>2012 års modell, ekv. I (rektangel)</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Radie</translation>
    </message>
    <message>
        <source>Radius of the disc or sphere.</source>
        <translation>Skivans eller klotets radie.</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Bredd</translation>
    </message>
    <message>
        <source>2012 model, eq. I</source>
        <translation>2012 års modell, ekv. I</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Djup</translation>
    </message>
    <message>
        <source>Normal</source>
        <translation>Normal</translation>
    </message>
    <message>
        <source>The direction N that the emitter faces and sends particles in.</source>
        <translation>Riktningen N som utsändaren vetter åt och sänder partiklar i.</translation>
    </message>
    <message>
        <source>2012 model, eq. I and II</source>
        <translation>2012 års modell, ekv. I och II</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Läge</translation>
    </message>
    <message>
        <source>Centre of the emitter.</source>
        <translation>Utsändarens mitt.</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Fart</translation>
    </message>
    <message>
        <source>Speed at birth along the normal.</source>
        <translation>Fart vid födseln längs normalen.</translation>
    </message>
    <message>
        <source>2012 model, eq. II (1 there)</source>
        <translation>2012 års modell, ekv. II (1 där)</translation>
    </message>
    <message>
        <source>Speed variation</source>
        <translation>Hastighetsslump</translation>
    </message>
    <message>
        <source>0: every particle leaves at the full speed. 1: each component of the velocity is multiplied by its own random number.</source>
        <translation>0: varje partikel lämnar med full fart. 1: varje komponent av hastigheten multipliceras med ett eget slumptal.</translation>
    </message>
    <message>
        <source>Cone angle</source>
        <translation>Spridning</translation>
    </message>
    <message>
        <source>Half angle of the cone in which particles leave, evenly over its directions; 180 is all around.</source>
        <translation>Halva vinkeln på konen som partiklarna lämnar i, jämnt över dess riktningar; 180 är åt alla håll.</translation>
    </message>
    <message>
        <source>Emission</source>
        <translation>Utsläpp</translation>
    </message>
    <message>
        <source>Continuous smoke, or one burst at the start of the timeline.</source>
        <translation>Ständig rök, eller en enda puff i tidslinjens början.</translation>
    </message>
    <message>
        <source>Burst duration</source>
        <translation>Puffens längd</translation>
    </message>
    <message>
        <source>The time in which a burst gives birth to all of its particles.</source>
        <translation>Tiden under vilken en puff föder alla sina partiklar.</translation>
    </message>
    <message>
        <source>Sub-frame emission</source>
        <translation>Födsel mellan steg</translation>
    </message>
    <message>
        <source>Spreads births over the time between two steps, so that fast smoke leaves in a stream and not in sheets.</source>
        <translation>Sprider födslarna över tiden mellan två steg, så att snabb rök lämnar i en ström och inte i skivor.</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Frö</translation>
    </message>
    <message>
        <source>Another seed gives another smoke of the same kind.</source>
        <translation>Ett annat frö ger en annan rök av samma slag.</translation>
    </message>
    <message>
        <source>Buoyancy</source>
        <translation>Lyftkraft</translation>
    </message>
    <message>
        <source>Upward acceleration of smoke that is as hot as at birth; it fades as the smoke cools.</source>
        <translation>Uppåtriktad acceleration hos rök som är lika het som vid födseln; den avtar när röken svalnar.</translation>
    </message>
    <message>
        <source>2012 model, figure 1</source>
        <translation>2012 års modell, figur 1</translation>
    </message>
    <message>
        <source>Wind</source>
        <translation>Vind</translation>
    </message>
    <message>
        <source>Acceleration Vw by the wind, level with the ground.</source>
        <translation>Acceleration Vw av vinden, längs marken.</translation>
    </message>
    <message>
        <source>2012 model, eq. III and V</source>
        <translation>2012 års modell, ekv. III och V</translation>
    </message>
    <message>
        <source>Wind angle</source>
        <translation>Vindvinkel</translation>
    </message>
    <message>
        <source>Angle θ of the wind in the horizontal X-Z plane; 0 blows along +X, 90 along +Z, against the sense of the rotation.</source>
        <translation>Vindens vinkel θ i det vågräta X-Z-planet; 0 blåser längs +X, 90 längs +Z, mot rotationens riktning.</translation>
    </message>
    <message>
        <source>Gravity</source>
        <translation>Tyngdkraft</translation>
    </message>
    <message>
        <source>Gravity g; divided by the mass it pulls particles down.</source>
        <translation>Tyngdkraften g; delad med massan drar den partiklarna nedåt.</translation>
    </message>
    <message>
        <source>2012 model, eq. IV</source>
        <translation>2012 års modell, ekv. IV</translation>
    </message>
    <message>
        <source>Drag</source>
        <translation>Luftmotstånd</translation>
    </message>
    <message>
        <source>Air resistance: the share of its velocity that a particle loses a second.</source>
        <translation>Luftmotstånd: den andel av sin hastighet som en partikel förlorar i sekunden.</translation>
    </message>
    <message>
        <source>Cooling</source>
        <translation>Avsvalning</translation>
    </message>
    <message>
        <source>How fast the heat that lifts the smoke is lost.</source>
        <translation>Hur fort värmen som lyfter röken går förlorad.</translation>
    </message>
    <message>
        <source>Randomness</source>
        <translation>Slumpmässighet</translation>
    </message>
    <message>
        <source>0: forces act steadily. 1: each is multiplied by a new random number every frame and acts as a random walk. Steps per frame do not change how far it leads; a higher frame rate shortens it.</source>
        <translation>0: krafterna verkar stadigt. 1: var och en multipliceras med ett nytt slumptal varje bildruta och verkar som en slumpvandring. Steg per bildruta ändrar inte hur långt den leder; en högre bildfrekvens förkortar den.</translation>
    </message>
    <message>
        <source>2012 model, eq. XI and XII (1 there)</source>
        <translation>2012 års modell, ekv. XI och XII (1 där)</translation>
    </message>
    <message>
        <source>Gusts</source>
        <translation>Byar</translation>
    </message>
    <message>
        <source>How much the strength and direction of the wind wander.</source>
        <translation>Hur mycket vindens styrka och riktning vandrar.</translation>
    </message>
    <message>
        <source>Gust rate</source>
        <translation>Bytakt</translation>
    </message>
    <message>
        <source>How often the wind changes.</source>
        <translation>Hur ofta vinden ändrar sig.</translation>
    </message>
    <message>
        <source>Heat variation</source>
        <translation>Värmevariation</translation>
    </message>
    <message>
        <source>How much the heat at birth differs from one particle to the next, around the same mean; hot ones run ahead.</source>
        <translation>Hur mycket värmen vid födseln skiljer mellan partiklar, kring samma medelvärde; de heta springer före.</translation>
    </message>
    <message>
        <source>Attract to axis</source>
        <translation>Drag mot axeln</translation>
    </message>
    <message>
        <source>Acceleration towards the vertical line through the emitter, per metre of distance: the inflow that keeps a plume together.</source>
        <translation>Acceleration mot den lodräta linjen genom utsändaren, per meter avstånd: inflödet som håller ihop en plym.</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>Rotation</translation>
    </message>
    <message>
        <source>2012 model, whole-body rotation (0 there)</source>
        <translation>2012 års modell, rotation av hela molnet (0 där)</translation>
    </message>
    <message>
        <source>Rotation jitter</source>
        <translation>Rotationsjitter</translation>
    </message>
    <message>
        <source>Random part of that rate, drawn anew every frame. Steps per frame do not change how far it turns; a higher frame rate does.</source>
        <translation>Slumpdelen av takten, dragen på nytt varje bildruta. Steg per bildruta ändrar inte hur långt den vrider; en högre bildfrekvens gör det.</translation>
    </message>
    <message>
        <source>2012 model, whole-body rotation</source>
        <translation>2012 års modell, rotation av hela molnet</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>Massa</translation>
    </message>
    <message>
        <source>Mass m of a particle, which divides gravity.</source>
        <translation>En partikels massa m, som delar tyngdkraften.</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>Styrka</translation>
    </message>
    <message>
        <source>Speed of the swirls that carry the particles: its root mean square over space, all layers together.</source>
        <translation>Farten hos virvlarna som bär partiklarna: dess kvadratiska medelvärde över rummet, alla lager tillsammans.</translation>
    </message>
    <message>
        <source>Bridson et al. 2007, curl noise</source>
        <translation>Bridson m.fl. 2007, rotationsbrus</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Skala</translation>
    </message>
    <message>
        <source>Size of the largest swirls at the height of the emitter.</source>
        <translation>Storleken på de största virvlarna i utsändarens höjd.</translation>
    </message>
    <message>
        <source>Octaves</source>
        <translation>Oktaver</translation>
    </message>
    <message>
        <source>Layers of ever smaller swirls; each costs the same time.</source>
        <translation>Lager av allt mindre virvlar; vart och ett kostar lika lång tid.</translation>
    </message>
    <message>
        <source>Roughness</source>
        <translation>Skrovlighet</translation>
    </message>
    <message>
        <source>Speed of each layer of swirls relative to the one before.</source>
        <translation>Varje virvellagers fart i förhållande till det föregående.</translation>
    </message>
    <message>
        <source>Evolution</source>
        <translation>Utveckling</translation>
    </message>
    <message>
        <source>How often the largest swirls become others; smaller ones change faster.</source>
        <translation>Hur ofta de största virvlarna blir andra; mindre ändrar sig fortare.</translation>
    </message>
    <message>
        <source>Fade-in time</source>
        <translation>Insats</translation>
    </message>
    <message>
        <source>Age at which the swirls have their full strength; younger smoke is calmer.</source>
        <translation>Ålder då virvlarna har sin fulla styrka; yngre rök är lugnare.</translation>
    </message>
    <message>
        <source>Growth with height</source>
        <translation>Tillväxt med höjden</translation>
    </message>
    <message>
        <source>How much larger the swirls are with each metre above the emitter, as in a plume that takes in air.</source>
        <translation>Hur mycket större virvlarna är med varje meter över utsändaren, som i en plym som tar in luft.</translation>
    </message>
    <message>
        <source>Drift</source>
        <translation>Drift</translation>
    </message>
    <message>
        <source>Speed at which the swirls rise along with the smoke, instead of standing still while it passes.</source>
        <translation>Fart som virvlarna stiger med tillsammans med röken, i stället för att stå stilla medan den passerar.</translation>
    </message>
    <message>
        <source>Lacunarity</source>
        <translation>Lakunaritet</translation>
    </message>
    <message>
        <source>How many times smaller each layer of swirls is than the one before.</source>
        <translation>Hur många gånger mindre varje virvellager är än det föregående.</translation>
    </message>
    <message>
        <source>Speed of the swirl at its radius. About an upright axis it turns from +X towards -Z; negative turns the other way.</source>
        <translation>Virvelns fart vid sin radie. Kring en upprätt axel vrider den från +X mot -Z; negativ vrider åt andra hållet.</translation>
    </message>
    <message>
        <source>Scully 1975, vortex profile</source>
        <translation>Scully 1975, virvelprofil</translation>
    </message>
    <message>
        <source>Distance from the axis at which the swirl is fastest.</source>
        <translation>Avstånd från axeln där virveln är snabbast.</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>Axel</translation>
    </message>
    <message>
        <source>Direction of the axis through the emitter about which the smoke swirls.</source>
        <translation>Riktningen på axeln genom utsändaren som röken virvlar kring.</translation>
    </message>
    <message>
        <source>Fade rate</source>
        <translation>Avtoningstakt</translation>
    </message>
    <message>
        <source>Alpha that a particle loses a second. Its life is the initial alpha divided by this.</source>
        <translation>Alfa som en partikel förlorar i sekunden. Dess liv är den ursprungliga alfan delad med detta.</translation>
    </message>
    <message>
        <source>2012 model, eq. XIII</source>
        <translation>2012 års modell, ekv. XIII</translation>
    </message>
    <message>
        <source>Initial alpha</source>
        <translation>Ursprunglig alfa</translation>
    </message>
    <message>
        <source>Alpha Ai of a particle at birth.</source>
        <translation>En partikels alfa Ai vid födseln.</translation>
    </message>
    <message>
        <source>2012 model, eq. XIII (0.1 there)</source>
        <translation>2012 års modell, ekv. XIII (0.1 där)</translation>
    </message>
    <message>
        <source>Lifetime variation</source>
        <translation>Livslängdsvariation</translation>
    </message>
    <message>
        <source>Lets particles die earlier, by up to this share of their life, so that the smoke thins out unevenly.</source>
        <translation>Låter partiklar dö tidigare, med upp till denna andel av sitt liv, så att röken tunnas ut ojämnt.</translation>
    </message>
    <message>
        <source>Size over life</source>
        <translation>Storlek över livet</translation>
    </message>
    <message>
        <source>Share of the particle&apos;s size, from birth to death.</source>
        <translation>Andel av partikelns storlek, från födsel till död.</translation>
    </message>
    <message>
        <source>Alpha over life</source>
        <translation>Alfa över livet</translation>
    </message>
    <message>
        <source>Multiplies the fading alpha, from birth to death.</source>
        <translation>Multiplicerar den avtagande alfan, från födsel till död.</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Täthet</translation>
    </message>
    <message>
        <source>Multiplies the alpha of every particle: from wisp to billow.</source>
        <translation>Multiplicerar varje partikels alfa: från slöja till moln.</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Storlek</translation>
    </message>
    <message>
        <source>Largest diameter of a particle.</source>
        <translation>En partikels största diameter.</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Färg</translation>
    </message>
    <message>
        <source>Colour of the smoke itself (albedo), before light falls on it.</source>
        <translation>Rökens egen färg (albedo), innan ljus faller på den.</translation>
    </message>
    <message>
        <source>Colour over life</source>
        <translation>Färg över livet</translation>
    </message>
    <message>
        <source>Multiplies the colour, from birth to death.</source>
        <translation>Multiplicerar färgen, från födsel till död.</translation>
    </message>
    <message>
        <source>Texture</source>
        <translation>Textur</translation>
    </message>
    <message>
        <source>How much the noise disturbs the transparency of a particle.</source>
        <translation>Hur mycket bruset stör en partikels genomskinlighet.</translation>
    </message>
    <message>
        <source>2012 model, transparency disturbance</source>
        <translation>2012 års modell, störd genomskinlighet</translation>
    </message>
    <message>
        <source>Erosion</source>
        <translation>Erosion</translation>
    </message>
    <message>
        <source>How far the noise eats into a particle by the end of its life.</source>
        <translation>Hur långt bruset äter sig in i en partikel mot slutet av dess liv.</translation>
    </message>
    <message>
        <source>Erosion softness</source>
        <translation>Erosionens mjukhet</translation>
    </message>
    <message>
        <source>Width of the transition from smoke to hole.</source>
        <translation>Bredden på övergången från rök till hål.</translation>
    </message>
    <message>
        <source>Softness</source>
        <translation>Mjukhet</translation>
    </message>
    <message>
        <source>0: a disc with a hard rim. 1: a puff that fades from its centre.</source>
        <translation>0: en skiva med hård kant. 1: en puff som tonar bort från mitten.</translation>
    </message>
    <message>
        <source>Relief</source>
        <translation>Relief</translation>
    </message>
    <message>
        <source>How much the noise catches the light, as bumps on a puff.</source>
        <translation>Hur mycket bruset fångar ljuset, som bulor på en puff.</translation>
    </message>
    <message>
        <source>Roundness</source>
        <translation>Rundhet</translation>
    </message>
    <message>
        <source>How much a puff is shaded like a ball.</source>
        <translation>Hur mycket en puff skuggas som en boll.</translation>
    </message>
    <message>
        <source>Size variation</source>
        <translation>Storleksvariation</translation>
    </message>
    <message>
        <source>How much sizes differ; 1 mixes everything down to nothing.</source>
        <translation>Hur mycket storlekarna skiljer sig; 1 blandar allt ned till ingenting.</translation>
    </message>
    <message>
        <source>Density falloff</source>
        <translation>Utspädning</translation>
    </message>
    <message>
        <source>How much a particle thins out as it grows; 1 keeps its amount of smoke constant.</source>
        <translation>Hur mycket en partikel tunnas ut när den växer; 1 håller dess mängd rök konstant.</translation>
    </message>
    <message>
        <source>Texture scale</source>
        <translation>Texturskala</translation>
    </message>
    <message>
        <source>Share of the noise tile that a particle shows; more than 1 repeats it.</source>
        <translation>Andel av brusrutan som en partikel visar; mer än 1 upprepar den.</translation>
    </message>
    <message>
        <source>Texture evolution</source>
        <translation>Texturens utveckling</translation>
    </message>
    <message>
        <source>How fast the noise in a particle boils: lattice cells of the third axis a second.</source>
        <translation>Hur fort bruset i en partikel sjuder: gitterceller längs tredje axeln i sekunden.</translation>
    </message>
    <message>
        <source>Rotation variation</source>
        <translation>Rotationsvariation</translation>
    </message>
    <message>
        <source>How much particles are turned at birth; 1 is any angle.</source>
        <translation>Hur mycket partiklar är vridna vid födseln; 1 är vilken vinkel som helst.</translation>
    </message>
    <message>
        <source>Spin</source>
        <translation>Snurr</translation>
    </message>
    <message>
        <source>Rate at which each particle turns on the screen.</source>
        <translation>Takt som varje partikel vrids med på skärmen.</translation>
    </message>
    <message>
        <source>Spin variation</source>
        <translation>Snurrvariation</translation>
    </message>
    <message>
        <source>Random part of that rate, different for every particle.</source>
        <translation>Slumpdelen av takten, olika för varje partikel.</translation>
    </message>
    <message>
        <source>Stretch</source>
        <translation>Töjning</translation>
    </message>
    <message>
        <source>Lengthens a particle&apos;s texture along its motion, by the way it travels in this time.</source>
        <translation>Förlänger en partikels textur längs dess rörelse, med vägen den går på denna tid.</translation>
    </message>
    <message>
        <source>Particle shape</source>
        <translation>Mask</translation>
    </message>
    <message>
        <source>Layers of noise that are summed, each finer and weaker than the one before.</source>
        <translation>Lager av brus som summeras, vart och ett finare och svagare än det föregående.</translation>
    </message>
    <message>
        <source>2012 model, octaves</source>
        <translation>2012 års modell, oktaver</translation>
    </message>
    <message>
        <source>Sharpness</source>
        <translation>Skärpa</translation>
    </message>
    <message>
        <source>Contrast of the grey values about their middle; 1 leaves them as they are.</source>
        <translation>Gråvärdenas kontrast kring sin mitt; 1 lämnar dem som de är.</translation>
    </message>
    <message>
        <source>2012 model, sharpness</source>
        <translation>2012 års modell, skärpa</translation>
    </message>
    <message>
        <source>Wavelength</source>
        <translation>Våglängd</translation>
    </message>
    <message>
        <source>Wavelength of the first octave as a share of the tile (the inverse of its frequency).</source>
        <translation>Första oktavens våglängd som andel av rutan (frekvensens invers).</translation>
    </message>
    <message>
        <source>Persistence</source>
        <translation>Persistens</translation>
    </message>
    <message>
        <source>Amplitude of each octave relative to the one before.</source>
        <translation>Varje oktavs amplitud i förhållande till den föregående.</translation>
    </message>
    <message>
        <source>Coverage</source>
        <translation>Täckning</translation>
    </message>
    <message>
        <source>How much of the tile is smoke: shifts the grey values up or down.</source>
        <translation>Hur mycket av rutan som är rök: flyttar gråvärdena uppåt eller nedåt.</translation>
    </message>
    <message>
        <source>Warp</source>
        <translation>Förvridning</translation>
    </message>
    <message>
        <source>Bends the noise by another noise, by up to this share of its wavelength.</source>
        <translation>Böjer bruset med ett annat brus, med upp till denna andel av dess våglängd.</translation>
    </message>
    <message>
        <source>Perlin 1985, domain perturbation</source>
        <translation>Perlin 1985, domänstörning</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>Utjämning</translation>
    </message>
    <message>
        <source>Averages each lattice value with its neighbours: centre 1/4, edges 1/8, corners 1/16.</source>
        <translation>Tar medelvärdet av varje gittervärde och dess grannar: mitten 1/4, kanter 1/8, hörn 1/16.</translation>
    </message>
    <message>
        <source>2012 model, smooth function</source>
        <translation>2012 års modell, utjämningsfunktionen</translation>
    </message>
    <message>
        <source>Basis</source>
        <translation>Bas</translation>
    </message>
    <message>
        <source>Random values on a lattice (2012 model), random gradients, or gradients on a lattice of simplices.</source>
        <translation>Slumpvärden på ett gitter (2012 års modell), slumpgradienter, eller gradienter på ett gitter av simplex.</translation>
    </message>
    <message>
        <source>2012 model; Perlin 2002</source>
        <translation>2012 års modell; Perlin 2002</translation>
    </message>
    <message>
        <source>Interpolation</source>
        <translation>Interpolation</translation>
    </message>
    <message>
        <source>How values between lattice points are found. Cubic swings past its points; what leaves 0 to 1 is cut.</source>
        <translation>Hur värden mellan gitterpunkter hittas. Kubisk svänger förbi sina punkter; det som lämnar 0 till 1 klipps.</translation>
    </message>
    <message>
        <source>2012 model (linear, cosine, cubic); Perlin 2002 (quintic)</source>
        <translation>2012 års modell (linjär, cosinus, kubisk); Perlin 2002 (kvintisk)</translation>
    </message>
    <message>
        <source>Frequency of each octave relative to the one before.</source>
        <translation>Varje oktavs frekvens i förhållande till den föregående.</translation>
    </message>
    <message>
        <source>Lattice cells of the first octave along the third axis, through which the texture boils before it repeats.</source>
        <translation>Första oktavens gitterceller längs tredje axeln, som texturen sjuder igenom innan den upprepas.</translation>
    </message>
    <message>
        <source>Slices</source>
        <translation>Snitt</translation>
    </message>
    <message>
        <source>How many slices of the 3D noise are baked.</source>
        <translation>Hur många snitt av 3D-bruset som bakas.</translation>
    </message>
    <message>
        <source>Resolution</source>
        <translation>Upplösning</translation>
    </message>
    <message>
        <source>Edge of the noise tile; particles use the next power of two.</source>
        <translation>Brusrutans kant; partiklarna använder nästa tvåpotens.</translation>
    </message>
    <message>
        <source>Another seed gives another texture of the same kind.</source>
        <translation>Ett annat frö ger en annan textur av samma slag.</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Riktning</translation>
    </message>
    <message>
        <source>The direction in which the light of the sun travels.</source>
        <translation>Riktningen som solens ljus går i.</translation>
    </message>
    <message>
        <source>Sun intensity</source>
        <translation>Intensitet</translation>
    </message>
    <message>
        <source>Strength of the sun.</source>
        <translation>Solens styrka.</translation>
    </message>
    <message>
        <source>Shadow</source>
        <translation>Skugga</translation>
    </message>
    <message>
        <source>How much light is lost on the way through the smoke.</source>
        <translation>Hur mycket ljus som går förlorat på vägen genom röken.</translation>
    </message>
    <message>
        <source>Scattering</source>
        <translation>Spridning av ljus</translation>
    </message>
    <message>
        <source>Light that is scattered many times and reaches deep into dense smoke, so that it is not black.</source>
        <translation>Ljus som sprids många gånger och når djupt in i tät rök, så att den inte är svart.</translation>
    </message>
    <message>
        <source>Wrenninge et al. 2013, octaves of scattering</source>
        <translation>Wrenninge m.fl. 2013, oktaver av spridning</translation>
    </message>
    <message>
        <source>Forward scattering</source>
        <translation>Anisotropi</translation>
    </message>
    <message>
        <source>More than 0: smoke glows when it stands before the sun. Less: it is brighter with the sun behind the camera.</source>
        <translation>Mer än 0: röken glöder när den står framför solen. Mindre: den är ljusare med solen bakom kameran.</translation>
    </message>
    <message>
        <source>Henyey and Greenstein 1941</source>
        <translation>Henyey och Greenstein 1941</translation>
    </message>
    <message>
        <source>Ambient</source>
        <translation>Omgivningsljus</translation>
    </message>
    <message>
        <source>Strength of the light from sky and ground.</source>
        <translation>Styrkan hos ljuset från himmel och mark.</translation>
    </message>
    <message>
        <source>Colour of the sun.</source>
        <translation>Solens färg.</translation>
    </message>
    <message>
        <source>Sky</source>
        <translation>Himmel</translation>
    </message>
    <message>
        <source>Colour of the light from above.</source>
        <translation>Färgen på ljuset ovanifrån.</translation>
    </message>
    <message>
        <source>Ground</source>
        <translation>Mark</translation>
    </message>
    <message>
        <source>Colour of the light from below.</source>
        <translation>Färgen på ljuset underifrån.</translation>
    </message>
    <message>
        <source>Occlusion</source>
        <translation>Ocklusion</translation>
    </message>
    <message>
        <source>How much the light from sky and ground is lost inside dense smoke.</source>
        <translation>Hur mycket av ljuset från himmel och mark som går förlorat inne i tät rök.</translation>
    </message>
    <message>
        <source>Light that hot smoke gives off by itself, as fire.</source>
        <translation>Ljus som het rök själv avger, som eld.</translation>
    </message>
    <message>
        <source>Emission cooling</source>
        <translation>Glödens avsvalning</translation>
    </message>
    <message>
        <source>How fast the glow moves down its colours as smoke ages.</source>
        <translation>Hur fort glöden rör sig nedåt genom sina färger när röken åldras.</translation>
    </message>
    <message>
        <source>Emission colours</source>
        <translation>Glödens färger</translation>
    </message>
    <message>
        <source>Colour of the glow from cold (left) to as hot as at birth (right).</source>
        <translation>Glödens färg från kall (vänster) till lika het som vid födseln (höger).</translation>
    </message>
    <message>
        <source>Cells of the density grid along the longest side of the cloud.</source>
        <translation>Täthetsrutnätets celler längs molnets längsta sida.</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>Läge</translation>
    </message>
    <message>
        <source>Around a target, or at a fixed place.</source>
        <translation>Kring ett mål, eller på en fast plats.</translation>
    </message>
    <message>
        <source>Yaw</source>
        <translation>Gir</translation>
    </message>
    <message>
        <source>Angle around the target, seen from above; 0 looks along -Z.</source>
        <translation>Vinkel kring målet, sedd uppifrån; 0 tittar längs -Z.</translation>
    </message>
    <message>
        <source>Pitch</source>
        <translation>Lutning</translation>
    </message>
    <message>
        <source>Angle above the horizon from which the target is seen.</source>
        <translation>Vinkel över horisonten som målet ses från.</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Avstånd</translation>
    </message>
    <message>
        <source>Distance from the target.</source>
        <translation>Avstånd från målet.</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>Mål</translation>
    </message>
    <message>
        <source>The point that the camera looks at.</source>
        <translation>Punkten som kameran tittar på.</translation>
    </message>
    <message>
        <source>Turntable</source>
        <translation>Vändskiva</translation>
    </message>
    <message>
        <source>Rate at which the camera goes around the target.</source>
        <translation>Takt som kameran går runt målet med.</translation>
    </message>
    <message>
        <source>Where the fixed camera stands.</source>
        <translation>Var den fasta kameran står.</translation>
    </message>
    <message>
        <source>View direction</source>
        <translation>Blickriktning</translation>
    </message>
    <message>
        <source>Where the fixed camera looks.</source>
        <translation>Vart den fasta kameran tittar.</translation>
    </message>
    <message>
        <source>Focal length</source>
        <translation>Brännvidd</translation>
    </message>
    <message>
        <source>Of a lens on a sensor of 36 mm across the shorter side; longer brings the smoke nearer.</source>
        <translation>Hos ett objektiv på en sensor med 36 mm kortsida; längre för röken närmare.</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Längd</translation>
    </message>
    <message>
        <source>Frames from the first to the last; also the length of the loop.</source>
        <translation>Bildrutor från den första till den sista; också slingans längd.</translation>
    </message>
    <message>
        <source>The frame after the last is the first again, to the bit.</source>
        <translation>Bildrutan efter den sista är den första igen, på biten när.</translation>
    </message>
    <message>
        <source>Prewarm</source>
        <translation>Börja varm</translation>
    </message>
    <message>
        <source>Frame 0 shows smoke that has been rising for a lifetime, instead of none.</source>
        <translation>Bildruta 0 visar rök som har stigit en livslängd, i stället för ingen.</translation>
    </message>
    <message>
        <source>Frame rate</source>
        <translation>Bildfrekvens</translation>
    </message>
    <message>
        <source>Frames a second.</source>
        <translation>Bildrutor i sekunden.</translation>
    </message>
    <message>
        <source>Substeps</source>
        <translation>Steg per bildruta</translation>
    </message>
    <message>
        <source>Steps of the simulation in a frame; more follow fast motion more closely.</source>
        <translation>Simuleringens steg i en bildruta; fler följer snabb rörelse närmare.</translation>
    </message>
    <message>
        <source>2012 model, eq. IX and X (1 there)</source>
        <translation>2012 års modell, ekv. IX och X (1 där)</translation>
    </message>
    <message>
        <source>Width of a frame.</source>
        <translation>En bildrutas bredd.</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Höjd</translation>
    </message>
    <message>
        <source>Height of a frame.</source>
        <translation>En bildrutas höjd.</translation>
    </message>
    <message>
        <source>Supersampling</source>
        <translation>Översampling</translation>
    </message>
    <message>
        <source>Renders this many times larger and averages.</source>
        <translation>Renderar så många gånger större och tar medelvärdet.</translation>
    </message>
    <message>
        <source>Exposure</source>
        <translation>Exponering</translation>
    </message>
    <message>
        <source>Brightness in stops; one more doubles it. Not applied to EXR, which is linear.</source>
        <translation>Ljusstyrka i bländarsteg; ett till fördubblar den. Gäller inte EXR, som är linjär.</translation>
    </message>
    <message>
        <source>View transform</source>
        <translation>Vytransform</translation>
    </message>
    <message>
        <source>Standard is plain sRGB; filmic rolls bright light off softly.</source>
        <translation>Standard är ren sRGB; film rullar av starkt ljus mjukt.</translation>
    </message>
    <message>
        <source>Background</source>
        <translation>Bakgrund</translation>
    </message>
    <message>
        <source>Keep transparency, or put a colour behind the smoke.</source>
        <translation>Behåll genomskinligheten, eller lägg en färg bakom röken.</translation>
    </message>
    <message>
        <source>Background colour</source>
        <translation>Bakgrundsfärg</translation>
    </message>
    <message>
        <source>The colour behind the smoke.</source>
        <translation>Färgen bakom röken.</translation>
    </message>
    <message>
        <source>rectangle</source>
        <translation>rektangel</translation>
    </message>
    <message>
        <source>disc</source>
        <translation>skiva</translation>
    </message>
    <message>
        <source>sphere</source>
        <translation>klot</translation>
    </message>
    <message>
        <source>continuous</source>
        <translation>ständig</translation>
    </message>
    <message>
        <source>burst</source>
        <translation>puff</translation>
    </message>
    <message>
        <source>square</source>
        <translation>kvadrat</translation>
    </message>
    <message>
        <source>lattice</source>
        <translation>gitter</translation>
    </message>
    <message>
        <source>gradient</source>
        <translation>gradient</translation>
    </message>
    <message>
        <source>simplex</source>
        <translation>simplex</translation>
    </message>
    <message>
        <source>linear</source>
        <translation>linjär</translation>
    </message>
    <message>
        <source>cosine</source>
        <translation>cosinus</translation>
    </message>
    <message>
        <source>cubic</source>
        <translation>kubisk</translation>
    </message>
    <message>
        <source>quintic</source>
        <translation>kvintisk</translation>
    </message>
    <message>
        <source>orbit</source>
        <translation>kretsande</translation>
    </message>
    <message>
        <source>fixed</source>
        <translation>fast</translation>
    </message>
    <message>
        <source>standard</source>
        <translation>standard</translation>
    </message>
    <message>
        <source>filmic</source>
        <translation>film</translation>
    </message>
    <message>
        <source>transparent</source>
        <translation>genomskinlig</translation>
    </message>
    <message>
        <source>colour</source>
        <translation>färg</translation>
    </message>
    <message>
        <source>Emitter</source>
        <translation>Utsändare</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>Rörelse</translation>
    </message>
    <message>
        <source>Turbulence</source>
        <translation>Turbulens</translation>
    </message>
    <message>
        <source>Vortex</source>
        <translation>Virvel</translation>
    </message>
    <message>
        <source>Life</source>
        <translation>Liv</translation>
    </message>
    <message>
        <source>Look</source>
        <translation>Utseende</translation>
    </message>
    <message>
        <source>Noise</source>
        <translation>Brus</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Ljus</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Kamera</translation>
    </message>
    <message>
        <source>Timeline</source>
        <translation>Tidslinje</translation>
    </message>
    <message>
        <source>Output</source>
        <translation>Utdata</translation>
    </message>
    <message>
        <source>Range: %1</source>
        <translation>Intervall: %1</translation>
    </message>
    <message>
        <source>Source: %1</source>
        <translation>Källa: %1</translation>
    </message>
    <message>
        <source>Speed of the flow through the middle of the vortex rings that rise with the smoke: they roll its rim into billows, and the first one is the head of a mushroom.</source>
        <translation>Hur fort det strömmar genom mitten av de virvelringar som stiger med röken: de rullar dess kant till bolster, och den första är svampens huvud.</translation>
    </message>
    <message>
        <source>Rise</source>
        <translation>Stigning</translation>
    </message>
    <message>
        <source>Speed at which the rings travel along the emitter&apos;s normal.</source>
        <translation>Hur fort ringarna färdas längs emitterns normal.</translation>
    </message>
    <message>
        <source>Radius of a ring at the emitter: inside it the smoke rises, outside it sinks.</source>
        <translation>En rings radie vid emittern: innanför den stiger röken, utanför sjunker den.</translation>
    </message>
    <message>
        <source>Metres that the radius grows with each metre from the emitter.</source>
        <translation>Hur många meter radien växer för varje meter från emittern.</translation>
    </message>
    <message>
        <source>Spacing</source>
        <translation>Avstånd mellan ringar</translation>
    </message>
    <message>
        <source>Distance from one ring to the next.</source>
        <translation>Avståndet från en ring till nästa.</translation>
    </message>
    <message>
        <source>Following rings</source>
        <translation>Följande</translation>
    </message>
    <message>
        <source>Strength of the rings that follow, relative to the first; smoke that starts warm has followers only.</source>
        <translation>De följande ringarnas styrka i förhållande till den första; rök som börjar varm har bara följande.</translation>
    </message>
    <message>
        <source>Variation</source>
        <translation>Variation</translation>
    </message>
    <message>
        <source>How much the rings differ in strength and lie off the axis, so that they do not march in formation.</source>
        <translation>Hur mycket ringarna skiljer sig i styrka och ligger vid sidan av axeln, så att de inte marscherar i takt.</translation>
    </message>
    <message>
        <source>Roll</source>
        <translation>Rullning</translation>
    </message>
    <message>
        <source>How much particles turn with the swirls that carry them; 1 is as much as the air itself.</source>
        <translation>Hur mycket partiklarna vrids av virvlarna som bär dem; 1 är lika mycket som luften själv.</translation>
    </message>
    <message>
        <source>Hot core</source>
        <translation>Het kärna</translation>
    </message>
    <message>
        <source>How much cooler the rim glows than the inside: air cools what lies open to it, and fire shows in the gaps.</source>
        <translation>Hur mycket svalare kanten glöder än det inre: luften kyler det som ligger öppet, och elden syns i springorna.</translation>
    </message>
    <message>
        <source>Fire colours from</source>
        <translation>Glöd från</translation>
    </message>
    <message>
        <source>Colours of your choice, or those of a body that glows by its temperature.</source>
        <translation>Färger som du väljer, eller de hos en kropp som glöder av sin temperatur.</translation>
    </message>
    <message>
        <source>Temperature</source>
        <translation>Temperatur</translation>
    </message>
    <message>
        <source>Temperature at birth: 1000 K glows red, 1900 K as a candle, 5800 K as the sun. As smoke cools, its glow turns red and fades.</source>
        <translation>Temperatur vid födseln: 1000 K glöder rött, 1900 K som ett stearinljus, 5800 K som solen. När röken svalnar blir glöden röd och dör ut.</translation>
    </message>
    <message>
        <source>Planck 1901; colour matching of Wyman et al. 2013</source>
        <translation>Planck 1901; färgmatchning enligt Wyman m.fl. 2013</translation>
    </message>
    <message>
        <source>Quality</source>
        <translation>Kvalitet</translation>
    </message>
    <message>
        <source>Draft: a quarter of the particles. Final: eight times as many. The smoke keeps its form and density.</source>
        <translation>Utkast: en fjärdedel av partiklarna. Slutlig: åtta gånger så många. Röken behåller sin form och täthet.</translation>
    </message>
    <message>
        <source>black-body</source>
        <translation>svartkropp</translation>
    </message>
    <message>
        <source>draft</source>
        <translation>utkast</translation>
    </message>
    <message>
        <source>good</source>
        <translation>god</translation>
    </message>
    <message>
        <source>final</source>
        <translation>slutlig</translation>
    </message>
    <message>
        <source>Vortex rings</source>
        <translation>Virvelringar</translation>
    </message>
    <message>
        <source>Turner 1962, the starting plume</source>
        <translation>Turner 1962, den begynnande plymen</translation>
    </message>
    <message>
        <source>on</source>
        <translation>på</translation>
    </message>
    <message>
        <source>off</source>
        <translation>av</translation>
    </message>
    <message>
        <source>Seamless loop</source>
        <translation>Sömlös slinga</translation>
    </message>
    <message>
        <source>Fluid simulation</source>
        <translation>Luft i rörelse</translation>
    </message>
    <message>
        <source>The smoke is carried by air that it heats: it rolls up, takes in air, makes stems and caps, and flows around obstacles. Buoyancy, cooling, wind, gusts and the speed of the emitter act on the air; turbulence is the detail below its grid, and vortex rings come by themselves.</source>
        <translation>Röken bärs av luft som den värmer: den rullar ihop sig, tar in luft, bildar stammar och hattar och strömmar runt hinder. Lyftkraft, avkylning, vind, byar och emitterns fart verkar på luften; turbulensen är detaljerna under dess rutnät, och virvelringar kommer av sig själva.</translation>
    </message>
    <message>
        <source>Fedkiw, Stam, Jensen 2001</source>
        <translation>Fedkiw, Stam, Jensen 2001</translation>
    </message>
    <message>
        <source>Cells of air along the longest side of its box: twice as many show smaller billows and take sixteen times as long. Once baked, the air costs next to nothing.</source>
        <translation>Luftens celler längs den längsta sidan av dess låda: dubbelt så många visar mindre bolster och tar sexton gånger så lång tid. När luften väl är beräknad kostar den nästan ingenting.</translation>
    </message>
    <message>
        <source>Fit to the smoke</source>
        <translation>Anpassa till röken</translation>
    </message>
    <message>
        <source>The box of the air is as large as the smoke is expected to become, from what the emitter gives it and for how long it lives.</source>
        <translation>Luftens låda är så stor som röken väntas bli, av det som emittern ger den och så länge som den lever.</translation>
    </message>
    <message>
        <source>Edges of the box of the air. It stands above the emitter&apos;s foot; smoke that leaves it goes on with the wind.</source>
        <translation>Kanterna på luftens låda. Den står ovanför emitterns fot; rök som lämnar den följer vinden.</translation>
    </message>
    <message>
        <source>Offset</source>
        <translation>Förskjutning</translation>
    </message>
    <message>
        <source>Moves the box of the air away from the emitter. The emitter has to stay inside it.</source>
        <translation>Flyttar luftens låda från emittern. Emittern måste vara kvar i den.</translation>
    </message>
    <message>
        <source>Vorticity confinement</source>
        <translation>Virvling</translation>
    </message>
    <message>
        <source>Gives swirls back what the grid takes from them, and no more than that. It makes billows crisp.</source>
        <translation>Ger virvlarna tillbaka det som rutnätet tar från dem, och inte mer. Gör bolstren skarpa.</translation>
    </message>
    <message>
        <source>Steinhoff and Underhill 1994</source>
        <translation>Steinhoff och Underhill 1994</translation>
    </message>
    <message>
        <source>Source noise</source>
        <translation>Ojämnhet</translation>
    </message>
    <message>
        <source>Detail</source>
        <translation>Detaljer</translation>
    </message>
    <message>
        <source>Swirls that are smaller than the cells of the air, as strong as the air around them is sheared. Octaves, roughness, evolution and drift of the turbulence say what they are like.</source>
        <translation>Virvlar som är mindre än luftens celler, så starka som luften omkring dem skjuvas. Turbulensens oktaver, råhet, utveckling och drift säger hurdana de är.</translation>
    </message>
    <message>
        <source>Kim, Thürey, James, Gross 2008</source>
        <translation>Kim, Thürey, James, Gross 2008</translation>
    </message>
    <message>
        <source>Heat opacity</source>
        <translation>Täckning efter värme</translation>
    </message>
    <message>
        <source>How much smoke fades where its air is cold: 1 shows nothing but what is hot, as in a flame.</source>
        <translation>Hur mycket röken bleknar där luften är kall: 1 visar bara det som är hett, som i en låga.</translation>
    </message>
    <message>
        <source>Expansion</source>
        <translation>Utvidgning</translation>
    </message>
    <message>
        <source>Volume that the source adds to the air, as a multiple of its own each second, as long as it emits: a burst blows up a ball.</source>
        <translation>Den volym som källan tillför luften, som en multipel av sin egen varje sekund, så länge den sänder ut: en puff blåser upp en boll.</translation>
    </message>
    <message>
        <source>A floor that air and smoke flow along and do not enter.</source>
        <translation>Ett golv som luft och rök strömmar längs och inte tränger in i.</translation>
    </message>
    <message>
        <source>Ground height</source>
        <translation>Markens höjd</translation>
    </message>
    <message>
        <source>Height of the floor.</source>
        <translation>Golvets höjd.</translation>
    </message>
    <message>
        <source>Friction</source>
        <translation>Friktion</translation>
    </message>
    <message>
        <source>Drag coefficient of the floor and of the obstacle: 0 lets the air slip along, forest has 0.1.</source>
        <translation>Motståndskoefficient för golvet och hindret: 0 låter luften glida, en skog har 0,1.</translation>
    </message>
    <message>
        <source>Obstacle</source>
        <translation>Hinder</translation>
    </message>
    <message>
        <source>A body that air and smoke flow around.</source>
        <translation>En kropp som luft och rök strömmar runt.</translation>
    </message>
    <message>
        <source>Centre of the obstacle.</source>
        <translation>Hindrets mittpunkt.</translation>
    </message>
    <message>
        <source>Obstacle size</source>
        <translation>Hindrets storlek</translation>
    </message>
    <message>
        <source>Edges of the box; of a sphere the first number is the diameter.</source>
        <translation>Lådans kanter; för ett klot är det första talet diametern.</translation>
    </message>
    <message>
        <source>none</source>
        <translation>inget</translation>
    </message>
    <message>
        <source>box</source>
        <translation>låda</translation>
    </message>
    <message>
        <source>Air</source>
        <translation>Luft</translation>
    </message>
    <message>
        <source>Overlap</source>
        <translation>Överlapp</translation>
    </message>
    <message>
        <source>Where fewer particles than this overlap they grow and thin out, so that smoke ends as haze and not as dots; 0: never.</source>
        <translation>Där färre partiklar än så överlappar växer de och tunnas ut, så att röken slutar som dis och inte som prickar; 0: aldrig.</translation>
    </message>
    <message>
        <source>Deformation</source>
        <translation>Deformation</translation>
    </message>
    <message>
        <source>How much the air that carries a particle stretches it, into sheets and curls; 0: all stay round.</source>
        <translation>Hur mycket luften som bär en partikel sträcker ut den, till skikt och krusningar; 0: alla förblir runda.</translation>
    </message>
    <message>
        <source>Deformation time</source>
        <translation>Deformationstid</translation>
    </message>
    <message>
        <source>How long a particle remembers how it was stretched.</source>
        <translation>Hur länge en partikel minns hur den sträcktes.</translation>
    </message>
    <message>
        <source>Deformation limit</source>
        <translation>Deformationsgräns</translation>
    </message>
    <message>
        <source>Axes of a stretched particle are at most this many times its own, and at least the same part of it.</source>
        <translation>En utsträckt partikels axlar är högst så många gånger dess egen, och minst samma bråkdel av den.</translation>
    </message>
    <message>
        <source>Flame opacity</source>
        <translation>Lågornas täthet</translation>
    </message>
    <message>
        <source>How opaque smoke is while it glows, beside when it is cold. 1: it glows as lava does. 0.1: a clear flame that one sees into, from which soot forms as it cools.</source>
        <translation>Hur tät röken är medan den glöder, mot när den är kall. 1: den glöder som lava. 0,1: en klar låga som man ser in i och där sot bildas när den svalnar.</translation>
    </message>
    <message>
        <source>Fire light</source>
        <translation>Eldens ljus</translation>
    </message>
    <message>
        <source>How much what glows lights the smoke around it. 1: as much as it gives off.</source>
        <translation>Hur mycket det som glöder lyser upp röken omkring. 1: så mycket som det avger.</translation>
    </message>
    <message>
        <source>How far the rim of the source wanders, and how unevenly it blows. Without it smoke rises as a column of one width.</source>
        <translation>Hur långt källans rand vandrar och hur ojämnt den blåser. Utan detta stiger röken som en pelare med en enda bredd.</translation>
    </message>
    <message>
        <source>Heat noise</source>
        <translation>Ojämn värme</translation>
    </message>
    <message>
        <source>How much the heat of the source differs from place to place, as a share of it. What is hotter rises ahead of the rest: billows on billows. Without it a cap is bald.</source>
        <translation>Hur mycket källans värme skiljer sig från ställe till ställe, som andel av den. Det hetare stiger före det övriga: bolmar på bolmar. Utan detta blir hatten kal.</translation>
    </message>
    <message>
        <source>Metres that the radius grows with each metre along the axis, away from the emitter: a funnel.</source>
        <translation>Så många meter växer radien med varje meter längs axeln, bort från källan: en tratt.</translation>
    </message>
    <message>
        <source>Stirs the hot air, so that smoke breaks up, spreads and billows from its foot on, where it would rise as a smooth column: the root mean square of the acceleration where it is hottest.</source>
        <translation>Rör om i den varma luften, så att röken bryts upp, sprids och bolmar redan från sin fot, där den annars skulle stiga som en slät pelare: accelerationens effektivvärde där det är som hetast.</translation>
    </message>
    <message>
        <source>Turbulence size</source>
        <translation>Turbulensens storlek</translation>
    </message>
    <message>
        <source>Size of the largest swirls that the turbulence makes; there are some half and a quarter as large, as far as the cells of the air show them. About as large as the emitter looks natural.</source>
        <translation>Storleken på de största virvlar som turbulensen skapar; det finns också hälften och en fjärdedel så stora, så långt luftens celler visar dem. Ungefär lika stora som källan ser naturligt ut.</translation>
    </message>
    <message>
        <source>Ground fade</source>
        <translation>Marktoning</translation>
    </message>
    <message>
        <source>Height above the floor over which smoke becomes opaque, as soft particles do before what they touch in engines: no straight cut at its foot. 0: smoke ends at the floor.</source>
        <translation>Höjd över golvet på vilken röken blir tät, som mjuka partiklar gör framför det de möter i spelmotorer: inget rakt snitt vid foten. 0: röken slutar vid golvet.</translation>
    </message>
    <message>
        <source>Lifetime</source>
        <translation>Livslängd</translation>
    </message>
    <message>
        <source>Seconds from birth to death of a particle: the initial alpha divided by the fade rate. Setting it sets the fade rate.</source>
        <translation>Sekunder från en partikels födelse till dess död: ursprunglig alfa delat med avtoningstakten. Att ändra den ändrar avtoningstakten.</translation>
    </message>
    <message>
        <source>Fire</source>
        <translation>Eld</translation>
    </message>
    <message>
        <source>Upward acceleration of air that is as hot as the source makes it; it fades as the air cools.</source>
        <translation>Acceleration uppåt hos luft som är så het som källan gör den; den avtar när luften svalnar.</translation>
    </message>
    <message>
        <source>How fast the heat that lifts the air is lost.</source>
        <translation>Hur snabbt värmen som lyfter luften går förlorad.</translation>
    </message>
    <message>
        <source>Wind drag</source>
        <translation>Vindmotstånd</translation>
    </message>
    <message>
        <source>The wind blows the air as fast as its acceleration over this, 0.5 at least: with 1 a wind of 2 m/s² is one of 2 m/s.</source>
        <translation>Vinden för luften så fort som sin acceleration delad med detta, minst 0,5: med 1 är en vind på 2 m/s² en på 2 m/s.</translation>
    </message>
    <message>
        <source>Obstacle position</source>
        <translation>Hindrets läge</translation>
    </message>
    <message>
        <source>Fire brightness</source>
        <translation>Eldens ljusstyrka</translation>
    </message>
    <message>
        <source>Flare</source>
        <translation>Utvidgning</translation>
    </message>
    <message>
        <source>Wind strength</source>
        <translation>Vindstyrka</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Källa</translation>
    </message>
    <message>
        <source>Mean rate at which the whole cloud turns about the vertical line through the emitter: from +X towards -Z, against the sense of the wind&apos;s angle. The emitter does not turn.</source>
        <translation>Medeltakt som hela molnet vrids med kring den lodräta linjen genom utsändaren: från +X mot -Z, mot vindvinkelns riktning. Utsändaren vrids inte.</translation>
    </message>
    <message>
        <source>Billows finer than the air: noise that rides on it, the same for all particles of a place. 0: none.</source>
        <translation>Bulor finare än luften: brus som följer med den, lika för alla partiklar på en plats. 0: inga.</translation>
    </message>
    <message>
        <source>Max and Becker 1995; Neyret, Advected Textures, 2003</source>
        <translation>Max och Becker 1995; Neyret, Advected Textures, 2003</translation>
    </message>
    <message>
        <source>Detail size</source>
        <translation>Detaljstorlek</translation>
    </message>
    <message>
        <source>Length of the largest billows of the detail; three octaves are finer. Five to six cells of the air.</source>
        <translation>Längden på detaljens största bulor; tre oktaver är finare. Fem till sex av luftens celler.</translation>
    </message>
    <message>
        <source>Detail life</source>
        <translation>Detaljens livslängd</translation>
    </message>
    <message>
        <source>How long the air carries a piece of detail before it is replaced: longer is steadier, until it is drawn out to hair. About 2 over the rate at which the air shears.</source>
        <translation>Hur länge luften bär en detalj innan den byts ut: längre är stadigare, tills den dras ut till hår. Ungefär 2 delat med luftens skjuvhastighet.</translation>
    </message>
    <message>
        <source>Detail relief</source>
        <translation>Detaljrelief</translation>
    </message>
    <message>
        <source>How much the detail catches the light.</source>
        <translation>Hur mycket detaljen fångar ljuset.</translation>
    </message>
    <message>
        <source>Detail at edges</source>
        <translation>Detalj i kanter</translation>
    </message>
    <message>
        <source>Share of the detail that thin smoke shows: 0 leaves veils soft, 1 cuts them as deep as dense smoke.</source>
        <translation>Andel av detaljen som tunn rök visar: 0 lämnar slöjor mjuka, 1 skär dem lika djupt som tät rök.</translation>
    </message>
    <message>
        <source>Detail shadow</source>
        <translation>Detaljskugga</translation>
    </message>
    <message>
        <source>How much the detail throws shadow into its own folds.</source>
        <translation>Hur mycket detaljen kastar skugga i sina egna veck.</translation>
    </message>
    <message>
        <source>Surge</source>
        <translation>Stötar</translation>
    </message>
    <message>
        <source>How much a steady source comes in puffs: its heat, speed and expansion swell and fall, each puff as strong as chance has it; the mean stays. 0: even.</source>
        <translation>Hur mycket en jämn källa kommer i puffar: värme, fart och expansion stiger och faller, varje puff så stark som slumpen vill; medelvärdet består. 0: jämnt.</translation>
    </message>
    <message>
        <source>Surge rate</source>
        <translation>Stötarnas takt</translation>
    </message>
    <message>
        <source>Puffs a second; in a loop a whole number of them. A fire puffs at about 1.5 Hz over the root of its width in metres.</source>
        <translation>Puffar per sekund; i en slinga ett helt antal. En eld puffar med ungefär 1,5 Hz delat med roten ur sin bredd i meter.</translation>
    </message>
    <message>
        <source>Cetegen and Ahmed 1993</source>
        <translation>Cetegen och Ahmed 1993</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Start</translation>
    </message>
    <message>
        <source>When the emission begins. What starts late is not prewarmed; in a loop it comes as much later.</source>
        <translation>När utsläppet börjar. Det som börjar sent är inte förvärmt; i en slinga kommer det så mycket senare.</translation>
    </message>
    <message>
        <source>How long smoke is emitted; in a loop, in each turn of it. 0: for ever. What ends is not prewarmed.</source>
        <translation>Hur länge rök släpps ut; i en slinga, i varje varv. 0: för alltid. Det som slutar är inte förvärmt.</translation>
    </message>
    <message>
        <source>In the air</source>
        <translation>I luften</translation>
    </message>
    <message>
        <source>Carried: particles are the air&apos;s, as smoke is. Dragged: they have a velocity of their own, which drag takes towards the air&apos;s, as embers and debris have. Free: no air touches them. What is dragged or free bounces off ground and obstacle.</source>
        <translation>Buren: partiklarna är luftens, som rök. Dragen: de har en egen fart, som motståndet drar mot luftens, som glöd och skräp. Fri: ingen luft rör dem. Det som är draget eller fritt studsar mot mark och hinder.</translation>
    </message>
    <message>
        <source>Bounce</source>
        <translation>Studs</translation>
    </message>
    <message>
        <source>Share of its speed with which a dragged or free particle leaves ground and obstacle again.</source>
        <translation>Andel av farten med vilken en dragen eller fri partikel lämnar mark och hinder igen.</translation>
    </message>
    <message>
        <source>Contact friction</source>
        <translation>Kontaktfriktion</translation>
    </message>
    <message>
        <source>Share of its speed along ground or obstacle that a dragged or free particle loses in each touch.</source>
        <translation>Andel av farten längs mark eller hinder som en dragen eller fri partikel förlorar vid varje beröring.</translation>
    </message>
    <message>
        <source>Feeds the air</source>
        <translation>Driver luften</translation>
    </message>
    <message>
        <source>Whether the emitter heats, pushes and stirs the air. Without it its particles only follow the air that others move: embers, dust, debris.</source>
        <translation>Om källan värmer, trycker och rör om luften. Utan det följer dess partiklar bara luften som andra rör: glöd, damm, skräp.</translation>
    </message>
    <message>
        <source>carried</source>
        <translation>buren</translation>
    </message>
    <message>
        <source>dragged</source>
        <translation>dragen</translation>
    </message>
    <message>
        <source>free</source>
        <translation>fri</translation>
    </message>
    <message>
        <source>Inherit velocity</source>
        <translation>Ärv hastighet</translation>
    </message>
    <message>
        <source>Of a layer whose particles are born on those of another: the share of their velocity that they take along. 0: a trail that stays where it was left. 1: what goes on with them.</source>
        <translation>För ett lager vars partiklar föds på ett annats: hur stor del av deras hastighet de tar med sig. 0: ett spår som blir kvar där det lämnades. 1: det som följer med dem.</translation>
    </message>
    <message>
        <source>Key frames: as they are at each frame</source>
        <translation>Nyckelbildrutor: som de är vid varje bildruta</translation>
    </message>
    <message>
        <source>Key frames: as they are at each step</source>
        <translation>Nyckelbildrutor: som de är vid varje steg</translation>
    </message>
    <message>
        <source>Key frames: as they are at a particle&apos;s birth</source>
        <translation>Nyckelbildrutor: som de är när en partikel föds</translation>
    </message>
    <message>
        <source>Key frames: summed up over time</source>
        <translation>Nyckelbildrutor: summerade över tid</translation>
    </message>
    <message>
        <source>Emission rate</source>
        <translation>Utsläppstakt</translation>
    </message>
    <message>
        <source>The share of the particles that are born: 1 all, 0 none. The source heats the air, and blows it up, as much less. With key frames it lets a fire be lit and go out.</source>
        <translation>Andelen av partiklarna som föds: 1 alla, 0 inga. Källan värmer luften, och blåser upp den, lika mycket mindre. Med nyckelbildrutor tänds och slocknar en eld.</translation>
    </message>
    <message>
        <source>Width of the rectangle or the picture, across its normal.</source>
        <translation>Rektangelns eller bildens bredd, tvärs sin normal.</translation>
    </message>
    <message>
        <source>Depth of the rectangle or the picture, across its normal and its width.</source>
        <translation>Rektangelns eller bildens djup, tvärs sin normal och sin bredd.</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>A PNG whose bright pixels give birth to particles, each as often as it is bright and opaque: a logo that burns. It lies on width and depth of the emitter, upright on a wall that faces +Z. Without one all of the rectangle does.</source>
        <translation>En PNG vars ljusa bildpunkter föder partiklar, var och en så ofta som den är ljus och täckande: en logotyp som brinner. Den ligger på emitterns bredd och djup, upprätt på en vägg som vetter mot +Z. Utan bild gör hela rektangeln det.</translation>
    </message>
    <message>
        <source>A soft round puff, the bare square of the 2012 model, or a picture.</source>
        <translation>En mjuk rund puff, den nakna kvadraten i 2012 års modell, eller en bild.</translation>
    </message>
    <message>
        <source>A PNG that particles look like, as leaves or debris: its alpha is their shape, its colours are multiplied with that of the smoke. It turns and stretches with them, its longer edge as wide as they are; noise, erosion, relief, roundness and detail do not show in it. Without one they are squares.</source>
        <translation>En PNG som partiklarna ser ut som, till exempel löv eller skräp: dess alfa är deras form, dess färger multipliceras med rökens. Den vrids och sträcks med dem, dess längre kant lika bred som de; brus, erosion, relief, rundhet och detalj syns inte i den. Utan bild är de kvadrater.</translation>
    </message>
    <message>
        <source>picture</source>
        <translation>bild</translation>
    </message>
    <message>
        <source>Parent&apos;s life from</source>
        <translation>Förälderns liv från</translation>
    </message>
    <message>
        <source>Of a layer whose particles are born on those of another: the share of a parent&apos;s life from which on they are. 0.9: near its death, as the stars of a firework&apos;s shell.</source>
        <translation>För ett lager vars partiklar föds på ett annats: den andel av en förälders liv från vilken de föds. 0.9: nära dess död, som stjärnorna ur ett fyrverkeri.</translation>
    </message>
    <message>
        <source>Parent&apos;s life to</source>
        <translation>Förälderns liv till</translation>
    </message>
    <message>
        <source>Of a layer whose particles are born on those of another: the share of a parent&apos;s life up to which they are. 0.1: while it is young.</source>
        <translation>För ett lager vars partiklar föds på ett annats: den andel av en förälders liv till vilken de föds. 0.1: medan den är ung.</translation>
    </message>
    <message>
        <source>Multiple scattering</source>
        <translation>Multipel spridning</translation>
    </message>
    <message>
        <source>Light that wanders through the smoke: folds light one another, and nothing that is white is black. 1: white as clouds and steam are. 0: every shadow stays as dark as it falls.</source>
        <translation>Ljus som vandrar genom röken: vecken lyser upp varandra, och inget som är vitt blir svart. 1: vitt som moln och ånga. 0: varje skugga förblir så mörk som den faller.</translation>
    </message>
    <message>
        <source>Stam 1995, multiple scattering as a diffusion process</source>
        <translation>Stam 1995, multipel spridning som diffusion</translation>
    </message>
    <message>
        <source>fluid solver simulation flow grid fire real realistic billow roll mushroom moving air</source>
        <translation>fluid strömning flöde simulering lösare rutnät eld verklig realistisk bolma rulla svamp</translation>
    </message>
    <message>
        <source>grid cells voxels divisions quality detail</source>
        <translation>rutnät celler rutor voxlar voxel indelning kvalitet detaljer finhet</translation>
    </message>
    <message>
        <source>auto automatic domain bounds box size</source>
        <translation>automatisk domän gränser låda ram storlek passa</translation>
    </message>
    <message>
        <source>domain bounds box width height depth</source>
        <translation>domän gränser låda bredd höjd djup mått utsträckning</translation>
    </message>
    <message>
        <source>domain position move box centre center</source>
        <translation>domän läge position flytta låda mitt centrum plats</translation>
    </message>
    <message>
        <source>rise lift tall high fast heat hot up float climb</source>
        <translation>stiga stiger lyfta hög högre snabb het hetta varm varmare uppåt flyta sväva klättra</translation>
    </message>
    <message>
        <source>heat cold temperature short low</source>
        <translation>värme svalna kall kallare kyla svalare temperatur kort kortare låg lägre</translation>
    </message>
    <message>
        <source>wind speed slow blow</source>
        <translation>vind fart hastighet långsam långsammare snabb blåsa bromsa luftmotstånd motstånd</translation>
    </message>
    <message>
        <source>confinement swirl curl turbulence detail curly vorticity</source>
        <translation>virvel virvlar snurra krusig krusning lockig turbulens detaljer skarp vorticitet</translation>
    </message>
    <message>
        <source>disturbance shredding force noise stir chaos break up spread billow rough wild</source>
        <translation>störning slita kraft brus röra kaos bryta upplösa sprida bolma orolig ojämn vild vildare</translation>
    </message>
    <message>
        <source>disturbance eddy swirl scale wavelength</source>
        <translation>störning virvel virvlar skala våglängd stor större liten mindre</translation>
    </message>
    <message>
        <source>floor collision plane</source>
        <translation>golv kollision plan yta botten underlag</translation>
    </message>
    <message>
        <source>floor level altitude</source>
        <translation>golv nivå altitud höjdläge</translation>
    </message>
    <message>
        <source>drag rough floor wall slip</source>
        <translation>motstånd sträv skrovlig golv vägg glida hal bromsa</translation>
    </message>
    <message>
        <source>collision collider body wall ceiling</source>
        <translation>kollision kropp vägg tak krock föremål objekt låda klot</translation>
    </message>
    <message>
        <source>collision place centre center obstacle</source>
        <translation>hinder kollision plats position mitt centrum flytta</translation>
    </message>
    <message>
        <source>collision width height depth diameter</source>
        <translation>hinder kollision bredd höjd djup diameter stor större liten mindre</translation>
    </message>
    <message>
        <source>orbit fixed free</source>
        <translation>kretsa bana runt fast fri kamera</translation>
    </message>
    <message>
        <source>turn orbit rotate angle azimuth heading</source>
        <translation>vrida rotera kretsa vinkel azimut kurs riktning sväng</translation>
    </message>
    <message>
        <source>tilt elevation angle above below</source>
        <translation>luta höjdvinkel elevation vinkel ovanifrån uppifrån underifrån nedifrån</translation>
    </message>
    <message>
        <source>zoom near far close dolly range</source>
        <translation>zoom zooma nära närmare långt längre bort avlägsen</translation>
    </message>
    <message>
        <source>look at pivot focus center</source>
        <translation>titta vridpunkt pivot fokus mittpunkt centrum sikte</translation>
    </message>
    <message>
        <source>turn spin rotate orbit</source>
        <translation>vrida snurra rotera kretsa runt rotation varv</translation>
    </message>
    <message>
        <source>place location move eye</source>
        <translation>plats position flytta placering öga</translation>
    </message>
    <message>
        <source>look direction aim</source>
        <translation>titta riktning sikta sikte håll vända</translation>
    </message>
    <message>
        <source>zoom lens wide field of view fov</source>
        <translation>zoom objektiv lins vidvinkel bildvinkel synfält vid smal tele fov</translation>
    </message>
    <message>
        <source>life duration lifespan age seconds long longer short shorter live last persist linger die</source>
        <translation>liv livstid varaktighet ålder sekunder lång längre kort kortare leva vara dröja dö försvinna</translation>
    </message>
    <message>
        <source>thick dense more number amount quantity density rate spawn</source>
        <translation>tjock tät antal fler mer tjockare tätare mängd partikel många densitet täthet få färre</translation>
    </message>
    <message>
        <source>birth spawn amount share on off fire lit goes out swell ignite extinguish</source>
        <translation>födelse föda takt mängd andel på av eld tända slockna släcka svälla emission</translation>
    </message>
    <message>
        <source>source form disc disk sphere rectangle picture image logo text mask</source>
        <translation>källa skiva disk klot sfär rektangel bild logotyp logga text mask figur</translation>
    </message>
    <message>
        <source>source wide narrow size diameter width</source>
        <translation>källa bred bredare smal smalare storlek diameter bredd stor större liten mindre</translation>
    </message>
    <message>
        <source>source size wide narrow</source>
        <translation>källa storlek bredare smal smalare stor större</translation>
    </message>
    <message>
        <source>size source length</source>
        <translation>storlek källa längd mått utsträckning</translation>
    </message>
    <message>
        <source>image logo text mask texture map bright pixels png file</source>
        <translation>logotyp logga text mask textur karta ljus bildpunkter pixlar pixel png fil foto</translation>
    </message>
    <message>
        <source>direction aim up orientation</source>
        <translation>riktning sikta uppåt orientering håll vända</translation>
    </message>
    <message>
        <source>place location source move origin path carry swing</source>
        <translation>plats position källa flytta ursprung bana väg bära svinga</translation>
    </message>
    <message>
        <source>velocity fast slow initial jet throw strong weak</source>
        <translation>hastighet snabb snabbare långsam långsammare begynnelsefart stråle kasta stark starkare svag svagare</translation>
    </message>
    <message>
        <source>random chaos jitter irregular uneven wild velocity randomness</source>
        <translation>slump slumpmässig kaos skakig oregelbunden ojämn vild vildare fart variation</translation>
    </message>
    <message>
        <source>wide narrow cone angle nozzle fan direction focused spread</source>
        <translation>bred bredare smal smalare kon vinkel munstycke solfjäder riktning samlad fokuserad</translation>
    </message>
    <message>
        <source>parent trail born on sub emitter take along throw</source>
        <translation>ärva förälder spår svans föds följa medfölja fart kasta</translation>
    </message>
    <message>
        <source>birth death dies end burst on death sub emitter age firework event</source>
        <translation>födelse död dör slut explosion brista föds subemitter ålder fyrverkeri händelse</translation>
    </message>
    <message>
        <source>birth death dies end burst on birth sub emitter age firework event</source>
        <translation>födelse död dör slut explosion brista föds subemitter ålder fyrverkeri händelse</translation>
    </message>
    <message>
        <source>burst explosion puff continuous once</source>
        <translation>puff explosion smäll stöt ständig kontinuerlig enstaka engång emission</translation>
    </message>
    <message>
        <source>burst explosion puff time</source>
        <translation>explosion utbrott stöt smäll tid varaktighet</translation>
    </message>
    <message>
        <source>delay begin time offset late when</source>
        <translation>fördröjning börja dröja tid förskjutning sen senare när vänta</translation>
    </message>
    <message>
        <source>end stop emit time</source>
        <translation>slut sluta stopp stoppa tid varaktighet upphöra utsläpp</translation>
    </message>
    <message>
        <source>smooth stream stripes bands birth between steps</source>
        <translation>jämn mjuk slät ström ränder band skivor födelse delsteg bildruta</translation>
    </message>
    <message>
        <source>random different another</source>
        <translation>slump slumpmässig annan annat annorlunda ny variant</translation>
    </message>
    <message>
        <source>flame fire glow burn heat hot incandescent emission flash</source>
        <translation>eld låga flamma lågor glöd brinna hetta het glödande emission sken blixt ljusare</translation>
    </message>
    <message>
        <source>fade glow flame fire smoky soot</source>
        <translation>tona svalna slockna kallna låga lågor eld rökig sot</translation>
    </message>
    <message>
        <source>center inside white hot fire flame</source>
        <translation>mitt centrum inre inuti vit vitglödande hetta eld låga</translation>
    </message>
    <message>
        <source>clear transparent soot additive fire</source>
        <translation>klar klarare genomskinlig sot additiv eld låga tät tätare tunn tunnare ogenomskinlig</translation>
    </message>
    <message>
        <source>flame glow bounce illuminate indirect lit light fire</source>
        <translation>låga lågor glöd studs belysa lysa upplyst indirekt belysning sken eld</translation>
    </message>
    <message>
        <source>blackbody color fire flame emission from</source>
        <translation>svartkropp färg eld låga lågor emission källa temperatur</translation>
    </message>
    <message>
        <source>heat kelvin hot cold fire blackbody red blue</source>
        <translation>hetta värme kelvin het varm kall eld svartkropp röd blå färgtemperatur</translation>
    </message>
    <message>
        <source>color colors fire flame ramp gradient green blue magic</source>
        <translation>färg eld låga lågor flamma övergång gradient ramp toning grön blå magi</translation>
    </message>
    <message>
        <source>fade vanish disappear dissolve fast slow lifetime life duration age lifespan out die</source>
        <translation>tona blekna försvinna upplösa avta snabb snabbare långsam långsammare livslängd varaktighet ålder dö</translation>
    </message>
    <message>
        <source>transparent transparency opacity density start</source>
        <translation>genomskinlig genomskinlighet opacitet täthet tät start börja begynnelse</translation>
    </message>
    <message>
        <source>life duration random variation lifespan lifetime variance</source>
        <translation>slump slumpmässig variation varaktighet ålder livstid spridning olika</translation>
    </message>
    <message>
        <source>grow shrink scale expansion curve</source>
        <translation>växa växer krympa skala expansion kurva större mindre svälla</translation>
    </message>
    <message>
        <source>fade in transparent transparency opacity curve</source>
        <translation>intoning tona genomskinlig genomskinlighet opacitet täthet kurva</translation>
    </message>
    <message>
        <source>sun angle lamp lighting</source>
        <translation>sol vinkel lampa belysning ljussättning håll</translation>
    </message>
    <message>
        <source>bright dark brightness sun strength dim light intensity flash lightning strobe</source>
        <translation>ljus ljusare mörk mörkare ljusstyrka sol styrka dämpa svag blixt åska stroboskop sken</translation>
    </message>
    <message>
        <source>dark self-shadow shade black absorption thick contrast</source>
        <translation>mörk mörkare självskugga svart absorption tjock tjockare kontrast dunkel</translation>
    </message>
    <message>
        <source>bright translucent soft milky white</source>
        <translation>genomlysande ljusare genomskinlig mjuk mjukare mjölkig vit vitare</translation>
    </message>
    <message>
        <source>diffuse diffusion white cloud steam snow bounce fill soft bright translucent subsurface black</source>
        <translation>diffus diffusion vit vitare moln ånga snö studs utfyllnad mjuk ljus ljusare genomlysande svart</translation>
    </message>
    <message>
        <source>forward back rim silver lining phase anisotropy</source>
        <translation>framåt bakåt kant kantljus silverkant fas motljus spridning gloria</translation>
    </message>
    <message>
        <source>fill sky brightness bright dark dim</source>
        <translation>utfyllnad fyllnadsljus himmel ljusstyrka ljus ljusare mörk mörkare dämpa</translation>
    </message>
    <message>
        <source>color sun tint warm cold</source>
        <translation>sol ton nyans varm varmare kall kallare kulör</translation>
    </message>
    <message>
        <source>color ambient blue above</source>
        <translation>färg omgivningsljus blå ovanifrån uppifrån ovan</translation>
    </message>
    <message>
        <source>color ambient bounce below floor</source>
        <translation>färg omgivningsljus studs underifrån nedifrån golv</translation>
    </message>
    <message>
        <source>ao ambient dark shade</source>
        <translation>ao omgivningsljus mörk mörkare skugga skymma</translation>
    </message>
    <message>
        <source>quality detail shadow grid voxels</source>
        <translation>kvalitet detaljer skugga skuggor rutnät voxlar voxel finhet</translation>
    </message>
    <message>
        <source>thick transparent thin dense mist fog haze density transparency thickness heavy faint alpha solid see-through</source>
        <translation>genomskinlig tjock tjockare tunn tunnare tät tätare dimma dis densitet opacitet svag alfa solid</translation>
    </message>
    <message>
        <source>big small large scale particle puff diameter tiny huge fat soft thick</source>
        <translation>stor större liten mindre skala partikel puff diameter pytteliten enorm jättestor fet mjuk tjock</translation>
    </message>
    <message>
        <source>color tint white black dark bright light albedo gray grey dirty</source>
        <translation>ton nyans vit svart mörk mörkare ljus ljusare albedo grå gråare smutsig kulör</translation>
    </message>
    <message>
        <source>color gradient tint ramp age</source>
        <translation>gradient övergång ton toning ramp ålder åldrande nyans skifta</translation>
    </message>
    <message>
        <source>sharp crisp cauliflower billow noise displacement upres wavelet advected texture focus folds</source>
        <translation>skarp skarpare blomkål bolma bulor brus förskjutning uppskalning wavelet textur fokus skärpa veck</translation>
    </message>
    <message>
        <source>scale wavelength billow noise frequency largest</source>
        <translation>storlek skala våglängd bolma bulor brus frekvens störst stor större liten mindre</translation>
    </message>
    <message>
        <source>regenerate advect dissolve hair boil time</source>
        <translation>förnya byta återskapa bära upplösa hår sjuda koka tid ålder</translation>
    </message>
    <message>
        <source>bump normal surface light plastic</source>
        <translation>relief bula bulor normal yta ljus plastisk upphöjd</translation>
    </message>
    <message>
        <source>thin wisps rim haze veil feather soft</source>
        <translation>tunn tunnare slingor slöja slöjor rand dis fjädrig mjuk mjukare</translation>
    </message>
    <message>
        <source>folds clefts depth occlusion self-shadow</source>
        <translation>skugga veck skrevor springor djup ocklusion självskugga mörk</translation>
    </message>
    <message>
        <source>detail noise holes transparent grain texture</source>
        <translation>detaljer brus hål genomskinlig korn kornig yta mönster</translation>
    </message>
    <message>
        <source>dissolve holes wispy ragged torn break up</source>
        <translation>upplösa hål slöjor trasig trasigare söndrig sönder bryta fransig</translation>
    </message>
    <message>
        <source>dissolve holes edge</source>
        <translation>upplösa mjuk mjukare hål kant övergång hård hårdare</translation>
    </message>
    <message>
        <source>soft hard edge crisp sharp blur feather rim smooth mist</source>
        <translation>mjuk mjukare hård hårdare kant skarp skarpare suddig oskärpa fjädrig rand slät jämn dimma</translation>
    </message>
    <message>
        <source>bump normal depth volume plastic</source>
        <translation>bula bulor normal djup volym plastisk upphöjd</translation>
    </message>
    <message>
        <source>ball round volume puffy fluffy shading</source>
        <translation>boll rund rundare klot volym puffig fluffig skuggning</translation>
    </message>
    <message>
        <source>random size variation variance</source>
        <translation>slump slumpmässig variation olika spridning stora små</translation>
    </message>
    <message>
        <source>thin mist expand density mass haze dilution</source>
        <translation>tunn tunnare utvidga växa densitet täthet massa dis späda avta dimma</translation>
    </message>
    <message>
        <source>dots grain lone haze merge blend grow neighbours smooth mist fog</source>
        <translation>prickar korn ensam dis smälta blanda växa grannar jämn mjuk dimma</translation>
    </message>
    <message>
        <source>soft particles depth fade floor foot cut intersection contact</source>
        <translation>mjuka partiklar djup tona golv fot snitt skärning kontakt</translation>
    </message>
    <message>
        <source>noise zoom tiling detail</source>
        <translation>skala brus zoom upprepning kakel detaljer storlek</translation>
    </message>
    <message>
        <source>boil animate evolve noise speed</source>
        <translation>sjuda koka animera utvecklas brus fart hastighet förändras</translation>
    </message>
    <message>
        <source>rotate angle random rotation variance</source>
        <translation>vrida vinkel slump slumpmässig variation rotera vridning</translation>
    </message>
    <message>
        <source>rotate rotation turn fast</source>
        <translation>snurra rotera rotation vrida vridning snabb snabbare</translation>
    </message>
    <message>
        <source>rotate random rotation spin variance</source>
        <translation>snurra rotera rotation slump slumpmässig variation vrida</translation>
    </message>
    <message>
        <source>rotate swirl billow</source>
        <translation>rulla rotera virvel virvla bolma vrida</translation>
    </message>
    <message>
        <source>ellipse anisotropic sheet curl strand flatten shear</source>
        <translation>ellips oval anisotrop skikt krusning tråd strimma platta skjuvning sträcka töja</translation>
    </message>
    <message>
        <source>relax relaxation round memory</source>
        <translation>avslappning relaxation återgå rund minne minnas tid</translation>
    </message>
    <message>
        <source>ellipse longest thinnest aspect ratio hair</source>
        <translation>gräns ellips längst tunnast proportion förhållande hår högst töjning</translation>
    </message>
    <message>
        <source>streak motion blur velocity long</source>
        <translation>strimma streck rörelseoskärpa sträcka töja lång längre fart hastighet avlång</translation>
    </message>
    <message>
        <source>flame fire hot transparent burn opacity heat</source>
        <translation>låga flamma eld het hetta genomskinlig brinna opacitet täthet varm</translation>
    </message>
    <message>
        <source>shape sprite square round mask picture image leaf debris</source>
        <translation>form sprite kvadrat fyrkant rund partikel bild löv skräp</translation>
    </message>
    <message>
        <source>image leaf leaves debris sprite texture map flake petal feather png file</source>
        <translation>löv blad skräp sprite textur karta flinga kronblad fjäder png fil foto</translation>
    </message>
    <message>
        <source>advect carried dragged inertia ballistic free heavy sparks embers debris collide</source>
        <translation>buren bära dragen släpa tröghet ballistisk fri tung tyngre gnistor glöd skräp kollidera studsa</translation>
    </message>
    <message>
        <source>restitution elastic rebound collision</source>
        <translation>studsa elastisk återstudsa kollision krock fjädrande</translation>
    </message>
    <message>
        <source>slide stick roll collision ground</source>
        <translation>friktion glida fastna rulla kollision mark golv</translation>
    </message>
    <message>
        <source>fall weight down heavy sink drop light</source>
        <translation>falla vikt nedåt tung tyngre sjunka släppa lätt lättare gravitation</translation>
    </message>
    <message>
        <source>friction slow air resistance damping brake calm</source>
        <translation>friktion långsam långsammare motstånd dämpning broms bromsa lugn lugnare</translation>
    </message>
    <message>
        <source>chaos jitter random noise irregular wild messy</source>
        <translation>kaos skakig slump brus oregelbunden vild vildare rörig orolig</translation>
    </message>
    <message>
        <source>random hot rise heat variance</source>
        <translation>slump slumpmässig het hetta stiga variation olika temperatur</translation>
    </message>
    <message>
        <source>attract inflow narrow thin column tight pull to axis</source>
        <translation>attrahera inflöde smal smalare tunn tunnare pelare samla ihop</translation>
    </message>
    <message>
        <source>spin turn swirl twist whirl</source>
        <translation>snurra vrida rotera virvel virvla tvinna</translation>
    </message>
    <message>
        <source>spin random</source>
        <translation>snurra slump slumpmässig skaka skakig vrida</translation>
    </message>
    <message>
        <source>weight heavy light</source>
        <translation>vikt tung tyngre lätt lättare tyngd</translation>
    </message>
    <message>
        <source>detail layers fractal levels fine</source>
        <translation>detaljer lager fraktal nivåer fin finare</translation>
    </message>
    <message>
        <source>sharp crisp contrast hard soft</source>
        <translation>skarp skarpare kontrast hård hårdare mjuk mjukare tydlig</translation>
    </message>
    <message>
        <source>frequency scale size coarse fine</source>
        <translation>frekvens skala storlek grov grövre fin finare</translation>
    </message>
    <message>
        <source>gain amplitude roughness detail</source>
        <translation>förstärkning amplitud skrovlighet detaljer grov styrka</translation>
    </message>
    <message>
        <source>threshold amount fill bias</source>
        <translation>tröskel gränsvärde fylla fyllning mängd förskjutning</translation>
    </message>
    <message>
        <source>distort bend domain swirl</source>
        <translation>förvränga förvrida böja vrida domän virvel skev</translation>
    </message>
    <message>
        <source>blur soft</source>
        <translation>oskärpa suddig mjuk mjukare jämn jämna slät</translation>
    </message>
    <message>
        <source>type perlin simplex value</source>
        <translation>typ sort perlin simplex värde brustyp</translation>
    </message>
    <message>
        <source>smooth linear cosine cubic</source>
        <translation>jämn mjuk utjämning linjär cosinus kosinus kubisk</translation>
    </message>
    <message>
        <source>frequency detail</source>
        <translation>frekvens detaljer finhet luckor oktaver</translation>
    </message>
    <message>
        <source>boil evolve third</source>
        <translation>sjuda koka utvecklas utveckling tredje axel</translation>
    </message>
    <message>
        <source>layers quality</source>
        <translation>lager kvalitet skivor antal</translation>
    </message>
    <message>
        <source>size pixels quality detail</source>
        <translation>storlek pixlar pixel bildpunkter kvalitet detaljer</translation>
    </message>
    <message>
        <source>resolution size pixels wide</source>
        <translation>upplösning storlek pixlar pixel bildpunkter bredare</translation>
    </message>
    <message>
        <source>resolution size pixels tall high</source>
        <translation>upplösning storlek pixlar pixel bildpunkter hög högre</translation>
    </message>
    <message>
        <source>draft final preview particles</source>
        <translation>utkast slutlig förhandsvisning partiklar grov fin snabb</translation>
    </message>
    <message>
        <source>antialias anti-aliasing smooth aa</source>
        <translation>kantutjämning utjämning jämn mjuk taggig aa</translation>
    </message>
    <message>
        <source>bright dark brightness gamma light dim flash</source>
        <translation>ljus ljusare mörk mörkare ljusstyrka gamma dämpa blixt</translation>
    </message>
    <message>
        <source>tone mapping filmic color management gamma</source>
        <translation>tonmappning film filmisk färghantering gamma tonkurva</translation>
    </message>
    <message>
        <source>transparent alpha backdrop</source>
        <translation>genomskinlig transparent alfa fond kuliss</translation>
    </message>
    <message>
        <source>color backdrop behind</source>
        <translation>färg fond bakom kulör kuliss</translation>
    </message>
    <message>
        <source>mushroom billow puff roll vortex</source>
        <translation>svamp bolma puff rulla virvel virvelring ring</translation>
    </message>
    <message>
        <source>rise velocity</source>
        <translation>stiga stiger hastighet fart uppåt lyfta</translation>
    </message>
    <message>
        <source>size</source>
        <translation>storlek stor större liten mindre diameter</translation>
    </message>
    <message>
        <source>grow expand widening</source>
        <translation>växa växer expandera vidga utvidga bredare</translation>
    </message>
    <message>
        <source>distance puffs rate</source>
        <translation>distans puffar takt mellanrum tätt glest</translation>
    </message>
    <message>
        <source>repeat trail followers</source>
        <translation>upprepa spår svans efterföljare följa</translation>
    </message>
    <message>
        <source>random irregular variance</source>
        <translation>slump slumpmässig oregelbunden ojämn olika</translation>
    </message>
    <message>
        <source>heat push drive passive emits heats influence follows</source>
        <translation>värme värma värmer trycka knuffa passiv påverka följer mata driva</translation>
    </message>
    <message>
        <source>irregular noise source asymmetry breathe flicker raggedness</source>
        <translation>oregelbunden brus källa asymmetri asymmetrisk andas flämta fladdra trasig fransig</translation>
    </message>
    <message>
        <source>billows cauliflower hot spots noise source asymmetry heterogeneous bald uneven heat</source>
        <translation>bolma bolmar blomkål heta fläckar brus källa asymmetri kal hetta varm</translation>
    </message>
    <message>
        <source>explosion blast pressure burst divergence big</source>
        <translation>explosion sprängning tryckvåg tryck smäll puff divergens expansion svälla stor större utvidga</translation>
    </message>
    <message>
        <source>puff pulse breathe flicker lull rhythm uneven speed burst pump throb</source>
        <translation>puff puls pulsera andas fladdra flämta vila rytm ojämn fart utbrott pumpa dunka</translation>
    </message>
    <message>
        <source>puff pulse frequency flicker rhythm puffing</source>
        <translation>puff puls pulsera frekvens fladdra flämta rytm tempo</translation>
    </message>
    <message>
        <source>duration frames end time long short</source>
        <translation>varaktighet bildrutor slut tid lång längre kort kortare</translation>
    </message>
    <message>
        <source>loop seamless repeat cycle tile endless forever</source>
        <translation>loop loopa upprepa cykel kakel oändlig evig skarvlös</translation>
    </message>
    <message>
        <source>preroll pre-roll warmup start warm</source>
        <translation>förvärma förvärmd uppvärmning start inkörning</translation>
    </message>
    <message>
        <source>fps speed fast slow playback</source>
        <translation>fps fart hastighet snabb snabbare långsam långsammare uppspelning bildrutor</translation>
    </message>
    <message>
        <source>substeps quality accuracy steps frame</source>
        <translation>delsteg kvalitet noggrannhet precision tidssteg</translation>
    </message>
    <message>
        <source>swirl chaos wild wavy turbulent messy calm curl noise rough smooth</source>
        <translation>virvel virvlar kaos vild vildare vågig turbulent rörig lugn lugnare brus orolig ojämn slät</translation>
    </message>
    <message>
        <source>swirl size eddies big small coarse fine</source>
        <translation>virvel virvlar storlek stor större liten mindre grov grövre fin finare</translation>
    </message>
    <message>
        <source>detail layers swirl fine</source>
        <translation>detaljer lager virvel virvlar fin finare</translation>
    </message>
    <message>
        <source>detail gain persistence</source>
        <translation>detaljer förstärkning persistens grov grövre sträv ojämn</translation>
    </message>
    <message>
        <source>speed change animate fast slow</source>
        <translation>fart hastighet förändring ändra animera snabb snabbare långsam långsammare utvecklas</translation>
    </message>
    <message>
        <source>delay start calm onset</source>
        <translation>fördröjning start börja lugn intoning tid</translation>
    </message>
    <message>
        <source>height taller high bigger larger</source>
        <translation>växa växer högre större stor bredare</translation>
    </message>
    <message>
        <source>rise move speed</source>
        <translation>stiga flytta fart hastighet uppåt driva</translation>
    </message>
    <message>
        <source>wavelet turbulence noise subgrid sub-grid small swirls</source>
        <translation>wavelet turbulens brus små virvlar virvel rutnät</translation>
    </message>
    <message>
        <source>tornado swirl twist spin whirl</source>
        <translation>tornado tromb virvel virvla snurra vrida tvinna rotera</translation>
    </message>
    <message>
        <source>tornado width size</source>
        <translation>tornado tromb bredd storlek bred smal diameter</translation>
    </message>
    <message>
        <source>tornado funnel cone grow expand widening</source>
        <translation>tornado tromb tratt kon växa expandera vidga bredare</translation>
    </message>
    <message>
        <source>tornado direction</source>
        <translation>tornado tromb riktning håll lutning</translation>
    </message>
    <message>
        <source>blow breeze force air sideways drift lean fast strong</source>
        <translation>vind blåsa bris blåst kraft luft sidled driva luta snabb stark starkare storm</translation>
    </message>
    <message>
        <source>direction blow heading</source>
        <translation>vind riktning vindriktning blåsa kurs håll vinkel</translation>
    </message>
    <message>
        <source>wind wander random breeze</source>
        <translation>vind vandra slump slumpmässig bris vindby kastvind</translation>
    </message>
    <message>
        <source>wind frequency</source>
        <translation>vind frekvens byar takt ofta</translation>
    </message>
    <message>
        <source>Time scale</source>
        <translation>Tidsskala</translation>
    </message>
    <message>
        <source>speed fast slow motion playback simulation faster slower tempo</source>
        <translation>hastighet snabb långsam slow motion uppspelning simulering snabbare långsammare tempo</translation>
    </message>
    <message>
        <source>Seconds of smoke in a second of film: 2 lets all of it happen twice as fast, 0.5 in slow motion. Key frames, start and length keep their frames.</source>
        <translation>Sekunder av röken i en sekund av filmen: 2 låter allt ske dubbelt så fort, 0,5 i slow motion. Nyckelbildrutor, start och längd behåller sina bildrutor.</translation>
    </message>
</context>
<context>
    <name>fumage::ui::PasteDialog</name>
    <message>
        <source>Paste parameters</source>
        <translation>Klistra in parametrar</translation>
    </message>
    <message>
        <source>Give %1 these parameters of “%2”:</source>
        <translation>Ge %1 dessa parametrar från ”%2”:</translation>
    </message>
    <message>
        <source>Paste</source>
        <translation>Klistra in</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Alla</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Inga</translation>
    </message>
</context>
<context>
    <name>fumage::ui::PictureChoices</name>
    <message>
        <source>Fit the camera to the smoke of all frames</source>
        <translation>Anpassa kameran till röken i alla bildrutor</translation>
    </message>
    <message>
        <source>Pictures are taken from where all smoke is seen and fills them; the view stays as it is</source>
        <translation>Bilderna tas därifrån all rök syns och fyller dem; vyn förblir som den är</translation>
    </message>
    <message>
        <source>Fumage then opens a picture as the preset that it was made of, at its frame</source>
        <translation>Fumage öppnar då en bild som den förinställning den gjordes av, vid dess bildruta</translation>
    </message>
    <message>
        <source>A file beside the others with what each of them shows: Verify, in the panel Exports, and fumage-cli verify then find those that are missing, broken or changed</source>
        <translation>En fil bredvid de andra med vad var och en av dem visar: Kontrollera, i panelen Exporter, och fumage-cli verify hittar sedan dem som saknas, är trasiga eller har ändrats</translation>
    </message>
    <message>
        <source>Embed the preset in pictures</source>
        <translation>Bädda in förinställningen i bilder</translation>
    </message>
    <message>
        <source>Write a manifest of checksums</source>
        <translation>Skriv ett manifest med kontrollsummor</translation>
    </message>
    <message>
        <source>Write a mask of each layer</source>
        <translation>Skriv en mask för varje lager</translation>
    </message>
    <message>
        <source>Channels of an EXR that say how much of each layer is seen: together they are its alpha</source>
        <translation>Kanaler i en EXR som säger hur mycket av varje lager som syns: tillsammans är de dess alfa</translation>
    </message>
    <message>
        <source>Ignore outliers</source>
        <translation>Bortse från ströpartiklar</translation>
    </message>
    <message>
        <source>How much of the smoke may be outside, such as stray sparks, so that the rest is larger</source>
        <translation>Hur mycket av röken som får hamna utanför, som enstaka gnistor, så att resten blir större</translation>
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
        <translation>Ta bort bilden</translation>
    </message>
    <message>
        <source>remove</source>
        <translation>ta bort</translation>
    </message>
    <message>
        <source>Press to choose a PNG, or drop one here</source>
        <translation>Tryck för att välja en PNG, eller släpp en här</translation>
    </message>
    <message>
        <source>Choose a picture</source>
        <translation>Välj en bild</translation>
    </message>
    <message>
        <source>Pictures (*.png)</source>
        <translation>Bilder (*.png)</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Välj…</translation>
    </message>
</context>
<context>
    <name>fumage::ui::PointStrip</name>
    <message>
        <source>Delete the point</source>
        <translation>Ta bort punkten</translation>
    </message>
</context>
<context>
    <name>fumage::ui::Preferences</name>
    <message>
        <source>Preferences</source>
        <translation>Inställningar</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Stäng</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>Tema</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Språk</translation>
    </message>
    <message>
        <source>The language changes when Fumage starts the next time.</source>
        <translation>Språket ändras nästa gång Fumage startar.</translation>
    </message>
    <message>
        <source>Mouse in the viewport</source>
        <translation>Musen i vyn</translation>
    </message>
    <message>
        <source>OpenGL</source>
        <translation>OpenGL</translation>
    </message>
    <message>
        <source>Where there is a graphics card</source>
        <translation>Där det finns ett grafikkort</translation>
    </message>
    <message>
        <source>Always</source>
        <translation>Alltid</translation>
    </message>
    <message>
        <source>Never</source>
        <translation>Aldrig</translation>
    </message>
    <message>
        <source>“Never” helps where the picture is black or torn. It takes effect when Fumage starts the next time.</source>
        <translation>”Aldrig” hjälper där bilden är svart eller sönderriven. Det gäller från nästa gång Fumage startar.</translation>
    </message>
    <message>
        <source>Memory for pictures</source>
        <translation>Minne för bilder</translation>
    </message>
    <message>
        <source> MB</source>
        <translation> MB</translation>
    </message>
    <message>
        <source>Frames that a window keeps to play them again at once. Simulation and air come on top.</source>
        <translation>Bildrutor som ett fönster behåller för att genast kunna spela dem igen. Simulering och luft tillkommer.</translation>
    </message>
    <message>
        <source>Show presets when Fumage starts</source>
        <translation>Visa förinställningar när Fumage startar</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Start</translation>
    </message>
    <message>
        <source>Show the folder</source>
        <translation>Visa mappen</translation>
    </message>
    <message>
        <source>Recovery</source>
        <translation>Återställning</translation>
    </message>
    <message>
        <source>A copy of unsaved work is kept a second after each change, and is opened again should the program end unexpectedly: %1</source>
        <translation>En kopia av osparat arbete sparas en sekund efter varje ändring och öppnas igen om programmet skulle ta slut oväntat: %1</translation>
    </message>
    <message>
        <source>Threads</source>
        <translation>Trådar</translation>
    </message>
    <message>
        <source>All (%1)</source>
        <translation>Alla (%1)</translation>
    </message>
    <message>
        <source>Fewer leave more of the processor to other programs. Results are the same.</source>
        <translation>Färre lämnar mer av processorn till andra program. Resultaten är desamma.</translation>
    </message>
    <message>
        <source>Thumbnails on the disk</source>
        <translation>Miniatyrer på disken</translation>
    </message>
    <message>
        <source> MB at most</source>
        <translation> MB högst</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Rensa</translation>
    </message>
    <message>
        <source>%1 now</source>
        <translation>%1 nu</translation>
    </message>
    <message>
        <source>Play thumbnails under the pointer</source>
        <translation>Spela miniatyrer under pekaren</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>Rörelse</translation>
    </message>
</context>
<context>
    <name>fumage::ui::PresetBrowser</name>
    <message>
        <source>Search presets</source>
        <translation>Sök förinställningar</translation>
    </message>
    <message>
        <source>Favourites only</source>
        <translation>Bara favoriter</translation>
    </message>
    <message>
        <source>Delete the preset</source>
        <translation>Ta bort förinställningen</translation>
    </message>
    <message>
        <source>Delete “%1”? The file goes to the trash.</source>
        <translation>Ta bort ”%1”? Filen hamnar i papperskorgen.</translation>
    </message>
    <message>
        <source>“%1” cannot be moved to the trash. Delete the file by hand.</source>
        <translation>”%1” kan inte flyttas till papperskorgen. Ta bort filen för hand.</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öppna</translation>
    </message>
    <message>
        <source>Apply to this document</source>
        <translation>Lägg in i detta dokument</translation>
    </message>
    <message>
        <source>No longer a favourite</source>
        <translation>Inte längre favorit</translation>
    </message>
    <message>
        <source>Make a favourite</source>
        <translation>Gör till favorit</translation>
    </message>
    <message>
        <source>Delete…</source>
        <translation>Ta bort…</translation>
    </message>
    <message>
        <source>Add its layers</source>
        <translation>Lägg till dess lager</translation>
    </message>
</context>
<context>
    <name>fumage::ui::PresetList</name>
    <message>
        <source>Presets</source>
        <translation>Förinställningar</translation>
    </message>
    <message>
        <source> (broken)</source>
        <translation> (trasig)</translation>
    </message>
    <message>
        <source>There are no favourites yet: the menu of a preset makes it one.</source>
        <translation>Det finns inga favoriter än: en förinställnings meny gör den till en.</translation>
    </message>
    <message>
        <source>No preset matches “%1”.</source>
        <translation>Ingen förinställning handlar om ”%1”.</translation>
    </message>
</context>
<context>
    <name>Presets</name>
    <message>
        <source>Campfire</source>
        <translation>Lägereld</translation>
    </message>
    <message>
        <source>Chimney</source>
        <translation>Skorsten</translation>
    </message>
    <message>
        <source>Grey smoke from a stack, bent by a steady wind.</source>
        <translation>Grå rök ur en skorsten, böjd av en stadig vind.</translation>
    </message>
    <message>
        <source>Cigarette</source>
        <translation>Cigarett</translation>
    </message>
    <message>
        <source>A thin thread of smoke that breaks into curls.</source>
        <translation>En tunn rökslinga som bryts upp i krullar.</translation>
    </message>
    <message>
        <source>Cloud</source>
        <translation>Moln</translation>
    </message>
    <message>
        <source>Coloured smoke</source>
        <translation>Färgad rök</translation>
    </message>
    <message>
        <source>A dense magenta canister, as at parades.</source>
        <translation>Tät magentafärgad rök ur en burk, som vid parader.</translation>
    </message>
    <message>
        <source>Default</source>
        <translation>Standard</translation>
    </message>
    <message>
        <source>What a new document shows: a white plume in a light breeze.</source>
        <translation>Det som ett nytt dokument visar: en vit rökpelare i lätt bris.</translation>
    </message>
    <message>
        <source>Dust</source>
        <translation>Damm</translation>
    </message>
    <message>
        <source>Explosion</source>
        <translation>Explosion</translation>
    </message>
    <message>
        <source>A fireball that rolls up into a dark mushroom.</source>
        <translation>Ett eldklot som rullar upp till en mörk svamp.</translation>
    </message>
    <message>
        <source>Ground fog</source>
        <translation>Markdimma</translation>
    </message>
    <message>
        <source>A low bank that creeps over the ground.</source>
        <translation>En låg bank som kryper över marken.</translation>
    </message>
    <message>
        <source>Magic</source>
        <translation>Magi</translation>
    </message>
    <message>
        <source>A glowing spiral that winds around its axis.</source>
        <translation>En glödande spiral som slingrar sig runt sin axel.</translation>
    </message>
    <message>
        <source>Plume</source>
        <translation>Rökpelare</translation>
    </message>
    <message>
        <source>A dense, billowing column of grey smoke, as from a great fire.</source>
        <translation>En tät, bolmande pelare av grå rök, som från en stor brand.</translation>
    </message>
    <message>
        <source>Steam</source>
        <translation>Ånga</translation>
    </message>
    <message>
        <source>White puffs from a vent, gone within a metre or two.</source>
        <translation>Vita puffar ur en ventil, borta inom någon meter.</translation>
    </message>
    <message>
        <source>Thesis 2012</source>
        <translation>Uppsatsen 2012</translation>
    </message>
    <message>
        <source>The model of the 2012 thesis as its equations say: 5000 particles on a plane, wind, gravity, fading, lattice noise.</source>
        <translation>Modellen i uppsatsen från 2012, precis som dess ekvationer: 5000 partiklar på ett plan, vind, tyngdkraft, uttoning, gitterbrus.</translation>
    </message>
    <message>
        <source>Tornado</source>
        <translation>Tromb</translation>
    </message>
    <message>
        <source>A funnel that tightens towards the ground.</source>
        <translation>En tratt som smalnar av mot marken.</translation>
    </message>
    <message>
        <source>Tyre fire</source>
        <translation>Däckbrand</translation>
    </message>
    <message>
        <source>Thick black smoke that billows from a hidden fire.</source>
        <translation>Tjock svart rök som väller fram ur en dold brand.</translation>
    </message>
    <message>
        <source>Volcano</source>
        <translation>Vulkan</translation>
    </message>
    <message>
        <source>A column of dark ash that boils up, spreads and leans with the wind.</source>
        <translation>En pelare av mörk aska som väller upp, breder ut sig och lutar med vinden.</translation>
    </message>
    <message>
        <source>Under a ceiling</source>
        <translation>Under ett tak</translation>
    </message>
    <message>
        <source>Smoke that rises to a ceiling, spreads out under it and rolls up along its edge.</source>
        <translation>Rök som stiger till ett tak, breder ut sig under det och rullar upp längs kanten.</translation>
    </message>
    <message>
        <source>Fire ball</source>
        <translation>Eldklot</translation>
    </message>
    <message>
        <source>Burning vapour that blows up into a ball, rolls over itself and burns out into black smoke.</source>
        <translation>Brinnande ånga som blåses upp till ett klot, rullar över sig själv och brinner ut i svart rök.</translation>
    </message>
    <message>
        <source>Landing</source>
        <translation>Landning</translation>
    </message>
    <message>
        <source>Dust that the blast of a landing presses to the ground: it runs outwards as a ring that rolls up.</source>
        <translation>Damm som stöten från en landning trycker mot marken: det löper utåt som en ring som rullar upp sig.</translation>
    </message>
    <message>
        <source>Mushroom cloud</source>
        <translation>Svampmoln</translation>
    </message>
    <message>
        <source>A ball of hot air that rises, turns inside out and draws a stem of smoke after it.</source>
        <translation>Ett klot av het luft som stiger, vänder ut och in på sig och drar en stam av rök efter sig.</translation>
    </message>
    <message>
        <source>Tongues of clear flame, and thin smoke above them.</source>
        <translation>Tungor av klar låga, och tunn rök ovanför dem.</translation>
    </message>
    <message>
        <source>A cumulus that grows from a flat base.</source>
        <translation>Ett stackmoln som växer från en plan bas.</translation>
    </message>
    <message>
        <source>What a blow on dry ground throws up.</source>
        <translation>Det som ett slag mot torr mark kastar upp.</translation>
    </message>
    <message>
        <source>Rolling dust</source>
        <translation>Rullande damm</translation>
    </message>
    <message>
        <source>A front of dust that rolls along the ground.</source>
        <translation>En dammfront som rullar fram över marken.</translation>
    </message>
    <message>
        <source>Fire whirl</source>
        <translation>Eldvirvel</translation>
    </message>
    <message>
        <source>A turning column of flame that its own wind twists and draws up.</source>
        <translation>En roterande pelare av lågor som dess egen vind vrider och drar uppåt.</translation>
    </message>
    <message>
        <source>Blast</source>
        <translation>Sprängning</translation>
    </message>
    <message>
        <source>Bonfire</source>
        <translation>Majbrasa</translation>
    </message>
    <message>
        <source>Flames, and embers that the heat carries up and lets fall.</source>
        <translation>Lågor, och glöd som hettan bär upp och låter falla.</translation>
    </message>
    <message>
        <source>Forge sparks</source>
        <translation>Smidesgnistor</translation>
    </message>
    <message>
        <source>Sparks that a blow throws from hot iron: they bounce, and burst into smaller ones.</source>
        <translation>Gnistor som ett slag kastar från hett järn: de studsar och spricker i mindre.</translation>
    </message>
    <message>
        <source>Sand impact</source>
        <translation>Nedslag i sand</translation>
    </message>
    <message>
        <source>What strikes sand: a crown of clods that trail it, grains that fall back, and the dust that stays.</source>
        <translation>Det som slår ner i sand: en krona av klumpar som drar sand efter sig, korn som faller tillbaka, och dammet som blir kvar.</translation>
    </message>
    <message>
        <source>Breath</source>
        <translation>Andedräkt</translation>
    </message>
    <message>
        <source>Breath in the cold, once in three seconds: rate and speed of the emission have key frames that repeat.</source>
        <translation>Andedräkt i kylan, en gång på tre sekunder: utsläppets takt och fart har nyckelbildrutor som upprepas.</translation>
    </message>
    <message>
        <source>Burning logo</source>
        <translation>Brinnande logotyp</translation>
    </message>
    <message>
        <source>Letters that burn: births are spread over the bright pixels of a picture that the preset holds.</source>
        <translation>Bokstäver som brinner: födslarna sprids över de ljusa bildpunkterna i en bild som förinställningen bär med sig.</translation>
    </message>
    <message>
        <source>Lit fire</source>
        <translation>Tänd eld</translation>
    </message>
    <message>
        <source>A fire that catches, burns, dies down and goes out: the share of the particles that are born, and the radius of the flames, have key frames.</source>
        <translation>En eld som tar sig, brinner, falnar och slocknar: andelen partiklar som föds, och lågornas radie, har nyckelbildrutor.</translation>
    </message>
    <message>
        <source>Missile</source>
        <translation>Missil</translation>
    </message>
    <message>
        <source>Torch</source>
        <translation>Fackla</translation>
    </message>
    <message>
        <source>Candle</source>
        <translation>Stearinljus</translation>
    </message>
    <message>
        <source>A small flame that stands still, and leans when the air moves.</source>
        <translation>En liten låga som står stilla och lutar när luften rör sig.</translation>
    </message>
    <message>
        <source>Dry ice</source>
        <translation>Torris</translation>
    </message>
    <message>
        <source>Firework</source>
        <translation>Fyrverkeri</translation>
    </message>
    <message>
        <source>Glitter</source>
        <translation>Glitter</translation>
    </message>
    <message>
        <source>Gusty chimney</source>
        <translation>Skorsten i byig vind</translation>
    </message>
    <message>
        <source>Smoke in a wind that swells and turns, seamless: strength and angle have key frames that repeat.</source>
        <translation>Rök i en vind som växer och vrider sig, sömlöst: styrka och vinkel har nyckelbildrutor som upprepas.</translation>
    </message>
    <message>
        <source>Rocket launch</source>
        <translation>Raketuppskjutning</translation>
    </message>
    <message>
        <source>A rocket that lifts off: its jet, the smoke that it leaves, and the cloud that runs out over the ground.</source>
        <translation>En raket som lyfter: dess stråle, röken som den lämnar och molnet som rinner ut över marken.</translation>
    </message>
    <message>
        <source>Spell</source>
        <translation>Trollformel</translation>
    </message>
    <message>
        <source>A fireball over a ring of dust, which throws out debris that trails smoke, and sparks that bounce.</source>
        <translation>Ett eldklot över en ring av damm, som kastar ut bråte som drar rök efter sig, och gnistor som studsar.</translation>
    </message>
    <message>
        <source>Cold fog that is poured out: it falls, runs out over the ground and curls up at its front.</source>
        <translation>Kall dimma som hälls ut: den faller, rinner ut över marken och rullar ihop sig vid sin front.</translation>
    </message>
    <message>
        <source>Shells that rise with a tail, and burst at their death into stars of two colours that trail and glitter.</source>
        <translation>Bomber som stiger med en svans och vid sin död brister i stjärnor av två färger som drar spår och glittrar.</translation>
    </message>
    <message>
        <source>Motes of light in three colours that drift apart, twinkle as stars and go out.</source>
        <translation>Ljuskorn i tre färger som glider isär, tindrar som stjärnor och slocknar.</translation>
    </message>
    <message>
        <source>A missile and its trail: its emitters are carried along one way, and turn with it.</source>
        <translation>En robot och dess spår: dess emittrar förs längs en väg och vrider sig med den.</translation>
    </message>
    <message>
        <source>Two strands of light that wind around each other, thick with glitter: stars, motes and sparks that twinkle.</source>
        <translation>Två ljusslingor som vindar sig runt varandra, fulla av glitter: stjärnor, korn och gnistor som tindrar.</translation>
    </message>
    <message>
        <source>A torch that is swung, seamless: all layers follow the same key frames of the position.</source>
        <translation>En fackla som svingas, sömlöst: alla lager följer samma nyckelbilder för positionen.</translation>
    </message>
</context>
<context>
    <name>fumage::ui::PreviewCanvas</name>
    <message>
        <source>Preview of the flipbook</source>
        <translation>Förhandsvisning av flipboken</translation>
    </message>
</context>
<context>
    <name>fumage::ui::PreviewPane</name>
    <message>
        <source>Between cells</source>
        <translation>Mellan rutor</translation>
    </message>
    <message>
        <source>What the engine does between two cells</source>
        <translation>Vad motorn gör mellan två rutor</translation>
    </message>
    <message>
        <source>No blending</source>
        <translation>Ingen övergång</translation>
    </message>
    <message>
        <source>Cross-fade</source>
        <translation>Övertoning</translation>
    </message>
    <message>
        <source>Background</source>
        <translation>Bakgrund</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Mörkt</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Ljust</translation>
    </message>
    <message>
        <source>Checkerboard</source>
        <translation>Schackruta</translation>
    </message>
    <message>
        <source>Rendering the cells: %1 %</source>
        <translation>Renderar rutorna: %1 %</translation>
    </message>
    <message>
        <source>Motion vectors</source>
        <translation>Rörelsevektorer</translation>
    </message>
    <message>
        <source>Rendering the cells…</source>
        <translation>Renderar rutorna…</translation>
    </message>
    <message>
        <source>%1 cells a second</source>
        <translation>%1 rutor i sekunden</translation>
    </message>
    <message>
        <source>%1 cells a second, shown at %2 × %3 pixels</source>
        <translation>%1 rutor i sekunden, visas i %2 × %3 bildpunkter</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>Förhandsvisning</translation>
    </message>
    <message>
        <source>Play as in the engine</source>
        <translation>Spela som i motorn</translation>
    </message>
</context>
<context>
    <name>QCommandLineParser</name>
    <message>
        <source>Usage: %1</source>
        <translation>Användning: %1</translation>
    </message>
    <message>
        <source>[options]</source>
        <translation>[flaggor]</translation>
    </message>
    <message>
        <source>Options:</source>
        <translation>Flaggor:</translation>
    </message>
    <message>
        <source>Arguments:</source>
        <translation>Argument:</translation>
    </message>
    <message>
        <source>Displays help on commandline options.</source>
        <translation>Visar hjälp om kommandoradens flaggor.</translation>
    </message>
    <message>
        <source>Displays help including Qt specific options.</source>
        <translation>Visar hjälp, också om Qt:s egna flaggor.</translation>
    </message>
    <message>
        <source>Displays version information.</source>
        <translation>Visar versionen.</translation>
    </message>
    <message>
        <source>Unknown option &apos;%1&apos;.</source>
        <translation>Okänd flagga ”%1”.</translation>
    </message>
    <message>
        <source>Unknown options: %1.</source>
        <translation>Okända flaggor: %1.</translation>
    </message>
    <message>
        <source>Missing value after &apos;%1&apos;.</source>
        <translation>Värde saknas efter ”%1”.</translation>
    </message>
    <message>
        <source>Unexpected value after &apos;%1&apos;.</source>
        <translation>Oväntat värde efter ”%1”.</translation>
    </message>
</context>
<context>
    <name>fumage::ui::QueuePanel</name>
    <message>
        <source>Exports</source>
        <translation>Exporter</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Starta</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Ta bort</translation>
    </message>
    <message>
        <source>Earlier</source>
        <translation>Tidigare</translation>
    </message>
    <message>
        <source>Later</source>
        <translation>Senare</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Byt namn</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Avbryt</translation>
    </message>
    <message>
        <source>Show in folder</source>
        <translation>Visa i mappen</translation>
    </message>
    <message>
        <source>Export again, with the smoke as it is now</source>
        <translation>Exportera igen, med röken som den är nu</translation>
    </message>
    <message>
        <source>Remove what has ended</source>
        <translation>Ta bort det som är avslutat</translation>
    </message>
    <message>
        <source>Save the list…</source>
        <translation>Spara listan…</translation>
    </message>
    <message>
        <source>Save what is not done as a list, which fumage-cli render --jobs does without a display</source>
        <translation>Spara det som inte är klart som en lista, som fumage-cli render --jobs gör utan skärm</translation>
    </message>
    <message>
        <source>Save the list of exports</source>
        <translation>Spara listan över exporter</translation>
    </message>
    <message>
        <source>Not finished when the program ended: %1</source>
        <translation>Inte färdiga när programmet avslutades: %1</translation>
    </message>
    <message>
        <source>Verify</source>
        <translation>Kontrollera</translation>
    </message>
    <message>
        <source>Verify: look whether the files are as they were written, where an export has a manifest</source>
        <translation>Kontrollera: se efter om filerna är som de skrevs, där en export har ett manifest</translation>
    </message>
</context>
<context>
    <name>fumage::ui::RangeRow</name>
    <message>
        <source>Frame</source>
        <translation>Bildruta</translation>
    </message>
    <message>
        <source>First frame</source>
        <translation>Första bildrutan</translation>
    </message>
    <message>
        <source>Last frame</source>
        <translation>Sista bildrutan</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Var så många bildrutor</translation>
    </message>
    <message>
        <source>to</source>
        <translation>till</translation>
    </message>
    <message>
        <source>every</source>
        <translation>var</translation>
    </message>
    <message>
        <source>the frame on the screen</source>
        <translation>bildrutan på skärmen</translation>
    </message>
    <message>
        <source>frame %1 is on the screen</source>
        <translation>bildruta %1 visas på skärmen</translation>
    </message>
</context>
<context>
    <name>Readout</name>
    <message>
        <source>%1 fps</source>
        <translation>%1 bilder/s</translation>
    </message>
    <message>
        <source>step %1 ms</source>
        <translation>steg %1 ms</translation>
    </message>
    <message>
        <source>light %1 ms</source>
        <translation>ljus %1 ms</translation>
    </message>
    <message>
        <source>composite %1 ms</source>
        <translation>bild %1 ms</translation>
    </message>
    <message>
        <source>coarse air</source>
        <translation>grov luft</translation>
    </message>
    <message>
        <source>air %1 s</source>
        <translation>luft %1 s</translation>
    </message>
    <message>
        <source>%1 particles</source>
        <translation>%1 partiklar</translation>
    </message>
</context>
<context>
    <name>fumage::ui::SeedEditor</name>
    <message>
        <source>dice</source>
        <translation>tärning</translation>
    </message>
    <message>
        <source>New seed: another smoke of the same kind</source>
        <translation>Kasta tärningen: ett annat frö, en annan rök av samma slag</translation>
    </message>
    <message>
        <source>lock</source>
        <translation>lås</translation>
    </message>
    <message>
        <source>Lock the seed, so that no slip of the hand changes the smoke</source>
        <translation>Lås fröet, så att ingen slinkande hand ändrar röken</translation>
    </message>
</context>
<context>
    <name>fumage::ui::Session</name>
    <message>
        <source>A copy of unsaved work cannot be read. It stays where it is: %1</source>
        <translation>En kopia av osparat arbete kan inte läsas. Den ligger kvar: %1</translation>
    </message>
    <message>
        <source>The program ended twice while it opened unsaved work. It stays where it is: %1</source>
        <translation>Programmet tog slut två gånger medan det öppnade osparat arbete. Arbetet ligger kvar: %1</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportera</translation>
    </message>
    <message>
        <source>Export failed: %1</source>
        <translation>Exporten misslyckades: %1</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Stäng</translation>
    </message>
    <message>
        <source>Exports</source>
        <translation>Exporter</translation>
    </message>
    <message>
        <source>Exports still running or waiting: %1</source>
        <translation>Exporter som inte är färdiga: %1</translation>
    </message>
    <message>
        <source>Finish in the background and close</source>
        <translation>Slutför i bakgrunden och stäng</translation>
    </message>
    <message>
        <source>Stop them and close</source>
        <translation>Stoppa dem och stäng</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Avbryt</translation>
    </message>
    <message>
        <source>A list of exports cannot be read. It stays where it is: %1</source>
        <translation>En lista över exporter kan inte läsas. Den ligger kvar: %1</translation>
    </message>
    <message>
        <source>Exports that were not finished when the program ended: %1. The panel Exports starts or removes them.</source>
        <translation>Exporter som inte var färdiga när programmet avslutades: %1. Panelen Exporter startar eller tar bort dem.</translation>
    </message>
    <message>
        <source>The list has no room for %1 more, which come when the program starts again.</source>
        <translation>Listan har inte plats för %1 till, som kommer när programmet startas nästa gång.</translation>
    </message>
</context>
<context>
    <name>fumage::ui::SheetFinder</name>
    <message>
        <source>Cancelled.</source>
        <translation>Avbrutet.</translation>
    </message>
    <message>
        <source>Trying sheets: %1 %</source>
        <translation>Provar ark: %1 %</translation>
    </message>
    <message>
        <source>Memory on the graphics card</source>
        <translation>Minne på grafikkortet</translation>
    </message>
    <message>
        <source>What all pictures of the flipbook may take there, as BC7</source>
        <translation>Vad flipbokens alla bilder får ta där, som BC7</translation>
    </message>
    <message>
        <source>Cancelled: the flipbook has changed.</source>
        <translation>Avbrutet: flipboken har ändrats.</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Avbryt</translation>
    </message>
    <message>
        <source>Trying sheets…</source>
        <translation>Provar ark…</translation>
    </message>
    <message>
        <source>Tries columns, rows and sizes of cells, and takes those that play nearest to the animation</source>
        <translation>Provar kolumner, rader och cellstorlekar och tar dem som spelas närmast animationen</translation>
    </message>
    <message>
        <source>%1 × %2 cells of %3 × %4 pixels, %5: %6 dB</source>
        <translation>%1 × %2 celler om %3 × %4 bildpunkter, %5: %6 dB</translation>
    </message>
    <message>
        <source> MiB</source>
        <translation> MiB</translation>
    </message>
    <message>
        <source>Fit to a memory budget</source>
        <translation>Anpassa till en minnesbudget</translation>
    </message>
    <message>
        <source>Optimise</source>
        <translation>Optimera</translation>
    </message>
</context>
<context>
    <name>fumage::ui::SoloLine</name>
    <message>
        <source>Solo</source>
        <translation>Solo</translation>
    </message>
    <message>
        <source>End solo</source>
        <translation>Avsluta solo</translation>
    </message>
    <message>
        <source>Show all layers again</source>
        <translation>Visa alla lager igen</translation>
    </message>
    <message>
        <source>%1 (muted)</source>
        <translation>%1 (tystat)</translation>
    </message>
    <message>
        <source>Solo: %1</source>
        <translation>Solo: %1</translation>
    </message>
    <message>
        <source>Solo: %1 layers</source>
        <translation>Solo: %1 lager</translation>
    </message>
</context>
<context>
    <name>fumage::ui::StartDialog</name>
    <message>
        <source>Show this when Fumage starts</source>
        <translation>Visa detta när Fumage startar</translation>
    </message>
    <message>
        <source>Start from a preset</source>
        <translation>Börja med en rök</translation>
    </message>
    <message>
        <source>Recent files</source>
        <translation>Senaste filer</translation>
    </message>
    <message>
        <source>Open a file…</source>
        <translation>Öppna en fil…</translation>
    </message>
    <message>
        <source>New smoke</source>
        <translation>Standardröken</translation>
    </message>
    <message>
        <source>Files that you open or save will be here</source>
        <translation>Filer som du öppnar eller sparar kommer att finnas här</translation>
    </message>
    <message>
        <source>Scenes and presets</source>
        <translation>Scener och förinställningar</translation>
    </message>
</context>
<context>
    <name>fumage::ui::SummaryRow</name>
    <message>
        <source>Solo is of the view only. Layers that are exported: %1.</source>
        <translation>Solo gäller bara vyn: %1 lager exporteras.</translation>
    </message>
    <message>
        <source>Mend key frames</source>
        <translation>Laga nyckelbildrutor</translation>
    </message>
    <message>
        <source>Moves key frames into the timeline, closes loops, and lets rates change smoothly: one undo step</source>
        <translation>Flyttar in nyckelbildrutor i tidslinjen, sluter slingor och låter takter ändras mjukt: ett ångrasteg</translation>
    </message>
</context>
<context>
    <name>fumage::ui::TimelineBar</name>
    <message>
        <source>Go to start (Home)</source>
        <translation>Till första bildrutan (Home)</translation>
    </message>
    <message>
        <source>Previous frame (Left)</source>
        <translation>En bildruta bakåt (Vänster)</translation>
    </message>
    <message>
        <source>Play or pause (Space)</source>
        <translation>Spela eller pausa (Blanksteg)</translation>
    </message>
    <message>
        <source>Next frame (Right)</source>
        <translation>En bildruta framåt (Höger)</translation>
    </message>
    <message>
        <source>Go to end (End)</source>
        <translation>Till sista bildrutan (End)</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>Bildruta</translation>
    </message>
    <message>
        <source>The frame that is shown</source>
        <translation>Bildrutan som visas</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Fart</translation>
    </message>
    <message>
        <source>Speed of playing</source>
        <translation>Uppspelningens fart</translation>
    </message>
    <message>
        <source>Frames per second</source>
        <translation>Bildrutor per sekund</translation>
    </message>
    <message>
        <source>Frames per second of the effect</source>
        <translation>Effektens bildrutor per sekund</translation>
    </message>
    <message>
        <source> fps</source>
        <translation> bilder/s</translation>
    </message>
    <message>
        <source> of %1</source>
        <translation> av %1</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>Repeat playback: start again after the last frame, whether it fits the first or not</source>
        <translation>Upprepa uppspelningen: börja om efter den sista bilden, vare sig den passar till den första eller inte</translation>
    </message>
    <message>
        <source>What there is no room for</source>
        <translation>Det som inte får plats</translation>
    </message>
    <message>
        <source>Show the curves of key frames in a graph (Shift+G)</source>
        <translation>Visa nyckelbildrutornas kurvor i ett diagram (Shift+G)</translation>
    </message>
</context>
<context>
    <name>fumage::ui::TimelineRuler</name>
    <message>
        <source>Timeline</source>
        <translation>Tidslinje</translation>
    </message>
    <message>
        <source>Drag to go to any frame; drag the ends of the bar to play a part</source>
        <translation>Dra för att gå till valfri bildruta; dra stapelns ändar för att spela en del</translation>
    </message>
    <message>
        <source>air %1 %</source>
        <translation>luft %1 %</translation>
    </message>
</context>
<context>
    <name>fumage::ui::Tour</name>
    <message>
        <source>Back</source>
        <translation>Bakåt</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Nästa</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Klar</translation>
    </message>
    <message>
        <source>Tour</source>
        <translation>Rundtur</translation>
    </message>
</context>
<context>
    <name>fumage::ui::VariationsPanel</name>
    <message>
        <source>The present smoke</source>
        <translation>Den nuvarande röken</translation>
    </message>
    <message>
        <source>Variation %1</source>
        <translation>Variation %1</translation>
    </message>
    <message>
        <source>The smoke as it is</source>
        <translation>Röken som den är</translation>
    </message>
    <message>
        <source>Click to adopt this variation</source>
        <translation>Klicka för att ta över variationen</translation>
    </message>
    <message>
        <source>Previous variation</source>
        <translation>Tillbaka till röken före denna</translation>
    </message>
    <message>
        <source>Other variations</source>
        <translation>Andra variationer</translation>
    </message>
    <message>
        <source>How far they differ</source>
        <translation>Hur mycket de skiljer sig</translation>
    </message>
    <message>
        <source>Subtle</source>
        <translation>Försiktigt</translation>
    </message>
    <message>
        <source>Wild</source>
        <translation>Vilt</translation>
    </message>
    <message>
        <source>Lock parameters in their context menu to keep them as they are.</source>
        <translation>Lås parametrar i deras sammanhangsmeny för att behålla dem som de är.</translation>
    </message>
    <message>
        <source>Locked parameters, which stay as they are: %1</source>
        <translation>Låsta parametrar, som förblir som de är: %1</translation>
    </message>
    <message>
        <source>Adopt a variation</source>
        <translation>Ta över en variation</translation>
    </message>
    <message>
        <source>Back from a variation</source>
        <translation>Tillbaka från en variation</translation>
    </message>
</context>
<context>
    <name>fumage::ui::ViewActions</name>
    <message>
        <source>Backdrop</source>
        <translation>Bakgrund</translation>
    </message>
</context>
<context>
    <name>fumage::ui::Viewport</name>
    <message>
        <source>Smoke</source>
        <translation>Rök</translation>
    </message>
    <message>
        <source>Auto-key</source>
        <translation>Autonyckel</translation>
    </message>
</context>
<context>
    <name>fumage::ui::ViewportInput</name>
    <message>
        <source>Move a key frame of the way</source>
        <translation>Flytta en nyckelbildruta på vägen</translation>
    </message>
</context>
<context>
    <name>WindowTour</name>
    <message>
        <source>This is the smoke. Drag in it to look from another side, and turn the wheel to come nearer.</source>
        <translation>Detta är röken. Dra i den för att se från en annan sida, och vrid på hjulet för att komma närmare.</translation>
    </message>
    <message>
        <source>These are its parameters. Drag a number sideways, or click it and type: the smoke follows at once. F1 explains the one under the mouse.</source>
        <translation>Detta är dess parametrar. Dra ett tal i sidled, eller klicka på det och skriv: röken följer genast. F1 förklarar den under musen.</translation>
    </message>
    <message>
        <source>This plays the smoke and holds it, as Space does. Drag in the timeline to go to another frame.</source>
        <translation>Detta spelar upp röken och stannar den, som blanksteg gör. Dra i tidslinjen för att gå till en annan bildruta.</translation>
    </message>
    <message>
        <source>The diamond sets a key frame: change the number at another frame, and it changes over time.</source>
        <translation>Romben sätter en nyckelbildruta: ändra talet vid en annan bildruta, så ändras det över tid.</translation>
    </message>
    <message>
        <source>This takes the smoke away: as a flipbook, an image sequence, a video or data for an engine. Help &gt; Tour shows all of this again.</source>
        <translation>Härifrån tar du med dig röken: som flipbook, bildsekvens, video eller data för en motor. Hjälp &gt; Rundtur visar allt detta igen.</translation>
    </message>
    <message>
        <source>This is the short way into a game: click your engine, and a flipbook that suits it is written, and plays on a mock ground beside what is to be done in the engine.</source>
        <translation>Detta är den korta vägen in i ett spel: klicka på din motor, så skrivs en flipbook som passar den, och spelas upp på en låtsasmark bredvid det som ska göras i motorn.</translation>
    </message>
</context>
<context>
    <name>fumage::ui::WorkLine</name>
    <message>
        <source>Work in progress</source>
        <translation>Pågående arbete</translation>
    </message>
    <message>
        <source>Stopped: a preview is shown</source>
        <translation>Stoppat: en förhandsvisning visas</translation>
    </message>
    <message>
        <source>Go on</source>
        <translation>Fortsätt</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Stoppa</translation>
    </message>
    <message>
        <source>Make the picture after all</source>
        <translation>Gör bilden ändå</translation>
    </message>
    <message>
        <source>Give this up; a preview stays, and playing goes on with it</source>
        <translation>Avbryt detta; en förhandsvisning stannar kvar, och uppspelningen fortsätter med den</translation>
    </message>
    <message>
        <source>Baking air</source>
        <translation>Bakar luft</translation>
    </message>
    <message>
        <source>Simulating particles</source>
        <translation>Simulerar partiklar</translation>
    </message>
    <message>
        <source>Lighting</source>
        <translation>Ljussätter</translation>
    </message>
    <message>
        <source>Painting</source>
        <translation>Målar</translation>
    </message>
    <message>
        <source>%1 %2 %</source>
        <translation>%1 %2 %</translation>
    </message>
    <message>
        <source>%1 %2 %, about %3 min</source>
        <translation>%1 %2 %, ungefär %3 min</translation>
    </message>
    <message>
        <source>%1 %2 %, about %3 s</source>
        <translation>%1 %2 %, ungefär %3 s</translation>
    </message>
</context>
<context>
    <name>main</name>
    <message>
        <source>An editor for smoke.</source>
        <translation>En redigerare för rök.</translation>
    </message>
    <message>
        <source>Presets to open, each in a window of its own.</source>
        <translation>Förinställningar att öppna, var och en i ett eget fönster.</translation>
    </message>
    <message>
        <source>Prints the keyboard shortcuts.</source>
        <translation>Skriver ut kortkommandona.</translation>
    </message>
</context>
</TS>
