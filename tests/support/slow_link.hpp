// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QTcpServer>
#include <QTcpSocket>
#include <QTimer>
#include <memory>

namespace trocar::test {

/// A port of this machine behind which another one lies, as if it were far away: what either side
/// says arrives later.
class SlowLink {
 public:
  SlowLink(quint16 port, int delay_ms) : delay_ms_(delay_ms) {
    QObject::connect(&server_, &QTcpServer::newConnection, &server_, [this, port] {
      QTcpSocket* near = server_.nextPendingConnection();
      auto* far = new QTcpSocket(near);
      far->connectToHost("127.0.0.1", port);
      far->waitForConnected();
      forward(*near, *far);
      forward(*far, *near);
    });
    server_.listen(QHostAddress::LocalHost);
  }

  quint16 port() const { return server_.serverPort(); }

 private:
  void forward(QTcpSocket& from, QTcpSocket& to) const {
    QObject::connect(&from, &QTcpSocket::readyRead, &to, [this, &from, &to] {
      // Timers of one delay end in the order in which they began.
      QTimer::singleShot(delay_ms_, Qt::PreciseTimer, &to,
                         [&to, bytes = from.readAll()] { to.write(bytes); });
    });
  }

  int delay_ms_;
  QTcpServer server_;
};

}  // namespace trocar::test
