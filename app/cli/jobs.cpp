#include "app/cli/jobs.h"

#include "app/cli/command.h"
#include "app/cli/json_answer.h"
#include "app/cli/picture_options.h"

#include "core/system/path.h"
#include "core/base/text.h"
#include "core/export/jobs/job_file.h"
#include "core/export/remarks.h"

#include <algorithm>
#include <iostream>

namespace fumage::cli {

namespace {

Result<std::vector<ExportJob>> load(const std::string& file)
{
    Result<JobsReading> reading = JobsReading();
    if (file == kStandardStream) {
        const Result<std::string> text = readStandardInput(kMaxJobsFileBytes);
        reading = text ? parseJobs(text.value(), "standard input") : text.error();
    } else {
        reading = readJobsFile(pathFrom(file));
    }
    if (!reading) {
        return reading.error();
    }
    for (const Message& warning : reading.value().warnings) {
        warn(warning.text());
    }
    const Status apart = checkJobs(reading.value().jobs);
    return apart ? Result<std::vector<ExportJob>>(std::move(reading).value().jobs) : apart.error();
}

/// One job of a list with what became of it, for programs.
nlohmann::ordered_json answerOf(const ExportJob& job, const Result<std::optional<Flipbook>>& done)
{
    nlohmann::ordered_json answer{{"name", job.name}, {"outcome", done ? "done" : "failed"}};
    if (!done) {
        answer["error"] = done.error().text();
        return answer;
    }
    const Written written = writtenBy(job.preset.scene, job.plan, done.value());
    answer["files"] = written.count;
    answer["first"] = written.first.string();
    answer["last"] = written.last.string();
    for (const Message& remark : remarksOn(job.preset.scene, job.plan)) {
        answer["remarks"].push_back(remark.text());
    }
    return answer;
}

} // namespace

Status doJobs(const std::string& file, bool asJson)
{
    const Result<std::vector<ExportJob>> jobs = load(file);
    if (!jobs) {
        return jobs.error();
    }
    const std::size_t total = jobs.value().size();
    std::vector<ErrorCode> failures;
    nlohmann::ordered_json answers = nlohmann::ordered_json::array();
    for (std::size_t i = 0; i < total; ++i) {
        const ExportJob& job = jobs.value()[i];
        const std::string name = printable(job.name);
        report("job " + std::to_string(i + 1) + " of " + std::to_string(total) + ": " + name);
        if (!job.refusal) {
            warnOf(job.preset.scene, job.plan);
        }
        const Result<std::optional<Flipbook>> done =
            exportWithBar(job.preset.scene, job.plan, [&](const Task& task) { return runJob(job, task); });
        if (!done && done.error().code == ErrorCode::Cancelled) {
            return done.error();
        }
        if (!done) {
            failures.push_back(done.error().code);
            std::cerr << "fumage-cli: " << name << ": " << printable(done.error().text()) << '\n';
        }
        answers.push_back(answerOf(job, done));
    }
    Status answered = asJson
        ? printJson({{"done", total - failures.size()}, {"failed", failures.size()}, {"jobs", answers}})
        : Status(Done{});
    if (!answered || failures.empty()) {
        return answered;
    }
    // As long as one cannot be mended by trying again, the list cannot.
    const auto lasting = std::ranges::find_if(failures, [](ErrorCode code) { return exitCodeOf(code) != kTryAgain; });
    const ErrorCode code = lasting == failures.end() ? failures.front() : *lasting;
    return Error{code, makeMessage("%1 of %2 jobs failed", failures.size(), total), file,
        makeMessage("Mend what is said above, and do them again")};
}

} // namespace fumage::cli
