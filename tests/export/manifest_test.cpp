// Manifests say what files are, and hold files against it. Whatever somebody has written into one leads nowhere else.
#include "tests/export/small_smoke.h"
#include "tests/helpers.h"

#include "core/system/file.h"
#include "core/base/sha256.h"
#include "core/export/manifest/recorded.h"
#include "core/export/manifest/verify.h"
#include "core/export/plan.h"

#include <QTemporaryDir>

#include <map>

#include <sys/stat.h>

using namespace fumage;
using namespace fumage::tests;

namespace {

/// A folder for pictures, and what is done in it.
class Folder {
public:
    [[nodiscard]] std::filesystem::path path(const std::string& name = {}) const
    {
        return std::filesystem::path(m_folder.path().toStdString()) / name;
    }

    void render(const FrameRange& frames, const Effect& effect = smallSmoke(), bool skipExisting = false)
    {
        ExportPlan plan;
        plan.output = path("s_##.png");
        plan.frames = frames;
        plan.project = Preset{};
        plan.recording = {path("s.manifest.json"), skipExisting};
        m_rendered = 0;
        const auto done = runExport(effect, plan, [this](ProgressPhase work, int, int total) {
            m_rendered = work == ProgressPhase::Frames ? total : m_rendered;
        });
        QVERIFY2(done.ok(), done ? "" : done.error().text().c_str());
    }
    /// Frames that the last render() has rendered.
    [[nodiscard]] int rendered() const { return m_rendered; }

    [[nodiscard]] std::map<FileState, std::vector<std::string>> check(
        const std::optional<FrameRange>& frames = {}) const
    {
        std::map<FileState, std::vector<std::string>> found;
        const std::vector<CheckedFile> checked = checkFiles(openManifests(path()).value(), frames).value();
        for (const CheckedFile& file : checked) {
            found[file.state].push_back(file.file);
        }
        return found;
    }
    [[nodiscard]] std::vector<std::string> manifests() const
    {
        std::vector<std::string> names;
        const std::vector<FoundManifest> all = findManifests(path()).value();
        for (const FoundManifest& found : all) {
            names.push_back(found.path.filename().string());
        }
        return names;
    }

private:
    QTemporaryDir m_folder;
    int m_rendered = 0;
};

void copyOver(const std::filesystem::path& from, const std::filesystem::path& to)
{
    std::filesystem::copy_file(from, to, std::filesystem::copy_options::overwrite_existing);
}

using Names = std::vector<std::string>;

} // namespace

class ManifestTest : public QObject {
    Q_OBJECT

private slots:
    void aManifestComesBack()
    {
        Manifest manifest{{"frames", {{"format", "png"}, {"step", "2"}}, smallSmoke()}, {},
            {{"a b\"ö_0001.png", 1, {true, sha256Of(std::string_view("1"))}},
                {"sub/x.json", {}, {false, sha256Of(std::string_view("2"))}}}};
        manifest.jobHash = manifest.job.hash();
        const std::string text = formatManifest(manifest);
        const Result<Manifest> back = parseManifest(text, "m.json");
        QVERIFY2(back.ok(), back ? "" : back.error().text().c_str());
        QCOMPARE(formatManifest(back.value()), text);
        QCOMPARE(back.value().job.hash(), manifest.jobHash);
        QCOMPARE(*back.value().files[0].frame, 1);
        QVERIFY(!back.value().files[1].frame);
    }

    void whateverChangesPicturesIsAnotherJob()
    {
        const auto hashOf = [](const Effect& effect, const SequenceOptions& options) {
            return jobOf(effect, options).hash();
        };
        const SequenceOptions usual{"a_##.png", {0, 9, 1}};
        const std::string hash = hashOf(smallSmoke(), usual);
        Effect other = smallSmoke();
        other.motion.gravity += 1.0F;
        QVERIFY(hashOf(other, usual) != hash);
        other = smallSmoke();
        other.output.width += 1;
        QVERIFY(hashOf(other, usual) != hash);
        SequenceOptions options = usual;
        options.format = ImageFormat::Png16;
        QVERIFY(hashOf(smallSmoke(), options) != hash);
        options = usual;
        options.passes.add(Pass::Motion);
        QVERIFY(hashOf(smallSmoke(), options) != hash);
        options = usual;
        options.frames = {10, 19, 1};
        options.output = "b.png";
        QCOMPARE(hashOf(smallSmoke(), options), hash); // another part of it
    }

