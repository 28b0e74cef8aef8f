#include "ui/shell/settings.h"

#include "ui/shell/portable.h"

#include <algorithm>
#include <limits>

#include <QDir>
#include <QFileInfo>
#include <QStandardPaths>

namespace fumage::ui {

namespace {

constexpr int kMaxRecent = 10;
const QString kRecent = QStringLiteral("files/recent");
const QString kLastFolder = QStringLiteral("files/folder");
const QString kFavourites = QStringLiteral("presets/favourites");
const QString kTheme = QStringLiteral("face/theme");
const QString kLanguage = QStringLiteral("face/language");
const QString kNavigation = QStringLiteral("viewport/navigation");
const QString kTour = QStringLiteral("start/tour");
const QString kStart = QStringLiteral("start/shown");
const QString kGraph = QStringLiteral("timeline/graph");
const QString kGraphHeight = QStringLiteral("timeline/graphHeight");
const QString kOpenGl = QStringLiteral("viewport/opengl");
const QString kPictures = QStringLiteral("viewport/megabytes");
const QString kCache = QStringLiteral("cache/megabytes");
const QString kThreads = QStringLiteral("compute/threads");
const QString kPlays = QStringLiteral("presets/play");
const QString kKnowsQueue = QStringLiteral("exports/shown");

/// A number that an older or newer version may have written, as an enumerator that this one knows.
template <class Enum>
Enum known(const QVariant& value, Enum last)
{
    return static_cast<Enum>(std::clamp(value.toInt(), 0, static_cast<int>(last)));
}

/// Where the program keeps what is not a setting.
QString dataFolder()
{
    const QString portable = portableFolder();
    return (portable.isEmpty() ? QStandardPaths::writableLocation(QStandardPaths::GenericDataLocation) : portable)
        + QStringLiteral("/fumage");
}

} // namespace

Settings::Settings(QObject* parent)
    : QObject(parent)
    , m_settings(QSettings::IniFormat, QSettings::UserScope, QStringLiteral("fumage"), QStringLiteral("fumage"))
{
}

QStringList Settings::recentFiles() const
{
    return m_settings.value(kRecent).toStringList();
}

void Settings::addRecentFile(const QString& path)
{
    const QString whole = QFileInfo(path).absoluteFilePath();
    QStringList files = recentFiles();
    files.removeAll(whole);
    files.prepend(whole);
    m_settings.setValue(kRecent, QStringList(files.mid(0, kMaxRecent)));
    emit recentFilesChanged();
}

void Settings::removeRecentFile(const QString& path)
{
    QStringList files = recentFiles();
    files.removeAll(path);
    m_settings.setValue(kRecent, files);
    emit recentFilesChanged();
}

QString Settings::lastFolder() const
{
    const QString folder = m_settings.value(kLastFolder).toString();
    return QDir(folder).exists() && !folder.isEmpty()
        ? folder
        : QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
}

void Settings::setLastFolder(const QString& folder)
{
    m_settings.setValue(kLastFolder, folder);
}

QStringList Settings::favourites() const
{
    return m_settings.value(kFavourites).toStringList();
}

void Settings::setFavourite(const QString& preset, bool favourite)
{
    QStringList all = favourites();
    all.removeAll(preset);
    if (favourite) {
        all.append(preset);
    }
    m_settings.setValue(kFavourites, all);
    emit favouritesChanged();
}

Theme Settings::theme() const
{
    return known(m_settings.value(kTheme), Theme::Light);
}

void Settings::setTheme(Theme theme)
{
    m_settings.setValue(kTheme, static_cast<int>(theme));
    emit themeChanged(theme);
}

QString Settings::language() const
{
    return m_settings.value(kLanguage).toString();
}

void Settings::setLanguage(const QString& code)
{
    m_settings.setValue(kLanguage, code);
    emit languageChanged(code);
}

NavigationStyle Settings::navigationStyle() const
{
    return known(m_settings.value(kNavigation), NavigationStyle::Unity);
}

void Settings::setNavigationStyle(NavigationStyle style)
{
    m_settings.setValue(kNavigation, static_cast<int>(style));
    emit navigationStyleChanged(style);
}

bool Settings::showsStartDialog() const
{
    return m_settings.value(kStart, true).toBool();
}

void Settings::setShowsStartDialog(bool shows)
{
    m_settings.setValue(kStart, shows);
}

bool Settings::showsGraph() const
{
    return m_settings.value(kGraph, false).toBool();
}

void Settings::setShowsGraph(bool shows)
{
    m_settings.setValue(kGraph, shows);
}

int Settings::graphHeight(int usual) const
{
    return number(kGraphHeight, usual, 0, std::numeric_limits<int>::max()); // it is fitted where it is shown
}

void Settings::setGraphHeight(int height)
{
    m_settings.setValue(kGraphHeight, height);
}

bool Settings::isFirstUse() const
{
    // The first window that was closed has left its layout.
    return !m_settings.value(kTour, false).toBool() && !m_settings.contains(QStringLiteral("window/layout"));
}

void Settings::setTourSeen()
{
    m_settings.setValue(kTour, true);
}

OpenGlChoice Settings::openGl() const
{
    return known(m_settings.value(kOpenGl), OpenGlChoice::Never);
}

void Settings::setOpenGl(OpenGlChoice choice)
{
    m_settings.setValue(kOpenGl, static_cast<int>(choice));
}

int Settings::pictureMegabytes() const
{
    return number(kPictures, kUsualPictureMegabytes, kMinPictureMegabytes, kMaxPictureMegabytes);
}

void Settings::setPictureMegabytes(int megabytes)
{
    m_settings.setValue(kPictures, megabytes);
    emit pictureMegabytesChanged(pictureMegabytes());
}

int Settings::cacheMegabytes() const
{
    return number(kCache, kUsualCacheMegabytes, kMinCacheMegabytes, kMaxCacheMegabytes);
}

void Settings::setCacheMegabytes(int megabytes)
{
    m_settings.setValue(kCache, megabytes);
    emit cacheMegabytesChanged(cacheMegabytes());
}

int Settings::threads() const
{
    return number(kThreads, 0, 0, kMaxThreads);
}

void Settings::setThreads(int threads)
{
    m_settings.setValue(kThreads, threads);
    emit threadsChanged(this->threads());
}

bool Settings::playsThumbnails() const
{
    return m_settings.value(kPlays, true).toBool();
}

void Settings::setPlaysThumbnails(bool plays)
{
    m_settings.setValue(kPlays, plays);
    emit playsThumbnailsChanged(plays);
}

int Settings::number(const QString& key, int usual, int least, int most) const
{
    bool isNumber = false;
    const int value = m_settings.value(key, usual).toInt(&isNumber);
    return std::clamp(isNumber ? value : usual, least, most);
}

bool Settings::hasSeenQueue() const
{
    return m_settings.value(kKnowsQueue, false).toBool();
}

void Settings::setKnowsQueue(bool knows)
{
    m_settings.setValue(kKnowsQueue, knows);
}

QByteArray Settings::bytes(const QString& key) const
{
    return m_settings.value(key).toByteArray();
}

void Settings::setBytes(const QString& key, const QByteArray& value)
{
    m_settings.setValue(key, value);
}

QStringList Settings::list(const QString& key, const QStringList& otherwise) const
{
    return m_settings.value(key, otherwise).toStringList();
}

void Settings::setList(const QString& key, const QStringList& value)
{
    m_settings.setValue(key, value);
}

QString Settings::recoveryFolder()
{
    return dataFolder() + QStringLiteral("/recovery");
}

QString Settings::queueFolder()
{
    return dataFolder() + QStringLiteral("/exports");
}

} // namespace fumage::ui
