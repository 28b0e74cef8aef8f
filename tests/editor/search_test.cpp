// What is found by the words that people type, in the panel and in the search for commands.
#include "panel_fixture.h"

#include "ui/document/layer_edits.h"
#include "ui/document/search_index.h"

#include "core/effect/known_parameter.h"
#include "core/effect/shown_table.h"
#include "core/effect/assignment.h"
#include "core/effect/value.h"

#include <QLabel>
#include <QLineEdit>
#include <QToolButton>
#include <QTranslator>

#include <algorithm>
#include <array>

using namespace fumage;
using namespace fumage::tests;

namespace {

/// Keys of all parameters that are found, the best first.
QStringList found(const QString& text)
{
    SearchIndex index;
    for (const Parameter* parameter : shownParameters()) {
        index.add(searchTextsOf(*parameter));
    }
    const std::vector<double> scores = index.scores(text);
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < scores.size(); ++i) {
        if (scores[i] > 0.0) {
            order.push_back(i);
        }
    }
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return scores[a] > scores[b]; });
    QStringList keys;
    for (const std::size_t i : order) {
        keys += toQString(shownParameters()[i]->key);
    }
    return keys;
}

} // namespace

class SearchTest : public PanelFixture {
    Q_OBJECT

private slots:
    void aPlainWordFindsItsParameterAmongTheFirstThree_data()
    {
        QTest::addColumn<QString>("key");
        const auto add = [](const char* word, const char* key) { QTest::newRow(word) << QString::fromLatin1(key); };
        add("thick", "look.opacity");
        add("thicker", "look.opacity");
        add("thin", "look.opacity");
        add("thinner", "look.opacity");
        add("denser", "look.opacity");
        add("transparent", "look.opacity");
        add("mist", "look.opacity");
        add("fog", "look.opacity");
        add("big", "look.size");
        add("bigger", "look.size");
        add("biggest", "look.size");
        add("smaller", "look.size");
        add("larger", "look.size");
        add("tiny", "look.size");
        add("color", "look.colour");
        add("white", "look.colour");
        add("black", "look.colour");
        add("dark", "light.intensity");
        add("darker", "light.intensity");
        add("bright", "light.intensity");
        add("brighter", "light.intensity");
        add("brightest", "light.intensity");
        add("exposure", "output.exposure");
        add("slow", "emitter.speed");
        add("slower", "emitter.speed");
        add("fast", "emitter.speed");
        add("faster", "emitter.speed");
        add("faster rise", "motion.buoyancy");
        add("rise faster", "motion.buoyancy");
        add("rising", "motion.buoyancy");
        add("tall", "motion.buoyancy");
        add("taller", "motion.buoyancy");
        add("higher", "motion.buoyancy");
        add("wide", "emitter.spread");
        add("wider", "emitter.spread");
        add("narrower", "emitter.spread");
        add("heavier", "motion.gravity");
        add("falling", "motion.gravity");
        add("wind", "wind.strength");
        add("windy", "wind.strength");
        add("breeze", "wind.strength");
        add("swirls", "turbulence.strength");
        add("wilder", "turbulence.strength");
        add("tornado", "vortex.strength");
        add("mushroom", "rings.strength");
        add("lifetime", "life.lifetime");
        add("life", "life.lifetime");
        add("duration", "life.lifetime");
        add("longer", "life.lifetime");
        add("fade", "life.fade_rate");
        add("vanish", "life.fade_rate");
        add("fire", "glow.emission");
        add("glow", "glow.emission");
        add("flames", "glow.emission");
        add("softer", "look.softness");
        add("sharper", "noise.sharpness");
        add("crisp", "noise.sharpness");
        add("wispy", "look.erosion");
        add("holes", "look.erosion");
        add("fluffy", "look.roundness");
        add("loop", "timeline.loop");
        add("repeat", "timeline.loop");
        add("fps", "timeline.frame_rate");
        add("zoom", "camera.distance");
        add("more", "emitter.count");
        add("number", "emitter.count");
        add("explosion", "emitter.mode");
        add("puff", "emitter.mode");
        add("realistic", "air.enabled");
        add("spin", "motion.rotation");
        add("shadows", "light.shadow");
        add("background", "output.background");
    }
    void aPlainWordFindsItsParameterAmongTheFirstThree()
    {
        QFETCH(QString, key);
        const QStringList keys = found(QString::fromLatin1(QTest::currentDataTag()));
        QVERIFY2(keys.mid(0, 3).contains(key), qPrintable(keys.mid(0, 6).join(u", "_q)));
    }