    void hostileManifestsAreRefused_data()
    {
        QTest::addColumn<std::string>("what");
        QTest::addColumn<std::string>("instead");
        QTest::addColumn<std::string>("says");
        const auto row = [](const char* name, const char* what, const char* instead, const char* says) {
            QTest::newRow(name) << std::string(what) << std::string(instead) << std::string(says);
        };
        row("out of the folder", "\"s_01.png\"", "\"../s_01.png\"", "outside");
        row("from the root", "\"s_01.png\"", "\"/etc/passwd\"", "outside");
        row("up in the middle", "\"s_01.png\"", "\"a/../../s_01.png\"", "outside");
        row("the folder itself", "\"s_01.png\"", "\".\"", "outside");
        row("no name", "\"s_01.png\"", "\"\"", "outside");
        row("a zero byte", "\"s_01.png\"", "\"a\\u0000b\"", "outside");
        row("no text for a name", "\"s_01.png\"", "7", "\"file\"");
        row("frame", "\"frame\": 1", "\"frame\": -1", "frame");
        row("huge frame", "\"frame\": 1", "\"frame\": 1e99", "frame");
        row("version", "\"version\": 1", "\"version\": 2", "version");
        row("format", "fumage-manifest", "fumage-preset", "not a manifest");
        row("no files", "\"files\"", "\"flies\"", "\"files\"");
        row("preset", "\"format\": \"fumage-preset\"", "\"format\": \"x\"", "preset");
        row("broken", "\"settings\": {", "\"settings\": {{", "m.json");
    }
    void hostileManifestsAreRefused()
    {
        QFETCH(std::string, what);
        QFETCH(std::string, instead);
        QFETCH(std::string, says);
        std::string text = formatManifest(
            {jobOf(smallSmoke(), SequenceOptions()), "x", {{"s_01.png", 1, {true, sha256Of(std::string_view("1"))}}}});
        QVERIFY(parseManifest(text, "m.json").ok());
        const std::size_t at = text.find(what);
        QVERIFY(at != std::string::npos);
        text.replace(at, what.size(), instead);
        const Result<Manifest> read = parseManifest(text, "m.json");
        QVERIFY(!read.ok());
        QVERIFY2(read.error().text().find(says) != std::string::npos
                && read.error().text().find("m.json") != std::string::npos,
            read.error().text().c_str());
    }

    void hashesThatAreNoneAreRefused()
    {
        const std::string text =
            formatManifest({jobOf(smallSmoke(), SequenceOptions()), "x", {{"s_01.png", 1, {true, "12"}}}});
        QVERIFY(!parseManifest(text, "m.json").ok());
    }

    void deepAndTruncatedManifestsAreRefused()
    {
        QVERIFY(!parseManifest(std::string(1'000'000, '['), "m.json").ok());
        const std::string text = formatManifest(
            {jobOf(smallSmoke(), SequenceOptions()), "x", {{"s_01.png", 1, {true, sha256Of(std::string_view("1"))}}}});
        for (std::size_t size = 0; size + 1 < text.size(); size += 97) {
            QVERIFY(!parseManifest(std::string_view(text).substr(0, size), "m.json").ok());
        }
    }

    void namesOfManifestsAreThoseOfTheirFrames()
    {
        QCOMPARE(manifestBeside("out/fire_####.png").generic_string(), std::string("out/fire.manifest.json"));
        QCOMPARE(manifestBeside("####.exr").generic_string(), std::string("frames.manifest.json"));
        QCOMPARE(partOf("out/fire.manifest.json", FrameRange{0, 7, 1}).generic_string(),
            std::string("out/fire.0-7.manifest.json"));
        QCOMPARE(partOf("out/fire.json", FrameRange{0, 14, 2}).generic_string(),
            std::string("out/fire.0-14x2.manifest.json"));
        QCOMPARE(partOf("out/fire", {}).generic_string(), std::string("out/fire.manifest.json"));
    }

