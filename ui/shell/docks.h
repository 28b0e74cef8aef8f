#pragma once

#include "ui/document/document.h"
#include "ui/document/locks.h"

#include <QByteArray>
#include <QDockWidget>

#include <array>
#include <memory>

class QMainWindow;
class QMenu;

namespace fumage::ui {

class EffectPanel;
class NoisePane;
class PresetBrowser;
class VariationsPanel;

/// The panels of a window in their docks, which can be moved, put behind one another and put away.
class Docks : public QObject {
    Q_OBJECT

public:
    Docks(QMainWindow& window, Document& document, Locks& locks);

    [[nodiscard]] EffectPanel& effectPanel() const { return *m_effectPanel; }
    [[nodiscard]] NoisePane& noisePane() const { return *m_noisePane; }
    [[nodiscard]] PresetBrowser& browser() const { return *m_browser; }

    /// Puts all panels where they belong, in sight.
    void arrange();
    void showVariations();
    void searchParameters();
    /// Goes to the editor of a parameter.
    void showParameter(const QString& key);
    /// Puts all panels away, or back as they were.
    void setPutAway(bool away);
    /// A switch for each panel.
    void fillMenu(QMenu& menu) const;

private:
    using Dock = std::unique_ptr<QDockWidget>;
    [[nodiscard]] Dock makeDock(const QString& name, const QString& title, QWidget* content);
    [[nodiscard]] std::array<QDockWidget*, 5> all() const;

    QMainWindow& m_window;
    PresetBrowser* m_browser;
    EffectPanel* m_effectPanel;
    NoisePane* m_noisePane;
    Dock m_presets;
    Dock m_parameters;
    Dock m_noise;
    Dock m_history;
    Dock m_variations;
    QByteArray m_before; ///< the layout before the panels were put away; empty: they are not
};

} // namespace fumage::ui
