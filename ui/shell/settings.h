#pragma once

#include "ui/theme/theme.h"
#include "ui/viewport/navigation.h"

#include <QSettings>
#include <QStringList>

namespace fumage::ui {

/// Whether OpenGL draws the smoke.
enum class OpenGlChoice {
    Automatic, ///< where there is a graphics card
    Always, ///< also where the processor has to play graphics card
    Never,
};

/// What is remembered from one start to the next.
class Settings : public QObject {
    Q_OBJECT

public:
    explicit Settings(QObject* parent = nullptr);

    [[nodiscard]] QStringList recentFiles() const;
    void addRecentFile(const QString& path);
    void removeRecentFile(const QString& path);

    /// Where the user last opened or saved a file; that of documents before the first time.
    [[nodiscard]] QString lastFolder() const;
    void setLastFolder(const QString& folder);

    [[nodiscard]] QStringList favourites() const;
    void setFavourite(const QString& preset, bool favourite);

    [[nodiscard]] Theme theme() const;
    void setTheme(Theme theme);
    /// Language code such as "sv"; empty: that of the system.
    [[nodiscard]] QString language() const;
    void setLanguage(const QString& code);
    [[nodiscard]] NavigationStyle navigationStyle() const;
    void setNavigationStyle(NavigationStyle style);
    [[nodiscard]] bool showsStartDialog() const;
    void setShowsStartDialog(bool shows);
    /// Whether the timeline shows the graph of key frames.
    [[nodiscard]] bool showsGraph() const;
    void setShowsGraph(bool shows);
    /// How high that graph is, pixels; any number that a file may hold.
    /// @param usual where nobody has dragged it
    [[nodiscard]] int graphHeight(int usual) const;
    void setGraphHeight(int height);
    /// Whether this is the first time that the program is used here, and the tour has not come yet.
    [[nodiscard]] bool isFirstUse() const;
    void setTourSeen();

    /// Takes effect with the next start.
    [[nodiscard]] OpenGlChoice openGl() const;
    void setOpenGl(OpenGlChoice choice);
    /// What the pictures of a window that are kept for playing may take, in MB.
    [[nodiscard]] int pictureMegabytes() const;
    void setPictureMegabytes(int megabytes);
    static constexpr int kMinPictureMegabytes = 32;
    static constexpr int kMaxPictureMegabytes = 16384;
    static constexpr int kUsualPictureMegabytes = 256;
    /// What thumbnails may take on the disk, in MB.
    [[nodiscard]] int cacheMegabytes() const;
    void setCacheMegabytes(int megabytes);
    static constexpr int kMinCacheMegabytes = 8;
    static constexpr int kMaxCacheMegabytes = 4096;
    static constexpr int kUsualCacheMegabytes = 128;
    /// How many threads compute at the same time, to kMaxThreads; 0: as many as the machine has.
    [[nodiscard]] int threads() const;
    void setThreads(int threads);
    static constexpr int kMaxThreads = 256;
    /// Whether thumbnails play while the pointer is on them.
    [[nodiscard]] bool playsThumbnails() const;
    void setPlaysThumbnails(bool plays);

    /// Whether the panel of exports has come by itself, which it does once.
    [[nodiscard]] bool hasSeenQueue() const;
    void setKnowsQueue(bool knows);

    [[nodiscard]] QByteArray bytes(const QString& key) const;
    void setBytes(const QString& key, const QByteArray& value);
    [[nodiscard]] QStringList list(const QString& key, const QStringList& otherwise) const;
    void setList(const QString& key, const QStringList& value);

    /// Where unsaved work is kept.
    [[nodiscard]] static QString recoveryFolder();
    /// Where exports that are not done are kept.
    [[nodiscard]] static QString queueFolder();

signals:
    void recentFilesChanged();
    void favouritesChanged();
    void navigationStyleChanged(fumage::ui::NavigationStyle style);
    void themeChanged(fumage::ui::Theme theme);
    void languageChanged(const QString& code);
    void pictureMegabytesChanged(int megabytes);
    void cacheMegabytesChanged(int megabytes);
    void threadsChanged(int threads);
    void playsThumbnailsChanged(bool plays);

private:
    /// A number of the file, which may hold anything: within its bounds, and the usual one where it is none.
    [[nodiscard]] int number(const QString& key, int usual, int least, int most) const;

    QSettings m_settings;
};

} // namespace fumage::ui
