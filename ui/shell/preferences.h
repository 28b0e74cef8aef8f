#pragma once

#include <QDialog>

class QFormLayout;

namespace fumage::ui {

class AppServices;

/// What a person sets once, on one page. Each choice takes effect as it is made, or with the next start where it says
/// so.
class Preferences : public QDialog {
    Q_OBJECT

public:
    Preferences(AppServices& services, QWidget* parent);

private:
    void addFace(QFormLayout& form);
    void addViewport(QFormLayout& form);
    void addStart(QFormLayout& form);

    AppServices& m_services;
};

} // namespace fumage::ui
