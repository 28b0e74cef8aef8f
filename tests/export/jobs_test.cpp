// Exports that wait: lists of them on the disk, and that no two write the same file.
#include "core/export/sheets/cell_frames.h"
#include "tests/helpers.h"

#include "core/system/environment.h"
#include "core/system/file.h"
#include "core/export/jobs/job_file.h"
#include "core/preset/preset_file.h"

#include <QDir>
#include <QTemporaryDir>

using namespace fumage;
using namespace fumage::tests;

namespace {

Preset smallPreset()
{
    Preset preset;
    preset.name = "Small \"one\"";
    preset.description = "röd\n煙";
    preset.scene = everythingOn();
    preset.scene.layers[0].emitter.count = 200;
    preset.scene.output.width = 24;
    preset.scene.output.height = 16;
    preset.scene.timeline.length = 12;
    preset.unknown = {{"motion", "from_the_future", "{\n \"a\": 1}"}};
    return preset;
}

/// A list of jobs as a person would write it, with a preset of which little is said.
std::string listOf(const std::string& members)
{
    return R"({"format": "fumage-jobs", "version": 1, "jobs": [{)" + members
        + R"(, "preset": {"format": "fumage-preset", "version": 1, "name": "p"}}]})";
}

} // namespace

class JobsTest : public QObject {
    Q_OBJECT

private slots:
    void init() { m_folder = std::make_unique<QTemporaryDir>(); }

