// Pictures carry the preset that they were made of, and say no more than they hold when somebody has broken them.

#include "core/system/file.h"
#include "core/export/sheets/flipbook_files.h"
#include "core/export/sheets/cell_frames.h"
#include "core/export/image_file.h"
#include "core/export/plan.h"
#include "core/export/sheets/sheet_note.h"
#include "core/image_io/image_metadata.h"
#include "core/image_io/png_chunks.h"
#include "core/preset/json_tree.h"
#include "core/preset/library.h"
#include "core/preset/preset_file.h"

#include <QProcess>
#include <QTemporaryDir>

#include <array>
#include <map>

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIntAttribute.h>
#include <ImfOutputFile.h>
#include <ImfStringAttribute.h>

#include <QtTest/QtTest>

using namespace fumage;

namespace {

constexpr std::array kFormats{ImageFormat::Png8, ImageFormat::Png16, ImageFormat::ExrHalf, ImageFormat::ExrFloat};

std::string pictureWith(const ImageMetadata& notes, ImageFormat format)
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
    preset.scene.air.enabled = false;
    preset.scene.layers[0].emitter.count = 300;
    preset.scene.layers[0].motion.buoyancy = 1.2345F;
    preset.scene.layers[0].noise.slices = 4;
    preset.scene.layers[0].noise.resolution = 16;
    preset.scene.output.width = 32;
    preset.scene.output.height = 32;
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

void appendWord(std::string& bytes, std::uint32_t word)
{
    for (unsigned shift = 32; shift > 0; shift -= 8) {
        bytes += static_cast<char>(word >> (shift - 8));
    }
}

/// A chunk of a PNG with its checksum: CRC-32 of ISO 3309, bit by bit.
std::string chunkOf(const std::string& kind, const std::string& holds)
{
    std::uint32_t sum = 0xFFFFFFFFU;
    for (const char letter : kind + holds) {
        sum ^= static_cast<unsigned char>(letter);
        for (int bit = 0; bit < 8; ++bit) {
            sum = (sum >> 1U) ^ ((sum & 1U) != 0 ? 0xEDB88320U : 0U);
        }
    }
    std::string chunk;
    appendWord(chunk, static_cast<std::uint32_t>(holds.size()));
    chunk += kind + holds;
    appendWord(chunk, ~sum);
    return chunk;
}

/// A PNG without notes, with chunks before its pixels or behind them.
std::string pngWith(const std::string& chunks, bool behindPixels)
{
    const std::string plain = pictureWith({}, ImageFormat::Png8);
    const std::size_t at = behindPixels ? plain.find("IEND") - 4 : plain.find("IDAT") - 4;
    return plain.substr(0, at) + chunks + plain.substr(at);
}

const std::string kNul(1, '\0');

/// The preset as a text of each kind: as it stands, and as UTF-8, which pictures had before.
std::vector<std::string> presetChunks(const std::string& preset)
{
    const std::string key = std::string(kPresetNote) + kNul;
    return {chunkOf("tEXt", key + asciiJson(preset)), chunkOf("iTXt", key + kNul + kNul + kNul + kNul + preset)};
}

/// The lengths of the attributes in the header of an EXR, by their names.
std::map<std::string, std::size_t> attributesOf(const std::string& exr)
{
    constexpr std::size_t kMagicAndVersion = 8;
    std::map<std::string, std::size_t> lengths;
    for (std::size_t at = kMagicAndVersion; exr.at(at) != '\0';) {
        const std::string name = exr.c_str() + at;
        const std::size_t type = at + name.size() + 1;
        const std::size_t size = exr.find('\0', type) + 1;
        std::uint32_t length = 0;
        for (std::size_t i = 4; i > 0; --i) {
            length = (length << 8U) + static_cast<unsigned char>(exr.at(size + i - 1));
        }
        lengths[name] = length;
        at = size + 4 + length;
    }
    return lengths;
}

} // namespace

