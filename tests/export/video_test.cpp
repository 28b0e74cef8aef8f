// Videos, with a program in the place of ffmpeg that keeps what it is given.

#include "tests/helpers.h"

#include "core/base/file.h"
#include "core/export/plan.h"
#include "core/rendering/compositor.h"
#include "core/rendering/view_transform.h"

#include <QDir>
#include <QFileInfo>
#include <QTemporaryDir>

using namespace fumage;
using namespace fumage::tests;

namespace {

Effect smallSmoke()
{
    Effect effect = thesisEffect(300);
    effect.output.width = 20;
    effect.output.height = 15;
    effect.output.background = Background::Transparent;
    effect.output.backgroundColour = {0.2F, 0.4F, 0.6F};
    effect.timeline.frameRate = 24;
    return effect;
}

std::string contentsOf(const QString& path)
{
    return readFile(path.toStdString(), std::size_t{1} << 26U).value();
}

} // namespace

class VideoTest : public QObject {
    Q_OBJECT

private slots:
    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        QVERIFY(m_folder->isValid());
    }

    void cleanup() { qunsetenv("FUMAGE_FFMPEG"); }

    void theProgramGetsEveryFrameAndItsFileTakesItsPlace()
    {
        pretend("for last; do :; done; echo \"$@\" > \"$0.arguments\"; cat > \"${last#file:}\"");
        const VideoOptions options{output(".webm"), {4, 10, 3}, VideoFormat::WebM};
        QVERIFY(renderVideo(smallSmoke(), options, {}).ok());
        std::string expected;
        for (const int frame : {4, 7, 10}) {
            EncodedImage<std::uint8_t> encoded;
            encode(render(smallSmoke(), frame), smallSmoke().output, encoded);
            expected.append(reinterpret_cast<const char*>(encoded.pixels.data()), encoded.pixels.size());
        }
        QVERIFY(contentsOf(QString::fromStdString(options.output.string())) == expected);
        const std::string arguments = contentsOf(m_folder->filePath("ffmpeg.arguments"));
        for (const char* part : {"-video_size 20x15", "-framerate 24/3", "-pix_fmt rgba ", "yuva420p", "-f webm"}) {
            QVERIFY2(arguments.find(part) != std::string::npos, part);
        }
        QCOMPARE(filesThere(), QStringList({"ffmpeg", "ffmpeg.arguments", "smoke.webm"}));
    }

    void whatHasNoTransparencyHasTheColourBehindIt()
    {
        pretend("for last; do :; done; cat > \"${last#file:}\"");
        for (const VideoFormat format : kAllVideoFormats) {
            const VideoOptions options{output(fileEnding(format)), {0, 0, 1}, format};
            Effect effect = smallSmoke();
            effect.output.viewTransform = ViewTransform::Filmic; // of the smoke, and not of what is behind it
            effect.output.exposure = 1.5F;
            QVERIFY(renderVideo(effect, options, {}).ok());
            const std::string bytes = contentsOf(QString::fromStdString(options.output.string()));
            const std::size_t sample = format == VideoFormat::QuickTime ? 2 : 1;
            QCOMPARE(bytes.size(), std::size_t{20} * 15 * 4 * sample);
            const auto corner = static_cast<unsigned char>(bytes[4 * sample - 1]);
            QCOMPARE(int(corner), hasAlpha(format) ? 0 : 255);
            for (int channel = 0; !hasAlpha(format) && channel < 3; ++channel) {
                const float shown = srgbFromLinear(effect.output.backgroundColour[channel]);
                QCOMPARE(int(static_cast<unsigned char>(bytes[static_cast<std::size_t>(channel)])), static_cast<int>(shown * 255.0F + 0.5F));
            }
        }
    }

    void whatTheProgramSaysIsTold()
    {
        pretend("echo no such encoder >&2; exit 3");
        const VideoOptions options{output(".mp4"), {0, 20, 1}, VideoFormat::Mp4};
        QVERIFY(writeFileAtomically(options.output, std::string_view("before")).ok());
        const Status status = renderVideo(smallSmoke(), options, {});
        QVERIFY(!status.ok());
        QCOMPARE(status.error().code, ErrorCode::WriteFailed);
        QVERIFY2(status.error().text().find("no such encoder") != std::string::npos, status.error().text().c_str());
        QCOMPARE(contentsOf(QString::fromStdString(options.output.string())), std::string("before"));
        QCOMPARE(filesThere(), QStringList({"ffmpeg", "smoke.mp4"}));
    }

    void aProgramThatFailsAtTheEndLeavesNoVideo()
    {
        pretend("cat > /dev/null; echo disk full >&2; exit 1");
        const Status status = renderVideo(smallSmoke(), {output(".gif"), {0, 2, 1}, VideoFormat::Gif}, {});
        QVERIFY(!status.ok() && status.error().text().find("disk full") != std::string::npos);
        QCOMPARE(filesThere(), QStringList("ffmpeg"));
    }

    void withoutTheProgramTheRemedyIsNamed()
    {
        qputenv("FUMAGE_FFMPEG", "/no/such/ffmpeg");
        const Status status = renderVideo(smallSmoke(), {output(".mp4"), {0, 2, 1}, VideoFormat::Mp4}, {});
        QVERIFY(!status.ok());
        QCOMPARE(status.error().code, ErrorCode::FileNotFound);
        QVERIFY(status.error().text().find("install it") != std::string::npos);
        QVERIFY(filesThere().isEmpty());
    }

    void cancellingEndsTheProgram()
    {
        pretend("echo $$ > \"$0.id\"; exec sleep 1000"); // takes nothing
        std::stop_source stop;
        const VideoOptions options{output(".mp4"), {0, 500, 1}, VideoFormat::Mp4};
        const Status status = renderVideo(
            smallSmoke(), options, [&](int done, int) {
                if (done == 3) {
                    // Frames fit into its pipe before it has begun.
                    QVERIFY(QTest::qWaitFor([&] { return QFileInfo(m_folder->filePath("ffmpeg.id")).size() > 0; }));
                    stop.request_stop();
                }
            },
            stop.get_token());
        QVERIFY(!status.ok());
        QCOMPARE(status.error().code, ErrorCode::Cancelled);
        const std::string id = contentsOf(m_folder->filePath("ffmpeg.id"));
        QVERIFY(!QFile::exists("/proc/" + QString::fromStdString(id).trimmed()));
        QCOMPARE(filesThere(), QStringList({"ffmpeg", "ffmpeg.id"}));
    }

    void aPlanForAVideoIsCarriedOut()
    {
        pretend("for last; do :; done; cat > \"${last#file:}\"");
        ExportPlan plan;
        plan.kind = ExportKind::Video;
        plan.video = VideoFormat::Apng;
        plan.output = output(".apng");
        plan.frames = {0, 3, 1};
        QVERIFY(runExport(smallSmoke(), plan, {}).ok());
        QVERIFY(std::filesystem::file_size(plan.output) == std::uintmax_t{20} * 15 * 4 * 4);
        plan.source = plan.output;
        QCOMPARE(runExport(smallSmoke(), plan, {}).error().code, ErrorCode::WouldOverwrite);
        QVERIFY(!exportBytes(smallSmoke(), plan).ok());
    }

private:
    /// Puts a shell script in the place of ffmpeg.
    void pretend(const QByteArray& script)
    {
        QFile file(m_folder->filePath("ffmpeg"));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("#!/bin/sh\n" + script + "\n");
        file.close();
        QVERIFY(file.setPermissions(QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner));
        qputenv("FUMAGE_FFMPEG", file.fileName().toUtf8());
    }

    [[nodiscard]] std::filesystem::path output(std::string_view ending) const { return m_folder->filePath("smoke").toStdString() + std::string(ending); }

    [[nodiscard]] QStringList filesThere() const { return QDir(m_folder->path()).entryList(QDir::Files | QDir::Hidden, QDir::Name); }

    std::unique_ptr<QTemporaryDir> m_folder;
};

QTEST_GUILESS_MAIN(VideoTest)
#include "video_test.moc"