    void wordsOfOtherLanguagesFindThemToo_data()
    {
        QTest::addColumn<QString>("language");
        QTest::addColumn<QString>("word");
        QTest::addColumn<QString>("key");
        const auto add = [](const char* language, const QString& word, const char* key) {
            QTest::newRow(qPrintable(word)) << QString::fromLatin1(language) << word << QString::fromLatin1(key);
        };
        add("sv", u"tjockare"_q, "look.opacity");
        add("sv", u"genomskinlig"_q, "look.opacity");
        add("sv", u"dimma"_q, "look.opacity");
        add("sv", u"mindre"_q, "look.size");
        add("sv", u"vit"_q, "look.colour");
        add("sv", u"mörkare"_q, "light.intensity");
        add("sv", u"stiger"_q, "motion.buoyancy");
        add("sv", u"högre"_q, "motion.buoyancy");
        add("sv", u"eld"_q, "glow.emission");
        add("sv", u"låga"_q, "glow.emission");
        add("sv", u"upprepa"_q, "timeline.loop");
        add("sv", u"snurra"_q, "motion.rotation");
        add("sv", u"antal"_q, "emitter.count");
        add("zh_CN", u"透明"_q, "look.opacity");
        add("zh_CN", u"浓"_q, "look.opacity");
        add("zh_CN", u"微小"_q, "look.size");
        add("zh_CN", u"白"_q, "look.colour");
        add("zh_CN", u"火"_q, "glow.emission");
        add("zh_CN", u"重复"_q, "timeline.loop");
        add("zh_CN", u"数量"_q, "emitter.count");
        add("zh_CN", u"风"_q, "wind.strength");
        // What is said in English everywhere is found in every language.
        add("sv", u"tornado"_q, "vortex.strength");
        add("zh_CN", u"voxels"_q, "air.resolution");
    }
    void wordsOfOtherLanguagesFindThemToo()
    {
        QFETCH(QString, language);
        QFETCH(QString, word);
        QFETCH(QString, key);
        QTranslator translator;
        QVERIFY(translator.load(QLocale(language), u"fumage"_q, u"_"_q, u":/translations"_q));
        QVERIFY(QCoreApplication::installTranslator(&translator));
        const QStringList keys = found(word);
        QCoreApplication::removeTranslator(&translator);
        QVERIFY2(keys.mid(0, 3).contains(key), qPrintable(keys.mid(0, 6).join(u", "_q)));
    }

    void eachParameterIsFoundFirstByItsWholeName()
    {
        for (const Parameter* parameter : shownParameters()) {
            const QStringList keys = found(fullLabelOf(*parameter));
            QVERIFY2(!keys.isEmpty() && keys.mid(0, 3).contains(toQString(parameter->key)),
                qPrintable(toQString(parameter->key) + u": "_q + keys.mid(0, 3).join(u", "_q)));
        }
    }

    void aPartInsideAWordIsNoMatchWhereAWordBeginsWithIt()
    {
        QVERIFY(!found(u"rings"_q).isEmpty());
        QVERIFY(!found(u"ring"_q).contains(u"light.scattering"_q)); // "scatteRING"
        QVERIFY(found(u"cattering"_q).contains(u"light.scattering"_q));
        QVERIFY(found(u"qqqq"_q).isEmpty());
    }

    void thePanelShowsTheBestOnTopWithOpenArrows()
    {
        auto* search = childOf<QLineEdit>(*m_panel, u"parameterSearch"_q);
        m_panel->setOpenGroups({});
        for (const char* text : {"thicker", "faster rise", "lifetime"}) {
            search->setText(QString::fromLatin1(text));
            QApplication::processEvents();
            const QString best = found(QString::fromLatin1(text)).first();
            const auto* row = childOf<QWidget>(*m_panel, best + u".row"_q);
            QVERIFY(row->isVisible());
            for (const auto* other : m_panel->findChildren<ParameterRow*>()) {
                if (other->isVisible() && other != row) {
                    QVERIFY2(other->mapTo(m_panel.get(), QPoint()).y() > row->mapTo(m_panel.get(), QPoint()).y(),
                        qPrintable(other->objectName()));
                }
            }
            for (const auto* group : m_panel->findChildren<ParameterGroup*>()) {
                const auto* heading = childOf<QToolButton>(*group, group->objectName() + u".heading"_q);
                QVERIFY(!group->isVisible() || heading->arrowType() == Qt::DownArrow);
            }
        }
        search->clear();
        QApplication::processEvents();
        int last = -1;
        for (const char* group : {"essentials", "emitter", "motion", "life", "look", "glow", "light", "output"}) {
            const auto* widget = childOf<QWidget>(*m_panel, u"group."_q + QString::fromLatin1(group));
            QVERIFY2(widget->y() > last, group);
            last = widget->y();
        }
    }

    void searchingAndResizingPaintWithoutComplaint()
    {
        static QStringList said;
        said.clear();
        const QtMessageHandler before =
            qInstallMessageHandler([](QtMsgType, const QMessageLogContext&, const QString& text) {
                if (text.startsWith(u"QP"_q)) { // QPainter, QPixmap, QPaintDevice
                    said += text;
                }
            });
        auto* search = childOf<QLineEdit>(*m_panel, u"parameterSearch"_q);
        for (const int width : {400, 300, 200, 120, 60, 20}) {
            m_panel->resize(width, 700);
            for (const char* text : {"", "f", "fi", "fire", "fir", "gradient", "colour", "over life", ""}) {
                search->setText(QString::fromLatin1(text));
                QApplication::processEvents();
                (void)m_panel->grab();
            }
        }
        // Rows that are squeezed to nothing.
        for (ParameterRow* row : m_panel->findChildren<ParameterRow*>()) {
            for (const QSize size : {QSize(1, 1), QSize(8, 8), QSize(14, 30)}) {
                row->editor().setFixedSize(size);
                QApplication::processEvents();
                for (QWidget* part : row->editor().findChildren<QWidget*>()) {
                    part->resize(size);
                    (void)part->grab();
                }
            }
        }
        qInstallMessageHandler(before);
        QVERIFY2(said.isEmpty(), qPrintable(said.join(QLatin1Char('\n'))));
    }