class ImageMetadataTest : public QObject {
    Q_OBJECT

private slots:
    void notesComeBackAsTheyWere()
    {
        for (const ImageFormat format : kFormats) {
            const std::string picture =
                pictureWith({25, "{\"name\": \"Rök 烟😀\"}", 1234567, "{\"rows\":\"2\"}"}, format);
            QVERIFY(isPicture(picture));
            const ImageMetadata notes = readImageMetadata(picture).value();
            QCOMPARE(parseJson(notes.preset).value().find("name")->string, std::string("Rök 烟😀"));
            QCOMPARE(asciiJson(notes.preset), std::string("{\"name\": \"R\\u00f6k \\u70df\\ud83d\\ude00\"}"));
            QCOMPARE(notes.frame, 1234567);
            QCOMPARE(notes.sheet, std::string("{\"rows\":\"2\"}"));
            QVERIFY(readImageMetadata(pictureWith({}, format)).value().preset.empty());
        }
    }

    void aPictureOpensAsThePresetThatItWasMadeOf()
    {
        const QTemporaryDir folder;
        const std::filesystem::path root = folder.path().toStdString();
        for (const ImageFormat format : kFormats) {
            const ExportPlan plan = planFor(root / "smoke_##", format);
            QVERIFY(runExport(ownPreset().scene, plan).ok());
            const std::filesystem::path last = lastFile(Scene(), plan);
            const PresetReading reading = readPresetFile(last).value();
            QCOMPARE(formatPreset(reading.preset), formatPreset(ownPreset()));
            QCOMPARE(reading.frame.value(), 8);
            // Rendered again it is the same file, by bytes.
            ExportPlan again = plan;
            again.output = root / "again_##";
            again.project = reading.preset;
            QVERIFY(runExport(reading.preset.scene, again).ok());
            QVERIFY(bytesOf(last) == bytesOf(lastFile(Scene(), again)));
        }
    }

    void everySheetOfAFlipbookCarriesWhatItShows()
    {
        const QTemporaryDir folder;
        ExportPlan plan = planFor(std::filesystem::path(folder.path().toStdString()) / "sheet.png", ImageFormat::Png8);
        plan.kind = ExportKind::Flipbook;
        plan.flipbook.columns = plan.flipbook.rows = 2;
        plan.frames = {5, 8, 1};
        plan.passes.add(Pass::Motion);
        plan.fitCamera = true;
        QVERIFY(runExport(ownPreset().scene, plan).ok());
        for (const std::filesystem::path& picture : picturesOf(flipbookOf(plan))) {
            const PresetReading reading = readPresetFile(picture).value();
            QCOMPARE(reading.frame.value(), 5);
            QVERIFY(!(reading.preset.scene.camera == ownPreset().scene.camera)); // that which took the picture
        }
    }

    void notesAreTakenOutOfPngsAlone()
    {
        const auto bare = [](const std::string& file) {
            const std::vector<std::byte> left = withoutNotes(std::as_bytes(std::span(file)));
            return std::string(reinterpret_cast<const char*>(left.data()), left.size());
        };
        const std::string with = pictureWith({0, formatPreset(ownPreset()), 3, "{}"}, ImageFormat::Png8);
        QVERIFY(bare(with) == pictureWith({}, ImageFormat::Png8));
        const std::string cut = with.substr(0, with.find("fumage:preset") + 20);
        QVERIFY(bare(cut) == cut && bare("") == "" && bare("no picture") == "no picture");
    }

    void nothingIsCarriedWhereThatIsNotWanted()
    {
        const QTemporaryDir folder;
        ExportPlan plan =
            planFor(std::filesystem::path(folder.path().toStdString()) / "smoke_##.png", ImageFormat::Png8);
        plan.project.reset();
        QVERIFY(runExport(ownPreset().scene, plan).ok());
        const auto reading = readPresetFile(lastFile(Scene(), plan));
        QVERIFY(!reading.ok());
        QCOMPARE(reading.error().code, ErrorCode::WrongType);
        QVERIFY(reading.error().text().find("carries no preset") != std::string::npos);
        QVERIFY(bytesOf(lastFile(Scene(), plan)).find("fumage:") == std::string::npos);
    }

