// The example of docs/order-gates.md, from where the documentation keeps it.
#include "../../docs/examples/order_gates.cpp"
