// Packed pictures: each channel is the one that was asked for, smaller ones are averages of it, and the side-car says
// so.

#include "core/export/sheets/flipbook_files.h"
#include "core/export/sheets/cell_frames.h"
#include "tests/helpers.h"
#include "tests/png_file.h"

#include "core/system/file.h"
#include "core/export/sheets/flipbook.h"
#include "core/export/sheets/sheet.h"

#include <QDir>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>

using namespace fumage;
using namespace fumage::tests;

namespace {

PackedPicture packOf(const char* text)
{
    const Result<PackedPicture> pack = parsePack(text);
    if (!pack) {
        qFatal("%s", pack.error().text().c_str());
    }
    return pack.value();
}

/// A small flipbook with packed pictures in a folder of its own.
struct Book {
    QTemporaryDir folder;
    FlipbookOptions options;
    Effect effect = everythingOn();

    explicit Book(std::initializer_list<const char*> packs)
    {
        effect.output.width = 24;
        effect.output.height = 16;
        options.output = folder.path().toStdString() + "/boom.png";
        options.columns = 2;
        options.rows = 2;
        options.frames = {10, 25, 1};
        for (const char* pack : packs) {
            options.packs.push_back(packOf(pack));
        }
    }
    [[nodiscard]] Result<Flipbook> write() const { return renderFlipbook(effect, options); }
    [[nodiscard]] PngFile picture(const char* name) const
    {
        return PngFile(folder.filePath(QString::fromLatin1(name)).toStdString());
    }
    [[nodiscard]] QJsonArray pictures() const
    {
        return QJsonDocument::fromJson(
            QByteArray::fromStdString(readFile(folder.path().toStdString() + "/boom.flipbook.json", 100'000).value()))
            .object()[QStringLiteral("pictures")]
            .toArray();
    }
};

} // namespace

class PackingTest : public QObject {
    Q_OBJECT

private slots:
    void channelsAreReadAndWritten_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("channels");
        QTest::addColumn<int>("divisor");
        QTest::newRow("one") << "m=alpha"
                             << "alpha" << 1;
        QTest::newRow("four and a part") << "masks=shadow,temperature,depth,alpha@1/2"
                                         << "shadow,temperature,depth,alpha" << 2;
        QTest::newRow("letters") << "m=colour.r,six-way-a.g,motion.g,normal.b"
                                 << "colour.r,six-way-a.g,motion.g,normal.b" << 1;
        QTest::newRow("other spellings") << "m= Color.R , sixway_b.a,0 ,1 @ 1/16"
                                         << "colour.r,six-way-b.a,0,1" << 16;
    }
    void channelsAreReadAndWritten()
    {
        QFETCH(QString, text);
        QFETCH(QString, channels);
        QFETCH(int, divisor);
        const PackedPicture pack = packOf(qPrintable(text));
        QStringList names;
        for (const PackedChannel& channel : pack.channels) {
            names << QString::fromStdString(textOf(channel));
        }
        QCOMPARE(names.join(','), channels);
        QCOMPARE(pack.divisor, divisor);
    }

    void wrongPacksAreRefusedWithWhatWasMeant_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("says");
        const auto row = [](const char* text, const char* says) { QTest::newRow(text) << text << says; };
        row("masks", "masks=shadow");
        row("m=alpha@1/3x", "@1/2");
        row("m=alpha@1/17", "@1/16");
        row("m=alpha@0", "@1/2");
        row("m=shadw", "Did you mean \"shadow\"?");
        row("m=colour", "Did you mean \"colour.r\"?");
        row("m=motion.b", "Did you mean \"motion.r\"?");
        row("m=rubbish-of-all-kinds", "six-way-a.r");
        row("m=", "there is no channel");
        row("m=alpha,,1", "there is no channel");
        row("m=0,0,0,0,0", "has 5 channels");
        row("=alpha", "named");
        row("a/b=alpha", "a/b");
        row("..=alpha", "named");
        row("-a=alpha", "named");
        row("Sixway_A=alpha", "name of a pass");
        row("motion=alpha", "name of a pass");
        row("aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa=alpha", "up to 40");
    }
    void wrongPacksAreRefusedWithWhatWasMeant()
    {
        QFETCH(QString, text);
        QFETCH(QString, says);
        const Result<PackedPicture> pack = parsePack(text.toStdString());
        QVERIFY(!pack.ok());
        QVERIFY2(QString::fromStdString(pack.error().text()).contains(says), pack.error().text().c_str());
    }