    void sheetsSayHowTheirCellsAreMade()
    {
        const QTemporaryDir folder;
        for (const ImageFormat format : {ImageFormat::Png8, ImageFormat::ExrHalf}) {
            ExportPlan plan = planFor(
                std::filesystem::path(folder.path().toStdString()) / ("sheet" + std::string(fileEnding(format))),
                format);
            plan.kind = ExportKind::Flipbook;
            plan.flipbook.columns = 2;
            plan.flipbook.rows = 1;
            plan.frames = {5, 9, 2};
            plan.passes.add(Pass::Alpha);
            plan.flipbook.packs.push_back(parsePack("masks=alpha,colour.r").value());
            plan.flipbook.retime = parseRetime("[[0,0.5],[1,1]]").value();
            QVERIFY(runExport(ownPreset().scene, plan).ok());
            const PresetReading reading = readPresetFile(picturesOf(flipbookOf(plan)).front()).value();
            const std::optional<FlipbookOptions> sheet = readSheetNote(reading.sheet);
            QVERIFY(sheet.has_value());
            FlipbookOptions again = *sheet;
            again.output = plan.output.parent_path() / ("again" + std::string(fileEnding(format)));
            again.preset = formatPreset(reading.preset);
            QVERIFY(renderFlipbook(reading.preset.scene, again).ok());
            QVERIFY(bytesOf(picturesOf(flipbookOf(plan)).front()) == bytesOf(picturesOf(again).front()));
        }
        QVERIFY(!readSheetNote(""));
        QVERIFY(!readSheetNote("[1]"));
        QVERIFY(!readSheetNote("{\"columns\": 4}"));
    }

    void presetsAreReadFromBeforeThePixelsAndFromBehindThem()
    {
        const std::string preset = formatPreset(ownPreset());
        for (const bool behindPixels : {false, true}) {
            for (const std::string& chunk : presetChunks(preset)) {
                const std::string frame = chunkOf("tEXt", std::string(kFrameNote) + kNul + "17");
                for (const std::string& chunks : {frame + chunk, chunk + frame}) {
                    const ImageMetadata notes = readImageMetadata(pngWith(chunks, behindPixels)).value();
                    QCOMPARE(notes.frame, 17);
                    QCOMPARE(formatPreset(parsePreset(notes.preset).value().preset), preset);
                }
            }
        }
    }

    void presetsInOneAttributeOfAnExrAreStillRead()
    {
        Imf::Header header(2, 2);
        header.channels().insert("Y", Imf::Channel(Imf::HALF));
        header.insert(kPresetNote.data(), Imf::StringAttribute(formatPreset(ownPreset())));
        header.insert(kFrameNote.data(), Imf::IntAttribute(9));
        const QTemporaryDir folder;
        const std::string path = folder.filePath("old.exr").toStdString();
        {
            const std::vector<std::uint16_t> pixels(4);
            Imf::FrameBuffer buffer;
            buffer.insert(
                "Y", Imf::Slice(Imf::HALF, reinterpret_cast<char*>(const_cast<std::uint16_t*>(pixels.data())), 2, 4));
            Imf::OutputFile file(path.c_str(), header);
            file.setFrameBuffer(buffer);
            file.writePixels(2);
        }
        const PresetReading reading = readPresetFile(path).value();
        QCOMPARE(reading.frame.value(), 9);
        QCOMPARE(formatPreset(reading.preset), formatPreset(ownPreset()));
    }

    void noAttributeOfAnExrIsTooLongForAnyReader()
    {
        std::vector<Preset> presets;
        for (const LibraryEntry& entry : builtinPresets()) {
            presets.push_back(loadPreset(entry).value().preset);
        }
        for (std::size_t length = 0; length < 40; ++length) {
            presets.push_back(ownPreset());
            presets.back().description = std::string(length, 'x') + "烟烟烟";
            presets.back().name = std::string(length * length, 'n');
        }
        for (const Preset& preset : presets) {
            for (const ImageFormat format : {ImageFormat::ExrHalf, ImageFormat::ExrFloat}) {
                const std::string exr = pictureWith({24, formatPreset(preset), 3, sheetNoteOf({})}, format);
                for (const auto& [name, length] : attributesOf(exr)) {
                    QVERIFY2(length <= 255 && name.size() <= 31, name.c_str());
                }
                QCOMPARE(readImageMetadata(exr).value().preset, formatPreset(preset));
            }
        }
    }

