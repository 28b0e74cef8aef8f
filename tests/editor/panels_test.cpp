#include "panel_fixture.h"

#include "tests/parameter_rows.h"
#include "tests/pictures.h"

#include "ui/document/layer_edits.h"
#include "ui/document/number_text.h"
#include "ui/panels/curve_editor.h"
#include "ui/panels/gradient_editor.h"
#include "ui/shell/help.h"
#include "ui/widgets/vertical_scroll_area.h"

#include "core/effect/known_parameter.h"
#include "core/preset/library.h"
#include "core/preset/preset_file.h"

#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QLabel>
#include <QScrollBar>
#include <QTabBar>
#include <QTextBrowser>
#include <QToolButton>
#include <QToolTip>
#include <QTranslator>

using namespace fumage;
using namespace fumage::tests;

class PanelsTest : public PanelFixture {
    Q_OBJECT

private slots:
    // --- over the whole table ---------------------------------------------------------------------------------------

    void everyParameterHasAnEditorWithTipAndUnit_data() { addParameterRows(); }
    void everyParameterHasAnEditorWithTipAndUnit()
    {
        QFETCH(QString, key);
        const Parameter& parameter = *findParameter(key.toStdString());
        auto* editor = m_panel->findChild<ParameterEditor*>(key);
        QVERIFY(editor != nullptr);
        QVERIFY(editor->toolTip().contains(toQString(parameter.tip).toHtmlEscaped()));
        QVERIFY(!editor->accessibleName().isEmpty());
        auto* label = m_panel->findChild<QLabel*>(key + u".label"_q);
        QVERIFY(label != nullptr && label->text().contains(labelOf(parameter)));
        const auto fields = editor->findChildren<NumberField*>();
        const bool hasUnit = parameter.unit != Unit::None && !fields.isEmpty();
        QVERIFY(!hasUnit || fields.first()->text().contains(toQString(unitSymbol(parameter.unit))));
        for (const QWidget* child :
            editor->findChildren<QWidget*>(QRegularExpression(u"^"_q + QRegularExpression::escape(key)))) {
            QVERIFY2(!child->accessibleName().isEmpty(), qPrintable(child->objectName()));
        }
    }

    void everyPartOfAParameterLeadsToItsHelp_data() { addParameterRows(); }
    void everyPartOfAParameterLeadsToItsHelp()
    {
        QFETCH(QString, key);
        auto* editor = m_panel->findChild<ParameterEditor*>(key);
        QVERIFY(editor != nullptr);
        QList<QWidget*> parts = editor->findChildren<QWidget*>();
        parts += {editor, m_panel->findChild<QLabel*>(key + u".label"_q), editor->parentWidget()};
        for (const QWidget* part : std::as_const(parts)) {
            QCOMPARE(referenceAnchorAt(part), key);
        }
        QVERIFY(parameterReference().contains(u"<a name=\"%1\">"_q.arg(key)));
    }

    void theHelpOpensWhereItIsAskedFor()
    {
        QWidget window;
        int before = -1;
        for (const char* const anchor : {"emitter", "emitter.count", "look.size", "timeline.length", "look.size"}) {
            showReference(&window, QString::fromLatin1(anchor));
            auto* text = window.findChild<QTextBrowser*>();
            QVERIFY(text != nullptr);
            const int now = text->verticalScrollBar()->value();
            QVERIFY2(now != before, anchor);
            before = now;
        }
        QCOMPARE(referenceAnchorAt(m_panel->findChild<QWidget*>(u"group.look.heading"_q)), u"look"_q);
        QCOMPARE(referenceAnchorAt(&window), QString());
        QCOMPARE(referenceAnchorAt(nullptr), QString());
    }

    void openingThePanelChangesNothing()
    {
        QCOMPARE(m_document->undoStack()->count(), 0);
        QVERIFY(m_document->effect() == Effect());
        m_panel->setOpenGroups({});
        QCOMPARE(m_document->undoStack()->count(), 0);
    }

    void showingAnyPresetChangesNothing()
    {
        for (const LibraryEntry& entry : builtinPresets()) {
            const Preset preset = loadPreset(entry).value().preset;
            m_document->load(preset, {});
            QCoreApplication::processEvents();
            QVERIFY2(m_document->scene() == preset.scene, entry.id.c_str());
            QCOMPARE(m_document->undoStack()->count(), 0);
        }
    }

