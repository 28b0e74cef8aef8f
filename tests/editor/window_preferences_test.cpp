// What is set once.
#include "window_fixture.h"

#include "ui/presets/thumbnail_store.h"
#include "ui/shell/preferences.h"

#include "core/base/parallel.h"

#include <QCheckBox>
#include <QLabel>
#include <QPushButton>
#include <QSettings>
#include <QSpinBox>

using namespace fumage;
using namespace fumage::tests;

class WindowPreferencesTest : public WindowFixture {
    Q_OBJECT

private slots:
    void theyOpenFromMenuAndKeyboard()
    {
        QTest::keyClick(m_window, Qt::Key_Comma, Qt::ControlModifier);
        QTRY_VERIFY(m_window->findChild<Preferences*>() != nullptr);
        QTest::keyClick(m_window->findChild<Preferences*>(), Qt::Key_Escape);
        QTRY_VERIFY(m_window->findChild<Preferences*>() == nullptr);
    }

    void threadsAreLimitedAtOnce()
    {
        Preferences preferences(*m_session, m_window);
        auto* threads = childOf<QSpinBox>(preferences, u"preferences.threads"_q);
        QCOMPARE(threads->value(), 0);
        QVERIFY(threads->text().contains(QString::number(m_session->allThreads())));
        threads->setValue(1);
        QCOMPARE(parallelThreads(), std::size_t{1});
        QCOMPARE(Settings().threads(), 1);
        threads->setValue(0);
        QCOMPARE(parallelThreads(), static_cast<std::size_t>(m_session->allThreads()));
    }

    void theCacheIsMeasuredAndCleared()
    {
        const ThumbnailStore store(ThumbnailStore::usualFolder());
        QImage image(32, 32, QImage::Format_RGB32);
        image.fill(Qt::red);
        store.put(smallPreset().scene, 32, image);
        Preferences preferences(*m_session, m_window);
        const auto* size = childOf<QLabel>(preferences, u"preferences.cacheSize"_q);
        QTRY_VERIFY(!size->text().isEmpty());
        QTest::mouseClick(childOf<QPushButton>(preferences, u"preferences.clearCache"_q), Qt::LeftButton);
        QTRY_VERIFY(store.find(smallPreset().scene, 32).isNull());
        childOf<QSpinBox>(preferences, u"preferences.cache"_q)->setValue(64);
        QCOMPARE(Settings().cacheMegabytes(), 64);
    }

    void thumbnailsRestWhereTheyAreToldTo()
    {
        Preferences preferences(*m_session, m_window);
        auto* plays = childOf<QCheckBox>(preferences, u"preferences.plays"_q);
        QVERIFY(plays->isChecked());
        plays->setChecked(false);
        QVERIFY(!Settings().playsThumbnails());
        plays->setChecked(true);
    }

    void whatThePersonOrAnotherVersionHasWrittenStaysWithinBounds()
    {
        const char* keys[] = {"viewport/megabytes", "cache/megabytes", "compute/threads", "face/theme",
            "viewport/navigation", "viewport/opengl", "timeline/graphHeight"};
        for (const QVariant& broken :
            {QVariant(-5), QVariant(1000000), QVariant(u"many"_q), QVariant(QByteArray("\0\xff", 2))}) {
            {
                QSettings file(QSettings::IniFormat, QSettings::UserScope, u"fumage"_q, u"fumage"_q);
                for (const char* key : keys) {
                    file.setValue(QLatin1String(key), broken);
                }
            }
            const Settings settings;
            QVERIFY(settings.pictureMegabytes() >= Settings::kMinPictureMegabytes);
            QVERIFY(settings.pictureMegabytes() <= Settings::kMaxPictureMegabytes);
            QVERIFY(settings.cacheMegabytes() >= Settings::kMinCacheMegabytes);
            QVERIFY(settings.cacheMegabytes() <= Settings::kMaxCacheMegabytes);
            QVERIFY(settings.threads() >= 0 && settings.threads() <= Settings::kMaxThreads);
            QVERIFY(static_cast<int>(settings.theme()) <= static_cast<int>(Theme::Light));
            QVERIFY(static_cast<int>(settings.navigationStyle()) <= static_cast<int>(NavigationStyle::Unity));
            QVERIFY(static_cast<int>(settings.openGl()) <= static_cast<int>(OpenGlChoice::Never));
            if (broken.toString() == u"many"_q) { // no number: as nobody had chosen
                QCOMPARE(settings.pictureMegabytes(), Settings::kUsualPictureMegabytes);
                QCOMPARE(settings.threads(), 0);
                QCOMPARE(settings.graphHeight(170), 170);
            }
        }
        QSettings file(QSettings::IniFormat, QSettings::UserScope, u"fumage"_q, u"fumage"_q);
        for (const char* key : keys) {
            file.remove(QLatin1String(key));
        }
    }
};

FUMAGE_TEST_MAIN(WindowPreferencesTest)
#include "window_preferences_test.moc"