    void filesAreHeldAgainstTheirManifest()
    {
        Folder folder;
        folder.render({0, 4, 1});
        QCOMPARE(folder.check()[FileState::Same].size(), std::size_t{5});
        std::filesystem::remove(folder.path("s_01.png"));
        copyOver(folder.path("s_03.png"), folder.path("s_02.png"));
        std::filesystem::resize_file(folder.path("s_04.png"), 200);
        copyOver(folder.path("s_00.png"), folder.path("s_09.png"));
        auto found = folder.check(FrameRange{0, 5, 1});
        QCOMPARE(found[FileState::Missing], (Names{"s_01.png", ""})); // and frame 5, which has no name
        QCOMPARE(found[FileState::Different], Names{"s_02.png"});
        QCOMPARE(found[FileState::Broken], Names{"s_04.png"});
        QCOMPARE(found[FileState::Extra], Names{"s_09.png"});
        QCOMPARE(found[FileState::Same], (Names{"s_00.png", "s_03.png"}));
    }

    void whatCannotBeReadIsSaidAndTheOthersAreLookedAt()
    {
        Folder folder;
        folder.render({0, 6, 1});
        for (const char* gone : {"s_01.png", "s_02.png", "s_03.png", "s_05.png"}) {
            std::filesystem::remove(folder.path(gone));
        }
        QCOMPARE(mkfifo(folder.path("s_01.png").c_str(), 0600), 0);
        std::filesystem::create_directory(folder.path("s_02.png"));
        std::filesystem::create_symlink("/dev/null", folder.path("s_03.png"));
        std::filesystem::create_symlink("s_05.png", folder.path("s_05.png"));
        Manifest manifest = readManifest(folder.path("s.0-6.manifest.json")).value();
        manifest.files.push_back({std::string(300, 'n') + ".png", 9, manifest.files[0].content});
        QVERIFY(writeFileAtomically(folder.path("s.0-6.manifest.json"), formatManifest(manifest)).ok());
        QVERIFY(writeFileAtomically(folder.path("a.manifest.json"), std::string_view("{")).ok());
        manifest.files = {{"../up.png", 1, manifest.files[0].content}};
        QVERIFY(writeFileAtomically(folder.path("z.manifest.json"), formatManifest(manifest)).ok());
        auto found = folder.check();
        QCOMPARE(found[FileState::NotAFile], (Names{"s_01.png", "s_02.png", "s_03.png", "s_05.png"}));
        QCOMPARE(found[FileState::Missing], Names{std::string(300, 'n') + ".png"});
        QCOMPARE(found[FileState::Same], (Names{"s_00.png", "s_04.png", "s_06.png"}));
        const ManifestSet set = openManifests(folder.path()).value();
        QCOMPARE(set.manifests.size(), std::size_t{1});
        QCOMPARE(set.broken.size(), std::size_t{2});
        QVERIFY(set.broken[0].text().find("a.manifest.json") != std::string::npos
            && set.broken[1].text().find("../up.png") != std::string::npos);
        for (const CheckedFile& file : checkFiles(set, {}).value()) {
            QCOMPARE(file.why.empty(), file.state != FileState::NotAFile);
        }
    }

    void memoryDoesNotGrowWithTheFile()
    {
        constexpr std::uint64_t kLength = std::uint64_t{100} << 20U;
        std::size_t largest = 0;
        const auto zerosAfter = [&](const std::string& head, const std::string& tail) -> PartReader {
            return [&largest, head, tail](std::uint64_t at, std::size_t size) -> Result<std::string> {
                largest = std::max(largest, size);
                const std::uint64_t end = head.size() + kLength + tail.size();
                std::string part(
                    static_cast<std::size_t>(std::min<std::uint64_t>(size, end - std::min(at, end))), '\0');
                for (std::size_t i = 0; i < part.size(); ++i) {
                    const std::uint64_t place = at + i;
                    part[i] = place < head.size()        ? head[place]
                        : place >= head.size() + kLength ? tail[place - head.size() - kLength]
                                                         : '\0';
                }
                return part;
            };
        };
        const Content plain = contentOf(zerosAfter("head", "tail")).value();
        QVERIFY(!plain.ofPixels);
        // A picture with a chunk of any length that means nothing shows what it shows without.
        Folder folder;
        folder.render({0, 0, 1});
        const std::string png = readFile(folder.path("s_00.png"), std::size_t{1} << 20U).value();
        const std::size_t pixels = png.find("IDAT") - 4;
        std::string head = png.substr(0, pixels);
        for (unsigned shift = 32; shift > 0; shift -= 8) {
            head += static_cast<char>(kLength >> (shift - 8));
        }
        const Content large = contentOf(zerosAfter(head + "juNK", "sum!" + png.substr(pixels))).value();
        QVERIFY(large == contentOf(std::as_bytes(std::span(png))).value());
        QVERIFY2(largest <= std::size_t{1} << 20U, std::to_string(largest).c_str());
    }