    void everyEditorWritesWhatItShows_data() { addParameterRows(); }
    void everyEditorWritesWhatItShows()
    {
        // Editor -> document -> JSON -> editor, with another value than the default.
        QFETCH(QString, key);
        const Parameter& parameter = *findParameter(key.toStdString());
        auto* editor = m_panel->findChild<ParameterEditor*>(key);
        const Value before = parameter.get(m_document->effect());
        nudge(*editor);
        const Value after = parameter.get(m_document->effect());
        QVERIFY(!(before == after));
        const Result<PresetReading> reading = parsePreset(formatPreset(m_document->preset()));
        QVERIFY(reading.ok() && reading.value().warnings.empty());
        QVERIFY(parameter.get(reading.value().preset.scene.effect()) == after);
        Document second;
        second.load(reading.value().preset, {});
        Solo solo(second);
        EffectPanel other(second, *m_locks, solo);
        QVERIFY(second.effect() == reading.value().preset.scene.effect());
        const auto fields = editor->findChildren<NumberField*>();
        const auto otherFields = other.findChild<ParameterEditor*>(key)->findChildren<NumberField*>();
        for (int i = 0; i < fields.size(); ++i) {
            QCOMPARE(otherFields[i]->text(), fields[i]->text());
        }
    }

    // --- panel ------------------------------------------------------------------------------------------------------

    void aLayerAloneHasNoTabs()
    {
        const auto* tabs = m_panel->findChild<QTabBar*>(u"parameterTabs"_q);
        QVERIFY(tabs->isHidden());
        for (const char* group : {"emitter", "motion", "air", "camera"}) {
            QVERIFY(m_panel->findChild<ParameterGroup*>(u"group."_q + QLatin1String(group))->isVisible());
        }
    }

    void severalLayersHaveTheirParametersApartFromTheScene()
    {
        auto* tabs = m_panel->findChild<QTabBar*>(u"parameterTabs"_q);
        const auto group = [&](std::string_view name) {
            return m_panel->findChild<ParameterGroup*>(u"group."_q + toQString(name));
        };
        const auto row = [&](std::string_view key) {
            return m_panel->findChild<ParameterEditor*>(kEssentialsName + u'/' + toQString(key));
        };
        renameLayer(*m_document, 0, u"flames & <i>smoke</i>"_q);
        addLayer(*m_document);
        m_document->selectLayer(0);
        QVERIFY(tabs->isVisible());
        QCOMPARE(tabs->tabText(0), u"flames && <i>smoke</i>"_q);
        for (const Parameter* parameter : shownParameters()) {
            const Scope scope = storedParameter(*parameter).scope;
            QCOMPARE(group(parameter->group())->isVisible(),
                scope == Scope::Layer || group(parameter->group())->has(Scope::Layer));
        }
        tabs->setCurrentIndex(1);
        QVERIFY(group("air")->isVisible() && !group("motion")->isVisible());
        // What leads to a parameter leads to its tab.
        m_panel->showParameter(u"motion.gravity"_q);
        QCOMPARE(tabs->currentIndex(), 0);
        QVERIFY(group("motion")->isVisible());
        m_panel->showParameter(u"camera.distance"_q);
        QCOMPARE(tabs->currentIndex(), 1);
        for (const Parameter& parameter : parameterTable()) {
            if (const ParameterEditor* editor = parameter.essential > 0 ? row(parameter.key) : nullptr) {
                QVERIFY(parameter.scope == Scope::Scene || !editor->isVisible());
            }
        }
        // A search finds both, and says whose they are.
        auto* search = m_panel->findChild<QLineEdit*>(u"parameterSearch"_q);
        search->setText(u"drag"_q);
        QVERIFY(tabs->isHidden());
        QVERIFY(group("motion")->isVisible() && group("air")->isVisible());
        const auto heading = [&](const char* name) {
            return m_panel->findChild<QToolButton*>(u"group."_q + QLatin1String(name) + u".heading"_q)->text();
        };
        QVERIFY2(heading("air").endsWith(u"Scene"_q), qPrintable(heading("air")));
        QVERIFY2(heading("motion").endsWith(u"<i>smoke</i>"_q), qPrintable(heading("motion")));
        search->clear();
        QVERIFY(tabs->isVisible());
        QVERIFY(!heading("air").endsWith(u"Scene"_q));
        removeLayers(*m_document, {1});
        QVERIFY(tabs->isHidden());
        QVERIFY(group("air")->isVisible() && group("motion")->isVisible());
    }

