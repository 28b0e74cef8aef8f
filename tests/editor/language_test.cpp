// The translations are whole, are loaded, and say something of their own.
#include "editor_helpers.h"

#include "ui/document/text.h"
#include "ui/theme/language.h"
#include "ui/noise_preview/noise_pane.h"
#include "ui/document/solo.h"
#include "ui/panels/effect_panel.h"
#include "ui/shell/action_table.h"

#include "core/effect/known_parameter.h"
#include "core/preset/library.h"
#include "core/preset/preset_file.h"

#include <QCommandLineParser>
#include <QComboBox>
#include <QDirIterator>
#include <QLabel>
#include <QLineEdit>
#include <QTranslator>
#include <QXmlStreamReader>

using namespace fumage;
using namespace fumage::tests;

class LanguageTest : public QObject {
    Q_OBJECT

private slots:
    void everyTextIsTranslated_data() { addLanguages(); }
    void everyTextIsTranslated()
    {
        QFETCH(QString, code);
        QFile file(QStringLiteral(FUMAGE_SOURCE_DIR "/resources/translations/fumage_%1.ts").arg(code));
        QVERIFY(file.open(QIODevice::ReadOnly));
        QXmlStreamReader xml(&file);
        QString source;
        int count = 0;
        while (!xml.atEnd()) {
            xml.readNext();
            if (xml.isStartElement() && xml.name() == u"source") {
                source = xml.readElementText();
            } else if (xml.isStartElement() && xml.name() == u"translation") {
                QVERIFY2(!xml.attributes().hasAttribute(u"type"_q), qPrintable(source));
                const QString translation = xml.readElementText();
                QVERIFY2(!translation.isEmpty(), qPrintable(source));
                for (const QString& place : {u"%1"_q, u"%2"_q, u"%3"_q, u"%L1"_q}) {
                    QVERIFY2(source.contains(place) == translation.contains(place), qPrintable(translation));
                }
                // A menu entry that has a letter to press has one in every language.
                const QRegularExpression mnemonic(u"&\\S"_q);
                QVERIFY2(source.contains(mnemonic) == translation.contains(mnemonic), qPrintable(translation));
                ++count;
            }
        }
        QVERIFY(!xml.hasError() && count > 400);
    }

    void textsAreFoundUnderTheContextsThatTheProgramAsksBy_data() { addLanguages(); }
    void textsAreFoundUnderTheContextsThatTheProgramAsksBy()
    {
        QFETCH(QString, code);
        QFile translations(QStringLiteral(FUMAGE_SOURCE_DIR "/resources/translations/fumage_%1.ts").arg(code));
        QVERIFY(translations.open(QIODevice::ReadOnly));
        const QString names = QString::fromUtf8(translations.readAll());
        // Classes with a tr() of their own have the namespace in their context; these have not.
        static const QRegularExpression asked(
            u"\\b(?:translate|QT_TRANSLATE_NOOP)\\(\\s*\"(\\w+)\"|\\bQ_DECLARE_TR_FUNCTIONS\\((\\w+)\\)"_q);
        int count = 0;
        QDirIterator files(
            QStringLiteral(FUMAGE_SOURCE_DIR "/ui"), {u"*.h"_q, u"*.cpp"_q}, QDir::Files, QDirIterator::Subdirectories);
        while (files.hasNext()) {
            QFile file(files.next());
            QVERIFY(file.open(QIODevice::ReadOnly));
            const QString source = QString::fromUtf8(file.readAll());
            for (QRegularExpressionMatchIterator found = asked.globalMatch(source); found.hasNext(); ++count) {
                const QRegularExpressionMatch match = found.next();
                const QString context = match.captured(1) + match.captured(2); // one of them is empty
                QVERIFY2(names.contains(u"<name>%1</name>"_q.arg(context)), qPrintable(file.fileName() + context));
            }
        }
        QVERIFY(count > 50);
    }

    void theParameterTableIsTranslated_data() { addLanguages(); }
    void theParameterTableIsTranslated()
    {
        QFETCH(QString, code);
        QTranslator translator;
        QVERIFY(translator.load(QLocale(code), u"fumage"_q, u"_"_q, u":/translations"_q));
        const auto has = [&](std::string_view text) {
            return text.empty() || !translator.translate("Parameters", std::string(text).c_str()).isEmpty();
        };
        for (const Parameter& parameter : parameterTable()) {
            const bool whole = has(parameter.label) && has(parameter.synonyms) && has(parameter.tip)
                && has(parameter.source) && has(groupLabel(parameter.group()));
            QVERIFY2(whole, std::string(parameter.key).c_str());
            for (const std::string_view choice : parameter.choices) {
                QVERIFY2(has(choice), std::string(choice).c_str());
            }
        }
        for (const ActionSpec& spec : actionSpecs()) {
            QVERIFY2(!translator.translate("Actions", spec.text).isEmpty(), spec.id);
        }
    }

