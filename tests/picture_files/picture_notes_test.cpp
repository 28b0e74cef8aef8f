// Pictures carry the preset that they were made of, and say no more than they hold when somebody has broken them.

#include "core/base/file.h"
#include "core/export/image_file.h"
#include "core/export/plan.h"
#include "core/picture_files/picture_notes.h"
#include "core/preset/library.h"

#include <QProcess>
#include <QTemporaryDir>

#include <array>

#include <QtTest/QtTest>

using namespace fumage;

namespace {

constexpr std::array kFormats{ImageFormat::Png8, ImageFormat::Png16, ImageFormat::ExrHalf, ImageFormat::ExrFloat};

std::string pictureWith(const PictureNotes& notes, ImageFormat format)
{
    Image image;
    image.resize(20, 10);
    std::fill(image.pixels.begin(), image.pixels.end(), 0.5F);
    const std::vector<std::byte> bytes = encodeImage(image, Effect{}, format, notes).value();
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

/// A preset that nobody else has, with letters that are no ASCII.
Preset ownPreset()
{
    Preset preset = loadPreset("plume").value().preset;
    preset.name = "Rök \"von\" 烟";
    preset.description = "Line\nline";
    preset.effect.air.enabled = false;
    preset.effect.emitter.count = 300;
    preset.effect.motion.buoyancy = 1.2345F;
    preset.effect.noise.slices = 4;
    preset.effect.noise.resolution = 16;
    preset.effect.output.width = 32;
    preset.effect.output.height = 32;
    preset.unknown.push_back({"motion", "of_tomorrow", "[1, 2]"});
    return preset;
}

ExportPlan planFor(const std::filesystem::path& output, ImageFormat format)
{
    ExportPlan plan;
    plan.kind = ExportKind::Sequence;
    plan.output = output;
    plan.frames = {6, 8, 2};
    plan.format = format;
    plan.project = ownPreset();
    return plan;
}

std::string bytesOf(const std::filesystem::path& path)
{
    return readFile(path, std::size_t{1} << 26U).value();
}

} // namespace

class PictureNotesTest : public QObject {
    Q_OBJECT

private slots:
    void notesComeBackAsTheyWere()
    {
        for (const ImageFormat format : kFormats) {
            const std::string picture = pictureWith({25, "{\"name\": \"Rök 烟\"}", 1234567}, format);
            QVERIFY(isPicture(picture));
            const PictureNotes notes = readPictureNotes(picture).value();
            QCOMPARE(notes.preset, std::string("{\"name\": \"Rök 烟\"}"));
            QCOMPARE(notes.frame, 1234567);
            QVERIFY(readPictureNotes(pictureWith({}, format)).value().preset.empty());
        }
    }

    void aPictureOpensAsThePresetThatItWasMadeOf()
    {
        const QTemporaryDir folder;
        const std::filesystem::path root = folder.path().toStdString();
        for (const ImageFormat format : kFormats) {
            const ExportPlan plan = planFor(root / "smoke_##", format);
            QVERIFY(runExport(ownPreset().effect, plan, {}).ok());
            const std::filesystem::path last = lastFile(plan);
            const PresetReading reading = readPresetFile(last).value();
            QCOMPARE(formatPreset(reading.preset), formatPreset(ownPreset()));
            QCOMPARE(reading.frame.value(), 8);
            // Rendered again it is the same file, by bytes.
            ExportPlan again = plan;
            again.output = root / "again_##";
            again.project = reading.preset;
            QVERIFY(runExport(reading.preset.effect, again, {}).ok());
            QVERIFY(bytesOf(last) == bytesOf(lastFile(again)));
        }
    }

    void everySheetOfAFlipbookCarriesWhatItShows()
    {
        const QTemporaryDir folder;
        ExportPlan plan = planFor(std::filesystem::path(folder.path().toStdString()) / "sheet.png", ImageFormat::Png8);
        plan.kind = ExportKind::Flipbook;
        plan.columns = plan.rows = 2;
        plan.frames = {5, 8, 1};
        plan.passes.add(Pass::Motion);
        plan.fitCamera = true;
        QVERIFY(runExport(ownPreset().effect, plan, {}).ok());
        for (const std::filesystem::path& picture : picturesOf(flipbookOf(plan))) {
            const PresetReading reading = readPresetFile(picture).value();
            QCOMPARE(reading.frame.value(), 5);
            QVERIFY(!(reading.preset.effect.camera == ownPreset().effect.camera)); // that which took the picture
        }
    }