    void aPresetThatIsDamagedOrTooLongIsNamedAsSuch()
    {
        const std::string preset = formatPreset(ownPreset());
        for (const bool behindPixels : {false, true}) {
            for (std::string chunk : presetChunks(preset)) {
                chunk[chunk.size() / 2] ^= 1; // its checksum is wrong then
                QCOMPARE(readImageMetadata(pngWith(chunk, behindPixels)).error().code, ErrorCode::Syntax);
                QCOMPARE(readImageMetadata(pngWith(chunk, behindPixels)).error().text(), damagedNote().text());
            }
            for (const std::string& chunk : presetChunks(std::string(kMaxNoteBytes + 1, 'x'))) {
                QCOMPARE(readImageMetadata(pngWith(chunk, behindPixels)).error().text(), damagedNote().text());
            }
        }
        const QTemporaryDir folder;
        const std::filesystem::path path = folder.filePath("torn.png").toStdString();
        for (const ImageFormat format : kFormats) {
            QVERIFY(writeFileAtomically(path, pictureWith({24, preset.substr(0, preset.size() / 2), 3}, format)).ok());
            const auto reading = readPresetFile(path);
            QVERIFY(!reading);
            QVERIFY2(reading.error().text().find("the preset that this picture carries") != std::string::npos,
                reading.error().text().c_str());
            QVERIFY(reading.error().text().find(path.string()) != std::string::npos);
        }
    }

    void whatIsCutShortIsRefusedOrWhole()
    {
        const std::string preset = formatPreset(ownPreset());
        for (const ImageFormat format : {ImageFormat::Png8, ImageFormat::ExrHalf}) {
            const std::string picture = pictureWith({0, preset, 3}, format);
            for (std::size_t size = 0; size < picture.size(); size += 1 + size / 64) {
                const Result<ImageMetadata> notes = readImageMetadata(std::string_view(picture).substr(0, size));
                QVERIFY2(!notes || asciiJson(notes.value().preset) == asciiJson(preset) || notes.value().preset.empty(),
                    qPrintable(QString::number(size)));
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
                    const Result<ImageMetadata> notes = readImageMetadata(broken);
                    QVERIFY(!notes || notes.value().preset.size() <= kMaxNoteBytes);
                }
            }
        }
    }

    void aPackedTextThatIsTooLargeIsNotUnpacked()
    {
        const std::string bomb(std::size_t{64} << 20U, ' ');
        const std::string picture = pictureWith({0, bomb, 0}, ImageFormat::Png8);
        QVERIFY(picture.size() < kPictureHead);
        QCOMPARE(readImageMetadata(picture).error().text(), damagedNote().text());
        const std::string exr = pictureWith({0, bomb, 0}, ImageFormat::ExrHalf);
        const Result<ImageMetadata> notes = readImageMetadata(std::string_view(exr).substr(0, kPictureHead));
        QVERIFY(!notes || notes.value().preset.empty());
    }

    void otherReadersSeeTheNotes()
    {
        const QTemporaryDir folder;
        const QString path = folder.filePath("picture.exr");
        QVERIFY(writeFileAtomically(path.toStdString(), pictureWith({24, "{\"format\": 1}", 77}, ImageFormat::ExrHalf))
                    .ok());
        QProcess reader;
        reader.start("exrheader", {path});
        QVERIFY(reader.waitForFinished());
        const QByteArray seen = reader.readAllStandardOutput();
        QVERIFY2(seen.contains("fumage:preset.1 (type string): \"{\"format\": 1}\""), seen);
        QVERIFY2(seen.contains("fumage:frame (type int): 77"), seen);
    }

    void whatIsNoPictureIsNotTakenForOne()
    {
        QVERIFY(!isPicture(""));
        QVERIFY(!isPicture("\x89PNG"));
        QVERIFY(!isPicture("{\"format\""));
        QCOMPARE(readImageMetadata("GIF89a").error().code, ErrorCode::Syntax);
    }
};

QTEST_GUILESS_MAIN(ImageMetadataTest)
#include "image_metadata_test.moc"