    void thePresetsAreTranslated_data() { addLanguages(); }
    void thePresetsAreTranslated()
    {
        QFETCH(QString, code);
        QTranslator translator;
        QVERIFY(translator.load(QLocale(code), u"fumage"_q, u"_"_q, u":/translations"_q));
        for (const LibraryEntry& entry : builtinPresets()) {
            const Preset preset = loadPreset(entry).value().preset;
            for (const std::string& text : {preset.name, preset.description}) {
                QVERIFY2(!translator.translate("Presets", text.c_str()).isEmpty(), text.c_str());
            }
        }
    }

    void whatTheCoreSaysIsTranslated_data() { addLanguages(); }
    void whatTheCoreSaysIsTranslated()
    {
        QFETCH(QString, code);
        QTranslator translator;
        QVERIFY(translator.load(QLocale(code), u"fumage"_q, u"_"_q, u":/translations"_q));
        static const QString literal = u"\"(?:[^\"\\\\]|\\\\.)*\""_q;
        static const QRegularExpression sentence(u"\\bmakeMessage\\(\\s*(%1(?:\\s+%1)*)"_q.arg(literal));
        static const QRegularExpression between(u"\"\\s+\""_q); // literals that stand beside one another are one
        int count = 0;
        for (const QString& room : {u"core"_q, u"ui"_q}) {
            QDirIterator files(QStringLiteral(FUMAGE_SOURCE_DIR "/") + room, {u"*.h"_q, u"*.cpp"_q}, QDir::Files,
                QDirIterator::Subdirectories);
            while (files.hasNext()) {
                QFile file(files.next());
                QVERIFY(file.open(QIODevice::ReadOnly));
                const QString source = QString::fromUtf8(file.readAll());
                for (QRegularExpressionMatchIterator found = sentence.globalMatch(source); found.hasNext(); ++count) {
                    const QString all = found.next().captured(1).remove(between);
                    const QString text = all.mid(1, all.size() - 2).replace(u"\\\""_q, u"\""_q);
                    QVERIFY2(!translator.translate("Messages", text.toUtf8().constData()).isEmpty(), qPrintable(text));
                }
            }
        }
        QVERIFY(count > 70);
    }

    void errorsOfTheCoreAreToldInTheLanguageOfTheUser()
    {
        QVERIFY(applyLanguage(*qApp, u"sv"_q));
        const Result<PresetReading> reading = readPresetFile("/nowhere/rök.json");
        QCOMPARE(translated(reading.error()),
            u"/nowhere/rök.json: kan inte läsas: det finns ingen sådan fil eller mapp. "
            u"Kontrollera stavningen av sökvägen"_q);
        const Result<PresetReading> broken = parsePreset("{\n  \"format\": 5}");
        QVERIFY(translated(broken.error()).startsWith(u"rad 2, kolumn 13: "_q));
    }

    void thePanelSpeaksTheLanguage()
    {
        QVERIFY(applyLanguage(*qApp, u"sv"_q));
        Document document;
        Locks locks;
        Solo solo(document);
        EffectPanel panel(document, locks, solo);
        QCOMPARE(panel.findChild<QLabel*>(u"motion.gravity.label"_q)->text(), u"Tyngdkraft"_q);
        QCOMPARE(panel.findChild<QLineEdit*>(u"parameterSearch"_q)->placeholderText(), u"Sök parametrar"_q);
        QCOMPARE(NoisePane(document).findChild<QComboBox*>(u"noiseChannel"_q)->itemText(0), u"Textur"_q);
        QCOMPARE(panel.findChild<QWidget*>(u"emitter.seed.dice"_q)->accessibleName(), u"Utsändare: Frö tärning"_q);
        document.edit(knownParameter("motion.gravity"), 3.0F);
        QVERIFY(document.undoStack()->undoText().startsWith(u"Rörelse: Tyngdkraft 3"_q));
    }

    void theHelpOfTheProgramSpeaksTheLanguage()
    {
        QVERIFY(applyLanguage(*qApp, u"sv"_q));
        QCommandLineParser parser;
        parser.addHelpOption();
        parser.addVersionOption();
        const QString help = parser.helpText();
        for (const QString& word : {u"Användning: "_q, u"[flaggor]"_q, u"Flaggor:"_q,
                 u"Visar hjälp om kommandoradens flaggor."_q, u"Visar versionen."_q}) {
            QVERIFY2(help.contains(word), qPrintable(help));
        }
    }

    void anUnknownLanguageIsRefused()
    {
        QVERIFY(!applyLanguage(*qApp, u"is"_q));
        QVERIFY(applyLanguage(*qApp, u"en"_q));
    }

private:
    static void addLanguages()
    {
        QTest::addColumn<QString>("code");
        for (const Language& language : languages()) {
            if (language.code != u"en"_q) {
                QTest::newRow(qPrintable(language.code)) << language.code;
            }
        }
    }
};

FUMAGE_TEST_MAIN(LanguageTest)
#include "language_test.moc"