    void searchFindsByLabelGroupAndTip()
    {
        auto* search = m_panel->findChild<QLineEdit*>(u"parameterSearch"_q);
        QTest::keyClicks(search, u"wind"_q);
        QVERIFY(row("wind.strength")->isVisible());
        QVERIFY(row("wind.angle")->isVisible());
        QVERIFY(row("wind.gust")->isVisible()); // its tip speaks of the wind
        QVERIFY(!row("noise.octaves")->isVisible());
        search->setText(u"noise octaves"_q);
        QVERIFY(row("noise.octaves")->isVisible());
        QVERIFY(!row("turbulence.octaves")->isVisible());
        search->clear();
        QVERIFY(row("wind.strength")->isVisible());
    }

    void wordsOfArtistsFindParameters_data()
    {
        QTest::addColumn<QString>("word");
        QTest::addColumn<QString>("key");
        QTest::newRow("US spelling") << u"color"_q << u"look.colour"_q;
        QTest::newRow("thick") << u"thick"_q << u"look.opacity"_q;
        QTest::newRow("transparent") << u"transparent"_q << u"look.opacity"_q;
        QTest::newRow("density") << u"Density"_q << u"look.opacity"_q;
        QTest::newRow("lifetime") << u"lifetime"_q << u"life.fade_rate"_q;
        QTest::newRow("fps") << u"fps"_q << u"timeline.frame_rate"_q;
    }
    void wordsOfArtistsFindParameters()
    {
        QFETCH(QString, word);
        QFETCH(QString, key);
        m_panel->findChild<QLineEdit*>(u"parameterSearch"_q)->setText(word);
        QVERIFY(row(key.toLatin1().constData())->isVisible());
        QVERIFY(!m_panel->findChild<QLabel*>(u"parameterSearch.nothing"_q)->isVisible());
    }

    void aSearchThatFindsNothingSaysSo()
    {
        m_panel->findChild<QLineEdit*>(u"parameterSearch"_q)->setText(u"zebra"_q);
        const auto* nothing = m_panel->findChild<QLabel*>(u"parameterSearch.nothing"_q);
        QVERIFY(nothing->isVisible() && nothing->text().contains(u"zebra"_q));
    }

    void aFoldedGroupTellsThatSomethingInItIsChanged()
    {
        m_panel->setOpenGroups({});
        const auto* heading = m_panel->findChild<QToolButton*>(u"group.motion.heading"_q);
        QCOMPARE(heading->text(), u"Motion"_q);
        m_document->edit(*findParameter("motion.gravity"), 3.0F);
        QCOMPARE(heading->text(), u"• Motion"_q);
        m_document->undoStack()->undo();
        QCOMPARE(heading->text(), u"Motion"_q);
    }

    void onlyWhatIsChangedIsShown()
    {
        m_panel->setOpenGroups({});
        m_document->edit(*findParameter("motion.gravity"), 3.0F);
        auto* only = m_panel->findChild<QToolButton*>(u"onlyChanged"_q);
        only->click();
        QVERIFY(row("motion.gravity")->isVisible());
        QVERIFY(!row("wind.strength")->isVisible());
        QVERIFY(!row("look.size")->isVisible());
        m_document->edit(*findParameter("look.size"), 0.7F);
        QVERIFY(row("look.size")->isVisible());
        m_document->undoStack()->setIndex(0);
        QVERIFY(m_panel->findChild<QLabel*>(u"parameterSearch.nothing"_q)->isVisible());
        only->click();
        QVERIFY(m_panel->findChild<ParameterGroup*>(u"group.motion"_q)->isVisible());
    }

