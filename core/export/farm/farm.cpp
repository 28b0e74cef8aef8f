#include "core/export/farm/farm.h"

#include "core/base/embedded_file.h"
#include "core/base/path.h"
#include "core/base/text.h"
#include "core/export/farm/chunk.h"
#include "core/preset/json_tree.h"

#include <algorithm>
#include <cassert>
#include <span>

#include <kainjow/mustache.hpp>

namespace fumage {

extern const EmbeddedFile kFarmTemplates[];
extern const std::size_t kFarmTemplatesCount;

namespace {

using kainjow::mustache::data;
using kainjow::mustache::mustache;

using Words = std::vector<std::string>;

/// A word that a shell takes as it is.
std::string shellQuoted(const std::string& word)
{
    std::string out = "'";
    for (const char c : word) {
        out += c == '\'' ? "'\\''" : std::string(1, c);
    }
    return out + "'";
}

/// Words of a command line between spaces, each quoted.
template <class Quote>
std::string joined(const Words& words, const Quote& quote, const char* between)
{
    std::string out;
    for (const std::string& word : words) {
        out += (out.empty() ? "" : between) + quote(word);
    }
    return out;
}

/// A name on one line without what ends comments, quotes and options of a line.
std::string plainly(const std::string& name)
{
    constexpr std::size_t kMostBytes = 100; // Open Job Description takes 128 letters
    std::string out = printable(name);
    std::replace_if(
        out.begin(), out.end(), [](char c) { return std::string_view("\"'\\%{}<>*/").find(c) != std::string_view::npos; }, '_');
    std::size_t end = std::min(out.size(), kMostBytes);
    while (end < out.size() && (static_cast<unsigned char>(out[end]) & 0xc0U) == 0x80U) {
        --end; // not within a letter
    }
    return out.substr(0, end);
}

/// A name that no option is mistaken for.
std::string fromHere(const std::string& name)
{
    return "./" + name;
}

Words renderWordsOf(const FarmJob& job, const std::string& frames, const std::string& folder)
{
    Words words{"render", folder + presetFileOf(job), "--frames", frames, "--output", folder + job.output, "--skip-existing", "--manifest"};
    words.insert(words.end(), job.renderWords.begin(), job.renderWords.end());
    return words;
}

/// The words that join the frames, with files in the folder by their whole path.
Words joinWordsIn(const std::string& folder, const FarmJob& job)
{
    Words words = job.joinWords;
    std::for_each(words.begin(), words.end(), [&](std::string& word) { word = word.starts_with("./") ? folder + word.substr(2) : word; });
    return words;
}

/// Which characters of names a farm has no way to write.
Status checkNames(Farm farm, const FarmJob& job)
{
    const auto has = [&](std::string_view text) { return job.folder.generic_string().find(text) != std::string::npos || job.name.find(text) != std::string::npos || job.output.find(text) != std::string::npos; };
    std::vector<std::string_view> refused{std::string_view("\0", 1)};
    switch (farm) {
    case Farm::Slurm:
    case Farm::Flamenco: break;
    case Farm::OpenJd: refused = {"{{", "}}"}; break;
    case Farm::Deadline: refused = {"\"", "<", ">", "\n", "\r", "\\"}; break;
    }
    const auto found = std::find_if(refused.begin(), refused.end(), has);
    if (found == refused.end()) {
        return Done{};
    }
    return Error{ErrorCode::OutOfRange, said("%1 has no way to write %2 in the names of files", std::string(nameOf(farm)), inQuotes(*found)), (job.folder / pathFrom(job.output)).string(), said("Choose another name or folder")};
}

/// One of the farm's files.
std::filesystem::path fileOf(const FarmJob& job, std::string_view ending)
{
    return job.folder / pathFrom(job.name + std::string(ending));
}

data commonFacts(const FarmJob& job)
{
    data facts;
    facts.set("name", plainly(job.name));
    facts.set("first", std::to_string(job.frames.first));
    facts.set("last", std::to_string(job.frames.last));
    facts.set("step", std::to_string(job.frames.step));
    facts.set("stepped", job.frames.step > 1);
    facts.set("frames", textOf(job.frames));
    facts.set("count", std::to_string(job.frames.count()));
    facts.set("last_place", std::to_string(job.frames.count() - 1));
    facts.set("per_task", std::to_string(job.perTask));
    facts.set("last_task", std::to_string(taskCount(job.frames, job.perTask) - 1));
    facts.set("joins", !job.joinWords.empty());
    return facts;
}

std::string filled(std::string_view name, const data& facts)
{
    const EmbeddedFile* const found = findEmbedded({kFarmTemplates, kFarmTemplatesCount}, name);
    assert(found != nullptr);
    mustache text{std::string(found->contents)};
    text.set_custom_escape([](const std::string& value) { return value; }); // what is put in is quoted already
    assert(text.is_valid());
    return text.render(facts);
}

FarmFiles slurmFiles(const FarmJob& job)
{
    data facts = commonFacts(job);
    facts.set("folder", shellQuoted(job.folder.string()));
    Words before = renderWordsOf(job, {}, "./");
    const auto frames = std::find(before.begin(), before.end(), "--frames") + 1;
    const Words after(frames + 1, before.end());
    before.erase(frames, before.end());
    facts.set("before_frames", joined(before, shellQuoted, " "));
    facts.set("after_frames", joined(after, shellQuoted, " "));
    facts.set("join", joined(job.joinWords, shellQuoted, " "));
    const std::filesystem::path script = fileOf(job, ".slurm.sh");
    FarmFiles made{{{script, filled("slurm", facts)}}, "sbatch " + shellQuoted(script.string())};
    if (!job.joinWords.empty()) {
        const std::filesystem::path join = fileOf(job, ".join.slurm.sh");
        made.files.push_back({join, filled("slurm_join", facts)});
        made.submit = "sbatch --dependency=afterok:$(sbatch --parsable " + shellQuoted(script.string()) + ") " + shellQuoted(join.string());
    }
    return made;
}

FarmFiles openJdFiles(const FarmJob& job)
{
    const std::string folder = "{{Param.Folder}}/";
    data facts = commonFacts(job);
    facts.set("quoted_name", quoteJson(plainly(job.name)));
    Words words = renderWordsOf(job, "{{Task.Param.Frame}}", folder);
    words.insert(words.end(), {"--progress", "openjd"});
    facts.set("render", joined(words, quoteJson, ", "));
    facts.set("join", joined(joinWordsIn(folder, job), quoteJson, ", "));
    const std::filesystem::path path = fileOf(job, ".openjd.json");
    return {{{path, filled("openjd", facts)}}, "openjd run " + shellQuoted(path.string()) + " -p Folder=" + shellQuoted(job.folder.string())};
}

FarmFiles flamencoFiles(const FarmJob& job)
{
    const auto inFolder = [](const std::string& word) { return word.starts_with("./") ? "settings.folder + " + quoteJson(word.substr(1)) : quoteJson(word); };
    const auto listed = [&](const Words& words) { return joined(
                                                      words, [&](const std::string& word) { return word.empty() ? std::string("frames") : inFolder(word); }, ", "); };
    data facts = commonFacts(job);
    facts.set("quoted_name", quoteJson(plainly(job.name)));
    facts.set("folder", quoteJson(job.folder.string()));
    facts.set("render", listed(renderWordsOf(job, {}, "./")));
    facts.set("join", listed(job.joinWords));
    const std::filesystem::path path = fileOf(job, ".flamenco.js");
    return {{{path, filled("flamenco", facts)}}, "Copy " + shellQuoted(path.string()) + " to the folder \"scripts\" of the Flamenco Manager and choose the job type there"};
}

FarmFiles deadlineFiles(const FarmJob& job)
{
    const auto quoted = [](const std::string& word) { return word.find_first_of(" \t'") == std::string::npos ? word : "<QUOTE>" + word + "<QUOTE>"; };
    const std::string folder = (job.folder / "").generic_string(); // Deadline takes a backslash for itself
    data facts = commonFacts(job);
    facts.set("folder", shellQuoted(job.folder.generic_string()));
    facts.set("start", job.folder.generic_string());
    facts.set("render", joined(renderWordsOf(job, "<STARTFRAME>-<ENDFRAME>" + (job.frames.step > 1 ? ":" + std::to_string(job.frames.step) : std::string()), folder), quoted, " "));
    facts.set("join", joined(joinWordsIn(folder, job), quoted, " "));
    facts.set("job_file", shellQuoted(fromHere(job.name + ".deadline.job")));
    facts.set("plugin_file", shellQuoted(fromHere(job.name + ".deadline.plugin")));
    facts.set("join_job_file", shellQuoted(fromHere(job.name + ".join.deadline.job")));
    facts.set("join_plugin_file", shellQuoted(fromHere(job.name + ".join.deadline.plugin")));
    FarmFiles made{{{fileOf(job, ".deadline.sh"), filled("deadline_submit", facts)}, {fileOf(job, ".deadline.job"), filled("deadline_job", facts)}, {fileOf(job, ".deadline.plugin"), filled("deadline_plugin", facts)}},
        "bash " + shellQuoted(fileOf(job, ".deadline.sh").string())};
    if (!job.joinWords.empty()) {
        made.files.push_back({fileOf(job, ".join.deadline.job"), filled("deadline_join_job", facts)});
        made.files.push_back({fileOf(job, ".join.deadline.plugin"), filled("deadline_join_plugin", facts)});
    }
    return made;
}

} // namespace

std::string_view nameOf(Farm farm)
{
    switch (farm) {
    case Farm::Slurm: return "slurm";
    case Farm::OpenJd: return "openjd";
    case Farm::Flamenco: return "flamenco";
    case Farm::Deadline: return "deadline";
    }
    return {};
}

std::string presetFileOf(const FarmJob& job)
{
    return job.name + ".fumage.json";
}

Result<FarmFiles> makeFarmFiles(Farm farm, const FarmJob& job)
{
    if (Status status = checkNames(farm, job); !status) {
        return status.error();
    }
    switch (farm) {
    case Farm::Slurm: return slurmFiles(job);
    case Farm::OpenJd: return openJdFiles(job);
    case Farm::Flamenco: return flamencoFiles(job);
    case Farm::Deadline: return deadlineFiles(job);
    }
    return FarmFiles();
}

} // namespace fumage