    void aJobOfEveryKindIsReadAsItWasWritten()
    {
        std::vector<ExportJob> jobs;
        for (std::size_t kind = 0; kind < kExportKinds; ++kind) {
            jobs.push_back(jobFor(static_cast<ExportKind>(kind), "a.b/smoke-" + std::to_string(kind)));
        }
        ExportPlan& book = jobs[1].plan;
        book.flipbook.columns = 3;
        book.flipbook.rows = 5;
        book.flipbook.engine = Engine::Unreal;
        book.passes = {Pass::SixWayA, Pass::SixWayB, Pass::Motion};
        book.style = {SixWayLayout::RltBbf, VectorSigns::Unreal, true, NormalGreen::DirectX};
        book.flipbook.packs = {parsePack("masks=shadow,0,motion.r@1/4").value(), parsePack("own=depth").value()};
        book.flipbook.trim = true;
        book.flipbook.powerOfTwo = true;
        book.recording.manifest = "a.b/röd";
        book.flipbook.retime = parseRetime("[[0, 0], [0.3, 0.7], [1, 0.1]]").value();
        jobs[0].plan.passes = {Pass::Colour, Pass::Depth};
        jobs[0].plan.format = ImageFormat::ExrFloat;
        jobs[0].plan.project.reset();
        jobs[0].plan.recording = {"a.b/kept.manifest.json", true};
        jobs[2].plan.recording.manifest = "films.manifest.json"; // none is written of them
        jobs[2].plan.video.format = VideoFormat::WebM;
        jobs[2].plan.fitCamera = true;
        jobs[2].plan.video.repeat = Repeat::Once;
        jobs[2].plan.video.rate = FrameRate{24000, 1001};
        jobs[4].plan.noise.size = 48;
        jobs[4].plan.noise.depth = 0.3F;
        jobs[4].plan.format = ImageFormat::Tga;
        jobs[5].plan.particles = ParticleFormat::Ply;
        jobs[5].plan.up = UpAxis::Z;
        jobs[6].plan.volume.cells = 200;
        jobs[6].plan.volume.voxel = 0.02F;
        jobs[6].plan.up = UpAxis::Y;
        jobs[7].plan.air = AirFormat::Vf;

        for (ExportJob& job : jobs) {
            job.plan.output = withEnding(job.plan.output, fileEnding(job.plan));
        }

        const std::string text = formatJobs(jobs);
        const Result<JobsReading> reading = parseJobs(text);
        QVERIFY2(reading.ok(), reading.ok() ? "" : reading.error().text().c_str());
        QCOMPARE(reading.value().warnings.size(), jobs.size()); // of the key that this version does not know
        QCOMPARE(formatJobs(reading.value().jobs), text);

        const std::vector<ExportJob>& read = reading.value().jobs;
        QCOMPARE(read.size(), jobs.size());
        for (std::size_t i = 0; i < jobs.size(); ++i) {
            QCOMPARE(read[i].name, jobs[i].name);
            QCOMPARE(read[i].plan.kind, jobs[i].plan.kind);
            QCOMPARE(read[i].plan.output.string(), jobs[i].plan.output.string());
            QCOMPARE(read[i].plan.source.string(), std::string("/somewhere/mine.json"));
            QCOMPARE(formatPreset(read[i].preset), formatPreset(jobs[i].preset));
        }
        const ExportPlan& again = read[1].plan;
        QVERIFY(again.flipbook.columns == 3 && again.flipbook.rows == 5 && again.flipbook.engine == Engine::Unreal
            && again.passes == book.passes && again.flipbook.packs == book.flipbook.packs
            && again.flipbook.retime == book.flipbook.retime && again.flipbook.trim && again.flipbook.powerOfTwo);
        QVERIFY(again.style.layout == SixWayLayout::RltBbf && again.style.vectors == VectorSigns::Unreal
            && again.style.premultiplied && again.style.normals == NormalGreen::DirectX);
        QVERIFY(again.frames.first == 2 && again.frames.last == 9 && again.frames.step == 3);
        QVERIFY(read[0].plan.format == ImageFormat::ExrFloat && read[0].plan.passes.has(Pass::Depth)
            && !read[0].plan.project);
        QCOMPARE(read[0].plan.recording.manifest, jobs[0].plan.recording.manifest);
        QVERIFY(read[0].plan.recording.skipExisting && !again.recording.skipExisting);
        QCOMPARE(again.recording.manifest, book.recording.manifest);
        QVERIFY(read[2].plan.recording.manifest.empty());
        QVERIFY(read[2].plan.video.format == VideoFormat::WebM && read[2].plan.fitCamera && read[2].plan.project);
        QVERIFY(read[4].plan.noise.size == 48 && read[4].plan.noise.depth == 0.3F
            && read[4].plan.format == ImageFormat::Tga);
        QVERIFY(read[5].plan.particles == ParticleFormat::Ply && read[5].plan.up == UpAxis::Z);
        QVERIFY(read[2].plan.video.repeat == Repeat::Once && read[2].plan.video.rate == jobs[2].plan.video.rate
            && !read[0].plan.video.rate);
        QVERIFY(read[6].plan.volume.cells == 200 && read[6].plan.volume.voxel == 0.02F && read[6].plan.up == UpAxis::Y
            && !read[6].plan.project);
        QVERIFY(read[7].plan.air == AirFormat::Vf && !read[7].plan.up);
    }

    void aJobThatWasReadWritesTheSameFiles()
    {
        ExportJob job = jobFor(ExportKind::Flipbook, at("a/book"));
        job.plan.flipbook.columns = 2;
        job.plan.flipbook.rows = 1;
        job.plan.frames = {0, 5, 1};
        const Result<JobsReading> reading = parseJobs(formatJobs(std::span(&job, 1)));
        QVERIFY(reading.ok());
        ExportJob again = reading.value().jobs.front();
        again.plan.output = at("b/book.png");
        QVERIFY(runJob(job).ok());
        QVERIFY(runJob(again).ok());
        for (const char* file : {"book.png", "book.flipbook.json"}) {
            const Result<std::string> first = readFile(at(std::string("a/") + file), 1U << 20U);
            const Result<std::string> second = readFile(at(std::string("b/") + file), 1U << 20U);
            QVERIFY(first.ok() && second.ok() && first.value() == second.value());
        }
        // The pictures carry the preset of the job, whatever stood in the plan.
        const Result<PresetReading> carried = readPresetFile(at("b/book.png"));
        QVERIFY(carried.ok());
        QCOMPARE(carried.value().preset.name, job.preset.name);
    }

