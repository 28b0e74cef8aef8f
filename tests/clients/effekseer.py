#!/usr/bin/python3
"""Loads the project of `fumage-cli flipbook --for effekseer` with Effekseer's own code, and prints what it has read.

usage: effekseer.py <fumage-cli> <checkout of github.com/effekseer/Effekseer>
Needs mono-mcs and mono-runtime. Of the checkout Dev/Editor/EffekseerCore is read (tried with a2ff72e of July 2026). What loads a project is compiled as
it is; what exports, scripts and packs is left out, and the few newer words of C# that mcs does not know are put into older ones in a copy.
"""
import pathlib
import re
import subprocess
import sys
import tempfile

LEFT_OUT = ("Script/", "Exporter/", "Binary/", "IO/EfkPkg")

STUBS = """
namespace Effekseer.Binary {
    public enum ExporterVersion { Ver1500 = 1500, Ver1600 = 1600, Ver16Alpha1, Ver17 = 1700, Ver18 = 1800, Latest = 1800 }
    public class Exporter {
        public System.Collections.Generic.HashSet<string> UsedTextures, UsedNormalTextures, UsedDistortionTextures, Models, Sounds, Materials, Curves;
        public byte[] Export(params object[] all) { return null; }
    }
}
"""

LOADER = """
using System;
using Effekseer;
class Loader {
    static void Main(string[] files) {
        Core.Initialize();
        var root = Core.LoadFromFile(System.IO.Path.GetFullPath(files[0]));
        var node = (Effekseer.Data.Node)root.Children[0];
        var look = node.RendererCommonValues;
        var cells = look.UVAnimation.AnimationParams;
        var life = node.CommonValues;
        var place = node.LocationValues.Fixed.Location;
        var size = node.ScalingValues.Fixed.Scale;
        Console.WriteLine("children {0}", root.Children.Count);
        Console.WriteLine("name {0}", node.Name.Value);
        Console.WriteLine("texture {0}", look.ColorTexture.AbsolutePath);
        Console.WriteLine("look {0} {1} {2} zwrite={3}", look.AlphaBlend.Value, look.Filter.Value, look.Wrap.Value, look.ZWrite.Value);
        Console.WriteLine("uv {0} {1} {2}", look.UV.Value, cells.LoopType.Value, look.UVAnimation.FlipbookInterpolationType.Value);
        Console.WriteLine("cell {0} {1}", cells.Size.X.Value, cells.Size.Y.Value);
        Console.WriteLine("grid {0} {1}", cells.FrameCountX.Value, cells.FrameCountY.Value);
        Console.WriteLine("frames {0} {1}", cells.FrameLength.Value.Value, cells.FrameLength.Infinite.Value);
        Console.WriteLine("life {0} {1} dies={2}", life.Life.Min, life.Life.Max, life.RemoveWhenLifeIsExtinct.Value);
        Console.WriteLine("count {0} {1}", life.MaxGeneration.Value.Value, life.MaxGeneration.Infinite.Value);
        Console.WriteLine("drawn {0} {1}", node.DrawingValues.Type.Value, node.DrawingValues.Sprite.Billboard.Value);
        Console.WriteLine("place {0} {1} {2}", place.X.Value, place.Y.Value, place.Z.Value);
        Console.WriteLine("size {0} {1}", size.X.Value, size.Y.Value);
        Console.WriteLine("range {0} {1}", Core.StartFrame, Core.EndFrame);
    }
}
"""


def in_older_words(name, text):
    text = re.sub(r"^using [^;]*(IronPython|Microsoft\.Scripting|Newtonsoft|System\.Drawing)[^;]*;", "", text, flags=re.MULTILINE)
    text = re.sub(r"string language = [^;]*?switch\s*\{.*?\};", 'string language = "en";', text, flags=re.DOTALL)
    text = re.sub(r"(public|private|internal) ((?:readonly )?)([\w.<>]+) (\w+)(\s*\{ get;[^}]*\})? = new\(", r"\1 \2\3 \4\5 = new \3(", text)
    if name == "Utils/MaterialInformation.cs": # functions within functions, and JSON
        for head, words in ((r"GradientInformation\[\] LoadGradient\(\)", "Func<GradientInformation[]> LoadGradient = () =>"),
                (r"void SaveGradient\(GradientInformation\[\] infos\)", "Action<GradientInformation[]> SaveGradient = (infos) =>")):
            text = re.sub(rf"\n(\t+){head}\s*\n\1\{{(.*?)\n\1\}}", lambda found, words=words: f"\n{found[1]}{words}\n{found[1]}{{{found[2]}\n{found[1]}}};", text, flags=re.DOTALL)
        text = text.replace("public JObject EditorData", "public object EditorData").replace("JsonConvert.SerializeObject(EditorData)", '""')
        text = text.replace("EditorData = JsonConvert.DeserializeObject<JObject>(jsonText);", "")
    return text


def compile_loader(checkout, folder):
    root = pathlib.Path(checkout) / "Dev/Editor/EffekseerCore"
    sources = []
    for file in sorted(root.rglob("*.cs")):
        name = file.relative_to(root).as_posix()
        if not name.startswith(LEFT_OUT):
            sources.append(folder / name.replace("/", "_"))
            sources[-1].write_text(in_older_words(name, file.read_text(encoding="utf-8-sig")))
    for name, text in (("stubs.cs", STUBS), ("loader.cs", LOADER)):
        sources.append(folder / name)
        sources[-1].write_text(text)
    done = subprocess.run(["mcs", "-langversion:latest", "-unsafe", "-nowarn:0105,0108,0114,0168,0169,0219,0414,0618,0649", "-out:" + str(folder / "loader.exe"), *sources], capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(f"mcs does not take this checkout:\n{done.stderr[:3000]}")
    return folder / "loader.exe"


def check(cli, loader, folder, name, loop):
    settings = ["--size", "64x32", "--grid", "4x2", "--set", f"timeline.loop={loop}", "--set", "timeline.frame_rate=30", "--set", "emitter.count=500"]
    subprocess.run([cli, "--quiet", "flipbook", "thesis-2012", "--for", "effekseer", "--frames", "0-15", *settings, "--output", folder / f"{name}.png"], check=True)
    done = subprocess.run(["mono", loader, folder / f"{name}.efkproj"], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    read = dict(line.split(" ", 1) for line in done.stdout.splitlines())
    wanted = {"children": "1", "name": name, "texture": str(folder / f"{name}.png"), "look": "Blend Linear Clamp zwrite=False", "cell": "64 32", "grid": "4 2",
        "uv": f"Animation {'Loop' if loop == 'true' else 'Once'} Lerp", "frames": "4 False", "life": f"32 32 dies={loop != 'true'}", "count": "1 False",
        "drawn": "Sprite Billboard", "range": "0 32"}
    assert all(read[key] == value for key, value in wanted.items()), (read, wanted)
    assert all(float(number) > 0 for number in read["size"].split()), read
    print(f"{name}: {', '.join(read[key] for key in ('look', 'uv', 'frames', 'life', 'place', 'size'))}")


def main():
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name).resolve()
        (folder / "source").mkdir()
        loader = compile_loader(sys.argv[2], folder / "source")
        check(sys.argv[1], loader, folder, "fire", "true")
        check(sys.argv[1], loader, folder, "rök & <\"smoke\">'s", "false")


if __name__ == "__main__":
    main()
