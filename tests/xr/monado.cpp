#include "tests/xr/monado.h"

#include <arpa/inet.h>
#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <thread>

namespace odontoscope::testing_support {

namespace {

constexpr const char* log_file = "/tmp/monado.log";
constexpr std::uint16_t devices_port = 4242;
constexpr auto moment = std::chrono::milliseconds(20);

std::string socket_of_service() { return std::string(std::getenv("XDG_RUNTIME_DIR")) + "/monado_comp_ipc"; }

/// Bytes as Monado 25 reads them from the socket of its remote devices: little-endian, the third version of the format.
class Packet {
 public:
  Packet() { bytes_.append("mndrmt3\0", 8); }
  void number(double value) {
    const auto number = static_cast<float>(value);
    char raw[sizeof number];
    std::memcpy(raw, &number, sizeof number);
    bytes_.append(raw, sizeof number);
  }
  void flag(bool value) { bytes_.push_back(value ? 1 : 0); }
  void zeros(int count) {
    for (int i = 0; i < count; ++i) number(0);
  }
  void pose(const Pose& pose) {
    for (const double value :
         {pose.turn.x, pose.turn.y, pose.turn.z, pose.turn.w, pose.position.x, pose.position.y, pose.position.z})
      number(value);
  }
  void hand(const RemoteBody::Hand& hand) {
    pose(hand.pose);
    zeros(3 + 3 + 5);  // velocities, curls of the fingers
    for (const double value : {hand.trigger, hand.squeeze, hand.squeeze, hand.stick.x, hand.stick.y}) number(value);
    zeros(3);  // trackpad
    const bool pulled = hand.trigger > 0.5;
    for (const bool value : {false, hand.there, false, false, false, false, hand.b, hand.b, pulled, pulled, false,
                             false, false, false, false, false})
      flag(value);
  }
  const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
};

std::string packet_of(const RemoteBody& body) {
  Packet packet;
  for (int eye = 0; eye < 2; ++eye)
    packet.zeros(4 + 7 + 1);  // fields and places of the eyes: not told, so Monado's own
  packet.pose(body.head);
  for (int i = 0; i < 4; ++i) packet.flag(false);
  packet.hand(body.left);
  packet.hand(body.right);
  return packet.bytes();
}

int connected() {
  const int connection = socket(AF_INET, SOCK_STREAM, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(devices_port);
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  if (connect(connection, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0) return connection;
  close(connection);
  return -1;
}

}  // namespace

Monado::Monado(const std::vector<std::string>& words) {
  std::filesystem::remove(socket_of_service());
  int pipe_ends[2];
  if (pipe(pipe_ends) != 0) return;
  keeps_input_ = pipe_ends[1];
  service_ = fork();
  if (service_ == 0) {
    close(pipe_ends[1]);
    dup2(pipe_ends[0], 0);
    const int log = open(log_file, O_WRONLY | O_CREAT | O_TRUNC, 0600);
    dup2(log, 1);
    dup2(log, 2);
    for (const char* word : {"XRT_COMPOSITOR_NULL=TRUE", "XRT_NO_STDIN=1", "P_OVERRIDE_ACTIVE_CONFIG=remote"})
      putenv(const_cast<char*>(word));
    for (const std::string& word : words) putenv(const_cast<char*>(word.c_str()));
    unsetenv("LD_LIBRARY_PATH");  // what this program brought along is not for it
    // The right to be scheduled first makes it lock up machines of one processor; without the right it says so and goes
    // on.
    execlp("setpriv", "setpriv", "--bounding-set", "-sys_nice", "--inh-caps", "-sys_nice", "monado-service", nullptr);
    _exit(127);
  }
  close(pipe_ends[0]);
  for (int i = 0; i < 1000 && devices_ < 0; ++i) {
    std::this_thread::sleep_for(moment);
    if (waitpid(service_, nullptr, WNOHANG) == service_) {
      service_ = -1;
      break;
    }
    if (std::filesystem::exists(socket_of_service())) devices_ = connected();
  }
  if (devices_ < 0)
    ADD_FAILURE() << "Monado does not start:\n" << log();
  else
    say({});
}

Monado::~Monado() {
  if (devices_ >= 0) close(devices_);
  if (service_ > 0) {
    ::kill(service_, SIGTERM);
    waitpid(service_, nullptr, 0);
  }
  if (keeps_input_ >= 0) close(keeps_input_);
}

void Monado::kill() {
  ::kill(service_, SIGKILL);
  waitpid(service_, nullptr, 0);
  service_ = -1;
}

void Monado::say(const RemoteBody& body) {
  const std::string bytes = packet_of(body);
  if (send(devices_, bytes.data(), bytes.size(), MSG_NOSIGNAL) != static_cast<ssize_t>(bytes.size()))
    ADD_FAILURE() << "Monado's devices do not listen";
}

std::string Monado::log() {
  std::ostringstream text;
  text << std::ifstream(log_file).rdbuf();
  return text.str();
}

}  // namespace odontoscope::testing_support