    // --- derived rows ---

    void lifetimeSetsTheFadeRateInOneStep()
    {
        typeInto(*field("life.lifetime.field"), u"5"_q);
        const Life life = m_document->effect().life;
        QVERIFY(qAbs(life.initialAlpha / life.fadeRate - 5.0F) < 1e-4F);
        QCOMPARE(m_document->undoStack()->count(), 1);
        QCOMPARE(field("life.lifetime.field")->text(), u"5 s"_q);
        m_document->undoStack()->undo();
        QVERIFY(m_document->effect() == Effect());
    }

    void lifetimeFollowsWhatItIsMadeOf()
    {
        m_document->edit(knownParameter("life.initial_alpha"), 0.5F);
        m_document->edit(knownParameter("life.fade_rate"), 0.25F);
        QCOMPARE(field("life.lifetime.field")->value(), 2.0);
    }

    void eachDerivedRowComesBackAsItWasSetAndIsUndone()
    {
        int derived = 0;
        for (const Parameter* parameter : shownParameters()) {
            const Parameter& stored = storedParameter(*parameter);
            if (&stored == parameter) {
                continue;
            }
            ++derived;
            const Effect before = m_document->effect();
            const auto aim = static_cast<float>(parameter->soft.low * 2.0);
            m_document->edit(*parameter, aim);
            QVERIFY(qAbs(std::get<float>(parameter->get(m_document->effect())) / aim - 1.0F) < 1e-5F);
            QVERIFY(!(stored.get(m_document->effect()) == stored.get(before)));
            Effect assigned = before;
            QVERIFY(applyAssignment(assigned, std::string(parameter->key) + "=" + std::to_string(aim)));
            QVERIFY(assigned == m_document->effect());
            m_document->undoStack()->undo();
            QVERIFY(m_document->effect() == before);
            QVERIFY(findParameter(parameter->key) == nullptr); // files do not know it
        }
        QVERIFY(derived > 0);
    }

    void eachParameterIsShownOnce()
    {
        QSet<QString> keys;
        for (const Parameter* parameter : shownParameters()) {
            keys += toQString(parameter->key);
            QVERIFY(!groupLabel(parameter->group()).empty());
            QVERIFY(findShownParameter(parameter->key) == parameter);
        }
        QCOMPARE(static_cast<std::size_t>(keys.size()), shownParameters().size());
        for (const Parameter& parameter : parameterTable()) {
            QVERIFY(keys.contains(toQString(parameter.key)));
        }
    }

    void allGroupsAreOpenedAndFolded()
    {
        auto* group = m_panel->findChild<ParameterGroup*>();
        for (const bool open : {true, false}) {
            emit group->foldRequested(open);
            for (const auto* one : m_panel->findChildren<ParameterGroup*>()) {
                QCOMPARE(one->isOpen(), open);
            }
        }
    }

    void whatMattersToLayersBornOnOthersIsShownThereAndWhereItIsSearchedFor()
    {
        const auto row = [this](std::string_view key) {
            return m_panel->findChild<ParameterRow*>(toQString(key) + u".row"_q);
        };
        const std::array<std::string_view, 3> keys{
            "emitter.inherit", "emitter.parent_life_from", "emitter.parent_life_to"};
        const auto shown = [&] {
            return std::count_if(keys.begin(), keys.end(), [&](std::string_view key) { return row(key)->isVisible(); });
        };
        for (const Parameter& parameter : parameterTable()) {
            QCOMPARE(parameter.ofBorn, std::find(keys.begin(), keys.end(), parameter.key) != keys.end());
        }
        m_panel->setOpenGroups({u"emitter"_q});
        QVERIFY(row("emitter.speed")->isVisible());
        QCOMPARE(shown(), 0);
        addLayer(*m_document);
        setLayersParent(*m_document, {1}, 0);
        m_document->selectLayer(1);
        QCOMPARE(shown(), 3);
        m_document->selectLayer(0);
        QCOMPARE(shown(), 0);
        // Who looks for them learns from their tips whose they are.
        auto* search = m_panel->findChild<QLineEdit*>(u"parameterSearch"_q);
        search->setText(u"inherit velocity"_q);
        QVERIFY(row("emitter.inherit")->isVisible());
        search->clear();
        QCOMPARE(shown(), 0);
        m_document->selectLayer(1);
        QCOMPARE(shown(), 3);
        m_document->undoStack()->undo(); // of its parent
        QCOMPARE(shown(), 0);
    }
};

FUMAGE_TEST_MAIN(SearchTest)
#include "search_test.moc"
