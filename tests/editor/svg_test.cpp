// What draws the program's icons: outlines against closed forms, and every icon that is brought along.
#include "editor_helpers.h"

#include "ui/theme/icons.h"
#include "ui/theme/svg_drawing.h"
#include "ui/theme/svg_path.h"
#include "ui/theme/theme.h"

#include <QDirIterator>
#include <QFile>
#include <QIcon>
#include <QIconEnginePlugin>
#include <QPainter>
#include <QPluginLoader>

#include <cmath>
#include <numbers>

using namespace fumage::tests;

namespace {

/// Of one outline, by Gauss's formula.
double areaOf(const QPainterPath& path)
{
    const QPolygonF points = QTransform::fromScale(100.0, 100.0).map(path).toFillPolygon();
    double twice = 0.0;
    for (qsizetype i = 0; i + 1 < points.size(); ++i) {
        twice += points[i].x() * points[i + 1].y() - points[i + 1].x() * points[i].y();
    }
    return std::abs(twice) / 2.0 / 1e4;
}

QPainterPath pathOf(const QString& data)
{
    const std::optional<QPainterPath> path = readSvgPath(data);
    return path.value_or(QPainterPath());
}

struct Drawn {
    bool isKnown;
    QImage image;
};

/// @param inside of a view box of 10 by 10, drawn on 20 by 20 pixels
Drawn draw(const QByteArray& inside)
{
    Drawn drawn{false, QImage(20, 20, QImage::Format_ARGB32_Premultiplied)};
    drawn.image.fill(Qt::transparent);
    QPainter painter(&drawn.image);
    drawn.isKnown = drawSvg(painter, "<svg viewBox=\"0 0 10 10\">" + inside + "</svg>", drawn.image.rect());
    return drawn;
}

} // namespace

class SvgTest : public QObject {
    Q_OBJECT

private slots:
    void everyIconIsKnownWhole()
    {
        int count = 0;
        for (const QString& folder : {u":/icons"_q, u":/theme"_q}) {
            QDirIterator icons(folder, {u"*.svg"_q});
            while (icons.hasNext()) {
                QFile file(icons.next());
                QVERIFY(file.open(QIODevice::ReadOnly));
                QImage image(24, 24, QImage::Format_ARGB32_Premultiplied);
                image.fill(Qt::transparent);
                const QImage empty = image;
                QPainter painter(&image);
                QVERIFY2(drawSvg(painter, file.readAll().replace("currentColor", "#808080"), image.rect()),
                    qPrintable(file.fileName()));
                painter.end();
                QVERIFY2(image != empty, qPrintable(file.fileName()));
                ++count;
            }
        }
        QVERIFY(count > 40);
    }

    void theProgramHasAnEngineForWhatAStyleSheetNames()
    {
        applyTheme(*qApp, Theme::Dark, true);
        // Where Qt's own module is installed, its engine may be the one that is taken.
        QVERIFY(QIcon(u":/icons/fumage.svg"_q).pixmap(64, 64).toImage().pixelColor(32, 32).alpha() == 255);
        const QImage expected = themedIcon(u"fumage"_q).pixmap(64, 64).toImage();
        int engines = 0;
        for (QObject* plugin : QPluginLoader::staticInstances()) {
            if (auto* factory = qobject_cast<QIconEnginePlugin*>(plugin)) {
                const QIcon icon(factory->create(u":/icons/fumage.svg"_q));
                engines += icon.pixmap(64, 64).toImage() == expected ? 1 : 0;
            }
        }
        QCOMPARE(engines, 1);
    }

    void outlinesHaveTheAreaOfTheirClosedForms_data()
    {
        using std::numbers::pi;
        QTest::addColumn<QString>("data");
        QTest::addColumn<double>("area");
        QTest::newRow("box") << u"M1 1h4v3h-4z"_q << 12.0;
        QTest::newRow("box, absolute") << u"M1,1 H5 V4 H1 Z"_q << 12.0;
        QTest::newRow("lines that follow a move") << u"M0 0 4 0 4 2"_q << 4.0;
        QTest::newRow("lines that follow a relative move") << u"m1 1 4 0 0 2z"_q << 4.0;
        QTest::newRow("numbers without spaces") << u"M.5.5l4-0 0+2-4 0z"_q << 8.0;
        QTest::newRow("half a circle") << u"M0 0A5 5 0 0 1 10 0z"_q << 12.5 * pi;
        QTest::newRow("an arc too small for its ends") << u"M0 0a1 1 0 0 1 10 0z"_q << 12.5 * pi;
        QTest::newRow("three quarters and the triangle") << u"M0 0a5 5 0 1 1 5 5z"_q << 18.75 * pi + 12.5;
        QTest::newRow("a quarter without its triangle") << u"M0 0a5 5 0 0 1 5 5z"_q << 6.25 * pi - 12.5;
        QTest::newRow("flags without spaces") << u"M0 0a5 5 0 015 5z"_q << 6.25 * pi - 12.5;
        QTest::newRow("half an ellipse on end") << u"M0 0a4 2 90 0 1 0 8z"_q << 4.0 * pi;
        QTest::newRow("a curve that is a line") << u"M0 0c2 0 4 0 6 0l0 2z"_q << 6.0;
    }
    void outlinesHaveTheAreaOfTheirClosedForms()
    {
        QFETCH(QString, data);
        QFETCH(double, area);
        const double seen = areaOf(pathOf(data));
        QVERIFY2(std::abs(seen - area) < 2e-3 * area, qPrintable(QString::number(seen)));
    }

