#pragma once

#include "editor_helpers.h"

#include "ui/shell/main_window.h"
#include "ui/shell/session.h"

#include <QImage>
#include <QMessageBox>
#include <QTimer>

#include <memory>

namespace fumage::tests {

/// Smoke that a slow machine shows in a moment.
[[nodiscard]] Preset smallPreset();

/// Answers the next modal dialog of a name as soon as it is there.
template <class Dialog = QMessageBox, class Answer>
void answerNext(const char* name, const Answer& answer)
{
    auto* timer = new QTimer(qApp);
    timer->setInterval(10);
    QObject::connect(timer, &QTimer::timeout, timer, [timer, name, answer] {
        auto* dialog = qobject_cast<Dialog*>(QApplication::activeModalWidget());
        if (dialog != nullptr && dialog->objectName() == QLatin1String(name)) {
            timer->stop();
            timer->deleteLater();
            answer(*dialog);
        }
    });
    timer->start();
}

void pressButton(QMessageBox& box, QMessageBox::StandardButton button);

/// Whole windows, driven as a person would: on a screen, with mouse and keyboard. Each test gets a window of its own on
/// the small preset, paused at frame 30, with its picture on the screen, and a folder and a library that are empty.
class WindowFixture : public QObject {
    Q_OBJECT

private slots:
    void init();
    void cleanup();

protected:
    /// The picture of the document as it is now; null, with a warning, where it does not come.
    [[nodiscard]] QImage settled();
    void trigger(const char* action) { m_window->actions().get(action).trigger(); }
    /// The window beside m_window.
    [[nodiscard]] MainWindow* otherWindow() const;

    QTemporaryDir m_folder;
    QString m_chosenFile; ///< what a question for a file is answered with; empty: none is chosen
    QList<FileQuestion> m_fileQuestions; ///< that were asked
    int m_chosenAnswer = -1; ///< what a question with a few answers is answered with; less than 0: the last
    QList<ChoiceQuestion> m_choiceQuestions; ///< that were asked
    std::unique_ptr<Session> m_session;
    MainWindow* m_window = nullptr;
};

} // namespace fumage::tests
