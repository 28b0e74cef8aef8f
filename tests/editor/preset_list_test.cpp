// The library as it is looked through.
#include "editor_helpers.h"
#include "library_helpers.h"

#include "ui/theme/language.h"
#include "ui/presets/preset_list.h"

using namespace fumage;
using namespace fumage::tests;

namespace {

QStringList shown(const PresetList& list)
{
    QStringList names;
    for (int i = 0; i < list.count(); ++i) {
        if (!list.item(i)->isHidden()) {
            names << list.item(i)->text();
        }
    }
    return names;
}

} // namespace

class PresetListTest : public QObject {
    Q_OBJECT

private slots:
    void whereNothingIsFoundItSaysSo()
    {
        PresetList list(32);
        list.reload();
        QTRY_COMPARE(list.count(), sizeOfLibrary());
        list.filter(u"black forest"_q, false);
        QVERIFY(shown(list).isEmpty());
        QVERIFY(list.accessibleDescription().contains(u"black forest"_q));
        list.filter({}, true);
        QVERIFY(list.accessibleDescription().contains(u"favourites"_q));
        list.filter({}, false);
        QVERIFY(list.accessibleDescription().isEmpty());
    }

    void presetsAreNamedAndFoundInTheLanguageOfTheUser()
    {
        QVERIFY(applyLanguage(*qApp, u"sv"_q));
        PresetList list(32);
        list.reload();
        QTRY_COMPARE(list.count(), sizeOfLibrary());
        for (const QString& word : {u"vulkan"_q, u"Volcano"_q, u"aska"_q}) {
            list.filter(word, false);
            QVERIFY2(shown(list).contains(u"Vulkan"_q), qPrintable(shown(list).join(u'|')));
        }
    }
};

FUMAGE_TEST_MAIN(PresetListTest)
#include "preset_list_test.moc"
