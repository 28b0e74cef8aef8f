// Whatever the name of a file and of its markers: what is written for engines and farms has as many lines as for any
// other name, and holds of the name only what its language reads as that very name.

#include "tests/fuzz/expect.h"

#include "core/system/path.h"
#include "core/export/engines/engine_files.h"
#include "core/export/farm/farm.h"
#include "core/export/templates/language.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace {

using namespace fumage;

std::vector<std::string> textsFor(Engine engine, const std::string& name)
{
    static const Effect effect;
    EngineSheet sheet{effect, 4, 2, 15.0, false, styleFor(engine, ImageFormat::Png8), {}, {}};
    for (const Pass pass : {Pass::Colour, Pass::SixWayA, Pass::SixWayB, Pass::Motion}) {
        sheet.pictures.push_back(
            {pass, pathFrom(name + fileNameOf(pass) + ".png"), {}, pass == Pass::Colour, pass == Pass::Motion});
    }
    sheet.events = {{name, 0.25, 3}};
    return makeEngineFiles(engine, sheet);
}

std::ptrdiff_t linesOf(const std::string& text)
{
    return std::count(text.begin(), text.end(), '\n');
}

void checkLanguages(const std::string& name)
{
    for (const Language language : {Language::CSharp, Language::Python, Language::Json, Language::JavaScript,
             Language::Protobuf, Language::Xml, Language::Html}) {
        const std::string text = written(language, name);
        FUMAGE_EXPECT(std::all_of(text.begin(), text.end(),
            [](char c) { return c >= 0x20 && c < 0x7F && c != '"' && c != '\'' && c != '<' && c != '>'; }));
    }
    const std::string godot = written(Language::Godot, name);
    bool isEscaped = false;
    for (const char c : godot) {
        FUMAGE_EXPECT(static_cast<unsigned char>(c) >= 0x20 && (c != '"' || isEscaped));
        isEscaped = c == '\\' && !isEscaped;
    }
    FUMAGE_EXPECT(!isEscaped);
    FUMAGE_EXPECT(linesOf(written(Language::Shell, name)) == 0);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    std::string name(reinterpret_cast<const char*>(data), size);
    std::replace(name.begin(), name.end(), '\0', '0'); // which no name of a file has, nor '/'
    std::replace(name.begin(), name.end(), '/', '|');
    name += "x";
    checkLanguages(name);
    for (const Engine engine : {Engine::Unity, Engine::Unreal, Engine::Godot, Engine::Godot3, Engine::Effekseer,
             Engine::Defold, Engine::Web}) {
        const std::vector<std::string> plain = textsFor(engine, "plain");
        const std::vector<std::string> texts = textsFor(engine, name);
        for (std::size_t i = 0; i < texts.size(); ++i) {
            FUMAGE_EXPECT(linesOf(texts[i]) == linesOf(plain[i]));
        }
    }
    FarmJob job;
    job.folder = "/mnt";
    job.frames = {0, 9, 1};
    for (const Farm farm : kAllFarms) {
        job.name = job.output = "plain";
        const FarmFiles plain = makeFarmFiles(farm, job).value();
        job.name = job.output = name;
        const Result<FarmFiles> files = makeFarmFiles(farm, job);
        for (std::size_t i = 0; files && i < files.value().files.size(); ++i) {
            FUMAGE_EXPECT(linesOf(files.value().files[i].contents) == linesOf(plain.files[i].contents));
        }
    }
    return 0;
}
