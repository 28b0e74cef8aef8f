// Frames that were rendered to EXR become what rendering at once gives.
#include "tests/export/small_smoke.h"
#include "tests/helpers.h"

#include "core/system/file.h"
#include "core/export/plan.h"
#include "core/image_io/picture_pixels.h"

#include <QTemporaryDir>

using namespace fumage;
using namespace fumage::tests;

namespace {

/// Enough of it to be seen, in a picture that is no square.
Effect seenSmoke()
{
    Effect effect = smallSmoke();
    effect.emitter.count = 2000;
    effect.output.height = 20;
    effect.output.background = Background::Transparent;
    return effect;
}

RgbaPixels pixelsOf(const std::filesystem::path& file)
{
    const std::string bytes = readFile(file, 1U << 24U).value();
    return readPixels(std::as_bytes(std::span(bytes))).value();
}

} // namespace

class JoinTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { QVERIFY(renderSequence(seenSmoke(), {frames(), {20, 31, 1}, ImageFormat::ExrFloat}).ok()); }

    void aJoinedSheetIsTheRenderedOne()
    {
        FlipbookOptions options{folder() / "rendered.png", 3, 2, {20, 31, 1}};
        const Effect effect = seenSmoke();
        const Result<Flipbook> rendered = renderFlipbook(effect, options);
        QVERIFY(rendered.ok());
        options.output = folder() / "joined.png";
        const Result<Flipbook> joined = joinFlipbook(effect, options, framesOfFiles(frames(), options.frames, 24, 20));
        QVERIFY2(joined.ok(), joined ? "" : joined.error().text().c_str());
        QVERIFY(pixelsOf(folder() / "joined.png").values == pixelsOf(folder() / "rendered.png").values);
        QCOMPARE(joined.value().cellsPerSecond, rendered.value().cellsPerSecond);
        QVERIFY(std::filesystem::exists(folder() / "joined.flipbook.json"));
    }

    void passesCannotBeJoined()
    {
        FlipbookOptions options{folder() / "passes.png", 3, 2, {20, 31, 1}};
        options.passes.add(Pass::Motion);
        const Result<Flipbook> joined =
            joinFlipbook(seenSmoke(), options, framesOfFiles(frames(), options.frames, 24, 20));
        QVERIFY(!joined.ok());
        QCOMPARE(joined.error().code, ErrorCode::OutOfRange);
        QVERIFY(!std::filesystem::exists(folder() / "passes.png"));
    }

    void framesThatAreNotThereAreNamed()
    {
        const FlipbookOptions options{folder() / "more.png", 3, 2, {26, 33, 1}};
        const Result<Flipbook> joined =
            joinFlipbook(seenSmoke(), options, framesOfFiles(frames(), options.frames, 24, 20));
        QVERIFY(!joined.ok());
        QCOMPARE(joined.error().code, ErrorCode::FileNotFound);
        QVERIFY2(joined.error().text().find("f_32.exr") != std::string::npos, joined.error().text().c_str());
    }

    void framesOfAnotherSizeAreRefused()
    {
        Image image;
        const Status status = framesOfFiles(frames(), {20, 31, 1}, 24, 24)(20, image);
        QVERIFY(!status.ok() && status.error().code == ErrorCode::WrongType);
    }

private:
    [[nodiscard]] std::filesystem::path folder() const { return m_folder.path().toStdString(); }
    [[nodiscard]] std::filesystem::path frames() const { return folder() / "f_##.exr"; }

    QTemporaryDir m_folder;
};

QTEST_GUILESS_MAIN(JoinTest)
#include "join_test.moc"
