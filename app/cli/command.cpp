#include "app/cli/command.h"

#include "core/system/file.h"
#include "core/system/path.h"
#include "core/base/text.h"
#include "core/effect/assignment.h"
#include "core/effect/parameter_table.h"
#include "core/effect/shown_table.h"
#include "core/scene/key_assignment.h"
#include "core/scene/key_table.h"
#include "core/scene/layer_assignment.h"
#include "core/scene/marker_assignment.h"
#include "core/effect/value.h"
#include "core/preset/picture_file.h"
#include "core/preset/preset_file.h"

#include <map>

namespace fumage::cli {

namespace {

/// An option for messages: a picture in base64 is longer than anybody reads.
std::string optionOf(const std::string& option, const std::string& assignment)
{
    constexpr std::size_t kLong = 400;
    constexpr std::size_t kShown = 60;
    return option + (assignment.size() > kLong ? assignment.substr(0, kShown) + "..." : assignment);
}

/// What is set and changes nothing, as the effect is now, is told: it may have been meant for another parameter.
void warnWhereItHasNoEffect(const std::string& assignment, const Scene& scene)
{
    const LayerAssignment part = layerAssignment(scene, assignment).value();
    const Effect effect = scene.effect(part.layer);
    const Parameter* parameter = findShownParameter(trimmed(part.assignment.substr(0, part.assignment.find('='))));
    if (parameter != nullptr && parameter->ofBorn && !parentOf(scene, part.layer)) {
        warn(optionOf("--set ", assignment) + ": has no effect on a layer that is born on no other");
    }
    if (parameter != nullptr && !isVisible(*parameter, effect)) {
        const Parameter& other = *findParameter(parameter->visible.key);
        warn(optionOf("--set ", assignment) + ": has no effect while " + std::string(other.key) + " is "
            + formatText(other, other.get(effect), true));
    }
}

/// Sets a parameter, of which a picture may be named by its file.
Result<bool> setInScene(Scene& scene, std::string_view text)
{
    const Result<std::string> read = withPictureRead(std::string(text));
    return read ? applyToScene(scene, read.value()) : Result<bool>(read.error());
}

/// Applies what an option says, as often as it was given.
Status applyAll(const std::string& option, const std::vector<std::string>& texts,
    Result<bool> (*apply)(Scene& scene, std::string_view text), Scene& scene)
{
    for (const std::string& text : texts) {
        const Result<bool> clamped = apply(scene, text);
        if (!clamped) {
            Error error = clamped.error();
            error.place = optionOf(option, text);
            return error;
        }
        if (clamped.value()) {
            warn(optionOf(option, text) + ": out of range, the nearest allowed value is used");
        }
    }
    return Done{};
}

/// animateScene(), where "key=@file.csv" stands for the key frames of a table.
Result<bool> animate(Scene& scene, std::string_view text)
{
    const Result<LayerAssignment> part = layerAssignment(scene, text);
    const std::size_t at = part ? part.value().assignment.find("=@") : std::string_view::npos;
    if (at == std::string_view::npos) {
        return animateScene(scene, text);
    }
    const std::string_view key = trimmed(part.value().assignment.substr(0, at));
    const Parameter* parameter = findParameter(key);
    if (parameter == nullptr) {
        return noParameter(key);
    }
    constexpr std::size_t kMaxTableBytes = std::size_t{4} << 20U;
    const std::string file(part.value().assignment.substr(at + 2));
    const Result<std::string> table = readFile(pathFrom(file), kMaxTableBytes);
    if (!table) {
        return table.error();
    }
    const Result<Track> track = parseKeyTable(*parameter, table.value(), scene.timeline.frameRate);
    if (!track) {
        Error error = track.error();
        error.message = error.place.empty() ? error.message : makeMessage("%1: %2", error.place, error.message);
        return error;
    }
    scene.tracksOf(*parameter, part.value().layer).set(track.value());
    return false;
}

Result<NamedPreset> load(const std::string& preset, const EffectOptions& options)
{
    const Result<PresetReading> reading = readPreset(preset);
    if (!reading) {
        return reading.error();
    }
    for (const Message& warning : reading.value().warnings) {
        warn(warning.text());
    }
    NamedPreset named{reading.value().preset, "smoke", {}, shownBy(reading.value())};
    if (preset != kStandardStream) {
        const Result<LibraryEntry> entry = findPreset(preset);
        named.name = entry ? entry.value().id : named.name;
        named.file = entry ? entry.value().path : named.file;
    }
    Scene& scene = named.preset.scene;
    if (Status status = applyAll("--set ", options.assignments, &setInScene, scene); !status) {
        return status.error();
    }
    if (Status status = applyAll("--animate ", options.animations, &animate, scene); !status) {
        return status.error();
    }
    if (Status status = applyAll("--marker ", options.markers, &markScene, scene); !status) {
        return status.error();
    }
    for (const std::string& assignment : options.assignments) {
        warnWhereItHasNoEffect(assignment, named.preset.scene);
    }
    return named;
}

/// Shows and mutes the layers that options name.
/// @param names none: the option was not given
Status choose(const char* option, const std::optional<std::string>& names,
    Status (*apply)(Scene& scene, std::string_view names), Scene& scene)
{
    Status status = names ? apply(scene, *names) : Status(Done{});
    if (status) {
        return status;
    }
    Error error = status.error();
    error.place = std::string(option) + (names->empty() ? "" : " ") + *names;
    return error;
}

/// Presets of one name in different folders would be written to the same files; so would "Fire" and "fire" on file
/// systems that ignore case.
Status refuseSameNames(const std::vector<NamedPreset>& presets)
{
    std::map<std::string, std::string> names; // by their small letters
    for (const NamedPreset& named : presets) {
        const auto [at, isNew] = names.emplace(inSmallLetters(named.name), named.name);
        if (!isNew) {
            return Error{ErrorCode::OutOfRange,
                at->second == named.name
                    ? makeMessage(
                        "two presets are called %1, and one's files would overwrite the other's", inQuotes(named.name))
                    : makeMessage("the names %1 and %2 are the same where case is ignored, and one's files would "
                                  "overwrite the other's",
                        inQuotes(at->second), inQuotes(named.name)),
                named.file.string(), makeMessage("Write them to different folders")};
        }
    }
    return Done{};
}

Status forAll(const std::vector<NamedPreset>& presets, const std::function<Status(const NamedPreset&)>& work)
{
    for (const NamedPreset& named : presets) {
        if (Status status = work(named); !status) {
            return status;
        }
    }
    return Done{};
}

} // namespace

ExitCode exitCodeOf(ErrorCode code)
{
    switch (code) {
    case ErrorCode::Cancelled: return kInterrupted;
    case ErrorCode::Mismatch: return kMismatch;
    case ErrorCode::DiskFull:
    case ErrorCode::OutOfMemory:
    case ErrorCode::ReadFailed:
    case ErrorCode::WriteFailed: return kTryAgain;
    case ErrorCode::NotUtf8:
    case ErrorCode::Syntax:
    case ErrorCode::TooDeep:
    case ErrorCode::TooLarge:
    case ErrorCode::WrongType:
    case ErrorCode::WrongVersion:
    case ErrorCode::NotFinite:
    case ErrorCode::UnknownKey:
    case ErrorCode::UnknownName:
    case ErrorCode::OutOfRange:
    case ErrorCode::WouldOverwrite: return kBadInput;
    default: return kFailure;
    }
}

void EffectOptions::addTo(CLI::App& command)
{
    command
        .add_option("preset", presets, "Presets: names (see 'fumage-cli presets'), JSON files, or - for standard input")
        ->required()
        ->type_name("PRESET")
        ->option_text("PRESET...");
    command
        .add_option("-s,--set", assignments,
            "Change a parameter, for example --set wind.strength=1.5, or of a layer --set embers/motion.drag=1; may be "
            "repeated")
        ->type_name("KEY=VALUE")
        ->take_all()
        ->allow_extra_args(false)
        ->option_text("KEY=VALUE");
    command
        .add_option("--animate", animations,
            "Let a parameter change over time: --animate \"emitter.rate=1:0; 2:1\", seconds and value of each key "
            "frame, and its ease (auto, linear, hold); after=loop repeats them; @FILE.csv reads seconds and "
            "values from a table; may be repeated")
        ->type_name("KEY=KEYFRAMES")
        ->take_all()
        ->allow_extra_args(false)
        ->option_text("KEY=KEYFRAMES");
    command
        .add_option("--marker", markers,
            "Name a moment of the timeline, of which games are told: --marker \"Boom=0.5\", its seconds, or several "
            "with ; between; --marker Boom= takes it out; may be repeated")
        ->type_name("NAME=SECONDS")
        ->take_all()
        ->allow_extra_args(false)
        ->option_text("NAME=SECONDS");
    // Functions: the library would take an empty text for none.
    command
        .add_option_function<std::string>(
            "--layers", [this](const std::string& names) { layers = names; },
            "Show these layers alone: names or numbers from 1, with commas between")
        ->type_name("LAYERS")
        ->option_text("LAYERS");
    command
        .add_option_function<std::string>(
            "--mute", [this](const std::string& names) { muted = names; }, "Leave these layers out")
        ->type_name("LAYERS")
        ->option_text("LAYERS");
}

Status EffectOptions::forEach(const std::string& output, const std::function<Status(const NamedPreset&)>& work) const
{
    const std::filesystem::path place = pathFrom(output);
    std::error_code missing;
    const bool isFolder = !place.has_filename() || std::filesystem::is_directory(place, missing);
    if (presets.size() > 1 && !isFolder) {
        return Error{ErrorCode::OutOfRange, makeMessage("several presets cannot be written to one file"), output,
            makeMessage("Name a folder, as in --output out/")};
    }
    const Result<std::vector<NamedPreset>> loaded = loadAll();
    if (!loaded) {
        return loaded.error();
    }
    if (Status status = refuseSameNames(loaded.value()); !status) {
        return status;
    }
    return forAll(loaded.value(), work);
}

Status EffectOptions::forEach(const std::function<Status(const NamedPreset&)>& work) const
{
    const Result<std::vector<NamedPreset>> loaded = loadAll();
    return loaded ? forAll(loaded.value(), work) : Status(loaded.error());
}

Result<std::vector<NamedPreset>> EffectOptions::loadAll() const
{
    std::vector<NamedPreset> loaded;
    for (const std::string& preset : presets) {
        Result<NamedPreset> named = load(preset, *this);
        if (!named) {
            return named.error();
        }
        Scene& scene = named.value().preset.scene;
        if (Status status = choose("--layers", layers, &showOnly, scene); !status) {
            return status.error();
        }
        if (Status status = choose("--mute", muted, &mute, scene); !status) {
            return status.error();
        }
        if (muted && scene.visibleLayers().empty()) {
            warn("--mute " + *muted + ": no layer is left, and nothing of " + inQuotes(named.value().name)
                + " is to be seen");
        }
        loaded.push_back(std::move(named).value());
    }
    return loaded;
}

void addJson(CLI::App& command, bool& asJson)
{
    command.add_flag("--json", asJson, "Answer in JSON, for programs to read");
}

Result<FrameRange> framesFor(const std::string& asked, const NamedPreset& named, ExportKind kind)
{
    return asked.empty() ? Result<FrameRange>(framesOf(kind, named.preset.scene.timeline, named.shown))
                         : parseFrameRange(asked);
}

Result<FrameRange> oneFrameFor(const std::string& asked, const NamedPreset& named)
{
    const int frame = named.shown.frame.value_or(0);
    return asked.empty() ? Result<FrameRange>(FrameRange{frame, frame, 1}) : parseFrameRange(asked);
}

Result<PresetReading> readPreset(const std::string& name)
{
    if (name != kStandardStream) {
        return loadPreset(name);
    }
    const Result<std::string> text = readStandardInput(kMaxPresetFileBytes);
    return text ? parsePreset(text.value(), "standard input") : text.error();
}

} // namespace fumage::cli
