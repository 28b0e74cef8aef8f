// Small pictures of every built-in preset, held against their stored checksums bit for bit: any machine and compiler gives these.
// They change only on purpose: FUMAGE_WRITE_GOLDEN=1 writes the file anew.

#include "tests/helpers.h"

#include "core/preset/library.h"

#include <QCryptographicHash>
#include <QFile>

using namespace fumage;
using namespace fumage::tests;

namespace {

constexpr int kEdge = 96;
constexpr int kFrame = 45;

QByteArray checksum(const Image& image)
{
    const QByteArray bytes = QByteArray::fromRawData(reinterpret_cast<const char*>(image.pixels.data()), static_cast<qsizetype>(image.pixels.size() * sizeof(float)));
    return QCryptographicHash::hash(bytes, QCryptographicHash::Sha256).toHex().left(24);
}

QByteArray lineOf(const LibraryEntry& entry)
{
    Effect effect = loadPreset(entry).value().preset.effect;
    effect.emitter.count = std::min(effect.emitter.count, 20000);
    effect.output.width = kEdge;
    effect.output.height = kEdge;
    return QByteArray::fromStdString(entry.id) + " " + checksum(render(effect, kFrame));
}

} // namespace

class GoldenTest : public QObject {
    Q_OBJECT

private slots:
    void picturesOfThePresets_data()
    {
        QTest::addColumn<QByteArray>("expected");
        QFile file(FUMAGE_GOLDEN_FILE);
        if (qEnvironmentVariableIsSet("FUMAGE_WRITE_GOLDEN")) {
            QVERIFY(file.open(QIODevice::WriteOnly));
            for (const LibraryEntry& entry : builtinPresets()) {
                file.write(lineOf(entry) + "\n");
            }
            file.close();
        }
        QVERIFY(file.open(QIODevice::ReadOnly));
        QHash<QByteArray, QByteArray> lines;
        for (const QByteArray& line : file.readAll().split('\n')) {
            lines.insert(line.split(' ').first(), line);
        }
        for (const LibraryEntry& entry : builtinPresets()) {
            QTest::newRow(entry.id.c_str()) << lines.value(QByteArray::fromStdString(entry.id));
        }
    }
    void picturesOfThePresets()
    {
        QFETCH(QByteArray, expected);
        for (const LibraryEntry& entry : builtinPresets()) {
            if (entry.id == QTest::currentDataTag()) {
                QCOMPARE(lineOf(entry), expected);
            }
        }
    }
};

QTEST_GUILESS_MAIN(GoldenTest)
#include "golden_test.moc"
