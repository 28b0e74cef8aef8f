#pragma once

#include "ui/document/document.h"
#include "ui/noise_preview/noise_canvas.h"
#include "ui/noise_preview/noise_picture.h"

#include <QTimer>
#include <QWidget>

#include <optional>

class QComboBox;
class QHBoxLayout;
class QLabel;
class QSlider;
class QToolButton;

namespace fumage::ui {

/// The noise texture as the particles use it, with ways to look at it closely. Bakes only while it can be seen.
class NoisePane : public QWidget {
    Q_OBJECT

public:
    explicit NoisePane(Document& document, QWidget* parent = nullptr);

    [[nodiscard]] const NoisePicturePtr& picture() const { return m_picture; }

    /// Puts the parameters that are wanted beside the picture below it.
    void addControls(QWidget* controls);

signals:
    /// The artist wants the texture as a file.
    void exportRequested();
    void pictureShown();

protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

private:
    void build();
    QHBoxLayout* makeBar();
    void connectParts();
    QToolButton* addToggle(const QString& name, const QString& icon, const QString& tip);
    void refresh();
    void receive(const NoisePicturePtr& picture);
    void advance();
    void plot();

    Document& m_document;
    NoiseWorker m_worker;
    NoiseCanvas* m_canvas;
    NoisePlots* m_plots;
    QComboBox* m_channel;
    QToolButton* m_plain;
    QToolButton* m_tiled;
    QToolButton* m_animate;
    QToolButton* m_profile;
    QSlider* m_slice;
    QLabel* m_facts;
    QTimer m_clock;
    NoisePicturePtr m_picture;
    std::optional<NoiseRequest> m_asked; ///< the last tile that was asked for
    quint64 m_serial = 0;
    bool m_stale = true;
};

} // namespace fumage::ui
