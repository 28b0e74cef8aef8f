#pragma once

#include "ui/document/document.h"
#include "ui/document/locks.h"
#include "ui/widgets/file_question.h"

#include <QByteArray>
#include <QDockWidget>

#include <array>
#include <memory>

class QMainWindow;
class QMenu;

namespace fumage::ui {

class EffectPanel;
class ExportQueue;
class NoisePane;
class PresetBrowser;
class QueuePanel;
class Solo;
class VariationsPanel;

/// The panels of a window in their docks, which can be moved, put behind one another and put away.
class Docks : public QObject {
    Q_OBJECT

public:
    /// @param askForFile for the names of files that panels write
    Docks(QMainWindow& window, Document& document, Locks& locks, Solo& solo, ExportQueue& exports,
        const AskForFile& askForFile);

    [[nodiscard]] EffectPanel& effectPanel() const { return *m_effectPanel; }
    [[nodiscard]] NoisePane& noisePane() const { return *m_noisePane; }
    [[nodiscard]] PresetBrowser& browser() const { return *m_browser; }
    [[nodiscard]] QueuePanel& queuePanel() const { return *m_queuePanel; }

    /// Puts all panels where they belong, in sight; that of the exports where there are any.
    void arrange();
    void showVariations();
    void showQueue();
    /// Shows that it is there, and leaves the panel in front that is.
    void addQueue();
    void searchParameters();
    /// Goes to the editor of a parameter.
    void showParameter(const QString& key);
    /// Puts all panels away, or back as they were.
    void setAllHidden(bool away);
    /// A switch for each panel.
    void fillMenu(QMenu& menu) const;

private:
    using Dock = std::unique_ptr<QDockWidget>;
    [[nodiscard]] Dock makeDock(const QString& name, const QString& title, QWidget* content);
    [[nodiscard]] std::array<QDockWidget*, 6> all() const;

    QMainWindow& m_window;
    const ExportQueue& m_exports;
    PresetBrowser* m_browser;
    EffectPanel* m_effectPanel;
    NoisePane* m_noisePane;
    QueuePanel* m_queuePanel;
    Dock m_presets;
    Dock m_parameters;
    Dock m_noise;
    Dock m_history;
    Dock m_variations;
    Dock m_queue;
    QByteArray m_before; ///< the layout before the panels were put away; empty: they are not
};

} // namespace fumage::ui