    void whatIsLeftOutIsAsTheCommandLineHasIt()
    {
        const Result<JobsReading> reading = parseJobs(listOf(R"("output": "out/a_##.exr")"));
        QVERIFY(reading.ok());
        const ExportJob& job = reading.value().jobs.front();
        QCOMPARE(job.name, std::string("a_##.exr"));
        QCOMPARE(job.plan.kind, ExportKind::Sequence);
        QCOMPARE(job.plan.format, ImageFormat::ExrHalf);
        QVERIFY(job.plan.project.has_value());
        QCOMPARE(job.plan.frames.last, Effect().timeline.length - 1);
        QVERIFY(job.plan.passes == PassSet{Pass::Colour});
        const Result<JobsReading> unreal =
            parseJobs(listOf(R"("output": "a.png", "kind": "flipbook", "engine": "unreal")"));
        QVERIFY(unreal.ok());
        QVERIFY(unreal.value().jobs.front().plan.passes == passesFor(Engine::Unreal));
        QCOMPARE(unreal.value().jobs.front().plan.style.vectors, VectorSigns::Unreal);
        QCOMPARE(parseJobs(listOf(R"("output": "a.webm", "kind": "video")")).value().jobs.front().plan.video.format,
            VideoFormat::WebM);
        QCOMPARE(parseJobs(listOf(R"("output": "a.ply", "kind": "particles")")).value().jobs.front().plan.particles,
            ParticleFormat::Ply);
    }

    void aPresetMayBeNamed()
    {
        const std::string preset = at("mine.json");
        QVERIFY(writePresetFile(preset, smallPreset()).ok());
        const Result<JobsReading> reading =
            parseJobs(R"({"format": "fumage-jobs", "version": 1, "jobs": [{"output": "a.png", "preset": ")" + preset
                + R"("}, {"output": "b.png", "preset": "campfire"}]})");
        QVERIFY(reading.ok());
        QCOMPARE(reading.value().jobs[0].preset.name, smallPreset().name);
        QCOMPARE(reading.value().jobs[0].plan.source.string(), preset); // so that nothing is written over it
        QVERIFY(reading.value().jobs[1].plan.source.empty());
    }

    void aPresetThatCannotBeReadIsOneJobsAffair()
    {
        QVERIFY(writeFileAtomically(at("broken.json"), "{\"format\": 3").ok());
        QVERIFY(writePresetFile(at("good.json"), smallPreset()).ok());
        const std::string list = R"({"format": "fumage-jobs", "version": 1, "jobs": [)"
                                 R"({"output": "a.png", "kind": "picture", "preset": "none.json"}, )"
                                 R"({"output": "b.png", "kind": "picture", "preset": "good.json"},
            {"output": "c.png", "kind": "picture", "preset": "broken.json"},
            {"output": "d.png", "kind": "picture", "preset": "campfir"}]})";
        const JobsReading reading = parseJobs(list, "list.json", at("")).value();
        const auto codeOf = [&](std::size_t i) {
            return reading.jobs.at(i).refusal ? std::optional(reading.jobs[i].refusal->code) : std::nullopt;
        };
        QVERIFY(codeOf(0) == ErrorCode::FileNotFound && !codeOf(1) && codeOf(2) == ErrorCode::Syntax
            && codeOf(3) == ErrorCode::UnknownName);
        QVERIFY(reading.jobs[3].refusal->text().find("campfire") != std::string::npos);
        for (const ExportJob& job : reading.jobs) {
            const Result<std::optional<Flipbook>> done = runJob(job);
            QCOMPARE(done.ok(), !job.refusal.has_value());
            QCOMPARE(QFile::exists(QString::fromStdString(job.plan.output.string())), done.ok());
        }
        // What cannot be done is not another thing when it is written and read again.
        const JobsReading again = parseJobs(formatJobs(reading.jobs), "list.json", at("")).value();
        QCOMPARE(formatJobs(again.jobs), formatJobs(reading.jobs));
        QVERIFY(again.jobs[0].refusal && !again.jobs[1].refusal && again.jobs[2].refusal && again.jobs[3].refusal);
    }

    void pathsOfAListBeginInItsFolder()
    {
        QVERIFY(QDir(m_folder->path()).mkpath(QStringLiteral("deep/out")));
        QVERIFY(writePresetFile(at("deep/my.json"), smallPreset()).ok());
        std::string list = R"({"format": "fumage-jobs", "version": 1, "jobs": [)";
        list += R"({"output": "out/a.png", "kind": "picture", "manifest": "out/a", "preset": "my.json"}, )";
        list += R"({"output": "../b.png", "kind": "picture", "preset": "./my.json"}, )";
        list += "{\"output\": \"" + at("c.png")
            + "\", \"kind\": \"picture\", \"preset\": \"campfire\", \"source\": \"my.json\"}, ";
        list += R"({"output": "~/d.png", "kind": "picture", "preset": "../deep/my.json"}]})";
        QVERIFY(writeFileAtomically(at("deep/list.json"), list).ok());
        const JobsReading reading = readJobsFile(at("deep/list.json")).value();
        const auto placeOf = [&](const std::filesystem::path& path) { return path.lexically_normal().string(); };
        QCOMPARE(placeOf(reading.jobs[0].plan.output), at("deep/out/a.png"));
        QCOMPARE(placeOf(reading.jobs[0].plan.recording.manifest), at("deep/out/a"));
        QCOMPARE(placeOf(reading.jobs[0].plan.source), at("deep/my.json"));
        QCOMPARE(placeOf(reading.jobs[1].plan.output), at("b.png"));
        QCOMPARE(placeOf(reading.jobs[2].plan.output), at("c.png"));
        QCOMPARE(placeOf(reading.jobs[2].plan.source), at("deep/my.json"));
        QCOMPARE(placeOf(reading.jobs[3].plan.output), placeOf(userHome() / "d.png"));
        for (const ExportJob& job : reading.jobs) {
            QVERIFY(!job.refusal);
        }
    }

    void badListsAreRefusedWithTheirPlace_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<int>("code");
        QTest::addColumn<QByteArray>("says");
        const auto row = [](const char* name, const std::string& text, ErrorCode code, const char* says) {
            QTest::newRow(name) << QByteArray::fromStdString(text) << static_cast<int>(code) << QByteArray(says);
        };
        row("empty", "", ErrorCode::Syntax, "list.json, line 1, column 1");
        row("a preset", R"({"format": "fumage-preset"})", ErrorCode::WrongType, "fumage-jobs");
        row("version of tomorrow", R"({"format": "fumage-jobs", "version": 2, "jobs": []})", ErrorCode::WrongVersion,
            "newer");
        row("no list", R"({"format": "fumage-jobs", "version": 1, "jobs": {}})", ErrorCode::WrongType,
            "jobs: expected a list");
        row("a job that is none", R"({"format": "fumage-jobs", "version": 1, "jobs": [3]})", ErrorCode::WrongType,
            "line 1, column 50");
        row("a slip", listOf("\"output\": \"a.png\",\n \"colums\": 4"), ErrorCode::UnknownKey,
            "list.json, line 2, column 12: a job has no \"colums\". Did you mean \"columns\"?");
        row("no output", listOf(R"("name": "x")"), ErrorCode::WrongType, "\"x\" names no file");
        for (const char* name : {".", "..", "a/..", "...", " . "}) {
            row(name, listOf("\"output\": \"" + std::string(name) + "\""), ErrorCode::WrongType, "names no file");
        }
        row("a folder", listOf(R"("output": "a/")"), ErrorCode::WrongType, "names no file");
        row("a zero byte", listOf(R"("output": "/home/me/.profile\u0000.png")"), ErrorCode::Syntax,
            "output: there is a zero byte");
        row("a path without end", listOf(R"("output": ")" + std::string(5000, 'a') + R"(")"), ErrorCode::TooLarge,
            "4096");
        row("kind", listOf(R"("output": "a.png", "kind": "flipbok")"), ErrorCode::UnknownName,
            "kind: \"flipbok\" is not known here. Choose from sequence, flipbook");
        row("format of another kind", listOf(R"("output": "a", "kind": "video", "format": "png")"),
            ErrorCode::UnknownName, "webm");
        row("format of volumes", listOf(R"("output": "a", "kind": "volumes", "format": "png")"), ErrorCode::UnknownName,
            "Choose from vdb");
        row("cells of volumes", listOf(R"("output": "a", "kind": "volumes", "cells": 4)"), ErrorCode::OutOfRange,
            "cells: expected a whole number from 8 to 256");
        row("no axis", listOf(R"("output": "a", "kind": "volumes", "up": "x")"), ErrorCode::UnknownName,
            "Choose from y, z");
        row("frames", listOf(R"("output": "a", "frames": "0-2000000")"), ErrorCode::OutOfRange, "frames: ");
        row("columns", listOf(R"("output": "a", "columns": 65)"), ErrorCode::OutOfRange,
            "columns: expected a whole number from 1 to 64");
        row("half a row", listOf(R"("output": "a", "rows": 1.5)"), ErrorCode::OutOfRange, "rows: ");
        row("a huge number", listOf(R"("output": "a", "noise_size": 1e300)"), ErrorCode::OutOfRange, "noise_size: ");
        row("not a flag", listOf(R"("output": "a", "trim": 1)"), ErrorCode::WrongType, "true or false");
        row("pack", listOf(R"("output": "a", "packs": ["a=b"])"), ErrorCode::UnknownName, "packs: there is no channel");
        row("six packs", listOf(R"("output": "a", "packs": ["a=0", "b=0", "c=0", "d=0", "e=0", "f=0"])"),
            ErrorCode::WrongType, "up to 5");
        row("retime", listOf(R"("output": "a", "retime": [[0, 3]])"), ErrorCode::OutOfRange, "retime: ");
        row("no preset", R"({"format": "fumage-jobs", "version": 1, "jobs": [{"output": "a"}]})", ErrorCode::WrongType,
            "has no preset");
        row("bad preset",
            "{\"format\": \"fumage-jobs\", \"version\": 1, \"jobs\": [{\"output\": \"a\",\n\"preset\": {\"format\": "
            "\"fumage-preset\",\n \"version\": 1, \"motion\": 3}}]}",
            ErrorCode::WrongType, "list.json, line 3, column 26");
        row("too deep", std::string(100, '['), ErrorCode::TooDeep, "nested");
        row("too large", std::string(kMaxJobsBytes + 1, ' '), ErrorCode::TooLarge, "at most 4194304");
        std::string many;
        for (std::size_t i = 0; i <= kMaxJobs; ++i) {
            many += i == 0 ? "1" : ",1";
        }
        row("too many", R"({"format": "fumage-jobs", "version": 1, "jobs": [)" + many + "]}", ErrorCode::TooLarge,
            "at most 256");
    }
    void badListsAreRefusedWithTheirPlace()
    {
        QFETCH(QByteArray, text);
        QFETCH(int, code);
        QFETCH(QByteArray, says);
        const Result<JobsReading> reading = parseJobs(text.toStdString(), "list.json");
        QVERIFY(!reading.ok());
        const QByteArray said = QByteArray::fromStdString(reading.error().text());
        QVERIFY2(said.contains(says), said.constData());
        QCOMPARE(static_cast<int>(reading.error().code), code);
    }

    void everyPrefixOfAListIsReadOrRefused()
    {
        const ExportJob job = jobFor(ExportKind::Flipbook, "a");
        const std::string text = formatJobs(std::span(&job, 1));
        for (std::size_t length = 0; length < text.size(); ++length) {
            const Result<JobsReading> reading = parseJobs(std::string_view(text).substr(0, length));
            QVERIFY(reading.ok() == (length == text.size() - 1)); // but for the last line's end
        }
    }

    void warningsOfManyJobsAreFew()
    {
        ExportJob job = jobFor(ExportKind::Picture, "a");
        for (int i = 0; i < 100; ++i) {
            job.preset.unknown.push_back({"", "unknown" + std::to_string(i), "1"});
        }
        const std::vector<ExportJob> jobs(40, job);
        const Result<JobsReading> reading = parseJobs(formatJobs(jobs));
        QVERIFY(reading.ok());
        QVERIFY(reading.value().warnings.size() <= 20 + jobs.size());
    }

    void noTwoJobsWriteTheSameFile_data()
    {
        QTest::addColumn<int>("kind");
        QTest::addColumn<QString>("output");
        QTest::addColumn<bool>("collides");
        const auto row = [](const char* name, ExportKind kind, const char* output, bool collides) {
            QTest::newRow(name) << static_cast<int>(kind) << QString::fromLatin1(output) << collides;
        };
        row("the same sequence", ExportKind::Sequence, "a_##.png", true);
        row("one frame of it", ExportKind::Picture, "a_05", true);
        row("a frame that it leaves out", ExportKind::Picture, "a_04", false);
        row("by another way", ExportKind::Sequence, "sub/../a_##.png", true);
        row("through a link", ExportKind::Sequence, "link/a_##.png", true);
        row("another folder", ExportKind::Sequence, "sub/a_##.png", false);
        row("in capitals", ExportKind::Sequence, "A_##.PNG", true); // for file systems that ignore case
        row("other digits", ExportKind::Sequence, "a_###.png", false);
        row("a flipbook of that name", ExportKind::Flipbook, "a_02.png", true);
        row("noise of that name", ExportKind::NoiseTexture, "a_08.png", true);
    }
    void noTwoJobsWriteTheSameFile()
    {
        QFETCH(int, kind);
        QFETCH(QString, output);
        QFETCH(bool, collides);
        QVERIFY(QDir(m_folder->path()).mkdir("sub"));
        QVERIFY(QFile::link(m_folder->path(), m_folder->filePath("link")));
        std::vector<ExportJob> jobs{jobFor(ExportKind::Sequence, at("a_##.png")),
            jobFor(static_cast<ExportKind>(kind), at(output.toStdString()))};
        jobs[0].name = "first";
        jobs[1].name = "second";
        const Status status = checkJobs(jobs);
        QCOMPARE(!status.ok(), collides);
        if (collides) {
            QCOMPARE(status.error().code, ErrorCode::WouldOverwrite);
            QVERIFY2(status.error().text().find("\"second\" would write over a file of \"first\"") != std::string::npos,
                status.error().text().c_str());
        }
    }

    /// The system says of folders that are there whether they are the same; of others nobody can.
    void foldersMeetWhereTheSystemDoesNotTellThemApart()
    {
        const std::vector<ExportJob> jobs{
            jobFor(ExportKind::Picture, at("new/a.png")), jobFor(ExportKind::Picture, at("New/a.png"))};
        QCOMPARE(checkJobs(jobs).error().code, ErrorCode::WouldOverwrite);
        QVERIFY(QDir(m_folder->path()).mkdir("new"));
        QCOMPARE(checkJobs(jobs).error().code, ErrorCode::WouldOverwrite);
        const bool areTwo = QDir(m_folder->path()).mkdir("New");
        QCOMPARE(checkJobs(jobs).ok(), areTwo);
    }

    void filesAreKeptApartByName()
    {
        JobFiles files;
        const std::vector<std::filesystem::path> some{at("a.csv"), at("a.manifest.json")};
        const std::vector<std::filesystem::path> others{at("b.csv"), at("sub/../A.csv")};
        QVERIFY(files.add("first", some).ok());
        const Status status = files.add("second", others);
        QVERIFY(!status.ok());
        QVERIFY2(status.error().text().find("\"second\" would write over a file of \"first\"") != std::string::npos,
            status.error().text().c_str());
        QVERIFY(!files.writerOf(at("b.csv"))); // it stays out
        QVERIFY(files.writerOf(at("A.csv")) == std::optional(std::size_t{0}));
    }

    void noTwoJobsWriteTheSameManifest()
    {
        std::vector<ExportJob> jobs{
            jobFor(ExportKind::Sequence, at("a_##.png")), jobFor(ExportKind::Sequence, at("a_##.exr"))};
        jobs[1].plan.format = ImageFormat::ExrHalf;
        QVERIFY(checkJobs(jobs).ok());
        jobs[0].plan.recording.manifest = jobs[1].plan.recording.manifest = at("a.manifest.json");
        const Status status = checkJobs(jobs);
        QVERIFY(!status.ok());
        QVERIFY2(
            status.error().text().find("a.2-9x3.manifest.json") != std::string::npos, status.error().text().c_str());
        jobs[1].plan.frames.last = 20; // another part of it
        QVERIFY(checkJobs(jobs).ok());
    }

    void aJobIsNotWrittenOverThePresetOfAnother()
    {
        std::vector<ExportJob> jobs{jobFor(ExportKind::Picture, at("a.png")), jobFor(ExportKind::Picture, at("b.png"))};
        jobs[1].plan.source = at("a.png"); // a picture that was opened as its project
        QVERIFY(!checkJobs(jobs).ok());
        jobs[1].plan.source = at("c.png");
        QVERIFY(checkJobs(jobs).ok());
        // One's own is said when its turn comes, so that the others are done.
        jobs[1].plan.source = at("b.png");
        QVERIFY(checkJobs(jobs).ok());
        QVERIFY(writePresetFile(at("b.png"), smallPreset()).ok());
        const Result<std::optional<Flipbook>> done = runJob(jobs[1]);
        QVERIFY(!done.ok());
        QCOMPARE(done.error().code, ErrorCode::WouldOverwrite);
        QVERIFY(readPresetFile(at("b.png")).ok());
    }

    void moreFilesThanCanBeComparedAreRefused()
    {
        std::vector<ExportJob> jobs(2, jobFor(ExportKind::Sequence, at("a_##.png")));
        jobs[0].plan.frames = jobs[1].plan.frames = {0, 600'000, 1};
        jobs[1].plan.output = at("b_##.png");
        const Status status = checkJobs(jobs);
        QVERIFY(!status.ok());
        QCOMPARE(status.error().code, ErrorCode::TooLarge);
    }

    void aListIsWrittenWholeOrNotAtAll()
    {
        const ExportJob job = jobFor(ExportKind::Picture, "a");
        const std::string file = at("list.json");
        QVERIFY(writeJobsFile(file, std::span(&job, 1), FileAccess::Private).ok());
        QCOMPARE(readJobsFile(file).value().jobs.size(), std::size_t{1});
        const std::vector<ExportJob> many(kMaxJobs + 1, job);
        const Status status = writeJobsFile(file, many);
        QVERIFY(!status.ok());
        QCOMPARE(status.error().code, ErrorCode::TooLarge);
        QCOMPARE(readJobsFile(file).value().jobs.size(), std::size_t{1});
    }

private:
    [[nodiscard]] std::string at(const std::string& name) const { return m_folder->path().toStdString() + "/" + name; }

    static ExportJob jobFor(ExportKind kind, const std::string& output)
    {
        ExportJob job;
        job.name = "job " + output;
        job.preset = smallPreset();
        job.plan.kind = kind;
        job.plan.output = output;
        job.plan.frames = {2, 9, 3};
        job.plan.project = Preset();
        job.plan.source = "/somewhere/mine.json";
        return job;
    }

    std::unique_ptr<QTemporaryDir> m_folder;
};

QTEST_GUILESS_MAIN(JobsTest)
#include "jobs_test.moc"
