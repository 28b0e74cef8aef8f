#pragma once

#include <QImage>
#include <QWidget>

namespace fumage::ui {

/// A picture with alpha over a backdrop, scaled to fit.
class PreviewCanvas : public QWidget {
    Q_OBJECT

public:
    enum class Backdrop {
        Dark,
        Light,
        Checker,
    };

    explicit PreviewCanvas(QWidget* parent = nullptr);

    [[nodiscard]] QSize sizeHint() const override;
    void setBackdrop(Backdrop backdrop);
    /// @param image with straight alpha
    void setImage(const QImage& image);
    /// Takes the place of the picture.
    void say(const QString& text);
    [[nodiscard]] const QImage& image() const { return m_image; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void paintBackdrop(QPainter& painter, const QRect& area) const;

    Backdrop m_backdrop = Backdrop::Dark;
    QImage m_image;
    QString m_text;
};

} // namespace fumage::ui
