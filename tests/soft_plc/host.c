/* Soft PLC for tests: a process that scans like a PLC, and reads and writes a Modbus TCP server.

   Arguments: port, scan time [s], time of the machine at which to end [s], file of the log.
   The program is in another file, which defines `plc_image` sizes by macros and the two functions below. In each scan,
   the host reads all bits and registers, calls the program, and writes all coils and holding registers. The scans have
   absolute deadlines of the monotonic clock; the host is not synchronised with the server. */
#define _POSIX_C_SOURCE 200809L
#include <arpa/inet.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <sys/time.h>
#include <time.h>
#include <unistd.h>

#include "image.h"

static int server;
static uint16_t transaction;

static void stop(const char *reason) {
  fprintf(stderr, "soft PLC: %s\n", reason);
  exit(1);
}

static void receive(uint8_t *data, size_t count) {
  while (count > 0) {
    ssize_t n = recv(server, data, count, 0);
    if (n <= 0) stop("no answer");
    data += n;
    count -= (size_t)n;
  }
}

/* Send a message of a function code and data; the answer replaces it. Return the length of the answer. */
static size_t request(uint8_t *message, size_t length) {
  uint8_t frame[300], header[7];
  uint8_t function = message[0];
  transaction++;
  frame[0] = (uint8_t)(transaction >> 8);
  frame[1] = (uint8_t)transaction;
  frame[2] = frame[3] = 0;
  frame[4] = (uint8_t)((length + 1) >> 8);
  frame[5] = (uint8_t)(length + 1);
  frame[6] = 1;
  memcpy(frame + 7, message, length);
  if (send(server, frame, length + 7, 0) != (ssize_t)(length + 7)) stop("the request was not sent");
  receive(header, 7);
  if (header[0] != frame[0] || header[1] != frame[1]) stop("wrong transaction");
  length = (size_t)(header[4] * 256 + header[5]) - 1;
  receive(message, length);
  if (message[0] != function) {
    fprintf(stderr, "soft PLC: exception %d of function %d\n", message[1], function);
    exit(1);
  }
  return length;
}

static size_t begin(uint8_t *message, uint8_t function, int first, int count) {
  uint8_t head[] = {function, (uint8_t)(first >> 8), (uint8_t)first, (uint8_t)(count >> 8), (uint8_t)count};
  memcpy(message, head, 5);
  return 5;
}

static void read_inputs(struct image *image) {
  uint8_t message[300];
  if (N_DISCRETE > 0) {
    request(message, begin(message, 2, 0, N_DISCRETE));
    for (int k = 0; k < N_DISCRETE; k++) image->discrete[k] = message[2 + k / 8] >> k % 8 & 1;
  }
  request(message, begin(message, 4, 0, N_INPUT));
  for (int k = 0; k < N_INPUT; k++) image->input[k] = (uint16_t)(message[2 + 2 * k] * 256 + message[3 + 2 * k]);
}

static void write_outputs(const struct image *image) {
  uint8_t message[300];
  if (N_COIL > 0) {
    size_t n = begin(message, 15, 0, N_COIL);
    message[n++] = (N_COIL + 7) / 8;
    memset(message + n, 0, (N_COIL + 7) / 8);
    for (int k = 0; k < N_COIL; k++) message[n + (size_t)k / 8] |= (uint8_t)(image->coil[k] << k % 8);
    request(message, n + (N_COIL + 7) / 8);
  }
  if (N_HOLDING > 0) {
    size_t n = begin(message, 16, 0, N_HOLDING);
    message[n++] = 2 * N_HOLDING;
    for (int k = 0; k < N_HOLDING; k++) {
      message[n++] = (uint8_t)(image->holding[k] >> 8);
      message[n++] = (uint8_t)image->holding[k];
    }
    request(message, n);
  }
}

double get_float32(const uint16_t *words) {
  uint32_t bits = (uint32_t)words[0] << 16 | words[1];
  float value;
  memcpy(&value, &bits, sizeof value);
  return value;
}

double get_float64(const uint16_t *words) {
  uint64_t bits = 0;
  double value;
  for (int k = 0; k < 4; k++) bits = bits << 16 | words[k];
  memcpy(&value, &bits, sizeof value);
  return value;
}

void put_float32(uint16_t *words, double value) {
  float rounded = (float)value;
  uint32_t bits;
  memcpy(&bits, &rounded, sizeof bits);
  words[0] = (uint16_t)(bits >> 16);
  words[1] = (uint16_t)bits;
}

static double seconds(const struct timespec *t) { return (double)t->tv_sec + 1e-9 * (double)t->tv_nsec; }

int main(int count, char **arguments) {
  if (count != 5) stop("four arguments are required");
  double scan = atof(arguments[2]), end = atof(arguments[3]);
  FILE *log = fopen(arguments[4], "w");
  struct sockaddr_in address = {.sin_family = AF_INET, .sin_port = htons((uint16_t)atoi(arguments[1]))};
  struct timeval patience = {5, 0};
  int on = 1;
  inet_pton(AF_INET, "127.0.0.1", &address.sin_addr);
  server = socket(AF_INET, SOCK_STREAM, 0);
  setsockopt(server, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
  setsockopt(server, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
  if (log == NULL || connect(server, (struct sockaddr *)&address, sizeof address) != 0) stop("no connection");

  struct image image;
  memset(&image, 0, sizeof image);
  plc_init();
  fprintf(log, "begin,end,machine_time,lateness,outputs\n");
  struct timespec now, deadline;
  clock_gettime(CLOCK_MONOTONIC, &deadline);
  for (unsigned long tick = 0;; tick++) {
    clock_gettime(CLOCK_MONOTONIC, &now);
    double begin_time = seconds(&now), lateness = begin_time - seconds(&deadline);
    read_inputs(&image);
    double machine_time = get_float64(image.input);
    if (machine_time >= end) break;
    plc_scan(&image, tick);
    write_outputs(&image);
    clock_gettime(CLOCK_MONOTONIC, &now);
    fprintf(log, "%.6f,%.6f,%.6f,%.6f,", begin_time, seconds(&now), machine_time, lateness);
    for (int k = 0; k < N_COIL; k++) fputc(image.coil[k] ? '1' : '0', log);
    for (int k = 0; k + 1 < N_HOLDING; k += 2) fprintf(log, " %.7g", get_float32(image.holding + k));
    fputc('\n', log);
    deadline.tv_nsec += (long)(1e9 * scan + 0.5);
    for (; deadline.tv_nsec >= 1000000000L; deadline.tv_nsec -= 1000000000L) deadline.tv_sec++;
    clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &deadline, NULL);
  }
  fclose(log);
  close(server);
  return 0;
}