    void packsThatCannotBeTogetherAreRefused()
    {
        const auto errorOf = [](std::initializer_list<const char*> packs) {
            const Book book(packs);
            const Result<Flipbook> done = book.write();
            return done ? std::string() : done.error().text();
        };
        const auto says = [](const std::string& text, const char* part) {
            return text.find(part) != std::string::npos;
        };
        QVERIFY(says(errorOf({"a=alpha", "b=alpha", "c=alpha", "d=alpha", "e=alpha", "f=alpha"}), "6 packed"));
        QVERIFY(says(errorOf({"mask=alpha", "MASK=depth"}), "two packed pictures"));
        QVERIFY(says(errorOf({"mask=alpha@1/16"}), "24 x 16")); // 24 is no multiple of 16
        Book nothing({});
        nothing.options.passes = PassSet();
        QVERIFY(says(nothing.write().error().text(), "no pass"));
        QVERIFY(QDir(nothing.folder.path()).isEmpty());
    }

    void everyChannelIsTheOneThatWasAskedFor()
    {
        Book book(
            {"one=alpha", "two=shadow,depth", "three=colour.b,normal.g,motion.r", "four=six-way-a.a,0,1,six-way-b.g"});
        book.options.passes = parsePasses("all").value();
        QVERIFY(book.write().ok());
        struct Expected {
            const char* file;
            int channel;
            const char* pass; ///< null: the constant
            int from;
        };
        const std::array<Expected, 10> all{
            {{"boom_one.png", 0, "boom_alpha.png", 0}, {"boom_two.png", 0, "boom_shadow.png", 0},
                {"boom_two.png", 1, "boom_depth.png", 0}, {"boom_two.png", 2, nullptr, 0},
                {"boom_three.png", 0, "boom.png", 2}, {"boom_three.png", 1, "boom_normal.png", 1},
                {"boom_three.png", 2, "boom_motion.png", 0}, {"boom_four.png", 0, "boom_sixway_a.png", 3},
                {"boom_four.png", 2, nullptr, 255}, {"boom_four.png", 3, "boom_sixway_b.png", 1}}};
        for (const Expected& each : all) {
            const PngFile seen = book.picture(each.file);
            for (int y = 0; y < seen.height; ++y) {
                for (int x = 0; x < seen.width; ++x) {
                    QCOMPARE(seen.at(x, y, each.channel),
                        each.pass != nullptr ? book.picture(each.pass).at(x, y, each.from) : each.from);
                }
            }
        }
        QCOMPARE(book.picture("boom_one.png").channels, 1);
        QCOMPARE(book.picture("boom_two.png").channels, 3);
        QCOMPARE(book.picture("boom_three.png").channels, 3);
        QCOMPARE(book.picture("boom_four.png").channels, 4);
    }

    void aSmallerPictureIsTheAverage()
    {
        Book book({"large=alpha,six-way-a.r,depth", "small=alpha,six-way-a.r,depth@1/4"});
        book.options.format = ImageFormat::Png16;
        QVERIFY(book.write().ok());
        // The same numbers once more, unrounded.
        PassSheet sheet;
        PassSet passes = renderedPasses(book.options);
        passes.add(Pass::Colour);
        QVERIFY(renderSheet(book.effect, cellFramesOf(book.effect, book.options), 2, passes, sheet, {}).ok());
        const PassPictures pictures(sheet, passes, book.options.style);
        const Packer packer(sheet, pictures, book.options.style, book.effect, ImageFormat::ExrFloat);
        const DataImage large = packer.pack(book.options.packs[0]);
        const DataImage small = packer.pack(book.options.packs[1]);
        QCOMPARE(small.width, large.width / 4);
        QCOMPARE(small.height, large.height / 4);
        for (int y = 0; y < small.height; ++y) {
            for (int x = 0; x < small.width; ++x) {
                double alpha = 0.0;
                double light = 0.0;
                for (int j = 0; j < 4; ++j) {
                    for (int i = 0; i < 4; ++i) {
                        const float* p = large.values.data()
                            + static_cast<std::ptrdiff_t>((4 * y + j) * large.width + 4 * x + i) * 3;
                        alpha += static_cast<double>(p[0]) / 16.0;
                        light += static_cast<double>(p[0]) * static_cast<double>(p[1]) / 16.0;
                    }
                }
                const float* q = small.values.data() + static_cast<std::ptrdiff_t>(y * small.width + x) * 3;
                QVERIFY(near(q[0], alpha, 1e-5));
                QVERIFY(near(q[0] * q[1], light, 1e-5)); // as much light, whatever the edges of the smoke are like
            }
        }
    }