    void nothingIsCarriedWhereThatIsNotWanted()
    {
        const QTemporaryDir folder;
        ExportPlan plan = planFor(std::filesystem::path(folder.path().toStdString()) / "smoke_##.png", ImageFormat::Png8);
        plan.project.reset();
        QVERIFY(runExport(ownPreset().effect, plan, {}).ok());
        const auto reading = readPresetFile(lastFile(plan));
        QVERIFY(!reading.ok());
        QCOMPARE(reading.error().code, ErrorCode::WrongType);
        QVERIFY(reading.error().text().find("carries no preset") != std::string::npos);
        QVERIFY(bytesOf(lastFile(plan)).find("fumage:") == std::string::npos);
    }

    void whatIsCutShortIsRefusedOrWhole()
    {
        const std::string preset = formatPreset(ownPreset());
        for (const ImageFormat format : {ImageFormat::Png8, ImageFormat::ExrHalf}) {
            const std::string picture = pictureWith({0, preset, 3}, format);
            for (std::size_t size = 0; size < picture.size(); size += 1 + size / 64) {
                const Result<PictureNotes> notes = readPictureNotes(std::string_view(picture).substr(0, size));
                QVERIFY2(!notes || notes.value().preset == preset || notes.value().preset.empty(), qPrintable(QString::number(size)));
                QVERIFY(notes || !notes.error().message.empty());
            }
        }
    }

    void noByteThatIsWrongDoesHarm()
    {
        for (const ImageFormat format : {ImageFormat::Png8, ImageFormat::ExrHalf}) {
            const std::string whole = pictureWith({0, formatPreset(ownPreset()), 3}, format);
            for (std::size_t at = 0; at < whole.size(); at += at < 600 ? 1 : 97) {
                for (const char wrong : {'\0', '\x7f', '\xff'}) {
                    std::string broken = whole;
                    broken[at] = wrong;
                    const Result<PictureNotes> notes = readPictureNotes(broken);
                    QVERIFY(!notes || notes.value().preset.size() <= kMostNoteBytes);
                }
            }
        }
    }

    void aPackedTextThatIsTooLargeIsNotUnpacked()
    {
        const std::string bomb(std::size_t{64} << 20U, ' ');
        const std::string picture = pictureWith({0, bomb, 0}, ImageFormat::Png8);
        QVERIFY(picture.size() < kPictureHead);
        QVERIFY(readPictureNotes(picture).value().preset.empty());
        const std::string exr = pictureWith({0, bomb, 0}, ImageFormat::ExrHalf);
        const Result<PictureNotes> notes = readPictureNotes(std::string_view(exr).substr(0, kPictureHead));
        QVERIFY(!notes || notes.value().preset.empty());
    }

    void otherReadersSeeTheNotes()
    {
        const QTemporaryDir folder;
        const QString path = folder.filePath("picture.exr");
        QVERIFY(writeFileAtomically(path.toStdString(), pictureWith({24, "{\"format\": 1}", 77}, ImageFormat::ExrHalf)).ok());
        QProcess reader;
        reader.start("exrheader", {path});
        QVERIFY(reader.waitForFinished());
        const QByteArray seen = reader.readAllStandardOutput();
        QVERIFY2(seen.contains("fumage:preset (type string): \"{\"format\": 1}\""), seen);
        QVERIFY2(seen.contains("fumage:frame (type int): 77"), seen);
    }

    void whatIsNoPictureIsNotTakenForOne()
    {
        QVERIFY(!isPicture(""));
        QVERIFY(!isPicture("\x89PNG"));
        QVERIFY(!isPicture("{\"format\""));
        QCOMPARE(readPictureNotes("GIF89a").error().code, ErrorCode::Syntax);
    }
};

QTEST_GUILESS_MAIN(PictureNotesTest)
#include "picture_notes_test.moc"