    void namesThatAreNotUtf8AreRefusedBeforeAnythingIsWritten()
    {
        for (std::size_t i = 0; i < kExportKinds; ++i) {
            Folder folder;
            ExportPlan plan;
            plan.kind = static_cast<ExportKind>(i);
            plan.output = folder.path("b\xff") += std::string(fileEnding(plan));
            plan.frames = {0, 3, 1};
            plan.flipbook.columns = plan.flipbook.rows = 2;
            plan.recording.manifest =
                canBeRecorded(plan.kind) ? folder.path("b.manifest.json") : std::filesystem::path();
            if (!canBeRecorded(plan.kind)) {
                continue;
            }
            const auto done = runExport(smallSmoke(), plan);
            QVERIFY(!done.ok());
            QCOMPARE(done.error().code, ErrorCode::NotUtf8);
            QVERIFY(!done.error().remedy.empty());
            QVERIFY(std::filesystem::is_empty(folder.path()));
        }
        // Where nobody has to write the name down it is a name like any other.
        Folder folder;
        ExportPlan plan;
        plan.output = folder.path("b\xff##.png");
        plan.frames = {0, 1, 1};
        QVERIFY(runExport(smallSmoke(), plan).ok());
        for (const char* number : {"00", "01"}) {
            QVERIFY(
                std::filesystem::remove(folder.path(std::string("b\xff") + number + ".png"))); // Qt does not see them
        }
        // One that is UTF-8 is in the manifest as it is.
        plan.output = folder.path("煙 #1 é_##.png");
        plan.recording.manifest = folder.path("煙.manifest.json");
        QVERIFY(runExport(smallSmoke(), plan).ok());
        QCOMPARE(folder.check()[FileState::Same].size(), std::size_t{2});
    }

    void partsAreOneWhole()
    {
        Folder folder;
        folder.render({0, 2, 1});
        folder.render({2, 5, 1}); // tasks may overlap
        QCOMPARE(folder.manifests(), (Names{"s.0-2.manifest.json", "s.2-5.manifest.json"}));
        const auto found = folder.check(FrameRange{0, 5, 1});
        QCOMPARE(found.size(), std::size_t{1});
        QCOMPARE(found.at(FileState::Same).size(), std::size_t{6});
    }

    void partsThatDisagreeAreSaid()
    {
        Folder folder;
        folder.render({0, 2, 1});
        Manifest other = readManifest(folder.path("s.0-2.manifest.json")).value();
        other.files = {{"s_01.png", 1, other.files[0].content}};
        QVERIFY(writeFileAtomically(folder.path("s.1-1.manifest.json"), formatManifest(other)).ok());
        QCOMPARE(folder.check()[FileState::Contradicted], Names{"s_01.png"});
    }

    void manifestsOfOtherPicturesOfTheSameNameGo()
    {
        Folder folder;
        folder.render({0, 2, 1});
        folder.render({3, 5, 1});
        Effect changed = smallSmoke();
        changed.look.opacity *= 0.5F;
        folder.render({0, 1, 1}, changed);
        QCOMPARE(folder.manifests(), (Names{"s.0-1.manifest.json", "s.3-5.manifest.json"}));
        auto found = folder.check();
        QCOMPARE(found[FileState::Extra], Names{"s_02.png"}); // of the first job, of which nothing else is left
        QCOMPARE(found[FileState::Same].size(), std::size_t{5});
    }