    void anArcLiesOnTheSideThatItsFlagSays()
    {
        QVERIFY(std::abs(pathOf(u"M0 0A5 5 0 0 1 10 0"_q).boundingRect().top() + 5.0) < 0.01); // y is down
        QVERIFY(std::abs(pathOf(u"M0 0A5 5 0 0 0 10 0"_q).boundingRect().bottom() - 5.0) < 0.01);
    }

    void aSmoothCurveMirrorsTheLastControlPoint()
    {
        QCOMPARE(pathOf(u"M0 0C0 1 1 2 2 2S4 1 4 0"_q), pathOf(u"M0 0C0 1 1 2 2 2C3 2 4 1 4 0"_q));
        QCOMPARE(pathOf(u"M0 0c0 1 1 2 2 2s2-1 2-2"_q), pathOf(u"M0 0C0 1 1 2 2 2C3 2 4 1 4 0"_q));
        QCOMPARE(pathOf(u"M0 0H2S4 1 4 0"_q), pathOf(u"M0 0L2 0C2 0 4 1 4 0"_q)); // there is none before
    }

    void whatIsNoPathIsSaid()
    {
        for (const QString& data :
            {u"M0 0Q1 1 2 2"_q, u"M0"_q, u"M0 x"_q, u"1 2"_q, u"M0 0z1"_q, u"M0 0a1 1 0 2 0 1 1"_q, u"M0 0L1 -"_q}) {
            QVERIFY2(!readSvgPath(data), qPrintable(data));
        }
        QVERIFY(readSvgPath(QString()));
    }

    void coloursAndOpacityAreThoseOfTheElementOrOfWhatItIsIn()
    {
        const QRgb inherited =
            draw("<g fill=\"#ff0000\"><rect x=\"0\" y=\"0\" width=\"10\" height=\"10\"/></g>").image.pixel(10, 10);
        QCOMPARE(inherited, qRgba(255, 0, 0, 255));
        QCOMPARE(draw("<g fill=\"#ff0000\"/><circle cx=\"5\" cy=\"5\" r=\"4\"/>").image.pixel(10, 10),
            qRgba(0, 0, 0, 255)); // black where nothing is said
        const QColor half =
            draw("<g opacity=\"0.5\"><ellipse cx=\"5\" cy=\"5\" rx=\"4\" ry=\"3\" opacity=\"0.5\"/></g>")
                .image.pixelColor(10, 10);
        QVERIFY(std::abs(half.alphaF() - 0.25F) < 0.01F);
        QCOMPARE(qAlpha(draw("<path d=\"M0 0h10v10\" fill=\"none\"/>").image.pixel(15, 5)), 0);
        QCOMPARE(draw("<path d=\"M0 5h10\" stroke=\"#00ff00\" stroke-width=\"4\"/>").image.pixel(10, 10),
            qRgba(0, 255, 0, 255));
    }

    void aGradientGoesOverTheBoxOfTheShape()
    {
        const Drawn drawn =
            draw("<defs><linearGradient id=\"a\" x1=\"0\" y1=\"0\" x2=\"0\" y2=\"1\">"
                 "<stop offset=\"0\" stop-color=\"#000000\"/><stop offset=\"1\" stop-color=\"#ffffff\"/>"
                 "</linearGradient></defs><rect x=\"0\" y=\"5\" width=\"10\" height=\"5\" fill=\"url(#a)\"/>");
        QVERIFY(drawn.isKnown);
        QVERIFY(qRed(drawn.image.pixel(10, 10)) < 30);
        QVERIFY(qRed(drawn.image.pixel(10, 19)) > 225);
        QVERIFY(std::abs(qRed(drawn.image.pixel(10, 15)) - 128) < 20);
    }

    void whatIsNotKnownIsSaid()
    {
        QVERIFY(draw("<rect width=\"1\" height=\"1\"/>").isKnown);
        for (const char* inside :
            {"<text>a</text>", "<rect width=\"1\" height=\"1\" fill=\"red;\"/>", "<rect width=\"1px\" height=\"1\"/>",
                "<rect width=\"1\" height=\"1\" fill=\"url(#no)\"/>", "<path d=\"M0 0T1 1\"/>", "<g>"}) {
            QVERIFY2(!draw(inside).isKnown, inside);
        }
        QImage image(4, 4, QImage::Format_ARGB32_Premultiplied);
        QPainter painter(&image);
        QVERIFY(!drawSvg(painter, "<svg/>", image.rect())); // no view box
    }
};

QTEST_MAIN(SvgTest)
#include "svg_test.moc"