    void aGroupIsCopiedPastedAndResetInOneStep()
    {
        auto* group = m_panel->findChild<ParameterGroup*>(u"group.motion"_q);
        m_document->edit(*findParameter("motion.gravity"), 3.0F);
        m_document->edit(*findParameter("wind.strength"), 1.25F);
        m_document->edit(*findParameter("look.size"), 0.7F);
        group->copy();
        const int steps = m_document->undoStack()->count();
        group->reset();
        QCOMPARE(m_document->undoStack()->count(), steps + 1);
        QCOMPARE(m_document->effect().motion.gravity, Effect().motion.gravity);
        QCOMPARE(m_document->effect().look.size, 0.7F); // is of another group
        group->paste();
        QCOMPARE(m_document->undoStack()->count(), steps + 2);
        QCOMPARE(m_document->effect().motion.gravity, 3.0F);
        QCOMPARE(m_document->effect().wind.strength, 1.25F);
        QApplication::clipboard()->setText(u"look.size=2\nmotion.gravity=oops\nhello"_q);
        group->paste();
        QCOMPARE(m_document->undoStack()->count(), steps + 2);
    }

    void aLockHasAMarkThatUnlocks()
    {
        const Parameter& gravity = *findParameter("motion.gravity");
        const auto find = [this] { return m_panel->findChild<QToolButton*>(u"motion.gravity.locked"_q); };
        QVERIFY(find() == nullptr);
        m_locks->set(gravity, true);
        auto* mark = find();
        QVERIFY(mark != nullptr && mark->isVisible() && !mark->icon().isNull());
        QCOMPARE(m_panel->findChild<QLabel*>(u"motion.gravity.label"_q)->text(), u"Gravity"_q);
        QTest::mouseClick(mark, Qt::LeftButton);
        QVERIFY(!m_locks->contains(gravity) && !mark->isVisible());
    }

    void numbersOfAColourAreNotCutOff()
    {
        m_panel->setOpenGroups({u"look"_q});
        m_panel->resize(m_panel->sizeHint());
        m_document->edit(*findParameter("look.colour"), glm::vec3(0.12345F, 0.98765F, 0.45678F));
        for (const QString& channel : {u"r"_q, u"g"_q, u"b"_q}) {
            const auto* field = m_panel->findChild<NumberField*>(u"look.colour."_q + channel);
            constexpr int kPadding = 18; // of the style
            QVERIFY2(field->fontMetrics().horizontalAdvance(field->text()) + kPadding <= field->width(),
                qPrintable(field->text()));
        }
    }

    void theEssentialsStandOnTopOnceMore()
    {
        m_panel->setOpenGroups(EffectPanel::usualGroups());
        auto* group = m_panel->findChild<ParameterGroup*>(u"group.essentials"_q);
        QCOMPARE(group->y(), 0);
        QVERIFY(group->isVisible() && group->isOpen());
        for (const char* key : {"look.opacity", "look.size", "look.colour", "life.fade_rate", "emitter.normal",
                 "wind.angle", "motion.gravity", "noise.octaves", "noise.sharpness", "timeline.loop"}) {
            QVERIFY2(group->findChild<ParameterRow*>(u"essentials/%1.row"_q.arg(QLatin1String(key))) != nullptr, key);
        }
        m_document->edit(*findParameter("motion.gravity"), 3.0F);
        QCOMPARE(group->findChild<NumberField*>(u"essentials/motion.gravity.field"_q)->value(), 3.0);
        m_panel->findChild<QLineEdit*>(u"parameterSearch"_q)->setText(u"gravity"_q);
        QVERIFY(!group->isVisible()); // not found twice
        QVERIFY(row("motion.gravity")->isVisible());
    }

    void whereNothingIsSearchedForNoTextIsLookedUp()
    {
        CountingTranslator translator;
        QCoreApplication::installTranslator(&translator);
        const auto textsOf = [&](Document& document, float gravity) {
            translator.count = 0;
            document.edit(*findParameter("motion.gravity"), gravity);
            return translator.count;
        };
        Document unseen;
        const int forTheUndoStep = textsOf(unseen, 1.0F);
        QVERIFY(forTheUndoStep > 0);
        QCOMPARE(textsOf(*m_document, 1.0F), forTheUndoStep);
        QCOMPARE(textsOf(*m_document, 2.0F), forTheUndoStep);
        QCoreApplication::removeTranslator(&translator);
    }