    void aSmallerColourIsTheAverageOfTheLight()
    {
        Book book({"small=colour.r,colour.g,colour.b,colour.a@1/2"});
        book.effect.output.background = Background::Transparent;
        PassSheet sheet;
        QVERIFY(renderSheet(book.effect, cellFramesOf(book.effect, book.options), 2, {Pass::Colour}, sheet, {}).ok());
        const PassPictures pictures(sheet, {Pass::Colour}, {});
        const DataImage small =
            Packer(sheet, pictures, {}, book.effect, ImageFormat::ExrFloat).pack(book.options.packs[0]);
        const Image expected = downsample(sheet.targets.of(PassTarget::Colour), 2);
        QVERIFY(std::equal(expected.pixels.begin(), expected.pixels.end(), small.values.begin(), small.values.end()));
    }

    void onlyWhatIsAskedForIsRendered()
    {
        Book book({"m=shadow,0"});
        book.options.passes = PassSet();
        QVERIFY(renderedPasses(book.options) == PassSet{Pass::Shadow});
        const Result<Flipbook> done = book.write();
        QVERIFY(done.ok());
        QCOMPARE(done.value().picture.filename().string(), std::string("boom_m.png"));
        QCOMPARE(QDir(book.folder.path()).entryList(QDir::Files), QStringList({"boom.flipbook.json", "boom_m.png"}));
    }

    void theSideCarSaysWhatChannelsHold()
    {
        const Book book({"masks=six-way-a.g,motion.r,colour.r,0@1/2"});
        QVERIFY(book.write().ok());
        const QJsonObject masks = book.pictures().last().toObject();
        QCOMPARE(masks["packed"].toString(), QStringLiteral("masks"));
        QCOMPARE(masks["file"].toString(), QStringLiteral("boom_masks.png"));
        QCOMPARE(masks["colour"].toString(), QStringLiteral("linear"));
        QCOMPARE(masks["cell_width"].toInt(), 12);
        const QJsonArray channels = masks["channels"].toArray();
        QCOMPARE(channels[0].toObject()["from"].toString(), QStringLiteral("six-way-a.g"));
        QCOMPARE(channels[0].toObject()["holds"].toString(), QStringLiteral("top"));
        QCOMPARE(channels[0].toObject()["linear"].toBool(), true);
        QVERIFY(channels[0].toObject()["scale"].toDouble() >= 1.0);
        QCOMPARE(channels[1].toObject()["holds"].toString(), QStringLiteral("right"));
        QCOMPARE(channels[1].toObject()["centre"].toDouble(), 0.5);
        QCOMPARE(channels[2].toObject()["linear"].toBool(true), false);
        QCOMPARE(channels[3].toObject()["from"].toString(), QStringLiteral("0"));
        QVERIFY(!channels[3].toObject().contains("holds"));
    }

    void coloursAloneAreSrgb()
    {
        const Book book({"heat=colour.r,colour.g,colour.b,temperature", "mix=colour.r,shadow,0"});
        QVERIFY(book.write().ok());
        QVERIFY(book.picture("boom_heat.png").hasSrgb);
        QVERIFY(!book.picture("boom_mix.png").hasSrgb);
        QCOMPARE(book.pictures()[1].toObject()["colour"].toString(), QStringLiteral("sRGB"));
        QCOMPARE(book.pictures()[2].toObject()["colour"].toString(), QStringLiteral("linear"));
    }

    void enginesImportThem()
    {
        Book book({"heat=colour.r,colour.g,colour.b,temperature", "way=motion.r,motion.g"});
        book.options.engine = Engine::Unreal;
        QVERIFY(book.write().ok());
        const std::string script = readFile(book.folder.path().toStdString() + "/boom_unreal.py", 100'000).value();
        QVERIFY2(script.find("(\"boom_heat.png\", True, False)") != std::string::npos, script.c_str());
        QVERIFY2(script.find("(\"boom_way.png\", False, True)") != std::string::npos, script.c_str());
    }
};

QTEST_GUILESS_MAIN(PackingTest)
#include "packing_test.moc"
