// Videos, with a program in the place of ffmpeg that keeps what it is given.

#include "tests/helpers.h"

#include "core/system/file.h"
#include "core/export/plan.h"
#include "core/rendering/compositor.h"
#include "core/rendering/view_transform.h"

#include <QDir>
#include <QFileInfo>
#include <QProcess>
#include <QTemporaryDir>

#include <algorithm>
#include <numeric>
#include <optional>

#include <sys/resource.h>
#include <unistd.h>

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

/// A program that is installed, done to its end.
std::optional<QByteArray> makeMessage(const QString& program, const QStringList& arguments)
{
    QProcess process;
    process.start(program, arguments);
    const bool done = process.waitForStarted() && process.waitForFinished(60000) && process.exitCode() == 0;
    return done ? std::optional(process.readAllStandardOutput()) : std::nullopt;
}

bool isThere(const QString& program)
{
    return makeMessage(program, {QStringLiteral("-version")}).has_value();
}

/// How long the pictures of a GIF are shown, hundredths of a second.
std::vector<int> delaysOf(const std::string& gif)
{
    std::vector<int> delays;
    for (std::size_t at = gif.find("\x21\xF9\x04"); at != std::string::npos; at = gif.find("\x21\xF9\x04", at + 1)) {
        delays.push_back(static_cast<unsigned char>(gif[at + 4]) + 256 * static_cast<unsigned char>(gif[at + 5]));
    }
    return delays;
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
        QVERIFY(renderVideo(smallSmoke(), options).ok());
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
            QVERIFY(renderVideo(effect, options).ok());
            const std::string bytes = contentsOf(QString::fromStdString(options.output.string()));
            const std::size_t sample = format == VideoFormat::QuickTime ? 2 : 1;
            const auto [width, height] = sizeOf(smallSmoke().output, format);
            QCOMPARE(bytes.size(), static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4 * sample);
            const auto corner = static_cast<unsigned char>(bytes[4 * sample - 1]);
            QCOMPARE(int(corner), hasAlpha(format) ? 0 : 255);
            for (int channel = 0; !hasAlpha(format) && channel < 3; ++channel) {
                const float shown = srgbFromLinear(effect.output.backgroundColour[channel]);
                QCOMPARE(int(static_cast<unsigned char>(bytes[static_cast<std::size_t>(channel)])),
                    static_cast<int>(shown * 255.0F + 0.5F));
            }
        }
    }

    void whatTheProgramSaysIsTold()
    {
        pretend("echo no such encoder >&2; exit 3");
        const VideoOptions options{output(".mp4"), {0, 20, 1}, VideoFormat::Mp4};
        QVERIFY(writeFileAtomically(options.output, std::string_view("before")).ok());
        const Status status = renderVideo(smallSmoke(), options);
        QVERIFY(!status.ok());
        QCOMPARE(status.error().code, ErrorCode::WriteFailed);
        QVERIFY2(status.error().text().find("no such encoder") != std::string::npos, status.error().text().c_str());
        QCOMPARE(contentsOf(QString::fromStdString(options.output.string())), std::string("before"));
        QCOMPARE(filesThere(), QStringList({"ffmpeg", "smoke.mp4"}));
    }

    void aProgramThatFailsAtTheEndLeavesNoVideo()
    {
        pretend("cat > /dev/null; echo disk full >&2; exit 1");
        const Status status = renderVideo(smallSmoke(), {output(".gif"), {0, 2, 1}, VideoFormat::Gif});
        QVERIFY(!status.ok() && status.error().text().find("disk full") != std::string::npos);
        QCOMPARE(filesThere(), QStringList("ffmpeg"));
    }

    void aProgramThatWritesNothingLeavesNoVideo()
    {
        pretend("cat > /dev/null");
        for (const VideoFormat format : kAllVideoFormats) {
            const Status status = renderVideo(smallSmoke(), {output(fileEnding(format)), {0, 2, 1}, format});
            QVERIFY(!status.ok() && status.error().text().find("has written no video") != std::string::npos);
            QCOMPARE(status.error().code, ErrorCode::NotAFile);
            QCOMPARE(filesThere(), QStringList("ffmpeg"));
        }
    }

    void whatThereIsTooLittleOfIsNamedInPlaceOfFfmpeg()
    {
        pretend("cat > /dev/null");
        rlimit before{};
        QCOMPARE(getrlimit(RLIMIT_NOFILE, &before), 0);
        const int next = ::dup(0);
        ::close(next);
        rlimit few = before;
        few.rlim_cur = static_cast<rlim_t>(next) + 3; // the draft and its folder, and no connection to a program
        QCOMPARE(setrlimit(RLIMIT_NOFILE, &few), 0);
        const Status status = renderVideo(smallSmoke(), {output(".mp4"), {0, 2, 1}, VideoFormat::Mp4});
        QCOMPARE(setrlimit(RLIMIT_NOFILE, &before), 0);
        QVERIFY(!status.ok());
        QCOMPARE(status.error().code, ErrorCode::OutOfMemory);
        QVERIFY2(status.error().text().find("install") == std::string::npos
                && status.error().text().find("ulimit") != std::string::npos,
            status.error().text().c_str());
    }

    void withoutTheProgramTheRemedyIsNamed()
    {
        qputenv("FUMAGE_FFMPEG", "/no/such/ffmpeg");
        const Status status = renderVideo(smallSmoke(), {output(".mp4"), {0, 2, 1}, VideoFormat::Mp4});
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
        const auto stopAtThree = [&](int done, int) {
            if (done == 3) {
                // Frames fit into its pipe before it has begun.
                QVERIFY(QTest::qWaitFor([&] { return QFileInfo(m_folder->filePath("ffmpeg.id")).size() > 0; }));
                stop.request_stop();
            }
        };
        const Status status = renderVideo(smallSmoke(), options, {stopAtThree, stop.get_token()});
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
        plan.video.format = VideoFormat::Apng;
        plan.output = output(".apng");
        plan.frames = {0, 3, 1};
        QVERIFY(runExport(smallSmoke(), plan).ok());
        QVERIFY(std::filesystem::file_size(plan.output) == std::uintmax_t{20} * 15 * 4 * 4);
        plan.source = plan.output;
        QCOMPARE(runExport(smallSmoke(), plan).error().code, ErrorCode::WouldOverwrite);
        QVERIFY(!exportBytes(smallSmoke(), plan).ok());
    }

    void ratesAreReadAsTheyAreMeant_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<int>("frames");
        QTest::addColumn<int>("seconds");
        QTest::newRow("whole") << "24" << 24 << 1;
        QTest::newRow("film on television") << "23.976" << 24000 << 1001;
        QTest::newRow("rounded") << "23.98" << 24000 << 1001;
        QTest::newRow("television") << "29.97" << 30000 << 1001;
        QTest::newRow("twice") << "59.94" << 60000 << 1001;
        QTest::newRow("half") << "12.5" << 25 << 2;
        QTest::newRow("fraction") << "30000/1001" << 30000 << 1001;
    }
    void ratesAreReadAsTheyAreMeant()
    {
        QFETCH(QString, text);
        QFETCH(int, frames);
        QFETCH(int, seconds);
        const Result<FrameRate> rate = parseFrameRate(text.toStdString());
        QVERIFY(rate.ok());
        QVERIFY((rate.value() == FrameRate{frames, seconds}));
        QVERIFY(parseFrameRate(textOf(rate.value())).value() == rate.value());
    }

    void whatIsNoRateIsRefused()
    {
        for (const char* text :
            {"", "0", "-24", "nan", "inf", "241", "1/2", "24/0", "24000/1001/2", "24 fps", "99999999999999999999/1"}) {
            QVERIFY2(!parseFrameRate(text).ok(), text);
        }
    }

    void theProgramHearsTheRateAndHowOftenItIsPlayed()
    {
        pretend("for last; do :; done; echo \"$@\" > \"$0.arguments\"; cat > \"${last#file:}\"");
        Effect effect = smallSmoke();
        for (const bool loop : {false, true}) {
            effect.timeline.loop = loop;
            effect.timeline.length = 4;
            for (const VideoFormat format : kAllVideoFormats) {
                for (const Repeat repeat : {Repeat::Auto, Repeat::Once, Repeat::Forever}) {
                    for (const int last : {2, 3}) { // of which one is no whole turn
                        const VideoOptions options{
                            output(fileEnding(format)), {0, last, 1}, format, repeat, FrameRate{24000, 1001}};
                        QVERIFY(renderVideo(effect, options).ok());
                        const std::string arguments = contentsOf(m_folder->filePath("ffmpeg.arguments"));
                        QVERIFY(arguments.find("-framerate 24000/1001 ") != std::string::npos);
                        const bool endless = repeat == Repeat::Forever || (repeat == Repeat::Auto && loop && last == 3);
                        QCOMPARE(arguments.find(endless ? "-loop 0 " : "-loop -1 ") != std::string::npos,
                            format == VideoFormat::Gif);
                        QCOMPARE(arguments.find(endless ? "-plays 0 " : "-plays 1 ") != std::string::npos,
                            format == VideoFormat::Apng);
                    }
                }
            }
        }
    }

    void noPictureOfAGifIsTooShortForBrowsers()
    {
        if (!isThere(QStringLiteral("ffmpeg"))) {
            QSKIP("ffmpeg is not installed");
        }
        Effect effect = smallSmoke();
        for (const int rate : {24, 25, 30, 48, 50, 51, 60, 75, 90, 100, 120, 144, 240}) {
            for (const int step : {1, 2}) {
                effect.timeline.frameRate = rate;
                const VideoOptions options{output(".gif"), {0, 47, step}, VideoFormat::Gif};
                QVERIFY(renderVideo(effect, options).ok());
                const std::vector<int> delays = delaysOf(contentsOf(QString::fromStdString(options.output.string())));
                QCOMPARE(delays.size(), static_cast<std::size_t>(framesOf(effect, options).count()));
                QVERIFY(*std::min_element(delays.begin(), delays.end()) >= 2);
                const double wanted = 100.0 * 48.0 / rate;
                const double longest = 100.0 * framesOf(effect, options).step / rate; // of a picture
                QVERIFY(near(std::accumulate(delays.begin(), delays.end(), 0.0), wanted, longest + 2.0));
            }
        }
    }

    void aLoopStaysOneInAGifWherePicturesAreLeftOut()
    {
        Effect effect = smallSmoke();
        effect.timeline.frameRate = 120;
        const VideoOptions options{output(".gif"), {0, 99, 1}, VideoFormat::Gif};
        QCOMPARE(framesOf(effect, options).step, 4); // 3 would do, but does not divide 100
        const VideoOptions mp4{output(".mp4"), {0, 99, 1}, VideoFormat::Mp4};
        QCOMPARE(framesOf(effect, mp4).step, 1);
    }

    void framesOfProResSayWhatTheirColoursAre()
    {
        if (!isThere(QStringLiteral("ffprobe")) || !isThere(QStringLiteral("ffmpeg"))) {
            QSKIP("ffmpeg is not installed");
        }
        for (const VideoFormat format : {VideoFormat::Mp4, VideoFormat::WebM, VideoFormat::QuickTime}) {
            const VideoOptions options{output(fileEnding(format)), {0, 1, 1}, format};
            QVERIFY(renderVideo(smallSmoke(), options).ok());
            const auto facts = makeMessage(QStringLiteral("ffprobe"),
                {QStringLiteral("-v"), QStringLiteral("error"), QStringLiteral("-show_entries"),
                    QStringLiteral("frame=color_space,color_primaries"),
                    QString::fromStdString(options.output.string())});
            QVERIFY(facts);
            QVERIFY2(facts->count("color_space=bt709") == 2 && facts->count("color_primaries=bt709") == 2,
                facts->constData());
        }
    }

    void oddEdgesAreNeverBlack_data()
    {
        QTest::addColumn<int>("width");
        QTest::addColumn<int>("height");
        QTest::newRow("65x63") << 65 << 63;
        QTest::newRow("161x121") << 161 << 121;
        QTest::newRow("64x63") << 64 << 63;
        QTest::newRow("1x1") << 1 << 1;
    }
    void oddEdgesAreNeverBlack()
    {
        if (!isThere(QStringLiteral("ffmpeg"))) {
            QSKIP("ffmpeg is not installed");
        }
        QFETCH(int, width);
        QFETCH(int, height);
        Effect effect = smallSmoke();
        effect.output.width = width;
        effect.output.height = height;
        effect.output.background = Background::Colour;
        for (const glm::vec3 colour : {glm::vec3(1.0F), glm::vec3(0.05F, 0.1F, 0.18F)}) {
            effect.output.backgroundColour = colour;
            for (const VideoFormat format :
                {VideoFormat::Mp4, VideoFormat::WebM, VideoFormat::QuickTime, VideoFormat::Apng}) {
                const VideoOptions options{output(fileEnding(format)), {0, 0, 1}, format};
                const Status status = renderVideo(effect, options);
                QVERIFY2(status.ok(), status.ok() ? "" : status.error().text().c_str());
                const auto raw = makeMessage(QStringLiteral("ffmpeg"),
                    {QStringLiteral("-v"), QStringLiteral("error"), QStringLiteral("-i"),
                        QString::fromStdString(options.output.string()), QStringLiteral("-f"),
                        QStringLiteral("rawvideo"), QStringLiteral("-pix_fmt"), QStringLiteral("rgb24"),
                        QStringLiteral("-")});
                const auto size = sizeOf(effect.output, format);
                const int wide = size[0];
                const int high = size[1];
                QVERIFY(raw && raw->size() == qsizetype{3} * wide * high);
                const auto at = [&](int x, int y, int channel) {
                    return static_cast<int>(
                        static_cast<unsigned char>((*raw)[(qsizetype{y} * wide + x) * 3 + channel]));
                };
                // What holds transparency has the size that was asked for: nothing is added to it.
                QVERIFY(!hasAlpha(format) || (wide == width && high == height));
                for (int channel = 0; !hasAlpha(format) && channel < 3; ++channel) {
                    // The corners are background; the one that may have been added is as the one that was there.
                    QVERIFY2(std::abs(at(wide - 1, high - 1, channel) - at(0, 0, channel)) <= 6,
                        qPrintable(QStringLiteral("%1: %2 beside %3")
                                       .arg(static_cast<int>(format))
                                       .arg(at(wide - 1, high - 1, channel))
                                       .arg(at(0, 0, channel))));
                }
            }
        }
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

    [[nodiscard]] std::filesystem::path output(std::string_view ending) const
    {
        return m_folder->filePath("smoke").toStdString() + std::string(ending);
    }

    [[nodiscard]] QStringList filesThere() const
    {
        return QDir(m_folder->path()).entryList(QDir::Files | QDir::Hidden, QDir::Name);
    }

    std::unique_ptr<QTemporaryDir> m_folder;
};

QTEST_GUILESS_MAIN(VideoTest)
#include "video_test.moc"