    void rowsThatHaveNoInfluenceAreHidden()
    {
        QVERIFY(row("emitter.radius")->isVisible());
        m_document->edit(knownParameter("emitter.shape"), static_cast<int>(EmitterShape::Rectangle));
        QVERIFY(row("emitter.width")->isVisible());
        m_document->edit(knownParameter("emitter.shape"), static_cast<int>(EmitterShape::Disc));
        QVERIFY(!row("emitter.width")->isVisible());
    }

    void aChangedParameterIsMarkedUntilItIsReset()
    {
        auto* label = m_panel->findChild<QLabel*>(u"motion.gravity.label"_q);
        QVERIFY(!label->property("changed").toBool());
        typeInto(*field("motion.gravity.field"), u"4"_q);
        QVERIFY(label->property("changed").toBool());
        QTest::mouseDClick(label, Qt::LeftButton);
        QVERIFY(!label->property("changed").toBool());
        QCOMPARE(m_document->effect().motion.gravity, Effect().motion.gravity);
    }

    void nothingIsCutOffAtTheSideHoweverNarrowThePanel_data()
    {
        QTest::addColumn<double>("larger");
        QTest::newRow("usual letters") << 1.0;
        QTest::newRow("large letters") << 1.7;
    }
    void nothingIsCutOffAtTheSideHoweverNarrowThePanel()
    {
        QFETCH(double, larger);
        QFont font = m_panel->font();
        font.setPointSizeF(font.pointSizeF() * larger);
        m_panel->setFont(font);
        const auto* area = m_panel->findChild<VerticalScrollArea*>();
        QTRY_VERIFY(area->minimumSizeHint().width() >= area->widget()->minimumSizeHint().width());
        m_panel->resize(m_panel->minimumSizeHint().width(), 900);
        const int right = area->widget()->mapTo(m_panel.get(), QPoint(area->viewport()->width(), 0)).x();
        for (const ParameterEditor* editor : m_panel->findChildren<ParameterEditor*>()) {
            QTRY_VERIFY2(editor->mapTo(m_panel.get(), QPoint(editor->width(), 0)).x() <= right,
                qPrintable(editor->objectName()));
        }
    }

private:
    /// Counts the texts that are looked up; knows none.
    class CountingTranslator : public QTranslator {
    public:
        QString translate(const char*, const char*, const char*, int) const override
        {
            ++count;
            return {};
        }
        bool isEmpty() const override { return false; }
        mutable int count = 0;
    };

    ParameterRow* row(const char* key)
    {
        return m_panel->findChild<ParameterRow*>(QString::fromLatin1(key) + u".row"_q);
    }

    /// Changes a parameter through its widgets, whatever they are.
    static void nudge(ParameterEditor& editor)
    {
        if (auto* box = editor.findChild<QCheckBox*>()) {
            box->click();
        } else if (auto* choice = editor.findChild<QComboBox*>()) {
            choice->setCurrentIndex((choice->currentIndex() + 1) % choice->count());
        } else if (auto* area = editor.findChild<CurveArea*>()) {
            QTest::mouseClick(area, Qt::LeftButton, {}, area->toScreen({0.55F, 0.3F}).toPoint());
        } else if (auto* bar = editor.findChild<GradientBar*>()) {
            QTest::mouseClick(bar, Qt::LeftButton, {}, QPoint(bar->width() / 3, 8));
        } else if (editor.parameter().kind == Kind::Picture) {
            emit editor.edited(ramp(8, 8), true);
        } else {
            auto* field = editor.findChildren<NumberField*>().first();
            const double low = editor.parameter().hard.low;
            const double high = editor.parameter().hard.high;
            const double next = field->value() + 1.0 <= high ? field->value() + 1.0 : low + 0.37 * (high - low);
            typeInto(*field, formatNumber(field->value() == 0.0 && high <= 1.0 ? 0.3 : next));
        }
    }
};

FUMAGE_TEST_MAIN(PanelsTest)
#include "panels_test.moc"