    void framesOutOfRangeTellNothingOfAnotherMachine()
    {
        Folder folder;
        folder.render({0, 5, 1});
        const ManifestSet set = openManifests(folder.path()).value();
        const auto again = renderAgain(set, {2, 9, 2});
        QVERIFY2(again.ok(), again ? "" : again.error().text().c_str());
        QCOMPARE(again.value().size(), std::size_t{2});
        for (const CheckedFile& file : again.value()) {
            QCOMPARE(file.state, FileState::Same);
        }
        QCOMPARE(renderAgain(set, {6, 9, 1}).error().code, ErrorCode::OutOfRange);
    }

    void whatComesOutOtherwiseIsSaid()
    {
        Folder folder;
        folder.render({0, 2, 1});
        ManifestSet set = openManifests(folder.path()).value();
        std::swap(set.manifests[0].manifest.files[0].content, set.manifests[0].manifest.files[1].content);
        const std::vector<CheckedFile> again = renderAgain(set, {0, 2, 1}).value();
        QCOMPARE(again[0].state, FileState::Different);
        QCOMPARE(again[1].state, FileState::Different);
        QCOMPARE(again[2].state, FileState::Same);
    }

    void motionDoesNotDependOnTheRangeOfItsFrame()
    {
        SequenceOptions options;
        options.format = ImageFormat::ExrFloat;
        options.passes = {Pass::Colour, Pass::Motion};
        const auto hashes = [&](const FrameRange& frames) {
            std::map<int, std::string> all;
            options.frames = frames;
            const auto keep = [&](int frame, std::span<const std::byte> bytes) -> Status {
                all[frame] = contentOf(bytes).value().hash;
                return Done{};
            };
            const Status done = encodeFrames(smallSmoke(), options, keep);
            return done ? all : std::map<int, std::string>();
        };
        const std::map<int, std::string> whole = hashes({10, 22, 2});
        QCOMPARE(whole.size(), std::size_t{7});
        for (const FrameRange& part : {FrameRange{10, 14, 2}, FrameRange{16, 16, 2}, FrameRange{18, 22, 2}}) {
            for (const auto& [frame, hash] : hashes(part)) {
                QCOMPARE(hash, whole.at(frame));
            }
        }
    }

    void framesThatAreThereAreSkipped()
    {
        Folder folder;
        folder.render({0, 3, 1});
        const std::string before = readFile(folder.path("s_02.png"), 1U << 20U).value();
        std::filesystem::resize_file(folder.path("s_01.png"), before.size() / 2); // half a file
        copyOver(folder.path("s_02.png"), folder.path("s_03.png")); // a whole one of another frame
        folder.render({0, 4, 1}, smallSmoke(), true);
        QCOMPARE(folder.rendered(), 3);
        const auto found = folder.check(FrameRange{0, 4, 1});
        QCOMPARE(found.size(), std::size_t{1});
        QCOMPARE(found.at(FileState::Same).size(), std::size_t{5});
    }

    void framesOfAnotherPresetOrSizeAreNotSkipped()
    {
        Folder folder;
        folder.render({0, 1, 1});
        Effect changed = smallSmoke();
        changed.look.opacity *= 0.5F;
        folder.render({0, 1, 1}, changed, true);
        QCOMPARE(folder.rendered(), 2);
        folder.render({0, 1, 1}, changed, true);
        QCOMPARE(folder.rendered(), 0);
        changed.output.width = 20;
        folder.render({0, 1, 1}, changed, true);
        QCOMPARE(folder.rendered(), 2);
    }

    void aManifestMayLieAboveItsFilesButNotElsewhere()
    {
        const QTemporaryDir folder;
        const std::filesystem::path root = folder.path().toStdString();
        ManifestRecorder above({"frames", {}, Effect()}, root / "m.json", std::nullopt);
        const std::array bytes{std::byte{7}};
        QVERIFY(above.add(root / "deep" / "x.bin", std::nullopt, bytes).ok());
        ManifestRecorder beside({"frames", {}, Effect()}, root / "other" / "m.json", std::nullopt);
        const Status status = beside.add(root / "x.bin", std::nullopt, bytes);
        QVERIFY(!status.ok() && status.error().code == ErrorCode::OutOfRange);
        QVERIFY(above.write().ok());
        QCOMPARE(readManifest(root / "m.manifest.json").value().files[0].file, std::string("deep/x.bin"));
    }
};

QTEST_GUILESS_MAIN(ManifestTest)
#include "manifest_test.moc"
